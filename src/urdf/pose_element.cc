#include "urdf/pose_element.hh"

#include "base/element_edit.hh"

namespace pongsim::urdf {

void addPose(Element& parent, const Pose& pose, const SourcePosition& position, std::string_view relativeTo) {
  Element& element = base::addChild(parent, "pose", position, textOf(pose.position));
  if (!relativeTo.empty()) base::setAttribute(element, "relative_to", std::string(relativeTo), position);
  if (pose.rotation.vec().isZero(0)) {
    element.text += " 0 0 0";
    return;
  }
  base::setAttribute(element, "rotation_format", "quat_xyzw", position);
  element.text += ' ' + textOf(Vector3(pose.rotation.vec())) + ' ' + textOf(pose.rotation.w());
}

std::string textOf(double value) { return base::shortestText(value == 0 ? 0 : value); }

std::string textOf(const Vector3& vector) {
  return textOf(vector.x()) + ' ' + textOf(vector.y()) + ' ' + textOf(vector.z());
}

}  // namespace pongsim::urdf
