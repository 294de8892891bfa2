#pragma once

#include <cstdint>
#include <exception>
#include <list>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "base/hash.hh"
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

  /// Makes and configures the systems of a model that was inserted, and of those nested in it.
  void load(world::Slot model, Diagnostics& diagnostics);

  /// Ends the systems of models that have gone.
  void unload(const std::vector<ModelId>& models);

  /// Tells the systems that the world has changed, if it has since they were told.
  void announceChanges();

  /// Sets the systems back, after the world was. Those of models that have come back are made and configured anew,
  /// those of models that have gone end.
  void reset(Diagnostics& diagnostics);

  /// What the systems remember, with their random streams.
  void transfer(StateArchive& archive);

  /// Adds which systems there are.
  void addTo(base::Hash& hash) const;

  void preUpdate(const StepInfo& info);
  void update(const StepInfo& info);
  void postUpdate(const StepInfo& info);

 private:
  /// A system with what its context refers to.
  struct Slot {
    /// 0 for a system of the world.
    ModelId model;
    /// Which plugin of the model or of the world.
    std::size_t number;
    std::string stream;
    Logger log;
    Random random;
    Node node;
    std::unique_ptr<System> system;
    /// It has used a handle to what is gone, and is not called until the next reset.
    bool rests = false;
  };

  void loadWorldPlugins(const description::World& world, Diagnostics& diagnostics);
  void loadModelPlugins(world::Slot model, Diagnostics& diagnostics);
  void loadOwnPlugins(world::Slot model, Diagnostics& diagnostics);
  void add(const description::Plugin& plugin, std::size_t number, std::optional<world::Slot> model,
           Diagnostics& diagnostics);
  void putInOrder();
  static void rest(Slot& slot, const std::exception& reason);
  template <class Call>
  void forEach(Call call);

  Access& access_;
  Transport& transport_;
  std::uint64_t seed_;
  World world_;
  const description::Plugin defaultSceneBroadcaster_;
  bool wantsPhysics_ = true;
  // The libraries must be there until the systems are gone.
  plugin::Loader loader_;
  /// Models whose systems have ended: they come back with them.
  std::vector<ModelId> unloaded_;
  // Contexts point into the slots.
  std::list<Slot> slots_;
};

}  // namespace pongsim::sim
