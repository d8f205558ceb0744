#pragma once

#include "validation/bounds.hpp"

namespace trunk {

/// A row of the printed table, and what it is called.
struct Table1Source {
  const char* name;   // in JSON
  const char* title;  // in text
  const Table1Row* row;
};

/// The experiment, the published model, and ours of either kind; rows of `findings`, which must outlive them.
std::vector<Table1Source> table1_rows(const ValidationRun& findings);

/// The whole report as text: Table 1 with errors, the breaths, the bounds.
std::string validation_text(const ValidationRun& findings, std::span<const Judged> results);

}  // namespace trunk
