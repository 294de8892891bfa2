#pragma once

#include <string>
#include <string_view>
#include <vector>

namespace pongsim {
struct ServiceInfo;
class Transport;
}  // namespace pongsim

namespace pongsim::cli {

/// @return The service named by the user, with its leading slash.
/// @throws UsageError if it is not a valid service name.
std::string serviceOption(std::string_view name);

/// Reports that no process offers the service, and suggests a similar name.
/// @return The exit code.
int failWithoutService(Transport& transport, const std::string& service);

/// @return "did you mean '/gazebo/worlds'?" for the service with the most similar name, or an empty text.
std::string nearestService(std::string_view name, const std::vector<ServiceInfo>& known);

}  // namespace pongsim::cli
