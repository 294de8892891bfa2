#include "ros2/controllers/gripper_action_controller/gripper_action_controller.hh"

#include <algorithm>
#include <cmath>

#include "pongsim/commands.hh"
#include "ros2/node/stamp.hh"

namespace pongsim::ros2 {

namespace {
using GripperStatus = action_msgs::GoalStatus;
}

Outcome<void> GripperActionController::configure(const ControllerSetup& setup) {
  ControllerParameters& parameters = setup.parameters;
  log_ = &setup.log;
  name_ = setup.ros.options().name;
  now_ = setup.now;
  joint_ = parameters.text("joint", "");
  if (joint_.empty()) parameters.complain("'joint' is missing");
  tolerance_ = parameters.number("goal_tolerance", 0.01);
  maxEffort_ = parameters.number("max_effort", 0);
  allowsStalling_ = parameters.flag("allow_stalling", false);
  stallVelocity_ = parameters.number("stall_velocity_threshold", 0.001);
  stallTimeout_ = parameters.number("stall_timeout", 1);
  // goals end in the update that decides on them
  parameters.ignore("action_monitor_rate");
  parameters.ignore("state_interfaces");
  if (kind_ == Kind::kEffort) pid_ = JointPid::read(parameters, joint_);
  offer(setup);
  return {};
}

void GripperActionController::offer(const ControllerSetup& setup) {
  const std::string name = setup.remaps.apply(setup.ros, "~/gripper_cmd");
  const auto clock = [this] { return stampOf(now_()); };
  const auto cancels = [this](const Goal& id) { return isCanceled_ = goal_ == id; };
  if (kind_ == Kind::kParallel) {
    parallel_ = std::make_unique<ActionServer<Parallel>>(
        setup.ros, name, clock,
        ActionServer<Parallel>::Handlers{
            [this](const Parallel::Goal& goal) {
              return goal.command.position.size() == 1 && accepts(goal.command.position[0]);
            },
            [this](const Goal& id, const Parallel::Goal& goal) {
              const auto& efforts = goal.command.effort;
              begin(id, goal.command.position[0], efforts.empty() ? maxEffort_ : efforts[0]);
            },
            cancels});
    return;
  }
  gripper_ = std::make_unique<ActionServer<Gripper>>(
      setup.ros, name, clock,
      ActionServer<Gripper>::Handlers{[this](const Gripper::Goal& goal) { return accepts(goal.command.position); },
                                      [this](const Goal& id, const Gripper::Goal& goal) {
                                        begin(id, goal.command.position, goal.command.max_effort);
                                      },
                                      cancels});
}

Controller::Interfaces GripperActionController::interfaces() const {
  return {.commands = {joint_ + (kind_ == Kind::kEffort ? "/effort" : "/position")},
          .states = {joint_ + "/position", joint_ + "/velocity"}};
}

bool GripperActionController::accepts(double position) const {
  const bool isSound = std::abs(position) <= kLargestCommand;
  if (!isSound)
    log_->warning("controller '" + name_ + "': a goal is refused: its position is not finite, or very large");
  return isSound && !loan_.commands.empty();
}

void GripperActionController::begin(const Goal& id, double position, double effort) {
  end(GripperStatus::kStatusCanceled, false, false);
  goal_ = id;
  target_ = position;
  effort_ = effort;
  moved_ = now_();
}

void GripperActionController::end(std::int8_t status, bool isStalled, bool isReached) {
  if (goal_) {
    const double position = loan_.states[0]->read();
    if (gripper_) gripper_->end(*goal_, status, {position, commanded_, isStalled, isReached});
    if (parallel_) {
      Parallel::Result result;
      result.state.position = {position};
      result.state.effort = {commanded_};
      result.stalled = isStalled;
      result.reached_goal = isReached;
      parallel_->end(*goal_, status, result);
    }
  }
  goal_.reset();
  isCanceled_ = false;
}

Outcome<void> GripperActionController::activate(const Loan& loan, Time) {
  loan_ = loan;
  reset();
  return {};
}

void GripperActionController::deactivate() {
  end(GripperStatus::kStatusAborted, false, false);
  loan_ = {};
}

void GripperActionController::reset() {
  end(GripperStatus::kStatusAborted, false, false);
  target_.reset();
  effort_ = maxEffort_;
  commanded_ = 0;
  moved_ = Time::zero();
  pid_.reset();
}

void GripperActionController::update(Time now, double period) {
  const double position = loan_.states[0]->read(), velocity = loan_.states[1]->read();
  if (isCanceled_) {
    end(GripperStatus::kStatusCanceled, false, false);
    target_.reset();
  }
  if (!target_) {
    target_ = position;
    effort_ = maxEffort_;
  }
  if (goal_ && std::abs(*target_ - position) < tolerance_) {
    end(GripperStatus::kStatusSucceeded, false, true);
  } else if (std::abs(velocity) > stallVelocity_) {
    moved_ = now;
  } else if (goal_ && toSeconds(now - moved_) > stallTimeout_) {
    end(allowsStalling_ ? GripperStatus::kStatusSucceeded : GripperStatus::kStatusAborted, true, false);
  }
  command(position, velocity, period);
}

void GripperActionController::command(double position, double velocity, double period) {
  if (kind_ != Kind::kEffort) {
    commanded_ = effort_;
    return loan_.commands[0]->set(*target_);
  }
  const double limit = std::abs(effort_);
  commanded_ = std::clamp(pid_.command(*target_ - position, -velocity, 0, period), -limit, limit);
  loan_.commands[0]->set(commanded_);
}

void GripperActionController::transfer(StateArchive& archive) {
  archive(pid_);
  archive(target_);
  archive(effort_);
  archive(commanded_);
  archive(moved_);
}

}  // namespace pongsim::ros2
