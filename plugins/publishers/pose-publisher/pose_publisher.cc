#include <ignition/msgs/pose_v.pb.h>

#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "pongsim/messages/fields.hh"
#include "pongsim/parameters.hh"
#include "pongsim/sensing/sensor.hh"
#include "pongsim/system.hh"

namespace pongsim {

namespace {

/// An entity whose pose is published: its frames, and its pose relative to its parent.
struct Entry {
  std::string frame;
  std::string childFrame;
  std::optional<Model> model;
  std::optional<Link> link;
  /// Of an entity that is fixed to a link.
  Pose X_ParentEntity;

  Pose pose() const {
    if (model) {
      const std::optional<Model> parent = model->parent();
      return parent ? parent->pose().inverse() * model->pose() : model->pose();
    }
    return link ? link->model().pose().inverse() * link->pose() : X_ParentEntity;
  }
};

/// Which poses of a model are published.
struct Choice {
  bool links = true, visuals = false, collisions = false, sensors = false, nestedModels = false, model = false;
};

/// One topic: a list of entities and how often their poses are published.
class PoseTopic {
 public:
  /// @param isStill Whether the poses never change: then new subscribers get them at once, between the times.
  void open(Node& node, const std::string& topic, bool asVector, bool isStill, Time period) {
    isStill_ = isStill;
    publisher_ = asVector ? node.advertise<ignition::msgs::Pose_V>(topic) : node.advertise<ignition::msgs::Pose>(topic);
    asVector_ = asVector;
    schedule_ = Schedule(period);
  }

  void add(Entry entry) { entries_.push_back(std::move(entry)); }

  void publish(const StepInfo& info) {
    const bool isDue = schedule_.isDue(info.time);
    const bool isAsked = isStill_ && publisher_.newSubscribers() > 0;
    if (!(isDue || isAsked) || !publisher_.hasSubscribers()) return;
    if (asVector_) {
      setStamp(info.time, *vector_.mutable_header());
      while (vector_.pose_size() < static_cast<int>(entries_.size())) vector_.add_pose();
    }
    for (std::size_t i = 0; i < entries_.size(); ++i) {
      ignition::msgs::Pose& message = asVector_ ? *vector_.mutable_pose(static_cast<int>(i)) : single_;
      fill(entries_[i], info.time, message);
      if (!asVector_) publisher_.publish(single_);
    }
    if (asVector_) publisher_.publish(vector_);
  }

  void reset() { schedule_.reset(); }
  void transfer(StateArchive& archive) { archive(schedule_); }

 private:
  static void fill(const Entry& entry, Time time, ignition::msgs::Pose& message) {
    setStamp(time, *message.mutable_header());
    setHeaderValue("frame_id", entry.frame, *message.mutable_header());
    setHeaderValue("child_frame_id", entry.childFrame, *message.mutable_header());
    message.set_name(entry.childFrame);
    setPose(entry.pose(), message);
  }

  bool isStill_ = false;
  bool asVector_ = false;
  Schedule schedule_;
  std::vector<Entry> entries_;
  Publisher publisher_;
  ignition::msgs::Pose single_;
  ignition::msgs::Pose_V vector_;
};

/// @return Whether a moving joint moves the link relative to the rest: it is not the canonical link, and a moving joint
/// connects to it.
bool movesInModel(const Link& link, const Model& top) {
  if (top.canonicalLink() && top.canonicalLink()->id() == link.id()) return false;
  std::vector<Model> models = {top};
  for (std::size_t i = 0; i < models.size(); ++i) {
    for (const Model& inner : models[i].models()) models.push_back(inner);
    for (const Joint& joint : models[i].joints()) {
      if (joint.type() == "fixed") continue;
      if (joint.child().id() == link.id() || (joint.parent() && joint.parent()->id() == link.id())) return true;
    }
  }
  return false;
}

/// Publishes the poses of a model's parts, relative to their parents.
class PosePublisher : public System {
 public:
  void declare(Declaration& declaration) override {
    declaration.is("Publishes the poses of a model's parts, relative to their parents.", Declaration::Place::kModel);
    const auto add = [&](const char* name, bool& value, const char* text) -> Parameter& {
      return declaration.parameter(name, &value, "", text);
    };
    add("publish_link_pose", choice_.links, "poses of links");
    add("publish_visual_pose", choice_.visuals, "poses of visuals");
    add("publish_collision_pose", choice_.collisions, "poses of collisions");
    add("publish_sensor_pose", choice_.sensors, "poses of sensors");
    add("publish_nested_model_pose", choice_.nestedModels, "poses of the models in the model");
    add("publish_model_pose", choice_.model, "pose of the model itself, if those of nested models are published")
        .otherwise("as publish_nested_model_pose");
    add("use_pose_vector_msg", asVector_, "one Pose_V instead of a Pose for each part");
    add("static_publisher", isSplit_, "poses that are fixed in the model get their own topic");
    declaration.parameter("update_frequency", &frequency_, "Hz", "messages per simulated second; -1: one per step");
    declaration.parameter("static_update_frequency", &staticFrequency_, "Hz", "rate of fixed poses")
        .otherwise("update_frequency");
    declaration.publishes("/model/M/pose", "ignition.msgs.Pose", "or ignition.msgs.Pose_V");
    declaration.publishes("/model/M/pose_static", "ignition.msgs.Pose",
                          "or ignition.msgs.Pose_V; with `<static_publisher>`");
  }

