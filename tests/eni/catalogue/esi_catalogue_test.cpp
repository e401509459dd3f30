// SPDX-License-Identifier: Apache-2.0
#include "eni/catalogue/esi_catalogue.h"

#include <gmock/gmock.h>
#include <unistd.h>

#include <chrono>
#include <cstdlib>
#include <filesystem>
#include <optional>
#include <utility>

#include "config/dc_description.h"
#include "config/device_description.h"
#include "eni/catalogue/esi_folder.h"
#include "eni/catalogue/revision_words.h"
#include "eni/catalogue/usual_sources.h"
#include "eni/xml/file_warning.h"
#include "findings/error_text.h"
#include "findings/figure.h"
#include "sqlite/sqlite_database.h"

namespace syncline::eni {
namespace {

using ::testing::ElementsAre;
using ::testing::Field;
using ::testing::HasSubstr;
using ::testing::IsEmpty;
using ::testing::SizeIs;

MATCHER_P4(ReportIs, files, read, touched, removed, "") {
  const std::vector<std::size_t> found{arg->files, arg->read, arg->touched, arg->removed};
  *result_listener << testing::PrintToString(found);
  return found == std::vector<std::size_t>{static_cast<std::size_t>(files), static_cast<std::size_t>(read),
                                           static_cast<std::size_t>(touched), static_cast<std::size_t>(removed)};
}

class Catalogue : public EsiFolderTest {
 protected:
  [[nodiscard]] EsiCatalogue opened() const { return std::move(*EsiCatalogue::open(database())); }
  /// Folder added in a new program.
  [[nodiscard]] Result<IndexReport> update() const { return opened().add_folder(folder().string()); }
  [[nodiscard]] static std::vector<std::string> types(const EsiCatalogue& catalogue, const CatalogueSearch& search) {
    std::vector<std::string> found;
    const auto entries = catalogue.search(search);
    if (!entries) return {describe(entries.error())};
    for (const auto& entry : *entries) found.push_back(entry.type);
    return found;
  }
};

TEST_F(Catalogue, KeepsWhatItReadAndReadsOnlyWhatChanged) {
  put("a.xml", esi_text({{1, 0x10, "A1"}}));
  put("sub/b.XML", esi_text({{2, 0x10, "B1"}, {3, 0x10, "B2"}}));
  put("notes.txt", "no ESI");
  EXPECT_THAT(update(), ReportIs(2, 2, 0, 0));
  EXPECT_THAT(update(), ReportIs(2, 0, 0, 0));

  put("a.xml", esi_text({{1, 0x10, "A1"}}), 50);  // another time, the same content
  EXPECT_THAT(update(), ReportIs(2, 0, 1, 0));
  EXPECT_THAT(update(), ReportIs(2, 0, 0, 0));

  put("a.xml", esi_text({{1, 0x11, "A1"}}), 40);
  EXPECT_THAT(update(), ReportIs(2, 1, 0, 0));
  auto catalogue = opened();
  ASSERT_TRUE(catalogue.add_folder(folder().string()));
  EXPECT_EQ(catalogue.match({0x5EC, 1, 0x10, 0})->entry.identity.revision_no, 0x11U);

  std::filesystem::remove(file("sub/b.XML"));
  EXPECT_THAT(update(), ReportIs(1, 0, 0, 1));
  auto after = opened();
  ASSERT_TRUE(after.add_folder(folder().string()));
  EXPECT_EQ(after.device_count(), 1U);
  EXPECT_THAT(types(after, {"B"}), IsEmpty());
}

TEST_F(Catalogue, LooksTwiceIntoAFileThatWasWrittenJustNow) {
  put("a.xml", esi_text({{1, 0x10}}), 0);
  const auto time = std::filesystem::last_write_time(file("a.xml"));
  EXPECT_THAT(update(), ReportIs(1, 1, 0, 0));
  std::ofstream(file("a.xml")) << esi_text({{1, 0x11}});  // the same size, and the file system's clock did not tick
  std::filesystem::last_write_time(file("a.xml"), time);
  EXPECT_THAT(update(), ReportIs(1, 1, 0, 0));
}

TEST_F(Catalogue, TellsItsProgressAndKeepsWhatWasReadBeforeItIsCancelled) {
  for (const char* name : {"a.xml", "b.xml", "c.xml"}) put(name, esi_text({{1, 0x10, name}}));
  std::vector<std::string> seen;
  const auto two = [&](const IndexProgress& progress) {
    EXPECT_EQ(progress.files, 3U);
    EXPECT_EQ(progress.files_done, seen.size());
    seen.push_back(std::filesystem::path(progress.file).filename().string());
    return seen.size() < 3;
  };
  auto catalogue = opened();
  const auto report = catalogue.add_folder(folder().string(), two);
  ASSERT_TRUE(report);
  EXPECT_TRUE(report->cancelled);
  EXPECT_EQ(report->read, 2U);
  EXPECT_THAT(seen, ElementsAre("a.xml", "b.xml", "c.xml"));
  EXPECT_EQ(catalogue.device_count(), 2U);
  EXPECT_THAT(update(), ReportIs(3, 1, 0, 0));
}

TEST_F(Catalogue, SearchesTheFoldersOfThisProgramOnly) {
  put("a.xml", esi_text({{1, 0x10, "A1"}}));
  put("sub/b.xml", esi_text({{2, 0x10, "B1"}}));
  ASSERT_TRUE(update());
  auto catalogue = opened();
  EXPECT_EQ(catalogue.device_count(), 0U);
  EXPECT_EQ(catalogue.match({0x5EC, 2, 0x10, 0}).error().code, ErrorCode::kUnknownDevice);
  ASSERT_TRUE(catalogue.add_folder((folder() / "sub").string()));
  EXPECT_THAT(types(catalogue, {}), ElementsAre("B1"));
  EXPECT_FALSE(catalogue.find({0x5EC, 1, 0x10, 0}));
  EXPECT_TRUE(catalogue.find({0x5EC, 2, 0x10, 0}));
}

TEST(RevisionWords, AreTakenOutOfTheWords) {
  using Range = RevisionWords::Range;
  EXPECT_EQ(revision_words("EL2004 dig"), (RevisionWords{"EL2004 dig", {}, {}}));
  EXPECT_EQ(revision_words("el #X00120000"), (RevisionWords{"el", {0x120000}, {}}));
  EXPECT_EQ(revision_words("0x00120000 el"), (RevisionWords{"el", {0x120000}, {}})) << "as the window writes it";
  EXPECT_EQ(revision_words("0x44c2"), (RevisionWords{"0x44c2", {}, {}})) << "the beginning of a product code";
  EXPECT_EQ(revision_words("el Rev 18"), (RevisionWords{"el", {}, Range{0x120000, 0x12FFFF}}));
  EXPECT_EQ(revision_words("rev 16-18 el"), (RevisionWords{"el", {}, Range{0x100000, 0x12FFFF}}));
  EXPECT_EQ(revision_words("rev 18-16"), (RevisionWords{"", {}, Range{0x100000, 0x12FFFF}})) << "the other way round";
  EXPECT_EQ(revision_words("rev 16-"), (RevisionWords{"", {}, Range{0x100000, UINT32_MAX}}));
  EXPECT_EQ(revision_words("rev -#x11"), (RevisionWords{"", {}, Range{0, 0x11}}));
  for (const char* word : {"rev", "rev el", "rev -", "rev 99999999999", "#x0012000", "#x00120000g"}) {
    EXPECT_EQ(revision_words(word), (RevisionWords{word, {}, {}})) << "a word like others";
  }
}

TEST_F(Catalogue, FindsRevisions) {
  put("a.xml", esi_text({{1, 0x00100000, "EL2004"},
                         {1, 0x00110000, "EL2004"},
                         {1, 0x00120000, "EL2004", "Thing", "Digital", "<HideType RevisionNo=\"#x00100000\"/>"},
                         {2, 0x00120000, "EL1004"},
                         {3, 18, "Counts from one"},
                         {0x00120000, 5, "Its product code"}}));
  EsiCatalogue catalogue;
  ASSERT_TRUE(catalogue.add_folder(folder().string()));
  const auto revisions = [&](const char* words) {
    std::vector<std::uint32_t> found;
    const auto entries = catalogue.search({.words = words});
    for (const auto& entry : *entries) found.push_back(entry.identity.revision_no);
    return found;
  };
  EXPECT_THAT(revisions("el2004"), ElementsAre(0x00120000U)) << "the newest";
  EXPECT_THAT(revisions("el2004 #x00110000"), ElementsAre(0x00110000U));
  EXPECT_THAT(revisions("el2004 rev 17"), ElementsAre(0x00110000U));
  EXPECT_THAT(revisions("el2004 rev 16-17"), ElementsAre(0x00110000U, 0x00100000U)) << "hidden or not: it is named";
  EXPECT_THAT(revisions("el2004 rev 17-"), ElementsAre(0x00120000U, 0x00110000U));
  EXPECT_THAT(types(catalogue, {"rev 18"}), ElementsAre("Counts from one", "EL1004", "EL2004"));
  EXPECT_THAT(types(catalogue, {"#x00120000"}), ElementsAre("EL1004", "EL2004", "Its product code"));
  EXPECT_THAT(revisions("el2004 rev 19"), IsEmpty());
}

TEST_F(Catalogue, FindsWhileSomebodyTypes) {
  put("a.xml", esi_text({{1, 0x10, "EL2004", "4K. Dig. Ausgang 24V"},
                         {1, 0x11, "EL2004", "4Ch. Dig. Output 24V"},
                         {2, 0x10, "EL2004-0010", "4Ch. Dig. Output 24V"},
                         {3, 0x10, "EK1100", "Koppler für EtherCAT"},
                         {0x44C2C52, 0x10, "EL1100", "", "Analogue"}}));
  put("b.xml", esi_text({{1, 0x10, "XEL 2", "Drive"}}, "Łódź Drives", 7));
  EsiCatalogue catalogue;
  ASSERT_TRUE(catalogue.add_folder(folder().string()));
  EXPECT_THAT(types(catalogue, {"el20"}), ElementsAre("EL2004", "EL2004-0010"));
  EXPECT_EQ(catalogue.search({"el20"})->front().identity.revision_no, 0x11U);  // the newest stands for all
  EXPECT_THAT(types(catalogue, {.words = "el20", .all_revisions = true}),
              ElementsAre("EL2004", "EL2004", "EL2004-0010"));
  EXPECT_THAT(types(catalogue, {"EL2004-0"}), ElementsAre("EL2004-0010"));
  EXPECT_THAT(types(catalogue, {"2004"}), ElementsAre("EL2004", "EL2004-0010"));  // users remember numbers
  EXPECT_THAT(types(catalogue, {"outp dig maker"}), ElementsAre("EL2004", "EL2004-0010"));
  EXPECT_THAT(types(catalogue, {"digital term"}), testing::Not(IsEmpty()));  // the group's name
  EXPECT_THAT(types(catalogue, {"fur"}), ElementsAre("EK1100"));
  EXPECT_THAT(types(catalogue, {"0x44c2"}), ElementsAre("EL1100"));
  EXPECT_THAT(types(catalogue, {"el"}), ElementsAre("EL1100", "EL2004", "EL2004-0010"));
  EXPECT_THAT(types(catalogue, {"łód"}), ElementsAre("XEL 2"));
  EXPECT_THAT(types(catalogue, {.words = "", .vendor_id = 7}), ElementsAre("XEL 2"));
  EXPECT_THAT(types(catalogue, {.words = "", .product_code = 3}), ElementsAre("EK1100"));
  EXPECT_THAT(types(catalogue, {.words = "0x00000003"}), ElementsAre("EK1100")) << "as vendors and we write it";
  EXPECT_THAT(types(catalogue, {.words = "el", .group_type = "Analogue"}), ElementsAre("EL1100"));
  EXPECT_THAT(types(catalogue, {.words = "", .limit = 2}), SizeIs(2));
  for (const char* strange : {"\"", "* OR *", "NEAR(", "a:b", "'; DROP TABLE devices", "\xFF", "%", "-"}) {
    EXPECT_TRUE(catalogue.search({strange})) << strange;
  }
  EXPECT_EQ(catalogue.device_count(), 6U);
}

TEST_F(Catalogue, LeavesOutWhatANewerDeviceHides) {
  put("a.xml", esi_text({{1, 0x10, "A1"},
                         {1, 0x11, "A2", "", "", "<HideType RevisionNo=\"#x10\"/>"},
                         {2, 0x10, "B1"},
                         {3, 0x10, "C1", "", "", "<HideType ProductCode=\"2\">B1</HideType>"}}));
  EsiCatalogue catalogue;
  ASSERT_TRUE(catalogue.add_folder(folder().string()));
  EXPECT_THAT(types(catalogue, {}), ElementsAre("A2", "C1"));
  EXPECT_THAT(types(catalogue, {.with_hidden = true}), ElementsAre("A1", "A2", "B1", "C1"));
  const auto match = catalogue.match({0x5EC, 1, 0x10, 0});  // found on a bus it is what it is
  ASSERT_TRUE(match);
  EXPECT_EQ(match->kind, MatchKind::kExact);
  EXPECT_TRUE(match->entry.hidden);
}

TEST_F(Catalogue, ReportsDuplicatesAndConflicts) {
  put("a.xml", esi_text({{1, 0x10, "A1"}, {2, 0x10, "B1"}, {3, 0x10, "C1"}, {0, 0, "P1"}, {0, 0, "P2"}}));
  put("b.xml",
      "<?xml version=\"1.0\"?>\n" + esi_text({{1, 0x10, "A1", "Thing<!-- comment -->"}, {2, 0x10, "B1", "Other"}}));
  EsiCatalogue catalogue;
  ASSERT_TRUE(catalogue.add_folder(folder().string()));
  const auto found = *catalogue.duplicates();
  ASSERT_THAT(found, SizeIs(2));
  EXPECT_EQ(found[0].identity.product_code, 1U);
  EXPECT_FALSE(found[0].conflict);
  EXPECT_EQ(found[1].identity.product_code, 2U);
  EXPECT_TRUE(found[1].conflict);
  EXPECT_THAT(found[1].entries,
              ElementsAre(Field(&CatalogueEntry::file, file("a.xml")), Field(&CatalogueEntry::file, file("b.xml"))));
  const auto match = *catalogue.match({0x5EC, 2, 0x10, 0});
  EXPECT_EQ(match.entry.file, file("a.xml"));
  EXPECT_THAT(match.words, HasSubstr("b.xml line"));
  EXPECT_THAT(catalogue.match({0x5EC, 1, 0x10, 0})->words, testing::Not(HasSubstr("b.xml")));
}

TEST_F(Catalogue, TellsOfFilesThatCannotBeReadEachTime) {
  put("bad.xml", "<EtherCATInfo>\n<Vendor>");
  put("eni.xml", "<EtherCATConfig/>");
  put("module.xml", "<EtherCATModule/>");
  put("part.xml", esi_text({{1, 0x10, "A1"}, {2, 0x10, "B1", "", "", "", "SerialNo=\"1\" CheckRevisionNo=\"EQ\""}}));
  put("device.xml",
      "<EtherCATInfo><Vendor><Id>1</Id></Vendor><Descriptions><Devices>\n<Device><Type ProductCode=\"x\">T</Type>"
      "</Device></Devices></Descriptions></EtherCATInfo>");
  for (int twice = 0; twice < 2; ++twice) {
    auto catalogue = opened();
    ASSERT_TRUE(catalogue.add_folder(folder().string()));
    const auto warnings = catalogue.warnings();
    ASSERT_THAT(warnings, SizeIs(3));
    EXPECT_THAT(warnings[0].file, HasSubstr("bad.xml"));
    EXPECT_EQ(warnings[0].line, 2);
    EXPECT_THAT(warnings[1].file, HasSubstr("device.xml"));
    EXPECT_EQ(warnings[1].line, 2);
    EXPECT_THAT(warnings[1].reason.text(), HasSubstr("Device T is left out"));
    EXPECT_THAT(warnings[2].reason.text(), HasSubstr("EtherCATConfig"));
    EXPECT_EQ(catalogue.device_count(), 2U);
  }
  EsiCatalogue one;
  EXPECT_EQ(one.add_file(file("bad.xml")).error().code, ErrorCode::kXmlMalformed);
  EXPECT_EQ(one.add_file(file("none.xml")).error().code, ErrorCode::kFileNotFound);
  EXPECT_TRUE(one.add_file(file("part.xml")));
}

TEST_F(Catalogue, ReadsTheWholeDeviceFromItsFileWhenAsked) {
  put("a.xml",
      esi_text({{1, 0x10, "A1", "Thing", "Digital", "<Sm StartAddress=\"#x1000\" ControlByte=\"#x26\">MBoxOut</Sm>"}}));
  auto catalogue = opened();
  ASSERT_TRUE(catalogue.add_folder(folder().string()));
  const auto match = catalogue.device_for({0x5EC, 1, 0x10, 0});
  ASSERT_TRUE(match);
  EXPECT_THAT(match->device->sync_managers, SizeIs(1));
  EXPECT_EQ(match->device->vendor_name, "Maker & Sons");
  EXPECT_EQ(match->device, catalogue.find({0x5EC, 1, 0x10, 0})->device);

  auto later = opened();
  ASSERT_TRUE(later.add_folder(folder().string()));
  put("a.xml", esi_text({{2, 0x10, "A2"}}));  // changed behind the catalogue's back
  EXPECT_EQ(later.device_for({0x5EC, 1, 0x10, 0}).error().code, ErrorCode::kUnknownDevice);
  auto gone = opened();
  ASSERT_TRUE(gone.add_folder(folder().string()));
  std::filesystem::remove(file("a.xml"));
  EXPECT_EQ(gone.device_for({0x5EC, 2, 0x10, 0}).error().code, ErrorCode::kFileNotFound);
}

TEST_F(Catalogue, RemembersAndForgetsAFolder) {
  put("a.xml", esi_text({{1, 0x10, "A1"}}));
  auto catalogue = opened();
  ASSERT_TRUE(catalogue.add_folder(folder().string()));
  EXPECT_THAT(*catalogue.known_folders(), IsEmpty());  // used once is not kept
  ASSERT_TRUE(catalogue.remember_folder(folder().string()));
  EXPECT_THAT(*opened().known_folders(), ElementsAre(folder().string()));
  ASSERT_TRUE(catalogue.forget_folder(folder().string()));
  EXPECT_THAT(*catalogue.known_folders(), IsEmpty());
  EXPECT_EQ(catalogue.device_count(), 0U);
}

// ---- databases that went wrong ---------------------------------------------------------------------

TEST_F(Catalogue, MakesADamagedDatabaseAgainAndSaysSo) {
  for (int i = 0; i < 40; ++i) put(std::to_string(i) + ".xml", esi_text({{1, static_cast<std::uint32_t>(i), "A1"}}));
  ASSERT_TRUE(update());
  {  // behind the header everything is gone
    std::fstream stream(database(), std::ios::in | std::ios::out | std::ios::binary);
    stream.seekp(100);
    stream << std::string(std::filesystem::file_size(database()) - 100, '\xA5');
  }
  auto catalogue = opened();
  EXPECT_THAT(catalogue.add_folder(folder().string()), ReportIs(40, 40, 0, 0));
  ASSERT_THAT(catalogue.notes(), SizeIs(1));
  EXPECT_THAT(catalogue.notes()[0].reason.text(), HasSubstr("made again: it was damaged"));
  EXPECT_THAT(update(), ReportIs(40, 0, 0, 0));
}

/// Whatever it is called: by what stands behind SQLite's header it is known for ours.
TEST_F(Catalogue, MakesOneWhoseBeginningIsDamagedAgain) {
  put("a.xml", esi_text({{}}));
  for (const std::size_t length : {1U, 16U, 100U}) {
    ASSERT_TRUE(update());
    {
      std::fstream stream(database(), std::ios::in | std::ios::out | std::ios::binary);
      stream << std::string(length, '\x5A');
    }
    auto catalogue = opened();
    EXPECT_THAT(catalogue.add_folder(folder().string()), ReportIs(1, 1, 0, 0)) << length;
    ASSERT_THAT(catalogue.notes(), SizeIs(1)) << length;
    EXPECT_THAT(catalogue.notes()[0].reason.text(), HasSubstr("made again: it was damaged"));
  }
}

/// A file of which nothing says that it is ours stays as it is, and the sentence tells what to do.
TEST_F(Catalogue, LeavesWhatCannotBeKnownForOurs) {
  put("a.xml", esi_text({{}}));
  ASSERT_TRUE(update());
  const auto size = std::filesystem::file_size(database());
  const std::string own_words =
      "CREATE TABLE hides(device INTEGER NOT NULL, vendor_id INTEGER, product_code INTEGER);\n";
  std::string script;
  while (script.size() < size) script += own_words;
  script.resize(size);
  for (const std::string& other : {std::string(size, '\0'), script}) {
    std::ofstream(database(), std::ios::binary) << other;
    auto catalogue = EsiCatalogue::open(database());
    const auto added = catalogue ? catalogue->add_folder(folder().string()) : tl::unexpected(catalogue.error());
    ASSERT_FALSE(added);
    EXPECT_THAT(describe(added.error()), HasSubstr("Delete it"));
    std::ifstream in(database(), std::ios::binary);
    EXPECT_EQ(std::string(std::istreambuf_iterator<char>(in), {}), other);
  }
}

TEST_F(Catalogue, SurvivesADatabaseThatIsDamagedAnywhere) {
  for (int i = 0; i < 40; ++i) put(std::to_string(i) + ".xml", esi_text({{1, static_cast<std::uint32_t>(i), "A1"}}));
  ASSERT_TRUE(update());
  ASSERT_TRUE(opened().remember_folder(folder().string()));
  const auto size = std::filesystem::file_size(database());
  const auto good = database() + ".good";
  std::filesystem::copy_file(database(), good);
  constexpr std::size_t kPage = 4096;
  std::size_t forgotten = 0;
  for (std::size_t page = 1; page < size / kPage; ++page) {
    std::filesystem::copy_file(good, database(), std::filesystem::copy_options::overwrite_existing);
    {
      std::fstream stream(database(), std::ios::in | std::ios::out | std::ios::binary);
      stream.seekp(static_cast<std::streamoff>(page * kPage));
      stream << std::string(kPage, '\x5A');
    }
    auto catalogue = opened();
    const auto report = catalogue.add_folder(folder().string());
    ASSERT_TRUE(report) << "page " << page << ": " << describe(report.error());
    const auto match = catalogue.match({0x5EC, 1, 7, 0});
    ASSERT_TRUE(match) << "page " << page << ": " << describe(match.error());
    EXPECT_EQ(match->kind, MatchKind::kExact);
    EXPECT_TRUE(catalogue.search({"maker"})) << "page " << page;
    forgotten += catalogue.known_folders().value_or(std::vector<std::string>{}).empty() ? 1U : 0U;
  }
  EXPECT_LE(forgotten, 2U) << "only where the pages that hold it are gone";
}

TEST_F(Catalogue, MakesADatabaseOfAnotherVersionAgain) {
  put("a.xml", esi_text({{1, 0x10, "A1"}}));
  ASSERT_TRUE(update());
  ASSERT_TRUE(SqlDatabase::open(database())->execute("PRAGMA user_version=99; DROP TABLE devices"));
  auto catalogue = opened();
  EXPECT_THAT(catalogue.add_folder(folder().string()), ReportIs(1, 1, 0, 0));
  ASSERT_THAT(catalogue.notes(), SizeIs(1));
  EXPECT_THAT(catalogue.notes()[0].reason.text(), HasSubstr("version 99"));
}

TEST_F(Catalogue, LeavesFilesOfOthersAlone) {
  const auto project = file("machine.syncline");
  put("machine.syncline", "a project that somebody named as cache by mistake");
  const auto opened_project = EsiCatalogue::open(project);
  ASSERT_FALSE(opened_project);
  EXPECT_EQ(opened_project.error().code, ErrorCode::kCatalogue);
  EXPECT_EQ(opened_project.error().file, project);
  EXPECT_EQ(std::filesystem::file_size(project), 49U);

  const auto foreign = file("photos.db");
  ASSERT_TRUE(SqlDatabase::open(foreign)->execute("CREATE TABLE photos(name)"));
  const auto size = std::filesystem::file_size(foreign);
  EXPECT_FALSE(EsiCatalogue::open(foreign));
  EXPECT_EQ(std::filesystem::file_size(foreign), size);
}

/// SQLite would write its pages into it, whatever stands there.
TEST_F(Catalogue, LeavesDevicesAlone) {
  std::filesystem::create_symlink("/dev/null", file("device"));
  for (const auto& path : {std::string("/dev/null"), file("device"), file("")}) {
    const auto opened = EsiCatalogue::open(path);
    ASSERT_FALSE(opened) << path;
    EXPECT_THAT(describe(opened.error()), HasSubstr("no ordinary file")) << path;
  }
  EXPECT_FALSE(std::filesystem::exists(file("device-journal")));
}

TEST_F(Catalogue, WorksWithoutAPlaceForItsDatabase) {
  put("a.xml", esi_text({{1, 0x10, "A1"}}));
  put("nofolder", "a file where the cache's folder should be");
  ::setenv("XDG_CACHE_HOME", file("nofolder").c_str(), 1);
  auto catalogue = EsiCatalogue::open_default();
  ::unsetenv("XDG_CACHE_HOME");
  EXPECT_THAT(catalogue.add_folder(folder().string()), ReportIs(1, 1, 0, 0));
  ASSERT_THAT(catalogue.notes(), SizeIs(1));
  EXPECT_THAT(catalogue.notes()[0].reason.text(), HasSubstr("read anew each time"));
  EXPECT_TRUE(catalogue.find({0x5EC, 1, 0x10, 0}));
}

TEST_F(Catalogue, TwoProgramsMayIndexTheSameFolder) {
  for (int i = 0; i < 10; ++i) put(std::to_string(i) + ".xml", esi_text({{1, static_cast<std::uint32_t>(i), "A1"}}));
  auto first = opened(), second = opened();
  ASSERT_TRUE(first.add_folder(folder().string()));
  put("0.xml", esi_text({{1, 0x100, "A1"}}), 30);
  EXPECT_THAT(second.add_folder(folder().string()), ReportIs(10, 1, 0, 0));
  EXPECT_EQ(first.match({0x5EC, 1, 0x100, 0})->kind, MatchKind::kExact);
  EXPECT_EQ(second.device_count(), 10U);
}

/// Each step once a device: 20,000 devices of one identity took 22 s when each was compared with all.
/// Devices of one identity are compared by their contents; their files are read for that once.
TEST_F(Catalogue, ContentsThatWereComparedAreKept) {
  put("a.xml", esi_text({{1, 0x10, "A1"}, {2, 0x10, "B1"}}));
  put("b.xml", esi_text({{2, 0x10, "B1", "Other"}, {3, 0x10, "C1"}}));
  auto catalogue = opened();
  ASSERT_TRUE(catalogue.add_folder(folder().string()));
  const auto known = [&] {
    return *SqlDatabase::open_to_read(database())->number("SELECT count(*) FROM devices WHERE content <> 0");
  };
  EXPECT_EQ(known(), 0);
  ASSERT_TRUE(catalogue.match({0x5EC, 1, 0x10, 0}));
  EXPECT_EQ(known(), 0) << "nothing to compare it with";
  EXPECT_THAT(catalogue.match({0x5EC, 2, 0x10, 0})->words, HasSubstr("b.xml line"));
  EXPECT_EQ(known(), 4) << "of all in both files";
}

TEST_F(Catalogue, ManyDevicesOfOneIdentityTakeLinearTime) {
  constexpr std::size_t kDevices = 20'000;
  std::vector<EsiText> devices(kDevices);
  for (std::size_t i = 0; i < kDevices; ++i) {
    if (i % 2 == 0) devices[i].revision = static_cast<std::uint32_t>(i);  // and many revisions, twice each
    if (i % 2 == 1) devices[i].revision = static_cast<std::uint32_t>(i - 1);
  }
  put("a.xml", esi_text(devices));
  put("b.xml", esi_text(std::vector<EsiText>(kDevices)));
  const auto begin = std::chrono::steady_clock::now();
  auto catalogue = opened();
  ASSERT_TRUE(catalogue.add_folder(folder().string()));
  const auto found = catalogue.duplicates();
  ASSERT_TRUE(found);
  EXPECT_EQ(found->size(), kDevices / 2);  // one of the pairs is in b.xml, too
#if !defined(SYNCLINE_SANITIZED)
  EXPECT_LT(std::chrono::steady_clock::now() - begin, std::chrono::seconds(12));
#else
  static_cast<void>(begin);
#endif
  int asked = 0;
  EXPECT_THAT(*catalogue.duplicates([&] { return ++asked < 10; }), IsEmpty()) << "given up";
  EXPECT_EQ(asked, 10);
}

TEST_F(Catalogue, PartsWithoutAControllerAreNoDevices) {
  put("a.xml",
      "<EtherCATInfo><Vendor><Id>2</Id><Name>M</Name></Vendor><Descriptions><Groups/><Devices>"
      "<Device Physics=\"\" Invisible=\"1\"><Type>EC9011</Type><Name>End cap</Name></Device>"
      "<Device Physics=\"KK\"><Type>EC9100</Type><Name>Supply</Name></Device>"
      "<Device Physics=\"YY\"><Type ProductCode=\"7\" RevisionNo=\"1\">EC7</Type></Device>"
      "</Devices></Descriptions></EtherCATInfo>");
  auto catalogue = opened();
  ASSERT_TRUE(catalogue.add_folder(folder().string()));
  EXPECT_THAT(types(catalogue, {.with_hidden = true}), ElementsAre("EC7"));
  EXPECT_FALSE(catalogue.match({2, 0, 0, 0})) << "a slave with an empty EEPROM is no end cap";
  EXPECT_TRUE(catalogue.find({2, 7, 1, 0}));
}

/// Nobody may look into `closed` meanwhile, not even root.
class ClosedFolder {
 public:
  ClosedFolder(const std::filesystem::path& parent, const std::filesystem::path& closed) : closed_(closed) {
    std::filesystem::permissions(closed_, std::filesystem::perms::none);
    if (!root_) return;
    constexpr ::uid_t kNobody = 65534;
    std::filesystem::permissions(parent, std::filesystem::perms::all);
    is_closed_ = ::seteuid(kNobody) == 0;
  }
  ~ClosedFolder() {
    if (root_ && ::seteuid(0) != 0) std::abort();  // what follows needs its rights
    std::filesystem::permissions(closed_, std::filesystem::perms::owner_all);
  }
  ClosedFolder(const ClosedFolder&) = delete;
  ClosedFolder& operator=(const ClosedFolder&) = delete;
  [[nodiscard]] bool is_closed() const { return is_closed_; }

