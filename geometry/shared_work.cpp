#include "geometry/shared_work.h"

#include <exception>

namespace gnomon {
namespace {

constexpr char failed = '!', done = '.';

}  // namespace

std::string failure_text(std::string_view message) {
  return failed + std::string(message);
}

std::vector<std::string> exchanged(const Processes& processes, const std::function<std::string()>& mine) {
  if (processes.count == 1) return {mine()};
  std::string told;
  try {
    told = done + mine();
  } catch (const std::exception& error) {
    told = failure_text(error.what());
  }
  std::vector<std::string> texts = processes.exchange(told);
  for (std::size_t process = 0; process < texts.size(); ++process) {
    std::string& text = texts[process];
    if (!text.empty() && text[0] == done) {
      text.erase(0, 1);
      continue;
    }
    const std::string message = text.empty() ? "it sent nothing" : text.substr(1);
    throw std::runtime_error("process " + std::to_string(process) + " of " + std::to_string(processes.count) +
                             " failed: " + message);
  }
  return texts;
}

void require_same_points(const Processes& processes, const std::vector<Point3>& points) {
  if (processes.count == 1) return;
  const std::vector<std::string> all = exchanged(processes, [&] {
    std::string bytes;
    append_bytes(bytes, points);
    // The number and a hash of them; standard libraries of one machine hash alike.
    return std::to_string(points.size()) + ' ' + std::to_string(std::hash<std::string>()(bytes));
  });
  for (const std::string& text : all) {
    if (text != all.front()) {
      throw std::runtime_error("the processes read different scenes; all of them need the same files and options");
    }
  }
}

}  // namespace gnomon
