#pragma once

#include <map>
#include <string>
#include <string_view>
#include <utility>

#include "pongsim/element.hh"
#include "sdf/context.hh"

namespace pongsim::sdf {

/// Between a nested model and its part, as in `arm::hand::finger`.
inline constexpr std::string_view kNameSeparator = "::";

/// Reads the attribute `name`.
/// @param owner Whose part it is, for the message: "model 'robot'"; may be empty.
/// @return An empty text, and an error added, where there is none or it is a name that the format keeps for itself.
std::string readName(const Element& element, std::string_view owner, Context& context);

/// @return "link 'l' of model 'm'", or "a link of model 'm'" where it has no name.
std::string partLabel(const Element& element, const std::string& name, const std::string& owner);

/// The names given so far to the parts of one world, model or link.
class SiblingNames {
 public:
  /// @param owner "model 'robot'"
  explicit SiblingNames(std::string owner) : owner_(std::move(owner)) {}

  /// Adds a name, and an error where it is taken already. An empty name is not looked at.
  /// @param group Kinds of one group share their names; kinds of different groups do not.
  /// @param kind "link"
  void claim(const std::string& name, std::string_view group, std::string_view kind, const SourcePosition& position,
             Context& context);

  /// As above, for an element of its own kind and place.
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
