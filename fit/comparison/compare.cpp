#include "comparison/compare.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <string_view>

#include "math/units.hpp"

namespace trunk {
namespace {

/// Compares parts of two files and collects the differences.
class Comparer {
 public:
  explicit Comparer(const Tolerance& tolerance) : tolerance_(tolerance) {}

  void texts(const std::string& group, const std::string& name, const std::string& a, const std::string& b) {
    ++result_.compared;
    if (a != b) result_.differences.push_back({group, name, "", 0.0, 0.0, {}, a + " | " + b});
  }

  void numbers(const std::string& group, const std::vector<NamedValue>& a, const std::vector<NamedValue>& b) {
    matched(group, a, b, [&](const NamedValue& x, const NamedValue& y) {
      ++result_.compared;
      if (!alike(x.value, y.value, std::max(std::abs(x.value), std::abs(y.value))))
        result_.differences.push_back({group, x.name, x.unit, x.value, y.value, {}, ""});
    });
  }

  /// Compares curves at the times of the coarser grid, with linear interpolation on the finer one.
  void curves(const std::string& group, const std::vector<double>& time_a, const std::vector<Series>& a,
              const std::vector<double>& time_b, const std::vector<Series>& b) {
    matched(group, a, b, [&](const Series& x, const Series& y) {
      ++result_.compared;
      if (time_a.size() <= time_b.size())
        curve(group, x, time_a, x.values, time_b, y.values, false);
      else
        curve(group, x, time_b, y.values, time_a, x.values, true);
    });
  }

  void trajectories(const Trajectory& a, const Trajectory& b);

  Comparison result() && { return std::move(result_); }

 private:
  template <class Named>
  static const Named* find(const std::vector<Named>& all, const std::string& name) {
    const auto found = std::find_if(all.begin(), all.end(), [&](const Named& n) { return n.name == name; });
    return found == all.end() ? nullptr : &*found;
  }

  template <class Named>
  void add(const std::string& group, const Named& named, const std::string& note) {
    result_.differences.push_back({group, named.name, named.unit, 0.0, 0.0, {}, note});
  }

  /// Calls `both` for each name that both have. A name that only one of them has is a difference.
  template <class Named, class Both>
  void matched(const std::string& group, const std::vector<Named>& a, const std::vector<Named>& b,
               Both both) {
    for (const Named& x : a) {
      if (x.name == "wall_s" || x.name == "latency_ms") continue;
      if (const Named* y = find(b, x.name))
        both(x, *y);
      else
        add(group, x, "only in the first");
    }
    for (const Named& y : b)
      if (!find(a, y.name) && y.name != "wall_s" && y.name != "latency_ms")
        add(group, y, "only in the second");
  }

  bool alike(double a, double b, double larger) const {
    if (std::isnan(a) || std::isnan(b)) return std::isnan(a) && std::isnan(b);
    return a == b || std::abs(a - b) <= std::max(tolerance_.absolute, tolerance_.relative * larger);
  }

  void curve(const std::string& group, const Series& named, const std::vector<double>& times,
             const std::vector<double>& coarse, const std::vector<double>& fine_times,
             const std::vector<double>& fine, bool coarse_is_second);

