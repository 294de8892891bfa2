#include "transport/udp/announcements.hh"

#include <algorithm>

namespace pongsim::transport {

namespace {

// Less than the period of announcements, and more than the time in which a crowd meets.
constexpr std::chrono::seconds kOnce{1};

// How long the list of open ports is used. It may be old: whoever opens a port announces itself.
constexpr std::chrono::milliseconds kLook{100};

}  // namespace

bool Announcements::goesTo(std::uint32_t port, std::uint64_t sequence, TimePoint now) {
  const std::lock_guard lock(mutex_);
  if (ignored_.contains(port)) return false;
  const auto found = sent_.find(port);
  const bool isMet = found != sent_.end() && !found->second;
  if (!isMet) {
    const bool isSame = found != sent_.end() && found->second->sequence == sequence && now - found->second->at < kOnce;
    if (isSame || !isOpen(port, now)) return false;
  }
  sent_[port] = Sent{sequence, now};
  return true;
}

void Announcements::met(std::uint32_t port) {
  const std::lock_guard lock(mutex_);
  sent_[port].reset();
}

void Announcements::ignore(std::uint32_t port) {
  const std::lock_guard lock(mutex_);
  ignored_.insert(port);
}

bool Announcements::isOpen(std::uint32_t port, TimePoint now) {
  if (!looked_ || now - *looked_ >= kLook) {
    open_ = look_();
    looked_ = now;
  }
  return !open_ || std::ranges::find(*open_, port) != open_->end();
}

}  // namespace pongsim::transport
