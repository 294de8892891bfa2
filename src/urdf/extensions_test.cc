#include "urdf/extensions.hh"

#include "support/urdf/robot_support.hh"

namespace pongsim::urdf::test {
namespace {

const std::string kSkin =
    "<collision><geometry><sphere radius='1'/></geometry></collision>"
    "<visual><geometry><sphere radius='1'/></geometry></visual>";

std::string gazebo(const std::string& reference, const std::string& content) {
  return "<gazebo reference='" + reference + "'>" + content + "</gazebo>\n";
}

TEST(Extensions, SetTheSurfaceOfALink) {
  const Converted converted =
      convert(linkNamed("a", kSkin) +
              gazebo("a",
                     "<mu1>0.5</mu1><mu2 value='0.6'/><fdir1>1 0 0</fdir1><kp>10</kp><kd>1</kd><maxVel>2</maxVel>"
                     "<minDepth>0.1</minDepth><maxContacts>3</maxContacts><laserRetro>7</laserRetro>"));
  EXPECT_EQ(converted.messages, Messages());
  const Element& collision = *converted.part("link", "a").child("collision");
  EXPECT_EQ(textAt(collision, "surface/friction/ode/mu"), "0.5");
  EXPECT_EQ(textAt(collision, "surface/friction/ode/mu2"), "0.6");
  EXPECT_EQ(textAt(collision, "surface/friction/ode/fdir1"), "1 0 0");
  EXPECT_EQ(textAt(collision, "surface/contact/ode/kp"), "10");
  EXPECT_EQ(textAt(collision, "surface/contact/ode/kd"), "1");
  EXPECT_EQ(textAt(collision, "surface/contact/ode/max_vel"), "2");
  EXPECT_EQ(textAt(collision, "surface/contact/ode/min_depth"), "0.1");
  EXPECT_EQ(textAt(collision, "max_contacts"), "3");
  EXPECT_EQ(textAt(collision, "laser_retro"), "7");
}

TEST(Extensions, SetWhatALinkDoes) {
  const Converted converted =
      convert(linkNamed("a") + gazebo("a",
                                      "<selfCollide>True</selfCollide><turnGravityOff>yes</turnGravityOff>"
                                      "<dampingFactor>0.1</dampingFactor><kinematic>true</kinematic>"));
  const Element& link = converted.part("link", "a");
  EXPECT_EQ(textAt(link, "self_collide"), "true");
  EXPECT_EQ(textAt(link, "gravity"), "false");
  EXPECT_EQ(textAt(link, "velocity_decay/linear"), "0.1");
  EXPECT_EQ(textAt(link, "velocity_decay/angular"), "0.1");
  EXPECT_EQ(textAt(link, "kinematic"), "true");
}

TEST(Extensions, PutTheContentsOfCollisionAndVisualIntoAllOfALink) {
  const Converted converted =
      convert(linkNamed("a", kSkin + kSkin) +
              gazebo("a",
                     "<material>Gazebo/Red</material><collision><surface><bounce/></surface></collision>"
                     "<visual><transparency>0.5</transparency></visual><mu1>2</mu1>"));
  for (const Element* collision : converted.part("link", "a").childrenNamed("collision")) {
    EXPECT_EQ(textAt(*collision, "surface/bounce"), "");
    EXPECT_EQ(textAt(*collision, "surface/friction/ode/mu"), "2");
  }
  const auto visuals = converted.part("link", "a").childrenNamed("visual");
  ASSERT_EQ(visuals.size(), 2U);
  for (const Element* visual : visuals) {
    EXPECT_EQ(textAt(*visual, "transparency"), "0.5");
    EXPECT_EQ(textAt(*visual, "material/script/name"), "Gazebo/Red");
  }
}

TEST(Extensions, OfALumpedLinkGoToItsParts) {
  const Converted converted =
      convert(linkNamed("a", kSkin) + linkNamed("b", kSkin) + jointNamed("j", "fixed", "a", "b") +
              gazebo("b",
                     "<mu1>0.5</mu1><sensor name='s' type='imu'><pose>0 0 1 0 0 0</pose></sensor>"
                     "<sensor name='t' type='imu'/><gravity>0</gravity>"));
  EXPECT_EQ(converted.messages, Messages());
  const Element& link = converted.part("link", "a");
  const auto collisions = link.childrenNamed("collision");
  EXPECT_EQ(textAt(*collisions.at(0), "surface/friction/ode/mu"), "(none)");
  EXPECT_EQ(textAt(*collisions.at(1), "surface/friction/ode/mu"), "0.5");
  const auto sensors = link.childrenNamed("sensor");
  ASSERT_EQ(sensors.size(), 2U);
  EXPECT_EQ(textAt(*sensors[0], "pose"), "0 0 1 0 0 0");
  for (const Element* sensor : sensors) EXPECT_EQ(sensor->child("pose")->attributeOr("relative_to", ""), "b");
  EXPECT_EQ(textAt(link, "gravity"), "0");
}

TEST(Extensions, SetWhatAJointDoes) {
  const Converted converted =
      convert(linkNamed("a") + linkNamed("b") + jointNamed("j", "continuous", "a", "b") +
              gazebo("j",
                     "<springStiffness>3</springStiffness><springReference>1</springReference>"
                     "<stopErp>0.2</stopErp><stopCfm>0.1</stopCfm><fudgeFactor>0.5</fudgeFactor>"
                     "<provideFeedback>true</provideFeedback><implicitSpringDamper>1</implicitSpringDamper>"
                     "<sensor name='s' type='force_torque'/>"));
  EXPECT_EQ(converted.messages, Messages());
  const Element& joint = converted.part("joint", "j");
  EXPECT_EQ(textAt(joint, "axis/dynamics/spring_stiffness"), "3");
  EXPECT_EQ(textAt(joint, "axis/dynamics/spring_reference"), "1");
  EXPECT_EQ(textAt(joint, "physics/ode/limit/erp"), "0.2");
  EXPECT_EQ(textAt(joint, "physics/ode/limit/cfm"), "0.1");
  EXPECT_EQ(textAt(joint, "physics/ode/fudge_factor"), "0.5");
  EXPECT_EQ(textAt(joint, "physics/provide_feedback"), "true");
  EXPECT_EQ(textAt(joint, "physics/ode/implicit_spring_damper"), "true");
  EXPECT_EQ(joint.child("sensor")->attributeOr("name", ""), "s");
}

TEST(Extensions, WithoutReferenceGoToTheModel) {
  const Converted converted = convert(linkNamed("a") +
                                      "<gazebo><static>true</static><plugin filename='f' name='n'><x>1</x></plugin>"
                                      "</gazebo><gazebo><self_collide>true</self_collide></gazebo>");
  EXPECT_EQ(converted.messages, Messages());
  EXPECT_EQ(textAt(converted.model(), "static"), "true");
  EXPECT_EQ(textAt(converted.model(), "self_collide"), "true");
  EXPECT_EQ(textAt(converted.model(), "plugin/x"), "1");
  EXPECT_EQ(converted.model().child("plugin")->attributeOr("filename", ""), "f");
}

TEST(Extensions, OfTheModelSayWhetherItIsStatic) {
  EXPECT_EQ(textAt(convert(linkNamed("a") + "<gazebo><self_collide>true</self_collide></gazebo>").model(), "static"),
            "false");
  EXPECT_EQ(textAt(convert(linkNamed("a")).model(), "static"), "(none)");
}

TEST(Extensions, PreferAKeptJointToALockedOne) {
  const Element robot = robotWith(gazebo("j", "<disableFixedJointLumping>true</disableFixedJointLumping>") +
                                  gazebo("j", "<preserveFixedJoint>true</preserveFixedJoint>") +
                                  gazebo("k", "<preserveFixedJoint>false</preserveFixedJoint>"));
  const Extensions extensions(robot);
  EXPECT_EQ(extensions.fixingOf("j"), Extensions::Fixing::kKept);
  EXPECT_EQ(extensions.fixingOf("k"), Extensions::Fixing::kLumped);
}

TEST(Extensions, SayWhatHasNoEffect) {
  EXPECT_EQ(convert(linkNamed("arm") + "<gazebo reference='amr'/>\n<gazebo><mu1>1</mu1></gazebo>\n" +
                    gazebo("arm", "<stopErp>1</stopErp><static>1</static><canonicalBody/>"))
                .messages,
            (Messages{
                "r.urdf:3:9: warning: <gazebo> refers to 'amr', which is not a link or joint | did you mean 'arm'?",
                "r.urdf:4:9: warning: <mu1> has no effect on the robot | put it in <gazebo reference=\"...\"> with the "
                "name of a link",
                "r.urdf:5:25: warning: <stopErp> has no effect on link 'arm' | put it in <gazebo reference=\"...\"> "
                "with the name of a joint",
                "r.urdf:5:45: warning: <static> has no effect on link 'arm' | put it in a <gazebo> without a reference",
            }));
}

}  // namespace
}  // namespace pongsim::urdf::test
