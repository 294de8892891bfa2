#include "transport/names/type_name.hh"

#include <optional>
#include <stdexcept>
#include <utility>

#include "pongsim/message.hh"

namespace pongsim::transport {

namespace {

// What DDS can tell others as a type's name.
constexpr std::size_t kLongestType = 255;

}  // namespace

std::string knownType(std::string_view name) {
  if (std::optional<std::string> known = messageTypeName(name)) return *std::move(known);
  const std::string nearest = nearestMessageType(name);
  throw std::invalid_argument("there is no message type '" + std::string(name) + "'" +
                              (nearest.empty() ? "" : ", did you mean '" + nearest + "'?"));
}

std::string anyType(std::string_view name) {
  if (std::optional<std::string> known = messageTypeName(name)) return *std::move(known);
  if (name.empty()) throw std::invalid_argument("a message type's name is empty");
  if (name.size() > kLongestType) throw std::invalid_argument("a message type's name is longer than 255 characters");
  return std::string(name);
}

}  // namespace pongsim::transport
