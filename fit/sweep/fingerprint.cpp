#include "sweep/fingerprint.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <charconv>
#include <sstream>

#include "errors/input_error.hpp"
#include "files/read_file.hpp"
#include "files/sha256.hpp"
#include "records/provenance.hpp"
#include "trunks/read_trunk_pml.hpp"

namespace trunk {

namespace fs = std::filesystem;

std::string program_text() {
  const Provenance program = provenance_of({}, "");
  return fmt::format("trunk {} {}{}", program.version, program.git_sha, program.git_dirty ? "+" : "");
}

std::string fingerprint_of(const SweepDesign& design) {
  std::vector<fs::path> inputs;
  std::string all = program_text() + design.text;
  for (const auto& source : design.scenarios) {
    const ScenarioFile file = read_scenario(source.path);
    inputs.insert(inputs.end(), file.inputs.begin(), file.inputs.end());
    all += to_toml(file.scenario);
    if (file.scenario.mesh) all += trunk_pml(file.scenario);
  }
  for (const auto& source : design.subjects) inputs.push_back(source.path);
  inputs.push_back(design.path);
  std::string hashes;
  for (const auto& [name, hash] : provenance_of(inputs, "").input_sha256)
    hashes += fmt::format("{}  {}\n", hash, name);
  for (const auto& source : design.subjects) all += sha256_of_file(source.path);
  return fmt::format("{}\n{}\n{}\n{}", design.runs(), program_text(), sha256_of_text(all), hashes);
}

std::string read_fingerprint(const fs::path& folder) {
  const fs::path file = folder / "fingerprint";
  return fs::is_directory(folder) && fs::exists(file) ? read_text_file(file, longest_sweep_text) : "";
}

std::vector<std::string> lines_from(std::size_t first, const std::string& fingerprint) {
  std::istringstream text(fingerprint);
  std::vector<std::string> lines;
  for (std::string line; std::getline(text, line);) lines.push_back(line);
  lines.erase(lines.begin(), lines.begin() + static_cast<std::ptrdiff_t>(std::min(first, lines.size())));
  return lines;
}

std::string identity(const std::string& fingerprint) {
  std::size_t end = 0;
  for (int line = 0; line < 3 && end != std::string::npos; ++line) end = fingerprint.find('\n', end + 1);
  return fingerprint.substr(0, end);
}

std::size_t runs_in(const std::string& fingerprint, const fs::path& folder) {
  std::size_t runs = 0;
  const auto parsed = std::from_chars(fingerprint.data(), fingerprint.data() + fingerprint.size(), runs);
  if (fingerprint.empty() || parsed.ec != std::errc())
    throw InputError({folder.string()}, "holds no sweep", "a folder written by `trunk sweep`");
  return runs;
}

std::size_t most_runs_in(const std::string& fingerprint, const fs::path& folder) {
  return std::min<std::size_t>(runs_in(fingerprint, folder), 1 << 24);
}

}  // namespace trunk
