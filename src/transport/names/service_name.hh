#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <utility>

namespace pongsim::transport {

/// A service uses two topics. Their names have no leading slash, so they are never users' topics, and their DDS type
/// contains both message types.
std::string requestTopic(std::string_view service);
std::string replyTopic(std::string_view service);
std::string serviceType(std::string_view requestType, std::string_view replyType);

/// @return The service with that request topic, or nothing.
std::optional<std::string_view> serviceOfRequestTopic(std::string_view topic);

/// @return Request and reply type; nothing if `type` is not that of a service.
std::optional<std::pair<std::string_view, std::string_view>> typesOfService(std::string_view type);

/// @return The name with a leading slash and without a trailing one.
/// @throws std::invalid_argument for an invalid name.
std::string absoluteService(std::string_view name);

}  // namespace pongsim::transport
