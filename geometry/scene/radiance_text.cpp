#include "geometry/scene/radiance_text.h"

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>
#include <map>
#include <span>
#include <utility>

#include "geometry/scene/mesh_text.h"

namespace gnomon {
namespace {

bool is_one_of(std::string_view word, std::span<const std::string_view> words) {
  return std::ranges::find(words, word) != words.end();
}

constexpr std::array<std::string_view, 24> other_materials = {
    "spotlight", "mirror",     "prism1",    "prism2",     "mist",     "trans",   "plastic2",  "metal2",
    "trans2",    "dielectric", "interface", "glass",      "plasfunc", "metfunc", "transfunc", "BRTDfunc",
    "plasdata",  "metdata",    "transdata", "antimatter", "BSDF",     "aBSDF",   "WGMDfunc",  "ashik2"};
constexpr std::array<std::string_view, 11> other_surfaces = {
    "source", "sphere", "bubble", "cone", "cup", "cylinder", "tube", "ring", "instance", "mesh", "octree"};
constexpr std::array<std::string_view, 14> patterns = {
    "colorfunc", "brightfunc", "colordata", "brightdata", "colorpict", "colortext", "brighttext",
    "spectrum",  "texfunc",    "texdata",   "mixfunc",    "mixdata",   "mixpict",   "mixtext"};

/// The words of a Radiance scene, each with its line. Comments run from a word's '#' to the end of the line.
class RadianceWords {
 public:
  RadianceWords(std::string_view text, const MeshSource& source) : text_(text), source_(source) {
    if (text_.starts_with("\xef\xbb\xbf")) text_.remove_prefix(3);
  }

  /// The next word; empty at the end.
  std::string_view next() {
    skip_blanks();
    if (at_ == text_.size()) return {};
    const std::size_t start = at_;
    while (at_ < text_.size() && !is_blank(text_[at_])) ++at_;
    return text_.substr(start, at_ - start);
  }

  std::string_view required(std::string_view expected) {
    const std::string_view word = next();
    if (word.empty()) refuse("the end of the file", expected);
    return word;
  }

  /// The rest of the line after a word.
  std::string_view rest_of_line() {
    const std::size_t start = at_;
    while (at_ < text_.size() && text_[at_] != '\n' && text_[at_] != '\r') ++at_;
    return text_.substr(start, at_ - start);
  }

  std::size_t line() const { return line_; }

  [[noreturn]] void refuse(std::string_view found, std::string_view expected) const {
    source_.refuse("line " + std::to_string(line_), found, expected);
  }
  [[noreturn]] void refuse_as_unsupported(const std::string& found, std::string_view expected) const {
    source_.node.refuse_as_unsupported(
        "in " + word_text(source_.file) + " (line " + std::to_string(line_) + ") " + found, expected);
  }

 private:
  static bool is_blank(char c) { return c == ' ' || (c >= '\t' && c <= '\r') || c == '\0'; }

  void skip_blanks() {
    while (at_ < text_.size()) {
      if (text_[at_] == '#') rest_of_line();
      if (at_ == text_.size() || !is_blank(text_[at_])) return;
      const bool is_pair = text_[at_] == '\r' && text_.substr(at_ + 1).starts_with('\n');
      if (text_[at_] == '\n' || (text_[at_] == '\r' && !is_pair)) ++line_;
      ++at_;
    }
  }

  std::string_view text_;
  const MeshSource& source_;
  std::size_t at_ = 0, line_ = 1;
};

/// What follows a primitive's identifier.
struct Values {
  std::size_t texts = 0;
  std::vector<double> reals;
};

class RadianceReader {
 public:
  RadianceReader(std::string_view text, const MeshSource& source) : words_(text, source) {}

  RadianceScene scene() {
    for (std::string_view word = words_.next(); !word.empty(); word = words_.next()) read_primitive(word);
    for (const auto& [what, count] : passed_over_) {
      result_.soup.doubts.push_back(what.first + " (" + std::to_string(count) + "): " + what.second);
    }
    return std::move(result_);
  }

 private:
  using MaterialNumber = std::optional<std::uint32_t>;

  void read_primitive(std::string_view modifier) {
    if (modifier.starts_with('!')) {
      words_.refuse_as_unsupported(
          "the command " + word_text(std::string(modifier) + std::string(words_.rest_of_line())),
          "a scene without commands, which are not run: 'xform FILE > NEW.rad' writes what one makes");
    }
    const std::size_t line = words_.line();
    const MaterialNumber material = known(modifier);
    const std::string type(words_.required("a type, as \"polygon\""));
    const std::string name(words_.required("an identifier"));
    if (type == "alias") {
      known_[name] = known(words_.required("the identifier of what an alias is like"));
      return;
    }
    if (type == "polygon") {
      add_polygon(material, name, line, values());
    } else if (type == "light" || type == "illum" || type == "glow" || type == "plastic" || type == "metal") {
      add_material(name, known_material(type, values()));
    } else if (is_one_of(type, other_materials)) {
      values();
      count(type, "polygons of this material block, and reflect as those without one");
      add_material(name, std::nullopt);
    } else if (is_one_of(type, patterns)) {
      values();
      count(type, "what it does to a material is left out");
      known_[name] = material;
    } else if (is_one_of(type, other_surfaces)) {
      values();
      count(type, "no polygon, left out");
    } else {
      words_.refuse(word_text(type), "a type of primitives, as \"polygon\" or \"plastic\"");
    }
  }

