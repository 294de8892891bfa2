#include "ros2/config/bridge_file.hh"

#include <yaml-cpp/eventhandler.h>
#include <yaml-cpp/yaml.h>

#include <algorithm>
#include <charconv>
#include <fstream>
#include <iterator>
#include <memory>
#include <set>
#include <sstream>
#include <system_error>
#include <utility>

#include "pongsim/program/nearest_word.hh"

namespace pongsim::ros2 {

namespace {

constexpr std::size_t kMostBytes = std::size_t{16} << 20U;
constexpr std::size_t kLargestDepth = 1'000'000;

/// Named QoS profiles, like those of rmw. Unset values are the defaults.
struct Profile {
  std::string_view name;
  DirectionRule rule;
};
const Profile kProfiles[] = {
    {"SENSOR_DATA", {.depth = 5, .isReliable = false, .isTransientLocal = false}},
    {"CLOCK", {.depth = 1, .isReliable = false, .isTransientLocal = false}},
    {"PARAMETERS", {.depth = 1000, .isReliable = true, .isTransientLocal = false}},
    {"PARAMETER_EVENTS", {.depth = 1000, .isReliable = true, .isTransientLocal = false}},
    {"ROSOUT", {.depth = 1000, .isReliable = true, .isTransientLocal = true}},
    {"SERVICES", {.depth = 10, .isReliable = true, .isTransientLocal = false}},
    {"SYSTEM_DEFAULT", {}},
    {"SYSTEM_DEFAULTS", {}},
    {"BEST_AVAILABLE", {}},
};

template <class Value>
struct Word {
  std::string_view word;
  Value value;
};
constexpr Word<Direction> kDirections[] = {{"BIDIRECTIONAL", Direction::kBoth},
                                           {"GZ_TO_ROS", Direction::kToRos},
                                           {"ROS_TO_GZ", Direction::kFromRos},
                                           {"IGN_TO_ROS", Direction::kToRos},
                                           {"ROS_TO_IGN", Direction::kFromRos}};
constexpr Word<bool> kReliabilities[] = {{"reliable", true}, {"best_effort", false}};
constexpr Word<bool> kDurabilities[] = {{"transient_local", true}, {"volatile", false}};

class Reading {
 public:
  Reading(std::string name, Diagnostics& diagnostics)
      : name_(std::make_shared<const std::string>(std::move(name))), diagnostics_(diagnostics) {}

  SourcePosition at(const YAML::Mark& mark) const {
    return mark.is_null() ? SourcePosition{name_, 0, 0} : SourcePosition{name_, mark.line + 1, mark.column + 1};
  }
  SourcePosition at(const YAML::Node& node) const { return at(node.Mark()); }
  SourcePosition whole() const { return {name_, 0, 0}; }

  void error(const SourcePosition& where, std::string message, std::string hint = {}) {
    diagnostics_.error(where, std::move(message), std::move(hint));
  }
  void warning(const SourcePosition& where, std::string message, std::string hint = {}) {
    diagnostics_.warning(where, std::move(message), std::move(hint));
  }

 private:
  std::shared_ptr<const std::string> name_;
  Diagnostics& diagnostics_;
};

/// Parses one map of the list.
class RuleMap {
 public:
  RuleMap(const YAML::Node& node, Reading& reading) : node_(node), reading_(reading) {}

  /// @return The rule, if it has no errors.
  std::optional<RuleText> read() {
    readKeys();
    rule_.position = reading_.at(node_);
    rule_.isService = service_ || rosService_ || ignitionService_;
    takeNames();
    takeQuality();
    if (!isFine_) return std::nullopt;
    return std::move(rule_);
  }

 private:
  using Take = void (RuleMap::*)(std::string_view key, const YAML::Node& value);
  struct Key {
    std::string_view name;
    Take take;
  };
  static const Key kKeys[];
  static const Key kQosKeys[];

  void fail(const SourcePosition& where, std::string message, std::string hint = {}) {
    reading_.error(where, std::move(message), std::move(hint));
    isFine_ = false;
  }

