#include <random>

#include "errors/input_error.hpp"
#include "files/sha256.hpp"
#include "results/inspect/print_inspection.hpp"
#include "results/read/results_kind.hpp"
#include "results/read/stored_run.hpp"
#include "results/write/write_run.hpp"
#include "support/catch.hpp"
#include "support/result_records.hpp"

using namespace trunk;
using namespace trunk::test;
namespace fs = std::filesystem;

namespace {

constexpr std::size_t seal_size = 72;  // "sha256 ", 64 digits, line feed

/// As a program leaves a file that changed it.
std::string without_seal(const std::string& bytes) {
  return bytes.substr(0, bytes.size() - seal_size);
}

std::string refusal_of(const fs::path& path) {
  return error_of<InputError>([&] { inspection_text(path); });
}

}  // namespace

TEST_CASE("A file that is not a finished results file is refused with the reason", "[results]") {
  const TemporaryFolder folder;
  const fs::path path = folder / "x.h5", good = folder / "good.h5";
  write_run(good, sample_run());
  const std::string bytes = bytes_of(good);
  const auto refusal = [&] {
    CHECK_FALSE(is_complete(path));
    return error_of<InputError>([&] { inspection_text(path); });
  };
  CHECK_THAT(refusal(), Contains("no such file"));
  put(path, "");
  CHECK_THAT(refusal(), Contains("is empty"));
  put(path, "time_s,volume_ml\n0,0\n");
  CHECK_THAT(refusal(), Contains("not an HDF5 file"));
  for (const std::size_t size : {std::size_t{9}, std::size_t{47}}) {
    put(path, bytes.substr(0, size));
    CHECK_THAT(refusal(), Contains("is truncated"));
  }
  const std::string whole = std::to_string(bytes.size());
  for (const std::size_t size :
       {std::size_t{48}, bytes.size() / 2, bytes.size() - 72 - 1, bytes.size() - 1}) {
    put(path, bytes.substr(0, size));
    CHECK_THAT(refusal(),
               Contains("is truncated: it has " + std::to_string(size) + " of " + whole + " bytes"));
  }
  CHECK_THAT(error_of<InputError>([&] { inspection_text(folder / ""); }), Contains("is a folder"));
}

TEST_CASE("Without its seal, a flipped bit gives an error or no change, but never another number",
          "[results]") {
  const TemporaryFolder folder;
  const fs::path path = folder / "run.h5";
  write_run(path, sample_run());
  const std::string bytes = without_seal(bytes_of(path));
  put(path, bytes);
  const StoredRun good = read_stored_run(path);
  const std::string description = inspection_text(path);
  std::mt19937 random(1);
  int seen = 0;
  constexpr int flips = 400;
  for (int flip = 0; flip < flips; ++flip) {
    std::string damaged = bytes;
    char& byte = damaged[std::uniform_int_distribution<std::size_t>(0, bytes.size() - 1)(random)];
    byte = static_cast<char>(byte ^ (1 << (flip % 8)));
    put(path, damaged);
    try {
      const std::string now = inspection_text(path);
      const StoredRun back = read_stored_run(path);
      // Unused space, and the references that name the axes: what is read is right.
      CHECK(now == description);
      CHECK(back.curve_dV_ml == good.curve_dV_ml);
      CHECK(back.measures.front().value == good.measures.front().value);
    } catch (const InputError&) {
      ++seen;
    }
  }
  INFO(seen << " of " << flips << " seen");
  CHECK(seen > flips / 3);
}

TEST_CASE("Any flipped bit is found before anything is read", "[results]") {
  const TemporaryFolder folder;
  const fs::path path = folder / "run.h5";
  write_run(path, sample_run());
  const std::string bytes = bytes_of(path);
  CHECK(bytes.substr(bytes.size() - seal_size) == "sha256 " + sha256_of_text(without_seal(bytes)) + "\n");
  std::mt19937 random(2);
  std::vector<std::size_t> places = {0, 8, 9, 28, 35, 44, bytes.size() - seal_size, bytes.size() - 1};
  for (std::size_t i = 0; i < seal_size; i += 5) places.push_back(bytes.size() - seal_size + i);
  for (int i = 0; i < 100; ++i)
    places.push_back(std::uniform_int_distribution<std::size_t>(0, bytes.size() - 1)(random));
  for (const std::size_t place : places) {
    std::string damaged = bytes;
    damaged[place] = static_cast<char>(damaged[place] ^ (1 << (place % 8)));
    put(path, damaged);
    INFO("byte " << place << " of " << bytes.size());
    CHECK_THAT(refusal_of(path), Contains("is damaged: its bytes have changed since it was written") ||
                                     Contains("damaged in its first bytes"));
  }
}

TEST_CASE("A file that another program changed is read without its seal, but not with bytes after its end",
          "[results]") {
  const TemporaryFolder folder;
  const fs::path path = folder / "run.h5";
  write_run(path, sample_run());
  const std::string bytes = bytes_of(path);
  put(path, without_seal(bytes));
  CHECK_THAT(inspection_text(path), Contains("466.125"));
  CHECK(read_stored_run(path).title == "healthy");
  put(path, without_seal(bytes) + "x");
  CHECK_THAT(refusal_of(path), Contains("is truncated"));
  put(path, without_seal(bytes) + std::string(seal_size, 'x'));
  CHECK_THAT(refusal_of(path), Contains("is damaged"));
  put(path, bytes + "more");
  CHECK_THAT(refusal_of(path), Contains("is damaged"));
}

TEST_CASE("A file that is not HDF5 is described by its content", "[results]") {
  const TemporaryFolder folder;
  const auto said_of = [&](const std::string& name, const std::string& bytes) {
    put(folder / name, bytes);
    return refusal_of(folder / name);
  };
  CHECK_THAT(said_of("fit.h5.ledger", std::string("SQLite format 3\0", 16)),
             Contains("ledger of an unfinished fit"));
  CHECK_THAT(said_of("x.h5.12-345.part", "\x01\x02"), Contains("interrupted program"));
  CHECK_THAT(said_of("healthy.toml", "title = 'x'"), Contains("`trunk check`"));
  CHECK_THAT(said_of("trace.csv", "time_s,volume_ml\n"), Contains("`trunk breaths`"));
  CHECK_THAT(said_of("report.html", "<!doctype html>"), Contains("web page"));
  CHECK_THAT(said_of("trunk.pml", "<?xml version=\"1.0\"?>"), Contains("XML"));
  CHECK_THAT(said_of("x", "hello"), Contains("expected a results file of trunk; it looks like text"));
  CHECK_THAT(said_of("y", "\x01\x02"), Contains("it looks like an unknown format"));
}
