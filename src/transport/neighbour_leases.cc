#include "pongsim/program/neighbour_leases.hh"

#include <mutex>
#include <new>
#include <optional>

#include "transport/leases.hh"
#include "transport/rtps_message.hh"

namespace pongsim {

struct NeighbourLeases::State {
  std::mutex mutex;
  transport::Leases leases;
};

NeighbourLeases::NeighbourLeases() : state_(std::make_unique<State>()) {}
NeighbourLeases::~NeighbourLeases() = default;

bool NeighbourLeases::admits(std::span<std::uint8_t> message, TimePoint now) try {
  const std::optional<transport::RtpsMessage> read = transport::readRtpsMessage(message);
  if (!read || !speaksForItself(*read)) return false;
  const std::lock_guard lock(state_->mutex);
  return state_->leases.hear(*read, message, now);
} catch (const std::bad_alloc&) {
  return false;
}

void NeighbourLeases::discovered(const Prefix& participant, TimePoint now) {
  const std::lock_guard lock(state_->mutex);
  state_->leases.discovered(participant, now);
}

void NeighbourLeases::removed(const Prefix& participant) {
  const std::lock_guard lock(state_->mutex);
  state_->leases.removed(participant);
}

NeighbourLeases::Endings NeighbourLeases::endings(TimePoint now) try {
  const std::lock_guard lock(state_->mutex);
  return {state_->leases.endings(now), state_->leases.nextLook(now)};
} catch (const std::bad_alloc&) {
  return {{}, now + std::chrono::seconds(1)};
}

}  // namespace pongsim
