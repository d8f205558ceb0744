#pragma once

#include "validation/bounds.hpp"

namespace trunk {

/// A row of the printed table, with its names.
struct Table1Source {
  const char* name;   // in JSON
  const char* title;  // in text
  const Table1Row* row;
};

/// Returns the rows of the experiment, the published model, and our models. They point into `findings`, which
/// must outlive them.
std::vector<Table1Source> table1_rows(const ValidationRun& findings);

/// Returns the whole report as text: Table 1 with errors, the breaths, the bounds.
std::string validation_text(const ValidationRun& findings, std::span<const Judged> results);

}  // namespace trunk
