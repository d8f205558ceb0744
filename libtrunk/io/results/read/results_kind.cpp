#include "results/read/results_kind.hpp"

#include "errors/input_error.hpp"
#include "results/read/open_results.hpp"

namespace trunk {

bool is_complete(const std::filesystem::path& path) {
  try {
    layout::read_results(path, [](hid_t, const std::string&) {});
    return true;
  } catch (const InputError&) {
    return false;
  }
}

std::string kind_of(const std::filesystem::path& path) {
  std::string found;
  layout::read_results(path, [&](hid_t, const std::string& kind) { found = kind; });
  return found;
}

}  // namespace trunk
