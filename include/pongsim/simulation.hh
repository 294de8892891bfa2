#pragma once

#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

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
class Runner;
}

struct SimulationOptions {
  /// Where all random numbers of the run come from.
  std::uint64_t seed = 0;
  /// Load the systems that the world's plugins ask for; without them there are bodies, joints and gravity only.
  bool loadSystems = true;
  /// A system that throws, or gives a command that makes no sense, ends the step with an exception that names it, in
  /// place of being switched off.
  bool strict = false;
  /// How many threads move the bodies, from 1 on. Groups of bodies that touch nothing of each other's are shared out
  /// among them; the result has the same bits. Systems are called on the thread that steps, whatever it says.
  int threads = 1;
  /// Load the models, lights and actors of `<level>`s only while a performer is near; otherwise they are always there.
  bool levels = false;
  /// Where the systems' topics go; null keeps them within this simulation. Must outlive it.
  Transport* transport = nullptr;
  /// Systems beside those that the world asks for, each a `<plugin>` element with its parameters. Where the world asks
  /// for one of them too, it is there once, and of what both say counts what stands here.
  std::vector<Element> systems = {};
  /// Which world of the file, by its name; empty: the first one.
  std::string world = {};
  /// Let physics move the bodies. Without it they stay where systems put them (`StatePlayer`), whatever the world
  /// lists, and time may be set (`Simulation::setTime`).
  bool physics = true;
};

/// One world, from its file, with its bodies and systems. Belongs to one thread at a time.
class PONGSIM_API Simulation {
 public:
  /// Loads a world file, or one with a model at its root, which gets a world with a ground plane and the sun. What is
  /// wrong with it is added to `diagnostics`. Of a file with several worlds it is one, with the same bits as it has
  /// beside the others.
  /// @return Null if there was an error.
  static std::unique_ptr<Simulation> fromFile(const std::filesystem::path& file, const SimulationOptions& options,
                                              Diagnostics& diagnostics);
  /// As `fromFile`, from text; `name` stands in the messages.
  static std::unique_ptr<Simulation> fromText(std::string_view text, std::string_view name,
                                              const SimulationOptions& options, Diagnostics& diagnostics);
  /// Loads all worlds of a file, in its order, with all that is wrong with any of them. Where there are several, each
  /// has a share of its own in the transport of the options (`Transport::Sharing`), so that each may be stepped by a
  /// thread of its own. `systems` counts for each; where there are several, the attribute `beside_others` of the
  /// `<plugin>` is `true` then, so that they keep out of each other's way. `world` counts for none.
  /// @return None if there was an error.
  static std::vector<std::unique_ptr<Simulation>> allFromFile(const std::filesystem::path& file,
                                                              const SimulationOptions& options,
                                                              Diagnostics& diagnostics);
  ~Simulation();
  Simulation(const Simulation&) = delete;
  Simulation& operator=(const Simulation&) = delete;

  /// Makes `count` steps: hands over the messages that have come, calls the systems, moves the bodies.
  /// @throws std::runtime_error naming a system that has failed, where the options say so.
  void step(std::uint64_t count = 1);

  /// Does what a step does but moves nothing: hands over the messages and calls the systems with `dt` zero.
  void stepPaused();

  /// @return Simulated time since the start.
  Time time() const;
  std::uint64_t iterations() const;
  /// @return Length of a step: `<max_step_size>` of the world unless it was changed.
  Time stepSize() const;
  /// @return Simulated seconds a second that the world asks for, unless that was changed; 0 means as many as possible.
  double realTimeFactor() const;

  World world();

  /// Adds a system of the program's own, as one of the world's, behind all that are there: it is declared and
  /// configured at once, and called from the next step on. It stays through a reset, and its memory is in a saved
  /// state, which can be restored only where the same systems are.
  /// @param name Names it in messages, and its random stream; no other added system may have it.
  /// @return Whether it can be used; else `diagnostics` says why not.
  bool addSystem(std::string name, std::unique_ptr<System> system, Diagnostics& diagnostics);

  /// Offers on `transport()`, for as long as this lives, the services that change the world (`/world/W/create`,
  /// `remove`, `set_pose` and so on) and tell where files are looked for (`/gazebo/resource_paths/...`), as `pongsim
  /// run` does. They are met when messages are handed over.
  /// @throws std::invalid_argument where another simulation, or a run, offers them there.
  void offerEdits();

  // What follows changes the world between two steps. What is refused changes nothing.

