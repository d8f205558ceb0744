#include "recordings/edf/edf_recording.hpp"

#include <edflib.h>
#include <fmt/format.h>

#include <algorithm>

#include "recordings/edf/uninterrupted_parts.hpp"
#include "text/message_text.hpp"

namespace trunk {
namespace {

std::string without_padding(const char* field) {
  const std::string text = field;
  const auto last = text.find_last_not_of(' ');
  return last == std::string::npos ? "" : text.substr(0, last + 1);
}

[[noreturn]] void refuse(const std::string& source, int reason) {
  switch (reason) {
    case EDFLIB_NO_SUCH_FILE_OR_DIRECTORY:
      throw InputError({source}, "cannot be read", "a readable EDF or BDF file", "check its permissions");
    default:
      throw InputError({source}, "an EDF or BDF file that breaks the format or is cut short",
                       "a whole and valid one",
                       "export it again, or let EDFbrowser name and repair the fault");
  }
}

class EdfRecording : public Recording {
 public:
  EdfRecording(const std::filesystem::path& path, std::size_t block)
      : header_(std::make_unique<edf_hdr_struct>()) {
    source = path.string();
    word = "channel";
    const bool whole = open(source);
    if (!whole && header_->filetype == EDFLIB_FILE_IS_DISCONTINUOUS)
      open_part(path, block);
    else if (!whole)
      refuse(source, header_->filetype);
    else if (block > 1)
      refuse_block(block, 1);
    const double record_s = static_cast<double>(header_->datarecord_duration) / EDFLIB_TIME_DIMENSION;
    for (int i = 0; i < header_->edfsignals; ++i) {
      const edf_param_struct& signal = header_->signalparam[i];
      channels.push_back({without_padding(signal.label), without_padding(signal.physdimension),
                          record_s > 0 ? signal.smp_in_datarecord / record_s : 0.0,
                          static_cast<std::size_t>(std::max(signal.smp_in_file, 0LL))});
    }
    if (channels.empty()) {
      edfclose_file(header_->handle);
      throw InputError({source}, "an EDF file with only annotations", "a channel of flow or volume");
    }
  }
  ~EdfRecording() override { edfclose_file(header_->handle); }
  EdfRecording(const EdfRecording&) = delete;
  EdfRecording& operator=(const EdfRecording&) = delete;

  Samples read(std::span<const std::size_t> chosen) override {
    Samples samples;
    for (const std::size_t channel : chosen) samples.values.push_back(values(channel));
    for (const auto& values : samples.values)
      if (values.size() != samples.values.front().size())
        throw InputError({source}, "the chosen channels differ in their sampling rates", "the same rate");
    return samples;
  }

 private:
  bool open(const std::string& file) {
    return edfopen_file_readonly(file.c_str(), header_.get(), EDFLIB_DO_NOT_READ_ANNOTATIONS) == 0;
  }

  [[noreturn]] void refuse_block(std::size_t block, std::size_t parts) const {
    throw InputError({fmt::format("--block {}", block)},
                     fmt::format("{} has {} uninterrupted part{}", source, parts, parts == 1 ? "" : "s"),
                     "the number of one of them, from 1");
  }

  // EDFlib does not open EDF+D. A copy of one part is a continuous file.
  void open_part(const std::filesystem::path& path, std::size_t block) {
    const InterruptedEdf edf = uninterrupted_parts(path);
    const auto& parts = edf.parts;
    if (block > parts.size()) refuse_block(block, parts.size());
    const auto longest = std::max_element(parts.begin(), parts.end(),
                                          [](const auto& a, const auto& b) { return a.count < b.count; });
    const std::size_t chosen = block > 0 ? block - 1 : static_cast<std::size_t>(longest - parts.begin());
    if (parts.size() > 1 && block == 0)
      notes.push_back(fmt::format(
          "the recording has interruptions: part {} of {}, the longest, is read, {} s from {} s on "
          "(--block {} reads another)",
          chosen + 1, parts.size(), number_text(static_cast<double>(longest->count) * edf.record_s),
          number_text(longest->start_s, 8), chosen == 0 ? 2 : 1));
    copy_ = continuous_copy(path, edf, parts[chosen]);
    if (!open(fmt::format("/proc/self/fd/{}", fileno(copy_.get())))) refuse(source, header_->filetype);
  }

  std::vector<double> values(std::size_t channel) {
    const long long count = header_->signalparam[channel].smp_in_file;
    if (count > static_cast<long long>(max_samples))
      throw InputError({source},
                       fmt::format("{} samples found in channel '{}'", count, channels[channel].name),
                       fmt::format("at most {}", max_samples), "export a part of the recording");
    std::vector<double> values(static_cast<std::size_t>(std::max(count, 0LL)));
    const int signal = static_cast<int>(channel), wanted = static_cast<int>(values.size());
    edfrewind(header_->handle, signal);
    if (edfread_physical_samples(header_->handle, signal, wanted, values.data()) != wanted)
      throw InputError({source}, "reading stopped before the end", "", "check the disk");
    return values;
  }

  std::unique_ptr<edf_hdr_struct> header_;
  TemporaryFile copy_;
};

}  // namespace

bool is_edf(std::string_view start) {
  if (start.starts_with("\xFF"
                        "BIOSEMI"))
    return true;
  // A text table may also begin with a zero and spaces, but not with a line of 256 characters.
  return start.size() >= 256 && start.starts_with("0       ") &&
         std::none_of(start.begin(), start.begin() + 256, [](char c) { return c == '\n' || c == '\r'; });
}

std::unique_ptr<Recording> open_edf(const std::filesystem::path& path, std::size_t block) {
  return std::make_unique<EdfRecording>(path, block);
}

}  // namespace trunk
