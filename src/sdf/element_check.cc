#include "sdf/element_check.hh"

#include <span>
#include <string>
#include <vector>

#include "base/nearest_word.hh"
#include "sdf/schema.hh"

namespace pongsim::sdf {

namespace {

std::string hintFor(std::string_view name, std::span<const Schema::Part> parts) {
  std::vector<std::string_view> known;
  for (const Schema::Part& part : parts) {
    if (part.row.removedIn == 0 && part.name != "*") known.push_back(part.name);
  }
  return base::didYouMean(name, known);
}

/// @param label "<axiss>" or "attribute 'nam'"
/// @return The part, or null, and a warning given, where this version of the format does not have it.
const Schema::Part* knownPart(std::string_view name, std::span<const Schema::Part> parts, const std::string& label,
                              const Element& holder, const SourcePosition& position, Context& context) {
  const Schema::Part* part = Schema::find(parts, name);
  const bool isGone = part != nullptr && part->row.removedIn != 0 && context.version >= part->row.removedIn;
  if ((part == nullptr || isGone) && context.firstTime("unknown " + label)) {
    const std::string ending = " in <" + holder.name + ">";
    if (isGone) {
      context.diagnostics.warning(position, label + " is not used any more" + ending,
                                  "SDF 1." + std::to_string(part->row.removedIn) + " took it out of the format");
    } else {
      context.diagnostics.warning(position, label + " is not known" + ending, hintFor(name, parts));
    }
  }
  return isGone ? nullptr : part;
}

void check(const Element& element, const Schema::ElementType* type, Context& context) {
  static const Schema::ElementType kNothing;
  if (type == nullptr) type = &kNothing;
  for (const Element::Attribute& attribute : element.attributes) {
    if (attribute.name.find(':') != std::string::npos) continue;
    knownPart(attribute.name, type->attributes, "attribute '" + attribute.name + "'", element, attribute.position,
              context);
  }
  for (const Element& child : element.children) {
    if (child.name.find(':') != std::string::npos) continue;
    const Schema::Part* part =
        knownPart(child.name, type->children, "<" + child.name + ">", element, child.position, context);
    if (part != nullptr && !part->isFreeForm) check(child, part->type, context);
  }
}

}  // namespace

void checkElements(const Element& root, Context& context) { check(root, Schema::instance().root().type, context); }

}  // namespace pongsim::sdf
