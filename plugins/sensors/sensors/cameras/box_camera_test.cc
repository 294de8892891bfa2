#include <gtest/gtest.h>
#include <ignition/msgs/annotated_axis_aligned_2d_box_v.pb.h>
#include <ignition/msgs/annotated_oriented_3d_box_v.pb.h>
#include <ignition/msgs/camera_info.pb.h>
#include <ignition/msgs/image.pb.h>

#include <cmath>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <string>
#include <vector>

#include "support/camera_world.hh"
#include "support/temp_folder.hh"

namespace pongsim::box_camera_test {
namespace {

using ignition::msgs::Image;
using test::boxOf;
using test::labelled;
using test::RunningWorld;
using test::seenOn;
using test::smallCamera;
using test::thingAt;
using ImageBoxes = ignition::msgs::AnnotatedAxisAligned2DBox_V;
using SpaceBoxes = ignition::msgs::AnnotatedOriented3DBox_V;

class BoxCameras : public test::DrawingTest {};

std::string type(const std::string& name) { return "<box_type>" + name + "</box_type>"; }

/// A cube of 2 m, whose face is 4 m ahead, half hidden by an unlabelled post to the right, 3 m ahead.
std::string halfHidden() {
  return thingAt("cube", "5 0 0", boxOf(2, 2, 2), "", labelled(3)) + thingAt("post", "3.5 -2 0", boxOf(1, 4, 6));
}

void expectBox(const ignition::msgs::AnnotatedAxisAligned2DBox& box, unsigned label, double left, double top,
               double right, double bottom) {
  EXPECT_EQ(box.label(), label);
  EXPECT_NEAR(box.box().min_corner().x(), left, 1e-3);
  EXPECT_NEAR(box.box().min_corner().y(), top, 1e-3);
  EXPECT_NEAR(box.box().max_corner().x(), right, 1e-3);
  EXPECT_NEAR(box.box().max_corner().y(), bottom, 1e-3);
}

TEST_F(BoxCameras, BoundWhatIsSeenToThePixel) {
  // its face is projected from 19 to 45 and from 11 to 37; the post hides what is right of 32
  for (const std::string kind : {"", "2d", "visible_2d", "visible_box_2d"}) {
    const auto boxes =
        seenOn<ImageBoxes>("/cam", smallCamera("boundingbox", kind.empty() ? kind : type(kind)) + halfHidden());
    ASSERT_EQ(boxes.size(), 1U) << kind;
    ASSERT_EQ(boxes[0].annotated_box_size(), 1) << kind;
    // the pixels whose centres are within, from the first to the last
    expectBox(boxes[0].annotated_box(0), 3, 19, 11, 31, 36);
    EXPECT_EQ(boxes[0].header().data(0).value(0), "m::l::s");
  }
}

TEST_F(BoxCameras, BoundAllOfWhatIsPartlySeen) {
  for (const std::string kind : {"full_2d", "full_box_2d"}) {
    const auto boxes =
        seenOn<ImageBoxes>("/cam", smallCamera("boundingbox_camera", type(kind)) + halfHidden() +
                                       thingAt("behind", "30 0 0", boxOf(0.5, 0.5, 0.5), "", labelled(4)));
    ASSERT_EQ(boxes.size(), 1U) << kind;
    // what is wholly hidden has none
    ASSERT_EQ(boxes[0].annotated_box_size(), 1) << kind;
    expectBox(boxes[0].annotated_box(0), 3, 32 - 13, 24 - 13, 32 + 13, 24 + 13);
  }
}

TEST_F(BoxCameras, CutBoxesAtTheImage) {
  // its face is projected from -20 to 6 and from -15 to 11
  const std::string aside = thingAt("cube", "5 3 2", boxOf(2, 2, 2), "", labelled(3));
  const auto boxes = seenOn<ImageBoxes>("/cam", smallCamera("boundingbox", type("full_2d")) + aside);
  ASSERT_EQ(boxes.size(), 1U);
  ASSERT_EQ(boxes[0].annotated_box_size(), 1);
  // the inner side's far edge is 6 m ahead
  expectBox(boxes[0].annotated_box(0), 3, 0, 0, 32 - 52 * 2 / 6.0, 24 - 52 / 6.0);
}

TEST_F(BoxCameras, JoinTheVisualsOfAModel) {
  const std::string visual = "<geometry>" + boxOf(1, 1, 1) + "</geometry></visual>";
  const std::string pair = "<model name='pair'><static>true</static><pose relative_to='m'>5.5 0 0 0 0 0</pose>" +
                           labelled(5) + "<link name='l'><visual name='v'><pose>0 1.5 0 0 0 0</pose>" + visual +
                           "<visual name='w'><pose>0 -1.5 0 0 0 0</pose>" + visual + "</link></model>";
  const auto boxes = seenOn<ImageBoxes>("/cam", smallCamera("boundingbox", type("full_2d")) + pair +
                                                    thingAt("alone", "5.5 0 1.2", boxOf(1, 1, 1), labelled(5)));
  ASSERT_EQ(boxes.size(), 1U);
  ASSERT_EQ(boxes[0].annotated_box_size(), 2);
  // in descending order of names
  expectBox(boxes[0].annotated_box(0), 5, 32 - 20.8, 24 - 5.2, 32 + 20.8, 24 + 5.2);
  EXPECT_NEAR(boxes[0].annotated_box(1).box().max_corner().x(), 32 + 5.2, 1e-3);
  const auto inSpace = seenOn<SpaceBoxes>("/cam", smallCamera("boundingbox", type("3d")) + pair);
  ASSERT_EQ(inSpace.size(), 1U);
  ASSERT_EQ(inSpace[0].annotated_box_size(), 1);
  const auto& size = inSpace[0].annotated_box(0).box().boxsize();
  EXPECT_NEAR(std::max({size.x(), size.y(), size.z()}), 4, 1e-3);
}

TEST_F(BoxCameras, PlaceBoxesInSpace) {
  const std::string turned =
      "<model name='cube'><static>true</static><pose relative_to='m'>5 1 0.5 0 0 0.3</pose><link name='l'>"
      "<visual name='v'><geometry>" +
      boxOf(1, 2, 3) + "</geometry></visual></link>" + labelled(3) + "</model>";
  const auto boxes = seenOn<SpaceBoxes>("/cam", smallCamera("boundingbox_camera", type("3d")) + turned);
  ASSERT_EQ(boxes.size(), 1U);
  ASSERT_EQ(boxes[0].annotated_box_size(), 1);
  const auto& box = boxes[0].annotated_box(0).box();
  EXPECT_EQ(boxes[0].annotated_box(0).label(), 3U);
  // as renderers have it: x to the right, y up, z backwards
  EXPECT_NEAR(box.center().x(), -1, 1e-5);
  EXPECT_NEAR(box.center().y(), 0.5, 1e-5);
  EXPECT_NEAR(box.center().z(), -5, 1e-5);
  EXPECT_NEAR(box.boxsize().x(), 1, 1e-5);
  EXPECT_NEAR(box.boxsize().y(), 2, 1e-5);
  EXPECT_NEAR(box.boxsize().z(), 3, 1e-5);
  const Quaternion rotation(box.orientation().w(), box.orientation().x(), box.orientation().y(), box.orientation().z());
  // the box's axes: ahead and left, turned by 0.3 rad, and up
  EXPECT_TRUE((rotation * Vector3::UnitX()).isApprox(Vector3(-std::sin(0.3), 0, -std::cos(0.3)), 1e-5));
  EXPECT_TRUE((rotation * Vector3::UnitZ()).isApprox(Vector3::UnitY(), 1e-5));
}

TEST_F(BoxCameras, LeaveOutWhatHasNoLabelOrThatOfTheBackground) {
  const auto boxes = seenOn<ImageBoxes>("/cam", smallCamera("boundingbox") + thingAt("a", "5 0 0", boxOf(1, 1, 1)) +
                                                    thingAt("b", "5 1.5 0", boxOf(1, 1, 1), labelled(255)) +
                                                    thingAt("c", "5 -1.5 0", boxOf(1, 1, 1), labelled(0)));
  ASSERT_EQ(boxes.size(), 1U);
  ASSERT_EQ(boxes[0].annotated_box_size(), 1);
  EXPECT_EQ(boxes[0].annotated_box(0).label(), 0U);
}

TEST_F(BoxCameras, DrawBoxesIntoTheirImage) {
  for (const std::string kind : {"full_2d", "3d"}) {
    RunningWorld world(test::kSensorsSystem + smallCamera("boundingbox", type(kind)) + halfHidden());
    std::vector<Image> images;
    std::vector<ignition::msgs::CameraInfo> infos;
    world.listen("/cam_image", images);
    world.listen("/camera_info", infos);
    world.step(1);
    ASSERT_EQ(images.size(), 1U) << kind;
    EXPECT_EQ(infos.size(), 1U);
    EXPECT_EQ(images[0].pixel_format_type(), ignition::msgs::RGB_INT8);
    const auto colorAt = [&](std::size_t column, std::size_t row) {
      return images[0].data().substr(row * images[0].step() + 3 * column, 3);
    };
    const std::string green("\0\xff\0", 3);
    // the upper edge of the face, also where the post hides it
    for (const std::size_t column : {25U, 40U}) {
      // it is between two rows
      EXPECT_TRUE(colorAt(column, 10) == green || colorAt(column, 11) == green) << kind << ' ' << column;
    }
    EXPECT_NE(colorAt(25, 5), green) << kind;
  }
}

TEST_F(BoxCameras, SaveSamples) {
  const test::TempFolder folder;
  const auto save = [&](const std::string& kind) {
    RunningWorld world(test::kSensorsSystem +
                       smallCamera("boundingbox", type(kind) + "<save enabled='true'><path>" +
                                                      (folder.path() / kind).string() + "</path></save>") +
                       halfHidden());
    world.step(2);
    std::ifstream stream(folder.path() / kind / "boxes/boxes_0000001.csv");
    return std::string(std::istreambuf_iterator<char>(stream), {});
  };
  EXPECT_EQ(save("2d"), "label,x_center,y_center,width,height\n3,25.000000,23.500000,12.000000,25.000000\n");
  const std::string inSpace = save("3d");
  EXPECT_TRUE(inSpace.starts_with("label,x,y,z,w,h,l,roll,pitch,yaw\n3,")) << inSpace;
  EXPECT_NE(inSpace.find(",-5.000000,2.000000,2.000000,2.000000,"), std::string::npos) << inSpace;
  EXPECT_TRUE(std::filesystem::exists(folder.path() / "2d/images/image_0000000.png"));
  EXPECT_TRUE(std::filesystem::exists(folder.path() / "3d/images/image_0000001.png"));
}

}  // namespace
}  // namespace pongsim::box_camera_test
