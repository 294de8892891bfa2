#include "web/server/access.hh"

#include <arpa/inet.h>
#include <sys/random.h>

#include <algorithm>
#include <array>
#include <cctype>
#include <cstddef>
#include <stdexcept>

namespace pongsim::web {

namespace {

std::string lower(std::string_view text) {
  std::string result(text);
  std::ranges::transform(result, result.begin(), [](unsigned char c) { return static_cast<char>(std::tolower(c)); });
  return result;
}

/// @return The text without control characters, safe to print on a terminal.
std::string shown(std::string_view text) {
  std::string result(text);
  std::ranges::replace_if(
      result, [](unsigned char c) { return c < ' ' || c > '~'; }, '?');
  return result;
}

/// @return "127.0.0.1" for "127.0.0.1:9002", "[::1]" for "[::1]:9002".
std::string_view withoutPort(std::string_view host) {
  const std::size_t colon = host.rfind(':');
  if (colon == std::string_view::npos || host.find(']', colon) != std::string_view::npos) return host;
  const std::string_view port = host.substr(colon + 1);
  const bool isPort = std::ranges::all_of(port, [](unsigned char c) { return std::isdigit(c) != 0; });
  return isPort ? host.substr(0, colon) : host;
}

bool isAddress(const std::string& host) {
  std::array<unsigned char, sizeof(in6_addr)> place{};
  if (host.size() > 2 && host.front() == '[' && host.back() == ']')
    return inet_pton(AF_INET6, host.substr(1, host.size() - 2).c_str(), place.data()) == 1;
  return inet_pton(AF_INET, host.c_str(), place.data()) == 1;
}

bool contains(const std::vector<std::string>& all, const std::string& one) {
  return std::ranges::find(all, one) != all.end();
}

/// @return Whether the origin is this server itself.
bool isSameOrigin(const std::string& origin, const std::string& host) {
  return origin == "http://" + host || origin == "https://" + host;
}

/// @return Why a page of this origin is refused.
std::string refusalOf(const std::string& origin) {
  // browsers send this for pages in sandboxed frames, data: addresses and the like, which anybody can make
  if (origin == "null")
    return "a page without an origin ('null') can't be allowed: serve it from an address of its own";
  std::string why = "the page of '" + shown(origin) + "' is not allowed";
  if (originError(origin).empty()) why += "; use pongsim run --web-origin " + shown(origin) + " to allow it";
  return why;
}

}  // namespace

bool isOwnHost(const AccessRules& rules, std::string_view host) {
  const std::string name = lower(withoutPort(host));
  if (name == "localhost" || name == "127.0.0.1" || name == "[::1]") return true;
  if (!rules.isOpen) return false;
  // addresses cannot be rebound by DNS
  if (isAddress(name)) return true;
  return std::ranges::any_of(rules.hostNames, [&](const std::string& own) { return lower(own) == name; });
}

Permission judgePage(const AccessRules& rules, const Visit& visit) {
  if (isOwnHost(rules, visit.host)) return {Permission::Kind::kRead, 200, {}};
  return {Permission::Kind::kRefused, 421,
          "'" + shown(withoutPort(visit.host)) + "' is not a name of this server: use localhost or an IP address"};
}

Permission judgeClient(const AccessRules& rules, const Visit& visit) {
  if (const Permission page = judgePage(rules, visit); page.kind == Permission::Kind::kRefused) return page;
  bool mayWrite = true;
  const std::string origin = lower(visit.origin);
  if (!origin.empty() && !isSameOrigin(origin, lower(visit.host))) {
    mayWrite = contains(rules.writingOrigins, origin);
    if (!mayWrite && !contains(rules.readingOrigins, origin)) {
      return {Permission::Kind::kRefused, 403, refusalOf(origin)};
    }
  }
  if (!rules.token.empty() && !isSameSecret(visit.token, rules.token)) {
    return {Permission::Kind::kRefused, 401,
            visit.token.empty() ? "a token is needed: the server printed the address with it at its start"
                                : "the token is wrong"};
  }
  return {mayWrite && !rules.isReadOnly ? Permission::Kind::kWrite : Permission::Kind::kRead, 200, {}};
}

bool isSameSecret(std::string_view given, std::string_view expected) {
  unsigned difference = given.size() == expected.size() ? 0 : 1;
  for (std::size_t i = 0; i < expected.size(); ++i) {
    const char other = given.empty() ? '\0' : given[i % given.size()];
    difference |= static_cast<unsigned char>(expected[i]) ^ static_cast<unsigned char>(other);
  }
  return difference == 0;
}

std::string randomToken() {
  std::array<unsigned char, 16> bytes{};
  if (getrandom(bytes.data(), bytes.size(), 0) != static_cast<ssize_t>(bytes.size()))
    throw std::runtime_error("the system provides no random numbers");
  constexpr std::string_view kDigits = "0123456789abcdef";
  std::string text;
  for (const unsigned byte : bytes) text += {kDigits[byte >> 4U], kDigits[byte & 15U]};
  return text;
}

std::string originError(std::string_view origin) {
  const std::size_t scheme = origin.find("://");
  if (scheme == std::string_view::npos || scheme == 0) return "has no scheme, such as https:";
  const std::string_view rest = origin.substr(scheme + 3);
  if (rest.find_first_of("/?#@ *") != std::string_view::npos) return "has more than a scheme, host and port";
  if (rest.empty() && origin != "file://") return "has no host";
  if (origin != lower(origin)) return "has upper-case letters, which browsers never send";
  return {};
}

}  // namespace pongsim::web
