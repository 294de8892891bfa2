#include "cli/world/world_info.hh"

#include <gtest/gtest.h>
#include <ignition/msgs/serialized_map.pb.h>

#include <chrono>

#include "msgs/state/state_message.hh"
#include "support/msgs/scene_support.hh"

namespace pongsim::cli {
namespace {

ignition::msgs::SerializedStepMap cartState() {
  const description::World world = test::cartWorld();
  const world::Entities entities(world);
  world::State state(entities);
  state.time = std::chrono::milliseconds(1250);
  state.iterations = 1250;
  ignition::msgs::SerializedStepMap step;
  msgs::setState(entities, state, StateContent::kAll, true, step);
  return step;
}

TEST(WorldInfo, CountsWhatIsInTheWorld) {
  EXPECT_EQ(worldInfo(cartState(), false),
            "World: w\n"
            "  models      3, 1 of them static\n"
            "  links       3\n"
            "  joints      1\n"
            "  sensors     1\n"
            "  lights      2\n"
            "  gravity     0 0 -9.8 m/s^2\n"
            "  step        0.001 s\n"
            "  simulated   1.250 s\n"
            "  iterations  1250\n"
            "  state       paused\n");
}

TEST(WorldInfo, IsJsonToo) {
  EXPECT_EQ(worldInfo(cartState(), true),
            "{\"name\":\"w\",\"models\":3,\"staticModels\":1,\"links\":3,\"joints\":1,\"sensors\":1,\"lights\":2,"
            "\"gravity\":[0.0,0.0,-9.8],\"stepSize\":0.001,\"simulated\":1.25,\"iterations\":1250,\"paused\":true}\n");
}

}  // namespace
}  // namespace pongsim::cli
