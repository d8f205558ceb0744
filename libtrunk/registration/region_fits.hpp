#pragma once

#include "registration/register_trunk.hpp"

namespace trunk {

/// Adds how well the part of an attraction lies on its target, as a whole and region by region. => fits
void add_region_fits(const TrunkMesh& mesh, const Attraction& attraction, std::vector<RegionFit>& fits);

/// Regions of which no target shows as much as half the particles, and how many particles none shows: those
/// nothing of whose triangles has data. => particles
std::vector<std::string> regions_without_data(const TrunkMesh& mesh, std::span<const Attraction> attractions,
                                              std::size_t& particles);

}  // namespace trunk
