#include "sdf/readers/worlds/levels_reader.hh"

#include <algorithm>
#include <array>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <utility>
#include <variant>
#include <vector>

#include "base/nearest_word.hh"
#include "description/geometry.hh"
#include "sdf/readers/shapes/geometry_reader.hh"
#include "sdf/text/values.hh"

namespace pongsim::sdf {

namespace {

/// @param holder "<level>"
void warnOfUnknown(const Element& element, const std::string& holder, std::span<const std::string_view> known,
                   Context& context) {
  for (const Element& child : element.children) {
    if (std::ranges::find(known, child.name) != known.end()) continue;
    context.diagnostics.warning(child.position, "<" + child.name + "> is unknown in " + holder,
                                base::didYouMean(child.name, known));
  }
}

class LevelsReader {
 public:
  LevelsReader(const description::World& world, Context& context) : context_(context) {
    for (const description::Model& model : world.models) movers_.push_back(model.name);
    for (const description::Actor& actor : world.actors) movers_.push_back(actor.name);
    all_ = movers_;
    for (const description::Light& light : world.lights) all_.push_back(light.name);
  }

  description::LevelPlan read(const Element& plugin) {
    constexpr std::array<std::string_view, 2> kKnown{"level", "performer"};
    warnOfUnknown(plugin, "the levels plugin", kKnown, context_);
    description::LevelPlan plan;
    plan.isGiven = true;
    for (const Element* element : plugin.childrenNamed("performer")) readPerformer(*element, plan);
    for (const Element* element : plugin.childrenNamed("level")) readLevel(*element, plan);
    warnOfMissing();
    return plan;
  }

 private:
  void warn(const SourcePosition& position, std::string text, std::string hint = {}) {
    context_.diagnostics.warning(position, std::move(text), std::move(hint));
  }

  /// @param label "level 'l'"
  /// @return Its side lengths; nothing, with a warning, if it has no box.
  std::optional<Vector3> readBox(const Element& element, const std::string& label) {
    const char* const hint = "write <geometry><box><size>X Y Z</size></box></geometry>";
    const Element* geometry = element.child("geometry");
    if (geometry == nullptr) {
      warn(element.position, label + " has no <geometry>: it is ignored", hint);
    } else if (geometry->child("box") == nullptr) {
      warn(geometry->position, label + " is not a box: it is ignored", hint);
    } else if (const auto shape = readGeometry(element, label, context_);
               std::holds_alternative<description::Box>(shape)) {
      return std::get<description::Box>(shape).size;
    } else {
      warn(geometry->position, label + " has several shapes: it is ignored", hint);
    }
    return std::nullopt;
  }

  void readPerformer(const Element& element, description::LevelPlan& plan) {
    constexpr std::array<std::string_view, 2> kKnown{"ref", "geometry"};
    warnOfUnknown(element, "<performer>", kKnown, context_);
    description::Performer performer;
    performer.name = element.attributeOr("name", "");
    performer.position = element.position;
    const std::string label = "performer '" + performer.name + "'";
    const Element* ref = element.child("ref");
    if (ref == nullptr || ref->text.empty()) {
      return warn(element.position, label + " has no <ref>: it is ignored", "write <ref>MODEL</ref>");
    }
    performer.ref = ref->text;
    if (std::ranges::find(movers_, performer.ref) == movers_.end()) {
      return warn(ref->position,
                  label + " names '" + performer.ref + "', which is not a model or actor of the world: it is ignored",
                  base::didYouMean(performer.ref, movers_));
    }
    const auto other = std::ranges::find(plan.performers, performer.ref, &description::Performer::ref);
    if (other != plan.performers.end()) {
      return warn(ref->position, label + " is left out: '" + performer.ref + "' is already performer '" + other->name +
                                     "' in line " + std::to_string(other->position.line));
    }
    const std::optional<Vector3> size = readBox(element, label);
    if (!size) return;
    performer.size = *size;
    plan.performers.push_back(std::move(performer));
  }

