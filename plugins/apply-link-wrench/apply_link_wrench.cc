#include <ignition/msgs/entity.pb.h>

#include <algorithm>
#include <optional>
#include <string>
#include <vector>

#include "pongsim/parameters.hh"
#include "pongsim/system.hh"

namespace pongsim {

namespace {

/// @return The link of a name as "model::link".
std::optional<Link> linkNamed(const World& world, const std::string& name) {
  const std::size_t separator = name.rfind("::");
  if (separator == std::string::npos) return std::nullopt;
  const std::optional<Model> model = world.model(name.substr(0, separator));
  return model ? model->link(name.substr(separator + 2)) : std::nullopt;
}

/// Applies wrenches to links that the file names, in every step.
class ApplyLinkWrench : public System {
 public:
  void configure(const SystemContext& context) override {
    if (context.model) refuse(context.sdf, "ApplyLinkWrench must stand in the <world>");
    world_ = &context.world;
    log_ = &context.log;
    for (const Element* element : context.sdf.childrenNamed("persistent")) addWrench(*element);
    initial_ = wrenches_;
    const std::string topic = "/world/" + std::string(world_->name()) + "/wrench/clear";
    clear_ = context.node.subscribe<ignition::msgs::Entity>(topicParameter(context.sdf, "topic_clear", topic),
                                                            [this](const auto& entity) { clear(entity); });
  }

  void preUpdate(const StepInfo& info) override {
    if (info.paused) return;
    for (LinkWrench& wrench : wrenches_) wrench.link.addWrench(wrench.wrench.force, wrench.wrench.torque);
  }

  void reset() override { wrenches_ = initial_; }

 private:
  struct LinkWrench {
    Link link;
    Wrench wrench;
  };

  void addWrench(const Element& element) {
    const std::string name = requiredText(element, "entity_name");
    const std::string type = requiredText(element, "entity_type");
    if (type != "link" && type != "model") {
      refuse(*element.child("entity_type"), "<entity_type> '" + type + "' is neither 'link' nor 'model'");
    }
    const std::optional<Link> link = find(name, type == "model");
    if (!link) refuse(*element.child("entity_name"), "there is no " + type + " '" + name + "'");
    const Wrench wrench{element.get("force", Vector3(0, 0, 0)), element.get("torque", Vector3(0, 0, 0))};
    if (!wrench.force.allFinite() || !wrench.torque.allFinite()) refuse(element, "a wrench must be finite");
    wrenches_.push_back({*link, wrench});
  }

  /// @return The link of that name, or the canonical link of the model of that name.
  std::optional<Link> find(const std::string& name, bool isModel) const {
    if (!isModel) return linkNamed(*world_, name);
    const std::optional<Model> model = world_->model(name);
    return model ? model->canonicalLink() : std::nullopt;
  }

  /// Ends all wrenches on the link or the model.
  void clear(const ignition::msgs::Entity& entity) {
    const auto isMeant = [&](const LinkWrench& wrench) {
      if (entity.id() != 0)
        return wrench.link.id().value == entity.id() || wrench.link.model().id().value == entity.id();
      const std::optional<Link> link = find(entity.name(), entity.type() == ignition::msgs::Entity::MODEL);
      return link && link->id() == wrench.link.id();
    };
    if (std::erase_if(wrenches_, isMeant) == 0) log_->warning("there is no wrench to clear on '" + entity.name() + "'");
  }

  World* world_ = nullptr;
  const Logger* log_ = nullptr;
  std::vector<LinkWrench> initial_;
  std::vector<LinkWrench> wrenches_;
  Subscription clear_;
};

}  // namespace

}  // namespace pongsim

PONGSIM_EXPORT_SYSTEM(pongsim::ApplyLinkWrench, "ignition::gazebo::systems::ApplyLinkWrench",
                      "gz::sim::systems::ApplyLinkWrench");
