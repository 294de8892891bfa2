#include "fault.hh"

#include <gtest/gtest.h>

#include <string>
#include <utility>
#include <vector>

#include "pongsim/diagnostic.hh"

namespace pongsim::faults {
namespace {

using Attributes = std::vector<std::pair<std::string, std::string>>;

Element elementWith(const Attributes& attributes) {
  Element element;
  element.name = "fault";
  element.position = {nullptr, 7, 5};
  int column = 12;
  for (const auto& [name, value] : attributes) element.attributes.push_back({name, value, {nullptr, 7, column += 20}});
  return element;
}

Fault faultWith(const Attributes& attributes) { return faultOf(elementWith(attributes)); }

/// @return Column, message and hint of the error.
std::string errorOf(const Attributes& attributes) {
  try {
    faultWith(attributes);
  } catch (const Error& error) {
    const Diagnostic& found = error.diagnostic();
    return std::to_string(found.position.column) + ": " + found.message + (found.hint.empty() ? "" : "; " + found.hint);
  }
  return "";
}

TEST(Fault, ReadsWhatItIsGiven) {
  const Fault fault =
      faultWith({{"type", "drop"}, {"topic", "lidar"}, {"from", "2"}, {"to", "5.5"}, {"probability", "0.3"}});
  EXPECT_EQ(fault.kind, Kind::kDrop);
  EXPECT_EQ(fault.target, "/lidar");
  EXPECT_EQ(fault.from, std::chrono::seconds(2));
  EXPECT_EQ(fault.to, std::chrono::milliseconds(5500));
  EXPECT_EQ(fault.probability, 0.3);
  EXPECT_EQ(faultWith({{"type", "delay"}, {"topic", "/a"}, {"delay", "0.05"}}).delay, std::chrono::milliseconds(50));
  EXPECT_EQ(faultWith({{"type", "weaken"}, {"joint", "m::j"}, {"factor", "0.5"}}).factor, 0.5);
}

TEST(Fault, IsThereFromATimeToAnother) {
  const auto isActive = [](const Attributes& attributes, double seconds) {
    return faultWith(attributes).isActive(fromSeconds(seconds));
  };
  const Attributes always = {{"type", "freeze"}, {"topic", "/a"}};
  EXPECT_TRUE(isActive(always, 0));
  EXPECT_TRUE(isActive(always, 1e6));
  Attributes once = always;
  once.insert(once.end(), {{"from", "1"}, {"to", "2"}});
  EXPECT_FALSE(isActive(once, 0.999));
  EXPECT_TRUE(isActive(once, 1));
  EXPECT_TRUE(isActive(once, 1.999));
  EXPECT_FALSE(isActive(once, 2));
  Attributes often = once;
  often.emplace_back("every", "5");
  EXPECT_TRUE(isActive(often, 1.5));
  EXPECT_FALSE(isActive(often, 2));
  EXPECT_TRUE(isActive(often, 6));
  EXPECT_FALSE(isActive(often, 7));
}

TEST(Fault, SaysWhatIsWrongAndWhere) {
  EXPECT_EQ(errorOf({}),
            "5: <fault> has no type; types are drop, duplicate, delay, noise, freeze, sensor, stick, slip, weaken");
  EXPECT_EQ(errorOf({{"type", "freez"}}), "32: there is no fault 'freez'; did you mean 'freeze'?");
  EXPECT_EQ(errorOf({{"type", "drop"}}), "5: a fault of type 'drop' needs 'topic'");
  EXPECT_EQ(errorOf({{"type", "drop"}, {"topic", "/a b"}}), "52: '/a b' is no name of a topic: it has a space");
  EXPECT_EQ(errorOf({{"type", "drop"}, {"topic", "/a"}, {"probabilty", "1"}}),
            "72: a fault of type 'drop' has no 'probabilty'; did you mean 'probability'?");
  EXPECT_EQ(errorOf({{"type", "stick"}, {"topic", "/a"}}),
            "52: a fault of type 'stick' has no 'topic'; there are type, from, to, every, joint");
  EXPECT_EQ(errorOf({{"type", "drop"}, {"topic", "/a"}, {"probability", "1.5"}}),
            "72: 'probability' of a fault must be a number from 0 to 1, not '1.5'");
  EXPECT_EQ(errorOf({{"type", "delay"}, {"topic", "/a"}}), "5: a fault of type 'delay' needs 'delay'");
  EXPECT_EQ(errorOf({{"type", "noise"}, {"topic", "/a"}}), "5: a fault of type 'noise' needs 'stddev'");
  EXPECT_EQ(errorOf({{"type", "weaken"}, {"joint", "j"}}),
            "5: a fault of type 'weaken' needs either 'effort' or 'factor'");
  EXPECT_EQ(errorOf({{"type", "drop"}, {"topic", "/a"}, {"from", "2"}, {"to", "1"}}),
            "92: the fault ends before it begins");
  EXPECT_NE(errorOf({{"type", "drop"}, {"topic", "/a"}, {"to", "2"}, {"every", "2"}}), "");
  for (const char* bad : {"nan", "-1", "1e10", "soon", ""}) {
    EXPECT_NE(errorOf({{"type", "drop"}, {"topic", "/a"}, {"from", bad}}), "") << bad;
  }
}

}  // namespace
}  // namespace pongsim::faults
