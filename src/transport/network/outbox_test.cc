#include "transport/network/outbox.hh"

#include <gtest/gtest.h>

#include <algorithm>
#include <condition_variable>
#include <cstring>
#include <mutex>
#include <string>
#include <vector>

namespace pongsim::transport {

namespace {

/// Keeps the numbers that are sent, when it is let.
class NumberTarget final : public Outbox::Target {
 public:
  explicit NumberTarget(bool isOpen = true, bool isDroppedLast = false)
      : isOpen_(isOpen), isDroppedLast_(isDroppedLast) {}

  bool send(Buffer* sample) override {
    std::unique_lock lock(mutex_);
    opened_.wait(lock, [this] { return isOpen_; });
    int number = 0;
    std::memcpy(&number, sample->bytes.data(), sizeof number);
    sent.push_back(number);
    return false;
  }
  const std::string& topic() const override { return topic_; }
  bool isDroppedLast() const override { return isDroppedLast_; }
  std::uint64_t dropped() const { return droppedBeforeSending(); }

  void open() {
    {
      const std::lock_guard lock(mutex_);
      isOpen_ = true;
    }
    opened_.notify_all();
  }

  std::vector<int> sent;

 private:
  std::mutex mutex_;
  std::condition_variable opened_;
  bool isOpen_;
  bool isDroppedLast_;
  std::string topic_ = "/numbers";
};

void addNumber(Outbox& outbox, NumberTarget& target, int number, std::size_t size = sizeof(int)) {
  outbox.add(target, size, [&](std::span<std::byte> place) { std::memcpy(place.data(), &number, sizeof number); });
}

}  // namespace

TEST(Outbox, SendsInOrderAndSaysWhenAllIsSent) {
  Outbox outbox;
  NumberTarget target;
  std::vector<int> expected;
  for (int i = 0; i < 1000; ++i) {
    addNumber(outbox, target, i);
    expected.push_back(i);
  }
  outbox.flush(target);
  EXPECT_EQ(target.sent, expected);
}

TEST(Outbox, WaitsForNobodyAndDropsTheOldestWithAWarning) {
  Outbox outbox;
  NumberTarget closed(false);
  NumberTarget other;
  testing::internal::CaptureStderr();
  for (int i = 0; i < 30'000; ++i) addNumber(outbox, closed, i);
  addNumber(outbox, other, -1);
  const std::string said = testing::internal::GetCapturedStderr();
  EXPECT_NE(said.find("topic '/numbers': a message to other processes was dropped"), std::string::npos) << said;
  EXPECT_LT(std::count(said.begin(), said.end(), '\n'), 5);
  closed.open();
  outbox.flush(closed);
  outbox.flush(other);
  EXPECT_EQ(other.sent, std::vector{-1});
  // and those that were on their way when the first did not go through
  EXPECT_LE(closed.sent.size(), 20'000U);
  EXPECT_EQ(closed.sent.back(), 29'999);
  EXPECT_EQ(closed.sent.size() + closed.dropped(), 30'000U);
  EXPECT_EQ(other.dropped(), 0U);
  EXPECT_TRUE(std::ranges::is_sorted(closed.sent));
}

TEST(Outbox, DropsWhatMayBeDroppedFirst) {
  Outbox outbox;
  NumberTarget closed(false), replies(true, true);
  testing::internal::CaptureStderr();
  for (int i = 0; i < 30'000; ++i) {
    addNumber(outbox, closed, i);
    if (i % 100 == 0) addNumber(outbox, replies, i);
  }
  testing::internal::GetCapturedStderr();
  closed.open();
  outbox.flush(closed);
  outbox.flush(replies);
  EXPECT_EQ(replies.dropped(), 0U);
  EXPECT_EQ(replies.sent.size(), 300U);
  EXPECT_TRUE(std::ranges::is_sorted(replies.sent));
  EXPECT_GE(closed.dropped(), 10'000U);
  EXPECT_TRUE(std::ranges::is_sorted(closed.sent));
  EXPECT_EQ(closed.sent.back(), 29'999);
}

TEST(Outbox, BoundsAlsoWhatIsDroppedLast) {
  Outbox outbox;
  NumberTarget closed(false, true);
  testing::internal::CaptureStderr();
  for (int i = 0; i < 30'000; ++i) addNumber(outbox, closed, i);
  testing::internal::GetCapturedStderr();
  closed.open();
  outbox.flush(closed);
  EXPECT_GE(closed.dropped(), 10'000U);
  EXPECT_EQ(closed.sent.back(), 29'999);
}

TEST(Outbox, KeepsNoMoreBytesThanItMay) {
  Outbox outbox;
  NumberTarget closed(false);
  testing::internal::CaptureStderr();
  for (int i = 0; i < 100; ++i) addNumber(outbox, closed, i, 4 << 20);
  testing::internal::GetCapturedStderr();
  closed.open();
  outbox.flush(closed);
  EXPECT_LE(closed.sent.size(), 34U);
  EXPECT_EQ(closed.sent.back(), 99);
}

}  // namespace pongsim::transport
