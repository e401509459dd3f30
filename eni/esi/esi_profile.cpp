// SPDX-License-Identifier: Apache-2.0
#include "eni/esi/esi_device.h"
#include "eni/esi/esi_side_files.h"
#include "eni/xml/xml_text.h"
#include "findings/error_text.h"
#include "reasons/because.h"

namespace syncline::eni {
namespace {

/// ProfileNo and AddInfo stand in ChannelInfo, in older files directly in Profile.
void add_profile(const Node& node, std::vector<ChannelProfile>& profiles) {
  const Node number = node.child("ProfileNo");
  if (!number || (number.trimmed().empty() && node.reading().tolerant())) return;
  profiles.push_back({.profile_no = number.number<std::uint32_t>(),
                      .add_info = node.child_number<std::uint32_t>("AddInfo").value_or(0)});
}

void read_dictionary_file(const Node& reference, SideFiles* side_files, ReadProfiles& profiles) {
  const auto name = reference.trimmed();
  if (side_files == nullptr) {
    reference.warn(because("the dictionary \"{name}\" is in another file, which is not read here", name));
    return;
  }
  const auto file = side_files->open(name);
  if (!file) {
    reference.warn(because("the dictionary is left out: {error}", reason_of(file.error())));
    return;
  }
  const Node root = (*file)->root();
  if (root.name() != "EtherCATDict") {
    reference.warn(
        because("\"{name}\" is no dictionary file: its root is <{root}>, not <EtherCATDict>", name, root.name()));
    return;
  }
  read_dictionary(root.child("Dictionary"), profiles);
}

}  // namespace

ReadProfiles read_profiles(const Node& parent, SideFiles* side_files) {
  ReadProfiles read;
  for (const Node& profile : parent.children("Profile")) {
    for (const Node& channel : profile.children("ChannelInfo")) add_profile(channel, read.profiles);
    add_profile(profile, read.profiles);
    if (const Node dictionary = profile.child("Dictionary")) read_dictionary(dictionary, read);
    if (const Node reference = profile.child("DictionaryFile")) read_dictionary_file(reference, side_files, read);
  }
  return read;
}

}  // namespace syncline::eni
