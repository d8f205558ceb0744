#include "traces/breath_table.hpp"

#include <algorithm>
#include <array>
#include <string_view>

namespace trunk {
namespace {

// Tidal and minute volume, rates, gases, ratios and times of a breath, as carts abbreviate them.
constexpr std::array<std::string_view, 40> of_breaths{
    "vt",   "vte",   "vti",    "vtin", "vtex", "tv",    "ve",    "vmin",   "mv",    "rf",
    "rr",   "bf",    "fr",     "af",   "br",   "fb",    "vo2",   "vco2",   "rer",   "rq",
    "r",    "peto2", "petco2", "pto2", "feo2", "feco2", "feto2", "fetco2", "eqo2",  "eqco2",
    "mets", "hr",    "spo2",   "ti",   "te",   "ttot",  "vdvt",  "vo2kg",  "vevo2", "vevco2"};

bool is_of_breaths(const ColumnName& column) {
  std::string name = column.base;
  std::erase(name, '_');
  return std::find(of_breaths.begin(), of_breaths.end(), name) != of_breaths.end();
}

}  // namespace

std::string numbers_of_breaths(const std::vector<ColumnName>& columns) {
  std::vector<ColumnName> found;
  std::copy_if(columns.begin(), columns.end(), std::back_inserter(found), is_of_breaths);
  return found.size() < 3 ? "" : list_of(found);
}

}  // namespace trunk
