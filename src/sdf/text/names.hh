#pragma once

#include <map>
#include <string>
#include <string_view>
#include <utility>

#include "pongsim/element.hh"
#include "sdf/context.hh"

namespace pongsim::sdf {

/// Separates a nested model from its part, as in `arm::hand::finger`.
inline constexpr std::string_view kNameSeparator = "::";

/// Name, inside a model, of the model's own frame.
inline constexpr std::string_view kModelFrame = "__model__";

/// Reads the attribute `name`.
/// @param owner What the element is part of, for the message: "model 'robot'"; may be empty.
/// @return The name; empty, with an error, if there is none or the format reserves it.
std::string readName(const Element& element, std::string_view owner, Context& context);

/// @return "link 'l' of model 'm'", or "a link of model 'm'" if it has no name.
std::string partLabel(const Element& element, const std::string& name, const std::string& owner);

/// The names used so far in one world, model or link.
class SiblingNames {
 public:
  /// @param owner "model 'robot'"
  explicit SiblingNames(std::string owner) : owner_(std::move(owner)) {}

  /// Adds a name; if it is already used, adds an error instead. Empty names are ignored.
  /// @param group Names must differ within a group of kinds, but not between groups.
  /// @param kind "link"
  void claim(const std::string& name, std::string_view group, std::string_view kind, const SourcePosition& position,
             Context& context);

  /// Like the above, with the kind and position of an element.
  void claim(const std::string& name, std::string_view group, const Element& element, Context& context) {
    claim(name, group, element.name, element.position, context);
  }

 private:
  struct Holder {
    std::string kind;
    SourcePosition position;
  };
  std::string owner_;
  std::map<std::pair<std::string, std::string>, Holder, std::less<>> holders_;
};

}  // namespace pongsim::sdf
