#include "sim/running/server.hh"

#include <gtest/gtest.h>
#include <ignition/msgs/boolean.pb.h>
#include <ignition/msgs/clock.pb.h>

#include <atomic>
#include <chrono>
#include <cstdint>
#include <memory>
#include <stdexcept>
#include <string>
#include <thread>
#include <vector>

#include "support/process.hh"
#include "support/temp_folder.hh"
#include "support/wait_until.hh"

namespace pongsim::sim::server_test {
namespace {

constexpr const char* kWorlds = R"(<sdf version="1.9">
  <world name="fine"><physics name="p" type="ignored"><max_step_size>0.001</max_step_size></physics>
    <model name="ball"><pose>0 0 100 0 0 0</pose><link name="l"/></model></world>
  <world name="coarse"><physics name="p" type="ignored"><max_step_size>0.004</max_step_size></physics>
    <model name="ball"><pose>0 0 100 0 0 0</pose><link name="l"/></model></world></sdf>)";

class ServerTest : public testing::Test {
 protected:
  ServerTest() {
    Diagnostics diagnostics;
    worlds_ = Simulation::allFromFile(folder_.write("worlds.sdf", kWorlds),
                                      {.loadSystems = false, .transport = &transport_}, diagnostics);
    for (const Diagnostic& diagnostic : diagnostics.all()) ADD_FAILURE() << format(diagnostic);
  }
  ~ServerTest() override { end(); }

  void start(const RunOptions& options) {
    server_ = std::make_unique<Server>(transport_, worlds_, options);
    thread_ = std::thread([this] { server_->run(); });
  }
  void end() {
    if (!thread_.joinable()) return;
    server_->stop();
    thread_.join();
  }
  CallResult control(const std::string& world, const std::string& text) {
    const MessagePointer request = newMessage("WorldControl");
    EXPECT_FALSE(parseMessage(text, *request));
    ignition::msgs::Boolean reply;
    return asker_.node().call("/world/" + world + "/control", *request, reply, test::kDeadline);
  }

  const test::TempFolder folder_;
  Transport transport_{{.network = false}};
  Transport asker_{transport_, Transport::Sharing()};
  std::vector<std::unique_ptr<Simulation>> worlds_;
  std::unique_ptr<Server> server_;
  std::thread thread_;
};

TEST_F(ServerTest, MakesSoManyStepsOfEachWorldAtItsOwnSize) {
  Server server(transport_, worlds_, {.iterations = 100, .updateRate = 0.0});
  server.run();
  EXPECT_EQ(worlds_[0]->time(), std::chrono::milliseconds(100));
  EXPECT_EQ(worlds_[1]->time(), std::chrono::milliseconds(400));
}

TEST_F(ServerTest, ControlsEachWorldByItself) {
  std::atomic<std::int64_t> reached = 0;
  const Subscription clock = asker_.node().subscribe<ignition::msgs::Clock>(
      "/world/coarse/clock", [&reached](const ignition::msgs::Clock& message) { reached = message.sim().nsec(); });
  start({.paused = true, .updateRate = 0.0});
  EXPECT_TRUE(control("coarse", "pause: true, multi_step: 5"));
  EXPECT_TRUE(test::waitUntil([&] {
    asker_.dispatch();
    return reached == 20'000'000;
  }));
  end();
  EXPECT_EQ(worlds_[0]->iterations(), 0U);
  EXPECT_EQ(worlds_[1]->iterations(), 5U);
}

TEST_F(ServerTest, TellsTheFirstWorldsClockAsThatOfTheProcess) {
  std::atomic<std::int64_t> ofProcess = 0, ofCoarse = 0;
  const auto hear = [this](const std::string& topic, std::atomic<std::int64_t>& time) {
    return asker_.node().subscribe<ignition::msgs::Clock>(
        topic, [&time](const ignition::msgs::Clock& clock) { time = clock.sim().nsec(); });
  };
  const Subscription process = hear("/clock", ofProcess), coarse = hear("/world/coarse/clock", ofCoarse);
  Server server(transport_, worlds_, {.iterations = 10, .updateRate = 0.0});
  server.run();
  asker_.dispatch();
  EXPECT_EQ(ofProcess, 10'000'000);
  EXPECT_EQ(ofCoarse, 40'000'000);
}

TEST_F(ServerTest, AddsResourceFoldersForAllWorlds) {
  start({.paused = true});
  const MessagePointer request = newMessage("StringMsg_V");
  EXPECT_FALSE(parseMessage("data: '" + folder_.path().string() + "'", *request));
  const MessagePointer reply = newMessage("Empty");
  EXPECT_TRUE(asker_.node().call("/gazebo/resource_paths/add", *request, *reply, test::kDeadline));
  // posted tasks are done before the second request is answered
  EXPECT_TRUE(control("coarse", "pause: true"));
  EXPECT_TRUE(control("coarse", "pause: true"));
  end();
  for (const auto& world : worlds_) EXPECT_EQ(world->resourceFolders().back(), folder_.path());
}

TEST_F(ServerTest, EndsAllWorldsWhereItIsToldToStop) {
  start({});
  const MessagePointer request = newMessage("ServerControl");
  EXPECT_FALSE(parseMessage("stop: true", *request));
  ignition::msgs::Boolean reply;
  EXPECT_TRUE(asker_.node().call("/server_control", *request, reply, test::kDeadline));
  thread_.join();
}

TEST_F(ServerTest, HandsOverTheAnswerToAWorldThatAskedToStop) {
  const MessagePointer stop = newMessage("ServerControl");
  EXPECT_FALSE(parseMessage("stop: true", *stop));
  start({});
  bool isAnswered = false;
  const PendingRequest asked = worlds_[0]->transport().node().request(
      "/server_control", *stop, "ignition.msgs.Boolean",
      [&isAnswered](const CallResult& result, const Message&) { isAnswered = bool(result); });
  thread_.join();
  EXPECT_TRUE(isAnswered);
}

TEST_F(ServerTest, EndsTheServicesOfAWorldThatHasMadeItsSteps) {
  start({.paused = true, .iterations = 3});
  EXPECT_TRUE(control("coarse", "pause: false"));
  EXPECT_TRUE(test::waitUntil([this] { return control("coarse", "pause: false").outcome == CallOutcome::kNoService; }));
  EXPECT_TRUE(control("fine", "pause: false"));
  thread_.join();
  EXPECT_EQ(worlds_[0]->iterations(), 3U);
}

TEST_F(ServerTest, EndsAllWhereOneFails) {
  Server server(transport_, worlds_, {});
  const Subscription told = worlds_[1]->transport().node().subscribe<ignition::msgs::Boolean>(
      "/fail", [](const ignition::msgs::Boolean&) { throw std::runtime_error("no more"); });
  Publisher teller = asker_.node().advertise<ignition::msgs::Boolean>("/fail");
  teller.publish(ignition::msgs::Boolean());
  EXPECT_THROW(server.run(), std::runtime_error);
}

}  // namespace
}  // namespace pongsim::sim::server_test
