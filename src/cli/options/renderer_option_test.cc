#include "cli/options/renderer_option.hh"

#include <gtest/gtest.h>

#include <CLI/App.hpp>
#include <cstdlib>

#include "shared/program/failure.hh"
#include "support/environment_variable.hh"

namespace pongsim::cli {
namespace {

TEST(RendererOption, ChoosesForAllThatIsDrawn) {
  const test::EnvironmentVariable before("PONGSIM_RENDERER");
  CLI::App app;
  addRendererOption(app);
  app.parse("--renderer auto");
  EXPECT_STREQ(std::getenv("PONGSIM_RENDERER"), "auto");
  EXPECT_THROW(app.parse("--renderer gpu"), UsageError);
  EXPECT_STREQ(std::getenv("PONGSIM_RENDERER"), "auto");
}

}  // namespace
}  // namespace pongsim::cli
