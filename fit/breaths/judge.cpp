#include "breaths/judge.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <iterator>

#include "breaths/breath_sizes.hpp"
#include "breaths/breath_text.hpp"
#include "breaths/median_of.hpp"

namespace trunk {
namespace {

constexpr std::size_t most_listed = 4;
constexpr double shallow_size = 0.3;  // of the upper quartile

template <class Text>
std::string far_from_median(const std::string& what, double value, double usual, Text text) {
  if (value < 0.5 * usual) return what + " " + text(value) + " is under half the median " + text(usual);
  if (value > 2 * usual) return what + " " + text(value) + " is over twice the median " + text(usual);
  return "";
}

std::string odd_inspiration(const Breath& breath) {
  const double part = breath.inspiration_s() / breath.duration_s();
  if (part >= 0.1 && part <= 0.9) return "";
  return "inspiration takes " + number_text(100 * part, 2) + " % of the breath";
}

// Returns a reason if the recording ends within the last breath: its expiration is shorter than usual.
std::string cut_off(const Breath& breath, double record_end_s, double usual_expiration_s) {
  const bool at_the_end = record_end_s - breath.end_s < 0.02 * breath.duration_s();
  if (!at_the_end || breath.expiration_s() >= 0.8 * usual_expiration_s) return "";
  return "the recording ends " + seconds_text(breath.expiration_s()) +
         " into its expiration, which usually lasts " + seconds_text(usual_expiration_s);
}

template <class Text>
std::string odd_return(const Breath& breath, double shift, Text text) {
  if (std::abs(shift) <= 0.5 * breath.tidal_volume_m3) return "";
  return "ends " + text(std::abs(shift)) + (shift > 0 ? " above" : " below") +
         " where it began, over half of its tidal volume " + text(breath.tidal_volume_m3);
}

// Returns the breaths that show what is usual: those of the most common size, or all but very shallow ones.
std::vector<Breath> usual_of(const std::vector<Breath>& breaths, const std::vector<SizedPart>& parts) {
  std::vector<Breath> main;
  if (parts.empty()) {
    std::vector<double> sizes;
    for (const Breath& b : breaths) sizes.push_back(b.tidal_volume_m3);
    std::sort(sizes.begin(), sizes.end());
    const double least = shallow_size * sizes[sizes.size() * 3 / 4];
    std::copy_if(breaths.begin(), breaths.end(), std::back_inserter(main),
                 [&](const Breath& b) { return b.tidal_volume_m3 >= least; });
  }
  for (const SizedPart& part : parts)
    for (std::size_t i = part.first; part.main && i <= part.last; ++i) main.push_back(breaths[i]);
  return main;
}

}  // namespace

std::vector<double> shifts_of(const Landmarks& marks, double drift) {
  const std::vector<double>&time = marks.rest.time, &value = marks.rest.value;
  const auto slope = [&](std::size_t k) { return (value[k + 1] - value[k]) / (time[k + 1] - time[k]); };
  std::vector<double> shifts;
  for (std::size_t i = 0; i + 1 < time.size(); ++i) {
    double sudden = slope(i) - drift;
    const auto compare = [&](double other) {
      if (std::abs(slope(i) - other) < std::abs(sudden)) sudden = slope(i) - other;
    };
    if (i > 0) compare(slope(i - 1));
    if (i + 2 < time.size()) compare(slope(i + 1));
    shifts.push_back(sudden * (time[i + 1] - time[i]) / marks.tidal_volume[i]);
  }
  return shifts;
}

void judge(Segmentation& result, const std::vector<double>& shifts, const BreathSelection& selection) {
  const std::vector<SizedPart> parts = breath_sizes(result.breaths);
  const std::vector<Breath> usual = usual_of(result.breaths, parts);
  const double usual_volume = median_of(usual, tidal_volume_of),
               usual_duration = median_of(usual, duration_of);
  const double usual_expiration = median_of(usual, [](const Breath& b) { return b.expiration_s(); });
  const auto volume = [&](double v) { return volume_text(v, result.calibrated); };
  for (std::size_t i = 0; i < result.breaths.size(); ++i) {
    Breath& breath = result.breaths[i];
    breath.kept = true, breath.reason = "";
    for (const auto& reason :
         {far_from_median("tidal volume", breath.tidal_volume_m3, usual_volume, volume),
          far_from_median("duration", breath.duration_s(), usual_duration,
                          [](double s) { return seconds_text(s); }),
          odd_inspiration(breath), odd_return(breath, shifts[i] * breath.tidal_volume_m3, volume),
          cut_off(breath, result.time_s.back(), usual_expiration)}) {
      if (reason.empty()) continue;
      breath.kept = false;
      breath.reason += (breath.reason.empty() ? "" : "; ") + reason;
    }
  }
  for (const SizedPart& part : parts)
    for (std::size_t i = part.first; !part.main && i <= part.last; ++i)
      if (Breath& breath = result.breaths[i]; breath.kept) {
        breath.kept = false;
        breath.reason =
            "the breaths around it have another size, " + volume(part.tidal_volume_m3) + " (see the note)";
      }
  overrule(result.breaths, selection, result.source);
}

std::string note_of_sizes(const Segmentation& s) {
  const std::vector<SizedPart> parts = breath_sizes(s.breaths);
  if (parts.empty()) return "";
  std::string list;
  for (std::size_t i = 0; i < std::min(parts.size(), most_listed); ++i) {
    const Breath &first = s.breaths[parts[i].first], &last = s.breaths[parts[i].last];
    list += fmt::format("{}{} from {:.2f} to {:.2f} s (breaths {} to {})", i > 0 ? ", " : "",
                        volume_text(parts[i].tidal_volume_m3, s.calibrated), first.onset_s, last.end_s,
                        first.number, last.number);
  }
  if (parts.size() > most_listed) list += fmt::format(", and {} more parts", parts.size() - most_listed);
  return fmt::format(
      "the breaths have more than one size: {}; only the size of most breaths, {}, is used: choose a part "
      "with --begin and --end",
      list, volume_text(median_of(usual_of(s.breaths, parts), tidal_volume_of), s.calibrated));
}

}  // namespace trunk
