#include <ignition/msgs/light.pb.h>
#include <ignition/msgs/scene.pb.h>
#include <ignition/msgs/stringmsg.pb.h>

#include <algorithm>
#include <array>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "blinking.hh"
#include "pongsim/parameters.hh"
#include "pongsim/physical_properties.hh"
#include "pongsim/scene.hh"
#include "pongsim/system.hh"

namespace pongsim {

namespace {

/// Lets lights and visuals blink in modes.
class LedPlugin : public System {
 public:
  void declare(Declaration& declaration) override {
    declaration.is("Lets LEDs, which are lights and visuals, blink in modes, which commands choose.",
                   Declaration::Place::kModel);
    declaration.parameter("led_group_name", &group_, "", "part of the topic").otherwise("led_M");
    declaration
        .element("led",
                 "an LED, with the attribute `name`: `light_name`, `visual_name` or both (such as model::link::light, "
                 "or its end) and the `color` and `intensity` of its `default_state` (1 1 1 1 and 0); may be repeated")
        .required();
    declaration
        .element(
            "mode",
            "a mode, with the attribute `name`: `step`s, which repeat, each with `color` (1 1 1 1), `intensity` (1) "
            "and `on_time` (1 s) or the attribute `always_on`; `active_leds` names its `led`s (default: all); may be "
            "repeated")
        .required();
    declaration.parameter("startup_mode", &startupMode_, "", "first mode").otherwise("that of the file's first");
    declaration.subscribes("/model/M/GROUP/change_led_mode", "ignition.msgs.StringMsg",
                           "name of a mode, in small or capital letters; `off` or `reset`: the default states");
    declaration.publishes("/world/W/light_config", "ignition.msgs.Light", "changes of the lights");
    declaration.sharesTopics();
  }

  void configure(const SystemContext& context) override {
    world_ = &context.world;
    log_ = &context.log;
    modes_ = ledModesIn(context.sdf, context.diagnostics);
    if (modes_.empty()) refuse(context.sdf, "none of the <mode>s can be used");
    findLeds(context);
    warnOfLeds(context);
    const std::optional<std::uint64_t> first = modeNamed(startupMode_);
    if (!first && !startupMode_.empty()) {
      context.diagnostics.warning(
          context.sdf.child("startup_mode")->position,
          "<startup_mode> '" + startupMode_ + "' is not a mode: '" + modes_[0].name + "' is used");
    }
    startup_ = first.value_or(0);
    blinking_.begin(startup_);

    std::string topic = "/" + (group_.empty() ? "led_" + std::string(context.model->name()) : group_);
    for (std::optional<Model> model = context.model; model; model = model->parent()) {
      topic = "/model/" + std::string(model->name()) + topic;
    }
    commands_ = context.node.subscribe<ignition::msgs::StringMsg>(
        cleanTopic(topic + "/change_led_mode"), [this](const auto& message) { receive(message.data()); });
    changes_ = context.node.advertise<ignition::msgs::Light>(
        cleanTopic("/world/" + std::string(context.world.name()) + "/light_config"));
  }

  void preUpdate(const StepInfo& info) override {
    if (info.paused) return;
    const LedStep* step = blinking_.isOff() ? nullptr : &blinking_.step(modes_, info.time);
    for (Led& led : leds_) {
      // one that the mode leaves out keeps what it shows
      if (step == nullptr) {
        show(led, led.atRest);
      } else if (isActive(led)) {
        show(led, step->glow);
      } else if (!led.shown) {
        show(led, led.atRest);
      }
    }
  }

  void reset() override {
    blinking_ = {};
    blinking_.begin(startup_);
    for (Led& led : leds_) led.shown.reset();
  }

  void transfer(StateArchive& archive) override {
    blinking_.transfer(archive, modes_);
    for (Led& led : leds_) {
      archive(led.shown);
      if (archive.isGiving() && led.shown) paint(led);
    }
  }

 private:
  struct Led {
    std::string name;
    Glow atRest;
    /// As in the file, with its id; empty without a light.
    std::optional<ignition::msgs::Light> light;
    std::optional<VisualId> visual;
    std::optional<Glow> shown;
  };

  void findLeds(const SystemContext& context);
  void warnOfLeds(const SystemContext& context) const;

  std::optional<std::uint64_t> modeNamed(const std::string& name) const {
    const auto found = std::ranges::find(modes_, inSmallLetters(name), &LedMode::name);
    if (found == modes_.end()) return std::nullopt;
    return static_cast<std::uint64_t>(found - modes_.begin());
  }

  bool isActive(const Led& led) const {
    const std::vector<std::string>& active = modes_[blinking_.mode()].leds;
    return active.empty() || std::ranges::find(active, led.name) != active.end();
  }

