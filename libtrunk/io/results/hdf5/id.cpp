#include "results/hdf5/id.hpp"

#include <mutex>

namespace trunk::hdf5 {
namespace {

std::mutex one_thread;

/// HDF5 calls this from the innermost function outwards. The first call gets the cause.
herr_t keep_innermost(unsigned depth, const H5E_error2_t* error, void* cause) {
  if (depth == 0 && error->desc) *static_cast<std::string*>(cause) = error->desc;
  return 0;
}

}  // namespace

void raise(const std::string& doing) {
  std::string cause;
  H5Ewalk2(H5E_DEFAULT, H5E_WALK_UPWARD, keep_innermost, &cause);
  H5Eclear2(H5E_DEFAULT);
  for (char& c : cause) {
    if (c == '\n') c = ' ';
  }
  throw Error("cannot " + doing + (cause.empty() ? "" : " (" + cause + ")"));
}

Session::Session() {
  one_thread.lock();
  // Each thread has its own error stack, so printing is switched off in each session.
  H5Eset_auto2(H5E_DEFAULT, nullptr, nullptr);
}

Session::~Session() {
  one_thread.unlock();
}

}  // namespace trunk::hdf5
