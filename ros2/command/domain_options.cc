#include "ros2/command/domain_options.hh"

#include <CLI/App.hpp>
#include <charconv>
#include <stdexcept>
#include <string_view>

#include "ros2/command/console.hh"
#include "ros2/config/environment.hh"

namespace pongsim::ros2 {

namespace {

constexpr int kLastDomain = 232;

int domainOf(const std::string& text) {
  int domain = -1;
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), domain);
  if (error != std::errc() || end != text.data() + text.size() || domain < 0 || domain > kLastDomain) {
    throw UsageError("option '--domain' takes an integer between 0 and 232, not '" + text + "'");
  }
  return domain;
}

}  // namespace

ParticipantOptions DomainOptions::participant() const {
  ParticipantOptions options;
  try {
    options = participantOptionsOfEnvironment();
  } catch (const std::invalid_argument& error) {
    throw UsageError(error.what());
  }
  if (domain) options.domain = domainOf(*domain);
  if (distro) {
    const std::optional<Distro> known = distroNamed(*distro);
    if (!known) throw UsageError("'" + *distro + "' is no distribution of ROS 2", "humble or jazzy, for example");
    options.distro = *known;
  }
  if (network) options.interface = *network;
  return options;
}

void addDomainOptions(CLI::App& action, const std::shared_ptr<DomainOptions>& given) {
  const auto add = [&](const char* name, const char* value, const char* help, std::optional<std::string>& target) {
    action
        .add_option_function<std::string>(
            name, [given, &target](const std::string& text) { target = text; }, help)
        ->type_name(value);
  };
  add("--domain", "N", "Domain of ROS, 0 to 232 (what ROS_DOMAIN_ID says, else 0)", given->domain);
  add("--distro", "NAME", "Distribution of the nodes, as humble or jazzy (what ROS_DISTRO says, else humble)",
      given->distro);
  add("--network", "INTERFACE", "Look at other machines too, by a network interface's name or address", given->network);
}

}  // namespace pongsim::ros2
