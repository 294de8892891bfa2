// Arbitrary bytes of a connection, as the server of the page receives them: if the first byte is odd, after a valid
// WebSocket handshake. The connection must end when the client's side does, and the server must serve the next one.

#include <cstddef>
#include <cstdint>

#include "fuzz/require.hh"
#include "pongsim/log.hh"
#include "support/web/echo_protocol.hh"
#include "web/server/server.hh"
#include "web/test/raw_client.hh"

namespace pongsim::web {
namespace {

/// A server that lives as long as the process.
struct RunningServer {
  RunningServer() { setLogLevel(LogLevel::kNone); }

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
  static RunningServer running;
  if (size == 0) return 0;
  test::RawClient client(running.server.port());
  // there are no free ports, as for a minute after many connections
  if (!client.isConnected()) return -1;
  if (data[0] % 2 == 1) pongsim::fuzz::require(client.open().starts_with("HTTP/1.1 101"));
  client.send({reinterpret_cast<const char*>(data) + 1, size - 1});
  pongsim::fuzz::require(client.finish());
  return 0;
}
