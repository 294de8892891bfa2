#include "ros2/services/run_requests.hh"

#include <ignition/msgs/boolean.pb.h>
#include <ignition/msgs/empty.pb.h>
#include <ignition/msgs/server_control.pb.h>
#include <ignition/msgs/stringmsg_v.pb.h>
#include <ignition/msgs/world_control.pb.h>

#include <algorithm>
#include <limits>
#include <utility>

namespace pongsim::ros2 {

namespace si = simulation_interfaces;

namespace {

constexpr const char* kNobodyRuns = "nothing controls this simulation: a program steps it itself";

const std::string& boolean() {
  static const std::string name = ignition::msgs::Boolean::descriptor()->full_name();
  return name;
}

}  // namespace

RunRequests::RunRequests(const Node& simulation, const ServiceNames& names)
    : requests_(simulation), names_(names), node_(simulation) {}

bool RunRequests::canBeAsked() {
  // this service has no effect, and exists wherever the others do
  return static_cast<bool>(node_.request("/gazebo/worlds", ignition::msgs::Empty(),
                                         ignition::msgs::StringMsg_V::descriptor()->full_name(), {}));
}

void RunRequests::preUpdate(const StepInfo& info) {
  info_ = info;
  // while paused this is the number of steps made, otherwise it includes the current one
  if (!info.paused) isStartPaused_ = false;
  requests_.sweep();
  lookAtSteps();
}

void RunRequests::worldReset() {
  isStartPaused_ = false;
  info_.iteration = 0;
  info_.time = Time::zero();
  if (stepping_) endSteps(failed("the world was reset meanwhile"));
}

std::uint8_t RunRequests::state() const {
  if (!info_.paused) return State::kStatePlaying;
  return info_.iteration == 0 && !isStartPaused_ ? State::kStateStopped : State::kStatePaused;
}

void RunRequests::setState(std::uint8_t target, Done done) {
  using Response = si::srv::SetSimulationState::Response;
  const std::uint8_t now = state();
  if (target == State::kStateNoWorld || target == State::kStateLoadingWorld) {
    return done(refused(Response::kIncorrectTransition, "the one world can't be loaded or unloaded"));
  }
  if (target > State::kStateLoadingWorld) {
    return done(refused(Response::kIncorrectTransition, "there is no state " + std::to_string(target)));
  }
  if (target == now) {
    return done(refused(Response::kAlreadyInTargetState, "the simulation is already in that state"));
  }
  switch (target) {
    case State::kStatePlaying:
      return control({}, Response::kStateTransitionError, std::move(done));
    case State::kStateStopped:
      return control({.pause = true, .reset = true}, Response::kStateTransitionError, std::move(done));
    case State::kStatePaused:
      return control({.pause = true}, Response::kStateTransitionError, [this, now, done](const Result& result) {
        isStartPaused_ = isOk(result) && now == State::kStateStopped;
        done(result);
      });
    default:
      break;
  }
  ignition::msgs::ServerControl stop;
  stop.set_stop(true);
  const auto answered = [done](const std::string& error) {
    done(error.empty() ? succeeded() : refused(Response::kStateTransitionError, error));
  };
  if (!requests_.send("/server_control", stop, boolean(), answered)) {
    done(refused(Response::kStateTransitionError, kNobodyRuns));
  }
}

void RunRequests::step(std::uint64_t count, Done done) {
  if (count == 0) return done(failed("the number of steps must be above 0"));
  if (stepping_) return done(failed("another request is stepping"));
  if (!info_.paused) return done(failed("the simulation is not paused"));
  if (count > std::numeric_limits<std::uint32_t>::max()) {
    return done(failed(std::to_string(count) + " steps are more than 4294967295, the most for one request"));
  }
  stepping_ = Stepping{info_.iteration, count, std::move(done)};
  control({.pause = true, .steps = count}, Result::kResultOperationFailed, [this](const Result& result) {
    if (!stepping_) return;
    stepping_->isAnswered = true;
    if (!isOk(result)) endSteps(result);
  });
}

/// The run is paused again after its steps, or because somebody paused it.
void RunRequests::lookAtSteps() {
  if (!stepping_ || !stepping_->isAnswered) return;
  const std::uint64_t made = info_.iteration - (info_.paused ? 0 : 1) - stepping_->first;
  if (!info_.paused && made < stepping_->count) return;
  if (!info_.paused) return endSteps(failed("the simulation was resumed meanwhile"));
  if (made == stepping_->count) return endSteps(succeeded());
  endSteps(failed("the simulation was stopped after " + std::to_string(made) + " of " +
                  std::to_string(stepping_->count) + " steps"));
}

void RunRequests::endSteps(const Result& result) {
  const Done done = std::move(std::exchange(stepping_, std::nullopt)->done);
  done(result);
}

void RunRequests::resetAll(bool isStepped, Done done) {
  // a pause during the steps takes effect after them
  control({.pause = info_.paused || isStepped || stepping_.has_value(), .reset = true}, Result::kResultOperationFailed,
          std::move(done));
}

void RunRequests::control(const Control& what, std::uint8_t errorCode, Done done) {
  ignition::msgs::WorldControl request;
  request.set_pause(what.pause);
  request.set_multi_step(static_cast<std::uint32_t>(what.steps));
  if (what.reset) request.mutable_reset()->set_all(true);
  const auto answered = [done, errorCode](const std::string& error) {
    done(error.empty() ? succeeded() : refused(errorCode, error));
  };
  if (!requests_.send(names_.inSimulation("control"), request, boolean(), answered)) {
    done(refused(errorCode, kNobodyRuns));
  }
}

}  // namespace pongsim::ros2
