#pragma once

#include <cstdint>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "description/joint.hh"
#include "description/link.hh"
#include "description/plugin.hh"
#include "pongsim/diagnostic.hh"
#include "pongsim/files/urdf_source.hh"
#include "pongsim/semantics.hh"
#include "pongsim/types.hh"

namespace pongsim::description {

/// A `<frame>`: a named pose.
struct Frame {
  std::string name;
  SourcePosition position;
  Pose X_ModelFrame;
  /// Link that the frame moves with, named relative to the model.
  std::string attachedLink;
  bool operator==(const Frame&) const = default;
};

/// The URDF that a model was converted from, shared by all copies; null if it was SDF.
struct Urdf {
  std::shared_ptr<const UrdfSource> source;
  /// @return Whether the texts are the same.
  bool operator==(const Urdf& other) const {
    if (source == nullptr || other.source == nullptr) return source == other.source;
    return *source == *other.source;
  }
};

/// A `<model>`, with resolved frames.
struct Model {
  std::string name;
  SourcePosition position;
  /// Pose in the frame of its parent: the world or the enclosing model.
  Pose X_ParentModel;
  bool isStatic = false;
  bool selfCollide = false;
  /// `<enable_wind>`
  bool isInWind = false;
  /// Link that the model frame is attached to, named relative to this model ("link" or "inner::link").
  std::string canonicalLink;
  /// Prefix for the topics of its systems and sensors, see `InsertOptions::nameSpace`: for top-level models inserted at
  /// run time.
  std::string nameSpace = {};
  std::vector<Link> links;
  std::vector<Joint> joints;
  std::vector<Frame> frames;
  std::vector<Model> models;
  std::vector<Plugin> plugins;
  /// Of its visuals and nested models that have none of their own, from the system `label` in it.
  std::optional<std::uint8_t> label = {};
  Semantics semantics = {};
  Urdf urdf;
  bool operator==(const Model&) const = default;
};

}  // namespace pongsim::description
