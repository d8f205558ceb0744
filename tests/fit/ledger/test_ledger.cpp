#include "ledger/ledger.hpp"

#include <fstream>

#include "errors/input_error.hpp"
#include "problem/objective.hpp"
#include "support/catch.hpp"
#include "support/temporary_folder.hpp"
#include "support/trunk_objective.hpp"
#include "support/trunks.hpp"

using namespace trunk;

TEST_CASE("Entries survive their ledger, bit for bit", "[unit]") {
  const test::TemporaryFolder folder;
  const auto path = folder / "f.ledger";
  const std::string key("\0a\xff", 3);
  {
    Ledger ledger(path, "problem");
    CHECK(ledger.found() == 0);
    ledger.add(key, {1, 4.5, 0.02, {0.1, -1e-300, 3.0}});
    ledger.add("failed", {2, 0.3, 0.01, {}});
  }
  Ledger ledger(path, "problem");
  CHECK(ledger.found() == 2);
  REQUIRE(ledger.find(key));
  CHECK(ledger.find(key)->values == std::vector<double>{0.1, -1e-300, 3.0});
  CHECK(ledger.find(key)->lasted_s == 4.5);
  CHECK(ledger.find("failed")->values.empty());
  CHECK_FALSE(ledger.find("other"));
  CHECK_THROWS_WITH(Ledger(path, "problem"), Contains("in use"));
  ledger.discard();
  CHECK_FALSE(std::filesystem::exists(path));
}

TEST_CASE("A ledger of another problem starts empty, and another file is refused", "[unit]") {
  const test::TemporaryFolder folder;
  const auto path = folder / "f.ledger";
  Ledger(path, "problem").add("key", {1, 1.0, 0.0, {1.0}});
  CHECK(Ledger(path, "other").found() == 0);
  CHECK(Ledger(path, "problem").found() == 0);
  const auto text = folder / "text.ledger";
  std::ofstream(text)
      << "years of work, and long enough to be no empty file at all, so that it is not taken over\n";
  CHECK_THROWS_AS(Ledger(text, "problem"), InputError);
  CHECK_THROWS_WITH(Ledger(text, "problem"), Contains("is not a ledger"));
}

TEST_CASE("An entry of a ledger is checked before it is used", "[unit]") {
  Scenario s = test::shipped("healthy");
  s.time = {4e-3, 0.2};
  const Trunk trunk = make_trunk(s);
  const MeasuredCurve measured{{0.0, 0.1, 0.2}, {0.0, 1e-5, 2e-5}, {}};
  const SearchSpace space({"k_muscle"}, {s.parameters, s.activation});
  Ledger good;
  test::TrunkObjective first(trunk, s.time, space, measured, good);
  const auto model = first->model(space.start());
  REQUIRE(model);
  CHECK(first.simulated() == 1);
  const std::string key = ledger_key(space.decode(space.start()));
  for (const LedgerEntry& bad :
       {LedgerEntry{1, 0.2, 0.0, {1.0}}, LedgerEntry{1, 0.2, 0.0, {0.0, 1.0, std::nan("")}},
        LedgerEntry{7, 0.2, 0.0, {}}, LedgerEntry{2, 0.1, 0.0, {0.0, 0.0, 0.0}}}) {
    Ledger ledger;
    ledger.add(key, bad);
    test::TrunkObjective objective(trunk, s.time, space, measured, ledger);
    CHECK(*objective->model(space.start()) == *model);
    CHECK(objective.simulated() == 1);
  }
  test::TrunkObjective again(trunk, s.time, space, measured, good);
  CHECK(*again->model(space.start()) == *model);
  CHECK(again.simulated() == 0);
  CHECK(again->evaluations().size() == 1);  // it was asked for, though not simulated
}
