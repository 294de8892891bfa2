#include "sdf/includes/model_document.hh"

#include "support/sdf/load_support.hh"
#include "support/temp_folder.hh"

namespace pongsim::sdf::test {
namespace {

constexpr std::string_view kRobot = R"(<robot name="r">
<link name="base"><inertial><mass value="2"/><inertia ixx="1" ixy="0" ixz="0" iyy="1" iyz="0" izz="1"/></inertial></link>
<link name="wheel"><inertial><mass value="1"/><inertia ixx="1" ixy="0" ixz="0" iyy="1" iyz="0" izz="1"/></inertial>
<collision><geometry><sphere radius="0.1"/></geometry></collision></link>
<joint name="axle" type="continuous"><parent link="base"/><child link="wheel"/><origin xyz="0 1 0" rpy="1 0 0"/>
<axis xyz="0 0 1"/></joint><gazebo reference="wheel"><mu1>0.3</mu1></gazebo>
</robot>)";

TEST(ModelDocument, ReadsARobotAsAModel) {
  const Loaded loaded = load(kRobot);
  EXPECT_EQ(loaded.messages, Messages());
  ASSERT_EQ(loaded.root.models.size(), 1U);
  const description::Model& model = loaded.root.models[0];
  EXPECT_EQ(model.name, "r");
  ASSERT_EQ(model.links.size(), 2U);
  expectPose(model.links[1].X_ModelLink, {0, 1, 0}, fromRollPitchYaw(1, 0, 0));
  EXPECT_EQ(model.links[1].collisions.at(0).surface.mu, 0.3);
  EXPECT_EQ(model.links[1].position.line, 3);
  ASSERT_EQ(model.joints.size(), 1U);
  EXPECT_EQ(model.joints[0].parent, "base");
  expectPose(model.joints[0].X_ChildJoint, {0, 0, 0});
  EXPECT_EQ(model.joints[0].axes.at(0).xyz, Vector3(0, 0, 1));
  ASSERT_NE(model.urdf.source, nullptr);
  EXPECT_EQ(model.urdf.source->text, kRobot);
  EXPECT_EQ(model.urdf.source->robot.children.at(2).position.line, 5);
}

TEST(ModelDocument, PointsIntoTheUrdfWhereTheModelIsWrong) {
  EXPECT_EQ(
      load("<robot name='r'>\n<link name='a'><inertial><mass value='1'/>\n<inertia ixx='-1' ixy='0' ixz='0' iyy='1' "
           "iyz='0' izz='1'/></inertial>\n<collision><geometry>\n<sphere radius='-1'/></geometry></collision></link>"
           "</robot>")
          .messages,
      (Messages{
          "t.sdf:2:16: error: the inertia of link 'a' of model 'r' is not positive definite | ixx, iyy and izz must be "
          "above zero, and ixy, ixz and iyz small enough",
          "t.sdf:4:12: error: <radius> is '-1', which is not a finite number above zero",
      }));
}

TEST(ModelDocument, CanBeIncluded) {
  const pongsim::test::TempFolder folder;
  folder.write("r.urdf", kRobot);
  folder.write("model/model.config", "<model><sdf version='1.9'>../r.urdf</sdf></model>");
  folder.write("w.sdf",
               "<sdf version='1.9'><world name='w'><include><uri>r.urdf</uri><name>first</name><pose>0 0 1 0 0 0</pose>"
               "</include><include><uri>model://model</uri></include></world></sdf>");
  const Loaded loaded = load([&](Diagnostics& diagnostics) {
    return loadFile(folder.path() / "w.sdf", diagnostics, assets::finderIn({{folder.path()}, {}}));
  });
  EXPECT_EQ(loaded.messages, Messages());
  ASSERT_EQ(loaded.world().models.size(), 2U);
  EXPECT_EQ(loaded.model().name, "first");
  expectPose(loaded.model().X_ParentModel, {0, 0, 1});
  EXPECT_EQ(loaded.world().models[1].name, "r");
  ASSERT_NE(loaded.model().urdf.source, nullptr);
  EXPECT_EQ(loaded.model().urdf, loaded.world().models[1].urdf);
}

TEST(ModelDocument, IsKeptAsUrdfByItsOwnModelAlone) {
  const Loaded loaded = load(
      "<robot name='r'><link name='base'><inertial><mass value='2'/><inertia ixx='1' ixy='0' ixz='0' iyy='1' iyz='0' "
      "izz='1'/></inertial></link><gazebo><model name='load'><link name='l'/></model></gazebo></robot>");
  EXPECT_EQ(loaded.messages, Messages());
  ASSERT_EQ(loaded.root.models.size(), 1U);
  EXPECT_NE(loaded.root.models[0].urdf.source, nullptr);
  ASSERT_EQ(loaded.root.models[0].models.size(), 1U);
  EXPECT_EQ(loaded.root.models[0].models[0].urdf.source, nullptr);
  EXPECT_EQ(load("<sdf version='1.9'><model name='m'><link name='l'/></model></sdf>").root.models.at(0).urdf.source,
            nullptr);
}

}  // namespace
}  // namespace pongsim::sdf::test
