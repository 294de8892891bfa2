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
#include "sim/file_worlds.hh"
#include "sim/inputs/inside.hh"
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

/// @param profile The world's, which chooses the solver, as in Fortress with DART.
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
        access(description, settingsFor(description.physics, options)),
        edits(access, places, description.position.file ? *description.position.file : std::string()),
        transport(chooseTransport(options, sharesTransport)),
        systems(access, edits, transport, options.seed, options.strict, place),
        wantsPhysics(options.physics) {
    edits.setSystems(systems);
    access.particles.setSeed(options.seed);
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

  /// Loads and unloads levels. The systems are notified at their next call.
  void updateLevels() {
    const std::uint64_t before = access.changes;
    access.levels.update();
    if (access.changes != before) systems.updateWhoRests();
  }
  void stepEngine(Time dt);

  bool hasPhysics() const { return wantsPhysics && systems.wantsPhysics(); }
  StepInfo nextStep(Time dt) const {
    const bool paused = dt == Time::zero();
    return {access.state.time + dt, dt, access.state.iterations + (paused ? 0 : 1), paused};
  }

  const description::World description;
  /// Where files of inserted models are searched.
  assets::Places places = assets::Places::fromEnvironment();
  sim::Access access;
  sim::ModelEdits edits;
  std::optional<Transport> ownTransport;
  Transport& transport;
  /// The systems; only added ones if the options ask for no systems of the file.
  sim::SystemSet systems;
  struct Offers {
    explicit Offers(Simulation& simulation) : edits(simulation), resources(simulation, [](const auto&) {}) {}

    sim::EditServices edits;
    sim::ResourceServices resources;
  };
  std::optional<Offers> offers;
  const bool wantsPhysics;
  /// Links whose excessive angular velocity has been reported.
  std::set<LinkId> slowedDown;
  /// Whether an excessive number of overlapping links has been reported.
  bool isCrowded = false;
};

