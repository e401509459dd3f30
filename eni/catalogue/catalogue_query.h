// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <functional>
#include <string>
#include <vector>

#include "support/result.h"

/// Questions to the index; only chosen files answer.
namespace syncline::eni {

struct CatalogueEntry;
struct CatalogueSearch;
class CatalogueStore;
struct DuplicateDevice;

/// All revisions of a product, each in the order in which its files were chosen, compared where one occurs twice.
[[nodiscard]] Result<std::vector<CatalogueEntry>> entries_of(CatalogueStore& store, std::uint32_t vendor_id,
                                                             std::uint32_t product_code);
/// Fast enough for each key that a user presses. Types that begin with the words come first, then by type; newest
/// revision first.
[[nodiscard]] Result<std::vector<CatalogueEntry>> search(CatalogueStore& store, const CatalogueSearch& search);
/// `go_on` is asked between devices; with false from it the list is empty.
[[nodiscard]] Result<std::vector<DuplicateDevice>> duplicates(CatalogueStore& store,
                                                              const std::function<bool()>& go_on = {});

}  // namespace syncline::eni
