#include "pongsim/parameters.hh"

#include <algorithm>
#include <cmath>
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
    refuse(element, subject + " is not a joint of model '" + std::string(model.name()) + "'",
           names.empty() ? "the model has no joints" : "its joints are " + names);
  }
  if (joint->axisCount() == 0) refuse(element, subject + " is a joint without an axis to drive");
  return *joint;
}

double finiteIn(const Element& element, std::string_view name) {
  const double value = element.get(name, 0.0);
  if (!std::isfinite(value)) refuse(*element.child(name), "<" + std::string(name) + "> must be a finite number");
  return value;
}

double notNegativeIn(const Element& element, std::string_view name) {
  const double value = finiteIn(element, name);
  if (value < 0) refuse(*element.child(name), "<" + std::string(name) + "> must be zero or more");
  return value;
}

NoiseSettings::Type noiseTypeOf(const Element& noise) {
  using Type = NoiseSettings::Type;
  // in SDF 1.6 and older the type is an element
  const std::string type = noise.attributeOr("type", noise.get<std::string>("type", "none"));
  if (type == "none") return Type::kNone;
  if (type == "gaussian") return Type::kGaussian;
  if (type == "gaussian_quantized") return Type::kGaussianQuantized;
  refuse(noise, "<noise> has the unknown type '" + type + "'", "it can be none, gaussian or gaussian_quantized");
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

Link requiredLink(const Element& sdf, std::string_view name, const Model& model) {
  requiredText(sdf, name);
  const Element& element = *sdf.child(name);
  const std::optional<Link> link = model.link(element.text);
  if (link) return *link;
  std::string names;
  for (const Link& other : model.links()) names += (names.empty() ? "" : ", ") + std::string(other.name());
  refuse(element,
         "<" + element.name + "> '" + element.text + "' is not a link of model '" + std::string(model.name()) + "'",
         names.empty() ? "the model has no links" : "its links are " + names);
}

NoiseSettings noiseIn(const Element& holder) {
  NoiseSettings settings;
  const Element* noise = holder.child("noise");
  if (noise == nullptr) return settings;
  settings.type = noiseTypeOf(*noise);
  settings.mean = finiteIn(*noise, "mean");
  settings.standardDeviation = notNegativeIn(*noise, "stddev");
  settings.biasMean = finiteIn(*noise, "bias_mean");
  settings.biasStandardDeviation = notNegativeIn(*noise, "bias_stddev");
  settings.dynamicBiasStandardDeviation = notNegativeIn(*noise, "dynamic_bias_stddev");
  settings.dynamicBiasCorrelationTime = notNegativeIn(*noise, "dynamic_bias_correlation_time");
  settings.precision = notNegativeIn(*noise, "precision");
  return settings;
}

Time periodOf(double rate) { return rate > 0 ? fromSeconds(std::min(1 / rate, 1e9)) : Time::zero(); }

std::string topicOr(std::string_view named, std::string_view fallback) {
  return cleanTopic(named.empty() ? fallback : named);
}

}  // namespace pongsim