  void readKeys();
  void readMap(const YAML::Node& map, std::span<const Key> keys);
  void takeNames();
  void takeQuality();

  std::optional<GivenText> text(std::string_view key, const YAML::Node& value);
  std::optional<std::size_t> depth(std::string_view key, const YAML::Node& value);
  template <class Value, std::size_t N>
  std::optional<Value> word(std::string_view key, const YAML::Node& value, const Word<Value> (&words)[N]);
  /// Sets a value that a key with another name may have set before.
  void text(std::string_view key, const YAML::Node& value, std::optional<GivenText>& to);

  template <std::optional<GivenText> RuleMap::*target>
  void takeText(std::string_view key, const YAML::Node& value) {
    text(key, value, this->*target);
  }
  template <std::optional<GivenText> RuleText::*target>
  void takeRuleText(std::string_view key, const YAML::Node& value) {
    text(key, value, rule_.*target);
  }
  void takeDirection(std::string_view key, const YAML::Node& value);
  void takePublisherQueue(std::string_view key, const YAML::Node& value) { publisherQueue_ = depth(key, value); }
  void takeSubscriberQueue(std::string_view key, const YAML::Node& value) { subscriberQueue_ = depth(key, value); }
  void takeLazy(std::string_view key, const YAML::Node& value);
  void takeProfile(std::string_view key, const YAML::Node& value);
  void takeQos(std::string_view key, const YAML::Node& value);
  void takeReliability(std::string_view key, const YAML::Node& value) {
    isReliable_ = word(key, value, kReliabilities);
  }
  void takeDurability(std::string_view key, const YAML::Node& value) {
    isTransientLocal_ = word(key, value, kDurabilities);
  }
  void takeDepth(std::string_view key, const YAML::Node& value) {
    depthPosition_ = reading_.at(value);
    depth_ = depth(key, value);
  }

