#include "commands/options/shipped_files.hpp"

#include <system_error>

#include "errors/input_error.hpp"

namespace trunk {

namespace fs = std::filesystem;

fs::path shipped_file(const fs::path& place, const char* option) {
  std::error_code ignored;  // what cannot be looked at is not there
  const fs::path program = fs::read_symlink("/proc/self/exe", ignored);
  fs::path beside = program.parent_path().parent_path() / place, here = fs::current_path(ignored) / place;
  if (!program.empty() && fs::exists(beside, ignored)) return beside;
  if (fs::exists(here, ignored)) return here;
  throw InputError(Place{}, "neither " + beside.string() + " nor " + here.string() + " exists", "",
                   std::string("say where it is with ") + option);
}

fs::path require_folder(const fs::path& folder) {
  std::error_code ignored;
  if (fs::is_directory(folder, ignored)) return folder;
  throw InputError(Place{folder.string()}, "there is no such folder", "a folder with the shipped scenarios");
}

}  // namespace trunk
