#pragma once

#include <memory>
#include <string>
#include <string_view>

#include "pongsim/message.hh"

namespace pongsim::cli {

/// @return The full name of the message type named by the user.
/// @throws UsageError if there is no such type.
std::string messageTypeOption(std::string_view name);

/// @param source Where the text comes from, for messages about it.
/// @return A message of type `type`, parsed from the user's text.
/// @throws UsageError that shows where the text is wrong.
std::shared_ptr<const Message> messageOption(std::string_view type, std::string_view text,
                                             const std::string& source = "message text");

}  // namespace pongsim::cli
