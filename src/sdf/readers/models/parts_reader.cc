#include "sdf/readers/models/parts_reader.hh"

#include <algorithm>
#include <array>
#include <optional>
#include <string_view>
#include <utility>

#include "sdf/includes/includes.hh"
#include "sdf/includes/merge.hh"
#include "sdf/readers/models/model_reader.hh"
#include "sdf/readers/worlds/plugin_reader.hh"
#include "sdf/schema/unsimulated.hh"

namespace pongsim::sdf {

namespace {

// Group of names: links, joints, frames and models share one, because each of them is a frame.
constexpr std::string_view kFrames = "frame";
/// Parts that may stand outside of any world.
constexpr std::array<std::string_view, 4> kInRoot{"model", "light", "actor", "include"};

}  // namespace

PartsReader::PartsReader(Scope& scope, bool isStatic, Context& context)
    : scope_(scope), isStatic_(isStatic), context_(context), names_(scope.label()) {}

void PartsReader::read(const Element& holder) {
  isModel_ = holder.name == "model";
  isRoot_ = holder.name == "sdf";
  const Source source{context_};
  for (const Element& child : holder.children) {
    if (isRoot_ && std::ranges::find(kInRoot, child.name) == kInRoot.end()) continue;
    readPart(child, source);
  }
}

void PartsReader::readPart(const Element& element, const Source& source) {
  const std::string& kind = element.name;
  source.context.isInWorld = !isModel_;
  if (kind == "model") return readModelPart(element, source);
  if (kind == "link" && isModel_) return readLinkPart(element, source);
  if (kind == "joint") return readJointPart(element, source);
  if (kind == "frame") return readFramePart(element, source);
  if (kind == "light" && !isModel_) return readLightPart(element, source);
  if (kind == "actor" && !isModel_) readActorPart(element, source);
  if (kind == "include") return readInclude(element, source);
  if (kind == "plugin") return plugins_.push_back(readPlugin(element, scope_.label(), source.context));
  warnIfUnsimulated(element, source.context);
}

void PartsReader::readModelPart(const Element& element, const Source& source) {
  ModelDraft draft = readModel(element, scope_.label(), isStatic_, source.context);
  description::Model& model = draft.model;
  const SourcePosition& position = source.includedFrom != nullptr ? *source.includedFrom : element.position;
  names_.claim(model.name, kFrames, element.name, position, context_);
  const std::size_t frameIndex = scope_.add({.kind = FrameKind::kModel,
                                             .name = model.name,
                                             .position = position,
                                             .pose = std::move(draft.pose),
                                             .attachedTo = {},
                                             .attachedToPosition = {},
                                             .inside = std::move(draft.scope),
                                             .placementFrame = std::move(draft.placementFrame)});
  models_.push_back({std::move(model), frameIndex, &source.context});
}

void PartsReader::readLinkPart(const Element& element, const Source& source) {
  LinkDraft draft = readLink(element, scope_.label(), isStatic_, source.context);
  names_.claim(draft.link.name, kFrames, element, source.context);
  const std::size_t frameIndex = scope_.add({.kind = FrameKind::kLink,
                                             .name = draft.link.name,
                                             .position = draft.link.position,
                                             .pose = draft.pose,
                                             .attachedTo = {},
                                             .attachedToPosition = {}});
  links_.push_back({std::move(draft), frameIndex, &source.context});
}

void PartsReader::readJointPart(const Element& element, const Source& source) {
  JointDraft draft = readJoint(element, scope_.label(), source.context);
  names_.claim(draft.joint.name, kFrames, element, source.context);
  const std::size_t frameIndex = scope_.add({.kind = FrameKind::kJoint,
                                             .name = draft.joint.name,
                                             .position = draft.joint.position,
                                             .pose = draft.pose,
                                             .attachedTo = draft.child.name,
                                             .attachedToPosition = draft.child.position});
  joints_.push_back({std::move(draft), frameIndex, &source.context});
}

void PartsReader::readFramePart(const Element& element, const Source& source) {
  description::Frame frame;
  frame.name = readName(element, scope_.label(), source.context);
  frame.position = element.position;
  names_.claim(frame.name, kFrames, element, source.context);
  PoseText pose = readPose(element, source.context);
  const Element::Attribute* attribute = element.attribute("attached_to");
  const std::size_t frameIndex =
      scope_.add({.kind = FrameKind::kFrame,
                  .name = frame.name,
                  .position = frame.position,
                  .pose = std::move(pose),
                  .attachedTo = attribute != nullptr ? attribute->value : "",
                  .attachedToPosition = attribute != nullptr ? attribute->position : frame.position});
  frames_.push_back({std::move(frame), frameIndex, &source.context});
}

void PartsReader::readLightPart(const Element& element, const Source& source) {
  LightDraft draft = readLight(element, scope_.label(), source.context);
  const SourcePosition& position = source.includedFrom != nullptr ? *source.includedFrom : element.position;
  names_.claim(draft.light.name, element.name, element.name, position, context_);
  lights_.push_back({std::move(draft), 0, &source.context});
}

void PartsReader::readActorPart(const Element& element, const Source& source) {
  ActorDraft draft = readActor(element, scope_.label(), source.context);
  const SourcePosition& position = source.includedFrom != nullptr ? *source.includedFrom : element.position;
  names_.claim(draft.actor.name, element.name, element.name, position, context_);
  actors_.push_back({std::move(draft), 0, &source.context});
}

void PartsReader::readInclude(const Element& include, const Source& source) {
  const bool merges = readFlagAttribute(include, "merge", false, source.context);
  const bool isOpen = context_.includes.follow(include, source.context, [&](Element& included, Context& context) {
    if (!source.modelFrame.empty()) setModelFrame(included, source.modelFrame);
    std::vector<Element> parts;
    if (included.name == "light" && isModel_) {
      source.context.diagnostics.warning(include.position, "a light can't be included in a model: it is ignored",
                                         "include it in a <link> or in the world");
      context_.includes.replace(include, parts);
    } else if (!merges) {
      parts.push_back(std::move(included));
      readPart(context_.includes.replace(include, parts).front(), {context, {}, &include.position});
    } else if (const std::string obstacle = obstacleToMerge(included); !obstacle.empty()) {
      source.context.diagnostics.error(include.position, obstacle, "remove the attribute 'merge'");
    } else {
      readMerged(included, include, context);
    }
  });
  if (!isOpen) scope_.setIncomplete();
}

std::string PartsReader::obstacleToMerge(const Element& included) const {
  if (included.name != "model" || isRoot_) return "only a model can be merged, and only into a model or a world";
  if (isModel_) return "";
  for (const Element& part : included.children) {
    if (part.name == "link" || part.name == "gripper") {
      return "a model with a <" + part.name + "> can't be merged into a world, only models, joints, frames and plugins";
    }
  }
  return "";
}

void PartsReader::readMerged(const Element& element, const Element& include, Context& context) {
  // first read it as a separate model: it must be valid, and this locates its frame
  const SourcePosition& includedFrom = include.position;
  ModelDraft draft = readModel(element, scope_.label(), isStatic_, context);
  if (draft.model.name.empty()) return scope_.setIncomplete();
  if (draft.model.isStatic && !isStatic_) {
    context.diagnostics.warning(
        includedFrom,
        "model '" + draft.model.name + "' is static, and what it is merged into " + "is not: its links will move");
  }
  PoseText pose = std::move(draft.pose);
  if (!draft.placementFrame.empty()) {
    const std::optional<Scope::ResolvedFrame> frame = draft.scope->findOrComplain(
        draft.placementFrame, "model '" + draft.model.name + "' is placed by its frame", includedFrom, context);
    if (frame) pose.value = pose.value * frame->X_ScopeFrame.inverse();
  }
  if (pose.relativeTo.empty()) pose.relativeTo = isModel_ ? std::string(kModelFrame) : "world";

  // then read its parts, with a frame that replaces its own
  std::vector<Element> parts = mergedParts({.element = element,
                                            .name = draft.model.name,
                                            .canonicalLink = draft.model.canonicalLink,
                                            .X_ReferenceModel = pose.value,
                                            .relativeTo = std::move(pose.relativeTo),
                                            .includedFrom = includedFrom});
  const Source source{context, mergedFrameName(draft.model.name)};
  for (const Element& part : context_.includes.replace(include, parts)) readPart(part, source);
}

std::vector<description::Model> PartsReader::takeModels() {
  std::vector<description::Model> models;
  models.reserve(models_.size());
  for (auto& [model, frameIndex, context] : models_) {
    model.X_ParentModel = scope_.pose(frameIndex);
    models.push_back(std::move(model));
  }
  return models;
}

std::vector<description::Link> PartsReader::takeLinks() {
  std::vector<description::Link> links;
  links.reserve(links_.size());
  for (auto& [draft, frameIndex, context] : links_)
    links.push_back(finishLink(std::move(draft), scope_, frameIndex, *context));
  return links;
}

std::vector<description::Joint> PartsReader::takeJoints() {
  std::vector<description::Joint> joints;
  joints.reserve(joints_.size());
  for (auto& [draft, frameIndex, context] : joints_) {
    std::optional<description::Joint> joint = finishJoint(std::move(draft), scope_, frameIndex, *context);
    if (joint) joints.push_back(std::move(*joint));
  }
  checkMimics(joints, context_);
  return joints;
}

std::vector<description::Frame> PartsReader::takeFrames() {
  std::vector<description::Frame> frames;
  frames.reserve(frames_.size());
  for (auto& [frame, frameIndex, context] : frames_) {
    frame.X_ModelFrame = scope_.pose(frameIndex);
    frame.attachedLink = scope_.link(frameIndex);
    frames.push_back(std::move(frame));
  }
  return frames;
}

std::vector<description::Light> PartsReader::takeLights() {
  std::vector<description::Light> lights;
  lights.reserve(lights_.size());
  for (auto& [draft, frameIndex, context] : lights_) {
    lights.push_back(finishLight(std::move(draft), scope_, Pose(), *context));
  }
  return lights;
}

std::vector<description::Actor> PartsReader::takeActors() {
  std::vector<description::Actor> actors;
  actors.reserve(actors_.size());
  for (auto& [draft, frameIndex, context] : actors_) actors.push_back(finishActor(std::move(draft), scope_, *context));
  return actors;
}

}  // namespace pongsim::sdf
