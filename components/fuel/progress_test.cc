#include "fuel/progress.hh"

#include <gtest/gtest.h>

namespace pongsim::fuel {
namespace {

TEST(Progress, WritesSizesAsPeopleDo) {
  EXPECT_EQ(sizeText(0), "0 B");
  EXPECT_EQ(sizeText(999), "999 B");
  EXPECT_EQ(sizeText(1000), "1.0 kB");
  EXPECT_EQ(sizeText(1'234'567), "1.2 MB");
  EXPECT_EQ(sizeText(999'960'000), "1.0 GB");
  EXPECT_EQ(sizeText(5'000'000'000'000'000), "5000.0 TB");
}

TEST(Progress, IsLinesWithoutATerminal) {
  testing::internal::CaptureStderr();
  {
    Progress progress(3, false);
    progress.begin("o/m", 0, 2000);
    progress.add("o/m", 2000);
    progress.warning("slow");
    progress.end("o/m", "2.0 kB");
    progress.begin("o/n", 10, 0);
    progress.drop("o/n");
  }
  EXPECT_EQ(testing::internal::GetCapturedStderr(),
            "pongsim: downloading o/m, 2.0 kB\npongsim: warning: slow\npongsim: o/m: 2.0 kB\n"
            "pongsim: downloading o/n, from byte 10 on\n");
}

TEST(Progress, IsABarOnATerminalThatGoesAtTheEnd) {
  testing::internal::CaptureStderr();
  {
    Progress progress(3, true);
    progress.begin("o/m", 500, 1000);
    progress.begin("o/n", 0, 1000);
  }
  const std::string said = testing::internal::GetCapturedStderr();
  EXPECT_NE(said.find("[==========          ] 50 %  500 B of 1.0 kB  o/m"), std::string::npos) << said;
  EXPECT_NE(said.find("25 %  500 B of 2.0 kB  o/m, o/n"), std::string::npos) << said;
  EXPECT_TRUE(said.ends_with("\r\x1b[K"));
}

TEST(Progress, IsQuietWhereThatIsWanted) {
  testing::internal::CaptureStderr();
  Progress progress(1, true);
  progress.begin("o/m", 0, 0);
  progress.warning("x");
  progress.end("o/m", "");
  EXPECT_EQ(testing::internal::GetCapturedStderr(), "");
}

}  // namespace
}  // namespace pongsim::fuel
