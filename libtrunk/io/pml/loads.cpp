#include "pml/loads.hpp"

#include <fmt/format.h>

#include "errors/input_error.hpp"

namespace trunk::pml {
namespace {

struct TargetText {
  std::string operator()(const AtomRange& range) const {
    return range.first == range.last ? fmt::format("{}", range.first)
                                     : fmt::format("{}-{}", range.first, range.last);
  }
  std::string operator()(const ComponentName& component) const { return component.name; }
  std::string operator()(AllAtoms) const { return "*"; }
};

}  // namespace

std::string text_of(const std::vector<LoadTarget>& targets) {
  std::vector<std::string> texts;
  for (const LoadTarget& target : targets) texts.push_back(std::visit(TargetText{}, target));
  return fmt::format("{}", fmt::join(texts, ","));
}

PiecewiseLinear course(const Load& load, double to_si) {
  std::vector<PiecewiseLinear::Event> events;
  for (const Load::Event& event : load.events) events.push_back({event.date, event.value * to_si});
  return PiecewiseLinear(std::move(events));
}

std::vector<std::size_t> listed_indices(const Load& load, std::size_t end) {
  std::vector<std::size_t> indices;
  std::vector<bool> taken(end);
  for (const LoadTarget& target : load.targets) {
    const AtomRange* const range = std::get_if<AtomRange>(&target);
    if (!range) continue;
    if (range->last >= end || range->first > range->last)
      throw InputError({}, fmt::format("a load on atoms {}-{}", range->first, range->last),
                       fmt::format("indexes below {} in increasing order", end), "correct its appliedTo");
    for (std::size_t index = range->first; index <= range->last; ++index)
      if (!taken[index]) {
        taken[index] = true;
        indices.push_back(index);
      }
  }
  return indices;
}

}  // namespace trunk::pml
