#include "ros2/config/elements.hh"

#include <cmath>
#include <filesystem>
#include <stdexcept>
#include <utility>

#include "pongsim/program/nearest_word.hh"
#include "ros2/config/bridge_file.hh"
#include "ros2/config/distro.hh"
#include "ros2/config/environment.hh"
#include "ros2/config/rules.hh"
#include "ros2/config/topic_argument.hh"
#include "ros2/node/names.hh"
#include "ros2/wire/participant.hh"
#include "ros2/wire/security.hh"

namespace pongsim::ros2 {

namespace {

/// Position of the element, or of the plugin if it is missing.
const SourcePosition& positionOf(const Element& plugin, std::string_view name) {
  const Element* found = plugin.child(name);
  return found == nullptr ? plugin.position : found->position;
}

/// @return The path of the file, to be opened and for messages.
std::filesystem::path besideItsElement(const std::string& file, const SourcePosition& position) {
  const std::filesystem::path path(file);
  if (path.is_absolute() || position.file == nullptr) return path;
  return std::filesystem::path(*position.file).parent_path() / path;
}

}  // namespace

void SettingsElements::declare(Declaration& declaration) {
  declaration.parameter("domain", &domain_, "", "ROS domain, 0 to 232").otherwise("$ROS_DOMAIN_ID, else 0");
  declaration
      .parameter("distro", &distro_, "",
                 "ROS distribution of the other nodes, such as humble or jazzy, where it is not seen from them")
      .otherwise("$ROS_DISTRO");
  declaration.parameter("node_name", &nodeName_, "", "name of the node");
  declaration.parameter("namespace", &nameSpace_, "", "prefix of the node's and topics' names, such as /robot");
  declaration.parameter("frame_prefix", &framePrefix_, "", "prefix of all frames, such as robot/");
  declaration.parameter("bridge_all", &bridgesAll_, "",
                        "whether to bridge all topics that have a ROS type, or only those that are named");
  declaration.usesFiles();
  declaration.parameter("config_file", &configFile_, "",
                        "configuration in the YAML of ros_gz_bridge, named from the folder of the world");
  declaration.parameter("topic", &topics_, "",
                        "a topic or service as ros_gz's parameter_bridge takes it: NAME@ROS_TYPE@IGNITION_TYPE, with [ "
                        "in place of the second @ for to ROS only, ] for from ROS only");
  declaration.parameter("expand_gz_topic_names", &expandsIgnition_, "",
                        "whether the namespace is also put before the simulation's topic names in rules");
  declaration.parameter("override_timestamps_with_wall_time", &usesWallTime_, "",
                        "whether messages to ROS are stamped with wall time");
}

void SettingsElements::nameAfter(std::string_view world, const Element& plugin) {
  const Element* const name = plugin.child("node_name");
  // options of the command line have no line
  const bool isOfFile = name != nullptr && name->position.line > 0;
  if (!isOfFile) nodeName_ += "_" + rosNameFor(world).substr(1);
}

std::optional<ParticipantOptions> SettingsElements::readParticipant(const Element& plugin,
                                                                    Diagnostics& diagnostics) const {
  ParticipantOptions options;
  bool isFine = true;
  const auto refuse = [&](const SourcePosition& where, std::string why, std::string hint = {}) {
    diagnostics.error(where, std::move(why), std::move(hint));
    isFine = false;
  };
  try {
    options = participantOptionsOfEnvironment();
  } catch (const std::invalid_argument& error) {
    // here it can be reported with its position
    if (!domain_) refuse(plugin.position, error.what());
  }
  if (domain_ && (*domain_ < 0 || *domain_ > kLastDomain || *domain_ != std::floor(*domain_))) {
    refuse(positionOf(plugin, "domain"), "the ROS domain must be an integer between 0 and 232");
  } else if (domain_) {
    options.domain = static_cast<int>(*domain_);
  }
  if (!distro_.empty() && !isDistro(distro_)) {
    const std::string hint = didYouMean(distro_, distroNames());
    refuse(positionOf(plugin, "distro"), "'" + distro_ + "' is not a ROS 2 distribution",
           hint.empty() ? "humble or jazzy, for example" : hint);
  }
  if (!isFine) return std::nullopt;
  try {
    // the participant would fail with the same reason, but without the position
    const Security security = securityOfEnvironment(options.domain);
    if (!security.warning.empty()) diagnostics.warning(plugin.position, security.warning);
  } catch (const KeystoreError& error) {
    refuse(plugin.position, error.what(), error.hint());
  }
  for (std::string& sentence : unmetVariables(options)) diagnostics.warning(plugin.position, std::move(sentence));
  return isFine ? std::optional(options) : std::nullopt;
}

std::optional<Settings> SettingsElements::read(const Element& plugin, Diagnostics& diagnostics) const {
  Diagnostics found;
  Settings settings;
  if (const auto participant = readParticipant(plugin, found)) settings.participant = *participant;
  settings.distro = distro_.empty() ? distroOfEnvironment() : distro_;
  settings.nodeName = nodeName_;
  settings.nameSpace = absoluteName("/", nameSpace_.empty() ? "/" : nameSpace_);
  settings.frames.prefix = framePrefix_;
  settings.frames.usesWallTime = usesWallTime_;
  settings.bridgesAll = bridgesAll_;
  settings.configFile = configFile_;
  // checked separately, so that the message names the wrong one
  if (const auto wrong = rosNameError("/" + nodeName_); wrong || nodeName_.find('/') != std::string::npos) {
    found.error(positionOf(plugin, "node_name"), "the name of the node, '" + nodeName_ + "', " +
                                                     wrong.value_or("contains a slash: put that part in <namespace>"));
  }
  if (settings.nameSpace != "/") {
    if (const auto wrong = rosNameError(settings.nameSpace)) {
      found.error(positionOf(plugin, "namespace"), "the namespace '" + nameSpace_ + "' " + *wrong);
    }
  }

  std::vector<RuleText> texts;
  if (!configFile_.empty()) {
    const SourcePosition& position = positionOf(plugin, "config_file");
    texts = readBridgeFile(besideItsElement(configFile_, position), found);
  }
  for (const Element* element : plugin.childrenNamed("topic")) {
    if (element->text.empty()) continue;
    if (auto rule = readTopicArgument(element->text, element->position, found)) texts.push_back(std::move(*rule));
  }
  Rules rules = makeRules(texts, {settings.nameSpace, settings.nodeName, expandsIgnition_}, found);
  settings.rules = std::move(rules.topics);
  settings.services = std::move(rules.services);
  if (expandsIgnition_ && texts.empty()) {
    found.warning(positionOf(plugin, "expand_gz_topic_names"),
                  "<expand_gz_topic_names> has no effect: no rules are given");
  }
  if (!bridgesAll_ && texts.empty()) {
    found.warning(positionOf(plugin, "bridge_all"), "no topic is bridged: <bridge_all> is false and no topic is given");
  }
  for (const Diagnostic& each : found.all()) diagnostics.add(each);
  return found.hasErrors() ? std::nullopt : std::optional(std::move(settings));
}

}  // namespace pongsim::ros2
