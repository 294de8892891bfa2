#include "sdf/schema/schema.hh"

#include <algorithm>

namespace pongsim::sdf {

Schema::Schema() {
  addRows();
  std::ranges::sort(shared_, {}, &Part::name);
  for (Part& part : shared_) resolve(part);
  for (ElementType& type : types_) {
    std::ranges::sort(type.attributes, {}, &Part::name);
    std::ranges::sort(type.children, {}, &Part::name);
    for (Part& part : type.attributes) resolve(part);
    for (Part& part : type.children) resolve(part);
  }
}

void Schema::addRows() {
  for (const SchemaRow& row : schemaTable()) {
    const std::size_t mark = row.path.find_last_of(".@");
    if (mark == std::string_view::npos) {
      shared_.push_back({row.path, row});
      continue;
    }
    ElementType& parent = typeAt(row.path.substr(0, mark));
    (row.path[mark] == '@' ? parent.attributes : parent.children).push_back({row.path.substr(mark + 1), row});
  }
}

void Schema::resolve(Part& part) {
  std::string_view path = part.row.path;
  if (part.row.type.starts_with('+')) {
    path = part.row.type.substr(1);
    const SchemaRow& meant = shared(path)->row;
    part.row.type = meant.type;
    part.row.fallback = meant.fallback;
    if (part.row.description.empty()) part.row.description = meant.description;
  }
  part.type = typeOf(path);
  if (part.type == nullptr) return;
  part.isFreeForm = std::ranges::find(part.type->children, "*", &Part::name) != part.type->children.end();
}

Schema::ElementType& Schema::typeAt(std::string_view path) {
  ElementType*& type = typeOfPath_[path];
  if (type == nullptr) type = &types_.emplace_back();
  return *type;
}

const Schema& Schema::instance() {
  static const Schema schema;
  return schema;
}

const Schema::Part* Schema::shared(std::string_view name) const { return find(shared_, name); }

const Schema::ElementType* Schema::typeOf(std::string_view path) const {
  const auto found = typeOfPath_.find(path);
  return found != typeOfPath_.end() ? found->second : nullptr;
}

const Schema::Part* Schema::find(std::span<const Part> parts, std::string_view name) {
  const auto found = std::ranges::lower_bound(parts, name, {}, &Part::name);
  return found != parts.end() && found->name == name ? &*found : nullptr;
}

}  // namespace pongsim::sdf
