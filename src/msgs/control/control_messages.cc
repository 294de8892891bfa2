#include "msgs/control/control_messages.hh"

#include <ignition/msgs/boolean.pb.h>
#include <ignition/msgs/double.pb.h>
#include <ignition/msgs/int32.pb.h>
#include <ignition/msgs/log_playback_control.pb.h>
#include <ignition/msgs/log_playback_stats.pb.h>
#include <ignition/msgs/server_control.pb.h>
#include <ignition/msgs/stringmsg.pb.h>
#include <ignition/msgs/stringmsg_v.pb.h>
#include <ignition/msgs/world_control.pb.h>

#include <algorithm>

#include "msgs/fields/time.hh"

namespace pongsim::msgs {

WorldControl worldControl(const Message& message) {
  const auto& asked = static_cast<const ignition::msgs::WorldControl&>(message);
  WorldControl control;
  control.pause = asked.pause();
  control.steps = asked.step() ? std::max(asked.multi_step(), 1U) : asked.multi_step();
  if (asked.has_run_to_sim_time()) control.runTo = timeOf(asked.run_to_sim_time());
  if (asked.reset().model_only()) control.reset = Reset::kModelsOnly;
  if (asked.reset().time_only()) control.reset = Reset::kTimeOnly;
  if (asked.reset().all()) control.reset = Reset::kAll;
  control.seed = asked.seed();
  return control;
}

PlaybackControl playbackControl(const Message& message) {
  const auto& asked = static_cast<const ignition::msgs::LogPlaybackControl&>(message);
  PlaybackControl control;
  control.run.pause = asked.pause();
  control.run.steps = static_cast<std::uint32_t>(std::max(asked.multi_step(), 0));
  control.rewind = asked.rewind();
  control.forward = asked.forward();
  if (asked.has_seek()) control.seek = timeOf(asked.seek());
  return control;
}

ServerControl serverControl(const Message& message) {
  const auto& asked = static_cast<const ignition::msgs::ServerControl&>(message);
  const bool more = !asked.save_world_name().empty() || !asked.save_filename().empty() ||
                    !asked.open_filename().empty() || asked.new_world() || asked.clone() || asked.new_port() != 0;
  return {asked.stop(), more};
}

void setBoolean(bool value, Message& message) { static_cast<ignition::msgs::Boolean&>(message).set_data(value); }

void setLogPlaybackStatistics(Time start, Time end, Message& message) {
  auto& statistics = static_cast<ignition::msgs::LogPlaybackStatistics&>(message);
  setTime(start, *statistics.mutable_start_time());
  setTime(end, *statistics.mutable_end_time());
}

void addString(const std::string& value, Message& stringMsgV) {
  static_cast<ignition::msgs::StringMsg_V&>(stringMsgV).add_data(value);
}

std::vector<std::string> strings(const Message& stringMsgV) {
  const auto& data = static_cast<const ignition::msgs::StringMsg_V&>(stringMsgV).data();
  return {data.begin(), data.end()};
}

void setString(const std::string& value, Message& stringMsg) {
  static_cast<ignition::msgs::StringMsg&>(stringMsg).set_data(value);
}

std::string string(const Message& stringMsg) { return static_cast<const ignition::msgs::StringMsg&>(stringMsg).data(); }

MessagePointer worldControlMessage(const WorldControl& control) {
  auto message = std::make_unique<ignition::msgs::WorldControl>();
  message->set_pause(control.pause);
  message->set_multi_step(control.steps);
  if (control.reset == Reset::kAll) message->mutable_reset()->set_all(true);
  message->set_seed(control.seed);
  if (control.runTo) setTime(*control.runTo, *message->mutable_run_to_sim_time());
  return MessagePointer(message.release());
}

bool boolean(const Message& message) { return static_cast<const ignition::msgs::Boolean&>(message).data(); }

double number(const Message& message) { return static_cast<const ignition::msgs::Double&>(message).data(); }

MessagePointer int32Message(std::int32_t value) {
  auto message = std::make_unique<ignition::msgs::Int32>();
  message->set_data(value);
  return MessagePointer(message.release());
}

}  // namespace pongsim::msgs
