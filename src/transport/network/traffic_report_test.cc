#include "transport/network/traffic_report.hh"

#include <gtest/gtest.h>

#include <string>
#include <vector>

namespace pongsim::transport {

namespace {

TrafficReport someTraffic() {
  return {std::chrono::nanoseconds(123456789012345),
          {{"/clock", "ignition.msgs.Clock", Role::kPublisher, 1'000'000'000'000, 3},
           {"/cmd_vel", "", Role::kSubscriber, 0, 0}}};
}

}  // namespace

TEST(TrafficReport, ComesBackFromItsBytes) {
  EXPECT_EQ(readTraffic(trafficBytes(someTraffic())), someTraffic());
  EXPECT_EQ(readTraffic(trafficBytes({})), TrafficReport());
}

TEST(TrafficReport, TellsNamesNoLongerThanItCan) {
  TrafficReport report = someTraffic();
  report.endpoints[0].topic = std::string(70'000, 'x');
  const auto read = readTraffic(trafficBytes(report));
  ASSERT_TRUE(read);
  EXPECT_EQ(read->endpoints[0].topic.size(), 65'535);
  EXPECT_EQ(read->endpoints[1], report.endpoints[1]);
}

TEST(TrafficReport, RefusesWhatIsTruncatedOrWrong) {
  const std::vector<std::byte> good = trafficBytes(someTraffic());
  int whole = 0;
  for (std::size_t size = 0; size < good.size(); ++size) whole += readTraffic({good.data(), size}) ? 1 : 0;
  // where the time ends, and where the first endpoint does
  EXPECT_EQ(whole, 2);
  std::vector<std::byte> wrongRole = good;
  wrongRole[8] = std::byte{2};
  EXPECT_FALSE(readTraffic(wrongRole));
  std::vector<std::byte> wrongLength = good;
  wrongLength[10] = std::byte{0xff};
  EXPECT_FALSE(readTraffic(wrongLength));
}

}  // namespace pongsim::transport
