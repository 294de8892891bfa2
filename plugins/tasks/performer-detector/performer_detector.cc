#include <ignition/msgs/pose.pb.h>

#include <algorithm>
#include <cstdint>
#include <map>
#include <optional>
#include <sstream>
#include <string>
#include <vector>

#include "pongsim/messages/fields.hh"
#include "pongsim/parameters.hh"
#include "pongsim/system.hh"

namespace pongsim {

namespace {

/// @return The first three numbers of a pose.
Vector3 positionOf(const Element& pose) {
  std::istringstream stream(pose.text);
  Vector3 position;
  double rest = 0;
  for (double& number : position) stream >> number;
  for (int i = 0; i < 3; ++i) stream >> rest;
  if (!stream || !position.allFinite()) refuse(pose, "<pose> must be six numbers: x y z roll pitch yaw");
  return position;
}

/// Publishes which performers enter and leave a box around a model.
class PerformerDetector : public System {
 public:
  void declare(Declaration& declaration) override {
    declaration.is("Publishes which performers enter and leave a box around a model.", Declaration::Place::kModel);
    declaration.element("geometry", "`<box><size>`: the box [m], aligned with the world's axes; required");
    declaration.element("pose", "centre of the box in the model's frame [m]; rotations have no effect");
    declaration.parameter("topic", &topic_, "", "topic of the messages")
        .otherwise("/model/M/performer_detector/status");
    declaration.element("header_data",
                        "`<key>` and `<value>`: an entry for the header of the messages; may be repeated");
    declaration.publishes("<topic>", "ignition.msgs.Pose",
                          "pose of a performer in the model's frame, with its name and id; in the header's data "
                          "`frame_id` (the model), `state` (1: entered, 0: left) and `count` (performers inside)");
    // detectors of one place often share a topic
    declaration.sharesTopics();
  }

  void configure(const SystemContext& context) override {
    model_ = context.model;
    world_ = &context.world;
    size_ = sizeOf(context.sdf);
    if (const Element* pose = context.sdf.child("pose"); pose != nullptr && !pose->text.empty()) {
      middle_ = positionOf(*pose);
    }
    readHeader(context);
    publisher_ = context.node.advertise<ignition::msgs::Pose>(
        topicOr(topic_, "/model/" + std::string(model_->name()) + "/performer_detector/status"));
  }

  void postUpdate(const StepInfo& info) override {
    if (info.paused) return;
    world_->performers(performers_);
    if (performers_.empty() && present_.empty()) return;
    const Pose X_WorldModel = model_->pose();
    const Vector3 middle = X_WorldModel * middle_;
    for (const Performer& performer : performers_) {
      const Vector3 gap = (performer.pose.position - middle).cwiseAbs() - (performer.size + size_) / 2;
      const auto place = std::ranges::find(present_, performer.id);
      const bool isIn = gap.maxCoeff() <= 0;
      if (isIn == (place != present_.end())) continue;
      if (isIn) {
        present_.push_back(performer.id);
      } else {
        present_.erase(place);
      }
      publish(performer, isIn, X_WorldModel, info.time);
    }
  }

  void worldChanged() override {
    // a removed performer has not left, as in Fortress, but no longer counts
    world_->performers(performers_);
    std::erase_if(present_, [this](std::uint64_t id) {
      return std::ranges::find(performers_, id, &Performer::id) == performers_.end();
    });
  }

  void reset() override { present_.clear(); }

  void transfer(StateArchive& archive) override { archive(present_); }

 private:
  static Vector3 sizeOf(const Element& sdf) {
    const Element* geometry = sdf.child("geometry");
    const Element* box = geometry != nullptr ? geometry->child("box") : nullptr;
    const Element* size = box != nullptr ? box->child("size") : nullptr;
    if (size == nullptr) {
      refuse(geometry != nullptr ? *geometry : sdf, "no <geometry> is given",
             "write <geometry><box><size>X Y Z</size></box></geometry>");
    }
    const Vector3 lengths = size->as<Vector3>();
    if (!lengths.allFinite() || lengths.minCoeff() < 0) refuse(*size, "<size> must be three lengths");
    return lengths;
  }

  void readHeader(const SystemContext& context) {
    for (const Element* data : context.sdf.childrenNamed("header_data")) {
      const std::string key = data->get<std::string>("key", ""), value = data->get<std::string>("value", "");
      if (key.empty() || value.empty()) {
        context.diagnostics.warning(data->position, std::string("this <header_data> has no <") +
                                                        (key.empty() ? "key" : "value") + ">: it is left out");
        continue;
      }
      headerData_[key] = value;
    }
  }

  void publish(const Performer& performer, bool isIn, const Pose& X_WorldModel, Time time) {
    if (!publisher_.hasSubscribers()) return;
    ignition::msgs::Pose message;
    setPose(X_WorldModel.inverse() * performer.pose, message);
    message.set_name(std::string(nameOf(performer)));
    message.set_id(static_cast<std::uint32_t>(performer.id));
    ignition::msgs::Header& header = *message.mutable_header();
    setStamp(time, header);
    setHeaderValue("frame_id", std::string(model_->name()), header);
    setHeaderValue("state", isIn ? "1" : "0", header);
    setHeaderValue("count", std::to_string(present_.size()), header);
    for (const auto& [key, value] : headerData_) {
      auto& entry = *header.add_data();
      entry.set_key(key);
      entry.add_value(value);
    }
    publisher_.publish(message);
  }

  /// @return The name of the performer's model.
  std::string nameOf(const Performer& performer) const {
    const std::optional<Model> model = performer.model ? world_->model(*performer.model) : std::nullopt;
    return model ? std::string(model->name()) : std::string(performer.name);
  }

  std::string topic_;
  std::optional<Model> model_;
  World* world_ = nullptr;
  Vector3 size_ = Vector3::Zero();
  Vector3 middle_ = Vector3::Zero();
  std::map<std::string, std::string> headerData_;
  /// Performers in the box, in the order of arrival.
  std::vector<std::uint64_t> present_;
  // reused in each step
  std::vector<Performer> performers_;
  Publisher publisher_;
};

}  // namespace

}  // namespace pongsim

PONGSIM_EXPORT_SYSTEM(pongsim::PerformerDetector, "ignition::gazebo::systems::PerformerDetector",
                      "gz::sim::systems::PerformerDetector");