  void readLevel(const Element& element, description::LevelPlan& plan) {
    constexpr std::array<std::string_view, 4> kKnown{"pose", "geometry", "buffer", "ref"};
    warnOfUnknown(element, "<level>", kKnown, context_);
    description::Level level;
    level.name = element.attributeOr("name", "");
    level.position = element.position;
    const std::string label = "level '" + level.name + "'";
    checkName(level, plan);
    const std::optional<Vector3> size = readBox(element, label);
    if (!size) return;
    level.size = *size;
    const PoseText pose = readPose(element, context_);
    level.center = pose.value.position;
    if (pose.value.rotation.vec().norm() > 5e-10) {
      warn(pose.position,
           "the box of " + label + " is not rotated: it is aligned with the axes of the world, as in Fortress");
    }
    if (!pose.relativeTo.empty() && pose.relativeTo != "world") {
      warn(pose.position,
           "the pose of " + label + " is in the world frame, as in Fortress: 'relative_to' has no effect");
    }
    level.buffer = readNumber(element, "buffer", 0, context_);
    if (level.buffer < 0) {
      warn(element.child("buffer")->position, "the <buffer> of " + label + " is negative: 0 is used",
           "the level is unloaded when the performer is this many metres outside it");
      level.buffer = 0;
    }
    readMembers(element, label, plan, level);
    plan.levels.push_back(std::move(level));
  }

  void checkName(const description::Level& level, const description::LevelPlan& plan) {
    if (level.name.empty()) return warn(level.position, "a level has no name", "write <level name=\"...\">");
    const auto other = std::ranges::find(plan.levels, level.name, &description::Level::name);
    if (other == plan.levels.end()) return;
    warn(level.position, "there is a level '" + level.name + "' in line " + std::to_string(other->position.line) +
                             " already: messages can't distinguish them");
  }

  void readMembers(const Element& element, const std::string& label, const description::LevelPlan& plan,
                   description::Level& level) {
    for (const Element* ref : element.childrenNamed("ref")) {
      if (std::ranges::find(all_, ref->text) == all_.end()) {
        if (missing_++ == 0) {
          firstMissing_ = {ref->position,
                           label + " names '" + ref->text + "', which is not a model, light or actor of the world",
                           ref->text.empty() ? "write <ref>MODEL</ref>" : base::didYouMean(ref->text, all_)};
        }
        continue;
      }
      if (std::ranges::find(plan.performers, ref->text, &description::Performer::ref) != plan.performers.end()) {
        warn(ref->position, label + " names '" + ref->text + "', which is a performer: performers are always loaded");
        continue;
      }
      if (std::ranges::find(level.members, ref->text, &description::Level::Member::name) != level.members.end()) {
        warn(ref->position, label + " names '" + ref->text + "' twice");
        continue;
      }
      level.members.push_back({ref->text, ref->position});
    }
    if (element.child("ref") == nullptr) warn(level.position, label + " is empty", "write <ref>MODEL</ref>");
  }

  /// Where an include is missing, so are the members of all levels: one warning stands for them.
  void warnOfMissing() {
    if (missing_ == 0) return;
    const std::size_t others = missing_ - 1;
    std::string more;
    if (others == 1) more = " (nor is another name of the levels)";
    if (others > 1) more = " (nor are " + std::to_string(others) + " other names of the levels)";
    warn(firstMissing_.position, firstMissing_.text + more, firstMissing_.hint);
  }

  struct Missing {
    SourcePosition position;
    std::string text, hint;
  };

  Context& context_;
  /// Members of levels that are not in the world, and the first of them.
  std::size_t missing_ = 0;
  Missing firstMissing_;
  /// Names of the entities that can be performers, and of those that can be in a level.
  std::vector<std::string_view> movers_;
  std::vector<std::string_view> all_;
};

}  // namespace

description::LevelPlan readLevels(const description::World& world, Context& context) {
  const description::Plugin* plan = nullptr;
  for (const description::Plugin& plugin : world.plugins) {
    if (!description::isLevelPlan(plugin.className)) continue;
    if (plan == nullptr) {
      plan = &plugin;
      continue;
    }
    context.diagnostics.warning(plugin.sdf.position,
                                "the levels and performers of this plugin are ignored: those of "
                                "line " +
                                    std::to_string(plan->sdf.position.line) + " are used");
  }
  return plan == nullptr ? description::LevelPlan() : LevelsReader(world, context).read(plan->sdf);
}

}  // namespace pongsim::sdf
