#include "ros2/services/entity_services.hh"

#include <gtest/gtest.h>

#include <limits>

#include "support/ros2/served_world.hh"

namespace pongsim::ros2::entity_services_test {
namespace {

namespace si = simulation_interfaces;
namespace srv = simulation_interfaces::srv;
using si::SpawnResult;

const std::string kWorld =
    "<gravity>0 0 0</gravity><frame name='dock'><pose>1 2 3 0 0 0</pose></frame>"
    "<model name='box'><pose>5 0 0 0 0 0</pose><link name='l'><collision name='c'><geometry><box><size>2 2 "
    "2</size></box>"
    "</geometry></collision></link></model>"
    "<model name='wall'><static>true</static><link name='l'/><model name='door'><link name='l'/></model></model>";

std::string ball(const std::string& name, const std::string& content = "") {
  return "<sdf version='1.9'><model name='" + name + "'><link name='l'>" + content + "</link></model></sdf>";
}

class EntityServicesTest : public testing::Test {
 protected:
  EntityServicesTest() {
    world_.folder().write("models/cup/model.config",
                          "<model><name>cup</name><version>1</version><sdf version='1.9'>model.sdf</sdf></model>");
    world_.folder().write("models/cup/model.sdf", ball("cup"));
  }
  static srv::SpawnEntity::Request text(const std::string& content, const std::string& name = "") {
    srv::SpawnEntity::Request request;
    request.name = name;
    request.entity_resource.resource_string = content;
    return request;
  }
  static srv::SpawnEntity::Request uri(const std::string& address) {
    srv::SpawnEntity::Request request;
    request.entity_resource.uri = address;
    return request;
  }
  srv::SpawnEntity::Response spawn(const srv::SpawnEntity::Request& request) {
    return world_.call<srv::SpawnEntity>("~/spawn_entity", request);
  }
  /// @param part Expected in the text of the refusal.
  void expectRefused(const srv::SpawnEntity::Request& request, std::uint8_t code, const std::string& part) {
    const auto response = spawn(request);
    EXPECT_EQ(response.result.result, code) << response.result.error_message;
    EXPECT_NE(response.result.error_message.find(part), std::string::npos) << response.result.error_message;
    EXPECT_EQ(response.entity_name, "");
  }
  std::vector<std::string> entities(const si::EntityFilters& filters = {}) {
    const auto response = world_.call<srv::GetEntities>("~/get_entities", {filters});
    EXPECT_EQ(response.result, succeeded());
    return response.entities;
  }
  si::EntityState state(const std::string& entity) {
    const auto response = world_.call<srv::GetEntityState>("~/get_entity_state", {entity});
    EXPECT_EQ(response.result, succeeded());
    return response.state;
  }

