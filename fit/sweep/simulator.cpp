#include "sweep/simulator.hpp"

#include <algorithm>

#include "anatomy/breath_run.hpp"
#include "dynamics/recoil.hpp"
#include "records/run_record.hpp"
#include "scenarios/build_trunk.hpp"

namespace trunk {

struct SweepSimulator::Ready {
  std::size_t model = 0;
  ScenarioFile file;
  Trunk trunk;
  mutable StableRange stable;
};

SweepSimulator::SweepSimulator(const SweepDesign& design, Provenance provenance, RunLimits limits)
    : design_(design), provenance_(std::move(provenance)), limits_(std::move(limits)) {
  for (const auto& subject : design.subjects) {
    subjects_.push_back(read_stored_subject(subject.path));
    if (!design.intervals) subjects_.back().draws.clear();
  }
  subject_repeats_ = std::any_of(subjects_.begin(), subjects_.end(), [](const StoredSubject& s) {
    return s.own && s.own->scenario.time.start == Start::periodic;
  });
}

SweepSimulator::~SweepSimulator() = default;

std::size_t SweepSimulator::together() const noexcept {
  const bool drawn = std::any_of(subjects_.begin(), subjects_.end(),
                                 [](const StoredSubject& s) { return !s.draws.empty(); });
  return design_.store == SweepDesign::Store::full || drawn ? 1 : batch_lanes();
}

std::shared_ptr<const SweepSimulator::Ready> SweepSimulator::ready_for(std::size_t run) const {
  const std::size_t model = design_.model_of(run);
  const std::lock_guard lock(mutex_);
  if (last_ && last_->model == model) return last_;
  const SweepDesign::Run r = design_.run(run);
  const auto ready = std::make_shared<Ready>();
  ready->model = model;
  ready->file = read_scenario(design_.scenarios[r.scenario].path);
  apply_settings(design_.settings_of(r.values), ready->file);
  ready->trunk = assemble_trunk(ready->file);
  if (subject_repeats_ && !ready->trunk.model.recoil)
    ready->trunk.model.recoil = measure_recoil_for_leads(ready->trunk.model);
  return last_ = ready;
}

std::vector<FinishedRun> SweepSimulator::operator()(std::span<const std::size_t> runs) const {
  std::vector<FinishedRun> done;
  const auto fail_run = [&](std::size_t run, const std::exception& error) {
    done.push_back({invalid_row(design_, run, error), std::nullopt});
  };
  try {
    const std::shared_ptr<const Ready> ready = ready_for(runs.front());
    std::vector<PreparedRun> prepared;
    for (const std::size_t run : runs) try {
        const SweepDesign::Run r = design_.run(run);
        ScenarioFile file = ready->file;
        if (!subjects_.empty()) breathe_as(subjects_[r.subject], file.scenario);
        const std::vector<Setting> settings = design_.settings_of(r.values);
        apply_settings(settings, file);
        require_repeating(file.scenario);
        prepared.push_back({run, std::move(file)});
        if (!subjects_.empty())
          prepared.back().draws = draws_in(prepared.back().file, subjects_[r.subject].draws, settings);
      } catch (const std::exception& error) {
        fail_run(run, error);
      }
    for (FinishedRun& f :
         SweepBatch{design_, provenance_, limits_, ready->trunk, ready->stable}.simulate(std::move(prepared)))
      done.push_back(std::move(f));
  } catch (const Cancelled&) {
  } catch (const std::exception& error) {
    for (const std::size_t run : runs)
      if (std::none_of(done.begin(), done.end(), [&](const FinishedRun& f) { return f.row.run == run; }))
        fail_run(run, error);
  }
  return done;
}

}  // namespace trunk
