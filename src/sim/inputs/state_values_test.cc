#include "sim/inputs/state_values.hh"

#include <gtest/gtest.h>

#include <memory>
#include <string>
#include <vector>

#include "pongsim/simulation.hh"
#include "sim/api/access.hh"
#include "sim/inputs/inside.hh"

namespace pongsim::sim {
namespace {

using Words = std::vector<std::string>;

std::unique_ptr<Simulation> worldOf(const std::string& more = "", const std::string& mass = "1") {
  Diagnostics diagnostics;
  return Simulation::fromText(R"(<sdf version="1.9"><world name="w"><model name="m">
    <link name="base"><inertial><mass>)" +
                                  mass + R"(</mass></inertial></link><link name="arm"/>
    <joint name="hinge" type="revolute"><parent>base</parent><child>arm</child><axis><xyz>0 0 1</xyz></axis></joint>
    </model>)" + more + "</world></sdf>",
                              "world.sdf", {.loadSystems = false}, diagnostics);
}

TEST(StateValues, NamesEachNumberThatDiffers) {
  const auto a = worldOf();
  const auto b = worldOf();
  const Access& accessA = Inside::access(*a);
  EXPECT_EQ(differences(StateValues::of(accessA), StateValues::of(accessA), 8), Words());
  EXPECT_EQ(quickHash(accessA), quickHash(Inside::access(*b)));
  b->world().model("m")->link("arm")->setVelocity({0, 2, 0}, {0, 0, 0.1});
  EXPECT_EQ(differences(StateValues::of(accessA), StateValues::of(Inside::access(*b)), 8),
            (Words{"link 'm::arm', velocity y: 0 and 2", "link 'm::arm', angular velocity z: 0 and 0.1"}));
  EXPECT_EQ(differences(StateValues::of(accessA), StateValues::of(Inside::access(*b)), 1),
            (Words{"link 'm::arm', velocity y: 0 and 2", "and 1 more"}));
  EXPECT_NE(quickHash(accessA), quickHash(Inside::access(*b)));
}

TEST(StateValues, SeesASignOfZero) {
  const auto a = worldOf();
  const auto b = worldOf();
  b->world().model("m")->link("arm")->setVelocity({-0.0, -0.0, 0}, {0, 0, 0});
  EXPECT_EQ(differences(StateValues::of(Inside::access(*a)), StateValues::of(Inside::access(*b)), 1),
            (Words{"link 'm::arm', velocity x: 0 and -0", "and 1 more"}));
  EXPECT_NE(quickHash(Inside::access(*a)), quickHash(Inside::access(*b)));
}

TEST(StateValues, NamesWhatOnlyOneHas) {
  const auto a = worldOf();
  const auto b = worldOf(R"(<model name="n"><link name="l"/></model>)");
  const StateValues valuesA = StateValues::of(Inside::access(*a));
  const StateValues valuesB = StateValues::of(Inside::access(*b));
  EXPECT_EQ(differences(valuesA, valuesB, 8), (Words{"link 'n::l' is only in the second"}));
  EXPECT_EQ(differences(valuesB, valuesA, 8), (Words{"link 'n::l' is only in the first"}));
}

TEST(StateValues, NamesTimeAndSteps) {
  const auto a = worldOf();
  const auto b = worldOf();
  Inside::advance(*b, std::chrono::milliseconds(1));
  const Words found = differences(StateValues::of(Inside::access(*a)), StateValues::of(Inside::access(*b)), 2);
  EXPECT_EQ(found[0], "the world, number of steps: 0 and 1");
  EXPECT_EQ(found[1], "the world, time [ns]: 0 and 1000000");
}

TEST(StateValues, AreTextWithAllDigits) {
  const auto a = worldOf();
  a->world().model("m")->link("arm")->setVelocity({0.1, 1e-300, 0}, {0, 0, 0});
  const std::string text = textOf(StateValues::of(Inside::access(*a)));
  EXPECT_NE(text.find("link m::arm\n  position x: 0\n"), std::string::npos) << text;
  EXPECT_NE(text.find("  velocity x: 0.1\n  velocity y: 1e-300\n"), std::string::npos) << text;
  EXPECT_NE(text.find("joint m::hinge\n  position: 0\n  velocity: 0\n"), std::string::npos) << text;
}

}  // namespace
}  // namespace pongsim::sim
