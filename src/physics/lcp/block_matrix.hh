#pragma once

#include <cassert>
#include <cstddef>
#include <span>
#include <vector>

#include "physics/lcp/elimination.hh"
#include "physics/lcp/joint_order.hh"

namespace pongsim::physics {

/// A sparse, symmetric and positive definite matrix with two right-hand sides. It stores the nonzero blocks of coupled
/// joints, in the order of elimination, and behind them the bounded rows, which are dense among each other.
///
/// A row is identified by the place of its joint in the order and its number in the joint; a bounded row by
/// `boundedPlace()` and `boundedNumber()`.
class BlockMatrix {
 public:
  /// A row with bounds acts on a body.
  struct BoundedEnd {
    int row;
    int body;
  };
  /// The rows of one place and the columns of another, in row-major order, `stride` numbers from row to row.
  struct Block {
    double* data;
    std::size_t stride;
  };

  /// Maximum number of equations of a joint.
  static constexpr int kMostBlockRows = 6;

  /// A joint that is coupled with an eliminated one, and its first column in the latter's rows.
  struct Later {
    int place;
    int column;
  };
  /// The rows of a joint, a multiple of four numbers wide: their own columns with the right-hand sides, those of the
  /// joints behind it, and those of some rows with bounds. All of these begin at a multiple of four.
  struct Panel {
    std::size_t data;
    std::size_t width;
    int rows;
    /// Where x has the rows.
    int x;
    /// Of `later_`.
    int firstLater;
    int endLater;
    /// The rows with bounds, and where their columns are.
    int firstBounded;
    int endBounded;
    int boundedColumn;
  };

  /// Makes room for the matrix, all zero.
  /// @param order Must outlive the use of the matrix.
  /// @param rows How many equations each joint has, in the joints' own order.
  /// @param bounded How many rows have bounds.
  /// @param ends Of these.
  /// @return False where a joint has too many equations.
  bool begin(const JointOrder& order, std::span<const int> rows, int bounded, std::span<const BoundedEnd> ends);

  /// @return About how many multiplications `eliminate` takes.
  double work() const;

  /// @return The place of rows with bounds.
  int boundedPlace() const { return static_cast<int>(order_->count()); }
  /// @return The number by which a row with bounds is known, which keeps together what acts on the same bodies.
  int boundedNumber(int row) const { return numberOf_[static_cast<std::size_t>(row)]; }

  /// @return The block of the rows of `first` and the columns of `second`, which does not stand before it; where both
  /// are one, what is before the diagonal is not read. Only for coupled places.
  Block block(int first, int second) {
    const Panel& panel = panels_[static_cast<std::size_t>(first)];
    double* const rows = data_.data() + panel.data;
    if (first == second) return {rows, panel.width};
    if (second == boundedPlace()) return {rows + panel.boundedColumn - panel.firstBounded, panel.width};
    const Later* later = &later_[static_cast<std::size_t>(panel.firstLater)];
    while (later->place != second) ++later;
    assert(later < later_.data() + panel.endLater);
    return {rows + later->column, panel.width};
  }
  /// @return Both right-hand sides of a row.
  double* sides(int place, int row);
  /// @return Where x has the row.
  int indexOf(int place, int row) const { return panels_[static_cast<std::size_t>(place)].x + row; }
  /// @return How many numbers x has for the place, of which those behind its rows are zero: a multiple of four.
  std::size_t paddedRowsAt(int place) const {
    return widthFor(static_cast<std::size_t>(panels_[static_cast<std::size_t>(place)].rows));
  }
  /// @return How many numbers x has, some of which are of no row.
  std::size_t size() const { return size_; }

  /// Eliminates the joints. What is left of the bounded rows is their Schur complement, with the right-hand sides
  /// behind.
  /// @return False where the matrix is not positive definite.
  bool eliminate();
  UpperRows bounded();

  /// Finds x of the joints, where that of the rows with bounds is known.
  /// @param side Which right-hand side, 0 or 1.
  /// @param x Of `size()` numbers, zero where there is no row.
  void substitute(int side, double* x);

 private:
  void findRanges(int bounded, std::span<const BoundedEnd> ends);
  void extend(std::size_t place, int first, int end);

  const JointOrder* order_ = nullptr;
  /// One for each joint in the order, and one for the rows with bounds.
  std::vector<Panel> panels_;
  std::vector<Later> later_;
  std::vector<int> numberOf_;
  /// How many rows with bounds there are by the first joint that they are coupled with.
  std::vector<int> counts_;
  std::vector<int> firstOf_;
  std::vector<double> data_;
  std::vector<double> inverseD_;
  std::size_t size_ = 0;
};

}  // namespace pongsim::physics
