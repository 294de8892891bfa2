#include "base/regular_file.hh"

#include <fcntl.h>
#include <sys/stat.h>

#include <cerrno>
#include <cstring>

namespace pongsim::base {

namespace {

/// @return What it is, if it is no regular file.
const char* otherKind(const struct stat& status) {
  switch (status.st_mode & S_IFMT) {
    case S_IFREG:
      return nullptr;
    case S_IFDIR:
      return "is a folder, not a file";
    case S_IFIFO:
      return "is a named pipe, not a file";
    case S_IFSOCK:
      return "is a socket, not a file";
    default:
      return "is a device, not a file";
  }
}

Unreadable because(int number) {
  if (number == ENOENT || number == ENOTDIR) return {"no such file"};
  return {std::string("can't be read: ") + std::strerror(number)};
}

}  // namespace

std::variant<RegularFile, Unreadable> RegularFile::open(const std::filesystem::path& file) {
  // before it is opened, because opening a device may already change it; and again afterwards, for it may be another
  // one
  struct stat status {};
  if (::stat(file.c_str(), &status) != 0) return because(errno);
  if (const char* kind = otherKind(status)) return Unreadable{kind};
  FileDescriptor descriptor(::open(file.c_str(), O_RDONLY | O_CLOEXEC | O_NONBLOCK | O_NOCTTY));
  if (!descriptor.isOpen() || ::fstat(descriptor.number(), &status) != 0) return because(errno);
  if (const char* kind = otherKind(status)) return Unreadable{kind};
  return RegularFile(std::move(descriptor), static_cast<std::uint64_t>(status.st_size));
}

std::optional<std::size_t> RegularFile::readAt(std::uint64_t offset, std::span<char> bytes) const {
  std::size_t done = 0;
  while (done < bytes.size()) {
    const ::ssize_t count =
        ::pread(descriptor_.number(), bytes.data() + done, bytes.size() - done, static_cast<::off_t>(offset + done));
    if (count < 0 && errno == EINTR) continue;
    if (count < 0) return std::nullopt;
    if (count == 0) break;
    done += static_cast<std::size_t>(count);
  }
  return done;
}

std::variant<std::string, Unreadable> readRegularFile(const std::filesystem::path& file, std::uint64_t largest) {
  auto opened = RegularFile::open(file);
  if (auto* reason = std::get_if<Unreadable>(&opened)) return std::move(*reason);
  const auto& open = std::get<RegularFile>(opened);
  const Unreadable tooLarge{"is larger than " + std::to_string(largest >> 20U) + " MiB, which is the limit"};
  if (open.size() > largest) return tooLarge;
  std::string content;
  // files of /proc and /sys have no size, and others may have grown
  for (std::size_t room = static_cast<std::size_t>(open.size()) + 1;; room = std::size_t{1} << 16U) {
    const std::size_t before = content.size();
    content.resize(before + room);
    const std::optional<std::size_t> count = open.readAt(before, std::span(content).subspan(before));
    if (!count) return because(errno);
    content.resize(before + *count);
    if (content.size() > largest) return tooLarge;
    if (*count < room) return content;
  }
}

}  // namespace pongsim::base
