#include "sim/edit_services.hh"

#include <gtest/gtest.h>
#include <ignition/msgs/boolean.pb.h>

#include <atomic>
#include <chrono>
#include <memory>
#include <string>
#include <thread>

#include "pongsim/simulation.hh"
#include "support/process.hh"
#include "support/test_domain.hh"

namespace pongsim::sim {
namespace {

constexpr const char* kEditedWorld = R"(<sdf version="1.9"><world name="w"><gravity>0 0 0</gravity>
  <model name="ball"><pose>1 2 3 0 0 0</pose><link name="l"/></model>
  <model name="tower"><link name="l"/><model name="top"><link name="l"/></model></model></world></sdf>)";
constexpr const char* kCrate = "sdf: \"<sdf version='1.9'><model name='crate'><link name='l'/></model></sdf>\"";

class EditServicesTest : public testing::Test {
 protected:
  void SetUp() override {
    test::testDomain();
    Diagnostics diagnostics;
    simulation_ = Simulation::fromText(kEditedWorld, "world.sdf", {.loadSystems = false}, diagnostics);
    ASSERT_NE(simulation_, nullptr);
    services_ = std::make_unique<EditServices>(*simulation_);
  }

  /// @return Why the service refused; empty where it did it.
  std::string refusal(const std::string& service, const std::string& type, const std::string& text) {
    const MessagePointer request = newMessage(type);
    EXPECT_FALSE(parseMessage(text, *request)) << text;
    std::atomic<bool> answered = false;
    CallResult result;
    std::thread caller([&] {
      ignition::msgs::Boolean reply;
      result = simulation_->transport().node().call("/world/w/" + service, *request, reply, test::kDeadline);
      EXPECT_EQ(reply.data(), static_cast<bool>(result));
      answered = true;
      simulation_->transport().wake();
    });
    while (!answered) simulation_->transport().dispatchFor(std::chrono::milliseconds(20));
    caller.join();
    const std::string_view before = " refused: ";
    return result ? "" : result.error.substr(result.error.find(before) + before.size());
  }
  std::string create(const std::string& text) { return refusal("create", "EntityFactory", text); }
  std::string setPose(const std::string& text) { return refusal("set_pose", "Pose", text); }
  std::string setPhysics(const std::string& text) { return refusal("set_physics", "Physics", text); }

  std::optional<Model> model(const char* name) { return simulation_->world().model(name); }

  std::unique_ptr<Simulation> simulation_;
  std::unique_ptr<EditServices> services_;
};

TEST_F(EditServicesTest, CreateAModelWhereItIsWanted) {
  const std::string crate = kCrate;
  EXPECT_EQ(create(crate + ", pose {position {x: 4}}"), "");
  EXPECT_EQ(model("crate")->pose().position, Vector3(4, 0, 0));
  EXPECT_EQ(create(crate + ", name: 'box'"), "");
  EXPECT_TRUE(model("box"));
  EXPECT_NE(create(crate), "");
  EXPECT_EQ(create(crate + ", allow_renaming: true"), "");
  EXPECT_TRUE(model("crate_0"));
}

TEST_F(EditServicesTest, SayWhatIsWrongWithWhatIsToBeCreated) {
  EXPECT_NE(create("").find("'sdf'"), std::string::npos);
  EXPECT_NE(create("sdf: '<sdf'").find("sdf:1:"), std::string::npos);
  EXPECT_NE(create("sdf_filename: 'nowhere.sdf'").find("nowhere.sdf"), std::string::npos);
  EXPECT_EQ(create("clone_name: 'ball'"), "field 'clone_name' is not supported");
  EXPECT_EQ(simulation_->world().models().size(), 2U);
}

TEST_F(EditServicesTest, CreateAllOrNone) {
  const std::string crate = kCrate;
  EXPECT_NE(
      refusal("create_multiple", "EntityFactory_V", "data {" + crate + "} data {" + crate + "}").find("number 2: "),
      std::string::npos);
  EXPECT_FALSE(model("crate"));
  EXPECT_EQ(refusal("create_multiple", "EntityFactory_V", "data {" + crate + "} data {" + crate + ", name: 'b'}"), "");
  EXPECT_TRUE(model("crate") && model("b"));
}

TEST_F(EditServicesTest, RemoveAModelByNameOrId) {
  EXPECT_EQ(refusal("remove", "Entity", "name: 'bal', type: MODEL"), "there is no model 'bal'; did you mean 'ball'?");
  EXPECT_EQ(refusal("remove", "Entity", "name: 'tower::top', type: MODEL"), "'tower::top' is nested in another model");
  EXPECT_NE(refusal("remove", "Entity", "name: 'sun', type: LIGHT"), "");
  EXPECT_NE(refusal("remove", "Entity", "id: 4711"), "");
  EXPECT_EQ(refusal("remove", "Entity", "name: 'ball', type: MODEL"), "");
  EXPECT_EQ(refusal("remove", "Entity", "id: " + std::to_string(model("tower")->id().value)), "");
  EXPECT_TRUE(simulation_->world().models().empty());
}

TEST_F(EditServicesTest, PutModelsSomewhereElse) {
  EXPECT_EQ(setPose("name: 'ball', position {x: 7}, orientation {z: 1}"), "");
  EXPECT_EQ(model("ball")->pose().position, Vector3(7, 0, 0));
  EXPECT_NE(setPose("name: 'ball', orientation {}"), "") << "no rotation";
  EXPECT_NE(setPose("position {x: 7}"), "");
  const std::string both = "pose {name: 'ball', position {x: 1}} pose {name: 'NAME', position {x: 2}}";
  EXPECT_NE(refusal("set_pose_vector", "Pose_V", both), "");
  EXPECT_EQ(model("ball")->pose().position.x(), 7);
  EXPECT_EQ(refusal("set_pose_vector", "Pose_V", "pose {name: 'ball'} pose {name: 'tower', position {x: 2}}"), "");
  EXPECT_EQ(model("tower")->pose().position.x(), 2);
}

TEST_F(EditServicesTest, ChangePhysicsOrNothingOfIt) {
  EXPECT_EQ(setPhysics("max_step_size: 0.002, real_time_factor: 3, gravity {z: -1}"), "");
  EXPECT_EQ(simulation_->stepSize(), std::chrono::milliseconds(2));
  EXPECT_EQ(simulation_->realTimeFactor(), 3);
  EXPECT_EQ(simulation_->world().gravity(), Vector3(0, 0, -1));
  for (const char* bad : {"", "max_step_size: -1", "max_step_size: nan", "max_step_size: 1e300",
                          "max_step_size: 0.5, real_time_factor: -1", "max_step_size: 0.5, gravity {x: inf}"}) {
    EXPECT_NE(setPhysics(bad), "") << bad;
  }
  EXPECT_EQ(simulation_->stepSize(), std::chrono::milliseconds(2));
}

}  // namespace
}  // namespace pongsim::sim
