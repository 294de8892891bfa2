#include "web/typed/scene_update.hh"

#include <gtest/gtest.h>

#include <cmath>

namespace pongsim::web::typed {
namespace {

namespace im = ignition::msgs;

class SceneUpdateTest : public testing::Test {
 protected:
  im::Visual& addVisual(im::Geometry::Type type) {
    im::Visual& visual = *link_->add_visual();
    visual.mutable_geometry()->set_type(type);
    return visual;
  }
  ::foxglove::SceneEntity entity() { return sceneUpdate(scene_, 3'000'000'000).entities(0); }

  im::Scene scene_;
  im::Model* model_ = scene_.add_model();
  im::Link* link_ = model_->add_link();
};

TEST_F(SceneUpdateTest, ReplacesAllByAnEntityForEachLink) {
  model_->set_name("rover");
  link_->set_name("chassis");
  im::Model& arm = *model_->add_model();
  arm.set_name("arm");
  arm.add_link()->set_name("hand");
  const auto update = sceneUpdate(scene_, 3'000'000'000);
  ASSERT_EQ(update.deletions_size(), 1);
  EXPECT_EQ(update.deletions(0).type(), ::foxglove::SceneEntityDeletion::ALL);
  ASSERT_EQ(update.entities_size(), 2);
  EXPECT_EQ(update.entities(0).id(), "rover::chassis");
  EXPECT_EQ(update.entities(0).frame_id(), "rover::chassis");
  EXPECT_TRUE(update.entities(0).frame_locked());
  EXPECT_EQ(update.entities(0).timestamp().seconds(), 3);
  EXPECT_EQ(update.entities(1).frame_id(), "rover::arm::hand");
}

TEST_F(SceneUpdateTest, HasShapesInTheirColours) {
  im::Visual& box = addVisual(im::Geometry::BOX);
  box.mutable_geometry()->mutable_box()->mutable_size()->set_y(2);
  box.mutable_pose()->mutable_position()->set_x(7);
  box.mutable_material()->mutable_diffuse()->set_g(0.5F);
  box.mutable_material()->mutable_diffuse()->set_a(1);
  box.set_transparency(0.25);
  addVisual(im::Geometry::SPHERE).mutable_geometry()->mutable_sphere()->set_radius(3);
  addVisual(im::Geometry::CYLINDER).mutable_geometry()->mutable_cylinder()->set_radius(4);
  addVisual(im::Geometry::CONE).mutable_geometry()->mutable_cone()->set_length(5);
  addVisual(im::Geometry::HEIGHTMAP);
  const auto all = entity();
  ASSERT_EQ(all.cubes_size(), 1);
  EXPECT_EQ(all.cubes(0).size().y(), 2);
  EXPECT_EQ(all.cubes(0).pose().position().x(), 7);
  EXPECT_EQ(all.cubes(0).pose().orientation().w(), 1);
  EXPECT_EQ(all.cubes(0).color().g(), 0.5);
  EXPECT_EQ(all.cubes(0).color().a(), 0.75);
  ASSERT_EQ(all.spheres_size(), 1);
  EXPECT_EQ(all.spheres(0).size().x(), 6);
  EXPECT_EQ(all.spheres(0).color().a(), 1);
  ASSERT_EQ(all.cylinders_size(), 2);
  EXPECT_EQ(all.cylinders(0).size().x(), 8);
  EXPECT_EQ(all.cylinders(0).top_scale(), 1);
  EXPECT_EQ(all.cylinders(1).size().z(), 5);
  EXPECT_EQ(all.cylinders(1).top_scale(), 0);
}

TEST_F(SceneUpdateTest, RoundsTheEndsOfCapsules) {
  im::Visual& capsule = addVisual(im::Geometry::CAPSULE);
  capsule.mutable_geometry()->mutable_capsule()->set_radius(1);
  capsule.mutable_geometry()->mutable_capsule()->set_length(4);
  // a quarter turn about x, after which z points along -y
  capsule.mutable_pose()->mutable_orientation()->set_x(std::sqrt(0.5));
  capsule.mutable_pose()->mutable_orientation()->set_w(std::sqrt(0.5));
  const auto all = entity();
  ASSERT_EQ(all.spheres_size(), 2);
  EXPECT_NEAR(all.spheres(0).pose().position().y(), 2, 1e-12);
  EXPECT_NEAR(all.spheres(1).pose().position().y(), -2, 1e-12);
  EXPECT_NEAR(all.spheres(0).pose().position().z(), 0, 1e-12);
}

TEST_F(SceneUpdateTest, LaysPlanesAcrossTheirNormals) {
  for (const auto& [x, z] : {std::pair{0.0, 1.0}, {1.0, 0.0}, {0.6, 0.8}, {0.0, -1.0}}) {
    link_->clear_visual();
    im::PlaneGeom& plane = *addVisual(im::Geometry::PLANE).mutable_geometry()->mutable_plane();
    plane.mutable_normal()->set_x(x);
    plane.mutable_normal()->set_z(z);
    plane.mutable_size()->set_x(2);
    plane.mutable_size()->set_y(4);
    const auto all = entity();
    ASSERT_EQ(all.triangles_size(), 1);
    ASSERT_EQ(all.triangles(0).points_size(), 6);
    for (const auto& point : all.triangles(0).points()) {
      EXPECT_NEAR(point.x() * x + point.z() * z, 0, 1e-12);
      EXPECT_NEAR(std::hypot(point.x(), point.y(), point.z()), std::hypot(1, 2), 1e-12);
    }
  }
}

TEST_F(SceneUpdateTest, TellsWhereMeshesAre) {
  im::MeshGeom& mesh = *addVisual(im::Geometry::MESH).mutable_geometry()->mutable_mesh();
  mesh.set_filename("model://arm/meshes/ARM.DAE");
  mesh.mutable_scale()->set_x(2);
  const auto all = entity();
  ASSERT_EQ(all.models_size(), 1);
  EXPECT_EQ(all.models(0).url(), "package://pongsim/model/arm/meshes/ARM.DAE");
  EXPECT_EQ(all.models(0).media_type(), "model/vnd.collada+xml");
  EXPECT_EQ(all.models(0).scale().x(), 2);
}

}  // namespace
}  // namespace pongsim::web::typed
