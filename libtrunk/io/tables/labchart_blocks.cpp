#include "tables/labchart_blocks.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <utility>

#include "errors/input_error.hpp"
#include "tables/column_names.hpp"
#include "tables/labchart_layout.hpp"
#include "tables/leading_number.hpp"
#include "text/message_text.hpp"

namespace trunk {
namespace {

using Block = LabChartBlock;
using Cells = Block::Cells;

constexpr std::size_t most_blocks = 10'000, most_key_lines = 30;

// Returns "Interval" for the line "Interval=\t0.01 s"; "" for a line of another form.
std::string_view key_of(std::string_view line) {
  if (line.starts_with('"')) line.remove_prefix(1);
  std::size_t length = 0;
  while (length < line.size() && ((line[length] | 0x20) >= 'a' && (line[length] | 0x20) <= 'z')) ++length;
  return length > 0 && length < line.size() && line[length] == '=' ? line.substr(0, length)
                                                                   : std::string_view{};
}

char delimiter_after_key(std::string_view line) {
  line.remove_prefix(line.find('=') + 1);
  if (line.starts_with('"')) line.remove_prefix(1);
  return !line.empty() && std::string_view("\t;,").find(line.front()) != std::string_view::npos ? line.front()
                                                                                                : ' ';
}

// Returns "0.01 s" for "Interval=\t0.01 s", and also if everything stands in quotes.
std::string_view after_key(std::string_view line) {
  const char delimiter = delimiter_after_key(line);
  line.remove_prefix(line.find('=') + 1);
  if (line.starts_with('"')) line.remove_prefix(1);
  if (delimiter != ' ') line.remove_prefix(1);
  return line;
}

void take_key(Block& block, std::string_view key, std::string_view line, std::size_t number) {
  if (key == "ChannelTitle" || block.header_line == 0) block.header_line = number;
  if (!trimmed(line).ends_with('=')) block.delimiter = delimiter_after_key(line);
  Cells& cells = block.keys[key];
  split_cells(after_key(line), delimiter_after_key(line), cells);
  if (key != "Interval" || cells.empty()) return;
  const LeadingNumber interval = leading_number(
      cells.size() > 1 ? std::string(cells[0]) + " " + std::string(cells[1]) : std::string(cells[0]));
  const auto unit = unit_of(interval.rest.empty() ? "s" : interval.rest);
  block.interval_s = unit && unit->quantity == Quantity::time && interval.value > 0 && interval.value < 1e9
                         ? interval.value * unit->to_si
                         : 0;
}

std::vector<Block> blocks_of(const TextLines& lines) {
  std::vector<Block> blocks;
  TextLines at = lines, before = lines;
  bool in_header = false;
  for (std::string_view line; at.next(line); before = at) {
    const std::string_view key = key_of(line);
    if (!key.empty() && !in_header) {
      if (!blocks.empty()) blocks.back().rows.stop_at(before);
      if (blocks.size() >= most_blocks)
        throw InputError({lines.source(), at.number()}, fmt::format("more than {} blocks found", most_blocks),
                         "fewer", "export a part of the recording");
      Block next{{}, 0, 0, '\t', 0, lines};
      if (!blocks.empty()) {  // what the new header does not say holds on
        next = blocks.back();
        next.count = 0;
      }
      blocks.push_back(std::move(next));
    }
    in_header = !key.empty();
    if (in_header) {
      take_key(blocks.back(), key, line, at.number());
      blocks.back().rows = at;
    } else if (!blocks.empty()) {
      ++blocks.back().count;
    }
  }
  std::erase_if(blocks, [](const Block& block) { return block.count == 0; });
  return blocks;
}

std::string lengths_of(const std::vector<Block>& blocks) {
  constexpr std::size_t most = 6;
  std::string text;
  for (std::size_t i = 0; i < std::min(blocks.size(), most); ++i)
    text += fmt::format("{}{}", i > 0 ? ", " : "", number_text(blocks[i].length_s(), 4));
  return text + (blocks.size() > most ? ", ..." : "");
}

// Returns the number of the block to read, from 0, and adds a note if nobody chose it. => notes
std::size_t chosen_block(const std::vector<Block>& blocks, std::size_t wanted, const std::string& source,
                         std::vector<std::string>& notes) {
  if (blocks.empty())
    throw InputError({source}, "headers without rows of numbers below them", "at least 10 samples",
                     "check that the export was finished");
  if (wanted > blocks.size())
    throw InputError({fmt::format("--block {}", wanted)},
                     fmt::format("{} has {} block{}", source, blocks.size(), blocks.size() == 1 ? "" : "s"),
                     "the number of a block, from 1");
  if (wanted > 0 || blocks.size() == 1) return wanted > 0 ? wanted - 1 : 0;
  const auto longest = std::max_element(blocks.begin(), blocks.end(), [](const Block& a, const Block& b) {
    return a.length_s() < b.length_s();
  });
  const auto chosen = static_cast<std::size_t>(longest - blocks.begin());
  notes.push_back(fmt::format(
      "the file has {} blocks, of {} {}: block {}, the longest, is read (--block {} reads another)",
      blocks.size(), lengths_of(blocks), longest->interval_s > 0 ? "s" : "rows", chosen + 1,
      chosen == 0 ? 2 : 1));
  return chosen;
}

}  // namespace

LabChartBlock::Cells LabChartBlock::values_of(std::string_view key) const {
  const auto found = keys.find(key);
  return found == keys.end() ? Cells{} : found->second;
}

bool is_labchart(TextLines lines) {
  std::string_view line;
  for (std::size_t i = 0; i < most_key_lines && lines.next(line); ++i) {
    const std::string_view key = key_of(line);
    if (key.empty()) return false;
    if (key == "ChannelTitle" || key == "ExcelDateTime") return true;
  }
  return false;
}

LabChartBlock labchart_block(const TextLines& lines, std::size_t wanted, std::vector<std::string>& notes) {
  std::vector<Block> blocks = blocks_of(lines);
  return std::move(blocks[chosen_block(blocks, wanted, lines.source(), notes)]);
}

}  // namespace trunk
