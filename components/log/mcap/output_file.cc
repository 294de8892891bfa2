#include "log/mcap/output_file.hh"

#include <fcntl.h>
#include <unistd.h>

#include <cerrno>
#include <cstring>
#include <utility>

#include "log/store/failure.hh"

namespace pongsim::log {

OutputFile::OutputFile(std::filesystem::path path, bool overwrites)
    : path_(std::move(path)),
      number_(::open(path_.c_str(), O_WRONLY | O_CREAT | O_CLOEXEC | (overwrites ? O_TRUNC : O_EXCL), 0666)) {
  if (number_ >= 0) return;
  if (errno == EEXIST) throw Failure("'" + path_.string() + "' already exists", "use --force to overwrite it");
  throw Failure("'" + path_.string() + "' can't be created: " + std::strerror(errno));
}

OutputFile::~OutputFile() {
  if (number_ >= 0) ::close(number_);
}

void OutputFile::fail() const {
  const int error = errno;
  throw Failure("'" + path_.string() + "' can't be written: " + std::strerror(error),
                error == ENOSPC || error == EDQUOT ? "free disk space; what has been written is readable" : "");
}

void OutputFile::close() {
  if (::close(std::exchange(number_, -1)) != 0 && errno != EINTR) fail();
}

void OutputFile::write(std::string_view bytes) {
  while (!bytes.empty()) {
    const ssize_t count = ::write(number_, bytes.data(), bytes.size());
    if (count < 0 && errno == EINTR) continue;
    if (count < 0) fail();
    bytes.remove_prefix(static_cast<std::size_t>(count));
    size_ += static_cast<std::uint64_t>(count);
  }
}

}  // namespace pongsim::log
