#include "sdf/schema/element_check.hh"

#include <optional>
#include <span>
#include <string>
#include <vector>

#include "base/nearest_word.hh"
#include "sdf/schema/schema.hh"
#include "sdf/schema/value_check.hh"

namespace pongsim::sdf {

namespace {

std::string hintFor(std::string_view name, std::span<const Schema::Part> parts) {
  std::vector<std::string_view> known;
  for (const Schema::Part& part : parts) {
    if (part.row.removedIn == 0 && part.name != "*") known.push_back(part.name);
  }
  return base::didYouMean(name, known);
}

/// The name of an element or attribute in messages.
struct Label {
  const std::string& name;
  bool isAttribute;

  /// @return "<axiss>" or "attribute 'nam'"
  std::string text() const { return isAttribute ? "attribute '" + name + "'" : "<" + name + ">"; }
};

/// @return The part; null, with a warning, if this version of the format does not have it.
const Schema::Part* knownPart(const Label& which, std::span<const Schema::Part> parts, const Element& holder,
                              const SourcePosition& position, Context& context) {
  const std::string& name = which.name;
  const Schema::Part* part = Schema::find(parts, name);
  const bool isGone = part != nullptr && part->row.isGoneIn(context.version);
  if (part != nullptr && !isGone) return part;
  const std::string label = which.text();
  if (context.firstTime("unknown " + label)) {
    const std::string ending = " in <" + holder.name + ">";
    if (isGone) {
      context.diagnostics.warning(position, label + " is obsolete" + ending,
                                  "SDF 1." + std::to_string(part->row.removedIn) + " removed it");
    } else {
      context.diagnostics.warning(position, label + " is unknown" + ending, hintFor(name, parts));
    }
  }
  return nullptr;
}

void checkType(std::string_view type, const std::string& text, const Label& label, const SourcePosition& position,
               Context& context) {
  const std::optional<WrongValue> wrong = checkValue(type, text);
  if (!wrong) return;
  const bool isError = wrong->severity == Severity::kError;
  context.diagnostics.add({wrong->severity, position,
                           label.text() + " is '" + quoted(text) + "', which is not " + std::string(wrong->expected),
                           isError ? "" : "Fortress reads as much of it as it can"});
}

void checkRequired(const Element& element, const Schema::ElementType& type, Context& context) {
  for (const Schema::Part& part : type.attributes) {
    if (part.row.presence.in(context.version) != '1' || part.row.removedIn != 0 ||
        element.attribute(part.name) != nullptr)
      continue;
    const std::string name(part.name);
    context.diagnostics.error(element.position, "<" + element.name + "> has no " + name,
                              "write <" + element.name + " " + name + "=\"...\">");
  }
}

/// @return Whether an element is a custom sensor's own, which its system reads.
bool isOfCustomSensor(const Element& child, const Element& parent, std::span<const Schema::Part> known) {
  return parent.name == "sensor" && parent.attributeOr("type", "") == "custom" &&
         Schema::find(known, child.name) == nullptr;
}

/// @param isPassed Whether no reader handles the element: then its values are checked here.
/// @param isActorLink Whether it is an actor's link, of which only the pose and the visuals are read.
void check(const Element& element, const Schema::ElementType* type, bool isPassed, bool isActorLink, Context& context) {
  static const Schema::ElementType kNothing;
  if (type == nullptr) type = &kNothing;
  if (isPassed) checkRequired(element, *type, context);
  for (const Element::Attribute& attribute : element.attributes) {
    if (attribute.name.find(':') != std::string::npos) continue;
    const Label label{attribute.name, true};
    const Schema::Part* part = knownPart(label, type->attributes, element, attribute.position, context);
    if (part == nullptr || (!isPassed && part->row.use == Use::kRead)) continue;
    checkType(part->row.type, attribute.value, label, attribute.position, context);
  }
  for (const Element& child : element.children) {
    if (child.name.find(':') != std::string::npos) continue;
    if (isOfCustomSensor(child, element, type->children)) continue;
    if (element.name == "sdf" && child.name == "include") {
      // which libsdformat reads there, but does not describe
      check(child, Schema::instance().typeOf("world.include"), isPassed, false, context);
      continue;
    }
    const Label label{child.name, false};
    const Schema::Part* part = knownPart(label, type->children, element, child.position, context);
    if (part == nullptr) continue;
    const bool isUnread = isActorLink && child.name != "pose" && child.name != "visual";
    const bool isChildPassed = isPassed || isUnread || part->row.use != Use::kRead;
    if (isChildPassed) checkType(part->row.type, child.text, label, child.position, context);
    if (!part->isFreeForm) {
      check(child, part->type, isChildPassed, element.name == "actor" && child.name == "link", context);
    } else if (isChildPassed) {
      checkRequired(child, *part->type, context);
    }
  }
}

}  // namespace

void checkElements(const Element& root, Context& context) {
  check(root, Schema::instance().root().type, false, false, context);
}

}  // namespace pongsim::sdf
