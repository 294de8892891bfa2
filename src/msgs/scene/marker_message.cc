#include "msgs/scene/marker_message.hh"

#include <ignition/msgs/marker.pb.h>
#include <ignition/msgs/marker_v.pb.h>

#include <string>

#include "msgs/fields/time.hh"
#include "msgs/scene/color_message.hh"
#include "msgs/scene/pose_message.hh"

namespace pongsim::msgs {

namespace {

namespace im = ignition::msgs;

constexpr const char* kWorldKey = "world";

/// @return The colour in which Fortress draws it, unlit: the diffuse one. An opacity that is left out is 0 in the
/// message.
Eigen::Vector4f markerColor(const im::Material& material) {
  const im::Color& color = material.diffuse();
  const float opacity = color.a() > 0 && color.a() < 1 ? color.a() : 1;
  return {color.r(), color.g(), color.b(), opacity};
}

}  // namespace

Outcome<world::MarkerChange> markerChange(const Message& message) {
  const auto& asked = static_cast<const im::Marker&>(message);
  world::MarkerChange change;
  const std::string number = "marker " + std::to_string(asked.id());
  switch (asked.action()) {
    case im::Marker::ADD_MODIFY:
      change.action = world::MarkerChange::Action::kAddOrModify;
      break;
    case im::Marker::DELETE_MARKER:
      change.action = world::MarkerChange::Action::kDelete;
      break;
    case im::Marker::DELETE_ALL:
      change.action = world::MarkerChange::Action::kDeleteAll;
      break;
    default:
      return {std::nullopt, number + " asks for an unknown action, " + std::to_string(asked.action())};
  }
  if (!im::Marker::Type_IsValid(asked.type())) {
    return {std::nullopt, number + " has an unknown type, " + std::to_string(asked.type())};
  }
  change.type = static_cast<world::Marker::Type>(asked.type());
  change.space = asked.ns();
  change.id = asked.id();
  change.layer = asked.layer();
  change.isForAll = asked.visibility() == im::Marker::ALL;
  change.lifetime = timeOf(asked.lifetime());
  if (asked.has_pose()) {
    change.pose = poseFrom(asked.pose());
    Quaternion& rotation = change.pose->rotation;
    rotation = rotation.norm() > 0 ? rotation.normalized() : Quaternion::Identity();
  }
  if (asked.has_scale()) change.scale = vectorFrom(asked.scale());
  if (asked.has_material()) change.color = markerColor(asked.material());
  for (const im::Vector3d& point : asked.point()) change.points.push_back(vectorFrom(point));
  change.text = asked.text();
  change.parent = asked.parent();
  return {std::move(change), {}};
}

std::vector<const Message*> markersIn(const Message& message) {
  std::vector<const Message*> all;
  for (const im::Marker& each : static_cast<const im::Marker_V&>(message).marker()) all.push_back(&each);
  return all;
}

void setMarker(const world::Markers::Key& key, const world::Marker& marker, Time now, Message& message) {
  auto& told = static_cast<im::Marker&>(message);
  told.set_ns(key.first);
  told.set_id(key.second);
  told.set_type(static_cast<im::Marker::Type>(marker.type));
  told.set_layer(marker.layer);
  told.set_visibility(marker.isForAll ? im::Marker::ALL : im::Marker::GUI);
  if (marker.end) setTime(*marker.end - now, *told.mutable_lifetime());
  const auto setVector = [](const Vector3& vector, im::Vector3d& to) {
    to.set_x(vector.x());
    to.set_y(vector.y());
    to.set_z(vector.z());
  };
  setVector(marker.X_ParentMarker.position, *told.mutable_pose()->mutable_position());
  const Quaternion& rotation = marker.X_ParentMarker.rotation;
  im::Quaternion& orientation = *told.mutable_pose()->mutable_orientation();
  orientation.set_w(rotation.w());
  orientation.set_x(rotation.x());
  orientation.set_y(rotation.y());
  orientation.set_z(rotation.z());
  setVector(marker.scale, *told.mutable_scale());
  const Eigen::Vector4f& color = marker.color;
  setColor({color.x(), color.y(), color.z(), color.w()}, *told.mutable_material()->mutable_diffuse());
  for (const Vector3& point : marker.points) setVector(point, *told.add_point());
  told.set_text(marker.text);
  told.set_parent(marker.parent);
}

void setMarkerRemoval(const world::Markers::Key& key, bool isAll, Message& message) {
  auto& told = static_cast<im::Marker&>(message);
  told.set_action(isAll ? im::Marker::DELETE_ALL : im::Marker::DELETE_MARKER);
  told.set_ns(key.first);
  told.set_id(key.second);
}

void setWorldOfMarkers(const std::string& world, Message& message) {
  setHeaderValue(kWorldKey, world, *static_cast<im::Marker_V&>(message).mutable_header());
}

void setWorldOfMarker(const std::string& world, Message& message) {
  setHeaderValue(kWorldKey, world, *static_cast<im::Marker&>(message).mutable_header());
}

std::string worldOfMarkers(const Message& message) {
  for (const im::Header::Map& each : static_cast<const im::Marker_V&>(message).header().data()) {
    if (each.key() == kWorldKey && each.value_size() > 0) return each.value(0);
  }
  return {};
}

Message& addMarker(Message& message) { return *static_cast<im::Marker_V&>(message).add_marker(); }

}  // namespace pongsim::msgs
