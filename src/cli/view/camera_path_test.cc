#include "cli/view/camera_path.hh"

#include <gtest/gtest.h>

#include <numbers>
#include <optional>

#include "support/cli/still_sight.hh"

namespace pongsim::cli {
namespace {

/// A model that is moved.
class MovedModel final : public test::StillSight {
 public:
  std::optional<Vector3> position(const std::string& name) override { return name == "robot" ? place : std::nullopt; }
  std::optional<Vector3> place = Vector3(1, 2, 0);
};

void expectAt(const Pose& pose, const Vector3& position, double yaw) {
  EXPECT_TRUE(pose.position.isApprox(position)) << pose.position.transpose();
  EXPECT_TRUE(pose.rotation.toRotationMatrix().isApprox(fromRollPitchYaw(0, 0.3, yaw).toRotationMatrix(), 1e-9));
}

const Pose kStart{{-3, 0, 2}, fromRollPitchYaw(0, 0.3, 0)};

TEST(CameraPath, StandsStill) {
  MovedModel sight;
  CameraPath path(sight, kStart, "", std::nullopt);
  sight.place = Vector3(5, 5, 5);
  expectAt(path.at(0.5), kStart.position, 0);
}

TEST(CameraPath, MovesWithAModel) {
  MovedModel sight;
  CameraPath path(sight, kStart, "robot", std::nullopt);
  expectAt(path.at(0), {-3, 0, 2}, 0);
  sight.place = Vector3(2, 2, 0.5);
  expectAt(path.at(0.1), {-2, 0, 2.5}, 0);
  sight.place = std::nullopt;
  expectAt(path.at(0.2), {-2, 0, 2.5}, 0);
}

TEST(CameraPath, TurnsOnceAnticlockwise) {
  MovedModel sight;
  CameraPath path(sight, kStart, "", Vector3(1, 0, 0));
  expectAt(path.at(0), {-3, 0, 2}, 0);
  expectAt(path.at(0.25), {1, -4, 2}, std::numbers::pi / 2);
  expectAt(path.at(0.5), {5, 0, 2}, std::numbers::pi);
  expectAt(path.at(1), {-3, 0, 2}, 0);
}

TEST(CameraPath, TurnsAroundWhatMoves) {
  MovedModel sight;
  CameraPath path(sight, kStart, "robot", Vector3(1, 0, 0));
  sight.place = Vector3(1, 12, 0);
  expectAt(path.at(0.5), {5, 10, 2}, std::numbers::pi);
}

}  // namespace
}  // namespace pongsim::cli
