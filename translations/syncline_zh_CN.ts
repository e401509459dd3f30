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
            <source>High &amp;Contrast</source>
            <translation>高对比度(&amp;C)</translation>
        </message>
        <message>
            <source>Make a recording of a capture of frames (pcap, pcapng) of any master, and show it</source>
            <translation>将任意主站的帧抓包（pcap、pcapng）生成记录并显示</translation>
        </message>
        <message>
            <source>Import Capture as Recordin&amp;g…</source>
            <translation>将抓包导入为记录(&amp;G)…</translation>
        </message>
        <message>
            <source>Choose the B&amp;us…</source>
            <translation>选择总线(&amp;U)…</translation>
        </message>
        <message>
            <source>On which bus the machine runs: a network card, a scenario, or itself, simulated</source>
            <translation>机器在哪条总线上运行：网卡、场景，或仿真的机器自身</translation>
        </message>
        <message>
            <source>Memor&amp;y for the Last…</source>
            <translation>最近周期的内存(&amp;Y)…</translation>
        </message>
        <message>
            <source>How many of the latest cycles stay in memory, to be saved afterwards</source>
            <translation>内存中保留多少最近的周期，以便事后保存</translation>
        </message>
    <message>
        <source>Comm&amp;issioning Report…</source>
        <translation>调试报告(&amp;I)…</translation>
    </message>
    <message>
        <source>Judge the run that is shown by criteria, and write the page to hand over</source>
        <translation>按准则评判所示的运行，并写出移交页面</translation>
    </message>
        <message>
            <source>Ne&amp;w Machine…</source>
            <translation>新建机器(&amp;W)…</translation>
        </message>
        <message>
            <source>Make a machine step by step: slaves, cycle, clocks, operation modes</source>
            <translation>逐步建立机器：从站、周期、时钟、运行模式</translation>
        </message>
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
            <source>Open a project, an ENI, an ESI file, a recording, a capture or a scenario</source>
            <translation>打开项目、ENI、ESI 文件、记录、抓包文件或场景</translation>
        </message>
        <message>
            <source>&amp;Close Recording</source>
            <translation>关闭记录(&amp;C)</translation>
        </message>
        <message>
            <source>Show the project and its machine again in place of the recording</source>
            <translation>重新显示项目及其机器，代替记录</translation>
        </message>
        <message>
            <source>&amp;Record…</source>
            <translation>记录(&amp;R)…</translation>
        </message>
        <message>
            <source>Record the running machine to a file, from now on</source>
            <translation>从现在起将运行中的机器记录到文件</translation>
        </message>
        <message>
            <source>Save the &amp;Last…</source>
            <translation>保存最近一段(&amp;L)…</translation>
        </message>
        <message>
            <source>Save the last stretch, which is still in memory, as a recording</source>
            <translation>将仍在内存中的最近一段保存为记录</translation>
        </message>
        <message>
            <source>&amp;Overview</source>
            <translation>总览(&amp;O)</translation>
        </message>
        <message>
            <source>Whether the machine is in sync, since when, and what happened first</source>
            <translation>机器是否同步、自何时起、首先发生了什么</translation>
        </message>
        <message>
            <source>&amp;Go To…</source>
            <translation>转到(&amp;G)…</translation>
        </message>
        <message>
            <source>Find a slave, a setting or a command</source>
            <translation>查找从站、设置或命令</translation>
        </message>
        <message>
            <source>Co&amp;mpare…</source>
            <translation>比较(&amp;M)…</translation>
        </message>
        <message>
            <source>Compare the project with a file, the running machine or a bus, or two files</source>
            <translation>将项目与文件、运行中的机器或总线比较，或比较两个文件</translation>
        </message>
        <message>
            <source>Save as &amp;Template…</source>
            <translation>存为模板(&amp;T)…</translation>
        </message>
        <message>
            <source>Keep the project as what others can begin with</source>
            <translation>保留此项目，供其他项目以它开始</translation>
        </message>
        <message>
            <source>Export with Re&amp;port</source>
            <translation>导出时附报告(&amp;P)</translation>
        </message>
        <message>
            <source>Write an HTML report of the machine beside each ENI that is exported</source>
            <translation>在每个导出的 ENI 旁写一份机器的 HTML 报告</translation>
        </message>
        <message>
            <source>&amp;Black Box of Frames…</source>
            <translation>帧黑匣子(&amp;B)…</translation>
        </message>
        <message>
            <source>Keep the last frames of every run on disk, whole also after a crash</source>
            <translation>将每次运行的最后若干帧保存在磁盘上，崩溃后也完整</translation>
        </message>
        <message>
            <source>O&amp;verlay Another Recording…</source>
            <translation>叠加另一个记录(&amp;V)…</translation>
        </message>
        <message>
            <source>Lay the curves of another recording over those of the one that is shown</source>
            <translation>将另一个记录的曲线叠加到所显示的记录上</translation>
        </message>
</context>
<context>
    <name>BusCommands</name>
        <message>
            <source>Choose Another &amp;Bus…</source>
            <translation>选择其他总线(&amp;B)…</translation>
        </message>
        <message>
            <source>Choose</source>
            <translation>选择</translation>
        </message>
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
    <name>CsvExport</name>
        <message>
            <source>Writing %1…</source>
            <translation>正在写入 %1…</translation>
        </message>
        <message>
            <source>Export</source>
            <translation>导出</translation>
        </message>
        <message>
            <source>Cancel</source>
            <translation>取消</translation>
        </message>
    </context>
<context>
    <name>ExportMenu</name>
        <message>
            <source>&amp;C Header of the Process Image…</source>
            <translation>过程映像的 C 头文件(&amp;C)…</translation>
        </message>
        <message>
            <source>&amp;Process Image (CSV)…</source>
            <translation>过程映像 (CSV)(&amp;P)…</translation>
        </message>
        <message>
            <source>P&amp;DOs and Their Entries (CSV)…</source>
            <translation>PDO 及其条目 (CSV)(&amp;D)…</translation>
        </message>
        <message>
            <source>&amp;Init Commands (CSV)…</source>
            <translation>初始化命令 (CSV)(&amp;I)…</translation>
        </message>
        <message>
            <source>&amp;Slaves (CSV)…</source>
            <translation>从站 (CSV)(&amp;S)…</translation>
        </message>
        <message>
            <source>&amp;Topology (SVG)…</source>
            <translation>拓扑 (SVG)(&amp;T)…</translation>
        </message>
        <message>
            <source>Export Ta&amp;bles and Code</source>
            <translation>导出表格和代码(&amp;B)</translation>
        </message>
        <message>
            <source>Export</source>
            <translation>导出</translation>
        </message>
        <message>
            <source>The file could not be written.</source>
            <translation>无法写入该文件。</translation>
        </message>
        <message>
            <source>Written to %1</source>
            <translation>已写入 %1</translation>
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
    <name>CyclePlot</name>
        <message>
            <source>nominal</source>
            <translation>标称</translation>
        </message>
        <message>
            <source>From one SYNC0 to the next: when the frame with the slave&apos;s outputs had ended there, in system time. Bars are logarithmic counts and fade with the age of their latest arrival; the dotted line is where outputs nominally come by the set value; shaded is what the slave needs for calculating and copying.</source>
            <translation>从一个 SYNC0 到下一个：带有从站输出的帧在该处结束的时刻（系统时间）。柱为对数计数，随最近一次到达的时间变旧而变淡；虚点线为按设定值输出应到达的位置；阴影为从站计算与复制所需的时间。</translation>
        </message>
        <message>
            <source>calculating and copying</source>
            <translation>计算与复制</translation>
        </message>
</context>
<context>
    <name>CycleView</name>
        <message>
            <source>Slave whose SYNC0 period is shown</source>
            <translation>显示其 SYNC0 周期的从站</translation>
        </message>
        <message>
            <source>Margins and setpoint slips</source>
            <translation>裕量与设定值错拍</translation>
        </message>
        <message>
            <source>Arrivals in the SYNC0 period</source>
            <translation>SYNC0 周期内的到达</translation>
        </message>
        <message>
            <source>Cycle</source>
            <translation>周期</translation>
        </message>
        <message>
            <source>No slave with SYNC0 whose outputs can be followed</source>
            <translation>没有可跟踪输出的带 SYNC0 的从站</translation>
        </message>
        <message>
            <source>margin at least %1</source>
            <translation>裕量至少 %1</translation>
        </message>
        <message>
            <source>no arrivals</source>
            <translation>没有到达</translation>
        </message>
        <message>
            <source>99.9 %: %1</source>
            <translation>99.9 %：%1</translation>
        </message>
        <message>
            <source>calculating and copying %1</source>
            <translation>计算与复制 %1</translation>
        </message>
        <message>
            <source>nominally %1</source>
            <translation>标称 %1</translation>
        </message>
        <message>
            <source>calculating and copying not known</source>
            <translation>计算与复制时间未知</translation>
        </message>
        <message>
            <source>setpoint slips: %1</source>
            <translation>设定值错拍：%1</translation>
        </message>
        <message>
            <source>setpoint slips not known</source>
            <translation>设定值错拍未知</translation>
        </message>
        <message>
            <source>SYNC0 %1, shift %2</source>
            <translation>SYNC0 %1，偏移 %2</translation>
        </message>
</context>
<context>
    <name>DcmPanel</name>
        <message>
            <source>filtered ±%1</source>
            <translation>滤波后 ±%1</translation>
        </message>
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
            <source>All</source>
            <translation>全部</translation>
        </message>
        <message>
            <source>All pages of the selected node</source>
            <translation>所选节点的全部页面</translation>
        </message>
        <message>
            <source>Configuration</source>
            <translation>配置</translation>
        </message>
        <message>
            <source>The pages that say what shall be</source>
            <translation>设定应有状态的页面</translation>
        </message>
        <message>
            <source>Diagnosis</source>
            <translation>诊断</translation>
        </message>
        <message>
            <source>The pages that show what is</source>
            <translation>显示实际状态的页面</translation>
        </message>
        <message>
            <source>Which pages are shown</source>
            <translation>显示哪些页面</translation>
        </message>
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
            <source>Offline</source>
            <translation>离线</translation>
        </message>
        <message>
            <source>position %1, address %2</source>
            <translation>位置 %1，地址 %2</translation>
        </message>
</context>
<context>
    <name>ExplorerPanel</name>
        <message>
            <source>Project explorer</source>
            <translation>项目浏览器</translation>
        </message>
        <message>
            <source>Topology of the network</source>
            <translation>网络拓扑</translation>
        </message>
        <message>
            <source>Classic</source>
            <translation>经典</translation>
        </message>
        <message>
            <source>Tree by wiring: terminals below their coupler</source>
            <translation>按接线的树：端子模块位于其耦合器之下</translation>
        </message>
        <message>
            <source>Flat</source>
            <translation>平铺</translation>
        </message>
        <message>
            <source>All slaves in bus order</source>
            <translation>按总线顺序的所有从站</translation>
        </message>
        <message>
            <source>Topology</source>
            <translation>拓扑</translation>
        </message>
        <message>
            <source>Ports and cables; drag a slave to another port to rewire it</source>
            <translation>端口和电缆；将从站拖到另一端口即可改接</translation>
        </message>
        <message>
            <source>Error Counters at Its Cable (%1)</source>
            <translation>其电缆处的错误计数器（%1）</translation>
        </message>
        <message>
            <source>Network of the machine</source>
            <translation>机器的网络</translation>
        </message>
        <message>
            <source>Which network of the machine is in work (Ctrl+F6: the next one)</source>
            <translation>当前处理机器的哪个网络（Ctrl+F6：下一个）</translation>
        </message>
</context>
    <context>
    <name>FaultBanner</name>
        <message>
            <source>First fault</source>
            <translation>首个故障</translation>
        </message>
        <message>
            <source>The episode before</source>
            <translation>前一次</translation>
        </message>
        <message>
            <source>The next episode</source>
            <translation>后一次</translation>
        </message>
    </context>
<context>
    <name>FileCommands</name>
        <message>
            <source>A new machine takes the place of the present one.</source>
            <translation>新机器将取代当前机器。</translation>
        </message>
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
            <source>%1 cannot be opened here.</source>
            <translation>%1 无法在此打开。</translation>
        </message>
        <message>
            <source>Another project is opened.</source>
            <translation>将打开另一个项目。</translation>
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
        <message>
            <source>All that can be opened (*.syncline *.xml *.esi *.eni *.slrec *.csv *.pcap *.pcapng *.toml);;Syncline projects (*.syncline);;Recordings (*.slrec);;All files (*)</source>
            <translation>所有可打开的文件 (*.syncline *.xml *.esi *.eni *.slrec *.csv *.pcap *.pcapng *.toml);;Syncline 项目 (*.syncline);;记录 (*.slrec);;所有文件 (*)</translation>
        </message>
        <message>
            <source>a project, an ENI, an ESI, a recording, a capture or a scenario</source>
            <translation>项目、ENI、ESI、记录、抓包文件或场景</translation>
        </message>
        <message>
            <source>Open %1, or compare the project with it?</source>
            <translation>打开 %1，还是将项目与它比较？</translation>
        </message>
        <message>
            <source>&amp;Compare</source>
            <translation>比较(&amp;C)</translation>
        </message>
        <message>
            <source>&amp;Open</source>
            <translation>打开(&amp;O)</translation>
        </message>
        <message>
            <source>ENI written to %1, report to %2</source>
            <translation>ENI 已写入 %1，报告已写入 %2</translation>
        </message>
        <message>
            <source>There is a report %1 already.</source>
            <translation>已存在报告 %1。</translation>
        </message>
        <message>
            <source>It is replaced by the one of this export.</source>
            <translation>它将被本次导出的报告替换。</translation>
        </message>
        <message>
            <source>Replace</source>
            <translation>替换</translation>
        </message>
        <message>
            <source>Open %1 now?</source>
            <translation>现在打开 %1 吗？</translation>
        </message>
        <message>
            <source>Syncline was started with it. The recovered work is not saved yet; what would take its place asks first.</source>
            <translation>Syncline 是以该文件启动的。恢复的工作尚未保存；若要取代它，会先询问。</translation>
        </message>
        <message>
            <source>%1 was not opened: the recovered work is shown</source>
            <translation>未打开 %1：显示的是恢复的工作</translation>
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
            <translation>总线偏移</translation>
        </message>
        <message>
            <source>Master shift</source>
            <translation>主站偏移</translation>
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
            <translation>由应用执行主站偏移</translation>
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
        <message>
            <source>on the way to the external clock</source>
            <translation>正在趋近外部时钟</translation>
        </message>
        <message>
            <source>away from the external clock</source>
            <translation>偏离外部时钟</translation>
        </message>
</context>
<context>
    <name>Link</name>
        <message>
            <source>This machine (simulated)</source>
            <translation>本机器（仿真）</translation>
        </message>
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
        <message numerus="yes">
            <source>Simulated bus of the %n slave(s) of the project, as they are wired there</source>
            <translation>
                <numerusform>由项目的 %n 个从站组成的仿真总线，按项目中的接线</numerusform>
            </translation>
        </message>
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
        <message>
            <source>driver %1</source>
            <translation>驱动 %1</translation>
        </message>
</context>
<context>
    <name>LiveStrip</name>
        <message>
            <source>The worst %1</source>
            <translation>最差的 %1 个</translation>
        </message>
        <message>
            <source>The worst one</source>
            <translation>最差的一个</translation>
        </message>
        <message>
            <source>Slaves that are drawn</source>
            <translation>绘制的从站</translation>
        </message>
        <message>
            <source>Limit in the plots</source>
            <translation>图中的限值</translation>
        </message>
        <message>
            <source>Limit</source>
            <translation>限值</translation>
        </message>
        <message>
            <source>Limit in the project, such as 127 ns or 4 us. The sync window takes the nearest 2ⁿ − 1 ns.</source>
            <translation>项目中的限值，例如 127 ns 或 4 us。同步窗口取最接近的 2ⁿ − 1 ns。</translation>
        </message>
        <message>
            <source>That is no limit. A number above zero with ns, us or ms:</source>
            <translation>这不是限值。请输入大于零、带 ns、us 或 ms 的数：</translation>
        </message>
        <message>
            <source>Limit in the project…</source>
            <translation>项目中的限值…</translation>
        </message>
        <message>
            <source>Distance of the Cursors</source>
            <translation>光标间距</translation>
        </message>
        <message>
            <source>From A to B, such as 12.5 ms, 250 us, -1 s, or 50 Hz:</source>
            <translation>从 A 到 B，例如 12.5 ms、250 us、-1 s 或 50 Hz：</translation>
        </message>
        <message>
            <source>That is no time. A number with ns, us, ms, s or Hz:</source>
            <translation>这不是时间。请输入带 ns、us、ms、s 或 Hz 的数：</translation>
        </message>
        <message>
            <source>Distance of the cursors…</source>
            <translation>光标间距…</translation>
        </message>
        <message>
            <source>Cursors stay on the screen</source>
            <translation>光标固定在屏幕上</translation>
        </message>
        <message>
            <source>Time axis</source>
            <translation>时间轴</translation>
        </message>
        <message>
            <source>Before now, or since the start</source>
            <translation>距现在，或自启动以来</translation>
        </message>
        <message>
            <source>Since the start</source>
            <translation>自启动以来</translation>
        </message>
        <message>
            <source>Time of day (UTC)</source>
            <translation>时刻（UTC）</translation>
        </message>
        <message>
            <source>Number of the cycle</source>
            <translation>周期编号</translation>
        </message>
        <message>
            <source>System time of the reference clock</source>
            <translation>参考时钟的系统时间</translation>
        </message>
        <message>
            <source>Value scale of this plot</source>
            <translation>此图的数值刻度</translation>
        </message>
        <message>
            <source>Linear</source>
            <translation>线性</translation>
        </message>
        <message>
            <source>Signed logarithmic</source>
            <translation>带符号对数</translation>
        </message>
        <message>
            <source>Logarithmic</source>
            <translation>对数</translation>
        </message>
        <message>
            <source>Value limits of this plot…</source>
            <translation>此图的数值范围…</translation>
        </message>
        <message>
            <source>Own time axis of this plot</source>
            <translation>此图的独立时间轴</translation>
        </message>
        <message>
            <source>Copy figures</source>
            <translation>复制数值</translation>
        </message>
        <message>
            <source>Note here…</source>
            <translation>在此处写注释…</translation>
        </message>
        <message>
            <source>Export the episode</source>
            <translation>导出片段</translation>
        </message>
        <message>
            <source>Live plots</source>
            <translation>实时曲线</translation>
        </message>
        <message>
            <source>No data: go online</source>
            <translation>无数据：请先上线</translation>
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
            <source>Copy picture</source>
            <translation>复制图片</translation>
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
            <source>Replay from here</source>
            <translation>从此处回放</translation>
        </message>
        <message>
            <source>Lay this moment of %1 on cursor A</source>
            <translation>将 %1 的此时刻对到光标 A</translation>
        </message>
        <message>
            <source>Show the plots</source>
            <translation>显示曲线图</translation>
        </message>
</context>
<context>
    <name>PictureFile</name>
        <message>
            <source>PNG picture (*.png)</source>
            <translation>PNG 图片 (*.png)</translation>
        </message>
        <message>
            <source>SVG drawing (*.svg)</source>
            <translation>SVG 图形 (*.svg)</translation>
        </message>
        <message>
            <source>PDF document (*.pdf)</source>
            <translation>PDF 文档 (*.pdf)</translation>
        </message>
</context>
<context>
    <name>LiveStripToolbar</name>
        <message>
            <source>Own Plots</source>
            <translation>自定义图</translation>
        </message>
        <message>
            <source>Any signals in as many plots as you like, instead of these; kept with the project</source>
            <translation>用任意多个图显示任意信号，代替这些图；随项目保存</translation>
        </message>
        <message>
            <source>Trigger</source>
            <translation>触发</translation>
        </message>
        <message>
            <source>Stops or moves the plots where a signal or an event does what you wait for</source>
            <translation>在信号或事件发生所等待的变化处停止或移动曲线</translation>
        </message>
        <message>
            <source>Distribution</source>
            <translation>分布</translation>
        </message>
        <message>
            <source>How often which value came, instead of the plots over time</source>
            <translation>以各数值出现的次数代替时间曲线</translation>
        </message>
        <message>
            <source>Stability</source>
            <translation>稳定性</translation>
        </message>
        <message>
            <source>How steady signals are over observation times, and their spectrum, instead of the plots</source>
            <translation>以信号在各观测时间上的稳定程度及其频谱代替曲线</translation>
        </message>
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
            <source>Show the end of the run (End)</source>
            <translation>显示运行的末尾（End）</translation>
        </message>
        <message>
            <source>The run has ended: its picture stands still</source>
            <translation>运行已结束：画面静止</translation>
        </message>
        <message>
            <source>Ended, %1 before the end</source>
            <translation>已结束，距末尾 %1</translation>
        </message>
        <message>
            <source>Ended</source>
            <translation>已结束</translation>
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
        <message>
            <source>A recording has no newest sample to follow</source>
            <translation>记录没有可跟随的最新采样</translation>
        </message>
        <message>
            <source>A recording stands still</source>
            <translation>记录是静止的</translation>
        </message>
        <message>
            <source>Recording</source>
            <translation>记录</translation>
        </message>
        <message>
            <source>Slaves</source>
            <translation>从站</translation>
        </message>
        <message>
            <source>Cycle</source>
            <translation>周期</translation>
        </message>
        <message>
            <source>Where in the SYNC0 period of a slave its outputs come, instead of the plots</source>
            <translation>输出在从站 SYNC0 周期中何时到达，代替曲线</translation>
        </message>
        <message>
            <source>The deviations of all slaves as a heat map, and their figures, instead of the plots</source>
            <translation>以热图显示所有从站的偏差及其数值，代替曲线</translation>
        </message>
        <message>
            <source>View</source>
            <translation>视图</translation>
        </message>
        <message>
            <source>What is shown instead of the plots over time</source>
            <translation>代替时间曲线显示的内容</translation>
        </message>
        <message>
            <source>Now</source>
            <translation>现在</translation>
        </message>
        <message>
            <source>Replay</source>
            <translation>回放</translation>
        </message>
        <message>
            <source>Follow the moment of the replay (End)</source>
            <translation>跟随回放的时刻（End）</translation>
        </message>
        <message>
            <source>Stop the picture, not the replay (Space)</source>
            <translation>停住画面，不停止回放（空格）</translation>
        </message>
        <message>
            <source>Leave only the figures of the plots</source>
            <translation>只保留曲线图的数值</translation>
        </message>
</context>
<context>
    <name>MainWindow</name>
        <message>
            <source>The program ends.</source>
            <translation>程序将退出。</translation>
        </message>
        <message>
            <source>Trigger</source>
            <translation>触发</translation>
        </message>
        <message>
            <source>A recording is shown; it has no pages of slaves</source>
            <translation>正在显示记录；记录没有从站页面</translation>
        </message>
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
            <source>Request S&amp;tate</source>
            <translation>请求状态(&amp;T)</translation>
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
        <message>
            <source>Recording %1 – Syncline</source>
            <translation>记录 %1 – Syncline</translation>
        </message>
        <message>
            <source>Stop &amp;Recording</source>
            <translation>停止记录(&amp;R)</translation>
        </message>
        <message>
            <source>&amp;Record…</source>
            <translation>记录(&amp;R)…</translation>
        </message>
        <message>
            <source>A recording is shown, and nothing runs: close it first (File, Close Recording)</source>
            <translation>正在显示记录，没有机器运行：请先关闭记录（文件，关闭记录）</translation>
        </message>
        <message>
            <source>Re&amp;play</source>
            <translation>回放(&amp;P)</translation>
        </message>
        <message>
            <source>&amp;Help on the Field</source>
            <translation>字段帮助(&amp;H)</translation>
        </message>
        <message>
            <source>Range, default and key of the field that has the focus</source>
            <translation>当前字段的范围、默认值和键</translation>
        </message>
</context>
<context>
    <name>MasterDcPage</name>
        <message>
            <source>Distributed Clocks</source>
            <translation>分布式时钟</translation>
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
            <source>As bus shift, without a control loop: the reference clock is written the nominal time, and what a frame is far off it is made good. Needs an accurate cycle.</source>
            <translation>同总线偏移，但没有控制环：将标称时间写入参考时钟，帧的较大偏差随即补偿。要求周期精确。</translation>
        </message>
        <message>
            <source>As bus shift, with the time that the network adapter puts into each frame while sending it</source>
            <translation>同总线偏移，使用网卡在发送时写入每一帧的时间</translation>
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
        <message>
            <source>Two thirds of the cycle, and later on long buses</source>
            <translation>周期的三分之二，总线较长时更晚</translation>
        </message>
        <message>
            <source>External clock</source>
            <translation>外部时钟</translation>
        </message>
        <message>
            <source>Reference clock ahead of the external one &gt; 0, within half a cycle</source>
            <translation>参考时钟领先于外部时钟 &gt; 0，在半个周期之内</translation>
        </message>
</context>
    <context>
    <name>BathtubPlot</name>
        <message>
            <source>From one SYNC0 to the next: how probable it is that the outputs come later than a moment (the line that falls to the right), and earlier (the one that falls to the left). Dashed is what comes out if the rarest arrivals go on as they begin; shaded is what the slave needs for calculating and copying.</source>
            <translation>从一个 SYNC0 到下一个：输出晚于某一时刻到达的概率（向右下降的线），以及早于该时刻的概率（向左下降的线）。虚线表示最罕见的到达按其开始的趋势继续时的结果；阴影为从站计算和复制所需的时间。</translation>
        </message>
    </context>
    <context>
    <name>CycleView</name>
        <message>
            <source>What is shown of the arrivals</source>
            <translation>显示到达的哪一方面</translation>
        </message>
        <message>
            <source>How probable late and early arrivals are</source>
            <translation>过晚和过早到达的概率</translation>
        </message>
        <message>
            <source>Arrivals</source>
            <translation>到达</translation>
        </message>
        <message>
            <source>Bathtub</source>
            <translation>浴盆曲线</translation>
        </message>
        <message>
            <source>How often outputs came when</source>
            <translation>输出在何时到达的次数</translation>
        </message>
        <message>
            <source>How probable it is that outputs come too late or too early</source>
            <translation>输出到达过晚或过早的概率</translation>
        </message>
        <message>
            <source>%1 (extrapolated) in all but %2</source>
            <translation>除 %2 外均有 %1（外推）</translation>
        </message>
        <message>
            <source>%1 in all but %2</source>
            <translation>除 %2 外均有 %1</translation>
        </message>
        <message>
            <source>%1 arrivals: too few for a probability</source>
            <translation>%1 次到达：太少，无法给出概率</translation>
        </message>
        <message>
            <source>room before SYNC0: %1</source>
            <translation>距 SYNC0 的余量：%1</translation>
        </message>
        <message>
            <source>behind the one before: %1</source>
            <translation>距前一个 SYNC0：%1</translation>
        </message>
        <message>
            <source>calculating and copying (%1) always has its time, as far as can be told</source>
            <translation>就目前所知，计算和复制（%1）始终有足够的时间</translation>
        </message>
        <message>
            <source>too late for calculating and copying (%1): %2 at most, extrapolated</source>
            <translation>来不及计算和复制（%1）：最多 %2，外推</translation>
        </message>
        <message>
            <source>too late for calculating and copying (%1): %2 at most</source>
            <translation>来不及计算和复制（%1）：最多 %2</translation>
        </message>
    </context>
    <context>
    <name>JoinedText</name>
        <message>
            <source>%1, %2</source>
            <comment>parts of one sentence</comment>
            <translation>%1，%2</translation>
        </message>
        <message>
            <source>%1; %2</source>
            <comment>clauses of one sentence</comment>
            <translation>%1；%2</translation>
        </message>
        <message>
            <source>%1.</source>
            <comment>a sentence and its full stop</comment>
            <translation>%1。</translation>
        </message>
        <message>
            <source>%1 %2</source>
            <comment>one sentence behind the other</comment>
            <translation>%1%2</translation>
        </message>
    </context>
    <context>
    <name>HeatLegend</name>
        <message>
            <source>The largest magnitude of register 0x092C in each cell. Between two readings the older one holds; a cell is hatched where the slave was not read for longer than a few readings take, or no frame came back.</source>
            <translation>每个单元格中寄存器 0x092C 的最大绝对值。两次读数之间保持较早的读数；若从站超过数个读取间隔未被读取，或没有帧返回，则单元格画阴影线。</translation>
        </message>
        <message>
            <source>limit %1</source>
            <translation>限值 %1</translation>
        </message>
        <message>
            <source>over</source>
            <translation>超限</translation>
        </message>
        <message>
            <source>no reading</source>
            <translation>无读数</translation>
        </message>
    </context>
    <context>
    <name>HeatMapPlot</name>
        <message>
            <source>reference clock</source>
            <translation>参考时钟</translation>
        </message>
    </context>
    <context>
    <name>MaskChooser</name>
        <message>
            <source>Mask</source>
            <translation>模板</translation>
        </message>
        <message>
            <source>Own mask</source>
            <translation>自定义模板</translation>
        </message>
        <message>
            <source>Limit</source>
            <translation>限值</translation>
        </message>
        <message>
            <source>1/25 of the cycle</source>
            <translation>周期的 1/25</translation>
        </message>
        <message>
            <source>The most that the figure can be while every value is within the limit of the signal: the sync window, or that of the DCM error</source>
            <translation>只要每个值都在信号的限值（同步窗口或 DCM 误差限值）之内，该指标可能达到的最大值</translation>
        </message>
        <message>
            <source>The most that the figure can be while every value is within a twenty-fifth of the cycle</source>
            <translation>只要每个值都在周期的二十五分之一之内，该指标可能达到的最大值</translation>
        </message>
        <message>
            <source>What you type: observation time and value, points parted by semicolons</source>
            <translation>由您输入：观测时间和数值，各点以分号分隔</translation>
        </message>
        <message>
            <source>Observation time and value: &quot;1ms 100ns; 1s 250ns&quot;. Between points the mask is straight on both logarithmic axes, outside of them nothing is asked. A value alone is asked at every time.</source>
            <translation>观测时间和数值：“1ms 100ns; 1s 250ns”。各点之间，模板在两个对数轴上为直线；点范围之外不作要求。单独一个数值适用于所有时间。</translation>
        </message>
        <message>
            <source>Nobody understands &quot;%1&quot; in the mask.</source>
            <translation>模板中的“%1”无法理解。</translation>
        </message>
    </context>
    <context>
    <name>SlaveFiguresModel</name>
        <message>
            <source>reference</source>
            <translation>参考</translation>
        </message>
        <message>
            <source>no DC</source>
            <translation>无 DC</translation>
        </message>
        <message>
            <source>Slave</source>
            <translation>从站</translation>
        </message>
        <message>
            <source>Now</source>
            <translation>当前</translation>
        </message>
        <message>
            <source>Age</source>
            <translation>时龄</translation>
        </message>
        <message>
            <source>Max</source>
            <translation>最大</translation>
        </message>
        <message>
            <source>Mean</source>
            <translation>平均</translation>
        </message>
        <message>
            <source>RMS</source>
            <translation>RMS</translation>
        </message>
        <message>
            <source>Over</source>
            <translation>超限</translation>
        </message>
        <message>
            <source>SM2 missed</source>
            <translation>SM2 丢失</translation>
        </message>
        <message>
            <source>Course</source>
            <translation>走势</translation>
        </message>
        <message>
            <source>By position</source>
            <translation>按位置</translation>
        </message>
        <message>
            <source>The newest reading; a dash where it is too old to be present</source>
            <translation>最新读数；过旧而不再有效时显示横线</translation>
        </message>
        <message>
            <source>Of the newest reading, at the end of the range shown</source>
            <translation>最新读数在所示范围末端的时龄</translation>
        </message>
        <message>
            <source>The largest magnitude of all readings of the range shown</source>
            <translation>所示范围内所有读数的最大绝对值</translation>
        </message>
        <message>
            <source>Of all readings, with their signs; sorted by its magnitude</source>
            <translation>所有读数带符号的平均值；按绝对值排序</translation>
        </message>
        <message>
            <source>Root mean square of all readings, about zero</source>
            <translation>所有读数相对于零的均方根</translation>
        </message>
        <message>
            <source>Part of the readings whose magnitude is over the limit</source>
            <translation>绝对值超过限值的读数所占比例</translation>
        </message>
        <message>
            <source>SM2 events missed in the range shown; a dash without such a counter</source>
            <translation>所示范围内丢失的 SM2 事件；没有该计数器时显示横线</translation>
        </message>
        <message>
            <source>The largest magnitudes over the range shown; the top is the limit</source>
            <translation>所示范围内的最大绝对值；顶端为限值</translation>
        </message>
        <message>
            <source>%1; too few readings, or too alike, to say how sure that is</source>
            <translation>%1；读数太少或彼此过于相似，无法说明其可靠程度</translation>
        </message>
        <message>
            <source>%1; with 95 % certainty the true mean lies in it</source>
            <translation>%1；真实均值以 95 % 的把握位于其中</translation>
        </message>
    </context>
    <context>
    <name>SlavesView</name>
        <message>
            <source>Note</source>
            <translation>注释</translation>
        </message>
        <message>
            <source>Deviations of all slaves</source>
            <translation>所有从站的偏差</translation>
        </message>
        <message>
            <source>Colours of the deviations</source>
            <translation>偏差的颜色</translation>
        </message>
        <message>
            <source>Reading under the pointer</source>
            <translation>指针处的读数</translation>
        </message>
        <message>
            <source>Figures of all slaves</source>
            <translation>所有从站的数值</translation>
        </message>
        <message>
            <source>Slaves</source>
            <translation>从站</translation>
        </message>
        <message>
            <source>%1 old</source>
            <translation>%1 前</translation>
        </message>
        <message>
            <source>no reading</source>
            <translation>无读数</translation>
        </message>
        <message>
            <source>up to %1 in the cell</source>
            <translation>单元格内最大 %1</translation>
        </message>
        <message>
            <source>limit ±%1</source>
            <translation>限值 ±%1</translation>
        </message>
        <message>
            <source>%1: now %2, at most %3</source>
            <translation>%1：当前 %2，最大 %3</translation>
        </message>
            <message>
            <source>Farthest off is %1: %2</source>
            <translation>偏差最大的是 %1：%2</translation>
        </message>
