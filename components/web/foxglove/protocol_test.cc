#include "web/foxglove/protocol.hh"

#include <gtest/gtest.h>

#include "support/web/session_of_a_world.hh"

namespace pongsim::web::foxglove {
namespace {

using FoxgloveProtocolTest = SessionTest;

TEST_F(FoxgloveProtocolTest, IsAskedForByBothNamesOfFoxgloveAndOurs) {
  EXPECT_EQ(protocol_.names(),
            (std::vector<std::string>{"foxglove.sdk.v1", "foxglove.websocket.v1", "pongsim.web.v1"}));
  for (const std::string& name : protocol_.names()) {
    open(name);
    EXPECT_EQ(await("serverInfo")["name"], "pongsim") << name;
  }
}

TEST_F(FoxgloveProtocolTest, LetsGoOfWhatASessionHad) {
  open();
  await("advertise");
  session_.reset();
  client_->takeTexts();
  const Publisher publisher = world_.node().advertise("/said", "StringMsg");
  world_.steps(3);
  client_->free();
  EXPECT_TRUE(client_->takeTexts().empty());
}

}  // namespace
}  // namespace pongsim::web::foxglove
