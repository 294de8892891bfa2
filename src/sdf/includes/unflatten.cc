#include "sdf/includes/unflatten.hh"

#include <algorithm>
#include <array>
#include <cstddef>
#include <string>
#include <string_view>
#include <unordered_map>
#include <utility>
#include <vector>

#include "base/element_edit.hh"
#include "sdf/includes/includes.hh"
#include "sdf/text/names.hh"

namespace pongsim::sdf {

namespace {

/// @return Name of the included model that the part came from; empty if it belongs to this model.
std::string_view innerModel(const Element& part) {
  constexpr std::array<std::string_view, 5> kKinds{"model", "link", "joint", "frame", "gripper"};
  if (std::ranges::find(kKinds, part.name) == kKinds.end()) return {};
  const Element::Attribute* name = part.attribute("name");
  if (name == nullptr) return {};
  const std::string_view text = name->value;
  const std::size_t end = text.find(kNameSeparator);
  return end == std::string_view::npos ? std::string_view() : text.substr(0, end);
}

/// @return Whether the name has too many nested models.
bool isTooDeep(std::string_view name) {
  int depth = 0;
  for (std::size_t at = name.find(kNameSeparator); at != name.npos; at = name.find(kNameSeparator, at + 2)) ++depth;
  return depth > Includes::kDeepestModel;
}

/// Removes the model's name from the names in a part that becomes part of that model.
class PrefixRemover {
 public:
  explicit PrefixRemover(std::string_view model) : prefix_(std::string(model) + std::string(kNameSeparator)) {}

  void removeFrom(Element& part) const {
    constexpr std::array<std::string_view, 4> kAttributes{"name", "attached_to", "canonical_link", "placement_frame"};
    for (const std::string_view name : kAttributes) removeFromAttribute(part, name);
    for (Element& child : part.children) removeFromInside(child);
  }

 private:
  void removeFromInside(Element& element) const {
    constexpr std::array<std::string_view, 4> kTexts{"parent", "child", "gripper_link", "palm_link"};
    if (element.name == "plugin") return;
    if (std::ranges::find(kTexts, element.name) != kTexts.end()) remove(element.text);
    if (element.name == "pose") removeFromAttribute(element, "relative_to");
    if (element.name == "xyz") removeFromAttribute(element, "expressed_in");
    for (Element& child : element.children) removeFromInside(child);
  }

  void removeFromAttribute(Element& element, std::string_view name) const {
    if (Element::Attribute* attribute = base::attributeOf(element, name)) remove(attribute->value);
  }

  void remove(std::string& text) const {
    if (text.starts_with(prefix_)) text.erase(0, prefix_.size());
  }

  std::string prefix_;
};

/// Moves pose and attachment from the frame "__model__" to the model.
void takeModelFrame(Element& frame, Element& model) {
  if (const Element::Attribute* link = frame.attribute("attached_to")) {
    model.attributes.push_back({"canonical_link", link->value, link->position});
  }
  for (Element& child : frame.children) {
    if (child.name == "pose") model.children.insert(model.children.begin(), std::move(child));
  }
}

bool isModelFrame(const Element& element) {
  return element.name == "frame" && element.attributeOr("name", "") == kModelFrame;
}

void unflatten(Element& model, Context& context) {
  std::vector<Element> inner;
  std::unordered_map<std::string, std::size_t> indexOfName;
  for (Element& part : model.children) {
    const std::string name(innerModel(part));
    if (name.empty()) continue;
    if (isTooDeep(part.attribute("name")->value)) {
      context.diagnostics.error(part.position, "models nest more than " + std::to_string(Includes::kDeepestModel) +
                                                   " deep in the name of a " + part.name);
      continue;
    }
    const auto [found, isNew] = indexOfName.try_emplace(name, inner.size());
    if (isNew) {
      Element& added = inner.emplace_back(base::makeElement("model", part.position));
      base::setAttribute(added, "name", name, part.attribute("name")->position);
    }
    PrefixRemover(name).removeFrom(part);
    Element& target = inner[found->second];
    if (isModelFrame(part)) {
      takeModelFrame(part, target);
    } else {
      target.children.push_back(std::move(part));
    }
    // mark it as moved; erased below
    part.name.clear();
  }
  std::erase_if(model.children, [](const Element& part) { return part.name.empty(); });
  std::ranges::move(inner, std::back_inserter(model.children));
  unflattenAll(model, context);
}

}  // namespace

void unflattenAll(Element& root, Context& context) {
  for (Element& child : root.children) {
    if (child.name == "model") unflatten(child, context);
    if (child.name == "world") unflattenAll(child, context);
  }
}

}  // namespace pongsim::sdf
