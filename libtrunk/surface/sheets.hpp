#pragma once

#include "surface/repair.hpp"

namespace trunk {

/// Replaces a thin sheet that has two sides by its middle. Segmentation tools export a diaphragm so, closed
/// around a rim or open. A surface is such a sheet if 70 % of its area has another part of the surface close
/// by along its normal, nearer than 5 % of the largest extent (our choice). The side that is farther from the
/// middle stays and moves halfway to the other. Points have to be merged, and the surface oriented so that it
/// faces outward.
/// => surface, report.sheet_triangles, report.sheet_share, report.sheet_thickness
void take_middle_of_sheet(MeasuredSurface& surface, RepairReport& report);

}  // namespace trunk
