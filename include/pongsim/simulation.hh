#pragma once

#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <variant>
#include <vector>

#include "pongsim/declaration.hh"
#include "pongsim/diagnostic.hh"
#include "pongsim/element.hh"
#include "pongsim/export.hh"
#include "pongsim/handles.hh"
#include "pongsim/insert_options.hh"
#include "pongsim/node.hh"
#include "pongsim/outcome.hh"
#include "pongsim/types.hh"

namespace pongsim {

class System;

namespace sim {
class Inside;
class Runner;
}  // namespace sim

struct SimulationOptions {
  /// Seed of all random numbers of the run.
  std::uint64_t seed = 0;
  /// Load the systems of the world's plugins; without them there are only bodies, joints and gravity.
  bool loadSystems = true;
  /// If a system throws or gives an invalid command, end the step with an exception that names it, instead of switching
  /// the system off.
  bool strict = false;
  /// Number of threads that move bodies, from 1. Groups of bodies that do not touch each other are distributed among
  /// them; the result has the same bits. Systems are always called on the thread that steps.
  int threads = 1;
  /// Load the models, lights and actors of `<level>`s only while a performer is near; otherwise they are always loaded.
  bool levels = false;
  /// Transport of the systems' topics; null: topics stay within this simulation. Must outlive it.
  Transport* transport = nullptr;
  /// Systems in addition to the world's, as `<plugin>` elements with parameters. A system that the world also lists
  /// exists once, and the parameters given here take precedence.
  std::vector<Element> systems = {};
  /// Name of the world in the file; empty: the first one.
  std::string world = {};
  /// Let physics move bodies. Without it they stay where systems put them (`StatePlayer`), whatever systems the world
  /// lists, and time may be set (`Simulation::setTime`).
  bool physics = true;
  /// Load libraries that the file's `<plugin>`s name by their paths, too, instead of only by names that are looked for
  /// in the folders of systems: whoever writes the file can then run any code. The environment variable
  /// PONGSIM_ALLOW_PLUGIN_PATHS=1 allows it as well. Never done for inserted models and for files of a Fuel server.
  bool allowPluginPaths = false;
  /// Load systems that connect the world with other programs or record it (`Declaration::standsOutside`).
  bool outsideSystems = true;
};

/// What a file had to insert: a model, or a light by its name.
using ModelOrLight = std::variant<Model, std::string>;

/// A world with its bodies and systems, loaded from a file. Use it on one thread at a time.
class PONGSIM_API Simulation {
 public:
  /// Loads a world file, or a file with a model, which gets a world with a ground plane and a sun. Errors and warnings
  /// are added to `diagnostics`. From a file with several worlds it loads one, with the same bits as when all run.
  /// @return Null on errors.
  static std::unique_ptr<Simulation> fromFile(const std::filesystem::path& file, const SimulationOptions& options,
                                              Diagnostics& diagnostics);
  /// Like `fromFile`, from text; `name` is used in messages.
  static std::unique_ptr<Simulation> fromText(std::string_view text, std::string_view name,
                                              const SimulationOptions& options, Diagnostics& diagnostics);
  /// Loads all worlds of a file in its order. If there are several, each shares the transport of the options
  /// (`Transport::Sharing`), so that each can be stepped on its own thread. `systems` applies to each; with several
  /// worlds, the `<plugin>` gets the attribute `beside_others="true"`, so that they avoid conflicts. `world` is
  /// ignored.
  /// @return Empty on errors, which are in `diagnostics`.
  static std::vector<std::unique_ptr<Simulation>> allFromFile(const std::filesystem::path& file,
                                                              const SimulationOptions& options,
                                                              Diagnostics& diagnostics);
  ~Simulation();
  Simulation(const Simulation&) = delete;
  Simulation& operator=(const Simulation&) = delete;

  /// Makes `count` steps: delivers received messages, calls the systems, moves the bodies.
  /// @throws std::runtime_error naming a failed system, if the options are strict.
  void step(std::uint64_t count = 1);

