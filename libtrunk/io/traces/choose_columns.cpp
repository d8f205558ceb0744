#include "traces/choose_columns.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "text/message_text.hpp"
#include "traces/breath_table.hpp"

namespace trunk {
namespace {

constexpr auto time_names = "time_s, time_ms or time_min";
constexpr auto volume_names = "volume_ml or volume_L";
constexpr auto flow_names = "flow_L_s, flow_L_min or flow_ml_s";
constexpr auto signal_options = "--time, --flow, --volume or --belt";
constexpr auto signal_names = "volume_ml, volume_L, flow_L_s, flow_L_min or flow_ml_s";

// A unit that the file gives separately has priority over a unit in the name.
ColumnName name_of(const Channel& channel) {
  ColumnName column = column_name(channel.name);
  if (const auto unit = unit_of(channel.unit)) {
    // The times of a clock are in seconds whatever its name says.
    const bool other = column.quantity != Quantity::unknown && column.quantity != Quantity::time &&
                       (column.quantity != unit->quantity || column.to_si != unit->to_si);
    const std::string both = other ? fmt::format("{} and {}", column.unit, unit->name) : "";
    if (column.quantity == Quantity::unknown) column.base = column.plain;
    column.set(*unit);
    column.unclear = both;
  } else if (column.quantity == Quantity::unknown) {
    column.unit = channel.unit;
  } else if (looks_like_unit(channel.unit)) {
    column.unclear = channel.unit;
  }
  return column;
}

std::string quantity_name(Quantity quantity) {
  switch (quantity) {
    case Quantity::time:
      return "time";
    case Quantity::flow:
      return "flow";
    case Quantity::pressure:
      return "pressure";
    case Quantity::length:
      return "excursion";
    default:
      return "volume";
  }
}

class ColumnChoice {
 public:
  ColumnChoice(const Recording& recording, const TraceOptions& options)
      : recording_(recording), options_(options), find_(recording, chosen_.all) {
    for (const Channel& channel : recording.channels) chosen_.all.push_back(name_of(channel));
  }

  TraceColumns choose() {
    require_header();
    require_samples();
    if (options_.kind != SignalKind::belt) require_unit("--unit", options_.unit, false);
    require_unit("--time-unit", options_.time_unit, true);
    Mistakes mistakes;
    mistakes.gather([&] { choose_time(); });
    mistakes.gather([&] { choose_value(); });
    mistakes.gather([&] { chosen_.sigma = documented("sigma", Quantity::volume); });
    if (mistakes.empty()) mistakes.gather([&] { choose_rate(); });
    mistakes.settle();
    find_other();
    chosen_.unit_by_user = !options_.unit.empty();
    chosen_.channels =
        choose_channels(recording_, chosen_.all, chosen_.value, chosen_.time, options_.channels);
    return chosen_;
  }

 private:
  using Index = std::size_t;

  [[noreturn]] void fail(std::string found, std::string expected, std::string remedy) const {
    find_.fail(std::move(found), std::move(expected), std::move(remedy));
  }
  std::string word_and_name(Index i) const { return find_.word_and_name(i); }

  void require_header() const {
    const bool picked =
        !options_.value_column.empty() && (!options_.time_column.empty() || options_.rate_hz > 0);
    if (recording_.first_cell.empty() || picked) return;
    fail(fmt::format("the first row starts with the number {}", excerpt(recording_.first_cell)),
         "a header such as time_s,volume_ml",
         "write a header (without '#') above the numbers, or choose columns by number, as in --time 1 --flow "
         "2 "
         "--unit L/s");
  }

  // Throws if the names show a table of breaths, unless one may be a signal or the user names it.
  void require_samples() const {
    const std::string names = numbers_of_breaths(chosen_.all);
    const bool may_be_signal =
        std::any_of(chosen_.all.begin(), chosen_.all.end(), [](const ColumnName& column) {
          const auto role = role_of(column);
          return role && *role != Role::time;
        });
    if (names.empty() || may_be_signal || options_.kind || !options_.value_column.empty()) return;
    fail(fmt::format("each row seems to be a breath with its numbers, {}, as a metabolic cart writes them",
                     names),
         "a recording of flow or volume within the breaths", remedy_for_breath_table);
  }

  // ---- finding columns ----

  template <class Predicate>
  std::optional<Index> only(Predicate wanted) const {
    return find_.only(wanted, signal_options);
  }

  std::optional<Index> documented(const std::string& base, Quantity quantity) const {
    return only([&](const ColumnName& c) {
      return (c.base == base || (base == "time" && c.base == "t")) && c.quantity == quantity;
    });
  }

