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
  /// Adds an attribute to the element that was opened last, before anything is in it.
  XmlWriter& with(std::string_view attribute, std::string_view value);
  /// A number reads as the same bits; one that is not finite is written as the largest of its sign that URDF's readers
  /// take for a number of use, 1e9.
  XmlWriter& with(std::string_view attribute, double value);
  XmlWriter& with(std::string_view attribute, const Vector3& vector);
  XmlWriter& close();
  /// An `<origin>`.
  XmlWriter& origin(const Pose& pose);

  /// @return All, with everything closed.
  std::string take();

 private:
  std::string text_;
  std::vector<std::string> elements_;
  bool isTagOpen_ = false;
};

/// @return Roll, pitch, yaw [rad] from which `fromRollPitchYaw` makes this rotation, to the last bits at a pitch of a
/// quarter turn too: there `rollPitchYawOf`, which takes the arcus sine of what is nearly 1, has lost half of them.
Vector3 exactRollPitchYawOf(const Quaternion& rotation);

}  // namespace pongsim::ros2
