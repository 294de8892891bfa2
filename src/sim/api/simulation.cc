#include "pongsim/simulation.hh"

#include <algorithm>
#include <cmath>
#include <iterator>
#include <optional>
#include <set>
#include <span>
#include <stdexcept>
#include <string_view>
#include <system_error>
#include <utility>
#include <vector>

#include "assets/file_cache.hh"
#include "assets/finder.hh"
#include "assets/places.hh"
#include "description/world.hh"
#include "physics/engine.hh"
#include "pongsim/log.hh"
#include "sdf/loader.hh"
#include "sim/api/access.hh"
#include "sim/edits/edit_services.hh"
#include "sim/edits/editor.hh"
#include "sim/edits/light_edits.hh"
#include "sim/edits/model_edits.hh"
#include "sim/levels.hh"
#include "sim/resource_services.hh"
#include "sim/running/server_config.hh"
#include "sim/running/world_place.hh"
#include "sim/shared_topics.hh"
#include "sim/state/saved_state.hh"
#include "sim/system_set.hh"
#include "world/entities.hh"
#include "world/state.hh"

namespace pongsim {

namespace {

/// @param profile Of the world, which chooses between the solvers as Fortress's engine understands it.
physics::Settings settingsFor(const description::PhysicsProfile& profile, const SimulationOptions& options) {
  physics::Settings settings;
  settings.threads = std::max(options.threads, 1);
  settings.maxContacts = profile.maxContacts;
  settings.hullCache = assets::FileCache::userFolder();
  if (profile.dart.solver == "pgs") settings.solver = physics::Solver::kGaussSeidel;
  return settings;
}

}  // namespace

struct Simulation::Parts {
  Parts(description::World world, const sim::WorldPlace& place, bool sharesTransport, const SimulationOptions& options)
      : description(std::move(world)),
        entities(description),
        state(entities),
        engine(entities, settingsFor(description.physics, options)),
        access{entities, state, engine},
        edits(access, places),
        transport(chooseTransport(options, sharesTransport)),
        systems(access, edits, transport, options.seed, options.strict, place),
        wantsPhysics(options.physics) {
    edits.setSystems(systems);
  }

  /// @return The simulation of one of the file's worlds; null, with the reason in `diagnostics`, if it can't run.
  static std::unique_ptr<Simulation> makeOne(sdf::Root root, const SimulationOptions& options,
                                             Diagnostics& diagnostics);
  static std::unique_ptr<Simulation> make(description::World world, const sim::WorldPlace& place, bool sharesTransport,
                                          const SimulationOptions& options, Diagnostics& diagnostics);

  /// @return The program's transport, or one of the simulation's own.
  Transport& chooseTransport(const SimulationOptions& options, bool sharesTransport) {
    if (options.transport == nullptr) return ownTransport.emplace(TransportOptions{.network = false, .domain = {}});
    return sharesTransport ? ownTransport.emplace(*options.transport, Transport::Sharing()) : *options.transport;
  }

  /// Loads and unloads levels. The systems are told when they are called next.
  void updateLevels() {
    const std::uint64_t before = access.changes;
    access.levels.update(access);
    if (access.changes != before) systems.updateWhoRests();
  }
  void stepEngine(Time dt);

  bool hasPhysics() const { return wantsPhysics && systems.wantsPhysics(); }
  StepInfo nextStep(Time dt) const {
    const bool paused = dt == Time::zero();
    return {state.time + dt, dt, state.iterations + (paused ? 0 : 1), paused};
  }

  const description::World description;
  /// Where files that inserted models name are looked for.
  assets::Places places = assets::Places::fromEnvironment();
  world::Entities entities;
  world::State state;
  physics::Engine engine;
  sim::Access access;
  sim::ModelEdits edits;
  std::optional<Transport> ownTransport;
  Transport& transport;
  /// None but added ones where the options want none.
  sim::SystemSet systems;
  struct Offers {
    explicit Offers(Simulation& simulation) : edits(simulation), resources(simulation, [](const auto&) {}) {}

