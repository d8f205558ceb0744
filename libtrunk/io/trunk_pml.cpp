#include "io/trunk_pml.hpp"
#include "errors/input_error.hpp"
namespace trunk {
TrunkMesh read_trunk_pml(const std::filesystem::path& path) {
  throw InputError(path.string());
}
}  // namespace trunk
