#include "sdf/readers/models/joint_reader.hh"

#include <array>
#include <cmath>
#include <limits>
#include <optional>
#include <string>
#include <utility>

#include "base/nearest_word.hh"
#include "sdf/text/names.hh"
#include "sdf/text/values.hh"

namespace pongsim::sdf {

namespace {

using description::JointAxis;
using description::JointType;

constexpr std::array kJointTypes{JointType::kRevolute,  JointType::kContinuous, JointType::kPrismatic,
                                 JointType::kBall,      JointType::kFixed,      JointType::kUniversal,
                                 JointType::kRevolute2, JointType::kScrew,      JointType::kGearbox};

std::size_t axisCount(JointType type) {
  switch (type) {
    case JointType::kBall:
    case JointType::kFixed:
      return 0;
    case JointType::kUniversal:
    case JointType::kRevolute2:
    case JointType::kGearbox:
      return 2;
    default:
      return 1;
  }
}

// two axes are parallel if the sine of the angle between them is below this
constexpr double kSmallestSine = 1e-3;

std::string labelOf(const description::Joint& joint) {
  return joint.name.empty() ? "a joint" : "joint '" + joint.name + "'";
}

std::optional<JointType> readType(const Element& element, const std::string& label, Context& context) {
  const Element::Attribute* attribute = element.attribute("type");
  if (attribute == nullptr) {
    context.diagnostics.error(element.position, label + " has no type", "write type=\"revolute\", for example");
    return std::nullopt;
  }
  std::vector<std::string_view> known;
  for (const JointType type : kJointTypes) {
    known.push_back(description::name(type));
    if (known.back() == attribute->value) return type;
  }
  context.diagnostics.error(attribute->position, label + " has the unknown type '" + attribute->value + "'",
                            base::didYouMean(attribute->value, known));
  return std::nullopt;
}

/// A negative value means no limit.
double readMaximum(const Element& limit, std::string_view child, Context& context) {
  const double value = readLimit(limit, child, -1, context);
  return value < 0 ? std::numeric_limits<double>::infinity() : value;
}

void readLimits(const Element& element, const std::string& label, JointType type, JointAxis& axis, Context& context) {
  if (type != JointType::kContinuous) {
    axis.lower = readLimit(element, "lower", axis.lower, context);
    axis.upper = readLimit(element, "upper", axis.upper, context);
  }
  axis.effort = readMaximum(element, "effort", context);
  axis.velocity = readMaximum(element, "velocity", context);
  for (const auto& [name, value] : {std::pair("lower", axis.lower), std::pair("upper", axis.upper)}) {
    // a lower limit of -inf or an upper one of +inf means no limit; the opposite would be out of reach
    const bool isOut = name[0] == 'l' ? value > kLargestPosition : value < -kLargestPosition;
    if (!isOut) continue;
    context.diagnostics.error(element.child(name)->position, "the " + std::string(name) + " limit of " + label +
                                                                 " is out of range: beyond 1e9 rad or m");
  }
  if (axis.lower > axis.upper) {
    context.diagnostics.error(element.position, "the lower limit of " + label + " is above its upper limit");
  }
}

description::Mimic readMimic(const Element& element, const std::string& label, Context& context) {
  description::Mimic mimic{element.attributeOr("joint", ""), element.position};
  if (mimic.joint.empty()) {
    context.diagnostics.warning(element.position, "the <mimic> of " + label + " has no joint",
                                "write <mimic joint=\"...\">");
  }
  mimic.axis = element.attributeOr("axis", "axis") == "axis2" ? 1 : 0;
  mimic.multiplier = readNumber(element, "multiplier", mimic.multiplier, context);
  mimic.offset = readNumber(element, "offset", mimic.offset, context);
  mimic.reference = readNumber(element, "reference", mimic.reference, context);
  return mimic;
}

JointAxis readAxis(const Element& element, const std::string& label, JointType type, Context& context) {
  JointAxis axis;
  axis.xyz = readVector(element, "xyz", axis.xyz, context);
  const double length = axis.xyz.stableNorm();
  if (length > 0 && std::isfinite(length)) {
    axis.xyz = (axis.xyz / length).normalized();
  } else {
    context.diagnostics.error(element.child("xyz")->position, "an axis of " + label + " has length zero");
    axis.xyz = Vector3::UnitZ();
  }
  if (const Element* limit = element.child("limit")) readLimits(*limit, label, type, axis, context);
  if (const Element* dynamics = element.child("dynamics")) {
    axis.damping = readNumber(*dynamics, "damping", axis.damping, context);
    axis.friction = readNumber(*dynamics, "friction", axis.friction, context);
    axis.springReference = readNumber(*dynamics, "spring_reference", axis.springReference, context);
    if (!(std::abs(axis.springReference) <= kLargestPosition)) {
      context.diagnostics.error(dynamics->child("spring_reference")->position,
                                "the spring of " + label + " has a reference out of range: beyond 1e9 rad or m");
      axis.springReference = 0;
    }
    axis.springStiffness = readNumber(*dynamics, "spring_stiffness", axis.springStiffness, context);
  }
  if (const Element* mimic = element.child("mimic")) axis.mimic = readMimic(*mimic, label, context);
  return axis;
}

/// @return The frame that the axis is given in; empty: the joint's own.
JointDraft::FrameName readAxisFrame(const Element& axis) {
  if (const Element* xyz = axis.child("xyz")) {
    if (const Element::Attribute* frame = xyz->attribute("expressed_in")) return {frame->value, frame->position};
  }
  return {"", axis.position};
}

void readAxes(const Element& element, JointDraft& draft, Context& context) {
  constexpr std::array<std::string_view, 2> kNames{"axis", "axis2"};
  const std::string label = labelOf(draft.joint);
  for (std::size_t i = 0; i < axisCount(draft.joint.type); ++i) {
    const Element* axis = element.child(kNames[i]);
    if (axis == nullptr) {
      const std::string name(kNames[i]);
      context.diagnostics.warning(element.position, label + " has no <" + name + ">: z is used");
      draft.joint.axes.emplace_back();
      draft.axisFrames.emplace_back();
      continue;
    }
    draft.joint.axes.push_back(readAxis(*axis, label, draft.joint.type, context));
    draft.axisFrames.push_back(readAxisFrame(*axis));
  }
}

JointDraft::FrameName readLinkName(const Element& joint, std::string_view child, const std::string& label,
                                   Context& context) {
  const Element* element = joint.child(child);
  if (element != nullptr && !element->text.empty()) return {element->text, element->position};
  context.diagnostics.error(element != nullptr ? element->position : joint.position,
                            label + " has no <" + std::string(child) + ">");
  return {"", joint.position};
}

// the limits and friction of a gearbox's axes have no effect: its gears turn about hinges that are separate joints
void warnOfIdleAxis(const JointAxis& axis, const std::string& label, SourcePosition position, Context& context) {
  constexpr double kNoLimit = 1e16;
  const bool isIdle = axis.lower <= -kNoLimit && axis.upper >= kNoLimit && std::isinf(axis.effort) &&
                      std::isinf(axis.velocity) && axis.damping == 0 && axis.friction == 0 && axis.springStiffness == 0;
  if (isIdle) return;
  context.unsimulated.warning(position, "limits and dynamics of " + label + " have no effect: it is a gearbox",
                              "set them on the joints that the gears turn on");
}

void readGearbox(const Element& element, JointDraft& draft, Context& context) {
  description::Joint& joint = draft.joint;
  const std::string label = labelOf(joint);
  joint.gearboxRatio = readNumber(element, "gearbox_ratio", joint.gearboxRatio, context);
  // libsdformat loads a file without it; Fortress makes no joint of any gearbox
  if (const Element* body = element.child("gearbox_reference_body"); body == nullptr || body->text.empty()) {
    context.diagnostics.warning(element.position, label + " has no <gearbox_reference_body>: the joint is left out");
  } else {
    draft.reference = readLinkName(element, "gearbox_reference_body", label, context);
  }
  for (const JointAxis& axis : joint.axes) warnOfIdleAxis(axis, label, element.position, context);
  if (joint.gearboxRatio == 0) {
    context.diagnostics.error(element.position, label + " has a <gearbox_ratio> of 0",
                              "the child turns -ratio times as far as the parent");
  }
}

}  // namespace

JointDraft readJoint(const Element& element, const std::string& owner, Context& context) {
  JointDraft draft;
  description::Joint& joint = draft.joint;
  joint.name = readName(element, owner, context);
  joint.position = element.position;
  const std::string label = labelOf(joint);
  draft.pose = readPose(element, context);
  if (const std::optional<JointType> type = readType(element, label, context)) {
    joint.type = *type;
    readAxes(element, draft, context);
    if (*type == JointType::kScrew) {
      const bool isNew = element.child("screw_thread_pitch") != nullptr;
      joint.threadPitch =
          readNumber(element, isNew ? "screw_thread_pitch" : "thread_pitch", joint.threadPitch, context);
    }
    if (*type == JointType::kGearbox) readGearbox(element, draft, context);
  }
  draft.parent = readLinkName(element, "parent", label, context);
  draft.child = readLinkName(element, "child", label, context);
  if (draft.child.name == "world") {
    context.diagnostics.error(draft.child.position, label + " has the world as its child",
                              "the world can only be a joint's parent");
    draft.child.name.clear();
  } else if (!draft.child.name.empty() && draft.child.name == draft.parent.name) {
    context.diagnostics.error(draft.child.position, label + " has '" + draft.child.name + "' as parent and child");
    draft.parent.name.clear();
  }
  SiblingNames names(label + " of " + owner);
  for (const Element* sensor : element.childrenNamed("sensor")) {
    draft.sensors.push_back(readSensor(*sensor, label + " of " + owner, context));
    names.claim(draft.sensors.back().sensor.name, sensor->name, *sensor, context);
  }
  return draft;
}

namespace {

/// Finds the link that the axes of a gearbox are fixed to.
void finishGearbox(description::Joint& joint, const JointDraft& draft, const Scope& scope, const Pose& X_ScopeJoint,
                   Context& context) {
  const JointDraft::FrameName& given = draft.reference;
  joint.gearboxReference = given.name;
  joint.X_ReferenceJoint = X_ScopeJoint;
  if (given.name == "world") return;
  const std::string label = labelOf(joint);
  const std::optional<Scope::ResolvedFrame> reference =
      scope.findOrComplain(given.name, label + " names reference body", given.position, context);
  if (!reference) return;
  joint.gearboxReference = reference->link;
  if (reference->link.empty()) {
    context.diagnostics.error(given.position, label + " names reference body '" + given.name + "', which has no link");
    return;
  }
  const std::optional<Scope::ResolvedFrame> link = scope.find(reference->link);
  if (link) joint.X_ReferenceJoint = link->X_ScopeFrame.inverse() * X_ScopeJoint;
  if (joint.gearboxReference == joint.parent || joint.gearboxReference == joint.child) {
    context.diagnostics.error(given.position,
                              label + " has '" + given.name + "' both as reference body and as parent or child",
                              "it is the link that both gears turn on");
  }
}

}  // namespace

std::optional<description::Joint> finishJoint(JointDraft&& draft, const Scope& scope, std::size_t frameIndex,
                                              Context& context) {
  description::Joint joint = std::move(draft.joint);
  const std::string label = labelOf(joint);
  const Pose& X_ScopeJoint = scope.pose(frameIndex);
  const auto poseOf = [&](const std::string& link) {
    const std::optional<Scope::ResolvedFrame> found = scope.find(link);
    return found ? found->X_ScopeFrame : Pose();
  };

  joint.child = scope.link(frameIndex);
  joint.X_ChildJoint = poseOf(joint.child).inverse() * X_ScopeJoint;
  if (joint.child == "world") {
    context.diagnostics.error(draft.child.position,
                              label + " has the world as its child, through frame '" + draft.child.name + "'");
  } else if (joint.child.empty() && scope.find(draft.child.name)) {
    context.diagnostics.error(draft.child.position,
                              label + " names child '" + draft.child.name + "', which has no link");
  }

  if (draft.parent.name == "world") {
    joint.parent = "world";
    joint.X_ParentJoint = X_ScopeJoint;
  } else if (!draft.parent.name.empty()) {
    const std::optional<Scope::ResolvedFrame> parent =
        scope.findOrComplain(draft.parent.name, label + " names parent link", draft.parent.position, context);
    if (parent && parent->link.empty()) {
      context.diagnostics.error(draft.parent.position,
                                label + " names parent '" + draft.parent.name + "', which has no link");
    }
    joint.parent = parent ? parent->link : "";
    joint.X_ParentJoint = poseOf(joint.parent).inverse() * X_ScopeJoint;
    // Fortress loads such a joint, but it has no effect
    if (!joint.parent.empty() && joint.parent == joint.child) {
      context.diagnostics.warning(draft.child.position, "parent '" + draft.parent.name + "' and child '" +
                                                            draft.child.name + "' of " + label + " are both link '" +
                                                            joint.child + "': the joint is left out");
      return std::nullopt;
    }
  }

  if (joint.type == JointType::kGearbox) {
    if (draft.reference.name.empty()) return std::nullopt;
    finishGearbox(joint, draft, scope, X_ScopeJoint, context);
  }
  for (std::size_t i = 0; i < joint.axes.size(); ++i) {
    const JointDraft::FrameName& given = draft.axisFrames[i];
    if (given.name.empty()) continue;
    const std::optional<Scope::ResolvedFrame> frame =
        scope.findOrComplain(given.name, "an axis of " + label + " is expressed in", given.position, context);
    if (!frame) continue;
    joint.axes[i].xyz = X_ScopeJoint.rotation.conjugate() * (frame->X_ScopeFrame.rotation * joint.axes[i].xyz);
  }
  const bool hasCross = joint.type == JointType::kUniversal || joint.type == JointType::kRevolute2;
  if (hasCross && joint.axes[0].xyz.cross(joint.axes[1].xyz).norm() < kSmallestSine) {
    context.unsimulated.error(joint.position, "the two axes of " + label + " have the same direction",
                              "<axis> is fixed to the parent, <axis2> to the child; they must not be parallel");
  }
  for (SensorDraft& sensor : draft.sensors) {
    joint.sensors.push_back(finishSensor(std::move(sensor), scope, X_ScopeJoint, context));
  }
  return joint;
}

void checkMimics(std::vector<description::Joint>& joints, Context& context) {
  std::vector<std::string_view> names;
  for (const description::Joint& joint : joints) names.push_back(joint.name);
  for (description::Joint& joint : joints) {
    for (JointAxis& axis : joint.axes) {
      if (!axis.mimic || axis.mimic->joint.empty()) continue;
      const description::Mimic& mimic = *axis.mimic;
      const auto leader = std::ranges::find(joints, mimic.joint, &description::Joint::name);
      if (leader != joints.end() && leader->name != joint.name && mimic.axis < leader->axes.size()) continue;
      const std::string what = leader == joints.end()       ? "which is not a joint of its model"
                               : leader->name == joint.name ? "which is itself"
                                                            : "which has no such axis";
      context.diagnostics.warning(mimic.position,
                                  labelOf(joint) + " mimics '" + mimic.joint + "', " + what + ": it moves freely",
                                  leader == joints.end() ? base::didYouMean(mimic.joint, names) : "");
      axis.mimic.reset();
    }
  }
}

}  // namespace pongsim::sdf
