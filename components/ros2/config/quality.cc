#include "ros2/config/quality.hh"

namespace pongsim::ros2 {

namespace {

constexpr std::size_t kTransformDepth = 100;

Qos withWishes(Qos qos, const DirectionRule& wishes) {
  qos.depth = wishes.depth.value_or(qos.depth);
  qos.isReliable = wishes.isReliable.value_or(qos.isReliable);
  qos.isTransientLocal = wishes.isTransientLocal.value_or(qos.isTransientLocal);
  return qos;
}

}  // namespace

Qos writerQos(const TopicRule& rule, bool isLatched) {
  Qos qos = isLatched ? kLatchedQos : kDefaultQos;
  if (rule.pair->ros == "tf2_msgs/msg/TFMessage" && !isLatched) qos.depth = kTransformDepth;
  return withWishes(qos, rule.toRos);
}

Qos readerQos(const TopicRule& rule) { return withWishes(kAnyWriterQos, rule.fromRos); }

bool isLazyToRos(const TopicRule& rule, bool isLatched) {
  return rule.toRos.isLazy.value_or(!writerQos(rule, isLatched).isTransientLocal);
}

bool isLazyFromRos(const TopicRule& rule) { return rule.fromRos.isLazy.value_or(false); }

}  // namespace pongsim::ros2
