#include "apps/gnomon/started_processes.h"

#include <fcntl.h>
#include <unistd.h>

#ifdef GNOMON_MPI
#include <mpi.h>
#endif

#include <algorithm>
#include <cstdio>
#include <cstdlib>
#include <iostream>
#include <string>

#include "geometry/shared_work.h"
#include "gnomon/errors.h"

namespace gnomon {
namespace {

/// How many processes an MPI launcher says it has started: Open MPI's, then MPICH's variable.
int launched_count() {
  for (const char* name : {"OMPI_COMM_WORLD_SIZE", "PMI_SIZE"}) {
    if (const char* text = std::getenv(name)) return std::max(1, std::atoi(text));
  }
  return 1;
}

struct Started {
  Processes processes;
  std::FILE* words = nullptr;  ///< what a process that is not heard would have said
};

#ifdef GNOMON_MPI

/// MPI counts in ints.
constexpr std::size_t largest_piece = std::size_t{1} << 30;

void broadcast(std::string& text, std::uint32_t from) {
  unsigned long long size = text.size();
  MPI_Bcast(&size, 1, MPI_UNSIGNED_LONG_LONG, static_cast<int>(from), MPI_COMM_WORLD);
  text.resize(size);
  for (std::size_t at = 0; at < size; at += largest_piece) {
    const int count = static_cast<int>(std::min<std::size_t>(largest_piece, size - at));
    MPI_Bcast(text.data() + at, count, MPI_BYTE, static_cast<int>(from), MPI_COMM_WORLD);
  }
}

/// Keeps what is printed away from the user; errors are kept, for the others.
std::FILE* silence() {
  std::cout.flush();
  const int nowhere = open("/dev/null", O_WRONLY | O_CLOEXEC);
  if (nowhere >= 0) dup2(nowhere, STDOUT_FILENO);
  std::FILE* words = std::tmpfile();
  dup2(words ? fileno(words) : nowhere, STDERR_FILENO);
  return words;
}

std::string text_of(std::FILE* file) {
  std::string text;
  if (file == nullptr) return text;
  std::rewind(file);
  for (int c = std::fgetc(file); c != EOF; c = std::fgetc(file)) text += static_cast<char>(c);
  while (text.ends_with('\n')) text.pop_back();
  return text;
}

Started start() {
  Started started;
  if (launched_count() == 1) return started;
  // Who waits for others leaves the processor to them; Open MPI would spin.
  setenv("OMPI_MCA_mpi_yield_when_idle", "1", 0);
  int support = 0, number = 0, count = 1;
  MPI_Init_thread(nullptr, nullptr, MPI_THREAD_FUNNELED, &support);
  MPI_Comm_rank(MPI_COMM_WORLD, &number);
  MPI_Comm_size(MPI_COMM_WORLD, &count);
  started.processes.number = static_cast<std::uint32_t>(number);
  started.processes.count = static_cast<std::uint32_t>(count);
  started.processes.exchange = [number, count](const std::string& mine) {
    std::vector<std::string> texts(static_cast<std::size_t>(count));
    texts[static_cast<std::size_t>(number)] = mine;
    for (std::uint32_t from = 0; from < texts.size(); ++from) broadcast(texts[from], from);
    return texts;
  };
  if (number > 0) started.words = silence();
  return started;
}

void end(const Started& started, ExitCode code) {
  int is_initialised = 0;
  MPI_Initialized(&is_initialised);
  if (is_initialised == 0) return;
  if (code != ExitCode::done) {
    // The first has told its user why, or hears of it now, and ends all.
    if (started.processes.number == 0) MPI_Abort(MPI_COMM_WORLD, static_cast<int>(code));
    started.processes.exchange(failure_text(text_of(started.words)));
  }
  MPI_Finalize();
}

#else

Started start() {
  const int count = launched_count();
  if (count == 1) return {};
  throw UnsupportedError("mpirun started " + std::to_string(count) +
                         " processes, but this program was built without MPI; expected -DGNOMON_MPI=ON when it is "
                         "configured, or one process, which takes all processors anyway");
}

#endif

/// MPI starts once a process.
const Started& the_start() {
  static const Started started = start();
  return started;
}

}  // namespace

const Processes& started_processes() {
  return the_start().processes;
}

bool is_first_process() {
  return started_processes().number == 0;
}

#ifdef GNOMON_MPI

ExitCode end_processes(ExitCode code) {
  end(the_start(), code);
  return code;
}

#else

ExitCode end_processes(ExitCode code) {
  return code;
}

#endif

}  // namespace gnomon
