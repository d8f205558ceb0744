#include "files/replace_file.hpp"

#include <fcntl.h>
#include <unistd.h>

#include <cerrno>
#include <cstring>
#include <random>
#include <stdexcept>
#include <string>
#include <utility>

#include "errors/input_error.hpp"

namespace trunk {
namespace {

namespace fs = std::filesystem;

[[noreturn]] void fail(const fs::path& path, const std::string& found, int error) {
  throw InputError({path.string()}, found + ": " + std::strerror(error));
}

fs::path folder_of(const fs::path& path) {
  return path.has_parent_path() ? path.parent_path() : fs::path(".");
}

/// A new file beside the output. It is removed again unless it takes the output's name.
class PartFile {
 public:
  explicit PartFile(const fs::path& output) : output_(output) {
    // Process numbers are not unique on a shared file system: the random part keeps nodes apart.
    std::random_device random;
    do {
      part_ = output;
      part_ += "." + std::to_string(getpid()) + "-" + std::to_string(random()) + ".part";
      descriptor_ = open(part_.c_str(), O_WRONLY | O_CREAT | O_EXCL | O_CLOEXEC, 0666);
    } while (descriptor_ < 0 && errno == EEXIST);
    if (descriptor_ < 0) fail(output_, "cannot create a file in this folder", errno);
  }
  ~PartFile() {
    if (descriptor_ >= 0) close(descriptor_);
    if (!part_.empty()) unlink(part_.c_str());
  }
  PartFile(const PartFile&) = delete;
  PartFile& operator=(const PartFile&) = delete;

  void write_all(std::span<const std::byte> bytes) {
    while (!bytes.empty()) {
      const ssize_t written = write(descriptor_, bytes.data(), bytes.size());
      if (written < 0 && errno == EINTR) continue;
      if (written < 0) fail(output_, "cannot be written", errno);
      bytes = bytes.subspan(static_cast<std::size_t>(written));
    }
  }

  void take_the_name() {
    if (fsync(descriptor_) != 0) fail(output_, "cannot be written", errno);
    if (close(std::exchange(descriptor_, -1)) != 0) fail(output_, "cannot be written", errno);
    if (rename(part_.c_str(), output_.c_str()) != 0) fail(output_, "cannot be replaced", errno);
    part_.clear();
  }

 private:
  fs::path output_, part_;
  int descriptor_ = -1;
};

/// Makes the rename survive a power cut. Some network file systems cannot; the file is stored all the same.
void synchronise_folder(const fs::path& folder) {
  const int descriptor = open(folder.c_str(), O_RDONLY | O_DIRECTORY | O_CLOEXEC);
  if (descriptor < 0) return;
  fsync(descriptor);
  close(descriptor);
}

}  // namespace

void require_writable_output(const fs::path& path, bool force) {
  const auto refuse = [&path](const std::string& found, const std::string& expected,
                              const std::string& remedy) {
    throw InputError({path.string()}, found, expected, remedy);
  };
  if (!path.has_filename()) refuse("is not the name of a file", "the name of a file to write", "");
  std::error_code error;
  const fs::file_status existing = fs::status(path, error);
  if (fs::exists(existing)) {
    // A rename would replace even a device.
    if (!fs::is_regular_file(existing)) refuse("exists and is not a file", "", "choose another name");
    if (!force) refuse("exists already", "", "use --force to replace it, or choose another name");
  }
  const fs::file_status folder = fs::status(folder_of(path), error);
  if (!fs::exists(folder)) refuse("its folder does not exist", "", "create the folder first");
  if (!fs::is_directory(folder)) refuse("its folder is a file", "a folder", "choose another name");
  PartFile trial(path);
}

void replace_file(const fs::path& path, std::span<const std::byte> bytes, std::span<const std::byte> more) {
  std::error_code error;
  const fs::file_status existing = fs::status(path, error);
  if (fs::exists(existing) && !fs::is_regular_file(existing)) {
    throw InputError({path.string()}, "exists and is not a file, so it cannot be replaced");
  }
  PartFile part(path);
  part.write_all(bytes);
  part.write_all(more);
  part.take_the_name();
  synchronise_folder(folder_of(path));
}

void require_apart(const std::vector<fs::path>& inputs, const std::vector<fs::path>& outputs) {
  const auto same = [](const fs::path& a, const fs::path& b) {
    return fs::weakly_canonical(fs::absolute(a)) == fs::weakly_canonical(fs::absolute(b));
  };
  for (std::size_t i = 0; i < outputs.size(); ++i) {
    const Place output{outputs[i].string()};
    for (const fs::path& input : inputs)
      if (same(input, outputs[i]))
        throw InputError(output, "is read by this command", "another name for the result");
    for (std::size_t j = 0; j < i; ++j)
      if (same(outputs[j], outputs[i])) throw InputError(output, "is named for two results", "two names");
  }
}

}  // namespace trunk
