#include <algorithm>
#include <cmath>
#include <cstddef>
#include <optional>
#include <span>
#include <string>
#include <utility>
#include <variant>
#include <vector>

#include "fluid.hh"
#include "pongsim/geometry/solid.hh"
#include "pongsim/link_group.hh"
#include "pongsim/parameters.hh"
#include "pongsim/system.hh"

namespace pongsim {

namespace {

/// A link that displaces fluid.
struct FloatingLink {
  struct Part {
    Solid solid;
    Pose X_LinkPart;
    /// Whether its frame is that of the link.
    bool isInPlace;
  };

  Link link;
  std::vector<Part> parts;
  /// Volume of all parts together [m^3], with its centre in the link frame.
  Volume volume;
  /// Whether that centre is the origin of the link frame.
  bool isCentred = true;
  /// Largest distance of any part from that centre [m].
  double radius = 0;
};

/// Applies buoyancy to links: the weight of the fluid that their collisions displace.
class Buoyancy : public System {
 public:
  void declare(Declaration& declaration) override {
    declaration.is("Applies buoyancy to links: the weight of the fluid that their collisions displace.",
                   Declaration::Place::kWorld);
    declaration.parameter("uniform_fluid_density", &density_, "kg/m^3", "density of the fluid, the same everywhere")
        .above(0)
        .otherwise("1000");
    declaration.element("graded_buoyancy",
                        "fluid in layers: `default_density` [kg/m^3] below all (1000), and `density_change`, "
                        "repeated, with `density` [kg/m^3] from the height `above_depth` [m] up");
    declaration.parameter("enable", &enabled_, "", "model or link (`M`, `M::L`) with buoyancy; default: all");
  }

  void configure(const SystemContext& context) override {
    log_ = &context.log;
    world_ = &context.world;
    readFluid(context.sdf, context.diagnostics);
    addLinks(&context.diagnostics);
    warnOfUnknown(context.sdf, context.diagnostics);
  }

  // it inlines everything that it calls for each link
  [[gnu::flatten]] void preUpdate(const StepInfo& info) override {
    if (info.paused) return;
    const Vector3 gravity = world_->gravity();
    const std::span<const Pose* const> poses = group_->poses();
    for (std::size_t i = 0; i < links_.size(); ++i) wrenches_[i] = lift(links_[i], *poses[i], gravity);
    group_->addWrenches(wrenches_);
  }

  void worldChanged() override {
    std::erase_if(links_, [](const FloatingLink& each) { return !each.link.exists(); });
    addLinks(nullptr);
  }

 private:
  void readFluid(const Element& sdf, Diagnostics& diagnostics);
  void readLayers(const Element& graded, Diagnostics& diagnostics);
  void readLayer(const Element& change, Diagnostics& diagnostics);
  void warnOfUnknown(const Element& sdf, Diagnostics& diagnostics) const;
  bool isEnabled(const Model& model) const;
  void addLinks(Diagnostics* diagnostics);
  void addLinksOf(const Model& model, bool isEnabledAbove, Diagnostics* diagnostics);
  void addLink(const Link& link, Diagnostics* diagnostics);
  void warnOfSurface(const Collision& collision, const Solid& solid, Diagnostics* diagnostics) const;
  Displaced displacedBy(const FloatingLink& each, const Pose& X_WorldLink) const;
  Wrench lift(const FloatingLink& each, const Pose& X_WorldLink, const Vector3& gravity) const;

  std::optional<double> density_;
  std::vector<std::string> enabled_;

