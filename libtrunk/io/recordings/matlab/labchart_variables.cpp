#include "recordings/matlab/labchart_variables.hpp"

#include <algorithm>
#include <cmath>

namespace trunk {
namespace {

const MatVariable* named(const MatContent& content, const std::string& name) {
  for (const MatVariable& variable : content.variables)
    if (variable.name == name) return &variable;
  return nullptr;
}

// Returns an index from 1 as one from 0; `count` if it is none.
std::size_t index_of(double value, std::size_t count) {
  return value >= 1 && value <= static_cast<double>(count) && value == std::floor(value)
             ? static_cast<std::size_t>(value) - 1
             : count;
}

}  // namespace

std::optional<LabChartVariables> LabChartVariables::in(const MatContent& content) {
  LabChartVariables v;
  v.data_ = named(content, "data");
  v.starts_ = named(content, "datastart");
  v.ends_ = named(content, "dataend");
  v.rates_ = named(content, "samplerate");
  if (!v.data_ || !v.starts_ || !v.ends_ || !v.rates_) return std::nullopt;
  const auto like_starts = [&](const MatVariable& other) {
    return other.rows == v.starts_->rows && other.columns == v.starts_->columns &&
           other.values.size() == v.starts_->values.size();
  };
  if (v.starts_->values.empty() || std::min(v.data_->rows, v.data_->columns) != 1 || !like_starts(*v.ends_) ||
      !like_starts(*v.rates_))
    return std::nullopt;
  v.titles_ = named(content, "titles");
  v.units_ = named(content, "unittext");
  v.unit_map_ = named(content, "unittextmap");
  if (v.titles_ && v.titles_->texts.size() != v.starts_->rows) v.titles_ = nullptr;
  if (v.unit_map_ && !like_starts(*v.unit_map_)) v.unit_map_ = nullptr;
  return v;
}

double LabChartVariables::length_s(std::size_t block) const {
  double longest = 0;
  for (const Channel& channel : channels(block))
    longest = std::max(longest, static_cast<double>(channel.count) / channel.rate_hz);
  return longest;
}

std::vector<LabChartVariables::Channel> LabChartVariables::channels(std::size_t block) const {
  std::vector<Channel> found;
  const std::size_t all = data_->values.size();
  for (std::size_t i = 0; i < starts_->rows; ++i) {
    const std::size_t at = block * starts_->rows + i;
    const std::size_t first = index_of(starts_->values[at], all), last = index_of(ends_->values[at], all);
    const double rate = rates_->values[at];
    if (first == all || last == all || last < first || !(rate > 0) || !std::isfinite(rate)) continue;
    Channel channel{titles_ ? titles_->texts[i] : "", "", rate, first, last - first + 1};
    if (channel.name.empty()) channel.name = "Channel " + std::to_string(i + 1);
    if (units_ && unit_map_) {
      const std::size_t unit = index_of(unit_map_->values[at], units_->texts.size());
      if (unit < units_->texts.size()) channel.unit = units_->texts[unit];
    }
    found.push_back(std::move(channel));
  }
  return found;
}

}  // namespace trunk
