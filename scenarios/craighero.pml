<?xml version="1.0" encoding="UTF-8"?>
<physicalModel name="craighero" unit="mm" axes="RAS" fineness="1" nrOfAtoms="113" nrOfExclusiveComponents="3" nrOfInformativeComponents="13" nrOfCells="384">
<atoms>
<structuralComponent name="particles">
<nrOfStructures value="113" />
<atom>
<atomProperties index="0" x="-0.8672078605829904" y="18.879662471947444" z="-110.91448490700459" />
</atom>
<atom>
<atomProperties index="1" x="148.45135971630472" y="24.561564667977493" z="-103.39421540093709" />
</atom>
<atom>
<atomProperties index="2" x="126.1403492900988" y="71.83960892299797" z="-100.98413907195622" />
</atom>
<atom>
<atomProperties index="3" x="69.95819563429887" y="104.6144873261481" z="-101.90621241181141" />
</atom>
<atom>
<atomProperties index="4" x="-4.860844761524929" y="114.96357687328062" z="-105.67605769332349" />
</atom>
<atom>
<atomProperties index="5" x="-79.17707272969261" y="99.2496423251645" z="-109.96967151312337" />
</atom>
<atom>
<atomProperties index="6" x="-131.29289496256067" y="61.86543379370246" z="-114.38570039690373" />
</atom>
<atom>
<atomProperties index="7" x="-148.7651753878186" y="13.915860402820645" z="-118.11247845163669" />
</atom>
<atom>
<atomProperties index="8" x="-127.35049438196968" y="-33.245933375796284" z="-120.67504054289245" />
</atom>
<atom>
<atomProperties index="9" x="-71.97025256687307" y="-67.45188281730626" z="-120.06100176723413" />
</atom>
<atom>
<atomProperties index="10" x="3.4842301369917643" y="-78.53127980714041" z="-116.08009100088569" />
</atom>
<atom>
<atomProperties index="11" x="78.40705937045439" y="-62.44727563043036" z="-111.6476631053234" />
</atom>
<atom>
<atomProperties index="12" x="131.26068407993162" y="-24.370033455393326" z="-107.33697110575437" />
</atom>
<atom>
<atomProperties index="13" x="147.74468746810558" y="19.790533300990454" z="-35.153080220573976" />
</atom>
<atom>
<atomProperties index="14" x="123.19895962722534" y="66.00132578767791" z="-31.209679873313302" />
</atom>
<atom>
<atomProperties index="15" x="65.26591984863103" y="96.55448897194036" z="-16.776893082588533" />
</atom>
<atom>
<atomProperties index="16" x="-11.33830113561375" y="108.12668864341002" z="2.5529305749679017" />
</atom>
<atom>
<atomProperties index="17" x="-85.02760875899662" y="94.9318755442659" z="-19.289914162347515" />
</atom>
<atom>
<atomProperties index="18" x="-136.00746195075106" y="57.31451938554246" z="-37.54906256348206" />
</atom>
<atom>
<atomProperties index="19" x="-152.61306146651953" y="8.707679259456052" z="-42.55416308576332" />
</atom>
<atom>
<atomProperties index="20" x="-130.81000053803453" y="-38.06717124477003" z="-42.07495616275388" />
</atom>
<atom>
<atomProperties index="21" x="-75.41580128535493" y="-71.8288936363139" z="-35.88215921311076" />
</atom>
<atom>
<atomProperties index="22" x="1.1365267863471615" y="-83.0839951547766" z="-30.034721712860467" />
</atom>
<atom>
<atomProperties index="23" x="77.42365475861573" y="-67.98258018111285" z="-31.493559344792185" />
</atom>
<atom>
<atomProperties index="24" x="131.2295794966404" y="-30.1520504039493" z="-34.96453362773247" />
</atom>
<atom>
<atomProperties index="25" x="146.5885226648766" y="15.484337657201396" z="34.006573355403994" />
</atom>
<atom>
<atomProperties index="26" x="118.86197778735364" y="59.33224827908814" z="37.97117547706497" />
</atom>
<atom>
<atomProperties index="27" x="61.52454279892168" y="89.62761045400362" z="66.8585415014572" />
</atom>
<atom>
<atomProperties index="28" x="-16.002113629215568" y="104.37289612596082" z="110.91060567528486" />
</atom>
<atom>
<atomProperties index="29" x="-91.37503757845104" y="92.39711888872665" z="72.1412440595377" />
</atom>
<atom>
<atomProperties index="30" x="-140.50815401528874" y="52.186737664304715" z="40.530737024010335" />
</atom>
<atom>
<atomProperties index="31" x="-155.55249413962517" y="2.6980179265221764" z="33.49718297840512" />
</atom>
<atom>
<atomProperties index="32" x="-133.83078831021166" y="-43.22414809077972" z="36.86572328011686" />
</atom>
<atom>
<atomProperties index="33" x="-78.23640775257586" y="-77.60079909383829" z="49.571867303506934" />
</atom>
<atom>
<atomProperties index="34" x="-0.07746134277329848" y="-89.18312353218839" z="57.77376818085855" />
</atom>
<atom>
<atomProperties index="35" x="77.53305264180257" y="-72.78853712823383" z="49.48408885818142" />
</atom>
<atom>
<atomProperties index="36" x="132.00909763538925" y="-34.79699304137846" z="38.447937645061934" />
</atom>
<atom>
<atomProperties index="37" x="143.0966737033779" y="12.155692935608336" z="103.59069431994067" />
</atom>
<atom>
<atomProperties index="38" x="113.68532879565231" y="52.50557819857906" z="105.01861445798508" />
</atom>
<atom>
<atomProperties index="39" x="63.36055021148912" y="88.4320561929455" z="150.6933545027046" />
</atom>
<atom>
<atomProperties index="40" x="-17.43005850412365" y="90.48126125807237" z="220.3951924552508" />
</atom>
<atom>
<atomProperties index="41" x="-98.73696710902239" y="94.740783164995" z="164.35505556500456" />
</atom>
<atom>
<atomProperties index="42" x="-142.90387484739526" y="45.86622396160905" z="121.04497837899319" />
</atom>
<atom>
<atomProperties index="43" x="-154.44115554446682" y="-4.651283878647204" z="109.7444035819515" />
</atom>
<atom>
<atomProperties index="44" x="-138.40480361910113" y="-49.076228137732514" z="117.07233493527902" />
</atom>
<atom>
<atomProperties index="45" x="-76.48950931336702" y="-86.21266982578555" z="137.36436275526884" />
</atom>
<atom>
<atomProperties index="46" x="4.054065146852688" y="-87.8575201739803" z="148.84078031097164" />
</atom>
<atom>
<atomProperties index="47" x="77.4457084198216" y="-79.38052212829302" z="130.34828642823217" />
</atom>
<atom>
<atomProperties index="48" x="134.5130306334514" y="-37.354527639780216" z="112.901497745801" />
</atom>
<atom>
<atomProperties index="49" x="139.21981451682072" y="12.447198015565762" z="163.84380323961938" />
</atom>
<atom>
<atomProperties index="50" x="112.26605676476724" y="50.387111185898604" z="164.8116389170815" />
</atom>
<atom>
<atomProperties index="51" x="61.468444527755096" y="80.94941584661404" z="192.84050837025342" />
</atom>
<atom>
<atomProperties index="52" x="-17.136071474123895" y="80.52758013882696" z="232.9858042178871" />
</atom>
<atom>
<atomProperties index="53" x="-93.04759298947977" y="81.96742867903139" z="198.58009530160243" />
</atom>
<atom>
<atomProperties index="54" x="-142.2919340864069" y="43.19534972218025" z="171.42191224957958" />
</atom>
<atom>
<atomProperties index="55" x="-152.83657278121953" y="-10.016326697975005" z="164.12915073688904" />
</atom>
<atom>
<atomProperties index="56" x="-135.64476428847345" y="-58.85288510776717" z="170.38842529597565" />
</atom>
<atom>
<atomProperties index="57" x="-68.53876611406872" y="-84.03936824459154" z="183.11810415113771" />
</atom>
<atom>
<atomProperties index="58" x="3.6796724297157257" y="-76.39928092892035" z="183.7493120414852" />
</atom>
<atom>
<atomProperties index="59" x="75.7336213917795" y="-74.6147212710703" z="187.91991533897735" />
</atom>
<atom>
<atomProperties index="60" x="131.01677105800331" y="-37.19618182083205" z="174.15810111724684" />
</atom>
<atom>
<atomProperties index="61" x="133.65930971514567" y="14.124048110667838" z="231.14955337525268" />
</atom>
<atom>
<atomProperties index="62" x="112.4070542546493" y="51.98610752727904" z="229.88778795619547" />
</atom>
<atom>
<atomProperties index="63" x="57.0907199992725" y="72.22999052682931" z="226.85127589642033" />
</atom>
<atom>
<atomProperties index="64" x="-17.191883204204043" y="75.51021543949577" z="234.2539565374403" />
</atom>
<atom>
<atomProperties index="65" x="-88.52024219612059" y="67.19319844221816" z="222.83533644788628" />
</atom>
<atom>
<atomProperties index="66" x="-142.87095712447507" y="42.09735890528163" z="220.80297899570633" />
</atom>
<atom>
<atomProperties index="67" x="-147.45398244631647" y="-10.840683729525248" z="215.27087100166696" />
</atom>
<atom>
<atomProperties index="68" x="-136.33994291792226" y="-61.56307170893982" z="221.78901461334806" />
</atom>
<atom>
<atomProperties index="69" x="-62.68018209004031" y="-82.06152725878577" z="221.16588206133054" />
</atom>
<atom>
<atomProperties index="70" x="4.446024740503208" y="-64.5789629495769" z="209.09866893551933" />
</atom>
<atom>
<atomProperties index="71" x="64.39185508688968" y="-67.91318234013713" z="245.18657800427323" />
</atom>
<atom>
<atomProperties index="72" x="126.18838075168065" y="-38.432791362899444" z="247.63379267739123" />
</atom>
<atom>
<atomProperties index="73" x="109.36978937239023" y="15.273044387060724" z="283.2603742275423" />
</atom>
<atom>
<atomProperties index="74" x="82.44328307576482" y="50.88181156854367" z="274.70419711962353" />
</atom>
<atom>
<atomProperties index="75" x="37.50506948112259" y="57.75925925539244" z="255.3692198228814" />
</atom>
<atom>
<atomProperties index="76" x="-19.396008510429137" y="64.6211670772487" z="243.77434697184802" />
</atom>
<atom>
<atomProperties index="77" x="-78.33031758852822" y="55.692975403401604" z="242.71321918178802" />
</atom>
<atom>
<atomProperties index="78" x="-124.26558052125192" y="35.625192790640305" z="257.9942617986415" />
</atom>
<atom>
<atomProperties index="79" x="-142.60059880709397" y="-8.164251657128187" z="262.4825016273222" />
</atom>
<atom>
<atomProperties index="80" x="-115.94154212037763" y="-57.84859491949539" z="266.1604320796045" />
</atom>
<atom>
<atomProperties index="81" x="-57.35528829143151" y="-78.91420829272703" z="259.4647867927208" />
</atom>
<atom>
<atomProperties index="82" x="-16.64371585076796" y="-49.687557687184466" z="236.89069613702935" />
</atom>
<atom>
<atomProperties index="83" x="30.514883110107636" y="-31.05678864742323" z="247.40720815157087" />
</atom>
<atom>
<atomProperties index="84" x="77.33476150744002" y="-22.304321070666877" z="276.93689189979943" />
</atom>
<atom>
<atomProperties index="85" x="63.42408937688321" y="11.362386618842486" z="289.36069143971014" />
</atom>
<atom>
<atomProperties index="86" x="20.638706611456687" y="50.4009795543333" z="265.8677495320147" />
</atom>
<atom>
<atomProperties index="87" x="-67.70904213949194" y="44.139388462804924" z="252.93252177086052" />
</atom>
<atom>
<atomProperties index="88" x="-112.15456408801738" y="-1.1653028602448907" z="282.92311758871534" />
</atom>
<atom>
<atomProperties index="89" x="-60.661720271566054" y="-50.77064524556701" z="274.49857532498606" />
</atom>
<atom>
<atomProperties index="90" x="14.926743423242232" y="-27.257929248476312" z="244.24212149530962" />
</atom>
<atom>
<atomProperties index="91" x="-28.617510527278352" y="5.3601562842263535" z="261.6257741240028" />
</atom>
<atom>
<atomProperties index="92" x="134.26176291967053" y="32.047744263648724" z="348.0266799225307" />
</atom>
<atom>
<atomProperties index="93" x="98.6074959875484" y="74.17158261593008" z="336.4931988862028" />
</atom>
<atom>
<atomProperties index="94" x="39.570942963741345" y="95.66352165833736" z="325.32976661311073" />
</atom>
<atom>
<atomProperties index="95" x="-34.71910377869309" y="96.73643012554085" z="321.68229023418075" />
</atom>
<atom>
<atomProperties index="96" x="-101.28728215201112" y="72.13769270222626" z="312.25852057055044" />
</atom>
<atom>
<atomProperties index="97" x="-142.41980735308965" y="30.35944516939308" z="314.44242156202506" />
</atom>
<atom>
<atomProperties index="98" x="-169.08634875919142" y="-11.581478561159514" z="317.9126464968229" />
</atom>
<atom>
<atomProperties index="99" x="-133.30122244615904" y="-61.36518982019813" z="318.8889101772516" />
</atom>
<atom>
<atomProperties index="100" x="-78.50191145773313" y="-82.17823873068343" z="312.8230074306587" />
</atom>
<atom>
<atomProperties index="101" x="-7.326612106848231" y="-91.52038759901116" z="319.4493323472363" />
</atom>
<atom>
<atomProperties index="102" x="57.77615903461967" y="-46.99332540164791" z="338.1360159926658" />
</atom>
<atom>
<atomProperties index="103" x="104.46231908613113" y="-15.231087179935146" z="355.710608873841" />
</atom>
<atom>
<atomProperties index="104" x="61.27026114747205" y="33.53275126928067" z="417.6340092214973" />
</atom>
<atom>
<atomProperties index="105" x="27.15436023965569" y="68.8836941673063" z="401.89446644222113" />
</atom>
<atom>
<atomProperties index="106" x="-40.50737715076051" y="72.8654629778718" z="393.2127326183218" />
</atom>
<atom>
<atomProperties index="107" x="-99.41239530427981" y="42.08479065660712" z="387.63656724036287" />
</atom>
<atom>
<atomProperties index="108" x="-118.57891488780096" y="-5.138242984071484" z="390.2301833571123" />
</atom>
<atom>
<atomProperties index="109" x="-86.35613723513752" y="-43.248032545613846" z="389.61680934341894" />
</atom>
<atom>
<atomProperties index="110" x="-22.326952434506907" y="-51.05636651180912" z="400.6062308650759" />
</atom>
<atom>
<atomProperties index="111" x="37.74541142495355" y="-16.497323143785284" z="415.97928575398936" />
</atom>
<atom>
<atomProperties index="112" x="-35.892378381024734" y="14.887241832080003" z="429.90859443374075" />
</atom>
</structuralComponent>
</atoms>
<exclusiveComponents>
<multiComponent name="Exclusive Components">
<multiComponent name="Enclosed Volumes">
<structuralComponent name="abdomen" mode="WIREFRAME_AND_SURFACE" incompressibility="true">
<nrOfStructures value="180" />
<cell>
<cellProperties type="TRIANGLE" />
<nrOfStructures value="3" />
<atomRef index="1" />
<atomRef index="0" />
<atomRef index="2" />
</cell>
<cell>
<cellProperties type="TRIANGLE" />
<nrOfStructures value="3" />
<atomRef index="2" />
<atomRef index="0" />
<atomRef index="3" />
</cell>
<cell>
<cellProperties type="TRIANGLE" />
<nrOfStructures value="3" />
<atomRef index="3" />
<atomRef index="0" />
<atomRef index="4" />
</cell>
<cell>
<cellProperties type="TRIANGLE" />
<nrOfStructures value="3" />
<atomRef index="4" />
<atomRef index="0" />
<atomRef index="5" />
</cell>
<cell>
<cellProperties type="TRIANGLE" />
<nrOfStructures value="3" />
<atomRef index="5" />
<atomRef index="0" />
<atomRef index="6" />
</cell>
<cell>
<cellProperties type="TRIANGLE" />
<nrOfStructures value="3" />
<atomRef index="6" />
<atomRef index="0" />
<atomRef index="7" />
</cell>
<cell>
<cellProperties type="TRIANGLE" />
<nrOfStructures value="3" />
<atomRef index="7" />
<atomRef index="0" />
<atomRef index="8" />
</cell>
<cell>
<cellProperties type="TRIANGLE" />
<nrOfStructures value="3" />
<atomRef index="8" />
<atomRef index="0" />
<atomRef index="9" />
</cell>
<cell>
<cellProperties type="TRIANGLE" />
<nrOfStructures value="3" />
<atomRef index="9" />
<atomRef index="0" />
<atomRef index="10" />
</cell>
<cell>
<cellProperties type="TRIANGLE" />
<nrOfStructures value="3" />
<atomRef index="10" />
<atomRef index="0" />
<atomRef index="11" />
</cell>
<cell>
<cellProperties type="TRIANGLE" />
<nrOfStructures value="3" />
<atomRef index="11" />
<atomRef index="0" />
<atomRef index="12" />
</cell>
<cell>
<cellProperties type="TRIANGLE" />
<nrOfStructures value="3" />
<atomRef index="12" />
<atomRef index="0" />
<atomRef index="1" />
</cell>
<cell>
<cellProperties type="TRIANGLE" />
<nrOfStructures value="3" />
<atomRef index="1" />
<atomRef index="2" />
<atomRef index="13" />
</cell>
<cell>
<cellProperties type="TRIANGLE" />
<nrOfStructures value="3" />
<atomRef index="2" />
<atomRef index="14" />
<atomRef index="13" />
</cell>
<cell>
<cellProperties type="TRIANGLE" />
<nrOfStructures value="3" />
<atomRef index="2" />
<atomRef index="3" />
<atomRef index="14" />
</cell>
<cell>
<cellProperties type="TRIANGLE" />
<nrOfStructures value="3" />
<atomRef index="3" />
<atomRef index="15" />
<atomRef index="14" />
</cell>
<cell>
<cellProperties type="TRIANGLE" />
<nrOfStructures value="3" />
<atomRef index="3" />
<atomRef index="4" />
<atomRef index="15" />
</cell>
<cell>
<cellProperties type="TRIANGLE" />
<nrOfStructures value="3" />
<atomRef index="4" />
<atomRef index="16" />
<atomRef index="15" />
</cell>
<cell>
<cellProperties type="TRIANGLE" />
<nrOfStructures value="3" />
<atomRef index="4" />
<atomRef index="17" />
<atomRef index="16" />
</cell>
<cell>
<cellProperties type="TRIANGLE" />
<nrOfStructures value="3" />
<atomRef index="4" />
<atomRef index="5" />
<atomRef index="17" />
</cell>
<cell>
<cellProperties type="TRIANGLE" />
<nrOfStructures value="3" />
<atomRef index="5" />
<atomRef index="18" />
<atomRef index="17" />
</cell>
<cell>
<cellProperties type="TRIANGLE" />
<nrOfStructures value="3" />
<atomRef index="5" />
<atomRef index="6" />
<atomRef index="18" />
</cell>
<cell>
<cellProperties type="TRIANGLE" />
<nrOfStructures value="3" />
<atomRef index="6" />
<atomRef index="19" />
<atomRef index="18" />
</cell>
<cell>
<cellProperties type="TRIANGLE" />
<nrOfStructures value="3" />
<atomRef index="6" />
<atomRef index="7" />
<atomRef index="19" />
</cell>
<cell>
<cellProperties type="TRIANGLE" />
<nrOfStructures value="3" />
<atomRef index="7" />
<atomRef index="8" />
<atomRef index="19" />
</cell>
<cell>
<cellProperties type="TRIANGLE" />
<nrOfStructures value="3" />
<atomRef index="8" />
<atomRef index="20" />
<atomRef index="19" />
</cell>
<cell>
<cellProperties type="TRIANGLE" />
<nrOfStructures value="3" />
<atomRef index="8" />
<atomRef index="9" />
<atomRef index="20" />
</cell>
<cell>
<cellProperties type="TRIANGLE" />
<nrOfStructures value="3" />
<atomRef index="9" />
<atomRef index="21" />
<atomRef index="20" />
</cell>
<cell>
<cellProperties type="TRIANGLE" />
<nrOfStructures value="3" />
<atomRef index="9" />
<atomRef index="10" />
<atomRef index="21" />
</cell>
<cell>
<cellProperties type="TRIANGLE" />
<nrOfStructures value="3" />
<atomRef index="10" />
<atomRef index="22" />
<atomRef index="21" />
</cell>
<cell>
<cellProperties type="TRIANGLE" />
<nrOfStructures value="3" />
<atomRef index="10" />
<atomRef index="23" />
<atomRef index="22" />
</cell>
<cell>
<cellProperties type="TRIANGLE" />
<nrOfStructures value="3" />
<atomRef index="10" />
<atomRef index="11" />
<atomRef index="23" />
</cell>
<cell>
<cellProperties type="TRIANGLE" />
<nrOfStructures value="3" />
<atomRef index="11" />
<atomRef index="24" />
<atomRef index="23" />
</cell>
<cell>
<cellProperties type="TRIANGLE" />
<nrOfStructures value="3" />
<atomRef index="11" />
<atomRef index="12" />
<atomRef index="24" />
</cell>
<cell>
<cellProperties type="TRIANGLE" />
<nrOfStructures value="3" />
<atomRef index="12" />
<atomRef index="13" />
<atomRef index="24" />
</cell>
<cell>
<cellProperties type="TRIANGLE" />
<nrOfStructures value="3" />
<atomRef index="12" />
<atomRef index="1" />
<atomRef index="13" />
</cell>
<cell>
<cellProperties type="TRIANGLE" />
<nrOfStructures value="3" />
<atomRef index="13" />
<atomRef index="14" />
<atomRef index="25" />
</cell>
<cell>
<cellProperties type="TRIANGLE" />
<nrOfStructures value="3" />
<atomRef index="14" />
<atomRef index="26" />
<atomRef index="25" />
</cell>
<cell>
<cellProperties type="TRIANGLE" />
<nrOfStructures value="3" />
<atomRef index="14" />
<atomRef index="15" />
<atomRef index="26" />
</cell>
<cell>
<cellProperties type="TRIANGLE" />
<nrOfStructures value="3" />
<atomRef index="15" />
<atomRef index="27" />
<atomRef index="26" />
</cell>
<cell>
<cellProperties type="TRIANGLE" />
<nrOfStructures value="3" />
<atomRef index="15" />
<atomRef index="16" />
<atomRef index="27" />
</cell>
<cell>
<cellProperties type="TRIANGLE" />
<nrOfStructures value="3" />
<atomRef index="16" />
<atomRef index="28" />
<atomRef index="27" />
</cell>
<cell>
<cellProperties type="TRIANGLE" />
<nrOfStructures value="3" />
<atomRef index="16" />
<atomRef index="29" />
<atomRef index="28" />
</cell>
<cell>
<cellProperties type="TRIANGLE" />
<nrOfStructures value="3" />
<atomRef index="16" />
<atomRef index="17" />
<atomRef index="29" />
</cell>
<cell>
<cellProperties type="TRIANGLE" />
<nrOfStructures value="3" />
<atomRef index="17" />
<atomRef index="30" />
<atomRef index="29" />
</cell>
<cell>
<cellProperties type="TRIANGLE" />
<nrOfStructures value="3" />
<atomRef index="17" />
<atomRef index="18" />
<atomRef index="30" />
</cell>
<cell>
<cellProperties type="TRIANGLE" />
<nrOfStructures value="3" />
<atomRef index="18" />
<atomRef index="31" />
<atomRef index="30" />
</cell>
<cell>
<cellProperties type="TRIANGLE" />
<nrOfStructures value="3" />
<atomRef index="18" />
<atomRef index="19" />
<atomRef index="31" />
</cell>
<cell>
<cellProperties type="TRIANGLE" />
<nrOfStructures value="3" />
<atomRef index="19" />
<atomRef index="20" />
<atomRef index="31" />
</cell>
<cell>
<cellProperties type="TRIANGLE" />
<nrOfStructures value="3" />
<atomRef index="20" />
<atomRef index="32" />
<atomRef index="31" />
</cell>
<cell>
<cellProperties type="TRIANGLE" />
<nrOfStructures value="3" />
<atomRef index="20" />
<atomRef index="21" />
<atomRef index="32" />
</cell>
<cell>
<cellProperties type="TRIANGLE" />
<nrOfStructures value="3" />
<atomRef index="21" />
<atomRef index="33" />
<atomRef index="32" />
</cell>
<cell>
<cellProperties type="TRIANGLE" />
<nrOfStructures value="3" />
<atomRef index="21" />
<atomRef index="22" />
<atomRef index="33" />
</cell>
<cell>
<cellProperties type="TRIANGLE" />
<nrOfStructures value="3" />
<atomRef index="22" />
<atomRef index="34" />
<atomRef index="33" />
</cell>
<cell>
<cellProperties type="TRIANGLE" />
<nrOfStructures value="3" />
<atomRef index="22" />
<atomRef index="35" />
<atomRef index="34" />
</cell>
<cell>
<cellProperties type="TRIANGLE" />
<nrOfStructures value="3" />
<atomRef index="22" />
<atomRef index="23" />
<atomRef index="35" />
</cell>
<cell>
<cellProperties type="TRIANGLE" />
<nrOfStructures value="3" />
<atomRef index="23" />
<atomRef index="36" />
<atomRef index="35" />
</cell>
<cell>
<cellProperties type="TRIANGLE" />
<nrOfStructures value="3" />
<atomRef index="23" />
<atomRef index="24" />
<atomRef index="36" />
</cell>
<cell>
<cellProperties type="TRIANGLE" />
<nrOfStructures value="3" />
<atomRef index="24" />
<atomRef index="25" />
<atomRef index="36" />
</cell>
<cell>
<cellProperties type="TRIANGLE" />
<nrOfStructures value="3" />
<atomRef index="24" />
<atomRef index="13" />
<atomRef index="25" />
</cell>
<cell>
<cellProperties type="TRIANGLE" />
<nrOfStructures value="3" />
<atomRef index="25" />
<atomRef index="26" />
<atomRef index="37" />
</cell>
<cell>
<cellProperties type="TRIANGLE" />
<nrOfStructures value="3" />
<atomRef index="26" />
<atomRef index="38" />
<atomRef index="37" />
</cell>
<cell>
<cellProperties type="TRIANGLE" />
<nrOfStructures value="3" />
<atomRef index="26" />
<atomRef index="27" />
<atomRef index="38" />
</cell>
<cell>
<cellProperties type="TRIANGLE" />
<nrOfStructures value="3" />
<atomRef index="27" />
<atomRef index="39" />
<atomRef index="38" />
</cell>
<cell>
<cellProperties type="TRIANGLE" />
<nrOfStructures value="3" />
<atomRef index="27" />
<atomRef index="28" />
<atomRef index="39" />
</cell>
<cell>
<cellProperties type="TRIANGLE" />
<nrOfStructures value="3" />
<atomRef index="28" />
<atomRef index="40" />
<atomRef index="39" />
</cell>
<cell>
<cellProperties type="TRIANGLE" />
<nrOfStructures value="3" />
<atomRef index="28" />
<atomRef index="41" />
<atomRef index="40" />
</cell>
<cell>
<cellProperties type="TRIANGLE" />
<nrOfStructures value="3" />
<atomRef index="28" />
<atomRef index="29" />
<atomRef index="41" />
</cell>
<cell>
<cellProperties type="TRIANGLE" />
<nrOfStructures value="3" />
<atomRef index="29" />
<atomRef index="42" />
<atomRef index="41" />
</cell>
<cell>
<cellProperties type="TRIANGLE" />
<nrOfStructures value="3" />
<atomRef index="29" />
<atomRef index="30" />
<atomRef index="42" />
</cell>
<cell>
<cellProperties type="TRIANGLE" />
<nrOfStructures value="3" />
<atomRef index="30" />
<atomRef index="43" />
<atomRef index="42" />
</cell>
<cell>
<cellProperties type="TRIANGLE" />
<nrOfStructures value="3" />
<atomRef index="30" />
<atomRef index="31" />
<atomRef index="43" />
</cell>
<cell>
<cellProperties type="TRIANGLE" />
<nrOfStructures value="3" />
<atomRef index="31" />
<atomRef index="32" />
<atomRef index="43" />
</cell>
<cell>
<cellProperties type="TRIANGLE" />
<nrOfStructures value="3" />
<atomRef index="32" />
<atomRef index="44" />
<atomRef index="43" />
</cell>
<cell>
<cellProperties type="TRIANGLE" />
<nrOfStructures value="3" />
<atomRef index="32" />
<atomRef index="33" />
<atomRef index="44" />
</cell>
<cell>
<cellProperties type="TRIANGLE" />
<nrOfStructures value="3" />
<atomRef index="33" />
<atomRef index="45" />
<atomRef index="44" />
</cell>
<cell>
<cellProperties type="TRIANGLE" />
<nrOfStructures value="3" />
<atomRef index="33" />
<atomRef index="34" />
<atomRef index="45" />
</cell>
<cell>
<cellProperties type="TRIANGLE" />
<nrOfStructures value="3" />
<atomRef index="34" />
<atomRef index="46" />
<atomRef index="45" />
</cell>
<cell>
<cellProperties type="TRIANGLE" />
<nrOfStructures value="3" />
<atomRef index="34" />
<atomRef index="47" />
<atomRef index="46" />
</cell>
<cell>
<cellProperties type="TRIANGLE" />
<nrOfStructures value="3" />
<atomRef index="34" />
<atomRef index="35" />
<atomRef index="47" />
</cell>
<cell>
<cellProperties type="TRIANGLE" />
<nrOfStructures value="3" />
<atomRef index="35" />
<atomRef index="48" />
<atomRef index="47" />
</cell>
<cell>
<cellProperties type="TRIANGLE" />
<nrOfStructures value="3" />
<atomRef index="35" />
<atomRef index="36" />
<atomRef index="48" />
</cell>
<cell>
<cellProperties type="TRIANGLE" />
<nrOfStructures value="3" />
<atomRef index="36" />
<atomRef index="37" />
<atomRef index="48" />
</cell>
<cell>
<cellProperties type="TRIANGLE" />
<nrOfStructures value="3" />
<atomRef index="36" />
<atomRef index="25" />
<atomRef index="37" />
</cell>
<cell>
<cellProperties type="TRIANGLE" />
<nrOfStructures value="3" />
<atomRef index="37" />
<atomRef index="38" />
<atomRef index="49" />
</cell>
<cell>
<cellProperties type="TRIANGLE" />
<nrOfStructures value="3" />
<atomRef index="38" />
<atomRef index="50" />
<atomRef index="49" />
</cell>
<cell>
<cellProperties type="TRIANGLE" />
<nrOfStructures value="3" />
<atomRef index="38" />
<atomRef index="39" />
<atomRef index="50" />
</cell>
<cell>
<cellProperties type="TRIANGLE" />
<nrOfStructures value="3" />
<atomRef index="39" />
<atomRef index="51" />
<atomRef index="50" />
</cell>
<cell>
<cellProperties type="TRIANGLE" />
<nrOfStructures value="3" />
<atomRef index="39" />
<atomRef index="40" />
<atomRef index="51" />
</cell>
<cell>
<cellProperties type="TRIANGLE" />
<nrOfStructures value="3" />
<atomRef index="40" />
<atomRef index="52" />
<atomRef index="51" />
</cell>
<cell>
<cellProperties type="TRIANGLE" />
<nrOfStructures value="3" />
<atomRef index="40" />
<atomRef index="53" />
<atomRef index="52" />
</cell>
<cell>
<cellProperties type="TRIANGLE" />
<nrOfStructures value="3" />
<atomRef index="40" />
<atomRef index="41" />
<atomRef index="53" />
</cell>
<cell>
<cellProperties type="TRIANGLE" />
<nrOfStructures value="3" />
<atomRef index="41" />
<atomRef index="54" />
<atomRef index="53" />
</cell>
<cell>
<cellProperties type="TRIANGLE" />
<nrOfStructures value="3" />
<atomRef index="41" />
<atomRef index="42" />
<atomRef index="54" />
</cell>
<cell>
<cellProperties type="TRIANGLE" />
<nrOfStructures value="3" />
<atomRef index="42" />
<atomRef index="55" />
<atomRef index="54" />
</cell>
<cell>
<cellProperties type="TRIANGLE" />
<nrOfStructures value="3" />
<atomRef index="42" />
<atomRef index="43" />
<atomRef index="55" />
</cell>
<cell>
<cellProperties type="TRIANGLE" />
<nrOfStructures value="3" />
<atomRef index="43" />
<atomRef index="44" />
<atomRef index="55" />
</cell>
<cell>
<cellProperties type="TRIANGLE" />
<nrOfStructures value="3" />
<atomRef index="44" />
<atomRef index="56" />
<atomRef index="55" />
</cell>
<cell>
<cellProperties type="TRIANGLE" />
<nrOfStructures value="3" />
<atomRef index="44" />
<atomRef index="45" />
<atomRef index="56" />
</cell>
<cell>
<cellProperties type="TRIANGLE" />
<nrOfStructures value="3" />
<atomRef index="45" />
<atomRef index="57" />
<atomRef index="56" />
</cell>
<cell>
<cellProperties type="TRIANGLE" />
<nrOfStructures value="3" />
<atomRef index="45" />
<atomRef index="46" />
<atomRef index="57" />
</cell>
<cell>
<cellProperties type="TRIANGLE" />
<nrOfStructures value="3" />
<atomRef index="46" />
<atomRef index="58" />
<atomRef index="57" />
</cell>
<cell>
<cellProperties type="TRIANGLE" />
<nrOfStructures value="3" />
<atomRef index="46" />
<atomRef index="59" />
<atomRef index="58" />
</cell>
<cell>
<cellProperties type="TRIANGLE" />
<nrOfStructures value="3" />
<atomRef index="46" />
<atomRef index="47" />
<atomRef index="59" />
</cell>
<cell>
<cellProperties type="TRIANGLE" />
<nrOfStructures value="3" />
<atomRef index="47" />
<atomRef index="60" />
<atomRef index="59" />
</cell>
<cell>
<cellProperties type="TRIANGLE" />
<nrOfStructures value="3" />
<atomRef index="47" />
<atomRef index="48" />
<atomRef index="60" />
</cell>
<cell>
<cellProperties type="TRIANGLE" />
<nrOfStructures value="3" />
<atomRef index="48" />
<atomRef index="49" />
<atomRef index="60" />
</cell>
<cell>
<cellProperties type="TRIANGLE" />
<nrOfStructures value="3" />
<atomRef index="48" />
<atomRef index="37" />
<atomRef index="49" />
</cell>
<cell>
<cellProperties type="TRIANGLE" />
<nrOfStructures value="3" />
<atomRef index="49" />
<atomRef index="50" />
<atomRef index="61" />
</cell>
<cell>
<cellProperties type="TRIANGLE" />
<nrOfStructures value="3" />
<atomRef index="50" />
<atomRef index="62" />
<atomRef index="61" />
</cell>
<cell>
<cellProperties type="TRIANGLE" />
<nrOfStructures value="3" />
<atomRef index="50" />
<atomRef index="51" />
<atomRef index="62" />
</cell>
<cell>
<cellProperties type="TRIANGLE" />
<nrOfStructures value="3" />
<atomRef index="51" />
<atomRef index="63" />
<atomRef index="62" />
</cell>
<cell>
<cellProperties type="TRIANGLE" />
<nrOfStructures value="3" />
<atomRef index="51" />
<atomRef index="52" />
<atomRef index="63" />
</cell>
<cell>
<cellProperties type="TRIANGLE" />
<nrOfStructures value="3" />
<atomRef index="52" />
<atomRef index="64" />
<atomRef index="63" />
</cell>
<cell>
<cellProperties type="TRIANGLE" />
<nrOfStructures value="3" />
<atomRef index="52" />
<atomRef index="65" />
<atomRef index="64" />
</cell>
<cell>
<cellProperties type="TRIANGLE" />
<nrOfStructures value="3" />
<atomRef index="52" />
<atomRef index="53" />
<atomRef index="65" />
</cell>
<cell>
<cellProperties type="TRIANGLE" />
<nrOfStructures value="3" />
<atomRef index="53" />
<atomRef index="66" />
<atomRef index="65" />
</cell>
<cell>
<cellProperties type="TRIANGLE" />
<nrOfStructures value="3" />
<atomRef index="53" />
<atomRef index="54" />
<atomRef index="66" />
</cell>
<cell>
<cellProperties type="TRIANGLE" />
<nrOfStructures value="3" />
<atomRef index="54" />
<atomRef index="67" />
<atomRef index="66" />
</cell>
<cell>
<cellProperties type="TRIANGLE" />
<nrOfStructures value="3" />
<atomRef index="54" />
<atomRef index="55" />
<atomRef index="67" />
</cell>
<cell>
<cellProperties type="TRIANGLE" />
<nrOfStructures value="3" />
<atomRef index="55" />
<atomRef index="56" />
<atomRef index="67" />
</cell>
<cell>
<cellProperties type="TRIANGLE" />
<nrOfStructures value="3" />
<atomRef index="56" />
<atomRef index="68" />
<atomRef index="67" />
</cell>
<cell>
<cellProperties type="TRIANGLE" />
<nrOfStructures value="3" />
<atomRef index="56" />
<atomRef index="57" />
<atomRef index="68" />
</cell>
<cell>
<cellProperties type="TRIANGLE" />
<nrOfStructures value="3" />
<atomRef index="57" />
<atomRef index="69" />
<atomRef index="68" />
</cell>
<cell>
<cellProperties type="TRIANGLE" />
<nrOfStructures value="3" />
<atomRef index="57" />
<atomRef index="58" />
<atomRef index="69" />
</cell>
<cell>
<cellProperties type="TRIANGLE" />
<nrOfStructures value="3" />
<atomRef index="58" />
<atomRef index="70" />
<atomRef index="69" />
</cell>
<cell>
<cellProperties type="TRIANGLE" />
<nrOfStructures value="3" />
<atomRef index="58" />
<atomRef index="71" />
<atomRef index="70" />
</cell>
<cell>
<cellProperties type="TRIANGLE" />
<nrOfStructures value="3" />
<atomRef index="58" />
<atomRef index="59" />
<atomRef index="71" />
</cell>
<cell>
<cellProperties type="TRIANGLE" />
<nrOfStructures value="3" />
<atomRef index="59" />
<atomRef index="72" />
<atomRef index="71" />
</cell>
<cell>
<cellProperties type="TRIANGLE" />
<nrOfStructures value="3" />
<atomRef index="59" />
<atomRef index="60" />
<atomRef index="72" />
</cell>
<cell>
<cellProperties type="TRIANGLE" />
<nrOfStructures value="3" />
<atomRef index="60" />
<atomRef index="61" />
<atomRef index="72" />
</cell>
<cell>
<cellProperties type="TRIANGLE" />
<nrOfStructures value="3" />
<atomRef index="60" />
<atomRef index="49" />
<atomRef index="61" />
</cell>
<cell>
<cellProperties type="TRIANGLE" />
<nrOfStructures value="3" />
<atomRef index="61" />
<atomRef index="62" />
<atomRef index="73" />
</cell>
<cell>
<cellProperties type="TRIANGLE" />
<nrOfStructures value="3" />
<atomRef index="62" />
<atomRef index="74" />
<atomRef index="73" />
</cell>
<cell>
<cellProperties type="TRIANGLE" />
<nrOfStructures value="3" />
<atomRef index="62" />
<atomRef index="63" />
<atomRef index="74" />
</cell>
<cell>
<cellProperties type="TRIANGLE" />
<nrOfStructures value="3" />
<atomRef index="63" />
<atomRef index="75" />
<atomRef index="74" />
</cell>
<cell>
<cellProperties type="TRIANGLE" />
<nrOfStructures value="3" />
<atomRef index="63" />
<atomRef index="64" />
<atomRef index="75" />
</cell>
<cell>
<cellProperties type="TRIANGLE" />
<nrOfStructures value="3" />
<atomRef index="64" />
<atomRef index="76" />
<atomRef index="75" />
</cell>
<cell>
<cellProperties type="TRIANGLE" />
<nrOfStructures value="3" />
<atomRef index="64" />
<atomRef index="77" />
<atomRef index="76" />
</cell>
<cell>
<cellProperties type="TRIANGLE" />
<nrOfStructures value="3" />
<atomRef index="64" />
<atomRef index="65" />
<atomRef index="77" />
</cell>
<cell>
<cellProperties type="TRIANGLE" />
<nrOfStructures value="3" />
<atomRef index="65" />
<atomRef index="78" />
<atomRef index="77" />
</cell>
<cell>
<cellProperties type="TRIANGLE" />
<nrOfStructures value="3" />
<atomRef index="65" />
<atomRef index="66" />
<atomRef index="78" />
</cell>
<cell>
<cellProperties type="TRIANGLE" />
<nrOfStructures value="3" />
<atomRef index="66" />
<atomRef index="79" />
<atomRef index="78" />
</cell>
<cell>
<cellProperties type="TRIANGLE" />
<nrOfStructures value="3" />
<atomRef index="66" />
<atomRef index="67" />
<atomRef index="79" />
</cell>
<cell>
<cellProperties type="TRIANGLE" />
<nrOfStructures value="3" />
<atomRef index="67" />
<atomRef index="68" />
<atomRef index="79" />
</cell>
<cell>
<cellProperties type="TRIANGLE" />
<nrOfStructures value="3" />
<atomRef index="68" />
<atomRef index="80" />
<atomRef index="79" />
</cell>
<cell>
<cellProperties type="TRIANGLE" />
<nrOfStructures value="3" />
<atomRef index="68" />
<atomRef index="69" />
<atomRef index="80" />
</cell>
<cell>
<cellProperties type="TRIANGLE" />
<nrOfStructures value="3" />
<atomRef index="69" />
<atomRef index="81" />
<atomRef index="80" />
</cell>
<cell>
<cellProperties type="TRIANGLE" />
<nrOfStructures value="3" />
<atomRef index="69" />
<atomRef index="70" />
<atomRef index="81" />
</cell>
<cell>
<cellProperties type="TRIANGLE" />
<nrOfStructures value="3" />
<atomRef index="70" />
<atomRef index="82" />
<atomRef index="81" />
</cell>
<cell>
<cellProperties type="TRIANGLE" />
<nrOfStructures value="3" />
<atomRef index="70" />
<atomRef index="83" />
<atomRef index="82" />
</cell>
<cell>
<cellProperties type="TRIANGLE" />
<nrOfStructures value="3" />
<atomRef index="70" />
<atomRef index="71" />
<atomRef index="83" />
</cell>
<cell>
<cellProperties type="TRIANGLE" />
<nrOfStructures value="3" />
<atomRef index="71" />
<atomRef index="84" />
<atomRef index="83" />
</cell>
<cell>
<cellProperties type="TRIANGLE" />
<nrOfStructures value="3" />
<atomRef index="71" />
<atomRef index="72" />
<atomRef index="84" />
</cell>
<cell>
<cellProperties type="TRIANGLE" />
<nrOfStructures value="3" />
<atomRef index="72" />
<atomRef index="73" />
<atomRef index="84" />
</cell>
<cell>
<cellProperties type="TRIANGLE" />
<nrOfStructures value="3" />
<atomRef index="72" />
<atomRef index="61" />
<atomRef index="73" />
</cell>
<cell>
<cellProperties type="TRIANGLE" />
<nrOfStructures value="3" />
<atomRef index="73" />
<atomRef index="74" />
<atomRef index="85" />
</cell>
<cell>
<cellProperties type="TRIANGLE" />
<nrOfStructures value="3" />
<atomRef index="74" />
<atomRef index="86" />
<atomRef index="85" />
</cell>
<cell>
<cellProperties type="TRIANGLE" />
<nrOfStructures value="3" />
<atomRef index="74" />
<atomRef index="75" />
<atomRef index="86" />
</cell>
<cell>
<cellProperties type="TRIANGLE" />
<nrOfStructures value="3" />
<atomRef index="75" />
<atomRef index="76" />
<atomRef index="86" />
</cell>
<cell>
<cellProperties type="TRIANGLE" />
<nrOfStructures value="3" />
<atomRef index="76" />
<atomRef index="87" />
<atomRef index="86" />
</cell>
<cell>
<cellProperties type="TRIANGLE" />
<nrOfStructures value="3" />
<atomRef index="76" />
<atomRef index="77" />
<atomRef index="87" />
</cell>
<cell>
<cellProperties type="TRIANGLE" />
<nrOfStructures value="3" />
<atomRef index="77" />
<atomRef index="78" />
<atomRef index="87" />
</cell>
<cell>
<cellProperties type="TRIANGLE" />
<nrOfStructures value="3" />
<atomRef index="78" />
<atomRef index="88" />
<atomRef index="87" />
</cell>
<cell>
<cellProperties type="TRIANGLE" />
<nrOfStructures value="3" />
<atomRef index="78" />
<atomRef index="79" />
<atomRef index="88" />
</cell>
<cell>
<cellProperties type="TRIANGLE" />
<nrOfStructures value="3" />
<atomRef index="79" />
<atomRef index="80" />
<atomRef index="88" />
</cell>
<cell>
<cellProperties type="TRIANGLE" />
<nrOfStructures value="3" />
<atomRef index="80" />
<atomRef index="89" />
<atomRef index="88" />
</cell>
<cell>
<cellProperties type="TRIANGLE" />
<nrOfStructures value="3" />
<atomRef index="80" />
<atomRef index="81" />
<atomRef index="89" />
</cell>
<cell>
<cellProperties type="TRIANGLE" />
<nrOfStructures value="3" />
<atomRef index="81" />
<atomRef index="82" />
<atomRef index="89" />
</cell>
<cell>
<cellProperties type="TRIANGLE" />
<nrOfStructures value="3" />
<atomRef index="82" />
<atomRef index="90" />
<atomRef index="89" />
</cell>
<cell>
<cellProperties type="TRIANGLE" />
<nrOfStructures value="3" />
<atomRef index="82" />
<atomRef index="83" />
<atomRef index="90" />
</cell>
<cell>
<cellProperties type="TRIANGLE" />
<nrOfStructures value="3" />
<atomRef index="83" />
<atomRef index="84" />
<atomRef index="90" />
</cell>
<cell>
<cellProperties type="TRIANGLE" />
<nrOfStructures value="3" />
<atomRef index="84" />
<atomRef index="85" />
<atomRef index="90" />
</cell>
<cell>
<cellProperties type="TRIANGLE" />
<nrOfStructures value="3" />
<atomRef index="84" />
<atomRef index="73" />
<atomRef index="85" />
</cell>
<cell>
<cellProperties type="TRIANGLE" />
<nrOfStructures value="3" />
<atomRef index="85" />
<atomRef index="86" />
<atomRef index="91" />
</cell>
<cell>
<cellProperties type="TRIANGLE" />
<nrOfStructures value="3" />
<atomRef index="86" />
<atomRef index="87" />
<atomRef index="91" />
</cell>
<cell>
<cellProperties type="TRIANGLE" />
<nrOfStructures value="3" />
<atomRef index="87" />
<atomRef index="88" />
<atomRef index="91" />
</cell>
<cell>
<cellProperties type="TRIANGLE" />
<nrOfStructures value="3" />
<atomRef index="88" />
<atomRef index="89" />
<atomRef index="91" />
</cell>
<cell>
<cellProperties type="TRIANGLE" />
<nrOfStructures value="3" />
<atomRef index="89" />
<atomRef index="90" />
<atomRef index="91" />
</cell>
<cell>
<cellProperties type="TRIANGLE" />
<nrOfStructures value="3" />
<atomRef index="90" />
<atomRef index="85" />
<atomRef index="91" />
</cell>
</structuralComponent>
<structuralComponent name="lung" mode="WIREFRAME_AND_SURFACE">
<nrOfStructures value="100" />
<cell>
<cellProperties type="TRIANGLE" />
<nrOfStructures value="3" />
<atomRef index="61" />
<atomRef index="73" />
<atomRef index="62" />
</cell>
<cell>
<cellProperties type="TRIANGLE" />
<nrOfStructures value="3" />
<atomRef index="62" />
<atomRef index="73" />
<atomRef index="74" />
</cell>
<cell>
<cellProperties type="TRIANGLE" />
<nrOfStructures value="3" />
<atomRef index="62" />
<atomRef index="74" />
<atomRef index="63" />
</cell>
<cell>
<cellProperties type="TRIANGLE" />
<nrOfStructures value="3" />
<atomRef index="63" />
<atomRef index="74" />
<atomRef index="75" />
</cell>
<cell>
<cellProperties type="TRIANGLE" />
<nrOfStructures value="3" />
<atomRef index="63" />
<atomRef index="75" />
<atomRef index="64" />
</cell>
<cell>
<cellProperties type="TRIANGLE" />
<nrOfStructures value="3" />
<atomRef index="64" />
<atomRef index="75" />
<atomRef index="76" />
</cell>
<cell>
<cellProperties type="TRIANGLE" />
<nrOfStructures value="3" />
<atomRef index="64" />
<atomRef index="76" />
<atomRef index="77" />
</cell>
<cell>
<cellProperties type="TRIANGLE" />
<nrOfStructures value="3" />
<atomRef index="64" />
<atomRef index="77" />
<atomRef index="65" />
</cell>
<cell>
<cellProperties type="TRIANGLE" />
<nrOfStructures value="3" />
<atomRef index="65" />
<atomRef index="77" />
<atomRef index="78" />
</cell>
<cell>
<cellProperties type="TRIANGLE" />
<nrOfStructures value="3" />
<atomRef index="65" />
<atomRef index="78" />
<atomRef index="66" />
</cell>
<cell>
<cellProperties type="TRIANGLE" />
<nrOfStructures value="3" />
<atomRef index="66" />
<atomRef index="78" />
<atomRef index="79" />
</cell>
<cell>
<cellProperties type="TRIANGLE" />
<nrOfStructures value="3" />
<atomRef index="66" />
<atomRef index="79" />
<atomRef index="67" />
</cell>
<cell>
<cellProperties type="TRIANGLE" />
<nrOfStructures value="3" />
<atomRef index="67" />
<atomRef index="79" />
<atomRef index="68" />
</cell>
<cell>
<cellProperties type="TRIANGLE" />
<nrOfStructures value="3" />
<atomRef index="68" />
<atomRef index="79" />
<atomRef index="80" />
</cell>
<cell>
<cellProperties type="TRIANGLE" />
<nrOfStructures value="3" />
<atomRef index="68" />
<atomRef index="80" />
<atomRef index="69" />
</cell>
<cell>
<cellProperties type="TRIANGLE" />
<nrOfStructures value="3" />
<atomRef index="69" />
<atomRef index="80" />
<atomRef index="81" />
</cell>
<cell>
<cellProperties type="TRIANGLE" />
<nrOfStructures value="3" />
<atomRef index="69" />
<atomRef index="81" />
<atomRef index="70" />
</cell>
<cell>
<cellProperties type="TRIANGLE" />
<nrOfStructures value="3" />
<atomRef index="70" />
<atomRef index="81" />
<atomRef index="82" />
</cell>
<cell>
<cellProperties type="TRIANGLE" />
<nrOfStructures value="3" />
<atomRef index="70" />
<atomRef index="82" />
<atomRef index="83" />
</cell>
<cell>
<cellProperties type="TRIANGLE" />
<nrOfStructures value="3" />
<atomRef index="70" />
<atomRef index="83" />
<atomRef index="71" />
</cell>
<cell>
<cellProperties type="TRIANGLE" />
<nrOfStructures value="3" />
<atomRef index="71" />
<atomRef index="83" />
<atomRef index="84" />
</cell>
<cell>
<cellProperties type="TRIANGLE" />
<nrOfStructures value="3" />
<atomRef index="71" />
<atomRef index="84" />
<atomRef index="72" />
</cell>
<cell>
<cellProperties type="TRIANGLE" />
<nrOfStructures value="3" />
<atomRef index="72" />
<atomRef index="84" />
<atomRef index="73" />
</cell>
<cell>
<cellProperties type="TRIANGLE" />
<nrOfStructures value="3" />
<atomRef index="72" />
<atomRef index="73" />
<atomRef index="61" />
</cell>
<cell>
<cellProperties type="TRIANGLE" />
<nrOfStructures value="3" />
<atomRef index="73" />
<atomRef index="85" />
<atomRef index="74" />
</cell>
<cell>
<cellProperties type="TRIANGLE" />
<nrOfStructures value="3" />
<atomRef index="74" />
<atomRef index="85" />
<atomRef index="86" />
</cell>
<cell>
<cellProperties type="TRIANGLE" />
<nrOfStructures value="3" />
<atomRef index="74" />
<atomRef index="86" />
<atomRef index="75" />
</cell>
<cell>
<cellProperties type="TRIANGLE" />
<nrOfStructures value="3" />
<atomRef index="75" />
<atomRef index="86" />
<atomRef index="76" />
</cell>
<cell>
<cellProperties type="TRIANGLE" />
<nrOfStructures value="3" />
<atomRef index="76" />
<atomRef index="86" />
<atomRef index="87" />
</cell>
<cell>
<cellProperties type="TRIANGLE" />
<nrOfStructures value="3" />
<atomRef index="76" />
<atomRef index="87" />
<atomRef index="77" />
</cell>
<cell>
<cellProperties type="TRIANGLE" />
<nrOfStructures value="3" />
<atomRef index="77" />
<atomRef index="87" />
<atomRef index="78" />
</cell>
<cell>
<cellProperties type="TRIANGLE" />
<nrOfStructures value="3" />
<atomRef index="78" />
<atomRef index="87" />
<atomRef index="88" />
</cell>
<cell>
<cellProperties type="TRIANGLE" />
<nrOfStructures value="3" />
<atomRef index="78" />
<atomRef index="88" />
<atomRef index="79" />
</cell>
<cell>
<cellProperties type="TRIANGLE" />
<nrOfStructures value="3" />
<atomRef index="79" />
<atomRef index="88" />
<atomRef index="80" />
</cell>
<cell>
<cellProperties type="TRIANGLE" />
<nrOfStructures value="3" />
<atomRef index="80" />
<atomRef index="88" />
<atomRef index="89" />
</cell>
<cell>
<cellProperties type="TRIANGLE" />
<nrOfStructures value="3" />
<atomRef index="80" />
<atomRef index="89" />
<atomRef index="81" />
</cell>
<cell>
<cellProperties type="TRIANGLE" />
<nrOfStructures value="3" />
<atomRef index="81" />
<atomRef index="89" />
<atomRef index="82" />
</cell>
<cell>
<cellProperties type="TRIANGLE" />
<nrOfStructures value="3" />
<atomRef index="82" />
<atomRef index="89" />
<atomRef index="90" />
</cell>
<cell>
<cellProperties type="TRIANGLE" />
<nrOfStructures value="3" />
<atomRef index="82" />
<atomRef index="90" />
<atomRef index="83" />
</cell>
<cell>
<cellProperties type="TRIANGLE" />
<nrOfStructures value="3" />
<atomRef index="83" />
<atomRef index="90" />
<atomRef index="84" />
</cell>
<cell>
<cellProperties type="TRIANGLE" />
<nrOfStructures value="3" />
<atomRef index="84" />
<atomRef index="90" />
<atomRef index="85" />
</cell>
<cell>
<cellProperties type="TRIANGLE" />
<nrOfStructures value="3" />
<atomRef index="84" />
<atomRef index="85" />
<atomRef index="73" />
</cell>
<cell>
<cellProperties type="TRIANGLE" />
<nrOfStructures value="3" />
<atomRef index="85" />
<atomRef index="91" />
<atomRef index="86" />
</cell>
<cell>
<cellProperties type="TRIANGLE" />
<nrOfStructures value="3" />
<atomRef index="86" />
<atomRef index="91" />
<atomRef index="87" />
</cell>
<cell>
<cellProperties type="TRIANGLE" />
<nrOfStructures value="3" />
<atomRef index="87" />
<atomRef index="91" />
<atomRef index="88" />
</cell>
<cell>
<cellProperties type="TRIANGLE" />
<nrOfStructures value="3" />
<atomRef index="88" />
<atomRef index="91" />
<atomRef index="89" />
</cell>
<cell>
<cellProperties type="TRIANGLE" />
<nrOfStructures value="3" />
<atomRef index="89" />
<atomRef index="91" />
<atomRef index="90" />
</cell>
<cell>
<cellProperties type="TRIANGLE" />
<nrOfStructures value="3" />
<atomRef index="90" />
<atomRef index="91" />
<atomRef index="85" />
</cell>
<cell>
<cellProperties type="TRIANGLE" />
<nrOfStructures value="3" />
<atomRef index="61" />
<atomRef index="62" />
<atomRef index="92" />
</cell>
<cell>
<cellProperties type="TRIANGLE" />
<nrOfStructures value="3" />
<atomRef index="62" />
<atomRef index="93" />
<atomRef index="92" />
</cell>
<cell>
<cellProperties type="TRIANGLE" />
<nrOfStructures value="3" />
<atomRef index="62" />
<atomRef index="63" />
<atomRef index="93" />
</cell>
<cell>
<cellProperties type="TRIANGLE" />
<nrOfStructures value="3" />
<atomRef index="63" />
<atomRef index="94" />
<atomRef index="93" />
</cell>
<cell>
<cellProperties type="TRIANGLE" />
<nrOfStructures value="3" />
<atomRef index="63" />
<atomRef index="64" />
<atomRef index="94" />
</cell>
<cell>
<cellProperties type="TRIANGLE" />
<nrOfStructures value="3" />
<atomRef index="64" />
<atomRef index="95" />
<atomRef index="94" />
</cell>
<cell>
<cellProperties type="TRIANGLE" />
<nrOfStructures value="3" />
<atomRef index="64" />
<atomRef index="96" />
<atomRef index="95" />
</cell>
<cell>
<cellProperties type="TRIANGLE" />
<nrOfStructures value="3" />
<atomRef index="64" />
<atomRef index="65" />
<atomRef index="96" />
</cell>
<cell>
<cellProperties type="TRIANGLE" />
<nrOfStructures value="3" />
<atomRef index="65" />
<atomRef index="97" />
<atomRef index="96" />
</cell>
<cell>
<cellProperties type="TRIANGLE" />
<nrOfStructures value="3" />
<atomRef index="65" />
<atomRef index="66" />
<atomRef index="97" />
</cell>
<cell>
<cellProperties type="TRIANGLE" />
<nrOfStructures value="3" />
<atomRef index="66" />
<atomRef index="98" />
<atomRef index="97" />
</cell>
<cell>
<cellProperties type="TRIANGLE" />
<nrOfStructures value="3" />
<atomRef index="66" />
<atomRef index="67" />
<atomRef index="98" />
</cell>
<cell>
<cellProperties type="TRIANGLE" />
<nrOfStructures value="3" />
<atomRef index="67" />
<atomRef index="68" />
<atomRef index="98" />
</cell>
<cell>
<cellProperties type="TRIANGLE" />
<nrOfStructures value="3" />
<atomRef index="68" />
<atomRef index="99" />
<atomRef index="98" />
</cell>
<cell>
<cellProperties type="TRIANGLE" />
<nrOfStructures value="3" />
<atomRef index="68" />
<atomRef index="69" />
<atomRef index="99" />
</cell>
<cell>
<cellProperties type="TRIANGLE" />
<nrOfStructures value="3" />
<atomRef index="69" />
<atomRef index="100" />
<atomRef index="99" />
</cell>
<cell>
<cellProperties type="TRIANGLE" />
<nrOfStructures value="3" />
<atomRef index="69" />
<atomRef index="70" />
<atomRef index="100" />
</cell>
<cell>
<cellProperties type="TRIANGLE" />
<nrOfStructures value="3" />
<atomRef index="70" />
<atomRef index="101" />
<atomRef index="100" />
</cell>
<cell>
<cellProperties type="TRIANGLE" />
<nrOfStructures value="3" />
<atomRef index="70" />
<atomRef index="102" />
<atomRef index="101" />
</cell>
<cell>
<cellProperties type="TRIANGLE" />
<nrOfStructures value="3" />
<atomRef index="70" />
<atomRef index="71" />
<atomRef index="102" />
</cell>
<cell>
<cellProperties type="TRIANGLE" />
<nrOfStructures value="3" />
<atomRef index="71" />
<atomRef index="103" />
<atomRef index="102" />
</cell>
<cell>
<cellProperties type="TRIANGLE" />
<nrOfStructures value="3" />
<atomRef index="71" />
<atomRef index="72" />
<atomRef index="103" />
</cell>
<cell>
<cellProperties type="TRIANGLE" />
<nrOfStructures value="3" />
<atomRef index="72" />
<atomRef index="92" />
<atomRef index="103" />
</cell>
<cell>
<cellProperties type="TRIANGLE" />
<nrOfStructures value="3" />
<atomRef index="72" />
<atomRef index="61" />
<atomRef index="92" />
</cell>
<cell>
<cellProperties type="TRIANGLE" />
<nrOfStructures value="3" />
<atomRef index="92" />
<atomRef index="93" />
<atomRef index="104" />
</cell>
<cell>
<cellProperties type="TRIANGLE" />
<nrOfStructures value="3" />
<atomRef index="93" />
<atomRef index="105" />
<atomRef index="104" />
</cell>
<cell>
<cellProperties type="TRIANGLE" />
<nrOfStructures value="3" />
<atomRef index="93" />
<atomRef index="94" />
<atomRef index="105" />
</cell>
<cell>
<cellProperties type="TRIANGLE" />
<nrOfStructures value="3" />
<atomRef index="94" />
<atomRef index="106" />
<atomRef index="105" />
</cell>
<cell>
<cellProperties type="TRIANGLE" />
<nrOfStructures value="3" />
<atomRef index="94" />
<atomRef index="95" />
<atomRef index="106" />
</cell>
<cell>
<cellProperties type="TRIANGLE" />
<nrOfStructures value="3" />
<atomRef index="95" />
<atomRef index="96" />
<atomRef index="106" />
</cell>
<cell>
<cellProperties type="TRIANGLE" />
<nrOfStructures value="3" />
<atomRef index="96" />
<atomRef index="107" />
<atomRef index="106" />
</cell>
<cell>
<cellProperties type="TRIANGLE" />
<nrOfStructures value="3" />
<atomRef index="96" />
<atomRef index="97" />
<atomRef index="107" />
</cell>
<cell>
<cellProperties type="TRIANGLE" />
<nrOfStructures value="3" />
<atomRef index="97" />
<atomRef index="108" />
<atomRef index="107" />
</cell>
<cell>
<cellProperties type="TRIANGLE" />
<nrOfStructures value="3" />
<atomRef index="97" />
<atomRef index="98" />
<atomRef index="108" />
</cell>
<cell>
<cellProperties type="TRIANGLE" />
<nrOfStructures value="3" />
<atomRef index="98" />
<atomRef index="99" />
<atomRef index="108" />
</cell>
<cell>
<cellProperties type="TRIANGLE" />
<nrOfStructures value="3" />
<atomRef index="99" />
<atomRef index="109" />
<atomRef index="108" />
</cell>
<cell>
<cellProperties type="TRIANGLE" />
<nrOfStructures value="3" />
<atomRef index="99" />
<atomRef index="100" />
<atomRef index="109" />
</cell>
<cell>
<cellProperties type="TRIANGLE" />
<nrOfStructures value="3" />
<atomRef index="100" />
<atomRef index="110" />
<atomRef index="109" />
</cell>
<cell>
<cellProperties type="TRIANGLE" />
<nrOfStructures value="3" />
<atomRef index="100" />
<atomRef index="101" />
<atomRef index="110" />
</cell>
<cell>
<cellProperties type="TRIANGLE" />
<nrOfStructures value="3" />
<atomRef index="101" />
<atomRef index="102" />
<atomRef index="110" />
</cell>
<cell>
<cellProperties type="TRIANGLE" />
<nrOfStructures value="3" />
<atomRef index="102" />
<atomRef index="111" />
<atomRef index="110" />
</cell>
<cell>
<cellProperties type="TRIANGLE" />
<nrOfStructures value="3" />
<atomRef index="102" />
<atomRef index="103" />
<atomRef index="111" />
</cell>
<cell>
<cellProperties type="TRIANGLE" />
<nrOfStructures value="3" />
<atomRef index="103" />
<atomRef index="104" />
<atomRef index="111" />
</cell>
<cell>
<cellProperties type="TRIANGLE" />
<nrOfStructures value="3" />
<atomRef index="103" />
<atomRef index="92" />
<atomRef index="104" />
</cell>
<cell>
<cellProperties type="TRIANGLE" />
<nrOfStructures value="3" />
<atomRef index="104" />
<atomRef index="105" />
<atomRef index="112" />
</cell>
<cell>
<cellProperties type="TRIANGLE" />
<nrOfStructures value="3" />
<atomRef index="105" />
<atomRef index="106" />
<atomRef index="112" />
</cell>
<cell>
<cellProperties type="TRIANGLE" />
<nrOfStructures value="3" />
<atomRef index="106" />
<atomRef index="107" />
<atomRef index="112" />
</cell>
<cell>
<cellProperties type="TRIANGLE" />
<nrOfStructures value="3" />
<atomRef index="107" />
<atomRef index="108" />
<atomRef index="112" />
</cell>
<cell>
<cellProperties type="TRIANGLE" />
<nrOfStructures value="3" />
<atomRef index="108" />
<atomRef index="109" />
<atomRef index="112" />
</cell>
<cell>
<cellProperties type="TRIANGLE" />
<nrOfStructures value="3" />
<atomRef index="109" />
<atomRef index="110" />
<atomRef index="112" />
</cell>
<cell>
<cellProperties type="TRIANGLE" />
<nrOfStructures value="3" />
<atomRef index="110" />
<atomRef index="111" />
<atomRef index="112" />
</cell>
<cell>
<cellProperties type="TRIANGLE" />
<nrOfStructures value="3" />
<atomRef index="111" />
<atomRef index="104" />
<atomRef index="112" />
</cell>
</structuralComponent>
</multiComponent>
<multiComponent name="Regions">
<structuralComponent name="abdominal_wall">
<nrOfStructures value="24" />
<atomRef index="13" />
<atomRef index="14" />
<atomRef index="15" />
<atomRef index="16" />
<atomRef index="17" />
<atomRef index="18" />
<atomRef index="19" />
<atomRef index="20" />
<atomRef index="21" />
<atomRef index="22" />
<atomRef index="23" />
<atomRef index="24" />
<atomRef index="25" />
<atomRef index="26" />
<atomRef index="27" />
<atomRef index="28" />
<atomRef index="29" />
<atomRef index="30" />
<atomRef index="31" />
<atomRef index="32" />
<atomRef index="33" />
<atomRef index="34" />
<atomRef index="35" />
<atomRef index="36" />
</structuralComponent>
<structuralComponent name="central_tendon">
<nrOfStructures value="19" />
<atomRef index="73" />
<atomRef index="74" />
<atomRef index="75" />
<atomRef index="76" />
<atomRef index="77" />
<atomRef index="78" />
<atomRef index="79" />
<atomRef index="80" />
<atomRef index="81" />
<atomRef index="82" />
<atomRef index="83" />
<atomRef index="84" />
<atomRef index="85" />
<atomRef index="86" />
<atomRef index="87" />
<atomRef index="88" />
<atomRef index="89" />
<atomRef index="90" />
<atomRef index="91" />
</structuralComponent>
<structuralComponent name="costal_insertion">
<nrOfStructures value="12" />
<atomRef index="37" />
<atomRef index="38" />
<atomRef index="39" />
<atomRef index="40" />
<atomRef index="41" />
<atomRef index="42" />
<atomRef index="43" />
<atomRef index="44" />
<atomRef index="45" />
<atomRef index="46" />
<atomRef index="47" />
<atomRef index="48" />
</structuralComponent>
<structuralComponent name="lung_top">
<nrOfStructures value="1" />
<atomRef index="112" />
</structuralComponent>
<structuralComponent name="lung_wall">
<nrOfStructures value="20" />
<atomRef index="92" />
<atomRef index="93" />
<atomRef index="94" />
<atomRef index="95" />
<atomRef index="96" />
<atomRef index="97" />
<atomRef index="98" />
<atomRef index="99" />
<atomRef index="100" />
<atomRef index="101" />
<atomRef index="102" />
<atomRef index="103" />
<atomRef index="104" />
<atomRef index="105" />
<atomRef index="106" />
<atomRef index="107" />
<atomRef index="108" />
<atomRef index="109" />
<atomRef index="110" />
<atomRef index="111" />
</structuralComponent>
<structuralComponent name="pelvis">
<nrOfStructures value="13" />
<atomRef index="0" />
<atomRef index="1" />
<atomRef index="2" />
<atomRef index="3" />
<atomRef index="4" />
<atomRef index="5" />
<atomRef index="6" />
<atomRef index="7" />
<atomRef index="8" />
<atomRef index="9" />
<atomRef index="10" />
<atomRef index="11" />
<atomRef index="12" />
</structuralComponent>
<structuralComponent name="zone_of_apposition">
<nrOfStructures value="24" />
<atomRef index="49" />
<atomRef index="50" />
<atomRef index="51" />
<atomRef index="52" />
<atomRef index="53" />
<atomRef index="54" />
<atomRef index="55" />
<atomRef index="56" />
<atomRef index="57" />
<atomRef index="58" />
<atomRef index="59" />
<atomRef index="60" />
<atomRef index="61" />
<atomRef index="62" />
<atomRef index="63" />
<atomRef index="64" />
<atomRef index="65" />
<atomRef index="66" />
<atomRef index="67" />
<atomRef index="68" />
<atomRef index="69" />
<atomRef index="70" />
<atomRef index="71" />
<atomRef index="72" />
</structuralComponent>
</multiComponent>
<structuralComponent name="Node Neighborhoods">
<nrOfStructures value="92" />
<cell>
<cellProperties type="POLY_VERTEX" name="Atom #0" />
<nrOfStructures value="12" />
<atomRef index="1" />
<atomRef index="12" />
<atomRef index="11" />
<atomRef index="10" />
<atomRef index="9" />
<atomRef index="8" />
<atomRef index="7" />
<atomRef index="6" />
<atomRef index="5" />
<atomRef index="4" />
<atomRef index="3" />
<atomRef index="2" />
</cell>
<cell>
<cellProperties type="POLY_VERTEX" name="Atom #1" />
<nrOfStructures value="4" />
<atomRef index="0" />
<atomRef index="2" />
<atomRef index="13" />
<atomRef index="12" />
</cell>
<cell>
<cellProperties type="POLY_VERTEX" name="Atom #2" />
<nrOfStructures value="5" />
<atomRef index="0" />
<atomRef index="3" />
<atomRef index="14" />
<atomRef index="13" />
<atomRef index="1" />
</cell>
<cell>
<cellProperties type="POLY_VERTEX" name="Atom #3" />
<nrOfStructures value="5" />
<atomRef index="0" />
<atomRef index="4" />
<atomRef index="15" />
<atomRef index="14" />
<atomRef index="2" />
</cell>
<cell>
<cellProperties type="POLY_VERTEX" name="Atom #4" />
<nrOfStructures value="6" />
<atomRef index="0" />
<atomRef index="5" />
<atomRef index="17" />
<atomRef index="16" />
<atomRef index="15" />
<atomRef index="3" />
</cell>
<cell>
<cellProperties type="POLY_VERTEX" name="Atom #5" />
<nrOfStructures value="5" />
<atomRef index="0" />
<atomRef index="6" />
<atomRef index="18" />
<atomRef index="17" />
<atomRef index="4" />
</cell>
<cell>
<cellProperties type="POLY_VERTEX" name="Atom #6" />
<nrOfStructures value="5" />
<atomRef index="0" />
<atomRef index="7" />
<atomRef index="19" />
<atomRef index="18" />
<atomRef index="5" />
</cell>
<cell>
<cellProperties type="POLY_VERTEX" name="Atom #7" />
<nrOfStructures value="4" />
<atomRef index="0" />
<atomRef index="8" />
<atomRef index="19" />
<atomRef index="6" />
</cell>
<cell>
<cellProperties type="POLY_VERTEX" name="Atom #8" />
<nrOfStructures value="5" />
<atomRef index="0" />
<atomRef index="9" />
<atomRef index="20" />
<atomRef index="19" />
<atomRef index="7" />
</cell>
<cell>
<cellProperties type="POLY_VERTEX" name="Atom #9" />
<nrOfStructures value="5" />
<atomRef index="0" />
<atomRef index="10" />
<atomRef index="21" />
<atomRef index="20" />
<atomRef index="8" />
</cell>
<cell>
<cellProperties type="POLY_VERTEX" name="Atom #10" />
<nrOfStructures value="6" />
<atomRef index="0" />
<atomRef index="11" />
<atomRef index="23" />
<atomRef index="22" />
<atomRef index="21" />
<atomRef index="9" />
</cell>
<cell>
<cellProperties type="POLY_VERTEX" name="Atom #11" />
<nrOfStructures value="5" />
<atomRef index="0" />
<atomRef index="12" />
<atomRef index="24" />
<atomRef index="23" />
<atomRef index="10" />
</cell>
<cell>
<cellProperties type="POLY_VERTEX" name="Atom #12" />
<nrOfStructures value="5" />
<atomRef index="0" />
<atomRef index="1" />
<atomRef index="13" />
<atomRef index="24" />
<atomRef index="11" />
</cell>
<cell>
<cellProperties type="POLY_VERTEX" name="Atom #13" />
<nrOfStructures value="6" />
<atomRef index="1" />
<atomRef index="2" />
<atomRef index="14" />
<atomRef index="25" />
<atomRef index="24" />
<atomRef index="12" />
</cell>
<cell>
<cellProperties type="POLY_VERTEX" name="Atom #14" />
<nrOfStructures value="6" />
<atomRef index="2" />
<atomRef index="3" />
<atomRef index="15" />
<atomRef index="26" />
<atomRef index="25" />
<atomRef index="13" />
</cell>
<cell>
<cellProperties type="POLY_VERTEX" name="Atom #15" />
<nrOfStructures value="6" />
<atomRef index="3" />
<atomRef index="4" />
<atomRef index="16" />
<atomRef index="27" />
<atomRef index="26" />
<atomRef index="14" />
</cell>
<cell>
<cellProperties type="POLY_VERTEX" name="Atom #16" />
<nrOfStructures value="6" />
<atomRef index="4" />
<atomRef index="17" />
<atomRef index="29" />
<atomRef index="28" />
<atomRef index="27" />
<atomRef index="15" />
</cell>
<cell>
<cellProperties type="POLY_VERTEX" name="Atom #17" />
<nrOfStructures value="6" />
<atomRef index="4" />
<atomRef index="5" />
<atomRef index="18" />
<atomRef index="30" />
<atomRef index="29" />
<atomRef index="16" />
</cell>
<cell>
<cellProperties type="POLY_VERTEX" name="Atom #18" />
<nrOfStructures value="6" />
<atomRef index="5" />
<atomRef index="6" />
<atomRef index="19" />
<atomRef index="31" />
<atomRef index="30" />
<atomRef index="17" />
</cell>
<cell>
<cellProperties type="POLY_VERTEX" name="Atom #19" />
<nrOfStructures value="6" />
<atomRef index="6" />
<atomRef index="7" />
<atomRef index="8" />
<atomRef index="20" />
<atomRef index="31" />
<atomRef index="18" />
</cell>
<cell>
<cellProperties type="POLY_VERTEX" name="Atom #20" />
<nrOfStructures value="6" />
<atomRef index="8" />
<atomRef index="9" />
<atomRef index="21" />
<atomRef index="32" />
<atomRef index="31" />
<atomRef index="19" />
</cell>
<cell>
<cellProperties type="POLY_VERTEX" name="Atom #21" />
<nrOfStructures value="6" />
<atomRef index="9" />
<atomRef index="10" />
<atomRef index="22" />
<atomRef index="33" />
<atomRef index="32" />
<atomRef index="20" />
</cell>
<cell>
<cellProperties type="POLY_VERTEX" name="Atom #22" />
<nrOfStructures value="6" />
<atomRef index="10" />
<atomRef index="23" />
<atomRef index="35" />
<atomRef index="34" />
<atomRef index="33" />
<atomRef index="21" />
</cell>
<cell>
<cellProperties type="POLY_VERTEX" name="Atom #23" />
<nrOfStructures value="6" />
<atomRef index="10" />
<atomRef index="11" />
<atomRef index="24" />
<atomRef index="36" />
<atomRef index="35" />
<atomRef index="22" />
</cell>
<cell>
<cellProperties type="POLY_VERTEX" name="Atom #24" />
<nrOfStructures value="6" />
<atomRef index="11" />
<atomRef index="12" />
<atomRef index="13" />
<atomRef index="25" />
<atomRef index="36" />
<atomRef index="23" />
</cell>
<cell>
<cellProperties type="POLY_VERTEX" name="Atom #25" />
<nrOfStructures value="6" />
<atomRef index="13" />
<atomRef index="14" />
<atomRef index="26" />
<atomRef index="37" />
<atomRef index="36" />
<atomRef index="24" />
</cell>
<cell>
<cellProperties type="POLY_VERTEX" name="Atom #26" />
<nrOfStructures value="6" />
<atomRef index="14" />
<atomRef index="15" />
<atomRef index="27" />
<atomRef index="38" />
<atomRef index="37" />
<atomRef index="25" />
</cell>
<cell>
<cellProperties type="POLY_VERTEX" name="Atom #27" />
<nrOfStructures value="6" />
<atomRef index="15" />
<atomRef index="16" />
<atomRef index="28" />
<atomRef index="39" />
<atomRef index="38" />
<atomRef index="26" />
</cell>
<cell>
<cellProperties type="POLY_VERTEX" name="Atom #28" />
<nrOfStructures value="6" />
<atomRef index="16" />
<atomRef index="29" />
<atomRef index="41" />
<atomRef index="40" />
<atomRef index="39" />
<atomRef index="27" />
</cell>
<cell>
<cellProperties type="POLY_VERTEX" name="Atom #29" />
<nrOfStructures value="6" />
<atomRef index="16" />
<atomRef index="17" />
<atomRef index="30" />
<atomRef index="42" />
<atomRef index="41" />
<atomRef index="28" />
</cell>
<cell>
<cellProperties type="POLY_VERTEX" name="Atom #30" />
<nrOfStructures value="6" />
<atomRef index="17" />
<atomRef index="18" />
<atomRef index="31" />
<atomRef index="43" />
<atomRef index="42" />
<atomRef index="29" />
</cell>
<cell>
<cellProperties type="POLY_VERTEX" name="Atom #31" />
<nrOfStructures value="6" />
<atomRef index="18" />
<atomRef index="19" />
<atomRef index="20" />
<atomRef index="32" />
<atomRef index="43" />
<atomRef index="30" />
</cell>
<cell>
<cellProperties type="POLY_VERTEX" name="Atom #32" />
<nrOfStructures value="6" />
<atomRef index="20" />
<atomRef index="21" />
<atomRef index="33" />
<atomRef index="44" />
<atomRef index="43" />
<atomRef index="31" />
</cell>
<cell>
<cellProperties type="POLY_VERTEX" name="Atom #33" />
<nrOfStructures value="6" />
<atomRef index="21" />
<atomRef index="22" />
<atomRef index="34" />
<atomRef index="45" />
<atomRef index="44" />
<atomRef index="32" />
</cell>
<cell>
<cellProperties type="POLY_VERTEX" name="Atom #34" />
<nrOfStructures value="6" />
<atomRef index="22" />
<atomRef index="35" />
<atomRef index="47" />
<atomRef index="46" />
<atomRef index="45" />
<atomRef index="33" />
</cell>
<cell>
<cellProperties type="POLY_VERTEX" name="Atom #35" />
<nrOfStructures value="6" />
<atomRef index="22" />
<atomRef index="23" />
<atomRef index="36" />
<atomRef index="48" />
<atomRef index="47" />
<atomRef index="34" />
</cell>
<cell>
<cellProperties type="POLY_VERTEX" name="Atom #36" />
<nrOfStructures value="6" />
<atomRef index="23" />
<atomRef index="24" />
<atomRef index="25" />
<atomRef index="37" />
<atomRef index="48" />
<atomRef index="35" />
</cell>
<cell>
<cellProperties type="POLY_VERTEX" name="Atom #37" />
<nrOfStructures value="6" />
<atomRef index="25" />
<atomRef index="26" />
<atomRef index="38" />
<atomRef index="49" />
<atomRef index="48" />
<atomRef index="36" />
</cell>
<cell>
<cellProperties type="POLY_VERTEX" name="Atom #38" />
<nrOfStructures value="6" />
<atomRef index="26" />
<atomRef index="27" />
<atomRef index="39" />
<atomRef index="50" />
<atomRef index="49" />
<atomRef index="37" />
</cell>
<cell>
<cellProperties type="POLY_VERTEX" name="Atom #39" />
<nrOfStructures value="6" />
<atomRef index="27" />
<atomRef index="28" />
<atomRef index="40" />
<atomRef index="51" />
<atomRef index="50" />
<atomRef index="38" />
</cell>
<cell>
<cellProperties type="POLY_VERTEX" name="Atom #40" />
<nrOfStructures value="6" />
<atomRef index="28" />
<atomRef index="41" />
<atomRef index="53" />
<atomRef index="52" />
<atomRef index="51" />
<atomRef index="39" />
</cell>
<cell>
<cellProperties type="POLY_VERTEX" name="Atom #41" />
<nrOfStructures value="6" />
<atomRef index="28" />
<atomRef index="29" />
<atomRef index="42" />
<atomRef index="54" />
<atomRef index="53" />
<atomRef index="40" />
</cell>
<cell>
<cellProperties type="POLY_VERTEX" name="Atom #42" />
<nrOfStructures value="6" />
<atomRef index="29" />
<atomRef index="30" />
<atomRef index="43" />
<atomRef index="55" />
<atomRef index="54" />
<atomRef index="41" />
</cell>
<cell>
<cellProperties type="POLY_VERTEX" name="Atom #43" />
<nrOfStructures value="6" />
<atomRef index="30" />
<atomRef index="31" />
<atomRef index="32" />
<atomRef index="44" />
<atomRef index="55" />
<atomRef index="42" />
</cell>
<cell>
<cellProperties type="POLY_VERTEX" name="Atom #44" />
<nrOfStructures value="6" />
<atomRef index="32" />
<atomRef index="33" />
<atomRef index="45" />
<atomRef index="56" />
<atomRef index="55" />
<atomRef index="43" />
</cell>
<cell>
<cellProperties type="POLY_VERTEX" name="Atom #45" />
<nrOfStructures value="6" />
<atomRef index="33" />
<atomRef index="34" />
<atomRef index="46" />
<atomRef index="57" />
<atomRef index="56" />
<atomRef index="44" />
</cell>
<cell>
<cellProperties type="POLY_VERTEX" name="Atom #46" />
<nrOfStructures value="6" />
<atomRef index="34" />
<atomRef index="47" />
<atomRef index="59" />
<atomRef index="58" />
<atomRef index="57" />
<atomRef index="45" />
</cell>
<cell>
<cellProperties type="POLY_VERTEX" name="Atom #47" />
<nrOfStructures value="6" />
<atomRef index="34" />
<atomRef index="35" />
<atomRef index="48" />
<atomRef index="60" />
<atomRef index="59" />
<atomRef index="46" />
</cell>
<cell>
<cellProperties type="POLY_VERTEX" name="Atom #48" />
<nrOfStructures value="6" />
<atomRef index="35" />
<atomRef index="36" />
<atomRef index="37" />
<atomRef index="49" />
<atomRef index="60" />
<atomRef index="47" />
</cell>
<cell>
<cellProperties type="POLY_VERTEX" name="Atom #49" />
<nrOfStructures value="6" />
<atomRef index="37" />
<atomRef index="38" />
<atomRef index="50" />
<atomRef index="61" />
<atomRef index="60" />
<atomRef index="48" />
</cell>
<cell>
<cellProperties type="POLY_VERTEX" name="Atom #50" />
<nrOfStructures value="6" />
<atomRef index="38" />
<atomRef index="39" />
<atomRef index="51" />
<atomRef index="62" />
<atomRef index="61" />
<atomRef index="49" />
</cell>
<cell>
<cellProperties type="POLY_VERTEX" name="Atom #51" />
<nrOfStructures value="6" />
<atomRef index="39" />
<atomRef index="40" />
<atomRef index="52" />
<atomRef index="63" />
<atomRef index="62" />
<atomRef index="50" />
</cell>
<cell>
<cellProperties type="POLY_VERTEX" name="Atom #52" />
<nrOfStructures value="6" />
<atomRef index="40" />
<atomRef index="53" />
<atomRef index="65" />
<atomRef index="64" />
<atomRef index="63" />
<atomRef index="51" />
</cell>
<cell>
<cellProperties type="POLY_VERTEX" name="Atom #53" />
<nrOfStructures value="6" />
<atomRef index="40" />
<atomRef index="41" />
<atomRef index="54" />
<atomRef index="66" />
<atomRef index="65" />
<atomRef index="52" />
</cell>
<cell>
<cellProperties type="POLY_VERTEX" name="Atom #54" />
<nrOfStructures value="6" />
<atomRef index="41" />
<atomRef index="42" />
<atomRef index="55" />
<atomRef index="67" />
<atomRef index="66" />
<atomRef index="53" />
</cell>
<cell>
<cellProperties type="POLY_VERTEX" name="Atom #55" />
<nrOfStructures value="6" />
<atomRef index="42" />
<atomRef index="43" />
<atomRef index="44" />
<atomRef index="56" />
<atomRef index="67" />
<atomRef index="54" />
</cell>
<cell>
<cellProperties type="POLY_VERTEX" name="Atom #56" />
<nrOfStructures value="6" />
<atomRef index="44" />
<atomRef index="45" />
<atomRef index="57" />
<atomRef index="68" />
<atomRef index="67" />
<atomRef index="55" />
</cell>
<cell>
<cellProperties type="POLY_VERTEX" name="Atom #57" />
<nrOfStructures value="6" />
<atomRef index="45" />
<atomRef index="46" />
<atomRef index="58" />
<atomRef index="69" />
<atomRef index="68" />
<atomRef index="56" />
</cell>
<cell>
<cellProperties type="POLY_VERTEX" name="Atom #58" />
<nrOfStructures value="6" />
<atomRef index="46" />
<atomRef index="59" />
<atomRef index="71" />
<atomRef index="70" />
<atomRef index="69" />
<atomRef index="57" />
</cell>
<cell>
<cellProperties type="POLY_VERTEX" name="Atom #59" />
<nrOfStructures value="6" />
<atomRef index="46" />
<atomRef index="47" />
<atomRef index="60" />
<atomRef index="72" />
<atomRef index="71" />
<atomRef index="58" />
</cell>
<cell>
<cellProperties type="POLY_VERTEX" name="Atom #60" />
<nrOfStructures value="6" />
<atomRef index="47" />
<atomRef index="48" />
<atomRef index="49" />
<atomRef index="61" />
<atomRef index="72" />
<atomRef index="59" />
</cell>
<cell>
<cellProperties type="POLY_VERTEX" name="Atom #61" />
<nrOfStructures value="6" />
<atomRef index="49" />
<atomRef index="50" />
<atomRef index="62" />
<atomRef index="73" />
<atomRef index="72" />
<atomRef index="60" />
</cell>
<cell>
<cellProperties type="POLY_VERTEX" name="Atom #62" />
<nrOfStructures value="6" />
<atomRef index="50" />
<atomRef index="51" />
<atomRef index="63" />
<atomRef index="74" />
<atomRef index="73" />
<atomRef index="61" />
</cell>
<cell>
<cellProperties type="POLY_VERTEX" name="Atom #63" />
<nrOfStructures value="6" />
<atomRef index="51" />
<atomRef index="52" />
<atomRef index="64" />
<atomRef index="75" />
<atomRef index="74" />
<atomRef index="62" />
</cell>
<cell>
<cellProperties type="POLY_VERTEX" name="Atom #64" />
<nrOfStructures value="6" />
<atomRef index="52" />
<atomRef index="65" />
<atomRef index="77" />
<atomRef index="76" />
<atomRef index="75" />
<atomRef index="63" />
</cell>
<cell>
<cellProperties type="POLY_VERTEX" name="Atom #65" />
<nrOfStructures value="6" />
<atomRef index="52" />
<atomRef index="53" />
<atomRef index="66" />
<atomRef index="78" />
<atomRef index="77" />
<atomRef index="64" />
</cell>
<cell>
<cellProperties type="POLY_VERTEX" name="Atom #66" />
<nrOfStructures value="6" />
<atomRef index="53" />
<atomRef index="54" />
<atomRef index="67" />
<atomRef index="79" />
<atomRef index="78" />
<atomRef index="65" />
</cell>
<cell>
<cellProperties type="POLY_VERTEX" name="Atom #67" />
<nrOfStructures value="6" />
<atomRef index="54" />
<atomRef index="55" />
<atomRef index="56" />
<atomRef index="68" />
<atomRef index="79" />
<atomRef index="66" />
</cell>
<cell>
<cellProperties type="POLY_VERTEX" name="Atom #68" />
<nrOfStructures value="6" />
<atomRef index="56" />
<atomRef index="57" />
<atomRef index="69" />
<atomRef index="80" />
<atomRef index="79" />
<atomRef index="67" />
</cell>
<cell>
<cellProperties type="POLY_VERTEX" name="Atom #69" />
<nrOfStructures value="6" />
<atomRef index="57" />
<atomRef index="58" />
<atomRef index="70" />
<atomRef index="81" />
<atomRef index="80" />
<atomRef index="68" />
</cell>
<cell>
<cellProperties type="POLY_VERTEX" name="Atom #70" />
<nrOfStructures value="6" />
<atomRef index="58" />
<atomRef index="71" />
<atomRef index="83" />
<atomRef index="82" />
<atomRef index="81" />
<atomRef index="69" />
</cell>
<cell>
<cellProperties type="POLY_VERTEX" name="Atom #71" />
<nrOfStructures value="6" />
<atomRef index="58" />
<atomRef index="59" />
<atomRef index="72" />
<atomRef index="84" />
<atomRef index="83" />
<atomRef index="70" />
</cell>
<cell>
<cellProperties type="POLY_VERTEX" name="Atom #72" />
<nrOfStructures value="6" />
<atomRef index="59" />
<atomRef index="60" />
<atomRef index="61" />
<atomRef index="73" />
<atomRef index="84" />
<atomRef index="71" />
</cell>
<cell>
<cellProperties type="POLY_VERTEX" name="Atom #73" />
<nrOfStructures value="6" />
<atomRef index="61" />
<atomRef index="62" />
<atomRef index="74" />
<atomRef index="85" />
<atomRef index="84" />
<atomRef index="72" />
</cell>
<cell>
<cellProperties type="POLY_VERTEX" name="Atom #74" />
<nrOfStructures value="6" />
<atomRef index="62" />
<atomRef index="63" />
<atomRef index="75" />
<atomRef index="86" />
<atomRef index="85" />
<atomRef index="73" />
</cell>
<cell>
<cellProperties type="POLY_VERTEX" name="Atom #75" />
<nrOfStructures value="5" />
<atomRef index="63" />
<atomRef index="64" />
<atomRef index="76" />
<atomRef index="86" />
<atomRef index="74" />
</cell>
<cell>
<cellProperties type="POLY_VERTEX" name="Atom #76" />
<nrOfStructures value="5" />
<atomRef index="64" />
<atomRef index="77" />
<atomRef index="87" />
<atomRef index="86" />
<atomRef index="75" />
</cell>
<cell>
<cellProperties type="POLY_VERTEX" name="Atom #77" />
<nrOfStructures value="5" />
<atomRef index="64" />
<atomRef index="65" />
<atomRef index="78" />
<atomRef index="87" />
<atomRef index="76" />
</cell>
<cell>
<cellProperties type="POLY_VERTEX" name="Atom #78" />
<nrOfStructures value="6" />
<atomRef index="65" />
<atomRef index="66" />
<atomRef index="79" />
<atomRef index="88" />
<atomRef index="87" />
<atomRef index="77" />
</cell>
<cell>
<cellProperties type="POLY_VERTEX" name="Atom #79" />
<nrOfStructures value="6" />
<atomRef index="66" />
<atomRef index="67" />
<atomRef index="68" />
<atomRef index="80" />
<atomRef index="88" />
<atomRef index="78" />
</cell>
<cell>
<cellProperties type="POLY_VERTEX" name="Atom #80" />
<nrOfStructures value="6" />
<atomRef index="68" />
<atomRef index="69" />
<atomRef index="81" />
<atomRef index="89" />
<atomRef index="88" />
<atomRef index="79" />
</cell>
<cell>
<cellProperties type="POLY_VERTEX" name="Atom #81" />
<nrOfStructures value="5" />
<atomRef index="69" />
<atomRef index="70" />
<atomRef index="82" />
<atomRef index="89" />
<atomRef index="80" />
</cell>
<cell>
<cellProperties type="POLY_VERTEX" name="Atom #82" />
<nrOfStructures value="5" />
<atomRef index="70" />
<atomRef index="83" />
<atomRef index="90" />
<atomRef index="89" />
<atomRef index="81" />
</cell>
<cell>
<cellProperties type="POLY_VERTEX" name="Atom #83" />
<nrOfStructures value="5" />
<atomRef index="70" />
<atomRef index="71" />
<atomRef index="84" />
<atomRef index="90" />
<atomRef index="82" />
</cell>
<cell>
<cellProperties type="POLY_VERTEX" name="Atom #84" />
<nrOfStructures value="6" />
<atomRef index="71" />
<atomRef index="72" />
<atomRef index="73" />
<atomRef index="85" />
<atomRef index="90" />
<atomRef index="83" />
</cell>
<cell>
<cellProperties type="POLY_VERTEX" name="Atom #85" />
<nrOfStructures value="6" />
<atomRef index="73" />
<atomRef index="74" />
<atomRef index="86" />
<atomRef index="91" />
<atomRef index="90" />
<atomRef index="84" />
</cell>
<cell>
<cellProperties type="POLY_VERTEX" name="Atom #86" />
<nrOfStructures value="6" />
<atomRef index="74" />
<atomRef index="75" />
<atomRef index="76" />
<atomRef index="87" />
<atomRef index="91" />
<atomRef index="85" />
</cell>
<cell>
<cellProperties type="POLY_VERTEX" name="Atom #87" />
<nrOfStructures value="6" />
<atomRef index="76" />
<atomRef index="77" />
<atomRef index="78" />
<atomRef index="88" />
<atomRef index="91" />
<atomRef index="86" />
</cell>
<cell>
<cellProperties type="POLY_VERTEX" name="Atom #88" />
<nrOfStructures value="6" />
<atomRef index="78" />
<atomRef index="79" />
<atomRef index="80" />
<atomRef index="89" />
<atomRef index="91" />
<atomRef index="87" />
</cell>
<cell>
<cellProperties type="POLY_VERTEX" name="Atom #89" />
<nrOfStructures value="6" />
<atomRef index="80" />
<atomRef index="81" />
<atomRef index="82" />
<atomRef index="90" />
<atomRef index="91" />
<atomRef index="88" />
</cell>
<cell>
<cellProperties type="POLY_VERTEX" name="Atom #90" />
<nrOfStructures value="6" />
<atomRef index="82" />
<atomRef index="83" />
<atomRef index="84" />
<atomRef index="85" />
<atomRef index="91" />
<atomRef index="89" />
</cell>
<cell>
<cellProperties type="POLY_VERTEX" name="Atom #91" />
<nrOfStructures value="6" />
<atomRef index="85" />
<atomRef index="86" />
<atomRef index="87" />
<atomRef index="88" />
<atomRef index="89" />
<atomRef index="90" />
</cell>
</structuralComponent>
</multiComponent>
</exclusiveComponents>
<informativeComponents>
<multiComponent name="Informative Components">
<structuralComponent name="muscle_lines">
<nrOfStructures value="12" />
<cell>
<cellProperties type="POLY_LINE" />
<nrOfStructures value="4" />
<atomRef index="37" />
<atomRef index="49" />
<atomRef index="61" />
<atomRef index="73" />
</cell>
<cell>
<cellProperties type="POLY_LINE" />
<nrOfStructures value="4" />
<atomRef index="38" />
<atomRef index="50" />
<atomRef index="62" />
<atomRef index="74" />
</cell>
<cell>
<cellProperties type="POLY_LINE" />
<nrOfStructures value="4" />
<atomRef index="39" />
<atomRef index="51" />
<atomRef index="63" />
<atomRef index="75" />
</cell>
<cell>
<cellProperties type="POLY_LINE" />
<nrOfStructures value="4" />
<atomRef index="40" />
<atomRef index="52" />
<atomRef index="64" />
<atomRef index="76" />
</cell>
<cell>
<cellProperties type="POLY_LINE" />
<nrOfStructures value="4" />
<atomRef index="41" />
<atomRef index="53" />
<atomRef index="65" />
<atomRef index="77" />
</cell>
<cell>
<cellProperties type="POLY_LINE" />
<nrOfStructures value="4" />
<atomRef index="42" />
<atomRef index="54" />
<atomRef index="66" />
<atomRef index="78" />
</cell>
<cell>
<cellProperties type="POLY_LINE" />
<nrOfStructures value="4" />
<atomRef index="43" />
<atomRef index="55" />
<atomRef index="67" />
<atomRef index="79" />
</cell>
<cell>
<cellProperties type="POLY_LINE" />
<nrOfStructures value="4" />
<atomRef index="44" />
<atomRef index="56" />
<atomRef index="68" />
<atomRef index="80" />
</cell>
<cell>
<cellProperties type="POLY_LINE" />
<nrOfStructures value="4" />
<atomRef index="45" />
<atomRef index="57" />
<atomRef index="69" />
<atomRef index="81" />
</cell>
<cell>
<cellProperties type="POLY_LINE" />
<nrOfStructures value="4" />
<atomRef index="46" />
<atomRef index="58" />
<atomRef index="70" />
<atomRef index="82" />
</cell>
<cell>
<cellProperties type="POLY_LINE" />
<nrOfStructures value="4" />
<atomRef index="47" />
<atomRef index="59" />
<atomRef index="71" />
<atomRef index="83" />
</cell>
<cell>
<cellProperties type="POLY_LINE" />
<nrOfStructures value="4" />
<atomRef index="48" />
<atomRef index="60" />
<atomRef index="72" />
<atomRef index="84" />
</cell>
</structuralComponent>
<structuralComponent name="apposition_middle">
<nrOfStructures value="12" />
<atomRef index="49" />
<atomRef index="50" />
<atomRef index="51" />
<atomRef index="52" />
<atomRef index="53" />
<atomRef index="54" />
<atomRef index="55" />
<atomRef index="56" />
<atomRef index="57" />
<atomRef index="58" />
<atomRef index="59" />
<atomRef index="60" />
</structuralComponent>
<structuralComponent name="apposition_top">
<nrOfStructures value="12" />
<atomRef index="61" />
<atomRef index="62" />
<atomRef index="63" />
<atomRef index="64" />
<atomRef index="65" />
<atomRef index="66" />
<atomRef index="67" />
<atomRef index="68" />
<atomRef index="69" />
<atomRef index="70" />
<atomRef index="71" />
<atomRef index="72" />
</structuralComponent>
<structuralComponent name="dome_saddle">
<nrOfStructures value="1" />
<atomRef index="91" />
</structuralComponent>
<structuralComponent name="dome_top_left">
<nrOfStructures value="3" />
<atomRef index="87" />
<atomRef index="88" />
<atomRef index="89" />
</structuralComponent>
<structuralComponent name="dome_top_right">
<nrOfStructures value="3" />
<atomRef index="85" />
<atomRef index="86" />
<atomRef index="90" />
</structuralComponent>
<structuralComponent name="fixed" fixed="true">
<nrOfStructures value="37" />
<atomRef index="0" />
<atomRef index="1" />
<atomRef index="2" />
<atomRef index="3" />
<atomRef index="4" />
<atomRef index="5" />
<atomRef index="6" />
<atomRef index="7" />
<atomRef index="8" />
<atomRef index="9" />
<atomRef index="10" />
<atomRef index="11" />
<atomRef index="12" />
<atomRef index="22" />
<atomRef index="34" />
<atomRef index="46" />
<atomRef index="92" />
<atomRef index="93" />
<atomRef index="94" />
<atomRef index="95" />
<atomRef index="96" />
<atomRef index="97" />
<atomRef index="98" />
<atomRef index="99" />
<atomRef index="100" />
<atomRef index="101" />
<atomRef index="102" />
<atomRef index="103" />
<atomRef index="104" />
<atomRef index="105" />
<atomRef index="106" />
<atomRef index="107" />
<atomRef index="108" />
<atomRef index="109" />
<atomRef index="110" />
<atomRef index="111" />
<atomRef index="112" />
</structuralComponent>
<structuralComponent name="rib_cage_left">
<nrOfStructures value="13" />
<atomRef index="41" />
<atomRef index="42" />
<atomRef index="43" />
<atomRef index="44" />
<atomRef index="45" />
<atomRef index="96" />
<atomRef index="97" />
<atomRef index="98" />
<atomRef index="99" />
<atomRef index="100" />
<atomRef index="107" />
<atomRef index="108" />
<atomRef index="109" />
</structuralComponent>
<structuralComponent name="rib_cage_right">
<nrOfStructures value="13" />
<atomRef index="37" />
<atomRef index="38" />
<atomRef index="39" />
<atomRef index="47" />
<atomRef index="48" />
<atomRef index="92" />
<atomRef index="93" />
<atomRef index="94" />
<atomRef index="102" />
<atomRef index="103" />
<atomRef index="104" />
<atomRef index="105" />
<atomRef index="111" />
</structuralComponent>
<structuralComponent name="spine">
<nrOfStructures value="3" />
<atomRef index="22" />
<atomRef index="34" />
<atomRef index="46" />
</structuralComponent>
<structuralComponent name="tendon_border">
<nrOfStructures value="12" />
<atomRef index="73" />
<atomRef index="74" />
<atomRef index="75" />
<atomRef index="76" />
<atomRef index="77" />
<atomRef index="78" />
<atomRef index="79" />
<atomRef index="80" />
<atomRef index="81" />
<atomRef index="82" />
<atomRef index="83" />
<atomRef index="84" />
</structuralComponent>
<structuralComponent name="zone_of_apposition_left">
<nrOfStructures value="10" />
<atomRef index="53" />
<atomRef index="54" />
<atomRef index="55" />
<atomRef index="56" />
<atomRef index="57" />
<atomRef index="65" />
<atomRef index="66" />
<atomRef index="67" />
<atomRef index="68" />
<atomRef index="69" />
</structuralComponent>
<structuralComponent name="zone_of_apposition_right">
<nrOfStructures value="10" />
<atomRef index="49" />
<atomRef index="50" />
<atomRef index="51" />
<atomRef index="59" />
<atomRef index="60" />
<atomRef index="61" />
<atomRef index="62" />
<atomRef index="63" />
<atomRef index="71" />
<atomRef index="72" />
</structuralComponent>
</multiComponent>
</informativeComponents>
</physicalModel>
