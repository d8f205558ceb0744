#pragma once

#include <fmt/format.h>

#include <optional>
#include <string>
#include <vector>

#include "recordings/recording.hpp"
#include "tables/column_names.hpp"
#include "text/message_text.hpp"

namespace trunk {

/// Finds columns of a recording by what they are called. It refers to what it is given.
class ColumnFinder {
 public:
  ColumnFinder(const Recording& recording, const std::vector<ColumnName>& columns)
      : recording_(recording), columns_(columns) {}

  /// Returns the only column for which `wanted` holds, if there is one. Throws InputError if there are two,
  /// since a silent choice may be wrong.
  template <class Predicate>
  std::optional<std::size_t> only(Predicate wanted, const std::string& options) const {
    std::optional<std::size_t> found;
    for (std::size_t i = 0; i < columns_.size(); ++i) {
      if (!wanted(columns_[i])) continue;
      if (found)
        fail(fmt::format("two {}s have the same meaning, {} and {}", recording_.word,
                         excerpt(columns_[*found].text), excerpt(columns_[i].text)),
             "one", "choose one with " + options);
      found = i;
    }
    return found;
  }

  /// Returns the column of this name, of this name without its unit, or of this number from 1. Throws
  /// InputError if there is none.
  std::size_t by_name(const std::string& name, const std::string& options) const;

  /// Returns "column 'flow'".
  std::string word_and_name(std::size_t column) const;

  /// Returns a note about the factor in the unit of a column, or "".
  std::string note_of_factor(std::size_t column, const std::string& unit) const;

  /// Throws an error about the header.
  [[noreturn]] void fail(std::string found, std::string expected, std::string remedy) const;

 private:
  const Recording& recording_;
  const std::vector<ColumnName>& columns_;
};

}  // namespace trunk
