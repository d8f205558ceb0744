#include "recordings/matlab/matlab_recording.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cctype>
#include <cmath>
#include <map>

#include "recordings/matlab/labchart_variables.hpp"
#include "recordings/matlab/mat_variables.hpp"
#include "text/message_text.hpp"

namespace trunk {
namespace {

constexpr std::size_t most_values = 50'000'000;
constexpr std::size_t most_columns = 1000;  // of one matrix

std::string lower_case(std::string text) {
  std::transform(text.begin(), text.end(), text.begin(),
                 [](unsigned char c) { return static_cast<char>(std::tolower(c)); });
  return text;
}

/// Returns the own name of a field, which gives its meaning: "samplingrate" for "rec.Sampling_Rate".
std::string own_name(const MatVariable& variable) {
  std::string name = lower_case(variable.name.substr(variable.name.find_last_of('.') + 1));
  std::erase(name, '_');
  return name;
}

template <std::size_t n>
bool among(const std::string& name, const std::array<std::string_view, n>& names) {
  return std::find(names.begin(), names.end(), name) != names.end();
}

constexpr std::array<std::string_view, 11> rates{"fs",         "srate",        "sr",
                                                 "sfreq",      "samplerate",   "samplingrate",
                                                 "samplefreq", "samplingfreq", "samplingfrequency",
                                                 "rate",       "freq"};
constexpr std::array<std::string_view, 6> intervals{
    "dt", "ts", "isi", "sampleinterval", "samplinginterval", "deltat"};
constexpr std::array<std::string_view, 8> lists_of_names{
    "labels", "label", "titles", "names", "columns", "channels", "channelnames", "channellabels"};
constexpr std::array<std::string_view, 2> lists_of_units{"units", "unit"};

class MatlabRecording : public Recording {
 public:
  MatlabRecording(const std::filesystem::path& path, std::size_t block)
      : content_(read_mat_variables(path, most_values)) {
    source = path.string();
    word = "variable";
    if (const auto labchart = LabChartVariables::in(content_)) {
      add_labchart(*labchart, block);
      return;
    }
    if (block > 1) refuse_block(block, 1);
    const double rate = rate_hz();
    for (const MatVariable& v : content_.variables) add_channels(v);
    for (Channel& channel : channels) channel.rate_hz = rate;
    shorten_names();
    if (channels.empty()) refuse_empty();
    if (content_.has_objects)
      if_missing = "the file also holds objects such as a MATLAB table, which writetable exports";
  }

  Samples read(std::span<const std::size_t> chosen) override {
    Samples samples;
    for (const std::size_t channel : chosen) samples.values.push_back(slices_[channel].values());
    for (std::size_t i = 1; i < chosen.size(); ++i)
      if (samples.values[i].size() != samples.values[0].size())
        throw InputError(
            {source},
            fmt::format("{} values found in variable '{}' and {} in '{}'", samples.values[0].size(),
                        channels[chosen[0]].name, samples.values[i].size(), channels[chosen[i]].name),
            "equal numbers of values", "choose other variables");
    return samples;
  }

 private:
  /// One row or column of a variable.
  struct Slice {
    const MatVariable* variable;
    std::size_t first, stride, count;
    std::vector<double> values() const {
      std::vector<double> values(count);
      for (std::size_t i = 0; i < count; ++i) values[i] = variable->values[first + i * stride];
      return values;
    }
  };

  [[noreturn]] void refuse_empty() const {
    if (content_.has_objects)
      throw InputError({source}, "a MATLAB table, timetable or other object, which only MATLAB reads",
                       "vectors or a struct",
                       "in MATLAB, export it with writetable(T, 'recording.csv'), and a timetable with "
                       "writetimetable");
    throw InputError({source}, "no vector of numbers found", "variables such as time_s and flow_L_s");
  }

  [[noreturn]] void refuse_block(std::size_t block, std::size_t blocks) const {
    throw InputError({fmt::format("--block {}", block)},
                     fmt::format("{} has {} block{}", source, blocks, blocks == 1 ? "" : "s"),
                     "the number of a block of LabChart, from 1");
  }

