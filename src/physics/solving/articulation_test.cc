#include "physics/solving/articulation.hh"

#include <gtest/gtest.h>

#include <Eigen/Dense>
#include <random>
#include <vector>

#include "physics/convert.hh"
#include "physics/lcp/elimination.hh"

namespace pongsim::physics {
namespace {

using Matrix = Eigen::MatrixXd;
using Values = Eigen::VectorXd;
using Matrix6 = Eigen::Matrix<double, 6, 6>;

constexpr double kTolerance = 1e-10;

Matrix3 crossMatrix(const Vector3& r) {
  return (Matrix3() << 0, -r.z(), r.y(), r.z(), 0, -r.x(), -r.y(), r.x(), 0).finished();
}

/// The velocity at a point by that at a centre of mass, to which `arm` points.
Matrix6 toPoint(const Vector3& arm) {
  Matrix6 T = Matrix6::Identity();
  T.topRightCorner<3, 3>() = -crossMatrix(arm);
  return T;
}

/// Random trees, and what moves them by dense matrices: velocity changes are G q + g, with q the velocities of freedoms
/// and roots, of which (G^T M G + damping) q = G^T (J^T x - M g) + damping * target.
class RandomTrees {
 public:
  explicit RandomTrees(unsigned seed) : random_(seed) {
    for (int joint = 0; joint < kBodies - 2; ++joint) addJoint(joint);
    tree_.find(joints_);
    articulation_.begin(tree_, kBodies);
    M_ = Matrix::Zero(6 * kBodies, 6 * kBodies);
    for (int body = 0; body < kBodies; ++body) {
      const Matrix6 factor = Matrix6::NullaryExpr([this] { return number(); });
      const Matrix6 inertia = factor * factor.transpose() + 0.1 * Matrix6::Identity();
      M_.block<6, 6>(6 * body, 6 * body) = inertia;
      Articulation::Inertia& own = articulation_.inertia(static_cast<std::size_t>(body));
      for (int i = 0; i < 6; ++i) {
        own[static_cast<std::size_t>(i)].fill(0);
        for (int k = 0; k < 6; ++k) own[static_cast<std::size_t>(i)][static_cast<std::size_t>(k)] = inertia(i, k);
      }
    }
    findMotion();
  }

  Articulation& articulation() { return articulation_; }
  double number() { return std::uniform_real_distribution<>(-1, 1)(random_); }
  int body() { return static_cast<int>(random_() % kBodies); }

  /// A row of J on a body and, unless that is the same, on another one.
  Values row(int one, int other) {
    Values J = Values::Zero(6 * kBodies);
    for (const int each : {one, other}) {
      J.segment<6>(6 * each) = Values::NullaryExpr(6, [this] { return number(); });
    }
    return J;
  }

  Values changeByJoints() const { return G_ * solve(D_ * target_ - G_.transpose() * M_ * g_) + g_; }
  Matrix changeBy(const Matrix& impulses) const { return G_ * solve(G_.transpose() * impulses); }

  static constexpr int kBodies = 12;

 private:
  Matrix solve(const Matrix& right) const { return (G_.transpose() * M_ * G_ + D_).ldlt().solve(right); }

  btVector3 vector() { return {number(), number(), number()}; }

  /// Holds the next body to the world or to one before it, by up to three freedoms; the last two bodies are alone.
  void addJoint(int joint) {
    const int other = static_cast<int>(random_() % static_cast<unsigned>(joint + 2)) - 1;
    joints_.push_back(random_() % 2 == 0 ? JointBodies{other, joint + 1} : JointBodies{joint + 1, other});
    JointMotion& motion = motions_.emplace_back();
    for (btVector3* each : {&motion.parentArm, &motion.childArm, &motion.linear, &motion.angular}) *each = vector();
    motion.count = random_() % 4;
    for (std::size_t i = 0; i < motion.count; ++i) {
      motion.freedoms[i] = {vector(), vector(), static_cast<double>(random_() % 2), number()};
    }
    relative_.push_back({vector(), vector()});
  }

  void findMotion() {
    int freedoms = 0;
    for (const JointMotion& motion : motions_) freedoms += static_cast<int>(motion.count);
    for (int body = 0; body < kBodies; ++body) freedoms += tree_.linkOf(body) < 0 ? 6 : 0;
    G_ = Matrix::Zero(6 * kBodies, freedoms);
    D_ = Matrix::Zero(freedoms, freedoms);
    g_ = Values::Zero(6 * kBodies);
    target_ = Values::Zero(freedoms);
    int next = 0;
    for (int body = 0; body < kBodies; ++body) {
      if (tree_.linkOf(body) >= 0) continue;
      G_.block<6, 6>(6 * body, next).setIdentity();
      next += 6;
    }
    for (const JointTree::Link& link : tree_.links()) next = follow(link, next);
  }

