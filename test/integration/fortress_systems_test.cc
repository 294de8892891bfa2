// Worlds of Fortress that only use supported features run strictly, and behave as intended. fortress_systems.txt has
// their commands and expectations, and the reasons why others are left out.

#include <gtest/gtest.h>

#include <algorithm>
#include <cctype>
#include <cstdint>
#include <deque>
#include <filesystem>
#include <fstream>
#include <map>
#include <memory>
#include <ostream>
#include <set>
#include <sstream>
#include <string>
#include <string_view>
#include <vector>

#include "integration/program.hh"
#include "pongsim/message.hh"
#include "pongsim/simulation.hh"
#include "support/environment_variable.hh"
#include "support/fortress_worlds.hh"
#include "support/working_folder.hh"

namespace pongsim::test {
namespace {

namespace fs = std::filesystem;

constexpr double kSeconds = 5;

/// The list's entry for a world.
struct ListedWorld {
  std::string file;
  /// Whether it is run with `--levels`, perhaps in addition.
  bool usesLevels = false;
  /// Why it is left out; empty if it runs.
  std::string reason;
  std::vector<std::string> lines;
};

constexpr std::string_view kLevels = " --levels";

void PrintTo(const ListedWorld& world, std::ostream* stream) {
  *stream << world.file << (world.usesLevels ? kLevels : "");
}

std::vector<ListedWorld> listedWorlds() {
  std::ifstream stream(projectFolder() / "test/integration/fortress_systems.txt");
  std::vector<ListedWorld> worlds;
  for (std::string line; std::getline(stream, line);) {
    if (line.empty() || line.front() == '#') continue;
    if (line.front() == ' ') {
      worlds.back().lines.push_back(line.substr(2));
      continue;
    }
    const std::size_t colon = line.find(": ");
    ListedWorld& world = worlds.emplace_back();
    world.file = line.substr(0, colon);
    world.reason = colon == std::string::npos ? "" : line.substr(colon + 2);
    world.usesLevels = world.file.ends_with(kLevels);
    if (world.usesLevels) world.file.resize(world.file.size() - kLevels.size());
  }
  return worlds;
}

std::vector<ListedWorld> runningWorlds() {
  std::vector<ListedWorld> worlds = listedWorlds();
  std::erase_if(worlds, [](const ListedWorld& world) { return !world.reason.empty(); });
  return worlds;
}

/// Runs one world with the commands and expectations of its entry.
class ListedRun {
 public:
  explicit ListedRun(Simulation& simulation) : simulation_(simulation), node_(simulation.transport().node()) {}

  /// @return Whether the list expects this message for the world.
  static bool isExpected(const ListedWorld& world, const std::string& message) {
    return std::ranges::any_of(world.lines, [&](const std::string& line) {
      return line.starts_with("says ") && message.find(line.substr(5)) != std::string::npos;
    });
  }

  /// Before the run: subscribes, records the positions of models, publishes.
  void prepare(const std::string& line) {
    std::istringstream words(line);
    std::string verb, name, type;
    words >> verb >> name;
    if (verb == "tell") {
      words >> type;
      std::string text;
      std::getline(words, text);
      const MessagePointer message = newMessage(type);
      ASSERT_TRUE(message) << line;
      ASSERT_FALSE(parseMessage(text, *message)) << line;
      publishers_.push_back(node_.advertise(name, type));
      EXPECT_TRUE(publishers_.back().hasSubscribers()) << name << " has no subscriber";
      publishers_.back().publish(*message);
    } else if (verb == "hear") {
      words >> type;
      std::vector<std::string>& heard = heard_[name];
      subscriptions_.push_back(
          node_.subscribe(name, type, [&heard](const Message& message) { heard.push_back(messageJson(message)); }));
    } else if (verb == "moves" || verb == "rests") {
      const auto model = simulation_.world().model(name);
      ASSERT_TRUE(model) << line;
      starts_.emplace(name, model->pose().position);
    } else if (verb == "perform") {
      double x = 0, y = 0;
      words >> x >> y;
      const auto model = simulation_.world().model(name);
      ASSERT_TRUE(model) << line;
      EXPECT_TRUE(Model(*model).setPose({{x, y, model->pose().position.z()}, model->pose().rotation}));
      EXPECT_TRUE(simulation_.addPerformer(name));
    } else if (verb != "says" && verb != "turns" && verb != "there" && verb != "gone" && verb != "writes") {
      FAIL() << "the list says '" << line << "'";
    }
  }

