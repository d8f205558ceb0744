#include "recordings/matlab/mat_variables.hpp"

#include <fmt/format.h>
#include <matio.h>

#include <algorithm>
#include <cstdint>
#include <filesystem>
#include <memory>
#include <stdexcept>

#include "errors/input_error.hpp"
#include "recordings/matlab/apart.hpp"
#include "recordings/matlab/packing.hpp"
#include "recordings/matlab/require_whole.hpp"

namespace trunk {
namespace {

constexpr int deepest = 3;
constexpr std::size_t most_elements = 200;    // of a struct array
constexpr std::size_t most_variables = 5000;  // fields included
constexpr std::size_t longest_text = 200, most_texts = 1000;

class Collector {
 public:
  Collector(MatContent& content, std::size_t most_values) : content_(content), left_(most_values) {}

  // The bytes of all objects of a file are one more variable, without a name of its own.
  void add_top(const matvar_t& v) {
    const std::string name = v.name ? v.name : "";
    if (name.empty() || name.starts_with('#') || name.starts_with("__"))
      content_.has_objects = true;
    else
      add(v, name, 1);
  }

  void add(const matvar_t& v, const std::string& name, int depth) {
    if (content_.variables.size() >= most_variables || depth > deepest) return;
    if (v.class_type == MAT_C_STRUCT) return add_fields(v, name, depth);
    // In version 7.3, libmatio calls a class that it does not know an empty one.
    if (v.class_type == MAT_C_OPAQUE || v.class_type == MAT_C_OBJECT || v.class_type == MAT_C_EMPTY)
      content_.has_objects = true;
    if (v.rank != 2 || !v.dims || !v.data || v.isComplex) return;
    if (v.class_type == MAT_C_CELL) return add_texts(name, cell_texts(v));
    if (v.class_type == MAT_C_CHAR) return add_texts(name, char_rows(v));
    if (v.class_type >= MAT_C_DOUBLE && v.class_type <= MAT_C_UINT64) add_matrix(v, name);
  }

 private:
  /// Returns the number of elements if the data hold as many of `size` bytes; otherwise 0.
  static std::size_t elements(const matvar_t& v, std::size_t size) {
    std::size_t count = 0;
    if (size == 0 || __builtin_mul_overflow(v.dims[0], v.dims[1], &count)) return 0;
    return count <= v.nbytes / size ? count : 0;
  }

  void add_fields(const matvar_t& v, const std::string& name, int depth) {
    const std::size_t fields = Mat_VarGetNumberOfFields(const_cast<matvar_t*>(&v));
    char* const* names = Mat_VarGetStructFieldnames(&v);
    if (fields == 0 || !names || v.rank != 2 || !v.dims) return;
    std::size_t all = 0;
    if (__builtin_mul_overflow(v.dims[0], v.dims[1], &all)) return;
    for (std::size_t element = 0; element < std::min(all, most_elements); ++element)
      for (std::size_t field = 0; field < fields; ++field) {
        const matvar_t* f = Mat_VarGetStructFieldByIndex(const_cast<matvar_t*>(&v), field, element);
        const std::string index = all > 1 ? "(" + std::to_string(element + 1) + ")" : "";
        if (f && names[field]) add(*f, name + index + "." + names[field], depth + 1);
      }
  }

  template <class T>
  void take(const matvar_t& v, const std::string& name) {
    const std::size_t count = elements(v, sizeof(T));
    if (count == 0) return;
    if (count > left_) throw std::runtime_error("too many numbers");
    left_ -= count;
    MatVariable variable{name, v.dims[0], v.dims[1], std::vector<double>(count), {}};
    const auto* data = static_cast<const T*>(v.data);
    std::transform(data, data + count, variable.values.begin(), [](T x) { return static_cast<double>(x); });
    content_.variables.push_back(std::move(variable));
  }

