#include "urdf/joint_elements.hh"

#include <utility>

#include "base/element_edit.hh"
#include "urdf/pose_element.hh"

namespace pongsim::urdf {

namespace {

/// @return SDF's type; empty if the joint leaves the link free.
std::string typeOf(const ::urdf::Joint& joint) {
  switch (joint.type) {
    case ::urdf::Joint::REVOLUTE:
    case ::urdf::Joint::CONTINUOUS:
      return "revolute";
    case ::urdf::Joint::PRISMATIC:
      return "prismatic";
    case ::urdf::Joint::FIXED:
      return "fixed";
    default:
      return {};
  }
}

void addLimits(const Joint& joint, Element& axis, Diagnostics& diagnostics) {
  const ::urdf::Joint& urdf = *joint.urdf;
  const SourcePosition& position = positionIn(*joint.xml, "limit");
  Element& limit = base::addChild(axis, "limit", position);
  if (urdf.limits == nullptr) return;
  if (urdf.type != ::urdf::Joint::CONTINUOUS) {
    double lower = urdf.limits->lower, upper = urdf.limits->upper;
    if (lower > upper) {
      diagnostics.warning(position, "the lower limit of joint '" + urdf.name + "' is above its upper limit",
                          "they are swapped, as in Fortress");
      std::swap(lower, upper);
    }
    base::addChild(limit, "lower", position, textOf(lower));
    base::addChild(limit, "upper", position, textOf(upper));
  }
  base::addChild(limit, "effort", position, textOf(urdf.limits->effort));
  base::addChild(limit, "velocity", position, textOf(urdf.limits->velocity));
}

void addAxis(const Joint& joint, Element& element, Diagnostics& diagnostics) {
  const ::urdf::Joint& urdf = *joint.urdf;
  const SourcePosition& position = positionIn(*joint.xml, "axis");
  Element& axis = base::addChild(element, "axis", position);
  base::addChild(axis, "xyz", position, textOf(Vector3(urdf.axis.x, urdf.axis.y, urdf.axis.z)));
  addLimits(joint, axis, diagnostics);
  if (urdf.mimic != nullptr) {
    const SourcePosition& mimicPosition = positionIn(*joint.xml, "mimic");
    Element& mimic = base::addChild(axis, "mimic", mimicPosition);
    base::setAttribute(mimic, "joint", urdf.mimic->joint_name, mimicPosition);
    base::addChild(mimic, "multiplier", mimicPosition, textOf(urdf.mimic->multiplier));
    base::addChild(mimic, "offset", mimicPosition, textOf(urdf.mimic->offset));
  }
  const SourcePosition& dynamicsPosition = positionIn(*joint.xml, "dynamics");
  Element& dynamics = base::addChild(axis, "dynamics", dynamicsPosition);
  if (urdf.dynamics == nullptr) return;
  base::addChild(dynamics, "damping", dynamicsPosition, textOf(urdf.dynamics->damping));
  base::addChild(dynamics, "friction", dynamicsPosition, textOf(urdf.dynamics->friction));
}

/// For a fixed joint kept by an old extension: a revolute joint that can't turn.
void addLockedAxis(const SourcePosition& position, Element& element) {
  Element& axis = base::addChild(element, "axis", position);
  base::addChild(axis, "xyz", position, "0 0 1");
  Element& limit = base::addChild(axis, "limit", position);
  base::addChild(limit, "lower", position, "0");
  base::addChild(limit, "upper", position, "0");
}

void warnOfWhatIsNotSimulated(const Joint& joint, Diagnostics& diagnostics) {
  const std::string label = "joint '" + joint.urdf->name + "'";
  if (joint.urdf->type == ::urdf::Joint::PLANAR) {
    diagnostics.warning(joint.xml->position, label + " is planar, which is not simulated: its child moves freely");
  }
}

}  // namespace

void addJoint(const Robot& robot, const Link& link, const Extensions& extensions, Element& model,
              Diagnostics& diagnostics) {
  const Joint& joint = *link.joint;
  const std::string& name = joint.urdf->name;
  warnOfWhatIsNotSimulated(joint, diagnostics);
  std::string type = typeOf(*joint.urdf);
  if (type.empty()) return;
  const bool isLocked = type == "fixed" && extensions.fixingOf(name) == Extensions::Fixing::kTurnedRevolute;
  if (isLocked) type = "revolute";

  const SourcePosition& position = joint.xml->position;
  Element& element = base::addChild(model, "joint", position);
  base::setAttribute(element, "name", name, position);
  base::setAttribute(element, "type", type, position);
  const std::string& parent = robot.links[joint.parent].name;
  addPose(element, joint.X_ParentJoint, positionIn(*joint.xml, "origin"), parent == "world" ? "__model__" : parent);
  base::addChild(element, "parent", positionIn(*joint.xml, "parent"), parent);
  base::addChild(element, "child", positionIn(*joint.xml, "child"), link.name);
  if (isLocked) {
    addLockedAxis(position, element);
  } else if (type != "fixed") {
    addAxis(joint, element, diagnostics);
  }
  extensions.addToJoint(name, element);
}

}  // namespace pongsim::urdf
