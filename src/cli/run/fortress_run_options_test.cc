#include "cli/run/fortress_run_options.hh"

#include <gtest/gtest.h>

#include <CLI/App.hpp>

#include "shared/program/failure.hh"

namespace pongsim::cli {
namespace {

/// @param words Behind each other, the last first, as CLI11 takes them.
std::vector<std::string> sentencesOn(std::vector<std::string> words) {
  CLI::App app;
  FortressRunOptions options;
  options.addTo(app);
  app.parse(std::move(words));
  return options.check();
}

TEST(FortressRunOptions, TakeWhatIsSoAnyway) {
  EXPECT_TRUE(sentencesOn({"-s"}).empty());
  EXPECT_TRUE(sentencesOn({"--headless-rendering"}).empty());
  EXPECT_TRUE(sentencesOn({"ogre", "--render-engine"}).empty());
  EXPECT_TRUE(sentencesOn({"ignition-rendering-ogre2", "--render-engine-server"}).empty());
  EXPECT_TRUE(sentencesOn({"a.config", "--gui-config", "ogre", "--render-engine-gui", "-s"}).empty());
  EXPECT_TRUE(sentencesOn({"-g", "-s"}).empty());
  EXPECT_TRUE(sentencesOn({"--wait-for-assets"}).empty());
  EXPECT_TRUE(sentencesOn({"0", "--initial-sim-time"}).empty());
  EXPECT_TRUE(sentencesOn({"gz-rendering8-ogre2", "--render-engine"}).empty());
  EXPECT_TRUE(sentencesOn({"vulkan", "--render-engine-api-backend"}).empty());
  EXPECT_TRUE(sentencesOn({"opengl", "--render-engine-server-api-backend"}).empty());
  EXPECT_TRUE(sentencesOn({"opengl", "--render-engine-gui-api-backend", "-s"}).empty());
}

TEST(FortressRunOptions, SayWhatChangesNothing) {
  EXPECT_EQ(sentencesOn({"a.config", "--gui-config"}),
            (std::vector<std::string>{"'--gui-config' has no effect: pongsim has no GUI"}));
  EXPECT_EQ(sentencesOn({"ogre", "--render-engine-gui"}),
            (std::vector<std::string>{"'--render-engine-gui' has no effect: pongsim has no GUI"}));
  EXPECT_EQ(sentencesOn({"opengl", "--render-engine-gui-api-backend"}),
            (std::vector<std::string>{"'--render-engine-gui-api-backend' has no effect: pongsim has no GUI"}));
  EXPECT_EQ(sentencesOn({"ignition-physics-tpe-plugin", "--physics-engine"}),
            (std::vector<std::string>{"'--physics-engine' has no effect: pongsim has its own engine"}));
}

TEST(FortressRunOptions, RefuseWhatCannotBe) {
  EXPECT_THROW(sentencesOn({"-g"}), UsageError);
  EXPECT_THROW(sentencesOn({"primary", "--network-role"}), UsageError);
  EXPECT_THROW(sentencesOn({"2", "--network-secondaries"}), UsageError);
  EXPECT_THROW(sentencesOn({"optix", "--render-engine"}), UsageError);
  EXPECT_THROW(sentencesOn({"gz-rendering-optix", "--render-engine"}), UsageError);
  EXPECT_THROW(sentencesOn({"glide", "--render-engine-api-backend"}), UsageError);
  EXPECT_THROW(sentencesOn({"10", "--initial-sim-time"}), UsageError);
  EXPECT_THROW(sentencesOn({"soon", "--initial-sim-time"}), UsageError);
  EXPECT_THROW(sentencesOn({"optix", "--render-engine-server"}), UsageError);
}

}  // namespace
}  // namespace pongsim::cli
