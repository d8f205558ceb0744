#include <fmt/format.h>

#include <charconv>

#include "surfaces/formats/raw_surface.hpp"
#include "surfaces/formats/words.hpp"
#include "text/message_text.hpp"

namespace trunk {
namespace {

/// Returns the point of a corner, counted from 0. The file writes "7", "7/1/2" or "7//2", counted from 1, or
/// "-1", counted back from the last point.
double corner_of(std::string_view word, const Words& words, std::size_t points) {
  const std::string_view digits = word.substr(0, word.find('/'));
  long value = 0;
  const auto [end, error] = std::from_chars(digits.data(), digits.data() + digits.size(), value);
  if (error != std::errc{} || end != digits.data() + digits.size() || value == 0)
    words.fail(fmt::format("corner {} found", excerpt(word)), "the number of a point, from 1", "correct it");
  return static_cast<double>(value) + (value > 0 ? -1.0 : static_cast<double>(points));
}

/// Returns the next word of a face. A line that ends in a backslash continues in the next line.
std::string_view next_of_face(Words& words) {
  std::string_view word = words.word_of_line();
  while (word == "\\") {
    words.skip_line();
    word = words.word_of_line();
  }
  return word.starts_with('#') ? std::string_view() : word;
}

/// Returns the number of points in the whole file, since faces may stand before their points.
std::size_t points_of_obj(const std::string& bytes) {
  std::size_t points = 0;
  for (Words words(bytes, ""); !words.at_end(); words.skip_line()) points += words.next() == "v";
  return points;
}

}  // namespace

RawSurface read_obj(const std::string& bytes, const std::string& file) {
  SurfaceBuilder builder(file, "OBJ");
  const std::size_t points = points_of_obj(bytes);
  Words words(bytes, file);
  for (; !words.at_end(); words.skip_line()) {
    const std::string_view statement = words.next();
    if (statement == "v") {
      const double x = words.number_of_line("a coordinate"), y = words.number_of_line("a coordinate"),
                   z = words.number_of_line("a coordinate");
      builder.point({x, y, z}, words.line());
    } else if (statement == "f") {
      std::vector<double> corners;
      for (std::string_view word = next_of_face(words); !word.empty(); word = next_of_face(words))
        corners.push_back(corner_of(word, words, builder.points()));
      builder.polygon(corners, words.line(), points);
    } else if (statement == "o" || statement == "g") {
      Words name = words;
      builder.begin_part(name.rest_of_line());
    } else if (statement.starts_with('#')) {
      Words comment = words;
      builder.remark(comment.rest_of_line());
    }
  }
  return builder.finish();
}

}  // namespace trunk
