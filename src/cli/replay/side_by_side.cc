#include "cli/replay/side_by_side.hh"

#include "cli/options/number_option.hh"
#include "sim/api/access.hh"
#include "sim/inputs/inside.hh"
#include "sim/inputs/replay.hh"
#include "sim/inputs/state_values.hh"

namespace pongsim::cli {

namespace {

constexpr std::size_t kMostDifferences = 8;

}  // namespace

std::optional<FirstDifference> compare(Simulation& a, Simulation& b, const sim::Tape& inputs, bool paused,
                                       std::optional<std::uint64_t> until) {
  sim::Replay replayA(inputs, a, paused);
  sim::Replay replayB(inputs, b, paused);
  const sim::Access& accessA = sim::Inside::access(a);
  const sim::Access& accessB = sim::Inside::access(b);
  bool isAsRecorded = true;
  while (true) {
    isAsRecorded = isAsRecorded && replayA.isAsRecorded();
    if (sim::quickHash(accessA) != sim::quickHash(accessB)) {
      FirstDifference found{replayA.steps(), a.time(), {}, isAsRecorded};
      found.lines = differences(sim::StateValues::of(accessA), sim::StateValues::of(accessB), kMostDifferences);
      for (const std::string& what : replayB.missing()) found.lines.push_back("the second lacks " + what);
      return found;
    }
    if (until && replayA.steps() >= *until) return std::nullopt;
    if (!replayA.advance() || !replayB.advance()) return std::nullopt;
  }
}

std::string textOf(const FirstDifference& difference, const std::string& world) {
  std::string text = "world '" + world + "' differs ";
  if (difference.steps == 0) {
    text += "from the start:\n";
  } else {
    text +=
        "from step " + std::to_string(difference.steps) + " on (" + shortNumber(toSeconds(difference.time)) + " s):\n";
  }
  for (const std::string& line : difference.lines) text += "  " + line + "\n";
  return text;
}

}  // namespace pongsim::cli
