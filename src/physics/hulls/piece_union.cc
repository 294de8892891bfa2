#include "physics/hulls/piece_union.hh"

#include <limits>
#include <utility>

namespace pongsim::physics {

namespace {

/// Pieces whose bounding boxes are further apart than this, relative to their size, are joined only if they must be.
constexpr double kGap = 1e-3;

Eigen::AlignedBox3d boxOf(const Piece& piece) {
  Eigen::AlignedBox3d box;
  for (const Vector3& corner : piece.hull.corners) box.extend(corner);
  return box;
}

Piece joined(const Piece& a, const Piece& b) {
  std::vector<Vector3> points = a.hull.corners;
  points.insert(points.end(), b.hull.corners.begin(), b.hull.corners.end());
  // overlapping volume counts once; their bounding boxes give a lower bound of it
  const Eigen::AlignedBox3d common = boxOf(a).intersection(boxOf(b));
  const double overlap = common.isEmpty() ? 0 : std::min({common.volume(), a.hull.volume, b.hull.volume});
  const double disjoint = a.hull.volume + b.hull.volume - overlap;
  Piece whole{convexHull(points), a.volume + b.volume};
  if (whole.volume > disjoint) whole.volume = disjoint;
  return whole;
}

/// The cost of joining each pair of pieces.
class Offers {
 public:
  explicit Offers(std::vector<Piece>& pieces) : pieces_(pieces), offers_(pieces.size() * pieces.size()) {
    for (std::size_t i = 0; i < pieces.size(); ++i) boxes_.push_back(boxOf(pieces[i]));
    isThere_.assign(pieces.size(), true);
    for (std::size_t i = 0; i < pieces.size(); ++i) makeOffers(i, i);
  }

  struct Best {
    std::size_t a = 0, b = 0;
    double cost = std::numeric_limits<double>::infinity();
  };

  /// @param isTaken Which of the unions are of interest.
  template <class IsTaken>
  Best best(IsTaken&& isTaken) const {
    Best best;
    for (std::size_t i = 0; i < pieces_.size(); ++i) {
      for (std::size_t j = 0; j < i && isThere_[i]; ++j) {
        if (!isThere_[j]) continue;
        const Offer& offer = offers_[i * pieces_.size() + j];
        if (offer.isMade && offer.cost < best.cost && isTaken(offer.whole)) best = {j, i, offer.cost};
      }
    }
    return best;
  }

  void join(const Best& best) {
    pieces_[best.a] = std::move(offers_[best.b * pieces_.size() + best.a].whole);
    isThere_[best.b] = false;
    boxes_[best.a] = boxOf(pieces_[best.a]);
    makeOffers(best.a, pieces_.size());
  }

  /// Also for pieces that do not touch.
  void makeAll() {
    touchingOnly_ = false;
    for (std::size_t i = 0; i < pieces_.size(); ++i) {
      if (isThere_[i]) makeOffers(i, i);
    }
  }

  std::size_t count() const { return static_cast<std::size_t>(std::ranges::count(isThere_, true)); }

  std::vector<Piece> take() {
    std::vector<Piece> rest;
    for (std::size_t i = 0; i < pieces_.size(); ++i) {
      if (isThere_[i]) rest.push_back(std::move(pieces_[i]));
    }
    return rest;
  }

 private:
  struct Offer {
    Piece whole;
    double cost = 0;
    bool isMade = false;
  };

  void makeOffers(std::size_t piece, std::size_t end) {
    for (std::size_t other = 0; other < end; ++other) {
      if (other == piece || !isThere_[other]) continue;
      Offer& offer = offers_[std::max(piece, other) * pieces_.size() + std::min(piece, other)];
      offer = Offer();
      const double gap = kGap * std::max(boxes_[piece].sizes().maxCoeff(), boxes_[other].sizes().maxCoeff());
      if (touchingOnly_ && boxes_[piece].squaredExteriorDistance(boxes_[other]) > gap * gap) continue;
      offer.whole = joined(pieces_[piece], pieces_[other]);
      offer.cost = offer.whole.excess() - pieces_[piece].excess() - pieces_[other].excess();
      offer.isMade = true;
    }
  }

  std::vector<Piece>& pieces_;
  std::vector<Offer> offers_;
  std::vector<Eigen::AlignedBox3d> boxes_;
  std::vector<bool> isThere_;
  bool touchingOnly_ = true;
};

}  // namespace

std::vector<Piece> joinPieces(std::vector<Piece> pieces, std::size_t most,
                              const std::function<bool(const Piece&)>& isConvex) {
  Offers offers(pieces);
  for (auto best = offers.best(isConvex); best.a != best.b; best = offers.best(isConvex)) offers.join(best);
  const auto any = [](const Piece&) { return true; };
  bool areAll = false;
  while (offers.count() > most) {
    const auto best = offers.best(any);
    if (best.a != best.b) {
      offers.join(best);
    } else if (!areAll) {
      areAll = true;
      offers.makeAll();
    } else {
      break;
    }
  }
  return offers.take();
}

}  // namespace pongsim::physics
