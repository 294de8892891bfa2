#pragma once

#include <string>
#include <string_view>

#include <nlohmann/json.hpp>

#include "web/server/session.hh"

namespace pongsim::web::foxglove {

/// How bad it is what a client is told, as the protocol numbers it.
enum class StatusLevel { kInfo = 0, kWarning = 1, kError = 2 };

/// @return The JSON on one line; text that is no UTF-8 is mended.
inline std::string textOf(const nlohmann::json& message) {
  return message.dump(-1, ' ', false, nlohmann::json::error_handler_t::replace);
}

/// Tells the client in words.
inline void sendStatus(Client& client, StatusLevel level, std::string_view text) {
  client.sendText(textOf({{"op", "status"}, {"level", static_cast<int>(level)}, {"message", text}}));
}

}  // namespace pongsim::web::foxglove
