#include "log/system/log_record.hh"

#include <gtest/gtest.h>
#include <ignition/msgs/double.pb.h>
#include <ignition/msgs/stringmsg.pb.h>

#include <filesystem>
#include <map>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "log/playback/recorded_state.hh"
#include "log/store/zip.hh"
#include "log/tlog/tlog_reader.hh"
#include "support/fortress_worlds.hh"
#include "support/log/log_support.hh"
#include "support/temp_folder.hh"

namespace pongsim::log {
namespace {

namespace fs = std::filesystem;

class LogRecordTest : public testing::Test {
 protected:
  fs::path recording() const { return folder_.path() / "rec"; }
  fs::path state() const { return recording() / "state.tlog"; }

  /// @param parameters In addition to the path.
  fs::path world(const std::string& parameters = {}, const std::string& models = test::pendulum("p", "0 0 2 0 0 0")) {
    return folder_.write("w.sdf",
                         test::worldText(models + test::plugin("LogRecord", "<record_path>" + recording().string() +
                                                                                "</record_path>" + parameters)));
  }

  static std::size_t count(const fs::path& file, const std::string& topic) {
    for (const Topic& each : TlogReader(file).topics()) {
      if (each.name == topic) return each.count;
    }
    return 0;
  }

  test::TempFolder folder_;
};

TEST_F(LogRecordTest, WritesTheWorldAndItsStateStepByStep) {
  test::load(world())->step(100);
  const TlogReader reader(state());
  EXPECT_EQ(reader.timeRange(), (TimeRange{1'000'000, 100'000'000}));
  EXPECT_EQ(reader.topics(), (std::vector<Topic>{{"/rec/sdf", "ignition.msgs.StringMsg", 1},
                                                 {"/world/w/changed_state", "ignition.msgs.SerializedStateMap", 100}}));
  EXPECT_FALSE(reader.torn());
  reader.forEach({.topics = std::vector<std::string>{"/rec/sdf"}}, [](const Record& record) {
    ignition::msgs::StringMsg message;
    EXPECT_TRUE(message.ParseFromArray(record.payload.data(), static_cast<int>(record.payload.size())));
    EXPECT_NE(message.data().find("<model name=\"p\">"), std::string::npos) << message.data();
    return true;
  });
  EXPECT_TRUE(fs::exists(recording() / "server_console.log"));
}

TEST_F(LogRecordTest, TellsOfPosesToAMicrometreAndOfJointsWhole) {
  std::unique_ptr<Simulation> simulation = test::load(world());
  simulation->step(250);
  const Link arm = simulation->world().model("p")->link("arm").value();
  const Pose pose = arm.poseInModel();
  const double angle = simulation->world().model("p")->joint("hinge")->position();
  simulation.reset();
  RecordedState recorded;
  TlogReader(state()).forEach({}, [&](const Record& record) {
    if (record.type != "ignition.msgs.StringMsg") {
      EXPECT_TRUE(recorded.apply(record.type, record.payload));
    }
    return true;
  });
  bool isThere = false;
  for (const std::uint64_t id : recorded.entitiesWith("Link")) {
    if (recorded.text(id, "Name") != "arm") continue;
    isThere = true;
    EXPECT_LT((recorded.poseOf(id).position - pose.position).norm(), 2e-6);
    EXPECT_LT(recorded.poseOf(id).rotation.angularDistance(pose.rotation), 4e-6);
  }
  EXPECT_TRUE(isThere);
  for (const std::uint64_t id : recorded.entitiesWith("JointPosition"))
    EXPECT_EQ(recorded.numbersOf(id, "JointPosition"), std::vector<double>{angle});
}

TEST_F(LogRecordTest, APeriodLeavesStatesOut) {
  test::load(world("<record_period>0.01</record_period>"))->step(100);
  EXPECT_EQ(count(state(), "/world/w/changed_state"), 10U);
}

TEST_F(LogRecordTest, WhoComesAndGoesIsTold) {
  std::unique_ptr<Simulation> simulation = test::load(world("<record_period>10</record_period>"));
  simulation->step(10);
  Diagnostics diagnostics;
  const auto model = simulation->insertText("<sdf version='1.9'>" + test::pendulum("q", "1 0 2 0 0 0") + "</sdf>", "q",
                                            {}, diagnostics);
  ASSERT_TRUE(model);
  simulation->step(10);
  EXPECT_TRUE(simulation->remove(*model));
  simulation->step(10);
  simulation.reset();
  std::map<std::int64_t, std::size_t> models;
  RecordedState recorded;
  const TlogReader reader(state());
  reader.forEach({.topics = reader.topicsOf("ignition.msgs.SerializedStateMap")}, [&](const Record& record) {
    EXPECT_TRUE(recorded.apply(record.type, record.payload));
    models[record.timeNs] = recorded.entitiesWith("Model").size();
    return true;
  });
  EXPECT_EQ(models, (std::map<std::int64_t, std::size_t>{{1'000'000, 1}, {11'000'000, 2}, {21'000'000, 1}}));
}

TEST_F(LogRecordTest, RecordsTopicsByNameAndByExpression) {
  std::unique_ptr<Simulation> simulation =
      test::load(world("<record_topic>/plain</record_topic><record_topic>/robot/.*</record_topic>"));
  std::vector<Publisher> publishers;
  for (const char* topic : {"/plain", "/robot/speed", "/other"})
    publishers.push_back(simulation->transport().node().advertise<ignition::msgs::Double>(topic));
  simulation->step();
  ignition::msgs::Double message;
  message.set_data(1.5);
  for (Publisher& publisher : publishers) publisher.publish(message);
  simulation->step();
  publishers.clear();
  simulation.reset();
  EXPECT_EQ(count(state(), "/plain"), 1U);
  EXPECT_EQ(count(state(), "/robot/speed"), 1U);
  EXPECT_EQ(count(state(), "/other"), 0U);
}

TEST_F(LogRecordTest, AnotherFolderIsTakenWhereOneIsToBeKept) {
  for (int i = 0; i < 3; ++i) test::load(world("<keep_existing>true</keep_existing>"))->step();
  EXPECT_TRUE(fs::exists(state()));
  EXPECT_TRUE(fs::exists(folder_.path() / "rec(1)/state.tlog"));
  EXPECT_TRUE(fs::exists(folder_.path() / "rec(2)/state.tlog"));
}

TEST_F(LogRecordTest, WhatIsThereIsDeletedWhereThatIsWanted) {
  fs::create_directory(recording());
  folder_.write("rec/old", "x");
  test::load(world("<overwrite>true</overwrite>"))->step();
  EXPECT_TRUE(fs::exists(state()));
  EXPECT_FALSE(fs::exists(recording() / "old"));
}

TEST_F(LogRecordTest, IsPackedIntoAZipFile) {
  test::load(world("<compress>true</compress>"))->step(10);
  EXPECT_FALSE(fs::exists(recording()));
  unpackZip(folder_.path() / "rec.zip", folder_.path());
  EXPECT_EQ(count(state(), "/world/w/changed_state"), 10U);
}

TEST_F(LogRecordTest, CopiesMeshesWithTheirModel) {
  const fs::path mesh = folder_.write("models/tri/meshes/tri.obj", "v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n");
  folder_.write("models/tri/model.config", "<model><name>tri</name><sdf>model.sdf</sdf></model>");
  folder_.write("models/tri/meshes/tri.png", "x");
  test::load(world("<record_resources>true</record_resources>",
                   "<model name='m'><static>true</static><link name='l'><visual name='v'><geometry><mesh><uri>" +
                       mesh.string() + "</uri></mesh></geometry></visual></link></model>"))
      ->step();
  EXPECT_TRUE(fs::exists(recording() / mesh.relative_path()));
  EXPECT_TRUE(fs::exists(recording() / mesh.relative_path().replace_filename("tri.png")));
}

TEST_F(LogRecordTest, IsNoLargerThanFortresssLogOfTheSameWorld) {
  const std::optional<fs::path> data = test::goldenData();
  if (!data) GTEST_SKIP() << "no recordings of Fortress here";
  const fs::path golden = *data / "log/double_pendulum.tlog";
  std::string text;
  const TlogReader reader(golden);
  reader.forEach({.topics = reader.topicsOf("ignition.msgs.StringMsg")}, [&](const Record& record) {
    ignition::msgs::StringMsg message;
    EXPECT_TRUE(message.ParseFromArray(record.payload.data(), static_cast<int>(record.payload.size())));
    text = "<sdf version='1.9'>" + message.data() + "</sdf>";
    return false;
  });
  Element path, plugin;
  path.name = "record_path";
  path.text = recording().string();
  plugin.name = "plugin";
  plugin.attributes = {{"filename", "ignition-gazebo-log-system", {}},
                       {"name", "ignition::gazebo::systems::LogRecord", {}}};
  plugin.children = {path};
  Diagnostics diagnostics;
  Simulation::fromFile(folder_.write("pendulum.sdf", text), {.systems = {plugin}}, diagnostics)->step(3000);
  EXPECT_EQ(count(state(), "/world/log_pendulum/changed_state"), 3000U);
  EXPECT_LE(fs::file_size(state()), fs::file_size(golden));
}

TEST_F(LogRecordTest, OfTwoWorldsThatNameAFolderTheFirstHasIt) {
  const std::string recorder = test::plugin("LogRecord", "<record_path>" + recording().string() + "</record_path>");
  const fs::path file = folder_.write("two.sdf", "<sdf version='1.9'><world name='w'>" + recorder +
                                                     "</world><world name='v'>" + recorder + "</world></sdf>");
  Diagnostics diagnostics;
  {
    const auto worlds = Simulation::allFromFile(file, {.physics = false}, diagnostics);
    ASSERT_EQ(worlds.size(), 2U);
    for (const auto& world : worlds) world->step(10);
  }
  ASSERT_EQ(diagnostics.all().size(), 1U);
  EXPECT_NE(diagnostics.all()[0].message.find("already contains a recording in progress"), std::string::npos)
      << diagnostics.all()[0].message;
  EXPECT_GE(count(state(), "/world/w/changed_state"), 1U);
  EXPECT_EQ(count(state(), "/world/v/changed_state"), 0U);
}

TEST_F(LogRecordTest, WhatCantBeRecordedIsSaidAndTheWorldRuns) {
  folder_.write("rec", "a file");
  for (const std::string parameters : {"", "<overwrite>true</overwrite><record_topic>[</record_topic>"}) {
    Diagnostics diagnostics;
    const std::unique_ptr<Simulation> simulation = Simulation::fromFile(world(parameters), {}, diagnostics);
    ASSERT_NE(simulation, nullptr);
    ASSERT_EQ(diagnostics.all().size(), 1U);
    const std::string& said = diagnostics.all()[0].message;
    EXPECT_NE(said.find(parameters.empty() ? "can't be created" : "'[' is not a regular expression"), std::string::npos)
        << said;
    simulation->step();
  }
}

}  // namespace
}  // namespace pongsim::log
