#include <cmath>
#include <limits>
#include <numbers>

#include "support/sdf/load_support.hh"

namespace pongsim::sdf::test {
namespace {

constexpr double kInfinity = std::numeric_limits<double>::infinity();

/// Loads a joint 'j', in line 4, between the links 'a' and 'b', which is turned by 90 degrees about z.
Loaded loadJoint(std::string_view joint, std::string_view version = "1.9") {
  return loadModel(
      "<link name='a'><pose>1 0 0 0 0 0</pose></link><link name='b'><pose degrees='1'>2 0 0 0 0 90</pose></link>\n" +
          std::string(joint),
      version);
}

const std::string kLinks = "<parent>a</parent><child>b</child>";

TEST(Joint, IsMeasuredInItsChildByDefault) {
  const Loaded loaded =
      loadJoint("<joint name='j' type='revolute'><pose>0 1 0 0 0 0</pose>" + kLinks + "<axis/></joint>");
  EXPECT_EQ(loaded.messages, Messages());
  const description::Joint& joint = loaded.model().joints.at(0);
  EXPECT_EQ(joint.parent, "a");
  EXPECT_EQ(joint.child, "b");
  expectPose(joint.X_ChildJoint, {0, 1, 0});
  expectPose(joint.X_ParentJoint, {0, 0, 0}, fromRollPitchYaw(0, 0, std::numbers::pi / 2));
}

TEST(Joint, TurnsItsAxisIntoItsOwnFrame) {
  const auto axis = [](const std::string& xyz, std::string_view version = "1.9", const std::string& more = "") {
    const Loaded loaded =
        loadJoint("<joint name='j' type='revolute'>" + kLinks + "<axis>" + xyz + more + "</axis></joint>", version);
    EXPECT_EQ(loaded.messages, Messages());
    return loaded.model().joints.at(0).axes.at(0).xyz;
  };
  EXPECT_EQ(axis(""), Vector3(0, 0, 1));
  EXPECT_LT((axis("<xyz>0 3 4</xyz>") - Vector3(0, 0.6, 0.8)).norm(), 1e-15);
  EXPECT_LT((axis("<xyz expressed_in='__model__'>0 1 0</xyz>") - Vector3(1, 0, 0)).norm(), 1e-15);
  EXPECT_LT((axis("<xyz expressed_in='b'>0 1 0</xyz>") - Vector3(0, 1, 0)).norm(), 1e-15);
  // in older versions
  EXPECT_LT(
      (axis("<xyz>0 1 0</xyz>", "1.6", "<use_parent_model_frame>1</use_parent_model_frame>") - Vector3(1, 0, 0)).norm(),
      1e-15);
  EXPECT_LT((axis("<xyz>0 1 0</xyz>", "1.6") - Vector3(0, 1, 0)).norm(), 1e-15);
  EXPECT_LT((axis("<xyz>0 1 0</xyz>", "1.4") - Vector3(1, 0, 0)).norm(), 1e-15);
}

TEST(Joint, ReadsLimitsAndDynamics) {
  const Loaded loaded = loadJoint(
      "<joint name='j' type='prismatic'>" + kLinks +
      "<axis><limit><lower>-1</lower><upper>2</upper><effort>3</effort><velocity>4</velocity></limit><dynamics>"
      "<damping>5</damping><friction>6</friction><spring_reference>7</spring_reference><spring_stiffness>8"
      "</spring_stiffness></dynamics></axis></joint>");
  EXPECT_EQ(loaded.messages, Messages());
  const description::JointAxis& axis = loaded.model().joints.at(0).axes.at(0);
  EXPECT_EQ(axis.lower, -1);
  EXPECT_EQ(axis.upper, 2);
  EXPECT_EQ(axis.effort, 3);
  EXPECT_EQ(axis.velocity, 4);
  EXPECT_EQ(axis.damping, 5);
  EXPECT_EQ(axis.friction, 6);
  EXPECT_EQ(axis.springReference, 7);
  EXPECT_EQ(axis.springStiffness, 8);
}

TEST(Joint, HasNoLimitWhereTheNumberIsHuge) {
  for (const char* limit : {"<limit><lower>-1e16</lower><upper>1e16</upper><effort>-1</effort></limit>",
                            "<limit><lower>-1.79769e+308</lower><upper>1.79769e+308</upper></limit>",
                            "<limit><lower>-inf</lower><upper>inf</upper></limit>", ""}) {
    const Loaded loaded = loadJoint("<joint name='j' type='revolute'>" + kLinks + "<axis>" + limit + "</axis></joint>");
    EXPECT_EQ(loaded.messages, Messages());
    const description::JointAxis& axis = loaded.model().joints.at(0).axes.at(0);
    EXPECT_EQ(axis.lower, -kInfinity);
    EXPECT_EQ(axis.upper, kInfinity);
    EXPECT_EQ(axis.effort, kInfinity);
    EXPECT_EQ(axis.velocity, kInfinity);
  }
}

TEST(Joint, RefusesLimitsAndSpringsWhereNothingCanBe) {
  const auto messagesOf = [](const std::string& axis) {
    return loadJoint("<joint name='j' type='revolute'>" + kLinks + "<axis>" + axis + "</axis></joint>").messages;
  };
  for (const std::string name : {"lower", "upper"}) {
    const std::string value = name == "lower" ? "1e16" : "-1e10";
    const Messages messages = messagesOf("<limit><" + name + ">" + value + "</" + name + "></limit>");
    ASSERT_FALSE(messages.empty());
    EXPECT_NE(messages[0].find(": error: the " + name + " limit of joint 'j' is out of range"), std::string::npos)
        << messages[0];
  }
  const Messages messages = messagesOf("<dynamics><spring_reference>1e308</spring_reference></dynamics>");
  ASSERT_EQ(messages.size(), 1U);
  EXPECT_NE(messages[0].find(": error: the spring of joint 'j' has a reference out of range"), std::string::npos);
}

TEST(Joint, OfContinuousTypeHasNoLimits) {
  const Loaded loaded = loadJoint("<joint name='j' type='continuous'>" + kLinks +
                                  "<axis><limit><lower>-1</lower><upper>1</upper></limit></axis></joint>");
  EXPECT_EQ(loaded.model().joints.at(0).axes.at(0).upper, kInfinity);
}

TEST(Joint, KnowsAllTypes) {
  const std::pair<const char*, std::size_t> types[] = {{"revolute", 1},  {"continuous", 1}, {"prismatic", 1},
                                                       {"ball", 0},      {"fixed", 0},      {"screw", 1},
                                                       {"universal", 2}, {"revolute2", 2},  {"gearbox", 2}};
  for (const auto& [type, axes] : types) {
    const Loaded loaded = loadJoint("<joint name='j' type='" + std::string(type) + "'>" + kLinks +
                                    "<axis/><axis2><xyz>0 1 0</xyz></axis2><gearbox_reference_body>world"
                                    "</gearbox_reference_body></joint>");
    const description::Joint& joint = loaded.model().joints.at(0);
    EXPECT_EQ(description::name(joint.type), type);
    EXPECT_EQ(joint.axes.size(), axes);
    EXPECT_EQ(loaded.messages, Messages{}) << type;
  }
}

TEST(Joint, ReadsAGearbox) {
  const std::string kGears = "<parent>a</parent><child>b</child><axis/><axis2><xyz>0 1 0</xyz></axis2>";
  const auto load = [&](const std::string& rest) {
    return loadModel("<link name='c'><pose>1 2 3 0 0 0</pose></link><joint name='j' type='gearbox'>" + kGears + rest +
                     "</joint><link name='a'/><link name='b'/>");
  };
  const Loaded loaded = load("<gearbox_ratio>2.5</gearbox_ratio><gearbox_reference_body>c</gearbox_reference_body>");
  EXPECT_EQ(loaded.messages, Messages{});
  const description::Joint& joint = loaded.model().joints.at(0);
  EXPECT_EQ(joint.gearboxRatio, 2.5);
  EXPECT_EQ(joint.gearboxReference, "c");
  EXPECT_EQ(joint.X_ReferenceJoint.position, Vector3(-1, -2, -3));
  const std::pair<const char*, const char*> faults[] = {
      {"", "warning: joint 'j' has no <gearbox_reference_body>: the joint is left out"},
      {"<gearbox_reference_body>d</gearbox_reference_body>", "error: joint 'j' names reference body 'd', which"},
      {"<gearbox_reference_body>a</gearbox_reference_body>",
       "error: joint 'j' has 'a' both as reference body and as parent or child"},
      {"<gearbox_ratio>0</gearbox_ratio><gearbox_reference_body>c</gearbox_reference_body>",
       "error: joint 'j' has a <gearbox_ratio> of 0"}};
  for (const auto& [rest, message] : faults) {
    const Loaded faulty = load(rest);
    ASSERT_EQ(faulty.messages.size(), 1U) << rest;
    EXPECT_NE(faulty.messages.front().find(message), std::string::npos) << faulty.messages.front();
  }
}

TEST(Joint, SaysThatLimitsOfAGearboxHaveNoEffect) {
  const Loaded loaded = loadJoint("<joint name='j' type='gearbox'>" + kLinks +
                                  "<gearbox_reference_body>world</gearbox_reference_body><axis><limit><lower>-1</lower>"
                                  "</limit></axis><axis2><limit><lower>-1e16</lower><upper>1e16</upper></limit></axis2>"
                                  "</joint>");
  EXPECT_EQ(loaded.messages, Messages{"t.sdf:4:1: warning: limits and dynamics of joint 'j' have no effect: it is a "
                                      "gearbox | set them on the joints that the gears turn on"});
}

TEST(Joint, RefusesTwoAxesOfTheSameDirection) {
  EXPECT_EQ(loadJoint("<joint name='j' type='universal'>" + kLinks + "<axis/><axis2/></joint>").messages,
            Messages{"t.sdf:4:1: error: the two axes of joint 'j' have the same direction | <axis> is fixed to the "
                     "parent, <axis2> to the child; they must not be parallel"});
}

TEST(Joint, ReadsTheThreadOfAScrew) {
  const Loaded loaded =
      loadJoint("<joint name='j' type='screw'>" + kLinks + "<axis/><thread_pitch>0.25</thread_pitch></joint>");
  EXPECT_EQ(loaded.model().joints.at(0).threadPitch, 0.25);
}

// as in libsdformat 13 and later
TEST(Joint, ReadsTheThreadOfAScrewInRadiansPerMetreFromSdf110On) {
  const auto pitchOf = [](const std::string& thread) {
    const Loaded loaded = loadJoint("<joint name='j' type='screw'>" + kLinks + "<axis/>" + thread + "</joint>", "1.10");
    EXPECT_EQ(loaded.messages, Messages());
    return loaded.model().joints.at(0).threadPitch;
  };
  EXPECT_DOUBLE_EQ(pitchOf("<thread_pitch>-12.566370614359172</thread_pitch>"), 0.5);
  EXPECT_EQ(pitchOf("<screw_thread_pitch>0.25</screw_thread_pitch>"), 0.25);
  EXPECT_EQ(pitchOf("<thread_pitch>3</thread_pitch><screw_thread_pitch>0.25</screw_thread_pitch>"), 0.25);
  EXPECT_EQ(pitchOf(""), 1);
  EXPECT_EQ(
      loadJoint("<joint name='j' type='screw'>" + kLinks + "<axis/>\n<thread_pitch>0</thread_pitch></joint>", "1.10")
          .messages,
      Messages{"t.sdf:5:1: error: <thread_pitch> is 0 | <screw_thread_pitch> is the distance per turn in metres"});
}

TEST(Joint, NamesTheLineOfAJointWithoutChild) {
  EXPECT_EQ(loadJoint("  <joint name='j' type='fixed'><parent>a</parent></joint>").messages,
            Messages{"t.sdf:4:3: error: joint 'j' has no <child>"});
  EXPECT_EQ(loadJoint("<joint name='j' type='fixed'><parent/><child>b</child></joint>").messages,
            Messages{"t.sdf:4:30: error: joint 'j' has no <parent>"});
}

TEST(Joint, NamesTheLinkThatIsMeant) {
  EXPECT_EQ(
      loadModel("<link name='left_wheel'/><link name='body'/>\n"
                "<joint name='j' type='fixed'><parent>bdy</parent><child>left_whel</child></joint>")
          .messages,
      (Messages{
          "t.sdf:4:30: error: joint 'j' names parent link 'bdy', which is not in model 'm' | did you mean 'body'?",
          "t.sdf:4:50: error: joint 'j' names child link 'left_whel', which is not in model 'm' | did you mean "
          "'left_wheel'?"}));
}

TEST(Joint, NeedsTwoLinks) {
  EXPECT_EQ(loadJoint("<joint name='j' type='fixed'><parent>a</parent><child>a</child></joint>").messages,
            Messages{"t.sdf:4:48: error: joint 'j' has 'a' as parent and child"});
  EXPECT_EQ(
      loadJoint("<joint name='j' type='fixed'><parent>a</parent><child>world</child></joint>").messages,
      Messages{"t.sdf:4:48: error: joint 'j' has the world as its child | the world can only be a joint's parent"});
  const Loaded onItself = loadJoint(
      "<joint name='j' type='fixed'><parent>a</parent><child>f</child></joint>\n<frame name='f' attached_to='a'/>");
  EXPECT_EQ(onItself.messages,
            Messages{"t.sdf:4:48: warning: parent 'a' and child 'f' of joint 'j' are both link 'a': the joint is "
                     "left out"});
  EXPECT_TRUE(onItself.model().joints.empty());
}

TEST(Joint, TakesAFrameForTheLinkThatItIsAttachedTo) {
  const Loaded loaded = loadJoint(
      "<frame name='f' attached_to='b'><pose>0 0 1 0 0 0</pose></frame>"
      "<joint name='j' type='fixed'><parent>a</parent><child>f</child></joint>");
  EXPECT_EQ(loaded.messages, Messages());
  EXPECT_EQ(loaded.model().joints.at(0).child, "b");
  expectPose(loaded.model().joints.at(0).X_ChildJoint, {0, 0, 1});
}

TEST(Joint, RefusesWhatCanNotBe) {
  EXPECT_EQ(loadJoint("<joint name='j' type='revolut'>" + kLinks + "</joint>").messages,
            Messages{"t.sdf:4:17: error: joint 'j' has the unknown type 'revolut' | did you mean 'revolute'?"});
  EXPECT_EQ(loadJoint("<joint name='j'>" + kLinks + "</joint>").messages,
            Messages{"t.sdf:4:1: error: joint 'j' has no type | write type=\"revolute\", for example"});
  EXPECT_EQ(loadJoint("<joint name='j' type='revolute'>" + kLinks + "<axis><xyz>0 0 0</xyz></axis></joint>").messages,
            Messages{"t.sdf:4:73: error: an axis of joint 'j' has length zero"});
  EXPECT_EQ(loadJoint("<joint name='j' type='revolute'>" + kLinks +
                      "<axis><limit><lower>1</lower><upper>0</upper></limit></axis></joint>")
                .messages,
            Messages{"t.sdf:4:73: error: the lower limit of joint 'j' is above its upper limit"});
  EXPECT_EQ(loadJoint("<joint name='j' type='revolute'>" + kLinks +
                      "<axis><xyz expressed_in='nosuch'>0 0 1</xyz></axis></joint>")
                .messages,
            Messages{"t.sdf:4:78: error: an axis of joint 'j' is expressed in 'nosuch', which is not in model 'm'"});
}

TEST(Joint, WarnsWhereTheAxisIsLeftOut) {
  EXPECT_EQ(loadJoint("<joint name='j' type='revolute'>" + kLinks + "</joint>").messages,
            Messages{"t.sdf:4:1: warning: joint 'j' has no <axis>: z is used"});
}

TEST(Joint, ToTheWorldKnowsItsPlaceInTheWorld) {
  const Loaded loaded = loadWorld(
      "<model name='o'><pose>1 0 0 0 0 0</pose><model name='i'><pose>0 2 0 0 0 0</pose><link name='l'>"
      "<pose>0 0 3 0 0 0</pose></link><joint name='j' type='fixed'><parent>world</parent><child>l</child></joint>"
      "</model></model>");
  EXPECT_EQ(loaded.messages, Messages());
  const description::Joint& joint = loaded.model().models.at(0).joints.at(0);
  EXPECT_EQ(joint.parent, "world");
  expectPose(joint.X_ParentJoint, {1, 2, 3});
  expectPose(joint.X_ChildJoint, {0, 0, 0});
}

TEST(Joint, MayMimicAnother) {
  const auto load = [](const std::string& mimic) {
    return loadModel(
        "<link name='a'/><link name='b'/><link name='c'/>"
        "<joint name='j' type='revolute'><parent>a</parent><child>b</child><axis/></joint>"
        "<joint name='k' type='prismatic'><parent>a</parent><child>c</child><axis>" +
        mimic + "</axis></joint>");
  };
  const Loaded loaded =
      load("<mimic joint='j'><multiplier>2</multiplier><offset>3</offset><reference>4</reference></mimic>");
  EXPECT_EQ(loaded.messages, Messages());
  const std::optional<description::Mimic>& mimic = loaded.model().joints.at(1).axes.at(0).mimic;
  ASSERT_TRUE(mimic);
  EXPECT_EQ(mimic->joint, "j");
  EXPECT_EQ(mimic->axis, 0U);
  EXPECT_EQ(mimic->multiplier, 2);
  EXPECT_EQ(mimic->offset, 3);
  EXPECT_EQ(mimic->reference, 4);
  for (const auto& [element, why] :
       {std::pair("<mimic joint='jj'/>", "mimics 'jj', which is not a joint of its model: it moves freely | did you"),
        {"<mimic joint='k'/>", "mimics 'k', which is itself"},
        {"<mimic joint='j' axis='axis2'/>", "mimics 'j', which has no such axis"}}) {
    const Loaded wrong = load(element);
    ASSERT_EQ(wrong.messages.size(), 1U);
    EXPECT_NE(wrong.messages[0].find(why), std::string::npos) << wrong.messages[0];
    EXPECT_FALSE(wrong.model().joints.at(1).axes.at(0).mimic);
  }
}

}  // namespace
}  // namespace pongsim::sdf::test
