// A grasp in numbers of order one: what every solver of this folder works on.
//
// Lengths are divided by L, a power of two near the rms distance of the contacts (but at least the moment length of a
// patch), so that dividing rounds nothing. Moments are taken about the origin; about the centroid of the contacts where
// that is farther away than 4 L, which rounds the data by eps |centroid| / L: `rounding` counts it.
//
// Not every load can be met: the wrenches of all contacts span a range R of dimension `rank` (singular values above
// rank_tolerance of the largest). A direction outside it is resisted by no contact, rho_i = 0: a load with a part there cannot
// be held, and that part is the proof. P maps coordinates in which the range is well conditioned to twists.
//
// Units    scaled: lengths / L, w L; force unchanged, moment / L.
// Throws   std::invalid_argument if there is no contact.
#pragma once

#include <cstddef>
#include <optional>
#include <span>
#include <vector>

#include <patchgrip/grasp/element.h>

namespace patchgrip::grasp {

class ScaledGrasp {
 public:
  static constexpr double rank_tolerance = 1e-10;

  // About `centre` if given. The contacts must outlive the result.
  explicit ScaledGrasp(const std::vector<Contact>& contacts, const std::optional<Vector3>& centre = std::nullopt);

  // Every contact as a sum of rays (element.h): a list of their t for each.
  ScaledGrasp(const std::vector<Contact>& contacts, std::span<const std::vector<Vector3>> rays);

  struct Part {
    Element element;
    std::size_t contact;
  };

  const std::vector<Part>& parts() const noexcept { return parts_; }
  std::size_t contacts() const noexcept { return contacts_; }

  double length() const noexcept { return length_; }          // L
  const Vector3& centre() const noexcept { return centre_; }  // moments are about it
  double rounding() const noexcept { return rounding_; }      // relative, of the scaled data

  int rank() const noexcept { return rank_; }
  const Matrix6& to_range() const noexcept { return P_; }       // P; columns beyond the rank are 0
  const Matrix6& unresisted() const noexcept { return null_; }  // projector on what no contact resists
  Vector6 scaled_load(const Vector6& load) const noexcept;      // exact but for the centre
  Vector6 twist(const Vector6& scaled_twist) const noexcept;    // in the units of the contacts
  Vector6 scaled_twist(const Vector6& twist) const noexcept;

 private:
  // Length, centre and rounding.
  void set_scale(const std::vector<Contact>& contacts);
  void find_range();

  std::vector<Part> parts_;
  std::size_t contacts_;
  Vector3 centre_ = Vector3::Zero();
  double length_ = 1;
  double rounding_ = 0x1p-53;
  int rank_ = 6;
  Matrix6 P_ = Matrix6::Identity();
  Matrix6 null_ = Matrix6::Zero();
};

}  // namespace patchgrip::grasp
