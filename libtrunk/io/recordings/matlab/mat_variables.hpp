#pragma once

#include <filesystem>
#include <string>
#include <vector>

namespace trunk {

/// A variable of a MAT-file, or a field of a struct: a real matrix, or rows of text.
struct MatVariable {
  std::string name;  ///< "rec.flow"; "rec(2).flow" in a struct array
  std::size_t rows = 0, columns = 0;
  std::vector<double> values;      ///< [columns][rows], the order of MATLAB
  std::vector<std::string> texts;  ///< of a char matrix or a cell of chars, for which rows is 0
};

struct MatContent {
  std::vector<MatVariable> variables;
  /// The file has tables, strings or other objects, which no library reads. They are no variables here.
  bool has_objects = false;
};

/// Returns the numbers and texts of a MAT-file (versions 4, 5, 7 and 7.3), at most `most_values` numbers.
/// Structs are read to a depth of three. Complex, sparse and more-dimensional arrays are ignored. Throws
/// InputError if the file is damaged or too large.
///
/// This is the only user of libmatio. It runs in its own process, because the library crashes on damaged
/// headers (33 of 2500 trials with flipped bytes) or requests any amount of memory.
MatContent read_mat_variables(const std::filesystem::path& path, std::size_t most_values);

}  // namespace trunk
