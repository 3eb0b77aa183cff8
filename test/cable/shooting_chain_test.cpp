// The elimination of the chain's nodes against one dense system of finite differences, and the count of negative
// directions against Euler's column.
#include "cable/shooting_chain.h"

#include <gtest/gtest.h>

#include <Eigen/Core>
#include <Eigen/LU>
#include <cmath>
#include <vector>

namespace cdpr_kinetostatics {
namespace {

constexpr double kLength = 6.0;       // in units of the shot
constexpr double kTolerance = 1e-10;  // of the shots

// A cable in three segments of unlike length whose nodes do not fit together.
struct Chain {
  ShotParameters parameters{0.8, 0.5, 0.15, 1e-3};
  double length = kLength;
  std::vector<double> share{0.0, 0.2, 0.65, 1.0};
  std::vector<Eigen::Vector2d> nodes{{-0.5, 0.02}, {-0.35, 0.1}, {0.1, 0.12}, {0.3, -0.03}};

  std::size_t size() const { return share.size() - 1; }
};

SegmentList shotSegments(const Chain& chain) {
  SegmentList segments;
  segments.resize(chain.size());
  for (std::size_t k = 0; k < chain.size(); ++k) {
    ShootingSegment& segment = segments[k];
    segment.begin = chain.share[k];
    segment.end = chain.share[k + 1];
    segment.node = chain.nodes[k];
    const ShotState start{segment.node.x(), segment.node.y(), 0.0, 0.0};
    const double t0 = segment.begin * chain.length;
    const double t1 = segment.end * chain.length;
    EXPECT_TRUE(shootAdaptive(chain.parameters, t0, t1, start, kTolerance, &segment.grid, &segment.shot));
    segment.begin_derivative = shotDerivative(chain.parameters, t0, start);
    segment.end_derivative = shotDerivative(chain.parameters, t1, segment.shot.end);
  }
  return segments;
}

// All that must vanish, and below it (x, y) of the end. The moments at A and B, and the joints between segments.
Eigen::VectorXd equations(const Chain& chain, const EndMoments& moments) {
  const SegmentList segments = shotSegments(chain);
  Eigen::VectorXd result = Eigen::VectorXd::Zero(2 * static_cast<int>(chain.nodes.size()) + 2);
  result[0] = chain.nodes.front().y() - moments.a;
  for (std::size_t k = 0; k < chain.size(); ++k) {
    const ShotState& end = segments[k].shot.end;
    const int row = 1 + 2 * static_cast<int>(k);
    result.segment<2>(row) = Eigen::Vector2d(end.alpha, end.moment) - chain.nodes[k + 1];
    result.tail<2>() += Eigen::Vector2d(end.x, end.y);
  }
  result[2 * static_cast<int>(chain.size()) + 1] = chain.nodes.back().y() - moments.b;
  return result;
}

// Moves entry `column` of (nodes, h, v, l).
Chain moved(Chain chain, int column, double change) {
  const int nodes = 2 * static_cast<int>(chain.nodes.size());
  if (column < nodes) {
    chain.nodes[column / 2][column % 2] += change;
  } else if (column < nodes + 2) {
    (column == nodes ? chain.parameters.h : chain.parameters.v) += change;
  } else {
    chain.length += change;
  }
  return chain;
}

TEST(ShootingChain, EliminationSolvesTheWholeSystem) {
  const Chain chain;
  for (const EndMoments moments : {EndMoments{}, EndMoments{0.07, -0.11}}) {
    ShootingChain elimination;
    ASSERT_TRUE(elimination.eliminate(shotSegments(chain), chain.nodes.back(), moments));

    const int unknowns = 2 * static_cast<int>(chain.nodes.size());
    Eigen::MatrixXd jacobian(unknowns + 2, unknowns + 3);
    const double d = 1e-4;  // differences of fourth order
    for (int i = 0; i < unknowns + 3; ++i) {
      const auto at = [&](double change) { return equations(moved(chain, i, change), moments); };
      jacobian.col(i) = (8.0 * (at(d) - at(-d)) - (at(2.0 * d) - at(-2.0 * d))) / (12.0 * d);
    }
    const Eigen::VectorXd residual = equations(chain, moments);
    Eigen::MatrixXd right(unknowns, 4);
    right << -residual.head(unknowns), -jacobian.topRightCorner(unknowns, 3);
    const Eigen::MatrixXd nodes = jacobian.topLeftCorner(unknowns, unknowns).partialPivLu().solve(right);
    Eigen::MatrixXd end = jacobian.bottomLeftCorner(2, unknowns) * nodes;
    end.col(0) += residual.tail<2>();
    end.rightCols<3>() += jacobian.bottomRightCorner<2, 3>();

    // The shots' own tolerance, over the step of the differences.
    const double tolerance = 1e-5;
    for (std::size_t k = 0; k < chain.nodes.size(); ++k) {
      EXPECT_LT((elimination.change(k) - nodes.middleRows<2>(2 * static_cast<int>(k))).lpNorm<Eigen::Infinity>(),
                tolerance * (1.0 + nodes.lpNorm<Eigen::Infinity>()))
          << "node " << k;
    }
    EXPECT_LT((elimination.end() - end).lpNorm<Eigen::Infinity>(), tolerance * (1.0 + end.lpNorm<Eigen::Infinity>()));

    double largest = 0.0;
    const Eigen::Vector4d factors(1.0, 0.02, -0.01, 0.3);
    for (int k = 0; k < unknowns; k += 2) largest = std::max(largest, std::abs(nodes.row(k).dot(factors)));
    EXPECT_NEAR(elimination.angleChange(factors), largest, tolerance * (1.0 + largest));
  }
}

TEST(ShootingChain, TheMomentDefectIsTheLargestOfJointsAndEnds) {
  const Chain chain;
  ShootingChain elimination;
  const EndMoments moments{0.0, 5.0};
  ASSERT_TRUE(elimination.eliminate(shotSegments(chain), chain.nodes.back(), moments));
  EXPECT_DOUBLE_EQ(elimination.momentDefect(), 5.0 - chain.nodes.back().y());
  ASSERT_TRUE(elimination.eliminate(shotSegments(chain), chain.nodes.back(), {}));
  Eigen::VectorXd defects = equations(chain, {});
  double largest = std::max(std::abs(chain.nodes.front().y()), std::abs(chain.nodes.back().y()));
  for (std::size_t k = 0; k < chain.size(); ++k) largest = std::max(largest, std::abs(defects[2 + 2 * k]));
  EXPECT_DOUBLE_EQ(elimination.momentDefect(), largest);
}

// A straight weightless column under a push P at its free end, both ends free to turn: int EI beta'^2 - P beta^2 has
// the eigenfunctions cos(n pi s/L), and a negative direction for each n = 0, 1, ... with n pi/L < sqrt(P/EI).
TEST(ShootingChain, NegativeDirectionsAreThoseOfEulersColumn) {
  for (const double push : {-1.0, 0.05, 0.7, 1.3, 2.4, 3.6}) {  // sqrt(P/EI) L/pi; the first is a pull
    Chain chain;
    chain.parameters = {push < 0.0 ? 1.0 : -std::pow(push * M_PI / kLength, 2), 0.0, 0.0, 0.0};
    for (Eigen::Vector2d& node : chain.nodes) node.setZero();
    ShootingChain elimination;
    ASSERT_TRUE(elimination.eliminate(shotSegments(chain), chain.nodes.back(), {}));
    EXPECT_EQ(elimination.negativeDirections(), push < 0.0 ? 0 : 1 + static_cast<int>(push)) << push;
  }
}

// The same where the column slides along a pulley at A: it cannot turn there, as a beam that is clamped cannot. Then
// the eigenfunctions are sin((n + 1/2) pi s/L).
TEST(ShootingChain, NegativeDirectionsOnAPulleyAreThoseOfAClampedColumn) {
  for (const double push : {-1.0, 0.3, 0.7, 1.3, 1.7, 3.6}) {
    Chain chain;
    chain.parameters = {push < 0.0 ? 1.0 : -std::pow(push * M_PI / kLength, 2), 0.0, 0.0, 0.0};
    for (Eigen::Vector2d& node : chain.nodes) node.setZero();
    ShootingChain elimination;
    ASSERT_TRUE(elimination.eliminate(shotSegments(chain), chain.nodes.back(), {0.0, 0.0, true}));
    EXPECT_EQ(elimination.negativeDirections(), push < 0.0 ? 0 : static_cast<int>(push + 0.5)) << push;
  }
}

}  // namespace
}  // namespace cdpr_kinetostatics
