#include "cli/dataset/sample_reader.hh"

#include <gtest/gtest.h>

#include <cstdint>
#include <filesystem>
#include <string>
#include <vector>

#include "assets/images/picture_file.hh"
#include "support/temp_folder.hh"

namespace pongsim::cli {
namespace {

namespace fs = std::filesystem;

class SampleReader : public testing::Test {
 protected:
  /// Writes a picture of 4 x 3 pixels.
  void writePicture(const std::string& name, std::uint8_t value = 0, std::size_t width = 4) {
    const fs::path file = folder_.path() / name;
    fs::create_directories(file.parent_path());
    ASSERT_FALSE(assets::writePicture(file, width, 3, std::vector<std::uint8_t>(width * 3 * 3, value)));
  }

  std::vector<Sample> read() {
    found_ = {};
    return readSamples(folder_.path(), found_);
  }

  std::string message(std::size_t i) const { return found_.all().at(i).message; }

  const test::TempFolder folder_;
  Diagnostics found_;
};

TEST_F(SampleReader, ReadsBoxesInPictures) {
  for (const char* name : {"images/image_0000001.png", "images/image_0000000.png"}) writePicture(name);
  folder_.write("boxes/boxes_0000000.csv", "label,x_center,y_center,width,height\n7,1.5,1.000000,1.000000,2.000000\n");
  folder_.write("boxes/boxes_0000001.csv", "label,x_center,y_center,width,height\n7,1.25,1.5,1.5,2\n0,1,1,0,0\n");
  const std::vector<Sample> samples = read();
  EXPECT_TRUE(found_.all().empty());
  ASSERT_EQ(samples.size(), 2U);
  EXPECT_EQ(samples[0].picture.filename(), "image_0000000.png");
  EXPECT_EQ(samples[0].width, 4U);
  EXPECT_EQ(samples[0].height, 3U);
  ASSERT_EQ(samples[0].things.size(), 1U);
  // columns 1 and 2, rows 0 to 2
  EXPECT_EQ(samples[0].things[0].label, 7);
  EXPECT_EQ(samples[0].things[0].box.min(), Eigen::Vector2d(1, 0));
  EXPECT_EQ(samples[0].things[0].box.max(), Eigen::Vector2d(3, 3));
  ASSERT_EQ(samples[1].things.size(), 2U);
  // edges of a full box
  EXPECT_EQ(samples[1].things[0].box.max(), Eigen::Vector2d(2, 2.5));
  // one pixel
  EXPECT_EQ(samples[1].things[1].box.sizes(), Eigen::Vector2d(1, 1));
}

TEST_F(SampleReader, ReadsBoxesInSpace) {
  writePicture("images/image_0000000.png");
  folder_.write("boxes/boxes_0000000.csv", "label,x,y,z,w,h,l,roll,pitch,yaw\n7,1,2,-3,4,5,6,0.1,0.2,0.3\n");
  const std::vector<Sample> samples = read();
  ASSERT_EQ(samples.size(), 1U);
  const BoxInSpace& box = samples[0].things.at(0).space.value();
  EXPECT_EQ(box.X_CameraBox.position, Vector3(1, 2, -3));
  EXPECT_TRUE(box.X_CameraBox.rotation.isApprox(fromRollPitchYaw(0.1, 0.2, 0.3)));
  EXPECT_EQ(box.size, Vector3(4, 5, 6));
}

TEST_F(SampleReader, ReadsMapsOfLabels) {
  writePicture("images/image_0000000.png", 100);
  writePicture("labels_maps/labels_0000000.png", 7);
  writePicture("colored_maps/colored_0000000.png", 55);
  const std::vector<Sample> samples = read();
  EXPECT_TRUE(found_.all().empty());
  ASSERT_EQ(samples.size(), 1U);
  ASSERT_EQ(samples[0].things.size(), 1U);
  EXPECT_EQ(samples[0].things[0].label, 7);
  EXPECT_EQ(samples[0].things[0].mask->area, 12U);
}

TEST_F(SampleReader, SaysWhichPicturesAreLeftOut) {
  for (const char* number : {"0", "1", "2", "3", "4"})
    writePicture("images/image_000000" + std::string(number) + ".png");
  folder_.write("images/image_0000005.png", "no picture");
  folder_.write("boxes/boxes_0000000.csv", "label,x_center,y_center,width,height\n");
  folder_.write("boxes/boxes_0000001.csv", "");
  folder_.write("boxes/boxes_0000002.csv", "label,x_center,y_center,width,height\n7,1,1,1,1\n7,1,1,1\n");
  folder_.write("boxes/boxes_0000003.csv", "label,x_center,y_center,width,height\n7,1,1,-1,1\n");
  EXPECT_EQ(read().size(), 1U);
  EXPECT_FALSE(found_.hasErrors());
  ASSERT_EQ(found_.all().size(), 5U);
  EXPECT_NE(message(0).find("this is no table of boxes: '"), std::string::npos);
  EXPECT_NE(message(1).find("'7,1,1,1' is no box: '"), std::string::npos);
  EXPECT_EQ(found_.all()[1].position.line, 3);
  EXPECT_NE(message(2).find("'7,1,1,-1,1' is no box: '"), std::string::npos);
  EXPECT_NE(message(3).find("boxes_0000004.csv' is missing: this picture is left out"), std::string::npos);
  EXPECT_NE(message(4).find(": it is left out"), std::string::npos);
}

TEST_F(SampleReader, SaysWhereAMapHasAnotherSize) {
  writePicture("images/image_0000000.png");
  writePicture("labels_maps/labels_0000000.png", 7, 5);
  EXPECT_TRUE(read().empty());
  EXPECT_NE(message(0).find("the map of labels has another size than its picture"), std::string::npos);
}

TEST_F(SampleReader, SaysThatThereAreNone) {
  EXPECT_TRUE(read().empty());
  EXPECT_TRUE(found_.hasErrors());
  // those of an ordinary camera
  writePicture("images/image_0000000.png");
  read();
  EXPECT_TRUE(found_.hasErrors());
}

}  // namespace
}  // namespace pongsim::cli
