#include "verdict/assess_fit.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

#include "anatomy/breath_run.hpp"
#include "math/units.hpp"
#include "verdict/reasons.hpp"
#include "verdict/recoil_ends.hpp"
#include "verdict/sentences.hpp"
#include "verdict/spread.hpp"

namespace trunk {
namespace {

constexpr double unknown = std::numeric_limits<double>::quiet_NaN();
constexpr double normal_quantile = 1.96;

/// A reading at the best point and at both ends of the interval of the recoil time, and its statistical
/// deviation there.
struct Readings {
  double best = unknown, low_recoil = unknown, high_recoil = unknown;
  double deviation = 0.0;  // of the logarithm if `factor`
  bool factor = true;      // the number is positive and its interval is a factor
  std::vector<Share> shares{};
};

class Assessment {
 public:
  explicit Assessment(const FitEvidence& evidence)
      : in_(evidence), p_(evidence.problem), e_(evidence.estimation), space_(p_.space) {}

  FitResults run() {
    results_.gates = in_.gates;
    results_.straight = in_.straight_lines;
    if (e_.search.converged && e_.local) {
      find_points();
      simulate_points();
      add_parameters();
      add_clinical();
      add_measures();
    } else if (e_.search.converged && p_.measured.is_tidal_volume() && e_.uncertainty) {
      add_one_number();
    }
    withhold();
    distrust();
    results_.grade = worst();
    results_.verdict = verdict_sentence(results_, in_);
    return std::move(results_);
  }

 private:
  /// Fits all else again at both ends of the recoil time. => low_, high_, quantile_, covariance_, posterior
  void find_points() {
    best_ = space_.decode(e_.local->x);
    low_ = high_ = best_;
    covariance_ = e_.local->covariance;
    quantile_ = t_quantile(e_.local->freedom);
    const auto elasticity = space_.find("k_elasticity");
    std::optional<AlongRecoil> along;
    if (in_.energy_known && elasticity) {
      const auto held = static_cast<Eigen::Index>(*elasticity);
      RecoilEnds ends = recoil_ends(p_, e_, *in_.breath, held);
      covariance_ = covariance_with_held(*e_.local, held);
      recoil_ = ends.recoil;
      low_ = ends.low;
      high_ = ends.high;
      along = std::move(ends.along);
    }
    results_.posterior = {e_.local->x, covariance_, e_.local->freedom, volume_error(), std::move(along)};
  }

  /// => summaries_: best point, both ends of the recoil time, 5 % more muscle
  void simulate_points() {
    Candidate stronger = best_;
    stronger.parameters.muscle *= more_muscle;
    const std::vector<Candidate> all = {best_, low_, high_, stronger};
    summaries_ = summarise_breaths(p_.trunk, all, p_.grid);
  }

  Readings read(const Reading& reading, bool factor = true) const {
    Readings r{reading(best_), reading(low_), reading(high_), 0.0, factor, {}};
    const Reading scaled = [&](const Candidate& c) { return factor ? std::log(reading(c)) : reading(c); };
    const Eigen::VectorXd gradient = gradient_of(scaled, space_, e_.local->x);
    r.deviation = deviation_of(gradient, covariance_);
    if (!in_.scale.empty()) r.shares = shares_of(p_, *e_.local, gradient);
    return r;
  }

  /// Returns the interval: the spread of breaths and noise, and what the recoil time changes, as the root of
  /// the sum of squares. `gain` adds the error of the volume's gain.
  FitResult result(const char* name, const char* unit, const Readings& r, bool gain) const {
    FitResult out{name, unit, r.best, unknown, unknown, Grade::assumption};
    const double error = gain ? volume_error() * (r.factor ? 1.0 : std::abs(r.best)) : 0.0;
    const double spread = std::hypot(quantile_ * r.deviation, normal_quantile * error);
    const auto of = [&](double v) { return r.factor ? std::log(v) : v; };
    const auto back = [&](double v) { return r.factor ? std::exp(v) : v; };
    const double below = of(r.best) - std::min({of(r.best), of(r.low_recoil), of(r.high_recoil)});
    const double above = std::max({of(r.best), of(r.low_recoil), of(r.high_recoil)}) - of(r.best);
    out.lower95 = back(of(r.best) - std::hypot(spread, below));
    out.upper95 = back(of(r.best) + std::hypot(spread, above));
    out.meaning = meaning_of(name);
    out.shares = r.shares;
    return out;
  }

