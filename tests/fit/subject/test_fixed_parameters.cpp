#include "subject/fixed_parameters.hpp"

#include "results/write/write_fit.hpp"
#include "support/catch.hpp"
#include "support/result_records.hpp"
#include "support/temporary_folder.hpp"

using namespace trunk;
using namespace trunk::test;
using Names = std::vector<std::string>;

namespace {

Mistake mistake_in_fix(const std::string& text) {
  try {
    fixed_parameter(text);
  } catch (const InputError& error) {
    return error.mistake();
  }
  return {{}, "no error", "", "", {}};
}

}  // namespace

TEST_CASE("A parameter is fixed at a number", "[unit]") {
  const FixedParameter fixed = fixed_parameter("k_elasticity=3500");
  CHECK(fixed.name() == "k_elasticity");
  CHECK(fixed.value == 3500.0);
  CHECK_FALSE(fixed.source);
}

TEST_CASE("A parameter is fixed at its value in a result file", "[unit]") {
  const TemporaryFolder folder;
  const std::string file = (folder / "fit.h5").string();
  FitRecord fit = sample_fit();  // k_elasticity 4000, k_muscle 500
  fit.gates.clear();
  write_fit(file, fit);
  const FixedParameter fixed = fixed_parameter("k_muscle=@" + file);
  CHECK(fixed.value == 500.0);
  CHECK(fixed.source == file);

  const Mistake absent = mistake_in_fix("damping=@" + file);  // the file has no such parameter
  CHECK(absent.at == Place{"--fix damping=@" + file});
  CHECK(absent.found == file + " holds no value of damping");
}

TEST_CASE("A fit behind a gate lends no parameter", "[unit]") {
  const TemporaryFolder folder;
  const std::string file = (folder / "fit.h5").string();
  FitRecord fit = sample_fit();
  fit.gates = {{"machine_driven", "not driven by a muscle?"}};
  write_fit(file, fit);
  CHECK(mistake_in_fix("k_muscle=@" + file).found == file + " withholds k_muscle: not driven by a muscle?");
}

TEST_CASE("A file that cannot be read is named with the option that names it", "[unit]") {
  const TemporaryFolder folder;
  const std::string file = (folder / "none.h5").string();
  const Mistake mistake = mistake_in_fix("k_muscle=@" + file);
  CHECK(mistake.at == Place{file});
  CHECK(mistake.named_in == Place{"--fix k_muscle=@" + file});
}

TEST_CASE("What fixes no parameter is refused with the option as it was typed", "[unit]") {
  for (const auto& [text, found] : {std::pair{"k_muscle", "no value is given"},
                                    {"k_muscle=", "'' is not a number"},
                                    {"k_muscle=soft", "'soft' is not a number"},
                                    {"k_muscle=3 N/m", "'3 N/m' is not a number"},
                                    {"k_elasticity=19", "19 N/m is out of bounds"},
                                    {"k_elasticity=nan", "nan N/m is out of bounds"},
                                    {"k_elasticity=-4000", "-4000 N/m is out of bounds"}}) {
    INFO(text);
    const Mistake mistake = mistake_in_fix(text);
    CHECK(mistake.at == Place{std::string("--fix ") + text});
    CHECK(mistake.found == found);
    CHECK_FALSE(mistake.expected.empty());
  }
  CHECK(mistake_in_fix("k_elasticity=100001").expected == "20 to 100000 N/m");
  CHECK(mistake_in_fix("strength=3").at == Place{"--fix strength=3"});
  CHECK(mistake_in_fix("strength=3").found.find("'strength'") != std::string::npos);
}

TEST_CASE("What is fixed is not fitted", "[unit]") {
  Mistakes mistakes;
  CHECK(names_to_fit({}, {}, false, mistakes) == Names{"k_elasticity", "k_muscle"});
  CHECK(names_to_fit({}, {}, true, mistakes) == Names{"k_muscle"});
  CHECK(names_to_fit({}, {fixed_parameter("k_elasticity=4000")}, false, mistakes) == Names{"k_muscle"});
  CHECK(names_to_fit({"damping", "timing"}, {fixed_parameter("k_muscle=30")}, false, mistakes) ==
        Names{"damping", "onset", "rise", "fast_fall", "slow_fall"});
  CHECK(mistakes.empty());
}

TEST_CASE("All mistakes in the names of parameters are gathered", "[unit]") {
  Mistakes mistakes;
  names_to_fit({"k_muscle", "beauty", "damping", "damping"}, {fixed_parameter("k_muscle=30")}, false,
               mistakes);
  const auto found = mistakes.sorted();
  REQUIRE(found.size() == 3);
  CHECK(text_of(found[0]).find("'beauty'") != std::string::npos);
  CHECK(found[1].found == "parameter 'k_muscle' is both free and fixed");
  CHECK(found[2].found == "parameter 'damping' is named twice");

  Mistakes none;
  names_to_fit({}, {fixed_parameter("k_muscle=30"), fixed_parameter("k_elasticity=4000")}, false, none);
  REQUIRE(none.sorted().size() == 1);
  CHECK(none.sorted()[0].found == "no parameter is free");
}
