#include "shared/threads/outbox.hh"

#include <gtest/gtest.h>

#include <algorithm>
#include <condition_variable>
#include <cstring>
#include <mutex>
#include <string>
#include <vector>

namespace pongsim::shared {

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

/// Records what it is sent, and holds the outbox's thread on request.
class SlowTarget final : public Outbox::Target {
 public:
  explicit SlowTarget(std::size_t mostWaiting) : mostWaiting_(mostWaiting) {}

  bool send(Buffer* buffer) override {
    std::unique_lock lock(mutex_);
    int number = 0;
    std::memcpy(&number, buffer->bytes.data(), sizeof number);
    sent_.push_back(number);
    changed_.notify_all();
    changed_.wait(lock, [this] { return !isHeld_; });
    return false;
  }
  const std::string& topic() const override { return topic_; }
  std::size_t mostWaiting() const override { return mostWaiting_; }
  std::uint64_t dropped() const { return droppedBeforeSending(); }

  void hold() {
    const std::lock_guard lock(mutex_);
    isHeld_ = true;
  }
  void letGo() {
    const std::lock_guard lock(mutex_);
    isHeld_ = false;
    changed_.notify_all();
  }
  void waitForSent(std::size_t count) {
    std::unique_lock lock(mutex_);
    changed_.wait(lock, [&] { return sent_.size() >= count; });
  }
  /// Only valid after a flush.
  const std::vector<int>& sent() const { return sent_; }

 private:
  std::size_t mostWaiting_;
  std::mutex mutex_;
  std::condition_variable changed_;
  bool isHeld_ = false;
  std::vector<int> sent_;
  std::string topic_ = "/slow";
};

void addNumber(Outbox& outbox, Outbox::Target& target, int number, std::size_t size = sizeof(int)) {
  outbox.add(target, size, [&](std::span<std::byte> place) { std::memcpy(place.data(), &number, sizeof number); });
}

}  // namespace

TEST(Outbox, SendsInOrderAndSaysWhenAllIsSent) {
  Outbox outbox({});
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
  Outbox outbox({});
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
  Outbox outbox({});
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
  Outbox outbox({});
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
  Outbox outbox({});
  NumberTarget closed(false);
  testing::internal::CaptureStderr();
  for (int i = 0; i < 100; ++i) addNumber(outbox, closed, i, 4 << 20);
  testing::internal::GetCapturedStderr();
  closed.open();
  outbox.flush(closed);
  EXPECT_LE(closed.sent.size(), 34U);
  EXPECT_EQ(closed.sent.back(), 99);
}

TEST(Outbox, KeepsTheNewestOfATargetWhileAnotherIsBeingSent) {
  Outbox outbox({});
  SlowTarget target(1);
  target.hold();
  addNumber(outbox, target, 1);
  target.waitForSent(1);
  addNumber(outbox, target, 2);
  EXPECT_EQ(target.dropped(), 0U);
  addNumber(outbox, target, 3);
  EXPECT_EQ(target.dropped(), 1U);
  target.letGo();
  outbox.flush(target);
  EXPECT_EQ(target.sent(), (std::vector<int>{1, 3}));
}

TEST(Outbox, DropsTheOldestOfATargetWithALimitOnly) {
  Outbox outbox({Outbox::kUnlimited, Outbox::kUnlimited});
  SlowTarget slow(2), other(2);
  slow.hold();
  addNumber(outbox, slow, 1);
  slow.waitForSent(1);
  addNumber(outbox, other, 10);
  for (int i = 2; i <= 5; ++i) addNumber(outbox, slow, i);
  addNumber(outbox, other, 11);
  slow.letGo();
  outbox.flush(slow);
  outbox.flush(other);
  EXPECT_EQ(slow.sent(), (std::vector<int>{1, 4, 5}));
  EXPECT_EQ(slow.dropped(), 2U);
  EXPECT_EQ(other.sent(), (std::vector<int>{10, 11}));
  EXPECT_EQ(other.dropped(), 0U);
}

}  // namespace pongsim::shared
