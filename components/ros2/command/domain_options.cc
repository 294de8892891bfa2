#include "ros2/command/domain_options.hh"

#include <CLI/App.hpp>
#include <charconv>
#include <cstdlib>
#include <stdexcept>
#include <string_view>

#include "pongsim/program/keystore.hh"
#include "ros2/config/distro.hh"
#include "ros2/config/environment.hh"
#include "ros2/wire/participant.hh"
#include "ros2/wire/security.hh"
#include "shared/program/console.hh"
#include "shared/program/failure.hh"

namespace pongsim::ros2 {

namespace {

int domainOf(const std::string& text) {
  int domain = -1;
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), domain);
  if (error != std::errc() || end != text.data() + text.size() || domain < 0 || domain > kLastDomain) {
    throw cli::UsageError("option '--domain' takes an integer between 0 and 232, not '" + text + "'");
  }
  return domain;
}

}  // namespace

ParticipantOptions DomainOptions::participant() const {
  ParticipantOptions options;
  try {
    options = participantOptionsOfEnvironment();
  } catch (const std::invalid_argument& error) {
    throw cli::UsageError(error.what());
  }
  if (domain) options.domain = domainOf(*domain);
  if (distro && !isDistro(*distro)) {
    throw cli::UsageError("'" + *distro + "' is not a ROS 2 distribution", "humble or jazzy, for example");
  }
  if (network) options.interface = *network;
  const Security security = securityOfEnvironment(options.domain);
  if (!security.warning.empty()) cli::say(security.warning);
  for (const std::string& sentence : unmetVariables(options)) cli::say(sentence);
  return options;
}

void takeKeystore(const std::string& place) {
  if (place.empty()) throw cli::UsageError("option '--secure' takes a keystore, or KEYSTORE/NAME, not ''");
  secureBy(place);
}

void addDomainOptions(CLI::App& action, const std::shared_ptr<DomainOptions>& given) {
  const auto add = [&](const char* name, const char* value, const char* help, std::optional<std::string>& target) {
    action
        .add_option_function<std::string>(
            name, [given, &target](const std::string& text) { target = text; }, help)
        ->type_name(value);
  };
  add("--domain", "N", "ROS domain, 0 to 232 (ROS_DOMAIN_ID, else 0)", given->domain);
  add("--distro", "NAME", "ROS distribution of the nodes; no longer needed: those of all are met", given->distro);
  add("--network", "INTERFACE", "Also look at machines on this network interface (name or address)", given->network);
  action
      .add_option_function<std::string>(
          "--secure",
          [](const std::string& place) {
            takeKeystore(place);
            unsetenv("ROS_SECURITY_ENABLE");
          },
          "Take part as an identity of this keystore (ROS_SECURITY_KEYSTORE and others)")
      ->type_name("KEYSTORE[/NAME]");
}

}  // namespace pongsim::ros2
