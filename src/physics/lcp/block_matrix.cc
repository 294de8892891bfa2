#include "physics/lcp/block_matrix.hh"

#include <algorithm>

#include "physics/lcp/four.hh"

namespace pongsim::physics {

namespace {

using Panel = BlockMatrix::Panel;
using Later = BlockMatrix::Later;

constexpr int roundedDown(int column) { return column / 4 * 4; }
constexpr int roundedUp(int column) { return (column + 3) / 4 * 4; }
// own columns, with the right-hand sides behind them
constexpr int ownWidth(int rows) { return roundedUp(rows + 2); }

/// What the inner loops work on.
struct Blocks {
  const Panel* panels;
  const Later* later;
  double* data;
  double* inverseD;
  /// How many joints there are; the panel of the rows with bounds stands behind theirs.
  std::size_t count;
};

/// How far apart the factors of two rows are, by which they are taken out of all rows of another joint.
constexpr std::size_t kFactorStride = 8;

[[gnu::always_inline]] inline Four& fourAt(double* at) { return *reinterpret_cast<Four*>(at); }
[[gnu::always_inline]] inline const Four& fourAt(const double* at) { return *reinterpret_cast<const Four*>(at); }

/// to -= the sum of the factors times the rows of a panel, in columns from `begin` to `end` of these.
template <int kRows>
[[gnu::always_inline]] inline void subtractRows(double* to, const double* rows, std::size_t width,
                                                const double* factors, std::size_t stride, int begin, int end) {
  for (int k = begin; k < end; k += 4, to += 4) {
    Four sum = factors[0] * fourAt(rows + k);
#pragma GCC unroll 8
    for (std::size_t p = 1; p < kRows; ++p) sum += factors[p * stride] * fourAt(rows + p * width + k);
    fourAt(to) -= sum;
  }
}

/// Likewise both right-hand sides, which stand in the rows' own columns.
template <int kRows>
[[gnu::always_inline]] inline void subtractSides(double* to, const double* rows, std::size_t width,
                                                 const double* factors, std::size_t stride) {
  using Two [[gnu::vector_size(16), gnu::aligned(8), gnu::may_alias]] = double;
  const auto sidesOf = [&](std::size_t p) { return *reinterpret_cast<const Two*>(rows + p * width + kRows); };
  Two sum = factors[0] * sidesOf(0);
#pragma GCC unroll 8
  for (std::size_t p = 1; p < kRows; ++p) sum += factors[p * stride] * sidesOf(p);
  *reinterpret_cast<Two*>(to) -= sum;
}

/// Makes D L^T of the panel's own rows.
/// @return False where the matrix is not positive definite.
template <int kRows>
[[gnu::always_inline]] inline bool factor(double* rows, std::size_t width, double* inverseD) {
  constexpr std::size_t kOwn = ownWidth(kRows);
  // of each pair of rows, one after the other
  double factors[kRows * kRows];
  for (std::size_t j = 0; j < kRows; ++j) {
    const double* const pivot = rows + j * width;
    if (!(pivot[j] > 0)) return false;
    inverseD[j] = 1 / pivot[j];
#pragma GCC unroll 8
    for (std::size_t i = j + 1; i < kRows; ++i) {
      const double factor = factors[j * kRows + i] = pivot[i] * inverseD[j];
#pragma GCC unroll 2
      for (std::size_t k = 0; k < kOwn; k += 4) fourAt(rows + i * width + k) -= factor * fourAt(pivot + k);
    }
  }
  for (std::size_t k = kOwn; k < width; k += 4) {
    Four four[kRows];
#pragma GCC unroll 8
    for (std::size_t i = 0; i < kRows; ++i) four[i] = fourAt(rows + i * width + k);
#pragma GCC unroll 8
    for (std::size_t j = 0; j < kRows; ++j) {
#pragma GCC unroll 8
      for (std::size_t i = j + 1; i < kRows; ++i) four[i] -= factors[j * kRows + i] * four[j];
    }
#pragma GCC unroll 8
    for (std::size_t i = 1; i < kRows; ++i) fourAt(rows + i * width + k) = four[i];
  }
  return true;
}

/// @return Where the rows of a panel have the columns of a later one.
[[gnu::always_inline]] inline int columnOf(const Blocks& blocks, const Panel& panel, int place) {
  const Later* later = blocks.later + panel.firstLater;
  while (later->place != place) ++later;
  return later->column;
}

/// Takes the rows of a panel, with their right-hand sides, out of those of the joint at `blocks.later[number]`.
template <int kRows>
[[gnu::always_inline]] inline void eliminateFrom(const Blocks& blocks, const Panel& panel, int number,
                                                 double* factors) {
  const Later& later = blocks.later[number];
  const Panel& target = blocks.panels[later.place];
  const double* const rows = blocks.data + panel.data;
  const std::size_t width = panel.width;
  const int ownEnd = roundedUp(target.rows);
  for (int k = 0; k < ownEnd; k += 4) {
#pragma GCC unroll 8
    for (std::size_t p = 0; p < kRows; ++p) {
      fourAt(factors + p * kFactorStride + k) =
          blocks.inverseD[panel.x + static_cast<int>(p)] * fourAt(rows + p * width + later.column + k);
    }
  }
  for (int i = 0; i < target.rows; ++i) {
    double* const to = blocks.data + target.data + static_cast<std::size_t>(i) * target.width;
    const int first = roundedDown(i);
    subtractRows<kRows>(to + first, rows, width, factors + i, kFactorStride, later.column + first,
                        later.column + ownEnd);
    subtractSides<kRows>(to + target.rows, rows, width, factors + i, kFactorStride);
  }
  for (int b = number + 1; b < panel.endLater; ++b) {
    const Later& other = blocks.later[b];
    double* to = blocks.data + target.data + columnOf(blocks, target, other.place);
    const int end = other.column + roundedUp(blocks.panels[other.place].rows);
    for (int i = 0; i < target.rows; ++i, to += target.width) {
      subtractRows<kRows>(to, rows, width, factors + i, kFactorStride, other.column, end);
    }
  }
  if (panel.firstBounded == panel.endBounded) return;
  double* to = blocks.data + target.data + target.boundedColumn + (panel.firstBounded - target.firstBounded);
  for (int i = 0; i < target.rows; ++i, to += target.width) {
    subtractRows<kRows>(to, rows, width, factors + i, kFactorStride, panel.boundedColumn, static_cast<int>(width));
  }
}

/// Likewise out of the rows with bounds.
template <int kRows>
[[gnu::always_inline]] inline void eliminateFromBounded(const Blocks& blocks, const Panel& panel) {
  const Panel& bounded = blocks.panels[blocks.count];
  const double* const rows = blocks.data + panel.data;
  const std::size_t width = panel.width;
  double factors[kRows];
  for (int i = panel.firstBounded; i < std::min(panel.endBounded, bounded.rows); ++i) {
    const int column = panel.boundedColumn + i - panel.firstBounded;
    bool isCoupled = false;
#pragma GCC unroll 8
    for (std::size_t p = 0; p < kRows; ++p) {
      factors[p] = rows[p * width + static_cast<std::size_t>(column)] * blocks.inverseD[panel.x + static_cast<int>(p)];
      isCoupled = isCoupled || factors[p] != 0;
    }
    if (!isCoupled) continue;
    double* const to = blocks.data + bounded.data + static_cast<std::size_t>(i) * bounded.width;
    subtractRows<kRows>(to + roundedDown(i), rows, width, factors, 1, roundedDown(column), static_cast<int>(width));
    subtractSides<kRows>(to + bounded.rows, rows, width, factors, 1);
  }
}

template <int kRows>
[[gnu::always_inline]] inline bool eliminateJoint(const Blocks& blocks, std::size_t place) {
  const Panel& panel = blocks.panels[place];
  if (!factor<kRows>(blocks.data + panel.data, panel.width, blocks.inverseD + panel.x)) return false;
  alignas(16) double factors[kRows * kFactorStride];
  for (int number = panel.firstLater; number < panel.endLater; ++number) {
    eliminateFrom<kRows>(blocks, panel, number, factors);
  }
  eliminateFromBounded<kRows>(blocks, panel);
  return true;
}

PONGSIM_WIDE bool eliminateJoints(const Blocks& blocks) {
  for (std::size_t place = 0; place < blocks.count; ++place) {
    bool isDone = true;
    switch (blocks.panels[place].rows) {
      case 1:
        isDone = eliminateJoint<1>(blocks, place);
        break;
      case 2:
        isDone = eliminateJoint<2>(blocks, place);
        break;
      case 3:
        isDone = eliminateJoint<3>(blocks, place);
        break;
      case 4:
        isDone = eliminateJoint<4>(blocks, place);
        break;
      case 5:
        isDone = eliminateJoint<5>(blocks, place);
        break;
      case 6:
        isDone = eliminateJoint<6>(blocks, place);
        break;
      default:
        break;
    }
    if (!isDone) return false;
  }
  return true;
}

/// Adds up what known x count for in the rows, four columns side by side.
template <int kRows>
[[gnu::always_inline]] inline void addKnown(Four* sums, const double* rows, std::size_t width, const double* x,
                                            int columns) {
  for (int k = 0; k < columns; k += 4) {
    const Four known = fourAt(x + k);
#pragma GCC unroll 8
    for (std::size_t p = 0; p < kRows; ++p) sums[p] += fourAt(rows + p * width + k) * known;
  }
}

template <int kRows>
[[gnu::always_inline]] inline void substituteJoint(const Blocks& blocks, std::size_t place, std::size_t side,
                                                   double* x) {
  const Panel& panel = blocks.panels[place];
  const double* const rows = blocks.data + panel.data;
  const std::size_t width = panel.width;
  // four are summed up at a time
  Four sums[kRows > 4 ? 8 : 4] = {};
  for (int a = panel.firstLater; a < panel.endLater; ++a) {
    const Later& later = blocks.later[a];
    const Panel& other = blocks.panels[later.place];
    addKnown<kRows>(sums, rows + later.column, width, x + other.x, roundedUp(other.rows));
  }
  addKnown<kRows>(sums, rows + panel.boundedColumn, width, x + blocks.panels[blocks.count].x + panel.firstBounded,
                  panel.endBounded - panel.firstBounded);
  alignas(16) double left[8];
  sumUp(sums[0], sums[1], sums[2], sums[3], fourAt(left));
  if constexpr (kRows > 4) sumUp(sums[4], sums[5], sums[6], sums[7], fourAt(left + 4));
#pragma GCC unroll 8
  for (std::size_t p = 0; p < kRows; ++p) left[p] = rows[p * width + kRows + side] - left[p];
  const double* const inverseD = blocks.inverseD + panel.x;
  double* const own = x + panel.x;
#pragma GCC unroll 8
  for (std::size_t taken = 1; taken <= kRows; ++taken) {
    const std::size_t j = kRows - taken;
    const double found = own[j] = left[j] * inverseD[j];
#pragma GCC unroll 8
    for (std::size_t p = 0; p < j; ++p) left[p] -= rows[p * width + j] * found;
  }
}

PONGSIM_WIDE void substituteJoints(const Blocks& blocks, std::size_t side, double* x) {
  for (std::size_t place = blocks.count; place-- > 0;) {
    switch (blocks.panels[place].rows) {
      case 1:
        substituteJoint<1>(blocks, place, side, x);
        break;
      case 2:
        substituteJoint<2>(blocks, place, side, x);
        break;
      case 3:
        substituteJoint<3>(blocks, place, side, x);
        break;
      case 4:
        substituteJoint<4>(blocks, place, side, x);
        break;
      case 5:
        substituteJoint<5>(blocks, place, side, x);
        break;
      case 6:
        substituteJoint<6>(blocks, place, side, x);
        break;
      default:
        break;
    }
  }
}

}  // namespace

bool BlockMatrix::begin(const JointOrder& order, std::span<const int> rows, int bounded,
                        std::span<const BoundedEnd> ends) {
  order_ = &order;
  const std::size_t count = order.count();
  panels_.resize(count + 1);
  later_.clear();
  findRanges(bounded, ends);
  const auto rowsAt = [&](int place) { return rows[static_cast<std::size_t>(order.jointAt(place))]; };
  std::size_t data = 0;
  int x = 0;
  for (std::size_t i = 0; i < count; ++i) {
    Panel& panel = panels_[i];
    panel.rows = rowsAt(static_cast<int>(i));
    if (panel.rows > kMostBlockRows) return false;
    panel.data = data;
    panel.x = x;
    panel.firstLater = static_cast<int>(later_.size());
    int column = ownWidth(panel.rows);
    for (const int other : order.later(static_cast<int>(i))) {
      later_.push_back({other, column});
      column += roundedUp(rowsAt(other));
    }
    panel.endLater = static_cast<int>(later_.size());
    panel.boundedColumn = column;
    panel.width = static_cast<std::size_t>(column + panel.endBounded - panel.firstBounded);
    data += panel.width * static_cast<std::size_t>(panel.rows);
    x += roundedUp(panel.rows);
  }
  panels_[count] = {data, static_cast<std::size_t>(ownWidth(bounded)), bounded, x, 0, 0, 0, 0, 0};
  data += panels_[count].width * static_cast<std::size_t>(bounded);
  size_ = static_cast<std::size_t>(x + roundedUp(bounded));
  data_.assign(data, 0.0);
  inverseD_.resize(static_cast<std::size_t>(x));
  return true;
}

/// Numbers rows with bounds by the first joint that they are coupled with, so that those which a joint is coupled with
/// are next to each other, but for few that it is not.
void BlockMatrix::findRanges(int bounded, std::span<const BoundedEnd> ends) {
  const std::size_t count = order_->count();
  for (Panel& panel : panels_) panel.firstBounded = panel.endBounded = 0;
  if (bounded == 0) return;
  const int none = static_cast<int>(count);
  firstOf_.assign(static_cast<std::size_t>(bounded), none);
  for (const BoundedEnd& end : ends) {
    const int first = order_->firstAt(end.body);
    int& found = firstOf_[static_cast<std::size_t>(end.row)];
    if (first >= 0) found = std::min(found, first);
  }
  counts_.assign(count + 2, 0);
  for (const int first : firstOf_) ++counts_[static_cast<std::size_t>(first) + 1];
  for (std::size_t i = 1; i < counts_.size(); ++i) counts_[i] += counts_[i - 1];
  numberOf_.resize(static_cast<std::size_t>(bounded));
  for (std::size_t row = 0; row < firstOf_.size(); ++row) {
    numberOf_[row] = counts_[static_cast<std::size_t>(firstOf_[row])]++;
  }
  for (const BoundedEnd& end : ends) {
    const int first = order_->firstAt(end.body);
    const int number = boundedNumber(end.row);
    if (first >= 0) extend(static_cast<std::size_t>(first), roundedDown(number), roundedUp(number + 1));
  }
  for (std::size_t place = 0; place < count; ++place) {
    const std::span<const int> later = order_->later(static_cast<int>(place));
    const Panel& panel = panels_[place];
    if (later.empty() || panel.firstBounded == panel.endBounded) continue;
    extend(static_cast<std::size_t>(later.front()), panel.firstBounded, panel.endBounded);
  }
}

void BlockMatrix::extend(std::size_t place, int first, int end) {
  Panel& panel = panels_[place];
  const bool isNew = panel.firstBounded == panel.endBounded;
  panel.firstBounded = isNew ? first : std::min(panel.firstBounded, first);
  panel.endBounded = isNew ? end : std::max(panel.endBounded, end);
}

double BlockMatrix::work() const {
  double work = 0;
  for (const Panel& panel : panels_) {
    const auto width = static_cast<double>(panel.width);
    work += panel.rows * width * width / 2;
  }
  return work;
}

double* BlockMatrix::sides(int place, int row) {
  const Panel& panel = panels_[static_cast<std::size_t>(place)];
  return &data_[panel.data + static_cast<std::size_t>(row) * panel.width + static_cast<std::size_t>(panel.rows)];
}

UpperRows BlockMatrix::bounded() {
  const Panel& panel = panels_.back();
  return {data_.data() + panel.data, panel.width, static_cast<std::size_t>(panel.rows)};
}

bool BlockMatrix::eliminate() {
  return eliminateJoints({panels_.data(), later_.data(), data_.data(), inverseD_.data(), order_->count()});
}

void BlockMatrix::substitute(int side, double* x) {
  substituteJoints({panels_.data(), later_.data(), data_.data(), inverseD_.data(), order_->count()},
                   static_cast<std::size_t>(side), x);
}

}  // namespace pongsim::physics
