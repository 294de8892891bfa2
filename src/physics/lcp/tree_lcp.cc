#include "physics/lcp/tree_lcp.hh"

#include <algorithm>
#include <cstddef>

namespace pongsim::physics {

bool TreeLcp::solve(const Bounds& bounds, std::span<double> x) {
  bounds_ = bounds;
  if (!matrix_.eliminate()) return false;
  std::ranges::fill(x, 0.0);
  takeReduced();
  if (count_ > 0 && !lcp_.solve(rest(count_, b_.data()), found_.data())) return false;
  place(count_, x);
  matrix_.substitute(0, x.data());
  return true;
}

bool TreeLcp::solveSecond(std::span<double> x) {
  const int rows = bounds_.unfrictionalRows;
  std::ranges::fill(x, 0.0);
  if (rows > 0 && !lcp_.solveWithSameMatrix(rest(rows, b2_.data()), found_.data())) return false;
  place(rows, x);
  matrix_.substitute(1, x.data());
  return true;
}

void TreeLcp::takeReduced() {
  const UpperRows left = matrix_.bounded();
  const std::size_t count = left.rows;
  count_ = static_cast<int>(count);
  A_.resize(count * count);
  for (std::vector<double>* each : {&b_, &b2_, &found_}) each->resize(count);
  for (std::size_t i = 0; i < count; ++i) {
    const auto row = static_cast<std::size_t>(matrix_.boundedNumber(static_cast<int>(i)));
    b_[i] = left.row(row)[count];
    b2_[i] = left.row(row)[count + 1];
    for (std::size_t j = 0; j <= i; ++j) {
      const auto other = static_cast<std::size_t>(matrix_.boundedNumber(static_cast<int>(j)));
      A_[i * count + j] = A_[j * count + i] = left.row(std::min(row, other))[std::max(row, other)];
    }
  }
}

Lcp::Problem TreeLcp::rest(int rows, const double* b) const {
  return {rows, A_.data(), count_, b, bounds_.lowest, bounds_.highest, bounds_.normalOf};
}

/// Copies the solution of the first bounded rows to their places in x.
void TreeLcp::place(int rows, std::span<double> x) const {
  const int bounded = matrix_.boundedPlace();
  for (int row = 0; row < rows; ++row) {
    x[static_cast<std::size_t>(matrix_.indexOf(bounded, matrix_.boundedNumber(row)))] =
        found_[static_cast<std::size_t>(row)];
  }
}

}  // namespace pongsim::physics
