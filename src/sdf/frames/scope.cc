#include "sdf/frames/scope.hh"

#include <cassert>
#include <utility>

#include "base/nearest_word.hh"
#include "sdf/frames/frame_graph.hh"
#include "sdf/text/names.hh"
#include "sdf/text/values.hh"

namespace pongsim::sdf {

namespace {

// Of a longer cycle, a message names only this many frames.
constexpr std::size_t kLongestCyclePrinted = 8;

std::string_view kindName(FrameKind kind) {
  switch (kind) {
    case FrameKind::kLink:
      return "link";
    case FrameKind::kJoint:
      return "joint";
    case FrameKind::kModel:
      return "model";
    default:
      return "frame";
  }
}

std::string joined(const std::string& model, const std::string& link) {
  return link.empty() ? std::string() : model + std::string(kNameSeparator) + link;
}

}  // namespace

Scope::Scope(std::string rootName, std::string label) : label_(std::move(label)) {
  Frame root;
  root.kind = FrameKind::kRoot;
  root.name = std::move(rootName);
  add(std::move(root));
}

std::size_t Scope::add(Frame frame) {
  const std::size_t index = frames_.size();
  if (!frame.name.empty()) frameOfName_.try_emplace(frame.name, index);
  frames_.push_back(std::move(frame));
  resolved_.push_back({frames_.back().kind, {}, {}});
  return index;
}

void Scope::setCanonicalLink(std::string link) { resolved_[0].link = std::move(link); }

std::string Scope::firstLink() const {
  for (const Frame& frame : frames_) {
    if (frame.kind == FrameKind::kLink && !frame.name.empty()) return frame.name;
  }
  for (const Frame& frame : frames_) {
    if (frame.inside == nullptr || frame.name.empty()) continue;
    std::string link = joined(frame.name, frame.inside->firstLink());
    if (!link.empty()) return link;
  }
  return {};
}

void Scope::resolve(Context& context) {
  assert(resolved_.size() == frames_.size());
  if (resolved_[0].link.empty()) resolved_[0].link = firstLink();
  resolveLinks(context);
  resolvePoses(context);
}

std::string Scope::labelOf(const Frame& frame) const {
  return std::string(kindName(frame.kind)) + " '" + frame.name + "'";
}

std::optional<Scope::Reference> Scope::lookUp(std::string_view path) const {
  if (const auto local = frameOfName_.find(std::string(path)); local != frameOfName_.end()) {
    return Reference{local->second, std::nullopt};
  }
  // Before SDF 1.8 the model's name may contain the separator itself.
  for (std::size_t at = path.find(kNameSeparator); at != std::string_view::npos;
       at = path.find(kNameSeparator, at + 1)) {
    const auto model = frameOfName_.find(std::string(path.substr(0, at)));
    if (model == frameOfName_.end() || frames_[model->second].inside == nullptr) continue;
    std::optional<ResolvedFrame> inside = frames_[model->second].inside->find(path.substr(at + kNameSeparator.size()));
    if (!inside) continue;
    inside->link = joined(frames_[model->second].name, inside->link);
    return Reference{model->second, std::move(inside)};
  }
  return std::nullopt;
}

std::string Scope::nearestPath(std::string_view path) const {
  std::vector<std::string> paths;
  for (const Frame& frame : frames_) {
    paths.push_back(frame.name);
    // inside the model that the path starts with
    const bool isInside = frame.inside != nullptr && path.starts_with(frame.name) &&
                          path.substr(frame.name.size()).starts_with(kNameSeparator);
    if (!isInside) continue;
    for (const Frame& inner : frame.inside->frames_) paths.push_back(joined(frame.name, inner.name));
  }
  const std::vector<std::string_view> known(paths.begin(), paths.end());
  return base::didYouMean(path, known);
}

std::optional<Scope::Reference> Scope::lookUpOrComplain(std::string_view path, const std::string& what,
                                                        const SourcePosition& position, Context& context) const {
  std::optional<Reference> reference = lookUp(path);
  if (reference || isIncomplete_) return reference;
  std::string hint;
  if (path == "__root__") {
    hint = "__root__ can't be used; the frame of a world is 'world'";
  } else if (context.searchesLeft > 0) {
    --context.searchesLeft;
    hint = nearestPath(path);
  }
  if (hint.empty() && path == "world") hint = "a model can't refer to the frame of its world";
  context.diagnostics.error(position, what + " '" + std::string(path) + "', which is not in " + label_,
                            std::move(hint));
  return std::nullopt;
}

std::optional<Scope::ResolvedFrame> Scope::find(std::string_view path) const {
  const std::optional<Reference> reference = lookUp(path);
  if (!reference) return std::nullopt;
  const ResolvedFrame& frame = resolved_[reference->frame];
  if (!reference->inside) return frame;
  const ResolvedFrame& inside = *reference->inside;
  return ResolvedFrame{inside.kind, frame.X_ScopeFrame * inside.X_ScopeFrame, inside.link};
}

std::optional<Scope::ResolvedFrame> Scope::findOrComplain(std::string_view path, const std::string& what,
                                                          const SourcePosition& position, Context& context) const {
  return lookUpOrComplain(path, what, position, context) ? find(path) : std::nullopt;
}

void Scope::resolveLinks(Context& context) {
  attachments_.resize(frames_.size());
  std::vector<std::size_t> next(frames_.size(), kNoNode);
  for (std::size_t i = 1; i < frames_.size(); ++i) {
    const Frame& frame = frames_[i];
    if (frame.kind == FrameKind::kLink) {
      resolved_[i].link = frame.name;
    } else if (frame.kind == FrameKind::kModel) {
      if (frame.inside != nullptr) resolved_[i].link = joined(frame.name, frame.inside->link(0));
    } else if (frame.attachedTo.empty()) {
      // a joint without a child has been reported already
      if (frame.kind == FrameKind::kFrame) next[i] = 0;
    } else {
      const std::string verb = frame.kind == FrameKind::kJoint ? " names child link" : " is attached to";
      attachments_[i] = lookUpOrComplain(frame.attachedTo, labelOf(frame) + verb, frame.attachedToPosition, context);
      if (!attachments_[i]) continue;
      if (attachments_[i]->inside) {
        resolved_[i].link = attachments_[i]->inside->link;
      } else {
        next[i] = attachments_[i]->frame;
      }
    }
  }

  const FrameOrder order = orderFrames(next);
  for (const std::size_t i : order.order) {
    if (next[i] != kNoNode) resolved_[i].link = resolved_[next[i]].link;
  }
  for (const std::vector<std::size_t>& cycle : order.cycles) {
    complainOfCycle(cycle, "attached to", context);
    // a cycle of attachments would be a cycle of poses too: report it only once
    for (const std::size_t i : cycle) attachments_[i].reset();
  }
}

void Scope::resolvePoses(Context& context) {
  std::vector<std::optional<Reference>> references(frames_.size());
  std::vector<std::size_t> next(frames_.size(), kNoNode);
  for (std::size_t i = 1; i < frames_.size(); ++i) {
    const Frame& frame = frames_[i];
    if (!frame.pose.relativeTo.empty()) {
      references[i] = lookUpOrComplain(frame.pose.relativeTo, "the pose of " + labelOf(frame) + " is relative to",
                                       frame.pose.position, context);
    } else {
      references[i] = attachments_[i];
    }
    next[i] = references[i] ? references[i]->frame : 0;
  }

  const FrameOrder order = orderFrames(next);
  for (const std::size_t i : order.order) {
    if (i == 0) continue;
    Pose X_ScopeReference = resolved_[next[i]].X_ScopeFrame;
    if (references[i] && references[i]->inside)
      X_ScopeReference = X_ScopeReference * references[i]->inside->X_ScopeFrame;
    const Pose X_ScopeFrame = X_ScopeReference * frames_[i].pose.value * placementOf(frames_[i], context);
    if (X_ScopeFrame.position.cwiseAbs().maxCoeff() <= kLargestPosition && X_ScopeFrame.rotation.coeffs().allFinite()) {
      resolved_[i].X_ScopeFrame = X_ScopeFrame;
    } else {
      context.diagnostics.error(frames_[i].pose.position,
                                labelOf(frames_[i]) + " is too far from the origin: more than 1e9 m");
    }
  }
  for (const std::vector<std::size_t>& cycle : order.cycles) complainOfCycle(cycle, "relative to", context);
}

Pose Scope::placementOf(const Frame& frame, Context& context) const {
  if (frame.placementFrame.empty() || frame.inside == nullptr) return {};
  const std::optional<ResolvedFrame> placed = frame.inside->findOrComplain(
      frame.placementFrame, labelOf(frame) + " is placed by its frame", frame.position, context);
  return placed ? placed->X_ScopeFrame.inverse() : Pose();
}

void Scope::complainOfCycle(const std::vector<std::size_t>& cycle, const std::string& relation,
                            Context& context) const {
  const Frame& first = frames_[cycle.front()];
  std::string message = labelOf(first) + " is " + relation + " ";
  if (cycle.size() == 1) {
    message += "itself";
  } else {
    for (std::size_t i = 1; i < cycle.size() && i < kLongestCyclePrinted; ++i) {
      message += "'" + frames_[cycle[i]].name + "', which is " + relation + " ";
    }
    if (cycle.size() > kLongestCyclePrinted) {
      message += "(" + std::to_string(cycle.size() - kLongestCyclePrinted) + " more and) ";
    }
    message += "'" + first.name + "'";
  }
  const bool isPose = relation == "relative to";
  context.diagnostics.error(isPose ? first.pose.position : first.attachedToPosition, std::move(message),
                            "one of them must refer to another frame");
}

}  // namespace pongsim::sdf
