#include "clinic/clinic.hpp"

#include <cmath>

#include "clinic/lung_mechanics.hpp"
#include "support/catch.hpp"
#include "support/lung_breather.hpp"

using namespace trunk;
using namespace trunk::test;

namespace {

constexpr double joules_per_cmH2O_L = Pa_per_cmH2O * m3_per_litre;

std::vector<ClinicNumber> numbers_of(const LungBreather& who, const ClinicOptions& options = {}) {
  return clinic_numbers(mean_breath(segment_breaths(recorded(who))), options);
}

const ClinicNumber& find(const std::vector<ClinicNumber>& numbers, const std::string& name) {
  for (const ClinicNumber& number : numbers)
    if (number.name == name) return number;
  FAIL("there is no " << name);
  throw;
}

bool has(const std::vector<ClinicNumber>& numbers, const std::string& name) {
  return std::any_of(numbers.begin(), numbers.end(), [&](const ClinicNumber& n) { return n.name == name; });
}

}  // namespace

TEST_CASE("A lung of one elastance and one resistance has the numbers of the closed form", "[clinic]") {
  const auto [elastance, resistance, volume, inspiration] = GENERATE(
      table<double, double, double, double>({{5, 2.5, 0.5, 1.6}, {20, 15, 0.4, 0.9}, {4, 1, 1.5, 1.2}}));
  CAPTURE(elastance, resistance, volume, inspiration);
  LungBreather who;
  who.elastance = elastance, who.resistance = resistance, who.tidal_volume = volume,
  who.inspiration = inspiration;
  const auto numbers = numbers_of(who);
  const auto value = [&](const char* name) {
    const ClinicNumber& number = find(numbers, name);
    CHECK(number.of_mean_breath == Approx(number.mean).epsilon(0.01).margin(0.02));  // all breaths are alike
    return number.mean;
  };
  // A resistance of 15 cmH2O s/L turns an error of 5 ms at the points without flow into 2 %.
  const double per_min = 60 / who.period(), of_litre = joules_per_cmH2O_L / volume;
  CHECK(value("pleural_swing_cmH2O") == Approx(-who.swing()).epsilon(0.015));
  CHECK(value("gastric_swing_cmH2O") == Approx(who.gastric_swing).epsilon(0.015));
  CHECK(value("elastic_work_J_per_L") == Approx(who.elastic_work() * of_litre).epsilon(0.03));
  CHECK(value("resistive_work_J_per_L") == Approx(who.resistive_work(inspiration) * of_litre).epsilon(0.03));
  CHECK(value("expiratory_resistive_work_J_per_L") ==
        Approx(who.resistive_work(who.expiration) * of_litre).epsilon(0.03));
  const double work = who.elastic_work() + who.resistive_work(inspiration);
  CHECK(value("work_of_breathing_J_per_L") == Approx(work * of_litre).epsilon(0.02));
  CHECK(value("work_of_breathing_J_per_min") == Approx(work * joules_per_cmH2O_L * per_min).epsilon(0.02));
  CHECK(value("pressure_time_product_pleural_cmH2O_s") == Approx(who.pressure_time_product()).epsilon(0.03));
  CHECK(value("pressure_time_product_pleural_cmH2O_s_per_min") ==
        Approx(who.pressure_time_product() * per_min).epsilon(0.03));
  const double across = who.pressure_time_product() + 0.5 * who.gastric_swing * inspiration;
  CHECK(value("pressure_time_product_transdiaphragmatic_cmH2O_s_per_min") ==
        Approx(across * per_min).epsilon(0.03));
  CHECK(value("tension_time_cmH2O") == Approx(across / who.period()).epsilon(0.03));
  CHECK(value("dynamic_lung_compliance_ml_per_cmH2O") == Approx(1000 / elastance).epsilon(0.03));
  CHECK(value("dynamic_lung_elastance_cmH2O_per_L") == Approx(elastance).epsilon(0.02));
  CHECK(value("lung_resistance_cmH2O_s_per_L") == Approx(resistance).epsilon(0.02));
  CHECK(value("intrinsic_peep_cmH2O") == Approx(0).margin(0.01));
  CHECK(find(numbers, "pleural_swing_cmH2O").each.size() == static_cast<std::size_t>(who.breaths));
}

TEST_CASE("Intrinsic PEEP is the fall before flow, and adds to work and pressure-time product", "[clinic]") {
  LungBreather who;
  who.peep = 3;
  const auto numbers = numbers_of(who);
  CHECK(find(numbers, "intrinsic_peep_cmH2O").mean == Approx(3).margin(0.35));
  CHECK(find(numbers, "intrinsic_peep_work_J_per_L").mean ==
        Approx(3 * joules_per_cmH2O_L).epsilon(0.12));  // the pressure over every litre
  const double work = who.elastic_work() + who.resistive_work(who.inspiration) + who.peep * who.tidal_volume;
  CHECK(find(numbers, "work_of_breathing_J_per_L").mean ==
        Approx(work * joules_per_cmH2O_L / who.tidal_volume).epsilon(0.05));
  CHECK(find(numbers, "pressure_time_product_pleural_cmH2O_s").mean ==
        Approx(who.pressure_time_product()).epsilon(0.06));
}

