#include "sim/resource_services.hh"

#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>
#include <memory>
#include <string>
#include <vector>

#include "support/ask_service.hh"
#include "support/environment_variable.hh"
#include "support/temp_folder.hh"

namespace pongsim::sim {
namespace {

class ResourceServicesTest : public testing::Test {
 protected:
  void SetUp() override {
    std::filesystem::create_directory(models_.path() / "crate");
    std::ofstream(models_.path() / "crate/model.config")
        << "<model><name>crate</name><sdf version='1.9'>model.sdf</sdf></model>";
    std::ofstream(models_.path() / "crate/model.sdf")
        << "<sdf version='1.9'><model name='crate'><link name='l'/></model></sdf>";
    Diagnostics diagnostics;
    simulation_ = Simulation::fromText("<sdf version='1.9'><world name='w'/></sdf>", "world.sdf",
                                       {.loadSystems = false}, diagnostics);
    ASSERT_NE(simulation_, nullptr);
    services_ = std::make_unique<ResourceServices>(
        *simulation_, [this](const std::filesystem::path& folder) { added_.push_back(folder); });
  }

  /// @return The reply's text, or why the service refused.
  std::string ask(const std::string& service, const std::string& text) {
    const bool isPath = service == "resolve";
    const MessagePointer request = newMessage(isPath ? "StringMsg" : service == "get" ? "Empty" : "StringMsg_V");
    EXPECT_FALSE(parseMessage(text, *request)) << text;
    const MessagePointer reply = newMessage(isPath ? "StringMsg" : service == "get" ? "StringMsg_V" : "Empty");
    const CallResult result =
        test::askService(simulation_->transport(), "/gazebo/resource_paths/" + service, *request, *reply);
    return result ? messageText(*reply) : test::refusalOf(result);
  }

  bool canInsert() {
    Diagnostics diagnostics;
    return simulation_
        ->insertText("<sdf version='1.9'><model name='m'><include><uri>model://crate</uri></include></model></sdf>",
                     "sdf", {.allowRenaming = true}, diagnostics)
        .has_value();
  }

  const test::TempFolder models_;
  // its subfolders may be added by requests
  const test::EnvironmentVariable reach_{"PONGSIM_RESOURCE_PATH", models_.path().parent_path().string()};
  std::unique_ptr<Simulation> simulation_;
  std::vector<std::filesystem::path> added_;
  std::unique_ptr<ResourceServices> services_;
};

TEST_F(ResourceServicesTest, AddFoldersInWhichModelsAreFoundThen) {
  std::vector<std::string> told;
  const Subscription subscription = simulation_->transport().node().subscribe(
      "/gazebo/resource_paths", "ignition.msgs.StringMsg_V",
      [&told](const Message& message) { told.push_back(messageText(message)); });
  EXPECT_FALSE(canInsert());
  EXPECT_EQ(ask("get", "").find(models_.path().string()), std::string::npos);
  EXPECT_EQ(ask("add", "data: '" + models_.path().string() + "'"), "");
  EXPECT_TRUE(canInsert());
  const std::string line = "data: \"" + models_.path().string() + "\"\n";
  EXPECT_NE(ask("get", "").find(line), std::string::npos);
  ASSERT_EQ(told.size(), 1U);
  EXPECT_NE(told[0].find(line), std::string::npos);
  // adding a folder twice has no further effect
  const std::string before = ask("get", "");
  EXPECT_EQ(ask("add", "data: '" + models_.path().string() + "'"), "");
  EXPECT_EQ(ask("get", ""), before);
}

TEST_F(ResourceServicesTest, RefuseWhatIsNoFolder) {
  EXPECT_EQ(ask("add", ""), "the request contains no folder");
  EXPECT_EQ(ask("add", "data: '" + models_.path().string() + "' data: '/no/such'"),
            "'/no/such' is not a folder in the world's folder or in those of PONGSIM_RESOURCE_PATH");
  EXPECT_FALSE(canInsert()) << "all or none";
}

TEST_F(ResourceServicesTest, TellNothingOfWhatIsOutOfReach) {
  const auto withoutName = [](std::string text, const std::string& name) {
    return text.erase(text.find(name), name.size());
  };
  EXPECT_EQ(withoutName(ask("add", "data: '/etc'"), "/etc"), withoutName(ask("add", "data: '/no/such'"), "/no/such"));
  EXPECT_EQ(withoutName(ask("resolve", "data: '/etc/passwd'"), "/etc/passwd"),
            withoutName(ask("resolve", "data: '/no/such'"), "/no/such"));
}

TEST_F(ResourceServicesTest, ResolveAddresses) {
  EXPECT_EQ(ask("resolve", "data: 'model://crate'"), "there is no 'model://crate' in the folders with models");
  ask("add", "data: '" + models_.path().string() + "'");
  EXPECT_EQ(ask("resolve", "data: 'model://crate'"), "data: \"" + (models_.path() / "crate").string() + "\"\n");
}

}  // namespace
}  // namespace pongsim::sim
