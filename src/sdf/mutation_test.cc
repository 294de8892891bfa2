#include <algorithm>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <random>

#include "support/fortress_worlds.hh"
#include "support/sdf/load_support.hh"
#include "support/temp_folder.hh"

namespace pongsim::sdf::test {
namespace {

/// A made-up world with elements of each kind.
constexpr std::string_view kSample = R"(<?xml version="1.0"?>
<!-- a -- comment --><sdf version="1.8"><world name="w"><physics name="p" default="1">
<max_step_size>0.001</max_step_size></physics><gravity>0 0 -9.8</gravity><light name="sun" type="directional">
<pose relative_to="f">0 0 10 0 0 0</pose></light>
<frame name="f" attached_to="m::i"><pose degrees="true">1 2 3 10 20 30</pose></frame>
<model name="m" canonical_link="a" placement_frame="g"><pose rotation_format="quat_xyzw">0 0 0 0 0 0 1</pose>
<frame name="g" attached_to="i::x"/><link name="a"><inertial><mass>2</mass><inertia><ixx>1</ixx><iyy>1</iyy><izz>1</izz>
<ixy>0.1</ixy></inertia></inertial><collision name="c"><pose relative_to="g"/><geometry><box><size>1 2 3</size></box>
</geometry><surface><friction><ode><mu>1</mu></ode></friction></surface></collision><visual name="v"><geometry><plane>
<normal>0 0 1</normal><size>1 1</size></plane></geometry></visual><sensor name="s" type="imu"/></link>
<model name="i"><link name="x"><pose>1 0 0 0 0 0</pose></link></model><joint name="j" type="revolute">
<pose relative_to="g"/><parent>a</parent><child>i::x</child><axis><xyz expressed_in="__model__">0 1 0</xyz>
<limit><lower>-1e16</lower>
<upper>1.79769e+308</upper></limit></axis></joint><plugin filename="f.so" name="n"><![CDATA[<x>]]> a &amp; b</plugin>
</model></world></sdf>)";

/// The same as a URDF robot.
constexpr std::string_view kMutatedRobot =
    R"(<robot name="r"><origin xyz="0 0 1"/><material name="m"><color rgba="1 0 0 1"/>
</material><link name="a"><inertial><origin xyz="1 0 0" rpy="0 1 0"/><mass value="2"/>
<inertia ixx="1" ixy="0.1" ixz="0" iyy="1" iyz="0" izz="1"/></inertial><visual><geometry><box size="1 2 3"/></geometry>
<material name="m"/></visual></link><link name="b"><inertial><mass value="2"/>
<inertia ixx="1" ixy="0" ixz="0" iyy="1" iyz="0" izz="1"/></inertial><collision name="c"><geometry>
<cylinder radius="1" length="2"/></geometry></collision></link><link name="c"/><link name="world"/>
<joint name="w" type="fixed"><parent link="world"/><child link="a"/></joint>
<joint name="j" type="revolute"><parent link="a"/><child link="b"/><axis xyz="0 1 0"/><limit lower="-1" upper="1"
effort="1" velocity="1"/><mimic joint="k"/></joint><joint name="k" type="fixed"><parent link="b"/><child link="c"/></joint>
<gazebo reference="c"><mu1>1</mu1><sensor name="s" type="imu"><pose>0 0 1 0 0 0</pose></sensor></gazebo>
<gazebo><plugin filename="f" name="n"/></gazebo></robot>)";

/// Changes, swaps, cuts and repeats parts of `text`.
std::string mutated(std::string text, std::mt19937& random) {
  constexpr std::string_view kInteresting = "<>/\"'=&!-?[]: \n\t0123456789.eE+-nainf_ab\xC3\xFF";
  const auto below = [&](std::size_t limit) { return random() % std::max<std::size_t>(limit, 1); };
  for (std::size_t count = 1 + below(4); count > 0 && !text.empty(); --count) {
    const std::size_t at = below(text.size());
    const std::size_t length = below(40);
    switch (below(6)) {
      case 0:
        text[at] = kInteresting[below(kInteresting.size())];
        break;
      case 1:
        text[at] = static_cast<char>(random() & 0xFFU);
        break;
      case 2:
        text.erase(at, length);
        break;
      case 3:
        text.insert(at, text.substr(below(text.size()), length));
        break;
      case 4:
        text.replace(at, length, text.substr(below(text.size()), length));
        break;
      default:
        if (below(4) == 0) text.resize(at);
        break;
    }
  }
  return text;
}

