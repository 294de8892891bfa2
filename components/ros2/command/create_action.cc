#include <ignition/msgs/boolean.pb.h>
#include <ignition/msgs/entity_factory.pb.h>

#include <CLI/App.hpp>
#include <Eigen/Geometry>
#include <algorithm>
#include <charconv>
#include <chrono>
#include <cmath>
#include <filesystem>
#include <map>
#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <system_error>
#include <vector>

#include "pongsim/node.hh"
#include "pongsim/program/nearest_word.hh"
#include "ros2/command/command.hh"
#include "ros2/command/description_source.hh"
#include "ros2/command/domain_options.hh"
#include "ros2/command/single_dash.hh"
#include "shared/program/console.hh"
#include "shared/program/failure.hh"

namespace pongsim::ros2 {

namespace {

// Equal to ros_gz_sim's waiting time for the response.
constexpr std::chrono::seconds kAnswerTime{5};
constexpr std::chrono::milliseconds kDiscoveryTime{300};
constexpr std::string_view kWorldPrefix = "/world/", kCreateSuffix = "/create";

struct CreateCommandLine {
  std::shared_ptr<DomainOptions> domain = std::make_shared<DomainOptions>();
  std::string world, file, topic, parameter, text, owner, name;
  bool allowsRenaming = false;
  std::map<std::string, std::string> pose;
  std::string timeout;
};

struct CreateOptions {
  CreateCommandLine given;
  Eigen::Vector3d position;
  Eigen::Quaterniond rotation;
  SearchOptions search;
  ParticipantOptions participant;
};

double numberOf(const std::string& option, const std::string& text) {
  double number = 0;
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), number);
  if (error != std::errc() || end != text.data() + text.size() || !std::isfinite(number)) {
    throw cli::UsageError("option '" + option + "' takes a number, not '" + text + "'");
  }
  return number;
}

CreateOptions optionsOf(const CreateCommandLine& given) {
  const std::string* sources[] = {&given.file, &given.topic, &given.parameter, &given.text};
  const auto count = std::ranges::count_if(sources, [](const std::string* each) { return !each->empty(); });
  if (count == 0) throw cli::UsageError("nothing to create", "use -file, -topic, -param or -string");
  if (count > 1) throw cli::UsageError("use only one of -file, -topic, -param and -string");
  if (!given.owner.empty() && given.parameter.empty()) throw cli::UsageError("option '--node' needs '-param'");
  CreateOptions options{given, {}, {}, {std::nullopt, [](std::string_view what) { cli::say(what); }}, {}};
  const auto number = [&](const char* name) {
    const auto found = given.pose.find(name);
    return found == given.pose.end() ? 0 : numberOf(std::string("-") + name, found->second);
  };
  options.position = {number("x"), number("y"), number("z")};
  options.rotation = fromRollPitchYaw(number("R"), number("P"), number("Y"));
  if (!given.timeout.empty()) {
    const double milliseconds = numberOf("--timeout", given.timeout);
    // a year stands for no limit
    if (milliseconds < 0)
      throw cli::UsageError("option '--timeout' takes a number from 0 up, not '" + given.timeout + "'");
    options.search.timeout = std::chrono::milliseconds(static_cast<std::int64_t>(std::min(milliseconds, 3e10)));
  }
  options.participant = given.domain->participant();
  return options;
}

std::vector<std::string> worldsIn(const std::vector<ServiceInfo>& services) {
  std::vector<std::string> worlds;
  for (const ServiceInfo& service : services) {
    std::string_view name = service.name;
    if (name.size() <= kWorldPrefix.size() + kCreateSuffix.size() || !name.starts_with(kWorldPrefix) ||
        !name.ends_with(kCreateSuffix)) {
      continue;
    }
    name = name.substr(kWorldPrefix.size(), name.size() - kWorldPrefix.size() - kCreateSuffix.size());
    if (name.find('/') == std::string_view::npos) worlds.emplace_back(name);
  }
  return worlds;
}

/// Waits for the world, with a message if that takes longer.
/// @return Its name; nothing if there is none in time, or several, after an error message.
std::optional<std::string> findWorld(Transport& transport, const CreateOptions& options) {
  using Clock = std::chrono::steady_clock;
  const Clock::time_point start = Clock::now();
  const std::string wanted = cleanTopic(options.given.world);
  bool hasSaid = false;
  while (true) {
    const std::vector<std::string> worlds = worldsIn(transport.discoverServices(kDiscoveryTime));
    if (!wanted.empty() && std::ranges::count(worlds, wanted) > 0) return wanted;
    if (wanted.empty() && worlds.size() == 1) return worlds.front();
    if (wanted.empty() && worlds.size() > 1) {
      std::string names;
      for (const std::string& world : worlds) names += (names.empty() ? "" : ", ") + world;
      cli::fail("several worlds are running: " + names, "choose with -world WORLD");
      return std::nullopt;
    }
    const auto waited = Clock::now() - start;
    if (options.search.timeout && waited >= *options.search.timeout) {
      cli::fail(wanted.empty() ? "no world is running" : "no world '" + options.given.world + "' is running",
                worlds.empty() ? "start one with pongsim run WORLD"
                               : didYouMean(wanted, std::vector<std::string_view>(worlds.begin(), worlds.end())));
      return std::nullopt;
    }
    if (!hasSaid && waited > std::chrono::seconds(1)) {
      hasSaid = true;
      cli::say(wanted.empty() ? "waiting for a world" : "waiting for the world '" + options.given.world + "'");
    }
    transport.dispatchFor(std::chrono::milliseconds(50));
  }
}

