#include "report/page.hpp"

#include <string_view>

#include "errors/input_error.hpp"
#include "report/contents.hpp"
#include "report/surface_contents.hpp"

// The page as scripts/build_report_page makes it, in the program itself: it needs no file beside it.
asm(R"(
.section .rodata
.global trunk_report_page, trunk_report_page_end
trunk_report_page: .incbin ")" TRUNK_REPORT_PAGE R"("
trunk_report_page_end:
.text
)");
extern "C" const char trunk_report_page[], trunk_report_page_end[];

namespace trunk {
namespace {

constexpr std::size_t trajectory_bytes = 2'400'000;

/// Nothing in a text can end the element it stands in.
std::string for_script_element(const Packed::Json& json) {
  std::string text;
  for (const char c : json.dump(-1, ' ', true, Packed::Json::error_handler_t::replace))
    if (c == '<')
      text += "\\u003c";
    else
      text += c;
  return text;
}

void require_side_by_side(const Packed::Json& files) {
  for (const auto& file : files)
    if (files.size() > 1 && file["kind"] == "sweep")
      throw InputError(file["name"].get<std::string>() +
                       ": is a sweep, expected runs or fits side by side; report it alone");
}

}  // namespace

std::string report_page(const std::vector<std::filesystem::path>& files,
                        const std::optional<ComparedSurface>& beside) {
  Packed packed;
  Packed::Json contents = Packed::Json::array();
  for (const auto& file : files)
    contents.push_back(file_contents(file, trajectory_bytes / files.size(), packed));
  require_side_by_side(contents);
  if (beside) {
    Packed::Json& run = contents[0]["run"];
    run["surface"] = surface_contents(*beside, run["trajectory"]["particles"].get<std::size_t>(), packed);
  }
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
