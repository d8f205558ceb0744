#pragma once

#include <cmath>
#include <functional>
#include <string>
#include <vector>

namespace trunk::test {

struct EdfChannel {
  std::string label, unit;
  int rate_hz;
  double most;  ///< physical range: -most to most
  std::function<double(int)> value;
};

/// An EDF file of records of one second, or a BDF file; written from the specification (edfplus.info). With
/// `starts`, one for each record, it is an EDF+D or BDF+D file, whose records say when they begin.
inline std::string edf_bytes(std::vector<EdfChannel> channels, int records, bool bdf = false,
                             const std::vector<std::string>& starts = {}) {
  constexpr int samples_of_annotations = 15;
  if (!starts.empty())
    channels.push_back({bdf ? "BDF Annotations" : "EDF Annotations", "", samples_of_annotations, 1, {}});
  const auto field = [](std::string text, std::size_t width) {
    text.resize(width, ' ');
    return text;
  };
  const int highest = bdf ? 8388607 : 32767;
  const std::size_t bytes_a_sample = bdf ? 3 : 2;
  std::string file = bdf ? "\xFF"
                           "BIOSEMI"
                         : field("0", 8);
  file += field("X X X X", 80) + field("Startdate 01-JAN-2024 X X X", 80) + "01.01.2408.00.00";
  file += field(std::to_string(256 * (channels.size() + 1)), 8) +
          field(starts.empty() ? ""
                : bdf          ? "BDF+D"
                               : "EDF+D",
                44) +
          field(std::to_string(records), 8) + field("1", 8) + field(std::to_string(channels.size()), 4);
  const auto for_all = [&](std::size_t width, auto&& text) {
    for (const EdfChannel& c : channels) file += field(text(c), width);
  };
  const auto whole = [](double x) { return std::to_string(static_cast<int>(x)); };
  for_all(16, [](const auto& c) { return c.label; });
  for_all(80, [](const auto&) { return ""; });
  for_all(8, [](const auto& c) { return c.unit; });
  for_all(8, [&](const auto& c) { return whole(-c.most); });
  for_all(8, [&](const auto& c) { return whole(c.most); });
  for_all(8, [&](const auto& c) { return std::to_string(-highest - (c.value ? 0 : 1)); });
  for_all(8, [&](const auto&) { return std::to_string(highest); });
  for_all(80, [](const auto&) { return ""; });
  for_all(8, [](const auto& c) { return std::to_string(c.rate_hz); });
  for_all(32, [](const auto&) { return ""; });
  for (int record = 0; record < records; ++record)
    for (const EdfChannel& c : channels) {
      if (!c.value) {
        std::string text = starts[static_cast<std::size_t>(record)] + "\x14\x14";
        text.resize(bytes_a_sample * samples_of_annotations, '\0');
        file += text;
        continue;
      }
      for (int i = record * c.rate_hz; i < (record + 1) * c.rate_hz; ++i) {
        const auto digital = static_cast<unsigned>(std::lround(c.value(i) / c.most * highest));
        for (std::size_t byte = 0; byte < bytes_a_sample; ++byte)
          file += static_cast<char>(digital >> (8 * byte) & 0xFF);
      }
    }
  return file;
}

}  // namespace trunk::test
