#include "cli/dataset/kitti.hh"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>

namespace pongsim::cli {

namespace {

/// A line of a label file.
struct KittiLine {
  /// Share of the projection that is beyond the picture; -1: unknown.
  double truncated = -1;
  double alpha = -10;
  /// Indices of pixels, the last ones included.
  Eigen::AlignedBox2d box;
  /// Height, width, length [m].
  Vector3 size = Vector3::Constant(-1);
  /// Of the middle of the lower side, in the camera's frame: x to the right, y down, z ahead [m].
  Vector3 location = Vector3::Constant(-1000);
  /// From the camera's x axis to the length, around y [rad].
  double rotation = -10;
};

/// From renderers' frame (y up, z backwards) to KITTI's.
Vector3 inKitti(const Vector3& p) { return {p.x(), -p.y(), -p.z()}; }

/// KITTI's boxes stand upright: their height is the side that is nearest to the camera's vertical, their length the
/// first other one.
void placeUpright(const BoxInSpace& box, KittiLine& line) {
  const Matrix3 axes = box.X_CameraBox.rotation.toRotationMatrix();
  Eigen::Index up = 0;
  axes.row(1).cwiseAbs().maxCoeff(&up);
  const Eigen::Index ahead = up == 0 ? 1 : 0, aside = 3 - up - ahead;
  line.size = {box.size[up], box.size[aside], box.size[ahead]};
  line.location = inKitti(box.X_CameraBox.position) + Vector3(0, box.size[up] / 2, 0);
  const Vector3 direction = inKitti(axes.col(ahead));
  line.rotation = std::atan2(-direction.z(), direction.x());
  line.alpha = std::remainder(line.rotation - std::atan2(line.location.x(), line.location.z()), 2 * M_PI);
}

/// @return The box around its projection, not cut at the picture's edges; empty if all of it is behind the camera.
Eigen::AlignedBox2d projectionOf(const BoxInSpace& box, const Sample& sample, double focalLength) {
  // what is beside or behind the camera is projected as if it were this far ahead [m]
  constexpr double kNearest = 0.01;
  Eigen::AlignedBox2d projection;
  bool isAhead = false;
  const Eigen::Vector2d centre(static_cast<double>(sample.width) / 2, static_cast<double>(sample.height) / 2);
  for (int corner = 0; corner < 8; ++corner) {
    const Vector3 side((corner & 1) - 0.5, (corner >> 1 & 1) - 0.5, (corner >> 2 & 1) - 0.5);
    const Vector3 place = inKitti(box.X_CameraBox * Vector3(side.cwiseProduct(box.size)));
    isAhead = isAhead || place.z() > kNearest;
    projection.extend(Eigen::Vector2d(centre + focalLength * place.head<2>() / std::max(place.z(), kNearest)));
  }
  return isAhead ? projection : Eigen::AlignedBox2d();
}

/// Cuts a projection at the picture's edges.
void setBox(const Eigen::AlignedBox2d& projection, const Sample& sample, KittiLine& line) {
  const Eigen::AlignedBox2d picture(
      Eigen::Vector2d::Zero(), Eigen::Vector2d(static_cast<double>(sample.width), static_cast<double>(sample.height)));
  const Eigen::AlignedBox2d seen = projection.intersection(picture);
  const double whole = projection.isEmpty() ? 0 : projection.volume();
  line.truncated = whole > 0 && !seen.isEmpty() ? 1 - seen.volume() / whole : 0;
  line.box = seen;
}

std::string textOfLine(const KittiLine& line, const std::string& name) {
  // unknown how far it is hidden
  constexpr int kOcclusionUnknown = 3;
  std::array<char, 256> numbers{};
  std::snprintf(numbers.data(), numbers.size(),
                " %.2f %d %.2f %.2f %.2f %.2f %.2f %.2f %.2f %.2f %.2f %.2f %.2f %.2f\n", line.truncated,
                kOcclusionUnknown, line.alpha, line.box.min().x(), line.box.min().y(), line.box.max().x() - 1,
                line.box.max().y() - 1, line.size.x(), line.size.y(), line.size.z(), line.location.x(),
                line.location.y(), line.location.z(), line.rotation);
  // the fields are separated by spaces
  std::string word = name;
  std::ranges::replace_if(
      word, [](unsigned char letter) { return letter <= ' '; }, '_');
  return word + numbers.data();
}

}  // namespace

std::string kittiLabels(const Sample& sample, double focalLength, const LabelNames& names) {
  std::string text;
  for (const LabelledThing& thing : sample.things) {
    KittiLine line;
    line.box = thing.box;
    if (thing.space) {
      placeUpright(*thing.space, line);
      setBox(projectionOf(*thing.space, sample, focalLength), sample, line);
      if (line.box.isEmpty()) continue;
    }
    text += textOfLine(line, nameOf(thing.label, names));
  }
  return text;
}

std::string kittiCalibration(const Sample& sample, double focalLength) {
  std::array<char, 256> numbers{};
  std::snprintf(numbers.data(), numbers.size(), ": %.12e 0 %.12e 0 0 %.12e %.12e 0 0 0 1 0\n", focalLength,
                static_cast<double>(sample.width) / 2, focalLength, static_cast<double>(sample.height) / 2);
  std::string text;
  // one camera stands for all four, as with KITTI's rectified images
  for (const char* camera : {"P0", "P1", "P2", "P3"}) text += std::string(camera) + numbers.data();
  text += "R0_rect: 1 0 0 0 1 0 0 0 1\n";
  for (const char* lidar : {"Tr_velo_to_cam", "Tr_imu_to_velo"}) {
    text += std::string(lidar) + ": 1 0 0 0 0 1 0 0 0 0 1 0\n";
  }
  return text;
}

}  // namespace pongsim::cli
