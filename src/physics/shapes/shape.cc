#include "physics/shapes/shape.hh"

#include <BulletCollision/CollisionShapes/btCompoundShape.h>
#include <BulletCollision/CollisionShapes/btEmptyShape.h>

#include <algorithm>
#include <cassert>
#include <cmath>
#include <utility>
#include <variant>

#include "physics/convert.hh"
#include "physics/shapes/mesh_shape.hh"

namespace pongsim::physics {

namespace {

/// @return The triangles of a mesh-like shape and their scale; null for other shapes.
std::pair<const description::TriangleMesh*, Vector3> trianglesOf(const description::Geometry& geometry) {
  if (const auto* mesh = std::get_if<description::Mesh>(&geometry)) return {mesh->triangles.get(), mesh->scale};
  if (const auto* map = std::get_if<description::Heightmap>(&geometry)) return {map->triangles.get(), {1, 1, 1}};
  if (const auto* line = std::get_if<description::Polyline>(&geometry)) return {line->triangles.get(), {1, 1, 1}};
  return {nullptr, {1, 1, 1}};
}

}  // namespace

bool usesHulls(const description::Geometry& geometry, bool moves) {
  if (const auto* mesh = std::get_if<description::Mesh>(&geometry)) {
    return mesh->triangles != nullptr && (moves || mesh->optimization != description::MeshOptimization::kNone);
  }
  return moves && trianglesOf(geometry).first != nullptr;
}

LinkShape::LinkShape(const description::Link& link, const Pose& X_BodyLink, bool moves, HullStore& hulls,
                     SharedShapes& shared) {
  for (const description::Collision& collision : link.collisions) {
    surfacesOfParts_.push_back(shared.surface(collision.surface));
    const description::Surface& surface = *surfacesOfParts_.back();
    collisions_.push_back({&surface, surface.slip1, surface.slip2, (X_BodyLink * collision.X_LinkCollision).rotation});
  }
  build(link, X_BodyLink, moves, hulls, shared);
}

void LinkShape::reshape(const description::Link& link, const Pose& X_BodyLink, bool moves, HullStore& hulls,
                        SharedShapes& shared) {
  assert(link.collisions.size() == collisions_.size());
  holder_.reset();
  parts_.clear();
  owned_.clear();
  surfaces_.clear();
  build(link, X_BodyLink, moves, hulls, shared);
}

// makes the shapes of all collisions
void LinkShape::build(const description::Link& link, const Pose& X_BodyLink, bool moves, HullStore& hulls,
                      SharedShapes& shared) {
  std::vector<Pose> poses;
  for (std::size_t i = 0; i < link.collisions.size(); ++i) {
    const description::Collision& collision = link.collisions[i];
    const Pose X_BodyCollision = X_BodyLink * collision.X_LinkCollision;
    const description::Surface& surface = *surfacesOfParts_[i];
    int piece = 0;
    const auto add = [&](btCollisionShape* shape, const Pose& X_BodyPart) {
      parts_.push_back(shape);
      poses.push_back(X_BodyPart);
    };
    const auto addOwn = [&](btCollisionShape* shape, const Pose& X_BodyPart) {
      if (shape == nullptr) return;
      shape->setUserPointer(const_cast<description::Surface*>(&surface));
      shape->setUserIndex(static_cast<int>(i));
      shape->setUserIndex2(piece++);
      add(shape, X_BodyPart);
    };
    const auto [triangles, scale] = trianglesOf(collision.geometry);
    if (usesHulls(collision.geometry, moves)) {
      for (const Hull& hull : hulls.find(requestFor(collision.geometry))) {
        owned_.push_back(makeShape(hull));
        addOwn(owned_.back().get(), X_BodyCollision);
      }
    } else if (triangles != nullptr) {
      surfaces_.push_back(std::make_unique<TriangleSurface>(*triangles, scale, X_BodyCollision));
      addOwn(surfaces_.back()->shape(), Pose());
    } else if (auto shape = shared.shape(collision.geometry, surface, static_cast<int>(i))) {
      add(shape.get(), X_BodyCollision);
      owned_.push_back(std::move(shape));
    }
  }
  assemble(poses);
}

// makes one shape of all parts
void LinkShape::assemble(const std::vector<Pose>& poses) {
  if (parts_.empty()) {
    holder_ = std::make_unique<btEmptyShape>();
    root_ = holder_.get();
    return;
  }

  // a single part in the body's own pose needs no compound
  const bool inPlace = poses[0].position.isZero(0) && poses[0].rotation.vec().isZero(0);
  if (parts_.size() == 1 && inPlace) {
    root_ = parts_[0];
    return;
  }
  auto compound = std::make_unique<btCompoundShape>(true, static_cast<int>(parts_.size()));
  for (std::size_t i = 0; i < parts_.size(); ++i) compound->addChildShape(toBullet(poses[i]), parts_[i]);
  holder_ = std::move(compound);
  root_ = holder_.get();
}

LinkShape::Feel LinkShape::feel(std::size_t collision) const {
  const description::Surface& surface = *collisions_[collision].surface;
  return {surface.mu, surface.mu2, surface.restitution};
}

void LinkShape::setFeel(std::size_t collision, const Feel& feel, btCollisionObject& body) {
  Part& part = collisions_[collision];
  description::Surface surface = *part.surface;
  surface.mu = feel.mu;
  surface.mu2 = feel.mu2;
  surface.restitution = feel.restitution;
  part.changed = std::make_shared<const description::Surface>(std::move(surface));
  part.surface = part.changed.get();
  body.setUserIndex2(kChanged);
}

void LinkShape::transfer(StateArchive& archive, btCollisionObject& body) {
  for (std::size_t i = 0; i < collisions_.size(); ++i) {
    Part& part = collisions_[i];
    bool isChanged = part.changed != nullptr;
    archive(isChanged);
    if (isChanged) {
      Feel now = feel(i);
      for (double* number : {&now.mu, &now.mu2, &now.restitution}) {
        archive(*number);
        archive.check(*number >= 0);
      }
      setFeel(i, now, body);
    }
    archive(part.slip1);
    archive(part.slip2);
    archive.check(part.slip1 >= 0 && part.slip2 >= 0);
    archive(part.motion);
    if (!part.motion) continue;
    const bool isTurned = std::abs(part.motion->axis.squaredNorm() - 1) < 1e-6;
    archive.check(std::abs(part.motion->speed) <= SurfaceMotion::kLargestSpeed && isTurned);
  }
}

}  // namespace pongsim::physics
