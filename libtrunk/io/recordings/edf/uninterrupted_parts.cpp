#include "recordings/edf/uninterrupted_parts.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <charconv>
#include <cmath>
#include <fstream>
#include <optional>
#include <string>
#include <string_view>

#include "errors/input_error.hpp"

namespace trunk {
namespace {

// Kemp and Olivan, Clin Neurophysiol 2003;114:1755: where the fields of the header are, in bytes.
constexpr std::size_t fixed_bytes = 256, reserved_at = 192, records_at = 236, duration_at = 244,
                      signals_at = 252;
constexpr std::size_t bytes_of_signal = 256, samples_of_record_at = 216, label_bytes = 16;
constexpr std::uint64_t most_signals = 640, most_records = 10'000'000, most_samples_of_record = 10'000'000;
constexpr std::uint64_t most_copied = 1'000'000'000;
constexpr std::size_t longest_onset = 32;

[[noreturn]] void refuse(const std::filesystem::path& path, const std::string& found) {
  throw InputError({path.string()}, "an EDF+ recording with interruptions, " + found,
                   "records that say when they begin", "export one uninterrupted part of it");
}

std::optional<double> number_in(std::string_view field) {
  const auto first = field.find_first_not_of(" +");
  if (first == std::string_view::npos) return std::nullopt;
  field.remove_prefix(first);
  double value = 0;
  const auto [end, error] = std::from_chars(field.data(), field.data() + field.size(), value);
  return error == std::errc{} && std::isfinite(value) ? std::optional(value) : std::nullopt;
}

std::string bytes_at(std::ifstream& file, std::uint64_t offset, std::size_t size) {
  std::string bytes(size, '\0');
  file.clear();
  file.seekg(static_cast<std::streamoff>(offset));
  file.read(bytes.data(), static_cast<std::streamsize>(size));
  bytes.resize(static_cast<std::size_t>(std::max<std::streamsize>(file.gcount(), 0)));
  return bytes;
}

class Reader {
 public:
  explicit Reader(const std::filesystem::path& path) : path_(path), file_(path, std::ios::binary) {}

  InterruptedEdf read() {
    read_header();
    std::error_code unknown;
    const std::uintmax_t size = std::filesystem::file_size(path_, unknown);
    const std::uint64_t records =
        unknown || size < edf_.header_bytes ? 0 : (size - edf_.header_bytes) / edf_.record_bytes;
    if (records == 0 || records > most_records) refuse(path_, fmt::format("of {} records", records));
    if (size != edf_.header_bytes + records * edf_.record_bytes || (said_ > 0 && said_ != records))
      refuse(path_, "which is cut short or longer than its header says");
    for (std::uint64_t i = 0; i < records; ++i) add(i, onset_of(i));
    return edf_;
  }

 private:
  void read_header() {
    const std::string fixed = bytes_at(file_, 0, fixed_bytes);
    const auto signals = fixed.size() == fixed_bytes ? number_in(fixed.substr(signals_at, 4)) : std::nullopt;
    const auto record_s = signals ? number_in(fixed.substr(duration_at, 8)) : std::nullopt;
    if (!record_s || !(*record_s > 0) || !(*signals >= 1 && *signals <= most_signals))
      refuse(path_, "whose header breaks the format");
    const auto count = static_cast<std::size_t>(*signals);
    const std::string rest = bytes_at(file_, fixed_bytes, count * bytes_of_signal);
    if (rest.size() != count * bytes_of_signal) refuse(path_, "which ends in the header");
    const double said = number_in(fixed.substr(records_at, 8)).value_or(0);
    said_ = said > 0 && said <= most_records ? static_cast<std::uint64_t>(said) : 0;
    const std::uint64_t sample_bytes = fixed.front() == '\xFF' ? 3 : 2;
    double most_samples = 1;
    edf_.header_bytes = fixed_bytes + rest.size();
    edf_.record_s = *record_s;
    for (std::size_t i = 0; i < count; ++i) {
      const auto samples = number_in(std::string_view(rest).substr(samples_of_record_at * count + 8 * i, 8));
      if (!samples || !(*samples >= 1 && *samples <= most_samples_of_record))
        refuse(path_, "whose header breaks the format");
      const std::string_view label = std::string_view(rest).substr(label_bytes * i, label_bytes);
      const bool annotations = label.substr(1) == "DF Annotations ";
      if (annotations && edf_.times_bytes == 0) {
        edf_.times_at = edf_.record_bytes;
        edf_.times_bytes = sample_bytes * static_cast<std::uint64_t>(*samples);
      }
      if (!annotations) most_samples = std::max(most_samples, *samples);
      edf_.record_bytes += sample_bytes * static_cast<std::uint64_t>(*samples);
    }
    if (edf_.times_bytes == 0) refuse(path_, "without the channel of annotations");
    tolerance_s_ = 0.5 * *record_s / most_samples;
  }

