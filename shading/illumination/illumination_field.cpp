#include <algorithm>
#include <cmath>
#include <tuple>

#include "geometry/numbers/vector3.h"
#include "gnomon/illumination.h"

namespace gnomon {
namespace {

/// A place over two of the coordinates.
using FieldPlace = std::array<double, 2>;

double field_coordinate(const Point3& p, std::size_t axis) {
  return axis == 0 ? p.x : axis == 1 ? p.y : p.z;
}

/// The two coordinates that a mesh is widest over.
std::array<std::size_t, 2> widest_axes(const IlluminationMesh& mesh) {
  std::array<double, 3> size{};
  for (const IlluminationFace& face : mesh.faces) {
    const auto& [a, b, c] = face.corners;
    const Vector3<double> n = cross(step(mesh.points[a], mesh.points[b]), step(mesh.points[a], mesh.points[c]));
    for (std::size_t k = 0; k < 3; ++k) size[k] += std::fabs(n[k]);
  }
  const auto dropped = static_cast<std::size_t>(std::ranges::max_element(size) - size.begin());
  return {(dropped + 1) % 3, (dropped + 2) % 3};
}

/// A face over two coordinates.
struct FieldFace {
  FieldPlace first{};                             ///< its first corner
  std::array<std::array<double, 2>, 3> slopes{};  ///< of each corner's weight
  std::array<double, 6> nodes{};                  ///< irradiance of the corners, and with order 2 of the middles
  double error = 0;
  double rounding = 0;  ///< the weights are off by less
  FieldPlace low{}, high{};

  std::array<double, 3> weights(const FieldPlace& p) const {
    const double x = p[0] - first[0], y = p[1] - first[1];
    return {1 + slopes[0][0] * x + slopes[0][1] * y, slopes[1][0] * x + slopes[1][1] * y,
            slopes[2][0] * x + slopes[2][1] * y};
  }
};

/// None of a face that is seen from its side: it has no place in it.
std::optional<FieldFace> field_face(const std::array<FieldPlace, 3>& corners, double extent) {
  const auto& [a, b, c] = corners;
  const FieldPlace u{b[0] - a[0], b[1] - a[1]}, v{c[0] - a[0], c[1] - a[1]};
  const double turn = u[0] * v[1] - u[1] * v[0];
  if (turn == 0) return std::nullopt;
  FieldFace face;
  face.first = a;
  face.slopes[1] = {v[1] / turn, -v[0] / turn};
  face.slopes[2] = {-u[1] / turn, u[0] / turn};
  face.slopes[0] = {-face.slopes[1][0] - face.slopes[2][0], -face.slopes[1][1] - face.slopes[2][1]};
  for (const auto& slope : face.slopes) face.rounding += 0x1p-48 * extent * (std::fabs(slope[0]) + std::fabs(slope[1]));
  for (std::size_t k = 0; k < 2; ++k) std::tie(face.low[k], face.high[k]) = std::minmax({a[k], b[k], c[k]});
  return face;
}

}  // namespace

struct IlluminationField::Faces {
  explicit Faces(const IlluminationMesh& mesh) : order(mesh.order), axes(widest_axes(mesh)) {
    double extent = 0;
    for (const Point3& p : mesh.points) {
      for (const std::size_t k : axes) extent = std::max(extent, std::fabs(field_coordinate(p, k)));
    }
    for (const IlluminationFace& face : mesh.faces) add(mesh, face, extent);
    if (!faces.empty()) sort_into_cells();
  }

  void add(const IlluminationMesh& mesh, const IlluminationFace& face, double extent) {
    std::array<FieldPlace, 3> corners;
    for (std::size_t k = 0; k < 3; ++k) corners[k] = flat(mesh.points[face.corners[k]]);
    std::optional<FieldFace> fresh = field_face(corners, extent);
    if (!fresh) return;
    for (std::size_t k = 0; k < 3; ++k) {
      fresh->nodes[k] = mesh.irradiance[face.corners[k]].value;
      if (order == 2) fresh->nodes[k + 3] = mesh.irradiance[face.middles[k]].value;
    }
    fresh->error = face.error;
    for (std::size_t k = 0; k < 2; ++k) {
      low[k] = faces.empty() ? fresh->low[k] : std::min(low[k], fresh->low[k]);
      high[k] = faces.empty() ? fresh->high[k] : std::max(high[k], fresh->high[k]);
    }
    faces.push_back(*fresh);
  }

  FieldPlace flat(const Point3& p) const { return {field_coordinate(p, axes[0]), field_coordinate(p, axes[1])}; }

