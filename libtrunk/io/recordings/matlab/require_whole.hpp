#pragma once

#include <cstdint>
#include <filesystem>

namespace trunk {

/// Throws InputError if a MAT-file of version 5 ends in the middle of a variable, or if a compressed variable
/// does not unpack to its end with the checksum that zlib keeps there. libmatio looks at neither: it reads
/// missing values as zeros, and changed ones as they are, which look like a signal (23 of 220 flipped bits
/// gave other numbers). All variables together have at most `most_bytes` bytes unpacked. Files of other
/// versions pass: HDF5 finds such damage itself.
void require_whole(const std::filesystem::path& path, std::uint64_t most_bytes);

}  // namespace trunk
