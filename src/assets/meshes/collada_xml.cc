#include "assets/meshes/collada_xml.hh"

#include <cstdlib>
#include <limits>
#include <optional>
#include <stdexcept>

#include "base/parse_number.hh"

namespace pongsim::assets {

namespace {

// what Assimp skips as space
constexpr std::string_view kSpaces = " \t\r\n";
constexpr std::string_view kDigits = "0123456789";

/// @return Nothing if the word isn't a whole number of 31 bits, with or without a sign.
std::optional<std::int32_t> wholeNumber(std::string_view word) {
  const bool hasSign = word.starts_with('-') || word.starts_with('+');
  if (word.find_first_not_of(kDigits, hasSign ? 1 : 0) != std::string_view::npos) return std::nullopt;
  const auto number = base::parseInteger(word);
  if (!number || std::abs(*number) > std::numeric_limits<std::int32_t>::max()) return std::nullopt;
  return static_cast<std::int32_t>(*number);
}

}  // namespace

void refuseElement(const tinyxml2::XMLElement& element, const std::string& reason) {
  throw std::runtime_error("line " + std::to_string(element.GetLineNum()) + ": <" + element.Name() + "> " + reason);
}

std::string_view attributeOf(const tinyxml2::XMLElement& element, const char* name) {
  const char* value = element.Attribute(name);
  return value != nullptr ? value : std::string_view();
}

std::string_view referenceIn(const tinyxml2::XMLElement& element, const char* name) {
  const std::string_view value = attributeOf(element, name);
  return value.starts_with('#') ? value.substr(1) : std::string_view();
}

std::string_view textOf(const tinyxml2::XMLElement& element) {
  for (const auto* child = element.FirstChild(); child != nullptr; child = child->NextSibling()) {
    const tinyxml2::XMLText* text = child->ToText();
    if (text == nullptr) continue;
    // to Assimp, spaces alone are no text
    const std::string_view value = text->Value();
    if (text->CData() || value.find_first_not_of(kSpaces) != std::string_view::npos) return value;
  }
  return {};
}

std::uint64_t numberIn(const tinyxml2::XMLElement& element, const char* name, std::uint64_t otherwise) {
  const char* value = element.Attribute(name);
  if (value == nullptr) return otherwise;
  const auto number = wholeNumber(value);
  if (!number || *number < 0) {
    refuseElement(element, std::string("has ") + name + "=\"" + value + "\", which is not a whole number");
  }
  return static_cast<std::uint64_t>(*number);
}

std::vector<std::int32_t> numbersIn(const tinyxml2::XMLElement& element) {
  std::vector<std::int32_t> numbers;
  const std::string_view text = textOf(element);
  for (std::size_t at = text.find_first_not_of(kSpaces); at < text.size(); at = text.find_first_not_of(kSpaces, at)) {
    const std::string_view word = text.substr(at, text.find_first_of(kSpaces, at) - at);
    const auto number = wholeNumber(word);
    if (!number)
      refuseElement(element, "contains '" + std::string(word.substr(0, 20)) + "', which is not a whole number");
    numbers.push_back(*number);
    at += word.size();
  }
  return numbers;
}

}  // namespace pongsim::assets
