#include <algorithm>
#include <cmath>
#include <cstdint>
#include <deque>
#include <optional>
#include <stdexcept>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "fault.hh"
#include "joint_faults.hh"
#include "pongsim/diagnostic.hh"
#include "pongsim/program/nearest_word.hh"
#include "pongsim/sensing/sensor.hh"
#include "pongsim/system.hh"
#include "topic_faults.hh"

namespace pongsim::faults {

namespace {

/// A name with the model's, as in "model::joint".
std::string scoped(const Model& model, std::string_view name) {
  return std::string(model.scopedName()) + "::" + std::string(name);
}

class Faults final : public System {
 public:
  void declare(Declaration& declaration) override {
    declaration.is("Makes faults on purpose: of topics, sensors, joints, wheels and motors.",
                   Declaration::Place::kWorld);
    declaration
        .element("fault",
                 "a fault: attribute `type`, and those listed on the page of the details; may be repeated. `drop`, "
                 "`duplicate`, `delay`, `noise` and `freeze` act on the messages of a `topic`, `sensor` silences a "
                 "`sensor`, `stick`, `slip` and `weaken` act on a `joint`; `from`, `to` and `every` say when [s]")
        .required();
  }

  void configure(const SystemContext& context) override {
    node_ = context.node;
    log_ = &context.log;
    random_ = &context.random;
    world_ = context.world;
    for (const Element* element : context.sdf.childrenNamed("fault")) {
      // an error, not a fault left out: a test would pass without it
      try {
        add(faultOf(*element));
      } catch (const Error& error) {
        context.diagnostics.add(error.diagnostic());
      } catch (const std::invalid_argument& error) {
        context.diagnostics.error(element->position, error.what());
      }
    }
    topicsVersion_ = node_->ownTopicsVersion() - 1;
  }

  void preUpdate(const StepInfo& info) override {
    followTopics();
    if (info.paused) return;
    setTime(info.time);
    for (JointFault& fault : joints_) fault.update(info.time - info.dt, *log_);
  }

  void postUpdate(const StepInfo& info) override {
    if (info.paused) return;
    setTime(info.time);
    for (TopicFaults& topic : topics_) topic.release();
    if (!std::exchange(isChecked_, true)) warnOfUnknownTopics();
  }

  void reset() override {
    for (TopicFaults& topic : topics_) topic.reset();
    for (JointFault& fault : joints_) fault.reset();
    // those of the new seed
    for (const Stream& stream : streams_) {
      topics_[stream.topic].restart(stream.stage, random_->split(stream.name));
    }
  }

  void transfer(StateArchive& archive) override {
    for (TopicFaults& topic : topics_) topic.transfer(archive);
    for (JointFault& fault : joints_) fault.transfer(archive);
  }

 private:
  struct SensorFault {
    Fault fault;
    std::string topic;
    /// Of it.
    std::vector<std::string> silenced = {};
  };
  /// Where the stream of that name is used.
  struct Stream {
    std::size_t topic;
    std::size_t stage;
    std::string name;
  };

  void setTime(Time now) {
    for (TopicFaults& topic : topics_) topic.setTime(now);
  }

  void add(const Fault& fault) {
    if (fault.isOfTopic()) {
      addTo(fault.target, fault);
      named_.push_back(fault);
    } else if (fault.isOfJoint()) {
      joints_.emplace_back(*world_, jointOf(fault), fault);
    } else {
      const Sensor sensor = sensorOf(fault);
      const std::string topic = cleanTopic(sensor.topic(""));
      sensors_.push_back({fault, topic.starts_with('/') ? topic : "/" + topic});
    }
  }

  void addTo(const std::string& name, const Fault& fault) {
    auto found = std::ranges::find(topics_, name, &TopicFaults::topic);
    if (found == topics_.end()) {
      topics_.emplace_back(*node_, name, *log_);
      found = std::prev(topics_.end());
    }
    const std::string stream = name + " " + std::to_string(streams_.size());
    found->add(fault, random_->split(stream));
    const auto place = static_cast<std::size_t>(found - topics_.begin());
    const auto stage = static_cast<std::size_t>(std::ranges::count(streams_, place, &Stream::topic));
    streams_.push_back({place, stage, stream});
  }

