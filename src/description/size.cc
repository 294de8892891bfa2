#include "description/size.hh"

#include <cassert>
#include <cstddef>
#include <variant>

namespace pongsim::description {

namespace {

/// Calls `use` with each number of the size of a simple shape.
template <class Use>
struct EachNumber {
  Use use;

  void operator()(auto& shape) {
    if constexpr (requires { shape.radii; }) {
      for (int i = 0; i < 3; ++i) use(shape.radii[i]);
    } else if constexpr (requires(Box& box) { box = shape; }) {
      for (int i = 0; i < 3; ++i) use(shape.size[i]);
    } else if constexpr (requires(Sphere& sphere) { sphere = shape; }) {
      use(shape.radius);
    } else if constexpr (
        requires(Cylinder& cylinder) { cylinder = shape; } || requires(Capsule& capsule) { capsule = shape; }) {
      use(shape.radius);
      use(shape.length);
    }
  }
};

template <class Use>
EachNumber(Use) -> EachNumber<Use>;

}  // namespace

std::vector<double> sizeOf(const Geometry& geometry) {
  std::vector<double> size;
  std::visit(EachNumber{[&size](double number) { size.push_back(number); }}, geometry);
  return size;
}

void setSize(Geometry& geometry, std::span<const double> size) {
  assert(size.size() == sizeOf(geometry).size());
  std::size_t i = 0;
  std::visit(EachNumber{[&](double& number) { number = size[i++]; }}, geometry);
}

}  // namespace pongsim::description
