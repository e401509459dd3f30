// SPDX-License-Identifier: Apache-2.0
#pragma once

namespace syncline::eni {

/// How the same content is spelled: EC-Engineer's way, or that of TwinCAT 3.
struct EniStyle {
  bool words = false;  // booleans as true and false instead of 1 and 0
  bool tabs = false;
  bool declare_encoding = true;
  bool dc_element_always = true;  // slaves without DC have a DC element that says so
  bool operator==(const EniStyle&) const = default;
};

}  // namespace syncline::eni
