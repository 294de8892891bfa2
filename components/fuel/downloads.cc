#include "fuel/downloads.hh"

#include <fcntl.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <chrono>
#include <condition_variable>
#include <cstring>
#include <exception>
#include <mutex>
#include <set>
#include <system_error>
#include <thread>

#include "fuel/archive.hh"
#include "fuel/cache.hh"
#include "fuel/failure.hh"
#include "fuel/interruption.hh"
#include "fuel/sdf_text.hh"
#include "shared/program/stop_signal.hh"

namespace pongsim::fuel {

namespace fs = std::filesystem;

namespace {

constexpr int kMostTries = 3;
constexpr std::chrono::milliseconds kBetweenTries{500};
constexpr std::uint64_t kLargestZip = std::uint64_t{4} << 30U;
/// Limit of models and worlds per run, with their dependencies.
constexpr std::size_t kMostResources = 1000;
constexpr std::uint64_t kLargestText = std::uint64_t{64} << 20U;

/// Writes a zip file, and appends to an existing part.
class ZipFile {
 public:
  explicit ZipFile(const fs::path& path) : path_(path) {
    number_ = ::open(path.c_str(), O_WRONLY | O_CREAT | O_CLOEXEC | O_NOFOLLOW, 0666);
    if (number_ < 0) fail();
  }
  ~ZipFile() { ::close(number_); }
  ZipFile(const ZipFile&) = delete;
  ZipFile& operator=(const ZipFile&) = delete;

  void beginAt(std::uint64_t place) {
    if (::ftruncate(number_, static_cast<off_t>(place)) != 0) fail();
    if (::lseek(number_, static_cast<off_t>(place), SEEK_SET) < 0) fail();
    size_ = place;
  }
  void write(std::string_view bytes) {
    size_ += bytes.size();
    if (size_ > kLargestZip)
      throw Failure("its zip file is larger than " + sizeText(kLargestZip) + ", which is the limit");
    while (!bytes.empty()) {
      const ssize_t count = ::write(number_, bytes.data(), bytes.size());
      if (count < 0 && errno == EINTR) continue;
      if (count < 0) fail();
      bytes.remove_prefix(static_cast<std::size_t>(count));
    }
  }

 private:
  [[noreturn]] void fail() const {
    const int error = errno;
    std::error_code ignored;
    // frees the space: the part can't be completed on this disk
    if (error != EINTR) fs::remove(path_, ignored);
    throw Failure("'" + path_.string() + "' can't be written: " + std::strerror(error),
                  error == ENOSPC || error == EDQUOT || error == EFBIG
                      ? "free disk space, or set IGN_FUEL_CACHE_PATH to a folder on another disk"
                      : "");
  }

  fs::path path_;
  int number_ = -1;
  std::uint64_t size_ = 0;
};

/// Deletes a folder with its contents on destruction.
class ShortLivedFolder {
 public:
  explicit ShortLivedFolder(fs::path path) : path_(std::move(path)) {
    std::error_code error;
    fs::remove_all(path_, error);
    fs::create_directories(path_, error);
    if (error) throw Failure("the folder '" + path_.string() + "' can't be created: " + error.message());
  }
  ~ShortLivedFolder() {
    std::error_code ignored;
    fs::remove_all(path_, ignored);
  }
  ShortLivedFolder(const ShortLivedFolder&) = delete;
  ShortLivedFolder& operator=(const ShortLivedFolder&) = delete;

