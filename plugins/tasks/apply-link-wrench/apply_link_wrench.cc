#include <ignition/msgs/entity.pb.h>
#include <ignition/msgs/entity_wrench.pb.h>

#include <algorithm>
#include <optional>
#include <string>
#include <vector>

#include "pongsim/commands.hh"
#include "pongsim/parameters.hh"
#include "pongsim/system.hh"

namespace pongsim {

namespace {

/// @return The link named by "model::link".
std::optional<Link> linkNamed(const World& world, const std::string& name) {
  const std::size_t separator = name.rfind("::");
  if (separator == std::string::npos) return std::nullopt;
  const std::optional<Model> model = world.model(name.substr(0, separator));
  return model ? model->link(name.substr(separator + 2)) : std::nullopt;
}

/// Applies wrenches to links, persistent ones in every step.
class ApplyLinkWrench : public System {
 public:
  void declare(Declaration& declaration) override {
    declaration.is("Applies wrenches to links.", Declaration::Place::kWorld);
    declaration.element("persistent",
                        "a wrench in each step: `<entity_name>` (as model::link), `<entity_type>` (link, or model for "
                        "its canonical link), `<force>` [N] and `<torque>` [N m] in the world frame");
    declaration.parameter("topic", &topic_, "", "wrenches for one step").otherwise("/world/W/wrench");
    declaration.parameter("topic_persistent", &persistentTopic_, "", "persistent wrenches")
        .otherwise("/world/W/wrench/persistent");
    declaration.parameter("topic_clear", &clearTopic_, "", "removes persistent wrenches")
        .otherwise("/world/W/wrench/clear");
    declaration.parameter("verbose", &verbose_, "", "logs what is applied and cleared (`-v 3`)");
    declaration.subscribes("<topic>", "ignition.msgs.EntityWrench", "a wrench for one step");
    declaration.subscribes("<topic_persistent>", "ignition.msgs.EntityWrench", "a persistent wrench");
    declaration.subscribes("<topic_clear>", "ignition.msgs.Entity", "clears the wrenches on a link or model");
  }

  void configure(const SystemContext& context) override {
    world_ = &context.world;
    log_ = &context.log;
    for (const Element* element : context.sdf.childrenNamed("persistent")) addWrench(*element);
    initial_ = wrenches_;
    const std::string topic = "/world/" + std::string(world_->name()) + "/wrench";
    once_ = context.node.subscribe<ignition::msgs::EntityWrench>(
        topicOr(topic_, topic), [this](const auto& message) { receive(message, onceWrenches_); }, kForces);
    persistent_ = context.node.subscribe<ignition::msgs::EntityWrench>(
        topicOr(persistentTopic_, topic + "/persistent"), [this](const auto& message) { receive(message, wrenches_); },
        kForces);
    clear_ = context.node.subscribe<ignition::msgs::Entity>(topicOr(clearTopic_, topic + "/clear"),
                                                            [this](const auto& entity) { clear(entity); });
  }

  void preUpdate(const StepInfo& info) override {
    if (info.paused) return;
    apply(wrenches_);
    apply(onceWrenches_);
    onceWrenches_.clear();
  }

  void reset() override {
    wrenches_ = initial_;
    onceWrenches_.clear();
  }

  void transfer(StateArchive& archive) override {
    archive(wrenches_);
    archive(onceWrenches_);
  }

 private:
  struct LinkWrench {
    LinkId link;
    Wrench wrench;

    void transfer(StateArchive& archive) {
      archive(link.value);
      archive(wrench.force);
      archive(wrench.torque);
    }
  };

  void apply(const std::vector<LinkWrench>& wrenches) {
    for (const auto& [id, wrench] : wrenches) {
      if (std::optional<Link> link = world_->link(id)) link->addWrench(wrench.force, wrench.torque);
    }
  }

