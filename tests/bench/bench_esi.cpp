// SPDX-License-Identifier: Apache-2.0
// The catalogue of ESI files against parsing the same files and nothing else, and the memory that reading takes.
#include <fmt/format.h>
#include <sys/resource.h>
#include <sys/wait.h>
#include <tinyxml2.h>
#include <unistd.h>

#include <algorithm>
#include <filesystem>
#include <vector>

#include "bench/ratio_report.h"
#include "eni/catalogue/catalogue_query.h"
#include "eni/catalogue/catalogue_store.h"
#include "eni/catalogue/catalogue_update.h"
#include "eni/catalogue/esi_cards.h"
#include "eni/catalogue/esi_catalogue.h"
#include "eni/esi/esi_reader.h"
#include "eni/xml/xml_text.h"
#include "findings/error_text.h"
#include "sqlite/sqlite_database.h"
#include "tests/support/sample_folder.h"
#include "tests/support/source_dir.h"

namespace syncline::bench {
namespace {

namespace fs = std::filesystem;

constexpr int kRounds = 7;
constexpr double kMillisecondNs = 1e6;

/// A folder that goes with the bench.
class Scratch {
 public:
  Scratch() {
    std::string pattern = (fs::temp_directory_path() / "syncline-bench-XXXXXX").string();
    path_ = ::mkdtemp(pattern.data());
  }
  ~Scratch() { fs::remove_all(path_); }
  [[nodiscard]] std::string file(const std::string& name) const { return (path_ / name).string(); }

