#include "ros2/bridge/topics_service.hh"

#include <ignition/msgs/empty.pb.h>
#include <ignition/msgs/param_v.pb.h>

namespace pongsim::ros2 {

namespace {

using ignition::msgs::Any;

void set(ignition::msgs::Param& param, const char* name, std::string_view text) {
  Any& value = (*param.mutable_params())[name];
  value.set_type(Any::STRING);
  value.set_string_value(std::string(text));
}

void set(ignition::msgs::Param& param, const char* name, bool is) {
  Any& value = (*param.mutable_params())[name];
  value.set_type(Any::BOOLEAN);
  value.set_bool_value(is);
}

void setNumber(ignition::msgs::Param& param, const char* name, std::uint64_t number) {
  Any& value = (*param.mutable_params())[name];
  value.set_type(Any::DOUBLE);
  value.set_double_value(static_cast<double>(number));
}

}  // namespace

std::string topicsServiceOf(std::string_view world) {
  return cleanTopic("/world/" + std::string(world) + "/ros2/topics");
}

TopicsService::TopicsService(Node& simulation, std::string_view world, const Bridge& bridge)
    : service_(simulation.serve<ignition::msgs::Empty, ignition::msgs::Param_V>(
          topicsServiceOf(world), [&bridge](const ignition::msgs::Empty&, ignition::msgs::Param_V& reply) {
            for (const Bridge::Topic& topic : bridge.topics()) {
              if (!topic.isToRos && !topic.isFromRos) continue;
              ignition::msgs::Param& param = *reply.add_param();
              set(param, "ros", topic.ros);
              set(param, "ros_type", topic.pair->ros);
              set(param, "ignition", topic.ignition);
              set(param, "ignition_type", topic.pair->ignition);
              set(param, "to_ros", topic.isToRos);
              set(param, "from_ros", topic.isFromRos);
              setNumber(param, "readers", topic.readers);
              setNumber(param, "writers", topic.writers);
              setNumber(param, "sent", topic.sent);
              setNumber(param, "received", topic.received);
              setNumber(param, "dropped", topic.dropped);
              setNumber(param, "refused", topic.refused);
            }
            return true;
          })) {}

}  // namespace pongsim::ros2
