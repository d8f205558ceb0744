#pragma once

#include <cstddef>
#include <string>
#include <string_view>

/// Private to the surfaces layer: words and numbers of a text, and the line of each.
namespace trunk {

/// Reads words between white space. Lines end in LF, CRLF or CR. The text must outlive this object.
class Words {
 public:
  Words(std::string_view text, std::string file, std::size_t position = 0)
      : text_(text), file_(std::move(file)), position_(position) {}

  std::size_t line() const noexcept { return line_; }          ///< of the last word, from 1; 0 after bytes
  std::size_t position() const noexcept { return position_; }  ///< the byte after the last word
  bool at_end();                                               ///< only white space is left

  /// Returns the next word of any line; empty at the end of the text.
  std::string_view next();
  /// Returns the next word of this line; empty at the end of the line.
  std::string_view word_of_line();
  /// Returns the rest of this line without white space around it, and goes to the next line.
  std::string_view rest_of_line();
  void skip_line() { rest_of_line(); }

  /// Returns the next bytes; throws InputError if there are fewer.
  std::string_view bytes(std::size_t count);
  /// Goes on at a byte.
  void go_to(std::size_t position) noexcept { position_ = position; }

  /// Returns the next word of any line, or of this line, as a finite number. The exponent may be written as
  /// in Fortran (1.5D+02), and the decimal mark may be a comma. Messages name `what` is expected, such as "a
  /// coordinate". Throws InputError if there is no such number.
  double number(const char* what);
  double number_of_line(const char* what);
  /// Returns the next word as a whole number from 0 to `most`; throws InputError if it is not one.
  std::size_t count(const char* what, std::size_t most);

  /// Throws InputError at the line of the last word.
  [[noreturn]] void fail(std::string found, std::string expected = "", std::string remedy = "") const;

 private:
  double number(std::string_view word, const char* what) const;
  void skip_blanks(const char* blanks);

  std::string_view text_;
  std::string file_;
  std::size_t position_ = 0, line_ = 1;
};

/// Returns whether two words are equal apart from upper and lower case.
bool same_word(std::string_view a, std::string_view b) noexcept;

/// Returns whether the bytes are a binary STL. Their number must match the count of triangles. A file that is
/// cut short or has additional bytes counts as well if it is not text and its count is possible.
bool is_binary_stl(std::string_view bytes);

}  // namespace trunk
