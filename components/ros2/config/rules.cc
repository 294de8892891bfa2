#include "ros2/config/rules.hh"

#include <algorithm>
#include <optional>
#include <tuple>
#include <utility>

#include "pongsim/message.hh"
#include "pongsim/node.hh"
#include "pongsim/program/nearest_word.hh"
#include "ros2/node/names.hh"
#include "ros2/pairs/pairs.hh"

namespace pongsim::ros2 {

namespace {

/// A service of ros_gz_interfaces, and its counterpart in the simulation.
struct ServiceKind {
  std::string_view type;
  /// Name after "/world/W/".
  std::string_view name;
  std::string_view request;
  std::string_view reply;
};
constexpr ServiceKind kServices[] = {
    {"ros_gz_interfaces/srv/ControlWorld", "control", "ignition.msgs.WorldControl", "ignition.msgs.Boolean"},
    {"ros_gz_interfaces/srv/SpawnEntity", "create", "ignition.msgs.EntityFactory", "ignition.msgs.Boolean"},
    {"ros_gz_interfaces/srv/DeleteEntity", "remove", "ignition.msgs.Entity", "ignition.msgs.Boolean"},
    {"ros_gz_interfaces/srv/SetEntityPose", "set_pose", "ignition.msgs.Pose", "ignition.msgs.Boolean"},
};

/// @return "bridge.yaml:4:3"; "another place on the command line" if it has no line.
std::string placeOf(const SourcePosition& position) {
  if (position.line == 0) return "another place on the command line";
  return *position.file + ":" + std::to_string(position.line) + ":" + std::to_string(position.column);
}

/// @return Like `messageTypeName`, also for names with "::".
std::optional<std::string> ignitionTypeOf(std::string name) {
  for (std::size_t at = name.find("::"); at != std::string::npos; at = name.find("::")) name.replace(at, 2, ".");
  return messageTypeName(name);
}

std::string partnersOf(std::string_view rosType) {
  std::string partners;
  for (const Pair& pair : allPairs()) {
    if (pair.ros == rosType) partners += (partners.empty() ? "" : ", ") + pair.ignition;
  }
  return partners;
}

class Maker {
 public:
  Maker(const NameScope& scope, Diagnostics& diagnostics) : scope_(scope), diagnostics_(diagnostics) {}

  void add(const RuleText& text) { text.isService ? addService(text) : addTopic(text); }
  Rules take() { return std::move(rules_); }

 private:
  void error(const SourcePosition& where, std::string message, std::string hint = {}) {
    diagnostics_.error(where, std::move(message), std::move(hint));
  }
  void warning(const SourcePosition& where, std::string message, std::string hint = {}) {
    diagnostics_.warning(where, std::move(message), std::move(hint));
  }

  void addTopic(const RuleText& text);
  void addService(const RuleText& text);
  std::optional<std::string> rosName(const GivenText& said, const char* kind);
  std::optional<std::string> ignitionName(const GivenText& said);
  const Pair* pairOf(const RuleText& text);
  const ServiceKind* kindOf(const RuleText& text);
  bool isSaidBefore(const TopicRule& rule);
  bool join(TopicRule& known, const TopicRule& rule);
  void warnOfIneffective(const TopicRule& rule);

