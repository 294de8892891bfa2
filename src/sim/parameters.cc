#include "pongsim/parameters.hh"

#include <algorithm>
#include <optional>
#include <utility>

#include "pongsim/node.hh"

namespace pongsim {

namespace {

Joint jointOf(const Element& element, const Model& model) {
  const std::optional<Joint> joint = model.joint(element.text);
  const std::string subject = "<" + element.name + "> '" + element.text + "'";
  if (!joint) {
    std::string names;
    for (const Joint& other : model.joints()) names += (names.empty() ? "" : ", ") + std::string(other.name());
    refuse(element, subject + " is no joint of model '" + std::string(model.name()) + "'",
           names.empty() ? "the model has no joints" : "its joints are " + names);
  }
  if (joint->axisCount() == 0) refuse(element, subject + " is a joint without an axis that could be driven");
  return *joint;
}

}  // namespace

void refuse(const Element& where, std::string message, std::string hint) {
  throw Error({Severity::kError, where.position, std::move(message), std::move(hint)});
}

std::string requiredText(const Element& sdf, std::string_view name) {
  const Element* element = sdf.child(name);
  if (element == nullptr || element->text.empty()) {
    refuse(element != nullptr ? *element : sdf, "no <" + std::string(name) + "> is given");
  }
  return element->text;
}

Joint requiredJoint(const Element& sdf, std::string_view name, const Model& model) {
  const Element* element = sdf.child(name);
  if (element == nullptr) refuse(sdf, "no <" + std::string(name) + "> is given");
  return jointOf(*element, model);
}

std::vector<Joint> requiredJoints(const Element& sdf, std::string_view name, const Model& model) {
  std::vector<Joint> joints;
  for (const Element* element : sdf.childrenNamed(name)) joints.push_back(jointOf(*element, model));
  if (joints.empty()) refuse(sdf, "no <" + std::string(name) + "> is given");
  return joints;
}

Time periodOf(double rate) { return rate > 0 ? fromSeconds(std::min(1 / rate, 1e9)) : Time::zero(); }

std::string topicOr(std::string_view named, std::string_view fallback) {
  return cleanTopic(named.empty() ? fallback : named);
}

}  // namespace pongsim
