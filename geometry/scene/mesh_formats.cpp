#include "geometry/scene/mesh_formats.h"

#include <algorithm>
#include <array>
#include <bit>
#include <charconv>
#include <cmath>
#include <utility>

#include "geometry/scene/mesh_text.h"

namespace gnomon {
namespace {

/// A corner of an OBJ facet: the number before the first slash, counted from 1, or backwards from the last vertex.
std::uint32_t obj_corner(const MeshLines& lines, std::string_view word, std::size_t vertices) {
  const std::optional<std::int64_t> number = integer_of(word.substr(0, word.find('/')));
  const auto count = static_cast<std::int64_t>(vertices);
  if (!number || *number == 0 || *number < -count || *number > UINT32_MAX) {
    lines.refuse(word_text(word), "the number of a vertex, counted from 1, or from -1 backwards");
  }
  return static_cast<std::uint32_t>(*number > 0 ? *number - 1 : count + *number);
}

std::vector<std::uint32_t> obj_facet(const MeshLines& lines, std::size_t vertices) {
  std::vector<std::uint32_t> facet;
  for (const std::string_view word : lines.words()) {
    if (word.data() != lines.words()[0].data()) facet.push_back(obj_corner(lines, word, vertices));
  }
  return facet;
}

/// The number behind a corner's second slash, counted like its vertex; one that no normal has where there is none.
std::uint32_t obj_normal(std::string_view word, std::size_t normals) {
  const std::size_t first = word.find('/'), second = first == word.npos ? first : word.find('/', first + 1);
  const auto number = second == word.npos ? std::nullopt : integer_of(word.substr(second + 1));
  const auto count = static_cast<std::int64_t>(normals);
  if (!number || *number == 0 || *number < -count || *number > UINT32_MAX) return UINT32_MAX;
  return static_cast<std::uint32_t>(*number > 0 ? *number - 1 : count + *number);
}

std::vector<std::uint32_t> obj_normals(const MeshLines& lines, std::size_t normals) {
  std::vector<std::uint32_t> corners;
  for (std::size_t k = 1; k < lines.words().size(); ++k) corners.push_back(obj_normal(lines.words()[k], normals));
  return corners;
}

/// The words after the first as a vector, zero if they are none: nobody may ask for it.
Point3 obj_vector(const MeshLines& lines) {
  std::array<double, 3> v{};
  if (lines.words().size() < 4) return {};
  for (std::size_t k = 0; k < 3; ++k) {
    const std::string_view word = lines.words()[k + 1];
    const auto [end, error] = std::from_chars(word.data(), word.data() + word.size(), v[k]);
    if (error != std::errc() || end != word.data() + word.size() || !std::isfinite(v[k])) return {};
  }
  return {v[0], v[1], v[2]};
}

/// The counts in the head of an OFF file. Every vertex and facet takes a line, so larger counts than bytes are wrong.
std::size_t off_count(const MeshLines& lines, std::size_t word, std::size_t bytes) {
  const std::int64_t count = lines.integer(word);
  if (count < 0 || static_cast<std::uint64_t>(count) > bytes) {
    lines.refuse("the count " + std::to_string(count), "as many as the file has lines for");
  }
  return static_cast<std::size_t>(count);
}

std::vector<std::uint32_t> off_facet(const MeshLines& lines, std::size_t vertices) {
  const std::int64_t size = lines.integer(0);
  if (size < 0 || static_cast<std::uint64_t>(size) >= lines.words().size()) {
    lines.refuse("a facet of " + std::to_string(size) + " vertices with another count of numbers",
                 "as many numbers as vertices");
  }
  std::vector<std::uint32_t> facet;
  for (std::size_t word = 1; word <= static_cast<std::size_t>(size); ++word) {
    const std::int64_t index = lines.integer(word);
    if (index < 0 || static_cast<std::uint64_t>(index) >= vertices) {
      lines.refuse("the vertex number " + std::to_string(index), "one of " + std::to_string(vertices) + " vertices");
    }
    facet.push_back(static_cast<std::uint32_t>(index));
  }
  return facet;
}

void off_line(MeshLines& lines, std::string_view expected) {
  if (!lines.next()) lines.refuse("the end of the file", expected);
}

std::uint32_t little_endian(std::string_view text, std::size_t offset) {
  std::uint32_t value = 0;
  for (std::size_t i = 4; i-- > 0;) value = value << 8 | static_cast<unsigned char>(text[offset + i]);
  return value;
}

constexpr std::size_t stl_head = 84;
constexpr std::size_t stl_facet = 50;

/// Three coordinates, of which those of a vertex have to be finite.
std::array<double, 3> stl_triple(std::string_view text, std::size_t offset) {
  std::array<double, 3> triple;
  for (std::size_t i = 0; i < 3; ++i) {
    triple[i] = static_cast<double>(std::bit_cast<float>(little_endian(text, offset + 4 * i)));
  }
  return triple;
}

bool is_finite(const std::array<double, 3>& v) {
  return std::isfinite(v[0]) && std::isfinite(v[1]) && std::isfinite(v[2]);
}

const std::string normals_not_finite = "normals that are not finite, and not used";

PolygonSoup binary_stl(std::string_view text, const MeshSource& source) {
  PolygonSoup soup;
  const std::uint32_t count = little_endian(text, stl_head - 4);
  bool normals_are_finite = true;
  for (std::uint32_t f = 0; f < count; ++f) {
    const std::size_t offset = stl_head + f * stl_facet;
    normals_are_finite = normals_are_finite && is_finite(stl_triple(text, offset));
    for (std::size_t corner = 1; corner <= 3; ++corner) {
      const std::array<double, 3> v = stl_triple(text, offset + 12 * corner);
      if (!is_finite(v)) {
        source.refuse("facet " + std::to_string(f), "a coordinate that is not finite", "a finite number");
      }
      soup.vertices.push_back({v[0], v[1], v[2]});
    }
    soup.facets.push_back({3 * f, 3 * f + 1, 3 * f + 2});
  }
  const std::size_t end = stl_head + std::size_t{count} * stl_facet;
  if (!normals_are_finite) soup.doubts.push_back(normals_not_finite);
  if (text.size() > end) soup.doubts.push_back(std::to_string(text.size() - end) + " bytes after the last facet");
  return soup;
}

bool names_number_that_is_not_finite(const MeshLines& lines) {
  return std::ranges::any_of(lines.words(), [](std::string_view word) {
    const std::string lower = lower_case(word.substr(word.starts_with('-') || word.starts_with('+') ? 1 : 0));
    return lower == "nan" || lower == "inf" || lower == "infinity";
  });
}

/// An ASCII STL file, taken line by line.
class StlLines {
 public:
  StlLines(std::string_view text, const MeshSource& source) : lines_(text, source) {}

