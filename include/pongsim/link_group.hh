#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "pongsim/export.hh"
#include "pongsim/handles.hh"
#include "pongsim/types.hh"

namespace pongsim {

/// Many links of one world, for a system that reads where all of them are and pushes them in each step. They are looked
/// up when the world has changed, where a handle is at each call. It must not outlive its `Simulation`.
class PONGSIM_API LinkGroup {
 public:
  /// @param links All of that world.
  LinkGroup(const World& world, std::span<const Link> links);

  std::size_t size() const { return ids_.size(); }

  /// @return Pose of each link frame in the world frame, in the order of the links; to be read before the next call or
  /// step.
  /// @throws Gone where one of them is not there any more.
  std::span<const Pose* const> poses();

  /// As `Link::addWrench` for each of them, in their order: forces at the origins of their frames and torques during
  /// the next step, in the world frame [N, N m].
  /// @throws std::invalid_argument where there are not as many wrenches as links; Gone as above.
  void addWrenches(std::span<const Wrench> wrenches);

 private:
  void lookUp();

  sim::Access* access_;
  std::vector<LinkId> ids_;
  std::vector<std::size_t> slots_;
  std::vector<const Pose*> poses_;
  /// When they were looked up, and whether they ever were.
  std::uint64_t changes_ = 0;
  bool isKnown_ = false;
};

}  // namespace pongsim
