#include "results/write/vtkhdf_view.hpp"

#include <fmt/format.h>

#include <stdexcept>

#include "files/replace_file.hpp"
#include "results/hdf5/image.hpp"

namespace trunk {

void write_vtkhdf_view(const std::filesystem::path& view, const std::filesystem::path& results) {
  const auto folder = std::filesystem::weakly_canonical(std::filesystem::absolute(view)).parent_path();
  const auto linked = std::filesystem::canonical(results).lexically_relative(folder);
  try {
    const hdf5::Session session;
    const hdf5::Image image = hdf5::build_image([&](hid_t root) {
      hdf5::require(H5Lcreate_external(linked.c_str(), "/VTKHDF", root, "VTKHDF", H5P_DEFAULT, H5P_DEFAULT),
                    "link the trajectory");
    });
    replace_file(view, image.bytes());
  } catch (const hdf5::Error& error) {
    throw std::runtime_error(fmt::format("{}: {}", view.string(), error.what()));
  }
}

}  // namespace trunk
