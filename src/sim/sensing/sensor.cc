#include "pongsim/sensing/sensor.hh"

#include "pongsim/node.hh"
#include "pongsim/sensing/custom_type.hh"
#include "sim/api/access.hh"

namespace pongsim {

namespace {

const world::SensorRecord& sensorRecord(const sim::Access& access, SensorId id) {
  return access.entities.sensors()[sim::slotOf(access, id)];
}

/// @return "/model/outer/model/inner"
std::string modelTopic(const world::Entities& entities, world::Slot model) {
  if (model == world::kNoSlot) return "";
  const world::ModelRecord& record = entities.models()[model];
  return modelTopic(entities, record.parent) + "/model/" + record.description->name;
}

}  // namespace

bool Sensor::exists() const { return access_->entities.slot(id_) != world::kNoSlot; }

bool Sensor::isSetAside() const { return access_->entities.isSetAside(id_.value); }

std::string_view Sensor::name() const { return sensorRecord(*access_, id_).description->name; }

std::string_view Sensor::type() const { return sensorRecord(*access_, id_).description->type; }

std::string Sensor::scopedName() const {
  const std::optional<Joint> holder = joint();
  if (!holder) return link().scopedName() + "::" + std::string(name());
  const world::Slot model = access_->entities.joints()[sensorRecord(*access_, id_).joint].model;
  const std::string scope = model == world::kNoSlot ? "" : access_->entities.models()[model].scopedName + "::";
  return scope + std::string(holder->name()) + "::" + std::string(name());
}

Link Sensor::link() const {
  const world::SensorRecord& sensor = sensorRecord(*access_, id_);
  if (sensor.joint != world::kNoSlot) return joint()->child();
  return Link(*access_, access_->entities.links()[sensor.link].id);
}

std::optional<Joint> Sensor::joint() const {
  const world::Slot slot = sensorRecord(*access_, id_).joint;
  if (slot == world::kNoSlot) return std::nullopt;
  return Joint(*access_, access_->entities.joints()[slot].id);
}

Pose Sensor::poseInLink() const {
  const world::SensorRecord& sensor = sensorRecord(*access_, id_);
  if (sensor.joint == world::kNoSlot) return sensor.description->X_ParentSensor;
  return access_->entities.joints()[sensor.joint].description->X_ChildJoint * sensor.description->X_ParentSensor;
}

Pose Sensor::pose() const { return link().pose() * poseInLink(); }

Vector3 Sensor::linearVelocity() const {
  const Link holder = link();
  return holder.linearVelocity() + holder.angularVelocity().cross(holder.pose().rotation * poseInLink().position);
}

double Sensor::updateRate() const { return sensorRecord(*access_, id_).description->updateRate; }

bool Sensor::isAlwaysOn() const { return sensorRecord(*access_, id_).description->alwaysOn; }

bool Sensor::hasMetrics() const { return sensorRecord(*access_, id_).description->hasMetrics; }

std::string Sensor::topic(std::string_view suffix) const {
  const world::SensorRecord& sensor = sensorRecord(*access_, id_);
  const world::Entities& entities = access_->entities;
  const world::Slot holder =
      sensor.joint != world::kNoSlot ? entities.joints()[sensor.joint].model : entities.links()[sensor.link].model;
  const std::string& nameSpace = entities.nameSpace(holder);
  if (!sensor.description->topic.empty()) {
    const std::string& topic = sensor.description->topic;
    return nameSpace.empty() ? topic : nameSpace + (topic.starts_with('/') ? "" : "/") + topic;
  }
  std::string topic = nameSpace + "/world/" + entities.description().name;
  if (sensor.joint != world::kNoSlot) {
    const world::JointRecord& joint = entities.joints()[sensor.joint];
    topic += modelTopic(entities, joint.model) + "/joint/" + joint.description->name;
  } else {
    const world::LinkRecord& link = entities.links()[sensor.link];
    topic += modelTopic(entities, link.model) + "/link/" + link.description->name;
  }
  topic.append("/sensor/").append(sensor.description->name).append(suffix);
  // as in Gazebo, the default topic of an environmental sensor has its whole type: "environmental_sensor/humidity"
  const std::string_view type = customTypeOf(sensor.description->sdf);
  const bool isContinued = !suffix.empty() && type.starts_with(suffix.substr(1)) && type[suffix.size() - 1] == '/';
  return isContinued ? topic.append(type.substr(suffix.size() - 1)) : topic;
}

std::string Sensor::topic(const SensorReadings& readings) const {
  return cleanTopic(topic(readings.suffix)) + readings.behind;
}

std::string Sensor::frameName() const {
  const std::string& frame = sensorRecord(*access_, id_).description->frame;
  return frame.empty() ? scopedName() : frame;
}

const SensorSettings& Sensor::allSettings() const { return sensorRecord(*access_, id_).description->settings; }

const Element& Sensor::sdf() const { return sensorRecord(*access_, id_).description->sdf; }

}  // namespace pongsim
