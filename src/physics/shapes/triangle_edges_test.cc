#include "physics/shapes/triangle_edges.hh"

#include <BulletCollision/CollisionDispatch/btCollisionObject.h>
#include <BulletCollision/CollisionDispatch/btInternalEdgeUtility.h>
#include <BulletCollision/CollisionShapes/btTriangleMesh.h>
#include <BulletCollision/CollisionShapes/btTriangleShape.h>
#include <gtest/gtest.h>

#include <cstddef>
#include <ctime>
#include <optional>
#include <vector>

#include "pongsim/random.hh"

namespace pongsim::physics {
namespace {

using Corners = TriangleEdges::Corners;

/// Hilly ground of `side` by `side` squares of half a metre, with flat parts, twice: once with our edges, once with
/// Bullet's.
class Ground {
 public:
  Ground(int side, double hills) {
    Random random(3, "hills");
    std::vector<btVector3> points;
    for (int i = 0; i <= side; ++i) {
      for (int j = 0; j <= side; ++j) {
        const double height = hills * random.uniform();
        points.emplace_back(0.5 * i, 0.5 * j, random.uniform() < 0.4 ? 0 : height);
      }
    }
    const auto at = [&](int i, int j) { return points[static_cast<std::size_t>(i * (side + 1) + j)]; };
    for (int i = 0; i < side; ++i) {
      for (int j = 0; j < side; ++j) {
        triangles.push_back({at(i, j), at(i + 1, j), at(i + 1, j + 1)});
        triangles.push_back({at(i, j), at(i + 1, j + 1), at(i, j + 1)});
      }
    }
    for (const Corners& each : triangles) mesh_.addTriangle(each[0], each[1], each[2]);
    ours_.setCollisionShape(&ourShape_.emplace(&mesh_, true));
    bullets_.setCollisionShape(&bulletsShape_.emplace(&mesh_, true));
    edges_.connect(*ourShape_, triangles);
    btGenerateInternalEdgeInfo(&*bulletsShape_, &bulletsEdges_);
    for (btCollisionObject* object : {&ours_, &bullets_}) {
      object->setWorldTransform(btTransform(btQuaternion(btVector3(0, 0.6, 0.8), 0.3), btVector3(1, -2, 3)));
    }
  }

  /// @return A contact of something with a triangle, as the surface has it.
  btManifoldPoint contactAt(std::size_t triangle, const btVector3& place, const btVector3& normal, bool isOurs) {
    const btCollisionObject& object = isOurs ? ours_ : bullets_;
    const Corners& corners = triangles[triangle];
    btTriangleShape shape(corners[0], corners[1], corners[2]);
    const auto index = static_cast<int>(triangle);
    const btCollisionObjectWrapper wrapper(nullptr, &shape, &object, object.getWorldTransform(), 0, index);
    btManifoldPoint point(btVector3(0, 0, 0), place, object.getWorldTransform().getBasis() * normal, -1e-3);
    point.m_positionWorldOnB = object.getWorldTransform() * place;
    point.m_positionWorldOnA = point.m_positionWorldOnB + point.m_normalWorldOnB * point.m_distance1;
    if (isOurs) {
      TriangleEdges::smooth(point, wrapper, index);
    } else {
      btAdjustInternalEdgeContacts(point, &wrapper, nullptr, 0, index, BT_TRIANGLE_CONCAVE_DOUBLE_SIDED);
    }
    return point;
  }

  std::vector<Corners> triangles;

 private:
  btTriangleMesh mesh_;
  TriangleEdges edges_;
  btTriangleInfoMap bulletsEdges_;
  std::optional<btBvhTriangleMeshShape> ourShape_;
  std::optional<btBvhTriangleMeshShape> bulletsShape_;
  btCollisionObject ours_;
  btCollisionObject bullets_;
};

TEST(TriangleEdges, TurnNormalsAsBulletDoes) {
  Random random(7, "contacts");
  const auto between = [&](double low, double high) { return low + (high - low) * random.uniform(); };
  for (const double hills : {0.0, 0.05, 1.0}) {
    Ground ground(6, hills);
    int turned = 0;
    for (int i = 0; i < 20'000; ++i) {
      const auto triangle = static_cast<std::size_t>(between(0, static_cast<double>(ground.triangles.size())));
      const Corners& corners = ground.triangles[triangle];
      const double a = between(0, 1), b = between(0, 1 - a);
      const btVector3 place = a * corners[0] + b * corners[1] + (1 - a - b) * corners[2];
      const btVector3 normal = btVector3(between(-1, 1), between(-1, 1), between(-0.5, 1)).normalized();
      const btManifoldPoint ours = ground.contactAt(triangle, place, normal, true);
      const btManifoldPoint bullets = ground.contactAt(triangle, place, normal, false);
      ASSERT_LT((ours.m_normalWorldOnB - bullets.m_normalWorldOnB).length(), 1e-9) << i;
      ASSERT_LT((ours.m_positionWorldOnB - bullets.m_positionWorldOnB).length(), 1e-9) << i;
      ASSERT_LT((ours.m_localPointB - bullets.m_localPointB).length(), 1e-9) << i;
      if ((ours.m_localPointB - place).length() > 1e-9) ++turned;
    }
    EXPECT_GT(turned, 5'000) << hills;
  }
}

TEST(TriangleEdges, AreFoundInSecondsAmongTrianglesThatAllOverlap) {
  Random random(5, "heap");
  btTriangleMesh mesh;
  std::vector<Corners> triangles;
  for (int i = 0; i < 100'000; ++i) {
    Corners corners;
    for (btVector3& corner : corners) corner = {random.uniform(), random.uniform(), random.uniform()};
    mesh.addTriangle(corners[0], corners[1], corners[2]);
    triangles.push_back(corners);
  }
  btBvhTriangleMeshShape shape(&mesh, true);
  TriangleEdges edges;
  const std::clock_t begin = std::clock();
  edges.connect(shape, triangles);
  // comparing each with each takes minutes
  EXPECT_LT(std::clock() - begin, 5 * CLOCKS_PER_SEC);
}

TEST(TriangleEdges, AreFoundInSecondsAmongTrianglesAtOneEdge) {
  btTriangleMesh mesh;
  std::vector<Corners> triangles;
  for (int i = 0; i < 50'000; ++i) {
    triangles.push_back({btVector3(0, 0, 0), btVector3(0, 0, 1), btVector3(1, 1e-5 * (i / 2), 0.5)});
    mesh.addTriangle(triangles.back()[0], triangles.back()[1], triangles.back()[2]);
  }
  btBvhTriangleMeshShape shape(&mesh, true);
  TriangleEdges edges;
  const std::clock_t begin = std::clock();
  edges.connect(shape, triangles);
  EXPECT_LT(std::clock() - begin, 5 * CLOCKS_PER_SEC);
}

}  // namespace
}  // namespace pongsim::physics
