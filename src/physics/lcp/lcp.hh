#pragma once

#include <utility>
#include <vector>

namespace pongsim::physics {

/// Solves mixed linear complementarity problems directly. First by block principal pivoting: assume that no bound is
/// active and solve the equations; then set all x outside their bounds to these, free all at a bound whose w has the
/// wrong sign, and solve again, which seldom takes more than a few rounds. If it takes too many, by Dantzig's method:
/// drive row after row to its condition, while those before it keep theirs. The solution is unique, so both find the
/// same. Keeps nothing but memory from one problem to the next.
///
/// References: J. J. Júdice, F. M. Pires, A block principal pivoting algorithm for large-scale strictly monotone linear
/// complementarity problems, Computers & Operations Research 21, 1994; R. W. Cottle, G. B. Dantzig, Complementary pivot
/// theory of mathematical programming, Linear Algebra and its Applications 1, 1968; D. Baraff, Fast contact force
/// computation for nonpenetrating rigid bodies, SIGGRAPH 1994.
class Lcp {
 public:
  struct Problem {
    /// Number of rows.
    int rows = 0;
    /// `rows` x `rows`, symmetric and positive definite, row after row, each `stride` numbers behind the one before.
    const double* A = nullptr;
    int stride = 0;
    const double* b = nullptr;
    /// Bounds of each x, infinite where there are none. Of a row of friction they are multiples of its normal row's
    /// |x|.
    const double* lowest = nullptr;
    const double* highest = nullptr;
    /// The normal row of a row of friction, -1 for others. Rows of friction stand behind all others.
    const int* normalOf = nullptr;
  };

  /// Finds x between its bounds so that w = A x - b is zero where x is between them, not negative where x is at its
  /// lowest, not positive where it is at its highest. Friction is bounded by the normal x of the problem without
  /// friction.
  /// @param x Of `rows` numbers.
  /// @return Whether a solution was found; otherwise `x` is undefined.
  bool solve(const Problem& problem, double* x);

  /// Like `solve`, if A is that of the last problem, or its first rows: reuses the factorization.
  bool solveWithSameMatrix(const Problem& problem, double* x);

 private:
  /// Whether a row's x is free or at a bound; `kOut`: it is not in the problem yet.
  enum class State { kOut, kFree, kLowest, kHighest };
  /// The length of a pivoting step, the row that limits it, and what that row becomes.
  struct Move {
    double length;
    int row;
    State becomes;
  };

  void begin(const Problem& problem, double* x);
  bool solveByRounds(std::size_t factored);
  std::size_t factoredRows(std::size_t rows) const;
  bool settle(int first, int end, std::size_t factored);
  bool solveFree();
  bool solveFreeAfresh();
  void listViolations(int end);
  void dropRelieved();
  bool solveByPivots();
  bool solveUnbounded();
  void setFrictionBounds();
  bool drive(int row);
  void computeDirection(int row, double direction);
  Move ratioTest(int row, double direction) const;
  void shorten(Move& way, int row, double length, State becomes) const;
  bool setFree(int row);
  bool setFree(const std::vector<int>& rows);
  template <std::size_t kCount>
  bool setFreeTogether(const int* rows);
  bool addFactor(int row, double d);
  void setBound(int row, State state);
  void dropFactor(std::size_t place);
  void solveFourForward(double* values, std::size_t first) const;
  void solveFactors(std::vector<double>& values) const;
  const double* rowOfA(std::size_t row) const { return problem_.A + row * static_cast<std::size_t>(problem_.stride); }
  double* factorRow(std::size_t place) { return &L_[place * rows_]; }
  const double* factorRow(std::size_t place) const { return &L_[place * rows_]; }

  Problem problem_;
  double* x_ = nullptr;
  std::size_t rows_ = 0;
  /// Whether there are so few rows that the free ones are eliminated from scratch in each round.
  bool isSmall_ = false;
  std::vector<double> U_;
  std::vector<State> states_;
  std::vector<double> w_;
  std::vector<double> lowest_;
  std::vector<double> highest_;
  /// Changes of x and w per unit of the pivoting step.
  std::vector<double> dx_;
  std::vector<double> dw_;
  /// The rows whose x is free, and of A among them the factors: L D L^T, the diagonal of L being ones; and 1/D.
  std::vector<int> free_;
  /// Those at a bound, where there are few rows.
  std::vector<int> bound_;
  std::vector<double> L_;
  std::vector<double> D_;
  std::vector<double> inverseD_;
  std::vector<double> values_;
  std::vector<int> freed_;
  std::vector<std::pair<int, State>> violations_;
};

}  // namespace pongsim::physics
