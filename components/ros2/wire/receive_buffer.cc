#include "ros2/wire/receive_buffer.hh"

#include <arpa/inet.h>
#include <linux/inet_diag.h>
#include <linux/netlink.h>
#include <linux/rtnetlink.h>
#include <linux/sock_diag.h>
#include <sys/socket.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <cstdio>
#include <cstring>
#include <memory>

#include "shared/sockets/udp_lookup.hh"

namespace pongsim::ros2 {

namespace {

/// Linux's default, net.core.rmem_default.
constexpr std::size_t kDefaultBuffer = 208 * 1024;

/// @param size Bytes of the kernel's answer.
std::optional<ReceiveBuffer> readAnswer(const nlmsghdr& header, std::size_t size) {
  constexpr std::size_t kBegin = NLMSG_LENGTH(sizeof(inet_diag_msg));
  if (!NLMSG_OK(&header, size) || header.nlmsg_type != SOCK_DIAG_BY_FAMILY || header.nlmsg_len < kBegin) {
    return std::nullopt;
  }
  const auto* const bytes = reinterpret_cast<const std::byte*>(&header);
  const auto* attribute = reinterpret_cast<const rtattr*>(bytes + NLMSG_ALIGN(kBegin));
  auto left = static_cast<int>(header.nlmsg_len - NLMSG_ALIGN(kBegin));
  for (; RTA_OK(attribute, left); attribute = RTA_NEXT(attribute, left)) {
    if (attribute->rta_type != INET_DIAG_SKMEMINFO) continue;
    std::array<std::uint32_t, SK_MEMINFO_RCVBUF + 1> memory{};
    if (RTA_PAYLOAD(attribute) < sizeof memory) return std::nullopt;
    std::memcpy(memory.data(), RTA_DATA(attribute), sizeof memory);
    return ReceiveBuffer{memory[SK_MEMINFO_RCVBUF], memory[SK_MEMINFO_RMEM_ALLOC]};
  }
  return std::nullopt;
}

std::optional<ReceiveBuffer> ask(int netlink, std::uint32_t address, std::uint16_t port) {
  alignas(nlmsghdr) shared::DiagAnswer answer;
  constexpr std::uint8_t kMemory = 1U << (INET_DIAG_SKMEMINFO - 1);
  const auto bytes = shared::askForUdpSocket(netlink, address, htons(port), kMemory, answer);
  if (bytes.size() < sizeof(nlmsghdr)) return std::nullopt;
  return readAnswer(*reinterpret_cast<const nlmsghdr*>(answer.data()), bytes.size());
}

}  // namespace

std::optional<ReceiveBuffer> receiveBufferOf(std::uint32_t address, std::uint16_t port) {
  if (const int netlink = socket(AF_NETLINK, SOCK_RAW | SOCK_CLOEXEC, NETLINK_SOCK_DIAG); netlink >= 0) {
    const auto buffer = ask(netlink, address, port);
    close(netlink);
    if (buffer) return buffer;
  }
  return receiveBufferByProc(port);
}

std::optional<ReceiveBuffer> receiveBufferByProc(std::uint16_t port) {
  const std::unique_ptr<std::FILE, int (*)(std::FILE*)> table(std::fopen("/proc/net/udp", "re"), &std::fclose);
  if (!table) return std::nullopt;
  std::optional<ReceiveBuffer> fullest;
  char line[256];
  while (std::fgets(line, sizeof line, table.get()) != nullptr) {
    unsigned int local = 0;
    unsigned long queued = 0;
    // number: address:port address:port state sent:queued
    if (std::sscanf(line, " %*d: %*x:%x %*x:%*x %*x %*x:%lx", &local, &queued) != 2 || local != port) continue;
    if (!fullest || queued > fullest->used) fullest = ReceiveBuffer{kDefaultBuffer, queued};
  }
  return fullest;
}

}  // namespace pongsim::ros2