    sim::EditServices edits;
    sim::ResourceServices resources;
  };
  std::optional<Offers> offers;
  const bool wantsPhysics;
  /// Links of which it was said that they turn too fast.
  std::set<LinkId> slowedDown;
};

namespace {

/// @return A world around the models, lights and actors that stand in none: a ground, the sun, and what a world has by
/// default.
description::World worldAround(sdf::Root root) {
  constexpr std::string_view kWorld =
      "<sdf version='1.9'><world name='default'><light name='sun' type='directional'><pose>0 0 10 0 0 0</pose></light>"
      "<model name='ground_plane'><static>true</static><link name='link'>"
      "<collision name='collision'><geometry><plane><size>100 100</size></plane></geometry></collision>"
      "<visual name='visual'><geometry><plane><size>100 100</size></plane></geometry></visual>"
      "</link></model></world></sdf>";
  Diagnostics none;
  description::World world = std::move(sdf::loadText(kWorld, "default world", none, {}).worlds.at(0));
  const auto addTo = [](auto& standard, auto& own) {
    // the file's own ground or sun takes the place of ours
    for (const auto& part : own) std::erase_if(standard, [&](const auto& other) { return other.name == part.name; });
    std::ranges::move(own, std::back_inserter(standard));
  };
  addTo(world.models, root.models);
  addTo(world.lights, root.lights);
  addTo(world.actors, root.actors);
  return world;
}

}  // namespace

namespace {

/// Puts a world around what stands in none, where there is no other.
/// @return Whether the file can be simulated.
bool prepare(sdf::Root& root, Diagnostics& diagnostics) {
  for (const Diagnostic& diagnostic : root.unsimulated.all()) diagnostics.add(diagnostic);
  if (diagnostics.hasErrors()) return false;
  if (!root.worlds.empty()) return true;
  description::World around = worldAround(std::move(root));
  root.worlds.clear();
  root.worlds.push_back(std::move(around));
  return true;
}

/// @return The number of the world of that name, of the first one where it is empty; nothing, and an error added,
/// where there is none.
std::optional<std::size_t> chooseWorld(const std::vector<description::World>& worlds, const std::string& name,
                                       Diagnostics& diagnostics) {
  if (!name.empty()) {
    const auto found = std::ranges::find(worlds, name, &description::World::name);
    if (found != worlds.end()) return static_cast<std::size_t>(found - worlds.begin());
    std::string names;
    for (const description::World& world : worlds) names += (names.empty() ? "'" : ", '") + world.name + "'";
    diagnostics.error(worlds.front().position, "there is no world '" + name + "' in this file", "it has " + names);
    return std::nullopt;
  }
  for (std::size_t i = 1; i < worlds.size(); ++i) {
    diagnostics.warning(worlds[i].position,
                        "world '" + worlds[i].name + "' is left out: the first one is used, '" + worlds[0].name + "'",
                        "name the world to choose another");
  }
  return 0;
}

/// Adds an error for each world whose topics have the names of another one's, for "a b" and "a_b" have the same.
void checkTopicNames(const std::vector<description::World>& worlds, Diagnostics& diagnostics) {
  for (std::size_t i = 1; i < worlds.size(); ++i) {
    for (std::size_t j = 0; j < i; ++j) {
      const std::string topics = cleanTopic("/world/" + worlds[i].name);
      if (topics != cleanTopic("/world/" + worlds[j].name)) continue;
      diagnostics.error(worlds[i].position,
                        "the topics of world '" + worlds[i].name + "' collide with those of world '" + worlds[j].name +
                            "': " + topics + "/...",
                        "rename one of them");
    }
  }
}

}  // namespace

std::unique_ptr<Simulation> Simulation::Parts::makeOne(sdf::Root root, const SimulationOptions& options,
                                                       Diagnostics& diagnostics) {
  if (!prepare(root, diagnostics)) return nullptr;
  const std::optional<std::size_t> number = chooseWorld(root.worlds, options.world, diagnostics);
  if (!number) return nullptr;
  return make(std::move(root.worlds[*number]), {*number, true}, false, options, diagnostics);
}

std::unique_ptr<Simulation> Simulation::Parts::make(description::World world, const sim::WorldPlace& place,
                                                    bool sharesTransport, const SimulationOptions& options,
                                                    Diagnostics& diagnostics) {
  if (options.levels && !world.levels.isGiven) {
    diagnostics.warning(world.position, "world '" + world.name + "' has no levels: all of it is loaded",
                        "add them in a <plugin filename=\"dummy\" name=\"gz::sim\"> of the world");
  }
  const bool isConfigured = options.loadSystems && sim::applyServerConfig(world, diagnostics);
  auto parts = std::make_unique<Parts>(std::move(world), place, sharesTransport, options);
  if (options.levels) parts->access.levels.use();
  parts->access.levels.start(parts->access);
  if (options.loadSystems) {
    parts->systems.load(parts->description, isConfigured, options, diagnostics);
    if (diagnostics.hasErrors()) return nullptr;
  }
  parts->updateLevels();
  parts->systems.announceChanges();
  return std::unique_ptr<Simulation>(new Simulation(std::move(parts)));
}

std::unique_ptr<Simulation> Simulation::fromFile(const std::filesystem::path& file, const SimulationOptions& options,
                                                 Diagnostics& diagnostics) {
  return Parts::makeOne(sdf::loadFile(file, diagnostics), options, diagnostics);
}

std::vector<std::unique_ptr<Simulation>> Simulation::allFromFile(const std::filesystem::path& file,
                                                                 const SimulationOptions& options,
                                                                 Diagnostics& diagnostics) {
  sdf::Root root = sdf::loadFile(file, diagnostics);
  if (!prepare(root, diagnostics)) return {};
  const bool isOne = root.worlds.size() == 1;
  checkTopicNames(root.worlds, diagnostics);
  if (diagnostics.hasErrors()) return {};
  std::vector<std::unique_ptr<Simulation>> all;
  std::vector<SourcePosition> positions;
  SimulationOptions ofWorlds = options;
  if (!isOne) {
    for (Element& plugin : ofWorlds.systems) plugin.attributes.push_back({"beside_others", "true", plugin.position});
  }
  bool isComplete = true;
  for (std::size_t i = 0; i < root.worlds.size(); ++i) {
    // all are tried, so that all that is wrong is said
    positions.push_back(root.worlds[i].position);
    Diagnostics found;
    all.push_back(Parts::make(std::move(root.worlds[i]), {i, isOne}, !isOne, ofWorlds, found));
    for (const Diagnostic& diagnostic : found.all()) diagnostics.add(diagnostic);
    isComplete = isComplete && all.back() != nullptr && !found.hasErrors();
  }
  if (!isComplete) return {};
  sim::warnOfSharedTopics(all, positions, diagnostics);
  return all;
}

std::unique_ptr<Simulation> Simulation::fromText(std::string_view text, std::string_view name,
                                                 const SimulationOptions& options, Diagnostics& diagnostics) {
  return Parts::makeOne(sdf::loadText(text, name, diagnostics), options, diagnostics);
}

Simulation::Simulation(std::unique_ptr<Parts> parts) : parts_(std::move(parts)) {}

Simulation::~Simulation() = default;

void Simulation::step(std::uint64_t count) {
  for (std::uint64_t i = 0; i < count; ++i) {
    parts_->transport.dispatch();
    advance(stepSize());
  }
}

void Simulation::stepPaused() {
  parts_->transport.dispatch();
  advance(Time::zero());
}

void Simulation::Parts::stepEngine(Time dt) {
  sim::Editor(access).cutPower();
  engine.step(dt, state);
  const world::Slot link = engine.slowedDown();
  if (link == world::kNoSlot || !slowedDown.insert(entities.links()[link].id).second) return;
  const world::LinkRecord& record = entities.links()[link];
  Logger("physics").warning("link '" + entities.models()[record.model].scopedName + "::" + record.description->name +
                            "' would turn more than once in a step or exceed 1e6 m/s, and is slowed down to "
                            "that (a shorter step may "
                            "help)");
}

void Simulation::advance(Time dt) {
  Parts& parts = *parts_;
  const StepInfo info = parts.nextStep(dt);
  parts.updateLevels();
  parts.systems.preUpdate(info);
  parts.systems.update(info);
  if (!info.paused) {
    if (parts.hasPhysics()) parts.stepEngine(info.dt);
    parts.state.time = info.time;
    parts.state.iterations = info.iteration;
  }
  parts.systems.postUpdate(info);
}

Time Simulation::time() const { return parts_->state.time; }

std::uint64_t Simulation::iterations() const { return parts_->state.iterations; }

Time Simulation::stepSize() const { return parts_->state.stepSize; }

double Simulation::realTimeFactor() const { return World(parts_->access).realTimeFactor(); }

std::optional<Model> Simulation::insertFile(const std::filesystem::path& file, const InsertOptions& options,
                                            Diagnostics& diagnostics) {
  return parts_->edits.insertFile(file, options, diagnostics);
}

std::optional<Model> Simulation::insertText(std::string_view text, std::string_view name, const InsertOptions& options,
                                            Diagnostics& diagnostics) {
  return parts_->edits.insertText(text, name, options, diagnostics);
}

std::optional<ModelOrLight> Simulation::insertModelOrLight(const std::filesystem::path& file,
                                                           const InsertOptions& options, Diagnostics& diagnostics) {
  return parts_->edits.insertModelOrLight(file, options, diagnostics);
}

std::optional<ModelOrLight> Simulation::insertModelOrLight(std::string_view text, std::string_view name,
                                                           const InsertOptions& options, Diagnostics& diagnostics) {
  return parts_->edits.insertModelOrLight(text, name, options, diagnostics);
}

std::optional<Model> Simulation::insertCopy(const Model& model, const InsertOptions& options,
                                            Diagnostics& diagnostics) {
  return parts_->edits.insertCopy(model.id(), options, diagnostics);
}

Outcome<std::string> Simulation::insertLight(const Message& light, const InsertOptions& options) {
  Outcome<std::string> name = sim::insertLight(parts_->access, light, options);
  parts_->systems.announceChanges();
  return name;
}

std::optional<std::string> Simulation::changeLight(const Message& light) {
  const std::optional<std::string> refusal = sim::changeLight(parts_->access, light);
  parts_->systems.announceChanges();
  return refusal;
}

std::optional<std::string> Simulation::removeLight(LightId id, const std::string& name) {
  const std::optional<std::string> refusal = sim::removeLight(parts_->access, id.value, name);
  parts_->systems.announceChanges();
  return refusal;
}

std::optional<std::string> Simulation::addResourceFolder(const std::filesystem::path& folder) {
  std::error_code error;
  const std::filesystem::path whole = std::filesystem::absolute(folder, error);
  if (folder.empty() || error || !std::filesystem::is_directory(whole, error)) {
    return "'" + folder.string() + "' is not a folder";
  }
  if (std::ranges::find(parts_->places.folders, whole) == parts_->places.folders.end()) {
    parts_->places.folders.push_back(whole);
  }
  return std::nullopt;
}

std::vector<std::filesystem::path> Simulation::resourceFolders() const { return parts_->places.folders; }

std::optional<std::filesystem::path> Simulation::resolve(const std::string& address) const {
  Diagnostics none;
  return assets::finderIn(parts_->places)(address, std::filesystem::path(), {}, none);
}

std::optional<std::string> Simulation::remove(const Model& model) { return remove(std::span(&model, 1)); }

std::optional<std::string> Simulation::remove(std::span<const Model> models) {
  std::vector<ModelId> ids;
  for (const Model& model : models) ids.push_back(model.id());
  return parts_->edits.remove(ids);
}

std::optional<std::string> Simulation::addPerformer(const std::string& model) {
  if (model.empty()) return "no model is given";
  sim::Access& access = parts_->access;
  const world::Slot slot = access.entities.findModel(model);
  if (slot != world::kNoSlot)
    return access.levels.add(access, access.entities.models()[slot].id, {}, sim::kPerformerSize);
  Logger("levels").warning("there is no model '" + model + "' yet: it becomes a performer when it is inserted");
  access.levels.addLater(model);
  return std::nullopt;
}

bool Simulation::isSetAside(const std::string& model) const { return parts_->access.entities.isSetAside(model); }

std::size_t Simulation::countSetAside() const {
  return static_cast<std::size_t>(std::ranges::count_if(parts_->entities.models(), [](const world::ModelRecord& model) {
    return model.isSetAside && model.parent == world::kNoSlot;
  }));
}

std::optional<std::string> Simulation::setStepSize(Time size) {
  if (size <= Time::zero() || size > kLongestStep) return "a step must be longer than 0 s and at most 1 s";
  parts_->state.stepSize = size;
  return std::nullopt;
}

std::optional<std::string> Simulation::setRealTimeFactor(double factor) { return world().setRealTimeFactor(factor); }

void Simulation::reset(Diagnostics& diagnostics, std::optional<std::uint64_t> seed) {
  sim::Editor(parts_->access).reset();
  parts_->access.levels.start(parts_->access);
  parts_->systems.reset(diagnostics, seed);
  parts_->updateLevels();
  parts_->systems.announceChanges();
}

std::optional<std::string> Simulation::setTime(Time time) {
  if (parts_->hasPhysics()) return "the world is not a recording: it has no time to seek to";
  if (time < Time::zero()) return "the time must be zero or more";
  parts_->state.time = time;
  parts_->state.iterations = static_cast<std::uint64_t>(time / stepSize());
  parts_->systems.jump();
  return std::nullopt;
}

std::vector<std::byte> Simulation::saveState() { return sim::saveState(parts_->access, parts_->systems); }

std::optional<std::string> Simulation::restoreState(std::span<const std::byte> state) {
  return sim::restoreState(state, parts_->access, parts_->systems);
}

World Simulation::world() { return World(parts_->access); }

bool Simulation::addSystem(std::string name, std::unique_ptr<System> system, Diagnostics& diagnostics) {
  return parts_->systems.add(std::move(name), std::move(system), diagnostics);
}

void Simulation::offerEdits() {
  if (!parts_->offers) parts_->offers.emplace(*this);
}

std::uint64_t Simulation::stateHash() const { return world::stateHash(parts_->state); }

Transport& Simulation::transport() { return parts_->transport; }

}  // namespace pongsim