  const NameScope& scope_;
  Diagnostics& diagnostics_;
  Rules rules_;
};

std::string expanded(const NameScope& scope, std::string_view name) {
  if (name.starts_with("~/")) return absoluteName(absoluteName(scope.nameSpace, scope.nodeName), name.substr(2));
  return absoluteName(scope.nameSpace, name);
}

/// @param kind "topic" or "service".
std::optional<std::string> Maker::rosName(const GivenText& said, const char* kind) {
  std::string name = expanded(scope_, said.text);
  if (const auto wrong = rosNameError(name)) {
    error(said.position, std::string(kind) + " '" + said.text + "' " + *wrong,
          std::string("ros_") + kind + "_name and gz_" + kind + "_name give it a different name on each side");
    return std::nullopt;
  }
  return name;
}

std::optional<std::string> Maker::ignitionName(const GivenText& said) {
  std::string name = scope_.expandsIgnition       ? expanded(scope_, said.text)
                     : said.text.starts_with('/') ? said.text
                                                  : "/" + said.text;
  if (const auto wrong = topicNameError(name)) {
    error(said.position, "'" + said.text + "' is not a name in the simulation: it " + *wrong,
          said.text.starts_with('~') ? "set expand_gz_topic_names to expand it as in ROS" : "");
    return std::nullopt;
  }
  return name;
}

const Pair* Maker::pairOf(const RuleText& text) {
  const GivenText& ros = *text.rosType;
  const GivenText& ignition = *text.ignitionType;
  const std::optional<std::string> known = ignitionTypeOf(ignition.text);
  if (const Pair* pair = findPair(ros.text, known.value_or(ignition.text))) return pair;
  const std::string partners = partnersOf(ros.text);
  if (partners.empty()) {
    error(ros.position, "'" + ros.text + "' is not a ROS type that can be bridged", hintOfRosType(ros.text));
  } else if (!known) {
    const std::string nearest = nearestMessageType(ignition.text);
    error(ignition.position, "'" + ignition.text + "' is not a message type",
          nearest.empty() ? ros.text + " goes with " + partners : "did you mean '" + nearest + "'?");
  } else {
    error(ignition.position, ros.text + " does not match " + *known, "use " + partners);
  }
  return nullptr;
}

void Maker::addTopic(const RuleText& text) {
  const Pair* pair = pairOf(text);
  std::optional<std::string> ros = rosName(*text.ros, "topic"), ignition = ignitionName(*text.ignition);
  if (pair == nullptr || !ros || !ignition) return;
  TopicRule rule;
  rule.ros = std::move(*ros);
  rule.ignition = std::move(*ignition);
  rule.pair = pair;
  rule.direction = text.direction;
  rule.toRos = text.toRos;
  rule.fromRos = text.fromRos;
  if (text.framePrefix) rule.framePrefix = text.framePrefix->text;
  if (text.frameId) rule.frameId = text.frameId->text;
  rule.position = text.position;
  if (isSaidBefore(rule)) return;
  warnOfIneffective(rule);
  rules_.topics.push_back(std::move(rule));
}

/// @return Whether nothing is to be added, because another rule includes or contradicts this one.
bool Maker::isSaidBefore(const TopicRule& rule) {
  for (TopicRule& known : rules_.topics) {
    if (known.ros == rule.ros && known.pair->ros != rule.pair->ros) {
      error(rule.position, "ROS topic '" + rule.ros + "' can't be " + std::string(rule.pair->ros) + " here and " +
                               std::string(known.pair->ros) + " at " + placeOf(known.position));
      return true;
    }
    if (known.ignition == rule.ignition && known.pair->ignition != rule.pair->ignition) {
      error(rule.position, "topic '" + rule.ignition + "' of the simulation can't be " + rule.pair->ignition +
                               " here and " + known.pair->ignition + " at " + placeOf(known.position));
      return true;
    }
    if (known.ros == rule.ros && known.ignition == rule.ignition) return join(known, rule);
  }
  return false;
}

/// Whether two rules have the same names and types.
bool Maker::join(TopicRule& known, const TopicRule& rule) {
  const bool bothToRos = known.goesToRos() && rule.goesToRos(),
             bothFromRos = known.comesFromRos() && rule.comesFromRos();
  const auto frames = [](const TopicRule& each) { return std::tie(each.framePrefix, each.frameId); };
  if (!bothToRos && !bothFromRos && frames(known) == frames(rule)) {
    warnOfIneffective(rule);
    (rule.goesToRos() ? known.toRos : known.fromRos) = rule.goesToRos() ? rule.toRos : rule.fromRos;
    known.direction = Direction::kBoth;
    return true;
  }
  const bool isSame = known.direction == rule.direction && (!bothToRos || known.toRos == rule.toRos) &&
                      (!bothFromRos || known.fromRos == rule.fromRos) && frames(known) == frames(rule);
  if (isSame) {
    warning(rule.position, "it repeats the rule at " + placeOf(known.position));
  } else {
    error(rule.position, "topic '" + rule.ros + "' is bridged differently at " + placeOf(known.position));
  }
  return true;
}

void Maker::warnOfIneffective(const TopicRule& rule) {
  if (rule.goesToRos()) {
    if (rule.toRos.isLazy.value_or(false) && rule.toRos.isTransientLocal.value_or(false)) {
      warning(rule.position, "a lazy topic can only offer late readers what came since the first one",
              "set lazy: false for transient_local");
    }
    if (!rule.frameId.empty() && !rule.pair->hasHeader) {
      warning(rule.position, "the frame_id has no effect: " + std::string(rule.pair->ros) + " has no header");
    }
  } else if (!rule.frameId.empty()) {
    warning(rule.position, "the frame_id has no effect on messages from ROS");
  }
}

const ServiceKind* Maker::kindOf(const RuleText& text) {
  const auto kind = std::ranges::find(kServices, text.rosType->text, &ServiceKind::type);
  if (kind == std::end(kServices)) {
    std::vector<std::string_view> known;
    std::string all;
    for (const ServiceKind& each : kServices) {
      known.push_back(each.type);
      all += (all.empty() ? "" : ", ") + std::string(each.type);
    }
    const std::string hint = didYouMean(text.rosType->text, known);
    error(text.rosType->position, "'" + text.rosType->text + "' is not a service that can be bridged",
          hint.empty() ? "one of " + all : hint);
    return nullptr;
  }
  if (!text.requestType) return &*kind;
  for (const auto& [said, meant] :
       {std::pair(*text.requestType, kind->request), std::pair(*text.replyType, kind->reply)}) {
    if (ignitionTypeOf(said.text) == meant) continue;
    error(said.position, std::string(kind->type) + " does not match " + said.text,
          "use " + std::string(kind->request) + " and " + std::string(kind->reply));
    return nullptr;
  }
  return &*kind;
}

void Maker::addService(const RuleText& text) {
  const ServiceKind* kind = kindOf(text);
  std::optional<std::string> ros = rosName(*text.ros, "service"), ignition = ignitionName(*text.ignition);
  if (kind == nullptr || !ros || !ignition) return;
  const std::string_view name = *ignition;
  const bool isOfWorld = name.starts_with("/world/") && std::ranges::count(name, '/') == 3;
  if (!isOfWorld || name.substr(name.rfind('/') + 1) != kind->name) {
    error(text.ignition->position,
          "'" + *ignition + "' is not a service of the simulation of type " + std::string(kind->type),
          "it is '/world/WORLD/" + std::string(kind->name) + "'");
    return;
  }
  for (const ServiceRule& known : rules_.services) {
    if (known.ros != *ros) continue;
    if (known.ignition == *ignition) {
      warning(text.position, "it repeats the rule at " + placeOf(known.position));
    } else {
      error(text.position, "ROS service '" + *ros + "' is '" + known.ignition + "' at " + placeOf(known.position));
    }
    return;
  }
  rules_.services.push_back({std::move(*ros), std::move(*ignition), std::string(kind->type), text.position});
}

}  // namespace

Rules makeRules(std::span<const RuleText> texts, const NameScope& scope, Diagnostics& diagnostics) {
  Maker maker(scope, diagnostics);
  for (const RuleText& text : texts) maker.add(text);
  return maker.take();
}

void warnOfOtherWorlds(std::span<const ServiceRule> services, std::string_view world, Diagnostics& diagnostics) {
  const std::string own = cleanTopic("/world/" + std::string(world) + "/");
  for (const ServiceRule& rule : services) {
    if (rule.ignition.starts_with(own)) continue;
    diagnostics.warning(rule.position, "service '" + rule.ignition + "' belongs to another world and is not bridged",
                        "this world is '" + std::string(world) + "'");
  }
}

std::string hintOfRosType(std::string_view name) {
  std::vector<std::string_view> known;
  for (const Pair& pair : allPairs()) known.push_back(pair.ros);
  return didYouMean(name, known);
}

}  // namespace pongsim::ros2
