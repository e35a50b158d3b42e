#include "geometry/scene/json_text.h"

#include <algorithm>
#include <array>
#include <cstdio>
#include <nlohmann/json.hpp>
#include <vector>

#include "gnomon/scene.h"

namespace gnomon {
namespace {

using nlohmann::json;

/// A scene needs five levels. The limit keeps every later walk over the document shallow.
constexpr std::size_t deepest = 16;

std::string printable(std::string_view text, std::size_t longest) {
  std::string result;
  for (const char c : text.substr(0, longest)) {
    const auto byte = static_cast<unsigned char>(c);
    if (byte >= 0x20 && byte != 0x7f) {
      result += c;
      continue;
    }
    std::array<char, 8> escape{};
    std::snprintf(escape.data(), escape.size(), "\\x%02x", byte);
    result += escape.data();
  }
  // A cut must not fall inside a character.
  if (text.size() > longest) {
    while (!result.empty() && (static_cast<unsigned char>(result.back()) & 0xc0) == 0x80) result.pop_back();
    if (!result.empty() && static_cast<unsigned char>(result.back()) >= 0xc0) result.pop_back();
    result += "...";
  }
  return result;
}

/// The same for bytes that may not be UTF-8.
std::string printable_bytes(std::string_view bytes, std::size_t longest) {
  std::string result = printable(bytes, longest);
  std::replace_if(
      result.begin(), result.end(), [](char c) { return static_cast<unsigned char>(c) >= 0x80; }, '?');
  return result;
}

std::string line_and_column(std::string_view text, std::size_t offset) {
  const std::string_view before = text.substr(0, offset);
  const auto line = 1 + std::count(before.begin(), before.end(), '\n');
  const std::size_t start = before.rfind('\n') + 1;  // npos + 1 is 0
  return "line " + std::to_string(line) + ", column " + std::to_string(offset - start + 1);
}

/// The bare word around an offset, such as NaN: what the author may have taken for a value.
std::string_view word_at(std::string_view text, std::size_t offset) {
  constexpr std::string_view ends = " \t\r\n,:[]{}\"";
  if (offset >= text.size()) return {};
  const std::size_t before = text.find_last_of(ends, offset);
  const std::size_t start = before == std::string_view::npos ? 0 : before + 1;
  if (start > offset) return {};
  return text.substr(start, text.find_first_of(ends, offset) - start);
}

/// True for the numbers that are none, as programs write them: NaN, -Infinity.
bool is_not_finite(std::string_view word) {
  std::string lower;
  for (const char c : word.substr(word.starts_with('-') || word.starts_with('+') ? 1 : 0)) {
    lower += static_cast<char>(c >= 'A' && c <= 'Z' ? c - 'A' + 'a' : c);
  }
  return lower == "nan" || lower == "inf" || lower == "infinity";
}

/// Builds the document and refuses what a scene must not contain.
class DocumentBuilder : public nlohmann::json_sax<json> {
 public:
  DocumentBuilder(std::string_view text, const std::string& source) : text_(text), source_(source) {}

  json take() { return std::move(root_); }

  bool null() override { return add(nullptr); }
  bool boolean(bool value) override { return add(value); }
  bool number_integer(number_integer_t value) override { return add(value); }
  bool number_unsigned(number_unsigned_t value) override { return add(value); }
  bool number_float(number_float_t value, const string_t&) override { return add(value); }
  bool string(string_t& value) override { return add(std::move(value)); }
  bool binary(binary_t&) override { return false; }  // no such thing in JSON text
  bool start_object(std::size_t) override { return open(json::object()); }
  bool start_array(std::size_t) override { return open(json::array()); }
  bool end_object() override { return close(); }
  bool end_array() override { return close(); }

  bool key(string_t& name) override {
    Level& level = levels_.back();
    level.key = name;
    level.key_pending = true;
    if (level.container->contains(name)) refuse("found the key " + in_quotes(name) + " twice; expected it once");
    return true;
  }

