#include "urdf/xml_text.hh"

#include <algorithm>
#include <array>
#include <string_view>

namespace pongsim::urdf {

namespace {

constexpr std::array<std::string_view, 3> kParts{"link", "joint", "material"};

void appendEscaped(std::string_view text, std::string& xml) {
  for (const char letter : text) {
    switch (letter) {
      case '&':
        xml += "&amp;";
        break;
      case '<':
        xml += "&lt;";
        break;
      case '>':
        xml += "&gt;";
        break;
      case '"':
        xml += "&quot;";
        break;
      default:
        xml += letter;
    }
  }
}

void appendTag(const Element& element, std::string& xml) {
  xml += '<' + element.name;
  for (const Element::Attribute& attribute : element.attributes) {
    xml += ' ' + attribute.name + "=\"";
    appendEscaped(attribute.value, xml);
    xml += '"';
  }
  xml += '>';
}

void append(const Element& element, std::string& xml) {
  appendTag(element, xml);
  for (const Element& child : element.children) append(child, xml);
  appendEscaped(element.text, xml);
  xml += "</" + element.name + '>';
}

}  // namespace

std::string xmlOf(const Element& robot) {
  std::string xml;
  appendTag(robot, xml);
  for (const Element& child : robot.children) {
    if (std::ranges::find(kParts, child.name) != kParts.end()) append(child, xml);
  }
  xml += "</" + robot.name + '>';
  return xml;
}

}  // namespace pongsim::urdf
