#include "sdf/readers/models/inertial_reader.hh"

#include <Eigen/Eigenvalues>
#include <algorithm>
#include <string>
#include <string_view>

#include "sdf/text/values.hh"

namespace pongsim::sdf {

namespace {

/// Allowed error of a tensor relative to its trace, for files with rounded numbers.
constexpr double kTolerance = 1e-4;

bool isPositiveDefinite(const Matrix3& m) {
  return m(0, 0) > 0 && m(0, 0) * m(1, 1) - m(0, 1) * m(1, 0) > 0 && m.determinant() > 0;
}

/// @return Whether no principal moment exceeds the sum of the other two, as holds for every body.
bool fulfilsTriangleInequality(const Matrix3& moments) {
  // Second moments of the mass distribution, trace / 2 - I, which can't be negative.
  const double trace = moments.trace();
  return isPositiveDefinite((trace / 2 + trace * kTolerance) * Matrix3::Identity() - moments);
}

/// Square of the radius of gyration [m^2] of a body that is a point or a thin rod in the file: of a body of 1 mm.
constexpr double kLeastRadiusSquared = 1e-6;

/// Gives the principal moments that are zero, which no motion can have, the smallest that a body of this mass has.
/// @return False, with nothing changed, if a moment is negative.
bool raiseZeroMoments(description::Inertial& inertial) {
  const Eigen::SelfAdjointEigenSolver<Matrix3> solver(inertial.moments);
  const Vector3 moments = solver.eigenvalues();
  if (moments.minCoeff() < -kTolerance * moments.maxCoeff()) return false;
  const double least = kLeastRadiusSquared * std::max(inertial.mass, moments.maxCoeff());
  if (inertial.moments.isDiagonal(0)) {
    for (int i = 0; i < 3; ++i) inertial.moments(i, i) = std::max(inertial.moments(i, i), least);
    return true;
  }
  const Matrix3 axes = solver.eigenvectors();
  inertial.moments = axes * moments.cwiseMax(least).asDiagonal() * axes.transpose();
  return true;
}

Matrix3 readMoments(const Element& inertia, Context& context) {
  Matrix3 moments;
  const auto at = [&](std::string_view name, double fallback) { return readNumber(inertia, name, fallback, context); };
  const double xx = at("ixx", 1), yy = at("iyy", 1), zz = at("izz", 1);
  const double xy = at("ixy", 0), xz = at("ixz", 0), yz = at("iyz", 0);
  moments << xx, xy, xz, xy, yy, yz, xz, yz, zz;
  return moments;
}

// rows and columns of <fluid_added_mass>
constexpr std::string_view kDirections = "xyzpqr";

/// Reads the added mass of an inertia without one. What no body can have is left out.
void readAddedMass(const Element& element, const std::string& owner, description::Inertial& inertial,
                   Context& context) {
  description::AddedMass added;
  for (int row = 0; row < 6; ++row) {
    for (int column = row; column < 6; ++column) {
      const std::string name = {kDirections[static_cast<std::size_t>(row)],
                                kDirections[static_cast<std::size_t>(column)]};
      added(row, column) = added(column, row) = readNumber(element, name, 0, context);
    }
  }
  if (added.isZero(0)) return;
  if (added.cwiseAbs().maxCoeff() <= kLargestMass &&
      description::isPossible(added, inertial.mass, inertial.X_LinkCom, inertial.moments)) {
    inertial.addedMass = added;
    return;
  }
  context.diagnostics.warning(element.position, "the <fluid_added_mass> of " + owner + " is left out",
                              "with mass and inertia, its matrix must be positive definite, and no element be beyond "
                              "1e30");
}

/// Reads `<inertia>` into it.
void readInertia(const Element& inertia, const std::string& owner, bool isStatic, description::Inertial& inertial,
                 Context& context) {
  inertial.moments = readMoments(inertia, context);
  if (isStatic) return;
  // scaled by the largest moment, so that the tolerance is relative and nothing overflows
  const double largest = inertial.moments.cwiseAbs().maxCoeff();
  const Matrix3 scaled = largest > 0 ? Matrix3(inertial.moments / largest) : inertial.moments;
  const bool isPoint = largest == 0;
  if (!isPositiveDefinite(scaled)) {
    if (!raiseZeroMoments(inertial)) {
      context.diagnostics.error(inertia.position, "the inertia of " + owner + " is not positive definite",
                                "ixx, iyy and izz must be above zero, and ixy, ixz and iyz small enough");
    } else if (isPoint) {
      context.diagnostics.warning(inertia.position,
                                  "the inertia of " + owner + " is zero: that of a body of 1 mm is used");
    }
  } else if (!fulfilsTriangleInequality(scaled)) {
    context.diagnostics.warning(inertia.position, "the inertia of " + owner + " is impossible",
                                "no principal moment can exceed the sum of the other two");
  }
}

}  // namespace

description::Inertial readInertial(const Element& link, const std::string& owner, bool isStatic, Context& context) {
  description::Inertial inertial;
  const Element* element = link.child("inertial");
  if (element == nullptr) return inertial;
  inertial.mass = isStatic ? readNumber(*element, "mass", inertial.mass, context)
                           : readPositive(*element, "mass", inertial.mass, context);

  if (!isStatic && inertial.mass > kLargestMass) {
    context.diagnostics.error(element->child("mass")->position, "the <mass> of " + owner + " is beyond 1e30 kg");
  }

  inertial.X_LinkCom = readPose(*element, context).value;

  if (const Element* inertia = element->child("inertia")) readInertia(*inertia, owner, isStatic, inertial, context);
  const Element* added = element->child("fluid_added_mass");
  if (added != nullptr && !isStatic) readAddedMass(*added, owner, inertial, context);
  return inertial;
}

}  // namespace pongsim::sdf
