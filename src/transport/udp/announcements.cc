#include "transport/udp/announcements.hh"

#include <algorithm>

namespace pongsim::transport {

namespace {

// Minimum interval between two transmissions of one announcement to a port. It is shorter than the announcement period,
// and longer than the time in which many participants that start together discover each other.
constexpr std::chrono::seconds kAnnouncementInterval{1};

// Maximum age of the list of open ports. A participant that opens a port after that announces itself, so an old list
// delays no discovery.
constexpr std::chrono::milliseconds kListAge{100};

}  // namespace

bool Announcements::goesTo(std::uint32_t port, std::uint64_t sequence, TimePoint now) {
  const std::lock_guard lock(mutex_);
  if (ignored_.contains(port)) return false;
  const auto found = sent_.find(port);
  const bool isNew = found != sent_.end() && !found->second;
  if (!isNew) {
    const bool isSame =
        found != sent_.end() && found->second->sequence == sequence && now - found->second->at < kAnnouncementInterval;
    if (isSame || !isOpen(port, now)) return false;
  }
  sent_[port] = Sent{sequence, now};
  return true;
}

void Announcements::discovered(std::uint32_t port) {
  const std::lock_guard lock(mutex_);
  sent_[port].reset();
}

void Announcements::ignore(std::uint32_t port) {
  const std::lock_guard lock(mutex_);
  ignored_.insert(port);
}

bool Announcements::isOpen(std::uint32_t port, TimePoint now) {
  if (!listedAt_ || now - *listedAt_ >= kListAge) {
    open_ = listOpenPorts_();
    listedAt_ = now;
  }
  return !open_ || std::ranges::find(*open_, port) != open_->end();
}

}  // namespace pongsim::transport
