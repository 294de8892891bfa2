#include "hostile/neighbour.hh"

#include <arpa/inet.h>
#include <netinet/in.h>
#include <poll.h>
#include <sys/socket.h>
#include <unistd.h>

#include <algorithm>
#include <cstring>
#include <stdexcept>
#include <string>

namespace pongsim::hostile {

namespace {

using Clock = std::chrono::steady_clock;

// Parameters with the addresses of a participant.
constexpr std::uint16_t kUserAddress = 0x31, kDiscoveryAddress = 0x32;

constexpr std::size_t kHeader = 20;
// Sizes: of a DATA submessage up to its parameter list, and of the list up to its first parameter.
constexpr std::size_t kDataHeader = 20, kEncapsulation = 4;

sockaddr_in loopback(std::uint16_t port) {
  sockaddr_in address{};
  address.sin_family = AF_INET;
  address.sin_port = htons(port);
  address.sin_addr.s_addr = htonl(INADDR_LOOPBACK);
  return address;
}

std::uint16_t read16(std::span<const std::uint8_t> bytes, std::size_t at) {
  return static_cast<std::uint16_t>(bytes[at] | bytes[at + 1] << 8);
}

/// @return The bytes after a list of parameters.
std::span<const std::uint8_t> afterList(std::span<const std::uint8_t> list) {
  while (list.size() >= 4) {
    const bool isEnd = read16(list, 0) == 1;
    list = list.subspan(std::min(list.size(), std::size_t(4) + read16(list, 2)));
    if (isEnd) break;
  }
  return list;
}

/// Reads the ports from the parameters of a participant, which are little-endian.
void readPorts(std::span<const std::uint8_t> parameters, Neighbour& neighbour) {
  while (parameters.size() >= 4) {
    const std::uint16_t id = read16(parameters, 0);
    const std::size_t length = read16(parameters, 2);
    if (id == 1 || parameters.size() < 4 + length) return;
    if (length >= 8 && id == kUserAddress) neighbour.userPort = read16(parameters, 8);
    if (length >= 8 && id == kDiscoveryAddress) neighbour.discoveryPort = read16(parameters, 8);
    parameters = parameters.subspan(4 + length);
  }
}

/// @return The participant that announces itself; its ports are 0 if the message is no announcement.
Neighbour readNeighbour(std::span<const std::uint8_t> message) {
  Neighbour neighbour;
  if (message.size() < kHeader) return neighbour;
  std::copy_n(message.begin() + 8, neighbour.prefix.size(), neighbour.prefix.begin());
  auto rest = message.subspan(kHeader);
  while (rest.size() >= 4) {
    const std::size_t length = read16(rest, 2);
    if (rest.size() < 4 + length) break;
    constexpr std::uint8_t kSpdpWriter[] = {0x00, 0x01, 0x00, 0xc2};
    if (rest[0] == static_cast<std::uint8_t>(Kind::kData) && length > kDataHeader + kEncapsulation &&
        std::equal(std::begin(kSpdpWriter), std::end(kSpdpWriter), rest.begin() + 12)) {
      auto sample = rest.subspan(4 + kDataHeader, length - kDataHeader);
      if ((rest[1] & kInlineQos) != 0) sample = afterList(sample);
      if (sample.size() > kEncapsulation) readPorts(sample.subspan(kEncapsulation), neighbour);
    }
    rest = rest.subspan(4 + length);
  }
  return neighbour;
}

}  // namespace

std::uint16_t discoveryPort(int domain, int number) {
  return static_cast<std::uint16_t>(7400 + 250 * domain + 10 + 2 * number);
}

Foothold::Foothold(int domain) {
  descriptor_ = socket(AF_INET, SOCK_DGRAM | SOCK_CLOEXEC | SOCK_NONBLOCK, 0);
  if (descriptor_ < 0) throw std::runtime_error("no socket can be had");
  // from the highest one down, because other participants take the lowest free one
  for (int i = kMostParticipants - 1; i >= 0 && port_ == 0; --i) {
    const std::uint16_t port = discoveryPort(domain, i);
    const sockaddr_in address = loopback(port);
    if (bind(descriptor_, reinterpret_cast<const sockaddr*>(&address), sizeof address) == 0) port_ = port;
  }
  if (port_ == 0) {
    close(descriptor_);
    throw std::runtime_error("domain " + std::to_string(domain) + " has no port left");
  }
}

Foothold::~Foothold() { close(descriptor_); }

std::vector<Neighbour> Foothold::hear(std::chrono::milliseconds duration, std::chrono::milliseconds atMost) {
  std::vector<Neighbour> all;
  const auto start = Clock::now();
  std::vector<std::uint8_t> message(65536);
  while (Clock::now() < start + (all.empty() ? atMost : duration)) {
    pollfd readable{descriptor_, POLLIN, 0};
    poll(&readable, 1, 20);
    const ssize_t size = recv(descriptor_, message.data(), message.size(), 0);
    if (size <= 0) continue;
    const Neighbour heard = readNeighbour({message.data(), static_cast<std::size_t>(size)});
    if (heard.discoveryPort == 0) continue;
    if (std::ranges::find(all, heard.prefix, &Neighbour::prefix) == all.end()) all.push_back(heard);
  }
  return all;
}

void Foothold::send(std::span<const std::uint8_t> bytes, std::uint16_t port) const {
  const sockaddr_in address = loopback(port);
  // an error means a lost packet, as on any network
  static_cast<void>(
      sendto(descriptor_, bytes.data(), bytes.size(), 0, reinterpret_cast<const sockaddr*>(&address), sizeof address));
}

void sendFromNewSocket(std::span<const std::uint8_t> bytes, std::uint16_t port) {
  const int descriptor = socket(AF_INET, SOCK_DGRAM | SOCK_CLOEXEC, 0);
  if (descriptor < 0) return;
  const sockaddr_in address = loopback(port);
  static_cast<void>(
      sendto(descriptor, bytes.data(), bytes.size(), 0, reinterpret_cast<const sockaddr*>(&address), sizeof address));
  close(descriptor);
}

}  // namespace pongsim::hostile
