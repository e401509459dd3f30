// SPDX-License-Identifier: Apache-2.0
#include "fuzz/catalogue_target.h"

#include <filesystem>
#include <fstream>

#include "eni/catalogue/esi_catalogue.h"
#include "eni/esi/esi_writer.h"
#include "fuzz/sandbox.h"
#include "tests/support/sample_devices.h"

namespace syncline::fuzz {
namespace {

constexpr Identity kServo{0x5EC, 0x402, 0x10002, 0};

void look_into(eni::EsiCatalogue& catalogue) {
  eni::CatalogueSearch search;
  (void)catalogue.search(search);
  search.words = "servo";
  (void)catalogue.search(search);
  (void)catalogue.duplicates();
  (void)catalogue.known_folders();
  (void)catalogue.device_count();
  (void)catalogue.warnings();
  (void)catalogue.device_for(kServo);
}

}  // namespace

void run_catalogue(std::span<const std::uint8_t> bytes) {
  static const Sandbox sandbox;
  const auto path = sandbox.file("catalogue.sqlite");
  sandbox.clear();
  sandbox.put("esi/servo.xml", eni::write_esi(sample::servo()));
  sandbox.put("catalogue.sqlite", text_of(bytes));
  auto catalogue = eni::EsiCatalogue::open(path);
  if (!catalogue) return;  // something else than a catalogue, and left alone
  look_into(*catalogue);
  (void)catalogue->add_folder(sandbox.file("esi"));
  look_into(*catalogue);
  promise(catalogue->mend().has_value());
  promise(catalogue->add_folder(sandbox.file("esi")).has_value());
  promise(catalogue->device_for(kServo).has_value());
}

std::vector<Bytes> catalogues() {
  const Sandbox sandbox;
  sandbox.put("esi/servo.xml", eni::write_esi(sample::servo()));
  sandbox.put("esi/broken.xml", "<EtherCATInfo><Vendor>");
  {
    auto catalogue = eni::EsiCatalogue::open(sandbox.file("catalogue.sqlite"));
    if (!catalogue) return {};
    (void)catalogue->add_folder(sandbox.file("esi"));
    (void)catalogue->remember_folder(sandbox.file("esi"));
  }
  return {bytes_of_text(sandbox.text("catalogue.sqlite"))};
}

}  // namespace syncline::fuzz
