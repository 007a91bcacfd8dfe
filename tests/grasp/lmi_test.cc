#include <Eigen/Eigenvalues>
#include <Eigen/QR>
#include <cmath>
#include <limits>
#include <sstream>
#include <stdexcept>

#include <gtest/gtest.h>

#include <patchgrip/tests/grasp/lmi_draws.h>

namespace patchgrip::grasp {
namespace {

using Model = DrawnContact::Model;
using Matrices = std::vector<Eigen::MatrixXd>;

double least_eigenvalue(const Eigen::MatrixXd& X) {
  return Eigen::SelfAdjointEigenSolver<Eigen::MatrixXd>(X, Eigen::EigenvaluesOnly).eigenvalues()[0];
}

double least_eigenvalue(const GripLmi& lmi, std::span<const double> x) {
  double least = std::numeric_limits<double>::infinity();
  for (int block = 1; block <= static_cast<int>(lmi.blocks.size()); ++block)
    least = std::min(least, least_eigenvalue(lmi_matrix(lmi, block, x)));
  return least;
}

// rho(W), from the contact's geometry and the D of its model.
double resistance(const DrawnContact& c, const Vector6& W) {
  const friction::Twist slide = c.contact().sliding(W);
  return c.mu * c.dissipation({slide.vx, slide.vy, slide.w}) - c.contact().opening(W);
}

std::vector<double> unknowns(const GripLmi& lmi, const Vector6& W) {
  const Eigen::VectorXd y = lmi.twists.colPivHouseholderQr().solve(W);
  return {y.begin(), y.end()};
}

// The matrices of the forces: positive semidefinite, with 0 as an eigenvalue, where t is in the cone.
Matrices force_matrices(const LmiDraw& g, double unit) {
  Matrices Y;
  for (std::size_t i = 0; i < g.contacts.size(); ++i) {
    const DrawnContact& c = g.contacts[i];
    const double F = g.forces[i].normal / unit;
    const Vector3 t = c.mu > 0 ? Vector3(g.forces[i].friction / (c.mu * unit)) : Vector3::Zero();
    const auto point = [&](double F_1) {
      return Eigen::MatrixXd{{(F_1 + t[0]) / 2, t[1] / 2}, {t[1] / 2, (F_1 - t[0]) / 2}};
    };
    if (c.model == Model::frictionless) Y.push_back(Eigen::MatrixXd{{F}});
    if (c.model == Model::point) Y.push_back(point(F));
    if (c.model == Model::elliptic) {
      const Vector3 s(t[0], t[1], t[2] / c.e);
      Eigen::Matrix4d y = Eigen::Matrix4d::Zero();
      y.topLeftCorner<3, 3>() = F / 2 * s.normalized() * s.normalized().transpose();
      y.topRightCorner<3, 1>() = s / 2;
      y.bottomLeftCorner<1, 3>() = s.transpose() / 2;
      y(3, 3) = F / 2;
      Y.push_back(y);
    }
    if (c.model == Model::linear) {
      const double force = std::hypot(t[0], t[1]), moment = std::fabs(t[2]) / c.e;
      const double F_1 = force + moment > 0 ? F * force / (force + moment) : F, F_2 = F - F_1;
      Y.push_back(point(F_1));
      Y.push_back(Eigen::MatrixXd{{(F_2 + t[2] / c.e) / 2, 0}, {0, (F_2 - t[2] / c.e) / 2}});
    }
  }
  return Y;
}

// F_k . Y of the blocks of the parts.
double product(const GripLmi& lmi, int matrix, const Matrices& Y) {
  double sum = 0;
  for (const GripLmi::Entry& e : lmi.entries) {
    const auto block = static_cast<std::size_t>(e.block - 1);
    if (e.matrix != matrix || block >= Y.size()) continue;
    sum += (e.row == e.column ? 1 : 2) * e.value * Y[block](e.row - 1, e.column - 1);
  }
  return sum;
}

TEST(Lmi, TwistsAreAdmissibleWhereTheBlocksArePositive) {
  GraspDraws draws(1);
  for (int i = 0; i < testing::cases(200); ++i) {
    const LmiDraw g = draw_lmi(draws, 3 + i % 12, 1, true);
    const GripLmi lmi = grip_lmi(g.made(), g.load, Objective::max_force);
    const GripLmi total = grip_lmi(g.made(), g.load, Objective::total_force);
    Vector6 W = draws.load().reverse();
    double sum = 0, most = 0;
    for (const DrawnContact& c : g.contacts) {
      sum += std::max(0., resistance(c, W));
      most = std::max(most, resistance(c, W));
    }
    if (sum == 0) continue;
    const auto scaled = [&](double k, double above) {
      std::vector<double> x = unknowns(lmi, k / sum * W);
      for (const DrawnContact& c : g.contacts) x.push_back(std::max(0., resistance(c, k / sum * W)) + above);
      return x;
    };
    const double above = 1e-7 / static_cast<double>(g.contacts.size());
    EXPECT_GT(least_eigenvalue(lmi, scaled(1 - 1e-6, above)), 0);
    EXPECT_LT(least_eigenvalue(lmi, scaled(1 + 1e-6, above)), -1e-7);
    EXPECT_LT(least_eigenvalue(lmi, scaled(1 - 1e-6, -1e-7)), -9e-8);
    EXPECT_GT(least_eigenvalue(total, unknowns(total, (1 - 1e-6) / most * W)), 0);
    EXPECT_LT(least_eigenvalue(total, unknowns(total, (1 + 1e-6) / most * W)), -9e-7);
  }
}

TEST(Lmi, ForcesAreAdmissibleWhereTheirMatricesArePositive) {
  GraspDraws draws(2);
  for (int i = 0; i < testing::cases(200); ++i) {
    LmiDraw g = draw_lmi(draws, 3 + i % 12, 0.999, true);
    const GripLmi lmi = grip_lmi(g.made(), g.load, Objective::max_force);
    const Matrices Y = force_matrices(g, lmi.force);
    for (const Eigen::MatrixXd& y : Y) EXPECT_GT(least_eigenvalue(y), -1e-15);
    // F_k . Y = c_k: balance.
    for (int k = 0; k < lmi.twists.cols(); ++k)
      EXPECT_NEAR(product(lmi, k + 1, Y), lmi.costs[static_cast<std::size_t>(k)], 1e-12);
    const std::vector<ContactForce> forces = contact_forces(lmi, Y);
    for (std::size_t c = 0; c < forces.size(); ++c) {
      EXPECT_NEAR(forces[c].normal, g.forces[c].normal, 1e-14);
      EXPECT_LT((forces[c].friction - g.forces[c].friction).norm(), 1e-14);
    }
    // Friction beyond the cone.
    for (std::size_t c = 0; c < g.forces.size(); ++c) {
      const DrawnContact& k = g.contacts[c];
      if (k.mu > 0) g.forces[c].friction = 1.01 * k.mu * g.forces[c].normal * k.gradient(draws.vector());
    }
    const Matrices beyond = force_matrices(g, lmi.force);
    for (std::size_t p = 0; p < lmi.parts.size(); ++p) {
      const bool last = p + 1 == lmi.parts.size() || lmi.parts[p + 1].contact != lmi.parts[p].contact;
      if (!last || lmi.parts[p].kind == Element::Kind::normal) continue;
      const bool two = p > 0 && lmi.parts[p - 1].contact == lmi.parts[p].contact;
      EXPECT_LT(std::min(least_eigenvalue(beyond[p]), two ? least_eigenvalue(beyond[p - 1]) : 0), 0);
    }
  }
}

// The escape twist is admissible to the LMI with the least grip as its value, and so are the forces: both are optimal.
TEST(Lmi, OptimaAreThoseOfTheGrasp) {
  GraspDraws draws(3);
  for (int i = 0; i < testing::cases(100); ++i) {
    const LmiDraw g = draw_lmi(draws, 3 + i % 12, 0.9, true);
    Grasp grasp(g.made());
    const GripAnswer& a = grasp.least_grip(g.load);
    const GripLmi lmi = grip_lmi(g.made(), g.load, Objective::max_force);
    std::vector<double> x = unknowns(lmi, a.escape_twist);
    for (const ContactAnswer& c : a.contacts) x.push_back(std::max(0., c.resistance));
    EXPECT_NEAR(lmi_value(lmi, x), a.value, 1e-10 * a.value);
    EXPECT_LT((lmi_twist(lmi, x) - a.escape_twist).norm(), 1e-12 * a.escape_twist.norm());
    EXPECT_GT(least_eigenvalue(lmi, x), -1e-12 * (1 + a.escape_twist.norm()));

    const GripAnswer& b = grasp.least_total_grip(g.load);
    const GripLmi total = grip_lmi(g.made(), g.load, Objective::total_force);
    const std::vector<double> y = unknowns(total, b.escape_twist);
    EXPECT_NEAR(lmi_value(total, y), b.value, 1e-10 * b.value);
    EXPECT_GT(least_eigenvalue(total, y), -1e-12 * (1 + b.escape_twist.norm()));
  }
}

TEST(Lmi, TheFileReadsBackToTheSameNumbers) {
  GraspDraws draws(4);
  const LmiDraw g = draw_lmi(draws, 9, 0.9, true);
  for (const Objective objective : {Objective::max_force, Objective::total_force}) {
    const GripLmi lmi = grip_lmi(g.made(), g.load, objective);
    std::stringstream file;
    file << std::fixed;
    file.precision(3);
    write_sdpa(file, lmi);
    EXPECT_EQ(file.precision(), 3);
    std::string line;
    std::getline(file, line);
    EXPECT_EQ(line.substr(0, 1), "\"");
    std::size_t unknowns = 0, blocks = 0;
    file >> unknowns;
    std::getline(file, line);
    file >> blocks;
    std::getline(file, line);
    ASSERT_EQ(unknowns, lmi.costs.size());
    ASSERT_EQ(blocks, lmi.blocks.size());
    for (const GripLmi::Block& b : lmi.blocks) {
      int size = 0;
      file >> size;
      EXPECT_EQ(size, b.diagonal ? -b.size : b.size);
    }
    std::getline(file, line);
    for (const double c : lmi.costs) {
      double read = 0;
      file >> read;
      EXPECT_EQ(read, c);
    }
    for (const GripLmi::Entry& e : lmi.entries) {
      GripLmi::Entry read{};
      file >> read.matrix >> read.block >> read.row >> read.column >> read.value;
      EXPECT_EQ(read.matrix, e.matrix);
      EXPECT_EQ(read.block, e.block);
      EXPECT_EQ(read.row, e.row);
      EXPECT_EQ(read.column, e.column);
      EXPECT_EQ(read.value, e.value);
    }
    EXPECT_FALSE(file >> line) << line;
  }
}

TEST(Lmi, WhatHasNoFormIsRefused) {
  const auto contact = [](const FrictionCone& cone) {
    return Contact({Vector3(0, 0, 0.1), Vector3(0, 0, 1), Vector3(1, 0, 0)}, cone);
  };
  const std::vector<Contact> patch{contact(FrictionCone::patch(0.5, friction::HertzDisc::of_radius(0.01)))};
  const std::vector<Contact> pinch{contact(FrictionCone::point(0.5)),
                                   Contact({Vector3(0, 0, -0.1), Vector3(0, 0, -1), {}}, FrictionCone::point(0.5))};
  const Vector6 carried = spatial(Vector3(1, 0, 0), Vector3::Zero());
  const Vector6 turned = spatial(Vector3::Zero(), Vector3(0, 0, 1));
  EXPECT_THROW(grip_lmi(patch, carried, Objective::max_force), std::invalid_argument);
  EXPECT_THROW(grip_lmi({}, carried, Objective::max_force), std::invalid_argument);
  EXPECT_THROW(grip_lmi(pinch, carried, Objective::distance), std::invalid_argument);
  EXPECT_THROW(grip_lmi(pinch, std::nan("") * carried, Objective::max_force), std::invalid_argument);
  EXPECT_THROW(grip_lmi(pinch, turned, Objective::max_force), std::domain_error);
  EXPECT_EQ(grip_lmi(pinch, carried, Objective::max_force).twists.cols(), 5);
}

}  // namespace
}  // namespace patchgrip::grasp
