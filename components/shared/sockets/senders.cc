#include "shared/sockets/senders.hh"

#include <linux/filter.h>
#include <netinet/in.h>
#include <sys/socket.h>

namespace pongsim::shared {

namespace {

// Offsets of the addresses in an IPv4 header.
constexpr std::uint32_t kSourceAddress = 12;
constexpr std::uint32_t kDestinationAddress = 16;
constexpr std::uint32_t kWholePacket = 0xffffffff;

bool attach(int socket, std::vector<sock_filter>& filter) {
  const sock_fprog program{static_cast<unsigned short>(filter.size()), filter.data()};
  return setsockopt(socket, SOL_SOCKET, SO_ATTACH_FILTER, &program, sizeof program) == 0;
}

sock_filter statement(std::uint32_t code, std::uint32_t value) {
  return {static_cast<std::uint16_t>(code), 0, 0, value};
}

/// What the program says first: it begins at the header of UDP.
void refuse(const RefusedKind& kind, std::vector<sock_filter>& filter) {
  constexpr std::uint32_t kHeader = 8;
  const std::uint32_t tag = kHeader + kind.offset, value = tag + 1;
  filter.push_back(statement(BPF_LD | BPF_W | BPF_LEN, 0));
  filter.push_back({BPF_JMP | BPF_JGT | BPF_K, 0, 5, value});
  filter.push_back(statement(BPF_LD | BPF_B | BPF_ABS, tag));
  filter.push_back({BPF_JMP | BPF_JEQ | BPF_K, 0, 3, kind.tag});
  filter.push_back(statement(BPF_LD | BPF_B | BPF_ABS, value));
  filter.push_back({BPF_JMP | BPF_JGE | BPF_K, 0, 1, kind.least});
  filter.push_back(statement(BPF_RET | BPF_K, 0));
}

}  // namespace

bool limitSenders(int socket, const Senders& senders, const std::optional<RefusedKind>& refused) {
  if (senders.isAnybody && !refused) return true;
  std::vector<sock_filter> filter;
  if (refused) refuse(*refused, filter);
  if (senders.isAnybody) {
    filter.push_back(statement(BPF_RET | BPF_K, kWholePacket));
    return attach(socket, filter);
  }
  const std::size_t count = senders.addresses.size();
  if (count > Senders::kMostAddresses) return false;
  const auto load = [](std::uint32_t offset) {
    return statement(BPF_LD | BPF_W | BPF_ABS, static_cast<std::uint32_t>(SKF_NET_OFF) + offset);
  };
  if (senders.openAddress) {
    filter.push_back(load(kDestinationAddress));
    filter.push_back({BPF_JMP | BPF_JEQ | BPF_K, 0, 1, ntohl(*senders.openAddress)});
    filter.push_back(statement(BPF_RET | BPF_K, kWholePacket));
  }
  filter.push_back(load(kSourceAddress));
  // each jump skips the remaining comparisons and the refusal
  for (std::size_t i = 0; i < count; ++i) {
    filter.push_back(
        {BPF_JMP | BPF_JEQ | BPF_K, static_cast<std::uint8_t>(count - i - 1 + 3), 0, ntohl(senders.addresses[i])});
  }
  filter.push_back(statement(BPF_ALU | BPF_AND | BPF_K, 0xff000000));
  filter.push_back({BPF_JMP | BPF_JEQ | BPF_K, 1, 0, 0x7f000000});
  filter.push_back(statement(BPF_RET | BPF_K, 0));
  filter.push_back(statement(BPF_RET | BPF_K, kWholePacket));
  return attach(socket, filter);
}

bool refuseSenders(int socket) {
  std::vector<sock_filter> filter{statement(BPF_RET | BPF_K, 0)};
  return attach(socket, filter);
}

}  // namespace pongsim::shared
