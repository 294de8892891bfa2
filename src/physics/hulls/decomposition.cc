#include "physics/hulls/decomposition.hh"

#include <algorithm>
#include <utility>

#include "physics/hulls/best_cut.hh"
#include "physics/hulls/hull.hh"
#include "physics/hulls/piece_union.hh"

namespace pongsim::physics {

namespace {

/// Splitting makes this many times more pieces than allowed, because joining judges better than cutting.
constexpr double kSurplus = 1.5;
/// A piece that fills this much of its hull counts as convex; the rest can't be felt.
constexpr double kFilled = 0.99;

/// Pieces smaller than this part of the total volume are dropped.
constexpr double kSmallest = 1e-6;

struct Part {
  TriangleChain chain;
  Piece piece;
  /// No plane improves it.
  bool isDone = false;
};

double longestEdge(const TriangleChain& chain) {
  Eigen::AlignedBox3d box;
  for (const Vector3& point : chain.points) box.extend(point);
  return box.sizes().maxCoeff();
}

class Decomposer {
 public:
  Decomposer(const TriangleChain& chain, const DecompositionSettings& settings)
      : settings_(settings), size_(longestEdge(chain)) {}

  std::vector<Piece> run(const TriangleChain& chain) {
    add(chain);
    const auto most = static_cast<std::size_t>(kSurplus * static_cast<double>(settings_.mostPieces) + 0.5);
    if (parts_.size() > most) {
      // too many to look at each
      parts_.clear();
      parts_.push_back(partOf(chain));
    }
    while (settings_.mostPieces > 1 && parts_.size() < most && splitWorst()) {
    }
    std::vector<Piece> pieces;
    for (Part& part : parts_) pieces.push_back(std::move(part.piece));
    return joinPieces(std::move(pieces), settings_.mostPieces, [this](const Piece& piece) { return isConvex(piece); });
  }

 private:
  bool isConvex(const Piece& piece) const {
    return piece.excess() <= (1 - kFilled) * piece.hull.volume ||
           piece.excess() <= settings_.standOff * size_ * piece.hull.area / 2;
  }

  Part partOf(TriangleChain chain) const {
    Piece piece{convexHull(chain.points), std::max(0.0, volumeOf(chain))};
    return {std::move(chain), std::move(piece)};
  }

  void add(const TriangleChain& chain) {
    for (TriangleChain& body : separateBodies(chain)) {
      if (!body.triangles.empty()) parts_.push_back(partOf(std::move(body)));
    }
  }

  bool splitWorst() {
    Part* worst = nullptr;
    for (Part& part : parts_) {
      if (part.isDone || isConvex(part.piece)) continue;
      if (worst == nullptr || part.piece.excess() > worst->piece.excess()) worst = &part;
    }
    if (worst == nullptr) return false;
    const std::optional<Plane> plane = bestCut(worst->chain, worst->piece.hull);
    if (!plane) {
      worst->isDone = true;
      return true;
    }
    const TriangleChain chain = std::move(worst->chain);
    *worst = std::move(parts_.back());
    parts_.pop_back();
    Halves halves = cut(chain, *plane, cutTolerance(chain), true);
    add(halves.front);
    add(halves.back);
    return true;
  }

  const DecompositionSettings& settings_;
  const double size_;
  std::vector<Part> parts_;
};

}  // namespace

std::vector<PieceCorners> decompose(const TriangleChain& chain, const DecompositionSettings& settings) {
  std::vector<PieceCorners> corners;
  if (chain.triangles.empty()) return corners;
  std::vector<Piece> pieces = Decomposer(chain, settings).run(chain);
  double volume = 0;
  for (const Piece& piece : pieces) volume += piece.hull.volume;
  for (Piece& piece : pieces) {
    // slivers left by cuts
    if (chain.isClosed && piece.hull.volume <= kSmallest * volume) continue;
    corners.push_back(std::move(piece.hull.corners));
  }
  return corners;
}

}  // namespace pongsim::physics
