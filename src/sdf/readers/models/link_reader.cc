#include "sdf/readers/models/link_reader.hh"

#include <algorithm>
#include <charconv>
#include <cstdint>
#include <limits>
#include <string_view>
#include <utility>
#include <variant>

#include "sdf/readers/models/inertial_reader.hh"
#include "sdf/readers/shapes/geometry_reader.hh"
#include "sdf/readers/shapes/visual_reader.hh"
#include "sdf/text/names.hh"

namespace pongsim::sdf {

namespace {

/// Reads a mask of 16 bits; higher bits are ignored, as in Fortress.
std::uint16_t readMask(const Element& parent, std::string_view child, std::uint16_t fallback, Context& context) {
  const std::string_view text = childText(parent, child);
  std::uint64_t bits = 0;
  if (text.starts_with("0x") || text.starts_with("0X")) {
    std::from_chars(text.data() + 2, text.data() + text.size(), bits, 16);
  } else {
    bits = static_cast<std::uint64_t>(std::clamp(readNumber(parent, child, fallback, context), 0.0, 1e18));
  }
  return static_cast<std::uint16_t>(bits & 0xffffU);
}

description::Torsion readTorsion(const Element& element, Context& context) {
  description::Torsion torsion;
  torsion.coefficient = readNotNegative(element, "coefficient", torsion.coefficient, context);
  torsion.patchRadius = readNotNegative(element, "patch_radius", torsion.patchRadius, context);
  torsion.surfaceRadius = readNotNegative(element, "surface_radius", torsion.surfaceRadius, context);
  torsion.usesPatchRadius = readFlag(element, "use_patch_radius", torsion.usesPatchRadius, context);
  if (const Element* ode = element.child("ode")) torsion.slip = readNotNegative(*ode, "slip", torsion.slip, context);
  return torsion;
}

/// @return The attribute that names the link in whose frame a friction direction is given, or null.
const Element::Attribute* frameOfDirection(const Element& direction) {
  const Element::Attribute* frame = direction.attribute("ignition:expressed_in");
  return frame != nullptr ? frame : direction.attribute("gz:expressed_in");
}

description::Surface readSurface(const Element& collision, Context& context) {
  description::Surface surface;
  const Element* element = collision.child("surface");
  if (element == nullptr) return surface;
  const Element* friction = element->child("friction");
  if (const Element* ode = friction != nullptr ? friction->child("ode") : nullptr) {
    surface.mu = readNotNegative(*ode, "mu", surface.mu, context);
    surface.mu2 = readNotNegative(*ode, "mu2", surface.mu2, context);
    surface.fdir1 = readVector(*ode, "fdir1", surface.fdir1, context);
    if (const Element* direction = ode->child("fdir1")) {
      if (const Element::Attribute* frame = frameOfDirection(*direction)) surface.fdir1Link = frame->value;
    }
    surface.slip1 = readNotNegative(*ode, "slip1", surface.slip1, context);
    surface.slip2 = readNotNegative(*ode, "slip2", surface.slip2, context);
  }
  if (const Element* torsional = friction != nullptr ? friction->child("torsional") : nullptr) {
    surface.torsion = readTorsion(*torsional, context);
  }
  if (const Element* contact = element->child("contact")) {
    surface.collideBitmask = readMask(*contact, "collide_bitmask", surface.collideBitmask, context);
  }
  if (const Element* bounce = element->child("bounce")) {
    surface.restitution = readNotNegative(*bounce, "restitution_coefficient", surface.restitution, context);
    if (bounce->child("threshold") != nullptr)
      surface.bounceThreshold = readNotNegative(*bounce, "threshold", 0, context);
  }
  return surface;
}

description::Collision readCollision(const Element& element, const std::string& owner, Context& context) {
  description::Collision collision;
  collision.name = readName(element, owner, context);
  collision.position = element.position;
  collision.geometry = readGeometry(element, partLabel(element, collision.name, owner), context);
  collision.surface = readSurface(element, context);
  if (element.child("max_contacts") != nullptr) {
    collision.surface.maxContacts = readInteger(element, "max_contacts", 10, std::numeric_limits<int>::min(),
                                                std::numeric_limits<int>::max(), context);
  }
  if (std::holds_alternative<description::Image>(collision.geometry)) {
    context.unsimulated.warning(
        element.position,
        "collision '" + collision.name + "' has an image, which Fortress does not support: it " + "will not collide",
        "a <heightmap> can be made from an image");
  }
  return collision;
}

}  // namespace

LinkDraft readLink(const Element& element, const std::string& owner, bool isStatic, Context& context) {
  LinkDraft draft;
  description::Link& link = draft.link;
  link.name = readName(element, owner, context);
  link.position = element.position;
  draft.pose = readPose(element, context);
  const std::string label = partLabel(element, link.name, owner);
  std::optional<AutoInertia> automatic = readAutoInertia(element, label, context);
  if (!automatic) link.inertial = readInertial(element, label, isStatic, context);
  // a static link has no use for it
  if (!isStatic) draft.autoInertia = std::move(automatic);
  link.gravity = readFlag(element, "gravity", link.gravity, context);
  link.kinematic = readFlag(element, "kinematic", link.kinematic, context);
  if (const Element* selfCollide = element.child("self_collide");
      selfCollide != nullptr && !selfCollide->text.empty()) {
    link.selfCollide = readFlag(element, "self_collide", false, context);
  }
  if (const Element* wind = element.child("enable_wind"); wind != nullptr && !wind->text.empty()) {
    link.isInWind = readFlag(element, "enable_wind", false, context);
  }
  if (const Element* decay = element.child("velocity_decay")) {
    link.linearDamping = readNotNegative(*decay, "linear", link.linearDamping, context);
    link.angularDamping = readNotNegative(*decay, "angular", link.angularDamping, context);
  }

  SiblingNames names(label);
  for (const Element& child : element.children) {
    if (child.name != "collision" && child.name != "visual") continue;
    const bool isVisual = child.name == "visual";
    const PoseText pose = readPose(child, context);
    std::size_t index = 0;
    if (isVisual) {
      index = link.visuals.size();
      link.visuals.push_back(readVisual(child, label, context));
      link.visuals.back().X_LinkVisual = pose.value;
      names.claim(link.visuals.back().name, child.name, child, context);
    } else {
      index = link.collisions.size();
      link.collisions.push_back(readCollision(child, label, context));
      link.collisions.back().X_LinkCollision = pose.value;
      draft.densities.push_back(readDensity(child, context));
      names.claim(link.collisions.back().name, child.name, child, context);
    }
    if (!pose.relativeTo.empty()) draft.shapes.push_back({isVisual, index, pose});
  }
  for (const Element* sensor : element.childrenNamed("sensor")) {
    draft.sensors.push_back(readSensor(*sensor, label, context));
    names.claim(draft.sensors.back().sensor.name, sensor->name, *sensor, context);
  }
  for (const Element* light : element.childrenNamed("light")) {
    draft.lights.push_back(readLight(*light, label, context));
    names.claim(draft.lights.back().light.name, light->name, *light, context);
  }
  for (const Element* emitter : element.childrenNamed("particle_emitter")) {
    draft.emitters.push_back(readEmitter(*emitter, label, context));
    names.claim(draft.emitters.back().emitter.name, emitter->name, *emitter, context);
  }
  return draft;
}

description::Link finishLink(LinkDraft&& draft, const Scope& scope, std::size_t frameIndex, Context& context) {
  description::Link link = std::move(draft.link);
  link.X_ModelLink = scope.pose(frameIndex);
  for (const LinkDraft::PlacedShape& shape : draft.shapes) {
    const std::string& name = shape.isVisual ? link.visuals[shape.index].name : link.collisions[shape.index].name;
    const std::string label = (shape.isVisual ? "visual '" : "collision '") + name + "'";
    const std::optional<Scope::ResolvedFrame> frame = scope.findOrComplain(
        shape.pose.relativeTo, "the pose of " + label + " is relative to", shape.pose.position, context);
    if (!frame) continue;
    const Pose X_LinkShape = link.X_ModelLink.inverse() * frame->X_ScopeFrame * shape.pose.value;
    (shape.isVisual ? link.visuals[shape.index].X_LinkVisual : link.collisions[shape.index].X_LinkCollision) =
        X_LinkShape;
  }
  if (draft.autoInertia) {
    computeInertia(*draft.autoInertia, draft.densities, "link '" + link.name + "'", link, context);
  }
  for (SensorDraft& sensor : draft.sensors) {
    link.sensors.push_back(finishSensor(std::move(sensor), scope, link.X_ModelLink, context));
  }
  for (LightDraft& light : draft.lights) {
    link.lights.push_back(finishLight(std::move(light), scope, link.X_ModelLink, context));
  }
  for (EmitterDraft& emitter : draft.emitters) {
    link.emitters.push_back(finishEmitter(std::move(emitter), scope, link.X_ModelLink, context));
  }
  return link;
}

}  // namespace pongsim::sdf
