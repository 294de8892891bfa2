#include "ros2/config/distro.hh"

#include <algorithm>
#include <cstdlib>
#include <iterator>

namespace pongsim::ros2 {

namespace {
constexpr std::string_view kDistros[] = {"dashing", "eloquent", "foxy",   "galactic", "humble",
                                         "iron",    "jazzy",    "kilted", "lyrical",  "rolling"};
// which ships simulation_interfaces 2
constexpr std::string_view kFirstWithNewerInterfaces = "lyrical";
}  // namespace

std::span<const std::string_view> distroNames() { return kDistros; }

bool isDistro(std::string_view name) { return std::ranges::find(kDistros, name) != std::end(kDistros); }

bool shipsOlderInterfaces(std::string_view name) {
  return !isDistro(name) || std::ranges::find(kDistros, name) < std::ranges::find(kDistros, kFirstWithNewerInterfaces);
}

std::string distroOfEnvironment() {
  const char* text = std::getenv("ROS_DISTRO");
  return text == nullptr ? "" : text;
}

}  // namespace pongsim::ros2
