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

/// Where all that moves in a world stood at one time. Plain values: any thread may read them later.
struct StateSnapshot {
  /// A model or a link.
  struct Place {
    std::uint64_t entity = 0;
    /// In the frame of what holds it: the world or a model, of a link its model.
    Pose X_ParentEntity;
  };
  struct Axes {
    std::uint64_t joint = 0;
    int count = 0;
    /// [rad] or [m]
    std::array<double, 2> positions{};
  };
  Time time{0};
  /// Models of the top level, and what is not static, in the order of the world.
  std::vector<Place> places;
  /// Joints that have axes.
  std::vector<Axes> joints;
  /// All entities with all their components, an ignition.msgs.SerializedStepMap, in the first snapshot and where
  /// somebody has come, gone or become another since the one before; else null.
  std::shared_ptr<const Message> everything;
};

/// Takes snapshots of a world, on its simulation's thread. It must not outlive the `Simulation`.
class PONGSIM_API StateWatch {
 public:
  explicit StateWatch(const Scene& scene) : access_(scene.access_) {}

  /// @return Whether the next snapshot has everything: none was taken yet, or somebody has come or gone since.
  bool hasNews() const;

  /// Replaces a snapshot by what is now. Copies what moves; allocates nothing where `snapshot` was filled before and
  /// nobody has come or gone.
  void take(StateSnapshot& snapshot);

 private:
  sim::Access* access_;
  std::uint64_t changes_ = 0;
  bool hasTaken_ = false;
};

/// Tells of snapshots as Fortress's logs do: of the first all, then what has changed. For one thread at a time, which
/// need not be that of the simulation.
class PONGSIM_API StateChanges {
 public:
  StateChanges();
  ~StateChanges();
  StateChanges(const StateChanges&) = delete;
  StateChanges& operator=(const StateChanges&) = delete;

  /// Replaces an ignition.msgs.SerializedStateMap by what differs from the snapshot before: entities that are new with
  /// all their components, components that have changed, and entities that have gone, with `remove` set. Poses are
  /// rounded to a micrometre and a microradian, as in Fortress's logs; one that stays the same by that has not changed.
  /// @return Whether anything is in it.
  bool tell(const StateSnapshot& snapshot, Message& stateMap);

 private:
  struct Told;
  std::unique_ptr<Told> told_;
};

}  // namespace pongsim
