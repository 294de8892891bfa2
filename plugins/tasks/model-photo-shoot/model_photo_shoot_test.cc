#include <gtest/gtest.h>

#include <cmath>
#include <cstddef>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <optional>
#include <string>
#include <vector>

#include "pongsim/files/parameter_picture.hh"
#include "support/camera_world.hh"
#include "support/example_world.hh"
#include "support/working_folder.hh"

namespace pongsim::model_photo_shoot_test {
namespace {

namespace fs = std::filesystem;
using test::RunningWorld;

std::string example() {
  return "<scene><background>1 1 1 1</background></scene><gravity>0 0 0</gravity>" +
         test::modelsOf("plugins/tasks/model-photo-shoot/model_photo_shoot.sdf");
}

std::string textOf(const fs::path& file) {
  std::ifstream stream(file);
  return {std::istreambuf_iterator<char>(stream), {}};
}

/// @return Width and height of the red part of a picture of 96 by 54 pixels.
Eigen::Vector2i redExtent(const fs::path& file) {
  Element element;
  element.text = file.string();
  const ParameterPicture picture = parameterPicture(element);
  EXPECT_EQ(picture.width, 96U);
  EXPECT_EQ(picture.height, 54U);
  Eigen::AlignedBox2i box;
  for (std::size_t i = 0; i < picture.width * picture.height; ++i) {
    const auto* pixel = &picture.pixels[4 * i];
    if (pixel[0] < pixel[1] + 30) continue;
    box.extend(Eigen::Vector2i(static_cast<int>(i % picture.width), static_cast<int>(i / picture.width)));
  }
  return box.isEmpty() ? Eigen::Vector2i(0, 0) : Eigen::Vector2i(box.sizes().array() + 1);
}

class ModelPhotoShootTest : public test::DrawingTest {
 protected:
  test::WorkingFolder folder_;
};

TEST_F(ModelPhotoShootTest, ShowsTheModelFromFiveSides) {
  RunningWorld world(example());
  world.step(2);
  for (const char* name : {"1.png", "2.png", "3.png", "4.png", "5.png"}) EXPECT_TRUE(fs::exists(name)) << name;
  // focal length 83 pixels; the arrow is 2 m long, 0.2 m wide and 0.4 m high
  const double focal = 96 / (2 * std::tan(1.047 / 2));
  const Eigen::Vector2i above = redExtent("2.png"), ahead = redExtent("3.png"), left = redExtent("4.png"),
                        behind = redExtent("5.png");
  // seen from above, x is upward in the picture
  EXPECT_NEAR(above.y(), focal * 2 / (4.4 - 0.2), 2);
  EXPECT_NEAR(above.x(), focal * 0.2 / (4.4 - 0.2), 2);
  EXPECT_NEAR(left.x(), focal * 2 / (4.4 - 0.1), 2);
  EXPECT_NEAR(left.y(), focal * 0.4 / (4.4 - 0.1), 2);
  EXPECT_NEAR(ahead.x(), focal * 0.2 / (4.4 - 1), 2);
  EXPECT_NEAR(ahead.y(), focal * 0.4 / (4.4 - 1), 2);
  EXPECT_NEAR(behind.x(), focal * 0.2 / (4.4 - 1), 2);
  EXPECT_NEAR(behind.y(), focal * 0.4 / (4.4 - 1), 2);
  EXPECT_GT(redExtent("1.png").x(), 10);
  EXPECT_EQ(textOf("poses.txt"), "Translation: 1 2 3\nScaling: 0.5\n");
}

TEST_F(ModelPhotoShootTest, TakesThemOnce) {
  RunningWorld world(example());
  world.step(1);
  fs::remove("1.png");
  world.step(3);
  EXPECT_FALSE(fs::exists("1.png"));
}

TEST_F(ModelPhotoShootTest, WaitsForTheCamera) {
  RunningWorld world(test::replaced(example(), "<model name=\"photo_shoot\">", "<model name=\"other\">"));
  world.step(3);
  EXPECT_FALSE(fs::exists("1.png"));
}

TEST_F(ModelPhotoShootTest, MovesJointsBetweenTheirLimits) {
  const std::string joint =
      "<link name='tip'><pose>1 0 0 0 0 0</pose></link><joint name='hinge' type='revolute'><parent>shaft</parent>"
      "<child>tip</child><axis><xyz>0 0 1</xyz><limit><lower>0.5</lower><upper>0.7</upper></limit></axis></joint>";
  RunningWorld world(test::replaced(test::replaced(example(), "<plugin filename=\"ignition-gazebo-model",
                                                   joint + "<plugin filename=\"ignition-gazebo-model"),
                                    "<translation_data_file>",
                                    "<random_joints_pose>true</random_joints_pose><translation_data_file>"));
  world.step(1);
  const std::string text = textOf("poses.txt");
  ASSERT_EQ(text.rfind("hinge: ", 0), 0U) << text;
  const double position = std::stod(text.substr(7));
  EXPECT_GE(position, 0.5);
  EXPECT_LE(position, 0.7);
  EXPECT_NEAR(world.model("arrow").joint("hinge")->position(), position, 1e-3);
}

TEST_F(ModelPhotoShootTest, SaysWhyThereAreNone) {
  fs::create_directory("1.png");
  RunningWorld world(example());
  testing::internal::CaptureStderr();
  world.step(1);
  EXPECT_NE(testing::internal::GetCapturedStderr().find("no pictures of 'arrow': '"), std::string::npos);
  const Outcome<void> finished = world.simulation().finish();
  ASSERT_FALSE(finished);
  EXPECT_NE(finished.error.find("1.png"), std::string::npos);
}

}  // namespace
}  // namespace pongsim::model_photo_shoot_test
