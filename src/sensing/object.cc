#include "sensing/object.hh"

#include <optional>

namespace pongsim::sensing {

void Object::place(const Pose& X_WorldLinkNow) {
  X_WorldLink = X_WorldLinkNow;
  const Pose X_WorldObject = X_WorldLink * X_LinkObject;
  position = X_WorldObject.position;
  M_ObjectWorld = scale.cwiseInverse().asDiagonal() * X_WorldObject.rotation.toRotationMatrix().transpose();
}

Eigen::AlignedBox3d Object::boundsInWorld() const {
  const Matrix3 rotation = (X_WorldLink.rotation * X_LinkObject.rotation).toRotationMatrix();
  const Matrix3 M_WorldObject = rotation * scale.asDiagonal();
  const Vector3 middle = position + M_WorldObject * bounds.center();
  const Vector3 half = M_WorldObject.cwiseAbs() * bounds.sizes() / 2;
  return {middle - half, middle + half};
}

double Object::firstSeenOn(const Line& world, double from, double to) const {
  const Line line{M_ObjectWorld * (world.origin - position), M_ObjectWorld * world.direction};
  if (const auto* mesh = std::get_if<const Mesh*>(&body)) return (*mesh)->firstHit(line, from, to, seesInside);
  const std::optional<Passage> found = passage(*std::get_if<Shape>(&body), line);
  return found ? firstSeen(*found, from, seesInside) : kNowhere;
}

}  // namespace pongsim::sensing
