#include "ros2/pairs/frames.hh"

namespace pongsim::ros2 {

void Frames::toRos(std::string_view frame, std::string& to) const {
  to.clear();
  if (frame.empty()) return;
  to += prefix;
  while (!frame.empty()) {
    const std::size_t colons = frame.find("::");
    to += frame.substr(0, colons);
    if (colons == std::string_view::npos) return;
    to += '/';
    frame.remove_prefix(colons + 2);
  }
}

std::string_view Frames::fromRos(std::string_view frame) const {
  if (!prefix.empty() && frame.starts_with(prefix)) frame.remove_prefix(prefix.size());
  return frame;
}

}  // namespace pongsim::ros2
