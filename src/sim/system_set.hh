#pragma once

#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <list>
#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <unordered_map>
#include <vector>

#include "assets/places.hh"
#include "base/hash.hh"
#include "description/plugin.hh"
#include "plugin/loader.hh"
#include "pongsim/diagnostic.hh"
#include "pongsim/simulation.hh"
#include "pongsim/system.hh"
#include "sim/api/access.hh"
#include "sim/edits/edit_queue.hh"
#include "sim/running/world_place.hh"
#include "sim/system_slot.hh"

namespace pongsim::sim {

/// The systems of a world, called in phases.
class SystemSet {
 public:
  /// All references must outlive this.
  /// @param edits Carries out requests of systems.
  /// @param strict Whether a failing system ends the step with an exception instead of being switched off.
  /// @param place Each world of a file has its own random streams; worlds that run at once are named in log messages.
  SystemSet(Access& access, ModelEdits& edits, Transport& transport, std::uint64_t seed, bool strict,
            const WorldPlace& place);
  ~SystemSet();
  SystemSet(const SystemSet&) = delete;
  SystemSet& operator=(const SystemSet&) = delete;

  /// Makes and configures the world's systems: its own plugins in the order of the file, then each model's. A world
  /// without systems gets the default ones of Fortress's server. A plugin that is not found, or has invalid parameters,
  /// is left out with a warning, as in Fortress, and the rest of the world runs. A system of sensors that stands in a
  /// model, since a URDF has no world, is one of the world, unless the world has it already.
  /// @param isConfigured A server config file sets the systems: there are no default ones.
  /// @param options Additional systems, and whether a missing physics system matters.
  void load(const description::World& world, bool isConfigured, const SimulationOptions& options,
            Diagnostics& diagnostics);

  /// Configures a system of the program, after all others.
  /// @param name Unique among added systems.
  /// @return Whether it can be used; otherwise `diagnostics` has the reason.
  bool add(std::string name, std::unique_ptr<System> system, Diagnostics& diagnostics);

  /// @return Whether bodies move: the world lists the physics system, or no system.
  bool wantsPhysics() const { return wantsPhysics_; }

  /// Like `Simulation::readings`.
  std::vector<SensorReadings> readings(std::string_view sensorType) const;

  /// Makes and configures the systems of an inserted model and of its nested models.
  void load(world::Slot model, bool isFromOutside, Diagnostics& diagnostics);

  /// Ends the systems of removed models.
  void unload(const std::vector<ModelId>& models);

  /// Stops calling systems of models that are set aside, and resumes those of returned models.
  void updateWhoRests();

  /// Notifies the systems if the world has changed since the last call.
  void announceChanges();

  /// Resets the systems after the world. Systems of models that have returned are made and configured again, those of
  /// removed models end, and those switched off are switched on.
  /// @param seed New seed; unset: the same.
  void reset(Diagnostics& diagnostics, std::optional<std::uint64_t> seed);

  /// Notifies the systems that the time was set, by `reset`.
  void jump();

  /// Lets all complete what they write; like `Simulation::finish`.
  Outcome<void> finish();

  /// @return The state of each system with its random stream.
  std::vector<std::string> save();
  /// Restores that state.
  /// @throws std::runtime_error if it is not that of these systems; then some are restored.
  /// @param awakeOnly Skips systems that are set aside, whose entities do not exist now.
  void restore(const std::vector<std::string>& saved, bool awakeOnly);

  /// Adds the list of systems to a hash.
  void addTo(base::Hash& hash) const;

  /// @throws std::runtime_error (likewise below) if the set is strict and a system has failed.
  void preUpdate(const StepInfo& info);
  void update(const StepInfo& info);
  void postUpdate(const StepInfo& info);

 private:
  void lookAhead(std::size_t system) const;
  void loadWorldPlugins(const description::World& world, bool isConfigured, const SimulationOptions& options,
                        Diagnostics& diagnostics);
  /// Who wrote a `<plugin>`.
  struct Origin {
    /// Whether it may name the path of a library; not if it is from a server.
    plugin::Loader::Paths paths;
    /// As in `InsertOptions`.
    bool isFromOutside = false;
    /// Whether whoever started the run asks for it, beside the file.
    plugin::Loader::Need need = plugin::Loader::Need::kOptional;
  };
  void loadModelPlugins(world::Slot model, const Origin& origin, Diagnostics& diagnostics);
  void loadOwnPlugins(world::Slot model, const Origin& origin, Diagnostics& diagnostics);
  bool isFromServer(const std::shared_ptr<const std::string>& file);
  /// The parent of a `<plugin>`: a model, an actor, or if neither, the world.
  struct Holder {
    world::Slot model = world::kNoSlot;
    const world::ActorRecord* actor = nullptr;
  };
  void add(const description::Plugin& plugin, std::size_t number, const Holder& holder, Origin origin,
           Diagnostics& diagnostics);
  /// @return Whether there is a system of the world of this kind.
  bool hasOfWorld(const Declaration& declaration) const;
  /// Warns of plugins that were left out, and of sensors that no system simulates.
  /// @param sensors Where the new ones begin in the list of all.
  void warnOfMissing(std::size_t sensors, Diagnostics& diagnostics);
  /// @return Whether it can be used.
  bool start(SystemSlot::Parts parts, const std::optional<Model>& model, const std::optional<Actor>& actor,
             Diagnostics& diagnostics);
  void putInOrder();
  void collect();
  /// Takes out all that one says yes to.
  template <class Predicate>
  void end(Predicate predicate);
  void noteTopic(const SystemSlot& slot, const std::string& topic);
  void forgetTopics(const SystemSlot& slot);
  void warnOfSharedTopics(const SystemSlot& slot, Diagnostics& diagnostics) const;
  Random stream(const std::string& name) const;
  /// @return Text after a system's name in log messages.
  std::string where() const;
  void noteFailure(const SystemSlot& slot, const std::string& what);
  /// Ends the step if the set is strict and a system has failed.
  void check() const;

  Access& access_;
  Transport& transport_;
  std::uint64_t seed_;
  bool strict_;
  const WorldPlace place_;
  World world_;
  const description::Plugin defaultSceneBroadcaster_;
  bool wantsPhysics_ = true;
  /// Whether plugins of files are loaded, also those of models inserted later, and not only added systems.
  bool loadsPlugins_ = false;
  /// For the plugins of the world that the run starts with.
  plugin::Loader::Paths paths_ = plugin::Loader::Paths::kNeedLeave;
  /// Where files of Fuel servers are.
  const std::filesystem::path fuelCache_ = assets::Places::fromEnvironment().fuelCache;
  /// The last file that was asked about, and the answer: a file's plugins come one after the other.
  std::shared_ptr<const std::string> lastFile_;
  bool isLastFromServer_ = false;
  // The libraries must outlive the systems.
  plugin::Loader loader_;
  /// Models of the file whose systems have ended; both return with a reset.
  std::vector<ModelId> unloaded_;
  ModelId lastOfFile_;
  /// How many systems of the world came from models and actors.
  std::size_t brought_ = 0;
  std::optional<std::string> failure_;
  EditQueue queue_;
  /// By topic, those that advertise it.
  std::unordered_map<std::string, std::vector<const SystemSlot*>> publishers_;
  // Contexts point into the slots.
  std::list<SystemSlot> slots_;
  /// Theirs, in the same order.
  std::vector<System*> systems_;
  /// Those called in a step, in order.
  std::vector<SystemSlot*> awake_;
};

}  // namespace pongsim::sim
