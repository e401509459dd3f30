<?xml version="1.0" encoding="utf-8"?>
<!-- SPDX-License-Identifier: Apache-2.0 -->
<!DOCTYPE TS>
<TS version="2.1" language="zh_CN" sourcelanguage="en">
    <context>
        <name>AboutDialog</name>
        <message>
            <source>About Syncline</source>
            <translation>关于 Syncline</translation>
        </message>
        <message>
            <source>&lt;h3&gt;Syncline %1&lt;/h3&gt;&lt;p&gt;EtherCAT configurator and live synchronisation monitor.&lt;/p&gt;&lt;p&gt;Apache License 2.0. Built with Qt %2 (LGPL) and Qwt %3 (Qwt License).&lt;/p&gt;</source>
            <translation>&lt;h3&gt;Syncline %1&lt;/h3&gt;&lt;p&gt;EtherCAT 配置工具与实时同步监视器。&lt;/p&gt;&lt;p&gt;Apache License 2.0。使用 Qt %2 (LGPL) 和 Qwt %3 (Qwt License) 构建。&lt;/p&gt;</translation>
        </message>
        <message>
            <source>EtherCAT is a registered trademark and patented technology, licensed by Beckhoff Automation GmbH, Germany.</source>
            <translation>EtherCAT 是注册商标和专利技术，由德国 Beckhoff Automation GmbH 授权。</translation>
        </message>
    </context>
    <context>
        <name>Actions</name>
        <message>
            <source>Take the last edit back</source>
            <translation>撤销上一次编辑</translation>
        </message>
        <message>
            <source>Do again what was taken back</source>
            <translation>恢复刚才撤销的编辑</translation>
        </message>
        <message>
            <source>&amp;New</source>
            <translation>新建(&amp;N)</translation>
        </message>
        <message>
            <source>New project</source>
            <translation>新建项目</translation>
        </message>
        <message>
            <source>&amp;Open…</source>
            <translation>打开(&amp;O)…</translation>
        </message>
        <message>
            <source>&amp;Save</source>
            <translation>保存(&amp;S)</translation>
        </message>
        <message>
            <source>Save the project</source>
            <translation>保存项目</translation>
        </message>
        <message>
            <source>Save &amp;As…</source>
            <translation>另存为(&amp;A)…</translation>
        </message>
        <message>
            <source>Save the project under another name</source>
            <translation>以其他名称保存项目</translation>
        </message>
        <message>
            <source>&amp;Export ENI…</source>
            <translation>导出 ENI(&amp;E)…</translation>
        </message>
        <message>
            <source>Write the network information file (ETG.2100)</source>
            <translation>写出网络信息文件 (ETG.2100)</translation>
        </message>
        <message>
            <source>&amp;Quit</source>
            <translation>退出(&amp;Q)</translation>
        </message>
        <message>
            <source>Quit</source>
            <translation>退出</translation>
        </message>
        <message>
            <source>&amp;Undo</source>
            <translation>撤销(&amp;U)</translation>
        </message>
        <message>
            <source>&amp;Redo</source>
            <translation>重做(&amp;R)</translation>
        </message>
        <message>
            <source>&amp;Demonstration Machine</source>
            <translation>演示机器(&amp;D)</translation>
        </message>
        <message>
            <source>Scan the simulated demonstration machine and go online</source>
            <translation>扫描仿真的演示机器并上线</translation>
        </message>
        <message>
            <source>&amp;Scan…</source>
            <translation>扫描(&amp;S)…</translation>
        </message>
        <message>
            <source>Scan a bus and make a project of it</source>
            <translation>扫描总线并据此建立项目</translation>
        </message>
        <message>
            <source>Go &amp;Online</source>
            <translation>上线(&amp;O)</translation>
        </message>
        <message>
            <source>Run the configuration on the bus</source>
            <translation>在总线上运行此配置</translation>
        </message>
        <message>
            <source>Go O&amp;ffline</source>
            <translation>下线(&amp;F)</translation>
        </message>
        <message>
            <source>Bring the bus to INIT and stop</source>
            <translation>将总线切换到 INIT 并停止</translation>
        </message>
        <message>
            <source>&amp;Clear Statistics</source>
            <translation>清除统计(&amp;C)</translation>
        </message>
        <message>
            <source>Start counting anew</source>
            <translation>重新开始计数</translation>
        </message>
        <message>
            <source>Request %1 for all slaves (register 0x0120)</source>
            <translation>为所有从站请求 %1（寄存器 0x0120）</translation>
        </message>
        <message>
            <source>&amp;System Colours</source>
            <translation>系统颜色(&amp;S)</translation>
        </message>
        <message>
            <source>&amp;Light</source>
            <translation>浅色(&amp;L)</translation>
        </message>
        <message>
            <source>&amp;Dark</source>
            <translation>深色(&amp;D)</translation>
        </message>
        <message>
            <source>Light/Dark</source>
            <translation>浅色/深色</translation>
        </message>
        <message>
            <source>Switch between light and dark</source>
            <translation>在浅色与深色之间切换</translation>
        </message>
        <message>
            <source>&amp;Reset Layout</source>
            <translation>复位布局(&amp;R)</translation>
        </message>
        <message>
            <source>Put all panels back in their places</source>
            <translation>将所有面板放回原位</translation>
        </message>
        <message>
            <source>&amp;About Syncline</source>
            <translation>关于 Syncline(&amp;A)</translation>
        </message>
        <message>
            <source>Version, licence and trademarks</source>
            <translation>版本、许可证和商标</translation>
        </message>
        <message>
            <source>&amp;Expert Settings</source>
            <translation>专家设置(&amp;E)</translation>
        </message>
        <message>
            <source>Show the settings that few machines need</source>
            <translation>显示少数机器才需要的设置</translation>
        </message>
        <message>
            <source>Open a project, an ENI, an ESI file, a capture or a scenario</source>
            <translation>打开项目、ENI、ESI 文件、抓包文件或场景</translation>
        </message>
    </context>
    <context>
        <name>BusCommands</name>
        <message>
            <source>EEPROM</source>
            <translation>EEPROM</translation>
        </message>
        <message>
            <source>The bus could not be scanned.</source>
            <translation>无法扫描总线。</translation>
        </message>
        <message>
            <source>Scan</source>
            <translation>扫描</translation>
        </message>
        <message>
            <source>Go Online</source>
            <translation>上线</translation>
        </message>
        <message>
            <source>Master</source>
            <translation>主站</translation>
        </message>
        <message>
            <source>The master could not go online.</source>
            <translation>主站无法上线。</translation>
        </message>
        <message>
            <source>Monitor the sync window</source>
            <translation>监视同步窗口</translation>
        </message>
        <message>
            <source>A scan needs the bus for itself.</source>
            <translation>扫描需要独占总线。</translation>
        </message>
        <message>
            <source>Restart the machine with the project as it is now?</source>
            <translation>用当前的项目重新启动机器？</translation>
        </message>
        <message>
            <source>All slaves go to INIT and come up again.</source>
            <translation>所有从站切换到 INIT，然后重新启动。</translation>
        </message>
        <message>
            <source>Restart</source>
            <translation>重新启动</translation>
        </message>
    </context>
    <context>
        <name>CutShortDialog</name>
        <message>
            <source>EEPROM write was cut short</source>
            <translation>EEPROM 写入中断</translation>
        </message>
        <message>
            <source>What was cut short</source>
            <translation>中断的内容</translation>
        </message>
        <message>
            <source>Why it could not be ended</source>
            <translation>未能完成的原因</translation>
        </message>
        <message>
            <source>Writing the EEPROM</source>
            <translation>写入 EEPROM</translation>
        </message>
        <message>
            <source>&amp;Finish Writing</source>
            <translation>完成写入(&amp;F)</translation>
        </message>
        <message>
            <source>&amp;Put Back Old Contents</source>
            <translation>恢复旧内容(&amp;P)</translation>
        </message>
        <message>
            <source>&amp;Later</source>
            <translation>稍后(&amp;L)</translation>
        </message>
        <message>
            <source>Finish writing</source>
            <translation>完成写入</translation>
        </message>
        <message>
            <source>Put back old contents</source>
            <translation>恢复旧内容</translation>
        </message>
        <message>
            <source>Later</source>
            <translation>稍后</translation>
        </message>
        <message>
            <source>Writing the EEPROM of slave %1 on %2 was cut short (begun %3 UTC). What it holds now is half old and half new: the slave may not start after its next power-on. Connect it and end the write.</source>
            <translation>%2 上从站 %1 的 EEPROM 写入被中断（开始于 UTC %3）。现在其内容新旧各半：下次上电后该从站可能无法启动。请连接该从站并完成写入。</translation>
        </message>
        <message>
            <source>&amp;Cancel</source>
            <translation>取消(&amp;C)</translation>
        </message>
        <message>
            <source>The EEPROM of slave %1 on %2 holds its old contents again.</source>
            <translation>%2 上从站 %1 的 EEPROM 已恢复旧内容。</translation>
        </message>
        <message>
            <source>The EEPROM of slave %1 on %2 is written and verified.</source>
            <translation>%2 上从站 %1 的 EEPROM 已写入并校验。</translation>
        </message>
        <message>
            <source>The EEPROM of slave %1 on %2 is still half written; the next start offers to end it.</source>
            <translation>%2 上从站 %1 的 EEPROM 仍只写了一半；下次启动时会再次提示完成写入。</translation>
        </message>
        <message numerus="yes">
            <source>%n more write(s) follow.</source>
            <translation>
                <numerusform>之后还有 %n 次写入。</numerusform>
            </translation>
        </message>
    </context>
    <context>
        <name>DcmPanel</name>
        <message>
            <source>DCM error</source>
            <translation>DCM 误差</translation>
        </message>
        <message>
            <source>Error</source>
            <translation>误差</translation>
        </message>
        <message>
            <source>raw</source>
            <translation>原始</translation>
        </message>
        <message>
            <source>filtered</source>
            <translation>滤波后</translation>
        </message>
        <message>
            <source>Time of the frame at the reference clock minus its wanted time in the cycle.</source>
            <translation>按参考时钟计的帧时刻减去其在周期中的设定时刻。</translation>
        </message>
        <message>
            <source>drift %1</source>
            <translation>漂移 %1</translation>
        </message>
        <message>
            <source>DCM is off</source>
            <translation>DCM 已关闭</translation>
        </message>
    </context>
    <context>
        <name>DeviationPanel</name>
        <message>
            <source>DC deviation</source>
            <translation>DC 偏差</translation>
        </message>
        <message>
            <source>Deviation</source>
            <translation>偏差</translation>
        </message>
        <message>
            <source>largest</source>
            <translation>最大</translation>
        </message>
        <message>
            <source>Register 0x092C (System Time Difference) of the slaves that follow the reference clock. Largest: the wire-or of all of them read by BRD where nothing else is in it, else the largest of their latest readings. Lines: signed values of single slaves.</source>
            <translation>跟随参考时钟的从站的寄存器 0x092C（系统时间差）。最大：只有这些从站参与时为 BRD 读取的全部值的线或，否则为其最新读数中的最大值。曲线：各从站的带符号值。</translation>
        </message>
        <message>
            <source>limit ±%1</source>
            <translation>限值 ±%1</translation>
        </message>
        <message>
            <source>peak %1</source>
            <translation>峰值 %1</translation>
        </message>
    </context>
    <context>
        <name>DeviceEditor</name>
        <message>
            <source>Device editor</source>
            <translation>设备编辑器</translation>
        </message>
        <message>
            <source>State of the selected node</source>
            <translation>所选节点的状态</translation>
        </message>
        <message>
            <source>Pages of the selected node</source>
            <translation>所选节点的页面</translation>
        </message>
        <message numerus="yes">
            <source>%n slave(s), cycle %1</source>
            <translation>
                <numerusform>%n 个从站，周期 %1</numerusform>
            </translation>
        </message>
        <message>
            <source>%1, position %2, address %3</source>
            <translation>%1，位置 %2，地址 %3</translation>
        </message>
        <message>
            <source>Offline</source>
            <translation>离线</translation>
        </message>
    </context>
    <context>
        <name>Error</name>
        <message>
            <source>The file {file} does not exist; check its name and folder.</source>
            <translation>文件 {file} 不存在；请检查文件名和文件夹。</translation>
        </message>
        <message>
            <source>The file {file} cannot be read{because}.</source>
            <translation>无法读取文件 {file}{because}。</translation>
        </message>
        <message>
            <source>The file {file} cannot be written{because}; check the folder&apos;s permissions and free space.</source>
            <translation>无法写入文件 {file}{because}；请检查文件夹的权限和剩余空间。</translation>
        </message>
        <message>
            <source>{where}: this is not well-formed XML{because}.</source>
            <translation>{where}：不是格式正确的 XML{because}。</translation>
        </message>
        <message>
            <source>{where}: the element &lt;{subject}&gt; is missing{because}.</source>
            <translation>{where}：缺少元素 &lt;{subject}&gt;{because}。</translation>
        </message>
        <message>
            <source>{where}: the value of &lt;{subject}&gt; cannot be used{because}.</source>
            <translation>{where}：&lt;{subject}&gt; 的值无法使用{because}。</translation>
        </message>
        <message>
            <source>{where}: this is another kind of file; expected{because}.</source>
            <translation>{where}：这是另一种文件；期望{because}。</translation>
        </message>
        <message>
            <source>{where}: this is not well-formed TOML{because}.</source>
            <translation>{where}：不是格式正确的 TOML{because}。</translation>
        </message>
        <message>
            <source>{where}: the key &quot;{subject}&quot; cannot be used{because}.</source>
            <translation>{where}：键“{subject}”无法使用{because}。</translation>
        </message>
        <message>
            <source>The device {subject} is not known{because}; load its ESI file.</source>
            <translation>未知设备 {subject}{because}；请加载其 ESI 文件。</translation>
        </message>
        <message>
            <source>No ESI file describes {subject}; put the vendor&apos;s ESI file into the ESI folder {detail} and scan again.</source>
            <translation>没有描述 {subject} 的 ESI 文件；请将供应商的 ESI 文件放入 ESI 文件夹 {detail} 后重新扫描。</translation>
        </message>
        <message>
            <source>There is no setting &quot;{subject}&quot;{because}.</source>
            <translation>没有设置“{subject}”{because}。</translation>
        </message>
        <message>
            <source>The value of {subject} cannot be used{because}.</source>
            <translation>{subject} 的值无法使用{because}。</translation>
        </message>
        <message>
            <source>The configuration of {subject} does not work out{because}.</source>
            <translation>{subject} 的配置不成立{because}。</translation>
        </message>
        <message>
            <source>There is no network adapter or link &quot;{subject}&quot;{because}; list them with &quot;synclinectl adapters&quot;.</source>
            <translation>没有网卡或链路“{subject}”{because}；可用“synclinectl adapters”列出。</translation>
        </message>
        <message>
            <source>The link {subject} is down{because}; check the cable and that the interface is up.</source>
            <translation>链路 {subject} 未连通{because}；请检查电缆以及接口是否已启用。</translation>
        </message>
        <message>
            <source>No permission to send raw frames on {subject}; grant it once with: {detail}</source>
            <translation>没有在 {subject} 上发送原始帧的权限；请用以下命令授权一次：{detail}</translation>
        </message>
        <message>
            <source>Sending or receiving on {subject} failed{because}.</source>
            <translation>在 {subject} 上发送或接收失败{because}。</translation>
        </message>
        <message>
            <source>{subject} is not supported{because}.</source>
            <translation>不支持 {subject}{because}。</translation>
        </message>
        <message>
            <source>No answer from {subject}; check power, cabling and the working counter of the slaves before it.</source>
            <translation>{subject} 没有应答；请检查电源、接线以及其前面各从站的工作计数器。</translation>
        </message>
        <message>
            <source>{subject}: working counter {received} where {expected} was expected; a slave did not process the datagram.</source>
            <translation>{subject}：工作计数器为 {received}，期望为 {expected}；有从站未处理该数据报。</translation>
        </message>
        <message>
            <source>The bus has {received} slaves where {expected} were expected; compare the wiring with the configuration.</source>
            <translation>总线上有 {received} 个从站，期望为 {expected} 个；请将接线与配置进行比较。</translation>
        </message>
        <message>
            <source>{subject} is another device than configured{because}; scan again or exchange the device.</source>
            <translation>{subject} 与所配置的设备不同{because}；请重新扫描或更换设备。</translation>
        </message>
        <message>
            <source>{subject} refused {state} and stays in {actual}: AL status code {alcode}.</source>
            <translation>{subject} 拒绝 {state}，停留在 {actual}：AL 状态码 {alcode}。</translation>
        </message>
        <message>
            <source>{subject} did not reach {state} in time and is in {actual}; raise the timeout or check what the slave waits for.</source>
            <translation>{subject} 未能及时到达 {state}，现为 {actual}；请增大超时时间，或检查该从站在等待什么。</translation>
        </message>
        <message>
            <source>{subject} did not answer in its mailbox in time; the slave may be busy or its mailbox is set up wrongly.</source>
            <translation>{subject} 的邮箱未及时应答；从站可能繁忙，或其邮箱设置有误。</translation>
        </message>
        <message>
            <source>{subject} answered in its mailbox with something else than was asked{because}.</source>
            <translation>{subject} 的邮箱应答与请求不符{because}。</translation>
        </message>
        <message>
            <source>{subject}: the slave aborted the SDO transfer with {abort}.</source>
            <translation>{subject}：从站以 {abort} 中止了 SDO 传输。</translation>
        </message>
        <message>
            <source>The SII (EEPROM) of {subject} cannot be used{because}.</source>
            <translation>{subject} 的 SII (EEPROM) 无法使用{because}。</translation>
        </message>
        <message>
            <source>{subject}: the slave&apos;s answer differs from what the init command demands{because}.</source>
            <translation>{subject}：从站的应答与启动命令的要求不符{because}。</translation>
        </message>
        <message>
            <source>{subject} is malformed{because}.</source>
            <translation>{subject} 格式错误{because}。</translation>
        </message>
        <message>
            <source>Distributed clocks of {subject} could not be set up{because}.</source>
            <translation>无法设置 {subject} 的分布时钟{because}。</translation>
        </message>
        <message>
            <source>{subject}: the DCM error of {received} ns is beyond the limit of {expected} ns; check the host&apos;s jitter and the clock&apos;s drift.</source>
            <translation>{subject}：{received} ns 的 DCM 误差超出 {expected} ns 的限值；请检查主机的抖动和时钟的漂移。</translation>
        </message>
        <message>
            <source>{subject} is missing{because}; check its power and the cable to it, or take it out of the configuration.</source>
            <translation>缺少 {subject}{because}；请检查其电源和通往它的电缆，或将其从配置中移除。</translation>
        </message>
        <message>
            <source>There is a device that is not in the configuration: {subject}{because}; scan again or take it off the bus.</source>
            <translation>有一个设备不在配置中：{subject}{because}；请重新扫描或将其从总线上取下。</translation>
        </message>
        <message>
            <source>{subject} and {detail} have changed places; swap their cables, or their positions in the configuration.</source>
            <translation>{subject} 与 {detail} 互换了位置；请对调两者的电缆，或对调它们在配置中的位置。</translation>
        </message>
        <message>
            <source>{subject} took too long{because}.</source>
            <translation>{subject} 耗时过长{because}。</translation>
        </message>
        <message>
            <source>Wiring of {subject}: {detail}.</source>
            <translation>{subject} 的接线：{detail}。</translation>
        </message>
        <message>
            <source>Identification of {subject}: {detail}.</source>
            <translation>{subject} 的识别：{detail}。</translation>
        </message>
        <message>
            <source>{subject}: the slave ended the file transfer with {foe}{because}.</source>
            <translation>{subject}：从站以 {foe} 结束了文件传输{because}。</translation>
        </message>
        <message>
            <source>{where}: the file is beyond what is read{because}.</source>
            <translation>{where}：文件超出可读取的范围{because}。</translation>
        </message>
        <message>
            <source>The device catalogue {file} cannot be used{because}; delete it or choose another one.</source>
            <translation>设备目录 {file} 无法使用{because}；请将其删除或选择其他目录。</translation>
        </message>
        <message>
            <source>Not read from {subject}: {detail}.</source>
            <translation>未从 {subject} 读取：{detail}。</translation>
        </message>
        <message>
            <source>Cancelled.</source>
            <translation>已取消。</translation>
        </message>
        <message>
            <source>{subject}{because}.</source>
            <translation>{subject}{because}。</translation>
        </message>
    </context>
    <context>
        <name>Events</name>
        <message>
            <source>Not known whether the slaves are in sync: nobody leads them</source>
            <translation>不知道从站是否同步：没有参考时钟引领</translation>
        </message>
        <message>
            <source>In sync again, deviation %1</source>
            <translation>重新同步，偏差 %1</translation>
        </message>
        <message>
            <source>Port %1: link lost %2 times, %3 damaged frames</source>
            <translation>端口 %1：链路丢失 %2 次，损坏帧 %3 个</translation>
        </message>
        <message>
            <source>The bring-up begins again from INIT: the network adapter was away in the middle of it</source>
            <translation>从 INIT 重新开始启动：启动过程中网卡曾断开</translation>
        </message>
        <message>
            <source>The firmware is fast enough again</source>
            <translation>固件速度恢复正常</translation>
        </message>
        <message>
            <source>The firmware is slow: %1 cycles took longer than the cycle time</source>
            <translation>固件过慢：%1 个周期的耗时超过周期时间</translation>
        </message>
        <message>
            <source>The firmware is slow: no new inputs in %1 of %2 cycles</source>
            <translation>固件过慢：%2 个周期中有 %1 个没有新的输入</translation>
        </message>
        <message>
            <source>Network adapter %1 is up again after %2</source>
            <translation>网卡 %1 在 %2 后恢复</translation>
        </message>
        <message>
            <source>Network adapter %1 is down, gone or without carrier; waiting for it</source>
            <translation>网卡 %1 未连通、已移除或无载波；正在等待</translation>
        </message>
        <message>
            <source>Port %1: %2 damaged frames</source>
            <translation>端口 %1：损坏帧 %2 个</translation>
        </message>
        <message numerus="yes">
            <source>Process data watchdog expired (%n time(s))</source>
            <translation>
                <numerusform>过程数据看门狗超时（%n 次）</numerusform>
            </translation>
        </message>
        <message numerus="yes">
            <source>PDI watchdog expired (%n time(s)): the firmware is silent</source>
            <translation>
                <numerusform>PDI 看门狗超时（%n 次）：固件无响应</numerusform>
            </translation>
        </message>
        <message>
            <source>Connected by port %1 instead of A: swap its cables IN and OUT. Its delay is right here, but other masters take it wrong without a word</source>
            <translation>经端口 %1 而不是 A 连接：请对调其 IN 和 OUT 电缆。其延迟在此处正确，但其他主站会在毫无提示的情况下算错</translation>
        </message>
        <message>
            <source>Port %1 has a link and no slave behind it: a closed ring or another master</source>
            <translation>端口 %1 有链路但其后没有从站：闭合的环或另一个主站</translation>
        </message>
        <message>
            <source>Implausible propagation delay: %1</source>
            <translation>传输延迟不合理：%1</translation>
        </message>
        <message>
            <source>Propagation delays measured again: nothing to correct</source>
            <translation>已重新测量传输延迟：无需修正</translation>
        </message>
        <message numerus="yes">
            <source>Propagation delays measured again: %n slave(s) to correct, by %1 at most</source>
            <translation>
                <numerusform>已重新测量传输延迟：需修正 %n 个从站，最多 %1</numerusform>
            </translation>
        </message>
        <message>
            <source>State %1 → %2</source>
            <translation>状态 %1 → %2</translation>
        </message>
        <message>
            <source>AL status %1, code %2: %3. Check: %4</source>
            <translation>AL 状态 %1，代码 %2：%3。请检查：%4</translation>
        </message>
        <message>
            <source>Master synchronisation stopped with code %1 (drift %2). Measure the host&apos;s jitter, or try master shift.</source>
            <translation>主站同步以代码 %1 停止（漂移 %2）。请测量主机的抖动，或尝试主站移位。</translation>
        </message>
        <message>
            <source>Emergency %1, error register %2, data %3</source>
            <translation>紧急报文 %1，错误寄存器 %2，数据 %3</translation>
        </message>
        <message>
            <source>Diagnosis message %1, text %2, time stamp %3 ns</source>
            <translation>诊断消息 %1，文本 %2，时间戳 %3 ns</translation>
        </message>
        <message>
            <source>Connected (hot-connect group %1)</source>
            <translation>已连接（热连接组 %1）</translation>
        </message>
        <message>
            <source>Disconnected (hot-connect group %1)</source>
            <translation>已断开（热连接组 %1）</translation>
        </message>
        <message>
            <source>Not there yet (hot-connect group %1)</source>
            <translation>尚未出现（热连接组 %1）</translation>
        </message>
        <message>
            <source>The scan touches a running machine: %1 slaves are beyond INIT. States and station addresses stay; %2 EEPROMs are taken from their PDIs while they are read, and the DC receive times are latched</source>
            <translation>扫描会影响运行中的机器：%1 个从站高于 INIT。状态和站地址不变；读取期间将从其 PDI 收回 %2 个 EEPROM，并锁存 DC 接收时间</translation>
        </message>
        <message>
            <source>Online: the master runs the configuration</source>
            <translation>在线：主站正在运行配置</translation>
        </message>
        <message>
            <source>Offline</source>
            <translation>离线</translation>
        </message>
        <message numerus="yes">
            <source>Distributed clocks initialised: %n slave(s), reference clock at position %1</source>
            <translation>
                <numerusform>分布时钟已初始化：%n 个从站，参考时钟位于位置 %1</numerusform>
            </translation>
        </message>
        <message>
            <source>Reference clock present</source>
            <translation>参考时钟已就绪</translation>
        </message>
        <message>
            <source>Configured as reference clock, but its system time (0x0910) does not answer: the next clock leads in its place</source>
            <translation>已配置为参考时钟，但其系统时间 (0x0910) 无应答：由下一个时钟代替</translation>
        </message>
        <message>
            <source>This clock took over as reference clock</source>
            <translation>此时钟已接任参考时钟</translation>
        </message>
        <message>
            <source>Working counter expected now %1 (all slaves: %2)</source>
            <translation>工作计数器现期望为 %1（全部从站：%2）</translation>
        </message>
        <message>
            <source>Device that is not in the configuration, at position %1: %2</source>
            <translation>位置 %1 处有不在配置中的设备：%2</translation>
        </message>
        <message>
            <source>The cable from port %1 to position %2 is healed</source>
            <translation>从端口 %1 到位置 %2 的电缆已恢复</translation>
        </message>
        <message>
            <source>Nothing comes back over the cable from port %1 to position %2: pulled, broken, or no power behind it</source>
            <translation>从端口 %1 到位置 %2 的电缆没有返回：已拔出、断线或其后无电源</translation>
        </message>
        <message>
            <source>Recovery begins (try %1)</source>
            <translation>开始恢复（第 %1 次）</translation>
        </message>
        <message>
            <source>Recovered (try %1)</source>
            <translation>已恢复（第 %1 次）</translation>
        </message>
        <message>
            <source>Recovery failed (try %1)</source>
            <translation>恢复失败（第 %1 次）</translation>
        </message>
        <message>
            <source>Recovery given up after try %1; request the state again when the cause is removed</source>
            <translation>第 %1 次后放弃恢复；请在排除原因后重新请求状态</translation>
        </message>
        <message>
            <source>Reference clock lost</source>
            <translation>参考时钟丢失</translation>
        </message>
        <message>
            <source>All slaves in sync, deviation at most %1</source>
            <translation>所有从站已同步，偏差不超过 %1</translation>
        </message>
        <message>
            <source>The slaves&apos; deviation is not monitored</source>
            <translation>未监视从站的偏差</translation>
        </message>
        <message>
            <source>Slaves out of sync, deviation %1</source>
            <translation>从站失步，偏差 %1</translation>
        </message>
        <message>
            <source>Master synchronisation in sync, error %1</source>
            <translation>主站已同步，误差 %1</translation>
        </message>
        <message>
            <source>Master synchronisation out of sync, error %1: %2</source>
            <translation>主站失步，误差 %1：%2</translation>
        </message>
        <message>
            <source>Working counter %1 instead of %2 (%3 times)</source>
            <translation>工作计数器为 %1 而不是 %2（%3 次）</translation>
        </message>
        <message>
            <source>Working counter %1 instead of %2</source>
            <translation>工作计数器为 %1 而不是 %2</translation>
        </message>
        <message numerus="yes">
            <source>%n frame(s) lost</source>
            <translation>
                <numerusform>丢失 %n 帧</numerusform>
            </translation>
        </message>
        <message>
            <source>Slave does not answer any more</source>
            <translation>从站不再应答</translation>
        </message>
        <message>
            <source>Slave answers again</source>
            <translation>从站重新应答</translation>
        </message>
        <message>
            <source>Best effort instead of real time: %1</source>
            <translation>尽力而为，非实时：%1</translation>
        </message>
        <message numerus="yes">
            <source>%n event(s) were lost: the queue was full</source>
            <translation>
                <numerusform>丢失 %n 个事件：队列已满</numerusform>
            </translation>
        </message>
        <message numerus="yes">
            <source>%n frame(s) back late, up to %1 after the deadline (%2 of them told as lost before)</source>
            <translation>
                <numerusform>%n 帧返回过迟，最多超出截止时间 %1（其中 %2 帧先前报为丢失）</numerusform>
            </translation>
        </message>
        <message numerus="yes">
            <source>%n frame(s) back late, up to %1 after the deadline</source>
            <translation>
                <numerusform>%n 帧返回过迟，最多超出截止时间 %1</numerusform>
            </translation>
        </message>
        <message numerus="yes">
            <source>%n cycle(s) left out, the host sent nothing for up to %1</source>
            <translation>
                <numerusform>漏发 %n 个周期，主机最长 %1 未发送任何帧</numerusform>
            </translation>
        </message>
        <message numerus="yes">
            <source>Slaves out of sync, deviation %1; %n slave(s) over the limit</source>
            <translation>
                <numerusform>从站失步，偏差 %1；%n 个从站超出限值</numerusform>
            </translation>
        </message>
        <message>
            <source>All slaves out of sync at once and to the same side, deviation %1: the reference clock has stepped</source>
            <translation>所有从站同时向同一侧失步，偏差 %1：参考时钟发生跳变</translation>
        </message>
        <message>
            <source>Not known whether the slaves are in sync: nothing was read for %1</source>
            <translation>不知道从站是否同步：已有 %1 未读到任何值</translation>
        </message>
    </context>
    <context>
        <name>ExplorerPanel</name>
        <message>
            <source>Project explorer</source>
            <translation>项目浏览器</translation>
        </message>
    </context>
    <context>
        <name>FileCommands</name>
        <message>
            <source>Open</source>
            <translation>打开</translation>
        </message>
        <message>
            <source>The project could not be opened.</source>
            <translation>无法打开项目。</translation>
        </message>
        <message>
            <source>Project</source>
            <translation>项目</translation>
        </message>
        <message>
            <source>Opened %1</source>
            <translation>已打开 %1</translation>
        </message>
        <message>
            <source>Save Project</source>
            <translation>保存项目</translation>
        </message>
        <message>
            <source>Syncline projects (*.syncline)</source>
            <translation>Syncline 项目 (*.syncline)</translation>
        </message>
        <message>
            <source>Save</source>
            <translation>保存</translation>
        </message>
        <message>
            <source>The project could not be saved.</source>
            <translation>无法保存项目。</translation>
        </message>
        <message>
            <source>Saved %1</source>
            <translation>已保存 %1</translation>
        </message>
        <message>
            <source>Export ENI</source>
            <translation>导出 ENI</translation>
        </message>
        <message>
            <source>EtherCAT network information (*.xml)</source>
            <translation>EtherCAT 网络信息 (*.xml)</translation>
        </message>
        <message>
            <source>Export</source>
            <translation>导出</translation>
        </message>
        <message>
            <source>The ENI could not be written.</source>
            <translation>无法写入 ENI。</translation>
        </message>
        <message>
            <source>ENI written to %1</source>
            <translation>ENI 已写入 %1</translation>
        </message>
        <message>
            <source>Syncline</source>
            <translation>Syncline</translation>
        </message>
        <message>
            <source>Save the changes to %1?</source>
            <translation>保存对 %1 的更改？</translation>
        </message>
        <message>
            <source>A new project begins without a machine.</source>
            <translation>新项目开始时没有机器。</translation>
        </message>
        <message>
            <source>All that can be opened (*.syncline *.xml *.esi *.eni *.pcap *.pcapng *.toml);;Syncline projects (*.syncline);;All files (*)</source>
            <translation>所有可打开的文件 (*.syncline *.xml *.esi *.eni *.pcap *.pcapng *.toml);;Syncline 项目 (*.syncline);;所有文件 (*)</translation>
        </message>
        <message>
            <source>%1 cannot be opened here.</source>
            <translation>%1 无法在此打开。</translation>
        </message>
        <message>
            <source>Another project is opened.</source>
            <translation>将打开另一个项目。</translation>
        </message>
        <message>
            <source>It is a log of the master synchronisation: a spreadsheet shows it.</source>
            <translation>这是主站同步的日志：可用电子表格查看。</translation>
        </message>
        <message>
            <source>It is neither a project, an ENI, an ESI, a capture nor a scenario.</source>
            <translation>它既不是项目、ENI、ESI、抓包文件，也不是场景。</translation>
        </message>
        <message>
            <source>Another window has %1 open.</source>
            <translation>另一个窗口已打开 %1。</translation>
        </message>
        <message>
            <source>It is %1. Here it can be looked at and changed, and be saved under another name. If that window is gone, delete %2.</source>
            <translation>占用者为 %1。在这里可以查看和更改，并以其他名称保存。如果那个窗口已不存在，请删除 %2。</translation>
        </message>
        <message>
            <source>Open Read-only</source>
            <translation>以只读方式打开</translation>
        </message>
        <message>
            <source>Recover</source>
            <translation>恢复</translation>
        </message>
        <message>
            <source>The unsaved work could not be read.</source>
            <translation>无法读取未保存的工作。</translation>
        </message>
        <message>
            <source>Recovered %1; it is not saved yet</source>
            <translation>已恢复 %1；尚未保存</translation>
        </message>
    </context>
    <context>
        <name>Glossary</name>
        <message>
            <source>Master</source>
            <translation>主站</translation>
        </message>
        <message>
            <source>Slave</source>
            <translation>从站</translation>
        </message>
        <message>
            <source>Slaves missing</source>
            <translation>缺少从站</translation>
        </message>
        <message>
            <source>No response</source>
            <translation>无应答</translation>
        </message>
        <message>
            <source>Not monitored</source>
            <translation>未监视</translation>
        </message>
        <message>
            <source>Not ready</source>
            <translation>未就绪</translation>
        </message>
        <message>
            <source>Settling</source>
            <translation>稳定中</translation>
        </message>
        <message>
            <source>In sync</source>
            <translation>已同步</translation>
        </message>
        <message>
            <source>Out of sync</source>
            <translation>失步</translation>
        </message>
        <message>
            <source>Off</source>
            <translation>关闭</translation>
        </message>
        <message>
            <source>Bus shift</source>
            <translation>总线移位</translation>
        </message>
        <message>
            <source>Master shift</source>
            <translation>主站移位</translation>
        </message>
        <message>
            <source>Master reference clock</source>
            <translation>主站参考时钟</translation>
        </message>
        <message>
            <source>Adapter reference clock</source>
            <translation>网卡参考时钟</translation>
        </message>
        <message>
            <source>External clock (DCX)</source>
            <translation>外部时钟 (DCX)</translation>
        </message>
        <message>
            <source>Master shift by application</source>
            <translation>由应用执行主站移位</translation>
        </message>
        <message>
            <source>Unknown</source>
            <translation>未知</translation>
        </message>
        <message>
            <source>no reference clock</source>
            <translation>没有参考时钟</translation>
        </message>
        <message>
            <source>no reading of the reference clock</source>
            <translation>没有参考时钟的读数</translation>
        </message>
        <message>
            <source>error of the controller</source>
            <translation>控制器误差</translation>
        </message>
        <message>
            <source>schedule beyond its limit</source>
            <translation>调度超出限值</translation>
        </message>
        <message>
            <source>the reference clock has stepped</source>
            <translation>参考时钟发生跳变</translation>
        </message>
        <message>
            <source>cycles left out</source>
            <translation>漏发周期</translation>
        </message>
        <message>
            <source>frames later than the set value allows</source>
            <translation>帧晚于设定值所允许的时刻</translation>
        </message>
        <message>
            <source>settling</source>
            <translation>稳定中</translation>
        </message>
    </context>
    <context>
        <name>LanguageMenu</name>
        <message>
            <source>Lan&amp;guage</source>
            <translation>语言(&amp;G)</translation>
        </message>
        <message>
            <source>&amp;System Language</source>
            <translation>系统语言(&amp;S)</translation>
        </message>
        <message>
            <source>Applied at the next start</source>
            <translation>下次启动时生效</translation>
        </message>
        <message>
            <source>The window speaks this language from the next start on.</source>
            <translation>窗口从下次启动起使用此语言。</translation>
        </message>
    </context>
    <context>
        <name>Link</name>
        <message>
            <source>Demonstration machine (simulated)</source>
            <translation>演示机器（仿真）</translation>
        </message>
        <message>
            <source>Network card %1</source>
            <translation>网卡 %1</translation>
        </message>
        <message>
            <source>Simulated: %1</source>
            <translation>仿真：%1</translation>
        </message>
    </context>
    <context>
        <name>LinkChooser</name>
        <message>
            <source>Choose the Bus</source>
            <translation>选择总线</translation>
        </message>
        <message>
            <source>Where is the bus?</source>
            <translation>总线在哪里？</translation>
        </message>
        <message>
            <source>Links</source>
            <translation>链路</translation>
        </message>
        <message>
            <source>Demonstration machine</source>
            <translation>演示机器</translation>
        </message>
        <message>
            <source>Simulated bus with a coupler, terminals and drives; no hardware needed</source>
            <translation>带有耦合器、端子模块和驱动器的仿真总线；无需硬件</translation>
        </message>
        <message>
            <source>Simulated bus</source>
            <translation>仿真总线</translation>
        </message>
        <message>
            <source>Scenario File…</source>
            <translation>场景文件…</translation>
        </message>
        <message>
            <source>Simulated bus from a scenario file</source>
            <translation>来自场景文件的仿真总线</translation>
        </message>
        <message>
            <source>Network card, link up</source>
            <translation>网卡，链路已连通</translation>
        </message>
        <message>
            <source>Network card, no link</source>
            <translation>网卡，无链路</translation>
        </message>
        <message>
            <source>No network card was found that can carry EtherCAT.</source>
            <translation>未找到可运行 EtherCAT 的网卡。</translation>
        </message>
        <message>
            <source>Open Scenario</source>
            <translation>打开场景</translation>
        </message>
        <message>
            <source>Scenarios (*.toml)</source>
            <translation>场景 (*.toml)</translation>
        </message>
    </context>
    <context>
        <name>LiveStrip</name>
        <message>
            <source>Live plots</source>
            <translation>实时曲线</translation>
        </message>
        <message>
            <source>No data: go online</source>
            <translation>无数据：请先上线</translation>
        </message>
        <message>
            <source>Syncline, %1, cycle %2</source>
            <translation>Syncline，%1，周期 %2</translation>
        </message>
        <message>
            <source>Export the range shown</source>
            <translation>导出显示的范围</translation>
        </message>
        <message>
            <source>Comma-separated values (*.csv)</source>
            <translation>逗号分隔值 (*.csv)</translation>
        </message>
        <message>
            <source>Export</source>
            <translation>导出</translation>
        </message>
        <message>
            <source>%1: %2</source>
            <translation>%1：%2</translation>
        </message>
        <message>
            <source>Export the plots</source>
            <translation>导出曲线</translation>
        </message>
        <message>
            <source>PNG picture (*.png)</source>
            <translation>PNG 图片 (*.png)</translation>
        </message>
        <message>
            <source>Cursor A here</source>
            <translation>光标 A 放在此处</translation>
        </message>
        <message>
            <source>Cursor B here</source>
            <translation>光标 B 放在此处</translation>
        </message>
        <message>
            <source>Remove cursors</source>
            <translation>移除光标</translation>
        </message>
        <message>
            <source>Show everything</source>
            <translation>显示全部</translation>
        </message>
        <message>
            <source>Fit values</source>
            <translation>适配数值</translation>
        </message>
        <message>
            <source>Keep the value axes as they are</source>
            <translation>保持数值轴不变</translation>
        </message>
        <message>
            <source>Export range as CSV…</source>
            <translation>将范围导出为 CSV…</translation>
        </message>
        <message>
            <source>Export picture…</source>
            <translation>导出图片…</translation>
        </message>
        <message>
            <source>Copy picture</source>
            <translation>复制图片</translation>
        </message>
    </context>
    <context>
        <name>LiveStripToolbar</name>
        <message>
            <source>1 s</source>
            <translation>1 s</translation>
        </message>
        <message>
            <source>10 s</source>
            <translation>10 s</translation>
        </message>
        <message>
            <source>60 s</source>
            <translation>60 s</translation>
        </message>
        <message>
            <source>10 min</source>
            <translation>10 min</translation>
        </message>
        <message>
            <source>Show the last %1</source>
            <translation>显示最近 %1</translation>
        </message>
        <message>
            <source>Live</source>
            <translation>实时</translation>
        </message>
        <message>
            <source>Follow the newest sample (End)</source>
            <translation>跟随最新采样 (End)</translation>
        </message>
        <message>
            <source>Freeze</source>
            <translation>冻结</translation>
        </message>
        <message>
            <source>Stop the picture, not the acquisition (Space)</source>
            <translation>停止画面，不停止采集（空格键）</translation>
        </message>
        <message>
            <source>Cursors</source>
            <translation>光标</translation>
        </message>
        <message>
            <source>Two cursors to drag (keys A and B put them at the pointer)</source>
            <translation>两个可拖动的光标（A 键和 B 键将其放到指针处）</translation>
        </message>
        <message>
            <source>Fit</source>
            <translation>适配</translation>
        </message>
        <message>
            <source>Fit the value axes to what is shown (F)</source>
            <translation>使数值轴适配所显示的内容 (F)</translation>
        </message>
        <message>
            <source>State of the plots</source>
            <translation>曲线的状态</translation>
        </message>
        <message>
            <source>Time between the cursors</source>
            <translation>光标之间的时间</translation>
        </message>
        <message>
            <source>Export, axes and cursors</source>
            <translation>导出、坐标轴和光标</translation>
        </message>
        <message>
            <source>Menu of the live plots</source>
            <translation>实时曲线的菜单</translation>
        </message>
        <message>
            <source>Frozen, %1 behind</source>
            <translation>已冻结，落后 %1</translation>
        </message>
        <message>
            <source>History, %1 behind</source>
            <translation>历史，落后 %1</translation>
        </message>
        <message>
            <source>   1/Δt %1 Hz</source>
            <translation>   1/Δt %1 Hz</translation>
        </message>
        <message>
            <source>B−A %1</source>
            <translation>B−A %1</translation>
        </message>
    </context>
    <context>
        <name>MainWindow</name>
        <message>
            <source>A field holds what cannot be a value: mend it, or press Esc in it.</source>
            <translation>有字段的内容不是有效值：请改正，或在其中按 Esc。</translation>
        </message>
        <message>
            <source>Findings</source>
            <translation>检查结果</translation>
        </message>
        <message>
            <source>Findings (%1)</source>
            <translation>检查结果 (%1)</translation>
        </message>
        <message>
            <source>Live plots</source>
            <translation>实时曲线</translation>
        </message>
        <message>
            <source>Project Explorer</source>
            <translation>项目浏览器</translation>
        </message>
        <message>
            <source>Messages</source>
            <translation>消息</translation>
        </message>
        <message>
            <source>&amp;File</source>
            <translation>文件(&amp;F)</translation>
        </message>
        <message>
            <source>&amp;Edit</source>
            <translation>编辑(&amp;E)</translation>
        </message>
        <message>
            <source>&amp;Network</source>
            <translation>网络(&amp;N)</translation>
        </message>
        <message>
            <source>&amp;Request State</source>
            <translation>请求状态(&amp;R)</translation>
        </message>
        <message>
            <source>&amp;View</source>
            <translation>视图(&amp;V)</translation>
        </message>
        <message>
            <source>&amp;Help</source>
            <translation>帮助(&amp;H)</translation>
        </message>
        <message>
            <source>Main</source>
            <translation>主工具栏</translation>
        </message>
        <message>
            <source>Request a state for all slaves</source>
            <translation>为所有从站请求状态</translation>
        </message>
        <message>
            <source>Request State</source>
            <translation>请求状态</translation>
        </message>
        <message>
            <source>Request a state for all slaves (register 0x0120)</source>
            <translation>为所有从站请求状态（寄存器 0x0120）</translation>
        </message>
        <message>
            <source>%1[*] – Syncline</source>
            <translation>%1[*] – Syncline</translation>
        </message>
        <message>
            <source>Revert to what runs</source>
            <translation>还原为运行中的配置</translation>
        </message>
        <message>
            <source>%1[*] (read-only) – Syncline</source>
            <translation>%1[*]（只读）– Syncline</translation>
        </message>
    </context>
    <context>
        <name>MasterDcPage</name>
        <message>
            <source>Distributed Clocks</source>
            <translation>分布时钟</translation>
        </message>
        <message>
            <source>Clock Adjustment</source>
            <translation>时钟校准</translation>
        </message>
        <message>
            <source>Master Synchronisation (DCM)</source>
            <translation>主站同步 (DCM)</translation>
        </message>
        <message>
            <source>Sync Window Monitoring</source>
            <translation>同步窗口监视</translation>
        </message>
        <message>
            <source>Slaves, live</source>
            <translation>从站，实时</translation>
        </message>
        <message>
            <source>Master, live</source>
            <translation>主站，实时</translation>
        </message>
        <message>
            <source>Reference clock</source>
            <translation>参考时钟</translation>
        </message>
        <message>
            <source>The master&apos;s clock leads: the reference clock is steered by a cyclic write to register 0x0910</source>
            <translation>主站时钟引领：通过循环写寄存器 0x0910 调节参考时钟</translation>
        </message>
        <message>
            <source>The reference clock leads: the master moves its send time. No extra cyclic command.</source>
            <translation>参考时钟引领：主站移动其发送时刻。没有额外的循环命令。</translation>
        </message>
        <message>
            <source>Master and slaves run on clocks of their own; the frame drifts through the SYNC grid</source>
            <translation>主站和从站各用自己的时钟；帧在 SYNC 网格中漂移</translation>
        </message>
        <message>
            <source>As bus shift, without a control loop: the reference clock is written the nominal time. Needs an accurate cycle.</source>
            <translation>同总线移位，但没有控制环：将标称时间写入参考时钟。要求周期精确。</translation>
        </message>
        <message>
            <source>As bus shift, with the time that the network adapter puts into each frame while sending it</source>
            <translation>同总线移位，使用网卡在发送时写入每一帧的时间</translation>
        </message>
        <message>
            <source>An external clock leads through a bridge device: the reference clock follows it, the master follows the reference clock</source>
            <translation>外部时钟经桥接设备引领：参考时钟跟随它，主站跟随参考时钟</translation>
        </message>
        <message>
            <source>The reference clock leads, and the application moves the send time by the reported adjustment</source>
            <translation>参考时钟引领，应用按所报告的调整量移动发送时刻</translation>
        </message>
        <message>
            <source>Set value automatic</source>
            <translation>设定值自动</translation>
        </message>
        <message>
            <source>Two thirds of the cycle</source>
            <translation>周期的三分之二</translation>
        </message>
        <message>
            <source>Limit</source>
            <translation>限值</translation>
        </message>
        <message>
            <source>Slaves in sync</source>
            <translation>从站同步</translation>
        </message>
        <message>
            <source>State</source>
            <translation>状态</translation>
        </message>
        <message>
            <source>Sync window of register 0x092C</source>
            <translation>寄存器 0x092C 的同步窗口</translation>
        </message>
        <message>
            <source>Deviation</source>
            <translation>偏差</translation>
        </message>
        <message>
            <source>Register 0x092C: largest latest reading of the slaves that follow the reference clock</source>
            <translation>寄存器 0x092C：跟随参考时钟的从站最新读数中的最大值</translation>
        </message>
        <message>
            <source>Settled after</source>
            <translation>稳定用时</translation>
        </message>
        <message>
            <source>From the first cyclic frame</source>
            <translation>从第一个循环帧算起</translation>
        </message>
        <message>
            <source>The slave that leads on the bus</source>
            <translation>在总线上引领的从站</translation>
        </message>
        <message>
            <source>Master in sync</source>
            <translation>主站同步</translation>
        </message>
        <message>
            <source>Error of the controller, frames later than the set value allows, cycles left out: none of them within the settle time</source>
            <translation>控制器误差、晚于设定值所允许时刻的帧、漏发的周期：在稳定时间内均未出现</translation>
        </message>
        <message>
            <source>Error</source>
            <translation>误差</translation>
        </message>
        <message>
            <source>Frame late in the SYNC grid &gt; 0, filtered</source>
            <translation>帧在 SYNC 网格中偏晚为 &gt; 0，滤波后</translation>
        </message>
        <message>
            <source>RMS / max</source>
            <translation>RMS / 最大</translation>
        </message>
        <message>
            <source>Since in sync</source>
            <translation>自同步起</translation>
        </message>
        <message>
            <source>Drift</source>
            <translation>漂移</translation>
        </message>
        <message>
            <source>Reference clock&apos;s rate against the host&apos;s; the ceiling is about 600 ppm</source>
            <translation>参考时钟相对主机的速率；上限约为 600 ppm</translation>
        </message>
        <message>
            <source>In sync after</source>
            <translation>同步用时</translation>
        </message>
        <message>
            <source>%1 / %2</source>
            <translation>%1 / %2</translation>
        </message>
        <message>
            <source>%1 (limit %2)</source>
            <translation>%1（限值 %2）</translation>
        </message>
        <message>
            <source>at once</source>
            <translation>立即</translation>
        </message>
        <message>
            <source>in this cycle</source>
            <translation>本周期</translation>
        </message>
        <message>
            <source>Last heard of</source>
            <translation>最近收到</translation>
        </message>
        <message>
            <source>How long ago something was last heard of each slave that follows</source>
            <translation>距最近一次收到每个跟随从站的信息已过去多久</translation>
        </message>
        <message>
            <source>Frame, max / allowed</source>
            <translation>帧，最大 / 允许</translation>
        </message>
        <message>
            <source>Error of the schedule and how late frames were sent, together: largest since in sync, and at which a frame meets SYNC0</source>
            <translation>调度误差与帧的迟发量之和：自同步以来的最大值，以及帧与 SYNC0 相遇的值</translation>
        </message>
        <message>
            <source>%1 ago</source>
            <translation>%1 前</translation>
        </message>
    </context>
    <context>
        <name>MasterGeneralPage</name>
        <message>
            <source>Recovery</source>
            <translation>恢复</translation>
        </message>
        <message>
            <source>General</source>
            <translation>常规</translation>
        </message>
        <message>
            <source>Settings</source>
            <translation>设置</translation>
        </message>
        <message>
            <source>Configuration</source>
            <translation>配置</translation>
        </message>
        <message>
            <source>Slaves</source>
            <translation>从站</translation>
        </message>
        <message>
            <source>Configured slaves</source>
            <translation>已配置的从站</translation>
        </message>
        <message>
            <source>Slaves with DC</source>
            <translation>带 DC 的从站</translation>
        </message>
        <message>
            <source>Inputs</source>
            <translation>输入</translation>
        </message>
        <message>
            <source>Input process image (ENI ProcessImage/Inputs)</source>
            <translation>输入过程映像 (ENI ProcessImage/Inputs)</translation>
        </message>
        <message>
            <source>Outputs</source>
            <translation>输出</translation>
        </message>
        <message>
            <source>Output process image (ENI ProcessImage/Outputs)</source>
            <translation>输出过程映像 (ENI ProcessImage/Outputs)</translation>
        </message>
        <message>
            <source>Cyclic frames</source>
            <translation>循环帧</translation>
        </message>
        <message>
            <source>Bytes and time on the wire at 100 Mbit/s, each cycle</source>
            <translation>每个周期的字节数和 100 Mbit/s 下的线上时间</translation>
        </message>
        <message>
            <source>State Machine</source>
            <translation>状态机</translation>
        </message>
        <message>
            <source>Bus</source>
            <translation>总线</translation>
        </message>
        <message>
            <source>Current state</source>
            <translation>当前状态</translation>
        </message>
        <message>
            <source>Lowest state of all slaves (register 0x0130)</source>
            <translation>所有从站中的最低状态（寄存器 0x0130）</translation>
        </message>
        <message>
            <source>Requested state</source>
            <translation>请求的状态</translation>
        </message>
        <message>
            <source>State asked for last (register 0x0120)</source>
            <translation>最近一次请求的状态（寄存器 0x0120）</translation>
        </message>
        <message>
            <source>Request state %1</source>
            <translation>请求状态 %1</translation>
        </message>
        <message>
            <source>Request %1 for all slaves (register 0x0120)</source>
            <translation>为所有从站请求 %1（寄存器 0x0120）</translation>
        </message>
        <message>
            <source>Slaves answering</source>
            <translation>应答的从站</translation>
        </message>
        <message>
            <source>Slaves that answered the last state reading</source>
            <translation>最近一次读取状态时应答的从站</translation>
        </message>
        <message>
            <source>Cycles</source>
            <translation>周期</translation>
        </message>
        <message>
            <source>Bus cycles since going online</source>
            <translation>上线以来的总线周期</translation>
        </message>
        <message>
            <source>Lost frames</source>
            <translation>丢失帧</translation>
        </message>
        <message>
            <source>Frames that did not come back</source>
            <translation>没有返回的帧</translation>
        </message>
        <message>
            <source>Working counter errors</source>
            <translation>工作计数器错误</translation>
        </message>
        <message>
            <source>Cycles whose working counter was not the expected one</source>
            <translation>工作计数器与期望值不符的周期</translation>
        </message>
        <message>
            <source>Cycles left out</source>
            <translation>漏发周期</translation>
        </message>
        <message>
            <source>Cycles without a frame: the host came too late for them</source>
            <translation>没有发送帧的周期：主机来得太晚</translation>
        </message>
        <message>
            <source>%1, %2 on the wire</source>
            <translation>%1，线上时间 %2</translation>
        </message>
        <message>
            <source>Offline</source>
            <translation>离线</translation>
        </message>
        <message>
            <source>%1 of %2</source>
            <translation>%1 / %2</translation>
        </message>
        <message>
            <source>Slaves whose distributed clock is set up (ENI Slave/DC)</source>
            <translation>已设置分布时钟的从站 (ENI Slave/DC)</translation>
        </message>
        <message>
            <source>Late frames</source>
            <translation>迟到帧</translation>
        </message>
        <message>
            <source>Frames that came back after their cycle</source>
            <translation>在其周期之后才返回的帧</translation>
        </message>
        <message>
            <source>Frame Addresses</source>
            <translation>帧地址</translation>
        </message>
        <message>
            <source>Process Image</source>
            <translation>过程映像</translation>
        </message>
        <message>
            <source>Real Time</source>
            <translation>实时</translation>
        </message>
    </context>
    <context>
        <name>MessageModel</name>
        <message>
            <source>%1
