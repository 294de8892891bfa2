#include "sdf/schema/value_check.hh"

#include <algorithm>
#include <vector>

#include "support/sdf/format_walk.hh"
#include "support/sdf/load_support.hh"

namespace pongsim::sdf::test {
namespace {

/// @return "good", "warning" or "error".
std::string verdict(std::string_view type, std::string_view text) {
  const std::optional<WrongValue> wrong = checkValue(type, text);
  if (!wrong) return "good";
  return wrong->severity == Severity::kWarning ? "warning" : "error";
}

TEST(ValueCheck, TakesWhatIsOfItsType) {
  EXPECT_EQ(verdict("double", "-1.5e3"), "good");
  EXPECT_EQ(verdict("double", "inf"), "good");
  EXPECT_EQ(verdict("float", "+1"), "good");
  EXPECT_EQ(verdict("int", "-3"), "good");
  EXPECT_EQ(verdict("unsigned int", "4294967295"), "good");
  EXPECT_EQ(verdict("unsigned int", "0x1F"), "good");
  EXPECT_EQ(verdict("bool", "True"), "good");
  EXPECT_EQ(verdict("vector2d", "1 2"), "good");
  EXPECT_EQ(verdict("vector3", "1 2\n3"), "good");
  EXPECT_EQ(verdict("color", "1 1 1"), "good");
  EXPECT_EQ(verdict("color", "1 1 1 1"), "good");
  EXPECT_EQ(verdict("time", "1 500"), "good");
  EXPECT_EQ(verdict("pose", "1 2 3 4 5 6"), "good");
  EXPECT_EQ(verdict("pose", "1 2 3 0 0 0 1"), "good");
  EXPECT_EQ(verdict("string", "any"), "good");
  EXPECT_EQ(verdict("double", ""), "good");
}

// libsdformat 12.3 does the same with each of these: it refuses the errors, and reads the warnings in part.
TEST(ValueCheck, TellsWhatFortressRefusesFromWhatItTakesInPart) {
  EXPECT_EQ(verdict("double", "x"), "error");
  EXPECT_EQ(verdict("double", "1abc"), "warning");
  EXPECT_EQ(verdict("double", "1 2"), "warning");
  EXPECT_EQ(verdict("int", "3.5"), "warning");
  EXPECT_EQ(verdict("int", "a"), "error");
  EXPECT_EQ(verdict("unsigned int", "-3"), "warning");
  EXPECT_EQ(verdict("unsigned int", "0x1G"), "warning");
  EXPECT_EQ(verdict("bool", "yes"), "error");
  EXPECT_EQ(verdict("bool", "1.0"), "error");
  EXPECT_EQ(verdict("vector3", "1 2"), "error");
  EXPECT_EQ(verdict("vector3", "1 2 3 4"), "warning");
  EXPECT_EQ(verdict("color", "1 1"), "error");
  EXPECT_EQ(verdict("color", "a b c d"), "error");
  EXPECT_EQ(verdict("pose", "1 2"), "error");
}

TEST(ValueCheck, ReadsTheNumbersThatATextBeginsWith) {
  EXPECT_EQ(leadingNumber("5m"), 5);
  EXPECT_EQ(leadingNumber(" +1.5e2 3"), 150);
  EXPECT_EQ(leadingNumber("m5"), std::nullopt);
  EXPECT_EQ(leadingNumber(""), std::nullopt);
  EXPECT_EQ(leadingInteger("640.0"), 640);
  EXPECT_EQ(leadingInteger("-3"), -3);
  EXPECT_EQ(leadingInteger("0x1fz"), 31);
  EXPECT_EQ(leadingInteger("x"), std::nullopt);
  EXPECT_EQ(leadingInteger("99999999999999999999"), std::nullopt);
  EXPECT_EQ(leadingNumbers("1 2x 3", 4), (std::vector<double>{1, 2, 3}));
  EXPECT_EQ(leadingNumbers("1 2 3", 2), (std::vector<double>{1, 2}));
  EXPECT_EQ(leadingNumbers("1 x 3", 3), (std::vector<double>{1}));
}

TEST(ValueCheck, IsMadeWhereNoReaderLooks) {
  EXPECT_EQ(
      loadLink("<visual name='v'><geometry><empty/></geometry>\n<cast_shadows>yes</cast_shadows></visual>").messages,
      Messages{"t.sdf:5:1: error: <cast_shadows> is 'yes', which is not 'true' or 'false'"});
  EXPECT_EQ(
      loadLink("<battery name='b'><voltage>1V</voltage></battery>").messages,
      Messages{
          "t.sdf:4:19: warning: <voltage> is '1V', which is not a number | Fortress reads as much of it as it can"});
  EXPECT_EQ(loadLink("<battery/>").messages,
            Messages{"t.sdf:4:1: error: <battery> has no name | write <battery name=\"...\">"});
  EXPECT_EQ(loadLink("<projector name='p'><plugin name='p'/></projector>").messages,
            Messages{"t.sdf:4:21: error: <plugin> has no filename | write <plugin filename=\"...\">"});
}

TEST(ValueCheck, LetsNoRubbishPass) {
  int count = 0;
  FormatWalk([&count](const Place& place) {
    const SchemaRow& row = place.part().row;
    if (row.type.empty() || row.type == "string") return;
    ++count;
    const std::string file = documentWith(place, "rubbish");
    const Loaded loaded = load(file);
    const auto isSeen = [](const std::string& message) {
      return message.starts_with("t.sdf:2:") && message.find("rubbish") != std::string::npos;
    };
    EXPECT_TRUE(std::ranges::any_of(loaded.messages, isSeen)) << row.path << "\n" << file;
  });
  EXPECT_GT(count, 1000);
}

}  // namespace
}  // namespace pongsim::sdf::test
