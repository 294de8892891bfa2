#include "sdf/upgrade.hh"

#include "sdf/includes/includes.hh"
#include "sdf/text/document.hh"
#include "support/sdf/load_support.hh"

namespace pongsim::sdf::test {
namespace {

/// @return Two links, the second one turned by a right angle, and a joint with this axis.
std::string turnedJoint(const std::string& axis) {
  return "<link name='a'/><link name='b'><pose>0 0 0 0 0 1.5707963267948966</pose></link>"
         "<joint name='j' type='revolute'><parent>a</parent><child>b</child>\n<axis>" +
         axis + "</axis></joint>";
}

TEST(Upgrade, TakesAxesOfSdf14AsTheModels) {
  const auto axis = [](std::string_view version) {
    const Loaded loaded = loadModel(turnedJoint("<xyz>0 1 0</xyz>"), version);
    EXPECT_EQ(loaded.messages, Messages());
    return loaded.model().joints.at(0).axes.at(0).xyz;
  };
  EXPECT_LT((axis("1.4") - Vector3(1, 0, 0)).norm(), 1e-15);
  EXPECT_LT((axis("1.5") - Vector3(0, 1, 0)).norm(), 1e-15);
}

TEST(Upgrade, ReadsTheFlagOfAxes) {
  const auto load = [](const std::string& flag) {
    return loadModel(turnedJoint("<use_parent_model_frame>" + flag +
                                 "</use_parent_model_frame>"
                                 "<xyz>0 1 0</xyz>"),
                     "1.6");
  };
  EXPECT_EQ(load("1").messages, Messages());
  EXPECT_LT((load("1").model().joints.at(0).axes.at(0).xyz - Vector3(1, 0, 0)).norm(), 1e-15);
  EXPECT_LT((load("false").model().joints.at(0).axes.at(0).xyz - Vector3(0, 1, 0)).norm(), 1e-15);
  EXPECT_EQ(load("x").messages,
            Messages{"t.sdf:4:7: error: <use_parent_model_frame> is 'x', which is not 'true' or 'false'"});
  // without a vector, the default one is in the model's frame
  const Loaded loaded = loadModel(turnedJoint("<use_parent_model_frame>1</use_parent_model_frame>"), "1.6");
  EXPECT_LT((loaded.model().joints.at(0).axes.at(0).xyz - Vector3(0, 0, 1)).norm(), 1e-15);
}

TEST(Upgrade, DropsTheInitialPositionOfJoints) {
  const std::string joint = turnedJoint("<initial_position>1</initial_position>");
  EXPECT_EQ(loadModel(joint, "1.7").messages,
            Messages{"t.sdf:4:7: warning: <initial_position> has no effect in <axis> | SDF 1.8 removed it"});
}

TEST(Upgrade, RenamesTheFrameOfPoses) {
  const std::string model =
      "<frame name='f'><pose>1 0 0 0 0 0</pose></frame><link name='l'><pose frame='f'>1 2 3 0 0 0</pose></link>";
  const Loaded loaded = loadModel(model, "1.6");
  EXPECT_EQ(loaded.messages, Messages());
  expectPose(loaded.model().links.at(0).X_ModelLink, {2, 2, 3});
  EXPECT_EQ(loadModel(model, "1.7").messages.size(), 1U);
}

TEST(Upgrade, LeavesPluginsAlone) {
  const Loaded loaded = loadWorld("<plugin filename='f' name='n'><pose frame='f'/></plugin>", "1.6");
  EXPECT_EQ(loaded.messages, Messages());
  EXPECT_NE(loaded.world().plugins.at(0).sdf.child("pose")->attribute("frame"), nullptr);
}

TEST(Upgrade, MovesGravityAndTheMagneticFieldToTheWorld) {
  const std::string physics = "<physics><gravity>1 2 3</gravity><magnetic_field>4 5 6</magnetic_field></physics>";
  const Loaded loaded = loadWorld(physics, "1.5");
  EXPECT_EQ(loaded.messages, Messages());
  EXPECT_EQ(loaded.world().gravity, Vector3(1, 2, 3));
  EXPECT_EQ(loaded.world().environment.magneticField, Vector3(4, 5, 6));
  EXPECT_EQ(loadWorld(physics, "1.6").world().gravity, Vector3(0, 0, -9.8));
  // the first profile counts, and the world's own <gravity> before it
  const Loaded second =
      loadWorld("<physics/><physics><gravity>1 2 3</gravity></physics><gravity>7 8 9</gravity>", "1.5");
  EXPECT_EQ(second.world().gravity, Vector3(7, 8, 9));
  EXPECT_EQ(second.messages,
            Messages{"t.sdf:2:20: warning: <gravity> has no effect in <physics> | SDF 1.6 removed it"});
}

TEST(Upgrade, GivesNewNamesToPartsOfTheSameName) {
  const Loaded loaded = loadModel(
      "<link name='a'/>\n<joint name='b' type='fixed'><parent>a</parent><child>b</child></joint>\n<link name='b'/>\n"
      "<frame name='b'/><frame name='b_joint'/>",
      "1.6");
  const std::string hint = " | as in Fortress; from SDF 1.7 this is an error";
  const std::string is = "' has the same name as another part of its model: it is renamed to '";
  EXPECT_EQ(loaded.messages, (Messages{"t.sdf:4:8: warning: joint 'b" + is + "b_joint'" + hint,
                                       "t.sdf:6:8: warning: frame 'b" + is + "b_frame'" + hint,
                                       "t.sdf:6:25: warning: frame 'b_joint" + is + "b_joint_frame'" + hint}));
  EXPECT_EQ(loaded.model().joints.at(0).name, "b_joint");
  EXPECT_EQ(loaded.model().joints.at(0).child, "b");
  // two parts of the same kind are not renamed
  EXPECT_EQ(loadModel("<link name='a'/><link name='a'/>", "1.6").messages.size(), 1U);
  EXPECT_TRUE(loadModel("<link name='a'/><frame name='a'/>", "1.7").messages.at(0).find("error") != std::string::npos);
}

TEST(Upgrade, KeepsInertialsInTheirLinks) {
  const std::string link =
      "<link name='l'>\n<inertial><pose relative_to='__model__'>1 0 0 0 0 0</pose></inertial></link>";
  EXPECT_EQ(loadModel(link, "1.7").messages,
            Messages{"t.sdf:4:17: warning: attribute 'relative_to' has no effect in <pose> | SDF 1.8 removed it"});
  EXPECT_EQ(loadModel(link, "1.8").messages,
            Messages{"t.sdf:4:17: warning: attribute 'relative_to' is obsolete in <pose> | SDF 1.8 removed it"});
  EXPECT_EQ(loadModel("<link name='l'><inertial><pose relative_to=''/></inertial></link>", "1.7").messages, Messages());
}

TEST(Upgrade, GivesEachAxisOfAnImuItsNoise) {
  const std::string imu =
      "<link name='l'><sensor name='s' type='imu'><imu><noise><type>gaussian</type><rate><mean>1</mean>"
      "<stddev>2</stddev></rate><accel><bias_mean>3</bias_mean></accel></noise></imu></sensor></link>";
  Element root;
  Diagnostics diagnostics;
  Includes includes(assets::finderIn({}), diagnostics, diagnostics);
  Context context{.diagnostics = diagnostics, .unsimulated = diagnostics, .includes = includes, .version = 5};
  root = *parseDocument("<sdf version='1.5'><model name='m'>" + imu + "</model></sdf>", nullptr, diagnostics);
  upgrade(root, context);
  EXPECT_TRUE(diagnostics.all().empty());
  EXPECT_EQ(root.attributeOr("version", ""), "1.9");
  const Element& upgraded = root.children.at(0).children.at(0).children.at(0).children.at(0);
  EXPECT_EQ(upgraded.child("noise"), nullptr);
  for (const char* axis : {"x", "y", "z"}) {
    const Element* rate = upgraded.child("angular_velocity")->child(axis)->child("noise");
    EXPECT_EQ(rate->attributeOr("type", ""), "gaussian");
    EXPECT_EQ(rate->get<double>("mean", 0), 1);
    EXPECT_EQ(rate->get<double>("stddev", 0), 2);
    const Element* acceleration = upgraded.child("linear_acceleration")->child(axis)->child("noise");
    EXPECT_EQ(acceleration->get<double>("bias_mean", 0), 3);
  }
}

TEST(Upgrade, LeadsToTheNewestVersionWhereFortressCannotReadTheFile) {
  Diagnostics diagnostics;
  Includes includes(assets::finderIn({}), diagnostics, diagnostics);
  for (const int version : {10, 11, 12}) {
    Context context{.diagnostics = diagnostics, .unsimulated = diagnostics, .includes = includes, .version = version};
    Element root = *parseDocument("<sdf version='1." + std::to_string(version) +
                                      "'><world name='w'><state world_name='w'><model name='m'/></state></world></sdf>",
                                  nullptr, diagnostics);
    upgrade(root, context);
    EXPECT_EQ(root.attributeOr("version", ""), "1.12");
    EXPECT_TRUE(root.children.at(0).children.at(0).children.empty());
  }
  // the check of elements says it of files of 1.12
  EXPECT_EQ(diagnostics.all().size(), 2U);
}

}  // namespace
}  // namespace pongsim::sdf::test
