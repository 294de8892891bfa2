#pragma once

#include <cstddef>
#include <cstdint>
#include <limits>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include <nlohmann/json.hpp>

/// What clients say in JSON, which may be anything.
namespace pongsim::web::foxglove {

/// @return What a text says as JSON; null where it is none, or is nested more than 64 deep, which would take long.
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

/// @return The text of that name; nothing where there is none.
inline std::optional<std::string> textField(const nlohmann::json& object, const char* name) {
  if (!object.is_object()) return std::nullopt;
  const auto found = object.find(name);
  if (found == object.end() || !found->is_string()) return std::nullopt;
  return found->get<std::string>();
}

/// @return The number as an id of the protocol, 32 bits without a sign; nothing where it is none.
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

/// @return The list of that name; nothing where there is none.
inline std::optional<std::vector<nlohmann::json>> listField(const nlohmann::json& object, const char* name) {
  if (!object.is_object()) return std::nullopt;
  const auto found = object.find(name);
  if (found == object.end() || !found->is_array()) return std::nullopt;
  return std::vector<nlohmann::json>(found->begin(), found->end());
}

}  // namespace pongsim::web::foxglove