  const YAML::Node& node_;
  Reading& reading_;
  bool isFine_ = true;
  RuleText rule_;
  std::optional<GivenText> topic_, rosTopic_, ignitionTopic_, service_, rosService_, ignitionService_;
  std::optional<std::size_t> publisherQueue_, subscriberQueue_, depth_;
  SourcePosition depthPosition_;
  std::optional<bool> isLazy_, isReliable_, isTransientLocal_;
  std::optional<GivenText> direction_;
  std::optional<DirectionRule> profile_;
};

const RuleMap::Key RuleMap::kKeys[] = {
    {"topic_name", &RuleMap::takeText<&RuleMap::topic_>},
    {"ros_topic_name", &RuleMap::takeText<&RuleMap::rosTopic_>},
    {"gz_topic_name", &RuleMap::takeText<&RuleMap::ignitionTopic_>},
    {"ign_topic_name", &RuleMap::takeText<&RuleMap::ignitionTopic_>},
    {"ros_type_name", &RuleMap::takeRuleText<&RuleText::rosType>},
    {"gz_type_name", &RuleMap::takeRuleText<&RuleText::ignitionType>},
    {"ign_type_name", &RuleMap::takeRuleText<&RuleText::ignitionType>},
    {"direction", &RuleMap::takeDirection},
    {"publisher_queue", &RuleMap::takePublisherQueue},
    {"subscriber_queue", &RuleMap::takeSubscriberQueue},
    {"lazy", &RuleMap::takeLazy},
    {"qos_profile", &RuleMap::takeProfile},
    {"frame_id", &RuleMap::takeRuleText<&RuleText::frameId>},
    {"service_name", &RuleMap::takeText<&RuleMap::service_>},
    {"gz_req_type_name", &RuleMap::takeRuleText<&RuleText::requestType>},
    {"gz_rep_type_name", &RuleMap::takeRuleText<&RuleText::replyType>},
    // pongsim's own key
    {"qos", &RuleMap::takeQos},
    {"frame_prefix", &RuleMap::takeRuleText<&RuleText::framePrefix>},
    {"ros_service_name", &RuleMap::takeText<&RuleMap::rosService_>},
    {"gz_service_name", &RuleMap::takeText<&RuleMap::ignitionService_>},
};

const RuleMap::Key RuleMap::kQosKeys[] = {{"reliability", &RuleMap::takeReliability},
                                          {"durability", &RuleMap::takeDurability},
                                          {"depth", &RuleMap::takeDepth}};

void RuleMap::readKeys() { readMap(node_, kKeys); }

void RuleMap::readMap(const YAML::Node& map, std::span<const Key> keys) {
  std::set<std::string> seen;
  for (const auto& pair : map) {
    if (!pair.first.IsScalar()) {
      fail(reading_.at(pair.first), "a key must be a string");
      continue;
    }
    const std::string& key = pair.first.Scalar();
    const auto known = std::ranges::find(keys, key, &Key::name);
    if (known == keys.end()) {
      std::vector<std::string_view> names;
      for (const Key& each : keys) names.push_back(each.name);
      reading_.warning(reading_.at(pair.first), "key '" + key + "' is unknown and has no effect",
                       didYouMean(key, names));
    } else if (!seen.insert(key).second) {
      fail(reading_.at(pair.first), "key '" + key + "' is given twice");
    } else {
      (this->*known->take)(key, pair.second);
    }
  }
}

std::optional<GivenText> RuleMap::text(std::string_view key, const YAML::Node& value) {
  if (!value.IsScalar()) {
    fail(reading_.at(value), "'" + std::string(key) + "' must be a string");
    return std::nullopt;
  }
  // as in ros_gz, an empty name counts as missing
  if (value.Scalar().empty()) return std::nullopt;
  return GivenText{value.Scalar(), reading_.at(value)};
}

void RuleMap::text(std::string_view key, const YAML::Node& value, std::optional<GivenText>& to) {
  const std::optional<GivenText> said = text(key, value);
  if (said && to && said->text != to->text) {
    fail(said->position,
         "'" + std::string(key) + "' is '" + said->text + "', and '" + to->text + "' by its other name");
  }
  if (said && !to) to = said;
}

std::optional<std::size_t> RuleMap::depth(std::string_view key, const YAML::Node& value) {
  const std::string text = value.IsScalar() ? value.Scalar() : "";
  std::size_t number = 0;
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), number);
  if (text.empty() || error != std::errc() || end != text.data() + text.size() || number > kLargestDepth) {
    fail(reading_.at(value), "'" + std::string(key) + "' must be an integer between 1 and " +
                                 std::to_string(kLargestDepth) + (text.empty() ? "" : ", not '" + text + "'"));
    return std::nullopt;
  }
  if (number == 0) {
    reading_.warning(reading_.at(value), "'" + std::string(key) + "' is 0: 1 is used");
    number = 1;
  }
  return number;
}

template <class Value, std::size_t N>
std::optional<Value> RuleMap::word(std::string_view key, const YAML::Node& value, const Word<Value> (&words)[N]) {
  const std::string text = value.IsScalar() ? value.Scalar() : "";
  const auto found = std::ranges::find(words, text, &Word<Value>::word);
  if (found != std::end(words)) return found->value;
  std::vector<std::string_view> known;
  std::string all;
  for (const auto& each : words) {
    known.push_back(each.word);
    all += (all.empty() ? "" : ", ") + std::string(each.word);
  }
  const std::string hint = didYouMean(text, known);
  fail(reading_.at(value), "'" + std::string(key) + "' can't be '" + text + "'", hint.empty() ? "one of " + all : hint);
  return std::nullopt;
}

void RuleMap::takeDirection(std::string_view key, const YAML::Node& value) {
  if (const auto direction = word(key, value, kDirections)) rule_.direction = *direction;
  direction_ = GivenText{std::string(key), reading_.at(value)};
}

