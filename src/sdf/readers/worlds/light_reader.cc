#include "sdf/readers/worlds/light_reader.hh"

#include <array>
#include <cmath>
#include <optional>
#include <string_view>
#include <utility>

#include "sdf/text/names.hh"

namespace pongsim::sdf {

namespace {

using description::LightType;

void readDirection(const Element& element, description::Light& light, Context& context) {
  const Vector3 direction = readVector(element, "direction", light.direction, context);
  const double length = direction.stableNorm();
  if (length > 0 && std::isfinite(length)) {
    light.direction = (direction / length).normalized();
  } else {
    context.diagnostics.warning(element.child("direction")->position,
                                "<direction> of light '" + light.name + "' has length zero: 0 0 -1 is used");
  }
}

void readAttenuation(const Element& element, description::Light& light, Context& context) {
  light.range = readLimit(element, "range", light.range, context);
  light.constantAttenuation = readNumber(element, "constant", light.constantAttenuation, context);
  light.linearAttenuation = readNumber(element, "linear", light.linearAttenuation, context);
  light.quadraticAttenuation = readNumber(element, "quadratic", light.quadraticAttenuation, context);
}

void readSpot(const Element& element, description::Light& light, Context& context) {
  light.innerAngle = readNumber(element, "inner_angle", light.innerAngle, context);
  light.outerAngle = readNumber(element, "outer_angle", light.outerAngle, context);
  light.falloff = readNumber(element, "falloff", light.falloff, context);
}

}  // namespace

LightDraft readLight(const Element& element, const std::string& owner, Context& context) {
  constexpr std::array<std::string_view, 3> kLightTypes{"point", "directional", "spot"};
  constexpr std::array kTypeOfWord{LightType::kPoint, LightType::kDirectional, LightType::kSpot};
  LightDraft draft;
  description::Light& light = draft.light;
  light.name = readName(element, owner, context);
  light.type = kTypeOfWord[readWordAttribute(element, "type", 0, kLightTypes, context)];
  light.position = element.position;
  draft.pose = readPose(element, context);
  light.isOn = readFlag(element, "light_on", light.isOn, context);
  light.castsShadows = readFlag(element, "cast_shadows", light.castsShadows, context);
  light.isVisualized = readFlag(element, "visualize", light.isVisualized, context);
  light.intensity = readNumber(element, "intensity", light.intensity, context);
  light.diffuse = readColor(element, "diffuse", light.diffuse, context);
  light.specular = readColor(element, "specular", light.specular, context);
  readDirection(element, light, context);
  if (const Element* attenuation = element.child("attenuation")) readAttenuation(*attenuation, light, context);
  if (const Element* spot = element.child("spot")) readSpot(*spot, light, context);
  return draft;
}

description::Light finishLight(LightDraft&& draft, const Scope& scope, const Pose& X_ScopeParent, Context& context) {
  description::Light light = std::move(draft.light);
  light.X_ParentLight = draft.pose.value;
  if (!draft.pose.relativeTo.empty()) {
    const std::optional<Scope::ResolvedFrame> frame = scope.findOrComplain(
        draft.pose.relativeTo, "the pose of light '" + light.name + "' is relative to", draft.pose.position, context);
    if (frame) light.X_ParentLight = X_ScopeParent.inverse() * frame->X_ScopeFrame * draft.pose.value;
  }
  return light;
}

}  // namespace pongsim::sdf
