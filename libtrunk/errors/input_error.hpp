#pragma once

#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

namespace trunk {

/// Something the user gave us cannot be used. The text is one line and reads
/// `file:line: what was found, what was expected, what to do`; the program prints it and exits with 2.
class InputError : public std::runtime_error {
 public:
  using std::runtime_error::runtime_error;

  /// An error at a line of a file; `line` counts from 1, 0 means the file as a whole.
  InputError(const std::string& file, std::size_t line, const std::string& text)
      : std::runtime_error(file + (line > 0 ? ":" + std::to_string(line) : "") + ": " + text) {}
};

/// Several mistakes found in one pass. The text is that of the first, and how many there are more.
class InputErrors : public InputError {
 public:
  explicit InputErrors(std::vector<std::string> texts)  // at least one
      : InputError(texts.front() + (texts.size() > 1 ? " (and " + std::to_string(texts.size() - 1) +
                                                           " more: `trunk check` lists all)"
                                                     : "")),
        texts_(std::move(texts)) {}

  const std::vector<std::string>& texts() const noexcept { return texts_; }  ///< each as InputError has it

 private:
  std::vector<std::string> texts_;
};

/// Gathers the InputErrors of the parts of one pass, so that a mistake does not hide the next one.
class Mistakes {
 public:
  static constexpr std::size_t most = 100;  ///< further ones are dropped: our choice of what is still read

  /// Runs a part; its InputError is kept. True where there was none.
  template <class Part>
  bool gather(Part&& part) {
    try {
      part();
      return true;
    } catch (const InputErrors& errors) {
      for (const std::string& text : errors.texts()) add(text);
    } catch (const InputError& error) {
      add(error.what());
    }
    return false;
  }

  void add(const std::string& text) {
    if (texts_.size() < most) texts_.push_back(text);
  }

  const std::vector<std::string>& texts() const noexcept { return texts_; }

  /// Throws InputErrors where something was gathered.
  void settle() const {
    if (!texts_.empty()) throw InputErrors(texts_);
  }

 private:
  std::vector<std::string> texts_;
};

}  // namespace trunk
