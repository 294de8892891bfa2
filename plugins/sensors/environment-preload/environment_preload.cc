#include <cstdint>
#include <sstream>
#include <string>
#include <utility>

#include "pongsim/files/parameter_file.hh"
#include "pongsim/parameters.hh"
#include "pongsim/sensing/environment.hh"
#include "pongsim/system.hh"

namespace pongsim {

namespace {

// a table of 10 million cells has about 100 MB
constexpr std::uint64_t kLargestFile = 256 << 20;

using Reference = EnvironmentSettings::Reference;

Reference referenceOf(const Element& space) {
  const std::string name = space.attributeOr("reference", "global");
  if (name == "global") return Reference::kGlobal;
  if (name == "spherical") return Reference::kSpherical;
  if (name == "ecef") return Reference::kEcef;
  refuse(space, "<space> has the unknown reference '" + name + "'", "it can be global, spherical or ecef");
}

bool isInDegrees(const Element& space) {
  const std::string units = space.attributeOr("units", "radians");
  if (units != "degrees" && units != "radians") {
    refuse(space, "<space> has the unknown units '" + units + "'", "they can be degrees or radians");
  }
  return units == "degrees";
}

EnvironmentSettings settingsIn(const Element& plugin) {
  EnvironmentSettings settings;
  const Element* dimensions = plugin.child("dimensions");
  if (dimensions == nullptr) return settings;
  settings.isStatic = dimensions->get("ignore_time", false);
  settings.timeColumn = dimensions->get("time", settings.timeColumn);
  const Element* space = dimensions->child("space");
  if (space == nullptr) return settings;
  settings.reference = referenceOf(*space);
  settings.isInDegrees = isInDegrees(*space);
  constexpr const char* kAxes[] = {"x", "y", "z"};
  for (std::size_t i = 0; i < settings.placeColumns.size(); ++i) {
    settings.placeColumns[i] = space->get(kAxes[i], settings.placeColumns[i]);
  }
  return settings;
}

/// Reads a table of quantities by time and place, for sensors.
class EnvironmentPreload final : public System, public EnvironmentUser {
 public:
  void declare(Declaration& declaration) override {
    declaration.is("Reads a table of quantities by time and place, which sensors measure.", Declaration::Place::kWorld);
    declaration.usesFiles();
    declaration.parameter("data", &data_, "", "file of comma-separated values").required();
    declaration.element(
        "dimensions",
        "columns: `<time>` (t) [s]; `<space>` with `<x>` (x), `<y>` (y) and `<z>` (z), whose attribute "
        "`reference` is global (the default), spherical or ecef, and `units`, for spherical, radians or "
        "degrees; `<ignore_time>` true: the first time holds for ever");
  }

  void configure(const SystemContext& context) override {
    shareEnvironment(context.before);
    if (environment() != nullptr) refuse(context.sdf, "the world has an environment already");
    const Element& file = *context.sdf.child("data");
    const EnvironmentSettings settings = settingsIn(context.sdf);
    Outcome<Environment> read = Environment::fromCsv(parameterFile(file, kLargestFile), settings);
    if (!read) refuse(file, "'" + data_ + "' can't be read: " + read.error);
    warnOfGaps(*read, settings, file, context.diagnostics);
    setEnvironment(std::move(*read));
  }

 private:
  void warnOfGaps(const Environment& read, const EnvironmentSettings& settings, const Element& file,
                  Diagnostics& diagnostics) const {
    if (read.missingPoints() > 0) {
      diagnostics.warning(file.position, "'" + data_ + "' lacks " + std::to_string(read.missingPoints()) +
                                             " points of its grid: they count as zero, as in Gazebo");
    }
    const auto [first, last] = read.times();
    if (settings.isStatic || first < last) return;
    std::ostringstream time;
    time << first;
    diagnostics.warning(file.position, "'" + data_ + "' has values for the time " + time.str() + " s only",
                        "for values at all times, write <dimensions><ignore_time>true</ignore_time></dimensions>");
  }

  std::string data_;
};

}  // namespace

}  // namespace pongsim

PONGSIM_EXPORT_SYSTEM(pongsim::EnvironmentPreload, "gz::sim::systems::EnvironmentPreload",
                      "ignition::gazebo::systems::EnvironmentPreload");
