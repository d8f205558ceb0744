#include "io/trace_columns.hpp"

#include "errors/input_error.hpp"
#include "io/message_text.hpp"

namespace trunk {
namespace {

constexpr auto time_names = "time_s, time_ms or time_min";
constexpr auto volume_names = "volume_ml or volume_L";
constexpr auto flow_names = "flow_L_s, flow_L_min or flow_ml_s";
constexpr auto signal_names = "volume_ml, volume_L, flow_L_s, flow_L_min or flow_ml_s";

struct Header {
  const DelimitedText& table;
  const std::vector<ColumnName>& columns;

  [[noreturn]] void fail(const std::string& text) const {
    throw InputError(table.source(), table.header_line(), text);
  }

  [[noreturn]] void missing(const std::string& what, const std::string& expected, std::string hint) const {
    if (columns.size() == 1) hint = "separate the columns by comma, semicolon or tab";
    if (hint.empty()) hint = "rename the column that holds it, with its unit";
    fail("no " + what + " column among " + list_of(columns) + "; expected " + expected + "; " + hint);
  }

  // The one column for which `wanted` holds; two are an error because silence would pick one of them.
  template <class Predicate>
  std::optional<std::size_t> only(Predicate wanted) const {
    std::optional<std::size_t> found;
    for (std::size_t i = 0; i < columns.size(); ++i) {
      if (!wanted(columns[i])) continue;
      if (found)
        fail("two columns that mean the same, " + excerpt(columns[*found].text) + " and " +
             excerpt(columns[i].text) +
             "; expected one; rename one of them or choose the column by its name");
      found = i;
    }
    return found;
  }

  std::optional<std::size_t> automatic(const std::string& base, Quantity quantity) const {
    return only([&](const ColumnName& column) {
      const bool same_base = column.base == base || (base == "time" && column.base == "t");
      return same_base && column.quantity == quantity;
    });
  }

  std::size_t by_name(const std::string& name) const {
    for (std::size_t i = 0; i < columns.size(); ++i)
      if (columns[i].text == name) return i;
    const std::string plain = column_name(name).plain;
    if (const auto found = only([&](const ColumnName& column) { return column.plain == plain; }))
      return *found;
    fail("no column " + excerpt(name) + " among " + list_of(columns) +
         "; expected the chosen column; correct its name");
  }
};

std::size_t time_column(const Header& header, const std::string& name) {
  if (name.empty()) {
    if (const auto found = header.automatic("time", Quantity::time)) return *found;
    header.missing("time", time_names, suggestion(header.columns, Quantity::time));
  }
  const std::size_t chosen = header.by_name(name);
  if (header.columns[chosen].quantity != Quantity::time)
    header.fail("the chosen time column " + excerpt(name) +
                " does not end in a unit of time; expected a name such as " + time_names + "; rename it");
  return chosen;
}

std::size_t named_value_column(const Header& header, const std::string& name) {
  const std::size_t chosen = header.by_name(name);
  const Quantity quantity = header.columns[chosen].quantity;
  if (quantity != Quantity::volume && quantity != Quantity::flow)
    header.fail("the chosen column " + excerpt(name) +
                " does not end in a unit of volume or flow; expected a name like " + signal_names +
                "; rename it");
  return chosen;
}

std::size_t preferred_value_column(const Header& header, SignalKind kind) {
  const bool flow = kind == SignalKind::flow;
  const Quantity quantity = flow ? Quantity::flow : Quantity::volume;
  const std::string base = flow ? "flow" : "volume";
  if (const auto found = header.automatic(base, quantity)) return *found;
  header.missing(base, flow ? flow_names : volume_names, suggestion(header.columns, quantity));
}

std::size_t automatic_value_column(const Header& header, std::vector<std::string>& notes) {
  const auto flow = header.automatic("flow", Quantity::flow),
             volume = header.automatic("volume", Quantity::volume);
  if (flow && volume)
    notes.push_back("flow " + excerpt(header.columns[*flow].text) + " is used and not volume " +
                    excerpt(header.columns[*volume].text) +
                    ": volumes of ventilators and spirometers are reset at each breath");
  if (flow) return *flow;
  if (volume) return *volume;
  auto hint = suggestion(header.columns, Quantity::volume);
  if (hint.empty()) hint = suggestion(header.columns, Quantity::flow);
  header.missing("volume or flow", std::string("one of ") + signal_names, hint);
}

}  // namespace

TraceColumns choose_columns(const DelimitedText& table, const TraceOptions& options) {
  TraceColumns chosen;
  for (const auto& name : table.names()) chosen.all.push_back(column_name(name));
  const Header header{table, chosen.all};
  chosen.time = time_column(header, options.time_column);
  if (!options.value_column.empty())
    chosen.value = named_value_column(header, options.value_column);
  else if (options.prefer)
    chosen.value = preferred_value_column(header, *options.prefer);
  else
    chosen.value = automatic_value_column(header, chosen.notes);
  chosen.sigma = header.automatic("sigma", Quantity::volume);
  return chosen;
}

}  // namespace trunk
