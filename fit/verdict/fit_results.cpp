#include "verdict/fit_results.hpp"

#include <algorithm>

namespace trunk {

std::string_view name_of(Grade grade) {
  switch (grade) {
    case Grade::determined:
      return "determined";
    case Grade::assumption:
      return "assumption";
    case Grade::not_determined:
      return "not_determined";
    case Grade::not_converged:
      break;
  }
  return "not_converged";
}

const FitResult* FitResults::find(std::string_view name) const {
  const auto at =
      std::find_if(results.begin(), results.end(), [&](const FitResult& r) { return r.name == name; });
  return at == results.end() ? nullptr : &*at;
}

}  // namespace trunk
