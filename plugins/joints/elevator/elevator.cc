#include <ignition/msgs/double.pb.h>
#include <ignition/msgs/int32.pb.h>
#include <ignition/msgs/laserscan.pb.h>

#include <algorithm>
#include <cctype>
#include <cmath>
#include <cstddef>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "elevator_machine.hh"
#include "pongsim/parameters.hh"
#include "pongsim/system.hh"

namespace pongsim {

namespace {

constexpr double kDoorSlack = 0.02;
constexpr double kCabinSlack = 0.15;
constexpr double kStillSpeed = 0.01;
/// A hit counts if it is closer than the lidar's maximum range by this much [m].
constexpr double kScanSlack = 0.005;

bool isNumbered(std::string_view name, std::string_view prefix) {
  if (!name.starts_with(prefix) || name.size() == prefix.size()) return false;
  return std::ranges::all_of(name.substr(prefix.size()), [](unsigned char c) { return std::isdigit(c) != 0; });
}

/// Commands a joint through the topic of its JointPositionController.
class PositionedJoint {
 public:
  PositionedJoint(const Joint& joint, const std::string& prefix, Node& node)
      : joint_(joint),
        command_(node.advertise<ignition::msgs::Double>(
            cleanTopic(prefix + "/joint/" + std::string(joint.name()) + "/0/cmd_pos"))) {}

  void send(double position) {
    ignition::msgs::Double message;
    message.set_data(position);
    command_.publish(message);
  }
  /// As in Fortress, a joint that moves backwards counts as still.
  bool isAt(double position, double slack) const {
    return std::abs(position - joint_.position()) <= slack && joint_.velocity() <= kStillSpeed;
  }
  double position() const { return joint_.position(); }

 private:
  Joint joint_;
  Publisher command_;
};

/// Runs an elevator: a cabin on a sliding joint, and a door on each floor.
class Elevator : public System {
 public:
  void declare(Declaration& declaration) override {
    declaration.is("Runs an elevator, using JointPositionControllers for its cabin and doors.",
                   Declaration::Place::kModel);
    declaration.parameter("update_rate", &updateRate_, "1/s", "update rate; 0: each step").mayBeInfinite();
    declaration.parameter("floor_link_prefix", &floorPrefix_, "",
                          "name of the floors' links before their number, which counts from 0");
    declaration.parameter("door_joint_prefix", &doorPrefix_, "", "the same for the doors' joints, one for each floor");
    declaration.parameter("cabin_joint", &cabinName_, "", "joint of the cabin");
    declaration.parameter("open_door_wait_duration", &wait_, "s", "how long a door stays open").atMost(1e9);
    declaration.parameter("cmd_topic", &commandTopic_, "", "topic of floor calls").otherwise("/model/M/cmd");
    declaration.parameter("state_topic", &stateTopic_, "", "topic of the current floor").otherwise("/model/M/state");
    declaration.parameter("state_publish_rate", &stateRate_, "1/s", "rate of the state; 0: the update rate")
        .mayBeInfinite();
    declaration.subscribes("<cmd_topic>", "ignition.msgs.Int32", "floor to go to");
    declaration.subscribes("/model/M/J/lidar", "ignition.msgs.LaserScan",
                           "one per door: if its first range is below the maximum, the door stays open");
    declaration.publishes("<state_topic>", "ignition.msgs.Int32", "floor nearest to the cabin");
    declaration.publishes("/model/M/joint/J/0/cmd_pos", "ignition.msgs.Double",
                          "targets of the cabin [m] and the doors: heights of the floors, upper limits, 0");
    declaration.sharesTopics();
  }

  void configure(const SystemContext& context) override {
    log_ = &context.log;
    const Model& model = *context.model;
    const std::string prefix = "/model/" + std::string(model.name());
    findFloors(model, context.sdf);
    const std::optional<Joint> cabin = model.joint(cabinName_);
    cabin_.emplace(requireAxis(cabin, cabinName_, "cabin", context.sdf), prefix, context.node);
    for (std::size_t floor = 0; floor < heights_.size(); ++floor) addDoor(floor, model, prefix, context);

    state_ = context.node.advertise<ignition::msgs::Int32>(topicOr(stateTopic_, prefix + "/state"));
    command_ = context.node.subscribe<ignition::msgs::Int32>(topicOr(commandTopic_, prefix + "/cmd"),
                                                             [this](const auto& message) { receive(message.data()); });
    updatePeriod_ = periodOf(updateRate_);
    statePeriod_ = periodOf(stateRate_);
    machine_.emplace(fromSeconds(std::max(wait_, 0.0)),
                     ElevatorMachine::Doings{
                         [this](int floor) { cabin_->send(heightOf(floor)); },
                         [this](int floor) { return cabin_->isAt(heightOf(floor), kCabinSlack); },
                         [this](int floor, bool open) { doorAt(floor).joint.send(open ? doorAt(floor).open : 0); },
                         [this](int floor, bool open) {
                           return doorAt(floor).joint.isAt(open ? doorAt(floor).open : 0, kDoorSlack);
                         }});
  }

