#include "load_support.hh"

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

TEST(Physics, RefusesStepsThatAreNone) {
  const auto messages = [](const std::string& content) {
    return loadWorld("<physics>" + content + "</physics>").messages;
  };
  EXPECT_EQ(messages("<max_step_size>0</max_step_size>"),
            Messages{"t.sdf:2:10: error: <max_step_size> is '0', which is not a finite number above zero"});
  EXPECT_EQ(messages("<max_step_size>1e-12</max_step_size>"),
            Messages{"t.sdf:2:10: error: a step of 1e-12 s is not between a nanosecond and a million seconds"});
  EXPECT_EQ(messages("<max_step_size>1e300</max_step_size>"),
            Messages{"t.sdf:2:10: error: a step of 1e300 s is not between a nanosecond and a million seconds"});
  EXPECT_EQ(messages("<real_time_factor>-1</real_time_factor>"),
            Messages{"t.sdf:2:10: error: <real_time_factor> is '-1', which is not a finite number from zero up"});
}

TEST(Physics, ReadsGravity) { EXPECT_EQ(loadWorld("<gravity>1 2 3</gravity>").world().gravity, Vector3(1, 2, 3)); }

}  // namespace
}  // namespace pongsim::sdf::test