  /// Does a step without moving anything: delivers messages and calls the systems with `dt` zero.
  void stepPaused();

  /// @return Simulated time since the start.
  Time time() const;
  std::uint64_t iterations() const;
  /// @return Step size: `<max_step_size>` of the world unless changed.
  Time stepSize() const;
  /// @return The desired real-time factor: that of the world unless changed; 0: as fast as possible.
  double realTimeFactor() const;

  /// Lets the systems complete what they write, such as recordings. Call it after the last step: a destructor could not
  /// report that this failed. A second call does nothing new.
  /// @return What is incomplete, with the names of the systems.
  Outcome<void> finish();

  World world();

  /// @return What the world's systems publish of sensors of that type, the main readings first; empty if no system
  /// supports it. A reading's topic is that of the sensor: `Sensor::topic(readings)`.
  std::vector<SensorReadings> readings(std::string_view sensorType) const;

  /// Adds a system of the program, after all existing ones. It is declared and configured immediately, and called from
  /// the next step on. It survives a reset, and its state is part of saved states, which can only be restored with the
  /// same systems.
  /// @param name Unique among added systems; used in messages and for its random stream.
  /// @return Whether it can be used; otherwise `diagnostics` has the reason.
  bool addSystem(std::string name, std::unique_ptr<System> system, Diagnostics& diagnostics);

  /// Adds a system that only watches the world or serves others, such as a web server, after all existing ones. It
  /// survives a reset, but is not part of saved states: those of before can be restored.
  /// @param plugin Its `<plugin>`, which names it and has its parameters.
  /// @return Whether it can be used; otherwise `diagnostics` has the reason.
  bool addWatcher(const Element& plugin, Diagnostics& diagnostics);

  /// Offers the services that change the world (`/world/W/create`, `remove`, `set_pose` and so on) and resource paths
  /// (`/gazebo/resource_paths/...`) on `transport()`, as `pongsim run` does, as long as this exists. Requests are
  /// handled when messages are delivered.
  /// @throws std::invalid_argument if another simulation, or a run, offers them there.
  void offerEdits();

  // The following functions change the world between two steps. A refused change has no effect.

  /// Inserts the first model of a file, or of a model folder (with `model.config`), with the systems of its plugins, at
  /// its own pose or that of `options`. Errors and warnings are added to `diagnostics`.
  /// @return The model; nothing on errors.
  std::optional<Model> insertFile(const std::filesystem::path& file, const InsertOptions& options,
                                  Diagnostics& diagnostics);
  /// Like `insertFile`, from text; `name` is used in messages.
  std::optional<Model> insertText(std::string_view text, std::string_view name, const InsertOptions& options,
                                  Diagnostics& diagnostics);

  /// Like `insertFile` and `insertText`, but a file without models may have lights, of which the first is inserted.
  std::optional<ModelOrLight> insertModelOrLight(const std::filesystem::path& file, const InsertOptions& options,
                                                 Diagnostics& diagnostics);
  std::optional<ModelOrLight> insertModelOrLight(std::string_view text, std::string_view name,
                                                 const InsertOptions& options, Diagnostics& diagnostics);

  /// Inserts a copy of a top-level model as it was inserted, with its own systems, at the model's current pose or that
  /// of `options`. It needs another name, or `allowRenaming`.
  std::optional<Model> insertCopy(const Model& model, const InsertOptions& options, Diagnostics& diagnostics);

  /// Removes a top-level model with all its parts, its systems, and joints connected to it. Handles to them throw
  /// `Gone` afterwards.
  Outcome<void> remove(const Model& model);
  /// Removes several models or, if one can't be removed, none. Faster than one by one, which moves the state of all
  /// later models each time.
  Outcome<void> remove(std::span<const Model> models);

