#include "report/packed.hpp"

#include <openssl/evp.h>
#include <zlib.h>

#include <bit>
#include <cstring>
#include <stdexcept>

namespace trunk {
namespace {

static_assert(std::endian::native == std::endian::little, "the page reads little-endian numbers");

/// Returns the block in gzip format. The gzip header has no name and no time, so equal blocks give equal
/// bytes.
std::string gzipped(const std::string& block) {
  constexpr int window_with_gzip_head = 15 + 16, memory_level = 9;
  z_stream stream{};
  if (deflateInit2(&stream, Z_BEST_COMPRESSION, Z_DEFLATED, window_with_gzip_head, memory_level,
                   Z_DEFAULT_STRATEGY) != Z_OK)
    throw std::runtime_error("zlib cannot be started");
  std::string out(deflateBound(&stream, block.size()), '\0');
  stream.next_in = reinterpret_cast<Bytef*>(const_cast<char*>(block.data()));
  stream.avail_in = static_cast<uInt>(block.size());
  stream.next_out = reinterpret_cast<Bytef*>(out.data());
  stream.avail_out = static_cast<uInt>(out.size());
  const int end = deflate(&stream, Z_FINISH);
  out.resize(stream.total_out);
  deflateEnd(&stream);
  if (end != Z_STREAM_END) throw std::runtime_error("the numbers of the report could not be compressed");
  return out;
}

std::string base64(const std::string& bytes) {
  std::string out(4 * ((bytes.size() + 2) / 3) + 1, '\0');
  const int size =
      EVP_EncodeBlock(reinterpret_cast<unsigned char*>(out.data()),
                      reinterpret_cast<const unsigned char*>(bytes.data()), static_cast<int>(bytes.size()));
  out.resize(static_cast<std::size_t>(size));
  return out;
}

}  // namespace

template <typename Value>
Packed::Json Packed::append(const char* as, const std::vector<Value>& values) {
  block_.resize((block_.size() + 7) / 8 *
                8);  // a typed array of a browser must begin at a multiple of its size
  const std::size_t at = block_.size(), size = values.size() * sizeof(Value);
  constexpr std::size_t most = 1u << 28;
  if (size > most - at) throw std::runtime_error("the file holds more than a page can show");
  block_.resize(at + size);
  if (size > 0) std::memcpy(block_.data() + at, values.data(), size);
  return {{"as", as}, {"at", at}, {"n", values.size()}};
}

Packed::Json Packed::add(const std::vector<double>& values) {
  return append("f8", values);
}

Packed::Json Packed::add_single(const std::vector<double>& values) {
  return append("f4", std::vector<float>(values.begin(), values.end()));
}

Packed::Json Packed::add(const std::vector<std::int32_t>& values) {
  return append("i4", values);
}

Packed::Json Packed::add(const std::vector<std::int16_t>& values) {
  return append("i2", values);
}

Packed::Json Packed::add(const std::vector<std::uint8_t>& values) {
  return append("u1", values);
}

std::string Packed::text() const {
  return base64(gzipped(block_));
}

}  // namespace trunk
