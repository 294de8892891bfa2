#pragma once

#include <cstddef>
#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <unordered_map>
#include <vector>

#include "pongsim/diagnostic.hh"
#include "pongsim/types.hh"
#include "sdf/context.hh"
#include "sdf/text/values.hh"

namespace pongsim::sdf {

enum class FrameKind { kRoot, kLink, kJoint, kFrame, kModel };

/// The frames that one world or model names, which may be measured in each other in any order. Add them all, then
/// `resolve` once, then ask.
///
/// Defaults, as SDF 1.9 has them: links, models and frames are measured in the scope's own frame, joints in the frame
/// of their child, a frame that is attached to something in the frame of that.
class Scope {
 public:
  /// @param rootName Name of the scope's own frame: "__model__" or "world".
  /// @param label For errors: "model 'robot'".
  Scope(std::string rootName, std::string label);

  struct Entry {
    FrameKind kind = FrameKind::kFrame;
    std::string name;
    SourcePosition position;
    PoseText pose;
    /// What a frame is attached to, or a joint's child; empty: the scope's own frame.
    std::string attachedTo;
    SourcePosition attachedToPosition;
    /// A model's own scope, resolved already.
    std::unique_ptr<Scope> inside = nullptr;
    /// The frame inside the model that `pose` is the pose of, if not the model's own.
    std::string placementFrame = {};
  };

  /// @return The number by which to ask for it.
  std::size_t add(Entry entry);

  /// Something of this scope could not be read, so that a name which is missing is no error of its own.
  void setIncomplete() { isIncomplete_ = true; }

  /// The link that the scope's own frame moves with: "link", "inner::link", "world"; empty where there is none.
  /// Without a call: the first link, of the first model inside if there is none here, and so on.
  void setCanonicalLink(std::string link);

  /// The scope's own frame is a static model's: it moves with no link.
  void setStatic() { isStatic_ = true; }
  bool isStatic() const { return isStatic_; }

  /// @return The canonical link by default.
  std::string firstLink() const;

  /// Finds all poses and attachments. What is wrong with them is an error each, and their pose the identity.
  void resolve(Context& context);

  /// What a name stands for.
  struct Found {
    FrameKind kind = FrameKind::kFrame;
    Pose X_ScopeFrame;
    /// The link that it moves with, as this scope names it; empty if it is not known.
    std::string link;
  };

  /// @param path "frame", "__model__", "inner::frame".
  std::optional<Found> find(std::string_view path) const;

  /// As `find`; where there is none, adds the error "`what` 'path', which is not in model 'robot'".
  std::optional<Found> findOrComplain(std::string_view path, const std::string& what, const SourcePosition& position,
                                      Context& context) const;

  /// @return All that was added, the scope's own frame first.
  const std::vector<Entry>& entries() const { return entries_; }

  const Pose& pose(std::size_t entry) const { return resolved_[entry].X_ScopeFrame; }
  const std::string& link(std::size_t entry) const { return resolved_[entry].link; }
  const std::string& label() const { return label_; }

 private:
  struct Resolved {
    Pose X_ScopeFrame;
    std::string link;
  };
  /// An entry of this scope, or something inside the model that an entry is.
  struct Reference {
    std::size_t entry = 0;
    std::optional<Found> inside;
  };

  std::optional<Reference> lookUp(std::string_view path) const;
  /// @return "did you mean 'inner::frame'?", or an empty text.
  std::string nearestPath(std::string_view path) const;
  std::optional<Reference> lookUpOrComplain(std::string_view path, const std::string& what,
                                            const SourcePosition& position, Context& context) const;
  void resolveLinks(Context& context);
  void resolvePoses(Context& context);
  void complainOfCycle(const std::vector<std::size_t>& cycle, const std::string& relation, Context& context) const;
  Pose placementOf(const Entry& entry, Context& context) const;
  std::string labelOf(const Entry& entry) const;

  std::string label_;
  std::vector<Entry> entries_;
  std::vector<Resolved> resolved_;
  /// For each entry what it is attached to, if that is known.
  std::vector<std::optional<Reference>> attachments_;
  std::unordered_map<std::string, std::size_t> entryOfName_;
  bool isIncomplete_ = false;
  bool isStatic_ = false;
};

}  // namespace pongsim::sdf