  /// After the run: `hear`, `moves`, `rests`, `turns`, `there`, `gone` and `writes`.
  void check(const std::string& line) {
    std::istringstream words(line);
    std::string verb, name, type, part;
    words >> verb >> name;
    if (verb == "hear") {
      std::size_t least = 0;
      words >> type >> least >> std::ws;
      std::getline(words, part);
      const std::vector<std::string>& heard = heard_[name];
      EXPECT_GE(heard.size(), least) << line;
      const bool isThere =
          std::ranges::any_of(heard, [&](const std::string& each) { return each.find(part) != std::string::npos; });
      EXPECT_TRUE(part.empty() || isThere) << line << "\n" << (heard.empty() ? "" : heard.back());
    } else if (verb == "moves" || verb == "rests") {
      double distance = 0;
      words >> distance;
      const double moved = (simulation_.world().model(name)->pose().position - starts_.at(name)).norm();
      EXPECT_TRUE(verb == "moves" ? moved >= distance : moved <= distance)
          << line << ": it has moved " << moved << " m";
    } else if (verb == "there" || verb == "gone") {
      for (; !name.empty(); name.clear(), words >> name) {
        EXPECT_EQ(simulation_.world().model(name).has_value(), verb == "there") << name;
      }
    } else if (verb == "writes") {
      EXPECT_TRUE(fs::is_regular_file(name)) << line;
    } else if (verb == "turns") {
      std::string joint;
      double position = 0;
      words >> joint >> position;
      EXPECT_NEAR(simulation_.world().model(name)->joint(joint)->position(), position, 0.02) << line;
    }
  }

 private:
  Simulation& simulation_;
  Node node_;
  std::deque<Publisher> publishers_;
  std::deque<Subscription> subscriptions_;
  std::map<std::string, std::vector<std::string>> heard_;
  std::map<std::string, Vector3> starts_;
};

/// Fortress's own tests refer to the folder of their models in this way.
class FortressSystems : public testing::TestWithParam<ListedWorld> {
 protected:
  FortressSystems() {
    if (const auto folder = fortressWorlds()) models_.set((*folder / "test/models").string());
  }

 private:
  test::EnvironmentVariable models_{"IGN_GAZEBO_RESOURCE_PATH"};
  const WorkingFolder workingFolder_;
  // for the files that they write
  const test::EnvironmentVariable home_{"HOME", workingFolder_.path().string()};
};

TEST_P(FortressSystems, RunStrictlyAndDoWhatTheyAreFor) {
  const auto folder = fortressWorlds();
  if (!folder) GTEST_SKIP() << "no worlds of Fortress here";
  Diagnostics diagnostics;
  const auto simulation =
      Simulation::fromFile(*folder / GetParam().file, {.strict = true, .levels = GetParam().usesLevels}, diagnostics);
  for (const Diagnostic& diagnostic : diagnostics.all()) {
    EXPECT_TRUE(ListedRun::isExpected(GetParam(), diagnostic.message)) << format(diagnostic);
  }
  ASSERT_NE(simulation, nullptr);
  ListedRun run(*simulation);
  for (const std::string& line : GetParam().lines) run.prepare(line);
  if (HasFatalFailure()) return;
  simulation->step(static_cast<std::uint64_t>(kSeconds / toSeconds(simulation->stepSize())));
  simulation->transport().dispatch();
  for (const std::string& line : GetParam().lines) run.check(line);
}

std::string nameOf(const testing::TestParamInfo<ListedWorld>& info) {
  std::string name = info.param.file + (info.param.usesLevels ? "_with_levels" : "");
  std::ranges::replace_if(
      name, [](unsigned char letter) { return std::isalnum(letter) == 0; }, '_');
  return name;
}

INSTANTIATE_TEST_SUITE_P(Listed, FortressSystems, testing::ValuesIn(runningWorlds()), nameOf);

TEST(FortressSystemsList, HasEveryWorld) {
  const auto folder = fortressWorlds();
  if (!folder) GTEST_SKIP() << "no worlds of Fortress here";
  std::set<std::string> listed, there;
  for (const ListedWorld& world : listedWorlds()) {
    EXPECT_TRUE(listed.insert(world.file).second || world.usesLevels) << world.file << " is listed twice";
  }
  for (const char* part : {"examples", "test"}) {
    for (const auto& entry : fs::directory_iterator(*folder / part)) {
      if (entry.path().extension() == ".sdf") there.insert(part + ("/" + entry.path().filename().string()));
    }
  }
  EXPECT_EQ(listed, there);
}

TEST(SystemsOfFortress, AreAllKnown) {
  std::set<std::string> later;
  for (const std::string& line : lines(runToEnd({"plugin", "-l", "--later"}).output)) {
    later.insert(line.substr(0, line.find('\t')));
  }
  EXPECT_GT(later.size(), 10U);
  // what is missing is of later releases
  for (const std::string& line : lines(runToEnd({"plugin", "-l", "--missing"}).output)) {
    EXPECT_TRUE(later.contains(line)) << line;
  }
}

}  // namespace
}  // namespace pongsim::test
