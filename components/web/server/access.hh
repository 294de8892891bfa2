#pragma once

#include <string>
#include <string_view>
#include <vector>

namespace pongsim::web {

/// Who may connect.
struct AccessRules {
  /// Whether other machines can reach the server.
  bool isOpen = false;
  /// Required from every client; empty: not required.
  std::string token = {};
  /// Whether all clients are read-only.
  bool isReadOnly = false;
  /// Origins of other pages that may read, and of those that may also change things, as browsers send them in `Origin`:
  /// "https://app.gazebosim.org".
  std::vector<std::string> readingOrigins = {};
  std::vector<std::string> writingOrigins = {};
  /// Names of this machine that clients may use in addition to its addresses.
  std::vector<std::string> hostNames = {};
};

/// What a client says about itself. Empty if it does not say.
struct Visit {
  /// `Host`
  std::string host = {};
  /// `Origin`: the page that makes the request, sent by browsers but not necessarily by other programs.
  std::string origin = {};
  std::string token = {};
};

struct Permission {
  enum class Kind { kRefused, kRead, kWrite };
  Kind kind = Kind::kRefused;
  /// HTTP status if refused.
  int status = 403;
  /// Why it is refused, for the user.
  std::string why = {};
};

/// @return Whether the client addressed the server by a name or address of this machine. Otherwise a foreign page could
/// point its own host name at this address, and its scripts would have the same origin (DNS rebinding).
bool isOwnHost(const AccessRules& rules, std::string_view host);

/// @return Whether the client may load the page. This needs no token: the page contains no secrets.
Permission judgePage(const AccessRules& rules, const Visit& visit);

/// @return Whether the client may open a WebSocket, or load a world's files.
Permission judgeClient(const AccessRules& rules, const Visit& visit);

/// Compares in constant time, regardless of where they differ.
bool isSameSecret(std::string_view given, std::string_view expected);

/// @return 128 random bits as 32 hexadecimal digits.
/// @throws std::runtime_error if the system provides none.
std::string randomToken();

/// @return What is wrong with it as an origin, or nothing. "https://a.org:8443" is valid; it must not have a path.
std::string originError(std::string_view origin);

}  // namespace pongsim::web
