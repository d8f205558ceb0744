#include "dynamics/step.hpp"

namespace trunk {

template void calc_forces<double>(const Model&, const Parameters<double>&, const double&,
                                  const State<double>&, Workspace<double>&) noexcept;
template StepReport<double> step<double>(const Model&, const Parameters<double>&, const double&,
                                         State<double>&, Workspace<double>&) noexcept;

}  // namespace trunk
