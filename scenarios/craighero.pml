<?xml version="1.0" encoding="UTF-8"?>
<physicalModel name="craighero" unit="mm" axes="RAS" fineness="1" nrOfAtoms="113" nrOfExclusiveComponents="3" nrOfInformativeComponents="13" nrOfCells="384">
<atoms>
<structuralComponent name="particles">
<nrOfStructures value="113" />
<atom>
<atomProperties index="0" x="-3.4547423150738172" y="-3.098147905976689" z="-103.54924968050874" />
</atom>
<atom>
<atomProperties index="1" x="144.79231350477406" y="3.9649434632859517" z="-98.3965193936131" />
</atom>
<atom>
<atomProperties index="2" x="122.37627058007888" y="50.83527382098349" z="-99.15649206242259" />
</atom>
<atom>
<atomProperties index="3" x="66.04770154575468" y="82.91725065408174" z="-101.66122495530465" />
</atom>
<atom>
<atomProperties index="4" x="-8.347649050196175" y="92.20173666896923" z="-105.43181002813881" />
</atom>
<atom>
<atomProperties index="5" x="-82.25689230391326" y="75.18799002620122" z="-108.20269570417528" />
</atom>
<atom>
<atomProperties index="6" x="-133.12325520827267" y="36.94564381965517" z="-108.56914993204593" />
</atom>
<atom>
<atomProperties index="7" x="-149.527213511786" y="-9.3865109319327" z="-107.69823039214407" />
</atom>
<atom>
<atomProperties index="8" x="-128.1336780805013" y="-55.62328578584971" z="-107.35776396680366" />
</atom>
<atom>
<atomProperties index="9" x="-73.01938830711741" y="-89.1600163057658" z="-105.47882967042833" />
</atom>
<atom>
<atomProperties index="10" x="1.5701777215718693" y="-99.06448713032401" z="-101.87781849838741" />
</atom>
<atom>
<atomProperties index="11" x="75.5017043282426" y="-82.4799501653018" z="-98.8354165168863" />
</atom>
<atom>
<atomProperties index="12" x="127.8737907645571" y="-44.66627669299461" z="-97.91208522783467" />
</atom>
<atom>
<atomProperties index="13" x="147.87292637087492" y="4.616083476401406" z="-32.220206751307934" />
</atom>
<atom>
<atomProperties index="14" x="122.16808806598743" y="51.0812698656712" z="-30.96617171431186" />
</atom>
<atom>
<atomProperties index="15" x="62.96253562197196" y="79.06076075651204" z="-17.876805968824268" />
</atom>
<atom>
<atomProperties index="16" x="-13.470781848201728" y="90.7745405155759" z="0.8116756530073127" />
</atom>
<atom>
<atomProperties index="17" x="-88.29599931761706" y="79.20890540984898" z="-19.646391071139828" />
</atom>
<atom>
<atomProperties index="18" x="-139.91222505415325" y="41.184773350317485" z="-35.58604977413768" />
</atom>
<atom>
<atomProperties index="19" x="-154.23483382848767" y="-8.20022051631368" z="-36.41827119485466" />
</atom>
<atom>
<atomProperties index="20" x="-129.63229778806033" y="-52.73903762626057" z="-32.28814239938516" />
</atom>
<atom>
<atomProperties index="21" x="-74.03480925329676" y="-84.13280436346496" z="-25.258181542842316" />
</atom>
<atom>
<atomProperties index="22" x="0.21771009022657878" y="-95.30022690903253" z="-20.47167913302156" />
</atom>
<atom>
<atomProperties index="23" x="75.01637947157337" y="-82.61041752386222" z="-21.765842166240862" />
</atom>
<atom>
<atomProperties index="24" x="130.31843533767773" y="-46.02387061172846" z="-27.662779822251434" />
</atom>
<atom>
<atomProperties index="25" x="148.98211844889292" y="5.028001699714351" z="35.82522594664886" />
</atom>
<atom>
<atomProperties index="26" x="119.62420181495133" y="49.19019086608849" z="37.00876360761959" />
</atom>
<atom>
<atomProperties index="27" x="61.3192603083199" y="75.94490614686495" z="64.46485091110284" />
</atom>
<atom>
<atomProperties index="28" x="-15.153380185057276" y="98.08782166446609" z="107.75418816198778" />
</atom>
<atom>
<atomProperties index="29" x="-93.42134425503328" y="82.52837778581632" z="70.10810735100448" />
</atom>
<atom>
<atomProperties index="30" x="-145.98137038817404" y="45.04478618913635" z="40.30087971411814" />
</atom>
<atom>
<atomProperties index="31" x="-157.41382088505472" y="-6.768258614319251" z="36.42625348558754" />
</atom>
<atom>
<atomProperties index="32" x="-130.04397628029392" y="-49.72335508428144" z="42.69657354255207" />
</atom>
<atom>
<atomProperties index="33" x="-75.5696135836059" y="-82.77414316507915" z="54.67674744992873" />
</atom>
<atom>
<atomProperties index="34" x="-1.3356736453302755" y="-94.75385612161558" z="60.8771290400793" />
</atom>
<atom>
<atomProperties index="35" x="73.57896401761307" y="-80.92915446005584" z="55.35594825919704" />
</atom>
<atom>
<atomProperties index="36" x="130.19862718845442" y="-46.19391460426258" z="44.0334788573728" />
</atom>
<atom>
<atomProperties index="37" x="143.7721595773831" y="5.500849931661108" z="103.71826996947642" />
</atom>
<atom>
<atomProperties index="38" x="118.21470597267168" y="47.78893096138732" z="103.24404816604526" />
</atom>
<atom>
<atomProperties index="39" x="68.43370034606022" y="85.93128084775968" z="147.0027182142541" />
</atom>
<atom>
<atomProperties index="40" x="-10.1538962054873" y="90.63531460449437" z="219.69762769030842" />
</atom>
<atom>
<atomProperties index="41" x="-101.15750646711228" y="91.78922372125251" z="161.90378942338833" />
</atom>
<atom>
<atomProperties index="42" x="-144.22706377987285" y="42.325168719335636" z="119.17513800764493" />
</atom>
<atom>
<atomProperties index="43" x="-154.61624279483638" y="-6.264748056698508" z="110.11693306528966" />
</atom>
<atom>
<atomProperties index="44" x="-134.63241811089028" y="-53.289048081106564" z="118.18686622947072" />
</atom>
<atom>
<atomProperties index="45" x="-75.23465351394083" y="-86.58999996031427" z="136.45175987496796" />
</atom>
<atom>
<atomProperties index="46" x="2.049528513176995" y="-92.58158046579146" z="143.10611927471385" />
</atom>
<atom>
<atomProperties index="47" x="72.8639768905605" y="-80.88850788842045" z="131.4914837537394" />
</atom>
<atom>
<atomProperties index="48" x="128.7892682212063" y="-44.361717140714354" z="114.76779669388922" />
</atom>
<atom>
<atomProperties index="49" x="141.08958233982756" y="6.7639327155803315" z="164.2071642087168" />
</atom>
<atom>
<atomProperties index="50" x="116.05255135959389" y="47.0442499858213" z="163.6414136134141" />
</atom>
<atom>
<atomProperties index="51" x="66.23152290407806" y="78.95811965976388" z="194.47721445026605" />
</atom>
<atom>
<atomProperties index="52" x="-10.670185646791674" y="76.769759453604" z="235.77998902354292" />
</atom>
<atom>
<atomProperties index="53" x="-92.7035313248989" y="80.3661862591287" z="203.6765608160751" />
</atom>
<atom>
<atomProperties index="54" x="-142.6706427210897" y="42.41952650278387" z="173.5970955102114" />
</atom>
<atom>
<atomProperties index="55" x="-152.67460918143232" y="-8.903825845843967" z="167.7397135577901" />
</atom>
<atom>
<atomProperties index="56" x="-135.44129786114843" y="-59.17022366017499" z="172.99392597078318" />
</atom>
<atom>
<atomProperties index="57" x="-70.46738294260216" y="-82.832434188366" z="183.36614268340773" />
</atom>
<atom>
<atomProperties index="58" x="4.215687742780757" y="-76.52463537912294" z="184.78390436395887" />
</atom>
<atom>
<atomProperties index="59" x="74.64910054795935" y="-74.23583991532325" z="184.46246369479059" />
</atom>
<atom>
<atomProperties index="60" x="127.80159811108847" y="-41.08195578699929" z="172.7602956161048" />
</atom>
<atom>
<atomProperties index="61" x="134.8004821598785" y="8.084506223376312" z="226.55658102599702" />
</atom>
<atom>
<atomProperties index="62" x="116.56275204434698" y="48.608877440817594" z="227.52068862923502" />
</atom>
<atom>
<atomProperties index="63" x="60.925596835486445" y="70.49652040145259" z="233.06972594321846" />
</atom>
<atom>
<atomProperties index="64" x="-11.501313339472564" y="71.61388063095087" z="238.09033403842446" />
</atom>
<atom>
<atomProperties index="65" x="-83.57370934433312" y="64.38925689411825" z="230.4102689367448" />
</atom>
<atom>
<atomProperties index="66" x="-142.45165498330456" y="41.74066437575882" z="227.1006092594758" />
</atom>
<atom>
<atomProperties index="67" x="-147.55746267984074" y="-8.217335049536652" z="221.87154972755235" />
</atom>
<atom>
<atomProperties index="68" x="-136.78745700413427" y="-60.88498041828605" z="226.62921615990606" />
</atom>
<atom>
<atomProperties index="69" x="-66.00059834788372" y="-82.30477848893685" z="227.58723278131276" />
</atom>
<atom>
<atomProperties index="70" x="6.3407910371193905" y="-60.65697628097603" z="216.68697847141488" />
</atom>
<atom>
<atomProperties index="71" x="69.46439280351134" y="-70.39398172056669" z="240.25112831814417" />
</atom>
<atom>
<atomProperties index="72" x="126.73944557462762" y="-40.12070922661284" z="237.61253835448142" />
</atom>
<atom>
<atomProperties index="73" x="114.72042429957476" y="8.907378310534478" z="280.02289273133" />
</atom>
<atom>
<atomProperties index="74" x="88.81324711542005" y="47.037076265684675" z="276.37989414801746" />
</atom>
<atom>
<atomProperties index="75" x="42.768202275744414" y="55.59013325154137" z="259.5509909146848" />
</atom>
<atom>
<atomProperties index="76" x="-13.293559857132948" y="61.37469549969182" z="247.36697091177362" />
</atom>
<atom>
<atomProperties index="77" x="-71.58001659849205" y="52.23225088650354" z="246.7075237525953" />
</atom>
<atom>
<atomProperties index="78" x="-116.31354686505261" y="33.53941298664507" z="262.2074855111837" />
</atom>
<atom>
<atomProperties index="79" x="-138.89857991858463" y="-5.923757055710635" z="268.53363033282386" />
</atom>
<atom>
<atomProperties index="80" x="-113.54446620069866" y="-53.41428263631772" z="271.3425352480981" />
</atom>
<atom>
<atomProperties index="81" x="-56.945019206360676" y="-75.69872566884641" z="264.5354579587323" />
</atom>
<atom>
<atomProperties index="82" x="-13.732954153097324" y="-44.624168855598555" z="234.13889108886372" />
</atom>
<atom>
<atomProperties index="83" x="43.249922336983964" y="-36.71908873599156" z="253.15304898261076" />
</atom>
<atom>
<atomProperties index="84" x="87.25579672661247" y="-27.61157633160177" z="274.84080245723624" />
</atom>
<atom>
<atomProperties index="85" x="72.80535349771732" y="7.728278778637554" z="290.29477477743103" />
</atom>
<atom>
<atomProperties index="86" x="27.219816763334276" y="48.41971500958349" z="270.3130134270939" />
</atom>
<atom>
<atomProperties index="87" x="-60.994185746452416" y="40.93828972583486" z="253.95483847522178" />
</atom>
<atom>
<atomProperties index="88" x="-106.2536278676177" y="-1.4598059770329903" z="282.16644197912495" />
</atom>
<atom>
<atomProperties index="89" x="-56.23636315890643" y="-48.782482699596095" z="271.4889886843256" />
</atom>
<atom>
<atomProperties index="90" x="29.294668174766475" y="-29.450105924445324" z="249.43066070957147" />
</atom>
<atom>
<atomProperties index="91" x="-18.721267378785562" y="2.7096882776871305" z="261.1436023315632" />
</atom>
<atom>
<atomProperties index="92" x="146.94215843329982" y="20.15252990051803" z="349.31298709511043" />
</atom>
<atom>
<atomProperties index="93" x="108.56014359896587" y="65.46421398505348" z="343.0346190893804" />
</atom>
<atom>
<atomProperties index="94" x="49.0054545784155" y="85.40312617511165" z="335.6784430459568" />
</atom>
<atom>
<atomProperties index="95" x="-24.413506403290558" y="92.95783243990127" z="333.8245842367869" />
</atom>
<atom>
<atomProperties index="96" x="-90.28072764068229" y="66.59075810467829" z="325.2147682680874" />
</atom>
<atom>
<atomProperties index="97" x="-133.29741009514117" y="29.770868021733953" z="327.32019147876014" />
</atom>
<atom>
<atomProperties index="98" x="-165.9651009996357" y="-11.180033484565673" z="333.6681480559082" />
</atom>
<atom>
<atomProperties index="99" x="-127.2019836718398" y="-57.08130043538027" z="331.6231517851404" />
</atom>
<atom>
<atomProperties index="100" x="-73.5006567951362" y="-74.86551382005682" z="322.62018275646227" />
</atom>
<atom>
<atomProperties index="101" x="-4.945530316724415" y="-90.71432046476497" z="326.7588276065862" />
</atom>
<atom>
<atomProperties index="102" x="59.365360509133225" y="-46.99331277772985" z="338.5222837256438" />
</atom>
<atom>
<atomProperties index="103" x="111.84246343996037" y="-26.329927431292283" z="352.63041859636576" />
</atom>
<atom>
<atomProperties index="104" x="73.65363167010335" y="20.159694286601063" z="425.36410008647033" />
</atom>
<atom>
<atomProperties index="105" x="38.89939683375476" y="56.923366244405656" z="413.08046430971564" />
</atom>
<atom>
<atomProperties index="106" x="-27.680854413558915" y="63.57362032430392" z="407.14949852316266" />
</atom>
<atom>
<atomProperties index="107" x="-86.13210154580689" y="36.75065127866138" z="400.93589549655945" />
</atom>
<atom>
<atomProperties index="108" x="-106.4041303052688" y="-6.00004224662247" z="402.4559304460495" />
</atom>
<atom>
<atomProperties index="109" x="-76.05150823242026" y="-39.324922321185745" z="397.78074416291344" />
</atom>
<atom>
<atomProperties index="110" x="-15.961420791078117" y="-52.54836097950292" z="408.960587525468" />
</atom>
<atom>
<atomProperties index="111" x="46.363598683927734" y="-27.15997736974393" z="421.41977058183903" />
</atom>
<atom>
<atomProperties index="112" x="-23.845222939857198" y="7.472001003572065" z="439.1385990385212" />
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
