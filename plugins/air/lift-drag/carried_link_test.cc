#include "carried_link.hh"

#include <gtest/gtest.h>

#include <cmath>
#include <string>

#include "support/running_world.hh"

namespace pongsim::carried_link_test {
namespace {

using test::RunningWorld;

const std::string kInertial =
    "<inertial><pose>%</pose><mass>1</mass><inertia><ixx>0.1</ixx><iyy>0.1</iyy><izz>0.1</izz></inertia></inertial>";

std::string inertialAt(const std::string& place) {
  return std::string(kInertial).replace(kInertial.find('%'), 1, place);
}

/// A rod that turns about z through the origin, with a blade fixed to it whose centre of mass is 0.5 m out.
std::string rotor(const std::string& parent, const std::string& type) {
  return "<gravity>0 0 0</gravity><model name='m'><link name='base'><inertial><mass>1e6</mass><inertia><ixx>1e6</ixx>"
         "<iyy>1e6</iyy><izz>1e6</izz></inertia></inertial></link><link name='rod'>" +
         inertialAt("0 0 0 0 0 0") + "</link><link name='blade'><pose>0 0.2 0 0 0 0</pose>" +
         inertialAt("0 0.3 0 0 0 0") +
         "</link><joint name='weld' type='fixed'><parent>rod</parent><child>blade</child></joint>"
         "<joint name='axle' type='" +
         type + "'><parent>" + parent + "</parent><child>rod</child><axis><xyz>0 0 1</xyz></axis></joint></model>";
}

TEST(CarriedLink, MovesAlongTheTangentHoweverFarAStepTurnsIt) {
  for (const std::string parent : {"world", "base"}) {
    RunningWorld world(rotor(parent, "revolute"));
    const Model model = world.model("m");
    Joint axle = *model.joint("axle");
    const Link blade = *model.link("blade");
    const CarriedLink carried(blade);
    ASSERT_TRUE(axle.resetVelocity(300));
    world.step(20);
    const Vector3 arm = blade.pose().position - axle.child().pose().position;
    const Vector3 tangent = Vector3(0, 0, axle.velocity()).cross(arm);
    EXPECT_NEAR(arm.norm(), 0.2, 1e-3);
    EXPECT_LT((carried.linearVelocity() - tangent).norm(), 1e-3 * tangent.norm()) << parent;
    // the link itself is half a step behind
    EXPECT_GT((blade.linearVelocity() - tangent).norm(), 0.1 * tangent.norm()) << parent;
  }
}

TEST(CarriedLink, MovesAsItIsToldWhereNoJointCarriesItOrOneThatSlides) {
  RunningWorld free("<gravity>0 0 0</gravity><model name='m'><link name='blade'>" + inertialAt("0 0.3 0 0 0 0") +
                    "</link></model>");
  Link blade = *free.model("m").link("blade");
  blade.setVelocity({1, 2, 3}, {0, 0, 4});
  EXPECT_EQ(CarriedLink(blade).linearVelocity(), Vector3(1, 2, 3));

  RunningWorld slides(rotor("world", "prismatic"));
  const Model model = slides.model("m");
  Joint axle = *model.joint("axle");
  ASSERT_TRUE(axle.resetVelocity(2));
  slides.step(10);
  EXPECT_NEAR(CarriedLink(*model.link("rod")).linearVelocity().z(), 2, 1e-3);
  EXPECT_NEAR(CarriedLink(*model.link("blade")).linearVelocity().z(), 2, 1e-3);
}

}  // namespace
}  // namespace pongsim::carried_link_test
