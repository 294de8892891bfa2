#include "cli/sdf/inertial_stats.hh"

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdio>

#include "pongsim/types.hh"

namespace pongsim::cli {

namespace {

/// Total of several links, in the model frame.
struct Sum {
  double mass = 0;
  Vector3 center = Vector3::Zero();
  /// About the centre of mass.
  Matrix3 moments = Matrix3::Zero();
};

/// @return The change of `moments` when the reference moves from the centre of mass by this offset (parallel axis
/// theorem).
Matrix3 steiner(double mass, const Vector3& offset) {
  return mass * (offset.squaredNorm() * Matrix3::Identity() - offset * offset.transpose());
}

Sum sumOf(const std::vector<description::Link>& links) {
  Sum sum;
  Vector3 weighted = Vector3::Zero();
  for (const description::Link& link : links) {
    sum.mass += link.inertial.mass;
    weighted += link.inertial.mass * (link.X_ModelLink * link.inertial.X_LinkCom).position;
  }
  if (sum.mass > 0) sum.center = weighted / sum.mass;
  for (const description::Link& link : links) {
    const Pose X_ModelCom = link.X_ModelLink * link.inertial.X_LinkCom;
    const Matrix3 R = X_ModelCom.rotation.toRotationMatrix();
    sum.moments += R * link.inertial.moments * R.transpose();
    sum.moments += steiner(link.inertial.mass, X_ModelCom.position - sum.center);
  }
  return sum;
}

std::string digits(double value) {
  std::array<char, 32> text{};
  std::snprintf(text.data(), text.size(), "%g", value == 0 ? 0 : value);
  return text.data();
}

std::string tableOf(const Matrix3& matrix) {
  std::array<std::string, 9> cells;
  std::size_t width = 0;
  for (std::size_t i = 0; i < cells.size(); ++i) {
    cells[i] = digits(matrix(static_cast<Eigen::Index>(i / 3), static_cast<Eigen::Index>(i % 3)));
    width = std::max(width, cells[i].size());
  }
  std::string text;
  for (std::size_t i = 0; i < cells.size(); ++i) {
    text += cells[i] + std::string(width - cells[i].size() + 2, ' ') + (i % 3 == 2 ? "\n" : "");
  }
  return text;
}

}  // namespace

std::string inertialStats(const description::Model& model) {
  const Sum sum = sumOf(model.links);
  constexpr const char* kLine = "---\n";
  return "Inertial statistics for model: " + model.name + "\n" + kLine +
         "Total mass of the model: " + digits(sum.mass) + "\n" + kLine +
         "Centre of mass in model frame: \nX: " + digits(sum.center.x()) + "\nY: " + digits(sum.center.y()) +
         "\nZ: " + digits(sum.center.z()) + "\n" + kLine + "Moment of inertia matrix: \n" + tableOf(sum.moments) +
         kLine;
}

}  // namespace pongsim::cli
