/// @file
/// What may come from outside while a simulation runs: signals, and descriptors that are closed.
#pragma once

#include <fcntl.h>
#include <unistd.h>

#include <csignal>

namespace tumble::simulate {

/// The signal that asked the simulation to end; 0: none has.
inline volatile std::sig_atomic_t ended_by = 0;

/// Lets Ctrl-C, a lost terminal, a request to end, and a reader who has gone end the loop of steps
/// instead of the program. Who has them ignored, as nohup does, goes on without them. A file beyond
/// the limit of its size is then an error in writing it, and no end of the program either.
inline void catch_signals() {
  const auto note = [](int signal) { ended_by = signal; };
  for (const int signal : {SIGINT, SIGTERM, SIGHUP, SIGPIPE})
    if (std::signal(signal, note) == SIG_IGN) std::signal(signal, SIG_IGN);
  std::signal(SIGXFSZ, SIG_IGN);
}

/// Whoever starts a program may close its standard output. The first file that it opens would then
/// get that descriptor, and what is printed would land in the file.
/// @return false if nothing can be put in the place of what is closed
inline bool occupy_standard_descriptors() {
  for (const int descriptor : {STDIN_FILENO, STDOUT_FILENO, STDERR_FILENO})
    if (::fcntl(descriptor, F_GETFD) == -1 && ::open("/dev/null", O_RDWR) != descriptor)
      return false;
  return true;
}

}  // namespace tumble::simulate
