#pragma once

#include <string>
#include <utility>
#include <vector>

#include "description/model.hh"
#include "pongsim/element.hh"
#include "sdf/context.hh"
#include "sdf/joint_reader.hh"
#include "sdf/link_reader.hh"
#include "sdf/names.hh"
#include "sdf/scope.hh"

namespace pongsim::sdf {

/// Reads what worlds and models have in common: models, links, joints, frames and plugins, which refer to each other
/// in any order. First `read` the children, then resolve the scope, then `take` the parts.
class PartsReader {
 public:
  /// @param scope That of the world or model; must outlive this.
  /// @param isStatic What stands here never moves.
  PartsReader(Scope& scope, bool isStatic, Context& context);

  /// Reads all children of a world or model that are such parts.
  void read(const Element& holder);

  std::vector<description::Model> takeModels();
  std::vector<description::Link> takeLinks();
  std::vector<description::Joint> takeJoints();
  std::vector<description::Frame> takeFrames();
  std::vector<description::Plugin> takePlugins() { return std::move(plugins_); }

 private:
  void readModelPart(const Element& element);
  void readLinkPart(const Element& element);
  void readJointPart(const Element& element);
  void readFramePart(const Element& element);

  template <class Part>
  struct Numbered {
    Part part;
    /// In the scope.
    std::size_t entry;
  };

  Scope& scope_;
  bool isStatic_;
  Context& context_;
  SiblingNames names_;
  std::vector<Numbered<description::Model>> models_;
  std::vector<Numbered<LinkDraft>> links_;
  std::vector<Numbered<JointDraft>> joints_;
  std::vector<Numbered<description::Frame>> frames_;
  std::vector<description::Plugin> plugins_;
};

}  // namespace pongsim::sdf
