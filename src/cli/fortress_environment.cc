#include "cli/fortress_environment.hh"

#include <cstdlib>
#include <string_view>

namespace pongsim::cli {

namespace {

struct Variable {
  const char* name;
  /// What it does not change.
  std::string_view what;
  /// What to use instead, behind a colon.
  std::string_view instead;
};

constexpr std::string_view kNetwork = "PONGSIM_NETWORK opens a run to other machines";
constexpr std::string_view kDomain = "PONGSIM_DOMAIN and IGN_PARTITION keep runs apart";
constexpr std::string_view kPassword = "nobody is asked for a password there, so leave the network closed";

// Of those that speak of ign-transport a package may make something.
constexpr std::string_view kHere = "here";
constexpr std::string_view kOwnTopics = "for pongsim's own topics";

constexpr Variable kVariables[] = {
    {"IGN_IP", kOwnTopics, kNetwork},
    {"IGN_RELAY", kOwnTopics, kNetwork},
    {"IGN_DISCOVERY_MULTICAST_IP", kOwnTopics, kDomain},
    {"IGN_DISCOVERY_MSG_PORT", kOwnTopics, kDomain},
    {"IGN_DISCOVERY_SRV_PORT", kOwnTopics, kDomain},
    {"IGN_TRANSPORT_USERNAME", kOwnTopics, kPassword},
    {"IGN_TRANSPORT_PASSWORD", kOwnTopics, kPassword},
    {"IGN_GAZEBO_PHYSICS_ENGINE_PATH", kHere, "pongsim has an engine of its own"},
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
    sentences.push_back(std::string(variable.name) + " changes nothing " + std::string(variable.what) + ": " +
                        std::string(variable.instead));
  }
  return sentences;
}

}  // namespace pongsim::cli
