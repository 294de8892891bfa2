#include "log/playback/model_text.hh"

#include <gtest/gtest.h>
#include <ignition/msgs/axis.pb.h>
#include <ignition/msgs/geometry.pb.h>
#include <ignition/msgs/inertial.pb.h>
#include <ignition/msgs/material.pb.h>
#include <ignition/msgs/serialized_map.pb.h>

#include <string>

#include "log/store/failure.hh"
#include "pongsim/components.hh"
#include "support/temp_folder.hh"

namespace pongsim::log {
namespace {

namespace im = ignition::msgs;

constexpr std::uint64_t kWorld = 1;
constexpr std::uint64_t kModel = 2;

class ModelTextTest : public testing::Test {
 protected:
  ModelTextTest() {
    set(kWorld, "World");
    add(kModel, kWorld, "Model", "robot");
  }

  /// Adds a component to an entity.
  void set(std::uint64_t entity, const std::string& component, const std::string& bytes = {}) {
    im::SerializedStateMap message;
    auto& known = (*message.mutable_entities())[entity];
    known.set_id(entity);
    const std::uint64_t type = componentType(component);
    auto& added = (*known.mutable_components())[static_cast<std::int64_t>(type)];
    added.set_type(type);
    added.set_component(bytes);
    ASSERT_TRUE(state_.apply("ignition.msgs.SerializedStateMap", message.SerializeAsString()));
  }
  /// Adds a child entity.
  void add(std::uint64_t entity, std::uint64_t parent, const std::string& kind, const std::string& name) {
    set(entity, kind);
    set(entity, "Name", name);
    set(entity, "ParentEntity", std::to_string(parent));
  }
  std::string text(std::uint64_t model = kModel) const { return modelText(state_, model, files_); }
  /// @return The content of the model, which is not static and has no pose.
  std::string content() const {
    const std::string whole = text();
    const std::string begin = "<sdf version='1.9'><model name='robot'><static>false</static>", end = "</model></sdf>";
    if (!whole.starts_with(begin) || !whole.ends_with(end)) return "something else: " + whole;
    return whole.substr(begin.size(), whole.size() - begin.size() - end.size());
  }
  /// @return The shape of a collision with that geometry.
  std::string shape(const im::Geometry& geometry) {
    add(3, kModel, "Link", "base");
    add(4, 3, "Collision", "c");
    set(4, "Geometry", geometry.SerializeAsString());
    const std::string whole = content();
    const std::string begin = "<link name='base'><collision name='c'><geometry>",
                      end = "</geometry></collision></link>";
    if (!whole.starts_with(begin) || !whole.ends_with(end)) return "something else: " + whole;
    return whole.substr(begin.size(), whole.size() - begin.size() - end.size());
  }

