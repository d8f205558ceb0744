#pragma once

#include <cstddef>
#include <filesystem>
#include <span>
#include <string_view>

namespace trunk {

/// To be called before any long work: makes sure that a result can be stored at `path` later.
/// Throws InputError when the file exists (unless `force`) or is not a regular file, or when its
/// folder is missing, not a folder or not writable. A file is created there for trial and removed.
void require_writable_output(const std::filesystem::path& path, bool force);

/// Stores `bytes`, and `more` behind them, at `path`, whole or not at all: written to a new file beside it
/// (its name ends in
/// `.part`), synchronised, renamed. An old file, and whoever reads it, are left alone until then.
/// Throws InputError that names the file and the cause; the `.part` file is gone then.
///
/// A limit on file sizes (`ulimit -f`) is such a cause only in a program that ignores SIGXFSZ.
void replace_file(const std::filesystem::path& path, std::span<const std::byte> bytes,
                  std::span<const std::byte> more = {});
inline void replace_file(const std::filesystem::path& path, std::string_view text) {
  replace_file(path, std::as_bytes(std::span(text)));
}

}  // namespace trunk
