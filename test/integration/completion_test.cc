#include <gtest/gtest.h>

#include <algorithm>
#include <filesystem>
#include <string>
#include <vector>

#include "integration/program.hh"
#include "support/fortress_worlds.hh"
#include "support/test_domain.hh"

namespace pongsim::test {
namespace {

/// @return bash's completions for the last word.
std::vector<std::string> offered(const std::vector<std::string>& words) {
  testDomain();
  std::string line;
  for (const std::string& word : words) line += " '" + word + "'";
  const std::string folder = std::filesystem::path(PONGSIM_PROGRAM).parent_path().string();
  Process bash({"bash", "-c",
                "PATH=" + folder + ":$PATH; source <(pongsim completion bash); COMP_WORDS=(" + line + "); COMP_CWORD=" +
                    std::to_string(words.size() - 1) + "; _pongsim; printf '%s\\n' \"${COMPREPLY[@]}\""},
               {.environment = {}, .folder = projectFolder()});
  EXPECT_EQ(bash.wait(), 0) << bash.error();
  EXPECT_EQ(bash.error(), "");
  return lines(bash.output());
}

using Words = std::vector<std::string>;

TEST(Completion, OffersCommandsAndOptions) {
  EXPECT_EQ(offered({"pongsim", "to"}), Words{"topic"});
  EXPECT_EQ(offered({"pongsim", "--ver"}), Words{"--version"});
  EXPECT_EQ(offered({"pongsim", "run", "--ite"}), Words{"--iterations"});
  EXPECT_EQ(offered({"pongsim", "topic", "--json-"}), Words{"--json-output"});
  EXPECT_EQ(offered({"pongsim", "world", "st"}), (Words{"step", "stats"}));
  EXPECT_EQ(offered({"pongsim", "model", "--fo"}), Words{"--follow"});
}

TEST(Completion, OffersFilesTypesAndTopics) {
  EXPECT_EQ(offered({"pongsim", "run", "worlds/pong_w"}), Words{"worlds/pong_world.sdf"});
  EXPECT_EQ(offered({"pongsim", "topic", "-m", "ignition.msgs.FluidP"}), Words{"ignition.msgs.FluidPressure"});
  EXPECT_EQ(offered({"pongsim", "msg", "-t", "ignition.msgs.FluidP"}), Words{"ignition.msgs.FluidPressure"});
  const auto world = startServedWorld("pong_world.sdf");
  EXPECT_EQ(offered({"pongsim", "topic", "-t", "/cmd"}), Words{"/cmd_vel"});
  EXPECT_EQ(offered({"pongsim", "model", "-m", "pong_"}), Words{"pong_bot"});
  EXPECT_EQ(offered({"pongsim", "world", "-w", ""}), Words{"pong_world"});
  EXPECT_EQ(offered({"pongsim", "service", "-s", "/world/pong_world/con"}), Words{"/world/pong_world/control"});
}

TEST(Completion, IsForBashAndZsh) {
  EXPECT_TRUE(runToEnd({"completion", "zsh"}).output.starts_with("#compdef pongsim\n"));
  const Outcome fish = runToEnd({"completion", "fish"});
  EXPECT_EQ(fish.exitCode, 2);
  EXPECT_EQ(fish.error, "pongsim: error: no completion for 'fish'\n  hint: bash or zsh\n");
}

}  // namespace
}  // namespace pongsim::test
