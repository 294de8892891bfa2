#include <ignition/msgs/empty.pb.h>
#include <ignition/msgs/param_v.pb.h>

#include <CLI/App.hpp>
#include <algorithm>
#include <charconv>
#include <chrono>
#include <cstdio>
#include <cstdlib>
#include <memory>
#include <nlohmann/json.hpp>
#include <optional>
#include <string>
#include <string_view>
#include <thread>
#include <vector>

#include "pongsim/log.hh"
#include "pongsim/node.hh"
#include "pongsim/program/nearest_word.hh"
#include "ros2/bridge/topics_service.hh"
#include "ros2/command/command.hh"
#include "ros2/command/domain_options.hh"
#include "ros2/command/rows.hh"
#include "shared/program/console.hh"
#include "shared/program/failure.hh"

namespace pongsim::ros2 {

namespace {

using ignition::msgs::Param;
using ignition::msgs::Param_V;
using Clock = std::chrono::steady_clock;

/// Maximum time for other processes to report their services.
constexpr std::chrono::milliseconds kServicesTime{5000};
constexpr std::chrono::milliseconds kDispatchTime{20};
constexpr std::chrono::seconds kTopicsTime{5};
constexpr double kLongestLook = 3600;
constexpr std::string_view kTopicsPrefix = "/world/", kTopicsSuffix = "/ros2/topics", kControlSuffix = "/control";

struct TopicsCommandLine {
  std::string world;
  bool asJson = false;
  /// Measuring time of rates [s].
  double duration = 1;
  std::chrono::milliseconds timeout{1000};
};

/// The messages that passed during the measurement.
struct Measurement {
  Param_V topics;
  /// From the first to the last request [s].
  double seconds = 0;
  Param_V before;
};

/// @return The worlds that offer such a service, by their names in its name.
std::vector<std::string> worldsWith(const std::vector<ServiceInfo>& services, std::string_view suffix) {
  std::vector<std::string> worlds;
  for (const ServiceInfo& service : services) {
    std::string_view name = service.name;
    if (name.size() <= kTopicsPrefix.size() + suffix.size() || !name.starts_with(kTopicsPrefix) ||
        !name.ends_with(suffix))
      continue;
    name.remove_prefix(kTopicsPrefix.size());
    name.remove_suffix(suffix.size());
    if (name.find('/') == std::string_view::npos) worlds.emplace_back(name);
  }
  return worlds;
}

int failWithout(const std::string& wanted, const std::vector<std::string>& bridged,
                const std::vector<std::string>& running) {
  if (wanted.empty() && bridged.size() > 1) {
    std::string names;
    for (const std::string& world : bridged) names += (names.empty() ? "" : ", ") + world;
    return cli::fail("several worlds are bridged: " + names, "choose with -w WORLD");
  }
  if (!wanted.empty() && std::ranges::count(running, wanted) == 0) {
    return cli::fail("no world '" + wanted + "' is running",
                     didYouMean(wanted, std::vector<std::string_view>(running.begin(), running.end())));
  }
  if (running.empty()) return cli::fail("no world is running", "start one with pongsim run WORLD --ros2");
  return cli::fail("world '" + (wanted.empty() ? running.front() : wanted) + "' is not bridged to ROS 2",
                   "start it with pongsim run WORLD --ros2");
}

/// @return The world to ask; nothing if there is none, after an error message.
std::optional<std::string> findWorld(Transport& transport, const TopicsCommandLine& given) {
  const std::string wanted = cleanTopic(given.world);
  const Clock::time_point deadline = Clock::now() + given.timeout;
  while (true) {
    const std::vector<ServiceInfo> services = transport.discoverServices(kServicesTime);
    std::vector<std::string> bridged = worldsWith(services, kTopicsSuffix);
    if (wanted.empty() ? bridged.size() == 1 : std::ranges::count(bridged, wanted) > 0) {
      return wanted.empty() ? bridged.front() : wanted;
    }
    if (Clock::now() >= deadline || bridged.size() > 1) {
      failWithout(wanted, bridged, worldsWith(services, kControlSuffix));
      return std::nullopt;
    }
    transport.dispatchFor(kDispatchTime);
  }
}

std::optional<Param_V> ask(Transport& transport, const std::string& world) {
  Param_V reply;
  const CallResult result = transport.node().call(topicsServiceOf(world), ignition::msgs::Empty(), reply, kTopicsTime);
  if (result) return reply;
  cli::fail(result.error);
  return std::nullopt;
}

std::optional<Measurement> measure(Transport& transport, const TopicsCommandLine& given, const std::string& world) {
  const auto before = ask(transport, world);
  if (!before) return std::nullopt;
  const Clock::time_point start = Clock::now();
  std::this_thread::sleep_for(std::chrono::duration<double>(given.duration));
  const auto after = ask(transport, world);
  if (!after) return std::nullopt;
  return Measurement{*after, std::chrono::duration<double>(Clock::now() - start).count(), *before};
}

std::string text(const Param& topic, const char* name) {
  const auto found = topic.params().find(name);
  return found == topic.params().end() ? "" : found->second.string_value();
}
bool flag(const Param& topic, const char* name) {
  const auto found = topic.params().find(name);
  return found != topic.params().end() && found->second.bool_value();
}
double number(const Param& topic, const char* name) {
  const auto found = topic.params().find(name);
  return found == topic.params().end() ? 0 : found->second.double_value();
}

/// @return Messages per second during the measurement.
double rateOf(const Measurement& measured, const Param& topic, const char* counter) {
  double before = 0;
  for (const Param& each : measured.before.param()) {
    if (text(each, "ros") == text(topic, "ros") && text(each, "ignition") == text(topic, "ignition"))
      before = number(each, counter);
  }
  return measured.seconds > 0 ? std::max(0.0, number(topic, counter) - before) / measured.seconds : 0;
}

std::string counted(double count, const char* what) {
  return std::to_string(static_cast<std::uint64_t>(count)) + " " + what + (count == 1 ? "" : "s");
}

std::string rateText(double rate) {
  char words[32];
  std::snprintf(words, sizeof words, "%.*f Hz", rate < 10 ? 1 : 0, rate);
  return words;
}

std::string tableOf(const Measurement& measured) {
  std::vector<std::vector<std::string>> rows;
  for (const Param& topic : measured.topics.param()) {
    const bool toRos = flag(topic, "to_ros"), fromRos = flag(topic, "from_ros");
    std::string passed;
    if (toRos) {
      passed = "to ROS: " + counted(number(topic, "readers"), "reader") + ", " +
               rateText(rateOf(measured, topic, "sent")) + ", " + counted(number(topic, "dropped"), "drop");
    }
    if (fromRos) {
      passed += std::string(toRos ? "; " : "") + "from ROS: " + counted(number(topic, "writers"), "writer") + ", " +
                rateText(rateOf(measured, topic, "received")) + ", " +
                std::to_string(static_cast<std::uint64_t>(number(topic, "refused"))) + " refused";
    }
    rows.push_back({text(topic, "ros") + " [" + text(topic, "ros_type") + "]", toRos ? fromRos ? "<->" : "<-" : "->",
                    text(topic, "ignition") + " [" + text(topic, "ignition_type") + "]", passed});
  }
  return alignedRows(rows);
}

std::string jsonOf(const Measurement& measured) {
  nlohmann::ordered_json list = nlohmann::ordered_json::array();
  for (const Param& topic : measured.topics.param()) {
    nlohmann::ordered_json& added = list.emplace_back();
    for (const char* name : {"ros", "ros_type", "ignition", "ignition_type"}) added[name] = text(topic, name);
    for (const char* name : {"to_ros", "from_ros"}) added[name] = flag(topic, name);
    for (const char* name : {"readers", "writers", "sent", "received", "dropped", "refused"}) {
      added[name] = static_cast<std::uint64_t>(number(topic, name));
    }
    added["hz_to_ros"] = rateOf(measured, topic, "sent");
    added["hz_from_ros"] = rateOf(measured, topic, "received");
  }
  return list.dump(-1, ' ', false, nlohmann::ordered_json::error_handler_t::replace) + "\n";
}

int listTopics(const TopicsCommandLine& given) {
  // mismatched types make this action fail
  setLogLevel(LogLevel::kError);
  Transport transport;
  const std::optional<std::string> world = findWorld(transport, given);
  if (!world) return cli::kFailed;
  std::optional<Measurement> measured = measure(transport, given, *world);
  if (!measured) return cli::kFailed;
  std::sort(measured->topics.mutable_param()->begin(), measured->topics.mutable_param()->end(),
            [](const Param& a, const Param& b) { return text(a, "ros") < text(b, "ros"); });
  if (given.asJson) return cli::print(jsonOf(*measured)) ? cli::kDone : cli::kFailed;
  if (measured->topics.param_size() == 0) cli::say("no topics are bridged");
  return cli::print(tableOf(*measured)) ? cli::kDone : cli::kFailed;
}

/// @throws cli::UsageError unless it is a number from 0 to `most`.
double numberOption(const char* option, const std::string& text, double most) {
  double value = -1;
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value);
  if (error != std::errc() || end != text.data() + text.size() || !(value >= 0) || value > most) {
    throw cli::UsageError(std::string("option '") + option + "' takes a number between 0 and " +
                          std::to_string(static_cast<long>(most)) + ", not '" + text + "'");
  }
  return value;
}

}  // namespace