Setting %2</source>
            <translation>%1
设置 %2</translation>
        </message>
        <message>
            <source>Project</source>
            <translation>项目</translation>
        </message>
        <message>
            <source>Error</source>
            <translation>误差</translation>
        </message>
        <message>
            <source>Warning</source>
            <translation>警告</translation>
        </message>
        <message>
            <source>Information</source>
            <translation>信息</translation>
        </message>
        <message>
            <source>Time</source>
            <translation>时间</translation>
        </message>
        <message>
            <source>Severity</source>
            <translation>严重程度</translation>
        </message>
        <message>
            <source>Source</source>
            <translation>来源</translation>
        </message>
        <message>
            <source>Message</source>
            <translation>消息</translation>
        </message>
    </context>
    <context>
        <name>MessagesPanel</name>
        <message>
            <source>Filter messages</source>
            <translation>筛选消息</translation>
        </message>
        <message>
            <source>Filter</source>
            <translation>筛选</translation>
        </message>
        <message>
            <source>Clear the log</source>
            <translation>清空日志</translation>
        </message>
        <message>
            <source>Clear the log; findings about the project stay</source>
            <translation>清空日志；关于项目的检查结果保留</translation>
        </message>
        <message>
            <source>Messages</source>
            <translation>消息</translation>
        </message>
        <message>
            <source>Show information</source>
            <translation>显示信息</translation>
        </message>
        <message>
            <source>Show warnings</source>
            <translation>显示警告</translation>
        </message>
        <message>
            <source>Show errors</source>
            <translation>显示错误</translation>
        </message>
    </context>
    <context>
        <name>NetworkModel</name>
        <message>
            <source>Node</source>
            <translation>节点</translation>
        </message>
        <message>
            <source>Position %1, station address %2 (register 0x0010)</source>
            <translation>位置 %1，站地址 %2（寄存器 0x0010）</translation>
        </message>
        <message>
            <source>Reference clock of the project</source>
            <translation>项目的参考时钟</translation>
        </message>
        <message>
            <source>Distributed clocks on</source>
            <translation>分布时钟已启用</translation>
        </message>
        <message>
            <source>State %1</source>
            <translation>状态 %1</translation>
        </message>
        <message>
            <source>State %1 (register 0x0130 = %2)</source>
            <translation>状态 %1（寄存器 0x0130 = %2）</translation>
        </message>
        <message>
            <source>Offline</source>
            <translation>离线</translation>
        </message>
    </context>
    <context>
        <name>Page</name>
        <message>
            <source>Project</source>
            <translation>项目</translation>
        </message>
    </context>
    <context>
        <name>PdoEntryModel</name>
        <message>
            <source>(padding)</source>
            <translation>（填充）</translation>
        </message>
        <message>
            <source>Offset</source>
            <translation>偏移</translation>
        </message>
        <message>
            <source>Object</source>
            <translation>对象</translation>
        </message>
        <message>
            <source>Entry</source>
            <translation>条目</translation>
        </message>
        <message>
            <source>Type</source>
            <translation>类型</translation>
        </message>
        <message>
            <source>Size</source>
            <translation>大小</translation>
        </message>
    </context>
    <context>
        <name>PdoModel</name>
        <message>
            <source>The device needs this PDO (Mandatory in the ESI)</source>
            <translation>设备需要此 PDO（ESI 中的 Mandatory）</translation>
        </message>
        <message>
            <source>Excluded by the assigned PDO %1 (Exclude in the ESI)</source>
            <translation>被已分配的 PDO %1 排除（ESI 中的 Exclude）</translation>
        </message>
        <message>
            <source>Assigned through object 0x1C12</source>
            <translation>通过对象 0x1C12 分配</translation>
        </message>
        <message>
            <source>Assigned through object 0x1C13</source>
            <translation>通过对象 0x1C13 分配</translation>
        </message>
        <message>
            <source>PDO</source>
            <translation>PDO</translation>
        </message>
        <message>
            <source>Name</source>
            <translation>名称</translation>
        </message>
        <message>
            <source>SM</source>
            <translation>SM</translation>
        </message>
        <message>
            <source>Size</source>
            <translation>大小</translation>
        </message>
    </context>
    <context>
        <name>ProcessDataPage</name>
        <message>
            <source>Process Data</source>
            <translation>过程数据</translation>
        </message>
        <message>
            <source>Outputs (RxPDO)</source>
            <translation>输出 (RxPDO)</translation>
        </message>
        <message>
            <source>Inputs (TxPDO)</source>
            <translation>输入 (TxPDO)</translation>
        </message>
        <message>
            <source>Assigned size, %1</source>
            <translation>分配的大小，%1</translation>
        </message>
        <message>
            <source>Entries</source>
            <translation>条目</translation>
        </message>
        <message>
            <source>Entries of %1 %2</source>
            <translation>%1 %2 的条目</translation>
        </message>
        <message>
            <source>%1 assigned</source>
            <translation>已分配 %1</translation>
        </message>
        <message>
            <source>As slave, PDO and entry</source>
            <translation>按从站、PDO 和条目</translation>
        </message>
    </context>
    <context>
        <name>ProjectDocument</name>
        <message>
            <source>Untitled</source>
            <translation>未命名</translation>
        </message>
    </context>
    <context>
        <name>QObject</name>
        <message>
            <source>Syncline</source>
            <translation>Syncline</translation>
        </message>
    </context>
    <context>
        <name>ScanProgress</name>
        <message>
            <source>Scan</source>
            <translation>扫描</translation>
        </message>
        <message>
            <source>Scan progress</source>
            <translation>扫描进度</translation>
        </message>
        <message>
            <source>Looking for slaves…</source>
            <translation>正在查找从站…</translation>
        </message>
        <message>
            <source>Reading slave %1 of %2</source>
            <translation>正在读取从站 %1 / %2</translation>
        </message>
        <message>
            <source>Cancelling…</source>
            <translation>正在取消…</translation>
        </message>
    </context>
    <context>
        <name>SlaveDcPage</name>
        <message>
            <source>Distributed Clocks</source>
            <translation>分布时钟</translation>
        </message>
        <message>
            <source>Operation Mode</source>
            <translation>操作模式</translation>
        </message>
        <message>
            <source>SYNC0</source>
            <translation>SYNC0</translation>
        </message>
        <message>
            <source>SYNC1</source>
            <translation>SYNC1</translation>
        </message>
        <message>
            <source>Registers</source>
            <translation>寄存器</translation>
        </message>
        <message>
            <source>Live</source>
            <translation>实时</translation>
        </message>
        <message>
            <source>Mode</source>
            <translation>模式</translation>
        </message>
        <message>
            <source>Meaning</source>
            <translation>含义</translation>
        </message>
        <message>
            <source>ESI OpMode/Desc</source>
            <translation>ESI OpMode/Desc</translation>
        </message>
        <message>
            <source>AssignActivate</source>
            <translation>AssignActivate</translation>
        </message>
        <message>
            <source>ESI OpMode/AssignActivate, written to register 0x0980</source>
            <translation>ESI OpMode/AssignActivate，写入寄存器 0x0980</translation>
        </message>
        <message>
            <source>Bus cycle</source>
            <translation>总线周期</translation>
        </message>
        <message>
            <source>Cycle time of the master, base of the Sync Unit Cycle</source>
            <translation>主站的周期时间，同步单元周期的基准</translation>
        </message>
        <message>
            <source>0x0980 activation</source>
            <translation>0x0980 激活</translation>
        </message>
        <message>
            <source>Compiled value, as written in PREOP to SAFEOP</source>
            <translation>编译所得的值，在 PREOP 到 SAFEOP 时写入</translation>
        </message>
        <message>
            <source>0x09A0 SYNC0 cycle</source>
            <translation>0x09A0 SYNC0 周期</translation>
        </message>
        <message>
            <source>Compiled value (ENI DC/CycleTime0)</source>
            <translation>编译所得的值 (ENI DC/CycleTime0)</translation>
        </message>
        <message>
            <source>0x09A4 SYNC1</source>
            <translation>0x09A4 SYNC1</translation>
        </message>
        <message>
            <source>Compiled value (ENI DC/CycleTime1)</source>
            <translation>编译所得的值 (ENI DC/CycleTime1)</translation>
        </message>
        <message>
            <source>0x0990 shift</source>
            <translation>0x0990 移位</translation>
        </message>
        <message>
            <source>Compiled part of the start time (ENI DC/ShiftTime)</source>
            <translation>起始时间中编译所得的部分 (ENI DC/ShiftTime)</translation>
        </message>
        <message>
            <source>Role</source>
            <translation>角色</translation>
        </message>
        <message>
            <source>What this slave&apos;s clock does on the bus</source>
            <translation>此从站的时钟在总线上的作用</translation>
        </message>
        <message>
            <source>Deviation</source>
            <translation>偏差</translation>
        </message>
        <message>
            <source>SystemTimeDifference, register 0x092C</source>
            <translation>SystemTimeDifference，寄存器 0x092C</translation>
        </message>
        <message>
            <source>Propagation delay</source>
            <translation>传输延迟</translation>
        </message>
        <message>
            <source>Register 0x0928, measured at start-up</source>
            <translation>寄存器 0x0928，启动时测量</translation>
        </message>
        <message>
            <source>Missed SM2 events</source>
            <translation>错过的 SM2 事件</translation>
        </message>
        <message>
            <source>Counter of the device (object 0x1C32)</source>
            <translation>设备的计数器（对象 0x1C32）</translation>
        </message>
        <message>
            <source>Offline</source>
            <translation>离线</translation>
        </message>
        <message>
            <source>Reference clock</source>
            <translation>参考时钟</translation>
        </message>
        <message>
            <source>Follows</source>
            <translation>跟随</translation>
        </message>
        <message>
            <source>DC off</source>
            <translation>DC 关闭</translation>
        </message>
        <message>
            <source>%1 (object %2:%3)</source>
            <translation>%1（对象 %2:%3）</translation>
        </message>
        <message>
            <source>Does not follow</source>
            <translation>不跟随</translation>
        </message>
        <message>
            <source>CAN</source>
            <translation>CAN</translation>
        </message>
        <message>
            <source>Output Pins</source>
            <translation>输出引脚</translation>
        </message>
        <message>
            <source>Pin %1</source>
            <translation>引脚 %1</translation>
        </message>
    </context>
    <context>
        <name>SlaveGeneralPage</name>
        <message>
            <source>General</source>
            <translation>常规</translation>
        </message>
        <message>
            <source>Device</source>
            <translation>设备</translation>
        </message>
        <message>
            <source>Address</source>
            <translation>地址</translation>
        </message>
        <message>
            <source>Checks at Start-up</source>
            <translation>启动时检查</translation>
        </message>
        <message>
            <source>State</source>
            <translation>状态</translation>
        </message>
        <message>
            <source>Time-outs</source>
            <translation>超时</translation>
        </message>
        <message>
            <source>Type</source>
            <translation>类型</translation>
        </message>
        <message>
            <source>ESI Device/Type</source>
            <translation>ESI Device/Type</translation>
        </message>
        <message>
            <source>Vendor</source>
            <translation>供应商</translation>
        </message>
        <message>
            <source>SII word 0x0008, ESI Vendor/Id</source>
            <translation>SII 字 0x0008，ESI Vendor/Id</translation>
        </message>
        <message>
            <source>Product code</source>
            <translation>产品代码</translation>
        </message>
        <message>
            <source>SII word 0x000A, ESI Type@ProductCode</source>
            <translation>SII 字 0x000A，ESI Type@ProductCode</translation>
        </message>
        <message>
            <source>Revision</source>
            <translation>版本号</translation>
        </message>
        <message>
            <source>SII word 0x000C, ESI Type@RevisionNo</source>
            <translation>SII 字 0x000C，ESI Type@RevisionNo</translation>
        </message>
        <message>
            <source>Serial number</source>
            <translation>序列号</translation>
        </message>
        <message>
            <source>SII word 0x000E</source>
            <translation>SII 字 0x000E</translation>
        </message>
        <message>
            <source>Described by</source>
            <translation>描述来源</translation>
        </message>
        <message>
            <source>File or EEPROM that the device description came from</source>
            <translation>设备描述所来自的文件或 EEPROM</translation>
        </message>
        <message>
            <source>Alias</source>
            <translation>别名</translation>
        </message>
        <message>
            <source>Auto-increment</source>
            <translation>自动递增</translation>
        </message>
        <message>
            <source>Position address used before the station address is set</source>
            <translation>设置站地址之前使用的位置地址</translation>
        </message>
        <message>
            <source>Current state</source>
            <translation>当前状态</translation>
        </message>
        <message>
            <source>AL status (register 0x0130)</source>
            <translation>AL 状态（寄存器 0x0130）</translation>
        </message>
        <message>
            <source>AL status code</source>
            <translation>AL 状态码</translation>
        </message>
        <message>
            <source>Register 0x0134</source>
            <translation>寄存器 0x0134</translation>
        </message>
        <message>
            <source>Meaning of the AL status code</source>
            <translation>AL 状态码的含义</translation>
        </message>
        <message>
            <source>INIT to PREOP</source>
            <translation>INIT 到 PREOP</translation>
        </message>
        <message>
            <source>ESI Timeout/PreopTimeout</source>
            <translation>ESI Timeout/PreopTimeout</translation>
        </message>
        <message>
            <source>PREOP to SAFEOP to OP</source>
            <translation>PREOP 到 SAFEOP 到 OP</translation>
        </message>
        <message>
            <source>ESI Timeout/SafeopOpTimeout</source>
            <translation>ESI Timeout/SafeopOpTimeout</translation>
        </message>
        <message>
            <source>Back to INIT</source>
            <translation>返回 INIT</translation>
        </message>
        <message>
            <source>ESI Timeout/BackToInitTimeout</source>
            <translation>ESI Timeout/BackToInitTimeout</translation>
        </message>
        <message>
            <source>Back to SAFEOP</source>
            <translation>返回 SAFEOP</translation>
        </message>
        <message>
            <source>ESI Timeout/BackToSafeopTimeout</source>
            <translation>ESI Timeout/BackToSafeopTimeout</translation>
        </message>
        <message>
            <source>any</source>
            <translation>任意</translation>
        </message>
        <message>
            <source>%1, port %2</source>
            <translation>%1，端口 %2</translation>
        </message>
        <message>
            <source>Offline</source>
            <translation>离线</translation>
        </message>
        <message>
            <source>%1 + error</source>
            <translation>%1 + 错误</translation>
        </message>
        <message>
            <source>Place on the Bus</source>
            <translation>在总线上的位置</translation>
        </message>
        <message>
            <source>In front</source>
            <translation>前一级</translation>
        </message>
        <message>
            <source>Slave and port in front of this one</source>
            <translation>此从站前面的从站和端口</translation>
        </message>
    </context>
    <context>
        <name>Sm2Panel</name>
        <message>
            <source>SM2 events missed</source>
            <translation>错过的 SM2 事件</translation>
        </message>
        <message>
            <source>Events</source>
            <translation>事件</translation>
        </message>
        <message>
            <source>SM event missed counter, object 0x1C32:0B or 0x1C32:0C of the slaves that have one.</source>
            <translation>SM 事件错过计数器，即具有该计数器的从站的对象 0x1C32:0B 或 0x1C32:0C。</translation>
        </message>
        <message>
            <source>no slave has this counter</source>
            <translation>没有从站具有此计数器</translation>
        </message>
        <message>
            <source>none in the range shown</source>
            <translation>显示范围内没有</translation>
        </message>
        <message>
            <source>%1: %2/s</source>
            <translation>%1：%2/s</translation>
        </message>
    </context>
    <context>
        <name>StatusPanel</name>
        <message>
            <source>Offline</source>
            <translation>离线</translation>
        </message>
        <message>
            <source>Starting</source>
            <translation>正在启动</translation>
        </message>
        <message>
            <source>Stopping</source>
            <translation>正在停止</translation>
        </message>
        <message>
            <source>Online</source>
            <translation>在线</translation>
        </message>
        <message>
            <source>Connection</source>
            <translation>连接</translation>
        </message>
        <message>
            <source>Whether the master runs, and the link carries frames</source>
            <translation>主站是否在运行，链路是否传送帧</translation>
        </message>
        <message>
            <source>Link</source>
            <translation>链路</translation>
        </message>
        <message>
            <source>What the bus is connected through</source>
            <translation>连接总线所用的链路</translation>
        </message>
        <message>
            <source>Slaves</source>
            <translation>从站</translation>
        </message>
        <message>
            <source>Slaves in the master&apos;s state, of all configured</source>
            <translation>处于主站状态的从站数，相对于全部已配置的从站</translation>
        </message>
        <message>
            <source>Slaves in sync</source>
            <translation>从站同步</translation>
        </message>
        <message>
            <source>Sync window of register 0x092C over all slaves that follow the reference clock</source>
            <translation>跟随参考时钟的所有从站的寄存器 0x092C 同步窗口</translation>
        </message>
        <message>
            <source>Master in sync</source>
            <translation>主站同步</translation>
        </message>
        <message>
            <source>Master synchronisation: error against its limit, late frames, cycles left out</source>
            <translation>主站同步：误差与其限值、迟到帧、漏发周期</translation>
        </message>
        <message>
            <source>Drift</source>
            <translation>漂移</translation>
        </message>
        <message>
            <source>Reference clock&apos;s rate against the host&apos;s</source>
            <translation>参考时钟相对主机的速率</translation>
        </message>
        <message>
            <source>Cycle time</source>
            <translation>周期时间</translation>
        </message>
        <message>
            <source>Bus cycle</source>
            <translation>总线周期</translation>
        </message>
        <message>
            <source>Lost frames, late frames, cycles left out</source>
            <translation>丢失帧、迟到帧、漏发周期</translation>
        </message>
        <message>
            <source>Frames that did not come back, or came after their cycle; cycles that the host came too late for; samples the display could not take</source>
            <translation>没有返回或在其周期之后才返回的帧；主机来得太晚的周期；显示未能接收的采样</translation>
        </message>
        <message>
            <source>No link chosen</source>
            <translation>未选择链路</translation>
        </message>
        <message>
            <source>A link is chosen when scanning or going online</source>
            <translation>扫描或上线时选择链路</translation>
        </message>
        <message>
            <source>Slaves %1/%2 %3</source>
            <translation>从站 %1/%2 %3</translation>
        </message>
        <message numerus="yes">
            <source>%n slave(s)</source>
            <translation>
                <numerusform>%n 个从站</numerusform>
            </translation>
        </message>
        <message>
            <source>DC: %1</source>
            <translation>DC：%1</translation>
        </message>
        <message>
            <source>DCM: %1</source>
            <translation>DCM：%1</translation>
        </message>
        <message>
            <source>Drift %1</source>
            <translation>漂移 %1</translation>
        </message>
        <message>
            <source>Cycle %1</source>
            <translation>周期 %1</translation>
        </message>
        <message>
            <source>Lost %1  Late %2  Left out %3</source>
            <translation>丢失 %1  迟到 %2  漏发 %3</translation>
        </message>
        <message>
            <source>  Dropped %1</source>
            <translation>  丢弃 %1</translation>
        </message>
    </context>
    <context>
        <name>Sync</name>
        <message>
            <source>Offline</source>
            <translation>离线</translation>
        </message>
        <message>
            <source>DC off</source>
            <translation>DC 关闭</translation>
        </message>
        <message>
            <source>%1: %2</source>
            <translation>%1：%2</translation>
        </message>
    </context>
    <context>
        <name>SyncSettingsEditor</name>
        <message>
            <source>Device family</source>
            <translation>设备系列</translation>
        </message>
        <message>
            <source>Whose limits are known beyond the ESI (docs/device-families.md)</source>
            <translation>其限值在 ESI 之外已知 (docs/device-families.md)</translation>
        </message>
        <message>
            <source>SYNC0 cycles</source>
            <translation>SYNC0 周期</translation>
        </message>
        <message>
            <source>What the device takes; others are refused at SAFEOP</source>
            <translation>设备接受的周期；其他周期在 SAFEOP 时被拒绝</translation>
        </message>
        <message>
            <source>multiples of %1</source>
            <translation>%1 的倍数</translation>
        </message>
        <message>
            <source>from %1</source>
            <translation>从 %1 起</translation>
        </message>
        <message>
            <source>to %1</source>
            <translation>至 %1</translation>
        </message>
        <message>
            <source>As device (%1)</source>
            <translation>同设备 (%1)</translation>
        </message>
        <message>
            <source>As device</source>
            <translation>同设备</translation>
        </message>
        <message>
            <source>0 (never gives up)</source>
            <translation>0（从不放弃）</translation>
        </message>
        <message>
            <source>SYNC0</source>
            <translation>SYNC0</translation>
        </message>
        <message numerus="yes">
            <source>%1 (%n miss(es) in a row)</source>
            <translation>
                <numerusform>%1（连续错过 %n 次）</numerusform>
            </translation>
        </message>
    </context>
    <context>
        <name>SyncUnitEditor</name>
        <message>
            <source>Sync Unit Cycle of %1</source>
            <translation>%1 的同步单元周期</translation>
        </message>
        <message>
            <source>Sync Unit Cycle</source>
            <translation>同步单元周期</translation>
        </message>
        <message>
            <source>Cycle of %1</source>
            <translation>%1 的周期</translation>
        </message>
        <message>
            <source>Shift of %1</source>
            <translation>%1 的移位</translation>
        </message>
        <message>
            <source>Shift</source>
            <translation>移位</translation>
        </message>
        <message>
            <source>As operation mode (%1)</source>
            <translation>同操作模式 (%1)</translation>
        </message>
        <message>
            <source>User defined</source>
            <translation>自定义</translation>
        </message>
        <message>
            <source>Factor %1</source>
            <translation>系数 %1</translation>
        </message>
        <message>
            <source>Off in this operation mode</source>
            <translation>在此操作模式下关闭</translation>
        </message>
        <message>
            <source>Change Sync Unit Cycle of SYNC%1</source>
            <translation>更改 SYNC%1 的同步单元周期</translation>
        </message>
    </context>
    <context>
        <name>TracePanel</name>
        <message>
            <source>Legend: %1</source>
            <translation>图例：%1</translation>
        </message>
        <message>
            <source>Figures: %1</source>
            <translation>数值：%1</translation>
        </message>
        <message>
            <source>no samples at A or B</source>
            <translation>A 或 B 处没有采样</translation>
        </message>
        <message>
            <source>B−A %1</source>
            <translation>B−A %1</translation>
        </message>
        <message>
            <source>   min %1   max %2   mean %3</source>
            <translation>   最小 %1   最大 %2   平均 %3</translation>
        </message>
    </context>
    <context>
        <name>TracePlot</name>
        <message>
            <source>Time before now</source>
            <translation>距现在的时间</translation>
        </message>
        <message>
            <source>Time since start</source>
            <translation>自启动起的时间</translation>
        </message>
    </context>
    <context>
        <name>Units</name>
        <message numerus="yes">
            <source>%n Byte(s)</source>
            <translation>
                <numerusform>%n 字节</numerusform>
            </translation>
        </message>
        <message numerus="yes">
            <source>%n Bit(s)</source>
            <translation>
                <numerusform>%n 位</numerusform>
            </translation>
        </message>
    </context>
    <context>
        <name>WelcomePage</name>
        <message>
            <source>Welcome</source>
            <translation>欢迎</translation>
        </message>
        <message>
            <source>Configure a machine, run it, and see it in sync</source>
            <translation>配置机器，运行机器，查看其同步</translation>
        </message>
        <message>
            <source>Begin with the simulated demonstration machine, a bus, or a project file.</source>
            <translation>从仿真的演示机器、总线或项目文件开始。</translation>
        </message>
        <message>
            <source>Open %1</source>
            <translation>打开 %1</translation>
        </message>
        <message>
            <source>Pin %1</source>
            <translation>固定 %1</translation>
        </message>
        <message>
            <source>Stays in the list</source>
            <translation>保留在列表中</translation>
        </message>
        <message>
            <source>Keep it in the list</source>
            <translation>将其保留在列表中</translation>
        </message>
    </context>
    <context>
        <name>Workspace</name>
        <message>
            <source>Scan</source>
            <translation>扫描</translation>
        </message>
        <message>
            <source>Configuration</source>
            <translation>配置</translation>
        </message>
        <message numerus="yes">
            <source>%n slave(s) found on %1</source>
            <translation>
                <numerusform>在 %1 上找到 %n 个从站</numerusform>
            </translation>
        </message>
        <message>
            <source>Unsaved work is not kept</source>
            <translation>未保存的工作不会保留</translation>
        </message>
    </context>
    <context>
        <name>Finding</name>
        <message>
            <source>Slaves %1</source>
            <translation>从站 %1</translation>
        </message>
        <message>
            <source>each of slaves %1</source>
            <translation>从站 %1 各</translation>
        </message>
        <message>
            <source> to </source>
            <translation> 至 </translation>
        </message>
        <message>
            <source>at least %1</source>
            <translation>至少 %1</translation>
        </message>
        <message>
            <source>once</source>
            <translation>一次</translation>
        </message>
        <message>
            <source>%1 times</source>
            <translation>%1 次</translation>
        </message>
        <message>
            <source>the host</source>
            <translation>主机</translation>
        </message>
        <message>
            <source>nobody in the configuration</source>
            <translation>配置中没有从站</translation>
        </message>
        <message>
            <source>slaves %1 to %2</source>
            <translation>从站 %1 至 %2</translation>
        </message>
        <message>
            <source>slave %1</source>
            <translation>从站 %1</translation>
        </message>
    </context>
    <context>
        <name>FindingModel</name>
        <message>
            <source>Error</source>
            <translation>误差</translation>
        </message>
        <message>
            <source>Warning</source>
            <translation>警告</translation>
        </message>
        <message>
            <source>Note</source>
            <translation>提示</translation>
        </message>
        <message>
            <source>Severity</source>
            <translation>严重程度</translation>
        </message>
        <message>
            <source>Where</source>
            <translation>位置</translation>
        </message>
        <message>
            <source>Finding</source>
            <translation>检查结果</translation>
        </message>
        <message>
            <source>What to do</source>
            <translation>应对措施</translation>
        </message>
    </context>
    <context>
        <name>FindingsPanel</name>
        <message>
            <source>Findings about the running bus</source>
            <translation>关于运行中总线的检查结果</translation>
        </message>
        <message>
            <source>Nothing found. What the running bus shows to be wrong stands here, with its cause and what to do.</source>
            <translation>没有发现问题。运行中的总线出现问题时，会在此列出其原因和应对措施。</translation>
        </message>
    </context>
    <context>
        <name>Setting</name>
        <message>
            <source>Name</source>
            <translation>名称</translation>
        </message>
        <message>
            <source>Cycle time</source>
            <translation>周期时间</translation>
        </message>
        <message>
            <source>Overlap inputs and outputs</source>
            <translation>输入输出重叠</translation>
        </message>
        <message>
            <source>Bring back lost slaves</source>
            <translation>重新启用恢复的从站</translation>
        </message>
        <message>
            <source>Tries to leave an error state</source>
            <translation>退出错误状态的尝试次数</translation>
        </message>
        <message>
            <source>Start without missing slaves</source>
            <translation>缺少从站时也启动</translation>
        </message>
        <message>
            <source>Distributed clocks</source>
            <translation>分布时钟</translation>
        </message>
        <message>
            <source>Reference clock</source>
            <translation>参考时钟</translation>
        </message>
        <message>
            <source>Show 64-bit system time</source>
            <translation>显示 64 位系统时间</translation>
        </message>
        <message>
            <source>Master synchronisation</source>
            <translation>主站同步</translation>
        </message>
        <message>
            <source>Send to SYNC0</source>
            <translation>发送至 SYNC0</translation>
        </message>
        <message>
            <source>In-sync limit</source>
            <translation>同步限值</translation>
        </message>
        <message>
            <source>Settle time</source>
            <translation>稳定时间</translation>
        </message>
        <message>
            <source>Monitor the sync window</source>
            <translation>监视同步窗口</translation>
        </message>
        <message>
            <source>Limit 2ⁿ − 1</source>
            <translation>限值 2ⁿ − 1</translation>
        </message>
        <message>
            <source>Station address</source>
            <translation>站地址</translation>
        </message>
        <message>
            <source>Alias</source>
            <translation>别名</translation>
        </message>
        <message>
            <source>Vendor</source>
            <translation>供应商</translation>
        </message>
        <message>
            <source>Product code</source>
            <translation>产品代码</translation>
        </message>
        <message>
            <source>Revision</source>
            <translation>版本号</translation>
        </message>
        <message>
            <source>Serial number</source>
            <translation>序列号</translation>
        </message>
        <message>
            <source>Mode</source>
            <translation>模式</translation>
        </message>
        <message>
            <source>Potential reference clock</source>
            <translation>潜在的参考时钟</translation>
        </message>
        <message>
            <source>Sync Unit Cycle</source>
            <translation>同步单元周期</translation>
        </message>
        <message>
            <source>Cycle</source>
            <translation>周期</translation>
        </message>
        <message>
            <source>Shift</source>
            <translation>移位</translation>
        </message>
        <message>
            <source>Error limit</source>
            <translation>错误限值</translation>
        </message>
        <message>
            <source>Type</source>
            <translation>类型</translation>
        </message>
        <message>
            <source>Outputs (RxPDO)</source>
            <translation>输出 (RxPDO)</translation>
        </message>
        <message>
            <source>Inputs (TxPDO)</source>
            <translation>输入 (TxPDO)</translation>
        </message>
        <message>
            <source>First with DC</source>
            <translation>第一个带 DC 的从站</translation>
        </message>
        <message>
            <source>Off (no DC commands)</source>
            <translation>关闭（无 DC 命令）</translation>
        </message>
        <message>
            <source>As operation mode</source>
            <translation>同操作模式</translation>
        </message>
        <message>
            <source>Off</source>
            <translation>关闭</translation>
        </message>
        <message>
            <source>Bus shift</source>
            <translation>总线移位</translation>
        </message>
        <message>
            <source>Master shift</source>
            <translation>主站移位</translation>
        </message>
        <message>
            <source>Master reference clock</source>
            <translation>主站参考时钟</translation>
        </message>
        <message>
            <source>Adapter reference clock</source>
            <translation>网卡参考时钟</translation>
        </message>
        <message>
            <source>External clock (DCX)</source>
            <translation>外部时钟 (DCX)</translation>
        </message>
        <message>
            <source>Master shift by application</source>
            <translation>由应用执行主站移位</translation>
        </message>
        <message>
            <source>Free run</source>
            <translation>自由运行</translation>
        </message>
        <message>
            <source>SM event</source>
            <translation>SM 事件</translation>
        </message>
        <message>
            <source>SYNC0</source>
            <translation>SYNC0</translation>
        </message>
        <message>
            <source>SYNC1</source>
            <translation>SYNC1</translation>
        </message>
        <message>
            <source>Name of the master in the ENI file.</source>
            <translation>ENI 文件中主站的名称。</translation>
        </message>
        <message>
            <source>Time between two cyclic frames.</source>
            <translation>两个循环帧之间的时间。</translation>
        </message>
        <message>
            <source>Inputs and outputs of a slave share logical addresses, which halves the cyclic frame.</source>
            <translation>从站的输入和输出共用逻辑地址，使循环帧减半。</translation>
        </message>
        <message>
            <source>Slaves that come back (cable healed, power back) are set up again and led to the state of the bus.</source>
            <translation>重新出现的从站（电缆恢复、电源恢复） 会重新设置，并切换到总线的状态。</translation>
        </message>
        <message>
            <source>How often an error state is acknowledged and the state requested again; 0 leaves it to the user.</source>
            <translation>确认错误状态并重新请求状态的次数；0 表示由用户处理。</translation>
        </message>
        <message>
            <source>Goes online with the slaves that are there; the others join when they appear.</source>
            <translation>用现有的从站上线；其余从站出现后加入。</translation>
        </message>
        <message>
            <source>Distributed clocks for the whole bus.</source>
            <translation>整个总线的分布时钟。</translation>
        </message>
        <message>
            <source>Position of the slave whose clock all others follow; auto is the first slave with DC.</source>
            <translation>其时钟由所有其他从站跟随的从站的位置；自动表示第一个带 DC 的从站。</translation>
        </message>
        <message>
            <source>Reads and shows 64 bits of the system time (0x0910).</source>
            <translation>读取并显示 64 位系统时间 (0x0910)。</translation>
        </message>
        <message>
            <source>How the send time of the frames and the reference clock are brought together.</source>
            <translation>帧的发送时刻与参考时钟如何对齐。</translation>
        </message>
        <message>
            <source>Distance from sending the cyclic frame to SYNC0; auto is two thirds of the cycle.</source>
            <translation>从发送循环帧到 SYNC0 的间隔；自动表示周期的三分之二。</translation>
        </message>
        <message>
            <source>Largest control error that still counts as in sync; 0 is 4000 ns.</source>
            <translation>仍视为同步的最大控制误差；0 表示 4000 ns。</translation>
        </message>
        <message>
            <source>Time inside that limit before the controller counts as in sync; 0 is 1500 ms.</source>
            <translation>控制器被视为同步之前保持在该限值内的时间；0 表示 1500 ms。</translation>
        </message>
        <message>
            <source>Watches the wire-ored system time difference of all slaves (0x092C).</source>
            <translation>监视所有从站的系统时间差的线或值 (0x092C)。</translation>
        </message>
        <message>
            <source>Limit of the sync window: 2^exponent - 1 ns.</source>
            <translation>同步窗口的限值：2^指数 - 1 ns。</translation>
        </message>
        <message>
            <source>Time inside the window before the bus counts as in sync.</source>
            <translation>总线被视为同步之前保持在窗口内的时间。</translation>
        </message>
        <message>
            <source>Name of the slave in the ENI file.</source>
            <translation>ENI 文件中从站的名称。</translation>
        </message>
        <message>
            <source>Address that the master gives the slave (0x0010).</source>
            <translation>主站赋予从站的地址 (0x0010)。</translation>
        </message>
        <message>
            <source>Address in the slave&apos;s EEPROM (0x0012); 0 is none.</source>
            <translation>从站 EEPROM 中的地址 (0x0012)；0 表示没有。</translation>
        </message>
        <message>
            <source>Compares the vendor in the slave&apos;s EEPROM with the configured one at start-up.</source>
            <translation>启动时将从站 EEPROM 中的供应商与配置值比较。</translation>
        </message>
        <message>
            <source>Compares the product in the slave&apos;s EEPROM with the configured one at start-up.</source>
            <translation>启动时将从站 EEPROM 中的产品代码与配置值比较。</translation>
        </message>
        <message>
            <source>Compares the revision in the slave&apos;s EEPROM with the configured one at start-up.</source>
            <translation>启动时将从站 EEPROM 中的版本号与配置值比较。</translation>
        </message>
        <message>
            <source>Compares the serial in the slave&apos;s EEPROM with the configured one at start-up.</source>
            <translation>启动时将从站 EEPROM 中的序列号与配置值比较。</translation>
        </message>
        <message>
            <source>Operation mode of distributed clocks; where the ESI gives a mode its own PDOs, they are assigned too.</source>
            <translation>分布时钟的操作模式；如果 ESI 为某个模式规定了自己的 PDO，也会一并分配。</translation>
        </message>
        <message>
            <source>Marks the slave as a possible reference clock in the ENI.</source>
            <translation>在 ENI 中将从站标记为可能的参考时钟。</translation>
        </message>
        <message>
            <source>Sync Unit Cycle of SYNC0: above 0 multiplies, below 0 divides the bus cycle; auto as in the ESI.</source>
            <translation>SYNC0 的同步单元周期：大于 0 为总线周期的倍数，小于 0 为其分数；自动同 ESI。</translation>
        </message>
        <message>
            <source>Cycle of SYNC0 (0x09A0), before the factor.</source>
            <translation>乘以系数之前的 SYNC0 周期 (0x09A0)。</translation>
        </message>
        <message>
            <source>Shift of SYNC0; auto as in the ESI.</source>
            <translation>SYNC0 的移位；自动同 ESI。</translation>
        </message>
        <message>
            <source>Sync Unit Cycle of SYNC1: above 0 multiplies, below 0 divides the bus cycle; auto as in the ESI.</source>
            <translation>SYNC1 的同步单元周期：大于 0 为总线周期的倍数，小于 0 为其分数；自动同 ESI。</translation>
        </message>
        <message>
            <source>Cycle of SYNC1 (0x09A4), before the factor.</source>
            <translation>乘以系数之前的 SYNC1 周期 (0x09A4)。</translation>
        </message>
        <message>
            <source>Shift of SYNC1; auto as in the ESI.</source>
            <translation>SYNC1 的移位；自动同 ESI。</translation>
        </message>
        <message>
            <source>Error counter (3 more for a missed SM event, 1 less for a good one) at which the device gives up (0x10F1:02); 0 never, auto leaves the device&apos;s default.</source>
            <translation>设备放弃时的错误计数器值 (0x10F1:02)：每错过一个 SM 事件加 3，每个正常事件减 1；0 表示从不，自动表示保留设备的默认值。</translation>
        </message>
        <message>
            <source>What starts the device&apos;s cycle (0x1C32:01 and 0x1C33:01); auto as the operation mode says.</source>
            <translation>启动设备周期的事件（0x1C32:01 和 0x1C33:01）；自动表示按操作模式。</translation>
        </message>
        <message>
            <source>RxPDOs (outputs) in the order in which they lie in the process data.</source>
            <translation>按过程数据中的顺序排列的 RxPDO（输出）。</translation>
        </message>
        <message>
            <source>TxPDOs (inputs) in the order in which they lie in the process data.</source>
            <translation>按过程数据中的顺序排列的 TxPDO（输入）。</translation>
        </message>
        <message>
            <source>Values</source>
            <translation>取值</translation>
        </message>
        <message>
            <source>Default</source>
            <translation>默认值</translation>
        </message>
        <message>
            <source>Emptied field</source>
            <translation>清空字段时</translation>
        </message>
        <message>
            <source>Goes to</source>
            <translation>写入</translation>
        </message>
        <message>
            <source>Changes</source>
            <translation>更改</translation>
        </message>
        <message>
            <source>Key</source>
            <translation>键</translation>
        </message>
        <message>
            <source>Register %1</source>
            <translation>寄存器 %1</translation>
        </message>
        <message>
            <source>Object %1</source>
            <translation>对象 %1</translation>
        </message>
        <message>
            <source>Destination address</source>
            <translation>目标地址</translation>
        </message>
        <message>
            <source>Destination address of the frames; broadcast unless a switch demands another.</source>
            <translation>帧的目标地址；除非交换机另有要求，否则为广播地址。</translation>
        </message>
        <message>
            <source>Source address</source>
            <translation>源地址</translation>
        </message>
        <message>
            <source>Source address in the ENI file; zeros leave it to the network card.</source>
            <translation>ENI 文件中的源地址；全零表示由网卡决定。</translation>
        </message>
        <message>
            <source>Asking the clock</source>
            <translation>查询时钟</translation>
        </message>
        <message>
            <source>Most of each wait that is spent asking the clock: earlier wake-ups for processor time. Used is what this host needs for 99 of 100 frames to leave at most 2 % of the cycle late, and at most a quarter of the cycle.</source>
            <translation>每次等待中最多用于查询时钟的时间：以处理器时间换取更早的唤醒。实际使用的是此主机使 100 帧中 99 帧的迟发不超过周期 2 % 所需的时间，最多为周期的四分之一。</translation>
        </message>
        <message>
            <source>Processor</source>
            <translation>处理器</translation>
        </message>
        <message>
            <source>Processor that the cyclic thread is bound to; auto leaves it to the system.</source>
            <translation>循环线程绑定的处理器；自动表示由系统决定。</translation>
        </message>
        <message>
            <source>Continuous propagation compensation</source>
            <translation>持续传输延迟补偿</translation>
        </message>
        <message>
            <source>Measures the propagation delays again every 30 s and corrects them in small steps.</source>
            <translation>每 30 s 重新测量传输延迟，并以小步修正。</translation>
        </message>
        <message>
            <source>Burst, frames</source>
            <translation>突发，帧数</translation>
        </message>
        <message>
            <source>Frames of the first drift compensation (FRMW or ARMW of 0x0910).</source>
            <translation>首次漂移补偿的帧数（0x0910 的 FRMW 或 ARMW）。</translation>
        </message>
        <message>
            <source>Burst, frames a cycle</source>
            <translation>突发，每周期帧数</translation>
        </message>
        <message>
            <source>Frames of that burst in one cycle.</source>
            <translation>该突发在一个周期内的帧数。</translation>
        </message>
        <message>
            <source>Burst ends early</source>
            <translation>提前结束突发</translation>
        </message>
        <message>
            <source>The burst ends when all slaves have settled.</source>
            <translation>所有从站都稳定后结束突发。</translation>
        </message>
        <message>
            <source>Lead of the start time</source>
            <translation>起始时间的提前量</translation>
        </message>
        <message>
            <source>Lead of the SYNC start time (0x0990) on the time of writing it.</source>
            <translation>SYNC 起始时间 (0x0990) 相对其写入时刻的提前量。</translation>
        </message>
        <message>
            <source>Grid of the start time</source>
            <translation>起始时间的网格</translation>
        </message>
        <message>
            <source>Start times are multiples of this; 0 is the bus cycle.</source>
            <translation>起始时间为该值的倍数；0 表示总线周期。</translation>
        </message>
        <message>
            <source>First slave leads</source>
            <translation>第一个从站引领</translation>
        </message>
        <message>
            <source>The first slave on the bus that has a system time leads, whatever is configured.</source>
            <translation>无论如何配置，总线上第一个具有系统时间的从站引领。</translation>
        </message>
        <message>
            <source>Synchronise all slaves</source>
            <translation>同步所有从站</translation>
        </message>
        <message>
            <source>Every slave that has a system time is synchronised, with or without a DC operation mode.</source>
            <translation>每个具有系统时间的从站都会同步，无论有无 DC 操作模式。</translation>
        </message>
        <message>
            <source>Delay measurements</source>
            <translation>延迟测量次数</translation>
        </message>
        <message>
            <source>Latches of the receive times (0x0900) whose medians give the propagation delays.</source>
            <translation>接收时间 (0x0900) 的锁存次数，其中位数给出传输延迟。</translation>
        </message>
        <message>
            <source>Delay difference</source>
            <translation>延迟差</translation>
        </message>
        <message>
            <source>Processing minus forwarding latency of the ESCs (tDiff of their data sheets); auto is 40 ns.</source>
            <translation>ESC 的处理延迟减去转发延迟（数据手册中的 tDiff）；自动为 40 ns。</translation>
        </message>
        <message>
            <source>Speed counter start</source>
            <translation>速度计数器起始值</translation>
        </message>
        <message>
            <source>Start value of the slaves&apos; time control loops (0x0930): small ones follow faster, large ones smoother; auto suits the cycle.</source>
            <translation>从站时间控制环的起始值 (0x0930)：小则跟随快，大则更平稳；自动表示与周期相适应。</translation>
        </message>
        <message>
            <source>Filter depth, difference</source>
            <translation>滤波深度，时间差</translation>
        </message>
        <message>
            <source>Exponent of the average over the time differences (0x0934); auto is 0.</source>
            <translation>时间差平均值的指数 (0x0934)；自动为 0。</translation>
        </message>
        <message>
            <source>Filter depth, speed counter</source>
            <translation>滤波深度，速度计数器</translation>
        </message>
        <message>
            <source>Exponent of the average over the clock period deviation (0x0935); auto is 8.</source>
            <translation>时钟周期偏差平均值的指数 (0x0935)；自动为 8。</translation>
        </message>
        <message>
            <source>Tell of the reference clock</source>
            <translation>报告参考时钟</translation>
        </message>
        <message>
            <source>Tells presence and loss of the reference clock.</source>
            <translation>报告参考时钟的出现和丢失。</translation>
        </message>
        <message>
            <source>Tell of slaves in sync</source>
            <translation>报告从站同步</translation>
        </message>
        <message>
            <source>Tells when the slaves come in sync and fall out of it.</source>
            <translation>报告从站进入同步和失步的时刻。</translation>
        </message>
        <message>
            <source>Tell of the clocks&apos; state</source>
            <translation>报告时钟状态</translation>
        </message>
        <message>
            <source>Tells that the distributed clocks are initialised, or why not.</source>
            <translation>报告分布时钟已初始化，或未能初始化的原因。</translation>
        </message>
        <message>
            <source>Tell of the master in sync</source>
            <translation>报告主站同步</translation>
        </message>
        <message>
            <source>Tells when the master comes in sync and falls out of it.</source>
            <translation>报告主站进入同步和失步的时刻。</translation>
        </message>
        <message>
            <source>Gain</source>
            <translation>增益</translation>
        </message>
        <message>
            <source>Share of the control error that one cycle corrects while in sync (nCtlGain), in thousandths; 0 is 2.</source>
            <translation>同步时一个周期修正的控制误差份额 (nCtlGain)，以千分之一计；0 表示 2。</translation>
        </message>
        <message>
            <source>Drift error gain</source>
            <translation>漂移误差增益</translation>
        </message>
        <message>
            <source>Multiplies the integral gain (nCtlDriftErrorGain): more follows a changing drift faster and lets more noise through; 0 is 3.</source>
            <translation>积分增益的倍数 (nCtlDriftErrorGain)：越大越能更快跟随变化的漂移，但也引入更多噪声；0 表示 3。</translation>
        </message>
        <message>
            <source>Valid readings</source>
            <translation>有效读数</translation>
        </message>
        <message>
            <source>Readings further than this from what is expected are invalid (nMaxValidVal); 0 is 3000 ns.</source>
            <translation>与期望值相差超过此值的读数无效 (nMaxValidVal)；0 表示 3000 ns。</translation>
        </message>
        <message>
            <source>Start delay</source>
            <translation>启动延迟</translation>
        </message>
        <message>
            <source>Wait before the control error is judged.</source>
            <translation>开始评判控制误差之前的等待时间。</translation>
        </message>
        <message>
            <source>Control off</source>
            <translation>控制关闭</translation>
        </message>
        <message>
            <source>Nothing is moved, so that the natural drift and the adjustment that would be made can be read (bCtlOff).</source>
            <translation>不做任何移动，以便读取自然漂移和本应进行的调整量 (bCtlOff)。</translation>
        </message>
        <message>
            <source>Standard loop values</source>
            <translation>标准环参数</translation>
        </message>
        <message>
            <source>Leaves the time control loops of the slaves (0x0930, 0x0934) at the values of their reset.</source>
            <translation>使从站的时间控制环 (0x0930、0x0934) 保持复位值。</translation>
        </message>
        <message>
            <source>Controller log</source>
            <translation>控制器日志</translation>
        </message>
        <message>
            <source>Keeps the log of the controller, one line a cycle (bLogEnabled).</source>
            <translation>记录控制器的日志，每周期一行 (bLogEnabled)。</translation>
        </message>
        <message>
            <source>Network</source>
            <translation>网络</translation>
        </message>
        <message>
            <source>Name of this network, where a machine has several (--network).</source>
            <translation>机器有多个网络时此网络的名称 (--network)。</translation>
        </message>
        <message>
            <source>Logical start address</source>
            <translation>逻辑起始地址</translation>
        </message>
        <message>
            <source>Logical address of the first process data; auto as the dialect&apos;s tool.</source>
            <translation>第一个过程数据的逻辑地址；自动同该方言的工具。</translation>
        </message>
        <message>
            <source>Alignment</source>
            <translation>对齐</translation>
        </message>
        <message>
            <source>The data of each slave begin at a multiple of so many bytes in the process image.</source>
            <translation>每个从站的数据在过程映像中从此字节数的倍数处开始。</translation>
        </message>
        <message>
            <source>Bit packing</source>
            <translation>按位紧凑排列</translation>
        </message>
        <message>
            <source>Digital terminals are mapped bit by bit and may share bytes; off gives each whole bytes.</source>
            <translation>数字量端子模块按位映射并可共用字节；关闭则各占整字节。</translation>
        </message>
        <message>
            <source>Connected to</source>
            <translation>连接到</translation>
        </message>
        <message>
            <source>Where the slave is plugged in towards the master. One behind it only when that one&apos;s cables are swapped.</source>
            <translation>从站朝向主站的插接处。只有当该从站的电缆接反时，才会是其后面的从站。</translation>
        </message>
        <message>
            <source>Hot-connect group</source>
            <translation>热连接组</translation>
        </message>
        <message>
            <source>This slave and those behind it may be absent and be plugged in anywhere, known by this slave&apos;s alias.</source>
            <translation>此从站及其后面的从站可以不在，也可以接在任意位置，通过此从站的别名识别。</translation>
        </message>
        <message>
            <source>Optional</source>
            <translation>可选</translation>
        </message>
        <message>
            <source>The slave may be missing; it is known by its device ID or alias, and the others run without it.</source>
            <translation>此从站可以缺少；通过其设备标识或别名识别，其他从站没有它也能运行。</translation>
        </message>
        <message>
            <source>Revision rule</source>
            <translation>版本规则</translation>
        </message>
        <message>
            <source>How check.revision compares (ETG.2000 CheckRevisionNo): LW and HW are the low and high words, G is newer; auto as in the ESI.</source>
            <translation>check.revision 的比较方式 (ETG.2000 CheckRevisionNo)：LW 和 HW 为低字和高字，G 为更新；自动同 ESI。</translation>
        </message>
        <message>
            <source>Compares the alias in the slave (0x0012) with the configured one at start-up.</source>
            <translation>启动时将从站中的别名 (0x0012) 与配置值比较。</translation>
        </message>
        <message>
            <source>Device ID</source>
            <translation>设备标识</translation>
        </message>
        <message>
            <source>Explicit device ID (switches or display of the device, ETG.1020) that is compared at start-up.</source>
            <translation>启动时比较的显式设备标识（设备的拨码开关或显示，ETG.1020）。</translation>
        </message>
        <message>
            <source>Watchdog divider</source>
            <translation>看门狗分频器</translation>
        </message>
        <message>
            <source>Watchdog divider (0x0400): unit of the watchdogs is (value + 2) * 40 ns; auto as in the ESI.</source>
            <translation>看门狗分频器 (0x0400)：看门狗的单位为 (值 + 2) * 40 ns；自动同 ESI。</translation>
        </message>
        <message>
            <source>PDI watchdog</source>
            <translation>PDI 看门狗</translation>
        </message>
        <message>
            <source>PDI watchdog (0x0410) in units of the divider; 0 switches it off; auto as in the ESI.</source>
            <translation>PDI 看门狗 (0x0410)，以分频器为单位；0 表示关闭；自动同 ESI。</translation>
        </message>
        <message>
            <source>Process data watchdog</source>
            <translation>过程数据看门狗</translation>
        </message>
        <message>
            <source>Process data watchdog (0x0420) in units of the divider; 0 switches it off; auto as in the ESI.</source>
            <translation>过程数据看门狗 (0x0420)，以分频器为单位；0 表示关闭；自动同 ESI。</translation>
        </message>
        <message>
            <source>Outputs trigger the watchdog</source>
            <translation>输出触发看门狗</translation>
        </message>
        <message>
            <source>Outputs trigger the process data watchdog (control byte of their SyncManagers, bit 6); auto as in the ESI.</source>
            <translation>输出触发过程数据看门狗（其同步管理器控制字节的第 6 位）；自动同 ESI。</translation>
        </message>
        <message>
            <source>INIT to PREOP</source>
            <translation>INIT 到 PREOP</translation>
        </message>
        <message>
            <source>Time-out for INIT to PREOP or BOOT; auto as in the ESI.</source>
            <translation>INIT 到 PREOP 或 BOOT 的超时；自动同 ESI。</translation>
        </message>
        <message>
            <source>PREOP to SAFEOP to OP</source>
            <translation>PREOP 到 SAFEOP 到 OP</translation>
        </message>
        <message>
            <source>Time-out for PREOP to SAFEOP and SAFEOP to OP; auto as in the ESI.</source>
            <translation>PREOP 到 SAFEOP 以及 SAFEOP 到 OP 的超时；自动同 ESI。</translation>
        </message>
        <message>
            <source>Back to INIT</source>
            <translation>返回 INIT</translation>
        </message>
        <message>
            <source>Time-out for the way back to INIT; auto as in the ESI.</source>
            <translation>返回 INIT 的超时；自动同 ESI。</translation>
        </message>
        <message>
            <source>Back to SAFEOP</source>
            <translation>返回 SAFEOP</translation>
        </message>
        <message>
            <source>Time-out for OP to SAFEOP; auto as in the ESI.</source>
            <translation>OP 到 SAFEOP 的超时；自动同 ESI。</translation>
        </message>
        <message>
            <source>Mailbox request</source>
            <translation>邮箱请求</translation>
        </message>
        <message>
            <source>Time-out for the slave to take a mailbox request; auto as in the ESI.</source>
            <translation>从站接收邮箱请求的超时；自动同 ESI。</translation>
        </message>
        <message>
            <source>Mailbox response</source>
            <translation>邮箱应答</translation>
        </message>
        <message>
            <source>Time-out for the slave to answer a mailbox request; auto as in the ESI.</source>
            <translation>从站应答邮箱请求的超时；自动同 ESI。</translation>
        </message>
        <message>
            <source>Output mailbox</source>
            <translation>输出邮箱</translation>
        </message>
        <message>
            <source>Size of the output mailbox; auto as in the ESI.</source>
            <translation>输出邮箱的大小；自动同 ESI。</translation>
        </message>
        <message>
            <source>Input mailbox</source>
            <translation>输入邮箱</translation>
        </message>
        <message>
            <source>Size of the input mailbox; auto as in the ESI.</source>
            <translation>输入邮箱的大小；自动同 ESI。</translation>
        </message>
        <message>
            <source>Mailbox state by a bit</source>
            <translation>用位表示邮箱状态</translation>
        </message>
        <message>
            <source>The master learns of mail by a bit in the cyclic frames, where the device has an FMMU for it; off: it polls.</source>
            <translation>设备有相应的 FMMU 时，主站通过循环帧中的一个位得知邮件；关闭则轮询。</translation>
        </message>
        <message>
            <source>Poll time</source>
            <translation>轮询时间</translation>
        </message>
        <message>
            <source>How often the mailbox is polled; auto as the dialect&apos;s tool.</source>
            <translation>轮询邮箱的间隔；自动同该方言的工具。</translation>
        </message>
        <message>
            <source>Ethernet (EoE)</source>
            <translation>以太网 (EoE)</translation>
        </message>
        <message>
            <source>Ethernet frames are passed to and from the slave (EoE).</source>
            <translation>与从站之间转发以太网帧 (EoE)。</translation>
        </message>
        <message>
            <source>Ethernet address</source>
            <translation>以太网地址</translation>
        </message>
        <message>
            <source>Ethernet address that the slave gets at start-up (EoE).</source>
            <translation>从站启动时获得的以太网地址 (EoE)。</translation>
        </message>
        <message>
            <source>IP address</source>
            <translation>IP 地址</translation>
        </message>
        <message>
            <source>IP address that the slave gets at start-up (EoE).</source>
            <translation>从站启动时获得的 IP 地址 (EoE)。</translation>
        </message>
        <message>
            <source>Subnet mask</source>
            <translation>子网掩码</translation>
        </message>
        <message>
            <source>Subnet mask that the slave gets at start-up (EoE).</source>
            <translation>从站启动时获得的子网掩码 (EoE)。</translation>
        </message>
        <message>
            <source>Default gateway</source>
            <translation>默认网关</translation>
        </message>
        <message>
            <source>Default gateway that the slave gets at start-up (EoE).</source>
            <translation>从站启动时获得的默认网关 (EoE)。</translation>
        </message>
        <message>
            <source>Name server</source>
            <translation>域名服务器</translation>
        </message>
        <message>
            <source>Name server that the slave gets at start-up (EoE).</source>
            <translation>从站启动时获得的域名服务器 (EoE)。</translation>
        </message>
        <message>
            <source>Host name</source>
            <translation>主机名</translation>
        </message>
        <message>
            <source>Host name that the slave gets at start-up (EoE).</source>
            <translation>从站启动时获得的主机名 (EoE)。</translation>
        </message>
        <message>
            <source>AMS Net ID</source>
            <translation>AMS Net ID</translation>
        </message>
        <message>
            <source>AMS Net ID of the slave (AoE).</source>
            <translation>从站的 AMS Net ID (AoE)。</translation>
        </message>
        <message>
            <source>Sync Unit of the outputs</source>
            <translation>输出的同步单元</translation>
        </message>
        <message>
            <source>Sync Unit that exchanges the outputs; nothing for the unnamed one in the base task.</source>
            <translation>交换输出的同步单元；留空表示基本任务中的未命名单元。</translation>
        </message>
        <message>
            <source>Sync Unit of the inputs</source>
            <translation>输入的同步单元</translation>
        </message>
        <message>
            <source>Sync Unit that exchanges the inputs; nothing for the unnamed one in the base task.</source>
            <translation>交换输入的同步单元；留空表示基本任务中的未命名单元。</translation>
        </message>
        <message>
            <source>Input shift</source>
            <translation>输入移位</translation>
        </message>
        <message>
            <source>From the trigger to latching the inputs (0x1C33:03); auto as the operation mode says.</source>
            <translation>从触发到锁存输入的时间 (0x1C33:03)；自动表示按操作模式。</translation>
        </message>
        <message>
            <source>CAN cycle</source>
            <translation>CAN 周期</translation>
        </message>
        <message>
            <source>CAN cycle of a gateway (EL6751 0xF800:04), a multiple of the bus cycle; without SYNC0 the gateway is told the bus cycle, too. 0 is one CAN cycle a bus cycle, auto leaves the device&apos;s default.</source>
            <translation>网关的 CAN 周期 (EL6751 0xF800:04)，为总线周期的倍数；没有 SYNC0 时也会将总线周期告知网关。0 表示每个总线周期一个 CAN 周期，自动表示保留设备的默认值。</translation>
        </message>
        <message>
            <source>TxPDO delay</source>
            <translation>TxPDO 延迟</translation>
        </message>
        <message>
            <source>From the CAN SYNC message of a gateway to its first synchronous RxPDO (EL6751 0xF800:0E), in % of the CAN cycle.</source>
            <translation>从网关的 CAN SYNC 报文到其第一个同步 RxPDO 的时间 (EL6751 0xF800:0E)，以 CAN 周期的 % 计。</translation>
        </message>
        <message>
            <source>Output pin</source>
            <translation>输出引脚</translation>
        </message>
        <message>
            <source>What output pin K (from 1) of a drive shows on an oscilloscope (Copley 0x2193); auto leaves it alone.</source>
            <translation>驱动器的输出引脚 K（从 1 起） 在示波器上显示的内容 (Copley 0x2193)；自动表示不作更改。</translation>
        </message>
        <message>
            <source>Module</source>
            <translation>模块</translation>
        </message>
        <message>
            <source>Module in place K of a modular device, counted from 0; its PDOs and start-up commands come with it.</source>
            <translation>模块化设备位置 K 上的模块，从 0 起计；其 PDO 和启动命令随之而来。</translation>
        </message>
        <message>
            <source>Oversampling</source>
            <translation>过采样</translation>
        </message>
        <message>
            <source>How many samples of PDO 0xIIII a cycle carries; auto as the operation mode says.</source>
            <translation>PDO 0xIIII 每个周期携带的采样数；自动表示按操作模式。</translation>
        </message>
        <message>
            <source>Variable</source>
            <translation>变量</translation>
        </message>
        <message>
            <source>Name of the variable for entry K of PDO 0xIIII in the process image; nothing for SLAVE.PDO.ENTRY.</source>
            <translation>PDO 0xIIII 的条目 K 在过程映像中的变量名称；留空表示 SLAVE.PDO.ENTRY。</translation>
        </message>
        <message>
            <source>auto</source>
            <translation>自动</translation>
        </message>
        <message>
            <source>none</source>
            <translation>无</translation>
        </message>
        <message>
            <source>on</source>
            <translation>开</translation>
        </message>
        <message>
            <source>off</source>
            <translation>关</translation>
        </message>
        <message>
            <source>None (base task)</source>
            <translation>无（基本任务）</translation>
        </message>
        <message>
            <source>Expert setting: few machines need it</source>
            <translation>专家设置：少数机器才需要</translation>
        </message>
        <message>
            <source>frames</source>
            <translation>帧</translation>
        </message>
        <message>
            <source>bytes</source>
            <translation>字节</translation>
        </message>
        <message>
            <source>Task</source>
            <translation>任务</translation>
        </message>
        <message>
            <source>A task beside the base task, whose frames are sent in every MULTIPLE-th cycle; K counts from 0, the number behind the last adds one.</source>
            <translation>基本任务之外的任务，其帧每 MULTIPLE 个周期发送一次；K 从 0 起计，比最后一个大一的编号表示新增。</translation>
        </message>
        <message>
            <source>Sync Unit</source>
            <translation>同步单元</translation>
        </message>
        <message>
            <source>Slaves that are exchanged together in datagrams of their own, in the base task or in TASK; K counts from 0, the number behind the last adds one.</source>
            <translation>在基本任务或 TASK 中用各自的数据报一起交换的从站；K 从 0 起计，比最后一个大一的编号表示新增。</translation>
        </message>
        <message>
            <source>Mapping</source>
            <translation>映射</translation>
        </message>
        <message>
            <source>What PDO 0xIIII carries. Only PDOs that are not fixed can be changed.</source>
            <translation>PDO 0xIIII 携带的内容。只有非固定的 PDO 可以更改。</translation>
        </message>
        <message>
            <source>Start-up command</source>
            <translation>启动命令</translation>
        </message>
        <message>
            <source>CoE object that is written at these transitions, K counts from 0; the number behind the last adds one.</source>
            <translation>在这些状态切换时写入的 CoE 对象，K 从 0 起计；比最后一个大一的编号表示新增。</translation>
        </message>
        <message>
            <source>SoE start-up command</source>
            <translation>SoE 启动命令</translation>
        </message>
        <message>
            <source>IDN that is written at these transitions, K counts from 0; the number behind the last adds one.</source>
            <translation>在这些状态切换时写入的 IDN，K 从 0 起计；比最后一个大一的编号表示新增。</translation>
        </message>
    </context>
    <context>
        <name>FieldBinder</name>
        <message>
            <source>Change: %1</source>
            <translation>更改：%1</translation>
        </message>
        <message>
            <source>%1 (Expert)</source>
            <translation>%1（专家）</translation>
        </message>
        <message>
            <source>Finding: %1</source>
            <translation>检查结果：%1</translation>
        </message>
    </context>
    <context>
        <name>NumberEdit</name>
        <message>
            <source>&quot;%1&quot; is no such number: %2</source>
            <translation>“%1”不是有效的数：%2</translation>
        </message>
    </context>
    <context>
        <name>PresetEdit</name>
        <message>
            <source>&quot;%1&quot; is no such number: %2 %3</source>
            <translation>“%1”不是有效的数：%2 %3</translation>
        </message>
    </context>
    <context>
        <name>MasterDcExpertPage</name>
        <message>
            <source>Distributed Clocks (Expert)</source>
            <translation>分布时钟（专家）</translation>
        </message>
        <message>
            <source>Clocks and Delays</source>
            <translation>时钟与延迟</translation>
        </message>
        <message>
            <source>Burst and Start Time</source>
            <translation>突发与起始时间</translation>
        </message>
        <message>
            <source>Controller (DCM)</source>
            <translation>控制器 (DCM)</translation>
        </message>
        <message>
            <source>Control Loops of the Slaves</source>
            <translation>从站的控制环</translation>
        </message>
        <message>
            <source>Messages of the Clocks</source>
            <translation>时钟的消息</translation>
        </message>
    </context>
    <context>
        <name>SlaveTimingPage</name>
        <message>
            <source>Watchdogs (Expert)</source>
            <translation>看门狗（专家）</translation>
        </message>
        <message>
            <source>Watchdogs</source>
            <translation>看门狗</translation>
        </message>
        <message>
            <source>Time-outs of State Changes</source>
            <translation>状态切换的超时</translation>
        </message>
    </context>
    <context>
        <name>SlaveMailboxPage</name>
        <message>
            <source>Mailbox</source>
            <translation>邮箱</translation>
        </message>
        <message>
            <source>Ethernet (EoE)</source>
            <translation>以太网 (EoE)</translation>
        </message>
        <message>
            <source>ADS (AoE)</source>
            <translation>ADS (AoE)</translation>
        </message>
    </context>
    <context>
        <name>SlaveDataPage</name>
        <message>
            <source>Data Options</source>
            <translation>数据选项</translation>
        </message>
        <message>
            <source>Modules</source>
            <translation>模块</translation>
        </message>
        <message>
            <source>Oversampling</source>
            <translation>过采样</translation>
        </message>
        <message>
            <source>Sync Units</source>
            <translation>同步单元</translation>
        </message>
    </context>
    <context>
        <name>Questions</name>
        <message>
            <source>The machine is running. Take it offline?</source>
            <translation>机器正在运行。要下线吗？</translation>
        </message>
        <message>
            <source>All slaves go to INIT.</source>
            <translation>所有从站切换到 INIT。</translation>
        </message>
        <message>
            <source>Go Offline</source>
            <translation>下线</translation>
        </message>
    </context>
    <context>
        <name>SlaveStartupPage</name>
        <message>
            <source>INIT to PREOP</source>
            <translation>INIT 到 PREOP</translation>
        </message>
        <message>
            <source>PREOP to SAFEOP</source>
            <translation>PREOP 到 SAFEOP</translation>
        </message>
        <message>
            <source>SAFEOP to OP</source>
            <translation>SAFEOP 到 OP</translation>
        </message>
        <message>
            <source>INIT to BOOT</source>
            <translation>INIT 到 BOOT</translation>
        </message>
        <message>
            <source>PREOP again</source>
            <translation>再次 PREOP</translation>
        </message>
        <message>
            <source>OP to SAFEOP</source>
            <translation>OP 到 SAFEOP</translation>
        </message>
        <message>
            <source>OP to PREOP</source>
            <translation>OP 到 PREOP</translation>
        </message>
        <message>
            <source>SAFEOP to PREOP</source>
            <translation>SAFEOP 到 PREOP</translation>
        </message>
        <message>
            <source>SAFEOP to INIT</source>
            <translation>SAFEOP 到 INIT</translation>
        </message>
        <message>
            <source>PREOP to INIT</source>
            <translation>PREOP 到 INIT</translation>
        </message>
        <message>
            <source>Transitions</source>
            <translation>状态切换</translation>
        </message>
        <message>
            <source>State changes at which the command is sent (ENI InitCmd/Transition)</source>
            <translation>发送该命令的状态切换 (ENI InitCmd/Transition)</translation>
        </message>
        <message>
            <source>Time-out</source>
            <translation>超时</translation>
        </message>
        <message>
            <source>ms for the answer; empty: the master&apos;s own (ENI InitCmd/Timeout)</source>
            <translation>等待应答的 ms 数；留空：使用主站的值 (ENI InitCmd/Timeout)</translation>
        </message>
        <message>
            <source>a time-out is a whole number of ms</source>
            <translation>超时须为整数 ms</translation>
        </message>
        <message>
            <source>Comment</source>
            <translation>注释</translation>
        </message>
        <message>
            <source>Beside the command in the ENI (InitCmd/Comment)</source>
            <translation>ENI 中命令旁的注释 (InitCmd/Comment)</translation>
        </message>
        <message>
            <source>&quot;%1&quot; is no object like 0x6060:00</source>
            <translation>“%1”不是 0x6060:00 形式的对象</translation>
        </message>
        <message>
            <source>Value</source>
            <translation>值</translation>
        </message>
        <message>
            <source>Decimal, or hexadecimal with 0x; bytes in the order of the wire (ENI InitCmd/Data)</source>
            <translation>十进制，或以 0x 开头的十六进制；字节按线上顺序 (ENI InitCmd/Data)</translation>
        </message>
        <message>
            <source>&quot;%1&quot; is no IDN like S-0-0047</source>
            <translation>“%1”不是 S-0-0047 形式的 IDN</translation>
        </message>
        <message>
            <source>drives count from 0 to 7</source>
            <translation>驱动器编号为 0 至 7</translation>
        </message>
        <message>
            <source>Enabled</source>
            <translation>启用</translation>
        </message>
        <message>
            <source>Off: the command is kept, but not sent</source>
            <translation>关闭：保留该命令，但不发送</translation>
        </message>
        <message>
            <source>Object</source>
            <translation>对象</translation>
        </message>
        <message>
            <source>Index and sub-index, hexadecimal: 0x6060:00 (ENI InitCmd/Index and SubIndex)</source>
            <translation>索引和子索引，十六进制：0x6060:00（ENI InitCmd/Index 和 SubIndex）</translation>
        </message>
        <message>
            <source>Complete access</source>
            <translation>完全访问</translation>
        </message>
        <message>
            <source>The value is the whole object, from sub-index 0 or 1 on (ENI InitCmd@CompleteAccess)</source>
            <translation>该值为整个对象，从子索引 0 或 1 起 (ENI InitCmd@CompleteAccess)</translation>
        </message>
        <message>
            <source>Fixed</source>
            <translation>固定</translation>
        </message>
        <message>
            <source>The device needs the command as it is (ENI InitCmd@Fixed)</source>
            <translation>设备要求该命令保持原样 (ENI InitCmd@Fixed)</translation>
        </message>
        <message>
            <source>Adapt automatically</source>
            <translation>自动适配</translation>
        </message>
        <message>
            <source>The value follows another setting, such as the cycle time (ESI InitCmd@AdaptAutomatically)</source>
            <translation>该值跟随另一项设置，例如周期时间 (ESI InitCmd@AdaptAutomatically)</translation>
        </message>
        <message>
            <source>Drive</source>
            <translation>驱动器</translation>
        </message>
        <message>
            <source>Drive of the device, 0 to 7 (ENI InitCmd/DriveNo)</source>
            <translation>设备的驱动器，0 至 7 (ENI InitCmd/DriveNo)</translation>
        </message>
        <message>
            <source>IDN</source>
            <translation>IDN</translation>
        </message>
        <message>
            <source>Standard or product parameter: S-0-0047, P-0-0100 (ENI InitCmd/IDN)</source>
            <translation>标准参数或产品参数：S-0-0047、P-0-0100 (ENI InitCmd/IDN)</translation>
        </message>
        <message>
            <source>Bytes in hexadecimal, in the order of the wire (ENI InitCmd/Data)</source>
            <translation>十六进制字节，按线上顺序 (ENI InitCmd/Data)</translation>
        </message>
        <message>
            <source>Start-up</source>
            <translation>启动</translation>
        </message>
        <message>
            <source>start-up command</source>
            <translation>启动命令</translation>
        </message>
        <message>
            <source>SoE start-up command</source>
            <translation>SoE 启动命令</translation>
        </message>
        <message>
            <source>Objects (CoE)</source>
            <translation>对象 (CoE)</translation>
        </message>
        <message>
            <source>Parameters (SoE)</source>
            <translation>参数 (SoE)</translation>
        </message>
        <message>
            <source>Data type</source>
            <translation>数据类型</translation>
        </message>
        <message>
            <source>As what the value is written; the command holds its bytes</source>
            <translation>写入该值所用的类型；命令中保存其字节</translation>
        </message>
        <message>
            <source>Choose Object…</source>
            <translation>选择对象…</translation>
        </message>
        <message>
            <source>Choose an object of the device</source>
            <translation>选择设备的对象</translation>
        </message>
        <message>
            <source>As described (%1)</source>
            <translation>按描述 (%1)</translation>
        </message>
        <message>
            <source>None: the slave starts with what it has.</source>
            <translation>无：从站按其已有的值启动。</translation>
        </message>
    </context>
    <context>
        <name>DifferenceDialog</name>
        <message>
            <source>Project and Running Machine</source>
            <translation>项目与运行中的机器</translation>
        </message>
        <message>
            <source>The machine runs on as it was started. A double click goes to the field.</source>
            <translation>机器仍按启动时的配置运行。双击可转到相应字段。</translation>
        </message>
        <message>
            <source>Runs</source>
            <translation>运行中</translation>
        </message>
        <message>
            <source>Project</source>
            <translation>项目</translation>
        </message>
        <message>
            <source>Differences between project and running machine</source>
            <translation>项目与运行中机器的差异</translation>
        </message>
    </context>
    <context>
        <name>DifferenceModel</name>
        <message>
            <source>Where</source>
            <translation>位置</translation>
        </message>
        <message>
            <source>What</source>
            <translation>内容</translation>
        </message>
    </context>
    <context>
        <name>FoundDialog</name>
        <message numerus="yes">
            <source>%n match(es)</source>
            <translation>
                <numerusform>%n 个一致</numerusform>
            </translation>
        </message>
        <message numerus="yes">
            <source>%n additional</source>
            <translation>
                <numerusform>%n 个多出</numerusform>
            </translation>
        </message>
        <message numerus="yes">
            <source>%n missing</source>
            <translation>
                <numerusform>%n 个缺少</numerusform>
            </translation>
        </message>
        <message numerus="yes">
            <source>%n moved</source>
            <translation>
                <numerusform>%n 个位置改变</numerusform>
            </translation>
        </message>
        <message numerus="yes">
            <source>%n wired otherwise</source>
            <translation>
                <numerusform>%n 个接线不同</numerusform>
            </translation>
        </message>
        <message numerus="yes">
            <source>%n in another revision</source>
            <translation>
                <numerusform>%n 个版本不同</numerusform>
            </translation>
        </message>
        <message numerus="yes">
            <source>%n other device(s)</source>
            <translation>
                <numerusform>%n 个其他设备</numerusform>
            </translation>
        </message>
        <message>
            <source>The bus on %1 beside the project: %2.</source>
            <translation>%1 上的总线与项目相比：%2。</translation>
        </message>
        <message>
            <source>Scan Result</source>
            <translation>扫描结果</translation>
        </message>
        <message numerus="yes">
            <source>%n slave(s) of this bus are running. They were only looked at and nothing was written, so some of what they are may not be known.</source>
            <translation>
                <numerusform>此总线有 %n 个从站正在运行。只对其进行了查看，没有写入任何内容，因此其部分信息可能未知。</numerusform>
            </translation>
        </message>
        <message>
            <source>Scan &amp;Fully…</source>
            <translation>完整扫描(&amp;F)…</translation>
        </message>
        <message>
            <source>Scan fully</source>
            <translation>完整扫描</translation>
        </message>
        <message>
            <source>Touch the running machine?</source>
            <translation>要影响运行中的机器吗？</translation>
        </message>
        <message>
            <source>States stay as they are. EEPROMs are taken from their devices while they are read, the receive times of all slaves are latched, and slaves without a description are asked in PREOP.</source>
            <translation>状态保持不变。读取期间将从设备收回 EEPROM，锁存所有从站的接收时间，并在 PREOP 中查询没有描述的从站。</translation>
        </message>
        <message>
            <source>Scan Fully</source>
            <translation>完整扫描</translation>
        </message>
        <message>
            <source>Slaves in the project and on the bus</source>
            <translation>项目中和总线上的从站</translation>
        </message>
        <message>
            <source>&amp;Take Over Ticked</source>
            <translation>采纳勾选项(&amp;T)</translation>
        </message>
        <message>
            <source>Take over what is ticked</source>
            <translation>采纳勾选的内容</translation>
        </message>
        <message>
            <source>&amp;Replace Project…</source>
            <translation>替换项目(&amp;R)…</translation>
        </message>
        <message>
            <source>Replace the project</source>
            <translation>替换项目</translation>
        </message>
        <message>
            <source>A new project of the bus with the defaults of its devices; all settings go</source>
            <translation>按总线新建项目，采用设备的默认值；所有设置都会丢失</translation>
        </message>
        <message>
            <source>&amp;Keep Project</source>
            <translation>保留项目(&amp;K)</translation>
        </message>
        <message>
            <source>Keep the project</source>
            <translation>保留项目</translation>
        </message>
        <message>
            <source>The other revision does not take these settings: %1</source>
            <translation>另一版本不接受这些设置：%1</translation>
        </message>
        <message>
            <source>Replace the whole project?</source>
            <translation>要替换整个项目吗？</translation>
        </message>
        <message>
            <source>Its settings go; Undo brings them back.</source>
            <translation>其设置会丢失；可用“撤销”恢复。</translation>
        </message>
        <message>
            <source>Replace</source>
            <translation>替换</translation>
        </message>
    </context>
    <context>
        <name>FoundModel</name>
        <message>
            <source>Matches</source>
            <translation>一致</translation>
        </message>
        <message>
            <source>Wired otherwise</source>
            <translation>接线不同</translation>
        </message>
        <message>
            <source>Moved</source>
            <translation>位置改变</translation>
        </message>
        <message>
            <source>Other revision</source>
            <translation>其他版本</translation>
        </message>
        <message>
            <source>Other device</source>
            <translation>其他设备</translation>
        </message>
        <message>
            <source>Missing</source>
            <translation>缺少</translation>
        </message>
        <message>
            <source>Additional</source>
            <translation>多出</translation>
        </message>
        <message>
            <source>the master</source>
            <translation>主站</translation>
        </message>
        <message>
            <source>slave %1, port %2</source>
            <translation>从站 %1，端口 %2</translation>
        </message>
        <message>
            <source>Connected to %1 instead of %2</source>
            <translation>连接到 %1 而不是 %2</translation>
        </message>
        <message>
            <source>Position %1 instead of %2</source>
            <translation>位置为 %1 而不是 %2</translation>
        </message>
        <message>
            <source>Revision %1 instead of %2</source>
            <translation>版本号为 %1 而不是 %2</translation>
        </message>
        <message>
            <source>%1 instead of %2</source>
            <translation>%1 而不是 %2</translation>
        </message>
        <message>
            <source>Not on the bus; ticked: goes out of the project</source>
            <translation>总线上没有；勾选：从项目中移除</translation>
        </message>
        <message>
            <source>Not in the project; ticked: comes in</source>
            <translation>项目中没有；勾选：加入项目</translation>
        </message>
        <message>
            <source>Take over</source>
            <translation>采纳</translation>
        </message>
        <message>
            <source>In the project</source>
            <translation>项目中</translation>
        </message>
        <message>
            <source>On the bus</source>
            <translation>总线上</translation>
        </message>
        <message>
            <source>Difference</source>
            <translation>差异</translation>
        </message>
    </context>
    <context>
        <name>ImportCommands</name>
        <message>
            <source>Open</source>
            <translation>打开</translation>
        </message>
        <message>
            <source>The ENI could not be read.</source>
            <translation>无法读取 ENI。</translation>
        </message>
        <message numerus="yes">
            <source>A project was made of %1; exported again, %n command(s) would differ.</source>
            <translation>
                <numerusform>已由 %1 建立项目；再次导出时会有 %n 条命令不同。</numerusform>
            </translation>
        </message>
        <message>
            <source>Add the folder of this device description to the catalogue?</source>
            <translation>将此设备描述所在的文件夹加入目录？</translation>
        </message>
        <message>
            <source>All ESI files below %1 are read; scans then know their devices.</source>
            <translation>将读取 %1 下的所有 ESI 文件；之后扫描即可识别其中的设备。</translation>
        </message>
        <message>
            <source>Add Folder</source>
            <translation>添加文件夹</translation>
        </message>
        <message>
            <source>Catalogue</source>
            <translation>目录</translation>
        </message>
        <message>
            <source>Reading the ESI files below %1 …</source>
            <translation>正在读取 %1 下的 ESI 文件…</translation>
        </message>
        <message>
            <source>The folder could not be read.</source>
            <translation>无法读取该文件夹。</translation>
        </message>
        <message numerus="yes">
            <source>%n new device(s) of %1 are in the catalogue.</source>
            <translation>
                <numerusform>目录中有来自 %1 的 %n 个新设备。</numerusform>
            </translation>
        </message>
    </context>
    <context>
        <name>MasterTasksPage</name>
        <message>
            <source>Tasks (Expert)</source>
            <translation>任务（专家）</translation>
        </message>
        <message>
            <source>Task</source>
            <translation>任务</translation>
        </message>
        <message>
            <source>Name of the task (ENI Cyclic)</source>
            <translation>任务的名称 (ENI Cyclic)</translation>
        </message>
        <message>
            <source>Bus cycles</source>
            <translation>总线周期</translation>
        </message>
        <message>
            <source>Its frames are sent in every so many-th bus cycle, 1 to 1000</source>
            <translation>其帧每隔多少个总线周期发送一次，1 至 1000</translation>
        </message>
        <message>
            <source>Cycle</source>
            <translation>周期</translation>
        </message>
        <message>
            <source>Tasks beside the Base Task</source>
            <translation>基本任务之外的任务</translation>
        </message>
        <message>
            <source>Sync Unit</source>
            <translation>同步单元</translation>
        </message>
        <message>
            <source>Slaves of one unit are exchanged in datagrams of their own</source>
            <translation>同一单元的从站在其自己的数据报中交换</translation>
        </message>
        <message>
            <source>The task that exchanges the unit&apos;s process data</source>
            <translation>交换该单元过程数据的任务</translation>
        </message>
        <message>
            <source>Slaves</source>
            <translation>从站</translation>
        </message>
        <message>
            <source>Sync Units</source>
            <translation>同步单元</translation>
        </message>
        <message>
            <source>task</source>
            <translation>任务</translation>
        </message>
        <message>
            <source>Unit</source>
            <translation>单元</translation>
        </message>
        <message>
            <source>Base task</source>
            <translation>基本任务</translation>
        </message>
        <message>
            <source>None: all process data are exchanged in each bus cycle.</source>
            <translation>无：所有过程数据在每个总线周期交换。</translation>
        </message>
        <message>
            <source>None: the slaves share their datagrams. A unit is given to a slave on its page Data Options.</source>
            <translation>无：从站共用数据报。在从站的“数据选项”页面为其指定单元。</translation>
        </message>
    </context>
    <context>
        <name>ObjectPicker</name>
        <message>
            <source>Choose Object</source>
            <translation>选择对象</translation>
        </message>
        <message>
            <source>Search objects</source>
            <translation>搜索对象</translation>
        </message>
        <message>
            <source>Index, name or type</source>
            <translation>索引、名称或类型</translation>
        </message>
        <message>
            <source>Object</source>
            <translation>对象</translation>
        </message>
        <message>
            <source>Name</source>
            <translation>名称</translation>
        </message>
        <message>
            <source>Type</source>
            <translation>类型</translation>
        </message>
        <message>
            <source>Size</source>
            <translation>大小</translation>
        </message>
        <message>
            <source>Objects of the device</source>
            <translation>设备的对象</translation>
        </message>
        <message>
            <source>&amp;Choose</source>
            <translation>选择(&amp;C)</translation>
        </message>
        <message>
            <source>Choose</source>
            <translation>选择</translation>
        </message>
    </context>
    <context>
        <name>PdoMappingEditor</name>
        <message>
            <source>Entries</source>
            <translation>条目</translation>
        </message>
        <message>
            <source>Entries of the selected PDO</source>
            <translation>所选 PDO 的条目</translation>
        </message>
        <message>
            <source>Selected Entry</source>
            <translation>所选条目</translation>
        </message>
        <message>
            <source>Choose Object…</source>
            <translation>选择对象…</translation>
        </message>
        <message>
            <source>Choose an object of the device</source>
            <translation>选择设备的对象</translation>
        </message>
        <message>
            <source>PDO entry</source>
            <translation>PDO 条目</translation>
        </message>
        <message>
            <source>Object</source>
            <translation>对象</translation>
        </message>
        <message>
            <source>Index and sub-index, hexadecimal: 0x6040:00; 0x0000:00 is padding</source>
            <translation>索引和子索引，十六进制：0x6040:00；0x0000:00 为填充</translation>
        </message>
        <message>
            <source>&quot;%1&quot; is no object like 0x6040:00</source>
            <translation>“%1”不是 0x6040:00 形式的对象</translation>
        </message>
        <message>
            <source>Bits</source>
            <translation>位</translation>
        </message>
        <message>
            <source>Length of the entry, 1 to 255 bits</source>
            <translation>条目的长度，1 至 255 位</translation>
        </message>
        <message>
            <source>No PDO is selected.</source>
            <translation>未选择 PDO。</translation>
        </message>
        <message>
            <source>The device does not let this PDO be changed (Fixed in the ESI).</source>
            <translation>设备不允许更改此 PDO（ESI 中的 Fixed）。</translation>
        </message>
        <message>
            <source>The device takes no other mapping (CoE PdoConfig in its ESI).</source>
            <translation>设备不接受其他映射（其 ESI 中的 CoE PdoConfig）。</translation>
        </message>
    </context>
    <context>
        <name>RecentMenu</name>
        <message>
            <source>Open &amp;Recent</source>
            <translation>最近打开(&amp;R)</translation>
        </message>
        <message>
            <source>&amp;Pin This Project</source>
            <translation>固定此项目(&amp;P)</translation>
        </message>
        <message>
            <source>&amp;Clear List</source>
            <translation>清空列表(&amp;C)</translation>
        </message>
        <message>
            <source>Pinned projects stay</source>
            <translation>固定的项目保留</translation>
        </message>
    </context>
    <context>
        <name>RecordEditor</name>
        <message>
            <source>Selected</source>
            <translation>所选</translation>
        </message>
    </context>
    <context>
        <name>RecordForm</name>
        <message>
            <source>Change: %1</source>
            <translation>更改：%1</translation>
        </message>
        <message>
            <source>Add</source>
            <translation>添加</translation>
        </message>
        <message>
            <source>Add: %1</source>
            <translation>添加：%1</translation>
        </message>
        <message>
            <source>Remove</source>
            <translation>移除</translation>
        </message>
        <message>
            <source>Remove: %1</source>
            <translation>移除：%1</translation>
        </message>
        <message>
            <source>Move up: %1</source>
            <translation>上移：%1</translation>
        </message>
        <message>
            <source>Move down: %1</source>
            <translation>下移：%1</translation>
        </message>
    </context>
    <context>
        <name>RecoveryDialog</name>
        <message>
            <source>Recover Unsaved Work</source>
            <translation>恢复未保存的工作</translation>
        </message>
        <message>
            <source>A window ended before its edits were saved. They were kept; the files themselves are as they were last saved.</source>
            <translation>有窗口在保存编辑之前结束。编辑已保留；文件本身仍为上次保存的内容。</translation>
        </message>
        <message>
            <source>Unsaved work</source>
            <translation>未保存的工作</translation>
        </message>
        <message>
            <source>&amp;Recover</source>
            <translation>恢复(&amp;R)</translation>
        </message>
        <message>
            <source>&amp;Later</source>
            <translation>稍后(&amp;L)</translation>
        </message>
        <message>
            <source>&amp;Discard…</source>
            <translation>丢弃(&amp;D)…</translation>
        </message>
        <message>
            <source>Recover</source>
            <translation>恢复</translation>
        </message>
        <message>
            <source>Later</source>
            <translation>稍后</translation>
        </message>
        <message>
            <source>Leaves it to the next start</source>
            <translation>留待下次启动</translation>
        </message>
        <message>
            <source>Discard</source>
            <translation>丢弃</translation>
        </message>
        <message>
            <source>Untitled</source>
            <translation>未命名</translation>
        </message>
        <message numerus="yes">
            <source>kept %1, %n slave(s)</source>
            <translation>
                <numerusform>保留于 %1，%n 个从站</numerusform>
            </translation>
        </message>
        <message>
            <source>, last edit: %1</source>
            <translation>，最后一次编辑：%1</translation>
        </message>
        <message>
            <source>Never saved</source>
            <translation>从未保存</translation>
        </message>
        <message>
            <source>Discard this work for good?</source>
            <translation>要永久丢弃此工作吗？</translation>
        </message>
    </context>
    <context>
        <name>RunBar</name>
        <message>
            <source>Project and running machine</source>
            <translation>项目与运行中的机器</translation>
        </message>
        <message>
            <source>Differences…</source>
            <translation>差异…</translation>
        </message>
        <message>
            <source>What the project says otherwise than the machine that runs</source>
            <translation>项目与运行中的机器不同之处</translation>
        </message>
        <message>
            <source>Apply</source>
            <translation>应用</translation>
        </message>
        <message>
            <source>Restart…</source>
            <translation>重新启动…</translation>
        </message>
        <message>
            <source>Takes the machine offline and starts it with the project</source>
            <translation>使机器下线，并用项目重新启动</translation>
        </message>
        <message>
            <source>Revert</source>
            <translation>还原</translation>
        </message>
        <message>
            <source>Makes the project again what runs; Undo takes that back</source>
            <translation>使项目恢复为运行中的配置；可用“撤销”取消</translation>
        </message>
        <message numerus="yes">
            <source>The machine does not run what the project says: %n difference(s).</source>
            <translation>
                <numerusform>机器运行的配置与项目不同：%n 处差异。</numerusform>
            </translation>
        </message>
        <message>
            <source>Gives the parameters of the master synchronisation to the running machine</source>
            <translation>将主站同步的参数传给运行中的机器</translation>
        </message>
        <message>
            <source>Only parameters of the master synchronisation can be changed while the machine runs</source>
            <translation>机器运行时只能更改主站同步的参数</translation>
        </message>
    </context>
    <context>
        <name>SlaveSyncPage</name>
        <message>
            <source>Synchronisation</source>
            <translation>同步</translation>
        </message>
        <message>
            <source>Device Cycle</source>
            <translation>设备周期</translation>
        </message>
        <message>
            <source>CAN</source>
            <translation>CAN</translation>
        </message>
        <message>
            <source>Output Pins</source>
            <translation>输出引脚</translation>
        </message>
        <message>
            <source>Pin %1</source>
            <translation>引脚 %1</translation>
        </message>
    </context>
</TS>