 private:
  fs::path path_;
};

/// Converts unpacked files to the form in which Fortress caches them.
/// @throws Failure if they are no model or world.
void finish(const fs::path& folder, const FuelAddress& address) {
  const CachedVersion unpacked{address, folder};
  for (const std::string& fault : faultsOf(unpacked)) throw Failure("the server's response can't be used: " + fault);
  if (address.isWorld) return;
  for (const fs::path& file : sdfFilesIn(folder)) {
    if (sizeOf(file) > kLargestText) continue;
    const std::string text = textOf(file);
    const auto has = [&](const std::string& path) {
      std::error_code ignored;
      return fs::exists(folder / path, ignored);
    };
    std::string replaced = withFuelAddresses(text, address, has);
    if (replaced != text) writeText(file, replaced);
  }
}

void removePart(const Workplace& workplace) {
  std::error_code ignored;
  fs::remove(workplace.zip, ignored);
  fs::remove(workplace.note, ignored);
}

std::string validatorOf(const Answer& answer) {
  const std::string tag = answer.header("etag");
  // a weak ETag allows different bytes (RFC 9110, 8.8.1)
  return !tag.empty() && !tag.starts_with("W/") ? tag : answer.header("last-modified");
}

}  // namespace

std::string keyOf(const FuelAddress& address) {
  std::string key = fuelFolder(address, "").string();
  if (const std::string other = otherFuelHost(address.host); !other.empty()) {
    FuelAddress there = address;
    there.host = std::max(address.host, other);
    key = fuelFolder(there, "").string();
  }
  return key + "/" + (address.version ? std::to_string(*address.version) : "tip");
}

std::string nameOf(const FuelAddress& address) {
  return address.owner + "/" + address.name + (address.version ? " version " + std::to_string(*address.version) : "");
}

std::vector<FuelAddress> neededBy(const fs::path& folder) {
  std::vector<std::string> addresses;
  std::vector<fs::path> files = sdfFilesIn(folder);
  std::error_code ignored;
  for (const char* name : {"model.config", "metadata.pbtxt"}) {
    if (fs::is_regular_file(folder / name, ignored)) files.push_back(folder / name);
  }
  for (const fs::path& file : files) {
    if (sizeOf(file) > kLargestText) continue;
    const std::string text = textOf(file);
    std::ranges::copy(file.extension() == ".pbtxt" ? fuelAddressesInQuotes(text) : fuelAddressesInXml(text),
                      std::back_inserter(addresses));
  }
  std::vector<FuelAddress> needed;
  std::set<std::string> known;
  for (const std::string& text : addresses) {
    FuelAddress address = *parseFuelAddress(text);
    address.file.clear();
    if (known.insert(keyOf(address)).second) needed.push_back(address);
  }
  return needed;
}

/// Addresses to download, and results. Shared by the threads of `run`.
struct Downloads::Queue {
  std::mutex mutex;
  std::condition_variable changed;
  std::vector<DownloadResult> all;
  std::size_t next = 0;
  std::size_t busy = 0;
  std::set<std::string> known;
  bool isTooMuch = false;

