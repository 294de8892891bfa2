#include "assets/figures/figure.hh"

#include <gtest/gtest.h>

#include <filesystem>
#include <memory>
#include <numbers>
#include <string>
#include <vector>

#include "support/assets/figure_file.hh"
#include "support/temp_folder.hh"

namespace pongsim::assets {
namespace {

class FigureTest : public testing::Test {
 protected:
  /// @param animation Nothing but a name: none.
  std::unique_ptr<Figure> figureOf(const test::FigureFile& skin, const test::FigureFile& animation,
                                   bool followsPath = false) {
    description::Actor actor;
    actor.skin.file = folder_.write("skin.dae", skin.text());
    actor.animations.push_back({"walk", {"walk", folder_.write("walk.dae", animation.text())}, followsPath});
    return load(actor);
  }

  std::unique_ptr<Figure> load(const description::Actor& actor) {
    said_.clear();
    return Figure::load(actor, [this](const std::filesystem::path& file, const Problem& problem) {
      said_.push_back(file.filename().string() + " " + problem.text +
                      (problem.hint.empty() ? "" : " | " + problem.hint));
    });
  }

  /// @return Where a vertex of the file is in a gait.
  static Vector3 placeOf(const Figure& figure, const Vector3& atRest, const Gait& gait) {
    const auto* influences = figure.influencesAt(atRest);
    EXPECT_NE(influences, nullptr);
    if (influences == nullptr) return Vector3::Zero();
    return Figure::blend(*influences, figure.bonesIn(gait)) * atRest;
  }

  static void expectNear(const Vector3& actual, const Vector3& expected) {
    EXPECT_LT((actual - expected).norm(), 1e-9) << actual.transpose() << " instead of " << expected.transpose();
  }

