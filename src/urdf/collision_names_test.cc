#include "urdf/collision_names.hh"

#include <gtest/gtest.h>

#include "support/urdf/robot_support.hh"

namespace pongsim::urdf::test {
namespace {

const std::string kSphere = "<geometry><sphere radius='0.5'/></geometry>";
const std::string kShell = "<collision name='shell'>" + kSphere + "</collision>";

std::string bumperOf(const std::string& link, const std::string& collision) {
  return "<gazebo reference='" + link + "'><sensor name='" + link + "' type='contact'><contact><collision>" +
         collision + "</collision></contact></sensor></gazebo>";
}

/// @return Which collisions the contact sensors of link "base" watch.
Messages watchedIn(const std::string& robot) {
  const Converted converted = convert(robot);
  EXPECT_EQ(converted.messages, Messages());
  Messages watched;
  for (const Element* sensor : converted.part("link", "base").childrenNamed("sensor")) {
    watched.push_back(textAt(*sensor, "contact/collision"));
  }
  return watched;
}

TEST(CollisionNames, LetSensorsUseTheNameInTheirFile) {
  EXPECT_EQ(watchedIn(linkNamed("base", kShell) + bumperOf("base", "shell")),
            Messages{"base_fixed_joint_lump__shell_collision"});
}

TEST(CollisionNames, LetSensorsOfLumpedLinksUseTheNamesOfTheirOwnLink) {
  const std::string two = linkNamed("base", kShell) + linkNamed("left", kShell) + linkNamed("right", kShell) +
                          linkNamed("nose", "<collision>" + kSphere + "</collision>") +
                          jointNamed("l", "fixed", "base", "left") + jointNamed("n", "fixed", "base", "nose") +
                          jointNamed("r", "fixed", "base", "right");
  const Messages expected = {"base_fixed_joint_lump__shell_collision_1", "base_fixed_joint_lump__nose_collision_2",
                             "base_fixed_joint_lump__shell_collision_3"};
  EXPECT_EQ(
      watchedIn(two + bumperOf("left", "shell") + bumperOf("right", "shell") + bumperOf("nose", "nose_collision")),
      expected);
}

TEST(CollisionNames, LeaveConvertedNamesAndWhatIsUnknownOrAmbiguous) {
  const std::string base = linkNamed("base", kShell + kShell);
  EXPECT_EQ(watchedIn(base + bumperOf("base", "base_fixed_joint_lump__shell_collision_1") + bumperOf("base", "shell") +
                      bumperOf("base", "hull")),
            (Messages{"base_fixed_joint_lump__shell_collision_1", "shell", "hull"}));
}

}  // namespace
}  // namespace pongsim::urdf::test
