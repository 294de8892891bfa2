#include <gtest/gtest.h>

#include <memory>
#include <optional>
#include <stdexcept>
#include <string>
#include <vector>

#include "pongsim/simulation.hh"
#include "pongsim/system.hh"
#include "support/ask_service.hh"

namespace pongsim {
namespace {

constexpr const char* kAddedWorld = R"(<sdf version="1.9"><world name="w">
  <model name="ball"><pose>0 0 100 0 0 0</pose><link name="l"/></model></world></sdf>)";

/// Records its calls in a list that the test keeps.
class NotingSystem : public System {
 public:
  NotingSystem(std::string name, std::vector<std::string>& calls) : name_(std::move(name)), calls_(calls) {}
  void configure(const SystemContext& context) override { note("configure " + std::string(context.world.name())); }
  void preUpdate(const StepInfo&) override { note("preUpdate"); }
  void postUpdate(const StepInfo& info) override {
    note("postUpdate");
    if (info.iteration == failsAt) throw std::runtime_error("as it must");
  }
  void reset() override { note("reset"); }
  void transfer(StateArchive& archive) override { archive(memory); }

  std::uint64_t failsAt = 0;
  int memory = 0;

 private:
  void note(const std::string& what) { calls_.push_back(name_ + " " + what); }
  std::string name_;
  std::vector<std::string>& calls_;
};

class AddedSystemTest : public testing::Test {
 protected:
  void start(const SimulationOptions& options = {}) {
    Diagnostics diagnostics;
    simulation_ = Simulation::fromText(kAddedWorld, "world.sdf", options, diagnostics);
    ASSERT_NE(simulation_, nullptr);
  }
  NotingSystem* add(const std::string& name) {
    auto system = std::make_unique<NotingSystem>(name, calls_);
    NotingSystem* raw = system.get();
    diagnostics_ = Diagnostics();
    return simulation_->addSystem(name, std::move(system), diagnostics_) ? raw : nullptr;
  }
  std::vector<std::string> takeCalls() { return std::exchange(calls_, {}); }

  std::vector<std::string> calls_;
  Diagnostics diagnostics_;
  std::unique_ptr<Simulation> simulation_;
};

TEST_F(AddedSystemTest, IsAloneWhereThePluginsOfFilesDoNotCount) {
  start({.loadSystems = false});
  Diagnostics diagnostics;
  const char* model =
      "<sdf version='1.9'><model name='m'><link name='l'/><plugin filename='nobody' name='nobody'/></model></sdf>";
  EXPECT_TRUE(simulation_->insertText(model, "m.sdf", {}, diagnostics));
}

TEST_F(AddedSystemTest, IsNoPartOfTheStateIfItOnlyWatches) {
  start();
  simulation_->step(3);
  const std::vector<std::byte> before = simulation_->saveState();
  Element plugin;
  plugin.name = "plugin";
  plugin.attributes = {{"filename", "ignition-gazebo-breadcrumbs-system", {}},
                       {"name", "ignition::gazebo::systems::Breadcrumbs", {}}};
  // what can't be used is not there
  EXPECT_FALSE(simulation_->addWatcher(plugin, diagnostics_));
  EXPECT_FALSE(diagnostics_.all().empty());
  plugin.attributes = {{"filename", "ignition-gazebo-imu-system", {}}, {"name", "ignition::gazebo::systems::Imu", {}}};
  diagnostics_ = Diagnostics();
  ASSERT_TRUE(simulation_->addWatcher(plugin, diagnostics_)) << format(diagnostics_.all().front());
  EXPECT_EQ(simulation_->saveState(), before);
  simulation_->step();
  EXPECT_TRUE(simulation_->restoreState(before));
  simulation_->reset(diagnostics_);
  simulation_->step(3);
  EXPECT_EQ(simulation_->saveState(), before);
  EXPECT_TRUE(diagnostics_.all().empty());
}

TEST_F(AddedSystemTest, IsCalledBehindThoseThatAreThereAndStaysThroughAReset) {
  using Calls = std::vector<std::string>;
  start();
  ASSERT_NE(add("b"), nullptr);
  ASSERT_NE(add("a"), nullptr);
  EXPECT_EQ(takeCalls(), (Calls{"b configure w", "a configure w"}));
  simulation_->step();
  EXPECT_EQ(takeCalls(), (Calls{"b preUpdate", "a preUpdate", "b postUpdate", "a postUpdate"}));
  Diagnostics diagnostics;
  simulation_->reset(diagnostics);
  EXPECT_EQ(takeCalls(), (Calls{"b reset", "a reset"}));
  simulation_->step();
  EXPECT_EQ(takeCalls().size(), 4U);
}

TEST_F(AddedSystemTest, IsThereWithoutTheSystemsOfTheFile) {
  start({.loadSystems = false});
  ASSERT_NE(add("a"), nullptr);
  simulation_->step(1000);
  EXPECT_NEAR(simulation_->world().model("ball")->pose().position.z(), 95.1, 0.01);
  EXPECT_EQ(takeCalls().size(), 2001U);
}

/// Keeps its context, which `SystemContext` allows for as long as the system exists.
class KeepingSystem : public System {
 public:
  void configure(const SystemContext& context) override { context_.emplace(context); }
  void preUpdate(const StepInfo&) override {
    seen += context_->sdf.name + " of " + std::string(context_->world.name());
  }
  std::string seen;

