#include "rotors.hh"

#include <gtest/gtest.h>

#include <functional>
#include <string>

#include "pongsim/simulation.hh"

namespace pongsim::rotors_test {
namespace {

/// A body that is turned by a quarter and lies beside the model's origin, with a rotor ahead of it that leans by 60
/// degrees.
constexpr const char* kWorld = R"(<sdf version="1.9"><world name="w"><model name="m">
  <link name="body"><pose>1 0 0 0 0 1.5707963267948966</pose></link>
  <link name="rotor"><pose relative_to="body">0.3 0 0.1 0 1.0471975511965976 0</pose></link>
  <joint name="hinge" type="revolute"><parent>body</parent><child>rotor</child><axis><xyz>0 0 1</xyz></axis></joint>
</model></world></sdf>)";

void add(Element& element, const std::string& name, const std::string& text) {
  element.children.emplace_back().name = name;
  element.children.back().text = text;
}

Element configuration(const std::string& joint, const std::string& force, const std::string& moment,
                      const std::string& direction) {
  Element element;
  element.name = "rotorConfiguration";
  Element& rotor = element.children.emplace_back();
  rotor.name = "rotor";
  add(rotor, "jointName", joint);
  add(rotor, "forceConstant", force);
  add(rotor, "momentConstant", moment);
  if (!direction.empty()) add(rotor, "direction", direction);
  return element;
}

TEST(Rotors, AreWhereTheirJointsAre) {
  Diagnostics diagnostics;
  const auto simulation = Simulation::fromText(kWorld, "world.sdf", {}, diagnostics);
  const Model model = simulation->world().model("m").value();
  const auto rotors = readRotors(configuration("hinge", "8e-6", "0.02", "-1"), model, *model.link("body"));
  ASSERT_EQ(rotors.size(), 1U);
  EXPECT_NEAR(rotors[0].x, 0.3, 1e-12);
  EXPECT_NEAR(rotors[0].y, 0, 1e-12);
  EXPECT_NEAR(rotors[0].forceConstant, 4e-6, 1e-12);
  EXPECT_EQ(rotors[0].momentConstant, 0.02);
  EXPECT_EQ(rotors[0].direction, -1);
}

TEST(Rotors, MustBeWhole) {
  Diagnostics diagnostics;
  const auto simulation = Simulation::fromText(kWorld, "world.sdf", {}, diagnostics);
  const Model model = simulation->world().model("m").value();
  const auto refusal = [&](const Element& element) -> std::string {
    try {
      readRotors(element, model, *model.link("body"));
    } catch (const Error& error) {
      return error.diagnostic().message;
    }
    return {};
  };
  EXPECT_EQ(refusal(configuration("knee", "1", "1", "1")), "<jointName> 'knee' is not a joint of model 'm'");
  EXPECT_EQ(refusal(configuration("hinge", "0", "1", "1")), "<forceConstant> must be a number above zero");
  EXPECT_EQ(refusal(configuration("hinge", "1", "-1", "1")), "<momentConstant> must be a number of at least zero");
  EXPECT_EQ(refusal(configuration("hinge", "1", "0", "")), "no <direction> is given");
  EXPECT_EQ(refusal(configuration("hinge", "1", "0", "2")), "<direction> is 2");
}

TEST(Allocation, SaysWhatEachRotorDoes) {
  const Allocation allocation = allocationOf({{0.3, -0.2, 5, 0.1, 1}, {-0.1, 0.4, 2, 0.1, -1}});
  Eigen::Matrix<double, 4, 2> expected;
  expected << -1, 0.8, -1.5, 0.2, -0.5, 0.2, 5, 2;
  EXPECT_TRUE(allocation.isApprox(expected)) << allocation;
}

TEST(Allocation, TellsWhatCanBeControlled) {
  const std::vector<Rotor> square{
      {1, 1, 1e-6, 0.1, 1}, {-1, -1, 1e-6, 0.1, 1}, {1, -1, 1e-6, 0.1, -1}, {-1, 1, 1e-6, 0.1, -1}};
  EXPECT_EQ(rankOf(allocationOf(square)), 4);
  EXPECT_EQ(rankOf(allocationOf({square[0], square[1], square[2]})), 3);
  std::vector<Rotor> oneWay = square;
  for (Rotor& rotor : oneWay) rotor.direction = 1;
  EXPECT_EQ(rankOf(allocationOf(oneWay)), 3);
  EXPECT_EQ(rankOf(allocationOf({})), 0);
}

}  // namespace
}  // namespace pongsim::rotors_test
