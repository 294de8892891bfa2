#pragma once

#include <ctime>
#include <string>
#include <string_view>
#include <vector>

namespace pongsim::security {

/// The permissions of an identity, as patterns of topics and services ("/robot/*"); without any, everything is allowed.
struct Permissions {
  std::vector<std::string> publish;
  std::vector<std::string> subscribe;
  std::vector<std::string> call;
  std::vector<std::string> offer;

  bool areAll() const { return publish.empty() && subscribe.empty() && call.empty() && offer.empty(); }
};

/// @return Whether it is a topic for discovery, which every identity may publish and subscribe.
bool isEverybodys(std::string_view topic);

/// @return A governance document: in all domains only authenticated participants are allowed, topics are subject to
/// access control, and RTPS messages are encrypted.
std::string governanceDocument();

/// @return A permissions document with one grant for all domains, with elements in the order that DDS-Security
/// requires.
/// @param name Name of the identity, "/robot"; its subject is "CN=/robot".
std::string permissionsDocument(const std::string& name, std::time_t from, std::time_t until,
                                const Permissions& permissions);

}  // namespace pongsim::security
