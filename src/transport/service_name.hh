#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <utility>

namespace pongsim::transport {

/// A service travels as two topics, whose names have no leading slash and are no user's topics therefore, of one DDS
/// type that names both message types.
std::string requestTopic(std::string_view service);
std::string replyTopic(std::string_view service);
std::string serviceType(std::string_view requestType, std::string_view replyType);

/// @return The service of which that is the request topic, or nothing.
std::optional<std::string_view> serviceOfRequestTopic(std::string_view topic);

/// @return Request and reply type, or nothing where `type` is no service's.
std::optional<std::pair<std::string_view, std::string_view>> typesOfService(std::string_view type);

/// @return The name with a leading slash and without a trailing one.
/// @throws std::invalid_argument for a name that is none.
std::string absoluteService(std::string_view name);

}  // namespace pongsim::transport
