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
