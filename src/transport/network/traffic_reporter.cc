#include "transport/network/traffic_reporter.hh"

#include <algorithm>
#include <chrono>
#include <exception>
#include <span>
#include <string>
#include <utility>
#include <vector>

#include "pongsim/log.hh"
#include "transport/deadline.hh"
#include "transport/network/endpoint.hh"

namespace pongsim::transport {

namespace {

constexpr std::chrono::milliseconds kReportPeriod{100};

// An asker whose reader is not found by then has gone.
constexpr std::chrono::seconds kAskerPatience{2};

}  // namespace

TrafficReporter::TrafficReporter(std::function<std::unique_ptr<Writer>(std::function<void()>)> makeWriter)
    : makeWriter_(std::move(makeWriter)) {}

TrafficReporter::~TrafficReporter() { stop(); }

void TrafficReporter::setSource(std::function<TrafficReport()> source) {
  const std::lock_guard lock(sourceMutex_);
  source_ = std::move(source);
}

void TrafficReporter::ask() {
  const std::lock_guard lock(mutex_);
  if (isOver_) return;
  isAsked_ = true;
  // a thread, for an endpoint can't be made in a call of DDS's
  if (!thread_.joinable()) thread_ = std::thread([this] { run(); });
  changed_.notify_one();
}

void TrafficReporter::stop() {
  {
    const std::lock_guard lock(mutex_);
    isOver_ = true;
  }
  changed_.notify_one();
  if (thread_.joinable()) thread_.join();
}

void TrafficReporter::run() {
  std::unique_lock lock(mutex_);
  while (true) {
    changed_.wait(lock, [this] { return isOver_ || isAsked_; });
    if (isOver_) return;
    isAsked_ = false;
    lock.unlock();
    try {
      answer();
    } catch (const std::exception& error) {
      static const Logger log("transport");
      log.warning(std::string("can't report the traffic of topics: ") + error.what());
    }
    lock.lock();
  }
}

/// Until nobody asks any more. The writer's end waits for calls that take the mutex, which is not held therefore.
void TrafficReporter::answer() {
  const std::unique_ptr<Writer> writer = makeWriter_([this] {
    {
      const std::lock_guard changeLock(mutex_);
      haveReadersChanged_ = true;
    }
    changed_.notify_one();
  });
  TimePoint patience = deadlineAfter(kAskerPatience);
  for (bool isOver = false; !isOver && std::chrono::steady_clock::now() < patience;) {
    if (writer->hasReaders()) {
      report(*writer);
      patience = deadlineAfter(kAskerPatience);
    }
    std::unique_lock lock(mutex_);
    changed_.wait_for(lock, kReportPeriod, [this] { return isOver_ || haveReadersChanged_; });
    haveReadersChanged_ = false;
    isOver = isOver_;
  }
}

void TrafficReporter::report(Writer& writer) {
  std::vector<std::byte> bytes;
  {
    const std::lock_guard lock(sourceMutex_);
    if (!source_) return;
    bytes = trafficBytes(source_());
  }
  writer.write(bytes.size(), [&bytes](std::span<std::byte> place) { std::ranges::copy(bytes, place.begin()); });
}

}  // namespace pongsim::transport
