#include "cli/model/model_text.hh"

#include <gtest/gtest.h>

#include <string>
#include <utility>
#include <vector>

namespace pongsim::cli {
namespace {

using msgs::EntityState;
using Kind = EntityState::Kind;

EntityState thing(std::uint64_t id, Kind kind, std::string name, std::uint64_t parent, const Pose& pose = {}) {
  EntityState state;
  state.id = id;
  state.kind = kind;
  state.name = std::move(name);
  state.parent = parent;
  if (kind != Kind::kWorld) state.pose = pose;
  return state;
}

/// A world with a model "cart" that has a link with a sensor, a nested model "arm" and a joint between the two.
ModelTeller cart() {
  EntityState chassis = thing(10, Kind::kLink, "chassis", 9, {{-0.5, 0, 0}, Quaternion::Identity()});
  chassis.inertial.emplace().mass = 1.14395;
  chassis.inertial->moments = Vector3(0.1, 0.2, 0.3).asDiagonal();
  EntityState altimeter = thing(12, Kind::kSensor, "height", 10);
  altimeter.sensor.emplace().type = "altimeter";
  altimeter.sensor->settings = AltimeterSettings{};
  EntityState hinge = thing(30, Kind::kJoint, "hinge", 9);
  hinge.jointType = "revolute";
  hinge.parentLink = "chassis";
  hinge.childLink = "arm::tip";
  hinge.axes = {Vector3(1e-15, 0, 1)};
  hinge.positions = {0.5};
  return ModelTeller({thing(1, Kind::kWorld, "w", 0), thing(4, Kind::kModel, "ground", 1),
                      thing(9, Kind::kModel, "cart", 1, {{0, 2, 0.325}, Quaternion::Identity()}), chassis, altimeter,
                      thing(14, Kind::kModel, "arm", 9), thing(15, Kind::kLink, "tip", 14), hinge});
}

std::string told(const ModelParts& parts) { return cart().text(9, parts); }

TEST(ModelText, ListsModelsAsFortressDoes) {
  EXPECT_EQ(cart().listText(), "Available models:\n    - ground\n    - cart\n");
  EXPECT_EQ(cart().listJson(),
            "[{\"name\":\"ground\",\"id\":4,\"static\":false},{\"name\":\"cart\",\"id\":9,\"static\":false}]\n");
}

TEST(ModelText, FindsModelsByTheirNames) {
  EXPECT_EQ(cart().find("cart"), 9U);
  EXPECT_EQ(cart().find("cart::arm"), 14U);
  EXPECT_EQ(cart().find("arm"), 14U);
  EXPECT_EQ(cart().find("tip"), std::nullopt);
  EXPECT_EQ(cart().namesOf(9, Kind::kSensor), std::vector<std::string>{"height"});
}

TEST(ModelText, PrintsAPoseAsFortressDoes) {
  EXPECT_EQ(told({.pose = true, .link = {}, .joint = {}, .sensor = {}}),
            "Model: [9]\n  - Name: cart\n  - Pose [ XYZ (m) ] [ RPY (rad) ]:\n    [0.000000 2.000000 0.325000]\n"
            "    [0.000000 0.000000 0.000000]\n");
}

TEST(ModelText, PrintsLinksAsFortressDoes) {
  const std::string link =
      "- Link [10]\n"
      "  - Name: chassis\n"
      "  - Parent: cart [9]\n"
      "  - Mass (kg): 1.143950\n"
      "  - Inertial Pose [ XYZ (m) ] [ RPY (rad) ]:\n"
      "    [0.000000 0.000000 0.000000]\n"
      "    [0.000000 0.000000 0.000000]\n"
      "  - Inertial Matrix (kg.m^2):\n"
      "    [0.100000 0.000000 0.000000]\n"
      "    [0.000000 0.200000 0.000000]\n"
      "    [0.000000 0.000000 0.300000]\n"
      "  - Pose [ XYZ (m) ] [ RPY (rad) ]:\n"
      "    [-0.500000 0.000000 0.000000]\n"
      "    [0.000000 0.000000 0.000000]\n"
      "  - Sensor [12]\n"
      "    - Name: height\n"
      "    - Parent: cart [9]\n";
  EXPECT_EQ(told({.pose = false, .link = "", .joint = {}, .sensor = {}}).substr(0, link.size()), link);
  EXPECT_EQ(told({.pose = false, .link = "other", .joint = {}, .sensor = {}}), "");
}

TEST(ModelText, PrintsJointsAsFortressDoes) {
  EXPECT_EQ(told({.pose = false, .link = {}, .joint = "hinge", .sensor = {}}),
            "- Joint [30]\n"
            "  - Name: hinge\n"
            "  - Parent: cart [9]\n"
            "  - Type: revolute\n"
            "  - Parent Link: chassis [10]\n"
            "  - Child Link: arm::tip [15]\n"
            "  - Pose [ XYZ (m) ] [ RPY (rad) ]:\n"
            "    [0.000000 0.000000 0.000000]\n"
            "    [0.000000 0.000000 0.000000]\n"
            "  - Axis unit vector [ XYZ ]:\n"
            "    [0 0 1]\n");
}

TEST(ModelText, PrintsANamedSensorAlone) {
  const std::string text = told({.pose = false, .link = {}, .joint = {}, .sensor = "height"});
  EXPECT_TRUE(text.starts_with("- Sensor [12]\n  - Name: height\n")) << text;
  EXPECT_NE(text.find("  - Vertical position noise:\n"), std::string::npos) << text;
}

TEST(ModelText, PrintsAllIndentedBelowTheModel) {
  const std::string text = told({});
  EXPECT_TRUE(text.starts_with("Model: [9]\n")) << text;
  EXPECT_NE(text.find("\n  - Link [10]\n    - Name: chassis\n"), std::string::npos) << text;
  EXPECT_NE(text.find("\n    - Sensor [12]\n"), std::string::npos) << text;
  EXPECT_NE(text.find("\n  - Joint [30]\n"), std::string::npos) << text;
}

TEST(ModelText, IsJsonToo) {
  EXPECT_EQ(cart().json(9, {.pose = true, .link = {}, .joint = {}, .sensor = {}}),
            "{\"name\":\"cart\",\"id\":9,\"pose\":{\"position\":[0.0,2.0,0.325],\"rpy\":[0.0,0.0,0.0]}}\n");
  const std::string all = cart().json(9, {});
  EXPECT_NE(all.find("\"mass\":1.14395"), std::string::npos) << all;
  EXPECT_NE(all.find("\"sensors\":[{\"name\":\"height\""), std::string::npos) << all;
  EXPECT_NE(all.find("\"child\":\"arm::tip\""), std::string::npos) << all;
  EXPECT_NE(all.find("\"positions\":[0.5]"), std::string::npos) << all;
}

}  // namespace
}  // namespace pongsim::cli
