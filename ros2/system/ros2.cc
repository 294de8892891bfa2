#include <memory>
#include <optional>

#include "pongsim/system.hh"
#include "ros2/bridge/bridge.hh"
#include "ros2/bridge/simulation_parameters.hh"
#include "ros2/bridge/topics_service.hh"
#include "ros2/config/elements.hh"
#include "ros2/config/rules.hh"
#include "ros2/config/settings.hh"
#include "ros2/node/node.hh"
#include "ros2/node/rosout.hh"
#include "ros2/services/simulate_steps.hh"
#include "ros2/wire/participant.hh"

namespace pongsim::ros2 {

namespace {

class Ros2 final : public System {
 public:
  void declare(Declaration& declaration) override {
    declaration.is("Makes the simulation a node of ROS 2: its topics are there under their own names.",
                   Declaration::Place::kWorld);
    elements_.declare(declaration);
    declaration.serves("/world/W/ros2/topics", "ignition.msgs.Empty", "ignition.msgs.Param_V",
                       "what is bridged, for pongsim ros2 topics");
  }

  void configure(const SystemContext& context) override {
    const std::optional<Settings> settings = elements_.read(context.sdf, context.diagnostics);
    // the run does not begin
    if (!settings) return;
    settings_ = *settings;
    warnOfOtherWorlds(settings_.services, context.world.name(), context.diagnostics);
    participant_.emplace(settings_.participant);
    node_.emplace(*participant_, RosNode::Options{settings_.nodeName, settings_.nameSpace});
    rosout_.emplace(*node_);
    bridge_.emplace(context.node, *node_, settings_);
    parameters_.emplace(*node_, context.world, *bridge_, settings_);
    steps_.emplace(context.node, cleanTopic("/world/" + std::string(context.world.name()) + "/control"), *node_,
                   "~/simulate_steps");
    topics_.emplace(context.node, context.world.name(), *bridge_);
  }

  void preUpdate(const StepInfo& info) override {
    parameters_->preUpdate(info.time);
    steps_->preUpdate(info);
    node_->mailbox().dispatch();
    bridge_->update();
  }

  void postUpdate(const StepInfo& info) override { steps_->postUpdate(info); }
  void reset() override { steps_->reset(); }

 private:
  SettingsElements elements_;
  Settings settings_;
  // each speaks by the one before it
  std::optional<Participant> participant_;
  std::optional<RosNode> node_;
  std::optional<Rosout> rosout_;
  std::optional<Bridge> bridge_;
  std::optional<SimulationParameters> parameters_;
  std::optional<SimulateSteps> steps_;
  std::optional<TopicsService> topics_;
};

}  // namespace

}  // namespace pongsim::ros2

PONGSIM_EXPORT_SYSTEM(pongsim::ros2::Ros2, "pongsim::systems::Ros2");
