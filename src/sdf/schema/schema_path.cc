#include "sdf/schema/schema_path.hh"

#include <algorithm>
#include <set>

#include "base/nearest_word.hh"

namespace pongsim::sdf {

namespace {

/// If there are more candidates, they are not listed.
constexpr std::size_t kMostListed = 12;

/// @return The names in the path; attributes start with "@".
std::vector<std::string> split(std::string_view path) {
  std::vector<std::string> names(1);
  for (const char letter : path) {
    if ((letter == '/' || letter == '@') && !names.back().empty() && names.back() != "@") names.emplace_back();
    if (letter != '/') names.back() += letter;
  }
  if (names.back().empty()) names.pop_back();
  return names;
}

/// @return The path without its last name.
std::string_view holderOf(std::string_view tablePath) {
  const std::size_t mark = tablePath.find_last_of(".@");
  return mark == std::string_view::npos ? "" : tablePath.substr(0, mark);
}

/// Calls `take` with each element and attribute of an element.
template <class Take>
void forEachPart(Take take) {
  const Schema& schema = Schema::instance();
  for (const SchemaRow& row : schemaTable()) {
    const std::string_view holder = holderOf(row.path);
    if (holder.empty() || row.path.ends_with('*')) continue;
    const Schema::ElementType* type = schema.typeOf(holder);
    const bool isAttribute = row.path[holder.size()] == '@';
    take(*Schema::find(isAttribute ? type->attributes : type->children, row.path.substr(holder.size() + 1)),
         isAttribute, holder);
  }
}

struct Candidate {
  const Schema::Part* part;
  bool isAttribute;
  std::string_view holder;
};

std::vector<Candidate> candidatesFor(const std::string& name) {
  const Schema::Part* shared = Schema::instance().shared(name);
  if (shared != nullptr) return {{shared, false, ""}};
  std::vector<Candidate> found;
  forEachPart([&](const Schema::Part& part, bool isAttribute, std::string_view holder) {
    if ((isAttribute ? "@" : "") + std::string(part.name) == name) found.push_back({&part, isAttribute, holder});
  });
  return found;
}

/// @return The candidates' children with this name.
std::vector<Candidate> stepInto(const std::vector<Candidate>& candidates, const std::string& name) {
  std::vector<Candidate> found;
  for (const Candidate& candidate : candidates) {
    const Schema::ElementType* type = candidate.part->type;
    if (type == nullptr) continue;
    const bool isAttribute = name.starts_with('@');
    const Schema::Part* part = isAttribute ? Schema::find(type->attributes, std::string_view(name).substr(1))
                                           : Schema::find(type->children, name);
    if (part != nullptr && part->name != "*") found.push_back({part, isAttribute, holderOf(part->row.path)});
  }
  return found;
}

std::string labelOf(const std::string& name) {
  return name.starts_with('@') ? "attribute '" + name.substr(1) + "'" : "element '" + name + "'";
}

/// @param holders Where it was looked for; empty: everywhere.
NoPart unknown(const std::string& name, const std::vector<Candidate>& holders) {
  std::set<std::string> known;
  const auto add = [&known](std::string_view part, bool isAttribute) {
    if (part != "*") known.insert((isAttribute ? "@" : "") + std::string(part));
  };
  for (const Candidate& holder : holders) {
    if (holder.part->type == nullptr) continue;
    for (const Schema::Part& part : holder.part->type->attributes) add(part.name, true);
    for (const Schema::Part& part : holder.part->type->children) add(part.name, false);
  }
  if (holders.empty()) {
    for (const Schema::Part& part : Schema::instance().allShared()) add(part.name, false);
    forEachPart([&](const Schema::Part& part, bool isAttribute, std::string_view) { add(part.name, isAttribute); });
  }
  const std::vector<std::string_view> words(known.begin(), known.end());
  const std::string place = holders.empty() ? "" : " in <" + std::string(holders.front().part->name) + ">";
  return {"SDF has no " + labelOf(name) + place, base::didYouMean(name, words)};
}

NoPart ambiguous(const std::string& name, const std::vector<Candidate>& candidates) {
  std::string list;
  for (std::size_t i = 0; i < candidates.size() && i < kMostListed; ++i) {
    list += (i == 0 ? "" : ", ") + userPath(candidates[i].part->row.path);
  }
  if (candidates.size() > kMostListed) list += ", ...";
  return {labelOf(name) + " is in several elements, with different meanings", "one of " + list};
}

/// @return All elements that contain the shared element with this name.
std::vector<std::string_view> holdersOfShared(std::string_view name) {
  std::vector<std::string_view> holders;
  for (const SchemaRow& row : schemaTable()) {
    if (row.removedIn == 0 && row.type.starts_with('+') && row.type.substr(1) == name) {
      holders.push_back(holderOf(row.path));
    }
  }
  std::ranges::sort(holders);
  return holders;
}

}  // namespace

std::variant<NamedPart, NoPart> findPart(std::string_view path) {
  const std::vector<std::string> names = split(path);
  if (names.empty()) return NoPart{"no element is given", "for example 'joint' or 'joint/axis/limit'"};
  std::vector<Candidate> candidates = candidatesFor(names.front());
  if (candidates.empty()) return unknown(names.front(), {});
  for (std::size_t i = 1; i < names.size(); ++i) {
    std::vector<Candidate> next = stepInto(candidates, names[i]);
    if (next.empty()) return unknown(names[i], candidates);
    candidates = std::move(next);
  }
  if (candidates.size() > 1) return ambiguous(names.back(), candidates);
  const Candidate& found = candidates.front();
  if (found.holder.empty()) return NamedPart{found.part, false, holdersOfShared(found.part->row.path)};
  return NamedPart{found.part, found.isAttribute, {found.holder}};
}

std::string userPath(std::string_view tablePath) {
  std::string path;
  for (const char letter : tablePath) {
    if (letter == '@') path += "/@";
    if (letter == '.') path += '/';
    if (letter != '@' && letter != '.') path += letter;
  }
  return path;
}

}  // namespace pongsim::sdf
