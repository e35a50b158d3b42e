#pragma once

/// Results that processes share. Private to the libraries and the program.

#include <cstring>
#include <functional>
#include <span>
#include <stdexcept>
#include <string>
#include <string_view>
#include <type_traits>
#include <vector>

#include "gnomon/point.h"
#include "gnomon/processes.h"

namespace gnomon {

/// Values as bytes, as processes on machines of one kind exchange them.
template <class Value>
void append_bytes(std::string& bytes, std::span<const Value> values) {
  static_assert(std::is_trivially_copyable_v<Value>);
  const std::size_t count = values.size();
  bytes.append(reinterpret_cast<const char*>(&count), sizeof count);
  bytes.append(reinterpret_cast<const char*>(values.data()), values.size_bytes());
}

template <class Value>
void append_bytes(std::string& bytes, const std::vector<Value>& values) {
  append_bytes(bytes, std::span<const Value>(values));
}

/// Takes the values that were appended first.
///
/// Throws: std::runtime_error if there are fewer bytes than announced.
template <class Value>
std::vector<Value> take_values(std::string_view& bytes) {
  static_assert(std::is_trivially_copyable_v<Value>);
  std::size_t count = 0;
  const auto take = [&](void* to, std::size_t size) {
    if (bytes.size() < size) throw std::runtime_error("another process sent less than it announced");
    if (size > 0) std::memcpy(to, bytes.data(), size);
    bytes.remove_prefix(size);
  };
  take(&count, sizeof count);
  if (count > bytes.size() / sizeof(Value)) throw std::runtime_error("another process sent less than it announced");
  std::vector<Value> values(count);
  take(values.data(), count * sizeof(Value));
  return values;
}

/// What each process has, for all of them: the texts that `mine` makes, by number; of one process alone its own.
///
/// Throws: std::runtime_error in all processes, with the first message, if `mine` throws in any.
std::vector<std::string> exchanged(const Processes& processes, const std::function<std::string()>& mine);

/// The text by which a process tells the others, in place of what they wait for, that it has failed.
std::string failure_text(std::string_view message);

/// The results of n parts, of which each process works out its own and gets those of the others.
///
/// `work_out` sets results[i] for every i that is this process's.
template <class Value>
void share_results(const Processes& processes, std::vector<std::vector<Value>>& results,
                   const std::function<void()>& work_out) {
  if (processes.count == 1) return work_out();
  const std::vector<std::string> texts = exchanged(processes, [&] {
    work_out();
    std::string bytes;
    for (std::size_t i = processes.number; i < results.size(); i += processes.count) append_bytes(bytes, results[i]);
    return bytes;
  });
  for (std::size_t process = 0; process < texts.size(); ++process) {
    std::string_view bytes = texts[process];
    for (std::size_t i = process; i < results.size(); i += processes.count) results[i] = take_values<Value>(bytes);
  }
}

/// Makes sure that all processes have the same points to begin with.
///
/// Throws: std::runtime_error in all processes if they have not.
void require_same_points(const Processes& processes, const std::vector<Point3>& points);

}  // namespace gnomon
