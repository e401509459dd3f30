<?xml version="1.0" encoding="utf-8"?>
<!-- SPDX-License-Identifier: Apache-2.0 -->
<!DOCTYPE TS>
<TS version="2.1" language="zh_CN" sourcelanguage="en">
<context>
    <name>Finding</name>
    <message>
        <source>"{name}" is the name of slave {slave}, too</source>
        <translation>“{name}”也是从站 {slave} 的名称</translation>
    </message>
    <message>
        <source>"{variable}" is a {type} of {bits:# bit|# bits}, which has {has}</source>
        <translation>“{variable}”的类型 {type} 为 {bits} 位，而变量为 {has}</translation>
    </message>
    <message>
        <source>"{variable}" shares bits with "{other}"</source>
        <translation>“{variable}”与“{other}”占用了相同的位</translation>
    </message>
    <message>
        <source>"{variable}" takes bits {first} to {last}, the image has {image}</source>
        <translation>“{variable}”占用第 {first} 位到第 {last} 位，过程映像只有 {image} 位</translation>
    </message>
    <message>
        <source>0 is what all slaves have before they are set up, so commands reach any of them</source>
        <translation>0 是所有从站在配置之前的地址，命令会到达其中任意一个从站</translation>
    </message>
    <message>
        <source>0, 1, true or false</source>
        <translation>0、1、true 或 false</translation>
    </message>
    <message>
        <source>0x0400, 0x0420 and the watchdog bit in the SM control byte</source>
        <translation>0x0400、0x0420 以及 SM 控制字节中的看门狗位</translation>
    </message>
    <message>
        <source>0x0990 is set to {written}, ShiftTime says {said}</source>
        <translation>0x0990 被设为 {written}，而 ShiftTime 为 {said}</translation>
    </message>
    <message>
        <source>0x09A0 against the multiples that the device supports</source>
        <translation>0x09A0 是否为设备支持的倍数</translation>
    </message>
    <message>
        <source>0x09A0 is set to {written}, CycleTime0 says {said}</source>
        <translation>0x09A0 被设为 {written}，而 CycleTime0 为 {said}</translation>
    </message>
    <message>
        <source>0x09A4 against the ESI's factor and shift</source>
        <translation>0x09A4 与 ESI 中的系数和偏移是否一致</translation>
    </message>
    <message>
        <source>0x09A4 is set to {written}, CycleTime1 says {said}</source>
        <translation>0x09A4 被设为 {written}，而 CycleTime1 为 {said}</translation>
    </message>
    <message>
        <source>0x1C32:01 against the DC activation 0x0980</source>
        <translation>0x1C32:01 与 DC 激活寄存器 0x0980 是否一致</translation>
    </message>
    <message>
        <source>0xF050 against 0xF030</source>
        <translation>0xF050 与 0xF030 是否一致</translation>
    </message>
    <message>
        <source>1 cycle left out, the host sent nothing for up to {standstill}</source>
        <translation>遗漏 1 个周期，主机最长 {standstill} 未发送任何内容</translation>
    </message>
    <message>
        <source>1 frame back late, {late} after the deadline</source>
        <translation>1 个帧返回过迟，超过截止时间 {late}</translation>
    </message>
    <message>
        <source>1 frame back late, {late} after the deadline (told as lost before)</source>
        <translation>1 个帧返回过迟，超过截止时间 {late}（此前报告为丢失）</translation>
    </message>
    <message>
        <source>6 bytes of two hexadecimal digits each</source>
        <translation>6 个字节，每个字节为两位十六进制数</translation>
    </message>
    <message>
        <source>&lt;{element}&gt; in &lt;{parent}&gt;</source>
        <translation>&lt;{parent}&gt; 中的 &lt;{element}&gt;</translation>
    </message>
    <message>
        <source>&lt;{element}&gt; in &lt;{parent}&gt;, {count:# time|# times}</source>
        <translation>&lt;{parent}&gt; 中的 &lt;{element}&gt;，共 {count} 次</translation>
    </message>
    <message>
        <source>&lt;{element}&gt; is "{value}" instead of {wanted}</source>
        <translation>&lt;{element}&gt; 的值为“{value}”，应为：{wanted}</translation>
    </message>
    <message>
        <source>&lt;{element}&gt; stands behind elements of &lt;{parent}&gt; that it has to precede</source>
        <translation>&lt;{element}&gt; 排在 &lt;{parent}&gt; 中本应位于其后的元素之后</translation>
    </message>
    <message>
        <source>&lt;{element}&gt; stands {count:# time|# times} in &lt;{parent}&gt;, allowed are {most}</source>
        <translation>&lt;{element}&gt; 在 &lt;{parent}&gt; 中出现 {count} 次，最多允许 {most} 次</translation>
    </message>
    <message>
        <source>&lt;{parent}&gt; has both &lt;{one}&gt; and &lt;{other}&gt;</source>
        <translation>&lt;{parent}&gt; 同时含有 &lt;{one}&gt; 和 &lt;{other}&gt;</translation>
    </message>
    <message>
        <source>&lt;{parent}&gt; has neither &lt;{one}&gt; nor &lt;{other}&gt;</source>
        <translation>&lt;{parent}&gt; 既没有 &lt;{one}&gt; 也没有 &lt;{other}&gt;</translation>
    </message>
    <message>
        <source>&lt;{parent}&gt; has no &lt;{element}&gt;</source>
        <translation>&lt;{parent}&gt; 中缺少 &lt;{element}&gt;</translation>
    </message>
    <message>
        <source>&lt;{parent}&gt; has no attribute {attribute}</source>
        <translation>&lt;{parent}&gt; 缺少属性 {attribute}</translation>
    </message>
    <message>
        <source>A CAN cycle that does not fit the bus cycle</source>
        <translation>CAN 周期与总线周期不匹配</translation>
    </message>
    <message>
        <source>A PDI watchdog expired</source>
        <translation>PDI 看门狗超时</translation>
    </message>
    <message>
        <source>A PDO and the SyncManagers' lists contradict each other</source>
        <translation>PDO 与同步管理器的列表相互矛盾</translation>
    </message>
    <message>
        <source>A PDO is assigned twice</source>
        <translation>同一个 PDO 被分配了两次</translation>
    </message>
    <message>
        <source>A PDO is described twice</source>
        <translation>同一个 PDO 被描述了两次</translation>
    </message>
    <message>
        <source>A PDO lies in a SyncManager that it must not lie in</source>
        <translation>PDO 位于不允许它使用的同步管理器中</translation>
    </message>
    <message>
        <source>A PDO that the device does not have</source>
        <translation>设备没有的 PDO</translation>
    </message>
    <message>
        <source>A SYNC0 cycle does not fit the bus cycle; make it a multiple or a divisor.</source>
        <translation>SYNC0 周期与总线周期不匹配；请设为总线周期的整数倍或整数分之一。</translation>
    </message>
    <message>
        <source>A SYNC0 cycle that the device does not take</source>
        <translation>设备不接受的 SYNC0 周期</translation>
    </message>
    <message>
        <source>A SYNC0 cycle that the device takes with losses</source>
        <translation>设备接受但会有功能损失的 SYNC0 周期</translation>
    </message>
    <message>
        <source>A SYNC1 time without SYNC1</source>
        <translation>设置了 SYNC1 时间，但未启用 SYNC1</translation>
    </message>
    <message>
        <source>A Sync Unit runs in a task that does not exist</source>
        <translation>同步单元所在的任务不存在</translation>
    </message>
    <message>
        <source>A Sync Unit that does not exist</source>
        <translation>不存在的同步单元</translation>
    </message>
    <message>
        <source>A SyncManager carries a PDO that the slave does not describe</source>
        <translation>同步管理器承载了从站未描述的 PDO</translation>
    </message>
    <message>
        <source>A SyncManager is set behind the request for the state that needs it</source>
        <translation>同步管理器在请求需要它的状态之后才设置</translation>
    </message>
    <message>
        <source>A SyncManager is set to another length than its PDOs have</source>
        <translation>同步管理器设置的长度与其 PDO 的长度不同</translation>
    </message>
    <message>
        <source>A SyncManager is set to another start than its element says</source>
        <translation>同步管理器设置的起始地址与其元素中的不同</translation>
    </message>
    <message>
        <source>A SyncManager lies outside the memory for data</source>
        <translation>同步管理器位于数据存储区之外</translation>
    </message>
    <message>
        <source>A SyncManager needs more process data</source>
        <translation>同步管理器需要更多过程数据</translation>
    </message>
    <message>
        <source>A SyncManager that is not enabled is switched on</source>
        <translation>未启用的同步管理器被打开</translation>
    </message>
    <message>
        <source>A SyncManager's PDOs or sizes</source>
        <translation>同步管理器的 PDO 或大小</translation>
    </message>
    <message>
        <source>A SyncManager's settings</source>
        <translation>同步管理器的设置</translation>
    </message>
    <message>
        <source>A buffer changes only when its last byte is read or written, so that data stay old</source>
        <translation>只有读写缓冲区的最后一个字节时缓冲区才会切换，因此数据一直是旧的</translation>
    </message>
    <message>
        <source>A cable is healed</source>
        <translation>电缆已恢复</translation>
    </message>
    <message>
        <source>A capture breaks off</source>
        <translation>抓包中途中断</translation>
    </message>
    <message>
        <source>A capture is cut off</source>
        <translation>抓包文件被截断</translation>
    </message>
    <message>
        <source>A check has a time-out of 0</source>
        <translation>某个检查的超时时间为 0</translation>
    </message>
    <message>
        <source>A check waits for another state than the one requested</source>
        <translation>检查等待的状态与请求的状态不同</translation>
    </message>
    <message>
        <source>A clock that stepped, was not initialised or cannot follow; its loop values and its propagation delay stand in its distributed clocks.</source>
        <translation>时钟发生跳变、未初始化或无法跟随；其控制环数值和传输延迟见其分布式时钟。</translation>
    </message>
    <message>
        <source>A clock that steps, or a reference clock that was exchanged; see the events of that moment.</source>
        <translation>时钟跳变或参考时钟被更换；请查看该时刻的事件。</translation>
    </message>
    <message>
        <source>A command has either a register or a logical address, and either data or a length: readers choose differently</source>
        <translation>命令要么有寄存器地址、要么有逻辑地址，要么有数据、要么有长度；两者并存时各读取软件的取舍不同</translation>
    </message>
    <message>
        <source>A command has no bytes</source>
        <translation>命令没有任何字节</translation>
    </message>
    <message>
        <source>A command requests another state than its transition leads to</source>
        <translation>命令请求的状态与其状态切换的目标状态不同</translation>
    </message>
    <message>
        <source>A command specifier that is not 1</source>
        <translation>命令说明符 (Ccs) 不为 1</translation>
    </message>
    <message>
        <source>A command that no slave can carry out</source>
        <translation>任何从站都无法执行的命令</translation>
    </message>
    <message>
        <source>A command to a clock register has the wrong length</source>
        <translation>写时钟寄存器的命令长度错误</translation>
    </message>
    <message>
        <source>A command's data lie outside the image</source>
        <translation>命令的数据位于过程映像之外</translation>
    </message>
    <message>
        <source>A configuration does not work out</source>
        <translation>配置无法成立</translation>
    </message>
    <message>
        <source>A copy between slaves reaches outside the image</source>
        <translation>从站间的数据复制超出过程映像</translation>
    </message>
    <message>
        <source>A cyclic command</source>
        <translation>循环命令</translation>
    </message>
    <message>
        <source>A cyclic command addresses no slave of the file</source>
        <translation>循环命令寻址的从站不在文件中</translation>
    </message>
    <message>
        <source>A cyclic synchronous mode without SYNC0</source>
        <translation>周期同步模式缺少 SYNC0</translation>
    </message>
    <message>
        <source>A device ID was not requested</source>
        <translation>未请求设备标识</translation>
    </message>
    <message>
        <source>A device is not in the configuration</source>
        <translation>设备不在配置中</translation>
    </message>
    <message>
        <source>A device is not known</source>
        <translation>设备未知</translation>
    </message>
    <message>
        <source>A device on the bus is not in the configuration</source>
        <translation>总线上的设备不在配置中</translation>
    </message>
    <message>
        <source>A download has another size than its object</source>
        <translation>下载的数据长度与对象长度不同</translation>
    </message>
    <message>
        <source>A drive interpolates over the wrong time: it moves in jerks, or refuses to</source>
        <translation>驱动器按错误的时间插补：运动不平稳，或拒绝运动</translation>
    </message>
    <message>
        <source>A field of an init command</source>
        <translation>初始化命令的字段</translation>
    </message>
    <message>
        <source>A file cannot be read</source>
        <translation>文件无法读取</translation>
    </message>
    <message>
        <source>A file cannot be written</source>
        <translation>文件无法写入</translation>
    </message>
    <message>
        <source>A file does not exist</source>
        <translation>文件不存在</translation>
    </message>
    <message>
        <source>A file is beyond what is read</source>
        <translation>文件超出可读取的大小</translation>
    </message>
    <message>
        <source>A file is not well-formed TOML</source>
        <translation>文件不是格式正确的 TOML</translation>
    </message>
    <message>
        <source>A file is not well-formed XML</source>
        <translation>文件不是格式正确的 XML</translation>
    </message>
    <message>
        <source>A frame is back only when it has passed all slaves, each of which takes about 1 us, or 0.3 us at E-bus: it meets the next cycle</source>
        <translation>帧要经过所有从站才返回，每个从站约需 1 µs（E-bus 约 0.3 µs）：它会与下一周期的帧相遇</translation>
    </message>
    <message>
        <source>A frame or datagram is too long for Ethernet</source>
        <translation>帧或数据报超过以太网允许的长度</translation>
    </message>
    <message>
        <source>A gateway that does not know the bus cycle</source>
        <translation>网关不知道总线周期</translation>
    </message>
    <message>
        <source>A gateway's fieldbus needs longer than a cycle</source>
        <translation>网关的现场总线所需时间超过一个周期</translation>
    </message>
    <message>
        <source>A hot-connect group came or went</source>
        <translation>热连接组接入或断开</translation>
    </message>
    <message>
        <source>A hot-connect group cannot be identified</source>
        <translation>热连接组无法识别</translation>
    </message>
    <message>
        <source>A hot-connect group does not have the members it says</source>
        <translation>热连接组的成员与声明不符</translation>
    </message>
    <message>
        <source>A key of a scenario cannot be used</source>
        <translation>场景中的键无法使用</translation>
    </message>
    <message>
        <source>A link is down</source>
        <translation>链路断开</translation>
    </message>
    <message>
        <source>A list can be changed only while its count is 0; slaves abort the write otherwise (0x06010000, 0x08000022)</source>
        <translation>列表只有在其计数为 0 时才能修改，否则从站会中止写入 (0x06010000, 0x08000022)</translation>
    </message>
    <message>
        <source>A list is written in an order that slaves refuse</source>
        <translation>列表的写入顺序会被从站拒绝</translation>
    </message>
    <message>
        <source>A loose plug at the host, or somebody who switches the adapter off: a network manager, power saving, the reset of a USB adapter.</source>
        <translation>主机侧插头松动，或网卡被关闭：网络管理器、节能功能、USB 网卡复位。</translation>
    </message>
    <message>
        <source>A loose plug or a weak supply; the lost links of the ports say which cable.</source>
        <translation>插头松动或供电不足；端口的链路丢失计数可指出是哪根电缆。</translation>
    </message>
    <message>
        <source>A loose plug, a bad cable, or a neighbour without power.</source>
        <translation>插头松动、电缆损坏，或相邻设备断电。</translation>
    </message>
    <message>
        <source>A mailbox SyncManager is set to other values than the mailbox says</source>
        <translation>邮箱同步管理器的设置值与邮箱声明的不同</translation>
    </message>
    <message>
        <source>A mailbox answered something else</source>
        <translation>邮箱响应了其他内容</translation>
    </message>
    <message>
        <source>A mailbox did not answer in time</source>
        <translation>邮箱未及时响应</translation>
    </message>
    <message>
        <source>A mailbox has an impossible size or place</source>
        <translation>邮箱的大小或位置不合理</translation>
    </message>
    <message>
        <source>A mailbox names no protocol</source>
        <translation>邮箱未声明任何协议</translation>
    </message>
    <message>
        <source>A mailbox without SyncManagers</source>
        <translation>邮箱没有同步管理器</translation>
    </message>
    <message>
        <source>A mailbox without usable size</source>
        <translation>邮箱没有可用的大小</translation>
    </message>
    <message>
        <source>A mandatory PDO is not assigned</source>
        <translation>必选 PDO 未分配</translation>
    </message>
    <message>
        <source>A master that goes by the commands runs whatever device stands in that place</source>
        <translation>按命令运行的主站，会接受该位置上的任何设备</translation>
    </message>
    <message>
        <source>A master that goes by the file leaves it in INIT; only masters that make the commands themselves run it</source>
        <translation>按文件运行的主站会让该从站停留在 INIT；只有自行生成命令的主站才能让它运行</translation>
    </message>
    <message>
        <source>A module demands another operation mode</source>
        <translation>模块要求另一种操作模式</translation>
    </message>
    <message>
        <source>A module does not fit into its place</source>
        <translation>模块不适合其插槽</translation>
    </message>
    <message>
        <source>A module is plugged into a place that is not there</source>
        <translation>模块插在不存在的插槽上</translation>
    </message>
    <message>
        <source>A module is plugged into place {place}; the device has {places}.</source>
        <translation>模块插在插槽 {place} 上；设备的插槽数：{places}。</translation>
    </message>
    <message>
        <source>A part of a recording is damaged</source>
        <translation>记录的一部分已损坏</translation>
    </message>
    <message>
        <source>A part of the ENI is not read</source>
        <translation>ENI 的一部分未被读取</translation>
    </message>
    <message>
        <source>A place must have a module</source>
        <translation>该插槽必须有模块</translation>
    </message>
    <message>
        <source>A port has one cable: the master finds another wiring than the one told</source>
        <translation>一个端口只能接一根电缆：主站检测到的接线会与声明的不同</translation>
    </message>
    <message>
        <source>A port lost its link</source>
        <translation>端口链路丢失</translation>
    </message>
    <message>
        <source>A previous port names a slave that is not in the file</source>
        <translation>PreviousPort 指向的从站不在文件中</translation>
    </message>
    <message>
        <source>A process data watchdog expired</source>
        <translation>过程数据看门狗超时</translation>
    </message>
    <message>
        <source>A process-data command has no working counter</source>
        <translation>过程数据命令没有工作计数器</translation>
    </message>
    <message>
        <source>A recording that was cut short has its last part in a log beside it.</source>
        <translation>被中断的记录，其最后部分位于旁边的日志中。</translation>
    </message>
    <message>
        <source>A required element or attribute is missing</source>
        <translation>缺少必需的元素或属性</translation>
    </message>
    <message>
        <source>A scan touches a machine that runs</source>
        <translation>扫描会影响正在运行的机器</translation>
    </message>
    <message>
        <source>A serial number is to be compared, and none is known</source>
        <translation>要比较序列号，但没有已知的序列号</translation>
    </message>
    <message>
        <source>A setting of the master synchronisation is out of range</source>
        <translation>主站同步的某项设置超出范围</translation>
    </message>
    <message>
        <source>A setting that no ENI carries</source>
        <translation>任何 ENI 都不包含的设置</translation>
    </message>
    <message>
        <source>A slave aborted an SDO transfer</source>
        <translation>从站中止了 SDO 传输</translation>
    </message>
    <message>
        <source>A slave answers again</source>
        <translation>从站恢复响应</translation>
    </message>
    <message>
        <source>A slave answers in a few to some hundred milliseconds; the command fails before</source>
        <translation>从站的响应需要几毫秒到几百毫秒，命令在此之前就会失败</translation>
    </message>
    <message>
        <source>A slave could not be led up again</source>
        <translation>从站无法重新启动到运行状态</translation>
    </message>
    <message>
        <source>A slave did not answer for a while</source>
        <translation>从站曾有一段时间没有响应</translation>
    </message>
    <message>
        <source>A slave did not process a datagram</source>
        <translation>从站未处理数据报</translation>
    </message>
    <message>
        <source>A slave did not reach a state in time</source>
        <translation>从站未及时到达状态</translation>
    </message>
    <message>
        <source>A slave does not answer</source>
        <translation>从站没有响应</translation>
    </message>
    <message>
        <source>A slave does not answer behind a cable</source>
        <translation>电缆后的从站没有响应</translation>
    </message>
    <message>
        <source>A slave does not renew its inputs in each cycle</source>
        <translation>从站不是每个周期都更新输入</translation>
    </message>
    <message>
        <source>A slave does not take its outputs in each cycle</source>
        <translation>从站不是每个周期都取走输出</translation>
    </message>
    <message>
        <source>A slave ended a file transfer</source>
        <translation>从站结束了文件传输</translation>
    </message>
    <message>
        <source>A slave hangs on a port that leads nowhere</source>
        <translation>从站接在一个无效的端口上</translation>
    </message>
    <message>
        <source>A slave hangs on itself or on one behind it</source>
        <translation>从站接在它自己或其后的从站上</translation>
    </message>
    <message>
        <source>A slave hangs on one that cannot stand in front of it</source>
        <translation>从站接在不可能位于它之前的从站上</translation>
    </message>
    <message>
        <source>A slave hangs on one that only swapped cables put behind it</source>
        <translation>从站接在仅因电缆接反才会在它之前的从站上</translation>
    </message>
    <message>
        <source>A slave hangs on port B, C or D of its predecessor.</source>
        <translation>从站应接在前一从站的端口 B、C 或 D 上。</translation>
    </message>
    <message>
        <source>A slave has a new diagnosis message</source>
        <translation>从站有新的诊断消息</translation>
    </message>
    <message>
        <source>A slave has left OP after its firmware had stood still</source>
        <translation>从站因其固件曾停止运行而退出 OP</translation>
    </message>
    <message>
        <source>A slave has left OP after missed SM2 events</source>
        <translation>从站因错过 SM2 事件而退出 OP</translation>
    </message>
    <message>
        <source>A slave has left OP because a clock had moved</source>
        <translation>从站因某个时钟发生了移动而退出 OP</translation>
    </message>
    <message>
        <source>A slave has left OP because frames came too late</source>
        <translation>从站因帧到达过晚而退出 OP</translation>
    </message>
    <message>
        <source>A slave has left OP while the bus was in order</source>
        <translation>总线正常时从站退出 OP</translation>
    </message>
    <message>
        <source>A slave has left OP with an error</source>
        <translation>从站因错误退出 OP</translation>
    </message>
    <message>
        <source>A slave has no init commands</source>
        <translation>从站没有初始化命令</translation>
    </message>
    <message>
        <source>A slave has the station address 0</source>
        <translation>从站的站地址为 0</translation>
    </message>
    <message>
        <source>A slave in DC mode checks its SYNC signals on that way and refuses (AL status code 0x0030 or 0x002D)</source>
        <translation>处于 DC 模式的从站在此状态切换过程中会检查 SYNC 信号并拒绝切换（AL 状态码 0x0030 或 0x002D）</translation>
    </message>
    <message>
        <source>A slave is addressed by its station address before it has one</source>
        <translation>从站尚未分配站地址就按站地址寻址</translation>
    </message>
    <message>
        <source>A slave is another device than configured</source>
        <translation>从站与配置的设备不同</translation>
    </message>
    <message>
        <source>A slave is given another station address than its PhysAddr</source>
        <translation>从站被设置的站地址与其 PhysAddr 不同</translation>
    </message>
    <message>
        <source>A slave is known by an alias that it does not have</source>
        <translation>按别名识别从站，但该从站没有别名</translation>
    </message>
    <message>
        <source>A slave is led up again</source>
        <translation>正在重新启动从站</translation>
    </message>
    <message>
        <source>A slave is not in sync</source>
        <translation>有一个从站未同步</translation>
    </message>
    <message>
        <source>A slave is not led up any more</source>
        <translation>不再重新启动从站</translation>
    </message>
    <message>
        <source>A slave lacks the clock that its ESI has</source>
        <translation>从站缺少其 ESI 中的时钟</translation>
    </message>
    <message>
        <source>A slave left OP, lost its link or did not serve its data.</source>
        <translation>有从站退出了 OP、丢失链路或未处理其数据。</translation>
    </message>
    <message>
        <source>A slave left the sync window for a while</source>
        <translation>从站曾一度超出同步窗口</translation>
    </message>
    <message>
        <source>A slave needs longer than its cycle</source>
        <translation>从站所需时间超过其周期</translation>
    </message>
    <message>
        <source>A slave of the configuration is missing</source>
        <translation>配置中的从站缺失</translation>
    </message>
    <message>
        <source>A slave refused a state</source>
        <translation>从站拒绝了状态</translation>
    </message>
    <message>
        <source>A slave refused a state or left one by itself</source>
        <translation>从站拒绝了状态或自行退出了状态</translation>
    </message>
    <message>
        <source>A slave refuses to go on</source>
        <translation>某从站拒绝继续</translation>
    </message>
    <message>
        <source>A slave sent an emergency</source>
        <translation>从站发送了紧急消息</translation>
    </message>
    <message>
        <source>A slave stays behind the others</source>
        <translation>从站的状态落后于其他从站</translation>
    </message>
    <message>
        <source>A slave with distributed clocks stands before the reference clock</source>
        <translation>带分布式时钟的从站位于参考时钟之前</translation>
    </message>
    <message>
        <source>A slave's SYNC0 comes at another time than configured</source>
        <translation>某从站的 SYNC0 到来时刻与配置不同</translation>
    </message>
    <message>
        <source>A slave's SYNC0 does not come</source>
        <translation>某从站的 SYNC0 未到来</translation>
    </message>
    <message>
        <source>A slave's cables IN and OUT are swapped</source>
        <translation>从站的 IN 和 OUT 电缆接反</translation>
    </message>
    <message>
        <source>A slave's clock was off</source>
        <translation>从站的时钟曾有偏差</translation>
    </message>
    <message>
        <source>A slave's firmware is fast enough again</source>
        <translation>从站固件的速度已恢复</translation>
    </message>
    <message>
        <source>A slave's firmware is slow</source>
        <translation>从站固件运行缓慢</translation>
    </message>
    <message>
        <source>A slave's firmware stood still</source>
        <translation>从站固件曾停止运行</translation>
    </message>
    <message>
        <source>A slave's mailbox does not answer</source>
        <translation>从站的邮箱没有响应</translation>
    </message>
    <message>
        <source>A start-up command</source>
        <translation>启动命令</translation>
    </message>
    <message>
        <source>A start-up command and a setting write different values</source>
        <translation>启动命令与设置写入的值不同</translation>
    </message>
    <message>
        <source>A start-up command has hardly any time</source>
        <translation>启动命令的时间过短</translation>
    </message>
    <message>
        <source>A start-up command has no data</source>
        <translation>启动命令没有数据</translation>
    </message>
    <message>
        <source>A start-up command on a transition without mailbox</source>
        <translation>启动命令位于没有邮箱的状态切换上</translation>
    </message>
    <message>
        <source>A synchronisation setting that cannot be set</source>
        <translation>某项同步设置无法生效</translation>
    </message>
    <message>
        <source>A synchronisation type that does not use the SYNC signals</source>
        <translation>同步类型不使用 SYNC 信号</translation>
    </message>
    <message>
        <source>A synchronisation type that the device does not take</source>
        <translation>设备不接受的同步类型</translation>
    </message>
    <message>
        <source>A table is cut off</source>
        <translation>表格被截断</translation>
    </message>
    <message>
        <source>A task without cycle time</source>
        <translation>任务没有周期时间</translation>
    </message>
    <message>
        <source>A value cannot be used</source>
        <translation>值无法使用</translation>
    </message>
    <message>
        <source>A value has the wrong type or is out of range</source>
        <translation>值的类型错误或超出范围</translation>
    </message>
    <message>
        <source>A value is written in a form that the schema does not allow</source>
        <translation>值的书写形式不符合模式 (schema)</translation>
    </message>
    <message>
        <source>A value stands in a form that no reader understands, so that nothing behind it was checked by meaning</source>
        <translation>该值的形式没有任何读取软件能理解，因此其后的内容未做语义检查</translation>
    </message>
    <message>
        <source>A variable</source>
        <translation>变量</translation>
    </message>
    <message>
        <source>A variable has another size than its type</source>
        <translation>变量的长度与其类型的长度不同</translation>
    </message>
    <message>
        <source>A variable lies outside the process image</source>
        <translation>变量位于过程映像之外</translation>
    </message>
    <message>
        <source>A working counter is not what is expected</source>
        <translation>工作计数器与预期不符</translation>
    </message>
    <message>
        <source>Activate SYNC1 (0x0400), or set CycleTime1 to 0</source>
        <translation>激活 SYNC1 (0x0400)，或将 CycleTime1 设为 0</translation>
    </message>
    <message>
        <source>Activation (0x0980)</source>
        <translation>激活 (0x0980)</translation>
    </message>
    <message>
        <source>Add Cnt</source>
        <translation>添加 Cnt</translation>
    </message>
    <message>
        <source>Add NOP 0x0900 and ARMW 0x0910 to the cyclic commands</source>
        <translation>在循环命令中添加 NOP 0x0900 和 ARMW 0x0910</translation>
    </message>
    <message>
        <source>Add PollTime, or StatusBitAddr with an FMMU for the status bit</source>
        <translation>添加 PollTime，或添加 StatusBitAddr 以及用于该状态位的 FMMU</translation>
    </message>
    <message>
        <source>Add a BRD of 0x0130 with 2 bytes</source>
        <translation>添加读取 0x0130 的 BRD，长度 2 字节</translation>
    </message>
    <message>
        <source>Add a NOP with Ado 2304 and 4 bytes before the ARMW</source>
        <translation>在 ARMW 之前添加 Ado 为 2304、长度 4 字节的 NOP</translation>
    </message>
    <message>
        <source>Add a read of 0x0130 with Validate behind the request</source>
        <translation>在请求之后添加带 Validate 的 0x0130 读取命令</translation>
    </message>
    <message>
        <source>Add the AL control write (0x0120) on that transition</source>
        <translation>在该状态切换上添加写 AL 控制 (0x0120) 的命令</translation>
    </message>
    <message>
        <source>Add the FMMU on PS, or take the PDOs out of the assignment</source>
        <translation>在 PS 上添加该 FMMU，或将这些 PDO 从分配中移除</translation>
    </message>
    <message>
        <source>Add the Protocol, or remove the commands</source>
        <translation>添加 Protocol，或删除这些命令</translation>
    </message>
    <message>
        <source>Add the Sync Unit, or choose another.</source>
        <translation>添加该同步单元，或选择其他同步单元。</translation>
    </message>
    <message>
        <source>Add the broadcast writes of 0x0010, 0x0600 and 0x0800 on IP to the master's init commands</source>
        <translation>在主站的初始化命令中为 IP 添加对 0x0010、0x0600 和 0x0800 的广播写</translation>
    </message>
    <message>
        <source>Add the element, or export the file again with the tool that made it</source>
        <translation>添加该元素，或用生成该文件的工具重新导出</translation>
    </message>
    <message>
        <source>Add the folder of its ESI to the catalogue, then import again.</source>
        <translation>将其 ESI 所在文件夹加入目录，然后重新导入。</translation>
    </message>
    <message>
        <source>Add the reads of vendor and product from the EEPROM with Validate on IP</source>
        <translation>在 IP 上添加从 EEPROM 读取供应商和产品代码并带 Validate 的命令</translation>
    </message>
    <message>
        <source>Add the state SAFEOP to the command</source>
        <translation>在命令中添加状态 SAFEOP</translation>
    </message>
    <message>
        <source>Add the task, or choose another for the Sync Unit.</source>
        <translation>添加该任务，或为同步单元选择其他任务。</translation>
    </message>
    <message>
        <source>Add the write of 0 to 0x0980 on SP, OP, SI and OI</source>
        <translation>在 SP、OP、SI 和 OI 上添加向 0x0980 写 0 的命令</translation>
    </message>
    <message>
        <source>Add the write of 8 bytes at 0x0990 before 0x0980</source>
        <translation>在 0x0980 之前添加对 0x0990 的 8 字节写入</translation>
    </message>
    <message>
        <source>Add the write of its 8 bytes at 0x0800 + 8 n on PS</source>
        <translation>在 PS 上添加向 0x0800 + 8 n 写入其 8 个字节的命令</translation>
    </message>
    <message>
        <source>Add the write of its 8 bytes at 0x0800 or 0x0808 on IP</source>
        <translation>在 IP 上添加向 0x0800 或 0x0808 写入其 8 个字节的命令</translation>
    </message>
    <message>
        <source>Added</source>
        <translation>新增</translation>
    </message>
    <message>
        <source>Addresses for a device without EoE</source>
        <translation>为不支持 EoE 的设备设置了地址</translation>
    </message>
    <message>
        <source>Alias</source>
        <translation>别名</translation>
    </message>
    <message>
        <source>All slaves moved at once and to the same side at {since}, out of the sync window ({deviation}, limit {limit}), and came back, {count} in all. The reference clock stepped or changed its rate{led}.</source>
        <translation>所有从站在 {since} 同时向同一侧移出了同步窗口（{deviation}，限值 {limit}），之后恢复，共 {count}。参考时钟发生了跳变或改变了速率{led}。</translation>
    </message>
    <message>
        <source>All slaves moved at once and to the same side at {since}, out of the sync window ({deviation}, limit {limit}). No reading is outside any more, but not for the settle time yet. The reference clock stepped or changed its rate{led}.</source>
        <translation>所有从站在 {since} 同时向同一侧移出了同步窗口（{deviation}，限值 {limit}）。已没有读数在窗口之外，但尚未持续达到稳定时间。参考时钟发生了跳变或改变了速率{led}。</translation>
    </message>
    <message>
        <source>All slaves moved at once and to the same side at {since}, out of the sync window ({deviation}, limit {limit}). The reference clock stepped or changed its rate{led}.</source>
        <translation>所有从站在 {since} 同时向同一侧移出了同步窗口（{deviation}，限值 {limit}）。参考时钟发生了跳变或改变了速率{led}。</translation>
    </message>
    <message>
        <source>An AMS Net ID for a device without AoE</source>
        <translation>为不支持 AoE 的设备设置了 AMS Net ID</translation>
    </message>
    <message>
        <source>An EEPROM (SII) cannot be used</source>
        <translation>EEPROM (SII) 无法使用</translation>
    </message>
    <message>
        <source>An EEPROM's checksum is wrong</source>
        <translation>EEPROM 的校验和错误</translation>
    </message>
    <message>
        <source>An ENI does not hold all settings of the clocks</source>
        <translation>ENI 不包含时钟的全部设置</translation>
    </message>
    <message>
        <source>An ENI file holds whole microseconds: {cycle} is rounded there. Masters that take the cycle from the file run at another rate than the SYNC signals.</source>
        <translation>ENI 文件只能保存整数微秒：{cycle} 在其中会被取整。从文件读取周期的主站，其运行频率会与 SYNC 信号不同。</translation>
    </message>
    <message>
        <source>An ENI keeps the layout of its image</source>
        <translation>ENI 保持其过程映像的布局</translation>
    </message>
    <message>
        <source>An ENI says of the clocks' settings only which commands are sent: limit and settle time of the sync window, set value, burst and controller have their defaults.</source>
        <translation>关于时钟设置，ENI 只说明发送哪些命令：同步窗口的限值和稳定时间、设定值、突发数和控制器均取默认值。</translation>
    </message>
    <message>
        <source>An FMMU</source>
        <translation>FMMU</translation>
    </message>
    <message>
        <source>An FMMU does not map the whole buffer of a SyncManager</source>
        <translation>FMMU 没有映射同步管理器的整个缓冲区</translation>
    </message>
    <message>
        <source>An FMMU has contradictory values</source>
        <translation>FMMU 的值相互矛盾</translation>
    </message>
    <message>
        <source>An FMMU is set behind the request for the state that needs it</source>
        <translation>FMMU 在请求需要它的状态之后才设置</translation>
    </message>
    <message>
        <source>An FMMU maps a SyncManager in the wrong direction</source>
        <translation>FMMU 以错误的方向映射同步管理器</translation>
    </message>
    <message>
        <source>An FMMU maps memory that no SyncManager guards</source>
        <translation>FMMU 映射的存储区没有同步管理器保护</translation>
    </message>
    <message>
        <source>An element is missing</source>
        <translation>缺少元素</translation>
    </message>
    <message>
        <source>An element or attribute that ETG.2100 does not know</source>
        <translation>ETG.2100 中没有的元素或属性</translation>
    </message>
    <message>
        <source>An element stands more often than allowed</source>
        <translation>元素出现次数超过允许值</translation>
    </message>
    <message>
        <source>An element's value cannot be used</source>
        <translation>元素的值无法使用</translation>
    </message>
    <message>
        <source>An entry that the ESI fixes is not mapped</source>
        <translation>ESI 固定的条目未被映射</translation>
    </message>
    <message>
        <source>An error limit beyond the device's range</source>
        <translation>错误限值超出设备的范围</translation>
    </message>
    <message>
        <source>An impossible cycle time</source>
        <translation>周期时间不合理</translation>
    </message>
    <message>
        <source>An init command goes to another slave</source>
        <translation>初始化命令发往另一个从站</translation>
    </message>
    <message>
        <source>An init command of the master</source>
        <translation>主站的初始化命令</translation>
    </message>
    <message>
        <source>An older program has written it.</source>
        <translation>它由较旧的程序写入。</translation>
    </message>
    <message>
        <source>An optional slave</source>
        <translation>可选从站</translation>
    </message>
    <message>
        <source>Another clock leads</source>
        <translation>主导时钟已更换</translation>
    </message>
    <message>
        <source>Another slave is set up with the settings of this one</source>
        <translation>用本从站的设置配置了另一个从站</translation>
    </message>
    <message>
        <source>Another working counter is expected</source>
        <translation>预期的工作计数器不同</translation>
    </message>
    <message>
        <source>AoE address</source>
        <translation>AoE 地址</translation>
    </message>
    <message>
        <source>AoE, EoE, CoE, SoE, FoE or VoE</source>
        <translation>AoE、EoE、CoE、SoE、FoE 或 VoE</translation>
    </message>
    <message>
        <source>Assign fewer PDOs, or do without the mailbox state bit.</source>
        <translation>减少分配的 PDO，或不使用邮箱状态位。</translation>
    </message>
    <message>
        <source>Assign fewer PDOs, or map fewer objects.</source>
        <translation>减少分配的 PDO，或减少映射的对象。</translation>
    </message>
    <message>
        <source>Assign fewer PDOs.</source>
        <translation>减少分配的 PDO。</translation>
    </message>
    <message>
        <source>Assign fewer or more PDOs</source>
        <translation>减少或增加分配的 PDO</translation>
    </message>
    <message>
        <source>Assign it once.</source>
        <translation>只分配一次。</translation>
    </message>
    <message>
        <source>Assign it.</source>
        <translation>分配该 PDO。</translation>
    </message>
    <message>
        <source>Assign more PDOs.</source>
        <translation>分配更多 PDO。</translation>
    </message>
    <message>
        <source>Assign the PDO</source>
        <translation>分配该 PDO</translation>
    </message>
    <message>
        <source>AssignActivate against the ESI, and that it is written in PREOP</source>
        <translation>AssignActivate 与 ESI 是否一致，以及它是否在 PREOP 中写入</translation>
    </message>
    <message>
        <source>Auto-increment address</source>
        <translation>自动递增地址</translation>
    </message>
    <message>
        <source>AutoIncAddr is {said}, the place in the file makes it {expected}</source>
        <translation>AutoIncAddr 为 {said}，按文件中的位置应为 {expected}</translation>
    </message>
    <message>
        <source>B, C or D</source>
        <translation>B、C 或 D</translation>
    </message>
    <message>
        <source>Before that, at {since}, all slaves had moved at once and to the same side, out of the sync window ({deviation}, limit {limit}); {count} in all. The reference clock had stepped or changed its rate{led}.</source>
        <translation>在此之前，所有从站在 {since} 同时向同一侧移出了同步窗口（{deviation}，限值 {limit}）；共 {count}。参考时钟发生了跳变或改变了速率{led}。</translation>
    </message>
    <message>
        <source>Best effort instead of real time</source>
        <translation>尽力而为，而非实时</translation>
    </message>
    <message>
        <source>Bootstrap mailbox for answers</source>
        <translation>用于响应的 BOOT 邮箱</translation>
    </message>
    <message>
        <source>Bootstrap mailbox for requests</source>
        <translation>用于请求的 BOOT 邮箱</translation>
    </message>
    <message>
        <source>Both answer the commands to that address: working counters are 2 and data are mixed</source>
        <translation>两个从站都会响应发往该地址的命令：工作计数器为 2，数据混在一起</translation>
    </message>
    <message>
        <source>Both slaves get the same outputs, which is rarely meant</source>
        <translation>两个从站会得到相同的输出，这通常不是本意</translation>
    </message>
    <message>
        <source>Cancelled</source>
        <translation>已取消</translation>
    </message>
    <message>
        <source>Cancelled{because}.</source>
        <translation>已取消{because}。</translation>
    </message>
    <message>
        <source>Capture whole frames (a snap length of 0).</source>
        <translation>请抓取完整的帧（snap length 为 0）。</translation>
    </message>
    <message>
        <source>Capture whole frames (tcpdump -s 0).</source>
        <translation>抓取完整的帧 (tcpdump -s 0)。</translation>
    </message>
    <message>
        <source>Capture with a probe in the line, or at the master; compare with the lost frames that the master counts.</source>
        <translation>请用串接在线路中的探针或在主站处抓包；并与主站统计的丢帧数比较。</translation>
    </message>
    <message>
        <source>Check its name and folder.</source>
        <translation>检查其名称和文件夹。</translation>
    </message>
    <message>
        <source>Check its power and the cable to it, or take it out of the configuration.</source>
        <translation>检查其电源和连接电缆，或将它从配置中移除。</translation>
    </message>
    <message>
        <source>Check power, cabling and the working counter of the slaves before it.</source>
        <translation>检查电源、接线以及它之前各从站的工作计数器。</translation>
    </message>
    <message>
        <source>Check the cable and that the interface is up.</source>
        <translation>检查电缆以及接口是否已启用。</translation>
    </message>
    <message>
        <source>Check the cycle time and the host's timer frequency.</source>
        <translation>检查周期时间和主机的定时器频率。</translation>
    </message>
    <message>
        <source>Check the folder's permissions and free space.</source>
        <translation>检查文件夹的权限和可用空间。</translation>
    </message>
    <message>
        <source>Check the host's jitter and the clock's drift.</source>
        <translation>检查主机的抖动和时钟的漂移。</translation>
    </message>
    <message>
        <source>Check the plug at the host, and that the adapter is switched on (ip link set ... up); the bus comes back with it.</source>
        <translation>检查主机侧的插头，以及网卡是否已启用 (ip link set ... up)；网卡恢复后总线随之恢复。</translation>
    </message>
    <message>
        <source>Check the power of the first one and the cable that leads to it.</source>
        <translation>检查第一个无响应从站的供电以及通向它的电缆。</translation>
    </message>
    <message>
        <source>Check the power of the first one, and the cable and plugs between the two.</source>
        <translation>检查第一个无响应从站的供电，以及两者之间的电缆和插头。</translation>
    </message>
    <message>
        <source>Check them in the project.</source>
        <translation>请在项目中检查这些设置。</translation>
    </message>
    <message>
        <source>Check {check}.</source>
        <translation>检查：{check}。</translation>
    </message>
    <message>
        <source>Choose a cycle of up to 255 times a power of ten.</source>
        <translation>选择可表示为不超过 255 的整数乘以 10 的幂的周期。</translation>
    </message>
    <message>
        <source>Choose a cycle of whole microseconds.</source>
        <translation>选择整数微秒的周期。</translation>
    </message>
    <message>
        <source>Choose a cycle that all devices take (page General, button Accepted, or synclinectl project cycle-times)</source>
        <translation>选择所有设备都接受的周期（“常规”页面的“可接受的”按钮，或 synclinectl project cycle-times）</translation>
    </message>
    <message>
        <source>Choose a factor of that range.</source>
        <translation>选择该范围内的系数。</translation>
    </message>
    <message>
        <source>Choose a factor that divides the bus cycle.</source>
        <translation>选择能整除总线周期的系数。</translation>
    </message>
    <message>
        <source>Choose a larger set value.</source>
        <translation>选择更大的设定值。</translation>
    </message>
    <message>
        <source>Choose a longer cycle, or exchange less.</source>
        <translation>选择更长的周期，或减少交换的数据。</translation>
    </message>
    <message>
        <source>Choose a longer cycle, or let slow slaves run in a task of their own with a longer one.</source>
        <translation>选择更长的周期，或让慢速从站在周期更长的独立任务中运行。</translation>
    </message>
    <message>
        <source>Choose a longer cycle.</source>
        <translation>选择更长的周期。</translation>
    </message>
    <message>
        <source>Choose a lower address, or leave the choice open.</source>
        <translation>选择更低的地址，或不指定。</translation>
    </message>
    <message>
        <source>Choose a multiple of its full step</source>
        <translation>选择其完整步长的整数倍</translation>
    </message>
    <message>
        <source>Choose a multiple of the first task's cycle.</source>
        <translation>选择第一个任务周期的整数倍。</translation>
    </message>
    <message>
        <source>Choose a multiple or a whole fraction of the bus cycle.</source>
        <translation>选择总线周期的整数倍或整数分之一。</translation>
    </message>
    <message>
        <source>Choose a slave that stands before it in the frame.</source>
        <translation>选择在帧路径上位于它之前的从站。</translation>
    </message>
    <message>
        <source>Choose a slave with a distributed clock, or leave the choice open.</source>
        <translation>选择带分布式时钟的从站，或不指定。</translation>
    </message>
    <message>
        <source>Choose a value that the device takes.</source>
        <translation>选择设备接受的值。</translation>
    </message>
    <message>
        <source>Choose a value within the range.</source>
        <translation>选择范围内的值。</translation>
    </message>
    <message>
        <source>Choose another, or none.</source>
        <translation>选择其他模块，或不插模块。</translation>
    </message>
    <message>
        <source>Choose bus shift or master shift.</source>
        <translation>选择总线偏移或主站偏移。</translation>
    </message>
    <message>
        <source>Choose one of the ESI's operation modes.</source>
        <translation>选择 ESI 中的一种操作模式。</translation>
    </message>
    <message>
        <source>Choose one of these ports.</source>
        <translation>选择这些端口之一。</translation>
    </message>
    <message>
        <source>Choose that operation mode.</source>
        <translation>选择该操作模式。</translation>
    </message>
    <message>
        <source>Choose the first slave with DC.</source>
        <translation>选择第一个带 DC 的从站。</translation>
    </message>
    <message>
        <source>Choose the operation mode by hand.</source>
        <translation>手动选择操作模式。</translation>
    </message>
    <message>
        <source>Clear the AMS Net ID.</source>
        <translation>清空 AMS Net ID。</translation>
    </message>
    <message>
        <source>Clear the addresses.</source>
        <translation>清空这些地址。</translation>
    </message>
    <message>
        <source>Clocks drift apart before SYNC signals start, and slaves miss their first pulses</source>
        <translation>SYNC 信号启动之前时钟已相互漂移，从站会错过最初的脉冲</translation>
    </message>
    <message>
        <source>Cnt of {command} is {count}, one slave makes it {computed}</source>
        <translation>{command} 的 Cnt 为 {count}，按一个从站计算应为 {computed}</translation>
    </message>
    <message>
        <source>Cnt of {command} is {count}, the FMMUs make it {computed} ({readers:# slave|# slaves} read, {writers:# slave|# slaves} written)</source>
        <translation>{command} 的 Cnt 为 {count}，按 FMMU 计算应为 {computed}（读取 {readers} 个从站，写入 {writers} 个）</translation>
    </message>
    <message>
        <source>Cnt of {command} is {count}, the file has {slaves:# slave|# slaves}</source>
        <translation>{command} 的 Cnt 为 {count}，文件中有 {slaves} 个从站</translation>
    </message>
    <message>
        <source>Commands come in another order</source>
        <translation>命令的顺序不同</translation>
    </message>
    <message>
        <source>Commands to a position reach another slave than the one described</source>
        <translation>按位置寻址的命令会到达并非所描述的从站</translation>
    </message>
    <message>
        <source>Compare the wiring with the configuration.</source>
        <translation>将接线与配置进行比较。</translation>
    </message>
    <message>
        <source>Complete access starts at sub-index 0 or 1; slaves abort it</source>
        <translation>完全访问 (Complete Access) 从子索引 0 或 1 开始，否则从站会中止</translation>
    </message>
    <message>
        <source>Complete access to a sub-index other than 0 or 1</source>
        <translation>对 0 或 1 以外的子索引使用完全访问 (Complete Access)</translation>
    </message>
    <message>
        <source>Copy the file that ends in -wal together with the recording.</source>
        <translation>请将以 -wal 结尾的文件与记录一同复制。</translation>
    </message>
    <message>
        <source>Correct Adp, or remove the command</source>
        <translation>更正 Adp，或删除该命令</translation>
    </message>
    <message>
        <source>Correct BitOffs or BitSize, or ByteSize of the image</source>
        <translation>更正 BitOffs 或 BitSize，或更正过程映像的 ByteSize</translation>
    </message>
    <message>
        <source>Correct BitOffs or BitSize, unless one is a part of the other</source>
        <translation>更正 BitOffs 或 BitSize，除非其中一个是另一个的一部分</translation>
    </message>
    <message>
        <source>Correct BitSize or DataType</source>
        <translation>更正 BitSize 或 DataType</translation>
    </message>
    <message>
        <source>Correct BitStart or BitLength, or ByteSize of the image</source>
        <translation>更正 BitStart 或 BitLength，或更正过程映像的 ByteSize</translation>
    </message>
    <message>
        <source>Correct BitStart, or the offsets of the command</source>
        <translation>更正 BitStart，或更正命令的偏移</translation>
    </message>
    <message>
        <source>Correct Cmd and Ado, or remove Validate</source>
        <translation>更正 Cmd 和 Ado，或删除 Validate</translation>
    </message>
    <message>
        <source>Correct CycleTime</source>
        <translation>更正 CycleTime</translation>
    </message>
    <message>
        <source>Correct InputOffs or OutputOffs, or ByteSize of the image</source>
        <translation>更正 InputOffs 或 OutputOffs，或更正过程映像的 ByteSize</translation>
    </message>
    <message>
        <source>Correct Port or PhysAddr of one PreviousPort</source>
        <translation>更正其中一个 PreviousPort 的 Port 或 PhysAddr</translation>
    </message>
    <message>
        <source>Correct Validate, or VendorId, ProductCode, RevisionNo and SerialNo of Info</source>
        <translation>更正 Validate，或更正 Info 中的 VendorId、ProductCode、RevisionNo 和 SerialNo</translation>
    </message>
    <message>
        <source>Correct length, start bit, stop bit, type and activation in the 16 bytes</source>
        <translation>更正这 16 个字节中的长度、起始位、结束位、类型和激活</translation>
    </message>
    <message>
        <source>Correct start and length; data memory begins at 0x1000, digital outputs at 0x0F00</source>
        <translation>更正起始地址和长度；数据存储区从 0x1000 开始，数字输出位于 0x0F00</translation>
    </message>
    <message>
        <source>Correct start or length of one</source>
        <translation>更正其中一个的起始地址或长度</translation>
    </message>
    <message>
        <source>Correct the PhysAddr of PreviousPort, or the order of the slaves</source>
        <translation>更正 PreviousPort 的 PhysAddr，或更正从站的顺序</translation>
    </message>
    <message>
        <source>Correct the data of Validate</source>
        <translation>更正 Validate 的数据</translation>
    </message>
    <message>
        <source>Correct the data of the AL control write</source>
        <translation>更正写 AL 控制的数据</translation>
    </message>
    <message>
        <source>Correct the data of the command, or Start and Length</source>
        <translation>更正命令的数据，或更正 Start 和 Length</translation>
    </message>
    <message>
        <source>Correct the data of the command, or StartAddress</source>
        <translation>更正命令的数据，或更正 StartAddress</translation>
    </message>
    <message>
        <source>Correct the data of the write to 0x0010</source>
        <translation>更正写 0x0010 的数据</translation>
    </message>
    <message>
        <source>Correct the offsets of CopyInfo</source>
        <translation>更正 CopyInfo 的偏移</translation>
    </message>
    <message>
        <source>Cycle time</source>
        <translation>周期时间</translation>
    </message>
    <message>
        <source>CycleTime is in microseconds; masters run some 31 us to 10 s</source>
        <translation>CycleTime 的单位为微秒；主站可运行的周期约为 31 µs 到 10 s</translation>
    </message>
    <message>
        <source>CycleTime is {cycle}</source>
        <translation>CycleTime 为 {cycle}</translation>
    </message>
    <message>
        <source>CycleTime0 is {cycle}, and no command on PS switches SYNC0 on</source>
        <translation>CycleTime0 为 {cycle}，但 PS 上没有命令启用 SYNC0</translation>
    </message>
    <message>
        <source>CycleTime1 is {time}, and {activation} does not switch SYNC1 on</source>
        <translation>CycleTime1 为 {time}，但 {activation} 没有启用 SYNC1</translation>
    </message>
    <message>
        <source>Cycles come late when the host has other work.</source>
        <translation>主机有其他工作时，周期会延迟。</translation>
    </message>
    <message>
        <source>Cyclic synchronous position mode is executed with SYNC0 only</source>
        <translation>周期同步位置模式只有在使用 SYNC0 时才执行</translation>
    </message>
    <message>
        <source>Cyclic synchronous position mode needs SYNC0: without it targets come at no fixed distance from the servo period</source>
        <translation>周期同步位置模式需要 SYNC0：没有它，目标值与伺服周期之间没有固定的时间间隔</translation>
    </message>
    <message>
        <source>Cyclic synchronous position mode without SYNC0 gets its targets at no fixed distance from the servo period, and moves badly</source>
        <translation>没有 SYNC0 时，周期同步位置模式的目标值与伺服周期之间没有固定的时间间隔，运动质量差</translation>
    </message>
    <message>
        <source>Cyclic synchronous torque mode is executed with SYNC0 only</source>
        <translation>周期同步转矩模式只有在使用 SYNC0 时才执行</translation>
    </message>
    <message>
        <source>Cyclic synchronous torque mode needs SYNC0: without it targets come at no fixed distance from the servo period</source>
        <translation>周期同步转矩模式需要 SYNC0：没有它，目标值与伺服周期之间没有固定的时间间隔</translation>
    </message>
    <message>
        <source>Cyclic synchronous torque mode without SYNC0 gets its targets at no fixed distance from the servo period, and moves badly</source>
        <translation>没有 SYNC0 时，周期同步转矩模式的目标值与伺服周期之间没有固定的时间间隔，运动质量差</translation>
    </message>
    <message>
        <source>Cyclic synchronous velocity mode is executed with SYNC0 only</source>
        <translation>周期同步速度模式只有在使用 SYNC0 时才执行</translation>
    </message>
    <message>
        <source>Cyclic synchronous velocity mode needs SYNC0: without it targets come at no fixed distance from the servo period</source>
        <translation>周期同步速度模式需要 SYNC0：没有它，目标值与伺服周期之间没有固定的时间间隔</translation>
    </message>
    <message>
        <source>Cyclic synchronous velocity mode without SYNC0 gets its targets at no fixed distance from the servo period, and moves badly</source>
        <translation>没有 SYNC0 时，周期同步速度模式的目标值与伺服周期之间没有固定的时间间隔，运动质量差</translation>
    </message>
    <message>
        <source>Cyclic tasks</source>
        <translation>循环任务</translation>
    </message>
    <message>
        <source>DC sync IO error</source>
        <translation>DC 同步 IO 错误</translation>
    </message>
    <message>
        <source>DC sync timeout</source>
        <translation>DC 同步超时</translation>
    </message>
    <message>
        <source>DCM error {code} {name}: {text} The drift is {drift} ppm</source>
        <translation>DCM 错误 {code} {name}：{text} 漂移为 {drift} ppm</translation>
    </message>
    <message>
        <source>Data are malformed</source>
        <translation>数据格式错误</translation>
    </message>
    <message>
        <source>Data link layer of the mailbox</source>
        <translation>邮箱的数据链路层</translation>
    </message>
    <message>
        <source>Data types of many variables</source>
        <translation>许多变量的数据类型</translation>
    </message>
    <message>
        <source>Delete it or choose another one.</source>
        <translation>删除它或选择另一个。</translation>
    </message>
    <message>
        <source>Describe the PDO, or take it out of the SyncManager's list</source>
        <translation>描述该 PDO，或将它从同步管理器的列表中移除</translation>
    </message>
    <message>
        <source>Destination address</source>
        <translation>目标地址</translation>
    </message>
    <message>
        <source>Device</source>
        <translation>设备</translation>
    </message>
    <message>
        <source>Distributed clocks</source>
        <translation>分布式时钟</translation>
    </message>
    <message>
        <source>Distributed clocks are initialised</source>
        <translation>分布式时钟已初始化</translation>
    </message>
    <message>
        <source>Distributed clocks are off for the whole bus</source>
        <translation>整个总线的分布式时钟已关闭</translation>
    </message>
    <message>
        <source>Distributed clocks are off for the whole bus; the slaves' operation modes do not count.</source>
        <translation>整个总线的分布式时钟已关闭，从站的操作模式不起作用。</translation>
    </message>
    <message>
        <source>Distributed clocks could not be set up</source>
        <translation>分布式时钟无法设置</translation>
    </message>
    <message>
        <source>Distributed clocks of {subject} could not be set up{because}.</source>
        <translation>{subject} 的分布式时钟无法设置{because}。</translation>
    </message>
    <message>
        <source>EC-Master and others find variables by name: they find the first</source>
        <translation>EC-Master 等主站按名称查找变量：它们会找到第一个</translation>
    </message>
    <message>
        <source>EC-Master used to refuse such files, and cannot measure delays again while it runs</source>
        <translation>EC-Master 曾拒绝此类文件，并且在运行期间无法重新测量延迟</translation>
    </message>
    <message>
        <source>EEPROM error</source>
        <translation>EEPROM 错误</translation>
    </message>
    <message>
        <source>EEPROM no access</source>
        <translation>无法访问 EEPROM</translation>
    </message>
    <message>
        <source>ETG.2100 demands it; strict readers refuse the file, others take a default that need not fit</source>
        <translation>ETG.2100 要求该项；严格的读取软件会拒绝文件，其他的会取不一定合适的默认值</translation>
    </message>
    <message>
        <source>Each clock runs at its own speed: SYNC signals drift apart by some 10 us a second</source>
        <translation>每个时钟按各自的速度运行：SYNC 信号每秒相互漂移约 10 µs</translation>
    </message>
    <message>
        <source>Elements stand in another order than ETG.2100's</source>
        <translation>元素顺序与 ETG.2100 不同</translation>
    </message>
    <message>
        <source>Elements that exclude each other</source>
        <translation>相互排斥的元素</translation>
    </message>
    <message>
        <source>Enable of SM{manager} is off, and an init command switches it on</source>
        <translation>SM{manager} 的 Enable 为关闭，但初始化命令打开了它</translation>
    </message>
    <message>
        <source>Enable the SyncManager, or correct the physical address</source>
        <translation>启用该同步管理器，或更正物理地址</translation>
    </message>
    <message>
        <source>EoE switch</source>
        <translation>EoE 交换机</translation>
    </message>
    <message>
        <source>EoE switched off</source>
        <translation>EoE 已关闭</translation>
    </message>
    <message>
        <source>EtherType</source>
        <translation>EtherType</translation>
    </message>
    <message>
        <source>Ethernet over EtherCAT</source>
        <translation>Ethernet over EtherCAT</translation>
    </message>
    <message>
        <source>Events were lost, their queue was full</source>
        <translation>事件丢失，其队列已满</translation>
    </message>
    <message>
        <source>Every later command to PhysAddr reaches nobody</source>
        <translation>之后所有发往 PhysAddr 的命令都无从站响应</translation>
    </message>
    <message>
        <source>Every tool known writes ARMW; readers that look for it alone see no distributed clocks</source>
        <translation>所有已知工具都写 ARMW；只查找 ARMW 的读取软件会认为没有分布式时钟</translation>
    </message>
    <message>
        <source>Every type is a sequence: readers that follow the schema refuse the file or skip what comes too late</source>
        <translation>每个类型都是有序序列：遵循模式 (schema) 的读取软件会拒绝文件，或跳过出现过晚的内容</translation>
    </message>
    <message>
        <source>Export the file again with init commands</source>
        <translation>重新导出带初始化命令的文件</translation>
    </message>
    <message>
        <source>Export the file without signature</source>
        <translation>导出不带签名的文件</translation>
    </message>
    <message>
        <source>FMMU {fmmu}: bits are set that have to be 0</source>
        <translation>FMMU {fmmu}：必须为 0 的位被置位</translation>
    </message>
    <message>
        <source>FMMU {fmmu}: it gives bits that FMMU {number} of {other} gives, too</source>
        <translation>FMMU {fmmu}：它提供的位也由{other} 的 FMMU {number} 提供</translation>
    </message>
    <message>
        <source>FMMU {fmmu}: it maps {bytes:# byte|# bytes} at {logical} and is not active</source>
        <translation>FMMU {fmmu}：它在 {logical} 映射 {bytes} 字节，但未激活</translation>
    </message>
    <message>
        <source>FMMU {fmmu}: it maps {first} to {last}, SM{manager} is {begin} to {end}</source>
        <translation>FMMU {fmmu}：它映射 {first} 到 {last}，而 SM{manager} 为 {begin} 到 {end}</translation>
    </message>
    <message>
        <source>FMMU {fmmu}: it takes bits that FMMU {number} of {other} takes, too</source>
        <translation>FMMU {fmmu}：它取用的位也由{other} 的 FMMU {number} 取用</translation>
    </message>
    <message>
        <source>FMMU {fmmu}: it {does} SM{manager}, which is {kind}</source>
        <translation>FMMU {fmmu}：它{does} SM{manager}，而后者是{kind}</translation>
    </message>
    <message>
        <source>FMMU {fmmu}: memory {first} to {last} belongs to no SyncManager that is on</source>
        <translation>FMMU {fmmu}：存储区 {first} 到 {last} 不属于任何已打开的同步管理器</translation>
    </message>
    <message>
        <source>FMMU {fmmu}: no cyclic command reads {first} to {last} in OP</source>
        <translation>FMMU {fmmu}：在 OP 中没有循环命令读取 {first} 到 {last}</translation>
    </message>
    <message>
        <source>FMMU {fmmu}: no cyclic command reads {first} to {last} in SAFEOP</source>
        <translation>FMMU {fmmu}：在 SAFEOP 中没有循环命令读取 {first} 到 {last}</translation>
    </message>
    <message>
        <source>FMMU {fmmu}: no cyclic command writes {first} to {last} in OP</source>
        <translation>FMMU {fmmu}：在 OP 中没有循环命令写入 {first} 到 {last}</translation>
    </message>
    <message>
        <source>FMMU {fmmu}: {bytes:# byte|# bytes} from bit {first_bit} to bit {last_bit} at {logical}, {activity}</source>
        <translation>FMMU {fmmu}：位于 {logical} 的 {bytes} 字节，从第 {first_bit} 位到第 {last_bit} 位，{activity}</translation>
    </message>
    <message>
        <source>FMMUs (0x0600)</source>
        <translation>FMMU (0x0600)</translation>
    </message>
    <message>
        <source>Find out what held the host.</source>
        <translation>查明是什么阻塞了主机。</translation>
    </message>
    <message>
        <source>Find out what held the host; its SYNC0 is not the reason.</source>
        <translation>查明是什么阻塞了主机；原因不在其 SYNC0。</translation>
    </message>
    <message>
        <source>Find out where the frames are lost; its SYNC0 is not the reason.</source>
        <translation>查明帧在何处丢失；原因不在其 SYNC0。</translation>
    </message>
    <message>
        <source>Frames and SYNC0 wander through each other: now and then a set value is missed or used twice</source>
        <translation>帧与 SYNC0 相互滑过：给定值不时会丢失或被使用两次</translation>
    </message>
    <message>
        <source>Frames are damaged on a cable</source>
        <translation>帧在某根电缆上损坏</translation>
    </message>
    <message>
        <source>Frames are lost behind a slave</source>
        <translation>帧在某从站之后丢失</translation>
    </message>
    <message>
        <source>Frames are lost by noise</source>
        <translation>帧因干扰丢失</translation>
    </message>
    <message>
        <source>Frames are lost by the host</source>
        <translation>帧因主机丢失</translation>
    </message>
    <message>
        <source>Frames came back after their deadline</source>
        <translation>帧在截止时间之后返回</translation>
    </message>
    <message>
        <source>Frames come back after their cycle</source>
        <translation>帧在其周期结束后才返回</translation>
    </message>
    <message>
        <source>Frames come close to SYNC0</source>
        <translation>帧到达时间离 SYNC0 过近</translation>
    </message>
    <message>
        <source>Frames did not come back</source>
        <translation>帧未返回</translation>
    </message>
    <message>
        <source>Frames do not come back</source>
        <translation>帧没有返回</translation>
    </message>
    <message>
        <source>Frames do not pass a port that has a link</source>
        <translation>帧未通过有链路的端口</translation>
    </message>
    <message>
        <source>Frames enter a slave by another port than A</source>
        <translation>帧从端口 A 以外的端口进入从站</translation>
    </message>
    <message>
        <source>Frames enter it by another port than A. Swap its cables IN and OUT: until then slaves behind it stand in front of it, an ENI file cannot tell what hangs on its port A, and other masters take its propagation delay wrong.</source>
        <translation>帧从端口 A 以外的端口进入该从站。请对调其 IN 和 OUT 电缆：在此之前，其后的从站会排在它之前，ENI 文件无法说明其端口 A 上接的是什么，其他主站也会算错它的传输延迟。</translation>
    </message>
    <message>
        <source>Frames enter {slave} by port {port} instead of port A.</source>
        <translation>帧从端口 {port} 而非端口 A 进入{slave}。</translation>
    </message>
    <message>
        <source>Frames meet those of the next cycle, requests to slaves find no room, and slaves do not reach OP or fall from it</source>
        <translation>帧与下一周期的帧相遇，给从站的请求没有余地，从站无法到达 OP 或从 OP 掉落</translation>
    </message>
    <message>
        <source>Frames pass the slaves in the order of the file: so it can be only where frames enter that one by another port than A</source>
        <translation>帧按文件中的顺序经过从站：因此只有当帧从端口 A 以外的端口进入那个从站时才可能如此</translation>
    </message>
    <message>
        <source>Frames pass the slaves in the order of the file: the wiring told cannot exist</source>
        <translation>帧按文件中的顺序经过从站：所声明的接线不可能存在</translation>
    </message>
    <message>
        <source>Frames were captured in part</source>
        <translation>只抓取了部分帧</translation>
    </message>
    <message>
        <source>Frames were captured in part only</source>
        <translation>有帧只被部分抓取</translation>
    </message>
    <message>
        <source>Frames were damaged or links lost at a port</source>
        <translation>端口上有帧损坏或链路丢失</translation>
    </message>
    <message>
        <source>Frames were lost by an interruption</source>
        <translation>帧因中断而丢失</translation>
    </message>
    <message>
        <source>Give Adp the slave's PhysAddr (FPxx) or AutoIncAddr (APxx)</source>
        <translation>将 Adp 设为该从站的 PhysAddr (FPxx) 或 AutoIncAddr (APxx)</translation>
    </message>
    <message>
        <source>Give PreviousPort the PhysAddr of the slave in front</source>
        <translation>将 PreviousPort 设为前一个从站的 PhysAddr</translation>
    </message>
    <message>
        <source>Give Validate a Timeout in ms</source>
        <translation>为 Validate 设置以 ms 为单位的 Timeout</translation>
    </message>
    <message>
        <source>Give each command bytes of its own</source>
        <translation>为每个命令分配各自的字节</translation>
    </message>
    <message>
        <source>Give each head an alias of its own, in the file and in the device</source>
        <translation>在文件和设备中为每个组首站设置各自的别名</translation>
    </message>
    <message>
        <source>Give each mailbox a StatusBitAddr of its own</source>
        <translation>为每个邮箱设置各自的 StatusBitAddr</translation>
    </message>
    <message>
        <source>Give each slave a PhysAddr of its own</source>
        <translation>为每个从站设置各自的 PhysAddr</translation>
    </message>
    <message>
        <source>Give each slave a name of its own</source>
        <translation>为每个从站设置各自的名称</translation>
    </message>
    <message>
        <source>Give each slave an address of its own.</source>
        <translation>为每个从站设置各自的地址。</translation>
    </message>
    <message>
        <source>Give each slave bits of its own</source>
        <translation>为每个从站分配各自的位</translation>
    </message>
    <message>
        <source>Give each variable a name of its own</source>
        <translation>为每个变量设置各自的名称</translation>
    </message>
    <message>
        <source>Give it Data or DataLength</source>
        <translation>为它设置 Data 或 DataLength</translation>
    </message>
    <message>
        <source>Give it a longer cycle, or fewer objects and functions in each.</source>
        <translation>给它更长的周期，或减少每个周期内的对象和功能。</translation>
    </message>
    <message>
        <source>Give it an address from 1 on.</source>
        <translation>为它设置从 1 开始的地址。</translation>
    </message>
    <message>
        <source>Give it an address from 1 on; tools start at 1001</source>
        <translation>为它设置从 1 开始的地址；工具一般从 1001 开始</translation>
    </message>
    <message>
        <source>Give it data, or disable it</source>
        <translation>为它设置数据，或将其禁用</translation>
    </message>
    <message>
        <source>Give it the Adp of the ARMW, or remove it</source>
        <translation>将它的 Adp 设为 ARMW 的 Adp，或将其删除</translation>
    </message>
    <message>
        <source>Give one of them another alias.</source>
        <translation>为其中一个设置另一个别名。</translation>
    </message>
    <message>
        <source>Give the FMMU start and length of the SyncManager</source>
        <translation>将 FMMU 的起始地址和长度设为同步管理器的值</translation>
    </message>
    <message>
        <source>Give the head an IdentifyCmd with Validate (alias 0x0012 or the device's ID)</source>
        <translation>为组首站设置带 Validate 的 IdentifyCmd（别名 0x0012 或设备标识）</translation>
    </message>
    <message>
        <source>Give the master a processor of its own and real-time priority, or increase the set value.</source>
        <translation>为主站提供独占的处理器和实时优先级，或增大设定值。</translation>
    </message>
    <message>
        <source>Give the master real-time priority above what else runs on this host, or a processor of its own.</source>
        <translation>为主站设置高于此主机上其他程序的实时优先级，或为其提供独占的处理器。</translation>
    </message>
    <message>
        <source>Give the slave a DC element and the write of 0x0980, or neither</source>
        <translation>为该从站同时设置 DC 元素和对 0x0980 的写入，或两者都不设置</translation>
    </message>
    <message>
        <source>Give them logical addresses that do not meet, or states that exclude each other</source>
        <translation>为它们设置互不重叠的逻辑地址，或互斥的状态</translation>
    </message>
    <message>
        <source>Grant it once with: {detail}</source>
        <translation>授予一次权限即可：{detail}</translation>
    </message>
    <message>
        <source>Hangs on</source>
        <translation>连接于</translation>
    </message>
    <message>
        <source>Host and reference clock drift apart by more than 600 ppm; look at the host's timer or choose another reference clock.</source>
        <translation>主机与参考时钟之间的漂移超过 600 ppm；检查主机的定时器，或选择其他参考时钟。</translation>
    </message>
    <message>
        <source>Hot-connect group</source>
        <translation>热连接组</translation>
    </message>
    <message>
        <source>How the mailbox is polled is not said</source>
        <translation>未说明如何轮询邮箱</translation>
    </message>
    <message>
        <source>INIT, PREOP, SAFEOP or OP</source>
        <translation>INIT、PREOP、SAFEOP 或 OP</translation>
    </message>
    <message>
        <source>Identification</source>
        <translation>识别标识</translation>
    </message>
    <message>
        <source>Identification of the hot-connect group</source>
        <translation>热连接组的识别标识</translation>
    </message>
    <message>
        <source>Image offsets in the way of TwinCAT</source>
        <translation>按 TwinCAT 方式书写的过程映像偏移</translation>
    </message>
    <message>
        <source>Import the whole file.</source>
        <translation>请导入完整的文件。</translation>
    </message>
    <message>
        <source>Import with the ESI of the device's revision.</source>
        <translation>用与设备版本对应的 ESI 导入。</translation>
    </message>
    <message>
        <source>In INIT and BOOT there is no CoE: the command fails and the transition with it</source>
        <translation>在 INIT 和 BOOT 中没有 CoE：命令会失败，状态切换也随之失败</translation>
    </message>
    <message>
        <source>In SAFEOP inputs are valid already; the application sees zeros until OP</source>
        <translation>在 SAFEOP 中输入已经有效；但应用程序在到达 OP 之前只能看到 0</translation>
    </message>
    <message>
        <source>Increase the set value by {more} or more, or make the host less late.</source>
        <translation>将设定值增大 {more} 或更多，或减小主机的延迟。</translation>
    </message>
    <message>
        <source>Increase the set value by {more} or more.</source>
        <translation>将设定值增大 {more} 或更多。</translation>
    </message>
    <message>
        <source>Init command</source>
        <translation>初始化命令</translation>
    </message>
    <message>
        <source>Init commands</source>
        <translation>初始化命令</translation>
    </message>
    <message>
        <source>InputOffs and OutputOffs count datagram headers, the data stand {bytes:# byte|# bytes} behind</source>
        <translation>InputOffs 和 OutputOffs 计入了数据报头，数据位于其后 {bytes} 字节处</translation>
    </message>
    <message>
        <source>InputOffs counts datagram headers, the data stand 10 bytes behind; EC-Engineer writes the offsets of the data</source>
        <translation>InputOffs 计入了数据报头，数据位于其后 10 字节处；EC-Engineer 写入的是数据本身的偏移</translation>
    </message>
    <message>
        <source>Inputs</source>
        <translation>输入</translation>
    </message>
    <message>
        <source>Inputs are latched too late</source>
        <translation>输入锁存过晚</translation>
    </message>
    <message>
        <source>Inputs are not read in SAFEOP</source>
        <translation>在 SAFEOP 中没有读取输入</translation>
    </message>
    <message>
        <source>Inputs overwrite each other, or both slaves get the same outputs</source>
        <translation>输入相互覆盖，或两个从站得到相同的输出</translation>
    </message>
    <message>
        <source>Integers are signed decimals (xs:int), booleans 0, 1, true or false: strict readers refuse 0x..., #x..., numbers above 2147483647 and blanks between bytes</source>
        <translation>整数为带符号十进制数 (xs:int)，布尔值为 0、1、true 或 false：严格的读取软件会拒绝 0x...、#x...、大于 2147483647 的数以及字节之间的空格</translation>
    </message>
    <message>
        <source>Interpolated position mode 1 needs SYNC0; only its mode 2 works without</source>
        <translation>插补位置模式 1 需要 SYNC0；只有模式 2 不需要</translation>
    </message>
    <message>
        <source>It cannot be sent</source>
        <translation>它无法发送</translation>
    </message>
    <message>
        <source>It cannot be set: {reason}.</source>
        <translation>无法设置：{reason}。</translation>
    </message>
    <message>
        <source>It fails or changes nothing, and the transition ends there</source>
        <translation>命令失败或不起作用，转换到此结束</translation>
    </message>
    <message>
        <source>It fails unless the first answer fits; other masters take 0 for a default of their own</source>
        <translation>除非第一次响应就符合，否则命令失败；其他主站把 0 当作各自的默认值</translation>
    </message>
    <message>
        <source>It had no outputs for longer than its watchdog time.</source>
        <translation>其输出中断的时间超过了看门狗时间。</translation>
    </message>
    <message>
        <source>It has no effect</source>
        <translation>它不起作用</translation>
    </message>
    <message>
        <source>It is another kind of file</source>
        <translation>这是另一种文件</translation>
    </message>
    <message>
        <source>It is not known whether slaves are in sync</source>
        <translation>不知道从站是否已同步</translation>
    </message>
    <message>
        <source>It is open which of the two mappings counts</source>
        <translation>不确定两个映射中哪一个有效</translation>
    </message>
    <message>
        <source>It maps nothing, and the slave's data never move</source>
        <translation>它没有映射任何内容，从站的数据永远不更新</translation>
    </message>
    <message>
        <source>It protects registers or nothing, and the slave refuses it</source>
        <translation>它保护的是寄存器或什么也不保护，从站会拒绝</translation>
    </message>
    <message>
        <source>It starts its CAN cycles with other frames than meant</source>
        <translation>它用并非预期的帧来启动 CAN 周期</translation>
    </message>
    <message>
        <source>It writes {object}, and a setting writes another value there ({command}).</source>
        <translation>它写入 {object}，而某项设置也在那里写入另一个值 ({command})。</translation>
    </message>
    <message>
        <source>Its bytes are not those that were written: a disk, a copy or another program has changed them. What is left out was recorded, and nothing is known of it any more.</source>
        <translation>其字节与写入时不同：磁盘、复制过程或其他程序改变了它们。略去的内容曾被记录，但现在已无从得知。</translation>
    </message>
    <message>
        <source>Its clock stepped or lost its reference; switch sync-window monitoring on to be told at once.</source>
        <translation>其时钟发生跳变或丢失了参考；打开同步窗口监视可立即得到通知。</translation>
    </message>
    <message>
        <source>Its data come every {cycle}, {least} is the shortest cycle that its object 0x1C32:05 names.</source>
        <translation>其数据每 {cycle} 更新一次，而其对象 0x1C32:05 给出的最短周期为 {least}。</translation>
    </message>
    <message>
        <source>Its description is what its EEPROM says.</source>
        <translation>它按其 EEPROM 的内容描述。</translation>
    </message>
    <message>
        <source>Its firmware is busy or stopped; the counters that it keeps in objects are as old as that.</source>
        <translation>其固件忙或已停止；它保存在对象中的计数器也同样陈旧。</translation>
    </message>
    <message>
        <source>Its firmware takes longer than the cycle: look for what else it has to do, give it a longer cycle, or fewer objects.</source>
        <translation>其固件所需时间超过周期：检查它还要处理什么，给它更长的周期，或减少对象。</translation>
    </message>
    <message>
        <source>Its outputs and inputs are older than the cycle.</source>
        <translation>其输出和输入比该周期更旧。</translation>
    </message>
    <message>
        <source>Its outputs and inputs stood still meanwhile. Look for what stops it: an interrupt storm, a debugger, a crash.</source>
        <translation>在此期间其输出和输入都停止更新。查找使它停止的原因：中断风暴、调试器、程序崩溃。</translation>
    </message>
    <message>
        <source>Its outputs come nominally {margin} before SYNC0, and it needs {need} for them; look at its firmware's load, or at frames that are damaged in front of it.</source>
        <translation>其输出标称在 SYNC0 之前 {margin} 到达，而它需要 {need}；检查其固件负载，或在它之前损坏的帧。</translation>
    </message>
    <message>
        <source>Its propagation delay is measured wrong by many masters.</source>
        <translation>许多主站会错误地测量其传输延迟。</translation>
    </message>
    <message>
        <source>Its serial number is to be compared at start-up, but the project has none (0 stands for any): nothing is compared.</source>
        <translation>启动时要比较其序列号，但项目中没有（0 表示任意）：不进行任何比较。</translation>
    </message>
    <message>
        <source>Its start time (0x0990) had passed when it was taken, or its SYNC unit was not switched on (0x0981). Let the start times begin later (master.dc.start_time_safety_us), or look at who else writes its registers.</source>
        <translation>其启动时间（0x0990）在生效时已经过去，或其 SYNC 单元未启用（0x0981）。请让启动时间更晚开始（master.dc.start_time_safety_us），或检查是否还有其他程序写其寄存器。</translation>
    </message>
    <message>
        <source>Its start time (0x0990) was not taken as it was written. Start it anew; if it stays, look at the slave's firmware, or at who else writes its registers.</source>
        <translation>其启动时间（0x0990）未按写入值生效。请重新启动该从站；若仍如此，请检查从站固件，或是否还有其他程序写其寄存器。</translation>
    </message>
    <message>
        <source>Its working counter stays 0 in each cycle</source>
        <translation>其工作计数器在每个周期都保持为 0</translation>
    </message>
    <message>
        <source>Keep one of the two</source>
        <translation>两者只保留一个</translation>
    </message>
    <message>
        <source>Keep the ESI's mapping.</source>
        <translation>保留 ESI 的映射。</translation>
    </message>
    <message>
        <source>Keep the default assignment.</source>
        <translation>保留默认分配。</translation>
    </message>
    <message>
        <source>Latch them earlier: a smaller input shift time.</source>
        <translation>更早锁存输入：减小输入偏移时间。</translation>
    </message>
    <message>
        <source>Leave ReferenceClock on at the slave that the ARMW addresses</source>
        <translation>仅在 ARMW 寻址的从站上保留 ReferenceClock</translation>
    </message>
    <message>
        <source>Lengthen the cycle, exchange less, or let slow slaves run in a task of their own</source>
        <translation>延长周期、减少交换的数据，或让慢速从站在独立任务中运行</translation>
    </message>
    <message>
        <source>Lengthen the cycle, or exchange less</source>
        <translation>延长周期，或减少交换的数据</translation>
    </message>
    <message>
        <source>Let 0x09A0 have CycleTime0 and CycleTime1</source>
        <translation>使 0x09A0 与 CycleTime0 和 CycleTime1 一致</translation>
    </message>
    <message>
        <source>Let Adp of the ARMW and ReferenceClock name the same slave</source>
        <translation>使 ARMW 的 Adp 与 ReferenceClock 指向同一个从站</translation>
    </message>
    <message>
        <source>Let Enable and the command say the same</source>
        <translation>使 Enable 与命令一致</translation>
    </message>
    <message>
        <source>Let SYNC1 come at SYNC0 or after it.</source>
        <translation>让 SYNC1 与 SYNC0 同时或在其之后到来。</translation>
    </message>
    <message>
        <source>Let a command cover the FMMU's logical addresses, or correct the FMMU</source>
        <translation>让某个命令覆盖该 FMMU 的逻辑地址，或更正 FMMU</translation>
    </message>
    <message>
        <source>Let a read of 0x0508 follow each request to 0x0502 (0x0100 and the address of the word)</source>
        <translation>每次向 0x0502 发出请求（0x0100 和字地址）之后都读取 0x0508</translation>
    </message>
    <message>
        <source>Let a slave that is always there come first.</source>
        <translation>将始终存在的从站放在第一位。</translation>
    </message>
    <message>
        <source>Let its SYNC0 come {more} later: a shift of {shift}.</source>
        <translation>让其 SYNC0 推迟 {more} 到来：偏移设为 {shift}。</translation>
    </message>
    <message>
        <source>Let the application copy the data.</source>
        <translation>让应用程序复制数据。</translation>
    </message>
    <message>
        <source>Let the attribute Sm name the SyncManager whose list has the PDO, or leave it out</source>
        <translation>使属性 Sm 指向列表中含有该 PDO 的同步管理器，或省略该属性</translation>
    </message>
    <message>
        <source>Let the command have PREOP, SAFEOP and OP</source>
        <translation>为该命令设置 PREOP、SAFEOP 和 OP</translation>
    </message>
    <message>
        <source>Let the data of 0x0990 be ShiftTime</source>
        <translation>使写 0x0990 的数据等于 ShiftTime</translation>
    </message>
    <message>
        <source>Line {line} is not read: a Slave without address, commands and data, as tools write end caps.</source>
        <translation>第 {line} 行未被读取：没有地址、命令和数据的 Slave，即工具为末端盖板写入的条目。</translation>
    </message>
    <message>
        <source>Line {line} is not read: {what}.</source>
        <translation>第 {line} 行未被读取：{what}。</translation>
    </message>
    <message>
        <source>Line {line}, the last one, has no end: its last cell may be cut off.</source>
        <translation>最后一行（第 {line} 行）没有行尾：其最后一个单元格可能被截断。</translation>
    </message>
    <message>
        <source>Line {line}, the last one, is cut off and left out.</source>
        <translation>最后一行（第 {line} 行）被截断，已略去。</translation>
    </message>
    <message>
        <source>List them with "synclinectl adapters".</source>
        <translation>用“synclinectl adapters”列出它们。</translation>
    </message>
    <message>
        <source>Load its ESI file.</source>
        <translation>加载其 ESI 文件。</translation>
    </message>
    <message>
        <source>Logical address of the mailbox state bits</source>
        <translation>邮箱状态位的逻辑地址</translation>
    </message>
    <message>
        <source>Look at the cables and plugs behind it, and at the way back: the network card and its driver receive there.</source>
        <translation>请检查其后的电缆和插头，以及返回路径：网卡及其驱动在那里接收。</translation>
    </message>
    <message>
        <source>Look at the deviations of the single slaves.</source>
        <translation>查看各个从站的偏差。</translation>
    </message>
    <message>
        <source>Look at the device behind it.</source>
        <translation>检查它后面的设备。</translation>
    </message>
    <message>
        <source>Look for what makes frames late, in the host or behind it: the frame behind a late one comes sooner after it. Its firmware is not the reason.</source>
        <translation>请查找使帧迟到的原因（主机内部或其后）：迟到的帧之后，下一帧来得更快。固件并非原因。</translation>
    </message>
    <message>
        <source>Look for what stops it: an interrupt storm, a debugger, a crash.</source>
        <translation>查找使它停止的原因：中断风暴、调试器、程序崩溃。</translation>
    </message>
    <message>
        <source>Lost on the bus and lost by who captured look alike. A mirror port of a switch passes over frames when both ways together are more than it carries, and gives no two frames their true distance.</source>
        <translation>在总线上丢失与在抓包时丢失看起来一样。当双向流量之和超过交换机镜像端口的容量时，该端口会漏掉帧，且任何两帧之间的间隔都不真实。</translation>
    </message>
    <message>
        <source>Mend the clock; neither the slave's firmware nor its shift is the reason.</source>
        <translation>请修复时钟；原因既不是从站固件，也不是其偏移。</translation>
    </message>
    <message>
        <source>Names of many variables</source>
        <translation>许多变量的名称</translation>
    </message>
    <message>
        <source>Only frames on their way back were captured: round trips and lost frames are not known.</source>
        <translation>只抓到了返回途中的帧：往返时间和丢帧情况未知。</translation>
    </message>
    <message>
        <source>Read it from another copy; what is shown beside it is as it was written.</source>
        <translation>请从另一份副本读取；其余显示的内容与写入时一致。</translation>
    </message>
    <message>
        <source>Replies are missing in an imported capture</source>
        <translation>导入的抓包中缺少应答</translation>
    </message>
    <message>
        <source>Row {row} of the table {table} is damaged and left out</source>
        <translation>表 {table} 的行 {row} 已损坏，已略去</translation>
    </message>
    <message>
        <source>Row {row} of the table {table} is damaged: cycles {first} to {last} are a gap</source>
        <translation>表 {table} 的行 {row} 已损坏：周期 {first} 至 {last} 为空缺</translation>
    </message>
    <message>
        <source>Row {row} of the table {table} is damaged: {signal} is not known in cycles {first} to {last}</source>
        <translation>表 {table} 的行 {row} 已损坏：周期 {first} 至 {last} 中的 {signal} 未知</translation>
    </message>
    <message>
        <source>SM2 events were missed because a clock had moved</source>
        <translation>因时钟偏移而丢失 SM2 事件</translation>
    </message>
    <message>
        <source>SYNC0 of {slave} comes {off} before its place in the cycle: its outputs are there {margin} before it, and it needs {need} for them.</source>
        <translation>{slave} 的 SYNC0 比其在周期中的位置早 {off}：其输出在 SYNC0 之前 {margin} 到达，而它需要 {need} 处理。</translation>
    </message>
    <message>
        <source>SYNC0 of {slave} comes {off} behind its place in the cycle: its outputs are there {margin} before it, and it needs {need} for them.</source>
        <translation>{slave} 的 SYNC0 比其在周期中的位置晚 {off}：其输出在 SYNC0 之前 {margin} 到达，而它需要 {need} 处理。</translation>
    </message>
    <message>
        <source>SYNC0 of {slave} will not come: it has no start time ahead of it.</source>
        <translation>{slave} 的 SYNC0 不会到来：其前方没有启动时间。</translation>
    </message>
    <message>
        <source>See that nobody stops the program: a debugger, SIGSTOP. Else look below the operating system: the host of a virtual machine, firmware (system management interrupts), power states, drivers that hold interrupts off. Run the master on a machine of its own.</source>
        <translation>请确认没有人暂停本程序：调试器、SIGSTOP。否则查找操作系统以下的原因：虚拟机的宿主机、固件（系统管理中断）、电源状态、屏蔽中断的驱动程序。请在独立的机器上运行主站。</translation>
    </message>
    <message>
        <source>Look for a busy host or a clock that stepped; if neither is there, choose the other shift mode.</source>
        <translation>检查主机是否繁忙或时钟是否跳变；如果都没有，请选择另一种偏移模式。</translation>
    </message>
    <message>
        <source>Look for a cable back to the master, or a device that is no slave.</source>
        <translation>查找接回主站的电缆，或不是从站的设备。</translation>
    </message>
    <message>
        <source>Look for what held it: another process of higher priority, power management, the virtual machine's host.</source>
        <translation>查找阻塞它的原因：优先级更高的进程、电源管理、虚拟机的宿主机。</translation>
    </message>
    <message>
        <source>Slaves followed with delays that were not theirs</source>
        <translation>从站曾使用不属于自己的延迟跟随</translation>
    </message>
    <message>
        <source>Slaves were up to {deviation} off the reference clock, {slave}, at {since}, at once and to the same side, and nobody monitors them. It is that clock which moved{led}.</source>
        <translation>从站在 {since} 同时且朝同一方向偏离参考时钟（{slave}）最多 {deviation}，且无人监视。移动的是该时钟{led}。</translation>
    </message>
    <message>
        <source>SyncManager of PDO {pdo}</source>
        <translation>PDO {pdo} 的 SyncManager</translation>
    </message>
    <message>
        <source>The capture breaks off behind {frames:# frame|# frames} ({reason}): what came before is imported.</source>
        <translation>抓包在 {frames:# 个帧|# 个帧} 之后中断（{reason}）：之前的内容已导入。</translation>
    </message>
    <message>
        <source>The file ends in the middle of a line: whoever has written or copied it did not come to its end.</source>
        <translation>文件在一行中间结束：写入或复制它的程序没有完成。</translation>
    </message>
    <message>
        <source>The frames' way to slaves has changed</source>
        <translation>帧到从站的路径已改变</translation>
    </message>
    <message>
        <source>Their own readings (0x092C) do not show it for long. Where delays were not measured anew, a device that nobody knows stands on the bus: set it up or take it away, before positions are compared across it.</source>
        <translation>它们自己的读数（0x092C）很快就不再显示这一点。如果延迟没有重新测量，说明总线上有未知设备：在跨该设备比较位置之前，请对其进行设置或将其移除。</translation>
    </message>
    <message>
        <source>Times are software stamps of the host that captured.</source>
        <translation>时间为抓包主机的软件时间戳。</translation>
    </message>
    <message>
        <source>Times are the hardware stamps of a probe, which the frames carry; dated by the first frame.</source>
        <translation>时间为帧所携带的探针硬件时间戳；日期取自第一帧。</translation>
    </message>
    <message>
        <source>Times of a probe are good to nanoseconds. Those of a host hold its interrupts and its clock, too: what is in the lateness or the round trip of a few microseconds may be its own.</source>
        <translation>探针的时间精确到纳秒。主机的时间还包含其中断和自身时钟的影响：延迟或往返时间中的几微秒可能来自主机自身。</translation>
    </message>
    <message>
        <source>Who stamped the frames of an imported capture</source>
        <translation>导入的抓包中帧的时间戳由谁给出</translation>
    </message>
    <message>
        <source>Write it as SerialNo of the device's Type into the project file, or switch check.serial off.</source>
        <translation>请在项目文件中该设备的 Type 里写入 SerialNo，或关闭 check.serial。</translation>
    </message>
    <message>
        <source>a signal ended the waiting for its content</source>
        <translation>等待其内容时被信号终止</translation>
    </message>
    <message>
        <source>a signal ended the waiting for its reader</source>
        <translation>等待其读取方时被信号终止</translation>
    </message>
    <message>
        <source>is missing, as stamp_error and stalls are: a host profile has times for one of them</source>
        <translation>缺失，stamp_error 和 stalls 也缺失：主机配置至少要有其中一项的时间</translation>
    </message>
    <message>
        <source>it follows this host's clock, which a time service may have moved</source>
        <translation>它跟随本机时钟，时间服务可能调整过该时钟</translation>
    </message>
    <message>
        <source>it was led back to this host's clock after the network adapter had been away</source>
        <translation>网络适配器中断之后，它被拉回到本机时钟</translation>
    </message>
    <message>
        <source>overlaps the {fault} from {time} ms to {other} ms</source>
        <translation>与 {time} ms 至 {other} ms 的 {fault} 重叠</translation>
    </message>
    <message>
        <source>the file {file} cannot be read: {reason}</source>
        <translation>无法读取文件 {file}：{reason}</translation>
    </message>
    <message>
        <source>there is no file {file}</source>
        <translation>没有文件 {file}</translation>
    </message>
    <message>
        <source>what else is told of that moment</source>
        <translation>该时刻还报告了什么</translation>
    </message>
    <message>
        <source>{count:# cyclic frame has|# cyclic frames have} no reply in the capture, of {frames}: lost on the bus, or by who captured.</source>
        <translation>抓包中 {frames} 个周期帧有 {count} 个没有应答：在总线上丢失，或在抓包时丢失。</translation>
    </message>
    <message>
        <source>{count:# frame has|# frames have} hardware stamps of a probe, the others of {frames} are stamped by the host that captured them: times between the two do not compare.</source>
        <translation>{frames} 帧中有 {count} 帧带有探针的硬件时间戳，其余由抓包主机加盖：两者之间的时间不可比较。</translation>
    </message>
    <message>
        <source>{slave} fell to {state} with AL status code {alcode}{alarm} at {since}: its firmware had stood still, its PDI watchdog expired at {stopped} (0x0443), and its SYNC0 went on without it.</source>
        <translation>{slave} 在 {since} 以 AL 状态码 {alcode}{alarm} 掉到 {state}：其固件曾停止运行，PDI 看门狗在 {stopped} 到期 (0x0443)，而其 SYNC0 仍在继续。</translation>
    </message>
    <message>
        <source>{slave} fell to {state} with AL status code {alcode}{alarm} at {since}: its SYNC0 had not come where its outputs are meant for, {why}.</source>
        <translation>{slave} 在 {since} 以 AL 状态码 {alcode}{alarm} 掉到 {state}：其 SYNC0 未在其输出所对应的位置到来，{why}。</translation>
    </message>
    <message>
        <source>{slave} had fallen to {state} with AL status code {alcode}{alarm} at {since} ({count} in all), and was led up again; just before: {why}.</source>
        <translation>{slave} 曾在 {since} 以 AL 状态码 {alcode}{alarm} 掉到 {state}（共 {count}），后被重新引导上来；在此之前不久：{why}。</translation>
    </message>
    <message>
        <source>{slave} went or came at {since}, and those behind it were off by up to {deviation}, until delays (0x0928) were measured anew at {renewed}.</source>
        <translation>{slave} 在 {since} 离开或到来，其后的从站偏差最大 {deviation}，直到 {renewed} 重新测量了延迟（0x0928）。</translation>
    </message>
    <message>
        <source>A recording is cut off</source>
        <translation>录制文件被截断</translation>
    </message>
    <message>
        <source>The file is shorter than it was: a copy, a transfer or a full disk ended within it. What is shown is as it was written; of what is lost nothing is known any more.</source>
        <translation>文件比原来短：复制、传输或磁盘写满时在其中间中断。所显示的与写入时一致；丢失的部分已无从得知。</translation>
    </message>
    <message>
        <source>Copy the whole file once more, from where it was written.</source>
        <translation>请从写入处重新复制整个文件。</translation>
    </message>
    <message>
        <source>An imported capture was taken through a switch</source>
        <translation>导入的抓包经过了交换机</translation>
    </message>
    <message>
        <source>A switch holds frames back, one behind the other, and stamps none: distances, round trips and jitter are its own as well, and what a mirror port cannot carry is missing.</source>
        <translation>交换机会逐个滞留报文，且不打时间戳：间隔、往返时间和抖动中也含有它自身的影响，镜像端口承载不下的报文会缺失。</translation>
    </message>
    <message>
        <source>Capture with a probe in the line, or on the master's own adapter.</source>
        <translation>请用串接在线路中的探头抓包，或在主站自己的网卡上抓包。</translation>
    </message>
    <message>
        <source>{count:# frame is|# frames are} of a switch itself (spanning tree, neighbour discovery).</source>
        <translation>有 {count} 个报文来自交换机自身（生成树、邻居发现）。</translation>
    </message>
    <message>
        <source>{count:# EtherCAT frame has|# EtherCAT frames have} a VLAN tag (802.1Q), which a switch has put on.</source>
        <translation>有 {count} 个 EtherCAT 报文带有交换机加上的 VLAN 标签（802.1Q）。</translation>
    </message>
    <message>
        <source>{count:# EtherCAT frame came|# EtherCAT frames came} twice, byte for byte, as a mirror port sends what enters and leaves.</source>
        <translation>有 {count} 个 EtherCAT 报文逐字节重复出现两次，正如镜像端口同时转发进出报文的情形。</translation>
    </message>
    <message>
        <source>An imported capture was taken in a virtual machine</source>
        <translation>导入的抓包来自虚拟机</translation>
    </message>
    <message>
        <source>A hypervisor passes frames on when it gets to it, and its clock is not the host's: times are off by milliseconds at any moment.</source>
        <translation>虚拟机管理程序在有空时才转发报文，且其时钟不是主机的时钟：时间随时可能偏差数毫秒。</translation>
    </message>
    <message>
        <source>Capture on a machine of its own, whose adapter stands at the bus.</source>
        <translation>请在网卡直接连接总线的独立计算机上抓包。</translation>
    </message>
    <message>
        <source>{count:# EtherCAT frame was|# EtherCAT frames were} sent by {address}, the adapter of a virtual machine.</source>
        <translation>有 {count} 个 EtherCAT 报文由虚拟机网卡 {address} 发出。</translation>
    </message>
    <message>
        <source>The file is cut off: {there} of {all} KiB are there, with {cycles:# cycle|# cycles}; {count:# block|# blocks} of values, about a second each, {count:is|are} lost</source>
        <translation>文件被截断：{all} KiB 中有 {there} KiB，含 {cycles} 个周期；{count} 个数据块（每块约一秒）丢失</translation>
    </message>
    <message>
        <source>SQLite refuses the file: what is shown was found page by page, with {cycles:# cycle|# cycles}; {count:# block|# blocks} of values, about a second each, {count:is|are} lost</source>
        <translation>SQLite 拒绝该文件：所显示的内容是逐页找到的，含 {cycles} 个周期；{count} 个数据块（每块约一秒）丢失</translation>
    </message>
    <message>
        <source>no whole cycle of it is left</source>
        <translation>没有剩下任何完整的周期</translation>
    </message>
    <message>
        <source>The log of a recording is missing</source>
        <translation>记录的日志缺失</translation>
    </message>
    <message>
        <source>The recording is of version {version}, whose rows carry no checks: damage in their values may not be seen.</source>
        <translation>该记录的版本为 {version}，其各行没有校验值：数值中的损坏可能无法发现。</translation>
    </message>
    <message>
        <source>The recording was cut short, and its log {file} is not beside it: what that held, the end of the run, is missing unless another program has taken it over.</source>
        <translation>记录被中断，其日志 {file} 不在旁边：除非已由其他程序并入，否则其中的内容（运行的末尾）缺失。</translation>
    </message>
    <message>
        <source>The rows of a recording carry no checks</source>
        <translation>记录的各行没有校验值</translation>
    </message>
    <message>
        <source>The rows of block {block} contradict each other: cycles {first} to {last} are a gap</source>
        <translation>块 {block} 的各行相互矛盾：周期 {first} 至 {last} 为空缺</translation>
    </message>
    <message>
        <source>Their own readings (0x092C) do not show it. Go online anew without the slave, or bring it back, before positions are compared across it.</source>
        <translation>它们自己的读数（0x092C）不会显示这一点。在跨该从站比较位置之前，请在没有该从站的情况下重新上线，或恢复该从站。</translation>
    </message>
    <message>
        <source>To change nothing on it, only look.</source>
        <translation>若不想更改任何内容，请只查看。</translation>
    </message>
    <message>
        <source>MBoxOut, MBoxIn, Outputs or Inputs</source>
        <translation>MBoxOut、MBoxIn、Outputs 或 Inputs</translation>
    </message>
    <message>
        <source>Mailbox</source>
        <translation>邮箱</translation>
    </message>
    <message>
        <source>Mailbox for answers</source>
        <translation>用于响应的邮箱</translation>
    </message>
    <message>
        <source>Mailbox for requests</source>
        <translation>用于请求的邮箱</translation>
    </message>
    <message>
        <source>Mailbox poll time</source>
        <translation>邮箱轮询时间</translation>
    </message>
    <message>
        <source>Mailbox protocols</source>
        <translation>邮箱协议</translation>
    </message>
    <message>
        <source>Mailbox state bit</source>
        <translation>邮箱状态位</translation>
    </message>
    <message>
        <source>Mailbox state bits</source>
        <translation>邮箱状态位</translation>
    </message>
    <message>
        <source>Mailbox, delays of the slaves and jitter of the master do not fit beside them</source>
        <translation>除此之外已容不下邮箱通信、从站延迟和主站抖动</translation>
    </message>
    <message>
        <source>MailboxStates must count the bit, an FMMU on IP map it and a command read it from PREOP on</source>
        <translation>MailboxStates 必须计入该位，IP 上必须有 FMMU 映射它，并且从 PREOP 起必须有命令读取它</translation>
    </message>
    <message>
        <source>Make the CAN cycle a multiple of the bus cycle</source>
        <translation>将 CAN 周期设为总线周期的整数倍</translation>
    </message>
    <message>
        <source>Make the first slave with distributed clocks the reference clock</source>
        <translation>将第一个带分布式时钟的从站设为参考时钟</translation>
    </message>
    <message>
        <source>Many things in other places</source>
        <translation>许多内容位于其他位置</translation>
    </message>
    <message>
        <source>Map both time stamps, or choose another mode.</source>
        <translation>映射这两个时间戳，或选择其他模式。</translation>
    </message>
    <message>
        <source>Map fewer entries.</source>
        <translation>减少映射的条目。</translation>
    </message>
    <message>
        <source>Map fewer objects and exchange the slow ones by SDO</source>
        <translation>减少映射的对象，慢速对象改用 SDO 交换</translation>
    </message>
    <message>
        <source>Map fewer, or use another PDO for the rest.</source>
        <translation>减少映射，或将其余条目放到另一个 PDO。</translation>
    </message>
    <message>
        <source>Map it again.</source>
        <translation>重新映射它。</translation>
    </message>
    <message>
        <source>Mapping of a PDO</source>
        <translation>PDO 的映射</translation>
    </message>
    <message>
        <source>Master and reference clock run at their own rates</source>
        <translation>主站与参考时钟按各自的速率运行</translation>
    </message>
    <message>
        <source>Master and reference clock run at their own rates: the frame wanders through the cycle and meets SYNC0 now and then.</source>
        <translation>主站与参考时钟按各自的速率运行：帧在周期内漂移，不时与 SYNC0 相遇。</translation>
    </message>
    <message>
        <source>Master and slaves follow different clocks</source>
        <translation>主站与从站跟随不同的时钟</translation>
    </message>
    <message>
        <source>Masters do not use the mailbox at all</source>
        <translation>主站根本不使用邮箱</translation>
    </message>
    <message>
        <source>Masters find the write of bus shift behind the ARMW: before it they steer by the time of the cycle before, or take it for something else</source>
        <translation>主站会在 ARMW 之后查找总线偏移的写命令：若在其之前，主站就按前一周期的时间进行调节，或将它误认为其他命令</translation>
    </message>
    <message>
        <source>Masters of other makers ignore it, so whatever it sets is lost there</source>
        <translation>其他厂商的主站会忽略它，因此它所设置的内容会丢失</translation>
    </message>
    <message>
        <source>Masters run slower tasks in every n-th cycle of the first one</source>
        <translation>主站在第一个任务的每 n 个周期运行一次较慢的任务</translation>
    </message>
    <message>
        <source>Masters skip them, or give up when the slave refuses the protocol</source>
        <translation>主站会跳过它们，或在从站拒绝该协议时放弃</translation>
    </message>
    <message>
        <source>Masters take the shift from the one or from the other</source>
        <translation>主站会采用两个偏移中的其中一个</translation>
    </message>
    <message>
        <source>Masters that go by the element set the slave up in another way than those that go by the commands</source>
        <translation>依据元素的主站与依据命令的主站对从站的设置会不同</translation>
    </message>
    <message>
        <source>Mend the lock first.</source>
        <translation>先解决锁定问题。</translation>
    </message>
    <message>
        <source>Mend the value at the line named, then check again</source>
        <translation>更正所指行中的值，然后重新检查</translation>
    </message>
    <message>
        <source>Mend what is found about that port.</source>
        <translation>按该端口的检查结果进行修复。</translation>
    </message>
    <message>
        <source>Messages do not fit, into the mailbox or into a frame, and every object access fails</source>
        <translation>消息放不进邮箱或帧，所有对象访问都会失败</translation>
    </message>
    <message>
        <source>Module {module} does not fit into place {place}.</source>
        <translation>模块 {module} 不适合插槽 {place}。</translation>
    </message>
    <message>
        <source>Module {module} in place {place} demands the operation mode {mode}.</source>
        <translation>插槽 {place} 中的模块 {module} 要求操作模式 {mode}。</translation>
    </message>
    <message>
        <source>More PDOs are assigned than an object takes</source>
        <translation>分配的 PDO 超过对象可容纳的数量</translation>
    </message>
    <message>
        <source>More entries are mapped than an object takes</source>
        <translation>映射的条目超过对象可容纳的数量</translation>
    </message>
    <message>
        <source>More entries are mapped than the device has room for</source>
        <translation>映射的条目超过设备可容纳的数量</translation>
    </message>
    <message>
        <source>More objects are mapped than the device takes</source>
        <translation>映射的对象超过设备可接受的数量</translation>
    </message>
    <message>
        <source>More than one reference clock</source>
        <translation>存在多个参考时钟</translation>
    </message>
    <message>
        <source>Move commands to another frame; 1498 bytes of datagrams fit into one, 12 of each are its own</source>
        <translation>将命令移到其他帧；一帧可容纳 1498 字节的数据报，每个数据报自身占用其中 12 字节</translation>
    </message>
    <message>
        <source>Move it to IP, PS or SO</source>
        <translation>将它移到 IP、PS 或 SO</translation>
    </message>
    <message>
        <source>Move one of them to logical addresses of its own</source>
        <translation>将其中一个移到单独的逻辑地址</translation>
    </message>
    <message>
        <source>Move one of them to logical addresses of its own, unless both shall do the same</source>
        <translation>将其中一个移到单独的逻辑地址，除非两者本应相同</translation>
    </message>
    <message>
        <source>Move the command before the AL control write</source>
        <translation>将该命令移到写 AL 控制之前</translation>
    </message>
    <message>
        <source>Move the element to its place</source>
        <translation>将元素移到正确的位置</translation>
    </message>
    <message>
        <source>Move the write of 0x0980 before the AL control write</source>
        <translation>将写 0x0980 的命令移到写 AL 控制之前</translation>
    </message>
    <message>
        <source>Name the protocols that the device has</source>
        <translation>写明设备具有的协议</translation>
    </message>
    <message>
        <source>Neither can be known by it.</source>
        <translation>两者都无法据此识别。</translation>
    </message>
    <message>
        <source>No ESI file describes a device</source>
        <translation>没有描述设备的 ESI 文件</translation>
    </message>
    <message>
        <source>No ESI file describes a slave</source>
        <translation>没有描述从站的 ESI 文件</translation>
    </message>
    <message>
        <source>No ESI file describes {slave} ({identity}).</source>
        <translation>没有描述{slave} ({identity}) 的 ESI 文件。</translation>
    </message>
    <message>
        <source>No ESI file describes {subject}.</source>
        <translation>没有描述 {subject} 的 ESI 文件。</translation>
    </message>
    <message>
        <source>No ESI of the device is at hand</source>
        <translation>没有该设备的 ESI</translation>
    </message>
    <message>
        <source>No ESI of {identity} is at hand: the device is described by what the ENI uses of it; other PDOs, operation modes and objects are unknown.</source>
        <translation>没有 {identity} 的 ESI：只按 ENI 用到的内容描述设备；其他 PDO、操作模式和对象均未知。</translation>
    </message>
    <message>
        <source>No SyncManager can carry PDO {pdo}.</source>
        <translation>没有同步管理器可以承载 PDO {pdo}。</translation>
    </message>
    <message>
        <source>No SyncManager can carry a PDO</source>
        <translation>没有同步管理器可以承载 PDO</translation>
    </message>
    <message>
        <source>No answer</source>
        <translation>无响应</translation>
    </message>
    <message>
        <source>No answer from {slaves} from {since} on, for {length} ({count} in all).</source>
        <translation>从 {since} 起，{slaves} 无响应，持续 {length}（共 {count}）。</translation>
    </message>
    <message>
        <source>No answer from {slaves} since {since}: nothing comes back over the cable at {near} port {port}.</source>
        <translation>从 {since} 起，{slaves} 无响应：{near} 端口 {port} 的电缆上没有任何数据返回。</translation>
    </message>
    <message>
        <source>No answer from {slaves} since {since}; {near} is the last that answers.</source>
        <translation>从 {since} 起，{slaves} 无响应；{near} 是最后一个有响应的。</translation>
    </message>
    <message>
        <source>No answer from {subject}.</source>
        <translation>{subject} 无响应。</translation>
    </message>
    <message>
        <source>No command enables a SyncManager that has PDOs</source>
        <translation>没有命令启用带有 PDO 的同步管理器</translation>
    </message>
    <message>
        <source>No command enables a mailbox SyncManager</source>
        <translation>没有命令启用邮箱同步管理器</translation>
    </message>
    <message>
        <source>No command requests a state on the way to OP</source>
        <translation>到达 OP 的途中有状态没有命令请求</translation>
    </message>
    <message>
        <source>No cyclic command carries what an FMMU maps in OP</source>
        <translation>没有循环命令承载 FMMU 在 OP 中映射的内容</translation>
    </message>
    <message>
        <source>No external clock was found; look at the bridge device and at the network on its other side.</source>
        <translation>未找到外部时钟；检查桥接设备及其另一侧的网络。</translation>
    </message>
    <message>
        <source>No master can send them in time</source>
        <translation>没有主站能按时发送它们</translation>
    </message>
    <message>
        <source>No operation mode fits the ENI's clocks</source>
        <translation>没有与 ENI 的时钟设置相符的操作模式</translation>
    </message>
    <message>
        <source>No operation mode of {type} has the AssignActivate {activation} of the ENI: DC is off.</source>
        <translation>{type} 没有操作模式具有 ENI 中的 AssignActivate {activation}：DC 已关闭。</translation>
    </message>
    <message>
        <source>No permission to send raw frames</source>
        <translation>没有发送原始帧的权限</translation>
    </message>
    <message>
        <source>No permission to send raw frames on {subject}.</source>
        <translation>没有在 {subject} 上发送原始帧的权限。</translation>
    </message>
    <message>
        <source>No slave brings the time of an external clock</source>
        <translation>没有从站提供外部时钟的时间</translation>
    </message>
    <message>
        <source>No slave follows the reference clock ({clocks} with a system time behind it), so there is no deviation to watch.</source>
        <translation>没有从站跟随参考时钟（其后有 {clocks} 个具有系统时间），因此没有可监视的偏差。</translation>
    </message>
    <message>
        <source>No start time is written</source>
        <translation>没有写入起始时间</translation>
    </message>
    <message>
        <source>No wiring puts a slave in front of the one that it hangs on here.</source>
        <translation>任何接线都不会使从站位于此处所接从站之前。</translation>
    </message>
    <message>
        <source>Nobody looks whether slaves are in sync</source>
        <translation>没有检查从站是否已同步</translation>
    </message>
    <message>
        <source>Nobody watches the slaves' deviation</source>
        <translation>从站的偏差无人监视</translation>
    </message>
    <message>
        <source>Noise on that cable, a bad plug or a bad shield: change the cable, keep it away from motor cables.</source>
        <translation>该电缆受干扰、插头不良或屏蔽不良：更换电缆，使其远离电机电缆。</translation>
    </message>
    <message>
        <source>Not read from {subject}: {detail}.</source>
        <translation>未从 {subject} 读取：{detail}。</translation>
    </message>
    <message>
        <source>Nothing answers behind an open port</source>
        <translation>打开的端口后面没有响应</translation>
    </message>
    <message>
        <source>Nothing comes back over a cable</source>
        <translation>电缆上没有任何数据返回</translation>
    </message>
    <message>
        <source>Nothing is written, or the slave aborts for a wrong length (0x06070010)</source>
        <translation>什么也没有写入，或从站因长度错误而中止 (0x06070010)</translation>
    </message>
    <message>
        <source>Nothing waits for the state requested</source>
        <translation>没有命令等待所请求的状态</translation>
    </message>
    <message>
        <source>Nothing, unless the application uses them</source>
        <translation>无需处理，除非应用程序使用它们</translation>
    </message>
    <message>
        <source>Nothing, unless the application uses them with another master</source>
        <translation>无需处理，除非应用程序在其他主站上使用它们</translation>
    </message>
    <message>
        <source>Nothing, unless the file has to carry the setting to another maker's master</source>
        <translation>无需处理，除非该文件必须将此设置带给其他厂商的主站</translation>
    </message>
    <message>
        <source>Nothing, unless your master needs it.</source>
        <translation>无需处理，除非主站需要它。</translation>
    </message>
    <message>
        <source>Nothing: readers should go by BitStart and BitOffs</source>
        <translation>无需处理：读取软件应以 BitStart 和 BitOffs 为准</translation>
    </message>
    <message>
        <source>Object 0x60C2 cannot express a cycle of {cycle}; the ESI's value is kept.</source>
        <translation>对象 0x60C2 无法表示 {cycle} 的周期；保留 ESI 的值。</translation>
    </message>
    <message>
        <source>Old station addresses, FMMUs or SyncManagers answer beside the new ones until a slave is switched off</source>
        <translation>从站断电之前，旧的站地址、FMMU 或同步管理器会与新的同时响应</translation>
    </message>
    <message>
        <source>One overwrites the other's data; a buffered SyncManager takes three times its length</source>
        <translation>其中一个会覆盖另一个的数据；缓冲型同步管理器占用三倍长度</translation>
    </message>
    <message>
        <source>Only masters of the maker who signed the file take it</source>
        <translation>只有签名该文件的厂商的主站才接受它</translation>
    </message>
    <message>
        <source>Only one clock can lead; masters take the first or the last</source>
        <translation>只能有一个时钟主导；主站会采用第一个或最后一个</translation>
    </message>
    <message>
        <source>The host&apos;s kernel held the processor</source>
        <translation>主机内核占用了处理器</translation>
    </message>
    <message>
        <source>Real-time priority does not interrupt a thread of the kernel where the kernel is not preemptible.</source>
        <translation>若内核不可抢占，实时优先级也不能打断内核线程。</translation>
    </message>
    <message>
        <source>Boot this kernel with preempt=full, or take one with PREEMPT_RT; or keep a processor for the master alone (isolcpus) and bind it to that.</source>
        <translation>请以 preempt=full 启动此内核，或使用带 PREEMPT_RT 的内核；或为主站单独保留一个处理器（isolcpus）并将主站绑定到它。</translation>
    </message>
    <message>
        <source>The host stood still {times}, first at {since}: it sent nothing for up to {longest}, and {count:# cycle was|# cycles were} left out. Of {held} that the master came too late, it was ready for {waited}. Of the kernel&apos;s threads {thread} kept a processor longest, {slice} at a time.</source>
        <translation>主机停顿了 {times}，首次在 {since}：最长 {longest} 未发送任何帧，漏掉了 {count} 个周期。主站共晚了 {held}，其中 {waited} 它已就绪。内核线程中 {thread} 连续占用处理器最久，每次 {slice}。</translation>
    </message>
    <message>
        <source>Another program with real-time priority held the host</source>
        <translation>另一个具有实时优先级的程序占用了主机</translation>
    </message>
    <message>
        <source>It has at least the priority of the master, which waits for it.</source>
        <translation>它的优先级不低于主站，主站必须等待它。</translation>
    </message>
    <message>
        <source>Give it less priority than the master, or bind it to another processor.</source>
        <translation>请给它低于主站的优先级，或将它绑定到另一个处理器。</translation>
    </message>
    <message>
        <source>The host stood still {times}, first at {since}: it sent nothing for up to {longest}, and {count:# cycle was|# cycles were} left out. Of {held} that the master came too late, it was ready for {waited}. Of the programs with as much priority {thread} kept a processor longest, {slice} at a time.</source>
        <translation>主机停顿了 {times}，首次在 {since}：最长 {longest} 未发送任何帧，漏掉了 {count} 个周期。主站共晚了 {held}，其中 {waited} 它已就绪。优先级不低于主站的程序中 {thread} 连续占用处理器最久，每次 {slice}。</translation>
    </message>
    <message>
        <source>Other threads held the host</source>
        <translation>其他线程占用了主机</translation>
    </message>
    <message>
        <source>Outputs</source>
        <translation>输出</translation>
    </message>
    <message>
        <source>Outputs come too late for SYNC0</source>
        <translation>输出到达晚于 SYNC0 所要求的时间</translation>
    </message>
    <message>
        <source>PDO {pdo}</source>
        <translation>PDO {pdo}</translation>
    </message>
    <message>
        <source>PDO {pdo} excludes {other}, and both are assigned</source>
        <translation>PDO {pdo} 与 {other} 互斥，但两者都已分配</translation>
    </message>
    <message>
        <source>PDO {pdo} excludes {other}; only one of them can be assigned.</source>
        <translation>PDO {pdo} 与 {other} 互斥；只能分配其中一个。</translation>
    </message>
    <message>
        <source>PDO {pdo} is assigned twice.</source>
        <translation>PDO {pdo} 被分配了两次。</translation>
    </message>
    <message>
        <source>PDO {pdo} is described more than once</source>
        <translation>PDO {pdo} 被多次描述</translation>
    </message>
    <message>
        <source>PDO {pdo} is mandatory and assigned to no SyncManager</source>
        <translation>PDO {pdo} 是必选的，但未分配给任何同步管理器</translation>
    </message>
    <message>
        <source>PDO {pdo} is mandatory and not assigned.</source>
        <translation>PDO {pdo} 是必选的，但未分配。</translation>
    </message>
    <message>
        <source>PDO {pdo} must not lie in SyncManager {manager} (ESI ExcludedSm).</source>
        <translation>PDO {pdo} 不允许位于同步管理器 {manager} (ESI ExcludedSm)。</translation>
    </message>
    <message>
        <source>PDO {pdo} says {said}, the SyncManagers' lists say {assigned}</source>
        <translation>PDO {pdo} 声明为 {said}，同步管理器的列表为 {assigned}</translation>
    </message>
    <message>
        <source>PDO {pdo} takes {least} to {most:# sample|# samples} a cycle, not {factor}.</source>
        <translation>PDO {pdo} 每周期可采样 {least} 到 {most} 次，不能为 {factor} 次。</translation>
    </message>
    <message>
        <source>PDOs that exclude each other are both assigned</source>
        <translation>相互排斥的 PDO 同时被分配</translation>
    </message>
    <message>
        <source>PLL error</source>
        <translation>PLL 错误</translation>
    </message>
    <message>
        <source>PREOP is requested while the EEPROM belongs to the master (0x0500 = 0)</source>
        <translation>EEPROM 属于主站时 (0x0500 = 0) 请求了 PREOP</translation>
    </message>
    <message>
        <source>PREOP is requested while the master has the EEPROM</source>
        <translation>主站占用 EEPROM 时请求了 PREOP</translation>
    </message>
    <message>
        <source>Place</source>
        <translation>位置</translation>
    </message>
    <message>
        <source>Place of a command's data in the image</source>
        <translation>命令数据在过程映像中的位置</translation>
    </message>
    <message>
        <source>Place {place} must have a module.</source>
        <translation>插槽 {place} 必须有模块。</translation>
    </message>
    <message>
        <source>Place {place}, {name}, must have a module.</source>
        <translation>插槽 {place}（{name}）必须有模块。</translation>
    </message>
    <message>
        <source>Places of slaves' data in the image</source>
        <translation>从站数据在过程映像中的位置</translation>
    </message>
    <message>
        <source>Plug a module in.</source>
        <translation>插入一个模块。</translation>
    </message>
    <message>
        <source>Port {port} of {slave} has a link, but frames do not pass it.</source>
        <translation>{slave}的端口 {port} 有链路，但帧未通过该端口。</translation>
    </message>
    <message>
        <source>Port {port} of {slave} is open, but no slave answers behind it.</source>
        <translation>{slave}的端口 {port} 已打开，但其后没有从站响应。</translation>
    </message>
    <message>
        <source>Possible reference clock</source>
        <translation>可能的参考时钟</translation>
    </message>
    <message>
        <source>Process data and mailbox states share logical addresses</source>
        <translation>过程数据与邮箱状态共用逻辑地址</translation>
    </message>
    <message>
        <source>Process data that no FMMU maps</source>
        <translation>没有 FMMU 映射的过程数据</translation>
    </message>
    <message>
        <source>Programs that look a slave or its variables up by name find the first one</source>
        <translation>按名称查找从站或其变量的程序会找到第一个</translation>
    </message>
    <message>
        <source>Propagation delays were measured again</source>
        <translation>已重新测量传输延迟</translation>
    </message>
    <message>
        <source>Pulses come one cycle later than meant, since the shift counts modulo the cycle</source>
        <translation>脉冲比预期晚一个周期，因为偏移按周期取模计算</translation>
    </message>
    <message>
        <source>Put the APWR of 0x0910 behind the ARMW</source>
        <translation>将写 0x0910 的 APWR 放在 ARMW 之后</translation>
    </message>
    <message>
        <source>Put the vendor's ESI file into the ESI folder that you use and scan again.</source>
        <translation>将供应商的 ESI 文件放入所用的 ESI 文件夹，然后重新扫描。</translation>
    </message>
    <message>
        <source>Put the vendor's ESI file into the ESI folder {detail} and scan again.</source>
        <translation>将供应商的 ESI 文件放入 ESI 文件夹 {detail}，然后重新扫描。</translation>
    </message>
    <message>
        <source>Raise the timeout or check what the slave waits for.</source>
        <translation>增大超时时间，或检查从站在等待什么。</translation>
    </message>
    <message>
        <source>Raise watchdog.process_data, or 0 switches it off.</source>
        <translation>增大 watchdog.process_data，设为 0 则关闭看门狗。</translation>
    </message>
    <message>
        <source>Readers disagree on other values: 1 is the download that all tools write</source>
        <translation>读取软件对其他值的理解不一：1 是所有工具都写的下载</translation>
    </message>
    <message>
        <source>Readers refuse the file, or take the value for 0</source>
        <translation>读取软件会拒绝文件，或把该值当作 0</translation>
    </message>
    <message>
        <source>Readers take the first or the last, and not all the same one</source>
        <translation>读取软件会取第一个或最后一个，且各不相同</translation>
    </message>
    <message>
        <source>Readers that go by Enable leave the data out, those that go by the commands do not</source>
        <translation>按 Enable 处理的读取软件会省略这些数据，按命令处理的则不会</translation>
    </message>
    <message>
        <source>Readers use the one or the other and come to different process images</source>
        <translation>读取软件使用其中一种，因而得到不同的过程映像</translation>
    </message>
    <message>
        <source>Reading EEPROMs takes them from their slaves for that time, and the DC receive times are latched.</source>
        <translation>读取 EEPROM 期间从站无法访问它们，并且 DC 接收时间会被锁存。</translation>
    </message>
    <message>
        <source>Recv has neither PollTime nor StatusBitAddr</source>
        <translation>Recv 既没有 PollTime 也没有 StatusBitAddr</translation>
    </message>
    <message>
        <source>Reference clock</source>
        <translation>参考时钟</translation>
    </message>
    <message>
        <source>Remove all but one</source>
        <translation>只保留一个，删除其余</translation>
    </message>
    <message>
        <source>Remove one of the descriptions</source>
        <translation>删除其中一个描述</translation>
    </message>
    <message>
        <source>Remove one of them.</source>
        <translation>删除其中一个。</translation>
    </message>
    <message>
        <source>Remove the BRD of 0x092C</source>
        <translation>删除读取 0x092C 的 BRD</translation>
    </message>
    <message>
        <source>Remove the command, or write a type that it supports</source>
        <translation>删除该命令，或写入它支持的类型</translation>
    </message>
    <message>
        <source>Remove what is set for it.</source>
        <translation>删除为它设置的内容。</translation>
    </message>
    <message>
        <source>Removed</source>
        <translation>已移除</translation>
    </message>
    <message>
        <source>Request the state again and watch its AL status.</source>
        <translation>重新请求该状态并观察其 AL 状态。</translation>
    </message>
    <message>
        <source>Request the state again when the cause is removed.</source>
        <translation>排除原因后重新请求该状态。</translation>
    </message>
    <message>
        <source>Requesting it writes AL control, which an untouched machine must not see.</source>
        <translation>请求它会写 AL 控制，而不应触动的机器上不得有此写操作。</translation>
    </message>
    <message>
        <source>Requests and answers overwrite each other</source>
        <translation>请求与响应相互覆盖</translation>
    </message>
    <message>
        <source>Revision</source>
        <translation>版本号</translation>
    </message>
    <message>
        <source>SDO protocol timeout</source>
        <translation>SDO 协议超时</translation>
    </message>
    <message>
        <source>SII does not match the firmware</source>
        <translation>SII 与固件不匹配</translation>
    </message>
    <message>
        <source>SM0 and SM1 against SII words 0x14 to 0x17</source>
        <translation>SM0 和 SM1 与 SII 字 0x14 到 0x17 是否一致</translation>
    </message>
    <message>
        <source>SM2 events were missed because frames came too late</source>
        <translation>因帧到达过晚而错过 SM2 事件</translation>
    </message>
    <message>
        <source>SM2 events were missed because frames were lost</source>
        <translation>因帧丢失而错过 SM2 事件</translation>
    </message>
    <message>
        <source>A frame that was held up brought the reference clock an old time</source>
        <translation>被延误的帧给参考时钟带来了旧时间</translation>
    </message>
    <message>
        <source>Look for what holds frames up behind the master: the network card, its driver, a switch, a busy host. In master shift nothing is written to the reference clock, and such a frame moves nobody.</source>
        <translation>请查找主站之后延误帧的原因：网卡、驱动程序、交换机或繁忙的主机。在 Master Shift 模式下不向参考时钟写入任何内容，这样的帧不会使任何从站偏移。</translation>
    </message>
    <message>
        <source>A frame that was held up on its way brought the reference clock an old time at {since}: the slaves were up to {deviation} off it until they had followed.</source>
        <translation>在途中被延误的帧于 {since} 给参考时钟带来了旧时间：各从站在跟上之前最多偏离 {deviation}。</translation>
    </message>
    <message>
        <source>A frame that was held up on its way brought the reference clock an old time at {since}: the slaves followed, and the master found back to it.</source>
        <translation>在途中被延误的帧于 {since} 给参考时钟带来了旧时间：各从站随之调整，主站已重新与其同步。</translation>
    </message>
    <message>
        <source>Outputs came too late because frames were held up on their way</source>
        <translation>因帧在途中被延误，输出到达过晚</translation>
    </message>
    <message>
        <source>They were sent in time, and nothing was lost.</source>
        <translation>这些帧按时发出，没有丢失任何帧。</translation>
    </message>
    <message>
        <source>Look for what holds frames up behind the master: the network card, its driver, a switch; its SYNC0 is not the reason.</source>
        <translation>请查找主站之后延误帧的原因：网卡、驱动程序或交换机；与其 SYNC0 无关。</translation>
    </message>
    <message>
        <source>SM2 events were missed because the host left cycles out</source>
        <translation>因主机漏掉周期而错过 SM2 事件</translation>
    </message>
    <message>
        <source>SM2 events were missed in good cycles</source>
        <translation>周期正常时仍错过 SM2 事件</translation>
    </message>
    <message>
        <source>SM2 events were missed while the master was not locked</source>
        <translation>主站未锁定期间错过 SM2 事件</translation>
    </message>
    <message>
        <source>SM{manager} carries PDO {pdo}, which the slave does not describe</source>
        <translation>SM{manager} 承载了 PDO {pdo}，而从站未描述该 PDO</translation>
    </message>
    <message>
        <source>SM{manager} carries {bytes:# byte|# bytes} of process data that no FMMU maps</source>
        <translation>SM{manager} 承载了 {bytes} 字节没有 FMMU 映射的过程数据</translation>
    </message>
    <message>
        <source>SM{manager} has PDOs, and no init command on IP, PS or SO enables it</source>
        <translation>SM{manager} 带有 PDO，但 IP、PS 或 SO 上没有初始化命令启用它</translation>
    </message>
    <message>
        <source>SM{manager} is on with {bytes:# byte|# bytes} at {start}</source>
        <translation>SM{manager} 已打开，位于 {start}，共 {bytes} 字节</translation>
    </message>
    <message>
        <source>SM{manager} is set to start at {start}, its element says {said}</source>
        <translation>SM{manager} 被设为从 {start} 开始，其元素为 {said}</translation>
    </message>
    <message>
        <source>SM{manager} is set to {bytes:# byte|# bytes} at {start}, {element} says {said_bytes:# byte|# bytes} at {said_start}</source>
        <translation>SM{manager} 被设为 {start} 处 {bytes} 字节，而 {element} 为 {said_start} 处 {said_bytes} 字节</translation>
    </message>
    <message>
        <source>SM{manager} is set to {bytes:# byte|# bytes}, its PDOs have {expected}</source>
        <translation>SM{manager} 被设为 {bytes} 字节，其 PDO 为 {expected} 字节</translation>
    </message>
    <message>
        <source>SM{manager} shares memory with SM{other}</source>
        <translation>SM{manager} 与 SM{other} 共用存储区</translation>
    </message>
    <message>
        <source>SM{manager} shares memory with SM{other}, whose three buffers reach that far</source>
        <translation>SM{manager} 与 SM{other} 共用存储区，后者的三个缓冲区延伸到了该处</translation>
    </message>
    <message>
        <source>SM{sm}</source>
        <translation>SM{sm}</translation>
    </message>
    <message>
        <source>SM{sm} PDOs</source>
        <translation>SM{sm} PDO</translation>
    </message>
    <message>
        <source>SM{sm} control byte</source>
        <translation>SM{sm} 控制字节</translation>
    </message>
    <message>
        <source>SM{sm} enabled</source>
        <translation>SM{sm} 启用</translation>
    </message>
    <message>
        <source>SM{sm} only in OP</source>
        <translation>SM{sm} 仅在 OP 中</translation>
    </message>
    <message>
        <source>SM{sm} sizes</source>
        <translation>SM{sm} 大小</translation>
    </message>
    <message>
        <source>SM{sm} start</source>
        <translation>SM{sm} 起始地址</translation>
    </message>
    <message>
        <source>SM{sm} type</source>
        <translation>SM{sm} 类型</translation>
    </message>
    <message>
        <source>SM{sm} watchdog</source>
        <translation>SM{sm} 看门狗</translation>
    </message>
    <message>
        <source>SYNC signals and cyclic frames; several sync errors came together</source>
        <translation>SYNC 信号和循环帧；多个同步错误同时出现</translation>
    </message>
    <message>
        <source>SYNC signals go on when the slave has left OP, and the next start finds a running unit</source>
        <translation>从站退出 OP 后 SYNC 信号仍继续，下次启动时该单元已在运行</translation>
    </message>
    <message>
        <source>SYNC0 and frames do not keep step</source>
        <translation>SYNC0 与帧不同步</translation>
    </message>
    <message>
        <source>SYNC0 comes before the frames</source>
        <translation>SYNC0 早于帧到来</translation>
    </message>
    <message>
        <source>SYNC0 comes every {cycle}: {family} {devices} need multiples of {step}; {otherwise}. Next to it: {nearest}.</source>
        <translation>SYNC0 每 {cycle} 到来一次：{family} {devices}需要 {step} 的整数倍；{otherwise}。最接近的值：{nearest}。</translation>
    </message>
    <message>
        <source>SYNC0 comes every {cycle}: {family} {devices} take multiples of {step}. Next to it: {nearest}.</source>
        <translation>SYNC0 每 {cycle} 到来一次：{family} {devices}只接受 {step} 的整数倍。最接近的值：{nearest}。</translation>
    </message>
    <message>
        <source>SYNC0 comes every {cycle}: {limit} is the longest cycle that {family} {devices} take. Next to it: {nearest}.</source>
        <translation>SYNC0 每 {cycle} 到来一次：{limit} 是 {family} {devices}接受的最长周期。最接近的值：{nearest}。</translation>
    </message>
    <message>
        <source>SYNC0 comes every {cycle}: {limit} is the shortest cycle that {family} {devices} take. Next to it: {nearest}.</source>
        <translation>SYNC0 每 {cycle} 到来一次：{limit} 是 {family} {devices}接受的最短周期。最接近的值：{nearest}。</translation>
    </message>
    <message>
        <source>SYNC0 comes, and the slave works without it</source>
        <translation>有 SYNC0，但从站没有使用它</translation>
    </message>
    <message>
        <source>SYNC0 cycle</source>
        <translation>SYNC0 周期</translation>
    </message>
    <message>
        <source>SYNC0 does not come with the frames</source>
        <translation>SYNC0 与帧的周期不一致</translation>
    </message>
    <message>
        <source>SYNC0 every {sync0} and a frame every {cycle}: neither is a multiple of the other.</source>
        <translation>SYNC0 每 {sync0} 一次，帧每 {cycle} 一次：两者互不为整数倍。</translation>
    </message>
    <message>
        <source>SYNC0 is never switched off</source>
        <translation>SYNC0 始终没有关闭</translation>
    </message>
    <message>
        <source>SYNC0 is on, and {object}:01 = {type} does not use it: {consequence}. Set it to 2.</source>
        <translation>SYNC0 已启用，但 {object}:01 = {type} 不使用它：{consequence}。请设为 2。</translation>
    </message>
    <message>
        <source>SYNC0 is started behind the request for SAFEOP</source>
        <translation>SYNC0 在请求 SAFEOP 之后才启动</translation>
    </message>
    <message>
        <source>SYNC0 is switched on (0x0980) before its cycle time is set (0x09A0)</source>
        <translation>SYNC0 在设置其周期时间 (0x09A0) 之前启用 (0x0980)</translation>
    </message>
    <message>
        <source>SYNC0 is switched on (0x0980) before its start time is set (0x0990)</source>
        <translation>SYNC0 在设置其起始时间 (0x0990) 之前启用 (0x0980)</translation>
    </message>
    <message>
        <source>SYNC0 is switched on before its times are set</source>
        <translation>SYNC0 在设置其时间之前启用</translation>
    </message>
    <message>
        <source>SYNC0 is switched on with a cycle time of 0</source>
        <translation>SYNC0 启用时周期时间为 0</translation>
    </message>
    <message>
        <source>SYNC0 is switched on without a cycle</source>
        <translation>SYNC0 启用时没有周期</translation>
    </message>
    <message>
        <source>SYNC0 is switched on without a cycle time</source>
        <translation>SYNC0 启用时没有周期时间</translation>
    </message>
    <message>
        <source>SYNC0 is switched on, and nothing writes its cycle time (0x09A0)</source>
        <translation>SYNC0 已启用，但没有命令写入其周期时间 (0x09A0)</translation>
    </message>
    <message>
        <source>SYNC0 is switched on, and nothing writes its start time (0x0990)</source>
        <translation>SYNC0 已启用，但没有命令写入其起始时间 (0x0990)</translation>
    </message>
    <message>
        <source>SYNC0 shift</source>
        <translation>SYNC0 偏移</translation>
    </message>
    <message>
        <source>SYNC1 behind SYNC0</source>
        <translation>SYNC1 滞后于 SYNC0</translation>
    </message>
    <message>
        <source>SYNC1 cannot come before SYNC0</source>
        <translation>SYNC1 不能早于 SYNC0</translation>
    </message>
    <message>
        <source>SYNC1 is derived from SYNC0 and never comes</source>
        <translation>SYNC1 由 SYNC0 导出，永远不会出现</translation>
    </message>
    <message>
        <source>SYNC1 is switched on without SYNC0</source>
        <translation>启用了 SYNC1 但未启用 SYNC0</translation>
    </message>
    <message>
        <source>SYNC1 would come {time} before SYNC0; register 0x09A4 holds only a delay after it.</source>
        <translation>SYNC1 将比 SYNC0 早 {time}；寄存器 0x09A4 只能保存在其之后的延迟。</translation>
    </message>
    <message>
        <source>Say which slave and port it hangs on.</source>
        <translation>请指定它接在哪个从站的哪个端口上。</translation>
    </message>
    <message>
        <source>Scan again or exchange the device.</source>
        <translation>重新扫描或更换设备。</translation>
    </message>
    <message>
        <source>Scan again or take it off the bus.</source>
        <translation>重新扫描或将它从总线上移除。</translation>
    </message>
    <message>
        <source>See in the device's manual whether it has one.</source>
        <translation>查看设备手册，确认它是否具有该标识。</translation>
    </message>
    <message>
        <source>See that at it and its neighbours the cable from the master is in IN (port A) and not in OUT.</source>
        <translation>确保在它及其相邻从站上，来自主站的电缆插在 IN（端口 A）而不是 OUT。</translation>
    </message>
    <message>
        <source>See what else happened then: a clock that stepped, cycles left out, a reference clock that was lost.</source>
        <translation>查看当时还发生了什么：时钟跳变、漏掉的周期、丢失的参考时钟。</translation>
    </message>
    <message>
        <source>Send ({send}, {send_bytes:# byte|# bytes}) and Recv ({receive}, {receive_bytes:# byte|# bytes}) share memory</source>
        <translation>Send（{send}，{send_bytes} 字节）与 Recv（{receive}，{receive_bytes} 字节）共用存储区</translation>
    </message>
    <message>
        <source>Send or Recv has another size than the assigned PDOs</source>
        <translation>Send 或 Recv 的长度与已分配的 PDO 不同</translation>
    </message>
    <message>
        <source>Send or Recv is not where the frames put the data</source>
        <translation>Send 或 Recv 的位置与帧放置数据的位置不同</translation>
    </message>
    <message>
        <source>Import with an ESI that has the protocol.</source>
        <translation>使用含有该协议的 ESI 导入。</translation>
    </message>
    <message>
        <source>Sending or receiving failed</source>
        <translation>发送或接收失败</translation>
    </message>
    <message>
        <source>Sending or receiving on {subject} failed{because}.</source>
        <translation>在 {subject} 上发送或接收失败{because}。</translation>
    </message>
    <message>
        <source>Serial number</source>
        <translation>序列号</translation>
    </message>
    <message>
        <source>Set 0x0010 first, or address the slave by its position</source>
        <translation>先设置 0x0010，或按位置寻址该从站</translation>
    </message>
    <message>
        <source>Set 0x60C2 to the cycle in which set values come</source>
        <translation>将 0x60C2 设为给定值到来的周期</translation>
    </message>
    <message>
        <source>Set BitLength to the bits of the PDOs</source>
        <translation>将 BitLength 设为 PDO 的位数</translation>
    </message>
    <message>
        <source>Set Cnt to 1, or 3 where it reads and writes</source>
        <translation>将 Cnt 设为 1，若既读又写则设为 3</translation>
    </message>
    <message>
        <source>Set Cnt to reading slaves, plus writing slaves (twice with LRW)</source>
        <translation>将 Cnt 设为读取的从站数加写入的从站数（LRW 时写入按两倍计）</translation>
    </message>
    <message>
        <source>Set Cnt to the number of slaves</source>
        <translation>将 Cnt 设为从站数量</translation>
    </message>
    <message>
        <source>Set GroupMemberCnt to the number of slaves from the head of the group on</source>
        <translation>将 GroupMemberCnt 设为从组首站起的从站数量</translation>
    </message>
    <message>
        <source>Set SubIndex to 0, or CompleteAccess off</source>
        <translation>将 SubIndex 设为 0，或关闭 CompleteAccess</translation>
    </message>
    <message>
        <source>Set a cycle or a factor.</source>
        <translation>设置周期或系数。</translation>
    </message>
    <message>
        <source>Set mode and direction in the control byte by the Type: outputs 0x64 or 0x24, inputs 0x20 or 0x00</source>
        <translation>按类型设置控制字节中的模式和方向：输出为 0x64 或 0x24，输入为 0x20 或 0x00</translation>
    </message>
    <message>
        <source>Set the cycle in the master, or add CycleTime in microseconds</source>
        <translation>在主站中设置周期，或添加以微秒为单位的 CycleTime</translation>
    </message>
    <message>
        <source>Set the length to the bytes of the assigned PDOs</source>
        <translation>将长度设为已分配 PDO 的字节数</translation>
    </message>
    <message>
        <source>Set the machine's cycle time.</source>
        <translation>设置机器的周期时间。</translation>
    </message>
    <message>
        <source>Set the switches of one of them to another number.</source>
        <translation>将其中一个的拨码开关设为另一个数字。</translation>
    </message>
    <message>
        <source>ShiftTime is {shift}, the SYNC0 cycle {cycle}</source>
        <translation>ShiftTime 为 {shift}，SYNC0 周期为 {cycle}</translation>
    </message>
    <message>
        <source>Size of the inputs</source>
        <translation>输入的大小</translation>
    </message>
    <message>
        <source>Size of the outputs</source>
        <translation>输出的大小</translation>
    </message>
    <message>
        <source>Slave-to-slave copies cannot be kept</source>
        <translation>从站间的数据复制无法保留</translation>
    </message>
    <message>
        <source>Slaves are in sync</source>
        <translation>从站已同步</translation>
    </message>
    <message>
        <source>Slaves are out of sync</source>
        <translation>从站未同步</translation>
    </message>
    <message>
        <source>Slaves do not answer it, and its working counter stays 0</source>
        <translation>没有从站响应它，其工作计数器保持为 0</translation>
    </message>
    <message>
        <source>Slaves may need 100 ms and more, and the start fails now and then</source>
        <translation>从站可能需要 100 ms 以上，启动会不时失败</translation>
    </message>
    <message>
        <source>Slaves use distributed clocks, and nothing distributes the time</source>
        <translation>从站使用分布式时钟，但没有任何命令分发时间</translation>
    </message>
    <message>
        <source>So the cause is in the slave: its application needed longer than the cycle, or than the time between its outputs and SYNC0. Give it a longer cycle or more time before SYNC0, or look for what slows its firmware.</source>
        <translation>因此原因在从站：其应用程序所需时间超过周期，或超过输出到达与 SYNC0 之间的时间。请给它更长的周期或在 SYNC0 之前留出更多时间，或查找拖慢其固件的原因。</translation>
    </message>
    <message>
        <source>Some slave did not take or give its process data in this cycle.</source>
        <translation>有从站在该周期内没有接收或提供其过程数据。</translation>
    </message>
    <message>
        <source>Something is not supported</source>
        <translation>某项功能不受支持</translation>
    </message>
    <message>
        <source>Something took too long</source>
        <translation>某项操作耗时过长</translation>
    </message>
    <message>
        <source>Something was not read</source>
        <translation>有内容未读取</translation>
    </message>
    <message>
        <source>Source address</source>
        <translation>源地址</translation>
    </message>
    <message>
        <source>Split into frames</source>
        <translation>拆分为帧</translation>
    </message>
    <message>
        <source>Start-up commands cannot be kept</source>
        <translation>启动命令无法保留</translation>
    </message>
    <message>
        <source>Start-up commands come in another order</source>
        <translation>启动命令的顺序不同</translation>
    </message>
    <message>
        <source>Start-up commands of a protocol that the mailbox does not name</source>
        <translation>启动命令所用的协议未在邮箱中声明</translation>
    </message>
    <message>
        <source>Start-up commands of {protocol} cannot be kept ({commands}): the device's ESI does not know this protocol.</source>
        <translation>无法保留 {protocol} 的启动命令（{commands}）：设备的 ESI 没有此协议。</translation>
    </message>
    <message>
        <source>Station address</source>
        <translation>站地址</translation>
    </message>
    <message>
        <source>Station address 0 is that of a slave without address.</source>
        <translation>站地址 0 是没有地址的从站的地址。</translation>
    </message>
    <message>
        <source>Station address {address} is that of {name} too.</source>
        <translation>站地址 {address} 也是 {name} 的地址。</translation>
    </message>
    <message>
        <source>Swap its cables IN and OUT, or correct PhysAddr of PreviousPort</source>
        <translation>对调其 IN 和 OUT 电缆，或更正 PreviousPort 的 PhysAddr</translation>
    </message>
    <message>
        <source>Swap its cables IN and OUT, or what hangs at its port A stands in front of it.</source>
        <translation>对调其 IN 和 OUT 电缆，否则接在其端口 A 上的设备会排在它前面。</translation>
    </message>
    <message>
        <source>Swap their cables, or their positions in the configuration.</source>
        <translation>对调它们的电缆，或它们在配置中的位置。</translation>
    </message>
    <message>
        <source>Switch SYNC0 on, or start in a profile mode (0x6060)</source>
        <translation>启用 SYNC0，或以轮廓 (Profile) 模式启动 (0x6060)</translation>
    </message>
    <message>
        <source>Switch distributed clocks on, or clear the operation modes.</source>
        <translation>启用分布式时钟，或清除操作模式。</translation>
    </message>
    <message>
        <source>Switch sync-window monitoring on to prove that they are in sync.</source>
        <translation>打开同步窗口监视，以证明它们已同步。</translation>
    </message>
    <message>
        <source>Switch the monitoring off, or give more slaves an operation mode with DC.</source>
        <translation>关闭监视，或为更多从站选择带 DC 的操作模式。</translation>
    </message>
    <message>
        <source>Switch the slave off and on.</source>
        <translation>将从站断电后重新上电。</translation>
    </message>
    <message>
        <source>Sync Unit "{unit}" is to run in task "{task}", which does not exist; it stays in the base task.</source>
        <translation>同步单元“{unit}”应在任务“{task}”中运行，但该任务不存在；它保留在基本任务中。</translation>
    </message>
    <message>
        <source>Sync window monitoring compares slaves with the reference clock; {slaves:# slave with DC leaves|# slaves with DC leave} nothing to compare.</source>
        <translation>同步窗口监视将从站与参考时钟比较；只有 {slaves} 个带 DC 的从站，没有可比较的对象。</translation>
    </message>
    <message>
        <source>SyncManager watchdog</source>
        <translation>同步管理器看门狗</translation>
    </message>
    <message>
        <source>SyncManager {manager} needs at least {least:# byte|# bytes}, the PDOs have {bytes}.</source>
        <translation>同步管理器 {manager} 至少需要 {least} 字节，PDO 为 {bytes} 字节。</translation>
    </message>
    <message>
        <source>SyncManagers (0x0800)</source>
        <translation>同步管理器 (0x0800)</translation>
    </message>
    <message>
        <source>Take another ESI or revision of the device.</source>
        <translation>使用该设备的其他 ESI 或版本。</translation>
    </message>
    <message>
        <source>Take it out of the assignment, or use another PDO.</source>
        <translation>将它从分配中移除，或使用其他 PDO。</translation>
    </message>
    <message>
        <source>Take it out of the assignment.</source>
        <translation>将它从分配中移除。</translation>
    </message>
    <message>
        <source>Take one of the modules out, or another revision of the ESI.</source>
        <translation>移除其中一个模块，或使用 ESI 的其他版本。</translation>
    </message>
    <message>
        <source>Take one of them out of the assignment</source>
        <translation>将其中一个从分配中移除</translation>
    </message>
    <message>
        <source>Take one of them out of the assignment.</source>
        <translation>将其中一个从分配中移除。</translation>
    </message>
    <message>
        <source>Take the module out.</source>
        <translation>移除该模块。</translation>
    </message>
    <message>
        <source>The CAN cycle of {can} ({object}) is no multiple of the bus cycle of {cycle}: the gateway refuses SAFEOP.</source>
        <translation>{can} ({object}) 的 CAN 周期不是总线周期 {cycle} 的整数倍：网关会拒绝进入 SAFEOP。</translation>
    </message>
    <message>
        <source>The DC element and the commands contradict each other</source>
        <translation>DC 元素与命令相互矛盾</translation>
    </message>
    <message>
        <source>The EEPROM has another alias than the ESC</source>
        <translation>EEPROM 与 ESC 的别名不同</translation>
    </message>
    <message>
        <source>The EEPROM is asked and not read, or read and not asked</source>
        <translation>发出了 EEPROM 请求却未读取，或读取了却未请求</translation>
    </message>
    <message>
        <source>The EEPROM is read before it belongs to the master</source>
        <translation>EEPROM 在属于主站之前就被读取</translation>
    </message>
    <message>
        <source>The EEPROM of {slave} has the alias {written}, its ESC has {taken} until the next power-on.</source>
        <translation>{slave}的 EEPROM 中别名为 {written}，而其 ESC 在下次上电前使用 {taken}。</translation>
    </message>
    <message>
        <source>The ENI has no cycle time</source>
        <translation>ENI 没有周期时间</translation>
    </message>
    <message>
        <source>The ENI has no cycle time; {cycle} is taken.</source>
        <translation>ENI 没有周期时间；采用 {cycle}。</translation>
    </message>
    <message>
        <source>The ESC did not take its configuration from it.</source>
        <translation>ESC 没有从中获取其配置。</translation>
    </message>
    <message>
        <source>The ESC refuses the access: the working counter stays too low</source>
        <translation>ESC 拒绝访问：工作计数器过低</translation>
    </message>
    <message>
        <source>The ESC refuses the read while the slave's controller has the EEPROM</source>
        <translation>从站控制器占用 EEPROM 时，ESC 拒绝读取</translation>
    </message>
    <message>
        <source>The ESC takes the time over only when all its bytes are accessed</source>
        <translation>只有访问其全部字节时，ESC 才会采用该时间</translation>
    </message>
    <message>
        <source>The ESI does not fit what the ENI uses</source>
        <translation>ESI 与 ENI 所用的内容不符</translation>
    </message>
    <message>
        <source>The ESI does not say that the device has an explicit device ID; it is asked by the request bit of AL control all the same.</source>
        <translation>ESI 未说明设备具有显式设备标识；仍会通过 AL 控制的请求位查询。</translation>
    </message>
    <message>
        <source>The ESI gives the mailbox no usable size.</source>
        <translation>ESI 给出的邮箱没有可用的大小。</translation>
    </message>
    <message>
        <source>The ESI has no operation mode "{mode}".</source>
        <translation>ESI 没有操作模式“{mode}”。</translation>
    </message>
    <message>
        <source>The ESI has no such operation mode</source>
        <translation>ESI 没有这种操作模式</translation>
    </message>
    <message>
        <source>The ESI knows of no explicit device ID</source>
        <translation>ESI 中没有显式设备标识</translation>
    </message>
    <message>
        <source>The ESI names mailbox protocols, but no pair of mailbox SyncManagers.</source>
        <translation>ESI 声明了邮箱协议，但没有一对邮箱同步管理器。</translation>
    </message>
    <message>
        <source>The ESI's {type} was not taken, {reason}: the device is described by what the ENI uses of it.</source>
        <translation>未采用 ESI 的 {type}，{reason}：只按 ENI 用到的内容描述设备。</translation>
    </message>
    <message>
        <source>The NOP to 0x0900 is missing before the drift compensation</source>
        <translation>漂移补偿之前缺少写 0x0900 的 NOP</translation>
    </message>
    <message>
        <source>The PDO assignment of the device cannot be changed</source>
        <translation>设备的 PDO 分配不能更改</translation>
    </message>
    <message>
        <source>The PDO assignment written is another than the SyncManager lists</source>
        <translation>写入的 PDO 分配与同步管理器列表不同</translation>
    </message>
    <message>
        <source>The PDOs do not fit between MinSize and MaxSize</source>
        <translation>PDO 的长度不在 MinSize 与 MaxSize 之间</translation>
    </message>
    <message>
        <source>The SII (EEPROM) of {subject} cannot be used{because}.</source>
        <translation>{subject} 的 SII (EEPROM) 无法使用{because}。</translation>
    </message>
    <message>
        <source>The SYNC cycle is no whole number of nanoseconds</source>
        <translation>SYNC 周期不是整数纳秒</translation>
    </message>
    <message>
        <source>The SYNC0 cycle does not fit the cycle of the frames</source>
        <translation>SYNC0 周期与帧周期不匹配</translation>
    </message>
    <message>
        <source>The answer to an init command is not what it demands</source>
        <translation>初始化命令的响应与要求不符</translation>
    </message>
    <message>
        <source>The application reads or writes memory that is not there</source>
        <translation>应用程序读写不存在的存储区</translation>
    </message>
    <message>
        <source>The application reads the data of another slave</source>
        <translation>应用程序读取了另一个从站的数据</translation>
    </message>
    <message>
        <source>The application reads too many bits or too few</source>
        <translation>应用程序读取的位过多或过少</translation>
    </message>
    <message>
        <source>The auto-increment address is not that of the slave's place</source>
        <translation>自动递增地址与从站的位置不符</translation>
    </message>
    <message>
        <source>The bring-up begins again</source>
        <translation>启动过程重新开始</translation>
    </message>
    <message>
        <source>The bus cycle is not divisible by the factor; the SYNC cycle is cut to whole nanoseconds and drifts against the frame.</source>
        <translation>总线周期不能被系数整除；SYNC 周期被截为整数纳秒，会相对于帧漂移。</translation>
    </message>
    <message>
        <source>The bus has another number of slaves</source>
        <translation>总线上的从站数量不同</translation>
    </message>
    <message>
        <source>The bus has {received:# slave|# slaves} where {expected} {expected:was|were} expected.</source>
        <translation>总线上有 {received} 个从站，预期为 {expected} 个。</translation>
    </message>
    <message>
        <source>The bus shift has no effect, or disturbs a clock that follows another</source>
        <translation>总线偏移不起作用，或干扰跟随其他时钟的时钟</translation>
    </message>
    <message>
        <source>The catalogue has the device in another revision</source>
        <translation>目录中该设备的版本号不同</translation>
    </message>
    <message>
        <source>The cause of {part} of the missed events: {cause}.</source>
        <translation>其中 {part} 次错过事件的原因：{cause}。</translation>
    </message>
    <message>
        <source>The checksum of the configuration area in the EEPROM of {slave} is wrong.</source>
        <translation>{slave}的 EEPROM 中配置区的校验和错误。</translation>
    </message>
    <message>
        <source>The clocks drift too fast</source>
        <translation>时钟漂移过快</translation>
    </message>
    <message>
        <source>The command fails though the slave has answered</source>
        <translation>从站虽已响应，命令仍然失败</translation>
    </message>
    <message>
        <source>The command reaches nobody, and the transition fails</source>
        <translation>命令没有从站接收，状态切换失败</translation>
    </message>
    <message>
        <source>The configuration does not hold what this mode needs.</source>
        <translation>配置中没有此模式所需的内容。</translation>
    </message>
    <message>
        <source>The configuration of {subject} does not work out{because}.</source>
        <translation>{subject} 的配置无法成立{because}。</translation>
    </message>
    <message>
        <source>The control byte contradicts the type of the SyncManager</source>
        <translation>控制字节与同步管理器的类型矛盾</translation>
    </message>
    <message>
        <source>The control byte does not make a mailbox of SyncManager 0 or 1</source>
        <translation>控制字节没有使同步管理器 0 或 1 成为邮箱</translation>
    </message>
    <message>
        <source>The control error left its limit; look at the host's jitter, lost frames and the reference clock.</source>
        <translation>控制误差超出限值；检查主机抖动、丢帧和参考时钟。</translation>
    </message>
    <message>
        <source>The cycle is shorter than the device says it can</source>
        <translation>周期短于设备声明的最小周期</translation>
    </message>
    <message>
        <source>The cycle of a task is no multiple of the first one's</source>
        <translation>某任务的周期不是第一个任务周期的整数倍</translation>
    </message>
    <message>
        <source>The cycle of a task is no multiple of the first task's</source>
        <translation>某任务的周期不是第一个任务周期的整数倍</translation>
    </message>
    <message>
        <source>The cycle of task {task}, {cycle}, is no multiple of {first}: its slaves were put into the base task.</source>
        <translation>任务 {task} 的周期 {cycle} 不是 {first} 的整数倍：其从站已放入基本任务。</translation>
    </message>
    <message>
        <source>The cycle of {cycle} is too short: until its frames are back it takes {needed}, {wire} on the wire and {travel} on their way through {slaves:# slave|# slaves}. {late:# frame|# frames} came back too late.</source>
        <translation>周期 {cycle} 过短：帧返回需要 {needed}，其中线上 {wire}，经过 {slaves} 个从站 {travel}。有 {late} 帧返回过晚。</translation>
    </message>
    <message>
        <source>The cycle time is no whole number of microseconds</source>
        <translation>周期时间不是整数微秒</translation>
    </message>
    <message>
        <source>The cycle time written is another than the DC element says</source>
        <translation>写入的周期时间与 DC 元素声明的不同</translation>
    </message>
    <message>
        <source>The cycles do not come with the configured cycle time.</source>
        <translation>各周期不按配置的周期时间到来。</translation>
    </message>
    <message>
        <source>The cyclic frames need about {needed} of a cycle of {cycle}: {wire} on the wire and {travel} on their way through {slaves:# slave|# slaves}.</source>
        <translation>循环帧约需 {needed}，周期为 {cycle}：线上 {wire}，经过 {slaves} 个从站 {travel}。</translation>
    </message>
    <message>
        <source>The cyclic frames take {wire} of wire time, the cycle is {cycle}.</source>
        <translation>循环帧的线上时间为 {wire}，周期为 {cycle}。</translation>
    </message>
    <message>
        <source>The cyclic frames take {wire} of {cycle} of wire time; mailbox traffic has little room.</source>
        <translation>循环帧的线上时间占用 {cycle} 中的 {wire}；邮箱通信的余地很小。</translation>
    </message>
    <message>
        <source>The cyclic thread runs on another processor than it is bound to.</source>
        <translation>循环线程在其绑定处理器以外的处理器上运行。</translation>
    </message>
    <message>
        <source>The data are not consistent, and the slave never sees them</source>
        <translation>数据不一致，从站永远看不到它们</translation>
    </message>
    <message>
        <source>The data of one overwrite those of the other</source>
        <translation>其中一个的数据覆盖另一个的数据</translation>
    </message>
    <message>
        <source>The delay measurement stumbled</source>
        <translation>延迟测量遇到问题</translation>
    </message>
    <message>
        <source>The device ID of {slave} was not requested, which would write AL control.</source>
        <translation>未请求{slave}的设备标识，因为这会写 AL 控制。</translation>
    </message>
    <message>
        <source>The device cannot be told another PDO assignment than its ESI's default.</source>
        <translation>该设备只能使用其 ESI 的默认 PDO 分配。</translation>
    </message>
    <message>
        <source>The device catalogue cannot be used</source>
        <translation>设备目录无法使用</translation>
    </message>
    <message>
        <source>The device catalogue {file} cannot be used{because}.</source>
        <translation>设备目录 {file} 无法使用{because}。</translation>
    </message>
    <message>
        <source>The device does not take so many samples a cycle</source>
        <translation>设备不接受每周期这么多次采样</translation>
    </message>
    <message>
        <source>The device has no AoE; its AMS Net ID is not written.</source>
        <translation>设备不支持 AoE；其 AMS Net ID 不会写入。</translation>
    </message>
    <message>
        <source>The device has no EoE; its addresses are not set.</source>
        <translation>设备不支持 EoE；其地址不会设置。</translation>
    </message>
    <message>
        <source>The device has no PDO {pdo} in this direction.</source>
        <translation>设备在该方向上没有 PDO {pdo}。</translation>
    </message>
    <message>
        <source>The device has no PDO {pdo}.</source>
        <translation>设备没有 PDO {pdo}。</translation>
    </message>
    <message>
        <source>The device {subject} is not known{because}.</source>
        <translation>设备 {subject} 未知{because}。</translation>
    </message>
    <message>
        <source>The device's reaction to missed SM events is switched off</source>
        <translation>设备对错过 SM 事件的响应已关闭</translation>
    </message>
    <message>
        <source>The drive does not execute the mode, or moves badly</source>
        <translation>驱动器不执行该模式，或运动质量差</translation>
    </message>
    <message>
        <source>The error limit 0x10F1:02 is 0: the slave never stops for missed SM events, the application has to watch their counter.</source>
        <translation>错误限值 0x10F1:02 为 0：从站不会因错过 SM 事件而停止，应用程序必须监视其计数器。</translation>
    </message>
    <message>
        <source>The error limit 0x10F1:02 is set to {limit}, {family} {devices} take 0 to {most} and refuse the download.</source>
        <translation>错误限值 0x10F1:02 被设为 {limit}，{family} {devices}只接受 0 到 {most} 并会拒绝该下载。</translation>
    </message>
    <message>
        <source>The file cannot be taken in</source>
        <translation>无法导入该文件</translation>
    </message>
    <message>
        <source>The file {file} cannot be read{because}.</source>
        <translation>文件 {file} 无法读取{because}。</translation>
    </message>
    <message>
        <source>The file {file} cannot be written{because}.</source>
        <translation>文件 {file} 无法写入{because}。</translation>
    </message>
    <message>
        <source>The file {file} does not exist.</source>
        <translation>文件 {file} 不存在。</translation>
    </message>
    <message>
        <source>The firmware of {slave} was silent at {since}: its PDI watchdog expired {count} (0x0443).</source>
        <translation>{slave} 的固件在 {since} 时没有响应：其 PDI 看门狗超时 {count} (0x0443)。</translation>
    </message>
    <message>
        <source>The first frames of the new state find no data, and working counters are too low</source>
        <translation>新状态的最初几帧找不到数据，工作计数器过低</translation>
    </message>
    <message>
        <source>The first slave of a hot-connect group</source>
        <translation>热连接组的第一个从站</translation>
    </message>
    <message>
        <source>The first slave of the bus cannot be optional</source>
        <translation>总线的第一个从站不能是可选的</translation>
    </message>
    <message>
        <source>The frame passes it before it carries the time of this cycle, so that it is given the last one, or 0, and stays off</source>
        <translation>帧在携带本周期时间之前就经过它，因此它得到上一周期的时间或 0，并一直有偏差</translation>
    </message>
    <message>
        <source>The frames and their way through the slaves take longer than the cycle</source>
        <translation>帧及其经过从站的时间超过周期</translation>
    </message>
    <message>
        <source>The frames cannot steer the reference clock</source>
        <translation>帧无法调节参考时钟</translation>
    </message>
    <message>
        <source>The frames do not fit into the cycle</source>
        <translation>帧放不进周期</translation>
    </message>
    <message>
        <source>The frames fill most of the cycle</source>
        <translation>帧占用了周期的大部分</translation>
    </message>
    <message>
        <source>The frames reach {slave} nominally {margin} before its SYNC0, and one in a thousand is {lateness} late.</source>
        <translation>帧标称在 SYNC0 之前 {margin} 到达{slave}，而每一千帧中有一帧晚 {lateness}。</translation>
    </message>
    <message>
        <source>The frames reach {slave} nominally {margin} before its SYNC0, and it needs {need} for its outputs (0x1C32:06); one in a thousand is {lateness} late.</source>
        <translation>帧标称在 SYNC0 之前 {margin} 到达{slave}，而它的输出需要 {need}（0x1C32:06）；每一千帧中有一帧晚 {lateness}。</translation>
    </message>
    <message>
        <source>The frames take longer on the wire than the cycle</source>
        <translation>帧的线上时间超过周期</translation>
    </message>
    <message>
        <source>The frames take over 80 % of the cycle</source>
        <translation>帧占用周期的 80 % 以上</translation>
    </message>
    <message>
        <source>The gateway is told a bus cycle of {told} (0x1C32:02), frames come every {cycle}.</source>
        <translation>告知网关的总线周期为 {told} (0x1C32:02)，而帧每 {cycle} 到来一次。</translation>
    </message>
    <message>
        <source>The gateway refuses SAFEOP (AL status code 0x0026 or 0x0035)</source>
        <translation>网关拒绝进入 SAFEOP（AL 状态码 0x0026 或 0x0035）</translation>
    </message>
    <message>
        <source>The host left cycles out</source>
        <translation>主机遗漏了周期</translation>
    </message>
    <message>
        <source>The host&apos;s jitter reaches the reference clock</source>
        <translation>主机的抖动传到了参考时钟</translation>
    </message>
    <message>
        <source>In this mode of the master synchronisation the reference clock is told the host&apos;s time as it is, without a control loop in front of it.</source>
        <translation>在这种主站同步模式下，写给参考时钟的就是主机的时间，前面没有控制环。</translation>
    </message>
    <message>
        <source>Choose bus shift or master shift, which keep the host&apos;s jitter away from the clocks; else a host with a more exact timer, or a wider sync window.</source>
        <translation>请选择总线移位或主站移位，它们使主机的抖动不影响时钟；否则请使用定时器更精确的主机，或放宽同步窗口。</translation>
    </message>
    <message>
        <source>The reference clock is told the host&apos;s time as it is (master-ref-clock): each frame that leaves later or earlier than the host believes shakes it, and all slaves with it.</source>
        <translation>写给参考时钟的就是主机的时间（master-ref-clock）：每个实际发出时刻早于或晚于主机所认为的帧都会扰动它，并波及所有从站。</translation>
    </message>
    <message>
        <source>The reference clock is told the host&apos;s time as it is (master-ref-clock): each frame that leaves later or earlier than the host believes shakes it, and all slaves with it. Half of the frames left up to {p50} late, one in a hundred {p99} or more, one in a thousand {p999}, at most {largest}.</source>
        <translation>写给参考时钟的就是主机的时间（master-ref-clock）：每个实际发出时刻早于或晚于主机所认为的帧都会扰动它，并波及所有从站。一半的帧晚发不超过 {p50}，百分之一晚 {p99} 以上，千分之一晚 {p999}，最多 {largest}。</translation>
    </message>
    <message>
        <source>The host sends late</source>
        <translation>主机发送过晚</translation>
    </message>
    <message>
        <source>The host sends late: half of the frames by {p50}, one in a hundred by {p99}, one in a thousand by {p999}, at most {largest}; the frames may be {margin} late.</source>
        <translation>主机发送过晚：一半的帧晚 {p50}，百分之一晚 {p99}，千分之一晚 {p999}，最多晚 {largest}；帧最多允许晚 {margin}。</translation>
    </message>
    <message>
        <source>The host stood still</source>
        <translation>主机曾停顿</translation>
    </message>
    <message>
        <source>The host stood still {times}, first at {since}: it sent nothing for up to {longest}, and {count:# cycle was|# cycles were} left out.</source>
        <translation>主机停顿了 {times}，首次在 {since}：最长 {longest} 未发送任何帧，漏掉了 {count} 个周期。</translation>
    </message>
    <message>
        <source>The host stood still {times}, first at {since}: it sent nothing for up to {longest}, and {count:# cycle was|# cycles were} left out. Of {held} that the master came too late, it was ready for {waited}, and other threads had its processor.</source>
        <translation>主机停顿了 {times}，首次在 {since}：最长 {longest} 未发送任何帧，漏掉了 {count} 个周期。主站共晚了 {held}，其中 {waited} 它已就绪，而处理器被其他线程占用。</translation>
    </message>
    <message>
        <source>The host stood still {times}, first at {since}: it sent nothing for up to {longest}, and {count:# cycle was|# cycles were} left out. The master came {held} too late, and other threads had its processor for {waited} of that only: it was stopped, or its timer came late.</source>
        <translation>主机停顿了 {times}，首次在 {since}：最长 {longest} 未发送任何帧，漏掉了 {count} 个周期。主站共晚了 {held}，其中只有 {waited} 处理器被其他线程占用：它被暂停，或其定时器触发过晚。</translation>
    </message>
    <message>
        <source>The host's clock and the reference clock drift by {drift}; no controller balances more than 600 ppm.</source>
        <translation>主机时钟与参考时钟之间的漂移为 {drift}；超过 600 ppm 时任何控制器都无法补偿。</translation>
    </message>
    <message>
        <source>The host's cycle has stopped.</source>
        <translation>主机的周期已停止。</translation>
    </message>
    <message>
        <source>Nothing woke the master in time</source>
        <translation>主站未被及时唤醒</translation>
    </message>
    <message>
        <source>The host's timer cannot be adjusted as far as the controller demands.</source>
        <translation>主机定时器无法调整到控制器要求的程度。</translation>
    </message>
    <message>
        <source>The identity of a slave is not checked</source>
        <translation>未检查从站的标识</translation>
    </message>
    <message>
        <source>The identity that a command expects is not the one of Info</source>
        <translation>命令期望的标识与 Info 中的不同</translation>
    </message>
    <message>
        <source>The interpolation time cannot be the cycle</source>
        <translation>插补时间无法等于周期</translation>
    </message>
    <message>
        <source>The interpolation time is not the cycle</source>
        <translation>插补时间与周期不同</translation>
    </message>
    <message>
        <source>The link cannot put its send time into the frames.</source>
        <translation>网卡无法将其发送时间写入帧中。</translation>
    </message>
    <message>
        <source>The link {subject} is down{because}.</source>
        <translation>链路 {subject} 断开{because}。</translation>
    </message>
    <message>
        <source>The mailboxes of a slave share memory</source>
        <translation>从站的两个邮箱共用存储区</translation>
    </message>
    <message>
        <source>The mapping of PDO {pdo} is fixed.</source>
        <translation>PDO {pdo} 的映射是固定的。</translation>
    </message>
    <message>
        <source>The mapping of a PDO cannot be changed</source>
        <translation>PDO 的映射不能更改</translation>
    </message>
    <message>
        <source>The mapping written is another than the PDO lists</source>
        <translation>写入的映射与 PDO 的列表不同</translation>
    </message>
    <message>
        <source>The master cannot check the wiring, and takes every line for a wrong one or none</source>
        <translation>主站无法检查接线，会把任何线路都视为错误，或都不视为错误</translation>
    </message>
    <message>
        <source>The master copies from or to memory that is not there</source>
        <translation>主站从不存在的存储区复制，或复制到不存在的存储区</translation>
    </message>
    <message>
        <source>The master copies too little or too much between image and slave</source>
        <translation>主站在过程映像与从站之间复制的数据过少或过多</translation>
    </message>
    <message>
        <source>The master does not clear what an earlier run left</source>
        <translation>主站没有清除上次运行的残留</translation>
    </message>
    <message>
        <source>The master does not notice when slaves fall out and uses old inputs</source>
        <translation>主站察觉不到从站掉线，会使用旧的输入</translation>
    </message>
    <message>
        <source>The master has no command to put the start time into, and SYNC0 may start in the past, which is never</source>
        <translation>主站没有可写入起始时间的命令，SYNC0 可能从过去的时间开始，即永远不启动</translation>
    </message>
    <message>
        <source>The master has to ask for it apart, and learns of errors later</source>
        <translation>主站必须另行查询，从而较晚才得知错误</translation>
    </message>
    <message>
        <source>The master has to guess how often to look for answers and emergencies</source>
        <translation>主站只能猜测查询响应和紧急报文的频率</translation>
    </message>
    <message>
        <source>The master is in sync</source>
        <translation>主站已同步</translation>
    </message>
    <message>
        <source>The master is not in sync</source>
        <translation>主站未同步</translation>
    </message>
    <message>
        <source>The master is not in sync with the reference clock (schedule error {error}){obstacle}.</source>
        <translation>主站与参考时钟未同步（调度误差 {error}）{obstacle}。</translation>
    </message>
    <message>
        <source>The master is out of sync</source>
        <translation>主站未同步</translation>
    </message>
    <message>
        <source>The master looks into the wrong mailbox</source>
        <translation>主站查看了错误的邮箱</translation>
    </message>
    <message>
        <source>The master never sees that the mailbox is full, and answers are lost</source>
        <translation>主站察觉不到邮箱已满，响应会丢失</translation>
    </message>
    <message>
        <source>The master or a slave is in another state</source>
        <translation>主站或从站处于其他状态</translation>
    </message>
    <message>
        <source>The master runs a configuration</source>
        <translation>主站正在运行配置</translation>
    </message>
    <message>
        <source>The master runs nothing</source>
        <translation>主站未运行任何内容</translation>
    </message>
    <message>
        <source>The master stopped by something that should not have happened</source>
        <translation>主站因不应发生的情况而停止</translation>
    </message>
    <message>
        <source>The master synchronisation failed.</source>
        <translation>主站同步失败。</translation>
    </message>
    <message>
        <source>The master synchronisation gave up</source>
        <translation>主站同步已放弃</translation>
    </message>
    <message>
        <source>The master synchronisation is not running; bring the bus to PREOP first.</source>
        <translation>主站同步未运行；请先让总线进入 PREOP。</translation>
    </message>
    <message>
        <source>The master synchronisation reports an error</source>
        <translation>主站同步报告错误</translation>
    </message>
    <message>
        <source>The master synchronisation reports {code}: {meaning}</source>
        <translation>主站同步报告 {code}：{meaning}</translation>
    </message>
    <message>
        <source>The master takes one group for the other</source>
        <translation>主站会混淆这两个组</translation>
    </message>
    <message>
        <source>The master takes slaves of the fixed line for members, or misses some</source>
        <translation>主站会把固定线路的从站当作成员，或遗漏部分成员</translation>
    </message>
    <message>
        <source>The master takes the answer of every cycle for a missing slave</source>
        <translation>主站会把每个周期的响应都当作从站缺失</translation>
    </message>
    <message>
        <source>The master takes the data of every cycle for invalid</source>
        <translation>主站会把每个周期的数据都视为无效</translation>
    </message>
    <message>
        <source>The master was out of sync for a while</source>
        <translation>主站曾有一段时间未同步</translation>
    </message>
    <message>
        <source>The master was out of sync with the reference clock {count}, first at {since}{obstacle}; it found back.</source>
        <translation>主站与参考时钟失步 {count}，首次在 {since}{obstacle}；之后已恢复。</translation>
    </message>
    <message>
        <source>The master writes its messages beside the mailbox, and the slave refuses PREOP</source>
        <translation>主站把消息写在邮箱之外，从站会拒绝进入 PREOP</translation>
    </message>
    <message>
        <source>The master's DCM error is beyond its limit</source>
        <translation>主站的 DCM 错误超过限值</translation>
    </message>
    <message>
        <source>The network adapter is away</source>
        <translation>网卡不可用</translation>
    </message>
    <message>
        <source>The network adapter is back</source>
        <translation>网卡已恢复</translation>
    </message>
    <message>
        <source>The network adapter was away for a while</source>
        <translation>网卡曾有一段时间不可用</translation>
    </message>
    <message>
        <source>The network adapter {adapter} is down, gone or without carrier since {since}.</source>
        <translation>网卡 {adapter} 从 {since} 起已关闭、被移除或无载波。</translation>
    </message>
    <message>
        <source>The network adapter {adapter} was down, gone or without carrier from {since} on, for {length} ({count} in all); the bus came back with it.</source>
        <translation>网卡 {adapter} 从 {since} 起关闭、被移除或无载波，持续 {length}（共 {count}）；总线随它一起恢复。</translation>
    </message>
    <message>
        <source>The next commands reach the slave before it is ready</source>
        <translation>后续命令在从站就绪之前就已到达</translation>
    </message>
    <message>
        <source>The open ports do not explain a slave's place</source>
        <translation>打开的端口无法解释从站的位置</translation>
    </message>
    <message>
        <source>The open ports of the slaves before {slave} do not explain its place.</source>
        <translation>{slave}之前各从站的打开端口无法解释其位置。</translation>
    </message>
    <message>
        <source>The process data do not fit</source>
        <translation>过程数据放不下</translation>
    </message>
    <message>
        <source>The process data lie over the mailbox states at 0x09000000.</source>
        <translation>过程数据覆盖了 0x09000000 处的邮箱状态。</translation>
    </message>
    <message>
        <source>The process data need more FMMUs than the device has</source>
        <translation>过程数据所需的 FMMU 多于设备所有</translation>
    </message>
    <message>
        <source>The process data need {fmmus:# FMMU|# FMMUs}, the device has {available}.</source>
        <translation>过程数据需要 {fmmus} 个 FMMU，设备只有 {available} 个。</translation>
    </message>
    <message>
        <source>The process data of a slave lie outside the image</source>
        <translation>从站的过程数据位于过程映像之外</translation>
    </message>
    <message>
        <source>The process data watchdog is shorter than two cycles</source>
        <translation>过程数据看门狗短于两个周期</translation>
    </message>
    <message>
        <source>The process data watchdog of {slave} expired {count} (0x0442), last at {last}.</source>
        <translation>{slave} 的过程数据看门狗超时 {count} (0x0442)，最近一次在 {last}。</translation>
    </message>
    <message>
        <source>The process data watchdog runs out after {time}, outputs come every {cycle}: one lost frame stops the slave.</source>
        <translation>过程数据看门狗在 {time} 后超时，输出每 {cycle} 更新一次：丢失一帧就会使从站停止。</translation>
    </message>
    <message>
        <source>The project cannot be compiled: {reason}</source>
        <translation>项目无法编译：{reason}</translation>
    </message>
    <message>
        <source>The recovered project cannot be compiled</source>
        <translation>恢复出的项目无法编译</translation>
    </message>
    <message>
        <source>The reference clock does not answer</source>
        <translation>参考时钟无响应</translation>
    </message>
    <message>
        <source>The reference clock has no distributed clock</source>
        <translation>参考时钟没有分布式时钟</translation>
    </message>
    <message>
        <source>The reference clock is no slave of the bus</source>
        <translation>参考时钟不是总线上的从站</translation>
    </message>
    <message>
        <source>The reference clock is steered before its time is read</source>
        <translation>在读取参考时钟的时间之前就对其进行调节</translation>
    </message>
    <message>
        <source>The reference clock is there</source>
        <translation>参考时钟已就绪</translation>
    </message>
    <message>
        <source>The root element is not EtherCATConfig</source>
        <translation>根元素不是 EtherCATConfig</translation>
    </message>
    <message>
        <source>Save the file as UTF-8, and have its first line say so</source>
        <translation>把文件另存为 UTF-8，并在第一行中声明</translation>
    </message>
    <message>
        <source>Names and comments come out as other letters, here or in the next program</source>
        <translation>名称和注释会显示为别的字符，在这里或在下一个程序中</translation>
    </message>
    <message>
        <source>The text is not in the encoding that the file names</source>
        <translation>文本不是文件所声明的编码</translation>
    </message>
    <message>
        <source>{count:# finding more is|# findings more are} not listed</source>
        <translation>另有 {count} 个问题未列出</translation>
    </message>
    <message>
        <source>Mend what is listed, then check again</source>
        <translation>改正所列出的问题，然后重新检查</translation>
    </message>
    <message>
        <source>What is wrong in each of thousands of elements is one mistake: the first 1,000 findings of a rule are listed, and 10,000 in all</source>
        <translation>成千上万个元素中同样的错误其实是一个错误：每条规则只列出前 1000 个问题，总共最多 10000 个</translation>
    </message>
    <message>
        <source>There are more findings than are listed</source>
        <translation>发现的问题多于所列出的</translation>
    </message>
    <message>
        <source>The second overwrites the data of the first; buffers change twice a cycle</source>
        <translation>第二个会覆盖第一个的数据；缓冲区在每个周期更改两次</translation>
    </message>
    <message>
        <source>The set value is too small: at SYNC0 the frame is still on its way; raise it above frame time plus propagation delay, below the cycle.</source>
        <translation>设定值过小：SYNC0 到来时帧仍在途中；请增大到帧时间加传输延迟以上，但小于周期。</translation>
    </message>
    <message>
        <source>The shift is longer than the cycle</source>
        <translation>偏移长于周期</translation>
    </message>
    <message>
        <source>The signals start at once with old values</source>
        <translation>信号立即以旧值启动</translation>
    </message>
    <message>
        <source>The size of the data and the variables in them are unknown</source>
        <translation>数据长度及其中的变量未知</translation>
    </message>
    <message>
        <source>The slave aborts it (0x06070010, 0x06070012 or 0x06070013) and the transition fails</source>
        <translation>从站会中止它（0x06070010、0x06070012 或 0x06070013），状态切换失败</translation>
    </message>
    <message>
        <source>The slave cannot read its own settings and may refuse PREOP (AL status code 0x0051)</source>
        <translation>从站无法读取自身的设置，可能拒绝进入 PREOP（AL 状态码 0x0051）</translation>
    </message>
    <message>
        <source>The slave checks it while it changes its state and refuses</source>
        <translation>从站在状态切换时检查它并拒绝切换</translation>
    </message>
    <message>
        <source>The slave comes to OP, and a part of it is not synchronised</source>
        <translation>从站能到达 OP，但其中一部分未同步</translation>
    </message>
    <message>
        <source>The slave exchanges other data than the master expects, or refuses SAFEOP (AL status code 0x001D or 0x001E)</source>
        <translation>从站交换的数据与主站期望的不同，或拒绝进入 SAFEOP（AL 状态码 0x001D 或 0x001E）</translation>
    </message>
    <message>
        <source>The slave farther down the line overwrites the data of the other</source>
        <translation>线路下游的从站会覆盖另一个从站的数据</translation>
    </message>
    <message>
        <source>The slave gets one pulse and no more, and refuses SAFEOP or OP (AL status code 0x002D or 0x0035)</source>
        <translation>从站只收到一个脉冲，并拒绝进入 SAFEOP 或 OP（AL 状态码 0x002D 或 0x0035）</translation>
    </message>
    <message>
        <source>The slave goes elsewhere, or refuses the request (AL status code 0x0011)</source>
        <translation>从站进入其他状态，或拒绝请求（AL 状态码 0x0011）</translation>
    </message>
    <message>
        <source>The slave goes on with old outputs, however many are missed</source>
        <translation>无论错过多少，从站都会继续使用旧的输出</translation>
    </message>
    <message>
        <source>The slave got no outputs for too long.</source>
        <translation>从站过长时间未收到输出。</translation>
    </message>
    <message>
        <source>The slave may be busy or its mailbox is set up wrongly.</source>
        <translation>从站可能忙，或其邮箱设置有误。</translation>
    </message>
    <message>
        <source>The slave may refuse to go to SAFEOP without it</source>
        <translation>没有它，从站可能拒绝进入 SAFEOP</translation>
    </message>
    <message>
        <source>The slave refuses PREOP with AL status code 0x0016</source>
        <translation>从站以 AL 状态码 0x0016 拒绝进入 PREOP</translation>
    </message>
    <message>
        <source>The slave refuses SAFEOP (AL status code 0x001D or 0x001E)</source>
        <translation>从站拒绝进入 SAFEOP（AL 状态码 0x001D 或 0x001E）</translation>
    </message>
    <message>
        <source>The slave refuses SAFEOP (AL status code 0x001D or 0x001E), as it has no process data</source>
        <translation>从站没有过程数据，因此拒绝进入 SAFEOP（AL 状态码 0x001D 或 0x001E）</translation>
    </message>
    <message>
        <source>The slave refuses SAFEOP (AL status code 0x0035, 0x0036 or 0x002E)</source>
        <translation>从站拒绝进入 SAFEOP（AL 状态码 0x0035、0x0036 或 0x002E）</translation>
    </message>
    <message>
        <source>The slave refuses SAFEOP with an invalid SyncManager configuration, or overwrites its memory</source>
        <translation>从站因同步管理器配置无效而拒绝进入 SAFEOP，或覆盖自身的存储区</translation>
    </message>
    <message>
        <source>The slave refuses the SyncManager, or data flow in the wrong direction</source>
        <translation>从站拒绝该同步管理器，或数据方向错误</translation>
    </message>
    <message>
        <source>The slave refuses the SyncManager, or data land where it does not look for them</source>
        <translation>从站拒绝该同步管理器，或数据落在它不查找的位置</translation>
    </message>
    <message>
        <source>The slave refuses the assignment (AL status code 0x0024 or 0x0025)</source>
        <translation>从站拒绝该分配（AL 状态码 0x0024 或 0x0025）</translation>
    </message>
    <message>
        <source>The slave refuses the assignment or the mapping</source>
        <translation>从站拒绝该分配或映射</translation>
    </message>
    <message>
        <source>The slave refuses the download to 0x10F1:02, which ends the start-up</source>
        <translation>从站拒绝对 0x10F1:02 的下载，启动随之中断</translation>
    </message>
    <message>
        <source>The slave refuses the download to 0x1C32:01 or 0x1C33:01, or SAFEOP</source>
        <translation>从站拒绝对 0x1C32:01 或 0x1C33:01 的下载，或拒绝进入 SAFEOP</translation>
    </message>
    <message>
        <source>The slave runs with the one, the master plans with the other</source>
        <translation>从站按其中一个运行，主站按另一个规划</translation>
    </message>
    <message>
        <source>The slave stays where it is and the bus never reaches OP</source>
        <translation>从站停留在原状态，总线永远无法到达 OP</translation>
    </message>
    <message>
        <source>The slave that Info describes fails the check: the bus does not leave INIT</source>
        <translation>Info 中描述的从站通不过检查：总线无法离开 INIT</translation>
    </message>
    <message>
        <source>The slave's data never move: outputs stay 0 and its watchdog expires, inputs stay old</source>
        <translation>从站的数据永远不更新：输出保持为 0 且看门狗超时，输入一直是旧的</translation>
    </message>
    <message>
        <source>The slave's firmware does not serve its ESC any more.</source>
        <translation>从站固件不再处理其 ESC。</translation>
    </message>
    <message>
        <source>The slaves are not in sync</source>
        <translation>从站未同步</translation>
    </message>
    <message>
        <source>The slaves are not in sync within {limit} since {since}.</source>
        <translation>从 {since} 起从站的偏差不在 {limit} 之内。</translation>
    </message>
    <message>
        <source>its SYNC0 was started at another place</source>
        <translation>其 SYNC0 在其他位置启动</translation>
    </message>
    <message>
        <source>What they carry is not known: a cycle without its frame is missing, or counts as one whose frame was lost.</source>
        <translation>其内容未知：缺少帧的周期会缺失，或被计为帧丢失的周期。</translation>
    </message>
    <message>
        <source>Whoever has written or copied it did not come to its end.</source>
        <translation>写入或复制它的程序没有完成。</translation>
    </message>
    <message>
        <source>a recording that is shown here</source>
        <translation>此处显示的记录</translation>
    </message>
    <message>
        <source>its cycle {cycle} does not come behind that of the line before</source>
        <translation>其周期 {cycle} 不在前一行的周期之后</translation>
    </message>
    <message>
        <source>of {other} cells it has only {count}</source>
        <translation>在 {other} 个单元格中只有 {count} 个</translation>
    </message>
    <message>
        <source>it is {what}, which would be lost: choose another name</source>
        <translation>它是{what}，写入会使其丢失：请选择另一个名称</translation>
    </message>
    <message>
        <source>its own clock was out of its place</source>
        <translation>其自身时钟偏离了应有位置</translation>
    </message>
    <message>
        <source>the frames' way behind {subject} has changed: {slaves:# slave there is|# slaves there are} at once off by {deviation}, with delays that were measured before</source>
        <translation>{subject} 之后的帧路径已改变：其后 {slaves:# 个从站|# 个从站}同时偏差 {deviation}，使用的是此前测得的延迟</translation>
    </message>
    <message>
        <source>its tables are not those of version {version}</source>
        <translation>其中的表不是版本 {version} 的表</translation>
    </message>
    <message>
        <source>the frames' way behind {subject} has changed: {slaves:# slave that follows|all # slaves that follow} at once off by {deviation}, with a delay that was measured before</source>
        <translation>{subject} 之后的帧路径已改变：{slaves:# 个跟随的从站|全部 # 个跟随的从站}同时偏差 {deviation}，使用的是此前测得的延迟</translation>
    </message>
    <message>
        <source>the project that is open here</source>
        <translation>此处打开的项目</translation>
    </message>
    <message>
        <source>the recording that is being written</source>
        <translation>正在写入的记录</translation>
    </message>
    <message>
        <source>{count:# frame was|# frames were} captured in part only and passed over.</source>
        <translation>{count:# 个帧|# 个帧} 只被部分抓取，已略过。</translation>
    </message>
    <message>
        <source>{count:# frame|# frames} did not come back (up to {most} close together, first at {since}), and {slave} had its outputs all the same: they had passed it, and no slave counted an error at its ports.</source>
        <translation>{count:# 个帧|# 个帧}未返回（密集时最多 {most} 个，首次在 {since}），而 {slave} 仍收到了输出：这些帧已经过它，且没有从站在端口上计到错误。</translation>
    </message>
    <message>
        <source>{count:# row|# rows} of the table {table} {count:is|are} missing</source>
        <translation>表 {table} 缺少 {count:# 行|# 行}</translation>
    </message>
    <message>
        <source>{count:# row|# rows} of the table {table} {count:is|are} missing: cycles {first} to {last} are a gap</source>
        <translation>表 {table} 缺少 {count:# 行|# 行}：周期 {first} 至 {last} 为空缺</translation>
    </message>
    <message>
        <source>{file} is an ENI, which holds one alone: leave the network out</source>
        <translation>{file} 是 ENI，只含一个网络：请不要指定网络</translation>
    </message>
    <message>
        <source>{slave} left the sync window at {since} ({deviation}, limit {limit}). No reading is outside any more, but not for the settle time yet.</source>
        <translation>{slave} 在 {since} 离开了同步窗口（{deviation}，限值 {limit}）。已没有读数在窗口之外，但尚未持续达到稳定时间。</translation>
    </message>
    <message>
        <source>Whether the slaves are in sync is not known</source>
        <translation>从站是否同步未知</translation>
    </message>
    <message>
        <source>Mend first what keeps the readings away: a reference clock that is gone, frames that are lost, the adapter.</source>
        <translation>请先排除使读数缺失的原因：参考时钟消失、帧丢失或网络适配器。</translation>
    </message>
    <message>
        <source>Nobody knows since {since} whether the slaves are in sync within {limit}: not all of their deviations can be read.</source>
        <translation>自 {since} 起无法得知从站是否在 {limit} 之内同步：并非所有偏差都能读取。</translation>
    </message>
    <message>
        <source>The slaves are not in sync: {slave} is {deviation} off its reference clock, the limit is {limit}.</source>
        <translation>从站未同步：{slave} 与其参考时钟的偏差为 {deviation}，限值为 {limit}。</translation>
    </message>
    <message>
        <source>The slaves' deviation is not monitored.</source>
        <translation>未监视从站的偏差。</translation>
    </message>
    <message>
        <source>The start-time command carries another shift than the DC element</source>
        <translation>起始时间命令的偏移与 DC 元素不同</translation>
    </message>
    <message>
        <source>The state of the slaves is not read cyclically</source>
        <translation>没有循环读取从站的状态</translation>
    </message>
    <message>
        <source>The status bit of a mailbox is not wired up</source>
        <translation>邮箱的状态位没有接通</translation>
    </message>
    <message>
        <source>The sync window has nothing to compare</source>
        <translation>同步窗口没有可比较的对象</translation>
    </message>
    <message>
        <source>The sync window is monitored with fewer than two clocks</source>
        <translation>时钟少于两个却监视同步窗口</translation>
    </message>
    <message>
        <source>The time distributed is not that of the reference clock</source>
        <translation>分发的时间不是参考时钟的时间</translation>
    </message>
    <message>
        <source>The time is distributed by FRMW</source>
        <translation>时间用 FRMW 分发</translation>
    </message>
    <message>
        <source>The time is not distributed in all states from PREOP on</source>
        <translation>时间没有从 PREOP 起在所有状态中分发</translation>
    </message>
    <message>
        <source>The time-out of a change of state is very short</source>
        <translation>状态切换的超时时间过短</translation>
    </message>
    <message>
        <source>The transition ends in a time-out though the slave is right</source>
        <translation>从站虽正常，状态切换仍以超时结束</translation>
    </message>
    <message>
        <source>The value of {subject} cannot be used{because}.</source>
        <translation>{subject} 的值无法使用{because}。</translation>
    </message>
    <message>
        <source>The way through the network card takes too long now and then: interrupt moderation, a switch, or a busy host.</source>
        <translation>经过网卡的时间不时过长：中断聚合、交换机或主机繁忙。</translation>
    </message>
    <message>
        <source>The wiring is unknown: propagation delays will be measured as if in a line.</source>
        <translation>接线未知：测量传输延迟时将按线形拓扑处理。</translation>
    </message>
    <message>
        <source>The wiring of a slave is unknown</source>
        <translation>从站的接线未知</translation>
    </message>
    <message>
        <source>The working counter of a broadcast does not fit the number of slaves</source>
        <translation>广播命令的工作计数器与从站数量不符</translation>
    </message>
    <message>
        <source>The working counter of a command to one slave is impossible</source>
        <translation>发往单个从站的命令的工作计数器不可能出现</translation>
    </message>
    <message>
        <source>The working counter of a process-data command does not fit the FMMUs</source>
        <translation>过程数据命令的工作计数器与 FMMU 不符</translation>
    </message>
    <message>
        <source>The write that steers the reference clock does not reach it</source>
        <translation>调节参考时钟的写命令没有到达参考时钟</translation>
    </message>
    <message>
        <source>There is a device that is not in the configuration: {subject}{because}.</source>
        <translation>有不在配置中的设备：{subject}{because}。</translation>
    </message>
    <message>
        <source>There is no Sync Unit "{unit}"; the unnamed one is used.</source>
        <translation>没有同步单元“{unit}”；使用未命名的同步单元。</translation>
    </message>
    <message>
        <source>There is no deviation to watch</source>
        <translation>没有可监视的偏差</translation>
    </message>
    <message>
        <source>There is no network adapter or link "{subject}"{because}.</source>
        <translation>没有网卡或链路“{subject}”{because}。</translation>
    </message>
    <message>
        <source>There is no setting "{subject}"{because}.</source>
        <translation>没有设置“{subject}”{because}。</translation>
    </message>
    <message>
        <source>There is no slave at position {position}.</source>
        <translation>位置 {position} 没有从站。</translation>
    </message>
    <message>
        <source>There is no such adapter or link</source>
        <translation>没有这样的网卡或链路</translation>
    </message>
    <message>
        <source>There is no such setting</source>
        <translation>没有这样的设置</translation>
    </message>
    <message>
        <source>There is not enough memory.</source>
        <translation>内存不足。</translation>
    </message>
    <message>
        <source>There is nothing to compare: EC-Master leaves the monitoring out</source>
        <translation>没有可比较的对象：EC-Master 不启用监视</translation>
    </message>
    <message>
        <source>A slave went down unasked</source>
        <translation>从站未经请求进入更低状态</translation>
    </message>
    <message>
        <source>{subject}: the receive time of its port {port} contradicts all others and is left out</source>
        <translation>{subject}：其端口 {port} 的接收时间与所有其他时间矛盾，不予采用</translation>
    </message>
    <message>
        <source>{subject}: the delay to it and to those behind it cannot be measured, because the slave at which their branch parts has no receive times; {delay} is taken, which is wrong by the cables of both branches (some 100 ns)</source>
        <translation>{subject}：无法测量到它及其后从站的延迟，因为其分支所在的从站没有接收时间；取 {delay}，误差为两条分支的电缆（约几百 ns）</translation>
    </message>
    <message>
        <source>{subject}: {from} -&gt; {to} without an error, and not asked by this master</source>
        <translation>{subject}：{from} -&gt; {to}，没有错误，也不是此主站请求的</translation>
    </message>
    <message>
        <source>The bus was running already</source>
        <translation>总线已经在运行</translation>
    </message>
    <message>
        <source>slaves are in SAFEOP or OP already: another master operates this bus, or it was left so; they are taken to INIT</source>
        <translation>从站已处于 SAFEOP 或 OP：另一个主站正在运行此总线，或总线被遗留在该状态；它们将被带到 INIT</translation>
    </message>
    <message>
        <source>A slave went down without being asked</source>
        <translation>从站未被请求就进入了更低状态</translation>
    </message>
    <message>
        <source>Look for another master on this bus, a second program or a second cable; or for a slave that begins anew by itself. What clocks and drives did since then is not this master's doing.</source>
        <translation>请查找此总线上的另一个主站、第二个程序或第二根电缆；或自行重启的从站。此后时钟和驱动器的行为并非此主站所为。</translation>
    </message>
    <message>
        <source>{slave} went from {from} to {to} at {since}, without an error, and this master had not asked it.</source>
        <translation>{slave} 在 {since} 从 {from} 变为 {to}，没有错误，也未被此主站请求。</translation>
    </message>
    <message>
        <source>A slave had left OP with an error</source>
        <translation>一个从站曾因错误离开 OP</translation>
    </message>
    <message>
        <source>{slave} had fallen to {state} with AL status code {alcode}{alarm} at {since} ({count} in all), and was led up again.</source>
        <translation>{slave} 曾在 {since} 以 AL 状态码 {alcode}{alarm} 跌落到 {state}（共 {count}），后又被带回。</translation>
    </message>
    <message>
        <source>{slave} had fallen to {state} with AL status code {alcode}{alarm} at {since} ({count} in all), before it answered no more.</source>
        <translation>{slave} 在不再应答之前，曾在 {since} 以 AL 状态码 {alcode}{alarm} 跌落到 {state}（共 {count}）。</translation>
    </message>
    <message>
        <source>A slave's firmware stands still</source>
        <translation>从站固件停止运行</translation>
    </message>
    <message>
        <source>Its outputs and inputs stand still. Look for what stops it: an interrupt storm, a debugger, a crash; its power has to be switched off and on.</source>
        <translation>其输出和输入均已停止。查找使其停止的原因：中断风暴、调试器或崩溃；必须断电后重新上电。</translation>
    </message>
    <message>
        <source>The firmware of {slave} is silent since {since}: its PDI watchdog expired {count} (0x0443).</source>
        <translation>{slave} 的固件自 {since} 起无响应：其 PDI 看门狗超时 {count}（0x0443）。</translation>
    </message>
    <message>
        <source>Nothing tells where. Look at the cables and plugs, and at the network card and its driver.</source>
        <translation>无法得知丢失位置。请检查电缆和插头，以及网卡及其驱动。</translation>
    </message>
    <message>
        <source>Frames are lost in front of a slave</source>
        <translation>帧在某个从站之前丢失</translation>
    </message>
    <message>
        <source>Look at the cables and plugs between the host and it, and at the network card and its driver.</source>
        <translation>请检查主机与它之间的电缆和插头，以及网卡及其驱动。</translation>
    </message>
    <message>
        <source>{count:# frame|# frames} did not come back (up to {most} close together, first at {since}), and {slave}, the first that counts, missed its outputs with them: they had not got to it. No slave counted an error at its ports.</source>
        <translation>{count:# 帧|# 帧}未返回（最多 {most} 帧紧邻，首次在 {since}），而第一个进行计数的 {slave} 也因此缺失了输出：这些帧没有到达它。没有从站在其端口上计到错误。</translation>
    </message>
    <message>
        <source>The working counter is never the expected one</source>
        <translation>工作计数器从未等于预期值</translation>
    </message>
    <message>
        <source>The configuration expects what this bus does not give: correct Cnt of the cyclic command, or export it anew for these slaves. A slave without LRW (0x0008 bit 9) needs LRD and LWR instead. Inputs are not taken meanwhile.</source>
        <translation>配置所期望的值是此总线给不出的：请更正循环命令的 Cnt，或针对这些从站重新导出。不支持 LRW 的从站（0x0008 位 9）需要改用 LRD 和 LWR。在此期间不采用输入。</translation>
    </message>
    <message>
        <source>{count:# cycle|# cycles} had a wrong working counter, all from {since} on ({received} instead of {expected}), although each slave answers and none has fallen.</source>
        <translation>{count:# 个周期|# 个周期}的工作计数器错误，自 {since} 起全部如此（{received} 而非 {expected}），尽管每个从站都有应答且无一跌落。</translation>
    </message>
    <message>
        <source>A propagation delay could not be measured</source>
        <translation>某个传播延迟无法测量</translation>
    </message>
    <message>
        <source>Its receive times (0x0900 to 0x090C) and those of the slave before it contradict each other: one of the two does not latch them as it should. Until that is mended these clocks cannot be compared, whatever 0x092C says.</source>
        <translation>它的接收时间（0x0900 至 0x090C）与前一个从站的相互矛盾：两者之一没有按应有方式锁存。在修复之前，无论 0x092C 显示什么，这些时钟都无法比较。</translation>
    </message>
    <message>
        <source>{slave}: the way to it from the slave before it comes out as {delay}, which cannot be. 0 is taken (0x0928), and its clock and those behind it are off by what the way really takes; no reading shows it.</source>
        <translation>{slave}：从前一个从站到它的路径测得 {delay}，这不可能。取 0（0x0928），它及其后的时钟会偏差该路径的真实时间；任何读数都不会显示。</translation>
    </message>
    <message>
        <source>They are part of the assignment and never exchanged</source>
        <translation>它们属于分配的一部分，但从未交换</translation>
    </message>
    <message>
        <source>Time-out back to INIT</source>
        <translation>返回 INIT 的超时时间</translation>
    </message>
    <message>
        <source>Time-out back to SAFEOP</source>
        <translation>返回 SAFEOP 的超时时间</translation>
    </message>
    <message>
        <source>Time-out to PREOP</source>
        <translation>到 PREOP 的超时时间</translation>
    </message>
    <message>
        <source>Time-out to SAFEOP and OP</source>
        <translation>到 SAFEOP 和 OP 的超时时间</translation>
    </message>
    <message>
        <source>TwinCAT gives several names to the state bits of its frames and slaves; other masters do not fill them</source>
        <translation>TwinCAT 为其帧和从站的状态位起了多个名称；其他主站不填写它们</translation>
    </message>
    <message>
        <source>TwinCAT takes the cycle from its own task; EC-Master and others use a default</source>
        <translation>TwinCAT 采用自身任务的周期；EC-Master 等主站使用默认值</translation>
    </message>
    <message>
        <source>TwinCAT writes the variables of its own diagnosis so; other masters have nothing there</source>
        <translation>TwinCAT 这样书写自身诊断的变量；其他主站在那里没有内容</translation>
    </message>
    <message>
        <source>Two FMMUs give the same input bits</source>
        <translation>两个 FMMU 提供相同的输入位</translation>
    </message>
    <message>
        <source>Two FMMUs take the same output bits</source>
        <translation>两个 FMMU 取用相同的输出位</translation>
    </message>
    <message>
        <source>Two SyncManagers share memory</source>
        <translation>两个同步管理器共用存储区</translation>
    </message>
    <message>
        <source>Two commands carry the same process data</source>
        <translation>两个命令承载相同的过程数据</translation>
    </message>
    <message>
        <source>Two commands share bytes of the image</source>
        <translation>两个命令占用过程映像中相同的字节</translation>
    </message>
    <message>
        <source>Two hot-connect groups have the same identification</source>
        <translation>两个热连接组的识别方式相同</translation>
    </message>
    <message>
        <source>Two mailboxes share a status bit</source>
        <translation>两个邮箱共用一个状态位</translation>
    </message>
    <message>
        <source>Two modules bring PDO {pdo}; the ESI's SlotPdoIncrement does not part them.</source>
        <translation>两个模块都带有 PDO {pdo}；ESI 的 SlotPdoIncrement 没有将它们区分开。</translation>
    </message>
    <message>
        <source>Two modules bring the same PDO</source>
        <translation>两个模块带有相同的 PDO</translation>
    </message>
    <message>
        <source>Two slaves hang on one port</source>
        <translation>两个从站接在同一个端口上</translation>
    </message>
    <message>
        <source>Two slaves have changed places</source>
        <translation>两个从站互换了位置</translation>
    </message>
    <message>
        <source>Two slaves have the same alias</source>
        <translation>两个从站的别名相同</translation>
    </message>
    <message>
        <source>Two slaves have the same device ID</source>
        <translation>两个从站的设备标识相同</translation>
    </message>
    <message>
        <source>Two slaves have the same name</source>
        <translation>两个从站的名称相同</translation>
    </message>
    <message>
        <source>Two slaves have the same station address</source>
        <translation>两个从站的站地址相同</translation>
    </message>
    <message>
        <source>Two slaves share bits of the image</source>
        <translation>两个从站占用过程映像中相同的位</translation>
    </message>
    <message>
        <source>Two variables have the same name</source>
        <translation>两个变量的名称相同</translation>
    </message>
    <message>
        <source>Two variables share bits</source>
        <translation>两个变量占用相同的位</translation>
    </message>
    <message>
        <source>Use 0x0700 to activate both</source>
        <translation>使用 0x0700 激活两者</translation>
    </message>
    <message>
        <source>Use 0x26 for requests (SM0) and 0x22 for answers (SM1)</source>
        <translation>请求 (SM0) 使用 0x26，响应 (SM1) 使用 0x22</translation>
    </message>
    <message>
        <source>Use 4 or 8 bytes for 0x0910, 4 for 0x092C</source>
        <translation>0x0910 使用 4 或 8 字节，0x092C 使用 4 字节</translation>
    </message>
    <message>
        <source>Use ARMW with the auto-increment address of the reference clock</source>
        <translation>使用带参考时钟自动递增地址的 ARMW</translation>
    </message>
    <message>
        <source>Use a longer bus cycle or a larger sync multiplier, or let its fieldbus carry less.</source>
        <translation>使用更长的总线周期或更大的同步倍数，或让其现场总线传输更少的数据。</translation>
    </message>
    <message>
        <source>Use a multiple</source>
        <translation>使用整数倍</translation>
    </message>
    <message>
        <source>Use a multiple or a whole fraction of the cycle</source>
        <translation>使用周期的整数倍或整数分之一</translation>
    </message>
    <message>
        <source>Use a shift within the cycle</source>
        <translation>使用小于周期的偏移</translation>
    </message>
    <message>
        <source>Use start and length of the ESI (16 to 1486 bytes in data memory)</source>
        <translation>使用 ESI 的起始地址和长度（数据存储区中 16 到 1486 字节）</translation>
    </message>
    <message>
        <source>Use the time-outs of the ESI (3000 ms to PREOP, 10000 ms to SAFEOP and OP, 200 ms back to SAFEOP)</source>
        <translation>使用 ESI 的超时时间（到 PREOP 3000 ms，到 SAFEOP 和 OP 10000 ms，回到 SAFEOP 200 ms）</translation>
    </message>
    <message>
        <source>Variables lie behind the image</source>
        <translation>变量位于过程映像末尾之后</translation>
    </message>
    <message>
        <source>Variables lie in other bytes than the process image says</source>
        <translation>变量所在的字节与过程映像声明的不同</translation>
    </message>
    <message>
        <source>Variables of the diagnosis share bits</source>
        <translation>诊断变量占用相同的位</translation>
    </message>
    <message>
        <source>Variables of the inputs</source>
        <translation>输入变量</translation>
    </message>
    <message>
        <source>Watch the counter in 0x1C32, or set a limit in 0x10F1:02</source>
        <translation>监视 0x1C32 中的计数器，或在 0x10F1:02 中设置限值</translation>
    </message>
    <message>
        <source>What is compared is another word, or nothing</source>
        <translation>所比较的是另一个字，或什么也没有比较</translation>
    </message>
    <message>
        <source>When all tasks are due in one cycle their frames take {wire} of {cycle} of wire time.</source>
        <translation>所有任务在同一周期到期时，它们的帧的线上时间占用 {cycle} 中的 {wire}。</translation>
    </message>
    <message>
        <source>Without SYNC0 the gateway knows its bus cycle from 0x1C32:02 only, which no start-up command writes: it starts a CAN cycle with each frame.</source>
        <translation>没有 SYNC0 时，网关只能从 0x1C32:02 得知其总线周期，而没有启动命令写入它：它会随每一帧启动一个 CAN 周期。</translation>
    </message>
    <message>
        <source>Without a value to compare, the master cannot know which group has been plugged in</source>
        <translation>没有可比较的值，主站无法知道插入的是哪一组</translation>
    </message>
    <message>
        <source>Working counters are wrong</source>
        <translation>工作计数器错误</translation>
    </message>
    <message>
        <source>Working counters are wrong for a known reason</source>
        <translation>工作计数器因已知原因错误</translation>
    </message>
    <message>
        <source>Write 0 to 0x0500 first</source>
        <translation>先向 0x0500 写 0</translation>
    </message>
    <message>
        <source>Write 0 to sub-index 0, then the entries, then their count</source>
        <translation>先向子索引 0 写 0，再写条目，最后写条目计数</translation>
    </message>
    <message>
        <source>Write 0, 65535, 65534 and so on in the order of the slaves</source>
        <translation>按从站顺序依次写 0、65535、65534，依此类推</translation>
    </message>
    <message>
        <source>Write 0, the master's own time, or at least 20 ms</source>
        <translation>写 0（主站自身的时间）或至少 20 ms</translation>
    </message>
    <message>
        <source>Write 0x09A0 and 0x0990 before 0x0980</source>
        <translation>在 0x0980 之前写 0x09A0 和 0x0990</translation>
    </message>
    <message>
        <source>Write 1 to 0x0500 before the request</source>
        <translation>在请求之前向 0x0500 写 1</translation>
    </message>
    <message>
        <source>Write 2 to 0x1C32:01 and 0x1C33:01, or switch SYNC0 off</source>
        <translation>向 0x1C32:01 和 0x1C33:01 写 2，或关闭 SYNC0</translation>
    </message>
    <message>
        <source>Write Ccs 1</source>
        <translation>将 Ccs 写为 1</translation>
    </message>
    <message>
        <source>Write a value of the type named</source>
        <translation>写入所述类型的值</translation>
    </message>
    <message>
        <source>Write a value within the range</source>
        <translation>写入范围内的值</translation>
    </message>
    <message>
        <source>Write as many bytes as the object has</source>
        <translation>写入的字节数与对象一致</translation>
    </message>
    <message>
        <source>Write it as the schema does; numbers from 0x80000000 on as negative ones</source>
        <translation>按模式 (schema) 的规定书写；0x80000000 及以上的数写成负数</translation>
    </message>
    <message>
        <source>Write one to its EEPROM (page EEPROM, or synclinectl sii alias) and set it here, or set the device ID of its switches (check.device_id).</source>
        <translation>向其 EEPROM 写入别名 （“EEPROM”页面，或 synclinectl sii alias）并在此设置，或设置其拨码开关的设备标识 (check.device_id)。</translation>
    </message>
    <message>
        <source>Write outputs and read inputs: correct type or physical address</source>
        <translation>写输出、读输入：更正类型或物理地址</translation>
    </message>
    <message>
        <source>Write the EEPROM of the device's ESI again.</source>
        <translation>用该设备的 ESI 重新写入 EEPROM。</translation>
    </message>
    <message>
        <source>Write the PDOs of the SyncManager's list to 0x1C1n, in its order</source>
        <translation>将同步管理器列表中的 PDO 按其顺序写入 0x1C1n</translation>
    </message>
    <message>
        <source>Write the bus cycle to 0x1C32:02 on PS</source>
        <translation>在 PS 上将总线周期写入 0x1C32:02</translation>
    </message>
    <message>
        <source>Write the cycle time to 0x09A0 on PS</source>
        <translation>在 PS 上将周期时间写入 0x09A0</translation>
    </message>
    <message>
        <source>Write the entries of the PDO, in its order, or correct the PDO</source>
        <translation>按 PDO 的顺序写入其条目，或更正 PDO</translation>
    </message>
    <message>
        <source>Writing the one changes the other</source>
        <translation>写其中一个会改变另一个</translation>
    </message>
    <message>
        <source>a buffer for inputs</source>
        <translation>输入缓冲区</translation>
    </message>
    <message>
        <source>a buffer for outputs</source>
        <translation>输出缓冲区</translation>
    </message>
    <message>
        <source>a decimal number from -2147483648 to 2147483647</source>
        <translation>-2147483648 到 2147483647 的十进制数</translation>
    </message>
    <message>
        <source>a decimal number from 0 to 255</source>
        <translation>0 到 255 的十进制数</translation>
    </message>
    <message>
        <source>a decimal number from 0 to 65535</source>
        <translation>0 到 65535 的十进制数</translation>
    </message>
    <message>
        <source>a decimal number of 32 bits, negative from 2147483648 on</source>
        <translation>32 位十进制数，从 2147483648 起写成负数</translation>
    </message>
    <message>
        <source>a decimal number, or a hexadecimal one as #x1a00</source>
        <translation>十进制数，或形如 #x1a00 的十六进制数</translation>
    </message>
    <message>
        <source>a frame was sent later than the set value allows</source>
        <translation>某一帧的发送晚于设定值允许的时间</translation>
    </message>
    <message>
        <source>a mailbox</source>
        <translation>邮箱</translation>
    </message>
    <message>
        <source>a mailbox for answers</source>
        <translation>响应邮箱</translation>
    </message>
    <message>
        <source>a mailbox for requests</source>
        <translation>请求邮箱</translation>
    </message>
    <message>
        <source>a running machine is touched: {running:# slave is|# slaves are} beyond INIT. States and station addresses stay; {eeproms:# EEPROM is taken from its PDI while it is|# EEPROMs are taken from their PDIs while they are} read, and the DC receive times are latched</source>
        <translation>正在访问运行中的机器：{running} 个从站已超出 INIT。状态和站地址保持不变；读取期间 {eeproms} 个 EEPROM 将从其 PDI 收回，并锁存 DC 接收时间</translation>
    </message>
    <message>
        <source>a transition on which SoE is allowed: PS, SO, SP, OP or OS</source>
        <translation>允许使用 SoE 的状态切换：PS、SO、SP、OP 或 OS</translation>
    </message>
    <message>
        <source>a transition such as IP or PS</source>
        <translation>状态切换，例如 IP 或 PS</translation>
    </message>
    <message>
        <source>access denied; is the password right?</source>
        <translation>访问被拒绝；密码是否正确？</translation>
    </message>
    <message>
        <source>access to the object not supported</source>
        <translation>不支持对该对象的访问</translation>
    </message>
    <message>
        <source>activation (0x0980)</source>
        <translation>激活 (0x0980)</translation>
    </message>
    <message>
        <source>active</source>
        <translation>已激活</translation>
    </message>
    <message>
        <source>active for neither reading nor writing</source>
        <translation>读和写均未激活</translation>
    </message>
    <message>
        <source>added</source>
        <translation>新增</translation>
    </message>
    <message>
        <source>additional</source>
        <translation>多余</translation>
    </message>
    <message>
        <source>address, length and control byte of SM0 and SM1 and that both are enabled</source>
        <translation>SM0 和 SM1 的地址、长度和控制字节，以及两者是否已启用</translation>
    </message>
    <message>
        <source>alias</source>
        <translation>别名</translation>
    </message>
    <message>
        <source>alias {alias} identifies the group of {slave}, too</source>
        <translation>别名 {alias} 也用于识别{slave} 的组</translation>
    </message>
    <message>
        <source>an init command writes {activation} to 0x0980, and there is no DC element</source>
        <translation>初始化命令向 0x0980 写入 {activation}，但没有 DC 元素</translation>
    </message>
    <message>
        <source>answers</source>
        <translation>响应</translation>
    </message>
    <message>
        <source>application controller available</source>
        <translation>应用控制器可用</translation>
    </message>
    <message>
        <source>attribute {element} is "{value}" instead of {wanted}</source>
        <translation>属性 {element} 的值为“{value}”，应为：{wanted}</translation>
    </message>
    <message>
        <source>attribute {element} of &lt;{parent}&gt;</source>
        <translation>&lt;{parent}&gt; 的属性 {element}</translation>
    </message>
    <message>
        <source>attribute {element} of &lt;{parent}&gt;, {count:# time|# times}</source>
        <translation>&lt;{parent}&gt; 的属性 {element}，共 {count} 次</translation>
    </message>
    <message>
        <source>auto-increment address</source>
        <translation>自动递增地址</translation>
    </message>
    <message>
        <source>background watchdog</source>
        <translation>后台看门狗</translation>
    </message>
    <message>
        <source>before slave</source>
        <translation>在从站之前</translation>
    </message>
    <message>
        <source>bit of variable "{variable}"</source>
        <translation>变量“{variable}”的位</translation>
    </message>
    <message>
        <source>bits of variable "{variable}"</source>
        <translation>变量“{variable}”的位</translation>
    </message>
    <message>
        <source>block checksum wrong</source>
        <translation>块校验和错误</translation>
    </message>
    <message>
        <source>block sequence number invalid</source>
        <translation>块序号无效</translation>
    </message>
    <message>
        <source>block size invalid</source>
        <translation>块大小无效</translation>
    </message>
    <message>
        <source>bootstrap mailbox for answers</source>
        <translation>用于响应的 BOOT 邮箱</translation>
    </message>
    <message>
        <source>bootstrap mailbox for requests</source>
        <translation>用于请求的 BOOT 邮箱</translation>
    </message>
    <message>
        <source>bootstrap not supported</source>
        <translation>不支持 BOOT 状态</translation>
    </message>
    <message>
        <source>bytes of two hexadecimal digits each</source>
        <translation>若干字节，每个字节为两位十六进制数</translation>
    </message>
    <message>
        <source>cable between {subject} port {port} and {far}: NOTHING COMES BACK (pulled, broken, or no power behind it)</source>
        <translation>{subject} 端口 {port} 与 {far} 之间的电缆：没有任何返回（被拔出、断线或其后没有供电）</translation>
    </message>
    <message>
        <source>cable between {subject} port {port} and {far}: healed</source>
        <translation>{subject} 端口 {port} 与 {far} 之间的电缆：已恢复</translation>
    </message>
    <message>
        <source>check time-out</source>
        <translation>检查超时时间</translation>
    </message>
    <message>
        <source>command specifier invalid or unknown</source>
        <translation>命令说明符无效或未知</translation>
    </message>
    <message>
        <source>commands come in another order</source>
        <translation>命令的顺序不同</translation>
    </message>
    <message>
        <source>comparison</source>
        <translation>比较</translation>
    </message>
    <message>
        <source>complete access not supported</source>
        <translation>不支持 Complete Access</translation>
    </message>
    <message>
        <source>configured modules differ from the detected ones</source>
        <translation>配置的模块与检测到的模块不同</translation>
    </message>
    <message>
        <source>content and wiring of the EEPROM</source>
        <translation>EEPROM 的内容和接线</translation>
    </message>
    <message>
        <source>cycle time</source>
        <translation>周期时间</translation>
    </message>
    <message>
        <source>cycle time too small (older slaves: invalid input FMMU)</source>
        <translation>周期时间过小（较旧的从站：输入 FMMU 无效）</translation>
    </message>
    <message>
        <source>cycles were left out, the host came too late</source>
        <translation>漏掉了周期，主机来得过晚</translation>
    </message>
    <message>
        <source>cyclic frames and the device's inputs before OP is requested</source>
        <translation>请求 OP 之前的循环帧和设备输入</translation>
    </message>
    <message>
        <source>cyclic tasks</source>
        <translation>循环任务</translation>
    </message>
    <message>
        <source>data</source>
        <translation>数据</translation>
    </message>
    <message>
        <source>data cannot be transferred or stored</source>
        <translation>数据无法传输或存储</translation>
    </message>
    <message>
        <source>data link layer of the mailbox</source>
        <translation>邮箱的数据链路层</translation>
    </message>
    <message>
        <source>data too long</source>
        <translation>数据过长</translation>
    </message>
    <message>
        <source>data too short</source>
        <translation>数据过短</translation>
    </message>
    <message>
        <source>data type of variable "{variable}"</source>
        <translation>变量“{variable}”的数据类型</translation>
    </message>
    <message>
        <source>data type or length does not match</source>
        <translation>数据类型或长度不匹配</translation>
    </message>
    <message>
        <source>dcx follows an external clock, but no slave maps both time stamps of the external synchronisation (0x10F4:11 and :12) into its inputs.</source>
        <translation>dcx 跟随外部时钟，但没有从站将外部同步的两个时间戳（0x10F4:11 和 :12）映射到其输入中。</translation>
    </message>
    <message>
        <source>destination address</source>
        <translation>目标地址</translation>
    </message>
    <message>
        <source>detected modules differ from the configured ones</source>
        <translation>检测到的模块与配置的不同</translation>
    </message>
    <message>
        <source>device</source>
        <translation>设备</translation>
    </message>
    <message>
        <source>device identification value updated</source>
        <translation>设备标识值已更新</translation>
    </message>
    <message>
        <source>distributed clocks</source>
        <translation>分布式时钟</translation>
    </message>
    <message>
        <source>distributed clocks initialised: {slaves:# slave|# slaves}, no reference clock</source>
        <translation>分布式时钟已初始化：{slaves} 个从站，没有参考时钟</translation>
    </message>
    <message>
        <source>distributed clocks initialised: {slaves:# slave|# slaves}, reference clock is {clock}</source>
        <translation>分布式时钟已初始化：{slaves} 个从站，参考时钟为 {clock}</translation>
    </message>
    <message>
        <source>drives</source>
        <translation>驱动器</translation>
    </message>
    <message>
        <source>error</source>
        <translation>错误</translation>
    </message>
    <message>
        <source>expected bytes</source>
        <translation>期望的字节</translation>
    </message>
    <message>
        <source>expected mask</source>
        <translation>期望的掩码</translation>
    </message>
    <message>
        <source>external hardware not ready</source>
        <translation>外部硬件未就绪</translation>
    </message>
    <message>
        <source>fatal sync error</source>
        <translation>严重同步错误</translation>
    </message>
    <message>
        <source>file not found</source>
        <translation>未找到文件</translation>
    </message>
    <message>
        <source>firmware update not successful</source>
        <translation>固件更新未成功</translation>
    </message>
    <message>
        <source>for inputs</source>
        <translation>用于输入的</translation>
    </message>
    <message>
        <source>for outputs</source>
        <translation>用于输出的</translation>
    </message>
    <message>
        <source>frame or cycle</source>
        <translation>frame 或 cycle</translation>
    </message>
    <message>
        <source>frames came behind the SYNC0 they were meant for</source>
        <translation>帧晚于它们所对应的 SYNC0 到达</translation>
    </message>
    <message>
        <source>the master was not locked to the reference clock, and frames slid through its SYNC0</source>
        <translation>主站未锁定到参考时钟，帧滑过了它的 SYNC0</translation>
    </message>
    <message>
        <source>frames were lost</source>
        <translation>帧丢失</translation>
    </message>
    <message>
        <source>free run needs three buffer mode</source>
        <translation>自由运行需要三缓冲模式</translation>
    </message>
    <message>
        <source>free run not supported</source>
        <translation>不支持自由运行</translation>
    </message>
    <message>
        <source>gateways</source>
        <translation>网关</translation>
    </message>
    <message>
        <source>terminals</source>
        <translation>端子模块</translation>
    </message>
    <message>
        <source>general error</source>
        <translation>一般错误</translation>
    </message>
    <message>
        <source>go to INIT first</source>
        <translation>先进入 INIT</translation>
    </message>
    <message>
        <source>go to PREOP first</source>
        <translation>先进入 PREOP</translation>
    </message>
    <message>
        <source>go to SAFEOP first</source>
        <translation>先进入 SAFEOP</translation>
    </message>
    <message>
        <source>group "{group}" has no IdentifyCmd that compares what it reads</source>
        <translation>组“{group}”没有对读取值进行比较的 IdentifyCmd</translation>
    </message>
    <message>
        <source>group "{group}" has {members:# member|# members}, but only {left:# slave is|# slaves are} left from here</source>
        <translation>组“{group}”有 {members} 个成员，但从此处起只剩 {left} 个从站</translation>
    </message>
    <message>
        <source>group "{group}" has {members:# member|# members}, but {slave} begins a group of its own</source>
        <translation>组“{group}”有 {members} 个成员，但{slave} 开始了它自己的组</translation>
    </message>
    <message>
        <source>hangs on</source>
        <translation>连接于</translation>
    </message>
    <message>
        <source>hardware error</source>
        <translation>硬件错误</translation>
    </message>
    <message>
        <source>hot-connect group</source>
        <translation>热连接组</translation>
    </message>
    <message>
        <source>identification</source>
        <translation>识别标识</translation>
    </message>
    <message>
        <source>identification of the hot-connect group</source>
        <translation>热连接组的识别标识</translation>
    </message>
    <message>
        <source>illegal operation</source>
        <translation>非法操作</translation>
    </message>
    <message>
        <source>incompatible inside the device</source>
        <translation>设备内部不兼容</translation>
    </message>
    <message>
        <source>inconsistent settings</source>
        <translation>设置不一致</translation>
    </message>
    <message>
        <source>info</source>
        <translation>提示</translation>
    </message>
    <message>
        <source>init command</source>
        <translation>初始化命令</translation>
    </message>
    <message>
        <source>init command {command}: {field}</source>
        <translation>初始化命令 {command}：{field}</translation>
    </message>
    <message>
        <source>init commands</source>
        <translation>初始化命令</translation>
    </message>
    <message>
        <source>init commands of a transition come in another order</source>
        <translation>某一转换的初始化命令顺序不同</translation>
    </message>
    <message>
        <source>inputs</source>
        <translation>输入</translation>
    </message>
    <message>
        <source>inputs are not those of SYNC0</source>
        <translation>输入不是 SYNC0 时刻的输入</translation>
    </message>
    <message>
        <source>inputs of {command} in the image</source>
        <translation>{command} 的输入在映像中的位置</translation>
    </message>
    <message>
        <source>inputs of {slaves:# slave|# slaves} begin elsewhere in the image</source>
        <translation>{slaves} 个从站的输入在映像中的起始位置不同</translation>
    </message>
    <message>
        <source>invalid DC SYNC configuration</source>
        <translation>DC SYNC 配置无效</translation>
    </message>
    <message>
        <source>invalid DC latch configuration</source>
        <translation>DC 锁存配置无效</translation>
    </message>
    <message>
        <source>invalid SYNC cycle time</source>
        <translation>SYNC 周期时间无效</translation>
    </message>
    <message>
        <source>invalid SYNC0 cycle time</source>
        <translation>SYNC0 周期时间无效</translation>
    </message>
    <message>
        <source>invalid SYNC1 cycle time</source>
        <translation>SYNC1 周期时间无效</translation>
    </message>
    <message>
        <source>invalid SyncManager configuration</source>
        <translation>同步管理器配置无效</translation>
    </message>
    <message>
        <source>invalid SyncManager types</source>
        <translation>同步管理器类型无效</translation>
    </message>
    <message>
        <source>invalid device setup</source>
        <translation>设备设置无效</translation>
    </message>
    <message>
        <source>invalid input configuration</source>
        <translation>输入配置无效</translation>
    </message>
    <message>
        <source>invalid input mapping</source>
        <translation>输入映射无效</translation>
    </message>
    <message>
        <source>invalid mailbox configuration in BOOT</source>
        <translation>BOOT 中的邮箱配置无效</translation>
    </message>
    <message>
        <source>invalid mailbox configuration in PREOP</source>
        <translation>PREOP 中的邮箱配置无效</translation>
    </message>
    <message>
        <source>invalid output configuration</source>
        <translation>输出配置无效</translation>
    </message>
    <message>
        <source>invalid output mapping</source>
        <translation>输出映射无效</translation>
    </message>
    <message>
        <source>invalid requested state change</source>
        <translation>请求的状态切换无效</translation>
    </message>
    <message>
        <source>invalid revision</source>
        <translation>版本无效</translation>
    </message>
    <message>
        <source>invalid watchdog configuration</source>
        <translation>看门狗配置无效</translation>
    </message>
    <message>
        <source>it compares data of the EEPROM for which no valid command asks</source>
        <translation>它比较 EEPROM 的数据，但没有有效的命令请求这些数据</translation>
    </message>
    <message>
        <source>it expects the {field} in word {word} of the EEPROM, which stands in word {own}</source>
        <translation>它在 EEPROM 的字 {word} 中期望 {field}，而该值位于字 {own}</translation>
    </message>
    <message>
        <source>it hangs on {slave}, which does not stand before it</source>
        <translation>它接在{slave} 上，而后者不在它之前</translation>
    </message>
    <message>
        <source>it hangs on {slave}, which stands behind it</source>
        <translation>它接在{slave} 上，而后者在它之后</translation>
    </message>
    <message>
        <source>it has no InitCmds</source>
        <translation>它没有 InitCmds</translation>
    </message>
    <message>
        <source>it has {bytes:# byte|# bytes}, {most} fit</source>
        <translation>它有 {bytes} 字节，最多可容纳 {most} 字节</translation>
    </message>
    <message>
        <source>it reads the EEPROM, which does not belong to the master (0x0500 = 0) yet</source>
        <translation>它读取 EEPROM，但 EEPROM 尚不属于主站 (0x0500 = 0)</translation>
    </message>
    <message>
        <source>it sets {written}, PhysAddr is {address}</source>
        <translation>它设置 {written}，而 PhysAddr 为 {address}</translation>
    </message>
    <message>
        <source>it stands before the reference clock, {reference}</source>
        <translation>它位于参考时钟（{reference}）之前</translation>
    </message>
    <message>
        <source>its cycle of {cycle} is no multiple of the first task's {first}</source>
        <translation>其周期 {cycle} 不是第一个任务周期 {first} 的整数倍</translation>
    </message>
    <message>
        <source>its datagrams take {bytes:# byte|# bytes}, {most} fit</source>
        <translation>其数据报占用 {bytes} 字节，最多可容纳 {most} 字节</translation>
    </message>
    <message>
        <source>its {data} share bytes of the image with {command}</source>
        <translation>其{data}与 {command} 占用过程映像中相同的字节</translation>
    </message>
    <message>
        <source>its {data} take bytes {first} to {last}, the image has {image}</source>
        <translation>其{data}占用第 {first} 到 {last} 字节，过程映像只有 {image} 字节</translation>
    </message>
    <message>
        <source>jitter and drift of the reference clock; wait until DC has settled before OP</source>
        <translation>参考时钟的抖动和漂移；到 OP 之前请等待 DC 稳定</translation>
    </message>
    <message>
        <source>late or missing frames around SYNC0: host jitter, the shift, and that the master is locked to DC</source>
        <translation>SYNC0 前后是否有延迟或丢失的帧：主机抖动、偏移，以及主站是否锁定到 DC</translation>
    </message>
    <message>
        <source>length and control byte of SM2 and SM3 against the assigned PDOs</source>
        <translation>SM2 和 SM3 的长度和控制字节与已分配的 PDO 是否一致</translation>
    </message>
    <message>
        <source>licence error</source>
        <translation>许可证错误</translation>
    </message>
    <message>
        <source>logical address of the mailbox state bits</source>
        <translation>邮箱状态位的逻辑地址</translation>
    </message>
    <message>
        <source>logical bit of {fmmu} of {slave}, against its data in the image</source>
        <translation>{slave} 的 {fmmu} 的逻辑位，相对于其数据在映像中的位置</translation>
    </message>
    <message>
        <source>mailbox</source>
        <translation>邮箱</translation>
    </message>
    <message>
        <source>mailbox AoE error</source>
        <translation>邮箱 AoE 错误</translation>
    </message>
    <message>
        <source>mailbox CoE error</source>
        <translation>邮箱 CoE 错误</translation>
    </message>
    <message>
        <source>mailbox EoE error</source>
        <translation>邮箱 EoE 错误</translation>
    </message>
    <message>
        <source>mailbox FoE error</source>
        <translation>邮箱 FoE 错误</translation>
    </message>
    <message>
        <source>mailbox SoE error</source>
        <translation>邮箱 SoE 错误</translation>
    </message>
    <message>
        <source>mailbox VoE error</source>
        <translation>邮箱 VoE 错误</translation>
    </message>
    <message>
        <source>mailbox for answers</source>
        <translation>用于响应的邮箱</translation>
    </message>
    <message>
        <source>mailbox for requests</source>
        <translation>用于请求的邮箱</translation>
    </message>
    <message>
        <source>mailbox poll time</source>
        <translation>邮箱轮询时间</translation>
    </message>
    <message>
        <source>mailbox protocols</source>
        <translation>邮箱协议</translation>
    </message>
    <message>
        <source>mailbox state bit</source>
        <translation>邮箱状态位</translation>
    </message>
    <message>
        <source>mailbox state bits</source>
        <translation>邮箱状态位</translation>
    </message>
    <message>
        <source>mailbox states of {slaves:# slave|# slaves} have other bits</source>
        <translation>{slaves} 个从站的邮箱状态使用其他位</translation>
    </message>
    <message>
        <source>mapped objects exceed the PDO length</source>
        <translation>映射的对象超出 PDO 长度</translation>
    </message>
    <message>
        <source>master</source>
        <translation>主站</translation>
    </message>
    <message>
        <source>master OUT OF SYNC, error {error}{because}</source>
        <translation>主站未同步，误差 {error}{because}</translation>
    </message>
    <message>
        <source>master in sync, error {error}</source>
        <translation>主站已同步，误差 {error}</translation>
    </message>
    <message>
        <source>master{command} {field}</source>
        <translation>主站{command} {field}</translation>
    </message>
    <message>
        <source>maximum is below the minimum</source>
        <translation>最大值小于最小值</translation>
    </message>
    <message>
        <source>missing</source>
        <translation>缺少</translation>
    </message>
    <message>
        <source>modules and options of the device</source>
        <translation>设备的模块和选件</translation>
    </message>
    <message>
        <source>name of the variable at bit {bit}</source>
        <translation>第 {bit} 位处变量的名称</translation>
    </message>
    <message>
        <source>network adapter {adapter} is DOWN, gone or without carrier: waiting for it</source>
        <translation>网卡 {adapter} 已断开、不存在或没有载波：正在等待</translation>
    </message>
    <message>
        <source>network adapter {adapter} is up again after {away}</source>
        <translation>网卡 {adapter} 在 {away} 后恢复</translation>
    </message>
    <message>
        <source>no NOP to 0x0900 stands before {command}</source>
        <translation>{command} 之前没有写 0x0900 的 NOP</translation>
    </message>
    <message>
        <source>no Protocol is named</source>
        <translation>未声明 Protocol</translation>
    </message>
    <message>
        <source>no SyncManager</source>
        <translation>没有同步管理器</translation>
    </message>
    <message>
        <source>no command of the master on IP clears the {registers}</source>
        <translation>主站在 IP 上没有命令清除以下寄存器：{registers}</translation>
    </message>
    <message>
        <source>no command on IP reads 0x0508 before the next request</source>
        <translation>IP 上没有命令在下一个请求之前读取 0x0508</translation>
    </message>
    <message>
        <source>no command on {transition} waits for {state} behind this request</source>
        <translation>{transition} 上没有命令在该请求之后等待 {state}</translation>
    </message>
    <message>
        <source>no cyclic BRD reads 0x0130</source>
        <translation>没有循环 BRD 读取 0x0130</translation>
    </message>
    <message>
        <source>no data available</source>
        <translation>没有可用数据</translation>
    </message>
    <message>
        <source>no error</source>
        <translation>无错误</translation>
    </message>
    <message>
        <source>no init command compares vendor or product with the EEPROM</source>
        <translation>没有初始化命令将供应商或产品代码与 EEPROM 比较</translation>
    </message>
    <message>
        <source>no init command on IP enables SM{manager} for {element}</source>
        <translation>IP 上没有初始化命令为 {element} 启用 SM{manager}</translation>
    </message>
    <message>
        <source>no init command on SP or SI switches SYNC0 off again</source>
        <translation>SP 或 SI 上没有初始化命令重新关闭 SYNC0</translation>
    </message>
    <message>
        <source>no init command on {transition} requests {state}</source>
        <translation>{transition} 上没有初始化命令请求 {state}</translation>
    </message>
    <message>
        <source>no limit</source>
        <translation>无</translation>
    </message>
    <message>
        <source>no memory</source>
        <translation>内存不足</translation>
    </message>
    <message>
        <source>no object dictionary</source>
        <translation>没有对象字典</translation>
    </message>
    <message>
        <source>no reference clock leads</source>
        <translation>没有主导的参考时钟</translation>
    </message>
    <message>
        <source>no rights for this file</source>
        <translation>没有该文件的权限</translation>
    </message>
    <message>
        <source>no room left in the device</source>
        <translation>设备中没有剩余空间</translation>
    </message>
    <message>
        <source>no slave has the station address {address}</source>
        <translation>没有从站的站地址为 {address}</translation>
    </message>
    <message>
        <source>no sync signal</source>
        <translation>无同步信号</translation>
    </message>
    <message>
        <source>no user</source>
        <translation>没有用户</translation>
    </message>
    <message>
        <source>no valid firmware</source>
        <translation>没有有效的固件</translation>
    </message>
    <message>
        <source>no valid inputs and outputs</source>
        <translation>没有有效的输入和输出</translation>
    </message>
    <message>
        <source>no valid inputs available</source>
        <translation>没有可用的有效输入</translation>
    </message>
    <message>
        <source>no valid outputs</source>
        <translation>没有有效的输出</translation>
    </message>
    <message>
        <source>none</source>
        <translation>无</translation>
    </message>
    <message>
        <source>not defined</source>
        <translation>未定义</translation>
    </message>
    <message>
        <source>not in BOOT state</source>
        <translation>不在 BOOT 状态</translation>
    </message>
    <message>
        <source>not possible in the present device state, try it in PREOP</source>
        <translation>在设备当前状态下不可行，请在 PREOP 中尝试</translation>
    </message>
    <message>
        <source>not possible under local control</source>
        <translation>在本地控制下不可行</translation>
    </message>
    <message>
        <source>not seen by the master; look at its firmware and at frames that are damaged in front of it</source>
        <translation>主站没有发现原因；检查其固件，以及在它之前损坏的帧</translation>
    </message>
    <message>
        <source>nothing</source>
        <translation>无</translation>
    </message>
    <message>
        <source>object cannot be mapped to a PDO</source>
        <translation>对象不能映射到 PDO</translation>
    </message>
    <message>
        <source>object does not exist</source>
        <translation>对象不存在</translation>
    </message>
    <message>
        <source>object is mapped to a PDO, download blocked</source>
        <translation>对象已映射到 PDO，禁止下载</translation>
    </message>
    <message>
        <source>object larger than the mailbox</source>
        <translation>对象大于邮箱</translation>
    </message>
    <message>
        <source>offline</source>
        <translation>离线</translation>
    </message>
    <message>
        <source>on {transition} it comes behind the request for {state}</source>
        <translation>在 {transition} 上它位于请求 {state} 之后</translation>
    </message>
    <message>
        <source>on {transition} it requests {requested} instead of {wanted}</source>
        <translation>在 {transition} 上它请求 {requested}，应为 {wanted}</translation>
    </message>
    <message>
        <source>on {transition} it waits for {awaited}, requested is {requested}</source>
        <translation>在 {transition} 上它等待 {awaited}，而请求的是 {requested}</translation>
    </message>
    <message>
        <source>on {transition} it waits for {state} with the error bit (0x10) set</source>
        <translation>在 {transition} 上它等待错误位 (0x10) 置位的 {state}</translation>
    </message>
    <message>
        <source>one of the slaves</source>
        <translation>其中一个从站</translation>
    </message>
    <message>
        <source>online: the master runs the configuration</source>
        <translation>在线：主站正在运行该配置</translation>
    </message>
    <message>
        <source>only Sigma-X drives take it</source>
        <translation>只有 Sigma-X 驱动器接受它</translation>
    </message>
    <message>
        <source>only in BOOT state</source>
        <translation>仅在 BOOT 状态下可用</translation>
    </message>
    <message>
        <source>only the current loop is synchronised then, the position loop is not</source>
        <translation>那样只有电流环同步，位置环不同步</translation>
    </message>
    <message>
        <source>order and types of the SyncManagers against 0x1C00</source>
        <translation>同步管理器的顺序和类型与 0x1C00 是否一致</translation>
    </message>
    <message>
        <source>out of memory</source>
        <translation>内存不足</translation>
    </message>
    <message>
        <source>outputs</source>
        <translation>输出</translation>
    </message>
    <message>
        <source>outputs count from their arrival</source>
        <translation>输出在到达时即生效</translation>
    </message>
    <message>
        <source>outputs of {command} in the image</source>
        <translation>{command} 的输出在映像中的位置</translation>
    </message>
    <message>
        <source>outputs of {slaves:# slave|# slaves} begin elsewhere in the image</source>
        <translation>{slaves} 个从站的输出在映像中的起始位置不同</translation>
    </message>
    <message>
        <source>own cycle</source>
        <translation>独立周期</translation>
    </message>
    <message>
        <source>own frame</source>
        <translation>独立帧</translation>
    </message>
    <message>
        <source>parameters incompatible</source>
        <translation>参数不兼容</translation>
    </message>
    <message>
        <source>place</source>
        <translation>位置</translation>
    </message>
    <message>
        <source>port {port} of {slave} carries another slave already</source>
        <translation>{slave} 的端口 {port} 已接有另一个从站</translation>
    </message>
    <message>
        <source>possible reference clock</source>
        <translation>可能的参考时钟</translation>
    </message>
    <message>
        <source>power the slave off and on</source>
        <translation>将从站断电再上电</translation>
    </message>
    <message>
        <source>propagation delays measured again: 1 slave to correct, by {largest}</source>
        <translation>已重新测量传输延迟：需校正 1 个从站，校正量 {largest}</translation>
    </message>
    <message>
        <source>propagation delays measured again: nothing to correct</source>
        <translation>已重新测量传输延迟：无需校正</translation>
    </message>
    <message>
        <source>propagation delays measured again: {slaves:# slave|# slaves} to correct, by {largest} at most</source>
        <translation>已重新测量传输延迟：需校正 {slaves} 个从站，最大校正量 {largest}</translation>
    </message>
    <message>
        <source>reading a write-only object</source>
        <translation>读取只写对象</translation>
    </message>
    <message>
        <source>reads</source>
        <translation>读取</translation>
    </message>
    <message>
        <source>real time: {what}</source>
        <translation>实时：{what}</translation>
    </message>
    <message>
        <source>reference clock</source>
        <translation>参考时钟</translation>
    </message>
    <message>
        <source>reference clock {subject}: LOST</source>
        <translation>参考时钟 {subject}：已丢失</translation>
    </message>
    <message>
        <source>reference clock {subject}: has no system time (0x0910 does not answer), the next clock leads in its place</source>
        <translation>参考时钟 {subject}：没有系统时间（0x0910 无响应），由下一个时钟代替</translation>
    </message>
    <message>
        <source>reference clock {subject}: present</source>
        <translation>参考时钟 {subject}：存在</translation>
    </message>
    <message>
        <source>reference clock {subject}: took over</source>
        <translation>参考时钟 {subject}：已接管</translation>
    </message>
    <message>
        <source>removed</source>
        <translation>已移除</translation>
    </message>
    <message>
        <source>requests</source>
        <translation>请求</translation>
    </message>
    <message>
        <source>resource not available</source>
        <translation>资源不可用</translation>
    </message>
    <message>
        <source>retries</source>
        <translation>重试次数</translation>
    </message>
    <message>
        <source>revision</source>
        <translation>版本号</translation>
    </message>
    <message>
        <source>serial number</source>
        <translation>序列号</translation>
    </message>
    <message>
        <source>settling behind an interruption</source>
        <translation>中断之后正在稳定</translation>
    </message>
    <message>
        <source>The reference clock is not at the external clock</source>
        <translation>参考时钟未对准外部时钟</translation>
    </message>
    <message>
        <source>Wait until it is there; where it never comes there, look at the network behind the bridge device.</source>
        <translation>等待其对准；若始终无法对准，请检查桥接设备另一侧的网络。</translation>
    </message>
    <message>
        <source>The reference clock is {external} away from the external clock. To go there takes some {left}.</source>
        <translation>参考时钟与外部时钟相差 {external}。对准约需 {left}。</translation>
    </message>
    <message>
        <source>The external clock was elsewhere for a while</source>
        <translation>外部时钟曾一度偏离</translation>
    </message>
    <message>
        <source>Look at the network behind the bridge device: its reference clock has stepped, or another one leads there now; or this computer's clock was slewed.</source>
        <translation>检查桥接设备另一侧的网络：其参考时钟发生了跳变，或那里现在由另一个时钟主导；或本机时钟被调快或调慢。</translation>
    </message>
    <message>
        <source>The external clock was not where the reference clock is {count}, first at {since}, and up to {external} away; the reference clock has found it again.</source>
        <translation>外部时钟 {count}不在参考时钟的位置，首次在 {since}，最多相差 {external}；参考时钟已重新对准。</translation>
    </message>
    <message>
        <source>the reference clock is on its way to the external clock</source>
        <translation>参考时钟正在趋近外部时钟</translation>
    </message>
    <message>
        <source>the external clock is not where the reference clock is</source>
        <translation>外部时钟不在参考时钟的位置</translation>
    </message>
    <message>
        <source>size of the inputs</source>
        <translation>输入的大小</translation>
    </message>
    <message>
        <source>size of the outputs</source>
        <translation>输出的大小</translation>
    </message>
    <message>
        <source>slave needs INIT</source>
        <translation>从站需要 INIT</translation>
    </message>
    <message>
        <source>slave needs PREOP</source>
        <translation>从站需要 PREOP</translation>
    </message>
    <message>
        <source>slave needs SAFEOP</source>
        <translation>从站需要 SAFEOP</translation>
    </message>
    <message>
        <source>slave needs cold start</source>
        <translation>从站需要冷启动</translation>
    </message>
    <message>
        <source>slave restarted locally</source>
        <translation>从站已自行重新启动</translation>
    </message>
    <message>
        <source>slaves OUT OF SYNC, deviation {deviation}</source>
        <translation>从站未同步，偏差 {deviation}</translation>
    </message>
    <message>
        <source>slaves OUT OF SYNC, deviation {deviation} at {subject}</source>
        <translation>从站未同步，{subject} 的偏差为 {deviation}</translation>
    </message>
    <message>
        <source>slaves OUT OF SYNC, deviation {deviation} at {subject} ({slaves:# slave is|# slaves are} over the limit)</source>
        <translation>从站未同步，{subject} 的偏差为 {deviation}（{slaves} 个从站超出限值）</translation>
    </message>
    <message>
        <source>slaves OUT OF SYNC, deviation {deviation}: {slaves:the one that follows, at once|all # at once} and to the same side, the reference clock has stepped or changed its rate</source>
        <translation>从站未同步，偏差 {deviation}：全部 {slaves} 个同时朝同一方向偏离，参考时钟发生了跳变或改变了速率</translation>
    </message>
    <message>
        <source>slaves in sync, deviation {deviation}</source>
        <translation>从站已同步，偏差 {deviation}</translation>
    </message>
    <message>
        <source>slaves not monitored</source>
        <translation>从站未被监视</translation>
    </message>
    <message>
        <source>slaves: not known whether in sync, nobody leads them</source>
        <translation>从站：是否同步未知，没有时钟为其提供参考</translation>
    </message>
    <message>
        <source>slaves: not known whether in sync, nothing was read for {age}</source>
        <translation>从站：是否同步未知，已有 {age} 未读取到任何数据</translation>
    </message>
    <message>
        <source>source address</source>
        <translation>源地址</translation>
    </message>
    <message>
        <source>split into frames</source>
        <translation>拆分为帧</translation>
    </message>
    <message>
        <source>start time 0x0990 (must lie ahead), cycle 0x09A0, activation 0x0981</source>
        <translation>起始时间 0x0990（必须在未来）、周期 0x09A0、激活 0x0981</translation>
    </message>
    <message>
        <source>start-up command {command}</source>
        <translation>启动命令 {command}</translation>
    </message>
    <message>
        <source>start-up commands come in another order</source>
        <translation>启动命令的顺序不同</translation>
    </message>
    <message>
        <source>station address</source>
        <translation>站地址</translation>
    </message>
    <message>
        <source>station address {address} belongs to {slave}, too</source>
        <translation>站地址 {address} 也属于{slave}</translation>
    </message>
    <message>
        <source>station addresses (0x0010)</source>
        <translation>站地址 (0x0010)</translation>
    </message>
    <message>
        <source>status bit {bit} belongs to {slave}, too</source>
        <translation>状态位 {bit} 也属于{slave}</translation>
    </message>
    <message>
        <source>status bit {bit} is mapped by no FMMU on IP</source>
        <translation>IP 上没有 FMMU 映射状态位 {bit}</translation>
    </message>
    <message>
        <source>status bit {bit} is not read by a cyclic command in PREOP</source>
        <translation>PREOP 中没有循环命令读取状态位 {bit}</translation>
    </message>
    <message>
        <source>status bit {bit}, and MailboxStates counts {counted}</source>
        <translation>状态位为 {bit}，而 MailboxStates 计数为 {counted}</translation>
    </message>
    <message>
        <source>subindex cannot be written, subindex 0 must be 0 first</source>
        <translation>子索引不可写，必须先将子索引 0 设为 0</translation>
    </message>
    <message>
        <source>subindex does not exist</source>
        <translation>子索引不存在</translation>
    </message>
    <message>
        <source>supply and attached hardware of the device</source>
        <translation>设备的供电和所连接的硬件</translation>
    </message>
    <message>
        <source>supply voltage too high</source>
        <translation>供电电压过高</translation>
    </message>
    <message>
        <source>supply voltage too low</source>
        <translation>供电电压过低</translation>
    </message>
    <message>
        <source>synchronization error</source>
        <translation>同步错误</translation>
    </message>
    <message>
        <source>synchronization not supported</source>
        <translation>不支持同步</translation>
    </message>
    <message>
        <source>task {task}: commands come in another order</source>
        <translation>任务 {task}：命令的顺序不同</translation>
    </message>
    <message>
        <source>task {task}: cycle time</source>
        <translation>任务 {task}：周期时间</translation>
    </message>
    <message>
        <source>task {task}: split into frames</source>
        <translation>任务 {task}：拆分为帧</translation>
    </message>
    <message>
        <source>task {task}: {command}</source>
        <translation>任务 {task}：{command}</translation>
    </message>
    <message>
        <source>temperature too high</source>
        <translation>温度过高</translation>
    </message>
    <message>
        <source>temperature too low</source>
        <translation>温度过低</translation>
    </message>
    <message>
        <source>text</source>
        <translation>文本</translation>
    </message>
    <message>
        <source>that DC is on or SM synchronous mode is chosen (0x1C32:01)</source>
        <translation>DC 是否已启用，或是否选择了 SM 同步模式 (0x1C32:01)</translation>
    </message>
    <message>
        <source>that SYNC pulses and frames come in time</source>
        <translation>SYNC 脉冲和帧是否按时到达</translation>
    </message>
    <message>
        <source>that cyclic frames run with the right working counter before OP is requested</source>
        <translation>请求 OP 之前循环帧是否以正确的工作计数器运行</translation>
    </message>
    <message>
        <source>that operation mode, PDOs and DC settings fit together</source>
        <translation>操作模式、PDO 和 DC 设置是否相互匹配</translation>
    </message>
    <message>
        <source>that the EEPROM is given to the PDI before PREOP (0x0500)</source>
        <translation>进入 PREOP 之前是否已将 EEPROM 交给 PDI (0x0500)</translation>
    </message>
    <message>
        <source>that the PDOs in 0x1C12 add up to the length of SM2</source>
        <translation>0x1C12 中的 PDO 之和是否等于 SM2 的长度</translation>
    </message>
    <message>
        <source>that the PDOs in 0x1C13 add up to the length of SM3</source>
        <translation>0x1C13 中的 PDO 之和是否等于 SM3 的长度</translation>
    </message>
    <message>
        <source>that the cycle is a multiple the device supports (e.g. 125 or 250 us)</source>
        <translation>周期是否为设备支持的倍数（例如 125 或 250 µs）</translation>
    </message>
    <message>
        <source>the CoE start-up commands</source>
        <translation>CoE 启动命令</translation>
    </message>
    <message>
        <source>the PDOs of SM{manager} have {bytes:# byte|# bytes}, it takes {least} to {most}</source>
        <translation>SM{manager} 的 PDO 为 {bytes} 字节，而它可容纳 {least} 到 {most} 字节</translation>
    </message>
    <message>
        <source>the SYNC0 cycle of {sync0} and the task's cycle of {cycle} are no multiples of each other</source>
        <translation>SYNC0 周期 {sync0} 与任务周期 {cycle} 互不为整数倍</translation>
    </message>
    <message>
        <source>the SoE start-up commands</source>
        <translation>SoE 启动命令</translation>
    </message>
    <message>
        <source>the ambient temperature</source>
        <translation>环境温度</translation>
    </message>
    <message>
        <source>the bring-up begins again from INIT: no slave could be reached in the middle of it</source>
        <translation>启动过程从 INIT 重新开始：启动途中无法访问任何从站</translation>
    </message>
    <message>
        <source>the change of state may take {timeout} ms</source>
        <translation>状态切换最多允许 {timeout} ms</translation>
    </message>
    <message>
        <source>the control byte {control} does not make SM{manager} a mailbox for {use}</source>
        <translation>控制字节 {control} 没有使 SM{manager} 成为{use}邮箱</translation>
    </message>
    <message>
        <source>the control byte {control} of SM{manager} makes it {kind}, its Type says {type}</source>
        <translation>SM{manager} 的控制字节 {control} 使其成为{kind}，而其 Type 为 {type}</translation>
    </message>
    <message>
        <source>the control bytes of SM2 and SM3</source>
        <translation>SM2 和 SM3 的控制字节</translation>
    </message>
    <message>
        <source>the controller reports an error</source>
        <translation>控制器报告错误</translation>
    </message>
    <message>
        <source>the device's AoE service</source>
        <translation>设备的 AoE 服务</translation>
    </message>
    <message>
        <source>the device's EoE settings (IP address)</source>
        <translation>设备的 EoE 设置（IP 地址）</translation>
    </message>
    <message>
        <source>the device's program failed</source>
        <translation>设备的程序失败</translation>
    </message>
    <message>
        <source>the file exists already</source>
        <translation>文件已存在</translation>
    </message>
    <message>
        <source>the file transfer</source>
        <translation>文件传输</translation>
    </message>
    <message>
        <source>the firmware file, then repeat the update</source>
        <translation>固件文件，然后重新更新</translation>
    </message>
    <message>
        <source>the firmware; load it in BOOT</source>
        <translation>固件；请在 BOOT 中加载</translation>
    </message>
    <message>
        <source>frames were held up on their way</source>
        <translation>帧在途中被延误</translation>
    </message>
    <message>
        <source>the host left cycles out</source>
        <translation>主机漏掉了周期</translation>
    </message>
    <message>
        <source>the identification value, then restart the slave</source>
        <translation>标识值，然后重新启动从站</translation>
    </message>
    <message>
        <source>the load of the slave's processor; a longer cycle helps</source>
        <translation>从站处理器的负载；更长的周期会有帮助</translation>
    </message>
    <message>
        <source>the reference clock has stepped</source>
        <translation>参考时钟发生跳变</translation>
    </message>
    <message>
        <source>the reference clock is addressed by its station address (FRMW)</source>
        <translation>参考时钟按站地址寻址 (FRMW)</translation>
    </message>
    <message>
        <source>the reference clock's time does not come</source>
        <translation>参考时钟的时间没有到来</translation>
    </message>
    <message>
        <source>the root element is {element}</source>
        <translation>根元素为 {element}</translation>
    </message>
    <message>
        <source>the schedule is not within its limit</source>
        <translation>调度误差超出限值</translation>
    </message>
    <message>
        <source>the smallest cycle in 0x1C32:05</source>
        <translation>0x1C32:05 中的最小周期</translation>
    </message>
    <message>
        <source>the station address is 0</source>
        <translation>站地址为 0</translation>
    </message>
    <message>
        <source>the supply</source>
        <translation>供电</translation>
    </message>
    <message>
        <source>the value written to AL control 0x0120</source>
        <translation>写入 AL 控制 0x0120 的值</translation>
    </message>
    <message>
        <source>the vendor protocol</source>
        <translation>供应商协议</translation>
    </message>
    <message>
        <source>the vendor's diagnosis, object 0x10F3 and the device's display</source>
        <translation>供应商诊断、对象 0x10F3 和设备的显示</translation>
    </message>
    <message>
        <source>the vendor's licence for this function</source>
        <translation>该功能的供应商许可证</translation>
    </message>
    <message>
        <source>the vendor's manual</source>
        <translation>供应商手册</translation>
    </message>
    <message>
        <source>there are {protocol} start-up commands, and no Protocol says {protocol}</source>
        <translation>存在 {protocol} 启动命令，但没有 Protocol 声明 {protocol}</translation>
    </message>
    <message>
        <source>there is no CycleTime</source>
        <translation>没有 CycleTime</translation>
    </message>
    <message>
        <source>time-out</source>
        <translation>超时时间</translation>
    </message>
    <message>
        <source>time-out back to INIT</source>
        <translation>返回 INIT 的超时时间</translation>
    </message>
    <message>
        <source>time-out back to SAFEOP</source>
        <translation>返回 SAFEOP 的超时时间</translation>
    </message>
    <message>
        <source>time-out to PREOP</source>
        <translation>到 PREOP 的超时时间</translation>
    </message>
    <message>
        <source>time-out to SAFEOP and OP</source>
        <translation>到 SAFEOP 和 OP 的超时时间</translation>
    </message>
    <message>
        <source>toggle bit did not change</source>
        <translation>Toggle 位未翻转</translation>
    </message>
    <message>
        <source>two variables have the name "{variable}"</source>
        <translation>两个变量的名称均为“{variable}”</translation>
    </message>
    <message>
        <source>unknown</source>
        <translation>未知</translation>
    </message>
    <message>
        <source>unknown abort code</source>
        <translation>未知的中止代码</translation>
    </message>
    <message>
        <source>unknown code</source>
        <translation>未知代码</translation>
    </message>
    <message>
        <source>unknown device at position {position}: {identity}</source>
        <translation>位置 {position} 的未知设备：{identity}</translation>
    </message>
    <message>
        <source>unknown error of the device</source>
        <translation>设备的未知错误</translation>
    </message>
    <message>
        <source>unknown requested state</source>
        <translation>请求的状态未知</translation>
    </message>
    <message>
        <source>unspecified error</source>
        <translation>未指明的错误</translation>
    </message>
    <message>
        <source>up to 4 of the letters Y, K and B</source>
        <translation>Y、K、B 中最多 4 个字母</translation>
    </message>
    <message>
        <source>value out of range</source>
        <translation>值超出范围</translation>
    </message>
    <message>
        <source>value too high</source>
        <translation>值过大</translation>
    </message>
    <message>
        <source>value too low</source>
        <translation>值过小</translation>
    </message>
    <message>
        <source>variables of the inputs</source>
        <translation>输入变量</translation>
    </message>
    <message>
        <source>variables of the outputs</source>
        <translation>输出变量</translation>
    </message>
    <message>
        <source>vendor specific code</source>
        <translation>供应商特定代码</translation>
    </message>
    <message>
        <source>ventilation and ambient temperature</source>
        <translation>通风和环境温度</translation>
    </message>
    <message>
        <source>warning</source>
        <translation>警告</translation>
    </message>
    <message>
        <source>what the device needs for valid inputs (supply, encoder)</source>
        <translation>设备获得有效输入所需的条件（供电、编码器）</translation>
    </message>
    <message>
        <source>whether PDOs and SyncManager lengths exceed what the slave can hold</source>
        <translation>PDO 和同步管理器长度是否超出从站的容量</translation>
    </message>
    <message>
        <source>whether a state was skipped, e.g. INIT to SAFEOP</source>
        <translation>是否跳过了某个状态，例如从 INIT 到 SAFEOP</translation>
    </message>
    <message>
        <source>whether every object in the RxPDOs can be mapped</source>
        <translation>RxPDO 中的每个对象是否都可以映射</translation>
    </message>
    <message>
        <source>whether every object in the TxPDOs can be mapped</source>
        <translation>TxPDO 中的每个对象是否都可以映射</translation>
    </message>
    <message>
        <source>whether the EEPROM belongs to this firmware; rewrite one of them</source>
        <translation>EEPROM 是否属于该固件；重写其中之一</translation>
    </message>
    <message>
        <source>whether the ESI revision fits the device's hardware and firmware</source>
        <translation>ESI 版本是否与设备的硬件和固件相符</translation>
    </message>
    <message>
        <source>whether this device has a BOOT state</source>
        <translation>该设备是否有 BOOT 状态</translation>
    </message>
    <message>
        <source>who owns the latch units (AssignActivate bits 4 and 5)</source>
        <translation>锁存单元归谁所有（AssignActivate 第 4 位和第 5 位）</translation>
    </message>
    <message>
        <source>why SYNC0 or SYNC1 stopped; clear 0x0981 before a new start</source>
        <translation>SYNC0 或 SYNC1 为何停止；重新启动之前请清除 0x0981</translation>
    </message>
    <message>
        <source>why outputs stopped for longer than the watchdog 0x0420 (loop, working counter)</source>
        <translation>输出停止的时间为何超过看门狗 0x0420（回路、工作计数器）</translation>
    </message>
    <message>
        <source>why the device restarted (supply, watchdog, operator)</source>
        <translation>设备为何重新启动（供电、看门狗、操作人员）</translation>
    </message>
    <message>
        <source>working counter</source>
        <translation>工作计数器</translation>
    </message>
    <message>
        <source>working counter expected now {now} (all slaves: {configured})</source>
        <translation>当前期望的工作计数器 {now}（所有从站：{configured}）</translation>
    </message>
    <message>
        <source>working counter {received} instead of {expected}</source>
        <translation>工作计数器为 {received}，应为 {expected}</translation>
    </message>
    <message>
        <source>working counter {received} instead of {expected} ({count:# time|# times})</source>
        <translation>工作计数器为 {received}，应为 {expected}（{count} 次）</translation>
    </message>
    <message>
        <source>writes</source>
        <translation>写入</translation>
    </message>
    <message>
        <source>writing a read-only object</source>
        <translation>写入只读对象</translation>
    </message>
    <message>
        <source>wrong packet number</source>
        <translation>包编号错误</translation>
    </message>
    <message>
        <source>{activation} switches SYNC1 on without SYNC0</source>
        <translation>{activation} 启用了 SYNC1 但没有启用 SYNC0</translation>
    </message>
    <message>
        <source>{bits:# bit is|# bits are} copied from input bit {from} to output bit {to}, the image has {inputs} and {outputs}</source>
        <translation>{bits} 位从输入位 {from} 复制到输出位 {to}，过程映像只有 {inputs} 位和 {outputs} 位</translation>
    </message>
    <message>
        <source>{bytes:# byte exceeds|# bytes exceed} the {most} that SyncManager {manager} takes.</source>
        <translation>{bytes} 字节超出同步管理器 {manager} 可容纳的 {most} 字节。</translation>
    </message>
    <message>
        <source>{bytes:# byte of process data does|# bytes of process data do} not fit into one Ethernet frame.</source>
        <translation>{bytes} 字节的过程数据放不进一个以太网帧。</translation>
    </message>
    <message>
        <source>{command}</source>
        <translation>{command}</translation>
    </message>
    <message>
        <source>{command} addresses no slave of the file</source>
        <translation>{command} 寻址的从站不在文件中</translation>
    </message>
    <message>
        <source>{command} comes before the station address is set (0x0010)</source>
        <translation>{command} 位于设置站地址 (0x0010) 之前</translation>
    </message>
    <message>
        <source>{command} compares what it reads with a time-out of 0</source>
        <translation>{command} 比较读取的值，但超时时间为 0</translation>
    </message>
    <message>
        <source>{command} does not go to this slave (auto-increment address {address})</source>
        <translation>{command} 没有发往该从站（自动递增地址 {address}）</translation>
    </message>
    <message>
        <source>{command} does not go to this slave (station address {address})</source>
        <translation>{command} 没有发往该从站（站地址 {address}）</translation>
    </message>
    <message>
        <source>{command} goes to all slaves</source>
        <translation>{command} 发往所有从站</translation>
    </message>
    <message>
        <source>{command} goes to logical addresses, which are those of the process data</source>
        <translation>{command} 指向逻辑地址，即过程数据的地址</translation>
    </message>
    <message>
        <source>{command} has no Cnt; the FMMUs make it {computed}</source>
        <translation>{command} 没有 Cnt；按 FMMU 计算应为 {computed}</translation>
    </message>
    <message>
        <source>{command} has no bytes</source>
        <translation>{command} 没有任何字节</translation>
    </message>
    <message>
        <source>{command} has {bytes:# byte|# bytes} instead of 4</source>
        <translation>{command} 有 {bytes} 字节，应为 4 字节</translation>
    </message>
    <message>
        <source>{command} has {bytes:# byte|# bytes} instead of 4 or 8</source>
        <translation>{command} 有 {bytes} 字节，应为 4 或 8 字节</translation>
    </message>
    <message>
        <source>{command} is not sent in {state}</source>
        <translation>{command} 在 {state} 中没有发送</translation>
    </message>
    <message>
        <source>{command} reads nothing that Validate could be compared with</source>
        <translation>{command} 不读取可与 Validate 比较的任何内容</translation>
    </message>
    <message>
        <source>{command} stands before {distributor}</source>
        <translation>{command} 位于 {distributor} 之前</translation>
    </message>
    <message>
        <source>{command} steers a clock whose time nothing distributes</source>
        <translation>{command} 调节的时钟，其时间没有任何命令分发</translation>
    </message>
    <message>
        <source>{command} steers {slave}, {distributor} distributes the time of another</source>
        <translation>{command} 调节{slave}，而 {distributor} 分发的是另一个从站的时间</translation>
    </message>
    <message>
        <source>{command} takes the time of {slave}, and no slave is marked as reference clock</source>
        <translation>{command} 取用{slave} 的时间，但没有从站被标记为参考时钟</translation>
    </message>
    <message>
        <source>{command} takes the time of {slave}, the reference clock is {reference}</source>
        <translation>{command} 取用{slave} 的时间，而参考时钟是{reference}</translation>
    </message>
    <message>
        <source>{command}: a master can only read the register {register}</source>
        <translation>{command}：主站只能读取寄存器 {register}</translation>
    </message>
    <message>
        <source>{command}: no ESC has a register there</source>
        <translation>{command}：任何 ESC 在该处都没有寄存器</translation>
    </message>
    <message>
        <source>{copies:# slave-to-slave copy|# slave-to-slave copies} cannot be kept: a project has no place for that.</source>
        <translation>{copies} 个从站间的数据复制无法保留：项目中无处存放。</translation>
    </message>
    <message>
        <source>{count:# FMMU lies|# FMMUs lie} elsewhere</source>
        <translation>{count} 个 FMMU 的位置不同</translation>
    </message>
    <message>
        <source>{count:# command's inputs|# commands' inputs} lie elsewhere</source>
        <translation>{count} 个命令的输入位置不同</translation>
    </message>
    <message>
        <source>{count:# command's outputs|# commands' outputs} lie elsewhere</source>
        <translation>{count} 个命令的输出位置不同</translation>
    </message>
    <message>
        <source>{count:# cycle|# cycles} had a wrong working counter ({received} instead of {expected} last), from {since} on.</source>
        <translation>从 {since} 起，{count} 个周期的工作计数器错误（最近一次为 {received}，应为 {expected}）。</translation>
    </message>
    <message>
        <source>{count:# cycle|# cycles} had a wrong working counter, from {since} on: that is what the others see of {slave}.</source>
        <translation>从 {since} 起，{count} 个周期的工作计数器错误：这是其他从站所反映出的{slave} 的问题。</translation>
    </message>
    <message>
        <source>{count:# cycle|# cycles} left out, the host sent nothing for up to {standstill}</source>
        <translation>漏掉 {count} 个周期，主机最长 {standstill} 未发送任何数据</translation>
    </message>
    <message>
        <source>{count:# event was|# events were} lost</source>
        <translation>丢失了 {count} 个事件</translation>
    </message>
    <message>
        <source>{count:# frame|# frames} back late, up to {late} after the deadline</source>
        <translation>{count} 帧返回过晚，最多超过期限 {late}</translation>
    </message>
    <message>
        <source>{count:# frame|# frames} back late, up to {late} after the deadline ({told} of them told as lost before)</source>
        <translation>{count} 帧返回过晚，最多超过期限 {late}（其中 {told} 帧此前已报告为丢失）</translation>
    </message>
    <message>
        <source>{count:# frame|# frames} came back after the cycle, by up to {largest}.</source>
        <translation>{count} 帧在其周期结束后才返回，最多晚 {largest}。</translation>
    </message>
    <message>
        <source>{count:# frame|# frames} did not come back (up to {most} close together, first at {since}), and no slave counted an error at its ports.</source>
        <translation>{count} 帧没有返回（最多 {most} 帧接连丢失，首次在 {since}），且没有从站在其端口上计到错误。</translation>
    </message>
    <message>
        <source>{count:# frame|# frames} did not come back (up to {most} close together, first at {since}); damaged on the way, first at {slave} port {port}.</source>
        <translation>{count} 帧没有返回（最多 {most} 帧接连丢失，首次在 {since}）；它们在途中损坏，首次损坏于{slave} 端口 {port}。</translation>
    </message>
    <message>
        <source>{count:# frame|# frames} did not come back in time while the host stood still.</source>
        <translation>主机停顿期间有 {count} 帧没有按时返回。</translation>
    </message>
    <message>
        <source>{count:# frame|# frames} lost</source>
        <translation>丢失 {count} 帧</translation>
    </message>
    <message>
        <source>{count:# frame|# frames} reached {slave} damaged at port {port} (0x{register}), from {since} on; the cable comes from {behind}.</source>
        <translation>从 {since} 起，{count} 帧到达{slave} 端口 {port} 时已损坏 (0x{register})；该电缆来自{behind}。</translation>
    </message>
    <message>
        <source>{count:# frame was|# frames were} lost when {slave} went away or came back.</source>
        <translation>{slave} 离开或恢复时丢失了 {count} 帧。</translation>
    </message>
    <message>
        <source>{count:# frame was|# frames were} lost when {slave} lost its link.</source>
        <translation>{slave} 失去链路时丢失了 {count} 个帧。</translation>
    </message>
    <message>
        <source>Frames were lost at the end</source>
        <translation>结束时有帧丢失</translation>
    </message>
    <message>
        <source>Let it run on: the error counters of the slaves' ports say where they are lost.</source>
        <translation>让它继续运行：从站端口的错误计数器会说明帧在何处丢失。</translation>
    </message>
    <message>
        <source>{count:# frame|# frames} did not come back at the end (first at {since}), and not all slaves' error counters have been read since.</source>
        <translation>结束时有 {count} 个帧未返回（最早在 {since}），此后尚未读取所有从站的错误计数器。</translation>
    </message>
    <message>
        <source>{count:# variable has another data type|# variables have other data types}</source>
        <translation>{count} 个变量的数据类型不同</translation>
    </message>
    <message>
        <source>{count:# variable has another name|# variables have other names}</source>
        <translation>{count} 个变量的名称不同</translation>
    </message>
    <message>
        <source>{count:# variable of the inputs lies|# variables of the inputs lie} elsewhere</source>
        <translation>{count} 个输入变量的位置不同</translation>
    </message>
    <message>
        <source>{count:# variable of the outputs lies|# variables of the outputs lie} elsewhere</source>
        <translation>{count} 个输出变量的位置不同</translation>
    </message>
    <message>
        <source>{count:# variable|# variables}, "{variable}" among them, {count:lies|lie} behind the image</source>
        <translation>“{variable}”等 {count} 个变量位于过程映像末尾之后</translation>
    </message>
    <message>
        <source>{count:# variable|# variables}, "{variable}" among them, {count:shares|share} bits with others</source>
        <translation>“{variable}”等 {count} 个变量与其他变量占用相同的位</translation>
    </message>
    <message>
        <source>{element} has {bits:# bit|# bits}, the assigned PDOs have {expected}</source>
        <translation>{element} 有 {bits} 位，已分配的 PDO 为 {expected} 位</translation>
    </message>
    <message>
        <source>{element} has {bytes:# byte|# bytes} at {start}</source>
        <translation>{element} 位于 {start}，共 {bytes} 字节</translation>
    </message>
    <message>
        <source>{element} shares bits of the image with {slave}</source>
        <translation>{element} 与{slave} 占用过程映像中相同的位</translation>
    </message>
    <message>
        <source>{element} starts at bit {said}, the FMMUs and cyclic commands put the data at bit {computed}</source>
        <translation>{element} 从第 {said} 位开始，而 FMMU 和循环命令将数据放在第 {computed} 位</translation>
    </message>
    <message>
        <source>{element} takes {bits:# bit|# bits} from bit {first}, the image has {image}</source>
        <translation>{element} 从第 {first} 位起占用 {bits} 位，过程映像只有 {image} 位</translation>
    </message>
    <message>
        <source>{entries:# entry is|# entries are} mapped; the device's dictionary has room for {room} in {object}.</source>
        <translation>映射了 {entries} 个条目；设备的对象字典在 {object} 中只有 {room} 个位置。</translation>
    </message>
    <message>
        <source>{entries:# entry is|# entries are} mapped; the object {object} takes {most}.</source>
        <translation>映射了 {entries} 个条目；对象 {object} 最多容纳 {most} 个。</translation>
    </message>
    <message>
        <source>{error}</source>
        <translation>{error}</translation>
    </message>
    <message>
        <source>{reason}</source>
        <translation>{reason}</translation>
    </message>
    <message>
        <source>{field} is {said} in Info, the command expects the bytes {expected}</source>
        <translation>Info 中的 {field} 为 {said}，命令期望的字节为 {expected}</translation>
    </message>
    <message>
        <source>{file} is an ENI: its commands and the layout of its image stay as they are, only the spelling follows the dialect. "project create --eni" makes a project that can be laid out anew.</source>
        <translation>{file} 是 ENI：其命令和过程映像布局保持不变，只有书写形式遵循所选方言。使用“project create --eni”可生成能重新布局的项目。</translation>
    </message>
    <message>
        <source>{file}: what came after frame {frames} was not read, the file breaks off there ({reason}).</source>
        <translation>{file}：第 {frames} 帧之后的内容未被读取，文件在该处中断（{reason}）。</translation>
    </message>
    <message>
        <source>{file}: {cut} of its {frames:# frame|# frames} {cut:was|were} captured in part only and not read.</source>
        <translation>{file}：{frames} 帧中有 {cut} 帧只被部分捕获，未被读取。</translation>
    </message>
    <message>
        <source>{first} and {second} are both the reference clock</source>
        <translation>{first} 和{second} 都是参考时钟</translation>
    </message>
    <message>
        <source>{first} and {second} carry the same {data}</source>
        <translation>{first} 和 {second} 承载相同的{data}</translation>
    </message>
    <message>
        <source>{frames:# frame takes|# frames take} {wire} on the wire and about {travel} through {slaves:# slave|# slaves}, the cycle is {cycle}</source>
        <translation>{frames} 帧在线上需要 {wire}，经过 {slaves} 个从站约需 {travel}，周期为 {cycle}</translation>
    </message>
    <message>
        <source>{frames:# frame takes|# frames take} {wire} on the wire, the cycle is {cycle}</source>
        <translation>{frames} 帧在线上需要 {wire}，周期为 {cycle}</translation>
    </message>
    <message>
        <source>{mode} switches SYNC0 on, its cycle is {cycle}.</source>
        <translation>{mode} 启用 SYNC0，其周期为 {cycle}。</translation>
    </message>
    <message>
        <source>{mode} writes the reference clock in each cycle, but the cyclic frames have no command for it (APWR or FPWR of 0x0910); choose off, master-shift or master-shift-by-app.</source>
        <translation>{mode} 在每个周期写参考时钟，但循环帧中没有对应的命令（对 0x0910 的 APWR 或 FPWR）；请选择 off、master-shift 或 master-shift-by-app。</translation>
    </message>
    <message>
        <source>{name} has no distributed clock according to its ESI and cannot be the reference.</source>
        <translation>根据其 ESI，{name} 没有分布式时钟，不能作为参考时钟。</translation>
    </message>
    <message>
        <source>{name} stands before the reference clock: the frame passes it without the time. A run here tells it what the master believes, so it follows less exactly; other masters leave it off.</source>
        <translation>{name} 位于参考时钟之前：帧经过它时还没有时间。在此运行时，主站告诉它自己估计的时间，因此它跟随得不够精确；使用其他主站时它会一直有偏差。</translation>
    </message>
    <message>
        <source>{name}: a SYNC0 cycle of {sync0} is neither a multiple nor a divisor of the bus cycle of {cycle}.</source>
        <translation>{name}：SYNC0 周期 {sync0} 既不是总线周期 {cycle} 的整数倍，也不是其整数分之一。</translation>
    </message>
    <message>
        <source>{objects:# object is|# objects are} mapped in this direction, {family} {devices} take {most}. Unassign a PDO, or map fewer objects and exchange the slow ones by SDO.</source>
        <translation>该方向映射了 {objects} 个对象，{family} {devices}最多接受 {most} 个。请取消分配一个 PDO，或减少映射的对象，慢速对象改用 SDO 交换。</translation>
    </message>
    <message>
        <source>{object} has no Data</source>
        <translation>{object} 没有 Data</translation>
    </message>
    <message>
        <source>{object} has no sub-index {sub_index}</source>
        <translation>{object} 没有子索引 {sub_index}</translation>
    </message>
    <message>
        <source>{object} is set to {mode}, and SYNC0 is off. {reason}. Select an operation mode with DC, or a profile mode.</source>
        <translation>{object} 被设为 {mode}，但 SYNC0 未启用。{reason}。请选择带 DC 的操作模式或轮廓 (Profile) 模式。</translation>
    </message>
    <message>
        <source>{object} is set to {written}, SM{manager} lists {listed}</source>
        <translation>{object} 被设为 {written}，SM{manager} 的列表为 {listed}</translation>
    </message>
    <message>
        <source>{object} is set to {written}, the PDO lists {listed}</source>
        <translation>{object} 被设为 {written}，PDO 的列表为 {listed}</translation>
    </message>
    <message>
        <source>{object} is set to {written}, the cycle is {cycle}</source>
        <translation>{object} 被设为 {written}，周期为 {cycle}</translation>
    </message>
    <message>
        <source>{object} is written by complete access</source>
        <translation>{object} 用完全访问 (Complete Access) 写入</translation>
    </message>
    <message>
        <source>{object} is written on {transition}</source>
        <translation>{object} 在 {transition} 上写入</translation>
    </message>
    <message>
        <source>{object} may take {timeout} ms</source>
        <translation>{object} 最多允许 {timeout} ms</translation>
    </message>
    <message>
        <source>{object} must stay in PDO {pdo} (ESI Entry@Fixed).</source>
        <translation>{object} 必须保留在 PDO {pdo} 中 (ESI Entry@Fixed)。</translation>
    </message>
    <message>
        <source>{object}: Ccs is {ccs}</source>
        <translation>{object}：Ccs 为 {ccs}</translation>
    </message>
    <message>
        <source>{object}: the count is set to {count}, entries are written up to {last}</source>
        <translation>{object}：计数设为 {count}，条目写到 {last}</translation>
    </message>
    <message>
        <source>{object}: {entries:# entry is|# entries are} written, the count stays {count}</source>
        <translation>{object}：写入了 {entries} 个条目，计数仍为 {count}</translation>
    </message>
    <message>
        <source>{object}:01 asks for SYNC signals, and they are off. Select an operation mode with DC, or free run.</source>
        <translation>{object}:01 要求 SYNC 信号，但 SYNC 信号未启用。请选择带 DC 的操作模式或自由运行。</translation>
    </message>
    <message>
        <source>{object}:01 is read-only in {family} {devices}: the download ends the start-up. The SYNC signals set the type; remove the command.</source>
        <translation>{family} {devices}的 {object}:01 是只读的：该下载会中断启动。类型由 SYNC 信号决定；请删除该命令。</translation>
    </message>
    <message>
        <source>{object}:01 is set to {type}, which {family} {devices} do not have.</source>
        <translation>{object}:01 被设为 {type}，而 {family} {devices}没有该类型。</translation>
    </message>
    <message>
        <source>{object}:{sub_index} is written while the list is not emptied (:0 = 0)</source>
        <translation>{object}:{sub_index} 在列表清空 (:0 = 0) 之前写入</translation>
    </message>
    <message>
        <source>{object}:{sub_index} is written with {written:# byte|# bytes}, it has {bytes}</source>
        <translation>{object}:{sub_index} 写入 {written} 字节，其长度为 {bytes} 字节</translation>
    </message>
    <message>
        <source>{pdos:# PDO is|# PDOs are} assigned to SyncManager {manager}; its object takes {most}.</source>
        <translation>为同步管理器 {manager} 分配了 {pdos} 个 PDO；其对象最多容纳 {most} 个。</translation>
    </message>
    <message>
        <source>{reason}.</source>
        <translation>{reason}。</translation>
    </message>
    <message>
        <source>{set_value} is outside {least}..{most}: the cyclic frames are still on their way at SYNC0.</source>
        <translation>{set_value} 超出 {least}..{most}：SYNC0 到来时循环帧仍在途中。</translation>
    </message>
    <message>
        <source>{setting}</source>
        <translation>{setting}</translation>
    </message>
    <message>
        <source>{slaves:# slave uses|# slaves use} distributed clocks</source>
        <translation>{slaves} 个从站使用分布式时钟</translation>
    </message>
    <message>
        <source>{slaves:# slave uses|# slaves use} distributed clocks, and no cyclic command distributes the time</source>
        <translation>{slaves} 个从站使用分布式时钟，但没有循环命令分发时间</translation>
    </message>
    <message>
        <source>{slave} ({identity}) has no system time register 0x0910, where its ESI has operation modes: DC is off.</source>
        <translation>{slave} ({identity}) 没有系统时间寄存器 0x0910，而其 ESI 带有操作模式：DC 已关闭。</translation>
    </message>
    <message>
        <source>{slave} ({identity}): {match} ({file}).</source>
        <translation>{slave} ({identity})：{match} ({file})。</translation>
    </message>
    <message>
        <source>{slave} counts {missed:# missed SM2 event|# missed SM2 events} (0x1C32:{sub}), and for {part} of them the master saw good cycles.</source>
        <translation>{slave} 计到 {missed} 个错过的 SM2 事件 (0x1C32:{sub})，其中 {part} 个发生时主站看到的周期都正常。</translation>
    </message>
    <message>
        <source>{slave} did not finish {count:# cycle|# cycles} before the next frame came ({object} cycle exceeded), last at {last}: frames came less than a cycle one behind the other.</source>
        <translation>{slave} 有 {count} 个周期在下一帧到来前未完成（{object} cycle exceeded），最近一次在 {last}：帧到达的间隔小于一个周期。</translation>
    </message>
    <message>
        <source>{slave} does not renew its inputs in every cycle, as it did before: from {since} on, {count} (0x0805 + 8 n of its input SyncManager names the same buffer again).</source>
        <translation>{slave} 不再像以前那样每个周期更新输入：从 {since} 起，{count}（其输入同步管理器的 0x0805 + 8 n 再次指向同一个缓冲区）。</translation>
    </message>
    <message>
        <source>{slave} does not take its outputs in every cycle, as it did before: from {since} on, {count} (0x0220 names its output SyncManager when the next ones come).</source>
        <translation>{slave} 不再像以前那样每个周期取走输出：从 {since} 起，{count}（下一批输出到来时 0x0220 仍指示其输出同步管理器）。</translation>
    </message>
    <message>
        <source>{slave} fell to {state} with AL status code {alcode}{alarm} at {since}, and the master saw nothing but good cycles before: no frame lost or late, none left out, outputs nominally there {margin} before each SYNC0.</source>
        <translation>{slave} 在 {since} 以 AL 状态码 {alcode}{alarm} 掉到 {state}，而主站此前看到的周期都正常：没有丢帧或晚到的帧，没有漏掉周期，输出标称在每个 SYNC0 之前 {margin} 到达。</translation>
    </message>
    <message>
        <source>{slave} fell to {state} with AL status code {alcode}{alarm} at {since}: it missed {missed:# SM2 event|# SM2 events}, its error counter reached {integrator} of {limit}.</source>
        <translation>{slave} 在 {since} 以 AL 状态码 {alcode}{alarm} 掉到 {state}：它错过了 {missed} 个 SM2 事件，其错误计数器达到 {integrator}（限值：{limit}）。</translation>
    </message>
    <message>
        <source>{slave} fell to {state} with AL status code {alcode}{alarm} at {since}: it missed {missed:# SM2 event|# SM2 events}, {part} of them because frames came behind the SYNC0 they were meant for. Nominally they are there {margin} before it, but one in a thousand is {lateness} late.</source>
        <translation>{slave} 在 {since} 以 AL 状态码 {alcode}{alarm} 掉到 {state}：它错过了 {missed} 个 SM2 事件，其中 {part} 个是因为帧晚于其所对应的 SYNC0 到达。帧标称在 SYNC0 之前 {margin} 到达，但每一千帧中有一帧晚 {lateness}。</translation>
    </message>
    <message>
        <source>{slave} got its outputs too late for SYNC0 {count} (0x1C32:0D shift too short), because frames were held up on their way, by up to {largest}.</source>
        <translation>{slave} 的输出对 SYNC0 而言到达过晚（{count}，0x1C32:0D 偏移过短），因为帧在途中被延误，最多 {largest}。</translation>
    </message>
    <message>
        <source>{slave} got its outputs too late for SYNC0 {count} (0x1C32:0D shift too short), and used those of the cycle before: they come {margin} before SYNC0, and it needs {need}.</source>
        <translation>{slave} 的输出对 SYNC0 而言到达过晚（{count}，0x1C32:0D 偏移过短），因而使用了前一周期的输出：输出在 SYNC0 之前 {margin} 到达，而它需要 {need}。</translation>
    </message>
    <message>
        <source>{slave} had its inputs too late {count} (0x1C33:0D shift too short).</source>
        <translation>{slave} 的输入过晚（{count}，0x1C33:0D 偏移过短）。</translation>
    </message>
    <message>
        <source>{slave} has the alias {alias}, which {other} has as well.</source>
        <translation>{slave} 的别名为 {alias}，与{other} 相同。</translation>
    </message>
    <message>
        <source>{slave} has the device ID {id}, which {other} has as well.</source>
        <translation>{slave} 的设备标识为 {id}，与{other} 相同。</translation>
    </message>
    <message>
        <source>{slave} is in {state} with AL status code {alcode}{alarm}, since {since}.</source>
        <translation>从 {since} 起，{slave} 处于 {state}，AL 状态码为 {alcode}{alarm}。</translation>
    </message>
    <message>
        <source>{slave} is in {state} with AL status code {alcode}{alarm}, since {since}; just before: {why}.</source>
        <translation>{slave} 自 {since} 起处于 {state}，AL 状态码 {alcode}{alarm}；在此之前不久：{why}。</translation>
    </message>
    <message>
        <source>{slave} is in {state} with AL status code {alcode}{alarm}, since {since}: it had been cut off from the master, and its SYNC0 went on.</source>
        <translation>从 {since} 起，{slave} 处于 {state}，AL 状态码为 {alcode}{alarm}：它曾与主站断开，而其 SYNC0 仍在继续。</translation>
    </message>
    <message>
        <source>{slave} is in {state} with AL status code {alcode}{alarm}, since {since}; the master was not locked to the reference clock, and frames slid through its SYNC0.</source>
        <translation>从 {since} 起，{slave} 处于 {state}，AL 状态码为 {alcode}{alarm}；主站未锁定到参考时钟，帧滑过了它的 SYNC0。</translation>
    </message>
    <message>
        <source>{slave} left the sync window at {since} ({deviation}, limit {limit}) and came back; {count} in all.</source>
        <translation>{slave} 在 {since} 超出同步窗口（{deviation}，限值 {limit}），之后恢复；共 {count}。</translation>
    </message>
    <message>
        <source>{slave} left {count:# mailbox request|# mailbox requests} in a row without an answer.</source>
        <translation>{slave} 对连续 {count} 个邮箱请求没有响应。</translation>
    </message>
    <message>
        <source>{slave} lost its link at port {port} {count} (0x{register}), last at {last}.</source>
        <translation>{slave} 的端口 {port} 链路丢失 {count} (0x{register})，最近一次在 {last}。</translation>
    </message>
    <message>
        <source>{slave} missed {missed:# SM2 event|# SM2 events}, and the master was not locked to the reference clock all the time: frames slid through its SYNC0.</source>
        <translation>{slave} 错过了 {missed} 个 SM2 事件，且主站并非始终锁定到参考时钟：帧滑过了它的 SYNC0。</translation>
    </message>
    <message>
        <source>{slave} missed {missed:# SM2 event|# SM2 events}: the master synchronisation is switched off, and frames slid through its SYNC0.</source>
        <translation>{slave} 错过了 {missed} 个 SM2 事件：主站同步已关闭，帧滑过了它的 SYNC0。</translation>
    </message>
    <message>
        <source>{slave} got its outputs too late for SYNC0 {count} (0x1C32:0D shift too short), and nothing held the frames at their place before it all the time: they slid through it.</source>
        <translation>{slave} 的输出对 SYNC0 而言到达过晚（{count}，0x1C32:0D 偏移过短），且没有什么始终把帧保持在它之前的位置：帧滑过了 SYNC0。</translation>
    </message>
    <message>
        <source>{slave} missed {missed:# SM2 event|# SM2 events}, {part} of them because frames came behind the SYNC0 they were meant for: nominally they are there {margin} before it, but one in a thousand is {lateness} late.</source>
        <translation>{slave} 错过了 {missed} 个 SM2 事件，其中 {part} 个是因为帧晚于其所对应的 SYNC0 到达：帧标称在 SYNC0 之前 {margin} 到达，但每一千帧中有一帧晚 {lateness}。</translation>
    </message>
    <message>
        <source>{slave} missed {missed:# SM2 event|# SM2 events}, {part} of them because frames were lost; its error counter reached {integrator} of {limit}.</source>
        <translation>{slave} 错过了 {missed} 个 SM2 事件，其中 {part} 个是因为丢帧；其错误计数器达到 {integrator}（限值：{limit}）。</translation>
    </message>
    <message>
        <source>{slave} missed {missed:# SM2 event|# SM2 events}, {part} of them because frames were held up on their way; its error counter reached {integrator} of {limit}.</source>
        <translation>{slave} 错过了 {missed} 个 SM2 事件，其中 {part} 个是因为帧在途中被延误；其错误计数器达到 {integrator}（限值：{limit}）。</translation>
    </message>
    <message>
        <source>{slave} missed {missed:# SM2 event|# SM2 events}, {part} of them because the host left cycles out; its error counter reached {integrator} of {limit}.</source>
        <translation>{slave} 错过了 {missed} 个 SM2 事件，其中 {part} 个是因为主机漏掉周期；其错误计数器达到 {integrator}（限值：{limit}）。</translation>
    </message>
    <message>
        <source>{slave} missed {missed:# SM2 event|# SM2 events}, {part} of them while its SYNC0 did not come where its outputs are meant for, from {since} on: {why}.</source>
        <translation>{slave} 丢失 {missed:# 个 SM2 事件|# 个 SM2 事件}，其中 {part} 个发生在其 SYNC0 未在输出所针对的时刻到来期间，自 {since} 起：{why}。</translation>
    </message>
    <message>
        <source>{slave} needed longer than its cycle {count} ({object} cycle exceeded), last at {last}.</source>
        <translation>{slave} 有 {count}所需时间超过其周期（{object} cycle exceeded），最近一次在 {last}。</translation>
    </message>
    <message>
        <source>{slave} skipped {count:# cycle|# cycles} because the one before was not over ({object} cycle exceeded): its fieldbus needs longer than a cycle.</source>
        <translation>{slave} 因前一周期尚未结束而跳过了 {count} 个周期（{object} cycle exceeded）：其现场总线所需时间超过一个周期。</translation>
    </message>
    <message>
        <source>{slave} stays in {state} while others went further.</source>
        <translation>{slave} 停留在 {state}，而其他从站已进入更高的状态。</translation>
    </message>
    <message>
        <source>{slave} stays in {state}: it refused to go on with AL status code {alcode}, last at {since}.</source>
        <translation>{slave} 停留在 {state}：它以 AL 状态码 {alcode} 拒绝继续，最近一次在 {since}。</translation>
    </message>
    <message>
        <source>{slave} was {deviation} off its reference clock at {since}, and nobody monitors it.</source>
        <translation>{slave} 在 {since} 时与其参考时钟的偏差为 {deviation}，且无人监视。</translation>
    </message>
    <message>
        <source>{slave} went at {since} and came back; meanwhile those behind it followed with delays (0x0928) that were measured with it: they were off by up to {deviation}.</source>
        <translation>{slave} 在 {since} 离线后又恢复；期间其后的从站使用包含它时测得的延迟（0x0928）跟随：偏差曾最大为 {deviation}。</translation>
    </message>
    <message>
        <source>{slave} went at {since}, and those behind it follow since with delays (0x0928) that were measured with it: they are off by up to {deviation}.</source>
        <translation>{slave} 在 {since} 离线，其后的从站此后使用包含它时测得的延迟（0x0928）跟随：偏差最大为 {deviation}。</translation>
    </message>
    <message>
        <source>{subject} and {detail} have changed places.</source>
        <translation>{subject} 与 {detail} 互换了位置。</translation>
    </message>
    <message>
        <source>{subject} answered in its mailbox with something else than was asked{because}.</source>
        <translation>{subject} 在其邮箱中的响应与请求不符{because}。</translation>
    </message>
    <message>
        <source>{subject} answers again</source>
        <translation>{subject} 恢复响应</translation>
    </message>
    <message>
        <source>{subject} did not answer in its mailbox in time.</source>
        <translation>{subject} 未在其邮箱中及时响应。</translation>
    </message>
    <message>
        <source>{subject} did not reach {state} in time and is in {actual}.</source>
        <translation>{subject} 未及时到达 {state}，当前处于 {actual}。</translation>
    </message>
    <message>
        <source>{subject} does not answer</source>
        <translation>{subject} 没有响应</translation>
    </message>
    <message>
        <source>{subject} in sync again, deviation {deviation}</source>
        <translation>{subject} 重新同步，偏差 {deviation}</translation>
    </message>
    <message>
        <source>{subject} is another device than configured{because}.</source>
        <translation>{subject} 与配置的设备不同{because}。</translation>
    </message>
    <message>
        <source>{subject} is malformed{because}.</source>
        <translation>{subject} 的格式错误{because}。</translation>
    </message>
    <message>
        <source>{subject} is missing{because}.</source>
        <translation>{subject} 缺失{because}。</translation>
    </message>
    <message>
        <source>{subject} is not supported{because}.</source>
        <translation>{subject} 不受支持{because}。</translation>
    </message>
    <message>
        <source>{subject} port {port}: link lost {lost}</source>
        <translation>{subject} 端口 {port}：链路丢失 {lost}</translation>
    </message>
    <message>
        <source>{subject} port {port}: {damaged:# damaged frame|# damaged frames}</source>
        <translation>{subject} 端口 {port}：{damaged} 个损坏的帧</translation>
    </message>
    <message>
        <source>{subject} port {port}: {damaged:# damaged frame|# damaged frames}, link lost {lost}</source>
        <translation>{subject} 端口 {port}：{damaged} 个损坏的帧，链路丢失 {lost}</translation>
    </message>
    <message>
        <source>{subject} refused {state} and stays in {actual}: AL status code {alcode}.</source>
        <translation>{subject} 拒绝 {state}，停留在 {actual}：AL 状态码 {alcode}。</translation>
    </message>
    <message>
        <source>{subject} refused {state} and stays in {actual}: AL status code {alcode}; check {check}.</source>
        <translation>{subject} 拒绝 {state}，停留在 {actual}：AL 状态码 {alcode}；检查{check}。</translation>
    </message>
    <message>
        <source>{subject} took too long{because}.</source>
        <translation>{subject} 耗时过长{because}。</translation>
    </message>
    <message>
        <source>{subject}: PDI watchdog expired ({count}): its firmware is silent</source>
        <translation>{subject}：PDI 看门狗超时 ({count})：其固件没有动作</translation>
    </message>
    <message>
        <source>{subject}: connected (hot-connect group "{group}")</source>
        <translation>{subject}：已连接（热连接组“{group}”）</translation>
    </message>
    <message>
        <source>{subject}: connected by port {port} instead of A: swap its cables IN and OUT; its delay is right here, but other masters take it wrong without a word</source>
        <translation>{subject}：通过端口 {port} 而不是 A 连接：交换其 IN 和 OUT 电缆；此处其延迟正确，但其他主站会测错且不作提示</translation>
    </message>
    <message>
        <source>{subject}: diagnosis {type} {code}, text {text}</source>
        <translation>{subject}：诊断 {type} {code}，文本 {text}</translation>
    </message>
    <message>
        <source>{subject}: diagnosis {type} {code}, text {text}, time stamp {stamp}</source>
        <translation>{subject}：诊断 {type} {code}，文本 {text}，时间戳 {stamp}</translation>
    </message>
    <message>
        <source>{subject}: disconnected (hot-connect group "{group}")</source>
        <translation>{subject}：已断开（热连接组“{group}”）</translation>
    </message>
    <message>
        <source>{subject}: emergency {code} ({alarm}, {text}), error register {register}, data {data}</source>
        <translation>{subject}：紧急消息 {code}（{alarm}，{text}），错误寄存器 {register}，数据 {data}</translation>
    </message>
    <message>
        <source>{subject}: emergency {code}, error register {register}, data {data}</source>
        <translation>{subject}：紧急消息 {code}，错误寄存器 {register}，数据 {data}</translation>
    </message>
    <message>
        <source>{subject}: it renews its inputs in every cycle again</source>
        <translation>{subject}：重新在每个周期更新其输入</translation>
    </message>
    <message>
        <source>{subject}: it takes its outputs in every cycle again</source>
        <translation>{subject}：重新在每个周期取走其输出</translation>
    </message>
    <message>
        <source>{subject}: its cycles are short enough again</source>
        <translation>{subject}：其周期已恢复到足够短</translation>
    </message>
    <message>
        <source>{subject}: its delay of {delay} is not above that of the slave before it</source>
        <translation>{subject}：其延迟 {delay} 不大于前一个从站的延迟</translation>
    </message>
    <message>
        <source>{subject}: no new inputs in {stale} of {cycles:# cycle|# cycles}, where each brought some before: its firmware is slow</source>
        <translation>{subject}：{cycles} 个周期中有 {stale} 个没有新输入，而此前每个周期都有：其固件较慢</translation>
    </message>
    <message>
        <source>{subject}: not there yet (hot-connect group "{group}")</source>
        <translation>{subject}：尚未出现（热连接组“{group}”）</translation>
    </message>
    <message>
        <source>{subject}: outputs waited until the next ones in {stale} of {cycles:# cycle|# cycles}, where it took them before: its firmware is slow</source>
        <translation>{subject}：{cycles} 个周期中有 {stale} 个的输出一直等到下一批输出到来，而此前都会被取走：其固件较慢</translation>
    </message>
    <message>
        <source>{subject}: port {port} has a link and no slave behind it: a closed ring or another master</source>
        <translation>{subject}：端口 {port} 有链路但其后没有从站：环路闭合或存在另一个主站</translation>
    </message>
    <message>
        <source>{subject}: process data watchdog expired ({count})</source>
        <translation>{subject}：过程数据看门狗超时 ({count})</translation>
    </message>
    <message>
        <source>{subject}: recovered (try {tries})</source>
        <translation>{subject}：已恢复（第 {tries} 次尝试）</translation>
    </message>
    <message>
        <source>{subject}: recovery FAILED (try {tries})</source>
        <translation>{subject}：恢复失败（第 {tries} 次尝试）</translation>
    </message>
    <message>
        <source>{subject}: recovery begins (try {tries})</source>
        <translation>{subject}：开始恢复（第 {tries} 次尝试）</translation>
    </message>
    <message>
        <source>{subject}: recovery given up (try {tries})</source>
        <translation>{subject}：放弃恢复（第 {tries} 次尝试）</translation>
    </message>
    <message>
        <source>{subject}: the DCM error of {error} is beyond the limit of {limit}.</source>
        <translation>{subject}：DCM 误差 {error} 超出限值 {limit}。</translation>
    </message>
    <message>
        <source>{subject}: the delay to it comes out negative ({delay}); 0 is taken</source>
        <translation>{subject}：到它的延迟为负值 ({delay})；取为 0</translation>
    </message>
    <message>
        <source>{subject}: the delay to it is implausible ({delay}); 0 is taken</source>
        <translation>{subject}：到它的延迟不合理 ({delay})；取为 0</translation>
    </message>
    <message>
        <source>{subject}: the slave aborted the SDO transfer with {code} ({meaning}).</source>
        <translation>{subject}：从站中止了 SDO 传输，代码 {code}（{meaning}）。</translation>
    </message>
    <message>
        <source>{subject}: the slave ended the file transfer with {code} ({meaning}){because}.</source>
        <translation>{subject}：从站结束了文件传输，代码 {code}（{meaning}）{because}。</translation>
    </message>
    <message>
        <source>{subject}: the slave's answer differs from what the init command demands{because}.</source>
        <translation>{subject}：从站的响应与初始化命令的要求不符{because}。</translation>
    </message>
    <message>
        <source>{subject}: working counter {received} where {expected} was expected; a slave did not process the datagram.</source>
        <translation>{subject}：工作计数器为 {received}，应为 {expected}；有从站未处理该数据报。</translation>
    </message>
    <message>
        <source>{subject}: {count} of its cycles took longer than the cycle time: its firmware is slow</source>
        <translation>{subject}：其 {count} 个周期超过了周期时间：其固件较慢</translation>
    </message>
    <message>
        <source>{subject}: {from} -&gt; {to}</source>
        <translation>{subject}：{from} -&gt; {to}</translation>
    </message>
    <message>
        <source>{subject}: {status} with AL status code {code}</source>
        <translation>{subject}：{status}，AL 状态码 {code}</translation>
    </message>
    <message>
        <source>{subject}: {status} with AL status code {code}; check {check}</source>
        <translation>{subject}：{status}，AL 状态码 {code}；检查{check}</translation>
    </message>
    <message>
        <source>{text}</source>
        <translation>{text}</translation>
    </message>
    <message>
        <source>{what} writes the file {file}, too; name another one for one of them</source>
        <translation>{what} 也写入文件 {file}；请为其中之一指定另一个文件</translation>
    </message>
    <message>
        <source>{where}: the element &lt;{subject}&gt; is missing{because}.</source>
        <translation>{where}：缺少元素 &lt;{subject}&gt;{because}。</translation>
    </message>
    <message>
        <source>{where}: the file is beyond what is read{because}.</source>
        <translation>{where}：文件超出可读取的大小{because}。</translation>
    </message>
    <message>
        <source>{where}: the key "{subject}" cannot be used{because}.</source>
        <translation>{where}：键“{subject}”无法使用{because}。</translation>
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
        <translation>{where}：不是格式良好的 TOML{because}。</translation>
    </message>
    <message>
        <source>{where}: this is not well-formed XML{because}.</source>
        <translation>{where}：不是格式良好的 XML{because}。</translation>
    </message>
    <message>
        <source>{who} cannot be the first slave of the bus: nobody could be in front of it.</source>
        <translation>{who}不能是总线的第一个从站：没有从站能位于它之前。</translation>
    </message>
    <message>
        <source>{who} is known by its alias; it has none.</source>
        <translation>{who}按别名识别，但没有设置别名。</translation>
    </message>
    <message>
        <source>"{text}" is no number</source>
        <translation>“{text}”不是数字</translation>
    </message>
    <message>
        <source>"{text}" is out of range</source>
        <translation>“{text}”超出范围</translation>
    </message>
    <message>
        <source>"{text}" is no hexadecimal data</source>
        <translation>“{text}”不是十六进制数据</translation>
    </message>
    <message>
        <source>"{text}" is neither true nor false</source>
        <translation>“{text}”既不是 true 也不是 false</translation>
    </message>
    <message>
        <source>"{text}" is no state transition</source>
        <translation>“{text}”不是状态转换</translation>
    </message>
    <message>
        <source>"{text}" is no transition</source>
        <translation>“{text}”不是转换</translation>
    </message>
    <message>
        <source>"{text}" is no PDO index</source>
        <translation>“{text}”不是 PDO 索引</translation>
    </message>
    <message>
        <source>in &lt;{element}&gt;</source>
        <translation>在 &lt;{element}&gt; 中</translation>
    </message>
    <message>
        <source>there is no element</source>
        <translation>其中没有任何元素</translation>
    </message>
    <message>
        <source>it has {size} MB, the limit is {limit} MB</source>
        <translation>其大小为 {size} MB，上限为 {limit} MB</translation>
    </message>
    <message>
        <source>it has more than {limit} MB</source>
        <translation>其大小超过 {limit} MB</translation>
    </message>
    <message>
        <source>it is written in the encoding "{name}", which this system cannot convert; save it as UTF-8</source>
        <translation>其编码为“{name}”，本系统无法转换；请另存为 UTF-8</translation>
    </message>
    <message>
        <source>it should be written in the encoding "{name}", to which the byte 0x{byte} does not belong; save it as UTF-8</source>
        <translation>其编码应为“{name}”，但字节 0x{byte} 不属于该编码；请另存为 UTF-8</translation>
    </message>
    <message>
        <source>a project file with the root &lt;{wanted}&gt;, not &lt;{root}&gt;</source>
        <translation>根元素为 &lt;{wanted}&gt; 的项目文件，而不是 &lt;{root}&gt;</translation>
    </message>
    <message>
        <source>a project file of version {version} or older, not {other}</source>
        <translation>版本 {version} 或更早的项目文件，而不是 {other}</translation>
    </message>
    <message>
        <source>an ENI file (root element EtherCATConfig)</source>
        <translation>ENI 文件（根元素为 EtherCATConfig）</translation>
    </message>
    <message>
        <source>an ENI file that others can read: its maker has encrypted it</source>
        <translation>他人可读的 ENI 文件：其制作者已将其加密</translation>
    </message>
    <message>
        <source>an ESI file with the root &lt;EtherCATInfo&gt;, not &lt;{root}&gt;</source>
        <translation>根元素为 &lt;EtherCATInfo&gt; 的 ESI 文件，而不是 &lt;{root}&gt;</translation>
    </message>
    <message>
        <source>a pcap or pcapng capture; it is empty</source>
        <translation>pcap 或 pcapng 抓包文件；该文件为空</translation>
    </message>
    <message>
        <source>a recording; this database belongs to another program</source>
        <translation>录制文件；该数据库属于其他程序</translation>
    </message>
    <message>
        <source>a recording of version {version} or older; this one is of version {other}, use the program that has written it, or a newer one</source>
        <translation>版本 {version} 或更早的录制文件；此文件版本为 {other}，请使用写入它的程序或更新的版本</translation>
    </message>
    <message>
        <source>it is damaged: {words}</source>
        <translation>它已损坏：{words}</translation>
    </message>
    <message>
        <source>there is not enough memory</source>
        <translation>内存不足</translation>
    </message>
    <message>
        <source>there is one of this name already, and a recording replaces nothing</source>
        <translation>同名文件已存在，录制不会替换任何文件</translation>
    </message>
    <message>
        <source>the file is gone: it, or its folder, was deleted or moved while it was recorded</source>
        <translation>文件已不存在：录制期间它或其文件夹被删除或移动</translation>
    </message>
    <message>
        <source>the attribute No is missing</source>
        <translation>缺少属性 No</translation>
    </message>
    <message>
        <source>the attribute ModuleIdent is missing</source>
        <translation>缺少属性 ModuleIdent</translation>
    </message>
    <message>
        <source>it has too many sub-indices</source>
        <translation>子索引过多</translation>
    </message>
    <message>
        <source>MinInstances {least} is more than MaxInstances {most}</source>
        <translation>MinInstances {least} 大于 MaxInstances {most}</translation>
    </message>
    <message>
        <source>there is no Pdo with the RefName "{name}"</source>
        <translation>没有 RefName 为“{name}”的 Pdo</translation>
    </message>
    <message>
        <source>the PDO index 0x{index} is used twice; first in line {line}</source>
        <translation>PDO 索引 0x{index} 重复使用；首次出现在第 {line} 行</translation>
    </message>
    <message>
        <source>{value} is out of range in channel {channel}</source>
        <translation>{value} 在通道 {channel} 中超出范围</translation>
    </message>
    <message>
        <source>it lies outside of the folder of the ESI file</source>
        <translation>它位于 ESI 文件所在文件夹之外</translation>
    </message>
    <message>
        <source>the ESI file refers to too many files</source>
        <translation>该 ESI 文件引用了过多文件</translation>
    </message>
    <message>
        <source>there is no device "{name}" in the file</source>
        <translation>文件中没有设备“{name}”</translation>
    </message>
    <message>
        <source>the ESI files have revision 0x{revision}</source>
        <translation>ESI 文件中的修订号为 0x{revision}</translation>
    </message>
    <message>
        <source>none of the {count} devices in the ESI files has this vendor and product</source>
        <translation>ESI 文件中的 {count} 个设备均无此厂商和产品</translation>
    </message>
    <message>
        <source>it is no device catalogue, or its beginning is damaged</source>
        <translation>它不是设备目录，或其开头已损坏</translation>
    </message>
    <message>
        <source>it is no ordinary file</source>
        <translation>它不是普通文件</translation>
    </message>
    <message>
        <source>Permission denied</source>
        <translation>权限不足</translation>
    </message>
    <message>
        <source>Operation not permitted</source>
        <translation>操作不被允许</translation>
    </message>
    <message>
        <source>Is a directory</source>
        <translation>它是一个文件夹</translation>
    </message>
    <message>
        <source>Not a directory</source>
        <translation>路径中的某部分不是文件夹</translation>
    </message>
    <message>
        <source>No such file or directory</source>
        <translation>文件或文件夹不存在</translation>
    </message>
    <message>
        <source>No space left on device</source>
        <translation>磁盘空间不足</translation>
    </message>
    <message>
        <source>Read-only file system</source>
        <translation>文件系统为只读</translation>
    </message>
    <message>
        <source>Input/output error</source>
        <translation>输入/输出错误</translation>
    </message>
    <message>
        <source>Disk quota exceeded</source>
        <translation>磁盘配额已用尽</translation>
    </message>
    <message>
        <source>this machine has no Ethernet adapter</source>
        <translation>本机没有以太网适配器</translation>
    </message>
    <message>
        <source>there are: {names}</source>
        <translation>现有：{names}</translation>
    </message>
    <message>
        <source>not an Ethernet adapter</source>
        <translation>不是以太网适配器</translation>
    </message>
    <message>
        <source>no carrier</source>
        <translation>无载波</translation>
    </message>
    <message>
        <source>it cannot put its send time into frames</source>
        <translation>它无法将发送时间写入帧中</translation>
    </message>
    <message>
        <source>Network is down</source>
        <translation>网络适配器已关闭</translation>
    </message>
    <message>
        <source>No such device</source>
        <translation>设备不存在</translation>
    </message>
    <message>
        <source>No such device or address</source>
        <translation>设备或地址不存在</translation>
    </message>
    <message>
        <source>the EEPROM belongs to the PDI and is left to it</source>
        <translation>EEPROM 归 PDI 所有，保持不动</translation>
    </message>
    <message>
        <source>category {category} at word 0x{word} of {words} words reaches beyond the EEPROM of {bytes} bytes</source>
        <translation>位于字 0x{word} 的类别 {category}（{words} 个字）超出了 {bytes} 字节的 EEPROM</translation>
    </message>
    <message>
        <source>more than {most} categories up to word 0x{word}</source>
        <translation>到字 0x{word} 为止的类别多于 {most} 个</translation>
    </message>
    <message>
        <source>it has an odd number of bytes</source>
        <translation>其字节数为奇数</translation>
    </message>
    <message>
        <source>it is shorter than the header of {bytes} bytes</source>
        <translation>它短于 {bytes} 字节的头部</translation>
    </message>
    <message>
        <source>its checksum is 0x{has} where 0x{right} is right</source>
        <translation>其校验和为 0x{has}，正确值为 0x{right}</translation>
    </message>
    <message>
        <source>its {bytes} bytes are more than the EEPROM's {room}</source>
        <translation>其 {bytes} 字节超过 EEPROM 的 {room} 字节</translation>
    </message>
    <message>
        <source>no answer at word 0x{word}{which}</source>
        <translation>在字 0x{word} 处无应答{which}</translation>
    </message>
    <message>
        <source>the EEPROM stays busy at word 0x{word}{which}</source>
        <translation>EEPROM 在字 0x{word} 处一直忙{which}</translation>
    </message>
    <message>
        <source>the ESC does not enable writing at word 0x{word}{which}</source>
        <translation>ESC 未在字 0x{word} 处允许写入{which}</translation>
    </message>
    <message>
        <source>the EEPROM acknowledges no write command at word 0x{word}{which}</source>
        <translation>EEPROM 在字 0x{word} 处不确认写命令{which}</translation>
    </message>
    <message>
        <source>the EEPROM acknowledges no read command at word 0x{word}{which}</source>
        <translation>EEPROM 在字 0x{word} 处不确认读命令{which}</translation>
    </message>
    <message>
        <source>word 0x{word} reads 0x{value} after another value was written{which}</source>
        <translation>字 0x{word} 写入其他值后读回为 0x{value}{which}</translation>
    </message>
    <message>
        <source>{bytes} bytes are fewer than the {least} of its fixed part</source>
        <translation>{bytes} 字节少于其固定部分的 {least} 字节</translation>
    </message>
    <message>
        <source>a write of it was cut short; go offline and end that first</source>
        <translation>其写入曾被中断；请先离线并完成该写入</translation>
    </message>
    <message>
        <source>a write of it was cut short; end that first with "sii finish", or write a whole image</source>
        <translation>其写入曾被中断；请先用“sii finish”完成，或写入完整映像</translation>
    </message>
    <message>
        <source>no EEPROM write of this slave was cut short</source>
        <translation>该从站没有被中断的 EEPROM 写入</translation>
    </message>
    <message>
        <source>the mailbox holds no segment</source>
        <translation>邮箱容纳不下一个分段</translation>
    </message>
    <message>
        <source>the mailbox holds no data</source>
        <translation>邮箱容纳不下数据</translation>
    </message>
    <message>
        <source>the answer belongs to another request</source>
        <translation>该应答属于另一个请求</translation>
    </message>
    <message>
        <source>the toggle bit did not alternate</source>
        <translation>翻转位没有交替</translation>
    </message>
    <message>
        <source>the slave announces {bytes} bytes, more than the {most} that are taken</source>
        <translation>从站声明 {bytes} 字节，超过可接受的 {most} 字节</translation>
    </message>
    <message>
        <source>more than the {bytes} bytes that were announced</source>
        <translation>多于声明的 {bytes} 字节</translation>
    </message>
    <message>
        <source>{bytes} bytes where {announced} were announced</source>
        <translation>收到 {bytes} 字节，而声明的是 {announced} 字节</translation>
    </message>
    <message>
        <source>an empty segment that is not the last</source>
        <translation>空分段，但不是最后一个</translation>
    </message>
    <message>
        <source>its fragments do not follow each other</source>
        <translation>其片段不连续</translation>
    </message>
    <message>
        <source>its answer is longer than {bytes} bytes</source>
        <translation>其应答长于 {bytes} 字节</translation>
    </message>
    <message>
        <source>an error that cannot be read</source>
        <translation>无法读取的错误</translation>
    </message>
    <message>
        <source>it has no mailbox</source>
        <translation>它没有邮箱</translation>
    </message>
    <message>
        <source>it is longer than a frame</source>
        <translation>它比一个帧还长</translation>
    </message>
    <message>
        <source>no frame comes back</source>
        <translation>没有帧返回</translation>
    </message>
    <message>
        <source>no acknowledgement where one was to come</source>
        <translation>应有确认却没有收到</translation>
    </message>
    <message>
        <source>no data where data were asked for</source>
        <translation>请求了数据却没有收到</translation>
    </message>
    <message>
        <source>busy without end</source>
        <translation>一直忙</translation>
    </message>
    <message>
        <source>packet {number} where {expected} was to come</source>
        <translation>收到数据包 {number}，应为 {expected}</translation>
    </message>
    <message>
        <source>the file is longer than the {bytes} bytes that are taken</source>
        <translation>文件长于可接受的 {bytes} 字节</translation>
    </message>
    <message>
        <source>its datagram of {bytes} bytes takes {time} us on the wire, and the cycle leaves no room for it; choose a longer cycle</source>
        <translation>其 {bytes} 字节的数据报在线路上需要 {time} us，周期内没有余量；请选择更长的周期</translation>
    </message>
    <message>
        <source>{bytes} bytes are more than the {most} that are possible</source>
        <translation>{bytes} 字节超过允许的 {most} 字节</translation>
    </message>
    <message>
        <source>it is about no bytes at all</source>
        <translation>其中没有任何字节</translation>
    </message>
    <message>
        <source>{count} others are on their way already; wait for one of them</source>
        <translation>已有 {count} 个请求在途；请等待其中之一完成</translation>
    </message>
    <message>
        <source>it has no slaves</source>
        <translation>其中没有从站</translation>
    </message>
    <message>
        <source>it has no cyclic frames</source>
        <translation>其中没有周期帧</translation>
    </message>
    <message>
        <source>more slaves than addresses</source>
        <translation>从站数多于地址数</translation>
    </message>
    <message>
        <source>the bus is offline</source>
        <translation>总线已离线</translation>
    </message>
    <message>
        <source>no slave on the bus has a system time</source>
        <translation>总线上没有从站具有系统时间</translation>
    </message>
    <message>
        <source>no slave is configured as reference clock</source>
        <translation>没有从站被配置为参考时钟</translation>
    </message>
    <message>
        <source>it has no system time and cannot be the reference clock, and no slave behind it can</source>
        <translation>它没有系统时间，不能作为参考时钟，其后的从站也都不能</translation>
    </message>
    <message>
        <source>no slave that is there can be the reference clock</source>
        <translation>在场的从站都不能作为参考时钟</translation>
    </message>
    <message>
        <source>no answer to the receive time latch</source>
        <translation>锁存接收时间无应答</translation>
    </message>
    <message>
        <source>it does not take its system time offset</source>
        <translation>它不接受其系统时间偏移</translation>
    </message>
    <message>
        <source>its system time cannot be read</source>
        <translation>无法读取其系统时间</translation>
    </message>
    <message>
        <source>its SYNC unit is not active (0x0981)</source>
        <translation>其 SYNC 单元未激活 (0x0981)</translation>
    </message>
    <message>
        <source>the bus is at rest in INIT; lead the whole bus to PREOP first</source>
        <translation>总线停留在 INIT；请先将整个总线切换到 PREOP</translation>
    </message>
    <message>
        <source>the bus is in {state}; no slave can be led above it</source>
        <translation>总线处于 {state}；任何从站都不能切换到更高状态</translation>
    </message>
    <message>
        <source>no station address is free</source>
        <translation>没有空闲的站地址</translation>
    </message>
    <message>
        <source>"{text}" is no whole number</source>
        <translation>“{text}”不是整数</translation>
    </message>
    <message>
        <source>"{text}" is no number of microseconds with at most three decimals</source>
        <translation>“{text}”不是最多三位小数的微秒数</translation>
    </message>
    <message>
        <source>"{text}" is neither on nor off</source>
        <translation>“{text}”既不是 on 也不是 off</translation>
    </message>
    <message>
        <source>"{text}" is none of {words}</source>
        <translation>“{text}”不在 {words} 之中</translation>
    </message>
    <message>
        <source>"{text}" is no address like {example}</source>
        <translation>“{text}”不是形如 {example} 的地址</translation>
    </message>
    <message>
        <source>a name cannot be empty</source>
        <translation>名称不能为空</translation>
    </message>
    <message>
        <source>a name is printable UTF-8 text</source>
        <translation>名称必须是可打印的 UTF-8 文本</translation>
    </message>
    <message>
        <source>the factor 0 gives no cycle; switch the operation mode off instead</source>
        <translation>因子 0 不构成周期；请改为关闭运行模式</translation>
    </message>
    <message>
        <source>the setting needs a value</source>
        <translation>该设置需要一个值</translation>
    </message>
    <message>
        <source>"{text}" is not to be had here</source>
        <translation>此处没有“{text}”</translation>
    </message>
    <message>
        <source>it is a number</source>
        <translation>它是一个数字</translation>
    </message>
    <message>
        <source>it is a text</source>
        <translation>它是一段文本</translation>
    </message>
    <message>
        <source>"{name}" is the name of number {number} already</source>
        <translation>“{name}”已是编号 {number} 的名称</translation>
    </message>
    <message>
        <source>the device has no PDO 0x{index} in this direction; it has {indices}</source>
        <translation>该设备在此方向上没有 PDO 0x{index}；现有 {indices}</translation>
    </message>
    <message>
        <source>0x{index} stands there twice</source>
        <translation>0x{index} 出现了两次</translation>
    </message>
    <message>
        <source>0x{index} and 0x{other} exclude each other</source>
        <translation>0x{index} 与 0x{other} 互斥</translation>
    </message>
    <message>
        <source>the device has no such PDO</source>
        <translation>该设备没有这样的 PDO</translation>
    </message>
    <message>
        <source>the ESI says that the mapping of this PDO is fixed</source>
        <translation>ESI 规定此 PDO 的映射是固定的</translation>
    </message>
    <message>
        <source>the device does not take another mapping (CoE PdoConfig in its ESI)</source>
        <translation>该设备不接受其他映射（其 ESI 中的 CoE PdoConfig）</translation>
    </message>
    <message>
        <source>the device has no CoE mailbox</source>
        <translation>该设备没有 CoE 邮箱</translation>
    </message>
    <message>
        <source>the device has no SoE mailbox</source>
        <translation>该设备没有 SoE 邮箱</translation>
    </message>
    <message>
        <source>"{text}" is no state transition like PS or SO</source>
        <translation>“{text}”不是 PS 或 SO 之类的状态转换</translation>
    </message>
    <message>
        <source>"{text}" are no whole hexadecimal bytes</source>
        <translation>“{text}”不是完整的十六进制字节</translation>
    </message>
    <message>
        <source>"{text}" is no object</source>
        <translation>“{text}”不是对象</translation>
    </message>
    <message>
        <source>the comment is no UTF-8 text</source>
        <translation>注释不是 UTF-8 文本</translation>
    </message>
    <message>
        <source>"{text}" is neither none nor a module ident</source>
        <translation>“{text}”既不是 none 也不是模块标识</translation>
    </message>
    <message>
        <source>there is no slave at position {position}, the last one is at {last}</source>
        <translation>位置 {position} 处没有从站，最后一个在 {last}</translation>
    </message>
    <message>
        <source>the slave is gone</source>
        <translation>该从站已不存在</translation>
    </message>
    <message>
        <source>no file can be made there</source>
        <translation>无法在该处创建文件</translation>
    </message>
    <message>
        <source>no slaves</source>
        <translation>没有从站</translation>
    </message>
    <message>
        <source>unsaved work of Syncline</source>
        <translation>Syncline 的未保存工作</translation>
    </message>
    <message>
        <source>a recording is shown: close it first (File, Close Recording)</source>
        <translation>正在显示录制文件：请先关闭（文件，关闭录制）</translation>
    </message>
    <message>
        <source>a run holds {count} different ones: go offline and online again to watch others</source>
        <translation>一次运行最多容纳 {count} 个不同的变量：请先离线再上线以监视其他变量</translation>
    </message>
    <message>
        <source>no machine runs: go online first</source>
        <translation>没有机器在运行：请先上线</translation>
    </message>
    <message>
        <source>no cycle has run yet: go online first</source>
        <translation>尚无周期运行过：请先上线</translation>
    </message>
    <message>
        <source>no cycle of it is in memory any more</source>
        <translation>内存中已没有其中的任何周期</translation>
    </message>
    <message>
        <source>another stretch is being written; try again in a moment</source>
        <translation>另一段正在写入；请稍后重试</translation>
    </message>
    <message>
        <source>{value} is outside {range}</source>
        <translation>{value} 超出范围 {range}</translation>
    </message>
    <message>
        <source>the value is of another kind</source>
        <translation>该值属于其他类型</translation>
    </message>
    <message>
        <source>its SYNC0 will never come: the start time {start} (0x0990) had passed by {late} ns at {time}</source>
        <translation>其 SYNC0 永远不会到来：在 {time} 时启动时间 {start} (0x0990) 已过去 {late} ns</translation>
    </message>
    <message>
        <source>packet {number} acknowledged where {expected} was sent</source>
        <translation>确认了数据包 {number}，而发送的是 {expected}</translation>
    </message>
    <message>
        <source>link-layer-ref-clock: this link cannot put its send time into frames</source>
        <translation>link-layer-ref-clock：此链路无法将发送时间写入帧中</translation>
    </message>
    <message>
        <source>it is not in sync after {time} s: {reason}</source>
        <translation>{time} s 后仍未同步：{reason}</translation>
    </message>
    <message>
        <source>messages without end, but no answer</source>
        <translation>消息不断，但没有应答</translation>
    </message>
    <message>
        <source>an EEPROM is written in words of two bytes</source>
        <translation>EEPROM 以两字节的字写入</translation>
    </message>
    <message>
        <source>the device has {count} places for modules, counted from 0</source>
        <translation>该设备有 {count} 个模块位置，从 0 开始计数</translation>
    </message>
    <message>
        <source>module 0x{module} does not fit into place {place}; these do: {modules}</source>
        <translation>模块 0x{module} 不适合位置 {place}；可用的有：{modules}</translation>
    </message>
    <message>
        <source>SDO command 0x{command} is not a response</source>
        <translation>SDO 命令 0x{command} 不是应答</translation>
    </message>
    <message>
        <source>it is not an SDO response</source>
        <translation>它不是 SDO 应答</translation>
    </message>
    <message>
        <source>only {bytes} bytes</source>
        <translation>只有 {bytes} 字节</translation>
    </message>
    <message>
        <source>"{text}" is no object; write 0x1018:01</source>
        <translation>“{text}”不是对象；请写成 0x1018:01</translation>
    </message>
    <message>
        <source>it needs about {need} MiB, and the disk has {left} MiB left</source>
        <translation>大约需要 {need} MiB，而磁盘仅剩 {left} MiB</translation>
    </message>
    <message>
        <source>only {left} MiB are left on the disk; the recording is whole up to here</source>
        <translation>磁盘仅剩 {left} MiB；到此为止的录制是完整的</translation>
    </message>
    <message>
        <source>there is no slave at position {position}; the project has {count}</source>
        <translation>位置 {position} 处没有从站；项目中有 {count} 个</translation>
    </message>
    <message>
        <source>"{text}" is no NAME xMULTIPLE like Slow x4, with 1..{most} bus cycles</source>
        <translation>“{text}”不是形如 Slow x4 的 名称 x倍数，总线周期数为 1..{most}</translation>
    </message>
    <message>
        <source>there is no Sync Unit "{name}"; the project has {names}</source>
        <translation>没有同步单元“{name}”；项目中有 {names}</translation>
    </message>
    <message>
        <source>"{text}" is neither auto nor a factor from {least} to {most}</source>
        <translation>“{text}”既不是 auto 也不是 {least} 到 {most} 的因子</translation>
    </message>
    <message>
        <source>"{text}" is no entry INDEX:SUB:BITS like 0x6040:00:16</source>
        <translation>“{text}”不是形如 0x6040:00:16 的条目 INDEX:SUB:BITS</translation>
    </message>
    <message>
        <source>"{text}" is no address like 01:23:45:67:89:ab</source>
        <translation>“{text}”不是形如 01:23:45:67:89:ab 的地址</translation>
    </message>
    <message>
        <source>it is the name of an operation mode</source>
        <translation>它是运行模式的名称</translation>
    </message>
    <message>
        <source>"{text}" is neither none nor POSITION:PORT, like 0:B</source>
        <translation>“{text}”既不是 none 也不是形如 0:B 的 POSITION:PORT</translation>
    </message>
    <message>
        <source>"{text}" is no DRIVE:IDN=DATA like 0:S-0-0047=00000000</source>
        <translation>“{text}”不是形如 0:S-0-0047=00000000 的 DRIVE:IDN=DATA</translation>
    </message>
    <message>
        <source>"{text}" is no data=HEX like data=0200</source>
        <translation>“{text}”不是形如 data=0200 的 data=HEX</translation>
    </message>
    <message>
        <source>the device has no {protocol} mailbox</source>
        <translation>设备没有 {protocol} 邮箱</translation>
    </message>
    <message>
        <source>"{text}" is neither write nor read</source>
        <translation>“{text}”既不是 write 也不是 read</translation>
    </message>
    <message>
        <source>"{text}" is no REGISTER=DATA like 0x09A8=0100, nor, for a read, REGISTER*BYTES</source>
        <translation>“{text}”不是形如 0x09A8=0100 的 REGISTER=DATA，读取时也不是 REGISTER*BYTES</translation>
    </message>
    <message>
        <source>"{text}" is none of expect=HEX, mask=HEX, within=MS, off, after</source>
        <translation>“{text}”不是 expect=HEX、mask=HEX、within=MS、off、after 之一</translation>
    </message>
    <message>
        <source>only a read expects a value, of as many bytes as it reads; a mask is as long</source>
        <translation>只有读取才有期望值，其字节数与读取的相同；掩码也一样长</translation>
    </message>
    <message>
        <source>only commands of the master stand behind those of the slaves</source>
        <translation>只有主站的命令才能排在从站命令之后</translation>
    </message>
    <message>
        <source>A start-up message is longer than the mailbox</source>
        <translation>启动消息比邮箱长</translation>
    </message>
    <message>
        <source>Shorten it, or enlarge the output mailbox.</source>
        <translation>缩短消息，或增大输出邮箱。</translation>
    </message>
    <message>
        <source>In bytes: the message {bytes}, room in the slave's mailbox {most}.</source>
        <translation>字节数：消息 {bytes}，从站邮箱的容量 {most}。</translation>
    </message>
    <message>
        <source>"{text}" is no IDN of a drive 0..7</source>
        <translation>“{text}”不是驱动器 0..7 的 IDN</translation>
    </message>
    <message>
        <source>"{text}" is none of fixed, off, timeout=MS</source>
        <translation>“{text}”不是 fixed、off、timeout=MS 之一</translation>
    </message>
    <message>
        <source>"{text}" is no INDEX:SUB=DATA like 0x6060:00=08</source>
        <translation>“{text}”不是形如 0x6060:00=08 的 INDEX:SUB=DATA</translation>
    </message>
    <message>
        <source>"{text}" is none of complete, fixed, off, adapt, timeout=MS</source>
        <translation>“{text}”不是 complete、fixed、off、adapt、timeout=MS 之一</translation>
    </message>
    <message>
        <source>the device has no output pins that are known</source>
        <translation>该设备没有已知的输出引脚</translation>
    </message>
    <message>
        <source>the device is no CAN gateway that is known</source>
        <translation>该设备不是已知的 CAN 网关</translation>
    </message>
    <message>
        <source>{time} ns do not fit into 32 bits</source>
        <translation>{time} ns 超出 32 位</translation>
    </message>
    <message>
        <source>{percent} is more than 100 %</source>
        <translation>{percent} 大于 100 %</translation>
    </message>
    <message>
        <source>the device has no CoE mailbox through which objects could be written</source>
        <translation>该设备没有可用来写对象的 CoE 邮箱</translation>
    </message>
    <message>
        <source>it names none of the log's columns</source>
        <translation>其中没有该日志的任何列</translation>
    </message>
    <message>
        <source>the file holds {count} networks; choose one by number or name: {names}</source>
        <translation>文件包含 {count} 个网络；请按编号或名称选择：{names}</translation>
    </message>
    <message>
        <source>it holds neither what was there nor what was to be written: another slave, or written since; write the image that it is to have with "sii write"</source>
        <translation>其内容既不是原有的，也不是要写入的：可能是另一个从站，或之后又被写入；请用“sii write”写入所需映像</translation>
    </message>
    <message>
        <source>the other revision does not take it</source>
        <translation>另一修订版不接受它</translation>
    </message>
    <message>
        <source>must be a list of [part, ns], such as [[0, 50], [0.5, 500], [1, 40000]]</source>
        <translation>必须是 [比例, ns] 的列表，例如 [[0, 50], [0.5, 500], [1, 40000]]</translation>
    </message>
    <message>
        <source>must be pairs of a part from 0 to 1 and a time from 0 to 60000000000 ns</source>
        <translation>必须由成对的值组成：0 到 1 的比例和 0 到 60000000000 ns 的时间</translation>
    </message>
    <message>
        <source>the parts must rise</source>
        <translation>比例必须递增</translation>
    </message>
    <message>
        <source>{part} of all are not above {time} ns, so {other} of all cannot be below {least} ns</source>
        <translation>全体的 {part} 不超过 {time} ns，因此全体的 {other} 不可能低于 {least} ns</translation>
    </message>
    <message>
        <source>so many stalls of this length leave the host no time at all</source>
        <translation>如此多这种长度的停顿使主机完全没有时间</translation>
    </message>
    <message>
        <source>must be one of {names}</source>
        <translation>必须是以下之一：{names}</translation>
    </message>
    <message>
        <source>does not go with {fault}</source>
        <translation>不适用于 {fault}</translation>
    </message>
    <message>
        <source>does not go with {fault}: it is no slave's</source>
        <translation>不适用于 {fault}：它不属于从站</translation>
    </message>
    <message>
        <source>is missing: {fault} needs it</source>
        <translation>缺失：{fault} 需要它</translation>
    </message>
    <message>
        <source>goes without probability: one of the two</source>
        <translation>不能与 probability 同时给出：二者选一</translation>
    </message>
    <message>
        <source>must be above 0; the sign of value_ns says which way</source>
        <translation>必须大于 0；方向由 value_ns 的符号决定</translation>
    </message>
    <message>
        <source>must be above 0: at least 0.01</source>
        <translation>必须大于 0：至少 0.01</translation>
    </message>
    <message>
        <source>must be INIT, PREOP, SAFEOP or OP</source>
        <translation>必须是 INIT、PREOP、SAFEOP 或 OP</translation>
    </message>
    <message>
        <source>must be "A", "B", "C" or "D"</source>
        <translation>必须是 "A"、"B"、"C" 或 "D"</translation>
    </message>
    <message>
        <source>must be the position of a slave of this scenario</source>
        <translation>必须是本场景中某个从站的位置</translation>
    </message>
    <message>
        <source>this slave has no firmware that could do so (device emulation)</source>
        <translation>该从站没有能这样做的固件（设备仿真）</translation>
    </message>
    <message>
        <source>this slave has no mailbox</source>
        <translation>该从站没有邮箱</translation>
    </message>
    <message>
        <source>this slave has no clock (dc)</source>
        <translation>该从站没有时钟（dc）</translation>
    </message>
    <message>
        <source>this slave has no system time (dc)</source>
        <translation>该从站没有系统时间（dc）</translation>
    </message>
    <message>
        <source>needs a slave</source>
        <translation>需要一个从站</translation>
    </message>
    <message>
        <source>no cable is at this port</source>
        <translation>该端口没有电缆</translation>
    </message>
    <message>
        <source>is not free: another slave is there</source>
        <translation>已被占用：那里有另一个从站</translation>
    </message>
    <message>
        <source>is where the cable from the master is anyway</source>
        <translation>那里本来就是来自主站的电缆</translation>
    </message>
    <message>
        <source>the fault would end before it begins, at {time} ms; 0 or no until_ms: for good</source>
        <translation>故障将在 {time} ms 开始之前结束；until_ms 为 0 或不给出：永久</translation>
    </message>
    <message>
        <source>goes without until_ms: so many frames, or all of them until then</source>
        <translation>不能与 until_ms 同时给出：这么多帧，或到那时为止的所有帧</translation>
    </message>
    <message>
        <source>without a slave, lose-frames has a count or a probability</source>
        <translation>不指定从站时，lose-frames 需要 count 或 probability</translation>
    </message>
    <message>
        <source>the {fault} of the same slave that begins at {time} ms is not over then</source>
        <translation>同一从站在 {time} ms 开始的 {fault} 届时尚未结束</translation>
    </message>
    <message>
        <source>the {fault} that begins at {time} ms is not over then</source>
        <translation>在 {time} ms 开始的 {fault} 那时尚未结束</translation>
    </message>
    <message>
        <source>must be "none", "quiet", "desktop" or "bad"</source>
        <translation>必须是 "none"、"quiet"、"desktop" 或 "bad"</translation>
    </message>
    <message>
        <source>goes without jitter: one of the two</source>
        <translation>不能与 jitter 同时给出：二者选一</translation>
    </message>
    <message>
        <source>a scenario needs at least one [[slave]]</source>
        <translation>场景至少需要一个 [[slave]]</translation>
    </message>
    <message>
        <source>all pulses must come within a day</source>
        <translation>所有脉冲必须在一天之内到来</translation>
    </message>
    <message>
        <source>must be above 0 and below period_ms</source>
        <translation>必须大于 0 且小于 period_ms</translation>
    </message>
    <message>
        <source>must be "64", "32", "times" or "none"</source>
        <translation>必须是 "64"、"32"、"times" 或 "none"</translation>
    </message>
    <message>
        <source>must be "generic", "servo-y", "drive-c", "can-gateway", "analog-input" or "sync-bridge"</source>
        <translation>必须是 "generic"、"servo-y"、"drive-c"、"can-gateway"、"analog-input" 或 "sync-bridge"</translation>
    </message>
    <message>
        <source>must be 4 or 8</source>
        <translation>必须是 4 或 8</translation>
    </message>
    <message>
        <source>goes without esc, whose delays are known</source>
        <translation>不能与 esc 同时给出，其延迟是已知的</translation>
    </message>
    <message>
        <source>is processing_delay_ns less forwarding_delay_ns: one of the two</source>
        <translation>它等于 processing_delay_ns 减 forwarding_delay_ns：二者选一</translation>
    </message>
    <message>
        <source>must be "older" or "newer"</source>
        <translation>必须是 "older" 或 "newer"</translation>
    </message>
    <message>
        <source>makes {count} slaves where a segment has {most} at most</source>
        <translation>共 {count} 个从站，而一个网段最多 {most} 个</translation>
    </message>
    <message>
        <source>counts up to {last}, beyond 65535</source>
        <translation>计数到 {last}，超过 65535</translation>
    </message>
    <message>
        <source>counts up beyond 4294967295</source>
        <translation>计数超过 4294967295</translation>
    </message>
    <message>
        <source>is where the next of these slaves would be wired to; give them one by one</source>
        <translation>那里是这些从站中下一个的接线处；请逐个给出</translation>
    </message>
    <message>
        <source>must be the number of another slave</source>
        <translation>必须是另一个从站的编号</translation>
    </message>
    <message>
        <source>this port of slave {slave} has slave {other} already</source>
        <translation>从站 {slave} 的该端口已连接从站 {other}</translation>
    </message>
    <message>
        <source>is more than there and back over {length} m together</source>
        <translation>超过 {length} m 电缆往返时间之和</translation>
    </message>
    <message>
        <source>is needed: slave {slave} is the one that is wired to the master</source>
        <translation>必须给出：与主站相连的是从站 {slave}</translation>
    </message>
    <message>
        <source>must be the number of a slave; there are {count}</source>
        <translation>必须是从站编号；共有 {count} 个</translation>
    </message>
    <message>
        <source>{port} is where slave {slave} is wired to the one before it</source>
        <translation>{port} 是从站 {slave} 与前一个从站的连接处</translation>
    </message>
    <message>
        <source>goes with behaviour = "sync-bridge" only</source>
        <translation>只适用于 behaviour = "sync-bridge"</translation>
    </message>
    <message>
        <source>either esi = an ESI file or sii = an EEPROM image names the device, relative to the scenario</source>
        <translation>由 esi = ESI 文件或 sii = EEPROM 映像指定设备，路径相对于场景文件</translation>
    </message>
    <message>
        <source>must be a text in quotation marks</source>
        <translation>必须是引号中的文本</translation>
    </message>
    <message>
        <source>must be true or false</source>
        <translation>必须是 true 或 false</translation>
    </message>
    <message>
        <source>must be a whole number</source>
        <translation>必须是整数</translation>
    </message>
    <message>
        <source>must be a whole number from {low} on</source>
        <translation>必须是不小于 {low} 的整数</translation>
    </message>
    <message>
        <source>must be a whole number from {low} to {high}</source>
        <translation>必须是 {low} 到 {high} 的整数</translation>
    </message>
    <message>
        <source>must be a number from {low} to {high}</source>
        <translation>必须是 {low} 到 {high} 的数</translation>
    </message>
    <message>
        <source>must be written as [{key}]</source>
        <translation>必须写作 [{key}]</translation>
    </message>
    <message>
        <source>must be written as [[{key}]]</source>
        <translation>必须写作 [[{key}]]</translation>
    </message>
    <message>
        <source>must be a list in brackets</source>
        <translation>必须是方括号中的列表</translation>
    </message>
    <message>
        <source>is not a key that {reason} has here</source>
        <translation>{reason}在此处没有这个键</translation>
    </message>
    <message>
        <source>a scenario</source>
        <translation>场景</translation>
    </message>
    <message>
        <source>a host profile</source>
        <translation>主机配置</translation>
    </message>
    <message>
        <source>the segment has no slaves</source>
        <translation>网段没有从站</translation>
    </message>
    <message>
        <source>no slave is where it hangs; check parent</source>
        <translation>它所接的位置没有从站；请检查 parent</translation>
    </message>
    <message>
        <source>the wiring puts slave {slave} at this place of the frame's way; list the slaves in frame order (ports D, B, C; what hangs between another entry than A and port A comes first)</source>
        <translation>按接线，帧路径的此处是从站 {slave}；请按帧的顺序列出从站（端口 D、B、C；入口不是 A 时，该入口与端口 A 之间的从站在前）</translation>
    </message>
    <message>
        <source>no frame reaches it; check parent and port</source>
        <translation>没有帧能到达它；请检查 parent 和 port</translation>
    </message>
    <message>
        <source>it has no slaves to simulate</source>
        <translation>其中没有可仿真的从站</translation>
    </message>
    <message>
        <source>not in {file}</source>
        <translation>不在 {file} 中</translation>
    </message>
    <message>
        <source>{file} is the EEPROM of {device}</source>
        <translation>{file} 是 {device} 的 EEPROM</translation>
    </message>
    <message>
        <source>{file} has {count}, counted from 0</source>
        <translation>{file} 有 {count} 个，从 0 开始计数</translation>
    </message>
    <message>
        <source>unknown option '{option}'; {forms}</source>
        <translation>未知选项“{option}”；{forms}</translation>
    </message>
    <message>
        <source>the controller moves the timer; set it to on first</source>
        <translation>控制器正在移动定时器；请先将其设为 on</translation>
    </message>
    <message>
        <source>its EEPROM, of which the capture holds {words} words</source>
        <translation>其 EEPROM，抓包中只有 {words} 个字</translation>
    </message>
    <message>
        <source>the place of the send time is not in the frame</source>
        <translation>发送时间的位置不在帧内</translation>
    </message>
    <message>
        <source>the slave does not answer{which}</source>
        <translation>从站没有应答{which}</translation>
    </message>
    <message>
        <source>the bus is offline; go online first</source>
        <translation>总线离线；请先联机</translation>
    </message>
    <message>
        <source>the configuration has only {count} slaves</source>
        <translation>配置中只有 {count} 个从站</translation>
    </message>
    <message>
        <source>it does not speak CoE</source>
        <translation>它不支持 CoE</translation>
    </message>
    <message>
        <source>its mailbox works from PREOP on, and it is in {state}; lead it there first</source>
        <translation>其邮箱从 PREOP 起工作，而它处于 {state}；请先将其切换到该状态</translation>
    </message>
    <message>
        <source>the bus is brought up again</source>
        <translation>总线正在重新启动</translation>
    </message>
    <message>
        <source>mailbox error {number}, {reason}</source>
        <translation>邮箱错误 {number}，{reason}</translation>
    </message>
    <message>
        <source>syntax of the mailbox header</source>
        <translation>邮箱头语法</translation>
    </message>
    <message>
        <source>the slave does not support this protocol</source>
        <translation>从站不支持该协议</translation>
    </message>
    <message>
        <source>the channel does not exist</source>
        <translation>该通道不存在</translation>
    </message>
    <message>
        <source>the slave does not support this service of the protocol</source>
        <translation>从站不支持该协议的这项服务</translation>
    </message>
    <message>
        <source>the protocol's header is wrong</source>
        <translation>协议头错误</translation>
    </message>
    <message>
        <source>the message is too short</source>
        <translation>报文太短</translation>
    </message>
    <message>
        <source>the slave is out of memory</source>
        <translation>从站内存不足</translation>
    </message>
    <message>
        <source>the length in the message is inconsistent</source>
        <translation>报文中的长度不一致</translation>
    </message>
    <message>
        <source>the slave is still busy with another service</source>
        <translation>从站仍在处理另一项服务</translation>
    </message>
    <message>
        <source>unknown mailbox error</source>
        <translation>未知邮箱错误</translation>
    </message>
    <message>
        <source>only answers to other requests come</source>
        <translation>只收到对其他请求的应答</translation>
    </message>
    <message>
        <source>the bus goes offline{which}</source>
        <translation>总线正在离线{which}</translation>
    </message>
    <message>
        <source>the content changed again after every word had been verified, at word 0x{word}</source>
        <translation>所有字校验之后，字 0x{word} 处的内容又发生了变化</translation>
    </message>
    <message>
        <source>words 0 to 7 would end up with the checksum 0x{has} where 0x{right} is right; write word 7 with them</source>
        <translation>字 0 到 7 的校验和将为 0x{has}，正确值是 0x{right}；请一并写入字 7</translation>
    </message>
    <message>
        <source>writing ended early{which}</source>
        <translation>写入提前结束{which}</translation>
    </message>
    <message>
        <source>they are {by} ns from the reference clock after {time} s, the sync window allows {limit} ns</source>
        <translation>{time} s 后它们与参考时钟相差 {by} ns，同步窗口允许 {limit} ns</translation>
    </message>
    <message>
        <source>{slave} {by} ns from the reference clock after {time} s, the sync window allows {limit} ns</source>
        <translation>{slave} {by} ns（与参考时钟之差，{time} s 后），同步窗口允许 {limit} ns</translation>
    </message>
    <message>
        <source>they did not stay within {limit} ns of the reference clock for {settle} ms in {time} s</source>
        <translation>{time} s 内它们从未在参考时钟 {limit} ns 范围内保持 {settle} ms</translation>
    </message>
    <message>
        <source>the reference clock has been away for {time} s</source>
        <translation>参考时钟已消失 {time} s</translation>
    </message>
    <message>
        <source>expected {wanted}, read {read}</source>
        <translation>应为 {wanted}，读到 {read}</translation>
    </message>
    <message>
        <source>{comment}: expected {wanted}, read {read}</source>
        <translation>{comment}：应为 {wanted}，读到 {read}</translation>
    </message>
    <message>
        <source>EoE result 0x{code}</source>
        <translation>EoE 结果 0x{code}</translation>
    </message>
    <message>
        <source>SoE error 0x{code}</source>
        <translation>SoE 错误 0x{code}</translation>
    </message>
    <message>
        <source>AoE error 0x{code}</source>
        <translation>AoE 错误 0x{code}</translation>
    </message>
    <message>
        <source>FoE error 0x{code}</source>
        <translation>FoE 错误 0x{code}</translation>
    </message>
    <message>
        <source>its header promises {promised} bytes of data, {count} bytes came with the header</source>
        <translation>其报文头声明 {promised} 字节数据，连同报文头共收到 {count} 字节</translation>
    </message>
    <message>
        <source>SDO command 0x{command} is not a request</source>
        <translation>SDO 命令 0x{command} 不是请求</translation>
    </message>
    <message>
        <source>it is not an SDO request</source>
        <translation>它不是 SDO 请求</translation>
    </message>
    <message>
        <source>service {number} does not exist</source>
        <translation>服务 {number} 不存在</translation>
    </message>
    <message>
        <source>type {number} does not exist</source>
        <translation>类型 {number} 不存在</translation>
    </message>
    <message>
        <source>opcode {number} does not exist</source>
        <translation>操作码 {number} 不存在</translation>
    </message>
    <message>
        <source>operation {number} does not exist</source>
        <translation>操作 {number} 不存在</translation>
    </message>
    <message>
        <source>{bytes} bytes, service {number}</source>
        <translation>{bytes} 字节，服务 {number}</translation>
    </message>
    <message>
        <source>"{text}" is no {type}</source>
        <translation>“{text}”不是 {type}</translation>
    </message>
    <message>
        <source>the object list is too short</source>
        <translation>对象列表太短</translation>
    </message>
    <message>
        <source>the object description is too short</source>
        <translation>对象描述太短</translation>
    </message>
    <message>
        <source>the description of 0x{index}:{sub} is too short</source>
        <translation>0x{index}:{sub} 的描述太短</translation>
    </message>
    <message>
        <source>it is CoE service {number}</source>
        <translation>它是 CoE 服务 {number}</translation>
    </message>
    <message>
        <source>opcode {number} is not a request</source>
        <translation>操作码 {number} 不是请求</translation>
    </message>
    <message>
        <source>the request is too short</source>
        <translation>请求太短</translation>
    </message>
    <message>
        <source>the error is too short</source>
        <translation>错误报文太短</translation>
    </message>
    <message>
        <source>opcode {number} is not a response</source>
        <translation>操作码 {number} 不是应答</translation>
    </message>
    <message>
        <source>category {category} at word 0x{word} {reason}</source>
        <translation>字 0x{word} 处的类别 {category} {reason}</translation>
    </message>
    <message>
        <source>of {words} words reaches beyond the image</source>
        <translation>（{words} 个字）超出映像范围</translation>
    </message>
    <message>
        <source>ends inside string {number} of {count}</source>
        <translation>在第 {number}/{count} 个字符串中途结束</translation>
    </message>
    <message>
        <source>is too short for general information</source>
        <translation>太短，容不下一般信息</translation>
    </message>
    <message>
        <source>holds a part of a SyncManager</source>
        <translation>只含 SyncManager 的一部分</translation>
    </message>
    <message>
        <source>ends inside PDO 0x{index}</source>
        <translation>在 PDO 0x{index} 中途结束</translation>
    </message>
    <message>
        <source>holds a part of a DC mode</source>
        <translation>只含 DC 模式的一部分</translation>
    </message>
    <message>
        <source>a pcap or pcapng capture; {words}</source>
        <translation>pcap 或 pcapng 抓包；{words}</translation>
    </message>
    <message>
        <source>a capture of Ethernet frames; this one holds {reason}</source>
        <translation>以太网帧的抓包；此文件包含 {reason}</translation>
    </message>
    <message>
        <source>a frame's time stamp of {time} s is outside of the years 1708 to 2292</source>
        <translation>某帧的时间戳 {time} s 超出 1708 至 2292 年的范围</translation>
    </message>
    <message>
        <source>a capture with EtherCAT frames and their answers</source>
        <translation>含 EtherCAT 帧及其应答的抓包</translation>
    </message>
    <message>
        <source>a capture of whole frames; {cut} of its {frames} were captured in part only</source>
        <translation>完整帧的抓包；其 {frames} 帧中有 {cut} 帧只抓到一部分</translation>
    </message>
    <message>
        <source>a recording that "synclinectl run --record" has written</source>
        <translation>由“synclinectl run --record”写入的记录</translation>
    </message>
    <message>
        <source>it is damaged or cut off ({words})</source>
        <translation>已损坏或被截断（{words}）</translation>
    </message>
    <message>
        <source>it has {count} slaves, the recording has {other}</source>
        <translation>它有 {count} 个从站，而记录有 {other} 个</translation>
    </message>
    <message>
        <source>a {kind} has at most {bytes} bytes</source>
        <translation>{kind}：最多 {bytes} 字节</translation>
    </message>
    <message>
        <source>{value} is none of {words}</source>
        <translation>{value} 不在 {words} 之中</translation>
    </message>
    <message>
        <source>slaves in the project: {count}, counted from 0</source>
        <translation>项目中的从站：{count} 个，从 0 开始计数</translation>
    </message>
    <message>
        <source>slave {position} has no such item</source>
        <translation>从站 {position} 没有该项</translation>
    </message>
    <message>
        <source>there is no such item</source>
        <translation>没有该项</translation>
    </message>
    <message>
        <source>list all with "synclinectl project keys"</source>
        <translation>用“synclinectl project keys”列出全部</translation>
    </message>
    <message>
        <source>a slave has the ports A to D</source>
        <translation>从站有端口 A 到 D</translation>
    </message>
    <message>
        <source>{value} is more than {devices} take: 0 to {most}</source>
        <translation>{value} 超过 {devices} 可接受的范围：0 到 {most}</translation>
    </message>
    <message>
        <source>{devices} set it themselves by the SYNC signals</source>
        <translation>{devices} 根据 SYNC 信号自行设置</translation>
    </message>
    <message>
        <source>{devices} do not have {type}</source>
        <translation>{devices} 没有 {type}</translation>
    </message>
    <message>
        <source>{devices} have pins 1 to {last}</source>
        <translation>{devices} 有引脚 1 到 {last}</translation>
    </message>
    <message>
        <source>{devices} have no function {number}</source>
        <translation>{devices} 没有功能 {number}</translation>
    </message>
    <message>
        <source>slave.{position}.{key}: {reason}</source>
        <translation>slave.{position}.{key}：{reason}</translation>
    </message>
    <message>
        <source>it is a folder</source>
        <translation>它是文件夹</translation>
    </message>
    <message>
        <source>the ENI goes to this file</source>
        <translation>ENI 要写入这个文件</translation>
    </message>
    <message>
        <source>it is a disk, not a file</source>
        <translation>它是磁盘，不是文件</translation>
    </message>
    <message>
        <source>it is a socket, not a file</source>
        <translation>它是套接字，不是文件</translation>
    </message>
    <message>
        <source>it is empty</source>
        <translation>为空</translation>
    </message>
    <message>
        <source>it has no rows</source>
        <translation>其中没有数据行</translation>
    </message>
    <message>
        <source>it holds no cyclic frame that came back</source>
        <translation>其中没有返回的周期帧</translation>
    </message>
    <message>
        <source>its times do not tell the cycles apart</source>
        <translation>其时间无法区分各个周期</translation>
    </message>
    <message>
        <source>its time {time} ns is no date of this century</source>
        <translation>其时间 {time} ns 不是本世纪的日期</translation>
    </message>
    <message>
        <source>a log of the master synchronisation, or the table that "synclinectl run --csv" writes</source>
        <translation>主站同步日志，或“synclinectl run --csv”写出的表格</translation>
    </message>
    <message>
        <source>its name must end in .png, .svg or .pdf</source>
        <translation>名称必须以 .png、.svg 或 .pdf 结尾</translation>
    </message>
    <message>
        <source>the view needs more room; leave the size out to have what suits it</source>
        <translation>该视图需要更大的空间；不指定尺寸则使用适合它的尺寸</translation>
    </message>
    <message>
        <source>it is no signal that can be shown here, such as dcm_error_ns or deviation_ns@1</source>
        <translation>这不是此处可以显示的信号，例如 dcm_error_ns 或 deviation_ns@1</translation>
    </message>
    <message>
        <source>no slave with SYNC0 whose arrivals are known</source>
        <translation>没有到达时刻已知的 SYNC0 从站</translation>
    </message>
    <message>
        <source>slaves in the recording: {count}, counted from 0</source>
        <translation>记录中的从站：{count} 个，从 0 开始计数</translation>
    </message>
    <message>
        <source>it holds nothing of the recording, which is {time} s long</source>
        <translation>其中不含记录的任何内容，记录长 {time} s</translation>
    </message>
    <message>
        <source>{file} has it no longer</source>
        <translation>{file} 中已没有它</translation>
    </message>
    <message>
        <source>its ESI files are missing here</source>
        <translation>这里缺少其 ESI 文件</translation>
    </message>
    <message>
        <source>Device: {reason}</source>
        <translation>设备：{reason}</translation>
    </message>
    <message>
        <source>Device {device}: {reason}</source>
        <translation>设备 {device}：{reason}</translation>
    </message>
    <message>
        <source>{attribute}="{text}" {reason}</source>
        <translation>{attribute}=“{text}”{reason}</translation>
    </message>
    <message>
        <source>is no rule</source>
        <translation>不是规则</translation>
    </message>
    <message>
        <source>is no mode</source>
        <translation>不是模式</translation>
    </message>
    <message>
        <source>is no scale</source>
        <translation>不是刻度类型</translation>
    </message>
    <message>
        <source>is nothing that has signals</source>
        <translation>不是具有信号的对象</translation>
    </message>
    <message>
        <source>is no pair of limits, the lower one first</source>
        <translation>不是一对上下限（下限在前）</translation>
    </message>
    <message>
        <source>the project in the recording has no view of that name</source>
        <translation>记录中的项目没有该名称的视图</translation>
    </message>
    <message>
        <source>it is no signal that can be drawn, such as lost_frames_total, al_status@1 or a variable's name</source>
        <translation>这不是可以绘制的信号，例如 lost_frames_total、al_status@1 或某个变量的名称</translation>
    </message>
    <message>
        <source>is no synchronisation type</source>
        <translation>不是同步类型</translation>
    </message>
    <message>
        <source>is no Ethernet address</source>
        <translation>不是以太网地址</translation>
    </message>
    <message>
        <source>the file holds {names}</source>
        <translation>文件包含 {names}</translation>
    </message>
    <message>
        <source>it defines entities of its own, which are not read</source>
        <translation>它定义了自己的实体，这些不会被读取</translation>
    </message>
    <message>
        <source>more than {most} elements</source>
        <translation>元素超过 {most} 个</translation>
    </message>
    <message>
        <source>it has {count} elements, attributes and comments of less than {bytes} bytes each, as no tool writes them</source>
        <translation>文件有 {count} 个元素、属性和注释，平均每个不足 {bytes} 字节，没有工具会这样写</translation>
    </message>
    <message>
        <source>an element with more than {most} attributes</source>
        <translation>某个元素的属性超过 {most} 个</translation>
    </message>
    <message>
        <source>more than {most} attributes</source>
        <translation>属性超过 {most} 个</translation>
    </message>
    <message>
        <source>elements are nested more than {most} deep</source>
        <translation>元素嵌套超过 {most} 层</translation>
    </message>
    <message>
        <source>{reason} (&lt;{element}&gt;)</source>
        <translation>{reason}（&lt;{element}&gt;）</translation>
    </message>
    <message>
        <source>an end tag does not match its start tag</source>
        <translation>结束标签与开始标签不匹配</translation>
    </message>
    <message>
        <source>an attribute is written wrongly</source>
        <translation>某个属性书写错误</translation>
    </message>
    <message>
        <source>an element is not complete</source>
        <translation>某个元素不完整</translation>
    </message>
    <message>
        <source>a text does not end</source>
        <translation>某段文本没有结束</translation>
    </message>
    <message>
        <source>a comment does not end</source>
        <translation>某个注释没有结束</translation>
    </message>
    <message>
        <source>the XML declaration is wrong</source>
        <translation>XML 声明错误</translation>
    </message>
    <message>
        <source>a &lt;!...&gt; section does not end</source>
        <translation>某个 &lt;!...&gt; 段没有结束</translation>
    </message>
    <message>
        <source>the file is empty</source>
        <translation>文件为空</translation>
    </message>
    <message>
        <source>the elements are nested too deeply</source>
        <translation>元素嵌套过深</translation>
    </message>
    <message>
        <source>the text ends too early or is no XML</source>
        <translation>文本过早结束或不是 XML</translation>
    </message>
    <message>
        <source>another window has it open ({who}): save under another name</source>
        <translation>另一个窗口已打开它（{who}）：请另存为其他名称</translation>
    </message>
    <message>
        <source>a mailbox error reply that cannot be read</source>
        <translation>无法读取的邮箱错误应答</translation>
    </message>
    <message>
        <source>the request is longer than the mailbox</source>
        <translation>请求比邮箱更长</translation>
    </message>
    <message>
        <source>its mailbox holds no message</source>
        <translation>其邮箱中没有报文</translation>
    </message>
    <message>
        <source>something else</source>
        <translation>其他内容</translation>
    </message>
    <message>
        <source>the file of a machine is a scenario of its own</source>
        <translation>机器的文件本身必须是独立的场景</translation>
    </message>
    <message>
        <source>the slaves are those of the machine</source>
        <translation>从站即为该机器的从站</translation>
    </message>
    <message>
        <source>stands in the file of the machine</source>
        <translation>应写在机器的文件中</translation>
    </message>
    <message>
        <source>{device} is not in the file</source>
        <translation>文件中没有 {device}</translation>
    </message>
    <message>
        <source>Before that, at {since}, {slave} had left the sync window as well ({deviation}, limit {limit}); {count} in all.</source>
        <translation>在此之前，{slave} 已在 {since} 超出同步窗口（{deviation}，限值 {limit}）；共 {count}。</translation>
    </message>
    <message>
        <source>Outputs are forced</source>
        <translation>输出被强制</translation>
    </message>
    <message>
        <source>No output is forced any more</source>
        <translation>不再有输出被强制</translation>
    </message>
    <message>
        <source>They stay at the value that somebody set by hand, whatever the application calculates.</source>
        <translation>它们保持人手设定的值，无论应用程序计算出什么。</translation>
    </message>
    <message>
        <source>Release them before the machine is left to itself.</source>
        <translation>在让机器自行运行之前请释放它们。</translation>
    </message>
    <message>
        <source>outputs are forced: {bits:# bit|# bits}</source>
        <translation>输出被强制：{bits} 位</translation>
    </message>
    <message>
        <source>no output is forced any more</source>
        <translation>不再有输出被强制</translation>
    </message>
    <message>
        <source>the process image has no such bits</source>
        <translation>过程映像没有这些位</translation>
    </message>
    <message>
        <source>the process image has no such variable of 1 to 64 bits: use its name, or SLAVE.ENTRY with the slave's position or name, e.g. "3.Position actual value"</source>
        <translation>过程映像中没有这样的 1 到 64 位变量：请使用变量名，或用 SLAVE.ENTRY 的形式给出从站的位置或名称及条目，例如“3.Position actual value”</translation>
    </message>
    <message>
        <source>it could be any of {names}</source>
        <translation>可能是以下任意一个：{names}</translation>
    </message>
    <message>
        <source>the network "{name}" runs on it: choose another link or take that one offline</source>
        <translation>网络“{name}”正在使用它：请选择其他连接，或使该网络离线</translation>
    </message>
    <message>
        <source>; not all words could be put back: write them again before power is switched off</source>
        <translation>；未能恢复全部字：断电前请重新写入</translation>
    </message>
    <message>
        <source>; the old content was put back</source>
        <translation>；已恢复原来的内容</translation>
    </message>
    <message>
        <source>block {number} holds other cycles than it says</source>
        <translation>块 {number} 所含的周期与其声明不符</translation>
    </message>
    <message>
        <source>its lists of watched variables are none</source>
        <translation>其监视变量列表无效</translation>
    </message>
    <message>
        <source>block {number} is none</source>
        <translation>块 {number} 无效</translation>
    </message>
    <message>
        <source>it has no cycle time</source>
        <translation>没有周期时间</translation>
    </message>
    <message>
        <source>it reads other words than it is asked for at word 0x{word}</source>
        <translation>在字 0x{word} 处读出的不是所要的字</translation>
    </message>
    <message>
        <source>it was away for a moment</source>
        <translation>它曾短暂消失</translation>
    </message>
    <message>
        <source>its slaves are not numbered in a row</source>
        <translation>其从站编号不连续</translation>
    </message>
    <message>
        <source>slave {position} is not another slave of the {count} on the bus</source>
        <translation>从站 {position} 不是总线上 {count} 个从站中的另一个</translation>
    </message>
    <message>
        <source>the sums of {signal} in block {number} are not those of its values</source>
        <translation>块 {number} 中 {signal} 的总和与其值不符</translation>
    </message>
    <message>
        <source>there are values of blocks that are not there</source>
        <translation>存在属于不存在的块的值</translation>
    </message>
    <message>
        <source>use sim:FILE[?virtual][&amp;seed=N][&amp;network=N], nic:NAME or replay:FILE</source>
        <translation>请用 sim:文件[?virtual][&amp;seed=N][&amp;network=N]、nic:名称 或 replay:文件</translation>
    </message>
    <message>
        <source>{signal} of block {number} cannot be read</source>
        <translation>块 {number} 的 {signal} 无法读取</translation>
    </message>
    <message>
        <source>expected {wanted}, found {found}</source>
        <translation>应为 {wanted}，实为 {found}</translation>
    </message>
    <message>
        <source>it is at position {position}</source>
        <translation>它位于位置 {position}</translation>
    </message>
    <message>
        <source>{limit} is the shortest cycle that {family} {devices} take</source>
        <translation>{limit} 是 {family} {devices}接受的最短周期</translation>
    </message>
    <message>
        <source>{limit} is the longest cycle that {family} {devices} take</source>
        <translation>{limit} 是 {family} {devices}接受的最长周期</translation>
    </message>
    <message>
        <source>{family} {devices} take multiples of {step}</source>
        <translation>{family} {devices}只接受 {step} 的整数倍</translation>
    </message>
    <message>
        <source>{family} {devices} need multiples of {step}; {otherwise}</source>
        <translation>{family} {devices}需要 {step} 的整数倍；{otherwise}</translation>
    </message>
    <message>
        <source>{limit} is the shortest cycle that its object 0x1C32:05 names</source>
        <translation>{limit} 是其对象 0x1C32:05 给出的最短周期</translation>
    </message>
    <message>
        <source>its operation mode {mode} has a SYNC0 every {cycle}, which is neither a multiple nor a part of it</source>
        <translation>其运行模式 {mode} 的 SYNC0 每 {cycle} 到来一次，既不是该周期的整数倍也不是其整数分之一</translation>
    </message>
    <message>
        <source>its operation mode {mode} divides the cycle by {divisor}, which leaves a rest</source>
        <translation>其运行模式 {mode} 将周期除以 {divisor}，不能整除</translation>
    </message>
    <message>
        <source>its object 0x60C2 (interpolation time) cannot express it</source>
        <translation>其对象 0x60C2（插补时间）无法表示该周期</translation>
    </message>
    <message>
        <source>the bus cycle is {shortest} to {longest}</source>
        <translation>总线周期为 {shortest} 至 {longest}</translation>
    </message>
    <message>
        <source>the cyclic frames take {time} of wire time</source>
        <translation>循环帧的线路时间为 {time}</translation>
    </message>
    <message>
        <source>the cyclic frames take {time} of wire time and about {travel} through the slaves</source>
        <translation>循环帧的线路时间为 {time}，经过各从站约需 {travel}</translation>
    </message>
    <message>
        <source>it should be the first on the bus</source>
        <translation>它应是总线上的第一个</translation>
    </message>
    <message>
        <source>it should follow {slave}</source>
        <translation>它应在 {slave} 之后</translation>
    </message>
    <message>
        <source>it should hang at port {port} of {slave}</source>
        <translation>它应接在 {slave} 的端口 {port} 上</translation>
    </message>
    <message>
        <source>the file is gone: it, or its folder, was deleted or moved while it was written</source>
        <translation>文件已不存在：写入期间它或其文件夹被删除或移动</translation>
    </message>
    <message>
        <source>only {left} MiB are left on the disk; the black box is whole up to here</source>
        <translation>磁盘只剩 {left} MiB；黑匣子到此为止是完整的</translation>
    </message>
    <message>
        <source>another program writes to a black box of this name: use another one</source>
        <translation>另一个程序正在写入同名的黑匣子：请使用其他名称</translation>
    </message>
    <message>
        <source>the disk has {left} MiB left, a black box needs {needed} MiB with what is kept free</source>
        <translation>磁盘剩余 {left} MiB，黑匣子连同需要留空的部分需要 {needed} MiB</translation>
    </message>
    <message>
        <source>A SYNC time that neither registers nor ENI hold</source>
        <translation>寄存器和 ENI 都放不下的 SYNC 时间</translation>
    </message>
    <message>
        <source>Choose a shorter time.</source>
        <translation>请选择较短的时间。</translation>
    </message>
    <message>
        <source>The cycle of SYNC0 is {time}; registers and ENI hold up to {most}.</source>
        <translation>SYNC0 的周期为 {time}；寄存器和 ENI 最多容纳 {most}。</translation>
    </message>
    <message>
        <source>SYNC1 would come {time} after SYNC0; registers and ENI hold up to {most}.</source>
        <translation>SYNC1 将在 SYNC0 之后 {time} 到来；寄存器和 ENI 最多容纳 {most}。</translation>
    </message>
    <message>
        <source>The shift of SYNC0 is {time}; registers and ENI hold up to {most}.</source>
        <translation>SYNC0 的偏移为 {time}；寄存器和 ENI 最多容纳 {most}。</translation>
    </message>
    <message>
        <source>The shift of SYNC0 is longer than its cycle</source>
        <translation>SYNC0 的偏移长于其周期</translation>
    </message>
    <message>
        <source>Choose a shift within the cycle of SYNC0.</source>
        <translation>请选择 SYNC0 周期以内的偏移。</translation>
    </message>
    <message>
        <source>SYNC0 is shifted by {shift}, its cycle is {cycle}: the shift counts modulo the cycle, and SYNC0 starts later.</source>
        <translation>SYNC0 偏移 {shift}，其周期为 {cycle}：偏移按周期取模计算，SYNC0 会更晚开始。</translation>
    </message>
    <message>
        <source>Times of a SYNC signal that does not come</source>
        <translation>为不会出现的 SYNC 信号设置了时间</translation>
    </message>
    <message>
        <source>Choose an operation mode with that signal, or set its times back to auto.</source>
        <translation>请选择带有该信号的运行模式，或将其时间恢复为自动。</translation>
    </message>
    <message>
        <source>{file} is what {what} reads and would be lost; name another file</source>
        <translation>{file} 是 {what} 读取的文件，会因此丢失；请指定另一个文件</translation>
    </message>
    <message>
        <source>{signal} is set, and the operation mode &quot;{mode}&quot; does not generate it: what is set has no effect.</source>
        <translation>已设置 {signal}，但运行模式“{mode}”不产生该信号：该设置不起作用。</translation>
    </message>
    <message>
        <source>{signal} is set, and distributed clocks are off for this slave: what is set has no effect.</source>
        <translation>已设置 {signal}，但该从站的分布式时钟已关闭：该设置不起作用。</translation>
    </message>
    <message>
        <source>Outputs stay as they are when frames stop</source>
        <translation>帧停止时输出保持不变</translation>
    </message>
    <message>
        <source>Let the process data watchdog guard them, unless something else stops the machine.</source>
        <translation>除非有其他手段使机器停止，否则请让过程数据看门狗监视输出。</translation>
    </message>
    <message>
        <source>The process data watchdog is switched off: outputs keep their last values when frames stop.</source>
        <translation>过程数据看门狗已关闭：帧停止时输出保持最后的值。</translation>
    </message>
    <message>
        <source>Outputs do not trigger the process data watchdog: they keep their last values when frames stop.</source>
        <translation>输出不触发过程数据看门狗：帧停止时输出保持最后的值。</translation>
    </message>
    <message>
        <source>Two slaves are known by the same alias</source>
        <translation>两个从站以相同的别名识别</translation>
    </message>
    <message>
        <source>Give each of them an alias of its own, here and in its EEPROM.</source>
        <translation>请为每个从站分配各自的别名，此处和其 EEPROM 中都要设置。</translation>
    </message>
    <message>
        <source>It is known by the alias {alias}, and so is {slave}: nobody could tell if they were exchanged.</source>
        <translation>它以别名 {alias} 识别，{slave} 也是如此：即使两者互换也无法察觉。</translation>
    </message>
    <message>
        <source>A device with outputs gets none</source>
        <translation>带输出的设备没有得到输出</translation>
    </message>
    <message>
        <source>Assign a PDO, if the device is to be told anything.</source>
        <translation>如果需要向设备发送数据，请分配一个 PDO。</translation>
    </message>
    <message>
        <source>The device has outputs, and no PDO is assigned for them: it gets no set values.</source>
        <translation>设备有输出，但没有为其分配 PDO：它得不到设定值。</translation>
    </message>
    <message>
        <source>Exchanged with each other they pass the check of their aliases, and get each other&apos;s outputs</source>
        <translation>两者互换后仍能通过别名检查，并得到对方的输出</translation>
    </message>
    <message>
        <source>Give each slave an alias of its own, in the file and in the device</source>
        <translation>为每个从站分配各自的别名，文件和设备中都要设置</translation>
    </message>
    <message>
        <source>its alias is checked to be {alias}, and so is that of {slave}</source>
        <translation>其别名被检查是否为 {alias}，{slave} 的别名也是如此</translation>
    </message>
    <message>
        <source>{count} of the clocks do not keep what is written to 0x0920 and 0x0928, the first one reads {read} in {register} instead of {written}</source>
        <translation>{count} 个时钟不保留写入 0x0920 和 0x0928 的值，第一个在 {register} 中读到 {read} 而不是 {written}</translation>
    </message>
    <message>
        <source>Frames of other programs reach the bus</source>
        <translation>其他程序的帧到达总线</translation>
    </message>
    <message>
        <source>Each takes the wire from the master's frames, which come later by its length.</source>
        <translation>每一帧都占用主站帧的线路，使其按该帧长度延后。</translation>
    </message>
    <message>
        <source>Give the adapter no IP address and no other protocol (DHCP, IPv6, LLDP, a network manager), and put no switch with other devices between the host and the first slave.</source>
        <translation>不要给适配器分配 IP 地址或其他协议（DHCP、IPv6、LLDP、网络管理器），也不要在主机与第一个从站之间放置连接其他设备的交换机。</translation>
    </message>
    <message>
        <source>{slave} has counted {count:# frame|# frames} that it could not process (0x030C) and that were not damaged, from {since} on: they are none of the master's.</source>
        <translation>{slave} 从 {since} 起计数到 {count:# 个帧|# 个帧} 无法处理（0x030C）且未损坏：它们不是主站的帧。</translation>
    </message>
    <message>
        <source>"{text}" is read as {value}</source>
        <translation>"{text}" 按 {value} 读取</translation>
    </message>
    <message>
        <source>"{text}" has an odd number of digits; a zero is put in front</source>
        <translation>"{text}" 的位数为奇数；在前面补零</translation>
    </message>
    <message>
        <source>hexadecimal numbers of this file begin with 0x instead of #x</source>
        <translation>此文件的十六进制数以 0x 开头，而不是 #x</translation>
    </message>
    <message>
        <source>the text is not UTF-8, though it should be; read as {encoding}</source>
        <translation>文本不是 UTF-8，尽管应当是；按 {encoding} 读取</translation>
    </message>
    <message>
        <source>the byte 0x{byte} is no letter of the encoding {name}; read as a control character</source>
        <translation>字节 0x{byte} 不是编码 {name} 中的字符；按控制字符读取</translation>
    </message>
    <message>
        <source>it names the encoding {name}, but its letters stand alone as Western ones do; read as {encoding}</source>
        <translation>它声明的编码是 {name}，但其字符像西文那样单个出现；按 {encoding} 读取</translation>
    </message>
    <message>
        <source>it names the encoding {name}, but its letters come in pairs as those of GB 2312; read as {encoding}</source>
        <translation>它声明的编码是 {name}，但其字符像 GB 2312 那样成对出现；按 {encoding} 读取</translation>
    </message>
    <message>
        <source>Transition is missing; taken for PS</source>
        <translation>缺少 Transition；按 PS 处理</translation>
    </message>
    <message>
        <source>Name is missing; taken from Desc</source>
        <translation>缺少 Name；取自 Desc</translation>
    </message>
    <message>
        <source>MaxInstances is missing; taken for 1</source>
        <translation>缺少 MaxInstances；按 1 处理</translation>
    </message>
    <message>
        <source>BitLen is missing; {bits} bits by the data type {type}</source>
        <translation>缺少 BitLen；按数据类型 {type} 为 {bits} 位</translation>
    </message>
    <message>
        <source>the use "{use}" is not known; the FMMU counts as free</source>
        <translation>未知用途 "{use}"；该 FMMU 视为空闲</translation>
    </message>
    <message>
        <source>the use "{use}" is not known; taken from the control byte 0x{control}</source>
        <translation>未知用途 "{use}"；取自控制字节 0x{control}</translation>
    </message>
    <message>
        <source>the PDO 0x{index} excludes itself; that is left out</source>
        <translation>PDO 0x{index} 排除其自身；此项被忽略</translation>
    </message>
    <message>
        <source>the rule "{rule}" for {attribute} is not known</source>
        <translation>{attribute} 的规则 "{rule}" 未知</translation>
    </message>
    <message>
        <source>{attribute} "{text}" is no number of 32 bits and is left out</source>
        <translation>{attribute} "{text}" 不是 32 位数，已略去</translation>
    </message>
    <message>
        <source>the picture is no hexadecimal data and is left out</source>
        <translation>图片不是十六进制数据，已略去</translation>
    </message>
    <message>
        <source>the dictionary has too many entries; the rest is left out</source>
        <translation>对象字典条目过多；其余已略去</translation>
    </message>
    <message>
        <source>the data type is left out: {error}</source>
        <translation>数据类型已略去：{error}</translation>
    </message>
    <message>
        <source>the object is left out: {error}</source>
        <translation>对象已略去：{error}</translation>
    </message>
    <message>
        <source>the module is left out: {error}</source>
        <translation>模块已略去：{error}</translation>
    </message>
    <message>
        <source>the dictionary is left out: {error}</source>
        <translation>对象字典已略去：{error}</translation>
    </message>
    <message>
        <source>the file is left out: {error}</source>
        <translation>文件已略去：{error}</translation>
    </message>
    <message>
        <source>Device is left out: {error}</source>
        <translation>一个设备已略去：{error}</translation>
    </message>
    <message>
        <source>Device {device} is left out: {error}</source>
        <translation>设备 {device} 已略去：{error}</translation>
    </message>
    <message>
        <source>"{name}" is another file, which is not read here</source>
        <translation>"{name}" 是另一个文件，此处不读取</translation>
    </message>
    <message>
        <source>the dictionary "{name}" is in another file, which is not read here</source>
        <translation>对象字典 "{name}" 在另一个文件中，此处不读取</translation>
    </message>
    <message>
        <source>"{name}" is no dictionary file: its root is &lt;{root}&gt;, not &lt;EtherCATDict&gt;</source>
        <translation>"{name}" 不是对象字典文件：其根元素是 &lt;{root}&gt;，而不是 &lt;EtherCATDict&gt;</translation>
    </message>
    <message>
        <source>no file describes the module 0x{module} of the slot "{slot}"</source>
        <translation>没有文件描述插槽 "{slot}" 的模块 0x{module}</translation>
    </message>
    <message>
        <source>the device catalogue is made again: {reason}</source>
        <translation>设备目录将重新建立：{reason}</translation>
    </message>
    <message>
        <source>it was damaged: {words}</source>
        <translation>它已损坏：{words}</translation>
    </message>
    <message>
        <source>it is of version {version}, this program uses version {own}</source>
        <translation>其版本为 {version}，本程序使用版本 {own}</translation>
    </message>
    <message>
        <source>the ESI files are read anew each time: {error}</source>
        <translation>每次都重新读取 ESI 文件：{error}</translation>
    </message>
    <message>
        <source>{place}: {reason}</source>
        <translation>{place}：{reason}</translation>
    </message>
    <message>
        <source>{sentence}.</source>
        <translation>{sentence}。</translation>
    </message>
    <message>
        <source>{sentence} {next}</source>
        <translation>{sentence}{next}</translation>
    </message>
    <message>
        <source>: {reason}</source>
        <translation>: {reason}</translation>
    </message>
    <message>
        <source>{code} ({meaning})</source>
        <translation>{code}（{meaning}）</translation>
    </message>
    <message>
        <source>Watched for</source>
        <translation>观察时长</translation>
    </message>
    <message>
        <source>State of the master</source>
        <translation>主站状态</translation>
    </message>
    <message>
        <source>Slaves against their reference clock</source>
        <translation>从站相对参考时钟</translation>
    </message>
    <message>
        <source>Reference clock against the master</source>
        <translation>参考时钟相对主站</translation>
    </message>
    <message>
        <source>SM2 events missed</source>
        <translation>错过的 SM2 事件</translation>
    </message>
    <message>
        <source>Frames lost</source>
        <translation>丢失的帧</translation>
    </message>
    <message>
        <source>Cycles of a slave were not finished because frames came too soon</source>
        <translation>帧来得太早，从站未能完成周期</translation>
    </message>
    <message>
        <source>Cycles with another working counter than expected</source>
        <translation>工作计数器与预期不符的周期</translation>
    </message>
    <message>
        <source>Cycles left out by the host</source>
        <translation>主机跳过的周期</translation>
    </message>
    <message>
        <source>Disturbances</source>
        <translation>干扰</translation>
    </message>
    <message>
        <source>Findings</source>
        <translation>发现</translation>
    </message>
    <message>
        <source>kept</source>
        <translation>满足</translation>
    </message>
    <message>
        <source>NOT KEPT</source>
        <translation>不满足</translation>
    </message>
    <message>
        <source>not judged</source>
        <translation>未评判</translation>
    </message>
    <message>
        <source>as long as it was</source>
        <translation>实际时长</translation>
    </message>
    <message>
        <source>OP at the end</source>
        <translation>结束时为 OP</translation>
    </message>
    <message>
        <source>in sync throughout</source>
        <translation>始终同步</translation>
    </message>
    <message>
        <source>no error, no warning</source>
        <translation>无错误、无警告</translation>
    </message>
    <message>
        <source>never: it was not in sync in OP</source>
        <translation>从未：在 OP 中未曾同步</translation>
    </message>
    <message>
        <source>unknown: a slave does not answer, or it is not told</source>
        <translation>未知：有从站无应答，或没有记录</translation>
    </message>
    <message>
        <source>not counted: it was never armed</source>
        <translation>未计数：从未启用统计</translation>
    </message>
    <message>
        <source>no slave has a counter that is known</source>
        <translation>没有从站具有已知的计数器</translation>
    </message>
    <message>
        <source>not told</source>
        <translation>没有记录</translation>
    </message>
</context>
</TS>