  void count(const std::string& what, const std::string& how) { ++passed_over_[{what, how}]; }

  MaterialNumber known(std::string_view modifier) const {
    if (modifier == "void") return std::nullopt;
    const auto found = known_.find(std::string(modifier));
    if (found == known_.end()) {
      words_.refuse("the modifier " + word_text(modifier), "\"void\" or the identifier of something before it");
    }
    return found->second;
  }

  void add_material(const std::string& name, const std::optional<FileMaterial>& material) {
    known_[name] = static_cast<std::uint32_t>(result_.materials.size());
    result_.materials.push_back(material);
    result_.soup.materials.push_back(name);
  }

  std::size_t counted_values(std::string_view of) {
    const std::string_view word = words_.required("how many " + std::string(of) + " follow");
    const auto count = integer_of(word);
    if (!count || *count < 0 || *count > 1'000'000'000) {
      words_.refuse(word_text(word), "how many " + std::string(of) + " follow");
    }
    return static_cast<std::size_t>(*count);
  }

  double real() {
    std::string_view word = words_.required("a number");
    const std::string_view written = word;
    if (word.starts_with('+') && !word.starts_with("+-")) word.remove_prefix(1);
    double value = 0;
    const auto [end, error] = std::from_chars(word.data(), word.data() + word.size(), value);
    const bool is_tiny = error == std::errc::result_out_of_range && end == word.data() + word.size();
    if (is_tiny) value = std::strtod(std::string(word).c_str(), nullptr);
    if ((error != std::errc() && !is_tiny) || end != word.data() + word.size() || !std::isfinite(value)) {
      words_.refuse(word_text(written), "a finite number");
    }
    return value;
  }

  Values values() {
    Values found;
    found.texts = counted_values("texts");
    for (std::size_t k = 0; k < found.texts; ++k) words_.required("a text");
    const std::size_t integers = counted_values("whole numbers");
    for (std::size_t k = 0; k < integers; ++k) words_.required("a whole number");
    const std::size_t reals = counted_values("numbers");
    for (std::size_t k = 0; k < reals; ++k) found.reals.push_back(real());
    return found;
  }

  void add_polygon(MaterialNumber material, const std::string& name, std::size_t line, const Values& values) {
    const std::vector<double>& v = values.reals;
    if (v.size() < 9 || v.size() % 3 != 0) {
      words_.refuse(std::to_string(v.size()) + " numbers of the polygon " + word_text(name),
                    "three for each of at least 3 vertices");
    }
    if (!material) {
      count("polygon of void", "nothing is seen of it, left out");
      return;
    }
    PolygonSoup& soup = result_.soup;
    std::vector<std::uint32_t> facet;
    for (std::size_t k = 0; k < v.size(); k += 3) {
      facet.push_back(static_cast<std::uint32_t>(soup.vertices.size()));
      soup.vertices.push_back({v[k], v[k + 1], v[k + 2]});
    }
    soup.facets.push_back(std::move(facet));
    soup.lines.push_back(line);
    soup.facet_materials.push_back(*material);
    result_.names.push_back(name);
  }

  FileMaterial known_material(const std::string& type, const Values& values) {
    const std::vector<double>& v = values.reals;
    const bool reflects = type == "plastic" || type == "metal";
    const std::size_t numbers = reflects ? 5 : type == "glow" ? 4 : 3;
    const bool is_wrong =
        std::any_of(v.begin(), v.begin() + static_cast<std::ptrdiff_t>(std::min(v.size(), reflects ? numbers : 3)),
                    [](double x) { return x < 0; });
    if (v.size() != numbers || is_wrong) {
      words_.refuse(is_wrong ? "a negative number" : std::to_string(v.size()) + " numbers",
                    std::to_string(numbers) + " numbers from 0 on for the type " + word_text(type) +
                        (type == "glow" ? ", of which the last may be negative" : ""));
    }
    const std::array<double, 3> color{v[0], v[1], v[2]};
    FileMaterial material;
    if (reflects) {
      add_reflection(material, color, v[3], v[4], type == "metal");
    } else if (type != "glow" || v[3] >= 0) {
      material.emission = color;
    }
    return material;
  }

  void add_reflection(FileMaterial& material, const std::array<double, 3>& c, double share, double roughness,
                      bool is_metal) {
    if (share > 1) words_.refuse("a specular share of more than 1", "one from 0 to 1");
    const double rest = 1 - share;
    material.diffuse = std::array{c[0] * rest, c[1] * rest, c[2] * rest};
    if (share == 0) return;
    if (roughness == 0) {
      count("specular share of roughness 0", "a mirror's, left out");
      return;
    }
    material.specular =
        is_metal ? std::array{c[0] * share, c[1] * share, c[2] * share} : std::array{share, share, share};
    material.exponent = 2 / (roughness * roughness);
  }

  RadianceWords words_;
  RadianceScene result_;
  std::map<std::string, MaterialNumber> known_;                             ///< what modifiers stand for; none for void
  std::map<std::pair<std::string, std::string>, std::size_t> passed_over_;  ///< what, and how it is taken
};

}  // namespace

RadianceScene radiance_scene(std::string_view text, const MeshSource& source) {
  return RadianceReader(text, source).scene();
}

}  // namespace gnomon
