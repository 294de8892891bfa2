#include "sdf/readers/worlds/physics_reader.hh"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <string>
#include <string_view>

#include "base/nearest_word.hh"
#include "description/limits.hh"
#include "description/world.hh"
#include "sdf/schema/value_check.hh"
#include "sdf/text/values.hh"

namespace pongsim::sdf {

namespace {

// [s]: time is counted in nanoseconds, with 64 bits.
constexpr double kShortestStep = 1e-9;
constexpr double kLongestStep = 1e6;

/// Reads settings for Gazebo's physics engines. The values are not used, so any number is valid.
class EngineReader {
 public:
  explicit EngineReader(Context& context) : context_(context) {}

  description::OdeSettings readOde(const Element& element) {
    description::OdeSettings ode;
    if (const Element* solver = element.child("solver")) {
      ode.solver = readText(*solver, "type", ode.solver);
      number(*solver, "min_step_size", ode.minStepSize);
      integer(*solver, "island_threads", ode.islandThreads);
      integer(*solver, "iters", ode.iterations);
      integer(*solver, "precon_iters", ode.preconditionIterations);
      number(*solver, "sor", ode.sor);
      flag(*solver, "thread_position_correction", ode.threadsPositionCorrection);
      flag(*solver, "use_dynamic_moi_rescaling", ode.rescalesInertia);
      ode.frictionModel = readText(*solver, "friction_model", ode.frictionModel);
    }
    if (const Element* constraints = element.child("constraints")) {
      number(*constraints, "cfm", ode.cfm);
      number(*constraints, "erp", ode.erp);
      number(*constraints, "contact_max_correcting_vel", ode.contactMaxCorrectingVelocity);
      number(*constraints, "contact_surface_layer", ode.contactSurfaceLayer);
    }
    return ode;
  }

  description::BulletSettings readBullet(const Element& element) {
    description::BulletSettings bullet;
    if (const Element* solver = element.child("solver")) {
      bullet.solver = readText(*solver, "type", bullet.solver);
      number(*solver, "min_step_size", bullet.minStepSize);
      integer(*solver, "iters", bullet.iterations);
      number(*solver, "sor", bullet.sor);
    }
    if (const Element* constraints = element.child("constraints")) {
      number(*constraints, "cfm", bullet.cfm);
      number(*constraints, "erp", bullet.erp);
      number(*constraints, "contact_surface_layer", bullet.contactSurfaceLayer);
      flag(*constraints, "split_impulse", bullet.splitsImpulse);
      number(*constraints, "split_impulse_penetration_threshold", bullet.splitImpulsePenetrationThreshold);
    }
    return bullet;
  }

  description::SimbodySettings readSimbody(const Element& element) {
    description::SimbodySettings simbody;
    number(element, "min_step_size", simbody.minStepSize);
    number(element, "accuracy", simbody.accuracy);
    number(element, "max_transient_velocity", simbody.maxTransientVelocity);
    if (const Element* contact = element.child("contact")) {
      number(*contact, "stiffness", simbody.stiffness);
      number(*contact, "dissipation", simbody.dissipation);
      number(*contact, "plastic_coef_restitution", simbody.plasticRestitution);
      number(*contact, "plastic_impact_velocity", simbody.plasticImpactVelocity);
      number(*contact, "static_friction", simbody.staticFriction);
      number(*contact, "dynamic_friction", simbody.dynamicFriction);
      number(*contact, "viscous_friction", simbody.viscousFriction);
      number(*contact, "override_impact_capture_velocity", simbody.impactCaptureVelocity);
      number(*contact, "override_stiction_transition_velocity", simbody.stictionTransitionVelocity);
    }
    return simbody;
  }

  description::DartSettings readDart(const Element& element) {
    description::DartSettings dart;
    if (const Element* solver = element.child("solver")) {
      dart.solver = readText(*solver, "solver_type", dart.solver);
      checkSolver(*solver, dart.solver);
    }
    dart.collisionDetector = readText(element, "collision_detector", dart.collisionDetector);
    return dart;
  }

