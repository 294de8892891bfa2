#include <ignition/msgs/boolean.pb.h>
#include <ignition/msgs/empty.pb.h>

#include <algorithm>
#include <stdexcept>
#include <string>
#include <vector>

#include "pongsim/contact.hh"
#include "pongsim/parameters.hh"
#include "pongsim/sensing/sensor.hh"
#include "pongsim/system.hh"

namespace pongsim {

namespace {

/// @return "world/W/model/M/link/L/collision/C", in which targets are searched.
std::string pathOf(const World& world, const Collision& collision) {
  std::string path = "/link/" + std::string(collision.link().name()) + "/collision/" + std::string(collision.name());
  for (std::optional<Model> model = collision.link().model(); model; model = model->parent()) {
    path = "/model/" + std::string(model->name()) + path;
  }
  return "world/" + std::string(world.name()) + path;
}

/// Calls `take` with each collision of the models and of their nested models.
template <class Take>
void forEachCollision(const std::vector<Model>& models, Take take) {
  for (const Model& model : models) {
    for (const Link& link : model.links()) {
      for (const Collision& collision : link.collisions()) take(collision);
    }
    forEachCollision(model.models(), take);
  }
}

/// Reports once that the model has touched a target for some time.
class TouchPlugin : public System {
 public:
  void declare(Declaration& declaration) override {
    declaration.is("Reports once that the model has touched a target for some time.", Declaration::Place::kModel);
    declaration
        .parameter("target", &target_, "",
                   "part of the names of collisions, such as world/W/model/M/link/L/collision/C")
        .required();
    declaration.parameter("time", &seconds_, "s", "how long the contact must last").required().atLeast(0);
    declaration.parameter("namespace", &space_, "", "prefix of topic and service").otherwise("/model/M/touch");
    declaration
        .parameter("collision", &collisionNames_, "",
                   "only these collisions of the model count, by their own or their scoped name")
        .otherwise("those of contact sensors");
    declaration.parameter("create_contact_sensor_for_collision", &needsNoSensor_, "",
                          "collisions count without a contact sensor, too");
    declaration.parameter("enabled", &startsEnabled_, "", "whether it is initially enabled");
    declaration.reads("contact");
    declaration.publishes("/NAMESPACE/touched", "ignition.msgs.Boolean", "`true`; the plugin is then disabled");
    declaration.serves("/NAMESPACE/enable", "ignition.msgs.Boolean", "ignition.msgs.Empty", "enables or disables it");
  }

  void configure(const SystemContext& context) override {
    const Element& sdf = context.sdf;
    world_ = &context.world;
    node_ = &context.node;
    time_ = fromSeconds(std::min(seconds_, 1e9));
    std::string space = "/" + (space_.empty() ? "touch" : space_);
    for (std::optional<Model> model = context.model; space_.empty() && model; model = model->parent()) {
      space = "/model/" + std::string(model->name()) + space;
    }
    topic_ = cleanTopic(space + "/touched");

    forEachCollision(context.world.models(), [&](const Collision& collision) {
      if (pathOf(*world_, collision).find(target_) != std::string::npos) targets_.push_back(collision.id());
    });
    if (targets_.empty()) {
      context.diagnostics.warning(sdf.child("target")->position,
                                  "no collision in the world has '" + target_ + "' in its name");
    }
    watchCollisions(context);
    if (watched_.empty() && !collisionNames_.empty()) {
      refuse(*sdf.child("collision"),
             "model '" + context.model->scopedName() + "' has no such collision with a contact sensor");
    }
    if (watched_.empty()) {
      refuse(sdf, "model '" + context.model->scopedName() + "' has no contact sensor with a <collision>",
             "add a <sensor type=\"contact\"> to a link and name the collision in it");
    }

    try {
      service_ = node_->serve<ignition::msgs::Boolean, ignition::msgs::Empty>(
          cleanTopic(space + "/enable"), [this](const ignition::msgs::Boolean& request, ignition::msgs::Empty&) {
            setEnabled(request.data());
            return true;
          });
    } catch (const std::invalid_argument& error) {
      // such as that of a model's copy, which reports on the same topic, as in Fortress
      context.diagnostics.warning(
          sdf.child(space_.empty() ? "target" : "namespace")->position,
          "model '" + context.model->scopedName() + "' can't be enabled or disabled: " + error.what());
    }
    setEnabled(startsEnabled_);
  }

