#pragma once

/// How a process treats memory that it has freed.

#include <cstdlib>  // tells which C library this is

#ifdef __GLIBC__
#include <malloc.h>
#include <unistd.h>
#endif

namespace gnomon {

/// Keeps freed memory for what comes next, up to a limit, instead of giving it back at once: fetching pages anew takes
/// a third of the time that large meshes take, one after the other. Memory in use at one time is not changed by it.
inline void keep_freed_memory() {
#ifdef __GLIBC__
  constexpr int largest_block = 32 << 20;  // larger ones would be refused
  constexpr int most_kept = 128 << 20;
  mallopt(M_MMAP_THRESHOLD, largest_block);
  mallopt(M_TRIM_THRESHOLD, most_kept);
#endif
}

/// Lets each thread keep many freed blocks of a size to itself: exact numbers come and go by the million, and a tenth
/// of the time is spared. The C library takes this setting only as a program starts, so the program starts again; it
/// goes on as it is where that fails, or where the environment has settings of its own.
inline void start_with_large_thread_caches([[maybe_unused]] char** argv) {
#ifdef __GLIBC__
  if (std::getenv("GLIBC_TUNABLES") != nullptr) return;
  if (setenv("GLIBC_TUNABLES", "glibc.malloc.tcache_count=2000", 0) == 0) execv("/proc/self/exe", argv);
#endif
}

}  // namespace gnomon