  // Returns whether a column has a unit of this quantity, or has no unit and an option gives one. In formats
  // whose names have no room for a unit, times without a unit are probably seconds.
  bool fits(const ColumnName& column, Quantity quantity, const std::string& unit_option) const {
    if (column.quantity == quantity) return true;
    if (column.quantity != Quantity::unknown) return false;
    const auto given = unit_of(unit_option);
    return given ? given->quantity == quantity : quantity == Quantity::time && recording_.header_line == 0;
  }

  // Returns a column with a documented name, or else one with a synonym, which a note reports.
  std::optional<Index> automatic(Role role, Quantity quantity, const std::string& unit_option) {
    if (const auto found = documented(quantity_name(quantity), quantity)) return found;
    const auto found =
        only([&](const ColumnName& c) { return role_of(c) == role && fits(c, quantity, unit_option); });
    if (found) note_choice(*found, quantity_name(quantity));
    return found;
  }

  void note_choice(Index i, const std::string& what) {
    if (!is_documented(chosen_.all[i]))
      choices_ += fmt::format("{}{} as the {}", choices_.empty() ? "" : ", ", word_and_name(i), what);
  }

  Index by_name(const std::string& name) const { return find_.by_name(name, signal_options); }

  [[noreturn]] void missing(const std::string& what, const std::string& expected, std::string hint,
                            const std::string& option) const {
    if (hint.empty() && chosen_.all.size() == 1 && recording_.word == "column")
      hint = "separate the columns by comma, semicolon or tab, or give --rate HZ for evenly spaced samples";
    if (hint.empty())
      hint = fmt::format("rename the {} that holds it, or choose it with {}", recording_.word, option);
    if (!recording_.if_missing.empty()) hint += "; " + recording_.if_missing;
    fail(fmt::format("no {} {} among {}", what, recording_.word, list_of(chosen_.all)), expected, hint);
  }

  // ---- units ----

  static void require_unit(const std::string& option, const std::string& given, bool of_time) {
    if (given.empty()) return;
    const auto unit = unit_of(given);
    const auto fits_option = [of_time](Quantity quantity) {
      return of_time ? quantity == Quantity::time
                     : quantity == Quantity::volume || quantity == Quantity::flow;
    };
    if (!unit || !fits_option(unit->quantity))
      throw InputError(
          {fmt::format("{} {}", option, given)},
          of_time ? "this is not a known unit of time" : "this is not a known unit of volume or flow",
          of_time ? "a unit such as s, ms or min" : "a unit such as ml, L, L/s, L/min or ml/s",
          looks_like_unit(given) ? "write a factor before the unit, as in '10 ml'" : "");
  }

  // The unit of an option replaces the unit of the file. A note reports a difference.
  void apply_unit(Index i, const std::string& given, const std::string& option) {
    const auto unit = unit_of(given);
    if (!unit) return;
    ColumnName& column = chosen_.all[i];
    if (column.quantity != Quantity::unknown && column.unit != unit->name)
      chosen_.notes.push_back(fmt::format("{} is read in {}, as {} says, not in {}", word_and_name(i), given,
                                          option, column.unit));
    column.set(*unit);
  }

  void require_clear(Index i, Quantity wanted) const {
    const std::string given = chosen_.all[i].doubtful_unit();
    if (given.empty()) return;
    fail(fmt::format("the unit {} of the chosen {} is not known or not clear", excerpt(given),
                     word_and_name(i)),
         fmt::format("one unit of {}", quantity_name(wanted)), how_to_give_a_unit(wanted));
  }

  void note_factor(Index i) {
    const std::string note = find_.note_of_factor(i, chosen_.all[i].unit);
    if (!note.empty()) chosen_.notes.push_back(note);
  }

  // ---- the time ----

  void choose_time() {
    const std::string& name = options_.time_column;
    if (options_.rate_hz > 0) {
      if (const auto unused = documented("time", Quantity::time))
        chosen_.notes.push_back(
            fmt::format("{} is not used: --rate gives the times", word_and_name(*unused)));
      return;
    }
    chosen_.time = name.empty() ? automatic(Role::time, Quantity::time, options_.time_unit) : by_name(name);
    if (!chosen_.time) chosen_.time = only_clock();
    if (!chosen_.time) return require_any_rate();
    apply_unit(*chosen_.time, options_.time_unit, "--time-unit");
    ColumnName& column = chosen_.all[*chosen_.time];
    require_clear(*chosen_.time, Quantity::time);
    if (column.quantity == Quantity::time) return note_factor(*chosen_.time);
    if (column.quantity != Quantity::unknown)
      fail(fmt::format("the chosen time {} is in {} and not in a unit of time", word_and_name(*chosen_.time),
                       column.unit),
           fmt::format("one such as {}", time_names), "choose another");
    chosen_.notes.push_back(
        fmt::format("{} names no unit of time: seconds are assumed (--time-unit ms changes this)",
                    word_and_name(*chosen_.time)));
    column.set(*unit_of("s"));
  }

