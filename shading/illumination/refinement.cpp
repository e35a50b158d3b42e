#include "shading/illumination/refinement.h"

#include <algorithm>
#include <cmath>
#include <map>

#include "geometry/numbers/vector3.h"
#include "geometry/parallel.h"

namespace gnomon::illumination {
namespace {

using Weights = std::array<double, 3>;

constexpr double into_face = 0x1p-20;        ///< of the way to a triangle's middle
constexpr double beside_an_edge = 1.0 / 64;  ///< of an angle, where limits along an edge are asked for

/// Seen differences understate the largest one by up to 1.15 with order 1, 1.38 with order 2.
double safety(int order) {
  return order == 1 ? 1.2 : 1.4;
}

Point3 towards(const Point3& a, const Point3& b, double share) {
  return {a.x + share * (b.x - a.x), a.y + share * (b.y - a.y), a.z + share * (b.z - a.z)};
}

/// Twice a sixth of the way between corners and edges: 25 places beside the corners, those in the middle first.
const std::vector<Weights>& lattice() {
  static const std::vector<Weights> places = [] {
    std::vector<Weights> all;
    for (int i = 0; i <= 6; ++i) {
      for (int j = 0; i + j <= 6; ++j) {
        if (std::max({i, j, 6 - i - j}) < 6) all.push_back({i / 6.0, j / 6.0, (6 - i - j) / 6.0});
      }
    }
    const auto least = [](const Weights& w) { return -std::min({w[0], w[1], w[2]}); };
    std::ranges::stable_sort(all, {}, least);
    return all;
  }();
  return places;
}

double off(const Irradiance& exact, double interpolated) {
  const double difference = std::fabs(exact.value - interpolated);
  return std::isnan(difference) ? HUGE_VAL : difference;
}

}  // namespace

Refinement::Refinement(FirstTriangles first, std::span<const std::uint32_t> receivers,
                       std::span<const Point3> many_limits, std::vector<Probe> probes, LightsTogether& lights,
                       const RefinementGoal& goal)
    : mesh_(std::move(first)),
      receivers_(receivers.begin(), receivers.end()),
      probes_(std::move(probes)),
      lights_(lights),
      goal_(goal),
      states_(mesh_.triangles().size()) {
  for (const Point3& p : many_limits) many_limits_.insert(place_key(p));
  for (std::uint32_t t = 0; t < states_.size(); ++t) open_ends(t);
  place_probes();
}

void Refinement::run() {
  std::vector<std::uint32_t> fresh(states_.size());
  for (std::uint32_t t = 0; t < fresh.size(); ++t) fresh[t] = t;
  while (!fresh.empty()) {
    ask_shared(fresh);
    for_all(fresh.size(), goal_.threads, [&](std::size_t i, std::size_t worker) { judge(fresh[i], worker); });
    fresh = halve_failing(fresh);
    if (goal_.progress) goal_.progress(states_.size());
  }
}

/// Irradiance jumps across edges of order 0, and has many limits where something touches.
void Refinement::open_ends(std::uint32_t triangle) {
  is_open_.resize(mesh_.points().size());
  const HalvingTriangle& t = mesh_.triangles()[triangle];
  for (std::size_t k = 0; k < 3; ++k) {
    if (many_limits_.contains(place_key(mesh_.points()[t.corners[k]]))) is_open_[t.corners[k]] = true;
    if (t.orders[k] != 0) continue;
    for (const std::uint32_t v : {t.corners[k], t.corners[(k + 1) % 3]}) is_open_[v] = true;
  }
}

std::uint32_t Refinement::place_of(std::uint32_t triangle, std::size_t node) const {
  const HalvingTriangle& t = mesh_.triangles()[triangle];
  if (node < 3) return t.corners[node];
  return mesh_.known_middle(t.corners[node - 3], t.corners[(node - 2) % 3]);
}

Point3 Refinement::at(std::uint32_t triangle, const Weights& weights) const {
  const auto& [a, b, c] = mesh_.triangles()[triangle].corners;
  const Point3 &p = mesh_.points()[a], &q = mesh_.points()[b], &r = mesh_.points()[c];
  // From one corner, so that what is alike in all corners stays as it is.
  return {p.x + weights[1] * (q.x - p.x) + weights[2] * (r.x - p.x),
          p.y + weights[1] * (q.y - p.y) + weights[2] * (r.y - p.y),
          p.z + weights[1] * (q.z - p.z) + weights[2] * (r.z - p.z)};
}

Point3 Refinement::asked_at(std::uint32_t triangle, std::size_t node) const {
  const Point3 place = mesh_.points()[place_of(triangle, node)];
  if (!states_[triangle].is_own[node]) return place;
  return towards(place, at(triangle, {1.0 / 3, 1.0 / 3, 1.0 / 3}), into_face);
}

void Refinement::place_probes() {
  std::uint32_t last = 0;
  for (std::uint32_t p = 0; p < probes_.size(); ++p) {
    if (const auto around = triangle_around(probes_[p], last)) {
      last = *around;
      states_[last].probes.push_back(p);
    }
  }
}

/// Walks from triangle to triangle towards the place. Where a border or rounding ends the walk all triangles are looked
/// at, for the one that the place is deepest in.
std::optional<std::uint32_t> Refinement::triangle_around(const Probe& probe, std::uint32_t from) const {
  const auto depth = [](const Weights& w) { return std::min({w[0], w[1], w[2]}); };
  for (std::size_t steps = 0; from != none && steps < 2 * states_.size(); ++steps) {
    const Weights w = weights_of(from, probe.point);
    if (depth(w) >= 0) break;
    // Across from the corner whose weight is least.
    const auto corner = static_cast<std::size_t>(std::ranges::min_element(w) - w.begin());
    from = mesh_.triangles()[from].beyond[(corner + 1) % 3];
  }
  if (from != none && depth(weights_of(from, probe.point)) >= 0 && receiver_of(from) == probe.receiver) return from;
  std::optional<std::uint32_t> best;
  double deepest = -HUGE_VAL;
  for (std::uint32_t t = 0; t < states_.size(); ++t) {
    if (receiver_of(t) != probe.receiver) continue;
    const double here = depth(weights_of(t, probe.point));
    if (here > deepest) deepest = here, best = t;
  }
  return best;
}

void Refinement::move_probes(const Halving& halving) {
  std::vector<std::uint32_t> all = std::move(states_[halving.kept].probes);
  states_[halving.kept].probes.clear();
  const auto& [a, m, c] = halving.line;
  const Point3& base = mesh_.points()[c];
  const Vector3<double> line = step(base, mesh_.points()[m]);
  const Vector3<double> kept_side = cross(line, step(base, mesh_.points()[a]));
  for (const std::uint32_t p : all) {
    const bool is_kept = dot(cross(line, step(base, probes_[p].point)), kept_side) > 0;
    states_[is_kept ? halving.kept : halving.fresh].probes.push_back(p);
  }
}

Weights Refinement::weights_of(std::uint32_t triangle, const Point3& p) const {
  const auto& [a, b, c] = mesh_.triangles()[triangle].corners;
  const Point3& base = mesh_.points()[a];
  const Vector3<double> u = step(base, mesh_.points()[b]), v = step(base, mesh_.points()[c]), w = step(base, p);
  const Vector3<double> normal = cross(u, v);
  const double area = dot(normal, normal);
  if (area == 0) return {1, 0, 0};
  const double second = dot(cross(w, v), normal) / area, third = dot(cross(u, w), normal) / area;
  return {1 - second - third, second, third};
}

void Refinement::ask_shared(std::span<const std::uint32_t> triangles) {
  std::vector<std::pair<std::uint32_t, std::uint32_t>> unknown;  // place, receiver
  for (const std::uint32_t t : triangles) {
    for (std::size_t k = 0; k < nodes(); ++k) {
      const auto& corners = mesh_.triangles()[t].corners;
      if (k >= 3) mesh_.middle(corners[k - 3], corners[(k - 2) % 3]);
      const std::uint32_t place = place_of(t, k);
      is_open_.resize(mesh_.points().size());
      is_known_.resize(mesh_.points().size());
      const bool is_own = is_open_[place] || (k >= 3 && mesh_.triangles()[t].orders[k - 3] == 0);
      states_[t].is_own[k] = is_own;
      if (is_own || is_known_[place]) continue;
      is_known_[place] = true;
      unknown.emplace_back(place, receiver_of(t));
    }
  }
  shared_.resize(mesh_.points().size());
  for_all(unknown.size(), goal_.threads, [&](std::size_t i, std::size_t worker) {
    const auto& [place, receiver] = unknown[i];
    shared_[place] = lights_.sum(worker, receiver, mesh_.points()[place]);
  });
  for (const std::uint32_t t : triangles) {
    for (std::size_t k = 0; k < nodes(); ++k) {
      if (!states_[t].is_own[k]) states_[t].nodes[k] = shared_[place_of(t, k)];
    }
  }
}

void Refinement::judge(std::uint32_t triangle, std::size_t worker) {
  TriangleState& state = states_[triangle];
  ask_own(triangle, worker);
  double bound = 0;
  for (std::size_t k = 0; k < nodes(); ++k) bound = std::max(bound, state.nodes[k].error_bound);
  state.error = safety(goal_.order) * off_at_places(triangle, worker) + bound;
  state.is_met = state.error <= goal_.tolerance;
  if (!state.is_met) state.edge = edge_to_halve(triangle, worker);
}

int Refinement::edge_to_halve(std::uint32_t triangle, std::size_t worker) {
  // Where limits at a corner are too far from the one in the middle smaller triangles are no better, narrower ones are.
  double most_apart = goal_.tolerance / safety(goal_.order);
  int across = -1;
  for (std::size_t k = 0; k < 3; ++k) {
    const double apart = states_[triangle].is_own[k] ? off_at_limits(triangle, k, worker) : 0;
    if (apart <= most_apart || !has_limit(triangle, k, worker)) continue;
    most_apart = apart;
    across = static_cast<int>((k + 1) % 3);
  }
  if (across >= 0) return across;
  return goal_.tries_edges ? best_edge(triangle, worker) : mesh_.longest_edge(triangle);
}

/// Every face that is too far off will take as many faces, about, as its error is tolerances.
int Refinement::best_edge(std::uint32_t triangle, std::size_t worker) {
  const int longest = mesh_.longest_edge(triangle);
  int best = longest;
  double least = HUGE_VAL;
  for (const int edge : {longest, (longest + 1) % 3, (longest + 2) % 3}) {
    if (mesh_.length(triangle, edge) < mesh_.length(triangle, longest) / 2) continue;
    const auto k = static_cast<std::size_t>(edge), l = (k + 1) % 3;
    const auto cost = [&](double off) { return std::max(1.0, safety(goal_.order) * off / goal_.tolerance); };
    const double both = cost(off_in_half(triangle, k, l, worker)) + cost(off_in_half(triangle, l, k, worker));
    if (both < least * 0.999) least = both, best = edge;
  }
  return best;
}

/// How far off linear interpolation is in the half at the first of two corners, the edge between them halved.
double Refinement::off_in_half(std::uint32_t triangle, std::size_t from, std::size_t to, std::size_t worker) {
  const std::size_t apex = 3 - from - to;
  const auto weights = [&](double w_from, double w_middle, double w_apex) {
    Weights w{};
    w[from] = w_from + w_middle / 2;
    w[to] = w_middle / 2;
    w[apex] = w_apex;
    return w;
  };
  const auto exact = [&](double w_from, double w_middle, double w_apex) {
    const auto nudged = [](double w) { return w * (1 - into_face) + into_face / 3; };
    return lights_.sum(worker, receiver_of(triangle),
                       at(triangle, weights(nudged(w_from), nudged(w_middle), nudged(w_apex))));
  };
  const auto& nodes = states_[triangle].nodes;
  const double middle = exact(0, 1, 0).value;
  double largest = 0;
  for (int i = 0; i <= 4; ++i) {
    for (int j = 0; i + j <= 4; ++j) {
      if (std::max({i, j, 4 - i - j}) == 4) continue;
      const double u = i / 4.0, v = j / 4.0, w = 1 - u - v;
      largest = std::max(largest, off(exact(u, v, w), u * nodes[from].value + v * middle + w * nodes[apex].value));
    }
  }
  return largest;
}

void Refinement::ask_own(std::uint32_t triangle, std::size_t worker) {
  TriangleState& state = states_[triangle];
  const Point3 middle = at(triangle, {1.0 / 3, 1.0 / 3, 1.0 / 3});
  for (std::size_t k = 0; k < nodes(); ++k) {
    if (!state.is_own[k]) continue;
    const auto& corners = mesh_.triangles()[triangle].corners;
    const Point3 place = k < 3 ? mesh_.points()[corners[k]]
                               : towards(mesh_.points()[corners[k - 3]], mesh_.points()[corners[(k - 2) % 3]], 0.5);
    state.nodes[k] = lights_.sum(worker, receiver_of(triangle), towards(place, middle, into_face));
  }
}

/// False where irradiance grows without end towards a corner, as at a light on the receiver.
bool Refinement::has_limit(std::uint32_t triangle, std::size_t corner, std::size_t worker) {
  Weights w{into_face / 6, into_face / 6, into_face / 6};
  w[corner] += 1 - into_face / 2;
  const Irradiance nearer = lights_.sum(worker, receiver_of(triangle), at(triangle, w));
  return off(nearer, states_[triangle].nodes[corner].value) <= goal_.tolerance;
}

/// How far the limits at a corner along its two edges are from its own.
double Refinement::off_at_limits(std::uint32_t triangle, std::size_t corner, std::size_t worker) {
  const auto beside = [&](double share) {
    Weights w{};
    w[corner] = 1 - into_face;
    w[(corner + 1) % 3] = (1 - share) * into_face;
    w[(corner + 2) % 3] = share * into_face;
    return off(lights_.sum(worker, receiver_of(triangle), at(triangle, w)), states_[triangle].nodes[corner].value);
  };
  return std::max(beside(beside_an_edge), beside(1 - beside_an_edge));
}

/// The largest difference seen, or the first that is too large.
double Refinement::off_at_places(std::uint32_t triangle, std::size_t worker) {
  const double most = goal_.tolerance / safety(goal_.order);
  double largest = 0;
  for (const std::uint32_t p : states_[triangle].probes) {
    largest =
        std::max(largest, off(probes_[p].irradiance, interpolated(triangle, weights_of(triangle, probes_[p].point))));
  }
  for (const Weights& place : lattice()) {
    if (largest > most) return largest;
    Weights w;
    for (std::size_t k = 0; k < 3; ++k) w[k] = place[k] * (1 - into_face) + into_face / 3;
    largest =
        std::max(largest, off(lights_.sum(worker, receiver_of(triangle), at(triangle, w)), interpolated(triangle, w)));
  }
  return largest;
}

double Refinement::interpolated(std::uint32_t triangle, const Weights& w) const {
  const auto& nodes = states_[triangle].nodes;
  double sum = 0;
  for (std::size_t k = 0; k < 3; ++k) {
    if (goal_.order == 1) {
      sum += w[k] * nodes[k].value;
    } else {
      sum += w[k] * (2 * w[k] - 1) * nodes[k].value + 4 * w[k] * w[(k + 1) % 3] * nodes[k + 3].value;
    }
  }
  return sum;
}

/// What a triangle's error may take or give; where irradiance is infinite halving does not help.
double Refinement::missing_flux(std::uint32_t triangle) const {
  const auto& [a, b, c] = mesh_.triangles()[triangle].corners;
  const Point3& base = mesh_.points()[a];
  const Vector3<double> n = cross(step(base, mesh_.points()[b]), step(base, mesh_.points()[c]));
  const double error = states_[triangle].error;
  return std::isfinite(error) ? error * std::hypot(n.x, n.y, n.z) : 0;
}

std::vector<std::uint32_t> Refinement::halve_failing(std::span<const std::uint32_t> fresh) {
  std::vector<std::pair<double, std::uint32_t>> failing;
  std::map<std::uint32_t, Ends> wanted;
  for (const std::uint32_t t : fresh) {
    if (states_[t].is_met) continue;
    failing.emplace_back(-missing_flux(t), t);
    const auto& corners = mesh_.triangles()[t].corners;
    const auto k = static_cast<std::size_t>(states_[t].edge);
    wanted[t] = {corners[k], corners[(k + 1) % 3]};
  }
  std::ranges::sort(failing);
  std::map<std::uint32_t, std::vector<std::uint32_t>> cut_off;  // of each triangle that was halved, what it lost
  for (const auto& [flux, t] : failing) {
    if (states_.size() >= goal_.most_triangles) break;
    // The triangles across may have been first, and have halved it along another edge: the wanted one is halved all
    // the same, or those that wait would be cut into ever thinner pieces.
    const auto [piece, edge] = piece_at_edge(t, wanted.at(t), cut_off);
    if (piece == none || mesh_.length(piece, edge) < goal_.shortest) continue;
    std::vector<Halving> halved;
    mesh_.halve(piece, edge, halved);
    for (const Halving& halving : halved) {
      states_.resize(std::max<std::size_t>(states_.size(), halving.fresh + 1));
      move_probes(halving);
      cut_off[halving.kept].push_back(halving.fresh);
    }
  }
  std::set<std::uint32_t> changed;
  for (const auto& [kept, lost] : cut_off) {
    changed.insert(kept);
    changed.insert(lost.begin(), lost.end());
  }
  for (const std::uint32_t t : changed) open_ends(t);
  return {changed.begin(), changed.end()};
}

/// The piece of a triangle that has an edge of it whole, and which of its edges that is; none if it was halved.
std::pair<std::uint32_t, int> Refinement::piece_at_edge(
    std::uint32_t triangle, const Ends& ends,
    const std::map<std::uint32_t, std::vector<std::uint32_t>>& cut_off) const {
  const auto& corners = mesh_.triangles()[triangle].corners;
  for (std::size_t k = 0; k < 3; ++k) {
    if (Ends{corners[k], corners[(k + 1) % 3]} == ends) return {triangle, static_cast<int>(k)};
  }
  const auto lost = cut_off.find(triangle);
  if (lost == cut_off.end()) return {none, 0};
  for (const std::uint32_t piece : lost->second) {
    const auto found = piece_at_edge(piece, ends, cut_off);
    if (found.first != none) return found;
  }
  return {none, 0};
}

}  // namespace gnomon::illumination
