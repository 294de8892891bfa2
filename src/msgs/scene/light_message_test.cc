#include "msgs/scene/light_message.hh"

#include <gtest/gtest.h>
#include <ignition/msgs/light.pb.h>

namespace pongsim::msgs {
namespace {

namespace im = ignition::msgs;

description::Light spot() {
  description::Light light;
  light.name = "lamp";
  light.type = description::LightType::kSpot;
  light.X_ParentLight = {{1, 2, 3}, fromRollPitchYaw(0, 0, 1)};
  light.diffuse = {0.5F, 0.25F, 0, 1};
  light.range = 20;
  light.innerAngle = 0.5;
  light.outerAngle = 0.75;
  light.castsShadows = true;
  return light;
}

TEST(LightMessage, MakesTheSameLightAgain) {
  im::Light message;
  setLight(spot(), message);
  EXPECT_EQ(message.type(), im::Light::SPOT);
  EXPECT_EQ(message.pose().position().z(), 3);
  description::Light before;
  before.name = "lamp";
  before.X_ParentLight.rotation = spot().X_ParentLight.rotation;
  // fields that the message lacks are unchanged
  const description::Light again = changedLight(before, message);
  EXPECT_EQ(again.diffuse, spot().diffuse);
  EXPECT_EQ(again.X_ParentLight.position, spot().X_ParentLight.position);
  EXPECT_EQ(again.type, spot().type);
  EXPECT_EQ(again.innerAngle, 0.5);
  EXPECT_TRUE(again.castsShadows);
}

TEST(LightMessage, LeavesPartsThatItDoesNotHave) {
  im::Light message;
  message.set_range(7);
  const description::Light changed = changedLight(spot(), message);
  EXPECT_EQ(changed.diffuse, spot().diffuse);
  EXPECT_EQ(changed.direction, spot().direction);
  EXPECT_EQ(changed.X_ParentLight, spot().X_ParentLight);
  EXPECT_EQ(changed.range, 7);
  EXPECT_EQ(changed.intensity, 0);
  EXPECT_EQ(changed.name, "lamp");
}

TEST(LightMessage, SwitchesALightOffAndOn) {
  description::Light off = spot();
  off.isOn = false;
  im::Light message;
  setLight(off, message);
  EXPECT_FALSE(changedLight(spot(), message).isOn);
  EXPECT_EQ(lightFrom(message), off);
  EXPECT_TRUE(changedLight(off, im::Light()).isOn);
}

TEST(LightMessage, MakesALightAnew) {
  description::Light light = spot();
  light.specular = {0.5F, 0.5F, 0.5F, 1};
  im::Light message;
  setLight(light, message);
  EXPECT_EQ(lightFrom(message), light);
}

TEST(LightMessage, NamesALight) {
  im::Light message;
  message.set_name("sun");
  message.set_parent_id(4);
  EXPECT_EQ(lightName(message).name, "sun");
  EXPECT_EQ(lightName(message).parent, 4U);
  EXPECT_EQ(lightName(message).id, 0U);
}

}  // namespace
}  // namespace pongsim::msgs
