// How steep the surfaces of a contact are at its edge: the half-space theory, which makes a plane of either body,
// leaves out what is of that order, slopes and strains alike. What is not small is worth a warning.
//
//     balls, hollows, planes    a over the radius of either body, or over the relative one: in a socket that nearly
//                               fits the bodies are steep and strain little
//     curved bodies             slope of either body at the edge of the ellipse, or b / R_small of the two
//     stamps of revolution      g(a) / a, g the elastic approach at a: of a paraboloid that is a / R
//     pressures on a grid       peak pressure / E*: of Hertz's contact that is (2 / pi) a / R
#pragma once

#include <string>
#include <string_view>

#include <patchgrip/cli/scene/body_reader.h>
#include <patchgrip/contact/mesh_contact.h>
#include <patchgrip/contact/relative_radii.h>

namespace patchgrip::cli {

class Steepness {
 public:
  // Two bodies that make a circle of radius a [m]; elastic_approach [m] is used where they are not balls.
  static Steepness of_circle(const BodyPair& pair, double a, double elastic_approach);
  // Of a stamp, or of what a pressure makes.
  static Steepness of_stamp(double a, double elastic_approach);
  // Semi-axes a and b, `angle` of a in the frame of the two surfaces.
  static Steepness of_ellipse(const CurvedSurface& first, const CurvedSurface& second,
                              const contact::RelativeRadii& radii, double angle, double a, double b);
  static Steepness of_mesh(const contact::MeshContact& mesh, double a, double b);
  static Steepness of_pressure(double peak_pressure, double contact_modulus);
  // The same where the grid does not resolve the peak.
  static Steepness of_cells(double highest_pressure, double contact_modulus);

  double ratio() const noexcept { return ratio_; }  // of a circle and a paraboloid it is a / R
  bool is_small() const noexcept { return ratio_ <= 0.1; }
  std::string text() const;     // "a/R = 0.52 of body A"
  std::string warning() const;  // "a/R = 0.52 of body A is not small" and what that means

 private:
  Steepness(std::string name, double shown, double ratio, std::string_view of = "");
  void take_if_steeper(const Steepness& other);

  std::string name_, of_;
  double shown_, ratio_;
};

}  // namespace patchgrip::cli
