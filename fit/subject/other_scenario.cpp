#include "subject/other_scenario.hpp"

#include "records/stored_subject.hpp"
#include "scenarios/build_trunk.hpp"

namespace trunk {

OtherScenario other_scenario(const SubjectFit& fit, const std::filesystem::path& path,
                             const std::vector<std::string>& settings) {
  ScenarioFile file = read_scenario(path, settings);
  breathe_as(fit.file().scenario, file.scenario);
  Trunk trunk = build_timed_trunk(file, stiffer_in_searches);
  return {std::move(file), std::move(trunk)};
}

bool same_geometry(const SubjectFit& fit, const OtherScenario& other) {
  const auto& a = fit.trunk().mesh.rest;
  const auto& b = other.trunk.mesh.rest;
  return std::equal(a.begin(), a.end(), b.begin(), b.end(),
                    [](const Vec3d& p, const Vec3d& q) { return dot(p - q, p - q) < 1e-12; });
}

}  // namespace trunk
