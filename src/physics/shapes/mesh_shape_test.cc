#include "physics/shapes/mesh_shape.hh"

#include <BulletCollision/CollisionShapes/btConvexHullShape.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "physics/hulls/hull_store.hh"
#include "support/physics/rig.hh"

namespace pongsim::physics {
namespace {

using test::addCollision;
using test::makeLink;
using test::makeModel;
using test::Rig;

/// The surface of a box around the origin, with a vertex in the middle that no triangle uses.
description::TriangleMesh boxMesh(const Vector3& size) {
  description::TriangleMesh mesh;
  for (int i = 0; i < 8; ++i) {
    const Vector3 corner((i & 1) != 0 ? 1 : -1, (i & 2) != 0 ? 1 : -1, (i & 4) != 0 ? 1 : -1);
    mesh.vertices.push_back(corner.cwiseProduct(size) / 2);
  }
  mesh.triangles = {{0, 2, 1}, {1, 2, 3}, {4, 5, 6}, {5, 7, 6}, {0, 1, 4}, {1, 5, 4},
                    {2, 6, 3}, {3, 6, 7}, {0, 4, 2}, {2, 4, 6}, {1, 3, 5}, {3, 7, 5}};
  mesh.vertices.push_back(Vector3::Zero());
  return mesh;
}

/// A level floor of n by n squares of 1 m, two triangles each, its middle in the origin.
description::TriangleMesh floorMesh(int n) {
  description::TriangleMesh mesh;
  const auto number = [n](int x, int y) { return static_cast<std::uint32_t>(y * (n + 1) + x); };
  for (int y = 0; y <= n; ++y) {
    for (int x = 0; x <= n; ++x) mesh.vertices.emplace_back(x - n / 2.0, y - n / 2.0, 0);
  }
  for (int y = 0; y < n; ++y) {
    for (int x = 0; x < n; ++x) {
      mesh.triangles.push_back({number(x, y), number(x + 1, y), number(x + 1, y + 1)});
      mesh.triangles.push_back({number(x, y), number(x + 1, y + 1), number(x, y + 1)});
    }
  }
  return mesh;
}

description::Mesh meshOf(description::TriangleMesh triangles, const Vector3& scale = {1, 1, 1}) {
  description::Mesh mesh;
  mesh.scale = scale;
  mesh.triangles = std::make_shared<const description::TriangleMesh>(std::move(triangles));
  return mesh;
}

/// As it moves, which is in one piece.
std::unique_ptr<btConvexHullShape> hullOf(description::TriangleMesh triangles, const Vector3& scale) {
  HullStore store;
  const std::vector<Hull>& hulls = store.find(requestFor(meshOf(std::move(triangles), scale)));
  EXPECT_EQ(hulls.size(), 1U);
  return makeShape(hulls.at(0));
}

description::Model makeFloor(double mu = 1) {
  description::Link link;
  link.name = "link";
  addCollision(link, meshOf(floorMesh(20)), mu);
  description::Model model = makeModel("floor", {link});
  model.isStatic = true;
  return model;
}

// height of the link's origin when it has come to rest on the floor
double restingHeight(const description::Link& link, description::Model floor) {
  description::World world;
  world.models = {std::move(floor), makeModel("body", {link})};
  Rig rig(std::move(world));
  rig.step(3000);
  EXPECT_LT(rig.link("body::link").v_WorldLink.norm(), 5e-3);
  return rig.link("body::link").X_WorldLink.position.z();
}

TEST(MeshShape, MovesAsItsConvexHull) {
  const auto shape = hullOf(boxMesh({1, 2, 3}), {1, 1, -2});
  const auto* hull = dynamic_cast<const btConvexHullShape*>(shape.get());
  ASSERT_NE(hull, nullptr);
  EXPECT_EQ(hull->getNumPoints(), 8);
  EXPECT_NEAR(hull->localGetSupportingVertex({1, 0, 0}).x(), 0.5, 1e-4);
  EXPECT_NEAR(hull->localGetSupportingVertex({0, 1, 0}).y(), 1, 1e-4);
  EXPECT_NEAR(hull->localGetSupportingVertex({0, 0, -1}).z(), -3, 1e-3);
}

TEST(MeshShape, KeepsTheFormOfAFineMeshWithFewCorners) {
  description::TriangleMesh ball;
  for (int i = 0; i < 20000; ++i) {
    const double z = 1 - (2 * i + 1) / 20000.0, angle = 0.1 * i;
    ball.vertices.emplace_back(std::sqrt(1 - z * z) * std::cos(angle), std::sqrt(1 - z * z) * std::sin(angle), z);
  }
  const auto shape = hullOf(ball, {1, 1, 1});
  const auto* hull = dynamic_cast<const btConvexHullShape*>(shape.get());
  ASSERT_NE(hull, nullptr);
  EXPECT_LE(hull->getNumPoints(), 500);
  for (int i = 0; i < 1000; ++i) {
    const btVector3 direction = btVector3(std::sin(3.0 * i), std::cos(5.0 * i), std::sin(7.0 * i + 1)).normalized();
    EXPECT_NEAR(hull->localGetSupportingVertex(direction).dot(direction), 1, 0.02);
  }
}

TEST(MeshShape, BearsAFlatMesh) {
  const auto hull = hullOf(floorMesh(2), {1, 1, 1});
  btVector3 lower, upper;
  hull->getAabb(btTransform::getIdentity(), lower, upper);
  EXPECT_NEAR(upper.x(), 1, 1e-6);
  EXPECT_NEAR(upper.z(), 0, 1e-6);
}

TEST(MeshShape, RestsAsTheShapeThatItShows) {
  description::Link link = makeLink("link", {0, 0, 0.51}, 1, {0.1, 0.1, 0.1});
  addCollision(link, meshOf(boxMesh({1, 1, 0.5}), {1, 1, 2}));
  EXPECT_NEAR(restingHeight(link, test::makeGround()), 0.5, 1e-4);
  EXPECT_NEAR(restingHeight(link, makeFloor()), 0.5, 1e-4);
}

TEST(MeshShape, BearsOtherShapesOnItsTriangles) {
  description::Link box = makeLink("link", {0.3, 0.2, 0.16}, 1, {0.01, 0.01, 0.01});
  addCollision(box, description::Box{{0.2, 0.2, 0.3}});
  EXPECT_NEAR(restingHeight(box, makeFloor()), 0.15, 1e-4);

  description::Link sphere = makeLink("link", {0.3, 0.2, 0.26}, 1, {0.01, 0.01, 0.01});
  addCollision(sphere, description::Sphere{0.25});
  EXPECT_NEAR(restingHeight(sphere, makeFloor()), 0.25, 1e-4);

  description::Link cylinder = makeLink("link", {0.3, 0.2, 0.11}, 1, {0.01, 0.01, 0.01});
  addCollision(cylinder, description::Cylinder{0.3, 0.2});
  EXPECT_NEAR(restingHeight(cylinder, makeFloor()), 0.1, 1e-4);
}

TEST(MeshShape, LetsABoxSlideOverTheEdgesOfItsTriangles) {
  description::Link box = makeLink("link", {-8, 0.3, 0.1}, 1, {0.01, 0.01, 0.01});
  addCollision(box, description::Box{{0.4, 0.4, 0.2}}, 0);
  description::World world;
  world.models = {makeFloor(), makeModel("body", {box})};
  world.gravity = {0.5, 0, -9.8};
  Rig rig(std::move(world));
  const auto& state = rig.link("body::link");
  double highest = 0, lowest = 1, tilt = 0;
  for (int i = 0; i < 4000; ++i) {
    rig.step();
    highest = std::max(highest, state.X_WorldLink.position.z());
    lowest = std::min(lowest, state.X_WorldLink.position.z());
    const Vector3 up = state.X_WorldLink.rotation * Vector3::UnitZ();
    tilt = std::max(tilt, std::hypot(up.x(), up.y()));
  }
  // x = a t^2 / 2, and level: at an edge it dips by half a millimetre
  EXPECT_NEAR(state.X_WorldLink.position.x(), -8 + 0.25 * 16, 0.01);
  EXPECT_NEAR(highest, 0.1, 1e-3);
  EXPECT_NEAR(lowest, 0.1, 1e-3);
  EXPECT_LT(tilt, 2e-3);
}

TEST(MeshShape, LetsAWheelRollOverTheEdgesOfItsTriangles) {
  description::Link wheel = makeLink("link", {-8, 0.3, 0.25}, 1, {0.02, 0.04, 0.02});
  addCollision(wheel, description::Cylinder{0.25, 0.1});
  wheel.collisions[0].X_LinkCollision.rotation = fromRollPitchYaw(M_PI / 2, 0, 0);
  description::World world;
  world.models = {makeFloor(), makeModel("body", {wheel})};
  world.gravity = {0.5, 0, -9.8};
  Rig rig(std::move(world));
  rig.step(4000);
  // a = g sin / (1 + I / m r^2)
  const double acceleration = 0.5 / (1 + 0.04 / (0.25 * 0.25));
  const auto& state = rig.link("body::link");
  EXPECT_NEAR(state.X_WorldLink.position.x(), -8 + acceleration * 8, 0.03);
  EXPECT_NEAR(state.X_WorldLink.position.z(), 0.25, 5e-4);
}

TEST(MeshShape, HasTheSurfaceOfItsCollision) {
  // on a slope of 1 in 5 a block stays with mu 0.5 and goes with mu 0.05
  for (const auto& [mu, goes] : {std::pair(0.5, false), std::pair(0.05, true)}) {
    description::Link box = makeLink("link", {0, 0, 0.1}, 1, {0.01, 0.01, 0.01});
    addCollision(box, description::Box{{0.4, 0.4, 0.2}});
    description::World world;
    world.models = {makeFloor(mu), makeModel("body", {box})};
    world.gravity = {2, 0, -10};
    Rig rig(std::move(world));
    rig.step(1000);
    EXPECT_EQ(rig.link("body::link").X_WorldLink.position.x() > 0.1, goes) << mu;
  }
}

TEST(MeshShape, LeavesOutTrianglesWithoutArea) {
  description::TriangleMesh mesh = boxMesh({1, 1, 1});
  mesh.triangles.push_back({0, 0, 1});
  EXPECT_EQ(TriangleSurface(mesh, {1, 1, 1}, Pose()).triangleCount(), 12);
  mesh.triangles = {{1, 1, 1}};
  EXPECT_EQ(TriangleSurface(mesh, {1, 1, 1}, Pose()).shape(), nullptr);
}

TEST(MeshShape, MayBeThatOfAHeightmap) {
  description::Heightmap map;
  map.triangles = std::make_shared<const description::TriangleMesh>(floorMesh(4));
  description::Link link;
  link.name = "link";
  addCollision(link, map);
  description::Model ground = makeModel("floor", {link});
  ground.isStatic = true;
  description::Link sphere = makeLink("link", {0.3, 0.2, 0.26}, 1, {0.01, 0.01, 0.01});
  addCollision(sphere, description::Sphere{0.25});
  EXPECT_NEAR(restingHeight(sphere, ground), 0.25, 1e-4);
}

TEST(MeshShape, LiesWhereItsCollisionDoes) {
  description::Model floor = makeFloor();
  floor.links[0].collisions[0].X_LinkCollision = {{0, 0, 1}, fromRollPitchYaw(0, 0, 0.3)};
  description::Link sphere = makeLink("link", {0.3, 0.2, 1.26}, 1, {0.01, 0.01, 0.01});
  addCollision(sphere, description::Sphere{0.25});
  EXPECT_NEAR(restingHeight(sphere, floor), 1.25, 1e-4);
}

}  // namespace
}  // namespace pongsim::physics
