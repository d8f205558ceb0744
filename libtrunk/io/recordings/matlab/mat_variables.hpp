#pragma once

#include <filesystem>
#include <string>
#include <vector>

namespace trunk {

/// A variable of a MAT-file, or a field of a struct: a real matrix, or rows of text.
struct MatVariable {
  std::string name;  ///< "rec.flow"; elements of a struct array as "rec(2).flow"
  std::size_t rows = 0, columns = 0;
  std::vector<double> values;      ///< [columns][rows], as MATLAB keeps them
  std::vector<std::string> texts;  ///< of a char matrix or a cell of chars; then rows is 0
};

struct MatContent {
  std::vector<MatVariable> variables;
  bool has_objects = false;  ///< tables, timetables, strings and other objects, which no library reads
};

/// Everything numeric or text in a MAT-file (versions 4, 5, 7 and 7.3): structs three deep; complex, sparse
/// and more-dimensional arrays are left out. At most `most_values` numbers. The only user of libmatio, in a
/// process of its own: on damaged headers the library crashes (33 of 2500 trials with flipped bytes) or asks
/// for any amount of memory. Throws InputError where it fails.
MatContent read_mat_variables(const std::filesystem::path& path, std::size_t most_values);

}  // namespace trunk
