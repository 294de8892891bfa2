#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "pongsim/export.hh"
#include "pongsim/handles.hh"
#include "pongsim/types.hh"

namespace pongsim {

/// Many links of one world, for systems that read or push all of them in each step. They are looked up only when the
/// world has changed, while a handle is looked up at each call. Must not outlive its `Simulation`.
class PONGSIM_API LinkGroup {
 public:
  /// @param links Links of that world.
  LinkGroup(const World& world, std::span<const Link> links);

  std::size_t size() const { return ids_.size(); }

  /// @return Poses of the link frames in the world frame, in the order of the links; valid until the next call or step.
  /// @throws Gone if one of the links no longer exists.
  std::span<const Pose* const> poses();

  /// Copies the poses.
  /// @throws std::invalid_argument if the sizes differ; Gone as above.
  void copyPoses(std::span<Pose> X_WorldLinks);

  /// Like `Link::addWrench` for each link, in their order: forces at the origins of their frames and torques during the
  /// next step, in the world frame [N, N m].
  /// @throws std::invalid_argument if the sizes differ; Gone as above.
  void addWrenches(std::span<const Wrench> wrenches);

 private:
  void lookUp();

  sim::Access* access_;
  std::vector<LinkId> ids_;
  std::vector<std::size_t> slots_;
  std::vector<const Pose*> poses_;
  /// State of the world when they were looked up, and whether they ever were.
  std::uint64_t changes_ = 0;
  bool isKnown_ = false;
};

}  // namespace pongsim
