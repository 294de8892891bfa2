#include <cstdint>
#include <memory>
#include <optional>
#include <string>
#include <utility>

#include "pongsim/system.hh"
#include "ros2/bridge/bridge.hh"
#include "ros2/bridge/noise_variances.hh"
#include "ros2/bridge/simulation_parameters.hh"
#include "ros2/bridge/topics_service.hh"
#include "ros2/config/distro.hh"
#include "ros2/config/elements.hh"
#include "ros2/config/rules.hh"
#include "ros2/config/settings.hh"
#include "ros2/controllers/ros_home.hh"
#include "ros2/node/node.hh"
#include "ros2/node/rosout.hh"
#include "ros2/node/type_descriptions.hh"
#include "ros2/robot/robots.hh"
#include "ros2/services/services.hh"
#include "ros2/wire/participant.hh"

namespace pongsim::ros2 {

namespace {

class Ros2 final : public System, public RosHost {
 public:
  void declare(Declaration& declaration) override {
    declaration.is("Makes the simulation a ROS 2 node, which bridges its topics under their own names.",
                   Declaration::Place::kWorld);
    declaration.standsOutside();
    elements_.declare(declaration);
    robotSettings_.declare(declaration);
    declaration.parameter(
        "service_prefix", &servicePrefix_, "",
        "prefix of the services of simulation_interfaces: ~ for the node's own name, /gzserver, or /");
    declaration.serves("/world/W/ros2/topics", "ignition.msgs.Empty", "ignition.msgs.Param_V",
                       "what is bridged, for pongsim ros2 topics");
  }

  void configure(const SystemContext& context) override {
    if (context.sdf.attributeOr("beside_others", "") == "true") elements_.nameAfter(context.world.name(), context.sdf);
    const std::optional<Settings> settings = elements_.read(context.sdf, context.diagnostics);
    // the run does not start
    if (!settings) return;
    home_->settings = settings_ = *settings;
    if (!settings_.bridgesAll) robotSettings_.leaveOutUnnamed(context.sdf);
    warnOfOtherWorlds(settings_.services, context.world.name(), context.diagnostics);
    home_->tellsTransforms = robotSettings_.tellsTransforms;
    home_->participant.emplace(settings_.participant);
    node_ = &home_->node.emplace(*home_->participant, RosNode::Options{settings_.nodeName, settings_.nameSpace,
                                                                       shipsOlderInterfaces(settings_.distro)});
    node_->log().info("node '" + node_->fullName() + "' in domain " + std::to_string(settings_.participant.domain));
    rosout_.emplace(*node_);
    typeDescriptions_ = offerTypeDescriptions(*node_);
    bridge_.emplace(context.node, *node_, settings_);
    bridge_->useVariances([world = context.world] { return noiseVariances(world); });
    parameters_.emplace(*node_, context.world, *bridge_, settings_);
    robots_.emplace(context.world, context.node, *node_, *bridge_, settings_, robotSettings_);
    services_.emplace(*node_, context, servicePrefix_, settings_);
    topics_.emplace(context.node, context.world.name(), *bridge_);
  }

  std::shared_ptr<RosHome> home() const override { return node_ == nullptr ? nullptr : home_; }

  void preUpdate(const StepInfo& info) override {
    if (std::exchange(knownReplaced_, home_->version()) != home_->version()) robots_->leave(home_->replaced());
    parameters_->preUpdate(info.time);
    services_->preUpdate(info);
    node_->mailbox().dispatch();
    bridge_->update();
    robots_->preUpdate(info.time);
  }

  void postUpdate(const StepInfo& info) override {
    services_->postUpdate(info);
    if (!info.paused) robots_->postUpdate(info.time);
  }

  void worldChanged() override {
    robots_->worldChanged();
    services_->worldChanged();
  }

  void reset() override {
    robots_->reset();
    services_->reset();
  }

 private:
  SettingsElements elements_;
  RobotSettings robotSettings_;
  std::string servicePrefix_ = "~";
  Settings settings_;
  // each uses the one before it
  std::shared_ptr<RosHome> home_ = std::make_shared<RosHome>();
  RosNode* node_ = nullptr;
  std::uint64_t knownReplaced_ = 0;
  std::optional<Rosout> rosout_;
  std::unique_ptr<RosServer> typeDescriptions_;
  std::optional<Bridge> bridge_;
  std::optional<SimulationParameters> parameters_;
  std::optional<Robots> robots_;
  std::optional<Services> services_;
  std::optional<TopicsService> topics_;
};

}  // namespace

}  // namespace pongsim::ros2

PONGSIM_EXPORT_SYSTEM(pongsim::ros2::Ros2, "pongsim::systems::Ros2");
