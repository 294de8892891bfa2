#pragma once

#include <array>
#include <cstdint>
#include <memory>
#include <vector>

#include "pongsim/export.hh"
#include "pongsim/message.hh"
#include "pongsim/scene.hh"
#include "pongsim/types.hh"

namespace pongsim {

/// Poses and joint positions of everything that moves in a world at one time. Plain values, which any thread may read.
struct StateSnapshot {
  /// A model or a link.
  struct Place {
    std::uint64_t entity = 0;
    /// In the frame of its parent: the world or a model; for a link, its model.
    Pose X_ParentEntity;
  };
  struct Axes {
    std::uint64_t joint = 0;
    int count = 0;
    /// [rad] or [m]
    std::array<double, 2> positions{};
  };
  Time time{0};
  /// Top-level models and everything that is not static, in the order of the world.
  std::vector<Place> places;
  /// Joints with axes.
  std::vector<Axes> joints;
  /// All entities with all components, an ignition.msgs.SerializedStepMap; only in the first snapshot, and if entities
  /// were added, removed or changed since the previous one. Otherwise null.
  std::shared_ptr<const Message> everything;
};

/// Takes snapshots of a world, on its simulation's thread. Must not outlive the `Simulation`.
class PONGSIM_API StateWatch {
 public:
  explicit StateWatch(const Scene& scene) : access_(scene.access_) {}

  /// @return Whether the next snapshot has everything: it is the first, or entities were added or removed.
  bool hasNews() const;

  /// Replaces a snapshot by the current state. Copies what moves; does not allocate if `snapshot` was used before and
  /// no entities were added or removed.
  void take(StateSnapshot& snapshot);

 private:
  sim::Access* access_;
  std::uint64_t changes_ = 0;
  bool hasTaken_ = false;
};

/// Builds messages from snapshots as in Fortress's logs: everything from the first one, then changes. Use it on one
/// thread at a time, which need not be the simulation's.
class PONGSIM_API StateChanges {
 public:
  StateChanges();
  ~StateChanges();
  StateChanges(const StateChanges&) = delete;
  StateChanges& operator=(const StateChanges&) = delete;

  /// Replaces an ignition.msgs.SerializedStateMap by the changes since the previous snapshot: new entities with all
  /// components, changed components, and removed entities with `remove` set. Poses are rounded to a micrometre and a
  /// microradian, as in Fortress's logs, and compared after rounding.
  /// @return Whether there are changes.
  bool tell(const StateSnapshot& snapshot, Message& stateMap);

 private:
  struct Told;
  std::unique_ptr<Told> told_;
};

}  // namespace pongsim
