#pragma once

#include <optional>
#include <string>
#include <vector>

#include "traces/choose_columns.hpp"

namespace trunk {

/// The samples of a trace on their way from file to Trace: what they are in the file, and where.
class RawSamples {
 public:
  /// Reads the chosen channels.
  RawSamples(Recording& recording, const TraceColumns& columns);

  const std::string& word() const { return recording_.word; }
  std::size_t size() const { return samples_.values.front().size(); }

  /// Puts numbers where samples have none (NaN): interpolated, by sample number, over at most a quarter of a
  /// second and in at most a tenth of the samples (our choice), left out at either end of the recording. Adds
  /// a note. Throws InputErrors where more is missing.
  void bridge_missing(std::vector<std::string>& notes);

  /// In SI units; a belt's value as in the file. Times are those of the samples, or counted by their rate.
  std::vector<double> time_s() const;
  std::vector<double> time_of_whole_samples_s() const;  ///< NaN where another number is missing
  std::vector<double> value() const;
  std::vector<double> sigma_m3() const;  ///< empty where there is none

  /// An InputError at a sample: its line, or its number where the file has no lines.
  InputError error(std::size_t sample, const std::string& text) const;
  InputError error_of_all(const std::string& text) const { return InputError(recording_.source, 0, text); }

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
  std::vector<std::size_t> chosen_;  // value, then time and sigma where there are such
  Samples samples_;
};

}  // namespace trunk
