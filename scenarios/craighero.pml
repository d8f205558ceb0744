<?xml version="1.0" encoding="UTF-8"?>
<physicalModel name="craighero" unit="mm" axes="RAS" fineness="1" nrOfAtoms="113" nrOfExclusiveComponents="3" nrOfInformativeComponents="13" nrOfCells="384">
<atoms>
<structuralComponent name="particles">
<nrOfStructures value="113" />
<atom>
<atomProperties index="0" x="-0.7434839453339696" y="10.786755273256967" z="-112.52035244680543" />
</atom>
<atom>
<atomProperties index="1" x="148.23644547613424" y="21.586419468035714" z="-105.80710723044228" />
</atom>
<atom>
<atomProperties index="2" x="124.6984894914566" y="68.07437514807732" z="-103.9944712012403" />
</atom>
<atom>
<atomProperties index="3" x="67.59843234774011" y="99.30470542478557" z="-105.00842320307999" />
</atom>
<atom>
<atomProperties index="4" x="-8.026246931004534" y="107.11990274625212" z="-108.33317947813255" />
</atom>
<atom>
<atomProperties index="5" x="-82.29159515107084" y="88.34896132303706" z="-111.52103270627026" />
</atom>
<atom>
<atomProperties index="6" x="-133.2796783309865" y="49.03277208661598" z="-114.7475065243542" />
</atom>
<atom>
<atomProperties index="7" x="-149.1208830940099" y="0.2857146723129701" z="-118.19283295040162" />
</atom>
<atom>
<atomProperties index="8" x="-125.78842130246748" y="-46.84131538101355" z="-120.43628058669172" />
</atom>
<atom>
<atomProperties index="9" x="-68.4172841158845" y="-79.0693585307111" z="-120.01335975971676" />
</atom>
<atom>
<atomProperties index="10" x="7.544180538163874" y="-86.73489913898669" z="-116.96263781287107" />
</atom>
<atom>
<atomProperties index="11" x="81.32848101914881" y="-67.48763276630122" z="-113.14115780949098" />
</atom>
<atom>
<atomProperties index="12" x="132.6110469397369" y="-27.650330870894788" z="-109.16935641685744" />
</atom>
<atom>
<atomProperties index="13" x="147.52605280317673" y="17.70423589533713" z="-37.441055120683075" />
</atom>
<atom>
<atomProperties index="14" x="122.09074564492805" y="63.26698312460476" z="-33.74778398664047" />
</atom>
<atom>
<atomProperties index="15" x="63.646902176463726" y="93.17945338153447" z="-19.084832761729718" />
</atom>
<atom>
<atomProperties index="16" x="-13.751451014348246" y="103.57147491732962" z="0.7831609163604231" />
</atom>
<atom>
<atomProperties index="17" x="-87.75175419793565" y="86.6006674322059" z="-20.79504495426708" />
</atom>
<atom>
<atomProperties index="18" x="-137.72659302687677" y="45.64218265464937" z="-37.80122596320155" />
</atom>
<atom>
<atomProperties index="19" x="-152.60175865061788" y="-4.558557732505211" z="-42.04991493126085" />
</atom>
<atom>
<atomProperties index="20" x="-128.05336263825143" y="-51.42503491334701" z="-41.02997559503088" />
</atom>
<atom>
<atomProperties index="21" x="-69.93843831139277" y="-82.51359640635512" z="-35.33364566553879" />
</atom>
<atom>
<atomProperties index="22" x="6.368575829056965" y="-89.49541639102826" z="-30.877346343331684" />
</atom>
<atom>
<atomProperties index="23" x="80.53087193049934" y="-71.47097309087792" z="-33.06076091298166" />
</atom>
<atom>
<atomProperties index="24" x="132.5394335870703" y="-32.34576159520576" z="-36.76885092125129" />
</atom>
<atom>
<atomProperties index="25" x="146.52963688230304" y="14.432624314371571" z="32.26961378847928" />
</atom>
<atom>
<atomProperties index="26" x="118.32170742428067" y="58.02053789859518" z="36.4216630667045" />
</atom>
<atom>
<atomProperties index="27" x="60.68894492897372" y="88.68098154747311" z="65.92949552785196" />
</atom>
<atom>
<atomProperties index="28" x="-17.84302394305862" y="103.01766929669915" z="110.40742149547114" />
</atom>
<atom>
<atomProperties index="29" x="-94.1715199084219" y="87.26268897831977" z="70.46943057478059" />
</atom>
<atom>
<atomProperties index="30" x="-142.27548630347886" y="42.52976185960024" z="39.891105727830336" />
</atom>
<atom>
<atomProperties index="31" x="-154.75260076683276" y="-9.722538953789389" z="34.578977648310946" />
</atom>
<atom>
<atomProperties index="32" x="-128.77804544184147" y="-55.469771113280565" z="38.673242117720605" />
</atom>
<atom>
<atomProperties index="33" x="-70.0986112852835" y="-85.24974599695841" z="50.30946403422543" />
</atom>
<atom>
<atomProperties index="34" x="6.134427762409042" y="-92.21151814134042" z="56.8760997631223" />
</atom>
<atom>
<atomProperties index="35" x="80.58385399255074" y="-73.82439247166198" z="47.762753383128796" />
</atom>
<atom>
<atomProperties index="36" x="133.09007109521096" y="-35.61166277831937" z="37.11902183591126" />
</atom>
<atom>
<atomProperties index="37" x="143.0769716836756" y="12.213773403395185" z="103.54655364892729" />
</atom>
<atom>
<atomProperties index="38" x="113.36766833432735" y="52.85614412431434" z="105.24148301077041" />
</atom>
<atom>
<atomProperties index="39" x="62.42128492282078" y="88.51025568814774" z="151.91347304302215" />
</atom>
<atom>
<atomProperties index="40" x="-19.49903548946567" y="90.4978324732984" z="219.9457990735909" />
</atom>
<atom>
<atomProperties index="41" x="-101.36677080803423" y="91.52021190777073" z="162.74196027815069" />
</atom>
<atom>
<atomProperties index="42" x="-145.49119058480875" y="40.359487018643506" z="118.60456463446384" />
</atom>
<atom>
<atomProperties index="43" x="-153.77478206169684" y="-15.44629330391058" z="110.98135402009834" />
</atom>
<atom>
<atomProperties index="44" x="-129.10470681286827" y="-57.86347282578451" z="118.33402409046973" />
</atom>
<atom>
<atomProperties index="45" x="-66.92866046538116" y="-88.65782391240108" z="137.77651698815566" />
</atom>
<atom>
<atomProperties index="46" x="13.617418532078151" y="-87.60996242853412" z="149.12230385061363" />
</atom>
<atom>
<atomProperties index="47" x="81.06003969430607" y="-77.72007953751172" z="128.49224935784005" />
</atom>
<atom>
<atomProperties index="48" x="134.96179314004854" y="-36.58280127147032" z="112.6707090734696" />
</atom>
<atom>
<atomProperties index="49" x="138.5688919314249" y="13.571549263760181" z="167.38762677147568" />
</atom>
<atom>
<atomProperties index="50" x="110.4803730068878" y="51.820813652627734" z="169.7066611836232" />
</atom>
<atom>
<atomProperties index="51" x="58.51969993906596" y="81.66235694133134" z="193.3604959230733" />
</atom>
<atom>
<atomProperties index="52" x="-20.114953107871113" y="84.78310801696472" z="229.08412510262576" />
</atom>
<atom>
<atomProperties index="53" x="-94.27541425070979" y="83.83358950353117" z="194.32406291703387" />
</atom>
<atom>
<atomProperties index="54" x="-144.02986318994016" y="40.42426145187462" z="168.28576774423027" />
</atom>
<atom>
<atomProperties index="55" x="-152.8806029833574" y="-19.54030382577169" z="162.6815598413542" />
</atom>
<atom>
<atomProperties index="56" x="-129.2643802213239" y="-64.20232539823665" z="169.58732269456772" />
</atom>
<atom>
<atomProperties index="57" x="-60.381588206880295" y="-84.09685823511519" z="183.9711537062051" />
</atom>
<atom>
<atomProperties index="58" x="16.48825093318712" y="-75.65636709797855" z="187.0513698361232" />
</atom>
<atom>
<atomProperties index="59" x="82.0517024660547" y="-72.3031548613233" z="190.1867128686098" />
</atom>
<atom>
<atomProperties index="60" x="131.80088120417022" y="-35.45259854126497" z="176.89758135622174" />
</atom>
<atom>
<atomProperties index="61" x="131.78797611813013" y="18.348016433580536" z="239.9361129276486" />
</atom>
<atom>
<atomProperties index="62" x="107.19153410852411" y="55.68383065396954" z="236.28639058319445" />
</atom>
<atom>
<atomProperties index="63" x="50.70419386790625" y="72.43103537149528" z="225.79661462848256" />
</atom>
<atom>
<atomProperties index="64" x="-20.940922767539224" y="79.2171329028186" z="230.56044707619466" />
</atom>
<atom>
<atomProperties index="65" x="-91.3121519123943" y="69.53621684214414" z="217.41737447779892" />
</atom>
<atom>
<atomProperties index="66" x="-143.60064701898997" y="40.76968138374176" z="216.83784602911504" />
</atom>
<atom>
<atomProperties index="67" x="-147.67819867245703" y="-16.69638563276473" z="212.71533072531022" />
</atom>
<atom>
<atomProperties index="68" x="-133.8448957479981" y="-63.6852675296489" z="220.9887754403758" />
</atom>
<atom>
<atomProperties index="69" x="-56.42693994197411" y="-82.19734727073659" z="224.63259128063356" />
</atom>
<atom>
<atomProperties index="70" x="8.602912162385755" y="-57.466550094036535" z="214.5569198708635" />
</atom>
<atom>
<atomProperties index="71" x="68.70512548399127" y="-67.86270019760325" z="248.52321319898024" />
</atom>
<atom>
<atomProperties index="72" x="127.58976689027502" y="-34.390385302185294" z="250.2368871210831" />
</atom>
<atom>
<atomProperties index="73" x="102.91990650054332" y="16.951569178354607" z="286.07931713810797" />
</atom>
<atom>
<atomProperties index="74" x="76.65462874882034" y="51.2987533350358" z="274.4623821843455" />
</atom>
<atom>
<atomProperties index="75" x="33.96315526950033" y="59.3981736298577" z="252.3251563713066" />
</atom>
<atom>
<atomProperties index="76" x="-22.679259375392785" y="66.74733735426832" z="241.28680085820014" />
</atom>
<atom>
<atomProperties index="77" x="-81.15890731759869" y="56.99919428389648" z="240.32307899910467" />
</atom>
<atom>
<atomProperties index="78" x="-127.07260914821674" y="36.36146216186821" z="256.19763109649904" />
</atom>
<atom>
<atomProperties index="79" x="-143.33186636824462" y="-10.186159638318108" z="260.94115824998283" />
</atom>
<atom>
<atomProperties index="80" x="-115.3641055295721" y="-58.61609002205417" z="266.163534004439" />
</atom>
<atom>
<atomProperties index="81" x="-56.002521610551604" y="-77.40962961628506" z="261.35051906479316" />
</atom>
<atom>
<atomProperties index="82" x="-17.327839534601022" y="-45.84524146356461" z="238.50636506950474" />
</atom>
<atom>
<atomProperties index="83" x="30.238216673803375" y="-26.96274740197662" z="250.49571241363344" />
</atom>
<atom>
<atomProperties index="84" x="76.58231610533578" y="-19.072359899701784" z="277.8109630837944" />
</atom>
<atom>
<atomProperties index="85" x="60.874827669405846" y="12.774002022693697" z="288.90735127668535" />
</atom>
<atom>
<atomProperties index="86" x="18.155594196403907" y="52.018416114863804" z="264.10531080999846" />
</atom>
<atom>
<atomProperties index="87" x="-69.83779394508795" y="45.69000694554478" z="252.31104864238952" />
</atom>
<atom>
<atomProperties index="88" x="-113.2408916607756" y="-0.9898677115752013" z="282.8860394093509" />
</atom>
<atom>
<atomProperties index="89" x="-61.352771909598545" y="-49.40751542576714" z="274.7791100445777" />
</atom>
<atom>
<atomProperties index="90" x="14.276227122211205" y="-25.654239722907363" z="246.4612954347557" />
</atom>
<atom>
<atomProperties index="91" x="-29.61941423998534" y="6.421196618807346" z="261.74740332427365" />
</atom>
<atom>
<atomProperties index="92" x="123.22067838499781" y="37.74845440350189" z="358.75304359624187" />
</atom>
<atom>
<atomProperties index="93" x="87.31509149536518" y="76.61682046048165" z="343.9475498150383" />
</atom>
<atom>
<atomProperties index="94" x="31.784709040194272" y="97.29110592349407" z="329.13949526820653" />
</atom>
<atom>
<atomProperties index="95" x="-41.69957041698042" y="97.93937552867385" z="322.99721222060833" />
</atom>
<atom>
<atomProperties index="96" x="-106.67183377447809" y="71.80964785865012" z="311.1617461232591" />
</atom>
<atom>
<atomProperties index="97" x="-142.7315118150913" y="27.38337122840608" z="312.702505313469" />
</atom>
<atom>
<atomProperties index="98" x="-169.25553384548098" y="-13.001032555249433" z="319.1470571009245" />
</atom>
<atom>
<atomProperties index="99" x="-132.74909026575887" y="-63.65859233634989" z="321.976518892773" />
</atom>
<atom>
<atomProperties index="100" x="-78.1975948306989" y="-76.7536257688084" z="316.8416064944144" />
</atom>
<atom>
<atomProperties index="101" x="-11.628404492943789" y="-81.95789959329828" z="325.52074086506616" />
</atom>
<atom>
<atomProperties index="102" x="52.75666821905834" y="-42.63895531618242" z="346.8349268863583" />
</atom>
<atom>
<atomProperties index="103" x="99.7734900673511" y="-10.841694799848636" z="364.1045413650952" />
</atom>
<atom>
<atomProperties index="104" x="49.83934357984989" y="37.210240729202035" z="426.31399364409094" />
</atom>
<atom>
<atomProperties index="105" x="16.411349375094503" y="70.89625313718327" z="408.62494510607905" />
</atom>
<atom>
<atomProperties index="106" x="-49.336136391285294" y="73.64458431088833" z="397.24698520312785" />
</atom>
<atom>
<atomProperties index="107" x="-105.4570511865825" y="41.49605358435645" z="389.4960460689843" />
</atom>
<atom>
<atomProperties index="108" x="-121.69809686847744" y="-4.759354868335882" z="392.71943031417" />
</atom>
<atom>
<atomProperties index="109" x="-89.7889573878379" y="-40.000380358866956" z="393.3165580805722" />
</atom>
<atom>
<atomProperties index="110" x="-29.630401160783922" y="-45.28561688871993" z="406.7084804241574" />
</atom>
<atom>
<atomProperties index="111" x="28.810437410996265" y="-12.198516962237447" z="424.3819900181314" />
</atom>
<atom>
<atomProperties index="112" x="-44.769901937768815" y="17.296162834728765" z="435.2231036027551" />
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
