#pragma once

#include <string>
#include <vector>

#include "description/model.hh"
#include "description/world.hh"
#include "pongsim/element.hh"
#include "sdf/context.hh"
#include "sdf/frames/scope.hh"
#include "sdf/readers/actor_reader.hh"
#include "sdf/readers/joint_reader.hh"
#include "sdf/readers/light_reader.hh"
#include "sdf/readers/link_reader.hh"
#include "sdf/text/names.hh"

namespace pongsim::sdf {

/// Reads what worlds and models have in common: models, links, joints, frames, lights, actors and plugins, their own
/// and included ones, which refer to each other in any order. First `read` the children, then resolve the scope, then
/// `take` the parts.
class PartsReader {
 public:
  /// @param scope That of the world or model; must outlive this.
  /// @param isStatic What stands here never moves.
  PartsReader(Scope& scope, bool isStatic, Context& context);

  /// Reads all children of a world or model, or of a file's root, that are such parts.
  void read(const Element& holder);

  std::vector<description::Model> takeModels();
  std::vector<description::Link> takeLinks();
  std::vector<description::Joint> takeJoints();
  std::vector<description::Frame> takeFrames();
  std::vector<description::Light> takeLights();
  std::vector<description::Actor> takeActors();
  std::vector<description::Plugin> takePlugins() { return std::move(plugins_); }

 private:
  /// Whose parts are read.
  struct Source {
    /// That of the file that they stand in.
    Context& context;
    /// Of a model whose parts are merged into this one: the frame that stands for its own, for what it includes.
    std::string modelFrame = {};
    /// Where the file is included, to tell of clashes with what stands around it; else null.
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
  void readMerged(const Element& model, const Element& include, Context& context);

  template <class Part>
  struct Read {
    Part part;
    /// Number in the scope.
    std::size_t entry;
    /// That of its file.
    Context* context;
  };

  Scope& scope_;
  bool isStatic_;
  Context& context_;
  bool isModel_ = false;
  SiblingNames names_;
  std::vector<Read<description::Model>> models_;
  std::vector<Read<LinkDraft>> links_;
  std::vector<Read<JointDraft>> joints_;
  std::vector<Read<description::Frame>> frames_;
  std::vector<Read<LightDraft>> lights_;
  std::vector<Read<ActorDraft>> actors_;
  std::vector<description::Plugin> plugins_;
};

}  // namespace pongsim::sdf
