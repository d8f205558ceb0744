#pragma once

#include <cstddef>
#include <filesystem>
#include <span>
#include <string>

namespace trunk {

/// Returns the seal that our files have after the last byte of HDF5: "sha256 ", the SHA-256 of all bytes
/// before in hexadecimal, and a line feed (our choice). The checksums of HDF5 do not cover all bytes, but the
/// seal does. It is checked before HDF5 reads anything, since HDF5 1.10 crashes on some damage. Readers of
/// HDF5 do not see the seal, and a program that changes the file removes it.
std::string seal_of(std::span<const std::byte> hdf5);

/// Throws InputError if the file is truncated, if its seal does not match, or if it has a version of HDF5
/// that we never write. A file without a seal is accepted. `path` must be an HDF5 file that can be read.
void require_intact(const std::filesystem::path& path);

}  // namespace trunk
