#pragma once

#include <string>
#include <vector>

#include "pongsim/element.hh"

namespace pongsim::urdf {

/// The collisions of a converted link, by their names in the robot's file: Fortress renames them
/// ("base_fixed_joint_lump__shell_collision"), but the file's contact sensors name them as it does.
class CollisionNames {
 public:
  /// @param ownLink The link of the collision in the file.
  /// @param inFile A name that the file may use for it.
  /// @param converted Its name in SDF.
  void add(std::string ownLink, std::string inFile, std::string converted);

  /// Makes a contact sensor name the converted collisions. A name stays if it is a converted one, or if the sensor's
  /// link has no collision of that name, or several.
  /// @param ownLink The link of the sensor in the file.
  void replaceIn(Element& sensor, const std::string& ownLink) const;

 private:
  struct Collision {
    std::string ownLink;
    std::string inFile;
    std::string converted;
  };

  std::vector<Collision> collisions_;
};

}  // namespace pongsim::urdf