  void add_matrix(const matvar_t& v, const std::string& name) {
    switch (v.class_type) {
      case MAT_C_DOUBLE:
        return take<double>(v, name);
      case MAT_C_SINGLE:
        return take<float>(v, name);
      case MAT_C_INT8:
        return take<std::int8_t>(v, name);
      case MAT_C_UINT8:
        return take<std::uint8_t>(v, name);
      case MAT_C_INT16:
        return take<std::int16_t>(v, name);
      case MAT_C_UINT16:
        return take<std::uint16_t>(v, name);
      case MAT_C_INT32:
        return take<std::int32_t>(v, name);
      case MAT_C_UINT32:
        return take<std::uint32_t>(v, name);
      case MAT_C_INT64:
        return take<std::int64_t>(v, name);
      default:
        return take<std::uint64_t>(v, name);
    }
  }

  /// Returns the texts of a char matrix, one per row; characters that are not ASCII become '?'.
  static std::vector<std::string> char_rows(const matvar_t& v) {
    const std::size_t size = Mat_SizeOf(v.data_type);
    if ((size != 1 && size != 2) || elements(v, size) == 0) return {};
    std::vector<std::string> texts(std::min(v.dims[0], most_texts));
    const auto* data = static_cast<const unsigned char*>(v.data);
    for (std::size_t row = 0; row < texts.size(); ++row) {
      for (std::size_t column = 0; column < std::min(v.dims[1], longest_text); ++column) {
        const unsigned char* at = data + size * (column * v.dims[0] + row);
        const unsigned code = size == 1 ? at[0] : static_cast<unsigned>(at[0] | at[1] << 8);
        texts[row] += code >= 0x20 && code < 0x7F ? static_cast<char>(code) : '?';
      }
      texts[row].erase(texts[row].find_last_not_of(' ') + 1);
    }
    return texts;
  }

  static std::vector<std::string> cell_texts(const matvar_t& v) {
    std::vector<std::string> texts;
    const std::size_t count = std::min(elements(v, sizeof(matvar_t*)), most_texts);
    for (std::size_t i = 0; i < count; ++i) {
      const matvar_t* cell = static_cast<matvar_t* const*>(v.data)[i];
      if (!cell || cell->class_type != MAT_C_CHAR || cell->rank != 2 || !cell->dims || !cell->data) return {};
      const auto rows = char_rows(*cell);
      texts.push_back(rows.empty() ? "" : rows.front());
    }
    return texts;
  }

  void add_texts(const std::string& name, std::vector<std::string> texts) {
    if (!texts.empty()) content_.variables.push_back({name, 0, 0, {}, std::move(texts)});
  }

  MatContent& content_;
  std::size_t left_;
};

std::string read_packed(const std::string& path, std::size_t most_values) {
  struct Close {
    void operator()(mat_t* file) const { Mat_Close(file); }
    void operator()(matvar_t* variable) const { Mat_VarFree(variable); }
  };
  const std::unique_ptr<mat_t, Close> file(Mat_Open(path.c_str(), MAT_ACC_RDONLY));
  if (!file) throw std::runtime_error("not a MAT-file");
  MatContent content;
  Collector collector(content, most_values);
  std::size_t count = 0;
  while (count++ < most_variables) {
    const std::unique_ptr<matvar_t, Close> variable(Mat_VarReadNext(file.get()));
    if (!variable) break;
    collector.add_top(*variable);
  }
  return packed(content);
}

}  // namespace

MatContent read_mat_variables(const std::filesystem::path& path, std::size_t most_values) {
  const std::string name = path.string();
  require_whole(path, sizeof(double) * most_values + (std::size_t{64} << 20));
  const auto bytes = run_apart([&] { return read_packed(name, most_values); },
                               sizeof(double) * most_values + (std::size_t{64} << 20));
  if (!bytes)
    throw InputError({name},
                     fmt::format("the MAT-file is damaged, or holds more than {} million numbers",
                                 most_values / 1'000'000),
                     "a whole and smaller file", "save only the signals again");
  return unpacked(*bytes);
}

}  // namespace trunk
