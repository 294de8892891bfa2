#include "ros2/services/entity_finder.hh"

#include <algorithm>
#include <string_view>

namespace pongsim::ros2 {

namespace {

bool hasLink(const Model& model) {
  return !model.links().empty() || std::ranges::any_of(model.models(), [](const Model& each) { return hasLink(each); });
}

/// @return A frame with the link's pose and motion.
MovingFrame partOf(const Link& link, const Pose& X_WorldPart) {
  const Vector3 w = link.angularVelocity();
  return {X_WorldPart, link.linearVelocity() + w.cross(X_WorldPart.position - link.pose().position), w};
}

/// @return "model::link" for "model/link".
std::string withColons(std::string_view name) {
  std::string result;
  for (const char letter : name) {
    if (letter == '/') {
      result += "::";
    } else {
      result += letter;
    }
  }
  return result;
}

}  // namespace

MovingFrame movingFrame(const Model& model) {
  const std::optional<Link> link = model.canonicalLink();
  return link ? partOf(*link, model.pose()) : MovingFrame{model.pose()};
}

std::vector<Model> EntityFinder::entities() const {
  std::vector<Model> models = world_.models();
  std::erase_if(models, [](const Model& model) { return !hasLink(model); });
  return models;
}

std::vector<Model> EntityFinder::poses() const {
  std::vector<Model> models = world_.models();
  std::erase_if(models, [](const Model& model) { return hasLink(model); });
  return models;
}

Outcome<Model> EntityFinder::find(const std::string& name) const {
  if (name.empty()) return {{}, "no entity is given"};
  if (const std::optional<Model> model = world_.model(name)) return {model, {}};
  return {{}, "there is no entity '" + name + "'"};
}

Outcome<MovingFrame> EntityFinder::frame(const std::string& id) const {
  if (const auto found = frameNamed(id)) return {found, {}};
  const std::string bare(frames_.fromRos(id));
  if (const auto found = frameNamed(bare)) return {found, {}};
  if (const auto found = frameNamed(withColons(bare))) return {found, {}};
  return {{}, "there is no frame '" + id + "': it is 'world', a model, 'model/link' or a <frame> of the world"};
}

std::optional<MovingFrame> EntityFinder::frameNamed(const std::string& name) const {
  if (name.empty() || name == "world" || name == world_.name()) return MovingFrame();
  if (const auto model = world_.model(name)) return movingFrame(*model);
  if (const std::size_t colons = name.rfind("::"); colons != std::string::npos) {
    const auto model = world_.model(std::string_view(name).substr(0, colons));
    const auto link = model ? model->link(std::string_view(name).substr(colons + 2)) : std::nullopt;
    if (link) return partOf(*link, link->pose());
  }
  for (const WorldFrame& frame : world_.frames()) {
    if (frame.name == name) return MovingFrame{frame.pose};
  }
  return std::nullopt;
}

}  // namespace pongsim::ros2
