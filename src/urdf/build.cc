#include "urdf/build.hh"

#include <algorithm>
#include <charconv>
#include <utility>

namespace pongsim::urdf {

Element makeElement(std::string_view name, const SourcePosition& position, std::string text) {
  Element element;
  element.name = name;
  element.text = std::move(text);
  element.position = position;
  return element;
}

Element& addChild(Element& parent, std::string_view name, const SourcePosition& position, std::string text) {
  return parent.children.emplace_back(makeElement(name, position, std::move(text)));
}

void setChild(Element& parent, std::string_view name, const SourcePosition& position, std::string text) {
  Element& child = childOrNew(parent, name, position);
  child.text = std::move(text);
  child.position = position;
}

Element& childOrNew(Element& parent, std::string_view name, const SourcePosition& position) {
  const auto found = std::ranges::find(parent.children, name, &Element::name);
  return found != parent.children.end() ? *found : addChild(parent, name, position);
}

void setAttribute(Element& element, std::string_view name, std::string value, const SourcePosition& position) {
  element.attributes.push_back({std::string(name), std::move(value), position});
}

void addPose(Element& parent, const Pose& pose, const SourcePosition& position, std::string_view relativeTo) {
  Element& element = addChild(parent, "pose", position, textOf(pose.position));
  if (!relativeTo.empty()) setAttribute(element, "relative_to", std::string(relativeTo), position);
  if (pose.rotation.vec().isZero(0)) {
    element.text += " 0 0 0";
    return;
  }
  setAttribute(element, "rotation_format", "quat_xyzw", position);
  element.text += ' ' + textOf(Vector3(pose.rotation.vec())) + ' ' + textOf(pose.rotation.w());
}

std::string textOf(double value) {
  char buffer[32];
  const auto end = std::to_chars(std::begin(buffer), std::end(buffer), value == 0 ? 0.0 : value).ptr;
  return {buffer, end};
}

std::string textOf(const Vector3& vector) {
  return textOf(vector.x()) + ' ' + textOf(vector.y()) + ' ' + textOf(vector.z());
}

}  // namespace pongsim::urdf
