#include <set>

#include "results/hdf5/read.hpp"

namespace trunk::hdf5 {
namespace {

constexpr int deepest = 12;  // our files have 4 levels
constexpr std::size_t most_objects = 1000000;

/// Returns the order of writing if the file has it, otherwise the alphabetical order.
H5_index_t order_of(hid_t group) {
  const Properties properties(H5Gget_create_plist(group), "read the order of a group");
  unsigned flags = 0;
  H5Pget_link_creation_order(properties, &flags);
  return flags & H5P_CRT_ORDER_INDEXED ? H5_INDEX_CRT_ORDER : H5_INDEX_NAME;
}

std::string link_name(hid_t group, H5_index_t order, hsize_t index) {
  const std::string doing = "read the names in a group";
  const auto size =
      require(H5Lget_name_by_idx(group, ".", order, H5_ITER_INC, index, nullptr, 0, H5P_DEFAULT), doing);
  std::string name(static_cast<std::size_t>(size) + 1, '\0');
  require(H5Lget_name_by_idx(group, ".", order, H5_ITER_INC, index, name.data(), name.size(), H5P_DEFAULT),
          doing);
  name.pop_back();
  return name;
}

/// Returns the result of H5Oget_info1: an H5O_info_t in HDF5 1.10, an H5O_info1_t from 1.12 on. H5Oget_info
/// means another function in each of these versions.
template <class Info>
Info info_of(herr_t (*get_info)(hid_t, Info*), hid_t object, const std::string& path) {
  Info info{};
  require(get_info(object, &info), "open " + path);
  return info;
}

using Visit = std::function<void(hid_t, H5I_type_t, const std::string&)>;

void walk_below(hid_t group, const std::string& prefix, int depth, std::set<haddr_t>& seen,
                const Visit& visit) {
  H5G_info_t info{};
  require(H5Gget_info(group, &info), "list " + prefix);
  const H5_index_t order = order_of(group);
  for (hsize_t index = 0; index < info.nlinks; ++index) {
    if (depth > deepest || seen.size() > most_objects) throw Error("cannot list the file: it has no end");
    H5L_info_t link{};
    require(H5Lget_info_by_idx(group, ".", order, H5_ITER_INC, index, &link, H5P_DEFAULT), "list " + prefix);
    if (link.type != H5L_TYPE_HARD) continue;
    const std::string path = prefix + link_name(group, order, index);
    const Object object(H5Oopen_by_idx(group, ".", order, H5_ITER_INC, index, H5P_DEFAULT), "open " + path);
    if (!seen.insert(info_of(H5Oget_info1, object, path).addr).second) continue;
    const H5I_type_t kind = H5Iget_type(object);
    visit(object, kind, path);
    if (kind == H5I_GROUP) walk_below(object, path + "/", depth + 1, seen, visit);
  }
}

}  // namespace

std::vector<std::string> link_names(hid_t group) {
  H5G_info_t info{};
  require(H5Gget_info(group, &info), "list a group");
  if (info.nlinks > most_objects) throw Error("cannot list the file: it has no end");
  const H5_index_t order = order_of(group);
  std::vector<std::string> names;
  for (hsize_t index = 0; index < info.nlinks; ++index) names.push_back(link_name(group, order, index));
  return names;
}

void walk(hid_t group, const Visit& visit) {
  std::set<haddr_t> seen;
  walk_below(group, "", 0, seen, visit);
}

}  // namespace trunk::hdf5
