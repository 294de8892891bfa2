#include "cli/help/manual.hh"

#include <gtest/gtest.h>

#include <CLI/App.hpp>
#include <CLI/Config.hpp>
#include <CLI/Formatter.hpp>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <string>

#include "cli/cli.hh"
#include "support/process.hh"
#include "support/temp_folder.hh"

namespace pongsim::cli {
namespace {

TEST(Manual, TellsWhatHelpTells) {
  CLI::App program("tool does things.", "tool");
  bool flag = false;
  std::string name, file;
  CLI::App* command = program.add_subcommand("make", "Make it");
  command->add_flag("-f,--fast", flag, "Don't\n.wait");
  command->add_option("--name", name, "A \\ name")->type_name("NAME");
  command->add_option("FILE", file, "What of")->type_name("")->required();
  command->footer("Examples:\n  tool make --fast x");
  const std::vector<ManualPage> pages = manualPages(program);
  ASSERT_EQ(pages.size(), 2U);
  EXPECT_EQ(pages[0].file, "pongsim-make.1");
  EXPECT_EQ(pages[1].file, "pongsim.1");
  for (const char* part :
       {".SH NAME\npongsim\\-make \\- make it\n", "\\fBpongsim make\\fR [\\fIOPTIONS\\fR] \\fIFILE\\fR\n",
        ".TP\n\\fB\\-f\\fR, \\fB\\-\\-fast\\fR\nDon't\n\\&.wait\n", "\\fB\\-\\-name\\fR \\fINAME\\fR\nA \\e name\n",
        ".SH EXAMPLES\n.nf\ntool make \\-\\-fast x\n.fi\n"}) {
    EXPECT_NE(pages[0].text.find(part), std::string::npos) << part << "\n" << pages[0].text;
  }
}

// As man takes them, and with all that is in the help.
TEST(Manual, HasPagesThatManReadsWithoutComplaint) {
  const test::TempFolder folder;
  ASSERT_TRUE(pongsim_write_manual(folder.path().c_str()));
  EXPECT_FALSE(pongsim_write_manual((folder.path() / "not/there").c_str()));
  int pages = 0;
  for (const auto& entry : std::filesystem::directory_iterator(folder.path())) {
    ++pages;
    std::ifstream stream(entry.path());
    const std::string text(std::istreambuf_iterator<char>(stream), {});
    EXPECT_NE(text.find(".SH EXAMPLES\n.nf\n"), std::string::npos) << entry.path();
    EXPECT_NE(text.find("\\fB\\-\\-help\\fR"), std::string::npos) << entry.path();
    test::Process man({"man", "--warnings", "-E", "UTF-8", "-l", "-Tutf8", entry.path().string()},
                      {.environment = {{"LC_ALL", "C.UTF-8"}, {"MANROFFSEQ", ""}}, .folder = {}});
    const auto code = man.wait();
    if (code == 127) GTEST_SKIP() << "there is no man";
    EXPECT_EQ(code, 0) << entry.path();
    EXPECT_EQ(man.error(), "") << entry.path();
    EXPECT_NE(man.output().find("Print this help and exit"), std::string::npos) << man.output();
  }
  EXPECT_GT(pages, 10);
}

}  // namespace
}  // namespace pongsim::cli
