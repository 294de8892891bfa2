#include "log/mcap/input_file.hh"

#include <fcntl.h>
#include <sys/stat.h>
#include <unistd.h>

#include <cerrno>
#include <cstring>

#include "log/mcap/bytes.hh"
#include "log/store/failure.hh"

namespace pongsim::log {

// non-blocking, because it may be a pipe without a writer
InputFile::InputFile(const std::filesystem::path& path)
    : number_(::open(path.c_str(), O_RDONLY | O_CLOEXEC | O_NONBLOCK)) {
  const auto refuse = [&](const std::string& why) {
    if (number_ >= 0) ::close(number_);
    throw Failure("'" + path.string() + "' can't be read: " + why);
  };
  struct stat status {};
  if (number_ < 0 || fstat(number_, &status) != 0) refuse(std::strerror(errno));
  if (!S_ISREG(status.st_mode)) refuse(S_ISDIR(status.st_mode) ? "it is a folder" : "it is not a regular file");
  size_ = static_cast<std::uint64_t>(status.st_size);
}

InputFile::~InputFile() { ::close(number_); }

std::string InputFile::read(std::uint64_t offset, std::uint64_t length) const {
  if (offset > size_ || length > size_ - offset) {
    throw Failure(
        atByte(offset, std::to_string(length) + " bytes expected here, but the file ends at " + std::to_string(size_)));
  }
  if (length > kMostAtOnce) {
    throw Failure(atByte(offset, "a piece of " + std::to_string(length) + " bytes, and " + std::to_string(kMostAtOnce) +
                                     " is the limit"));
  }
  std::string bytes(length, '\0');
  std::size_t done = 0;
  while (done < length) {
    const ssize_t count = ::pread(number_, bytes.data() + done, length - done, static_cast<off_t>(offset + done));
    if (count < 0 && errno == EINTR) continue;
    if (count < 0) throw Failure(atByte(offset + done, std::string("it can't be read: ") + std::strerror(errno)));
    if (count == 0) throw Failure(atByte(offset + done, "the file has shrunk"));
    done += static_cast<std::size_t>(count);
  }
  return bytes;
}

}  // namespace pongsim::log
