#pragma once

#include <optional>
#include <string>
#include <string_view>

#include "pongsim/message.hh"
#include "web/server/session.hh"

/// What ign-launch's WebSocket server and its clients send each other: "operation,topic,type,payload".
namespace pongsim::web::gz {

/// A message from a client. Lives as long as its bytes.
struct Call {
  std::string_view operation;
  std::string_view topic;
  std::string_view type;
  /// May have commas in it.
  std::string_view payload;
};

/// @return Nothing where it has no three commas.
std::optional<Call> readCall(std::string_view bytes);

/// @return What stands in front of the payload.
std::string head(std::string_view operation, std::string_view topic, std::string_view type);

/// @return A whole frame with a message.
Frame frame(std::string_view operation, std::string_view topic, const Message& message);

/// @return A whole frame with a text as ignition.msgs.StringMsg.
Frame textFrame(std::string_view operation, std::string_view topic, std::string_view text);

}  // namespace pongsim::web::gz
