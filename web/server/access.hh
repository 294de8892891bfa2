#pragma once

#include <string>
#include <string_view>
#include <vector>

namespace pongsim::web {

/// Who may come in.
struct AccessRules {
  /// Whether other machines can reach the server.
  bool isOpen = false;
  /// Asked of every client; empty: of none.
  std::string token = {};
  /// Whether all clients are read-only.
  bool isReadOnly = false;
  /// Pages of others that may look, and those that may change things too, as browsers name them in `Origin`:
  /// "https://app.gazebosim.org".
  std::vector<std::string> readingOrigins = {};
  std::vector<std::string> writingOrigins = {};
  /// Names of this machine, by which it may be called beside its addresses.
  std::vector<std::string> hostNames = {};
};

/// What a client says of itself. Empty where it says nothing.
struct Visit {
  /// `Host`
  std::string host = {};
  /// `Origin`, which browsers say of the page that asks and other programs need not.
  std::string origin = {};
  std::string token = {};
};

struct Permission {
  enum class Kind { kRefused, kRead, kWrite };
  Kind kind = Kind::kRefused;
  /// HTTP's status where it is refused.
  int status = 403;
  /// Why it is refused, for its user.
  std::string why = {};
};

/// @return Whether the host by which the server was called is this machine: else a foreign page has pointed a name of
/// its own at this address, and its scripts would be of the same origin.
bool isOwnHost(const AccessRules& rules, std::string_view host);

/// @return Whether who asks may load the page. The token is not asked for: there is nothing secret in it.
Permission judgePage(const AccessRules& rules, const Visit& visit);

/// @return Whether who asks may be a client, or load what the world consists of.
Permission judgeClient(const AccessRules& rules, const Visit& visit);

/// Compares in a time that does not depend on where they differ.
bool isSameSecret(std::string_view given, std::string_view expected);

/// @return 128 random bits, in 32 hexadecimal digits.
/// @throws std::runtime_error where the system has none.
std::string randomToken();

/// @return What is wrong with it as an origin, or nothing. "https://a.org:8443" is right, a path behind it is not.
std::string originError(std::string_view origin);

}  // namespace pongsim::web