</context>
    <context>
    <name>StabilityView</name>
        <message>
            <source>1/25 of the cycle</source>
            <translation>周期的 1/25</translation>
        </message>
        <message>
            <source>own mask</source>
            <translation>自定义模板</translation>
        </message>
        <message>
            <source>There is no mask yet.</source>
            <translation>尚无模板。</translation>
        </message>
        <message>
            <source>The mask asks nothing at the observation times that are shown.</source>
            <translation>模板对所示的观测时间没有要求。</translation>
        </message>
        <message>
            <source>Keeps the mask; closest to it at τ %1: %2 of %3.</source>
            <translation>符合模板；最接近处在 τ %1：%2，允许 %3。</translation>
        </message>
        <message>
            <source>Beyond the mask at %1 of %2 observation times, from τ %3 on; furthest at %4: %5 where %6 is allowed.</source>
            <translation>在 %2 个观测时间中有 %1 个超出模板，从 τ %3 开始；超出最多处在 %4：%5，允许 %6。</translation>
        </message>
    </context>
    <context>
    <name>StepText</name>
        <message>
            <source>overshoot %1 %</source>
            <translation>超调 %1 %</translation>
        </message>
        <message>
            <source>settled after %1</source>
            <translation>%1 后稳定</translation>
        </message>
        <message>
            <source>not settled</source>
            <translation>未稳定</translation>
        </message>
        <message>
            <source>step %1: %2</source>
            <translation>阶跃 %1：%2</translation>
        </message>
        <message>
            <source> (its controller without noise: %1)</source>
            <translation>（其控制器在无噪声时：%1）</translation>
        </message>
    </context>
    <context>
    <name>SyncWindowFields</name>
        <message>
            <source>Limit</source>
            <translation>限值</translation>
        </message>
    </context>
    <context>
    <name>ClockStep</name>
        <message>
            <source>Its description has no distributed clocks.</source>
            <translation>其描述中没有分布式时钟。</translation>
        </message>
        <message>
            <source>It may be missing; then nobody leads.</source>
            <translation>它可以缺失；那时没有时钟领先。</translation>
        </message>
        <message>
            <source>%1 stands before it, uses DC and would hear of its time a cycle late.</source>
            <translation>%1 位于它之前并使用 DC，会晚一个周期得知其时间。</translation>
        </message>
        <message>
            <source>No</source>
            <translation>否</translation>
        </message>
        <message>
            <source>Yes</source>
            <translation>是</translation>
        </message>
        <message>
            <source>Better not</source>
            <translation>最好不要</translation>
        </message>
        <message>
            <source>Reference Clock</source>
            <translation>参考时钟</translation>
        </message>
        <message>
            <source>Slaves that move together need distributed clocks: one slave's clock leads, and the others follow it. Without synchronised motion leave them off.</source>
            <translation>需要同步运动的从站需要分布式时钟：一个从站的时钟领先，其他从站跟随。没有同步运动时请将其关闭。</translation>
        </message>
        <message>
            <source>Distributed Clocks</source>
            <translation>分布式时钟</translation>
        </message>
        <message>
            <source>Leads now</source>
            <translation>当前领先</translation>
        </message>
        <message>
            <source>The slave whose clock the compiled project makes lead</source>
            <translation>编译后的项目中时钟领先的从站</translation>
        </message>
        <message>
            <source>Which slaves can lead, and why not</source>
            <translation>哪些从站可以领先，以及为何不能</translation>
        </message>
        <message>
            <source>Slave</source>
            <translation>从站</translation>
        </message>
        <message>
            <source>Can lead</source>
            <translation>可领先</translation>
        </message>
        <message>
            <source>Why not</source>
            <translation>原因</translation>
        </message>
    </context>
    <context>
    <name>CycleDialog</name>
        <message>
            <source>Cycle Times</source>
            <translation>周期时间</translation>
        </message>
        <message>
            <source>Cycles and who refuses them</source>
            <translation>各周期及拒绝它的从站</translation>
        </message>
        <message>
            <source>&amp;Use This Cycle</source>
            <translation>使用此周期(&amp;U)</translation>
        </message>
        <message>
            <source>The slaves accept: %1.</source>
            <translation>从站接受：%1。</translation>
        </message>
</context>
<context>
    <name>CycleStep</name>
        <message>
            <source>Cycle</source>
            <translation>周期</translation>
        </message>
        <message>
            <source>How often the process data go over the network. All Sync Unit Cycles are multiples or fractions of it.</source>
            <translation>过程数据在网络上传输的间隔。所有 Sync Unit Cycle 都是它的倍数或分数。</translation>
        </message>
        <message>
            <source>Network</source>
            <translation>网络</translation>
        </message>
        <message>
            <source>Slaves accept</source>
            <translation>从站接受</translation>
        </message>
        <message>
            <source>What drive families, object 0x1C32:05, operation modes and the frames leave</source>
            <translation>驱动器系列、对象 0x1C32:05、运行模式和帧所允许的范围</translation>
        </message>
        <message>
            <source>Cycles and who refuses them</source>
            <translation>周期及拒绝它的从站</translation>
        </message>
    </context>
<context>
    <name>CycleTable</name>
        <message>
            <source>Refused</source>
            <translation>被拒绝</translation>
        </message>
        <message>
            <source>Accepted by all</source>
            <translation>全部接受</translation>
        </message>
        <message>
            <source>Taken with a loss</source>
            <translation>接受但有损失</translation>
        </message>
        <message>
            <source>Cycle</source>
            <translation>周期</translation>
        </message>
        <message>
            <source>Slaves</source>
            <translation>从站</translation>
        </message>
        <message>
            <source>Because of</source>
            <translation>由于</translation>
        </message>
        <message>
            <source>Enter or a double click takes the cycle</source>
            <translation>按回车或双击采用该周期</translation>
        </message>
        <message>
            <source>%1 to %2, in steps of %3</source>
            <translation>%1 至 %2，步长 %3</translation>
        </message>
        <message>
            <source>any cycle</source>
            <translation>任意周期</translation>
        </message>
        <message numerus="yes">
            <source>%n more</source>
            <translation>
                <numerusform>另外 %n 个</numerusform>
            </translation>
        </message>
        <message>
            <source>%1: %2</source>
            <translation>%1：%2</translation>
        </message>
</context>
    <context>
    <name>DcModeModel</name>
        <message>
            <source>no distributed clocks</source>
            <translation>无分布式时钟</translation>
        </message>
        <message>
            <source>Off</source>
            <translation>关</translation>
        </message>
        <message>
            <source>User defined</source>
            <translation>自定义</translation>
        </message>
        <message>
            <source>As operation mode</source>
            <translation>按运行模式</translation>
        </message>
        <message>
            <source>As operation mode (%1)</source>
            <translation>按运行模式 (%1)</translation>
        </message>
        <message>
            <source>Slave</source>
            <translation>从站</translation>
        </message>
        <message>
            <source>Operation mode</source>
            <translation>运行模式</translation>
        </message>
        <message>
            <source>Sync Unit Cycle</source>
            <translation>Sync Unit Cycle</translation>
        </message>
        <message>
            <source>SYNC0</source>
            <translation>SYNC0</translation>
        </message>
        <message>
            <source>Found</source>
            <translation>发现</translation>
        </message>
    </context>
    <context>
    <name>MachineDraft</name>
        <message>
            <source>Reading slave %1 of %2</source>
            <translation>正在读取从站 %1 / %2</translation>
        </message>
        <message numerus="yes">
            <source>%n slave(s) found on %1</source>
            <translation>
                <numerusform>在 %1 上找到 %n 个从站</numerusform>
            </translation>
        </message>
        <message>
            <source>The scan was cancelled; the slaves are those of before.</source>
            <translation>扫描已取消；从站保持不变。</translation>
        </message>
        <message>
            <source>The machine of the window runs on this bus. Go offline first, or choose another bus.</source>
            <translation>窗口中的机器正在此总线上运行。请先离线，或选择其他总线。</translation>
        </message>
        <message>
            <source>Looking for slaves…</source>
            <translation>正在查找从站…</translation>
        </message>
        <message numerus="yes">
            <source>A project was made of %1; exported again, %n command(s) would differ.</source>
            <translation>
                <numerusform>已由 %1 建立项目；再次导出时会有 %n 条命令不同。</numerusform>
            </translation>
        </message>
        <message numerus="yes">
            <source>%n slave(s) as in %1</source>
            <translation>
                <numerusform>%n 个从站，与 %1 相同</numerusform>
            </translation>
        </message>
        <message>
            <source>Add a slave</source>
            <translation>添加从站</translation>
        </message>
        <message>
            <source>%1 was added.</source>
            <translation>已添加 %1。</translation>
        </message>
        <message>
            <source>Remove a slave</source>
            <translation>移除从站</translation>
        </message>
    </context>
    <context>
    <name>ModesStep</name>
        <message>
            <source>Operation Modes</source>
            <translation>运行模式</translation>
        </message>
        <message>
            <source>What each slave does with the SYNC signals, and how often. F2 or a double click opens a choice.</source>
            <translation>每个从站如何使用 SYNC 信号以及频率。按 F2 或双击打开选项。</translation>
        </message>
        <message>
            <source>Change DC mode</source>
            <translation>更改 DC 模式</translation>
        </message>
        <message>
            <source>Operation modes of all slaves</source>
            <translation>所有从站的运行模式</translation>
        </message>
        <message>
            <source>What is found wrong with the selected slave</source>
            <translation>所选从站的问题</translation>
        </message>
    </context>
    <context>
    <name>NewMachineWizard</name>
        <message>
            <source>New Machine</source>
            <translation>新建机器</translation>
        </message>
        <message>
            <source>Step</source>
            <translation>步骤</translation>
        </message>
        <message>
            <source>What is decided here</source>
            <translation>此处的决定</translation>
        </message>
        <message>
            <source>Why it does not go on</source>
            <translation>无法继续的原因</translation>
        </message>
        <message>
            <source>&lt; Bac&amp;k</source>
            <translation>&lt; 上一步(&amp;K)</translation>
        </message>
        <message>
            <source>Back</source>
            <translation>上一步</translation>
        </message>
        <message>
            <source>Next</source>
            <translation>下一步</translation>
        </message>
        <message>
            <source>Cancel</source>
            <translation>取消</translation>
        </message>
        <message>
            <source>&amp;Finish</source>
            <translation>完成(&amp;F)</translation>
        </message>
        <message>
            <source>&amp;Next &gt;</source>
            <translation>下一步(&amp;N) &gt;</translation>
        </message>
        <message>
            <source>Finish</source>
            <translation>完成</translation>
        </message>
        <message>
            <source>A field holds what cannot be a value: mend it, or press Esc in it.</source>
            <translation>有字段的内容不是有效值：请改正，或在其中按 Esc。</translation>
        </message>
        <message>
            <source>%1 exists already.</source>
            <translation>%1 已存在。</translation>
        </message>
        <message>
            <source>Its contents go when the ENI is written.</source>
            <translation>写入 ENI 时其内容将丢失。</translation>
        </message>
        <message>
            <source>Overwrite</source>
            <translation>覆盖</translation>
        </message>
        <message>
            <source>Give up the new machine?</source>
            <translation>放弃新机器？</translation>
        </message>
        <message>
            <source>What was chosen here goes. The project of the window stays as it is.</source>
            <translation>此处的选择将丢失。窗口中的项目保持不变。</translation>
        </message>
        <message>
            <source>Give Up</source>
            <translation>放弃</translation>
        </message>
    </context>
    <context>
    <name>SourceStep</name>
        <message>
            <source>Slaves</source>
            <translation>从站</translation>
        </message>
        <message>
            <source>Where do the slaves come from? The list on the right shows what the new machine has so far.</source>
            <translation>从站来自哪里？右侧列表显示新机器目前的从站。</translation>
        </message>
        <message>
            <source>A project is made of what the file lets be seen. Devices of the catalogue bring what an ENI does not hold.</source>
            <translation>根据文件可见的内容生成项目。目录中的设备补充 ENI 所不包含的内容。</translation>
        </message>
        <message>
            <source>Choose EN&amp;I…</source>
            <translation>选择 ENI(&amp;I)…</translation>
        </message>
        <message>
            <source>All that a saved project holds, under a new name. The file stays as it is.</source>
            <translation>已保存项目的全部内容，使用新名称。文件保持不变。</translation>
        </message>
        <message>
            <source>Choose &amp;Project…</source>
            <translation>选择项目(&amp;P)…</translation>
        </message>
        <message>
            <source>&amp;Scan of a bus</source>
            <translation>扫描总线(&amp;S)</translation>
        </message>
        <message>
            <source>&amp;ENI file</source>
            <translation>ENI 文件(&amp;E)</translation>
        </message>
        <message>
            <source>&amp;Device catalogue</source>
            <translation>设备目录(&amp;D)</translation>
        </message>
        <message>
            <source>Project as a &amp;template</source>
            <translation>以项目为模板(&amp;T)</translation>
        </message>
        <message>
            <source>What came of it</source>
            <translation>结果</translation>
        </message>
        <message>
            <source>A network card or a simulated bus. A bus whose slaves are running is only looked at, and nothing is written to it.</source>
            <translation>网卡或仿真总线。从站正在运行的总线只会被查看，不会写入任何内容。</translation>
        </message>
        <message>
            <source>Bus</source>
            <translation>总线</translation>
        </message>
        <message>
            <source>Choose &amp;Bus and Scan…</source>
            <translation>选择总线并扫描(&amp;B)…</translation>
        </message>
        <message>
            <source>Choose a bus and scan it</source>
            <translation>选择总线并扫描</translation>
        </message>
        <message>
            <source>Cance&amp;l Scan</source>
            <translation>取消扫描(&amp;L)</translation>
        </message>
        <message>
            <source>Cancel the scan</source>
            <translation>取消扫描</translation>
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
            <source>Why the scan is not whole</source>
            <translation>扫描不完整的原因</translation>
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
            <source>Number of slaves</source>
            <translation>从站数</translation>
        </message>
        <message>
            <source>Slaves of the new machine</source>
            <translation>新机器的从站</translation>
        </message>
        <message>
            <source>&amp;Remove</source>
            <translation>移除(&amp;R)</translation>
        </message>
        <message>
            <source>Remove the selected slave with its branches</source>
            <translation>移除所选从站及其分支</translation>
        </message>
        <message>
            <source>Remove the selected slave with its branches (Del)</source>
            <translation>移除所选从站及其分支 (Del)</translation>
        </message>
        <message>
            <source>The bus is being scanned.</source>
            <translation>正在扫描总线。</translation>
        </message>
        <message>
            <source>The machine has no slaves yet.</source>
            <translation>机器还没有从站。</translation>
        </message>
        <message numerus="yes">
            <source>%n slave(s)</source>
            <translation>
                <numerusform>%n 个从站</numerusform>
            </translation>
        </message>
        <message numerus="yes">
            <source>%n slave(s) of this bus are running. They were only looked at and nothing was written, so some of what they are may not be known.</source>
            <translation>
                <numerusform>此总线有 %n 个从站正在运行。只对其进行了查看，没有写入任何内容，因此其部分信息可能未知。</numerusform>
            </translation>
        </message>
        <message>
            <source>Scanned: %1</source>
            <translation>已扫描：%1</translation>
        </message>
        <message>
            <source>Scan</source>
            <translation>扫描</translation>
        </message>
        <message>
            <source>Open ENI</source>
            <translation>打开 ENI</translation>
        </message>
        <message>
            <source>EtherCAT network information (*.xml *.eni)</source>
            <translation>EtherCAT 网络信息 (*.xml *.eni)</translation>
        </message>
        <message>
            <source>Open Project</source>
            <translation>打开项目</translation>
        </message>
        <message>
            <source>Syncline projects (*.syncline)</source>
            <translation>Syncline 项目 (*.syncline)</translation>
        </message>
        <message>
            <source>Your templates (File, Save as Template)</source>
            <translation>您的模板（文件，存为模板）</translation>
        </message>
        <message>
            <source>&amp;Your templates (File, Save as Template)</source>
            <translation>您的模板（文件，存为模板）(&amp;Y)</translation>
        </message>
        <message>
            <source>&amp;Use Template</source>
            <translation>使用模板(&amp;U)</translation>
        </message>
        <message>
            <source>Take the slaves of the template</source>
            <translation>采用模板的从站</translation>
        </message>
        <message>
            <source>Re&amp;move Template…</source>
            <translation>删除模板(&amp;M)…</translation>
        </message>
        <message>
            <source>Remove the template</source>
            <translation>删除该模板</translation>
        </message>
    </context>
    <context>
    <name>SummaryStep</name>
        <message>
            <source>Summary</source>
            <translation>摘要</translation>
        </message>
        <message>
            <source>Finish puts the machine into the window, where everything can be changed further. It is not saved yet.</source>
            <translation>“完成”会把机器放入窗口，之后仍可更改一切。此时尚未保存。</translation>
        </message>
        <message>
            <source>The new machine</source>
            <translation>新机器</translation>
        </message>
        <message>
            <source>Slaves</source>
            <translation>从站</translation>
        </message>
        <message>
            <source>Cycle</source>
            <translation>周期</translation>
        </message>
        <message>
            <source>Reference clock</source>
            <translation>参考时钟</translation>
        </message>
        <message>
            <source>Master synchronisation</source>
            <translation>主站同步</translation>
        </message>
        <message>
            <source>Sync window</source>
            <translation>同步窗口</translation>
        </message>
        <message>
            <source>What the check found</source>
            <translation>检查结果</translation>
        </message>
        <message>
            <source>Findings</source>
            <translation>发现</translation>
        </message>
        <message>
            <source>&amp;Export the ENI to</source>
            <translation>导出 ENI 到(&amp;E)</translation>
        </message>
        <message>
            <source>Export the ENI, too</source>
            <translation>同时导出 ENI</translation>
        </message>
        <message>
            <source>File of the ENI</source>
            <translation>ENI 文件</translation>
        </message>
        <message>
            <source>Bro&amp;wse…</source>
            <translation>浏览(&amp;W)…</translation>
        </message>
        <message>
            <source>Choose the file of the ENI</source>
            <translation>选择 ENI 文件</translation>
        </message>
        <message>
            <source>The ENI needs a file name.</source>
            <translation>ENI 需要文件名。</translation>
        </message>
        <message>
            <source>There is no folder %1.</source>
            <translation>文件夹 %1 不存在。</translation>
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
            <source>none</source>
            <translation>无</translation>
        </message>
        <message>
            <source>%1, with DC %2</source>
            <translation>%1，其中 DC %2</translation>
        </message>
        <message>
            <source>distributed clocks are off</source>
            <translation>分布式时钟已关闭</translation>
        </message>
        <message>
            <source>monitored, limit %1</source>
            <translation>监视，限值 %1</translation>
        </message>
        <message>
            <source>not monitored</source>
            <translation>不监视</translation>
        </message>
        <message>
            <source>The ENI is being checked…</source>
            <translation>正在检查 ENI…</translation>
        </message>
        <message>
            <source>The check of project and ENI found nothing.</source>
            <translation>项目和 ENI 的检查未发现问题。</translation>
        </message>
        <message numerus="yes">
            <source>%n error(s)</source>
            <translation>
                <numerusform>%n 个错误</numerusform>
            </translation>
        </message>
        <message numerus="yes">
            <source>%n warning(s)</source>
            <translation>
                <numerusform>%n 个警告</numerusform>
            </translation>
        </message>
        <message numerus="yes">
            <source>%n note(s)</source>
            <translation>
                <numerusform>%n 个提示</numerusform>
            </translation>
        </message>
        <message>
            <source>The check of project and ENI found: %1.</source>
            <translation>项目和 ENI 的检查发现：%1。</translation>
        </message>
    </context>
    <context>
    <name>SyncStep</name>
        <message>
            <source>The master's clock leads and steers the reference clock, by a command in each frame. For several networks in one machine, or a host whose timer cannot be moved. It needs a steady host.</source>
            <translation>主站的时钟领先，并通过每帧中的一条命令调整参考时钟。适用于一台机器中有多个网络，或主机定时器无法移动的情况。要求主机稳定。</translation>
        </message>
        <message>
            <source>The reference clock leads and the master moves its send time after it. For one network; the slaves' SYNC signals have nothing of the host's jitter.</source>
            <translation>参考时钟领先，主站据此移动其发送时刻。适用于单个网络；从站的 SYNC 信号不受主机抖动影响。</translation>
        </message>
        <message>
            <source>Nobody follows: the frames drift through the SYNC grid of the slaves. For machines without synchronised motion only.</source>
            <translation>互不跟随：帧会在从站的 SYNC 网格中漂移。仅适用于没有同步运动的机器。</translation>
        </message>
        <message>
            <source>Another way, for special hardware; the page Distributed Clocks of the master explains it.</source>
            <translation>另一种方式，用于特殊硬件；主站的“分布式时钟”页有说明。</translation>
        </message>
        <message>
            <source>Distributed clocks are off: there is nothing to bring together.</source>
            <translation>分布式时钟已关闭：没有需要同步的内容。</translation>
        </message>
        <message>
            <source>No slave has an operation mode with SYNC signals: there is nothing to bring together.</source>
            <translation>没有从站使用带 SYNC 信号的运行模式：没有需要同步的内容。</translation>
        </message>
        <message>
            <source>Networks keep step when each reference clock follows the one clock of the masters.</source>
            <translation>当每个参考时钟都跟随主站的同一时钟时，各网络保持同步。</translation>
        </message>
        <message>
            <source>In a single network the slave's clock is the steadiest one to follow.</source>
            <translation>在单个网络中，从站的时钟是最稳定的跟随对象。</translation>
        </message>
        <message>
            <source>Synchronisation</source>
            <translation>同步</translation>
        </message>
        <message>
            <source>Master and reference clock run at slightly different speeds: one of them has to follow the other.</source>
            <translation>主站与参考时钟的速度略有不同：必须由一方跟随另一方。</translation>
        </message>
        <message>
            <source>Who follows whom</source>
            <translation>谁跟随谁</translation>
        </message>
        <message>
            <source>Proposal</source>
            <translation>建议</translation>
        </message>
        <message>
            <source>Sync Window Monitoring</source>
            <translation>同步窗口监视</translation>
        </message>
        <message>
            <source>What it is for</source>
            <translation>用途</translation>
        </message>
        <message>
            <source>&amp;Several networks run in step</source>
            <translation>多个网络同步运行(&amp;S)</translation>
        </message>
        <message>
            <source>Several networks run in step</source>
            <translation>多个网络同步运行</translation>
        </message>
        <message>
            <source>More than one EtherCAT network of the machine has to keep a common time</source>
            <translation>机器的多个 EtherCAT 网络必须保持同一时间</translation>
        </message>
        <message>
            <source>&amp;Use Proposal</source>
            <translation>采用建议(&amp;U)</translation>
        </message>
        <message>
            <source>Use the proposal</source>
            <translation>采用建议</translation>
        </message>
    </context>
<context>
    <name>MasterGeneralPage</name>
        <message>
            <source>Accepted…</source>
            <translation>可接受的…</translation>
        </message>
        <message>
            <source>Cycles that the slaves accept</source>
            <translation>从站接受的周期</translation>
        </message>
        <message>
            <source>Cycle times that all slaves accept, who refuses the others, and why</source>
            <translation>所有从站都接受的周期时间、谁拒绝其他周期以及原因</translation>
        </message>
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
            <source>Outputs</source>
            <translation>输出</translation>
        </message>
        <message>
            <source>Cyclic frames</source>
            <translation>循环帧</translation>
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
            <translation>已设置分布式时钟的从站 (ENI Slave/DC)</translation>
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
        <message>
            <source>Process data of all slaves to the master</source>
            <translation>所有从站发往主站的过程数据</translation>
        </message>
        <message>
            <source>Process data of the master to all slaves</source>
            <translation>主站发往所有从站的过程数据</translation>
        </message>
        <message>
            <source>Bytes on the wire and time for them at 100 Mbit/s, in a cycle; the page Frames and Cost says more</source>
            <translation>一个周期内线路上的字节数及 100 Mbit/s 下所需时间；详见“帧与开销”页面</translation>
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
        <message>
            <source>%1 by the clock of the recorded run</source>
            <translation>%1（所录运行的时钟）</translation>
        </message>
        <message>
            <source>%1 by the clock of this computer</source>
            <translation>%1（本计算机的时钟）</translation>
        </message>
        <message>
            <source>Run time</source>
            <translation>运行时间</translation>
        </message>
        <message>
            <source>Seconds of the run: since its first cycle, as on the axis of the plots</source>
            <translation>运行的秒数：自首个周期起，与曲线的时间轴一致</translation>
        </message>
        <message>
            <source>Time of day</source>
            <translation>时刻</translation>
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
            <source>%1, network in work</source>
            <translation>%1，正在编辑的网络</translation>
        </message>
        <message>
            <source>%1, another network</source>
            <translation>%1，其他网络</translation>
        </message>
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
            <translation>分布式时钟已启用</translation>
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
        <message>
            <source>no DC</source>
            <translation>无 DC</translation>
        </message>
        <message>
            <source>HC</source>
            <translation>HC</translation>
        </message>
        <message>
            <source>opt.</source>
            <translation>可选</translation>
        </message>
        <message>
            <source>%1, position %2, address %3</source>
            <translation>%1，位置 %2，地址 %3</translation>
        </message>
        <message>
            <source>Hot-connect group %1</source>
            <translation>热连接组 %1</translation>
        </message>
        <message>
            <source>Optional: may be missing</source>
            <translation>可选：可以缺少</translation>
        </message>
        <message>
            <source>The cable to it is broken</source>
            <translation>通往它的电缆已断开</translation>
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
        <message>
            <source>Excluded by %1, which the device needs (Exclude and Mandatory in the ESI)</source>
            <translation>被设备所需的 %1 排除（ESI 中的 Exclude 与 Mandatory）</translation>
        </message>
        <message>
            <source>Takes the place of %1: the device does not exchange both (Exclude in the ESI)</source>
            <translation>取代 %1：设备不会同时交换两者（ESI 中的 Exclude）</translation>
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
        <message>
            <source>Network %1</source>
            <translation>网络 %1</translation>
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
            <translation>分布式时钟</translation>
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
            <source>Cycle of the task that exchanges the slave&apos;s process data, base of the Sync Unit Cycle</source>
            <translation>交换该从站过程数据的任务的周期，是同步单元周期的基准</translation>
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
            <translation>0x0990 偏移</translation>
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
            <source>%1 (computed: it has no counter)</source>
            <translation>%1（计算值：它没有计数器）</translation>
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
        <message>
            <source>One Cycle</source>
            <translation>一个周期</translation>
        </message>
        <message>
            <source>One cycle of the slave to scale</source>
            <translation>从站的一个周期，按比例</translation>
        </message>
        <message>
            <source>Before SYNC0</source>
            <translation>SYNC0 之前</translation>
        </message>
        <message>
            <source>From the end of the frame with the slave's outputs to the SYNC0 that uses them</source>
            <translation>从携带该从站输出的帧结束到使用这些输出的 SYNC0</translation>
        </message>
        <message>
            <source>Calc + copy</source>
            <translation>计算 + 复制</translation>
        </message>
        <message>
            <source>What the slave needs of it: as it tells itself (0x1C32:06), else as its family is known</source>
            <translation>从站从中需要的时间：按其自身报告（0x1C32:06），否则按其系列的已知值</translation>
        </message>
        <message>
            <source>Compiled value, as written in PREOP to SAFEOP; online also what the slave has</source>
            <translation>编译值，在 PREOP 到 SAFEOP 时写入；在线时还显示从站的值</translation>
        </message>
        <message>
            <source>%1, the slave has %2</source>
            <translation>%1，从站为 %2</translation>
        </message>
        <message>
            <source>%1, read back</source>
            <translation>%1，已回读</translation>
        </message>
        <message>
            <source>no SYNC0</source>
            <translation>无 SYNC0</translation>
        </message>
</context>
<context>
    <name>SaveName</name>
        <message>
            <source>%1 is there already. Replace it?</source>
            <translation>%1 已存在。要替换吗？</translation>
        </message>