void RuleMap::takeLazy(std::string_view key, const YAML::Node& value) {
  bool isLazy = false;
  if (value.IsScalar() && YAML::convert<bool>::decode(value, isLazy)) {
    isLazy_ = isLazy;
  } else {
    fail(reading_.at(value), "'" + std::string(key) + "' must be true or false");
  }
}

void RuleMap::takeProfile(std::string_view key, const YAML::Node& value) {
  const std::optional<GivenText> name = text(key, value);
  if (!name) return;
  const auto found = std::ranges::find(kProfiles, name->text, &Profile::name);
  if (found != std::end(kProfiles)) {
    profile_ = found->rule;
    return;
  }
  std::vector<std::string_view> names;
  for (const Profile& each : kProfiles) names.push_back(each.name);
  const std::string hint = didYouMean(name->text, names);
  fail(name->position, "'" + name->text + "' is not a profile", hint.empty() ? "SENSOR_DATA, for example" : hint);
}

void RuleMap::takeQos(std::string_view key, const YAML::Node& value) {
  if (value.IsMap()) {
    readMap(value, kQosKeys);
  } else {
    fail(reading_.at(value), "'" + std::string(key) + "' must be a map", "qos: {reliability: reliable, depth: 5}");
  }
}

void RuleMap::takeNames() {
  const auto exclude = [this](const std::optional<GivenText>& one, const char* name,
                              const std::optional<GivenText>& other, const char* otherName) {
    if (one && other) {
      fail(other->position, std::string("'") + name + "' and '" + otherName + "' can't be used together");
    }
  };
  const bool isService = rule_.isService;
  const std::optional<GivenText>& both = isService ? service_ : topic_;
  const std::optional<GivenText>& ros = isService ? rosService_ : rosTopic_;
  const std::optional<GivenText>& ignition = isService ? ignitionService_ : ignitionTopic_;
  exclude(both, isService ? "service_name" : "topic_name", ros, isService ? "ros_service_name" : "ros_topic_name");
  exclude(both, isService ? "service_name" : "topic_name", ignition, isService ? "gz_service_name" : "gz_topic_name");
  rule_.ros = both ? both : ros ? ros : ignition;
  rule_.ignition = both ? both : ignition ? ignition : ros;
  if (!rule_.ros && isFine_) {
    fail(reading_.at(node_), "no topic name is given", "topic_name: NAME, or ros_topic_name and gz_topic_name");
  }
  const auto require = [this](const std::optional<GivenText>& word, const char* key, const char* example) {
    if (!word && isFine_) fail(reading_.at(node_), std::string("there is no '") + key + "'", example);
  };
  require(rule_.rosType, "ros_type_name",
          isService ? "ros_type_name: ros_gz_interfaces/srv/ControlWorld" : "ros_type_name: std_msgs/msg/String");
  if (!isService) {
    require(rule_.ignitionType, "gz_type_name", "gz_type_name: ignition.msgs.StringMsg");
    for (const auto& type : {rule_.requestType, rule_.replyType}) {
      if (type) fail(type->position, "a topic has no request and reply types", "for a service, use service_name");
    }
    return;
  }
  for (const auto& word :
       {topic_, rosTopic_, ignitionTopic_, rule_.ignitionType, rule_.frameId, rule_.framePrefix, direction_}) {
    if (word) fail(word->position, "a service has no topic, direction or frame");
  }
  if (rule_.requestType.has_value() != rule_.replyType.has_value()) {
    fail(reading_.at(node_), "give both the request and the reply type, or neither",
         "gz_req_type_name and gz_rep_type_name");
  }
}

void RuleMap::takeQuality() {
  DirectionRule all = profile_.value_or(DirectionRule());
  if (isReliable_) all.isReliable = isReliable_;
  if (isTransientLocal_) all.isTransientLocal = isTransientLocal_;
  if (depth_) all.depth = depth_;
  all.isLazy = isLazy_;
  rule_.toRos = rule_.fromRos = all;
  for (const auto& [queue, options, name] : {std::tuple(publisherQueue_, &rule_.toRos, "publisher_queue"),
                                             std::tuple(subscriberQueue_, &rule_.fromRos, "subscriber_queue")}) {
    if (!queue) continue;
    if (depth_ && *depth_ != *queue) {
      fail(depthPosition_,
           "the depth is " + std::to_string(*depth_) + ", and " + std::to_string(*queue) + " by '" + name + "'");
    }
    options->depth = queue;
  }
}

