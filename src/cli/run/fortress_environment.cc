#include "cli/run/fortress_environment.hh"

#include <cstdlib>
#include <string_view>

namespace pongsim::cli {

namespace {

struct Variable {
  const char* name;
  /// What it has no effect on.
  std::string_view what;
  /// What to use instead, printed after a colon.
  std::string_view instead;
};

constexpr std::string_view kNetwork = "use PONGSIM_NETWORK to reach other machines";
constexpr std::string_view kDomain = "use PONGSIM_DOMAIN or IGN_PARTITION to separate runs";
constexpr std::string_view kPassword = "pongsim has no passwords for topics: use --secure";

// A package may make use of the variables of ign-transport.
constexpr std::string_view kHere = "here";
constexpr std::string_view kOwnTopics = "on pongsim's own topics";

constexpr Variable kVariables[] = {
    {"IGN_IP", kOwnTopics, kNetwork},
    {"IGN_RELAY", kOwnTopics, kNetwork},
    {"IGN_DISCOVERY_MULTICAST_IP", kOwnTopics, kDomain},
    {"IGN_DISCOVERY_MSG_PORT", kOwnTopics, kDomain},
    {"IGN_DISCOVERY_SRV_PORT", kOwnTopics, kDomain},
    {"IGN_TRANSPORT_USERNAME", kOwnTopics, kPassword},
    {"IGN_TRANSPORT_PASSWORD", kOwnTopics, kPassword},
    {"IGN_GAZEBO_PHYSICS_ENGINE_PATH", kHere, "pongsim has its own physics engine"},
};

/// @return Whether it asks for the default behaviour.
bool isMet(std::string_view name, std::string_view value) {
  return value.empty() || (name == "IGN_IP" && value.starts_with("127."));
}

}  // namespace

std::vector<std::string> ignoredVariables() {
  std::vector<std::string> sentences;
  for (const Variable& variable : kVariables) {
    const char* value = std::getenv(variable.name);
    if (value == nullptr || isMet(variable.name, value)) continue;
    sentences.push_back(std::string(variable.name) + " has no effect " + std::string(variable.what) + ": " +
                        std::string(variable.instead));
  }
  return sentences;
}

}  // namespace pongsim::cli
