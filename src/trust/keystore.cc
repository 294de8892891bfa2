#include "trust/keystore.hh"

#include <algorithm>
#include <cstdlib>

#include "pongsim/program/keystore.hh"

namespace pongsim {

namespace {

namespace fs = std::filesystem;

constexpr const char* kVariable = "PONGSIM_SECURITY";
constexpr const char* kIdentities = "enclaves";
// The file that makes a folder an identity.
constexpr const char* kKeyFile = "key.pem";
// The default identity.
constexpr const char* kOwnName = "/pongsim";

bool isFolder(const fs::path& path) {
  std::error_code error;
  return fs::is_directory(path, error);
}

bool isThere(const fs::path& path) {
  std::error_code error;
  return fs::exists(fs::symlink_status(path, error));
}

std::string listed(const std::vector<std::string>& names) {
  std::string text;
  for (const std::string& each : names) text += (text.empty() ? "" : ", ") + each.substr(1);
  return text;
}

[[noreturn]] void refuseKeystore(const std::string& place) {
  throw KeystoreError("there is no keystore at '" + place + "'", "'pongsim security init " + place + "' makes one");
}

/// @return The folder of the identity to use if none is named.
fs::path onlyIdentity(const fs::path& keystore) {
  const std::vector<std::string> names = identitiesOf(keystore.string());
  const bool hasOwn = std::ranges::find(names, kOwnName) != names.end();
  if (names.empty()) {
    throw KeystoreError("keystore '" + keystore.string() + "' has no identity",
                        "'pongsim security add NAME --keystore " + keystore.string() + "' adds one");
  }
  if (!hasOwn && names.size() > 1) {
    throw KeystoreError("keystore '" + keystore.string() + "' has several identities: " + listed(names),
                        "say which: " + (keystore / names.front().substr(1)).string());
  }
  return keystore / kIdentities / (hasOwn ? kOwnName : names.front()).substr(1);
}

}  // namespace

std::vector<std::string> identitiesOf(const std::string& keystore) {
  const fs::path root = fs::path(keystore) / kIdentities;
  if (!isFolder(root)) refuseKeystore(keystore);
  std::vector<std::string> names;
  std::error_code error;
  fs::recursive_directory_iterator each(root, fs::directory_options::skip_permission_denied, error);
  for (; !error && each != fs::recursive_directory_iterator(); each.increment(error)) {
    if (each->path().filename() != kKeyFile) continue;
    names.push_back("/" + each->path().parent_path().lexically_relative(root).generic_string());
  }
  if (error) throw KeystoreError(root.string() + " can't be read: " + error.message());
  std::ranges::sort(names);
  return names;
}

std::string identityFolder(const std::string& place) {
  const fs::path path = fs::path(place).lexically_normal();
  if (isFolder(path) && isThere(path / kKeyFile)) return path.string();
  // the longest part of KEYSTORE/NAME that is a keystore
  for (fs::path root = path;; root = root.parent_path()) {
    if (isFolder(root.empty() ? fs::path(kIdentities) : root / kIdentities)) {
      const fs::path name = path.lexically_relative(root.empty() ? "." : root);
      if (name.empty() || name == ".") return onlyIdentity(root).string();
      const fs::path folder = root / kIdentities / name;
      if (isThere(folder / kKeyFile)) return folder.string();
      const std::vector<std::string> names = identitiesOf(root.empty() ? "." : root.string());
      throw KeystoreError("keystore '" + root.string() + "' has no identity '" + name.string() + "'" +
                              (names.empty() ? "" : ", but " + listed(names)),
                          "'pongsim security add " + name.string() + " --keystore " + root.string() + "' adds it");
    }
    if (root.empty() || root == root.parent_path()) refuseKeystore(place);
  }
}

bool isSecured() {
  const char* place = std::getenv(kVariable);
  return place != nullptr && *place != '\0';
}

void secureBy(const std::string& place) { setenv(kVariable, place.c_str(), 1); }

std::optional<SecureIdentity> chosenIdentity(int domain) {
  if (!isSecured()) return std::nullopt;
  return readIdentity(identityFolder(std::getenv(kVariable)), domain);
}

namespace trust {

std::string nameOf(const fs::path& folder) {
  for (fs::path root = folder.parent_path(); root != root.parent_path(); root = root.parent_path()) {
    if (root.filename() == kIdentities) return "/" + folder.lexically_relative(root).generic_string();
  }
  return "/" + folder.filename().string();
}

}  // namespace trust

}  // namespace pongsim
