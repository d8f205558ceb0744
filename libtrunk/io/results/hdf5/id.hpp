#pragma once

#include <hdf5.h>

#include <stdexcept>
#include <string>
#include <utility>

/// Private to the results layer: the only header that includes hdf5.h.
namespace trunk::hdf5 {

/// An HDF5 call failed; the text is one line, what was being done and the innermost cause.
class Error : public std::runtime_error {
 public:
  using std::runtime_error::runtime_error;
};

/// Takes the library's error stack apart and throws it as one Error.
[[noreturn]] void raise(const std::string& doing);

/// Passes on what an HDF5 call returned, unless it is negative: then it throws.
template <typename Result>
Result require(Result result, const std::string& doing) {
  if (result < 0) raise(doing);
  return result;
}

/// Owns one HDF5 identifier; move-only.
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

  /// Gives up ownership, for the caller who wants to see whether closing works.
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

/// Held by every public function of the layer while it uses HDF5: one thread at a time, whatever
/// the library was built with, and nothing printed by it.
class Session {
 public:
  Session();
  ~Session();
  Session(const Session&) = delete;
  Session& operator=(const Session&) = delete;
};

}  // namespace trunk::hdf5