 private:
  void checkSolver(const Element& element, const std::string& solver) {
    constexpr std::array<std::string_view, 2> kSolvers = {"dantzig", "pgs"};
    if (std::ranges::find(kSolvers, solver) != kSolvers.end()) return;
    std::string hint = base::didYouMean(solver, kSolvers);
    context_.diagnostics.warning(element.child("solver_type")->position,
                                 "there is no solver '" + solver + "': 'dantzig' is used",
                                 hint.empty() ? "the solvers are dantzig and pgs" : hint);
  }

  void number(const Element& element, std::string_view child, double& value) {
    value = readLimit(element, child, value, context_);
  }
  void integer(const Element& element, std::string_view child, long long& value) {
    using Limits = std::numeric_limits<int>;
    value = readInteger(element, child, value, Limits::min(), Limits::max(), context_);
  }
  void flag(const Element& element, std::string_view child, bool& value) {
    value = readFlag(element, child, value, context_);
  }

  Context& context_;
};

description::PhysicsProfile readProfile(const Element& element, Context& context) {
  description::PhysicsProfile profile;
  profile.name = element.attributeOr("name", profile.name);
  profile.type = element.attributeOr("type", profile.type);
  profile.isDefault = readFlagAttribute(element, "default", false, context);
  const double step = readPositive(element, "max_step_size", toSeconds(profile.maxStepSize), context);
  if (step >= kShortestStep && step <= kLongestStep) {
    profile.maxStepSize = fromSeconds(step);
  } else {
    context.diagnostics.error(
        element.child("max_step_size")->position,
        "a step of " + std::string(childText(element, "max_step_size")) + " s is out of range: 1e-9 to 1e6 s");
  }
  // as in Gazebo, negative means as fast as possible, like zero; infinity means the same
  const double factor = readLimit(element, "real_time_factor", profile.realTimeFactor, context);
  profile.realTimeFactor = std::isfinite(factor) ? std::max(factor, 0.0) : 0.0;
  profile.realTimeUpdateRate = readLimit(element, "real_time_update_rate", profile.realTimeUpdateRate, context);
  profile.maxContacts = readInteger(element, "max_contacts", profile.maxContacts, std::numeric_limits<int>::min(),
                                    std::numeric_limits<int>::max(), context);
  EngineReader engines(context);
  if (const Element* ode = element.child("ode")) profile.ode = engines.readOde(*ode);
  if (const Element* bullet = element.child("bullet")) profile.bullet = engines.readBullet(*bullet);
  if (const Element* simbody = element.child("simbody")) profile.simbody = engines.readSimbody(*simbody);
  if (const Element* dart = element.child("dart")) profile.dart = engines.readDart(*dart);
  return profile;
}

}  // namespace

std::vector<description::PhysicsProfile> readPhysics(const Element& world, Context& context) {
  std::vector<description::PhysicsProfile> profiles;
  for (const Element* child : world.childrenNamed("physics")) profiles.push_back(readProfile(*child, context));
  return profiles;
}

description::PhysicsProfile chosenProfile(const std::vector<description::PhysicsProfile>& profiles) {
  const auto marked = std::ranges::find(profiles, true, &description::PhysicsProfile::isDefault);
  if (marked != profiles.end()) return *marked;
  return profiles.empty() ? description::PhysicsProfile() : profiles.front();
}

Vector3 readGravity(const Element& world, Context& context) {
  // more than on the surface of any star but a neutron star, and far below the limits of the physics
  const Vector3 usual = description::World().gravity;
  const Vector3 gravity = readVector(world, "gravity", usual, context);
  if (gravity.cwiseAbs().maxCoeff() <= description::kLargestGravity) return gravity;
  const Element& element = *world.child("gravity");
  context.diagnostics.error(element.position, "<gravity> is '" + quoted(element.text) + "': the limit is 1e6 m/s^2",
                            "on earth it is 0 0 -9.8");
  return usual;
}

}  // namespace pongsim::sdf
