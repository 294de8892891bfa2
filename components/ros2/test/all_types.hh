#pragma once

#include "ros2/types/ackermann_msgs.hh"
#include "ros2/types/action_msgs.hh"
#include "ros2/types/actuator_msgs.hh"
#include "ros2/types/control_actions.hh"
#include "ros2/types/control_msgs.hh"
#include "ros2/types/controller_manager_services.hh"
#include "ros2/types/gps_msgs.hh"
#include "ros2/types/lifecycle_msgs.hh"
#include "ros2/types/nav_msgs.hh"
#include "ros2/types/ros_gz_interfaces.hh"
#include "ros2/types/rosgraph_msgs.hh"
#include "ros2/types/sensor_msgs.hh"
#include "ros2/types/simulation_actions.hh"
#include "ros2/types/simulation_entity_services.hh"
#include "ros2/types/simulation_world_services.hh"
#include "ros2/types/std_srvs.hh"
#include "ros2/types/tf2_msgs.hh"
#include "ros2/types/trajectory_msgs.hh"
#include "ros2/types/vision_msgs.hh"

namespace pongsim::ros2 {

template <class... Types>
struct TypeList {
  /// Calls `each.template operator()<Type>()` with each.
  static void forEach(auto&& each) { (each.template operator()<Types>(), ...); }
};

/// All messages.
using Messages = TypeList<
    builtin_interfaces::Time, builtin_interfaces::Duration, rosgraph_msgs::Clock, std_msgs::Bool, std_msgs::ColorRGBA,
    std_msgs::Empty, std_msgs::Float32, std_msgs::Float64, std_msgs::Header, std_msgs::Int32, std_msgs::UInt32,
    std_msgs::String, geometry_msgs::Point, geometry_msgs::Quaternion, geometry_msgs::Pose, geometry_msgs::PoseArray,
    geometry_msgs::PoseStamped, geometry_msgs::PoseWithCovariance, geometry_msgs::Vector3, geometry_msgs::Transform,
    geometry_msgs::TransformStamped, geometry_msgs::Twist, geometry_msgs::TwistStamped,
    geometry_msgs::TwistWithCovariance, geometry_msgs::TwistWithCovarianceStamped, geometry_msgs::Wrench,
    geometry_msgs::WrenchStamped, geometry_msgs::Accel, nav_msgs::Odometry, sensor_msgs::BatteryState,
    sensor_msgs::RegionOfInterest, sensor_msgs::CameraInfo, sensor_msgs::FluidPressure, sensor_msgs::Image,
    sensor_msgs::Imu, sensor_msgs::JointState, sensor_msgs::Joy, sensor_msgs::LaserScan, sensor_msgs::MagneticField,
    sensor_msgs::NavSatStatus, sensor_msgs::NavSatFix, sensor_msgs::PointField, sensor_msgs::PointCloud2,
    trajectory_msgs::JointTrajectoryPoint, trajectory_msgs::JointTrajectory, tf2_msgs::TFMessage, vision_msgs::Point2D,
    vision_msgs::Pose2D, vision_msgs::BoundingBox2D, vision_msgs::ObjectHypothesis,
    vision_msgs::ObjectHypothesisWithPose, vision_msgs::Detection2D, vision_msgs::Detection2DArray,
    vision_msgs::BoundingBox3D, vision_msgs::Detection3D, vision_msgs::Detection3DArray, actuator_msgs::Actuators,
    gps_msgs::GPSStatus, gps_msgs::GPSFix, rcl_interfaces::Log, rcl_interfaces::ParameterValue,
    rcl_interfaces::Parameter, rcl_interfaces::FloatingPointRange, rcl_interfaces::IntegerRange,
    rcl_interfaces::ParameterDescriptor, rcl_interfaces::ParameterEvent, rcl_interfaces::ParameterType,
    rcl_interfaces::ListParametersResult, rcl_interfaces::SetParametersResult, action_msgs::GoalInfo,
    action_msgs::GoalStatus, action_msgs::GoalStatusArray, ros_gz_interfaces::Altimeter, ros_gz_interfaces::Entity,
    ros_gz_interfaces::JointWrench, ros_gz_interfaces::Contact, ros_gz_interfaces::Contacts,
    ros_gz_interfaces::Dataframe, ros_gz_interfaces::EntityFactory, ros_gz_interfaces::EntityWrench,
    ros_gz_interfaces::Float32Array, ros_gz_interfaces::TrackVisual, ros_gz_interfaces::GuiCamera,
    ros_gz_interfaces::Light, ros_gz_interfaces::ParamVec, ros_gz_interfaces::SensorNoise, ros_gz_interfaces::StringVec,
    ros_gz_interfaces::VideoRecord, ros_gz_interfaces::WorldReset, ros_gz_interfaces::WorldControl,
    simulation_interfaces::Bounds, simulation_interfaces::EntityCategory, simulation_interfaces::TagsFilter,
    simulation_interfaces::EntityFilters, simulation_interfaces::EntityInfo, simulation_interfaces::EntityState,
    simulation_interfaces::NamedPose, simulation_interfaces::Resource, simulation_interfaces::Result,
    simulation_interfaces::SimulationState, simulation_interfaces::SimulatorFeatures,
    simulation_interfaces::SpawnEntity, simulation_interfaces::SpawnResult, simulation_interfaces::Spawnable,
    simulation_interfaces::WorldResource, std_msgs::MultiArrayDimension, std_msgs::MultiArrayLayout,
    std_msgs::Float64MultiArray, trajectory_msgs::MultiDOFJointTrajectoryPoint,
    trajectory_msgs::MultiDOFJointTrajectory, ackermann_msgs::AckermannDrive, lifecycle_msgs::State,
    control_msgs::InterfaceValue, control_msgs::DynamicJointState, control_msgs::SteeringControllerStatus,
    control_msgs::MecanumDriveControllerState, control_msgs::JointTolerance, control_msgs::JointComponentTolerance,
    control_msgs::GripperCommand, control_msgs::JointTrajectoryControllerState,
    controller_manager_msgs::ChainConnection, controller_manager_msgs::ControllerState,
    controller_manager_msgs::HardwareInterface, controller_manager_msgs::HardwareComponentState,
    controller_manager_msgs::NamedLifecycleState, controller_manager_msgs::ControllerManagerActivity>;

/// All services.
using Services =
    TypeList<rcl_interfaces::srv::DescribeParameters, rcl_interfaces::srv::GetParameterTypes,
             rcl_interfaces::srv::GetParameters, rcl_interfaces::srv::ListParameters,
             rcl_interfaces::srv::SetParameters, rcl_interfaces::srv::SetParametersAtomically,
             action_msgs::srv::CancelGoal, ros_gz_interfaces::srv::ControlWorld, ros_gz_interfaces::srv::DeleteEntity,
             ros_gz_interfaces::srv::SetEntityPose, ros_gz_interfaces::srv::SpawnEntity,
             simulation_interfaces::srv::DeleteEntity, simulation_interfaces::srv::GetEntities,
             simulation_interfaces::srv::GetEntitiesStates, simulation_interfaces::srv::GetEntityBounds,
             simulation_interfaces::srv::GetEntityInfo, simulation_interfaces::srv::GetEntityState,
             simulation_interfaces::srv::GetNamedPoseBounds, simulation_interfaces::srv::GetNamedPoses,
             simulation_interfaces::srv::GetSpawnables, simulation_interfaces::srv::SetEntityInfo,
             simulation_interfaces::srv::SetEntityState, simulation_interfaces::srv::SpawnEntities,
             simulation_interfaces::srv::SpawnEntity, simulation_interfaces::srv::GetAvailableWorlds,
             simulation_interfaces::srv::GetCurrentWorld, simulation_interfaces::srv::GetSimulationState,
             simulation_interfaces::srv::GetSimulatorFeatures, simulation_interfaces::srv::LoadWorld,
             simulation_interfaces::srv::ResetSimulation, simulation_interfaces::srv::SetSimulationState,
             simulation_interfaces::srv::StepSimulation, simulation_interfaces::srv::UnloadWorld,
             controller_manager_msgs::srv::CleanupController, controller_manager_msgs::srv::ConfigureController,
             controller_manager_msgs::srv::ListControllerTypes, controller_manager_msgs::srv::ListControllers,
             controller_manager_msgs::srv::ListHardwareComponents, controller_manager_msgs::srv::ListHardwareInterfaces,
             controller_manager_msgs::srv::LoadController, controller_manager_msgs::srv::ReloadControllerLibraries,
             controller_manager_msgs::srv::SetHardwareComponentState, controller_manager_msgs::srv::SwitchController,
             controller_manager_msgs::srv::UnloadController, std_srvs::srv::Empty>;

/// All actions.
using Actions = TypeList<simulation_interfaces::action::SimulateSteps, control_msgs::action::FollowJointTrajectory,
                         control_msgs::action::GripperCommand, control_msgs::action::ParallelGripperCommand>;

/// Calls `each.template operator()<Type>()` with all messages, with the requests and responses of all services, and
/// with the wire types of all actions.
void forAllTypes(auto&& each) {
  Messages::forEach(each);
  Services::forEach([&each]<class Service>() {
    each.template operator()<typename Service::Request>();
    each.template operator()<typename Service::Response>();
  });
  Actions::forEach([&each]<class Action>() {
    each.template operator()<typename Action::Goal>();
    each.template operator()<typename Action::Result>();
    each.template operator()<typename Action::Feedback>();
    each.template operator()<typename SendGoal<Action>::Request>();
    each.template operator()<typename SendGoal<Action>::Response>();
    each.template operator()<typename GetResult<Action>::Request>();
    each.template operator()<typename GetResult<Action>::Response>();
    each.template operator()<FeedbackMessage<Action>>();
  });
}

}  // namespace pongsim::ros2
