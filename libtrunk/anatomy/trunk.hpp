#pragma once

#include <map>
#include <string>
#include <vector>

#include "anatomy/template_mesh.hpp"
#include "anatomy/trunk_options.hpp"
#include "model/model.hpp"

namespace trunk {

/// A trunk ready to be simulated and measured: the model and the anatomical names of its particles.
struct Trunk {
  Model model;
  TemplateMesh mesh;
  std::map<std::string, std::vector<int>> regions;  // particles by anatomical name
};

/// Builds the trunk of the paper: elastic diaphragm and abdomen, central tendon, fibres, held spine, pelvis
/// and lung, and (our addition) the rib cage. Throws InputError on impossible sizes or factors.
Trunk make_trunk(const TrunkGeometry& geometry, const Tissue& tissue, Reaction reaction);

/// The part of a particle that belongs to a side: 1 inside, 0 on the other side, 1/2 on the midline.
double share_of_side(Side side, double x);

}  // namespace trunk