  void configure(const SystemContext& context) override {
    const Model& model = *context.model;
    top_ = model;
    if (context.sdf.child("publish_model_pose") == nullptr) choice_.model = choice_.nestedModels;
    std::string topic = "/pose";
    for (std::optional<Model> holder = model; holder; holder = holder->parent()) {
      topic = "/model/" + std::string(holder->name()) + topic;
    }
    moving_.open(context.node, cleanTopic(topic), asVector_, false, periodOf(frequency_));
    if (isSplit_) {
      still_.open(context.node, cleanTopic(topic + "_static"), asVector_, true,
                  periodOf(staticFrequency_.value_or(frequency_)));
    }

    if (choice_.model && choice_.nestedModels) {
      const std::optional<Model> parent = model.parent();
      const std::string frame = parent ? parent->scopedName() : std::string(context.world.name());
      add({frame, model.scopedName(), model, std::nullopt, {}}, false);
    }
    addParts(model);
  }

  void postUpdate(const StepInfo& info) override {
    if (info.paused) return;
    moving_.publish(info);
    if (isSplit_) still_.publish(info);
  }

  void reset() override {
    moving_.reset();
    still_.reset();
  }

  void transfer(StateArchive& archive) override {
    archive(moving_);
    archive(still_);
  }

 private:
  void addParts(const Model& model) {
    const std::string name = model.scopedName();
    for (const Link& link : model.links()) {
      const std::string linkName = link.scopedName();
      if (choice_.links) add({name, linkName, std::nullopt, link, {}}, isSplit_ && movesInModel(link, *top_));
      const auto addFixed = [&](std::string_view part, const Pose& X_LinkPart) {
        add({linkName, linkName + "::" + std::string(part), std::nullopt, std::nullopt, X_LinkPart}, false);
      };
      if (choice_.visuals) {
        for (const Visual& visual : link.visuals()) addFixed(visual.name(), visual.poseInLink());
      }
      if (choice_.collisions) {
        for (const Collision& collision : link.collisions()) addFixed(collision.name(), collision.poseInLink());
      }
      if (choice_.sensors) {
        for (const Sensor& sensor : link.sensors()) addFixed(sensor.name(), sensor.poseInLink());
      }
    }
    for (const Model& inner : model.models()) {
      if (choice_.nestedModels) add({name, inner.scopedName(), inner, std::nullopt, {}}, false);
      addParts(inner);
    }
  }

  void add(Entry entry, bool moves) { (isSplit_ && !moves ? still_ : moving_).add(std::move(entry)); }

  Choice choice_;
  bool asVector_ = false;
  bool isSplit_ = false;
  double frequency_ = -1;
  std::optional<double> staticFrequency_;
  std::optional<Model> top_;
  PoseTopic moving_;
  PoseTopic still_;
};

}  // namespace

}  // namespace pongsim

PONGSIM_EXPORT_SYSTEM(pongsim::PosePublisher, "ignition::gazebo::systems::PosePublisher",
                      "gz::sim::systems::PosePublisher");
