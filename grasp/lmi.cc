#include <patchgrip/grasp/lmi.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <ostream>
#include <stdexcept>
#include <string>
#include <tuple>

#include <patchgrip/contact/require.h>

namespace patchgrip::grasp {
namespace {

// The matrix of a part: its entry in `row` and `column` has the term sign z[component].
struct Cell {
  int row, column, component;
  double sign;
};

std::span<const Cell> cells(Element::Kind kind) {
  static constexpr Cell normal[] = {{1, 1, 0, 1}};
  static constexpr Cell spin[] = {{1, 1, 0, 1}, {1, 1, 3, 1}, {2, 2, 0, 1}, {2, 2, 3, -1}};
  static constexpr Cell point[] = {{1, 1, 0, 1}, {1, 1, 1, 1}, {1, 2, 2, 1}, {2, 2, 0, 1}, {2, 2, 1, -1}};
  static constexpr Cell ellipsoid[] = {{1, 1, 0, 1}, {2, 2, 0, 1}, {3, 3, 0, 1}, {4, 4, 0, 1},
                                       {1, 4, 1, 1}, {2, 4, 2, 1}, {3, 4, 3, 1}};
  switch (kind) {
    case Element::Kind::normal:
      return normal;
    case Element::Kind::spin:
      return spin;
    case Element::Kind::point:
      return point;
    default:
      return ellipsoid;
  }
}

GripLmi::Block block_of(Element::Kind kind) {
  const Cell& last = *std::ranges::max_element(cells(kind), {}, &Cell::row);
  return {last.row, kind == Element::Kind::normal || kind == Element::Kind::spin};
}

void add(GripLmi& lmi, int matrix, int block, Element::Kind kind, const Eigen::Vector4d& z) {
  Eigen::Matrix4d sum = Eigen::Matrix4d::Zero();
  for (const Cell& c : cells(kind)) sum(c.row - 1, c.column - 1) += c.sign * z[c.component];
  for (int i = 0; i < 4; ++i) {
    for (int j = i; j < 4; ++j) {
      if (sum(i, j) != 0) lmi.entries.push_back({matrix, block, i + 1, j + 1, sum(i, j)});
    }
  }
}

// u >= 0 and sum u <= 1.
void add_caps(GripLmi& lmi, int first) {
  const int n = static_cast<int>(lmi.contacts);
  lmi.blocks.push_back({n + 1, true});
  const int block = static_cast<int>(lmi.blocks.size());
  lmi.entries.push_back({0, block, n + 1, n + 1, -1});
  for (int i = 1; i <= n; ++i) {
    lmi.entries.push_back({first + i, block, i, i, 1});
    lmi.entries.push_back({first + i, block, n + 1, n + 1, -1});
  }
}

void require_representable(const std::vector<Contact>& contacts) {
  for (std::size_t i = 0; i < contacts.size(); ++i) {
    const FrictionCone& cone = contacts[i].cone();
    if (cone.model() == FrictionCone::Model::patch && cone.has_friction()) {
      contact::refuse(
          "contact " + std::to_string(i) + ": patch with mu", cone.mu(),
          "the limit surface of an exact patch is no linear matrix inequality; soft_elliptic and soft_linear "
          "are");
    }
  }
}

}  // namespace

GripLmi grip_lmi(const std::vector<Contact>& contacts, const Vector6& load, Objective objective) {
  if (objective != Objective::max_force && objective != Objective::total_force)
    throw std::invalid_argument("objective is not allowed: must be max_force or total_force");
  for (const double x : load) contact::require_finite("load", x);
  require_representable(contacts);
  const ScaledGrasp grasp(contacts);
  const Vector6 w = grasp.scaled_load(load);
  GripLmi lmi;
  lmi.contacts = contacts.size();
  if (w.norm() > 0) lmi.force = w.norm();
  if ((grasp.unresisted() * (w / lmi.force)).norm() > 100 * grasp.rounding())
    throw std::domain_error("load has a part that no contact resists: it cannot be held, whatever the grip");

  const bool capped = objective == Objective::max_force;
  const int rank = grasp.rank();
  const Matrix6& P = grasp.to_range();
  lmi.twists.resize(6, rank);
  for (int k = 0; k < rank; ++k) {
    lmi.twists.col(k) = grasp.twist(P.col(k));
    lmi.costs.push_back(-P.col(k).dot(w / lmi.force));
  }
  if (capped) lmi.costs.resize(static_cast<std::size_t>(rank) + lmi.contacts, 0);

  for (const ScaledGrasp::Part& part : grasp.parts()) {
    const Element& element = part.element;
    const Element::Kind kind = element.kind();
    const Matrix3 friction = element.mu() * element.surrogate();
    lmi.parts.push_back({kind, part.contact, Vector3(1, 1, grasp.length()).asDiagonal() * friction});
    lmi.blocks.push_back(block_of(kind));
    const int block = static_cast<int>(lmi.blocks.size());
    Matrix64 columns = element.G();
    columns.rightCols<3>() *= friction;
    for (int k = 0; k < rank; ++k) add(lmi, k + 1, block, kind, columns.transpose() * P.col(k));
    if (capped) {
      add(lmi, rank + static_cast<int>(part.contact) + 1, block, kind, Eigen::Vector4d::Unit(0));
    } else {
      add(lmi, 0, block, kind, -Eigen::Vector4d::Unit(0));
    }
  }
  if (capped) add_caps(lmi, rank);
  std::ranges::sort(lmi.entries, {},
                    [](const GripLmi::Entry& e) { return std::tuple(e.matrix, e.block, e.row, e.column); });
  return lmi;
}

Eigen::MatrixXd lmi_matrix(const GripLmi& lmi, int block, std::span<const double> x) {
  const int size = lmi.blocks[static_cast<std::size_t>(block - 1)].size;
  Eigen::MatrixXd X = Eigen::MatrixXd::Zero(size, size);
  for (const GripLmi::Entry& e : lmi.entries) {
    if (e.block != block) continue;
    X(e.row - 1, e.column - 1) += e.matrix == 0 ? -e.value : e.value * x[static_cast<std::size_t>(e.matrix - 1)];
  }
  return X.selfadjointView<Eigen::Upper>();
}

double lmi_value(const GripLmi& lmi, std::span<const double> x) {
  double sum = 0;
  for (std::size_t k = 0; k < lmi.costs.size(); ++k) sum -= lmi.costs[k] * x[k];
  return lmi.force * sum;
}

Vector6 lmi_twist(const GripLmi& lmi, std::span<const double> x) {
  return lmi.twists * Eigen::Map<const Eigen::VectorXd>(x.data(), lmi.twists.cols());
}

std::vector<ContactForce> contact_forces(const GripLmi& lmi, std::span<const Eigen::MatrixXd> Y) {
  std::vector<ContactForce> forces(lmi.contacts);
  for (std::size_t i = 0; i < lmi.parts.size(); ++i) {
    const GripLmi::Part& part = lmi.parts[i];
    Eigen::Vector4d z = Eigen::Vector4d::Zero();
    for (const Cell& c : cells(part.kind)) {
      z[c.component] += (c.row == c.column ? c.sign : 2 * c.sign) * Y[i](c.row - 1, c.column - 1);
    }
    forces[part.contact].normal += lmi.force * z[0];
    forces[part.contact].friction += lmi.force * (part.friction * z.tail<3>());
  }
  return forces;
}

void write_sdpa(std::ostream& out, const GripLmi& lmi) {
  const std::streamsize precision = out.precision(std::numeric_limits<double>::max_digits10);
  const std::ios_base::fmtflags flags = out.setf(std::ios_base::fmtflags(), std::ios_base::floatfield);
  out << "\"Grip of " << lmi.contacts << " contacts as linear matrix inequalities. Unit of force " << lmi.force
      << " N.\n"
      << lmi.costs.size() << " = number of unknowns\n"
      << lmi.blocks.size() << " = number of blocks\n";
  for (const GripLmi::Block& b : lmi.blocks) out << (b.diagonal ? -b.size : b.size) << ' ';
  out << "= sizes, diagonal blocks < 0\n";
  for (const double c : lmi.costs) out << c << ' ';
  out << '\n';
  for (const GripLmi::Entry& e : lmi.entries) {
    out << e.matrix << ' ' << e.block << ' ' << e.row << ' ' << e.column << ' ' << e.value << '\n';
  }
  out.flags(flags);
  out.precision(precision);
}

}  // namespace patchgrip::grasp
