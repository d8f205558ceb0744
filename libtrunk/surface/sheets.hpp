#pragma once

#include "surface/repair.hpp"

namespace trunk {

/// Recognises a thin sheet that has two sides, closed around a rim or open (as segmentation tools export a
/// diaphragm), by the share of its area that has another part of the surface close by along its normal:
/// nearer than 2 % of the largest extent, on 70 % of the area (our choice). Of such a sheet the side
/// that is farther from the middle stays, moved halfway to the other. Expects merged points and an oriented
/// surface that faces outward. => report.sheet_…, surface
void take_middle_of_sheet(MeasuredSurface& surface, RepairReport& report);

}  // namespace trunk
