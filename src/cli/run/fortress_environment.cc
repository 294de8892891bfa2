#include "cli/run/fortress_environment.hh"

#include <cstdlib>
#include <string_view>

#include "pongsim/program/gazebo_variable.hh"

namespace pongsim::cli {

namespace {

struct Variable {
  GazeboVariable variable;
  /// What it has no effect on.
  std::string_view what;
  /// What to use instead, printed after a colon.
  std::string_view instead;
};

constexpr std::string_view kNetwork = "use PONGSIM_NETWORK to reach other machines";
constexpr std::string_view kDomain = "use PONGSIM_DOMAIN or IGN_PARTITION (GZ_PARTITION) to separate runs";
constexpr std::string_view kPassword = "pongsim has no passwords for topics: use --secure";

// A package may make use of the variables of ign-transport.
constexpr std::string_view kHere = "here";
constexpr std::string_view kOwnTopics = "on pongsim's own topics";

constexpr Variable kVariables[] = {
    {gazebo::kIp, kOwnTopics, kNetwork},
    {gazebo::kRelay, kOwnTopics, kNetwork},
    {gazebo::kMulticastIp, kOwnTopics, kDomain},
    {gazebo::kMessagePort, kOwnTopics, kDomain},
    {gazebo::kServicePort, kOwnTopics, kDomain},
    {gazebo::kUsername, kOwnTopics, kPassword},
    {gazebo::kPassword, kOwnTopics, kPassword},
    {gazebo::kPhysicsEnginePath, kHere, "pongsim has its own physics engine"},
};

/// @return Whether it asks for the default behaviour.
bool isMet(std::string_view name, std::string_view value) {
  const bool isAddress = name == gazebo::kIp.fortress || name == gazebo::kIp.later;
  return value.empty() || (isAddress && value.starts_with("127."));
}

}  // namespace

std::vector<std::string> ignoredVariables() {
  std::vector<std::string> sentences;
  for (const Variable& each : kVariables) {
    for (const char* const name : {each.variable.fortress, each.variable.later}) {
      const char* value = std::getenv(name);
      if (value == nullptr || isMet(name, value)) continue;
      sentences.push_back(std::string(name) + " has no effect " + std::string(each.what) + ": " +
                          std::string(each.instead));
    }
  }
  return sentences;
}

}  // namespace pongsim::cli
