#include "sdf/parts_reader.hh"

#include "sdf/model_reader.hh"
#include "sdf/plugin_reader.hh"
#include "sdf/unsimulated.hh"

namespace pongsim::sdf {

namespace {

// Links, joints, frames and models stand for frames, so no two may have the same name.
constexpr std::string_view kFrames = "frame";

}  // namespace

PartsReader::PartsReader(Scope& scope, bool isStatic, Context& context)
    : scope_(scope), isStatic_(isStatic), context_(context), names_(scope.label()) {}

void PartsReader::read(const Element& holder) {
  if (refuseIncludes(holder, context_)) scope_.setIncomplete();
  const bool isWorld = holder.name == "world";
  for (const Element& child : holder.children) {
    if (child.name == "model") readModelPart(child);
    if (child.name == "link" && !isWorld) readLinkPart(child);
    if (child.name == "joint") readJointPart(child);
    if (child.name == "frame") readFramePart(child);
    if (child.name == "plugin") plugins_.push_back(readPlugin(child, scope_.label(), context_));
  }
  warnOfUnsimulated(holder, context_);
}

void PartsReader::readModelPart(const Element& element) {
  ModelDraft draft = readModel(element, scope_.label(), isStatic_, context_);
  description::Model& model = draft.model;
  names_.claim(model.name, kFrames, element, context_);
  const std::size_t entry = scope_.add({.kind = FrameKind::kModel,
                                        .name = model.name,
                                        .position = model.position,
                                        .pose = std::move(draft.pose),
                                        .attachedTo = {},
                                        .attachedToPosition = {},
                                        .inside = std::move(draft.scope),
                                        .placementFrame = std::move(draft.placementFrame)});
  models_.push_back({std::move(model), entry});
}

void PartsReader::readLinkPart(const Element& element) {
  LinkDraft draft = readLink(element, scope_.label(), isStatic_, context_);
  names_.claim(draft.link.name, kFrames, element, context_);
  const std::size_t entry = scope_.add({.kind = FrameKind::kLink,
                                        .name = draft.link.name,
                                        .position = draft.link.position,
                                        .pose = draft.pose,
                                        .attachedTo = {},
                                        .attachedToPosition = {}});
  links_.push_back({std::move(draft), entry});
}

void PartsReader::readJointPart(const Element& element) {
  JointDraft draft = readJoint(element, scope_.label(), context_);
  names_.claim(draft.joint.name, kFrames, element, context_);
  const std::size_t entry = scope_.add({.kind = FrameKind::kJoint,
                                        .name = draft.joint.name,
                                        .position = draft.joint.position,
                                        .pose = draft.pose,
                                        .attachedTo = draft.child.name,
                                        .attachedToPosition = draft.child.position});
  joints_.push_back({std::move(draft), entry});
}

void PartsReader::readFramePart(const Element& element) {
  description::Frame frame;
  frame.name = readName(element, scope_.label(), context_);
  frame.position = element.position;
  names_.claim(frame.name, kFrames, element, context_);
  const Element::Attribute* attachedTo = element.attribute("attached_to");
  const std::size_t entry =
      scope_.add({.kind = FrameKind::kFrame,
                  .name = frame.name,
                  .position = frame.position,
                  .pose = readPose(element, context_),
                  .attachedTo = attachedTo != nullptr ? attachedTo->value : "",
                  .attachedToPosition = attachedTo != nullptr ? attachedTo->position : frame.position});
  frames_.push_back({std::move(frame), entry});
}

std::vector<description::Model> PartsReader::takeModels() {
  std::vector<description::Model> models;
  models.reserve(models_.size());
  for (auto& [model, entry] : models_) {
    model.X_ParentModel = scope_.pose(entry);
    models.push_back(std::move(model));
  }
  return models;
}

std::vector<description::Link> PartsReader::takeLinks() {
  std::vector<description::Link> links;
  links.reserve(links_.size());
  for (auto& [draft, entry] : links_) links.push_back(finishLink(std::move(draft), scope_, entry, context_));
  return links;
}

std::vector<description::Joint> PartsReader::takeJoints() {
  std::vector<description::Joint> joints;
  joints.reserve(joints_.size());
  for (auto& [draft, entry] : joints_) joints.push_back(finishJoint(std::move(draft), scope_, entry, context_));
  return joints;
}

std::vector<description::Frame> PartsReader::takeFrames() {
  std::vector<description::Frame> frames;
  frames.reserve(frames_.size());
  for (auto& [frame, entry] : frames_) {
    frame.X_ModelFrame = scope_.pose(entry);
    frame.attachedLink = scope_.link(entry);
    frames.push_back(std::move(frame));
  }
  return frames;
}

}  // namespace pongsim::sdf
