#include "pongsim/element.hh"

#include <limits>

#include "base/parse_number.hh"

namespace pongsim {

namespace {

[[noreturn]] void failToRead(const Element& element, std::string_view expected) {
  throw Error({Severity::kError,
               element.position,
               "<" + element.name + "> is '" + element.text + "', which is not " + std::string(expected),
               {}});
}

}  // namespace

const Element* Element::child(std::string_view childName) const {
  for (const Element& candidate : children) {
    if (candidate.name == childName) return &candidate;
  }
  return nullptr;
}

std::vector<const Element*> Element::childrenNamed(std::string_view childName) const {
  std::vector<const Element*> found;
  for (const Element& candidate : children) {
    if (candidate.name == childName) found.push_back(&candidate);
  }
  return found;
}

const Element::Attribute* Element::attribute(std::string_view attributeName) const {
  for (const Attribute& candidate : attributes) {
    if (candidate.name == attributeName) return &candidate;
  }
  return nullptr;
}

std::string Element::attributeOr(std::string_view attributeName, std::string_view fallback) const {
  const Attribute* found = attribute(attributeName);
  return found != nullptr ? found->value : std::string(fallback);
}

template <>
double Element::as<double>() const {
  const std::optional<double> value = base::parseDouble(text);
  if (!value) failToRead(*this, "a number");
  return *value;
}

template <>
bool Element::as<bool>() const {
  if (text == "true" || text == "1" || text == "True" || text == "TRUE") return true;
  if (text == "false" || text == "0" || text == "False" || text == "FALSE") return false;
  failToRead(*this, "'true' or 'false'");
}

template <>
int Element::as<int>() const {
  const std::optional<long long> value = base::parseInteger(text);
  if (!value || *value < std::numeric_limits<int>::min() || *value > std::numeric_limits<int>::max()) {
    failToRead(*this, "an integer");
  }
  return static_cast<int>(*value);
}

template <>
std::string Element::as<std::string>() const {
  return text;
}

template <>
Vector3 Element::as<Vector3>() const {
  const std::optional<std::vector<double>> values = base::parseDoubles(text);
  if (!values || values->size() != 3) failToRead(*this, "three numbers");
  return {(*values)[0], (*values)[1], (*values)[2]};
}

}  // namespace pongsim