  Tolerance tolerance_;
  Comparison result_;
};

double at(double time, const std::vector<double>& times, const std::vector<double>& values) {
  const auto after = std::lower_bound(times.begin(), times.end(), time);
  if (after == times.begin()) return values.front();
  if (after == times.end()) return values.back();
  const auto i = static_cast<std::size_t>(after - times.begin());
  const double weight = (time - times[i - 1]) / (times[i] - times[i - 1]);
  return weight == 1.0 ? values[i] : std::lerp(values[i - 1], values[i], weight);
}

void Comparer::curve(const std::string& group, const Series& named, const std::vector<double>& times,
                     const std::vector<double>& coarse, const std::vector<double>& fine_times,
                     const std::vector<double>& fine, bool coarse_is_second) {
  if (coarse.empty() || fine.empty()) {
    if (coarse.size() != fine.size()) add(group, named, "one of them is empty");
    return;
  }
  constexpr double steps_apart_s = 0.05;  // the last samples of two grids may be this far apart
  if (std::abs(fine_times.back() - times.back()) > steps_apart_s)
    return add(group, named, "they do not last equally long");
  double highest = 0.0, farthest = -1.0;
  Difference worst{group, named.name, named.unit, 0.0, 0.0, {}, ""};
  bool same = true;
  for (const double v : coarse) highest = std::max(highest, std::isfinite(v) ? std::abs(v) : 0.0);
  for (std::size_t i = 0; i < coarse.size(); ++i) {
    const double other = at(times[i], fine_times, fine), apart = std::abs(coarse[i] - other);
    same = same && alike(coarse[i], other, highest);
    if (apart <= farthest) continue;
    farthest = std::isnan(apart) ? farthest : apart;
    worst.first = coarse_is_second ? other : coarse[i];
    worst.second = coarse_is_second ? coarse[i] : other;
    worst.time_s = times[i];
  }
  if (!same) result_.differences.push_back(worst);
}

void Comparer::trajectories(const Trajectory& a, const Trajectory& b) {
  if (a.particles == 0 || b.particles == 0)
    return;  // a run is the same whether its trajectory is kept or not
  ++result_.compared;
  const auto differ = [&](const std::string& note) {
    result_.differences.push_back({"trajectory", "position", "m", 0.0, 0.0, {}, note});
  };
  if (a.particles != b.particles)
    return differ(std::to_string(a.particles) + " | " + std::to_string(b.particles) + " particles");
  const std::size_t width = 3 * a.particles;
  constexpr double same_moment_s = 1e-9;
  double highest = 0.0;
  Difference worst{"trajectory", "position", "m", 0.0, 0.0, {}, ""};
  for (const double x : a.position_m) highest = std::max(highest, std::abs(x));
  bool same = true;
  for (std::size_t i = 0, j = 0; i < a.time_s.size() && j < b.time_s.size();) {
    const double ahead = a.time_s[i] - b.time_s[j];
    if (std::abs(ahead) > same_moment_s) {
      ahead < 0.0 ? ++i : ++j;
      continue;
    }
    for (std::size_t k = 0; k < width; ++k) {
      const double x = a.position_m[i * width + k], y = b.position_m[j * width + k];
      same = same && alike(x, y, highest);
      if (!(std::abs(x - y) > result_.farthest_m)) continue;
      result_.farthest_m = std::abs(x - y);
      worst = {
          "trajectory", "particle " + std::to_string(k / 3) + " " + "xyz"[k % 3], "m", x, y, a.time_s[i], ""};
    }
    ++i, ++j;
  }
  if (!same) result_.differences.push_back(worst);
}

/// Measures that older files of trunks without a lung do not have. They follow from the curves and frames.
constexpr std::array later = {"gastric_swing_cmH2O", "excursion_left_most_risen_mm",
                              "excursion_right_most_risen_mm", "recoil_time_s"};

/// Returns the measures of a run that the other one can have too. What only newer files say is added if the
/// other one is newer: before there was `time.start`, every breath began at rest. If the other one is older,
/// what it cannot say is left out.
std::vector<NamedValue> measures_beside(const RunRecord& run, const RunRecord& other) {
  const auto in = [](const RunRecord& r, std::string_view name) {
    return std::any_of(r.measures.begin(), r.measures.end(),
                       [&](const NamedValue& v) { return v.name == name; });
  };
  std::vector<NamedValue> measures = run.measures;
  std::erase_if(measures, [&](const NamedValue& v) {
    return std::find(later.begin(), later.end(), v.name) != later.end() && !in(other, v.name);
  });
  const char* level = "end_expiratory_above_relaxation_ml";
  if (in(other, level) && !in(run, level))
    measures.push_back({level, "ml", run.status == "completed" ? 0.0 : std::nan("")});
  return measures;
}

void add_runs(const RunRecord& a, const RunRecord& b, Comparer& comparer) {
  comparer.texts("run", "status", a.status, b.status);
  comparer.numbers("parameters", a.parameters, b.parameters);
  comparer.numbers("measures", measures_beside(a, b), measures_beside(b, a));
  comparer.curves("curves", a.curve_time_s, a.curves, b.curve_time_s, b.curves);
  comparer.trajectories(a.trajectory, b.trajectory);
}

/// Returns best values, intervals, and whether each parameter was free.
std::vector<NamedValue> estimates(const FitRecord& fit) {
  std::vector<NamedValue> all;
  for (const FitRecord::Parameter& p : fit.parameters) {
    all.push_back({p.name, p.unit, p.best});
    all.push_back({p.name + " free", "1", p.free ? 1.0 : 0.0});
    if (!p.free && !p.beside) continue;
    all.push_back({p.name + " stderr", p.unit, p.stderr_});
    all.push_back({p.name + " lower95", p.unit, p.lower95});
    all.push_back({p.name + " upper95", p.unit, p.upper95});
  }
  return all;
}

std::vector<Series> fitted_curves(const FitRecord& fit) {
  const auto ml = [](std::vector<double> volumes) {
    for (double& v : volumes) v *= ml_per_m3;
    return volumes;
  };
  return {{"measured", "ml", "", ml(fit.measured_m3)},
          {"dV_fit", "ml", "", ml(fit.dV_fit_m3)},
          {"residual", "ml", "", ml(fit.residual_m3)}};
}

}  // namespace

Comparison compare_runs(const RunRecord& first, const RunRecord& second, const Tolerance& tolerance) {
  Comparer comparer(tolerance);
  add_runs(first, second, comparer);
  return std::move(comparer).result();
}

Comparison compare_fits(const FitRecord& first, const FitRecord& second, const Tolerance& tolerance) {
  Comparer comparer(tolerance);
  comparer.texts("fit", "status", first.status, second.status);
  comparer.numbers("parameters", estimates(first), estimates(second));
  comparer.numbers("statistics", first.statistics, second.statistics);
  comparer.curves("result", first.result_time_s, fitted_curves(first), second.result_time_s,
                  fitted_curves(second));
  add_runs(first.best_run, second.best_run, comparer);
  return std::move(comparer).result();
}

}  // namespace trunk
