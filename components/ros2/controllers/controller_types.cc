#include "ros2/controllers/controller_types.hh"

#include <algorithm>

#include "ros2/controllers/diff_drive_controller/diff_drive_controller.hh"
#include "ros2/controllers/forward_command_controller/forward_command_controller.hh"
#include "ros2/controllers/gripper_action_controller/gripper_action_controller.hh"
#include "ros2/controllers/imu_sensor_broadcaster/imu_sensor_broadcaster.hh"
#include "ros2/controllers/joint_state_broadcaster/joint_state_broadcaster.hh"
#include "ros2/controllers/joint_trajectory_controller/joint_trajectory_controller.hh"
#include "ros2/controllers/mecanum_drive_controller/mecanum_drive_controller.hh"
#include "ros2/controllers/steering_controllers/steering_controller.hh"
#include "ros2/controllers/tricycle_controller/tricycle_controller.hh"

namespace pongsim::ros2 {

namespace {

using Made = std::unique_ptr<Controller>;

template <class Class, auto... kArguments>
Made make() {
  return std::make_unique<Class>(kArguments...);
}

constexpr ControllerType kControllerTypes[] = {
    {"ackermann_steering_controller/AckermannSteeringController",
     make<SteeringController, SteeringController::Kind::kAckermann>},
    {"bicycle_steering_controller/BicycleSteeringController",
     make<SteeringController, SteeringController::Kind::kBicycle>},
    {"diff_drive_controller/DiffDriveController", make<DiffDriveController>},
    {"effort_controllers/GripperActionController",
     make<GripperActionController, GripperActionController::Kind::kEffort>},
    {"effort_controllers/JointGroupEffortController",
     []() -> Made { return std::make_unique<ForwardCommandController>("effort"); }},
    {"forward_command_controller/ForwardCommandController",
     []() -> Made { return std::make_unique<ForwardCommandController>(""); }},
    {"forward_command_controller/MultiInterfaceForwardCommandController",
     []() -> Made { return std::make_unique<ForwardCommandController>("*"); }},
    {"imu_sensor_broadcaster/IMUSensorBroadcaster", make<ImuSensorBroadcaster>},
    {"joint_state_broadcaster/JointStateBroadcaster", make<JointStateBroadcaster>},
    {"joint_trajectory_controller/JointTrajectoryController", make<JointTrajectoryController>},
    {"mecanum_drive_controller/MecanumDriveController", make<MecanumDriveController>},
    {"parallel_gripper_action_controller/GripperActionController",
     make<GripperActionController, GripperActionController::Kind::kParallel>},
    {"position_controllers/GripperActionController",
     make<GripperActionController, GripperActionController::Kind::kPosition>},
    {"position_controllers/JointGroupPositionController",
     []() -> Made { return std::make_unique<ForwardCommandController>("position"); }},
    {"tricycle_controller/TricycleController", make<TricycleController>},
    {"tricycle_steering_controller/TricycleSteeringController",
     make<SteeringController, SteeringController::Kind::kTricycle>},
    {"velocity_controllers/JointGroupVelocityController",
     []() -> Made { return std::make_unique<ForwardCommandController>("velocity"); }},
};

}  // namespace

std::span<const ControllerType> controllerTypes() { return kControllerTypes; }

std::unique_ptr<Controller> makeController(std::string_view type) {
  const auto found = std::ranges::find(kControllerTypes, type, &ControllerType::name);
  return found == std::end(kControllerTypes) ? nullptr : found->make();
}

}  // namespace pongsim::ros2
