#include "geometry/discontinuity/face_cells.h"

#include <algorithm>
#include <boost/pending/disjoint_sets.hpp>
#include <optional>
#include <utility>

namespace gnomon::event {
namespace {

using conic::CurveMap;
using PieceUse = CurveMap::PieceUse;

/// Leaves out what parts nothing, and joins what it parted.
class CellJoiner {
 public:
  CellJoiner(const CurveMap& map, std::span<const conic::Side> sides, std::vector<ReceiverRegion> regions)
      : map_(map),
        sides_(sides),
        regions_(std::move(regions)),
        cell_of_(2 * map.pieces().size(), CurveMap::nowhere),
        next_(2 * map.pieces().size()),
        ends_at_(map.nodes().size()) {
    for (std::uint32_t c = 0; c < map_.cells().size(); ++c) {
      const auto& cycle = map_.cells()[c];
      for (std::size_t k = 0; k < cycle.size(); ++k) {
        cell_of_[cycle[k]] = c;
        next_[cycle[k]] = cycle[(k + 1) % cycle.size()];
      }
    }
    for (std::uint32_t p = 0; p < map_.pieces().size(); ++p) {
      if (!is_kept(p)) continue;
      ends_at_[map_.pieces()[p].start].push_back(p);
      ends_at_[map_.pieces()[p].end].push_back(p);
    }
  }

  FaceCells cells() {
    make_arcs();
    boost::disjoint_sets_with_storage<> sets(map_.cells().size());
    for (std::uint32_t p = 0; p < map_.pieces().size(); ++p) {
      if (!is_kept(p)) sets.union_set(cell_of_[2 * p], cell_of_[2 * p + 1]);
    }
    std::vector<std::uint32_t> place(map_.cells().size(), CurveMap::nowhere);
    std::vector<bool> done(next_.size(), false);
    for (PieceUse first = 0; first < next_.size(); ++first) {
      if (done[first] || cell_of_[first] == CurveMap::nowhere || !is_kept(first / 2)) continue;
      std::vector<PieceUse> cycle;
      for (PieceUse use = first; !done[use]; use = following(use)) {
        done[use] = true;
        cycle.push_back(use);
      }
      std::uint32_t& at = place[sets.find_set(cell_of_[first])];
      if (at == CurveMap::nowhere) {
        at = static_cast<std::uint32_t>(result_.cells.size());
        result_.cells.push_back({regions_[cell_of_[first]], {}});
      }
      result_.cells[at].cycles.push_back(joined(std::move(cycle)));
    }
    result_.curves = map_.curves();
    result_.nodes = map_.nodes();
    return std::move(result_);
  }

 private:
  const CurveMap::Piece& piece(PieceUse use) const { return map_.pieces()[use / 2]; }

  bool is_arc(std::uint32_t p) const { return map_.pieces()[p].side == CurveMap::nowhere; }

  /// Sides stay; of others those between two regions.
  bool is_kept(std::uint32_t p) const {
    return !is_arc(p) || regions_[cell_of_[2 * p]] != regions_[cell_of_[2 * p + 1]];
  }

  PieceUse following(PieceUse use) const {
    PieceUse next = next_[use];
    while (!is_kept(next / 2)) next = next_[next ^ 1U];
    return next;
  }

  /// A node at which an arc, or a run of parts of one side, begins or ends.
  bool is_stop(std::uint32_t node) const {
    const auto& ends = ends_at_[node];
    if (map_.nodes()[node].vertex != CurveMap::nowhere || ends.size() != 2) return true;
    const auto &p = map_.pieces()[ends[0]], &q = map_.pieces()[ends[1]];
    return p.curve != q.curve || p.side != q.side;
  }

  /// Joins pieces of one curve that follow each other.
  void make_arcs() {
    arc_of_.assign(map_.pieces().size(), CurveMap::nowhere);
    for (std::uint32_t p = 0; p < map_.pieces().size(); ++p) {
      if (!is_arc(p) || !is_kept(p) || !is_stop(map_.pieces()[p].start)) continue;
      const auto index = static_cast<std::uint32_t>(result_.arcs.size());
      const CurveMap::Piece& first = map_.pieces()[p];
      CellArc arc{first.curve, first.from, first.to, first.start, first.end, first.names};
      arc_of_[p] = index;
      for (std::uint32_t last = p; !is_stop(arc.end);) {
        const auto& ends = ends_at_[arc.end];
        last = ends[0] == last ? ends[1] : ends[0];
        const CurveMap::Piece& more = map_.pieces()[last];
        arc.to = more.to;
        arc.end = more.end;
        arc.names.insert(arc.names.end(), more.names.begin(), more.names.end());
        arc_of_[last] = index;
      }
      std::sort(arc.names.begin(), arc.names.end());
      arc.names.erase(std::unique(arc.names.begin(), arc.names.end()), arc.names.end());
      result_.arcs.push_back(std::move(arc));
    }
  }

  std::uint32_t start_of(PieceUse use) const { return use % 2 == 0 ? piece(use).start : piece(use).end; }
  std::uint32_t end_of(PieceUse use) const { return start_of(use ^ 1U); }

  CellSide side(PieceUse use) const {
    const CurveMap::Piece& p = piece(use);
    const bool grows = use % 2 == 0;
    CellSide result{p.side == CurveMap::nowhere, 0, grows, start_of(use), end_of(use), p.from, p.to};
    if (!grows) std::swap(result.at_start, result.at_end);
    if (result.is_arc) {
      result.index = arc_of_[use / 2];
    } else {
      result.index = sides_[p.side].name;
      result.is_forward = grows == p.runs_as_side;
    }
    return result;
  }

  std::vector<CellSide> joined(std::vector<PieceUse> cycle) const {
    const auto first = std::find_if(cycle.begin(), cycle.end(), [&](PieceUse use) { return is_stop(start_of(use)); });
    std::rotate(cycle.begin(), first, cycle.end());
    std::vector<CellSide> result;
    for (const PieceUse use : cycle) {
      CellSide next = side(use);
      if (is_stop(next.start)) {
        result.push_back(std::move(next));
      } else {
        result.back().end = next.end;
        result.back().at_end = next.at_end;
      }
    }
    return result;
  }

  const CurveMap& map_;
  std::span<const conic::Side> sides_;
  std::vector<ReceiverRegion> regions_;  ///< of the map's cells
  std::vector<std::uint32_t> cell_of_;
  std::vector<PieceUse> next_;
  std::vector<std::vector<std::uint32_t>> ends_at_;  ///< of each node, pieces that are kept
  std::vector<std::uint32_t> arc_of_;
  FaceCells result_;
};

}  // namespace

FaceCells face_cells(const conic::CurveMap& map, std::span<const conic::Side> sides,
                     const std::function<ReceiverRegion(const FlatPoint&)>& region_of) {
  std::vector<ReceiverRegion> regions;
  for (std::size_t c = 0; c < map.cells().size(); ++c) regions.push_back(region_of(map.inner_point(c)));
  return CellJoiner(map, sides, std::move(regions)).cells();
}

}  // namespace gnomon::event
