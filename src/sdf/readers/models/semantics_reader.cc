#include "sdf/readers/models/semantics_reader.hh"

#include <algorithm>
#include <array>
#include <cctype>
#include <string_view>
#include <utility>

#include "base/nearest_word.hh"

namespace pongsim::sdf {

namespace {

constexpr std::array<std::pair<std::string_view, std::uint8_t>, 5> kCategories{
    {{"object", 0}, {"robot", 1}, {"human", 2}, {"dynamic_object", 4}, {"static_object", 5}}};

std::string lower(std::string text) {
  std::ranges::transform(text, text.begin(),
                         [](unsigned char letter) { return static_cast<char>(std::tolower(letter)); });
  return text;
}

/// @return The first child of that name; others are a warning.
const Element* onlyChild(const Element& element, const char* name, const std::string& owner, Context& context) {
  const std::vector<const Element*> found = element.childrenNamed(name);
  if (found.size() > 1) {
    context.diagnostics.warning(
        found[1]->position, "the semantics of " + owner + " have more than one <" + name + ">: the first one counts");
  }
  return found.empty() ? nullptr : found[0];
}

void warnOfEmpty(const Element& element, const std::string& owner, Context& context) {
  context.diagnostics.warning(element.position,
                              "a <" + element.name + "> in the semantics of " + owner + " is empty: it is left out");
}

}  // namespace

Semantics readSemantics(const Element& model, const std::string& owner, Context& context) {
  Semantics semantics;
  const Element* element = model.child("gz:semantics");
  if (element == nullptr) return semantics;
  if (const Element* category = onlyChild(*element, "category", owner, context)) {
    const auto* const found =
        std::ranges::find(kCategories, lower(category->text), &std::pair<std::string_view, std::uint8_t>::first);
    if (found != kCategories.end()) {
      semantics.category = found->second;
    } else {
      std::vector<std::string_view> names;
      for (const auto& [name, number] : kCategories) names.push_back(name);
      context.diagnostics.warning(category->position,
                                  "'" + category->text + "' is not a category of " + owner + ": it is left out",
                                  base::didYouMean(category->text, names));
    }
  }
  if (const Element* description = onlyChild(*element, "description", owner, context)) {
    if (description->text.empty()) warnOfEmpty(*description, owner, context);
    semantics.description = description->text;
  }
  for (const Element* tag : element->childrenNamed("tag")) {
    if (tag->text.empty()) {
      warnOfEmpty(*tag, owner, context);
    } else {
      semantics.tags.push_back(tag->text);
    }
  }
  return semantics;
}

}  // namespace pongsim::sdf
