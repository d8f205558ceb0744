#pragma once

#include <cstddef>
#include <optional>
#include <vector>

#include "breaths/segment.hpp"

namespace trunk {

/// A channel over the mean breath, stretched in time as the volume is. Pressures (Pa) and the excursion (m)
/// are changes from end-expiration: the line from the level at the onset of a breath to that at its end is
/// removed. An EMG is in its own unit, above the lowest value of its mean.
struct MeasuredChannel {
  ChannelKind kind = ChannelKind::pleural;
  std::string column;                     ///< name in the file, for messages
  std::string unit;                       ///< that the values had in the file, for messages
  std::vector<double> value;              ///< [samples of the mean breath] mean over `each`
  std::vector<double> sigma;              ///< [samples] standard deviation over breaths; > 0
  std::vector<double> standard_error;     ///< [samples] of `value`
  std::vector<std::size_t> breaths;       ///< [that count] positions in MeasuredBreath::used
  std::vector<std::vector<double>> each;  ///< [breaths that count][samples]
  double end_expiratory = 0;              ///< mean level that was removed, as the trace has it
  std::vector<std::string> notes;         ///< messages about this channel
};

/// The breath that a fit follows, on an even time grid from 0 (onset) to duration_s, both included.
struct MeasuredBreath {
  std::vector<double> time_s;             ///< [samples]
  std::vector<double> volume_m3;          ///< [samples] above end-expiration; exactly 0 at both ends
  std::vector<double> sigma_m3;           ///< [samples] > 0; see mean_breath and single_breath
  std::vector<double> standard_error_m3;  ///< [samples] of volume_m3: sigma_m3 over the root of breaths_used
  double inspiration_s = 0, duration_s = 0, tidal_volume_m3 = 0;  ///< means over the breaths used
  double pause_s = 0;  ///< mean rest at the end of expiration, part of duration_s
  int breaths_used = 0, breaths_rejected = 0;
  std::vector<Breath> used;  ///< [breaths] the breaths that are averaged, with their times and sizes
  /// [breaths][samples] their volumes, stretched as for the mean and exactly 0 at both ends: volume_m3 is
  /// their mean. The spread of what is fitted comes from them.
  std::vector<std::vector<double>> each_m3;
  std::vector<MeasuredChannel> channels;  ///< at most one of each kind
  std::optional<double> excursion_m{};    ///< of a dome from end-expiration to end-inspiration, if one number
  std::optional<TimeWindow> window{};     ///< of the breaths, if the user chose one

  const MeasuredChannel* channel(ChannelKind kind) const;  ///< null if it was not measured
};

/// Returns the time of the trace in a breath that corresponds to time t of the mean: the same part of the
/// same phase.
double time_in(const Breath& breath, const MeasuredBreath& mean, double t);

/// Returns the mean of the kept breaths. Inspirations and expirations are stretched linearly to their mean
/// durations, so that peaks coincide; then volumes are averaged. A pause that is longer than the median one
/// by more than a tenth of a breath is cut to the median first. sigma is the standard deviation over breaths
/// (the noise of one breath if fewer than three are kept), or the trace's own sigma if that is larger. It is
/// at least 1 % of the tidal volume, because all breaths are set to 0 at their ends and no spirometer is more
/// exact (our choice).
///
/// Channels follow their breaths (see mean_channels). Throws InputError if samples < 3, if no breath is kept,
/// or if the signal is a belt that is not calibrated.
MeasuredBreath mean_breath(const Segmentation& segmentation, int samples = 200);

/// Returns breath `number`, kept or not, counted from 1 as in the list shown to the user. sigma is the
/// trace's own if it has one, otherwise the noise of the volume, and at least 1 % of the tidal volume.
///
/// Throws InputError if there is no such breath, if samples < 3, or if the signal is a belt that is not
/// calibrated.
MeasuredBreath single_breath(const Segmentation& segmentation, std::size_t number, int samples = 200);

}  // namespace trunk
