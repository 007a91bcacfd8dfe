#include <patchgrip/verification/fe/model.h>

#include <getfem/getfem_export.h>
#include <getfem/getfem_generic_assembly.h>
#include <getfem/getfem_im_data.h>
#include <getfem/getfem_import.h>
#include <getfem/getfem_interpolation.h>
#include <getfem/getfem_model_solvers.h>
#include <getfem/getfem_models.h>
#include <gmsh.h>

#include <algorithm>
#include <exception>
#include <map>
#include <stdexcept>
#include <utility>

namespace patchgrip::verification {
namespace {

using Vector = getfem::model_real_plain_vector;

constexpr int most_iterations = 80;

Point point_of(const bgeot::base_node& node) {
  Point p{0, 0, 0};
  for (std::size_t i = 0; i < node.size(); ++i) p[i] = node[i];
  return p;
}

std::size_t region_of(int region) { return region == Model::body ? std::size_t(-1) : static_cast<std::size_t>(region); }

}  // namespace

struct Model::Parts {
  getfem::mesh mesh;
  getfem::mesh_im inside;  // exact for the strain energy of quadratic elements
  getfem::mesh_im faces;   // finer: contact ends within elements
  getfem::model model;
  std::map<std::string, std::unique_ptr<getfem::mesh_fem>> fems;
  std::map<std::string, std::unique_ptr<getfem::im_data>> histories;
  std::map<std::string, std::size_t> loads;

  getfem::mesh_region faces_of(int region) const {
    return region == body ? getfem::mesh_region::all_convexes() : mesh.region(region_of(region));
  }
  const getfem::mesh_im& rule(int region) const { return region == body ? inside : faces; }

  getfem::mesh_fem& fem(int components, int degree) {
    auto& place = fems[std::to_string(components) + "x" + std::to_string(degree)];
    if (!place) {
      place = std::make_unique<getfem::mesh_fem>(mesh, bgeot::dim_type(components));
      place->set_finite_element(
          getfem::fem_descriptor("FEM_PK(" + std::to_string(mesh.dim()) + "," + std::to_string(degree) + ")"));
    }
    return *place;
  }