  Joint jointOf(const Fault& fault) const {
    std::vector<std::string> names;
    for (const Model& model : world_->models()) {
      for (const Joint& joint : model.joints()) {
        names.push_back(scoped(model, joint.name()));
        if (names.back() != fault.target) continue;
        check(fault, joint);
        return joint;
      }
    }
    const std::vector<std::string_view> known(names.begin(), names.end());
    throw Error(
        {Severity::kError, fault.position, "there is no joint '" + fault.target + "'", hintFor(fault.target, known)});
  }

  void check(const Fault& fault, const Joint& joint) const {
    const auto refuse = [&fault](const std::string& message, const std::string& hint = {}) {
      throw Error({Severity::kError, fault.position, message, hint});
    };
    const std::string of = "joint '" + fault.target + "'";
    if (fault.kind == Kind::kSlip) {
      if (joint.child().collisions().empty()) refuse("the child of " + of + " has no collision that could slip");
      return;
    }
    if (joint.axisCount() == 0) refuse(of + " has no axis");
    const PhysicalProperties properties(*world_);
    for (int axis = 0; axis < joint.axisCount(); ++axis) {
      if (fault.factor && std::isinf(properties.bounds(joint, axis).effort)) {
        refuse("the effort of " + of + " has no limit, of which there could be a part",
               "write effort=\"E\" with what is left of it [N m or N]");
      }
    }
  }

  Sensor sensorOf(const Fault& fault) const {
    std::vector<std::string> names;
    const auto isIt = [&](const Sensor& sensor) {
      names.push_back(sensor.scopedName());
      return names.back() == fault.target;
    };
    for (const Model& model : world_->models()) {
      for (const Link& link : model.links()) {
        for (const Sensor& sensor : link.sensors()) {
          if (isIt(sensor)) return sensor;
        }
      }
      for (const Joint& joint : model.joints()) {
        for (const Sensor& sensor : joint.sensors()) {
          if (isIt(sensor)) return sensor;
        }
      }
    }
    const std::vector<std::string_view> known(names.begin(), names.end());
    throw Error(
        {Severity::kError, fault.position, "there is no sensor '" + fault.target + "'", hintFor(fault.target, known)});
  }

  /// Silences the topics of sensors, which their systems open when they like.
  void followTopics() {
    if (sensors_.empty() || node_->ownTopicsVersion() == topicsVersion_) return;
    topicsVersion_ = node_->ownTopicsVersion();
    for (const OwnTopic& topic : node_->ownTopics()) {
      if (topic.publishers == 0) continue;
      for (SensorFault& sensor : sensors_) {
        const bool isSilenced = std::ranges::find(sensor.silenced, topic.name) != sensor.silenced.end();
        if (isSilenced || !isOf(topic.name, sensor.topic)) continue;
        sensor.silenced.push_back(topic.name);
        addTo(topic.name, sensor.fault);
      }
    }
  }

  /// Whether a topic is the sensor's or below it, such as a lidar's points, or
  /// the description of a camera beside it.
  static bool isOf(std::string_view topic, std::string_view sensor) {
    if (topic == sensor || (topic.starts_with(sensor) && topic.substr(sensor.size()).starts_with('/'))) return true;
    const std::string_view folder = sensor.substr(0, sensor.rfind('/') + 1);
    return topic.starts_with(folder) && topic.substr(folder.size()) == "camera_info";
  }

  void warnOfUnknownTopics() const {
    const std::vector<OwnTopic> own = node_->ownTopics();
    std::vector<std::string_view> names;
    for (const OwnTopic& topic : own) names.push_back(topic.name);
    for (const Fault& fault : named_) {
      if (std::ranges::find(names, fault.target) != names.end()) continue;
      const std::string near = didYouMean(fault.target, names);
      log_->warning("nobody in the world uses the topic '" + fault.target + "', which has a fault" +
                    (near.empty() ? "" : ": " + near));
    }
  }

  std::optional<Node> node_;
  std::optional<World> world_;
  const Logger* log_ = nullptr;
  Random* random_ = nullptr;
  std::deque<TopicFaults> topics_;
  std::deque<JointFault> joints_;
  std::vector<Stream> streams_;
  std::vector<Fault> named_;
  std::vector<SensorFault> sensors_;
  std::uint64_t topicsVersion_ = 0;
  bool isChecked_ = false;
};

}  // namespace

}  // namespace pongsim::faults

PONGSIM_EXPORT_SYSTEM(pongsim::faults::Faults, "pongsim::systems::Faults");
