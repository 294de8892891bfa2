#include <ignition/msgs/empty.pb.h>
#include <ignition/msgs/scene.pb.h>
#include <ignition/msgs/serialized_map.pb.h>
#include <ignition/msgs/stringmsg.pb.h>
#include <ignition/msgs/uint32_v.pb.h>

#include <algorithm>
#include <chrono>
#include <cstddef>
#include <cstdint>
#include <iterator>
#include <memory>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "pongsim/background_calls.hh"
#include "pongsim/parameters.hh"
#include "pongsim/scene.hh"
#include "pongsim/system.hh"
#include "pose_topic.hh"

namespace pongsim {

namespace {

namespace im = ignition::msgs;

/// Limit of states that wait for their services to be called: each may be large.
constexpr std::size_t kMostCallbacks = 8;

/// Publishes the world's scene, poses and state.
class SceneBroadcaster : public System {
 public:
  void declare(Declaration& declaration) override {
    declaration.is("Publishes the world's scene, poses and state.", Declaration::Place::kWorld);
    declaration.parameter("dynamic_pose_hertz", &poseRate_, "Hz", "pose messages per simulated second").above(0);
    declaration.parameter("state_hertz", &stateRate_, "Hz", "state messages per simulated second").above(0);
    declaration.publishes("/world/W/pose/info", "ignition.msgs.Pose_V",
                          "models, links, visuals and lights, relative to their parents");
    declaration.publishes("/world/W/dynamic_pose/info", "ignition.msgs.Pose_V", "models and links that are not static");
    declaration.publishes("/world/W/scene/info", "ignition.msgs.Scene",
                          "new models and lights; late subscribers get all of them");
    declaration.publishes("/world/W/scene/deletion", "ignition.msgs.UInt32_V", "ids of removed models and lights");
    declaration.publishes("/world/W/state", "ignition.msgs.SerializedStepMap",
                          "moving entities; everything after changes");
    declaration.serves("/world/W/scene/info", "ignition.msgs.Empty", "ignition.msgs.Scene", "all models and lights");
    declaration.serves("/world/W/scene/graph", "ignition.msgs.Empty", "ignition.msgs.StringMsg",
                       "the tree of entities, as text for Graphviz");
    declaration.serves("/world/W/state", "ignition.msgs.Empty", "ignition.msgs.SerializedStepMap",
                       "all entities with their components");
    declaration.serves("/world/W/state_async", "ignition.msgs.StringMsg", "ignition.msgs.Empty",
                       "sends the state to the service named in the request, which responds with Empty");
  }

  void configure(const SystemContext& context) override {
    poses_ = Schedule(periodOf(poseRate_));
    states_ = Schedule(periodOf(stateRate_));
    world_ = &context.world;
    scene_.emplace(context.world);
    calls_.emplace(context.node, context.log, kMostCallbacks);

    const std::string prefix = cleanTopic("/world/" + std::string(context.world.name()));
    allPoses_.open(context.node, prefix + "/pose/info");
    movingPoses_.open(context.node, prefix + "/dynamic_pose/info");
    scenePublisher_ = context.node.advertise<im::Scene>(prefix + "/scene/info");
    deletionPublisher_ = context.node.advertise<im::UInt32_V>(prefix + "/scene/deletion");
    statePublisher_ = context.node.advertise<im::SerializedStepMap>(prefix + "/state");
    offer(context.node, prefix);
    tellOfChanges();
  }

  void postUpdate(const StepInfo& info) override {
    isPaused_ = info.paused;
    if (hasToTell_) tellOfChanges();
    if (scenePublisher_.newSubscribers() > 0) {
      im::Scene message;
      scene_->fillIn(message);
      scenePublisher_.publish(message);
    }
    if (poses_.isDue(info.time) || info.paused) {
      allPoses_.publish(info.time);
      movingPoses_.publish(info.time);
    }
    // every third time while paused, about 30 Hz
    const bool isDue = states_.isDue(info.time) || (info.paused && pausedSteps_++ % 3 == 0);
    if (hasChanged_ || isDue) publishState(info);
  }

