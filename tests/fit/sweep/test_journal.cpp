#include <algorithm>
#include <fstream>
#include <iterator>

#include "support/catch.hpp"
#include "support/temporary_folder.hpp"
#include "sweep/journal.hpp"

using namespace trunk;

namespace {

SweepRow sweep_row(std::uint64_t run, const std::string& status, double ended_at, double measure = 1.0) {
  return {run, status, "", ended_at, false, {measure, 2.0}, {3.0}};
}

void append_rows(const std::filesystem::path& journal, const std::vector<SweepRow>& rows) {
  Journal(journal, "me").append(rows);
}

std::string bytes_in(const std::filesystem::path& path) {
  std::ifstream file(path, std::ios::binary);
  return {std::istreambuf_iterator<char>(file), {}};
}

std::vector<std::uint64_t> runs_on_file(const std::filesystem::path& journal) {
  std::vector<std::uint64_t> runs;
  read_journal(journal, "me", [&](const SweepRow& r) {
    CHECK(r.measures == std::vector<double>{1.0, 2.0});
    runs.push_back(r.run);
  });
  return runs;
}

}  // namespace

TEST_CASE("A row keeps its intervals, beside rows that have none", "[unit]") {
  const test::TemporaryFolder folder;
  SweepRow with = sweep_row(1, "completed", 2);
  with.intervals = {0.5, 1.5, 0.0};
  append_rows(folder / "j", {sweep_row(0, "completed", 1), with, sweep_row(2, "completed", 3)});
  std::vector<std::vector<double>> read;
  read_journal(folder / "j", "me", [&](const SweepRow& r) { read.push_back(r.intervals); });
  CHECK(read == std::vector<std::vector<double>>{{}, {0.5, 1.5, 0.0}, {}});
}

TEST_CASE("A damaged byte of a journal costs one row, and rows can still be appended", "[unit]") {
  const test::TemporaryFolder folder;
  append_rows(folder / "whole", {});
  const std::size_t heading = bytes_in(folder / "whole").size();
  append_rows(folder / "whole",
              {sweep_row(0, "completed", 1), sweep_row(1, "completed", 2), sweep_row(2, "completed", 3)});
  const std::string whole = bytes_in(folder / "whole");
  REQUIRE(runs_on_file(folder / "whole") == std::vector<std::uint64_t>{0, 1, 2});
  const std::size_t size = (whole.size() - heading) / 3;
  for (std::size_t at = heading; at < whole.size(); ++at) {
    std::string bytes = whole;
    bytes[at] = static_cast<char>(bytes[at] ^ (at % 3 > 0 ? 1 : 128));
    append_rows(folder.write("damaged", bytes), {sweep_row(3, "completed", 4)});
    std::vector<std::uint64_t> left{0, 1, 2, 3};
    left.erase(left.begin() + static_cast<std::ptrdiff_t>((at - heading) / size));
    INFO(at << " of " << heading << " + 3 x " << size);
    CHECK(runs_on_file(folder / "damaged") == left);
  }
  for (std::size_t cut = heading + 2 * size; cut < whole.size(); ++cut) {  // and half a row is none
    append_rows(folder.write("cut", whole.substr(0, cut)), {sweep_row(3, "completed", 4)});
    CHECK(runs_on_file(folder / "cut") == std::vector<std::uint64_t>{0, 1, 3});
  }
}

TEST_CASE("The row of a run that counts does not depend on the journals its rows are in", "[unit]") {
  std::vector<std::string> journals{"1-of-1", "1-of-2", "10-of-16", "2-of-2"};
  do {
    const test::TemporaryFolder folder;
    append_rows(folder / journals[0], {sweep_row(0, "timeout", 9, 1), sweep_row(1, "timeout", 5, 1),
                                       sweep_row(2, "diverged", 1, 1)});
    append_rows(folder / journals[1], {sweep_row(0, "completed", 3, 2), sweep_row(1, "invalid", 6, 2),
                                       sweep_row(2, "timeout", 1, 2)});
    append_rows(folder / journals[2], {sweep_row(0, "completed", 2, 3), sweep_row(1, "timeout", 4, 3),
                                       sweep_row(99, "completed", 1)});
    append_rows(folder / journals[3], {sweep_row(1, "timeout", 6, 2), sweep_row(1, "timeout", 5.5, 4)});
    std::vector<double> counts(3, 0.0);
    read_journals(folder / "", "me", counts.size(),
                  [&](const SweepRow& r) { counts.at(r.run) = r.measures[0]; });
    CHECK(counts[0] == 2.0);
    CHECK(counts[1] == 2.0);
    CHECK(counts[2] == (journals[0] < journals[1] ? 2.0 : 1.0));  // at once: the one read last
  } while (std::next_permutation(journals.begin(), journals.end()));
}
