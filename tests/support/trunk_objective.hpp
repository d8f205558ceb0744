#pragma once

#include "dynamics/recoil.hpp"
#include "estimation/fit_problem.hpp"

namespace trunk::test {

/// The log-posterior of a trunk without a compartment beside it.
class TrunkObjective {
 public:
  TrunkObjective(const Trunk& trunk, const TimeGrid& grid, const SearchSpace& space,
                 const MeasuredCurve& measured, Ledger& ledger)
      : model_(trunk, grid, measured, ledger), objective_(model_, grid, space, measured) {}

  Objective* operator->() noexcept { return &objective_; }
  Objective& operator*() noexcept { return objective_; }
  std::size_t simulated() const noexcept { return model_.simulated(); }

 private:
  TrunkModel model_;
  Objective objective_;
};

/// The compartment of a trunk, as a fit takes it.
inline TrunkAsCompartment compartment_of(const Trunk& trunk, const Parameters<double>& parameters) {
  return as_compartment(measure_recoil(trunk.model, parameters));
}

}  // namespace trunk::test
