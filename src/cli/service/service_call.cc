#include <algorithm>
#include <memory>
#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include "cli/fortress/gz_types.hh"
#include "cli/look_around.hh"
#include "cli/options/message_option.hh"
#include "cli/service/service_command.hh"
#include "cli/service/service_name.hh"
#include "cli/topic/topic_command.hh"
#include "pongsim/node.hh"
#include "shared/program/console.hh"

namespace pongsim::cli {

namespace {

constexpr std::chrono::seconds kAnswerTime{5};

nlohmann::ordered_json jsonOf(const ServiceInfo& service) {
  nlohmann::ordered_json json = {{"name", service.name}, {"providers", nlohmann::ordered_json::array()}};
  for (const ServiceInfo::Provider& provider : service.providers) {
    json["providers"].push_back(
        {{"pid", provider.pid}, {"requestType", provider.requestType}, {"replyType", provider.replyType}});
  }
  return json;
}

/// Fills in the types that the user left out.
/// @return The exit code, after an error message, if they are not known.
std::optional<int> findTypes(Transport& transport, CallOptions& options) {
  if (!options.requestType.empty() && !options.replyType.empty()) return std::nullopt;
  ServiceInfo service = transport.waitForService(options.service, options.timeout.value_or(kArrivalTime));
  if (service.providers.empty()) {
    const std::vector<ServiceInfo> services = servicesAround(transport);
    // on a busy machine, who is there may not have told so by then
    if (!options.timeout) service = transport.waitForService(options.service, {});
    if (service.providers.empty()) {
      return fail("no service " + options.service, nearestService(options.service, services));
    }
  }
  const ServiceInfo::Provider& provider = service.providers.front();
  const bool agree = std::ranges::all_of(service.providers, [&](const ServiceInfo::Provider& other) {
    return other.requestType == provider.requestType && other.replyType == provider.replyType;
  });
  if (!agree) {
    return fail("several processes offer " + options.service + ", of different types",
                "choose with --reqtype TYPE --reptype TYPE");
  }
  if (options.requestType.empty()) options.requestType = provider.requestType;
  if (options.replyType.empty()) options.replyType = provider.replyType;
  for (const std::string& type : {options.requestType, options.replyType}) {
    if (messageTypeName(type) != type) return fail(options.service + " is of the unknown type '" + type + "'");
  }
  return std::nullopt;
}

}  // namespace

int listServices(bool asJson, bool asGz) {
  Transport transport;
  const std::vector<ServiceInfo> services = servicesAround(transport);
  if (asJson) {
    nlohmann::ordered_json list = nlohmann::ordered_json::array();
    for (const ServiceInfo& service : services) list.push_back(jsonOf(service));
    return print(withTypeNames(list.dump() + "\n", asGz)) ? kDone : kFailed;
  }
  std::string text;
  for (const ServiceInfo& service : services) text += service.name + "\n";
  if (text.empty()) say("no services");
  return print(text) ? kDone : kFailed;
}

int showService(const std::string& name, bool asJson, bool asGz) {
  Transport transport;
  const std::vector<ServiceInfo> services = servicesAround(transport);
  const auto service = std::ranges::find(services, name, &ServiceInfo::name);
  if (service == services.end()) return fail("no service " + name, nearestService(name, services));

  if (asJson) return print(withTypeNames(jsonOf(*service).dump() + "\n", asGz)) ? kDone : kFailed;
  std::string text = "Service providers [Process, Request Message Type, Response Message Type]:\n";
  for (const ServiceInfo::Provider& provider : service->providers) {
    text += "  " + std::to_string(provider.pid) + ", " + provider.requestType + ", " + provider.replyType + "\n";
  }
  return print(withTypeNames(text, asGz)) ? kDone : kFailed;
}

int callService(const CallOptions& given) {
  CallOptions options = given;
  // errors in the command line come before waiting for anybody
  std::shared_ptr<const Message> request;
  if (!options.requestType.empty()) request = messageOption(options.requestType, options.text);
  Transport transport;
  const auto start = std::chrono::steady_clock::now();
  if (const std::optional<int> code = findTypes(transport, options)) return *code;
  if (!request) request = messageOption(options.requestType, options.text);

  const MessagePointer reply = newMessage(options.replyType);
  std::chrono::nanoseconds timeout = kAnswerTime;
  if (options.timeout) timeout = *options.timeout - (std::chrono::steady_clock::now() - start);
  const CallResult result = transport.node().call(options.service, *request, *reply, timeout);
  if (result.outcome == CallOutcome::kNoService) return failWithoutService(transport, options.service);
  if (!result) return fail(result.error);
  if (options.asJson) return print(messageJson(*reply) + "\n") ? kDone : kFailed;
  const std::string text = messageText(*reply);
  // protobuf's text format leaves out values that are false, 0 or empty
  if (text.empty()) say("the reply, " + options.replyType + ", has only default values");
  return print(text + "\n") ? kDone : kFailed;
}

}  // namespace pongsim::cli
