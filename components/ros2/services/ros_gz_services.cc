#include "ros2/services/ros_gz_services.hh"

#include <ignition/msgs/boolean.pb.h>
#include <ignition/msgs/entity.pb.h>
#include <ignition/msgs/entity_factory.pb.h>
#include <ignition/msgs/pose.pb.h>
#include <ignition/msgs/world_control.pb.h>

#include <memory>
#include <utility>

#include "ros2/node/complaints.hh"
#include "ros2/pairs/convert.hh"
#include "ros2/pairs/gz_parts.hh"
#include "ros2/types/finite.hh"
#include "ros2/types/ros_gz_interfaces.hh"

namespace pongsim::ros2 {

namespace gz = ros_gz_interfaces;
using Refusal = std::optional<std::string>;

namespace {

Refusal toIgnition(const gz::srv::ControlWorld::Request& from, ignition::msgs::WorldControl& to, const EntityFinder&) {
  convert(from.world_control, to);
  return std::nullopt;
}

Refusal toIgnition(const gz::srv::SpawnEntity::Request& from, ignition::msgs::EntityFactory& to,
                   const EntityFinder& finder) {
  const gz::EntityFactory& factory = from.entity_factory;
  if (const Refusal error = poseError(factory.pose)) return error;
  Outcome<MovingFrame> frame = finder.frame(factory.relative_to);
  if (!frame) return frame.error;
  to.set_name(factory.name);
  to.set_allow_renaming(factory.allow_renaming);
  if (!factory.sdf.empty()) to.set_sdf(factory.sdf);
  if (!factory.sdf_filename.empty()) to.set_sdf_filename(factory.sdf_filename);
  if (!factory.clone_name.empty()) to.set_clone_name(factory.clone_name);
  convert(poseMessage(frame->pose * poseOf(factory.pose)), *to.mutable_pose());
  return std::nullopt;
}

Refusal toIgnition(const gz::srv::DeleteEntity::Request& from, ignition::msgs::Entity& to, const EntityFinder&) {
  convert(from.entity, to);
  return std::nullopt;
}

Refusal toIgnition(const gz::srv::SetEntityPose::Request& from, ignition::msgs::Pose& to, const EntityFinder&) {
  if (!isFinite(from.pose)) return "the pose is not finite";
  convert(from.pose, to);
  to.set_name(from.entity.name);
  to.set_id(static_cast<std::uint32_t>(from.entity.id));
  if (to.id() != from.entity.id) return "there is no entity with the id " + std::to_string(from.entity.id);
  return std::nullopt;
}

}  // namespace

RosGzServices::RosGzServices(RosNode& node, const Node& simulation, const ServiceNames& names,
                             std::span<const ServiceRule> rules, const EntityFinder& finder)
    : requests_(simulation), log_(node.log()), offers_(node) {
  const auto offerAs = [&]<ServiceType Service, class Request>(const std::string& name) {
    const std::string target = names.inSimulation(name);
    std::vector<std::string> offeredAs;
    for (const ServiceRule& rule : rules) {
      if (rule.ignition == target && rule.type == Service::kName) offeredAs.push_back(rule.ros);
    }
    if (offeredAs.empty()) offeredAs.push_back(names.ofWorld(name));
    offer<Service, Request>(target, offeredAs, [&finder](const typename Service::Request& from, Request& to) {
      return toIgnition(from, to, finder);
    });
  };
  offerAs.operator()<gz::srv::ControlWorld, ignition::msgs::WorldControl>("control");
  offerAs.operator()<gz::srv::SpawnEntity, ignition::msgs::EntityFactory>("create");
  offerAs.operator()<gz::srv::DeleteEntity, ignition::msgs::Entity>("remove");
  offerAs.operator()<gz::srv::SetEntityPose, ignition::msgs::Pose>("set_pose");
}

template <ServiceType Service, class Request>
void RosGzServices::offer(const std::string& target, const std::vector<std::string>& offeredAs,
                          std::function<Refusal(const typename Service::Request&, Request&)> convert) {
  const auto complaints = std::make_shared<Complaints>();
  const auto handle = [this, target, complaints, convert = std::move(convert)](const typename Service::Request& request,
                                                                               const Responder<Service>& responder) {
    const auto answer = [this, target, complaints, responder](const std::string& error) {
      if (!error.empty()) complaints->warn(log_, "service '" + target + "': " + error);
      responder.answer({error.empty()});
    };
    Request message;
    if (const Refusal refusal = convert(request, message)) return answer(*refusal);
    if (!requests_.send(target, message, ignition::msgs::Boolean::descriptor()->full_name(), answer)) {
      answer("nothing controls this simulation: a program steps it itself");
    }
  };
  for (const std::string& name : offeredAs) offers_.add<Service>(name, handle);
}

}  // namespace pongsim::ros2
