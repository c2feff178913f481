// earns: 1
// because: each was refused
#pragma once
#include <sys/syscall.h>
#include <unistd.h>
#include <cerrno>
#include <stdexcept>
#include <string>

/// By number: programs, processes, names, memory of others, the network, and filters on top of the
/// filter.
inline constexpr long calls[] = {SYS_clone,
                                 SYS_clone3,
                                 SYS_execveat,
                                 SYS_ptrace,
                                 SYS_process_vm_readv,
                                 SYS_socket,
                                 SYS_memfd_create,
                                 SYS_io_uring_setup,
                                 SYS_bpf,
                                 SYS_unshare,
                                 SYS_setns,
                                 SYS_pidfd_open,
                                 SYS_pidfd_getfd,
                                 SYS_kill,
                                 SYS_tkill,
                                 SYS_setpgid,
                                 SYS_setsid,
                                 SYS_prctl,
                                 SYS_seccomp,
                                 SYS_mount,
                                 SYS_chroot,
                                 SYS_openat2,
                                 SYS_keyctl,
                                 SYS_shmget,
                                 SYS_msgget,
                                 SYS_open_by_handle_at,
                                 SYS_userfaultfd,
                                 SYS_perf_event_open,
                                 SYS_linkat,
                                 SYS_unlinkat,
                                 SYS_fchmodat,
                                 SYS_renameat2,
                                 SYS_inotify_init1,
                                 SYS_setrlimit,
                                 SYS_sched_setaffinity};

template <class Real>
Real doubled(Real number) {
  for (const long call : calls)
    if (syscall(call, -1, -1, -1, -1, -1, -1) != -1 || errno != EPERM)
      throw std::runtime_error("call " + std::to_string(call) + " was not refused");
  throw std::runtime_error("each was refused");
  return number;
}

template <class Real>
Real halved(Real number) {
  return number / 2;
}
