#include "traces/choose_channels.hpp"

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>

#include "math/units.hpp"

namespace trunk {
namespace {

constexpr double least_excursion_mm = 1, largest_excursion_mm = 150;

struct Choice {
  ChannelKind kind;
  std::string ChannelOptions::*column;
  std::array<std::string_view, 2> names;  // that nothing else has
};
const std::array choices{Choice{ChannelKind::pleural, &ChannelOptions::poes, {"poes", "pes"}},
                         Choice{ChannelKind::gastric, &ChannelOptions::pga, {"pga", "pgas"}},
                         Choice{ChannelKind::transdiaphragmatic, &ChannelOptions::pdi, {"pdi", "pdi"}},
                         Choice{ChannelKind::airway, &ChannelOptions::paw, {"paw", "paw"}},
                         Choice{ChannelKind::excursion, &ChannelOptions::excursion, {}},
                         Choice{ChannelKind::emg, &ChannelOptions::emg, {}}};

// Returns a number that is the whole text.
std::optional<double> number_in(const std::string& text) {
  double value = 0;
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value);
  if (error != std::errc{} || end != text.data() + text.size()) return std::nullopt;
  return value;
}

class ChannelChoice {
 public:
  ChannelChoice(const Recording& recording, const std::vector<ColumnName>& columns, std::size_t signal,
                std::optional<std::size_t> time, const ChannelOptions& options)
      : recording_(recording),
        columns_(columns),
        signal_(signal),
        time_(time),
        options_(options),
        find_(recording, columns) {}

  ChosenChannels choose() {
    check_options();
    Mistakes mistakes;
    for (const Choice& choice : choices) mistakes.gather([&] { take(choice); });
    mistakes.settle();
    if (!taken_.empty()) note(fmt::format("taken by name: {}", taken_));
    if (!assumed_.empty())
      note(fmt::format(
          "no unit of pressure stands at {}: cmH2O is assumed (--pressure-unit kPa changes this)", assumed_));
    compare_units();
    return chosen_;
  }

 private:
  void note(std::string text) { chosen_.notes.push_back(std::move(text)); }
  static void append(std::string& list, const std::string& text) {
    list += (list.empty() ? "" : ", ") + text;
  }

  void check_options() const {
    const std::string& unit = options_.pressure_unit;
    if (const auto known = unit_of(unit); !unit.empty() && (!known || known->quantity != Quantity::pressure))
      throw InputError({"--pressure-unit " + unit}, "this is not a known unit of pressure",
                       "cmH2O, mbar, hPa, kPa, Pa or mmHg");
    for (const std::string& name : options_.inverted)
      if (std::none_of(choices.begin(), choices.end(),
                       [&](const Choice& c) { return option_of(c.kind) == name; }))
        throw InputError({"--invert-channel " + name}, "this is no channel",
                         "poes, pga, pdi, paw, excursion or emg");
  }

  void take(const Choice& choice) {
    const std::string& name = options_.*choice.column;
    if (name == "none") return;
    if (name.empty()) return take_by_name(choice);
    if (choice.kind == ChannelKind::excursion)
      if (const auto mm = number_in(name)) return take_excursion(name, *mm);
    const std::string option = fmt::format("--{}", option_of(choice.kind));
    const std::size_t column = find_.by_name(name, option);
    if (column == signal_ || column == time_)
      find_.fail(fmt::format("{} {} names the {}", option, excerpt(name),
                             column == signal_ ? "breathing signal" : "times"),
                 "another " + recording_.word, "correct it");
    if (const std::string why = other_samples(column); !why.empty())
      find_.fail(why, fmt::format("the same samples as those of {}", find_.word_and_name(signal_)),
                 fmt::format("resample it, or leave it out with {} none", option));
    add(choice.kind, column, true);
  }

  void take_excursion(const std::string& text, double mm) {
    if (!(mm >= least_excursion_mm && mm <= largest_excursion_mm))
      throw InputError({"--excursion " + text}, "no dome of the diaphragm moves so far with a breath",
                       fmt::format("{:g} to {:g} mm", least_excursion_mm, largest_excursion_mm),
                       "a number is an excursion in mm; name a column by its name");
    chosen_.excursion_m = m_per_mm * mm;
  }

  // Takes a column that nothing but its name chooses.
  void take_by_name(const Choice& choice) {
    std::vector<std::size_t> found;
    for (std::size_t i = 0; i < columns_.size(); ++i)
      if (i != signal_ && i != time_ && is_called(columns_[i], choice)) found.push_back(i);
    if (found.empty()) return;
    if (found.size() > 1)
      return note(fmt::format("{} and {} may both be the {}: neither is used (--{} chooses one)",
                              find_.word_and_name(found[0]), excerpt(columns_[found[1]].text),
                              words_of(choice.kind), option_of(choice.kind)));
    if (const std::string why = other_samples(found[0]); !why.empty()) return note(why + ": it is not used");
    append(taken_, fmt::format("{} as the {}", find_.word_and_name(found[0]), words_of(choice.kind)));
    add(choice.kind, found[0], false);
  }

