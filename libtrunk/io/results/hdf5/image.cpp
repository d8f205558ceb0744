#include "results/hdf5/image.hpp"

#include <cstdint>
#include <cstring>
#include <utility>

namespace trunk::hdf5 {
namespace {

constexpr std::size_t growth = std::size_t{4} << 20;  // bytes added to the image at a time

/// The memory of a file of HDF5's core driver. We keep it when the driver closes the file. H5Fget_file_image
/// would be simpler, but in HDF5 1.10 it clears the "open for writing" flag without updating the checksum of
/// the superblock, and such images cannot be opened.
struct Buffer {
  std::byte* data = nullptr;
  std::size_t size = 0;
  ~Buffer() { std::free(data); }
};

void* enlarge(void* data, std::size_t size, H5FD_file_image_op_t, void* user) {
  auto& buffer = *static_cast<Buffer*>(user);
  auto* moved = static_cast<std::byte*>(std::realloc(data, size));
  if (!moved) return nullptr;
  // Gaps in the file are zero, so that equal runs give equal bytes.
  if (size > buffer.size) std::memset(moved + buffer.size, 0, size - buffer.size);
  buffer.data = moved;
  buffer.size = size;
  return moved;
}

/// Frees nothing: Buffer or Image frees the memory.
herr_t keep(void*, H5FD_file_image_op_t, void*) {
  return 0;
}
void* same(void* user) {
  return user;
}
herr_t leave(void*) {
  return 0;
}

Properties access_in_memory(Buffer& buffer) {
  Properties access(H5Pcreate(H5P_FILE_ACCESS), "prepare a file");
  require(H5Pset_fapl_core(access, growth, false), "prepare a file in memory");
  // The formats of 1.10 have checksums on all metadata; older ones do not.
  require(H5Pset_libver_bounds(access, H5F_LIBVER_V110, H5F_LIBVER_V110), "choose the file format");
  // Closing fails if something is still open, instead of silently waiting for it.
  require(H5Pset_fclose_degree(access, H5F_CLOSE_SEMI), "prepare a file");
  H5FD_file_image_callbacks_t callbacks{};
  callbacks.image_realloc = enlarge;
  callbacks.image_free = keep;
  callbacks.udata_copy = same;
  callbacks.udata_free = leave;
  callbacks.udata = &buffer;
  require(H5Pset_file_image_callbacks(access, &callbacks), "prepare a file in memory");
  return access;
}

/// Returns the end of the file, which is in the superblock (version 2 and 3). The buffer is larger, since it
/// grows in steps.
std::size_t end_of_file(const Buffer& buffer) {
  constexpr std::size_t end_of_file_address = 28;
  std::uint64_t end = 0;
  if (buffer.size > 48) std::memcpy(&end, buffer.data + end_of_file_address, sizeof end);
  if (end < 48 || end > buffer.size) throw Error("cannot find the end of the file in memory");
  return end;
}

}  // namespace

Image build_image(const std::function<void(hid_t root)>& fill) {
  Buffer buffer;  // outlives the file
  {
    const Properties access = access_in_memory(buffer);
    const Properties creation(H5Pcreate(H5P_FILE_CREATE), "prepare a file");
    require(H5Pset_obj_track_times(creation, false), "leave times out");
    require(H5Pset_link_creation_order(creation, H5P_CRT_ORDER_TRACKED | H5P_CRT_ORDER_INDEXED),
            "keep the order");
    File file(H5Fcreate("in memory", H5F_ACC_TRUNC, creation, access), "create a file in memory");
    {
      const Group root(H5Gopen2(file, "/", H5P_DEFAULT), "open the root group");
      fill(root);
    }
    require(H5Fflush(file, H5F_SCOPE_LOCAL), "flush the file in memory");
    require(H5Fclose(file.release()), "close the file in memory");
  }
  const std::size_t size = end_of_file(buffer);
  return {std::exchange(buffer.data, nullptr), size};
}

}  // namespace trunk::hdf5
