#include "fuel/archive.hh"

#include <fcntl.h>
#include <sys/stat.h>
#include <unistd.h>
#include <zip.h>

#include <cerrno>
#include <cstring>
#include <memory>
#include <string>
#include <string_view>
#include <system_error>
#include <vector>

#include "fuel/failure.hh"
#include "fuel/interruption.hh"

namespace pongsim::fuel {

namespace fs = std::filesystem;

namespace {

struct Closer {
  void operator()(zip_t* zip) const { zip_discard(zip); }
  void operator()(zip_file_t* file) const { zip_fclose(file); }
};

std::string shown(std::string_view name) {
  std::string text;
  for (const char each : name.substr(0, 200)) text += static_cast<unsigned char>(each) < 0x20 ? '?' : each;
  return "'" + text + "'";
}

/// @return The entry's path relative to the folder; empty for the folder itself.
fs::path pathOf(std::string_view name) {
  const auto refuse = [&] {
    throw Failure("the archive was refused: " + shown(name) + " is outside the model's folder");
  };
  if (name.empty() || name.front() == '/' || (name.size() > 1 && name[1] == ':')) refuse();
  fs::path path;
  std::size_t start = 0;
  while (start < name.size()) {
    const std::size_t end = std::min(name.find_first_of("/\\", start), name.size());
    const std::string_view part = name.substr(start, end - start);
    if (part == "..") refuse();
    if (!part.empty() && part != ".") path /= part;
    start = end + 1;
  }
  return path;
}

/// @throws Failure if an entry is neither a regular file nor a folder, by its Unix file mode.
void checkKind(zip_t* zip, zip_uint64_t index, std::string_view name) {
  zip_uint8_t system = 0;
  zip_uint32_t attributes = 0;
  if (zip_file_get_external_attributes(zip, index, 0, &system, &attributes) != 0 || system != ZIP_OPSYS_UNIX) return;
  const mode_t kind = (attributes >> 16U) & S_IFMT;
  if (kind == S_IFLNK) throw Failure("the archive was refused: " + shown(name) + " is a link");
  if (kind != 0 && kind != S_IFREG && kind != S_IFDIR) {
    throw Failure("the archive was refused: " + shown(name) + " is neither a file nor a folder");
  }
}

void makeFolder(const fs::path& folder) {
  std::error_code error;
  fs::create_directories(folder, error);
  if (error) throw Failure("the folder '" + folder.string() + "' can't be created: " + error.message());
}

[[noreturn]] void failToWrite(const fs::path& file) {
  const int error = errno;
  throw Failure("'" + file.string() + "' can't be written: " + std::strerror(error),
                error == ENOSPC || error == EDQUOT
                    ? "free disk space, or set IGN_FUEL_CACHE_PATH to a folder on another disk"
                    : "");
}

/// Creates a file; fails if there is already a file or link of that name (O_EXCL).
class NewFile {
 public:
  explicit NewFile(fs::path path)
      : path_(std::move(path)),
        number_(::open(path_.c_str(), O_WRONLY | O_CREAT | O_EXCL | O_NOFOLLOW | O_CLOEXEC, 0666)) {
    if (number_ < 0) {
      if (errno == EEXIST) throw Failure("the archive was refused: it has '" + path_.filename().string() + "' twice");
      failToWrite(path_);
    }
  }
  ~NewFile() { ::close(number_); }
  NewFile(const NewFile&) = delete;
  NewFile& operator=(const NewFile&) = delete;

  void write(std::string_view bytes) {
    while (!bytes.empty()) {
      const ssize_t count = ::write(number_, bytes.data(), bytes.size());
      if (count < 0 && errno == EINTR) continue;
      if (count < 0) failToWrite(path_);
      bytes.remove_prefix(static_cast<std::size_t>(count));
    }
  }
  /// Writes the data to the disk (fdatasync), so that the folder is complete when it is moved into place.
  void finish() {
    if (::fdatasync(number_) != 0 && errno != EINVAL) failToWrite(path_);
  }