  /// Grades a result after what it rests on where forces count, and else after a reason against it, if there
  /// is one.
  void grade(FitResult& r, const std::string& reason) const {
    if (in_.scale.empty()) return set_reason(r, reason);
    r.grade = Grade::assumption;
    r.assumption = grade_of_shares(in_, r);
    if (r.assumption.empty()) r.grade = Grade::determined;
    set_reason(r, scale_reason(in_));
  }

  /// A breath that an airway drives may have no muscle at all: 0 is in the interval then.
  FitResult muscular(const char* name, const char* unit, const Reading& reading) const {
    if (!in_.airway_driven) return result(name, unit, read(reading), true);
    FitResult r = result(name, unit, read(reading, false), true);
    r.lower95 = std::max(r.lower95, 0.0);
    return r;
  }

  /// Relative deviation of the measured volume: 1 % for segmentation and compartment, and that of a gain that
  /// differs with the direction of flow. The 1 % is our choice: without it the ratio of twins whose breaths
  /// are equal was covered in 58 to 83 % of 12 recordings, and its median was up to 0.7 % off.
  double volume_error() const { return std::hypot(0.01, in_.gain_error); }

  void add_parameters() {
    const auto& c = p_.compartment;
    const bool ratio_free = space_.find("k_muscle") || space_.find("k_elasticity");
    const std::string course = course_reason(in_, recoil_);
    const Reading r_ei = [&](const Candidate& x) {
      return muscle_against_recoil(c, x, p_.grid, p_.measured);
    };
    FitResult inspiration = muscular("r_ei", "1", r_ei);
    if (in_.scale.empty()) grade_inspiration(in_, inspiration);
    grade(inspiration, "");
    add(std::move(inspiration));
    FitResult recoil = recoil_result();
    grade(recoil, course);
    add(std::move(recoil));
    if (!ratio_free) return;
    FitResult ratio = muscular("k_muscle_over_k_elasticity", "1", [](const Candidate& x) {
      return x.parameters.muscle / x.parameters.elasticity;
    });
    ratio.assumption = course_assumption(in_);
    grade(ratio, course);
    add(std::move(ratio));
    for (const bool muscle : {false, true}) add_stiffness(muscle, course);
  }

  /// One number tells one parameter, and nothing of how exactly.
  void add_one_number() {
    for (const Estimate& e : e_.uncertainty->parameters) {
      FitResult r{e.name, e.unit, e.value, unknown, unknown, Grade::assumption};
      r.assumption = "all else is as in the scenario; one tidal volume shows no spread";
      r.meaning = meaning_of(e.name);
      if (e.at_bound) set_reason(r, e.name + " stopped at its bound");
      add(std::move(r));
    }
  }

  void add_stiffness(bool muscle, const std::string& course) {
    const char* name = muscle ? "k_muscle" : "k_elasticity";
    if (!space_.find(name)) return;
    const Reading reading = [&](const Candidate& x) {
      return muscle ? x.parameters.muscle : x.parameters.elasticity;
    };
    FitResult stiffness = muscle ? muscular(name, "N/m", reading) : result(name, "N/m", read(reading), false);
    if (!muscle && recoil_) {  // the ends of the recoil time, not of the candidates: a bound may stop those
      stiffness.lower95 = std::max(p_.compartment.elasticity_of(recoil_->upper95_s, best_.parameters), 0.0);
      stiffness.upper95 = p_.compartment.elasticity_of(recoil_->lower95_s, best_.parameters);
    }
    const bool damped = static_cast<bool>(space_.find("damping"));
    stiffness.assumption = fmt::format("a damping of {:g} N s/m, which no volume can tell{}",
                                       best_.parameters.damping, "; " + course_assumption(in_));
    grade(stiffness, damped ? "the damping is free, and volume gives no scale of forces" : course);
    add(std::move(stiffness));
  }

  FitResult recoil_result() const {
    FitResult r =
        result("recoil_time_s", "s",
               read([&](const Candidate& x) { return p_.compartment.recoil_time_s(x.parameters); }), false);
    if (recoil_) {
      r.lower95 = recoil_->lower95_s;
      r.upper95 = recoil_->upper95_s;
    }
    const auto widening = [&](double limit) {
      return std::exp(std::hypot(std::log(limit / r.value), normal_quantile * TrunkAsCompartment::log_error));
    };
    r.lower95 = r.value / widening(r.lower95);
    r.upper95 = r.value * widening(r.upper95);
    r.assumption = course_assumption(in_);
    return r;
  }

