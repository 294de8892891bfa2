#include "transport/services/gateways.hh"

#include <algorithm>
#include <chrono>
#include <mutex>
#include <utility>

namespace pongsim::transport {

std::uint64_t Gateways::add(CallElsewhere call) {
  const std::lock_guard lock(mutex_);
  gateways_.emplace(next_, std::move(call));
  isEmpty_ = false;
  return next_++;
}

void Gateways::end(std::uint64_t number) {
  const std::lock_guard lock(mutex_);
  gateways_.erase(number);
  isEmpty_ = gateways_.empty();
}

std::optional<CallResult> Gateways::call(const std::string& service, const Message& request, Message& reply,
                                         TimePoint deadline) {
  if (isEmpty_) return std::nullopt;
  const std::shared_lock lock(mutex_);
  for (const auto& [number, gateway] : gateways_) {
    const auto left = std::max(deadline - std::chrono::steady_clock::now(), std::chrono::steady_clock::duration(0));
    if (std::optional<CallResult> result = gateway(service, request, reply, left)) return result;
  }
  return std::nullopt;
}

}  // namespace pongsim::transport
