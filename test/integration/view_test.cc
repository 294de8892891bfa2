#include <gtest/gtest.h>

#include <array>
#include <filesystem>
#include <memory>
#include <string>
#include <utility>
#include <vector>

#include "integration/program.hh"
#include "support/regex.hh"
#include "support/temp_folder.hh"
#include "support/test_domain.hh"

namespace pongsim::test {
namespace {

/// @return Content of a model: a visual whose colour does not depend on light.
std::string flatVisual(const std::string& geometry, const std::string& color) {
  return "<link name='l'><visual name='v'><geometry>" + geometry + "</geometry><material><lighting>false</lighting>" +
         "<ambient>" + color + "</ambient><diffuse>" + color + "</diffuse></material></visual></link>";
}

constexpr const char* kBox = "<box><size>1 1 1</size></box>";
constexpr const char* kRed = "1 0 0 1";
constexpr const char* kGreen = "0 1 0 1";
constexpr const char* kBlue = "0 0 1 1";

/// A black world with a red box in its centre, and a blue square from a file three metres to the right (y = -3).
std::string coloredWorld(const std::string& name) {
  return "<sdf version='1.9'><world name='" + name +
         "'><scene><background>0 0 0 1</background></scene>"
         "<model name='box'><static>true</static>" +
         flatVisual(kBox, kRed) + "</model><model name='square'><static>true</static><pose>0 -3 0 0 0 0</pose>" +
         flatVisual("<mesh><uri>model://shapes/square.obj</uri></mesh>", kBlue) + "</model></world></sdf>";
}

/// Images of a world from ten metres above: x is up, y to the left.
class SeenFromAbove {
 public:
  /// @param arguments Arguments of `view` that select the world.
  explicit SeenFromAbove(std::vector<std::string> arguments) {
    arguments.insert(arguments.begin(), "view");
    arguments.insert(arguments.end(), {"--camera", "0 0 10 0 1.570796 0", "--size", "40x40", "--terminal"});
    outcome_ = runToEnd(arguments);
    static const Regex kBlock("\033\\[38;2;(\\d+);(\\d+);(\\d+)m\033\\[48;2;(\\d+);(\\d+);(\\d+)m");
    for (const std::string& line : lines(outcome_.output)) {
      std::array<std::vector<std::string>, 2> pair;
      for (const Regex::Match& block : kBlock.allIn(line)) {
        for (std::size_t i = 0; i < 2; ++i) {
          const auto number = [&](std::size_t part) { return block[3 * i + part]; };
          pair[i].push_back(number(1) + " " + number(2) + " " + number(3));
        }
      }
      for (std::vector<std::string>& row : pair) rows_.push_back(std::move(row));
    }
  }

  const Outcome& outcome() const { return outcome_; }

  /// @return The colour at a position on the ground, "255 0 0", or "nothing".
  std::string at(double x, double y) const {
    // 60 degrees correspond to the image's width
    const double perMetre = 20 / (10 * 0.57735);
    const auto row = static_cast<std::size_t>(20 - x * perMetre), column = static_cast<std::size_t>(20 - y * perMetre);
    return row < rows_.size() && column < rows_[row].size() ? rows_[row][column] : "nothing";
  }

