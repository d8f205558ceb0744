#pragma once

#include <cstdint>
#include <cstdio>
#include <filesystem>
#include <memory>
#include <vector>

namespace trunk {

/// The records of an EDF+D or BDF+D file, each of which says when it begins.
struct InterruptedEdf {
  struct Part {
    std::uint64_t first = 0, count = 0;  ///< records that follow each other without a gap
    double start_s = 0;                  ///< of the first one, since the start of the recording
  };
  std::uint64_t header_bytes = 0, record_bytes = 0;
  std::uint64_t times_at = 0, times_bytes = 0;  ///< the channel of annotations in a record
  double record_s = 0;
  std::vector<Part> parts;  ///< at least one
};

/// Reads when the records begin. A record follows the one before without a gap if it begins when that one
/// ends, give or take half a sample of the fastest channel (our choice). Throws InputError if the header or a
/// time cannot be read, or if there are more than 10 million records.
InterruptedEdf uninterrupted_parts(const std::filesystem::path& path);

struct CloseFile {
  void operator()(std::FILE* file) const { std::fclose(file); }
};
using TemporaryFile = std::unique_ptr<std::FILE, CloseFile>;

/// Returns a copy of one part as a continuous file, which has no name and is gone when it is closed. Its
/// first record begins at 0 s and has no other annotations, since EDFlib wants less than a second there.
/// Throws InputError if the part is longer than 1 GB or if there is no room for it.
TemporaryFile continuous_copy(const std::filesystem::path& path, const InterruptedEdf& edf,
                              const InterruptedEdf::Part& part);

}  // namespace trunk
