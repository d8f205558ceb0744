#pragma once

#include <filesystem>

#include "subject/fit_summary.hpp"

namespace trunk {

/// What the folder of a cohort keeps beside a fit, so that the fit need not be done again for its row.
struct StoredFit {
  FitSummary summary;
  std::vector<std::string> notes;
  std::string fingerprint;  // of all that decides the result
};

/// Returns a stored fit as JSON text. `details` is what `fit --json` prints; it holds the summary.
std::string text_of(const StoredFit& fit, Json details);

/// Returns the stored fit in a text that text_of made; throws InputError with `file` for any other text.
StoredFit stored_fit(const std::string& text, const std::filesystem::path& file);

}  // namespace trunk
