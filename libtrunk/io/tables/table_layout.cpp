#include "tables/table_layout.hpp"

#include <algorithm>
#include <cctype>
#include <optional>

#include "errors/input_error.hpp"
#include "tables/clock_time.hpp"
#include "tables/column_names.hpp"

namespace trunk {
namespace {

constexpr std::size_t longest_preamble = 20'000;  // lines
constexpr std::size_t farthest_header = 30;       // lines above the numbers

using Cells = std::vector<std::string_view>;

bool is_numeric(std::string_view cell, char delimiter) {
  return cell_number(cell, delimiter != ',').second == std::errc{} || clock_time(cell);
}

bool any_numeric(const Cells& cells, char delimiter) {
  return std::any_of(cells.begin(), cells.end(), [&](auto cell) { return is_numeric(cell, delimiter); });
}

// A text such as "0.01 s" is not a name.
bool any_starts_with_digit(const Cells& cells) {
  return std::any_of(cells.begin(), cells.end(),
                     [](auto cell) { return !cell.empty() && cell.front() >= '0' && cell.front() <= '9'; });
}

bool has_letter(const Cells& cells) {
  return std::any_of(cells.begin(), cells.end(), [](std::string_view cell) {
    return std::any_of(cell.begin(), cell.end(), [](char c) {
      const auto byte = static_cast<unsigned char>(c);
      return byte >= 0x80 || std::isalpha(byte);
    });
  });
}

bool names_a_quantity(const Cells& cells) {
  return std::any_of(cells.begin(), cells.end(), [](std::string_view cell) {
    const ColumnName name = column_name(cell);
    return name.quantity != Quantity::unknown || role_of(name);
  });
}

bool is_units_row(const Cells& cells, char delimiter) {
  return !any_numeric(cells, delimiter) &&
         std::any_of(cells.begin(), cells.end(), [](auto cell) { return unit_of(cell).has_value(); });
}

// Returns a cell with a space for every line break in it.
std::string on_one_line(std::string_view cell) {
  std::string text;
  for (const char c : cell) {
    if (c != '\r' && c != '\n')
      text += c;
    else if (!text.empty() && text.back() != ' ')
      text += ' ';
  }
  return text;
}

// If spaces separate the cells, "Flow (L/s)" is two cells; the unit belongs to the name.
std::vector<std::string> joined_names(const Cells& cells, char delimiter) {
  std::vector<std::string> names;
  for (const std::string_view cell : cells) {
    const bool is_unit = delimiter == ' ' && (cell.starts_with('(') || cell.starts_with('['));
    if (is_unit && !names.empty())
      names.back() += " " + std::string(cell);
    else
      names.push_back(on_one_line(cell));
  }
  return names;
}

class LayoutFinder {
 public:
  explicit LayoutFinder(const TextLines& lines) : end_(lines) {}

  TableLayout find() {
    if (!has_line(0)) fail(0, "only blank lines and comments found", "a header line and rows of numbers");
    read_declaration();
    const std::optional<std::size_t> rows = first_rows();
    if (!rows) delimiter_ = declared_.value_or(guessed_delimiter(lines_[first_].text));
    if (!rows) return any_numeric(first_cell(), delimiter_) ? unnamed(first_) : below(first_, first_);
    if (const auto header = header_above(*rows)) return below(*header, *rows);
    if (const auto comment = cells_of(lines_[*rows].comment); names_a_quantity(comment)) {
      TableLayout layout = unnamed(*rows);
      layout.names = joined_names(comment, delimiter_);
      layout.named = true;
      return layout;
    }
    return unnamed(*rows);
  }

  TableLayout list() {
    if (!has_line(0)) fail(0, "only blank lines and comments found", "a header line and rows");
    read_declaration();
    delimiter_ = declared_.value_or(guessed_delimiter(lines_[first_].text));
    return headed(first_);
  }

 private:
  struct Line {
    std::string_view text, comment;  // the line, and the comment just above it
    TextLines before, after;         // the positions before and after it
  };

  // Lines are read when they are needed, because a few lines suffice for a table without preamble.
  bool has_line(std::size_t i) {
    while (lines_.size() <= i) {
      TextLines before = end_;
      std::string_view text;
      if (!end_.next(text)) return false;
      lines_.push_back({text, end_.comment_above(), before, end_});
    }
    return true;
  }

  [[noreturn]] void fail(std::size_t line, std::string found, std::string expected,
                         std::string remedy = "") const {
    throw InputError({end_.source(), line}, std::move(found), std::move(expected), std::move(remedy));
  }

  void read_declaration() {
    const std::string_view line = trimmed(lines_[0].text);
    if (line.size() != 5 || !line.starts_with("sep=")) return;
    declared_ = line[4];
    first_ = 1;
    if (!has_line(1)) fail(0, "only blank lines and comments found", "a header line and rows of numbers");
  }

  Cells cells_of(std::string_view line) const {
    Cells cells;
    split_cells(line, delimiter_, cells);
    return cells;
  }

