#include "base/element_edit.hh"

#include <algorithm>
#include <charconv>
#include <iterator>
#include <utility>

namespace pongsim::base {

Element makeElement(std::string_view name, const SourcePosition& position, std::string text) {
  Element element;
  element.name = name;
  element.text = std::move(text);
  element.position = position;
  return element;
}

Element& addChild(Element& parent, std::string_view name, const SourcePosition& position, std::string text) {
  return parent.children.emplace_back(makeElement(name, position, std::move(text)));
}

Element* childOf(Element& parent, std::string_view name) {
  const auto found = std::ranges::find(parent.children, name, &Element::name);
  return found != parent.children.end() ? &*found : nullptr;
}

Element& childOrNew(Element& parent, std::string_view name, const SourcePosition& position) {
  Element* const child = childOf(parent, name);
  return child != nullptr ? *child : addChild(parent, name, position);
}

void setChild(Element& parent, std::string_view name, const SourcePosition& position, std::string text) {
  Element& child = childOrNew(parent, name, position);
  child.text = std::move(text);
  child.position = position;
}

Element::Attribute* attributeOf(Element& element, std::string_view name) {
  const auto found = std::ranges::find(element.attributes, name, &Element::Attribute::name);
  return found != element.attributes.end() ? &*found : nullptr;
}

void setAttribute(Element& element, std::string_view name, std::string value, const SourcePosition& position) {
  if (Element::Attribute* const attribute = attributeOf(element, name)) {
    attribute->value = std::move(value);
    attribute->position = position;
  } else {
    element.attributes.push_back({std::string(name), std::move(value), position});
  }
}

std::string shortestText(double value) {
  char buffer[32];
  return {std::begin(buffer), std::to_chars(std::begin(buffer), std::end(buffer), value).ptr};
}

}  // namespace pongsim::base
