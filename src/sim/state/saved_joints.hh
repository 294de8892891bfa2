#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "pongsim/state/state_archive.hh"
#include "pongsim/types.hh"
#include "sim/api/access.hh"

namespace pongsim::sim {

/// A joint in a saved state: a joint of the file only by name, one made at run time with its description.
struct SavedJoint {
  /// Hash of its description in the file, or of the fields below.
  std::uint64_t key = 0;
  bool isMade = false;
  JointId id;
  std::string name;
  std::string parent;
  std::string child;
  Pose X_ParentJoint;

  void transfer(StateArchive& archive);
};

/// @return All joints, including those set aside, in the order of their ids.
std::vector<SavedJoint> listJoints(const Access& access);

/// Makes and removes joints until exactly these exist. If joints of the file have been removed, everything is first
/// reset to the start, which is refused if models were added or removed. No entity may be set aside. A refusal changes
/// nothing.
Outcome<void> restoreJoints(Access& access, const std::vector<SavedJoint>& wanted);

}  // namespace pongsim::sim
