#include "support/sdf/load_support.hh"

namespace pongsim::sdf::test {
namespace {

TEST(Physics, HasTheDefaultsOfTheFormat) {
  const Loaded loaded = loadWorld("");
  EXPECT_EQ(loaded.world().physics.maxStepSize, std::chrono::milliseconds(1));
  EXPECT_EQ(loaded.world().physics.realTimeFactor, 1);
  EXPECT_EQ(loaded.world().gravity, Vector3(0, 0, -9.8));
}

TEST(Physics, IsTheFirstProfileOrTheOneMarked) {
  const std::string first =
      "<physics name='a' type='x'><max_step_size>0.004</max_step_size><real_time_factor>0</real_time_factor></physics>";
  const Loaded loaded = loadWorld(first + "<physics name='b' type='x'/>");
  EXPECT_EQ(loaded.messages, Messages());
  EXPECT_EQ(loaded.world().physics.name, "a");
  EXPECT_EQ(loaded.world().physics.maxStepSize, std::chrono::milliseconds(4));
  EXPECT_EQ(loaded.world().physics.realTimeFactor, 0);
  EXPECT_EQ(loadWorld(first + "<physics name='b' default='1' type='x'/><physics name='c' default='true' type='x'/>")
                .world()
                .physics.name,
            "b");
}

TEST(Physics, KeepsAllProfilesWithWhatTheySayOfEngines) {
  const Loaded loaded = loadWorld(
      "<physics name='a' type='ode' default='true'><max_contacts>5</max_contacts>"
      "<real_time_update_rate>250</real_time_update_rate>"
      "<ode><solver><type>world</type><iters>70</iters><sor>1.1</sor></solver><constraints><cfm>0.1</cfm><erp>0.3</erp>"
      "<contact_max_correcting_vel>7</contact_max_correcting_vel></constraints></ode></physics>"
      "<physics name='b' type='bullet'><bullet><solver><iters>20</iters></solver><constraints>"
      "<split_impulse>false</split_impulse></constraints></bullet><simbody><contact><stiffness>9</stiffness></contact>"
      "</simbody><dart><solver><solver_type>pgs</solver_type></solver><collision_detector>ode</collision_detector></"
      "dart>"
      "</physics>");
  EXPECT_EQ(loaded.messages, Messages());
  const auto& profiles = loaded.world().physicsProfiles;
  ASSERT_EQ(profiles.size(), 2U);
  EXPECT_EQ(loaded.world().physics, profiles[0]);
  EXPECT_TRUE(profiles[0].isDefault);
  EXPECT_EQ(profiles[0].maxContacts, 5);
  EXPECT_EQ(profiles[0].realTimeUpdateRate, 250);
  EXPECT_EQ(profiles[0].ode.solver, "world");
  EXPECT_EQ(profiles[0].ode.iterations, 70);
  EXPECT_EQ(profiles[0].ode.sor, 1.1);
  EXPECT_EQ(profiles[0].ode.cfm, 0.1);
  EXPECT_EQ(profiles[0].ode.erp, 0.3);
  EXPECT_EQ(profiles[0].ode.contactMaxCorrectingVelocity, 7);
  EXPECT_EQ(profiles[0].ode.contactSurfaceLayer, 0.001);
  EXPECT_EQ(profiles[1].type, "bullet");
  EXPECT_EQ(profiles[1].bullet.iterations, 20);
  EXPECT_FALSE(profiles[1].bullet.splitsImpulse);
  EXPECT_EQ(profiles[1].simbody.stiffness, 9);
  EXPECT_EQ(profiles[1].dart.solver, "pgs");
  EXPECT_EQ(profiles[1].dart.collisionDetector, "ode");
}

TEST(Physics, RefusesAGravityThatIsNone) {
  const Loaded loaded = loadWorld("<gravity>0 0 -1e308</gravity>");
  EXPECT_EQ(loaded.messages, Messages{"t.sdf:2:1: error: <gravity> is '0 0 -1e308': the limit is 1e6 m/s^2 | "
                                      "on earth it is 0 0 -9.8"});
  EXPECT_EQ(loadWorld("<gravity>0 0 -1e6</gravity>").messages, Messages());
}

TEST(Physics, RefusesStepsThatAreNone) {
  const auto messages = [](const std::string& content) {
    return loadWorld("<physics>" + content + "</physics>").messages;
  };
  EXPECT_EQ(messages("<max_step_size>0</max_step_size>"),
            Messages{"t.sdf:2:10: error: <max_step_size> is '0', which is not a finite number above zero"});
  EXPECT_EQ(messages("<max_step_size>1e-12</max_step_size>"),
            Messages{"t.sdf:2:10: error: a step of 1e-12 s is out of range: 1e-9 to 1e6 s"});
  EXPECT_EQ(messages("<max_step_size>1e300</max_step_size>"),
            Messages{"t.sdf:2:10: error: a step of 1e300 s is out of range: 1e-9 to 1e6 s"});
  EXPECT_EQ(messages("<real_time_factor>fast</real_time_factor>"),
            Messages{"t.sdf:2:10: error: <real_time_factor> is 'fast', which is not a number"});
}

TEST(Physics, TakesAFactorThatIsNoPaceForAsFastAsPossible) {
  for (const char* factor : {"-1.0", "-1e30", "inf"}) {
    const Loaded loaded =
        loadWorld("<physics><real_time_factor>" + std::string(factor) + "</real_time_factor></physics>");
    EXPECT_EQ(loaded.messages, Messages()) << factor;
    EXPECT_EQ(loaded.world().physics.realTimeFactor, 0) << factor;
  }
}

TEST(Physics, ReadsGravity) { EXPECT_EQ(loadWorld("<gravity>1 2 3</gravity>").world().gravity, Vector3(1, 2, 3)); }

}  // namespace
}  // namespace pongsim::sdf::test
