#include "sdf/frames/scope.hh"

#include <utility>

#include "base/nearest_word.hh"
#include "sdf/frames/frame_graph.hh"
#include "sdf/text/names.hh"
#include "sdf/text/values.hh"

namespace pongsim::sdf {

namespace {

// Longer cycles are printed in part.
constexpr std::size_t kLongestCycleTold = 8;

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
  Entry root;
  root.kind = FrameKind::kRoot;
  root.name = std::move(rootName);
  add(std::move(root));
}

std::size_t Scope::add(Entry entry) {
  const std::size_t index = entries_.size();
  if (!entry.name.empty()) entryOfName_.try_emplace(entry.name, index);
  entries_.push_back(std::move(entry));
  resolved_.emplace_back();
  return index;
}

void Scope::setCanonicalLink(std::string link) { resolved_[0].link = std::move(link); }

std::string Scope::firstLink() const {
  for (const Entry& entry : entries_) {
    if (entry.kind == FrameKind::kLink && !entry.name.empty()) return entry.name;
  }
  for (const Entry& entry : entries_) {
    if (entry.inside == nullptr || entry.name.empty()) continue;
    std::string link = joined(entry.name, entry.inside->firstLink());
    if (!link.empty()) return link;
  }
  return {};
}

void Scope::resolve(Context& context) {
  if (resolved_[0].link.empty()) resolved_[0].link = firstLink();
  resolveLinks(context);
  resolvePoses(context);
}

std::string Scope::labelOf(const Entry& entry) const {
  return std::string(kindName(entry.kind)) + " '" + entry.name + "'";
}

std::optional<Scope::Reference> Scope::lookUp(std::string_view path) const {
  if (const auto local = entryOfName_.find(std::string(path)); local != entryOfName_.end()) {
    return Reference{local->second, std::nullopt};
  }
  // Before SDF 1.8 the model's name may contain the separator itself.
  for (std::size_t at = path.find(kNameSeparator); at != std::string_view::npos;
       at = path.find(kNameSeparator, at + 1)) {
    const auto model = entryOfName_.find(std::string(path.substr(0, at)));
    if (model == entryOfName_.end() || entries_[model->second].inside == nullptr) continue;
    std::optional<Found> inside = entries_[model->second].inside->find(path.substr(at + kNameSeparator.size()));
    if (!inside) continue;
    inside->link = joined(entries_[model->second].name, inside->link);
    return Reference{model->second, std::move(inside)};
  }
  return std::nullopt;
}

std::string Scope::nearestPath(std::string_view path) const {
  std::vector<std::string> paths;
  for (const Entry& entry : entries_) {
    paths.push_back(entry.name);
    // inside the entry that the path starts with
    const bool isInside = entry.inside != nullptr && path.starts_with(entry.name) &&
                          path.substr(entry.name.size()).starts_with(kNameSeparator);
    if (!isInside) continue;
    for (const Entry& inner : entry.inside->entries_) paths.push_back(joined(entry.name, inner.name));
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

std::optional<Scope::Found> Scope::find(std::string_view path) const {
  const std::optional<Reference> reference = lookUp(path);
  if (!reference) return std::nullopt;
  const Resolved& entry = resolved_[reference->entry];
  if (!reference->inside) return Found{entries_[reference->entry].kind, entry.X_ScopeFrame, entry.link};
  const Found& inside = *reference->inside;
  return Found{inside.kind, entry.X_ScopeFrame * inside.X_ScopeFrame, inside.link};
}

std::optional<Scope::Found> Scope::findOrComplain(std::string_view path, const std::string& what,
                                                  const SourcePosition& position, Context& context) const {
  return lookUpOrComplain(path, what, position, context) ? find(path) : std::nullopt;
}

void Scope::resolveLinks(Context& context) {
  attachments_.resize(entries_.size());
  std::vector<std::size_t> next(entries_.size(), kNoNode);
  for (std::size_t i = 1; i < entries_.size(); ++i) {
    const Entry& entry = entries_[i];
    if (entry.kind == FrameKind::kLink) {
      resolved_[i].link = entry.name;
    } else if (entry.kind == FrameKind::kModel) {
      if (entry.inside != nullptr) resolved_[i].link = joined(entry.name, entry.inside->link(0));
    } else if (entry.attachedTo.empty()) {
      // a joint without a child has been reported already
      if (entry.kind == FrameKind::kFrame) next[i] = 0;
    } else {
      const std::string verb = entry.kind == FrameKind::kJoint ? " names child link" : " is attached to";
      attachments_[i] = lookUpOrComplain(entry.attachedTo, labelOf(entry) + verb, entry.attachedToPosition, context);
      if (!attachments_[i]) continue;
      if (attachments_[i]->inside) {
        resolved_[i].link = attachments_[i]->inside->link;
      } else {
        next[i] = attachments_[i]->entry;
      }
    }
  }

  const FrameOrder frames = orderFrames(next);
  for (const std::size_t i : frames.order) {
    if (next[i] != kNoNode) resolved_[i].link = resolved_[next[i]].link;
  }
  for (const std::vector<std::size_t>& cycle : frames.cycles) {
    complainOfCycle(cycle, "attached to", context);
    // do not report the same cycle again for the poses
    for (const std::size_t i : cycle) attachments_[i].reset();
  }
}

void Scope::resolvePoses(Context& context) {
  std::vector<std::optional<Reference>> references(entries_.size());
  std::vector<std::size_t> next(entries_.size(), kNoNode);
  for (std::size_t i = 1; i < entries_.size(); ++i) {
    const Entry& entry = entries_[i];
    if (!entry.pose.relativeTo.empty()) {
      references[i] = lookUpOrComplain(entry.pose.relativeTo, "the pose of " + labelOf(entry) + " is relative to",
                                       entry.pose.position, context);
    } else {
      references[i] = attachments_[i];
    }
    next[i] = references[i] ? references[i]->entry : 0;
  }

  const FrameOrder frames = orderFrames(next);
  for (const std::size_t i : frames.order) {
    if (i == 0) continue;
    Pose X_ScopeReference = resolved_[next[i]].X_ScopeFrame;
    if (references[i] && references[i]->inside)
      X_ScopeReference = X_ScopeReference * references[i]->inside->X_ScopeFrame;
    const Pose X_ScopeFrame = X_ScopeReference * entries_[i].pose.value * placementOf(entries_[i], context);
    if (X_ScopeFrame.position.cwiseAbs().maxCoeff() <= kLargestPosition && X_ScopeFrame.rotation.coeffs().allFinite()) {
      resolved_[i].X_ScopeFrame = X_ScopeFrame;
    } else {
      context.diagnostics.error(entries_[i].pose.position,
                                labelOf(entries_[i]) + " is too far from the origin: more than 1e9 m");
    }
  }
  for (const std::vector<std::size_t>& cycle : frames.cycles) complainOfCycle(cycle, "relative to", context);
}

Pose Scope::placementOf(const Entry& entry, Context& context) const {
  if (entry.placementFrame.empty() || entry.inside == nullptr) return {};
  const std::optional<Found> frame = entry.inside->findOrComplain(
      entry.placementFrame, labelOf(entry) + " is placed by its frame", entry.position, context);
  return frame ? frame->X_ScopeFrame.inverse() : Pose();
}

void Scope::complainOfCycle(const std::vector<std::size_t>& cycle, const std::string& relation,
                            Context& context) const {
  const Entry& first = entries_[cycle.front()];
  std::string message = labelOf(first) + " is " + relation + " ";
  if (cycle.size() == 1) {
    message += "itself";
  } else {
    for (std::size_t i = 1; i < cycle.size() && i < kLongestCycleTold; ++i) {
      message += "'" + entries_[cycle[i]].name + "', which is " + relation + " ";
    }
    if (cycle.size() > kLongestCycleTold) {
      message += "(" + std::to_string(cycle.size() - kLongestCycleTold) + " more and) ";
    }
    message += "'" + first.name + "'";
  }
  const bool isPose = relation == "relative to";
  context.diagnostics.error(isPose ? first.pose.position : first.attachedToPosition, std::move(message),
                            "one of them must refer to another frame");
}

}  // namespace pongsim::sdf
