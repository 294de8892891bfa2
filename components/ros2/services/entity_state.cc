#include "ros2/services/entity_state.hh"

#include <chrono>
#include <optional>
#include <string>

namespace pongsim::ros2 {

namespace si = simulation_interfaces;

namespace {

bool isZero(const geometry_msgs::Vector3& vector) { return vectorOf(vector).isZero(0); }

std::optional<std::string> velocityError(const geometry_msgs::Twist& twist) {
  if (!isFinite(twist)) return "the twist is not finite";
  if (!(vectorOf(twist.linear).cwiseAbs().maxCoeff() <= kLargestCommand) ||
      !(vectorOf(twist.angular).cwiseAbs().maxCoeff() <= kLargestCommand)) {
    return "the twist has a number above 1000000";
  }
  return std::nullopt;
}

builtin_interfaces::Time stamp(Time time) {
  const auto seconds = std::chrono::floor<std::chrono::seconds>(time);
  return {static_cast<std::int32_t>(seconds.count()), static_cast<std::uint32_t>((time - seconds).count())};
}

}  // namespace

Accelerations::Acceleration Accelerations::of(const Model& model) {
  return known_.try_emplace(model.id().value, Known{movingFrame(model), {}}).first->second.acceleration;
}

void Accelerations::stepped(const World& world, const StepInfo& info) {
  if (known_.empty() || info.paused) return;
  const double dt = toSeconds(info.dt);
  for (auto each = known_.begin(); each != known_.end();) {
    const std::optional<Model> model = world.model(ModelId{each->first});
    if (!model) {
      each = known_.erase(each);
      continue;
    }
    Known& known = (each++)->second;
    const MovingFrame now = movingFrame(*model);
    known.acceleration = {(now.linear - known.last.linear) / dt, (now.angular - known.last.angular) / dt};
    known.last = now;
  }
}

si::EntityState stateOf(const Model& model, Time now, Accelerations& accelerations) {
  const MovingFrame frame = movingFrame(model);
  const Accelerations::Acceleration acceleration = accelerations.of(model);
  si::EntityState state;
  state.header.frame_id = "world";
  state.header.stamp = stamp(now);
  state.pose = poseMessage(frame.pose);
  copyVector(frame.linear, state.twist.linear);
  copyVector(frame.angular, state.twist.angular);
  copyVector(acceleration.linear, state.acceleration.linear);
  copyVector(acceleration.angular, state.acceleration.angular);
  return state;
}

Result setState(const EntityFinder& finder, const si::srv::SetEntityState::Request& request) {
  using Response = si::srv::SetEntityState::Response;
  Outcome<Model> model = finder.find(request.entity);
  if (!model) return notFound(model.error);
  Outcome<MovingFrame> frame = finder.frame(request.state.header.frame_id);
  if (!frame) return refused(Response::kInvalidPose, frame.error);
  if (request.set_pose) {
    if (const auto error = poseError(request.state.pose)) return refused(Response::kInvalidPose, *error);
  }
  if (request.set_twist) {
    if (const auto error = velocityError(request.state.twist)) return failed(*error);
  }
  const auto& [linear, angular] = request.state.twist;
  const bool isMoved = request.set_twist && !(isZero(linear) && isZero(angular));
  const bool isAccelerated = request.set_acceleration &&
                             !(isZero(request.state.acceleration.linear) && isZero(request.state.acceleration.angular));
  if (model->isStatic() && (isMoved || isAccelerated)) {
    return failed("'" + request.entity + "' is static: it can't be given a velocity or an acceleration");
  }
  if (request.set_acceleration && !request.set_pose && !request.set_twist) {
    return refused(Result::kResultFeatureUnsupported,
                   "an acceleration can't be set: apply forces instead (with the topic of apply-link-wrench)");
  }

  if (request.set_pose) {
    const Outcome<void> moved = model->setPose(frame->pose * poseOf(request.state.pose));
    if (!moved) return failed(moved.error);
  }
  if (request.set_twist && !model->isStatic()) {
    // v_W = v_WF + w_WF x (p - p_F) + R_WF v_F
    const Vector3 arm = model->pose().position - frame->pose.position;
    model->setVelocity(frame->linear + frame->angular.cross(arm) + frame->pose.rotation * vectorOf(linear),
                       frame->angular + frame->pose.rotation * vectorOf(angular));
  }
  Result result = succeeded();
  if (isAccelerated) result.error_message = "the acceleration is ignored: apply forces instead";
  return result;
}

}  // namespace pongsim::ros2
