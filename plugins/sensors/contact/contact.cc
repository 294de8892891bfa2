#include <ignition/msgs/contacts.pb.h>

#include <algorithm>
#include <cstdint>
#include <stdexcept>
#include <string>
#include <unordered_set>
#include <vector>

#include "pongsim/contact.hh"
#include "pongsim/messages/fields.hh"
#include "pongsim/sensing/sensor.hh"
#include "pongsim/system.hh"

namespace pongsim {

namespace {

constexpr const char* kType = "contact";
constexpr const char* kSuffix = "/contact";

/// The contact points of a pair of collisions, seen from one of the two.
class PairMessage {
 public:
  PairMessage(const World& world, const Contact& first, CollisionId own, ignition::msgs::Contact& message)
      : swapped_(first.collision1 != own), message_(message) {
    const Collision one = world.collision(own).value();
    const Collision other = world.collision(swapped_ ? first.collision1 : first.collision2).value();
    setEntity(one, *message.mutable_collision1());
    setEntity(other, *message.mutable_collision2());
    const Link body1 = one.link(), body2 = other.link();
    body1_.set_body_1_name(body1.scopedName());
    body1_.set_body_1_id(static_cast<std::uint32_t>(body1.id().value));
    body1_.set_body_2_name(body2.scopedName());
    body1_.set_body_2_id(static_cast<std::uint32_t>(body2.id().value));
  }

  void add(const Contact& contact) {
    const double sign = swapped_ ? -1 : 1;
    const Vector3 force = sign * contact.force;
    setVector(contact.position, *message_.add_position());
    setVector(Vector3(sign * contact.normal), *message_.add_normal());
    message_.add_depth(contact.depth);
    ignition::msgs::JointWrench& wrench = *message_.add_wrench();
    wrench = body1_;
    setVector(force, *wrench.mutable_body_1_wrench()->mutable_force());
    setVector(Vector3(-force), *wrench.mutable_body_2_wrench()->mutable_force());
  }

 private:
  static void setEntity(const Collision& collision, ignition::msgs::Entity& entity) {
    entity.set_id(collision.id().value);
    entity.set_name(collision.scopedName());
    entity.set_type(ignition::msgs::Entity::COLLISION);
  }

  bool swapped_;
  ignition::msgs::Contact& message_;
  /// Names and ids of the collisions.
  ignition::msgs::JointWrench body1_;
};

/// One sensor: its collisions and its topic.
class ContactSensor {
 public:
  ContactSensor(const Sensor& sensor, Node& node, Diagnostics& diagnostics) : sensor_(sensor) {
    for (const std::string& name : sensor.settings<ContactSettings>()->collisions) {
      const std::vector<Collision> all = sensor.link().collisions();
      const auto found =
          std::ranges::find_if(all, [&](const Collision& collision) { return collision.name() == name; });
      if (found != all.end()) {
        watched_.push_back(found->id());
      } else {
        diagnostics.warning(sensor.sdf().position, "sensor '" + sensor.scopedName() + "' names collision '" + name +
                                                       "', which is not in link '" + sensor.link().scopedName() + "'");
      }
    }
    publisher_ = node.advertise<ignition::msgs::Contacts>(cleanTopic(sensor.topic(kSuffix)));
  }

  const Sensor& sensor() const { return sensor_; }

  bool hasListeners() const { return !watched_.empty() && publisher_.hasSubscribers(); }

  /// @param contacts All of the world, grouped by pair.
  void publish(const World& world, const std::vector<Contact>& contacts, Time time) {
    ignition::msgs::Contacts message;
    for (const CollisionId own : watched_) addContacts(world, contacts, own, time, message);
    if (message.contact_size() == 0) return;
    setStamp(time, *message.mutable_header());
    publisher_.publish(message);
  }

 private:
  static void addContacts(const World& world, const std::vector<Contact>& contacts, CollisionId own, Time time,
                          ignition::msgs::Contacts& message) {
    const auto isOther = [](const Contact& a, const Contact& b) {
      return a.collision1 != b.collision1 || a.collision2 != b.collision2;
    };
    for (std::size_t first = 0, next = 0; first < contacts.size(); first = next) {
      while (next < contacts.size() && !isOther(contacts[first], contacts[next])) ++next;
      if (contacts[first].collision1 != own && contacts[first].collision2 != own) continue;
      ignition::msgs::Contact& pair = *message.add_contact();
      setStamp(time, *pair.mutable_header());
      PairMessage filling(world, contacts[first], own, pair);
      for (std::size_t i = first; i < next; ++i) filling.add(contacts[i]);
    }
  }

  Sensor sensor_;
  std::vector<CollisionId> watched_;
  Publisher publisher_;
};

/// Publishes the contacts of contact sensors.
class ContactSystem : public System {
 public:
  void declare(Declaration& declaration) override {
    declaration.is("Publishes the contacts of contact sensors.", Declaration::Place::kWorld);
    declaration.publishes("/world/W/model/M/link/L/sensor/S/contact", "ignition.msgs.Contacts",
                          "in each step with contacts; renamed by `<contact><topic>` in the `<sensor>`");
    declaration.measures({.sensorType = kType, .suffix = kSuffix, .messageType = "ignition.msgs.Contacts"});
  }

  void configure(const SystemContext& context) override {
    world_ = &context.world;
    node_ = &context.node;
    log_ = &context.log;
    addSensors(context.diagnostics);
  }

  void worldChanged() override {
    std::erase_if(sensors_, [this](const ContactSensor& each) {
      const bool hasGone = !each.sensor().exists() && !each.sensor().isSetAside();
      if (hasGone) known_.erase(each.sensor().id().value);
      return hasGone;
    });
    Diagnostics diagnostics;
    addSensors(diagnostics);
    for (const Diagnostic& diagnostic : diagnostics.all()) log_->warning(format(diagnostic));
  }

  void postUpdate(const StepInfo& info) override {
    if (info.paused) return;
    if (std::ranges::none_of(sensors_, [](const ContactSensor& sensor) { return sensor.hasListeners(); })) return;
    world_->contacts(contacts_);
    for (ContactSensor& sensor : sensors_) {
      if (sensor.hasListeners()) sensor.publish(*world_, contacts_, info.time);
    }
  }

 private:
  void addSensors(Diagnostics& diagnostics) {
    for (const Sensor& sensor : world_->sensors(kType)) {
      if (known_.contains(sensor.id().value)) continue;
      try {
        sensors_.emplace_back(sensor, *node_, diagnostics);
        known_.insert(sensor.id().value);
      } catch (const std::invalid_argument& error) {
        diagnostics.warning(sensor.sdf().position,
                            "sensor '" + sensor.scopedName() + "' can't publish: " + error.what());
      }
    }
  }

  World* world_ = nullptr;
  Node* node_ = nullptr;
  const Logger* log_ = nullptr;
  std::vector<ContactSensor> sensors_;
  /// Their ids.
  std::unordered_set<std::uint64_t> known_;
  std::vector<Contact> contacts_;
};

}  // namespace

}  // namespace pongsim

PONGSIM_EXPORT_SYSTEM(pongsim::ContactSystem, "ignition::gazebo::systems::Contact", "gz::sim::systems::Contact");
