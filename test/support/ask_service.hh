#pragma once

#include <atomic>
#include <chrono>
#include <cstddef>
#include <functional>
#include <string>
#include <string_view>
#include <thread>

#include "pongsim/node.hh"
#include "support/process.hh"

namespace pongsim::test {

/// Calls a service that this thread offers on the same transport, from another thread, and dispatches until the
/// response.
/// @param between Called after each dispatch, as a run calls its work.
inline CallResult askService(Transport& transport, std::string_view service, const Message& request, Message& reply,
                             const std::function<void()>& between = {}) {
  std::atomic<bool> answered = false;
  CallResult result;
  std::thread caller([&] {
    result = transport.node().call(service, request, reply, kDeadline);
    answered = true;
    transport.wake();
  });
  while (!answered) {
    transport.dispatchFor(std::chrono::milliseconds(20));
    if (between) between();
  }
  caller.join();
  return result;
}

/// @return Why the service refused, or the error of another kind; empty if the call succeeded.
inline std::string refusalOf(const CallResult& result) {
  constexpr std::string_view kBefore = " refused: ";
  const std::size_t place = result.error.find(kBefore);
  return place == std::string::npos ? result.error : result.error.substr(place + kBefore.size());
}

}  // namespace pongsim::test
