#include "core/reading.hh"

#include <google/protobuf/message.h>
#include <ignition/msgs/laserscan.pb.h>

#include <algorithm>
#include <cmath>
#include <optional>
#include <utility>

#include "core/errors.hh"
#include "core/topics.hh"
#include "pongsim/messages/field_path.hh"
#include "pongsim/sensing/sensor_settings.hh"

namespace pongsim::python {

TopicReading::TopicReading(Life& life, std::string name, const std::string& topic, const std::string& type,
                           std::size_t size, Take take)
    : name_(std::move(name)), now_{std::vector<double>(size, 0.0)}, saved_(now_) {
  subscription_ = life.use().transport().node().subscribeAtOnce(
      topic, type, [this, take = std::move(take)](const Message& message, const Bulk*) {
        take(message, now_.numbers);
        now_.isThere = true;
      });
}

namespace {

/// The lidar system's limit of beams.
constexpr double kMostBeams = 1e6;

Reading readingOf(std::shared_ptr<TopicReading> topic) {
  const TopicReading& source = *topic;
  return {.size = source.numbers().size(),
          .sample = [&source](double* to) { std::ranges::copy(source.numbers(), to); },
          .topic = std::move(topic)};
}

void put(const Vector3& vector, double* to) { std::copy_n(vector.data(), 3, to); }

}  // namespace

LidarLimits lidarLimits(PySensor& sensor) {
  const auto* settings = sensor.use().settings<LidarSettings>();
  if (settings == nullptr) {
    throw py::value_error("sensor '" + sensor.use().scopedName() + "' is not a lidar but of type " +
                          std::string(sensor.use().type()));
  }
  const auto count = [](const LidarSettings::Scan& scan) {
    return std::max(1.0, std::floor(scan.samples * scan.resolution));
  };
  const double beams = count(settings->horizontal) * count(settings->vertical);
  if (beams > kMostBeams) throw py::value_error("lidar '" + sensor.use().scopedName() + "' has too many beams");
  return {static_cast<std::size_t>(beams), settings->minRange, settings->maxRange};
}

Reading rangesOf(PySensor& sensor) {
  const LidarLimits limits = lidarLimits(sensor);
  return readingOf(std::make_shared<TopicReading>(
      *sensor.life, "the ranges of " + sensor.use().scopedName(), cleanTopic(sensor.use().topic("/scan")),
      "ignition.msgs.LaserScan", limits.beams, [](const Message& message, std::vector<double>& numbers) {
        const auto& ranges = static_cast<const ignition::msgs::LaserScan&>(message).ranges();
        const auto size = std::min(numbers.size(), static_cast<std::size_t>(ranges.size()));
        std::copy_n(ranges.begin(), size, numbers.begin());
      }));
}

Reading fieldsOf(const std::shared_ptr<Life>& life, const std::string& topic, const std::string& type,
                 const std::vector<std::string>& paths) {
  const std::string full = typeFor(*life, topic, type);
  std::vector<FieldPath> fields;
  for (const std::string& path : paths) {
    MessageError error;
    auto field = FieldPath::parse(full, path, error);
    if (!field) {
      throw py::value_error("field '" + path + "' of " + full + ": " + error.message +
                            (error.hint.empty() ? "" : "; " + error.hint));
    }
    if (!field->isNumber()) throw py::value_error("field '" + path + "' of " + full + " is not a single number");
    fields.push_back(std::move(*field));
  }
  return readingOf(std::make_shared<TopicReading>(
      *life, "topic " + topic, topic, full, paths.size(),
      [fields = std::move(fields)](const Message& message, std::vector<double>& numbers) {
        for (std::size_t i = 0; i < fields.size(); ++i) numbers[i] = fields[i].numberIn(message).value_or(0.0);
      }));
}

Reading poseReading(PyModel& model) {
  return {.size = 7,
          .sample =
              [model = model.use()](double* to) {
                const Pose pose = model.pose();
                put(pose.position, to);
                std::copy_n(pose.rotation.coeffs().data(), 4, to + 3);
              },
          .topic = nullptr};
}

Reading velocityReading(PyModel& model) {
  const std::optional<Link> canonical = model.use().canonicalLink();
  if (!canonical) throw py::value_error("model '" + model.inner.scopedName() + "' has no link of its own");
  return {.size = 6,
          .sample =
              [link = *canonical](double* to) {
                const Eigen::Quaterniond back = link.pose().rotation.conjugate();
                put(back * link.linearVelocity(), to);
                put(back * link.angularVelocity(), to + 3);
              },
          .topic = nullptr};
}

Reading jointReading(PyJoint& joint) {
  if (joint.use().axisCount() == 0) {
    throw py::value_error("joint '" + std::string(joint.inner.name()) + "' has no axis with a position");
  }
  return {.size = 2,
          .sample =
              [joint = joint.use()](double* to) {
                to[0] = joint.position();
                to[1] = joint.velocity();
              },
          .topic = nullptr};
}

}  // namespace pongsim::python