  test::TempFolder folder_;
  PlayedFiles files_{folder_.write("state.tlog", "")};
  RecordedState state_;
};

TEST_F(ModelTextTest, IsWhatTheRecorderToldInOnePiece) {
  set(kModel, "ModelSdf", "<sdf version='1.9'><model name='as_told'><static>1</static></model></sdf>");
  EXPECT_NE(text().find("as_told"), std::string::npos) << text();
}

TEST_F(ModelTextTest, HasWhatHoldsForTheModel) {
  set(kModel, "Pose", "1 2 3 0 0 0.5");
  set(kModel, "Static", "1");
  EXPECT_EQ(text(),
            "<sdf version='1.9'><model name='robot'><pose>1 2 3 0 0 0.5</pose><static>true</static></model></sdf>");
}

TEST_F(ModelTextTest, EscapesNames) {
  set(kModel, "Name", "a<'b'>&c");
  EXPECT_NE(text().find("<model name='a&lt;&apos;b&apos;>&amp;c'>"), std::string::npos) << text();
}

TEST_F(ModelTextTest, HasLinksWithTheirMasses) {
  add(3, kModel, "Link", "base");
  set(3, "Pose", "0 0 0.1 0 0 0");
  im::Inertial inertial;
  inertial.set_mass(2);
  inertial.mutable_pose()->mutable_position()->set_z(0.5);
  inertial.mutable_pose()->mutable_orientation()->set_w(1);
  inertial.set_ixx(0.1);
  inertial.set_iyy(0.2);
  inertial.set_izz(0.3);
  set(3, "Inertial", inertial.SerializeAsString());
  EXPECT_EQ(
      content(),
      "<link name='base'><pose>0 0 0.1 0 0 0</pose><inertial><pose>0 0 0.5 0 0 0</pose><mass>2</mass><inertia>"
      "<ixx>0.1</ixx><ixy>0</ixy><ixz>0</ixz><iyy>0.2</iyy><iyz>0</iyz><izz>0.3</izz></inertia></inertial></link>");
}

TEST_F(ModelTextTest, HasShapesOfAllKinds) {
  im::Geometry geometry;
  geometry.set_type(im::Geometry::EMPTY);
  EXPECT_EQ(shape(geometry), "<empty></empty>");
  geometry.set_type(im::Geometry::BOX);
  geometry.mutable_box()->mutable_size()->set_x(1.5);
  EXPECT_EQ(shape(geometry), "<box><size>1.5 0 0</size></box>");
  geometry.set_type(im::Geometry::SPHERE);
  geometry.mutable_sphere()->set_radius(2);
  EXPECT_EQ(shape(geometry), "<sphere><radius>2</radius></sphere>");
  geometry.set_type(im::Geometry::CYLINDER);
  geometry.mutable_cylinder()->set_radius(0.25);
  geometry.mutable_cylinder()->set_length(3);
  EXPECT_EQ(shape(geometry), "<cylinder><radius>0.25</radius><length>3</length></cylinder>");
  geometry.set_type(im::Geometry::CAPSULE);
  geometry.mutable_capsule()->set_radius(0.5);
  geometry.mutable_capsule()->set_length(4);
  EXPECT_EQ(shape(geometry), "<capsule><radius>0.5</radius><length>4</length></capsule>");
  geometry.set_type(im::Geometry::ELLIPSOID);
  geometry.mutable_ellipsoid()->mutable_radii()->set_y(5);
  EXPECT_EQ(shape(geometry), "<ellipsoid><radii>0 5 0</radii></ellipsoid>");
  geometry.set_type(im::Geometry::PLANE);
  geometry.mutable_plane()->mutable_normal()->set_z(1);
  geometry.mutable_plane()->mutable_size()->set_x(6);
  EXPECT_EQ(shape(geometry), "<plane><normal>0 0 1</normal><size>6 0</size></plane>");
  geometry.set_type(im::Geometry::MESH);
  geometry.mutable_mesh()->set_filename("a&b.dae");
  geometry.mutable_mesh()->set_submesh("lid");
  geometry.mutable_mesh()->set_center_submesh(true);
  EXPECT_EQ(shape(geometry),
            "<mesh><uri>a&amp;b.dae</uri><submesh><name>lid</name><center>true</center></submesh></mesh>");
}

TEST_F(ModelTextTest, HasMaterialsOfVisuals) {
  add(3, kModel, "Link", "base");
  add(4, 3, "Visual", "v");
  im::Material material;
  material.mutable_diffuse()->set_r(1);
  material.mutable_diffuse()->set_a(0.5);
  set(4, "Material", material.SerializeAsString());
  EXPECT_EQ(content(),
            "<link name='base'><visual name='v'><geometry><empty></empty></geometry><material>"
            "<ambient>0 0 0 0</ambient><diffuse>1 0 0 0.5</diffuse><specular>0 0 0 0</specular>"
            "<emissive>0 0 0 0</emissive></material></visual></link>");
}

TEST_F(ModelTextTest, HasJointsWithTheirAxes) {
  add(5, kModel, "Joint", "hinge");
  set(5, "JointType", "6");
  set(5, "ParentLinkName", "base");
  set(5, "ChildLinkName", "rod");
  im::Axis axis;
  axis.mutable_xyz()->set_z(1);
  set(5, "JointAxis", axis.SerializeAsString());
  EXPECT_EQ(content(),
            "<joint name='hinge' type='revolute'><parent>base</parent><child>rod</child><axis><xyz>0 0 1</xyz></axis>"
            "</joint>");
}

TEST_F(ModelTextTest, LeavesOutJointsOfNoKnownType) {
  add(5, kModel, "Joint", "hinge");
  for (const char* type : {"", "0", "10", "x"}) {
    set(5, "JointType", type);
    EXPECT_EQ(content(), "") << type;
  }
}

TEST_F(ModelTextTest, HasNestedModels) {
  add(3, kModel, "Model", "inner");
  add(4, 3, "Link", "l");
  EXPECT_EQ(content(), "<model name='inner'><static>false</static><link name='l'></link></model>");
}

TEST_F(ModelTextTest, RefusesModelsThatHoldThemselves) {
  // as in a damaged log
  set(kWorld, "Model");
  set(kWorld, "ParentEntity", std::to_string(kWorld));
  EXPECT_THROW(text(kWorld), Failure);
}

TEST_F(ModelTextTest, LeavesOutWhatCantBeRead) {
  add(3, kModel, "Link", "base");
  set(3, "Inertial", "\xff\xff\xff");
  EXPECT_EQ(content(), "<link name='base'></link>");
}

}  // namespace
}  // namespace pongsim::log