  PolygonSoup soup() {
    while (lines_.next()) read_line(lower_case(lines_.words()[0]));
    if (facet_start_ != soup_.vertices.size()) lines_.refuse("the end of the file", "\"endfacet\"");
    for (std::string& doubt : unknown_.doubts()) soup_.doubts.push_back(std::move(doubt));
    if (!normals_are_finite_) soup_.doubts.push_back(normals_not_finite);
    soup_.doubts.push_back(lines_.doubt());
    return std::move(soup_);
  }

 private:
  void read_line(const std::string& keyword) {
    if (keyword == "vertex") {
      soup_.vertices.push_back(lines_.point(1));
    } else if (keyword == "facet") {
      facet_line_ = lines_.line();
      normals_are_finite_ = normals_are_finite_ && !names_number_that_is_not_finite(lines_);
    } else if (keyword == "endfacet") {
      end_facet();
    } else if (keyword != "solid" && keyword != "outer" && keyword != "endloop" && keyword != "endsolid") {
      unknown_.add(lines_);
    }
  }

  void end_facet() {
    const std::size_t end = soup_.vertices.size();
    if (end != facet_start_ + 3) {
      lines_.refuse("a facet of " + std::to_string(end - facet_start_) + " vertices", "3 vertices");
    }
    const auto first = static_cast<std::uint32_t>(facet_start_);
    soup_.facets.push_back({first, first + 1, first + 2});
    soup_.lines.push_back(facet_line_);
    facet_start_ = end;
  }

  MeshLines lines_;
  PolygonSoup soup_;
  UnknownWords unknown_;
  std::size_t facet_start_ = 0;  ///< number of its first vertex
  std::size_t facet_line_ = 1;
  bool normals_are_finite_ = true;
};

/// Lines that hold nothing of what is read: textures, lines and points, groups, materials, how to draw.
bool is_passed_over(std::string_view keyword) {
  constexpr std::array<std::string_view, 18> known = {"vt",       "vp",  "l",      "p",      "o",          "g",
                                                      "s",        "mg",  "maplib", "usemap", "bevel",      "c_interp",
                                                      "d_interp", "lod", "ctech",  "stech",  "shadow_obj", "trace_obj"};
  return std::ranges::find(known, keyword) != known.end();
}

/// An OBJ file, taken line by line.
class ObjLines {
 public:
  ObjLines(std::string_view text, const MeshSource& source) : lines_(text, source), source_(source) {
    lines_.let_backslashes_continue();
    soup_.first_number = 1;
  }

