#include "log/command/recording.hh"

#include <gtest/gtest.h>
#include <ignition/msgs/int32.pb.h>
#include <ignition/msgs/stringmsg.pb.h>

#include <string>
#include <vector>

#include "log/store/failure.hh"
#include "support/test_domain.hh"
#include "support/wait_until.hh"

namespace pongsim::log {
namespace {

using ignition::msgs::Int32;
using ignition::msgs::StringMsg;

/// Keeps topics and messages, as "/topic TYPE TEXT".
class KeptRecords : public Writer {
 public:
  void write(const Record& record) override {
    if (isFull) throw Failure("the disk is full");
    StringMsg message;
    message.ParseFromArray(record.payload.data(), static_cast<int>(record.payload.size()));
    kept.push_back(std::string(record.topic) + " " + std::string(record.type) + " " + message.data());
    EXPECT_GT(record.timeNs, 0);
  }
  void close() override {}

  std::vector<std::string> kept;
  bool isFull = false;
};

class RecordingTest : public testing::Test {
 protected:
  /// Continues recording while messages are published, until the condition holds.
  bool recordUntil(Recording& recording, const std::function<void()>& publish, const std::function<bool()>& condition) {
    return test::waitUntil([&] {
      publish();
      recording.goOn();
      return condition();
    });
  }
  static StringMsg said(const std::string& text) {
    StringMsg message;
    message.set_data(text);
    return message;
  }

  const int domain_ = test::testDomain();
  Transport speaker_{{.domain = domain_}};
  Node node_ = speaker_.node();
  Transport listener_{{.domain = domain_}};
  KeptRecords log_;
};

TEST_F(RecordingTest, FindsTopicsByExpressions) {
  const TopicChoice choice({".*/odometry"});
  Recording recording(listener_, log_, choice);
  Publisher odometry = node_.advertise<StringMsg>("/a/odometry");
  Publisher other = node_.advertise<StringMsg>("/b");
  EXPECT_TRUE(recordUntil(
      recording,
      [&] {
        other.publish(said("no"));
        odometry.publish(said("yes"));
      },
      [&] { return recording.messages() > 2; }));
  EXPECT_EQ(recording.messages(), log_.kept.size());
  for (const std::string& each : log_.kept) EXPECT_EQ(each, "/a/odometry ignition.msgs.StringMsg yes");
  EXPECT_EQ(recording.topics(), 1U);
  EXPECT_TRUE(recording.hasHeard("/a/odometry"));
  EXPECT_FALSE(recording.hasHeard("/b"));
  EXPECT_TRUE(recording.lost().empty());
}

TEST_F(RecordingTest, ListensToATopicThatIsNotThereYet) {
  const TopicChoice choice({"/late"});
  Recording recording(listener_, log_, choice);
  recording.goOn();
  EXPECT_EQ(recording.messages(), 0U);
  Publisher late = node_.advertise<StringMsg>("/late");
  EXPECT_TRUE(recordUntil(
      recording, [&] { late.publish(said("here")); }, [&] { return recording.messages() > 0; }));
  EXPECT_TRUE(recording.hasHeard("/late"));
}

TEST_F(RecordingTest, LeavesAloneWhatCantBeWritten) {
  const TopicChoice choice({});
  Recording recording(listener_, log_, choice,
                      [](std::string_view, std::string_view type) { return type == "ignition.msgs.StringMsg"; });
  Publisher number = node_.advertise<Int32>("/number");
  Publisher text = node_.advertise<StringMsg>("/text");
  EXPECT_TRUE(recordUntil(
      recording,
      [&] {
        number.publish(Int32());
        text.publish(said("a"));
      },
      [&] { return recording.messages() > 2; }));
  EXPECT_FALSE(recording.hasHeard("/number"));
  EXPECT_TRUE(recording.hasHeard("/text"));
}

TEST_F(RecordingTest, SaysThatTheLogCantBeWritten) {
  const TopicChoice choice({"/text"});
  Recording recording(listener_, log_, choice);
  log_.isFull = true;
  Publisher text = node_.advertise<StringMsg>("/text");
  const auto fails = [&] {
    try {
      text.publish(said("a"));
      recording.goOn();
      return false;
    } catch (const Failure& failure) {
      EXPECT_STREQ(failure.what(), "the disk is full");
      return true;
    }
  };
  EXPECT_TRUE(test::waitUntil(fails));
  EXPECT_EQ(recording.messages(), 0U);
}

}  // namespace
}  // namespace pongsim::log
