#pragma once

#include "registration/register_trunk.hpp"

namespace trunk {

/// Adds how well the part of an attraction lies on its target, as a whole and for each region. => fits
void add_region_fits(const TrunkMesh& mesh, const Attraction& attraction, std::vector<RegionFit>& fits);

/// Returns the regions with data for less than half of their particles. A particle has data if a target shows
/// a part of its triangles. => particles, the number of those without data
std::vector<std::string> regions_without_data(const TrunkMesh& mesh, std::span<const Attraction> attractions,
                                              std::size_t& particles);

}  // namespace trunk
