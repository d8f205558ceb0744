#include <zlib.h>

#include <cmath>
#include <cstring>
#include <limits>

#include "report/packed.hpp"
#include "support/catch.hpp"

using namespace trunk;

namespace {

/// Decodes base64 as a browser does (RFC 4648), by a way of its own.
std::string from_base64(const std::string& text) {
  const std::string letters = "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";
  std::string bytes;
  unsigned bits = 0, count = 0;
  for (const char c : text) {
    if (c == '=') break;
    REQUIRE(letters.find(c) != std::string::npos);
    bits = bits << 6 | static_cast<unsigned>(letters.find(c));
    count += 6;
    if (count < 8) continue;
    count -= 8;
    bytes += static_cast<char>(bits >> count & 0xFF);
  }
  return bytes;
}

/// Returns the block that a page finds: base64, then gzip.
std::string block_of(const Packed& packed) {
  const std::string bytes = from_base64(packed.text());
  std::string block(packed.bytes() + 1, '\0');
  z_stream stream{};
  REQUIRE(inflateInit2(&stream, 15 + 16) == Z_OK);  // a gzip head and nothing else
  stream.next_in = reinterpret_cast<Bytef*>(const_cast<char*>(bytes.data()));
  stream.avail_in = static_cast<uInt>(bytes.size());
  stream.next_out = reinterpret_cast<Bytef*>(block.data());
  stream.avail_out = static_cast<uInt>(block.size());
  CHECK(inflate(&stream, Z_FINISH) == Z_STREAM_END);
  block.resize(stream.total_out);
  inflateEnd(&stream);
  return block;
}

/// Reads an array at its reference, as a typed array of a browser does.
template <class Number>
std::vector<Number> values_at(const Packed::Json& reference, const std::string& block) {
  const auto first = reference["at"].get<std::size_t>(), count = reference["n"].get<std::size_t>();
  CHECK(first % sizeof(Number) == 0);
  REQUIRE(first + count * sizeof(Number) <= block.size());
  std::vector<Number> values(count);
  if (count > 0) std::memcpy(values.data(), block.data() + first, count * sizeof(Number));
  return values;
}

}  // namespace

TEST_CASE("Packed arrays of every kind come back bit for bit", "[report]") {
  const std::vector<double> wide{0.1, -1e300, std::numeric_limits<double>::infinity(), 5e-324};
  const std::vector<std::uint8_t> bytes{0, 255, 7};
  const std::vector<std::int16_t> shorts{-32768, 32767, 0};
  const std::vector<std::int32_t> whole{-2147483647, 42};
  Packed packed;
  // An odd number of bytes comes first, so that what follows must be aligned.
  const auto b = packed.add(bytes), d = packed.add(wide), s = packed.add(shorts), w = packed.add(whole);
  const auto f = packed.add_single({1.0 / 3.0, std::nan("")}), none = packed.add(std::vector<double>());

  const std::string block = block_of(packed);
  CHECK(block.size() == packed.bytes());
  CHECK(values_at<std::uint8_t>(b, block) == bytes);
  CHECK(values_at<double>(d, block) == wide);
  CHECK(values_at<std::int16_t>(s, block) == shorts);
  CHECK(values_at<std::int32_t>(w, block) == whole);
  const auto single = values_at<float>(f, block);
  CHECK(single[0] == static_cast<float>(1.0 / 3.0));
  CHECK(std::isnan(single[1]));
  CHECK(none["n"] == 0);
  std::vector<std::string> kinds;
  for (const auto* reference : {&b, &d, &s, &w, &f}) kinds.push_back((*reference)["as"]);
  CHECK(kinds == std::vector<std::string>{"u1", "f8", "i2", "i4", "f4"});
}

TEST_CASE("Equal arrays give equal text", "[report]") {
  Packed one, other;
  for (Packed* packed : {&one, &other}) packed->add(std::vector<double>(1000, 2.5));
  CHECK(one.text() == other.text());
  CHECK(one.text().size() < 200);  // 8,000 bytes, compressed
  other.add(std::vector<std::uint8_t>{1});
  CHECK(one.text() != other.text());
}

TEST_CASE("A block without arrays is valid too", "[report]") {
  CHECK(block_of(Packed()).empty());
}
