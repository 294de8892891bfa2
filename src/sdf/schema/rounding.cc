#include "sdf/schema/rounding.hh"

#include <algorithm>
#include <array>
#include <cstdio>
#include <string>
#include <string_view>
#include <vector>

#include "base/parse_number.hh"
#include "sdf/schema/schema.hh"

namespace pongsim::sdf {

namespace {

constexpr std::string_view kTypes[] = {"double", "float", "vector2d", "vector3", "quaternion", "pose", "color"};

void roundText(std::string& text, std::string_view type, int digits) {
  if (std::ranges::find(kTypes, type) == std::end(kTypes)) return;
  const std::optional<std::vector<double>> numbers = base::parseDoubles(text);
  if (!numbers || numbers->empty()) return;
  text.clear();
  for (const double number : *numbers) {
    std::array<char, 64> word{};
    std::snprintf(word.data(), word.size(), "%.*g", digits, number);
    text += (text.empty() ? "" : " ") + std::string(word.data());
  }
}

void roundIn(Element& element, const Schema::Part& part, int digits) {
  roundText(element.text, part.row.type, digits);
  if (part.type == nullptr || part.isFreeForm) return;
  for (Element::Attribute& attribute : element.attributes) {
    const Schema::Part* const known = Schema::find(part.type->attributes, attribute.name);
    if (known != nullptr) roundText(attribute.value, known->row.type, digits);
  }
  for (Element& child : element.children) {
    const Schema::Part* const known = Schema::find(part.type->children, child.name);
    if (known != nullptr && child.name != "plugin") roundIn(child, *known, digits);
  }
}

}  // namespace

void roundNumbers(Element& root, int digits) { roundIn(root, Schema::instance().root(), digits); }

}  // namespace pongsim::sdf
