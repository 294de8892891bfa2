#include <memory>
#include <optional>
#include <stdexcept>
#include <string>

#include "pongsim/system.hh"
#include "ros2/bridge/bridge.hh"
#include "ros2/config/environment.hh"
#include "ros2/config/settings.hh"
#include "ros2/node/node.hh"
#include "ros2/services/services.hh"
#include "ros2/wire/participant.hh"

namespace pongsim::ros2 {

namespace {

class Ros2 final : public System {
 public:
  void declare(Declaration& declaration) override {
    declaration.is("Makes the simulation a node of ROS 2: its topics are there under their own names.",
                   Declaration::Place::kWorld);
    declaration.parameter("domain", &domain_, "", "number of the domain, 0 to 232; else what ROS_DOMAIN_ID says")
        .otherwise("$ROS_DOMAIN_ID, else 0");
    declaration.parameter("distro", &distro_, "", "distribution of ROS whose nodes are met, as humble or jazzy")
        .otherwise("$ROS_DISTRO, else humble");
    declaration.parameter("node_name", &settings_.nodeName, "", "name of the node");
    declaration.parameter("namespace", &settings_.nameSpace, "", "in front of the names of node and topics, as /robot");
    declaration.parameter("frame_prefix", &settings_.frames.prefix, "", "in front of all frames, as robot/");
    declaration.parameter("bridge_all", &settings_.bridgesAll, "",
                          "whether all topics that have a type in ROS are there, or those only that are named");
    declaration.parameter(
        "service_prefix", &servicePrefix_, "",
        "in front of the services of simulation_interfaces: ~ for the node's own name, /gzserver, or /");
  }

  void configure(const SystemContext& context) override {
    settings_.participant = participantOptionsOfEnvironment();
    if (domain_) settings_.participant.domain = static_cast<int>(*domain_);
    if (!distro_.empty()) {
      const std::optional<Distro> known = distroNamed(distro_);
      if (!known)
        throw std::invalid_argument("'" + distro_ + "' is no distribution of ROS 2: humble or jazzy, for example");
      settings_.participant.distro = *known;
    }
    participant_.emplace(settings_.participant);
    node_.emplace(*participant_, RosNode::Options{settings_.nodeName, settings_.nameSpace});
    // a run that is paused need not sleep on while a request waits
    node_->mailbox().whenPosted([simulation = context.node]() mutable { simulation.wake(); });
    bridge_.emplace(context.node, *node_, settings_);
    services_.emplace(*node_, context, servicePrefix_, settings_.frames);
  }

  void preUpdate(const StepInfo& info) override {
    services_->preUpdate(info);
    node_->mailbox().dispatch();
    bridge_->update();
  }
  void postUpdate(const StepInfo& info) override { services_->postUpdate(info); }
  void worldChanged() override { services_->worldChanged(); }
  void reset() override { services_->reset(); }

 private:
  Settings settings_;
  std::optional<double> domain_;
  std::string distro_;
  std::string servicePrefix_ = "~";
  // each speaks by the one before it
  std::optional<Participant> participant_;
  std::optional<RosNode> node_;
  std::optional<Bridge> bridge_;
  std::optional<Services> services_;
};

}  // namespace

}  // namespace pongsim::ros2

PONGSIM_EXPORT_SYSTEM(pongsim::ros2::Ros2, "pongsim::systems::Ros2");
