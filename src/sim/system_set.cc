#include "sim/system_set.hh"

#include <exception>

#include "plugin/system_name.hh"

namespace pongsim::sim {

namespace {

constexpr std::string_view kPhysics = "physics";
constexpr std::string_view kUserCommands = "user-commands";

/// Fortress's servers add this where a world lists no system of its own.
description::Plugin defaultSceneBroadcaster() {
  description::Plugin plugin;
  plugin.filename = "ignition-gazebo-scene-broadcaster-system";
  plugin.className = "ignition::gazebo::systems::SceneBroadcaster";
  plugin.sdf.name = "plugin";
  return plugin;
}

}  // namespace

SystemSet::SystemSet(Access& access, Transport& transport, std::uint64_t seed)
    : access_(access), transport_(transport), seed_(seed), world_(access) {}

SystemSet::~SystemSet() = default;

void SystemSet::load(const description::World& world, Diagnostics& diagnostics) {
  loadWorldPlugins(world, diagnostics);
  for (world::Slot model : access_.entities.topLevelModels()) loadModelPlugins(model, diagnostics);
}

void SystemSet::loadWorldPlugins(const description::World& world, Diagnostics& diagnostics) {
  if (world.plugins.empty()) {
    add(defaultSceneBroadcaster(), std::nullopt, diagnostics);
    return;
  }
  wantsPhysics_ = false;
  for (const description::Plugin& plugin : world.plugins) {
    const std::string name = plugin::systemName(plugin.filename);
    if (name == kPhysics) {
      wantsPhysics_ = true;
    } else if (name == kUserCommands) {
      Logger("plugins").info("user-commands is accepted; its services are not there yet");
    } else {
      add(plugin, std::nullopt, diagnostics);
    }
  }
  if (!wantsPhysics_) {
    diagnostics.warning(world.position, "world '" + world.name + "' lists systems, but not physics: nothing will move",
                        "add <plugin filename=\"ignition-gazebo-physics-system\" "
                        "name=\"ignition::gazebo::systems::Physics\"/>");
  }
}

void SystemSet::loadModelPlugins(world::Slot model, Diagnostics& diagnostics) {
  const world::ModelRecord& record = access_.entities.models()[model];
  for (const description::Plugin& plugin : record.description->plugins) add(plugin, model, diagnostics);
  for (world::Slot nested : record.models) loadModelPlugins(nested, diagnostics);
}

void SystemSet::add(const description::Plugin& plugin, std::optional<world::Slot> model, Diagnostics& diagnostics) {
  std::unique_ptr<System> system = loader_.load(plugin, diagnostics);
  if (system == nullptr) return;

  std::string speaker = plugin::systemName(plugin.filename);
  std::optional<Model> handle;
  if (model) {
    const world::ModelRecord& record = access_.entities.models()[*model];
    handle = Model(access_, record.id);
    speaker += " of " + record.scopedName;
  }
  // The number keeps apart two systems of a kind in one place.
  const std::string stream = speaker + "#" + std::to_string(slots_.size());
  Slot& slot = slots_.emplace_back(Slot{Logger(speaker), Random(seed_, stream), transport_.node(), std::move(system)});
  try {
    slot.system->configure({plugin.sdf, world_, handle, slot.node, slot.log, slot.random});
    return;
  } catch (const Error& error) {
    const Diagnostic& found = error.diagnostic();
    diagnostics.warning(found.position, speaker + " is left out: " + found.message, found.hint);
  } catch (const std::exception& error) {
    diagnostics.warning(plugin.sdf.position, speaker + " is left out: " + error.what());
  }
  slots_.pop_back();
}

void SystemSet::preUpdate(const StepInfo& info) {
  for (Slot& slot : slots_) slot.system->preUpdate(info);
}

void SystemSet::update(const StepInfo& info) {
  for (Slot& slot : slots_) slot.system->update(info);
}

void SystemSet::postUpdate(const StepInfo& info) {
  for (Slot& slot : slots_) slot.system->postUpdate(info);
}

}  // namespace pongsim::sim
