#include "ros2/doctor/checks.hh"

#include <cmath>
#include <cstdio>

namespace pongsim::ros2 {

Findings checkAll(const Observation& seen, const Expected& expected) {
  Findings all = checkTime(seen);
  for (const Findings& more : {checkFrames(seen, expected), checkTopics(seen, expected), checkCommands(seen, expected),
                               checkRobot(seen, expected), checkMatches(seen)}) {
    all.insert(all.end(), more.begin(), more.end());
  }
  return all;
}

std::string rootOf(const std::map<std::string, FrameSeen>& frames, std::string frame) {
  // a longer way has a loop
  for (std::size_t i = 0; i <= frames.size(); ++i) {
    const auto found = frames.find(frame);
    if (found == frames.end()) return frame;
    frame = *found->second.parents.begin();
  }
  return {};
}

bool isKnown(const std::map<std::string, FrameSeen>& frames, const std::string& frame) {
  if (frames.contains(frame)) return true;
  for (const auto& [name, each] : frames) {
    if (each.parents.contains(frame)) return true;
  }
  return false;
}

std::string quoted(const std::set<std::string>& names) {
  constexpr std::size_t kMost = 8;
  std::string text;
  std::size_t count = 0;
  for (const std::string& name : names) {
    if (count++ == kMost) return text + " and " + std::to_string(names.size() - kMost) + " more";
    text += (text.empty() ? "'" : ", '") + name + "'";
  }
  return text;
}

std::string rounded(double value) {
  char text[32];
  std::snprintf(text, sizeof text, "%.3g", value);
  return value >= 1000 ? std::to_string(std::llround(value)) : text;
}

}  // namespace pongsim::ros2
