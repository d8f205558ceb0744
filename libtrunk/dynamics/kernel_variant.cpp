// Compiled once an instruction set, each with the name and the number of lanes given by the build; of what a
// variant defines, no other part of the program sees more than its Kernel (see CMakeLists.txt).
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
