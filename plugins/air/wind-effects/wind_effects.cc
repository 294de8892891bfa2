#include <ignition/msgs/empty.pb.h>
#include <ignition/msgs/wind.pb.h>

#include <algorithm>
#include <optional>
#include <string>
#include <vector>

#include "pongsim/commands.hh"
#include "pongsim/parameters.hh"
#include "pongsim/system.hh"
#include "scaling_field.hh"
#include "wind_model.hh"
#include "wind_settings.hh"

namespace pongsim {

namespace {

/// Simulates wind and the force that it exerts on links.
class WindEffects : public System {
 public:
  void declare(Declaration& declaration) override {
    declaration.is("Simulates wind and the force that it exerts on links.", Declaration::Place::kWorld);
    declaration
        .parameter(
            "force_approximation_scaling_factor", &scale_, "1/s",
            "force per mass and relative wind velocity; instead of a number, `<when>` elements give it by region")
        .atLeast(1e-6);
    declaration.element("horizontal",
                        "`<magnitude>` and `<direction>`, each with `<time_for_rise>` (1 s), `<noise>` and `<sin>`: a "
                        "wave of `<period>` (1 s) and `<amplitude_percent>` (0; a fraction: 0.05 is five percent), for "
                        "the direction `<amplitude>` (0 degrees)");
    declaration.element("vertical", "`<time_for_rise>` (1 s) and `<noise>`");
    declaration.subscribes("/world/W/wind", "ignition.msgs.Wind",
                           "`linear_velocity` [m/s], which the wind approaches, and `enable_wind`: false switches the "
                           "wind off");
    declaration.serves("/world/W/wind_info", "ignition.msgs.Empty", "ignition.msgs.Wind",
                       "the last command; initially the world's `<wind>`");
  }

  void configure(const SystemContext& context) override {
    log_ = &context.log;
    world_ = &context.world;
    random_ = &context.random;
    const Element* factor = context.sdf.child("force_approximation_scaling_factor");
    if (factor != nullptr && !factor->children.empty()) field_.emplace(*factor);
    model_.emplace(readWindSettings(context.sdf, context.diagnostics), *random_);
    mean_ = world_->wind();
    findLinks();
    const std::string prefix = cleanTopic("/world/" + std::string(world_->name()));
    command_ = context.node.subscribe<ignition::msgs::Wind>(
        prefix + "/wind", [this](const auto& message) { receive(message); }, kCommands);
    info_ = context.node.serve<ignition::msgs::Empty, ignition::msgs::Wind>(
        prefix + "/wind_info", [this](const auto&, auto& reply) {
          reply.set_enable_wind(blows_);
          reply.mutable_linear_velocity()->set_x(mean_.x());
          reply.mutable_linear_velocity()->set_y(mean_.y());
          reply.mutable_linear_velocity()->set_z(mean_.z());
          return ServiceAnswer(true);
        });
  }

  void preUpdate(const StepInfo& info) override {
    if (info.paused || !blows_) return;
    const double dt = toSeconds(info.dt);
    // noise that would make the wind too fast is left out
    world_->setWind(model_->update(mean_, info.time, dt));
    push(world_->wind(), dt);
  }

  void worldChanged() override { findLinks(); }

  void reset() override {
    mean_ = world_->wind();
    blows_ = true;
    model_->reset(*random_);
  }

  void transfer(StateArchive& archive) override {
    archive(mean_);
    archive(blows_);
    model_->transfer(archive);
  }

 private:
  struct WindyLink {
    Link link;
    double mass;
    /// Of the mass, link frame.
    Vector3 center;
  };

  void findLinks() {
    links_.clear();
    for (const Model& model : world_->models()) addLinks(model);
  }

  void addLinks(const Model& model) {
    if (model.isStatic()) return;
    for (const Link& link : model.links()) {
      if (!link.isInWind()) continue;
      const MassInfo mass = link.mass();
      links_.push_back({link, mass.mass, mass.center});
    }
    for (const Model& inner : model.models()) addLinks(inner);
  }

  /// The force acts at the centre of mass; the velocity is that of the link's origin, as in Fortress.
  void push(const Vector3& wind, double dt) {
    for (WindyLink& each : links_) {
      // a larger factor would overshoot the wind's velocity, further in each step
      const double scale = std::min(field_ ? field_->at(each.link.pose().position) : scale_, 1 / dt);
      const Vector3 force = each.mass * scale * (wind - each.link.linearVelocity());
      each.link.addWrench(force, (each.link.pose().rotation * each.center).cross(force));
    }
  }

  void receive(const ignition::msgs::Wind& message) {
    const ignition::msgs::Vector3d& velocity = message.linear_velocity();
    const Vector3 mean(velocity.x(), velocity.y(), velocity.z());
    if (mean.norm() > kFastestWind) {
      return log_->warning("a wind was ignored: the limit is " + std::to_string(static_cast<int>(kFastestWind)) +
                           " m/s");
    }
    mean_ = mean;
    blows_ = message.enable_wind();
  }

  double scale_ = 1;
  /// In place of the scale, if the file has one.
  std::optional<ScalingField> field_;

  const Logger* log_ = nullptr;
  World* world_ = nullptr;
  Random* random_ = nullptr;
  std::optional<WindModel> model_;
  std::vector<WindyLink> links_;
  /// Mean velocity of the wind, world frame [m/s].
  Vector3 mean_ = Vector3::Zero();
  bool blows_ = true;
  Subscription command_;
  Service info_;
};

}  // namespace

}  // namespace pongsim

PONGSIM_EXPORT_SYSTEM(pongsim::WindEffects, "ignition::gazebo::systems::WindEffects", "gz::sim::systems::WindEffects");
