#include "msgs/scene/surroundings_message.hh"

#include <gtest/gtest.h>
#include <ignition/msgs/scene.pb.h>

namespace pongsim::msgs {
namespace {

TEST(SurroundingsMessage, MakesTheSameAgain) {
  description::Scene surroundings;
  surroundings.ambient = {0.5F, 0.25F, 0, 1};
  surroundings.hasShadows = false;
  ignition::msgs::Scene message;
  setSurroundings(surroundings, message);
  EXPECT_EQ(message.ambient().r(), 0.5F);
  EXPECT_EQ(surroundingsFrom(message), surroundings);
  surroundings.sky = {1, 2, 3, 4, 5, 6, 7, {0.5F, 0, 0, 1}};
  setSurroundings(surroundings, message);
  EXPECT_EQ(message.sky().sunset(), 3);
  EXPECT_EQ(surroundingsFrom(message), surroundings);
}

}  // namespace
}  // namespace pongsim::msgs
