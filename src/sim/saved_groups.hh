#pragma once

#include <string>
#include <vector>

#include "pongsim/state_archive.hh"
#include "sim/access.hh"

namespace pongsim::sim {

/// What a saved state says of a group that is set aside: the names of what stands in it at the world's level.
struct SavedGroup {
  std::vector<std::string> models;
  std::vector<std::string> lights;
  std::vector<std::string> actors;

  void transfer(StateArchive& archive);
  bool operator==(const SavedGroup&) const = default;
};

/// @return Who is set aside.
std::vector<SavedGroup> listGroups(const Access& access);

/// Brings back all that is set aside.
void bringAllBack(Access& access);

/// Sets these aside, when nothing is.
void setAside(const std::vector<SavedGroup>& groups, Access& access);

}  // namespace pongsim::sim
