#include "log/playback/played_sdf.hh"

#include <tinyxml2.h>

#include <algorithm>
#include <array>
#include <vector>

#include "log/record/resources.hh"
#include "log/store/failure.hh"
#include "pongsim/node.hh"

namespace pongsim::log {

namespace {

using tinyxml2::XMLElement;

// Systems that only read poses. Those that need velocities or forces are not among them.
constexpr std::array<std::string_view, 15> kLooking{"scene-broadcaster",
                                                    "sensors",
                                                    "pose-publisher",
                                                    "joint-state-publisher",
                                                    "odometry-publisher",
                                                    "magnetometer",
                                                    "air-pressure",
                                                    "log-video-recorder",
                                                    "logical-camera",
                                                    "thermal",
                                                    "thermal-sensor",
                                                    "label",
                                                    "particle-emitter",
                                                    "particle-emitter2",
                                                    "logicalaudiosensorplugin"};

void removePlugins(XMLElement& element) {
  for (XMLElement* child = element.FirstChildElement(); child != nullptr;) {
    XMLElement* const next = child->NextSiblingElement();
    const char* const file = child->Attribute("filename");
    if (std::string_view(child->Name()) == "plugin" && !isOfUseInPlayback(file == nullptr ? "" : file)) {
      element.DeleteChild(child);
    } else if (std::string_view(child->Name()) != "plugin") {
      removePlugins(*child);
    }
    child = next;
  }
}

/// Removes all worlds of a file except the one of that name.
void keepWorld(XMLElement& root, std::string_view name) {
  std::vector<XMLElement*> others;
  bool isThere = false;
  for (XMLElement* world = root.FirstChildElement("world"); world != nullptr;
       world = world->NextSiblingElement("world")) {
    const char* const own = world->Attribute("name");
    const bool isIt = cleanTopic(own == nullptr ? "" : own) == name;
    isThere = isThere || isIt;
    if (!isIt) others.push_back(world);
  }
  if (!isThere) return;
  for (XMLElement* other : others) root.DeleteChild(other);
}

}  // namespace

bool isOfUseInPlayback(std::string_view filename) {
  return std::ranges::any_of(kLooking, [&](std::string_view name) {
    return filename.find("-" + std::string(name) + "-system") != std::string_view::npos;
  });
}

std::string playedSdf(const std::string& sdf, const PlayedFiles& files, std::string_view world) {
  tinyxml2::XMLDocument document;
  const std::string placed = withAddresses(sdf, [&](const std::string& address) { return files.placeOf(address); });
  XMLElement* root = document.Parse(placed.c_str()) == tinyxml2::XML_SUCCESS ? document.RootElement() : nullptr;
  if (root == nullptr) {
    throw Failure("the recording's world can't be read: " +
                  std::string(document.ErrorStr() == nullptr ? "it is empty" : document.ErrorStr()));
  }
  keepWorld(*root, world);
  removePlugins(*root);
  tinyxml2::XMLPrinter printer;
  document.Print(&printer);
  const std::string text = printer.CStr();
  if (std::string_view(root->Name()) == "sdf") return text;
  return "<sdf version='1.9'>" + text.substr(text.find(std::string("<") + root->Name())) + "</sdf>";
}

}  // namespace pongsim::log
