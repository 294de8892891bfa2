#include "base/own_program.hh"

#include <gtest/gtest.h>

namespace pongsim::base {
namespace {

TEST(OwnProgram, IsThatOfTheBuildTree) {
  const std::filesystem::path program = ownProgram("pongsim-xacro");
  EXPECT_EQ(program.filename(), "pongsim-xacro");
  EXPECT_TRUE(std::filesystem::exists(program));
  EXPECT_EQ(ownProgram("pongsim-none"), "");
}

}  // namespace
}  // namespace pongsim::base
