#pragma once

/// Memory of this process.

namespace gnomon::benchmarks {

/// Megabytes (10^6 bytes) of the heap that are in use now; 0 where the C library does not tell.
double megabytes_in_use();

/// The largest amount of memory that the process has held so far, in megabytes. 0 where the system does not tell.
double peak_megabytes();

/// Forgets the largest amount so far, so that peak_megabytes() speaks of what comes. Returns false if the system
/// cannot do it.
bool reset_peak();

}  // namespace gnomon::benchmarks
