#include "cli/run/readiness.hh"

#include <sys/socket.h>
#include <sys/un.h>
#include <unistd.h>

#include <cerrno>
#include <cstddef>
#include <cstdlib>
#include <cstring>
#include <string>

#include "shared/program/console.hh"

namespace pongsim::cli {

namespace {

/// Sends one datagram.
/// @return Zero, or the error's number.
int sendTo(std::string_view path, std::string_view text) {
  sockaddr_un address{};
  address.sun_family = AF_UNIX;
  if (path.size() >= sizeof address.sun_path) return ENAMETOOLONG;
  path.copy(address.sun_path, path.size());
  // an abstract address, without a file
  if (path.front() == '@') address.sun_path[0] = '\0';
  const int socket = ::socket(AF_UNIX, SOCK_DGRAM | SOCK_CLOEXEC, 0);
  if (socket < 0) return errno;
  const auto length = static_cast<socklen_t>(offsetof(sockaddr_un, sun_path) + path.size());
  const ssize_t sent =
      sendto(socket, text.data(), text.size(), MSG_NOSIGNAL, reinterpret_cast<const sockaddr*>(&address), length);
  const int error = sent < 0 ? errno : 0;
  close(socket);
  return error;
}

void tell(const std::string& text) {
  const char* path = std::getenv("NOTIFY_SOCKET");
  if (path == nullptr || *path == '\0') return;
  if (const int error = sendTo(path, text); error != 0) {
    say("can't notify the service manager at '" + std::string(path) + "': " + std::strerror(error));
  }
}

}  // namespace

void tellReady(std::string_view status) { tell("READY=1\nSTATUS=" + std::string(status) + "\n"); }

void tellStopping() { tell("STOPPING=1\n"); }

}  // namespace pongsim::cli
