#pragma once

#include <string>
#include <string_view>
#include <vector>

namespace pongsim::ros2 {

/// What a check says of a running world.
struct Finding {
  enum class Verdict {
    kGood,
    /// It may be meant, or somebody else's part.
    kHint,
    kFault,
  };
  Verdict verdict = Verdict::kGood;
  std::string text;
  /// The line that mends it; empty if good.
  std::string remedy = {};
  /// Who needs it: "Nav2, slam_toolbox".
  std::string_view users = {};
  bool operator==(const Finding&) const = default;
};

using Findings = std::vector<Finding>;

}  // namespace pongsim::ros2
