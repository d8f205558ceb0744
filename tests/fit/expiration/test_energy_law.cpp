#include "expiration/recoil_time.hpp"

#include <filesystem>
#include <map>

#include "expiration/passive_expiration.hpp"
#include "math/median.hpp"
#include "support/breathers.hpp"
#include "support/catch.hpp"
#include "support/shared_data.hpp"
#include "traces/read_trace.hpp"

using namespace trunk;

namespace {

// A straight inspiration, then an exponential fall that the next breath cuts; the volume begins at 0.
struct Passive {
  double tidal_volume_m3 = 500e-6, recoil_s = 0.5, inspiration_s = 1, expiration_s = 2;
  double left() const { return std::exp(-expiration_s / recoil_s); }  // at the end, of the volume at the top
  double relaxed_m3() const { return tidal_volume_m3 / (1 - left()); }  // volume at the top above relaxation
  double volume(double t) const {
    if (t <= inspiration_s) return tidal_volume_m3 * t / inspiration_s;
    return relaxed_m3() * (std::exp(-(t - inspiration_s) / recoil_s) - left());
  }
};

MeasuredBreath measured(const Passive& shape, int breaths = 1, double noise_m3 = 0, std::uint64_t seed = 1) {
  test::Random random(seed);
  MeasuredBreath breath;
  breath.inspiration_s = shape.inspiration_s;
  breath.duration_s = shape.inspiration_s + shape.expiration_s;
  breath.tidal_volume_m3 = shape.tidal_volume_m3;
  breath.breaths_used = breaths;
  breath.each_m3.resize(static_cast<std::size_t>(breaths));
  breath.used.assign(static_cast<std::size_t>(breaths),
                     {0, shape.inspiration_s, breath.duration_s, shape.tidal_volume_m3, true, ""});
  for (int i = 0; i < 200; ++i) {
    const double t = breath.duration_s * i / 199;
    double mean = 0;
    breath.time_s.push_back(t);
    for (auto& volume : breath.each_m3) {
      volume.push_back(shape.volume(t) + noise_m3 * random.normal());
      mean += volume.back() / breaths;
    }
    breath.volume_m3.push_back(mean);
  }
  return breath;
}

}  // namespace

TEST_CASE("A passive expiration has the energy of its exponential, and f = 1 at its own time constant",
          "[unit][expiration]") {
  Passive shape;
  shape.recoil_s = GENERATE(0.3, 0.6, 1.2);
  shape.expiration_s = GENERATE(1.2, 3.0);
  CAPTURE(shape.recoil_s, shape.expiration_s);
  const ExpiredEnergy e = expired_energy(measured(shape));
  const double top = shape.relaxed_m3(), tau = shape.recoil_s;
  // Its flow jumps at the top; 50 ms round that.
  const double whole = top * top / (2 * tau) * (1 - shape.left() * shape.left());
  CHECK(e.squared_flow == Approx(whole).margin(0.03 * top * top / (tau * tau)));
  CHECK(e.late_flow_m3_s == Approx(top / tau * std::exp(-0.89 * shape.expiration_s / tau)).epsilon(0.02));
  CHECK(e.expiration_s == Approx(shape.expiration_s));
  CHECK(e.tidal_volume_m3 == shape.tidal_volume_m3);
  // By hand, with the flow at the end: all stored energy goes into the airway.
  const double last_flow = top * shape.left() / tau;
  CHECK(resistive_share({whole, last_flow, shape.expiration_s, shape.tidal_volume_m3}, tau) == Approx(1));
}

TEST_CASE("The share of the airway and the time constant are inverse to each other", "[unit][expiration]") {
  const ExpiredEnergy e{0.5e-6, 0.3e-3, 2, 1e-3};
  for (const double share : {0.1, 0.4, 0.9})
    CHECK(resistive_share(e, recoil_time_s(e, share)) == Approx(share));
  // tau = 0.4 / 2 / (0.5 - 0.4 * 0.3), in litres.
  CHECK(recoil_time_s(e, 0.4) == Approx(0.2 / 0.38));
  CHECK(std::isinf(recoil_time_s(e, 1.7)));
}

TEST_CASE("The residual of the prior is that of ln f, and its slope is that of finite differences",
          "[unit][expiration]") {
  const ExpiredEnergy e{0.5e-6, 0.3e-3, 2, 1e-3};
  const double usual = std::log(recoil_time_s(e, 0.40)), step = 1e-5;
  CHECK(energy_residual(e, usual).z == Approx(0).margin(1e-12));
  for (const double log_tau : {usual - 1, usual, usual + 1}) {
    const double slope =
        (energy_residual(e, log_tau + step).z - energy_residual(e, log_tau - step).z) / (2 * step);
    CHECK(energy_residual(e, log_tau).slope == Approx(slope));
  }
  CHECK(energy_residual(e, std::log(recoil_time_s(e, 0.40 * std::exp(0.42)))).z == Approx(1));
}

