#include "video/output_file.hh"

#include <fcntl.h>
#include <linux/fs.h>
#include <sys/stat.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <cstdio>
#include <cstring>
#include <system_error>

namespace pongsim::video {

namespace fs = std::filesystem;

namespace {

constexpr mode_t kMode = 0644;

std::string partOf(const fs::path& place) { return place.string() + ".part"; }

std::string cantBeWritten(const fs::path& place, const std::string& why) {
  return "'" + place.string() + "' can't be written: " + why;
}

bool isBelow(const fs::path& path, const fs::path& folder) {
  return std::ranges::mismatch(path, folder).in2 == folder.end();
}

}  // namespace

Outcome<OutputFile> OutputFile::create(const fs::path& place) {
  std::error_code error;
  fs::create_directories(place.parent_path(), error);
  if (error) return {{}, cantBeWritten(place, error.message())};
  // a link there would lead elsewhere
  const int file = ::open(partOf(place).c_str(), O_RDWR | O_CREAT | O_TRUNC | O_CLOEXEC | O_NOFOLLOW, kMode);
  if (file < 0) return {{}, cantBeWritten(place, std::strerror(errno))};
  return {OutputFile(file, place), {}};
}

OutputFile::OutputFile(OutputFile&& other) noexcept
    : file_(std::exchange(other.file_, -1)), place_(std::move(other.place_)), error_(std::move(other.error_)) {}

OutputFile::~OutputFile() {
  if (file_ < 0) return;
  ::close(file_);
  std::error_code ignored;
  fs::remove(partOf(place_), ignored);
}

int OutputFile::write(std::span<const std::uint8_t> bytes) {
  for (std::size_t done = 0; done < bytes.size();) {
    const ssize_t count = ::write(file_, bytes.data() + done, bytes.size() - done);
    if (count < 0 && errno == EINTR) continue;
    if (count <= 0) {
      const int code = count < 0 ? errno : ENOSPC;
      error_ = std::strerror(code);
      return -code;
    }
    done += static_cast<std::size_t>(count);
  }
  return static_cast<int>(bytes.size());
}

std::int64_t OutputFile::seek(std::int64_t offset, int whence) {
  const off_t place = ::lseek(file_, offset, whence);
  return place < 0 ? -errno : place;
}

Outcome<void> OutputFile::complete() {
  const std::string part = partOf(place_);
  // some file systems tell only now that they are full
  if (::close(std::exchange(file_, -1)) != 0) error_ = std::strerror(errno);
  if (error_.empty() && ::renameat2(AT_FDCWD, part.c_str(), AT_FDCWD, place_.c_str(), RENAME_NOREPLACE) != 0) {
    error_ = std::strerror(errno);
  }
  if (error_.empty()) return {};
  ::unlink(part.c_str());
  return {cantBeWritten(place_, error_)};
}

std::string fileNameOf(std::string scopedName) {
  for (std::size_t at = 0; (at = scopedName.find("::", at)) != std::string::npos;) scopedName.replace(at, 2, "_");
  return scopedName;
}

Outcome<fs::path> placeOf(const fs::path& wanted, const fs::path& folder, const std::string& ending) {
  std::error_code error;
  const fs::path allowed = fs::weakly_canonical(fs::absolute(folder), error);
  if (error) return {{}, "the folder '" + folder.string() + "' can't be found: " + error.message()};
  const fs::path place = fs::weakly_canonical(allowed / wanted, error);
  if (error) return {{}, cantBeWritten(wanted, error.message())};
  if (!isBelow(place, allowed) || place == allowed) {
    return {{}, "'" + wanted.string() + "' is not in '" + allowed.string() + "', where videos are written"};
  }
  if (place.extension() != ending) return {{}, "'" + wanted.string() + "' does not end in " + ending};
  if (fs::symlink_status(place, error).type() != fs::file_type::not_found) {
    return {{}, "'" + wanted.string() + "' is there already"};
  }
  return {place, {}};
}

}  // namespace pongsim::video
