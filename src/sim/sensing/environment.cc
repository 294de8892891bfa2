#include "pongsim/sensing/environment.hh"

#include <algorithm>
#include <numbers>
#include <tuple>
#include <utility>

#include "pongsim/geometry/geodesy.hh"
#include "pongsim/math.hh"
#include "sim/sensing/environment_table.hh"

namespace pongsim {

namespace {

constexpr double kDegree = std::numbers::pi / 180;
/// How far outside of the grid a place counts as on its edge, in units of the table, as in Gazebo.
constexpr double kTolerance = 1e-6;

/// Two neighbouring lines of a grid, and how near to the second.
struct Bracket {
  double first = 0;
  double second = 0;
  /// 0: at the first, 1: at the second.
  double weight = 0;
};

std::optional<Bracket> bracketOf(const std::vector<double>& lines, double value) {
  if (!(value > lines.front() - kTolerance && value < lines.back() + kTolerance)) return std::nullopt;
  const double inside = std::clamp(value, lines.front(), lines.back());
  const auto above = std::ranges::lower_bound(lines, inside);
  if (*above == inside) return Bracket{inside, inside, 0};
  const double below = *std::prev(above);
  return Bracket{below, *above, (inside - below) / (*above - below)};
}

/// Lexicographic order.
bool isBefore(const Vector3& a, const Vector3& b) {
  return std::tuple(a.x(), a.y(), a.z()) < std::tuple(b.x(), b.y(), b.z());
}

/// @return In the frame fixed to the earth [m].
Vector3 fixedToTheEarth(const GeodeticPosition& place) {
  // the plane where the zero meridian meets the equator: east is the earth's y, north its z, and up its x
  constexpr double kRadius = 6378137;  // of the equator (WGS84)
  const Vector3 local = TangentPlane({}, 0).positionOf(place);
  return {kRadius + local.z(), local.x(), local.y()};
}

}  // namespace

struct Environment::Table : sim::EnvironmentTable {};

Outcome<Environment> Environment::fromCsv(std::string_view csv, const EnvironmentSettings& settings) {
  Table table;
  if (Outcome<void> read = table.read(csv, settings); !read) return {{}, read.error};
  Environment environment;
  environment.settings_ = settings;
  environment.quantities_ = std::move(table.quantities);
  environment.addSlices(table);
  return {std::move(environment), {}};
}

void Environment::addSlices(Table& table) {
  using Row = sim::EnvironmentTable::Row;
  // stable: of two lines with the same time and place, the last counts
  std::ranges::stable_sort(table.rows, [](const Row& a, const Row& b) {
    return a.time < b.time || (a.time == b.time && isBefore(a.place, b.place));
  });
  values_.reserve(table.values.size());
  const std::size_t count = quantities_.size();
  for (std::size_t i = 0; i < table.rows.size(); ++i) {
    const Row& row = table.rows[i];
    const bool isRepeated =
        i + 1 < table.rows.size() && table.rows[i + 1].time == row.time && table.rows[i + 1].place == row.place;
    if (isRepeated) continue;
    if (slices_.empty() || slices_.back().time != row.time) {
      slices_.emplace_back().time = row.time;
      slices_.back().firstValue = values_.size();
    }
    slices_.back().points.push_back(row.place);
    const auto first = table.values.begin() + static_cast<std::ptrdiff_t>(row.index * count);
    values_.insert(values_.end(), first, first + static_cast<std::ptrdiff_t>(count));
  }
  for (Slice& slice : slices_) {
    double size = 1;
    for (std::size_t axis = 0; axis < 3; ++axis) {
      std::vector<double>& lines = slice.lines[axis];
      for (const Vector3& point : slice.points) lines.push_back(point[static_cast<Eigen::Index>(axis)]);
      std::ranges::sort(lines);
      lines.erase(std::ranges::unique(lines).begin(), lines.end());
      size *= static_cast<double>(lines.size());
    }
    missingPoints_ += static_cast<std::size_t>(std::min(size, 1e15)) - slice.points.size();
  }
}

std::optional<std::size_t> Environment::quantity(std::string_view name) const {
  const auto found = std::ranges::find(quantities_, name);
  if (found == quantities_.end()) return std::nullopt;
  return static_cast<std::size_t>(found - quantities_.begin());
}

std::pair<double, double> Environment::times() const { return {slices_.front().time, slices_.back().time}; }

std::optional<double> Environment::at(std::size_t quantity, Time time, const Vector3& place) const {
  if (settings_.isStatic) return at(slices_.front(), quantity, place);
  const double now = toSeconds(time);
  if (now < slices_.front().time || now > slices_.back().time) return std::nullopt;
  const auto next = std::ranges::lower_bound(slices_, now, {}, &Slice::time);
  const std::optional<double> after = at(*next, quantity, place);
  if (next->time == now) return after;
  const Slice& previous = *std::prev(next);
  const std::optional<double> before = at(previous, quantity, place);
  // as in Gazebo, one of two grids with the place is enough
  if (!before || !after) return before ? before : after;
  const double weight = (now - previous.time) / (next->time - previous.time);
  return (1 - weight) * *before + weight * *after;
}

double Environment::valueAt(const Slice& slice, std::size_t quantity, const Vector3& point) const {
  const auto found = std::ranges::lower_bound(slice.points, point, isBefore);
  if (found == slice.points.end() || *found != point) return 0;
  const auto index = static_cast<std::size_t>(found - slice.points.begin());
  return values_[slice.firstValue + index * quantities_.size() + quantity];
}

std::optional<double> Environment::at(const Slice& slice, std::size_t quantity, const Vector3& place) const {
  std::array<Bracket, 3> brackets;
  for (std::size_t axis = 0; axis < 3; ++axis) {
    const std::optional<Bracket> bracket = bracketOf(slice.lines[axis], place[static_cast<Eigen::Index>(axis)]);
    if (!bracket) return std::nullopt;
    brackets[axis] = *bracket;
  }
  // trilinear: each corner of the cell counts by the volume opposite to it
  double value = 0;
  for (unsigned corner = 0; corner < 8; ++corner) {
    double weight = 1;
    Vector3 point;
    for (std::size_t axis = 0; axis < 3; ++axis) {
      const Bracket& bracket = brackets[axis];
      const bool isSecond = (corner >> axis & 1U) != 0;
      weight *= isSecond ? bracket.weight : 1 - bracket.weight;
      point[static_cast<Eigen::Index>(axis)] = isSecond ? bracket.second : bracket.first;
    }
    if (weight > 0) value += weight * valueAt(slice, quantity, point);
  }
  return value;
}

std::optional<Vector3> Environment::placeOf(const Vector3& position, const World& world) const {
  using enum EnvironmentSettings::Reference;
  if (settings_.reference == kGlobal) {
    const auto [sine, cosine] = math::sinCos(world.heading());
    return Vector3(cosine * position.x() - sine * position.y(), sine * position.x() + cosine * position.y(),
                   position.z());
  }
  const std::optional<TangentPlane> plane = world.tangentPlane();
  if (!plane) return std::nullopt;
  const GeodeticPosition place = plane->at(position);
  if (settings_.reference == kEcef) return fixedToTheEarth(place);
  const double unit = settings_.isInDegrees ? kDegree : 1;
  return Vector3(place.latitude / unit, place.longitude / unit, place.altitude);
}

struct EnvironmentUser::Shared {
  std::optional<Environment> environment;
  std::uint64_t version = 0;
};

EnvironmentUser::EnvironmentUser() : shared_(std::make_shared<Shared>()) {}

EnvironmentUser::~EnvironmentUser() = default;

void EnvironmentUser::shareEnvironment(std::span<System* const> before) {
  for (System* const system : before) {
    const auto* other = dynamic_cast<const EnvironmentUser*>(system);
    if (other == nullptr) continue;
    shared_ = other->shared_;
    return;
  }
}

void EnvironmentUser::setEnvironment(Environment environment) {
  shared_->environment = std::move(environment);
  ++shared_->version;
}

const Environment* EnvironmentUser::environment() const {
  return shared_->environment ? &*shared_->environment : nullptr;
}

std::uint64_t EnvironmentUser::environmentVersion() const { return shared_->version; }

}  // namespace pongsim
