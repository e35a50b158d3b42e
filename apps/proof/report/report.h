#pragma once

#include <string>
#include <utility>
#include <vector>

#include "apps/proof/report/adaptive_rays.h"
#include "apps/proof/report/hard_case_trial.h"
#include "apps/proof/report/measurement.h"
#include "apps/proof/report/rotation.h"
#include "apps/proof/report/search_tables.h"
#include "apps/proof/report/shadow_bsp.h"
#include "apps/proof/report/table_one.h"
#include "apps/proof/report/timings.h"
#include "apps/proof/report/visibility_tasks.h"

namespace gnomon::report {

/// Everything that was measured, before it is told.
struct Report {
  Effort effort = Effort::full;
  std::vector<std::pair<std::string, std::string>> machine;
  std::vector<Measurement> measurements;
  std::vector<Timing> timings;
  std::vector<HardCaseResult> hard_cases;
  std::vector<RotationResult> rotations;
  std::vector<TableOneRow> table_one;
  std::vector<SearchRow> searches;
  std::vector<MeshedBoardRow> meshed_board;
  BoxesResult boxes;
  std::vector<AdaptiveRow> adaptive;
};

/// A file, by its name relative to the report's folder.
struct TextFile {
  std::string name;
  std::string text;
};

/// The report as JSON: `report.json`.
TextFile report_json(const Report& report);

/// Its tables: `speed_against_error.csv`, `hard_cases.csv`, `rotation.csv`, `equivalents.csv`.
std::vector<TextFile> report_csv(const Report& report);

/// Its plots, in the folder `pictures`.
std::vector<TextFile> report_pictures(const Report& report);

/// The report in words, with tables and the plots: `report.md`.
TextFile report_page(const Report& report);

}  // namespace gnomon::report