  /// Writes the motion of a link, which is that of its parent and of its joint.
  int follow(const JointTree::Link& link, int next) {
    const auto number = static_cast<std::size_t>(link.joint);
    const JointMotion& motion = motions_[number];
    const auto& [linear, angular] = relative_[number];
    articulation_.add(link, motion, linear, angular);
    const double sign = link.isReversed ? -1 : 1;
    const Vector3 own = fromBullet(link.isReversed ? motion.parentArm : motion.childArm);
    const Vector3 others = fromBullet(link.isReversed ? motion.childArm : motion.parentArm);
    const Matrix6 back = toPoint(own).inverse();
    if (link.parent >= 0) {
      const Matrix6 along = back * toPoint(others);
      G_.middleRows<6>(6 * link.body) = along * G_.middleRows<6>(6 * link.parent);
      g_.segment<6>(6 * link.body) = along * g_.segment<6>(6 * link.parent);
    }
    const auto spatial = [](const btVector3& v, const btVector3& w) {
      return (Values(6) << fromBullet(v), fromBullet(w)).finished();
    };
    g_.segment<6>(6 * link.body) += sign * back * spatial(motion.linear - linear, motion.angular - angular);
    for (std::size_t i = 0; i < motion.count; ++i, ++next) {
      const JointMotion::Freedom& freedom = motion.freedoms[i];
      G_.block<6, 1>(6 * link.body, next) = sign * back * spatial(freedom.linear, freedom.angular);
      D_(next, next) = freedom.damping;
      target_[next] = freedom.velocity;
    }
    return next;
  }

  std::mt19937 random_;
  std::vector<JointBodies> joints_;
  std::vector<JointMotion> motions_;
  /// Velocities of children relative to parents.
  std::vector<std::pair<btVector3, btVector3>> relative_;
  JointTree tree_;
  Articulation articulation_;
  Matrix M_, G_, D_;
  Values g_, target_;
};

Values listed(std::span<const Articulation::Vector> changes) {
  Values all(6 * static_cast<int>(changes.size()));
  for (int i = 0; i < all.size(); ++i)
    all[i] = changes[static_cast<std::size_t>(i / 6)][static_cast<std::size_t>(i % 6)];
  return all;
}

TEST(Articulation, MovesBodiesAsTheirJointsAskFor) {
  for (unsigned seed = 0; seed < 50; ++seed) {
    RandomTrees trees(seed);
    ASSERT_TRUE(trees.articulation().factor());
    const Values expected = trees.changeByJoints();
    EXPECT_LT((listed(trees.articulation().changeByJoints()) - expected).norm(), kTolerance * expected.norm()) << seed;
  }
}

TEST(Articulation, RespondsToImpulses) {
  constexpr int kRows = 7;
  for (unsigned seed = 0; seed < 50; ++seed) {
    RandomTrees trees(seed);
    Articulation& articulation = trees.articulation();
    ASSERT_TRUE(articulation.factor());
    const std::size_t width = articulation.coordinates();
    ASSERT_EQ(width % 4, 0U);
    std::vector<double> Z(kRows * width, 0.0);
    Matrix J(kRows, 6 * RandomTrees::kBodies);
    std::vector<int> places;
    for (int i = 0; i < kRows; ++i) {
      const int one = trees.body(), other = trees.body();
      const Values row = trees.row(one, other);
      J.row(i) = row.transpose();
      const std::vector<Articulation::End> ends = {{one, &row[6 * one]}, {other, &row[6 * other]}};
      articulation.resolve(std::span(ends).first(one == other ? 1 : 2), &Z[static_cast<std::size_t>(i) * width]);
      places.push_back(kRows - 1 - i);
    }
    const Matrix response = trees.changeBy(J.transpose());
    const Matrix expected = J * response;
    std::vector<double> A(kRows * widthFor(kRows), 0.0);
    addSquare(Z.data(), width, places, {A.data(), widthFor(kRows), kRows});
    for (int i = 0; i < kRows; ++i) {
      for (int j = i; j < kRows; ++j) {
        EXPECT_NEAR(A[static_cast<std::size_t>(i) * widthFor(kRows) + static_cast<std::size_t>(j)],
                    expected(kRows - 1 - i, kRows - 1 - j), kTolerance * expected.norm());
      }
      const Values change =
          listed(articulation.changeBy(std::span(Z).subspan(static_cast<std::size_t>(i) * width, width)));
      EXPECT_LT((change - response.col(i)).norm(), kTolerance * response.norm()) << seed;
    }
  }
}

TEST(Articulation, RefusesLinksWithoutInertia) {
  const std::vector<JointBodies> joints = {{-1, 0}};
  JointTree tree;
  tree.find(joints);
  Articulation articulation;
  articulation.begin(tree, 1);
  JointMotion motion;
  motion.parentArm = motion.childArm = {0, 0, 0};
  motion.freedoms[0] = {{0, 0, 0}, {0, 0, 1}};
  motion.count = 1;
  articulation.add(tree.links()[0], motion, {0, 0, 0}, {0, 0, 0});
  for (Articulation::Vector& row : articulation.inertia(0)) row.fill(0);
  EXPECT_FALSE(articulation.factor());
}

}  // namespace
}  // namespace pongsim::physics
