#include <algorithm>
#include <bit>
#include <cmath>
#include <optional>

#include "geometry/scene/mesh_formats.h"
#include "geometry/scene/mesh_text.h"

namespace gnomon {
namespace {

enum class Encoding { ascii, little_endian, big_endian };

struct ScalarType {
  std::size_t bytes;
  enum class Kind { signed_integer, unsigned_integer, floating } kind;
};

struct Property {
  std::string name;
  ScalarType type;
  std::optional<ScalarType> count;  ///< of a list
};

struct Element {
  std::string name;
  std::uint64_t count;
  std::vector<Property> properties;
};

struct Head {
  Encoding encoding = Encoding::ascii;
  std::vector<Element> elements;
};

ScalarType scalar_type(const MeshLines& lines, std::string_view word) {
  using Kind = ScalarType::Kind;
  if (word == "char" || word == "int8") return {1, Kind::signed_integer};
  if (word == "uchar" || word == "uint8") return {1, Kind::unsigned_integer};
  if (word == "short" || word == "int16") return {2, Kind::signed_integer};
  if (word == "ushort" || word == "uint16") return {2, Kind::unsigned_integer};
  if (word == "int" || word == "int32") return {4, Kind::signed_integer};
  if (word == "uint" || word == "uint32") return {4, Kind::unsigned_integer};
  if (word == "float" || word == "float32") return {4, Kind::floating};
  if (word == "double" || word == "float64") return {8, Kind::floating};
  lines.refuse(word_text(word), "a PLY number type");
}

Encoding encoding(const MeshLines& lines, std::string_view word) {
  if (word == "ascii") return Encoding::ascii;
  if (word == "binary_little_endian") return Encoding::little_endian;
  if (word == "binary_big_endian") return Encoding::big_endian;
  lines.refuse(word_text(word), "ascii, binary_little_endian or binary_big_endian");
}

void require_words(const MeshLines& lines, std::size_t count) {
  if (lines.words().size() < count) {
    lines.refuse("a head line of " + std::to_string(lines.words().size()) + " words", std::to_string(count) + " words");
  }
}

void read_property(const MeshLines& lines, Head& head) {
  require_words(lines, 3);
  if (head.elements.empty()) lines.refuse("a property before the first element", "an element");
  const auto& words = lines.words();
  std::vector<Property>& properties = head.elements.back().properties;
  if (words[1] != "list") {
    properties.push_back({std::string(words[2]), scalar_type(lines, words[1]), {}});
    return;
  }
  require_words(lines, 5);
  const ScalarType count = scalar_type(lines, words[2]);
  if (count.kind == ScalarType::Kind::floating) lines.refuse(word_text(words[2]), "an integer type for a count");
  properties.push_back({std::string(words[4]), scalar_type(lines, words[3]), count});
}

Head read_head(MeshLines& lines) {
  Head head;
  if (!lines.next() || lines.words()[0] != "ply") lines.refuse("no PLY head", "a first line \"ply\"");
  while (lines.next()) {
    const std::string_view keyword = lines.words()[0];
    if (keyword == "end_header") return head;
    if (keyword == "format") {
      require_words(lines, 2);
      head.encoding = encoding(lines, lines.words()[1]);
    } else if (keyword == "element") {
      require_words(lines, 3);
      const std::int64_t count = lines.integer(2);
      if (count < 0) lines.refuse("a negative count", "0 or more");
      head.elements.push_back({std::string(lines.words()[1]), static_cast<std::uint64_t>(count), {}});
    } else if (keyword == "property") {
      read_property(lines, head);
    } else if (keyword != "comment" && keyword != "obj_info") {
      lines.refuse(word_text(keyword), "a line of a PLY head");
    }
  }
  lines.refuse("the end of the file", "\"end_header\"");
}

/// The numbers that follow the head, one after the other.
class Numbers {
 public:
  Numbers(const MeshLines& head_lines, Encoding encoding, const MeshSource& source)
      : lines_(head_lines.rest(), source, head_lines.line()),
        bytes_(head_lines.rest()),
        encoding_(encoding),
        source_(source) {}

  double next(ScalarType type, const std::string& place) {
    const double value = next_of_any_kind(type, place);
    if (!std::isfinite(value)) refuse(place, "a number that is not finite", "a finite number");
    return value;
  }

  /// A number that is not used.
  void pass_over(ScalarType type, const std::string& place) {
    if (!std::isfinite(next_of_any_kind(type, place))) all_finite_ = false;
  }

  /// A count or an index.
  std::uint32_t next_whole(ScalarType type, const std::string& place) {
    const double value = next(type, place);
    if (value != std::floor(value) || value < 0 || value > UINT32_MAX) {
      refuse(place, "the number " + shortest(value), "a whole number, 0 or more");
    }
    return static_cast<std::uint32_t>(value);
  }

  /// The line of the number that was read last; nothing in binary files.
  std::optional<std::size_t> line() const {
    return encoding_ == Encoding::ascii ? std::optional(lines_.line()) : std::nullopt;
  }

  void add_doubts(std::vector<std::string>& doubts) {
    if (encoding_ != Encoding::ascii && !bytes_.empty()) {
      doubts.push_back(std::to_string(bytes_.size()) + " bytes after the last element that the head announces");
    }
    if (encoding_ == Encoding::ascii && (word_ < lines_.words().size() || lines_.next())) {
      doubts.push_back("more than the elements that the head announces, from line " + std::to_string(lines_.line()) +
                       " on, which is not read");
    }
    if (!all_finite_) doubts.emplace_back("numbers that are not finite in properties that are not used");
    if (encoding_ == Encoding::ascii) doubts.push_back(lines_.doubt());
  }

