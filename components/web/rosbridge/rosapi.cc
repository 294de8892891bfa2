#include "web/rosbridge/rosapi.hh"

#include <cstdint>
#include <set>
#include <string_view>

#include "web/foxglove/fields.hh"
#include "web/rosbridge/rosout.hh"
#include "web/world/read_only_service.hh"

namespace pongsim::web::rosbridge {

namespace {

using nlohmann::json;

constexpr std::string_view kNode = "/pongsim";

}  // namespace

std::optional<json> Rosapi::call(const std::string& service, const json& arguments) {
  const auto argument = [&](const char* name) { return foxglove::textField(arguments, name).value_or(""); };
  if (service == "/rosapi/topics") return topics(false);
  if (service == "/rosapi/topics_and_raw_types") return topics(true);
  if (service == "/rosapi/topics_for_type") return json{{"topics", topicsOf(argument("type"))}};
  if (service == "/rosapi/topic_type") {
    if (argument("topic") == kRosout) return json{{"type", kRosoutType}};
    const auto found = topics_.find(argument("topic"));
    return json{{"type", found.empty() ? "" : found.front().type}};
  }
  if (service == "/rosapi/services") return json{{"services", services(std::nullopt)}};
  if (service == "/rosapi/services_for_type") return json{{"services", services(argument("type"))}};
  if (service == "/rosapi/service_type") {
    const auto found = worlds_.findService(argument("service"));
    return json{{"type", found ? found->service.requestType : ""}};
  }
  if (service == "/rosapi/nodes") return json{{"nodes", json::array({kNode})}};
  if (service == "/rosapi/node_details") return nodeDetails(argument("node"));
  if (service == "/rosapi/get_time") return json{{"time", time()}};
  return std::nullopt;
}

json Rosapi::topics(bool withDefinitions) {
  json names = json::array({kRosout}), types = json::array({kRosoutType}), definitions = json::array({kRosoutSchema});
  std::set<std::string, std::less<>> known{std::string(kRosout)};
  for (const RosTopic& topic : topics_.all()) {
    if (!known.insert(topic.name).second) continue;
    names.push_back(topic.name);
    types.push_back(topic.type);
    if (withDefinitions) definitions.push_back(topics_.definition(topic));
  }
  json values = {{"topics", names}, {"types", types}};
  if (withDefinitions) values["typedefs_full_text"] = definitions;
  return values;
}

json Rosapi::topicsOf(const std::string& type) {
  std::set<std::string> names;
  if (fullRosType(type) == kRosoutType) names.emplace(kRosout);
  for (const RosTopic& topic : topics_.all()) {
    if (topic.type == fullRosType(type)) names.insert(topic.name);
  }
  return names;
}

/// @param type Nothing: of any.
json Rosapi::services(const std::optional<std::string>& type) {
  json names = json::array();
  for (const auto& place : worlds_.services()) {
    if (type && place.service.requestType != *type) continue;
    if (mayWrite_ || isReadOnlyService(place.service.name)) names.push_back(place.service.name);
  }
  return names;
}

json Rosapi::nodeDetails(const std::string& node) {
  std::set<std::string> publishing, subscribing;
  if (node != kNode) return {{"publishing", publishing}, {"subscribing", subscribing}, {"services", json::array()}};
  publishing.emplace(kRosout);
  for (const RosTopic& topic : topics_.all()) {
    if (topic.place.topic.publishers > 0) publishing.insert(topic.name);
    if (topic.place.topic.subscribers > 0) subscribing.insert(topic.name);
  }
  return {{"publishing", publishing}, {"subscribing", subscribing}, {"services", services(std::nullopt)}};
}

/// @return The simulated time of the first world.
json Rosapi::time() {
  const auto all = worlds_.all();
  const std::uint64_t ns = all.empty() ? 0 : all.front()->timeNs();
  return {{"sec", ns / kNanoseconds}, {"nanosec", ns % kNanoseconds}};
}

}  // namespace pongsim::web::rosbridge