/// @return Whether `request` has the model now; if not, an error was printed.
bool describe(const CreateOptions& options, ignition::msgs::EntityFactory& request) {
  const CreateCommandLine& given = options.given;
  if (!given.text.empty()) {
    request.set_sdf(given.text);
    return true;
  }
  if (!given.file.empty()) {
    // the simulation may run in another folder
    std::error_code error;
    const bool isHere = std::filesystem::exists(given.file, error);
    request.set_sdf_filename(isHere ? std::filesystem::absolute(given.file, error).string() : given.file);
    return true;
  }
  Participant participant(options.participant);
  RosNode node(participant, {.name = "ros_gz_sim"});
  const auto description = given.topic.empty()
                               ? descriptionFromParameter(node, given.owner, given.parameter, options.search)
                               : descriptionFromTopic(node, given.topic, options.search);
  if (!description) {
    cli::fail(given.topic.empty() ? "no node has a parameter '" + given.parameter + "'"
                                  : "no messages on '" + node.resolve(given.topic) + "'");
    return false;
  }
  if (description->empty()) {
    cli::fail("the description is empty");
    return false;
  }
  request.set_sdf(*description);
  return true;
}

int create(const CreateOptions& options) {
  ignition::msgs::EntityFactory request;
  if (!describe(options, request)) return cli::kFailed;
  request.set_name(options.given.name);
  request.set_allow_renaming(options.given.allowsRenaming);
  // always set, as in ros_gz_sim: the pose in the file is ignored
  auto& position = *request.mutable_pose()->mutable_position();
  position.set_x(options.position.x());
  position.set_y(options.position.y());
  position.set_z(options.position.z());
  auto& orientation = *request.mutable_pose()->mutable_orientation();
  orientation.set_w(options.rotation.w());
  orientation.set_x(options.rotation.x());
  orientation.set_y(options.rotation.y());
  orientation.set_z(options.rotation.z());

  Transport transport;
  const auto world = findWorld(transport, options);
  if (!world) return cli::kFailed;
  ignition::msgs::Boolean reply;
  const CallResult result = transport.node().call(std::string(kWorldPrefix) + *world + std::string(kCreateSuffix),
                                                  request, reply, kAnswerTime);
  if (!result) return cli::fail(result.error);
  if (!reply.data()) return cli::fail("the world '" + *world + "' did not create it");
  cli::say("created in the world '" + *world + "'");
  return cli::kDone;
}

}  // namespace

void addCreateAction(CLI::App& program, cli::Work& work) {
  const auto given = std::make_shared<CreateCommandLine>();
  CLI::App* action = program.add_subcommand("create", "Insert a model, as ros_gz_sim's create does");
  const auto add = [&](const char* name, const char* value, const char* help, std::string& target) {
    action->add_option("--" + std::string(name), target, help)->type_name(value);
  };
  add("world", "WORLD", "The world's name, if several run", given->world);
  add("file", "FILE", "What to insert: an SDF or URDF file, or an address such as model://box", given->file);
  add("topic", "TOPIC", "... or the message that a node keeps on a topic, such as robot_description", given->topic);
  add("param", "NAME", "... or a text parameter of a node", given->parameter);
  add("node", "NODE", "The node with that parameter (the first one that has it)", given->owner);
  add("string", "TEXT", "... or the text itself", given->text);
  add("name", "NAME", "Its name in the world (the one that it has)", given->name);
  action
      ->add_flag("--allow_renaming", given->allowsRenaming, "If the name is taken, use another one instead of failing")
      ->disable_flag_override();
  for (const char* coordinate : {"x", "y", "z"}) add(coordinate, "M", "Its position [m] (0)", given->pose[coordinate]);
  add("R", "RAD", "Its roll [rad] (0)", given->pose["R"]);
  add("P", "RAD", "Its pitch [rad] (0)", given->pose["P"]);
  add("Y", "RAD", "Its yaw [rad] (0)", given->pose["Y"]);
  add("timeout", "MS", "Give up after MS milliseconds without world, message or parameter (never)", given->timeout);
  addDomainOptions(*action, given->domain);
  action->footer(
      "A single dash works for all of these, as in ros_gz_sim: -world, -x.\n"
      "Examples:\n"
      "  pongsim ros2 create -topic robot_description -name robot -z 0.1\n"
      "  pongsim ros2 create -world pong -file box.sdf -x 1 -Y 1.57 -allow_renaming");
  action->callback([given, &work] {
    std::erase_if(given->pose, [](const auto& each) { return each.second.empty(); });
    const CreateOptions options = optionsOf(*given);
    work = [options] { return create(options); };
  });
}

std::vector<std::string> withTwoDashesForCreate(std::vector<std::string> words, const CLI::App&) {
  if (words.front() != "create") return words;
  static constexpr std::string_view kWithValue[] = {"world", "file",    "topic",  "param",  "node",    "string",
                                                    "name",  "timeout", "domain", "distro", "network", "x",
                                                    "y",     "z",       "R",      "P",      "Y"};
  static constexpr std::string_view kFlags[] = {"allow_renaming"};
  return withTwoDashes(words, {kWithValue, kFlags});
}

}  // namespace pongsim::ros2
