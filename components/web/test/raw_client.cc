#include "web/test/raw_client.hh"

#include <netinet/in.h>
#include <sys/socket.h>
#include <sys/time.h>
#include <unistd.h>

#include <array>
#include <cerrno>

namespace pongsim::web::test {

namespace {

constexpr int kDeadlineSeconds = 60;

}  // namespace

RawClient::RawClient(int port, int receiveBuffer) : port_(port), socket_(socket(AF_INET, SOCK_STREAM, 0)) {
  const timeval deadline{kDeadlineSeconds, 0};
  setsockopt(socket_, SOL_SOCKET, SO_RCVTIMEO, &deadline, sizeof deadline);
  setsockopt(socket_, SOL_SOCKET, SO_SNDTIMEO, &deadline, sizeof deadline);
  if (receiveBuffer > 0) setsockopt(socket_, SOL_SOCKET, SO_RCVBUF, &receiveBuffer, sizeof receiveBuffer);
  sockaddr_in place{};
  place.sin_family = AF_INET;
  place.sin_port = htons(static_cast<std::uint16_t>(port));
  place.sin_addr.s_addr = htonl(INADDR_LOOPBACK);
  if (connect(socket_, reinterpret_cast<const sockaddr*>(&place), sizeof place) == 0) return;
  ::close(socket_);
  socket_ = -1;
}

RawClient::~RawClient() {
  if (socket_ >= 0) ::close(socket_);
}

bool RawClient::send(std::string_view bytes) {
  while (!bytes.empty()) {
    const ssize_t count = ::send(socket_, bytes.data(), bytes.size(), MSG_NOSIGNAL);
    if (count <= 0) return false;
    bytes.remove_prefix(static_cast<std::size_t>(count));
  }
  return true;
}

std::string RawClient::get(const std::string& path, const std::string& headers, const std::string& host) {
  const std::string asked = host.empty() ? "127.0.0.1:" + std::to_string(port_) : host;
  send("GET " + path + " HTTP/1.1\r\nHost: " + asked + "\r\nConnection: close\r\n" + headers + "\r\n");
  std::string answer;
  std::array<char, 4096> part{};
  while (true) {
    const ssize_t count = recv(socket_, part.data(), part.size(), 0);
    if (count <= 0) return answer;
    answer.append(part.data(), static_cast<std::size_t>(count));
  }
}

std::string RawClient::open(const std::string& path, const std::string& headers, const std::string& host) {
  const std::string asked = host.empty() ? "127.0.0.1:" + std::to_string(port_) : host;
  send("GET " + path + " HTTP/1.1\r\nHost: " + asked +
       "\r\nUpgrade: websocket\r\nConnection: Upgrade\r\nSec-WebSocket-Version: 13\r\n"
       "Sec-WebSocket-Key: dGhlIHNhbXBsZSBub25jZQ==\r\n" +
       headers + "\r\n");
  std::string head;
  char letter = 0;
  while (!head.ends_with("\r\n\r\n") && readExactly(&letter, 1)) head += letter;
  return head;
}

bool RawClient::sendFrame(int opcode, std::string_view payload, bool isFinal) {
  std::string frame;
  frame += static_cast<char>((isFinal ? 0x80 : 0) | opcode);
  if (payload.size() < 126) {
    frame += static_cast<char>(0x80 | payload.size());
  } else {
    const int bytes = payload.size() < 65536 ? 2 : 8;
    frame += static_cast<char>(0x80 | (bytes == 2 ? 126 : 127));
    for (int i = bytes - 1; i >= 0; --i) frame += static_cast<char>(payload.size() >> (8 * i));
  }
  // a mask of zeros is valid
  frame += std::string(4, '\0');
  frame += payload;
  return send(frame);
}

bool RawClient::readExactly(void* place, std::size_t size) {
  auto* at = static_cast<char*>(place);
  while (size > 0) {
    const ssize_t count = recv(socket_, at, size, 0);
    if (count <= 0) return false;
    at += count;
    size -= static_cast<std::size_t>(count);
  }
  return true;
}

std::optional<RawClient::Message> RawClient::next() {
  Message message;
  while (true) {
    std::array<unsigned char, 8> head{};
    if (!readExactly(head.data(), 2)) return {};
    const bool isFinal = (head[0] & 0x80) != 0;
    const int opcode = head[0] & 15;
    std::uint64_t size = head[1] & 127;
    if (size >= 126) {
      const std::size_t count = size == 126 ? 2 : 8;
      if (!readExactly(head.data(), count)) return {};
      size = 0;
      for (std::size_t i = 0; i < count; ++i) size = size << 8 | head[i];
    }
    std::string part(size, '\0');
    if (!readExactly(part.data(), size)) return {};
    if (opcode == 9) continue;
    if (opcode != 0) message.opcode = opcode;
    message.payload += part;
    if (isFinal) return message;
  }
}

bool RawClient::finish() {
  shutdown(socket_, SHUT_WR);
  std::array<char, 4096> part{};
  ssize_t count = 0;
  do count = recv(socket_, part.data(), part.size(), 0);
  while (count > 0);
  return count == 0 || errno == ECONNRESET;
}

int RawClient::Message::closeCode() const {
  if (payload.size() < 2) return 0;
  return static_cast<unsigned char>(payload[0]) << 8 | static_cast<unsigned char>(payload[1]);
}

}  // namespace pongsim::web::test
