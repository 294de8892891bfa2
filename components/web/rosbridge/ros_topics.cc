#include "web/rosbridge/ros_topics.hh"

namespace pongsim::web::rosbridge {

namespace {

constexpr std::size_t kMostNames = 10000;

}  // namespace

std::string fullRosType(std::string_view type) {
  const std::size_t slash = type.find('/');
  if (slash == std::string_view::npos || type.find('/', slash + 1) != std::string_view::npos) return std::string(type);
  return std::string(type.substr(0, slash)) + "/msg" + std::string(type.substr(slash));
}

bool RosTopics::open() {
  if (isOpened_) return encoding_ != nullptr;
  isOpened_ = true;
  Diagnostics diagnostics;
  encoding_ = makeMessageEncoder("ros2", {}, diagnostics);
  if (encoding_) return true;
  fault_ = "types of ROS can't be used";
  for (const Diagnostic& each : diagnostics.all()) {
    fault_ += ": " + each.message + (each.hint.empty() ? "" : "; " + each.hint);
  }
  return false;
}

const std::string& RosTopics::fault() {
  open();
  return fault_;
}

const RosTopics::Names& RosTopics::namesOf(const Topic& topic) {
  // names of topics that no longer exist
  if (names_.size() > kMostNames) names_.clear();
  const auto [entry, isNew] = names_.try_emplace({topic.name, topic.type});
  if (!isNew) return entry->second;
  const auto opened = encoding_->openTopic(topic.name, topic.type);
  if (const auto* encoder = std::get_if<std::unique_ptr<TopicEncoder>>(&opened)) {
    for (const EncodedTopic& each : (*encoder)->topics()) entry->second.emplace_back(each.name, each.type);
  }
  return entry->second;
}

std::vector<RosTopic> RosTopics::all() {
  std::vector<RosTopic> topics;
  if (!open()) return topics;
  for (const Worlds::TopicPlace& place : worlds_->topics()) {
    const Names& names = namesOf(place.topic);
    for (std::size_t i = 0; i < names.size(); ++i) topics.push_back({names[i].first, names[i].second, place, i});
  }
  return topics;
}

std::vector<RosTopic> RosTopics::find(std::string_view name) {
  std::vector<RosTopic> found = all();
  std::erase_if(found, [&](const RosTopic& topic) { return topic.name != name; });
  return found;
}

std::unique_ptr<TopicEncoder> RosTopics::encoder(const RosTopic& topic) {
  if (!open()) return nullptr;
  auto opened = encoding_->openTopic(topic.place.topic.name, topic.place.topic.type);
  auto* encoder = std::get_if<std::unique_ptr<TopicEncoder>>(&opened);
  return encoder == nullptr ? nullptr : std::move(*encoder);
}

std::variant<std::unique_ptr<TopicDecoder>, std::string> RosTopics::decoder(std::string_view rosType,
                                                                            std::string_view type) {
  if (!open()) return fault_;
  auto* const reader = dynamic_cast<MessageDecoder*>(encoding_.get());
  if (reader == nullptr) return "messages of types of ROS can't be read";
  return reader->openInput(fullRosType(rosType), type);
}

std::string RosTopics::definition(const RosTopic& topic) {
  const std::unique_ptr<TopicEncoder> opened = encoder(topic);
  return opened ? opened->topics()[topic.index].schema : std::string();
}

}  // namespace pongsim::web::rosbridge
