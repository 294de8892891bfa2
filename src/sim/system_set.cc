#include "sim/system_set.hh"

#include <algorithm>
#include <memory>
#include <span>
#include <stdexcept>
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

SystemSet::SystemSet(Access& access, Transport& transport, std::uint64_t seed, bool strict)
    : access_(access),
      transport_(transport),
      seed_(seed),
      strict_(strict),
      world_(access),
      defaultSceneBroadcaster_(defaultSceneBroadcaster()) {}

SystemSet::~SystemSet() = default;

void SystemSet::load(const description::World& world, Diagnostics& diagnostics) {
  loadWorldPlugins(world, diagnostics);
  for (world::Slot model : access_.entities.topLevelModels()) loadModelPlugins(model, diagnostics);
  collectAwake();
}

void SystemSet::loadWorldPlugins(const description::World& world, Diagnostics& diagnostics) {
  const auto isSystem = [](const description::Plugin& plugin) { return !description::isLevelPlan(plugin.className); };
  if (std::ranges::none_of(world.plugins, isSystem)) {
    add(defaultSceneBroadcaster_, 0, std::nullopt, diagnostics);
    return;
  }
  wantsPhysics_ = false;
  for (std::size_t i = 0; i < world.plugins.size(); ++i) {
    const description::Plugin& plugin = world.plugins[i];
    if (!isSystem(plugin)) continue;
    const std::string name = plugin::systemName(plugin.filename);
    if (name == kPhysics) {
      wantsPhysics_ = true;
    } else if (name == kUserCommands) {
      Logger("plugins").info("user-commands is part of pongsim: each world has its services");
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
  std::unique_ptr<System> system;
  {
    const base::RunningPart running(plugin.filename.c_str(), "while it was loaded");
    system = loader_.load(plugin, diagnostics);
  }
  if (system == nullptr) return;

  std::string name = plugin::systemName(plugin.filename);
  std::optional<Model> handle;
  if (model) {
    const world::ModelRecord& record = access_.entities.models()[*model];
    handle = Model(access_, record.id);
    name += " of " + record.scopedName;
  }
  std::vector<System*> before;
  for (SystemSlot& slot : slots_) before.push_back(&slot.system());
  SystemSlot& slot = slots_.emplace_back(
      SystemSlot::Parts{handle ? handle->id() : ModelId(), number, name, plugin.sdf.position, transport_.node(),
                        Random(seed_, SystemSlot::streamOf(name, number)), std::move(system)},
      access_, [this](const SystemSlot& each, const std::string& what) { noteFailure(each, what); });
  if (slot.start(plugin.sdf, world_, handle, before, diagnostics)) {
    warnOfSharedTopics(slot, diagnostics);
  } else {
    slots_.pop_back();
  }
}

void SystemSet::warnOfSharedTopics(const SystemSlot& slot, Diagnostics& diagnostics) const {
  if (slot.declaration().topicsAreShared()) return;
  for (const SystemSlot& other : slots_) {
    // of one kind: what others say on a topic is theirs to know
    if (&other == &slot || other.declaration().text() != slot.declaration().text()) continue;
    const auto shared = std::ranges::find_first_of(slot.topics(), other.topics());
    if (shared == slot.topics().end()) continue;
    diagnostics.warning(slot.position(),
                        slot.name() + " publishes on '" + *shared + "', and so does " + other.name() + " of line " +
                            std::to_string(other.position().line),
                        "who listens gets the messages of both");
  }
}

void SystemSet::noteFailure(const SystemSlot& slot, const std::string& what) {
  if (!strict_) {
    Logger(slot.name()).error(what + "; it is switched off");
  } else if (!failure_) {
    failure_ = slot.name() + " " + what;
  }
}

void SystemSet::check() const {
  if (failure_) throw std::runtime_error(*failure_);
}

void SystemSet::load(world::Slot model, Diagnostics& diagnostics) {
  loadModelPlugins(model, diagnostics);
  collectAwake();
}

void SystemSet::unload(const std::vector<ModelId>& models) {
  slots_.remove_if([&](const SystemSlot& slot) { return std::ranges::find(models, slot.model()) != models.end(); });
  unloaded_.insert(unloaded_.end(), models.begin(), models.end());
  collectAwake();
}

void SystemSet::updateWhoRests() {
  for (SystemSlot& slot : slots_) slot.setResting(access_.shelvedIds.contains(slot.model().value));
  collectAwake();
}

void SystemSet::collectAwake() {
  awake_.clear();
  for (SystemSlot& slot : slots_) {
    if (!slot.isResting()) awake_.push_back(&slot);
  }
}

void SystemSet::announceChanges() {
  if (!access_.hasChanged) return;
  access_.hasChanged = false;
  for (SystemSlot& slot : slots_) slot.worldChanged();
}

void SystemSet::reset(Diagnostics& diagnostics, std::optional<std::uint64_t> seed) {
  seed_ = seed.value_or(seed_);
  slots_.remove_if(
      [&](const SystemSlot& slot) { return slot.model() && access_.entities.slot(slot.model()) == world::kNoSlot; });
  for (const ModelId model : std::exchange(unloaded_, {})) {
    const world::Slot slot = access_.entities.slot(model);
    if (slot != world::kNoSlot) loadOwnPlugins(slot, diagnostics);
  }
  putInOrder();
  updateWhoRests();
  for (SystemSlot& slot : slots_) slot.switchOn(Random(seed_, slot.stream()));
  announceChanges();
  for (SystemSlot& slot : slots_) {
    // once more: who is told of changes may draw numbers
    slot.setRandom(Random(seed_, slot.stream()));
    slot.reset();
  }
}

std::vector<std::string> SystemSet::save() {
  std::vector<std::string> saved;
  for (SystemSlot& slot : slots_) {
    StateArchive archive;
    slot.transfer(archive);
    const std::vector<std::byte> bytes = archive.take();
    saved.emplace_back(reinterpret_cast<const char*>(bytes.data()), bytes.size());
  }
  return saved;
}

void SystemSet::restore(const std::vector<std::string>& saved, bool awakeOnly) {
  auto next = saved.begin();
  for (SystemSlot& slot : slots_) {
    StateArchive archive(std::as_bytes(std::span(next->data(), next->size())));
    ++next;
    if (!awakeOnly || !slot.isResting()) slot.transfer(archive);
  }
}

void SystemSet::addTo(base::Hash& hash) const {
  for (const SystemSlot& slot : slots_) hash.add(slot.stream());
}

/// As they were loaded at the start: the world's, then each model's.
void SystemSet::putInOrder() {
  const auto place = [this](const SystemSlot& slot) {
    return std::pair(slot.model() ? access_.entities.slot(slot.model()) + 1 : 0, slot.number());
  };
  slots_.sort([&](const SystemSlot& a, const SystemSlot& b) { return place(a) < place(b); });
}

void SystemSet::preUpdate(const StepInfo& info) {
  // of a message that was handed over before
  check();
  announceChanges();
  for (std::size_t i = 0; i < awake_.size(); ++i) awake_[i]->preUpdate(info);
  check();
}

void SystemSet::update(const StepInfo& info) {
  for (std::size_t i = 0; i < awake_.size(); ++i) awake_[i]->update(info);
  check();
}

void SystemSet::postUpdate(const StepInfo& info) {
  for (std::size_t i = 0; i < awake_.size(); ++i) awake_[i]->postUpdate(info);
  check();
}

}  // namespace pongsim::sim
