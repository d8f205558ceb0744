#pragma once

#include <cstddef>
#include <cstdlib>
#include <functional>
#include <memory>
#include <span>

#include "results/hdf5/id.hpp"

namespace trunk::hdf5 {

/// The bytes of a whole HDF5 file, in memory.
///
/// Files are built in memory and then stored with plain system calls. On a full disk, write() fails at once
/// and gives the cause. HDF5 1.10 fails late (at flush or close), without errno, and keeps the file open
/// until the program ends.
class Image {
 public:
  Image(std::byte* data, std::size_t size) : data_(data), size_(size) {}
  std::span<const std::byte> bytes() const { return {data_.get(), size_}; }

 private:
  struct Free {
    void operator()(std::byte* data) const { std::free(data); }
  };
  std::unique_ptr<std::byte[], Free> data_;
  std::size_t size_;
};

/// Builds a file whose root group `fill` fills. Throws Error, also if `fill` leaves something open.
Image build_image(const std::function<void(hid_t root)>& fill);

}  // namespace trunk::hdf5