  /// Adds a light to the world.
  /// @param light An ignition.msgs.Light.
  /// @return Its name, or why it was refused.
  Outcome<std::string> insertLight(const Message& light, const InsertOptions& options);
  /// Changes a light. Colours, direction and position that are not in the message stay, and so does the rotation; other
  /// missing values become 0 or false, since the message can't distinguish them.
  /// @param light An ignition.msgs.Light that identifies it by `id`, or by `name` with the `parent_id` of its link, of
  /// the world, or 0.
  Outcome<void> changeLight(const Message& light);
  /// Removes a light of the world.
  /// @param id 0: use the name.
  Outcome<void> removeLight(LightId id, const std::string& name);

  /// Makes a top-level model a performer, with a box of 2 m around its origin: levels are loaded around it. A model
  /// that does not exist yet, or is in an unloaded level, becomes a performer when it is added or loaded.
  Outcome<void> addPerformer(const std::string& model);

  /// @return Whether there is a model with that name in an unloaded level.
  bool isSetAside(const std::string& model) const;
  /// @return The number of such top-level models.
  std::size_t countSetAside() const;

  /// @param size Above zero, up to `kLongestStep`.
  Outcome<void> setStepSize(Time size);

  /// @param factor Simulated seconds per second; 0: as fast as possible.
  Outcome<void> setRealTimeFactor(double factor);

  /// Resets the world to its start: time zero, and state, step size, gravity and random numbers with the same bits.
  /// Inserted models and added joints are removed; removed models return with their systems, whose errors are added to
  /// `diagnostics`. The other systems' `reset` is called. Messages and requests of systems that wait are dropped
  /// (`Transport::discard`).
  /// @param seed New seed, like `SimulationOptions::seed`. Unset: the same seed.
  void reset(Diagnostics& diagnostics, std::optional<std::uint64_t> seed = std::nullopt);

  /// @return Whether physics moves bodies: neither the world's systems nor `SimulationOptions::physics` leave it out.
  bool hasPhysics() const;

  /// Sets the simulated time, forwards or backwards, in a world without physics. The systems' `reset` is called; a
  /// system that plays a recording moves everything to its state at that time in the next step, even while paused.
  /// @param time Zero or more.
  Outcome<void> setTime(Time time);

  /// @return Everything that the next steps depend on: time, poses, velocities, joints and their drives, contact points
  /// with their forces, step size, gravity, random streams, and the state of systems that save it (`System::transfer`).
  /// Messages in transit are not included.
  std::vector<std::byte> saveState();

  /// Restores a saved state, from which the world continues with the same bits. It must be the same world with the same
  /// seed, models, systems and joints; otherwise it is refused. So is a damaged or forged state, as far as its values
  /// show it. Messages and requests of systems that wait are dropped, as in `reset`.
  Outcome<void> restoreState(std::span<const std::byte> state);

  static constexpr Time kLongestStep = std::chrono::seconds(1);

  /// Adds a folder to search for inserted models and their files, after the existing ones. Only for this simulation.
  /// (It does not become one that models from outside may read: `InsertOptions::isFromOutside`.)
  Outcome<void> addResourceFolder(const std::filesystem::path& folder);
  /// @return The folders that are searched, in this order.
  std::vector<std::filesystem::path> resourceFolders() const;
  /// @return Whether what comes from outside may read this file or folder: see `InsertOptions::isFromOutside`.
  bool isInReach(const std::filesystem::path& path) const;
  /// @return The file or folder of an address such as "model://box"; nothing if it was not found.
  std::optional<std::filesystem::path> resolve(const std::string& address) const;

  /// @return A hash of all bits of the state (time, poses, velocities, joints): equal for two runs of the same world
  /// with the same seed and inputs, and in practice different for different states.
  std::uint64_t stateHash() const;

  /// The transport of the systems' topics: that of the options, or the simulation's own.
  Transport& transport();

 private:
  friend class sim::Inside;
  friend class sim::Runner;
  struct Parts;

  /// One step of that length, after messages were delivered; zero: nothing moves.
  void advance(Time dt);

  explicit Simulation(std::unique_ptr<Parts> parts);
  std::unique_ptr<Parts> parts_;
};

}  // namespace pongsim
