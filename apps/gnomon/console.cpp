#include "apps/gnomon/console.h"

#include <fcntl.h>
#include <unistd.h>

#include <csignal>
#include <cstdlib>
#include <iostream>
#include <stdexcept>
#include <utility>

namespace gnomon {
namespace {

/// See no-color.org: set and not empty means no.
bool wants_color(int descriptor) {
  const char* no_color = std::getenv("NO_COLOR");
  return isatty(descriptor) != 0 && (no_color == nullptr || *no_color == '\0');
}

std::string label(std::string_view text, std::string_view color) {
  if (!wants_color(STDERR_FILENO)) return std::string(text);
  return std::string(color) + std::string(text) + "\033[0m";
}

}  // namespace

void prepare_streams() {
  std::signal(SIGPIPE, SIG_IGN);
  for (const int descriptor : {STDIN_FILENO, STDOUT_FILENO, STDERR_FILENO}) {
    if (fcntl(descriptor, F_GETFD) != -1) continue;
    // The lowest free number is taken, which is this one. Opened the wrong way round, so that its use fails.
    [[maybe_unused]] const int opened = open("/dev/null", descriptor == STDIN_FILENO ? O_WRONLY : O_RDONLY);
  }
}

void finish_stdout() {
  std::cout.flush();
  if (!std::cout) throw std::runtime_error("standard output could not be written");
}

void print_warning(std::string_view text) {
  std::cerr << "gnomon: " << label("warning: ", "\033[33m") << text << '\n';
}

void print_error(std::string_view text) {
  std::cerr << label("gnomon: ", "\033[31m") << text << '\n';
}

Progress::Progress(std::string task, std::size_t total, Visibility visibility)
    : task_(std::move(task)),
      total_(total),
      shown_(visibility == Visibility::automatic && isatty(STDERR_FILENO) != 0 && total != 1) {
  if (shown_) print();
}

Progress::~Progress() {
  if (shown_) std::cerr << "\r\033[K" << std::flush;
}

void Progress::step(std::size_t count) {
  done_ += count;
  if (!shown_) return;
  const std::unique_lock lock(mutex_, std::try_to_lock);
  if (lock && std::chrono::steady_clock::now() >= next_print_) print();
}

void Progress::print() {
  std::cerr << '\r' << task_ << ' ' << done_;
  if (total_ > 0) std::cerr << " of " << total_;
  std::cerr << "\033[K" << std::flush;
  next_print_ = std::chrono::steady_clock::now() + std::chrono::milliseconds(100);
}

Progress::Visibility progress_visibility(bool quiet, bool results_on_stdout) {
  const bool spoils = results_on_stdout && isatty(STDOUT_FILENO) != 0;
  return quiet || spoils ? Progress::Visibility::hidden : Progress::Visibility::automatic;
}

}  // namespace gnomon