 private:
  std::optional<SystemContext> context_;
};

TEST_F(AddedSystemTest, MayKeepItsElement) {
  start();
  auto system = std::make_unique<KeepingSystem>();
  const KeepingSystem& keeper = *system;
  Diagnostics diagnostics;
  ASSERT_TRUE(simulation_->addSystem("keeper", std::move(system), diagnostics));
  simulation_->step();
  EXPECT_EQ(keeper.seen, "plugin of w");
}

TEST_F(AddedSystemTest, ThatHasNoNameOrATakenOneIsRefused) {
  start();
  ASSERT_NE(add("a"), nullptr);
  EXPECT_EQ(add("a"), nullptr);
  ASSERT_EQ(diagnostics_.all().size(), 1U);
  EXPECT_EQ(diagnostics_.all()[0].message, "there is an added system 'a' already");
  EXPECT_EQ(add(""), nullptr);
  takeCalls();
  simulation_->step();
  EXPECT_EQ(takeCalls().size(), 2U);
}

TEST_F(AddedSystemTest, ThatFailsIsSwitchedOffUntilTheReset) {
  start();
  add("a")->failsAt = 2;
  simulation_->step(10);
  EXPECT_EQ(takeCalls().size(), 5U);
  Diagnostics diagnostics;
  simulation_->reset(diagnostics);
  simulation_->step();
  EXPECT_EQ(takeCalls().size(), 3U);
  start({.strict = true});
  add("a")->failsAt = 2;
  EXPECT_THROW(simulation_->step(10), std::runtime_error);
}

TEST_F(AddedSystemTest, HasItsMemoryInASavedState) {
  start();
  const std::vector<std::byte> without = simulation_->saveState();
  NotingSystem* system = add("a");
  system->memory = 7;
  const std::vector<std::byte> state = simulation_->saveState();
  system->memory = 8;
  EXPECT_TRUE(simulation_->restoreState(state));
  EXPECT_EQ(system->memory, 7);
  EXPECT_FALSE(simulation_->restoreState(without)) << "it is not in it";
}

TEST_F(AddedSystemTest, EditsAreOfferedOnceWhereTheyAreAskedFor) {
  start();
  const MessagePointer request = newMessage("Entity");
  ASSERT_FALSE(parseMessage("name: 'ball', type: MODEL", *request).has_value());
  const MessagePointer reply = newMessage("Boolean");
  Node node = simulation_->transport().node();
  EXPECT_FALSE(node.request("/world/w/remove", *request, "ignition.msgs.Boolean", {}));
  simulation_->offerEdits();
  simulation_->offerEdits();
  Diagnostics diagnostics;
  const auto other =
      Simulation::fromText(kAddedWorld, "world.sdf", {.transport = &simulation_->transport()}, diagnostics);
  ASSERT_NE(other, nullptr);
  EXPECT_THROW(other->offerEdits(), std::invalid_argument);
  EXPECT_TRUE(test::askService(simulation_->transport(), "/world/w/remove", *request, *reply));
  EXPECT_FALSE(simulation_->world().model("ball").has_value());
}

}  // namespace
}  // namespace pongsim
