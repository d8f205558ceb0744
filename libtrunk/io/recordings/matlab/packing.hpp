#pragma once

#include <cstdint>
#include <cstring>
#include <stdexcept>
#include <string>
#include <string_view>

#include "recordings/matlab/mat_variables.hpp"

namespace trunk {

/// Returns the content of a MAT-file as bytes, for another process on the same machine.
inline std::string packed(const MatContent& content) {
  std::string bytes;
  const auto number = [&](std::uint64_t n) { bytes.append(reinterpret_cast<const char*>(&n), sizeof n); };
  const auto text = [&](const std::string& t) {
    number(t.size());
    bytes += t;
  };
  number(content.has_objects ? 1 : 0);
  number(content.variables.size());
  for (const MatVariable& v : content.variables) {
    text(v.name);
    number(v.rows);
    number(v.columns);
    number(v.values.size());
    bytes.append(reinterpret_cast<const char*>(v.values.data()), v.values.size() * sizeof(double));
    number(v.texts.size());
    for (const std::string& t : v.texts) text(t);
  }
  return bytes;
}

/// Returns the content of bytes from packed(). A crash may have damaged them: throws std::runtime_error if
/// they end too early.
inline MatContent unpacked(std::string_view bytes) {
  const auto take = [&](std::size_t count) {
    if (count > bytes.size()) throw std::runtime_error("the reader of MAT-files ended half way");
    const std::string_view taken = bytes.substr(0, count);
    bytes.remove_prefix(count);
    return taken;
  };
  const auto number = [&] {
    std::uint64_t n;
    std::memcpy(&n, take(sizeof n).data(), sizeof n);
    return n;
  };
  const auto text = [&] { return std::string(take(number())); };
  MatContent content;
  content.has_objects = number() != 0;
  for (std::uint64_t count = number(); count > 0; --count) {
    MatVariable v;
    v.name = text();
    v.rows = number();
    v.columns = number();
    const std::uint64_t values = number();
    const std::string_view data = take(values > bytes.size() ? bytes.size() + 1 : values * sizeof(double));
    v.values.resize(values);
    if (values > 0) std::memcpy(v.values.data(), data.data(), data.size());
    for (std::uint64_t texts = number(); texts > 0; --texts) v.texts.push_back(text());
    content.variables.push_back(std::move(v));
  }
  return content;
}

}  // namespace trunk
