#include "fuel/cache.hh"

#include <fcntl.h>
#include <sys/file.h>
#include <sys/stat.h>
#include <unistd.h>

#include <algorithm>
#include <cctype>
#include <cerrno>
#include <chrono>
#include <cstdio>
#include <cstring>
#include <fstream>
#include <functional>
#include <iterator>
#include <nlohmann/json.hpp>
#include <system_error>
#include <thread>
#include <tuple>

#include "fuel/failure.hh"
#include "fuel/interruption.hh"
#include "fuel/sdf_text.hh"

namespace pongsim::fuel {

namespace fs = std::filesystem;

namespace {

/// Interval of attempts to take a lock.
constexpr std::chrono::milliseconds kBetweenLooks{100};
/// Limit of a file name, NAME_MAX (255) minus room for suffixes [bytes].
constexpr std::size_t kLongestName = 200;

/// @return The subfolders of a folder, sorted by name.
std::vector<fs::path> foldersIn(const fs::path& folder) {
  std::vector<fs::path> folders;
  std::error_code error;
  for (fs::directory_iterator entry(folder, error), end; !error && entry != end; entry.increment(error)) {
    std::error_code ignored;
    if (entry->is_directory(ignored)) folders.push_back(entry->path());
  }
  std::ranges::sort(folders);
  return folders;
}

/// @return The version number that is the name of a folder; nothing for other names.
std::optional<int> versionOf(const fs::path& folder) {
  const std::string name = folder.filename().string();
  const bool isNumber = !name.empty() && name.size() <= 7 && name.front() != '0' &&
                        std::ranges::all_of(name, [](unsigned char each) { return std::isdigit(each) != 0; });
  return isNumber ? std::optional(std::stoi(name)) : std::nullopt;
}

/// @return The SDF files named in a model.config.
std::vector<std::string> filesNamedBy(const fs::path& config) {
  std::vector<std::string> names;
  for (const XmlText& each : xmlTexts(textOf(config))) {
    if (each.path == "/model/sdf") names.push_back(each.text);
  }
  return names;
}

bool leadsOut(const fs::path& link, const fs::path& folder) {
  std::error_code error;
  const fs::path target = fs::weakly_canonical(link, error), root = fs::weakly_canonical(folder, error);
  return error || std::ranges::mismatch(root, target).in1 != root.end();
}

}  // namespace

Lock::Lock(const fs::path& file) : file_(file) { open(); }

void Lock::open() {
  if (number_ >= 0) ::close(number_);
  number_ = ::open(file_.c_str(), O_RDWR | O_CREAT | O_CLOEXEC | O_NOFOLLOW, 0666);
  if (number_ < 0) throw Failure("'" + file_.string() + "' can't be created: " + std::strerror(errno));
}

Lock::~Lock() {
  struct stat mine {};
  // the file may be removed while this lock is held: `tryTake` checks that its own file still has a name
  if (::flock(number_, LOCK_EX | LOCK_NB) == 0 && ::fstat(number_, &mine) == 0 && mine.st_nlink > 0) {
    ::unlink(file_.c_str());
  }
  ::close(number_);
}

bool Lock::tryTake() {
  while (::flock(number_, LOCK_EX | LOCK_NB) == 0) {
    struct stat mine {};
    if (::fstat(number_, &mine) == 0 && mine.st_nlink > 0) return true;
    open();
  }
  return false;
}

void Lock::take() {
  while (!tryTake()) {
    checkInterruption();
    std::this_thread::sleep_for(kBetweenLooks);
  }
}

Workplace::Workplace(const FuelAddress& address, const fs::path& cache) {
  const fs::path root = cache / ".pongsim";
  std::string name;
  for (const fs::path& part : fs::relative(fuelFolder(address, "/"), "/"))
    name += (name.empty() ? "" : "+") + part.string();
  if (name.size() > kLongestName) name = name.substr(0, kLongestName) + std::to_string(std::hash<std::string>{}(name));
  std::error_code error;
  fs::create_directories(root, error);
  if (error) throw Failure("the folder '" + root.string() + "' can't be created: " + error.message());
  lock = root / (name + ".lock");
  zip = root / (name + ".zip");
  note = root / (name + ".json");
  folder = root / (name + ".unpacked");
}

std::optional<PartialDownload> PartialDownload::read(const fs::path& file) {
  std::ifstream stream(file);
  const auto json = nlohmann::json::parse(stream, nullptr, false);
  if (!json.is_object()) return std::nullopt;
  try {
    return PartialDownload{json.at("version").get<int>(), json.at("validator").get<std::string>(),
                           json.at("linked").get<bool>()};
  } catch (const nlohmann::json::exception&) {
    return std::nullopt;
  }
}

void PartialDownload::write(const fs::path& file) const {
  const nlohmann::json json{{"version", version}, {"validator", validator}, {"linked", isLinked}};
  writeText(file, json.dump(-1, ' ', false, nlohmann::json::error_handler_t::replace) + "\n");
}

void place(const fs::path& folder, const fs::path& target) {
  std::error_code error;
  fs::create_directories(target.parent_path(), error);
  if (error) throw Failure("the folder '" + target.parent_path().string() + "' can't be created: " + error.message());
  if (::rename(folder.c_str(), target.c_str()) == 0) return;
  const bool isTaken = errno == EEXIST || errno == ENOTEMPTY || errno == ENOTDIR;
  if (isTaken && ::renameat2(AT_FDCWD, folder.c_str(), AT_FDCWD, target.c_str(), RENAME_EXCHANGE) == 0) {
    fs::remove_all(folder, error);
    return;
  }
  throw Failure("'" + target.string() + "' can't be created: " + std::strerror(errno));
}

std::vector<CachedVersion> cachedVersions(const fs::path& cache) {
  std::vector<CachedVersion> versions;
  for (const fs::path& host : foldersIn(cache)) {
    if (host.filename() == ".pongsim") continue;
    for (const fs::path& owner : foldersIn(host)) {
      for (const bool isWorld : {false, true}) {
        for (const fs::path& name : foldersIn(owner / (isWorld ? "worlds" : "models"))) {
          const std::size_t first = versions.size();
          for (const fs::path& folder : foldersIn(name)) {
            const std::optional<int> number = versionOf(folder);
            if (!number) continue;
            FuelAddress address{
                .scheme = "https", .host = host.filename().string(), .owner = owner.filename().string()};
            address.isWorld = isWorld;
            address.name = name.filename().string();
            address.version = number;
            versions.push_back({address, folder});
          }
          std::sort(
              versions.begin() + static_cast<std::ptrdiff_t>(first), versions.end(),
              [](const CachedVersion& a, const CachedVersion& b) { return *a.address.version < *b.address.version; });
        }
      }
    }
  }
  return versions;
}

std::vector<std::string> faultsOf(const CachedVersion& version) {
  if (!isWholeFuelVersion(version.folder)) {
    return {"the zip file is still in it: Fortress is unpacking it or was interrupted"};
  }
  std::vector<std::string> faults;
  std::error_code error, ignored;
  if (version.address.isWorld) {
    if (sdfFilesIn(version.folder).empty()) faults.emplace_back("there is no SDF file in it");
  } else if (!fs::is_regular_file(version.folder / "model.config", ignored)) {
    faults.emplace_back("there is no model.config in it");
  } else {
    const std::vector<std::string> names = filesNamedBy(version.folder / "model.config");
    if (names.empty()) faults.emplace_back("its model.config has no <sdf>");
    for (const std::string& name : names) {
      if (!fs::is_regular_file(version.folder / name, ignored)) {
        faults.push_back("its model.config names '" + name + "', which does not exist");
      }
    }
  }
  for (fs::recursive_directory_iterator entry(version.folder, error), end; !error && entry != end;
       entry.increment(error)) {
    if (entry->is_symlink(ignored) && leadsOut(entry->path(), version.folder)) {
      faults.push_back("'" + entry->path().lexically_relative(version.folder).string() + "' is a link to outside it");
    }
  }
  if (error) faults.push_back("it can't be read: " + error.message());
  return faults;
}

std::vector<fs::path> sdfFilesIn(const fs::path& folder) {
  std::vector<fs::path> files;
  std::error_code error;
  for (fs::directory_iterator entry(folder, error), end; !error && entry != end; entry.increment(error)) {
    const std::string extension = entry->path().extension().string();
    std::error_code ignored;
    if ((extension == ".sdf" || extension == ".world") && entry->is_regular_file(ignored))
      files.push_back(entry->path());
  }
  std::ranges::sort(files);
  return files;
}

std::uint64_t sizeOf(const fs::path& path) {
  std::error_code error;
  if (fs::is_regular_file(path, error)) {
    const std::uintmax_t size = fs::file_size(path, error);
    return error ? 0 : size;
  }
  std::uint64_t total = 0;
  for (fs::recursive_directory_iterator entry(path, error), end; !error && entry != end; entry.increment(error)) {
    std::error_code ignored;
    if (entry->is_regular_file(ignored) && !entry->is_symlink(ignored)) total += entry->file_size(ignored);
  }
  return total;
}

std::string textOf(const fs::path& file) {
  std::ifstream stream(file, std::ios::binary);
  if (!stream) throw Failure("'" + file.string() + "' can't be read");
  return {std::istreambuf_iterator<char>(stream), {}};
}

void writeText(const fs::path& file, const std::string& text) {
  errno = 0;
  std::ofstream stream(file, std::ios::binary | std::ios::trunc);
  stream.write(text.data(), static_cast<std::streamsize>(text.size()));
  stream.close();
  if (!stream) throw Failure("'" + file.string() + "' can't be written: " + std::strerror(errno));
}

}  // namespace pongsim::fuel
