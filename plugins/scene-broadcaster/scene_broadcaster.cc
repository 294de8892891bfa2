#include <ignition/msgs/pose_v.pb.h>

#include <algorithm>
#include <cmath>
#include <string>
#include <vector>

#include "pongsim/system.hh"

namespace pongsim {

namespace {

void setPose(const Pose& pose, ignition::msgs::Pose& message) {
  message.mutable_position()->set_x(pose.position.x());
  message.mutable_position()->set_y(pose.position.y());
  message.mutable_position()->set_z(pose.position.z());
  message.mutable_orientation()->set_x(pose.rotation.x());
  message.mutable_orientation()->set_y(pose.rotation.y());
  message.mutable_orientation()->set_z(pose.rotation.z());
  message.mutable_orientation()->set_w(pose.rotation.w());
}

void setStamp(Time time, ignition::msgs::Time& message) {
  const auto seconds = std::chrono::floor<std::chrono::seconds>(time);
  message.set_sec(seconds.count());
  message.set_nsec(static_cast<std::int32_t>((time - seconds).count()));
}

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
    setStamp(time, *message_.mutable_header()->mutable_stamp());
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
  void configure(const SystemContext& context) override {
    const double rate = context.sdf.get("dynamic_pose_hertz", 60.0);
    if (!(rate > 0)) {
      throw Error({Severity::kError,
                   context.sdf.child("dynamic_pose_hertz")->position,
                   "<dynamic_pose_hertz> must be above zero",
                   {}});
    }
    period_ = fromSeconds(std::min(1 / rate, 1e9));

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

  void worldChanged() override {
    std::vector<Model> all = world_->models();
    std::vector<Model> moving;
    std::ranges::copy_if(all, std::back_inserter(moving), [](const Model& model) { return !model.isStatic(); });
    all_.tellOf(std::move(all));
    moving_.tellOf(std::move(moving));
  }

 private:
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
