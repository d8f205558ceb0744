#include "files/sha256.hpp"

#include <openssl/evp.h>

#include <algorithm>
#include <array>
#include <cerrno>
#include <cstdio>
#include <cstring>
#include <memory>
#include <stdexcept>

#include "errors/input_error.hpp"

namespace trunk {
namespace {

class Sha256 {
 public:
  Sha256() : context_(EVP_MD_CTX_new()) {
    check(context_ && EVP_DigestInit_ex(context_.get(), EVP_sha256(), nullptr));
  }
  void add(const void* data, std::size_t size) { check(EVP_DigestUpdate(context_.get(), data, size)); }

  std::string hexadecimal() {
    std::array<unsigned char, EVP_MAX_MD_SIZE> digest{};
    unsigned size = 0;
    check(EVP_DigestFinal_ex(context_.get(), digest.data(), &size));
    std::string text;
    for (unsigned i = 0; i < size; ++i) {
      text += "0123456789abcdef"[digest[i] >> 4];
      text += "0123456789abcdef"[digest[i] & 15];
    }
    return text;
  }

 private:
  static void check(int ok) {
    if (ok != 1) throw std::runtime_error("SHA-256 is not available from libcrypto");
  }
  struct Free {
    void operator()(EVP_MD_CTX* context) const { EVP_MD_CTX_free(context); }
  };
  std::unique_ptr<EVP_MD_CTX, Free> context_;
};

struct Close {
  void operator()(std::FILE* file) const { std::fclose(file); }
};

}  // namespace

std::string sha256_of_text(std::string_view text) {
  Sha256 hash;
  hash.add(text.data(), text.size());
  return hash.hexadecimal();
}

std::string sha256_of_file(const std::filesystem::path& path, std::uintmax_t most) {
  const std::unique_ptr<std::FILE, Close> file(std::fopen(path.c_str(), "rb"));
  if (!file) throw InputError({path.string()}, std::string("cannot be read: ") + std::strerror(errno));
  Sha256 hash;
  std::array<char, 65536> block;
  const auto next = [&] { return static_cast<std::size_t>(std::min<std::uintmax_t>(block.size(), most)); };
  while (const std::size_t size = std::fread(block.data(), 1, next(), file.get())) {
    hash.add(block.data(), size);
    most -= size;
  }
  // A folder can be opened, but not read.
  if (std::ferror(file.get())) {
    throw InputError({path.string()}, std::string("cannot be read: ") + std::strerror(errno));
  }
  return hash.hexadecimal();
}

}  // namespace trunk
