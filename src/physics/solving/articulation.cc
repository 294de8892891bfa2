#include "physics/solving/articulation.hh"

#include <algorithm>
#include <cassert>
#include <cmath>

#include "physics/lcp/four.hh"

namespace pongsim::physics {

namespace {

using Vector = Articulation::Vector;
using Inertia = Articulation::Inertia;
using Shift = Articulation::Shift;

constexpr std::size_t kRootCoordinates = 6;

[[gnu::always_inline]] inline Loose* lanesOf(Vector& v) { return reinterpret_cast<Loose*>(v.data()); }
[[gnu::always_inline]] inline const Loose* lanesOf(const Vector& v) { return reinterpret_cast<const Loose*>(v.data()); }

[[gnu::always_inline]] inline double product(const Vector& a, const Vector& b) {
  return ((a[0] * b[0] + a[1] * b[1]) + (a[2] * b[2] + a[3] * b[3])) + (a[4] * b[4] + a[5] * b[5]);
}

[[gnu::always_inline]] inline void addTo(Vector& to, double factor, const Vector& each) {
  Loose* const sum = lanesOf(to);
  const Loose* const x = lanesOf(each);
  sum[0] += factor * x[0];
  sum[1] += factor * x[1];
}

[[gnu::always_inline]] inline void multiply(const Inertia& inertia, const Vector& v, Vector& result) {
  Four first{}, last{};
  for (std::size_t row = 0; row < 6; ++row) {
    const Loose* const lanes = lanesOf(inertia[row]);
    first += v[row] * lanes[0];
    last += v[row] * lanes[1];
  }
  lanesOf(result)[0] = first;
  lanesOf(result)[1] = last;
}

/// Moves a wrench to a point further by r: L - r x P.
[[gnu::always_inline]] inline void moveWrench(Vector& p, const Shift& r) {
  p[3] += r[2] * p[1] - r[1] * p[2];
  p[4] += r[0] * p[2] - r[2] * p[0];
  p[5] += r[1] * p[0] - r[0] * p[1];
}

/// Moves a velocity from a point that is further by r: v + r x w.
[[gnu::always_inline]] inline void moveVelocity(Vector& v, const Shift& r) {
  v[0] += r[1] * v[5] - r[2] * v[4];
  v[1] += r[2] * v[3] - r[0] * v[5];
  v[2] += r[0] * v[4] - r[1] * v[3];
}

/// Moves an inertia to a point further by r: T^T I T, where T moves a velocity back.
[[gnu::always_inline]] inline void moveInertia(Inertia& I, const Shift& r) {
  for (std::size_t k = 0; k < 2; ++k) {
    const Four a = lanesOf(I[0])[k], b = lanesOf(I[1])[k], c = lanesOf(I[2])[k];
    lanesOf(I[3])[k] += r[2] * b - r[1] * c;
    lanesOf(I[4])[k] += r[0] * c - r[2] * a;
    lanesOf(I[5])[k] += r[1] * a - r[0] * b;
  }
  for (std::size_t row = 3; row < 6; ++row) {
    moveWrench(I[row], r);
    for (std::size_t column = 0; column < 3; ++column) I[column][row] = I[row][column];
  }
}

/// @return The motion at a centre of mass that lies at -arm from the joint.
Vector atCentre(const btVector3& linear, const btVector3& angular, const btVector3& arm, double sign) {
  const btVector3 v = sign * (linear + arm.cross(angular)), w = sign * angular;
  return {v.x(), v.y(), v.z(), w.x(), w.y(), w.z(), 0, 0};
}

/// Replaces the lower triangle by L, with the inverse of its diagonal.
[[gnu::always_inline]] inline bool factorRoot(Inertia& I) {
  for (std::size_t j = 0; j < 6; ++j) {
    double d = I[j][j];
    for (std::size_t k = 0; k < j; ++k) d -= I[j][k] * I[j][k];
    if (!(d > 0)) return false;
    const double inverse = I[j][j] = 1 / std::sqrt(d);
    for (std::size_t i = j + 1; i < 6; ++i) {
      double sum = I[i][j];
      for (std::size_t k = 0; k < j; ++k) sum -= I[i][k] * I[j][k];
      I[i][j] = sum * inverse;
    }
  }
  return true;
}

/// z = L^-1 p
[[gnu::always_inline]] inline void solveForward(const Inertia& L, const Vector& p, double* z) {
  for (std::size_t i = 0; i < 6; ++i) {
    double sum = p[i];
    for (std::size_t k = 0; k < i; ++k) sum -= L[i][k] * z[k];
    z[i] = sum * L[i][i];
  }
}

/// v = L^-T z
[[gnu::always_inline]] inline void solveBackward(const Inertia& L, const double* z, Vector& v) {
  for (std::size_t i = 6; i-- > 0;) {
    double sum = z[i];
    for (std::size_t k = i + 1; k < 6; ++k) sum -= L[k][i] * v[k];
    v[i] = sum * L[i][i];
  }
  v[6] = v[7] = 0;
}

/// Adds to the parent the inertia of a link, less what its joint lets move, and the wrench of what its joint asks for.
[[gnu::always_inline]] inline bool factorLink(const Articulation::Link& link, Articulation::Freedom* freedoms,
                                              double* own, Articulation::Body* bodies) {
  Inertia& I = bodies[link.body].inertia;
  Vector& p = bodies[link.body].wrench;
  for (std::size_t i = link.first; i < link.end; ++i) {
    Articulation::Freedom& freedom = freedoms[i];
    Vector U;
    multiply(I, freedom.S, U);
    const double D = product(freedom.S, U) + freedom.damping;
    if (!(D > 0)) return false;
    const double inverseD = 1 / D, u = product(freedom.S, p) + freedom.damping * freedom.target;
    freedom.inverseD = inverseD;
    freedom.scale = std::sqrt(inverseD);
    own[i] = u * freedom.scale;
    addTo(p, -u * inverseD, U);
    for (std::size_t row = 0; row < 6; ++row) addTo(I[row], -U[row] * inverseD, U);
    freedom.U = U;
  }
  if (link.parent < 0) return true;
  Vector ofBias;
  multiply(I, link.bias, ofBias);
  addTo(p, -1, ofBias);
  moveWrench(p, link.shift);
  moveInertia(I, link.shift);
  Articulation::Body& parent = bodies[link.parent];
  addTo(parent.wrench, 1, p);
  for (std::size_t row = 0; row < 6; ++row) addTo(parent.inertia[row], 1, I[row]);
  return true;
}

PONGSIM_WIDE bool factorLinks(const Articulation::Link* links, std::size_t count, Articulation::Freedom* freedoms,
                              double* own, Articulation::Body* bodies) {
  for (std::size_t number = count; number-- > 0;) {
    if (!factorLink(links[number], freedoms, own, bodies)) return false;
  }
  return true;
}

PONGSIM_WIDE void moveLinks(const Articulation::Link* links, std::size_t count, const Articulation::Freedom* freedoms,
                            const double* z, bool isByJoints, Vector* changes) {
  for (std::size_t number = 0; number < count; ++number) {
    const Articulation::Link& link = links[number];
    Vector v{};
    if (link.parent >= 0) {
      v = changes[link.parent];
      moveVelocity(v, link.shift);
    }
    if (isByJoints) addTo(v, 1, link.bias);
    for (std::size_t i = link.end; i-- > link.first;) {
      const Articulation::Freedom& freedom = freedoms[i];
      addTo(v, z[i] * freedom.scale - product(freedom.U, v) * freedom.inverseD, freedom.S);
    }
    changes[link.body] = v;
  }
}

/// A wrench on its way to the root.
struct Climber {
  int body;
  /// Of the body.
  int link;
  Vector wrench;
};

/// Takes it past links behind `limit`; to the body -1 beyond a link that is held to the world.
PONGSIM_WIDE void climb(const Articulation::Link* links, const Articulation::Freedom* freedoms, int limit,
                        Climber& climber, double* z) {
  Vector p = climber.wrench;
  while (climber.link > limit) {
    const Articulation::Link& link = links[climber.link];
    for (std::size_t i = link.first; i < link.end; ++i) {
      const Articulation::Freedom& freedom = freedoms[i];
      const double u = product(freedom.S, p);
      z[i] = u * freedom.scale;
      addTo(p, -u * freedom.inverseD, freedom.U);
    }
    climber.body = link.parent;
    climber.link = link.next;
    if (link.parent >= 0) moveWrench(p, link.shift);
  }
  climber.wrench = p;
}

PONGSIM_WIDE void addSquareOf(const double* Z, std::size_t width, const int* places, std::size_t count,
                              const UpperRows& A) {
  for (std::size_t i = 0; i < count; ++i) {
    const double* const row = Z + i * width;
    for (std::size_t j = 0; j <= i; j += 4) {
      const std::size_t others = std::min(i - j + 1, std::size_t{4});
      const auto at = [&](std::size_t number, std::size_t k) -> const Four& {
        return *reinterpret_cast<const Four*>(Z + (j + std::min(number, others - 1)) * width + k);
      };
      Four a{}, b{}, c{}, d{}, sums;
      for (std::size_t k = 0; k < width; k += 4) {
        const Four own = *reinterpret_cast<const Four*>(row + k);
        a += own * at(0, k);
        b += own * at(1, k);
        c += own * at(2, k);
        d += own * at(3, k);
      }
      sumUp(a, b, c, d, sums);
      for (std::size_t r = 0; r < others; ++r) {
        const int first = std::min(places[i], places[j + r]), second = std::max(places[i], places[j + r]);
        A.row(static_cast<std::size_t>(first))[second] += sums[r];
      }
    }
  }
}

}  // namespace

void addSquare(const double* Z, std::size_t width, std::span<const int> places, const UpperRows& A) {
  addSquareOf(Z, width, places.data(), places.size(), A);
}

void Articulation::begin(const JointTree& tree, std::size_t bodies) {
  tree_ = &tree;
  bodies_.resize(bodies);
  links_.clear();
  links_.reserve(tree.links().size());
  freedoms_.clear();
}

void Articulation::add(const JointTree::Link& link, const JointMotion& motion, const btVector3& linear,
                       const btVector3& angular) {
  const btVector3& arm = link.isReversed ? motion.parentArm : motion.childArm;
  const btVector3 shift = arm - (link.isReversed ? motion.childArm : motion.parentArm);
  const double sign = link.isReversed ? -1 : 1;
  Link& added = links_.emplace_back();
  added.body = link.body;
  added.parent = link.parent;
  added.next = link.parent < 0 ? -1 : tree_->linkOf(link.parent);
  added.shift = {shift.x(), shift.y(), shift.z()};
  added.bias = atCentre(motion.linear - linear, motion.angular - angular, arm, sign);
  added.first = freedoms_.size();
  for (std::size_t i = 0; i < motion.count; ++i) {
    const JointMotion::Freedom& each = motion.freedoms[i];
    Freedom& freedom = freedoms_.emplace_back();
    freedom.S = atCentre(each.linear, each.angular, arm, sign);
    freedom.damping = each.damping;
    freedom.target = each.velocity;
  }
  added.end = freedoms_.size();
}

bool Articulation::factor() {
  assert(links_.size() == tree_->links().size());
  std::size_t coordinates = freedoms_.size();
  for (std::size_t i = 0; i < bodies_.size(); ++i) {
    Body& body = bodies_[i];
    body.wrench.fill(0);
    body.isRoot = tree_->linkOf(static_cast<int>(i)) < 0;
    body.first = coordinates;
    if (body.isRoot) coordinates += kRootCoordinates;
  }
  width_ = widthFor(coordinates);
  own_.assign(width_, 0.0);
  if (!factorLinks(links_.data(), links_.size(), freedoms_.data(), own_.data(), bodies_.data())) return false;
  for (Body& body : bodies_) {
    if (!body.isRoot) continue;
    if (!factorRoot(body.inertia)) return false;
    solveForward(body.inertia, body.wrench, &own_[body.first]);
  }
  return true;
}

void Articulation::resolve(std::span<const End> ends, double* z) const {
  std::array<Climber, 3> climbers;
  std::size_t count = 0;
  assert(ends.size() <= climbers.size());
  const auto joinAnother = [&](std::size_t one) {
    for (std::size_t i = 0; i < count; ++i) {
      if (i == one || climbers[i].body != climbers[one].body) continue;
      addTo(climbers[i].wrench, 1, climbers[one].wrench);
      return true;
    }
    return false;
  };
  for (const End& end : ends) {
    climbers[count] = {end.body, tree_->linkOf(end.body), {}};
    std::copy_n(end.jacobian, 6, climbers[count].wrench.begin());
    if (!joinAnother(count)) ++count;
  }
  // from the link that is farthest out, so that what meets goes on together
  while (count > 0) {
    const auto later = [](const Climber& a, const Climber& b) { return a.link < b.link; };
    std::sort(climbers.begin(), climbers.begin() + static_cast<std::ptrdiff_t>(count), later);
    Climber& last = climbers[count - 1];
    if (last.link < 0) {
      const Body& root = bodies_[static_cast<std::size_t>(last.body)];
      solveForward(root.inertia, last.wrench, z + root.first);
      --count;
      continue;
    }
    climb(links_.data(), freedoms_.data(), count > 1 ? climbers[count - 2].link : -1, last, z);
    if (last.body < 0 || joinAnother(count - 1)) --count;
  }
}

std::span<const Articulation::Vector> Articulation::change(std::span<const double> z, bool isByJoints) {
  changes_.resize(bodies_.size());
  for (std::size_t i = 0; i < bodies_.size(); ++i) {
    if (bodies_[i].isRoot) solveBackward(bodies_[i].inertia, &z[bodies_[i].first], changes_[i]);
  }
  moveLinks(links_.data(), links_.size(), freedoms_.data(), z.data(), isByJoints, changes_.data());
  return changes_;
}

void Articulation::gather(std::span<Vector> wrenches) const {
  for (std::size_t number = links_.size(); number-- > 0;) {
    const Link& link = links_[number];
    if (link.parent < 0) continue;
    Vector p = wrenches[static_cast<std::size_t>(link.body)];
    moveWrench(p, link.shift);
    addTo(wrenches[static_cast<std::size_t>(link.parent)], 1, p);
  }
}

}  // namespace pongsim::physics
