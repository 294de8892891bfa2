#include "sim/running/server_services.hh"

#include <utility>

#include "msgs/control/control_messages.hh"

namespace pongsim::sim {

ServerServices::ServerServices(Transport& transport, std::vector<std::string> worlds, std::function<void()> stop)
    : names_(std::move(worlds)), stop_(std::move(stop)) {
  Node node = transport.node();
  worlds_ = node.serve("/gazebo/worlds", "ignition.msgs.Empty", "ignition.msgs.StringMsg_V",
                       [this](const Message&, Message& reply) {
                         for (const std::string& name : names_) msgs::addString(name, reply);
                         return true;
                       });
  control_ = node.serve("/server_control", "ignition.msgs.ServerControl", "ignition.msgs.Boolean",
                        [this](const Message& request, Message& reply) {
                          msgs::setBoolean(true, reply);
                          return control(request);
                        });
}

ServiceAnswer ServerServices::control(const Message& request) const {
  const msgs::ServerControl asked = msgs::serverControl(request);
  if (asked.more || !asked.stop) return ServiceAnswer::refused("only 'stop: true' is supported");
  stop_();
  return true;
}

}  // namespace pongsim::sim