  void reset() override {
    poses_.reset();
    states_.reset();
    hasChanged_ = true;
  }

  void transfer(StateArchive& archive) override {
    poses_.transfer(archive);
    states_.transfer(archive);
  }

  // published once per step, however much was inserted and removed
  void worldChanged() override {
    hasToTell_ = true;
    hasChanged_ = true;
  }

 private:
  void offer(Node& node, const std::string& prefix) {
    services_.push_back(node.serve<im::Empty, im::Scene>(prefix + "/scene/info", [this](const auto&, auto& reply) {
      scene_->fillIn(reply);
      return true;
    }));
    services_.push_back(node.serve<im::Empty, im::StringMsg>(prefix + "/scene/graph", [this](const auto&, auto& reply) {
      reply.set_data(scene_->graph());
      return true;
    }));
    services_.push_back(
        node.serve<im::Empty, im::SerializedStepMap>(prefix + "/state", [this](const auto&, auto& reply) {
          scene_->fillInState(reply, StateContent::kAll, isPaused_);
          return true;
        }));
    services_.push_back(node.serve<im::StringMsg, im::Empty>(
        prefix + "/state_async", [this](const auto& request, auto&) { return sendState(request.data()); }));
  }

  ServiceAnswer sendState(const std::string& service) {
    if (service.empty()) return ServiceAnswer::refused("the request has no service");
    auto state = std::make_shared<im::SerializedStepMap>();
    scene_->fillInState(*state, StateContent::kAll, isPaused_);
    const bool isPosted = calls_->post({.service = service,
                                        .request = std::move(state),
                                        .replyType = im::Empty::descriptor()->full_name(),
                                        .timeout = std::chrono::seconds(5)});
    return isPosted ? true : ServiceAnswer::refused("too many requests for the state are waiting");
  }

  void publishState(const StepInfo& info) {
    const StateContent content = std::exchange(hasChanged_, false) ? StateContent::kAll : StateContent::kMoving;
    if (!statePublisher_.hasSubscribers()) return;
    im::SerializedStepMap message;
    scene_->fillInState(message, content, info.paused);
    statePublisher_.publish(message);
  }

  /// Entities inserted and removed since the last time.
  void tellOfChanges() {
    hasToTell_ = false;
    allPoses_.tellOf(*world_, false);
    movingPoses_.tellOf(*world_, true);
    std::vector<std::uint64_t> now = scene_->topLevelIds();
    std::vector<std::uint64_t> come, gone;
    std::ranges::set_difference(now, known_, std::back_inserter(come));
    std::ranges::set_difference(known_, now, std::back_inserter(gone));
    known_ = std::move(now);
    if (!come.empty() && scenePublisher_.hasSubscribers()) {
      im::Scene message;
      scene_->fillIn(message, [&come](std::uint64_t id) { return std::ranges::binary_search(come, id); });
      scenePublisher_.publish(message);
    }
    if (gone.empty()) return;
    im::UInt32_V message;
    for (const std::uint64_t id : gone) message.add_data(static_cast<std::uint32_t>(id));
    deletionPublisher_.publish(message);
  }

  double poseRate_ = 60;
  double stateRate_ = 60;
  World* world_ = nullptr;
  std::optional<Scene> scene_;
  Schedule poses_;
  Schedule states_;
  PoseTopic allPoses_;
  PoseTopic movingPoses_;
  Publisher scenePublisher_;
  Publisher deletionPublisher_;
  Publisher statePublisher_;
  std::optional<BackgroundCalls> calls_;
  std::vector<Service> services_;
  /// Ids of the published models and lights, in ascending order.
  std::vector<std::uint64_t> known_;
  bool hasChanged_ = true;
  bool hasToTell_ = false;
  bool isPaused_ = true;
  std::uint64_t pausedSteps_ = 0;
};

}  // namespace

}  // namespace pongsim

PONGSIM_EXPORT_SYSTEM(pongsim::SceneBroadcaster, "ignition::gazebo::systems::SceneBroadcaster",
                      "gz::sim::systems::SceneBroadcaster");
