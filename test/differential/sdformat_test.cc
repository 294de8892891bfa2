// The worlds of Fortress as pongsim and as libsdformat 12 read them: poses, axes, masses and shapes are the same.

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <map>
#include <sdf/sdf.hh>
#include <string>
#include <vector>

#include "pongsim/diagnostic.hh"
#include "sdf/loader.hh"
#include "support/fortress_worlds.hh"

namespace pongsim::test {
namespace {

namespace fs = std::filesystem;
namespace theirs = ::sdf;
namespace ours = pongsim::description;

constexpr double kTolerance = 1e-9;
/// libsdformat takes minutes and gigabytes for more.
constexpr std::uintmax_t kMostBytes = 1'000'000;

/// Files that are read otherwise here, and why.
const std::map<std::string, std::string> kOnPurpose = {
    {"test/models/include_nested/model.sdf", "it includes nested_models, below"},
    {"test/models/nested_models/model.sdf",
     "joint_01 connects a link with itself by two frames: it is left out with a warning"}};

Vector3 vector(const ignition::math::Vector3d& v) { return {v.X(), v.Y(), v.Z()}; }

Pose pose(const ignition::math::Pose3d& X) {
  return {vector(X.Pos()), Quaternion(X.Rot().W(), X.Rot().X(), X.Rot().Y(), X.Rot().Z())};
}

Matrix3 matrix(const ignition::math::Matrix3d& m) {
  Matrix3 result;
  for (int i = 0; i < 3; ++i) {
    for (int j = 0; j < 3; ++j) result(i, j) = m(static_cast<std::size_t>(i), static_cast<std::size_t>(j));
  }
  return result;
}

template <class Thing>
Pose resolved(const Thing& thing, const std::string& to = "") {
  ignition::math::Pose3d result;
  const theirs::Errors errors = thing.SemanticPose().Resolve(result, to);
  EXPECT_TRUE(errors.empty()) << errors.front();
  return pose(result);
}

void expectNear(const Vector3& a, const Vector3& b, const std::string& what) {
  EXPECT_LE((a - b).norm(), kTolerance * std::max(1.0, b.norm()))
      << what << ": " << a.transpose() << " and " << b.transpose();
}

void expectNear(const Pose& a, const Pose& b, const std::string& what) {
  expectNear(a.position, b.position, what);
  EXPECT_LE(2 * (a.rotation.conjugate() * b.rotation).vec().norm(), kTolerance)
      << what << ": " << a.rotation.coeffs().transpose() << " and " << b.rotation.coeffs().transpose();
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

/// @param name Finds its partner.
template <class Thing>
const Thing* named(const std::vector<Thing>& things, const std::string& name) {
  const auto found = std::ranges::find(things, name, &Thing::name);
  return found == things.end() ? nullptr : &*found;
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
  }
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
    // theirs stands for no limit from 1e16
    const auto limit = [](double value) { return std::clamp(value, -1e16, 1e16); };
    EXPECT_NEAR(limit(a.axes[i].lower), limit(axis->Lower()), kTolerance) << what;
    EXPECT_NEAR(limit(a.axes[i].upper), limit(axis->Upper()), kTolerance) << what;
  }
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
    expectNear(light->X_WorldLight, resolved(*b.LightByIndex(i)), name);
  }
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

class Sdformat : public testing::TestWithParam<fs::path> {};

TEST_P(Sdformat, ReadsTheSame) {
  const auto purpose = kOnPurpose.find(fs::relative(GetParam(), *fortressWorlds()).string());
  if (purpose != kOnPurpose.end()) GTEST_SKIP() << purpose->second;
  Diagnostics diagnostics;
  const fs::path models = *fortressWorlds() / "test/models";
  const pongsim::sdf::Root root =
      pongsim::sdf::loadFile(GetParam(), diagnostics, assets::finderIn({.folders = {models}, .fuelCache = {}}));
  theirs::ParserConfig config;
  config.AddURIPath("model://", models.string());
  config.SetFindCallback([&models](const std::string& name) {
    return fs::exists(models / name) ? (models / name).string() : std::string();
  });
  theirs::Root other;
  const theirs::Errors errors = other.Load(GetParam().string(), config);
  if (!errors.empty()) GTEST_SKIP() << "libsdformat does not load it: " << errors.front().Message();
  ASSERT_FALSE(diagnostics.hasErrors()) << format(diagnostics.all().front());
  ASSERT_EQ(root.worlds.size(), other.WorldCount());
  for (std::uint64_t i = 0; i < other.WorldCount(); ++i) compare(root.worlds[i], *other.WorldByIndex(i));
  if (other.Model() != nullptr) {
    ASSERT_EQ(root.models.size(), 1U);
    compare(root.models[0], *other.Model(), root.models[0].name);
  }
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
