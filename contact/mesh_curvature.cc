#include <patchgrip/contact/mesh_curvature.h>
#include <patchgrip/contact/require.h>

#define CGAL_EIGEN3_ENABLED
#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>
#include <set>
#include <sstream>
#include <stdexcept>
#include <string>
#include <vector>

#include <CGAL/Monge_via_jet_fitting.h>
#include <CGAL/Simple_cartesian.h>

namespace patchgrip::contact {
namespace {

using Kernel = CGAL::Simple_cartesian<double>;
using Jets = CGAL::Monge_via_jet_fitting<Kernel>;
using Point = Kernel::Point_3;
using Direction = Kernel::Vector_3;

constexpr std::size_t fewest = 40;  // vertices of a fit
constexpr double unknowns = 15;     // of a polynomial of fourth degree
constexpr double certainty = 60;
constexpr double largest_condition = 1e8;

Point point_of(const Vector& v) { return {v[0], v[1], v[2]}; }
Vector vector_of(const Point& p) { return {p.x(), p.y(), p.z()}; }
Vector vector_of(const Direction& d) { return {d.x(), d.y(), d.z()}; }

// The vertices around a point, nearest first along the mesh: round also where its triangles are long.
class Neighbourhood {
 public:
  Neighbourhood(const TriangleMesh& mesh, const TriangleMesh::Triangle& start, const Point& centre)
      : mesh_(mesh), centre_(centre) {
    for (const std::size_t vertex : start) offer(vertex);
  }

  // False where a border or the end of the mesh comes first.
  bool grow_to(std::size_t count) {
    while (found_.size() < count) {
      if (next_.empty()) return false;
      const std::size_t vertex = next_.begin()->second;
      if (mesh_.on_border(vertex)) {
        border_ = vertex;
        return false;
      }
      next_.erase(next_.begin());
      found_.push_back(point_of(mesh_.vertices()[vertex]));
      for (const std::size_t other : mesh_.neighbours(vertex)) offer(other);
    }
    return true;
  }

  const std::vector<Point>& points() const { return found_; }

  // Another vertex so close to the border vertex met that the two were meant to be one; its distance.
  std::optional<double> seam() const {
    if (!border_) return std::nullopt;
    constexpr double meant_as_one = 1e-6;  // of the shortest side at the vertex
    const Point at = point_of(mesh_.vertices()[*border_]);
    double shortest = std::numeric_limits<double>::infinity(), nearest = shortest;
    for (const std::size_t other : mesh_.neighbours(*border_)) {
      shortest = std::min(shortest, CGAL::squared_distance(at, point_of(mesh_.vertices()[other])));
    }
    for (std::size_t other = 0; other < mesh_.vertices().size(); ++other) {
      if (other == *border_ || !mesh_.on_border(other)) continue;
      nearest = std::min(nearest, CGAL::squared_distance(at, point_of(mesh_.vertices()[other])));
    }
    if (!(nearest < meant_as_one * meant_as_one * shortest)) return std::nullopt;
    return std::sqrt(nearest);
  }

 private:
  void offer(std::size_t vertex) {
    if (seen_.insert(vertex).second)
      next_.emplace(CGAL::squared_distance(centre_, point_of(mesh_.vertices()[vertex])), vertex);
  }

