#pragma once

#include <ignition/msgs/odometry.pb.h>
#include <ignition/msgs/pose_v.pb.h>

#include <optional>
#include <string>

#include "pongsim/control/planar_odometry.hh"
#include "pongsim/math.hh"
#include "pongsim/messages/fields.hh"
#include "pongsim/node.hh"
#include "pongsim/parameters.hh"
#include "pongsim/state/state_archive.hh"
#include "pongsim/system.hh"

namespace pongsim {

/// The parameters and topics with which a drive publishes its odometry.
class OdometryTopics {
 public:
  void declare(Declaration& declaration) {
    declaration.parameter("odom_publish_frequency", &frequency_, "Hz",
                          "messages per simulated second; 0: one per step");
    declaration.parameter("odom_topic", &odometryTopic_, "", "topic of odometry").otherwise("/model/M/odometry");
    declaration.parameter("tf_topic", &tfTopic_, "", "topic of the base's pose").otherwise("/model/M/tf");
    declaration.parameter("frame_id", &frame_, "", "frame of the odometry, in the headers").otherwise("M/odom");
    declaration.parameter("child_frame_id", &childFrame_, "", "frame of the vehicle, in the headers")
        .otherwise("M/ and the canonical link");
    declaration.publishes("<odom_topic>", "ignition.msgs.Odometry", "pose relative to the start, and velocity");
    declaration.publishes("<tf_topic>", "ignition.msgs.Pose_V", "the same pose");
  }

  /// @param base The link whose odometry it is; unset: the model's canonical link.
  void open(const Model& model, Node& node, std::optional<Link> base = std::nullopt) {
    const std::string name(model.name());
    if (!base) base = model.canonicalLink();
    if (frame_.empty()) frame_ = name + "/odom";
    if (childFrame_.empty() && base) childFrame_ = name + "/" + std::string(base->name());
    odometryPublisher_ =
        node.advertise<ignition::msgs::Odometry>(topicOr(odometryTopic_, "/model/" + name + "/odometry"));
    tfPublisher_ = node.advertise<ignition::msgs::Pose_V>(topicOr(tfTopic_, "/model/" + name + "/tf"));
  }

  /// Publishes odometry when it is due and has subscribers. Call it in each `postUpdate` that is not paused.
  void update(const PlanarOdometry& odometry, Time now) {
    if (now - last_ < periodOf(frequency_)) return;
    last_ = now;
    if (odometryPublisher_.hasSubscribers()) {
      setHeader(now, *message_.mutable_header());
      setPlace(odometry, *message_.mutable_pose());
      message_.mutable_twist()->mutable_linear()->set_x(odometry.linearVelocity);
      message_.mutable_twist()->mutable_linear()->set_y(odometry.lateralVelocity);
      message_.mutable_twist()->mutable_angular()->set_z(odometry.angularVelocity);
      odometryPublisher_.publish(message_);
    }
    if (tfPublisher_.hasSubscribers()) {
      if (tfMessage_.pose_size() == 0) tfMessage_.add_pose();
      setHeader(now, *tfMessage_.mutable_pose(0)->mutable_header());
      setPlace(odometry, *tfMessage_.mutable_pose(0));
      tfPublisher_.publish(tfMessage_);
    }
  }

  void reset() { last_ = Time::zero(); }
  void transfer(StateArchive& archive) { archive(last_); }

 private:
  void setHeader(Time now, ignition::msgs::Header& header) const {
    setStamp(now, header);
    if (header.data_size() > 0) return;
    setHeaderValue("frame_id", frame_, header);
    setHeaderValue("child_frame_id", childFrame_, header);
  }

  static void setPlace(const PlanarOdometry& odometry, ignition::msgs::Pose& pose) {
    pose.mutable_position()->set_x(odometry.x);
    pose.mutable_position()->set_y(odometry.y);
    pose.mutable_orientation()->set_z(math::sin(odometry.heading / 2));
    pose.mutable_orientation()->set_w(math::cos(odometry.heading / 2));
  }

  double frequency_ = 50;
  std::string odometryTopic_;
  std::string tfTopic_;
  std::string frame_;
  std::string childFrame_;
  Time last_{0};
  Publisher odometryPublisher_;
  Publisher tfPublisher_;
  ignition::msgs::Odometry message_;
  ignition::msgs::Pose_V tfMessage_;
};

}  // namespace pongsim
