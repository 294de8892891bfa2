#include "sdf/value_check.hh"

#include <algorithm>
#include <set>
#include <utility>
#include <vector>

#include "load_support.hh"
#include "sdf/schema.hh"

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

// Each of these was given to libsdformat 12.3, too: it refuses the errors and takes the warnings.
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

TEST(ValueCheck, IsMadeWhereNoReaderLooks) {
  EXPECT_EQ(
      loadLink("<visual name='v'><geometry><empty/></geometry>\n<cast_shadows>yes</cast_shadows></visual>").messages,
      Messages{"t.sdf:5:1: error: <cast_shadows> is 'yes', which is not 'true' or 'false'"});
  EXPECT_EQ(loadLink("<battery name='b'><voltage>1V</voltage></battery>").messages,
            Messages{"t.sdf:4:19: warning: <voltage> is '1V', which is not a number | Fortress takes as much of it as "
                     "it can"});
  EXPECT_EQ(loadLink("<battery/>").messages,
            Messages{"t.sdf:4:1: error: <battery> has no name | write <battery name=\"...\">"});
  EXPECT_EQ(loadLink("<projector name='p'><plugin name='p'/></projector>").messages,
            Messages{"t.sdf:4:21: error: <plugin> has no filename | write <plugin filename=\"...\">"});
}

/// The way from `<sdf>` to each element and attribute: the elements on it, and the part itself at the end.
using Way = std::vector<const Schema::Part*>;

void collect(const Way& way, bool isAttribute, std::vector<std::pair<Way, bool>>& ways,
             std::set<std::string_view>& known) {
  const Schema::Part& last = *way.back();
  if (!known.insert(last.row.path).second || last.row.removedIn != 0 || last.name == "*") return;
  ways.emplace_back(way, isAttribute);
}

std::vector<std::pair<Way, bool>> allWays() {
  std::vector<std::pair<Way, bool>> ways{{{&Schema::instance().root()}, false}};
  std::set<std::string_view> known;
  for (std::size_t i = 0; i < ways.size(); ++i) {
    const auto [way, isAttribute] = ways[i];
    if (isAttribute || way.back()->type == nullptr) continue;
    for (const Schema::Part& part : way.back()->type->attributes) {
      Way next = way;
      next.push_back(&part);
      collect(next, true, ways, known);
    }
    for (const Schema::Part& part : way.back()->type->children) {
      Way next = way;
      next.push_back(&part);
      collect(next, false, ways, known);
    }
  }
  return ways;
}

/// @return A file with the text "rubbish" at the end of the way, in line 2.
std::string fileFor(const Way& way, bool isAttribute) {
  std::string begin, end;
  const std::size_t elements = way.size() - (isAttribute ? 1 : 0);
  for (std::size_t i = 0; i < elements; ++i) {
    const std::string name(way[i]->name);
    if (i + 1 == elements) begin += "\n";
    begin += "<" + name;
    if (i + 1 == elements && isAttribute) begin += " " + std::string(way.back()->name) + "='rubbish'";
    if (way[i]->type != nullptr) {
      for (const Schema::Part& attribute : way[i]->type->attributes) {
        if (attribute.row.presence != '1' || (isAttribute && i + 1 == elements && &attribute == way.back())) continue;
        const std::string value = attribute.name == "version" ? "1.9" : attribute.name == "type" ? "universal" : "1";
        begin += " " + std::string(attribute.name) + "='" + value + "'";
      }
    }
    begin += ">";
    end.insert(0, "</" + name + ">");
    // what else is needed for the reader to come so far
    if (name == "model" && i + 1 < elements) begin += "<link name='a'/><link name='b'/>";
    if (name == "joint" && i + 1 < elements) begin += "<parent>a</parent><child>b</child>";
  }
  return begin + (isAttribute ? "" : "rubbish") + end;
}

TEST(ValueCheck, LetsNoRubbishPass) {
  int count = 0;
  for (const auto& [way, isAttribute] : allWays()) {
    const SchemaRow& row = way.back()->row;
    // what an include says is read where there is a file to include
    if (row.type.empty() || row.type == "string" || row.path.find(".include.") != row.path.npos) continue;
    ++count;
    const std::string file = fileFor(way, isAttribute);
    const Loaded loaded = load(file);
    const auto isSeen = [](const std::string& message) {
      return message.starts_with("t.sdf:2:") && message.find("rubbish") != std::string::npos;
    };
    EXPECT_TRUE(std::ranges::any_of(loaded.messages, isSeen)) << row.path << "\n" << file;
  }
  EXPECT_GT(count, 300);
}

}  // namespace
}  // namespace pongsim::sdf::test
