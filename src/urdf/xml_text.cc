#include "urdf/xml_text.hh"

#include <algorithm>
#include <array>
#include <string_view>

#include "pongsim/files/xml_text.hh"

namespace pongsim::urdf {

namespace {

constexpr std::array<std::string_view, 3> kParts{"link", "joint", "material"};

void appendTag(const Element& element, std::string& xml) {
  xml += '<' + element.name;
  for (const Element::Attribute& attribute : element.attributes) {
    xml += ' ' + attribute.name + "=\"";
    appendXmlText(attribute.value, xml);
    xml += '"';
  }
  xml += '>';
}

void append(const Element& element, std::string& xml) {
  appendTag(element, xml);
  for (const Element& child : element.children) append(child, xml);
  appendXmlText(element.text, xml);
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
