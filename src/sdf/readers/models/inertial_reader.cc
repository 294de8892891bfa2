#include "sdf/readers/models/inertial_reader.hh"

#include "sdf/text/values.hh"

namespace pongsim::sdf {

namespace {

/// Mass of the sun [kg]. The limit keeps squares and products of masses finite.
constexpr double kLargestMass = 1e30;

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

Matrix3 readMoments(const Element& inertia, Context& context) {
  Matrix3 moments;
  const auto at = [&](std::string_view name, double fallback) { return readNumber(inertia, name, fallback, context); };
  const double xx = at("ixx", 1), yy = at("iyy", 1), zz = at("izz", 1);
  const double xy = at("ixy", 0), xz = at("ixz", 0), yz = at("iyz", 0);
  moments << xx, xy, xz, xy, yy, yz, xz, yz, zz;
  return moments;
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

  const Element* inertia = element->child("inertia");
  if (inertia == nullptr) return inertial;
  inertial.moments = readMoments(*inertia, context);
  if (isStatic) return inertial;
  // scaled by the largest moment, so that the tolerance is relative and nothing overflows
  const double largest = inertial.moments.cwiseAbs().maxCoeff();
  const Matrix3 scaled = largest > 0 ? Matrix3(inertial.moments / largest) : inertial.moments;
  if (!isPositiveDefinite(scaled)) {
    context.diagnostics.error(inertia->position, "the inertia of " + owner + " is not positive definite",
                              "ixx, iyy and izz must be above zero, and ixy, ixz and iyz small enough");
  } else if (!fulfilsTriangleInequality(scaled)) {
    context.diagnostics.warning(inertia->position, "the inertia of " + owner + " is impossible",
                                "no principal moment can exceed the sum of the other two");
  }
  return inertial;
}

}  // namespace pongsim::sdf
