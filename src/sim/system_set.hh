#pragma once

#include <cstddef>
#include <cstdint>
#include <list>
#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "base/hash.hh"
#include "description/plugin.hh"
#include "plugin/loader.hh"
#include "pongsim/diagnostic.hh"
#include "pongsim/simulation.hh"
#include "pongsim/system.hh"
#include "sim/access.hh"
#include "sim/edit_queue.hh"
#include "sim/system_slot.hh"
#include "sim/world_place.hh"

namespace pongsim::sim {

/// The systems of a world, and their phases.
class SystemSet {
 public:
  /// All references must outlive it.
  /// @param edits Carries out what systems ask for.
  /// @param strict A system that fails ends the step with an exception, in place of being switched off.
  /// @param place Worlds of a file have random streams of their own, and those that run beside others are named where
  /// systems speak.
  SystemSet(Access& access, ModelEdits& edits, Transport& transport, std::uint64_t seed, bool strict,
            const WorldPlace& place);
  ~SystemSet();
  SystemSet(const SystemSet&) = delete;
  SystemSet& operator=(const SystemSet&) = delete;

  /// Makes and configures the systems that the world asks for: its own plugins in the order of the file, then each
  /// model's. A world that lists none gets those that Fortress's servers have by default. A system that can't use its
  /// parameters is left out with a warning, as in Fortress, and the rest of the world runs.
  /// @param isConfigured A server config file says which there are: none are there by default.
  /// @param options Which systems there are beside them, and whether it matters that the world lists no physics.
  void load(const description::World& world, bool isConfigured, const SimulationOptions& options,
            Diagnostics& diagnostics);

  /// Configures a system of the program's own, behind all others.
  /// @param name No other added system may have it.
  /// @return Whether it can be used; else `diagnostics` says why not.
  bool add(std::string name, std::unique_ptr<System> system, Diagnostics& diagnostics);

  /// @return Whether the world's bodies are to be moved: the world lists the physics system, or lists no system.
  bool wantsPhysics() const { return wantsPhysics_; }

  /// Makes and configures the systems of a model that was inserted, and of those nested in it.
  void load(world::Slot model, Diagnostics& diagnostics);

  /// Ends the systems of models that have gone.
  void unload(const std::vector<ModelId>& models);

  /// Lets the systems of models that are set aside rest, and those of models that are back be called again.
  void updateWhoRests();

  /// Tells the systems that the world has changed, if it has since they were told.
  void announceChanges();

  /// Sets the systems back, after the world was. Those of models that have come back are made and configured anew,
  /// those of models that have gone end, those that are switched off are switched on.
  /// @param seed In place of the one of before.
  void reset(Diagnostics& diagnostics, std::optional<std::uint64_t> seed);

  /// Tells the systems that time has been set: their `reset` is called.
  void jump();

  /// @return What the systems remember, with their random streams, one after the other.
  std::vector<std::string> save();
  /// Gives that back.
  /// @param awakeOnly Not to those that rest: they can't be, where they look for what is set aside with them.
  void restore(const std::vector<std::string>& saved, bool awakeOnly);

  /// Adds which systems there are.
  void addTo(base::Hash& hash) const;

  /// @throws std::runtime_error, as the others, where systems must not fail and one has.
  void preUpdate(const StepInfo& info);
  void update(const StepInfo& info);
  void postUpdate(const StepInfo& info);

 private:
  void loadWorldPlugins(const description::World& world, bool isConfigured, const SimulationOptions& options,
                        Diagnostics& diagnostics);
  void loadModelPlugins(world::Slot model, Diagnostics& diagnostics);
  void loadOwnPlugins(world::Slot model, Diagnostics& diagnostics);
  /// What a `<plugin>` stands in: a model, an actor, or where it is neither the world.
  struct Holder {
    world::Slot model = world::kNoSlot;
    const world::ActorRecord* actor = nullptr;
  };
  void add(const description::Plugin& plugin, std::size_t number, const Holder& holder, Diagnostics& diagnostics);
  /// @return Whether it can be used.
  bool start(SystemSlot::Parts parts, const Element& plugin, const std::optional<Model>& model,
             const std::optional<Actor>& actor, Diagnostics& diagnostics);
  void putInOrder();
  void collectAwake();
  void warnOfSharedTopics(const SystemSlot& slot, Diagnostics& diagnostics) const;
  Random stream(const std::string& name) const;
  /// @return What stands behind the name of a system where it speaks.
  std::string where() const;
  void noteFailure(const SystemSlot& slot, const std::string& what);
  /// Ends the step where a system must not have failed.
  void check() const;

  Access& access_;
  Transport& transport_;
  std::uint64_t seed_;
  bool strict_;
  const WorldPlace place_;
  World world_;
  const description::Plugin defaultSceneBroadcaster_;
  bool wantsPhysics_ = true;
  /// Whether the plugins of files count, and those of models that come while it runs, and not added systems alone.
  bool loadsPlugins_ = false;
  // The libraries must be there until the systems are gone.
  plugin::Loader loader_;
  /// Models whose systems have ended: they come back with them.
  std::vector<ModelId> unloaded_;
  std::optional<std::string> failure_;
  EditQueue queue_;
  // Contexts point into the slots.
  std::list<SystemSlot> slots_;
  /// Those that are called in a step, in their order.
  std::vector<SystemSlot*> awake_;
};

}  // namespace pongsim::sim
