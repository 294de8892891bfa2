#include "combinations/kind.hh"

#include <gtest/gtest.h>
#include <tinyxml2.h>

#include <fstream>
#include <iterator>
#include <string>
#include <string_view>

#include "support/regex.hh"

namespace pongsim::test {

namespace {

std::string textOf(const tinyxml2::XMLElement& element) {
  tinyxml2::XMLPrinter printer(nullptr, true);
  element.Accept(&printer);
  return printer.CStr();
}

bool isForLevels(const tinyxml2::XMLElement& element) {
  const std::string className = element.Attribute("name") == nullptr ? "" : element.Attribute("name");
  return element.Name() == std::string("plugin") && (className == "gz::sim" || className == "ignition::gazebo");
}

/// Puts an element of the world where it belongs.
void add(const tinyxml2::XMLElement& element, Kind& kind) {
  const std::string name = element.Name();
  if (isForLevels(element)) {
    for (auto* child = element.FirstChildElement(); child != nullptr; child = child->NextSiblingElement()) {
      kind.performers += textOf(*child);
    }
  } else if (name == "model") {
    const std::string text = textOf(element);
    kind.models.push_back({element.Attribute("name"), text, "<sdf version='1.9'>" + text + "</sdf>"});
  } else {
    if (name == "light" || name == "actor") kind.others.push_back(element.Attribute("name"));
    kind.rest += textOf(element);
  }
}

/// @param text A document with a world.
Kind split(const std::string& name, const std::string& text) {
  Kind kind;
  kind.name = name;
  tinyxml2::XMLDocument document;
  EXPECT_EQ(document.Parse(text.c_str()), tinyxml2::XML_SUCCESS) << name << ": " << document.ErrorStr();
  const tinyxml2::XMLElement* world =
      tinyxml2::XMLHandle(document).FirstChildElement("sdf").FirstChildElement("world").ToElement();
  if (world == nullptr) return kind;
  kind.world = world->Attribute("name");
  for (auto* child = world->FirstChildElement(); child != nullptr; child = child->NextSiblingElement()) {
    add(*child, kind);
  }
  return kind;
}

}  // namespace

std::string Kind::worldText(bool withModels, const std::string& worldName) const {
  std::string text = "<world name='" + worldName + "'>" + rest;
  std::string inLevel;
  const auto refer = [&](const std::string& entity) {
    const std::string reference = "<ref>" + entity + "</ref>";
    // a performer is always loaded
    if (performers.find(reference) == std::string::npos) inLevel += reference;
  };
  for (const std::string& other : others) refer(other);
  for (const KindModel& model : models) {
    if (!withModels) break;
    text += model.inWorld;
    refer(model.name);
  }
  text +=
      "<model name='scout'><static>true</static><link name='link'/></model><plugin filename='dummy' name='gz::sim'>";
  if (withModels) text += performers;
  text += "<performer name='scout'><ref>scout</ref><geometry><box><size>1 1 1</size></box></geometry></performer>";
  if (!inLevel.empty()) {
    text += "<level name='here'><geometry><box><size>100 100 100</size></box></geometry>" + inLevel + "</level>";
  }
  return text + "</plugin></world>";
}

Kind kindOf(const std::string& name, const std::string& content) {
  return split(name,
               "<sdf version='1.9'><world name='w'>"
               "<plugin filename='ignition-gazebo-physics-system' name='ignition::gazebo::systems::Physics'/>" +
                   content + "</world></sdf>");
}

Kind kindFrom(const std::filesystem::path& file) {
  std::ifstream stream(file);
  std::string text{std::istreambuf_iterator<char>(stream), {}};
  // tables and maps lie beside the example that reads them
  for (const std::string_view beside : {"<data>", "<slip_map>"}) {
    const std::size_t at = text.find(beside);
    if (at != std::string::npos) text.insert(at + beside.size(), file.parent_path().string() + "/");
  }
  Kind kind = split(file.stem().string(), text);
  const Regex command(R"re(pongsim topic -t (\S+) -m (\S+) -p "([^"]*)")re");
  for (const Regex::Match& match : command.allIn(text)) kind.commands.push_back({match[1], match[2], match[3]});
  return kind;
}

}  // namespace pongsim::test
