#include "pongsim/background_calls.hh"

#include <exception>
#include <optional>
#include <utility>

namespace pongsim {

BackgroundCalls::BackgroundCalls(const Node& node, const Logger& log, std::size_t mostWaiting)
    : node_(node), log_(log), mostWaiting_(mostWaiting) {}

BackgroundCalls::~BackgroundCalls() = default;

bool BackgroundCalls::post(Call call) {
  {
    const std::lock_guard lock(mutex_);
    if (waiting_.size() >= mostWaiting_) {
      log_.warning("service '" + call.service + "' was not called: " + std::to_string(mostWaiting_) +
                   " calls are already waiting");
      return false;
    }
    waiting_.push_back(std::move(call));
  }
  changed_.notify_one();
  if (!worker_.joinable()) worker_ = std::jthread([this](const std::stop_token& stop) { work(stop); });
  return true;
}

void BackgroundCalls::work(const std::stop_token& stop) {
  while (true) {
    std::optional<Call> call;
    {
      std::unique_lock lock(mutex_);
      if (!changed_.wait(lock, stop, [this] { return !waiting_.empty(); })) return;
      call = std::move(waiting_.front());
      waiting_.pop_front();
    }
    if (stop.stop_requested()) return;
    make(*call);
  }
}

void BackgroundCalls::make(const Call& call) {
  try {
    const MessagePointer reply = newMessage(call.replyType);
    const CallResult result = node_.call(call.service, *call.request, *reply, call.timeout);
    if (call.done) {
      call.done(result, *reply);
    } else if (!result) {
      log_.warning(result.error);
    }
  } catch (const std::exception& error) {
    log_.warning("service '" + call.service + "' can't be called: " + error.what());
  }
}

}  // namespace pongsim
