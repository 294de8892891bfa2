#include "msgs/control/status_messages.hh"

#include <gtest/gtest.h>

#include <chrono>

#include "pongsim/message.hh"

namespace pongsim::msgs {
namespace {

using namespace std::chrono_literals;

constexpr Status kStatus{.simulated = 2s + 5ms,
                         .real = 3s,
                         .system = 100s + 1ns,
                         .iterations = 2005,
                         .realTimeFactor = 0.66666,
                         .paused = true};

TEST(StatusMessages, GiveTheThreeTimesInTheClock) {
  StatusMessages messages;
  EXPECT_EQ(messageJson(messages.clock(kStatus)),
            R"({"system":{"sec":"100","nsec":1},"real":{"sec":"3"},"sim":{"sec":"2","nsec":5000000}})");
}

TEST(StatusMessages, GiveTheRunsStateInTheStatistics) {
  StatusMessages messages;
  const std::string text = messageText(messages.statistics(kStatus));
  EXPECT_NE(text.find("iterations: 2005\n"), std::string::npos) << text;
  EXPECT_NE(text.find("paused: true\n"), std::string::npos) << text;
  EXPECT_NE(text.find("real_time_factor: 0.6667\n"), std::string::npos) << text;
  EXPECT_NE(text.find("sim_time {\n  sec: 2\n  nsec: 5000000\n}\n"), std::string::npos) << text;
}

TEST(StatusMessages, AreReadAsTheyAreMade) {
  StatusMessages messages;
  const Status read = statusOf(messages.statistics(kStatus));
  EXPECT_EQ(read.simulated, kStatus.simulated);
  EXPECT_EQ(read.real, kStatus.real);
  EXPECT_EQ(read.iterations, kStatus.iterations);
  EXPECT_EQ(read.realTimeFactor, 0.6667);
  EXPECT_TRUE(read.paused);
}

TEST(StatusMessages, AreMadeAnewEachTime) {
  StatusMessages messages;
  messages.statistics(kStatus);
  EXPECT_EQ(messageText(messages.statistics({.iterations = 1})).find("paused"), std::string::npos);
}

TEST(StatusMessages, TellASensorsRates) {
  const MessagePointer message = newMessage("ignition.msgs.PerformanceSensorMetrics");
  setSensorName("m::l::s", *message);
  setRates({.simulated = 50, .real = 75, .nominal = 60}, *message);
  EXPECT_EQ(messageText(*message),
            "name: \"m::l::s\"\nreal_update_rate: 75\nsim_update_rate: 50\nnominal_update_rate: 60\n");
  setRates({.pictures = 20}, *message);
  EXPECT_NE(messageText(*message).find("fps_optional {\n  data: 20\n}\n"), std::string::npos);
}

}  // namespace
}  // namespace pongsim::msgs
