#pragma once

#include <atomic>
#include <chrono>
#include <condition_variable>
#include <cstddef>
#include <mutex>
#include <stdexcept>
#include <string>
#include <string_view>
#include <thread>

namespace gnomon {

/// Makes standard streams safe to use: a closed one is replaced by one that fails, so that no file of ours gets its
/// number, and a reader that goes away shows as a failed write instead of ending the program.
void prepare_streams();

/// Whoever read stdout has gone away.
class ReaderGone : public std::runtime_error {
 public:
  using std::runtime_error::runtime_error;
};

/// Flushes stdout.
///
/// Throws: ReaderGone; std::runtime_error if anything else is the reason for which something written to it was lost.
void finish_stdout();

/// Prints a line "gnomon: warning: ..." to stderr.
void print_warning(std::string_view text);

/// Prints a line "gnomon: ..." to stderr.
void print_error(std::string_view text);

/// How far a task is, in words: "point 512 of 2048, 25 %, 12 s left". What nobody knows is left out: `total` is 0 if it
/// is not known, `share` of the work negative; the time left is told after a second, and the time so far where no share
/// is known.
std::string progress_text(std::string_view task, std::size_t done, std::size_t total, double share, double seconds);

/// A line on stderr that tells how far a task is; shown on a terminal only, a few times a second, and removed at the
/// end.
class Progress {
 public:
  enum class Visibility { automatic, hidden };

  /// `total` steps are to come; 0 if nobody knows.
  Progress(std::string task, std::size_t total, Visibility visibility);
  ~Progress();
  Progress(const Progress&) = delete;
  Progress& operator=(const Progress&) = delete;

  /// Counts more steps. May be called from several threads.
  void step(std::size_t count = 1) { done_ += count; }

  /// Counts anew, where steps may be taken back.
  void set_done(std::size_t count) { done_ = count; }

  /// The part of the work that is done, where steps do not tell: from 0 to 1.
  void set_share(double share) { share_ = share; }

 private:
  void print_until_the_end();
  void print() const;

  std::string task_;
  std::size_t total_;
  std::atomic<std::size_t> done_ = 0;
  std::atomic<double> share_ = -1;
  std::chrono::steady_clock::time_point start_;
  std::mutex mutex_;
  std::condition_variable has_ended_;
  bool ended_ = false;
  std::thread printer_;
};

/// Hidden if asked to be quiet, or if results go to a terminal, which the line would spoil.
Progress::Visibility progress_visibility(bool quiet, bool results_on_stdout);

}  // namespace gnomon