  PolygonSoup soup() {
    while (lines_.next()) read_line(lines_.words()[0]);
    require_indices(soup_, source_);
    for (std::string& doubt : unknown_.doubts()) soup_.doubts.push_back(std::move(doubt));
    soup_.doubts.push_back(lines_.doubt());
    return std::move(soup_);
  }

 private:
  void read_line(std::string_view keyword) {
    if (keyword == "v") {
      soup_.vertices.push_back(lines_.point(1));
    } else if (keyword == "f") {
      soup_.facets.push_back(obj_facet(lines_, soup_.vertices.size()));
      soup_.corner_normals.push_back(obj_normals(lines_, soup_.normals.size()));
      soup_.lines.push_back(lines_.line());
      add_material();
    } else if (keyword == "vn") {
      soup_.normals.push_back(obj_vector(lines_));
    } else if (keyword == "usemtl") {
      material_ = lines_.words_from(1);
    } else if (keyword == "mtllib") {
      for (const std::string_view word : lines_.words()) soup_.material_files.emplace_back(word);
    } else if (!is_passed_over(keyword)) {
      unknown_.add(lines_);
    }
  }

  void add_material() {
    const auto known = std::ranges::find(soup_.materials, material_);
    soup_.facet_materials.push_back(static_cast<std::uint32_t>(known - soup_.materials.begin()));
    if (known == soup_.materials.end()) soup_.materials.push_back(material_);
  }

  MeshLines lines_;
  const MeshSource& source_;
  PolygonSoup soup_;
  UnknownWords unknown_;
  std::string material_;
};

/// Goes to the line of an OFF file that counts vertices and facets. Returns the place of the first count in it.
std::size_t off_counts(MeshLines& lines) {
  constexpr std::string_view expected = "\"OFF\" (or with normals, colours, textures: \"STCNOFF\"), as text";
  constexpr std::array<std::string_view, 6> heads = {"OFF", "COFF", "NOFF", "CNOFF", "STOFF", "STCNOFF"};
  off_line(lines, expected);
  // The keyword may be missing.
  if (integer_of(lines.words()[0])) return 0;
  if (std::ranges::find(heads, lines.words()[0]) == heads.end()) lines.refuse(word_text(lines.words()[0]), expected);
  if (lines.words().size() == 1) {
    off_line(lines, "numbers of vertices and facets");
    return 0;
  }
  if (!integer_of(lines.words()[1])) lines.refuse(word_text(lines.words()[1]), expected);
  return 1;
}

}  // namespace

PolygonSoup obj_soup(std::string_view text, const MeshSource& source) {
  return ObjLines(text, source).soup();
}

PolygonSoup off_soup(std::string_view text, const MeshSource& source) {
  MeshLines lines(text, source);
  PolygonSoup soup;
  const std::size_t counts = off_counts(lines);
  const std::size_t vertices = off_count(lines, counts, text.size());
  const std::size_t facets = off_count(lines, counts + 1, text.size());
  while (soup.vertices.size() < vertices) {
    off_line(lines, "a vertex");
    soup.vertices.push_back(lines.point(0));
  }
  while (soup.facets.size() < facets) {
    off_line(lines, "a facet");
    soup.facets.push_back(off_facet(lines, vertices));
    soup.lines.push_back(lines.line());
  }
  if (lines.next()) {
    soup.doubts.push_back("more than the " + std::to_string(facets) + " facets that the head announces, from line " +
                          std::to_string(lines.line()) + " on, which is not read");
  }
  soup.doubts.push_back(lines.doubt());
  return soup;
}

PolygonSoup stl_soup(std::string_view text, const MeshSource& source) {
  std::string_view start = text.substr(0, stl_head);
  if (start.starts_with("\xef\xbb\xbf")) start.remove_prefix(3);
  start.remove_prefix(std::min(start.find_first_not_of(" \t\r\n"), start.size()));
  const bool solid = lower_case(start.substr(0, 5)) == "solid";
  // Some programs begin binary files with "solid" too; text has no zero bytes, the count of facets always has.
  const bool binary = !solid || start.find('\0') != std::string_view::npos;
  if (!binary) return StlLines(text, source).soup();
  if (text.size() < stl_head) {
    source.refuse("line 1", "neither \"solid\" nor the head of a binary file", "an STL file");
  }
  const std::uint32_t count = little_endian(text, stl_head - 4);
  const std::uint64_t size = stl_head + std::uint64_t{stl_facet} * count;
  if (text.size() < size) {
    source.refuse("the head",
                  std::to_string(count) + " facets, which take " + std::to_string(size) + " bytes, in a file of " +
                      std::to_string(text.size()),
                  "an STL file of that size, or one of text that begins with \"solid\"");
  }
  return binary_stl(text, source);
}

}  // namespace gnomon
