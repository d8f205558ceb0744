#pragma once

#include <cstddef>
#include <filesystem>
#include <string>
#include <vector>

#include "sweep/design.hpp"

namespace trunk {

/// The largest size, in bytes, of a text file of a sweep that is read.
inline constexpr std::size_t longest_sweep_text = 10'000'000;

/// Returns the program and version that results belong to.
std::string program_text();

/// Returns what a sweep's folder belongs to, as lines: the number of runs, the program, the hash of
/// everything that decides the results, then the hash and the name of every file.
std::string fingerprint_of(const SweepDesign& design);

/// Returns the fingerprint stored in a folder, or "" if there is none; throws InputError if it cannot be
/// read.
std::string read_fingerprint(const std::filesystem::path& folder);

/// Returns the lines of a fingerprint from a number on, counted from 0.
std::vector<std::string> lines_from(std::size_t first, const std::string& fingerprint);

/// Returns what two fingerprints of the same sweep share: names of files are left out, since they depend on
/// the folder that the sweep was called from.
std::string identity(const std::string& fingerprint);

/// Returns the number of runs; throws InputError if the fingerprint is not one of ours.
std::size_t runs_in(const std::string& fingerprint, const std::filesystem::path& folder);

/// Returns the same, but never more than a design makes: a damaged folder may claim any number.
std::size_t most_runs_in(const std::string& fingerprint, const std::filesystem::path& folder);

}  // namespace trunk
