// All systems are bit-for-bit reproducible: after a reset, from a saved state, and with any subscribers. Each runs in
// the example world of its folder, with the commands in that world's comment.

#include <gtest/gtest.h>

#include <algorithm>
#include <chrono>
#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <memory>
#include <ostream>
#include <string>
#include <utility>
#include <vector>

#include "pongsim/message.hh"
#include "pongsim/simulation.hh"
#include "support/fortress_worlds.hh"
#include "support/regex.hh"
#include "support/working_folder.hh"

namespace pongsim::test {
namespace {

namespace fs = std::filesystem;

/// A step at which the systems are executing the commands, and the last one.
constexpr std::uint64_t kHalf = 300, kEnd = 600;

struct Command {
  std::string topic, type, text;
};

/// @return The commands `pongsim topic -t TOPIC -m TYPE -p "TEXT"` in a world's comment.
std::vector<Command> commandsIn(const fs::path& file) {
  std::ifstream stream(file);
  const std::string text{std::istreambuf_iterator<char>(stream), {}};
  const Regex command(R"re(pongsim topic -t (\S+) -m (\S+) -p "([^"]*)")re");
  std::vector<Command> commands;
  for (const Regex::Match& match : command.allIn(text)) commands.push_back({match[1], match[2], match[3]});
  return commands;
}

/// @return The topics that a world's systems publish, with their types, except scene messages, which depend on
/// subscribers and changes instead of steps.
std::vector<std::pair<std::string, std::string>> topicsOf(const fs::path& file) {
  Diagnostics diagnostics;
  const auto simulation = Simulation::fromFile(file, {}, diagnostics);
  std::vector<std::pair<std::string, std::string>> topics;
  for (const OwnTopic& topic : simulation->transport().node().ownTopics()) {
    if (topic.publishers > 0 && !topic.name.ends_with("/scene/info")) topics.emplace_back(topic.name, topic.type);
  }
  return topics;
}

/// A world that receives its commands, and whose messages are recorded.
class Recorder {
 public:
  explicit Recorder(const fs::path& file) : commands_(commandsIn(file)), topics_(topicsOf(file)) {
    Diagnostics diagnostics;
    simulation_ = Simulation::fromFile(file, {.seed = 3}, diagnostics);
    for (const Diagnostic& diagnostic : diagnostics.all()) ADD_FAILURE() << format(diagnostic);
  }

  Simulation& simulation() { return *simulation_; }
  std::vector<std::string> modelNames() {
    std::vector<std::string> names;
    for (const Model& model : simulation_->world().models()) names.emplace_back(model.name());
    return names;
  }

  void listen() {
    for (const auto& [name, type] : topics_) {
      subscriptions_.push_back(simulation_->transport().node().subscribe(
          name, type,
          [this, name = name](const Message& message) { messages_.push_back(name + ": " + messageText(message)); }));
    }
  }

  /// @return What is published from now on until `step`.
  std::vector<std::string> stepTo(std::uint64_t step) {
    messages_.clear();
    while (simulation_->iterations() < step) {
      // one after another, because some belong together
      const std::uint64_t now = simulation_->iterations();
      if (now % 50 == 0 && now > 0 && now / 50 <= commands_.size()) tell(commands_[now / 50 - 1]);
      simulation_->step(1);
    }
    // messages in transit are not part of a saved state; those that systems send in reply are in transit again
    for (int i = 0; i < 10 && simulation_->transport().dispatch() > 0; ++i) {
    }
    messages_.push_back("state " + std::to_string(simulation_->stateHash()));
    return std::exchange(messages_, {});
  }

  void reset() {
    Diagnostics diagnostics;
    simulation_->reset(diagnostics);
    for (const Diagnostic& diagnostic : diagnostics.all()) ADD_FAILURE() << format(diagnostic);
    // messages about the reset itself
    simulation_->transport().dispatch();
  }

 private:
  void tell(const Command& command) {
    publishers_.push_back(simulation_->transport().node().advertise(command.topic, command.type));
    const MessagePointer message = newMessage(command.type);
    ASSERT_FALSE(parseMessage(command.text, *message)) << command.text;
    publishers_.back().publish(*message);
  }

  std::vector<Command> commands_;
  std::vector<std::pair<std::string, std::string>> topics_;
  std::unique_ptr<Simulation> simulation_;
  std::vector<Subscription> subscriptions_;
  std::vector<Publisher> publishers_;
  std::vector<std::string> messages_;
};

void expectSame(const std::vector<std::string>& found, const std::vector<std::string>& expected,
                const std::string& when) {
  const auto [one, other] = std::ranges::mismatch(found, expected);
  if (one != found.end() && other != expected.end()) {
    FAIL() << when << ", message " << one - found.begin() << "\n" << *one << "\nin place of\n" << *other;
  }
  EXPECT_EQ(found.size(), expected.size()) << when;
}

std::vector<std::string> systemWorlds() {
  const fs::path plugins = projectFolder() / "plugins";
  std::vector<std::string> files;
  for (const auto& file : fs::recursive_directory_iterator(plugins)) {
    if (file.path().extension() == ".sdf") files.push_back(file.path().lexically_relative(plugins).string());
  }
  std::ranges::sort(files);
  return files;
}

TEST(SystemWorlds, AreFound) { EXPECT_GT(systemWorlds().size(), 20U); }

class SystemState : public testing::TestWithParam<std::string> {};

TEST_P(SystemState, RepeatsToTheBit) {
  const WorkingFolder folder;
  const fs::path file = projectFolder() / "plugins" / GetParam();
  Recorder recorder(file);
  recorder.listen();
  const std::vector<std::string> first = recorder.stepTo(kHalf);
  const std::vector<std::byte> state = recorder.simulation().saveState();
  const std::vector<std::string> before = recorder.modelNames();
  const std::vector<std::string> second = recorder.stepTo(kEnd);

  if (recorder.modelNames() == before) {
    EXPECT_TRUE(recorder.simulation().restoreState(state));
    expectSame(recorder.stepTo(kEnd), second, "from a saved state");
    recorder.reset();
    expectSame(recorder.stepTo(kHalf), first, "after a reset");
    expectSame(recorder.stepTo(kEnd), second, "later after a reset");
  } else {
    // models inserted meanwhile are not part of a saved state, and get other ids when they are inserted again
    EXPECT_FALSE(recorder.simulation().restoreState(state));
    recorder.reset();
    EXPECT_EQ(recorder.stepTo(kHalf).back(), first.back()) << "after a reset";
    EXPECT_EQ(recorder.stepTo(kEnd).back(), second.back()) << "later after a reset";
  }

  Recorder lateListener(file);
  lateListener.stepTo(kHalf);
  lateListener.listen();
  expectSame(lateListener.stepTo(kEnd), second, "to one who listens late");
}

INSTANTIATE_TEST_SUITE_P(Worlds, SystemState, testing::ValuesIn(systemWorlds()), [](const auto& parameter) {
  std::string name = fs::path(parameter.param).stem().string();
  std::erase(name, '_');
  return name;
});

}  // namespace
}  // namespace pongsim::test
