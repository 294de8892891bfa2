#include "msgs/control/control_messages.hh"

#include <gtest/gtest.h>
#include <ignition/msgs/boolean.pb.h>
#include <ignition/msgs/int32.pb.h>
#include <ignition/msgs/stringmsg_v.pb.h>

namespace pongsim::msgs {
namespace {

WorldControl control(const std::string& text) {
  const MessagePointer message = newMessage("WorldControl");
  EXPECT_FALSE(parseMessage(text, *message)) << text;
  return worldControl(*message);
}

ServerControl server(const std::string& text) {
  const MessagePointer message = newMessage("ServerControl");
  EXPECT_FALSE(parseMessage(text, *message)) << text;
  return serverControl(*message);
}

TEST(ControlMessages, ReadWhatIsAskedOfAWorld) {
  EXPECT_FALSE(control("").pause);
  EXPECT_EQ(control("").steps, 0U);
  EXPECT_FALSE(control("").runTo);
  EXPECT_TRUE(control("pause: true").pause);
  EXPECT_EQ(control("multi_step: 5").steps, 5U);
  EXPECT_EQ(control("step: true").steps, 1U);
  EXPECT_EQ(control("step: true, multi_step: 5").steps, 5U);
  EXPECT_EQ(control("run_to_sim_time {sec: 2 nsec: 500000000}").runTo, std::chrono::milliseconds(2500));
  EXPECT_EQ(control("seed: 3").seed, 3U);
}

TEST(ControlMessages, KnowAResetFromAnEmptyOne) {
  EXPECT_EQ(control("reset {}").reset, Reset::kNone);
  EXPECT_EQ(control("reset {all: true}").reset, Reset::kAll);
  EXPECT_EQ(control("reset {time_only: true}").reset, Reset::kTimeOnly);
  EXPECT_EQ(control("reset {model_only: true}").reset, Reset::kModelsOnly);
}

TEST(ControlMessages, TakeTimesThatDoNotFit) {
  EXPECT_GT(control("run_to_sim_time {sec: 9223372036854775807}").runTo, std::chrono::hours(24 * 365 * 100));
  EXPECT_LT(control("run_to_sim_time {sec: -9223372036854775808}").runTo, Time::zero());
}

TEST(ControlMessages, ReadWhatIsAskedOfTheServer) {
  EXPECT_TRUE(server("stop: true").stop);
  EXPECT_FALSE(server("stop: true").more);
  EXPECT_FALSE(server("").stop);
  for (const char* text : {"clone: true", "new_port: 1", "save_filename: 'a'", "open_filename: 'a'",
                           "save_world_name: 'a'", "new_world: true"}) {
    EXPECT_TRUE(server(text).more) << text;
  }
}

TEST(ControlMessages, AskAsTheyAreRead) {
  const WorldControl asked{.pause = true, .steps = 3, .runTo = std::chrono::milliseconds(1500)};
  const MessagePointer message = worldControlMessage(asked);
  const WorldControl read = worldControl(*message);
  EXPECT_TRUE(read.pause);
  EXPECT_EQ(read.steps, 3U);
  EXPECT_EQ(read.runTo, asked.runTo);
}

TEST(ControlMessages, CarryPlainValues) {
  const MessagePointer answer = newMessage("Boolean");
  for (const bool value : {true, false}) {
    setBoolean(value, *answer);
    EXPECT_EQ(boolean(*answer), value);
  }
  const MessagePointer names = newMessage("StringMsg_V");
  addString("a", *names);
  addString("b", *names);
  EXPECT_EQ(static_cast<const ignition::msgs::StringMsg_V&>(*names).data_size(), 2);
  EXPECT_EQ(static_cast<const ignition::msgs::Int32&>(*int32Message(-7)).data(), -7);
}

}  // namespace
}  // namespace pongsim::msgs
