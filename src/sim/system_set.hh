#pragma once

#include <cstdint>
#include <list>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "description/plugin.hh"
#include "plugin/loader.hh"
#include "pongsim/diagnostic.hh"
#include "pongsim/system.hh"
#include "sim/access.hh"

namespace pongsim::sim {

/// The systems of a world, and their phases.
class SystemSet {
 public:
  /// All references must outlive it.
  SystemSet(Access& access, Transport& transport, std::uint64_t seed);
  ~SystemSet();
  SystemSet(const SystemSet&) = delete;
  SystemSet& operator=(const SystemSet&) = delete;

  /// Makes and configures the systems that the world asks for: its own plugins in the order of the file, then each
  /// model's. A world that lists none gets those that Fortress's servers have by default. A system that can't use its
  /// parameters is left out with a warning, as in Fortress, and the rest of the world runs.
  void load(const description::World& world, Diagnostics& diagnostics);

  /// @return Whether the world's bodies are to be moved: the world lists the physics system, or lists no system.
  bool wantsPhysics() const { return wantsPhysics_; }

  void preUpdate(const StepInfo& info);
  void update(const StepInfo& info);
  void postUpdate(const StepInfo& info);

 private:
  /// A system with what its context refers to.
  struct Slot {
    Logger log;
    Random random;
    Node node;
    std::unique_ptr<System> system;
  };

  void loadWorldPlugins(const description::World& world, Diagnostics& diagnostics);
  void loadModelPlugins(world::Slot model, Diagnostics& diagnostics);
  void add(const description::Plugin& plugin, std::optional<world::Slot> model, Diagnostics& diagnostics);

  Access& access_;
  Transport& transport_;
  std::uint64_t seed_;
  World world_;
  bool wantsPhysics_ = true;
  // The libraries must be there until the systems are gone.
  plugin::Loader loader_;
  // Contexts point into the slots.
  std::list<Slot> slots_;
};

}  // namespace pongsim::sim
