#include "ros2/wire/security.hh"

#include <cstdlib>
#include <filesystem>

namespace pongsim::ros2 {

namespace {

std::string variable(const char* name) {
  const char* text = std::getenv(name);
  return text == nullptr ? std::string() : std::string(text);
}

/// @return "a, b" for the names "/a" and "/b".
std::string listOf(const std::vector<std::string>& names) {
  std::string text;
  for (const std::string& name : names) text += (text.empty() ? "" : ", ") + name;
  return text;
}

}  // namespace

Security securityOfEnvironment(int domain) {
  const std::string enabled = variable("ROS_SECURITY_ENABLE");
  if (enabled.empty()) return {chosenIdentity(domain), ""};
  if (enabled != "true") {
    return {std::nullopt, isSecured() ? "ROS_SECURITY_ENABLE is '" + enabled + "': ROS nodes are not secured" : ""};
  }
  const std::string keystore = variable("ROS_SECURITY_KEYSTORE");
  if (keystore.empty()) {
    throw KeystoreError("ROS_SECURITY_ENABLE is true, but ROS_SECURITY_KEYSTORE is not set",
                        "set it, or set ROS_SECURITY_ENABLE to false");
  }
  std::string name = variable("ROS_SECURITY_ENCLAVE_OVERRIDE");
  if (name.empty()) name = "/";
  const std::filesystem::path folder =
      std::filesystem::path(keystore) / "enclaves" / name.substr(name.front() == '/' ? 1 : 0);
  std::error_code error;
  if (std::filesystem::exists(std::filesystem::symlink_status(folder / "key.pem", error))) {
    return {readIdentity(folder.string(), domain), ""};
  }
  const std::string missing = "keystore '" + keystore + "' has no enclave '" + name + "'";
  if (variable("ROS_SECURITY_STRATEGY") != "Enforce") {
    return {std::nullopt, missing + ", and ROS_SECURITY_STRATEGY is not Enforce: ROS nodes are not secured"};
  }
  throw KeystoreError(missing + ", but " + listOf(identitiesOf(keystore)),
                      "set ROS_SECURITY_ENCLAVE_OVERRIDE to one of them");
}

}  // namespace pongsim::ros2