  void addWrench(const Element& element) {
    const std::string name = requiredText(element, "entity_name");
    const std::string type = requiredText(element, "entity_type");
    if (type != "link" && type != "model") {
      refuse(*element.child("entity_type"), "<entity_type> '" + type + "' is neither 'link' nor 'model'");
    }
    const std::optional<Link> link = find(name, type == "model");
    if (!link) refuse(*element.child("entity_name"), "there is no " + type + " '" + name + "'");
    const Wrench wrench{element.get("force", Vector3(0, 0, 0)), element.get("torque", Vector3(0, 0, 0))};
    for (const char* part : {"force", "torque"}) {
      const Vector3 value = element.get(part, Vector3(0, 0, 0));
      if (value.cwiseAbs().maxCoeff() <= kLargestForce && value.allFinite()) continue;
      refuse(*element.child(part), "<" + std::string(part) + "> of a wrench must be finite and from -1e8 to 1e8");
    }
    wrenches_.push_back({link->id(), wrench});
  }

  /// @return The link of that name, or the canonical link of the model of that name.
  std::optional<Link> find(const std::string& name, bool isModel) const {
    if (!isModel) return linkNamed(*world_, name);
    const std::optional<Model> model = world_->model(name);
    return model ? model->canonicalLink() : std::nullopt;
  }

  /// @return The link that a message names, or the canonical link of the model that it names.
  std::optional<Link> find(const ignition::msgs::Entity& entity) const {
    if (entity.id() == 0) return find(entity.name(), entity.type() == ignition::msgs::Entity::MODEL);
    std::vector<Model> models = world_->models();
    for (std::size_t i = 0; i < models.size(); ++i) {
      // a copy, because the list grows
      const Model model = models[i];
      if (model.id().value == entity.id()) return model.canonicalLink();
      for (const Link& link : model.links()) {
        if (link.id().value == entity.id()) return link;
      }
      for (const Model& inner : model.models()) models.push_back(inner);
    }
    return std::nullopt;
  }

  /// Adds the wrench of a message to `wrenches`.
  void receive(const ignition::msgs::EntityWrench& message, std::vector<LinkWrench>& wrenches) {
    const std::string name =
        message.entity().id() != 0 ? std::to_string(message.entity().id()) : "'" + message.entity().name() + "'";
    const std::optional<Link> link = find(message.entity());
    if (!link) return log_->warning("there is no link or model " + name + " to apply a wrench to");
    const auto vector = [](const ignition::msgs::Vector3d& v) { return Vector3(v.x(), v.y(), v.z()); };
    const Wrench wrench{vector(message.wrench().force()), vector(message.wrench().torque())};
    if (message.wrench().has_force_offset() && !vector(message.wrench().force_offset()).isZero()) {
      log_->warning("a force offset is ignored, as in Fortress: the force acts at the link's origin");
    }
    if (verbose_) log_->info("a wrench acts on " + link->scopedName());
    wrenches.push_back({link->id(), wrench});
  }

  /// Clears all wrenches on the link or the model.
  void clear(const ignition::msgs::Entity& entity) {
    const std::optional<Link> link = find(entity);
    const auto isMeant = [&](const LinkWrench& wrench) { return link && link->id() == wrench.link; };
    const std::size_t count = std::erase_if(wrenches_, isMeant);
    if (count == 0) return log_->warning("there is no wrench to clear on '" + entity.name() + "'");
    if (verbose_) log_->info(std::to_string(count) + " wrenches on " + link->scopedName() + " are cleared");
  }

  std::string topic_, persistentTopic_, clearTopic_;
  bool verbose_ = true;
  World* world_ = nullptr;
  const Logger* log_ = nullptr;
  std::vector<LinkWrench> initial_;
  std::vector<LinkWrench> wrenches_;
  /// For the next step only.
  std::vector<LinkWrench> onceWrenches_;
  Subscription once_;
  Subscription persistent_;
  Subscription clear_;
};

}  // namespace

}  // namespace pongsim

PONGSIM_EXPORT_SYSTEM(pongsim::ApplyLinkWrench, "ignition::gazebo::systems::ApplyLinkWrench",
                      "gz::sim::systems::ApplyLinkWrench");
