#include "cohort/list.hpp"

#include "errors/input_error.hpp"
#include "support/catch.hpp"
#include "support/temporary_folder.hpp"

using namespace trunk;
using namespace trunk::test;
using Texts = std::vector<std::string>;

namespace {

Mistake mistake_in_list(const std::string& text) {
  const TemporaryFolder folder;
  try {
    read_cohort_list(folder.write("list.csv", text));
  } catch (const InputError& error) {
    Mistake mistake = error.mistake();
    mistake.at.file = std::filesystem::path(mistake.at.file).filename().string();
    return mistake;
  }
  return {{}, "no error", "", "", {}};
}

}  // namespace

TEST_CASE("A list gives its columns, and a row of cells to each subject", "[unit]") {
  const TemporaryFolder folder;
  const std::string text = "# made by hand\nsubject;trace;fix\nA;a.csv;k_muscle=3\n\nB b;b.csv\n";
  const CohortList list = read_cohort_list(folder.write("list.csv", text));
  CHECK(list.text == text);
  CHECK(list.header_line == 2);
  CHECK(list.columns == Texts{"subject", "trace", "fix"});
  REQUIRE(list.subjects.size() == 2);
  CHECK(list.subjects[0].name == "A");
  CHECK(list.subjects[0].line == 3);
  CHECK(list.subjects[0].cells == Texts{"A", "a.csv", "k_muscle=3"});
  CHECK(list.subjects[1].name == "B b");
  CHECK(list.subjects[1].line == 5);
  CHECK(list.subjects[1].cells == Texts{"B b", "b.csv", ""});  // what the row leaves out is empty
}

TEST_CASE("A list that cannot be used is refused with its line", "[unit]") {
  const auto at = [](std::size_t line) { return Place{"list.csv", line}; };
  CHECK(mistake_in_list("trace\na.csv\n").at == at(1));
  CHECK(mistake_in_list("subject,trace\n").found == "the list names no subject");
  CHECK(mistake_in_list("subject,trace,trace\nA,a,b\n").found == "column 'trace' stands twice");
  const Mistake twice = mistake_in_list("subject,trace\nA,a.csv\nB,b.csv\nA,c.csv\n");
  CHECK(twice.at == at(4));
  CHECK(twice.found == "subject 'A' stands in line 2 as well");
  CHECK(mistake_in_list("subject,trace\nA,a.csv\n,b.csv\n").found == "this row names no subject");
}

TEST_CASE("A subject must be able to name a file that no spreadsheet takes for a formula", "[unit]") {
  for (const std::string name : {"a/b", "a\\b", "../a", ".a", "-a", "+a", "=a", "@a", "cohort", "a\x01"}) {
    INFO(name);
    const Mistake mistake = mistake_in_list("subject,trace\nA,a.csv\n" + name + ",b.csv\n");
    CHECK(mistake.at == Place{"list.csv", 3});
    CHECK(mistake.found.find("cannot name a result file") != std::string::npos);
  }
  CHECK(mistake_in_list("subject,trace\n" + std::string(101, 'a') + ",a.csv\n").at == Place{"list.csv", 2});
  CHECK(mistake_in_list("subject,trace\n" + std::string(100, 'a') + ",a.csv\n").found == "no error");
}
