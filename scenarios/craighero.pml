<?xml version="1.0" encoding="UTF-8"?>
<physicalModel name="craighero" unit="mm" axes="RAS" fineness="1" nrOfAtoms="113" nrOfExclusiveComponents="3" nrOfInformativeComponents="13" nrOfCells="384">
<atoms>
<structuralComponent name="particles">
<nrOfStructures value="113" />
<atom>
<atomProperties index="0" x="2.639872826459058" y="1.182460961497945" z="-123.62120605696438" />
</atom>
<atom>
<atomProperties index="1" x="153.22715093128735" y="2.510102181593191" z="-113.38644487458534" />
</atom>
<atom>
<atomProperties index="2" x="131.93822118754647" y="51.54897437332876" z="-114.4293786266998" />
</atom>
<atom>
<atomProperties index="3" x="75.90913662170298" y="86.40811720537131" z="-118.6858201618092" />
</atom>
<atom>
<atomProperties index="4" x="1.061893052790695" y="99.04134816781523" z="-124.52987806147692" />
</atom>
<atom>
<atomProperties index="5" x="-74.4400825501104" y="84.46980432362953" z="-129.14424108780253" />
</atom>
<atom>
<atomProperties index="6" x="-127.28264896461964" y="47.56834060209703" z="-131.57471784271377" />
</atom>
<atom>
<atomProperties index="7" x="-145.74347394852776" y="0.5202537408174935" z="-132.41277190170499" />
</atom>
<atom>
<atomProperties index="8" x="-125.6941786874689" y="-48.04101450692545" z="-132.4447959882521" />
</atom>
<atom>
<atomProperties index="9" x="-70.65103181510747" y="-84.5955619337599" z="-129.2373290589663" />
</atom>
<atom>
<atomProperties index="10" x="4.573330457823623" y="-97.17046846013135" z="-122.69394202840327" />
</atom>
<atom>
<atomProperties index="11" x="79.84028852121395" y="-83.03352550622776" z="-116.85128816849398" />
</atom>
<atom>
<atomProperties index="12" x="134.26001954060862" y="-46.55404113845992" z="-113.88297839860032" />
</atom>
<atom>
<atomProperties index="13" x="152.45858005471564" y="2.172689694344546" z="-41.2411672947801" />
</atom>
<atom>
<atomProperties index="14" x="127.97472584499734" y="50.46628189304251" z="-40.632371906042266" />
</atom>
<atom>
<atomProperties index="15" x="69.24482427436389" y="81.68760233081568" z="-29.534640291489527" />
</atom>
<atom>
<atomProperties index="16" x="-7.005280323309506" y="98.02665014723543" z="-11.648514950971272" />
</atom>
<atom>
<atomProperties index="17" x="-82.18081671990366" y="88.87911305615958" z="-32.74328036129549" />
</atom>
<atom>
<atomProperties index="18" x="-134.35334179069585" y="50.0763913607256" z="-50.071650747846626" />
</atom>
<atom>
<atomProperties index="19" x="-150.72025755977916" y="0.4351470144749307" z="-52.659258957093144" />
</atom>
<atom>
<atomProperties index="20" x="-129.08945024145322" y="-46.891458204867014" z="-49.10800192229155" />
</atom>
<atom>
<atomProperties index="21" x="-74.66703109994437" y="-81.24533320038285" z="-40.899835401736766" />
</atom>
<atom>
<atomProperties index="22" x="0.13630966857456317" y="-94.5179424427861" z="-33.618455864067656" />
</atom>
<atom>
<atomProperties index="23" x="76.54860298708562" y="-84.80277167739337" z="-32.79006357131023" />
</atom>
<atom>
<atomProperties index="24" x="133.6112726854563" y="-49.10372371399557" z="-37.41607015387162" />
</atom>
<atom>
<atomProperties index="25" x="149.89017771176066" y="1.1024178360498993" z="31.9359072734644" />
</atom>
<atom>
<atomProperties index="26" x="122.45594031321875" y="47.27858318924384" z="32.005625707972804" />
</atom>
<atom>
<atomProperties index="27" x="64.6984224520129" y="76.13166592730863" z="56.796648792206945" />
</atom>
<atom>
<atomProperties index="28" x="-10.354882145654782" y="99.57551496847005" z="101.60533528578341" />
</atom>
<atom>
<atomProperties index="29" x="-88.93088259295806" y="93.21356643442209" z="66.13588727329436" />
</atom>
<atom>
<atomProperties index="30" x="-140.9244184775222" y="52.85169482367726" z="34.28584730995718" />
</atom>
<atom>
<atomProperties index="31" x="-154.75259803133582" y="0.8887830948418448" z="28.279567983756415" />
</atom>
<atom>
<atomProperties index="32" x="-132.38129018414733" y="-45.45057781131431" z="33.84575155451813" />
</atom>
<atom>
<atomProperties index="33" x="-80.00136243490076" y="-79.24750385828158" z="46.36278928139104" />
</atom>
<atom>
<atomProperties index="34" x="-5.422066335236053" y="-93.0529070179061" z="54.66180636007081" />
</atom>
<atom>
<atomProperties index="35" x="72.103705990853" y="-83.30800647593918" z="51.21168452188751" />
</atom>
<atom>
<atomProperties index="36" x="130.707503254037" y="-50.694681440338975" z="40.13876888553869" />
</atom>
<atom>
<atomProperties index="37" x="143.77796578147476" y="0.1389472358309775" z="104.40572827602729" />
</atom>
<atom>
<atomProperties index="38" x="119.67542340685729" y="46.428014492143234" z="102.50361838051327" />
</atom>
<atom>
<atomProperties index="39" x="72.14081312249935" y="84.59139971991793" z="141.05173475791082" />
</atom>
<atom>
<atomProperties index="40" x="-9.80949782639665" y="90.47385062660564" z="219.42822342464862" />
</atom>
<atom>
<atomProperties index="41" x="-94.31573545989903" y="93.31128448425179" z="168.33316921085577" />
</atom>
<atom>
<atomProperties index="42" x="-140.85460865649918" y="50.20358440161283" z="122.32165381673182" />
</atom>
<atom>
<atomProperties index="43" x="-154.3806150030559" y="0.42143869446685783" z="110.18550093240462" />
</atom>
<atom>
<atomProperties index="44" x="-139.16530930653929" y="-48.33116658247208" z="117.26064534654482" />
</atom>
<atom>
<atomProperties index="45" x="-87.42117705462347" y="-82.54986057137997" z="134.2967243478675" />
</atom>
<atom>
<atomProperties index="46" x="-7.475662791092815" y="-92.96623493445458" z="143.1784307455279" />
</atom>
<atom>
<atomProperties index="47" x="69.55911972123056" y="-81.93548587794106" z="133.6482397654471" />
</atom>
<atom>
<atomProperties index="48" x="125.0607019864764" y="-47.8995210659958" z="116.02053099636089" />
</atom>
<atom>
<atomProperties index="49" x="142.6166147498396" y="0.6583999815401667" z="160.4426513019807" />
</atom>
<atom>
<atomProperties index="50" x="119.42867784053095" y="44.14663051071574" z="158.05616533902722" />
</atom>
<atom>
<atomProperties index="51" x="69.36405581025875" y="79.18783203511258" z="188.90914472881397" />
</atom>
<atom>
<atomProperties index="52" x="-11.144548701089379" y="80.26023547927436" z="232.52191047303955" />
</atom>
<atom>
<atomProperties index="53" x="-89.03958430236139" y="82.92483411266733" z="201.29645382303275" />
</atom>
<atom>
<atomProperties index="54" x="-139.7066738099855" y="48.2470974592587" z="171.23767488188037" />
</atom>
<atom>
<atomProperties index="55" x="-152.94207007949157" y="-1.1593841181027549" z="162.94844103251927" />
</atom>
<atom>
<atomProperties index="56" x="-141.5182167847057" y="-51.35325699401909" z="166.10414569771277" />
</atom>
<atom>
<atomProperties index="57" x="-84.00626178306476" y="-81.83779547004407" z="176.77226696538045" />
</atom>
<atom>
<atomProperties index="58" x="-6.772578127118849" y="-82.09702545392985" z="179.38984244692097" />
</atom>
<atom>
<atomProperties index="59" x="67.93700802651595" y="-76.44582102440836" z="177.46238835315526" />
</atom>
<atom>
<atomProperties index="60" x="123.68175833469745" y="-45.90502223359869" z="168.27976071468987" />
</atom>
<atom>
<atomProperties index="61" x="136.27046894467784" y="-0.1925178510874489" z="217.96858432998195" />
</atom>
<atom>
<atomProperties index="62" x="121.2412987685667" y="44.00492971455432" z="220.09273646626704" />
</atom>
<atom>
<atomProperties index="63" x="64.34767140619451" y="72.03547222233564" z="227.11244661400016" />
</atom>
<atom>
<atomProperties index="64" x="-11.49351003619418" y="77.22552633310711" z="232.48561053397788" />
</atom>
<atom>
<atomProperties index="65" x="-83.94074990808339" y="68.80684325857278" z="222.87295748769236" />
</atom>
<atom>
<atomProperties index="66" x="-141.33408250584299" y="44.95028390315087" z="216.82471073260788" />
</atom>
<atom>
<atomProperties index="67" x="-147.23872810091711" y="-2.2766569538662504" z="211.09383656641683" />
</atom>
<atom>
<atomProperties index="68" x="-142.4390502753295" y="-54.076809655566734" z="214.20843634806315" />
</atom>
<atom>
<atomProperties index="69" x="-79.70547478118614" y="-79.70967729048715" z="217.331087725209" />
</atom>
<atom>
<atomProperties index="70" x="-2.223307447999219" y="-72.97329749322597" z="209.32170242519837" />
</atom>
<atom>
<atomProperties index="71" x="66.43143827753131" y="-72.3998354318214" z="219.7373769993438" />
</atom>
<atom>
<atomProperties index="72" x="122.66094730946726" y="-46.195673793117365" z="223.92114851497692" />
</atom>
<atom>
<atomProperties index="73" x="122.46908119401537" y="-0.4641364702459715" z="273.24934897201155" />
</atom>
<atom>
<atomProperties index="74" x="96.90929790949093" y="46.99978196179549" z="274.64095738062997" />
</atom>
<atom>
<atomProperties index="75" x="45.98432955001863" y="58.0515466774396" z="255.3362846632204" />
</atom>
<atom>
<atomProperties index="76" x="-12.286738927036058" y="65.20214588014615" z="243.22564736687934" />
</atom>
<atom>
<atomProperties index="77" x="-72.86774535440749" y="57.58328653015909" z="241.70043838500683" />
</atom>
<atom>
<atomProperties index="78" x="-121.07629835342826" y="39.399697405232935" z="255.60554698949701" />
</atom>
<atom>
<atomProperties index="79" x="-144.08528859374084" y="-2.1194295869257074" z="257.24112764285127" />
</atom>
<atom>
<atomProperties index="80" x="-125.95468073501773" y="-54.50793539736951" z="263.88426405475997" />
</atom>
<atom>
<atomProperties index="81" x="-68.53211073316292" y="-79.81108699210034" z="253.72355566590383" />
</atom>
<atom>
<atomProperties index="82" x="-14.958789814313857" y="-60.37105489775345" z="232.98629109067903" />
</atom>
<atom>
<atomProperties index="83" x="45.44339643149409" y="-54.1004879113039" z="245.36335080674792" />
</atom>
<atom>
<atomProperties index="84" x="91.0685046805497" y="-43.90619467945326" z="267.6167857349501" />
</atom>
<atom>
<atomProperties index="85" x="77.10641499287753" y="0.4101280804862128" z="289.2674313677677" />
</atom>
<atom>
<atomProperties index="86" x="29.495536441794695" y="49.94312572017757" z="271.4432886219796" />
</atom>
<atom>
<atomProperties index="87" x="-61.990642073465885" y="45.04394276374138" z="252.4438965473615" />
</atom>
<atom>
<atomProperties index="88" x="-112.21732962665989" y="0.4238472089638464" z="282.92105595878655" />
</atom>
<atom>
<atomProperties index="89" x="-61.13515947223552" y="-56.26491696889761" z="272.65059324142123" />
</atom>
<atom>
<atomProperties index="90" x="30.78131629949637" y="-38.28601747022997" z="241.7387553987883" />
</atom>
<atom>
<atomProperties index="91" x="-18.924999138757386" y="0.9718322323263759" z="261.04003608866077" />
</atom>
<atom>
<atomProperties index="92" x="150.91350278109726" y="1.8270670305148053" z="328.70128795334523" />
</atom>
<atom>
<atomProperties index="93" x="116.09662362098472" y="52.271020356660614" z="325.4871795578865" />
</atom>
<atom>
<atomProperties index="94" x="57.146177758622244" y="81.88766658675394" z="321.77195865589835" />
</atom>
<atom>
<atomProperties index="95" x="-19.191946439180686" y="95.92776287281771" z="322.23101815090365" />
</atom>
<atom>
<atomProperties index="96" x="-92.11717948702922" y="75.02530852665188" z="312.163575800359" />
</atom>
<atom>
<atomProperties index="97" x="-141.0721673391552" y="37.49925093980985" z="310.3653073209021" />
</atom>
<atom>
<atomProperties index="98" x="-174.26276781906114" y="-5.988869212997029" z="310.96879814881487" />
</atom>
<atom>
<atomProperties index="99" x="-141.92915428027888" y="-56.325011954622454" z="311.31408388812883" />
</atom>
<atom>
<atomProperties index="100" x="-86.83694128604716" y="-86.63807317715721" z="305.8410923367352" />
</atom>
<atom>
<atomProperties index="101" x="-13.53379649299475" y="-105.7130051002804" z="307.30014057493787" />
</atom>
<atom>
<atomProperties index="102" x="62.06197644035679" y="-78.66941383473095" z="316.43027925368574" />
</atom>
<atom>
<atomProperties index="103" x="113.90158683054676" y="-44.3899322926853" z="326.0068529712316" />
</atom>
<atom>
<atomProperties index="104" x="78.95136532411084" y="1.3815561167938675" z="398.1836927487047" />
</atom>
<atom>
<atomProperties index="105" x="46.629066261742274" y="44.956422875705236" z="392.42308055770525" />
</atom>
<atom>
<atomProperties index="106" x="-23.103356298557795" y="60.478713635737115" z="389.489158292311" />
</atom>
<atom>
<atomProperties index="107" x="-89.13373318108093" y="37.495762097216" z="382.28753661641656" />
</atom>
<atom>
<atomProperties index="108" x="-115.97696430572175" y="-7.354399823337313" z="381.43225152276597" />
</atom>
<atom>
<atomProperties index="109" x="-86.14838252628229" y="-49.81480977514477" z="379.2708841216483" />
</atom>
<atom>
<atomProperties index="110" x="-19.585477025741564" y="-68.65689750247128" z="384.75826919159164" />
</atom>
<atom>
<atomProperties index="111" x="48.97682008673271" y="-45.69769022380342" z="393.18580677030457" />
</atom>
<atom>
<atomProperties index="112" x="-23.01313246072751" y="-3.6267069497135345" z="416.2118860262672" />
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