 private:
  double next_of_any_kind(ScalarType type, const std::string& place) {
    return encoding_ == Encoding::ascii ? next_word(place) : next_binary(type, place);
  }

  double next_word(const std::string& place) {
    if (word_ == lines_.words().size()) {
      if (!lines_.next()) refuse_end(place);
      word_ = 0;
    }
    return lines_.any_number(word_++);
  }

  double next_binary(ScalarType type, const std::string& place) {
    if (bytes_.size() < type.bytes) refuse_end(place);
    std::uint64_t bits = 0;
    for (std::size_t i = 0; i < type.bytes; ++i) {
      const std::size_t from_top = encoding_ == Encoding::big_endian ? i : type.bytes - 1 - i;
      bits = bits << 8 | static_cast<unsigned char>(bytes_[from_top]);
    }
    bytes_.remove_prefix(type.bytes);
    if (type.kind == ScalarType::Kind::unsigned_integer) return static_cast<double>(bits);
    if (type.kind == ScalarType::Kind::floating) {
      if (type.bytes == 8) return std::bit_cast<double>(bits);
      return static_cast<double>(std::bit_cast<float>(static_cast<std::uint32_t>(bits)));
    }
    // Two's complement of at most 4 bytes: exact in doubles.
    const double value = static_cast<double>(bits);
    const double span = std::ldexp(1.0, static_cast<int>(8 * type.bytes));
    return value >= span / 2 ? value - span : value;
  }

  [[noreturn]] void refuse_end(const std::string& place) const {
    refuse(place, "the end of the file", "as much as the head announces");
  }

  [[noreturn]] void refuse(const std::string& place, std::string_view found, std::string_view expected) const {
    source_.refuse(line() ? "line " + std::to_string(*line()) + ", " + place : place, found, expected);
  }

  MeshLines lines_;
  std::string_view bytes_;
  Encoding encoding_;
  const MeshSource& source_;
  std::size_t word_ = 0;
  bool all_finite_ = true;
};

void require_coordinates(const Element& element, const MeshSource& source) {
  for (const std::string_view axis : {"x", "y", "z"}) {
    const auto named = [&](const Property& p) { return p.name == axis && !p.count; };
    if (std::any_of(element.properties.begin(), element.properties.end(), named)) continue;
    source.refuse("the head", "vertices without the property " + std::string(axis), "properties x, y and z");
  }
}

bool is_corner_list(const Property& property) {
  return property.count && (property.name == "vertex_indices" || property.name == "vertex_index");
}

/// Reads one item; what is neither a coordinate nor a corner is passed over.
void read_item(const Element& element, const std::string& place, Numbers& numbers, Point3& point,
               std::vector<std::uint32_t>& corners) {
  for (const Property& property : element.properties) {
    if (!property.count) {
      double* coordinate = property.name == "x"   ? &point.x
                           : property.name == "y" ? &point.y
                           : property.name == "z" ? &point.z
                                                  : nullptr;
      if (coordinate) {
        *coordinate = numbers.next(property.type, place);
      } else {
        numbers.pass_over(property.type, place);
      }
      continue;
    }
    const std::uint32_t count = numbers.next_whole(*property.count, place);
    for (std::uint32_t i = 0; i < count; ++i) {
      if (is_corner_list(property)) {
        corners.push_back(numbers.next_whole(property.type, place));
      } else {
        numbers.pass_over(property.type, place);
      }
    }
  }
}

void read_element(const Element& element, Numbers& numbers, const MeshSource& source, PolygonSoup& soup) {
  const bool is_vertex = element.name == "vertex";
  const bool is_face = element.name == "face";
  if (is_vertex) require_coordinates(element, source);
  if (is_face && std::none_of(element.properties.begin(), element.properties.end(), is_corner_list)) {
    source.refuse("the head", "faces without a list of vertices", "the property list vertex_indices");
  }
  // Items without properties take no room in the file, so their count cannot be checked against it.
  if (element.properties.empty()) return;
  for (std::uint64_t i = 0; i < element.count; ++i) {
    const std::string place = element.name.substr(0, 40) + " " + std::to_string(i);
    Point3 point;
    std::vector<std::uint32_t> corners;
    read_item(element, place, numbers, point, corners);
    if (is_vertex) soup.vertices.push_back(point);
    if (!is_face) continue;
    soup.facets.push_back(std::move(corners));
    if (numbers.line()) soup.lines.push_back(*numbers.line());
  }
}

}  // namespace

/// Without faces there may be strips of triangles, which are no part of the format's first description.
void require_faces(const Head& head, const MeshSource& source) {
  const auto is_called = [](std::string_view name) {
    return [name](const Element& element) { return element.name == name && element.count > 0; };
  };
  if (std::ranges::any_of(head.elements, is_called("face")) ||
      std::ranges::none_of(head.elements, is_called("tristrips")))
    return;
  source.refuse("the head", "strips of triangles, and no faces", "an element \"face\" with the list vertex_indices");
}

PolygonSoup ply_soup(std::string_view text, const MeshSource& source) {
  MeshLines lines(text, source);
  const Head head = read_head(lines);
  require_faces(head, source);
  Numbers numbers(lines, head.encoding, source);
  PolygonSoup soup;
  for (const Element& element : head.elements) read_element(element, numbers, source, soup);
  soup.doubts.push_back(lines.doubt());
  numbers.add_doubts(soup.doubts);
  require_indices(soup, source);
  return soup;
}

}  // namespace gnomon
