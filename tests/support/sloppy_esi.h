// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <utility>
#include <vector>

/// ESI files that are written otherwise than ETG.2000 says: together they have each kind of warning.
namespace syncline::sample {

struct NamedText {
  std::string name, text;
};

/// Latin-1 without saying so, and all that a device alone may have.
inline std::string sloppy_device() {
  return R"(<EtherCATInfo><Vendor><Id>2</Id><Name>M)"
         "\xFC"
         R"(ller</Name></Vendor>
<InfoReference>nowhere.xml</InfoReference>
<Descriptions><Groups/><Devices><Device>
<Type ProductCode="#x10" RevisionNo="1" CheckRevisionNo="XX" CheckProductCode="YY">ALPHA</Type><Name>ALPHA</Name>
<HideType ProductCode="#x1FFFFFFFF">BETA</HideType>
<Fmmu>ZZ1</Fmmu>
<Sm StartAddress="0x1000" ControlByte="#x24">ZZ2</Sm>
<RxPdo><Index>x1600</Index><Name>P1</Name><Exclude>#x1600</Exclude>
<Entry><Index>#x7000</Index><SubIndex>1</SubIndex><Name>E1</Name><DataType>UINT</DataType></Entry></RxPdo>
<Mailbox><CoE>
<InitCmd><Transition>ps</Transition><Index>#x8000</Index><Data>01</Data></InitCmd>
<InitCmd><Index>#x8001</Index><Data>1</Data></InitCmd></CoE></Mailbox>
<Dc><OpMode><Desc>DC1</Desc></OpMode></Dc>
<Slots><Slot><Name>S1</Name><ModuleIdent>#x55</ModuleIdent></Slot></Slots>
<ImageData16x14>QQ</ImageData16x14>
<Profile><DictionaryFile>absent.xml</DictionaryFile></Profile>
<Profile><DictionaryFile>modules.xml</DictionaryFile></Profile>
<Profile><Dictionary><DataTypes>
<DataType><Name>DT1</Name><EnumInfo><Text>T</Text></EnumInfo></DataType>
<DataType><Name>DT2</Name><BitSize>9b</BitSize></DataType></DataTypes>
<Objects><Object><Index>9z</Index></Object><Object><Index>#x2000</Index><Type>DT2</Type></Object></Objects>
</Dictionary></Profile>
</Device></Devices></Descriptions></EtherCATInfo>
)";
}

/// What takes a device or a module with it.
inline std::string broken_devices() {
  return R"(<EtherCATInfo><Vendor><Id>2</Id><Name>MAKER</Name></Vendor>
<Descriptions><Groups/><Devices>
<Device><Type ProductCode="1k">GAMMA</Type></Device>
<Device><Fmmu>Outputs</Fmmu></Device>
<Device><Type ProductCode="#x11">DELTA</Type><Sm DefaultSize="-1">Inputs</Sm></Device>
</Devices><Modules><Module><Type>MOD1</Type></Module></Modules></Descriptions></EtherCATInfo>
)";
}

/// Half a million entries by few lines.
inline std::string endless_dictionary() {
  std::string items, objects;
  for (int i = 0; i < 4; ++i) items += "<SubItem><Name>x</Name><Type>ARR</Type></SubItem>";
  for (int i = 0; i < 500; ++i) objects += "<Object><Index>#x2000</Index><Type>BIG</Type></Object>";
  return R"(<EtherCATInfo><Vendor><Id>2</Id><Name>MAKER</Name></Vendor><Descriptions><Groups/><Devices><Device>
<Type ProductCode="#x12">EPSILON</Type><Profile><Dictionary><DataTypes><DataType><Name>ARR</Name><BaseType>BYTE</BaseType>
<BitSize>2040</BitSize><ArrayInfo><LBound>1</LBound><Elements>255</Elements></ArrayInfo></DataType>
<DataType><Name>BIG</Name>)" +
         items + "</DataType></DataTypes>\n<Objects>" + objects +
         "</Objects></Dictionary></Profile></Device></Devices></Descriptions></EtherCATInfo>\n";
}

inline std::vector<NamedText> sloppy_esi_files() {
  return {{"sloppy.xml", sloppy_device()},         {"broken.xml", broken_devices()},
          {"cut.xml", "<EtherCATInfo>\n<Vendor>"}, {"other.xml", "<EtherCATConfig/>"},
          {"endless.xml", endless_dictionary()},   {"modules.xml", "<EtherCATModule/>"}};
}

}  // namespace syncline::sample