TEST_CASE("The limits of f hold 95 % of a normal law that ends at 1", "[unit][expiration]") {
  const ShareLimits limits = share_limits95();
  double inside = 0, all = 0;
  for (double log_f = -6; log_f < 0; log_f += 1e-4) {
    const double density = std::exp(-0.5 * std::pow((log_f - std::log(0.4)) / 0.42, 2));
    all += density;
    if (log_f > std::log(limits.low) && log_f < std::log(limits.high)) inside += density;
  }
  CHECK(inside / all == Approx(0.95).margin(1e-3));
  CHECK(limits.low * limits.high == Approx(0.16));
}

TEST_CASE("Noise does not add to the energy of several breaths, and its spread is in the interval",
          "[unit][expiration]") {
  const Passive shape;
  const double energy = expired_energy(measured(shape)).squared_flow;
  double ratio = 0;
  std::vector<double> logs, errors;
  constexpr int repeats = 60;
  for (int k = 0; k < repeats; ++k) {
    const MeasuredBreath noisy = measured(shape, 10, 25e-6, static_cast<std::uint64_t>(k));
    ratio += expired_energy(noisy).squared_flow / energy / repeats;
    const RecoilTime recoil = recoil_time(noisy);
    logs.push_back(std::log(recoil.median_s));
    errors.push_back(recoil.log_error);
  }
  CHECK(ratio == Approx(1).margin(0.02));
  double mean = 0, squares = 0;
  for (const double l : logs) mean += l / repeats;
  for (const double l : logs) squares += (l - mean) * (l - mean) / (repeats - 1);
  CHECK(median(errors) == Approx(std::sqrt(squares)).epsilon(0.3));
}

TEST_CASE("The spread of breaths moves a recoil time less that something else knows too",
          "[unit][expiration]") {
  const Passive shape;
  const double usual = std::log(recoil_time(measured(shape)).median_s);
  RecoilDeviance known;  // a normal statement on ln tau with a deviation of 0.3
  for (int i = -20; i <= 20; ++i) {
    known.log_recoil_s.push_back(usual + 0.1 * i);
    known.deviance.push_back(0.1 * i * 0.1 * i / 0.09);
  }
  constexpr int repeats = 60;
  std::vector<double> logs, errors;
  for (int k = 0; k < repeats; ++k) {
    const MeasuredBreath noisy = measured(shape, 10, 60e-6, static_cast<std::uint64_t>(k));
    const RecoilTime recoil = recoil_time(noisy, known);
    logs.push_back(std::log(recoil.median_s));
    errors.push_back(recoil.log_error);
    CHECK(recoil.log_error < 0.5 * recoil_time(noisy).log_error);
  }
  double mean = 0, squares = 0;
  for (const double l : logs) mean += l / repeats;
  for (const double l : logs) squares += (l - mean) * (l - mean) / (repeats - 1);
  const double spread = std::sqrt(squares);
  CHECK(median(errors) >
        spread);  // the law is not normal: its weight is that at the middle, and a little too large
  CHECK(median(errors) < 1.6 * spread);
}

TEST_CASE("There is no upper limit if the expiration does not slow down", "[unit][expiration]") {
  Passive shape;
  shape.recoil_s = -4;  // the flow grows
  const RecoilTime straight = recoil_time(measured(shape));
  CHECK_FALSE(straight.has_upper_limit);
  CHECK(std::isinf(straight.upper95_s));
  CHECK(straight.lower95_s > 0);
  CHECK(straight.log_error == 0);  // of a single breath
  shape.recoil_s = 0.5;
  const RecoilTime slowing = recoil_time(measured(shape));
  CHECK(slowing.has_upper_limit);
  CHECK(slowing.lower95_s < slowing.median_s);
  CHECK(slowing.median_s < slowing.upper95_s);
}

TEST_CASE("A passive expiration lies on a straight line of volume on flow; a braked one does not",
          "[unit][expiration]") {
  Passive shape;
  shape.recoil_s = GENERATE(0.3, 0.6);
  const PassiveExpiration relaxed = passive_expiration(measured(shape));
  CHECK(relaxed.straight);
  CHECK(relaxed.recoil_s == Approx(shape.recoil_s).epsilon(0.05));
  CHECK(relaxed.r_squared > 0.99);
  test::Breather braked;
  braked.activation = test::muscle_shapes().front().activation;
  braked.period_s = 5;
  CHECK_FALSE(passive_expiration(mean_breath(segment_breaths(test::breathed(braked, 1)))).straight);
}

