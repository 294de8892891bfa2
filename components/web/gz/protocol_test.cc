#include "web/gz/protocol.hh"

#include <gtest/gtest.h>

#include "support/web/recorded_client.hh"

namespace pongsim::web::gz {
namespace {

TEST(GzProtocol, IsThatOfClientsThatNameNone) {
  const RecordedAssets assets;
  GzProtocol protocol(std::make_shared<Worlds>(), assets);
  EXPECT_EQ(protocol.names(), std::vector<std::string>{""});
}

TEST(GzProtocol, SendsAwayWhoIsOneTooMany) {
  const RecordedAssets assets;
  GzSettings settings;
  settings.maxConnections = 1;
  GzProtocol protocol(std::make_shared<Worlds>(), assets, settings);
  const auto first = std::make_shared<RecordedClient>();
  const auto second = std::make_shared<RecordedClient>();
  auto session = protocol.open("", first);
  protocol.open("", second)->text("protos,,,");
  EXPECT_EQ(first->closed().first, 0);
  EXPECT_EQ(second->closed(), (std::pair<int, std::string>(1008, "max_connections")));
  EXPECT_TRUE(second->takeBinaries().empty());
  session.reset();
  const auto third = std::make_shared<RecordedClient>();
  session = protocol.open("", third);
  EXPECT_EQ(third->closed().first, 0);
}

}  // namespace
}  // namespace pongsim::web::gz
