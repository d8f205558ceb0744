#include "pml/applied_to.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "pml/text_values.hpp"
#include "text/message_text.hpp"

namespace trunk::pml {
namespace {

std::vector<std::string_view> split(std::string_view text) {
  std::vector<std::string_view> items;
  for (std::size_t from = 0; from <= text.size();) {
    const std::size_t comma = std::min(text.find(',', from), text.size());
    items.push_back(trimmed(text.substr(from, comma - from)));
    from = comma + 1;
  }
  return items;
}

// An item of only these characters is meant as an index: "3-", "1.5" and "-2" are mistakes, not names.
bool looks_numeric(std::string_view item) {
  return item.find_first_not_of("0123456789-+. \t\r\n") == std::string_view::npos;
}

std::optional<AtomRange> range_of(std::string_view item) {
  const std::size_t dash = item.find('-');
  const auto first = whole_number(item.substr(0, dash));
  const auto last = dash == std::string_view::npos ? first : whole_number(item.substr(dash + 1));
  if (!first || !last) return std::nullopt;
  return AtomRange{*first, *last};
}

LoadTarget load_target_of(std::string_view item, const XmlDocument& xml, pugi::xml_node at) {
  if (item == "*") return AllAtoms{};
  if (!item.empty() && !looks_numeric(item)) return ComponentName{std::string(item)};
  const auto range = range_of(item);
  if (!range)
    xml.fail(at, fmt::format("appliedTo has {}", excerpt(item)),
             "an index such as 7, a range such as 0-3, the name of a component, or *, separated by commas",
             "correct it");
  if (range->last < range->first)
    xml.fail(at, fmt::format("appliedTo has the range {}", excerpt(item)), "the smaller index first",
             "swap the two");
  return *range;
}

void check_length(const std::vector<LoadTarget>& targets, const XmlDocument& xml, pugi::xml_node at) {
  std::size_t sum = 0;
  for (const LoadTarget& target : targets)
    if (const AtomRange* const range = std::get_if<AtomRange>(&target)) sum += range->last - range->first + 1;
  if (sum > most_indices)
    xml.fail(at, fmt::format("appliedTo lists {} atoms", sum), fmt::format("at most {}", most_indices),
             "shorten the ranges");
}

}  // namespace

std::vector<LoadTarget> read_load_targets(const XmlDocument& xml, pugi::xml_node applied_to) {
  const std::string text = xml.text(applied_to);
  if (text.empty())
    xml.fail(applied_to, "appliedTo is empty", "indexes such as 0-3,7, names of components, or *",
             "fill it in");
  std::vector<LoadTarget> targets;
  for (const std::string_view item : split(text)) targets.push_back(load_target_of(item, xml, applied_to));
  check_length(targets, xml, applied_to);
  return targets;
}

}  // namespace trunk::pml