  Cells first_cell() const {
    Cells cells = cells_of(lines_[first_].text);
    cells.resize(std::min<std::size_t>(cells.size(), 1));
    return cells;
  }

  static char guessed_delimiter(std::string_view header) {
    bool in_quotes = false, tab = false;
    for (const char c : header) {
      if (c == '"') in_quotes = !in_quotes;
      if (c == ';' && !in_quotes) return ';';
      tab = tab || (c == '\t' && !in_quotes);
    }
    return tab ? '\t' : ',';
  }

  // Returns the first of three lines (or of fewer at the end of the text) with numbers in two or more cells,
  // and sets delimiter_.
  std::optional<std::size_t> first_rows() {
    for (const char delimiter : declared_ ? std::string(1, *declared_) : std::string(";\t, ")) {
      delimiter_ = delimiter;
      std::size_t found = 0, first = 0;
      for (std::size_t i = first_; has_line(i) && i < first_ + longest_preamble && found < 3; ++i) {
        const Row row = row_at(i);
        if (row == Row::numbers && found++ == 0) first = i;
        if (row == Row::none) found = 0;
      }
      if (found > 0) return first;
    }
    return std::nullopt;
  }

  // A row with one number and otherwise empty cells tells nothing by itself.
  enum class Row { none, one_number, numbers };
  Row row_at(std::size_t i) const {
    std::size_t numbers = 0, others = 0;
    for (const auto cell : cells_of(lines_[i].text)) {
      const bool is_number = is_numeric(cell, delimiter_);
      numbers += is_number ? 1U : 0U;
      others += is_number || cell.empty() ? 0U : 1U;
      if (numbers == 2) return Row::numbers;
    }
    return numbers == 1 && others == 0 && delimiter_ != ' ' ? Row::one_number : Row::none;
  }

  bool can_be_header(const Cells& cells) const {
    return cells.size() >= 2 && has_letter(cells) && !any_numeric(cells, delimiter_) &&
           !any_starts_with_digit(cells);
  }

  // Returns the nearest line above the rows that names a quantity, or else the first line if it names one, or
  // else the line just above the rows (and their units) if it may be names.
  std::optional<std::size_t> header_above(std::size_t rows) const {
    std::optional<std::size_t> units, nearest;
    for (std::size_t i = rows; i > first_ && i + farthest_header > rows; --i) {
      const Cells cells = cells_of(lines_[i - 1].text);
      const bool has_units = is_units_row(cells, delimiter_);
      if (has_units && !units) {
        units = i - 1;
      } else if (can_be_header(cells)) {
        if (names_a_quantity(cells)) return i - 1;
        if (i == rows || (units && i == *units)) nearest = i - 1;
      }
    }
    const Cells first = cells_of(lines_[first_].text);
    if (rows > first_ && !any_numeric(first, delimiter_) && names_a_quantity(first)) return first_;
    return nearest ? nearest : units;
  }

  // Returns the layout of a table whose rows begin just below the header.
  TableLayout headed(std::size_t header) const {
    Cells cells;
    const std::size_t number = lines_[header].after.number();
    if (!split_cells(lines_[header].text, delimiter_, cells))
      fail(number, "a double quote is opened and not closed", "pairs of quotes", "close or remove it");
    if (cells.empty()) fail(number, "a line of empty cells found", "a header line that names the columns");
    return {delimiter_, number, true, joined_names(cells, delimiter_), {}, lines_[header].after, 0, {}};
  }

  // Returns the layout of a table with lines without numbers between header and rows; one of them may hold
  // units.
  TableLayout below(std::size_t header, std::size_t rows) {
    TableLayout layout = headed(header);
    Cells cells;
    for (std::size_t i = header + 1; i < header + farthest_header && has_line(i); ++i) {
      cells = cells_of(lines_[i].text);
      if (any_numeric(cells, delimiter_)) break;
      if (i < rows) layout.rows = lines_[i].after;
      if (!layout.units.empty() || cells.size() > layout.names.size() || !is_units_row(cells, delimiter_))
        continue;
      layout.rows = lines_[i].after;
      layout.units.assign(cells.begin(), cells.end());
      layout.units.resize(layout.names.size());
    }
    return layout;
  }

  TableLayout unnamed(std::size_t rows) const {
    TableLayout layout{delimiter_, lines_[rows].after.number(), false, {}, {}, lines_[rows].before, 0, {}};
    for (std::size_t i = 1; i <= cells_of(lines_[rows].text).size(); ++i)
      layout.names.push_back(std::to_string(i));
    return layout;
  }

  TextLines end_;
  std::vector<Line> lines_;
  std::size_t first_ = 0;  // 1 if the first line declares the delimiter
  std::optional<char> declared_;
  char delimiter_ = ',';
};

}  // namespace

TableLayout table_layout(const TextLines& lines) {
  return LayoutFinder(lines).find();
}

TableLayout list_layout(const TextLines& lines) {
  return LayoutFinder(lines).list();
}

}  // namespace trunk
