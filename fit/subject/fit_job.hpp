#pragma once

#include "subject/fit_outcome.hpp"
#include "subject/fit_request.hpp"
#include "subject/other_scenario.hpp"

namespace trunk {

/// What a fit tells while it is at work.
struct FitListener {
  std::function<void(const std::string&)> note, progress;
};

/// One subject's fit from the request to the file. The constructor reads and checks everything, carry_out
/// fits, store writes.
class FitJob {
 public:
  /// Reads all files and changes none. Throws InputError.
  FitJob(const FitRequest& request, Execution execution, FitListener listener);

  const SubjectFit& fit() const noexcept { return *fit_; }
  const std::vector<std::string>& notes() const noexcept { return notes_; }  // on what was read
  std::vector<std::filesystem::path> inputs() const;

  /// Fits. Simulations go to a ledger beside the result. Throws Cancelled, and std::runtime_error if no
  /// simulation completed.
  FitOutcome carry_out();
  /// Writes the result, and the fitted scenario if the request names a file for it; removes the ledger.
  /// `argv` is the command line as typed. Throws InputError.
  void store(const FitOutcome& outcome, const std::string& argv);

  std::filesystem::path ledger_file() const { return request_.output + ".ledger"; }

 private:
  Measurement measured();
  void read_others();
  std::vector<Prediction> predictions(const FitOutcome& outcome) const;

  FitRequest request_;
  FitListener listener_;
  std::vector<std::string> notes_;
  std::optional<Segmentation> each_;  // the breaths, if each is to be fitted
  std::unique_ptr<const SubjectFit> fit_;
  std::vector<OtherScenario> others_;
  std::unique_ptr<Ledger> ledger_;
};

}  // namespace trunk
