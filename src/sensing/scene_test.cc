#include "sensing/scene.hh"

#include <gtest/gtest.h>

#include <chrono>
#include <cmath>
#include <cstddef>
#include <memory>
#include <random>
#include <span>
#include <string>
#include <vector>

#include "pongsim/geometry/rotation_between.hh"
#include "sensing/shape.hh"
#include "support/assets/figure_file.hh"
#include "support/png_file.hh"
#include "support/temp_folder.hh"
#include "support/visual_world.hh"

namespace pongsim::sensing {
namespace {

/// Visuals and a scene for beams.
class BeamWorld : public pongsim::test::VisualWorld {
 public:
  /// Call when all visuals have been added.
  void start() {
    populate();
    scene_.build(entities(), state(), diagnostics());
  }

  Echo cast(const Beams& beams, const Vector3& direction = Vector3::UnitX()) {
    Echo echo;
    scene_.cast(beams, {&direction, 1}, {&echo, 1});
    return echo;
  }

  void cast(const Beams& beams, std::span<const Vector3> directions, std::span<Echo> echoes) {
    scene_.cast(beams, directions, echoes);
  }

  /// @return The link that a beam hits.
  world::Slot hit(const Beams& beams, const Vector3& direction = Vector3::UnitX()) {
    Echo echo;
    world::Slot link = 0;
    scene_.cast(beams, {&direction, 1}, {&echo, 1}, {&link, 1});
    return link;
  }

  void move(std::size_t model, const Vector3& position) {
    state().links[model].X_WorldLink.position = position;
    scene_.update(state());
  }

  /// Adds this many tiny visuals far away, so that the scene needs a tree of boxes.
  void crowd(bool isStatic) {
    for (int i = 0; i < 9; ++i) add(description::Sphere{1e-3}, {{1e7, 1e7, 1e7 + i}, Quaternion::Identity()}, isStatic);
  }

  void letPass(Time time) {
    state().time += time;
    scene_.update(state());
  }

 private:
  Scene scene_;
};

Pose at(double x, double y = 0, double z = 0) { return {{x, y, z}, Quaternion::Identity()}; }

/// Beams from one point, which see everything.
Beams from(const Pose& X_WorldSensor) { return {X_WorldSensor, {}, 0, kNowhere}; }

/// A point on a convex body's surface, and the outward direction there.
struct SurfacePoint {
  Vector3 point;
  Vector3 normal;
};

class RandomBodies {
 public:
  double between(double least, double most) { return std::uniform_real_distribution(least, most)(random_); }
  Vector3 inBox() { return {between(-1, 1), between(-1, 1), between(-1, 1)}; }
  Vector3 direction() { return inBox().normalized(); }
  Quaternion rotation() { return fromRollPitchYaw(between(-3, 3), between(-1.5, 1.5), between(-3, 3)); }

  SurfacePoint on(const description::Box& box) {
    Vector3 point = inBox(), normal = Vector3::Zero();
    const auto axis = static_cast<int>(random_() % 3);
    point[axis] = normal[axis] = sign();
    return {point.cwiseProduct(box.size / 2), normal};
  }
  SurfacePoint on(const description::Sphere& sphere) {
    const Vector3 normal = direction();
    return {sphere.radius * normal, normal};
  }
  SurfacePoint on(const description::Cylinder& cylinder) {
    const double angle = between(-3, 3);
    const Vector3 side(std::cos(angle), std::sin(angle), 0);
    if (random_() % 2 == 0) {
      return {cylinder.radius * side + between(-0.5, 0.5) * cylinder.length * Vector3::UnitZ(), side};
    }
    const Vector3 up = sign() * Vector3::UnitZ();
    return {between(0, 1) * cylinder.radius * side + cylinder.length / 2 * up, up};
  }
  SurfacePoint on(const description::Capsule& capsule) {
    const Vector3 normal = direction();
    const double middle = normal.z() > 0 ? capsule.length / 2 : -capsule.length / 2;
    return {capsule.radius * normal + middle * Vector3::UnitZ(), normal};
  }
  SurfacePoint on(const description::Cone& cone) {
    const double angle = between(-3, 3);
    const Vector3 side(std::cos(angle), std::sin(angle), 0);
    const double share = between(0, 1);
    if (random_() % 2 == 0) {
      return {share * cone.radius * side - cone.length / 2 * Vector3::UnitZ(), -Vector3::UnitZ()};
    }
    return {share * cone.radius * side + (0.5 - share) * cone.length * Vector3::UnitZ(),
            (cone.length * side + cone.radius * Vector3::UnitZ()).normalized()};
  }
  SurfacePoint on(const description::Ellipsoid& ellipsoid) {
    const Vector3 unit = direction();
    return {unit.cwiseProduct(ellipsoid.radii), unit.cwiseQuotient(ellipsoid.radii).normalized()};
  }
  SurfacePoint on(const description::Plane& plane) {
    const Vector3 point(between(-0.5, 0.5) * plane.size.x(), between(-0.5, 0.5) * plane.size.y(), 0);
    const Quaternion turned = rotationBetween(Vector3::UnitZ(), plane.normal);
    return {turned * point, plane.normal};
  }