  ServedWorld world_{kWorld, {"--paused"}};
};

using Names = std::vector<std::string>;

TEST_F(EntityServicesTest, SpawnATextWhereThePoseSays) {
  auto request = text(ball("ball"));
  request.initial_pose.header.frame_id = "dock";
  request.initial_pose.pose.position = {1, 0, 0};
  const auto response = spawn(request);
  EXPECT_EQ(response.result, succeeded());
  EXPECT_EQ(response.entity_name, "ball");
  EXPECT_EQ(vectorOf(state("ball").pose.position), Vector3(2, 2, 3));
  EXPECT_EQ(entities(), (Names{"box", "wall", "ball"}));
}

TEST_F(EntityServicesTest, SpawnRobotsInUrdf) {
  const auto response =
      spawn(text("<robot name='arm'><link name='base'><inertial><mass value='1'/>"
                 "<inertia ixx='1' ixy='0' ixz='0' iyy='1' iyz='0' izz='1'/></inertial></link></robot>"));
  EXPECT_EQ(response.result, succeeded());
  EXPECT_EQ(response.entity_name, "arm");
}

TEST_F(EntityServicesTest, SpawnFilesAndModelsOfTheResourceFolders) {
  EXPECT_EQ(spawn(uri("model://cup")).entity_name, "cup");
  auto again = uri((world_.folder().path() / "models/cup").string());
  again.name = "mug";
  EXPECT_EQ(spawn(again).entity_name, "mug");
  again.entity_resource.uri = "file://" + (world_.folder().path() / "models/cup/model.sdf").string();
  again.name = "glass";
  EXPECT_EQ(spawn(again).entity_name, "glass");
  const auto response = world_.call<srv::GetSpawnables>("~/get_spawnables", {{"/no/such"}});
  EXPECT_EQ(response.result, (Result{Result::kResultOk, "no folder: '/no/such'"}));
  ASSERT_EQ(response.spawnables.size(), 1U);
  EXPECT_EQ(response.spawnables[0].entity_resource.uri, "model://cup");
}

TEST_F(EntityServicesTest, NameWhatTheySpawn) {
  EXPECT_EQ(spawn(text(ball("ball"), "marble")).entity_name, "marble");
  expectRefused(text(ball("box")), SpawnResult::kNameNotUnique, "there is a 'box' in the world already");
  auto request = text(ball("box"));
  request.allow_renaming = true;
  EXPECT_EQ(spawn(request).entity_name, "box_0");
  EXPECT_EQ(spawn(request).entity_name, "box_1");
}

TEST_F(EntityServicesTest, PutWhatTheySpawnIntoItsNamespace) {
  auto request = text(ball("car", "<sensor name='s' type='imu'><topic>imu</topic></sensor>"));
  request.entity_namespace = "r1";
  EXPECT_EQ(spawn(request).result, succeeded());
  for (const char* bad : {"1r", "a b", "a//b", "a-b", "/"}) {
    request.entity_namespace = bad;
    request.name = "x";
    expectRefused(request, SpawnResult::kNamespaceInvalid, std::string("the namespace '") + bad + "' ");
  }
}

TEST_F(EntityServicesTest, SayWhyTheyDoNotSpawn) {
  constexpr double kNan = std::numeric_limits<double>::quiet_NaN();
  expectRefused({}, SpawnResult::kNoResource, "both uri and resource_string are empty");
  expectRefused(text(ball("a"), "a::b"), SpawnResult::kNameInvalid, "contains '::'");
  expectRefused(text(ball("a"), "world"), SpawnResult::kNameInvalid, "is the world's frame");
  expectRefused(text(ball("a"), "a\nb"), SpawnResult::kNameInvalid, "has a control character");
  expectRefused(text("<mujoco/>"), SpawnResult::kUnsupportedFormat, "begins with <mujoco>");
  expectRefused(text("nonsense"), SpawnResult::kResourceParseError, "resource_string");
  expectRefused(text("<sdf version='1.9'><model name='m'><lonk/>"), SpawnResult::kResourceParseError,
                "resource_string:1:");
  expectRefused(text("<sdf version='1.9'/>"), SpawnResult::kResourceParseError,
                "there is no <world> and no <model> in this file");
  expectRefused(text("<robot name='r'/>"), SpawnResult::kResourceParseError, "the robot has no <link>");
  expectRefused(uri("model://nothing"), Result::kResultNotFound, "there is no 'model://nothing'");
  world_.folder().write("scene.usd", "x");
  expectRefused(uri((world_.folder().path() / "scene.usd").string()), SpawnResult::kUnsupportedFormat,
                "is neither SDF nor URDF");
  const std::string mesh = "<visual name='v'><geometry><mesh><uri>URI</uri></mesh></geometry></visual>";
  const auto withMesh = [&](const std::string& address) {
    std::string content = mesh;
    return ball("m", content.replace(content.find("URI"), 3, address));
  };
  expectRefused(text(withMesh("model://no/such.dae")), SpawnResult::kMissingAssets, "is not found");
  const auto broken = world_.folder().write("broken.stl", "no mesh");
  expectRefused(text(ball("m", "<collision name='v'><geometry><mesh><uri>" + broken.string() +
                                   "</uri></mesh></geometry></collision>")),
                SpawnResult::kUnsupportedAssets, "can't be read as ");

  auto request = text(ball("a"));
  request.initial_pose.pose.position.x = kNan;
  expectRefused(request, SpawnResult::kInvalidPose, "the pose is not finite");
  request.initial_pose.pose.position.x = 0;
  request.initial_pose.pose.orientation.w = 0;
  expectRefused(request, SpawnResult::kInvalidPose, "the quaternion's length is not 1");
  request.initial_pose.pose.orientation.w = 1;
  request.initial_pose.header.frame_id = "moon";
  expectRefused(request, SpawnResult::kInvalidPose, "there is no frame 'moon'");
  EXPECT_EQ(entities(), (Names{"box", "wall"}));
}

TEST_F(EntityServicesTest, RefuseResourcesOfEnormousLength) {
  expectRefused(text(std::string(100'000'000, ' ')), SpawnResult::kResourceParseError,
                "resource_string is 100000000 bytes long; up to 33554432 are allowed");
}

TEST_F(EntityServicesTest, SpawnSeveralEachByItself) {
  const auto asMessage = [](const srv::SpawnEntity::Request& request) {
    return si::SpawnEntity{request.name, request.allow_renaming, request.entity_resource, request.entity_namespace,
                           request.initial_pose};
  };
  srv::SpawnEntities::Request request;
  EXPECT_EQ(world_.call<srv::SpawnEntities>("~/spawn_entities", request).result, succeeded());
  request.spawn_requests = {asMessage(text(ball("a"))), asMessage(text(ball("b")))};
  auto response = world_.call<srv::SpawnEntities>("~/spawn_entities", request);
  EXPECT_EQ(response.result, succeeded());
  ASSERT_EQ(response.results.size(), 2U);
  EXPECT_EQ(response.results[1].entity_name, "b");
  // of two with the same name, the first one is inserted
  request.spawn_requests = {asMessage(text(ball("c"))), asMessage(text(ball("c"))), asMessage({})};
  response = world_.call<srv::SpawnEntities>("~/spawn_entities", request);
  EXPECT_EQ(response.result.result, srv::SpawnEntities::Response::kEntitiesSpawnFailed);
  ASSERT_EQ(response.results.size(), 3U);
  EXPECT_EQ(response.results[0].result, succeeded());
  EXPECT_EQ(response.results[1].result.result, SpawnResult::kNameNotUnique);
  EXPECT_EQ(response.results[2].result.result, SpawnResult::kNoResource);
  EXPECT_EQ(entities(), (Names{"box", "wall", "a", "b", "c"}));
}

TEST_F(EntityServicesTest, DeleteWhatIsAtTheTopLevel) {
  const auto remove = [&](const std::string& name) {
    return world_.call<srv::DeleteEntity>("~/delete_entity", {name}).result;
  };
  EXPECT_EQ(remove("box"), succeeded());
  EXPECT_EQ(entities(), Names{"wall"});
  EXPECT_EQ(remove("box"), notFound("there is no entity 'box'"));
  EXPECT_EQ(remove(""), notFound("no entity is given"));
  EXPECT_EQ(remove("wall::door"), failed("'wall::door' is part of 'wall' and can't be removed alone"));
}

TEST_F(EntityServicesTest, FilterEntities) {
  si::EntityFilters filters;
  filters.filter = "^b";
  EXPECT_EQ(entities(filters), Names{"box"});
  const auto states = world_.call<srv::GetEntitiesStates>("~/get_entities_states", {filters});
  EXPECT_EQ(states.result, succeeded());
  EXPECT_EQ(states.entities, Names{"box"});
  ASSERT_EQ(states.states.size(), 1U);
  EXPECT_EQ(states.states[0].pose.position.x, 5);
  filters.filter = "[";
  EXPECT_EQ(world_.call<srv::GetEntities>("~/get_entities", {filters}).result.result, Result::kResultOperationFailed);
  EXPECT_EQ(world_.call<srv::GetEntitiesStates>("~/get_entities_states", {filters}).result.result,
            Result::kResultOperationFailed);
}

TEST_F(EntityServicesTest, TellAndSetInfos) {
  si::EntityInfo info{{si::EntityCategory::kCategoryDynamicObject}, "a box", {"red"}};
  EXPECT_EQ(world_.call<srv::SetEntityInfo>("~/set_entity_info", {"box", info}).result, succeeded());
  const auto response = world_.call<srv::GetEntityInfo>("~/get_entity_info", {"box"});
  EXPECT_EQ(response.result, succeeded());
  EXPECT_EQ(response.info, info);
  EXPECT_EQ(world_.call<srv::GetEntityInfo>("~/get_entity_info", {"bax"}).result, notFound("there is no entity 'bax'"));
  EXPECT_EQ(world_.call<srv::SetEntityInfo>("~/set_entity_info", {"bax", info}).result.result, Result::kResultNotFound);
  // entities inserted after the removal have ids of their own
  EXPECT_EQ(world_.call<srv::DeleteEntity>("~/delete_entity", {"box"}).result, succeeded());
  EXPECT_EQ(spawn(text(ball("box"))).result, succeeded());
  EXPECT_EQ(world_.call<srv::GetEntityInfo>("~/get_entity_info", {"box"}).info, si::EntityInfo());
}

TEST_F(EntityServicesTest, SetStates) {
  srv::SetEntityState::Request request;
  request.entity = "box";
  request.set_pose = true;
  request.state.pose.position = {7, 8, 9};
  EXPECT_EQ(world_.call<srv::SetEntityState>("~/set_entity_state", request).result, succeeded());
  EXPECT_EQ(vectorOf(state("box").pose.position), Vector3(7, 8, 9));
  EXPECT_EQ(world_.call<srv::GetEntityState>("~/get_entity_state", {"bax"}).result,
            notFound("there is no entity 'bax'"));
}

TEST_F(EntityServicesTest, TellBoundsAndNamedPoses) {
  const auto bounds = world_.call<srv::GetEntityBounds>("~/get_entity_bounds", {"box"});
  EXPECT_EQ(bounds.result, succeeded());
  EXPECT_EQ(bounds.bounds.type, si::Bounds::kTypeBox);
  EXPECT_EQ(world_.call<srv::GetEntityBounds>("~/get_entity_bounds", {"bax"}).result.result, Result::kResultNotFound);
  EXPECT_EQ(world_.call<srv::GetEntityBounds>("~/get_entity_bounds", {"wall"}).result.result,
            Result::kResultOperationFailed);
  const auto poses = world_.call<srv::GetNamedPoses>("~/get_named_poses");
  ASSERT_EQ(poses.poses.size(), 1U);
  EXPECT_EQ(poses.poses[0].name, "dock");
  EXPECT_EQ(world_.call<srv::GetNamedPoseBounds>("~/get_named_pose_bounds", {"dock"}).result, succeeded());
  EXPECT_EQ(world_.call<srv::GetNamedPoseBounds>("~/get_named_pose_bounds", {"box"}).result.result,
            Result::kResultNotFound);
}

TEST(EntityServicesPrefix, MayBeAnotherOne) {
  ServedWorld world(kWorld, {}, "<service_prefix>/gzserver</service_prefix>");
  EXPECT_EQ(world.call<srv::GetEntities>("/gzserver/get_entities").entities, (Names{"box", "wall"}));
}

}  // namespace
}  // namespace pongsim::ros2::entity_services_test