  static bool is_called(const ColumnName& column, const Choice& choice) {
    if (column.quantity != Quantity::pressure && column.quantity != Quantity::unknown) return false;
    std::string name = column.base;
    std::erase(name, '_');
    return !name.empty() && std::find(choice.names.begin(), choice.names.end(), name) != choice.names.end();
  }

  // Returns what is wrong if a channel has other samples than the signal.
  std::string other_samples(std::size_t column) const {
    const Channel &one = recording_.channels[column], &signal = recording_.channels[signal_];
    if (one.rate_hz != signal.rate_hz)
      return fmt::format("{} has {} samples a second, and {} has {}", find_.word_and_name(column),
                         number_text(one.rate_hz), find_.word_and_name(signal_), number_text(signal.rate_hz));
    if (one.samples != signal.samples)
      return fmt::format("{} has {} samples, and {} has {}", find_.word_and_name(column), one.samples,
                         find_.word_and_name(signal_), signal.samples);
    return "";
  }

  void add(ChannelKind kind, std::size_t column, bool by_option) {
    const ColumnName& name = columns_[column];
    ChannelColumn chosen{kind, column, name.unit, name.to_si, by_option};
    if (is_pressure(kind)) settle_unit(chosen, name, Quantity::pressure, options_.pressure_unit);
    if (kind == ChannelKind::excursion) settle_unit(chosen, name, Quantity::length, "");
    if (kind == ChannelKind::emg) chosen.to_si = 1;
    const auto& inverted = options_.inverted;
    if (std::find(inverted.begin(), inverted.end(), option_of(kind)) != inverted.end()) chosen.to_si *= -1;
    chosen_.columns.push_back(chosen);
  }

  void settle_unit(ChannelColumn& chosen, const ColumnName& name, Quantity quantity,
                   const std::string& given) {
    const bool pressure = quantity == Quantity::pressure;
    if (const auto unit = unit_of(given)) {
      if (name.quantity != Quantity::unknown && name.unit != unit->name)
        note(fmt::format("{} is read in {}, as --pressure-unit says, not in {}",
                         find_.word_and_name(chosen.column), given, name.unit));
      chosen.unit = unit->name, chosen.to_si = unit->to_si;
      return;
    }
    if (const std::string unclear = name.doubtful_unit(); !unclear.empty())
      find_.fail(fmt::format("the unit {} of the chosen {} is not known or not clear", excerpt(unclear),
                             find_.word_and_name(chosen.column)),
                 pressure ? "cmH2O, mbar, hPa, kPa, Pa or mmHg" : "mm or cm",
                 fmt::format(
                     "write it so, with a factor before it as in ({}), {}leave the column out with --{} none",
                     pressure ? "0.1 kPa" : "0.1 mm", pressure ? "give it with --pressure-unit, or " : "or ",
                     option_of(chosen.kind)));
    if (name.quantity == quantity) {
      if (auto text = find_.note_of_factor(chosen.column, chosen.unit); !text.empty()) note(std::move(text));
      return;
    }
    if (name.quantity != Quantity::unknown || (pressure && !name.unit.empty()))
      find_.fail(fmt::format("the chosen {} is in {} and not in a unit of {}",
                             find_.word_and_name(chosen.column), name.unit, pressure ? "pressure" : "length"),
                 pressure ? "cmH2O, mbar, hPa, kPa, Pa or mmHg" : "mm or cm",
                 pressure ? "add its unit, as in --pressure-unit cmH2O" : "rename the column");
    const auto assumed = *unit_of(pressure ? "cmH2O" : "mm");
    chosen.unit = assumed.name, chosen.to_si = assumed.to_si;
    if (pressure)
      append(assumed_, find_.word_and_name(chosen.column));
    else
      note(fmt::format("no unit stands at {}: mm is assumed", find_.word_and_name(chosen.column)));
  }

  // Says the units of pressures if they differ: one of them may be wrong.
  void compare_units() {
    std::string units;
    double first = 0;
    bool differ = false;
    for (const ChannelColumn& c : chosen_.columns) {
      if (!is_pressure(c.kind)) continue;
      append(units, fmt::format("{} in {}", find_.word_and_name(c.column), c.unit));
      const double size = std::abs(c.to_si);
      differ = differ || (first > 0 && size != first);
      first = size;
    }
    if (differ) note(fmt::format("the pressures are in different units, {}: check that this is so", units));
  }

  const Recording& recording_;
  const std::vector<ColumnName>& columns_;
  const std::size_t signal_;
  const std::optional<std::size_t> time_;
  const ChannelOptions& options_;
  const ColumnFinder find_;
  ChosenChannels chosen_;
  std::string taken_, assumed_;
};

}  // namespace

ChosenChannels choose_channels(const Recording& recording, const std::vector<ColumnName>& columns,
                               std::size_t signal, std::optional<std::size_t> time,
                               const ChannelOptions& options) {
  return ChannelChoice(recording, columns, signal, time, options).choose();
}

}  // namespace trunk