</context>
<context>
    <name>SlaveFilesPage</name>
        <message>
            <source>Files</source>
            <translation>文件</translation>
        </message>
        <message>
            <source>Most devices take firmware in BOOT only, where the buttons above lead the slave; other files are served in PREOP and above. What a name means, and which password opens it, says the device&apos;s manual.</source>
            <translation>多数设备只在 BOOT 状态下接受固件，可用上方按钮切换到该状态；其他文件在 PREOP 及以上状态提供。文件名的含义和所需密码见设备手册。</translation>
        </message>
        <message>
            <source>Slave</source>
            <translation>从站</translation>
        </message>
        <message>
            <source>What</source>
            <translation>操作</translation>
        </message>
        <message>
            <source>File in the slave</source>
            <translation>从站中的文件</translation>
        </message>
        <message>
            <source>Size</source>
            <translation>大小</translation>
        </message>
        <message>
            <source>File here</source>
            <translation>本机文件</translation>
        </message>
        <message>
            <source>Outcome</source>
            <translation>结果</translation>
        </message>
        <message>
            <source>Files that were transferred</source>
            <translation>已传输的文件</translation>
        </message>
        <message>
            <source>How much of the file has been transferred</source>
            <translation>文件已传输多少</translation>
        </message>
        <message>
            <source>Name of the file in the slave</source>
            <translation>从站中的文件名</translation>
        </message>
        <message>
            <source>Password of the slave, a number</source>
            <translation>从站的密码（数字）</translation>
        </message>
        <message>
            <source>none</source>
            <translation>无</translation>
        </message>
        <message>
            <source>&amp;Read into File…</source>
            <translation>读取到文件(&amp;R)…</translation>
        </message>
        <message>
            <source>Copy the slave&apos;s file into a file here</source>
            <translation>把从站的文件复制到本机文件</translation>
        </message>
        <message>
            <source>&amp;Write from File…</source>
            <translation>从文件写入(&amp;W)…</translation>
        </message>
        <message>
            <source>Give a file to the slave</source>
            <translation>把文件写入从站</translation>
        </message>
        <message>
            <source>&amp;Cancel</source>
            <translation>取消(&amp;C)</translation>
        </message>
        <message>
            <source>End the transfer</source>
            <translation>结束传输</translation>
        </message>
        <message>
            <source>Password</source>
            <translation>密码</translation>
        </message>
        <message>
            <source>The machine was started without files (FoE) for this slave: restart it with the project as it is now.</source>
            <translation>机器启动时该从站未启用文件访问 (FoE)：请用当前项目重新启动。</translation>
        </message>
        <message>
            <source>The slave is in %1: lead it to PREOP, or to BOOT.</source>
            <translation>从站处于 %1：请切换到 PREOP 或 BOOT。</translation>
        </message>
        <message>
            <source>%1: &quot;%2&quot; is being written, %3 of %4.</source>
            <translation>%1：正在写入“%2”，%3 / %4。</translation>
        </message>
        <message>
            <source>%1: &quot;%2&quot; is being read, %3 so far.</source>
            <translation>%1：正在读取“%2”，已读 %3。</translation>
        </message>
        <message>
            <source>The password is a number of 32 bits, such as 1234 or 0x12AB: &quot;%1&quot; is none.</source>
            <translation>密码是 32 位数字，例如 1234 或 0x12AB：“%1”不是。</translation>
        </message>
        <message>
            <source>Read File of the Slave</source>
            <translation>读取从站的文件</translation>
        </message>
        <message>
            <source>All files (*)</source>
            <translation>所有文件 (*)</translation>
        </message>
        <message>
            <source>Write File to the Slave</source>
            <translation>向从站写入文件</translation>
        </message>
        <message>
            <source>The file could not be read.</source>
            <translation>无法读取该文件。</translation>
        </message>
        <message>
            <source>Write %1 (%2) into %3 as &quot;%4&quot;?</source>
            <translation>把 %1（%2）作为“%4”写入 %3？</translation>
        </message>
        <message>
            <source>Nothing brings back what the slave has under this name now, and a wrong firmware can leave a slave that no longer comes up. The slave must keep its power until it is done.</source>
            <translation>从站中该名称下的现有内容将无法恢复，错误的固件可能使从站无法再启动。完成之前从站不得断电。</translation>
        </message>
        <message>
            <source>The slave is in %1: taking a file may stop it.</source>
            <translation>从站处于 %1：接收文件可能使其停止。</translation>
        </message>
        <message>
            <source>Write</source>
            <translation>写入</translation>
        </message>
        <message>
            <source>Cancelled: the slave has a part of it, or nothing</source>
            <translation>已取消：从站只收到一部分，或没有收到</translation>
        </message>
        <message>
            <source>Cancelled</source>
            <translation>已取消</translation>
        </message>
        <message>
            <source>Written</source>
            <translation>已写入</translation>
        </message>
        <message>
            <source>Read</source>
            <translation>已读取</translation>
        </message>
        <message>
            <source>&quot;%1&quot;: %2</source>
            <translation>“%1”：%2</translation>
        </message>
        <message>
            <source>write</source>
            <translation>写入</translation>
        </message>
        <message>
            <source>read</source>
            <translation>读取</translation>
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
            <source>%1: %2/s</source>
            <translation>%1：%2/s</translation>
        </message>
        <message>
            <source>no reading</source>
            <translation>无读数</translation>
        </message>
</context>
<context>
    <name>StatusPanel</name>
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
        <message>
            <source>Recording</source>
            <translation>记录</translation>
        </message>
        <message>
            <source>Recording %1</source>
            <translation>记录 %1</translation>
        </message>
        <message>
            <source>%1
%2 written, %3 left on the disk</source>
            <translation>%1
已写入 %2，磁盘剩余 %3</translation>
        </message>
        <message>
            <source>
%1 cycles are missing in it: the disk was too slow</source>
            <translation>
其中缺少 %1 个周期：磁盘太慢</translation>
        </message>
        <message numerus="yes">
            <source>%n bit(s) forced</source>
            <translation>
                <numerusform>%n 位被强制</numerusform>
            </translation>
        </message>
        <message>
            <source>Forced outputs</source>
            <translation>强制的输出</translation>
        </message>
        <message>
            <source>Outputs that somebody holds at a value by hand: the page Variables releases them</source>
            <translation>被人手动保持在某个值的输出：在“变量”页面释放</translation>
        </message>
        <message numerus="yes">
            <source>%n other network(s) online</source>
            <translation>
                <numerusform>另有 %n 个网络在线</numerusform>
            </translation>
        </message>
        <message>
            <source>Networks that run beside the one in work:</source>
            <translation>与当前网络同时运行的网络：</translation>
        </message>
        <message>
            <source>Other networks</source>
            <translation>其他网络</translation>
        </message>
        <message>
            <source>Black box</source>
            <translation>黑匣子</translation>
        </message>
        <message>
            <source>Black box ended</source>
            <translation>黑匣子已结束</translation>
        </message>
        <message>
            <source>Black box %1</source>
            <translation>黑匣子 %1</translation>
        </message>
        <message>
            <source>Slaves %1</source>
            <translation>从站 %1</translation>
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
        <message numerus="yes">
            <source>%n of %1 do(es) not answer</source>
            <translation><numerusform>%1 个中有 %n 个无应答</numerusform></translation>
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
            <translation>%1 的偏移</translation>
        </message>
        <message>
            <source>Shift</source>
            <translation>偏移</translation>
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
        <message>
            <source>Choose "User defined" above to set it.</source>
            <translation>在上方选择“自定义”后才能设置。</translation>
        </message>
        <message>
            <source>Cycle</source>
            <translation>周期</translation>
        </message>
</context>
<context>
    <name>TracePanel</name>
        <message>
            <source>project ±%1</source>
            <translation>项目 ±%1</translation>
        </message>
        <message>
            <source>Signal</source>
            <translation>信号</translation>
        </message>
        <message>
            <source>At A</source>
            <translation>A 处</translation>
        </message>
        <message>
            <source>At B</source>
            <translation>B 处</translation>
        </message>
        <message>
            <source>B−A</source>
            <translation>B−A</translation>
        </message>
        <message>
            <source>Smallest</source>
            <translation>最小</translation>
        </message>
        <message>
            <source>Largest</source>
            <translation>最大</translation>
        </message>
        <message>
            <source>Mean</source>
            <translation>平均</translation>
        </message>
        <message>
            <source>Samples</source>
            <translation>样本数</translation>
        </message>
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
        <message>
            <source>%1 (%2)</source>
            <translation>%1 (%2)</translation>
        </message>
        <message>
            <source>%1: %2   %3: %4</source>
            <translation>%1: %2   %3: %4</translation>
        </message>
        <message>
            <source>the limit of %1 is exceeded</source>
            <translation>超出 %1 的限值</translation>
        </message>
        <message>
            <source>the limit of %1 is kept</source>
            <translation>未超出 %1 的限值</translation>
        </message>
        <message>
            <source>Unit</source>
            <translation>单位</translation>
        </message>
        <message>
            <source>p99.9</source>
            <translation>p99.9</translation>
        </message>
        <message>
            <source>   p99.9 %1</source>
            <translation>   p99.9 %1</translation>
        </message>
</context>
<context>
    <name>TracePlot</name>
        <message>
            <source>Time since start − %1 s</source>
            <translation>自开始的时间 − %1 s</translation>
        </message>
        <message>
            <source>project ±%1</source>
            <translation>项目 ±%1</translation>
        </message>
        <message>
            <source>%1 (not linked)</source>
            <translation>%1（未联动）</translation>
        </message>
        <message>
            <source>UTC, %1</source>
            <translation>UTC，%1</translation>
        </message>
        <message>
            <source>Cycle</source>
            <translation>周期</translation>
        </message>
        <message>
            <source>System time: not known</source>
            <translation>系统时间：未知</translation>
        </message>
        <message>
            <source>System time − %1 s / s</source>
            <translation>系统时间 − %1 s / s</translation>
        </message>
        <message>
            <source>Time before now</source>
            <translation>距现在的时间</translation>
        </message>
        <message>
            <source>Time before the end</source>
            <translation>距结束的时间</translation>
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
    <name>VariablePanel</name>
        <message>
            <source>Variables</source>
            <translation>变量</translation>
        </message>
        <message>
            <source>Value</source>
            <translation>值</translation>
        </message>
        <message>
            <source>Variables of the process image in each cycle, as they are watched on the page Variables. Where a value did not come back there is a gap.</source>
            <translation>过程映像变量在每个周期的值，在“变量”页面上选择监视。未返回的值显示为间断。</translation>
        </message>
        <message>
            <source>not known in the range shown</source>
            <translation>在所示范围内未知</translation>
        </message>
        <message>
            <source>min %1   max %2</source>
            <translation>最小 %1   最大 %2</translation>
        </message>
</context>
<context>
    <name>VariablesRow</name>
        <message>
            <source>Watched variables</source>
            <translation>被监视的变量</translation>
        </message>
        <message>
            <source>Variables</source>
            <translation>变量</translation>
        </message>
        <message>
            <source>Switches</source>
            <translation>开关量</translation>
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
        <message>
            <source>Begin with the simulated demonstration machine, a bus, devices of the catalogue, or a project file.</source>
            <translation>从仿真的演示机器、总线、目录中的设备或项目文件开始。</translation>
        </message>
        <message>
            <source>New from a template of yours</source>
            <translation>从您的模板新建</translation>
        </message>
        <message numerus="yes">
            <source>%n more in New Machine</source>
            <translation>
                <numerusform>“新建机器”中还有 %n 个</numerusform>
            </translation>
        </message>
        <message>
            <source>New from the template %1</source>
            <translation>从模板 %1 新建</translation>
        </message>
        <message>
            <source>Remove the template %1</source>
            <translation>删除模板 %1</translation>
        </message>
        <message>
            <source>Remove this template</source>
            <translation>删除此模板</translation>
        </message>
</context>
<context>
    <name>Workspace</name>
        <message>
            <source>ENI</source>
            <translation>ENI</translation>
        </message>
        <message>
            <source>Note</source>
            <translation>注释</translation>
        </message>
        <message>
            <source>The machine is running: go offline to change its slaves.</source>
            <translation>机器正在运行：请先下线再更改其从站。</translation>
        </message>
        <message>
            <source>A recording is shown: close it to change the slaves of the project (File, Close Recording).</source>
            <translation>正在显示记录：请先关闭记录再更改项目的从站（文件，关闭记录）。</translation>
        </message>
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
        <message>
            <source>%1: %2</source>
            <translation>%1：%2</translation>
        </message>
        <message>
            <source>Monitor</source>
            <translation>监视器</translation>
        </message>
        <message>
            <source>Replay</source>
            <translation>回放</translation>
        </message>
        <message>
            <source>Controller log</source>
            <translation>控制器日志</translation>
        </message>
        <message>
            <source>Written to %1</source>
            <translation>正在写入 %1</translation>
        </message>
        <message>
            <source>Lies in %1</source>
            <translation>位于 %1</translation>
        </message>
        <message>
            <source>Master</source>
            <translation>主站</translation>
        </message>
        <message>
            <source>The master gives no sign of life: its thread hangs, or the adapter's driver does. What the slaves do now is not known, and no values are shown until it answers again. Go offline (Shift+F5); where it does not answer then either, restart the program.</source>
            <translation>主站没有任何响应：其线程或网卡驱动已挂起。从站现在的状态未知，在主站恢复应答之前不显示任何数值。请离线（Shift+F5）；若仍无应答，请重新启动程序。</translation>
        </message>
        <message>
            <source>The master answers again.</source>
            <translation>主站恢复应答。</translation>
        </message>
        <message>
            <source>The master did not go offline in time and is left to itself: the slaves may still be in OP, and it may still send. Make the machine safe by other means, and restart the program before you go online again.</source>
            <translation>主站未能及时离线，现任其自行运行：从站可能仍处于 OP，主站也可能仍在发送。请用其他方式使机器处于安全状态，并在再次上线前重新启动程序。</translation>
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
    <name>FindingTable</name>
        <message>
            <source>Error</source>
            <translation>错误</translation>
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
</context>
<context>
    <name>FindingModel</name>
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
            <source>A moment of a recording is shown. Findings are of the whole run: they stand at its end.</source>
            <translation>显示的是记录的某个时刻。检查结果针对整个运行：它们在记录末尾给出。</translation>
        </message>
        <message>
            <source>Findings about the project and the running bus</source>
            <translation>关于项目和运行中总线的诊断结果</translation>
        </message>
        <message>
            <source>Nothing found. What is wrong with the project, and what the running bus shows to be wrong, stands here with its cause and what to do.</source>
            <translation>未发现问题。项目中的错误以及运行中总线显示的问题会连同原因和处理办法列在这里。</translation>
        </message>
