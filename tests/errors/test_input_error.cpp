#include "errors/input_error.hpp"
#include "support/catch.hpp"

using namespace trunk;

TEST_CASE("The text of a mistake names place, what was found, what was expected and what to do", "[unit]") {
  const InputError error({"a.csv", 12}, "'x' found", "a number", "correct the row");
  CHECK(std::string(error.what()) == "a.csv:12: 'x' found; expected a number; correct the row");
  CHECK(error.mistake().at == Place{"a.csv", 12});
  CHECK(error.mistake().expected == "a number");
  CHECK(text_of({{"a.csv", 0}, "no such file", "", "", {}}) == "a.csv: no such file");
  CHECK(text_of({{}, "--rate 0", "a rate above 0", "", {}}) == "--rate 0; expected a rate above 0");
  CHECK(text_of({{"b.pml", 3}, "no atoms", "", "", {"a.toml", 2}}) ==
        "b.pml:3: no atoms (named in a.toml:2)");
}

TEST_CASE("Control characters of the input do not reach the text of an error", "[unit]") {
  const InputError error({"a\x1b[2Jb.csv", 1}, "'\x07\r' found", "one\nline", "\xc2\x9b!\x7f");
  CHECK(std::string(error.what()) == "a?[2Jb.csv:1: '?\?' found; expected one line; ?!?");
  CHECK(error.mistake().at.file == "a\x1b[2Jb.csv");
  // Bytes that are not UTF-8 would break the output for whoever reads it.
  CHECK(text_of({{},
                 "a\xe1t \xff gr\xc3\xb6\xc3\x9f"
                 "er \xe2\x82\xac \xed\xa0\x80",
                 "",
                 "",
                 {}}) ==
        "a?t ? gr\xc3\xb6\xc3\x9f"
        "er \xe2\x82\xac ???");
}

TEST_CASE("Mistakes are gathered once each and sorted by file and line", "[unit]") {
  Mistakes mistakes;
  CHECK(mistakes.gather([] {}));
  CHECK_NOTHROW(mistakes.settle());
  const auto add = [&](const std::string& file, std::size_t line) {
    CHECK_FALSE(mistakes.gather([&] { throw InputError({file, line}, "found"); }));
  };
  add("b", 7);
  add("", 0);
  add("a", 2);
  add("b", 3);
  add("b", 7);
  std::vector<std::string> places;
  for (const Mistake& m : mistakes.sorted()) places.push_back(m.at.text());
  CHECK(places == std::vector<std::string>{"b:3", "b:7", "a:2", ""});
  try {
    mistakes.settle();
    FAIL("settle throws");
  } catch (const InputErrors& errors) {
    CHECK(errors.mistakes().size() == 4);
    CHECK(std::string(errors.what()) == "b:3: found (and 3 more: `trunk check` lists all)");
    Mistakes again;
    again.gather([&] { throw errors; });
    CHECK(again.sorted() == errors.mistakes());
  }
}

TEST_CASE("An error that is thrown again gets a place and the file that names it", "[unit]") {
  const Mistake placed{{"a.csv", 3}, "3 cells found", "2", "", {}}, unplaced{{}, "no lung", "", "", {}};
  try {
    rethrow_at({"s.toml", 7}, InputErrors({placed, unplaced}));
  } catch (const InputError& error) {
    REQUIRE(error.mistakes().size() == 2);
    CHECK(error.mistakes()[0] == placed);
    CHECK(error.mistakes()[1] == Mistake{{"s.toml", 7}, "no lung", "", "", {}});
  }
  try {
    rethrow_named_in({"s.toml", 7}, InputError(placed));
  } catch (const InputError& error) {
    CHECK(text_of(error.mistake()) == "a.csv:3: 3 cells found; expected 2 (named in s.toml:7)");
  }
}

TEST_CASE("Mistakes beyond what a user reads are dropped", "[unit]") {
  Mistakes mistakes;
  for (std::size_t line = 1; line <= 2 * Mistakes::most; ++line)
    mistakes.add({{"a", line}, "found", "", "", {}});
  CHECK(mistakes.sorted().size() == Mistakes::most);
}
