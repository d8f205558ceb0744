#include "records/provenance.hpp"

#include <fmt/format.h>
#include <gsl/gsl_version.h>
#include <nlopt.h>

#include <Eigen/Core>

#include "files/sha256.hpp"
#include "results/hdf5_version.hpp"

namespace trunk {
namespace {

std::vector<std::pair<std::string, std::string>> libraries() {
  int major = 0, minor = 0, patch = 0;
  nlopt_version(&major, &minor, &patch);
  return {{"Eigen", fmt::format("{}.{}.{}", EIGEN_WORLD_VERSION, EIGEN_MAJOR_VERSION, EIGEN_MINOR_VERSION)},
          {"GSL", gsl_version},
          {"HDF5", hdf5_version()},
          {"NLopt", fmt::format("{}.{}.{}", major, minor, patch)}};
}

}  // namespace

Provenance provenance_of(const std::vector<std::filesystem::path>& inputs, const std::string& argv) {
  Provenance p;
  p.version = TRUNK_VERSION;
  p.git_sha = TRUNK_GIT_SHA;
  p.git_dirty = TRUNK_GIT_DIRTY;
  p.compiler = "g++ " __VERSION__;
  p.build_type = TRUNK_BUILD_TYPE;
  p.argv = argv;
  for (const auto& input : inputs) p.input_sha256.emplace_back(input.string(), sha256_of_file(input));
  p.libraries = libraries();
  return p;
}

std::string version_text() {
  const Provenance p = provenance_of({}, "");
  std::string text =
      fmt::format("trunk {} ({}{})\n{}, {} build\n", p.version, p.git_sha.empty() ? "no git" : p.git_sha,
                  p.git_dirty ? ", with changes" : "", p.compiler, p.build_type);
  for (const auto& [name, version] : p.libraries) text += fmt::format("{} {}\n", name, version);
  return text + "licence GPL-3.0-or-later";
}

}  // namespace trunk
