#include <patchgrip/grasp/internal_forces.h>

#include <Eigen/SVD>

#include <patchgrip/grasp/scaled_grasp.h>

namespace patchgrip::grasp {
namespace {

using Wide = Eigen::Matrix<double, 6, Eigen::Dynamic>;

// The component of a contact that a column of G stands for: 0 F, 1 R_u, 2 R_v, 3 R_M, and its unit.
struct Column {
  std::size_t contact;
  int component;
  double unit;
};

// Parts of one contact share its normal force.
std::vector<Column> columns_of(const ScaledGrasp& grasp, Wide& G) {
  std::vector<Column> columns;
  G.resize(6, static_cast<Eigen::Index>(4 * grasp.parts().size()));
  const auto add = [&](const ScaledGrasp::Part& part, int component, double unit) {
    G.col(static_cast<Eigen::Index>(columns.size())) = unit * part.element.G().col(component);
    columns.push_back({part.contact, component, unit});
  };
  for (const ScaledGrasp::Part& part : grasp.parts()) {
    const bool first = columns.empty() || columns.back().contact != part.contact;
    if (first) add(part, 0, 1);
    for (Eigen::Index k = part.element.first(); k < part.element.first() + part.element.size(); ++k) {
      add(part, static_cast<int>(k) + 1, k == 2 ? part.element.moment_length() : 1);
    }
  }
  G.conservativeResize(6, static_cast<Eigen::Index>(columns.size()));
  return columns;
}

}  // namespace

InternalForces internal_forces(const std::vector<Contact>& contacts) {
  const ScaledGrasp grasp(contacts, Vector3::Zero());
  Wide G;
  const std::vector<Column> columns = columns_of(grasp, G);
  const Eigen::JacobiSVD<Eigen::MatrixXd> svd(G, Eigen::ComputeFullV);
  InternalForces all;
  all.rank = grasp.rank();
  all.components = static_cast<int>(columns.size());
  for (Eigen::Index j = all.rank; j < all.components; ++j) {
    std::vector<ContactForce> forces(contacts.size());
    for (std::size_t i = 0; i < columns.size(); ++i) {
      const auto& [contact, component, unit] = columns[i];
      const double x = unit * svd.matrixV()(static_cast<Eigen::Index>(i), j);
      if (component == 0) forces[contact].normal = x;
      if (component > 0) forces[contact].friction[component - 1] = component == 3 ? grasp.length() * x : x;
    }
    all.basis.push_back(std::move(forces));
  }
  return all;
}

LeastNormForces least_norm_forces(const std::vector<Contact>& contacts, const Vector6& load) {
  const ScaledGrasp grasp(contacts, Vector3::Zero());
  Wide B(6, static_cast<Eigen::Index>(contacts.size()));
  for (const ScaledGrasp::Part& part : grasp.parts()) {
    B.col(static_cast<Eigen::Index>(part.contact)) = part.element.N();
  }
  Eigen::JacobiSVD<Eigen::MatrixXd> svd(B, Eigen::ComputeThinU | Eigen::ComputeThinV);
  svd.setThreshold(ScaledGrasp::rank_tolerance);
  const Vector6 w = grasp.scaled_load(load);
  const Eigen::VectorXd F = svd.solve(Eigen::VectorXd(-w));
  const Vector6 r = w + B * F;
  const Vector3 f = r.head<3>();
  LeastNormForces least;
  least.normal_forces.assign(F.begin(), F.end());
  least.residual = spatial(f, grasp.length() * r.tail<3>());
  least.rank = static_cast<int>(svd.rank());
  return least;
}

}  // namespace patchgrip::grasp