  void postUpdate(const StepInfo& info) override {
    if (info.paused || info.time - lastUpdate_ < updatePeriod_) return;
    lastUpdate_ = info.time;
    const int floor = nearestFloor();
    if (info.time - lastState_ >= statePeriod_) {
      lastState_ = info.time;
      stateMessage_.set_data(floor);
      if (state_.hasSubscribers()) state_.publish(stateMessage_);
    }
    machine_->update(info.time, floor, doorAt(floor).isBlocked);
  }

  void reset() override {
    machine_->reset();
    lastUpdate_ = lastState_ = Time(0);
    for (Door& door : doors_) door.isBlocked = false;
  }

  void transfer(StateArchive& archive) override {
    machine_->transfer(archive, static_cast<int>(doors_.size()));
    archive(lastUpdate_);
    archive(lastState_);
    for (Door& door : doors_) archive(door.isBlocked);
  }

 private:
  struct Door {
    PositionedJoint joint;
    /// Position of the open door.
    double open;
    bool isBlocked = false;
    Subscription scan = {};
  };

  double heightOf(int floor) const { return heights_[static_cast<std::size_t>(floor)]; }
  Door& doorAt(int floor) { return doors_[static_cast<std::size_t>(floor)]; }

  static Joint requireAxis(const std::optional<Joint>& joint, const std::string& name, const std::string& what,
                           const Element& sdf) {
    if (!joint) refuse(sdf, "there is no joint '" + name + "' for the " + what);
    if (joint->axisCount() == 0) refuse(sdf, "joint '" + name + "' of the " + what + " has no axis to drive");
    return *joint;
  }

  void findFloors(const Model& model, const Element& sdf) {
    const std::vector<Link> links = model.links();
    const auto count =
        std::ranges::count_if(links, [&](const Link& link) { return isNumbered(link.name(), floorPrefix_); });
    if (count == 0) {
      refuse(sdf, "model '" + std::string(model.name()) + "' has no floors",
             "name its floor links '" + floorPrefix_ + "0', '" + floorPrefix_ + "1' and so on");
    }
    for (int floor = 0; floor < count; ++floor) {
      const std::string name = floorPrefix_ + std::to_string(floor);
      const std::optional<Link> link = model.link(name);
      if (!link) {
        refuse(sdf,
               "there is no link '" + name + "' for floor " + std::to_string(floor) + " of " + std::to_string(count));
      }
      heights_.push_back(link->poseInModel().position.z());
    }
  }

  void addDoor(std::size_t floor, const Model& model, const std::string& prefix, const SystemContext& context) {
    const std::string name = doorPrefix_ + std::to_string(floor);
    const Joint joint = requireAxis(model.joint(name), name, "door of floor " + std::to_string(floor), context.sdf);
    const double open = joint.axisInfo().upper;
    if (!std::isfinite(open)) {
      refuse(context.sdf, "joint '" + name + "' has no upper limit: that is where the door is open");
    }
    doors_.push_back({PositionedJoint(joint, prefix, context.node), open});
    doors_.back().scan = context.node.subscribe<ignition::msgs::LaserScan>(
        cleanTopic(prefix + "/" + name + "/lidar"), [this, floor](const ignition::msgs::LaserScan& scan) {
          if (scan.ranges_size() > 0) doors_[floor].isBlocked = scan.ranges(0) < scan.range_max() - kScanSlack;
        });
  }

  void receive(int target) {
    if (target < 0 || static_cast<std::size_t>(target) >= heights_.size()) {
      return log_->warning("there is no floor " + std::to_string(target) + ", only 0 to " +
                           std::to_string(heights_.size() - 1) + ": the call was ignored");
    }
    machine_->call(target);
  }

  int nearestFloor() const {
    const auto distance = [this](double height) { return std::abs(height - cabin_->position()); };
    return static_cast<int>(std::ranges::min_element(heights_, {}, distance) - heights_.begin());
  }

  double updateRate_ = 10;
  double stateRate_ = 5;
  double wait_ = 5;
  std::string floorPrefix_ = "floor_";
  std::string doorPrefix_ = "door_";
  std::string cabinName_ = "lift";
  std::string commandTopic_, stateTopic_;

  const Logger* log_ = nullptr;
  /// Heights of the floors in the model [m].
  std::vector<double> heights_;
  std::optional<PositionedJoint> cabin_;
  std::vector<Door> doors_;
  std::optional<ElevatorMachine> machine_;
  Time updatePeriod_{0}, statePeriod_{0};
  Time lastUpdate_{0}, lastState_{0};
  Publisher state_;
  ignition::msgs::Int32 stateMessage_;
  Subscription command_;
};

}  // namespace

}  // namespace pongsim

PONGSIM_EXPORT_SYSTEM(pongsim::Elevator, "ignition::gazebo::systems::Elevator", "gz::sim::systems::Elevator");