 private:
  Outcome outcome_;
  std::vector<std::vector<std::string>> rows_;
};

TEST(View, IsDrawnByTheRendererThatIsChosen) {
  const TempFolder folder;
  const auto file = folder.write("w.sdf",
                                 "<sdf version='1.9'><world name='w'><scene><background>0 0 0 1</background></scene>"
                                 "<model name='box'><static>true</static>" +
                                     flatVisual(kBox, kRed) + "</model></world></sdf>");
  const SeenFromAbove software({file.string()});
  if (software.outcome().error.find("libOSMesa") != std::string::npos) GTEST_SKIP() << software.outcome().error;
  for (const std::string renderer : {"software", "auto", "egl"}) {
    const SeenFromAbove seen({file.string(), "--renderer", renderer});
    const auto said = [&seen](const char* text) { return seen.outcome().error.find(text) != std::string::npos; };
    // without libegl1, or without a driver that works
    if (renderer == "egl" && said("; the renderer 'auto' would draw in software")) continue;
    EXPECT_EQ(seen.outcome().exitCode, 0) << seen.outcome().error;
    EXPECT_EQ(seen.outcome().error, "");
    EXPECT_EQ(seen.at(0, 0), "255 0 0");
    EXPECT_EQ(seen.at(0, 3), "0 0 0");
  }
  const Outcome refused = runToEnd({"view", file.string(), "--renderer", "gpu"});
  EXPECT_EQ(refused.exitCode, 2);
  EXPECT_NE(refused.error.find("option '--renderer' takes auto, software or egl, not 'gpu'"), std::string::npos)
      << refused.error;
}

class ViewOfARunningWorld : public testing::Test {
 protected:
  void SetUp() override {
    folder_.write("models/shapes/square.obj",
                  "v -0.5 -0.5 0\nv 0.5 -0.5 0\nv 0.5 0.5 0\nv -0.5 0.5 0\nf 1 2 3\nf 1 3 4\n");
    const Outcome picture =
        runToEnd({"view", folder_.write("empty.sdf", "<sdf version='1.9'><world name='e'/></sdf>").string(), "-o",
                  (folder_.path() / "e.png").string()});
    if (picture.error.find("libOSMesa") != std::string::npos) GTEST_SKIP() << picture.error;
  }

  /// Runs the world, paused, until its services are there.
  std::unique_ptr<Process> runColoredWorld(const std::string& name) {
    const auto file = folder_.write(name + ".sdf", coloredWorld(name));
    testDomain();
    auto process = std::make_unique<Process>(
        std::vector<std::string>{PONGSIM_PROGRAM, "run", file.string(), "--paused"},
        Process::Options{.environment = {{"PONGSIM_RESOURCE_PATH", (folder_.path() / "models").string()}},
                         .folder = {}});
    EXPECT_TRUE(process->waitForError("pongsim: world '")) << process->error();
    EXPECT_EQ(runToEnd({"service", "-s", "/world/" + name + "/scene/info", "--req", "", "--timeout", "60000"}).exitCode,
              0);
    return process;
  }

