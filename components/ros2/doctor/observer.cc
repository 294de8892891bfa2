#include "ros2/doctor/observer.hh"

#include <algorithm>
#include <set>
#include <thread>

#include "ros2/node/parameters.hh"
#include "ros2/node/service.hh"
#include "ros2/node/stamp.hh"
#include "ros2/types/cdr.hh"
#include "ros2/types/nav_msgs.hh"
#include "ros2/types/rcl_interfaces.hh"
#include "ros2/types/rosgraph_msgs.hh"
#include "ros2/types/sensor_msgs.hh"
#include "ros2/types/std_msgs.hh"
#include "ros2/types/tf2_msgs.hh"

namespace pongsim::ros2 {

namespace {

using Clock = std::chrono::steady_clock;
using GetParameters = rcl_interfaces::srv::GetParameters;

constexpr std::chrono::seconds kAllNodesTime{5};
constexpr std::chrono::milliseconds kBetweenSubscriptions{100};
// A node that spins answers at once.
constexpr std::chrono::seconds kParameterAnswerTime{1};

double secondsOf(const builtin_interfaces::Time& time) { return toSeconds(timeOf(time)); }

bool areZero(const auto& variances) {
  return std::ranges::all_of(variances, [](double each) { return each == 0; });
}

bool lacksVariances(const auto&) { return false; }
bool lacksVariances(const sensor_msgs::Imu& imu) {
  return areZero(imu.angular_velocity_covariance) && areZero(imu.linear_acceleration_covariance);
}
bool lacksVariances(const sensor_msgs::NavSatFix& fix) {
  return fix.position_covariance_type == sensor_msgs::NavSatFix::kCovarianceTypeUnknown;
}
bool lacksVariances(const nav_msgs::Odometry& odometry) {
  return areZero(odometry.pose.covariance) && areZero(odometry.twist.covariance);
}

}  // namespace

Observer::Observer(RosNode& node) : node_(node), nodes_(node.participant()) {}
Observer::~Observer() = default;

template <class Message>
void Observer::receiveStream(const std::string& topic, const Message& message, const Guid&) {
  const std::lock_guard lock(mutex_);
  StreamSeen& stream = seen_.streams[topic];
  stream.type = nameOf<Message>();
  stream.stamps.add(secondsOf(message.header.stamp));
  if constexpr (!std::is_same_v<Message, sensor_msgs::JointState>) stream.frames.insert(message.header.frame_id);
  if constexpr (requires { message.child_frame_id; }) stream.childFrames.insert(message.child_frame_id);
  if constexpr (requires { message.name; }) stream.joints.insert(message.name.begin(), message.name.end());
  stream.lacksVariances = lacksVariances(message);
}

template <class Message>
void Observer::receiveTransforms(const std::string& topic, const Message& message, const Guid& writer) {
  const std::lock_guard lock(mutex_);
  for (const geometry_msgs::TransformStamped& each : message.transforms) {
    FrameSeen& frame = seen_.frames[each.child_frame_id];
    frame.parents.insert(each.header.frame_id);
    frame.publishers.insert(writer);
    frame.isStatic = topic.ends_with("_static");
    frame.stamps.add(secondsOf(each.header.stamp));
  }
}

template <class Message>
void Observer::receiveClock(const std::string&, const Message& message, const Guid&) {
  const std::lock_guard lock(mutex_);
  seen_.clock.add(secondsOf(message.clock));
}

template <class Message>
void Observer::receiveText(const std::string& topic, const Message& message, const Guid&) {
  const std::lock_guard lock(mutex_);
  seen_.descriptions[topic] = message.data;
}

/// What all writers of the topic offer, so that nothing is lost that need not be.
Qos Observer::qosOf(const std::string& topic) const {
  Qos qos{.isReliable = true, .isTransientLocal = true, .depth = 100};
  for (const Graph::Endpoint& each :
       node_.participant().graph().endpointsOn(topicOnWire(topic), Graph::Role::kWriter)) {
    qos.isReliable &= each.contract.qos.isReliable;
    qos.isTransientLocal &= each.contract.qos.isTransientLocal;
  }
  return qos;
}

template <class Message>
void Observer::openFor(const std::string& topic,
                       void (Observer::*receive)(const std::string&, const Message&, const Guid&)) {
  auto& subscription = subscriptions_[topic + " " + nameOf<Message>()];
  if (subscription) return;
  const auto received = [this, topic, receive, message = Message()](const Sample& sample) mutable {
    if (!readCdr(sample.payload, message)) (this->*receive)(topic, message, sample.id.writer);
  };
  subscription = std::make_unique<RosSubscription>(node_, topic, typeInfo<Message>(), qosOf(topic), received);
}

void Observer::open(const std::string& topic, const std::string& type) {
  const auto stream = [&]<class Message>(Message) {
    if (type == nameOf<Message>()) openFor<Message>(topic, &Observer::receiveStream<Message>);
  };
  stream(sensor_msgs::LaserScan());
  stream(sensor_msgs::PointCloud2());
  stream(sensor_msgs::Image());
  stream(sensor_msgs::CameraInfo());
  stream(sensor_msgs::Imu());
  stream(sensor_msgs::MagneticField());
  stream(sensor_msgs::NavSatFix());
  stream(sensor_msgs::JointState());
  stream(nav_msgs::Odometry());
  if (type == nameOf<tf2_msgs::TFMessage>()) {
    if (topic == "/tf" || topic == "/tf_static") {
      openFor<tf2_msgs::TFMessage>(topic, &Observer::receiveTransforms<tf2_msgs::TFMessage>);
    }
  } else if (type == nameOf<rosgraph_msgs::Clock>()) {
    if (topic == "/clock") openFor<rosgraph_msgs::Clock>(topic, &Observer::receiveClock<rosgraph_msgs::Clock>);
  } else if (type == nameOf<std_msgs::String>() && topic.ends_with("/robot_description")) {
    openFor<std_msgs::String>(topic, &Observer::receiveText<std_msgs::String>);
  }
}

void Observer::subscribe() {
  const RosNode::Quiet quiet(node_);
  for (const Graph::Endpoint& each : node_.participant().graph().endpoints()) {
    const auto topic = topicFromWire(each.contract.topic);
    if (topic && each.role == Graph::Role::kWriter) open(*topic, rosTypeName(each.contract.type));
  }
}

void Observer::watch(std::chrono::nanoseconds time) {
  nodes_.settle(kAllNodesTime);
  // nodes may begin to publish while they are watched
  for (const Clock::time_point end = Clock::now() + time; Clock::now() < end;) {
    subscribe();
    std::this_thread::sleep_for(std::min<std::chrono::nanoseconds>(kBetweenSubscriptions, end - Clock::now()));
  }
}

Observation Observer::observation() {
  const std::vector<Graph::Endpoint> endpoints = node_.participant().graph().endpoints();
  std::vector<std::string> onWallTime;
  for (const std::string& service : parameterServices(endpoints)) {
    const auto answer = RosClient<GetParameters>(node_, service).call({{"use_sim_time"}}, kParameterAnswerTime);
    if (!answer || answer->values.size() != 1) continue;
    const rcl_interfaces::ParameterValue& value = answer->values.front();
    if (value.type == rcl_interfaces::ParameterType::kParameterBool && !value.bool_value) {
      onWallTime.push_back(service.substr(0, service.size() - kGetParameters.size()));
    }
  }
  const std::lock_guard lock(mutex_);
  Observation seen = seen_;
  seen.endpoints = endpoints;
  seen.nodes = nodes_.nodes();
  seen.onWallTime = std::move(onWallTime);
  return seen;
}

}  // namespace pongsim::ros2
