#include "sim/system_set.hh"

#include <algorithm>
#include <exception>
#include <utility>

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
    : access_(access),
      transport_(transport),
      seed_(seed),
      world_(access),
      defaultSceneBroadcaster_(defaultSceneBroadcaster()) {}

SystemSet::~SystemSet() = default;

void SystemSet::load(const description::World& world, Diagnostics& diagnostics) {
  loadWorldPlugins(world, diagnostics);
  for (world::Slot model : access_.entities.topLevelModels()) loadModelPlugins(model, diagnostics);
}

void SystemSet::loadWorldPlugins(const description::World& world, Diagnostics& diagnostics) {
  if (world.plugins.empty()) {
    add(defaultSceneBroadcaster_, 0, std::nullopt, diagnostics);
    return;
  }
  wantsPhysics_ = false;
  for (std::size_t i = 0; i < world.plugins.size(); ++i) {
    const description::Plugin& plugin = world.plugins[i];
    const std::string name = plugin::systemName(plugin.filename);
    if (name == kPhysics) {
      wantsPhysics_ = true;
    } else if (name == kUserCommands) {
      Logger("plugins").info("user-commands is accepted; its services are not there yet");
    } else {
      add(plugin, i, std::nullopt, diagnostics);
    }
  }
  if (!wantsPhysics_) {
    diagnostics.warning(world.position, "world '" + world.name + "' lists systems, but not physics: nothing will move",
                        "add <plugin filename=\"ignition-gazebo-physics-system\" "
                        "name=\"ignition::gazebo::systems::Physics\"/>");
  }
}

void SystemSet::loadModelPlugins(world::Slot model, Diagnostics& diagnostics) {
  loadOwnPlugins(model, diagnostics);
  for (world::Slot nested : access_.entities.models()[model].models) loadModelPlugins(nested, diagnostics);
}

void SystemSet::loadOwnPlugins(world::Slot model, Diagnostics& diagnostics) {
  const std::vector<description::Plugin>& plugins = access_.entities.models()[model].description->plugins;
  for (std::size_t i = 0; i < plugins.size(); ++i) add(plugins[i], i, model, diagnostics);
}

void SystemSet::add(const description::Plugin& plugin, std::size_t number, std::optional<world::Slot> model,
                    Diagnostics& diagnostics) {
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
  const std::string stream = speaker + "#" + std::to_string(number);
  Slot& slot = slots_.emplace_back(Slot{handle ? handle->id() : ModelId(), number, stream, Logger(speaker),
                                        Random(seed_, stream), transport_.node(), std::move(system)});
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

void SystemSet::load(world::Slot model, Diagnostics& diagnostics) { loadModelPlugins(model, diagnostics); }

void SystemSet::unload(const std::vector<ModelId>& models) {
  slots_.remove_if([&](const Slot& slot) { return std::ranges::find(models, slot.model) != models.end(); });
  unloaded_.insert(unloaded_.end(), models.begin(), models.end());
}

void SystemSet::announceChanges() {
  if (!access_.hasChanged) return;
  access_.hasChanged = false;
  forEach([](System& system) { system.worldChanged(); });
}

void SystemSet::reset(Diagnostics& diagnostics) {
  slots_.remove_if([&](const Slot& slot) { return slot.model && access_.entities.slot(slot.model) == world::kNoSlot; });
  for (const ModelId model : std::exchange(unloaded_, {})) {
    const world::Slot slot = access_.entities.slot(model);
    if (slot != world::kNoSlot) loadOwnPlugins(slot, diagnostics);
  }
  putInOrder();
  for (Slot& slot : slots_) {
    slot.rests = false;
    slot.random = Random(seed_, slot.stream);
  }
  announceChanges();
  forEach([](System& system) { system.reset(); });
}

void SystemSet::transfer(StateArchive& archive) {
  for (Slot& slot : slots_) {
    slot.random.transfer(archive);
    archive(slot.rests);
    slot.system->transfer(archive);
  }
}

void SystemSet::addTo(base::Hash& hash) const {
  for (const Slot& slot : slots_) hash.add(slot.stream);
}

/// As they were loaded at the start: the world's, then each model's.
void SystemSet::putInOrder() {
  const auto place = [this](const Slot& slot) {
    return std::pair(slot.model ? access_.entities.slot(slot.model) + 1 : 0, slot.number);
  };
  slots_.sort([&](const Slot& a, const Slot& b) { return place(a) < place(b); });
}

void SystemSet::rest(Slot& slot, const std::exception& reason) {
  slot.log.warning(std::string("rests until the next reset: ") + reason.what());
  slot.rests = true;
}

/// Calls it for each system that does not rest.
template <class Call>
void SystemSet::forEach(Call call) {
  for (Slot& slot : slots_) {
    if (slot.rests) continue;
    try {
      call(*slot.system);
    } catch (const Gone& error) {
      rest(slot, error);
    } catch (const Error& error) {
      rest(slot, error);
    }
  }
}

void SystemSet::preUpdate(const StepInfo& info) {
  announceChanges();
  forEach([&](System& system) { system.preUpdate(info); });
}

void SystemSet::update(const StepInfo& info) {
  forEach([&](System& system) { system.update(info); });
}

void SystemSet::postUpdate(const StepInfo& info) {
  forEach([&](System& system) { system.postUpdate(info); });
}

}  // namespace pongsim::sim