  void add(FuelAddress address, bool isWanted) {
    address.file.clear();
    if (!known.insert(keyOf(address)).second) return;
    if (all.size() >= kMostResources && !isWanted) {
      isTooMuch = true;
      return;
    }
    all.push_back({std::move(address), isWanted, {}, {}, {}});
  }
};

Downloads::Downloads(const Settings& settings, const DownloadOptions& options, Progress& progress)
    : settings_(settings), options_(options), progress_(progress) {}

std::vector<DownloadResult> Downloads::run(const std::vector<FuelAddress>& addresses) {
  Queue queue;
  for (const FuelAddress& address : addresses) queue.add(address, true);
  std::vector<std::jthread> threads;
  try {
    for (std::size_t i = 1; i < options_.jobs; ++i) threads.emplace_back([&] { work(queue); });
  } catch (const std::system_error& error) {
    progress_.warning("at most " + std::to_string(threads.size() + 1) +
                      " downloads at once: " + error.code().message());
  }
  work(queue);
  threads.clear();
  checkInterruption();
  if (queue.isTooMuch) {
    progress_.warning("more than " + std::to_string(kMostResources) +
                      " models and worlds refer to each other: the rest is skipped");
  }
  return std::move(queue.all);
}

void Downloads::work(Queue& queue) {
  std::unique_lock lock(queue.mutex);
  while (true) {
    queue.changed.wait(lock, [&] { return queue.next < queue.all.size() || queue.busy == 0; });
    if (queue.next == queue.all.size()) return;
    const std::size_t index = queue.next++;
    ++queue.busy;
    DownloadResult result = queue.all[index];
    lock.unlock();
    std::vector<FuelAddress> needed;
    try {
      result.folder = bring(result.address, result.isWanted);
      needed = neededBy(result.folder);
    } catch (const Failure& failure) {
      result.folder.clear();
      result.why = failure.what();
      result.hint = failure.hint();
    } catch (const std::exception& failure) {
      result.folder.clear();
      result.why = failure.what();
    }
    lock.lock();
    queue.all[index] = result;
    if (!cli::isStopped()) {
      for (FuelAddress& address : needed) queue.add(std::move(address), false);
    }
    --queue.busy;
    queue.changed.notify_all();
  }
}

fs::path Downloads::bring(const FuelAddress& address, bool isWanted) {
  checkInterruption();
  // a version given by its number never changes, so the server need not be asked for a newer one
  const bool isAsked = options_.isUpdate && isWanted && !address.version;
  const auto cached = [&]() -> std::optional<fs::path> {
    return isAsked ? std::nullopt : findInFuelCache(address, settings_.cache);
  };
  if (const auto folder = cached()) return *folder;
  const Server& known = serverOf(address, settings_);
  if (isFuelOffline()) throw Failure("it is not in the cache, and downloads are off");
  const Workplace workplace(address, settings_.cache);
  Lock lock(workplace.lock);
  if (!lock.tryTake()) {
    progress_.info(nameOf(address) + ": waiting for another download of it");
    lock.take();
  }
  // checked again, because another process may have downloaded it while this one waited for the lock
  if (const auto folder = cached()) return *folder;
  FuelServer server(known, isWanted ? options_.headers : std::vector<std::string>());
  FuelAddress there = address;
  // the configured scheme: the address in a world may be "http"
  there.scheme = known.url.substr(0, known.url.find("://"));
  return bringFrom(server, there);
}

fs::path Downloads::bringFrom(FuelServer& server, FuelAddress address) {
  const fs::path versions = fuelFolder(address, settings_.cache);
  if (!address.version) {
    const Details details = server.details(address);
    if (details.version > 0) address.version = details.version;
    const auto cached = address.version ? findInFuelCache(address, settings_.cache) : std::nullopt;
    if (cached) {
      progress_.info(nameOf(address) + ": the newest version is in the cache");
      return *cached;
    }
  }
  const Workplace workplace(address, settings_.cache);
  const std::string name = nameOf(address);
  const bool isNumbered = address.version.has_value();
  try {
    loadZip(server, address, workplace);
    const ShortLivedFolder folder(workplace.folder);
    try {
      unpack(workplace.zip, workplace.folder);
    } catch (const Interrupted&) {
      throw;
    } catch (const Failure&) {
      // a retry must not continue a damaged file
      removePart(workplace);
      throw;
    }
    const std::uint64_t bytes = sizeOf(workplace.zip);
    removePart(workplace);
    finish(workplace.folder, address);
    place(workplace.folder, versions / std::to_string(*address.version));
    progress_.end(name, sizeText(bytes) + (isNumbered ? "" : ", version " + std::to_string(*address.version)));
  } catch (...) {
    progress_.drop(name);
    throw;
  }
  return versions / std::to_string(*address.version);
}

void Downloads::loadZip(FuelServer& server, FuelAddress& address, const Workplace& workplace) {
  for (int tries = 1;; ++tries) {
    try {
      return loadOnce(server, address, workplace);
    } catch (const PassingFailure& failure) {
      if (tries == kMostTries) throw;
      progress_.warning(nameOf(address) + ": " + failure.what() + "; trying again");
    }
    checkInterruption();
    std::this_thread::sleep_for(kBetweenTries * tries);
  }
}

void Downloads::loadOnce(FuelServer& server, FuelAddress& address, const Workplace& workplace) {
  const std::string name = nameOf(address);
  const std::optional<PartialDownload> partial = PartialDownload::read(workplace.note);
  const bool isUsable = partial && !partial->validator.empty() && partial->version == address.version.value_or(0);
  const std::uint64_t have = isUsable ? sizeOf(workplace.zip) : 0;
  std::optional<ZipFile> file;
  int version = 0;
  bool goesOn = false;
  const auto begin = [&](int number, bool isLinked, const Answer& answer) {
    version = number;
    if (number > 0 && address.version && number != *address.version) {
      throw Failure(
          "the server sends version " + std::to_string(number) + " instead of " + std::to_string(*address.version),
          "leave out the version for the newest");
    }
    goesOn = have > 0 && answer.status == 206;
    if (goesOn && !answer.header("content-range").starts_with("bytes " + std::to_string(have) + "-")) {
      removePart(workplace);
      throw PassingFailure("the server sent a different part than requested", "try again");
    }
    const std::uint64_t length = answer.length();
    if (length > kLargestZip)
      throw Failure("its zip file has " + sizeText(length) + "; " + sizeText(kLargestZip) + " is the limit");
    file.emplace(workplace.zip);
    file->beginAt(goesOn ? have : 0);
    PartialDownload{address.version.value_or(0), validatorOf(answer), isLinked}.write(workplace.note);
    progress_.begin(name, goesOn ? have : 0, length == 0 ? 0 : length + (goesOn ? have : 0));
  };
  try {
    server.zip(address, have, isUsable ? partial->validator : "", isUsable && partial->isLinked, begin,
               [&](std::string_view bytes) {
                 file->write(bytes);
                 progress_.add(name, bytes.size());
               });
  } catch (const PassingFailure&) {
    throw;
  } catch (const Interrupted&) {
    throw;
  } catch (const Failure&) {
    removePart(workplace);
    // the server may have rejected the range, because the part is longer than its file
    if (have > 0 && !goesOn && version == 0) throw PassingFailure("the download can't be resumed", "try again");
    throw;
  }
  if (version > 0) address.version = version;
  if (!address.version) address.version = 1;
}

}  // namespace pongsim::fuel