/// Loads mutations of `text`. Each must load, or cause an error with a position.
void loadMutations(const std::string& text, int count, std::mt19937& random) {
  for (int i = 0; i < count; ++i) {
    const std::string mutation = mutated(text, random);
    Diagnostics diagnostics;
    const Root root = loadText(mutation, "m.sdf", diagnostics);
    const bool isFilled = !root.worlds.empty() || !root.models.empty() || !root.lights.empty();
    ASSERT_TRUE(diagnostics.hasErrors() || isFilled) << mutation;
    for (const Diagnostic& diagnostic : diagnostics.all()) ASSERT_FALSE(format(diagnostic).empty());
  }
}

TEST(Mutation, OfASampleIsLoadedOrRefused) {
  std::mt19937 random(1);
  const Loaded sound = load(kSample);
  EXPECT_EQ(sound.messages, Messages());
  loadMutations(std::string(kSample), 3000, random);
}

TEST(Mutation, OfARobotIsLoadedOrRefused) {
  std::mt19937 random(4);
  EXPECT_EQ(load(kMutatedRobot).messages,
            Messages{"t.sdf:9:26: warning: joint 'j' mimics 'k', which is not a joint of its model: it moves freely"});
  loadMutations(std::string(kMutatedRobot), 3000, random);
}

TEST(Mutation, OfFortressWorldsIsLoadedOrRefused) {
  const auto folder = pongsim::test::fortressWorlds();
  if (!folder) GTEST_SKIP() << "Fortress's worlds are not there";
  std::mt19937 random(2);
  for (const char* name :
       {"tutorials/moving_robot.sdf", "tutorials/sensor_tutorial.sdf", "examples/triggered_publisher.sdf"}) {
    std::ifstream stream(*folder / name, std::ios::binary);
    const std::string text((std::istreambuf_iterator<char>(stream)), std::istreambuf_iterator<char>());
    ASSERT_FALSE(text.empty()) << name;
    loadMutations(text, 200, random);
  }
}

TEST(Mutation, OfIncludedFilesIsLoadedOrRefused) {
  std::mt19937 random(3);
  const pongsim::test::TempFolder folder;
  const assets::Finder finder = assets::finderIn({{folder.path()}, {}});
  const std::vector<std::pair<std::string, std::string>> files = {
      {"w.sdf",
       "<sdf version='1.9'><world name='w'><include><uri>model://a</uri><name>n</name><pose>1 0 0 0 0 0</pose>"
       "<placement_frame>l</placement_frame><static>0</static><plugin filename='f' name='n'/></include>"
       "<include><uri>a/model.sdf</uri></include></world></sdf>"},
      {"a/model.config", "<?xml version='1.0'?><model><name>a</name><sdf version='1.9'>model.sdf</sdf></model>"},
      {"a/model.sdf",
       "<sdf version='1.8'><model name='a'><link name='l'/><include merge='true'><uri>b.sdf</uri><pose>0 0 1 0 0 0"
       "</pose></include><include><uri>../a/b.sdf</uri></include></model></sdf>"},
      {"a/b.sdf",
       "<sdf version='1.6'><model name='b'><link name='x'/><link name='y'/><joint name='j' type='revolute'>"
       "<parent>x</parent><child>y</child><axis><xyz expressed_in='__model__'>0 0 "
       "1</xyz></axis></joint></model></sdf>"}};
  for (const auto& [name, text] : files) folder.write(name, text);
  Diagnostics none;
  loadFile(folder.path() / "w.sdf", none, finder);
  for (const Diagnostic& diagnostic : none.all()) ADD_FAILURE() << format(diagnostic);

  for (const auto& [name, text] : files) {
    for (int i = 0; i < 250; ++i) {
      const std::string mutation = mutated(text, random);
      folder.write(name, mutation);
      Diagnostics diagnostics;
      const Root root = loadFile(folder.path() / "w.sdf", diagnostics, finder);
      const bool isFilled = !root.worlds.empty() || !root.models.empty() || !root.lights.empty();
      ASSERT_TRUE(diagnostics.hasErrors() || isFilled) << name << ": " << mutation;
      for (const Diagnostic& diagnostic : diagnostics.all()) ASSERT_FALSE(format(diagnostic).empty());
    }
    folder.write(name, text);
  }
}

}  // namespace
}  // namespace pongsim::sdf::test
