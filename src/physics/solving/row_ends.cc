#include "physics/solving/row_ends.hh"

#include <algorithm>

#include "physics/lcp/four.hh"

namespace pongsim::physics {

namespace {

/// Up to four consecutive ends at a body.
struct Ends {
  std::size_t count;
  std::array<std::size_t, 4> places;
  /// Whether each stands behind the one before in A, and whether they stand side by side.
  bool ascend;
  bool areSideBySide;
  /// Each component of their responses; those beyond their number are undefined.
  Four responses[6];
};

/// Transposes a 4 x 4 matrix: sets its first two rows, then its last two.
[[gnu::always_inline]] inline void turn(const Loose& a, const Loose& b, const Loose& c, const Loose& d, Four* first,
                                        Four* last) {
  const Four ab0 = __builtin_shufflevector(a, b, 0, 4, 2, 6), ab1 = __builtin_shufflevector(a, b, 1, 5, 3, 7);
  const Four cd0 = __builtin_shufflevector(c, d, 0, 4, 2, 6), cd1 = __builtin_shufflevector(c, d, 1, 5, 3, 7);
  first[0] = __builtin_shufflevector(ab0, cd0, 0, 1, 4, 5);
  first[1] = __builtin_shufflevector(ab1, cd1, 0, 1, 4, 5);
  last[0] = __builtin_shufflevector(ab0, cd0, 2, 3, 6, 7);
  last[1] = __builtin_shufflevector(ab1, cd1, 2, 3, 6, 7);
}

[[gnu::always_inline]] inline void load(const RowEnd* const* ends, std::size_t count, Ends& four) {
  four.count = count;
  const RowEnd* each[4];
  for (std::size_t i = 0; i < 4; ++i) {
    each[i] = ends[std::min(i, count - 1)];
    four.places[i] = static_cast<std::size_t>(each[i]->place);
  }
  const auto at = [&](std::size_t i, std::size_t k) -> const Loose& {
    return *reinterpret_cast<const Loose*>(&each[i]->response[k]);
  };
  Four* const r = four.responses;
  Four unused[2];
  turn(at(0, 0), at(1, 0), at(2, 0), at(3, 0), r, r + 2);
  turn(at(0, 2), at(1, 2), at(2, 2), at(3, 2), unused, r + 4);
  const std::array<std::size_t, 4>& p = four.places;
  four.ascend = true;
  for (std::size_t i = 1; i < count; ++i) four.ascend = four.ascend && p[i] > p[i - 1];
  four.areSideBySide = four.ascend && count == 4 && p[3] == p[0] + 3;
}

/// As `coupling` of an end with each of four.
[[gnu::always_inline]] inline void couplings(const std::array<double, 6>& d, const Ends& four, Four& sums) {
  const Four* const r = four.responses;
  sums = ((d[0] * r[0] + d[2] * r[2]) + d[4] * r[4]) + ((d[1] * r[1] + d[3] * r[3]) + d[5] * r[5]);
}

/// As `addOneByOne` below, where the end stands before those.
[[gnu::always_inline]] inline void addToRow(const Four& sums, const Ends& four, std::size_t first, double* row) {
  for (std::size_t i = first; i < four.count; ++i) row[four.places[i]] += sums[i];
}

/// @param first The first one of the four that an end is coupled with.
[[gnu::always_inline]] inline void addOneByOne(const Four& sums, const Ends& four, std::size_t place, std::size_t first,
                                               const UpperRows& A) {
  for (std::size_t i = first; i < four.count; ++i) {
    A.row(std::min(place, four.places[i]))[std::max(place, four.places[i])] += sums[i];
  }
}

PONGSIM_WIDE void coupleAll(const RowEnd* const* ends, std::size_t count, const UpperRows& A) {
  Ends four;
  for (std::size_t begin = 0; begin < count; begin += 4) {
    load(ends + begin, std::min(count - begin, std::size_t{4}), four);
    for (std::size_t i = 0; i < begin + four.count; ++i) {
      const RowEnd& end = *ends[i];
      const auto place = static_cast<std::size_t>(end.place);
      Four sums;
      couplings(end.jacobian, four, sums);
      const bool isOneOfThem = i >= begin;
      const std::size_t first = isOneOfThem ? i - begin : 0;
      if (!four.ascend || !(isOneOfThem || place < four.places[0])) {
        addOneByOne(sums, four, place, first, A);
      } else if (four.areSideBySide) {
        *reinterpret_cast<Loose*>(A.row(place) + four.places[0]) += sums;
      } else {
        addToRow(sums, four, first, A.row(place));
      }
    }
  }
}

}  // namespace

void coupleBefore(std::span<const RowEnd> ends, const RowEnd& end, const UpperRows& A) {
  A.row(static_cast<std::size_t>(end.place))[end.place] += coupling(end, end);
  for (int i = end.before; i >= 0; i = ends[static_cast<std::size_t>(i)].before) {
    const RowEnd& each = ends[static_cast<std::size_t>(i)];
    const double sum = coupling(each, end);
    // a gearbox may have two ends at one body: their product counts twice on the diagonal
    A.row(static_cast<std::size_t>(std::min(end.place, each.place)))[std::max(end.place, each.place)] +=
        each.place == end.place ? 2 * sum : sum;
  }
}

void BodyCoupling::couple(std::span<const RowEnd> ends, int last, const UpperRows& A) {
  list_.resize(std::max(list_.size(), ends.size()));
  std::size_t begin = list_.size();
  for (int i = last; i >= 0; i = ends[static_cast<std::size_t>(i)].before) {
    list_[--begin] = &ends[static_cast<std::size_t>(i)];
  }
  coupleAll(list_.data() + begin, list_.size() - begin, A);
}

}  // namespace pongsim::physics
