#pragma once

#include <cstddef>
#include <string>
#include <string_view>

/// Private to the surfaces layer: words and numbers of a text, with the line of each.
namespace trunk {

/// Words between white space; lines end in LF, CRLF or CR. The text must outlive this.
class Words {
 public:
  Words(std::string_view text, std::string file, std::size_t position = 0)
      : text_(text), file_(std::move(file)), position_(position) {}

  std::size_t line() const noexcept { return line_; }          ///< of the last word, from 1; 0 after bytes
  std::size_t position() const noexcept { return position_; }  ///< in bytes: just after the last word
  bool at_end();                                               ///< nothing but white space is left

  /// The next word, of any line; empty at the end.
  std::string_view next();
  /// The next word of this line; empty where the line ends.
  std::string_view word_of_line();
  /// What is left of this line, without blanks around it => goes to the next line.
  std::string_view rest_of_line();
  void skip_line() { rest_of_line(); }

  /// The next bytes as they are. Throws InputError where there are fewer.
  std::string_view bytes(std::size_t count);
  /// Goes on at a byte.
  void go_to(std::size_t position) noexcept { position_ = position; }

  /// The next word as a finite number, also as Fortran writes it (1.5D+02) and with a decimal comma.
  /// `what` is for messages: "a coordinate". Throws InputError.
  double number(const char* what);
  double number_of_line(const char* what);
  /// The next word as a whole number of 0 to `most`. Throws InputError.
  std::size_t count(const char* what, std::size_t most);

  [[noreturn]] void fail(const std::string& text) const;

 private:
  double number(std::string_view word, const char* what) const;
  void skip_blanks(const char* blanks);

  std::string_view text_;
  std::string file_;
  std::size_t position_ = 0, line_ = 1;
};

/// A word of a file as a message cites it: in quotes, on one line, at most 40 bytes.
std::string quoted(std::string_view word);

/// Case does not matter.
bool same_word(std::string_view a, std::string_view b) noexcept;

/// Where the bytes are a binary STL: as many as its count of triangles says, or, cut short or with some
/// bytes more, no text and a count that can be.
bool is_binary_stl(std::string_view bytes);

}  // namespace trunk
