#pragma once

#include <sys/file.h>

#include <cerrno>

namespace trunk {

enum class LockKind { shared, alone };

/// Locks an open file for this process until it is closed. False where another process holds a lock that
/// does not go with this one. On a file system without locks nobody watches, and all is allowed.
inline bool try_lock(int descriptor, LockKind kind) {
  const int how = kind == LockKind::alone ? LOCK_EX : LOCK_SH;
  return flock(descriptor, how | LOCK_NB) == 0 || errno != EWOULDBLOCK;
}

}  // namespace trunk
