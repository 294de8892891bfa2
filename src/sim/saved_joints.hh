#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "pongsim/state_archive.hh"
#include "pongsim/types.hh"
#include "sim/access.hh"

namespace pongsim::sim {

/// A joint as a saved state has it: one of the file is only named, one that was made while running is told whole.
struct SavedJoint {
  /// Of all that the file says of it, or that is below.
  std::uint64_t key = 0;
  bool isMade = false;
  JointId id;
  std::string name;
  std::string parent;
  std::string child;
  Pose X_ParentJoint;

  void transfer(StateArchive& archive);
};

/// @return The joints that are there or set aside, in the order of their ids.
std::vector<SavedJoint> listJoints(const Access& access);

/// Makes and removes joints until these are there. Where the file has joints that have gone since, all goes back to the
/// start first, which can't be where models have come or gone. Nothing may be set aside.
/// @return Why that can't be, and nothing is changed then.
std::optional<std::string> restoreJoints(Access& access, const std::vector<SavedJoint>& wanted);

}  // namespace pongsim::sim
