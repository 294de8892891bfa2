#include "sdf/schema.hh"

#include <algorithm>
#include <charconv>
#include <string>

namespace pongsim::sdf {

namespace {

/// Calls `take` with each word of `text`.
template <class Take>
void forEachWord(std::string_view text, Take take) {
  while (!text.empty()) {
    const std::size_t end = std::min(text.find(' '), text.size());
    take(text.substr(0, end));
    text.remove_prefix(std::min(end + 1, text.size()));
  }
}

/// Splits "name<7".
Schema::Part partFrom(std::string_view word) {
  Schema::Part part;
  const std::size_t mark = std::min(word.find('<'), word.size());
  part.name = word.substr(0, mark);
  if (mark < word.size()) std::from_chars(word.data() + mark + 1, word.data() + word.size(), part.removedIn);
  return part;
}

}  // namespace

Schema::Schema() {
  const std::span<const SchemaRow> rows = schemaRows();
  types_.resize(rows.size());
  for (std::size_t i = 0; i < rows.size(); ++i) typeOfPath_[rows[i].path] = &types_[i];

  for (std::size_t i = 0; i < rows.size(); ++i) {
    forEachWord(rows[i].attributes, [&](std::string_view word) { types_[i].attributes.push_back(partFrom(word)); });
    forEachWord(rows[i].children, [&](std::string_view word) {
      const bool isShared = word.starts_with('+');
      const bool isFreeForm = word.starts_with('*');
      if (isShared || isFreeForm) word.remove_prefix(1);
      Part part = partFrom(word);
      part.isFreeForm = isFreeForm;
      part.type = shared(isShared ? std::string(part.name) : std::string(rows[i].path) + "." + std::string(part.name));
      types_[i].children.push_back(part);
    });
    std::ranges::sort(types_[i].attributes, {}, &Part::name);
    std::ranges::sort(types_[i].children, {}, &Part::name);
  }
}

const Schema& Schema::instance() {
  static const Schema schema;
  return schema;
}

const Schema::ElementType* Schema::shared(std::string_view name) const {
  const auto found = typeOfPath_.find(name);
  return found != typeOfPath_.end() ? found->second : nullptr;
}

const Schema::Part* Schema::find(std::span<const Part> parts, std::string_view name) {
  const auto found = std::ranges::lower_bound(parts, name, {}, &Part::name);
  return found != parts.end() && found->name == name ? &*found : nullptr;
}

}  // namespace pongsim::sdf
