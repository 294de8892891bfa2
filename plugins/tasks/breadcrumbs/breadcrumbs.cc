#include <ignition/msgs/empty.pb.h>
#include <ignition/msgs/int32.pb.h>

#include <algorithm>
#include <cstdint>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "pongsim/parameters.hh"
#include "pongsim/system.hh"

namespace pongsim {

namespace {

/// Deploys copies of a model at its own model's pose.
class Breadcrumbs : public System {
 public:
  void declare(Declaration& declaration) override {
    declaration.is("Deploys copies of a model at its own model's pose, on command.", Declaration::Place::kModel);
    declaration.element("breadcrumb",
                        "`<sdf>` with the model B to deploy; its pose is relative to the own model; required");
    declaration.parameter("topic", &topic_, "", "command topic").otherwise("/model/M/breadcrumbs/B/deploy");
    declaration.parameter("max_deployments", &most_, "", "number of copies; below zero: unlimited");
    declaration.parameter("disable_physics_time", &timeToRest_, "s",
                          "simulated time after which a copy becomes static; 0 or less: never");
    declaration.element("performer_volume", "`<geometry><box><size>`: makes copies performers with that box [m]");
    declaration.parameter("allow_renaming", &mayRename_, "",
                          "adds a number to a name that is taken; otherwise nothing is deployed");
    declaration.parameter("topic_statistics", &tellsOfDrops_, "", "warns about lost messages");
    declaration.subscribes("<topic>", "ignition.msgs.Empty", "deploys a copy, named `B_0`, `B_1` and so on");
    declaration.publishes("<topic>/remaining", "ignition.msgs.Int32",
                          "remaining copies, after each message; below zero if unlimited");
    declaration.sharesTopics();
  }

  void configure(const SystemContext& context) override {
    log_ = &context.log;
    world_ = &context.world;
    edits_ = &context.edits;
    model_ = context.model;
    if (most_ == 0) return log_->info("has nothing to deploy: <max_deployments> is 0");
    const Element* breadcrumb = context.sdf.child("breadcrumb");
    if (breadcrumb == nullptr) refuse(context.sdf, "no <breadcrumb> is given");
    const Element* sdf = breadcrumb->child("sdf");
    if (sdf == nullptr) refuse(*breadcrumb, "<breadcrumb> has no <sdf>", "write <sdf version=\"1.6\"><model name=...");
    template_ = context.edits.read(*sdf, context.diagnostics);
    if (const Element* volume = context.sdf.child("performer_volume")) performerSize_ = sizeOf(*volume);

    const std::string topic =
        topicOr(topic_, "/model/" + std::string(model_->name()) + "/breadcrumbs/" + template_->name() + "/deploy");
    deploy_ = context.node.subscribe<ignition::msgs::Empty>(topic, [this](const auto&) { receive(); });
    remaining_ = context.node.advertise<ignition::msgs::Int32>(topic + "/remaining");
  }

  void preUpdate(const StepInfo& info) override {
    for (Falling& each : falling_) {
      if (!each.since) each.since = info.time;
    }
  }

  // requests made here are carried out before the next step begins
  void postUpdate(const StepInfo& info) override {
    while (!falling_.empty() && falling_.front().since &&
           info.time + info.dt - *falling_.front().since > fromSeconds(timeToRest_)) {
      hold(falling_.front().model);
      falling_.erase(falling_.begin());
    }
  }

  void reset() override {
    count_ = 0;
    falling_.clear();
  }

  void transfer(StateArchive& archive) override {
    archive(count_);
    archive.check(count_ >= 0);
    archive(falling_);
  }

 private:
  /// A copy that will become static.
  struct Falling {
    ModelId model;
    /// When it appeared.
    std::optional<Time> since;

    void transfer(StateArchive& archive) {
      archive(model.value);
      archive(since);
    }
  };

