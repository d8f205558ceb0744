<?xml version="1.0" encoding="UTF-8"?>
<physicalModel name="craighero" unit="mm" axes="RAS" fineness="1" nrOfAtoms="113" nrOfExclusiveComponents="3" nrOfInformativeComponents="13" nrOfCells="384">
<atoms>
<structuralComponent name="particles">
<nrOfStructures value="113" />
<atom>
<atomProperties index="0" x="-14.126669383237036" y="24.690486419366017" z="-121.11962375309808" />
</atom>
<atom>
<atomProperties index="1" x="137.4223320451714" y="26.577483362914162" z="-121.2815914518647" />
</atom>
<atom>
<atomProperties index="2" x="115.93136218567834" y="76.04684101814253" z="-116.18874444191762" />
</atom>
<atom>
<atomProperties index="3" x="59.33285865787454" y="110.69900069799114" z="-112.96904939723514" />
</atom>
<atom>
<atomProperties index="4" x="-16.038407620229354" y="122.64318965278275" z="-112.91118186110913" />
</atom>
<atom>
<atomProperties index="5" x="-91.67817613241651" y="107.94410977764751" z="-114.82051878638259" />
</atom>
<atom>
<atomProperties index="6" x="-144.75144916264844" y="70.48553490606963" z="-117.29879612914019" />
</atom>
<atom>
<atomProperties index="7" x="-162.9456086061811" y="23.15868237202991" z="-120.37529467503167" />
</atom>
<atom>
<atomProperties index="8" x="-142.54116583052797" y="-24.811039870094206" z="-125.55265982495919" />
</atom>
<atom>
<atomProperties index="9" x="-87.54238212671314" y="-60.76067564599913" z="-129.20078920669238" />
</atom>
<atom>
<atomProperties index="10" x="-12.105986744628" y="-73.50142757422086" z="-128.81434431622074" />
</atom>
<atom>
<atomProperties index="11" x="63.70774191908754" y="-59.4940827373492" z="-126.9050579530979" />
</atom>
<atom>
<atomProperties index="12" x="118.42213290721125" y="-22.807424425122278" z="-124.7356903971754" />
</atom>
<atom>
<atomProperties index="13" x="141.3428541003411" y="19.70610671391545" z="-47.10563807875019" />
</atom>
<atom>
<atomProperties index="14" x="116.5047139761706" y="67.95020040489251" z="-41.46294021372232" />
</atom>
<atom>
<atomProperties index="15" x="58.18330777792362" y="98.76221667664191" z="-24.737895950119228" />
</atom>
<atom>
<atomProperties index="16" x="-17.47666854656705" y="112.25313987392721" z="-2.540290629249542" />
</atom>
<atom>
<atomProperties index="17" x="-93.68109320819305" y="103.9811719221876" z="-21.87957473314732" />
</atom>
<atom>
<atomProperties index="18" x="-146.78810787717393" y="66.93675949622694" z="-39.19375838273814" />
</atom>
<atom>
<atomProperties index="19" x="-162.60051882789264" y="17.194559385167306" z="-43.529337039664554" />
</atom>
<atom>
<atomProperties index="20" x="-139.90118456450872" y="-29.443674845365948" z="-44.28637353531788" />
</atom>
<atom>
<atomProperties index="21" x="-85.5653038726383" y="-64.44544268611764" z="-41.34922413565609" />
</atom>
<atom>
<atomProperties index="22" x="-10.093168416251446" y="-79.45832264193963" z="-38.520495620408695" />
</atom>
<atom>
<atomProperties index="23" x="67.06386891634286" y="-69.6193055698471" z="-41.009120922008215" />
</atom>
<atom>
<atomProperties index="24" x="123.8897063704223" y="-32.67922181344128" z="-46.18745116587285" />
</atom>
<atom>
<atomProperties index="25" x="144.13936057493143" y="12.560083519286525" z="28.326921245894614" />
</atom>
<atom>
<atomProperties index="26" x="115.15829517676443" y="58.713538441223065" z="32.58365341304065" />
</atom>
<atom>
<atomProperties index="27" x="58.39861246616614" y="87.61999550359045" z="61.56678580283897" />
</atom>
<atom>
<atomProperties index="28" x="-15.637448637311657" y="104.99348477034458" z="107.67369624386733" />
</atom>
<atom>
<atomProperties index="29" x="-94.62607787230685" y="98.06212770433335" z="71.98177475514228" />
</atom>
<atom>
<atomProperties index="30" x="-147.635270355873" y="62.48400417096846" z="41.015802703665614" />
</atom>
<atom>
<atomProperties index="31" x="-160.66686042184077" y="11.54471493292691" z="33.952000686425706" />
</atom>
<atom>
<atomProperties index="32" x="-137.61009561906621" y="-34.27660006016765" z="36.080759561167966" />
</atom>
<atom>
<atomProperties index="33" x="-85.84740568311729" y="-71.23697670046612" z="45.58322534614204" />
</atom>
<atom>
<atomProperties index="34" x="-9.93548254907051" y="-87.09081984014367" z="51.63905017300988" />
</atom>
<atom>
<atomProperties index="35" x="69.04227418772906" y="-76.31980619037822" z="46.086529143100044" />
</atom>
<atom>
<atomProperties index="36" x="128.19624322183859" y="-41.77671639081434" z="34.23546607009836" />
</atom>
<atom>
<atomProperties index="37" x="143.57461621628735" y="6.434740418856019" z="104.01154873282262" />
</atom>
<atom>
<atomProperties index="38" x="114.18713600481487" y="52.344523923683674" z="104.84864840551933" />
</atom>
<atom>
<atomProperties index="39" x="68.1586530733996" y="85.897328240131" z="147.12343755860175" />
</atom>
<atom>
<atomProperties index="40" x="-9.849464186321828" y="90.44563249017844" z="219.87274150616892" />
</atom>
<atom>
<atomProperties index="41" x="-97.23285621934318" y="92.19072169816369" z="166.51654380736437" />
</atom>
<atom>
<atomProperties index="42" x="-140.6307412168822" y="50.45817478202386" z="122.53039239365695" />
</atom>
<atom>
<atomProperties index="43" x="-153.90991066516202" y="4.923615043641614" z="110.97989349176763" />
</atom>
<atom>
<atomProperties index="44" x="-141.75112265163318" y="-45.537637613684986" z="116.64121978460038" />
</atom>
<atom>
<atomProperties index="45" x="-87.6443572729324" y="-82.56162327580286" z="133.96096308325522" />
</atom>
<atom>
<atomProperties index="46" x="-5.504173372207187" y="-93.47031494276294" z="141.6253560629157" />
</atom>
<atom>
<atomProperties index="47" x="71.22552966498046" y="-81.47462162959447" z="131.9815317480333" />
</atom>
<atom>
<atomProperties index="48" x="128.57092278896158" y="-44.35522061334987" z="114.83446716069551" />
</atom>
<atom>
<atomProperties index="49" x="142.0948782600464" y="5.548223580297756" z="159.83660220062652" />
</atom>
<atom>
<atomProperties index="50" x="116.61299454093468" y="47.140404366332604" z="159.8531319084095" />
</atom>
<atom>
<atomProperties index="51" x="67.83586511354818" y="79.13219260508171" z="191.3959004200404" />
</atom>
<atom>
<atomProperties index="52" x="-10.138854442408439" y="77.90858033296159" z="234.66512022709145" />
</atom>
<atom>
<atomProperties index="53" x="-90.49061495846685" y="81.40565906520145" z="203.03665256858878" />
</atom>
<atom>
<atomProperties index="54" x="-140.61349556484305" y="46.39620561428431" z="172.95503586904925" />
</atom>
<atom>
<atomProperties index="55" x="-152.49928654522512" y="-1.4338721721984666" z="164.9220756954749" />
</atom>
<atom>
<atomProperties index="56" x="-140.9234594123836" y="-52.106377555117724" z="166.9130975605398" />
</atom>
<atom>
<atomProperties index="57" x="-80.46231586383163" y="-82.4297737543057" z="175.742248044572" />
</atom>
<atom>
<atomProperties index="58" x="-2.2121199746961624" y="-82.51632165825855" z="176.71729924790236" />
</atom>
<atom>
<atomProperties index="59" x="72.2393801479062" y="-76.09794825769677" z="174.0482090574495" />
</atom>
<atom>
<atomProperties index="60" x="127.13639500538146" y="-42.95066706855" z="165.5926371373152" />
</atom>
<atom>
<atomProperties index="61" x="135.60191074268678" y="2.510842271781097" z="214.11448455241856" />
</atom>
<atom>
<atomProperties index="62" x="120.97410478519653" y="44.0317027660099" z="219.0239120420691" />
</atom>
<atom>
<atomProperties index="63" x="65.699925688581" y="71.22140781137637" z="230.21878567006294" />
</atom>
<atom>
<atomProperties index="64" x="-10.510733824930341" y="72.40251609521347" z="237.33456790417208" />
</atom>
<atom>
<atomProperties index="65" x="-83.90466094899145" y="65.47727265301253" z="228.8249892618269" />
</atom>
<atom>
<atomProperties index="66" x="-142.6333977324738" y="42.486695921192805" z="223.1991703165281" />
</atom>
<atom>
<atomProperties index="67" x="-147.11087470876845" y="-5.7421130977330925" z="215.1456276095483" />
</atom>
<atom>
<atomProperties index="68" x="-139.85668684852257" y="-57.753051278860035" z="215.74978384103804" />
</atom>
<atom>
<atomProperties index="69" x="-72.98545742521883" y="-80.24478908294181" z="214.92799711773452" />
</atom>
<atom>
<atomProperties index="70" x="4.484974082232709" y="-70.61605621446165" z="204.826402060508" />
</atom>
<atom>
<atomProperties index="71" x="72.61272657800157" y="-72.40745849282612" z="213.6848213829539" />
</atom>
<atom>
<atomProperties index="72" x="125.62049099041317" y="-41.87229879615538" z="216.55184213884988" />
</atom>
<atom>
<atomProperties index="73" x="126.18805695534135" y="-1.4833323510034662" z="268.0370589486632" />
</atom>
<atom>
<atomProperties index="74" x="100.15288986311685" y="44.685557706274544" z="275.4046413390445" />
</atom>
<atom>
<atomProperties index="75" x="47.52849601295885" y="55.83339037907141" z="260.40045090251675" />
</atom>
<atom>
<atomProperties index="76" x="-11.05620038794369" y="60.126560272135265" z="247.97134284858524" />
</atom>
<atom>
<atomProperties index="77" x="-71.73721001980587" y="51.7733241529892" z="247.2148131350302" />
</atom>
<atom>
<atomProperties index="78" x="-119.2805314320523" y="33.59553192962628" z="262.22165238703536" />
</atom>
<atom>
<atomProperties index="79" x="-142.52579885130834" y="-8.059480168700828" z="262.23978132396496" />
</atom>
<atom>
<atomProperties index="80" x="-120.16997960095895" y="-59.11541854929621" z="263.1026183351716" />
</atom>
<atom>
<atomProperties index="81" x="-62.200274795153284" y="-81.17847524652355" z="248.5195714954609" />
</atom>
<atom>
<atomProperties index="82" x="-9.709586813053551" y="-57.347510334266246" z="227.21975766193097" />
</atom>
<atom>
<atomProperties index="83" x="51.46347824421899" y="-61.1211998024407" z="245.47608344635026" />
</atom>
<atom>
<atomProperties index="84" x="99.06541909282831" y="-46.9907688731412" z="263.41137896532973" />
</atom>
<atom>
<atomProperties index="85" x="81.70696628479253" y="-3.229862195763756" z="288.1862537484114" />
</atom>
<atom>
<atomProperties index="86" x="31.062726207963713" y="45.14199178644618" z="275.1528012976925" />
</atom>
<atom>
<atomProperties index="87" x="-60.40522253072825" y="38.916380367490454" z="255.18400773310717" />
</atom>
<atom>
<atomProperties index="88" x="-108.59205286253784" y="-6.124381727765232" z="284.50471125933655" />
</atom>
<atom>
<atomProperties index="89" x="-56.54235319581288" y="-60.9920313166416" z="269.6510246618575" />
</atom>
<atom>
<atomProperties index="90" x="36.352079994640015" y="-42.38599759504822" z="242.33390286655364" />
</atom>
<atom>
<atomProperties index="91" x="-16.253592113086164" y="-3.44262856290797" z="259.61150130520645" />
</atom>
<atom>
<atomProperties index="92" x="158.9912975063118" y="-3.366233400606485" z="322.6215756922636" />
</atom>
<atom>
<atomProperties index="93" x="124.18783091140385" y="48.70067609761323" z="326.4464839321997" />
</atom>
<atom>
<atomProperties index="94" x="61.0227702392267" y="73.89678026683764" z="325.80805980670067" />
</atom>
<atom>
<atomProperties index="95" x="-15.86730142967511" y="86.8765145034358" z="329.367767137798" />
</atom>
<atom>
<atomProperties index="96" x="-88.60812052652633" y="64.28279642717396" z="319.80764200940365" />
</atom>
<atom>
<atomProperties index="97" x="-136.53327190029174" y="26.6158590015877" z="317.1443688465721" />
</atom>
<atom>
<atomProperties index="98" x="-169.53581358872776" y="-17.456635425009797" z="317.0204634025631" />
</atom>
<atom>
<atomProperties index="99" x="-132.71836021245562" y="-64.87461940946822" z="311.6685312374713" />
</atom>
<atom>
<atomProperties index="100" x="-78.4056750303823" y="-88.6191145527029" z="300.47417433708205" />
</atom>
<atom>
<atomProperties index="101" x="-6.753557695964062" y="-114.7520092388379" z="298.5225021287354" />
</atom>
<atom>
<atomProperties index="102" x="70.11778182861168" y="-86.2825329188764" z="309.37432951497664" />
</atom>
<atom>
<atomProperties index="103" x="125.70417257926836" y="-54.29425437889357" z="319.90908980964326" />
</atom>
<atom>
<atomProperties index="104" x="89.33307746133475" y="-11.277034774261368" z="396.1154616598545" />
</atom>
<atom>
<atomProperties index="105" x="54.454169935875576" y="32.704996281222044" z="394.7137716968148" />
</atom>
<atom>
<atomProperties index="106" x="-16.677562660520444" y="46.00258924369208" z="394.47553500969934" />
</atom>
<atom>
<atomProperties index="107" x="-81.89647236681313" y="22.070817745043136" z="386.88192655642183" />
</atom>
<atom>
<atomProperties index="108" x="-106.91585647036283" y="-22.042489356289288" z="383.3781608810055" />
</atom>
<atom>
<atomProperties index="109" x="-76.17971664923114" y="-60.91039844507273" z="375.5868737750061" />
</atom>
<atom>
<atomProperties index="110" x="-11.287007801702401" y="-81.36887024370485" z="379.4586828521141" />
</atom>
<atom>
<atomProperties index="111" x="58.844254113606425" y="-59.6838771303234" z="388.7063790277395" />
</atom>
<atom>
<atomProperties index="112" x="-14.012563275195959" y="-19.294588286334214" z="415.40061399563666" />
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