  // Names of times are in many languages.
  std::optional<Index> only_clock() {
    std::optional<Index> found;
    for (Index i = 0; i < recording_.channels.size(); ++i) {
      if (!recording_.channels[i].is_clock) continue;
      if (found) return std::nullopt;
      found = i;
    }
    if (found)
      chosen_.notes.push_back(
          fmt::format("{} is taken as the time, since it alone has clock times", word_and_name(*found)));
    return found;
  }

  void require_any_rate() const {
    const auto& channels = recording_.channels;
    if (std::none_of(channels.begin(), channels.end(), [](const Channel& c) { return c.rate_hz > 0; }))
      no_times();
  }

  [[noreturn]] void no_times() const {
    missing("time", time_names, suggestion(chosen_.all, Quantity::time),
            "--time, or give --rate HZ if the samples are evenly spaced");
  }

  // If there are no times, an option or the file gives the rate.
  void choose_rate() {
    if (chosen_.time) return;
    const double given = options_.rate_hz, known = recording_.channels[chosen_.value].rate_hz;
    if (given > 0 && known > 0 && std::abs(given / known - 1) > 1e-3)
      chosen_.notes.push_back(
          fmt::format("{} is read at {} samples a second, as --rate says, not at {}, as the file says",
                      word_and_name(chosen_.value), number_text(given), number_text(known)));
    chosen_.rate_hz = given > 0 ? given : known;
    if (!(chosen_.rate_hz > 0)) no_times();
  }

  // ---- the signal ----

  void choose_value() {
    if (!options_.value_column.empty())
      take_named(by_name(options_.value_column));
    else if (options_.kind)
      take(preferred(*options_.kind), *options_.kind);
    else
      take_automatic();
    if (!choices_.empty()) chosen_.notes.push_back(fmt::format("taken by name: {}", choices_));
  }

  void take(Index i, SignalKind kind) {
    chosen_.value = i;
    chosen_.kind = kind;
    if (kind == SignalKind::belt) {
      chosen_.all[i].to_si = 1;
      if (!options_.unit.empty()) chosen_.all[i].unit = options_.unit;
      return;
    }
    apply_unit(i, options_.unit, "--unit");
    const Quantity wanted = kind == SignalKind::flow ? Quantity::flow : Quantity::volume;
    const ColumnName& column = chosen_.all[i];
    require_clear(i, wanted);
    if (column.quantity == wanted) return note_factor(i);
    const std::string what = quantity_name(wanted);
    if (column.quantity == Quantity::unknown)
      fail(fmt::format("the chosen {} has no unit of {}", word_and_name(i), what),
           fmt::format("a name like {}", kind == SignalKind::flow ? flow_names : volume_names),
           fmt::format("add the unit, as in --unit {}", kind == SignalKind::flow ? "L/s" : "ml"));
    fail(fmt::format("the chosen {} is in {} and not in a unit of {}", word_and_name(i), column.unit, what),
         fmt::format("a unit of {}", what), remedy_for(column.quantity));
  }

  static std::string remedy_for(Quantity quantity) {
    if (quantity == Quantity::pressure) return "choose a pressure with --poes, --pga, --pdi or --paw";
    return fmt::format("choose it as --{}", quantity_name(quantity));
  }

  void take_named(Index i) {
    if (options_.kind) return take(i, *options_.kind);
    apply_unit(i, options_.unit, "--unit");
    const ColumnName& column = chosen_.all[i];
    if (column.quantity == Quantity::flow || column.quantity == Quantity::volume)
      return take(i, column.quantity == Quantity::flow ? SignalKind::flow : SignalKind::volume);
    if (column.quantity == Quantity::unknown && role_of(column) == Role::belt) {
      note_choice(i, "belt, in its own unit");
      return take(i, SignalKind::belt);
    }
    if (const std::string given = column.doubtful_unit(); !given.empty())
      fail(fmt::format("the chosen {} does not end in a unit of volume or flow: the unit {} of it is not "
                       "known or not clear",
                       word_and_name(i), excerpt(given)),
           fmt::format("a name like {}", signal_names), how_to_give_a_unit(Quantity::flow));
    fail(fmt::format("the chosen {} does not end in a unit of volume or flow", word_and_name(i)),
         fmt::format("a name like {}", signal_names),
         "add the unit, as in --unit L/s, or choose it with --belt");
  }