std::unique_ptr<Simulation> Simulation::Parts::makeOne(sdf::Root root, const SimulationOptions& options,
                                                       Diagnostics& diagnostics) {
  if (!sim::prepareWorlds(root, diagnostics)) return nullptr;
  const std::optional<std::size_t> number = sim::chooseWorld(root.worlds, options.world, diagnostics);
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
  parts->access.levels.start();
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
  if (!sim::prepareWorlds(root, diagnostics)) return {};
  const bool isOne = root.worlds.size() == 1;
  sim::checkTopicNames(root.worlds, diagnostics);
  if (diagnostics.hasErrors()) return {};
  std::vector<std::unique_ptr<Simulation>> all;
  std::vector<SourcePosition> positions;
  SimulationOptions ofWorlds = options;
  if (!isOne) {
    for (Element& plugin : ofWorlds.systems) plugin.attributes.push_back({"beside_others", "true", plugin.position});
  }
  bool isComplete = true;
  for (std::size_t i = 0; i < root.worlds.size(); ++i) {
    // all worlds are read, to report the errors of all
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

Outcome<void> Simulation::finish() { return parts_->systems.finish(); }

void Simulation::Parts::stepEngine(Time dt) {
  sim::Editor(access).cutPower();
  access.engine.step(dt, access.state);
  if (const auto crowding = access.engine.crowding(); crowding && !std::exchange(isCrowded, true)) {
    Logger("physics").warning(std::to_string(crowding->pairs) +
                              " pairs of links are inside one another or near it, too "
                              "many for the memory: " +
                              std::to_string(crowding->pairs - crowding->most) + " of them pass through each other");
  }
  const world::Slot link = access.engine.slowedDown();
  if (link == world::kNoSlot || !slowedDown.insert(access.entities.links()[link].id).second) return;
  const world::LinkRecord& record = access.entities.links()[link];
  Logger("physics").warning("link '" + access.entities.models()[record.model].scopedName +
                            "::" + record.description->name +
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
    parts.access.state.time = info.time;
    parts.access.state.iterations = info.iteration;
    parts.access.particlesNow().advance(parts.access.entities, parts.access.state, toSeconds(info.dt));
  }
  parts.systems.postUpdate(info);
}

Time Simulation::time() const { return parts_->access.state.time; }

std::uint64_t Simulation::iterations() const { return parts_->access.state.iterations; }

Time Simulation::stepSize() const { return parts_->access.state.stepSize; }

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

Outcome<void> Simulation::changeLight(const Message& light) {
  Outcome<void> done = sim::changeLight(parts_->access, light);
  parts_->systems.announceChanges();
  return done;
}

Outcome<void> Simulation::removeLight(LightId id, const std::string& name) {
  Outcome<void> done = sim::removeLight(parts_->access, id.value, name);
  parts_->systems.announceChanges();
  return done;
}

Outcome<void> Simulation::addResourceFolder(const std::filesystem::path& folder) {
  std::error_code error;
  const std::filesystem::path whole = std::filesystem::absolute(folder, error);
  if (folder.empty() || error || !std::filesystem::is_directory(whole, error)) {
    return {"'" + folder.string() + "' is not a folder"};
  }
  if (std::ranges::find(parts_->places.folders, whole) == parts_->places.folders.end()) {
    parts_->places.folders.push_back(whole);
  }
  return {};
}

std::vector<std::filesystem::path> Simulation::resourceFolders() const { return parts_->places.folders; }

bool Simulation::isInReach(const std::filesystem::path& path) const { return parts_->edits.isInReach(path); }

std::optional<std::filesystem::path> Simulation::resolve(const std::string& address) const {
  Diagnostics none;
  return assets::finderIn(parts_->places)(address, std::filesystem::path(), {}, none);
}

Outcome<void> Simulation::remove(const Model& model) { return remove(std::span(&model, 1)); }

Outcome<void> Simulation::remove(std::span<const Model> models) {
  std::vector<ModelId> ids;
  for (const Model& model : models) ids.push_back(model.id());
  return parts_->edits.remove(ids);
}

Outcome<void> Simulation::addPerformer(const std::string& model) {
  if (model.empty()) return {"no model is given"};
  sim::Access& access = parts_->access;
  const world::Slot slot = access.entities.findModel(model);
  if (slot != world::kNoSlot) return access.levels.add(access.entities.models()[slot].id, {}, sim::kPerformerSize);
  Logger("levels").warning("there is no model '" + model + "' yet: it becomes a performer when it is inserted");
  access.levels.addLater(model);
  return {};
}

bool Simulation::isSetAside(const std::string& model) const { return parts_->access.entities.isSetAside(model); }

std::size_t Simulation::countSetAside() const {
  return static_cast<std::size_t>(std::ranges::count_if(
      parts_->access.entities.models(),
      [](const world::ModelRecord& model) { return model.isSetAside && model.parent == world::kNoSlot; }));
}

Outcome<void> Simulation::setStepSize(Time size) {
  if (size <= Time::zero() || size > kLongestStep) return {"a step must be longer than 0 s and at most 1 s"};
  parts_->access.state.stepSize = size;
  return {};
}

Outcome<void> Simulation::setRealTimeFactor(double factor) { return world().setRealTimeFactor(factor); }

void Simulation::reset(Diagnostics& diagnostics, std::optional<std::uint64_t> seed) {
  // what was sent before belongs to the time before
  parts_->transport.discard();
  sim::Editor(parts_->access).reset();
  if (!parts_->access.colors.empty()) ++parts_->access.colorChanges;
  parts_->access.colors.clear();
  parts_->access.particles.clear();
  if (seed) parts_->access.particles.setSeed(*seed);
  parts_->access.levels.start();
  parts_->systems.reset(diagnostics, seed);
  parts_->updateLevels();
  parts_->systems.announceChanges();
}

bool Simulation::hasPhysics() const { return parts_->hasPhysics(); }

Outcome<void> Simulation::setTime(Time time) {
  if (parts_->hasPhysics()) return {"the world is not a recording: it has no time to seek to"};
  if (time < Time::zero()) return {"the time must be zero or more"};
  parts_->access.state.time = time;
  parts_->access.state.iterations = static_cast<std::uint64_t>(time / stepSize());
  parts_->access.particles.clear();
  parts_->systems.jump();
  return {};
}

std::vector<std::byte> Simulation::saveState() { return sim::saveState(parts_->access, parts_->systems); }

Outcome<void> Simulation::restoreState(std::span<const std::byte> state) {
  Outcome<void> restored = sim::restoreState(state, parts_->access, parts_->systems);
  if (!restored) return restored;
  parts_->transport.discard();
  parts_->systems.forgetPast();
  return {};
}

World Simulation::world() { return World(parts_->access); }

bool Simulation::addSystem(std::string name, std::unique_ptr<System> system, Diagnostics& diagnostics) {
  return parts_->systems.add(std::move(name), std::move(system), diagnostics);
}

bool Simulation::addWatcher(const Element& plugin, Diagnostics& diagnostics) {
  return parts_->systems.addWatcher(plugin, diagnostics);
}

std::vector<SensorReadings> Simulation::readings(std::string_view sensorType) const {
  return parts_->systems.readings(sensorType);
}

void Simulation::offerEdits() {
  if (!parts_->offers) parts_->offers.emplace(*this);
}

std::uint64_t Simulation::stateHash() const { return world::stateHash(parts_->access.state); }

Transport& Simulation::transport() { return parts_->transport; }

sim::Access& sim::Inside::access(Simulation& simulation) { return simulation.parts_->access; }

const sim::Access& sim::Inside::access(const Simulation& simulation) { return simulation.parts_->access; }

}  // namespace pongsim
