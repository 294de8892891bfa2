#include "sdf/readers/worlds/world_reader.hh"

#include <string>
#include <utility>

#include "sdf/readers/models/parts_reader.hh"
#include "sdf/readers/worlds/environment_reader.hh"
#include "sdf/readers/worlds/levels_reader.hh"
#include "sdf/readers/worlds/physics_reader.hh"
#include "sdf/readers/worlds/scene_reader.hh"
#include "sdf/text/names.hh"

namespace pongsim::sdf {

namespace {

/// Updates the joints that connect the model to the world, now that the model's pose is known.
void placeWorldJoints(description::Model& model, const Pose& X_WorldParent) {
  const Pose X_WorldModel = X_WorldParent * model.X_ParentModel;
  for (description::Joint& joint : model.joints) {
    if (joint.parent == "world") joint.X_ParentJoint = X_WorldModel * joint.X_ParentJoint;
    if (joint.gearboxReference == "world") joint.X_ReferenceJoint = X_WorldModel * joint.X_ReferenceJoint;
  }
  for (description::Model& inner : model.models) placeWorldJoints(inner, X_WorldModel);
}

}  // namespace

WorldParts readWorld(const Element& element, Context& context) {
  description::World world;
  world.name = readName(element, "", context);
  world.position = element.position;
  world.gravity = readGravity(element, context);
  world.physicsProfiles = readPhysics(element, context);
  world.physics = chosenProfile(world.physicsProfiles);
  world.environment = readEnvironment(element, context);
  world.scene = readScene(element, context);
  if (const Element* gui = element.child("gui")) world.gui = *gui;

  auto scope = std::make_unique<Scope>("world", world.name.empty() ? "a world" : "world '" + world.name + "'");
  scope->setCanonicalLink("world");
  PartsReader parts(*scope, false, context);
  parts.read(element);
  scope->resolve(context);
  world.models = parts.takeModels();
  world.joints = parts.takeJoints();
  world.frames = parts.takeFrames();
  world.lights = parts.takeLights();
  world.actors = parts.takeActors();
  world.plugins = parts.takePlugins();
  world.levels = readLevels(world, context);
  for (description::Model& model : world.models) placeWorldJoints(model, Pose());
  return {std::move(world), std::move(scope)};
}

RootParts readRootParts(const Element& element, Context& context) {
  auto scope = std::make_unique<Scope>("__root__", "this file");
  scope->setCanonicalLink("world");
  PartsReader parts(*scope, false, context);
  parts.read(element);
  scope->resolve(context);
  RootParts found{parts.takeModels(), parts.takeLights(), parts.takeActors(), std::move(scope)};
  for (description::Model& model : found.models) placeWorldJoints(model, Pose());
  return found;
}

}  // namespace pongsim::sdf
