#include "support/test_domain.hh"

#include <fcntl.h>
#include <unistd.h>

#include <cstdlib>
#include <filesystem>
#include <stdexcept>
#include <string>

namespace pongsim::test {

namespace {

// The ports of a domain begin at 7400 + 250 * domain. From domain 101 on they are in the range from which Linux assigns
// ports to outgoing sockets.
constexpr int kDomains = 100;

int takeDomain() {
  const std::filesystem::path file =
      std::filesystem::temp_directory_path() / ("pongsim-test-domains-" + std::to_string(getuid()));

  // one byte of the file for each domain; children inherit the open file and with it the lock
  const int locks = open(file.c_str(), O_RDWR | O_CREAT, 0600);
  if (locks < 0) throw std::runtime_error("cannot open " + file.string());
  for (int i = 0; i < kDomains; ++i) {
    const int domain = 1 + (static_cast<int>(getpid()) + i) % kDomains;
    struct flock lock {};
    lock.l_type = F_WRLCK;
    lock.l_whence = SEEK_SET;
    lock.l_start = domain;
    lock.l_len = 1;
    if (fcntl(locks, F_OFD_SETLK, &lock) == 0) {
      setenv("PONGSIM_DOMAIN", std::to_string(domain).c_str(), 1);
      return domain;
    }
  }
  close(locks);
  throw std::runtime_error("all test domains are taken");
}

}  // namespace

int testDomain() {
  static const int domain = takeDomain();
  return domain;
}

}  // namespace pongsim::test
