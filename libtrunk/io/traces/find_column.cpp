#include "traces/find_column.hpp"

#include <charconv>

namespace trunk {

std::size_t ColumnFinder::by_name(const std::string& name, const std::string& options) const {
  for (std::size_t i = 0; i < columns_.size(); ++i)
    if (columns_[i].text == name) return i;
  const std::string plain = column_name(name).plain;
  if (const auto found = only([&](const ColumnName& c) { return c.plain == plain; }, options)) return *found;
  if (const auto found = only([&](const ColumnName& c) { return c.base == plain; }, options)) return *found;
  std::size_t number = 0;
  const auto [end, error] = std::from_chars(name.data(), name.data() + name.size(), number);
  if (error == std::errc{} && end == name.data() + name.size() && number >= 1 && number <= columns_.size())
    return number - 1;
  fail(fmt::format("no {} {} among {}", recording_.word, excerpt(name), list_of(columns_)),
       fmt::format("the chosen {}", recording_.word),
       "correct its name or give its number" +
           (recording_.if_missing.empty() ? "" : "; " + recording_.if_missing));
}

std::string ColumnFinder::word_and_name(std::size_t column) const {
  return fmt::format("{} {}", recording_.word, excerpt(columns_[column].text));
}

std::string ColumnFinder::note_of_factor(std::size_t column, const std::string& unit) const {
  const auto space = unit.find(' ');
  if (space == std::string::npos) return "";
  return fmt::format("one in {} is {}, as its unit says", word_and_name(column), spoken_unit(unit));
}

void ColumnFinder::fail(std::string found, std::string expected, std::string remedy) const {
  throw InputError({recording_.source, recording_.header_line}, std::move(found), std::move(expected),
                   std::move(remedy));
}

}  // namespace trunk
