// From the `<plugin>`s of a world and its models to systems.
#include <algorithm>
#include <cstdlib>
#include <memory>
#include <string_view>
#include <system_error>
#include <utility>

#include "base/is_below.hh"
#include "description/model_sensors.hh"
#include "plugin/core_systems.hh"
#include "plugin/sensor_plugins.hh"
#include "plugin/system_name.hh"
#include "sim/plugin_elements.hh"
#include "sim/system_set.hh"

namespace pongsim::sim {

namespace {

constexpr auto kRequired = plugin::Loader::Need::kRequired;
constexpr std::string_view kPhysics = "physics";
constexpr std::string_view kUserCommands = "user-commands";
/// Lowest `number` of world systems that come from `<plugin>`s of models and actors; those of the world itself are
/// below.
constexpr std::size_t kFirstFromModels = 1'000'000;

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

/// Tells a system in a `<sensor>` which one it is in, by its parameter `<sensor>`.
/// @param sensor "link::sensor"
/// @return False if it has no such parameter: then it does not belong there.
bool tellSensor(const std::string& sensor, const Declaration& declaration, Element& plugin) {
  constexpr const char* kSensor = "sensor";
  if (std::ranges::find(declaration.parameters(), kSensor, &Parameter::name) == declaration.parameters().end()) {
    return false;
  }
  std::erase_if(plugin.children, [](const Element& child) { return child.name == kSensor; });
  plugin.children.emplace_back();
  plugin.children.back().name = kSensor;
  plugin.children.back().text = sensor;
  plugin.children.back().position = plugin.position;
  return true;
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

std::string_view SystemSet::Holder::element() const {
  if (!sensor.empty()) return "<sensor>";
  if (isVisual) return "<visual>";
  if (actor != nullptr) return "<actor>";
  return model != world::kNoSlot ? "<model>" : "<world>";
}

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
  // which moves all by itself, and wants no physics beside it
  const bool isPlayed = std::ranges::any_of(world.plugins, [](const description::Plugin& plugin) {
    return plugin.className.ends_with("::systems::LogPlayback");
  });
  if (!wantsPhysics_ && options.physics && !isPlayed) {
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
  const description::Model& description = *access_.entities.models()[model].description;
  std::size_t number = 0;
  for (const description::Plugin& plugin : description.plugins) {
    add(plugin, number++, {.model = model}, origin, diagnostics);
  }
  for (const description::Link& link : description.links) {
    for (const description::Visual& visual : link.visuals) {
      for (const description::Plugin& plugin : visual.plugins) {
        add(plugin, number++, {.model = model, .isVisual = true}, origin, diagnostics);
      }
    }
  }
  description::forEachOwnSensor(description, [&](const description::Sensor& sensor, const std::string& holder) {
    for (const description::Plugin& plugin : sensor.plugins) {
      add(plugin, number++, {.model = model, .sensor = holder + "::" + sensor.name}, origin, diagnostics);
    }
  });
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
    if (core->holders.find(holder.element()) == std::string::npos) {
      diagnostics.warning(plugin.sdf.position, core->name + " is left out: it belongs in " + core->holders);
    } else {
      loader_.reportLimit(*core, plugin.sdf.position, diagnostics);
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
  Element sdf = plugin.sdf;
  const bool belongsHere = !holder.isVisual && (holder.sensor.empty() || isOfSensors(*declaration) ||
                                                tellSensor(holder.sensor, *declaration, sdf));
  if (!belongsHere) {
    diagnostics.warning(plugin.sdf.position,
                        name + " is left out: it does not belong in a " + std::string(holder.element()));
    return;
  }

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
  start({model ? model->id() : ModelId(), number, name, isStandIn ? Element() : std::move(sdf), node,
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

void SystemSet::load(world::Slot model, bool isFromOutside, Diagnostics& diagnostics) {
  loadModelPlugins(model, {plugin::Loader::Paths::kNever, isFromOutside}, diagnostics);
  if (loadsPlugins_) warnOfMissing(firstSensor(access_.entities, model), diagnostics);
  collect();
}

}  // namespace pongsim::sim