/// Records where documents begin.
class DocumentStart final : public YAML::EventHandler {
 public:
  const YAML::Mark& mark() const { return mark_; }

  void OnDocumentStart(const YAML::Mark& mark) override { mark_ = mark; }
  void OnDocumentEnd() override {}
  void OnNull(const YAML::Mark&, YAML::anchor_t) override {}
  void OnAlias(const YAML::Mark&, YAML::anchor_t) override {}
  void OnScalar(const YAML::Mark&, const std::string&, YAML::anchor_t, const std::string&) override {}
  void OnSequenceStart(const YAML::Mark&, const std::string&, YAML::anchor_t, YAML::EmitterStyle::value) override {}
  void OnSequenceEnd() override {}
  void OnMapStart(const YAML::Mark&, const std::string&, YAML::anchor_t, YAML::EmitterStyle::value) override {}
  void OnMapEnd() override {}

 private:
  YAML::Mark mark_;
};

/// @return Position of text that `YAML::Load` ignores: another document, or a line that does not belong to the first.
/// `YAML::LoadAll` loops forever on the latter.
std::optional<YAML::Mark> behindTheFirstDocument(std::string_view text) {
  std::istringstream stream{std::string(text)};
  YAML::Parser parser(stream);
  DocumentStart start;
  if (!parser.HandleNextDocument(start) || !parser.HandleNextDocument(start)) return std::nullopt;
  return start.mark();
}

}  // namespace

std::vector<RuleText> readBridgeText(std::string_view text, const std::string& name, Diagnostics& diagnostics) {
  Reading reading(name, diagnostics);
  std::vector<RuleText> rules;
  try {
    const YAML::Node list = YAML::Load(std::string(text));
    if (const auto rest = behindTheFirstDocument(text)) {
      reading.error(reading.at(*rest), "the indentation here is wrong",
                    "the file must be one list; check the beginning of the line");
    }
    if (!list.IsDefined() || list.IsNull()) {
      reading.error(reading.whole(), "the file is empty", "write each topic as a list item: - topic_name: NAME");
      return rules;
    }
    if (!list.IsSequence()) {
      reading.error(reading.at(list), "it is not a list", "write each topic as a list item: - topic_name: NAME");
      return rules;
    }
    for (const YAML::Node& item : list) {
      if (!item.IsMap()) {
        reading.error(reading.at(item), "an item of the list must be a map", "- topic_name: NAME");
        continue;
      }
      if (std::optional<RuleText> rule = RuleMap(item, reading).read()) rules.push_back(std::move(*rule));
    }
  } catch (const YAML::Exception& error) {
    reading.error(reading.at(error.mark), "it is not YAML: " + error.msg);
  }
  return rules;
}

std::vector<RuleText> readBridgeFile(const std::filesystem::path& file, Diagnostics& diagnostics) {
  const SourcePosition whole{std::make_shared<const std::string>(file.string()), 0, 0};
  std::error_code error;
  if (std::filesystem::is_directory(file, error)) {
    diagnostics.error(whole, "it is a folder, not a file");
    return {};
  }
  std::ifstream stream(file, std::ios::binary);
  if (!stream) {
    diagnostics.error(whole, "the file can't be read");
    return {};
  }
  std::string text(kMostBytes + 1, '\0');
  stream.read(text.data(), static_cast<std::streamsize>(text.size()));
  text.resize(static_cast<std::size_t>(stream.gcount()));
  if (text.size() > kMostBytes) {
    diagnostics.error(whole, "the file is larger than 16 MiB");
    return {};
  }
  return readBridgeText(text, file.string(), diagnostics);
}

}  // namespace pongsim::ros2
