#include "physics/solving/block_rows.hh"

#include <algorithm>
#include <utility>

#include "physics/lcp/four.hh"

namespace pongsim::physics {

namespace {

using End = BlockRows::End;
using RowValues = BlockRows::RowValues;
using Motion = BlockRows::Motion;

[[gnu::always_inline]] inline Loose& fourOf(RowValues& values, std::size_t first) {
  return *reinterpret_cast<Loose*>(values.data() + first);
}
[[gnu::always_inline]] inline const Loose& fourOf(const RowValues& values, std::size_t first) {
  return *reinterpret_cast<const Loose*>(values.data() + first);
}

PONGSIM_WIDE void respondAll(End& end, const BlockRows::Inertia& inertia, const Motion& velocity, RowValues& along) {
  const auto& I = inertia.inverseMoments;
#pragma GCC unroll 2
  for (std::size_t k = 0; k < BlockRows::kMostRows; k += 4) {
    Loose d[6];
#pragma GCC unroll 6
    for (std::size_t c = 0; c < 6; ++c) d[c] = fourOf(end.jacobian[c], k);
    fourOf(along, k) = (velocity[0] * d[0] + velocity[2] * d[2] + velocity[4] * d[4]) +
                       (velocity[1] * d[1] + velocity[3] * d[3] + velocity[5] * d[5]);
#pragma GCC unroll 3
    for (std::size_t c = 0; c < 3; ++c) {
      fourOf(end.response[c], k) = inertia.inverseMass * d[c];
      fourOf(end.response[c + 3], k) = I[3 * c] * d[3] + I[3 * c + 1] * d[4] + I[3 * c + 2] * d[5];
    }
  }
}

/// Adds J_b M^-1 J_a^T.
[[gnu::always_inline]] inline void coupleLanes(const End& a, std::size_t rowsOfA, const End& b, std::size_t end,
                                               double* to, std::size_t stride) {
  for (std::size_t k = 0; k < end; k += 4) {
    Loose d[6];
#pragma GCC unroll 6
    for (std::size_t c = 0; c < 6; ++c) d[c] = fourOf(b.jacobian[c], k);
    for (std::size_t i = 0; i < rowsOfA; ++i) {
      Four& sum = *reinterpret_cast<Four*>(to + i * stride + k);
      sum += (a.response[0][i] * d[0] + a.response[1][i] * d[1] + a.response[2][i] * d[2]) +
             (a.response[3][i] * d[3] + a.response[4][i] * d[4] + a.response[5][i] * d[5]);
    }
  }
}

/// Of all ends at a body, the last of which is `end`.
PONGSIM_WIDE void coupleAll(const End* ends, const End& end, const JointOrder& order, const int* rows, BlockMatrix& A) {
  const auto rowsOf = [rows](const End& each) { return static_cast<std::size_t>(rows[each.joint]); };
  const auto add = [&](const End& a, const End& b, const BlockMatrix::Block& block) {
    coupleLanes(a, rowsOf(a), b, rowsOf(b), block.data, block.stride);
  };
  for (const End* a = &end;; a = ends + a->before) {
    const int placeOfA = order.placeOf(a->joint);
    add(*a, *a, A.block(placeOfA, placeOfA));
    for (int i = a->before; i >= 0; i = ends[i].before) {
      const End& b = ends[i];
      const int placeOfB = order.placeOf(b.joint);
      const BlockMatrix::Block block = A.block(std::min(placeOfA, placeOfB), std::max(placeOfA, placeOfB));
      if (placeOfA <= placeOfB) add(*a, b, block);
      // a gearbox may have two ends at one body: their product counts twice on the diagonal
      if (placeOfB <= placeOfA) add(b, *a, block);
    }
    if (a->before < 0) break;
  }
}

PONGSIM_WIDE void answer(const End& end, const Motion& response, RowValues& sums) {
#pragma GCC unroll 2
  for (std::size_t k = 0; k < BlockRows::kMostRows; k += 4) {
    Loose sum = response[0] * fourOf(end.jacobian[0], k);
#pragma GCC unroll 6
    for (std::size_t c = 1; c < 6; ++c) sum += response[c] * fourOf(end.jacobian[c], k);
    fourOf(sums, k) = sum;
  }
}

PONGSIM_WIDE void addImpulses(const End& end, const double* x, std::size_t values, Motion& change) {
  Four sums[8] = {};
  for (std::size_t k = 0; k < values; k += 4) {
    const Loose impulse = *reinterpret_cast<const Loose*>(x + k);
#pragma GCC unroll 6
    for (std::size_t c = 0; c < 6; ++c) sums[c] += fourOf(end.response[c], k) * impulse;
  }
  Four first, second;
  sumUp(sums[0], sums[1], sums[2], sums[3], first);
  sumUp(sums[4], sums[5], sums[6], sums[7], second);
  for (std::size_t c = 0; c < 4; ++c) change[c] += first[c];
  for (std::size_t c = 0; c < 2; ++c) change[c + 4] += second[c];
}

}  // namespace

void BlockRows::begin(std::size_t bodies, std::size_t ends) {
  count_ = 0;
  ends_.resize(std::max(ends_.size(), ends));
  last_.assign(bodies, -1);
}

BlockRows::End& BlockRows::add(int joint, int body) {
  End& end = ends_[count_];
  for (RowValues& values : end.jacobian) values.fill(0);
  end.joint = joint;
  end.body = body;
  end.before = std::exchange(last_[static_cast<std::size_t>(body)], static_cast<int>(count_));
  ++count_;
  return end;
}

BlockRows::RowValues BlockRows::respond(End& end, const Inertia& inertia, const Motion& velocity) {
  RowValues along;
  respondAll(end, inertia, velocity, along);
  return along;
}

void BlockRows::couple(const JointOrder& order, std::span<const int> rows, BlockMatrix& A) const {
  for (const int last : last_) {
    if (last >= 0) coupleAll(ends_.data(), ends_[static_cast<std::size_t>(last)], order, rows.data(), A);
  }
}

void BlockRows::couple(const JointOrder& order, std::span<const int> rows, int body, const Motion& response, int number,
                       BlockMatrix& A) const {
  RowValues sums;
  for (int i = last_[static_cast<std::size_t>(body)]; i >= 0;) {
    const End& end = ends_[static_cast<std::size_t>(i)];
    answer(end, response, sums);
    const BlockMatrix::Block block = A.block(order.placeOf(end.joint), A.boundedPlace());
    double* to = block.data + number;
    for (int row = 0; row < rows[static_cast<std::size_t>(end.joint)]; ++row, to += block.stride) {
      *to += sums[static_cast<std::size_t>(row)];
    }
    i = end.before;
  }
}

void BlockRows::apply(int body, const JointOrder& order, const BlockMatrix& A, const double* x, Motion& change) const {
  for (int i = last_[static_cast<std::size_t>(body)]; i >= 0;) {
    const End& end = ends_[static_cast<std::size_t>(i)];
    const int place = order.placeOf(end.joint);
    addImpulses(end, x + A.indexOf(place, 0), A.paddedRowsAt(place), change);
    i = end.before;
  }
}

}  // namespace pongsim::physics
