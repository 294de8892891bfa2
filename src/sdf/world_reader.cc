#include "sdf/world_reader.hh"

#include <optional>
#include <string>
#include <utility>

#include "sdf/names.hh"
#include "sdf/parts_reader.hh"
#include "sdf/physics_reader.hh"
#include "sdf/scope.hh"

namespace pongsim::sdf {

namespace {

/// Reads a light of the world, whose scope is resolved.
description::Light readLight(const Element& element, const Scope& scope, Context& context) {
  description::Light light;
  light.name = readName(element, scope.label(), context);
  light.type = element.attributeOr("type", "point");
  light.position = element.position;
  const PoseText pose = readPose(element, context);
  light.X_WorldLight = pose.value;
  if (!pose.relativeTo.empty()) {
    const std::optional<Scope::Found> frame = scope.findOrComplain(
        pose.relativeTo, "the pose of light '" + light.name + "' is relative to", pose.position, context);
    if (frame) light.X_WorldLight = frame->X_ScopeFrame * pose.value;
  }
  return light;
}

/// Completes the joints that tie a part of the model to the world, now that the model's place is known.
void placeWorldJoints(description::Model& model, const Pose& X_WorldParent) {
  const Pose X_WorldModel = X_WorldParent * model.X_ParentModel;
  for (description::Joint& joint : model.joints) {
    if (joint.parent == "world") joint.X_ParentJoint = X_WorldModel * joint.X_ParentJoint;
  }
  for (description::Model& inner : model.models) placeWorldJoints(inner, X_WorldModel);
}

}  // namespace

description::World readWorld(const Element& element, Context& context) {
  description::World world;
  world.name = readName(element, "", context);
  world.position = element.position;
  world.gravity = readGravity(element, context);
  world.physics = readPhysics(element, context);

  Scope scope("world", world.name.empty() ? "a world" : "world '" + world.name + "'");
  scope.setCanonicalLink("world");
  PartsReader parts(scope, false, context);
  parts.read(element);
  scope.resolve(context);
  world.models = parts.takeModels();
  world.joints = parts.takeJoints();
  world.frames = parts.takeFrames();
  world.plugins = parts.takePlugins();
  for (description::Model& model : world.models) placeWorldJoints(model, Pose());

  SiblingNames lights(scope.label());
  for (const Element& child : element.children) {
    if (child.name != "light") continue;
    world.lights.push_back(readLight(child, scope, context));
    lights.claim(world.lights.back().name, child.name, child, context);
  }
  return world;
}

}  // namespace pongsim::sdf
