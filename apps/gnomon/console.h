#pragma once

#include <atomic>
#include <chrono>
#include <cstddef>
#include <mutex>
#include <string>
#include <string_view>

namespace gnomon {

/// Makes standard streams safe to use: a closed one is replaced by one that fails, so that no file of ours gets its
/// number, and a reader that goes away shows as a failed write instead of ending the program.
void prepare_streams();

/// Flushes stdout.
///
/// Throws: std::runtime_error if anything written to it was lost.
void finish_stdout();

/// Prints a line "gnomon: warning: ..." to stderr.
void print_warning(std::string_view text);

/// Prints a line "gnomon: ..." to stderr.
void print_error(std::string_view text);

/// A line on stderr that counts finished steps; shown on a terminal only, a few times a second, and removed at the end.
class Progress {
 public:
  enum class Visibility { automatic, hidden };

  /// `total` steps are to come; 0 if nobody knows.
  Progress(std::string task, std::size_t total, Visibility visibility);
  ~Progress();
  Progress(const Progress&) = delete;
  Progress& operator=(const Progress&) = delete;

  /// Counts more steps. May be called from several threads.
  void step(std::size_t count = 1);

 private:
  void print();

  std::string task_;
  std::size_t total_;
  std::atomic<std::size_t> done_ = 0;
  bool shown_;
  std::chrono::steady_clock::time_point next_print_;
  std::mutex mutex_;
};

/// Hidden if asked to be quiet, or if results go to a terminal, which the line would spoil.
Progress::Visibility progress_visibility(bool quiet, bool results_on_stdout);

}  // namespace gnomon