  /// Adds what a clinic calls these things, where forces count.
  void add_clinical() {
    if (in_.scale.empty()) return;
    const auto& c = p_.compartment;
    const auto clinical = [&](const char* name, const char* unit, const Readings& r) {
      FitResult out = result(name, unit, r, false);
      grade(out, "");
      add(std::move(out));
    };
    constexpr double per_unit = m3_per_litre / Pa_per_cmH2O;
    clinical("abdominal_elastance_cmH2O_per_L", "cmH2O/L",
             read([&](const Candidate& x) { return per_unit * c.abdominal_elastance(x.parameters); }));
    if (c.elastance > 0.0) {
      clinical("lung_elastance_cmH2O_per_L", "cmH2O/L",
               read([&](const Candidate& x) { return per_unit * x.parameters.lung_elastance; }));
      clinical("respiratory_elastance_cmH2O_per_L", "cmH2O/L",
               read([&](const Candidate& x) { return per_unit * c.respiratory_elastance(x.parameters); }));
      clinical("resistance_cmH2O_s_per_L", "cmH2O s/L",
               read([&](const Candidate& x) { return per_unit * x.parameters.resistance; }));
      Readings peep = read(
          [&](const Candidate& x) {
            const double above_m3 = above_relaxation(c, x, p_.grid, p_.measured);
            const double recoil_Pa = above_m3 * c.respiratory_elastance(x.parameters);
            return (recoil_Pa - c.airway_pressure(0.0)) / Pa_per_cmH2O;
          },
          false);
      FitResult out = result("intrinsic_peep_cmH2O", "cmH2O", peep, false);
      if (!in_.airway_driven) out.lower95 = std::max(out.lower95, 0.0);
      grade(out, "");
      add(std::move(out));
    }
    add_swings();
  }

  /// The swings are those of the trunk, with the relative spread of the compartment's.
  void add_swings() {
    const VolumeCurve curves = simulate_volume(p_.trunk, best_.parameters, best_.activation, p_.grid);
    if (!curves.ending.completed()) return;
    const bool lung = p_.compartment.elastance > 0.0;
    MeasuredCurve seen_at{p_.measured.time_s, p_.measured.delta_v, {}, {{ChannelKind::gastric, {0.0}, 1.0}}};
    using Course = std::function<Eigen::VectorXd(const SeenBreath&)>;
    const auto add_swing = [&](const char* name, const std::vector<double>& simulated, const Course& course) {
      const auto swing = [](const auto& values) {
        double most = 0.0;
        for (const double v : values)
          if (std::abs(v) > std::abs(most)) most = v;
        return most;
      };
      Readings r = read([&](const Candidate& x) {
        return std::abs(swing(course(seen(p_.compartment, x, p_.grid, seen_at)))) / Pa_per_cmH2O;
      });
      const double value = swing(simulated) / Pa_per_cmH2O, spread = std::exp(quantile_ * r.deviation);
      FitResult out{name, "cmH2O", value, value / spread, value * spread, Grade::assumption};
      if (value < 0.0) std::swap(out.lower95, out.upper95);
      out.meaning = meaning_of(name);
      out.shares = r.shares;
      grade(out, "");
      add(std::move(out));
    };
    add_swing("gastric_swing_cmH2O", curves.abdominal_Pa, [](const SeenBreath& b) { return b.abdominal_Pa; });
    if (!lung) return;
    std::vector<double> across = curves.abdominal_Pa;
    for (std::size_t i = 0; i < across.size(); ++i) across[i] -= curves.pleural_Pa[i];
    add_swing("pleural_swing_cmH2O", curves.pleural_Pa, [](const SeenBreath& b) { return b.pleural_Pa; });
    add_swing("transdiaphragmatic_swing_cmH2O", across,
              [](const SeenBreath& b) { return Eigen::VectorXd(b.abdominal_Pa - b.pleural_Pa); });
  }

