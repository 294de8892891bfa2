#include "sim/system_set.hh"

#include <algorithm>
#include <iterator>
#include <memory>
#include <span>
#include <stdexcept>
#include <string_view>
#include <system_error>
#include <tuple>
#include <utility>

#include "base/is_below.hh"
#include "base/prefetch.hh"
#include "plugin/core_systems.hh"
#include "plugin/sensor_plugins.hh"
#include "plugin/system_name.hh"
#include "sim/plugin_elements.hh"

namespace pongsim::sim {

namespace {

constexpr auto kRequired = plugin::Loader::Need::kRequired;
constexpr std::string_view kPhysics = "physics";
constexpr std::string_view kUserCommands = "user-commands";
/// Lowest `number` of world systems that come from `<plugin>`s of models and actors; those of the world itself are
/// below.
constexpr std::size_t kFirstFromModels = 1'000'000;

/// @return " (world.sdf:41:9)"; empty if it is not from a file.
std::string inBrackets(const SourcePosition& position) {
  if (!position.file || position.line <= 0) return {};
  return " (" + *position.file + ":" + std::to_string(position.line) + ":" + std::to_string(position.column) + ")";
}

bool environmentAllowsPaths() {
  const char* value = std::getenv("PONGSIM_ALLOW_PLUGIN_PATHS");
  return value != nullptr && std::string_view(value) == "1";
}

/// Takes the place of a system that stands outside, and does nothing.
class StandIn final : public System {
 public:
  void declare(Declaration& declaration) override {
    declaration.is("Stands for a system that connects the world with the outside.", Declaration::Place::kAnywhere);
    declaration.standsOutside();
  }
  void configure(const SystemContext&) override {}
};

/// @return Whether it is a system of the world that simulates sensors. Its `<plugin>` may be in a robot, because a URDF
/// has no world.
bool isOfSensors(const Declaration& declaration) {
  return declaration.place() == Declaration::Place::kWorld && !declaration.readings().empty();
}

/// @return The index of the first sensor of `model`, which is the last one of the world.
std::size_t firstSensor(const world::Entities& entities, world::Slot model) {
  const std::uint64_t id = entities.models()[model].id.value;
  const std::vector<world::SensorRecord>& all = entities.sensors();
  return static_cast<std::size_t>(
      std::ranges::lower_bound(all, id, {}, [](const world::SensorRecord& each) { return each.id.value; }) -
      all.begin());
}

/// @param name The system's name in messages.
/// @return What the system declares; nothing, with a warning, if it throws.
std::optional<Declaration> declared(System& system, const std::string& name, const SourcePosition& position,
                                    Diagnostics& diagnostics) {
  std::optional<Declaration> declaration(std::in_place);
  try {
    system.declare(*declaration);
  } catch (const std::exception& error) {
    diagnostics.warning(position, name + " is left out: " + error.what());
    declaration.reset();
  }
  return declaration;
}

}  // namespace

SystemSet::SystemSet(Access& access, ModelEdits& edits, Transport& transport, std::uint64_t seed, bool strict,
                     const WorldPlace& place)
    : access_(access),
      transport_(transport),
      seed_(seed),
      strict_(strict),
      place_(place),
      world_(access),
      defaultSceneBroadcaster_(defaultSceneBroadcaster()),
      queue_(edits) {}

SystemSet::~SystemSet() = default;

void SystemSet::load(const description::World& world, bool isConfigured, const SimulationOptions& options,
                     Diagnostics& diagnostics) {
  loadsPlugins_ = true;
  loadsOutsiders_ = options.outsideSystems;
  if (options.allowPluginPaths || environmentAllowsPaths()) paths_ = plugin::Loader::Paths::kAllowed;
  const std::vector<world::ModelRecord>& models = access_.entities.models();
  if (!models.empty()) lastOfFile_ = models.back().id;
  unloaded_.reserve(models.size());
  loadWorldPlugins(world, isConfigured, options, diagnostics);
  for (world::Slot model : access_.entities.topLevelModels()) loadModelPlugins(model, {paths_}, diagnostics);
  for (const world::ActorRecord& actor : access_.entities.actors()) {
    const std::vector<description::Plugin>& plugins = actor.description->plugins;
    for (std::size_t i = 0; i < plugins.size(); ++i) add(plugins[i], i, {.actor = &actor}, {paths_}, diagnostics);
  }
  warnOfMissing(0, diagnostics);
  collect();
}

void SystemSet::loadWorldPlugins(const description::World& world, bool isConfigured, const SimulationOptions& options,
                                 Diagnostics& diagnostics) {
  std::vector<description::Plugin> more = pluginsOf(options.systems);
  const auto isSystem = [](const description::Plugin& plugin) { return !description::isLevelPlan(plugin.className); };
  if (!isConfigured && std::ranges::none_of(world.plugins, isSystem)) {
    add(defaultSceneBroadcaster_, 0, {}, {paths_, false, kRequired}, diagnostics);
    for (std::size_t i = 0; i < more.size(); ++i) add(more[i], 1 + i, {}, {paths_, false, kRequired}, diagnostics);
    return;
  }
  wantsPhysics_ = false;
  for (std::size_t i = 0; i < world.plugins.size(); ++i) {
    if (!isSystem(world.plugins[i])) continue;
    const std::size_t wanted = more.size();
    const description::Plugin plugin = joined(world.plugins[i], more);
    const auto need = more.size() < wanted ? kRequired : plugin::Loader::Need::kOptional;
    const std::string name = plugin::systemName(plugin.filename);
    if (name == kPhysics) {
      wantsPhysics_ = true;
    } else if (name == kUserCommands) {
      Logger("plugins").info("user-commands is part of pongsim: every world has its services");
    } else {
      add(plugin, i, {}, {paths_, false, need}, diagnostics);
    }
  }
  if (!wantsPhysics_ && options.physics) {
    const std::string who = isConfigured ? "the server config file has no physics for world '" + world.name + "'"
                                         : "world '" + world.name + "' lists systems, but not physics";
    diagnostics.warning(world.position, who + ": nothing will move",
                        "add <plugin filename=\"ignition-gazebo-physics-system\" "
                        "name=\"ignition::gazebo::systems::Physics\"/>");
  }
  for (std::size_t i = 0; i < more.size(); ++i)
    add(more[i], world.plugins.size() + i, {}, {paths_, false, kRequired}, diagnostics);
}

void SystemSet::loadModelPlugins(world::Slot model, const Origin& origin, Diagnostics& diagnostics) {
  loadOwnPlugins(model, origin, diagnostics);
  for (world::Slot nested : access_.entities.models()[model].models) loadModelPlugins(nested, origin, diagnostics);
}

void SystemSet::loadOwnPlugins(world::Slot model, const Origin& origin, Diagnostics& diagnostics) {
  if (!loadsPlugins_) return;
  const std::vector<description::Plugin>& plugins = access_.entities.models()[model].description->plugins;
  for (std::size_t i = 0; i < plugins.size(); ++i) add(plugins[i], i, {.model = model}, origin, diagnostics);
}

bool SystemSet::isFromServer(const std::shared_ptr<const std::string>& file) {
  if (file != nullptr && file != lastFile_) {
    isLastFromServer_ = base::isBelow(*file, fuelCache_);
    lastFile_ = file;
  }
  return file != nullptr && isLastFromServer_;
}

void SystemSet::add(const description::Plugin& plugin, std::size_t number, const Holder& holder, Origin origin,
                    Diagnostics& diagnostics) {
  if (const plugin::CoreSystem* core = plugin::coreSystem(plugin.filename); core != nullptr && !core->holders.empty()) {
    const char* here = holder.actor != nullptr ? "<actor>" : holder.model != world::kNoSlot ? "<model>" : "<world>";
    if (core->holders.find(here) == std::string::npos) {
      diagnostics.warning(plugin.sdf.position, core->name + " is left out: it belongs in " + core->holders);
    }
    return;
  }
  if (isFromServer(plugin.sdf.position.file)) {
    origin = {plugin::Loader::Paths::kNever, true, origin.need, origin.isWatcher};
  }
  std::string name = plugin::systemName(plugin.filename);
  std::unique_ptr<System> system;
  std::optional<Declaration> declaration;
  {
    const base::RunningPart running(plugin.filename.c_str(), "while it was loaded");
    system = loader_.load(plugin, origin.paths, origin.need, diagnostics);
    if (system != nullptr) declaration = declared(*system, name, plugin.sdf.position, diagnostics);
  }
  if (!declaration) return;

  std::optional<Model> model;
  std::optional<Actor> actor;
  bool endsWithReset = false;
  const std::string* nameSpace = nullptr;
  const bool isInWorld = holder.model == world::kNoSlot && holder.actor == nullptr;
  if (isOfSensors(*declaration) && !isInWorld) {
    if (hasOfWorld(*declaration)) return;
    number = kFirstFromModels + countFromModels();
    endsWithReset = holder.model != world::kNoSlot && access_.entities.models()[holder.model].id > lastOfFile_;
  } else if (holder.model != world::kNoSlot) {
    const world::ModelRecord& record = access_.entities.models()[holder.model];
    model = Model(access_, record.id);
    name += " of " + record.scopedName;
    nameSpace = &access_.entities.nameSpace(holder.model);
  } else if (holder.actor != nullptr) {
    actor = Actor(access_, holder.actor->id);
    name += " of " + holder.actor->description->name;
  }
  const bool isStandIn = declaration->isOutside() && !loadsOutsiders_;
  if (isStandIn) {
    // keeps its place, where a replay makes the changes that it made
    system = std::make_unique<StandIn>();
    declaration = declared(*system, name, {}, diagnostics);
  }
  const bool isBelow = nameSpace != nullptr && !nameSpace->empty();
  const Node node = isBelow ? transport_.node().below(*nameSpace) : transport_.node();
  start({model ? model->id() : ModelId(), number, name, isStandIn ? Element() : plugin.sdf, node,
         stream(SystemSlot::streamOf(name, number)), std::move(system), *std::move(declaration),
         actor ? actor->id() : ActorId(), where(), false, origin.isFromOutside, endsWithReset, origin.isWatcher},
        model, actor, diagnostics);
}

std::size_t SystemSet::countFromModels() const {
  const auto count = std::ranges::count_if(
      slots_, [](const SystemSlot& slot) { return !slot.isAdded() && slot.number() >= kFirstFromModels; });
  return static_cast<std::size_t>(count);
}

bool SystemSet::hasOfWorld(const Declaration& declaration) const {
  return std::ranges::any_of(
      slots_, [&](const SystemSlot& slot) { return !slot.model() && slot.declaration().text() == declaration.text(); });
}

void SystemSet::warnOfMissing(std::size_t sensors, Diagnostics& diagnostics) {
  loader_.reportMissing(diagnostics);
  const std::vector<world::SensorRecord>& all = access_.entities.sensors();
  if (sensors == all.size()) return;
  plugin::SensorCheck check;
  for (const SystemSlot& slot : slots_) check.add(slot.declaration());
  for (; sensors < all.size(); ++sensors) check.add(*all[sensors].description);
  check.report(diagnostics);
}

bool SystemSet::add(std::string name, std::unique_ptr<System> system, Diagnostics& diagnostics) {
  if (name.empty() ||
      std::ranges::any_of(slots_, [&](const SystemSlot& slot) { return slot.isAdded() && slot.name() == name; })) {
    diagnostics.error({},
                      name.empty() ? "an added system has no name" : "there is an added system '" + name + "' already");
    return false;
  }
  const auto number = static_cast<std::size_t>(std::ranges::count_if(slots_, &SystemSlot::isAdded));
  Element plugin;
  plugin.name = "plugin";
  const Random random = stream(SystemSlot::streamOf(name, number));
  std::optional<Declaration> declaration = declared(*system, name, {}, diagnostics);
  const bool isUsed = declaration && start({{},
                                            number,
                                            std::move(name),
                                            std::move(plugin),
                                            transport_.node(),
                                            random,
                                            std::move(system),
                                            *std::move(declaration),
                                            {},
                                            where(),
                                            true,
                                            false},
                                           {}, {}, diagnostics);
  collect();
  return isUsed;
}

bool SystemSet::addWatcher(const Element& plugin, Diagnostics& diagnostics) {
  const std::size_t before = slots_.size();
  Diagnostics own;
  add(pluginsOf({plugin}).front(), before, {}, {plugin::Loader::Paths::kNever, false, kRequired, true}, own);
  const bool isUsed = slots_.size() > before && !own.hasErrors();
  if (!isUsed && slots_.size() > before) {
    forgetTopics(slots_.back());
    slots_.pop_back();
  }
  for (const Diagnostic& each : own.all()) diagnostics.add(each);
  collect();
  return isUsed;
}

std::vector<SensorReadings> SystemSet::readings(std::string_view sensorType) const {
  std::vector<SensorReadings> found;
  for (const SystemSlot& slot : slots_) {
    std::ranges::copy_if(slot.declaration().readings(), std::back_inserter(found),
                         [&](const SensorReadings& each) { return each.sensorType == sensorType; });
  }
  return found;
}

bool SystemSet::start(SystemSlot::Parts parts, const std::optional<Model>& model, const std::optional<Actor>& actor,
                      Diagnostics& diagnostics) {
  SystemSlot& slot = slots_.emplace_back(
      std::move(parts), access_, queue_,
      [this](const SystemSlot& each, const std::string& what) { noteFailure(each, what); },
      [this](const SystemSlot& each, const std::string& topic) { noteTopic(each, topic); });
  if (!slot.start(world_, model, actor, systems_, diagnostics)) {
    forgetTopics(slot);
    slots_.pop_back();
    return false;
  }
  systems_.push_back(&slot.system());
  warnOfSharedTopics(slot, diagnostics);
  return true;
}

void SystemSet::noteTopic(const SystemSlot& slot, const std::string& topic) { publishers_[topic].push_back(&slot); }

void SystemSet::forgetTopics(const SystemSlot& slot) {
  for (const std::string& topic : slot.topics()) {
    const auto found = publishers_.find(topic);
    if (found == publishers_.end()) continue;
    std::erase(found->second, &slot);
    if (found->second.empty()) publishers_.erase(found);
  }
}

void SystemSet::warnOfSharedTopics(const SystemSlot& slot, Diagnostics& diagnostics) const {
  if (slot.declaration().topicsAreShared()) return;
  std::vector<const SystemSlot*> named;
  for (const std::string& topic : slot.topics()) {
    for (const SystemSlot* other : publishers_.at(topic)) {
      // only for systems of one kind: other subscribers and publishers of a topic may know of each other
      if (other == &slot || other->declaration().text() != slot.declaration().text()) continue;
      if (std::ranges::find(named, other) != named.end()) continue;
      named.push_back(other);
      diagnostics.warning(slot.position(),
                          slot.name() + " publishes on '" + topic + "', and so does " + other->name() + " in line " +
                              std::to_string(other->position().line),
                          "subscribers get the messages of both");
    }
  }
}

/// @return A system's random stream. In the first world of a file it is the same as in a file with that world only; in
/// the others it also depends on the world's name.
Random SystemSet::stream(const std::string& name) const {
  return {seed_, place_.number == 0 ? name : std::string(world_.name()) + ": " + name};
}

std::string SystemSet::where() const { return place_.isAlone ? "" : " (world " + std::string(world_.name()) + ")"; }

void SystemSet::noteFailure(const SystemSlot& slot, const std::string& what) {
  if (!strict_) {
    Logger(slot.label()).error(what + "; it is switched off" + inBrackets(slot.position()));
  } else if (!failure_) {
    failure_ = slot.label() + " " + what;
  }
}

void SystemSet::check() const {
  if (failure_) throw std::runtime_error(*failure_);
}

void SystemSet::load(world::Slot model, bool isFromOutside, Diagnostics& diagnostics) {
  loadModelPlugins(model, {plugin::Loader::Paths::kNever, isFromOutside}, diagnostics);
  if (loadsPlugins_) warnOfMissing(firstSensor(access_.entities, model), diagnostics);
  collect();
}

template <class Predicate>
void SystemSet::end(Predicate predicate) {
  slots_.remove_if([&](const SystemSlot& slot) {
    const bool ends = predicate(slot);
    if (ends) forgetTopics(slot);
    return ends;
  });
}

void SystemSet::unload(const std::vector<ModelId>& models) {
  end([&](const SystemSlot& slot) { return std::ranges::binary_search(models, slot.model()); });
  collect();
  // does not allocate: memory was reserved when the file was loaded
  std::ranges::copy_if(models, std::back_inserter(unloaded_), [this](ModelId model) { return model <= lastOfFile_; });
}

void SystemSet::updateWhoRests() {
  const auto isAside = [this](auto id) { return access_.entities.isSetAside(id.value); };
  for (SystemSlot& slot : slots_) slot.setResting(isAside(slot.model()) || isAside(slot.actor()));
  collect();
}

void SystemSet::collect() {
  systems_.clear();
  awake_.clear();
  for (SystemSlot& slot : slots_) {
    systems_.push_back(&slot.system());
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
  forgetPast();
  end([&](const SystemSlot& slot) {
    return slot.endsWithReset() || (slot.model() && access_.entities.slot(slot.model()) == world::kNoSlot);
  });
  collect();
  for (const ModelId model : std::exchange(unloaded_, {})) {
    const world::Slot slot = access_.entities.slot(model);
    if (slot != world::kNoSlot) loadOwnPlugins(slot, {paths_}, diagnostics);
  }
  putInOrder();
  updateWhoRests();
  for (SystemSlot& slot : slots_) slot.switchOn(stream(slot.stream()));
  announceChanges();
  for (SystemSlot& slot : slots_) {
    // set again, because systems may have drawn numbers in `worldChanged`
    slot.setRandom(stream(slot.stream()));
    slot.reset();
  }
}

void SystemSet::forgetPast() {
  queue_.clear();
  failure_.reset();
}

void SystemSet::jump() {
  for (SystemSlot& slot : slots_) slot.reset();
}

Outcome<void> SystemSet::finish() {
  Outcome<void> outcome;
  for (SystemSlot& slot : slots_) {
    const Outcome<void> done = slot.finish();
    if (!done) outcome.error += (outcome.error.empty() ? "" : "; ") + slot.label() + ": " + done.error;
  }
  return outcome;
}

std::vector<std::string> SystemSet::save() {
  std::vector<std::string> saved;
  for (SystemSlot& slot : slots_) {
    if (slot.isWatcher()) continue;
    StateArchive archive;
    slot.transfer(archive);
    const std::vector<std::byte> bytes = archive.take();
    saved.emplace_back(reinterpret_cast<const char*>(bytes.data()), bytes.size());
  }
  return saved;
}

void SystemSet::restore(const std::vector<std::string>& saved, bool awakeOnly) {
  const auto isSaved = [](const SystemSlot& slot) { return !slot.isWatcher(); };
  if (std::cmp_not_equal(saved.size(), std::ranges::count_if(slots_, isSaved)))
    throw std::runtime_error("it is of other systems");
  auto next = saved.begin();
  for (SystemSlot& slot : slots_) {
    if (!isSaved(slot)) continue;
    StateArchive archive(std::as_bytes(std::span(next->data(), next->size())));
    ++next;
    if (awakeOnly && slot.isResting()) continue;
    try {
      slot.transfer(archive);
    } catch (const std::exception& error) {
      throw std::runtime_error("system " + slot.name() + ": " + error.what());
    }
    if (!archive.rest().empty())
      throw std::runtime_error("system " + slot.name() + ": it has more than the system reads");
  }
}

void SystemSet::addTo(base::Hash& hash) const {
  for (const SystemSlot& slot : slots_) {
    if (!slot.isWatcher()) hash.add(slot.stream());
  }
}

/// Sorts the systems as they were loaded at the start: those of the world, of each model, of each actor, added ones,
/// watchers.
void SystemSet::putInOrder() {
  const auto place = [this](const SystemSlot& slot) {
    return std::tuple(slot.isWatcher(), slot.isAdded(), slot.actor(),
                      slot.model() ? access_.entities.slot(slot.model()) + 1 : 0, slot.number());
  };
  slots_.sort([&](const SystemSlot& a, const SystemSlot& b) { return place(a) < place(b); });
}

/// Prefetches the systems that are called soon: a thousand systems do not fit into the nearest caches.
void SystemSet::lookAhead(std::size_t system) const {
  constexpr std::size_t kFar = 8, kNear = 4, kBytes = 512;
  if (system + kFar < awake_.size()) base::prefetch(*awake_[system + kFar]);
  if (system + kNear < awake_.size()) base::prefetch(awake_[system + kNear]->system(), kBytes);
}

void SystemSet::preUpdate(const StepInfo& info) {
  // a system may have failed in a message or request since the last step
  check();
  queue_.carryOut();
  announceChanges();
  for (std::size_t i = 0; i < awake_.size(); ++i) {
    lookAhead(i);
    awake_[i]->preUpdate(info);
  }
  check();
}

void SystemSet::update(const StepInfo& info) {
  for (std::size_t i = 0; i < awake_.size(); ++i) {
    lookAhead(i);
    awake_[i]->update(info);
  }
  check();
}

void SystemSet::postUpdate(const StepInfo& info) {
  for (std::size_t i = 0; i < awake_.size(); ++i) {
    lookAhead(i);
    awake_[i]->postUpdate(info);
  }
  queue_.carryOut();
  check();
}

}  // namespace pongsim::sim
