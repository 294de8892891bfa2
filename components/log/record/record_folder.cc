#include "log/record/record_folder.hh"

#include <chrono>
#include <cstdio>
#include <cstdlib>
#include <ctime>
#include <system_error>

#include "log/store/failure.hh"

namespace pongsim::log {

namespace fs = std::filesystem;

namespace {

fs::path zipOf(const fs::path& folder) { return folder.string() + ".zip"; }

FolderLock lockOf(const fs::path& folder) {
  std::optional<FolderLock> lock = FolderLock::take(folder);
  if (lock) return *std::move(lock);
  throw Failure("'" + folder.string() + "' already contains a recording in progress",
                "give each recording a folder of its own");
}

}  // namespace

fs::path defaultRecordFolder() {
  const char* const home = std::getenv("HOME");
  const auto now = std::chrono::system_clock::now().time_since_epoch();
  const auto seconds = std::chrono::floor<std::chrono::seconds>(now);
  const std::time_t time = seconds.count();
  std::tm parts{};
  localtime_r(&time, &parts);
  char day[32], name[48];
  std::strftime(day, sizeof day, "%FT%T", &parts);
  std::snprintf(name, sizeof name, "%s.%09lld", day,
                static_cast<long long>(std::chrono::nanoseconds(now - seconds).count()));
  return fs::path(home == nullptr ? "." : home) / ".ignition/gazebo/log" / name;
}

RecordFolder makeRecordFolder(fs::path folder, const fs::path& zip, WhereTaken where) {
  std::error_code error;
  folder = fs::absolute(folder, error).lexically_normal();
  if (!folder.has_filename()) folder = folder.parent_path();
  RecordFolder made{.folder = folder, .zip = zip.empty() ? zipOf(folder) : fs::absolute(zip, error)};
  if (where == WhereTaken::kDelete) {
    if (fs::is_directory(made.folder, error)) lockOf(made.folder);
    fs::remove_all(made.folder, error);
    if (!error) fs::remove(made.zip, error);
    if (error) throw Failure("'" + made.folder.string() + "' can't be deleted: " + error.message());
  }
  for (int number = 1;
       where == WhereTaken::kTakeAnother && (fs::exists(made.folder, error) || fs::exists(made.zip, error)); ++number) {
    made.folder = folder.string() + "(" + std::to_string(number) + ")";
    made.zip = zipOf(made.folder);
  }
  fs::create_directories(made.folder, error);
  if (error || !fs::is_directory(made.folder, error)) {
    throw Failure("the folder '" + made.folder.string() +
                  "' can't be created: " + (error ? error.message() : "a file has that name"));
  }
  made.lock = lockOf(made.folder);
  return made;
}

}  // namespace pongsim::log
