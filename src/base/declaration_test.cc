#include "pongsim/declaration.hh"

#include <gtest/gtest.h>

#include <limits>
#include <memory>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "pongsim/commands.hh"

namespace pongsim {
namespace {

Element pluginWith(const std::vector<std::pair<std::string, std::string>>& parameters) {
  Element plugin;
  plugin.name = "plugin";
  plugin.position = {std::make_shared<const std::string>("world.sdf"), 1, 1};
  int line = 2;
  for (const auto& [name, text] : parameters) {
    Element& element = plugin.children.emplace_back();
    element.name = name;
    element.text = text;
    element.position = {plugin.position.file, line++, 3};
  }
  return plugin;
}

/// A system's parameters, one of each kind.
struct Settings {
  double number = 1.5;
  int count = 2;
  bool flag = false;
  std::string word = "a";
  Vector3 vector{1, 0, 0};
  std::optional<double> perhaps;
  std::vector<std::string> words;
  std::vector<double> numbers;

  Settings() {
    declaration.is("A test.", Declaration::Place::kModel);
    declaration.parameter("number", &number, "m", "a length").above(0);
    declaration.parameter("count", &count, "", "a count").atLeast(1).atMost(9);
    declaration.parameter("flag", &flag, "", "a flag");
    declaration.parameter("word", &word, "", "a word").oneOf({"a", "b"});
    declaration.parameter("vector", &vector, "m", "a place");
    declaration.parameter("perhaps", &perhaps, "", "given or not").mayBeInfinite();
    declaration.parameter("words", &words, "", "names").required();
    declaration.parameter("numbers", &numbers, "", "numbers");
  }
  Declaration declaration;

