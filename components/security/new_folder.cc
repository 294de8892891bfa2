#include "security/new_folder.hh"

#include <fcntl.h>
#include <sys/stat.h>
#include <unistd.h>

#include <cerrno>
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <string>

#include "shared/program/failure.hh"

namespace pongsim::security {

namespace {

namespace fs = std::filesystem;

[[noreturn]] void fail(const fs::path& path, const char* what) {
  throw cli::Failure("can't " + std::string(what) + " " + path.string() + ": " + std::strerror(errno));
}

/// Writes the whole text to the disk.
bool writeAll(int file, std::string_view content) {
  while (!content.empty()) {
    const ssize_t count = ::write(file, content.data(), content.size());
    if (count < 0 && errno == EINTR) continue;
    if (count < 0) return false;
    content.remove_prefix(static_cast<std::size_t>(count));
  }
  return fsync(file) == 0;
}

}  // namespace

void makeFolders(const fs::path& folder) {
  struct stat about {};
  if (folder.empty() || (stat(folder.c_str(), &about) == 0 && S_ISDIR(about.st_mode))) return;
  makeFolders(folder.parent_path());
  if (mkdir(folder.c_str(), S_IRWXU) != 0 && errno != EEXIST) fail(folder, "make the folder");
}

NewFolder::NewFolder(const fs::path& beside) {
  makeFolders(beside);
  std::string name = ((beside.empty() ? "." : beside) / ".new-XXXXXX").string();
  // accessible only to its owner
  if (mkdtemp(name.data()) == nullptr) fail(beside, "make a folder in");
  path_ = name;
}

NewFolder::~NewFolder() {
  std::error_code error;
  if (!path_.empty()) fs::remove_all(path_, error);
}

void NewFolder::write(const fs::path& name, std::string_view content) {
  const fs::path path = path_ / name;
  makeFolders(path.parent_path());
  const int file = open(path.c_str(), O_WRONLY | O_CREAT | O_EXCL | O_CLOEXEC, S_IRUSR | S_IWUSR);
  if (file < 0) fail(path, "make");
  const bool isWritten = writeAll(file, content);
  const int error = errno;
  close(file);
  errno = error;
  if (!isWritten) fail(path, "write");
}

void NewFolder::link(const fs::path& name, const fs::path& target) {
  const fs::path path = path_ / name;
  makeFolders(path.parent_path());
  if (symlink(target.c_str(), path.c_str()) != 0) fail(path, "make the link");
}

bool NewFolder::put(const fs::path& place) {
  makeFolders(place.parent_path());
  if (std::rename(path_.c_str(), place.c_str()) == 0) {
    path_.clear();
    return true;
  }
  if (errno == ENOTEMPTY || errno == EEXIST || errno == ENOTDIR) return false;
  fail(place, "make");
}

}  // namespace pongsim::security
