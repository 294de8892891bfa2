#pragma once

#include <ctime>
#include <optional>
#include <stdexcept>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "pongsim/export.hh"

namespace pongsim {

/// An invalid keystore or identity: the file and the reason, in a sentence without a full stop.
class PONGSIM_API KeystoreError : public std::runtime_error {
 public:
  explicit KeystoreError(const std::string& message, std::string hint = {})
      : std::runtime_error(message), hint_(std::move(hint)) {}
  /// A hint, or empty.
  const std::string& hint() const { return hint_; }

 private:
  std::string hint_;
};

/// An `<allow_rule>` or `<deny_rule>` of DDS-Security permissions. Topic patterns are those of fnmatch(3).
struct TopicRule {
  bool isAllowed = true;
  /// Domains from the first to the second number.
  std::vector<std::pair<int, int>> domains;
  std::vector<std::string> publish;
  std::vector<std::string> subscribe;

  bool covers(int domain) const;
};

/// Identity of a participant in DDS-Security: a folder with its certificate, key, permissions and governance, such as
/// those made by `ros2 security create_enclave`.
struct SecureIdentity {
  /// Its name in the keystore, "/robot".
  std::string name;
  /// With symbolic links resolved.
  std::string folder;
  /// Subject of the certificate in the form of RFC 2253: "CN=/robot".
  std::string subject;
  /// Period in which all its certificates and permissions are valid.
  std::time_t validFrom = 0;
  std::time_t validUntil = 0;
  /// From the permissions: the first rule with a matching pattern decides; without one, a topic is denied.
  std::vector<TopicRule> rules;
};

enum class TopicUse { kPublish, kSubscribe };

/// @return Whether the identity may use a DDS topic in this way in that domain.
PONGSIM_API bool isPermitted(const SecureIdentity& identity, int domain, TopicUse use, std::string_view topic);

/// @param place A keystore's folder, or KEYSTORE/NAME. Without a name: the identity "pongsim", or the only one.
/// @return The identity's folder.
/// @throws KeystoreError if there is none.
PONGSIM_API std::string identityFolder(const std::string& place);

/// @return The names of a keystore's identities, sorted, each with a leading slash.
/// @throws KeystoreError if the folder is not a keystore.
PONGSIM_API std::vector<std::string> identitiesOf(const std::string& keystore);

/// Reads the files of an identity and checks everything that can be checked without a peer: that they exist, that no
/// one else can read the key, that key and certificates match and are valid now, that governance and permissions are
/// signed, well-formed and free of contradictions, and that they are for this identity and domain.
/// @param domain The DDS domain it is used in; unset: any.
/// @throws KeystoreError
PONGSIM_API SecureIdentity readIdentity(const std::string& folder, std::optional<int> domain = std::nullopt);

/// @return Whether the environment variable PONGSIM_SECURITY is set and not empty.
PONGSIM_API bool isSecured();

/// Sets PONGSIM_SECURITY for this process: its participants use the identity at `place`. Not thread-safe.
PONGSIM_API void secureBy(const std::string& place);

/// @return The identity selected by PONGSIM_SECURITY (a `place`) for participants in that domain; nothing if topics are
/// not secured.
/// @throws KeystoreError
PONGSIM_API std::optional<SecureIdentity> chosenIdentity(int domain);

/// @return The content of a file in a keystore.
/// @throws KeystoreError if it does not exist or can't be read.
PONGSIM_API std::string readKeystoreFile(const std::string& file);

/// Like `readKeystoreFile`.
/// @throws KeystoreError also if users other than the owner can read it.
PONGSIM_API std::string readSecretFile(const std::string& file);

/// Checks unsigned permissions like `readIdentity`.
/// @param file Name for messages.
/// @param subject Subject of the identity they are for.
/// @throws KeystoreError
PONGSIM_API void checkPermissions(const std::string& file, const std::string& text, const std::string& subject);

/// @return The participant properties (names and values) with which DDS-Security plugins use the identity.
PONGSIM_API std::vector<std::pair<std::string, std::string>> securityProperties(const SecureIdentity& identity);

}  // namespace pongsim