</context>
<context>
    <name>Setting</name>
    <message>
        <source>Not in the ENI: %1</source>
        <translation>不在 ENI 中：%1</translation>
    </message>
    <message>
        <source>Not in the ENI</source>
        <translation>不在 ENI 中</translation>
    </message>
    <message>
        <source>decided by the master that runs the bus</source>
        <translation>由运行总线的主站决定</translation>
    </message>
    <message>
        <source>done by the master as it sets up the clocks</source>
        <translation>由主站在设置时钟时完成</translation>
    </message>
    <message>
        <source>of the controller in the master that runs the bus</source>
        <translation>属于运行总线的主站中的控制器</translation>
    </message>
    <message>
        <source>judged by the master that runs the bus</source>
        <translation>由运行总线的主站判断</translation>
    </message>
    <message>
        <source>told by the master that runs the bus</source>
        <translation>由运行总线的主站通知</translation>
    </message>
    <message>
        <source>of the host that the master runs on</source>
        <translation>属于运行主站的主机</translation>
    </message>
    <message>
        <source>kept in the project alone</source>
        <translation>只保存在项目中</translation>
    </message>
    <message>
        <source>VoE message that is sent at these transitions, K counts from 0; the number behind the last adds one.</source>
        <translation>在这些转换时发送的 VoE 消息，K 从 0 计；最后一个之后的编号添加一个。</translation>
    </message>
    <message>
        <source>VoE start-up message</source>
        <translation>VoE 启动消息</translation>
    </message>
    <message>
        <source>FoE message that is sent at these transitions, K counts from 0; the number behind the last adds one.</source>
        <translation>在这些转换时发送的 FoE 消息，K 从 0 计；最后一个之后的编号添加一个。</translation>
    </message>
    <message>
        <source>FoE start-up message</source>
        <translation>FoE 启动消息</translation>
    </message>
    <message>
        <source>EoE message that is sent at these transitions, K counts from 0; the number behind the last adds one.</source>
        <translation>在这些转换时发送的 EoE 消息，K 从 0 计；最后一个之后的编号添加一个。</translation>
    </message>
    <message>
        <source>EoE start-up message</source>
        <translation>EoE 启动消息</translation>
    </message>
    <message>
        <source>AoE message that is sent at these transitions, K counts from 0; the number behind the last adds one.</source>
        <translation>在这些转换时发送的 AoE 消息，K 从 0 计；最后一个之后的编号添加一个。</translation>
    </message>
    <message>
        <source>AoE start-up message</source>
        <translation>AoE 启动消息</translation>
    </message>
    <message>
        <source>TRANSITIONS write REGISTER=HEX or read REGISTER*BYTES [expect=HEX] [mask=HEX] [within=MS] [off] [# comment]; nothing removes it</source>
        <translation>TRANSITIONS write REGISTER=HEX or read REGISTER*BYTES [expect=HEX] [mask=HEX] [within=MS] [off] [# 注释]；空则删除</translation>
    </message>
    <message>
        <source>TRANSITIONS write REGISTER=HEX or read REGISTER*BYTES [expect=HEX] [mask=HEX] [within=MS] [off] [after] [# comment]; nothing removes it</source>
        <translation>TRANSITIONS write REGISTER=HEX or read REGISTER*BYTES [expect=HEX] [mask=HEX] [within=MS] [off] [after] [# 注释]；空则删除</translation>
    </message>
    <message>
        <source>TRANSITIONS data=HEX [fixed] [off] [timeout=MS] [# comment]; nothing removes it</source>
        <translation>TRANSITIONS data=HEX [fixed] [off] [timeout=MS] [# 注释]；空则删除</translation>
    </message>
    <message>
        <source>Added to the SYNC0 shift of slaves that are based on the input reference.</source>
        <translation>加到基于输入参考的从站的 SYNC0 偏移上。</translation>
    </message>
    <message>
        <source>The input shift of the master is added to the shift of SYNC0, so that inputs are latched for the next frame; auto as in the ESI.</source>
        <translation>SYNC0 的偏移加上主站的输入偏移，使输入为下一帧锁存；auto 按 ESI。</translation>
    </message>
    <message>
        <source>Input reference</source>
        <translation>输入参考</translation>
    </message>
    <message>
        <source>Register of all slaves that is written or read at these transitions, K counts from 0; the number behind the last adds one.</source>
        <translation>在这些转换时写入或读取的所有从站的寄存器，K 从 0 计；最后一个之后的编号添加一个。</translation>
    </message>
    <message>
        <source>Register command of the master</source>
        <translation>主站的寄存器命令</translation>
    </message>
    <message>
        <source>Register of the slave that is written or read at these transitions, K counts from 0; the number behind the last adds one.</source>
        <translation>在这些转换时写入或读取的从站寄存器，K 从 0 计；最后一个之后的编号添加一个。</translation>
    </message>
    <message>
        <source>Register command</source>
        <translation>寄存器命令</translation>
    </message>
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
            <translation>分布式时钟</translation>
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
            <translation>总线偏移</translation>
        </message>
        <message>
            <source>Master shift</source>
            <translation>主站偏移</translation>
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
            <translation>由应用执行主站偏移</translation>
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
            <translation>整个总线的分布式时钟。</translation>
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
            <source>Distance from sending the cyclic frame to SYNC0; auto is two thirds of the cycle, and later on long buses.</source>
            <translation>从发送循环帧到 SYNC0 的间隔；自动表示周期的三分之二，总线较长时更晚。</translation>
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
            <translation>分布式时钟的操作模式；如果 ESI 为某个模式规定了自己的 PDO，也会一并分配。</translation>
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
            <translation>SYNC0 的偏移；自动同 ESI。</translation>
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
            <translation>SYNC1 的偏移；自动同 ESI。</translation>
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
            <source>Most of each wait that is spent asking the clock: earlier wake-ups for processor time. Used is what this host needs for 99 of 100 frames to leave at most 5 % of the cycle late, and at most a quarter of the cycle.</source>
            <translation>每次等待中最多用于查询时钟的时间：以处理器时间换取更早的唤醒。实际使用的是此主机使 100 帧中 99 帧的迟发不超过周期 5 % 所需的时间，最多为周期的四分之一。</translation>
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
            <source>Frames of that burst in one cycle; where cycles are longer than 1 ms, in a tenth of one or in 1 ms.</source>
            <translation>该突发在一个周期内的帧数；周期长于 1 ms 时，为周期的十分之一或 1 ms 内的帧数。</translation>
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
            <source>Processing minus forwarding latency of the ESCs (tDiff of their data sheets); auto is 40 ns at ports with a cable and 20 ns at E-bus.</source>
            <translation>ESC 的处理延迟减去转发延迟（数据手册中的 tDiff）；自动时带电缆的端口为 40 ns，E-bus 为 20 ns。</translation>
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
            <source>Exponent of the average over the time differences (0x0934); auto is 0, and 4 to 6 in front of the reference clock.</source>
            <translation>时间差平均值的指数 (0x0934)；自动为 0，参考时钟之前的从站为 4 至 6。</translation>
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
            <translation>报告分布式时钟已初始化，或未能初始化的原因。</translation>
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
            <translation>输入偏移</translation>
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
        <message>
            <source>1..255 bytes of text</source>
            <translation>1..255 字节文本</translation>
        </message>
        <message>
            <source>1..32 bytes of text</source>
            <translation>1..32 字节文本</translation>
        </message>
        <message>
            <source>six hexadecimal bytes with colons</source>
            <translation>以冒号分隔的六个十六进制字节</translation>
        </message>
        <message>
            <source>four numbers 0..255 with dots</source>
            <translation>以点分隔的四个 0..255 的数</translation>
        </message>
        <message>
            <source>six numbers 0..255 with dots</source>
            <translation>以点分隔的六个 0..255 的数</translation>
        </message>
        <message>
            <source>name of a master.sync_unit.K</source>
            <translation>某个 master.sync_unit.K 的名称</translation>
        </message>
        <message>
            <source>name of the group</source>
            <translation>组的名称</translation>
        </message>
        <message>
            <source>POSITION:A..D of another slave</source>
            <translation>另一从站的 POSITION:A..D</translation>
        </message>
        <message>
            <source>NAME xMULTIPLE, 1..1000 bus cycles; nothing removes it</source>
            <translation>NAME xMULTIPLE，1..1000 个总线周期；留空则删除</translation>
        </message>
        <message>
            <source>NAME, NAME@TASK; nothing removes it</source>
            <translation>NAME、NAME@TASK；留空则删除</translation>
        </message>
        <message>
            <source>TRANSITIONS DRIVE:IDN=HEX [fixed] [off] [timeout=MS] [# comment]; IDN like S-0-0047; nothing removes it</source>
            <translation>TRANSITIONS DRIVE:IDN=HEX [fixed] [off] [timeout=MS] [# 注释]；IDN 形如 S-0-0047；留空则删除</translation>
        </message>
        <message>
            <source>TRANSITIONS INDEX:SUB=HEX [complete] [fixed] [off] [adapt] [timeout=MS] [# comment]; nothing removes it</source>
            <translation>TRANSITIONS INDEX:SUB=HEX [complete] [fixed] [off] [adapt] [timeout=MS] [# 注释]；留空则删除</translation>
        </message>
        <message>
            <source>indices of the device with commas, or nothing</source>
            <translation>以逗号分隔的设备索引，或留空</translation>
        </message>
        <message>
            <source>INDEX:SUB:BITS with commas; INDEX 0 is padding</source>
            <translation>以逗号分隔的 INDEX:SUB:BITS；INDEX 0 为填充</translation>
        </message>
        <message>
            <source>0..last slave</source>
            <translation>0..最后一个从站</translation>
        </message>
        <message>
            <source>ident of a module that fits place K</source>
            <translation>适合位置 K 的模块标识</translation>
        </message>
        <message>
            <source>OSMin..OSMax of the PDO in the ESI</source>
            <translation>ESI 中该 PDO 的 OSMin..OSMax</translation>
        </message>
        <message>
            <source>a name of the ESI's OpMode</source>
            <translation>ESI 中 OpMode 的名称</translation>
        </message>
        <message>
            <source>words of the device family: nothing, sync0, frames, servo-period</source>
            <translation>设备系列的词：nothing、sync0、frames、servo-period</translation>
        </message>
        <message>
            <source>its device's</source>
            <translation>与其设备相同</translation>
        </message>
        <message>
            <source>1001 + N</source>
            <translation>1001 + N</translation>
        </message>
        <message>
            <source>the first of the ESI</source>
            <translation>ESI 中的第一个</translation>
        </message>
        <message>
            <source>those of the ESI</source>
            <translation>ESI 中的设定</translation>
        </message>
        <message>
            <source>nothing</source>
            <translation>空</translation>
        </message>
        <message>
            <source>Sync Unit Cycle of SYNC0</source>
            <translation>SYNC0 的同步单元周期</translation>
        </message>
        <message>
            <source>Cycle of SYNC0</source>
            <translation>SYNC0 的周期</translation>
        </message>
        <message>
            <source>Shift of SYNC0</source>
            <translation>SYNC0 的偏移</translation>
        </message>
        <message>
            <source>Sync Unit Cycle of SYNC1</source>
            <translation>SYNC1 的同步单元周期</translation>
        </message>
        <message>
            <source>Cycle of SYNC1</source>
            <translation>SYNC1 的周期</translation>
        </message>
        <message>
            <source>Shift of SYNC1</source>
            <translation>SYNC1 的偏移</translation>
        </message>
        <message>
            <source>Settle time of the window</source>
            <translation>窗口的稳定时间</translation>
        </message>
        <message>
            <source>Settle time of the controller</source>
            <translation>控制器的稳定时间</translation>
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
        <message>
            <source>Reset to &amp;default</source>
            <translation>恢复默认值(&amp;D)</translation>
        </message>
        <message>
            <source>Reset: %1</source>
            <translation>恢复默认：%1</translation>
        </message>
        <message>
            <source>Show in &amp;ENI</source>
            <translation>在 ENI 中显示(&amp;E)</translation>
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
            <translation>分布式时钟（专家）</translation>
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
            <source>Oversampling</source>
            <translation>过采样</translation>
        </message>
        <message>
            <source>Sync Units</source>
            <translation>同步单元</translation>
        </message>
</context>
<context>
    <name>SlaveModulesPage</name>
        <message>
            <source>Modules</source>
            <translation>模块</translation>
        </message>
        <message>
            <source>Modules in Slots</source>
            <translation>插槽中的模块</translation>
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
        <message>
            <source>Take %1 offline?</source>
            <translation>要使%1离线吗？</translation>
        </message>
        <message>
            <source>A slave is being written to, which ends unfinished.</source>
            <translation>正在写入一个从站，写入将中断而未完成。</translation>
        </message>
        <message>
            <source>A slave is being written to. Go offline all the same?</source>
            <translation>正在写入一个从站。仍要离线吗？</translation>
        </message>
        <message>
            <source>An EEPROM gets back what it held; a slave that has half of a file may not come up any more.</source>
            <translation>EEPROM 会恢复原有内容；只收到半个文件的从站可能无法再启动。</translation>
        </message>
        <message>
            <source>The slaves may still be in OP.</source>
            <translation>从站可能仍处于 OP。</translation>
        </message>
        <message>
            <source>The master did not go offline in time: it ends with the program, and nobody has taken the slaves to INIT. Make the machine safe by other means.</source>
            <translation>主站未能及时离线：它将随程序一起结束，且没有将从站切换到 INIT。请用其他方式使机器处于安全状态。</translation>
        </message>
</context>
<context>
    <name>SlaveStartupPage</name>
    <message>
        <source>Behind the slaves' commands of the transition instead of before them (ENI InitCmd/BeforeSlave)</source>
        <translation>排在该转换的从站命令之后而不是之前（ENI InitCmd/BeforeSlave）</translation>
    </message>
    <message>
        <source>After the slaves</source>
        <translation>在从站之后</translation>
    </message>
    <message>
        <source>Bits of the expected value that count, in hexadecimal; empty: all (ENI Validate/DataMask)</source>
        <translation>期望值中参与比较的位，十六进制；空：全部（ENI Validate/DataMask）</translation>
    </message>
    <message>
        <source>Mask</source>
        <translation>掩码</translation>
    </message>
    <message>
        <source>What a read has to bring, in hexadecimal; empty: anything (ENI Validate/Data)</source>
        <translation>读取应得到的值，十六进制；空：任意（ENI Validate/Data）</translation>
    </message>
    <message>
        <source>Expected</source>
        <translation>期望值</translation>
    </message>
    <message>
        <source>Write: bytes in hexadecimal, in the order of the wire; read: how many bytes (ENI InitCmd/Data)</source>
        <translation>写：十六进制字节，按线上顺序；读：字节数（ENI InitCmd/Data）</translation>
    </message>
    <message>
        <source>Data</source>
        <translation>数据</translation>
    </message>
    <message>
        <source>Byte address in the ESC: 0x09A8 (ENI InitCmd/Ado)</source>
        <translation>ESC 中的字节地址：0x09A8（ENI InitCmd/Ado）</translation>
    </message>
    <message>
        <source>Register</source>
        <translation>寄存器</translation>
    </message>
    <message>
        <source>Off: the command stays in the project and is not in the ENI</source>
        <translation>关：命令保留在项目中，不写入 ENI</translation>
    </message>
    <message>
        <source>Written or read; of a slave by its station address, of the master to all slaves (ENI InitCmd/Cmd)</source>
        <translation>写或读；从站按其站地址，主站则面向所有从站（ENI InitCmd/Cmd）</translation>
    </message>
    <message>
        <source>Direction</source>
        <translation>方向</translation>
    </message>
    <message>
        <source>ms for the expected value to come (ENI Validate/Timeout)</source>
        <translation>等待期望值的毫秒数（ENI Validate/Timeout）</translation>
    </message>
    <message>
        <source>Within</source>
        <translation>时限</translation>
    </message>
    <message>
        <source>a write has at least one byte</source>
        <translation>写入至少一个字节</translation>
    </message>
    <message>
        <source>a read takes 1 to %1 bytes</source>
        <translation>一次读取为 1 到 %1 字节</translation>
    </message>
    <message>
        <source>"%1" is no register like 0x09A8</source>
        <translation>“%1”不是形如 0x09A8 的寄存器</translation>
    </message>
    <message>
        <source>Read</source>
        <translation>读</translation>
    </message>
    <message>
        <source>Write</source>
        <translation>写</translation>
    </message>
    <message>
        <source>Message</source>
        <translation>消息</translation>
    </message>
    <message>
        <source>What follows the mailbox header, hexadecimal, in the order of the wire (ENI InitCmd/Data)</source>
        <translation>邮箱头之后的内容，十六进制，按线上顺序（ENI InitCmd/Data）</translation>
    </message>
    <message>
        <source>FoE request, hexadecimal, in the order of the wire (ENI InitCmd/Data)</source>
        <translation>FoE 请求，十六进制，按线上顺序（ENI InitCmd/Data）</translation>
    </message>
    <message>
        <source>EoE header and data, hexadecimal, in the order of the wire (ENI InitCmd/Data)</source>
        <translation>EoE 头和数据，十六进制，按线上顺序（ENI InitCmd/Data）</translation>
    </message>
    <message>
        <source>AoE header and data, hexadecimal, in the order of the wire (ENI InitCmd/Data)</source>
        <translation>AoE 头和数据，十六进制，按线上顺序（ENI InitCmd/Data）</translation>
    </message>
    <message>
        <source>own</source>
        <translation>自有</translation>
    </message>
    <message>
        <source>ESI</source>
        <translation>ESI</translation>
    </message>
    <message>
        <source>ESI: as the device's description has it; own: added or changed here</source>
        <translation>ESI：与设备描述一致；自有：在此添加或更改</translation>
    </message>
    <message>
        <source>Origin</source>
        <translation>来源</translation>
    </message>
    <message>
        <source>start-up message</source>
        <translation>启动消息</translation>
    </message>
    <message>
        <source>Messages (%1)</source>
        <translation>消息（%1）</translation>
    </message>
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
        <message>
            <source>What is sent otherwise than listed</source>
            <translation>与列表不同的实际发送内容</translation>
        </message>
        <message>
            <source>Sent for a bus cycle of %1, otherwise than listed: %2.</source>
            <translation>总线周期为 %1 时，实际发送与列表不同：%2。</translation>
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
            <source>Bus: %1. Beside the project: %2.</source>
            <translation>总线：%1。与项目相比：%2。</translation>
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
        <message>
            <source>At position %1; in the project at %2</source>
            <translation>位于位置 %1；项目中位于 %2</translation>
        </message>
        <message>
            <source>Connected to %1; in the project to %2</source>
            <translation>连接到 %1；项目中连接到 %2</translation>
        </message>
        <message>
            <source>Vendor %1, product %2 instead of %3, %4</source>
            <translation>厂商 %1、产品 %2，而不是 %3、%4</translation>
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
            <source>None: the slaves share their datagrams. Once there is a unit, slaves are dragged to it below.</source>
            <translation>无：从站共用数据报。有同步单元后，可在下方将从站拖入。</translation>
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
        <source>none</source>
        <translation>无</translation>
    </message>
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
            <source>The machine does not run what the project says: %n change(s).</source>
            <translation>
                <numerusform>机器运行的配置与项目不同：%n 处更改。</numerusform>
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
        <message>
            <source>The machine does not run what the project says.</source>
            <translation>机器运行的不是项目中所写的内容。</translation>
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
<context>
    <name>Overview</name>
        <message>
            <source>An event without words</source>
            <translation>没有文字说明的事件</translation>
        </message>
        <message numerus="yes">
            <source>%n SM2 event(s) missed</source>
            <translation>
                <numerusform>错过 %n 个 SM2 事件</numerusform>
            </translation>
        </message>
        <message>
            <source> (%1 times)</source>
            <translation>（%1 次）</translation>
        </message>
        <message>
            <source>for %1</source>
            <translation>已 %1</translation>
        </message>
        <message>
            <source>, not lost since armed</source>
            <translation>，重新计数以来未失步</translation>
        </message>
        <message numerus="yes">
            <source>, last lost %1 ago, %n time(s)</source>
            <translation>
                <numerusform>，最近一次失步在 %1 前，共 %n 次</numerusform>
            </translation>
        </message>
        <message>
            <source>&lt;b&gt;Not armed yet:&lt;/b&gt; figures and faults count once the machine is in OP, and in sync where that is watched.</source>
            <translation>&lt;b&gt;尚未启用：&lt;/b&gt;机器进入 OP，且所监视的项目均已同步后，才开始统计数值和故障。</translation>
        </message>
        <message>
            <source>slaves: %1</source>
            <translation>从站：%1</translation>
        </message>
        <message>
            <source>master: %1</source>
            <translation>主站：%1</translation>
        </message>
        <message>
            <source>Now: %1.</source>
            <translation>目前：%1。</translation>
        </message>
        <message>
            <source>Found so far: &lt;b&gt;%1&lt;/b&gt;</source>
            <translation>目前发现：&lt;b&gt;%1&lt;/b&gt;</translation>
        </message>
        <message>
            <source>&lt;b&gt;First: %1&lt;/b&gt; at %2.</source>
            <translation>&lt;b&gt;首先：%1&lt;/b&gt;，时间 %2。</translation>
        </message>
        <message>
            <source> Then %1</source>
            <translation> 随后 %1</translation>
        </message>
        <message>
            <source>; %1 more</source>
            <translation>；另有 %1 个</translation>
        </message>
        <message>
            <source>%1 s</source>
            <translation>%1 s</translation>
        </message>
        <message>
            <source> Not over: %1.</source>
            <translation> 尚未结束：%1。</translation>
        </message>
        <message>
            <source> It is episode %1 of %2 since %3.</source>
            <translation> 这是自 %3 以来 %2 次中的第 %1 次。</translation>
        </message>
        <message>
            <source>&lt;b&gt;First: %1&lt;/b&gt; at %2, until %3.</source>
            <translation>&lt;b&gt;最先：%1&lt;/b&gt;，发生于 %2，持续到 %3。</translation>
        </message>
        <message>
            <source>&lt;b&gt;First: %1&lt;/b&gt; at %2, and it is not over.</source>
            <translation>&lt;b&gt;最先：%1&lt;/b&gt;，发生于 %2，尚未结束。</translation>
        </message>
        <message>
            <source>in the same cycle</source>
            <translation>在同一周期内</translation>
        </message>
        <message numerus="yes">
            <source>%n cycle(s) before</source>
            <translation><numerusform>%n 个周期之前</numerusform></translation>
        </message>
        <message>
            <source>%1 before</source>
            <translation>%1 之前</translation>
        </message>
        <message numerus="yes">
            <source>%n cycle(s) later</source>
            <translation><numerusform>%n 个周期之后</numerusform></translation>
        </message>
        <message>
            <source>%1 later</source>
            <translation>%1 之后</translation>
        </message>
        <message>
            <source>%1 %2</source>
            <comment>when, what</comment>
            <translation>%1 %2</translation>
        </message>
        <message>
            <source> Seen %1.</source>
            <translation> 可见于 %1。</translation>
        </message>
        <message numerus="yes">
            <source>%n slave(s) do(es) not answer</source>
            <translation><numerusform>%n 个从站无应答</numerusform></translation>
        </message>
        <message>
            <source>&lt;b&gt;No fault&lt;/b&gt; for %2, since %1 of the run.</source>
            <translation>自运行的 %1 起，%2 内&lt;b&gt;无故障&lt;/b&gt;。</translation>
        </message>
        <message>
            <source>&lt;b&gt;Nothing fell or was lost&lt;/b&gt; for %2, since %1 of the run, but &lt;b&gt;%3&lt;/b&gt;</source>
            <translation>自运行的 %1 起，%2 内&lt;b&gt;没有掉线或丢失&lt;/b&gt;，但是 &lt;b&gt;%3&lt;/b&gt;</translation>
        </message>
</context>
<context>
    <name>Recorded</name>
        <message>
            <source>Master</source>
            <translation>主站</translation>
        </message>
        <message>
            <source>cut short; whole up to its last second</source>
            <translation>中断；直到最后一秒都完整</translation>
        </message>
        <message>
            <source>up to the end of the run</source>
            <translation>直到运行结束</translation>
        </message>
        <message>
            <source>stopped by the user</source>
            <translation>由用户停止</translation>
        </message>
        <message>
            <source>the last stretch out of memory</source>
            <translation>内存中的最近一段</translation>
        </message>
        <message>
            <source>Note</source>
            <translation>提示</translation>
        </message>
        <message>
            <source>%1 s</source>
            <translation>%1 s</translation>
        </message>
        <message>
            <source>%1 min %2 s</source>
            <translation>%1 min %2 s</translation>
        </message>
        <message>
            <source>%1 h %2 min</source>
            <translation>%1 h %2 min</translation>
        </message>
        <message>
            <source>a machine</source>
            <translation>一台机器</translation>
        </message>
        <message>
            <source>%1 on %2, %3, %4 in %5 cycles of %6, %7</source>
            <translation>%1，位于 %2，%3，%6 的 %5 个周期中共 %4，%7</translation>
        </message>
        <message>
            <source>; %1 cycles are missing in it</source>
            <translation>；其中缺少 %1 个周期</translation>
        </message>
        <message>
            <source>; the plots show the last %1 of them</source>
            <translation>；曲线显示其最近的 %1</translation>
        </message>
        <message>
            <source>up to the end of the file</source>
            <translation>直到文件末尾</translation>
        </message>
        <message>
            <source>an imported run</source>
            <translation>导入的运行</translation>
        </message>
</context>
<context>
    <name>FigureCard</name>
        <message>
            <source>Margin: %1</source>
            <translation>裕量：%1</translation>
        </message>
        <message>
            <source>%1: %2</source>
            <translation>%1：%2</translation>
        </message>
</context>
<context>
    <name>OverviewPanel</name>
        <message>
            <source>mean</source>
            <translation>平均</translation>
        </message>
        <message>
            <source>Since it was armed</source>
            <translation>自启用起</translation>
        </message>
        <message>
            <source>rms</source>
            <translation>rms</translation>
        </message>
        <message>
            <source>Root mean square about zero, since it was armed</source>
            <translation>相对零的均方根，自启用起</translation>
        </message>
        <message>
            <source>p99.99</source>
            <translation>p99.99</translation>
        </message>
        <message>
            <source>Of 10,000 cycles one is larger; magnitude, since it was armed</source>
            <translation>10,000 个周期中有一个更大；绝对值，自启用起</translation>
        </message>
        <message>
            <source>max</source>
            <translation>最大</translation>
        </message>
        <message>
            <source>Largest magnitude of all cycles since it was armed</source>
            <translation>自启用起所有周期的最大绝对值</translation>
        </message>
        <message>
            <source>Slaves in sync</source>
            <translation>从站同步</translation>
        </message>
        <message>
            <source>Master in sync</source>
            <translation>主站同步</translation>
        </message>
        <message>
            <source>Slaves: since when</source>
            <translation>从站：自何时起</translation>
        </message>
        <message>
            <source>Master: since when</source>
            <translation>主站：自何时起</translation>
        </message>
        <message>
            <source>DC deviation</source>
            <translation>DC 偏差</translation>
        </message>
        <message>
            <source>Register 0x092C of the slaves that follow the reference clock: the largest. With ≤ it is what the wire has or-ed of all of them: none is off by more, and perhaps none by so much</source>
            <translation>跟随参考时钟的从站的寄存器 0x092C：最大值。带 ≤ 时是线路对全部数值按位或的结果：没有从站偏差更大，也许都没有这么大</translation>
        </message>
        <message>
            <source>SM2 events missed</source>
            <translation>错过的 SM2 事件</translation>
        </message>
        <message>
            <source>Object 0x1C32:0B or 0x1C32:0C of the slaves that have one, since it was armed</source>
            <translation>具有该计数器的从站的对象 0x1C32:0B 或 0x1C32:0C，自启用起</translation>
        </message>
        <message>
            <source>DCM error</source>
            <translation>DCM 误差</translation>
        </message>
        <message>
            <source>Re-arm</source>
            <translation>重新启用</translation>
        </message>
        <message>
            <source>Begin figures and faults anew</source>
            <translation>数值和故障重新开始</translation>
        </message>
        <message>
            <source>Overview</source>
            <translation>总览</translation>
        </message>
        <message>
            <source>worst</source>
            <translation>最差</translation>
        </message>
        <message>
            <source>The slave that has missed most</source>
            <translation>错过最多的从站</translation>
        </message>
        <message>
            <source>last</source>
            <translation>最近</translation>
        </message>
        <message>
            <source>When one was missed last</source>
            <translation>最近一次错过的时间</translation>
        </message>
        <message>
            <source>counted</source>
            <translation>计数时长</translation>
        </message>
        <message>
            <source>For how long figures and faults have been counted</source>
            <translation>数值和故障已统计多长时间</translation>
        </message>
        <message>
            <source>In sync?</source>
            <translation>是否同步？</translation>
        </message>
        <message>
            <source>The verdicts on slaves and master</source>
            <translation>对从站和主站的判定</translation>
        </message>
        <message>
            <source>Mean, rms, quantile, maximum, missed events and faults begin anew now</source>
            <translation>平均值、rms、分位数、最大值、错过的事件和故障从现在重新开始</translation>
        </message>
        <message>
            <source>Slaves</source>
            <translation>从站</translation>
        </message>
        <message>
            <source>Master</source>
            <translation>主站</translation>
        </message>
        <message>
            <source>Offline</source>
            <translation>离线</translation>
        </message>
        <message>
            <source>At the end: %1</source>
            <translation>结束时：%1</translation>
        </message>
        <message>
            <source>%1 at %2</source>
            <translation>%1，时间 %2</translation>
        </message>
        <message>
            <source>no limit is set</source>
            <translation>未设置限值</translation>
        </message>
        <message>
            <source>limit ±%1</source>
            <translation>限值 ±%1</translation>
        </message>
        <message>
            <source>%1 % over the limit ±%2</source>
            <translation>超出限值 ±%2 达 %1 %</translation>
        </message>
        <message>
            <source>%1 % margin to ±%2</source>
            <translation>距 ±%2 有 %1 % 的裕量</translation>
        </message>
        <message>
            <source>no slave has this counter</source>
            <translation>没有从站具有此计数器</translation>
        </message>
        <message>
            <source>none</source>
            <translation>无</translation>
        </message>
        <message>
            <source>not counted yet</source>
            <translation>尚未计数</translation>
        </message>
        <message>
            <source>SYNC0 came without new outputs</source>
            <translation>SYNC0 到来时没有新的输出</translation>
        </message>
        <message>
            <source>A recording stays as it is</source>
            <translation>记录保持不变</translation>
        </message>
        <message>
            <source>Nothing has run yet: go online.</source>
            <translation>尚未运行：请先上线。</translation>
        </message>
        <message>
            <source>%1 times the limit ±%2</source>
            <translation>限值 ±%2 的 %1 倍</translation>
        </message>
        <message>
            <source>Export and copy</source>
            <translation>导出和复制</translation>
        </message>
        <message>
            <source>Export picture…</source>
            <translation>导出图片…</translation>
        </message>
        <message>
            <source>Export the overview</source>
            <translation>导出概览</translation>
        </message>
        <message>
            <source>Copy picture</source>
            <translation>复制图片</translation>
        </message>
        <message>
            <source>Copy figures</source>
            <translation>复制数值</translation>
        </message>
        <message>
            <source>Slaves in OP</source>
            <translation>处于 OP 的从站</translation>
        </message>
        <message>
            <source>Time of the frame at the reference clock minus its wanted time in the cycle. The margin is that of the filtered error as far as it has lasted for 200 ms: what is over before is no loss of synchronisation</source>
            <translation>帧到达参考时钟的时刻减去其在周期中的期望时刻。裕量取自持续 200 ms 的滤波误差：在此之前就结束的偏差不算失去同步</translation>
        </message>
        <message>
            <source>the others: %1</source>
            <translation>其余：%1</translation>
        </message>
        <message>
            <source>%1 of %2 slaves in OP</source>
            <translation>%2 个从站中有 %1 个处于 OP</translation>
        </message>
        <message numerus="yes">
            <source>%n do(es) not answer</source>
            <translation><numerusform>%n 个无应答</numerusform></translation>
        </message>
        <message numerus="yes">
            <source>lost %n time(s)</source>
            <translation><numerusform>失去 %n 次</numerusform></translation>
        </message>
        <message>
            <source>filtered, lasting: %1</source>
            <translation>滤波后持续：%1</translation>
        </message>
        <message>
            <source>DCM error (raw)</source>
            <translation>DCM 误差（原始）</translation>
        </message>
</context>
<context>
    <name>RecordingBar</name>
        <message>
            <source>Recording that is shown</source>
            <translation>显示的记录</translation>
        </message>
        <message>
            <source>Close</source>
            <translation>关闭</translation>
        </message>
        <message>
            <source>Close the recording</source>
            <translation>关闭记录</translation>
        </message>
        <message>
            <source>Shows the project and its machine again</source>
            <translation>重新显示项目及其机器</translation>
        </message>
        <message>
            <source>Recording %1 (not live): %2</source>
            <translation>记录 %1（非实时）：%2</translation>
        </message>
</context>
<context>
    <name>RecordingCommands</name>
        <message>
            <source>Recording of the Capture</source>
            <translation>抓包的记录</translation>
        </message>
        <message>
            <source>Captures (*.pcap *.pcapng *.cap);;All files (*)</source>
            <translation>抓包 (*.pcap *.pcapng *.cap);;所有文件 (*)</translation>
        </message>
        <message>
            <source>Import a Capture</source>
            <translation>导入抓包</translation>
        </message>
        <message>
            <source>Change Note</source>
            <translation>更改注释</translation>
        </message>
        <message>
            <source>Add Note</source>
            <translation>添加注释</translation>
        </message>
        <message>
            <source>At %1 (empty takes the note away):</source>
            <translation>在 %1（留空则删除该注释）：</translation>
        </message>
        <message>
            <source>At %1:</source>
            <translation>在 %1：</translation>
        </message>
        <message>
            <source>The note could not be written.</source>
            <translation>无法写入注释。</translation>
        </message>
        <message>
            <source>Save the Episode</source>
            <translation>保存片段</translation>
        </message>
        <message>
            <source>Open Recording</source>
            <translation>打开记录</translation>
        </message>
        <message>
            <source>A recording is shown in its place.</source>
            <translation>将显示一份记录来代替它。</translation>
        </message>
        <message>
            <source>Open</source>
            <translation>打开</translation>
        </message>
        <message>
            <source>The recording %1 could not be opened.</source>
            <translation>无法打开记录 %1。</translation>
        </message>
        <message>
            <source>Recordings (*.slrec)</source>
            <translation>记录 (*.slrec)</translation>
        </message>
        <message>
            <source>Recording</source>
            <translation>记录</translation>
        </message>
        <message>
            <source>Record</source>
            <translation>记录</translation>
        </message>
        <message>
            <source>The recording could not be started.</source>
            <translation>无法开始记录。</translation>
        </message>
        <message>
            <source>Recording to %1</source>
            <translation>正在记录到 %1</translation>
        </message>
        <message>
            <source>The recording %1 has ended: %2</source>
            <translation>记录 %1 已结束：%2</translation>
        </message>
        <message>
            <source>Recorded to %1</source>
            <translation>已记录到 %1</translation>
        </message>
        <message>
            <source>Save the &amp;Last…</source>
            <translation>保存最近一段(&amp;L)…</translation>
        </message>
        <message>
            <source>Save the &amp;Last %1…</source>
            <translation>保存最近 %1(&amp;L)…</translation>
        </message>
        <message>
            <source>All that is in memory: %1</source>
            <translation>内存中的全部：%1</translation>
        </message>
        <message>
            <source>The last %1</source>
            <translation>最近 %1</translation>
        </message>
        <message>
            <source>Save the Last</source>
            <translation>保存最近一段</translation>
        </message>
        <message>
            <source>The memory holds every cycle of the last %1 at most. Save:</source>
            <translation>内存最多保存最近 %1 的每个周期。保存：</translation>
        </message>
        <message>
            <source>Nothing could be saved.</source>
            <translation>没有可保存的内容。</translation>
        </message>
        <message>
            <source>The last stretch could not be saved.</source>
            <translation>无法保存最近一段。</translation>
        </message>
        <message>
            <source>Saved to %1</source>
            <translation>已保存到 %1</translation>
        </message>
        <message>
            <source>Black box</source>
            <translation>黑匣子</translation>
        </message>
</context>
<context>
    <name>Dictionary</name>
        <message>
            <source>write in %1</source>
            <translation>在 %1 中可写</translation>
        </message>
        <message>
            <source>text of at most %1</source>
            <translation>最多 %1 的文本</translation>
        </message>
        <message>
            <source>%1 to %2</source>
            <translation>%1 至 %2</translation>
        </message>
</context>
<context>
    <name>DictionaryReader</name>
        <message>
            <source>The slave does not tell its objects.</source>
            <translation>该从站不提供其对象信息。</translation>
        </message>
</context>
<context>
    <name>ObjectModel</name>
        <message>
            <source>Ticked entries are watched</source>
            <translation>勾选的条目会被监视</translation>
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
            <source>Access</source>
            <translation>访问</translation>
        </message>
        <message>
            <source>Unit</source>
            <translation>单元</translation>
        </message>
        <message>
            <source>Value</source>
            <translation>值</translation>
        </message>
        <message>
            <source>Hex</source>
            <translation>十六进制</translation>
        </message>
        <message>
            <source>%1, read from the slave</source>
            <translation>%1，从从站读取</translation>
        </message>
        <message>
            <source>Not read yet</source>
            <translation>尚未读取</translation>
        </message>
        <message>
            <source>%1, the default: not read yet</source>
            <translation>%1，默认值：尚未读取</translation>
        </message>
        <message>
            <source>Default</source>
            <translation>默认值</translation>
        </message>
</context>
<context>
    <name>ObjectWriteBar</name>
        <message>
            <source>New value</source>
            <translation>新值</translation>
        </message>
        <message>
            <source>Values with names</source>
            <translation>带名称的值</translation>
        </message>
        <message>
            <source>&amp;Write</source>
            <translation>写入(&amp;W)</translation>
        </message>
        <message>
            <source>Write the value</source>
            <translation>写入该值</translation>
        </message>
        <message>
            <source>Not possible; %1</source>
            <translation>不可行；%1</translation>
        </message>
</context>
<context>
    <name>OnlinePage</name>
        <message>
            <source>Offline. Go online (F5), in whatever state, to ask the slave itself.</source>
            <translation>离线。上线 (F5) 后，无论何种状态都可查询从站本身。</translation>
        </message>
        <message>
            <source>The bus is going offline.</source>
            <translation>总线正在下线。</translation>
        </message>
        <message>
            <source>The machine was started without this slave: restart it with the project as it is now.</source>
            <translation>机器启动时没有此从站：请用当前的项目重新启动机器。</translation>
        </message>
        <message>
            <source>The bus is starting.</source>
            <translation>总线正在启动。</translation>
        </message>
        <message>
            <source>The slave does not answer: check its power and the cable in front of it.</source>
            <translation>从站没有应答：请检查其电源和其前面的电缆。</translation>
        </message>
        <message>
            <source>%1 is in %2. %3</source>
            <translation>%1 处于 %2。%3</translation>
        </message>
        <message>
            <source>What became of the last request</source>
            <translation>最近一次请求的结果</translation>
        </message>
        <message>
            <source>The master does not answer.</source>
            <translation>主站无应答。</translation>
        </message>
</context>
<context>
    <name>SlaveObjectsPage</name>
        <message>
            <source>Objects</source>
            <translation>对象</translation>
        </message>
        <message>
            <source>Where the objects are described</source>
            <translation>对象描述的来源</translation>
        </message>
        <message>
            <source>From the ESI</source>
            <translation>来自 ESI</translation>
        </message>
        <message>
            <source>From the slave: all</source>
            <translation>来自从站：全部</translation>
        </message>
        <message>
            <source>From the slave: RxPDO</source>
            <translation>来自从站：RxPDO</translation>
        </message>
        <message>
            <source>From the slave: TxPDO</source>
            <translation>来自从站：TxPDO</translation>
        </message>
        <message>
            <source>From the slave: to be stored</source>
            <translation>来自从站：需存储</translation>
        </message>
        <message>
            <source>From the slave: start-up</source>
            <translation>来自从站：启动</translation>
        </message>
        <message>
            <source>The slave tells its objects by SDO information (ETG.1000.6, 5.6.3)</source>
            <translation>从站通过 SDO 信息提供其对象 (ETG.1000.6, 5.6.3)</translation>
        </message>
        <message>
            <source>Search objects</source>
            <translation>搜索对象</translation>
        </message>
        <message>
            <source>Index, name or value</source>
            <translation>索引、名称或值</translation>
        </message>
        <message>
            <source>Watched only</source>
            <translation>仅监视项</translation>
        </message>
        <message>
            <source>Show watched entries only</source>
            <translation>仅显示被监视的条目</translation>
        </message>
        <message>
            <source>Objects of the slave</source>
            <translation>从站的对象</translation>
        </message>
        <message>
            <source>Copy</source>
            <translation>复制</translation>
        </message>
        <message>
            <source>&amp;Read</source>
            <translation>读取(&amp;R)</translation>
        </message>
        <message>
            <source>Read the selected objects</source>
            <translation>读取所选对象</translation>
        </message>
        <message>
            <source>Read &amp;All Shown</source>
            <translation>读取全部显示项(&amp;A)</translation>
        </message>
        <message>
            <source>Read all entries that are shown</source>
            <translation>读取显示的所有条目</translation>
        </message>
        <message>
            <source>How often watched entries are read</source>
            <translation>被监视条目的读取间隔</translation>
        </message>
        <message>
            <source>Watched: on demand</source>
            <translation>监视：按需</translation>
        </message>
        <message>
            <source>Watched: every %1 s</source>
            <translation>监视：每 %1 s</translation>
        </message>
        <message>
            <source>Stop</source>
            <translation>停止</translation>
        </message>
        <message>
            <source>Stop reading</source>
            <translation>停止读取</translation>
        </message>
        <message>
            <source>&amp;CSV…</source>
            <translation>CSV(&amp;C)…</translation>
        </message>
        <message>
            <source>Export the shown objects as comma separated values</source>
            <translation>将显示的对象导出为逗号分隔值</translation>
        </message>
        <message>
            <source>%1 of %2 objects</source>
            <translation>%2 个对象中的 %1 个</translation>
        </message>
        <message numerus="yes">
            <source>%n object(s)</source>
            <translation>
                <numerusform>%n 个对象</numerusform>
            </translation>
        </message>
        <message>
            <source>This slave does not speak CoE: it has no objects. Its registers and EEPROM can be read all the same.</source>
            <translation>此从站不支持 CoE：没有对象。其寄存器和 EEPROM 仍可读取。</translation>
        </message>
        <message>
            <source>Objects can be read from PREOP on: lead the slave there first.</source>
            <translation>从 PREOP 起才能读取对象：请先将从站切换到该状态。</translation>
        </message>
        <message>
            <source>The ESI describes no objects: choose &quot;From the slave&quot; when online.</source>
            <translation>ESI 没有描述对象：请在上线后选择“来自从站”。</translation>
        </message>
        <message>
            <source>The slave is asked for its objects.</source>
            <translation>正在查询从站的对象。</translation>
        </message>
        <message>
            <source>Choose an entry to write a value.</source>
            <translation>选择条目以写入值。</translation>
        </message>
        <message>
            <source>%1 cannot be written.</source>
            <translation>%1 不可写。</translation>
        </message>
        <message>
            <source>Nothing that can be read is selected.</source>
            <translation>所选内容中没有可读取的。</translation>
        </message>
        <message>
            <source>%1 of %2 entries</source>
            <translation>%2 个条目中的 %1 个</translation>
        </message>
        <message>
            <source>%1 of %2 entries; the others say why in their line</source>
            <translation>%2 个条目中的 %1 个；其余条目在各自的行中说明原因</translation>
        </message>
        <message>
            <source>The slave acts upon the new value at once.</source>
            <translation>从站会立即按新值动作。</translation>
        </message>
        <message>
            <source>The object is in the process data: the master writes it in each cycle and will overwrite this.</source>
            <translation>该对象在过程数据中：主站每个周期都写入它，会覆盖此值。</translation>
        </message>
        <message>
            <source>Write %1 to %2?</source>
            <translation>将 %1 写入 %2？</translation>
        </message>
        <message>
            <source>Write</source>
            <translation>写入</translation>
        </message>
        <message>
            <source>%1 is written.</source>
            <translation>%1 已写入。</translation>
        </message>
        <message>
            <source>Written, but not to be read back: %1</source>
            <translation>已写入，但无法回读：%1</translation>
        </message>
        <message>
            <source>%1 is %2 now.</source>
            <translation>%1 现为 %2。</translation>
        </message>
        <message>
            <source>Written, but the slave has made %1 of it.</source>
            <translation>已写入，但从站将其变为 %1。</translation>
        </message>
        <message>
            <source>Stopped.</source>
            <translation>已停止。</translation>
        </message>
        <message>
            <source>Export Objects</source>
            <translation>导出对象</translation>
        </message>
        <message>
            <source>Comma-separated values (*.csv)</source>
            <translation>逗号分隔值 (*.csv)</translation>
        </message>
        <message>
            <source>The objects could not be exported.</source>
            <translation>无法导出对象。</translation>
        </message>
        <message>
            <source>Favourites</source>
            <translation>收藏</translation>
        </message>
        <message>
            <source>Objects that are watched in every device of this kind, also in other projects</source>
            <translation>在此类设备中始终监视的对象，也适用于其他项目</translation>
        </message>
        <message numerus="yes">
            <source>&amp;Watch %n favourite(s) of %1</source>
            <translation>
                <numerusform>监视 %1 的 %n 个收藏对象(&amp;W)</numerusform>
            </translation>
        </message>
        <message>
            <source>&amp;Make the watched entries the favourites of %1</source>
            <translation>将所监视的条目设为 %1 的收藏(&amp;M)</translation>
        </message>
        <message>
            <source>&amp;Forget the favourites of %1</source>
            <translation>清除 %1 的收藏(&amp;F)</translation>
        </message>
        <message>
            <source>No favourites of %1 yet</source>
            <translation>尚无 %1 的收藏</translation>
        </message>
</context>
<context>
    <name>SlaveRequests</name>
        <message>
            <source>Cancelled.</source>
            <translation>已取消。</translation>
        </message>
        <message>
            <source>The bus is offline: go online first (F5).</source>
            <translation>总线离线：请先上线 (F5)。</translation>
        </message>
</context>
<context>
    <name>SlaveStateBar</name>
        <message>
            <source>AL status of the slave</source>
            <translation>从站的 AL 状态</translation>
        </message>
        <message>
            <source>Acknowledge Error</source>
            <translation>确认错误</translation>
        </message>
        <message>
            <source>Acknowledge the error</source>
            <translation>确认该错误</translation>
        </message>
        <message>
            <source>Writes the error acknowledge bit (0x0120 bit 4); the slave stays in its state</source>
            <translation>写入错误确认位（0x0120 第 4 位）；从站停留在其状态</translation>
        </message>
        <message>
            <source>Request %1 of this slave</source>
            <translation>为此从站请求 %1</translation>
        </message>
        <message>
            <source>Leads this slave alone to %1, with its init commands (register 0x0120)</source>
            <translation>仅将此从站切换到 %1，并执行其启动命令（寄存器 0x0120）</translation>
        </message>
        <message>
            <source>The machine was started without this slave.</source>
            <translation>机器启动时没有此从站。</translation>
        </message>
        <message>
            <source>No answer (register 0x0130)</source>
            <translation>无应答（寄存器 0x0130）</translation>
        </message>
        <message>
            <source>AL status %1: %2</source>
            <translation>AL 状态 %1：%2</translation>
        </message>
</context>
<context>
    <name>SlaveStateCommands</name>
        <message>
            <source>Go online first (F5).</source>
            <translation>请先上线 (F5)。</translation>
        </message>
        <message>
            <source>The machine was started without this slave.</source>
            <translation>机器启动时没有此从站。</translation>
        </message>
        <message>
            <source>The slave does not answer.</source>
            <translation>从站没有应答。</translation>
        </message>
        <message>
            <source>The whole bus is in INIT: request PREOP or more for all first.</source>
            <translation>整个总线处于 INIT：请先为所有从站请求 PREOP 或更高状态。</translation>
        </message>
        <message>
            <source>Its outputs stop and its inputs are no longer valid. The other slaves go on, and the master expects the working counter without it.</source>
            <translation>其输出停止，输入不再有效。其他从站继续运行，主站期望的工作计数器不再包含它。</translation>
        </message>
        <message>
            <source>It stays where you lead it: automatic recovery brings back only slaves that were lost or fell by themselves. A request of a state for the whole bus takes it along again.</source>
            <translation>它停留在所切换到的状态：自动恢复只处理丢失或自行跌落的从站。为整个总线请求状态时会再次带上它。</translation>
        </message>
        <message>
            <source>The machine runs. Take %1 to %2?</source>
            <translation>机器正在运行。要将 %1 切换到 %2 吗？</translation>
        </message>
        <message>
            <source>Take to %1</source>
            <translation>切换到 %1</translation>
        </message>
        <message>
            <source>%1 is requested.</source>
            <translation>已请求 %1。</translation>
        </message>
        <message>
            <source>It is in %1.</source>
            <translation>现处于 %1。</translation>
        </message>
        <message>
            <source>The error is acknowledged; now request the state that it shall have.</source>
            <translation>错误已确认；现在请请求它应有的状态。</translation>
        </message>
        <message>
            <source>Acknowledge Error</source>
            <translation>确认错误</translation>
        </message>
</context>
<context>
    <name>Counters</name>
        <message>
            <source>at least %1</source>
            <translation>至少 %1</translation>
        </message>
        <message>
            <source> (+%1 in 10 s)</source>
            <translation>（10 s 内 +%1）</translation>
        </message>
        <message>
            <source>%1 s ago</source>
            <translation>%1 s 前</translation>
        </message>
</context>
<context>
    <name>EepromLines</name>
        <message>
            <source>Checksum of the configuration</source>
            <translation>配置的校验和</translation>
        </message>
        <message>
            <source>right</source>
            <translation>正确</translation>
        </message>
        <message>
            <source>WRONG: the ESC does not load it</source>
            <translation>错误：ESC 不会加载</translation>
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
            <source>Size</source>
            <translation>大小</translation>
        </message>
        <message>
            <source>PDI control</source>
            <translation>PDI 控制</translation>
        </message>
        <message>
            <source>PDI configuration</source>
            <translation>PDI 配置</translation>
        </message>
        <message>
            <source>Pulse length of SYNC signals</source>
            <translation>SYNC 信号的脉冲长度</translation>
        </message>
        <message>
            <source>Mailbox to the slave (SM0)</source>
            <translation>发往从站的邮箱 (SM0)</translation>
        </message>
        <message>
            <source>Mailbox from the slave (SM1)</source>
            <translation>来自从站的邮箱 (SM1)</translation>
        </message>
        <message>
            <source>In BOOT to the slave</source>
            <translation>BOOT 中发往从站</translation>
        </message>
        <message>
            <source>In BOOT from the slave</source>
            <translation>BOOT 中来自从站</translation>
        </message>
        <message>
            <source>Mailbox protocols</source>
            <translation>邮箱协议</translation>
        </message>
        <message>
            <source>Name</source>
            <translation>名称</translation>
        </message>
        <message>
            <source>Order number</source>
            <translation>订货号</translation>
        </message>
        <message>
            <source>Group</source>
            <translation>组</translation>
        </message>
        <message>
            <source>E-bus current</source>
            <translation>E-bus 电流</translation>
        </message>
        <message>
            <source>%1, control %2</source>
            <translation>%1，控制 %2</translation>
        </message>
        <message>
            <source>Distributed clocks: %1</source>
            <translation>分布式时钟：%1</translation>
        </message>
        <message>
            <source>AssignActivate %1, SYNC0 %2, shift %3</source>
            <translation>AssignActivate %1，SYNC0 %2，偏移 %3</translation>
        </message>
        <message>
            <source>Outputs</source>
            <translation>输出</translation>
        </message>
        <message>
            <source>Inputs</source>
            <translation>输入</translation>
        </message>
        <message>
            <source>Mailbox state</source>
            <translation>邮箱状态</translation>
        </message>
        <message>
            <source>Category %1</source>
            <translation>类别 %1</translation>
        </message>
</context>
<context>
    <name>RegisterModel</name>
        <message>
            <source>Address</source>
            <translation>地址</translation>
        </message>
        <message>
            <source>Register</source>
            <translation>寄存器</translation>
        </message>
        <message>
            <source>Value</source>
            <translation>值</translation>
        </message>
        <message>
            <source>Hex</source>
            <translation>十六进制</translation>
        </message>
        <message>
            <source>Age</source>
            <translation>时效</translation>
        </message>
        <message>
            <source>%1 s</source>
            <translation>%1 s</translation>
        </message>
        <message>
            <source>last run</source>
            <translation>上次运行</translation>
        </message>
</context>
<context>
    <name>SlaveCountersPage</name>
        <message>
            <source>Port</source>
            <translation>端口</translation>
        </message>
        <message>
            <source>Invalid frames</source>
            <translation>无效帧</translation>
        </message>
        <message>
            <source>Receive errors</source>
            <translation>接收错误</translation>
        </message>
        <message>
            <source>Forwarded errors</source>
            <translation>转发错误</translation>
        </message>
        <message>
            <source>Lost links</source>
            <translation>链路丢失</translation>
        </message>
        <message>
            <source>Counter</source>
            <translation>计数器</translation>
        </message>
        <message>
            <source>Total</source>
            <translation>总计</translation>
        </message>
        <message>
            <source>Register</source>
            <translation>寄存器</translation>
        </message>
        <message>
            <source>Read</source>
            <translation>读取</translation>
        </message>
        <message>
            <source>Error counters of the ports</source>
            <translation>端口的错误计数器</translation>
        </message>
        <message>
            <source>Other counters</source>
            <translation>其他计数器</translation>
        </message>
        <message>
            <source>Counts since going online, or since the statistics were cleared. Invalid frames at a port: the fault is on the cable or the plug at this port. Forwarded errors alone: it is further in front.</source>
            <translation>自上线或清除统计以来的计数。端口上有无效帧：故障在此端口的电缆或插头处。只有转发错误：故障在更前面。</translation>
        </message>
        <message>
            <source>not yet</source>
            <translation>尚未</translation>
        </message>
        <message>
            <source>in the last run</source>
            <translation>在上次运行中</translation>
        </message>
        <message>
            <source>Read: %1 (registers 0x0300 to 0x0313)</source>
            <translation>读取：%1（寄存器 0x0300 至 0x0313）</translation>
        </message>
        <message>
            <source>Port %1 (%2)</source>
            <translation>端口 %1 (%2)</translation>
        </message>
        <message>
            <source>Processing unit errors</source>
            <translation>处理单元错误</translation>
        </message>
        <message>
            <source>PDI errors</source>
            <translation>PDI 错误</translation>
        </message>
        <message>
            <source>Process data watchdog expired</source>
            <translation>过程数据看门狗超时</translation>
        </message>
        <message>
            <source>PDI watchdog expired</source>
            <translation>PDI 看门狗超时</translation>
        </message>
        <message>
            <source>Counters</source>
            <translation>计数器</translation>
        </message>
</context>
<context>
    <name>SlaveEepromPage</name>
        <message>
            <source>EEPROM</source>
            <translation>EEPROM</translation>
        </message>
        <message>
            <source>Part</source>
            <translation>部分</translation>
        </message>
        <message>
            <source>Value</source>
            <translation>值</translation>
        </message>
        <message>
            <source>What the EEPROM says</source>
            <translation>EEPROM 的内容</translation>
        </message>
        <message>
            <source>Bytes of the EEPROM</source>
            <translation>EEPROM 的字节</translation>
        </message>
        <message>
            <source>Not read yet</source>
            <translation>尚未读取</translation>
        </message>
        <message>
            <source>&amp;Read</source>
            <translation>读取(&amp;R)</translation>
        </message>
        <message>
            <source>Read the whole EEPROM</source>
            <translation>读取整个 EEPROM</translation>
        </message>
        <message>
            <source>&amp;Save…</source>
            <translation>保存(&amp;S)…</translation>
        </message>
        <message>
            <source>Copy the EEPROM into a file</source>
            <translation>将 EEPROM 复制到文件</translation>
        </message>
        <message>
            <source>New alias</source>
            <translation>新别名</translation>
        </message>
        <message>
            <source>&amp;Write Alias…</source>
            <translation>写入别名(&amp;W)…</translation>
        </message>
        <message>
            <source>Write the alias into the EEPROM</source>
            <translation>将别名写入 EEPROM</translation>
        </message>
        <message>
            <source>Write &amp;Image…</source>
            <translation>写入映像(&amp;I)…</translation>
        </message>
        <message>
            <source>Write a file into the EEPROM</source>
            <translation>将文件写入 EEPROM</translation>
        </message>
        <message>
            <source>Alias</source>
            <translation>别名</translation>
        </message>
        <message>
            <source>%1 of %2</source>
            <translation>%1 / %2</translation>
        </message>
        <message>
            <source>Save EEPROM</source>
            <translation>保存 EEPROM</translation>
        </message>
        <message>
            <source>EEPROM images (*.bin)</source>
            <translation>EEPROM 映像 (*.bin)</translation>
        </message>
        <message>
            <source>The EEPROM could not be saved.</source>
            <translation>无法保存 EEPROM。</translation>
        </message>
        <message>
            <source>Write alias %1 into the EEPROM of %2?</source>
            <translation>将别名 %1 写入 %2 的 EEPROM？</translation>
        </message>
        <message>
            <source>It is written with its checksum and read back; the machine goes on. The slave takes it at its next power-on: until then 0x0012 shows the old one.</source>
            <translation>将连同校验和一起写入并回读；机器继续运行。从站在下次上电时采用：在此之前 0x0012 显示旧别名。</translation>
        </message>
        <message>
            <source>Write</source>
            <translation>写入</translation>
        </message>
        <message>
            <source>Alias %1 is in the EEPROM and read back. The slave takes it at its next power-on.</source>
            <translation>别名 %1 已写入 EEPROM 并回读。从站在下次上电时采用。</translation>
        </message>
        <message>
            <source>Write EEPROM Image</source>
            <translation>写入 EEPROM 映像</translation>
        </message>
        <message>
            <source>EEPROM images (*.bin);;All files (*)</source>
            <translation>EEPROM 映像 (*.bin);;所有文件 (*)</translation>
        </message>
        <message>
            <source>The image could not be read.</source>
            <translation>无法读取该映像。</translation>
        </message>
        <message>
            <source>The image does not fit: it has %1, the EEPROM %2.</source>
            <translation>该映像不匹配：映像为 %1，EEPROM 为 %2。</translation>
        </message>
        <message>
            <source>Words that differ are written and read back; when one fails, all are put back. A wrong image can leave a slave that no longer comes up.</source>
            <translation>写入并回读不同的字；有一个失败则全部恢复。错误的映像可能使从站无法再启动。</translation>
        </message>
        <message>
            <source>The image is of another device (%1, product %2).</source>
            <translation>该映像属于另一设备（%1，产品 %2）。</translation>
        </message>
        <message>
            <source>Write this image into the EEPROM of %1?</source>
            <translation>将此映像写入 %1 的 EEPROM？</translation>
        </message>
        <message>
            <source>The image is in the EEPROM and read back. The slave takes it at its next power-on.</source>
            <translation>映像已写入 EEPROM 并回读。从站在下次上电时采用。</translation>
        </message>
        <message>
            <source>The EEPROM is being written.</source>
            <translation>正在写入 EEPROM。</translation>
        </message>
        <message>
            <source>%1 of %2 words are written.</source>
            <translation>已写入 %2 个字中的 %1 个。</translation>
        </message>
</context>
<context>
    <name>SlaveRegistersPage</name>
        <message>
            <source>Registers</source>
            <translation>寄存器</translation>
        </message>
        <message>
            <source>Registers of the slave</source>
            <translation>从站的寄存器</translation>
        </message>
        <message>
            <source>Which registers are shown and read</source>
            <translation>显示和读取哪些寄存器</translation>
        </message>
        <message>
            <source>All registers</source>
            <translation>所有寄存器</translation>
        </message>
        <message>
            <source>Search registers</source>
            <translation>搜索寄存器</translation>
        </message>
        <message>
            <source>Address or name</source>
            <translation>地址或名称</translation>
        </message>
        <message>
            <source>&amp;Read Shown</source>
            <translation>读取显示项(&amp;R)</translation>
        </message>
        <message>
            <source>Read the registers that are shown</source>
            <translation>读取显示的寄存器</translation>
        </message>
        <message>
            <source>Read &amp;One</source>
            <translation>读取一个(&amp;O)</translation>
        </message>
        <message>
            <source>Read the selected register</source>
            <translation>读取所选寄存器</translation>
        </message>
        <message>
            <source>How often the shown registers are read</source>
            <translation>显示的寄存器的读取间隔</translation>
        </message>
        <message>
            <source>On demand</source>
            <translation>按需</translation>
        </message>
        <message>
            <source>Every %1 s</source>
            <translation>每 %1 s</translation>
        </message>
        <message>
            <source>New value, decimal or with 0x</source>
            <translation>新值，十进制或以 0x 开头</translation>
        </message>
        <message>
            <source>&amp;Write…</source>
            <translation>写入(&amp;W)…</translation>
        </message>
        <message>
            <source>Write the register</source>
            <translation>写入该寄存器</translation>
        </message>
        <message>
            <source>Choose a register to write it.</source>
            <translation>选择寄存器以写入。</translation>
        </message>
        <message>
            <source>No register is shown that could be read along: choose one and read it alone.</source>
            <translation>显示的寄存器中没有可一起读取的：请选择一个单独读取。</translation>
        </message>
        <message>
            <source>Choose a register first.</source>
            <translation>请先选择寄存器。</translation>
        </message>
        <message>
            <source>not in this ESC</source>
            <translation>此 ESC 没有</translation>
        </message>
        <message>
            <source>Write %1 to register %2?</source>
            <translation>将 %1 写入寄存器 %2？</translation>
        </message>
        <message>
            <source>The master has set this slave up and counts on its registers. A wrong value can stop the slave or the bus behind it, and nothing but going online anew puts it back.</source>
            <translation>主站已设置此从站并依赖其寄存器。错误的值可能使从站或其后的总线停止，只有重新上线才能恢复。</translation>
        </message>
        <message>
            <source>Write</source>
            <translation>写入</translation>
        </message>
        <message>
            <source>%1 is written.</source>
            <translation>%1 已写入。</translation>
        </message>
        <message>
            <source>Written, but not to be read back: %1</source>
            <translation>已写入，但无法回读：%1</translation>
        </message>
        <message>
            <source>%1 is %2 now.</source>
            <translation>%1 现为 %2。</translation>
        </message>
        <message>
            <source>Written, but the register shows %1.</source>
            <translation>已写入，但寄存器显示 %1。</translation>
        </message>
</context>
<context>
    <name>CatalogueModel</name>
        <message>
            <source>Other devices</source>
            <translation>其他设备</translation>
        </message>
        <message>
            <source>Device</source>
            <translation>设备</translation>
        </message>
        <message>
            <source>%1, revision %2</source>
            <translation>%1，版本号 %2</translation>
        </message>
        <message>
            <source>%1
Product code %2, revision %3
%4</source>
            <translation>%1
产品代码 %2，版本号 %3
%4</translation>
        </message>
        <message>
            <source>Revision</source>
            <translation>版本号</translation>
        </message>
</context>
<context>
    <name>CataloguePanel</name>
        <message>
            <source>Search the device catalogue</source>
            <translation>搜索设备目录</translation>
        </message>
        <message>
            <source>Vendor, type, name or product code</source>
            <translation>供应商、类型、名称或产品代码</translation>
        </message>
        <message>
            <source>Beginnings of words of the vendor, group, type, name or product code; all must occur.
A revision: #x00120000, or rev 18 as it is printed on the device; several: rev 16-18, rev 16-</source>
            <translation>供应商、组、类型、名称或产品代码的词首；须全部出现。
修订版本：#x00120000，或设备上印刷的 rev 18；多个：rev 16-18、rev 16-</translation>
        </message>
        <message>
            <source>All revisions</source>
            <translation>所有版本</translation>
        </message>
        <message>
            <source>Show older revisions below each device, and devices that their vendor hides</source>
            <translation>在每个设备下显示旧版本，以及被供应商隐藏的设备</translation>
        </message>
        <message>
            <source>Devices of the catalogue</source>
            <translation>目录中的设备</translation>
        </message>
        <message>
            <source>The selected device</source>
            <translation>所选设备</translation>
        </message>
        <message>
            <source>Number of devices</source>
            <translation>设备数量</translation>
        </message>
        <message>
            <source>Reading of device descriptions</source>
            <translation>设备描述的读取</translation>
        </message>
        <message>
            <source>Add to Machine</source>
            <translation>添加到机器</translation>
        </message>
        <message>
            <source>Add the device behind the selected slave</source>
            <translation>将设备添加到所选从站之后</translation>
        </message>
        <message>
            <source>Add the device behind the slave that is selected in the explorer (Enter, or drag it there)</source>
            <translation>将设备添加到浏览器中所选从站之后（Enter，或拖到那里）</translation>
        </message>
        <message>
            <source>Read ESI…</source>
            <translation>读取 ESI…</translation>
        </message>
        <message>
            <source>Read ESI files into the catalogue</source>
            <translation>将 ESI 文件读入目录</translation>
        </message>
        <message>
            <source>Read device descriptions of vendors into the catalogue</source>
            <translation>将供应商的设备描述读入目录</translation>
        </message>
        <message>
            <source>Files…</source>
            <translation>文件…</translation>
        </message>
        <message>
            <source>Folder…</source>
            <translation>文件夹…</translation>
        </message>
        <message>
            <source>Cancel</source>
            <translation>取消</translation>
        </message>
        <message>
            <source>End reading; what was read is kept, the rest is read at the next start</source>
            <translation>结束读取；已读取的保留，其余在下次启动时读取</translation>
        </message>
        <message>
            <source>Reading %1 (%2 of %3)</source>
            <translation>正在读取 %1 (%2 / %3)</translation>
        </message>
        <message>
            <source>The catalogue is empty: read the ESI files of your devices.</source>
            <translation>目录为空：请读取设备的 ESI 文件。</translation>
        </message>
        <message numerus="yes">
            <source>None of the %n device(s) has all these words.</source>
            <translation>
                <numerusform>%n 个设备中没有一个包含所有这些词。</numerusform>
            </translation>
        </message>
        <message>
            <source>The first %1 of %2 devices: type more.</source>
            <translation>%2 个设备中的前 %1 个：请输入更多。</translation>
        </message>
        <message>
            <source>%1 of %2 devices and revisions</source>
            <translation>%2 个设备和版本中的 %1 个</translation>
        </message>
        <message>
            <source>Select a device to see what is known of it.</source>
            <translation>选择一个设备以查看其已知信息。</translation>
        </message>
        <message>
            <source>%1, product code %2</source>
            <translation>%1，产品代码 %2</translation>
        </message>
        <message>
            <source>Revision %1, ports %2</source>
            <translation>版本号 %1，端口 %2</translation>
        </message>
        <message>
            <source>Revision rule %1</source>
            <translation>版本规则 %1</translation>
        </message>
        <message>
            <source>Hidden by its vendor</source>
            <translation>被供应商隐藏</translation>
        </message>
        <message>
            <source>Read ESI Files</source>
            <translation>读取 ESI 文件</translation>
        </message>
        <message>
            <source>Device descriptions (*.xml);;All files (*)</source>
            <translation>设备描述 (*.xml);;所有文件 (*)</translation>
        </message>
        <message>
            <source>Read a Folder of ESI Files</source>
            <translation>读取 ESI 文件的文件夹</translation>
        </message>
</context>
<context>
    <name>GoToDialog</name>
        <message>
            <source>Go To</source>
            <translation>转到</translation>
        </message>
        <message>
            <source>What can be gone to</source>
            <translation>可转到的目标</translation>
        </message>
        <message>
            <source>the master</source>
            <translation>主站</translation>
        </message>
        <message>
            <source>slave %1, address %2, %3</source>
            <translation>从站 %1，地址 %2，%3</translation>
        </message>
        <message>
            <source>setting</source>
            <translation>设置</translation>
        </message>
        <message>
            <source>command</source>
            <translation>命令</translation>
        </message>
        <message>
            <source>Slave, setting, object or command to go to</source>
            <translation>要转到的从站、设置、对象或命令</translation>
        </message>
        <message>
            <source>A slave, a setting or its key, an object (6040, name), a command</source>
            <translation>从站、设置或其键、对象（6040、名称）、命令</translation>
        </message>
        <message>
            <source>Nothing fits. Slaves are found by name, position, address and type, settings by label and key, objects of their ESI by index and name.</source>
            <translation>没有匹配项。可按名称、位置、地址和类型查找从站，按标签和键查找设置，按索引和名称查找其 ESI 中的对象。</translation>
        </message>
</context>
<context>
    <name>MachineBuilding</name>
        <message numerus="yes">
            <source>%n new device(s) are in the catalogue.</source>
            <translation>
                <numerusform>目录中有 %n 个新设备。</numerusform>
            </translation>
        </message>
        <message>
            <source>Device Catalogue</source>
            <translation>设备目录</translation>
        </message>
        <message>
            <source>Catalogue</source>
            <translation>目录</translation>
        </message>
</context>
<context>
    <name>ReplaceDialog</name>
        <message numerus="yes">
            <source>%1 and %n more</source>
            <translation>
                <numerusform>%1 以及另外 %n 项</numerusform>
            </translation>
        </message>
        <message>
            <source>Replace %1</source>
            <translation>替换 %1</translation>
        </message>
        <message>
            <source>Now: %1, revision %2</source>
            <translation>当前：%1，版本号 %2</translation>
        </message>
        <message>
            <source>Search for another device</source>
            <translation>搜索其他设备</translation>
        </message>
        <message>
            <source>Its revisions are listed; type to search for another device</source>
            <translation>列出其各版本；输入即可搜索其他设备</translation>
        </message>
        <message>
            <source>What it can be replaced by</source>
            <translation>可替换为</translation>
        </message>
        <message>
            <source>What changes</source>
            <translation>变化内容</translation>
        </message>
        <message>
            <source>Replace</source>
            <translation>替换</translation>
        </message>
        <message>
            <source>%1, revision %2</source>
            <translation>%1，版本号 %2</translation>
        </message>
        <message>
            <source>The catalogue has no such device: read its ESI file, or type another name.</source>
            <translation>目录中没有这样的设备：请读取其 ESI 文件，或输入其他名称。</translation>
        </message>
        <message>
            <source>Choose one to see what changes.</source>
            <translation>选择一个以查看变化内容。</translation>
        </message>
        <message>
            <source>Reading…</source>
            <translation>正在读取…</translation>
        </message>
        <message>
            <source>All settings stay.</source>
            <translation>所有设置保留。</translation>
        </message>
        <message>
            <source>It does not take: %1. Everything else stays.</source>
            <translation>它不接受：%1。其余全部保留。</translation>
        </message>
</context>
<context>
    <name>SlaveCommands</name>
        <message>
            <source>&amp;Add Device…</source>
            <translation>添加设备(&amp;A)…</translation>
        </message>
        <message>
            <source>Choose a device in the catalogue for behind the selected slave</source>
            <translation>在目录中选择要接在所选从站之后的设备</translation>
        </message>
        <message>
            <source>&amp;Duplicate</source>
            <translation>复制(&amp;D)</translation>
        </message>
        <message>
            <source>Put a copy behind the slave, with its branches</source>
            <translation>在该从站之后放置其副本，包括分支</translation>
        </message>
        <message>
            <source>&amp;Move Up</source>
            <translation>上移(&amp;M)</translation>
        </message>
        <message>
            <source>Change places with the slave before it in its line</source>
            <translation>与同一线路中的前一从站互换位置</translation>
        </message>
        <message>
            <source>Move Do&amp;wn</source>
            <translation>下移(&amp;W)</translation>
        </message>
        <message>
            <source>Change places with the slave behind it in its line</source>
            <translation>与同一线路中的后一从站互换位置</translation>
        </message>
        <message>
            <source>Re&amp;place…</source>
            <translation>替换(&amp;P)…</translation>
        </message>
        <message>
            <source>Put another revision or another device in its place</source>
            <translation>用另一版本或另一设备替换</translation>
        </message>
        <message>
            <source>Remo&amp;ve</source>
            <translation>移除(&amp;V)</translation>
        </message>
        <message>
            <source>Take the slave with its branches out; its line closes</source>
            <translation>移除该从站及其分支；线路随之闭合</translation>
        </message>
        <message>
            <source>Duplicate %1</source>
            <translation>复制 %1</translation>
        </message>
        <message>
            <source>Move %1</source>
            <translation>移动 %1</translation>
        </message>
        <message>
            <source>Catalogue</source>
            <translation>目录</translation>
        </message>
        <message>
            <source>The description of the device could not be read.</source>
            <translation>无法读取设备的描述。</translation>
        </message>
        <message>
            <source>Add %1</source>
            <translation>添加 %1</translation>
        </message>
        <message>
            <source>Rewire %1</source>
            <translation>改接 %1</translation>
        </message>
        <message>
            <source>Remove %1</source>
            <translation>移除 %1</translation>
        </message>
        <message numerus="yes">
            <source>%1 was removed with %n slave(s) of its branches.</source>
            <translation>
                <numerusform>已移除 %1 及其分支上的 %n 个从站。</numerusform>
            </translation>
        </message>
        <message>
            <source>Replace %1</source>
            <translation>替换 %1</translation>
        </message>
        <message numerus="yes">
            <source>%n setting(s) of the old device are gone; undo brings them back.</source>
            <translation>
                <numerusform>旧设备的 %n 项设置已丢失；可用“撤销”恢复。</numerusform>
            </translation>
        </message>
        <message>
            <source>The slave is gone.</source>
            <translation>该从站已不存在。</translation>
        </message>
        <message>
            <source>No free port there, or nearer to the master, takes this device.</source>
            <translation>该处及更靠近主站处都没有空闲端口可接此设备。</translation>
        </message>
        <message>
            <source>That port is not free.</source>
            <translation>该端口未空闲。</translation>
        </message>
        <message>
            <source>A terminal needs an E-bus port, a device with a cable an Ethernet port.</source>
            <translation>端子模块需要 E-bus 端口，带电缆的设备需要以太网端口。</translation>
        </message>
        <message>
            <source>It has no port for what would hang behind it.</source>
            <translation>它没有端口来连接其后的设备。</translation>
        </message>
        <message>
            <source>That place is behind the slave itself.</source>
            <translation>该位置在此从站自身之后。</translation>
        </message>
        <message>
            <source>The slave stands first in its line.</source>
            <translation>该从站位于其线路的首位。</translation>
        </message>
        <message>
            <source>The slave stands last in its line.</source>
            <translation>该从站位于其线路的末位。</translation>
        </message>
        <message>
            <source>A network has at most 65535 slaves.</source>
            <translation>一个网络最多有 65535 个从站。</translation>
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
</context>
<context>
    <name>DistributionView</name>
        <message>
            <source>each bar %1 wide</source>
            <translation>每个柱宽 %1</translation>
        </message>
        <message>
            <source>Reference clock against external clock</source>
            <translation>参考时钟与外部时钟之差</translation>
        </message>
        <message>
            <source>Doubt of the send stamp</source>
            <translation>发送时间戳的不确定度</translation>
        </message>
        <message>
            <source>Distribution</source>
            <translation>分布</translation>
        </message>
        <message>
            <source>Signals of the distribution</source>
            <translation>分布的信号</translation>
        </message>
        <message>
            <source>Samples that count</source>
            <translation>计入的采样</translation>
        </message>
        <message>
            <source>Value axis of the distribution</source>
            <translation>分布的数值轴</translation>
        </message>
        <message>
            <source>All values</source>
            <translation>全部数值</translation>
        </message>
        <message>
            <source>Up to twice the limit</source>
            <translation>至限值的两倍</translation>
        </message>
        <message>
            <source>State of the distribution</source>
            <translation>分布的状态</translation>
        </message>
        <message>
            <source>Quantiles</source>
            <translation>分位数</translation>
        </message>
        <message>
            <source>50 %</source>
            <translation>50 %</translation>
        </message>
        <message>
            <source>99 %</source>
            <translation>99 %</translation>
        </message>
        <message>
            <source>99.9 %</source>
            <translation>99.9 %</translation>
        </message>
        <message>
            <source>99.99 %</source>
            <translation>99.99 %</translation>
        </message>
        <message>
            <source>Largest</source>
            <translation>最大</translation>
        </message>
        <message>
            <source>Samples</source>
            <translation>采样数</translation>
        </message>
        <message>
            <source>Samples of the bin</source>
            <translation>该区间的采样</translation>
        </message>
        <message>
            <source>The latest samples of the bin; a double click shows the moment in the plots</source>
            <translation>该区间最近的采样；双击可在曲线中显示该时刻</translation>
        </message>
        <message>
            <source>Computing, %1 %</source>
            <translation>正在计算，%1 %</translation>
        </message>
        <message>
            <source>Time since start</source>
            <translation>自开始的时间</translation>
        </message>
        <message>
            <source>Value</source>
            <translation>数值</translation>
        </message>
        <message>
            <source>%1 s</source>
            <translation>%1 s</translation>
        </message>
        <message>
            <source>Send lateness</source>
            <translation>发送延迟</translation>
        </message>
        <message>
            <source>Round trip</source>
            <translation>往返时间</translation>
        </message>
        <message>
            <source>DCM error</source>
            <translation>DCM 误差</translation>
        </message>
        <message>
            <source>DCM error, filtered</source>
            <translation>DCM 误差（滤波后）</translation>
        </message>
        <message>
            <source>DCM error with lateness</source>
            <translation>DCM 误差（含延迟）</translation>
        </message>
        <message>
            <source>Drift</source>
            <translation>漂移</translation>
        </message>
        <message>
            <source>Adjustment</source>
            <translation>调整量</translation>
        </message>
        <message>
            <source>Largest deviation</source>
            <translation>最大偏差</translation>
        </message>
        <message>
            <source>Deviation, or-ed (upper estimate)</source>
            <translation>偏差（按位或，上限估计）</translation>
        </message>
        <message>
            <source>Network to slave</source>
            <translation>网络到从站</translation>
        </message>
        <message>
            <source>Master to network</source>
            <translation>主站到网络</translation>
        </message>
        <message>
            <source>Frame late by</source>
            <translation>帧迟到时间</translation>
        </message>
        <message>
            <source>Deviation</source>
            <translation>偏差</translation>
        </message>
        <message>
            <source>Arrival phase</source>
            <translation>到达相位</translation>
        </message>
        <message>
            <source>%1 (%2)</source>
            <translation>%1 (%2)</translation>
        </message>
        <message>
            <source>Learned by the controller, a cycle</source>
            <translation>控制器学到的每周期量</translation>
        </message>
        <message>
            <source>All adjustments</source>
            <translation>全部调整量</translation>
        </message>
</context>
<context>
    <name>SampleRange</name>
        <message>
            <source>Range shown</source>
            <translation>显示范围</translation>
        </message>
        <message>
            <source>Between the cursors</source>
            <translation>光标之间</translation>
        </message>
        <message>
            <source>Since the figures were armed</source>
            <translation>自启用起</translation>
        </message>
        <message>
            <source>Set two cursors: keys A and B</source>
            <translation>请设置两个光标：按键 A 和 B</translation>
        </message>
        <message>
            <source>Not armed: the machine has not been ready yet</source>
            <translation>尚未启用：机器还未就绪</translation>
        </message>
</context>
<context>
    <name>SignalChooser</name>
        <message>
            <source>Signals</source>
            <translation>信号</translation>
        </message>
        <message>
            <source>Up to four signals over each other</source>
            <translation>最多叠加四个信号</translation>
        </message>
        <message>
            <source>Deviation of a slave</source>
            <translation>从站的偏差</translation>
        </message>
        <message>
            <source>Arrival phase of a slave</source>
            <translation>从站的到达相位</translation>
        </message>
        <message>
            <source>Variable of the process image</source>
            <translation>过程映像变量</translation>
        </message>
        <message>
            <source>Watch others…</source>
            <translation>监视其他变量…</translation>
        </message>
</context>
<context>
    <name>StabilityText</name>
        <message>
            <source>No samples in this range.</source>
            <translation>此范围内没有数值。</translation>
        </message>
        <message>
            <source>No even samples: between two gaps there are never as many as %1.</source>
            <translation>没有等间隔数值：两个间断之间从未达到 %1 个。</translation>
        </message>
        <message>
            <source>Constant: nothing moves.</source>
            <translation>恒定：没有任何变化。</translation>
        </message>
        <message>
            <source>Jitter at short times: ADEV falls with slope %1, neighbouring values have little to do with each other.</source>
            <translation>短时间内为抖动：ADEV 以斜率 %1 下降，相邻数值之间关系很小。</translation>
        </message>
        <message>
            <source>Hunting: it swings, with a period of about %1.</source>
            <translation>振荡：以约 %1 的周期摆动。</translation>
        </message>
        <message>
            <source>Drift at long times: ADEV rises with slope %1 up to the end, nothing takes it back.</source>
            <translation>长时间内为漂移：ADEV 以斜率 %1 一直上升到末端，没有任何作用将其拉回。</translation>
        </message>
        <message>
            <source>It moves away by about %1 in each second.</source>
            <translation>每秒约偏离 %1。</translation>
        </message>
        <message>
            <source>Too few samples for a verdict.</source>
            <translation>数值太少，无法判断。</translation>
        </message>
        <message>
            <source>Neither jitter, hunting nor drift stands out: slope of ADEV %1 at short times, %2 at long ones.</source>
            <translation>抖动、振荡和漂移均不明显：ADEV 的斜率在短时间内为 %1，长时间内为 %2。</translation>
        </message>
        <message>
            <source>%1 samples, one each %2</source>
            <translation>%1 个数值，每 %2 一个</translation>
        </message>
        <message>
            <source>%1 of %2 samples, one each %3</source>
            <translation>%2 个数值中的 %1 个，每 %3 一个</translation>
        </message>
        <message>
            <source>no gap</source>
            <translation>没有间断</translation>
        </message>
        <message numerus="yes">
            <source>%n gap(s)</source>
            <translation>
                <numerusform>%n 处间断</numerusform>
            </translation>
        </message>
        <message>
            <source>%1 of them at a distance that is off by more than a tenth</source>
            <translation>其中 %1 个的间隔偏差超过十分之一</translation>
        </message>
        <message>
            <source>τ %1 to %2</source>
            <translation>τ 从 %1 到 %2</translation>
        </message>
        <message>
            <source>Beyond the limit: MTIE is above %1 for times from %2 on, so values were beyond %3.</source>
            <translation>超出限值：观测时间从 %2 起 MTIE 高于 %1，因此有数值超过 %3。</translation>
        </message>
        <message>
            <source>MTIE keeps the limit: it reaches %1 of %2.</source>
            <translation>MTIE 未超出限值：达到 %1，上限为 %2。</translation>
        </message>
        <message>
            <source>beat of the two clocks</source>
            <translation>两个时钟的拍频</translation>
        </message>
        <message>
            <source>task, %1</source>
            <translation>任务，%1</translation>
        </message>
        <message>
            <source>mains, %1</source>
            <translation>电网，%1</translation>
        </message>
        <message>
            <source>swing of the DCM loop</source>
            <translation>DCM 控制环的摆动</translation>
        </message>
        <message>
            <source>folded</source>
            <translation>混叠</translation>
        </message>
        <message>
            <source>One disturbance: nearly all that moves does so within %1.</source>
            <translation>单次扰动：几乎所有变化都发生在 %1 之内。</translation>
        </message>
</context>
<context>
    <name>StabilityView</name>
        <message>
            <source>Stability</source>
            <translation>稳定性</translation>
        </message>
        <message>
            <source>Signals of the stability</source>
            <translation>稳定性的信号</translation>
        </message>
        <message>
            <source>Figure</source>
            <translation>指标</translation>
        </message>
        <message>
            <source>ADEV</source>
            <translation>ADEV</translation>
        </message>
        <message>
            <source>TDEV</source>
            <translation>TDEV</translation>
        </message>
        <message>
            <source>MTIE</source>
            <translation>MTIE</translation>
        </message>
        <message>
            <source>Spectrum</source>
            <translation>频谱</translation>
        </message>
        <message>
            <source>Allan deviation: how much the rate changes from one observation time to the next</source>
            <translation>阿伦偏差：速率从一个观测时间到下一个观测时间的变化程度</translation>
        </message>
        <message>
            <source>Time deviation: how far averages over an observation time stray from an even course</source>
            <translation>时间偏差：观测时间内的平均值偏离匀速的程度</translation>
        </message>
        <message>
            <source>Maximum time interval error: the largest peak-to-peak value in any observation time</source>
            <translation>最大时间间隔误差：任一观测时间内的最大峰峰值</translation>
        </message>
        <message>
            <source>Amplitude of each frequency</source>
            <translation>各频率的幅值</translation>
        </message>
        <message>
            <source>Samples that count</source>
            <translation>计入的采样</translation>
        </message>
        <message>
            <source>State of the stability</source>
            <translation>稳定性的状态</translation>
        </message>
        <message>
            <source>What the curves say</source>
            <translation>曲线的含义</translation>
        </message>
        <message>
            <source>at most %1, limit %2</source>
            <translation>最多 %1，限值 %2</translation>
        </message>
        <message>
            <source>ADEV over the observation time τ</source>
            <translation>ADEV 与观测时间 τ 的关系</translation>
        </message>
        <message>
            <source>TDEV over the observation time τ</source>
            <translation>TDEV 与观测时间 τ 的关系</translation>
        </message>
        <message>
            <source>MTIE over the observation time τ</source>
            <translation>MTIE 与观测时间 τ 的关系</translation>
        </message>
        <message>
            <source>Amplitude over the frequency</source>
            <translation>幅值与频率的关系</translation>
        </message>
        <message>
            <source>%1 windows of τ</source>
            <translation>%1 个 τ 窗口</translation>
        </message>
        <message>
            <source>Too few samples without a gap for a spectrum.</source>
            <translation>无间断的数值太少，无法计算频谱。</translation>
        </message>
        <message>
            <source>No line stands out.</source>
            <translation>没有突出的谱线。</translation>
        </message>
        <message>
            <source>Lines are named by their frequency alone: a hint, no proof.</source>
            <translation>谱线仅按频率命名：只是提示，不是证明。</translation>
        </message>
        <message>
            <source>No limit is set that this signal could be held against.</source>
            <translation>没有为此信号设置可供比较的限值。</translation>
        </message>
        <message>
            <source>A magnitude, without a sign: a swing about zero shows at half its period.</source>
            <translation>这是绝对值，没有符号：围绕零的摆动以一半的周期显示。</translation>
        </message>
        <message>
            <source>%1 windows averaged, one amplitude each %2.</source>
            <translation>已平均 %1 个窗口，每 %2 一个幅值。</translation>
        </message>
        <message>
            <source>%1; what is hollow rests on few windows of τ.</source>
            <translation>%1；空心点仅基于少数 τ 窗口。</translation>
        </message>
        <message>
            <source>Computing, %1 %</source>
            <translation>正在计算，%1 %</translation>
        </message>
</context>
<context>
    <name>HistogramPlot</name>
        <message>
            <source>Value</source>
            <translation>数值</translation>
        </message>
        <message>
            <source>Value / %1</source>
            <translation>数值 / %1</translation>
        </message>
        <message>
            <source>limit ±%1 %2</source>
            <translation>限值 ±%1 %2</translation>
        </message>
        <message>
            <source>below %1</source>
            <translation>低于 %1</translation>
        </message>
        <message>
            <source>%1 and more</source>
            <translation>%1 及以上</translation>
        </message>
        <message>
            <source>%1 to %2</source>
            <translation>%1 至 %2</translation>
        </message>
        <message>
            <source>Number of values</source>
            <translation>数值个数</translation>
        </message>
</context>
<context>
    <name>EniModel</name>
        <message>
            <source>added</source>
            <translation>新增</translation>
        </message>
        <message>
            <source>removed</source>
            <translation>删除</translation>
        </message>
        <message>
            <source>altered</source>
            <translation>更改</translation>
        </message>
        <message>
            <source>before</source>
            <translation>之前</translation>
        </message>
        <message>
            <source>Line</source>
            <translation>行</translation>
        </message>
        <message>
            <source>Change</source>
            <translation>更改</translation>
        </message>
        <message>
            <source>ENI</source>
            <translation>ENI</translation>
        </message>
        <message numerus="yes">
            <source>… %n line(s) …</source>
            <translation>
                <numerusform>… %n 行 …</numerusform>
            </translation>
        </message>
        <message>
            <source>with the other value</source>
            <translation>换成另一个值时</translation>
        </message>
        <message>
            <source>depends on the setting</source>
            <translation>取决于该设置</translation>
        </message>
</context>
<context>
    <name>EniFindingModel</name>
        <message>
            <source>Line</source>
            <translation>行</translation>
        </message>
        <message>
            <source>Rule</source>
            <translation>规则</translation>
        </message>
        <message>
            <source>Finding</source>
            <translation>发现</translation>
        </message>
</context>
<context>
    <name>EniTextView</name>
        <message>
            <source>Text of the ENI</source>
            <translation>ENI 文本</translation>
        </message>
</context>
<context>
    <name>EniPage</name>
        <message>
            <source>ENI</source>
            <translation>ENI</translation>
        </message>
        <message>
            <source>Cyclic</source>
            <translation>周期</translation>
        </message>
        <message>
            <source>Process image</source>
            <translation>过程映像</translation>
        </message>
        <message>
            <source>Other</source>
            <translation>其他</translation>
        </message>
        <message>
            <source>What stands against the ENI</source>
            <translation>ENI 存在的问题</translation>
        </message>
        <message>
            <source>ENI and what the checker says of it</source>
            <translation>ENI 及检查结果</translation>
        </message>
        <message>
            <source>Lines that changed</source>
            <translation>变化的行</translation>
        </message>
        <message>
            <source>Whether the ENI is up to date, and what the checker says of it</source>
            <translation>ENI 是否为最新，以及检查结果</translation>
        </message>
        <message>
            <source>Dialect of the ENI</source>
            <translation>ENI 方言</translation>
        </message>
        <message>
            <source>How the ENI is laid out and spelled, here and when it is exported: as EC-Engineer does, or as TwinCAT 3 does.</source>
            <translation>ENI 的布局和写法，此处显示与导出时相同：按 EC-Engineer 或按 TwinCAT 3 的方式。</translation>
        </message>
        <message>
            <source>Since when changes are shown</source>
            <translation>从何时起显示更改</translation>
        </message>
        <message>
            <source>Changes since saved</source>
            <translation>保存以来的更改</translation>
        </message>
        <message>
            <source>Changes since exported</source>
            <translation>导出以来的更改</translation>
        </message>
        <message>
            <source>Changes since opened here</source>
            <translation>打开本页以来的更改</translation>
        </message>
        <message>
            <source>The last change</source>
            <translation>最近一次更改</translation>
        </message>
        <message>
            <source>Previous change</source>
            <translation>上一处更改</translation>
        </message>
        <message>
            <source>Next change</source>
            <translation>下一处更改</translation>
        </message>
        <message>
            <source>&amp;Only changes</source>
            <translation>仅更改(&amp;O)</translation>
        </message>
        <message>
            <source>Show only the lines around changes</source>
            <translation>仅显示更改附近的行</translation>
        </message>
        <message>
            <source>Co&amp;mpare…</source>
            <translation>比较(&amp;M)…</translation>
        </message>
        <message>
            <source>Compare the project with a file</source>
            <translation>将项目与文件比较</translation>
        </message>
        <message>
            <source>E&amp;xport…</source>
            <translation>导出(&amp;X)…</translation>
        </message>
        <message>
            <source>Write the ENI to a file</source>
            <translation>将 ENI 写入文件</translation>
        </message>
        <message>
            <source>Part of the ENI to go to</source>
            <translation>要跳转到的 ENI 部分</translation>
        </message>
        <message>
            <source>Go to</source>
            <translation>转到</translation>
        </message>
        <message>
            <source>Search the ENI</source>
            <translation>搜索 ENI</translation>
        </message>
        <message>
            <source>Search (Ctrl+F)</source>
            <translation>搜索 (Ctrl+F)</translation>
        </message>
        <message>
            <source>Previous place</source>
            <translation>上一处</translation>
        </message>
        <message>
            <source>Next place</source>
            <translation>下一处</translation>
        </message>
        <message>
            <source>What the checker says of the ENI</source>
            <translation>ENI 的检查结果</translation>
        </message>
        <message>
            <source>&quot;%1&quot; is not in it</source>
            <translation>其中没有“%1”</translation>
        </message>
        <message>
            <source>The project cannot be compiled: %1</source>
            <translation>无法编译项目：%1</translation>
        </message>
        <message>
            <source>What stands here is old: it was made at %1.</source>
            <translation>此处内容已过时：生成于 %1。</translation>
        </message>
        <message numerus="yes">
            <source>%n error(s) of the project stand against this ENI.</source>
            <translation>
                <numerusform>此 ENI 存在项目的 %n 个错误。</numerusform>
            </translation>
        </message>
        <message>
            <source>Nothing has been changed yet</source>
            <translation>尚无更改</translation>
        </message>
        <message>
            <source>Not exported yet: nothing to compare with</source>
            <translation>尚未导出：没有可比较的内容</translation>
        </message>
        <message>
            <source>Not saved yet: nothing to compare with</source>
            <translation>尚未保存：没有可比较的内容</translation>
        </message>
        <message>
            <source>No line differs</source>
            <translation>没有变化的行</translation>
        </message>
        <message numerus="yes">
            <source>%n line(s) added</source>
            <translation>
                <numerusform>新增 %n 行</numerusform>
            </translation>
        </message>
        <message numerus="yes">
            <source>%n removed</source>
            <translation>
                <numerusform>删除 %n 行</numerusform>
            </translation>
        </message>
        <message numerus="yes">
            <source>%n altered</source>
            <translation>
                <numerusform>更改 %n 行</numerusform>
            </translation>
        </message>
        <message>
            <source>Computing…</source>
            <translation>正在计算…</translation>
        </message>
        <message>
            <source>Out of date</source>
            <translation>已过时</translation>
        </message>
        <message>
            <source>Being checked…</source>
            <translation>正在检查…</translation>
        </message>
        <message numerus="yes">
            <source>%n error(s)</source>
            <translation>
                <numerusform>%n 个错误</numerusform>
            </translation>
        </message>
        <message numerus="yes">
            <source>%n warning(s)</source>
            <translation>
                <numerusform>%n 个警告</numerusform>
            </translation>
        </message>
        <message numerus="yes">
            <source>%n note(s)</source>
            <translation>
                <numerusform>%n 条提示</numerusform>
            </translation>
        </message>
        <message>
            <source>The checker finds nothing</source>
            <translation>检查未发现问题</translation>
        </message>
        <message>
            <source>&amp;Report</source>
            <translation>报告(&amp;R)</translation>
        </message>
        <message>
            <source>Write a report beside each ENI that is exported</source>
            <translation>在每个导出的 ENI 旁写一份报告</translation>
        </message>
        <message>
            <source>An HTML file beside the ENI: slaves, clocks, frames, findings and the drawing of the wiring</source>
            <translation>ENI 旁的一个 HTML 文件：从站、时钟、帧、检查结果和接线图</translation>
        </message>
        <message>
            <source>What depends on a setting</source>
            <translation>哪些内容取决于某个设置</translation>
        </message>
        <message>
            <source>Show &amp;Changes</source>
            <translation>显示更改(&amp;C)</translation>
        </message>
        <message>
            <source>Show changes in place of what depends</source>
            <translation>显示更改，而不显示相关内容</translation>
        </message>
        <message>
            <source>Looking for what depends on &quot;%1&quot; of %2…</source>
            <translation>正在查找哪些内容取决于 %2 的“%1”…</translation>
        </message>
        <message>
            <source>No other value of &quot;%1&quot; of %2 can be tried, so what depends on it is not known.</source>
            <translation>%2 的“%1”没有别的值可试，因此不知道哪些内容取决于它。</translation>
        </message>
        <message>
            <source>&quot;%1&quot; of %2 does not change the ENI: it is used by the master at run time.</source>
            <translation>%2 的“%1”不改变 ENI：主站在运行时使用它。</translation>
        </message>
        <message>
            <source>Marked is what depends on &quot;%1&quot; of %2; struck out, how it would be with %3.</source>
            <translation>标出的是取决于 %2 的“%1”的内容；带删除线的是换成 %3 时的样子。</translation>
        </message>
</context>
<context>
    <name>ComparisonModel</name>
        <message>
            <source>Slaves</source>
            <translation>从站</translation>
        </message>
        <message>
            <source>Wiring</source>
            <translation>接线</translation>
        </message>
        <message>
            <source>Process data</source>
            <translation>过程数据</translation>
        </message>
        <message>
            <source>Mailbox</source>
            <translation>邮箱</translation>
        </message>
        <message>
            <source>Start-up</source>
            <translation>启动</translation>
        </message>
        <message>
            <source>Clocks</source>
            <translation>时钟</translation>
        </message>
        <message>
            <source>Commands</source>
            <translation>命令</translation>
        </message>
        <message>
            <source>Cyclic</source>
            <translation>周期</translation>
        </message>
        <message>
            <source>Process image</source>
            <translation>过程映像</translation>
        </message>
        <message>
            <source>Master</source>
            <translation>主站</translation>
        </message>
        <message>
            <source>At run time</source>
            <translation>运行时</translation>
        </message>
        <message>
            <source>Setting</source>
            <translation>设置</translation>
        </message>
        <message>
            <source>Position %1</source>
            <translation>位置 %1</translation>
        </message>
        <message>
            <source>Network</source>
            <translation>网络</translation>
        </message>
        <message numerus="yes">
            <source>%n difference(s)</source>
            <translation>
                <numerusform>%n 处差异</numerusform>
            </translation>
        </message>
        <message>
            <source>What</source>
            <translation>内容</translation>
        </message>
        <message>
            <source>Class</source>
            <translation>类别</translation>
        </message>
</context>
<context>
    <name>CompareDialog</name>
        <message>
            <source>Changed since it was compared; choose the bus once more to look again.</source>
            <translation>比较之后又有改动；请再次选择总线以重新查看。</translation>
        </message>
        <message>
            <source>A bus can only stand on the right</source>
            <translation>总线只能在右侧</translation>
        </message>
        <message>
            <source>Compare</source>
            <translation>比较</translation>
        </message>
        <message>
            <source>How many differences there are</source>
            <translation>差异数量</translation>
        </message>
        <message>
            <source>Left side of the comparison</source>
            <translation>比较的左侧</translation>
        </message>
        <message>
            <source>Right side of the comparison</source>
            <translation>比较的右侧</translation>
        </message>
        <message>
            <source>Exchange the two sides</source>
            <translation>交换两侧</translation>
        </message>
        <message>
            <source>Search the differences</source>
            <translation>搜索差异</translation>
        </message>
        <message>
            <source>Search</source>
            <translation>搜索</translation>
        </message>
        <message>
            <source>&amp;Only what matters</source>
            <translation>仅重要的(&amp;O)</translation>
        </message>
        <message>
            <source>Only what matters</source>
            <translation>仅重要的</translation>
        </message>
        <message>
            <source>Leaves out names, and where data stand in the process image</source>
            <translation>省略名称以及数据在过程映像中的位置</translation>
        </message>
        <message>
            <source>Differences</source>
            <translation>差异</translation>
        </message>
        <message>
            <source>&amp;Copy</source>
            <translation>复制(&amp;C)</translation>
        </message>
        <message>
            <source>Copy the differences as text</source>
            <translation>将差异复制为文本</translation>
        </message>
        <message>
            <source>&amp;Export CSV…</source>
            <translation>导出 CSV(&amp;E)…</translation>
        </message>
        <message>
            <source>Write the differences to a file</source>
            <translation>将差异写入文件</translation>
        </message>
        <message>
            <source>File…</source>
            <translation>文件…</translation>
        </message>
        <message>
            <source>Bus…</source>
            <translation>总线…</translation>
        </message>
        <message>
            <source>Project (%1)</source>
            <translation>项目 (%1)</translation>
        </message>
        <message>
            <source>Running machine</source>
            <translation>运行中的机器</translation>
        </message>
        <message>
            <source>Bus on %1</source>
            <translation>%1 上的总线</translation>
        </message>
        <message>
            <source>Compare With</source>
            <translation>与之比较</translation>
        </message>
        <message>
            <source>Projects and ENI files (*.syncline *.xml *.eni);;All files (*)</source>
            <translation>项目和 ENI 文件 (*.syncline *.xml *.eni);;所有文件 (*)</translation>
        </message>
        <message>
            <source>Choose what the project is to be compared with.</source>
            <translation>请选择要与项目比较的对象。</translation>
        </message>
        <message>
            <source>Comparing…</source>
            <translation>正在比较…</translation>
        </message>
        <message>
            <source>There is no difference.</source>
            <translation>没有差异。</translation>
        </message>
        <message numerus="yes">
            <source>%n difference(s)</source>
            <translation>
                <numerusform>%n 处差异</numerusform>
            </translation>
        </message>
        <message>
            <source>Where</source>
            <translation>位置</translation>
        </message>
        <message>
            <source>Export Differences</source>
            <translation>导出差异</translation>
        </message>
        <message>
            <source>Comma-separated values (*.csv)</source>
            <translation>逗号分隔值 (*.csv)</translation>
        </message>
        <message>
            <source>The differences could not be written.</source>
            <translation>无法写入差异。</translation>
        </message>
        <message numerus="yes">
            <source>(%n of them are changes of the project; the others follow from these, or change nothing)</source>
            <translation>
                <numerusform>（其中 %n 处是项目的更改；其余由此产生，或没有改变任何内容）</numerusform>
            </translation>
        </message>
</context>
<context>
    <name>DiagnosisModel</name>
        <message>
            <source>Information</source>
            <translation>信息</translation>
        </message>
        <message>
            <source>Warning</source>
            <translation>警告</translation>
        </message>
        <message>
            <source>Error</source>
            <translation>错误</translation>
        </message>
        <message>
            <source>%1 s since its start</source>
            <translation>启动后 %1 s</translation>
        </message>
        <message>
            <source>Acknowledged</source>
            <translation>已确认</translation>
        </message>
        <message>
            <source>New</source>
            <translation>新</translation>
        </message>
        <message>
            <source>cannot be read: %1</source>
            <translation>无法解读：%1</translation>
        </message>
        <message>
            <source>Text %1 of the ESI</source>
            <translation>ESI 的文本 %1</translation>
        </message>
        <message>
            <source>Sub-index</source>
            <translation>子索引</translation>
        </message>
        <message>
            <source>Severity</source>
            <translation>严重性</translation>
        </message>
        <message>
            <source>Message</source>
            <translation>消息</translation>
        </message>
        <message>
            <source>Diag code</source>
            <translation>诊断代码</translation>
        </message>
        <message>
            <source>Text ID</source>
            <translation>文本 ID</translation>
        </message>
        <message>
            <source>Time</source>
            <translation>时间</translation>
        </message>
        <message>
            <source>DC time (ns)</source>
            <translation>DC 时间 (ns)</translation>
        </message>
        <message>
            <source>State</source>
            <translation>状态</translation>
        </message>
</context>
<context>
    <name>DiagnosisReader</name>
        <message>
            <source>Object 0x10F3 says nothing of its length.</source>
            <translation>对象 0x10F3 未给出其长度。</translation>
        </message>
</context>
<context>
    <name>SlaveHistoryPage</name>
        <message>
            <source>History</source>
            <translation>历史</translation>
        </message>
        <message>
            <source>When full it keeps what nobody has acknowledged</source>
            <translation>已满时保留未确认的消息</translation>
        </message>
        <message>
            <source>When full it overwrites the oldest message</source>
            <translation>已满时覆盖最旧的消息</translation>
        </message>
        <message>
            <source>messages were thrown away because it was full</source>
            <translation>因已满有消息被丢弃</translation>
        </message>
        <message>
            <source>messages were overwritten that nobody had acknowledged</source>
            <translation>有未确认的消息被覆盖</translation>
        </message>
        <message>
            <source>each is sent as an emergency, too</source>
            <translation>每条消息也作为紧急报文发送</translation>
        </message>
        <message>
            <source>none is sent as an emergency</source>
            <translation>不作为紧急报文发送</translation>
        </message>
        <message>
            <source>information</source>
            <translation>信息</translation>
        </message>
        <message>
            <source>warnings</source>
            <translation>警告</translation>
        </message>
        <message>
            <source>errors</source>
            <translation>错误</translation>
        </message>
        <message>
            <source>not kept: %1</source>
            <translation>不保存：%1</translation>
        </message>
        <message>
            <source>Flags %1: %2.</source>
            <translation>标志 %1：%2。</translation>
        </message>
        <message>
            <source>Messages of the slave's diagnosis history, newest first</source>
            <translation>从站诊断历史的消息，最新的在前</translation>
        </message>
        <message>
            <source>&amp;Read</source>
            <translation>读取(&amp;R)</translation>
        </message>
        <message>
            <source>Read the diagnosis history</source>
            <translation>读取诊断历史</translation>
        </message>
        <message>
            <source>Object 0x10F3 (ETG.1020). Reading acknowledges nothing.</source>
            <translation>对象 0x10F3（ETG.1020）。读取不会确认任何消息。</translation>
        </message>
        <message>
            <source>On demand</source>
            <translation>按需</translation>
        </message>
        <message>
            <source>Every %1 s</source>
            <translation>每 %1 s</translation>
        </message>
        <message>
            <source>How often the diagnosis history is read</source>
            <translation>读取诊断历史的频率</translation>
        </message>
        <message>
            <source>&amp;Acknowledge All…</source>
            <translation>全部确认(&amp;A)…</translation>
        </message>
        <message>
            <source>Acknowledge all messages of the diagnosis history</source>
            <translation>确认诊断历史的所有消息</translation>
        </message>
        <message>
            <source>Writes the newest message's sub-index to 0x10F3:03</source>
            <translation>将最新消息的子索引写入 0x10F3:03</translation>
        </message>
        <message>
            <source>&amp;CSV…</source>
            <translation>&amp;CSV…</translation>
        </message>
        <message>
            <source>Export the messages as comma-separated values</source>
            <translation>将消息导出为逗号分隔值</translation>
        </message>
        <message>
            <source>This slave keeps no diagnosis history: it has no object 0x10F3.</source>
            <translation>该从站没有诊断历史：没有对象 0x10F3。</translation>
        </message>
        <message>
            <source>This slave does not speak CoE: it keeps no diagnosis history.</source>
            <translation>该从站不支持 CoE：没有诊断历史。</translation>
        </message>
        <message>
            <source>The history can be read from PREOP on: lead the slave there first.</source>
            <translation>从 PREOP 起才能读取历史：请先将从站切换到该状态。</translation>
        </message>
        <message>
            <source>The history is empty.</source>
            <translation>历史为空。</translation>
        </message>
        <message>
            <source>none</source>
            <translation>无</translation>
        </message>
        <message>
            <source>%1 of at most %2 messages. Newest: %3. Newest acknowledged: %4. New messages available: %5.</source>
            <translation>%1 条消息，最多 %2 条。最新：%3。最新已确认：%4。有新消息：%5。</translation>
        </message>
        <message>
            <source>yes</source>
            <translation>是</translation>
        </message>
        <message>
            <source>no</source>
            <translation>否</translation>
        </message>
        <message numerus="yes">
            <source>Acknowledge %n message(s) of %1?</source>
            <translation>
                <numerusform>确认 %1 的 %n 条消息？</numerusform>
            </translation>
        </message>
        <message>
            <source>The messages stay in the slave until newer ones take their places, but nobody is told of them any more. The fault itself is not acknowledged by this.</source>
            <translation>消息会保留在从站中，直到被更新的消息取代，但不再提示。故障本身不会因此被确认。</translation>
        </message>
        <message>
            <source>Acknowledge</source>
            <translation>确认</translation>
        </message>
        <message>
            <source>Export Diagnosis History</source>
            <translation>导出诊断历史</translation>
        </message>
        <message>
            <source>Comma-separated values (*.csv)</source>
            <translation>逗号分隔值 (*.csv)</translation>
        </message>
        <message>
            <source>The history could not be exported.</source>
            <translation>无法导出历史。</translation>
        </message>
</context>
<context>
    <name>TriggerMonitor</name>
        <message>
            <source>not armed</source>
            <translation>未就绪</translation>
        </message>
        <message>
            <source>armed: waits for a run</source>
            <translation>已就绪：等待运行</translation>
        </message>
        <message>
            <source>all of the recording was looked at</source>
            <translation>已检查整个记录</translation>
        </message>
        <message>
            <source>looks through the recording</source>
            <translation>正在检查记录</translation>
        </message>
        <message>
            <source>fills the time before the trigger</source>
            <translation>正在填充触发前时间</translation>
        </message>
        <message>
            <source>waits for the trigger</source>
            <translation>等待触发</translation>
        </message>
        <message>
            <source>triggered</source>
            <translation>已触发</translation>
        </message>
        <message>
            <source>holds off</source>
            <translation>触发抑制中</translation>
        </message>
        <message>
            <source>done: triggered once</source>
            <translation>完成：已触发一次</translation>
        </message>
</context>
<context>
    <name>TriggerPanel</name>
        <message>
            <source>A signal, in every cycle of it, an event, or a finding</source>
            <translation>每个周期的信号、事件或发现</translation>
        </message>
        <message>
            <source>A finding</source>
            <translation>发现</translation>
        </message>
        <message>
            <source>Finding of the trigger</source>
            <translation>触发的发现</translation>
        </message>
        <message>
            <source>Which finding; it counts at the moment at which it began, and one that is of the whole run has none</source>
            <translation>哪个发现；以其开始的时刻为准，关于整个运行的发现没有时刻</translation>
        </message>
        <message>
            <source>SM2 events missed</source>
            <translation>错过的 SM2 事件</translation>
        </message>
        <message>
            <source>Frames lost in a cycle</source>
            <translation>一个周期内丢失的帧</translation>
        </message>
        <message>
            <source>Deviation of a slave</source>
            <translation>从站的偏差</translation>
        </message>
        <message>
            <source>Arrival phase of a slave</source>
            <translation>从站的到达相位</translation>
        </message>
        <message>
            <source>Setpoint slips of a slave</source>
            <translation>从站的设定值错拍</translation>
        </message>
        <message>
            <source>Trigger</source>
            <translation>触发</translation>
        </message>
        <message>
            <source>What the trigger watches</source>
            <translation>触发监视的对象</translation>
        </message>
        <message>
            <source>Slave of the trigger</source>
            <translation>触发的从站</translation>
        </message>
        <message>
            <source>Whose signal or event</source>
            <translation>谁的信号或事件</translation>
        </message>
        <message>
            <source>Condition of the trigger</source>
            <translation>触发条件</translation>
        </message>
        <message>
            <source>What the signal does</source>
            <translation>信号的变化</translation>
        </message>
        <message>
            <source>rises to</source>
            <translation>上升到</translation>
        </message>
        <message>
            <source>falls to</source>
            <translation>下降到</translation>
        </message>
        <message>
            <source>crosses</source>
            <translation>穿过</translation>
        </message>
        <message>
            <source>leaves</source>
            <translation>离开</translation>
        </message>
        <message>
            <source>enters</source>
            <translation>进入</translation>
        </message>
        <message>
            <source>Event of the trigger</source>
            <translation>触发的事件</translation>
        </message>
        <message>
            <source>Which event</source>
            <translation>哪个事件</translation>
        </message>
        <message>
            <source>Level of the trigger</source>
            <translation>触发电平</translation>
        </message>
        <message>
            <source>The level, in the unit of the signal</source>
            <translation>电平，以信号的单位表示</translation>
        </message>
        <message>
            <source>Lower edge of the band</source>
            <translation>区间下限</translation>
        </message>
        <message>
            <source>Lower edge of the band; it belongs to the band</source>
            <translation>区间下限；属于区间</translation>
        </message>
        <message>
            <source>Upper edge of the band</source>
            <translation>区间上限</translation>
        </message>
        <message>
            <source>Upper edge of the band; it belongs to the band</source>
            <translation>区间上限；属于区间</translation>
        </message>
        <message>
            <source>Absolute</source>
            <translation>绝对值</translation>
        </message>
        <message>
            <source>Absolute value</source>
            <translation>绝对值</translation>
        </message>
        <message>
            <source>Whatever the sign of the signal is</source>
            <translation>不论信号的符号</translation>
        </message>
        <message>
            <source>Mode of the trigger</source>
            <translation>触发模式</translation>
        </message>
        <message>
            <source>Automatic: the plots go on following. Normal: they move to the newest episode. Single: they stop at the first one.</source>
            <translation>自动：曲线继续跟随。正常：移到最新的片段。单次：停在第一个片段。</translation>
        </message>
        <message>
            <source>Automatic</source>
            <translation>自动</translation>
        </message>
        <message>
            <source>Normal</source>
            <translation>正常</translation>
        </message>
        <message>
            <source>Single</source>
            <translation>单次</translation>
        </message>
        <message>
            <source>Time before the trigger</source>
            <translation>触发前时间</translation>
        </message>
        <message>
            <source>What of the time before belongs to an episode</source>
            <translation>片段包含的之前的时间</translation>
        </message>
        <message>
            <source>Time after the trigger</source>
            <translation>触发后时间</translation>
        </message>
        <message>
            <source>What of the time after belongs to an episode</source>
            <translation>片段包含的之后的时间</translation>
        </message>
        <message>
            <source>Hold-off</source>
            <translation>触发抑制</translation>
        </message>
        <message>
            <source>For so long after a trigger no other episode begins; those left out are counted</source>
            <translation>触发后这段时间内不开始新的片段；被略去的会计数</translation>
        </message>
        <message>
            <source>Arm</source>
            <translation>就绪</translation>
        </message>
        <message>
            <source>Arm the trigger</source>
            <translation>使触发就绪</translation>
        </message>
        <message>
            <source>State of the trigger</source>
            <translation>触发状态</translation>
        </message>
        <message>
            <source>Before</source>
            <translation>之前</translation>
        </message>
        <message>
            <source>After</source>
            <translation>之后</translation>
        </message>
        <message>
            <source>Save the episode</source>
            <translation>保存片段</translation>
        </message>
        <message>
            <source>Save…</source>
            <translation>保存…</translation>
        </message>
        <message>
            <source>Export the episode as CSV</source>
            <translation>将片段导出为 CSV</translation>
        </message>
        <message>
            <source>CSV…</source>
            <translation>CSV…</translation>
        </message>
        <message>
            <source>The samples of the chosen episode, before and after included, as comma-separated values</source>
            <translation>所选片段（含前后时间）的采样，逗号分隔</translation>
        </message>
        <message>
            <source>Episodes of the trigger</source>
            <translation>触发片段</translation>
        </message>
        <message>
            <source>Time</source>
            <translation>时间</translation>
        </message>
        <message>
            <source>Cycle</source>
            <translation>周期</translation>
        </message>
        <message>
            <source>Cause</source>
            <translation>原因</translation>
        </message>
        <message>
            <source>Slave</source>
            <translation>从站</translation>
        </message>
        <message>
            <source>Name</source>
            <translation>名称</translation>
        </message>
        <message>
            <source>Enter or a double click shows the episode in the plots; F2 names it</source>
            <translation>回车或双击在曲线中显示片段；F2 命名</translation>
        </message>
        <message>
            <source>An event</source>
            <translation>事件</translation>
        </message>
        <message>
            <source>Any slave</source>
            <translation>任一从站</translation>
        </message>
        <message>
            <source>%1 %2: %3</source>
            <translation>%1 %2：%3</translation>
        </message>
        <message>
            <source> (%1 more in the hold-off)</source>
            <translation>（抑制期内还有 %1 个）</translation>
        </message>
        <message>
            <source>What is shown is a recording already</source>
            <translation>显示的已是记录</translation>
        </message>
        <message>
            <source>A recording of the chosen episode, out of memory</source>
            <translation>从内存中记录所选片段</translation>
        </message>
        <message>
            <source>A watched variable</source>
            <translation>被监视的变量</translation>
        </message>
        <message>
            <source>Variable of the trigger</source>
            <translation>触发变量</translation>
        </message>
        <message>
            <source>Which variable; they are watched on the page Variables</source>
            <translation>选择变量；在“变量”页面上设置监视</translation>
        </message>
        <message>
            <source>, %1 within the hold-off</source>
            <translation>，保持期内 %1 次</translation>
        </message>
</context>
<context>
    <name>CableTip</name>
        <message>
            <source>%1 port %2</source>
            <translation>%1 端口 %2</translation>
        </message>
        <message>
            <source>The link is up.</source>
            <translation>链路已建立。</translation>
        </message>
        <message>
            <source>The cable is broken: nothing comes back over it.</source>
            <translation>电缆已断开：没有任何数据经它返回。</translation>
        </message>
        <message>
            <source>%1 does not answer.</source>
            <translation>%1 不应答。</translation>
        </message>
        <message>
            <source>Offline: the link is not known.</source>
            <translation>离线：链路状态未知。</translation>
        </message>
        <message>
            <source>%1: not read yet</source>
            <translation>%1：尚未读取</translation>
        </message>
        <message>
            <source>%1 does not answer: no counters</source>
            <translation>%1 不应答：没有计数</translation>
        </message>
        <message>
            <source>%1, read %2:</source>
            <translation>%1，读取于 %2：</translation>
        </message>
        <message>
            <source>invalid frames %1, receive errors %2</source>
            <translation>无效帧 %1，接收错误 %2</translation>
        </message>
        <message>
            <source>forwarded errors %1, lost links %2</source>
            <translation>转发错误 %1，链路丢失 %2</translation>
        </message>
        <message>
            <source>Here frames are damaged first: begin with this cable and its plugs.</source>
            <translation>帧首先在此处受损：请从这根电缆及其插头查起。</translation>
        </message>
        <message>
            <source>Frames were damaged or the link was lost on this cable.</source>
            <translation>这根电缆上有帧受损或链路丢失。</translation>
        </message>
        <message>
            <source>Only forwarded errors: the frames were damaged on another cable.</source>
            <translation>仅为转发错误：帧是在另一根电缆上损坏的。</translation>
        </message>
        <message>
            <source>Cable: %1 to %2</source>
            <translation>电缆：%1 到 %2</translation>
        </message>
        <message>
            <source>Click the number for the error counters of %1.</source>
            <translation>点击数字可查看 %1 的错误计数器。</translation>
        </message>
</context>
    <context>
        <name>TemplateCommands</name>
        <message>
            <source>Save as Template</source>
            <translation>存为模板</translation>
        </message>
        <message>
            <source>Name of the template:</source>
            <translation>模板名称：</translation>
        </message>
        <message>
            <source>Save</source>
            <translation>保存</translation>
        </message>
        <message>
            <source>There is a template %1 already.</source>
            <translation>已有模板 %1。</translation>
        </message>
        <message>
            <source>What it holds is lost when it is replaced.</source>
            <translation>替换后，其中的内容将丢失。</translation>
        </message>
        <message>
            <source>Replace</source>
            <translation>替换</translation>
        </message>
        <message>
            <source>Template</source>
            <translation>模板</translation>
        </message>
        <message>
            <source>The template could not be saved.</source>
            <translation>无法保存模板。</translation>
        </message>
        <message>
            <source>Saved the template %1</source>
            <translation>已保存模板 %1</translation>
        </message>
        <message>
            <source>The template %1 cannot be read.</source>
            <translation>无法读取模板 %1。</translation>
        </message>
        <message>
            <source>Remove the template %1?</source>
            <translation>删除模板 %1？</translation>
        </message>
        <message>
            <source>Projects that were begun with it stay as they are.</source>
            <translation>以它开始的项目保持不变。</translation>
        </message>
        <message>
            <source>Remove</source>
            <translation>删除</translation>
        </message>
        <message>
            <source>The template %1 could not be removed.</source>
            <translation>无法删除模板 %1。</translation>
        </message>
</context>
<context>
    <name>VariableModel</name>
        <message>
            <source>%1, byte %2 bit %3 of the process image's %4</source>
            <translation>%1，过程映像%4的字节 %2 位 %3</translation>
        </message>
        <message>
            <source>Direction</source>
            <translation>方向</translation>
        </message>
        <message>
            <source>Forced</source>
            <translation>强制</translation>
        </message>
        <message>
            <source>Hex</source>
            <translation>十六进制</translation>
        </message>
        <message>
            <source>Input</source>
            <translation>输入</translation>
        </message>
        <message>
            <source>Output</source>
            <translation>输出</translation>
        </message>
        <message>
            <source>inputs</source>
            <translation>输入</translation>
        </message>
        <message>
            <source>outputs</source>
            <translation>输出</translation>
        </message>
        <message>
            <source>Place</source>
            <translation>位置</translation>
        </message>
        <message>
            <source>Type</source>
            <translation>类型</translation>
        </message>
        <message>
            <source>Value</source>
            <translation>值</translation>
        </message>
        <message>
            <source>Variable</source>
            <translation>变量</translation>
        </message>
        <message>
            <source>forced</source>
            <translation>已强制</translation>
        </message>
        <message>
            <source>Not known: it does not come back, or its slave does not exchange process data.</source>
            <translation>未知：未返回，或其从站未交换过程数据。</translation>
        </message>
        <message>
            <source>Monitor</source>
            <translation>监视器</translation>
        </message>
        <message>
            <source>watched</source>
            <translation>已监视</translation>
        </message>
</context>
<context>
    <name>VariablesPage</name>
        <message>
            <source>Variables</source>
            <translation>变量</translation>
        </message>
        <message>
            <source>The process image has %1 for inputs and %2 for outputs, with gaps and addresses that both use. Values are shown while the machine runs.</source>
            <translation>过程映像中输入占 %1，输出占 %2，包括空隙和共用的地址。机器运行时显示值。</translation>
        </message>
        <message>
            <source>%1 is an input.</source>
            <translation>%1 是输入。</translation>
        </message>
        <message>
            <source>&amp;Force</source>
            <translation>强制(&amp;F)</translation>
        </message>
        <message>
            <source>Force</source>
            <translation>强制</translation>
        </message>
        <message>
            <source>All</source>
            <translation>全部</translation>
        </message>
        <message>
            <source>All variables</source>
            <translation>所有变量</translation>
        </message>
        <message>
            <source>Choose an output to force it.</source>
            <translation>选择一个输出以强制其值。</translation>
        </message>
        <message>
            <source>Cycle %1</source>
            <translation>周期 %1</translation>
        </message>
        <message>
            <source>Force no output any more</source>
            <translation>不再强制任何输出</translation>
        </message>
        <message>
            <source>Force outputs of the running machine?</source>
            <translation>强制正在运行的机器的输出？</translation>
        </message>
        <message>
            <source>Forced</source>
            <translation>强制</translation>
        </message>
        <message>
            <source>Hold the output at this value, whatever the application calculates</source>
            <translation>将输出保持为该值，无论应用程序计算出什么</translation>
        </message>
        <message>
            <source>Inputs</source>
            <translation>输入</translation>
        </message>
        <message>
            <source>Outputs</source>
            <translation>输出</translation>
        </message>
        <message>
            <source>Let the application set this output again</source>
            <translation>让应用程序重新设置该输出</translation>
        </message>
        <message>
            <source>Name, type, or place</source>
            <translation>名称、类型或位置</translation>
        </message>
        <message>
            <source>No slave that runs has this station address and identity.</source>
            <translation>运行中的从站都没有此站地址和标识。</translation>
        </message>
        <message>
            <source>Outputs that are forced</source>
            <translation>被强制的输出</translation>
        </message>
        <message>
            <source>Re&amp;lease</source>
            <translation>释放(&amp;L)</translation>
        </message>
        <message>
            <source>Release All</source>
            <translation>全部释放</translation>
        </message>
        <message>
            <source>Search variables</source>
            <translation>搜索变量</translation>
        </message>
        <message>
            <source>Selected variable</source>
            <translation>选中的变量</translation>
        </message>
        <message>
            <source>The project cannot be compiled: the messages say why.</source>
            <translation>项目无法编译：原因见消息。</translation>
        </message>
        <message>
            <source>Value</source>
            <translation>值</translation>
        </message>
        <message>
            <source>Value to force, decimal or with 0x</source>
            <translation>要强制的值，十进制或以 0x 开头</translation>
        </message>
        <message>
            <source>Variables of the process image</source>
            <translation>过程映像的变量</translation>
        </message>
        <message>
            <source>What the slaves are sent</source>
            <translation>发送给从站的数据</translation>
        </message>
        <message>
            <source>What the slaves send</source>
            <translation>从站发送的数据</translation>
        </message>
        <message>
            <source>What the values are</source>
            <translation>值的含义</translation>
        </message>
        <message>
            <source>What they drive moves or switches at once, whatever the application and its interlocks say. They stay forced until they are released or the machine goes offline. This is asked once a run.</source>
            <translation>它们驱动的设备会立即动作或切换，无论应用程序及其联锁如何。输出保持强制，直到被释放或机器离线。每次运行只询问一次。</translation>
        </message>
        <message>
            <source>Which variables are shown</source>
            <translation>显示哪些变量</translation>
        </message>
        <message numerus="yes">
            <source>%n input(s) not known: they do not come back, or their slaves exchange none</source>
            <translation>
                <numerusform>%n 个输入未知：未返回，或其从站未交换数据</numerusform>
            </translation>
        </message>
        <message>
            <source>Watch in the Monitor</source>
            <translation>在监视器中监视</translation>
        </message>
        <message>
            <source>&amp;Watch in the Monitor</source>
            <translation>在监视器中监视(&amp;W)</translation>
        </message>
        <message>
            <source>Record the variable in every cycle and draw it below the plots</source>
            <translation>在每个周期记录该变量，并绘制在曲线下方</translation>
        </message>
        <message>
            <source>%1 variables are watched already: take one away first</source>
            <translation>已监视 %1 个变量：请先移除一个</translation>
        </message>
</context>
<context>
    <name>InitCommandsPage</name>
    <message numerus="yes">
        <source>%n command(s), in the order of the ENI. Those of mailboxes are set on the page Start-up of a slave, those of registers below.</source>
        <translation>
            <numerusform>%n 条命令，按 ENI 的顺序。邮箱的命令在从站的“启动”页设置，寄存器的命令见下。</numerusform>
        </translation>
    </message>
    <message>
        <source>register command</source>
        <translation>寄存器命令</translation>
    </message>
    <message>
        <source>Own register commands to all slaves</source>
        <translation>面向所有从站的自有寄存器命令</translation>
    </message>
    <message>
        <source>Own register commands</source>
        <translation>自有寄存器命令</translation>
    </message>
    <message>
        <source>None: the commands above are all.</source>
        <translation>无：上面的命令就是全部。</translation>
    </message>
    <message>
        <source>Own, below</source>
        <translation>自有，见下</translation>
    </message>
        <message numerus="yes">
            <source>%n zero byte(s)</source>
            <translation>
                <numerusform>%n 个零字节</numerusform>
            </translation>
        </message>
        <message numerus="yes">
            <source>%n repeat(s)</source>
            <translation>
                <numerusform>重试 %n 次</numerusform>
            </translation>
        </message>
        <message>
            <source>counter %1</source>
            <translation>计数器 %1</translation>
        </message>
        <message>
            <source>within %1 ms</source>
            <translation>%1 ms 内</translation>
        </message>
        <message>
            <source>(off)</source>
            <translation>(关)</translation>
        </message>
        <message>
            <source>Init Commands (Expert)</source>
            <translation>初始化命令（专家）</translation>
        </message>
        <message>
            <source>Slave</source>
            <translation>从站</translation>
        </message>
        <message>
            <source>Transition</source>
            <translation>转换</translation>
        </message>
        <message>
            <source>Command</source>
            <translation>命令</translation>
        </message>
        <message>
            <source>To</source>
            <translation>目标</translation>
        </message>
        <message>
            <source>Data</source>
            <translation>数据</translation>
        </message>
        <message>
            <source>Answer</source>
            <translation>应答</translation>
        </message>
        <message>
            <source>Comment</source>
            <translation>注释</translation>
        </message>
        <message>
            <source>Search init commands</source>
            <translation>搜索初始化命令</translation>
        </message>
        <message>
            <source>Transition, register, object, or comment</source>
            <translation>转换、寄存器、对象或注释</translation>
        </message>
        <message>
            <source>Init commands</source>
            <translation>初始化命令</translation>
        </message>
        <message>
            <source>The project cannot be compiled: the messages say why.</source>
            <translation>项目无法编译：原因见消息。</translation>
        </message>
        <message>
            <source>Origin</source>
            <translation>来源</translation>
        </message>
        <message>
            <source>State machine</source>
            <translation>状态机</translation>
        </message>
        <message>
            <source>Addresses</source>
            <translation>地址</translation>
        </message>
        <message>
            <source>Check of the device</source>
            <translation>设备检查</translation>
        </message>
        <message>
            <source>SyncManagers</source>
            <translation>SyncManager</translation>
        </message>
        <message>
            <source>Process image</source>
            <translation>过程映像</translation>
        </message>
        <message>
            <source>Distributed clocks</source>
            <translation>分布式时钟</translation>
        </message>
        <message>
            <source>Watchdogs</source>
            <translation>看门狗</translation>
        </message>
        <message>
            <source>Ports</source>
            <translation>端口</translation>
        </message>
        <message>
            <source>PDO assignment</source>
            <translation>PDO 分配</translation>
        </message>
        <message>
            <source>PDO mapping</source>
            <translation>PDO 映射</translation>
        </message>
        <message>
            <source>ESI</source>
            <translation>ESI</translation>
        </message>
        <message>
            <source>Page Start-up</source>
            <translation>启动页</translation>
        </message>
        <message>
            <source>Settings</source>
            <translation>设置</translation>
        </message>
</context>
<context>
    <name>FramesPage</name>
        <message>
            <source>Frames and Cost</source>
            <translation>帧与开销</translation>
        </message>
        <message>
            <source>What a cycle costs</source>
            <translation>一个周期的开销</translation>
        </message>
        <message>
            <source>Cyclic frames</source>
            <translation>循环帧</translation>
        </message>
        <message>
            <source>Frame</source>
            <translation>帧</translation>
        </message>
        <message>
            <source>Every</source>
            <translation>周期</translation>
        </message>
        <message>
            <source>Datagrams</source>
            <translation>数据报</translation>
        </message>
        <message>
            <source>Bytes</source>
            <translation>字节</translation>
        </message>
        <message>
            <source>Process data</source>
            <translation>过程数据</translation>
        </message>
        <message>
            <source>Wire time</source>
            <translation>线路时间</translation>
        </message>
        <message>
            <source>Datagrams of the selected frame</source>
            <translation>选中帧的数据报</translation>
        </message>
        <message>
            <source>Command</source>
            <translation>命令</translation>
        </message>
        <message>
            <source>Counter</source>
            <translation>计数器</translation>
        </message>
        <message>
            <source>Sent in</source>
            <translation>发送状态</translation>
        </message>
        <message>
            <source>Comment</source>
            <translation>注释</translation>
        </message>
        <message>
            <source>Slaves, the costliest first</source>
            <translation>从站，开销最大的在前</translation>
        </message>
        <message>
            <source>Slave</source>
            <translation>从站</translation>
        </message>
        <message>
            <source>Outputs</source>
            <translation>输出</translation>
        </message>
        <message>
            <source>Inputs</source>
            <translation>输入</translation>
        </message>
        <message>
            <source>Bytes in datagrams</source>
            <translation>数据报中的字节</translation>
        </message>
        <message>
            <source>Objects that could be exchanged by SDO instead</source>
            <translation>可改用 SDO 交换的对象</translation>
        </message>
        <message>
            <source>Object</source>
            <translation>对象</translation>
        </message>
        <message>
            <source>PDO</source>
            <translation>PDO</translation>
        </message>
        <message>
            <source>Size</source>
            <translation>大小</translation>
        </message>
        <message>
            <source>Saves</source>
            <translation>节省</translation>
        </message>
        <message>
            <source>The project cannot be compiled: the messages say why.</source>
            <translation>项目无法编译：原因见消息。</translation>
        </message>
        <message>
            <source>Outputs %1, inputs %2, frames in a cycle of %4: %3. They take %5 on the wire, %6 % of the bandwidth.</source>
            <translation>输出 %1，输入 %2，每 %4 周期的帧数：%3。线路占用 %5，带宽的 %6 %。</translation>
        </message>
        <message>
            <source>The last frame is back after about %1.</source>
            <translation>最后一帧约在 %1 后返回。</translation>
        </message>
        <message>
            <source>That is longer than the cycle.</source>
            <translation>这比周期还长。</translation>
        </message>
</context>
<context>
    <name>NetworkCommands</name>
        <message>
            <source>Ne&amp;xt Network</source>
            <translation>下一个网络(&amp;X)</translation>
        </message>
        <message>
            <source>Work on the next network of the machine</source>
            <translation>处理机器的下一个网络</translation>
        </message>
        <message>
            <source>&amp;Add Network</source>
            <translation>添加网络(&amp;A)</translation>
        </message>
        <message>
            <source>Add a network without slaves to the machine</source>
            <translation>向机器添加一个没有从站的网络</translation>
        </message>
        <message>
            <source>Re&amp;move Network…</source>
            <translation>移除网络(&amp;M)…</translation>
        </message>
        <message>
            <source>Take the network in work out of the machine</source>
            <translation>将当前网络从机器中移除</translation>
        </message>
        <message>
            <source>Network %1</source>
            <translation>网络 %1</translation>
        </message>
        <message>
            <source>Take %1 out of the machine?</source>
            <translation>将 %1 从机器中移除？</translation>
        </message>
        <message numerus="yes">
            <source>Its %n slave(s) go with it. That cannot be undone, but until the project is saved the file keeps it.</source>
            <translation>
                <numerusform>其 %n 个从站也会一同移除。此操作无法撤销，但在保存项目之前文件中仍保留它。</numerusform>
            </translation>
        </message>
        <message>
            <source>Remove</source>
            <translation>移除</translation>
        </message>
        <message>
            <source>A bus is being scanned: wait for its slaves, or cancel the scan.</source>
            <translation>正在扫描总线：请等待其从站，或取消扫描。</translation>
        </message>
        <message>
            <source>A recording is shown: close it first (File, Close Recording).</source>
            <translation>正在显示记录：请先关闭它（文件，关闭记录）。</translation>
        </message>
        <message>
            <source>A slave is being written to: wait until it has been.</source>
            <translation>正在写入从站：请等待写入完成。</translation>
        </message>
        <message>
            <source>All Net&amp;works Offline</source>
            <translation>所有网络离线(&amp;W)</translation>
        </message>
        <message>
            <source>Take all networks of the machine that run offline</source>
            <translation>使机器中所有正在运行的网络离线</translation>
        </message>
</context>
<context>
    <name>FindingFixes</name>
        <message>
            <source>Show the Master</source>
            <translation>显示主站</translation>
        </message>
        <message>
            <source>Show Its Slave</source>
            <translation>显示其从站</translation>
        </message>
        <message>
            <source>Go to the Setting</source>
            <translation>转到该设置</translation>
        </message>
        <message numerus="yes">
            <source>Set %1 of %n slave(s) to %2</source>
            <translation>
                <numerusform>将 %n 个从站的%1设为 %2</numerusform>
            </translation>
        </message>
        <message>
            <source>Set %1 to %2</source>
            <translation>将%1设为 %2</translation>
        </message>
        <message>
            <source>Configuration</source>
            <translation>配置</translation>
        </message>
        <message>
            <source>No single value of this setting mends it</source>
            <translation>该设置的任何单个值都无法修复</translation>
        </message>
</context>
<context>
    <name>RunState</name>
        <message>
            <source>DC: %1</source>
            <translation>DC：%1</translation>
        </message>
        <message>
            <source>DCM: %1</source>
            <translation>DCM：%1</translation>
        </message>
        <message>
            <source>Offline</source>
            <translation>离线</translation>
        </message>
        <message>
            <source>Online</source>
            <translation>在线</translation>
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
            <source>no link</source>
            <translation>无连接</translation>
        </message>
        <message>
            <source>outputs forced</source>
            <translation>输出被强制</translation>
        </message>
        <message>
            <source>%1: %2</source>
            <translation>%1：%2</translation>
        </message>
        <message>
            <source>No answer</source>
            <translation>无应答</translation>
        </message>
</context>
<context>
    <name>SyncUnitModel</name>
        <message>
            <source>Sync Unit, slave</source>
            <translation>同步单元，从站</translation>
        </message>
        <message>
            <source>Process data</source>
            <translation>过程数据</translation>
        </message>
        <message>
            <source>Outputs and inputs</source>
            <translation>输出和输入</translation>
        </message>
        <message>
            <source>Outputs</source>
            <translation>输出</translation>
        </message>
        <message>
            <source>Inputs</source>
            <translation>输入</translation>
        </message>
        <message>
            <source>None (base task)</source>
            <translation>无（基本任务）</translation>
        </message>
        <message numerus="yes">
            <source>%n slave(s)</source>
            <translation>
                <numerusform>%n 个从站</numerusform>
            </translation>
        </message>
</context>
<context>
    <name>SyncUnitTree</name>
        <message>
            <source>Slaves of the Sync Units</source>
            <translation>同步单元的从站</translation>
        </message>
        <message>
            <source>Drag slaves to the Sync Unit that exchanges them</source>
            <translation>将从站拖到交换其数据的同步单元</translation>
        </message>
        <message>
            <source>Move to Sync Unit</source>
            <translation>移至同步单元</translation>
        </message>
        <message>
            <source>Move to</source>
            <translation>移至</translation>
        </message>
        <message>
            <source>Give the selected slaves to a Sync Unit</source>
            <translation>将所选从站分配给同步单元</translation>
        </message>
</context>
<context>
    <name>syncline::ui::SlavesView</name>
        <message numerus="yes">
            <source>%1 (and %n more here)</source>
            <translation>
                <numerusform>%1（此处还有 %n 个）</numerusform>
            </translation>
        </message>
</context>
    <context>
    <name>BlackBoxDialog</name>
        <message>
            <source>Black Box of Frames</source>
            <translation>帧黑匣子</translation>
        </message>
        <message>
            <source>Keeps the last frames of every run on disk, sent and received, in files that Wireshark reads. They are whole also after a crash or a power cut; the oldest are replaced.</source>
            <translation>将每次运行中发送和接收的最后若干帧保存在磁盘上，文件可由 Wireshark 读取。崩溃或断电后文件仍然完整；最旧的会被替换。</translation>
        </message>
        <message>
            <source>&amp;Keep the last frames of every run</source>
            <translation>保存每次运行的最后若干帧(&amp;K)</translation>
        </message>
        <message>
            <source>Keep the last frames</source>
            <translation>保存最后若干帧</translation>
        </message>
        <message>
            <source>Folder of the files</source>
            <translation>文件所在的文件夹</translation>
        </message>
        <message>
            <source>&amp;Browse…</source>
            <translation>浏览(&amp;B)…</translation>
        </message>
        <message>
            <source>Choose the folder</source>
            <translation>选择文件夹</translation>
        </message>
        <message>
            <source>&amp;Folder</source>
            <translation>文件夹(&amp;F)</translation>
        </message>
        <message>
            <source>Size of the files of a network together</source>
            <translation>一个网络的全部文件的总大小</translation>
        </message>
        <message>
            <source>&amp;Size</source>
            <translation>大小(&amp;S)</translation>
        </message>
        <message>
            <source>How much time it holds</source>
            <translation>可保存多长时间</translation>
        </message>
        <message>
            <source>What it holds now</source>
            <translation>目前保存的内容</translation>
        </message>
        <message>
            <source>OK</source>
            <translation>确定</translation>
        </message>
        <message>
            <source>Folder of the Black Box</source>
            <translation>黑匣子的文件夹</translation>
        </message>
        <message>
            <source>How much time that holds follows from the frames of a cycle: there are none yet.</source>
            <translation>可保存的时长取决于每个周期的帧：目前还没有。</translation>
        </message>
        <message>
            <source>Holds about the last %1 of this network's cycles.</source>
            <translation>大约保存本网络最近 %1 的周期。</translation>
        </message>
    </context>
    <context>
    <name>BlackBoxText</name>
        <message>
            <source>The last %1 of the run, %2 frames, in %3</source>
            <translation>运行的最后 %1，%2 帧，位于 %3</translation>
        </message>
        <message numerus="yes">
            <source>%n file(s), %1</source>
            <translation>
                <numerusform>%n 个文件，%1</numerusform>
            </translation>
        </message>
        <message>
            <source>%1 frames are missing: the disk was too slow</source>
            <translation>缺少 %1 帧：磁盘太慢</translation>
        </message>
        <message>
            <source>No frame of the run yet</source>
            <translation>还没有本次运行的帧</translation>
        </message>
    </context>
<context>
    <name>AcceptanceText</name>
    <message>
        <source>%1 for %2</source>
        <translation>%1，已持续 %2</translation>
    </message>
    <message>
        <source>; no value since it was armed</source>
        <translation>；启用统计后没有数值</translation>
    </message>
    <message>
        <source>; largest %1 ns</source>
        <translation>；最大 %1 ns</translation>
    </message>
    <message>
        <source>, over the limit</source>
        <translation>，超出限值</translation>
    </message>
    <message>
        <source>, %1 % margin</source>
        <translation>，裕量 %1 %</translation>
    </message>
    <message>
        <source>Accepted</source>
        <translation>通过</translation>
    </message>
    <message>
        <source>Not accepted</source>
        <translation>未通过</translation>
    </message>
    <message>
        <source>Not proven</source>
        <translation>未证明</translation>
    </message>
    <message>
        <source>in sync throughout, within ±%1 ns</source>
        <translation>始终同步，在 ±%1 ns 以内</translation>
    </message>
    <message>
        <source>, %1 % to spare</source>
        <translation>，裕量 %1 %</translation>
    </message>
    <message>
        <source>none</source>
        <translation>无</translation>
    </message>
    <message>
        <source>%1 at most</source>
        <translation>最多 %1</translation>
    </message>
    <message numerus="yes">
        <source>, lost %n time(s)</source>
        <translation><numerusform>，失步 %n 次</numerusform></translation>
    </message>
    <message numerus="yes">
        <source>%n episode(s)</source>
        <translation><numerusform>%n 次</numerusform></translation>
    </message>
    <message numerus="yes">
        <source>%n error(s)</source>
        <translation><numerusform>%n 个错误</numerusform></translation>
    </message>
    <message numerus="yes">
        <source>%n warning(s)</source>
        <translation><numerusform>%n 个警告</numerusform></translation>
    </message>
        <message>
            <source>; largest that lasted %1 ns</source>
            <translation>；持续的最大值 %1 ns</translation>
        </message>
</context>
<context>
    <name>CommissioningDialog</name>
    <message>
        <source>Commissioning Report</source>
        <translation>调试报告</translation>
    </message>
    <message>
        <source>Name of the machine</source>
        <translation>机器名称</translation>
    </message>
    <message>
        <source>&amp;Machine</source>
        <translation>机器(&amp;M)</translation>
    </message>
    <message>
        <source>Least time that it was watched for, minutes</source>
        <translation>最短观察时间（分钟）</translation>
    </message>
    <message>
        <source> min</source>
        <translation> min</translation>
    </message>
    <message>
        <source>&amp;Watched for at least</source>
        <translation>至少观察(&amp;W)</translation>
    </message>
    <message>
        <source>Least m&amp;argin</source>
        <translation>最小裕量(&amp;A)</translation>
    </message>
    <message>
        <source>Least margin to the limits, percent</source>
        <translation>距限值的最小裕量（百分比）</translation>
    </message>
    <message>
        <source>SM2 &amp;events missed at most</source>
        <translation>最多错过 SM2 事件(&amp;E)</translation>
    </message>
    <message>
        <source>Most SM2 events missed</source>
        <translation>错过 SM2 事件的上限</translation>
    </message>
    <message>
        <source>&amp;Frames lost at most</source>
        <translation>最多丢失帧(&amp;F)</translation>
    </message>
    <message>
        <source>Most frames lost</source>
        <translation>丢失帧的上限</translation>
    </message>
    <message>
        <source>Wr&amp;ong working counters at most</source>
        <translation>最多错误工作计数器(&amp;O)</translation>
    </message>
    <message>
        <source>Most wrong working counters</source>
        <translation>错误工作计数器的上限</translation>
    </message>
    <message>
        <source>&amp;Cycles left out at most</source>
        <translation>最多跳过周期(&amp;C)</translation>
    </message>
    <message>
        <source>Most cycles left out</source>
        <translation>跳过周期的上限</translation>
    </message>
    <message>
        <source>Result</source>
        <translation>结果</translation>
    </message>
    <message>
        <source>Criteria</source>
        <translation>准则</translation>
    </message>
    <message>
        <source>Verdict</source>
        <translation>评判</translation>
    </message>
    <message>
        <source>Criterion</source>
        <translation>准则</translation>
    </message>
    <message>
        <source>Required</source>
        <translation>要求</translation>
    </message>
    <message>
        <source>Found</source>
        <translation>实际</translation>
    </message>
    <message>
        <source>Write &amp;Page…</source>
        <translation>写出页面(&amp;P)…</translation>
    </message>
    <message>
        <source>Write the page</source>
        <translation>写出页面</translation>
    </message>
    <message>
        <source>Close</source>
        <translation>关闭</translation>
    </message>
    <message>
        <source>Write Page</source>
        <translation>写出页面</translation>
    </message>
    <message>
        <source>Web pages (*.html)</source>
        <translation>网页 (*.html)</translation>
    </message>
    <message>
        <source>The page could not be written.</source>
        <translation>无法写出页面。</translation>
    </message>
    <message>
        <source>Commissioning</source>
        <translation>调试</translation>
    </message>
    <message>
        <source>%1: %2</source>
        <translation>%1：%2</translation>
    </message>
</context>
<context>
    <name>MemoryDialog</name>
        <message>
            <source>Memory for the Last Cycles</source>
            <translation>最近周期的内存</translation>
        </message>
        <message>
            <source>Every cycle of a run is kept in memory, so that the last stretch can be saved afterwards. The oldest go when the memory is full.</source>
            <translation>运行的每个周期都保存在内存中，以便事后保存最近的一段。内存满时丢弃最旧的周期。</translation>
        </message>
        <message>
            <source>Memory for each network</source>
            <translation>每个网络的内存</translation>
        </message>
        <message>
            <source>&amp;Memory for each network</source>
            <translation>每个网络的内存(&amp;M)</translation>
        </message>
        <message>
            <source>How much time it holds</source>
            <translation>可容纳的时间</translation>
        </message>
        <message>
            <source>What is forgotten at once</source>
            <translation>立即丢弃的内容</translation>
        </message>
        <message>
            <source>OK</source>
            <translation>确定</translation>
        </message>
        <message>
            <source>How much time that is follows from the cycle time: nothing has run yet.</source>
            <translation>时间长短取决于周期时间：尚未运行过。</translation>
        </message>
        <message>
            <source>Holds every cycle of about the last %1 of this network.</source>
            <translation>可保存该网络最近约 %1 的每个周期。</translation>
        </message>
        <message>
            <source>The last %1 are in memory: what is older than that goes at once.</source>
            <translation>内存中有最近 %1：更早的将立即丢弃。</translation>
        </message>
</context>
<context>
    <name>ReplayBar</name>
        <message>
            <source>Replay of the recording</source>
            <translation>记录的回放</translation>
        </message>
        <message>
            <source>To the &amp;Beginning</source>
            <translation>到开头(&amp;B)</translation>
        </message>
        <message>
            <source>To the beginning of the recording</source>
            <translation>到记录的开头</translation>
        </message>
        <message>
            <source>Pre&amp;vious Event</source>
            <translation>上一个事件(&amp;V)</translation>
        </message>
        <message>
            <source>To the event or note before</source>
            <translation>到前一个事件或注释</translation>
        </message>
        <message>
            <source>Cycle B&amp;ack</source>
            <translation>后退一个周期(&amp;A)</translation>
        </message>
        <message>
            <source>A cycle back</source>
            <translation>后退一个周期</translation>
        </message>
        <message>
            <source>&amp;Play</source>
            <translation>播放(&amp;P)</translation>
        </message>
        <message>
            <source>&amp;Pause</source>
            <translation>暂停(&amp;P)</translation>
        </message>
        <message>
            <source>Play the recording as it was live, or pause</source>
            <translation>按当时实况播放记录，或暂停</translation>
        </message>
        <message>
            <source>Cycle &amp;Further</source>
            <translation>前进一个周期(&amp;F)</translation>
        </message>
        <message>
            <source>A cycle further</source>
            <translation>前进一个周期</translation>
        </message>
        <message>
            <source>&amp;Next Event</source>
            <translation>下一个事件(&amp;N)</translation>
        </message>
        <message>
            <source>To the next event or note</source>
            <translation>到下一个事件或注释</translation>
        </message>
        <message>
            <source>To the &amp;End</source>
            <translation>到末尾(&amp;E)</translation>
        </message>
        <message>
            <source>To the end of the recording</source>
            <translation>到记录的末尾</translation>
        </message>
        <message>
            <source>&amp;Slower</source>
            <translation>减慢(&amp;S)</translation>
        </message>
        <message>
            <source>Play slower</source>
            <translation>减慢播放</translation>
        </message>
        <message>
            <source>Fas&amp;ter</source>
            <translation>加快(&amp;T)</translation>
        </message>
        <message>
            <source>Play faster</source>
            <translation>加快播放</translation>
        </message>
        <message>
            <source>&amp;Whole Recording</source>
            <translation>整个记录(&amp;W)</translation>
        </message>
        <message>
            <source>Show the whole recording again (Esc in the plots or in this bar)</source>
            <translation>重新显示整个记录（在曲线或此栏中按 Esc）</translation>
        </message>
        <message>
            <source>Speed of the replay</source>
            <translation>回放速度</translation>
        </message>
        <message>
            <source>How fast the recording is played, against the time of the run (Alt+Minus, Alt+Plus)</source>
            <translation>相对于运行时间的播放速度（Alt+减号、Alt+加号）</translation>
        </message>
        <message>
            <source>Real time</source>
            <translation>实时</translation>
        </message>
        <message>
            <source>Moment of the recording</source>
            <translation>记录的时刻</translation>
        </message>
        <message>
            <source>The moment that is shown; ticks are events and notes</source>
            <translation>所显示的时刻；刻线为事件和注释</translation>
        </message>
        <message>
            <source>Time of the replay</source>
            <translation>回放时间</translation>
        </message>
        <message>
            <source>Whole</source>
            <translation>全部</translation>
        </message>
        <message>
            <source>Show the whole recording</source>
            <translation>显示整个记录</translation>
        </message>
        <message>
            <source>%1 of %2 s</source>
            <translation>%1 / %2 s</translation>
        </message>
</context>
<context>
    <name>OverlayBar</name>
        <message>
            <source>Recording laid over the one that is shown</source>
            <translation>叠加在所显示记录之上的记录</translation>
        </message>
        <message>
            <source>Aligned by</source>
            <translation>对齐方式</translation>
        </message>
        <message>
            <source>By what the two recordings are aligned</source>
            <translation>两个记录的对齐依据</translation>
        </message>
        <message>
            <source>Beginnings</source>
            <translation>开头</translation>
        </message>
        <message>
            <source>Armed</source>
            <translation>就绪时刻</translation>
        </message>
        <message>
            <source>First trigger</source>
            <translation>首次触发</translation>
        </message>
        <message>
            <source>Hand</source>
            <translation>手动</translation>
        </message>
        <message>
            <source>What lies over each other: the first cycles, the moments at which figures were armed (in OP and in sync), or the first episodes of the trigger as it is set in the panel Trigger</source>
            <translation>相互重叠的是：首个周期、数值开始统计的时刻（处于 OP 且同步），或按触发面板设置的触发的首次事件段</translation>
        </message>
        <message>
            <source>later by</source>
            <translation>推迟</translation>
        </message>
        <message>
            <source>How much later it is drawn</source>
            <translation>绘制推迟的时间</translation>
        </message>
        <message>
            <source>How much later than with both beginnings together; arrow keys move it by a cycle. In the plots Ctrl and the arrow keys or dragging with Ctrl move it, too</source>
            <translation>相对于两个开头对齐时推迟的时间；方向键按一个周期移动。在曲线中按 Ctrl 加方向键或按住 Ctrl 拖动也可移动</translation>
        </message>
        <message>
            <source> s</source>
            <translation> s</translation>
        </message>
        <message>
            <source>Take the other recording away</source>
            <translation>移除另一个记录</translation>
        </message>
        <message>
            <source>Remove</source>
            <translation>移除</translation>
        </message>
        <message>
            <source>Takes the recording that lies over this one away</source>
            <translation>移除叠加在此记录之上的记录</translation>
        </message>
        <message>
            <source>One of the two recordings was not armed: it cannot be aligned so.</source>
            <translation>两个记录之一未曾就绪：无法这样对齐。</translation>
        </message>
        <message>
            <source>The trigger as it is set does not occur in both recordings.</source>
            <translation>按当前设置的触发并未在两个记录中都出现。</translation>
        </message>
        <message>
            <source>Over it: %1</source>
            <translation>叠加：%1</translation>
        </message>
</context>
<context>
    <name>OverlayFigures</name>
        <message>
            <source>Figures of both recordings over the range shown</source>
            <translation>两个记录在所显示范围内的数值</translation>
        </message>
        <message>
            <source>Of every cycle of the range shown, at the places where the two lie over each other</source>
            <translation>取自所显示范围内的每个周期，按两者的叠加位置</translation>
        </message>
        <message>
            <source>rms</source>
            <translation>rms</translation>
        </message>
        <message>
            <source>p99.99</source>
            <translation>p99.99</translation>
        </message>
        <message>
            <source>max</source>
            <translation>最大</translation>
        </message>
        <message>
            <source>DC deviation: mean</source>
            <translation>DC 偏差：平均</translation>
        </message>
        <message>
            <source>DCM error: mean</source>
            <translation>DCM 误差：平均</translation>
        </message>
</context>
<context>
    <name>WindowOverlay</name>
        <message>
            <source>Overlay Another Recording</source>
            <translation>叠加另一个记录</translation>
        </message>
        <message>
            <source>Recordings and tables (*.slrec *.csv);;All files (*)</source>
            <translation>记录和表格 (*.slrec *.csv);;所有文件 (*)</translation>
        </message>
        <message>
            <source>No recording is shown that another could lie over.</source>
            <translation>未显示可供叠加的记录。</translation>
        </message>
        <message>
            <source>Overlay</source>
            <translation>叠加</translation>
        </message>
        <message>
            <source>The recording %1 could not be opened.</source>
            <translation>无法打开记录 %1。</translation>
        </message>
</context>
<context>
    <name>Signals</name>
        <message>
            <source>Port %1: invalid frames</source>
            <translation>端口 %1：无效帧</translation>
        </message>
        <message>
            <source>Port %1: receive errors</source>
            <translation>端口 %1：接收错误</translation>
        </message>
        <message>
            <source>Port %1: forwarded errors</source>
            <translation>端口 %1：转发的错误</translation>
        </message>
        <message>
            <source>Port %1: lost links</source>
            <translation>端口 %1：链路丢失</translation>
        </message>
        <message>
            <source>Working counter, expected</source>
            <translation>工作计数器，期望值</translation>
        </message>
        <message>
            <source>Working counter, received</source>
            <translation>工作计数器，接收值</translation>
        </message>
        <message>
            <source>Frames lost in a cycle</source>
            <translation>一个周期内丢失的帧</translation>
        </message>
        <message>
            <source>Cycles left out before a cycle</source>
            <translation>某周期之前跳过的周期</translation>
        </message>
        <message>
            <source>Synchronisation of the slaves</source>
            <translation>从站的同步</translation>
        </message>
        <message>
            <source>Synchronisation of the master</source>
            <translation>主站的同步</translation>
        </message>
        <message>
            <source>Lowest AL state of all slaves</source>
            <translation>所有从站的最低 AL 状态</translation>
        </message>
        <message>
            <source>Lost frames</source>
            <translation>丢失的帧</translation>
        </message>
        <message>
            <source>Late frames</source>
            <translation>迟到的帧</translation>
        </message>
        <message>
            <source>Cycles left out</source>
            <translation>跳过的周期</translation>
        </message>
        <message>
            <source>Wrong working counters</source>
            <translation>错误的工作计数器</translation>
        </message>
        <message>
            <source>Frames too late for SYNC0</source>
            <translation>对 SYNC0 来说太迟的帧</translation>
        </message>
        <message>
            <source>SM2 events missed</source>
            <translation>错过的 SM2 事件</translation>
        </message>
        <message>
            <source>Fuse of the SM2 events</source>
            <translation>SM2 事件的保险计数</translation>
        </message>
        <message>
            <source>Limit of the fuse</source>
            <translation>保险计数的限值</translation>
        </message>
        <message>
            <source>Misses until the fuse trips</source>
            <translation>触发前还可错过的次数</translation>
        </message>
        <message>
            <source>Cycle exceeded, outputs</source>
            <translation>周期超时，输出</translation>
        </message>
        <message>
            <source>Cycle exceeded, inputs</source>
            <translation>周期超时，输入</translation>
        </message>
        <message>
            <source>Shift too short, outputs</source>
            <translation>偏移过短，输出</translation>
        </message>
        <message>
            <source>Shift too short, inputs</source>
            <translation>偏移过短，输入</translation>
        </message>
        <message>
            <source>Clock slowed by</source>
            <translation>时钟减慢量</translation>
        </message>
        <message>
            <source>AL state</source>
            <translation>AL 状态</translation>
        </message>
        <message>
            <source>Process data watchdog</source>
            <translation>过程数据看门狗</translation>
        </message>
        <message>
            <source>PDI watchdog</source>
            <translation>PDI 看门狗</translation>
        </message>
        <message>
            <source>Processing unit errors</source>
            <translation>处理单元错误</translation>
        </message>
        <message>
            <source>PDI errors</source>
            <translation>PDI 错误</translation>
        </message>
        <message>
            <source>Propagation delay</source>
            <translation>传播延迟</translation>
        </message>
        <message>
            <source>Setpoint slips</source>
            <translation>设定值滑移</translation>
        </message>
        <message>
            <source>Counts that may be higher</source>
            <translation>可能更高的计数</translation>
        </message>
        <message>
            <source>Port %1</source>
            <translation>端口 %1</translation>
        </message>
        <message>
            <source>Variable</source>
            <translation>变量</translation>
        </message>
</context>
<context>
    <name>FreeView</name>
        <message>
            <source>States</source>
            <translation>状态</translation>
        </message>
        <message>
            <source>Time</source>
            <translation>时间</translation>
        </message>
        <message>
            <source>Rate of a clock</source>
            <translation>时钟速率</translation>
        </message>
        <message>
            <source>Events</source>
            <translation>事件</translation>
        </message>
        <message>
            <source>Value</source>
            <translation>值</translation>
        </message>
        <message>
            <source>%1, a second</source>
            <translation>%1（每秒）</translation>
        </message>
        <message>
            <source>DCM: error, adjustment, drift</source>
            <translation>DCM：误差、调整、漂移</translation>
        </message>
        <message>
            <source>DCM error</source>
            <translation>DCM 误差</translation>
        </message>
        <message>
            <source>External clock</source>
            <translation>外部时钟</translation>
        </message>
        <message>
            <source>Adjustment and drift</source>
            <translation>调整与漂移</translation>
        </message>
        <message>
            <source>AL states of all slaves</source>
            <translation>所有从站的 AL 状态</translation>
        </message>
        <message>
            <source>Frames of the bus</source>
            <translation>总线的帧</translation>
        </message>
        <message>
            <source>Round trip and send lateness</source>
            <translation>往返时间与发送延迟</translation>
        </message>
        <message>
            <source>Counts of the bus</source>
            <translation>总线计数</translation>
        </message>
        <message>
            <source>Counters of %1</source>
            <translation>%1 的计数器</translation>
        </message>
        <message>
            <source>Errors at the ports</source>
            <translation>端口错误</translation>
        </message>
        <message>
            <source>Counts of the device</source>
            <translation>设备计数</translation>
        </message>
        <message>
            <source>Own plots</source>
            <translation>自定义图</translation>
        </message>
        <message>
            <source>View</source>
            <translation>视图</translation>
        </message>
        <message>
            <source>Which view is shown; new ones, other names</source>
            <translation>显示哪个视图；新建、改名</translation>
        </message>
        <message>
            <source>Add a plot</source>
            <translation>添加一个图</translation>
        </message>
        <message>
            <source>Add Plot</source>
            <translation>添加图</translation>
        </message>
        <message>
            <source>One more plot below the others</source>
            <translation>在其他图下方再加一个图</translation>
        </message>
        <message>
            <source>Whose view it is</source>
            <translation>视图的归属</translation>
        </message>
        <message>
            <source>View: %1</source>
            <translation>视图：%1</translation>
        </message>
        <message>
            <source>Proposed; becomes the project's when it is changed</source>
            <translation>建议的视图；修改后归入项目</translation>
        </message>
        <message>
            <source>No plot yet: Add Plot</source>
            <translation>还没有图：添加图</translation>
        </message>
        <message>
            <source>Views of the project</source>
            <translation>项目的视图</translation>
        </message>
        <message>
            <source>None yet</source>
            <translation>暂无</translation>
        </message>
        <message>
            <source>Proposed</source>
            <translation>建议</translation>
        </message>
        <message>
            <source>New view</source>
            <translation>新建视图</translation>
        </message>
        <message>
            <source>Own view</source>
            <translation>自定义视图</translation>
        </message>
        <message>
            <source>Rename…</source>
            <translation>重命名…</translation>
        </message>
        <message>
            <source>Duplicate</source>
            <translation>复制</translation>
        </message>
        <message>
            <source>Delete</source>
            <translation>删除</translation>
        </message>
        <message>
            <source>Watch variables…</source>
            <translation>监视变量…</translation>
        </message>
        <message>
            <source>Rename View</source>
            <translation>重命名视图</translation>
        </message>
        <message>
            <source>Name of the view</source>
            <translation>视图名称</translation>
        </message>
        <message>
            <source>Fuse and its limit</source>
            <translation>保险计数及其限值</translation>
        </message>
</context>
<context>
    <name>FreePlot</name>
        <message>
            <source>not drawn</source>
            <translation>未绘制</translation>
        </message>
        <message>
            <source>Signals…</source>
            <translation>信号…</translation>
        </message>
        <message>
            <source>Choose signals and axes</source>
            <translation>选择信号和坐标轴</translation>
        </message>
        <message>
            <source>Menu of this plot</source>
            <translation>此图的菜单</translation>
        </message>
        <message>
            <source>Plot %1</source>
            <translation>图 %1</translation>
        </message>
        <message>
            <source>State</source>
            <translation>状态</translation>
        </message>
        <message>
            <source>limit ±%1</source>
            <translation>限值 ±%1</translation>
        </message>
        <message>
            <source>not there</source>
            <translation>不存在</translation>
        </message>
        <message>
            <source>%1 (right)</source>
            <translation>%1（右）</translation>
        </message>
        <message>
            <source>Nothing chosen yet: Signals…</source>
            <translation>尚未选择：信号…</translation>
        </message>
        <message>
            <source>min %1   max %2</source>
            <translation>最小 %1   最大 %2</translation>
        </message>
        <message>
            <source>Signals and axes…</source>
            <translation>信号和坐标轴…</translation>
        </message>
        <message>
            <source>Value scale</source>
            <translation>数值刻度</translation>
        </message>
        <message>
            <source>Linear</source>
            <translation>线性</translation>
        </message>
        <message>
            <source>Signed logarithmic</source>
            <translation>带符号对数</translation>
        </message>
        <message>
            <source>Logarithmic</source>
            <translation>对数</translation>
        </message>
        <message>
            <source>Own time axis</source>
            <translation>独立时间轴</translation>
        </message>
        <message>
            <source>Take out</source>
            <translation>移出</translation>
        </message>
        <message>
            <source>Axis at the right</source>
            <translation>右侧坐标轴</translation>
        </message>
        <message>
            <source>Move up</source>
            <translation>上移</translation>
        </message>
        <message>
            <source>Move down</source>
            <translation>下移</translation>
        </message>
        <message>
            <source>Remove plot</source>
            <translation>移除图</translation>
        </message>
</context>
<context>
    <name>PlotDialog</name>
        <message>
            <source>About the marked signal</source>
            <translation>关于所选信号</translation>
        </message>
        <message>
            <source>Signals and Axes of the Plot</source>
            <translation>图的信号和坐标轴</translation>
        </message>
        <message>
            <source>What is wrong</source>
            <translation>错误说明</translation>
        </message>
        <message>
            <source>Search signals</source>
            <translation>搜索信号</translation>
        </message>
        <message>
            <source>Slave and signal, such as: #1 lost</source>
            <translation>从站和信号，例如：#1 丢失</translation>
        </message>
        <message>
            <source>Signals of the run</source>
            <translation>运行中的信号</translation>
        </message>
        <message>
            <source>Add</source>
            <translation>添加</translation>
        </message>
        <message>
            <source>Add what is marked</source>
            <translation>添加选中的信号</translation>
        </message>
        <message>
            <source>Ctrl+A marks all that were found: several slaves at once</source>
            <translation>Ctrl+A 选中全部找到的信号：可一次选多个从站</translation>
        </message>
        <message>
            <source>Signals in the plot</source>
            <translation>图中的信号</translation>
        </message>
        <message>
            <source>In the plot</source>
            <translation>图中</translation>
        </message>
        <message>
            <source>A second</source>
            <translation>每秒</translation>
        </message>
        <message>
            <source>Axis right</source>
            <translation>右轴</translation>
        </message>
        <message>
            <source>How many a second instead of how many: of counts</source>
            <translation>每秒多少次而非总数：用于计数</translation>
        </message>
        <message>
            <source>On the value axis at the right</source>
            <translation>使用右侧数值轴</translation>
        </message>
        <message>
            <source>Take Out</source>
            <translation>移出</translation>
        </message>
        <message>
            <source>Take out what is marked (Del)</source>
            <translation>移出选中的信号（Del）</translation>
        </message>
        <message>
            <source>Title</source>
            <translation>标题</translation>
        </message>
        <message>
            <source>Title of the plot</source>
            <translation>图的标题</translation>
        </message>
        <message>
            <source>By what it shows</source>
            <translation>按显示内容</translation>
        </message>
        <message>
            <source>linear</source>
            <translation>线性</translation>
        </message>
        <message>
            <source>signed log</source>
            <translation>带符号对数</translation>
        </message>
        <message>
            <source>log</source>
            <translation>对数</translation>
        </message>
        <message>
            <source>Value scale: %1</source>
            <translation>数值刻度：%1</translation>
        </message>
        <message>
            <source>Value scale</source>
            <translation>数值刻度</translation>
        </message>
        <message>
            <source>Left axis</source>
            <translation>左轴</translation>
        </message>
        <message>
            <source>Right axis</source>
            <translation>右轴</translation>
        </message>
        <message>
            <source>Own time axis</source>
            <translation>独立时间轴</translation>
        </message>
        <message>
            <source>Time axis</source>
            <translation>时间轴</translation>
        </message>
        <message>
            <source>not linked to the others: own zoom and place</source>
            <translation>不与其他图联动：独立缩放和位置</translation>
        </message>
        <message>
            <source>Limits are two numbers, the smaller one first.</source>
            <translation>限值是两个数，小的在前。</translation>
        </message>
        <message>
            <source>A logarithmic scale begins above zero.</source>
            <translation>对数刻度须从零以上开始。</translation>
        </message>
</context>
<context>
    <name>LimitsDialog</name>
        <message>
            <source>Value Limits: %1</source>
            <translation>数值范围：%1</translation>
        </message>
        <message>
            <source>Left axis</source>
            <translation>左轴</translation>
        </message>
        <message>
            <source>Right axis</source>
            <translation>右轴</translation>
        </message>
</context>
<context>
    <name>LimitFields</name>
        <message>
            <source>fixed</source>
            <translation>固定</translation>
        </message>
        <message>
            <source>%1: fixed limits</source>
            <translation>%1：固定限值</translation>
        </message>
        <message>
            <source>%1: from</source>
            <translation>%1：从</translation>
        </message>
        <message>
            <source>%1: to</source>
            <translation>%1：到</translation>
        </message>
        <message>
            <source>In ns, or with its unit: ns, µs, ms, s</source>
            <translation>以 ns 为单位，或带单位：ns、µs、ms、s</translation>
        </message>
        <message>
            <source>A number</source>
            <translation>一个数</translation>
        </message>
        <message>
            <source>A number, in %1</source>
            <translation>一个数，单位 %1</translation>
        </message>
</context>
<context>
    <name>SignalTree</name>
        <message>
            <source>Bus</source>
            <translation>总线</translation>
        </message>
        <message>
            <source>Variables of the process image</source>
            <translation>过程映像的变量</translation>
        </message>
        <message>
            <source>%1 (no values so far)</source>
            <translation>%1（目前没有值）</translation>
        </message>
</context>
<context>
    <name>ReadingProgress</name>
        <message>
            <source>Reading %1…</source>
            <translation>正在读取 %1…</translation>
        </message>
        <message>
            <source>Cancel</source>
            <translation>取消</translation>
        </message>
        <message>
            <source>Single slaves, counts, figures and events are shown as soon as all of it is read.</source>
            <translation>单个从站、计数、统计值和事件在全部读完后显示。</translation>
        </message>
</context>
<context>
    <name>OpeningPicture</name>
        <message>
            <source>First picture of the recording</source>
            <translation>记录的第一幅图</translation>
        </message>
</context>
<context>
    <name>TimingDiagram</name>
    <message>
        <source>Each frame reads the times of latched edges (0x09AE to 0x09CF).</source>
        <translation>每个帧都读取所锁存沿的时间（0x09AE 至 0x09CF）。</translation>
    </message>
    <message>
        <source>The latch takes one edge until its time is read (0x09A8).</source>
        <translation>锁存器捕获一个沿，直到其时间被读取（0x09A8）。</translation>
    </message>
    <message>
        <source>The device's own controller has the latch unit (0x09A8).</source>
        <translation>锁存单元由设备自身的控制器使用（0x09A8）。</translation>
    </message>
    <message>
        <source>Latch</source>
        <translation>锁存</translation>
    </message>
        <message>
            <source>Without SYNC0 the device works when its outputs come.</source>
            <translation>没有 SYNC0 时，设备在收到输出后工作。</translation>
        </message>
        <message>
            <source>Outputs are complete at the slave %1 after the frame has passed the reference clock.</source>
            <translation>帧经过参考时钟 %1 后，输出在从站处完整。</translation>
        </message>
        <message>
            <source>It calculates and copies for %1.</source>
            <translation>它计算并复制 %1。</translation>
        </message>
        <message>
            <source>SYNC0 comes at %1, every %2.</source>
            <translation>SYNC0 在 %1 到来，每 %2 一次。</translation>
        </message>
        <message>
            <source>SYNC1 comes at %1, every %2.</source>
            <translation>SYNC1 在 %1 到来，每 %2 一次。</translation>
        </message>
        <message>
            <source>%1 are left before SYNC0, which is too little.</source>
            <translation>SYNC0 之前剩余 %1，太少。</translation>
        </message>
        <message>
            <source>%1 are left before SYNC0.</source>
            <translation>SYNC0 之前剩余 %1。</translation>
        </message>
        <message>
            <source>Frame</source>
            <translation>帧</translation>
        </message>
        <message>
            <source>Calc + copy</source>
            <translation>计算 + 复制</translation>
        </message>
</context>
    <context>
    <name>TracePanel</name>
        <message>
            <source>Mean 95 %</source>
            <translation>均值 95 %</translation>
        </message>
    </context>
<context>
    <name>SpokenValue</name>
        <message>
            <source>Nothing is shown</source>
            <translation>未显示任何内容</translation>
        </message>
</context>
<context>
    <name>SignalQuality</name>
        <message>
            <source>%1, within %2</source>
            <translation>%1，误差不超过 %2</translation>
        </message>
        <message>
            <source>the newest is %1 old</source>
            <translation>最新值距今 %1</translation>
        </message>
        <message>
            <source>%1 readings a second</source>
            <translation>每秒 %1 次读取</translation>
        </message>
        <message>
            <source>nobody tells who stamped the moment</source>
            <translation>未知时刻由谁打戳</translation>
        </message>
        <message>
            <source>moment stamped by a probe, in hardware</source>
            <translation>时刻由硬件探针打戳</translation>
        </message>
        <message>
            <source>moment stamped by the host that captured the frames</source>
            <translation>时刻由抓包主机打戳</translation>
        </message>
        <message>
            <source>moment stamped by the network card</source>
            <translation>时刻由网卡打戳</translation>
        </message>
        <message>
            <source>moment stamped by the kernel</source>
            <translation>时刻由内核打戳</translation>
        </message>
        <message>
            <source>moment stamped by the master's software</source>
            <translation>时刻由主站软件打戳</translation>
        </message>
        <message>
            <source>by the reference clock and the host's clock</source>
            <translation>按参考时钟和主机时钟</translation>
        </message>
        <message>
            <source>by the clocks of the slaves</source>
            <translation>按从站时钟</translation>
        </message>
        <message>
            <source>by the host's clock</source>
            <translation>按主机时钟</translation>
        </message>
</context>
<context>
    <name>ImportDialog</name>
    <message>
        <source>none</source>
        <translation>无</translation>
    </message>
    <message>
        <source>Import a Capture</source>
        <translation>导入抓包</translation>
    </message>
    <message>
        <source>Times count from the first frame of %1.</source>
        <translation>时间从 %1 的第一帧算起。</translation>
    </message>
    <message>
        <source>From</source>
        <translation>从</translation>
    </message>
    <message>
        <source>Until</source>
        <translation>到</translation>
    </message>
    <message>
        <source>end of the file</source>
        <translation>文件末尾</translation>
    </message>
    <message>
        <source>At most</source>
        <translation>最多</translation>
    </message>
    <message>
        <source>all frames</source>
        <translation>所有帧</translation>
    </message>
    <message>
        <source> frames</source>
        <translation> 帧</translation>
    </message>
    <message>
        <source>Limit of the slaves' deviation</source>
        <translation>从站偏差的界限</translation>
    </message>
    <message>
        <source>Limit of the master's error</source>
        <translation>主站误差的界限</translation>
    </message>
    <message>
        <source>&amp;From</source>
        <translation>从(&amp;F)</translation>
    </message>
    <message>
        <source>&amp;Until</source>
        <translation>到(&amp;U)</translation>
    </message>
    <message>
        <source>At &amp;most</source>
        <translation>最多(&amp;M)</translation>
    </message>
    <message>
        <source>Limit of the slaves' &amp;deviation</source>
        <translation>从站偏差的界限(&amp;D)</translation>
    </message>
    <message>
        <source>Limit of the master's &amp;error</source>
        <translation>主站误差的界限(&amp;E)</translation>
    </message>
    <message>
        <source>OK</source>
        <translation>确定</translation>
    </message>
    <message>
        <source>The end comes before the begin.</source>
        <translation>结束早于开始。</translation>
    </message>
</context>
<context>
    <name>StartBar</name>
        <message>
            <source>Start that failed</source>
            <translation>启动失败</translation>
        </message>
        <message>
            <source>Why the machine did not start</source>
            <translation>机器未启动的原因</translation>
        </message>
        <message>
            <source>Show the Slave</source>
            <translation>显示从站</translation>
        </message>
        <message>
            <source>Show the slave that it is about</source>
            <translation>显示相关从站</translation>
        </message>
        <message>
            <source>Scan and Compare…</source>
            <translation>扫描并比较…</translation>
        </message>
        <message>
            <source>Scan the bus and compare</source>
            <translation>扫描总线并比较</translation>
        </message>
        <message>
            <source>Looks what is on the bus and shows it beside the project: missing, more, another revision</source>
            <translation>查看总线上的设备并与项目并列显示：缺少、多出、修订版不同</translation>
        </message>
        <message>
            <source>Close</source>
            <translation>关闭</translation>
        </message>
        <message>
            <source>Close; the messages keep it</source>
            <translation>关闭；消息中仍会保留</translation>
        </message>
        <message>
            <source>The machine did not start. %1: %2</source>
            <translation>机器未启动。%1：%2</translation>
        </message>
        <message>
            <source>The machine did not start; the messages say how far it came.</source>
            <translation>机器未启动；消息中说明了进行到哪一步。</translation>
        </message>
        <message numerus="yes">
            <source>(%n further slave(s) in the messages)</source>
            <translation>
                <numerusform>（消息中另有 %n 个从站）</numerusform>
            </translation>
        </message>
</context>
<context>
    <name>Picture</name>
        <message>
            <source>Syncline, %1, cycle %2</source>
            <translation>Syncline，%1，周期 %2</translation>
        </message>
        <message>
            <source>Syncline, simulated machine, %1, cycle %2</source>
            <translation>Syncline，模拟机器，%1，周期 %2</translation>
        </message>
</context>
</TS>
