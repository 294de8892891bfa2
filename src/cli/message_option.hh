#pragma once

#include <memory>
#include <string>
#include <string_view>

#include "pongsim/message.hh"

namespace pongsim::cli {

/// @return The full name of the message type that a user names.
/// @throws UsageError where there is no such type.
std::string messageTypeOption(std::string_view name);

/// @param source Where the text is from, for messages about it.
/// @return The message of type `type` that a user's text describes.
/// @throws UsageError that shows the place where the text is wrong.
std::shared_ptr<const Message> messageOption(std::string_view type, std::string_view text,
                                             const std::string& source = "message text");

}  // namespace pongsim::cli
