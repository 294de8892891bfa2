#include "ros2/command/description_source.hh"

#include <algorithm>
#include <condition_variable>
#include <mutex>
#include <set>
#include <thread>
#include <vector>

#include "ros2/node/names.hh"
#include "ros2/node/parameters.hh"
#include "ros2/node/service.hh"
#include "ros2/types/rcl_interfaces.hh"
#include "ros2/types/std_msgs.hh"

namespace pongsim::ros2 {

namespace {

using Clock = std::chrono::steady_clock;
using GetParameters = rcl_interfaces::srv::GetParameters;

constexpr std::chrono::milliseconds kBetweenLooks{100};
// Grace period before the first message: a running node answers within it.
constexpr std::chrono::seconds kUnremarkable{1};

/// Prints each message once, and none in the first second.
class Remarks {
 public:
  explicit Remarks(const SearchOptions& options) : options_(options) {}
  void add(const std::string& text) {
    if (Clock::now() - start_ < kUnremarkable || !said_.insert(text).second || !options_.say) return;
    options_.say(text);
  }
  bool isLate() const { return options_.timeout && Clock::now() - start_ >= *options_.timeout; }

 private:
  const SearchOptions& options_;
  Clock::time_point start_ = Clock::now();
  std::set<std::string> said_;
};

/// @return Whether a node publishes it without keeping the last message, so that late subscribers get none.
bool isPublishedOnceOnly(RosNode& node, const std::string& topic) {
  return std::ranges::any_of(node.participant().graph().endpoints(), [&](const Graph::Endpoint& endpoint) {
    return endpoint.role == Graph::Role::kWriter && endpoint.contract.topic == topicOnWire(topic) &&
           !endpoint.contract.qos.isTransientLocal;
  });
}

}  // namespace

std::optional<std::string> descriptionFromTopic(RosNode& node, const std::string& topic, const SearchOptions& options) {
  std::mutex mutex;
  std::condition_variable changed;
  std::optional<std::string> description;
  const auto subscription = node.subscribe<std_msgs::String>(
      topic,
      [&](const std_msgs::String& message) {
        const std::lock_guard lock(mutex);
        description = message.data;
        changed.notify_all();
      },
      kLatchedQos);
  const std::string name = node.resolve(topic);
  Remarks remarks(options);
  std::unique_lock lock(mutex);
  while (!changed.wait_for(lock, kBetweenLooks, [&] { return description.has_value(); }) && !remarks.isLate()) {
    if (isPublishedOnceOnly(node, name)) {
      remarks.add("a node publishes '" + name +
                  "' but does not keep it for late subscribers: its durability is volatile, not transient local");
    }
    remarks.add("waiting for a message on '" + name + "'");
  }
  return description;
}

std::optional<std::string> descriptionFromParameter(RosNode& node, const std::string& owner,
                                                    const std::string& parameter, const SearchOptions& options) {
  const std::string ownerName = owner.empty() ? "" : absoluteName("/", owner);
  if (!ownerName.empty() && rosNameError(ownerName)) {
    throw std::invalid_argument("node '" + owner + "' " + *rosNameError(ownerName));
  }
  Remarks remarks(options);
  while (!remarks.isLate()) {
    std::set<std::string> services = parameterServices(node.participant().graph().endpoints());
    if (!ownerName.empty()) {
      std::erase_if(services, [&](const std::string& each) { return each != ownerName + std::string(kGetParameters); });
    }
    for (const std::string& service : services) {
      const auto response = RosClient<GetParameters>(node, service).call({{parameter}}, kUnremarkable);
      const std::string who = service.substr(0, service.size() - kGetParameters.size());
      if (!response) {
        remarks.add("node '" + who + "' does not answer");
      } else if (response->values.size() == 1 &&
                 response->values[0].type == rcl_interfaces::ParameterType::kParameterString) {
        return response->values[0].string_value;
      } else if (!ownerName.empty()) {
        remarks.add("node '" + who + "' has no parameter '" + parameter + "' of type string");
      }
    }
    remarks.add(ownerName.empty() ? "waiting for a node with a parameter '" + parameter + "'"
                                  : "waiting for the parameter '" + parameter + "' of node '" + ownerName + "'");
    std::this_thread::sleep_for(kBetweenLooks);
  }
  return std::nullopt;
}

}  // namespace pongsim::ros2