  test::TempFolder folder_;
  std::vector<std::string> said_;
};

const test::FigureFile kStill{.moves = false};
/// A corner of the hand, and where it is at the end of the arm.
const Vector3 kCorner(0, 0.1, 2.1), kCornerOfArm(0, 0.1, 0.7);

/// @param angle Of the arm about x [rad].
Vector3 handAt(double angle, const Vector3& hips = Vector3::Zero()) {
  return hips + Vector3(0, 0, 0.5) + Eigen::AngleAxisd(angle, Vector3::UnitX()) * kCornerOfArm;
}

TEST_F(FigureTest, HasItsHandWhereItsSkeletonSays) {
  const std::unique_ptr<Figure> figure = figureOf(kStill, {});
  ASSERT_NE(figure, nullptr);
  EXPECT_EQ(said_, std::vector<std::string>());
  for (const double time : {0.0, 0.25, 0.5, 1.0}) {
    expectNear(placeOf(*figure, kCorner, {.animation = "walk", .time = time}), handAt(time * std::numbers::pi / 2));
  }
  // the skeleton's root is where the actor is
  expectNear(placeOf(*figure, {0, 0.1, 1}, {.animation = "walk", .time = 0.5}), {0, 0.1, 0.1});
  expectNear(placeOf(*figure, {0, 0.1, 1}, {.animation = "walk", .time = 0.5, .isOnPath = false}), {1, 0.1, 1});
  expectNear(placeOf(*figure, kCorner, {.animation = "walk", .time = 1, .isOnPath = false}),
             handAt(std::numbers::pi / 2, {2, 0, 0.9}));
}

TEST_F(FigureTest, BeginsAgainOrStaysAtTheEnd) {
  const std::unique_ptr<Figure> figure = figureOf(kStill, {});
  ASSERT_NE(figure, nullptr);
  expectNear(placeOf(*figure, kCorner, {.animation = "walk", .time = 2.25}), handAt(std::numbers::pi / 8));
  expectNear(placeOf(*figure, kCorner, {.animation = "walk", .time = 2.25, .loops = false}),
             handAt(std::numbers::pi / 2));
}

TEST_F(FigureTest, StepsAsFarAsItGoesWhereItInterpolatesX) {
  const std::unique_ptr<Figure> figure = figureOf(kStill, {}, true);
  ASSERT_NE(figure, nullptr);
  // 2 m within a second; 5 m are two and a half times that
  for (const double distance : {1.0, 5.0}) {
    expectNear(placeOf(*figure, kCorner, {.animation = "walk", .time = 77, .distance = distance}),
               handAt(std::numbers::pi / 4));
  }
}

TEST_F(FigureTest, MovesByABvhFile) {
  description::Actor actor;
  actor.skin.file = folder_.write("skin.dae", kStill.text());
  // in centimetres
  const auto walk = folder_.write("walk.bvh",
                                  "HIERARCHY\nROOT Hip\n{\nOFFSET 0 0 90\nCHANNELS 6 Xposition Yposition Zposition "
                                  "Zrotation Xrotation Yrotation\nJOINT Elbow\n{\nOFFSET 0 0 50\nCHANNELS 3 Zrotation "
                                  "Xrotation Yrotation\nEnd Site\n{\nOFFSET 0 0 60\n}\n}\n}\nMOTION\nFrames: 2\n"
                                  "Frame Time: 1\n0 0 90 0 0 0 0 0 0\n200 0 90 0 0 0 0 90 0\n");
  actor.animations.push_back({"walk", {"walk", walk, 0.01}, true});
  const std::unique_ptr<Figure> figure = load(actor);
  EXPECT_EQ(said_, std::vector<std::string>());
  ASSERT_NE(figure, nullptr);
  for (const double time : {0.0, 0.25, 0.5, 1.0}) {
    expectNear(placeOf(*figure, kCorner, {.animation = "walk", .time = time}), handAt(time * std::numbers::pi / 2));
  }
  // along x, too
  expectNear(placeOf(*figure, kCorner, {.animation = "walk", .time = 77, .distance = 5}), handAt(std::numbers::pi / 4));
  expectNear(placeOf(*figure, kCorner, {.animation = "walk", .time = 1, .isOnPath = false}),
             handAt(std::numbers::pi / 2, {2, 0, 0.9}));
}

TEST_F(FigureTest, HasTheMotionOfItsOwnFileWithoutAnother) {
  description::Actor actor;
  actor.skin.file = folder_.write("skin.dae", test::FigureFile().text());
  const std::unique_ptr<Figure> figure = load(actor);
  ASSERT_NE(figure, nullptr);
  expectNear(placeOf(*figure, kCorner, {.animation = "", .time = 1}), handAt(std::numbers::pi / 2));
  actor.skin.file = folder_.write("skin.dae", kStill.text());
  EXPECT_EQ(load(actor), nullptr);
  EXPECT_EQ(said_, std::vector<std::string>());
}

TEST_F(FigureTest, AppliesTheUnitsOfBothFiles) {
  const std::unique_ptr<Figure> figure = figureOf({.unit = "0.5", .moves = false}, {.unit = "2"});
  ASSERT_NE(figure, nullptr);
  // the file's arm is at 0.5 of 2 m in the animation, its hand at 0.6 of 0.5 m
  expectNear(placeOf(*figure, kCorner / 2, {.animation = "walk", .time = 0}), Vector3(0, 0, 1) + kCornerOfArm / 2);
}

TEST_F(FigureTest, SaysWhatIsWrong) {
  EXPECT_EQ(figureOf({.isSkin = false}, {}), nullptr);
  EXPECT_EQ(said_, std::vector<std::string>{"skin.dae has no skin with a skeleton"});
  EXPECT_EQ(figureOf(kStill, kStill), nullptr);
  EXPECT_EQ(said_, std::vector<std::string>{"walk.dae contains no animation"});
  test::FigureFile other;
  std::string text = other.text();
  for (std::size_t at = text.find("\"hips\""); at != std::string::npos; at = text.find("\"hips\"")) {
    text.replace(at, 6, "\"pelvis\"");
  }
  description::Actor actor;
  actor.skin.file = folder_.write("skin.dae", kStill.text());
  for (std::size_t at = text.find("\"arm\""); at != std::string::npos; at = text.find("\"arm\"")) {
    text.replace(at, 5, "\"wing\"");
  }
  text.replace(text.find(">hips arm<"), 10, ">pelvis wing<");
  actor.animations.push_back({"fly", {"fly", folder_.write("fly.dae", text)}});
  actor.animations.push_back({"run", {"run", folder_.write("run.bvh", "HIERARCHY")}});
  actor.animations.push_back({"run", {"run", folder_.write("run.fbx", "")}});
  EXPECT_EQ(load(actor), nullptr);
  EXPECT_EQ(said_,
            (std::vector<std::string>{
                "fly.dae moves bones that the actor's skin lacks, such as 'pelvis' | those of the skin are 'hips' "
                "and those below it",
                "run.bvh can't move this skin | line 1: here should be 'ROOT', not ''",
                "run.fbx is no Collada file (.dae) | skins are read from these only, animations also from BVH files "
                "(.bvh)"}));
  EXPECT_NE(figureOf(kStill, {}, true), nullptr);
}

}  // namespace
}  // namespace pongsim::assets
