#include "security/actions.hh"

#include <gtest/gtest.h>
#include <openssl/pem.h>
#include <openssl/x509v3.h>
#include <sys/stat.h>

#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <functional>
#include <sstream>

#include "pongsim/program/keystore.hh"
#include "security/authority.hh"
#include "shared/program/console.hh"
#include "shared/program/failure.hh"
#include "support/temp_folder.hh"

namespace pongsim::security {
namespace {

namespace fs = std::filesystem;

std::string contentOf(const fs::path& file) {
  std::ostringstream text;
  text << std::ifstream(file).rdbuf();
  return text.str();
}

void replace(const fs::path& file, const std::string& content) {
  fs::remove(file);
  std::ofstream(file) << content;
  fs::permissions(file, fs::perms::owner_read | fs::perms::owner_write);
}

unsigned modeOf(const fs::path& path) {
  struct stat about {};
  return lstat(path.c_str(), &about) == 0 ? about.st_mode & 07777U : 0;
}

/// @return The error message, with KEYS in place of the keystore's path; empty if there is none.
std::string refusal(const std::function<void()>& work, const fs::path& keystore) {
  try {
    work();
  } catch (const std::runtime_error& error) {
    std::string text = error.what();
    for (std::size_t at = text.find(keystore.string()); at != std::string::npos;
         at = text.find(keystore.string(), at)) {
      text.replace(at, keystore.string().size(), "KEYS");
    }
    return text;
  }
  return "";
}

class Keystore : public testing::Test {
 protected:
  Keystore() {
    for (const char* name : {"PONGSIM_SECURITY", "ROS_SECURITY_KEYSTORE"}) unsetenv(name);
    make(keys_);
  }

  static void make(const fs::path& place) {
    Options options;
    options.keystore = place.string();
    actions::init(options);
  }
  Options adding(const std::string& name) const {
    Options options;
    options.keystore = keys_.string();
    options.name = name;
    return options;
  }
  std::string refusalToAdd(const Options& options) const {
    return refusal([&] { actions::add(options); }, keys_);
  }
  Credentials authority() const { return readCredentials(keys_ / "public/ca.cert.pem", keys_ / "private/ca.key.pem"); }
  std::string refusalToRead(int domain = 0) const {
    return refusal([&] { readIdentity(identityFolder(keys_.string()), domain); }, keys_);
  }
  void sign(const std::string& file, const std::string& text) const {
    replace(own_ / file, signedBy(authority(), text));
  }
  static std::string replaced(std::string text, const std::string& from, const std::string& to) {
    text.replace(text.find(from), from.size(), to);
    return text;
  }

