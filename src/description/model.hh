#pragma once

#include <memory>
#include <string>
#include <vector>

#include "description/joint.hh"
#include "description/link.hh"
#include "description/plugin.hh"
#include "pongsim/diagnostic.hh"
#include "pongsim/files/urdf_source.hh"
#include "pongsim/types.hh"

namespace pongsim::description {

/// A `<frame>`: a name for a pose.
struct Frame {
  std::string name;
  SourcePosition position;
  Pose X_ModelFrame;
  /// Link that the frame moves with, as the model names it.
  std::string attachedLink;
  bool operator==(const Frame&) const = default;
};

/// The URDF that a model was made from, shared by all copies; null where that was SDF.
struct Urdf {
  std::shared_ptr<const UrdfSource> source;
  /// @return Whether the texts are the same.
  bool operator==(const Urdf& other) const {
    if (source == nullptr || other.source == nullptr) return source == other.source;
    return *source == *other.source;
  }
};

/// What a `<model>` says, frames resolved.
struct Model {
  std::string name;
  SourcePosition position;
  /// Pose in the frame of what holds it: the world or the model it is nested in.
  Pose X_ParentModel;
  bool isStatic = false;
  bool selfCollide = false;
  /// `<enable_wind>`
  bool isInWind = false;
  /// Name of the link that the model frame is attached to, as this model sees it ("link" or "inner::link").
  std::string canonicalLink;
  /// In front of the topics of its systems and sensors, as `InsertOptions::nameSpace`: of a model at the top level that
  /// came while the world ran.
  std::string nameSpace = {};
  std::vector<Link> links;
  std::vector<Joint> joints;
  std::vector<Frame> frames;
  std::vector<Model> models;
  std::vector<Plugin> plugins;
  Urdf urdf;
  bool operator==(const Model&) const = default;
};

}  // namespace pongsim::description
