#include "web/system/hub.hh"

#include <gtest/gtest.h>

#include <memory>
#include <stdexcept>

#include "web/test/raw_client.hh"

namespace pongsim::web {
namespace {

TEST(Hub, IsSharedByAllWorldsOfAPort) {
  ServerSettings settings;
  settings.port = 0;
  const std::shared_ptr<Hub> one = Hub::open(settings, {});
  EXPECT_EQ(Hub::open(settings, {}), one);
  // a second server cannot open the port given to the first one
  settings.port = one->server().port();
  EXPECT_THROW(Hub::open(settings, {}), std::runtime_error);
}

TEST(Hub, IsNotSharedByWorldsThatMeanOtherServers) {
  ServerSettings settings;
  settings.port = 0;
  const std::shared_ptr<Hub> one = Hub::open(settings, {});
  GzSettings locked;
  locked.authorizationKey = "key";
  EXPECT_THROW(Hub::open(settings, locked), std::runtime_error);
  settings.access.isReadOnly = true;
  EXPECT_THROW(Hub::open(settings, {}), std::runtime_error);
}

TEST(Hub, EndsWithItsLastWorld) {
  ServerSettings settings;
  settings.port = 0;
  std::shared_ptr<Hub> hub = Hub::open(settings, {});
  const int port = hub->server().port();
  hub.reset();
  EXPECT_FALSE(test::RawClient(port).isConnected());
}

TEST(Hub, SpeaksAllProtocols) {
  ServerSettings settings;
  settings.port = 0;
  const std::shared_ptr<Hub> hub = Hub::open(settings, {});
  for (const char* protocol : {"foxglove.websocket.v1", "foxglove.sdk.v1", "pongsim.web.v1"}) {
    test::RawClient client(hub->server().port());
    const std::string head = client.open("/", std::string("Sec-WebSocket-Protocol: ") + protocol + "\r\n");
    EXPECT_TRUE(head.starts_with("HTTP/1.1 101")) << head;
    EXPECT_NE(client.next().value().payload.find("\"op\":\"serverInfo\""), std::string::npos) << protocol;
  }
  test::RawClient gz(hub->server().port());
  EXPECT_TRUE(gz.open().starts_with("HTTP/1.1 101"));
}

}  // namespace
}  // namespace pongsim::web
