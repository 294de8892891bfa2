#include "cli/options/message_option.hh"

#include <algorithm>

#include "shared/program/failure.hh"

namespace pongsim::cli {

namespace {

/// Number of bytes of a line shown before and after the position.
constexpr std::size_t kShownBefore = 60, kShownAfter = 40;

bool continuesCharacter(char byte) { return (static_cast<unsigned char>(byte) & 0xC0U) == 0x80; }

/// @return The line of the text with the error, or the part of it around the position, with a caret below.
std::string showPlace(std::string_view text, const MessageError& error) {
  for (int line = 1; line < error.line; ++line) text.remove_prefix(std::min(text.find('\n'), text.size() - 1) + 1);
  text = text.substr(0, text.find('\n'));
  const std::size_t place = std::min(static_cast<std::size_t>(error.column - 1), text.size());

  // whole characters only
  std::size_t begin = place - std::min(place, kShownBefore);
  while (begin > 0 && continuesCharacter(text[begin])) --begin;
  std::size_t end = std::min(place + kShownAfter, text.size());
  while (end < text.size() && continuesCharacter(text[end])) ++end;

  std::string shown(text.substr(begin, end - begin));
  std::replace_if(
      shown.begin(), shown.end(), [](char letter) { return static_cast<unsigned char>(letter) < ' '; }, ' ');
  const std::string_view before = text.substr(begin, place - begin);
  const auto width =
      before.size() - static_cast<std::size_t>(std::count_if(before.begin(), before.end(), continuesCharacter));
  return "  " + shown + "\n  " + std::string(width, ' ') + "^";
}

}  // namespace

std::string messageTypeOption(std::string_view name) {
  if (std::optional<std::string> type = messageTypeName(name)) return *std::move(type);
  const std::string nearest = nearestMessageType(name);
  throw UsageError("unknown message type '" + std::string(name) + "'",
                   nearest.empty() ? std::string() : "did you mean '" + nearest + "'?");
}

std::shared_ptr<const Message> messageOption(std::string_view type, std::string_view text, const std::string& source) {
  const std::shared_ptr<Message> message = newMessage(type);
  const std::optional<MessageError> error = parseMessage(text, *message);
  if (!error) return message;

  std::string said = source + ": " + error->message;
  if (error->line > 0) {
    said = source + ":" + std::to_string(error->line) + ":" + std::to_string(error->column) + ": " + error->message +
           "\n" + showPlace(text, *error);
  }
  throw UsageError(said, error->hint);
}

}  // namespace pongsim::cli
