#include "assets/meshes/collada_file.hh"

#include <algorithm>
#include <functional>
#include <initializer_list>
#include <map>
#include <stdexcept>

#include "assets/meshes/collada_check.hh"
#include "assets/meshes/collada_xml.hh"

namespace pongsim::assets {

namespace {

using tinyxml2::XMLDocument;
using tinyxml2::XMLElement;

template <class IsWanted>
void removeChildren(XMLElement& parent, const IsWanted& isWanted) {
  XMLElement* next = nullptr;
  for (XMLElement* child = parent.FirstChildElement(); child != nullptr; child = next) {
    next = child->NextSiblingElement();
    if (!isWanted(*child)) parent.DeleteChild(child);
  }
}

bool isOneOf(const XMLElement& element, std::initializer_list<std::string_view> names) {
  return std::ranges::find(names, std::string_view(element.Name())) != names.end();
}

/// Replaces instances of a skin or of a morphed mesh by instances of the mesh.
void withoutControllers(XMLElement& collada) {
  std::map<std::string, std::string, std::less<>> meshes;
  forEachChild(collada, "library_controllers", [&](const XMLElement& library) {
    forEachChild(library, "controller", [&](const XMLElement& controller) {
      const XMLElement* kind = controller.FirstChildElement("skin");
      if (kind == nullptr) kind = controller.FirstChildElement("morph");
      if (kind != nullptr) meshes.emplace(attributeOf(controller, "id"), attributeOf(*kind, "source"));
    });
  });
  const std::function<void(XMLElement&)> replaceIn = [&](XMLElement& parent) {
    for (XMLElement* child = parent.FirstChildElement(); child != nullptr; child = child->NextSiblingElement()) {
      replaceIn(*child);
      if (!isOneOf(*child, {"instance_controller"})) continue;
      const auto mesh = meshes.find(referenceIn(*child, "url"));
      if (mesh == meshes.end()) continue;
      child->SetName("instance_geometry");
      child->SetAttribute("url", mesh->second.c_str());
    }
  };
  replaceIn(collada);
}

void removeInside(XMLElement& outer, std::initializer_list<std::string_view> names) {
  removeChildren(outer, [&](const XMLElement& child) { return !isOneOf(child, names); });
  for (XMLElement* child = outer.FirstChildElement(); child != nullptr; child = child->NextSiblingElement()) {
    removeInside(*child, names);
  }
}

/// Adds names to images without one, which some programs write: Assimp ends the process for them.
void nameImages(XMLElement& outer) {
  for (XMLElement* child = outer.FirstChildElement(); child != nullptr; child = child->NextSiblingElement()) {
    nameImages(*child);
    if (!isOneOf(*child, {"init_from", "ref"})) continue;
    const std::string_view name = textOf(*child);
    if (!name.empty() && name != "file://") continue;
    child->DeleteChildren();
    child->SetText("unknown_texture");
  }
}

void removeUnused(XMLElement& collada) {
  withoutControllers(collada);
  removeChildren(collada, [](const XMLElement& child) {
    return isOneOf(child, {"asset", "library_images", "library_effects", "library_materials", "library_geometries",
                           "library_nodes", "library_visual_scenes", "scene"});
  });
  for (XMLElement* child = collada.FirstChildElement(); child != nullptr; child = child->NextSiblingElement()) {
    if (isOneOf(*child, {"asset"})) {
      removeChildren(*child, [](const XMLElement& part) { return isOneOf(part, {"unit", "up_axis"}); });
    }
    // embedded images, past whose end Assimp reads
    if (isOneOf(*child, {"library_images", "library_effects"})) {
      removeInside(*child, {"hex"});
      nameImages(*child);
    }
    if (isOneOf(*child, {"library_geometries"})) removeInside(*child, {"lines", "linestrips"});
  }
}

std::string faultOf(const XMLDocument& document) {
  const std::string where = document.ErrorLineNum() > 0 ? "line " + std::to_string(document.ErrorLineNum()) + ": " : "";
  return where + "the XML is not well-formed";
}

}  // namespace

std::string readCollada(const std::string& content) {
  XMLDocument document;
  if (document.Parse(content.data(), content.size()) != tinyxml2::XML_SUCCESS)
    throw std::runtime_error(faultOf(document));
  XMLElement* collada = document.FirstChildElement("COLLADA");
  if (collada == nullptr) throw std::runtime_error("there is no <COLLADA>");
  removeUnused(*collada);
  checkCollada(*collada);
  tinyxml2::XMLPrinter printer(nullptr, true);
  collada->Accept(&printer);
  return printer.CStr();
}

}  // namespace pongsim::assets
