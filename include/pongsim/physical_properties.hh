#pragma once

#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "pongsim/export.hh"
#include "pongsim/handles.hh"
#include "pongsim/outcome.hh"
#include "pongsim/sensing/noise_settings.hh"
#include "pongsim/visual_colors.hh"

namespace pongsim {

class NoiseSet;

/// Properties of links, collisions, joints, visuals and sensors that are changed between two steps, so that a world
/// differs from its file in them without being loaded again. They are part of saved states, and a reset brings those of
/// the file back. Must not outlive the `Simulation`. Systems that have read a property before, such as a controller
/// that knows the mass of its robot, or buoyancy that knows its volume, go on with the old one.
class PONGSIM_API PhysicalProperties {
 public:
  explicit PhysicalProperties(const World& world) : access_(world.access_) {}

  /// Changes the mass of a link; its centre of mass and the axes of its inertia stay.
  /// @param mass [kg]
  /// @param inertiaFactor How many times the moments of inertia of the file the new ones are.
  Outcome<void> setMass(const Link& link, double mass, double inertiaFactor);
  /// @return That factor; 1 unless changed.
  double inertiaFactor(const Link& link) const;

  /// Friction coefficients along both friction directions of a collision, and its coefficient of restitution. Of two
  /// collisions that touch, the smaller friction coefficient counts, and the product of the restitutions.
  struct Surface {
    double friction = 0;
    double friction2 = 0;
    double restitution = 0;
  };
  Surface surface(const Collision& collision) const;
  Outcome<void> setSurface(const Collision& collision, const Surface& surface);

  /// Changes the damping [N m s/rad or N s/m] of a joint's axis; `Joint::axisInfo` tells it.
  Outcome<void> setDamping(const Joint& joint, double damping, int axis = 0);
  /// Changes the friction [N m or N] of a joint's axis; `Joint::friction` tells it.
  Outcome<void> setFriction(const Joint& joint, double friction, int axis = 0);

  /// @return The size of a simple shape [m]: x, y and z of a box, the radius of a sphere, radius and length of a
  /// cylinder or capsule, the radii of an ellipsoid; empty for other shapes.
  std::vector<double> size(const Collision& collision) const;
  /// @param visual One of the link's.
  std::vector<double> size(const Link& link, const Visual& visual) const;
  /// What takes the new size of a collision along.
  struct Following {
    /// The visuals of its link with the same shape, size and pose.
    bool visuals = true;
    /// Mass and inertia of its link: its mass is spread over the new shape as over the old one, with the same density.
    /// Refused if the link has other collisions, or if that would move the centre of mass or turn the principal axes of
    /// inertia.
    bool mass = false;
  };
  /// Changes the size of a collision, 1e-6 m or more; `size` and `Collision::shape` tell it. Its frame stays, and so do
  /// wheel radii and the like in the parameters of systems. What is now inside of something is pushed out at
  /// 1 cm/s.
  Outcome<void> setSize(const Collision& collision, std::span<const double> size, const Following& following);
  /// Changes the size in which cameras and lidars see a visual.
  Outcome<void> setSize(const Link& link, const Visual& visual, std::span<const double> size);

  /// Noise on a value that a sensor reads.
  struct ReadingNoise {
    /// Such as "range" or "acceleration x".
    std::string value;
    NoiseSettings noise;
  };
  /// @return The noise of a sensor's readings, also where there is none; empty for a sensor without a system that gives
  /// it noise.
  std::vector<ReadingNoise> noises(const Sensor& sensor) const;
  /// Changes the noise of a value from the next reading on. Its offset begins again as at the start. What a sensor says
  /// of its accuracy in messages stays as in the file.
  Outcome<void> setNoise(const Sensor& sensor, std::string_view value, const NoiseSettings& noise);

  /// Changes the colour in which cameras, the scene and the state message show a visual, until a reset; its textures
  /// are tinted with it. Colours are no part of saved states, because nothing moves by them.
  /// @param color Red, green, blue, 0 to 1, as in `<diffuse>`.
  /// @param glows Whether the visual also emits it (`<emissive>`), and so has it in the dark, too.
  Outcome<void> setColor(VisualId visual, const Vector3& color, bool glows = false);
  /// The same for each of its colours. What is left out stays as it is.
  Outcome<void> setColors(VisualId visual, const VisualColors& colors);

  /// Positions between which a joint's axis moves [rad or m], and the largest force or torque of its motor and of
  /// commands [N m or N]. With `lower` and `upper` the same, it is locked there. May be infinite; NaN is refused.
  struct Bounds {
    double lower = 0;
    double upper = 0;
    double effort = 0;
  };
  /// @param axis Below `Joint::axisCount()`.
  Bounds bounds(const Joint& joint, int axis = 0) const;
  /// Changes them; `Joint::axisInfo` tells those of the file.
  Outcome<void> setBounds(const Joint& joint, const Bounds& bounds, int axis = 0);

 private:
  friend class SensorSystem;
  /// Makes a sensor's noise known until it is removed.
  void add(const Sensor& sensor, NoiseSet& noises);
  void remove(const NoiseSet& noises);
  Outcome<void> setResistance(const Joint& joint, const char* what, double number, int axis);
  sim::Access* access_;
};

}  // namespace pongsim
