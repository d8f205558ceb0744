// This file is compiled once for each instruction set. The build gives each variant its name and its number
// of lanes. The rest of the program sees only the Kernel of a variant (see kernels.cmake).
#include "dynamics/breath_course.hpp"
#include "dynamics/kernel.hpp"
#include "dynamics/volume_curve.hpp"
#include "math/dual.hpp"

namespace trunk {

extern const Kernel TRUNK_KERNEL;
const Kernel TRUNK_KERNEL{TRUNK_KERNEL_INSTRUCTIONS,
                          TRUNK_KERNEL_LANES,
                          TRUNK_KERNEL_LANES,
                          &step<double>,
                          &calc_volume_curves<Lanes<TRUNK_KERNEL_LANES>>,
                          &calc_volume_curves<double>,
                          &calc_breath_courses<Lanes<TRUNK_KERNEL_LANES>>,
                          &calc_breath_courses<double>,
                          &calc_volume_derivatives<TRUNK_KERNEL_LANES>};

}  // namespace trunk
