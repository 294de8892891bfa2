#pragma once

#include <string>
#include <vector>

#include "description/model.hh"
#include "description/world.hh"
#include "pongsim/element.hh"
#include "sdf/context.hh"
#include "sdf/frames/scope.hh"
#include "sdf/readers/models/actor_reader.hh"
#include "sdf/readers/models/joint_reader.hh"
#include "sdf/readers/models/link_reader.hh"
#include "sdf/readers/worlds/light_reader.hh"
#include "sdf/text/names.hh"

namespace pongsim::sdf {

/// Reads the parts that worlds and models have in common: models, links, joints, frames, lights, actors and plugins,
/// included or not, which can refer to each other in any order. First `read` the children, then resolve the scope, then
/// `take` the parts.
class PartsReader {
 public:
  /// @param scope Scope of the world or model; must outlive this.
  /// @param isStatic Whether the parts never move.
  PartsReader(Scope& scope, bool isStatic, Context& context);

  /// Reads all such children of a world or model, or of a file's root.
  void read(const Element& holder);

  std::vector<description::Model> takeModels();
  std::vector<description::Link> takeLinks();
  std::vector<description::Joint> takeJoints();
  std::vector<description::Frame> takeFrames();
  std::vector<description::Light> takeLights();
  std::vector<description::Actor> takeActors();
  std::vector<description::Plugin> takePlugins() { return std::move(plugins_); }

 private:
  /// Where parts come from.
  struct Source {
    /// Context of their file.
    Context& context;
    /// If they belong to a model that is merged into this one: the frame that replaces its own, for its includes.
    std::string modelFrame = {};
    /// Where their file is included, for reporting name clashes with their surroundings; else null.
    const SourcePosition* includedFrom = nullptr;
  };

  void readPart(const Element& element, const Source& source);
  void readModelPart(const Element& element, const Source& source);
  void readLinkPart(const Element& element, const Source& source);
  void readJointPart(const Element& element, const Source& source);
  void readFramePart(const Element& element, const Source& source);
  void readLightPart(const Element& element, const Source& source);
  void readActorPart(const Element& element, const Source& source);
  void readInclude(const Element& include, const Source& source);
  /// @return Why the included element can't be merged; empty if it can.
  std::string obstacleToMerge(const Element& included) const;
  void readMerged(const Element& model, const Element& include, Context& context);

  template <class Part>
  struct InScope {
    Part part;
    /// Index of its frame in the scope; 0 for lights and actors, which have none.
    std::size_t frameIndex;
    /// Context of its file.
    Context* context;
  };

  Scope& scope_;
  bool isStatic_;
  Context& context_;
  bool isModel_ = false;
  bool isRoot_ = false;
  SiblingNames names_;
  std::vector<InScope<description::Model>> models_;
  std::vector<InScope<LinkDraft>> links_;
  std::vector<InScope<JointDraft>> joints_;
  std::vector<InScope<description::Frame>> frames_;
  std::vector<InScope<LightDraft>> lights_;
  std::vector<InScope<ActorDraft>> actors_;
  std::vector<description::Plugin> plugins_;
};

}  // namespace pongsim::sdf
