#include "match.hh"

#include <gtest/gtest.h>

#include <optional>

namespace pongsim::match_test {
namespace {

Element matchElement(std::string text, std::vector<Element::Attribute> attributes = {}) {
  Element element;
  element.name = "match";
  element.text = std::move(text);
  element.attributes = std::move(attributes);
  element.position = {std::make_shared<const std::string>("world.sdf"), 5, 9};
  return element;
}

bool matches(const Element& element, const std::string& type, const std::string& text) {
  const MessagePointer message = newMessage(type);
  const std::optional<MessageError> error = parseMessage(text, *message);
  EXPECT_FALSE(error.has_value()) << text;
  return Match(element, type).matches(*message);
}

std::string errorOf(const Element& element, const std::string& type) {
  try {
    const Match match(element, type);
  } catch (const Error& error) {
    return format(error.diagnostic());
  }
  return "no error";
}

TEST(Match, ComparesTheWholeMessageWithoutAField) {
  const Element element = matchElement("linear: {x: 1}, angular: {z: 2}");
  EXPECT_TRUE(matches(element, "ignition.msgs.Twist", "linear {x: 1} angular {z: 2}"));
  EXPECT_FALSE(matches(element, "ignition.msgs.Twist", "linear {x: 1}"));
  EXPECT_FALSE(matches(element, "ignition.msgs.Twist", "linear {x: 1 y: 1} angular {z: 2}"));
}

TEST(Match, TakesUnsetFieldsAsDefaults) {
  EXPECT_TRUE(matches(matchElement("linear: {x: 0}"), "ignition.msgs.Twist", ""));
  EXPECT_TRUE(matches(matchElement("0", {{"field", "data", {}}}), "ignition.msgs.Int32", ""));
  EXPECT_TRUE(matches(matchElement("false", {{"field", "data", {}}}), "ignition.msgs.Boolean", ""));
  EXPECT_FALSE(matches(matchElement("false", {{"field", "data", {}}}), "ignition.msgs.Boolean", "data: true"));
}

TEST(Match, ComparesOneFieldByItsPath) {
  const Element element = matchElement("1.5", {{"field", "pose.position.x", {}}});
  EXPECT_TRUE(matches(element, "ignition.msgs.Odometry", "pose {position {x: 1.5 y: 7}} twist {linear {x: 3}}"));
  EXPECT_FALSE(matches(element, "ignition.msgs.Odometry", "pose {position {x: 1.6}}"));
  EXPECT_FALSE(matches(element, "ignition.msgs.Odometry", ""));
}

TEST(Match, ComparesAFieldThatIsAMessage) {
  const Element element = matchElement("x: 1, y: 2", {{"field", "position", {}}});
  EXPECT_TRUE(matches(element, "ignition.msgs.Pose", "position {x: 1 y: 2} name: 'a'"));
  EXPECT_FALSE(matches(element, "ignition.msgs.Pose", "position {x: 1 y: 2 z: 3}"));
  EXPECT_TRUE(matches(matchElement("{ x: 1 }", {{"field", "position", {}}}), "ignition.msgs.Pose", "position {x: 1}"));
}

TEST(Match, ComparesTextWithAndWithoutQuotes) {
  EXPECT_TRUE(matches(matchElement("go", {{"field", "data", {}}}), "ignition.msgs.StringMsg", "data: 'go'"));
  EXPECT_TRUE(matches(matchElement("\"go\"", {{"field", "data", {}}}), "ignition.msgs.StringMsg", "data: 'go'"));
  EXPECT_FALSE(matches(matchElement("go", {{"field", "data", {}}}), "ignition.msgs.StringMsg", "data: 'gone'"));
}

TEST(Match, TakesNumbersAsEqualWithinTheTolerance) {
  const Element element = matchElement("2", {{"field", "data", {}}, {"tol", "0.1", {}}});
  EXPECT_TRUE(matches(element, "ignition.msgs.Double", "data: 2.09"));
  EXPECT_TRUE(matches(element, "ignition.msgs.Double", "data: 1.91"));
  EXPECT_FALSE(matches(element, "ignition.msgs.Double", "data: 2.11"));
  EXPECT_FALSE(matches(matchElement("2", {{"field", "data", {}}}), "ignition.msgs.Double", "data: 2.0001"));
}

TEST(Match, CanBeNegative) {
  const Element element = matchElement("2", {{"field", "data", {}}, {"logic_type", "negative", {}}});
  EXPECT_FALSE(matches(element, "ignition.msgs.Double", "data: 2"));
  EXPECT_TRUE(matches(element, "ignition.msgs.Double", "data: 3"));
}

TEST(Match, LooksForValuesInARepeatedField) {
  const Element element = matchElement("7", {{"field", "data", {}}});
  EXPECT_TRUE(matches(element, "ignition.msgs.Int32_V", "data: [1, 7, 3]"));
  EXPECT_FALSE(matches(element, "ignition.msgs.Int32_V", "data: [1, 3]"));
  EXPECT_FALSE(matches(element, "ignition.msgs.Int32_V", ""));
  const Element key = matchElement("{ key: 'a' value: 'b' }", {{"field", "header.data", {}}});
  EXPECT_TRUE(matches(key, "ignition.msgs.Pose", "header {data {key: 'c'} data {key: 'a' value: 'b'}}"));
  EXPECT_FALSE(matches(key, "ignition.msgs.Pose", "header {data {key: 'a' value: 'c'}}"));
}

TEST(Match, NamesWhatIsWrongAndWhere) {
  EXPECT_EQ(errorOf(matchElement("1", {{"field", "dat", {}}}), "ignition.msgs.Int32"),
            "world.sdf:5:9: error: field 'dat' is not in ignition.msgs.Int32\n  hint: its fields are header, data");
  EXPECT_EQ(errorOf(matchElement("1", {{"field", "data.x", {}}}), "ignition.msgs.Int32"),
            "world.sdf:5:9: error: 'ignition.msgs.Int32.data' has no field 'x': it is not a message");
  EXPECT_EQ(errorOf(matchElement("1", {{"field", "pose.name", {}}}), "ignition.msgs.Pose_V"),
            "world.sdf:5:9: error: field 'pose' of a <match> is repeated: only the last field of a path may be");
  EXPECT_EQ(errorOf(matchElement("1", {{"tol", "-1", {}}}), "ignition.msgs.Int32"),
            "world.sdf:5:9: error: the 'tol' of a <match> must be zero or more, not '-1'");
  EXPECT_EQ(errorOf(matchElement("1", {{"logic_type", "maybe", {}}}), "ignition.msgs.Int32"),
            "world.sdf:5:9: error: the 'logic_type' of a <match> is 'maybe'\n"
            "  hint: it can be 'positive' or 'negative'");
  const std::string notANumber = errorOf(matchElement("seven", {{"field", "data", {}}}), "ignition.msgs.Int32");
  EXPECT_EQ(
      notANumber.find("world.sdf:5:9: error: the text of this <match> is not a value of 'ignition.msgs.Int32.data'"),
      0U)
      << notANumber;
}

}  // namespace
}  // namespace pongsim::match_test
