#include "description/joint.hh"

namespace pongsim::description {

std::string_view name(JointType type) {
  switch (type) {
    case JointType::kRevolute:
      return "revolute";
    case JointType::kContinuous:
      return "continuous";
    case JointType::kPrismatic:
      return "prismatic";
    case JointType::kBall:
      return "ball";
    case JointType::kFixed:
      return "fixed";
    case JointType::kUniversal:
      return "universal";
    case JointType::kRevolute2:
      return "revolute2";
    case JointType::kScrew:
      return "screw";
    case JointType::kGearbox:
      return "gearbox";
  }
  return "";
}

}  // namespace pongsim::description
