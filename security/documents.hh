#pragma once

#include <ctime>
#include <string>
#include <string_view>
#include <vector>

namespace pongsim::security {

/// What an identity is to be allowed, by patterns of topics and services ("/robot/*"); with none of them: everything.
struct Permissions {
  std::vector<std::string> publish;
  std::vector<std::string> subscribe;
  std::vector<std::string> call;
  std::vector<std::string> offer;

  bool areAll() const { return publish.empty() && subscribe.empty() && call.empty() && offer.empty(); }
};

/// Topics by which participants know each other, which each identity may use.
bool isEverybodys(std::string_view topic);

/// @return A governance document: in each domain none but identities take part, permissions count for each topic, and
/// all that is sent is encrypted, from participant to participant.
std::string governanceDocument();

/// @return A permissions document of one grant, for all domains, in the order in which DDS-Security wants it.
/// @param name That of the identity, "/robot"; its subject is "CN=/robot".
std::string permissionsDocument(const std::string& name, std::time_t from, std::time_t until,
                                const Permissions& permissions);

}  // namespace pongsim::security
