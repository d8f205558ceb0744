#pragma once

#include <optional>
#include <string>
#include <vector>

#include "surface/axes.hpp"
#include "surface/measured_surface.hpp"

namespace trunk {

/// Which lungs a surface shows. The model has one lung: both lungs and what lies between them.
enum class LungSide { both, right, left };

/// Measured lungs without what the model's lung does not have: sides that face the heart or the other lung,
/// walls of fissures and airways inside, the windpipe.
struct LungSurface {
  MeasuredSurface outer;  // open where something was left out; the measured surface itself if nothing was
  LungSide side = LungSide::both;
  bool two_bodies = false;  // right and left lung are apart
  double volume = 0.0;      // m3, of the measured lungs, with what their fissures and airways hold
  double gap = 0.0;         // m, the narrowest distance between the lungs; 0 unless there are two
  double middle = 0.0;      // m, of one lung: the x of the plane half-way to where the other one is assumed
  std::vector<std::string> notes;
};

/// Returns all surfaces as one.
MeasuredSurface joined(const std::vector<MeasuredSurface>& surfaces);

/// Returns the outer surface of one lung or of both (our own method). A staircase of voxels is smoothed,
/// since its sides do not face where the lung does. The lungs become cubes of 3 mm. Small gaps are closed;
/// what is thin and lies between the lungs, like the windpipe, is taken away; the gap between the lungs is
/// filled along x. Triangles stay that lie within two cubes of the outside, and do not face the other lung. A
/// surface that is narrower than deep is one lung: its inner side is the one towards which its top leans and
/// on which it is flat, unless `given` says it; the other lung is assumed 60 mm away from it. z is up. Throws
/// InputError if the shape does not say which lung it is.
LungSurface outer_lungs(const MeasuredSurface& measured, std::optional<LungSide> given = {});

/// Returns the axes that two lungs apart from each other show, taken as in the file, m; nothing if they are
/// not two or do not show them. They lie side by side; their lower side is hollow; the right lung is larger
/// than the left, and their lower edge is lower at the back. Left and right follow only if the last two
/// agree.
std::optional<GuessedAxes> guess_axes_of_lungs(const MeasuredSurface& lungs);

}  // namespace trunk
