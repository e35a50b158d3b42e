#include "apps/gnomon/untimely_end.h"

#include <fcntl.h>
#include <gmp.h>
#include <unistd.h>

#include <array>
#include <atomic>
#include <cerrno>
#include <csignal>
#include <cstdlib>
#include <memory>
#include <new>
#include <string_view>
#include <system_error>
#include <thread>

#include "apps/gnomon/commands.h"
#include "viz/vtk/staged_folder.h"

namespace gnomon {
namespace {

constexpr std::array signals = {SIGINT, SIGTERM, SIGHUP};

std::atomic<bool> interrupted = false;
int signal_pipe[2] = {-1, -1};

/// Little is allowed in a handler: it hands the signal's number to the thread that waits for it.
void pass_on(int number) {
  const int error = errno;
  interrupted = true;
  const auto byte = static_cast<unsigned char>(number);
  [[maybe_unused]] const ssize_t written = write(signal_pipe[1], &byte, 1);
  errno = error;
}

/// Ends as the signal would have ended the program, which shells look at.
void end_by_signal() {
  unsigned char number = 0;
  if (read(signal_pipe[0], &number, 1) != 1) return;
  viz::remove_staging_folders();
  std::signal(number, SIG_DFL);
  kill(getpid(), number);
}

void catch_signals() {
  if (pipe2(signal_pipe, O_CLOEXEC) != 0) return;
  try {
    std::thread(end_by_signal).detach();
  } catch (const std::system_error&) {
    return;  // no thread to be had: signals end the program as they would anyway
  }
  for (const int number : signals) {
    struct sigaction action {};
    sigaction(number, nullptr, &action);
    if (action.sa_handler == SIG_IGN) continue;  // as nohup asks for
    action.sa_handler = pass_on;
    action.sa_flags = SA_RESTART;
    sigaction(number, &action, nullptr);
  }
}

/// Kept for the end, which needs a little memory itself.
std::unique_ptr<std::array<char, 1 << 18>> reserve;
std::atomic_flag is_ending = ATOMIC_FLAG_INIT;
thread_local bool is_ending_here = false;

[[noreturn]] void end_for_lack_of_memory() {
  if (is_ending_here) _exit(static_cast<int>(ExitCode::failure));  // not even the reserve was enough
  if (is_ending.test_and_set()) {
    while (true) pause();  // another thread is at it
  }
  is_ending_here = true;
  constexpr std::string_view sentence = "gnomon: not enough memory\n";
  [[maybe_unused]] const ssize_t written = write(STDERR_FILENO, sentence.data(), sentence.size());
  reserve.reset();
  viz::remove_staging_folders();
  _exit(static_cast<int>(ExitCode::failure));
}

// GMP's own functions abort, and an exception must not pass through it.
void* gmp_allocate(std::size_t size) {
  void* memory = std::malloc(size);
  if (memory == nullptr) end_for_lack_of_memory();
  return memory;
}

void* gmp_reallocate(void* memory, std::size_t, std::size_t size) {
  memory = std::realloc(memory, size);
  if (memory == nullptr) end_for_lack_of_memory();
  return memory;
}

void gmp_free(void* memory, std::size_t) {
  std::free(memory);
}

}  // namespace

void prepare_untimely_end() {
  reserve = std::make_unique<std::array<char, 1 << 18>>();
  mp_set_memory_functions(gmp_allocate, gmp_reallocate, gmp_free);
  // Not by exceptions: they would have to pass through code, ours and others', that promises not to throw.
  std::set_new_handler(end_for_lack_of_memory);
  catch_signals();
}

void wait_if_interrupted() {
  while (interrupted) pause();
}

}  // namespace gnomon
