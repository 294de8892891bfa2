#pragma once

#include <cassert>
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

/// The frames named in one world or model. They can be relative to each other in any order: add all, call `resolve`
/// once, then look them up.
///
/// Defaults as in SDF 1.9: links, models and frames are relative to the scope's own frame, joints to the frame of their
/// child, and an attached frame to what it is attached to.
class Scope {
 public:
  /// @param rootName Name of the scope's own frame: "__model__" or "world".
  /// @param label For errors: "model 'robot'".
  Scope(std::string rootName, std::string label);

  /// A frame to add: that of a link, joint, model or `<frame>`.
  struct Frame {
    FrameKind kind = FrameKind::kFrame;
    std::string name;
    SourcePosition position;
    PoseText pose;
    /// What a frame is attached to, or a joint's child; empty: the scope's own frame.
    std::string attachedTo;
    SourcePosition attachedToPosition;
    /// A model's own scope, already resolved.
    std::unique_ptr<Scope> inside = nullptr;
    /// The frame inside the model that `pose` places; empty: the model's own.
    std::string placementFrame = {};
  };

  /// @return The index for looking it up.
  std::size_t add(Frame frame);

  /// Call if part of this scope could not be read: names that are missing are then no further errors.
  void setIncomplete() { isIncomplete_ = true; }

  /// Sets the link that the scope's own frame moves with: "link", "inner::link", "world"; empty: none. The default is
  /// the first link, or that of the first nested model if there is no link here, and so on.
  void setCanonicalLink(std::string link);

  /// Call if the scope's own frame is a static model's and moves with no link.
  void setStatic() { isStatic_ = true; }
  bool isStatic() const { return isStatic_; }

  /// @return The default canonical link.
  std::string firstLink() const;

  /// Computes all poses and attachments. Each fault adds an error, and the pose becomes the identity.
  void resolve(Context& context);

  struct ResolvedFrame {
    FrameKind kind = FrameKind::kFrame;
    Pose X_ScopeFrame;
    /// The link that it moves with, named as in this scope; empty if unknown.
    std::string link;
  };

  /// @param path "frame", "__model__", "inner::frame".
  std::optional<ResolvedFrame> find(std::string_view path) const;

  /// Like `find`, but adds the error "`what` 'path', which is not in model 'robot'" if nothing is found.
  std::optional<ResolvedFrame> findOrComplain(std::string_view path, const std::string& what,
                                              const SourcePosition& position, Context& context) const;

  /// @return All frames, the scope's own first.
  const std::vector<Frame>& frames() const { return frames_; }

  /// @param frame Index, as returned by `add`; 0: the scope's own frame.
  const Pose& pose(std::size_t frame) const { return resolved(frame).X_ScopeFrame; }
  const std::string& link(std::size_t frame) const { return resolved(frame).link; }
  const std::string& label() const { return label_; }

 private:
  /// A frame of this scope, or a frame inside a model of this scope.
  struct Reference {
    /// Index of the frame or model.
    std::size_t frame = 0;
    std::optional<ResolvedFrame> inside;
  };

  const ResolvedFrame& resolved(std::size_t frame) const {
    assert(frame < resolved_.size());
    return resolved_[frame];
  }
  std::optional<Reference> lookUp(std::string_view path) const;
  /// @return "did you mean 'inner::frame'?", or an empty text.
  std::string nearestPath(std::string_view path) const;
  std::optional<Reference> lookUpOrComplain(std::string_view path, const std::string& what,
                                            const SourcePosition& position, Context& context) const;
  void resolveLinks(Context& context);
  void resolvePoses(Context& context);
  void complainOfCycle(const std::vector<std::size_t>& cycle, const std::string& relation, Context& context) const;
  Pose placementOf(const Frame& frame, Context& context) const;
  std::string labelOf(const Frame& frame) const;

  std::string label_;
  std::vector<Frame> frames_;
  /// As many as `frames_`, in the same order.
  std::vector<ResolvedFrame> resolved_;
  /// What each frame is attached to, if known.
  std::vector<std::optional<Reference>> attachments_;
  std::unordered_map<std::string, std::size_t> frameOfName_;
  bool isIncomplete_ = false;
  bool isStatic_ = false;
};

}  // namespace pongsim::sdf
