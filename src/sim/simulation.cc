#include "pongsim/simulation.hh"

#include <algorithm>
#include <cmath>
#include <iterator>
#include <optional>
#include <set>
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
#include "sim/access.hh"
#include "sim/editor.hh"
#include "sim/light_edits.hh"
#include "sim/saved_state.hh"
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
  if (profile.dart.solver == "pgs") settings.solver = physics::Solver::kSequentialImpulse;
  return settings;
}

}  // namespace

struct Simulation::Parts {
  Parts(description::World world, const SimulationOptions& options)
      : description(std::move(world)),
        entities(description),
        state(entities),
        engine(entities, settingsFor(description.physics, options)),
        access{entities, state, engine} {
    if (options.transport == nullptr) ownTransport.emplace(TransportOptions{.network = false, .domain = {}});
    transport = options.transport != nullptr ? options.transport : &*ownTransport;
  }

  /// @return The simulation of the file's first world; null, with the reason in `diagnostics`, if it can't run.
  static std::unique_ptr<Simulation> make(sdf::Root root, const SimulationOptions& options, Diagnostics& diagnostics);

  std::optional<Model> insert(sdf::Root root, const InsertOptions& options, Diagnostics& diagnostics);
  /// @param model What is to be inserted but for what the options say.
  std::optional<Model> insert(std::shared_ptr<description::Model> model, const InsertOptions& options,
                              Diagnostics& diagnostics);
  /// Calls `read` with the finder for what inserted models name, and inserts what it read.
  template <class Read>
  std::optional<Model> insertRead(Read read, const InsertOptions& options, Diagnostics& diagnostics);
  sim::SystemSet* systemSet() { return systems ? &*systems : nullptr; }
  void announceChanges() {
    if (systems) systems->announceChanges();
  }

