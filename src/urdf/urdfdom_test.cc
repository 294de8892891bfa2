#include "urdf/urdfdom.hh"

#include <thread>

#include "support/urdf/robot_support.hh"

namespace pongsim::urdf::test {
namespace {

TEST(Urdfdom, ReadsARobot) {
  Diagnostics diagnostics;
  const auto model = readWithUrdfdom(robotWith(linkNamed("a")), diagnostics);
  ASSERT_NE(model, nullptr);
  EXPECT_EQ(model->getRoot()->name, "a");
  EXPECT_EQ(messagesOf(diagnostics), Messages());
}

TEST(Urdfdom, SaysThroughDiagnosticsWhatItWouldPrint) {
  testing::internal::CaptureStderr();
  testing::internal::CaptureStdout();
  Diagnostics diagnostics;
  const Element robot = robotWith(linkNamed("a") + "<link name='b'><inertial/></link>");
  EXPECT_EQ(readWithUrdfdom(robot, diagnostics), nullptr);
  EXPECT_EQ(testing::internal::GetCapturedStdout(), "");
  EXPECT_EQ(testing::internal::GetCapturedStderr(), "");
  EXPECT_TRUE(diagnostics.hasErrors());
  ASSERT_FALSE(diagnostics.all().empty());
  bool namesTheLink = false;
  for (const std::string& message : messagesOf(diagnostics)) {
    EXPECT_TRUE(message.starts_with("r.urdf:")) << message;
    namesTheLink = namesTheLink || message.starts_with("r.urdf:3:1: error: urdfdom: ");
  }
  EXPECT_TRUE(namesTheLink) << messagesOf(diagnostics).front();
}

TEST(Urdfdom, PlacesAndTellsOnceWhatItSaysOfALink) {
  Diagnostics diagnostics;
  const Element robot = robotWith(
      linkNamed("a", "\n<visual><geometry><sphere radius='1'/></geometry><material name='nowhere'/></visual>"));
  EXPECT_NE(readWithUrdfdom(robot, diagnostics), nullptr);
  EXPECT_EQ(messagesOf(diagnostics), Messages{"r.urdf:2:1: warning: urdfdom: link 'a' material 'nowhere' undefined."});
}

TEST(Urdfdom, MayBeUsedOnSeveralThreads) {
  const Element sound = robotWith(linkNamed("a"));
  const Element broken = robotWith("<link name='b'><inertial/></link>");
  const auto readMany = [](const Element& robot, bool isSound) {
    for (int i = 0; i < 50; ++i) {
      Diagnostics diagnostics;
      EXPECT_EQ(readWithUrdfdom(robot, diagnostics) != nullptr, isSound);
      EXPECT_EQ(diagnostics.all().empty(), isSound);
    }
  };
  std::thread other([&] { readMany(sound, true); });
  readMany(broken, false);
  other.join();
}

}  // namespace
}  // namespace pongsim::urdf::test
