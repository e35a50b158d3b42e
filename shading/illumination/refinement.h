#pragma once

/// Triangles that are halved until interpolated irradiance is close enough. Private to the libraries.

#include <cstdint>
#include <functional>
#include <map>
#include <optional>
#include <set>
#include <span>
#include <vector>

#include "geometry/numbers/place_key.h"
#include "shading/illumination/halving_mesh.h"
#include "shading/illumination/lights_together.h"

namespace gnomon::illumination {

/// A place of a receiver that must be right in whichever triangle it falls.
struct Probe {
  std::uint32_t receiver = 0;
  Point3 point;
  Irradiance irradiance;
};

struct RefinementGoal {
  double tolerance = 0;  ///< [W/m²]
  int order = 1;
  bool tries_edges =
      false;  ///< halve the edge whose halves are best, not the longest one; safe if all traces are edges
  std::size_t most_triangles = 0;
  double shortest = 0;  ///< edges are not halved below it
  unsigned threads = 1;
  std::function<void(std::size_t triangles)> progress = {};
};

/// What a triangle interpolates between: its corners, then with order 2 the middles of its edges.
struct TriangleState {
  std::array<Irradiance, 6> nodes{};
  std::array<bool, 6> is_own{};       ///< a limit that no other triangle shares
  std::vector<std::uint32_t> probes;  ///< that lie in it
  double error = 0;
  int edge = 0;  ///< to be halved, if the error is too large
  bool is_met = true;
};

/// The triangles of receivers of one plane, each with its state.
class Refinement {
 public:
  /// `many_limits` are places where something touches the plane. The lights outlive it.
  Refinement(FirstTriangles first, std::span<const std::uint32_t> receivers, std::span<const Point3> many_limits,
             std::vector<Probe> probes, LightsTogether& lights, const RefinementGoal& goal);

  void run();

  const HalvingMesh& mesh() const { return mesh_; }
  const std::vector<TriangleState>& states() const { return states_; }
  /// The receiver, as it is called outside, of a triangle.
  std::uint32_t receiver_of(std::uint32_t triangle) const { return receivers_[mesh_.triangles()[triangle].receiver]; }
  /// The number of the place of a node that is shared.
  std::uint32_t place_of(std::uint32_t triangle, std::size_t node) const;
  /// Where a node's irradiance is asked for.
  Point3 asked_at(std::uint32_t triangle, std::size_t node) const;
  std::size_t nodes() const { return goal_.order == 1 ? 3 : 6; }

 private:
  void open_ends(std::uint32_t triangle);
  void place_probes();
  std::optional<std::uint32_t> triangle_around(const Probe& probe, std::uint32_t from) const;
  void move_probes(const Halving& halving);
  void ask_shared(std::span<const std::uint32_t> triangles);
  void judge(std::uint32_t triangle, std::size_t worker);
  void ask_own(std::uint32_t triangle, std::size_t worker);
  int edge_to_halve(std::uint32_t triangle, std::size_t worker);
  int best_edge(std::uint32_t triangle, std::size_t worker);
  double off_in_half(std::uint32_t triangle, std::size_t from, std::size_t to, std::size_t worker);
  bool has_limit(std::uint32_t triangle, std::size_t corner, std::size_t worker);
  double off_at_limits(std::uint32_t triangle, std::size_t corner, std::size_t worker);
  double off_at_places(std::uint32_t triangle, std::size_t worker);
  double interpolated(std::uint32_t triangle, const std::array<double, 3>& weights) const;
  std::array<double, 3> weights_of(std::uint32_t triangle, const Point3& p) const;
  Point3 at(std::uint32_t triangle, const std::array<double, 3>& weights) const;
  double missing_flux(std::uint32_t triangle) const;
  std::vector<std::uint32_t> halve_failing(std::span<const std::uint32_t> fresh);
  using Ends = std::array<std::uint32_t, 2>;  ///< of an edge, as its triangle runs along it
  std::pair<std::uint32_t, int> piece_at_edge(std::uint32_t triangle, const Ends& ends,
                                              const std::map<std::uint32_t, std::vector<std::uint32_t>>& cut_off) const;

  HalvingMesh mesh_;
  std::vector<std::uint32_t> receivers_;
  std::set<PlaceKey> many_limits_;
  std::vector<Probe> probes_;
  LightsTogether& lights_;
  RefinementGoal goal_;
  std::vector<TriangleState> states_;
  std::vector<bool> is_open_;       ///< of each point: each triangle has a limit of its own there
  std::vector<bool> is_known_;      ///< of each point that is not open
  std::vector<Irradiance> shared_;  ///< the same
};

}  // namespace gnomon::illumination
