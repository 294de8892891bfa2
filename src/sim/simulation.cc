#include "pongsim/simulation.hh"

#include <algorithm>
#include <iterator>
#include <optional>
#include <string_view>
#include <utility>
#include <vector>

#include "description/world.hh"
#include "physics/engine.hh"
#include "sdf/loader.hh"
#include "sim/access.hh"
#include "sim/system_set.hh"
#include "world/entities.hh"
#include "world/state.hh"

namespace pongsim {

struct Simulation::Parts {
  Parts(description::World world, const SimulationOptions& options)
      : description(std::move(world)),
        entities(description),
        state(entities),
        engine(entities),
        access{entities, state, engine} {
    if (options.transport == nullptr) ownTransport.emplace(TransportOptions{.network = false, .domain = {}});
    transport = options.transport != nullptr ? options.transport : &*ownTransport;
  }

  /// @return The simulation of the file's first world; null, with the reason in `diagnostics`, if it can't run.
  static std::unique_ptr<Simulation> make(sdf::Root root, const SimulationOptions& options, Diagnostics& diagnostics);

  StepInfo nextStep(Time dt) const {
    const bool paused = dt == Time::zero();
    return {state.time + dt, dt, state.iterations + (paused ? 0 : 1), paused};
  }

  const description::World description;
  world::Entities entities;
  world::State state;
  physics::Engine engine;
  sim::Access access;
  std::optional<Transport> ownTransport;
  Transport* transport = nullptr;
  std::optional<sim::SystemSet> systems;
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
    parts->systems.emplace(parts->access, *parts->transport, options.seed);
    parts->systems->load(parts->description, diagnostics);
    if (diagnostics.hasErrors()) return nullptr;
  }
  return std::unique_ptr<Simulation>(new Simulation(std::move(parts)));
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

void Simulation::advance(Time dt) {
  Parts& parts = *parts_;
  const StepInfo info = parts.nextStep(dt);
  if (parts.systems) {
    parts.systems->preUpdate(info);
    parts.systems->update(info);
  }
  if (!info.paused) {
    if (!parts.systems || parts.systems->wantsPhysics()) parts.engine.step(info.dt, parts.state);
    parts.state.time = info.time;
    parts.state.iterations = info.iteration;
  }
  if (parts.systems) parts.systems->postUpdate(info);
}

Time Simulation::time() const { return parts_->state.time; }

std::uint64_t Simulation::iterations() const { return parts_->state.iterations; }

Time Simulation::stepSize() const { return parts_->description.physics.maxStepSize; }

double Simulation::realTimeFactor() const { return parts_->description.physics.realTimeFactor; }

World Simulation::world() { return World(parts_->access); }

std::uint64_t Simulation::stateHash() const { return world::stateHash(parts_->state); }

Transport& Simulation::transport() { return *parts_->transport; }

}  // namespace pongsim
