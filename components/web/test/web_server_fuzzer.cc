// Arbitrary bytes of a connection, as the server of the page receives them: if the first byte is odd, after a valid
// WebSocket handshake. The connection must end when the client's side does, and the server must serve the next one.

#include <cstddef>
#include <cstdint>
#include <memory>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "fuzz/require.hh"
#include "pongsim/log.hh"
#include "web/server/server.hh"
#include "web/test/raw_client.hh"

namespace pongsim::web {
namespace {

/// Sends back what it receives.
class EchoSession final : public Session {
 public:
  explicit EchoSession(std::shared_ptr<Client> client) : client_(std::move(client)) {}
  void text(std::string_view message) override { client_->sendText(std::string(message)); }
  void binary(std::span<const std::byte> message) override {
    client_->sendBinary({.head = {}, .body = Payload({reinterpret_cast<const char*>(message.data()), message.size()})});
  }

 private:
  std::shared_ptr<Client> client_;
};

class EchoProtocol final : public Protocol {
 public:
  std::vector<std::string> names() const override { return {"echo", ""}; }
  std::unique_ptr<Session> open(const std::string&, const std::shared_ptr<Client>& client) override {
    return std::make_unique<EchoSession>(client);
  }
};

struct Place {
  Place() { setLogLevel(LogLevel::kNone); }

  Logger log{"web"};
  EchoProtocol protocol;
  Server server{[] {
                  ServerSettings settings;
                  settings.port = 0;
                  return settings;
                }(),
                log,
                {&protocol}};
};

}  // namespace
}  // namespace pongsim::web

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  using namespace pongsim::web;
  static Place place;
  if (size == 0) return 0;
  test::RawClient client(place.server.port());
  // there are no free ports, as for a minute after many connections
  if (!client.isConnected()) return -1;
  if (data[0] % 2 == 1) pongsim::fuzz::require(client.open().starts_with("HTTP/1.1 101"));
  client.send({reinterpret_cast<const char*>(data) + 1, size - 1});
  pongsim::fuzz::require(client.finish());
  return 0;
}
