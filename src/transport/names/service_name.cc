#include "transport/names/service_name.hh"

#include <stdexcept>

#include "pongsim/node.hh"
#include "transport/names/topic_name.hh"

namespace pongsim::transport {

namespace {

constexpr std::string_view kRequests = "pongsim/request";
constexpr std::string_view kReplies = "pongsim/reply";
constexpr std::string_view kBetweenTypes = " -> ";

// With what stands before it, what DDS can tell others as a topic's name.
constexpr std::size_t kLongestServiceName = 230;

}  // namespace

std::string requestTopic(std::string_view service) { return std::string(kRequests) + std::string(service); }

std::string replyTopic(std::string_view service) { return std::string(kReplies) + std::string(service); }

std::string serviceType(std::string_view requestType, std::string_view replyType) {
  return std::string(requestType) + std::string(kBetweenTypes) + std::string(replyType);
}

std::optional<std::string_view> serviceOfRequestTopic(std::string_view topic) {
  if (!topic.starts_with(kRequests)) return std::nullopt;
  topic.remove_prefix(kRequests.size());
  if (!topic.starts_with('/')) return std::nullopt;
  return topic;
}

std::optional<std::pair<std::string_view, std::string_view>> typesOfService(std::string_view type) {
  const std::size_t place = type.find(kBetweenTypes);
  if (place == std::string_view::npos) return std::nullopt;
  return std::pair(type.substr(0, place), type.substr(place + kBetweenTypes.size()));
}

std::string absoluteService(std::string_view name) {
  std::optional<std::string> error = topicNameError(name);
  if (!error && name.size() > kLongestServiceName) error = "is longer than 230 characters";
  if (error) throw std::invalid_argument("'" + std::string(name) + "' is not a service name: it " + *error);
  return absoluteTopic(name);
}

}  // namespace pongsim::transport
