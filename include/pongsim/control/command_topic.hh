#pragma once

#include <string>
#include <string_view>

#include "pongsim/declaration.hh"
#include "pongsim/parameters.hh"
#include "pongsim/system.hh"

namespace pongsim {

/// The parameters by which later releases of Gazebo choose where a system gets its command: `<topic>`, `<sub_topic>`,
/// and
/// `<use_actuator_msg>` with `<actuator_number>`.
struct CommandTopic {
  std::string topic;
  std::string subTopic;
  bool usesActuators = false;
  int actuator = -1;

  /// Adds the parameters.
  /// @param fallback Describes the default topic: "/model/M/cmd_vel".
  void declare(Declaration& declaration, std::string fallback) {
    declaration.parameter("topic", &topic, "", "command topic").otherwise(std::move(fallback));
    declaration.parameter("sub_topic", &subTopic, "", "the command topic is `/model/M/SUB_TOPIC`").otherwise("<topic>");
    declaration.parameter("use_actuator_msg", &usesActuators, "",
                          "the command is a number in an Actuators message; default topic: /actuators");
    declaration.parameter("actuator_number", &actuator, "", "its index in the message")
        .atLeast(0)
        .otherwise("none: a Double is expected");
  }

  /// Must be called first: without a number, Actuators messages can't be used.
  void check(const SystemContext& context) {
    if (!usesActuators || actuator >= 0) return;
    usesActuators = false;
    context.diagnostics.warning(context.sdf.child("use_actuator_msg")->position,
                                "<use_actuator_msg> has no effect: no <actuator_number> is given");
  }

  /// @param fallback The default topic of single numbers.
  /// @return The topic.
  std::string name(const SystemContext& context, std::string_view fallback) const {
    if (!topic.empty()) return cleanTopic(topic);
    if (!subTopic.empty()) return cleanTopic("/model/" + std::string(context.model->name()) + "/" + subTopic);
    return cleanTopic(usesActuators ? "/actuators" : fallback);
  }
};

}  // namespace pongsim
