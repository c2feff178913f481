/// @file
/// What may come from outside while a simulation runs: signals, and descriptors that are closed.
#pragma once

#include <fcntl.h>
#include <unistd.h>

#include <csignal>
#include <initializer_list>

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

/// Whether a descriptor can be used for what it is for: to be written to, but for the first.
inline bool is_usable(int descriptor) {
  const int how = ::fcntl(descriptor, F_GETFL);
  return how != -1 && (descriptor == STDIN_FILENO || (how & O_ACCMODE) != O_RDONLY);
}

/// Whoever starts a program may close its standard output. The first file that it opens would then
/// get that descriptor, and what is printed would land in the file. A shell in between may have put
/// its own script there, open for reading.
/// @return false if nothing can be put in the place of what is closed
inline bool occupy_standard_descriptors() {
  for (const int descriptor : {STDIN_FILENO, STDOUT_FILENO, STDERR_FILENO}) {
    if (is_usable(descriptor)) continue;
    const int null = ::open("/dev/null", O_RDWR);
    if (null == -1) return false;
    if (null == descriptor) continue;
    if (::dup2(null, descriptor) == -1) return false;
    ::close(null);
  }
  return true;
}

}  // namespace tumble::simulate
