#include "trust/keystore.hh"

#include <gtest/gtest.h>

#include <cstdlib>
#include <filesystem>

#include "pongsim/program/keystore.hh"
#include "support/temp_folder.hh"

namespace pongsim {
namespace {

class Places : public testing::Test {
 protected:
  void addIdentity(const std::string& name) const { folder_.write("keys/enclaves/" + name + "/key.pem", ""); }
  std::string found(const std::string& place) const {
    try {
      return std::filesystem::path(identityFolder((folder_.path() / place).string()))
          .lexically_relative(folder_.path())
          .string();
    } catch (const KeystoreError& error) {
      return error.what();
    }
  }
  std::string keys() const { return (folder_.path() / "keys").string(); }

  test::TempFolder folder_;
};

TEST_F(Places, AreAKeystoreOrOneOfItsIdentities) {
  addIdentity("robot");
  EXPECT_EQ(found("keys"), "keys/enclaves/robot") << "the only one";
  EXPECT_EQ(found("keys/"), "keys/enclaves/robot");
  addIdentity("fleet/one");
  EXPECT_EQ(found("keys/robot"), "keys/enclaves/robot");
  EXPECT_EQ(found("keys/fleet/one"), "keys/enclaves/fleet/one");
  EXPECT_EQ(found("keys/enclaves/robot"), "keys/enclaves/robot");
  EXPECT_EQ(found("keys"), "keystore '" + keys() + "' has several identities: fleet/one, robot");
  addIdentity("pongsim");
  EXPECT_EQ(found("keys"), "keys/enclaves/pongsim") << "the one that is called so";
}

TEST_F(Places, AreRefusedWhereNothingIs) {
  EXPECT_EQ(found("keys"), "there is no keystore at '" + keys() + "'");
  std::filesystem::create_directories(folder_.path() / "keys/enclaves");
  EXPECT_EQ(found("keys"), "keystore '" + keys() + "' has no identity");
  addIdentity("robot");
  EXPECT_EQ(found("keys/fleet"), "keystore '" + keys() + "' has no identity 'fleet', but robot");
  EXPECT_THROW(identitiesOf("/no/such/folder"), KeystoreError);
}

TEST_F(Places, AreChosenByTheEnvironment) {
  unsetenv("PONGSIM_SECURITY");
  EXPECT_FALSE(isSecured());
  EXPECT_FALSE(chosenIdentity(0));
  setenv("PONGSIM_SECURITY", "", 1);
  EXPECT_FALSE(isSecured());
  EXPECT_FALSE(chosenIdentity(0));
  secureBy(keys());
  EXPECT_TRUE(isSecured());
  EXPECT_EQ(std::getenv("PONGSIM_SECURITY"), keys());
  EXPECT_THROW(chosenIdentity(0), KeystoreError);
  unsetenv("PONGSIM_SECURITY");
}

TEST(Identity, IsCalledByItsPlaceInTheKeystore) {
  EXPECT_EQ(trust::nameOf("/home/me/keys/enclaves/fleet/one"), "/fleet/one");
  EXPECT_EQ(trust::nameOf("/home/me/alone"), "/alone");
}

}  // namespace
}  // namespace pongsim
