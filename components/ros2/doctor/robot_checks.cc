#include <tinyxml2.h>

#include <algorithm>
#include <optional>
#include <set>
#include <string>

#include "ros2/doctor/checks.hh"
#include "ros2/node/names.hh"

namespace pongsim::ros2 {

namespace {

using Verdict = Finding::Verdict;
constexpr std::string_view kDescriptionUsers = "RViz, robot_state_publisher";

struct Description {
  std::set<std::string> links;
  /// Those that somebody has to tell the position of.
  std::set<std::string> joints;
};

std::string nameAttribute(const tinyxml2::XMLElement& element) {
  const char* name = element.Attribute("name");
  return name != nullptr ? name : "";
}

std::optional<Description> readDescription(const std::string& text) {
  tinyxml2::XMLDocument document;
  if (document.Parse(text.c_str(), text.size()) != tinyxml2::XML_SUCCESS) return std::nullopt;
  const tinyxml2::XMLElement* robot = document.FirstChildElement("robot");
  if (robot == nullptr) return std::nullopt;
  Description description;
  for (auto* link = robot->FirstChildElement("link"); link != nullptr; link = link->NextSiblingElement("link")) {
    description.links.insert(nameAttribute(*link));
  }
  for (auto* joint = robot->FirstChildElement("joint"); joint != nullptr; joint = joint->NextSiblingElement("joint")) {
    const char* type = joint->Attribute("type");
    const std::string kind = type != nullptr ? type : "";
    const bool isTold = kind == "revolute" || kind == "continuous" || kind == "prismatic";
    if (isTold && joint->FirstChildElement("mimic") == nullptr) description.joints.insert(nameAttribute(*joint));
  }
  return description;
}

void checkLinks(const Observation& seen, const Expected& expected, const Description& description, Findings& findings) {
  std::set<std::string> unknown;
  for (const std::string& link : description.links) {
    // RViz puts its TF Prefix before them
    if (!isKnown(seen.frames, link) && !isKnown(seen.frames, expected.framePrefix + link)) unknown.insert(link);
  }
  if (unknown.empty()) {
    findings.push_back(
        {Verdict::kGood, "tf knows all " + std::to_string(description.links.size()) + " links", {}, "RViz"});
  } else {
    findings.push_back({Verdict::kFault, "tf does not know the links " + quoted(unknown) + " of the description",
                        "leave out --ros2-no-tf, or start robot_state_publisher", "RViz"});
  }
}

void checkJoints(const Observation& seen, const Expected& expected, const Description& description,
                 Findings& findings) {
  const std::string topic = absoluteName(expected.nameSpace, "joint_states");
  const auto stream = seen.streams.find(topic);
  std::set<std::string> silent = description.joints;
  if (stream != seen.streams.end()) {
    for (const std::string& joint : stream->second.joints) silent.erase(joint);
  }
  if (silent.empty()) {
    findings.push_back({Verdict::kGood, "'" + topic + "' has all joints of the description", {}, kDescriptionUsers});
    return;
  }
  findings.push_back({Verdict::kFault, "'" + topic + "' lacks the joints " + quoted(silent) + " of the description",
                      "leave out --ros2-no-joint-states, or start joint_state_broadcaster; for a JointStatePublisher "
                      "a <joint_name> for each",
                      kDescriptionUsers});
}

}  // namespace

Findings checkRobot(const Observation& seen, const Expected& expected) {
  const std::string topic = absoluteName(expected.nameSpace, "robot_description");
  const std::vector<Graph::Endpoint> writers = seen.endpointsOn(topic, Graph::Role::kWriter);
  if (writers.empty()) {
    return {{Verdict::kFault, "nobody publishes '" + topic + "'",
             "leave out --ros2-no-robot-description, or start robot_state_publisher; of several robots each has its "
             "own: --namespace NAME",
             kDescriptionUsers}};
  }
  Findings findings;
  if (writers.size() > 1) {
    findings.push_back({Verdict::kFault,
                        std::to_string(writers.size()) + " publishers of '" + topic +
                            "': " + seen.nodesThat(&NodeInfo::publishes, topic),
                        "pongsim run WORLD --ros2-no-robot-description", kDescriptionUsers});
  }
  if (!std::ranges::all_of(writers, [](const auto& each) { return each.contract.qos.isTransientLocal; })) {
    findings.push_back({Verdict::kFault, "'" + topic + "' is not kept for late subscribers",
                        "publish it transient local", kDescriptionUsers});
  }
  const auto text = seen.descriptions.find(topic);
  if (text == seen.descriptions.end()) return findings;
  const std::optional<Description> description = readDescription(text->second);
  if (!description) {
    findings.push_back({Verdict::kFault, "the text on '" + topic + "' is not a URDF robot",
                        "give robot_state_publisher the URDF, after xacro", kDescriptionUsers});
    return findings;
  }
  if (!seen.frames.empty()) checkLinks(seen, expected, *description, findings);
  checkJoints(seen, expected, *description, findings);
  return findings;
}

}  // namespace pongsim::ros2
