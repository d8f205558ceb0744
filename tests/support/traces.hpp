#pragma once

#include <string>

#include "errors/input_error.hpp"
#include "support/catch.hpp"
#include "support/temporary_folder.hpp"
#include "traces/read_trace.hpp"

namespace trunk::test {

inline Trace trace_of(const std::string& content, const TraceOptions& options = {}) {
  const TemporaryFolder folder;
  return read_trace(folder.write("trace.csv", content), options);
}

/// The error of a file, with its name replaced by "FILE"; "" when there was none.
inline std::string trace_error_at(const std::filesystem::path& path, const TraceOptions& options = {}) {
  try {
    read_trace(path, options);
  } catch (const InputError& error) {
    std::string text = error.what();
    const std::string name = path.string();
    REQUIRE_THAT(text, StartsWith(name + ":"));
    REQUIRE(text.find('\n') == std::string::npos);
    return text.replace(0, name.size(), "FILE");
  }
  return "";
}

inline std::string trace_error(const std::string& content, const TraceOptions& options = {}) {
  const TemporaryFolder folder;
  return trace_error_at(folder.write("trace.csv", content), options);
}

/// Rows "0.00,0" "0.01,5" ...: times 10 ms apart, values 5 i.
inline std::string trace_rows(const std::string& delimiter = ",", const std::string& end = "\n",
                              int count = 12) {
  std::string text;
  for (int i = 0; i < count; ++i)
    text +=
        "0." + std::string(i < 10 ? "0" : "") + std::to_string(i) + delimiter + std::to_string(5 * i) + end;
  return text;
}

inline std::string utf16(const std::string& ascii, bool big_endian, bool mark = true) {
  std::string bytes = !mark ? "" : big_endian ? "\xFE\xFF" : "\xFF\xFE";
  for (const char c : ascii) bytes += big_endian ? std::string{'\0', c} : std::string{c, '\0'};
  return bytes;
}

}  // namespace trunk::test
