#pragma once

#include <string>
#include <string_view>
#include <unordered_map>
#include <vector>

#include "pongsim/diagnostic.hh"
#include "pongsim/element.hh"

namespace pongsim::urdf {

/// The `<gazebo>` elements of a robot, which extend its links, its joints, or the robot as a whole.
class Extensions {
 public:
  explicit Extensions(const Element& robot);

  /// Warns about elements without effect: a name of no link or joint, an element in the wrong place.
  void check(Diagnostics& diagnostics) const;

  /// What happens to a fixed joint.
  enum class Fixing { kLumped, kKept, kTurnedRevolute };
  Fixing fixingOf(const std::string& joint) const;

  // Each function adds the extensions of a link or joint to the converted element, in the order of the file.

  void addToCollision(const std::string& link, Element& collision) const;
  void addToVisual(const std::string& link, Element& visual) const;
  /// @param link The link named in the extension, which may have become part of the converted one.
  void addToLink(const std::string& link, Element& target) const;
  void addToJoint(const std::string& joint, Element& element) const;
  void addToModel(Element& model) const;
  /// @return Whether `addToModel` adds an element of this name.
  bool namesInModel(const std::string& name) const;

 private:
  using List = std::vector<const Element*>;
  const List& of(const std::string& reference) const;

  const Element& robot_;
  /// Keyed by reference; empty for those of the whole robot.
  std::unordered_map<std::string, List> lists_;
};

}  // namespace pongsim::urdf
