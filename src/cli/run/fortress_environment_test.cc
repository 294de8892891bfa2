#include "cli/run/fortress_environment.hh"

#include <gtest/gtest.h>

#include <cstdlib>

namespace pongsim::cli {
namespace {

/// Clears the variables that a test sets.
class FortressEnvironment : public testing::Test {
 protected:
  ~FortressEnvironment() override {
    for (const char* name : {"IGN_IP", "GZ_IP", "IGN_TRANSPORT_PASSWORD"}) unsetenv(name);
  }
};

TEST_F(FortressEnvironment, IsQuietWhereNothingIsSet) { EXPECT_TRUE(ignoredVariables().empty()); }

TEST_F(FortressEnvironment, TellsWhatChangesNothing) {
  setenv("IGN_IP", "192.168.1.20", 1);
  setenv("IGN_TRANSPORT_PASSWORD", "secret", 1);
  const std::vector<std::string> sentences = ignoredVariables();
  ASSERT_EQ(sentences.size(), 2U);
  EXPECT_EQ(sentences[0], "IGN_IP has no effect on pongsim's own topics: use PONGSIM_NETWORK to reach other machines");
  EXPECT_TRUE(sentences[1].starts_with("IGN_TRANSPORT_PASSWORD has no effect on pongsim's own topics: "))
      << sentences[1];
}

TEST_F(FortressEnvironment, KnowsTheLaterNames) {
  setenv("GZ_IP", "192.168.1.20", 1);
  EXPECT_EQ(ignoredVariables(), std::vector<std::string>{"GZ_IP has no effect on pongsim's own topics: use "
                                                         "PONGSIM_NETWORK to reach other machines"});
}

TEST_F(FortressEnvironment, IsQuietWhereItIsSoAnyway) {
  setenv("IGN_IP", "127.0.0.1", 1);
  setenv("GZ_IP", "127.0.0.2", 1);
  setenv("IGN_TRANSPORT_PASSWORD", "", 1);
  EXPECT_TRUE(ignoredVariables().empty());
}

}  // namespace
}  // namespace pongsim::cli