  bool parse_error(std::size_t position, const std::string&, const json::exception& error) override {
    const std::size_t offset = std::min(position == 0 ? 0 : position - 1, text_.size());
    const std::string_view word = word_at(text_, offset);
    if (error.id == 406) {  // the document is well formed, the number too large
      const std::string_view number = word.empty() ? word_at(text_, offset - 1) : word;
      refuse("found the number " + printable_bytes(number, 40) + ", which overflows; expected a finite double");
    }
    const std::string_view what = error.what();
    const std::size_t reason = std::min(what.find("syntax error"), what.size());
    std::string message = source_ + ": " + line_and_column(text_, offset) + place() + ": ";
    if (is_not_finite(word)) {
      message += "found " + printable_bytes(word, 40) + "; expected a finite number";
    } else if (offset == text_.size()) {
      message += "found the end of the text; expected more: the JSON is not complete";
    } else {
      const std::string_view culprit = word.empty() ? text_.substr(offset, 1) : word;
      message += "found '" + printable_bytes(culprit, 40) + "': ";
      message += "not valid JSON (" + printable_bytes(what.substr(reason), 200) + "); expected a JSON document";
    }
    throw SceneError(message);
  }

 private:
  struct Level {
    json* container;
    std::string key;
    bool key_pending = false;
  };

  json* insert(json value) {
    if (levels_.empty()) return &(root_ = std::move(value));
    Level& level = levels_.back();
    if (level.container->is_array()) {
      level.container->push_back(std::move(value));
      return &level.container->back();
    }
    level.key_pending = false;
    return &((*level.container)[level.key] = std::move(value));
  }

  bool add(json value) {
    insert(std::move(value));
    return true;
  }

  bool open(json container) {
    if (levels_.size() == deepest) {
      refuse("found arrays and objects nested more than " + std::to_string(deepest) + " levels deep; expected a scene");
    }
    json* inserted = insert(std::move(container));
    levels_.push_back({inserted, {}});
    return true;
  }

  bool close() {
    levels_.pop_back();
    return true;
  }

  /// Pointer and element of the value that is being read, led by ": ".
  std::string place() const {
    std::string pointer;
    for (std::size_t depth = 0; depth < levels_.size(); ++depth) {
      const Level& level = levels_[depth];
      const bool innermost = depth + 1 == levels_.size();
      if (level.container->is_array()) {
        pointer += "/" + std::to_string(innermost ? level.container->size() : level.container->size() - 1);
      } else if (!innermost || level.key_pending) {
        pointer += "/" + pointer_token(level.key);
      }
    }
    const std::string title = element();
    return (pointer.empty() ? "" : ": " + pointer) + (title.empty() ? "" : ": " + title);
  }

  /// The element that is being read, if its name came first.
  std::string element() const {
    if (levels_.size() < 3 || !levels_[2].container->is_object()) return {};
    const auto name = levels_[2].container->find("name");
    if (name == levels_[2].container->end() || !name->is_string()) return {};
    return element_title(levels_[0].key, name->get_ref<const std::string&>());
  }

  [[noreturn]] void refuse(const std::string& what) const { throw SceneError(source_ + place() + ": " + what); }

  std::string_view text_;
  const std::string& source_;
  json root_;
  std::vector<Level> levels_;
};

}  // namespace

json parse_json(std::string_view text, const std::string& source) {
  if (text.starts_with("\xff\xfe") || text.starts_with("\xfe\xff")) {
    throw SceneError(source + ": found text in UTF-16; expected JSON text in UTF-8");
  }
  // The parser takes a zero byte for the end of the text.
  if (const std::size_t zero = text.find('\0'); zero != std::string_view::npos) {
    throw SceneError(source + ": " + line_and_column(text, zero) + ": found a zero byte; expected JSON text");
  }
  if (text.find_first_not_of(" \t\r\n") == std::string_view::npos) {
    throw SceneError(source + ": found an empty file; expected a JSON document");
  }
  DocumentBuilder builder(text, source);
  json::sax_parse(text.begin(), text.end(), &builder);
  return builder.take();
}

std::string in_quotes(std::string_view text) {
  return '"' + printable(text, 80) + '"';
}

std::string pointer_token(std::string_view key) {
  std::string escaped;
  for (const char c : key) {
    if (c == '~') {
      escaped += "~0";
    } else if (c == '/') {
      escaped += "~1";
    } else {
      escaped += c;
    }
  }
  return printable(escaped, 80);
}

std::string element_title(std::string_view list, std::string_view name) {
  constexpr std::array<std::string_view, 3> lists = {"lights", "blockers", "receivers"};
  if (std::find(lists.begin(), lists.end(), list) == lists.end()) return {};
  return std::string(list.substr(0, list.size() - 1)) + " " + in_quotes(name);
}

}  // namespace gnomon
