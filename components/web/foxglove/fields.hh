#pragma once

#include <cstddef>
#include <cstdint>
#include <limits>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include <nlohmann/json.hpp>

/// Parses untrusted JSON from clients.
namespace pongsim::web::foxglove {

/// @return The parsed JSON; null if it is invalid, or nested more than 64 deep, which would take long.
inline nlohmann::json parseJson(std::string_view text) {
  constexpr int kDeepest = 64;
  int depth = 0;
  bool isInText = false;
  for (std::size_t i = 0; i < text.size(); ++i) {
    if (isInText && text[i] == '\\') {
      ++i;
    } else if (text[i] == '"') {
      isInText = !isInText;
    } else if (!isInText && (text[i] == '[' || text[i] == '{')) {
      if (++depth > kDeepest) return {};
    } else if (!isInText && (text[i] == ']' || text[i] == '}')) {
      --depth;
    }
  }
  const nlohmann::json parsed = nlohmann::json::parse(text, nullptr, false);
  return parsed.is_discarded() ? nlohmann::json() : parsed;
}

/// @return The text with this name; nothing if there is none.
inline std::optional<std::string> textField(const nlohmann::json& object, const char* name) {
  if (!object.is_object()) return std::nullopt;
  const auto found = object.find(name);
  if (found == object.end() || !found->is_string()) return std::nullopt;
  return found->get<std::string>();
}

/// @return The number as a protocol id, unsigned with 32 bits; nothing if it is not one.
inline std::optional<std::uint32_t> idOf(const nlohmann::json& value) {
  if (!value.is_number_integer()) return std::nullopt;
  const auto number = value.get<std::int64_t>();
  if (number < 0 || number > std::numeric_limits<std::uint32_t>::max()) return std::nullopt;
  return static_cast<std::uint32_t>(number);
}

inline std::optional<std::uint32_t> idField(const nlohmann::json& object, const char* name) {
  if (!object.is_object()) return std::nullopt;
  const auto found = object.find(name);
  return found == object.end() ? std::nullopt : idOf(*found);
}

/// @return The list with this name; nothing if there is none.
inline std::optional<std::vector<nlohmann::json>> listField(const nlohmann::json& object, const char* name) {
  if (!object.is_object()) return std::nullopt;
  const auto found = object.find(name);
  if (found == object.end() || !found->is_array()) return std::nullopt;
  return std::vector<nlohmann::json>(found->begin(), found->end());
}

}  // namespace pongsim::web::foxglove
