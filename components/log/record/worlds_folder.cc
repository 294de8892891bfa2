#include "log/record/worlds_folder.hh"

#include <algorithm>
#include <map>
#include <mutex>
#include <utility>

#include "log/store/zip.hh"

namespace pongsim::log {

namespace fs = std::filesystem;

namespace {

/// The folders in use by this process, keyed by the request.
struct OpenFolders {
  std::mutex mutex;
  std::map<std::pair<std::string, std::string>, std::weak_ptr<WorldsFolder>> folders;
};

/// Never destroyed, because a recording may end during the exit of the process.
OpenFolders& openFolders() {
  static OpenFolders& open = *std::make_unique<OpenFolders>().release();
  return open;
}

std::string folderName(std::string_view world) {
  std::string name(world);
  std::ranges::replace(name, '/', '_');
  return name.find_first_not_of('.') == std::string::npos ? "_" + name : name;
}

}  // namespace

std::shared_ptr<WorldsFolder> WorldsFolder::join(const std::string& wanted, const std::string& zip, WhereTaken where) {
  OpenFolders& open = openFolders();
  const std::lock_guard lock(open.mutex);
  std::weak_ptr<WorldsFolder>& place = open.folders[{wanted, zip}];
  if (auto there = place.lock()) return there;
  const fs::path path = wanted.empty() ? defaultRecordFolder() : fs::path(wanted);
  const std::shared_ptr<WorldsFolder> made(new WorldsFolder(makeRecordFolder(path, zip, where)));
  place = made;
  return made;
}

RecordFolder WorldsFolder::folderOf(std::string_view world) const {
  return makeRecordFolder(all_.folder / folderName(world), {}, WhereTaken::kReplaceFiles);
}

void WorldsFolder::leave(std::shared_ptr<WorldsFolder> folder, bool mustPack) {
  OpenFolders& open = openFolders();
  const std::lock_guard lock(open.mutex);
  if (folder.use_count() > 1) {
    // under the lock: else several that leave at the same time would each see the other, and none would pack
    folder.reset();
    return;
  }
  std::erase_if(open.folders, [&folder](const auto& each) { return each.second.lock() == folder; });
  if (mustPack) packRecording(folder->all_);
}

void packRecording(const RecordFolder& recording) {
  packFolder(recording.folder, recording.zip);
  fs::remove_all(recording.folder);
}

}  // namespace pongsim::log
