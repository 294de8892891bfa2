// Compares the worlds of Fortress as read by pongsim and by libsdformat 12: poses, axes, masses and shapes.

#include <gtest/gtest.h>

#include <algorithm>
#include <filesystem>
#include <map>
#include <string>
#include <vector>

#include "looks.hh"
#include "near.hh"
#include "pongsim/diagnostic.hh"
#include "sdf/loader.hh"
#include "sensors.hh"
#include "support/fortress_worlds.hh"

namespace pongsim::test {
namespace {

namespace fs = std::filesystem;
/// Files with intended differences, and the reasons.
const std::map<std::string, std::string> kIntended = {
    {"test/models/include_nested/model.sdf", "it includes nested_models, below"},
    {"test/models/nested_models/model.sdf",
     "joint_01 connects a link with itself by two frames: it is left out with a warning"}};

Matrix3 matrix(const ignition::math::Matrix3d& m) {
  Matrix3 result;
  for (int i = 0; i < 3; ++i) {
    for (int j = 0; j < 3; ++j) result(i, j) = m(static_cast<std::size_t>(i), static_cast<std::size_t>(j));
  }
  return result;
}

void compare(const ours::Geometry& a, const theirs::Geometry& b, const std::string& what) {
  switch (b.Type()) {
    case theirs::GeometryType::BOX:
      ASSERT_TRUE(std::holds_alternative<ours::Box>(a)) << what;
      return expectNear(std::get<ours::Box>(a).size, vector(b.BoxShape()->Size()), what);
    case theirs::GeometryType::SPHERE:
      ASSERT_TRUE(std::holds_alternative<ours::Sphere>(a)) << what;
      EXPECT_NEAR(std::get<ours::Sphere>(a).radius, b.SphereShape()->Radius(), kTolerance) << what;
      return;
    case theirs::GeometryType::CYLINDER:
      ASSERT_TRUE(std::holds_alternative<ours::Cylinder>(a)) << what;
      EXPECT_NEAR(std::get<ours::Cylinder>(a).radius, b.CylinderShape()->Radius(), kTolerance) << what;
      EXPECT_NEAR(std::get<ours::Cylinder>(a).length, b.CylinderShape()->Length(), kTolerance) << what;
      return;
    case theirs::GeometryType::CAPSULE:
      ASSERT_TRUE(std::holds_alternative<ours::Capsule>(a)) << what;
      EXPECT_NEAR(std::get<ours::Capsule>(a).radius, b.CapsuleShape()->Radius(), kTolerance) << what;
      EXPECT_NEAR(std::get<ours::Capsule>(a).length, b.CapsuleShape()->Length(), kTolerance) << what;
      return;
    case theirs::GeometryType::ELLIPSOID:
      ASSERT_TRUE(std::holds_alternative<ours::Ellipsoid>(a)) << what;
      return expectNear(std::get<ours::Ellipsoid>(a).radii, vector(b.EllipsoidShape()->Radii()), what);
    case theirs::GeometryType::MESH:
      ASSERT_TRUE(std::holds_alternative<ours::Mesh>(a)) << what;
      EXPECT_EQ(std::get<ours::Mesh>(a).submesh, b.MeshShape()->Submesh()) << what;
      EXPECT_EQ(std::get<ours::Mesh>(a).isCentered, b.MeshShape()->CenterSubmesh()) << what;
      return expectNear(std::get<ours::Mesh>(a).scale, vector(b.MeshShape()->Scale()), what);
    case theirs::GeometryType::HEIGHTMAP:
      ASSERT_TRUE(std::holds_alternative<ours::Heightmap>(a)) << what;
      expectNear(std::get<ours::Heightmap>(a).position, vector(b.HeightmapShape()->Position()), what);
      return expectNear(std::get<ours::Heightmap>(a).size, vector(b.HeightmapShape()->Size()), what);
    case theirs::GeometryType::PLANE:
      ASSERT_TRUE(std::holds_alternative<ours::Plane>(a)) << what;
      return expectNear(std::get<ours::Plane>(a).normal, vector(b.PlaneShape()->Normal()), what);
    default:
      return;
  }
}

/// @tparam Holder A link or a joint.
template <class Holder, class Other>
void compareSensors(const Holder& a, const Other& b, const std::string& what) {
  EXPECT_EQ(a.sensors.size(), b.SensorCount()) << what;
  for (std::uint64_t i = 0; i < b.SensorCount(); ++i) {
    const theirs::Sensor& other = *b.SensorByIndex(i);
    const ours::Sensor* sensor = named(a.sensors, other.Name());
    ASSERT_NE(sensor, nullptr) << what << "::" << other.Name();
    compareSensor(*sensor, other, what + "::" + other.Name());
  }
}

void compare(const ours::Link& a, const theirs::Link& b, const std::string& what) {
  expectNear(a.X_ModelLink, resolved(b), what);
  EXPECT_NEAR(a.inertial.mass, b.Inertial().MassMatrix().Mass(), kTolerance) << what;
  expectNear(a.inertial.X_LinkCom, pose(b.Inertial().Pose()), what + ", centre of mass");
  EXPECT_TRUE(a.inertial.moments.isApprox(matrix(b.Inertial().MassMatrix().Moi()), kTolerance))
      << what << ": " << a.inertial.moments << "\nand\n"
      << matrix(b.Inertial().MassMatrix().Moi());
  EXPECT_EQ(a.collisions.size(), b.CollisionCount()) << what;
  EXPECT_EQ(a.visuals.size(), b.VisualCount()) << what;
  for (std::uint64_t i = 0; i < b.CollisionCount(); ++i) {
    const theirs::Collision& other = *b.CollisionByIndex(i);
    const ours::Collision* collision = named(a.collisions, other.Name());
    ASSERT_NE(collision, nullptr) << what << "::" << other.Name();
    expectNear(collision->X_LinkCollision, resolved(other), what + "::" + other.Name());
    compare(collision->geometry, *other.Geom(), what + "::" + other.Name());
  }
  for (std::uint64_t i = 0; i < b.VisualCount(); ++i) {
    const theirs::Visual& other = *b.VisualByIndex(i);
    const ours::Visual* visual = named(a.visuals, other.Name());
    ASSERT_NE(visual, nullptr) << what << "::" << other.Name();
    expectNear(visual->X_LinkVisual, resolved(other), what + "::" + other.Name());
    compare(visual->geometry, *other.Geom(), what + "::" + other.Name());
    compareLooks(*visual, other, what + "::" + other.Name());
  }
  EXPECT_EQ(a.lights.size(), b.LightCount()) << what;
  for (std::uint64_t i = 0; i < b.LightCount(); ++i) {
    const theirs::Light& other = *b.LightByIndex(i);
    const ours::Light* light = named(a.lights, other.Name());
    ASSERT_NE(light, nullptr) << what << "::" << other.Name();
    compareLight(*light, other, what + "::" + other.Name());
  }
  compareSensors(a, b, what);
  EXPECT_EQ(a.isInWind.value_or(false), b.EnableWind()) << what;
}

void compare(const ours::Joint& a, const theirs::Joint& b, const std::string& what) {
  std::string child;
  if (b.ResolveChildLink(child).empty()) expectNear(a.X_ChildJoint, resolved(b, child), what);
  for (unsigned i = 0; i < a.axes.size(); ++i) {
    const theirs::JointAxis* axis = b.Axis(i);
    if (axis == nullptr) continue;
    ignition::math::Vector3d xyz;
    EXPECT_TRUE(axis->ResolveXyz(xyz).empty()) << what;
    expectNear(a.axes[i].xyz, vector(xyz), what + ", axis " + std::to_string(i));
    // libsdformat's limits from 1e16 on mean no limit
    const auto limit = [](double value) { return std::clamp(value, -1e16, 1e16); };
    EXPECT_NEAR(limit(a.axes[i].lower), limit(axis->Lower()), kTolerance) << what;
    EXPECT_NEAR(limit(a.axes[i].upper), limit(axis->Upper()), kTolerance) << what;
  }
  compareSensors(a, b, what);
}

void compare(const ours::Model& a, const theirs::Model& b, const std::string& what) {
  expectNear(a.X_ParentModel, resolved(b), what);
  EXPECT_EQ(a.isStatic, b.Static()) << what;
  EXPECT_EQ(a.links.size(), b.LinkCount()) << what;
  EXPECT_EQ(a.joints.size(), b.JointCount()) << what;
  EXPECT_EQ(a.models.size(), b.ModelCount()) << what;
  for (std::uint64_t i = 0; i < b.LinkCount(); ++i) {
    const std::string name = b.LinkByIndex(i)->Name();
    const ours::Link* link = named(a.links, name);
    ASSERT_NE(link, nullptr) << what << "::" << name;
    compare(*link, *b.LinkByIndex(i), what + "::" + name);
  }
  for (std::uint64_t i = 0; i < b.JointCount(); ++i) {
    const std::string name = b.JointByIndex(i)->Name();
    const ours::Joint* joint = named(a.joints, name);
    ASSERT_NE(joint, nullptr) << what << "::" << name;
    compare(*joint, *b.JointByIndex(i), what + "::" + name);
  }
  for (std::uint64_t i = 0; i < b.FrameCount(); ++i) {
    const std::string name = b.FrameByIndex(i)->Name();
    const ours::Frame* frame = named(a.frames, name);
    ASSERT_NE(frame, nullptr) << what << "::" << name;
    expectNear(frame->X_ModelFrame, resolved(*b.FrameByIndex(i), "__model__"), what + "::" + name);
  }
  for (std::uint64_t i = 0; i < b.ModelCount(); ++i) {
    const std::string name = b.ModelByIndex(i)->Name();
    const ours::Model* model = named(a.models, name);
    ASSERT_NE(model, nullptr) << what << "::" << name;
    compare(*model, *b.ModelByIndex(i), what + "::" + name);
  }
}

void compare(const ours::World& a, const theirs::World& b) {
  EXPECT_EQ(a.name, b.Name());
  expectNear(a.gravity, vector(b.Gravity()), "gravity");
  EXPECT_EQ(a.models.size(), b.ModelCount());
  for (std::uint64_t i = 0; i < b.ModelCount(); ++i) {
    const std::string name = b.ModelByIndex(i)->Name();
    const ours::Model* model = named(a.models, name);
    ASSERT_NE(model, nullptr) << name;
    compare(*model, *b.ModelByIndex(i), name);
  }
  EXPECT_EQ(a.lights.size(), b.LightCount());
  for (std::uint64_t i = 0; i < b.LightCount(); ++i) {
    const std::string name = b.LightByIndex(i)->Name();
    const ours::Light* light = named(a.lights, name);
    ASSERT_NE(light, nullptr) << name;
    compareLight(*light, *b.LightByIndex(i), name);
  }
  EXPECT_EQ(a.actors.size(), b.ActorCount());
  for (std::uint64_t i = 0; i < b.ActorCount(); ++i) {
    const std::string name = b.ActorByIndex(i)->Name();
    const ours::Actor* actor = named(a.actors, name);
    ASSERT_NE(actor, nullptr) << name;
    compareActor(*actor, *b.ActorByIndex(i), name);
  }
  if (b.Scene() != nullptr) compareScene(a.scene, *b.Scene());
  ASSERT_NE(b.PhysicsDefault(), nullptr);
  EXPECT_EQ(a.physics.name, b.PhysicsDefault()->Name());
  EXPECT_EQ(a.physics.type, b.PhysicsDefault()->EngineType());
  expectNear(toSeconds(a.physics.maxStepSize), b.PhysicsDefault()->MaxStepSize(), "step");
  expectNear(a.physics.realTimeFactor, b.PhysicsDefault()->RealTimeFactor(), "real time factor");
}

std::vector<fs::path> worlds() {
  std::vector<fs::path> files;
  const auto folder = fortressWorlds();
  if (!folder) return files;
  for (const auto& entry : fs::recursive_directory_iterator(*folder)) {
    if (entry.path().extension() == ".sdf" && entry.file_size() < kMostBytes) files.push_back(entry.path());
  }
  std::sort(files.begin(), files.end());
  return files;
}

/// Reads a file with pongsim and with libsdformat, and compares the results.
/// @param models Folder of models.
void compareFile(const fs::path& file, const fs::path& models) {
  Diagnostics diagnostics;
  const pongsim::sdf::Root root =
      pongsim::sdf::loadFile(file, diagnostics, assets::finderIn({.folders = {models}, .fuelCache = {}}));
  theirs::ParserConfig config;
  config.AddURIPath("model://", models.string());
  config.SetFindCallback([&models](const std::string& name) {
    return fs::exists(models / name) ? (models / name).string() : std::string();
  });
  theirs::Root other;
  const theirs::Errors errors = other.Load(file.string(), config);
  if (!errors.empty()) GTEST_SKIP() << "libsdformat does not load it: " << errors.front().Message();
  ASSERT_FALSE(diagnostics.hasErrors()) << format(diagnostics.all().front());
  ASSERT_EQ(root.worlds.size(), other.WorldCount());
  for (std::uint64_t i = 0; i < other.WorldCount(); ++i) compare(root.worlds[i], *other.WorldByIndex(i));
  if (other.Model() != nullptr) {
    ASSERT_EQ(root.models.size(), 1U);
    compare(root.models[0], *other.Model(), root.models[0].name);
  }
}

TEST(SdformatOfOurs, ReadsTheSame) {
  const fs::path folder = projectFolder() / "test/differential/worlds";
  for (const auto& entry : fs::directory_iterator(folder)) {
    SCOPED_TRACE(entry.path().string());
    compareFile(entry.path(), folder);
    EXPECT_FALSE(testing::Test::IsSkipped());
  }
}

class Sdformat : public testing::TestWithParam<fs::path> {};

TEST_P(Sdformat, ReadsTheSame) {
  const auto purpose = kIntended.find(fs::relative(GetParam(), *fortressWorlds()).string());
  if (purpose != kIntended.end()) GTEST_SKIP() << purpose->second;
  compareFile(GetParam(), *fortressWorlds() / "test/models");
}

GTEST_ALLOW_UNINSTANTIATED_PARAMETERIZED_TEST(Sdformat);
INSTANTIATE_TEST_SUITE_P(Fortress, Sdformat, testing::ValuesIn(worlds()), [](const auto& instance) {
  const fs::path relative = fs::relative(instance.param, *fortressWorlds()).replace_extension();
  std::string name = relative.string();
  std::replace_if(
      name.begin(), name.end(), [](unsigned char letter) { return std::isalnum(letter) == 0; }, '_');
  return name;
});

}  // namespace
}  // namespace pongsim::test