  /// The cell of a place, or the nearest one, along one of the axes.
  std::size_t cell(double at, std::size_t axis) const {
    const double share = (at - low[axis]) * per_length[axis];
    return share > 0 ? std::min(static_cast<std::size_t>(share), cells[axis] - 1) : 0;
  }

  void sort_into_cells() {
    const auto count = static_cast<double>(faces.size());
    const FieldPlace size{high[0] - low[0], high[1] - low[1]};
    for (std::size_t k = 0; k < 2; ++k) {
      const double wanted = std::ceil(std::sqrt(2 * count * size[k] / size[1 - k]));
      cells[k] = static_cast<std::size_t>(std::clamp(wanted, 1.0, 2 * count));
      per_length[k] = static_cast<double>(cells[k]) / size[k];
    }
    std::vector<std::vector<std::uint32_t>> lists(cells[0] * cells[1]);
    for (std::uint32_t f = 0; f < faces.size(); ++f) {
      const FieldFace& face = faces[f];
      for (std::size_t j = cell(face.low[1], 1); j <= cell(face.high[1], 1); ++j) {
        for (std::size_t i = cell(face.low[0], 0); i <= cell(face.high[0], 0); ++i) {
          if (reaches(face, i, j)) lists[j * cells[0] + i].push_back(f);
        }
      }
    }
    for (const auto& list : lists) {
      begin.push_back(static_cast<std::uint32_t>(found.size()));
      found.insert(found.end(), list.begin(), list.end());
    }
    begin.push_back(static_cast<std::uint32_t>(found.size()));
  }

  /// False if a cell, and a little around it, is wholly beyond one of the face's edges.
  bool reaches(const FieldFace& face, std::size_t i, std::size_t j) const {
    const FieldPlace half{0.501 / per_length[0], 0.501 / per_length[1]};
    const auto w = face.weights({low[0] + (static_cast<double>(i) + 0.5) / per_length[0],
                                 low[1] + (static_cast<double>(j) + 0.5) / per_length[1]});
    for (std::size_t k = 0; k < 3; ++k) {
      const auto& slope = face.slopes[k];
      if (w[k] + std::fabs(slope[0]) * half[0] + std::fabs(slope[1]) * half[1] < -face.rounding) return false;
    }
    return true;
  }

  std::optional<Irradiance> at(const FieldPlace& p) const {
    for (std::size_t k = 0; k < 2; ++k) {
      // Beyond the cells by more than rounding no face reaches.
      if (!(p[k] * per_length[k] > low[k] * per_length[k] - 1 && p[k] * per_length[k] < high[k] * per_length[k] + 1)) {
        return std::nullopt;
      }
    }
    const FieldFace* nearest = nullptr;
    double deepest = -HUGE_VAL;
    const std::size_t c = cell(p[1], 1) * cells[0] + cell(p[0], 0);
    for (std::uint32_t k = begin[c]; k < begin[c + 1]; ++k) {
      const FieldFace& face = faces[found[k]];
      const auto w = face.weights(p);
      const double depth = std::min({w[0], w[1], w[2]});
      if (depth >= 0) return Irradiance{interpolated(face, w), face.error};
      if (depth + face.rounding > deepest) deepest = depth + face.rounding, nearest = &face;
    }
    if (!nearest || deepest < 0) return std::nullopt;
    return Irradiance{interpolated(*nearest, nearest->weights(p)), nearest->error};
  }

  double interpolated(const FieldFace& face, const std::array<double, 3>& w) const {
    const auto& n = face.nodes;
    if (order == 1) return w[0] * n[0] + w[1] * n[1] + w[2] * n[2];
    double sum = 0;
    for (std::size_t k = 0; k < 3; ++k) sum += w[k] * ((2 * w[k] - 1) * n[k] + 4 * w[(k + 1) % 3] * n[k + 3]);
    return sum;
  }

  int order;
  std::array<std::size_t, 2> axes;
  std::vector<FieldFace> faces;
  FieldPlace low{}, high{}, per_length{};
  std::array<std::size_t, 2> cells{};
  std::vector<std::uint32_t> begin;  ///< of each cell in `found`, and the last one's end
  std::vector<std::uint32_t> found;  ///< faces that reach into the cells
};

IlluminationField::IlluminationField(const IlluminationMesh& mesh) : faces_(std::make_shared<const Faces>(mesh)) {}

std::optional<Irradiance> IlluminationField::at(const Point3& place) const {
  if (faces_->faces.empty()) return std::nullopt;
  return faces_->at(faces_->flat(place));
}

}  // namespace gnomon