  Index preferred(SignalKind kind) {
    if (kind == SignalKind::belt) {
      if (const auto found = belt()) return *found;
      missing("belt", "a name such as belt or respiration", "", "--belt");
    }
    const bool flow = kind == SignalKind::flow;
    const Quantity quantity = flow ? Quantity::flow : Quantity::volume;
    if (const auto found = automatic(flow ? Role::flow : Role::volume, quantity, options_.unit))
      return *found;
    missing(quantity_name(quantity), flow ? flow_names : volume_names, suggestion(chosen_.all, quantity),
            "--" + quantity_name(quantity));
  }

  static bool is_belt(const ColumnName& c) {
    // A unit of pressure or length that the file gives apart from the name is the belt's own.
    const bool own =
        (c.quantity == Quantity::pressure || c.quantity == Quantity::length) && c.base == c.plain;
    return (c.quantity == Quantity::unknown || own) && role_of(c) == Role::belt;
  }

  // A belt of the thorax and one of the abdomen are not two of the same. This version fits one of them.
  void refuse_both_belts() const {
    std::optional<Index> thorax, abdomen;
    for (Index i = 0; i < chosen_.all.size(); ++i) {
      if (!is_belt(chosen_.all[i])) continue;
      const auto part = part_of_trunk(chosen_.all[i]);
      if (part == TrunkPart::thorax) thorax = i;
      if (part == TrunkPart::abdomen) abdomen = i;
    }
    if (!thorax || !abdomen) return;
    const std::string first = excerpt(chosen_.all[*thorax].text),
                      second = excerpt(chosen_.all[*abdomen].text);
    fail(
        fmt::format("{} is understood as the belt of the thorax and {} as that of the abdomen, and their sum "
                    "has no scale without a calibration",
                    first, second),
        "one signal", fmt::format("choose one of them with --belt, as in --belt {}", first));
  }

  std::optional<Index> belt() {
    refuse_both_belts();
    const auto found = only(is_belt);
    if (found) note_choice(*found, "belt, in its own unit");
    return found;
  }

  void take_automatic() {
    const auto flow = automatic(Role::flow, Quantity::flow, options_.unit);
    const std::string of_flow = choices_;
    const auto volume = automatic(Role::volume, Quantity::volume, options_.unit);
    if (flow) {
      choices_ = of_flow;
      if (volume)
        chosen_.notes.push_back(
            fmt::format("flow {} is used and not volume {}, since ventilators and spirometers reset "
                        "the volume at each breath",
                        excerpt(chosen_.all[*flow].text), excerpt(chosen_.all[*volume].text)));
      return take(*flow, SignalKind::flow);
    }
    if (volume) return take(*volume, SignalKind::volume);
    if (const auto found = belt()) return take(*found, SignalKind::belt);
    auto hint = suggestion(chosen_.all, Quantity::volume);
    if (hint.empty()) hint = suggestion(chosen_.all, Quantity::flow);
    missing("volume or flow", fmt::format("one of {}", signal_names), hint, "--flow, --volume or --belt");
  }

  // A flow and a volume of one recording show each other's sign and scale, if there is one of the other kind.
  void find_other() {
    if (chosen_.kind == SignalKind::belt) return;
    const bool flow = chosen_.kind == SignalKind::flow;
    const Quantity quantity = flow ? Quantity::volume : Quantity::flow;
    for (Index i = 0; i < chosen_.all.size(); ++i) {
      const ColumnName& c = chosen_.all[i];
      const Channel &one = recording_.channels[i], &signal = recording_.channels[chosen_.value];
      const bool fits = c.quantity == quantity || c.quantity == Quantity::unknown;
      if (i == chosen_.value || !fits || role_of(c) != (flow ? Role::volume : Role::flow)) continue;
      if (one.rate_hz != signal.rate_hz || one.samples != signal.samples) continue;
      if (chosen_.other) return chosen_.other.reset();
      chosen_.other = i;
    }
  }

  const Recording& recording_;
  const TraceOptions& options_;
  TraceColumns chosen_;
  const ColumnFinder find_;
  std::string choices_;
};

}  // namespace

TraceColumns choose_columns(const Recording& recording, const TraceOptions& options) {
  return ColumnChoice(recording, options).choose();
}

}  // namespace trunk
