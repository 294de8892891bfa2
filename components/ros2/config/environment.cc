#include "ros2/config/environment.hh"

#include <algorithm>
#include <charconv>
#include <cstdlib>
#include <stdexcept>

#include "ros2/wire/participant.hh"

namespace pongsim::ros2 {

namespace {

constexpr std::string_view kDistros[] = {"dashing", "eloquent", "foxy",   "galactic", "humble",
                                         "iron",    "jazzy",    "kilted", "lyrical",  "rolling"};
// Earlier distributions use Humble's format.
constexpr std::string_view kFirstNew = "iron";

std::string_view environment(const char* name) {
  const char* text = std::getenv(name);
  return text == nullptr ? std::string_view() : std::string_view(text);
}

}  // namespace

std::optional<Distro> distroNamed(std::string_view name) {
  const auto found = std::ranges::find(kDistros, name);
  if (found == std::end(kDistros)) return std::nullopt;
  return found < std::ranges::find(kDistros, kFirstNew) ? Distro::kHumble : Distro::kJazzy;
}

std::span<const std::string_view> distroNames() { return kDistros; }

ParticipantOptions participantOptionsOfEnvironment() {
  ParticipantOptions options;
  if (const std::string_view text = environment("ROS_DOMAIN_ID"); !text.empty()) {
    const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), options.domain);
    if (error != std::errc() || end != text.data() + text.size() || options.domain < 0 ||
        options.domain > kLastDomain) {
      throw std::invalid_argument("ROS_DOMAIN_ID is '" + std::string(text) + "', not an integer between 0 and 232");
    }
  }
  options.isLoopbackOnly = environment("ROS_LOCALHOST_ONLY") == "1";
  // an unknown distribution is taken for a later one
  if (const std::string_view text = environment("ROS_DISTRO"); !text.empty()) {
    options.distro = distroNamed(text).value_or(Distro::kJazzy);
  }
  if (const std::string_view text = environment("PONGSIM_NETWORK"); !text.empty()) options.interface = text;
  return options;
}

}  // namespace pongsim::ros2
