#include "cli/files/diagnostic_report.hh"

#include <gtest/gtest.h>

#include "support/temp_folder.hh"

namespace pongsim::cli {
namespace {

class DiagnosticReport : public testing::Test {
 protected:
  SourcePosition in(const std::string& text, int line, int column = 1) {
    const std::string file = folder_.write("f.sdf", text).string();
    return {std::make_shared<const std::string>(file), line, column};
  }

  test::TempFolder folder_;
};

TEST_F(DiagnosticReport, FindsTheLineOfAFile) {
  const SourcePosition position = in("\xEF\xBB\xBFone\r\ntwo\nthree", 1);
  SourceLines lines;
  EXPECT_EQ(lines.at(position).text, "one");
  EXPECT_EQ(lines.at({position.file, 2, 1}).text, "two");
  EXPECT_EQ(lines.at({position.file, 3, 1}).text, "three");
  for (const int line : {-1, 0, 4}) EXPECT_EQ(lines.at({position.file, line, 1}).text, "");
}

TEST_F(DiagnosticReport, FindsNoLineWhereThereIsNoFile) {
  SourceLines lines;
  EXPECT_EQ(lines.at({}).text, "");
  EXPECT_EQ(lines.at({std::make_shared<const std::string>("/no/such/file"), 1, 1}).text, "");
  EXPECT_EQ(lines.at({std::make_shared<const std::string>(folder_.path().string()), 1, 1}).text, "");
}

TEST_F(DiagnosticReport, ShowsOfALongLineWhatIsAroundTheColumn) {
  std::string line;
  // letters of one, two and three bytes
  for (int i = 0; i < 5000; ++i) line += i % 3 == 0 ? "a" : i % 3 == 1 ? "ä" : "€";
  SourcePosition position = in("first\n" + line + "\r\nlast", 2);
  SourceLines lines;
  for (const int column :
       {1, 2, 60, 61, 120, 121, 255, 256, 257, 258, 511, 513, 2500, 4744, 4900, 4999, 5000, 5001, 9999}) {
    position.column = column;
    const Diagnostic diagnostic{Severity::kError, position, "wrong", {}};
    const SourceExcerpt part = lines.at(position);
    EXPECT_LT(part.text.size(), 3000U);
    EXPECT_EQ(format(diagnostic, part), format(diagnostic, {.text = line})) << column;
  }
  EXPECT_EQ(lines.at({position.file, 3, 1}).text, "last");
}

TEST_F(DiagnosticReport, SaysWhatIsBadEnoughWithItsLine) {
  const SourcePosition position = in("<a>\n  <b/>", 2, 3);
  Diagnostics diagnostics;
  diagnostics.warning(position, "odd");
  diagnostics.error(position, "wrong", "do it right");
  const std::string begin = *position.file + ":2:3: ", source = "\n      <b/>\n      ^\n";
  testing::internal::CaptureStderr();
  say(diagnostics, Severity::kWarning, Severity::kWarning);
  const std::string error = begin + "error: wrong" + source + "  hint: do it right\n";
  EXPECT_EQ(testing::internal::GetCapturedStderr(), begin + "warning: odd" + source + error);
  testing::internal::CaptureStderr();
  say(diagnostics, Severity::kWarning, Severity::kError);
  EXPECT_EQ(testing::internal::GetCapturedStderr(), begin + "warning: odd\n" + error);
  testing::internal::CaptureStderr();
  say(diagnostics, Severity::kError, Severity::kWarning);
  EXPECT_EQ(testing::internal::GetCapturedStderr(), error);
}

TEST(DiagnosticJson, HasWhatIsKnown) {
  const auto file = std::make_shared<const std::string>("a.sdf");
  EXPECT_EQ(jsonOf({}), "[]\n");
  EXPECT_EQ(jsonOf({{Severity::kError, {file, 1, 2}, "m", "h", {{file, 3, 4}, {file, 5, 0}}},
                    {Severity::kWarning, {file, 0, 0}, "n", {}},
                    {Severity::kWarning, {}, "o", {}}}),
            "[{\"file\":\"a.sdf\",\"line\":1,\"column\":2,\"severity\":\"error\",\"message\":\"m\",\"hint\":\"h\","
            "\"includedFrom\":[{\"file\":\"a.sdf\",\"line\":3,\"column\":4},{\"file\":\"a.sdf\",\"line\":5}]},"
            "{\"file\":\"a.sdf\",\"severity\":\"warning\",\"message\":\"n\"},"
            "{\"severity\":\"warning\",\"message\":\"o\"}]\n");
}

TEST(DiagnosticJson, IsSoundWhateverTheTextIs) {
  const auto message = [](std::string text) {
    const std::string report = jsonOf({{Severity::kError, {}, std::move(text), {}}});
    const std::string begin = "[{\"severity\":\"error\",\"message\":\"", end = "\"}]\n";
    EXPECT_TRUE(report.starts_with(begin) && report.ends_with(end)) << report;
    return report.substr(begin.size(), report.size() - begin.size() - end.size());
  };
  EXPECT_EQ(message("a\"b\\c\n\x01"), "a\\\"b\\\\c\\n\\u0001");
  EXPECT_EQ(message("ä€😀"), "ä€😀");
  // cut off, not begun, too long a form, half of a pair, beyond the last letter
  EXPECT_EQ(message("\xC3"), "\uFFFD");
  EXPECT_EQ(message("\x80z"), "\uFFFDz");
  EXPECT_EQ(message("\xC0\x80"), "\uFFFD\uFFFD");
  EXPECT_EQ(message("\xE0\x80\x80"), "\uFFFD\uFFFD\uFFFD");
  EXPECT_EQ(message("\xED\xA0\x80"), "\uFFFD\uFFFD\uFFFD");
  EXPECT_EQ(message("\xF4\x90\x80\x80"), "\uFFFD\uFFFD\uFFFD\uFFFD");
  EXPECT_EQ(message("\xF5z"), "\uFFFDz");
}

}  // namespace
}  // namespace pongsim::cli
