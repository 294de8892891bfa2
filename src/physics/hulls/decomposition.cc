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

/// How many triangles are looked at for all cuts together. Meshes of 6,000 triangles take 50,000 at most if they bound
/// a body; triangles in disorder multiply with each cut.
constexpr std::size_t kMostWork = 200'000;

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

  bool isComplete() const { return work_ <= kMostWork; }

  std::vector<Piece> run(const TriangleChain& chain) {
    const auto most = static_cast<std::size_t>(kSurplus * static_cast<double>(settings_.mostPieces) + 0.5);
    add(chain, most);
    while (settings_.mostPieces > 1 && parts_.size() < most && splitWorst(most)) {
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

  /// Adds its bodies, or all as one if they are too many to look at each.
  void add(const TriangleChain& chain, std::size_t most) {
    std::vector<TriangleChain> bodies = separateBodies(chain);
    std::erase_if(bodies, [](const TriangleChain& body) { return body.triangles.empty(); });
    if (bodies.size() > most) {
      parts_.push_back(partOf(chain));
      return;
    }
    for (TriangleChain& body : bodies) parts_.push_back(partOf(std::move(body)));
  }

  bool splitWorst(std::size_t most) {
    Part* worst = nullptr;
    for (Part& part : parts_) {
      if (part.isDone || isConvex(part.piece)) continue;
      if (worst == nullptr || part.piece.excess() > worst->piece.excess()) worst = &part;
    }
    if (worst == nullptr) return false;
    work_ += worst->chain.triangles.size();
    if (work_ > kMostWork) return false;
    const std::optional<Plane> plane = bestCut(worst->chain, worst->piece.hull);
    if (!plane) {
      worst->isDone = true;
      return true;
    }
    const TriangleChain chain = std::move(worst->chain);
    *worst = std::move(parts_.back());
    parts_.pop_back();
    Halves halves = cut(chain, *plane, cutTolerance(chain), true);
    add(halves.front, most);
    add(halves.back, most);
    return true;
  }

  const DecompositionSettings& settings_;
  const double size_;
  std::vector<Part> parts_;
  std::size_t work_ = 0;
};

}  // namespace

Decomposition decompose(const TriangleChain& chain, const DecompositionSettings& settings) {
  Decomposition made;
  if (chain.triangles.empty()) return made;
  Decomposer decomposer(chain, settings);
  std::vector<Piece> pieces = decomposer.run(chain);
  made.isComplete = decomposer.isComplete();
  double volume = 0;
  for (const Piece& piece : pieces) volume += piece.hull.volume;
  for (Piece& piece : pieces) {
    // slivers left by cuts
    if (chain.isClosed && piece.hull.volume <= kSmallest * volume) continue;
    made.pieces.push_back(std::move(piece.hull.corners));
  }
  return made;
}

}  // namespace pongsim::physics
