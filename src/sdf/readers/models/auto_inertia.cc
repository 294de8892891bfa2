#include "sdf/readers/models/auto_inertia.hh"

#include <Eigen/Eigenvalues>
#include <cmath>
#include <variant>

#include "pongsim/geometry/solid.hh"
#include "sdf/readers/models/inertial_reader.hh"
#include "sdf/readers/models/mass_properties.hh"
#include "sdf/text/values.hh"

namespace pongsim::sdf {

namespace {

/// That of water, the default of the format [kg/m^3].
constexpr double kDefaultDensity = 1000;

/// @return Whether a mesh has holes.
bool isOpen(const description::Geometry& geometry) {
  const auto* mesh = std::get_if<description::Mesh>(&geometry);
  if (mesh == nullptr || mesh->triangles == nullptr) return false;
  return !Solid(TriangleShape{mesh->triangles->vertices, mesh->triangles->triangles, mesh->scale}).isClosed();
}

bool isPossible(const description::Inertial& inertial) {
  if (!std::isfinite(inertial.mass) || !inertial.moments.allFinite() || !(inertial.mass > 0)) return false;
  return Eigen::SelfAdjointEigenSolver<Matrix3>(inertial.moments).eigenvalues().minCoeff() > 0;
}

}  // namespace

std::optional<double> readDensity(const Element& element, Context& context) {
  if (element.child("density") == nullptr) return std::nullopt;
  return readPositive(element, "density", kDefaultDensity, context);
}

std::optional<AutoInertia> readAutoInertia(const Element& link, const std::string& owner, Context& context) {
  const Element* element = link.child("inertial");
  if (element == nullptr) return std::nullopt;
  const std::optional<double> density = readDensity(*element, context);
  if (!readFlagAttribute(*element, "auto", false, context)) return std::nullopt;
  for (const char* name : {"pose", "inertia"}) {
    const Element* replaced = element->child(name);
    if (replaced == nullptr) continue;
    context.diagnostics.warning(replaced->position, "the <" + std::string(name) + "> of the inertia of " + owner +
                                                        " is ignored: auto=\"true\" computes it");
  }
  if (const Element* added = element->child("fluid_added_mass")) {
    context.diagnostics.warning(
        added->position,
        "the <fluid_added_mass> of " + owner + " is ignored, as in Gazebo: an inertia with auto=\"true\" has none");
  }
  AutoInertia automatic{.mass = std::nullopt, .density = density, .position = element->position};
  if (element->child("mass") != nullptr) automatic.mass = readPositive(*element, "mass", 1, context);
  return automatic;
}

void computeInertia(const AutoInertia& automatic, const std::vector<std::optional<double>>& densities,
                    const std::string& owner, description::Link& link, Context& context) {
  if (link.collisions.empty()) {
    context.diagnostics.error(automatic.position, "the inertia of " + owner + " can't be computed: it has no collision",
                              "give <mass> and <inertia>, or add a <collision>");
    return;
  }
  MassProperties sum;
  for (std::size_t i = 0; i < link.collisions.size(); ++i) {
    const description::Collision& collision = link.collisions[i];
    const double density = densities[i].value_or(automatic.density.value_or(kDefaultDensity));
    const std::optional<MassProperties> part = massPropertiesOf(collision.geometry, density);
    if (!part) {
      context.diagnostics.warning(
          collision.position,
          "collision '" + collision.name + "' has no volume: it does not count in the inertia of " + owner);
      continue;
    }
    if (isOpen(collision.geometry)) {
      context.diagnostics.warning(collision.position,
                                  "the mesh of collision '" + collision.name + "' is not closed: the inertia of " +
                                      owner + " is that of the volume between the middle of the mesh and its surface",
                                  "close the mesh, or give <mass> and <inertia>");
    }
    sum += part->in(collision.X_LinkCollision);
  }
  const description::Inertial computed = sum.inertial(automatic.mass.value_or(sum.mass));
  if (computed.mass > kLargestMass) {
    context.diagnostics.error(automatic.position, "the computed mass of " + owner + " is beyond 1e30 kg");
    return;
  }
  if (isPossible(computed)) {
    link.inertial = computed;
    return;
  }
  context.diagnostics.error(automatic.position,
                            "the inertia of " + owner + " can't be computed: its collisions have no volume",
                            "give <mass> and <inertia>");
}

}  // namespace pongsim::sdf
