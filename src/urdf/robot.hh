#pragma once

#include <urdf_model/model.h>

#include <cstddef>
#include <optional>
#include <string>
#include <vector>

#include "pongsim/element.hh"
#include "pongsim/types.hh"

namespace pongsim::urdf {

/// Mass and inertia in a link's frame.
struct Inertial {
  double mass = 0;
  Vector3 com = Vector3::Zero();
  /// About the centre of mass, along the axes of the link.
  Matrix3 moments = Matrix3::Zero();
  SourcePosition position;
};

/// A `<collision>` or `<visual>`.
struct Shape {
  /// As in the file; may be empty.
  std::string name;
  /// The link that it belongs to in the file, even if that link becomes part of another.
  std::string ownLink;
  const Element* xml = nullptr;
  Pose X_LinkShape;
  ::urdf::GeometrySharedPtr geometry;
  /// Visuals only; may be null.
  ::urdf::MaterialSharedPtr material;
};

/// The connection of a link to its parent.
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
  std::vector<Shape> collisions;
  std::vector<Shape> visuals;
  /// Nothing for the root.
  std::optional<Joint> joint;
  /// Set by `lumpFixedJoints`: which link this one has become part of, and which links have become part of it.
  std::optional<Lumped> lumpedInto;
  std::vector<Lumped> lumped;
};

struct Robot {
  const Element* xml = nullptr;
  /// From the root down, each link before its descendants; siblings sorted by their joints' names.
  std::vector<Link> links;
};

/// @param robot The `<robot>` that the model was read from; must outlive the result.
Robot robotFrom(const ::urdf::ModelInterface& model, const Element& robot);

/// @return Position of the child; if there is none, that of the part.
const SourcePosition& positionIn(const Element& part, std::string_view child);

}  // namespace pongsim::urdf
