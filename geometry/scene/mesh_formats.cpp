#include "geometry/scene/mesh_formats.h"

#include <bit>
#include <cmath>
#include <cstring>

#include "geometry/scene/mesh_text.h"

namespace gnomon {
namespace {

/// A corner of an OBJ facet: the number before the first slash, counted from 1, or backwards from the last vertex.
std::uint32_t obj_corner(const MeshLines& lines, std::string_view word, std::size_t vertices) {
  const std::optional<std::int64_t> number = integer_of(word.substr(0, word.find('/')));
  const auto count = static_cast<std::int64_t>(vertices);
  if (!number || *number == 0 || *number < -count || *number > UINT32_MAX) {
    lines.refuse(word_text(word), "the number of a vertex");
  }
  return static_cast<std::uint32_t>(*number > 0 ? *number - 1 : count + *number);
}

std::vector<std::uint32_t> obj_facet(const MeshLines& lines, std::size_t vertices) {
  if (lines.words().size() < 4) lines.refuse("a facet of fewer than 3 vertices", "at least 3");
  std::vector<std::uint32_t> facet;
  for (const std::string_view word : lines.words()) {
    if (word.data() != lines.words()[0].data()) facet.push_back(obj_corner(lines, word, vertices));
  }
  return facet;
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
  if (size < 3) lines.refuse("a facet of fewer than 3 vertices", "at least 3");
  if (static_cast<std::uint64_t>(size) >= lines.words().size()) {
    lines.refuse("a facet of " + std::to_string(size) + " vertices with fewer numbers", "as many numbers as vertices");
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

PolygonSoup binary_stl(std::string_view text, const MeshSource& source) {
  PolygonSoup soup;
  const std::uint32_t count = little_endian(text, stl_head - 4);
  for (std::uint32_t f = 0; f < count; ++f) {
    std::size_t offset = stl_head + f * stl_facet + 12;  // past the normal
    for (int corner = 0; corner < 3; ++corner) {
      double coordinates[3];
      for (double& coordinate : coordinates) {
        coordinate = static_cast<double>(std::bit_cast<float>(little_endian(text, offset)));
        offset += 4;
        if (!std::isfinite(coordinate)) {
          source.refuse("facet " + std::to_string(f), "a coordinate that is not finite", "a finite number");
        }
      }
      soup.vertices.push_back({coordinates[0], coordinates[1], coordinates[2]});
    }
    soup.facets.push_back({3 * f, 3 * f + 1, 3 * f + 2});
  }
  return soup;
}

PolygonSoup ascii_stl(std::string_view text, const MeshSource& source) {
  MeshLines lines(text, source);
  PolygonSoup soup;
  std::size_t facet_start = 0;
  while (lines.next()) {
    const std::string_view keyword = lines.words()[0];
    if (keyword == "vertex") {
      soup.vertices.push_back(lines.point(1));
    } else if (keyword == "endfacet") {
      const std::size_t end = soup.vertices.size();
      if (end != facet_start + 3) {
        lines.refuse("a facet of " + std::to_string(end - facet_start) + " vertices", "3 vertices");
      }
      const auto first = static_cast<std::uint32_t>(facet_start);
      soup.facets.push_back({first, first + 1, first + 2});
      facet_start = end;
    } else if (keyword != "solid" && keyword != "facet" && keyword != "outer" && keyword != "endloop" &&
               keyword != "endsolid") {
      lines.refuse(word_text(keyword), "a line of an ASCII STL file");
    }
  }
  if (facet_start != soup.vertices.size()) lines.refuse("the end of the file", "\"endfacet\"");
  return soup;
}

}  // namespace

PolygonSoup obj_soup(std::string_view text, const MeshSource& source) {
  MeshLines lines(text, source);
  PolygonSoup soup;
  while (lines.next()) {
    if (lines.words()[0] == "v") soup.vertices.push_back(lines.point(1));
    if (lines.words()[0] == "f") soup.facets.push_back(obj_facet(lines, soup.vertices.size()));
  }
  require_indices(soup, source);
  return soup;
}

PolygonSoup off_soup(std::string_view text, const MeshSource& source) {
  MeshLines lines(text, source);
  constexpr std::string_view expected = "\"OFF\" (or with normals, colours, textures: \"STCNOFF\"), as text";
  off_line(lines, expected);
  const std::string_view head = lines.words()[0];
  const std::size_t counts = lines.words().size() >= 3 ? 1 : 0;
  if (head != "OFF" && head != "COFF" && head != "NOFF" && head != "CNOFF" && head != "STOFF" && head != "STCNOFF") {
    lines.refuse(word_text(head), expected);
  }
  if (counts == 0) {
    if (lines.words().size() > 1) lines.refuse(word_text(lines.words()[1]), expected);
    off_line(lines, "numbers of vertices and facets");
  }
  PolygonSoup soup;
  const std::size_t vertices = off_count(lines, counts, text.size());
  const std::size_t facets = off_count(lines, counts + 1, text.size());
  while (soup.vertices.size() < vertices) {
    off_line(lines, "a vertex");
    soup.vertices.push_back(lines.point(0));
  }
  while (soup.facets.size() < facets) {
    off_line(lines, "a facet");
    soup.facets.push_back(off_facet(lines, vertices));
  }
  return soup;
}

PolygonSoup stl_soup(std::string_view text, const MeshSource& source) {
  const bool solid = text.starts_with("solid");
  if (text.size() >= stl_head) {
    // Some programs begin binary files with "solid" too; then the size tells.
    const std::uint64_t size = stl_head + std::uint64_t{stl_facet} * little_endian(text, stl_head - 4);
    if (solid ? text.size() == size : text.size() >= size) return binary_stl(text, source);
  }
  if (solid) return ascii_stl(text, source);
  source.refuse("line 1", "neither \"solid\" nor a binary file of the size it claims", "an STL file");
}

}  // namespace gnomon
