#include "sdf/readers/models/actor_reader.hh"

#include <limits>
#include <optional>
#include <utility>

#include "sdf/includes/asset_file.hh"
#include "sdf/readers/shapes/data_systems.hh"
#include "sdf/readers/shapes/visual_reader.hh"
#include "sdf/readers/worlds/plugin_reader.hh"
#include "sdf/text/names.hh"

namespace pongsim::sdf {

namespace {

description::ActorFile readFile(const Element& element, Context& context) {
  description::Texture file = readTexture(element, "filename", context);
  return {std::move(file.uri), std::move(file.file), readPositive(element, "scale", 1, context)};
}

description::Trajectory readTrajectory(const Element& element, Context& context) {
  using Limits = std::numeric_limits<int>;
  description::Trajectory trajectory;
  trajectory.id = readIntegerAttribute(element, "id", trajectory.id, Limits::min(), Limits::max(), context);
  trajectory.type = element.attributeOr("type", "");
  trajectory.tension = readNumberAttribute(element, "tension", trajectory.tension, context);
  for (const Element* waypoint : element.childrenNamed("waypoint")) {
    trajectory.waypoints.push_back({readNumber(*waypoint, "time", 0, context), readPose(*waypoint, context).value});
  }
  return trajectory;
}

void readScript(const Element& element, description::Actor& actor, Context& context) {
  actor.loops = readFlag(element, "loop", actor.loops, context);
  actor.startDelay = readNumber(element, "delay_start", actor.startDelay, context);
  actor.startsByItself = readFlag(element, "auto_start", actor.startsByItself, context);
  for (const Element* trajectory : element.childrenNamed("trajectory")) {
    actor.trajectories.push_back(readTrajectory(*trajectory, context));
  }
}

void readAnimations(const Element& element, const std::string& label, description::Actor& actor, Context& context) {
  SiblingNames names(label);
  for (const Element* child : element.childrenNamed("animation")) {
    description::Animation animation;
    animation.name = readName(*child, label, context);
    animation.source = readFile(*child, context);
    animation.followsPath = readFlag(*child, "interpolate_x", animation.followsPath, context);
    names.claim(animation.name, child->name, *child, context);
    actor.animations.push_back(std::move(animation));
  }
}

/// Adds the visuals of an actor's link.
void readActorLink(const Element& element, const std::string& owner, description::Actor& actor, Context& context) {
  const std::string label = partLabel(element, readName(element, owner, context), owner);
  const auto poseOf = [&context](const Element& part) {
    const PoseText pose = readPose(part, context);
    if (!pose.relativeTo.empty()) {
      context.diagnostics.warning(pose.position, "frames have no effect in actors: the pose is used as it is");
    }
    return pose.value;
  };
  const Pose X_ActorLink = poseOf(element);
  for (const Element* child : element.childrenNamed("visual")) {
    description::Visual visual = readVisual(*child, label, context);
    visual.X_LinkVisual = X_ActorLink * poseOf(*child);
    actor.visuals.push_back(std::move(visual));
  }
}

}  // namespace

ActorDraft readActor(const Element& element, const std::string& owner, Context& context) {
  ActorDraft draft;
  description::Actor& actor = draft.actor;
  actor.name = readName(element, owner, context);
  actor.position = element.position;
  draft.pose = readPose(element, context);
  const std::string label = partLabel(element, actor.name, owner);
  if (const Element* skin = element.child("skin")) actor.skin = readFile(*skin, context);
  readAnimations(element, label, actor, context);
  for (const Element* link : element.childrenNamed("link")) readActorLink(*link, label, actor, context);
  if (const Element* script = element.child("script")) readScript(*script, actor, context);
  for (const Element* plugin : element.childrenNamed("plugin")) {
    actor.plugins.push_back(readPlugin(*plugin, label, context));
  }
  actor.label = readLabel(actor.plugins, label, context);
  return draft;
}

description::Actor finishActor(ActorDraft&& draft, const Scope& scope, Context& context) {
  description::Actor actor = std::move(draft.actor);
  actor.X_WorldActor = draft.pose.value;
  if (draft.pose.relativeTo.empty()) return actor;
  const std::optional<Scope::ResolvedFrame> frame = scope.findOrComplain(
      draft.pose.relativeTo, "the pose of actor '" + actor.name + "' is relative to", draft.pose.position, context);
  if (frame) actor.X_WorldActor = frame->X_ScopeFrame * draft.pose.value;
  return actor;
}

}  // namespace pongsim::sdf
