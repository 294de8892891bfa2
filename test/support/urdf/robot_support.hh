#pragma once

#include <gtest/gtest.h>

#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "sdf/text/document.hh"
#include "urdf/converter.hh"

namespace pongsim::urdf::test {

using Messages = std::vector<std::string>;

/// @return The messages as `format` writes them, but each on one line, the hint after " | ".
inline Messages messagesOf(const Diagnostics& diagnostics) {
  Messages messages;
  for (Diagnostic diagnostic : diagnostics.all()) {
    const std::string hint = diagnostic.hint.empty() ? "" : " | " + diagnostic.hint;
    diagnostic.hint.clear();
    messages.push_back(format(diagnostic) + hint);
  }
  return messages;
}

/// @return A `<robot name="r">` with this content, which begins in line 2, column 1 of "r.urdf".
inline Element robotWith(std::string_view content) {
  Diagnostics diagnostics;
  const auto robot = sdf::parseDocument("<robot name=\"r\">\n" + std::string(content) + "\n</robot>",
                                        std::make_shared<const std::string>("r.urdf"), diagnostics);
  EXPECT_EQ(messagesOf(diagnostics), Messages());
  return robot.value_or(Element());
}

/// @return A link with a mass of 1 kg and this content.
inline std::string linkNamed(const std::string& name, const std::string& content = "") {
  return "<link name=\"" + name +
         "\"><inertial><mass value=\"1\"/><inertia ixx=\"0.1\" ixy=\"0\" ixz=\"0\" iyy=\"0.1\" iyz=\"0\" izz=\"0.1\"/>"
         "</inertial>" +
         content + "</link>\n";
}

inline std::string jointNamed(const std::string& name, const std::string& type, const std::string& parent,
                              const std::string& child, const std::string& content = "") {
  return "<joint name=\"" + name + "\" type=\"" + type + "\"><parent link=\"" + parent + "\"/><child link=\"" + child +
         "\"/>" + content + "</joint>\n";
}

struct Converted {
  std::optional<Element> sdf;
  Messages messages;

  const Element& model() const { return sdf.value().children.at(0); }
  /// @return The child of the model with this kind and name.
  const Element& part(std::string_view kind, std::string_view name) const {
    for (const Element& part : model().children) {
      if (part.name == kind && part.attributeOr("name", "") == name) return part;
    }
    throw std::out_of_range("there is no " + std::string(kind) + " " + std::string(name));
  }
  bool has(std::string_view kind, std::string_view name) const {
    for (const Element& part : model().children) {
      if (part.name == kind && part.attributeOr("name", "") == name) return true;
    }
    return false;
  }
};

inline Converted convert(std::string_view content) {
  const Element robot = robotWith(content);
  Diagnostics diagnostics;
  Converted converted;
  converted.sdf = toSdf(robot, diagnostics);
  converted.messages = messagesOf(diagnostics);
  return converted;
}

/// @return The text at "inertial/mass" below the element; "(none)" if there is no such element.
inline std::string textAt(const Element& element, std::string_view path) {
  const Element* found = &element;
  while (found != nullptr && !path.empty()) {
    const std::string_view name = path.substr(0, path.find('/'));
    path.remove_prefix(std::min(name.size() + 1, path.size()));
    found = found->child(name);
  }
  return found != nullptr ? found->text : "(none)";
}

}  // namespace pongsim::urdf::test
