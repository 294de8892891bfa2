#include "ros2/services/simulate_steps.hh"

#include <ignition/msgs/boolean.pb.h>
#include <ignition/msgs/world_control.pb.h>

#include <algorithm>
#include <limits>
#include <utility>

#include "ros2/node/stamp.hh"

namespace pongsim::ros2 {

namespace {

using Status = action_msgs::GoalStatus;
using Code = simulation_interfaces::Result;

// Maximum number of steps per request.
constexpr std::uint64_t kMostAtOnce = std::numeric_limits<std::uint32_t>::max();

}  // namespace

SimulateSteps::SimulateSteps(const Node& simulation, const std::string& control, RosNode& ros, const std::string& name)
    : simulation_(simulation),
      control_(control),
      server_(
          ros, name, [this] { return stampOf(info_.time); },
          ActionServer<Action>::Handlers{
              .accepts = {},
              .execute = [this](const Goals::Id& id, const Action::Goal& goal) { start(id, goal.steps); },
              .cancels = [this](const Goals::Id& id) { return running_ && running_->id == id; }}) {}

void SimulateSteps::start(const Goals::Id& id, std::uint64_t steps) {
  const auto refuse = [&](const std::string& why) {
    server_.end(id, Status::kStatusAborted, {{Code::kResultOperationFailed, why}});
  };
  if (running_) return refuse("the simulation is not paused: another goal steps it");
  if (!info_.paused) return refuse("the simulation is not paused");
  if (steps == 0) return refuse("the number of steps must be above 0");
  running_ = {id, steps, info_.iteration};
  askForSteps();
}

void SimulateSteps::askForSteps() {
  const std::uint64_t count = std::min(running_->steps - running_->requested, kMostAtOnce);
  running_->requested += count;
  running_->isTaken = false;
  ignition::msgs::WorldControl request;
  request.set_pause(true);
  request.set_multi_step(static_cast<std::uint32_t>(count));
  request_ = simulation_.request(control_, request, ignition::msgs::Boolean::descriptor()->full_name(),
                                 [this](const CallResult& result, const Message&) {
                                   if (!running_) return;
                                   running_->isTaken = true;
                                   if (!result) end(Status::kStatusAborted, Code::kResultOperationFailed, result.error);
                                 });
  if (!request_) {
    end(Status::kStatusAborted, Code::kResultOperationFailed,
        "nothing controls this simulation: there is no service '" + control_ + "'");
  }
}

void SimulateSteps::stop() {
  running_->isStopping = true;
  ignition::msgs::WorldControl request;
  request.set_pause(true);
  request_ =
      simulation_.request(control_, request, ignition::msgs::Boolean::descriptor()->full_name(),
                          [this](const CallResult& result, const Message&) {
                            if (!running_) return;
                            if (!result) {
                              end(Status::kStatusAborted, Code::kResultOperationFailed, result.error);
                            } else {
                              end(Status::kStatusCanceled, Code::kResultOperationFailed, "cancelled " + progress());
                            }
                          });
  if (!request_) end(Status::kStatusAborted, Code::kResultOperationFailed, "the run has ended");
}

void SimulateSteps::preUpdate(const StepInfo& info) {
  info_ = info;
  if (!running_) return;
  if (!running_->isStopping && server_.isCanceling(running_->id)) return stop();
  if (running_->isStopping || !running_->isTaken) return;
  if (running_->completed == running_->steps) {
    if (info.paused) return end(Status::kStatusSucceeded, Code::kResultOk, {});
    return end(Status::kStatusAborted, Code::kResultOperationFailed, "the simulation was resumed meanwhile");
  }
  if (info.paused) end(Status::kStatusAborted, Code::kResultOperationFailed, "it was paused " + progress());
}

void SimulateSteps::postUpdate(const StepInfo& info) {
  if (!running_ || info.paused) return;
  running_->completed = info.iteration - running_->first;
  server_.publishFeedback(running_->id, {running_->completed, running_->steps - running_->completed});
  if (running_->completed == running_->requested && running_->requested < running_->steps) askForSteps();
}

void SimulateSteps::reset() {
  if (running_) end(Status::kStatusAborted, Code::kResultOperationFailed, "the world was reset " + progress());
}

void SimulateSteps::end(std::int8_t status, std::uint8_t code, const std::string& message) {
  const Goals::Id id = running_->id;
  running_.reset();
  server_.end(id, status, {{code, message}});
}

std::string SimulateSteps::progress() const {
  return "after " + std::to_string(running_->completed) + " of " + std::to_string(running_->steps) + " steps";
}

}  // namespace pongsim::ros2
