#include "apps/gnomon/console.h"

#include <fcntl.h>
#include <poll.h>
#include <unistd.h>

#include <algorithm>
#include <cmath>
#include <csignal>
#include <cstdio>
#include <cstdlib>
#include <iostream>
#include <stdexcept>
#include <system_error>
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

/// True for a pipe or socket that nobody reads any more, whatever an earlier write has failed for.
bool is_pipe_without_reader(int descriptor) {
  pollfd question{descriptor, POLLOUT, 0};
  return poll(&question, 1, 0) > 0 && (question.revents & (POLLERR | POLLHUP)) != 0;
}

/// A line of progress gives way to what is said.
const char* clean_line() {
  return isatty(STDERR_FILENO) != 0 ? "\r\033[K" : "";
}

/// "40 s", "3 min", "1.5 h".
std::string duration_text(double seconds) {
  if (seconds < 100) return std::to_string(std::lround(seconds)) + " s";
  if (seconds < 100 * 60) return std::to_string(std::lround(seconds / 60)) + " min";
  const long tenths = std::lround(std::min(seconds / 360, 1e6));
  return std::to_string(tenths / 10) + '.' + std::to_string(tenths % 10) + " h";
}

/// Past std::cerr, which would flush std::cout first: another thread writes there, and waits if nobody reads.
void show(const std::string& line) {
  std::fputs(line.c_str(), stderr);
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
  if (std::cout) return;
  if (is_pipe_without_reader(STDOUT_FILENO)) throw ReaderGone("nobody reads standard output any more");
  throw std::runtime_error("standard output could not be written");
}

void print_warning(std::string_view text) {
  std::cerr << clean_line() << "gnomon: " << label("warning: ", "\033[33m") << text << '\n';
}

void print_error(std::string_view text) {
  std::cerr << clean_line() << label("gnomon: ", "\033[31m") << text << '\n';
}

std::string progress_text(std::string_view task, std::size_t done, std::size_t total, double share, double seconds) {
  std::string text = std::string(task) + ' ' + std::to_string(done);
  if (total > 0) text += " of " + std::to_string(total);
  if (share < 0 && total > 0) share = static_cast<double>(done) / static_cast<double>(total);
  if (share >= 0) text += ", " + std::to_string(static_cast<int>(100 * share)) + " %";
  if (seconds < 1) return text;
  if (share > 0) return text + ", " + duration_text(seconds * (1 - share) / share) + " left";
  return text + ", " + duration_text(seconds) + " so far";
}

Progress::Progress(std::string task, std::size_t total, Visibility visibility)
    : task_(std::move(task)), total_(total), start_(std::chrono::steady_clock::now()) {
  if (visibility == Visibility::hidden || isatty(STDERR_FILENO) == 0) return;
  try {
    printer_ = std::thread([this] { print_until_the_end(); });
  } catch (const std::system_error&) {
    return;  // no thread to be had: the work goes on in silence
  }
}

Progress::~Progress() {
  if (!printer_.joinable()) return;
  {
    const std::lock_guard lock(mutex_);
    ended_ = true;
  }
  has_ended_.notify_one();
  printer_.join();
  show("\r\033[K");
}

void Progress::print_until_the_end() {
  // Quick tasks need no line.
  std::unique_lock lock(mutex_);
  for (auto pause = std::chrono::milliseconds(300); !has_ended_.wait_for(lock, pause, [this] { return ended_; });
       pause = std::chrono::milliseconds(200)) {
    print();
  }
}

void Progress::print() const {
  const std::chrono::duration<double> passed = std::chrono::steady_clock::now() - start_;
  show('\r' + progress_text(task_, done_, total_, share_, passed.count()) + "\033[K");
}

Progress::Visibility progress_visibility(bool quiet, bool results_on_stdout) {
  const bool spoils = results_on_stdout && isatty(STDOUT_FILENO) != 0;
  return quiet || spoils ? Progress::Visibility::hidden : Progress::Visibility::automatic;
}

}  // namespace gnomon
