#include "cli/talk.hh"

#include <gtest/gtest.h>

#include <string>
#include <vector>

namespace pongsim::cli {
namespace {

bool isTalkOf(std::vector<std::string> words) {
  std::vector<char*> arguments;
  for (std::string& word : words) arguments.push_back(word.data());
  return isTalk(static_cast<int>(arguments.size()), arguments.data());
}

TEST(Talk, IsOfTopicsAndServices) {
  EXPECT_TRUE(isTalkOf({"pongsim", "topic", "-l"}));
  EXPECT_TRUE(isTalkOf({"ign", "service", "--help"}));
  for (const char* other : {"run", "topics", "--help", "help", ""}) EXPECT_FALSE(isTalkOf({"pongsim", other})) << other;
  EXPECT_FALSE(isTalkOf({"pongsim"}));
  EXPECT_FALSE(isTalkOf({}));
}

}  // namespace
}  // namespace pongsim::cli
