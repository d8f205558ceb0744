#pragma once

#include <hdf5.h>

#include <stdexcept>
#include <string>
#include <utility>

/// Private to the results layer: the only header that includes hdf5.h.
namespace trunk::hdf5 {

/// An HDF5 call failed. The text is one line with the action that failed and the innermost cause.
class Error : public std::runtime_error {
 public:
  using std::runtime_error::runtime_error;
};

/// Throws the innermost cause on the error stack of the library as an Error.
[[noreturn]] void raise(const std::string& doing);

/// Returns the result of an HDF5 call; throws Error if it is negative.
template <typename Result>
Result require(Result result, const std::string& doing) {
  if (result < 0) raise(doing);
  return result;
}

/// Owns one HDF5 identifier. It can be moved, but not copied.
template <auto Close>
class Id {
 public:
  Id(hid_t value, const std::string& doing) : value_(require(value, doing)) {}
  Id(Id&& other) noexcept : value_(std::exchange(other.value_, H5I_INVALID_HID)) {}
  Id& operator=(Id&& other) noexcept {
    std::swap(value_, other.value_);
    return *this;
  }
  ~Id() {
    if (value_ >= 0) Close(value_);
  }

  operator hid_t() const noexcept { return value_; }

  /// Gives up the ownership, so that the caller can check whether closing works.
  hid_t release() noexcept { return std::exchange(value_, H5I_INVALID_HID); }

 private:
  hid_t value_;
};

using File = Id<&H5Fclose>;
using Group = Id<&H5Gclose>;
using Object = Id<&H5Oclose>;
using Dataset = Id<&H5Dclose>;
using Space = Id<&H5Sclose>;
using Type = Id<&H5Tclose>;
using Attribute = Id<&H5Aclose>;
using Properties = Id<&H5Pclose>;

/// Every public function of the layer holds a Session while it uses HDF5. Only one thread at a time uses
/// HDF5, even if the library is not thread-safe, and the library prints nothing.
class Session {
 public:
  Session();
  ~Session();
  Session(const Session&) = delete;
  Session& operator=(const Session&) = delete;
};

}  // namespace trunk::hdf5
