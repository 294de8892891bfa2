#include "pongsim/parameters.hh"

#include <algorithm>
#include <utility>

namespace pongsim {

void refuse(const Element& where, std::string message, std::string hint) {
  throw Error({Severity::kError, where.position, std::move(message), std::move(hint)});
}

Model requiredModel(const SystemContext& context, std::string_view system) {
  if (!context.model) refuse(context.sdf, std::string(system) + " must stand in a <model>");
  return *context.model;
}

std::string requiredText(const Element& sdf, std::string_view name) {
  const Element* element = sdf.child(name);
  if (element == nullptr || element->text.empty()) {
    refuse(element != nullptr ? *element : sdf, "no <" + std::string(name) + "> is given");
  }
  return element->text;
}

Joint requiredJoint(const Element& sdf, std::string_view name, const Model& model) {
  const std::string jointName = requiredText(sdf, name);
  const std::optional<Joint> joint = model.joint(jointName);
  const std::string subject = "<" + std::string(name) + "> '" + jointName + "'";
  if (!joint) {
    std::string names;
    for (const Joint& other : model.joints()) names += (names.empty() ? "" : ", ") + std::string(other.name());
    refuse(*sdf.child(name), subject + " is no joint of model '" + std::string(model.name()) + "'",
           names.empty() ? "the model has no joints" : "its joints are " + names);
  }
  if (joint->axisCount() == 0) refuse(*sdf.child(name), subject + " is a joint without an axis that could be driven");
  return *joint;
}

Time periodParameter(const Element& sdf, std::string_view name, double fallback) {
  const double rate = sdf.get(name, fallback);
  return rate > 0 ? fromSeconds(std::min(1 / rate, 1e9)) : Time::zero();
}

std::string topicParameter(const Element& sdf, std::string_view name, std::string_view fallback) {
  return cleanTopic(sdf.get<std::string>(name, std::string(fallback)));
}

}  // namespace pongsim
