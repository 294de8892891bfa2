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

// Reporting ends after this time without a reader.
constexpr std::chrono::seconds kAskerPatience{2};

}  // namespace

TrafficReporter::TrafficReporter(std::function<std::unique_ptr<Writer>(std::function<void()>)> makeWriter)
    : makeWriter_(std::move(makeWriter)) {}

TrafficReporter::~TrafficReporter() { stop(); }

void TrafficReporter::setSource(std::function<TrafficReport()> source) {
  const Lock lock(sourceMutex_);
  source_ = std::move(source);
}

void TrafficReporter::ask() {
  const Lock lock(mutex_);
  if (isOver_) return;
  isAsked_ = true;
  // on its own thread: an endpoint can't be made in a callback of DDS
  if (!thread_.joinable()) thread_ = std::thread([this] { run(); });
  changed_.notify_one();
}

void TrafficReporter::stop() {
  {
    const Lock lock(mutex_);
    isOver_ = true;
  }
  changed_.notify_one();
  if (thread_.joinable()) thread_.join();
}

void TrafficReporter::run() {
  Lock lock(mutex_);
  while (true) {
    changed_.wait(lock, [this]() REQUIRES(mutex_) { return isOver_ || isAsked_; });
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

/// Reports until nobody asks any more. Without the mutex: the writer's destructor waits for callbacks that lock it.
void TrafficReporter::answer() {
  const std::unique_ptr<Writer> writer = makeWriter_([this] {
    {
      const Lock changeLock(mutex_);
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
    Lock lock(mutex_);
    changed_.wait_for(lock, kReportPeriod, [this]() REQUIRES(mutex_) { return isOver_ || haveReadersChanged_; });
    haveReadersChanged_ = false;
    isOver = isOver_;
  }
}

void TrafficReporter::report(Writer& writer) {
  std::vector<std::byte> bytes;
  {
    const Lock lock(sourceMutex_);
    if (!source_) return;
    bytes = trafficBytes(source_());
  }
  writer.write(bytes.size(), [&bytes](std::span<std::byte> place) { std::ranges::copy(bytes, place.begin()); });
}

}  // namespace pongsim::transport
