#include "errors/input_error.hpp"

#include <algorithm>

#include "text/message_text.hpp"

namespace trunk {
namespace {

std::string what_of(const std::vector<Mistake>& mistakes) {
  std::string text = text_of(mistakes.front());
  if (mistakes.size() > 1)
    text += " (and " + std::to_string(mistakes.size() - 1) + " more: `trunk check` lists all)";
  return text;
}

void append(std::string& text, const char* joint, const std::string& part) {
  if (!part.empty()) text += (text.empty() ? "" : joint) + part;
}

}  // namespace

std::string Place::text() const {
  return line > 0 ? file + ":" + std::to_string(line) : file;
}

std::string text_of(const Mistake& mistake) {
  std::string text = mistake.found;
  append(text, "; ", mistake.expected.empty() ? "" : "expected " + mistake.expected);
  append(text, "; ", mistake.remedy);
  if (!mistake.named_in.file.empty()) text += " (named in " + mistake.named_in.text() + ")";
  const std::string place = mistake.at.text();
  return without_controls(place.empty() ? text : place + ": " + text);
}

InputError::InputError(std::vector<Mistake> mistakes)
    : std::runtime_error(what_of(mistakes)), mistakes_(std::move(mistakes)) {}

InputError::InputError(Mistake mistake) : InputError(std::vector<Mistake>{std::move(mistake)}) {}

InputError::InputError(Place at, std::string found, std::string expected, std::string remedy)
    : InputError(Mistake{std::move(at), std::move(found), std::move(expected), std::move(remedy), {}}) {}

void rethrow_at(const Place& at, const InputError& error) {
  std::vector<Mistake> mistakes = error.mistakes();
  for (Mistake& mistake : mistakes)
    if (mistake.at == Place{}) mistake.at = at;
  throw InputErrors(std::move(mistakes));
}

void rethrow_named_in(const Place& named_in, const InputError& error) {
  std::vector<Mistake> mistakes = error.mistakes();
  for (Mistake& mistake : mistakes)
    if (mistake.named_in == Place{}) mistake.named_in = named_in;
  throw InputErrors(std::move(mistakes));
}

void Mistakes::add(Mistake mistake) {
  if (mistakes_.size() < most && std::find(mistakes_.begin(), mistakes_.end(), mistake) == mistakes_.end())
    mistakes_.push_back(std::move(mistake));
}

std::vector<Mistake> Mistakes::sorted() const {
  const auto first_of_file = [&](const std::string& file) {
    if (file.empty()) return mistakes_.end();
    return std::find_if(mistakes_.begin(), mistakes_.end(),
                        [&](const Mistake& m) { return m.at.file == file; });
  };
  std::vector<Mistake> sorted = mistakes_;
  std::stable_sort(sorted.begin(), sorted.end(), [&](const Mistake& a, const Mistake& b) {
    return std::pair(first_of_file(a.at.file), a.at.line) < std::pair(first_of_file(b.at.file), b.at.line);
  });
  return sorted;
}

void Mistakes::settle() const {
  if (!mistakes_.empty()) throw InputErrors(sorted());
}

}  // namespace trunk
