#include "ros2/services/spawnables.hh"

#include <gtest/gtest.h>

#include "ros2/services/result.hh"
#include "support/temp_folder.hh"

namespace pongsim::ros2 {
namespace {

namespace fs = std::filesystem;

class SpawnablesTest : public testing::Test {
 protected:
  SpawnablesTest() {
    folder_.write("models/box/model.config", "<model/>");
    folder_.write("models/arm/model.config", "<model/>");
    folder_.write("models/notes/readme.txt", "no model");
    folder_.write("more/cup/model.config", "<model/>");
  }
  std::vector<std::string> uris(const std::vector<std::string>& sources) {
    const auto response = spawnables({folder_.path() / "models", folder_.path() / "nowhere"}, sources,
                                     [](const std::string& address) -> std::optional<fs::path> {
                                       return fs::exists(address) ? std::optional(fs::path(address)) : std::nullopt;
                                     });
    EXPECT_EQ(response.result.result, Result::kResultOk);
    error_ = response.result.error_message;
    std::vector<std::string> found;
    for (const auto& each : response.spawnables) found.push_back(each.entity_resource.uri);
    return found;
  }

  test::TempFolder folder_;
  std::string error_;
};

TEST_F(SpawnablesTest, AreTheModelsWhereModelsAreLookedFor) {
  EXPECT_EQ(uris({}), (std::vector<std::string>{"model://arm", "model://box"}));
  EXPECT_EQ(error_, "");
}

TEST_F(SpawnablesTest, AreThoseOfMoreFoldersToo) {
  const std::string cup = folder_.path() / "more/cup";
  const std::vector<std::string> all{cup, "model://arm", "model://box"};
  EXPECT_EQ(uris({folder_.path() / "more"}), all);
  EXPECT_EQ(uris({cup}), all);
  EXPECT_EQ(uris({cup, folder_.path() / "more", cup}), all);
}

TEST_F(SpawnablesTest, NameTheSourcesThatAreNone) {
  EXPECT_EQ(uris({"/no/such", folder_.path() / "models/notes/readme.txt"}).size(), 2U);
  EXPECT_EQ(error_, "no folder: '/no/such', '" + (folder_.path() / "models/notes/readme.txt").string() + "'");
}

}  // namespace
}  // namespace pongsim::ros2
