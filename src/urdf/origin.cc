#include "urdf/origin.hh"

#include <optional>
#include <string_view>
#include <vector>

#include "base/parse_number.hh"

namespace pongsim::urdf {

namespace {

Vector3 readVector(const Element& origin, std::string_view name) {
  const std::optional<std::vector<double>> values = base::parseDoubles(origin.attributeOr(name, "0 0 0"));
  return values && values->size() == 3 ? Vector3((*values)[0], (*values)[1], (*values)[2]) : Vector3::Zero();
}

}  // namespace

Pose originOf(const Element& part) {
  const Element* origin = part.child("origin");
  if (origin == nullptr) return {};
  const Vector3 rpy = readVector(*origin, "rpy");
  return {readVector(*origin, "xyz"), fromRollPitchYaw(rpy.x(), rpy.y(), rpy.z())};
}

}  // namespace pongsim::urdf