  static Vector3 sizeOf(const Element& volume) {
    const Element* geometry = volume.child("geometry");
    const Element* box = geometry != nullptr ? geometry->child("box") : nullptr;
    const Element* size = box != nullptr ? box->child("size") : nullptr;
    if (size == nullptr) {
      refuse(volume, "<performer_volume> is not a box", "write <geometry><box><size>X Y Z</size></box></geometry>");
    }
    const Vector3 lengths = size->as<Vector3>();
    if (!lengths.allFinite() || lengths.minCoeff() < 0) refuse(*size, "<size> must be three lengths");
    return lengths;
  }

  void receive() {
    if (tellsOfDrops_ && deploy_.dropped() > dropped_) {
      dropped_ = deploy_.dropped();
      log_->warning(std::to_string(dropped_) + " messages to deploy a '" + template_->name() + "' were lost");
    }
    if (most_ >= 0 && count_ >= most_) {
      log_->info("has no '" + template_->name() + "' left to deploy");
    } else if (!leave()) {
      return;
    }
    ignition::msgs::Int32 message;
    message.set_data(most_ - count_);
    remaining_.publish(message);
  }

  /// @return Whether a copy is being inserted.
  bool leave() {
    const std::optional<std::string> name = freeName();
    if (!name) return false;
    ++count_;
    edits_->insert(*template_, {.name = *name, .pose = model_->pose() * template_->pose()},
                   [this](const Outcome<Model>& model) { settle(model); });
    return true;
  }

  std::optional<std::string> freeName() {
    const std::string wanted = template_->name() + "_" + std::to_string(count_);
    if (!world_->model(wanted)) return wanted;
    if (!mayRename_) {
      log_->warning("there is a '" + wanted + "' already, and <allow_renaming> is not set: nothing is deployed");
      return std::nullopt;
    }
    for (int number = 1;; ++number) {
      std::string name = wanted + "_" + std::to_string(number);
      if (!world_->model(name)) return name;
    }
  }

  /// Finishes a copy once it has been inserted.
  void settle(const Outcome<Model>& model) {
    if (!model) {
      --count_;
      return log_->warning("it can't be deployed: " + model.error);
    }
    if (performerSize_) {
      const Outcome<void> added = world_->addPerformer(*model.value, *performerSize_);
      if (!added) log_->warning("'" + std::string(model.value->name()) + "' can't become a performer: " + added.error);
    }
    if (!template_->isStatic() && timeToRest_ > 0) falling_.push_back({model.value->id(), std::nullopt});
  }

  /// Holds a model in place by attaching it to a static one, as in Fortress.
  void hold(ModelId id) {
    const std::optional<Model> model = world_->model(id);
    if (!model) return;
    const std::string text = "<sdf version='1.9'><model name='" + template_->name() +
                             "__static__'><static>true</static><link name='static_link'/></model></sdf>";
    edits_->insertText(text, "the holder of a breadcrumb",
                       {.name = std::string(model->name()) + "__static__", .pose = model->pose()},
                       [this, id](const Outcome<Model>& holder) { attach(holder, id); });
  }

  void attach(const Outcome<Model>& holder, ModelId id) {
    const std::optional<Model> model = world_->model(id);
    if (!model) return;
    std::string error = holder.error;
    if (holder) error = world_->attach(*holder.value->canonicalLink(), *model->canonicalLink()).error;
    if (!error.empty()) log_->warning("'" + std::string(model->name()) + "' can't be held: " + error);
  }

  std::string topic_;
  int most_ = -1;
  double timeToRest_ = 0;
  bool mayRename_ = false;
  bool tellsOfDrops_ = false;

  const Logger* log_ = nullptr;
  World* world_ = nullptr;
  WorldEdits* edits_ = nullptr;
  std::optional<Model> model_;
  std::optional<ModelTemplate> template_;
  std::optional<Vector3> performerSize_;
  /// Number of copies deployed.
  int count_ = 0;
  std::uint64_t dropped_ = 0;
  /// In the order of deployment.
  std::vector<Falling> falling_;
  Subscription deploy_;
  Publisher remaining_;
};

}  // namespace

}  // namespace pongsim

PONGSIM_EXPORT_SYSTEM(pongsim::Breadcrumbs, "ignition::gazebo::systems::Breadcrumbs", "gz::sim::systems::Breadcrumbs");
