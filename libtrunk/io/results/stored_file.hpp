#pragma once

#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <functional>
#include <string>
#include <vector>

namespace trunk {

/// An array of numbers as a results file holds it.
struct StoredArray {
  std::string unit, meaning;       ///< attributes `units` and `long_name`; "" where there are none
  std::vector<std::size_t> shape;  ///< empty for a single number
  std::vector<double> values;      ///< row-major
};

/// An open results file, read a path at a time ("curves/dV_model"). What is not there is empty, what is there
/// but damaged, of another type or larger than `most_values` is an InputError that names the file.
class StoredFile {
 public:
  static constexpr std::size_t most_values = 100'000'000;

  StoredFile(std::int64_t root, std::string kind) : root_(root), kind_(std::move(kind)) {}

  const std::string& kind() const { return kind_; }  ///< "run", "fit" or "sweep"
  bool has(const std::string& path) const;
  StoredArray array(const std::string& path) const;
  std::vector<std::string> texts(const std::string& path) const;
  std::string text(const std::string& path) const;
  /// Of a group or dataset; "" is the file itself.
  std::string attribute(const std::string& path, const std::string& name) const;
  std::vector<std::string> attributes(const std::string& path) const;
  /// What the codes 0, 1 … of a dataset mean.
  std::vector<std::string> code_names(const std::string& path) const;
  /// Names in a group, in the order written.
  std::vector<std::string> groups(const std::string& path) const;
  std::vector<std::string> datasets(const std::string& path) const;

 private:
  std::vector<std::string> members(const std::string& path, int kind) const;

  std::int64_t root_;
  std::string kind_;
};

/// Opens a finished results file for `use`. Throws InputError as reading does: missing, foreign, unfinished,
/// damaged.
void read_stored(const std::filesystem::path& path, const std::function<void(const StoredFile&)>& use);

}  // namespace trunk
