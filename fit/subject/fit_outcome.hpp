#pragma once

#include "clinic/clinic.hpp"
#include "prediction/predict.hpp"
#include "subject/each_breath.hpp"

namespace trunk {

/// All that came of the fit of one subject. JSON, tables, text and the result file are each written from it.
struct FitOutcome {
  Estimation estimation;
  FitResults results;
  std::string input;                    // the trace's own file name; "" if only a tidal volume was given
  std::vector<BreathRefit> breaths;     // empty unless --breath each
  std::vector<Candidate> draws;         // as likely as the fit says; empty if it knows no spread
  std::vector<ClinicNumber> clinic;     // of the breaths that were averaged; empty without a pressure
  std::vector<Prediction> predictions;  // in the order in which scenarios were named
  std::vector<std::string> notes;       // on what was read, then on the fit
  std::size_t replayed = 0;             // simulations that an interrupted run left in the ledger
  double wall_s = 0.0;
};

}  // namespace trunk
