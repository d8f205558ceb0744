#include "sweep/progress.hpp"

#include <algorithm>
#include <vector>

#include "sweep/fingerprint.hpp"
#include "sweep/journal.hpp"

namespace trunk {

namespace fs = std::filesystem;

SweepProgress progress_of(const fs::path& folder) {
  constexpr double recent_s = 60.0;
  SweepProgress progress;
  const std::string fingerprint = read_fingerprint(folder);
  progress.runs = runs_in(fingerprint, folder);
  std::vector<char> state(most_runs_in(fingerprint, folder), 0);  // 1 completed, 2 failed
  std::vector<double> ended_at;
  read_journals(folder / "journal", identity(fingerprint), state.size(), [&](const SweepRow& row) {
    state[row.run] = row.status == "completed" ? 1 : 2;
    ended_at.push_back(row.ended_at);
  });
  progress.failed = static_cast<std::size_t>(std::count(state.begin(), state.end(), 2));
  progress.done = progress.failed + static_cast<std::size_t>(std::count(state.begin(), state.end(), 1));
  std::sort(ended_at.begin(), ended_at.end());
  if (!ended_at.empty()) {
    const auto first = std::lower_bound(ended_at.begin(), ended_at.end(), ended_at.back() - recent_s);
    const double lasted_s = ended_at.back() - *first;
    if (lasted_s > 0.0) progress.runs_per_s = static_cast<double>(ended_at.end() - first - 1) / lasted_s;
  }
  progress.has_table = fs::exists(folder / "sweep.h5");
  return progress;
}

}  // namespace trunk
