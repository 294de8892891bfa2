#include <ignition/msgs/pose_v.pb.h>

#include <algorithm>
#include <iterator>
#include <string>
#include <utility>
#include <vector>

#include "pongsim/fields.hh"
#include "pongsim/parameters.hh"
#include "pongsim/system.hh"

namespace pongsim {

namespace {

/// A topic with the poses of some models and of their links, each in the frame of what holds it: models before links,
/// as Fortress orders them.
class PoseTopic {
 public:
  void open(Node& node, const std::string& topic) { publisher_ = node.advertise<ignition::msgs::Pose_V>(topic); }

  /// Sets of which models it tells from now on.
  void tellOf(std::vector<Model> models) {
    models_ = std::move(models);
    links_.clear();
    message_.Clear();
    for (const Model& model : models_) add(model.name(), model.id().value);
    for (const Model& model : models_) {
      for (const Link& link : model.links()) {
        add(link.name(), link.id().value);
        links_.push_back({model, link});
      }
    }
  }

  void publish(Time time) {
    if (!publisher_.hasSubscribers()) return;
    setStamp(time, *message_.mutable_header());
    int next = 0;
    for (const Model& model : models_) setPose(model.pose(), *message_.mutable_pose(next++));
    for (const auto& [model, link] : links_) {
      setPose(model.pose().inverse() * link.pose(), *message_.mutable_pose(next++));
    }
    publisher_.publish(message_);
  }

 private:
  struct LinkOfModel {
    Model model;
    Link link;
  };

  void add(std::string_view name, std::uint64_t id) {
    ignition::msgs::Pose& pose = *message_.add_pose();
    pose.set_name(std::string(name));
    pose.set_id(static_cast<std::uint32_t>(id));
  }

  Publisher publisher_;
  std::vector<Model> models_;
  std::vector<LinkOfModel> links_;
  ignition::msgs::Pose_V message_;
};

/// Publishes where the models and links are.
class SceneBroadcaster : public System {
 public:
  void declare(Declaration& declaration) override {
    declaration.is("Publishes where the models and links are.", Declaration::Place::kWorld);
    declaration.parameter("dynamic_pose_hertz", &rate_, "Hz", "messages a simulated second").above(0);
    declaration.element("state_hertz", "rate of `/world/W/state`, which is not there");
    declaration.publishes("/world/W/pose/info", "ignition.msgs.Pose_V",
                          "models in the world and links in their models");
    declaration.publishes("/world/W/dynamic_pose/info", "ignition.msgs.Pose_V", "the same of what is not static");
  }

  void configure(const SystemContext& context) override {
    period_ = periodOf(rate_);

    const std::string prefix = cleanTopic("/world/" + std::string(context.world.name()));
    all_.open(context.node, prefix + "/pose/info");
    moving_.open(context.node, prefix + "/dynamic_pose/info");
    world_ = &context.world;
    worldChanged();
  }

  void postUpdate(const StepInfo& info) override {
    if (!info.paused && info.time < due_) return;
    // On a grid, so that the rate is kept where it is no multiple of the step.
    due_ = Time((info.time / period_ + 1) * period_.count());
    all_.publish(info.time);
    moving_.publish(info.time);
  }

  void reset() override { due_ = Time::zero(); }

  void transfer(StateArchive& archive) override { archive(due_); }

  void worldChanged() override {
    std::vector<Model> all = world_->models();
    std::vector<Model> moving;
    std::ranges::copy_if(all, std::back_inserter(moving), [](const Model& model) { return !model.isStatic(); });
    all_.tellOf(std::move(all));
    moving_.tellOf(std::move(moving));
  }

 private:
  double rate_ = 60;
  World* world_ = nullptr;
  Time period_{0};
  Time due_{0};
  PoseTopic all_;
  PoseTopic moving_;
};

}  // namespace

}  // namespace pongsim

PONGSIM_EXPORT_SYSTEM(pongsim::SceneBroadcaster, "ignition::gazebo::systems::SceneBroadcaster",
                      "gz::sim::systems::SceneBroadcaster");
