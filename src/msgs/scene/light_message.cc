#include "msgs/scene/light_message.hh"

#include <ignition/msgs/light.pb.h>

#include "msgs/scene/color_message.hh"
#include "msgs/scene/pose_message.hh"
#include "pongsim/messages/fields.hh"

namespace pongsim::msgs {

namespace {

namespace im = ignition::msgs;

im::Light::LightType typeOf(description::LightType type) {
  switch (type) {
    case description::LightType::kPoint:
      return im::Light::POINT;
    case description::LightType::kSpot:
      return im::Light::SPOT;
    case description::LightType::kDirectional:
      break;
  }
  return im::Light::DIRECTIONAL;
}

description::LightType typeOf(im::Light::LightType type) {
  if (type == im::Light::SPOT) return description::LightType::kSpot;
  return type == im::Light::DIRECTIONAL ? description::LightType::kDirectional : description::LightType::kPoint;
}

constexpr const char* kIsOnKey = "isLightOn";

bool isOn(const im::Light& message) {
  for (const auto& entry : message.header().data()) {
    if (entry.key() == kIsOnKey && entry.value_size() > 0) return entry.value(0) != "0";
  }
  return true;
}

}  // namespace

void setLight(const description::Light& light, im::Light& message) {
  message.Clear();
  message.set_name(light.name);
  message.set_type(typeOf(light.type));
  setPose(light.X_ParentLight, *message.mutable_pose());
  setColor(light.diffuse, *message.mutable_diffuse());
  setColor(light.specular, *message.mutable_specular());
  message.set_attenuation_constant(static_cast<float>(light.constantAttenuation));
  message.set_attenuation_linear(static_cast<float>(light.linearAttenuation));
  message.set_attenuation_quadratic(static_cast<float>(light.quadraticAttenuation));
  setVector(light.direction, *message.mutable_direction());
  message.set_range(static_cast<float>(light.range));
  message.set_cast_shadows(light.castsShadows);
  message.set_spot_inner_angle(static_cast<float>(light.innerAngle));
  message.set_spot_outer_angle(static_cast<float>(light.outerAngle));
  message.set_spot_falloff(static_cast<float>(light.falloff));
  message.set_intensity(static_cast<float>(light.intensity));
  if (!light.isOn) setHeaderValue(kIsOnKey, "0", *message.mutable_header());
}

LightName lightName(const Message& light) {
  const auto& message = static_cast<const im::Light&>(light);
  return {message.id(), message.name(), message.parent_id()};
}

description::Light lightFrom(const im::Light& message) {
  description::Light none;
  none.name = message.name();
  description::Light light = changedLight(none, message);
  light.X_ParentLight = poseFrom(message.pose());
  return light;
}

description::Light changedLight(const description::Light& before, const Message& light) {
  const auto& message = static_cast<const im::Light&>(light);
  description::Light changed = before;
  changed.type = typeOf(message.type());
  if (message.pose().has_position()) changed.X_ParentLight.position = vectorFrom(message.pose().position());
  if (message.has_diffuse()) changed.diffuse = colorOf(message.diffuse());
  if (message.has_specular()) changed.specular = colorOf(message.specular());
  changed.constantAttenuation = message.attenuation_constant();
  changed.linearAttenuation = message.attenuation_linear();
  changed.quadraticAttenuation = message.attenuation_quadratic();
  if (message.has_direction()) changed.direction = vectorFrom(message.direction());
  changed.range = message.range();
  changed.castsShadows = message.cast_shadows();
  changed.innerAngle = message.spot_inner_angle();
  changed.outerAngle = message.spot_outer_angle();
  changed.falloff = message.spot_falloff();
  changed.intensity = message.intensity();
  changed.isOn = isOn(message);
  return changed;
}

}  // namespace pongsim::msgs