  Vector interpolated(const std::string& expression, const getfem::mesh_fem& fem, int region = body) const {
    Vector values;
    getfem::ga_interpolation_Lagrange_fem(model, expression, fem, values, faces_of(region));
    return values;
  }
};

Model::Model(const Mesh& mesh) : parts_(std::make_unique<Parts>()) {
  gmm::set_traces_level(0);
  gmm::set_warning_level(0);
  getfem::import_mesh(mesh.file.string(), "gmsh", parts_->mesh);
  const bool is_plane = mesh.dimension == 2;
  parts_->inside.init_with_mesh(parts_->mesh);
  parts_->faces.init_with_mesh(parts_->mesh);
  // Curved elements and the factor r of revolution ask for more than straight ones in space.
  parts_->inside.set_integration_method(
      getfem::int_method_descriptor(is_plane ? "IM_TRIANGLE(4)" : "IM_TETRAHEDRON(3)"));
  parts_->faces.set_integration_method(
      getfem::int_method_descriptor(is_plane ? "IM_TRIANGLE(4)" : "IM_TETRAHEDRON(6)"));
}

Model::~Model() = default;
Model::Model(Model&&) noexcept = default;

void Model::mark(int region, const std::function<bool(const Point&)>& where) {
  getfem::mesh& mesh = parts_->mesh;
  getfem::mesh_region outside;
  getfem::outer_faces_of_mesh(mesh, outside);
  auto& marked = mesh.region(region_of(region));
  for (getfem::mr_visitor face(outside); !face.finished(); ++face) {
    const auto corners = mesh.points_of_face_of_convex(face.cv(), face.f());
    bool is_inside = true;
    for (const auto& corner : corners) is_inside = is_inside && where(point_of(corner));
    if (is_inside) marked.add(face.cv(), face.f());
  }
  if (marked.nb_convex() == 0) throw std::runtime_error("no face of the mesh is in region " + std::to_string(region));
}

void Model::field(const std::string& name, int components, int degree, int region) {
  const auto& fem = parts_->fem(components, degree);
  if (region == body) {
    parts_->model.add_fem_variable(name, fem);
  } else {
    parts_->model.add_filtered_fem_variable(name, fem, region_of(region));
  }
}

void Model::unknown(const std::string& name, double start) {
  parts_->model.add_fixed_size_variable(name, 1);
  parts_->model.set_real_variable(name)[0] = start;
}

void Model::known(const std::string& name, double value) { known(name, std::span(&value, 1)); }

void Model::known(const std::string& name, std::span<const double> vector) {
  auto& model = parts_->model;
  const Vector values(vector.begin(), vector.end());
  if (model.variable_exists(name)) {
    gmm::copy(values, model.set_real_variable(name));
  } else {
    model.add_initialized_fixed_size_data(name, values);
  }
}

void Model::known_field(const std::string& name, const std::string& like,
                        const std::function<Point(const Point&)>& value) {
  auto& model = parts_->model;
  const auto& fem = model.mesh_fem_of_variable(like);
  const std::size_t components = fem.get_qdim();
  Vector values(fem.nb_basic_dof());
  for (std::size_t i = 0; i < values.size(); i += components) {
    const Point at = value(point_of(fem.point_of_basic_dof(i)));
    for (std::size_t k = 0; k < components; ++k) values[i + k] = at[k];
  }
  if (model.variable_exists(name)) {
    gmm::copy(values, model.set_real_variable(name));
  } else {
    model.add_initialized_fem_data(name, fem, values);
  }
}

void Model::remember(const std::string& name, const std::string& like) {
  auto& model = parts_->model;
  if (!model.variable_exists(name)) model.add_fem_data(name, model.mesh_fem_of_variable(like));
  gmm::copy(model.real_variable(like), model.set_real_variable(name));
}

void Model::history(const std::string& name, const std::vector<std::size_t>& sizes) {
  auto& data = parts_->histories[name];
  data = std::make_unique<getfem::im_data>(parts_->inside);
  bgeot::multi_index shape(sizes.size());
  std::copy(sizes.begin(), sizes.end(), shape.begin());
  data->set_tensor_size(shape);
  parts_->model.add_im_data(name, *data);
}

void Model::record(const std::string& name, const std::string& expression) {
  Vector values;
  getfem::ga_interpolation_im_data(parts_->model, expression, *parts_->histories.at(name), values);
  gmm::copy(values, parts_->model.set_real_variable(name));
}

void Model::linear(const std::string& term, int region) {
  getfem::add_linear_term(parts_->model, parts_->rule(region), term, region_of(region));
}

void Model::nonlinear(const std::string& term, int region) {
  getfem::add_nonlinear_term(parts_->model, parts_->rule(region), term, region_of(region));
}

void Model::load(const std::string& unknown, double value) {
  const Vector side(1, value);
  const auto known = parts_->loads.find(unknown);
  if (known == parts_->loads.end()) {
    parts_->loads[unknown] = getfem::add_explicit_rhs(parts_->model, unknown, side);
  } else {
    getfem::set_private_data_rhs(parts_->model, known->second, side);
  }
}

void Model::hold(const std::string& field, int region, const std::string& at_known_field) {
  getfem::add_Dirichlet_condition_with_simplification(parts_->model, field, region_of(region), at_known_field);
}

void Model::start(const std::string& field, double value) {
  auto& values = parts_->model.set_real_variable(field);
  std::fill(values.begin(), values.end(), value);
}

int Model::solve(double residual, const std::string& place) {
  gmm::iteration iteration(residual, 0, most_iterations);
  try {
    getfem::standard_solve(parts_->model, iteration, getfem::rselect_linear_solver(parts_->model, "mumps"));
  } catch (const std::exception& error) {
    throw std::runtime_error(place + ": " + error.what());
  }
  if (!iteration.converged()) {
    throw std::runtime_error(
        place + ": Newton's method did not converge: residual " + std::to_string(iteration.get_res()) + " after " +
        std::to_string(iteration.get_iteration()) + " iterations, wanted " + std::to_string(residual));
  }
  return static_cast<int>(iteration.get_iteration());
}

double Model::number(const std::string& unknown) const { return parts_->model.real_variable(unknown)[0]; }

double Model::integral(const std::string& expression, int region) const {
  getfem::ga_workspace workspace(parts_->model);
  workspace.add_expression(expression, parts_->rule(region), parts_->faces_of(region), 0);
  workspace.assembly(0);
  return workspace.assembled_potential();
}

std::size_t Model::unknowns() const { return parts_->model.nb_dof(); }

std::vector<std::pair<Point, double>> Model::along(const std::string& expression, int region) const {
  auto& fem = parts_->fem(1, 1);
  const Vector values = parts_->interpolated(expression, fem, region);
  const dal::bit_vector nodes = fem.basic_dof_on_region(region_of(region));
  std::vector<std::pair<Point, double>> line;
  for (dal::bv_visitor i(nodes); !i.finished(); ++i) line.emplace_back(point_of(fem.point_of_basic_dof(i)), values[i]);
  std::sort(line.begin(), line.end());
  return line;
}

PlaneField Model::plane_field(const std::string& expression, const std::string& displacement) const {
  auto& fem = parts_->fem(1, 1);
  const Vector values = parts_->interpolated(expression, fem);
  PlaneField field;
  field.values.assign(values.begin(), values.end());
  for (std::size_t i = 0; i < fem.nb_basic_dof(); ++i) {
    const auto node = fem.point_of_basic_dof(i);
    field.points.push_back({node[0], node[1]});
  }
  if (!displacement.empty()) {
    for (std::size_t k = 0; k < 2; ++k) {
      const Vector moved = parts_->interpolated(displacement + "(" + std::to_string(k + 1) + ")", fem);
      for (std::size_t i = 0; i < moved.size(); ++i) field.points[i][k] += moved[i];
    }
  }
  for (dal::bv_visitor element(parts_->mesh.convex_index()); !element.finished(); ++element) {
    const auto& nodes = fem.ind_basic_dof_of_element(element);
    field.triangles.push_back({nodes[0], nodes[1], nodes[2]});
  }
  return field;
}

void Model::write_vtk(const std::filesystem::path& file, const std::vector<std::string>& fields,
                      const std::vector<std::pair<std::string, std::string>>& expressions) const {
  getfem::vtk_export vtk(file.string(), true);
  auto& fem = parts_->fem(1, 1);
  vtk.exporting(parts_->mesh);
  vtk.write_mesh();
  for (const auto& name : fields) {
    vtk.write_point_data(parts_->model.mesh_fem_of_variable(name), parts_->model.real_variable(name), name);
  }
  for (const auto& [name, expression] : expressions) {
    vtk.write_point_data(fem, parts_->interpolated(expression, fem), name);
  }
}

std::string getfem_version() { return GETFEM_VERSION; }
std::string gmsh_version() { return GMSH_API_VERSION; }

}  // namespace patchgrip::verification
