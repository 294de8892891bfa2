#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "pongsim/types.hh"

namespace pongsim::ros2 {

/// Writes elements and attributes, indented and escaped.
class XmlWriter {
 public:
  XmlWriter& open(std::string_view element);
  /// Adds an attribute to the last opened element, before it has content.
  XmlWriter& with(std::string_view attribute, std::string_view value);
  /// Numbers are written so that they read as the same bits; an infinite or NaN value becomes 1e9 with its sign, the
  /// largest value that URDF readers handle sensibly.
  XmlWriter& with(std::string_view attribute, double value);
  XmlWriter& with(std::string_view attribute, const Vector3& vector);
  XmlWriter& close();
  /// An `<origin>`.
  XmlWriter& origin(const Pose& pose);

  /// @return The whole text, with all elements closed.
  std::string take();

 private:
  std::string text_;
  std::vector<std::string> elements_;
  bool isTagOpen_ = false;
};

/// @return Roll, pitch, yaw [rad] from which `fromRollPitchYaw` reproduces this rotation, to the last bits even at a
/// pitch of 90 degrees. There, `rollPitchYawOf` loses half of the digits, because it takes the arcsine of nearly 1.
Vector3 exactRollPitchYawOf(const Quaternion& rotation);

}  // namespace pongsim::ros2