  const TriangleMesh& mesh_;
  Point centre_;
  std::vector<Point> found_;
  std::optional<std::size_t> border_;
  std::set<std::size_t> seen_;
  std::set<std::pair<double, std::size_t>> next_;
};

// z over the tangent plane of the fit: z = k1 x^2/2 + k2 y^2/2 + third and fourth order.
double height(const Jets::Monge_form& form, double x, double y) {
  const auto& c = form.coefficients();
  const double third = c[2] * x * x * x + 3 * c[3] * x * x * y + 3 * c[4] * x * y * y + c[5] * y * y * y;
  const double fourth = c[6] * x * x * x * x + 4 * c[7] * x * x * x * y + 6 * c[8] * x * x * y * y +
                        4 * c[9] * x * y * y * y + c[10] * y * y * y * y;
  return (c[0] * x * x + c[1] * y * y) / 2 + third / 6 + fourth / 24;
}

struct Fit {
  Jets::Monge_form form;  // its normal inwards: convex is positive
  double error;           // of the curvatures
  std::size_t vertices;
};

// The first point is where the curvature is asked for.
Fit fit(const std::vector<Point>& points, const Direction& inwards) {
  Jets jets;
  Jets::Monge_form form = jets(points.begin(), points.end(), 4, 4);
  if (!(jets.condition_number() < largest_condition)) {
    throw std::runtime_error("mesh_curvature: the vertices around the point do not fix a surface, condition " +
                             std::to_string(jets.condition_number()));
  }
  form.comply_wrt_given_normal(inwards);
  double squares = 0, xx = 0, xy = 0, yy = 0;
  for (const Point& p : points) {
    const Direction d = p - form.origin();
    const double x = d * form.maximal_principal_direction(), y = d * form.minimal_principal_direction();
    const double residual = d * form.normal_direction() - height(form, x, y);
    squares += residual * residual;
    xx += x * x;
    xy += x * y;
    yy += y * y;
  }
  const auto n = static_cast<double>(points.size());
  const double narrow = 2 * ((xx + yy) - std::hypot(xx - yy, 2 * xy)) / n;  // r^2: 4 times the lesser mean square
  const double error = certainty * std::sqrt(squares / (n - unknowns)) / narrow;
  return {form, error, points.size()};
}

double difference(const Jets::Monge_form& one, const Jets::Monge_form& other) {
  return std::max(std::fabs(one.principal_curvatures(0) - other.principal_curvatures(0)),
                  std::fabs(one.principal_curvatures(1) - other.principal_curvatures(1)));
}

// The foot of a point on the fitted surface.
Point foot(const Jets::Monge_form& form, const Point& p) {
  const Direction d = p - form.origin();
  const double x = d * form.maximal_principal_direction(), y = d * form.minimal_principal_direction();
  return form.origin() + x * form.maximal_principal_direction() + y * form.minimal_principal_direction() +
         height(form, x, y) * form.normal_direction();
}

double longest_side(const TriangleMesh& mesh, std::size_t triangle) {
  double longest = 0;
  const auto& corners = mesh.triangles()[triangle];
  for (std::size_t k = 0; k < 3; ++k) {
    const Vector &p = mesh.vertices()[corners[k]], &q = mesh.vertices()[corners[(k + 1) % 3]];
    longest = std::max(longest, std::hypot(p[0] - q[0], p[1] - q[1], p[2] - q[2]));
  }
  return longest;
}

}  // namespace

MeshCurvature curvature_near(const TriangleMesh& mesh, const Vector& point) {
  const auto closest = mesh.closest_to(point);
  const Vector normal = mesh.normal(closest.triangle);
  require_in("distance of the point to the mesh", closest.distance, 0, longest_side(mesh, closest.triangle));
  const Direction inwards(-normal[0], -normal[1], -normal[2]);
  Neighbourhood around(mesh, mesh.triangles()[closest.triangle], point_of(closest.point));
  if (!around.grow_to(fewest)) {
    if (const auto apart = around.seam()) {
      if (*apart == 0) throw std::invalid_argument("mesh lists a vertex near the point twice: triangles must share it");
      std::ostringstream text;
      text << "mesh is open along a seam near the point: vertices that belong together lie " << *apart
           << " m apart; corners of triangles must coincide exactly";
      throw std::invalid_argument(text.str());
    }
    throw std::invalid_argument("mesh has fewer than " + std::to_string(fewest) +
                                " vertices around the point before its border or its end");
  }

  std::vector<Fit> fits;
  const auto by_error = [](const Fit& one, const Fit& other) { return one.error < other.error; };
  for (std::size_t count = fewest; around.grow_to(count); count *= 2) {
    // First from the closest vertex, which lies on the surface; then from the foot of the point asked for.
    std::vector<Point> points = around.points();
    points.insert(points.begin(), foot(fit(points, inwards).form, point_of(closest.point)));
    fits.push_back(fit(points, inwards));
    if (fits.back().error > 4 * std::min_element(fits.begin(), fits.end(), by_error)->error) break;
  }
  const auto best = std::min_element(fits.begin(), fits.end(), by_error);
  // Few vertices in a regular pattern can leave a small residual by chance: the next fit tells.
  double error = best->error;
  if (const auto next = best + 1; next != fits.end()) error = std::max(error, 2 * difference(best->form, next->form));

  const auto& form = best->form;
  return {{form.principal_curvatures(0), form.principal_curvatures(1), vector_of(form.maximal_principal_direction()),
           vector_of(form.minimal_principal_direction()), vector_of(-form.normal_direction())},
          error,
          vector_of(form.origin()),
          static_cast<int>(best->vertices - 1)};
}

}  // namespace patchgrip::contact
