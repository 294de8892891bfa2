#include "assets/figures/bvh_motion.hh"

#include <gtest/gtest.h>

#include <numbers>
#include <stdexcept>
#include <string>
#include <vector>

namespace pongsim::assets {
namespace {

/// Hips at 0.9 m, with an arm 0.5 m above them.
Skeleton skinWithArm() {
  Skeleton skin;
  skin.bones.push_back({"hips", 0, Eigen::Affine3d(Eigen::Translation3d(0, 0, 0.9))});
  skin.bones.push_back({"arm", 0, Eigen::Affine3d(Eigen::Translation3d(0, 0, 0.5))});
  return skin;
}

/// @param offset Of the arm.
/// @param frames Six numbers for the hips, then three for the arm about z, x and y.
std::string fileWith(const std::string& offset, const std::string& frames, const std::string& count = "1") {
  return "HIERARCHY\nROOT Pelvis\n{\n  OFFSET 0 0 0.9\n  CHANNELS 6 Xposition Yposition Zposition Zrotation Xrotation "
         "Yrotation\n  JOINT Arm\n  {\n    OFFSET " +
         offset +
         "\n    CHANNELS 3 Zrotation Xrotation Yrotation\n    End Site\n    {\n      OFFSET 0 0 1\n    }\n  }\n}\n"
         "MOTION\nFrames: " +
         count + "\nFrame Time: 0.04\n" + frames;
}

void expectPose(const Pose& pose, const Vector3& position, const Quaternion& rotation) {
  EXPECT_LT((pose.position - position).norm(), 1e-12) << pose.position.transpose();
  EXPECT_LT(pose.rotation.angularDistance(rotation), 1e-7);
}

const Quaternion kX = fromRollPitchYaw(std::numbers::pi / 2, 0, 0), kY = fromRollPitchYaw(0, std::numbers::pi / 2, 0),
                 kZ = fromRollPitchYaw(0, 0, std::numbers::pi / 2);

TEST(BvhMotion, HasTheFramesAtTheirTimes) {
  const Motion motion =
      bvhMotion(fileWith("0 0 0.5", "1 2 3 0 0 0 0 0 0\n2 2 3 0 90 0 0 0 90\n", "2"), 1, skinWithArm());
  EXPECT_DOUBLE_EQ(motion.length(), 0.04);
  // by the names of the skin's bones
  ASSERT_EQ(motion.tracks.size(), 2U);
  expectPose(motion.tracks.at("hips").at(0), {1, 2, 3}, Quaternion::Identity());
  expectPose(motion.tracks.at("hips").at(0.04), {2, 2, 3}, kX);
  expectPose(motion.tracks.at("arm").at(0.04), {0, 0, 0.5}, kY);
}

TEST(BvhMotion, TurnsInTheOrderOfTheChannels) {
  const Motion motion = bvhMotion(fileWith("0 0 0.5", "0 0 0 0 0 0 90 90 90"), 1, skinWithArm());
  expectPose(motion.tracks.at("arm").at(0), {0, 0, 0.5}, kZ * kX * kY);
}

TEST(BvhMotion, TurnsBonesUntilTheyRestAsTheSkinsDo) {
  // the file's arm points along y
  const Motion still = bvhMotion(fileWith("0 0.5 0", "0 0 0 0 0 0 0 0 0"), 1, skinWithArm());
  expectPose(still.tracks.at("arm").at(0), {0, 0, 0.5}, Quaternion::Identity());
  // around itself
  const Motion turned = bvhMotion(fileWith("0 0.5 0", "0 0 0 0 0 0 0 0 90"), 1, skinWithArm());
  expectPose(turned.tracks.at("arm").at(0), {0, 0, 0.5}, kZ);
}

TEST(BvhMotion, IsInTheUnitsOfTheSkin) {
  Skeleton skin = skinWithArm();
  skin.unit = 0.5;
  const Motion motion = bvhMotion(fileWith("0 0 50", "100 0 0 0 0 0 0 0 0"), 0.01, skin);
  expectPose(motion.tracks.at("hips").at(0), {2, 0, 0}, Quaternion::Identity());
  expectPose(motion.tracks.at("arm").at(0), {0, 0, 1}, Quaternion::Identity());
}

std::string motionFaultOf(const std::string& content, const Skeleton& skin = skinWithArm()) {
  try {
    bvhMotion(content, 1, skin);
  } catch (const std::runtime_error& fault) {
    return fault.what();
  }
  return "none";
}

TEST(BvhMotion, SaysWhatIsWrong) {
  const std::string good = fileWith("0 0 0.5", "0 0 0 0 0 0 0 0 0");
  const auto with = [&good](const std::string& what, const std::string& other) {
    std::string text = good;
    text.replace(text.find(what), what.size(), other);
    return motionFaultOf(text);
  };
  EXPECT_EQ(motionFaultOf(good), "none");
  EXPECT_EQ(motionFaultOf(""), "line 1: here should be 'HIERARCHY', not ''");
  EXPECT_EQ(with("JOINT", "JOIN"), "line 6: 'JOIN' does not belong into a bone");
  EXPECT_EQ(with("0.9", "nan"), "line 4: 'nan' is no finite number");
  EXPECT_EQ(with("Xposition", "Wposition"), "line 5: 'Wposition' is no channel");
  EXPECT_EQ(with("CHANNELS 3", "CHANNELS 7"), "line 9: this number is not from 0 to 6");
  EXPECT_EQ(with("Frames: 1", "Frames: 1e9"), "line 17: this number is not from 0 to 2222222");
  EXPECT_EQ(with("Frames: 1", "Frames: 2"), "line 19: '' is no finite number");
  EXPECT_EQ(with("0.04", "0"), "line 18: the time of a frame is not above 0");
}

TEST(BvhMotion, SaysWhereItIsOfOtherBones) {
  Skeleton skin = skinWithArm();
  skin.bones.push_back({"hand", 1, Eigen::Affine3d::Identity()});
  const std::string good = fileWith("0 0 0.5", "0 0 0 0 0 0 0 0 0");
  EXPECT_EQ(motionFaultOf(good, skin), "it has 2 bones, the actor's skin 3");
  skin = skinWithArm();
  skin.bones[1].parent = 1;
  EXPECT_EQ(motionFaultOf(good, skin),
            "its bones hang together in another way than those of the actor's skin, at 'hips'");
}

}  // namespace
}  // namespace pongsim::assets
