// A boundary value problem for GetFEM, said in its weak form language: fields, terms, conditions; then Newton's method.
//
// Displacements are quadratic on triangles or tetrahedra. Contact and friction are augmented Lagrangians with one
// multiplier field on the contact face, solved by the semi-smooth Newton method: no penalty in the answer.
//
// Terms are strings of GetFEM's language: u, Grad_u, Test_u, X, names of known numbers; they are integrated over a
// region, or over the whole body.
//
// Throws   std::runtime_error, with the place, where the mesh cannot be read and where Newton's method does not
//          converge: no number leaves an unsolved model.
#pragma once

#include <array>
#include <cstddef>
#include <functional>
#include <memory>
#include <span>
#include <string>
#include <vector>

#include <patchgrip/verification/fe/mesh.h>

namespace patchgrip::verification {

// Regions of the boundary, by what happens there.
namespace region {
inline constexpr int contact = 1, far = 2, axis = 3, side = 4, held = 5;
}

using Point = std::array<double, 3>;

// Values at nodes of a plane mesh.
struct PlaneField {
  std::vector<std::array<double, 2>> points;
  std::vector<std::array<std::size_t, 3>> triangles;
  std::vector<double> values;
};

class Model {
 public:
  static constexpr int body = -1;  // the region of everything

  explicit Model(const Mesh& mesh);
  ~Model();
  Model(Model&&) noexcept;

  // The faces of the boundary all of whose corners fulfil `where`.
  void mark(int region, const std::function<bool(const Point&)>& where);

  void field(const std::string& name, int components, int degree, int region = body);
  void unknown(const std::string& name, double start = 0);
  void known(const std::string& name, double value);  // again: changes it
  void known(const std::string& name, std::span<const double> vector);
  // A field of its own, like that of `like`, with the value of a function of the place.
  void known_field(const std::string& name, const std::string& like, const std::function<Point(const Point&)>& value);
  void remember(const std::string& name,
                const std::string& like);  // a known field: `like` as it is; again: as it is now
  void history(const std::string& name,
               const std::vector<std::size_t>& sizes);                  // at every point of integration, from 0
  void record(const std::string& name, const std::string& expression);  // into a history

  void linear(const std::string& term, int region = body);
  void nonlinear(const std::string& term, int region = body);
  void load(const std::string& unknown, double value);  // right side of its equation; again: changes it
  void hold(const std::string& field, int region, const std::string& at_known_field = "");  // else at zero
  void start(const std::string& field, double value);

  // Newton's method to a residual of `residual` in the largest norm. Returns the iterations it took.
  int solve(double residual, const std::string& place);

  double number(const std::string& unknown) const;
  double integral(const std::string& expression, int region = body) const;
  std::size_t unknowns() const;

  // An expression at the nodes of a region, sorted by their first coordinate.
  std::vector<std::pair<Point, double>> along(const std::string& expression, int region) const;
  // Of a body of revolution, moved by `displacement` if that is a field.
  PlaneField plane_field(const std::string& expression, const std::string& displacement = "") const;
  void write_vtk(const std::filesystem::path& file, const std::vector<std::string>& fields,
                 const std::vector<std::pair<std::string, std::string>>& expressions) const;

 private:
  struct Parts;
  std::unique_ptr<Parts> parts_;
};

std::string getfem_version();
std::string gmsh_version();

}  // namespace patchgrip::verification
