#include "urdf/converter.hh"

#include <string>
#include <utility>
#include <vector>

#include "base/element_edit.hh"
#include "urdf/extensions.hh"
#include "urdf/joint_elements.hh"
#include "urdf/link_elements.hh"
#include "urdf/lumping.hh"
#include "urdf/origin.hh"
#include "urdf/pose_element.hh"
#include "urdf/robot.hh"
#include "urdf/robot_check.hh"
#include "urdf/structure_check.hh"
#include "urdf/urdfdom.hh"

namespace pongsim::urdf {

namespace {

/// @return For each link, whether it is converted: links without mass and their descendants are not, as in Fortress.
std::vector<bool> findMade(const Robot& robot, Diagnostics& diagnostics) {
  std::vector<bool> isMade(robot.links.size(), true);
  for (std::size_t i = 0; i < robot.links.size(); ++i) {
    const Link& link = robot.links[i];
    if (link.lumpedInto || (i == 0 && link.name == "world")) continue;
    if (link.joint && !isMade[link.joint->parent]) {
      isMade[i] = false;
    } else if (!link.inertial || !(link.inertial->mass > 0)) {
      isMade[i] = false;
      const bool hasZero = link.inertial.has_value();
      diagnostics.warning(hasZero ? link.inertial->position : link.xml->position,
                          "link '" + link.name + (hasZero ? "' has a mass that is not above zero" : "' has no mass") +
                              ": it is ignored, with its joint and all links below it",
                          "give it an <inertial> with a mass");
    }
  }
  return isMade;
}

/// Adds the pose of the robot as a whole: Fortress reads an <origin> of the robot, although URDF has none.
void addRobotPose(const Element& robot, Element& model) {
  const Element* origin = robot.child("origin");
  if (origin == nullptr) return;
  addPose(model, originOf(robot), origin->position);
}

Element modelOf(const Robot& robot, const Extensions& extensions, Diagnostics& diagnostics) {
  Element model = base::makeElement("model", robot.xml->position);
  base::setAttribute(model, "name", robot.xml->attributeOr("name", ""), robot.xml->attribute("name")->position);
  const std::vector<bool> isMade = findMade(robot, diagnostics);
  for (std::size_t i = 0; i < robot.links.size(); ++i) {
    const Link& link = robot.links[i];
    if (!isMade[i] || link.lumpedInto || (i == 0 && link.name == "world")) continue;
    if (link.joint) addJoint(robot, link, extensions, model, diagnostics);
    addLink(robot, link, extensions, model);
  }
  for (const Link& link : robot.links) {
    if (link.lumpedInto && isMade[link.lumpedInto->link]) addFrames(robot, link, extensions, model);
  }
  extensions.addToModel(model);
  addRobotPose(*robot.xml, model);
  return model;
}

}  // namespace

std::optional<Element> toSdf(const Element& robot, Diagnostics& diagnostics) {
  const bool isSound = checkRobot(robot, diagnostics);
  if (!checkStructure(robot, diagnostics) || !isSound) return std::nullopt;
  const ::urdf::ModelInterfaceSharedPtr model = readWithUrdfdom(robot, diagnostics);
  if (model == nullptr) return std::nullopt;

  const Extensions extensions(robot);
  extensions.check(diagnostics);
  Robot values = robotFrom(*model, robot);
  lumpFixedJoints(values, extensions);
  Element sdf = base::makeElement("sdf", robot.position);
  base::setAttribute(sdf, "version", "1.7", robot.position);
  sdf.children.push_back(modelOf(values, extensions, diagnostics));
  return sdf;
}

}  // namespace pongsim::urdf
