#include "log/playback/played_files.hh"

#include <stdlib.h>

#include <cerrno>
#include <cstring>
#include <fstream>
#include <system_error>

#include "log/record/record_folder.hh"
#include "log/store/failure.hh"
#include "log/store/zip.hh"

namespace pongsim::log {

namespace fs = std::filesystem;

namespace {

constexpr std::string_view kFilePrefix = "file://";

bool isZip(const fs::path& file) {
  char begin[2]{};
  std::ifstream(file, std::ios::binary).read(begin, sizeof begin);
  return begin[0] == 'P' && begin[1] == 'K';
}

fs::path makeTemporaryFolder() {
  std::string name = (fs::temp_directory_path() / "pongsim-log-XXXXXX").string();
  if (mkdtemp(name.data()) == nullptr)
    throw Failure("a folder for what is unpacked can't be made: " + std::string(std::strerror(errno)));
  return name;
}

}  // namespace

PlayedFiles::PlayedFiles(const fs::path& path) {
  std::error_code error;
  if (fs::is_directory(path, error)) {
    find(path);
  } else if (!fs::is_regular_file(path, error)) {
    throw Failure("there is no recording '" + path.string() + "'",
                  "it is a folder, a zip file or a .tlog file that pongsim run --record made");
  } else if (isZip(path)) {
    unpacked_ = makeTemporaryFolder();
    try {
      unpackZip(path, unpacked_);
      find(unpacked_);
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

void PlayedFiles::find(const fs::path& folder) {
  std::error_code error;
  fs::path place = folder;
  // a zip file has a folder in it, of whatever name
  if (!fs::exists(place / kStateFile, error)) {
    for (const fs::directory_entry& each : fs::directory_iterator(folder, error)) {
      if (fs::exists(each.path() / kStateFile, error)) place = each.path();
    }
  }
  if (!fs::exists(place / kStateFile, error))
    throw Failure("there is no " + std::string(kStateFile) + " in '" + folder.string() + "'");
  folder_ = place;
  stateFile_ = place / kStateFile;
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
