#include "recordings/matlab/apart.hpp"

#include <fcntl.h>
#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>

#include <cerrno>
#include <csignal>
#include <cstdio>
#include <string_view>

namespace trunk {
namespace {

void limit(__rlimit_resource resource, rlim_t most) {
  const rlimit bound{most, most};
  setrlimit(resource, &bound);
}

void bound_resources() {
  limit(RLIMIT_CORE, 0);
  limit(RLIMIT_CPU, 15);
#ifndef __SANITIZE_ADDRESS__
  limit(RLIMIT_AS, rlim_t{4} << 30);
#endif
}

bool write_all(int file, std::string_view bytes) {
  while (!bytes.empty()) {
    const ssize_t written = write(file, bytes.data(), bytes.size());
    if (written < 0 && errno == EINTR) continue;
    if (written <= 0) return false;
    bytes.remove_prefix(static_cast<std::size_t>(written));
  }
  return true;
}

[[noreturn]] void work_as_child(const std::function<std::string()>& work, int result) {
  bound_resources();
  if (const int nowhere = open("/dev/null", O_WRONLY); nowhere >= 0) dup2(nowhere, STDERR_FILENO);
  for (const int sign : {SIGSEGV, SIGABRT, SIGBUS, SIGFPE, SIGINT, SIGTERM}) std::signal(sign, SIG_DFL);
  try {
    _exit(write_all(result, work()) ? 0 : 1);
  } catch (...) {
    _exit(1);
  }
}

bool read_all(int file, std::string& bytes, std::size_t most_bytes) {
  std::string piece(std::size_t{1} << 16, '\0');
  for (;;) {
    const ssize_t count = read(file, piece.data(), piece.size());
    if (count < 0 && errno == EINTR) continue;
    if (count <= 0) return count == 0;
    bytes.append(piece, 0, static_cast<std::size_t>(count));
    if (bytes.size() > most_bytes) return false;
  }
}

}  // namespace

std::optional<std::string> run_apart(const std::function<std::string()>& work, std::size_t most_bytes) {
  int ends[2];
  std::fflush(nullptr);  // otherwise the child would write the parent's pending output again
  if (pipe2(ends, O_CLOEXEC) != 0) return std::nullopt;
  const pid_t child = fork();
  if (child == 0) {
    close(ends[0]);
    work_as_child(work, ends[1]);
  }
  close(ends[1]);
  std::string bytes;
  const bool whole = child > 0 && read_all(ends[0], bytes, most_bytes);
  close(ends[0]);  // SIGPIPE ends a child that still writes
  int status = 1;
  while (child > 0 && waitpid(child, &status, 0) < 0 && errno == EINTR) continue;
  if (!whole || status != 0) return std::nullopt;
  return bytes;
}

}  // namespace trunk
