#include "ign/replies.hh"

#include <atomic>
#include <chrono>
#include <thread>

namespace pongsim::ign {

namespace {

using Clock = std::chrono::steady_clock;

constexpr std::chrono::milliseconds kTimeToLeave{500};

std::atomic<Clock::rep> last = 0;

}  // namespace

void replyGiven() { last = Clock::now().time_since_epoch().count(); }

void awaitReplies() {
  const Clock::rep given = last;
  if (given != 0) std::this_thread::sleep_until(Clock::time_point(Clock::duration(given)) + kTimeToLeave);
}

}  // namespace pongsim::ign
