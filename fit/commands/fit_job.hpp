#pragma once

#include "commands/options/fit_options.hpp"
#include "commands/text/output.hpp"
#include "subject/each_breath.hpp"
#include "subject/predict.hpp"

namespace trunk {

/// What a fit says while it is at work.
struct FitListener {
  std::function<void(const std::string&)> note, progress;
};

/// All that came of a fit.
struct FitOutcome {
  Estimation estimation;
  std::vector<BreathRefit> breaths;
  std::vector<Prediction> predictions;
  std::size_t replayed = 0;  // simulations found from an interrupted run
  double wall_s = 0.0;
};

/// One subject's fit from the options to the file: read and checked as a whole, then carried out, then
/// stored.
class FitJob {
 public:
  /// Reads all files but changes none. Throws InputError.
  FitJob(const FitRequest& request, Execution execution, FitListener listener);

  const SubjectFit& fit() const noexcept { return *fit_; }
  const std::vector<std::string>& notes() const noexcept { return notes_; }  // on what was read
  std::vector<std::filesystem::path> inputs() const;

  /// Simulations go to a ledger beside the result. Throws Cancelled, and std::runtime_error where no
  /// simulation completed.
  FitOutcome carry_out();
  /// Writes the result and whatever else was asked for; the ledger is not needed any more.
  void store(const FitOutcome& outcome, const std::string& argv);

  std::filesystem::path ledger_file() const { return request_.output + ".ledger"; }

 private:
  Measurement measured();
  void read_others();

  FitRequest request_;
  FitListener listener_;
  std::vector<std::string> notes_;
  std::optional<Segmentation> each_;  // where every breath is asked for
  std::unique_ptr<const SubjectFit> fit_;
  std::vector<OtherScenario> others_;
  std::unique_ptr<Ledger> ledger_;
};

Exit exit_of(const Estimation& e);

}  // namespace trunk
