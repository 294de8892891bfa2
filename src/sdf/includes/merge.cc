#include "sdf/includes/merge.hh"

#include <algorithm>
#include <array>
#include <string_view>
#include <utility>

#include "base/element_edit.hh"
#include "sdf/text/names.hh"

namespace pongsim::sdf {

namespace {

/// Replaces the model frame by `frame` in an attribute that names a frame.
void rename(Element& element, std::string_view attributeName, const std::string& frame) {
  Element::Attribute* attribute = base::attributeOf(element, attributeName);
  if (attribute != nullptr && attribute->value == kModelFrame) attribute->value = frame;
}

/// Like `rename`, but a missing or empty name also means the model frame.
void renameDefault(Element& element, std::string_view attributeName, const std::string& frame) {
  Element::Attribute* attribute = base::attributeOf(element, attributeName);
  if (attribute == nullptr) {
    element.attributes.push_back({std::string(attributeName), frame, element.position});
  } else if (attribute->value.empty() || attribute->value == kModelFrame) {
    attribute->value = frame;
  }
}

/// Renames the model frame in everything inside a part.
void renameInside(Element& element, const std::string& frame) {
  for (Element& child : element.children) {
    if (child.name == "plugin") continue;
    if (child.name == "pose") rename(child, "relative_to", frame);
    if (child.name == "xyz") rename(child, "expressed_in", frame);
    if ((child.name == "parent" || child.name == "child") && child.text == kModelFrame) child.text = frame;
    renameInside(child, frame);
  }
}

/// @return Whether the part is merged; the other parts describe the model itself.
bool isMerged(const Element& part) {
  constexpr std::array<std::string_view, 7> kMerged{"link", "model", "joint", "frame", "gripper", "plugin", "include"};
  return std::ranges::find(kMerged, part.name) != kMerged.end() || part.name.find(':') != std::string::npos;
}

Element poseElement(const MergedModel& model) {
  const Vector3& p = model.X_ReferenceModel.position;
  const Quaternion& q = model.X_ReferenceModel.rotation;
  Element pose = base::makeElement("pose", model.includedFrom);
  for (const double value : {p.x(), p.y(), p.z(), q.x(), q.y(), q.z(), q.w()}) {
    pose.text += (pose.text.empty() ? "" : " ") + base::shortestText(value);
  }
  pose.attributes.push_back({"relative_to", model.relativeTo, model.includedFrom});
  pose.attributes.push_back({"rotation_format", "quat_xyzw", model.includedFrom});
  return pose;
}

}  // namespace

std::string mergedFrameName(const std::string& model) { return "_merged__" + model + "__model__"; }

void setModelFrame(Element& part, const std::string& frame) {
  const bool isFrame = part.name == "frame";
  if (isFrame) renameDefault(part, "attached_to", frame);
  // a nested model's content refers to a model frame of its own
  if (part.name != "model") renameInside(part, frame);
  // by default, frames are relative to what they are attached to, and joints to their child
  if (isFrame || part.name == "joint") return;
  Element* pose = base::childOf(part, "pose");
  if (pose == nullptr) pose = &base::addChild(part, "pose", part.position, "0 0 0 0 0 0");
  renameDefault(*pose, "relative_to", frame);
}

std::vector<Element> mergedParts(const MergedModel& model) {
  const std::string frameName = mergedFrameName(model.name);
  std::vector<Element> parts = {base::makeElement("frame", model.includedFrom)};
  Element& frame = parts.front();
  frame.attributes.push_back({"name", frameName, model.includedFrom});
  frame.attributes.push_back({"attached_to", model.canonicalLink, model.includedFrom});
  frame.children.push_back(poseElement(model));
  for (const Element& child : model.element.children) {
    if (!isMerged(child)) continue;
    parts.push_back(child);
    if (child.name != "include" && child.name != "plugin" && child.name != "gripper") {
      setModelFrame(parts.back(), frameName);
    }
  }
  return parts;
}

}  // namespace pongsim::sdf
