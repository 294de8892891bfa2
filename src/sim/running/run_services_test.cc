#include "sim/running/run_services.hh"

#include <gtest/gtest.h>
#include <ignition/msgs/gui.pb.h>

#include <memory>

#include "pongsim/simulation.hh"
#include "support/ask_service.hh"
#include "support/test_domain.hh"

namespace pongsim::sim {
namespace {

TEST(RunServices, TellWhichPanelsTheFileAsksFor) {
  test::testDomain();
  Diagnostics diagnostics;
  const std::unique_ptr<Simulation> simulation = Simulation::fromText(
      "<sdf version='1.9'><world name='w'><gui><plugin filename='WorldStats' name='Stats'><sim_time>1</sim_time>"
      "</plugin></gui></world></sdf>",
      "world.sdf", {.loadSystems = false}, diagnostics);
  ASSERT_NE(simulation, nullptr);
  RunControl control(true);
  RunHistory history(*simulation, true);
  const RunServices services(*simulation, control, history, {});
  ignition::msgs::GUI gui;
  EXPECT_TRUE(test::askService(simulation->transport(), "/world/w/gui/info", *newMessage("Empty"), gui));
  ASSERT_EQ(gui.plugin_size(), 1);
  EXPECT_EQ(gui.plugin(0).filename(), "WorldStats");
  EXPECT_EQ(gui.plugin(0).innerxml(), "<sim_time>1</sim_time>\n");
}

}  // namespace
}  // namespace pongsim::sim