 private:
  std::filesystem::path closed_;
  bool root_ = ::geteuid() == 0, is_closed_ = true;
};

TEST_F(Catalogue, FoldersThatNobodyMayReadAreTold) {
  put("a.xml", esi_text({{1, 0x10, "A1"}}));
  put("closed/b.xml", esi_text({{2, 0x10, "B1"}}));
  std::optional<ClosedFolder> nobody(std::in_place, folder().parent_path(), folder() / "closed");
  ASSERT_TRUE(nobody->is_closed());
  EsiCatalogue catalogue;
  const auto report = catalogue.add_folder(folder().string());
  const auto closed = catalogue.add_folder(file("closed"));
  EsiCatalogue usual;
  const auto told = add_usual_sources(usual, {folder().string()});
  nobody.reset();
  ASSERT_TRUE(report);
  EXPECT_EQ(report->files, 1U);
  EXPECT_THAT(report->unreadable, ElementsAre(file("closed")));
  ASSERT_THAT(told, ElementsAre(Field(&Error::file, file("closed"))));
  EXPECT_EQ(told.front().code, ErrorCode::kFileNotReadable);
  EXPECT_EQ(usual.device_count(), 1U);
  ASSERT_FALSE(closed) << "an error, not a folder of 0 files";
  EXPECT_EQ(closed.error().code, ErrorCode::kFileNotReadable);
}

TEST_F(Catalogue, KeepsWhatItKnowsOfAFolderThatCannotBeReadNow) {
  put("a.xml", esi_text({{1, 0x10, "A1"}}));
  put("closed/b.xml", esi_text({{2, 0x10, "B1"}}));
  EsiCatalogue catalogue;
  ASSERT_TRUE(catalogue.add_folder(folder().string()));
  std::optional<ClosedFolder> nobody(std::in_place, folder().parent_path(), folder() / "closed");
  ASSERT_TRUE(nobody->is_closed());
  const auto again = catalogue.add_folder(folder().string());
  nobody.reset();
  ASSERT_TRUE(again);
  EXPECT_THAT(again->unreadable, ElementsAre(file("closed")));
  EXPECT_EQ(again->removed, 0U);
  EXPECT_THAT(types(catalogue, {}), ElementsAre("A1", "B1"));
  std::filesystem::remove_all(folder() / "closed");
  const auto last = catalogue.add_folder(folder().string());
  ASSERT_TRUE(last);
  EXPECT_EQ(last->removed, 1U);
}

/// Whatever is broken in it, `mend` leaves a database that has the devices.
TEST_F(Catalogue, MendsEveryKindOfDamage) {
  put("a.xml", esi_text({{1, 0x10, "A1"}, {2, 0x10, "B1", "Thing", "Digital", "<HideType ProductCode=\"1\"/>"}}));
  const auto all_there = [&](const std::string& what) {
    auto opening = EsiCatalogue::open(database());
    ASSERT_TRUE(opening) << what << ": " << describe(opening.error());
    EsiCatalogue catalogue = std::move(*opening);
    ASSERT_TRUE(catalogue.mend()) << what;
    ASSERT_TRUE(catalogue.add_folder(folder().string())) << what;
    EXPECT_EQ(catalogue.device_count(), 2U) << what;
    EXPECT_THAT(types(catalogue, {.words = "Thing", .with_hidden = true}), ElementsAre("A1", "B1")) << what;
  };
  all_there("new");
  for (const char* const sql :
       {"DROP TABLE devices", "DROP TABLE words", "DELETE FROM words_data", "DROP TABLE hides",
        "DROP INDEX devices_by_file", "PRAGMA user_version=0", "ALTER TABLE files RENAME path TO way",
        "PRAGMA writable_schema=ON; UPDATE sqlite_master SET rootpage=99 WHERE name='devices'"}) {
    ASSERT_TRUE(SqlDatabase::open(database())->execute(sql)) << sql;
    all_there(sql);
  }
  const auto size = std::filesystem::file_size(database());
  for (const auto part : {size - 1, size / 2, std::uintmax_t{4096}, std::uintmax_t{1000}, std::uintmax_t{100}}) {
    std::filesystem::resize_file(database(), part);
    all_there("cut to " + std::to_string(part));
  }
}

}  // namespace
}  // namespace syncline::eni
