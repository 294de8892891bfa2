#include "trust/secret_file.hh"

#include <sys/stat.h>

#include <cerrno>
#include <cstdio>
#include <cstring>
#include <fstream>
#include <sstream>

#include "pongsim/program/keystore.hh"

namespace pongsim {

std::string readKeystoreFile(const std::string& file) { return trust::contentsOf(file); }

std::string readSecretFile(const std::string& file) {
  std::string text = trust::contentsOf(file);
  trust::requireSecret(file);
  return text;
}

namespace trust {

namespace {

namespace fs = std::filesystem;

// Limit for the documents of a keystore, which are far smaller [bytes].
constexpr std::uintmax_t kLongestFile = 1 << 20;

unsigned modeOf(const fs::path& path) {
  struct stat about {};
  return stat(path.c_str(), &about) == 0 ? about.st_mode & 07777U : 0;
}

/// @return Whether another user can enter the folder: whether at each folder of the path, its group or others may. The
/// groups can differ from folder to folder, so a user may be in one folder's group and among the others of the next.
bool isReachable(const fs::path& folder) {
  for (fs::path each = folder;; each = each.parent_path()) {
    if ((modeOf(each) & (S_IXGRP | S_IXOTH)) == 0) return false;
    if (each == each.root_path()) return true;
  }
}

}  // namespace

std::string contentsOf(const fs::path& file) {
  std::error_code error;
  const fs::file_status status = fs::status(file, error);
  if (!fs::exists(status)) {
    const std::string why =
        fs::is_symlink(fs::symlink_status(file, error)) ? "is a broken symbolic link" : "is missing";
    throw KeystoreError(file.string() + " " + why, "'pongsim security add' creates all files of an identity");
  }
  if (!fs::is_regular_file(status)) throw KeystoreError(file.string() + " is not a file");
  if (const auto size = fs::file_size(file, error); error || size > kLongestFile) {
    throw KeystoreError(file.string() + " is " + (error ? "unreadable" : "too large for a file of a keystore"));
  }
  std::ifstream stream(file, std::ios::binary);
  if (!stream) throw KeystoreError(file.string() + " can't be read: " + std::strerror(errno));
  std::ostringstream text;
  text << stream.rdbuf();
  return text.str();
}

void requireSecret(const fs::path& file) {
  std::error_code error;
  const fs::path real = fs::canonical(file, error);
  if (error) throw KeystoreError(file.string() + " is missing");
  const unsigned mode = modeOf(real);
  if ((mode & (S_IRGRP | S_IROTH)) == 0 || !isReachable(real.parent_path())) return;
  char octal[16];
  std::snprintf(octal, sizeof octal, "%04o", mode);
  throw KeystoreError(file.string() + " can be read by other users (mode " + octal + ")", "chmod 600 " + real.string());
}

}  // namespace trust

}  // namespace pongsim
