#include "web/server/waker.hh"

#include <chrono>
#include <exception>
#include <string>
#include <utility>

namespace pongsim::web {

namespace {

// Calls may add calls: so many rounds are made before sockets are served again.
constexpr int kRounds = 2;
constexpr std::chrono::microseconds kPeriod{1'000'000 / 120};

}  // namespace

Waker::Waker(lws_context* context, const Logger& log) : log_(log), context_(context) {}

void Waker::add(std::shared_ptr<Callee> callee) {
  const std::lock_guard lock(mutex_);
  if (context_ == nullptr) return;
  waiting_.push_back(std::move(callee));
  if (waiting_.size() == 1 && !isCalling_) lws_cancel_service(context_);
}

void Waker::wake() {
  const std::lock_guard lock(mutex_);
  if (context_ != nullptr) lws_cancel_service(context_);
}

std::shared_ptr<void> Waker::addRegular(std::weak_ptr<Callee> callee) {
  auto regular = std::make_shared<Regular>(Regular{std::move(callee)});
  regulars_.push_back(regular);
  if (!timer_.joinable()) timer_ = std::jthread([this](const std::stop_token& stop) { beat(stop); });
  return regular;
}

void Waker::callAll() {
  bool isDue = false;
  {
    const std::lock_guard lock(mutex_);
    isCalling_ = true;
    isDue = std::exchange(isDue_, false);
  }
  if (isDue) callRegulars();
  for (int round = 0; round < kRounds; ++round) {
    {
      const std::lock_guard lock(mutex_);
      called_.swap(waiting_);
    }
    for (const std::shared_ptr<Callee>& callee : called_) call(*callee);
    called_.clear();
  }
  const std::lock_guard lock(mutex_);
  isCalling_ = false;
  if (!waiting_.empty() && context_ != nullptr) lws_cancel_service(context_);
}

void Waker::callRegulars() {
  std::erase_if(regulars_, [](const auto& each) { return each.expired(); });
  // the called functions may add others
  for (std::size_t i = 0; i < regulars_.size(); ++i) {
    const std::shared_ptr<Regular> regular = regulars_[i].lock();
    const std::shared_ptr<Callee> callee = regular ? regular->callee.lock() : nullptr;
    if (callee) call(*callee);
  }
  if (regulars_.empty()) timer_ = {};
}

void Waker::beat(const std::stop_token& stop) {
  std::unique_lock lock(mutex_);
  while (!beats_.wait_for(lock, stop, kPeriod, [&] { return stop.stop_requested(); })) {
    isDue_ = true;
    if (context_ != nullptr) lws_cancel_service(context_);
  }
}

void Waker::call(Callee& callee) {
  // exceptions must not pass through the library, which is in C
  try {
    callee.called();
  } catch (const std::exception& error) {
    log_.warning(std::string("a message for a client can't be made: ") + error.what());
  }
}

void Waker::end() {
  timer_ = {};
  std::vector<std::shared_ptr<Callee>> left;
  const std::lock_guard lock(mutex_);
  context_ = nullptr;
  left.swap(waiting_);
}

}  // namespace pongsim::web
