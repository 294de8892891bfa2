#include "web/system/parameters.hh"

#include <unistd.h>

#include <algorithm>
#include <array>
#include <stdexcept>

#include "pongsim/parameters.hh"
#include "pongsim/program/network_interface.hh"
#include "web/typed/asset_address.hh"

namespace pongsim::web {

namespace {

constexpr const char* kLoopback = "127.0.0.1";

void checkOrigins(const std::vector<std::string>& origins, const Element& plugin) {
  for (const std::string& origin : origins) {
    if (const std::string error = originError(origin); !error.empty())
      refuse(plugin, "'" + origin + "' is not an origin: it " + error);
  }
}

/// What the page's policy contains can't end it: a browser would ignore the rest.
void checkFramingOrigins(const std::vector<std::string>& origins, const Element& plugin) {
  for (const std::string& each : origins) {
    std::string_view origin = each;
    if (origin.ends_with(":*")) origin.remove_suffix(2);
    std::string error = originError(origin);
    if (error.empty() && origin.find_first_of(";,'\"") != std::string_view::npos) error = "has more than names";
    if (!error.empty()) refuse(plugin, "'" + each + "' is not an origin: it " + error);
  }
}

/// Reads `<subscription_limit_per_connection>`, whose `<subscription>`s have a `<msg_type>` and a `<limit>`.
void readLimits(const Element& limits, GzSettings& gz) {
  for (const Element* const each : limits.childrenNamed("subscription")) {
    const std::string type = requiredText(*each, "msg_type");
    requiredText(*each, "limit");
    gz.subscriptionLimits[type] = each->get<int>("limit", 0);
  }
}

std::vector<std::string> ownNames() {
  std::array<char, 256> name{};
  if (gethostname(name.data(), name.size() - 1) != 0) return {};
  const std::string host = name.data();
  return {host, host + ".local"};
}

/// @throws std::runtime_error if there is none.
std::string addressOf(const std::string& network) {
  std::string known;
  for (const NetworkInterface& each : networkInterfaces()) {
    if (each.name == network || each.address == network) return each.address;
    known += " " + each.name + " (" + each.address + ")";
  }
  throw std::runtime_error("there is no network interface '" + network + "'; there are" + known);
}

}  // namespace

void WebParameters::declare(Declaration& declaration) {
  declaration.parameter("port", &port, "", "TCP port of the page and of all protocols; 0: any free one")
      .atLeast(0)
      .atMost(65535);
  declaration.parameter("origin", &origins, "",
                        "Origin of another page that may connect read-only, such as https://app.gazebosim.org");
  declaration.parameter("writing_origin", &writingOrigins, "", "Origin of another page that may also change things");
  declaration.parameter("framing_origin", &framingOrigins, "",
                        "Origin of a page that may show this one in a frame; \":*\" at its end stands for any port");
  declaration.parameter("read_only", &isReadOnly, "", "Whether all clients are read-only");
  declaration.usesFiles();
  declaration.parameter("certificate", &certificate, "", "File with the certificate for TLS, in PEM")
      .otherwise("no TLS");
  declaration.parameter("key", &key, "", "File with the certificate's key, in PEM").otherwise("no TLS");
  declaration.element("ssl", "The same as in ign-launch: <cert_file> and <private_key_file>");
  declaration
      .parameter("publication_hz", &gz.publicationHz, "1/s",
                 "Maximum message rate of a topic for a client of ign-launch's protocol")
      .above(0);
  declaration.parameter("authorization_key", &gz.authorizationKey, "", "Key that such clients must send")
      .otherwise("none");
  declaration.parameter("admin_authorization_key", &gz.adminAuthorizationKey, "", "Another such key").otherwise("none");
  declaration.parameter("max_connections", &gz.maxConnections, "",
                        "Maximum number of such clients; below 0: unlimited");
  declaration.parameter(
      "queue_size_per_connection", &gz.queueSizePerConnection, "",
      "Maximum number of messages of a topic that wait for such a client; below 0: depends on the type");
  declaration.element("subscription_limit_per_connection",
                      "Maximum number of topics of a type that such a client may subscribe to: <subscription> with "
                      "<msg_type> and <limit>");
}

void WebParameters::readRest(const Element& plugin) {
  checkOrigins(origins, plugin);
  checkOrigins(writingOrigins, plugin);
  checkFramingOrigins(framingOrigins, plugin);
  if (const Element* const limits = plugin.child("subscription_limit_per_connection")) readLimits(*limits, gz);
  if (const Element* const ssl = plugin.child("ssl")) {
    if (certificate.empty()) certificate = ssl->get<std::string>("cert_file", "");
    if (key.empty()) key = ssl->get<std::string>("private_key_file", "");
  }
  if (certificate.empty() != key.empty()) {
    refuse(plugin, std::string("TLS needs a certificate and its key; the ") + (key.empty() ? "key" : "certificate") +
                       " is missing");
  }
}

ServerSettings serverSettings(const WebParameters& parameters, const std::string& network, const std::string& token) {
  ServerSettings settings;
  settings.port = parameters.port;
  settings.certificate = parameters.certificate;
  settings.key = parameters.key;
  settings.framingOrigins = parameters.framingOrigins;
  AccessRules& access = settings.access;
  access.isReadOnly = parameters.isReadOnly;
  access.readingOrigins = parameters.origins;
  access.writingOrigins = parameters.writingOrigins;
  access.token = token;
  if (network.empty()) return settings;
  const std::string address = addressOf(network);
  if (address == kLoopback) return settings;
  settings.addresses.push_back(address);
  access.isOpen = true;
  access.hostNames = ownNames();
  if (token.empty()) access.token = randomToken();
  return settings;
}

std::string pageAddress(const ServerSettings& settings, int port) {
  std::string address = settings.certificate.empty() ? "http://" : "https://";
  address += settings.addresses.back() + ":" + std::to_string(port) + "/";
  return settings.access.token.empty() ? address : address + "?token=" + typed::percentEncoded(settings.access.token);
}

}  // namespace pongsim::web
