#include <CLI/App.hpp>
#include <algorithm>
#include <chrono>
#include <memory>
#include <nlohmann/json.hpp>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "pongsim/program/nearest_word.hh"
#include "ros2/command/command.hh"
#include "ros2/command/domain_options.hh"
#include "ros2/node/node_watch.hh"
#include "shared/program/console.hh"

namespace pongsim::ros2 {

namespace {

// Enough for all nodes to be discovered; on an idle machine it takes a second.
constexpr std::chrono::seconds kNodesTime{5};

struct NodesCommandLine {
  std::shared_ptr<DomainOptions> domain = std::make_shared<DomainOptions>();
  std::string node;
  bool isVerbose = false;
  bool asJson = false;
};

using Interfaces = std::vector<NodeInfo::Interface>;

struct Section {
  const char* title;
  const char* key;
  const Interfaces NodeInfo::*interfaces;
};

constexpr Section kSections[] = {
    {"Publishers", "publishers", &NodeInfo::publishes}, {"Subscribers", "subscribers", &NodeInfo::subscribes},
    {"Services", "services", &NodeInfo::serves},        {"Service clients", "service_clients", &NodeInfo::calls},
    {"Actions", "actions", &NodeInfo::servesActions},   {"Action clients", "action_clients", &NodeInfo::callsActions}};

std::string describe(const NodeInfo& node) {
  std::string text = node.fullName() + "\n";
  for (const Section& section : kSections) {
    const Interfaces& interfaces = node.*section.interfaces;
    if (interfaces.empty()) continue;
    text += std::string("  ") + section.title + ":\n";
    for (const NodeInfo::Interface& each : interfaces) text += "    " + each.name + " [" + each.type + "]\n";
  }
  return text;
}

std::string jsonOf(const std::vector<NodeInfo>& nodes) {
  nlohmann::ordered_json list = nlohmann::ordered_json::array();
  for (const NodeInfo& node : nodes) {
    nlohmann::ordered_json& added = list.emplace_back();
    added = {{"name", node.fullName()}, {"namespace", node.nameSpace}};
    for (const Section& section : kSections) {
      added[section.key] = nlohmann::ordered_json::array();
      for (const NodeInfo::Interface& each : node.*section.interfaces) {
        added[section.key].push_back({{"name", each.name}, {"type", each.type}});
      }
    }
  }
  return list.dump(-1, ' ', false, nlohmann::ordered_json::error_handler_t::replace) + "\n";
}

int failWithout(const std::string& wanted, const std::vector<NodeInfo>& nodes) {
  std::vector<std::string> names;
  for (const NodeInfo& node : nodes) names.push_back(node.fullName());
  return cli::fail("no node " + wanted, didYouMean(wanted, std::vector<std::string_view>(names.begin(), names.end())));
}

int showNodes(const NodesCommandLine& given) {
  const ParticipantOptions options = given.domain->participant();
  Participant participant(options);
  const NodeWatch watch(participant);
  watch.settle(kNodesTime);
  std::vector<NodeInfo> nodes = watch.nodes();
  if (!given.node.empty()) {
    const std::string wanted = given.node.starts_with('/') ? given.node : "/" + given.node;
    const std::vector<NodeInfo> all = nodes;
    std::erase_if(nodes, [&](const NodeInfo& node) { return node.fullName() != wanted; });
    if (nodes.empty()) return failWithout(wanted, all);
  }
  if (given.asJson) return cli::print(jsonOf(nodes)) ? cli::kDone : cli::kFailed;
  if (nodes.empty()) cli::say("no nodes in domain " + std::to_string(options.domain));
  std::string text;
  for (const NodeInfo& node : nodes) {
    text += given.isVerbose || !given.node.empty() ? describe(node) : node.fullName() + "\n";
  }
  return cli::print(text) ? cli::kDone : cli::kFailed;
}

}  // namespace

void addNodesAction(CLI::App& program, cli::Work& work) {
  const auto given = std::make_shared<NodesCommandLine>();
  CLI::App* action = program.add_subcommand(
      "nodes", "List the nodes in the domain, or describe one: its topics, services and actions");
  action->add_option("NODE", given->node, "Describe this node: its topics, services and actions")->type_name("");
  action->add_flag("-v,--verbose", given->isVerbose, "Describe all of them")->disable_flag_override();
  action->add_flag("--json", given->asJson, "Print JSON: an array with everything known about each")
      ->disable_flag_override();
  addDomainOptions(*action, given->domain);
  action->footer(
      "Examples:\n"
      "  pongsim ros2 nodes\n"
      "  pongsim ros2 nodes /pongsim\n"
      "  pongsim ros2 nodes --json --domain 5");
  action->callback([given, &work] { work = [given] { return showNodes(*given); }; });
}

}  // namespace pongsim::ros2
