#include "sim/edits/light_edits.hh"

#include <cmath>
#include <memory>
#include <string_view>
#include <utility>
#include <vector>

#include "base/nearest_word.hh"
#include "msgs/scene/light_message.hh"
#include "sim/edits/editor.hh"

namespace pongsim::sim {

namespace {

/// @return The slot of the light.
Outcome<world::Slot> findLight(const Access& access, const msgs::LightName& asked) {
  const world::Entities& entities = access.entities;
  world::Slot holder = world::kNoSlot;
  if (asked.id != 0) {
    const world::Slot slot = entities.slot(LightId{asked.id});
    if (slot != world::kNoSlot) return {slot, {}};
    return {std::nullopt, "there is no light with the id " + std::to_string(asked.id)};
  }
  if (asked.name.empty()) return {std::nullopt, "give a name or an id"};
  if (asked.parent != 0 && asked.parent != entities.worldId().value) {
    holder = entities.slot(LinkId{asked.parent});
    if (holder == world::kNoSlot) {
      return {std::nullopt, "there is no link with the id " + std::to_string(asked.parent) + " to hold a light"};
    }
  }
  const world::Slot slot = entities.findLight(holder, asked.name);
  if (slot != world::kNoSlot) return {slot, {}};
  std::vector<std::string_view> names;
  for (const world::LightRecord& light : world::present(entities.lights())) {
    if (light.link == holder) names.push_back(light.description->name);
  }
  const std::string nearest = base::didYouMean(asked.name, names);
  return {std::nullopt, "there is no light '" + asked.name + "'" + (nearest.empty() ? "" : "; " + nearest)};
}

/// Normalizes the light's direction.
/// @return Why the light is invalid, or success.
Outcome<void> checkLight(description::Light& light) {
  const double length = light.direction.norm();
  if (!std::isfinite(length) || length < 1e-9) return {"the light's direction is not finite, or zero"};
  light.direction /= length;
  if (!light.X_ParentLight.position.allFinite()) return {"the light's pose is not finite"};
  for (const double value :
       {light.range, light.constantAttenuation, light.linearAttenuation, light.quadraticAttenuation, light.innerAngle,
        light.outerAngle, light.falloff, light.intensity}) {
    if (!std::isfinite(value) || value < 0) return {"the light's values must be finite and zero or more"};
  }
  return {};
}

}  // namespace

Outcome<std::string> insertLight(Access& access, description::Light light, const InsertOptions& options) {
  if (!options.name.empty()) light.name = options.name;
  if (light.name.empty()) return {std::nullopt, "the light has no name"};
  if (light.name.find("::") != std::string::npos) {
    return {std::nullopt, "the name '" + light.name + "' contains '::', which separates names"};
  }
  const Editor editor(access);
  if (options.allowRenaming) light.name = editor.freeName(light.name);
  if (!editor.isFree(light.name)) return {std::nullopt, "there is a '" + light.name + "' in the world already"};
  if (options.pose) light.X_ParentLight = *options.pose;
  if (const char* fault = poseFault(light.X_ParentLight))
    return {std::nullopt, std::string("the light's pose ") + fault};
  light.X_ParentLight.rotation.normalize();
  if (const Outcome<void> checked = checkLight(light); !checked) return {std::nullopt, checked.error};
  Outcome<std::string> name{light.name, {}};
  access.entities.insertLight(std::make_shared<description::Light>(std::move(light)));
  access.noteChange();
  return name;
}

Outcome<std::string> insertLight(Access& access, const Message& light, const InsertOptions& options) {
  description::Light blank;
  blank.name = msgs::lightName(light).name;
  return insertLight(access, msgs::changedLight(blank, light), options);
}

Outcome<void> changeLight(Access& access, const Message& light) {
  Outcome<world::Slot> slot = findLight(access, msgs::lightName(light));
  if (!slot) return {slot.error};
  auto changed =
      std::make_shared<description::Light>(msgs::changedLight(*access.entities.lights()[*slot].description, light));
  if (Outcome<void> checked = checkLight(*changed); !checked) return checked;
  access.entities.changeLight(*slot, std::move(changed));
  access.noteChange();
  return {};
}

Outcome<void> removeLight(Access& access, std::uint64_t id, const std::string& name) {
  Outcome<world::Slot> slot = findLight(access, {.id = id, .name = name, .parent = 0});
  if (!slot) return {slot.error};
  if (access.entities.lights()[*slot].link != world::kNoSlot) {
    return {"the light with the id " + std::to_string(id) + " is part of a link and can't be removed alone"};
  }
  access.entities.removeLight(*slot);
  access.noteChange();
  return {};
}

}  // namespace pongsim::sim
