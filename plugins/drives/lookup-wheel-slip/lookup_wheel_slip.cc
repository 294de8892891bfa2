#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "pongsim/files/parameter_picture.hh"
#include "pongsim/parameters.hh"
#include "pongsim/physical_properties.hh"
#include "pongsim/system.hh"
#include "slipping_wheel.hh"

namespace pongsim {

namespace {

/// A channel with this value changes nothing.
constexpr int kNominal = 128;

/// The picture, lying in the world's xy plane, centred on the origin: its columns go along +x, its rows along -y.
struct SlipMap {
  ParameterPicture picture;
  double sizeX = 0;
  double sizeY = 0;

  /// @return The number of the pixel whose column and row are nearest to a place; nothing outside. The first column is
  /// centred on the picture's edge, as in Gazebo.
  std::optional<std::uint64_t> pixelAt(const Vector3& place) const {
    const double column = std::round((place.x() / sizeX + 0.5) * static_cast<double>(picture.width));
    const double row = std::round((0.5 - place.y() / sizeY) * static_cast<double>(picture.height));
    const bool isInside = column >= 0 && column < static_cast<double>(picture.width) && row >= 0 &&
                          row < static_cast<double>(picture.height);
    if (!isInside) return std::nullopt;
    return static_cast<std::uint64_t>(row) * picture.width + static_cast<std::uint64_t>(column);
  }
};

/// Changes the slip and the friction of the wheels of WheelSlip by where they are on a map.
class LookupWheelSlip final : public System {
 public:
  void declare(Declaration& declaration) override {
    declaration.is("Changes the slip and friction of a model's wheels with WheelSlip by a map of the ground.",
                   Declaration::Place::kModel);
    declaration.usesFiles();
    declaration
        .parameter("slip_map", &file_, "",
                   "picture: red adds to the lateral slip compliance, green to the longitudinal, "
                   "blue to the friction coefficients, each (value - 128) times its `..._delta`")
        .required();
    declaration.parameter("size_x", &map_.sizeX, "m", "extent of the picture along x").required().above(0);
    declaration.parameter("size_y", &map_.sizeY, "m", "extent of the picture along y").required().above(0);
    declaration.parameter("slip_compliance_lateral_delta", &deltas_[0], "", "per unit of red");
    declaration.parameter("slip_compliance_longitudinal_delta", &deltas_[1], "", "per unit of green");
    declaration.parameter("friction_delta", &deltas_[2], "", "per unit of blue");
    declaration.element("wheel_link_name", "the link of a wheel of WheelSlip; may be repeated").required();
  }

  void configure(const SystemContext& context) override {
    log_ = &context.log;
    map_.picture = parameterPicture(*context.sdf.child("slip_map"));
    properties_.emplace(context.world);
    for (const Element* name : context.sdf.childrenNamed("wheel_link_name")) {
      const SlippingWheel wheel = slippingWheel(elementOf(*name, *context.model), *context.model);
      wheels_.push_back({wheel, properties_->surface(wheel.collision), {}});
    }
  }

  // after WheelSlip's preUpdate, wherever its plugin stands
  void update(const StepInfo& info) override {
    if (info.paused) return;
    for (Wheel& wheel : wheels_) {
      const std::optional<std::uint64_t> found = map_.pixelAt(wheel.self.link.pose().position);
      if (found && found != wheel.pixel) {
        wheel.pixel = found;
        setFriction(wheel);
      }
      if (wheel.pixel) wheel.self.slip(complianceOf(wheel));
    }
  }

  void reset() override {
    for (Wheel& wheel : wheels_) wheel.pixel.reset();
  }

  void transfer(StateArchive& archive) override {
    for (Wheel& wheel : wheels_) {
      archive(wheel.pixel);
      archive.check(!wheel.pixel || *wheel.pixel < map_.picture.width * map_.picture.height);
    }
  }

 private:
  struct Wheel {
    SlippingWheel self;
    /// In the file.
    PhysicalProperties::Surface surface;
    /// Where it was last inside the map.
    std::optional<std::uint64_t> pixel;
  };

  /// @return The `<wheel>` of WheelSlip for a link.
  static const Element& elementOf(const Element& name, const Model& model) {
    for (const Element* plugin : model.plugins()) {
      for (const Element* wheel : plugin->childrenNamed("wheel")) {
        if (wheel->attributeOr("link_name", "") == name.text) return *wheel;
      }
    }
    refuse(name, "'" + name.text + "' is no wheel of WheelSlip in model '" + std::string(model.name()) + "'",
           "add gz-sim-wheel-slip-system to the model, with <wheel link_name=\"" + name.text + "\">");
  }

  double changed(const Wheel& wheel, double nominal, std::size_t channel) const {
    const int value = map_.picture.pixels[4 * *wheel.pixel + channel];
    return std::max(nominal + (value - kNominal) * deltas_[channel], 0.0);
  }

  SlipCompliance complianceOf(const Wheel& wheel) const {
    return {changed(wheel, wheel.self.compliance.lateral, 0), changed(wheel, wheel.self.compliance.longitudinal, 1)};
  }

  void setFriction(const Wheel& wheel) {
    PhysicalProperties::Surface surface = wheel.surface;
    surface.friction = changed(wheel, surface.friction, 2);
    surface.friction2 = changed(wheel, surface.friction2, 2);
    if (const auto set = properties_->setSurface(wheel.self.collision, surface); !set) log_->warning(set.error);
  }

  std::string file_;
  SlipMap map_;
  /// Per unit of red, green and blue.
  std::array<double, 3> deltas_{0.05, 0.005, 0.5};
  std::optional<PhysicalProperties> properties_;
  std::vector<Wheel> wheels_;
  const Logger* log_ = nullptr;
};

}  // namespace

}  // namespace pongsim

PONGSIM_EXPORT_SYSTEM(pongsim::LookupWheelSlip, "gz::sim::systems::LookupWheelSlip",
                      "ignition::gazebo::systems::LookupWheelSlip");
