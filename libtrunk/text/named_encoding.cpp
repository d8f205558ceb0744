#include "text/named_encoding.hpp"

#include <iconv.h>

#include <cerrno>
#include <cstdint>

namespace trunk {
namespace {

class Converter {
 public:
  explicit Converter(const std::string& from) : handle_(iconv_open("UTF-8", from.c_str())) {}
  ~Converter() {
    if (*this) iconv_close(handle_);
  }
  Converter(const Converter&) = delete;
  Converter& operator=(const Converter&) = delete;
  explicit operator bool() const { return reinterpret_cast<std::intptr_t>(handle_) != -1; }

  // Converts as much as fits into `piece` and appends it. Returns 0, or the error: E2BIG if there is more.
  int convert(std::string_view& bytes, std::string& piece, std::string& text) {
    char* in = const_cast<char*>(bytes.data());  // iconv does not write there
    char* out = piece.data();
    std::size_t in_left = bytes.size(), out_left = piece.size();
    const bool failed = iconv(handle_, bytes.empty() ? nullptr : &in, &in_left, &out, &out_left) ==
                        static_cast<std::size_t>(-1);
    const int error = failed ? errno : 0;
    text.append(piece.data(), piece.size() - out_left);
    bytes.remove_prefix(bytes.size() - in_left);
    return error;
  }

 private:
  iconv_t handle_;
};

// iconv takes "NAME//OPTION" and names of files too.
bool may_be_name(std::string_view name) {
  constexpr std::string_view others = "-_.:+()";
  if (name.empty() || name.size() > 40) return false;
  for (const char c : name) {
    const bool letter = (c >= '0' && c <= '9') || (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z');
    if (!letter && others.find(c) == std::string_view::npos) return false;
  }
  return true;
}

}  // namespace

Decoded decoded(std::string_view bytes, const std::string& encoding, std::size_t most_bytes) {
  Decoded result;
  Converter converter(may_be_name(encoding) ? encoding : "no encoding");
  result.known_name = static_cast<bool>(converter);
  if (!result.known_name) return result;
  const std::size_t all = bytes.size();
  std::string piece(std::size_t{1} << 16, '\0');
  int error = E2BIG;
  while (!bytes.empty() && error == E2BIG && !result.too_long) {
    error = converter.convert(bytes, piece, result.text);
    result.too_long = result.text.size() > most_bytes;
  }
  if (!bytes.empty() && error != E2BIG) result.bad_byte = all - bytes.size();
  if (bytes.empty()) converter.convert(bytes, piece, result.text);  // what it still holds back
  if (result.text.starts_with("\xEF\xBB\xBF")) result.text.erase(0, 3);
  return result;
}

}  // namespace trunk
