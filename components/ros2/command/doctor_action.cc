#include <unistd.h>

#include <CLI/App.hpp>
#include <algorithm>
#include <chrono>
#include <memory>
#include <nlohmann/json.hpp>
#include <string>

#include "ros2/command/command.hh"
#include "ros2/command/domain_options.hh"
#include "ros2/doctor/checks.hh"
#include "ros2/doctor/observer.hh"
#include "ros2/node/names.hh"
#include "shared/program/console.hh"
#include "shared/program/failure.hh"

namespace pongsim::ros2 {

namespace {

using Verdict = Finding::Verdict;

struct DoctorCommandLine {
  std::shared_ptr<DomainOptions> domain = std::make_shared<DomainOptions>();
  Expected expected;
  double time = 3;
  bool asJson = false;
};

const char* wordFor(Verdict verdict) {
  return verdict == Verdict::kGood ? "ok" : verdict == Verdict::kHint ? "hint" : "FAULT";
}

std::string textOf(const Findings& findings) {
  std::string text;
  for (const Finding& each : findings) {
    std::string word = wordFor(each.verdict);
    word.resize(7, ' ');
    text += word + each.text + "\n";
    if (!each.remedy.empty()) text += "       for " + std::string(each.users) + "; to mend: " + each.remedy + "\n";
  }
  return text;
}

std::string jsonOf(const Findings& findings) {
  nlohmann::ordered_json list = nlohmann::ordered_json::array();
  for (const Finding& each : findings) {
    list.push_back({{"verdict", each.verdict == Verdict::kFault ? "fault" : wordFor(each.verdict)},
                    {"text", each.text},
                    {"for", each.users},
                    {"mend", each.remedy}});
  }
  return list.dump(-1, ' ', false, nlohmann::ordered_json::error_handler_t::replace) + "\n";
}

int examine(const DoctorCommandLine& given) {
  const ParticipantOptions options = given.domain->participant();
  Participant participant(options);
  RosNode node(participant, {.name = "pongsim_doctor_" + std::to_string(getpid())});
  Observer observer(node);
  observer.watch(std::chrono::milliseconds(static_cast<std::int64_t>(given.time * 1000)));
  const Observation seen = observer.observation();
  if (seen.endpoints.empty()) {
    return cli::fail("no nodes in domain " + std::to_string(options.domain),
                     "start the simulation with --ros2; see the same ROS_DOMAIN_ID on both sides");
  }
  const Findings findings = checkAll(seen, given.expected);
  const auto count = [&](Verdict verdict) { return std::ranges::count(findings, verdict, &Finding::verdict); };
  const auto faults = count(Verdict::kFault);
  const int code = faults > 0 ? cli::kFailed : cli::kDone;
  if (given.asJson) return cli::print(jsonOf(findings)) ? code : cli::kFailed;
  const auto counted = [](std::ptrdiff_t number, const char* what) {
    return std::to_string(number) + " " + what + (number == 1 ? "" : "s");
  };
  const std::string sum = counted(faults, "fault") + ", " + counted(count(Verdict::kHint), "hint") + "\n";
  return cli::print(textOf(findings) + sum) ? code : cli::kFailed;
}

/// @throws cli::UsageError for names that ROS does not have.
void checkCommandLine(const DoctorCommandLine& given) {
  if (given.time <= 0 || given.time > 3600) {
    throw cli::UsageError("option '--time' takes seconds, up to 3600");
  }
  if (given.expected.nameSpace == "/") return;
  if (const auto wrong = rosNameError(given.expected.nameSpace)) {
    throw cli::UsageError("the namespace '" + given.expected.nameSpace + "' " + *wrong);
  }
}

}  // namespace

void addDoctorAction(CLI::App& program, cli::Work& work) {
  const auto given = std::make_shared<DoctorCommandLine>();
  CLI::App* action = program.add_subcommand(
      "doctor", "Check a running world for what Nav2, slam_toolbox, robot_localization and RViz need");
  action->add_option("--namespace", given->expected.nameSpace, "Namespace of the robot's topics, such as /robot1 (/)")
      ->type_name("NAME");
  action
      ->add_option("--frame-prefix", given->expected.framePrefix,
                   "Prefix of the robot's frames, such as robot1/ (none)")
      ->type_name("PREFIX");
  action->add_option("--time", given->time, "How long to watch [s] (3)")->type_name("S");
  action->add_flag("--json", given->asJson, "Print JSON: an array with verdict, text, users and remedy of each finding")
      ->disable_flag_override();
  addDomainOptions(*action, given->domain);
  action->footer(
      "Checks the clock and use_sim_time; frames by REP 105, with one parent and one publisher each; names, stamps,\n"
      "rates, frames and covariances of topics; commands; the description with its joints; and quality of service.\n"
      "Each fault is followed by who needs it, and by the line that mends it. The exit code is 1 if there is a fault;\n"
      "hints don't count.\n"
      "Examples:\n"
      "  pongsim ros2 doctor\n"
      "  pongsim ros2 doctor --namespace /robot1 --frame-prefix robot1/\n"
      "  pongsim ros2 doctor --time 10 --json");
  action->callback([given, &work] {
    if (!given->expected.nameSpace.starts_with('/')) given->expected.nameSpace.insert(0, "/");
    checkCommandLine(*given);
    work = [given] { return examine(*given); };
  });
}

}  // namespace pongsim::ros2
