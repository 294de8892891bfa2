#include "pongsim/geometry/rotation_between.hh"

namespace pongsim {

// Compiled once, here: for opposite directions Eigen takes a singular value decomposition, 30 kB of code.
Quaternion rotationBetween(const Vector3& from, const Vector3& to) { return Quaternion::FromTwoVectors(from, to); }

}  // namespace pongsim
