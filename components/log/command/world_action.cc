#include <ignition/msgs/stringmsg.pb.h>

#include <CLI/App.hpp>
#include <algorithm>
#include <memory>
#include <string>
#include <string_view>
#include <vector>

#include "log/command/command.hh"
#include "log/playback/played_files.hh"
#include "log/playback/played_sdf.hh"
#include "log/store/failure.hh"
#include "log/tlog/tlog_reader.hh"
#include "shared/program/console.hh"
#include "shared/program/failure.hh"

namespace pongsim::log {

namespace {

/// @return The name in "/world/NAME/changed_state"; "default" if there is no such topic.
std::string worldNameIn(const TlogReader& reader) {
  constexpr std::string_view kPrefix = "/world/", kSuffix = "/changed_state";
  for (const std::string& topic : reader.topicsOf("ignition.msgs.SerializedStateMap")) {
    if (topic.starts_with(kPrefix) && topic.ends_with(kSuffix) && topic.size() > kPrefix.size() + kSuffix.size())
      return topic.substr(kPrefix.size(), topic.size() - kPrefix.size() - kSuffix.size());
  }
  return "default";
}

bool hasStates(const TlogReader& reader) {
  return std::ranges::any_of(reader.topics(), [](const Topic& topic) {
    const bool isState =
        topic.type == "ignition.msgs.SerializedStateMap" || topic.type == "ignition.msgs.SerializedState";
    return isState && topic.count > 0;
  });
}

/// @return The recorded world in SDF; empty if there is none.
std::string recordedWorld(const TlogReader& reader) {
  std::vector<std::string> topics;
  for (const std::string& topic : reader.topicsOf("ignition.msgs.StringMsg")) {
    if (topic.ends_with("/sdf")) topics.push_back(topic);
  }
  std::string world;
  if (topics.empty()) return world;
  reader.forEach({.topics = topics}, [&](const Record& record) {
    ignition::msgs::StringMsg message;
    if (message.ParseFromArray(record.payload.data(), static_cast<int>(record.payload.size()))) world = message.data();
    return world.empty();
  });
  return world;
}

int printWorld(const std::string& path) {
  const PlayedFiles files(path);
  const TlogReader reader(files.stateFile());
  if (!hasStates(reader)) {
    throw Failure("'" + path + "' contains no state of a world",
                  "its recording ended before the first state was written");
  }
  const std::string world = recordedWorld(reader);
  if (world.empty()) {
    cli::say("the recording does not contain the world's SDF: the models are made from the states");
    cli::print("<sdf version='1.9'><world name='" + worldNameIn(reader) + "'/></sdf>\n");
  } else {
    cli::print(playedSdf(world, files, worldNameIn(reader)));
  }
  return cli::kDone;
}

}  // namespace

void addWorldAction(CLI::App& program, cli::Work& work) {
  const auto path = std::make_shared<std::string>();
  CLI::App* action = program.add_subcommand("world", "Print the SDF world that plays a recording");
  action->add_option("PATH", *path, "Folder of the recording, zip file of one, or .tlog file")->type_name("");
  action->footer("Examples:\n  pongsim log world ~/rec > played.sdf");
  action->callback([path, &work] {
    if (path->empty()) throw cli::UsageError("no recording given", "pongsim log world PATH");
    work = [path] { return printWorld(*path); };
  });
}

}  // namespace pongsim::log
