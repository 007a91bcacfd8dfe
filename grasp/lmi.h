// The grip problem as linear matrix inequalities: for solvers of semidefinite programs, and as an independent check.
//
// The literature that the seed cites (5254: Buss, Hashimoto and Moore 1996, Han, Trinkle and Li 2000) writes what a
// contact can transmit as one positive semidefinite matrix; z = (F, t_u, t_v, t_M), t = (R_u, R_v, R_M / e) / mu:
//
//     frictionless   z_0
//     point          [z_0 + z_1, z_2; z_2, z_0 - z_1]
//     soft elliptic  4 x 4: z_0 on the diagonal, (z_1, z_2, z_3) in the rest of the last row and column
//     soft linear    F = F_1 + F_2: that of a point of F_1, and the two numbers F_2 +- t_M
//
// Each of these cones is its own dual: with z = (u_i - n_i . w_i, mu v_i), v_i = (v_u, v_v, e w), the same matrices say
// that the resistance rho_i(W) is at most u_i. So the two problems of grip_problem.h are the pair that SDPA solves,
//
//     min sum c_k x_k :  X = sum F_k x_k - F_0 >= 0          max F_0 . Y :  F_k . Y = c_k,  Y >= 0
//
// with x = (W, u), -c x = w . W, u >= 0, sum u <= 1 (total_force: x = W, u = 1). The equalities are the balance of
// forces and the caps as they stand, with twist and u as their multipliers; Y holds the forces, F = tr Y and so on
// (contact_forces()). Written in forces instead, the problem would need a basis of the null space of G: 4 n - 6 matrices,
// each of which fills all n blocks. Here there are 6 + n, and a contact has at most 7 entries in each of 7 of them.
//
// W = P y in the coordinates of scaled_grasp.h, lengths over L and the load over its size: the equalities are nearly
// orthonormal whatever the units and the rank. Only loads that contacts resist at all have a finite form.
//
// Units    of x and Y those of scaled_grasp.h, the load 1; twists, force and contact_forces() in SI.
// Throws   grip_lmi: std::invalid_argument on exact patches (their limit surface is no such cone), objectives other
//          than max_force and total_force, what is not finite and a grasp without contacts; std::domain_error on a load
//          with a part that no contact resists.
#pragma once

#include <Eigen/Core>
#include <iosfwd>
#include <span>
#include <vector>

#include <patchgrip/grasp/grip_problem.h>

namespace patchgrip::grasp {

// Rows, columns and blocks are counted from 1, as in SDPA's files; the matrix k = 0 is F_0.
struct GripLmi {
  struct Block {
    int size;
    bool diagonal;
  };
  struct Entry {
    int matrix, block, row, column;  // row <= column
    double value;
  };
  struct Part {
    Element::Kind kind;
    std::size_t contact;
    Matrix3 friction;  // (R_u, R_v, R_M) = friction (z_1, z_2, z_3)
  };

  std::vector<double> costs;   // c_1 ...
  std::vector<Block> blocks;   // one a part, then that of u and 1 - sum u
  std::vector<Entry> entries;  // by matrix, block, row and column
  std::vector<Part> parts;
  std::size_t contacts = 0;
  double force = 1;                                 // of the unit [N]
  Eigen::Matrix<double, 6, Eigen::Dynamic> twists;  // W = twists y, of the first unknowns y
};

GripLmi grip_lmi(const std::vector<Contact>& contacts, const Vector6& load, Objective objective);

// X at x, one of its blocks.
Eigen::MatrixXd lmi_matrix(const GripLmi& lmi, int block, std::span<const double> x);

// -sum c_k x_k [N], and W.
double lmi_value(const GripLmi& lmi, std::span<const double> x);
Vector6 lmi_twist(const GripLmi& lmi, std::span<const double> x);

// Of Y, the block of each part.
std::vector<ContactForce> contact_forces(const GripLmi& lmi, std::span<const Eigen::MatrixXd> Y);

// SDPA's sparse format (.dat-s), 17 digits.
void write_sdpa(std::ostream& out, const GripLmi& lmi);

}  // namespace patchgrip::grasp
