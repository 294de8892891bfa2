#include "sim/running/status_publisher.hh"

namespace pongsim::sim {

namespace {

constexpr std::string_view kClockType = "ignition.msgs.Clock";
constexpr std::string_view kStatisticsType = "ignition.msgs.WorldStatistics";

}  // namespace

StatusPublisher::StatusPublisher(Transport& transport, const std::string& worldName, bool isFirst)
    : clock_(isFirst ? transport.node().advertise("/clock", kClockType) : Publisher()),
      statistics_(isFirst ? transport.node().advertise("/stats", kStatisticsType) : Publisher()),
      worldClock_(transport.node().advertise(cleanTopic("/world/" + worldName + "/clock"), kClockType)),
      worldStatistics_(transport.node().advertise(cleanTopic("/world/" + worldName + "/stats"), kStatisticsType)) {}

void StatusPublisher::publish(const msgs::Status& status, std::chrono::steady_clock::time_point now) {
  if (clock_.hasSubscribers()) clock_.publish(messages_.clock(status));
  if (worldClock_.hasSubscribers()) worldClock_.publish(messages_.clock(status));
  if (statistics_.hasSubscribers()) statistics_.publish(messages_.statistics(status));
  if (now >= nextWorldStatistics_ && worldStatistics_.hasSubscribers()) {
    worldStatistics_.publish(messages_.statistics(status));
    nextWorldStatistics_ = now + kWorldStatisticsPeriod;
  }
}

}  // namespace pongsim::sim
