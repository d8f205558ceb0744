#include "recordings/text_recording.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cctype>
#include <limits>
#include <optional>

#include "tables/acqknowledge_layout.hpp"
#include "tables/clock_time.hpp"
#include "tables/column_names.hpp"
#include "tables/delimited_text.hpp"
#include "tables/labchart_layout.hpp"
#include "text/message_text.hpp"

namespace trunk {
namespace {

constexpr std::size_t most_flaws = 10'000;

// Returns the layout of a text according to the program that wrote it.
TableLayout layout_of(const TextLines& lines, std::size_t block) {
  if (is_labchart(lines)) return labchart_layout(lines, block);
  if (block > 1)
    throw InputError({fmt::format("--block {}", block)},
                     fmt::format("{} is not divided into blocks", lines.source()),
                     "a text of LabChart or an EDF+ file with interruptions", "leave this option out");
  return is_acqknowledge(lines) ? acqknowledge_layout(lines) : table_layout(lines);
}

// Gathers the comments at the ends of rows.
class Comments {
 public:
  void add(const DelimitedText::Row& row) {
    if (row.comment.empty() || ++count_ > most_shown) return;
    std::string_view text = row.comment.substr(1);
    if (text.starts_with('*')) text.remove_prefix(1);  // LabChart: it concerns all channels
    shown_ += fmt::format("{}{} in line {}", count_ > 1 ? ", " : "", excerpt(trimmed(text)), row.line);
  }
  std::string note() const {
    if (count_ == 0) return "";
    const std::string more = count_ > most_shown ? fmt::format(", and {} more", count_ - most_shown) : "";
    return fmt::format("{} comment{} in the file: {}{}", count_, count_ == 1 ? "" : "s", shown_, more);
  }

 private:
  static constexpr std::size_t most_shown = 5;
  std::size_t count_ = 0;
  std::string shown_;
};

class TextRecording : public Recording {
 public:
  TextRecording(std::string file, std::string text, std::size_t block)
      : table_(std::move(file), std::move(text),
               [block](const TextLines& lines) { return layout_of(lines, block); }) {
    source = table_.source();
    header_line = table_.header_line();
    notes = table_.notes();
    for (std::size_t i = 0; i < table_.names().size(); ++i)
      channels.push_back(
          {table_.names()[i], table_.units().empty() ? "" : table_.units()[i], table_.rate_hz(), 0, false});
    look_at_first_rows();
  }

  Samples read(std::span<const std::size_t> chosen) override {
    Samples samples;
    samples.values.resize(chosen.size());
    std::vector<std::vector<std::optional<ClockTime>>> clocks(chosen.size());
    DelimitedText::Row row;
    Comments comments;
    for (table_.rewind(); table_.next(row);) {
      refuse_other_header(row);
      comments.add(row);
      samples.lines.push_back(static_cast<std::uint32_t>(row.line));
      for (std::size_t i = 0; i < chosen.size(); ++i) {
        const auto flaw = [&](const InputError& error) { add_flaw(samples, error); };
        if (is_clock_[chosen[i]])
          clocks[i].push_back(
              read_or([&] { return std::optional(clock(row, chosen[i])); }, std::nullopt, flaw));
        else
          samples.values[i].push_back(
              read_or([&] { return table_.number(row, chosen[i]); }, no_number, flaw));
      }
    }
    for (std::size_t i = 0; i < chosen.size(); ++i)
      if (is_clock_[chosen[i]]) samples.values[i] = seconds_since_first(clocks[i]);
    if (const std::string note = comments.note(); !note.empty() && !has_read_) notes.push_back(note);
    has_read_ = true;
    return samples;
  }

 private:
  static constexpr double no_number = std::numeric_limits<double>::quiet_NaN();

  template <class Read, class T, class Flaw>
  static auto read_or(Read&& read, T without, Flaw&& flaw) -> decltype(read()) {
    try {
      return read();
    } catch (const InputError& error) {
      flaw(error);
      return without;
    }
  }

  static void add_flaw(Samples& samples, const InputError& error) {
    const std::size_t sample = samples.lines.size() - 1;
    if (samples.flaws.empty() || samples.flaws.back().sample != sample)
      samples.flaws.push_back({sample, error.mistake()});
    if (samples.flaws.size() > most_flaws) throw InputError(samples.flaws.front().mistake);
  }

  // Throws if a row names columns or units, and not as the header does: what follows may be something else. A
  // header that is repeated, as on each page of a report, is a row without numbers like others.
  void refuse_other_header(const DelimitedText::Row& row) const {
    std::size_t known = 0, other = 0, texts = 0;
    for (std::size_t i = 0; i < row.cells.size(); ++i) {
      const std::string_view cell = row.cells[i];
      if (cell.empty()) continue;
      if (!starts_like_a_name(cell)) return;
      const ColumnName name = column_name(cell);
      known += name.quantity != Quantity::unknown || role_of(name) ? 1 : 0;
      other += cell != table_.names()[i] && (table_.units().empty() || cell != table_.units()[i]) ? 1 : 0;
      ++texts;
    }
    if (texts < std::min<std::size_t>(2, channels.size()) || known == 0 || other == 0) return;
    throw InputError({source, row.line},
                     fmt::format("a second header, {}, after the first rows", excerpt(row.cells[0])),
                     "one table, in which names and units hold to its end",
                     "give the rows before and after it as files of their own");
  }

  static bool starts_like_a_name(std::string_view cell) {
    const auto byte = static_cast<unsigned char>(cell.front());
    return byte >= 0x80 || std::isalpha(byte) || cell.front() == '(' || cell.front() == '[';
  }

  ClockTime clock(const DelimitedText::Row& row, std::size_t column) const {
    const std::string_view cell = table_.text(row, column);
    if (const auto time = clock_time(cell)) return *time;
    throw InputError({source, row.line},
                     fmt::format("{} found in column {}", excerpt(cell), excerpt(channels[column].name)),
                     "a time such as 14:05:07.25", "correct or remove the row");
  }

  // Finds columns of clock times by their first filled cell within the first hundred rows.
  void look_at_first_rows() {
    is_clock_.assign(channels.size(), false);
    std::vector<bool> seen(channels.size(), false);
    DelimitedText::Row row;
    try {
      for (int i = 0; i < 100 && table_.next(row); ++i) {
        for (std::size_t column = 0; column < row.cells.size(); ++column) {
          if (seen[column] || row.cells[column].empty()) continue;
          seen[column] = true;
          if (first_cell.empty() && !table_.named()) first_cell = row.cells[column];
          is_clock_[column] = clock_time(row.cells[column]).has_value();
          channels[column].is_clock = is_clock_[column];
          if (is_clock_[column]) channels[column].unit = "s";
        }
      }
    } catch (const InputError&) {  // it is thrown again when the samples are read
    }
  }

  DelimitedText table_;
  std::vector<bool> is_clock_;  // [channels]
  bool has_read_ = false;
};

}  // namespace

std::unique_ptr<Recording> recording_of_text(std::string source, std::string text, std::size_t block) {
  return std::make_unique<TextRecording>(std::move(source), std::move(text), block);
}

}  // namespace trunk