void addTopicsAction(CLI::App& program, cli::Work& work) {
  const auto given = std::make_shared<TopicsCommandLine>();
  CLI::App* action = program.add_subcommand(
      "topics", "List what a running simulation bridges, with readers, writers, rates and drops");
  const auto add = [action](const char* names, const char* value, const char* help, auto take) {
    action->add_option_function<std::string>(names, take, help)->type_name(value);
  };
  add("-w,--world", "WORLD", "The world's name, if several run",
      [given](const std::string& words) { given->world = words; });
  add("-d,--duration", "S", "Measure for S seconds (1)",
      [given](const std::string& words) { given->duration = numberOption("-d", words, kLongestLook); });
  add("--timeout", "MS", "Give up after MS milliseconds (1000) without a world", [given](const std::string& words) {
    given->timeout = std::chrono::milliseconds(static_cast<std::int64_t>(numberOption("--timeout", words, 1e9)));
  });
  action->add_flag("--json", given->asJson, "Print JSON: an array of objects")->disable_flag_override();
  add("--network", "INTERFACE", "Also ask machines on this network interface (name or address)",
      [](const std::string& words) { setenv("PONGSIM_NETWORK", words.c_str(), 1); });
  add("--secure", "KEYSTORE[/NAME]", "Take part as an identity of this keystore, like PONGSIM_SECURITY", takeKeystore);
  action->footer(
      "Each line has the ROS topic, the direction (<- to ROS, -> from ROS), the simulation's topic,\nand the readers "
      "or writers, rates and drops.\n"
      "Examples:\n"
      "  pongsim ros2 topics\n"
      "  pongsim ros2 topics -d 5 --json");
  action->callback([given, &work] { work = [given] { return listTopics(*given); }; });
}

}  // namespace pongsim::ros2
