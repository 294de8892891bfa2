#include <CLI/App.hpp>
#include <cstdio>
#include <filesystem>
#include <fstream>
#include <memory>
#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include "pongsim/diagnostic.hh"
#include "ros2/command/command.hh"
#include "ros2/command/rows.hh"
#include "ros2/config/bridge_file.hh"
#include "ros2/config/quality.hh"
#include "ros2/config/rules.hh"
#include "ros2/node/names.hh"
#include "shared/program/console.hh"
#include "shared/program/failure.hh"

namespace pongsim::ros2 {

namespace {

using Json = nlohmann::ordered_json;

struct CheckCommandLine {
  std::string file;
  std::string nameSpace = "/";
  std::string nodeName = "pongsim";
  bool expandsIgnition = false;
  bool asJson = false;
};

const char* reliabilityOf(const Qos& qos) { return qos.isReliable ? "reliable" : "best_effort"; }
const char* durabilityOf(const Qos& qos) { return qos.isTransientLocal ? "transient_local" : "volatile"; }

/// @return "reliable, volatile, depth 10, lazy".
std::string toRosOf(const TopicRule& rule) {
  const Qos qos = writerQos(rule, false);
  return std::string("to ROS: ") + reliabilityOf(qos) + ", " + durabilityOf(qos) + ", depth " +
         std::to_string(qos.depth) + (isLazyToRos(rule, false) ? ", lazy" : "");
}

/// Without a depth, because nothing is queued.
std::string fromRosOf(const TopicRule& rule) {
  const Qos qos = readerQos(rule);
  return std::string("from ROS: ") + reliabilityOf(qos) + ", " + durabilityOf(qos) +
         (isLazyFromRos(rule) ? ", lazy" : "");
}

Json jsonOf(const Qos& qos, bool isLazy) {
  return {{"reliability", reliabilityOf(qos)}, {"durability", durabilityOf(qos)}, {"lazy", isLazy}};
}

std::string tableOf(const Rules& rules) {
  std::vector<std::vector<std::string>> rows;
  for (const TopicRule& rule : rules.topics) {
    std::string quality;
    if (rule.goesToRos()) quality = toRosOf(rule);
    if (rule.comesFromRos()) quality += (quality.empty() ? "" : "; ") + fromRosOf(rule);
    if (!rule.frameId.empty()) quality += "; frame " + rule.frameId;
    if (rule.framePrefix) quality += "; frames begin with '" + *rule.framePrefix + "'";
    rows.push_back({rule.ros + " [" + std::string(rule.pair->ros) + "]",
                    rule.goesToRos() ? rule.comesFromRos() ? "<->" : "<-" : "->",
                    rule.ignition + " [" + rule.pair->ignition + "]", quality});
  }
  for (const ServiceRule& rule : rules.services) {
    rows.push_back({rule.ros + " [" + rule.type + "]", "->", rule.ignition, "service"});
  }
  return alignedRows(rows);
}

Json jsonOf(const Rules& rules) {
  Json topics = Json::array(), services = Json::array();
  for (const TopicRule& rule : rules.topics) {
    Json& added = topics.emplace_back();
    added = {{"ros", rule.ros},
             {"ros_type", rule.pair->ros},
             {"ignition", rule.ignition},
             {"ignition_type", rule.pair->ignition}};
    if (rule.goesToRos()) {
      added["to_ros"] = jsonOf(writerQos(rule, false), isLazyToRos(rule, false));
      added["to_ros"]["depth"] = writerQos(rule, false).depth;
    }
    if (rule.comesFromRos()) added["from_ros"] = jsonOf(readerQos(rule), isLazyFromRos(rule));
    if (!rule.frameId.empty()) added["frame_id"] = rule.frameId;
    if (rule.framePrefix) added["frame_prefix"] = *rule.framePrefix;
  }
  for (const ServiceRule& rule : rules.services) {
    services.push_back({{"ros", rule.ros}, {"type", rule.type}, {"ignition", rule.ignition}});
  }
  return {{"topics", topics}, {"services", services}};
}

Json jsonOf(const Diagnostics& diagnostics) {
  Json list = Json::array();
  for (const Diagnostic& each : diagnostics.all()) {
    Json& added = list.emplace_back();
    added = Json::object();
    if (each.position.file) added["file"] = *each.position.file;
    if (each.position.line > 0) added["line"] = each.position.line;
    if (each.position.column > 0) added["column"] = each.position.column;
    added["severity"] = each.severity == Severity::kError ? "error" : "warning";
    added["message"] = each.message;
    if (!each.hint.empty()) added["hint"] = each.hint;
  }
  return list;
}

/// Prints each message with its line of the file below.
void tell(const Diagnostics& diagnostics, const std::string& file) {
  std::vector<std::string> lines;
  // only files are read again
  if (std::error_code error; std::filesystem::is_regular_file(file, error)) {
    std::ifstream stream(file, std::ios::binary);
    for (std::string line; std::getline(stream, line);) lines.push_back(line);
  }
  for (const Diagnostic& each : diagnostics.all()) {
    const auto number = static_cast<std::size_t>(each.position.line);
    const bool isThere = number >= 1 && number <= lines.size();
    const SourceExcerpt excerpt{.text = isThere ? std::string_view(lines[number - 1]) : std::string_view()};
    std::fprintf(stderr, "%s\n", (isThere ? format(each, excerpt) : format(each)).c_str());
  }
}

int check(const CheckCommandLine& given) {
  if (const auto wrong = rosNameError(absoluteName(given.nameSpace, given.nodeName))) {
    throw cli::UsageError("the node '" + absoluteName(given.nameSpace, given.nodeName) + "' " + *wrong);
  }
  Diagnostics diagnostics;
  const std::vector<RuleText> texts = readBridgeFile(given.file, diagnostics);
  const NameScope scope{absoluteName("/", given.nameSpace), given.nodeName, given.expandsIgnition};
  const Rules rules = makeRules(texts, scope, diagnostics);
  const int code = diagnostics.hasErrors() ? cli::kFailed : cli::kDone;
  if (given.asJson) {
    Json all = jsonOf(rules);
    all["diagnostics"] = jsonOf(diagnostics);
    return cli::print(all.dump(-1, ' ', false, Json::error_handler_t::replace) + "\n") ? code : cli::kFailed;
  }
  tell(diagnostics, given.file);
  return cli::print(tableOf(rules)) ? code : cli::kFailed;
}

}  // namespace

void addCheckAction(CLI::App& program, cli::Work& work) {
  const auto given = std::make_shared<CheckCommandLine>();
  CLI::App* action = program.add_subcommand("check", "Explain a ros_gz_bridge configuration and report its mistakes");
  action->add_option("FILE", given->file, "The configuration, in YAML")->type_name("")->required();
  const auto add = [action](const char* name, const char* value, const char* help, std::string& target) {
    action->add_option(name, target, help)->type_name(value);
  };
  add("--namespace", "NAME", "Namespace of the node, such as /robot", given->nameSpace);
  add("--node-name", "NAME", "Name of the node (pongsim)", given->nodeName);
  action
      ->add_flag("--expand-gz-topic-names", given->expandsIgnition,
                 "Put the namespace before the simulation's "
                 "topics, too")
      ->disable_flag_override();
  action->add_flag("--json", given->asJson, "Print JSON: an object with topics, services and diagnostics")
      ->disable_flag_override();
  action->footer(
      "Each line has the ROS topic, the direction (<- to ROS, -> from ROS), the simulation's topic,\nand the quality "
      "of service.\n"
      "The exit code is 1 if there is an error.\n"
      "Example:\n"
      "  pongsim ros2 check bridge.yaml");
  action->callback([given, &work] { work = [given] { return check(*given); }; });
}

}  // namespace pongsim::ros2
