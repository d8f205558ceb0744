#pragma once

#include <algorithm>
#include <stdexcept>
#include <string>
#include <tuple>
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

/// The text of an InputError taken apart; line 0 and an empty file where it names none.
struct Mistake {
  std::string file;
  std::size_t line = 0;
  std::string text;
};

/// The first ":number: " ends the place.
inline Mistake mistake_of(const std::string& what) {
  for (auto colon = what.find(':'); colon != std::string::npos; colon = what.find(':', colon + 1)) {
    std::size_t end = colon + 1, line = 0;
    while (end < what.size() && what[end] >= '0' && what[end] <= '9' && end - colon < 10)
      line = 10 * line + static_cast<std::size_t>(what[end++] - '0');
    if (line > 0 && what.compare(end, 2, ": ") == 0)
      return {what.substr(0, colon), line, what.substr(end + 2)};
  }
  return {"", 0, what};
}

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

  /// Once, where the same is found twice.
  void add(const std::string& text) {
    if (texts_.size() < most && std::find(texts_.begin(), texts_.end(), text) == texts_.end())
      texts_.push_back(text);
  }

  /// File by file in the order in which they first appear, each by line; last those that name none.
  std::vector<std::string> sorted() const {
    std::vector<std::string> files;
    std::vector<std::tuple<std::size_t, std::size_t, std::string>> placed;
    for (const std::string& text : texts_) {
      const Mistake mistake = mistake_of(text);
      const auto known = std::find(files.begin(), files.end(), mistake.file);
      const auto number = static_cast<std::size_t>(known - files.begin());
      if (known == files.end()) files.push_back(mistake.file);
      placed.emplace_back(mistake.file.empty() ? most : number, mistake.line, text);
    }
    std::stable_sort(placed.begin(), placed.end(), [](const auto& a, const auto& b) {
      return std::pair(std::get<0>(a), std::get<1>(a)) < std::pair(std::get<0>(b), std::get<1>(b));
    });
    std::vector<std::string> texts;
    for (auto& [file, line, text] : placed) texts.push_back(std::move(text));
    return texts;
  }

  bool empty() const noexcept { return texts_.empty(); }

  /// Throws InputErrors where something was gathered.
  void settle() const {
    if (!texts_.empty()) throw InputErrors(sorted());
  }

 private:
  std::vector<std::string> texts_;
};

}  // namespace trunk
