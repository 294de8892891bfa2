#pragma once

#include <urdf_model/model.h>

#include <cstddef>
#include <optional>
#include <string>
#include <vector>

#include "pongsim/element.hh"
#include "pongsim/types.hh"

namespace pongsim::urdf {

/// Mass and how it is spread, in the frame of a link.
struct Inertial {
  double mass = 0;
  Vector3 com = Vector3::Zero();
  /// About the centre of mass, along the axes of the link.
  Matrix3 moments = Matrix3::Zero();
  SourcePosition position;
};

/// A `<collision>` or `<visual>`.
struct Part {
  /// As the file gives it, perhaps empty.
  std::string name;
  /// The link that it stands in, whatever becomes of that link.
  std::string ownLink;
  const Element* xml = nullptr;
  Pose X_LinkPart;
  ::urdf::GeometrySharedPtr geometry;
  /// Of a visual, perhaps null.
  ::urdf::MaterialSharedPtr material;
};

/// What ties a link to its parent.
struct Joint {
  const Element* xml = nullptr;
  ::urdf::JointSharedPtr urdf;
  std::size_t parent = 0;
  Pose X_ParentJoint;
};

/// A link that has become part of another one.
struct Lumped {
  std::size_t link = 0;
  Pose X_TargetLink;
};

struct Link {
  std::string name;
  const Element* xml = nullptr;
  std::optional<Inertial> inertial;
  std::vector<Part> collisions;
  std::vector<Part> visuals;
  /// Nothing for the root.
  std::optional<Joint> joint;
  /// Filled by `lumpFixedJoints`: where the link has gone, and which have come.
  std::optional<Lumped> lumpedInto;
  std::vector<Lumped> lumped;
};

struct Robot {
  const Element* xml = nullptr;
  /// From the root down, each link before what hangs on it; brothers in the order of their joints' names.
  std::vector<Link> links;
};

/// @param robot The `<robot>` that the model was read from; must outlive the result.
Robot robotFrom(const ::urdf::ModelInterface& model, const Element& robot);

/// @return Where the child stands; where the part does, if it has no such child.
const SourcePosition& positionIn(const Element& part, std::string_view child);

}  // namespace pongsim::urdf