 private:
  double sign() { return random_() % 2 == 0 ? 1 : -1; }
  std::mt19937 random_{7};
};

/// A convex body that the beam meets from outside is met there first, wherever the beam begins: that is the formula.
template <class Body>
void expectRanges(const Body& body, double farthest) {
  RandomBodies random;
  for (int i = 0; i < 1000; ++i) {
    const Pose X_WorldBody{{random.between(-farthest, farthest), random.between(-farthest, farthest), 3},
                           random.rotation()};
    const SurfacePoint surface = random.on(body);
    Vector3 away = random.direction();
    if (away.dot(surface.normal) < 0) away = -away;
    if (away.dot(surface.normal) < 0.02) continue;
    const double range = std::exp(random.between(-4, 5));
    const Pose X_WorldSensor{X_WorldBody * Vector3(surface.point + range * away), random.rotation()};
    BeamWorld world;
    const bool isStatic = i % 2 == 0;
    world.add(body, X_WorldBody, isStatic);
    if (i % 4 < 2) world.crowd(isStatic);
    world.start();
    const Vector3 direction = X_WorldSensor.rotation.conjugate() * (X_WorldBody.rotation * -away);
    EXPECT_NEAR(world.cast(from(X_WorldSensor), direction).range / range, 1, 1e-6)
        << range << " m, at " << X_WorldBody.position.transpose();
  }
}

template <class Body>
void expectRangesNearAndFar(const Body& body) {
  expectRanges(body, 10);
  expectRanges(body, 10'000);
}

TEST(BeamScene, MeetsBoxesWhereTheFormulaSays) { expectRangesNearAndFar(description::Box{{1, 2, 0.3}}); }
TEST(BeamScene, MeetsSpheresWhereTheFormulaSays) { expectRangesNearAndFar(description::Sphere{0.7}); }
TEST(BeamScene, MeetsCylindersWhereTheFormulaSays) { expectRangesNearAndFar(description::Cylinder{0.4, 2}); }
TEST(BeamScene, MeetsCapsulesWhereTheFormulaSays) { expectRangesNearAndFar(description::Capsule{0.4, 2}); }
TEST(BeamScene, MeetsConesWhereTheFormulaSays) { expectRangesNearAndFar(description::Cone{0.4, 2}); }
TEST(BeamScene, MeetsEllipsoidsWhereTheFormulaSays) { expectRangesNearAndFar(description::Ellipsoid{{1, 2, 0.3}}); }
TEST(BeamScene, MeetsPlanesWhereTheFormulaSays) {
  expectRangesNearAndFar(description::Plane{Vector3(1, -2, 0.5).normalized(), {3, 5}});
}

TEST(BeamScene, MeetsTrianglesWhereTheFormulaSays) {
  // a box again, of twelve triangles
  auto triangles = std::make_shared<description::TriangleMesh>();
  for (int i = 0; i < 8; ++i) triangles->vertices.emplace_back((i & 1) - 0.5, (i & 2) - 1.0, (i & 4) * 0.075 - 0.15);
  triangles->triangles = {{0, 2, 3}, {0, 3, 1}, {4, 5, 7}, {4, 7, 6}, {0, 1, 5}, {0, 5, 4},
                          {2, 6, 7}, {2, 7, 3}, {0, 4, 6}, {0, 6, 2}, {1, 3, 7}, {1, 7, 5}};
  RandomBodies random;
  const description::Box box{{1, 2, 0.3}};
  for (int i = 0; i < 1000; ++i) {
    const Pose X_WorldBody{{random.between(-1e4, 1e4), random.between(-1e4, 1e4), 3}, random.rotation()};
    const SurfacePoint surface = random.on(box);
    const double range = std::exp(random.between(-4, 5));
    const Vector3 away = (surface.normal + 0.8 * random.direction()).normalized();
    BeamWorld world;
    description::Polyline body;
    body.triangles = triangles;
    world.add(body, X_WorldBody);
    world.start();
    const Pose X_WorldSensor{X_WorldBody * Vector3(surface.point + range * away), Quaternion::Identity()};
    const Vector3 direction = X_WorldBody.rotation * -away;
    EXPECT_NEAR(world.cast(from(X_WorldSensor), direction).range / range, 1, 1e-6) << range;
  }
}

TEST(BeamScene, SeesTheNearestOfMany) {
  BeamWorld world;
  for (int i = 50; i >= 1; --i) world.add(description::Sphere{0.1}, at(i), i % 2 == 0);
  world.start();
  EXPECT_NEAR(world.cast(from({})).range, 0.9, 1e-12);
  EXPECT_NEAR(world.cast(from(at(10.5))).range, 0.4, 1e-12);
}

TEST(BeamScene, SeesTheSameToTheBitAmongFewAndAmongMany) {
  RandomBodies random;
  int hits = 0;
  for (int i = 0; i < 50; ++i) {
    BeamWorld few, many;
    for (BeamWorld* world : {&few, &many}) {
      RandomBodies places = random;
      for (int k = 0; k < 8; ++k) {
        const Pose X_WorldBody{4 * places.inBox(), places.rotation()};
        if (k % 2 == 0) world->add(description::Box{{1, 2, 0.3}}, X_WorldBody, k < 4);
        if (k % 2 == 1) world->add(description::Cylinder{0.4, 2}, X_WorldBody, k < 4);
      }
    }
    for (const bool isStatic : {false, true}) many.crowd(isStatic);
    few.start();
    many.start();
    for (int k = 0; k < 200; ++k) {
      const Pose X_WorldSensor{4 * random.inBox(), random.rotation()};
      const Vector3 direction = random.direction();
      const double range = few.cast(from(X_WorldSensor), direction).range;
      EXPECT_EQ(range, many.cast(from(X_WorldSensor), direction).range);
      if (std::isfinite(range)) ++hits;
    }
  }
  EXPECT_GT(hits, 300);
}

TEST(BeamScene, SeesWhatIsNearerThanItsFarthest) {
  BeamWorld world;
  world.add(description::Box{{2, 2, 2}}, at(6)).laserRetro = 12;
  world.start();
  EXPECT_EQ(world.cast({{}, {}, 0.1, 5}).range, 5);
  EXPECT_EQ(world.cast({{}, {}, 0.1, 5}).intensity, 12);
  EXPECT_EQ(world.cast({{}, {}, 0.1, 4.999}).range, kNowhere);
  EXPECT_EQ(world.cast({{}, {}, 0.1, 4.999}).intensity, 0);
}

TEST(BeamScene, SaysThatSomethingIsTooNear) {
  BeamWorld world;
  world.add(description::Box{{2, 2, 2}}, at(6));
  world.start();
  EXPECT_EQ(world.cast({at(4.9), {}, 0.2, 5}).range, -kNowhere);
  EXPECT_NEAR(world.cast({at(4.9), {}, 0.05, 5}).range, 0.1, 1e-12);
}

TEST(BeamScene, SaysWhichLinkItSees) {
  BeamWorld world;
  for (const double x : {3.0, 6.0, 9.0}) world.add(description::Box{{1, 1, 1}}, at(x), x == 6);
  world.start();
  EXPECT_EQ(world.hit(from({})), 0U);
  EXPECT_EQ(world.hit(from(at(4))), 1U);
  EXPECT_EQ(world.hit(from(at(7))), 2U);
  EXPECT_EQ(world.hit(from(at(10))), world::kNoSlot);
  EXPECT_EQ(world.hit(from({}), Vector3::UnitZ()), world::kNoSlot);
  // too near to be seen
  EXPECT_EQ(world.hit({at(5.4), {}, 0.2, 5}), world::kNoSlot);
  EXPECT_EQ(world.hit(from(at(1e300))), world::kNoSlot);
}

TEST(BeamScene, LooksOutOfTheModelThatBearsTheSensor) {
  BeamWorld world;
  world.add(description::Box{{1, 1, 1}}, at(1));
  world.add(description::Box{{2, 2, 2}}, at(6));
  world.start();
  // near the front of its own box
  EXPECT_NEAR(world.cast({at(0.4), world.id(0), 0.2, 9}).range, 4.6, 1e-12);
  EXPECT_EQ(world.cast({at(0.4), world.id(1), 0.2, 9}).range, -kNowhere);
  EXPECT_NEAR(world.cast({at(0.2), world.id(0), 0.2, 9}).range, 0.3, 1e-12);
}

TEST(BeamScene, SeesBodiesFromInsideOnlyIfTheyAreDoubleSided) {
  for (const bool isDoubleSided : {false, true}) {
    BeamWorld world;
    description::Visual& visual = world.add(description::Sphere{2});
    visual.material.emplace();
    visual.material->isDoubleSided = isDoubleSided;
    world.start();
    EXPECT_EQ(world.cast(from({})).range, isDoubleSided ? 2 : kNowhere);
  }
}

TEST(BeamScene, HasVisualsInTheirPlaceInTheirLink) {
  BeamWorld world;
  world.add(description::Box{{1, 1, 1}}, {{2, 0, 0}, fromRollPitchYaw(0, 0, M_PI / 2)}).X_LinkVisual = at(0, -3);
  world.start();
  EXPECT_NEAR(world.cast(from({})).range, 4.5, 1e-9);
}

TEST(BeamScene, ShowsWhatItsMaskLetsThrough) {
  BeamWorld world;
  world.add(description::Box{{1, 1, 1}}, at(2)).visibilityFlags = 0x1;
  world.add(description::Box{{1, 1, 1}}, at(4)).visibilityFlags = 0x6;
  world.start();
  EXPECT_NEAR(world.cast({{}, {}, 0, 9, 0x1}).range, 1.5, 1e-12);
  EXPECT_NEAR(world.cast({{}, {}, 0, 9, 0x2}).range, 3.5, 1e-12);
  EXPECT_EQ(world.cast({{}, {}, 0, 9, 0x8}).range, kNowhere);
}

TEST(BeamScene, GoesWithWhatMoves) {
  for (const int which : {0, 1, 2, 3}) {
    const bool isStatic = which % 2 == 1, isCrowded = which > 1;
    BeamWorld world;
    world.add(description::Sphere{1}, at(3), isStatic);
    if (isCrowded) world.crowd(isStatic);
    world.start();
    EXPECT_NEAR(world.cast(from({})).range, 2, 1e-12);
    world.move(0, {9, 0, 0});
    EXPECT_NEAR(world.cast(from({})).range, 8, 1e-12);
    world.move(0, {9, 2, 0});
    EXPECT_EQ(world.cast(from({})).range, kNowhere);
    // out of all measure, and back
    world.move(0, {1e300, 0, 0});
    EXPECT_EQ(world.cast(from({})).range, kNowhere);
    world.move(0, {5, 0, 0});
    EXPECT_NEAR(world.cast(from({})).range, 4, 1e-12);
  }
}

TEST(BeamScene, SeesActorsWhereTheyGo) {
  BeamWorld world;
  description::Actor& actor = world.description().actors.emplace_back();
  actor.name = "a";
  actor.visuals.emplace_back().geometry = description::Sphere{1};
  actor.trajectories.emplace_back().waypoints = {{0, at(3)}, {2, at(7)}, {4, at(7, 5)}};
  world.start();
  EXPECT_NEAR(world.cast(from({})).range, 2, 1e-12);
  world.letPass(std::chrono::seconds(2));
  EXPECT_NEAR(world.cast(from({})).range, 6, 1e-12);
  world.letPass(std::chrono::seconds(2));
  EXPECT_EQ(world.cast(from({})).range, kNowhere);
}

TEST(BeamScene, SeesTheHandsOfActorsWhereTheirSkeletonsSay) {
  const test::TempFolder folder;
  BeamWorld world;
  description::Actor& actor = world.description().actors.emplace_back();
  actor.name = "a";
  actor.skin = {"skin.dae", folder.write("skin.dae", test::FigureFile{.moves = false}.text())};
  actor.animations.push_back({"walk", {"walk.dae", folder.write("walk.dae", test::FigureFile().text())}});
  actor.animations.push_back({"run", {"run.bvh", folder.write("run.bvh", "HIERARCHY")}});
  actor.trajectories.push_back({.id = 0, .type = "walk", .waypoints = {{0, at(5)}, {1, at(5)}}});
  world.start();
  ASSERT_EQ(world.warnings().size(), 1U);
  EXPECT_EQ(world.warnings()[0].message,
            "'" + actor.animations[1].source.file.string() +
                "' can't move this skin: sensors will not see it move the limbs of actor 'a'");
  // the arm turns from upright to the right
  const Pose before{{0, 0, 1.1}, Quaternion::Identity()}, behind{{0, -0.61, 0.5}, Quaternion::Identity()};
  EXPECT_NEAR(world.cast(from(before)).range, 5, 1e-9);
  EXPECT_EQ(world.cast(from(behind)).range, kNowhere);
  world.letPass(std::chrono::seconds(1));
  EXPECT_NEAR(world.cast(from(behind)).range, 5, 1e-9);
  EXPECT_EQ(world.cast(from(before)).range, kNowhere);
}

TEST(BeamScene, SeesNothingFromOutOfAllMeasure) {
  BeamWorld world;
  world.add(description::Sphere{1}, at(3));
  world.start();
  EXPECT_EQ(world.cast(from(at(-1e200))).range, kNowhere);
  EXPECT_EQ(world.cast(from(at(std::nan("")))).range, kNowhere);
}

TEST(BeamScene, ReadsMeshesAndHeightmaps) {
  const test::TempFolder folder;
  BeamWorld world;
  description::Mesh mesh;
  mesh.file = folder.write("m.obj", "v 0 -1 -1\nv 0 0 1\nv 0 1 -1\nf 1 2 3\n");
  mesh.scale = {1, 2, 2};
  world.add(mesh, at(3));
  description::Heightmap ground;
  ground.file = folder.write("h.png", test::grayPng(3, {0, 0, 0, 0, 255, 0, 0, 0, 0}));
  ground.size = {6, 6, 2};
  world.add(ground, at(0, 20));
  world.start();
  EXPECT_TRUE(world.warnings().empty());
  EXPECT_NEAR(world.cast(from(at(0, 1.5, -1.8))).range, 3, 1e-6);
  EXPECT_NEAR(world.cast(from(at(0, 20, 9)), -Vector3::UnitZ()).range, 7, 1e-6);
}

TEST(BeamScene, SaysOnceWhichFilesItCantRead) {
  const test::TempFolder folder;
  BeamWorld world;
  description::Mesh mesh;
  mesh.file = folder.write("m.stl", "no mesh");
  world.add(mesh).position = {nullptr, 12, 3};
  description::Heightmap ground;
  ground.file = folder.write("h.png", "no image");
  world.add(ground);
  world.start();
  world.start();
  ASSERT_EQ(world.warnings().size(), 2U);
  EXPECT_NE(world.warnings()[0].message.find("m.stl"), std::string::npos);
  EXPECT_NE(world.warnings()[0].message.find("visual 'v' of link 'l' will not be seen"), std::string::npos);
  EXPECT_EQ(world.warnings()[0].position.line, 12);
  EXPECT_EQ(world.cast(from({})).range, kNowhere);
}

// the level row of a lidar has directions with a vertical component of almost zero
TEST(Scene, IsSeenByBeamsTogetherAsByEachAlone) {
  BeamWorld world;
  world.add(description::Cylinder{0.3, 2}, at(-2, -2, 1));
  world.add(description::Sphere{0.8}, at(-1, 3, 1));
  world.start();
  std::vector<Vector3> directions;
  for (const double up : {-0.1, -0.1 + 0.2 / 2, 0.1}) {
    for (int i = 0; i < 180; ++i) {
      const double left = -3.1241 + i * 6.2482 / 179;
      directions.emplace_back(std::cos(up) * std::cos(left), std::cos(up) * std::sin(left), std::sin(up));
    }
  }
  std::vector<Echo> echoes(directions.size());
  for (const double turn : {0.0, 0.025, 0.05, 0.075, 0.1, 0.125, 0.3, 1.0}) {
    const Beams beams = from({{0, 0, 1}, fromRollPitchYaw(0, 0, turn)});
    world.cast(beams, directions, echoes);
    std::size_t seen = 0;
    for (std::size_t i = 0; i < directions.size(); ++i) {
      ASSERT_EQ(echoes[i].range, world.cast(beams, directions[i]).range) << turn << ", beam " << i;
      if (echoes[i].range < kNowhere) ++seen;
    }
    EXPECT_GT(seen, 50U);
  }
}

}  // namespace
}  // namespace pongsim::sensing
