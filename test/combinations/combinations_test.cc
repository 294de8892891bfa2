// Walks through combinations: every kind of entity, sensor and system, each operation after each other, alone and with
// the optional components or a second world.

#include <gtest/gtest.h>

#include <unistd.h>
#include <cstdlib>
#include <filesystem>
#include <iostream>
#include <memory>
#include <ostream>
#include <string>
#include <utility>
#include <vector>

#include "combinations/kinds.hh"
#include "combinations/operation.hh"
#include "combinations/walk.hh"
#include "pongsim/log.hh"
#include "pongsim/program/log_sink.hh"
#include "pongsim/simulation.hh"
#include "support/temp_folder.hh"
#include "support/test_domain.hh"
#include "support/working_folder.hh"

namespace pongsim::test {

void PrintTo(const Kind& kind, std::ostream* out) { *out << kind.name; }

namespace {

std::string documentOf(const std::string& worlds) { return "<sdf version='1.9'>" + worlds + "</sdf>"; }

Element pluginOf(const std::string& filename, const std::string& className,
                 const std::vector<std::pair<std::string, std::string>>& parameters) {
  Element plugin;
  plugin.name = "plugin";
  plugin.attributes = {{"filename", filename, {}}, {"name", className, {}}};
  for (const auto& [name, value] : parameters) {
    Element& child = plugin.children.emplace_back();
    child.name = name;
    child.text = value;
  }
  return plugin;
}

/// Its mistakes end a run before it begins.
constexpr const char* kFaults = "faults_system";

class Combinations : public testing::TestWithParam<Kind> {
 protected:
  static void SetUpTestSuite() {
    setLogLevel(LogLevel::kError);
    setenv("IGN_PARTITION", ("combinations_test_" + std::to_string(getpid())).c_str(), 1);
    setenv("IGN_IP", "127.0.0.1", 1);
  }

  static void walk(Walk& walk, const std::vector<Operation>& operations) {
    for (const Operation operation : operations) {
      // shows where a crash was
      std::cout << nameOf(operation) << "; " << std::flush;
      walk.make(operation);
      if (HasFailure()) return;
    }
    std::cout << std::endl;
  }

  /// @return What `--record --ros2 --web --ign` add to a world, where these components are built.
  std::vector<Element> optionalSystems() const {
    std::vector<Element> systems;
#ifdef HAS_LOG
    systems.push_back(pluginOf("pongsim-log-system", "ignition::gazebo::systems::LogRecord",
                               {{"record_path", (files_.path() / "recording").string()}, {"record_topic", ".*"}}));
#endif
#ifdef HAS_ROS2
    systems.push_back(pluginOf("pongsim-ros2-system", "pongsim::systems::Ros2",
                               {{"domain", std::to_string(testDomain())}, {"distro", "humble"}}));
#endif
#ifdef HAS_WEB
    systems.push_back(pluginOf("pongsim-web-system", "pongsim::systems::Web", {{"port", "0"}}));
#endif
#ifdef HAS_IGN
    systems.push_back(pluginOf("pongsim-ign-system", "pongsim::systems::Ign", {}));
#endif
    return systems;
  }

  std::unique_ptr<Simulation> load(bool withModels, std::vector<Element> systems = {}) const {
    Diagnostics diagnostics;
    const auto file = files_.write("world.sdf", documentOf(kind().worldText(withModels, kind().world)));
    auto simulation = Simulation::fromFile(
        file, {.seed = 3, .strict = true, .levels = true, .systems = std::move(systems)}, diagnostics);
    for (const Diagnostic& diagnostic : diagnostics.all()) {
      if (withModels || diagnostic.severity == Severity::kError) ADD_FAILURE() << format(diagnostic);
    }
    return simulation;
  }

  static const Kind& kind() { return GetParam(); }

  const TempFolder files_;
  /// For systems that write files.
  const WorkingFolder folder_;
};

TEST_P(Combinations, OfEachOperationAfterEach) {
  const auto simulation = load(true);
  ASSERT_NE(simulation, nullptr);
  Walk walked(kind(), *simulation);
  walk(walked, allPairs());
  walked.expectReadings();
  EXPECT_TRUE(simulation->finish());
}

TEST_P(Combinations, OfThreeOperationsAfterAReset) {
  const auto simulation = load(true);
  ASSERT_NE(simulation, nullptr);
  Walk walked(kind(), *simulation);
  walk(walked, {Operation::kListen});
  walk(walked, allTriples());
}

TEST_P(Combinations, InAWorldThatWasEmpty) {
  if (kind().name == kFaults) GTEST_SKIP() << "the joints that faults name must be there when the world is loaded";
  const auto simulation = load(false);
  ASSERT_NE(simulation, nullptr);
  Walk walked(kind(), *simulation);
  walk(walked, allPairs());
}

TEST_P(Combinations, WithTheOptionalComponents) {
  const auto simulation = load(true, optionalSystems());
  ASSERT_NE(simulation, nullptr);
  Walk walked(kind(), *simulation);
  walk(walked, allPairs());
  const Outcome<void> finished = simulation->finish();
  EXPECT_TRUE(finished) << finished.error;
}

TEST_P(Combinations, BesideASecondWorld) {
  if (kind().name == kFaults) GTEST_SKIP() << "a topic can have the faults of one world only";
  Diagnostics diagnostics;
  Transport transport({.network = false});
  auto worlds = Simulation::allFromFile(
      files_.write("worlds.sdf", documentOf(kind().worldText(true, "one") + kind().worldText(true, "two"))),
      {.seed = 3, .strict = true, .levels = true, .transport = &transport}, diagnostics);
  ASSERT_EQ(worlds.size(), 2U) << (diagnostics.all().empty() ? "" : format(diagnostics.all().front()));
  {
    Walk walked(kind(), *worlds[1], {worlds[0].get()});
    walk(walked, allPairs());
  }
  // one goes on without the other
  worlds.pop_back();
  worlds[0]->step(3);
  EXPECT_GT(worlds[0]->iterations(), 3U);
}

INSTANTIATE_TEST_SUITE_P(Of, Combinations, testing::ValuesIn(allKinds()),
                         [](const auto& parameter) { return parameter.param.name; });

}  // namespace
}  // namespace pongsim::test
