#pragma once

#include <cstddef>
#include <functional>
#include <memory>
#include <string>
#include <vector>

#include "core/handles.hh"
#include "core/life.hh"
#include "core/sensor.hh"

namespace pongsim::python {

/// The latest numbers received from a topic.
class TopicReading {
 public:
  /// Extracts the numbers from a message.
  using Take = std::function<void(const Message&, std::vector<double>&)>;

  TopicReading(Life& life, std::string name, const std::string& topic, const std::string& type, std::size_t size,
               Take take);
  ~TopicReading() { end(subscription_); }

  /// Its name in messages.
  const std::string& name() const { return name_; }
  const std::vector<double>& numbers() const { return now_.numbers; }
  /// Whether a message has arrived since `forget`.
  bool isThere() const { return now_.isThere; }
  void forget() { now_ = {std::vector<double>(now_.numbers.size(), 0.0), false}; }
  /// Saves the current numbers, for `restore`.
  void save() { saved_ = now_; }
  void restore() { now_ = saved_; }

 private:
  struct Known {
    std::vector<double> numbers;
    bool isThere = false;
  };
  std::string name_;
  Known now_;
  Known saved_;
  Subscription subscription_;
};

/// Values of a world that are read after each step of an environment.
struct Reading {
  std::size_t size = 0;
  /// Writes the current values. Called without the GIL.
  std::function<void(double*)> sample;
  /// Null if the values are read directly from the world.
  std::shared_ptr<TopicReading> topic;
};

/// Number of beams and range of a lidar.
struct LidarLimits {
  std::size_t beams = 0;
  /// [m]
  double nearest = 0;
  double farthest = 0;
};
/// @return The limits of a lidar. Raises ValueError for other sensors.
LidarLimits lidarLimits(PySensor& sensor);

/// @return The ranges of a lidar [m].
Reading rangesOf(PySensor& sensor);
/// @return Fields of the last message on a topic. Raises ValueError if they are not numeric fields of its type.
Reading fieldsOf(const std::shared_ptr<Life>& life, const std::string& topic, const std::string& type,
                 const std::vector<std::string>& paths);
/// @return Position and rotation of a model in the world frame: x, y, z [m], and a quaternion x, y, z, w.
Reading poseReading(PyModel& model);
/// @return Linear [m/s] and angular velocity [rad/s] of a model's canonical link, in that link's own frame.
/// Raises ValueError for a model without one.
Reading velocityReading(PyModel& model);
/// @return Position [rad or m] and velocity [rad/s or m/s] of an axis.
Reading jointReading(PyJoint& joint);

}  // namespace pongsim::python
