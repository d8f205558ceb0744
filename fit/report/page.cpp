#include "report/page.hpp"

#include <string_view>

#include "errors/input_error.hpp"
#include "report/contents.hpp"
#include "report/surface_contents.hpp"
#include "results/read/results_kind.hpp"

// The page as scripts/build_report_page makes it, in the program itself (fit/embed.cmake).
extern "C" const char trunk_report_page[], trunk_report_page_end[];

namespace trunk {
namespace {

constexpr std::size_t most_trajectory_bytes = 2'400'000;

/// Returns the JSON with "<" escaped, so that no text can end the script element.
std::string for_script_element(const Packed::Json& json) {
  std::string text;
  for (const char c : json.dump(-1, ' ', true, Packed::Json::error_handler_t::replace))
    if (c == '<')
      text += "\\u003c";
    else
      text += c;
  return text;
}

void require_side_by_side(const std::vector<std::filesystem::path>& files) {
  if (files.size() < 2) return;
  for (const auto& file : files)
    if (kind_of(file) == "sweep")
      throw InputError({file.string()}, "is a sweep", "runs or fits side by side", "report it alone");
}

}  // namespace

std::string report_page(const std::vector<std::filesystem::path>& files,
                        const std::optional<ComparedSurface>& compared) {
  require_side_by_side(files);
  Packed packed;
  Packed::Json contents = Packed::Json::array();
  for (const auto& file : files)
    contents.push_back(file_contents(file, most_trajectory_bytes / files.size(), packed));
  if (compared) contents[0]["run"]["surface"] = surface_contents(*compared, packed);
  constexpr std::string_view place = "<!-- the data -->";
  const std::string_view page(trunk_report_page,
                              static_cast<std::size_t>(trunk_report_page_end - trunk_report_page));
  const std::size_t at = page.find(place);
  std::string html(page.substr(0, at));
  html += "<script type=\"application/json\" id=\"contents\">" +
          for_script_element({{"schema", "trunk.report/1"}, {"files", contents}}) +
          "</script>\n<script type=\"application/octet-stream\" id=\"numbers\">" + packed.text() +
          "</script>";
  html += page.substr(at + place.size());
  return html;
}

}  // namespace trunk
