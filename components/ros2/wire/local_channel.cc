#include "ros2/wire/local_channel.hh"

#include <fastrtps/utils/IPLocator.h>
#include <netinet/in.h>
#include <poll.h>
#include <sys/eventfd.h>
#include <sys/socket.h>
#include <unistd.h>

#include <algorithm>
#include <chrono>
#include <cstring>
#include <span>
#include <stdexcept>
#include <utility>

namespace pongsim::ros2 {

LocalChannel::LocalChannel(std::vector<UdpSocket> sockets, const Locator& at, Receiver& receiver, DiscoveryGuard& guard,
                           bool endsLeases, std::size_t largest)
    : sockets_(std::move(sockets)),
      at_(at),
      receiver_(receiver),
      guard_(guard),
      endsLeases_(endsLeases),
      packet_(largest),
      wake_(eventfd(0, EFD_CLOEXEC | EFD_NONBLOCK)) {
  if (wake_ < 0) throw std::runtime_error("no more file descriptors");
  thread_ = std::thread([this] { run(); });
}

LocalChannel::~LocalChannel() {
  isOver_ = true;
  eventfd_write(wake_, 1);
  thread_.join();
  close(wake_);
}

void LocalChannel::run() {
  std::vector<pollfd> waited{{wake_, POLLIN, 0}};
  for (const UdpSocket& socket : sockets_) waited.push_back({socket.handle(), POLLIN, 0});
  while (!isOver_) {
    if (poll(waited.data(), waited.size(), endLeases()) < 0) continue;
    for (std::size_t i = 0; i < sockets_.size(); ++i) {
      if (waited[i + 1].revents != 0) drain(sockets_[i]);
    }
  }
}

int LocalChannel::endLeases() {
  using std::chrono::steady_clock;
  if (!endsLeases_) return -1;
  if (const auto now = steady_clock::now(); now >= nextCheck_) {
    nextCheck_ = guard_.end(now, [this](std::span<const std::uint8_t> message) {
      receiver_.OnDataReceived(message.data(), static_cast<std::uint32_t>(message.size()), at_, at_);
    });
  }
  const auto left = std::chrono::ceil<std::chrono::milliseconds>(nextCheck_ - steady_clock::now());
  return std::max(static_cast<int>(left.count()), 0);
}

/// Hands on what has come, until nothing is left or leases may end.
void LocalChannel::drain(const UdpSocket& socket) {
  namespace rtps = eprosima::fastrtps::rtps;
  while (!isOver_) {
    const auto now = std::chrono::steady_clock::now();
    if (endsLeases_ && now >= nextCheck_) return;
    sockaddr_in sender{};
    socklen_t length = sizeof sender;
    const ssize_t size =
        recvfrom(socket.handle(), packet_.data(), packet_.size(), 0, reinterpret_cast<sockaddr*>(&sender), &length);
    // also if an error of an earlier packet is reported
    if (size < 0) return;
    if (size == 0) continue;
    Locator from;
    from.kind = LOCATOR_KIND_UDPv4;
    from.port = ntohs(sender.sin_port);
    std::memcpy(&from.address[12], &sender.sin_addr.s_addr, sizeof sender.sin_addr.s_addr);
    const auto message = std::span(packet_).first(static_cast<std::size_t>(size));
    guard_.receive(message, now, [&](std::span<const std::uint8_t> admitted) {
      receiver_.OnDataReceived(admitted.data(), static_cast<std::uint32_t>(admitted.size()), at_, from);
    });
  }
}

}  // namespace pongsim::ros2