  void stepEngine(Time dt);

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
  std::optional<Transport> ownTransport;
  Transport* transport = nullptr;
  std::optional<sim::SystemSet> systems;
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

std::unique_ptr<Simulation> Simulation::Parts::make(sdf::Root root, const SimulationOptions& options,
                                                    Diagnostics& diagnostics) {
  for (const Diagnostic& diagnostic : root.unsimulated.all()) diagnostics.add(diagnostic);
  if (diagnostics.hasErrors()) return nullptr;
  for (std::size_t i = 1; i < root.worlds.size(); ++i) {
    diagnostics.warning(root.worlds[i].position, "world '" + root.worlds[i].name + "' is left out: pongsim runs the " +
                                                     "first world of a file, '" + root.worlds[0].name + "'");
  }
  description::World world = root.worlds.empty() ? worldAround(std::move(root)) : std::move(root.worlds.front());
  auto parts = std::make_unique<Parts>(std::move(world), options);
  if (options.loadSystems) {
    parts->systems.emplace(parts->access, *parts->transport, options.seed, options.strict);
    parts->systems->load(parts->description, diagnostics);
    if (diagnostics.hasErrors()) return nullptr;
  }
  return std::unique_ptr<Simulation>(new Simulation(std::move(parts)));
}

std::optional<Model> Simulation::Parts::insert(sdf::Root root, const InsertOptions& options, Diagnostics& diagnostics) {
  for (const Diagnostic& diagnostic : root.unsimulated.all()) diagnostics.add(diagnostic);
  if (diagnostics.hasErrors()) return std::nullopt;
  if (root.models.empty()) {
    diagnostics.error({}, "there is no model to insert", "it must stand directly in <sdf>");
    return std::nullopt;
  }
  auto model = std::make_shared<description::Model>(std::move(root.models.front()));
  for (std::size_t i = 1; i < root.models.size(); ++i) {
    diagnostics.warning(root.models[i].position, "model '" + root.models[i].name + "' is left out: the first model, '" +
                                                     model->name + "', is inserted");
  }
  return insert(std::move(model), options, diagnostics);
}

std::optional<Model> Simulation::Parts::insert(std::shared_ptr<description::Model> model, const InsertOptions& options,
                                               Diagnostics& diagnostics) {
  if (!options.name.empty()) model->name = options.name;
  if (options.pose) model->X_ParentModel = *options.pose;
  sim::Editor editor(access);
  if (options.allowRenaming) model->name = editor.freeName(model->name);
  const SourcePosition position = model->position;
  if (!editor.isFree(model->name)) {
    diagnostics.error(position, "there is a '" + model->name + "' in the world already");
  } else if (model->name.find("::") != std::string::npos) {
    diagnostics.error(position, "the name '" + model->name + "' has '::' in it, which stands between names");
  } else if (!sim::isSound(model->X_ParentModel)) {
    diagnostics.error(position, "the pose of '" + model->name + "' is not finite");
  }
  if (diagnostics.hasErrors()) return std::nullopt;
  model->X_ParentModel.rotation.normalize();

  world::Slot slot = world::kNoSlot;
  try {
    slot = editor.insert(std::move(model));
  } catch (const std::invalid_argument& error) {
    diagnostics.error(position, error.what());
    return std::nullopt;
  }
  const Model inserted(access, entities.models()[slot].id);
  if (systems) systems->load(slot, diagnostics);
  if (diagnostics.hasErrors()) {
    systems->unload(editor.remove(slot));
    access.hasChanged = false;
    return std::nullopt;
  }
  announceChanges();
  return inserted;
}

template <class Read>
std::optional<Model> Simulation::Parts::insertRead(Read read, const InsertOptions& options, Diagnostics& diagnostics) {
  // of their own: what was wrong before is no reason not to insert
  Diagnostics found;
  std::optional<Model> model = insert(read(found, assets::finderIn(places)), options, found);
  for (const Diagnostic& diagnostic : found.all()) diagnostics.add(diagnostic);
  return model;
}

std::unique_ptr<Simulation> Simulation::fromFile(const std::filesystem::path& file, const SimulationOptions& options,
                                                 Diagnostics& diagnostics) {
  return Parts::make(sdf::loadFile(file, diagnostics), options, diagnostics);
}

std::unique_ptr<Simulation> Simulation::fromText(std::string_view text, std::string_view name,
                                                 const SimulationOptions& options, Diagnostics& diagnostics) {
  return Parts::make(sdf::loadText(text, name, diagnostics), options, diagnostics);
}

Simulation::Simulation(std::unique_ptr<Parts> parts) : parts_(std::move(parts)) {}

Simulation::~Simulation() = default;

void Simulation::step(std::uint64_t count) {
  for (std::uint64_t i = 0; i < count; ++i) {
    parts_->transport->dispatch();
    advance(stepSize());
  }
}

void Simulation::stepPaused() {
  parts_->transport->dispatch();
  advance(Time::zero());
}

void Simulation::Parts::stepEngine(Time dt) {
  engine.step(dt, state);
  const world::Slot link = engine.slowedDown();
  if (link == world::kNoSlot || !slowedDown.insert(entities.links()[link].id).second) return;
  const world::LinkRecord& record = entities.links()[link];
  Logger("physics").warning(
      "link '" + entities.models()[record.model].scopedName + "::" + record.description->name +
      "' would turn more than once in a step and is slowed down to that (a shorter step may help)");
}

void Simulation::advance(Time dt) {
  Parts& parts = *parts_;
  const StepInfo info = parts.nextStep(dt);
  if (parts.systems) {
    parts.systems->preUpdate(info);
    parts.systems->update(info);
  }
  if (!info.paused) {
    if (!parts.systems || parts.systems->wantsPhysics()) parts.stepEngine(info.dt);
    parts.state.time = info.time;
    parts.state.iterations = info.iteration;
  }
  if (parts.systems) parts.systems->postUpdate(info);
}

Time Simulation::time() const { return parts_->state.time; }

std::uint64_t Simulation::iterations() const { return parts_->state.iterations; }

Time Simulation::stepSize() const { return parts_->state.stepSize; }

double Simulation::realTimeFactor() const { return parts_->state.realTimeFactor; }

std::optional<Model> Simulation::insertFile(const std::filesystem::path& file, const InsertOptions& options,
                                            Diagnostics& diagnostics) {
  return parts_->insertRead(
      [&](Diagnostics& found, const assets::Finder& finder) { return sdf::loadFile(file, found, finder); }, options,
      diagnostics);
}

std::optional<Model> Simulation::insertText(std::string_view text, std::string_view name, const InsertOptions& options,
                                            Diagnostics& diagnostics) {
  return parts_->insertRead(
      [&](Diagnostics& found, const assets::Finder& finder) { return sdf::loadText(text, name, found, finder); },
      options, diagnostics);
}

std::optional<Model> Simulation::insertCopy(const Model& model, const InsertOptions& options,
                                            Diagnostics& diagnostics) {
  const world::Slot slot = parts_->entities.slot(model.id());
  if (slot == world::kNoSlot || parts_->entities.models()[slot].parent != world::kNoSlot) {
    diagnostics.error({}, slot == world::kNoSlot ? "the model is not there any more"
                                                 : "model '" + model.scopedName() + "' is a part of another one");
    return std::nullopt;
  }
  auto copy = std::make_shared<description::Model>(*parts_->entities.models()[slot].description);
  copy->X_ParentModel = model.pose();
  Diagnostics found;
  std::optional<Model> inserted = parts_->insert(std::move(copy), options, found);
  for (const Diagnostic& diagnostic : found.all()) diagnostics.add(diagnostic);
  return inserted;
}

Outcome<std::string> Simulation::insertLight(const Message& light, const InsertOptions& options) {
  Outcome<std::string> name = sim::insertLight(parts_->access, light, options);
  parts_->announceChanges();
  return name;
}

std::optional<std::string> Simulation::changeLight(const Message& light) {
  const std::optional<std::string> refusal = sim::changeLight(parts_->access, light);
  parts_->announceChanges();
  return refusal;
}

std::optional<std::string> Simulation::removeLight(LightId id, const std::string& name) {
  const std::optional<std::string> refusal = sim::removeLight(parts_->access, id.value, name);
  parts_->announceChanges();
  return refusal;
}

std::optional<std::string> Simulation::addResourceFolder(const std::filesystem::path& folder) {
  std::error_code error;
  const std::filesystem::path whole = std::filesystem::absolute(folder, error);
  if (folder.empty() || error || !std::filesystem::is_directory(whole, error)) {
    return "'" + folder.string() + "' is no folder";
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

std::optional<std::string> Simulation::remove(const Model& model) {
  const world::Slot slot = parts_->entities.slot(model.id());
  if (slot == world::kNoSlot) return "the model is not there any more";
  const world::ModelRecord& record = parts_->entities.models()[slot];
  if (record.parent != world::kNoSlot) {
    return "model '" + record.scopedName + "' is a part of '" + parts_->entities.models()[record.parent].scopedName +
           "' and can't be removed alone";
  }
  const std::vector<ModelId> gone = sim::Editor(parts_->access).remove(slot);
  if (parts_->systems) parts_->systems->unload(gone);
  parts_->announceChanges();
  return std::nullopt;
}

std::optional<std::string> Simulation::setStepSize(Time size) {
  if (size <= Time::zero() || size > kLongestStep) return "a step must be longer than zero and at most a second";
  parts_->state.stepSize = size;
  return std::nullopt;
}

std::optional<std::string> Simulation::setRealTimeFactor(double factor) {
  if (!(factor >= 0) || !std::isfinite(factor)) return "a real-time factor must be a number from zero up";
  parts_->state.realTimeFactor = factor;
  return std::nullopt;
}

void Simulation::reset(Diagnostics& diagnostics, std::optional<std::uint64_t> seed) {
  sim::Editor(parts_->access).reset();
  if (parts_->systems) parts_->systems->reset(diagnostics, seed);
}

std::vector<std::byte> Simulation::saveState() { return sim::saveState(parts_->access, parts_->systemSet()); }

std::optional<std::string> Simulation::restoreState(std::span<const std::byte> state) {
  return sim::restoreState(state, parts_->access, parts_->systemSet());
}

World Simulation::world() { return World(parts_->access); }

std::uint64_t Simulation::stateHash() const { return world::stateHash(parts_->state); }

Transport& Simulation::transport() { return *parts_->transport; }

}  // namespace pongsim