namespace {

struct Covered {
  int covered = 0, all = 0;
  std::vector<double> widths;  // upper over lower limit
};

// Breathers of R/E 0.3 and 0.6 s and periods of 1.9, 3.3 and 5 s, for each shape of the muscle.
std::map<std::string, Covered> coverage(std::uint64_t seeds) {
  std::map<std::string, Covered> families;
  for (const auto& shape : test::muscle_shapes())
    for (const double recoil : {0.3, 0.6})
      for (const double period : {1.9, 3.3, 5.0})
        for (std::uint64_t seed = 1; seed <= seeds; ++seed) {
          test::Breather who;
          who.activation = shape.activation, who.recoil_s = recoil, who.period_s = period;
          who.noise_m3_s = seed % 2 == 0 ? 10e-6 : 30e-6;
          const RecoilTime found = recoil_time(mean_breath(segment_breaths(test::breathed(who, seed))));
          Covered& family = families[shape.name];
          family.covered += found.lower95_s <= recoil && recoil <= found.upper95_s ? 1 : 0;
          family.widths.push_back(found.upper95_s / found.lower95_s);
          ++family.all;
        }
  return families;
}

void check_coverage(std::uint64_t seeds, bool in_each_family) {
  int covered = 0, all = 0;
  std::vector<double> widths;
  std::string report;
  for (const auto& [name, family] : coverage(seeds)) {
    CAPTURE(name);
    if (in_each_family) CHECK(family.covered >= 0.89 * family.all);  // few repeats show less
    covered += family.covered, all += family.all;
    widths.insert(widths.end(), family.widths.begin(), family.widths.end());
    report += "\n" + name + ": " + std::to_string(100.0 * family.covered / family.all) +
              " % covered, upper over lower limit " + std::to_string(median(family.widths));
  }
  CHECK(covered >= 0.89 * all);
  CHECK(median(widths) <= 8);
  if (!in_each_family) return;
  WARN("R/E in its interval: " << 100.0 * covered / all << " % of " << all << ", upper over lower limit "
                               << median(widths) << report);
}

}  // namespace

TEST_CASE("The interval of the recoil time constant covers R/E of breathers with five muscles",
          "[unit][expiration]") {
  check_coverage(2, false);
}

TEST_CASE("The interval of the recoil time constant covers R/E of 1200 breathers", "[nightly][expiration]") {
  check_coverage(40, true);
}

namespace {

RecoilTime recoil_of(const std::filesystem::path& file, const std::string& excluded = "") {
  BreathSelection selection;
  if (!excluded.empty()) selection.excluded = breath_numbers("--exclude", excluded);
  return recoil_time(mean_breath(segment_breaths(read_trace(file), selection)));
}

}  // namespace

TEST_CASE("Recoil times of real breathing are as a prototype found them", "[shared][expiration]") {
  const RecoilTime first = recoil_of(test::shared_file("traces/cant_Subject01_0cmH2O_0mL.csv")),
                   third = recoil_of(test::shared_file("traces/cant_Subject03_0cmH2O_0mL.csv"));
  CHECK(first.median_s == Approx(0.48).epsilon(0.1));
  CHECK(first.lower95_s == Approx(0.19).epsilon(0.1));
  CHECK(first.upper95_s == Approx(1.73).epsilon(0.2));
  CHECK(first.late_share == Approx(0.73).epsilon(0.1));
  CHECK(third.median_s == Approx(0.48).epsilon(0.1));
  CHECK(third.lower95_s == Approx(0.20).epsilon(0.1));
  CHECK(third.upper95_s == Approx(1.50).epsilon(0.2));
  CHECK(third.late_share == Approx(0.65).epsilon(0.1));
}

TEST_CASE("Odd and even breaths of one subject agree on the recoil time", "[shared][expiration]") {
  const auto [name, odd, even, apart] =
      GENERATE(std::tuple{"traces/cant_Subject01_0cmH2O_0mL.csv", "2,4,6,8,10", "1,3,5,7,9", 0.5},
               std::tuple{"traces/cant_Subject03_0cmH2O_0mL.csv", "2,4,6,8,10", "1,3,5,7,9", 0.5},
               std::tuple{"cases/traces/local_optimum.csv", "2,4,6,8,10,12,14,16,18,20",
                          "1,3,5,7,9,11,13,15,17,19", 0.1});
  CAPTURE(name);
  const RecoilTime a = recoil_of(test::shared_file(name), even), b = recoil_of(test::shared_file(name), odd);
  CHECK(a.lower95_s < b.upper95_s);
  CHECK(b.lower95_s < a.upper95_s);
  CHECK(std::abs(std::log(a.median_s / b.median_s)) < apart);
}
