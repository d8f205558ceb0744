#pragma once

#include <cstddef>
#include <filesystem>
#include <span>
#include <string>

namespace trunk {

/// What stands behind the last byte of HDF5 in our files: "sha256 ", the SHA-256 of all bytes before in
/// hexadecimal, and a line feed (our choice). Checksums within HDF5 leave gaps; this one leaves none, and it
/// is tested before HDF5 reads anything: HDF5 1.10 does not survive all damage. Readers of HDF5 do not see
/// it, and a program that changes the file drops it.
std::string seal_of(std::span<const std::byte> hdf5);

/// Throws InputError where the file is truncated, its seal is broken, or it is HDF5 that we never write. A
/// file without a seal passes. `path` must be an HDF5 file that can be read.
void require_intact(const std::filesystem::path& path);

}  // namespace trunk
