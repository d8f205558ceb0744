#include "results/read/open_results.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <new>

#include "errors/input_error.hpp"
#include "results/hdf5/read.hpp"
#include "results/read/look.hpp"
#include "results/seal.hpp"
#include "results/write/layout.hpp"

namespace trunk::layout {
namespace {

namespace fs = std::filesystem;

void require_hdf5(const fs::path& path) {
  const auto refuse = [&path](std::string found, std::string expected = "", std::string remedy = "") {
    throw InputError({path.string()}, std::move(found), std::move(expected), std::move(remedy));
  };
  std::error_code error;
  const fs::file_status status = fs::status(path, error);
  if (!fs::exists(status)) refuse("no such file", "a results file", "check the path");
  if (fs::is_directory(status))
    refuse("is a folder", "a results file",
           "use `trunk status` for the folder of a sweep; its results are in sweep.h5");
  if (!fs::is_regular_file(status)) refuse("is not a file");
  std::error_code unreadable;
  if (fs::file_size(path, unreadable) == 0 || unreadable) refuse(unreadable ? "cannot be read" : "is empty");
  const htri_t is_hdf5 = H5Fis_hdf5(path.c_str());
  if (is_hdf5 < 0) refuse("cannot be read");
  if (is_hdf5 == 0)
    throw InputError({path.string()}, "is not an HDF5 file", "a results file of trunk",
                     fmt::format("it looks like {}", look_of(path)));
}

hdf5::File open_file(const fs::path& path) {
  const hdf5::Properties access(H5Pcreate(H5P_FILE_ACCESS), "prepare reading");
  // A file with its final name never changes. It needs no locks, and some clusters do not support them.
  hdf5::require(H5Pset_file_locking(access, false, true), "prepare reading");
  hdf5::require(H5Pset_fclose_degree(access, H5F_CLOSE_STRONG), "prepare reading");
  return hdf5::File(H5Fopen(path.c_str(), H5F_ACC_RDONLY, access), "open it");
}

std::string names_in(hid_t root) {
  constexpr std::size_t most = 5;
  const std::vector<std::string> names = hdf5::link_names(root);
  std::string text;
  for (std::size_t i = 0; i < std::min(most, names.size()); ++i)
    text += (i > 0 ? ", " : "") + names[i].substr(0, 40);
  if (names.size() > most) text += fmt::format(" and {} more", names.size() - most);
  return names.empty() ? "nothing" : text;
}

std::string require_schema(const fs::path& path, hid_t root) {
  const auto refuse = [&path](std::string found, std::string expected = "", std::string remedy = "") {
    throw InputError({path.string()}, std::move(found), std::move(expected), std::move(remedy));
  };
  const std::string schema = hdf5::read_attribute_if_any(root, "schema");
  const std::string version = hdf5::read_attribute_if_any(root, "schema_version");
  if (schema.rfind("trunk.", 0) != 0)
    refuse(fmt::format("is an HDF5 file of another program (it holds {})", names_in(root)),
           "a results file of trunk");
  std::string kind = schema.substr(6);
  if (kind != "run" && kind != "fit" && kind != "sweep") {
    refuse(fmt::format("has schema '{}'", schema), "trunk.run, trunk.fit or trunk.sweep");
  }
  std::vector<std::string> known;
  for (std::int32_t v = 1; v <= schema_version(kind); ++v) known.push_back(std::to_string(v));
  if (std::find(known.begin(), known.end(), version) == known.end()) {
    refuse(fmt::format("has version {} of schema {}", version, schema),
           fmt::format("version {}", fmt::join(known, " or ")),
           "use the version of trunk that wrote the file");
  }
  if (hdf5::read_attribute_if_any(root, "complete") != "1") {
    refuse("is unfinished: the program that wrote it was interrupted", "", "make it again");
  }
  return kind;
}

}  // namespace

void read_results(const fs::path& path, const std::function<void(hid_t, const std::string&)>& use) {
  const hdf5::Session session;
  require_hdf5(path);
  try {
    require_intact(path);
    const hdf5::File file = open_file(path);
    const hdf5::Group root(H5Gopen2(file, "/", H5P_DEFAULT), "open the root group");
    use(root, require_schema(path, root));
  } catch (const hdf5::Error& error) {
    throw InputError({path.string()}, fmt::format("is truncated or damaged: {}", error.what()));
  } catch (const std::bad_alloc&) {
    throw InputError({path.string()}, "is too large for the memory of this machine");
  }
}

}  // namespace trunk::layout
