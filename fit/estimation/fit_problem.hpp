#pragma once

#include "compartment/compartment_model.hpp"
#include "problem/objective.hpp"
#include "problem/trunk_model.hpp"

namespace trunk {

/// What a fit compares with what. All that it refers to must outlive it.
struct FitProblem {
  const Trunk& trunk;
  const TimeGrid& grid;
  const SearchSpace& space;
  const MeasuredCurve& measured;
  const TrunkAsCompartment& compartment;
  Parameters<double> begin = {};                  // where a search that is asked for by name begins
  Knowledge knowledge = {};                       // what else is known of a candidate
  double correlation = 0.0;                       // of neighbouring samples
  std::vector<std::vector<double>> breaths = {};  // [breaths][samples] m3, of which `measured` is the mean
};

}  // namespace trunk
