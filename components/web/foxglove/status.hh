#pragma once

#include <string>
#include <string_view>

#include <nlohmann/json.hpp>

#include "web/server/session.hh"

namespace pongsim::web::foxglove {

/// Severity of a message to a client, with the protocol's numbers.
enum class StatusLevel { kInfo = 0, kWarning = 1, kError = 2 };

/// @return The JSON on one line; invalid UTF-8 is replaced.
inline std::string textOf(const nlohmann::json& message) {
  return message.dump(-1, ' ', false, nlohmann::json::error_handler_t::replace);
}

/// Sends the client a text.
inline void sendStatus(Client& client, StatusLevel level, std::string_view text) {
  client.sendText(textOf({{"op", "status"}, {"level", static_cast<int>(level)}, {"message", text}}));
}

}  // namespace pongsim::web::foxglove
