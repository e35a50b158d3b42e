#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <map>
#include <regex>
#include <set>
#include <string>
#include <tuple>
#include <vector>

#include "tests/apps/gnomon/program_fixture.h"

namespace gnomon {
namespace {

using nlohmann::json;
using testing::HasSubstr;
using testing::IsEmpty;
using testing::IsSupersetOf;

class ReportCommand : public Program {
 protected:
  json quick_report(const std::string& folder) const {
    const Outcome run = gnomon("report --quick --quiet --out " + folder);
    EXPECT_EQ(run.code, 0) << run.err;
    EXPECT_THAT(run.out + run.err, IsEmpty());
    return read_json(folder + "/report.json");
  }
};

/// The document without what follows from times and memory, which no two runs share.
json counts_and_errors(json document) {
  document.erase("machine");
  document.erase("equivalent_point_lights");
  for (const char* list : {"hard_cases", "speed_vs_error", "timings"}) {
    for (json& entry : document.at(list)) {
      for (const char* key : {"ns", "ns_least", "ns_most", "bytes"}) entry.erase(key);
    }
  }
  EXPECT_EQ(document.at("linear_searches").size(), 32u);
  for (json& row : document.at("linear_searches")) row.erase("ns");
  EXPECT_EQ(document.at("table_one").size(), 10u);
  for (json& row : document.at("table_one")) {
    for (const char* key : {"pixel_ns", "constant", "per_point", "equal", "rms"}) row.erase(key);
  }
  return document;
}

void expect_hard_cases_right(const json& cases) {
  EXPECT_GE(cases.size(), 40u);
  std::set<std::string> names;
  int doubles = 0, floats = 0;
  for (const json& hard : cases) {
    const std::string name = hard["name"];
    EXPECT_TRUE(names.insert(name).second) << name;
    EXPECT_EQ(hard["points"], 200) << name;
    EXPECT_EQ(hard["misclassified"]["gnomon"], 0) << name;
    EXPECT_EQ(hard["outside_bound"], 0) << name;
    EXPECT_TRUE(hard["irradiance_is_right"]) << name;
    EXPECT_LE(hard["max"], hard["bound"].get<double>() + 1e-16) << name;
    doubles += hard["misclassified"]["double"].get<int>();
    floats += hard["misclassified"]["embree"].get<int>();
  }
  // A corpus that the plain ways get right would prove nothing.
  EXPECT_GT(doubles, 0);
  EXPECT_GT(floats, doubles);
}

void expect_bounds_kept(const json& measurements) {
  for (const json& m : measurements) {
    const std::string method = m["method"];
    EXPECT_GT(m["results"], 0) << m;
    EXPECT_GE(m["max"], m["rms"]) << m;
    if (method == "exact" || method == "gnomon" || method == "polygon_set_2") {
      EXPECT_EQ(m["wrong_regions"], 0) << m;
    }
    // The double nearest to the truth is at most half an ulp of 1 off.
    if (m.contains("bound")) {
      EXPECT_EQ(m["outside_bound"], 0) << m;
      EXPECT_LE(m["max"], m["bound"].get<double>() + 2.3e-16) << m;
    }
    if (method == "gnomon") {
      EXPECT_LE(m["max"], 1e-12) << m;
    }
    if (method == "exact" || method == "nef_3") {
      EXPECT_LE(m["max"], 4e-16) << m;
    }
  }
}

/// The more points on the light, the smaller the error. (A raster on a receiver may be right by chance.)
void expect_sampling_to_converge(const json& measurements) {
  std::map<std::tuple<std::string, std::string, int>, std::map<int, double>> errors;
  for (const json& m : measurements) {
    if (!m.contains("samples") || m["task"] == "receiver_areas") continue;
    errors[{m["task"], m["method"], m["blockers"]}][m["samples"]] = m["rms"];
  }
  EXPECT_GE(errors.size(), 18u);
  for (const auto& [of, by_samples] : errors) {
    EXPECT_LT(by_samples.rbegin()->second, by_samples.begin()->second) << std::get<0>(of) << ' ' << std::get<1>(of);
  }
}

/// Of every search on both scenes: at least what is needed; about the light hardly more.
void expect_searches_to_find_what_is_needed(const json& rows) {
  for (const json& row : rows) {
    const double needed = row["needed"], found = row["candidates"];
    EXPECT_GE(found, needed) << row;
    EXPECT_LE(found, row["blockers"].get<double>()) << row;
    if (row["search"] == "light_hierarchy" && row["scene"] == "tetrahedron") {
      EXPECT_LE(found, 1.2 * needed);
    }
  }
}

/// A board's umbra is found by ever fewer of its single triangles.
void expect_umbrae_of_pieces_to_shrink(const json& rows) {
  ASSERT_EQ(rows.size(), 6u);
  EXPECT_EQ(rows[0]["hidden_by_one"], 1);
  for (std::size_t k = 1; k < rows.size(); ++k) EXPECT_LT(rows[k]["hidden_by_one"], rows[k - 1]["hidden_by_one"]);
}

void expect_trees_of_shadow_volumes(const json& trees) {
  ASSERT_EQ(trees.size(), 3u);
  for (const json& tree : trees) {
    EXPECT_GT(tree["nodes"].get<double>(), 2 * tree["volumes"].get<double>()) << tree;
    EXPECT_LE(tree["path"], tree["height"]) << tree;
  }
  EXPECT_GT(trees[0]["nodes"], trees[1]["nodes"]) << "occlusions have more planes than umbrae";
}

/// What starts coarsely misses more than what starts finely.
void expect_adaptive_rays_to_miss_blockers(const json& rows) {
  ASSERT_EQ(rows.size(), 9u);
  for (std::size_t k = 0; k < rows.size(); k += 3) {
    EXPECT_GT(rows[k]["missed"], 0) << rows[k];
    EXPECT_GE(rows[k]["missed"], rows[k + 2]["missed"]) << rows[k];
    EXPECT_GT(rows[k]["rms"], rows[k + 2]["rms"]) << rows[k];
  }
}

std::set<std::string> methods_of_task(const json& measurements, const std::string& task) {
  std::set<std::string> methods;
  for (const json& m : measurements) {
    if (m["task"] == task) methods.insert(m["method"]);
  }
  return methods;
}

std::set<int> sizes_of_timing(const json& timings, const std::string& task) {
  std::set<int> sizes;
  for (const json& timing : timings) {
    if (timing["task"] == task) sizes.insert(timing["size"].get<int>());
  }
  return sizes;
}

TEST_F(ReportCommand, QuickReportClaimsNothingWrongAndAgreesWithTheNext) {
  const json document = quick_report("first");
  EXPECT_EQ(document["schema"], "gnomon/report/1");
  EXPECT_TRUE(document["machine"].contains("processor"));
  expect_hard_cases_right(document["hard_cases"]);
  const json& measurements = document["speed_vs_error"];
  expect_bounds_kept(measurements);
  expect_sampling_to_converge(measurements);
  expect_searches_to_find_what_is_needed(document["linear_searches"]);
  expect_umbrae_of_pieces_to_shrink(document["meshed_board"]);
  expect_trees_of_shadow_volumes(document["shadow_trees"]);
  expect_adaptive_rays_to_miss_blockers(document["adaptive_rays"]);
  for (const char* task : {"visible_fraction", "irradiance"}) {
    EXPECT_THAT(methods_of_task(measurements, task),
                IsSupersetOf({"exact", "gnomon", "plain_doubles", "polygon_set_2", "embree_regular", "embree_jittered",
                              "embree_stratified", "embree_packets"}));
  }
  EXPECT_THAT(methods_of_task(measurements, "occlusion_volume"), IsSupersetOf({"gnomon", "convex_hull_3"}));
  EXPECT_THAT(methods_of_task(measurements, "umbra_volume"), IsSupersetOf({"gnomon", "nef_3"}));
  EXPECT_THAT(methods_of_task(measurements, "receiver_areas"), IsSupersetOf({"exact_mesh", "gnomon_raster"}));
  EXPECT_THAT(sizes_of_timing(document["timings"], "exact_planes"), IsSupersetOf({3, 4, 16, 256, 1024}));
  EXPECT_THAT(sizes_of_timing(document["timings"], "mesh_parts"), IsSupersetOf({5000}));
  for (const json& turned : document["rotation"]) {
    EXPECT_EQ(turned["wrong_gnomon"], 0);
    EXPECT_GT(turned["max"], 0.0);
    EXPECT_LT(turned["max"], 1e-6);
  }
  EXPECT_EQ(counts_and_errors(document), counts_and_errors(quick_report("second")));

  // The page shows every picture that was written, and no other.
  std::set<std::string> shown;
  const std::string page = read("first/report.md");
  const std::regex link("\\]\\(pictures/([a-z_0-9]+\\.svg)\\)");
  for (std::sregex_iterator at(page.begin(), page.end(), link), end; at != end; ++at) shown.insert((*at)[1]);
  EXPECT_THAT(names_in("first/pictures"), testing::ElementsAreArray(shown));
  EXPECT_THAT(names_in("first"),
              testing::UnorderedElementsAre("equivalents.csv", "hard_cases.csv", "pictures", "report.json", "report.md",
                                            "rotation.csv", "speed_against_error.csv"));
  EXPECT_THAT(page, HasSubstr("`gnomon report --out DIR --quick`"));
  EXPECT_THAT(page, HasSubstr("Not measured in this run"));
  EXPECT_THAT(page, HasSubstr("3,073 receivers of stacks of boxes under a distant hexagon"));
}

TEST_F(ReportCommand, RefusesToRunWithoutAFolder) {
  EXPECT_EQ(gnomon("report").code, 2);
  EXPECT_THAT(gnomon("report --quick").err, HasSubstr("--out"));
}

TEST_F(ReportCommand, FailsAtOnceWhereItsFolderCannotBeMade) {
  write("file", "");
  const Outcome run = gnomon("report --out file/folder");
  EXPECT_EQ(run.code, 1);
  EXPECT_THAT(run.err, HasSubstr("file/folder"));
}

}  // namespace
}  // namespace gnomon