  void postUpdate(const StepInfo& info) override {
    if (info.paused || !enabled_) return;
    if (!isTouching()) {
      since_.reset();
      return;
    }
    if (!since_) since_ = info.time;
    if (info.time - *since_ <= time_) return;
    ignition::msgs::Boolean touched;
    touched.set_data(true);
    publisher_.publish(touched);
    setEnabled(false);
  }

  void reset() override { setEnabled(startsEnabled_); }

  void transfer(StateArchive& archive) override {
    bool enabled = enabled_;
    archive(enabled);
    if (archive.isGiving()) setEnabled(enabled);
    archive(since_);
  }

 private:
  /// Finds the model's collisions that count.
  void watchCollisions(const SystemContext& context) {
    for (const Link& link : context.model->links()) {
      for (const Collision& collision : link.collisions()) {
        const std::string name(collision.name());
        const bool isNamed = std::ranges::find(collisionNames_, name) != collisionNames_.end() ||
                             std::ranges::find(collisionNames_, collision.scopedName()) != collisionNames_.end();
        if (!isNamed && !collisionNames_.empty()) continue;
        if (needsNoSensor_ || hasContactSensor(link, name)) {
          watched_.push_back(collision.id());
        } else if (isNamed) {
          context.diagnostics.warning(
              context.sdf.child("collision")->position,
              "collision '" + collision.scopedName() + "' has no contact sensor: it does not count",
              "<create_contact_sensor_for_collision> makes one");
        }
      }
    }
  }

  static bool hasContactSensor(const Link& link, const std::string& collision) {
    return std::ranges::any_of(link.sensors(), [&collision](const Sensor& sensor) {
      const ContactSettings* settings = sensor.settings<ContactSettings>();
      return settings != nullptr && std::ranges::find(settings->collisions, collision) != settings->collisions.end();
    });
  }

  bool isTouching() {
    const auto isOf = [](const std::vector<CollisionId>& ids, CollisionId id) {
      return std::ranges::find(ids, id) != ids.end();
    };
    world_->contacts(contacts_);
    return std::ranges::any_of(contacts_, [&](const Contact& contact) {
      return (isOf(watched_, contact.collision1) && isOf(targets_, contact.collision2)) ||
             (isOf(watched_, contact.collision2) && isOf(targets_, contact.collision1));
    });
  }

  void setEnabled(bool enabled) {
    since_.reset();
    enabled_ = enabled;
    // it outlives disabling, because its last message may still be on the way to other processes
    if (enabled && !publisher_) publisher_ = node_->advertise<ignition::msgs::Boolean>(topic_);
  }

  std::string target_;
  double seconds_ = 0;
  std::string space_;
  std::vector<std::string> collisionNames_;
  bool needsNoSensor_ = false;
  World* world_ = nullptr;
  Node* node_ = nullptr;
  std::vector<CollisionId> targets_;
  std::vector<CollisionId> watched_;
  Time time_{0};
  std::string topic_;
  bool startsEnabled_ = false;
  bool enabled_ = false;

  /// Start of the uninterrupted touch.
  std::optional<Time> since_;
  std::vector<Contact> contacts_;
  Publisher publisher_;
  Service service_;
};

}  // namespace

}  // namespace pongsim

PONGSIM_EXPORT_SYSTEM(pongsim::TouchPlugin, "ignition::gazebo::systems::TouchPlugin", "gz::sim::systems::TouchPlugin");
