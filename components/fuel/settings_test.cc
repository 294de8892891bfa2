#include "fuel/settings.hh"

#include <gtest/gtest.h>

#include <cstdlib>

#include "fuel/failure.hh"
#include "support/temp_folder.hh"

namespace pongsim::fuel {
namespace {

class SettingsTest : public testing::Test {
 protected:
  SettingsTest() {
    const char* home = std::getenv("HOME");
    home_ = home != nullptr ? home : "";
    setenv("HOME", folder_.path().c_str(), 1);
    unsetenv("IGN_FUEL_CACHE_PATH");
    unsetenv("GZ_FUEL_CACHE_PATH");
  }
  ~SettingsTest() override { setenv("HOME", home_.c_str(), 1); }

  std::string complaint(const std::string& text) {
    const auto file = folder_.write("c.yaml", text);
    try {
      readSettings(file, warnings_);
    } catch (const Failure& failure) {
      return std::string(failure.what()).substr(file.string().size());
    }
    return "";
  }

  test::TempFolder folder_;
  std::string home_;
  std::vector<std::string> warnings_;
};

TEST_F(SettingsTest, KnowBothNamesOfTheServerWithoutAFile) {
  const Settings settings = readSettings({}, warnings_);
  ASSERT_EQ(settings.servers.size(), 2U);
  EXPECT_EQ(settings.listed.at(0).url, "https://fuel.gazebosim.org");
  EXPECT_EQ(settings.cache, folder_.path() / ".ignition/fuel");
  EXPECT_EQ(serverOf(*parseFuelAddress("http://fuel.ignitionrobotics.org/o/models/m"), settings).url,
            "https://fuel.ignitionrobotics.org");
  EXPECT_THROW(serverOf(*parseFuelAddress("https://example.org/o/models/m"), settings), Failure);
}

TEST_F(SettingsTest, TakeServersAndTokensOfTheUsualFile) {
  folder_.write(".ignition/fuel/config.yaml",
                "servers:\n- name: a\n  url: https://Fuel.gazebosim.org/\n  private-token: secret\n"
                "- url: http://localhost:8000\ncache:\n  path: /elsewhere\n");
  const Settings settings = readSettings({}, warnings_);
  EXPECT_EQ(settings.servers.size(), 3U);
  EXPECT_EQ(settings.listed.size(), 2U);
  EXPECT_EQ(serverOf(*parseFuelAddress("https://fuel.gazebosim.org/o/models/m"), settings).token, "secret");
  EXPECT_EQ(serverOf(*parseFuelAddress("https://localhost:8000/o/models/m"), settings).url, "http://localhost:8000");
  // `cache` of the default file is ignored, as Fortress and the loader ignore it
  EXPECT_EQ(settings.cache, folder_.path() / ".ignition/fuel");
  EXPECT_EQ(warnings_.size(), 1U);
}

TEST_F(SettingsTest, TakeTheCacheOfAFileThatIsNamed) {
  const auto file = folder_.write("c.yaml", "cache: {path: /there}");
  EXPECT_EQ(readSettings(file, warnings_).cache, "/there");
  EXPECT_TRUE(warnings_.empty());
  setenv("IGN_FUEL_CACHE_PATH", "/first", 1);
  EXPECT_EQ(readSettings(file, warnings_).cache, "/first");
  EXPECT_EQ(warnings_.size(), 1U);
  unsetenv("IGN_FUEL_CACHE_PATH");
}

TEST_F(SettingsTest, TakeTheFileAndTheCacheOfLaterReleasesWhereFortressHasNone) {
  folder_.write(".gz/fuel/config.yaml", "servers: [{url: 'https://models.example.org'}]");
  const Settings later = readSettings({}, warnings_);
  EXPECT_EQ(later.cache, folder_.path() / ".gz/fuel");
  EXPECT_EQ(later.listed.at(0).url, "https://models.example.org");
  folder_.write(".ignition/fuel/config.yaml", "");
  const Settings fortress = readSettings({}, warnings_);
  EXPECT_EQ(fortress.cache, folder_.path() / ".ignition/fuel");
  EXPECT_EQ(fortress.listed.at(0).url, "https://fuel.gazebosim.org");
}

TEST_F(SettingsTest, SayWhereTheFileIsWrong) {
  EXPECT_EQ(complaint(""), "");
  EXPECT_EQ(complaint("servers:"), "");
  EXPECT_EQ(complaint("servers: 1"), ":1:10: 'servers' is not a list");
  EXPECT_EQ(complaint("servers: [1]"), ":1:11: a server must be a map with 'url'");
  EXPECT_EQ(complaint("servers: [{name: a}]"), ":1:11: a server has no 'url'");
  EXPECT_EQ(complaint("servers: [{url: [a]}]"), ":1:17: 'url' must be a string");
  EXPECT_EQ(complaint("servers: [{url: 'ftp://a'}]"), ":1:11: 'ftp://a' is not the address of a server");
  EXPECT_EQ(complaint("servers: [{url: 'https://a/b'}]"), ":1:11: 'https://a/b' is not the address of a server");
  EXPECT_EQ(complaint("servers: [{url: 'https://a', private-token: \"a\\nb\"}]"),
            ":1:11: 'private-token' contains a line break");
  EXPECT_EQ(complaint("cache: 1"), ":1:1: 'cache' has no 'path'");
  EXPECT_EQ(complaint("a"), ":1:1: this must be a map with 'servers' and 'cache'");
  EXPECT_NE(complaint("a: ["), "");
  EXPECT_EQ(complaint("color: red"), "");
  EXPECT_EQ(warnings_.size(), 1U);
}

}  // namespace
}  // namespace pongsim::fuel