 private:
  fs::path path_;
  int number_;
};

void unpackFile(zip_t* zip, zip_uint64_t index, const zip_stat_t& stat, const fs::path& target) {
  const auto damaged = [&](const std::string& why) {
    throw PassingFailure("the archive is damaged at " + shown(stat.name) + ": " + why, "try again");
  };
  const std::unique_ptr<zip_file_t, Closer> file(zip_fopen_index(zip, index, 0));
  if (file == nullptr) throw Failure("the archive was refused: " + shown(stat.name) + ": " + zip_strerror(zip));
  NewFile out(target);
  std::vector<char> part(std::size_t{1} << 18U);
  std::uint64_t done = 0;
  while (true) {
    checkInterruption();
    const zip_int64_t count = zip_fread(file.get(), part.data(), part.size());
    if (count < 0) damaged(zip_file_strerror(file.get()));
    if (count == 0) break;
    done += static_cast<std::uint64_t>(count);
    if (done > stat.size) damaged("it contains more than it states");
    out.write({part.data(), static_cast<std::size_t>(count)});
  }
  if (done != stat.size) damaged("it contains less than it states");
  out.finish();
}

}  // namespace

void unpack(const fs::path& zipFile, const fs::path& folder, const ArchiveLimits& limits) {
  int error = 0;
  const std::unique_ptr<zip_t, Closer> zip(zip_open(zipFile.c_str(), ZIP_RDONLY, &error));
  if (zip == nullptr) {
    zip_error_t text;
    zip_error_init_with_code(&text, error);
    const std::string why = zip_error_strerror(&text);
    zip_error_fini(&text);
    throw PassingFailure("the server did not send a complete zip file: " + why, "try again");
  }
  const auto count = static_cast<std::uint64_t>(zip_get_num_entries(zip.get(), 0));
  if (count > limits.files) {
    throw Failure("the archive was refused: it has " + std::to_string(count) + " files, and " +
                  std::to_string(limits.files) + " is the limit");
  }
  // all entries are checked before the first is written
  std::vector<zip_stat_t> stats(count);
  std::vector<fs::path> paths(count);
  std::uint64_t total = 0;
  for (zip_uint64_t i = 0; i < count; ++i) {
    zip_stat_init(&stats[i]);
    const zip_uint64_t needed = ZIP_STAT_NAME | ZIP_STAT_SIZE;
    if (zip_stat_index(zip.get(), i, 0, &stats[i]) != 0 || (stats[i].valid & needed) != needed) {
      throw Failure(std::string("the archive was refused: ") + zip_strerror(zip.get()));
    }
    paths[i] = pathOf(stats[i].name);
    checkKind(zip.get(), i, stats[i].name);
    if (stats[i].size > limits.bytes) total = limits.bytes;
    total += stats[i].size;
    if (total > limits.bytes) break;
  }
  const std::uint64_t packed = fs::file_size(zipFile);
  if (total > limits.bytes || total > limits.free + limits.ratio * packed) {
    throw Failure("the archive was refused: its " + std::to_string(packed) + " bytes would become " +
                  std::to_string(total) + " or more");
  }
  std::error_code ignored;
  const fs::space_info space = fs::space(folder, ignored);
  if (!ignored && space.available < total) {
    throw Failure("not enough disk space for " + std::to_string(total) + " bytes in '" + folder.string() +
                      "', only for " + std::to_string(space.available),
                  "free disk space, or set IGN_FUEL_CACHE_PATH to a folder on another disk");
  }
  for (zip_uint64_t i = 0; i < count; ++i) {
    const std::string_view name = stats[i].name;
    if (paths[i].empty()) continue;
    const fs::path target = folder / paths[i];
    if (name.ends_with('/') || name.ends_with('\\')) {
      makeFolder(target);
    } else {
      makeFolder(target.parent_path());
      unpackFile(zip.get(), i, stats[i], target);
    }
  }
}

}  // namespace pongsim::fuel
