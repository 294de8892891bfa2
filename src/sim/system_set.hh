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
  /// @param strict Whether a failing system ends the step by an exception, instead of being switched off.
  /// @param place Each world of a file has its own random streams; log messages name the world if several run at once.
  SystemSet(Access& access, ModelEdits& edits, Transport& transport, std::uint64_t seed, bool strict,
            const WorldPlace& place);
  ~SystemSet();
  SystemSet(const SystemSet&) = delete;
  SystemSet& operator=(const SystemSet&) = delete;

  /// Makes and configures the world's systems: plugins of the world in the order of the file, then those of each model.
  /// A world without systems gets the default ones of Fortress's server. A plugin that is not found, or has invalid
  /// parameters, is left out with a warning, as in Fortress, and the rest of the world runs. A sensor system whose
  /// `<plugin>` is in a model, because a URDF has no world, becomes one of the world, unless the world already has it.
  /// @param isConfigured Whether a server config file sets the systems: then there are no default ones.
  /// @param options Additional systems, and whether to warn if the physics system is missing.
  void load(const description::World& world, bool isConfigured, const SimulationOptions& options,
            Diagnostics& diagnostics);

  /// Configures a system that the program adds, after all others.
  /// @param name Unique among added systems.
  /// @return Whether it can be used; otherwise `diagnostics` has the reason.
  bool add(std::string name, std::unique_ptr<System> system, Diagnostics& diagnostics);

  /// Configures a system that is not part of saved states, after all others.
  /// @return Whether it can be used; otherwise `diagnostics` has the reason.
  bool addWatcher(const Element& plugin, Diagnostics& diagnostics);

  /// @return Whether bodies move: the world lists the physics system, or no system.
  bool wantsPhysics() const { return wantsPhysics_; }

  /// Like `Simulation::readings`.
  std::vector<SensorReadings> readings(std::string_view sensorType) const;

  /// Makes and configures the systems of an inserted model and of its nested models.
  void load(world::Slot model, bool isFromOutside, Diagnostics& diagnostics);

  /// Ends the systems of removed models.
  void unload(const std::vector<ModelId>& models);

  /// Stops calling systems of models and actors that are set aside, and resumes those of returned ones.
  void updateWhoRests();

  /// Notifies the systems if the world has changed since the last call.
  void announceChanges();

  /// Resets the systems after the world. Systems of models that have returned are made and configured again, those of
  /// removed models end, and those switched off are switched on.
  /// @param seed New seed; unset: the same.
  void reset(Diagnostics& diagnostics, std::optional<std::uint64_t> seed);

  /// Forgets what belongs to the time before a saved state was restored: requests of systems, and a failure, after
  /// which a strict set could not go on.
  void forgetPast();

  /// Notifies the systems that the time was set, by `reset`.
  void jump();

  /// Lets all systems complete their files; see `Simulation::finish`.
  Outcome<void> finish();

  /// @return The state of each system with its random stream.
  std::vector<std::string> save();
  /// Restores that state.
  /// @throws std::runtime_error if it is not the state of these systems; some may have been restored by then.
  /// @param awakeOnly Skips systems that are set aside, because their entities do not exist now.
  void restore(const std::vector<std::string>& saved, bool awakeOnly);

  /// Adds the list of systems to a hash.
  void addTo(base::Hash& hash) const;

  /// @throws std::runtime_error if the set is strict and a system has failed. The same below.
  void preUpdate(const StepInfo& info);
  void update(const StepInfo& info);
  void postUpdate(const StepInfo& info);

 private:
  void lookAhead(std::size_t system) const;
  void loadWorldPlugins(const description::World& world, bool isConfigured, const SimulationOptions& options,
                        Diagnostics& diagnostics);
  /// The source of a `<plugin>`.
  struct Origin {
    /// Whether it may name a library by its path; not if it is from a server.
    plugin::Loader::Paths paths;
    /// As in `InsertOptions`.
    bool isFromOutside = false;
    /// Whether the options of the run ask for it, in addition to the file.
    plugin::Loader::Need need = plugin::Loader::Need::kOptional;
    bool isWatcher = false;
  };
  void loadModelPlugins(world::Slot model, const Origin& origin, Diagnostics& diagnostics);
  void loadOwnPlugins(world::Slot model, const Origin& origin, Diagnostics& diagnostics);
  bool isFromServer(const std::shared_ptr<const std::string>& file);
  /// The parent of a `<plugin>`: a model, a sensor or a visual in it, an actor, or if none of these, the world.
  struct Holder {
    world::Slot model = world::kNoSlot;
    const world::ActorRecord* actor = nullptr;
    /// "link::sensor"; empty: none.
    std::string sensor = {};
    bool isVisual = false;

    /// @return "<model>"
    std::string_view element() const;
  };
  void add(const description::Plugin& plugin, std::size_t number, const Holder& holder, Origin origin,
           Diagnostics& diagnostics);
  /// @return Number of world systems that came from `<plugin>`s of models and actors.
  std::size_t countFromModels() const;
  /// @return Whether the world already has such a system.
  bool hasOfWorld(const Declaration& declaration) const;
  /// Warns of plugins that were left out, and of sensors that no system simulates.
  /// @param sensors Index of the first new sensor.
  void warnOfMissing(std::size_t sensors, Diagnostics& diagnostics);
  /// Configures a system.
  /// @return Whether it can be used.
  bool start(SystemSlot::Parts parts, const std::optional<Model>& model, const std::optional<Actor>& actor,
             Diagnostics& diagnostics);
  void putInOrder();
  void collect();
  /// Removes all systems for which the predicate is true.
  template <class Predicate>
  void end(Predicate predicate);
  void noteTopic(const SystemSlot& slot, const std::string& topic);
  void forgetTopics(const SystemSlot& slot);
  void warnOfSharedTopics(const SystemSlot& slot, Diagnostics& diagnostics) const;
  Random stream(const std::string& name) const;
  /// @return The suffix of system names in log messages, such as " (world b)".
  std::string where() const;
  void noteFailure(const SystemSlot& slot, const std::string& what);
  /// @throws std::runtime_error if the set is strict and a system has failed.
  void check() const;

  Access& access_;
  Transport& transport_;
  std::uint64_t seed_;
  bool strict_;
  const WorldPlace place_;
  World world_;
  const description::Plugin defaultSceneBroadcaster_;
  bool wantsPhysics_ = true;
  /// Whether plugins of files are loaded, including those of models inserted later; otherwise there are only added
  /// systems.
  bool loadsPlugins_ = false;
  /// Whether systems are loaded that connect the world with other programs or record it.
  bool loadsOutsiders_ = true;
  /// Whether plugins of the initial world may name libraries by path.
  plugin::Loader::Paths paths_ = plugin::Loader::Paths::kNeedLeave;
  /// Folder of the Fuel cache, whose files are from servers.
  const std::filesystem::path fuelCache_ = assets::Places::fromEnvironment().fuelCache;
  /// The last file that was checked, and whether it is from a server: plugins of one file follow each other.
  std::shared_ptr<const std::string> lastFile_;
  bool isLastFromServer_ = false;
  // Declared before the systems: the libraries must be closed after the systems have been destroyed.
  plugin::Loader loader_;
  /// Removed models of the file, whose systems have ended with them; a reset makes both again.
  std::vector<ModelId> unloaded_;
  ModelId lastOfFile_;
  std::optional<std::string> failure_;
  EditQueue queue_;
  /// The systems that advertise each topic.
  std::unordered_map<std::string, std::vector<const SystemSlot*>> publishers_;
  // A list, because contexts refer to the slots.
  std::list<SystemSlot> slots_;
  /// The systems of `slots_`, in the same order.
  std::vector<System*> systems_;
  /// The slots that are called in a step, in order.
  std::vector<SystemSlot*> awake_;
};

}  // namespace pongsim::sim
