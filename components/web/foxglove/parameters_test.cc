#include "web/foxglove/parameters.hh"

#include <gtest/gtest.h>
#include <ignition/msgs/boolean.pb.h>
#include <ignition/msgs/physics.pb.h>
#include <ignition/msgs/world_control.pb.h>

#include <string>
#include <utility>
#include <vector>

#include "support/web/session_of_a_world.hh"

namespace pongsim::web::foxglove {
namespace {

namespace im = ignition::msgs;

/// A world whose services apply what is requested.
class ParametersTest : public SessionTest {
 protected:
  ParametersTest() {
    world_.reportSettings(settings_);
    open();
  }
  json answerTo(const json& message) {
    say(message);
    return await("parameterValues");
  }
  json setting(const std::string& name, const json& value) {
    return {{"op", "setParameters"}, {"parameters", {{{"name", "/world/w/" + name}, {"value", value}}}}, {"id", "s"}};
  }

  WorldSettings settings_{.isPaused = true, .realTimeFactor = 1, .stepSize = 0.001, .gravity = {0, 0, -9.8}};
  Service control_ =
      world_.node().serve<im::WorldControl, im::Boolean>("/world/w/control", [this](const auto& request, auto&) {
        settings_.isPaused = request.pause();
        world_.reportSettings(settings_);
        return ServiceAnswer(true);
      });
  Service physics_ =
      world_.node().serve<im::Physics, im::Boolean>("/world/w/set_physics", [this](const auto& request, auto&) {
        if (request.max_step_size() > 1) return ServiceAnswer::refused("max_step_size is not between 0 and 1 s");
        if (request.max_step_size() > 0) settings_.stepSize = request.max_step_size();
        if (request.real_time_factor() > 0) settings_.realTimeFactor = request.real_time_factor();
        if (request.has_gravity())
          settings_.gravity = {request.gravity().x(), request.gravity().y(), request.gravity().z()};
        world_.reportSettings(settings_);
        return ServiceAnswer(true);
      });
};

TEST_F(ParametersTest, AreTheSettingsOfTheWorld) {
  const json all = answerTo({{"op", "getParameters"}, {"parameterNames", json::array()}, {"id", "a"}});
  EXPECT_EQ(all["id"], "a");
  const json expected = {
      {{"name", "/world/w/gravity"}, {"value", {0.0, 0.0, -9.8}}, {"type", "float64_array"}},
      {{"name", "/world/w/max_step_size"}, {"value", 0.001}, {"type", "float64"}},
      {{"name", "/world/w/paused"}, {"value", true}},
      {{"name", "/world/w/real_time_factor"}, {"value", 1.0}, {"type", "float64"}},
  };
  EXPECT_EQ(all["parameters"], expected);
  const json one = answerTo({{"op", "getParameters"}, {"parameterNames", {"/world/w/paused", "/nothing"}}});
  EXPECT_EQ(one["parameters"].size(), 1U);
  EXPECT_FALSE(one.contains("id"));
}

TEST_F(ParametersTest, AreSetByTheServicesOfTheWorld) {
  json told = answerTo(setting("paused", false));
  EXPECT_EQ(told["id"], "s");
  EXPECT_EQ(told["parameters"], (json{{{"name", "/world/w/paused"}, {"value", false}}}));
  answerTo(setting("max_step_size", 0.002));
  answerTo(setting("real_time_factor", 2));
  answerTo(setting("gravity", {0, 0, -1}));
  EXPECT_EQ(settings_, (WorldSettings{false, 2, 0.002, {0, 0, -1}}));
}

TEST_F(ParametersTest, RefuseWhatTheyAreNot) {
  const std::vector<std::pair<std::string, json>> wrong = {{"paused", 1},
                                                           {"real_time_factor", "fast"},
                                                           {"real_time_factor", 0},
                                                           {"max_step_size", -0.001},
                                                           {"gravity", json::array({0, 0})},
                                                           {"gravity", json::array({0, 0, "down"})},
                                                           {"wind", 1}};
  const WorldSettings before = settings_;
  for (const auto& [name, value] : wrong) {
    EXPECT_TRUE(answerTo(setting(name, value))["parameters"].empty());
    EXPECT_NE(status().find("'/world/w/" + name + "'"), std::string::npos);
  }
  EXPECT_TRUE(answerTo(setting("max_step_size", 5))["parameters"].empty());
  const std::string refusal = status();
  EXPECT_TRUE(refusal.starts_with("'/world/w/max_step_size' is not set: ")) << refusal;
  EXPECT_TRUE(refusal.ends_with("max_step_size is not between 0 and 1 s")) << refusal;
  EXPECT_EQ(settings_, before);
  for (const char* operation : {"getParameters", "subscribeParameterUpdates", "unsubscribeParameterUpdates"}) {
    say({{"op", operation}, {"parameterNames", {1}}});
    EXPECT_NE(status().find("'parameterNames'"), std::string::npos);
  }
  say({{"op", "setParameters"}, {"parameters", {1, {{"name", "x"}}}}});
  EXPECT_EQ(status(), "a parameter must have a 'name' and a 'value'; a parameter must have a 'name' and a 'value'");
}

TEST_F(ParametersTest, AreNotSetByWhoMayLookOnly) {
  client_->setMayWrite(false);
  EXPECT_TRUE(answerTo(setting("paused", false))["parameters"].empty());
  EXPECT_EQ(status(), "this client is read-only: '/world/w/paused' is not set");
  EXPECT_TRUE(settings_.isPaused);
}

TEST_F(ParametersTest, AreToldOfWhenTheyChange) {
  say({{"op", "subscribeParameterUpdates"}, {"parameterNames", {"/world/w/gravity"}}});
  settings_.isPaused = false;
  settings_.gravity = {0, 0, -1};
  world_.reportSettings(settings_);
  EXPECT_EQ(await("parameterValues")["parameters"],
            (json{{{"name", "/world/w/gravity"}, {"value", {0.0, 0.0, -1.0}}, {"type", "float64_array"}}}));
  say({{"op", "unsubscribeParameterUpdates"}, {"parameterNames", json::array()}});
  settings_.gravity = {0, 0, -2};
  world_.reportSettings(settings_);
  for (int i = 0; i < 3; ++i) client_->free();
  for (const std::string& text : client_->takeTexts()) EXPECT_EQ(text.find("parameterValues"), std::string::npos);
  say({{"op", "subscribeParameterUpdates"}, {"parameterNames", {"/world/w/wind"}}});
  EXPECT_EQ(status(), "there is no parameter '/world/w/wind'");
}

TEST_F(ParametersTest, GoWithTheirWorld) {
  world_.end();
  EXPECT_TRUE(answerTo({{"op", "getParameters"}, {"parameterNames", json::array()}})["parameters"].empty());
}

}  // namespace
}  // namespace pongsim::web::foxglove