  /// @return What is said about the plugin, a line each.
  std::vector<std::string> read(const Element& plugin) {
    Diagnostics diagnostics;
    isGood = declaration.read(plugin, "test", diagnostics);
    std::vector<std::string> lines;
    for (const Diagnostic& diagnostic : diagnostics.all()) lines.push_back(format(diagnostic));
    return lines;
  }
  bool isGood = false;
};

TEST(Declaration, LeavesDefaultsAlone) {
  Settings settings;
  EXPECT_TRUE(settings.read(pluginWith({{"words", "x"}, {"number", ""}})).empty());
  EXPECT_TRUE(settings.isGood);
  EXPECT_EQ(settings.number, 1.5);
  EXPECT_EQ(settings.word, "a");
  EXPECT_FALSE(settings.perhaps);
}

TEST(Declaration, ReadsEachKind) {
  Settings settings;
  EXPECT_TRUE(settings
                  .read(pluginWith({{"number", "2"},
                                    {"count", "7"},
                                    {"flag", "true"},
                                    {"word", "b"},
                                    {"vector", "1 2 3"},
                                    {"perhaps", "inf"},
                                    {"words", "x"},
                                    {"words", "y"},
                                    {"numbers", "4"},
                                    {"numbers", "5"},
                                    {"number", "3"}}))
                  .empty());
  EXPECT_EQ(settings.number, 2) << "the first counts";
  EXPECT_EQ(settings.count, 7);
  EXPECT_TRUE(settings.flag);
  EXPECT_EQ(settings.word, "b");
  EXPECT_EQ(settings.vector, Vector3(1, 2, 3));
  EXPECT_EQ(settings.perhaps, std::numeric_limits<double>::infinity());
  EXPECT_EQ(settings.words, (std::vector<std::string>{"x", "y"}));
  EXPECT_EQ(settings.numbers, (std::vector<double>{4, 5}));
}

TEST(Declaration, NamesThePlaceOfEachWrongValue) {
  const std::pair<const char*, const char*> cases[] = {
      {"number wide", "<number> is 'wide', which is not a number"},
      {"number 0", "<number> must be above zero"},
      {"number inf", "<number> must be above zero"},
      {"count 0", "<count> must be at least 1"},
      {"count 10", "<count> must be at most 9"},
      {"count 1.5", "<count> is '1.5', which is not an integer"},
      {"flag maybe", "<flag> is 'maybe', which is not 'true' or 'false'"},
      {"word c", "<word> is 'c'\n  hint: it can be 'a', 'b'"},
      {"vector 1 2", "<vector> is '1 2', which is not three numbers"},
      {"vector 1 2 inf", "<vector> must be three finite numbers"},
      {"perhaps nan", "<perhaps> must be a finite number"},
      {"numbers inf", "<numbers> must be a finite number"}};
  for (const auto& [given, message] : cases) {
    const std::string text(given);
    const std::size_t space = text.find(' ');
    Settings settings;
    EXPECT_EQ(settings.read(pluginWith({{text.substr(0, space), text.substr(space + 1)}, {"words", "x"}})),
              std::vector<std::string>{"world.sdf:2:3: warning: test is left out: " + std::string(message)});
    EXPECT_FALSE(settings.isGood);
  }
}

TEST(Declaration, RefusesForcesThatCannotBeMeant) {
  for (const char* unit : {"N", "N m"}) {
    double force = 0;
    Declaration declaration;
    declaration.parameter("force", &force, unit, "a force");
    Diagnostics good, bad;
    EXPECT_TRUE(declaration.read(pluginWith({{"force", "-1e8"}}), "test", good));
    EXPECT_EQ(force, -1e8);
    EXPECT_FALSE(declaration.read(pluginWith({{"force", "1e308"}}), "test", bad));
    EXPECT_EQ(format(bad.all().at(0)), std::string("world.sdf:2:3: warning: test is left out: <force> must be from "
                                                   "-1e+08 to 1e+08 ") +
                                           unit);
  }
  EXPECT_EQ(kLargestForce, 1e8) << "the bound of messages";
}

TEST(Declaration, SaysAllThatIsWrongAtOnce) {
  Settings settings;
  EXPECT_EQ(
      settings.read(pluginWith({{"number", "-1"}, {"numbr", "1"}, {"other:thing", "1"}})),
      (std::vector<std::string>{"world.sdf:2:3: warning: test is left out: <number> must be above zero",
                                "world.sdf:1:1: warning: test is left out: no <words> is given\n  hint: names",
                                "world.sdf:3:3: warning: test does not know <numbr>\n  hint: did you mean 'number'?"}));
}

TEST(Declaration, KnowsAllElementsWhereItHandsThemOn) {
  Settings settings;
  settings.declaration.element("*", "any other element");
  EXPECT_EQ(settings.read(pluginWith({{"words", "a"}, {"numbr", "1"}, {"anything", "1"}})), std::vector<std::string>{});
  EXPECT_TRUE(settings.isGood);
}

TEST(Declaration, TellsOfItsParameters) {
  const Settings settings;
  const auto& parameters = settings.declaration.parameters();
  ASSERT_EQ(parameters.size(), 8U);
  EXPECT_EQ(parameters[0].fallback(), "1.5");
  EXPECT_EQ(parameters[0].type(), "number");
  EXPECT_EQ(parameters[2].fallback(), "false");
  EXPECT_EQ(parameters[4].fallback(), "1 0 0");
  EXPECT_EQ(parameters[5].fallback(), "");
  EXPECT_TRUE(parameters[6].isRequired());
  EXPECT_TRUE(parameters[6].isRepeated());
  EXPECT_FALSE(parameters[5].isRepeated());
}

TEST(Declaration, ReadsTheMembersOfAFamilyByTheirOwnNames) {
  double xU = 0, xV = 0;
  Declaration declaration;
  declaration.parameter("xU", &xU, "kg/s", "damping").inFamily("x{UV}");
  declaration.parameter("xV", &xV, "kg/s", "damping").inFamily("x{UV}");
  Diagnostics diagnostics;
  EXPECT_TRUE(declaration.read(pluginWith({{"xV", "-2"}}), "test", diagnostics));
  EXPECT_TRUE(diagnostics.all().empty());
  EXPECT_EQ(xU, 0);
  EXPECT_EQ(xV, -2);
  EXPECT_EQ(declaration.parameters()[1].family(), "x{UV}");
}

TEST(Declaration, OfNothingTakesAnything) {
  Diagnostics diagnostics;
  EXPECT_TRUE(Declaration().read(pluginWith({{"anything", "1"}}), "test", diagnostics));
  EXPECT_TRUE(diagnostics.all().empty());
}

}  // namespace
}  // namespace pongsim
