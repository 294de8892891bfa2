#pragma once

#include <optional>
#include <string>
#include <string_view>

#include "pongsim/message.hh"
#include "web/server/session.hh"

/// The messages of ign-launch's WebSocket server and its clients: "operation,topic,type,payload".
namespace pongsim::web::gz {

/// A message from a client. Valid as long as its bytes.
struct Call {
  std::string_view operation;
  std::string_view topic;
  std::string_view type;
  /// May contain commas.
  std::string_view payload;
};

/// @return Nothing if it does not have three commas.
std::optional<Call> readCall(std::string_view bytes);

/// @return What precedes the payload.
std::string head(std::string_view operation, std::string_view topic, std::string_view type);

/// @return A complete frame with a message.
Frame frame(std::string_view operation, std::string_view topic, const Message& message);

/// @return A complete frame with a text as ignition.msgs.StringMsg.
Frame textFrame(std::string_view operation, std::string_view topic, std::string_view text);

}  // namespace pongsim::web::gz