  void add_measures() {
    if (!summaries_.front().ending.completed()) return;
    const auto& m = summaries_;
    const Reading volume = [&](const Candidate& x) {
      return std::log(tidal_volume(p_.compartment, x, p_.grid, p_.measured));
    };
    const double volume_deviation = deviation_of(gradient_of(volume, space_, e_.local->x), covariance_);
    const auto measure = [&](const char* name, const char* unit, double scale, auto member) {
      const auto at = [&](std::size_t i) {
        return m[i].ending.completed() ? scale * member(m[i].measures) : unknown;
      };
      const double by_volume = (at(3) - at(0)) / std::log(m[3].measures.delta_v / m[0].measures.delta_v);
      Readings r{at(0), at(1), at(2), std::abs(by_volume) * volume_deviation, false};
      FitResult out = result(name, unit, r, false);
      const double gain = normal_quantile * volume_error() * std::abs(by_volume);
      out.lower95 = out.value - std::hypot(out.value - out.lower95, gain);
      out.upper95 = out.value + std::hypot(out.upper95 - out.value, gain);
      out.assumption = "the subject's trunk has the shape of the model's";
      add(std::move(out));
    };
    measure("excursion_right_mm", "mm", mm_per_m, [](const Measures& x) { return x.excursion_right; });
    measure("excursion_left_mm", "mm", mm_per_m, [](const Measures& x) { return x.excursion_left; });
    measure("delta_l_mm", "mm", mm_per_m, [](const Measures& x) { return x.delta_l; });
    measure("delta_h_mm", "mm", mm_per_m, [](const Measures& x) { return x.delta_h; });
    FitResult above =
        result("end_expiratory_above_relaxation_ml", "ml",
               read(
                   [&](const Candidate& x) {
                     return ml_per_m3 * above_relaxation(p_.compartment, x, p_.grid, p_.measured);
                   },
                   false),
               true);
    if (!in_.airway_driven) above.lower95 = std::max(above.lower95, 0.0);
    above.assumption = course_assumption(in_);
    grade(above, course_reason(in_, recoil_));
    add(std::move(above));
  }

  void add(FitResult r) { results_.results.push_back(std::move(r)); }

  /// A gate withholds all that a muscle and a recoil explain.
  void withhold() {
    static constexpr std::array of_volume = {
        "r_ei",     "recoil_time_s",      "k_muscle_over_k_elasticity", "k_elasticity",
        "k_muscle", "excursion_right_mm", "excursion_left_mm",          "delta_l_mm"};
    static constexpr std::array of_pressures = {"k_muscle",
                                                "abdominal_elastance_cmH2O_per_L",
                                                "lung_elastance_cmH2O_per_L",
                                                "respiratory_elastance_cmH2O_per_L",
                                                "resistance_cmH2O_s_per_L",
                                                "recoil_time_s",
                                                "transdiaphragmatic_swing_cmH2O",
                                                "excursion_right_mm"};
    const bool forces = pressure_measured(in_);
    for (const char* name : forces ? of_pressures : of_volume)
      if (results_.find(name)) results_.headline.emplace_back(name);
    if (results_.gates.empty()) return;
    const auto muscular = [](const std::string& name) { return !name.ends_with("_mm"); };
    for (std::vector<FitResult>* list :
         {&results_.results, results_.straight ? &results_.straight->results : nullptr})
      if (list != nullptr)
        for (FitResult& r : *list) {
          if (muscular(r.name)) r.value = r.lower95 = r.upper95 = unknown;
          set_reason(r, results_.gates.front().sentence);
        }
  }

  /// Whatever the search found, a recording behind a gate determines nothing.
  Grade worst() const {
    if (!results_.gates.empty()) return Grade::not_determined;
    if (!converged()) return Grade::not_converged;
    Grade grade = Grade::determined;
    for (const std::string& name : results_.headline) grade = std::max(grade, results_.find(name)->grade);
    return results_.headline.empty() ? Grade::not_determined : grade;
  }

  bool converged() const { return e_.search.converged && !(e_.cross_check && !e_.cross_check->agree); }

  /// No single result is better than the search.
  void distrust() {
    if (converged()) return;
    for (FitResult& r : results_.results) {
      set_reason(r, results_.gates.empty() ? "the search did not converge" : r.reason);
      if (results_.gates.empty()) r.grade = Grade::not_converged;
    }
  }

  static constexpr double more_muscle = 1.05;

  const FitEvidence& in_;
  const FitProblem& p_;
  const Estimation& e_;
  const SearchSpace& space_;
  FitResults results_;
  Candidate best_, low_, high_;  // high_ has the longest recoil time
  std::optional<RecoilTime> recoil_;
  Eigen::MatrixXd covariance_;
  double quantile_ = 0.0;
  std::vector<BreathSummary> summaries_;
};

}  // namespace

FitResults assess_fit(const FitEvidence& evidence) {
  return Assessment(evidence).run();
}

}  // namespace trunk
