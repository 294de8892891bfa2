#include <gtest/gtest.h>
#include <ignition/msgs/boolean.pb.h>
#include <ignition/msgs/contacts.pb.h>
#include <ignition/msgs/empty.pb.h>
#include <ignition/msgs/image.pb.h>

#include <cmath>
#include <cstring>
#include <string>
#include <vector>

#include "support/ask_service.hh"
#include "support/camera_world.hh"
#include "support/example_world.hh"

namespace pongsim::optical_tactile_plugin_test {
namespace {

namespace im = ignition::msgs;
using test::RunningWorld;

constexpr const char* kSystems =
    "<plugin filename='ignition-gazebo-sensors-system' name='ignition::gazebo::systems::Sensors'/>"
    "<plugin filename='ignition-gazebo-contact-system' name='ignition::gazebo::systems::Contact'/>";

std::string example() {
  return std::string("<gravity>-9.8 0 0</gravity>") + kSystems +
         test::modelsOf("plugins/sensors/opticaltactileplugin/optical_tactile_plugin.sdf");
}

Eigen::Vector3f normalAt(const im::Image& image, std::uint32_t column, std::uint32_t row) {
  Eigen::Vector3f normal;
  std::memcpy(normal.data(), image.data().data() + row * image.step() + column * sizeof(normal), sizeof(normal));
  return normal;
}

class OpticalTactileTest : public test::DrawingTest {};

TEST_F(OpticalTactileTest, TellsTheNormalsOfWhatIsOnThePad) {
  RunningWorld world(example());
  std::vector<im::Image> images;
  std::vector<im::Contacts> contacts;
  world.listen("/world/w/model/pad/link/link/sensor/contact/contact", contacts);
  world.listen("/pad/normal_forces", images);
  world.step(200);
  EXPECT_FALSE(contacts.empty());
  ASSERT_FALSE(images.empty());
  const im::Image& image = images.back();
  EXPECT_EQ(image.width(), 32U);
  EXPECT_EQ(image.height(), 24U);
  EXPECT_EQ(image.step(), 32 * 12U);
  EXPECT_EQ(image.pixel_format_type(), im::R_FLOAT32);
  // the plate is turned by 0.2 rad about z: its face is x = c - y tan(0.2); from left to right y falls and x rises
  const Eigen::Vector3f normal = normalAt(image, 16, 12);
  const auto slope = static_cast<float>(std::tan(0.2));
  EXPECT_LT((normal - Eigen::Vector3f(-1, -slope, 0).normalized()).norm(), 0.01F) << normal.transpose();
  EXPECT_EQ(normalAt(image, 0, 0), Eigen::Vector3f::Zero());
  // the corners of the picture are beside the pad
  EXPECT_TRUE(std::isnan(normalAt(image, 1, 1).y())) << normalAt(image, 1, 1).transpose();
}

TEST_F(OpticalTactileTest, IsSwitchedOnAndOff) {
  RunningWorld world(
      test::replaced(example(), "<namespace>pad</namespace>", "<namespace>pad</namespace><enabled>false</enabled>"));
  std::vector<im::Image> images;
  world.listen("/pad/normal_forces", images);
  world.step(200);
  EXPECT_TRUE(images.empty());
  im::Boolean request;
  request.set_data(true);
  im::Empty reply;
  EXPECT_EQ(test::askService(world.simulation().transport(), "/pad/enable", request, reply).error, "");
  world.step(200);
  EXPECT_FALSE(images.empty());
}

TEST_F(OpticalTactileTest, NeedsOneCameraAndOneBox) {
  const auto complaint = [](const std::string& content) {
    std::string all;
    for (const std::string& each : RunningWorld::complaintsAbout(content)) all += each + "\n";
    return all;
  };
  EXPECT_NE(complaint(test::replaced(example(), "<box><size>0.005 0.02 0.02</size></box>",
                                     "<sphere><radius>0.01</radius></sphere>"))
                .find("its link has no box as collision"),
            std::string::npos);
  EXPECT_NE(complaint(test::replaced(example(), "<update_rate>10</update_rate>", ""))
                .find("its depth camera has no <update_rate>"),
            std::string::npos);
  EXPECT_NE(complaint(test::replaced(example(), "type=\"contact\"", "type=\"imu\""))
                .find("its link must have one depth camera and one contact sensor"),
            std::string::npos);
}

}  // namespace
}  // namespace pongsim::optical_tactile_plugin_test
