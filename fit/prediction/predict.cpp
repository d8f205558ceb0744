#include "prediction/predict.hpp"

#include <algorithm>
#include <cmath>
#include <span>

#include "math/units.hpp"
#include "parallel/workers.hpp"
#include "records/run_record.hpp"

namespace trunk {
namespace {

using Row = std::vector<NamedValue>;  // the measures of one candidate

/// Returns the measures of every candidate in every place: [places][candidates].
std::vector<std::vector<Row>> simulated(const std::vector<const Drawn*>& places, const Execution& execution) {
  const std::size_t together = batch_lanes(), count = places.front()->candidates.size();
  std::vector<std::size_t> firsts;
  for (std::size_t i = 0; i < count; i += together) firsts.push_back(i);
  std::vector<std::vector<Row>> rows(places.size(), std::vector<Row>(count));
  const auto cancelled = [&] { return execution.cancelled && execution.cancelled(); };
  using Part = std::pair<std::size_t, std::vector<std::vector<Row>>>;
  work_off<Part>(
      firsts, execution.threads, cancelled,
      [&](std::size_t first) {
        Part part{first, {}};
        for (const Drawn* place : places) {
          const auto some = std::span(place->candidates).subspan(first, std::min(together, count - first));
          part.second.emplace_back();
          for (const BreathSummary& breath : summarise_breaths(place->at.trunk, some, place->at.grid))
            part.second.back().push_back(measures_of(breath));
        }
        return part;
      },
      [&](Part part) {
        for (std::size_t k = 0; k < places.size(); ++k)
          std::move(part.second[k].begin(), part.second[k].end(),
                    rows[k].begin() + static_cast<std::ptrdiff_t>(part.first));
      });
  if (cancelled()) throw Cancelled();
  return rows;
}

/// Returns the tidal volume of all candidates.
std::vector<double> delta_v_ml(const std::vector<Row>& rows) {
  std::vector<double> values;
  for (const Row& row : rows) values.push_back(row.front().value);
  return values;
}

/// Returns all values but the first, which belongs to the best candidate.
std::vector<double> draws_of(const std::vector<double>& values) {
  return {values.begin() + 1, values.end()};
}

std::vector<double> volumes_m3(std::vector<double> volumes_ml) {
  for (double& v : volumes_ml) v *= m3_per_ml;
  return volumes_ml;
}

}  // namespace

std::vector<Candidate> draws_in(const ScenarioFile& file, const std::vector<Candidate>& draws,
                                const std::vector<Setting>& settings) {
  std::vector<Candidate> all;
  ScenarioFile with = file;
  for (const Candidate& draw : draws) {
    with.scenario = file.scenario;
    with.scenario.parameters = draw.parameters;
    with.scenario.activation = draw.activation;
    apply_settings(settings, with);
    all.push_back({with.scenario.parameters, with.scenario.activation});
  }
  return all;
}

std::vector<Prediction> predict(const Drawn& own, const std::vector<std::pair<std::string, Drawn>>& others,
                                const Execution& execution) {
  if (others.empty()) return {};
  std::vector<const Drawn*> places = {&own};
  for (const auto& [name, drawn] : others) places.push_back(&drawn);
  const auto rows = simulated(places, execution);

  std::vector<Prediction> result;
  const std::vector<double> own_ml = delta_v_ml(rows.front());
  for (std::size_t k = 0; k < others.size(); ++k) {
    const std::vector<Row>& theirs = rows[k + 1];
    const std::vector<double> ml = delta_v_ml(theirs);
    std::vector<double> percent;
    for (std::size_t i = 0; i < ml.size(); ++i) percent.push_back(100.0 * ml[i] / own_ml[i]);
    Prediction p{others[k].first, predicted_measures(theirs), volumes_m3(draws_of(ml)),
                 volumes_m3(draws_of(own_ml)), 0};
    p.numbers.push_back(predicted("own_delta_v_ml", "ml", own_ml));
    p.numbers.push_back(predicted("ratio_percent", "percent", percent));
    p.failed = static_cast<int>(
        std::count_if(percent.begin() + 1, percent.end(), [](double v) { return !std::isfinite(v); }));
    result.push_back(std::move(p));
  }
  return result;
}

}  // namespace trunk
