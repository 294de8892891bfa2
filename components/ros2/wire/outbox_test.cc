#include "ros2/wire/outbox.hh"

#include <gtest/gtest.h>

#include <condition_variable>
#include <mutex>
#include <vector>

namespace pongsim::ros2 {
namespace {

/// Records what it is sent, and blocks the outbox's thread on request.
class SlowTarget final : public Outbox::Target {
 public:
  SlowTarget(Outbox& outbox, std::size_t depth) : outbox_(outbox), depth_(depth) {}

  void send(Buffer* buffer, const SampleId&) override {
    std::unique_lock lock(mutex_);
    sent_.push_back(static_cast<int>(buffer->bytes[0]));
    changed_.notify_all();
    changed_.wait(lock, [this] { return !isHeld_; });
    outbox_.buffers().giveBack(buffer);
  }
  std::size_t mostWaiting() const override { return depth_; }
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
  Outbox& outbox_;
  std::size_t depth_;
  std::mutex mutex_;
  std::condition_variable changed_;
  bool isHeld_ = false;
  std::vector<int> sent_;
};

void add(Outbox& outbox, SlowTarget& target, int number) {
  Buffer* buffer = outbox.buffers().take(1);
  buffer->bytes[0] = static_cast<std::byte>(number);
  outbox.add(target, buffer, {});
}

TEST(OutboxTest, KeepsTheNewestWhileAnotherIsBeingSent) {
  Outbox outbox;
  SlowTarget target(outbox, 1);
  target.hold();
  add(outbox, target, 1);
  target.waitForSent(1);
  add(outbox, target, 2);
  EXPECT_EQ(target.dropped(), 0u);
  add(outbox, target, 3);
  EXPECT_EQ(target.dropped(), 1u);
  target.letGo();
  outbox.flush(target);
  EXPECT_EQ(target.sent(), (std::vector<int>{1, 3}));
}

TEST(OutboxTest, DropsTheOldestOfTheSameTargetOnly) {
  Outbox outbox;
  SlowTarget slow(outbox, 2), other(outbox, 2);
  slow.hold();
  add(outbox, slow, 1);
  slow.waitForSent(1);
  add(outbox, other, 10);
  for (int i = 2; i <= 5; ++i) add(outbox, slow, i);
  add(outbox, other, 11);
  slow.letGo();
  outbox.flush(slow);
  outbox.flush(other);
  EXPECT_EQ(slow.sent(), (std::vector<int>{1, 4, 5}));
  EXPECT_EQ(slow.dropped(), 2u);
  EXPECT_EQ(other.sent(), (std::vector<int>{10, 11}));
  EXPECT_EQ(other.dropped(), 0u);
}

}  // namespace
}  // namespace pongsim::ros2