 private:
  fs::path path_;
};

double median(std::vector<double> found) {
  std::ranges::sort(found);
  return found[found.size() / 2];
}

std::vector<std::string> esi_files(const std::string& folder) {
  std::vector<std::string> files;
  for (const auto& entry : fs::directory_iterator(folder)) {
    if (entry.path().extension() == ".xml") files.push_back(entry.path().string());
  }
  return files;
}

/// tinyxml2 alone, as a program would use it.
double parse_ns(const std::vector<std::string>& files) {
  const double start = processor_seconds();
  for (const auto& file : files) {
    tinyxml2::XMLDocument document;
    (void)document.LoadFile(file.c_str());
  }
  return (processor_seconds() - start) * 1e9;
}

/// A new program: the database opened, the folder brought up to date.
double index_ns(const std::string& database, const std::string& folder, std::size_t& devices, std::size_t& read) {
  const double start = processor_seconds();
  auto catalogue = eni::EsiCatalogue::open(database);
  if (!catalogue) return 0;
  const auto report = catalogue->add_folder(folder);
  const double took = (processor_seconds() - start) * 1e9;
  if (!report) return 0;
  devices = catalogue->device_count();
  read = report->read;
  return took;
}

void bench_index(RatioReport& report) {
  const auto folder = test::sample_file("esi");
  if (!folder) return report.add_failure("cold index", "the sample ESI files are not here");
  const auto files = esi_files(*folder);
  const Scratch scratch;
  const auto database = scratch.file("catalogue.db");
  (void)parse_ns(files);  // the files are in memory from here on
  std::vector<double> parse, cold, warm;
  std::size_t devices = 0, read = 0;
  for (int i = 0; i < kRounds; ++i) {  // by turns: what disturbs one disturbs the other
    parse.push_back(parse_ns(files));
    fs::remove(database);
    cold.push_back(index_ns(database, *folder, devices, read));
    if (read != files.size()) return report.add_failure("cold index", fmt::format("{} files read", read));
    warm.push_back(index_ns(database, *folder, devices, read));
    if (read != 0) return report.add_failure("warm start", fmt::format("{} files read again", read));
  }
  report.add(fmt::format("cold index, {} files, {} devices", files.size(), devices), median(cold),
             "tinyxml2 parses them", median(parse), 1.5);
  report.add("warm start, nothing changed", median(warm), "cold index", median(cold), 0.02);
}

// ---- memory ----------------------------------------------------------------------------------------

/// The devices of our own files over and over, without the white space that makes a file large and a tree no larger.
std::string large_esi() {
  constexpr std::size_t kSize = 32U << 20;
  std::string devices;
  for (const auto& file : esi_files(test::source_dir() + "/resources/esi")) {
    const auto text = eni::read_file(file).value_or("");
    const auto begin = text.find("<Device "), end = text.rfind("</Device>");
    if (begin == std::string::npos || end == std::string::npos) continue;
    for (std::size_t at = begin; at < end + 9;) {
      devices.push_back(text[at++]);
      if (devices.back() == '>' || text[at] == '\n') at = std::min(text.find_first_not_of(" \r\n\t", at), text.size());
    }
  }
  std::string out = "<EtherCATInfo><Vendor><Id>1</Id><Name>V</Name></Vendor><Descriptions><Groups/><Devices>";
  while (!devices.empty() && out.size() < kSize) out += devices;
  return out + "</Devices></Descriptions></EtherCATInfo>";
}

/// Bytes by which a process of its own grows at most while it does that; 0 where it failed.
double grown_bytes(const std::function<bool()>& action) {
  int ends[2];
  if (::pipe(ends) != 0) return 0;
  const pid_t child = ::fork();
  if (child == 0) {
    rusage before{}, after{};
    ::getrusage(RUSAGE_SELF, &before);
    const bool done = action();
    ::getrusage(RUSAGE_SELF, &after);
    const double grown = done ? static_cast<double>(after.ru_maxrss - before.ru_maxrss) * 1024 : 0;
    const bool told = ::write(ends[1], &grown, sizeof grown) == sizeof grown;
    ::_exit(told ? 0 : 1);
  }
  double grown = 0;
  ::close(ends[1]);
  const bool told = child > 0 && ::read(ends[0], &grown, sizeof grown) == sizeof grown;
  ::close(ends[0]);
  int status = 0;
  ::waitpid(child, &status, 0);
  return told ? grown : 0;
}

/// Beside the text itself, which is there once.
void bench_memory(RatioReport& report) {
  const std::string text = large_esi();
  const auto size = static_cast<double>(text.size());
  const double cards = grown_bytes([&] { return eni::read_cards(text, "large.xml").has_value(); });
  const double devices = grown_bytes([&] {
    const auto file = eni::parse_esi(text, "large.xml");
    return file && !file->devices.empty();
  });
  if (cards == 0 || devices == 0) return report.add_failure("memory", "the large file was not read");
  constexpr double kMega = 1U << 20;
  report.add_count(fmt::format("memory to index {:.0f} MB of ESI", size / kMega), cards / kMega, "MB", size / kMega,
                   "MB", 1);
  report.add_count(fmt::format("memory to read {:.0f} MB of ESI", size / kMega), devices / kMega, "MB", size / kMega,
                   "MB", 8);
}

// ---- a large catalogue -----------------------------------------------------------------------------

constexpr std::uint32_t kFiles = 500, kProducts = 20, kRevisions = 5;  // 50,000 devices

eni::EsiCards cards_of(std::uint32_t file) {
  eni::EsiCards cards;
  for (std::uint32_t product = 0; product < kProducts; ++product) {
    for (std::uint32_t revision = 1; revision <= kRevisions; ++revision) {
      eni::EsiCard card;
      card.identity = {file % 40 + 1, file * 1'000 + product, revision << 16, 0};
      card.place = static_cast<int>(product * kRevisions + revision);
      card.vendor_name = fmt::format("Vendor {}", file % 40 + 1);
      card.type = fmt::format("EL{}-{:04}", 1'000 + file * 7 % 9'000, product);
      card.name =
          fmt::format("{}Ch. Digital {} 24V, {}us", product % 8 + 1, product % 2 == 0 ? "Input" : "Output", file);
      card.group_type = product % 2 == 0 ? "DigIn" : "DigOut";
      card.group_name = product % 2 == 0 ? "Digital input terminals" : "Digital output terminals";
      card.revision_rule = "EQ_OR_G";
      if (revision > 1) card.hides.push_back({card.identity.product_code, (revision - 1) << 16});
      cards.cards.push_back(card);
    }
  }
  return cards;
}

Status fill(eni::CatalogueStore& store) {
  auto transaction = SqlTransaction::begin(store.database());
  if (!transaction) return tl::unexpected(transaction.error());
  for (std::uint32_t file = 0; file < kFiles; ++file) {
    const auto id = store.put(fmt::format("/esi/{:04}.xml", file), {}, cards_of(file));
    if (!id) return tl::unexpected(id.error());
    if (auto status = store.choose(*id); !status) return status;
  }
  return transaction->commit();
}

void bench_lookup(RatioReport& report) {
  const Scratch scratch;
  Reason replaced;
  auto store = eni::CatalogueStore::open(scratch.file("catalogue.db"), replaced);
  if (!store) return report.add_failure("look-up", describe(store.error()));
  if (const auto status = fill(*store); !status) return report.add_failure("look-up", describe(status.error()));
  const auto devices = store->device_count().value_or(0);
  if (devices != kFiles * kProducts * kRevisions)
    return report.add_failure("look-up", fmt::format("{} devices", devices));
  std::uint32_t n = 0;
  bool found_all = true;
  const double lookup = median_ns([&] {
    n = n * 1'103'515'245 + 12'345;
    const std::uint32_t file = (n >> 8) % kFiles;
    const Identity identity{file % 40 + 1, file * 1'000 + (n >> 20) % kProducts, 0x00030001, 0};
    const auto entries = eni::entries_of(*store, identity.vendor_id, identity.product_code);
    found_all = found_all && entries && eni::best_match(*entries, identity)->kind == eni::MatchKind::kRule;
  });
  if (!found_all) return report.add_failure("look-up", "an identity was not found");
  report.add(fmt::format("look-up of an identity among {} devices", devices), lookup, "a millisecond", kMillisecondNs,
             1);
  for (const char* words : {"E", "EL21", "dig outp", "vendor 7 out", "nothing like this"}) {
    const double search = median_ns([&] { (void)eni::search(*store, {.words = words}); });
    report.add(fmt::format("search \"{}\" among {} devices", words, devices), search, "a frame of the screen",
               16 * kMillisecondNs, 1);
  }
}

}  // namespace
}  // namespace syncline::bench

int main() {
  syncline::bench::RatioReport report;
  syncline::bench::bench_memory(report);  // while there is no memory left over from anything else
  syncline::bench::bench_index(report);
  syncline::bench::bench_lookup(report);
  return report.finish("Catalogue of ESI files");
}
