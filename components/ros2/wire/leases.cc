#include "ros2/wire/leases.hh"

#include <algorithm>
#include <optional>

namespace pongsim::ros2 {

namespace {

constexpr std::chrono::seconds kLatestLook{1};
// not for each of many
constexpr std::chrono::milliseconds kSoonestLook{10};

}  // namespace

void Leases::receive(std::span<unsigned char> packet, TimePoint now, const HandOn& handOn) {
  const std::optional<Presence> presence = readPresence(packet);
  if (!presence) return;
  std::unique_lock turn(turn_, std::defer_lock);
  if (!presence->announcements.empty()) turn.lock();
  if (note(*presence, now)) handOn(packet);
}

/// @return Whether no lease is over of those that the message tells of.
bool Leases::note(const Presence& presence, TimePoint now) {
  const std::lock_guard lock(mutex_);
  const auto isOver = [&](const GuidPrefix& prefix) {
    const auto found = neighbours_.find(prefix);
    return found != neighbours_.end() && found->second.isOver(now);
  };
  if (std::ranges::any_of(presence.senders, isOver)) return false;
  if (std::ranges::any_of(presence.announcements, isOver, &Announcement::participant)) return false;
  for (const GuidPrefix& sender : presence.senders) {
    if (const auto found = neighbours_.find(sender); found != neighbours_.end()) found->second.heard = now;
  }
  for (const Announcement& each : presence.announcements) {
    if (each.lease) {
      neighbours_[each.participant] = {now, *each.lease};
    } else if (const auto found = neighbours_.find(each.participant); found != neighbours_.end()) {
      // Fast DDS 2.9 makes nothing of Cyclone's goodbye
      found->second.lease = std::chrono::nanoseconds(0);
    }
  }
  return true;
}

Leases::TimePoint Leases::end(TimePoint now, const HandOn& handOn) {
  {
    const std::lock_guard turn(turn_);
    for (const std::vector<unsigned char>& each : takeEnded(now)) handOn(each);
  }
  const std::lock_guard lock(mutex_);
  TimePoint next = now + kLatestLook;
  for (const auto& [prefix, neighbour] : neighbours_) next = std::min(next, neighbour.heard + neighbour.lease);
  return std::max(next, now + kSoonestLook);
}

/// @return Their goodbyes.
std::vector<std::vector<unsigned char>> Leases::takeEnded(TimePoint now) {
  std::vector<std::vector<unsigned char>> goodbyes;
  const std::lock_guard lock(mutex_);
  std::erase_if(neighbours_, [&](const auto& each) {
    const auto& [prefix, neighbour] = each;
    if (!neighbour.isOver(now)) return false;
    goodbyes.push_back(goodbye(prefix, ++goodbyes_));
    return true;
  });
  return goodbyes;
}

std::size_t Leases::size() const {
  const std::lock_guard lock(mutex_);
  return neighbours_.size();
}

}  // namespace pongsim::ros2
