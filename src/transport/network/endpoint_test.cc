#include "transport/network/endpoint.hh"

#include <gtest/gtest.h>

#include <atomic>
#include <chrono>
#include <cstddef>
#include <thread>
#include <vector>

#include "support/process.hh"
#include "support/test_domain.hh"
#include "transport/network/network.hh"

namespace pongsim::transport {

namespace {

constexpr const char* kBusyTopic = "/busy";
constexpr const char* kBusyType = "ignition.msgs.StringMsg";

}  // namespace

// Fast DDS 2.9 has two threads wait for each other for ever where a writer removes a sample while it is told that a
// reader has gone (Fast-DDS pull request 3468).
TEST(Writer, GoesOnWritingWhileReadersComeAndGo) {
  Network writing(test::testDomain());
  Network reading(test::testDomain());
  std::vector<std::unique_ptr<Writer>> writers;
  for (int i = 0; i < 4; ++i) writers.push_back(writing.makeWriter(kBusyTopic, kBusyType, nullptr));

  std::atomic<bool> isOver = false;
  std::atomic<std::uint64_t> written = 0;
  std::thread writer([&] {
    while (!isOver) {
      for (const auto& each : writers) each->write(64, [](std::span<std::byte>) {});
      ++written;
      std::this_thread::sleep_for(std::chrono::microseconds(100));  // its rate
    }
  });

  for (int i = 0; i < 100; ++i) {
    std::atomic<int> heard = 0;
    auto reader = reading.makeReader(kBusyTopic, kBusyType, [&](auto&&...) { ++heard; });
    const auto deadline = std::chrono::steady_clock::now() + test::kDeadline;
    while (heard < 4 && std::chrono::steady_clock::now() < deadline) std::this_thread::yield();
    EXPECT_GE(heard, 4) << "reader " << i << " after " << written << " messages";
    reading.end(std::move(reader));
    if (HasFailure()) break;
  }
  // a writer that hangs can't be joined: the test's own time limit ends it
  isOver = true;
  writer.join();
  for (auto& each : writers) writing.end(std::move(each));
}

}  // namespace pongsim::transport
