#include "cli/fortress_environment.hh"

#include <cstdlib>
#include <string_view>

namespace pongsim::cli {

namespace {

struct Variable {
  const char* name;
  /// What to use instead, behind a colon.
  std::string_view instead;
};

constexpr std::string_view kNetwork = "PONGSIM_NETWORK opens a run to other machines";
constexpr std::string_view kDomain = "PONGSIM_DOMAIN and IGN_PARTITION keep runs apart";
constexpr std::string_view kPassword = "nobody is asked for a password, so leave the network closed";

constexpr Variable kVariables[] = {
    {"IGN_IP", kNetwork},
    {"IGN_RELAY", kNetwork},
    {"IGN_DISCOVERY_MULTICAST_IP", kDomain},
    {"IGN_DISCOVERY_MSG_PORT", kDomain},
    {"IGN_DISCOVERY_SRV_PORT", kDomain},
    {"IGN_TRANSPORT_USERNAME", kPassword},
    {"IGN_TRANSPORT_PASSWORD", kPassword},
    {"IGN_GAZEBO_PHYSICS_ENGINE_PATH", "pongsim has an engine of its own"},
};

/// @return Whether it asks for what is so anyway.
bool isMet(std::string_view name, std::string_view value) {
  return value.empty() || (name == "IGN_IP" && value.starts_with("127."));
}

}  // namespace

std::vector<std::string> unheardVariables() {
  std::vector<std::string> sentences;
  for (const Variable& variable : kVariables) {
    const char* value = std::getenv(variable.name);
    if (value == nullptr || isMet(variable.name, value)) continue;
    sentences.push_back(std::string(variable.name) + " changes nothing here: " + std::string(variable.instead));
  }
  return sentences;
}

}  // namespace pongsim::cli
