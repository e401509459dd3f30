// SPDX-License-Identifier: Apache-2.0
#include "eni/check/check_bed.h"
#include "eni/check/rule_cases.h"

namespace syncline::test {
namespace {

std::function<std::string(std::string)> replace(const std::string& from, const std::string& to) {
  return [=](std::string text) { return replaced(std::move(text), from, to); };
}

}  // namespace

std::vector<TextCase> text_cases() {
  return {
      {"ENI-XML-01", replace("</EtherCATConfig>", "")},
      {"ENI-XML-02", replace("<VendorId>1516</VendorId>", "")},
      {"ENI-XML-03",
       [](std::string text) {
         return replaced(replaced(std::move(text), "<VendorId>1516</VendorId>", ""), "<SerialNo>0</SerialNo>",
                         "<SerialNo>0</SerialNo><VendorId>1516</VendorId>");
       }},
      {"ENI-XML-04", replace("<VendorId>1516</VendorId>", "<VendorId>1516</VendorId><Colour>red</Colour>")},
      {"ENI-XML-05", replace("<Retries>3</Retries>", "<Retries>three</Retries>")},
      {"ENI-XML-06", replace("<VendorId>1516</VendorId>", "<VendorId>#x5ec</VendorId>")},
      {"ENI-XML-07", replace("<SerialNo>0</SerialNo>", "<SerialNo>0</SerialNo><SerialNo>0</SerialNo>")},
      {"ENI-XML-08", replace("<Data>0000</Data>", "<Data>0000</Data><DataLength>2</DataLength>")},
      {"ENI-XML-09",
       [](std::string text) {
         return replaced(replaced(std::move(text), "<EtherCATConfig ", "<EncryptedEtherCATConfig "),
                         "</EtherCATConfig>", "</EncryptedEtherCATConfig>");
       }},
      {"ENI-XML-11", replace("<EtherCATConfig ", "<!-- \x8D -->\n<EtherCATConfig ")},
      {"ENI-REF-01",
       [](std::string text) {
         const auto port = text.rfind("<PreviousPort");
         const auto address = text.find("<PhysAddr>1004", port);
         return text.replace(address, 14, "<PhysAddr>1999");
       }},
  };
}

}  // namespace syncline::test
