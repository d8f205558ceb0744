#pragma once

#include <sys/file.h>

#include <cerrno>

namespace trunk {

enum class LockKind { shared, alone };

/// Locks an open file for this process until the file is closed. Returns false if another process holds a
/// conflicting lock. Returns true on a file system without locks, where conflicts cannot be detected.
inline bool try_lock(int descriptor, LockKind kind) {
  const int how = kind == LockKind::alone ? LOCK_EX : LOCK_SH;
  return flock(descriptor, how | LOCK_NB) == 0 || errno != EWOULDBLOCK;
}

}  // namespace trunk
