#include <gtest/gtest.h>
#include <ignition/msgs/image.pb.h>
#include <ignition/msgs/light.pb.h>

#include <cstddef>
#include <string>
#include <utility>
#include <vector>

#include "support/camera_world.hh"
#include "support/going_on.hh"
#include "support/running_world.hh"

namespace pongsim::led_plugin_test {
namespace {

using test::RunningWorld;

constexpr const char* kTopic = "/model/lamp/signals/change_led_mode";

std::string lamp(const std::string& parameters) {
  return "<model name='lamp'><static>true</static><link name='post'>"
         "<light name='red' type='point'><attenuation><range>7</range></attenuation></light>"
         "<light name='green' type='point'/></link>"
         "<plugin filename='gz-sim-led-plugin-system' name='gz::sim::systems::LedPlugin'>" +
         parameters + "</plugin></model>";
}

std::string led(const std::string& name, const std::string& content) {
  return "<led name='" + name + "'>" + content + "</led>";
}

const std::string kLeds = led("r",
                              "<light_name>lamp::post::red</light_name><default_state><color>0.3 0 0 1</color>"
                              "<intensity>0.1</intensity></default_state>") +
                          led("g", "<light_name>post::green</light_name>");
const std::string kModes =
    "<mode name='go'><active_leds><led>g</led></active_leds><step always_on='true'><color>0 1 0 1</color>"
    "<intensity>2</intensity></step></mode><mode name='Alarm'><step><color>1 0 0 1</color><on_time>0.01</on_time>"
    "</step><step><color>0 0 0 1</color><on_time>0.01</on_time><intensity>0</intensity></step></mode>";

std::string signals() { return lamp("<led_group_name>signals</led_group_name>" + kLeds + kModes); }

TEST(LedPlugin, ShowsItsFirstModeAndChangesItOnCommand) {
  RunningWorld world(signals());
  std::vector<ignition::msgs::Light> lights;
  world.listen("/world/w/light_config", lights);
  world.step(100);
  ASSERT_EQ(lights.size(), 2U);
  // the red one is not in this mode
  EXPECT_FLOAT_EQ(lights[0].diffuse().r(), 0.3F);
  EXPECT_FLOAT_EQ(lights[0].intensity(), 0.1F);
  EXPECT_EQ(lights[0].range(), 7);
  EXPECT_NE(lights[0].id(), 0U);
  EXPECT_EQ(lights[1].diffuse().g(), 1);
  EXPECT_EQ(lights[1].intensity(), 2);

  lights.clear();
  world.tellText(kTopic, "ignition.msgs.StringMsg", "data: 'ALARM'");
  world.step(220);
  // both change every 11 ms
  EXPECT_EQ(lights.size(), 40U);
  EXPECT_EQ(lights[0].diffuse().r(), 1);
  EXPECT_EQ(lights[2].intensity(), 0);

  lights.clear();
  world.tellText(kTopic, "ignition.msgs.StringMsg", "data: 'off'");
  world.step(100);
  ASSERT_EQ(lights.size(), 2U);
  EXPECT_FLOAT_EQ(lights[0].intensity(), 0.1F);
  EXPECT_EQ(lights[1].intensity(), 0);
}

class LedPluginSeen : public test::DrawingTest {};

// in the dark, it is seen only because it glows
TEST_F(LedPluginSeen, ChangesTheColorOfAVisual) {
  const std::string plugin =
      "<plugin filename='gz-sim-led-plugin-system' name='gz::sim::systems::LedPlugin'>"
      "<led_group_name>signals</led_group_name>" +
      led("v", "<visual_name>thing::l::v</visual_name><default_state><color>0 0 1 1</color></default_state>") +
      "<mode name='go'><step always_on='true'><color>0 1 0 1</color></step></mode></plugin>";
  RunningWorld world("<scene><ambient>0 0 0 1</ambient></scene>" + std::string(test::kSensorsSystem) +
                     test::smallCamera("camera") + test::thingAt("thing", "3 0 0", test::boxOf(1, 4, 4), "", plugin));
  std::vector<ignition::msgs::Image> images;
  world.listen("/cam", images);
  const auto middle = [&] {
    images.clear();
    world.step(100);
    const std::string& pixels = images.back().data();
    const std::size_t place = (24 * 64 + 32) * 3;
    return std::vector<int>{static_cast<unsigned char>(pixels[place]), static_cast<unsigned char>(pixels[place + 1]),
                            static_cast<unsigned char>(pixels[place + 2])};
  };
  const std::vector<int> green = middle();
  // highlights are white
  EXPECT_LT(green[0], 40);
  EXPECT_GT(green[1], 200);
  const std::vector<std::byte> state = world.simulation().saveState();
  world.tellText("/model/thing/signals/change_led_mode", "ignition.msgs.StringMsg", "data: 'off'");
  EXPECT_GT(middle()[2], 200);
  ASSERT_TRUE(world.simulation().restoreState(state));
  EXPECT_EQ(middle(), green);
  Diagnostics none;
  world.simulation().reset(none);
  EXPECT_EQ(middle(), green);
}

TEST(LedPlugin, GoesOnAfterAModeThatIsNotThere) {
  RunningWorld world(signals());
  testing::internal::CaptureStderr();
  world.tellText(kTopic, "ignition.msgs.StringMsg", "data: 'stop'");
  world.step(10);
  EXPECT_NE(testing::internal::GetCapturedStderr().find("there is no mode 'stop' of LEDs"), std::string::npos);
}

TEST(LedPlugin, GoesOnWithTheSameChangesFromASavedState) {
  RunningWorld world(signals());
  world.tellText(kTopic, "ignition.msgs.StringMsg", "data: 'alarm'");
  world.step(55);
  RunningWorld other(signals());
  test::expectSameBitsFromSavedState<ignition::msgs::Light>(world, other, 100, "/world/w/light_config");
}

TEST(LedPlugin, SaysWhatIsWrong) {
  const std::string left = "led-plugin of lamp is left out: ";
  const std::string group = "<led_group_name>signals</led_group_name>";
  for (const auto& [parameters, message] : std::vector<std::pair<std::string, std::string>>{
           {kModes, left + "no <led> is given"},
           {kLeds, left + "no <mode> is given"},
           {led("b", "<light_name>lamp::blue</light_name>") + kLeds + kModes,
            "<light_name> 'lamp::blue' is not a light in the world"},
           {led("b", "<visual_name>lamp::post::v</visual_name>") + kLeds + kModes,
            "<visual_name> 'lamp::post::v' is not a visual in the world"},
           {kLeds + kModes + "<startup_mode>stop</startup_mode>", "<startup_mode> 'stop' is not a mode: 'go' is used"},
           {led("r", "<light_name>lamp::post::red</light_name>") + kModes, "mode 'go' names 'g', which is no <led>"}}) {
    EXPECT_EQ(RunningWorld::complaintsAbout(lamp(group + parameters)), std::vector{message});
  }
}

}  // namespace
}  // namespace pongsim::led_plugin_test
