#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "apps/proof/report/visibility_tasks.h"
#include "gnomon/visibility.h"

namespace gnomon::report {

/// What a search for blockers that may hide a linear light does on a scene of the papers: means over questions.
struct SearchRow {
  std::string scene;
  LinearSearch search;
  std::size_t blockers = 0;
  std::size_t references = 0;  ///< entries stored
  double needed = 0;           ///< blockers in the triangle between point and light, exactly
  double candidates = 0;       ///< blockers found
  double visited = 0;          ///< nodes of a hierarchy or voxels met
  double seconds = 0;          ///< search and exact visible intervals together
};

/// Tables II and III of [PA90] and [P93] in counts, which no machine changes: grids and light buffers of the papers'
/// sizes, and the searches beside them, on the papers' two scenes.
std::vector<SearchRow> search_tables(Effort effort);

/// A board of n triangles: the share of its umbra, by volume, that lies in umbrae of single triangles.
struct MeshedBoardRow {
  std::size_t triangles = 0;
  double share = 0;
};

/// From the board as one polygon to 1,024 triangles. The umbra of all together stays the same (checked).
std::vector<MeshedBoardRow> meshed_board(Effort effort);

/// All of it as sections of the report, what the papers print beside it.
std::string search_tables_section(const std::vector<SearchRow>& rows);
std::string meshed_board_section(const std::vector<MeshedBoardRow>& rows);

}  // namespace gnomon::report
