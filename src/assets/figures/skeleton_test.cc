#include "assets/figures/skeleton.hh"

#include <gtest/gtest.h>

#include <optional>
#include <string>
#include <variant>

#include "support/assets/figure_file.hh"
#include "support/temp_folder.hh"

namespace pongsim::assets {
namespace {

class SkeletonFile : public testing::Test {
 protected:
  std::variant<std::optional<Skeleton>, Problem> read(const std::string& text) {
    return readSkeleton(folder_.write("f.dae", text));
  }

  /// @return Why a figure's file with a change is refused.
  std::string refusal(const std::string& part, const std::string& instead) {
    std::string text = test::FigureFile().text();
    const std::size_t at = text.find(part);
    EXPECT_NE(at, std::string::npos) << part;
    const auto result = read(text.replace(at, part.size(), instead));
    const auto* problem = std::get_if<Problem>(&result);
    return problem == nullptr
               ? ""
               : problem->hint.substr(problem->hint.starts_with("line") ? problem->hint.find(": ") + 2 : 0);
  }

  test::TempFolder folder_;
};

TEST_F(SkeletonFile, IsReadWhole) {
  const auto result = read(test::FigureFile().text());
  ASSERT_TRUE(std::holds_alternative<std::optional<Skeleton>>(result)) << std::get<Problem>(result).hint;
  const Skeleton& skeleton = *std::get<0>(result);
  ASSERT_EQ(skeleton.bones.size(), 2U);
  EXPECT_EQ(skeleton.bones[0].name, "hips");
  EXPECT_EQ(skeleton.bones[1].name, "arm");
  EXPECT_EQ(skeleton.bones[1].parent, 0U);
  EXPECT_EQ(skeleton.bones[1].X_ParentBone.translation(), Vector3(0, 0, 0.5));
  ASSERT_EQ(skeleton.joints.size(), 2U);
  EXPECT_EQ(skeleton.joints[1].M_BoneFile.translation(), Vector3(0, 0, -1.4));
  ASSERT_EQ(skeleton.vertices.size(), 8U);
  EXPECT_EQ(skeleton.vertices[7].position, Vector3(0, -0.1, 2.1));
  ASSERT_EQ(skeleton.vertices[7].influences.size(), 1U);
  EXPECT_EQ(skeleton.vertices[7].influences[0].joint, 1U);
  EXPECT_EQ(skeleton.vertices[7].influences[0].weight, 1);
  EXPECT_EQ(skeleton.motion.length(), 1);
  EXPECT_EQ(skeleton.motion.tracks.at("hips").lastX(), 2);
}

TEST_F(SkeletonFile, MayHaveNone) {
  const auto result = read(test::FigureFile{.isSkin = false, .moves = false}.text());
  EXPECT_EQ(std::get<0>(result).has_value(), false);
}

TEST_F(SkeletonFile, MayMoveSingleNumbers) {
  std::string text = test::FigureFile().text();
  const std::string channel = "target=\"hips_id/transform\"";
  text.replace(text.find(channel), channel.size(), "target=\"hips_id/transform(1)(3)\"");
  const auto result = read(text);
  const Track& hips = std::get<0>(result)->motion.tracks.at("hips");
  EXPECT_EQ(hips.at(0).position, Vector3(0, 1, 0.9));
}

TEST_F(SkeletonFile, SaysWhatIsWrong) {
  EXPECT_EQ(refusal("skin source=\"#g\"", "skin source=\"#h\""), "<skin> has a source that is not there");
  EXPECT_EQ(refusal("<skeleton>#hips_id", "<skeleton>#no"), "<skeleton> names a node that is not there");
  EXPECT_EQ(refusal(">hips arm<", ">hips leg<"), "<skin> has the joint 'leg', which its skeleton lacks");
  EXPECT_EQ(refusal(">1 0.5<", ">1 x<"), "<float_array> contains what is no finite number");
  EXPECT_EQ(refusal("<v>0 0 ", "<v>7 0 "), "<vertex_weights> refers to a joint or a weight that is not there");
  EXPECT_EQ(refusal("0 0 1 -1.4 0 0 0 1<", "0 0 1 -1.4 0<"), "<float_array> has fewer matrices than there are joints");
  EXPECT_EQ(refusal("<vcount>1 ", "<vcount>9 "), "<vertex_weights> has fewer weights than it counts");
  EXPECT_EQ(refusal("hips_id/transform", "hips_id/transform(99)"), "<channel> has a target that can't be read");
  EXPECT_EQ(refusal("<unit meter=\"1\"/></asset>", "<unit meter=\"1\"></asset>"), "the XML is not well-formed");
}

}  // namespace
}  // namespace pongsim::assets
