#include "ros2/node/type_descriptions.hh"

#include <map>

#include "ros2/types/message_definition.hh"
#include "ros2/types/type_description_interfaces.hh"

namespace pongsim::ros2 {

namespace {

namespace ti = type_description_interfaces;
using ti::srv::GetTypeDescription;
/// Keyed by name, in which order they are given.
using Individuals = std::map<std::string, ti::IndividualTypeDescription>;

/// Adds the type and all types inside it.
void addIndividuals(const TypeDescription& type, Individuals& all) {
  if (all.contains(type.name)) return;
  ti::IndividualTypeDescription& added = all[type.name];
  added.type_name.assign(type.name);
  for (const auto& [name, fieldType] : type.fields) {
    ti::Field& field = added.fields.emplace_back();
    field.name = name;
    field.type.type_id = static_cast<std::uint8_t>(int{fieldType.list} + int{fieldType.id});
    field.type.capacity = fieldType.capacity;
    field.type.string_capacity = fieldType.stringCapacity;
    if (fieldType.nested == nullptr) continue;
    const TypeDescription inner = fieldType.nested();
    field.type.nested_type_name.assign(inner.name);
    addIndividuals(inner, all);
  }
  if (!added.fields.empty()) return;
  ti::Field& field = added.fields.emplace_back();
  field.name = kFieldOfEmpty;
  field.type.type_id = static_cast<std::uint8_t>(FieldType::kUint8);
}

GetTypeDescription::Response describe(const RosNode& node, const GetTypeDescription::Request& request) {
  GetTypeDescription::Response response;
  const std::optional<TypeInfo> type = node.usedType(request.type_name);
  if (!type || type->describe == nullptr) {
    response.failure_reason = "the node does not use the type '" + request.type_name + "'";
    return response;
  }
  if (!request.type_hash.empty() && request.type_hash != type->hash) {
    response.failure_reason = "the type's hash is " + type->hash + " here";
    return response;
  }
  const TypeDescription description = type->describe();
  Individuals all;
  addIndividuals(description, all);
  response.successful = true;
  response.type_description.type_description = all.at(description.name);
  all.erase(description.name);
  for (auto& [name, each] : all) response.type_description.referenced_type_descriptions.push_back(std::move(each));
  if (request.include_type_sources) {
    response.type_sources.push_back({description.name, "msg", messageDefinition(description)});
  }
  return response;
}

}  // namespace

std::unique_ptr<RosServer> offerTypeDescriptions(RosNode& node) {
  return serveAtOnce<GetTypeDescription>(
      node, "~/get_type_description",
      [&node](const GetTypeDescription::Request& request) { return describe(node, request); });
}

}  // namespace pongsim::ros2
