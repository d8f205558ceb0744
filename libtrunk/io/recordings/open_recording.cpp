#include "recordings/open_recording.hpp"

#include <fstream>

#include "files/read_file.hpp"
#include "recordings/edf/edf_recording.hpp"
#include "recordings/foreign_formats.hpp"
#include "recordings/matlab/matlab_recording.hpp"
#include "recordings/text_recording.hpp"

namespace trunk {
namespace {

constexpr std::size_t largest_text = 200'000'000;

// Returns the first bytes of a file; "" for a pipe, which can be read only once.
std::string start_of(const std::filesystem::path& path) {
  std::error_code ignored;
  if (!std::filesystem::is_regular_file(path, ignored)) return {};
  std::string start(1024, '\0');
  std::ifstream file(path, std::ios::binary);
  file.read(start.data(), static_cast<std::streamsize>(start.size()));
  start.resize(static_cast<std::size_t>(file.gcount()));
  return start;
}

}  // namespace

std::unique_ptr<Recording> open_recording(const std::filesystem::path& path,
                                          const RecordingOptions& options) {
  const std::string start = start_of(path);
  if (is_matlab(start)) return open_matlab(path, options.block);
  if (is_edf(start)) return open_edf(path, options.block);
  require_no_foreign_format(path, start);
  TextOfFile file = read_text_file_in(options.encoding, path, largest_text);
  auto recording = recording_of_text(path.string(), std::move(file.text), options.block);
  if (file.encoding_is_a_guess)
    recording->if_missing =
        "if these names look wrong, give the encoding of the file, as in --encoding Shift_JIS";
  return recording;
}

}  // namespace trunk
