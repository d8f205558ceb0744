#include "results/stored_file.hpp"

#include <limits>
#include <sstream>

#include "results/hdf5/read.hpp"
#include "results/open_results.hpp"

namespace trunk {
namespace {

hdf5::Object opened(hid_t root, const std::string& path) {
  return hdf5::Object(H5Oopen(root, path.empty() ? "." : path.c_str(), H5P_DEFAULT), "open " + path);
}

std::size_t size_of(const std::vector<hsize_t>& shape, const std::string& path) {
  std::size_t size = 1;
  for (const hsize_t length : shape) {
    if (length > 0 && size > StoredFile::most_values / length) throw hdf5::Error(path + " is too large");
    size *= length;
  }
  return size;
}

}  // namespace

/// Link by link, and only links within the file: HDF5 fails where a group on the way is missing.
bool StoredFile::has(const std::string& path) const {
  for (std::size_t end = path.find('/');; end = path.find('/', end + 1)) {
    const std::string part = path.substr(0, end);
    if (!hdf5::has_link(root_, part)) return false;
    H5L_info_t link{};
    hdf5::require(H5Lget_info(root_, part.c_str(), &link, H5P_DEFAULT), "look for " + part);
    if (link.type != H5L_TYPE_HARD) return false;
    if (end == std::string::npos) return true;
  }
}

StoredArray StoredFile::array(const std::string& path) const {
  if (!has(path)) return {};
  const hdf5::Dataset dataset = hdf5::open_dataset(root_, path);
  StoredArray array{hdf5::read_attribute_if_any(dataset, "units"),
                    hdf5::read_attribute_if_any(dataset, "long_name"),
                    {},
                    {}};
  const auto shape = hdf5::shape_of(dataset);
  const std::size_t size = size_of(shape, path);
  array.shape.assign(shape.begin(), shape.end());
  array.values = hdf5::read_doubles(root_, path);
  if (array.values.size() != size) throw hdf5::Error(path + " has values missing");
  return array;
}

std::vector<std::string> StoredFile::texts(const std::string& path) const {
  return has(path) ? hdf5::read_texts(root_, path) : std::vector<std::string>{};
}

std::string StoredFile::text(const std::string& path) const {
  return has(path) ? hdf5::read_text(root_, path) : "";
}

std::string StoredFile::attribute(const std::string& path, const std::string& name) const {
  if (!path.empty() && !has(path)) return "";
  return hdf5::read_attribute_if_any(opened(root_, path), name);
}

std::vector<std::string> StoredFile::attributes(const std::string& path) const {
  if (!path.empty() && !has(path)) return {};
  return hdf5::attribute_names(opened(root_, path));
}

std::vector<std::string> StoredFile::code_names(const std::string& path) const {
  std::istringstream words(attribute(path, "flag_meanings"));
  std::vector<std::string> names;
  for (std::string word; words >> word;) names.push_back(word);
  return names;
}

std::vector<std::string> StoredFile::members(const std::string& path, int kind) const {
  std::vector<std::string> names;
  if (!has(path)) return names;
  const hdf5::Group group(H5Gopen2(root_, path.c_str(), H5P_DEFAULT), "open " + path);
  hdf5::walk(group, [&](hid_t, H5I_type_t found, const std::string& name) {
    if (found == kind && name.find('/') == std::string::npos) names.push_back(name);
  });
  return names;
}

std::vector<std::string> StoredFile::groups(const std::string& path) const {
  return members(path, H5I_GROUP);
}

std::vector<std::string> StoredFile::datasets(const std::string& path) const {
  return members(path, H5I_DATASET);
}

void read_stored(const std::filesystem::path& path, const std::function<void(const StoredFile&)>& use) {
  layout::read_results(path, [&](hid_t root, const std::string& kind) { use(StoredFile(root, kind)); });
}

}  // namespace trunk
