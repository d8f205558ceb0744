#pragma once

#include <cstddef>
#include <stdexcept>
#include <string>
#include <vector>

namespace trunk {

/// Where in the user's input something stands: a file and its line, or an option as it was typed.
struct Place {
  std::string file;      ///< path, or an option ("--set time.dt_ms=2"); empty: not known
  std::size_t line = 0;  ///< from 1; 0: the file as a whole

  /// Returns "file:line", "file" or "".
  std::string text() const;
  friend bool operator==(const Place&, const Place&) = default;
};

/// One thing in the user's input that cannot be used.
struct Mistake {
  Place at;
  std::string found;     ///< what stands there, as a sentence without its full stop
  std::string expected;  ///< what may stand there, without the word "expected"; empty: `found` says it
  std::string remedy;    ///< what to do; empty: `expected` says it
  Place named_in;        ///< the file that names `at.file`, if the user did not name it

  friend bool operator==(const Mistake&, const Mistake&) = default;
};

/// Returns the one line that a user reads: "file:line: found; expected this; remedy". This is the only place
/// where the text of an error is formed. Control characters of the input do not reach the terminal.
std::string text_of(const Mistake& mistake);

/// Thrown when the program cannot use something that the user gave. The program prints what() and exits with
/// 2.
class InputError : public std::runtime_error {
 public:
  explicit InputError(Mistake mistake);
  InputError(Place at, std::string found, std::string expected = "", std::string remedy = "");

  /// Returns the first of mistakes().
  const Mistake& mistake() const noexcept { return mistakes_.front(); }
  /// Returns all mistakes of one pass over the input, at least one.
  const std::vector<Mistake>& mistakes() const noexcept { return mistakes_; }

 protected:
  explicit InputError(std::vector<Mistake> mistakes);

 private:
  std::vector<Mistake> mistakes_;
};

/// Thrown when one pass over the input found several mistakes. what() is the text of the first one and says
/// how many more there are.
class InputErrors : public InputError {
 public:
  /// `mistakes` holds at least one.
  explicit InputErrors(std::vector<Mistake> mistakes) : InputError(std::move(mistakes)) {}
};

/// Throws `error` again, with `at` as the place of every mistake that has none.
[[noreturn]] void rethrow_at(const Place& at, const InputError& error);

/// Throws `error` again, with `named_in` as the place that names the file of every mistake. A mistake that
/// knows this place already keeps it.
[[noreturn]] void rethrow_named_in(const Place& named_in, const InputError& error);

/// Gathers the mistakes of the parts of one pass, so that one mistake does not hide the next.
class Mistakes {
 public:
  static constexpr std::size_t most = 100;  ///< our choice of what a user still reads; later ones are dropped

  /// Runs a part and keeps the mistakes of its InputError. Returns true if there was none.
  template <class Part>
  bool gather(Part&& part) {
    try {
      part();
      return true;
    } catch (const InputError& error) {
      for (const Mistake& mistake : error.mistakes()) add(mistake);
    }
    return false;
  }

  /// Adds a mistake, unless the same is there already.
  void add(Mistake mistake);

  /// Returns the mistakes file by file, in the order in which files first appear, each file by line; mistakes
  /// without a file come last.
  std::vector<Mistake> sorted() const;

  bool empty() const noexcept { return mistakes_.empty(); }

  /// Throws InputErrors if there are mistakes.
  void settle() const;

 private:
  std::vector<Mistake> mistakes_;
};

}  // namespace trunk
