#include <algorithm>
#include <chrono>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "base/nearest_word.hh"
#include "cli/model/model_command.hh"
#include "cli/stop_signal.hh"
#include "cli/world/world_finder.hh"
#include "cli/world/world_state.hh"
#include "msgs/state/state_reader.hh"
#include "pongsim/node.hh"
#include "shared/program/console.hh"

namespace pongsim::cli {

namespace {

using Kind = msgs::EntityState::Kind;

/// Period of --follow.
constexpr std::chrono::milliseconds kFollowPeriod{100};

std::string hintFor(const std::string& name, const std::vector<std::string>& known) {
  return base::didYouMean(name, std::vector<std::string_view>(known.begin(), known.end()));
}

class ModelQuery {
 public:
  explicit ModelQuery(const ModelOptions& options) : options_(options) {}
  int run();

 private:
  std::optional<ModelTeller> ask();
  std::optional<int> show(const ModelTeller& teller);
  bool hasParts(const ModelTeller& teller, std::uint64_t model);
  void waitUntil(std::chrono::steady_clock::time_point time);

  const ModelOptions& options_;
  // before the transport, whose threads inherit the signal mask
  StopSignal signal_;
  Transport transport_;
  std::string world_;
};

int ModelQuery::run() {
  const std::optional<std::string> world =
      findWorld(transport_, signal_, options_.world, options_.timeout, WorldChoice::kFirst);
  if (!world) return kFailed;
  world_ = *world;
  if (options_.namesWorld && !print("\nRequesting state for world [" + world_ + "]...\n\n")) return kFailed;
  const StopSignal::Callback wake(signal_, [this] { transport_.wake(); });
  std::optional<int> code;
  auto next = std::chrono::steady_clock::now();
  for (std::uint64_t shown = 0; !code && !signal_.stopped();) {
    const std::optional<ModelTeller> teller = ask();
    code = teller ? show(*teller) : std::optional(kFailed);
    if (code || !options_.follows || ++shown == options_.count) break;
    next += kFollowPeriod;
    waitUntil(next);
  }
  return code.value_or(kDone);
}

void ModelQuery::waitUntil(std::chrono::steady_clock::time_point time) {
  for (auto now = std::chrono::steady_clock::now(); now < time && !signal_.stopped();
       now = std::chrono::steady_clock::now()) {
    transport_.dispatchFor(time - now);
  }
}

std::optional<ModelTeller> ModelQuery::ask() {
  const MessagePointer state = askForState(transport_, world_, options_.timeout);
  if (state == nullptr) return std::nullopt;
  return ModelTeller(msgs::entitiesOf(*state));
}

/// @return The exit code, if that was the last one.
std::optional<int> ModelQuery::show(const ModelTeller& teller) {
  std::string text;
  if (options_.model.empty()) {
    text = options_.json ? teller.listJson() : teller.listText();
  } else {
    const std::optional<std::uint64_t> model = teller.find(options_.model);
    if (!model) {
      return fail("world '" + world_ + "' has no model '" + options_.model + "'",
                  hintFor(options_.model, teller.models()));
    }
    if (!hasParts(teller, *model)) return kFailed;
    text = options_.json ? teller.json(*model, options_.parts) : teller.text(*model, options_.parts);
    if (options_.follows && !options_.json) text += "\n";
  }
  if (print(text)) return std::nullopt;
  return outputIsClosed() ? kDone : kFailed;
}

/// @return Whether the model has the requested link, joint and sensor; reports the missing one.
bool ModelQuery::hasParts(const ModelTeller& teller, std::uint64_t model) {
  const struct {
    const std::optional<std::string>& name;
    Kind kind;
    const char* word;
  } parts[] = {{options_.parts.link, Kind::kLink, "link"},
               {options_.parts.joint, Kind::kJoint, "joint"},
               {options_.parts.sensor, Kind::kSensor, "sensor"}};
  for (const auto& part : parts) {
    if (!part.name || part.name->empty()) continue;
    const std::vector<std::string> known = teller.namesOf(model, part.kind);
    if (std::ranges::find(known, *part.name) != known.end()) continue;
    fail("model '" + options_.model + "' has no " + part.word + " '" + *part.name + "'", hintFor(*part.name, known));
    return false;
  }
  return true;
}

}  // namespace

int showModels(const ModelOptions& options) { return ModelQuery(options).run(); }

}  // namespace pongsim::cli