  /// Inserts the first model of a file, or of a model's folder, whose `model.config` names the file, with the systems
  /// that its plugins ask for, where its poses say or as `options` do. What is wrong is added to `diagnostics`.
  /// @return The model; nothing if there was an error.
  std::optional<Model> insertFile(const std::filesystem::path& file, const InsertOptions& options,
                                  Diagnostics& diagnostics);
  /// As `insertFile`, from text; `name` stands in the messages.
  std::optional<Model> insertText(std::string_view text, std::string_view name, const InsertOptions& options,
                                  Diagnostics& diagnostics);

  /// Inserts a copy of a model of the top level as it was when it came, with systems of its own, where the model is now
  /// or as `options` do. The name must be another one, or `allowRenaming` be set.
  std::optional<Model> insertCopy(const Model& model, const InsertOptions& options, Diagnostics& diagnostics);

  /// Removes a model of the top level with all that is in it, its systems, and the joints that hold on to it. Handles
  /// to all that throw `Gone` from then on.
  /// @return Why not, or nothing; likewise below.
  std::optional<std::string> remove(const Model& model);

  /// Adds a light of the world.
  /// @param light An ignition.msgs.Light that says how it is.
  /// @return Its name, or why not.
  Outcome<std::string> insertLight(const Message& light, const InsertOptions& options);
  /// Changes a light. Colours, direction and position that the message has not stay, as the rotation always does;
  /// single values that it leaves out become 0 or false, for it can't tell the one from the other.
  /// @param light An ignition.msgs.Light that names it, by `id`, or by `name` with the `parent_id` of its link or that
  /// of the world, or 0.
  std::optional<std::string> changeLight(const Message& light);
  /// Removes a light of the world.
  /// @param id 0: it is named by its name.
  std::optional<std::string> removeLight(LightId id, const std::string& name);

  /// Lets a model of the top level perform, with a box of 2 m around its origin: levels load where it is. One that is
  /// not there yet, or is set aside, performs from when it is.
  std::optional<std::string> addPerformer(const std::string& model);

  /// @return Whether there is a model of that name that is set aside with its level.
  bool isSetAside(const std::string& model) const;
  /// @return How many models of the top level are.
  std::size_t countSetAside() const;

  /// @param size Above zero and up to `kLongestStep`.
  std::optional<std::string> setStepSize(Time size);

  /// @param factor Simulated seconds a second; 0 means as many as possible.
  std::optional<std::string> setRealTimeFactor(double factor);

  /// Sets the world back to its start: time zero, every bit of the state, step size, gravity and random numbers as they
  /// were then. Models inserted and joints made since go, removed ones come back with their systems; the other systems'
  /// `reset` is called. What is wrong with the systems that come back is added to `diagnostics`.
  /// @param seed Where all random numbers come from then, as `SimulationOptions::seed`. Unset: from where they did.
  void reset(Diagnostics& diagnostics, std::optional<std::uint64_t> seed = std::nullopt);

  /// Goes to another simulated time, later or earlier, in a world whose physics rests: the systems' `reset` is called,
  /// and who plays a recording puts all where it has it at that time, in the next step, paused or not.
  /// @param time From zero on.
  /// @return Why not, or nothing.
  std::optional<std::string> setTime(Time time);

  /// @return All that the next steps depend on: time, poses, velocities, joints and what drives them, points of contact
  /// with their forces, step size, gravity, random streams, and what the systems remember, as far as they tell it
  /// (`System::transfer`). Messages on their way are not in it.
  std::vector<std::byte> saveState();

  /// Puts the world into a saved state, from which it goes on with the bits with which the saved one did. It must be
  /// the same world with the same seed, models, systems and joints; one that has been changed since is refused.
  std::optional<std::string> restoreState(std::span<const std::byte> state);

  static constexpr Time kLongestStep = std::chrono::seconds(1);

  /// Looks for what inserted models name in that folder, too, after those that were there before. It is for models of
  /// this simulation only.
  /// @return Why not, or nothing.
  std::optional<std::string> addResourceFolder(const std::filesystem::path& folder);
  /// @return Where it looks, in this order.
  std::vector<std::filesystem::path> resourceFolders() const;
  /// @return The file or folder that an address names, as "model://box"; nothing where there is none.
  std::optional<std::filesystem::path> resolve(const std::string& address) const;

  /// @return A number made of all bits of the state (time, poses, velocities, joints): equal for two runs of the
  /// same world with the same seed and inputs, different in practice for any two that differ.
  std::uint64_t stateHash() const;

  /// The transport of the systems' topics: the one of the options or the simulation's own.
  Transport& transport();

 private:
  friend class sim::Runner;
  struct Parts;

  /// One step of that length after the messages were handed over; none moves where it is zero.
  void advance(Time dt);

  explicit Simulation(std::unique_ptr<Parts> parts);
  std::unique_ptr<Parts> parts_;
};

}  // namespace pongsim
