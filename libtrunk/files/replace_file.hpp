#pragma once

#include <cstddef>
#include <filesystem>
#include <span>
#include <string_view>
#include <vector>

namespace trunk {

/// Checks that a result can be stored at `path` later. Call it before any long work. Throws InputError if the
/// file exists (unless `force`) or is not a regular file, or if its folder is missing, not a folder or not
/// writable. To test this, it creates a file in the folder and removes it.
void require_writable_output(const std::filesystem::path& path, bool force);

/// Makes sure that no output replaces a file that the command reads, or another output. Throws InputError.
void require_apart(const std::vector<std::filesystem::path>& inputs,
                   const std::vector<std::filesystem::path>& outputs);

/// Stores `bytes` followed by `more` at `path`, completely or not at all. The bytes go to a new file beside
/// it whose name ends in `.part`; this file is synchronised and then renamed. Until then, an old file and its
/// readers are not disturbed. Throws InputError with the file and the cause, and removes the `.part` file.
///
/// A limit on file sizes (`ulimit -f`) causes an InputError only in a program that ignores SIGXFSZ.
void replace_file(const std::filesystem::path& path, std::span<const std::byte> bytes,
                  std::span<const std::byte> more = {});
inline void replace_file(const std::filesystem::path& path, std::string_view text) {
  replace_file(path, std::as_bytes(std::span(text)));
}

}  // namespace trunk
