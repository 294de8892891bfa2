#pragma once

#include <linux/inet_diag.h>
#include <linux/netlink.h>
#include <linux/sock_diag.h>
#include <netinet/in.h>
#include <sys/socket.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <span>

namespace pongsim::shared {

/// One datagram of the kernel's answer.
using DiagAnswer = std::array<std::byte, 4096>;

/// Asks the kernel (sock_diag(7)) for the UDP socket over IPv4 that receives what is sent to an address.
/// @param address, port In network order.
/// @param extensions What to add to the answer, as `idiag_ext`.
/// @return The part of `answer` that is filled; empty if the kernel can't be asked.
inline std::span<const std::byte> askForUdpSocket(int netlink, std::uint32_t address, std::uint16_t port,
                                                  std::uint8_t extensions, DiagAnswer& answer) {
  struct {
    nlmsghdr header{};
    inet_diag_req_v2 wanted{};
  } request;
  request.header.nlmsg_len = sizeof request;
  request.header.nlmsg_type = SOCK_DIAG_BY_FAMILY;
  request.header.nlmsg_flags = NLM_F_REQUEST;
  request.wanted.sdiag_family = AF_INET;
  request.wanted.sdiag_protocol = IPPROTO_UDP;
  request.wanted.idiag_ext = extensions;
  request.wanted.idiag_states = ~0U;
  // the kernel looks the socket up as for a received packet, with this destination
  request.wanted.id.idiag_dst[0] = address;
  request.wanted.id.idiag_dport = port;
  std::ranges::fill(request.wanted.id.idiag_cookie, INET_DIAG_NOCOOKIE);
  if (send(netlink, &request, sizeof request, 0) != sizeof request) return {};
  const ssize_t size = recv(netlink, answer.data(), answer.size(), 0);
  return std::span(answer).first(static_cast<std::size_t>(std::max<ssize_t>(size, 0)));
}

}  // namespace pongsim::shared
