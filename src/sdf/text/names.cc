#include "sdf/text/names.hh"

namespace pongsim::sdf {

std::string readName(const Element& element, std::string_view owner, Context& context) {
  const std::string ending = owner.empty() ? "" : " in " + std::string(owner);
  const Element::Attribute* attribute = element.attribute("name");
  if (attribute == nullptr || attribute->value.empty()) {
    context.diagnostics.error(element.position, "<" + element.name + ">" + ending + " has no name",
                              "write <" + element.name + " name=\"...\">");
    return {};
  }
  const std::string& name = attribute->value;
  const bool isReserved = name == "world" || (name.size() >= 4 && name.starts_with("__") && name.ends_with("__"));
  if (isReserved && element.name != "world") {
    context.diagnostics.error(attribute->position, element.name + " can't be named '" + name + "'" + ending,
                              "'world' and names like __model__ are reserved");
    return {};
  }
  // Older files can use "::" like any other text, and at world level it has no other meaning.
  if (context.version >= 8 && name.find("::") != std::string::npos) {
    if (context.isInWorld) {
      context.diagnostics.warning(attribute->position, element.name + " is named '" + name + "'" + ending,
                                  "from SDF 1.8, Fortress refuses '::' in names");
      return name;
    }
    context.diagnostics.error(attribute->position, element.name + " can't be named '" + name + "'" + ending,
                              "'::' separates the name of a model from that of a part");
    return {};
  }
  return name;
}

std::string partLabel(const Element& element, const std::string& name, const std::string& owner) {
  return (name.empty() ? "a " + element.name : element.name + " '" + name + "'") + " of " + owner;
}

void SiblingNames::claim(const std::string& name, std::string_view group, std::string_view kind,
                         const SourcePosition& position, Context& context) {
  if (name.empty()) return;
  const auto [found, isNew] = holders_.try_emplace({std::string(group), name}, Holder{std::string(kind), position});
  if (isNew) return;
  const Holder& holder = found->second;
  const bool isSameKind = holder.kind == kind;
  const std::string message = std::string(kind) + " '" + name + "' has the same name as " +
                              (isSameKind ? "another " : "a ") + holder.kind + " of " + owner_;
  const bool isSameFile = holder.position.file == position.file;
  const std::string hint = "the first one is in " + (isSameFile ? "" : *holder.position.file + ", ") + "line " +
                           std::to_string(holder.position.line);
  context.diagnostics.error(position, message, hint);
}

}  // namespace pongsim::sdf
