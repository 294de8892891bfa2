#include "physics/lcp/lcp.hh"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <cstddef>
#include <limits>

#include "physics/lcp/dot.hh"
#include "physics/lcp/elimination.hh"

namespace pongsim::physics {

namespace {

constexpr double kUnbounded = std::numeric_limits<double>::infinity();

/// Up to that many rows, elimination from scratch is cheaper than keeping factors up to date.
constexpr int kFewRows = 32;

/// Rounds after which more seldom help.
constexpr int kMostRounds = 8;

/// Pivots after which a row is cycling.
int mostPivots(int rows) { return 30 + 3 * rows; }

}  // namespace

bool Lcp::solve(const Problem& problem, double* x) {
  begin(problem, x);
  isSmall_ = problem.rows <= kFewRows;
  if (solveByRounds(0)) return true;
  begin(problem, x);
  isSmall_ = false;
  return solveByPivots();
}

bool Lcp::solveWithSameMatrix(const Problem& problem, double* x) {
  const std::size_t before = rows_;
  const std::size_t factored = isSmall_ ? 0 : factoredRows(static_cast<std::size_t>(problem.rows));
  begin(problem, x);
  // rows of factors lie as far apart as there are rows
  for (std::size_t row = 1; row < factored; ++row) std::copy_n(&L_[row * before], row, factorRow(row));
  if (solveByRounds(factored)) return true;
  begin(problem, x);
  isSmall_ = false;
  return solveByPivots();
}

/// @return How many rows, from the first one on, stand in the factors at their own places, but for rows that the new
/// problem, of `rows` rows, does not have.
std::size_t Lcp::factoredRows(std::size_t rows) const {
  std::size_t count = 0;
  while (count < std::min(free_.size(), rows) && free_[count] == static_cast<int>(count)) ++count;
  return count;
}

/// @param factored So many rows, from the first one on, have their factors already.
bool Lcp::solveByRounds(std::size_t factored) {
  // first without friction, whose bounds follow from that
  const int* const end = problem_.normalOf + rows_;
  const auto frictional =
      static_cast<int>(std::find_if(problem_.normalOf, end, [](int row) { return row >= 0; }) - problem_.normalOf);
  if (!settle(0, frictional, factored)) return false;
  if (frictional == problem_.rows) return true;
  setFrictionBounds();
  return settle(frictional, problem_.rows, 0);
}

/// Adds the rows from `first` to `end` to those that are settled, and settles them all anew.
bool Lcp::settle(int first, int end, std::size_t factored) {
  freed_.clear();
  for (int row = first; row < end; ++row) {
    const auto i = static_cast<std::size_t>(row);
    if (lowest_[i] == 0 && highest_[i] == 0) {
      setBound(row, State::kLowest);
      // those behind it move up
      factored = std::min(factored, i);
    } else if (i < factored) {
      free_.push_back(row);
      states_[i] = State::kFree;
    } else {
      freed_.push_back(row);
    }
  }
  if (!setFree(freed_)) return false;
  for (int round = 0; round < kMostRounds; ++round) {
    if (!solveFree()) return false;
    listViolations(end);
    if (violations_.empty()) return true;
    if (round == 0) dropRelieved();
    for (const auto& [row, state] : violations_) {
      if (state != State::kFree) {
        setBound(row, state);
      } else if (isSmall_) {
        states_[static_cast<std::size_t>(row)] = State::kFree;
      } else if (!setFree(row)) {
        return false;
      }
    }
  }
  return false;
}

/// Sets the free x so that their w are zero.
/// @return False where A is not positive definite.
bool Lcp::solveFree() {
  if (isSmall_) return solveFreeAfresh();
  values_.clear();
  for (const int row : free_) values_.push_back(problem_.b[row]);
  for (std::size_t k = 0; k < rows_; ++k) {
    if (states_[k] == State::kFree || states_[k] == State::kOut || x_[k] == 0) continue;
    const double* const A = rowOfA(k);
    for (std::size_t i = 0; i < free_.size(); ++i) values_[i] -= A[free_[i]] * x_[k];
  }
  solveFactors(values_);
  for (std::size_t i = 0; i < free_.size(); ++i) x_[free_[i]] = values_[i];
  return true;
}

bool Lcp::solveFreeAfresh() {
  free_.clear();
  bound_.clear();
  for (std::size_t row = 0; row < rows_; ++row) {
    if (states_[row] == State::kFree) {
      free_.push_back(static_cast<int>(row));
    } else if (states_[row] != State::kOut) {
      bound_.push_back(static_cast<int>(row));
    }
  }
  const std::size_t count = free_.size();
  const UpperRows upper{U_.data(), widthFor(count + 1), count};
  for (std::size_t i = 0; i < count; ++i) {
    double* const to = upper.row(i);
    const double* const A = rowOfA(static_cast<std::size_t>(free_[i]));
    std::fill(to + count, to + upper.width, 0.0);
    for (std::size_t j = i; j < count; ++j) to[j] = A[free_[j]];
    double b = problem_.b[free_[i]];
    for (const int k : bound_) b -= A[k] * x_[k];
    to[count] = b;
  }
  if (!eliminate(upper, count, inverseD_.data())) return false;
  values_.resize(count);
  substitute(upper, inverseD_.data(), 0, count, count, count, values_.data());
  for (std::size_t i = 0; i < count; ++i) x_[free_[i]] = values_[i];
  return true;
}

/// Lists the rows before `end` that do not meet their condition, and what they should become.
void Lcp::listViolations(int end) {
  violations_.clear();
  for (int row = 0; row < end; ++row) {
    const auto i = static_cast<std::size_t>(row);
    if (states_[i] == State::kFree) {
      if (x_[i] < lowest_[i]) violations_.emplace_back(row, State::kLowest);
      if (x_[i] > highest_[i]) violations_.emplace_back(row, State::kHighest);
    } else if (lowest_[i] != highest_[i]) {
      const double w = dot(rowOfA(i), x_, static_cast<std::size_t>(end)) - problem_.b[row];
      if (states_[i] == State::kLowest ? w < 0 : w > 0) violations_.emplace_back(row, State::kFree);
    }
  }
}

/// If two rows exceed their bounds in opposite directions, but their sum stays within both bounds, as with the two
/// wheels of an axle, setting one to its bound relieves the other. So only the one with the narrower bounds is set.
void Lcp::dropRelieved() {
  const auto isRelieved = [this](int row, State state, int other, State otherState) {
    const bool isOpposed = (state == State::kLowest && otherState == State::kHighest) ||
                           (state == State::kHighest && otherState == State::kLowest);
    if (!isOpposed) return false;
    const auto bound = [this](int each, State side) {
      return std::abs((side == State::kLowest ? lowest_ : highest_)[static_cast<std::size_t>(each)]);
    };
    const double room = bound(row, state), otherRoom = bound(other, otherState);
    return std::pair(room, row) > std::pair(otherRoom, other) && std::abs(x_[row] + x_[other]) < room + otherRoom;
  };
  for (auto& [row, state] : violations_) {
    for (const auto& [other, otherState] : violations_) {
      if (isRelieved(row, state, other, otherState)) state = State::kOut;
    }
  }
  std::erase_if(violations_, [](const std::pair<int, State>& change) { return change.second == State::kOut; });
}

bool Lcp::solveByPivots() {
  for (std::vector<double>* each : {&w_, &dx_, &dw_}) each->assign(rows_, 0);
  if (!solveUnbounded()) return false;
  bool hasFriction = false;
  for (int row = 0; row < problem_.rows; ++row) {
    if (states_[static_cast<std::size_t>(row)] != State::kOut) continue;
    if (problem_.normalOf[row] >= 0 && !hasFriction) {
      hasFriction = true;
      setFrictionBounds();
    }
    if (!drive(row)) return false;
  }
  return true;
}

void Lcp::begin(const Problem& problem, double* x) {
  assert(problem.rows >= 0 && problem.stride >= problem.rows);
  assert(std::is_partitioned(problem.normalOf, problem.normalOf + problem.rows, [](int row) { return row < 0; }));
  problem_ = problem;
  x_ = x;
  rows_ = static_cast<std::size_t>(problem.rows);
  std::fill(x, x + rows_, 0.0);
  states_.assign(rows_, State::kOut);
  lowest_.assign(problem.lowest, problem.lowest + rows_);
  highest_.assign(problem.highest, problem.highest + rows_);
  free_.clear();
  free_.reserve(rows_);
  L_.resize(std::max(L_.size(), rows_ * rows_));
  U_.resize(std::max(U_.size(), rows_ * widthFor(rows_ + 1)));
  D_.resize(std::max(D_.size(), rows_));
  inverseD_.resize(D_.size());
  for (std::vector<double>* each : {&w_, &dx_, &dw_}) each->reserve(rows_);
  values_.reserve(4 * rows_);
  freed_.reserve(rows_);
  bound_.reserve(rows_);
}

// equations are free at all times
bool Lcp::solveUnbounded() {
  freed_.clear();
  for (int row = 0; row < problem_.rows; ++row) {
    const auto i = static_cast<std::size_t>(row);
    if (problem_.normalOf[row] < 0 && lowest_[i] == -kUnbounded && highest_[i] == kUnbounded) freed_.push_back(row);
  }
  if (!setFree(freed_)) return false;
  values_.clear();
  for (const int row : free_) values_.push_back(problem_.b[row]);
  solveFactors(values_);
  for (std::size_t i = 0; i < free_.size(); ++i) x_[free_[i]] = values_[i];
  return true;
}

void Lcp::setFrictionBounds() {
  for (std::size_t i = 0; i < rows_; ++i) {
    if (problem_.normalOf[i] < 0) continue;
    const double normal = std::abs(x_[problem_.normalOf[i]]);
    // infinity times zero: without a normal force there is no friction
    lowest_[i] = normal > 0 ? lowest_[i] * normal : 0;
    highest_[i] = normal > 0 ? highest_[i] * normal : 0;
  }
}

bool Lcp::drive(int row) {
  const auto i = static_cast<std::size_t>(row);
  w_[i] = dot(rowOfA(i), x_, rows_) - problem_.b[row];
  if (lowest_[i] == 0 && w_[i] >= 0) {
    setBound(row, State::kLowest);
    return true;
  }
  if (highest_[i] == 0 && w_[i] <= 0) {
    setBound(row, State::kHighest);
    return true;
  }
  for (int pivots = 0; pivots < mostPivots(problem_.rows); ++pivots) {
    if (w_[i] == 0) return setFree(row);
    const double direction = w_[i] < 0 ? 1 : -1;
    computeDirection(row, direction);
    if (!(direction * dw_[i] > 0)) return false;
    const Move way = ratioTest(row, direction);
    for (std::size_t k = 0; k < rows_; ++k) {
      x_[k] += way.length * dx_[k];
      w_[k] += way.length * dw_[k];
    }
    if (way.becomes == State::kFree) {
      w_[static_cast<std::size_t>(way.row)] = 0;
      if (!setFree(way.row)) return false;
    } else {
      setBound(way.row, way.becomes);
    }
    if (way.row == row) return true;
  }
  return false;
}

/// Sets how the free x follow where the row's x goes into the direction, and what that does to w of the others.
void Lcp::computeDirection(int row, double direction) {
  const double* const A = rowOfA(static_cast<std::size_t>(row));
  values_.clear();
  for (const int each : free_) values_.push_back(-direction * A[each]);
  solveFactors(values_);
  std::fill(dx_.begin(), dx_.end(), 0.0);
  for (std::size_t i = 0; i < free_.size(); ++i) dx_[static_cast<std::size_t>(free_[i])] = values_[i];
  dx_[static_cast<std::size_t>(row)] = direction;
  for (std::size_t k = 0; k < rows_; ++k) {
    const bool counts =
        states_[k] == State::kLowest || states_[k] == State::kHighest || k == static_cast<std::size_t>(row);
    dw_[k] = counts ? dot(rowOfA(k), dx_.data(), rows_) : 0;
  }
}

Lcp::Move Lcp::ratioTest(int row, double direction) const {
  const auto i = static_cast<std::size_t>(row);
  Move way{-w_[i] / dw_[i], row, State::kFree};
  if (direction > 0) {
    shorten(way, row, highest_[i] - x_[i], State::kHighest);
  } else {
    shorten(way, row, x_[i] - lowest_[i], State::kLowest);
  }
  for (std::size_t k = 0; k < rows_; ++k) {
    const int other = static_cast<int>(k);
    if (states_[k] == State::kFree) {
      if (dx_[k] < 0) shorten(way, other, (lowest_[k] - x_[k]) / dx_[k], State::kLowest);
      if (dx_[k] > 0) shorten(way, other, (highest_[k] - x_[k]) / dx_[k], State::kHighest);
    } else if (lowest_[k] != highest_[k]) {
      const bool leaves = (states_[k] == State::kLowest && dw_[k] < 0) || (states_[k] == State::kHighest && dw_[k] > 0);
      if (leaves) shorten(way, other, -w_[k] / dw_[k], State::kFree);
    }
  }
  return way;
}

void Lcp::shorten(Move& way, int row, double length, State becomes) const {
  // rounding may have taken it beyond already
  length = std::max(length, 0.0);
  if (length < way.length) way = {length, row, becomes};
}

/// @return False where A is not positive definite.
bool Lcp::setFree(int row) {
  const double* const A = rowOfA(static_cast<std::size_t>(row));
  const std::size_t place = free_.size();
  double* const l = factorRow(place);
  for (std::size_t j = 0; j < place; ++j) l[j] = A[free_[j]] - dot(l, factorRow(j), j);
  double d = A[row];
  for (std::size_t j = 0; j < place; ++j) {
    const double unscaled = l[j];
    l[j] *= inverseD_[j];
    d -= unscaled * l[j];
  }
  return addFactor(row, d);
}

/// As for one row after the other: each of their numbers waits for the one before it, and in the meantime goes on with
/// those of the others.
template <std::size_t kCount>
bool Lcp::setFreeTogether(const int* rows) {
  const std::size_t first = free_.size();
  // the rows of L D side by side
  values_.resize(kCount * (first + kCount));
  double* const u = values_.data();
  for (std::size_t j = 0; j < first + kCount; ++j) {
    double* const l = factorRow(j);
    if (j >= first) {
      for (std::size_t k = 0; k < j; ++k) l[k] = u[kCount * k + j - first] * inverseD_[k];
    }
    double even[kCount] = {};
    double odd[kCount] = {};
    std::size_t k = 0;
    for (; k + 2 <= j; k += 2) {
      for (std::size_t r = 0; r < kCount; ++r) even[r] += u[kCount * k + r] * l[k];
      for (std::size_t r = 0; r < kCount; ++r) odd[r] += u[kCount * (k + 1) + r] * l[k + 1];
    }
    if (k < j) {
      for (std::size_t r = 0; r < kCount; ++r) even[r] += u[kCount * k + r] * l[k];
    }
    const int column = j < first ? free_[j] : rows[j - first];
    for (std::size_t r = 0; r < kCount; ++r) {
      u[kCount * j + r] = rowOfA(static_cast<std::size_t>(rows[r]))[column] - (even[r] + odd[r]);
    }
    if (j < first) continue;
    if (!addFactor(rows[j - first], u[kCount * j + j - first])) return false;
  }
  return true;
}

/// @return False where A is not positive definite.
bool Lcp::setFree(const std::vector<int>& rows) {
  if (isSmall_) {
    for (const int row : rows) states_[static_cast<std::size_t>(row)] = State::kFree;
    return true;
  }
  // what does not make up four goes first, for rows cost more the more there are before them
  std::size_t i = rows.size() % 2;
  if (i == 1 && !setFree(rows[0])) return false;
  if (rows.size() % 4 >= 2) {
    if (!setFreeTogether<2>(&rows[i])) return false;
    i += 2;
  }
  for (; i < rows.size(); i += 4) {
    if (!setFreeTogether<4>(&rows[i])) return false;
  }
  return true;
}

/// Adds the row, whose factors stand at their place already.
/// @return False where A is not positive definite.
bool Lcp::addFactor(int row, double d) {
  if (!(d > 0)) return false;
  D_[free_.size()] = d;
  inverseD_[free_.size()] = 1 / d;
  free_.push_back(row);
  states_[static_cast<std::size_t>(row)] = State::kFree;
  return true;
}

void Lcp::setBound(int row, State state) {
  const auto i = static_cast<std::size_t>(row);
  if (states_[i] == State::kFree && !isSmall_)
    dropFactor(static_cast<std::size_t>(std::ranges::find(free_, row) - free_.begin()));
  states_[i] = state;
  x_[i] = state == State::kLowest ? lowest_[i] : highest_[i];
}

/// Removes a row and column from the factorization; the rows behind get an update of rank one. P. E. Gill, G. H. Golub,
/// W. Murray, M. A. Saunders, Methods for modifying matrix factorizations, Mathematics of Computation 28, 1974, method
/// C1.
void Lcp::dropFactor(std::size_t place) {
  const std::size_t end = free_.size();
  double alpha = D_[place];
  values_.clear();
  for (std::size_t row = place + 1; row < end; ++row) {
    double* const to = factorRow(row - 1);
    const double* const from = factorRow(row);
    values_.push_back(from[place]);
    std::copy(from, from + place, to);
    std::copy(from + place + 1, from + row, to + place);
    D_[row - 1] = D_[row];
    inverseD_[row - 1] = inverseD_[row];
  }
  free_.erase(free_.begin() + static_cast<std::ptrdiff_t>(place));
  for (std::size_t j = 0; j < values_.size(); ++j) {
    const double p = values_[j];
    const double before = D_[place + j];
    const double after = before + alpha * p * p;
    const double beta = alpha * p / after;
    alpha *= before / after;
    D_[place + j] = after;
    inverseD_[place + j] = 1 / after;
    for (std::size_t r = j + 1; r < values_.size(); ++r) {
      double& l = factorRow(place + r)[place + j];
      values_[r] -= p * l;
      l += beta * values_[r];
    }
  }
}

/// Takes what stands before it out of four values from `first` on, side by side.
void Lcp::solveFourForward(double* values, std::size_t first) const {
  double even[4] = {};
  double odd[4] = {};
  const double* const rows[4] = {factorRow(first), factorRow(first + 1), factorRow(first + 2), factorRow(first + 3)};
  // `first` is a multiple of four
  for (std::size_t k = 0; k < first; k += 2) {
    for (std::size_t r = 0; r < 4; ++r) {
      even[r] += rows[r][k] * values[k];
      odd[r] += rows[r][k + 1] * values[k + 1];
    }
  }
  for (std::size_t r = 0; r < 4; ++r) {
    values[first + r] -= even[r] + odd[r];
    for (std::size_t k = first; k < first + r; ++k) values[first + r] -= rows[r][k] * values[k];
  }
}

/// Solves L D L^T y = `values` in place.
void Lcp::solveFactors(std::vector<double>& values) const {
  const std::size_t count = free_.size();
  std::size_t i = 0;
  for (; i + 4 <= count; i += 4) solveFourForward(values.data(), i);
  for (; i < count; ++i) values[i] -= dot(factorRow(i), values.data(), i);
  for (i = 0; i < count; ++i) values[i] *= inverseD_[i];
  // two rows at a time
  for (; i >= 2; i -= 2) {
    const double* const l1 = factorRow(i - 1);
    const double* const l2 = factorRow(i - 2);
    const double value1 = values[i - 1];
    const double value2 = values[i - 2] -= l1[i - 2] * value1;
    for (std::size_t j = 0; j + 2 < i; ++j) values[j] -= l1[j] * value1 + l2[j] * value2;
  }
}

}  // namespace pongsim::physics
