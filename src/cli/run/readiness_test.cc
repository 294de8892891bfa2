#include "cli/run/readiness.hh"

#include <gtest/gtest.h>
#include <sys/socket.h>
#include <sys/un.h>
#include <unistd.h>

#include <cstddef>
#include <cstdlib>
#include <string>

#include "support/temp_folder.hh"

namespace pongsim::cli {
namespace {

/// A service manager's end, at a path or, with '@' in front, at a name without a file.
class ServiceManager {
 public:
  explicit ServiceManager(const std::string& path) : socket_(::socket(AF_UNIX, SOCK_DGRAM | SOCK_CLOEXEC, 0)) {
    sockaddr_un address{};
    address.sun_family = AF_UNIX;
    path.copy(address.sun_path, sizeof address.sun_path - 1);
    if (path.front() == '@') address.sun_path[0] = '\0';
    const auto length = static_cast<socklen_t>(offsetof(sockaddr_un, sun_path) + path.size());
    EXPECT_EQ(bind(socket_, reinterpret_cast<const sockaddr*>(&address), length), 0);
    setenv("NOTIFY_SOCKET", path.c_str(), 1);
  }
  ~ServiceManager() {
    unsetenv("NOTIFY_SOCKET");
    close(socket_);
  }
  ServiceManager(const ServiceManager&) = delete;
  ServiceManager& operator=(const ServiceManager&) = delete;

  /// @return What came; empty where nothing did.
  std::string told() const {
    char text[256];
    const ssize_t length = recv(socket_, text, sizeof text, MSG_DONTWAIT);
    return length < 0 ? std::string() : std::string(text, static_cast<std::size_t>(length));
  }

 private:
  int socket_;
};

TEST(Readiness, IsToldToTheServiceManager) {
  const test::TempFolder folder;
  for (const std::string& path : {(folder.path() / "s").string(), "@pongsim-test-" + std::to_string(getpid())}) {
    const ServiceManager manager(path);
    EXPECT_EQ(manager.told(), "");
    tellReady("world 'w'");
    EXPECT_EQ(manager.told(), "READY=1\nSTATUS=world 'w'\n");
    tellStopping();
    EXPECT_EQ(manager.told(), "STOPPING=1\n");
  }
}

TEST(Readiness, IsSilentWithoutServiceManagerAndSaysWhereItCanNotBeTold) {
  unsetenv("NOTIFY_SOCKET");
  testing::internal::CaptureStderr();
  tellReady("w");
  EXPECT_EQ(testing::internal::GetCapturedStderr(), "");
  for (const std::string& path : {std::string("/no/such/socket"), std::string(200, 'x')}) {
    setenv("NOTIFY_SOCKET", path.c_str(), 1);
    testing::internal::CaptureStderr();
    tellReady("w");
    EXPECT_TRUE(testing::internal::GetCapturedStderr().starts_with("pongsim: can't notify the service manager at '"));
  }
  unsetenv("NOTIFY_SOCKET");
}

}  // namespace
}  // namespace pongsim::cli
