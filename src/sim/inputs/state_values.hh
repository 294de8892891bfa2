#pragma once

#include <cstddef>
#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

#include "pongsim/state/state_archive.hh"

namespace pongsim::sim {

class Access;

/// All numbers of a world's state with the names of the links and joints that they belong to.
struct StateValues {
  /// [ns]
  std::int64_t time = 0;
  std::uint64_t iterations = 0;
  /// "rover::chassis"
  std::vector<std::string> links;
  std::vector<std::string> joints;
  /// The bits of `kLinkFields` for each link, then of `kJointFields` for each joint.
  std::vector<std::uint64_t> bits;

  static StateValues of(const Access& access);
  void transfer(StateArchive& archive);
  /// @return Whether there are as many numbers as the names need.
  bool isWhole() const;
};

/// @return A quick hash of these numbers, for comparisons within one build.
std::uint64_t quickHash(const Access& access);

/// Where two states differ, in one line each: "link 'box::link', position z: 0.5 and 0.4999". Of more than `most`
/// lines, the last says how many there are. Empty if no bit differs.
std::vector<std::string> differences(const StateValues& a, const StateValues& b, std::size_t most);

/// @return The state as text, one line for each link and joint.
std::string textOf(const StateValues& values);

}  // namespace pongsim::sim