  void show(Led& led, const Glow& glow) {
    if ((!led.light && !led.visual) || led.shown == glow) return;
    led.shown = glow;
    paint(led);
    if (!led.light) return;
    for (ignition::msgs::Color* color : {led.light->mutable_diffuse(), led.light->mutable_specular()}) {
      color->set_r(static_cast<float>(glow.color[0]));
      color->set_g(static_cast<float>(glow.color[1]));
      color->set_b(static_cast<float>(glow.color[2]));
      color->set_a(static_cast<float>(glow.color[3]));
    }
    led.light->set_intensity(static_cast<float>(glow.intensity));
    changes_.publish(*led.light);
  }

  /// A visual has the colour and emits it, whatever the intensity, as in Gazebo.
  void paint(const Led& led) {
    if (!led.visual) return;
    const std::array<double, 4>& color = led.shown->color;
    PhysicalProperties(*world_).setColor(*led.visual, {color[0], color[1], color[2]}, true);
  }

  void receive(const std::string& name) {
    const std::string wanted = inSmallLetters(name);
    if (wanted == "off" || wanted == "reset") return blinking_.switchOff();
    const std::optional<std::uint64_t> mode = modeNamed(wanted);
    if (!mode) return log_->warning("there is no mode '" + name + "' of LEDs");
    blinking_.begin(*mode);
    // those that the mode leaves out return to their default states
    for (Led& led : leds_) led.shown.reset();
  }

  std::string group_, startupMode_;
  std::vector<LedMode> modes_;
  std::vector<Led> leds_;
  std::uint64_t startup_ = 0;
  Blinking blinking_;
  World* world_ = nullptr;
  const Logger* log_ = nullptr;
  Subscription commands_;
  Publisher changes_;
};

/// @param parts Those of a link.
/// @return The first one with that scoped name, or with a name that ends so, in a model or the models in it.
template <class Part>
const Part* partIn(const ignition::msgs::Model& model, const std::string& prefix, const std::string& wanted,
                   const google::protobuf::RepeatedPtrField<Part>& (ignition::msgs::Link::*parts)() const) {
  const std::string name = prefix + model.name() + "::";
  for (const ignition::msgs::Link& link : model.link()) {
    for (const Part& part : (link.*parts)()) {
      // as in Gazebo, the name may begin anywhere in the tree
      if (("::" + name + link.name() + "::" + part.name()).ends_with("::" + wanted)) return &part;
    }
  }
  for (const ignition::msgs::Model& inner : model.model()) {
    if (const Part* part = partIn(inner, name, wanted, parts)) return part;
  }
  return nullptr;
}

template <class Part>
const Part* partIn(const ignition::msgs::Scene& scene, const std::string& wanted,
                   const google::protobuf::RepeatedPtrField<Part>& (ignition::msgs::Link::*parts)() const) {
  for (const ignition::msgs::Model& model : scene.model()) {
    if (const Part* part = partIn(model, "", wanted, parts)) return part;
  }
  return nullptr;
}

void LedPlugin::findLeds(const SystemContext& context) {
  ignition::msgs::Scene scene;
  Scene(context.world).fillIn(scene);
  for (const Element* element : context.sdf.childrenNamed("led")) {
    Led led{
        .name = element->attributeOr("name", ""), .atRest = {.intensity = 0}, .light = {}, .visual = {}, .shown = {}};
    if (const Element* rest = element->child("default_state")) led.atRest = glowIn(*rest, led.atRest);
    if (const Element* name = element->child("light_name")) {
      if (const ignition::msgs::Light* light = partIn(scene, name->text, &ignition::msgs::Link::light)) {
        led.light = *light;
      }
      for (const ignition::msgs::Light& light : scene.light()) {
        if (light.name() == name->text) led.light = light;
      }
      if (!led.light) {
        context.diagnostics.warning(name->position, "<light_name> '" + name->text + "' is not a light in the world");
      }
    }
    if (const Element* name = element->child("visual_name")) {
      if (const ignition::msgs::Visual* visual = partIn(scene, name->text, &ignition::msgs::Link::visual)) {
        led.visual = VisualId{visual->id()};
      } else {
        context.diagnostics.warning(name->position, "<visual_name> '" + name->text + "' is not a visual in the world");
      }
    }
    leds_.push_back(std::move(led));
  }
}

void LedPlugin::warnOfLeds(const SystemContext& context) const {
  for (const LedMode& mode : modes_) {
    for (const std::string& name : mode.leds) {
      if (std::ranges::find(leds_, name, &Led::name) != leds_.end()) continue;
      context.diagnostics.warning(context.sdf.position,
                                  "mode '" + mode.name + "' names '" + name + "', which is no <led>");
    }
  }
}

}  // namespace

}  // namespace pongsim

PONGSIM_EXPORT_SYSTEM(pongsim::LedPlugin, "gz::sim::systems::LedPlugin", "ignition::gazebo::systems::LedPlugin");
