#include "ros2/pairs/covariance.hh"

#include "ros2/pairs/convert.hh"

namespace pongsim::ros2 {

void convert(const ignition::msgs::PoseWithCovariance& from, geometry_msgs::PoseWithCovariance& to) {
  convert(from.pose(), to.pose);
  copyToArray(from.covariance().data(), to.covariance);
}

void convert(const geometry_msgs::PoseWithCovariance& from, ignition::msgs::PoseWithCovariance& to) {
  convert(from.pose, *to.mutable_pose());
  to.mutable_covariance()->clear_data();
  for (const double value : from.covariance) to.mutable_covariance()->add_data(static_cast<float>(value));
}

void convert(const ignition::msgs::TwistWithCovariance& from, geometry_msgs::TwistWithCovariance& to) {
  convert(from.twist(), to.twist);
  copyToArray(from.covariance().data(), to.covariance);
}

void convert(const geometry_msgs::TwistWithCovariance& from, ignition::msgs::TwistWithCovariance& to) {
  convert(from.twist, *to.mutable_twist());
  to.mutable_covariance()->clear_data();
  for (const double value : from.covariance) to.mutable_covariance()->add_data(static_cast<float>(value));
}

}  // namespace pongsim::ros2
