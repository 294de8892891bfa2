#include "security/actions.hh"

#include <algorithm>
#include <cctype>
#include <cstdlib>
#include <ctime>
#include <filesystem>
#include <nlohmann/json.hpp>
#include <optional>
#include <utility>

#include "pongsim/program/keystore.hh"
#include "security/authority.hh"
#include "security/new_folder.hh"
#include "shared/program/console.hh"
#include "shared/program/failure.hh"

namespace pongsim::security {

namespace {

namespace fs = std::filesystem;
using cli::Failure;
using cli::UsageError;

constexpr const char* kOwnName = "/pongsim";
constexpr const char* kUsualFolder = "keystore";
constexpr int kAuthorityDays = 3650;
constexpr int kIdentityDays = 365;
// Upper bound of an X.509 common name (ub-common-name, RFC 5280) [characters].
constexpr std::size_t kLongestName = 64;

/// @return The nearest parent folder that is a keystore; `place` if there is none.
std::string keystoreOf(const std::string& place) {
  std::error_code error;
  for (fs::path root = place; !root.empty() && root != root.parent_path(); root = root.parent_path()) {
    if (fs::is_directory(root / "enclaves", error)) return root.string();
  }
  return place;
}

std::string keystoreFor(const Options& options) {
  if (!options.keystore.empty()) return options.keystore;
  for (const char* variable : {"PONGSIM_SECURITY", "ROS_SECURITY_KEYSTORE"}) {
    const char* place = std::getenv(variable);
    if (place != nullptr && *place != '\0') return keystoreOf(place);
  }
  return kUsualFolder;
}

/// @return The enclave's name with a leading "/": "/fleet/robot_1".
std::string checkedName(const std::string& given) {
  const std::string name = given.starts_with('/') ? given : "/" + given;
  bool isFine = name.size() > 1 && name.size() <= kLongestName;
  for (std::size_t i = 1; i < name.size() && isFine; ++i) {
    const auto letter = static_cast<unsigned char>(name[i]);
    const bool isFirst = name[i - 1] == '/';
    isFine = letter == '_' || (letter == '/' && !isFirst) || (letter < 0x80 && std::isalpha(letter) != 0) ||
             (std::isdigit(letter) != 0 && !isFirst);
  }
  if (isFine && !name.ends_with('/')) return name;
  throw UsageError(
      "'" + given + "' is not a valid identity name",
      "use letters, digits and '_', separated by '/', no part beginning with a digit: 'robot' or 'fleet/robot_1'");
}

void checkPatterns(const Permissions& permissions) {
  const auto check = [](const char* option, const std::vector<std::string>& patterns) {
    for (const std::string& each : patterns) {
      const bool isFine = !each.empty() && std::ranges::none_of(each, [](unsigned char letter) {
        return std::isspace(letter) != 0 || std::iscntrl(letter) != 0;
      });
      if (!isFine) throw UsageError("option '" + std::string(option) + "' takes a name like /cmd_vel or '/robot/*'");
    }
  };
  check("--allow-publish", permissions.publish);
  check("--allow-subscribe", permissions.subscribe);
  check("--allow-call", permissions.call);
  check("--allow-offer", permissions.offer);
}

/// The two certificate authorities of a keystore: for identities and for permissions. They may be the same.
struct Authorities {
  const Credentials& identity;
  const Credentials& permissions;
};

/// Writes an identity's files into a folder, with links to the files that all identities share.
/// @param up The relative path from the folder to the keystore: "../..".
/// @param permissionsFile A permissions document to sign; empty: one is made from `permissions`.
void writeIdentity(NewFolder& folder, const fs::path& at, const fs::path& up, const std::string& name, int days,
                   const Authorities& authorities, const Permissions& permissions, const std::string& permissionsFile) {
  const Credentials made = makeIdentity(name, days, authorities.identity);
  std::string document;
  if (permissionsFile.empty()) {
    document = permissionsDocument(name, made.validFrom(), made.validUntil(), permissions);
  } else {
    document = readKeystoreFile(permissionsFile);
    checkPermissions(permissionsFile, document, "CN=" + name);
  }
  folder.write(at / "key.pem", made.keyAsPem());
  folder.write(at / "cert.pem", made.certificateAsPem());
  folder.write(at / "permissions.xml", document);
  folder.write(at / "permissions.p7s", signedBy(authorities.permissions, document));
  for (const char* file : {"identity_ca.cert.pem", "permissions_ca.cert.pem"}) {
    folder.link(at / file, up / "public" / file);
  }
  folder.link(at / "governance.p7s", up / "enclaves/governance.p7s");
}

std::string dayOf(std::time_t time) {
  std::tm parts{};
  gmtime_r(&time, &parts);
  char text[32];
  std::strftime(text, sizeof text, "%F", &parts);
  return text;
}

/// An identity, or why it can't be used.
struct ListedIdentity {
  std::string name;
  SecureIdentity identity;
  std::string error;
  std::string hint;
};

ListedIdentity listedIdentity(const fs::path& keystore, const std::string& name) {
  try {
    return {name, readIdentity((keystore / "enclaves" / name.substr(1)).string()), "", ""};
  } catch (const KeystoreError& error) {
    return {name, {}, error.what(), error.hint()};
  }
}

/// @return "all topics", or a list of patterns, with "not" before the denied ones.
std::string patternsOf(const SecureIdentity& identity, std::vector<std::string> TopicRule::*use) {
  std::string text;
  for (const TopicRule& rule : identity.rules) {
    for (const std::string& pattern : rule.*use) {
      if (rule.isAllowed && pattern == "*" && text.empty()) return "all topics";
      if (isEverybodys(pattern)) continue;
      text += std::string(text.empty() ? "" : ", ") + (rule.isAllowed ? "" : "not ") + pattern;
    }
  }
  return text.empty() ? "no topic" : text;
}

std::string textOf(const ListedIdentity& listed) {
  if (!listed.error.empty()) {
    return listed.name + "\n  error:       " + listed.error +
           (listed.hint.empty() ? "\n" : "\n  hint:        " + listed.hint + "\n");
  }
  return listed.name + "\n  subject:     " + listed.identity.subject +
         "\n  valid until: " + dayOf(listed.identity.validUntil) +
         "\n  publishes:   " + patternsOf(listed.identity, &TopicRule::publish) +
         "\n  subscribes:  " + patternsOf(listed.identity, &TopicRule::subscribe) + "\n";
}

nlohmann::json jsonOf(const ListedIdentity& listed) {
  nlohmann::json object = {{"name", listed.name}};
  if (!listed.error.empty()) {
    object["error"] = listed.error;
    return object;
  }
  object["folder"] = listed.identity.folder;
  object["subject"] = listed.identity.subject;
  object["validFrom"] = dayOf(listed.identity.validFrom);
  object["validUntil"] = dayOf(listed.identity.validUntil);
  object["rules"] = nlohmann::json::array();
  for (const TopicRule& rule : listed.identity.rules) {
    object["rules"].push_back({{"allowed", rule.isAllowed},
                               {"domains", rule.domains},
                               {"publish", rule.publish},
                               {"subscribe", rule.subscribe}});
  }
  return object;
}

}  // namespace

namespace actions {

int init(const Options& options) {
  const fs::path keystore = fs::path(options.keystore.empty() ? kUsualFolder : options.keystore).lexically_normal();
  const int days = options.days == 0 ? kAuthorityDays : options.days;
  // "keys/" and "keys" are the same folder
  const fs::path place = keystore.has_filename() ? keystore : keystore.parent_path();
  NewFolder folder(place.parent_path());

  const Credentials authority = makeAuthority(days);
  folder.write("private/ca.key.pem", authority.keyAsPem());
  folder.write("public/ca.cert.pem", authority.certificateAsPem());
  for (const char* role : {"identity", "permissions"}) {
    folder.link("private/" + std::string(role) + "_ca.key.pem", "ca.key.pem");
    folder.link("public/" + std::string(role) + "_ca.cert.pem", "ca.cert.pem");
  }
  folder.write("enclaves/governance.xml", governanceDocument());
  folder.write("enclaves/governance.p7s", signedBy(authority, governanceDocument()));
  writeIdentity(folder, "enclaves/pongsim", "../..", kOwnName, kIdentityDays, {authority, authority}, {}, "");
  if (!folder.put(place)) {
    throw Failure("there is already something at '" + place.string() + "', and nothing is overwritten",
                  "'pongsim security list " + place.string() + "' shows a keystore");
  }
  cli::say("keystore '" + place.string() + "', with identity 'pongsim'\n  hint: pongsim run WORLD --secure " +
           place.string());
  return cli::kDone;
}

int add(const Options& options) {
  const std::string name = checkedName(options.name);
  checkPatterns(options.permissions);
  const fs::path keystore = keystoreFor(options);
  // throws if there is no keystore
  identitiesOf(keystore.string());
  const fs::path open = keystore / "public";
  const fs::path secret = keystore / "private";
  const Credentials identities = readCredentials(open / "identity_ca.cert.pem", secret / "identity_ca.key.pem");
  const Credentials permissions = readCredentials(open / "permissions_ca.cert.pem", secret / "permissions_ca.key.pem");
  if (identities.validUntil() <= std::time(nullptr)) {
    throw Failure("the authority of keystore '" + keystore.string() + "' expired on " + dayOf(identities.validUntil()),
                  "'pongsim security init' makes a new keystore");
  }

  fs::path up;
  for (const char letter : name) {
    if (letter == '/') up /= "..";
  }
  NewFolder folder(secret);
  writeIdentity(folder, ".", up / "..", name, options.days == 0 ? kIdentityDays : options.days,
                {identities, permissions}, options.permissions, options.permissionsFile);
  const fs::path place = keystore / "enclaves" / name.substr(1);
  if (!folder.put(place)) {
    throw Failure(
        "keystore '" + keystore.string() + "' already has '" + name.substr(1) + "', and nothing is overwritten",
        "remove " + place.string() + " first, or use another name");
  }
  cli::say("identity '" + name.substr(1) + "', valid until " + dayOf(readIdentity(place.string()).validUntil));
  return cli::kDone;
}

int list(const Options& options) {
  const std::string keystore = keystoreFor(options);
  nlohmann::json array = nlohmann::json::array();
  std::string text;
  bool isFine = true;
  for (const std::string& name : identitiesOf(keystore)) {
    const ListedIdentity listed = listedIdentity(keystore, name);
    isFine = isFine && listed.error.empty();
    text += textOf(listed);
    array.push_back(jsonOf(listed));
  }
  if (!options.asJson && text.empty()) cli::say("keystore '" + keystore + "' has no identity");
  const bool isPrinted = cli::print(options.asJson ? array.dump(2) + "\n" : text);
  return isPrinted && isFine ? cli::kDone : cli::kFailed;
}

}  // namespace actions

}  // namespace pongsim::security
