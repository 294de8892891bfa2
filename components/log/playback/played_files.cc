#include "log/playback/played_files.hh"

#include <stdlib.h>

#include <algorithm>
#include <cerrno>
#include <cstring>
#include <fstream>
#include <system_error>
#include <vector>

#include "log/record/record_folder.hh"
#include "log/store/failure.hh"
#include "log/store/zip.hh"

namespace pongsim::log {

namespace fs = std::filesystem;

namespace {

constexpr std::string_view kFilePrefix = "file://";
constexpr std::size_t kMostListed = 8;

bool isZip(const fs::path& file) {
  char begin[2]{};
  std::ifstream(file, std::ios::binary).read(begin, sizeof begin);
  return begin[0] == 'P' && begin[1] == 'K';
}

/// @return The folder, if it is a recording; else the recordings in it, down to that depth: a zip file contains a
/// folder of any name, and a recording of several worlds has one folder for each.
std::vector<fs::path> recordingsIn(const fs::path& folder, int depth) {
  std::error_code error;
  if (fs::exists(folder / kStateFile, error)) return {folder};
  std::vector<fs::path> found;
  if (depth == 0) return found;
  for (const fs::directory_entry& each : fs::directory_iterator(folder, error)) {
    if (!each.is_directory(error)) continue;
    const std::vector<fs::path> inside = recordingsIn(each.path(), depth - 1);
    found.insert(found.end(), inside.begin(), inside.end());
  }
  return found;
}

fs::path makeTemporaryFolder() {
  std::string name = (fs::temp_directory_path() / "pongsim-log-XXXXXX").string();
  if (mkdtemp(name.data()) == nullptr)
    throw Failure("can't create a folder to unpack into: " + std::string(std::strerror(errno)));
  return name;
}

}  // namespace

PlayedFiles::PlayedFiles(const fs::path& path) {
  std::error_code error;
  if (fs::is_directory(path, error)) {
    find(path, path);
  } else if (!fs::is_regular_file(path, error)) {
    throw Failure("there is no recording '" + path.string() + "'",
                  "give a folder, zip file or .tlog file made by pongsim run --record");
  } else if (isZip(path)) {
    unpacked_ = makeTemporaryFolder();
    try {
      unpackZip(path, unpacked_);
      find(unpacked_, path);
    } catch (...) {
      fs::remove_all(unpacked_, error);
      throw;
    }
  } else {
    stateFile_ = path;
    folder_ = path.parent_path();
  }
}

PlayedFiles::~PlayedFiles() {
  std::error_code ignored;
  if (!unpacked_.empty()) fs::remove_all(unpacked_, ignored);
}

void PlayedFiles::find(const fs::path& folder, const fs::path& named) {
  std::vector<fs::path> found = recordingsIn(folder, 2);
  if (found.empty()) throw Failure("there is no " + std::string(kStateFile) + " in '" + named.string() + "'");
  if (found.size() > 1) {
    std::ranges::sort(found);
    std::string list;
    for (std::size_t i = 0; i < std::min(found.size(), kMostListed); ++i)
      list += (i == 0 ? "" : ", ") + found[i].filename().string();
    if (found.size() > kMostListed) list += " and " + std::to_string(found.size() - kMostListed) + " more";
    throw Failure("there are several recordings in '" + named.string() + "': " + list,
                  folder == named ? "play one at a time: '" + found.front().string() + "', for example"
                                  : "play one at a time: unpack it and give the folder of one");
  }
  folder_ = found.front();
  stateFile_ = folder_ / kStateFile;
}

std::string PlayedFiles::placeOf(const std::string& address) const {
  const bool hasPrefix = address.starts_with(kFilePrefix);
  const fs::path file(hasPrefix ? address.substr(kFilePrefix.size()) : address);
  std::error_code error;
  if (!file.is_absolute()) return address;
  const fs::path copy = fs::absolute(folder_, error) / file.relative_path();
  return fs::exists(copy, error) ? copy.string() : address;
}

}  // namespace pongsim::log