  TempFolder folder_;
};

TEST_F(ViewOfARunningWorld, ShowsWhatIsThereNow) {
  const auto world = runColoredWorld("w");
  const SeenFromAbove before({"--timeout", "60000"});
  ASSERT_EQ(before.outcome().exitCode, 0) << before.outcome().error;
  EXPECT_EQ(before.outcome().error, "");
  EXPECT_EQ(before.at(0, 0), "255 0 0");
  EXPECT_EQ(before.at(0, -3), "0 0 255");
  EXPECT_EQ(before.at(0, 3), "0 0 0");

  const std::string ball = "<sdf version='1.9'><model name='ball'><static>true</static><pose>0 3 0 0 0 0</pose>" +
                           flatVisual("<sphere><radius>0.6</radius></sphere>", kGreen) + "</model></sdf>";
  const auto ask = [](const std::string& service, const std::string& request) {
    const Outcome call = runToEnd({"service", "-s", "/world/w/" + service, "--req", request, "--timeout", "60000"});
    EXPECT_EQ(call.exitCode, 0) << call.error;
  };
  ask("create", "sdf: \"" + ball + "\"");
  ask("set_pose", "name: 'box', position: {x: 3}");
  const SeenFromAbove after({"-w", "w", "--timeout", "60000"});
  ASSERT_EQ(after.outcome().exitCode, 0) << after.outcome().error;
  EXPECT_EQ(after.at(0, 0), "0 0 0");
  EXPECT_EQ(after.at(3, 0), "255 0 0");
  EXPECT_EQ(after.at(0, 3), "0 255 0");
  EXPECT_EQ(after.at(0, -3), "0 0 255");
}

TEST_F(ViewOfARunningWorld, SaysWhichFilesAreNotHere) {
  const auto world = runColoredWorld("w");
  const auto mesh = folder_.path() / "models/shapes/square.obj";
  std::filesystem::remove(mesh);
  const SeenFromAbove seen({"--timeout", "60000"});
  EXPECT_EQ(seen.outcome().exitCode, 0) << seen.outcome().error;
  EXPECT_NE(seen.outcome().error.find("warning: mesh '" + mesh.string() + "' is not on this machine"),
            std::string::npos)
      << seen.outcome().error;
  EXPECT_NE(seen.outcome().error.find("hint: "), std::string::npos);
  EXPECT_EQ(seen.at(0, 0), "255 0 0");
  EXPECT_EQ(seen.at(0, -3), "0 0 0");
}

TEST_F(ViewOfARunningWorld, LooksAtOneOfItsModels) {
  const auto world = runColoredWorld("w");
  const std::string picture = (folder_.path() / "box.png").string();
  const Outcome seen = runToEnd({"view", "--camera", "box", "-o", picture, "--timeout", "60000"});
  EXPECT_EQ(seen.exitCode, 0) << seen.error;
  EXPECT_TRUE(std::filesystem::exists(picture));
  const Outcome wrong = runToEnd({"view", "--camera", "bax", "--timeout", "60000"});
  EXPECT_EQ(wrong.exitCode, 1);
  EXPECT_EQ(wrong.error, "pongsim: error: there is no model or actor 'bax' to look at\n  hint: did you mean 'box'?\n");
}

TEST_F(ViewOfARunningWorld, KnowsActorsByName) {
  const auto file = folder_.write(
      "w.sdf",
      "<sdf version='1.9'><world name='w'><scene><background>0 0 0 1</background></scene><actor name='walker'>" +
          flatVisual(kBox, kGreen) +
          "<script><trajectory id='0' type='walk'><waypoint><time>0</time><pose>90 40 0 0 0 "
          "0</pose></waypoint><waypoint>"
          "<time>9</time><pose>99 40 0 0 0 0</pose></waypoint></trajectory></script></actor></world></sdf>");
  testDomain();
  Process world({PONGSIM_PROGRAM, "run", file.string(), "--paused"});
  ASSERT_TRUE(world.waitForError("pongsim: world '")) << world.error();
  std::string pictures[2];
  for (const bool isNamed : {false, true}) {
    const auto picture = [isNamed](std::vector<std::string> arguments) {
      arguments.insert(arguments.begin(), "view");
      arguments.insert(arguments.end(), {"--camera", "walker", "--size", "60x40", "--terminal"});
      if (isNamed) arguments.emplace_back("--names");
      const Outcome seen = runToEnd(arguments);
      EXPECT_EQ(seen.exitCode, 0) << seen.error;
      return seen.output;
    };
    pictures[isNamed ? 1 : 0] = picture({file.string()});
    EXPECT_EQ(picture({"--timeout", "60000"}), pictures[isNamed ? 1 : 0]);
  }
  // it fills the image, with its name above it
  EXPECT_NE(pictures[0].find("\033[38;2;0;255;0m"), std::string::npos);
  EXPECT_EQ(pictures[0].find("\033[38;2;255;255;255m"), std::string::npos);
  EXPECT_NE(pictures[1].find("\033[38;2;255;255;255m"), std::string::npos);
}

TEST_F(ViewOfARunningWorld, WantsToKnowWhichOne) {
  const Outcome none = runToEnd({"view", "--timeout", "0"});
  EXPECT_EQ(none.exitCode, 1);
  EXPECT_EQ(none.error, "pongsim: error: no world is running\n  hint: start one with pongsim run WORLD\n");
  const auto first = runColoredWorld("w"), second = runColoredWorld("v");
  const Outcome either = runToEnd({"view", "--timeout", "60000"});
  EXPECT_EQ(either.exitCode, 1);
  EXPECT_TRUE(either.error.starts_with("pongsim: error: several worlds are running: ")) << either.error;
  EXPECT_NE(either.error.find("hint: choose with -w WORLD"), std::string::npos) << either.error;
  EXPECT_EQ(SeenFromAbove({"-w", "v", "--timeout", "60000"}).at(0, 0), "255 0 0");
}

TEST_F(ViewOfARunningWorld, IsThatOfItsFileWhereNothingHasMoved) {
  const auto world = startServedWorld("pong_lidar.sdf", {"--paused"});
  const auto picture = [](std::vector<std::string> which) {
    which.insert(which.begin(), "view");
    which.insert(which.end(), {"--size", "64x48", "--terminal"});
    const Outcome outcome = runToEnd(which);
    EXPECT_EQ(outcome.exitCode, 0) << outcome.error;
    return outcome.output;
  };
  EXPECT_EQ(picture({"--timeout", "60000"}), picture({ownWorld("pong_lidar.sdf")}));
}

}  // namespace
}  // namespace pongsim::test
