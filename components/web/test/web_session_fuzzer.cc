// Arbitrary messages of a client: the first byte selects the protocol; then each message follows its length in two
// bytes, of which the highest bit means binary. Sessions must end, and answer with valid messages only.

#include <cstddef>
#include <cstdint>
#include <iterator>
#include <memory>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include <ignition/msgs/boolean.pb.h>
#include <ignition/msgs/stringmsg.pb.h>
#include <ignition/msgs/world_control.pb.h>
#include <nlohmann/json.hpp>

#include "fuzz/require.hh"
#include "fuzz/split_messages.hh"
#include "support/web/recorded_client.hh"
#include "support/web/stepped_world.hh"
#include "web/foxglove/protocol.hh"
#include "web/gz/protocol.hh"
#include "web/system/plain_protocol.hh"

namespace pongsim::web {
namespace {

namespace im = ignition::msgs;

class NoChannels final : public OwnChannels {
 public:
  std::vector<std::shared_ptr<OwnChannel>> all() const override { return {}; }
  std::uint64_t version() const override { return 1; }
};

/// A world that lives as long as the process, with a topic and a service, and all protocols.
struct RunningWorld {
  std::shared_ptr<Worlds> worlds = std::make_shared<Worlds>();
  SteppedWorld world{worlds};
  NoChannels own;
  RecordedAssets assets;
  RecentLog log;
  foxglove::FoxgloveProtocol foxglove{worlds, own, log, assets};
  gz::GzProtocol gz{worlds, assets};
  PlainProtocol plain{worlds, gz, log};
  Publisher said = world.node().advertise<im::StringMsg>("/said");
  Service control = world.node().serve("/world/w/control", "ignition.msgs.WorldControl", "ignition.msgs.Boolean",
                                       [](const Message&, Message&) { return true; });
};

void check(RecordedClient& client) {
  for (const std::string& text : client.takeTexts()) fuzz::require(nlohmann::json::accept(text));
  for (const std::string& bytes : client.takeBinaries()) fuzz::require(!bytes.empty());
}

}  // namespace
}  // namespace pongsim::web

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  using namespace pongsim;
  using namespace pongsim::web;
  static RunningWorld running;
  if (size == 0) return 0;
  constexpr const char* kNames[] = {"foxglove.websocket.v1", "pongsim.web.v1", ""};
  const std::size_t choice = data[0] % std::size(kNames);
  const bool isFoxglove = *kNames[choice] != '\0';
  const auto client = std::make_shared<RecordedClient>();
  const std::unique_ptr<Session> session =
      isFoxglove ? running.foxglove.open(kNames[choice], client) : running.plain.open("", client);
  running.world.step();
  fuzz::splitMessages({data + 1, size - 1}, [&](const std::vector<std::uint8_t>& message, bool isBinary) {
    if (isBinary) {
      session->binary(std::as_bytes(std::span(message)));
    } else {
      session->text({reinterpret_cast<const char*>(message.data()), message.size()});
    }
    im::StringMsg greeting;
    greeting.set_data("hello");
    running.said.publish(greeting);
    running.world.step();
    client->free();
    check(*client);
  });
  return 0;
}
