#include <algorithm>
#include <cmath>
#include <optional>
#include <string>
#include <vector>

#include "pongsim/actor.hh"
#include "pongsim/math.hh"
#include "pongsim/parameters.hh"
#include "pongsim/system.hh"

namespace pongsim {

namespace {

/// Makes an actor follow a model or another actor.
class FollowActor : public System {
 public:
  void declare(Declaration& declaration) override {
    declaration.is("Makes an actor follow a model or another actor, in a horizontal plane.",
                   Declaration::Place::kActor);
    declaration.parameter("target", &targetName_, "", "name of what it follows").required();
    declaration.parameter("min_distance", &nearest_, "m", "it stops at this distance");
    declaration.parameter("max_distance", &farthest_, "m", "maximum distance of a target");
    declaration.parameter("velocity", &speed_, "m/s", "walking speed");
    declaration.parameter("animation", &animation_, "", "name of its animation").otherwise("the actor's first one");
    declaration.parameter("animation_x_vel", &animationSpeed_, "s/m", "animation time per metre walked");
  }

  void configure(const SystemContext& context) override {
    log_ = &context.log;
    world_ = &context.world;
    actor_ = context.actor;
    findTarget(context.sdf);
    const std::vector<std::string> animations = actor_->animations();
    if (animation_.empty()) {
      // an actor without an animation can follow, too
      if (!animations.empty()) animation_ = animations.front();
    } else if (std::ranges::find(animations, animation_) == animations.end()) {
      context.diagnostics.warning(
          context.sdf.child("animation")->position,
          "actor '" + std::string(actor_->name()) + "' has no <animation> '" + animation_ + "' to show");
    }
    reset();
  }

  void preUpdate(const StepInfo& info) override {
    if (info.paused || !actor_->exists()) return;
    const std::optional<Pose> target = targetPose();
    if (!target) return;
    Vector3 way = target->position - pose_.position;
    way.z() = 0;
    const double distance = way.norm();
    if (distance <= nearest_) return;
    noteWhetherItFollows(distance <= farthest_);
    if (!follows_) return;
    const double step = speed_ * toSeconds(info.dt);
    pose_.position += step / distance * way;
    pose_.rotation = fromRollPitchYaw(0, 0, math::atan2(way.y(), way.x()));
    animationTime_ += fromSeconds(std::abs(step) * animationSpeed_);
    actor_->move(pose_, animation_, animationTime_);
  }

  void reset() override {
    pose_ = actor_->startPose();
    animationTime_ = Time(0);
    follows_ = true;
    actor_->move(pose_, animation_, animationTime_);
  }

  void transfer(StateArchive& archive) override {
    archive(pose_);
    archive(animationTime_);
    archive(follows_);
    if (archive.isGiving() && actor_->exists()) actor_->move(pose_, animation_, animationTime_);
  }

 private:
  void findTarget(const Element& sdf) {
    if (const std::optional<Model> model = world_->model(targetName_)) {
      target_ = model->id();
      return;
    }
    targetActor_ = Actor::find(*world_, targetName_);
    if (targetActor_ && targetActor_->id() != actor_->id()) return;
    refuse(*sdf.child("target"), targetActor_ ? "<target> '" + targetName_ + "' is the actor itself"
                                              : "<target> '" + targetName_ + "' is not a model or actor of the world");
  }

  /// @return Nothing if the target was removed.
  std::optional<Pose> targetPose() const {
    if (targetActor_) return targetActor_->exists() ? std::optional(targetActor_->pose()) : std::nullopt;
    const std::optional<Model> model = world_->model(target_);
    return model ? std::optional(model->pose()) : std::nullopt;
  }

  void noteWhetherItFollows(bool follows) {
    if (follows == follows_) return;
    follows_ = follows;
    log_->info("'" + targetName_ + (follows ? "' is in range and followed" : "' is out of range and not followed"));
  }

  std::string targetName_, animation_;
  double nearest_ = 1.2;
  double farthest_ = 4;
  double speed_ = 0.8;
  double animationSpeed_ = 2;

  const Logger* log_ = nullptr;
  World* world_ = nullptr;
  std::optional<Actor> actor_;
  ModelId target_;
  std::optional<Actor> targetActor_;
  Pose pose_;
  Time animationTime_{0};
  bool follows_ = true;
};

}  // namespace

}  // namespace pongsim

PONGSIM_EXPORT_SYSTEM(pongsim::FollowActor, "ignition::gazebo::systems::FollowActor", "gz::sim::systems::FollowActor");