  test::TempFolder folder_;
  fs::path keys_ = fs::canonical(folder_.path()) / "keys";
  fs::path own_ = keys_ / "enclaves/pongsim";
};

TEST_F(Keystore, IsListedWithSuccessUnlessAnIdentityCantBeUsed) {
  const auto list = [this] {
    Options options;
    options.keystore = keys_.string();
    testing::internal::CaptureStdout();
    const int code = actions::list(options);
    const std::string text = testing::internal::GetCapturedStdout();
    EXPECT_TRUE(text.starts_with("/pongsim\n")) << text;
    return code;
  };
  EXPECT_EQ(list(), cli::kDone);
  fs::remove(own_ / "cert.pem");
  EXPECT_EQ(list(), cli::kFailed);
}

TEST_F(Keystore, IsLaidOutAsThatOfSros2AndForItsOwnerAlone) {
  for (const char* file : {"private/ca.key.pem", "public/ca.cert.pem", "enclaves/governance.xml",
                           "enclaves/governance.p7s", "enclaves/pongsim/cert.pem", "enclaves/pongsim/key.pem",
                           "enclaves/pongsim/permissions.xml", "enclaves/pongsim/permissions.p7s"}) {
    EXPECT_EQ(modeOf(keys_ / file), 0600U) << file;
  }
  const std::pair<const char*, const char*> links[] = {
      {"private/identity_ca.key.pem", "ca.key.pem"},
      {"private/permissions_ca.key.pem", "ca.key.pem"},
      {"public/identity_ca.cert.pem", "ca.cert.pem"},
      {"public/permissions_ca.cert.pem", "ca.cert.pem"},
      {"enclaves/pongsim/identity_ca.cert.pem", "../../public/identity_ca.cert.pem"},
      {"enclaves/pongsim/permissions_ca.cert.pem", "../../public/permissions_ca.cert.pem"},
      {"enclaves/pongsim/governance.p7s", "../../enclaves/governance.p7s"}};
  for (const auto& [link, target] : links) EXPECT_EQ(fs::read_symlink(keys_ / link), target) << link;
  for (const char* folder : {"", "public", "private", "enclaves", "enclaves/pongsim"}) {
    EXPECT_EQ(modeOf((keys_ / folder).lexically_normal()), 0700U) << folder;
  }
  EXPECT_EQ(std::distance(fs::directory_iterator(folder_.path()), {}), 1) << "something is left beside it";
}

TEST_F(Keystore, HasAnIdentityThatMayDoAll) {
  const SecureIdentity identity = readIdentity(identityFolder(keys_.string()), 200);
  EXPECT_EQ(identity.name, "/pongsim");
  EXPECT_EQ(identity.subject, "CN=/pongsim");
  EXPECT_EQ(identity.folder, own_.string());
  for (const char* topic : {"/cmd_vel", "rt/cmd_vel", "pongsim/request/world/w/control", "pongsim/census"}) {
    EXPECT_TRUE(isPermitted(identity, 0, TopicUse::kPublish, topic)) << topic;
    EXPECT_TRUE(isPermitted(identity, 232, TopicUse::kSubscribe, topic)) << topic;
  }
}

TEST_F(Keystore, IsNotOverwritten) {
  const std::string key = contentOf(keys_ / "private/ca.key.pem");
  EXPECT_EQ(refusal([&] { make(keys_); }, keys_), "there is already something at 'KEYS', and nothing is overwritten");
  EXPECT_EQ(refusal([&] { make(keys_ / ""); }, keys_),
            "there is already something at 'KEYS', and nothing is overwritten");
  EXPECT_EQ(contentOf(keys_ / "private/ca.key.pem"), key);
  actions::add(adding("robot"));
  const std::string own = contentOf(keys_ / "enclaves/robot/key.pem");
  EXPECT_EQ(refusalToAdd(adding("/robot")), "keystore 'KEYS' already has 'robot', and nothing is overwritten");
  EXPECT_EQ(contentOf(keys_ / "enclaves/robot/key.pem"), own);
  EXPECT_EQ(std::distance(fs::directory_iterator(keys_ / "private"), {}), 3) << "something is left behind";
}

TEST_F(Keystore, TakesNamesAsSros2HasThem) {
  actions::add(adding("fleet/robot_1"));
  EXPECT_EQ(readIdentity(identityFolder((keys_ / "fleet/robot_1").string())).name, "/fleet/robot_1");
  EXPECT_EQ(identitiesOf(keys_.string()), (std::vector<std::string>{"/fleet/robot_1", "/pongsim"}));
  for (const char* name : {"", "/", "a//b", "a/", "1st", "a/2", "../a", "a b", "r\xc3\xb6"}) {
    EXPECT_THROW(actions::add(adding(name)), cli::UsageError) << name;
  }
}

TEST_F(Keystore, GivesAnIdentityWhatItIsAllowed) {
  Options options = adding("driver");
  options.permissions.publish = {"/cmd_vel"};
  options.permissions.subscribe = {"/robot/*"};
  options.permissions.call = {"/reset"};
  actions::add(options);
  const SecureIdentity driver = readIdentity(identityFolder((keys_ / "driver").string()));
  const auto may = [&driver](TopicUse use, const char* topic) { return isPermitted(driver, 7, use, topic); };
  for (const char* topic :
       {"/cmd_vel", "rt/cmd_vel", "pongsim/request/reset", "rq/resetRequest", "pongsim/census", "ros_discovery_info"}) {
    EXPECT_TRUE(may(TopicUse::kPublish, topic)) << topic;
  }
  for (const char* topic : {"/robot/odom", "rt/robot/odom", "pongsim/reply/reset", "rr/resetReply"}) {
    EXPECT_TRUE(may(TopicUse::kSubscribe, topic)) << topic;
    EXPECT_FALSE(may(TopicUse::kPublish, topic)) << topic;
  }
  EXPECT_FALSE(may(TopicUse::kSubscribe, "/cmd_vel"));
  EXPECT_FALSE(may(TopicUse::kPublish, "pongsim/request/other"));
}

TEST_F(Keystore, SignsPermissionsOfTheUsersOwn) {
  Options options = adding("own");
  options.permissionsFile = (folder_.path() / "own.xml").string();
  const std::string text = permissionsDocument("/own", 0, 4'000'000'000, {{"/a"}, {}, {}, {}});
  replace(options.permissionsFile, replaced(text, "DENY", "PERHAPS"));
  EXPECT_NE(refusalToAdd(options).find("own.xml:41: <default> is 'PERHAPS': only DENY is supported"), std::string::npos)
      << refusalToAdd(options);
  EXPECT_FALSE(fs::exists(keys_ / "enclaves/own"));
  replace(options.permissionsFile, text);
  actions::add(options);
  EXPECT_TRUE(isPermitted(readIdentity((keys_ / "enclaves/own").string()), 0, TopicUse::kPublish, "/a"));
}

TEST_F(Keystore, LastsNoLongerThanItsAuthority) {
  const fs::path brief = folder_.path() / "brief";
  Options options;
  options.keystore = brief.string();
  options.days = 2;
  actions::init(options);
  EXPECT_LE(readIdentity(identityFolder(brief.string())).validUntil, std::time(nullptr) + 2 * 86400);
  EXPECT_GT(readIdentity(identityFolder(keys_.string())).validUntil, std::time(nullptr) + 364 * 86400);
}

TEST_F(Keystore, SaysWhatIsMissing) {
  for (const char* file : {"cert.pem", "permissions.p7s", "identity_ca.cert.pem"}) {
    fs::rename(own_ / file, own_ / "away");
    EXPECT_EQ(refusalToRead(), "KEYS/enclaves/pongsim/" + std::string(file) + " is missing");
    fs::rename(own_ / "away", own_ / file);
  }
  fs::remove(keys_ / "enclaves/governance.p7s");
  EXPECT_EQ(refusalToRead(), "KEYS/enclaves/pongsim/governance.p7s is a broken symbolic link");
  fs::remove(keys_ / "private/identity_ca.key.pem");
  EXPECT_EQ(refusalToAdd(adding("robot")), "KEYS/private/identity_ca.key.pem is missing");
  EXPECT_EQ(refusal([&] { identityFolder((keys_ / "nobody").string()); }, keys_),
            "keystore 'KEYS' has no identity 'nobody', but pongsim");
  EXPECT_EQ(refusal([&] { identityFolder((folder_.path() / "nowhere").string()); }, folder_.path()),
            "there is no keystore at 'KEYS/nowhere'");
}

TEST_F(Keystore, RefusesAKeyThatOthersCanRead) {
  fs::permissions(own_ / "key.pem", fs::perms(0644));
  EXPECT_EQ(refusalToRead(), "") << "the folders above keep others away";
  for (const char* folder : {"..", ".", "enclaves", "enclaves/pongsim", "private"}) {
    fs::permissions(keys_ / folder, fs::perms(0755));
  }
  EXPECT_EQ(refusalToRead(), "KEYS/enclaves/pongsim/key.pem can be read by other users (mode 0644)");
  fs::permissions(own_ / "key.pem", fs::perms(0600));
  EXPECT_EQ(refusalToRead(), "");
  fs::permissions(keys_ / "private/ca.key.pem", fs::perms(0640));
  EXPECT_EQ(refusalToAdd(adding("robot")), "KEYS/private/identity_ca.key.pem can be read by other users (mode 0640)");
}

TEST_F(Keystore, RefusesAKeyWithAPassword) {
  const Credentials made = makeIdentity("/pongsim", 5, authority());
  std::FILE* file = std::fopen((own_ / "key.pem").c_str(), "w");
  PEM_write_PKCS8PrivateKey(file, made.key.get(), EVP_aes_256_cbc(), "secret", 6, nullptr, nullptr);
  std::fclose(file);
  EXPECT_EQ(refusalToRead(), "KEYS/enclaves/pongsim/key.pem is protected by a password, which is not supported");
}

TEST_F(Keystore, RefusesCertificatesThatAreExpiredOrForeign) {
  const std::string certificate = contentOf(own_ / "cert.pem");
  const Credentials old = makeIdentity("/pongsim", -3, authority());
  replace(own_ / "cert.pem", old.certificateAsPem());
  EXPECT_TRUE(refusalToRead().starts_with("KEYS/enclaves/pongsim/cert.pem expired on 20")) << refusalToRead();

  make(folder_.path() / "others");
  replace(own_ / "cert.pem", contentOf(folder_.path() / "others/enclaves/pongsim/cert.pem"));
  EXPECT_TRUE(
      refusalToRead().starts_with("KEYS/enclaves/pongsim/cert.pem is not signed by the authority in "
                                  "KEYS/enclaves/pongsim/identity_ca.cert.pem (CN=pongsim "))
      << refusalToRead();

  replace(own_ / "cert.pem", makeIdentity("/pongsim", 5, authority()).certificateAsPem());
  EXPECT_EQ(refusalToRead(), "KEYS/enclaves/pongsim/key.pem is not the key of KEYS/enclaves/pongsim/cert.pem");

  replace(own_ / "cert.pem", certificate.substr(0, certificate.size() / 2));
  EXPECT_EQ(refusalToRead(), "KEYS/enclaves/pongsim/cert.pem is not a certificate in PEM format");
}

TEST_F(Keystore, RefusesDocumentsThatAreChangedOrForeign) {
  const std::string permissions = contentOf(own_ / "permissions.p7s");
  replace(own_ / "permissions.p7s", replaced(permissions, "<topic>*", "<topic>?"));
  EXPECT_EQ(refusalToRead(), "KEYS/enclaves/pongsim/permissions.p7s has been changed since it was signed");
  make(folder_.path() / "others");
  replace(own_ / "permissions.p7s", contentOf(folder_.path() / "others/enclaves/pongsim/permissions.p7s"));
  EXPECT_TRUE(refusalToRead().starts_with("KEYS/enclaves/pongsim/permissions.p7s is not signed by the authority in "))
      << refusalToRead();
  replace(own_ / "permissions.p7s", contentOf(own_ / "permissions.xml"));
  EXPECT_EQ(refusalToRead(), "KEYS/enclaves/pongsim/permissions.p7s is not an S/MIME signed document");
}

TEST_F(Keystore, LetsNoIdentitySignItsOwnPermissions) {
  const Credentials own = readCredentials(own_ / "cert.pem", own_ / "key.pem");
  EXPECT_EQ(X509_check_purpose(own.certificate.get(), X509_PURPOSE_SMIME_SIGN, 0), 0) << "Fast DDS would take it";
  EXPECT_EQ(X509_check_purpose(authority().certificate.get(), X509_PURPOSE_SMIME_SIGN, 0), 1);
  replace(own_ / "permissions.p7s", signedBy(own, contentOf(own_ / "permissions.xml")));
  EXPECT_TRUE(refusalToRead().starts_with("KEYS/enclaves/pongsim/permissions.p7s is not signed by the authority in "))
      << refusalToRead();
}

TEST_F(Keystore, RefusesPermissionsThatDoNotFit) {
  const std::string text = contentOf(own_ / "permissions.xml");
  sign("permissions.p7s", replaced(text, "CN=/pongsim", "CN=/other"));
  EXPECT_EQ(refusalToRead(), "KEYS/enclaves/pongsim/permissions.p7s grants nothing to CN=/pongsim, but to CN=/other");
  // at noon, so that the date is the same in all time zones: Fast DDS and pongsim read it as local time
  sign("permissions.p7s", permissionsDocument("/pongsim", 0, 1'000'036'800, {}));
  EXPECT_EQ(refusalToRead(), "KEYS/enclaves/pongsim/permissions.p7s expired on 2001-09-09");
  sign("permissions.p7s", replaced(text, "<max>232", "<max>9"));
  EXPECT_EQ(refusalToRead(9), "");
  EXPECT_EQ(refusalToRead(10), "KEYS/enclaves/pongsim/permissions.p7s allows nothing in DDS domain 10");
}

TEST_F(Keystore, RefusesAGovernanceOfAnotherDomain) {
  sign("governance.p7s", replaced(governanceDocument(), "<max>232", "<max>3"));
  EXPECT_EQ(refusalToRead(3), "");
  EXPECT_EQ(refusalToRead(4), "KEYS/enclaves/pongsim/governance.p7s has no rule for DDS domain 4");
  sign("governance.p7s", replaced(governanceDocument(), ">ENCRYPT<", ">CRYPT<"));
  EXPECT_EQ(refusalToRead(),
            "KEYS/enclaves/pongsim/governance.p7s:14: 'CRYPT' is not a kind of protection: use NONE, SIGN or ENCRYPT");
}

}  // namespace
}  // namespace pongsim::security
