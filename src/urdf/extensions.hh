#pragma once

#include <string>
#include <string_view>
#include <unordered_map>
#include <vector>

#include "pongsim/diagnostic.hh"
#include "pongsim/element.hh"

namespace pongsim::urdf {

/// The `<gazebo>` elements of a robot: what they say of its links, joints and of the whole.
class Extensions {
 public:
  explicit Extensions(const Element& robot);

  /// Warns of what can have no effect: a name that is no link's and no joint's, an element in the wrong place.
  void check(Diagnostics& diagnostics) const;

  /// What becomes of a fixed joint.
  enum class Fixing { kLumped, kKept, kTurnedRevolute };
  Fixing fixingOf(const std::string& joint) const;

  // Each adds to an element what is said of a link or joint: to one that the converter made, in the order of the file.

  void addToCollision(const std::string& link, Element& collision) const;
  void addToVisual(const std::string& link, Element& visual) const;
  /// @param link The one that is named, which may have become part of the one that is made.
  void addToLink(const std::string& link, Element& target) const;
  void addToJoint(const std::string& joint, Element& element) const;
  void addToModel(Element& model) const;

 private:
  using List = std::vector<const Element*>;
  const List& of(const std::string& reference) const;

  const Element& robot_;
  /// By reference; those of the whole have an empty one.
  std::unordered_map<std::string, List> lists_;
};

}  // namespace pongsim::urdf
