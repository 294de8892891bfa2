#pragma once

#include <string>
#include <vector>

#include "pongsim/state/state_archive.hh"
#include "sim/api/access.hh"

namespace pongsim::sim {

/// A group in a saved state that is set aside: the names of its top-level entities.
struct SavedGroup {
  std::vector<std::string> models;
  std::vector<std::string> lights;
  std::vector<std::string> actors;

  void transfer(StateArchive& archive);
  bool operator==(const SavedGroup&) const = default;
};

/// @return All groups that are set aside.
std::vector<SavedGroup> listGroups(const Access& access);

/// Returns all groups that are set aside.
void bringAllBack(Access& access);

/// Sets these groups aside, if none is yet.
void setAside(const std::vector<SavedGroup>& groups, Access& access);

}  // namespace pongsim::sim