  void add_labchart(const LabChartVariables& labchart, std::size_t block) {
    const std::size_t blocks = labchart.blocks();
    if (block > blocks) refuse_block(block, blocks);
    std::size_t chosen = block > 0 ? block - 1 : 0;
    for (std::size_t i = 0; block == 0 && i < blocks; ++i)
      if (labchart.length_s(i) > labchart.length_s(chosen)) chosen = i;
    if (block == 0 && blocks > 1)
      notes.push_back(fmt::format(
          "the file has {} blocks: block {}, the longest, is read, of {} s (--block {} reads another)",
          blocks, chosen + 1, number_text(labchart.length_s(chosen)), chosen == 0 ? 2 : 1));
    for (const auto& channel : labchart.channels(chosen))
      if (channel.count >= 2 && channel.count <= max_samples)
        add({channel.name, channel.unit, channel.rate_hz, channel.count},
            {&labchart.data(), channel.first, 1, channel.count});
    if (channels.empty()) refuse_empty();
  }

  double rate_hz() const {
    double found = 0;
    for (const MatVariable& v : content_.variables) {
      if (v.values.size() != 1 || !(v.values[0] > 0) || !std::isfinite(v.values[0])) continue;
      const std::string name = own_name(v);
      const double rate = among(name, rates)       ? v.values[0]
                          : among(name, intervals) ? 1 / (v.values[0] * interval_unit())
                                                   : 0;
      if (rate == 0) continue;
      if (found > 0 && std::abs(rate / found - 1) > 1e-6)
        throw InputError({source},
                         fmt::format("two sampling rates found, the second in variable '{}'", v.name),
                         "one rate", "give a vector of times, or save only the signal");
      found = rate;
    }
    return found;
  }

  double interval_unit() const {
    const MatVariable* unit = text_named("isiunits");
    return unit && unit->texts.front() == "ms" ? 1e-3 : 1;
  }

  const MatVariable* text_named(const std::string& own) const {
    for (const MatVariable& v : content_.variables)
      if (!v.texts.empty() && own_name(v) == own) return &v;
    return nullptr;
  }

  /// Returns the text for column i of a matrix of `width` columns from a list of texts; "" if there is no
  /// such list.
  template <std::size_t n>
  std::string entry(const std::array<std::string_view, n>& names, std::size_t i, std::size_t width) const {
    for (const MatVariable& v : content_.variables)
      if (v.texts.size() == width && among(own_name(v), names)) return v.texts[i];
    return "";
  }

  void add_channels(const MatVariable& v) {
    const std::size_t length = std::max(v.rows, v.columns), width = std::min(v.rows, v.columns);
    if (length < 2 || length > max_samples || width == 0 || width > most_columns) return;
    if (width == 1) return add({v.name, unit_of(v), 0, length}, {&v, 0, 1, length});
    const bool in_columns = v.rows >= v.columns;
    for (std::size_t i = 0; i < width; ++i) {
      std::string name = entry(lists_of_names, i, width);
      if (name.empty())
        name =
            v.name + (in_columns ? "(:," + std::to_string(i + 1) + ")" : "(" + std::to_string(i + 1) + ",:)");
      add({name, entry(lists_of_units, i, width), 0, length},
          {&v, in_columns ? i * v.rows : i, in_columns ? 1 : v.rows, length});
    }
  }

  std::string unit_of(const MatVariable& v) const {
    for (const std::string ending : {"units", "unit"})
      if (const MatVariable* text = text_named(own_name(v) + ending)) return text->texts.front();
    return "";
  }

  void add(Channel channel, Slice slice) {
    channels.push_back(std::move(channel));
    slices_.push_back(slice);
  }

  /// Shortens "rec.flow" to "flow" if no other channel has this name.
  void shorten_names() {
    std::map<std::string, int> count;
    const auto last_part = [](const std::string& name) { return name.substr(name.find_last_of('.') + 1); };
    for (const Channel& channel : channels) ++count[last_part(channel.name)];
    for (Channel& channel : channels)
      if (count[last_part(channel.name)] == 1) channel.name = last_part(channel.name);
  }

  MatContent content_;
  std::vector<Slice> slices_;  // [channels]
};

}  // namespace

bool is_matlab(std::string_view start) {
  return start.size() >= 128 &&
         (start.starts_with("MATLAB 5.0 MAT-file") || start.starts_with("MATLAB 7.0 MAT-file") ||
          start.starts_with("MATLAB 7.3 MAT-file"));
}

std::unique_ptr<Recording> open_matlab(const std::filesystem::path& path, std::size_t block) {
  return std::make_unique<MatlabRecording>(path, block);
}

}  // namespace trunk
