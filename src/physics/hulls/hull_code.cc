#include "physics/hulls/hull_code.hh"

#include <bit>
#include <cmath>
#include <cstddef>
#include <cstdint>

namespace pongsim::physics {

namespace {

constexpr std::uint64_t kMostHulls = 1000;

void append(std::uint64_t number, std::string& to) {
  for (unsigned shift = 0; shift < 64; shift += 8) to += static_cast<char>(number >> shift & 0xffU);
}

void append(double number, std::string& to) { append(std::bit_cast<std::uint64_t>(number), to); }

/// Reads numbers of eight bytes each.
class Reader {
 public:
  explicit Reader(std::string_view bytes) : rest_(bytes) {}

  std::optional<std::uint64_t> number() {
    if (rest_.size() < 8) return std::nullopt;
    std::uint64_t number = 0;
    for (unsigned i = 0; i < 8; ++i) number |= std::uint64_t{static_cast<std::uint8_t>(rest_[i])} << (8 * i);
    rest_.remove_prefix(8);
    return number;
  }

  std::optional<double> finite() {
    const std::optional<std::uint64_t> bits = number();
    if (!bits || !std::isfinite(std::bit_cast<double>(*bits))) return std::nullopt;
    return std::bit_cast<double>(*bits);
  }

  std::optional<Vector3> vector() {
    const std::optional<double> x = finite(), y = finite(), z = finite();
    if (!x || !y || !z) return std::nullopt;
    return Vector3(*x, *y, *z);
  }

  bool atEnd() const { return rest_.empty(); }

 private:
  std::string_view rest_;
};

std::optional<Hull> readHull(Reader& reader) {
  const std::optional<double> margin = reader.finite();
  const std::optional<std::uint64_t> count = reader.number();
  if (!margin || *margin < 0 || !count || *count == 0 || *count > kMostCorners) return std::nullopt;
  Hull hull{{}, *margin};
  for (std::uint64_t i = 0; i < *count; ++i) {
    const std::optional<Vector3> corner = reader.vector();
    if (!corner) return std::nullopt;
    hull.corners.push_back(*corner);
  }
  return hull;
}

}  // namespace

std::string encodeHulls(const std::vector<Hull>& hulls) {
  std::string bytes;
  append(std::uint64_t{hulls.size()}, bytes);
  for (const Hull& hull : hulls) {
    append(hull.margin, bytes);
    append(std::uint64_t{hull.corners.size()}, bytes);
    for (const Vector3& corner : hull.corners) {
      for (const double value : {corner.x(), corner.y(), corner.z()}) append(value, bytes);
    }
  }
  return bytes;
}

std::optional<std::vector<Hull>> decodeHulls(std::string_view bytes) {
  Reader reader(bytes);
  const std::optional<std::uint64_t> count = reader.number();
  if (!count || *count == 0 || *count > kMostHulls) return std::nullopt;
  std::vector<Hull> hulls;
  for (std::uint64_t i = 0; i < *count; ++i) {
    std::optional<Hull> hull = readHull(reader);
    if (!hull) return std::nullopt;
    hulls.push_back(std::move(*hull));
  }
  if (!reader.atEnd()) return std::nullopt;
  return hulls;
}

}  // namespace pongsim::physics
