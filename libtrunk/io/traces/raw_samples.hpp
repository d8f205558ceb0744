#pragma once

#include <optional>
#include <string>
#include <vector>

#include "traces/choose_columns.hpp"
#include "traces/used_samples.hpp"

namespace trunk {

inline constexpr double longest_bridge_s = 0.25;  ///< without a number; our choice

/// The samples of a recording before they become a Trace, and their places in the file.
class RawSamples {
 public:
  /// Reads the chosen channels; throws InputError if they cannot be read.
  RawSamples(Recording& recording, const TraceColumns& columns);

  const std::string& word() const { return recording_.word; }
  const std::vector<ColumnName>& names() const { return columns_.all; }  ///< of all channels
  std::size_t size() const { return samples_.values.front().size(); }
  const UsedSamples& used() const { return used_; }

  /// Leaves out the rows in which the signal has no number, if more than a tenth are such rows and the others
  /// are evenly spaced, in time or in the file: then channels at different rates share the rows, and nothing
  /// is missing. "Evenly" means that 49 of 50 steps differ by less than a quarter from the median (our
  /// choice). Adds a note.
  void leave_out_other_rates(std::vector<std::string>& notes);

  /// Repairs samples without a number (NaN): interpolates them by sample number, and removes them at either
  /// end of the recording. Adds a note. Throws InputErrors if more than a quarter of a second is missing at a
  /// time, or more than a tenth of all samples (our choice).
  void bridge_missing(std::vector<std::string>& notes);

  /// Return the samples in SI units, the values of a belt in the unit of the file. Times come from the file,
  /// or from the sampling rate.
  std::vector<double> time_s() const;
  std::vector<double> time_of_whole_samples_s() const;  ///< NaN if another number of the sample is missing
  std::vector<double> value() const;
  std::vector<double> sigma_m3() const;  ///< empty if there is none

  /// Returns a mistake at the line of a sample. If the file has no lines, the text begins with the number of
  /// the sample.
  Mistake mistake_at(std::size_t sample, std::string found, std::string expected, std::string remedy) const;
  /// Returns an error about the whole recording.
  InputError error(std::string found, std::string expected, std::string remedy) const;

 private:
  struct Run {
    std::size_t begin, end;
  };
  std::vector<Run> runs_without_number() const;
  bool at_an_end(const Run& run) const { return run.begin == 0 || run.end == size(); }
  void note(const std::vector<Run>& runs, std::vector<std::string>& notes) const;
  double step_s() const;
  Mistake flaw(std::size_t sample) const;
  void interpolate(const Run& run);
  void leave_out(const Run& run);
  std::vector<double> scaled(std::size_t row, std::size_t column) const;

  const Recording& recording_;
  const TraceColumns& columns_;
  std::vector<std::size_t> chosen_;  // the value, then time and sigma if there are any
  Samples samples_;
  UsedSamples used_;
};

}  // namespace trunk
