#include "blinking.hh"

#include <gtest/gtest.h>

#include <chrono>
#include <string>
#include <vector>

namespace pongsim::blinking_test {
namespace {

using std::chrono::milliseconds;

Element element(const std::string& name, const std::string& text, std::vector<Element> children = {},
                const std::string& label = "") {
  Element made;
  made.name = name;
  made.text = text;
  made.children = std::move(children);
  if (!label.empty()) made.attributes.push_back({"name", label, {}});
  return made;
}

Element step(const std::string& color, const std::string& time) {
  return element("step", "", {element("color", color), element("on_time", time)});
}

TEST(LedModes, AreReadWithTheirDefaults) {
  Diagnostics diagnostics;
  const Element plugin = element(
      "plugin", "",
      {element("mode", "", {element("active_leds", "", {element("led", "front")}), step("1 0 0", "0.5")}, "Alarm"),
       element("mode", "", {element("step", "")}, "idle")});
  const std::vector<LedMode> modes = ledModesIn(plugin, diagnostics);
  ASSERT_EQ(modes.size(), 2U);
  EXPECT_EQ(modes[0].name, "alarm");
  EXPECT_EQ(modes[0].leds, std::vector<std::string>{"front"});
  EXPECT_EQ(modes[0].steps[0].glow, (Glow{.color = {1, 0, 0, 1}, .intensity = 1}));
  EXPECT_EQ(modes[0].steps[0].duration, milliseconds(500));
  EXPECT_EQ(modes[1].steps[0].glow, Glow());
  EXPECT_EQ(modes[1].steps[0].duration, milliseconds(1000));
  EXPECT_TRUE(diagnostics.all().empty());
}

TEST(LedModes, AreLeftOutWithoutANameOrAStep) {
  Diagnostics diagnostics;
  const Element plugin =
      element("plugin", "", {element("mode", "", {step("1 1 1", "1")}), element("mode", "", {}, "a")});
  EXPECT_TRUE(ledModesIn(plugin, diagnostics).empty());
  ASSERT_EQ(diagnostics.all().size(), 2U);
  EXPECT_EQ(diagnostics.all()[0].message, "a <mode> without a name is left out");
  EXPECT_EQ(diagnostics.all()[1].message, "a <mode> without a <step> is left out");
}

TEST(Glow, RefusesWhatIsNoColour) {
  for (const char* color : {"1 0", "1 0 0 1 1", "1 2 0", "red", "nan 0 0"}) {
    EXPECT_THROW(glowIn(element("step", "", {element("color", color)}), {}), Error) << color;
  }
  EXPECT_THROW(glowIn(element("step", "", {element("intensity", "-1")}), {}), Error);
}

TEST(Blinking, GoesThroughTheStepsOfAModeAgainAndAgain) {
  const auto brightness = [](double value) { return Glow{.color = {1, 1, 1, 1}, .intensity = value}; };
  const std::vector<LedMode> modes{{.name = "blink",
                                    .leds = {},
                                    .steps = {{.glow = brightness(1), .duration = milliseconds(10), .lasts = false},
                                              {.glow = brightness(2), .duration = milliseconds(20), .lasts = false}}},
                                   {.name = "on",
                                    .leds = {},
                                    .steps = {{.glow = brightness(3), .duration = milliseconds(1), .lasts = true},
                                              {.glow = brightness(4), .duration = milliseconds(1), .lasts = false}}}};
  Blinking blinking;
  blinking.begin(0);
  int first = 0;
  constexpr int kSteps = 3200;
  for (int i = 1; i <= kSteps; ++i) first += blinking.step(modes, milliseconds(i)).glow.intensity == 1 ? 1 : 0;
  // a step ends once more than its time is over: 11 ms and 21 ms
  EXPECT_EQ(first, kSteps * 11 / 32);
  blinking.begin(1);
  for (int i = 1; i < 100; ++i) EXPECT_EQ(blinking.step(modes, milliseconds(kSteps + i)).glow.intensity, 3);
  EXPECT_FALSE(blinking.isOff());
  blinking.switchOff();
  EXPECT_TRUE(blinking.isOff());
}

}  // namespace
}  // namespace pongsim::blinking_test
