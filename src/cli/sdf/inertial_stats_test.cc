#include "cli/sdf/inertial_stats.hh"

#include <gtest/gtest.h>

#include <numbers>

namespace pongsim::cli {
namespace {

description::Link link(double mass, const Vector3& position, const Vector3& moments) {
  description::Link link;
  link.X_ModelLink.position = position;
  link.inertial.mass = mass;
  link.inertial.moments = moments.asDiagonal();
  return link;
}

TEST(InertialStats, AddUpTheLinksInTheModelFrame) {
  description::Model model;
  model.name = "dumbbell";
  model.links = {link(1, {-1, 0, 0}, {0.1, 0.2, 0.3}), link(3, {1, 0, 0}, {0.1, 0.2, 0.3})};
  // 1 kg at 1.5 m and 3 kg at 0.5 m of the centre: 2.25 + 0.75 kg m^2
  EXPECT_EQ(inertialStats(model),
            "Inertial statistics for model: dumbbell\n---\nTotal mass of the model: 4\n---\n"
            "Centre of mass in model frame: \nX: 0.5\nY: 0\nZ: 0\n---\nMoment of inertia matrix: \n"
            "0.2  0    0    \n0    3.4  0    \n0    0    3.6  \n---\n");
}

TEST(InertialStats, TurnWithTheirLinks) {
  description::Model model;
  model.links = {link(2, {0, 0, 1}, {1, 2, 3})};
  model.links[0].X_ModelLink.rotation = fromRollPitchYaw(std::numbers::pi / 2, 0, 0);
  model.links[0].inertial.X_LinkCom.position = {0, 0, 0.5};
  const std::string text = inertialStats(model);
  EXPECT_NE(text.find("Y: -0.5\n"), std::string::npos) << text;
  EXPECT_NE(text.find("Z: 1\n"), std::string::npos) << text;
  // the link's y axis is the model's z
  const std::size_t table = text.find("matrix: \n");
  EXPECT_EQ(text.substr(table + 9, 1), "1") << text;
  EXPECT_NE(text.find("2", table), std::string::npos) << text;
}

}  // namespace
}  // namespace pongsim::cli