  // The first annotation of a record is "+12.5\x14\x14".
  double onset_of(std::uint64_t record) {
    const std::string text = bytes_at(file_, edf_.header_bytes + record * edf_.record_bytes + edf_.times_at,
                                      std::min<std::size_t>(edf_.times_bytes, longest_onset));
    const auto end = text.find_first_of("\x14\x15");
    const auto onset = end == std::string::npos || (text.front() != '+' && text.front() != '-')
                           ? std::nullopt
                           : number_in(std::string_view(text).substr(0, end));
    if (!onset) refuse(path_, fmt::format("in which record {} has no time", record + 1));
    return *onset;
  }

  void add(std::uint64_t record, double onset_s) {
    if (record == 0 || std::abs(onset_s - end_s_) > tolerance_s_) edf_.parts.push_back({record, 0, onset_s});
    ++edf_.parts.back().count;
    end_s_ = onset_s + edf_.record_s;
  }

  const std::filesystem::path path_;
  std::ifstream file_;
  InterruptedEdf edf_;
  std::uint64_t said_ = 0;  // how many records the header counts; 0: unknown
  double tolerance_s_ = 0, end_s_ = 0;
};

}  // namespace

InterruptedEdf uninterrupted_parts(const std::filesystem::path& path) {
  return Reader(path).read();
}

TemporaryFile continuous_copy(const std::filesystem::path& path, const InterruptedEdf& edf,
                              const InterruptedEdf::Part& part) {
  std::uint64_t left = part.count * edf.record_bytes;
  if (left > most_copied)
    throw InputError({path.string()}, fmt::format("a part of {} MB", left / 1'000'000), "at most 1000 MB",
                     "export a part of the recording");
  std::ifstream file(path, std::ios::binary);
  std::string header = bytes_at(file, 0, edf.header_bytes);
  if (header.size() < fixed_bytes) refuse(path, "which changed while it was read");
  header.replace(reserved_at, 5, header.front() == '\xFF' ? "BDF+C" : "EDF+C");
  header.replace(records_at, 8, fmt::format("{:<8}", part.count));
  TemporaryFile copy(std::tmpfile());
  const auto write = [&](const std::string& bytes) {
    if (!copy || std::fwrite(bytes.data(), 1, bytes.size(), copy.get()) != bytes.size())
      throw InputError({path.string()}, "there is no room for a temporary copy", "",
                       "make room in the folder of temporary files");
  };
  write(header);
  constexpr std::uint64_t piece_bytes = 1 << 20;
  for (std::uint64_t at = edf.header_bytes + part.first * edf.record_bytes; left > 0;) {
    std::string piece = bytes_at(file, at, std::min(left, piece_bytes));
    if (piece.empty()) refuse(path, "which changed while it was read");
    if (left == part.count * edf.record_bytes && edf.times_at + edf.times_bytes <= piece.size()) {
      std::string times = "+0\x14\x14";
      times.resize(edf.times_bytes, '\0');
      piece.replace(edf.times_at, edf.times_bytes, times);
    }
    write(piece);
    at += piece.size();
    left -= piece.size();
  }
  if (std::fflush(copy.get()) != 0) write("x");  // fails again, with its message
  return copy;
}

}  // namespace trunk
