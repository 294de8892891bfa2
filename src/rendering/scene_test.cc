#include "rendering/scene.hh"

#include <gtest/gtest.h>

#include <chrono>
#include <cmath>
#include <cstdint>
#include <memory>
#include <stdexcept>
#include <vector>

#include "support/assets/figure_file.hh"
#include "support/rendering/drawn_world.hh"
#include "support/temp_folder.hh"

namespace pongsim::rendering {
namespace {

using test::DrawnWorld;
using test::Pictures;
using test::view;

/// @return The centre of all bright pixels.
Eigen::Vector2d brightPlace(const std::vector<std::uint8_t>& pixels, const PictureView& view) {
  Eigen::Vector2d sum = Eigen::Vector2d::Zero();
  double weight = 0;
  for (std::size_t i = 0; i < pixels.size() / 3; ++i) {
    const double share = pixels[3 * i] / 255.0;
    sum +=
        share * Eigen::Vector2d(static_cast<double>(i % view.width) + 0.5, static_cast<double>(i / view.width) + 0.5);
    weight += share;
  }
  return sum / weight;
}

TEST_F(Pictures, ShowPointsWhereThePinholeProjectsThem) {
  // a shifted pinhole with sheared pixels that are not square
  PictureView eye = view(160, 120, 100);
  eye.fy = 120;
  eye.cx = 70;
  eye.cy = 66;
  eye.skew = 8;
  eye.X_WorldEye = {{1, 2, 3}, fromRollPitchYaw(0.1, 0.2, 0.7)};
  for (const Vector3& place : {Vector3(4, 0, 0), Vector3(5, 1, 0.5), Vector3(3, -0.8, -0.9), Vector3(7, 1.9, -2)}) {
    DrawnWorld world;
    world.addShining(description::Sphere{0.12}, eye.X_WorldEye * place, {1, 1, 1, 1});
    world.start();
    const Eigen::Vector2d found = brightPlace(world.colors(eye), eye);
    EXPECT_NEAR(found.x(), eye.cx - (eye.fx * place.y() + eye.skew * place.z()) / place.x(), 0.3);
    EXPECT_NEAR(found.y(), eye.cy - eye.fy * place.z() / place.x(), 0.3);
  }
}

TEST_F(Pictures, ShowActorsWhereTheyGo) {
  DrawnWorld world;
  description::Actor& actor = world.description().actors.emplace_back();
  actor.name = "a";
  actor.visuals.emplace_back().geometry = description::Box{{1, 1, 1}};
  actor.trajectories.emplace_back().waypoints = {{0, {{3, 0, 0}, Quaternion::Identity()}},
                                                 {2, {{5, 0, 0}, Quaternion::Identity()}}};
  world.start();
  const PictureView eye = view(9, 9, 5);
  EXPECT_NEAR(world.depths(eye)[40], 2.5, 1e-5);
  world.letPass(std::chrono::seconds(2));
  EXPECT_NEAR(world.depths(eye)[40], 4.5, 1e-5);
  EXPECT_TRUE(world.scene().actorBounds("a").center().isApprox(Vector3(5, 0, 0), 1e-5));
  EXPECT_TRUE(world.scene().actorBounds("b").isEmpty());
}

TEST_F(Pictures, ShowTheHandsOfActorsWhereTheirSkeletonsSay) {
  const pongsim::test::TempFolder folder;
  DrawnWorld world;
  description::Actor& actor = world.description().actors.emplace_back();
  actor.name = "a";
  actor.skin = {"skin.dae", folder.write("skin.dae", pongsim::test::FigureFile{.moves = false}.text())};
  actor.animations.push_back({"walk", {"walk.dae", folder.write("walk.dae", pongsim::test::FigureFile().text())}});
  const Pose place{{5, 0, 0}, Quaternion::Identity()};
  actor.trajectories.push_back({.id = 0, .type = "walk", .waypoints = {{0, place}, {1, place}}});
  world.start();
  EXPECT_TRUE(world.warnings().empty());
  const PictureView eye = view(61, 61, 50);
  const auto depthAt = [&](const Vector3& point) {
    const auto column = static_cast<std::size_t>(eye.cx - eye.fx * point.y() / point.x());
    const auto row = static_cast<std::size_t>(eye.cy - eye.fy * point.z() / point.x());
    return world.depths(eye)[row * eye.width + column];
  };
  // the arm turns from upright to the right
  const Vector3 up(5, 0, 1.1), right(5, -0.61, 0.5);
  EXPECT_NEAR(depthAt(up), 5, 1e-4);
  EXPECT_TRUE(std::isinf(depthAt(right)));
  world.letPass(std::chrono::seconds(1));
  EXPECT_NEAR(depthAt(right), 5, 1e-4);
  EXPECT_TRUE(std::isinf(depthAt(up)));
  EXPECT_NEAR(world.scene().actorBounds("a").min().y(), -0.7, 1e-5);
}

TEST_F(Pictures, ShowConesWithTheTipUp) {
  DrawnWorld world;
  world.addShining(description::Cone{1, 2}, {5, 0, 0}, {});
  world.start();
  const std::vector<float> depths = world.depths(view(9, 9, 10));
  // the middle row, and those above and below, on lines z = x / 10 and z = -x / 10: x = 5 - (1 - z) / 2
  EXPECT_NEAR(depths[40], 4.5, 1e-4);
  EXPECT_NEAR(depths[31], 4.5 / 0.95, 1e-4);
  EXPECT_NEAR(depths[49], 4.5 / 1.05, 1e-4);
}

TEST_F(Pictures, MeasureDepthAlongTheLineOfSight) {
  // also far from the world's origin
  for (const Vector3& away : {Vector3(0, 0, 0), Vector3(20'000, -10'000, 50)}) {
    DrawnWorld world;
    world.addShining(description::Box{{2, 40, 40}}, away + Vector3(6, 0, 0), {});
    world.addShining(description::Sphere{1}, away + Vector3(3, 0, 0), {});
    world.start();
    PictureView eye = view(64, 48, 20);
    eye.X_WorldEye.position = away;
    const std::vector<float> depths = world.depths(eye);
    for (std::uint32_t row = 0; row < eye.height; ++row) {
      for (std::uint32_t column = 0; column < eye.width; ++column) {
        // 3 / length - sqrt(...) along the ray, for the ball
        const Vector3 ray = Vector3(1, (eye.cx - column - 0.5) / eye.fx, (eye.cy - row - 0.5) / eye.fy).normalized();
        const double nearest = 3 * ray.x(), aside = 9 - nearest * nearest;
        const float depth = depths[row * eye.width + column];
        if (aside < 0.9) {
          // where the ball is steep, corners that are moved by a sixteenth of a pixel show
          EXPECT_NEAR(depth, (nearest - std::sqrt(1 - aside)) * ray.x(), 0.012) << row << ' ' << column;
        } else if (aside > 1.02) {
          EXPECT_NEAR(depth, 5, 1e-4) << row << ' ' << column;
        }
      }
    }
  }
}

TEST_F(Pictures, SeeNothingNearerOrFartherThanTheyMay) {
  DrawnWorld world;
  world.addShining(description::Box{{1, 1, 1}}, {1, 0, 0}, {});
  world.addShining(description::Box{{1, 40, 40}}, {10, 0, 0}, {});
  world.start();
  PictureView eye = view(9, 9, 9);
  eye.near = 2;
  EXPECT_NEAR(world.depths(eye)[40], 9.5, 1e-5);
  eye.far = 9;
  EXPECT_EQ(world.depths(eye)[40], INFINITY);
}

TEST_F(Pictures, SeeOutsidesOnlyUnlessTheMaterialHasTwo) {
  for (const bool isDoubleSided : {false, true}) {
    DrawnWorld world;
    world.addShining(description::Sphere{2}, {0, 0, 0}, {}).material->isDoubleSided = isDoubleSided;
    world.start();
    EXPECT_EQ(std::isfinite(world.depths(view(9, 9, 9))[40]), isDoubleSided);
  }
}

TEST_F(Pictures, SeeWhatTheirMaskSharesABitWith) {
  DrawnWorld world;
  world.addShining(description::Box{{1, 40, 40}}, {10, 0, 0}, {}).visibilityFlags = 4;
  world.start();
  PictureView eye = view(9, 9, 9);
  eye.visibilityMask = 6;
  EXPECT_NEAR(world.depths(eye)[40], 9.5, 1e-5);
  eye.visibilityMask = 3;
  EXPECT_EQ(world.depths(eye)[40], INFINITY);
}

/// A white ground lit from above, with a plate 1 m above it.
std::unique_ptr<DrawnWorld> litWorld(description::LightType type, bool castsShadows) {
  auto world = std::make_unique<DrawnWorld>();
  auto& ground = *world->addShining(description::Plane{Vector3::UnitZ(), {20, 20}}, {0, 0, 0}, {}).material;
  ground.isLit = true;
  ground.diffuse = {1, 1, 1, 1};
  auto& plate = *world->addShining(description::Box{{1, 1, 0.1}}, {0, 0, 1}, {}).material;
  plate.isLit = true;
  plate.diffuse = {1, 1, 1, 1};
  world->description().scene.ambient = {0, 0, 0, 1};
  description::Light& light = world->description().lights.emplace_back();
  light.name = "lamp";
  light.type = type;
  light.castsShadows = castsShadows;
  light.X_ParentLight.position = {0, 0, 4};
  light.linearAttenuation = 0;
  light.outerAngle = 1.2;
  light.innerAngle = 1.1;
  return world;
}

TEST_F(Pictures, ShowShadowsOfParallelLightAndSpots) {
  for (const auto type : {description::LightType::kDirectional, description::LightType::kSpot}) {
    for (const bool castsShadows : {true, false}) {
      const std::unique_ptr<DrawnWorld> world = litWorld(type, castsShadows);
      world->start();
      // seen from the side, on the ground below the plate and beside its shadow
      PictureView eye = view(41, 41, 41);
      eye.X_WorldEye = {{-2, 0, 0.4}, fromRollPitchYaw(0, std::atan2(0.4, 2), 0)};
      const int below = world->colors(eye)[3 * (20 * 41 + 20)];
      eye.X_WorldEye.position.y() = 1.3;
      const int beside = world->colors(eye)[3 * (20 * 41 + 20)];
      // on top of the plate, which casts no shadow on itself
      eye.X_WorldEye = {{-2, 0, 2.5}, fromRollPitchYaw(0, std::atan2(1.45, 2), 0)};
      EXPECT_GT(world->colors(eye)[3 * (20 * 41 + 20)], 150);
      EXPECT_GT(beside, 150);
      if (castsShadows) {
        EXPECT_LT(below, 60);
      } else {
        EXPECT_GT(below, 150);
      }
    }
  }
}

TEST_F(Pictures, AreDarkOutsideOfASpot) {
  const std::unique_ptr<DrawnWorld> world = litWorld(description::LightType::kSpot, true);
  world->start();
  PictureView eye = view(41, 41, 41);
  eye.X_WorldEye = {{6, 0, 2}, fromRollPitchYaw(0, 1.5, 0)};
  EXPECT_LT(world->colors(eye)[3 * (20 * 41 + 20)], 20);
}

TEST_F(Pictures, AreTheSameBitsEachTime) {
  const auto draw = [](bool drawsOthersBefore) {
    const std::unique_ptr<DrawnWorld> world = litWorld(description::LightType::kDirectional, true);
    world->start();
    PictureView eye = view(160, 120, 100);
    if (drawsOthersBefore) world->depths(eye);
    eye.X_WorldEye = {{-3, 0.3, 1.8}, fromRollPitchYaw(0.05, 0.5, 0)};
    if (drawsOthersBefore) world->colors(view(33, 21, 20));
    return world->colors(eye);
  };
  const auto first = draw(false);
  EXPECT_EQ(first, draw(false));
  EXPECT_EQ(first, draw(true));
}

TEST_F(Pictures, ShowWhereThingsHaveMovedTo) {
  DrawnWorld world;
  world.addShining(description::Box{{1, 1, 1}}, {5, 0, 0}, {});
  world.start();
  EXPECT_NEAR(world.depths(view(9, 9, 9))[40], 4.5, 1e-5);
  world.move(0, {7, 0, 0});
  EXPECT_NEAR(world.depths(view(9, 9, 9))[40], 6.5, 1e-5);
}

TEST_F(Pictures, ShowVisualsInTheirPresentColors) {
  DrawnWorld world;
  for (const double y : {-1.0, 1.0}) {
    description::Visual& visual = world.addShining(description::Box{{1, 1, 1}}, {5, y, 0}, {});
    visual.material->diffuse = {0.5F, 0.25F, 0, 1};
    visual.material->ambient = {0, 0, 0.25F, 1};
  }
  world.start();
  const auto paintOf = [&](std::size_t item) -> const Paint& { return world.scene().items()[item].paint; };
  const Eigen::Vector3f diffuse = paintOf(0).diffuse, ambient = paintOf(0).ambient, color(0, 1, 0.5F);
  const Eigen::Vector3f emissive = paintOf(0).emissive, specular = paintOf(0).specular;
  world.paint({{world.scene().items()[1].id, {.diffuse = Vector3(0, 1, 0.5)}}});
  EXPECT_EQ(paintOf(1).diffuse, color);
  EXPECT_EQ(paintOf(1).ambient, color);
  EXPECT_EQ(paintOf(0).diffuse, diffuse);
  EXPECT_EQ(paintOf(1).emissive, emissive);
  world.paint({{world.scene().items()[1].id,
                {.ambient = Vector3(1, 0, 0), .specular = Vector3(0, 0, 1), .emissive = Vector3(0, 1, 0.5)}}});
  EXPECT_EQ(paintOf(1).diffuse, diffuse);
  EXPECT_EQ(paintOf(1).ambient, Eigen::Vector3f(1, 0, 0));
  EXPECT_EQ(paintOf(1).specular, Eigen::Vector3f(0, 0, 1));
  EXPECT_EQ(paintOf(1).emissive, color);
  world.paint({});
  EXPECT_EQ(paintOf(1).emissive, emissive);
  EXPECT_EQ(paintOf(1).diffuse, diffuse);
  EXPECT_EQ(paintOf(1).ambient, ambient);
  EXPECT_EQ(paintOf(1).specular, specular);
}

TEST_F(Pictures, TellThatTheirEdgeIsTooLong) {
  DrawnWorld world;
  world.start();
  EXPECT_THROW(world.depths(view(60'000, 1, 9)), std::runtime_error);
}

}  // namespace
}  // namespace pongsim::rendering
