#include "support/sdf/load_support.hh"

namespace pongsim::sdf::test {
namespace {

TEST(ElementCheck, NamesTheElementThatIsMeant) {
  EXPECT_EQ(loadLink("<colision name='c'/>").messages,
            Messages{"t.sdf:4:1: warning: <colision> is unknown in <link> | did you mean 'collision'?"});
  EXPECT_EQ(loadLink("<gravity nam='c'/>").messages,
            Messages{"t.sdf:4:10: warning: attribute 'nam' is unknown in <gravity>"});
  EXPECT_EQ(loadLink("<sensor name='s' type='imu' typ='x'/>").messages.at(0),
            "t.sdf:4:29: warning: attribute 'typ' is unknown in <sensor> | did you mean 'type'?");
}

TEST(ElementCheck, WarnsOnceAName) { EXPECT_EQ(loadLink("<colision/><colision/>").messages.size(), 1U); }

TEST(ElementCheck, LeavesTheUsersOwnAlone) {
  EXPECT_EQ(loadWorld("<plugin filename='a' name='b'><x y='z'/></plugin><gui><plugin filename='a' "
                      "name='b'><x/></plugin></gui><my:thing><x/></my:thing>"
                      "<model name='m' my:attribute='1'><link name='l'/></model>")
                .messages,
            Messages());
}

TEST(ElementCheck, LeavesWhatACustomSensorHasToItsSystem) {
  const std::string sensor = "<sensor name='s' type='custom' gz:type='environmental_sensor/heat'>";
  EXPECT_EQ(loadLink(sensor + "<output_format>scalar</output_format></sensor>").messages, Messages());
  EXPECT_EQ(loadLink(sensor + "<update_rate>often</update_rate></sensor>").messages.size(), 1U);
}

TEST(ElementCheck, KnowsWhenAnElementWasTakenOut) {
  const std::string joint =
      "<link name='a'/><link name='b'/><joint name='j' type='revolute'><parent>a</parent><child>b</child>\n"
      "<axis><use_parent_model_frame>0</use_parent_model_frame></axis></joint>";
  EXPECT_EQ(loadModel(joint, "1.6").messages, Messages());
  EXPECT_EQ(loadModel(joint, "1.7").messages,
            Messages{"t.sdf:4:7: warning: <use_parent_model_frame> is obsolete in <axis> | SDF 1.7 removed it"});
}

TEST(ElementCheck, KnowsNestedAndSharedElements) {
  EXPECT_EQ(
      loadModel("<link name='l'><visual name='v'><geometry><box/></geometry><material><ambient>1 1 1 1</ambient><pbr>"
                "<metal><roughness>1</roughness></metal></pbr></material></visual><inertial><pose/></inertial></link>"
                "<model name='i'><link name='l'><pose relative_to='__model__'/></link></model>")
          .messages,
      Messages());
}

}  // namespace
}  // namespace pongsim::sdf::test
