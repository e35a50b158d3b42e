#pragma once

namespace gnomon {

/// From now on, whatever ends the program before its time leaves no hidden folder behind: Ctrl-C (and SIGTERM and
/// SIGHUP, unless they are ignored) removes those of this process first, and a lack of memory, of GMP's numbers too, is
/// told in a sentence and ends the program with exit code 1.
void prepare_untimely_end();

/// Waits for the end if a signal has asked for it: what fails meanwhile, for want of the folders just removed, is no
/// news to anybody.
void wait_if_interrupted();

}  // namespace gnomon
