#include "assets/file_cache.hh"

#include <fcntl.h>
#include <unistd.h>

#include <algorithm>
#include <atomic>
#include <cerrno>
#include <chrono>
#include <cstdlib>
#include <cstring>
#include <system_error>
#include <utility>
#include <variant>
#include <vector>

#include "base/file_descriptor.hh"
#include "base/hash.hh"
#include "base/regular_file.hh"

namespace pongsim::assets {

namespace {

namespace fs = std::filesystem;

constexpr std::string_view kEnding = ".cache";
/// A file consists of this line, the length and the hash of the content in eight bytes each (least significant first),
/// and the content.
constexpr std::string_view kMagic = "pongsim cache 1\n";
constexpr std::size_t kHeader = kMagic.size() + 16;
constexpr std::uintmax_t kLargestFile = std::uintmax_t{64} << 20U;

void appendNumber(std::uint64_t number, std::string& to) {
  for (unsigned shift = 0; shift < 64; shift += 8) to += static_cast<char>(number >> shift & 0xffU);
}

std::uint64_t numberAt(std::string_view text, std::size_t place) {
  std::uint64_t number = 0;
  for (unsigned i = 0; i < 8; ++i) number |= std::uint64_t{static_cast<std::uint8_t>(text[place + i])} << (8 * i);
  return number;
}

std::uint64_t hashOf(std::string_view bytes) {
  base::Hash hash;
  hash.add(bytes);
  return hash.value();
}

/// @return Why it failed; empty on success.
std::string writeWhole(const fs::path& file, std::string_view bytes) {
  base::FileDescriptor open(::open(file.c_str(), O_WRONLY | O_CREAT | O_EXCL | O_CLOEXEC, 0644));
  if (!open.isOpen()) return std::strerror(errno);
  while (!bytes.empty()) {
    const ::ssize_t count = ::write(open.number(), bytes.data(), bytes.size());
    if (count < 0 && errno == EINTR) continue;
    if (count <= 0) return std::strerror(errno);
    bytes.remove_prefix(static_cast<std::size_t>(count));
  }
  return open.close() ? std::string() : std::strerror(errno);
}

}  // namespace

FileCache::FileCache(fs::path folder, std::uintmax_t mostBytes) : folder_(std::move(folder)), mostBytes_(mostBytes) {}

fs::path FileCache::userFolder() {
  const auto folder = [](const char* name) {
    const char* const value = std::getenv(name);
    return fs::path(value != nullptr ? value : "");
  };
  fs::path caches = folder("XDG_CACHE_HOME");
  if (!caches.is_absolute()) {
    const fs::path home = folder("HOME");
    if (!home.is_absolute()) return {};
    caches = home / ".cache";
  }
  return caches / "pongsim" / "meshes";
}

std::optional<std::string> FileCache::find(std::string_view name) const {
  if (folder_.empty()) return std::nullopt;
  const fs::path file = folder_ / (std::string(name) + std::string(kEnding));
  auto read = base::readRegularFile(file, kLargestFile);
  auto* const bytes = std::get_if<std::string>(&read);
  if (bytes == nullptr || bytes->size() < kHeader || !bytes->starts_with(kMagic)) return std::nullopt;
  if (numberAt(*bytes, kMagic.size()) != bytes->size() - kHeader) return std::nullopt;
  const std::uint64_t hash = numberAt(*bytes, kMagic.size() + 8);
  bytes->erase(0, kHeader);
  if (hashOf(*bytes) != hash) return std::nullopt;
  // mark it as recently used
  std::error_code ignored;
  fs::last_write_time(file, fs::file_time_type::clock::now(), ignored);
  return std::move(*bytes);
}

std::string FileCache::keep(std::string_view name, std::string_view bytes) const {
  if (folder_.empty()) return "there is no folder for it";
  if (bytes.size() > kLargestFile - kHeader) return "it is too large";
  std::error_code error;
  fs::create_directories(folder_, error);
  if (error) return error.message();
  std::string whole(kMagic);
  appendNumber(bytes.size(), whole);
  appendNumber(hashOf(bytes), whole);
  whole += bytes;

  // written under a unique name and renamed when complete, so that no reader sees a part of it
  static std::atomic<unsigned> count = 0;
  const fs::path file = folder_ / (std::string(name) + std::string(kEnding));
  fs::path draft = file;
  draft += "." + std::to_string(::getpid()) + "." + std::to_string(++count);
  std::string problem = writeWhole(draft, whole);
  if (problem.empty()) {
    fs::rename(draft, file, error);
    if (error) problem = error.message();
  }
  if (!problem.empty()) {
    fs::remove(draft, error);
    return problem;
  }
  prune();
  return {};
}

void FileCache::prune() const {
  struct CachedFile {
    fs::file_time_type time;
    std::uintmax_t size;
    fs::path path;
  };
  std::vector<CachedFile> files;
  std::uintmax_t sum = 0;
  std::error_code error;
  for (fs::directory_iterator at(folder_, error), end; !error && at != end; at.increment(error)) {
    // only the cache's own files, which other processes may delete meanwhile
    if (at->path().filename().string().find(kEnding) == std::string::npos) continue;
    std::error_code gone;
    const CachedFile cached{at->last_write_time(gone), at->file_size(gone), at->path()};
    if (gone) continue;
    sum += cached.size;
    files.push_back(cached);
  }
  if (sum <= mostBytes_) return;
  std::ranges::sort(files, [](const CachedFile& a, const CachedFile& b) {
    return a.time != b.time ? a.time < b.time : a.path < b.path;
  });
  for (const CachedFile& cached : files) {
    if (sum <= mostBytes_ / 4 * 3) break;
    std::error_code ignored;
    fs::remove(cached.path, ignored);
    sum -= cached.size;
  }
}

}  // namespace pongsim::assets
