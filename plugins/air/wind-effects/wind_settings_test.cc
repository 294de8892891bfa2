#include "wind_settings.hh"

#include <gtest/gtest.h>

#include <string>
#include <utility>
#include <vector>

namespace pongsim::wind_settings_test {
namespace {

Element element(const std::string& name, const std::string& text, std::vector<Element> children = {}) {
  Element result;
  result.name = name;
  result.text = text;
  result.children = std::move(children);
  return result;
}

Element rise(const std::string& text) { return element("time_for_rise", text); }

Element plugin(std::vector<Element> magnitude, std::vector<Element> direction, std::vector<Element> vertical) {
  return element(
      "plugin", "",
      {element("horizontal", "",
               {element("magnitude", "", std::move(magnitude)), element("direction", "", std::move(direction))}),
       element("vertical", "", std::move(vertical))});
}

std::string refusalOf(const Element& element) {
  Diagnostics diagnostics;
  try {
    readWindSettings(element, diagnostics);
  } catch (const Error& error) {
    return error.diagnostic().message;
  }
  return {};
}

TEST(WindSettings, AreThoseOfFortressByDefault) {
  Diagnostics diagnostics;
  const WindSettings settings = readWindSettings(element("plugin", ""), diagnostics);
  EXPECT_EQ(settings, WindSettings());
  EXPECT_EQ(settings.magnitude.riseTime, 1);
  EXPECT_EQ(settings.direction.waveAmplitude, 0);
  EXPECT_EQ(settings.direction.wavePeriod, 1);
  EXPECT_TRUE(diagnostics.all().empty());
}

TEST(WindSettings, AreRead) {
  Element noise = element("noise", "", {element("mean", "1"), element("stddev", "2")});
  noise.attributes.push_back({"type", "gaussian", {}});
  Diagnostics diagnostics;
  const WindSettings settings = readWindSettings(
      plugin({rise("3"), element("sin", "", {element("amplitude_percent", "0.4"), element("period", "5")})},
             {rise("6"), element("sin", "", {element("amplitude", "7"), element("period", "8")})}, {rise("9"), noise}),
      diagnostics);
  WindSettings expected;
  expected.magnitude = {3, 0.4, 5, {}};
  expected.direction = {6, 7, 8, {}};
  expected.vertical.riseTime = 9;
  expected.vertical.noise = {.type = NoiseSettings::Type::kGaussian, .mean = 1, .standardDeviation = 2};
  EXPECT_EQ(settings, expected);
  EXPECT_TRUE(diagnostics.all().empty());
}

TEST(WindSettings, MustMakeSense) {
  const std::string tooShort = "<time_for_rise> must be at least 1e-06";
  EXPECT_EQ(refusalOf(plugin({rise("0")}, {}, {})), tooShort);
  EXPECT_EQ(refusalOf(plugin({}, {rise("-1")}, {})), tooShort);
  EXPECT_EQ(refusalOf(plugin({}, {}, {rise("1e-9")})), tooShort);
  EXPECT_EQ(refusalOf(plugin({element("sin", "", {element("period", "0")})}, {}, {})), "<period> must be above zero");
  EXPECT_EQ(refusalOf(plugin({}, {element("sin", "", {element("amplitude", "inf")})}, {})),
            "<amplitude> must be a finite number");
  EXPECT_EQ(refusalOf(plugin({}, {}, {rise("soon")})), "<time_for_rise> is 'soon', which is not a number");
}

TEST(WindSettings, WarnOfWhatIsNotKnown) {
  Diagnostics diagnostics;
  readWindSettings(
      plugin({element("sin", "", {element("amplitude", "7")})}, {element("time_to_rise", "2")}, {element("sin", "")}),
      diagnostics);
  ASSERT_EQ(diagnostics.all().size(), 3U);
  EXPECT_EQ(diagnostics.all()[0].message, "<amplitude> is unknown in <sin>");
  EXPECT_EQ(diagnostics.all()[0].hint, "it can contain <amplitude_percent>, <period>");
  EXPECT_EQ(diagnostics.all()[1].message, "<time_to_rise> is unknown in <direction>");
  EXPECT_EQ(diagnostics.all()[2].message, "<sin> is unknown in <vertical>");
}

}  // namespace
}  // namespace pongsim::wind_settings_test
