#include "pongsim/diagnostic.hh"

#include <gtest/gtest.h>

namespace pongsim {
namespace {

SourcePosition at(int line, int column) { return {std::make_shared<const std::string>("world.sdf"), line, column}; }

TEST(Diagnostic, IsALineThatEditorsCanFollow) {
  EXPECT_EQ(format({Severity::kError, at(41, 9), "joint 'j' has no <child>", {}}),
            "world.sdf:41:9: error: joint 'j' has no <child>");
}

TEST(Diagnostic, LeavesOutWhatIsNotKnown) {
  EXPECT_EQ(format({Severity::kWarning, at(41, 0), "odd", {}}), "world.sdf:41: warning: odd");
  EXPECT_EQ(format({Severity::kError, at(0, 0), "no such file", {}}), "world.sdf: error: no such file");
  EXPECT_EQ(format({Severity::kError, {}, "wrong", {}}), "error: wrong");
}

TEST(Diagnostic, PutsTheHintOnALineOfItsOwn) {
  EXPECT_EQ(format({Severity::kError, at(1, 2), "wrong", "do it right"}),
            "world.sdf:1:2: error: wrong\n  hint: do it right");
}

TEST(Diagnostic, NamesTheFilesThatIncludeItsOwn) {
  EXPECT_EQ(format({Severity::kError, at(1, 2), "wrong", "do it right", {at(5, 3), at(9, 0)}}),
            "world.sdf:1:2: error: wrong\n  hint: do it right\n  included from world.sdf:5:3\n"
            "  included from world.sdf:9");
}

TEST(Diagnostic, ShowsTheLineWithAMark) {
  EXPECT_EQ(format({Severity::kError, at(1, 3), "wrong", "do it right"}, {"\t<link/>"}),
            "world.sdf:1:3: error: wrong\n     <link/>\n      ^\n  hint: do it right");
  // columns count characters, not bytes
  EXPECT_EQ(format({Severity::kError, at(1, 4), "wrong", {}}, {"äöü<"}),
            "world.sdf:1:4: error: wrong\n    äöü<\n       ^");
}

TEST(Diagnostic, ShowsAPartOfALongLine) {
  const std::string line = std::string(200, 'a') + "<" + std::string(200, 'b');
  EXPECT_EQ(format({Severity::kError, at(1, 201), "wrong", {}}, {line}),
            "world.sdf:1:201: error: wrong\n    ..." + std::string(60, 'a') + "<" + std::string(59, 'b') + "...\n" +
                std::string(67, ' ') + "^");
}

TEST(Diagnostic, ShowsAPartOfALineThatIsNotThereWhole) {
  const SourceExcerpt part{.text = "abc<def", .firstColumn = 1000, .isCutOff = true};
  EXPECT_EQ(format({Severity::kError, at(1, 1003), "wrong", {}}, part),
            "world.sdf:1:1003: error: wrong\n    ...abc<def...\n          ^");
  EXPECT_EQ(format({Severity::kError, at(1, 999), "wrong", {}}, part), "world.sdf:1:999: error: wrong");
}

TEST(Diagnostic, HasColoursWhereTheyAreWanted) {
  EXPECT_EQ(
      format({Severity::kError, at(1, 1), "wrong", "do it right"}, {"<a>"}, true),
      "\x1b[1mworld.sdf:1:1:\x1b[0m \x1b[1;31merror:\x1b[0m \x1b[1mwrong\x1b[0m\n    <a>\n    \x1b[1;32m^\x1b[0m\n"
      "  hint: do it right");
  EXPECT_EQ(format({Severity::kWarning, {}, "odd", {}}, {}, true), "\x1b[1;35mwarning:\x1b[0m \x1b[1modd\x1b[0m");
}

TEST(Diagnostic, ShowsNoLineWhereItsColumnIsNotInIt) {
  for (const int column : {0, 4}) {
    EXPECT_EQ(format({Severity::kError, at(0, column), "wrong", {}}, {"abc"}), "world.sdf: error: wrong");
  }
}

TEST(Diagnostics, KeepsOrderAndCountsOnlyErrorsAsErrors) {
  Diagnostics diagnostics;
  diagnostics.warning(at(1, 1), "first");
  EXPECT_FALSE(diagnostics.hasErrors());
  diagnostics.error(at(2, 1), "second");
  EXPECT_TRUE(diagnostics.hasErrors());
  ASSERT_EQ(diagnostics.all().size(), 2U);
  EXPECT_EQ(diagnostics.all()[0].message, "first");
  EXPECT_EQ(diagnostics.all()[1].severity, Severity::kError);
}

TEST(Error, SaysWhatItsDiagnosticSays) {
  const Error error({Severity::kError, at(3, 4), "wrong", {}});
  EXPECT_STREQ(error.what(), "world.sdf:3:4: error: wrong");
  EXPECT_EQ(error.diagnostic().position.line, 3);
}

}  // namespace
}  // namespace pongsim