TEST_CASE("The chest wall counts only if its compliance is given", "[clinic]") {
  const LungBreather who;
  ClinicOptions options;
  const auto without = numbers_of(who, options);
  CHECK_FALSE(has(without, "chest_wall_work_J_per_L"));
  options.chest_wall_compliance_m3_Pa = 200e-6 / Pa_per_cmH2O;
  const auto with = numbers_of(who, options);
  const double wall = 0.5 * who.tidal_volume / 0.2 * joules_per_cmH2O_L;  // of a litre
  CHECK(find(with, "chest_wall_work_J_per_L").mean == Approx(wall).epsilon(0.01));
  CHECK(find(with, "work_of_breathing_J_per_L").mean - find(without, "work_of_breathing_J_per_L").mean ==
        Approx(wall).epsilon(0.01));
  CHECK(find(with, "pressure_time_product_pleural_cmH2O_s").mean -
            find(without, "pressure_time_product_pleural_cmH2O_s").mean ==
        Approx(0.5 * who.tidal_volume / 0.2 * who.inspiration).epsilon(0.02));
}

TEST_CASE("The tension-time index needs the maximum", "[clinic]") {
  const LungBreather who;
  ClinicOptions options;
  options.pdi_max_Pa = 100 * Pa_per_cmH2O;
  const auto numbers = numbers_of(who, options);
  const double mean_pressure = who.pressure_time_product() / who.inspiration + 0.5 * who.gastric_swing;
  CHECK(find(numbers, "tension_time_index").mean ==
        Approx(mean_pressure / 100 * who.inspiration / who.period()).epsilon(0.03));
  CHECK_FALSE(has(numbers, "tension_time_cmH2O"));
}

TEST_CASE("Two of the three pressures give the third", "[clinic]") {
  const Trace whole = recorded({});
  const auto swing = [](Trace trace, const char* name) {
    return find(clinic_numbers(mean_breath(segment_breaths(trace)), {}), name).mean;
  };
  Trace from_pleural = whole, from_gastric = whole;
  TraceChannel across{ChannelKind::transdiaphragmatic, "pdi", "cmH2O", {}};
  for (std::size_t i = 0; i < whole.time_s.size(); ++i)
    across.value.push_back(whole.channels[1].value[i] - whole.channels[0].value[i]);
  from_pleural.channels[1] = across;
  from_gastric.channels[0] = across;
  for (const char* name : {"pleural_swing_cmH2O", "gastric_swing_cmH2O", "transdiaphragmatic_swing_cmH2O"}) {
    CHECK(swing(from_pleural, name) == Approx(swing(whole, name)).epsilon(1e-9));
    CHECK(swing(from_gastric, name) == Approx(swing(whole, name)).epsilon(1e-9));
  }
}

TEST_CASE("Airway pressure counts in the lung's mechanics", "[clinic]") {
  Trace trace = recorded({});
  trace.channels.push_back({ChannelKind::airway, "paw", "cmH2O", {}});
  double volume = 0;
  for (const double flow : trace.value) {  // support of 6 cmH2O/L beside the muscles
    volume += flow / 100;
    trace.channels[2].value.push_back(Pa_per_cmH2O * 6 * litres_per_m3 * volume);
    trace.channels[0].value[trace.channels[2].value.size() - 1] += trace.channels[2].value.back();
  }
  const auto numbers = clinic_numbers(mean_breath(segment_breaths(trace)), {});
  CHECK(find(numbers, "dynamic_lung_elastance_cmH2O_per_L").mean == Approx(5).epsilon(0.02));
  CHECK(find(numbers, "lung_resistance_cmH2O_s_per_L").mean == Approx(2.5).epsilon(0.02));
}

TEST_CASE("The interval is that of the mean of breaths", "[clinic]") {
  LungBreather who;
  who.noise = 0.3, who.breaths = 9;
  const auto numbers = numbers_of(who);
  const ClinicNumber& work = find(numbers, "work_of_breathing_J_per_L");
  double mean = 0, squares = 0;
  for (const double v : work.each) mean += v / 9;
  for (const double v : work.each) squares += (v - mean) * (v - mean);
  const double half = 2.306 * std::sqrt(squares / 8 / 9);  // t of 8 degrees of freedom
  CHECK(work.mean == Approx(mean));
  CHECK(work.upper95 - work.mean == Approx(half).epsilon(1e-3));
  CHECK(work.mean - work.lower95 == Approx(half).epsilon(1e-3));
  const auto single = clinic_numbers(single_breath(segment_breaths(recorded(who)), 3), {});
  CHECK(std::isinf(find(single, "work_of_breathing_J_per_L").upper95));
}

TEST_CASE("A trace without pressures has no numbers of a clinic", "[clinic]") {
  Trace trace = recorded({});
  trace.channels.clear();
  CHECK(clinic_numbers(mean_breath(segment_breaths(trace)), {}).empty());
}

TEST_CASE("A resistance that no airway has is doubted, and so is the work of flow", "[clinic]") {
  LungBreather who;
  for (const ClinicNumber& number : numbers_of(who)) CHECK(number.doubt.empty());
  who.resistance = 0.05;
  const auto numbers = numbers_of(who);
  for (const char* name :
       {"lung_resistance_cmH2O_s_per_L", "resistive_work_J_per_L", "expiratory_resistive_work_J_per_L"})
    CHECK_THAT(find(numbers, name).doubt, Contains("out of step"));
  CHECK(find(numbers, "pleural_swing_cmH2O").doubt.empty());
}
