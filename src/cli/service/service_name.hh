#pragma once

#include <string>
#include <string_view>
#include <vector>

namespace pongsim {
struct ServiceInfo;
class Transport;
}  // namespace pongsim

namespace pongsim::cli {

/// @return The service that a user names, with its leading slash.
/// @throws UsageError where it can't be a service's name.
std::string serviceOption(std::string_view name);

/// Says that no process has the service, and which one may be meant.
/// @return The exit code.
int failWithoutService(Transport& transport, const std::string& service);

/// @return "did you mean '/gazebo/worlds'?" for the service that is spelt most like `name`, or an empty text.
std::string nearestService(std::string_view name, const std::vector<ServiceInfo>& known);

}  // namespace pongsim::cli