  Fluid fluid_;
  std::vector<FloatingLink> links_;
  /// The links above as a group, and the wrenches on them.
  std::optional<LinkGroup> group_;
  std::vector<Wrench> wrenches_;
  World* world_ = nullptr;
  const Logger* log_ = nullptr;
};

/// @return The number in a child of an element.
double densityIn(const Element& element, bool mayBeZero) {
  const double density = element.as<double>();
  const bool isPossible = std::isfinite(density) && (mayBeZero ? density >= 0 : density > 0);
  if (!isPossible) refuse(element, "<" + element.name + "> must be a finite number above zero");
  return density;
}

void Buoyancy::readFluid(const Element& sdf, Diagnostics& diagnostics) {
  const Element* graded = sdf.child("graded_buoyancy");
  if (density_) {
    fluid_ = Fluid(*density_);
    if (graded != nullptr) {
      diagnostics.warning(graded->position, "<graded_buoyancy> has no effect: <uniform_fluid_density> is given too");
    }
  } else if (graded != nullptr) {
    readLayers(*graded, diagnostics);
  }
}

void Buoyancy::readLayers(const Element& graded, Diagnostics& diagnostics) {
  double bottom = 1000;
  for (const Element& element : graded.children) {
    if (element.name == "default_density") {
      bottom = densityIn(element, false);
    } else if (element.name != "density_change") {
      diagnostics.warning(element.position, "<graded_buoyancy> has no parameter <" + element.name + ">",
                          "it has <default_density> and <density_change>");
    }
  }
  fluid_ = Fluid(bottom);
  const std::vector<const Element*> changes = graded.childrenNamed("density_change");
  for (const Element* change : changes) readLayer(*change, diagnostics);
  if (changes.empty()) {
    diagnostics.warning(graded.position,
                        "<graded_buoyancy> has no <density_change>: the density is the same everywhere");
  }
}

void Buoyancy::readLayer(const Element& change, Diagnostics& diagnostics) {
  const Element* density = change.child("density");
  if (density == nullptr || density->text.empty()) refuse(change, "<density_change> has no <density>");
  const std::optional<double> from = change.find<double>("above_depth");
  if (!from) diagnostics.warning(change.position, "<density_change> has no <above_depth>: it begins at 0 m");
  if (!std::isfinite(from.value_or(0))) refuse(*change.child("above_depth"), "<above_depth> must be a finite number");
  const double value = densityIn(*density, true);
  if (value == 0) diagnostics.warning(density->position, "the <density> is zero: nothing floats");
  if (!fluid_.addLayer(from.value_or(0), value)) {
    diagnostics.warning(change.position, "<density_change> replaces another one at the same height");
  }
}

bool Buoyancy::isEnabled(const Model& model) const {
  return enabled_.empty() || std::ranges::find(enabled_, model.scopedName()) != enabled_.end();
}

void Buoyancy::addLinks(Diagnostics* diagnostics) {
  for (const Model& model : world_->models()) addLinksOf(model, false, diagnostics);
  std::vector<Link> all;
  for (const FloatingLink& each : links_) all.push_back(each.link);
  group_.emplace(*world_, all);
  wrenches_.resize(all.size());
}

void Buoyancy::addLinksOf(const Model& model, bool isEnabledAbove, Diagnostics* diagnostics) {
  if (model.isStatic()) return;
  const bool isOn = isEnabledAbove || isEnabled(model);
  for (const Link& link : model.links()) {
    const bool isMeant = isOn || std::ranges::find(enabled_, link.scopedName()) != enabled_.end();
    const auto isSame = [&link](const FloatingLink& each) { return each.link.id() == link.id(); };
    if (isMeant && std::ranges::none_of(links_, isSame)) addLink(link, diagnostics);
  }
  for (const Model& inner : model.models()) addLinksOf(inner, isOn, diagnostics);
}

void Buoyancy::addLink(const Link& link, Diagnostics* diagnostics) {
  FloatingLink floating{link, {}, {}};
  Vector3 first = Vector3::Zero();
  for (const Collision& collision : link.collisions()) {
    Solid solid(collision.shape());
    warnOfSurface(collision, solid, diagnostics);
    if (!(solid.volume().size > 0)) continue;
    const Pose X_LinkPart = collision.poseInLink();
    floating.volume.size += solid.volume().size;
    first += solid.volume().size * (X_LinkPart * solid.volume().center);
    floating.parts.push_back({std::move(solid), X_LinkPart, X_LinkPart == Pose()});
  }
  if (floating.parts.empty()) return;
  floating.volume.center = first / floating.volume.size;
  floating.isCentred = floating.volume.center.isZero(0);
  for (const FloatingLink::Part& part : floating.parts) {
    const Vector3 middle = part.X_LinkPart * Vector3(part.solid.bounds().center());
    floating.radius = std::max(floating.radius, (middle - floating.volume.center).norm() + part.solid.radius());
  }
  links_.push_back(std::move(floating));
}

void Buoyancy::warnOfSurface(const Collision& collision, const Solid& solid, Diagnostics* diagnostics) const {
  if (!std::holds_alternative<TriangleShape>(solid.shape()) || solid.isClosed()) return;
  const std::string text = "collision '" + collision.scopedName() +
                           "' is not a closed surface with consistent triangles: its volume is a guess";
  if (diagnostics == nullptr) return log_->warning(text);
  diagnostics->warning(collision.sourcePosition(), text, "use a box, a cylinder or a closed mesh");
}

void Buoyancy::warnOfUnknown(const Element& sdf, Diagnostics& diagnostics) const {
  for (const Element* element : sdf.childrenNamed("enable")) {
    if (element->text.empty() || world_->model(element->text)) continue;
    const auto isLink = [element](const FloatingLink& each) { return each.link.scopedName() == element->text; };
    if (std::ranges::any_of(links_, isLink)) continue;
    diagnostics.warning(element->position, "<enable> '" + element->text + "' is not a model or link yet",
                        "write 'model' or 'model::link'");
  }
}

/// What a link displaces if the fluid around it is not uniform.
Displaced Buoyancy::displacedBy(const FloatingLink& each, const Pose& X_WorldLink) const {
  const double height = X_WorldLink.position.z();
  if (each.parts.size() == 1 && each.parts[0].isInPlace) {
    return fluid_.displacedBy(each.parts[0].solid, X_WorldLink.rotation, height);
  }
  Displaced sum;
  for (const FloatingLink::Part& part : each.parts) {
    const Vector3 linkToPart = X_WorldLink.rotation * part.X_LinkPart.position;
    const Displaced displaced =
        fluid_.displacedBy(part.solid, X_WorldLink.rotation * part.X_LinkPart.rotation, height + linkToPart.z());
    sum.mass += displaced.mass;
    sum.first += displaced.first + displaced.mass * linkToPart;
  }
  return sum;
}

/// Archimedes: the weight of the displaced fluid, against gravity, at its centre.
Wrench Buoyancy::lift(const FloatingLink& each, const Pose& X_WorldLink, const Vector3& gravity) const {
  Vector3 linkToCenter = Vector3::Zero();
  if (!each.isCentred) linkToCenter = X_WorldLink.rotation * each.volume.center;
  const double height = X_WorldLink.position.z() + linkToCenter.z();
  const std::optional<double> density = fluid_.densityBetween(height - each.radius, height + each.radius);
  if (!density) {
    const Displaced displaced = displacedBy(each, X_WorldLink);
    return {-displaced.mass * gravity, gravity.cross(displaced.first)};
  }
  const Vector3 weight = *density * each.volume.size * gravity;
  if (each.isCentred) return {-weight, Vector3::Zero()};
  return {-weight, weight.cross(linkToCenter)};
}

}  // namespace

}  // namespace pongsim

PONGSIM_EXPORT_SYSTEM(pongsim::Buoyancy, "ignition::gazebo::systems::Buoyancy", "gz::sim::systems::Buoyancy");
