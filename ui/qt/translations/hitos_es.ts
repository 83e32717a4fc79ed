<?xml version="1.0" encoding="utf-8"?>
<!DOCTYPE TS>
<TS version="2.1" language="es_ES" sourcelanguage="en">
<context>
    <name>Advice</name>
    <message>
        <source>The robot drives %1 between scans, which is far for noise of a fixed size at every scan: the path may be lost.</source>
        <translation>El robot avanza %1 entre barridos, mucho para un ruido de tamaño fijo en cada barrido: se puede perder el camino.</translation>
    </message>
    <message>
        <source>The points of a line lie %1 from it, too much for split_merge.dmax: walls break into pieces, and their ends become false corners.</source>
        <translation>Los puntos de una recta distan %1 de ella, demasiado para split_merge.dmax: las paredes se rompen en trozos y sus extremos pasan por esquinas falsas.</translation>
    </message>
    <message>
        <source>%1 of the observations match nothing in the map: what is seen again becomes a new landmark.</source>
        <translation>El %1 de las observaciones no corresponde a nada del mapa: lo que se vuelve a ver se toma por un hito nuevo.</translation>
    </message>
    <message>
        <source>%1 of the scans fitted nothing that was seen before: the robot may have been carried, or its laser blind; the map may be in pieces.</source>
        <translation>El %1 de los barridos no encajó con nada de lo visto antes: quizá alguien movió el robot o su láser no veía; el mapa puede estar en trozos.</translation>
    </message>
    <message>
        <source>The scans lie badly on each other (score %1 of 1): much moves here, or the odometry and the laser do not belong together.</source>
        <translation>Los barridos se superponen mal (puntuación %1 de 1): hay mucho en movimiento, o la odometría y el láser no se corresponden.</translation>
    </message>
    <message>
        <source>No loop was closed in %1: nothing shows whether the map is bent.</source>
        <translation>No se cerró ningún bucle en %1: nada muestra si el mapa está torcido.</translation>
    </message>
    <message>
        <source>The map is less crisp than that of the odometry alone (%1 times the cells per point): do not trust it.</source>
        <translation>El mapa es menos nítido que el de la odometría sola (%1 veces las celdas por punto): no se fíe de él.</translation>
    </message>
    <message>
        <source>This is the recording of a robot (%1), and its scans are not registered: with registration maps of buildings come out right.</source>
        <translation>Esta es la grabación de un robot (%1) y sus barridos no se alinean: con la alineación de barridos los mapas de edificios salen bien.</translation>
    </message>
    <message>
        <source>A loop moved the path by %1 at once: until then the poses told while driving were that far off. Look whether walls meet where it closed.</source>
        <translation>Un bucle movió el camino %1 de una vez: hasta entonces las poses dichas durante la marcha estaban así de lejos. Mire si las paredes casan donde se cerró.</translation>
    </message>
    <message>
        <source>The odometry never moves in %1 scans: either the robot stood still, or the log has no odometry and its map is that of one place.</source>
        <translation>La odometría no se mueve en %1 barridos: o el robot estuvo parado, o el registro no tiene odometría y su mapa es el de un solo lugar.</translation>
    </message>
    <message>
        <source>The odometry jumps from one scan to the next (%1): they have nothing in common, and what follows lies where the jump put it until a loop is closed.</source>
        <translation>La odometría salta de un barrido al siguiente (%1): no tienen nada en común, y lo que sigue queda donde lo puso el salto hasta que se cierre un bucle.</translation>
    </message>
    <message>
        <source>The odometry&apos;s way is %1 times that by the scans: its scale is wrong, and corridors, which only the odometry measures, have a wrong length.</source>
        <translation>El camino de la odometría es %1 veces el de los barridos: su escala es falsa, y los pasillos, que solo mide la odometría, tienen un largo falso.</translation>
    </message>
    <message>
        <source>What was seen does not follow on what was seen just before (scan %1): the robot may have been carried there, the log have a gap, or scans lie too far apart for this odometry. The map may be in pieces.</source>
        <translation>Lo visto no sigue a lo visto justo antes (barrido %1): quizá el robot fue llevado allí, al registro le falta un trozo o los barridos están demasiado lejos para esta odometría. El mapa puede estar en pedazos.</translation>
    </message>
    <message>
        <source>%1 scans lie before the first odometry reading, and the robot is taken to have stood still until then: if it moved, leave them out (source.early_scans).</source>
        <translation>%1 barridos son anteriores a la primera lectura de odometría, y se supone que hasta ella el robot estuvo parado: si se movía, omítalos (source.early_scans).</translation>
    </message>
    <message>
        <source>No pose of the reference trajectory is within %1 of a scan, so no error is told: are the clocks the same? Of a slow reference --tolerance takes poses that are further away.</source>
        <translation>Ninguna pose de la trayectoria de referencia está a menos de %1 de un barrido, así que no se da ningún error: ¿son los mismos los relojes? De una referencia lenta, --tolerance admite poses más alejadas.</translation>
    </message>
    <message>
        <source>Paths keep the scans&apos; own stamps, without the %1 of the scan delay, and the reference is compared by these: where its clock is the odometry&apos;s, subtract them from its stamps.</source>
        <translation>Las trayectorias conservan los instantes propios de los barridos, sin los %1 del retraso de los barridos, y la referencia se compara según ellos: si su reloj es el de la odometría, réstelos de sus instantes.</translation>
    </message>
    <message>
        <source>The reference trajectory tells of less than half of the scans (%1), and the errors are of these alone: is it of this whole tour?</source>
        <translation>La trayectoria de referencia abarca menos de la mitad de los barridos (%1) y los errores son solo de estos: ¿es de todo este recorrido?</translation>
    </message>
    <message>
        <source>Less than half of the landmarks lie within a metre of one of the reference map (%1): is it of this place, and in the frame of the robot&apos;s start?</source>
        <translation>Menos de la mitad de los hitos está a menos de un metro de uno del mapa de referencia (%1): ¿es de este lugar y está en el sistema del punto de partida del robot?</translation>
    </message>
    <message>
        <source>Changes by hand (%1) are of the graph of key scans; with these parameters there is none, and they change nothing.</source>
        <translation>Los cambios a mano (%1) son del grafo de barridos clave; con estos parámetros no lo hay, y no cambian nada.</translation>
    </message>
    <message>
        <source>The tour that begins at scan %1 was not found in the map of the one before: it saw too little of it, or only what several places there have in common. It lies beside that map.</source>
        <translation>El recorrido que empieza en el barrido %1 no se ha encontrado en el mapa del anterior: vio demasiado poco de él, o solo lo que varios sitios de allí tienen en común. Queda junto a ese mapa.</translation>
    </message>
    <message>
        <source>Of a tour that was found in the map of the one before, what comes before a break in it (scan %1) was not: it lies beside that map.</source>
        <translation>De un recorrido que se encontró en el mapa del anterior, lo que viene antes de una ruptura en él (barrido %1) no se encontró: queda junto a ese mapa.</translation>
    </message>
    <message>
        <source>%1 of the scans show no wall and no corner: of trees and posts, which are round, landmarks are made where features.circles is on.</source>
        <translation>El %1 de los barridos no muestra ninguna pared ni esquina: de árboles y postes, que son redondos, se hacen hitos donde features.circles está activado.</translation>
    </message>
    <message>
        <source>The anchors (no. %1 of the changes by hand) do not say where the drawing lies: it takes two walls that are not parallel, two points, or one of each, and further ones to bend the map.</source>
        <translation>Las anclas (n.º %1 de los cambios a mano) no dicen dónde está el dibujo: hacen falta dos paredes que no sean paralelas, dos puntos o una de cada, y otras más para doblar el mapa.</translation>
    </message>
    <message>
        <source>Anchors contradict each other or the map (no. %1 of the changes by hand): what was seen does not lie where the drawing has it. Is each of them the right wall?</source>
        <translation>Hay anclas que se contradicen entre sí o con el mapa (n.º %1 de los cambios a mano): lo visto no está donde lo tiene el dibujo. ¿Es cada una la pared correcta?</translation>
    </message>
    <message>
        <source>The tour that begins at scan %1 was not found in the map of the one before, within 3 m and 30 degrees of where it is said to begin: it begins elsewhere, or saw too little of the map. It lies beside that map.</source>
        <translation>El recorrido que empieza en el barrido %1 no se encontró en el mapa del anterior a menos de 3 m y 30 grados de donde se dice que empieza: empieza en otro sitio, o vio demasiado poco del mapa. Queda al lado de ese mapa.</translation>
    </message>
    <message>
        <source>A place fixed by hand bends the map more than its edges explain (no. %1 of the changes by hand): is it where that scan was (in a file in metres and radians)?</source>
        <translation>Un sitio fijado a mano dobla el mapa más de lo que explican sus aristas (n.º %1 de los cambios a mano): ¿está donde estaba ese barrido (en un archivo, en metros y radianes)?</translation>
    </message>
    <message>
        <source>Loops that were closed by hand lie on hardly anything that the earlier passage saw (scan %1): is the pose that of the later scan, seen from the earlier one (in a file in metres and radians)?</source>
        <translation>Los bucles cerrados a mano apenas caen sobre lo que vio el paso anterior (barrido %1): ¿es la pose la del barrido posterior, vista desde el anterior (en un archivo, en metros y radianes)?</translation>
    </message>
    <message>
        <source>Anchors bend the map more than its edges explain (no. %1 of the changes by hand): is each of them the right wall, and do walls meet?</source>
        <translation>Hay anclas que doblan el mapa más de lo que explican sus aristas (n.º %1 de los cambios a mano): ¿es cada una la pared correcta, y casan las paredes?</translation>
    </message>
    <message>
        <source>A loop that is refused by hand takes its whole stretch with it, and so what other refusals name (no. %1 of the list): those behind the arrow have met nothing to change, and change nothing.</source>
        <translation>Un bucle rechazado a mano se lleva todo su tramo, y con él lo que nombran otros rechazos (n.º %1 de la lista): los que siguen a la flecha no han encontrado nada que cambiar y no cambian nada.</translation>
    </message>
    <message>
        <source>Changes by hand have met nothing to change (no. %1 of the list): no loop was found there, as where something else joins the passages, or the tour has not come to those scans.</source>
        <translation>Hay cambios a mano que no han encontrado nada que cambiar (n.º %1 de la lista): allí no se encontró ningún bucle, como donde otra cosa une las dos pasadas, o el recorrido no ha llegado a esos barridos.</translation>
    </message>
    <message>
        <source>The reference map has its angles in radians, where degrees are expected: %1 of the landmarks lie within a metre of one of it as it is.</source>
        <translation>El mapa de referencia tiene los ángulos en radianes, y se esperan grados: %1 de los hitos están a menos de un metro de uno suyo tal como es.</translation>
    </message>
    <message>
        <source>The reference map has rho and theta of its lines in each other&apos;s place: %1 of the landmarks lie within a metre of one of it as it is.</source>
        <translation>El mapa de referencia tiene rho y theta de sus rectas cambiados de lugar: %1 de los hitos están a menos de un metro de uno suyo tal como es.</translation>
    </message>
    <message>
        <source>The reference map is in millimetres, where metres are expected: %1 of the landmarks lie within a metre of one of it as it is.</source>
        <translation>El mapa de referencia está en milímetros, y se esperan metros: %1 de los hitos están a menos de un metro de uno suyo tal como es.</translation>
    </message>
    <message>
        <source>The reference map is in centimetres, where metres are expected: %1 of the landmarks lie within a metre of one of it as it is.</source>
        <translation>El mapa de referencia está en centímetros, y se esperan metros: %1 de los hitos están a menos de un metro de uno suyo tal como es.</translation>
    </message>
    <message>
        <source>The reference map is a mirror image, as where its y axis points the other way: %1 of the landmarks lie within a metre of one of it as it is.</source>
        <translation>El mapa de referencia está reflejado, como cuando su eje y apunta al lado contrario: %1 de los hitos están a menos de un metro de uno suyo tal como es.</translation>
    </message>
    <message>
        <source>The reference map is a mirror image, as where its x axis points the other way: %1 of the landmarks lie within a metre of one of it as it is.</source>
        <translation>El mapa de referencia está reflejado, como cuando su eje x apunta al lado contrario: %1 de los hitos están a menos de un metro de uno suyo tal como es.</translation>
    </message>
    <message>
        <source>The reference map has x and y in each other&apos;s place: %1 of the landmarks lie within a metre of one of it as it is.</source>
        <translation>El mapa de referencia tiene x e y cambiadas de lugar: %1 de los hitos están a menos de un metro de uno suyo tal como es.</translation>
    </message>
    <message>
        <source>Less than four fifths of the landmarks lie within a metre of one of the reference map (%1), and the error is that of the others too: is it of this place, and the whole of it?</source>
        <translation>Menos de cuatro quintos de los hitos están a menos de un metro de uno del mapa de referencia (%1), y el error es también el de los demás: ¿es de este lugar, y de todo él?</translation>
    </message>
    <message>
        <source>The reference trajectory is %1 times as large as the path: it is in millimetres; divide its positions by 1000. Errors against it are none of the path&apos;s.</source>
        <translation>La trayectoria de referencia es %1 veces tan grande como el camino: está en milímetros; divida sus posiciones entre 1000. Los errores respecto a ella no son del camino.</translation>
    </message>
    <message>
        <source>The reference trajectory is %1 times as large as the path: it is in centimetres; divide its positions by 100. Errors against it are none of the path&apos;s.</source>
        <translation>La trayectoria de referencia es %1 veces tan grande como el camino: está en centímetros; divida sus posiciones entre 100. Los errores respecto a ella no son del camino.</translation>
    </message>
    <message>
        <source>The reference trajectory is %1 times as large as the path: it is in feet; multiply its positions by 0.3048. Errors against it are none of the path&apos;s.</source>
        <translation>La trayectoria de referencia es %1 veces tan grande como el camino: está en pies; multiplique sus posiciones por 0.3048. Los errores respecto a ella no son del camino.</translation>
    </message>
    <message>
        <source>The reference trajectory is %1 times as large as the path, piece by piece: one of the two is not in metres. Errors against it are none of the path&apos;s.</source>
        <translation>La trayectoria de referencia es %1 veces tan grande como el camino, trozo a trozo: una de las dos cosas no está en metros. Los errores respecto a ella no son del camino.</translation>
    </message>
    <message>
        <source>The reference trajectory is a mirror image of the path (%1 of the bends): its y axis points the other way, or x and y have changed places. Errors against it are none of the path&apos;s.</source>
        <translation>La trayectoria de referencia es el reflejo del camino en un espejo (%1 de las curvas): su eje y apunta al lado contrario, o x e y están cambiadas de lugar. Los errores respecto a ella no son del camino.</translation>
    </message>
    <message>
        <source>The path is nowhere like the reference trajectory, not even over short pieces (%1 off, after alignment): that is of another tour, or the path went wrong from its start.</source>
        <translation>El camino no se parece en ninguna parte a la trayectoria de referencia, ni siquiera en trozos cortos (a %1, tras alinearlos): es la de otro recorrido, o el camino fue mal desde el principio.</translation>
    </message>
    <message>
        <source>Of the edges %1 turn by more than a whole turn: angles of such a file are radians; are these degrees?</source>
        <translation>De las aristas, %1 giran más de una vuelta entera: los ángulos de un archivo así son radianes; ¿son estos grados?</translation>
    </message>
    <message>
        <source>Solved, the edges are %1 times as far off as their information says: are their numbers metres and radians, and the information the inverse of their covariance? Or are some of them false?</source>
        <translation>Resuelto, las aristas se apartan %1 veces lo que dice su información: ¿son sus números metros y radianes, y la información la inversa de su covarianza? ¿O son falsas algunas?</translation>
    </message>
    <message>
        <source>The reference map is in feet, where metres are expected: %1 of the landmarks lie within a metre of one of it as it is.</source>
        <translation>El mapa de referencia está en pies, y se esperan metros: %1 de los hitos están a menos de un metro de uno suyo tal como es.</translation>
    </message>
    <message>
        <source>The reference trajectory fits the path where its stamps are taken %1 later: its clock is behind that of the scans. Add them to its stamps; errors against it as it is are none of the path&apos;s.</source>
        <translation>La trayectoria de referencia se ajusta al camino si sus marcas de tiempo se toman %1 más tarde: su reloj va atrasado respecto al de los barridos. Súmelos a sus marcas; los errores respecto a ella tal como está no son del camino.</translation>
    </message>
    <message>
        <source>The reference trajectory fits the path where its stamps are taken %1 earlier: its clock is ahead of that of the scans. Subtract them from its stamps; errors against it as it is are none of the path&apos;s.</source>
        <translation>La trayectoria de referencia se ajusta al camino si sus marcas de tiempo se toman %1 antes: su reloj va adelantado respecto al de los barridos. Réstelos de sus marcas; los errores respecto a ella tal como está no son del camino.</translation>
    </message>
    <message>
        <source>The reference trajectory has no headings: its poses all look the same way where the path makes %1 turns. Errors of headings, relative errors and which loops are false are left out; the ATE is of positions alone, and stands.</source>
        <translation>La trayectoria de referencia no tiene orientaciones: todas sus poses miran hacia el mismo lado donde el camino hace %1 giros. Se omiten los errores de orientación, los errores relativos y qué bucles son falsos; el ATE es solo de posiciones, y vale.</translation>
    </message>
    <message>
        <source>The headings of the reference trajectory are none of this path: %1 of its turns are not theirs. Errors of headings, relative errors and which loops are false are left out; the ATE is of positions alone, and stands.</source>
        <translation>Las orientaciones de la trayectoria de referencia no son las de este camino: %1 de sus giros no están en ellas. Se omiten los errores de orientación, los errores relativos y qué bucles son falsos; el ATE es solo de posiciones, y vale.</translation>
    </message>
    <message>
        <source>The headings of the reference trajectory are off by %1, as those of another part of the robot: turn them back by that. Errors of headings, relative errors and which loops are false are left out; the ATE is of positions alone, and stands.</source>
        <translation>Los rumbos de la trayectoria de referencia difieren en %1, como los de otra parte del robot: gírelos de vuelta en eso. Los errores de rumbo, los relativos y qué bucles son falsos se dejan fuera; el ATE es solo de posiciones, y vale.</translation>
    </message>
    <message>
        <source>Odometry alone is nearer to the reference than the path (%1): look where the path breaks, and at its loops.</source>
        <translation>La odometría sola está más cerca de la referencia que el camino (%1): mire dónde se rompe el camino, y sus bucles.</translation>
    </message>
    <message>
        <source>Odometry alone is nearer to the reference than the path (%1): these parameters do not suit this tour.</source>
        <translation>La odometría sola está más cerca de la referencia que el camino (%1): estos parámetros no convienen a este recorrido.</translation>
    </message>
    <message>
        <source>The reference trajectory tells only of a tour that was not found in the map, so no error is told.</source>
        <translation>La trayectoria de referencia solo habla de un recorrido que no se encontró en el mapa, así que no se dice ningún error.</translation>
    </message>
    <message>
        <source>The log&apos;s name (%1) is no UTF-8, which config.cfg has to be: what opens these results later will not find the log. Rename it and run it again.</source>
        <translation>El nombre del registro (%1) no es UTF-8, como ha de serlo config.cfg: quien abra después estos resultados no encontrará el registro. Cámbiele el nombre y vuelva a ejecutarlo.</translation>
    </message>
    <message>
        <source>The reference trajectory has two places at one stamp, up to %1 apart: it is of two robots or tours, and errors against it are none.</source>
        <translation>La trayectoria de referencia tiene dos lugares en un mismo instante, a %1 como mucho uno del otro: es de dos robots o recorridos, y los errores frente a ella no lo son.</translation>
    </message>
</context>
<context>
    <name>Associations</name>
    <message>
        <source>Matched with %1</source>
        <translation>Emparejada con %1</translation>
    </message>
    <message>
        <source>Matched, on probation</source>
        <translation>Emparejada, a prueba</translation>
    </message>
    <message>
        <source>New: %1</source>
        <translation>Nuevo: %1</translation>
    </message>
    <message>
        <source>New, on probation</source>
        <translation>Nuevo, a prueba</translation>
    </message>
    <message>
        <source>Ignored</source>
        <translation>Ignorada</translation>
    </message>
    <message>
        <source>This landmark fits, and no other one is nearly as plausible.</source>
        <translation>Este hito encaja, y ningún otro es ni de lejos tan plausible.</translation>
    </message>
    <message>
        <source>All landmarks that fit are stretches of one wall; the best one takes it.</source>
        <translation>Todos los hitos que encajan son tramos de una misma pared; se la lleva el mejor.</translation>
    </message>
    <message>
        <source>Of all pairings of this scan that go together, the best has this one.</source>
        <translation>De todos los emparejamientos de este barrido compatibles entre sí, el mejor incluye este.</translation>
    </message>
    <message>
        <source>It shows the landmark that an earlier feature of this scan has made.</source>
        <translation>Muestra el hito que ha creado una característica anterior de este barrido.</translation>
    </message>
    <message>
        <source>Several are plausible; one was drawn by their likelihoods.</source>
        <translation>Varios son plausibles; se ha sorteado uno según sus similitudes.</translation>
    </message>
    <message>
        <source>No landmark fits.</source>
        <translation>Ningún hito encaja.</translation>
    </message>
    <message>
        <source>Several landmarks are plausible: it could be any of them.</source>
        <translation>Varios hitos son plausibles: podría ser cualquiera de ellos.</translation>
    </message>
    <message>
        <source>Another feature of the scan fits its landmark better.</source>
        <translation>Otra característica del barrido encaja mejor con su hito.</translation>
    </message>
    <message>
        <source>Landmarks fit it, but together the other features fit them better.</source>
        <translation>Hay hitos que encajan, pero en conjunto las demás características encajan mejor con ellos.</translation>
    </message>
    <message>
        <source>No landmark fits, but the nearest is not far enough for it to be a new one.</source>
        <translation>Ningún hito encaja, pero el más cercano no está lo bastante lejos para que sea uno nuevo.</translation>
    </message>
    <message>
        <source>No landmark fits, and only key scans make new ones.</source>
        <translation>Ningún hito encaja, y solo los barridos clave crean nuevos.</translation>
    </message>
    <message>
        <source>Its landmark was taken out of the map at this scan.</source>
        <translation>Su hito se ha retirado del mapa en este barrido.</translation>
    </message>
    <message>
        <source>fits</source>
        <translation>encaja</translation>
    </message>
    <message>
        <source>does not fit</source>
        <translation>no encaja</translation>
    </message>
    <message>
        <source>was seen elsewhere</source>
        <translation>se vio en otra parte</translation>
    </message>
    <message>
        <source>too far, passed over</source>
        <translation>demasiado lejos, descartado</translation>
    </message>
    <message>
        <source>The sensor said which landmark it is.</source>
        <translation>El sensor ha dicho qué hito es.</translation>
    </message>
    <message>
        <source>New, then merged</source>
        <translation>Nuevo, luego fundido</translation>
    </message>
</context>
<context>
    <name>Calibration</name>
    <message>
        <source>poses</source>
        <translation>poses</translation>
    </message>
    <message>
        <source>landmarks</source>
        <translation>hitos</translation>
    </message>
    <message>
        <source>distances</source>
        <translation>distancias</translation>
    </message>
</context>
<context>
    <name>Disturbance</name>
    <message>
        <source>Push the robot</source>
        <translation>Empujar el robot</translation>
    </message>
    <message>
        <source>Let a wheel slip</source>
        <translation>Hacer patinar una rueda</translation>
    </message>
    <message>
        <source>Blind the laser</source>
        <translation>Cegar el láser</translation>
    </message>
    <message>
        <source>Put a box in the way</source>
        <translation>Poner una caja en el camino</translation>
    </message>
    <message>
        <source>Open a door</source>
        <translation>Abrir una puerta</translation>
    </message>
    <message>
        <source>Close a door</source>
        <translation>Cerrar una puerta</translation>
    </message>
    <message>
        <source>Change the odometry&apos;s noise</source>
        <translation>Cambiar el ruido de la odometría</translation>
    </message>
    <message>
        <source>Change the laser&apos;s noise</source>
        <translation>Cambiar el ruido del láser</translation>
    </message>
    <message>
        <source>carries the robot ahead [m], to its left [m] and round to its left [degrees]; its wheels do not notice</source>
        <translation>lleva el robot hacia delante [m], hacia su izquierda [m] y lo gira a su izquierda [grados]; sus ruedas no lo notan</translation>
    </message>
    <message>
        <source>ahead</source>
        <translation>delante</translation>
    </message>
    <message>
        <source>left</source>
        <translation>izquierda</translation>
    </message>
    <message>
        <source>turn</source>
        <translation>giro</translation>
    </message>
    <message>
        <source>for so long [s] these parts of the left and of the right wheel&apos;s way are lost</source>
        <translation>durante este tiempo [s] se pierden estas partes del camino de la rueda izquierda y de la derecha</translation>
    </message>
    <message>
        <source>seconds</source>
        <translation>segundos</translation>
    </message>
    <message>
        <source>right</source>
        <translation>derecha</translation>
    </message>
    <message>
        <source>for so long [s] no ray gives a reading</source>
        <translation>durante este tiempo [s] ningún rayo da lectura</translation>
    </message>
    <message>
        <source>a square box with its middle there [m] and sides so long [m]</source>
        <translation>una caja cuadrada con el centro ahí [m] y lados de esta longitud [m]</translation>
    </message>
    <message>
        <source>x</source>
        <translation>x</translation>
    </message>
    <message>
        <source>y</source>
        <translation>y</translation>
    </message>
    <message>
        <source>side</source>
        <translation>lado</translation>
    </message>
    <message>
        <source>the door of that number</source>
        <translation>la puerta de ese número</translation>
    </message>
    <message>
        <source>door</source>
        <translation>puerta</translation>
    </message>
    <message>
        <source>the level of odometry.noise from there on</source>
        <translation>el nivel de odometry.noise a partir de ahí</translation>
    </message>
    <message>
        <source>level</source>
        <translation>nivel</translation>
    </message>
    <message>
        <source>the standard deviation of a range [m] from there on</source>
        <translation>la desviación típica de una distancia [m] a partir de ahí</translation>
    </message>
    <message>
        <source>sigma</source>
        <translation>sigma</translation>
    </message>
</context>
<context>
    <name>DrawBar</name>
    <message>
        <source>Select</source>
        <translation>Elegir</translation>
    </message>
    <message>
        <source>Click what is to be changed; a double click takes the whole of it. Drag it, move it by Ctrl and the arrow keys, type its numbers, or delete it.</source>
        <translation>Pulse lo que quiera cambiar; un doble clic lo toma entero. Arrástrelo, muévalo con Ctrl y las flechas, escriba sus números o bórrelo.</translation>
    </message>
    <message>
        <source>Wall</source>
        <translation>Pared</translation>
    </message>
    <message>
        <source>Click point after point; a double click or Escape ends the wall, a click on its beginning closes it. Type a length, Tab, a direction, Return.</source>
        <translation>Pulse punto tras punto; un doble clic o Escape termina la pared, un clic en su principio la cierra. Escriba una longitud, Tab, una dirección, Intro.</translation>
    </message>
    <message>
        <source>Room</source>
        <translation>Sala</translation>
    </message>
    <message>
        <source>Click two opposite corners.</source>
        <translation>Pulse dos esquinas opuestas.</translation>
    </message>
    <message>
        <source>Door</source>
        <translation>Puerta</translation>
    </message>
    <message>
        <source>Click both sides of the door on a wall, which gets a gap there.</source>
        <translation>Pulse los dos lados de la puerta sobre una pared, que se abre ahí.</translation>
    </message>
    <message>
        <source>Box</source>
        <translation>Caja</translation>
    </message>
    <message>
        <source>Click the middle of the box.</source>
        <translation>Pulse el centro de la caja.</translation>
    </message>
    <message>
        <source>Person</source>
        <translation>Persona</translation>
    </message>
    <message>
        <source>Click the way point after point; a double click or Escape ends it, a click on its beginning makes it a round.</source>
        <translation>Pulse su camino punto tras punto; un doble clic o Escape lo termina, un clic en su principio lo hace una ronda.</translation>
    </message>
    <message>
        <source>Way points</source>
        <translation>Puntos de paso</translation>
    </message>
    <message>
        <source>Click where the tour is to lead next.</source>
        <translation>Pulse adonde debe seguir el recorrido.</translation>
    </message>
    <message>
        <source>Start</source>
        <translation>Salida</translation>
    </message>
    <message>
        <source>Click where the robot starts, then where it looks; Escape leaves its heading as it is.</source>
        <translation>Pulse donde sale el robot y después hacia donde mira; Escape deja su orientación como está.</translation>
    </message>
    <message>
        <source>Measure</source>
        <translation>Medir</translation>
    </message>
    <message>
        <source>Click two points.</source>
        <translation>Pulse dos puntos.</translation>
    </message>
</context>
<context>
    <name>DrawingUnit</name>
    <message>
        <source>millimetres</source>
        <translation>milímetros</translation>
    </message>
    <message>
        <source>centimetres</source>
        <translation>centímetros</translation>
    </message>
    <message>
        <source>metres</source>
        <translation>metros</translation>
    </message>
    <message>
        <source>inches</source>
        <translation>pulgadas</translation>
    </message>
    <message>
        <source>feet</source>
        <translation>pies</translation>
    </message>
</context>
<context>
    <name>Errors</name>
    <message>
        <source>line %1: %2</source>
        <translation>línea %1: %2</translation>
    </message>
    <message>
        <source>the %1 &quot;%2&quot; comes too late; add it before anything is read or run</source>
        <translation>%1 «%2»: llega demasiado tarde; añádalo antes de leer o ejecutar nada</translation>
    </message>
    <message>
        <source>found a %1 of the word &quot;%2&quot;; give it one of its own</source>
        <translation>%1: se encontró la palabra «%2»; déle una propia</translation>
    </message>
    <message>
        <source>the %1 &quot;%2&quot; (%3) is known already as %4; give it another word</source>
        <translation>%1 «%2» (%3): ya se conoce como %4; déle otra palabra</translation>
    </message>
    <message>
        <source>found &quot;%1&quot;, expected %2</source>
        <translation>se encontró «%1», se esperaba %2</translation>
    </message>
    <message>
        <source>; choose a folder that you may write to</source>
        <translation>; elija una carpeta en la que pueda escribir</translation>
    </message>
    <message>
        <source>; choose another folder</source>
        <translation>; elija otra carpeta</translation>
    </message>
    <message>
        <source>; create the folder first</source>
        <translation>; cree antes la carpeta</translation>
    </message>
    <message>
        <source>; choose a path whose parent is a folder</source>
        <translation>; elija una ruta que esté dentro de una carpeta</translation>
    </message>
    <message>
        <source>; free some space or choose another disk</source>
        <translation>; libere espacio o elija otro disco</translation>
    </message>
    <message>
        <source>; choose a shorter name</source>
        <translation>; elija un nombre más corto</translation>
    </message>
    <message>
        <source>cannot be written: it is a folder; choose a file name</source>
        <translation>no se puede escribir: es una carpeta; elija un nombre de archivo</translation>
    </message>
    <message>
        <source>cannot be written: it names no file</source>
        <translation>no se puede escribir: no nombra ningún archivo</translation>
    </message>
    <message>
        <source>cannot be written: it is a device or a pipe; choose a file name</source>
        <translation>no se puede escribir: es un dispositivo o una tubería; elija un nombre de archivo</translation>
    </message>
    <message>
        <source>cannot be written</source>
        <translation>no se puede escribir</translation>
    </message>
    <message>
        <source>cannot be compressed</source>
        <translation>no se puede comprimir</translation>
    </message>
    <message>
        <source>writing fails</source>
        <translation>la escritura falla</translation>
    </message>
    <message>
        <source>cannot be put in place</source>
        <translation>no se puede poner en su sitio</translation>
    </message>
    <message>
        <source>Permission denied</source>
        <translation>permiso denegado</translation>
    </message>
    <message>
        <source>Input/output error</source>
        <translation>error de entrada y salida</translation>
    </message>
    <message>
        <source>Is a directory</source>
        <translation>es una carpeta</translation>
    </message>
    <message>
        <source>File name too long</source>
        <translation>nombre de archivo demasiado largo</translation>
    </message>
    <message>
        <source>No such file or directory</source>
        <translation>no existe el archivo o la carpeta</translation>
    </message>
    <message>
        <source>No space left on device</source>
        <translation>no queda espacio en el disco</translation>
    </message>
    <message>
        <source>Not a directory</source>
        <translation>no es una carpeta</translation>
    </message>
    <message>
        <source>Operation not permitted</source>
        <translation>operación no permitida</translation>
    </message>
    <message>
        <source>Read-only file system</source>
        <translation>sistema de archivos de solo lectura</translation>
    </message>
    <message>
        <source>%1 or %2</source>
        <translation>%1 o %2</translation>
    </message>
    <message>
        <source>%1; allowed: %2</source>
        <translation>%1; se permite: %2</translation>
    </message>
    <message>
        <source>%1 is out of range</source>
        <translation>%1 está fuera del rango</translation>
    </message>
    <message>
        <source>%1 is none of the choices</source>
        <translation>%1 no es ninguna de las opciones</translation>
    </message>
    <message>
        <source>%1 is not a number</source>
        <translation>%1 no es un número</translation>
    </message>
    <message>
        <source>%1 is not an integer</source>
        <translation>%1 no es un número entero</translation>
    </message>
    <message>
        <source>%1 to %2%3</source>
        <translation>de %1 a %2%3</translation>
    </message>
    <message>
        <source>integers from %1 to %2%3</source>
        <translation>enteros de %1 a %2%3</translation>
    </message>
    <message>
        <source>one of %1</source>
        <translation>uno de %1</translation>
    </message>
    <message>
        <source>any text</source>
        <translation>cualquier texto</translation>
    </message>
    <message>
        <source>no such parameter; %1</source>
        <translation>no existe ese parámetro; %1</translation>
    </message>
    <message>
        <source>no such parameter; did you mean %1?</source>
        <translation>no existe ese parámetro; ¿quería decir %1?</translation>
    </message>
    <message>
        <source>no such file</source>
        <translation>no existe ese archivo</translation>
    </message>
    <message>
        <source>is a directory; expected a file</source>
        <translation>es una carpeta; se esperaba un archivo</translation>
    </message>
    <message>
        <source>cannot open: %1</source>
        <translation>no se puede abrir: %1</translation>
    </message>
    <message>
        <source>is greater than %1 MiB</source>
        <translation>ocupa más de %1 MiB</translation>
    </message>
    <message>
        <source>cannot read: %1</source>
        <translation>no se puede leer: %1</translation>
    </message>
    <message>
        <source>damaged gzip file: %1</source>
        <translation>archivo gzip dañado: %1</translation>
    </message>
    <message>
        <source>%1 is %2; expected a finite number</source>
        <translation>%1 es %2; se esperaba un número finito</translation>
    </message>
    <message>
        <source>found %1 fields; expected %2 numbers, %3</source>
        <translation>se encontraron %1 campos; se esperaban %2 números, %3</translation>
    </message>
    <message>
        <source>not a line of the format %1</source>
        <translation>no es una línea del formato %1</translation>
    </message>
    <message>
        <source>there is no such file; check the path</source>
        <translation>no existe ese archivo; compruebe la ruta</translation>
    </message>
    <message>
        <source>cannot be opened for reading: %1</source>
        <translation>no se puede abrir para leer: %1</translation>
    </message>
    <message>
        <source>is a folder; choose a log file inside it</source>
        <translation>es una carpeta; elija un registro que esté dentro</translation>
    </message>
    <message>
        <source>is no regular file; copy the log to one first</source>
        <translation>no es un archivo normal; copie antes el registro a uno</translation>
    </message>
    <message>
        <source>reading fails: %1</source>
        <translation>la lectura falla: %1</translation>
    </message>
    <message>
        <source>bytes that are not gzip follow the compressed data</source>
        <translation>tras los datos comprimidos hay bytes que no son gzip</translation>
    </message>
    <message>
        <source>the compressed data end early</source>
        <translation>los datos comprimidos terminan antes de tiempo</translation>
    </message>
    <message>
        <source>the compressed data are damaged</source>
        <translation>los datos comprimidos están dañados</translation>
    </message>
    <message>
        <source>the scan of line %1 (time %2) cannot be written as ranges: %3; write it in the normalized format</source>
        <translation>el barrido de la línea %1 (tiempo %2) no se puede escribir como distancias: %3; escríbalo en el formato normalizado</translation>
    </message>
    <message>
        <source>its rays are none that FLASER says, as which the scans before it are written</source>
        <translation>sus rayos no son los que dice FLASER, como el que se escriben los barridos anteriores</translation>
    </message>
    <message>
        <source>two of its points have one bearing</source>
        <translation>dos de sus puntos tienen la misma dirección</translation>
    </message>
    <message>
        <source>its points do not lie on regular rays</source>
        <translation>sus puntos no están sobre rayos regulares</translation>
    </message>
    <message>
        <source>a point belongs to ray %1 of %2</source>
        <translation>un punto pertenece al rayo %1 de %2</translation>
    </message>
    <message>
        <source>a point is %1 m away, its greatest range is %2 m</source>
        <translation>un punto está a %1 m y su mayor alcance es de %2 m</translation>
    </message>
    <message>
        <source>a whole number from 1</source>
        <translation>un número entero desde 1</translation>
    </message>
    <message>
        <source>a whole number from 0</source>
        <translation>un número entero desde 0</translation>
    </message>
    <message>
        <source>found %1 after %2, expected the end of the line</source>
        <translation>se encontró %1 tras %2, se esperaba el final de la línea</translation>
    </message>
    <message>
        <source>%1: found %2, expected %3</source>
        <translation>%1: se encontró %2, se esperaba %3</translation>
    </message>
    <message>
        <source>%1: found the end of the line, expected a value</source>
        <translation>%1: se encontró el final de la línea, se esperaba un valor</translation>
    </message>
    <message>
        <source>a number</source>
        <translation>un número</translation>
    </message>
    <message>
        <source>a finite number below 1e12</source>
        <translation>un número finito menor que 1e12</translation>
    </message>
    <message>
        <source>a whole number</source>
        <translation>un número entero</translation>
    </message>
    <message>
        <source>the logger&apos;s time</source>
        <translation>la hora del registrador</translation>
    </message>
    <message>
        <source>num_remissions: found %1, but %2 fields follow</source>
        <translation>num_remissions: se encontró %1, pero siguen %2 campos</translation>
    </message>
    <message>
        <source>message name</source>
        <translation>nombre del mensaje</translation>
    </message>
    <message>
        <source>parameter name</source>
        <translation>nombre del parámetro</translation>
    </message>
    <message>
        <source>parameter value</source>
        <translation>valor del parámetro</translation>
    </message>
    <message>
        <source>the points that n announces</source>
        <translation>los puntos que anuncia n</translation>
    </message>
    <message>
        <source>the velocities</source>
        <translation>las velocidades</translation>
    </message>
    <message>
        <source>found no header of a Player line, expected time host robot interface index type subtype</source>
        <translation>no se encontró la cabecera de una línea de Player, se esperaba time host robot interface index type subtype</translation>
    </message>
    <message>
        <source>the frequency</source>
        <translation>la frecuencia</translation>
    </message>
    <message>
        <source>the width</source>
        <translation>la anchura</translation>
    </message>
    <message>
        <source>the readings that the count announces</source>
        <translation>las lecturas que anuncia la cuenta</translation>
    </message>
    <message>
        <source>found the ranges of a ranger whose angles are unknown, expected a line of type 4, subtype 5 before it</source>
        <translation>se encontraron las distancias de un ranger cuyos ángulos no se conocen, se esperaba antes una línea de tipo 4, subtipo 5</translation>
    </message>
    <message>
        <source>the ranges that the count announces</source>
        <translation>las distancias que anuncia la cuenta</translation>
    </message>
    <message>
        <source>readings: found none, expected range bearing intensity</source>
        <translation>lecturas: no se encontró ninguna, se esperaba range bearing intensity</translation>
    </message>
    <message>
        <source>the line is longer than 1 MiB</source>
        <translation>la línea pasa de 1 MiB</translation>
    </message>
    <message>
        <source>the line is not text (it holds control characters)</source>
        <translation>la línea no es texto (contiene caracteres de control)</translation>
    </message>
    <message>
        <source>it is bzip2 data; unpack them first</source>
        <translation>son datos bzip2; descomprímalos antes</translation>
    </message>
    <message>
        <source>it is xz data; unpack them first</source>
        <translation>son datos xz; descomprímalos antes</translation>
    </message>
    <message>
        <source>it is zstd data; unpack them first</source>
        <translation>son datos zstd; descomprímalos antes</translation>
    </message>
    <message>
        <source>it is a zip archive; unpack it first</source>
        <translation>es un archivo zip; descomprímalo antes</translation>
    </message>
    <message>
        <source>it is a PNG picture</source>
        <translation>es una imagen PNG</translation>
    </message>
    <message>
        <source>it is a JPEG picture</source>
        <translation>es una imagen JPEG</translation>
    </message>
    <message>
        <source>it is a PDF document</source>
        <translation>es un documento PDF</translation>
    </message>
    <message>
        <source>it is a program</source>
        <translation>es un programa</translation>
    </message>
    <message>
        <source>is a gzip file that holds nothing</source>
        <translation>es un archivo gzip sin contenido</translation>
    </message>
    <message>
        <source>is empty</source>
        <translation>está vacío</translation>
    </message>
    <message>
        <source>is gzip, but %1 before any line</source>
        <translation>es gzip, pero %1 antes de cualquier línea</translation>
    </message>
    <message>
        <source>it holds control characters</source>
        <translation>contiene caracteres de control</translation>
    </message>
    <message>
        <source>is not text once unpacked: %1</source>
        <translation>una vez descomprimido no es texto: %1</translation>
    </message>
    <message>
        <source>is not text: %1</source>
        <translation>no es texto: %1</translation>
    </message>
    <message>
        <source>holds lines longer than 1 MiB</source>
        <translation>contiene líneas de más de 1 MiB</translation>
    </message>
    <message>
        <source>holds nothing but comments</source>
        <translation>no contiene más que comentarios</translation>
    </message>
    <message>
        <source>no line is one of a format that Hitos reads; the first is &quot;%1&quot;</source>
        <translation>ninguna línea es de un formato que Hitos lea; la primera es «%1»</translation>
    </message>
    <message>
        <source>is not in the format %1 but looks like %2; choose the format %2 or auto</source>
        <translation>no está en el formato %1 sino que parece %2; elija el formato %2 o auto</translation>
    </message>
    <message>
        <source>nothing in it can be read as %1; it holds neither scans nor odometry</source>
        <translation>nada de lo que contiene se puede leer como %1; no tiene barridos ni odometría</translation>
    </message>
    <message>
        <source>nothing in it can be read as %1: %2</source>
        <translation>nada de lo que contiene se puede leer como %1: %2</translation>
    </message>
    <message>
        <source>a table</source>
        <translation>una tabla</translation>
    </message>
    <message>
        <source>an array</source>
        <translation>una lista</translation>
    </message>
    <message>
        <source>a string</source>
        <translation>una cadena de texto</translation>
    </message>
    <message>
        <source>an integer</source>
        <translation>un número entero</translation>
    </message>
    <message>
        <source>a real number</source>
        <translation>un número real</translation>
    </message>
    <message>
        <source>a boolean</source>
        <translation>un valor lógico</translation>
    </message>
    <message>
        <source>a date or time</source>
        <translation>una fecha u hora</translation>
    </message>
    <message>
        <source>a string in quotes</source>
        <translation>una cadena entre comillas</translation>
    </message>
    <message>
        <source>[%1]: no such group</source>
        <translation>[%1]: no existe ese grupo</translation>
    </message>
    <message>
        <source>%1: found %2; expected a table [%1]</source>
        <translation>%1: se encontró %2; se esperaba una tabla [%1]</translation>
    </message>
    <message>
        <source>%1: found %2; expected %3, %4</source>
        <translation>%1: se encontró %2; se esperaba %3, %4</translation>
    </message>
    <message>
        <source>%1 mistakes and perhaps more:</source>
        <translation>%1 errores y quizá más:</translation>
    </message>
    <message>
        <source>%1 mistakes:</source>
        <translation>%1 errores:</translation>
    </message>
    <message>
        <source>%1 is not UTF-8 and cannot stand in a configuration file</source>
        <translation>%1 no es UTF-8 y no puede estar en un archivo de configuración</translation>
    </message>
    <message>
        <source>found the byte 0x%1; expected UTF-8 text</source>
        <translation>se encontró el byte 0x%1; se esperaba texto en UTF-8</translation>
    </message>
    <message>
        <source>no group of parameters has this table</source>
        <translation>ningún grupo de parámetros tiene esta tabla</translation>
    </message>
    <message>
        <source>init.cfg lists all of them</source>
        <translation>init.cfg los enumera todos</translation>
    </message>
    <message>
        <source>expected key=value</source>
        <translation>se esperaba clave=valor</translation>
    </message>
    <message>
        <source>grid.hit and grid.miss both 0 draw nothing; give at least one of them another value</source>
        <translation>con grid.hit y grid.miss a 0 no se dibuja nada; dé otro valor al menos a uno de ellos</translation>
    </message>
    <message>
        <source>%1 m is less than a cell (grid.resolution %2 m); 0 draws rays whole</source>
        <translation>%1 m es menos que una celda (grid.resolution %2 m); 0 dibuja los rayos enteros</translation>
    </message>
    <message>
        <source>says that it reads %1, but there is no such parameter</source>
        <translation>dice que lee %1, pero no existe ese parámetro</translation>
    </message>
    <message>
        <source>expected 5 fields, name x1 y1 x2 y2</source>
        <translation>se esperaban 5 campos, nombre x1 y1 x2 y2</translation>
    </message>
    <message>
        <source>expected a word without commas and quotes</source>
        <translation>se esperaba una palabra sin comas ni comillas</translation>
    </message>
    <message>
        <source>found %1 fields; %2</source>
        <translation>se encontraron %1 campos; %2</translation>
    </message>
    <message>
        <source>the name is %1; %2</source>
        <translation>el nombre es %1; %2</translation>
    </message>
    <message>
        <source>the two points of %1 are %2 m apart; expected points on two walls, at least %3 m apart</source>
        <translation>los dos puntos de %1 están a %2 m; se esperaban puntos sobre dos paredes, al menos a %3 m</translation>
    </message>
    <message>
        <source>%1 stands twice in the file; expected each name once</source>
        <translation>%1 está dos veces en el archivo; se esperaba cada nombre una sola vez</translation>
    </message>
    <message>
        <source>no distance in the file; %1</source>
        <translation>no hay ninguna distancia en el archivo; %1</translation>
    </message>
    <message>
        <source>there is no distance between two walls to write</source>
        <translation>no hay ninguna distancia entre dos paredes que escribir</translation>
    </message>
    <message>
        <source>a distance is named %1; %2</source>
        <translation>una distancia se llama %1; %2</translation>
    </message>
    <message>
        <source>two distances are named %1; expected each name once</source>
        <translation>dos distancias se llaman %1; se esperaba cada nombre una sola vez</translation>
    </message>
    <message>
        <source>the two points of %1 are %2 m apart; expected at least %3 m</source>
        <translation>los dos puntos de %1 están a %2 m; se esperaban al menos %3 m</translation>
    </message>
    <message>
        <source>no landmark was observed</source>
        <translation>no se observó ningún hito</translation>
    </message>
    <message>
        <source>there is no map to put on a sheet</source>
        <translation>no hay ningún mapa que poner en la hoja</translation>
    </message>
    <message>
        <source>%1 maps are too many for one sheet of %2 pixels</source>
        <translation>%1 mapas son demasiados para una hoja de %2 píxeles</translation>
    </message>
    <message>
        <source>a drawing cannot be made in memory: %1</source>
        <translation>no se puede hacer un dibujo en memoria: %1</translation>
    </message>
    <message>
        <source>%1 is at (%2, %3) and cannot be drawn; expected coordinates up to %4 m: check the log&apos;s readings and the motion noise</source>
        <translation>%1: está en (%2, %3) y no se puede dibujar; se esperaban coordenadas de hasta %4 m: compruebe las lecturas del registro y el ruido del movimiento</translation>
    </message>
    <message>
        <source>landmark %1</source>
        <translation>hito %1</translation>
    </message>
    <message>
        <source>segment %1 belongs to landmark %2, which is no line of the map</source>
        <translation>el segmento %1 pertenece al hito %2, que no es una recta del mapa</translation>
    </message>
    <message>
        <source>an end of segment %1</source>
        <translation>un extremo del segmento %1</translation>
    </message>
    <message>
        <source>the path</source>
        <translation>el camino</translation>
    </message>
    <message>
        <source>%1: a drawing cannot be made there</source>
        <translation>%1: ahí no se puede hacer un dibujo</translation>
    </message>
    <message>
        <source>a drawing cannot be made: memory is exhausted</source>
        <translation>no se puede hacer el dibujo: se agotó la memoria</translation>
    </message>
    <message>
        <source>cannot be made: %1</source>
        <translation>no se puede crear: %1</translation>
    </message>
    <message>
        <source>gnuplot is not installed (Debian: gnuplot-nox)</source>
        <translation>gnuplot no está instalado (Debian: gnuplot-nox)</translation>
    </message>
    <message>
        <source>gnuplot fails: %1</source>
        <translation>gnuplot falla: %1</translation>
    </message>
    <message>
        <source>expected &quot;rho: &lt;metres&gt; theta: &lt;degrees&gt;&quot; or &quot;x: &lt;metres&gt; y: &lt;metres&gt;&quot;</source>
        <translation>se esperaba «rho: &lt;metros&gt; theta: &lt;grados&gt;» o «x: &lt;metros&gt; y: &lt;metros&gt;»</translation>
    </message>
    <message>
        <source>found %1 after the feature; expected the end of the line</source>
        <translation>se encontró %1 tras la característica; se esperaba el final de la línea</translation>
    </message>
    <message>
        <source>found %1; %2</source>
        <translation>se encontró %1; %2</translation>
    </message>
    <message>
        <source>no landmark in the file; %1</source>
        <translation>no hay ningún hito en el archivo; %1</translation>
    </message>
    <message>
        <source>line</source>
        <translation>recta</translation>
    </message>
    <message>
        <source>corner</source>
        <translation>esquina</translation>
    </message>
    <message>
        <source>landmark %1 of the map, a %2 (%3, %4), is not finite and cannot be written</source>
        <translation>el hito %1 del mapa, una %2 (%3, %4), no es finito y no se puede escribir</translation>
    </message>
    <message>
        <source>no pose of the reference trajectory is as old as the first scan</source>
        <translation>ninguna pose de la trayectoria de referencia es tan antigua como el primer barrido</translation>
    </message>
    <message>
        <source>nothing was estimated</source>
        <translation>no se estimó nada</translation>
    </message>
    <message>
        <source>found the extension &quot;%1&quot;; pictures are written as .png, .jpg or .jpeg</source>
        <translation>se encontró la extensión «%1»; las imágenes se escriben como .png, .jpg o .jpeg</translation>
    </message>
    <message>
        <source>&quot;%1&quot; is no kind of picture; allowed: one of png, jpg, jpeg</source>
        <translation>«%1» no es un tipo de imagen; se permite: uno de png, jpg, jpeg</translation>
    </message>
    <message>
        <source>JPG holds at most %1 pixels a side and the picture has %2 x %3; write PNG instead</source>
        <translation>JPG admite como mucho %1 píxeles por lado y la imagen tiene %2 x %3; escriba PNG en su lugar</translation>
    </message>
    <message>
        <source>the picture could not be encoded</source>
        <translation>la imagen no se pudo codificar</translation>
    </message>
    <message>
        <source>%1 is out of range; allowed: integers from 1 to %2</source>
        <translation>%1 está fuera del rango; se permite: enteros de 1 a %2</translation>
    </message>
    <message>
        <source>the grid map is empty: there is nothing to draw</source>
        <translation>el mapa de celdas está vacío: no hay nada que dibujar</translation>
    </message>
    <message>
        <source>a picture of %1 x %2 pixels is too great; use a smaller scale or coarser cells</source>
        <translation>una imagen de %1 x %2 píxeles es demasiado grande; use una escala menor o celdas mayores</translation>
    </message>
    <message>
        <source>cannot be read</source>
        <translation>no se puede leer</translation>
    </message>
    <message>
        <source>landmark is %1; expected the number of a line of the map, counted from 1</source>
        <translation>el hito es %1; se esperaba el número de una recta del mapa, contado desde 1</translation>
    </message>
    <message>
        <source>segment %1 belongs to landmark %2, which is no line of the map of %3 landmarks</source>
        <translation>el segmento %1 pertenece al hito %2, que no es una recta del mapa de %3 hitos</translation>
    </message>
    <message>
        <source>segment %1, from (%2, %3) to (%4, %5), is not finite and cannot be written</source>
        <translation>el segmento %1, de (%2, %3) a (%4, %5), no es finito y no se puede escribir</translation>
    </message>
    <message>
        <source>the quaternion&apos;s length is %1; expected 1</source>
        <translation>la longitud del cuaternión es %1; se esperaba 1</translation>
    </message>
    <message>
        <source>no pose in the file; expected 8 numbers, t x y z qx qy qz qw on each line</source>
        <translation>no hay ninguna pose en el archivo; se esperaban 8 números, t x y z qx qy qz qw en cada línea</translation>
    </message>
    <message>
        <source>pose %1 of the trajectory (t %2, x %3, y %4, theta %5) is not finite and cannot be written</source>
        <translation>la pose %1 de la trayectoria (t %2, x %3, y %4, theta %5) no es finita y no se puede escribir</translation>
    </message>
    <message>
        <source>found no readable scan</source>
        <translation>no se encontró ningún barrido legible</translation>
    </message>
    <message>
        <source>%1; expected at least one scan: check the file and its format</source>
        <translation>%1; se esperaba al menos un barrido: compruebe el archivo y su formato</translation>
    </message>
    <message>
        <source>is no folder of results: it has no summary.json; choose one that Save all results or hitos-cli run --out has written</source>
        <translation>no es una carpeta de resultados: no tiene summary.json; elija una que haya escrito Guardar todos los resultados o hitos-cli run --out</translation>
    </message>
    <message>
        <source>is no summary of a run: %1</source>
        <translation>no es el resumen de una ejecución: %1</translation>
    </message>
    <message>
        <source>has a segment of line %1, and map.txt beside it %2 lines; the folder mixes the files of several runs</source>
        <translation>tiene un segmento de la recta %1, y map.txt a su lado %2 rectas; la carpeta mezcla los archivos de varias ejecuciones</translation>
    </message>
    <message>
        <source>found no file name; expected the path of a log</source>
        <translation>no se encontró ningún nombre de archivo; se esperaba la ruta de un registro</translation>
    </message>
    <message>
        <source>cannot make this output folder: %1; give another with --out</source>
        <translation>no se puede crear esta carpeta de salida: %1; dé otra con --out</translation>
    </message>
    <message>
        <source>a file is in its place</source>
        <translation>hay un archivo en su lugar</translation>
    </message>
    <message>
        <source>internal error: %1</source>
        <translation>error interno: %1</translation>
    </message>
    <message>
        <source>%1 of %2 runs are not there: %3%4; start the shards that lack them again</source>
        <translation>faltan %1 de %2 ejecuciones: %3%4; vuelva a lanzar las partes a las que les faltan</translation>
    </message>
    <message>
        <source>is of another study than %1: program, configuration, log, values or seeds differ</source>
        <translation>es de otro estudio que %1: difieren el programa, la configuración, el registro, los valores o las semillas</translation>
    </message>
    <message>
        <source>out of memory; fewer particles, coarser cells of the grid or fewer runs at a time take less</source>
        <translation>no queda memoria; menos partículas, celdas de la rejilla más gruesas o menos ejecuciones a la vez piden menos</translation>
    </message>
    <message>
        <source>cannot be read to its end</source>
        <translation>no se puede leer hasta el final</translation>
    </message>
    <message>
        <source>expected format %1</source>
        <translation>se esperaba el formato %1</translation>
    </message>
    <message>
        <source>%1 is %2; expected a whole number from %3 to %4</source>
        <translation>%1 es %2; se esperaba un número entero de %3 a %4</translation>
    </message>
    <message>
        <source>is a plan of more than %1 runs; the plan is damaged</source>
        <translation>es un plan de más de %1 ejecuciones; el plan está dañado</translation>
    </message>
    <message>
        <source>is nested deeper than %1 levels</source>
        <translation>está anidado a más de %1 niveles</translation>
    </message>
    <message>
        <source>the plan is damaged</source>
        <translation>el plan está dañado</translation>
    </message>
    <message>
        <source>is no plan of a study: %1</source>
        <translation>no es el plan de un estudio: %1</translation>
    </message>
    <message>
        <source>found no value to study</source>
        <translation>no se encontró ningún valor que estudiar</translation>
    </message>
    <message>
        <source>has no effect on a landmark map; a study draws grids only to measure and show its runs</source>
        <translation>no tiene efecto sobre un mapa de hitos; un estudio dibuja celdas solo para medir y mostrar sus ejecuciones</translation>
    </message>
    <message>
        <source>%1 is set by the study itself; say the number of runs and the first seed instead</source>
        <translation>%1 lo fija el propio estudio; diga en su lugar el número de ejecuciones y la primera semilla</translation>
    </message>
    <message>
        <source>a value has %1 components, expected %2</source>
        <translation>un valor tiene %1 componentes, se esperaban %2</translation>
    </message>
    <message>
        <source>the value %1 is given twice</source>
        <translation>el valor %1 se da dos veces</translation>
    </message>
    <message>
        <source>has no effect where %1 is %2; set it to %3</source>
        <translation>no tiene efecto donde %1 es %2; póngalo a %3</translation>
    </message>
    <message>
        <source>found &quot;%1&quot;, expected one of %2</source>
        <translation>se encontró «%1», se esperaba uno de %2</translation>
    </message>
    <message>
        <source>found %1 parameters; a study varies two at the most</source>
        <translation>se encontraron %1 parámetros; un estudio varía dos como mucho</translation>
    </message>
    <message>
        <source>found %1 for each value, expected 1 to %2</source>
        <translation>se encontró %1 para cada valor, se esperaba de 1 a %2</translation>
    </message>
    <message>
        <source>%1 and %2 more go beyond %3</source>
        <translation>%1 y %2 más pasan de %3</translation>
    </message>
    <message>
        <source>is varied by both parameters of the study</source>
        <translation>lo varían los dos parámetros del estudio</translation>
    </message>
    <message>
        <source>is a folder; expected the path of the quality file to write</source>
        <translation>es una carpeta; se esperaba la ruta del archivo de calidad que escribir</translation>
    </message>
    <message>
        <source>no run gave a figure for %1</source>
        <translation>ninguna ejecución dio una cifra de %1</translation>
    </message>
    <message>
        <source>found %1</source>
        <translation>se encontró %1</translation>
    </message>
    <message>
        <source>is not set</source>
        <translation>no está definida</translation>
    </message>
    <message>
        <source>%1, expected a whole number; say the shard with --shard i/n</source>
        <translation>%1, se esperaba un número entero; diga la parte con --shard i/n</translation>
    </message>
    <message>
        <source>found task %1 of an array from %2 to %3 by %4; say the shard with --shard i/n</source>
        <translation>se encontró la tarea %1 de una serie de %2 a %3 de %4 en %4; diga la parte con --shard i/n</translation>
    </message>
    <message>
        <source>found %1 tasks in an array from %2 to %3 by %4: it has gaps; say the shard with --shard i/n</source>
        <translation>se encontraron %1 tareas en una serie de %2 a %3 de %4 en %4: tiene huecos; diga la parte con --shard i/n</translation>
    </message>
    <message>
        <source>found %1, expected i/n with 1 &lt;= i &lt;= n, such as 2/8</source>
        <translation>se encontró %1, se esperaba i/n con 1 &lt;= i &lt;= n, como 2/8</translation>
    </message>
    <message>
        <source>found task %1, but PBS does not tell how many there are; say the shard with --shard $%2/n</source>
        <translation>se encontró la tarea %1, pero PBS no dice cuántas hay; diga la parte con --shard $%2/n</translation>
    </message>
    <message>
        <source>%1 is not a number; expected a range from:to:step such as 0.01:0.05:0.01</source>
        <translation>%1 no es un número; se esperaba un rango desde:hasta:paso como 0.01:0.05:0.01</translation>
    </message>
    <message>
        <source>number of particles</source>
        <translation>número de partículas</translation>
    </message>
    <message>
        <source>greatest distance of a point from its line, m</source>
        <translation>mayor distancia de un punto a su recta, m</translation>
    </message>
    <message>
        <source>shortest line, m</source>
        <translation>recta más corta, m</translation>
    </message>
    <message>
        <source>fewest points of a line</source>
        <translation>menor número de puntos de una recta</translation>
    </message>
    <message>
        <source>variance of rho in m^2, variance of theta in rad^2</source>
        <translation>varianza de rho en m^2, varianza de theta en rad^2</translation>
    </message>
    <message>
        <source>standard deviation of x in m, of y in m, of theta in rad; with motion.unit = &quot;variance&quot; in the configuration the variances of the thesis&apos;s text, in m^2, m^2, rad^2</source>
        <translation>desviación típica de x en m, de y en m, de theta en rad; con motion.unit = &quot;variance&quot; en la configuración, las varianzas del texto de la tesis, en m^2, m^2, rad^2</translation>
    </message>
    <message>
        <source>likelihood of a new landmark</source>
        <translation>similitud de un hito nuevo</translation>
    </message>
    <message>
        <source>collinearity thresholds: rho in m, theta in rad</source>
        <translation>umbrales de colinealidad: rho en m, theta en rad</translation>
    </message>
    <message>
        <source>greatest distance of a corner from its lines, m</source>
        <translation>mayor distancia de una esquina a sus rectas, m</translation>
    </message>
    <message>
        <source>no such parameter; expected one of %1</source>
        <translation>no existe ese parámetro; se esperaba uno de %1</translation>
    </message>
    <message>
        <source>names a key twice</source>
        <translation>nombra una clave dos veces</translation>
    </message>
    <message>
        <source>found %1 values; each run takes %2</source>
        <translation>se encontraron %1 valores; cada ejecución toma %2</translation>
    </message>
    <message>
        <source>expected name=value,value,… or name=from:to:step</source>
        <translation>se esperaba nombre=valor,valor,… o nombre=desde:hasta:paso</translation>
    </message>
    <message>
        <source>found an empty value</source>
        <translation>se encontró un valor vacío</translation>
    </message>
    <message>
        <source>found %1 of %2 components; each run takes %3, joined by &apos;/&apos;</source>
        <translation>se encontró %1, de %2 componentes; cada ejecución toma %3, unidos por &apos;/&apos;</translation>
    </message>
    <message>
        <source>expected a range from:to:step</source>
        <translation>se esperaba un rango desde:hasta:paso</translation>
    </message>
    <message>
        <source>the step does not lead from the first to the last</source>
        <translation>el paso no lleva del primero al último</translation>
    </message>
    <message>
        <source>has more than %1 values</source>
        <translation>tiene más de %1 valores</translation>
    </message>
    <message>
        <source>way point %1 at (%2, %3)</source>
        <translation>punto de paso %1 en (%2, %3)</translation>
    </message>
    <message>
        <source>way point %1 at (%2, %3) of lap %4</source>
        <translation>punto de paso %1 en (%2, %3) de la vuelta %4</translation>
    </message>
    <message>
        <source>wall %1, (%2, %3) to (%4, %5)</source>
        <translation>pared %1, de (%2, %3) a (%4, %5)</translation>
    </message>
    <message>
        <source>the start at (%1, %2) is %3 m from %4; expected at least the robot&apos;s radius of %5 m</source>
        <translation>la salida en (%1, %2) está a %3 m de %4; se esperaba al menos el radio del robot, %5 m</translation>
    </message>
    <message>
        <source>%1 is %2 m from %3; expected more than %4 m, twice the tolerance at which it is passed</source>
        <translation>%1 está a %2 m de %3; se esperaban más de %4 m, el doble de la tolerancia con que se pasa</translation>
    </message>
    <message>
        <source>the start</source>
        <translation>la salida</translation>
    </message>
    <message>
        <source>the one before</source>
        <translation>el anterior</translation>
    </message>
    <message>
        <source>%1 cannot be reached: the robot is still %2 m away after %3 s; raise robot.tolerance or the accelerations</source>
        <translation>%1 no se puede alcanzar: el robot sigue a %2 m tras %3 s; suba robot.tolerance o las aceleraciones</translation>
    </message>
    <message>
        <source>takes more than %1 control steps; expected a shorter tour or a faster robot</source>
        <translation>necesita más de %1 pasos de control; se esperaba un recorrido más corto o un robot más rápido</translation>
    </message>
    <message>
        <source>on the way to %1 the robot comes within %2 m of %3; expected at least its radius of %4 m</source>
        <translation>de camino a %1 el robot se acerca a %2 m de %3; se esperaba al menos su radio, %4 m</translation>
    </message>
    <message>
        <source>is a directory; expected a DXF drawing</source>
        <translation>es una carpeta; se esperaba un dibujo DXF</translation>
    </message>
    <message>
        <source>the drawing</source>
        <translation>el dibujo</translation>
    </message>
    <message>
        <source>layer &quot;%1&quot;</source>
        <translation>la capa «%1»</translation>
    </message>
    <message>
        <source>%1 holds no wall; expected LINE, LWPOLYLINE or POLYLINE entities of an ASCII DXF drawing</source>
        <translation>%1 no contiene ninguna pared; se esperaban entidades LINE, LWPOLYLINE o POLYLINE de un dibujo DXF en ASCII</translation>
    </message>
    <message>
        <source>found %1, expected a number of 0 or more</source>
        <translation>se encontró %1, se esperaba un número desde 0</translation>
    </message>
    <message>
        <source>found %1 m for walls over %2 x %3 m, which is %4 cells; expected at most %5, so take greater cells</source>
        <translation>se encontró %1 m para paredes sobre %2 x %3 m, que son %4 celdas; se esperaban como mucho %5: tome celdas mayores</translation>
    </message>
    <message>
        <source>found %1, expected more than 0</source>
        <translation>se encontró %1, se esperaba más de 0</translation>
    </message>
    <message>
        <source>found no walls; expected the key walls or walls_dxf</source>
        <translation>no se encontró ninguna pared; se esperaba la clave walls o walls_dxf</translation>
    </message>
    <message>
        <source>dxf_unit: expected the metres per drawing unit, more than 0</source>
        <translation>dxf_unit: se esperaban los metros por unidad del dibujo, más de 0</translation>
    </message>
    <message>
        <source>%1: expected %2</source>
        <translation>%1: se esperaba %2</translation>
    </message>
    <message>
        <source>walls: expected a list of polylines</source>
        <translation>walls: se esperaba una lista de polilíneas</translation>
    </message>
    <message>
        <source>wall %1: found %2, expected two points or more, [[x, y], [x, y]]</source>
        <translation>pared %1: se encontró %2, se esperaban dos puntos o más, [[x, y], [x, y]]</translation>
    </message>
    <message>
        <source>no list of points</source>
        <translation>ninguna lista de puntos</translation>
    </message>
    <message>
        <source>no point</source>
        <translation>ningún punto</translation>
    </message>
    <message>
        <source>one point</source>
        <translation>un punto</translation>
    </message>
    <message>
        <source>wall %1</source>
        <translation>pared %1</translation>
    </message>
    <message>
        <source>wall %1: found the point (%2, %3) twice in a row, expected two different ones</source>
        <translation>pared %1: se encontró el punto (%2, %3) dos veces seguidas, se esperaban dos distintos</translation>
    </message>
    <message>
        <source>walls_dxf: %1: no such file</source>
        <translation>walls_dxf: %1: no existe ese archivo</translation>
    </message>
    <message>
        <source>tour.start: expected [x, y, heading] in metres and degrees</source>
        <translation>tour.start: se esperaba [x, y, rumbo] en metros y grados</translation>
    </message>
    <message>
        <source>tour.way_points: found none, expected [[x, y], ...]</source>
        <translation>tour.way_points: no se encontró ninguno, se esperaba [[x, y], ...]</translation>
    </message>
    <message>
        <source>way point %1</source>
        <translation>punto de paso %1</translation>
    </message>
    <message>
        <source>%1: expected a point [x, y] within %2 m of the origin</source>
        <translation>%1: se esperaba un punto [x, y] a menos de %2 m del origen</translation>
    </message>
    <message>
        <source>%1: expected a string in quotes</source>
        <translation>%1: se esperaba una cadena entre comillas</translation>
    </message>
    <message>
        <source>is a directory; expected a world file</source>
        <translation>es una carpeta; se esperaba un archivo de mundo</translation>
    </message>
    <message>
        <source>found %1, expected %2</source>
        <translation>se encontró %1, se esperaba %2</translation>
    </message>
    <message>
        <source>a whole number, %1 to %2</source>
        <translation>un número entero, de %1 a %2</translation>
    </message>
    <message>
        <source>no such key; expected one of %1</source>
        <translation>no existe esa clave; se esperaba una de %1</translation>
    </message>
    <message>
        <source>found no &quot;=&quot;, expected KEY=VALUE</source>
        <translation>no se encontró «=», se esperaba CLAVE=VALOR</translation>
    </message>
    <message>
        <source>found none, expected one or more</source>
        <translation>no se encontró ninguno, se esperaba uno o más</translation>
    </message>
    <message>
        <source>%1 with motion.sigma_x, motion.sigma_y and motion.sigma_theta all 0 can never move; give at least one of them a value above 0</source>
        <translation>%1 con motion.sigma_x, motion.sigma_y y motion.sigma_theta a 0 no se puede mover nunca; dé al menos a uno un valor mayor que 0</translation>
    </message>
    <message>
        <source>%1 is less than association.gate_probability %2; an observation inside that gate cannot be new</source>
        <translation>%1 es menor que association.gate_probability %2; una observación dentro de esa puerta no puede ser nueva</translation>
    </message>
    <message>
        <source>graph-slam needs registration, and the run has none</source>
        <translation>graph-slam necesita la alineación de barridos, y la ejecución no la tiene</translation>
    </message>
    <message>
        <source>&quot;registered&quot; needs registration, and this run has none; choose another motion model, or give every step what registration says of it</source>
        <translation>«registered» necesita la alineación de barridos, y esta ejecución no la tiene; elija otro modelo de movimiento o dé a cada paso lo que la alineación dice de él</translation>
    </message>
    <message>
        <source>found &quot;%1&quot; for the world %2, expected auto: it is no log</source>
        <translation>se encontró «%1» para el mundo %2, se esperaba auto: no es un registro</translation>
    </message>
    <message>
        <source>found &quot;%1&quot; for the world %2, expected nothing: a world says itself where its laser sits, by laser.mount_x, laser.mount_y and laser.mount_heading</source>
        <translation>se encontró «%1» para el mundo %2, no se esperaba nada: un mundo dice él mismo dónde está su láser, con laser.mount_x, laser.mount_y y laser.mount_heading</translation>
    </message>
    <message>
        <source>found &apos;%1&apos;, expected one of %2</source>
        <translation>se encontró «%1», se esperaba uno de %2</translation>
    </message>
    <message>
        <source>is not there; it comes with Hitos: start the program from its folder</source>
        <translation>no está; viene con Hitos: arranque el programa desde su carpeta</translation>
    </message>
    <message>
        <source>found %1 of each value, expected 1 to %2</source>
        <translation>se encontró %1 de cada valor, se esperaba de 1 a %2</translation>
    </message>
    <message>
        <source>found &apos;%1&apos;, expected a figure&apos;s number, a world or a parameter of %2</source>
        <translation>se encontró «%1», se esperaba el número de una figura, un mundo o un parámetro de %2</translation>
    </message>
    <message>
        <source>cannot make this folder: %1</source>
        <translation>no se puede crear esta carpeta: %1</translation>
    </message>
    <message>
        <source>cannot be written: %1</source>
        <translation>no se puede escribir: %1</translation>
    </message>
    <message>
        <source>the thesis has no table for this parameter</source>
        <translation>la tesis no tiene ninguna tabla de este parámetro</translation>
    </message>
    <message>
        <source>the thesis says no range for world &apos;%1&apos;</source>
        <translation>la tesis no dice ningún rango para el mundo «%1»</translation>
    </message>
    <message>
        <source>no such world file; the worlds that come with Hitos are %1</source>
        <translation>no existe ese archivo de mundo; los mundos que vienen con Hitos son %1</translation>
    </message>
    <message>
        <source>no such log, nor a world of that name; the worlds that come with Hitos are %1</source>
        <translation>no existe ese registro, ni un mundo con ese nombre; los mundos que vienen con Hitos son %1</translation>
    </message>
    <message>
        <source>cannot be kept for this process: %1: %2; choose a folder that you may write to</source>
        <translation>no se puede reservar para este proceso: %1: %2; elija una carpeta en la que pueda escribir</translation>
    </message>
    <message>
        <source>is being written by %1; wait until it is done, or choose another folder</source>
        <translation>lo está escribiendo %1; espere a que termine o elija otra carpeta</translation>
    </message>
    <message>
        <source>cannot be put in place: %1</source>
        <translation>no se puede poner en su sitio: %1</translation>
    </message>
    <message>
        <source>cannot be written: %1; choose a folder that you may write to</source>
        <translation>no se puede escribir: %1; elija una carpeta en la que pueda escribir</translation>
    </message>
    <message>
        <source>is a device or a pipe; expected a file on a disk</source>
        <translation>es un dispositivo o una tubería; se esperaba un archivo de un disco</translation>
    </message>
    <message>
        <source>is not the file that summary.json beside it names: it is missing, was changed or is of another run; hitos-cli verify names all such files</source>
        <translation>no es el archivo que nombra summary.json a su lado: falta, se ha cambiado o es de otra ejecución; hitos-cli verify nombra todos los que están así</translation>
    </message>
    <message>
        <source>names the file %1; expected a name without folders</source>
        <translation>nombra el archivo %1; se esperaba un nombre sin carpetas</translation>
    </message>
    <message>
        <source>does not name the files of the run, as summaries before the first release did not; run it again to have them checked</source>
        <translation>no nombra los archivos de la ejecución, como los resúmenes anteriores a la primera versión publicada; repita la ejecución para que se puedan comprobar</translation>
    </message>
    <message>
        <source>is the plan of another study, on which others are at work: program, configuration, log, values or seeds differ; wait for them or choose another folder</source>
        <translation>es el plan de otro estudio en el que otros están trabajando: difieren el programa, la configuración, el registro, los valores o las semillas; espere a que terminen o elija otra carpeta</translation>
    </message>
    <message>
        <source>the run is not there</source>
        <translation>la ejecución no está</translation>
    </message>
    <message>
        <source>found more than %1 lasers</source>
        <translation>se han encontrado más de %1 láseres</translation>
    </message>
    <message>
        <source>out of memory at scan %1, with %2 landmarks in each map of %3 particles: %4; lower filter.particles, or make fewer landmarks with a higher split_merge.min_length</source>
        <translation>memoria agotada en el barrido %1, con %2 hitos en cada mapa de %3 partículas: %4; baje filter.particles o haga menos hitos con un split_merge.min_length mayor</translation>
    </message>
    <message>
        <source>out of memory at scan %1, with %2 landmarks in the map: %3; make fewer landmarks with a higher split_merge.min_length, or use filter.algorithm = fastslam</source>
        <translation>memoria agotada en el barrido %1, con %2 hitos en el mapa: %3; haga menos hitos con un split_merge.min_length mayor o use filter.algorithm = fastslam</translation>
    </message>
    <message>
        <source>cannot be read: %1</source>
        <translation>no se puede leer: %1</translation>
    </message>
    <message>
        <source>the line method returned rho %1, theta %2 for line %3 of the scan at %4 s; expected finite numbers</source>
        <translation>el método de rectas devolvió rho %1, theta %2 para la recta %3 del barrido en %4 s; se esperaban números finitos</translation>
    </message>
    <message>
        <source>names the file %1; expected a name within the folder</source>
        <translation>nombra el archivo %1; se esperaba un nombre dentro de la carpeta</translation>
    </message>
    <message>
        <source>stopped: %1 of %2 runs are done</source>
        <translation>detenido: hechas %1 de %2 ejecuciones</translation>
    </message>
    <message>
        <source>is no list of files: %1</source>
        <translation>no es una lista de archivos: %1</translation>
    </message>
    <message>
        <source>%1 values and %2 runs of each are more than %3 runs; choose fewer values or runs</source>
        <translation>%1 valores y %2 ejecuciones de cada uno son más de %3 ejecuciones; elija menos valores o ejecuciones</translation>
    </message>
    <message>
        <source>cannot be written: %1, which a process has left, cannot be removed; remove it by hand</source>
        <translation>no se puede escribir: no se puede eliminar %1, que dejó un proceso; elimínelo a mano</translation>
    </message>
    <message>
        <source>was changed or lost while the study was put in place; start the same command again</source>
        <translation>se cambió o se perdió mientras se colocaba el estudio; inicie otra vez la misma orden</translation>
    </message>
    <message>
        <source>the value %1 is no UTF-8 text; rename the file</source>
        <translation>el valor %1 no es texto UTF-8; cambie el nombre del archivo</translation>
    </message>
    <message>
        <source>is read by this very command; choose another name for what it writes</source>
        <translation>lo lee esta misma orden; elija otro nombre para lo que escribe</translation>
    </message>
    <message>
        <source>is to be written twice; choose another name for one of the two</source>
        <translation>se escribiría dos veces; elija otro nombre para uno de los dos</translation>
    </message>
    <message>
        <source>has changed while it was being worked on; start again when the file is complete</source>
        <translation>ha cambiado mientras se trabajaba con él; empiece otra vez cuando el archivo esté completo</translation>
    </message>
    <message>
        <source>has no run of its study that can be read; nothing was changed: look whether maps and runs are there</source>
        <translation>no tiene ninguna ejecución de su estudio que se pueda leer; no se ha cambiado nada: compruebe que maps y runs están ahí</translation>
    </message>
    <message>
        <source>it is a ROS bag; unpack it first</source>
        <translation>es una bolsa (bag) de ROS; descomprímala antes</translation>
    </message>
    <message>
        <source>it is an MCAP recording; unpack it first</source>
        <translation>es una grabación MCAP; descomprímala antes</translation>
    </message>
    <message>
        <source>%1, expected a log (%2); text may be gzip</source>
        <translation>%1, se esperaba un registro (%2); el texto puede ir en gzip</translation>
    </message>
    <message>
        <source>found a record without the field &quot;%1&quot;</source>
        <translation>se encontró un registro interno sin el campo «%1»</translation>
    </message>
    <message>
        <source>found %2 bytes in the field &quot;%1&quot;, expected %3</source>
        <translation>se encontraron %2 bytes en el campo «%1», se esperaban %3</translation>
    </message>
    <message>
        <source>the header of a record is damaged</source>
        <translation>la cabecera de un registro interno está dañada</translation>
    </message>
    <message>
        <source>is a ROS bag that begins with &quot;%1&quot;, expected version 2.0; convert it with &quot;rosbag fix&quot;</source>
        <translation>es una bolsa (bag) de ROS que empieza por «%1», se esperaba la versión 2.0; conviértala con «rosbag fix»</translation>
    </message>
    <message>
        <source>the data end early</source>
        <translation>los datos terminan antes de tiempo</translation>
    </message>
    <message>
        <source>found a record of the unknown kind %1</source>
        <translation>se encontró un registro interno de la clase desconocida %1</translation>
    </message>
    <message>
        <source>the bag was not closed or is cut off, as it has no index; all before byte %1 was read</source>
        <translation>la bolsa (bag) no se cerró o está cortada, pues no tiene índice; se leyó todo lo anterior al byte %1</translation>
    </message>
    <message>
        <source>found a message of the connection %1, which nothing describes</source>
        <translation>se encontró un mensaje de la conexión %1, que nada describe</translation>
    </message>
    <message>
        <source>more than %1 topics</source>
        <translation>hay más de %1 temas</translation>
    </message>
    <message>
        <source>found a length of %1 bytes, expected at most %2</source>
        <translation>se encontró una longitud de %1 bytes, se esperaban como mucho %2</translation>
    </message>
    <message>
        <source>found a length of %1 bytes, expected at most the %2 left</source>
        <translation>se encontró una longitud de %1 bytes, se esperaban como mucho los %2 que quedan</translation>
    </message>
    <message>
        <source>at byte %1: %2</source>
        <translation>en el byte %1: %2</translation>
    </message>
    <message>
        <source>in the chunk at byte %1, %2 bytes into it: %3</source>
        <translation>en el bloque del byte %1, %2 bytes dentro de él: %3</translation>
    </message>
    <message>
        <source>found a chunk inside a chunk</source>
        <translation>se encontró un bloque dentro de otro</translation>
    </message>
    <message>
        <source>found a chunk of %1 bytes once unpacked, expected at most %2</source>
        <translation>se encontró un bloque de %1 bytes una vez descomprimido, se esperaban como mucho %2</translation>
    </message>
    <message>
        <source>found more than the %1 bytes that it says it has</source>
        <translation>se encontraron más bytes que los %1 que dice tener</translation>
    </message>
    <message>
        <source>its checksum is not that of its content</source>
        <translation>su suma de comprobación no es la de su contenido</translation>
    </message>
    <message>
        <source>found a message of %1 bytes, expected at most %2</source>
        <translation>se encontró un mensaje de %1 bytes, se esperaban como mucho %2</translation>
    </message>
    <message>
        <source>behind the row %1: %2</source>
        <translation>tras la fila %1: %2</translation>
    </message>
    <message>
        <source>rows come out of order</source>
        <translation>las filas vienen desordenadas</translation>
    </message>
    <message>
        <source>cannot be read as a recording: %1</source>
        <translation>no se puede leer como grabación: %1</translation>
    </message>
    <message>
        <source>is an SQLite file without the table &quot;%1&quot;, expected a recording of ROS 2</source>
        <translation>es un archivo SQLite sin la tabla «%1», se esperaba una grabación de ROS 2</translation>
    </message>
    <message>
        <source>found a message of the topic %1 in the row %2, which nothing describes</source>
        <translation>se encontró en la fila %2 un mensaje del tema %1, que nada describe</translation>
    </message>
    <message>
        <source>the recording was not closed or is cut off, as its last bytes are not MCAP&apos;s; all before byte %1 was read</source>
        <translation>la grabación no se cerró o está cortada, pues sus últimos bytes no son los de MCAP; se leyó todo lo anterior al byte %1</translation>
    </message>
    <message>
        <source>found a message of the channel %1, which nothing describes</source>
        <translation>se encontró un mensaje del canal %1, que nada describe</translation>
    </message>
    <message>
        <source>names the file &quot;%1&quot;, which is not in its folder; put it there</source>
        <translation>nombra el archivo «%1», que no está en su carpeta; póngalo allí</translation>
    </message>
    <message>
        <source>says that the recording is compressed by %1, which Hitos does not read; convert it with &quot;ros2 bag convert&quot;</source>
        <translation>dice que la grabación está comprimida por %1, lo que Hitos no lee; conviértala con «ros2 bag convert»</translation>
    </message>
    <message>
        <source>found the compression &quot;%1&quot;, expected none, bz2, lz4 or zstd</source>
        <translation>se encontró la compresión «%1», se esperaba none, bz2, lz4 o zstd</translation>
    </message>
    <message>
        <source>more than %1 frames</source>
        <translation>hay más de %1 marcos de referencia</translation>
    </message>
    <message>
        <source>the laser &quot;%1&quot; is tilted by %2°; expected one that is level or upside down, to 3°</source>
        <translation>el láser «%1» está inclinado %2°; se esperaba uno horizontal o boca abajo, hasta 3°</translation>
    </message>
    <message>
        <source>field &quot;%1&quot;: found %2, expected a step between rays</source>
        <translation>campo «%1»: se encontró %2, se esperaba un paso entre rayos</translation>
    </message>
    <message>
        <source>the message does not begin as CDR does</source>
        <translation>el mensaje no empieza como CDR</translation>
    </message>
    <message>
        <source>the message ends in the field &quot;%1&quot;</source>
        <translation>el mensaje termina en el campo «%1»</translation>
    </message>
    <message>
        <source>field &quot;%1&quot;: found %2 bytes, expected at most %3</source>
        <translation>campo «%1»: se encontraron %2 bytes, se esperaban como mucho %3</translation>
    </message>
    <message>
        <source>field &quot;%1&quot;: found a count of %2, expected at most %3, for which there are bytes</source>
        <translation>campo «%1»: se encontró un número de elementos de %2, se esperaban como mucho %3, para los que hay bytes</translation>
    </message>
    <message>
        <source>%1 bytes are left behind the last field</source>
        <translation>quedan %1 bytes tras el último campo</translation>
    </message>
    <message>
        <source>field &quot;%1&quot;: found %2, expected a finite number up to 1e12</source>
        <translation>campo «%1»: se encontró %2, se esperaba un número finito de hasta 1e12</translation>
    </message>
    <message>
        <source>field &quot;%1&quot;: found %2, expected less than %3</source>
        <translation>campo «%1»: se encontró %2, se esperaba menos de %3</translation>
    </message>
    <message>
        <source>field &quot;%1&quot;: found a quaternion of length %2, expected 1</source>
        <translation>campo «%1»: se encontró un cuaternión de longitud %2, se esperaba 1</translation>
    </message>
    <message>
        <source>field &quot;%1&quot;: found %2 rays, expected 1 to %3</source>
        <translation>campo «%1»: se encontraron %2 rayos, se esperaban de 1 a %3</translation>
    </message>
    <message>
        <source>found &quot;%1&quot;, expected one of the topics of %2: %3</source>
        <translation>se encontró «%1», se esperaba uno de los temas de %2: %3</translation>
    </message>
    <message>
        <source>found %1 laser topics in %2: %3; choose one (--scan-topic), several with commas between them, or &quot;all&quot;</source>
        <translation>se encontraron %1 temas de láser en %2: %3; elija uno (--scan-topic), varios separados por comas, o «all»</translation>
    </message>
    <message>
        <source>found &quot;%1&quot;, but no transform in %2 leads from a frame &quot;odom&quot; to the laser&apos;s frame &quot;%3&quot;</source>
        <translation>se encontró «%1», pero ninguna transformación de %2 lleva de un marco «odom» al del láser «%3»</translation>
    </message>
    <message>
        <source>found %1 odometry topics in %2: %3; choose one (--odom-topic), or &quot;tf&quot; for the transforms</source>
        <translation>se encontraron %1 temas de odometría en %2: %3; elija uno (--odom-topic), o «tf» para las transformaciones</translation>
    </message>
    <message>
        <source>the tour has %1 scans, the path %2 poses; expected the tour that the path was made of</source>
        <translation>el recorrido tiene %1 barridos y el camino %2 poses; se esperaba el recorrido del que se hizo el camino</translation>
    </message>
    <message>
        <source>scan %1 has the stamp %2 s, its pose %3 s; expected the tour that the path was made of</source>
        <translation>el barrido %1 tiene el instante %2 s y su pose %3 s; se esperaba el recorrido del que se hizo el camino</translation>
    </message>
    <message>
        <source>no relation in the file; expected 8 numbers, t1 t2 x y z roll pitch yaw on each line</source>
        <translation>no hay ninguna relación en el archivo; se esperaban 8 números, t1 t2 x y z roll pitch yaw en cada línea</translation>
    </message>
    <message>
        <source>relation %1 (t1 %2, t2 %3, x %4, y %5, yaw %6) is not finite and cannot be written</source>
        <translation>la relación %1 (t1 %2, t2 %3, x %4, y %5, yaw %6) no es finita y no se puede escribir</translation>
    </message>
    <message>
        <source>does not begin as MCAP does</source>
        <translation>no empieza como un MCAP</translation>
    </message>
    <message>
        <source>cannot be kept in %1 to be read more than once: %2; make room there, or name another folder in TMPDIR</source>
        <translation>no puede guardarse en %1 para leerse más de una vez: %2; haga sitio allí o indique otra carpeta en TMPDIR</translation>
    </message>
    <message>
        <source>is a terminal; expected a file or what another program writes: hitos-cli … - &lt; FILE</source>
        <translation>es un terminal; se esperaba un archivo o lo que escribe otro programa: hitos-cli … - &lt; FILE</translation>
    </message>
    <message>
        <source>cannot be written: MCAP is compressed inside, and no program reads it inside of gzip; choose a name without .gz</source>
        <translation>no se puede escribir: MCAP se comprime por dentro, y ningún programa lo lee dentro de gzip; elija un nombre sin .gz</translation>
    </message>
    <message>
        <source>the time %1 cannot be a stamp of ROS, which has 0 to %2 seconds; write the normalized format</source>
        <translation>el tiempo %1 no puede ser una marca de tiempo de ROS, que va de 0 a %2 segundos; escriba el formato normalizado</translation>
    </message>
    <message>
        <source>its lasers sit in more than %1 places; write the normalized format</source>
        <translation>sus láseres están en más de %1 lugares; escriba el formato normalizado</translation>
    </message>
    <message>
        <source>is MCAP of the version &quot;%1&quot;, expected version 0; convert it with a program that knows both</source>
        <translation>es MCAP de la versión «%1», se esperaba la versión 0; conviértalo con un programa que conozca ambas</translation>
    </message>
    <message>
        <source>more than %1 types</source>
        <translation>más de %1 tipos</translation>
    </message>
    <message>
        <source>the message is compressed by itself (rosbag2&apos;s compression_mode MESSAGE), which Hitos does not read; convert the recording with &quot;ros2 bag convert&quot;</source>
        <translation>el mensaje está comprimido por sí mismo (compression_mode MESSAGE de rosbag2), lo que Hitos no lee; convierta la grabación con «ros2 bag convert»</translation>
    </message>
    <message>
        <source>landmark %1 of the map is not finite and cannot be written</source>
        <translation>el hito %1 del mapa no es finito y no se puede escribir</translation>
    </message>
    <message>
        <source>the tour has no scan to write</source>
        <translation>el recorrido no tiene ningún barrido que escribir</translation>
    </message>
    <message>
        <source>found &quot;%1&quot;, which is no file of a run that can be asked for; there are %2</source>
        <translation>se encontró «%1», que no es ningún archivo de una ejecución que se pueda pedir; hay %2</translation>
    </message>
    <message>
        <source>found &quot;%1&quot;, which is no file of a run that can be asked for; did you mean %2? There are %3</source>
        <translation>se encontró «%1», que no es ningún archivo de una ejecución que se pueda pedir; ¿quería decir %2? Hay %3</translation>
    </message>
    <message>
        <source>at: found %1, expected seconds, 0 or more</source>
        <translation>at: se encontró %1, se esperaban segundos, 0 o más</translation>
    </message>
    <message>
        <source>%1: found %2 for %3, expected %4 to %5</source>
        <translation>%1: se encontró %2 para %3, se esperaba de %4 a %5</translation>
    </message>
    <message>
        <source>%1: found door %2, expected one of the world&apos;s %3 doors</source>
        <translation>%1: se encontró la puerta %2, se esperaba una de las %3 puertas del mundo</translation>
    </message>
    <message>
        <source>found way_points and commands in [tour], expected one of them</source>
        <translation>se encontraron way_points y commands en [tour], se esperaba uno de los dos</translation>
    </message>
    <message>
        <source>found the speed %1 m/s, expected %2 to %3</source>
        <translation>se encontró la velocidad %1 m/s, se esperaba de %2 a %3</translation>
    </message>
    <message>
        <source>found the turn rate %1 rad/s, expected %2 to %3</source>
        <translation>se encontró la velocidad de giro %1 rad/s, se esperaba de %2 a %3</translation>
    </message>
    <message>
        <source>found the time %1 s, expected 0 or more</source>
        <translation>se encontró el tiempo %1 s, se esperaba 0 o más</translation>
    </message>
    <message>
        <source>found a point twice in a row on the way</source>
        <translation>se encontró un punto dos veces seguidas en el camino</translation>
    </message>
    <message>
        <source>found a way of no length, expected two points</source>
        <translation>se encontró un camino sin longitud, se esperaban dos puntos</translation>
    </message>
    <message>
        <source>found the radius %1 m, expected more than 0, at most %2</source>
        <translation>se encontró el radio %1 m, se esperaba más de 0 y como mucho %2</translation>
    </message>
    <message>
        <source>%1: expected two points or more, [[x, y], [x, y]]</source>
        <translation>%1: se esperaban dos puntos o más, [[x, y], [x, y]]</translation>
    </message>
    <message>
        <source>tour.events: expected { at = SECONDS, KIND = ... } with one of %1</source>
        <translation>tour.events: se esperaba { at = SEGUNDOS, TIPO = ... } con uno de %1</translation>
    </message>
    <message>
        <source>tour.events: found %1, expected one of %2</source>
        <translation>tour.events: se encontró %1, se esperaba uno de %2</translation>
    </message>
    <message>
        <source>tour.commands: expected [speed in m/s, turn rate in rad/s, seconds]</source>
        <translation>tour.commands: se esperaba [velocidad en m/s, velocidad de giro en rad/s, segundos]</translation>
    </message>
    <message>
        <source>walker %1</source>
        <translation>caminante %1</translation>
    </message>
    <message>
        <source>%1: expected { way = [[x, y], [x, y]], speed = 0.8, radius = 0.25 }</source>
        <translation>%1: se esperaba { way = [[x, y], [x, y]], speed = 0.8, radius = 0.25 }</translation>
    </message>
    <message>
        <source>%1: %2: expected the number speed or radius, or way</source>
        <translation>%1: %2: se esperaba el número speed o radius, o way</translation>
    </message>
    <message>
        <source>door %1</source>
        <translation>puerta %1</translation>
    </message>
    <message>
        <source>%1: expected two different points</source>
        <translation>%1: se esperaban dos puntos distintos</translation>
    </message>
    <message>
        <source>found %1, expected key: value, as in the YAML files of map_server</source>
        <translation>se encontró %1; se esperaba clave: valor, como en los archivos YAML de map_server</translation>
    </message>
    <message>
        <source>has no %1; expected a line %1: %2, as in the YAML files of map_server</source>
        <translation>no tiene %1; se esperaba una línea %1: %2, como en los archivos YAML de map_server</translation>
    </message>
    <message>
        <source>0 m or more</source>
        <translation>0 m o más</translation>
    </message>
    <message>
        <source>room: closed, every ray from the start meets a wall</source>
        <translation>recinto: cerrado, todo rayo desde la salida da con una pared</translation>
    </message>
    <message>
        <source>room: open, a ray from the start at %1 degrees meets no wall</source>
        <translation>recinto: abierto, un rayo desde la salida a %1 grados no da con ninguna pared</translation>
    </message>
    <message>
        <source>tour: none yet; it can be driven by hand, or given way points</source>
        <translation>recorrido: aún ninguno; se puede conducir a mano, o darle puntos de paso</translation>
    </message>
    <message>
        <source>tour: hits no wall</source>
        <translation>recorrido: no choca con ninguna pared</translation>
    </message>
    <message>
        <source>tour: %1</source>
        <translation>recorrido: %1</translation>
    </message>
    <message>
        <source>has no tour to drive; expected way_points = [[x, y], ...] or commands in [tour], or drive it by hand in the window</source>
        <translation>no tiene recorrido; se esperaba way_points = [[x, y], ...] o commands en [tour], o conducirlo a mano en la ventana</translation>
    </message>
    <message>
        <source>this change cannot be written as TOML that reads back the same; expected finite numbers, and polylines of two points or more</source>
        <translation>este cambio no se puede escribir como TOML que se lea igual; se esperaban números finitos y polilíneas de dos puntos o más</translation>
    </message>
    <message>
        <source>the walls of %1 are changed in the drawing, or written into the world file in its place</source>
        <translation>las paredes de %1 se cambian en el dibujo, o se escriben en el archivo del mundo en su lugar</translation>
    </message>
    <message>
        <source>%1 does not tell how large a pixel is; expected the metres of a pixel, or the YAML file of map_server that names the picture</source>
        <translation>%1 no dice cuánto mide un píxel; se esperaban los metros de un píxel, o el archivo YAML de map_server que nombra la imagen</translation>
    </message>
    <message>
        <source>is a world; expected a drawing, a map, a finished run or a picture</source>
        <translation>es un mundo; se esperaba un dibujo, un mapa, una ejecución terminada o una imagen</translation>
    </message>
    <message>
        <source>found no wall; expected straight walls of some length</source>
        <translation>no se encontró ninguna pared; se esperaban paredes rectas de cierta longitud</translation>
    </message>
    <message>
        <source>no laser scans (messages sensor_msgs/LaserScan) can be read in it, as some of it cannot: %1; the topics that can are: %2</source>
        <translation>no se puede leer en ella ningún barrido láser (mensajes sensor_msgs/LaserScan), pues hay partes ilegibles: %1; los temas que se pueden leer son: %2</translation>
    </message>
    <message>
        <source>found no scan behind the first odometry reading; %1 before it were left out, use them with source.early_scans=keep</source>
        <translation>no se encontró ningún barrido posterior a la primera lectura de odometría; se omitieron los %1 anteriores a ella, que se usan con source.early_scans=keep</translation>
    </message>
    <message>
        <source>found no readable scan; of the log %1 parts were skipped as damaged, the first is %2</source>
        <translation>no se encontró ningún barrido legible; partes del registro que se saltaron por dañadas: %1, la primera: %2</translation>
    </message>
    <message>
        <source>a side of a box, (%1, %2) to (%3, %4)</source>
        <translation>un lado de una caja, de (%1, %2) a (%3, %4)</translation>
    </message>
    <message>
        <source>the drawing %1 has changed meanwhile; save the world under another name, or open it again</source>
        <translation>el dibujo %1 ha cambiado entretanto; guarde el mundo con otro nombre o vuelva a abrirlo</translation>
    </message>
    <message>
        <source>expected a name that ends in .toml</source>
        <translation>se esperaba un nombre que acabe en .toml</translation>
    </message>
    <message>
        <source>lies among the files that come with Hitos; choose another folder</source>
        <translation>está entre los archivos que vienen con Hitos; elija otra carpeta</translation>
    </message>
    <message>
        <source>found %1, expected a finite number</source>
        <translation>se encontró %1, se esperaba un número finito</translation>
    </message>
    <message>
        <source>found %1, expected a drawing that is saved as ASCII DXF</source>
        <translation>se encontró %1, se esperaba un dibujo guardado como DXF ASCII</translation>
    </message>
    <message>
        <source>holds more than %1 entities; save the layers of the walls as a drawing of their own</source>
        <translation>contiene más de %1 entidades; guarde las capas de las paredes como un dibujo propio</translation>
    </message>
    <message>
        <source>found %1, expected a group code of an ASCII DXF drawing</source>
        <translation>se encontró %1, se esperaba un código de grupo de un dibujo DXF ASCII</translation>
    </message>
    <message>
        <source>drawing: left out, farther from the rest than a world reaches: %1; are they in the right place?</source>
        <translation>dibujo: excluidos, más lejos del resto de lo que abarca un mundo: %1; ¿están en su sitio?</translation>
    </message>
    <message>
        <source>drawing: %1 is no size of a place that a robot maps; is the unit right? By others (--unit, dxf_unit) it is: %2</source>
        <translation>dibujo: %1 no es el tamaño de un lugar que explore un robot; ¿es correcta la unidad? Con otras (--unit, dxf_unit) es: %2</translation>
    </message>
    <message>
        <source>drawing: unit %1 m, as asked</source>
        <translation>dibujo: unidad de %1 m, como se pidió</translation>
    </message>
    <message>
        <source>drawing: unit %1 m, as it says ($INSUNITS %2)</source>
        <translation>dibujo: unidad de %1 m, como él dice ($INSUNITS %2)</translation>
    </message>
    <message>
        <source>drawing: tells no unit ($INSUNITS); taken for metres, another one is given by --unit, or dxf_unit of a world</source>
        <translation>dibujo: no dice su unidad ($INSUNITS); se toma el metro, otra se da con --unit, o con dxf_unit de un mundo</translation>
    </message>
    <message>
        <source>drawing: lies far from its origin, as in survey coordinates; moved by (%1, %2) m, so that its lower left corner is near (0, 0)</source>
        <translation>dibujo: está lejos de su origen, como en coordenadas topográficas; se desplaza (%1, %2) m, con su esquina inferior izquierda cerca de (0, 0)</translation>
    </message>
    <message>
        <source>shows more than %1 pieces, blocks as often as they are inserted; name the layer of the walls</source>
        <translation>muestra más de %1 piezas, los bloques tantas veces como se insertan; nombre la capa de las paredes</translation>
    </message>
    <message>
        <source>drawing: walls are made of %1</source>
        <translation>dibujo: las paredes salen de %1</translation>
    </message>
    <message>
        <source>drawing: chords, at most 5 mm off, stand for the curves of %1</source>
        <translation>dibujo: cuerdas, a 5 mm como mucho, hacen de curvas de %1</translation>
    </message>
    <message>
        <source>drawing: %1 passed over, which are no walls</source>
        <translation>dibujo: se pasan por alto %1, que no son paredes</translation>
    </message>
    <message>
        <source>drawing: %1 left out, on sheets (paper space)</source>
        <translation>dibujo: excluidos %1, en láminas (espacio papel)</translation>
    </message>
    <message>
        <source>drawing: %1 left out, invisible</source>
        <translation>dibujo: excluidos %1, invisibles</translation>
    </message>
    <message>
        <source>drawing: left out on layers that are off or frozen: %1; name them (--layer, dxf_layer) to have them</source>
        <translation>dibujo: excluidos en capas desactivadas o inutilizadas: %1; nómbrelas (--layer, dxf_layer) para tenerlos</translation>
    </message>
    <message>
        <source>drawing: left out on other layers: %1</source>
        <translation>dibujo: excluidos en otras capas: %1</translation>
    </message>
    <message>
        <source>drawing: left out, of no length seen from above: %1</source>
        <translation>dibujo: excluidos, sin longitud vistos desde arriba: %1</translation>
    </message>
    <message>
        <source>drawing: polylines drawn with a width: %1; their middle lines are taken for walls</source>
        <translation>dibujo: polilíneas dibujadas con grosor: %1; se toman sus líneas medias como paredes</translation>
    </message>
    <message>
        <source>drawing: %1 cannot be read and may be walls that are missing; explode them where they were drawn</source>
        <translation>dibujo: %1 no se pueden leer y pueden ser paredes que faltan; descompóngalos donde se dibujaron</translation>
    </message>
    <message>
        <source>drawing: inserted, but not in the file: %1; bind external references where it was drawn</source>
        <translation>dibujo: insertados, pero no están en el archivo: %1; una las referencias externas donde se dibujó</translation>
    </message>
    <message>
        <source>%1 holds no wall; expected one of the layers that do: %2</source>
        <translation>%1 no contiene ninguna pared; se esperaba una de las capas que las contienen: %2</translation>
    </message>
    <message>
        <source>%1 holds no wall; found %2 that are none, cannot be read, or are hidden (name their layer to have them)</source>
        <translation>%1 no contiene ninguna pared; se encontró %2, que no lo son, no se pueden leer o están ocultos (nombre su capa para tenerlos)</translation>
    </message>
    <message>
        <source>drawing: breaks off before its end (EOF); what followed is missing, its last entity too</source>
        <translation>dibujo: se interrumpe antes de su final (EOF); falta lo que seguía, y su última entidad</translation>
    </message>
    <message>
        <source>%1 is no drawing; layers and units are chosen of DXF drawings (.dxf) alone</source>
        <translation>%1 no es un dibujo; solo de dibujos DXF (.dxf) se eligen capas y unidad</translation>
    </message>
    <message>
        <source>drawing: %1 is no size of a place that a robot maps; is anything far from the rest, or missing?</source>
        <translation>dibujo: %1 no es el tamaño de un lugar que explore un robot; ¿hay algo lejos del resto, o falta algo?</translation>
    </message>
    <message>
        <source>%1 of %2 scans have no reading that can be used, so there is nothing to map</source>
        <translation>%1 de %2 barridos no tienen ninguna lectura utilizable, así que no hay nada que cartografiar</translation>
    </message>
    <message>
        <source>look whether the range limits of the recording are swapped or tiny, or its readings not in metres; source.max_range sets the greatest range</source>
        <translation>compruebe si los límites de alcance de la grabación están cambiados o son diminutos, o si sus lecturas no están en metros; source.max_range fija el alcance máximo</translation>
    </message>
    <message>
        <source>half of the readings are beyond %1 m, which no such laser sees; the map is that many times too large</source>
        <translation>la mitad de las lecturas están a más de %1 m, lo que ningún láser de esta clase ve; el mapa sale otras tantas veces demasiado grande</translation>
    </message>
    <message>
        <source>the rays of a scan go over %1 degrees, more than a whole turn; they lie upon each other in the map</source>
        <translation>los rayos de un barrido abarcan %1 grados, más de una vuelta entera; en el mapa quedan unos sobre otros</translation>
    </message>
    <message>
        <source>%1 of %2 scans taken while the robot moved are the same as the one before</source>
        <translation>%1 de %2 barridos tomados con el robot en movimiento son iguales al anterior</translation>
    </message>
    <message>
        <source>look whether the laser&apos;s driver hung</source>
        <translation>compruebe si el controlador del láser se quedó colgado</translation>
    </message>
    <message>
        <source>there is no odometry, so that all scans are put on one place</source>
        <translation>no hay odometría, así que todos los barridos se ponen en un mismo lugar</translation>
    </message>
    <message>
        <source>record it too: of ROS the topic of the odometry, or /tf together with /tf_static</source>
        <translation>grábela también: en ROS, el tema de la odometría, o /tf junto con /tf_static</translation>
    </message>
    <message>
        <source>by the odometry the robot mostly drives at %1 m/s, which none of its kind does</source>
        <translation>según la odometría el robot circula casi siempre a %1 m/s, lo que ninguno de su clase hace</translation>
    </message>
    <message>
        <source>the scans change and the odometry says that the robot never moved; all scans are put on one place</source>
        <translation>los barridos cambian y la odometría dice que el robot no se movió nunca; todos los barridos se ponen en un mismo lugar</translation>
    </message>
    <message>
        <source>scans are stamped from %1 to %2 s and the odometry from %3 to %4 s: they share no time, so that the robot stands still in the map</source>
        <translation>los barridos están fechados de %1 a %2 s y la odometría de %3 a %4 s: no tienen ningún tiempo en común, así que en el mapa el robot está parado</translation>
    </message>
    <message>
        <source>set the clocks of both computers alike, and record again</source>
        <translation>ponga en hora los relojes de ambos ordenadores y grabe de nuevo</translation>
    </message>
    <message>
        <source>the scans fit the odometry of %1 from theirs (%2 % of their points, against %3 % as they are stamped): their clocks differ, and the map is wrong by what the robot drove meanwhile</source>
        <translation>los barridos encajan con la odometría de %1 respecto a sus tiempos (%2 % de sus puntos, frente a %3 % tal como están fechados): los relojes difieren y el mapa yerra en lo que el robot recorrió entretanto</translation>
    </message>
    <message>
        <source>the scans turn against the odometry (%1 % of their points fit mirrored, %2 % as they are): one of the two is mirrored, and where it is the laser, so is the map</source>
        <translation>los barridos giran al revés que la odometría (%1 % de sus puntos encajan reflejados, %2 % tal como están): uno de los dos está reflejado y, si es el láser, también el mapa</translation>
    </message>
    <message>
        <source>the scans move %1 degrees off where the odometry drives (%2 % of their points fit turned so, %3 % as they are): the map&apos;s path and walls do not fit each other</source>
        <translation>los barridos se desplazan a %1 grados de hacia donde circula la odometría (%2 % de sus puntos encajan girados así, %3 % tal como están): la trayectoria y las paredes del mapa no encajan</translation>
    </message>
    <message>
        <source>the odometry leaps, by up to %1 m (line %2) and %3 in all, as where a driver begins anew; the map falls in pieces there</source>
        <translation>la odometría salta hasta %1 m (línea %2), %3 veces en total, como cuando un controlador empieza de nuevo; ahí el mapa se rompe en pedazos</translation>
    </message>
    <message>
        <source>%1 is %2, with a decimal comma; expected a decimal point</source>
        <translation>%1 es %2, con coma decimal; se esperaba un punto decimal</translation>
    </message>
    <message>
        <source>a decimal point, not a comma</source>
        <translation>un punto decimal, no una coma</translation>
    </message>
    <message>
        <source>is written with decimal commas, as programs do under the settings of some languages; expected decimal points, as sed -E &apos;s/([0-9]),([0-9])/\1.\2/g&apos; makes of them; the first line is &quot;%1&quot;</source>
        <translation>está escrito con comas decimales, como hacen los programas con los ajustes de algunos idiomas; se esperaban puntos decimales, como los que pone sed -E &apos;s/([0-9]),([0-9])/\1.\2/g&apos;; la primera línea es &quot;%1&quot;</translation>
    </message>
    <message>
        <source>its header is damaged</source>
        <translation>su cabecera está dañada</translation>
    </message>
    <message>
        <source>the recording is cut off at byte %1: %2 of the %3 pages that it says it has are missing; what the others hold was read</source>
        <translation>la grabación está cortada en el byte %1: faltan %2 de las %3 páginas que dice tener; se ha leído lo que contienen las demás</translation>
    </message>
    <message>
        <source>a recorder was broken off while it wrote, as %1 tells; what it wrote last may be in part</source>
        <translation>se interrumpió un grabador mientras escribía, como indica %1; lo último que escribió puede estar incompleto</translation>
    </message>
    <message>
        <source>%1 holds changes from byte %2 to byte %3 that were never finished, or are cut off or damaged; they are left out</source>
        <translation>%1 contiene cambios del byte %2 al byte %3 que nunca se terminaron, o que están cortados o dañados; se dejan fuera</translation>
    </message>
    <message>
        <source>is a folder without a recording: found neither a metadata.yaml that names files nor files *.mcap or *.db3, plain or as *.zstd; choose a log file inside it</source>
        <translation>es una carpeta sin grabación: no hay un metadata.yaml que nombre archivos ni archivos *.mcap o *.db3, tal cual o como *.zstd; elija un archivo de registro dentro de ella</translation>
    </message>
    <message>
        <source>cannot be unpacked in %1: %2; make room there, or name another folder in TMPDIR</source>
        <translation>no se puede descomprimir en %1: %2; haga sitio allí o indique otra carpeta en TMPDIR</translation>
    </message>
    <message>
        <source>the picture is the file of that name beside %1, as there is no %2</source>
        <translation>la imagen es el archivo de ese nombre junto a %1, pues no existe %2</translation>
    </message>
    <message>
        <source>the stamps go from %1 to %2, which cannot be seconds; expected seconds (nanoseconds divided by 1e9)</source>
        <translation>las marcas de tiempo van de %1 a %2, que no pueden ser segundos; se esperaban segundos (nanosegundos divididos por 1e9)</translation>
    </message>
    <message>
        <source>the robot rolls about its x axis and turns about no other, as where qw stands before qx; expected t x y z qx qy qz qw, or a first line that names the columns</source>
        <translation>el robot gira en torno a su eje x y a ningún otro, como cuando qw está antes de qx; se esperaba t x y z qx qy qz qw, o una primera línea que nombre las columnas</translation>
    </message>
    <message>
        <source>is a world of Stage, which Hitos does not read; give the picture of its walls, %1, with --resolution: its width in metres (size %2) divided by that in pixels</source>
        <translation>es un mundo de Stage, que Hitos no lee; dé la imagen de sus paredes, %1, con --resolution: su ancho en metros (size %2) dividido por el ancho en píxeles</translation>
    </message>
    <message>
        <source>found &quot;%1&quot;, expected where the laser sits on the robot as &quot;x,y,degrees&quot; (metres ahead, metres to the left, turn to the left) or &quot;x,y,degrees,upside-down&quot;</source>
        <translation>se encontró «%1», se esperaba dónde va el láser en el robot, como «x,y,grados» (metros hacia delante, metros a la izquierda, giro a la izquierda) o «x,y,grados,upside-down»</translation>
    </message>
    <message>
        <source>a scan&apos;s rays are said to take %1 s, more than from one scan to the next; they are taken to be of one time</source>
        <translation>se dice que los rayos de un barrido tardan %1 s, más que de un barrido al siguiente; se toman como de un mismo instante</translation>
    </message>
    <message>
        <source>the odometry leaps, by up to %1 m (line %2) and %3 in all, as where a driver begins anew; the robot is taken to drive on there as before, for a second</source>
        <translation>la odometría salta, hasta %1 m (línea %2) y %3 en total, como donde un controlador empieza de nuevo; se supone que el robot sigue ahí como antes, durante un segundo</translation>
    </message>
    <message>
        <source>map it with registration, which finds what is left of it: --preset recorded</source>
        <translation>haga el mapa con alineación de barridos, que encuentra lo que quede: --preset recorded</translation>
    </message>
    <message>
        <source>the odometry&apos;s poses never change although its velocities do; all scans are put on one place</source>
        <translation>las poses de la odometría nunca cambian aunque sus velocidades sí; todos los barridos se ponen en un mismo lugar</translation>
    </message>
    <message>
        <source>found &quot;%1&quot;, expected two frames that are one, as base_footprint=base_link</source>
        <translation>se encontró «%1», se esperaban dos marcos que son uno, como base_footprint=base_link</translation>
    </message>
    <message>
        <source>the place of the frame &quot;%1&quot; is told by %2 and by %3, differently, so where the laser sits is not known; record those of one robot only, or say where it sits (--laser-pose x,y,degrees)</source>
        <translation>el lugar del marco «%1» lo dicen %2 y %3 de forma distinta, así que no se sabe dónde va el láser; grabe solo los de un robot, o diga dónde va (--laser-pose x,y,grados)</translation>
    </message>
    <message>
        <source>no transform leads from the laser&apos;s frame &quot;%1&quot; to the robot&apos;s frame &quot;%2&quot;, so where the laser sits is not known; say where (--laser-pose x,y,degrees), or which frames are one (--same-frames %2=NAME), or choose another laser (--scan-topic)</source>
        <translation>ninguna transformación lleva del marco del láser «%1» al del robot «%2», así que no se sabe dónde va el láser; diga dónde (--laser-pose x,y,grados), o qué marcos son uno (--same-frames %2=NOMBRE), o elija otro láser (--scan-topic)</translation>
    </message>
    <message>
        <source>; point clouds can be played into pointcloud_to_laserscan and its scans recorded</source>
        <translation>; las nubes de puntos se pueden pasar por pointcloud_to_laserscan y grabar sus barridos</translation>
    </message>
    <message>
        <source>; depth images can be played into depthimage_to_laserscan and its scans recorded</source>
        <translation>; las imágenes de profundidad se pueden pasar por depthimage_to_laserscan y grabar sus barridos</translation>
    </message>
    <message>
        <source>holds no laser scans (messages sensor_msgs/LaserScan); its topics are: %1%2</source>
        <translation>no contiene barridos láser (mensajes sensor_msgs/LaserScan); sus temas son: %1%2</translation>
    </message>
    <message>
        <source>no message of the odometry %1 can be read, so that the transforms to &quot;%2&quot; are taken</source>
        <translation>no se puede leer ningún mensaje de la odometría %1, así que se toman las transformaciones a «%2»</translation>
    </message>
    <message>
        <source>--odom-topic %1 says what is wrong with them</source>
        <translation>--odom-topic %1 dice qué les pasa</translation>
    </message>
    <message>
        <source>%1 was received %2 s after its stamps and %3 %4 s after its own: the clocks of their computers differ</source>
        <translation>%1 se recibió %2 s después de sus sellos de tiempo y %3 %4 s después de los suyos: los relojes de sus ordenadores difieren</translation>
    </message>
    <message>
        <source>no transform says where the laser &quot;%1&quot; sits on the robot &quot;%2&quot;; it is taken to sit in its origin and look ahead, and where it does not, the map is bent where the robot turns</source>
        <translation>ninguna transformación dice dónde va el láser «%1» en el robot «%2»; se supone que va en su origen y mira hacia delante, y si no es así, el mapa se tuerce donde el robot gira</translation>
    </message>
    <message>
        <source>say where it sits: --laser-pose x,y,degrees</source>
        <translation>diga dónde va: --laser-pose x,y,grados</translation>
    </message>
    <message>
        <source>the frame &quot;%1&quot; goes to and fro between two places in %2, %3 times: two programs say where it is</source>
        <translation>el marco «%1» va y viene entre dos lugares en %2, %3 veces: dos programas dicen dónde está</translation>
    </message>
    <message>
        <source>take a topic for the odometry (--odom-topic), or say where the laser sits (--laser-pose), or record with one of them only</source>
        <translation>tome un tema para la odometría (--odom-topic), o diga dónde va el láser (--laser-pose), o grabe con uno solo de ellos</translation>
    </message>
    <message>
        <source>found one place for %1 lasers; choose one of them (--scan-topic)</source>
        <translation>se encontró un lugar para %1 láseres; elija uno de ellos (--scan-topic)</translation>
    </message>
    <message>
        <source>%1 of %2 scans have the time of the one before: their stamps have too few digits, and how the robot moved between them is not known</source>
        <translation>%1 de %2 barridos tienen el tiempo del anterior: sus sellos tienen muy pocas cifras, y no se sabe cómo se movió el robot entre ellos</translation>
    </message>
    <message>
        <source>record times with milliseconds, as numbers of 64 bits</source>
        <translation>grabe los tiempos con milisegundos, como números de 64 bits</translation>
    </message>
    <message>
        <source>%1 rays always end at the same distance, however the robot turns: on the robot itself; they draw its path as walls</source>
        <translation>%1 rayos acaban siempre a la misma distancia, gire como gire el robot: en el robot mismo; dibujan su camino como paredes</translation>
    </message>
    <message>
        <source>by the odometry the robot always drives %1 degrees off where it looks, which no robot on wheels does: its headings are off by that</source>
        <translation>según la odometría el robot avanza siempre a %1 grados de hacia donde mira, lo que no hace ningún robot con ruedas: sus orientaciones están desviadas en eso</translation>
    </message>
    <message>
        <source>the scans&apos; clock does not run as fast as the odometry&apos;s: they fit it where %1 are added at the beginning and %2 at the end (%3 % of their points, against %4 % as they are stamped)</source>
        <translation>el reloj de los barridos no va tan deprisa como el de la odometría: encajan si se suman %1 al principio y %2 al final (%3 % de sus puntos, frente a %4 % como están sellados)</translation>
    </message>
    <message>
        <source>by the scans the robot drives %1 times as far as by the odometry (%2 % of their points fit so, %3 % as it is told)</source>
        <translation>según los barridos el robot recorre %1 veces lo que dice la odometría (así encaja el %2 % de sus puntos, el %3 % como está dicho)</translation>
    </message>
    <message>
        <source>how the robot moved is taken from the scans alone (%1 a second), which cannot tell it where they see the same all along, as in a corridor</source>
        <translation>cómo se movió el robot se toma solo de los barridos (%1 por segundo), que no pueden decirlo donde ven siempre lo mismo, como en un pasillo</translation>
    </message>
    <message>
        <source>record the odometry too where there is some: of ROS its topic, or /tf together with /tf_static</source>
        <translation>grabe también la odometría si la hay: de ROS su tema, o /tf junto con /tf_static</translation>
    </message>
    <message>
        <source>how the robot moved is taken from the scans alone, which at %1 a second lie so far apart that they may be matched wrongly</source>
        <translation>cómo se movió el robot se toma solo de los barridos, que a %1 por segundo quedan tan lejos unos de otros que pueden casarse mal</translation>
    </message>
    <message>
        <source>record 10 scans a second, or drive slowly, or record the odometry too: of ROS its topic, or /tf together with /tf_static</source>
        <translation>grabe 10 barridos por segundo, o conduzca despacio, o grabe también la odometría: de ROS su tema, o /tf junto con /tf_static</translation>
    </message>
    <message>
        <source>look at the world&apos;s walls, in the window or by hitos-cli world, and correct the drawing</source>
        <translation>mire las paredes del mundo, en la ventana o con hitos-cli world, y corrija el plano</translation>
    </message>
    <message>
        <source>after a pause of %1 s the odometry is %2 m and %3 degrees off (line %4), as where a driver begins anew: the scans before and after it are of one place (%5 % of their points fit so, %6 % as the odometry says); the map falls in pieces there</source>
        <translation>tras una pausa de %1 s la odometría se desvía %2 m y %3 grados (línea %4), como cuando un controlador empieza de nuevo: los barridos de antes y de después son de un mismo sitio (así encaja el %5 % de sus puntos, según la odometría el %6 %); ahí el mapa se rompe en pedazos</translation>
    </message>
    <message>
        <source>%1 of %2 scans of %3 are parts of a turn that do not go on where the one before ends (the last ones are %4 degrees apart), so that each is taken as a scan of its own, which shows little</source>
        <translation>%1 de %2 barridos de %3 son partes de una vuelta que no siguen donde acaba la anterior (las últimas distan %4 grados), así que cada una se toma por un barrido propio, que muestra poco</translation>
    </message>
    <message>
        <source>record all messages of the laser, or let its driver send whole turns</source>
        <translation>grabe todos los mensajes del láser, o haga que su controlador envíe vueltas completas</translation>
    </message>
    <message>
        <source>found lasers of two robots in %1: %2, whose odometry is in %3, and %4, whose is in %5; choose those of one (--scan-topic)</source>
        <translation>hay láseres de dos robots en %1: %2, con su odometría en %3, y %4, con la suya en %5; elija los de uno (--scan-topic)</translation>
    </message>
    <message>
        <source>the odometry stands still while the robot drives, for up to %1 s, and makes up for it in one step, of up to %2 m (line %3), %4 in all; scans of that time lie on one place</source>
        <translation>la odometría se queda quieta mientras el robot avanza, hasta %1 s, y lo recupera de un solo paso, de hasta %2 m (línea %3), %4 veces en total; los barridos de ese tiempo quedan en un mismo sitio</translation>
    </message>
    <message>
        <source>%1 of %2 odometry readings are stamped no later than the one before: too coarsely, or by two clocks; how fast the robot moved is not known</source>
        <translation>%1 de %2 lecturas de odometría no llevan una hora posterior a la anterior: con pocas cifras, o de dos relojes; no se sabe a qué velocidad se movió el robot</translation>
    </message>
    <message>
        <source>by the scans the robot turns %1 times as far as by the odometry (%2 % of their points fit so, %3 % as it is told): headings are %4</source>
        <translation>según los barridos el robot gira %1 veces lo que dice la odometría (así encaja el %2 % de sus puntos, y el %3 % tal como está): los rumbos están %4</translation>
    </message>
    <message>
        <source>in degrees</source>
        <translation>en grados</translation>
    </message>
    <message>
        <source>taken for degrees and turned into radians</source>
        <translation>tomados por grados y pasados a radianes</translation>
    </message>
    <message>
        <source>the scans do not lie where the odometry puts them (%1 % of their points do), and no other time, mounting or scale explains it</source>
        <translation>los barridos no caen donde los pone la odometría (solo el %1 % de sus puntos), y ninguna otra hora, montaje ni escala lo explica</translation>
    </message>
    <message>
        <source>the odometry ends %1 s before the scans do, which change on; all of them are put on one place</source>
        <translation>la odometría acaba %1 s antes que los barridos, que siguen cambiando; todos ellos quedan en un mismo lugar</translation>
    </message>
    <message>
        <source>the odometry begins %1 s after the scans, which change before; all of them are put on one place</source>
        <translation>la odometría empieza %1 s después que los barridos, que cambian antes; todos ellos quedan en un mismo lugar</translation>
    </message>
    <message>
        <source>the scans change for %1 s, from second %2 of the tour on, and the odometry stands still; all of them are put on one place</source>
        <translation>los barridos cambian durante %1 s, desde el segundo %2 del recorrido, y la odometría está quieta; todos ellos quedan en un mismo lugar</translation>
    </message>
    <message>
        <source>the run was asked to end, and this takes long</source>
        <translation>se pidió que la ejecución acabara, y esto tarda</translation>
    </message>
    <message>
        <source>%1 of the first %2 stamps are the same as the one before: they have too few digits; the logger&apos;s times, the last number of each line, are taken in their place</source>
        <translation>%1 de los %2 primeros sellos de tiempo son iguales al anterior: tienen demasiado pocas cifras; en su lugar se toman los tiempos del registrador, el último número de cada línea</translation>
    </message>
    <message>
        <source>by the logger&apos;s times the stamps of %1 are %2 s behind those of %3: the clocks of their computers differ</source>
        <translation>según los tiempos del registrador, los sellos de tiempo de %1 van %2 s por detrás de los de %3: los relojes de sus ordenadores difieren</translation>
    </message>
    <message>
        <source>is a DWG drawing, no log; save it as DXF, of which hitos-cli world makes a world</source>
        <translation>es un dibujo DWG, no un registro; guárdelo como DXF, del que hitos-cli world hace un mundo</translation>
    </message>
    <message>
        <source>is a DXF drawing, no log; hitos-cli world makes a world of it, in which a tour can be driven</source>
        <translation>es un dibujo DXF, no un registro; hitos-cli world hace de él un mundo en el que se puede simular un recorrido</translation>
    </message>
    <message>
        <source>drawing: as metres, which nothing says, it is %1, large for a place that a robot maps. By other units (--unit, dxf_unit) it is: %2</source>
        <translation>dibujo: en metros, que nada indica, mide %1, mucho para un lugar que explore un robot. Con otras unidades (--unit, dxf_unit) es: %2</translation>
    </message>
    <message>
        <source>is a link to %1, which is not there; make that folder, or give another with --out</source>
        <translation>es un enlace a %1, que no existe; cree esa carpeta o indique otra con --out</translation>
    </message>
    <message>
        <source>unpacks to more than %1 MiB, %2 times its size; expected a text, which packs less well</source>
        <translation>se descomprime en más de %1 MiB, %2 veces su tamaño; se esperaba un texto, que se comprime menos</translation>
    </message>
    <message>
        <source>%1 is %2; expected a number from -%3 to %3</source>
        <translation>%1 es %2; se esperaba un número de -%3 a %3</translation>
    </message>
    <message>
        <source>has a key of more than %1 parts between dots</source>
        <translation>tiene una clave de más de %1 partes entre puntos</translation>
    </message>
    <message>
        <source>the odometry goes to and fro between two tracks, %1 times: two programs tell it, and the map is of neither</source>
        <translation>la odometría va y viene entre dos recorridos, %1 veces: la emiten dos programas y el mapa no es de ninguno</translation>
    </message>
    <message>
        <source>the odometry&apos;s heading leaps, by up to %1 degrees (line %2) and %3 in all; the robot is taken to drive on there as before, for a second</source>
        <translation>el rumbo de la odometría salta hasta %1 grados (línea %2), %3 veces en total; se supone que el robot sigue allí como antes, durante un segundo</translation>
    </message>
    <message>
        <source>%1 says that its least range is %2 m and its greatest %3 m; they are taken the other way round, as no reading lies between them</source>
        <translation>%1 dice que su alcance mínimo es %2 m y el máximo %3 m; se toman al revés, pues ninguna lectura está entre ellos</translation>
    </message>
    <message>
        <source>let the driver say range_min and range_max the right way round</source>
        <translation>haga que el controlador indique range_min y range_max en el orden correcto</translation>
    </message>
    <message>
        <source>%1 % of the readings of %2 are nearer than the least range of %3 m that it says, and are no points</source>
        <translation>el %1 % de las lecturas de %2 está más cerca que el alcance mínimo de %3 m que indica, y no son puntos</translation>
    </message>
    <message>
        <source>let the driver say the laser&apos;s own range_min</source>
        <translation>haga que el controlador indique el range_min propio del láser</translation>
    </message>
    <message>
        <source>no transforms are of the namespace of %1, so that those of %2 are taken; where that is another robot, the laser sits wrongly, and drives its way</source>
        <translation>ninguna transformación es del espacio de nombres de %1, por lo que se toman las de %2; si son de otro robot, el láser queda mal situado y sigue el camino de aquél</translation>
    </message>
    <message>
        <source>say where it sits (--laser-pose x,y,degrees) and take a topic for the odometry (--odom-topic)</source>
        <translation>indique dónde está (--laser-pose x,y,grados) y elija un tema para la odometría (--odom-topic)</translation>
    </message>
    <message>
        <source>look whether scans are published twice, or the laser&apos;s driver hung</source>
        <translation>mire si los barridos se publican dos veces o si el controlador del láser se colgó</translation>
    </message>
    <message>
        <source>where the robot turns, the scans fit the odometry of %1 s from theirs (%2 % of their points closely, against %3 % as they are stamped): walls move by %4 m in its turns</source>
        <translation>donde el robot gira, los barridos encajan con la odometría de %1 s respecto a la suya (el %2 % de sus puntos de cerca, frente al %3 % con sus marcas de tiempo): las paredes se desplazan %4 m en los giros</translation>
    </message>
    <message>
        <source>where the robot turns, the scans fit a laser that sits %1 m from where it is said to (%2 % of their points closely, against %3 %): walls are bent there</source>
        <translation>donde el robot gira, los barridos encajan con un láser situado a %1 m de donde se dice (el %2 % de sus puntos de cerca, frente al %3 %): allí las paredes se doblan</translation>
    </message>
    <message>
        <source>by the scans the robot turns %1 times as far as by the odometry (%2 % of their points fit closely so, %3 % as it is told): walls fan out where it turns</source>
        <translation>según los barridos el robot gira %1 veces lo que dice la odometría (así encaja de cerca el %2 % de sus puntos, el %3 % tal como se dice): las paredes se abren en abanico donde gira</translation>
    </message>
    <message>
        <source>in %1 pairs of scans the robot turns %2 degrees by the scans and %3 by the odometry, as where a gyro or an encoder is dead; the map is bent straight</source>
        <translation>en %1 pares de barridos el robot gira %2 grados según los barridos y %3 según la odometría, como cuando un giróscopo o un codificador no funciona; el mapa queda enderezado</translation>
    </message>
    <message>
        <source>in %1 pairs of scans the robot drives %2 m by the scans and %3 m by the odometry, as where an encoder is dead; the map is pushed together</source>
        <translation>en %1 pares de barridos el robot avanza %2 m según los barridos y %3 m según la odometría, como cuando un codificador no funciona; el mapa queda comprimido</translation>
    </message>
    <message>
        <source>has %1 x %2 pixels; expected at most %3</source>
        <translation>tiene %1 x %2 píxeles; se esperaban %3 como máximo</translation>
    </message>
    <message>
        <source>says %1 %2, and config.cfg beside it %3; one of the two was changed or is of another run</source>
        <translation>dice %1 %2, y config.cfg junto a él %3; uno de los dos ha sido modificado o es de otra ejecución</translation>
    </message>
    <message>
        <source>was changed since the run wrote it: its text is not what its own digest is of; do the run again</source>
        <translation>ha sido modificado desde que la ejecución lo escribió: su texto no corresponde a su propio resumen; repita la ejecución</translation>
    </message>
    <message>
        <source>is damaged, was changed, or its map is missing; start the shard that it is of again</source>
        <translation>está dañado, ha sido modificado o le falta su mapa; vuelva a iniciar la parte a la que pertenece</translation>
    </message>
    <message>
        <source>%1 is %2 m from %3: the tour takes more than %4 control steps; expected a shorter tour or a faster robot</source>
        <translation>%1 está a %2 m de %3: el recorrido lleva más de %4 pasos de control; se esperaba un recorrido más corto o un robot más rápido</translation>
    </message>
    <message>
        <source>the odometry&apos;s headings go from one end of a turn to the other in steps of 360, %1 times (first in line %2): they are in degrees, and are read as radians</source>
        <translation>los rumbos de la odometría pasan de un extremo de la vuelta al otro en pasos de 360, %1 veces (la primera en la línea %2): están en grados y se leen como radianes</translation>
    </message>
    <message>
        <source>the scans&apos; clock was set during the tour: they fit the odometry where %1 are added up to second %2 and %3 from there on (%4 % of their points, against %5 % as they are stamped)</source>
        <translation>el reloj de los barridos se cambió durante el recorrido: encajan con la odometría si se les suman %1 hasta el segundo %2 y %3 a partir de ahí (el %4 % de sus puntos, frente al %5 % con sus marcas de tiempo)</translation>
    </message>
    <message>
        <source>from scan to scan the odometry is off by %1 % of what the robot drives and turns by the scans, now this way and now that (by more than a hand&apos;s breadth in %2 of %3 pairs), as where stamps waver or poses are rounded: walls are blurred</source>
        <translation>de barrido a barrido la odometría se desvía un %1 % de lo que el robot avanza y gira según los barridos, unas veces hacia un lado y otras hacia otro (más de un palmo en %2 de %3 pares), como cuando las marcas de tiempo oscilan o las posiciones se redondean: las paredes quedan borrosas</translation>
    </message>
    <message>
        <source>the scans fit the odometry where their rays go over %1 degrees, not over %2 as is told (%3 % of their points, against %4 %): walls are bent</source>
        <translation>los barridos encajan con la odometría si sus rayos abarcan %1 grados, no %2 como se dice (el %3 % de sus puntos, frente al %4 %): las paredes se doblan</translation>
    </message>
    <message>
        <source>has changed while it was being worked on; %1 of %2 runs were done before, of the file as it was, and the others are left out; start again when the file is complete</source>
        <translation>ha cambiado mientras se trabajaba con él; %1 de %2 ejecuciones estaban hechas antes, con el archivo tal como era, y las demás se dejan; empiece otra vez cuando el archivo esté completo</translation>
    </message>
    <message>
        <source>millimetres</source>
        <translation>milímetros</translation>
    </message>
    <message>
        <source>centimetres</source>
        <translation>centímetros</translation>
    </message>
    <message>
        <source>inches</source>
        <translation>pulgadas</translation>
    </message>
    <message>
        <source>feet</source>
        <translation>pies</translation>
    </message>
    <message>
        <source>the odometry&apos;s headings turn 57 times as far as its %1, in %2 of %3 steps: degrees were taken for radians</source>
        <translation>los rumbos de la odometría giran 57 veces más que %1, en %2 de %3 pasos: se tomaron grados por radianes</translation>
    </message>
    <message>
        <source>velocities</source>
        <translation>sus velocidades</translation>
    </message>
    <message>
        <source>way</source>
        <translation>su camino</translation>
    </message>
    <message>
        <source>let the driver say how long it takes from one ray to the next (time_increment)</source>
        <translation>haga que el controlador diga cuánto tarda de un rayo al siguiente (time_increment)</translation>
    </message>
    <message>
        <source>its rays go over %1 degrees, expected no more than a turn; if its angles are in degrees and not in radians: --set source.fan_scale=%2</source>
        <translation>sus rayos abarcan %1 grados, se esperaba no más de una vuelta; si sus ángulos están en grados y no en radianes: --set source.fan_scale=%2</translation>
    </message>
    <message>
        <source>%1 % of the readings lie beyond the greatest range of %2 m and are no points; half of them are above %3</source>
        <translation>el %1 % de las lecturas está más allá del alcance máximo de %2 m y no son puntos; la mitad supera %3</translation>
    </message>
    <message>
        <source>half of the readings are beyond %1 m, and by the odometry they are %2; the map is that many times too large</source>
        <translation>la mitad de las lecturas supera %1 m, y según la odometría son %2; el mapa es otras tantas veces demasiado grande</translation>
    </message>
    <message>
        <source>a scan&apos;s rays are taken to need %1 s, and where the robot turns they fit as if measured at one time (%2 % of their points closely, against %3 %): walls are bent there</source>
        <translation>los rayos de un barrido se toman por medidos en %1 s, y donde el robot gira encajan como medidos a la vez (el %2 % de sus puntos de cerca, frente al %3 %): allí las paredes se tuercen</translation>
    </message>
    <message>
        <source>the scans fit the odometry where %1 m are added to every reading (%2 % of their points closely, against %3 %): walls are bent</source>
        <translation>los barridos encajan con la odometría si a cada lectura se suman %1 m (el %2 % de sus puntos de cerca, frente al %3 %): las paredes se tuercen</translation>
    </message>
    <message>
        <source>%1 of %2 rays never have a reading, each between others that have: no two points are neighbours, and walls fall to pieces</source>
        <translation>%1 de %2 rayos nunca tienen lectura, cada uno entre otros que sí: no hay dos puntos vecinos, y las paredes se deshacen</translation>
    </message>
    <message>
        <source>let the driver tell those rays only that it measures, with the step between these (angle_increment)</source>
        <translation>haga que el controlador diga solo los rayos que mide, con el paso entre estos (angle_increment)</translation>
    </message>
    <message>
        <source>its scans are points and hold none; look at what wrote them</source>
        <translation>sus barridos son puntos y no contienen ninguno; revise lo que los escribió</translation>
    </message>
    <message>
        <source>the format %1 says not which lines it wants or how they are read; give its entry classify and make_conversor</source>
        <translation>el formato %1 no dice qué líneas quiere ni cómo se leen; dé a su entrada classify y make_conversor</translation>
    </message>
    <message>
        <source>found &quot;%1&quot;, expected what the log has in the place of x, y and heading: &quot;x,y,theta&quot; with axes in another order or negative and theta, or degrees where it is in degrees, as in &quot;y,x,theta&quot;, &quot;x,y,90-theta&quot;, &quot;x,y,degrees&quot;</source>
        <translation>se encontró &quot;%1&quot;; se esperaba lo que el registro tiene en el lugar de x, y y rumbo: &quot;x,y,theta&quot; con los ejes en otro orden o negativos y theta, o degrees donde está en grados, como en &quot;y,x,theta&quot;, &quot;x,y,90-theta&quot;, &quot;x,y,degrees&quot;</translation>
    </message>
    <message>
        <source>the odometry&apos;s headings are where its positions go if they are in degrees (%1 % of the way, against %2 % as they are read)</source>
        <translation>los rumbos de la odometría van hacia donde van sus posiciones si están en grados (%1 % del camino, frente a %2 % tal como se leen)</translation>
    </message>
    <message>
        <source>the odometry&apos;s headings turn the other way than its positions (they fit each other on %1 % of the way so, on %2 % as they are told): headings count to the right, or an axis of the positions is swapped or negative</source>
        <translation>los rumbos de la odometría giran al revés que sus posiciones (así concuerdan en el %1 % del camino; tal como se dan, en el %2 %): los rumbos cuentan hacia la derecha, o un eje de las posiciones está cambiado o es negativo</translation>
    </message>
    <message>
        <source>the odometry&apos;s headings go to and fro, %1 times, and its positions do not: they are not in radians, or two programs tell them</source>
        <translation>los rumbos de la odometría van y vienen, %1 veces, y sus posiciones no: no están en radianes, o los dan dos programas</translation>
    </message>
    <message>
        <source>the line method returned %1 points from %2 on, of %3, for line %4 of the scan at %5 s; expected at least one, and all of them in Observation::support</source>
        <translation>el método de rectas devolvió %1 puntos desde el %2, de %3, para la recta %4 del barrido de %5 s; se esperaba al menos uno, y todos en Observation::support</translation>
    </message>
    <message>
        <source>found &quot;%1&quot;, expected seconds, or seconds@second of the tour as in 0@0,-1.39@680, as check advises</source>
        <translation>se encontró &quot;%1&quot;; se esperaban segundos, o segundos@segundo del recorrido como en 0@0,-1.39@680, según aconseja check</translation>
    </message>
    <message>
        <source>where the headings are wrong, let them turn</source>
        <translation>si lo errado son las orientaciones, déjelas girar</translation>
    </message>
    <message>
        <source>where the positions are wrong, put their axes right</source>
        <translation>si lo errado son las posiciones, corrija sus ejes</translation>
    </message>
    <message>
        <source>record with one of them only</source>
        <translation>grabe con uno solo de ellos</translation>
    </message>
    <message>
        <source>by the odometry they are metres</source>
        <translation>según la odometría son metros</translation>
    </message>
    <message>
        <source>by the odometry they are %1</source>
        <translation>según la odometría son %1</translation>
    </message>
    <message>
        <source>if they are metres</source>
        <translation>si son metros</translation>
    </message>
    <message>
        <source>say so</source>
        <translation>indíquelo</translation>
    </message>
    <message>
        <source>add that to their times, in all</source>
        <translation>súmelo a sus tiempos, en total</translation>
    </message>
    <message>
        <source>add the difference to the scans&apos; times</source>
        <translation>sume la diferencia a los tiempos de los barridos</translation>
    </message>
    <message>
        <source>take how it moved from the scans, where they show enough for that</source>
        <translation>tome de los barridos cómo se movió, si muestran lo bastante</translation>
    </message>
    <message>
        <source>take the velocities</source>
        <translation>tome las velocidades</translation>
    </message>
    <message>
        <source>found &quot;%1&quot;, expected seconds to add to the scans&apos; times and after how many seconds of the tour, in their order and no more than two of one second, as in &quot;0@0,-1.39@680&quot;</source>
        <translation>se encontró «%1», se esperaban segundos que sumar a los tiempos de los barridos y tras cuántos segundos del recorrido, en su orden y no más de dos del mismo segundo, como en «0@0,-1.39@680»</translation>
    </message>
    <message>
        <source>add that to their times, and set the clocks of both computers alike before recording</source>
        <translation>súmelo a sus tiempos, y ponga en hora igual los relojes de ambos ordenadores antes de grabar</translation>
    </message>
    <message>
        <source>read them as such</source>
        <translation>léalas como tales</translation>
    </message>
    <message>
        <source>all of them are taken; let the driver say the step between rays that the laser makes (angle_increment); if it turns all round</source>
        <translation>se toman todos; haga que el controlador diga el paso entre rayos que da el láser (angle_increment); si da la vuelta entera</translation>
    </message>
    <message>
        <source>record times of one clock with milliseconds</source>
        <translation>grabe horas de un solo reloj con milisegundos</translation>
    </message>
    <message>
        <source>leave out what is so near</source>
        <translation>omita lo que está tan cerca</translation>
    </message>
    <message>
        <source>turn its headings back</source>
        <translation>gire sus orientaciones</translation>
    </message>
    <message>
        <source>or, where the scans are to be turned with it</source>
        <translation>o, si los barridos han de girar con ella</translation>
    </message>
    <message>
        <source>the scans fit the odometry where %1 are added to their times</source>
        <translation>los barridos encajan con la odometría si a sus tiempos se suman %1</translation>
    </message>
    <message>
        <source>or, where the laser&apos;s readings are no metres</source>
        <translation>o, si las lecturas del láser no son metros</translation>
    </message>
    <message>
        <source>if the laser&apos;s readings are %1</source>
        <translation>si las lecturas del láser son %1</translation>
    </message>
    <message>
        <source>or, where it is the odometry</source>
        <translation>o, si es la odometría</translation>
    </message>
    <message>
        <source>if the laser is upside down, or its rays go the other way round</source>
        <translation>si el láser está boca abajo, o sus rayos van en sentido contrario</translation>
    </message>
    <message>
        <source>if it is the odometry that counts turns to the right</source>
        <translation>si es la odometría la que cuenta los giros a la derecha</translation>
    </message>
    <message>
        <source>with the wrong one of both the map is right but mirrored</source>
        <translation>con el equivocado de los dos el mapa es correcto pero reflejado</translation>
    </message>
    <message>
        <source>the odometry&apos;s heading points elsewhere than the robot; let the laser turn with it</source>
        <translation>la orientación de la odometría apunta a otro lado que el robot; haga girar el láser con ella</translation>
    </message>
    <message>
        <source>the laser is mounted otherwise than the recording says</source>
        <translation>el láser está montado de otro modo que lo que dice la grabación</translation>
    </message>
    <message>
        <source>so they are by the odometry; say so</source>
        <translation>así es según la odometría; indíquelo</translation>
    </message>
    <message>
        <source>by the odometry they take a turn from scan to scan</source>
        <translation>según la odometría dan una vuelta de un barrido a otro</translation>
    </message>
    <message>
        <source>say where it sits</source>
        <translation>indique dónde está</translation>
    </message>
    <message>
        <source>every run failed; the first: %1</source>
        <translation>fallaron todas las ejecuciones; la primera: %1</translation>
    </message>
    <message>
        <source>tenths of a millimetre</source>
        <translation>décimas de milímetro</translation>
    </message>
    <message>
        <source>if they are %1</source>
        <translation>si son %1</translation>
    </message>
    <message>
        <source>the scans&apos; clock was set %1 times during the tour, first by %2 at second %3: with that taken back %4 % of their points fit the odometry meanwhile, against %5 % as they are stamped</source>
        <translation>el reloj de los barridos se puso en hora %1 veces durante el recorrido, primero en %2 en el segundo %3: deshecho eso, el %4 % de sus puntos encaja entretanto con la odometría, frente al %5 % tal como están fechados</translation>
    </message>
    <message>
        <source>half of the readings are nearer than %1 m, and by the odometry they are %2 times as long; the map is that many times too small</source>
        <translation>la mitad de las lecturas están a menos de %1 m, y según la odometría son %2 veces más largas; el mapa queda tantas veces más pequeño</translation>
    </message>
    <message>
        <source>if its positions are %1</source>
        <translation>si sus posiciones son %1</translation>
    </message>
    <message>
        <source>the picture could not be drawn: %1</source>
        <translation>no se pudo dibujar la imagen: %1</translation>
    </message>
    <message>
        <source>is no picture, or a damaged one; expected PNG, JPG, PGM or BMP that is not compressed</source>
        <translation>no es una imagen, o está dañada; se esperaba PNG, JPG, PGM o BMP sin comprimir</translation>
    </message>
    <message>
        <source>the system gives no more of it</source>
        <translation>el sistema no da más</translation>
    </message>
    <message>
        <source>found a figure of a run of the word &quot;%1&quot;, but tables, records or Python say &quot;%2&quot; of something else; give it another word</source>
        <translation>hay una medida de una ejecución con la palabra &quot;%1&quot;, pero las tablas, los registros o Python llaman &quot;%2&quot; a otra cosa; dele otra palabra</translation>
    </message>
    <message>
        <source>%1 and %2 are both trajectories; expected one of them, and a map beside it</source>
        <translation>%1 y %2 son ambas trayectorias; se esperaba una de ellas y un mapa a su lado</translation>
    </message>
    <message>
        <source>%1 and %2 are both maps; expected one of them, and a trajectory beside it</source>
        <translation>%1 y %2 son ambos mapas; se esperaba uno de ellos y una trayectoria a su lado</translation>
    </message>
    <message>
        <source>the reference trajectory is not one of this tour: %1 of %2 poses have one of it within %3 s; the tour goes from second %4 to %5, the reference from %6 to %7; expected the true path of this very tour, of a tenth of its time at least, with stamps of the same clock in seconds (hitos-cli run and evaluate take poses that are further away with --tolerance)</source>
        <translation>la trayectoria de referencia no es de este recorrido: %1 de %2 poses tienen una de ella a menos de %3 s; el recorrido va del segundo %4 al %5, la referencia del %6 al %7; se esperaba el camino verdadero de este mismo recorrido, de una décima parte de su tiempo al menos, con marcas del mismo reloj en segundos (hitos-cli run y evaluate toman poses más alejadas con --tolerance)</translation>
    </message>
    <message>
        <source>the odometry has poses and no velocities, which are asked for: none of it is used</source>
        <translation>la odometría tiene poses y no velocidades, que son las que se piden: no se usa nada de ella</translation>
    </message>
    <message>
        <source>take the poses</source>
        <translation>tome las poses</translation>
    </message>
    <message>
        <source>the odometry&apos;s velocities are 0 although its poses change; all scans are put on one place</source>
        <translation>las velocidades de la odometría son 0 aunque sus poses cambian; todos los barridos se ponen en un mismo lugar</translation>
    </message>
    <message>
        <source>change %1: %2</source>
        <translation>cambio %1: %2</translation>
    </message>
    <message>
        <source>found more than %1 changes</source>
        <translation>hay más de %1 cambios</translation>
    </message>
    <message>
        <source>scan %1 is said to come back to scan %2; expected an earlier one</source>
        <translation>se dice que el barrido %1 vuelve al barrido %2; se esperaba uno anterior</translation>
    </message>
    <message>
        <source>the first scan is where the map begins: it can neither be fixed elsewhere nor slip</source>
        <translation>el primer barrido es donde empieza el mapa: ni se puede fijar en otro lugar ni puede patinar</translation>
    </message>
    <message>
        <source>is of the same scans as change %1</source>
        <translation>es de los mismos barridos que el cambio %1</translation>
    </message>
    <message>
        <source>found %1; expected &quot;refuse A B&quot;, &quot;close A B X Y THETA&quot;, &quot;fix A X Y THETA&quot; or &quot;slip A&quot;, A and B ids of poses, X and Y in metres, THETA in rad from -2 pi to 2 pi</source>
        <translation>se encontró %1; se esperaba «refuse A B», «close A B X Y THETA», «fix A X Y THETA» o «slip A», con A y B números de poses, X e Y en metros y THETA en rad de -2 pi a 2 pi</translation>
    </message>
    <message>
        <source>names pose %1 twice; expected two poses</source>
        <translation>nombra dos veces la pose %1; se esperaban dos poses</translation>
    </message>
    <message>
        <source>is of the same poses as change %1</source>
        <translation>es de las mismas poses que el cambio %1</translation>
    </message>
    <message>
        <source>no pose in the file; expected a graph of the plane as g2o writes it, with lines &quot;%1&quot;</source>
        <translation>no hay ninguna pose en el archivo; se esperaba un grafo del plano como los escribe g2o, con líneas «%1»</translation>
    </message>
    <message>
        <source>no pose in the file, and lines %1; expected a graph of the plane as g2o writes it, with lines &quot;%2&quot;</source>
        <translation>no hay ninguna pose en el archivo, y sí líneas %1; se esperaba un grafo del plano como los escribe g2o, con líneas «%2»</translation>
    </message>
    <message>
        <source>the edge goes from vertex %1 to itself; expected two vertices</source>
        <translation>la arista va del vértice %1 a él mismo; se esperaban dos vértices</translation>
    </message>
    <message>
        <source>the information has the eigenvalue %1; expected none below 0: the inverse of a covariance, its upper triangle row by row</source>
        <translation>la información tiene el valor propio %1; se esperaba ninguno menor que 0: la inversa de una covarianza, su triángulo superior fila a fila</translation>
    </message>
    <message>
        <source>vertex %1 is there already, in line %2; expected another id</source>
        <translation>el vértice %1 ya está, en la línea %2; se esperaba otro número</translation>
    </message>
    <message>
        <source>names vertex %1, which the file does not have; expected a line VERTEX_SE2, VERTEX_XY or VERTEX_LINE2D with that id</source>
        <translation>nombra el vértice %1, que no está en el archivo; se esperaba una línea VERTEX_SE2, VERTEX_XY o VERTEX_LINE2D con ese número</translation>
    </message>
    <message>
        <source>vertex %1 is of %2; expected one of %3</source>
        <translation>el vértice %1 es de %2; se esperaba uno de %3</translation>
    </message>
    <message>
        <source>%1 is %2; expected a whole number from 0 to %3</source>
        <translation>%1 es %2; se esperaba un número entero de 0 a %3</translation>
    </message>
    <message>
        <source>has more than %1 vertices and edges</source>
        <translation>tiene más de %1 vértices y aristas</translation>
    </message>
    <message>
        <source>pose %1 is fixed by the graph already</source>
        <translation>el grafo ya fija la pose %1</translation>
    </message>
    <message>
        <source>the graph has no pose with the id %1</source>
        <translation>el grafo no tiene ninguna pose con el número %1</translation>
    </message>
    <message>
        <source>the graph has no edge between the poses %1 and %2</source>
        <translation>el grafo no tiene ninguna arista entre las poses %1 y %2</translation>
    </message>
    <message>
        <source>pose %1 has the lowest id: no step leads to it</source>
        <translation>la pose %1 tiene el número más bajo: ningún paso lleva a ella</translation>
    </message>
    <message>
        <source>the errors of the graph&apos;s edges are beyond reckoning; are its numbers metres and radians, and its information their inverse variances?</source>
        <translation>los errores de las aristas del grafo son incalculables; ¿son sus números metros y radianes, y su información las inversas de sus varianzas?</translation>
    </message>
    <message>
        <source>the edges join so many of the graph&apos;s vertices across it that solving it takes more than %1 million numbers; expected a graph of places most of which see few others</source>
        <translation>las aristas unen tantos vértices del grafo entre sí que resolverlo necesita más de %1 millones de números; se esperaba un grafo de lugares que en su mayoría vean pocos otros</translation>
    </message>
    <message>
        <source>change %1 is of another tour, or of this one read otherwise: scan %2 had the stamp %3 when it was made, and has %4</source>
        <translation>el cambio %1 es de otro recorrido, o de este leído de otro modo: el barrido %2 tenía la marca de tiempo %3 cuando se hizo, y tiene %4</translation>
    </message>
    <message>
        <source>found the verdict %1 of a loop; expected %2</source>
        <translation>hay el veredicto %1 de un bucle; se esperaba %2</translation>
    </message>
    <message>
        <source>the walls match, and the graph explains it</source>
        <translation>las paredes coinciden, y el grafo lo explica</translation>
    </message>
    <message>
        <source>the points lie badly on the earlier walls: a score of %1, and more than %2 is asked</source>
        <translation>los puntos caen mal sobre las paredes de antes: una puntuación de %1, y se pide más de %2</translation>
    </message>
    <message>
        <source>one direction is left open, as along a corridor</source>
        <translation>una dirección queda abierta, como a lo largo de un pasillo</translation>
    </message>
    <message>
        <source>one passage looks through %1 of what the other saw, and at most %2 is allowed</source>
        <translation>una pasada ve a través del %1 de lo que vio la otra, y se permite como mucho el %2</translation>
    </message>
    <message>
        <source>too few searches in a row have said the same yet</source>
        <translation>aún son pocas las búsquedas seguidas que han dicho lo mismo</translation>
    </message>
    <message>
        <source>the scan alone says too little of any earlier one</source>
        <translation>el barrido por sí solo dice muy poco de cualquiera anterior</translation>
    </message>
    <message>
        <source>the graph would be bent more than its edges explain: chi-square %1, and at most %2 is allowed</source>
        <translation>el grafo se doblaría más de lo que explican sus aristas: ji cuadrado %1, y se permite como mucho %2</translation>
    </message>
    <message>
        <source>sets %1 too; expected a file of changes by hand, which sets %2 alone: a whole configuration is read by --config</source>
        <translation>también da un valor a %1; se esperaba un archivo de cambios a mano, que solo lo da a %2: una configuración entera se lee con --config</translation>
    </message>
    <message>
        <source>changes by hand are of the graph of key scans, and with these parameters there is none; try --preset recorded</source>
        <translation>los cambios a mano son del grafo de barridos clave, y con estos parámetros no lo hay; pruebe --preset recorded</translation>
    </message>
    <message>
        <source>somebody has put it in</source>
        <translation>alguien lo ha metido</translation>
    </message>
    <message>
        <source>somebody has taken it out</source>
        <translation>alguien lo ha sacado</translation>
    </message>
    <message>
        <source>change %1 is of another tour: it names scan %2, and there are %3</source>
        <translation>el cambio %1 es de otro recorrido: nombra el barrido %2, y hay %3</translation>
    </message>
    <message>
        <source>scan %1 is no key scan</source>
        <translation>el barrido %1 no es un barrido clave</translation>
    </message>
    <message>
        <source>has no change by hand; expected %1 with at least one</source>
        <translation>no tiene ningún cambio a mano; se esperaba %1 con uno al menos</translation>
    </message>
    <message>
        <source>--set %1 names other changes; give one of them</source>
        <translation>--set %1 nombra otros cambios; dé uno de los dos</translation>
    </message>
    <message>
        <source>another place looks nearly as like</source>
        <translation>otro lugar se parece casi igual</translation>
    </message>
    <message>
        <source>the robot may have been carried, and for that the places are too little alike: %1 (score times overlap times what is not seen through), and more than %2 is asked; %3 is seen through, and at most %4 is allowed</source>
        <translation>puede que el robot haya sido llevado, y para eso los lugares se parecen poco: %1 (puntuación por solape por lo que no se atraviesa con la vista), y se pide más de %2; se atraviesa con la vista %3, y se admite como mucho %4</translation>
    </message>
    <message>
        <source>found &quot;%1&quot;, expected a pose in the map as &quot;x,y,degrees&quot;, in metres</source>
        <translation>hay «%1»; se esperaba una pose en el mapa como «x,y,grados», en metros</translation>
    </message>
    <message>
        <source>only registration finds the robot in the map of another tour; use preset recorded, or %1 and registration.loops=on</source>
        <translation>solo la alineación de barridos encuentra al robot en el mapa de otro recorrido; use --preset recorded, o %1 y registration.loops=on</translation>
    </message>
    <message>
        <source>graph-slam moves every landmark of its graph; use another filter.algorithm to hold a map</source>
        <translation>graph-slam mueve todas las marcas de su grafo; use otro filter.algorithm para retener un mapa</translation>
    </message>
    <message>
        <source>%1 is the end of a chain of more than %2 maps, or of a circle of them</source>
        <translation>%1 es el final de una cadena de más de %2 mapas, o de un círculo de ellos</translation>
    </message>
    <message>
        <source>holds no results of a run (no config.cfg); expected the folder that a run of the first tour has written</source>
        <translation>no tiene resultados de una ejecución (no hay config.cfg); se esperaba la carpeta que ha escrito una ejecución del primer recorrido</translation>
    </message>
    <message>
        <source>holds the results of %1 scans, and its log %2 has %3: it was stopped, or the log has changed; run it again</source>
        <translation>tiene los resultados de %1 barridos, y su registro %2 tiene %3: se detuvo, o el registro ha cambiado; ejecútelo de nuevo</translation>
    </message>
    <message>
        <source>the folder&apos;s name is not UTF-8, as a configuration has to be; rename it</source>
        <translation>el nombre de la carpeta no es UTF-8, como tiene que ser una configuración; cámbielo</translation>
    </message>
    <message>
        <source>is no table of a benchmark</source>
        <translation>no es la tabla de una comparativa</translation>
    </message>
    <message>
        <source>is not there; it can be had from %1</source>
        <translation>no está; se puede obtener de %1</translation>
    </message>
    <message>
        <source>is another file than the plan means: its digest is %1, expected %2</source>
        <translation>es otro archivo que el del plan: su resumen digital es %1, se esperaba %2</translation>
    </message>
    <message>
        <source>the tour names no trajectory to measure a peer&apos;s against</source>
        <translation>el recorrido no nombra ninguna trayectoria con la que medir la de otro programa</translation>
    </message>
    <message>
        <source>is neither a file nor a benchmark that comes with Hitos; those are %1</source>
        <translation>no es un archivo ni una comparativa que venga con Hitos; las que hay son %1</translation>
    </message>
    <message>
        <source>is of the format %1, but no tour by itself; expected %2</source>
        <translation>es del formato %1, pero no un recorrido por sí solo; se esperaba %2</translation>
    </message>
    <message>
        <source>one that Barcodes.dat lists</source>
        <translation>uno de los que enumera Barcodes.dat</translation>
    </message>
    <message>
        <source>no less than 0</source>
        <translation>no menos de 0</translation>
    </message>
    <message>
        <source>a whole number from 0, or -1 where it is unknown</source>
        <translation>un número entero desde 0, o -1 donde no se conoce</translation>
    </message>
    <message>
        <source>the landmarks that n announces</source>
        <translation>los hitos que anuncia n</translation>
    </message>
    <message>
        <source>the landmarks of line %1 (time %2) cannot be written as readings of a laser; write them in the normalized format</source>
        <translation>los hitos de la línea %1 (tiempo %2) no se pueden escribir como lecturas de un láser; escríbalos en el formato normalized</translation>
    </message>
    <message>
        <source>identity: found %1, expected a whole number from 0</source>
        <translation>identity: se encontró %1, se esperaba un número entero desde 0</translation>
    </message>
    <message>
        <source>[%1]: no such group; expected [tour], [robot], [laser], [landmarks], [raster] or [odometry]</source>
        <translation>[%1]: no existe ese grupo; se esperaba [tour], [robot], [laser], [landmarks], [raster] u [odometry]</translation>
    </message>
    <message>
        <source>%1: no such key; expected walls, walls_dxf, dxf_layer, dxf_unit, doors, people, seed, [tour], [robot], [laser], [landmarks], [raster] or [odometry]</source>
        <translation>%1: no existe esa clave; se esperaba walls, walls_dxf, dxf_layer, dxf_unit, doors, people, seed, [tour], [robot], [laser], [landmarks], [raster] u [odometry]</translation>
    </message>
    <message>
        <source>one that no line before lists</source>
        <translation>uno que ninguna línea anterior enumere</translation>
    </message>
    <message>
        <source>expected the heading &quot;%1&quot; of a table that hitos-cli run --hashes writes</source>
        <translation>se esperaba el encabezado &quot;%1&quot; de una tabla que escribe hitos-cli run --hashes</translation>
    </message>
    <message>
        <source>expected the number of a scan and its seven hashes of 16 digits</source>
        <translation>se esperaba el número de un barrido y sus siete resúmenes de 16 dígitos</translation>
    </message>
    <message>
        <source>landmark %1, (%2, %3)</source>
        <translation>el hito %1, (%2, %3)</translation>
    </message>
    <message>
        <source>found %1 radii of %2 landmarks, expected one for each, or none</source>
        <translation>hay %1 radios para %2 hitos; se esperaba uno para cada uno, o ninguno</translation>
    </message>
    <message>
        <source>landmarks.radii: expected a radius in metres</source>
        <translation>landmarks.radii: se esperaba un radio en metros</translation>
    </message>
    <message>
        <source>start: free, %1 m from what is nearest</source>
        <translation>salida: libre, a %1 m de lo más cercano</translation>
    </message>
    <message>
        <source>start: %1 m from what is nearest, expected at least the robot&apos;s radius of %2 m</source>
        <translation>salida: a %1 m de lo más cercano; se esperaba al menos el radio del robot, %2 m</translation>
    </message>
    <message>
        <source>landmarks.radii: found none; leave the key out where a sensor tells the landmarks</source>
        <translation>landmarks.radii: no hay ninguno; omita la clave donde un sensor dice los hitos</translation>
    </message>
    <message>
        <source>holds the results of a run, which would not be what they were; choose another folder</source>
        <translation>tiene los resultados de una ejecución, que dejarían de ser lo que eran; elija otra carpeta</translation>
    </message>
    <message>
        <source>found %1; expected &quot;refuse SCAN EARLIER&quot;, &quot;close SCAN EARLIER X Y THETA&quot;, &quot;fix SCAN X Y THETA&quot;, &quot;slip SCAN&quot;, &quot;wall SCAN BEARING X1 Y1 X2 Y2&quot; or &quot;point SCAN DX DY X Y&quot;, scans counted from 1, as SCAN@STAMP where the stamp is to be held, X and Y in metres, THETA and BEARING in rad from -2 pi to 2 pi</source>
        <translation>se encontró %1; se esperaba «refuse BARRIDO ANTERIOR», «close BARRIDO ANTERIOR X Y THETA», «fix BARRIDO X Y THETA», «slip BARRIDO», «wall BARRIDO RUMBO X1 Y1 X2 Y2» o «point BARRIDO DX DY X Y», con los barridos contados desde 1, como BARRIDO@TIEMPO donde se quiera comprobar su tiempo, X e Y en metros, THETA y RUMBO en rad de -2 pi a 2 pi</translation>
    </message>
    <message>
        <source>the wall of the drawing has no direction, it is %1 m long; expected two places on it, %2 m apart at least</source>
        <translation>la pared del dibujo no tiene dirección, mide %1 m; se esperaban dos sitios de ella, a %2 m uno de otro por lo menos</translation>
    </message>
    <message>
        <source>change %1: scan %2 sees no straight wall of half a metre in the direction of %3 rad (%4 degrees to the left of ahead)</source>
        <translation>cambio %1: el barrido %2 no ve ninguna pared recta de medio metro en la dirección de %3 rad (%4 grados a la izquierda del frente)</translation>
    </message>
    <message>
        <source>change %1: the wall that scan %2 sees is turned by %3 degrees against that of the drawing, as the walls before it lay the drawing, and at most 45 are taken; is it another wall, or are its ends the wrong way round? The first is the left one, as the robot sees it</source>
        <translation>cambio %1: la pared que ve el barrido %2 está girada %3 grados respecto a la del dibujo, tal como lo colocan las paredes anteriores, y se admiten 45 como mucho; ¿es otra pared, o están sus extremos al revés? El primero es el izquierdo, visto desde el robot</translation>
    </message>
    <message>
        <source>a graph from a file has no scans that see a wall or point of a drawing; &quot;fix&quot; holds a pose at a known place</source>
        <translation>un grafo de un archivo no tiene barridos que vean una pared o un punto de un dibujo; «fix» sujeta una pose en un sitio conocido</translation>
    </message>
    <message>
        <source>has become shorter while it was followed, from %1 to %2 bytes; what it had before that is what counts</source>
        <translation>se ha acortado mientras se seguía, de %1 a %2 bytes; cuenta lo que tenía antes</translation>
    </message>
    <message>
        <source>found a frame that is not of the protocol: %1</source>
        <translation>se ha encontrado una trama que no es del protocolo: %1</translation>
    </message>
    <message>
        <source>&quot;%1&quot; is missing or of another kind</source>
        <translation>«%1» falta o es de otra clase</translation>
    </message>
    <message>
        <source>a channel is no object</source>
        <translation>un canal no es un objeto</translation>
    </message>
    <message>
        <source>it is no JSON object</source>
        <translation>no es un objeto JSON</translation>
    </message>
    <message>
        <source>it is empty</source>
        <translation>está vacía</translation>
    </message>
    <message>
        <source>%1; it is looked for again</source>
        <translation>%1; se vuelve a buscar</translation>
    </message>
    <message>
        <source>connected again after %1 s</source>
        <translation>conectado de nuevo tras %1 s</translation>
    </message>
    <message>
        <source>%1; it was looked for for %2 s, and the tour ends here</source>
        <translation>%1; se ha buscado durante %2 s, y el recorrido termina aquí</translation>
    </message>
    <message>
        <source>the server says: %1</source>
        <translation>el servidor dice: %1</translation>
    </message>
    <message>
        <source>receives %1 (%2)</source>
        <translation>recibe %1 (%2)</translation>
    </message>
    <message>
        <source>cannot keep what comes in: %1; the tour ends with what it has</source>
        <translation>no puede guardar lo que llega: %1; el recorrido termina con lo que tiene</translation>
    </message>
    <message>
        <source>cannot be made to keep what comes in: %1</source>
        <translation>no se puede crear para guardar lo que llega: %1</translation>
    </message>
    <message>
        <source>ended before anything came; expected a log from the program before the |</source>
        <translation>terminó antes de que llegara nada; se esperaba un registro del programa delante de |</translation>
    </message>
    <message>
        <source>the connection is lost: %1</source>
        <translation>se ha perdido la conexión: %1</translation>
    </message>
    <message>
        <source>found &quot;%1&quot;; encrypted connections are not spoken, expected ws://HOST:PORT, for instance through a tunnel of ssh</source>
        <translation>se ha encontrado «%1»; no hay conexiones cifradas, se esperaba ws://HOST:PORT, por ejemplo a través de un túnel de ssh</translation>
    </message>
    <message>
        <source>cannot be connected to: %1</source>
        <translation>no se puede conectar: %1</translation>
    </message>
    <message>
        <source>is no server of the Foxglove protocol: it answers &quot;%1&quot; where a WebSocket is asked for</source>
        <translation>no es un servidor del protocolo de Foxglove: responde «%1» donde se pide un WebSocket</translation>
    </message>
    <message>
        <source>is no server of the Foxglove protocol: of %1 it speaks none</source>
        <translation>no es un servidor del protocolo de Foxglove: de %1 no habla ninguno</translation>
    </message>
    <message>
        <source>is compressed; a log that is followed while it is written is plain text or MCAP</source>
        <translation>está comprimido; un registro que se sigue mientras se escribe es texto sin comprimir o MCAP</translation>
    </message>
    <message>
        <source>is of the format %1; a log that is followed while it is written is text in one file, or MCAP</source>
        <translation>es del formato %1; un registro que se sigue mientras se escribe es texto en un solo archivo, o MCAP</translation>
    </message>
    <message>
        <source>nothing can be served at %1: another program has this port; name another one, or 0 for any that is free</source>
        <translation>no se puede servir nada en %1: otro programa tiene este puerto; indique otro, o 0 para cualquiera que esté libre</translation>
    </message>
    <message>
        <source>nothing can be served at %1: this program has no right to it; name a port from 1024 on</source>
        <translation>no se puede servir nada en %1: este programa no tiene permiso; indique un puerto desde 1024</translation>
    </message>
    <message>
        <source>nothing can be served at %1: this machine has no such address; 127.0.0.1 is for itself alone, 0.0.0.0 for all that reach it</source>
        <translation>no se puede servir nada en %1: esta máquina no tiene tal dirección; 127.0.0.1 es para ella sola, 0.0.0.0 para todos los que la alcancen</translation>
    </message>
    <message>
        <source>nothing can be served at %1: %2</source>
        <translation>no se puede servir nada en %1: %2</translation>
    </message>
    <message>
        <source>nothing can be served at %1: there is no host of this name; 127.0.0.1 is this machine for itself alone, 0.0.0.0 for all that reach it</source>
        <translation>no se puede servir nada en %1: no hay ninguna máquina con este nombre; 127.0.0.1 es esta máquina para ella sola, 0.0.0.0 para todos los que la alcancen</translation>
    </message>
    <message>
        <source>the server says nothing</source>
        <translation>el servidor no dice nada</translation>
    </message>
    <message>
        <source>is there already, and may be what another run received; say --replace to receive in its place, or another name with --received</source>
        <translation>ya está ahí, y puede ser lo que recibió otra ejecución; diga --replace para recibir en su lugar, u otro nombre con --received</translation>
    </message>
    <message>
        <source>has been renamed, removed or replaced while it was followed; what was opened first is what counts, and is not under this name any more</source>
        <translation>se ha renombrado, borrado o sustituido mientras se seguía; cuenta el que se abrió primero, que ya no está bajo este nombre</translation>
    </message>
    <message>
        <source>no laser (sensor_msgs/LaserScan) is offered yet; there are: %1</source>
        <translation>aún no se ofrece ningún láser (sensor_msgs/LaserScan); hay: %1</translation>
    </message>
    <message>
        <source>it ended before the first scan had come</source>
        <translation>terminó antes de que llegara el primer barrido</translation>
    </message>
    <message>
        <source>%1: a message of %2 bytes is passed over, and so is every one of more than %3; have the robot tell less at a time</source>
        <translation>%1: se pasa por alto un mensaje de %2 bytes, y también todos los de más de %3; haga que el robot envíe menos de una vez</translation>
    </message>
    <message>
        <source>nothing has come yet of the topics that are received; it is waited for: does the laser run?</source>
        <translation>aún no ha llegado nada de los temas que se reciben; se espera: ¿funciona el láser?</translation>
    </message>
    <message>
        <source>the server offers no topic yet; they are waited for: does what drives the robot run?</source>
        <translation>el servidor aún no ofrece ningún tema; se esperan: ¿está en marcha lo que mueve el robot?</translation>
    </message>
    <message>
        <source>%1; reading goes on at byte %2</source>
        <translation>%1; la lectura sigue en el byte %2</translation>
    </message>
    <message>
        <source>found a length of %1 bytes, within which other records stand</source>
        <translation>se encontró una longitud de %1 bytes, dentro de la cual hay otros registros</translation>
    </message>
    <message>
        <source>the record before is longer than can be: it takes in the end of the data, and leaves %1 bytes</source>
        <translation>el registro anterior es más largo de lo posible: abarca el final de los datos y deja %1 bytes</translation>
    </message>
    <message>
        <source>change %1 names scan %2 of the map, which is held (source.hold) and would have to get a key scan there; name scan %3, its key before that, or do not hold the map</source>
        <translation>el cambio %1 nombra el barrido %2 del mapa, que se mantiene (source.hold) y ahí tendría que recibir un barrido clave; nombre el barrido %3, su barrido clave anterior, o no mantenga el mapa</translation>
    </message>
    <message>
        <source>&quot;%1&quot; is of the map of %2, which stays as it is (source.hold): change it in that map&apos;s own run, or go on with the map without holding it</source>
        <translation>«%1» es del mapa de %2, que se queda como está (source.hold): cámbielo en la ejecución propia de ese mapa, o siga con el mapa sin mantenerlo</translation>
    </message>
    <message>
        <source>is a world; a world is simulated, not followed</source>
        <translation>es un mundo; un mundo se simula, no se sigue</translation>
    </message>
    <message>
        <source>nothing has come yet</source>
        <translation>todavía no ha llegado nada</translation>
    </message>
    <message>
        <source>record or play the tour once; of a log that goes back, make a log of each part, and go on with the map of the first</source>
        <translation>grabe o reproduzca el recorrido una sola vez; de un registro que vuelve atrás, haga un registro de cada parte, y continúe con el mapa de la primera</translation>
    </message>
    <message>
        <source>the graph cannot be written: &quot;%1&quot; would go on with %2, and numbers from -%3 to %3 are read; are its numbers metres and radians, and no edge false?</source>
        <translation>el grafo no se puede escribir: «%1» seguiría con %2, y se leen números de -%3 a %3; ¿son sus números metros y radianes, y no hay ninguna arista falsa?</translation>
    </message>
    <message>
        <source>the grid would have %1 x %2 cells, %3 m by %4 m, and %5 % of them are near anything that was seen; of more than %6 cells one in %7 has to be. Is an anchor, a place that is fixed or a reading far off? Else choose coarser cells (grid.resolution)</source>
        <translation>la rejilla tendría %1 x %2 celdas, %3 m por %4 m, y el %5 % de ellas está cerca de algo que se vio; de más de %6 celdas, una de cada %7 tiene que estarlo. ¿Queda lejos un ancla, un lugar fijado o una lectura? Si no, elija celdas más gruesas (grid.resolution)</translation>
    </message>
    <message>
        <source>is the address of a running robot, expected a log: hitos-cli run --follow maps what the robot sends, and keeps a log of it</source>
        <translation>es la dirección de un robot en marcha, se esperaba un registro: hitos-cli run --follow cartografía lo que envía el robot y guarda un registro de ello</translation>
    </message>
    <message>
        <source>is there already, of a run that was broken off; what it was to replace is %1. Say which of both is to stay by its name; --replace receives in the place of the first</source>
        <translation>ya existe, de una ejecución interrumpida; lo que iba a sustituir es %1. Diga con su nombre cuál de los dos ha de quedar; --replace recibe en lugar del primero</translation>
    </message>
    <message>
        <source>is being received into by another run; name another file, or end that one first</source>
        <translation>otra ejecución está recibiendo en él; indique otro archivo, o termine antes aquella</translation>
    </message>
    <message>
        <source>is no file that can be replaced; name another one</source>
        <translation>no es un archivo que se pueda sustituir; indique otro</translation>
    </message>
    <message>
        <source>the clock goes back, at %1 s by %2 s: a recording that was played again, or a clock that was set; scans behind that are taken to be of times that were, and lie anywhere (%3)</source>
        <translation>el reloj vuelve atrás, en el segundo %1 y %2 s: una grabación que se reprodujo otra vez, o un reloj que se puso en hora; los barridos que siguen se toman como de tiempos pasados, y quedan en cualquier parte (%3)</translation>
    </message>
    <message>
        <source>its time, %1 s, is out of line: that before it is of %2 s and that behind it of %3 s</source>
        <translation>su tiempo, %1 s, se sale de la serie: el anterior es de %2 s y el siguiente de %3 s</translation>
    </message>
    <message>
        <source>its time, %1 s, is out of line with its neighbour&apos;s, %2 s</source>
        <translation>su tiempo, %1 s, no concuerda con el de su vecino, %2 s</translation>
    </message>
    <message>
        <source>message %1</source>
        <translation>mensaje %1</translation>
    </message>
    <message>
        <source>line %1</source>
        <translation>línea %1</translation>
    </message>
    <message>
        <source>found &quot;%1&quot;, expected an address as ws://HOST:PORT, the port up to 65535</source>
        <translation>se encontró «%1» y se esperaba una dirección como ws://MÁQUINA:PUERTO, con el puerto hasta 65535</translation>
    </message>
    <message>
        <source>look at what stamps them: one clock, that is set before the first message</source>
        <translation>mire qué les pone el tiempo: un solo reloj, puesto en hora antes del primer mensaje</translation>
    </message>
    <message>
        <source>time runs backwards: %1 of %2 stamps are before the one ahead of them in the log; where the robot was at a scan is not known</source>
        <translation>el tiempo corre hacia atrás: %1 de %2 tiempos son anteriores al que los precede en el registro; no se sabe dónde estaba el robot en cada barrido</translation>
    </message>
    <message>
        <source>the clock leaps ahead, at %1 s by %2 days (%3): a clock that was set, or two logs in one; scans and odometry behind that may be of two times</source>
        <translation>el reloj salta adelante, en el segundo %1 y %2 días (%3): un reloj que se puso en hora, o dos registros en uno; los barridos y la odometría que siguen pueden ser de dos tiempos</translation>
    </message>
    <message>
        <source>by their stamps %1 s pass from scan to scan, as where they are not of seconds; how fast the robot drives is not known</source>
        <translation>según sus tiempos pasan %1 s de barrido a barrido, como si no fueran segundos; no se sabe a qué velocidad va el robot</translation>
    </message>
    <message>
        <source>write stamps in seconds</source>
        <translation>escriba los tiempos en segundos</translation>
    </message>
    <message>
        <source>%1 of %2 %3 are stamped out of line with those before and behind them, and left out: stamps that were never set, or of two clocks in turn</source>
        <translation>%1 de %2 %3 tienen un tiempo que no concuerda con los de sus vecinos y se dejan fuera: tiempos que nunca se pusieron, o de dos relojes por turnos</translation>
    </message>
    <message>
        <source>scans</source>
        <translation>barridos</translation>
    </message>
    <message>
        <source>odometry readings</source>
        <translation>lecturas de odometría</translation>
    </message>
    <message>
        <source>change %1 is of another tour: scan %2 was another one when it was made, of the same time; where it is the same in another format, take the &quot;~%3&quot; out</source>
        <translation>el cambio %1 es de otro recorrido: el barrido %2 era otro cuando se hizo, del mismo tiempo; si es el mismo en otro formato, quite el «~%3»</translation>
    </message>
    <message>
        <source>%1 of %2 scans lie beyond what a grid can hold (%3 million cells); one of %4 m a cell holds them all (grid.resolution)</source>
        <translation>%1 de %2 barridos quedan fuera de lo que cabe en una rejilla (%3 millones de celdas); en una de %4 m por celda caben todos (grid.resolution)</translation>
    </message>
    <message>
        <source>%1 % of the readings are %2 m, the greatest of all and three times as many as of any distance near it, as where a driver says that nothing was seen: they are taken for walls, which go with the robot</source>
        <translation>El %1 % de las lecturas son de %2 m, la mayor de todas y tres veces tantas como de cualquier distancia cercana, como donde un controlador dice que no se vio nada: se toman por paredes, que van con el robot</translation>
    </message>
    <message>
        <source>leave them out</source>
        <translation>déjelas fuera</translation>
    </message>
    <message>
        <source>another source is being opened; try again when it is there</source>
        <translation>se está abriendo otra fuente; vuelva a intentarlo cuando esté</translation>
    </message>
    <message>
        <source>holds the results of a tour whose scan %1 has the stamp %2 s, and in its log %3 that has %4 s: the log has changed; run it again</source>
        <translation>contiene los resultados de un recorrido cuyo barrido %1 tiene la marca de tiempo %2 s, y en su registro %3 esa es %4 s: el registro ha cambiado; ejecútelo de nuevo</translation>
    </message>
    <message>
        <source>is UTF-16 text; save it as UTF-8</source>
        <translation>es texto UTF-16; guárdelo como UTF-8</translation>
    </message>
    <message>
        <source>seconds, below 1e12 (nanoseconds divided by 1e9)</source>
        <translation>segundos, por debajo de 1e12 (los nanosegundos, divididos entre 1e9)</translation>
    </message>
    <message>
        <source>two numbers for each, without an intensity</source>
        <translation>dos números para cada una, sin intensidad</translation>
    </message>
    <message>
        <source>the bearings in the place of the ranges</source>
        <translation>los ángulos en el lugar de las distancias</translation>
    </message>
    <message>
        <source>readings: found %1, expected range bearing intensity for each</source>
        <translation>lecturas: se encontraron %1; se esperaba range bearing intensity para cada una</translation>
    </message>
    <message>
        <source>it is UTF-16 text; save it as UTF-8</source>
        <translation>es texto UTF-16; guárdelo como UTF-8</translation>
    </message>
    <message>
        <source>no line is one of a format that Hitos reads, but would be with blanks in the place of %1; the first is &quot;%2&quot;</source>
        <translation>ninguna línea es de un formato que Hitos lea, pero lo sería con espacios en el lugar de %1; la primera es «%2»</translation>
    </message>
    <message>
        <source>no line is one of a format that Hitos reads, but would be with its name in capital letters; the first is &quot;%1&quot;</source>
        <translation>ninguna línea es de un formato que Hitos lea, pero lo sería con su nombre en mayúsculas; la primera es «%1»</translation>
    </message>
    <message>
        <source>has lines that end with CR alone, as old Macs wrote them; expected LF or CR LF, as tr &apos;\r&apos; &apos;\n&apos; makes of them</source>
        <translation>tiene líneas que acaban solo en CR, como las escribían los Mac antiguos; se esperaba LF o CR LF, como las deja tr &apos;\r&apos; &apos;\n&apos;</translation>
    </message>
    <message>
        <source>found %1, with a decimal comma; expected a decimal point</source>
        <translation>se encontró %1, con coma decimal; se esperaba un punto decimal</translation>
    </message>
    <message>
        <source>%1 % of the readings lie beyond the greatest range of %2 m that the log states, where they go on from ray to ray as walls do, and are no points</source>
        <translation>El %1 % de las lecturas está más allá del alcance mayor de %2 m que dice el registro, donde siguen de rayo en rayo como lo hacen las paredes, y no son puntos</translation>
    </message>
    <message>
        <source>take them</source>
        <translation>tomarlas</translation>
    </message>
    <message>
        <source>%1 % of the readings of %2 lie beyond the greatest range of %3 m that it says, where they go on from ray to ray as walls do, and are no points</source>
        <translation>El %1 % de las lecturas de %2 está más allá del alcance mayor de %3 m que dice, donde siguen de rayo en rayo como lo hacen las paredes, y no son puntos</translation>
    </message>
    <message>
        <source>its positions fit the scans, so that its times are no seconds: record them in seconds</source>
        <translation>sus posiciones encajan con los barridos, de modo que sus tiempos no son segundos: grábense en segundos</translation>
    </message>
    <message>
        <source>by %1 % of the odometry readings the robot turns at some %2 degrees/s, which none of its kind does, and the scans do not lie where that puts them</source>
        <translation>según el %1 % de las lecturas de la odometría el robot gira a unos %2 grados/s, lo que ninguno de su clase hace, y los barridos no están donde eso los pone</translation>
    </message>
    <message>
        <source>if its turns are %1</source>
        <translation>si sus giros son %1</translation>
    </message>
    <message>
        <source>degrees</source>
        <translation>grados</translation>
    </message>
    <message>
        <source>between second %1 and %2 of the tour the scans move by %3 m or more while the odometry at most turns, as where wheels slip or the robot is pushed: the map is pushed together there</source>
        <translation>entre los segundos %1 y %2 del recorrido los barridos se mueven %3 m o más mientras que la odometría a lo sumo gira, como donde patinan las ruedas o se empuja al robot: ahí se encoge el mapa</translation>
    </message>
    <message>
        <source>%1 % of the readings are the greatest of their ray, %2 to %3 m, which it has over and over, as where a driver says that nothing was seen: they are taken for walls, which go with the robot</source>
        <translation>El %1 % de las lecturas es la mayor de su rayo, de %2 a %3 m, que este repite una y otra vez, como donde un controlador dice que no se vio nada: se toman por paredes, que van con el robot</translation>
    </message>
    <message>
        <source>left</source>
        <translation>izquierda</translation>
    </message>
    <message>
        <source>right</source>
        <translation>derecha</translation>
    </message>
    <message>
        <source>by the scans the odometry&apos;s heading drifts to the %2 by %1 degrees a second (%3 % of their points fit so, %4 % as it is told), as of a gyro whose zero is off: the path is bent</source>
        <translation>según los barridos el rumbo de la odometría deriva hacia la %2 %1 grados por segundo (el %3 % de sus puntos encaja así, el %4 % tal como se dice), como de un giróscopo cuyo cero no está bien: el camino se dobla</translation>
    </message>
    <message>
        <source>by the scans the odometry&apos;s heading drifts to the %2 by %1 degrees a metre (%3 % of their points fit so, %4 % as it is told), as of wheels that are not of one size: the path is bent</source>
        <translation>según los barridos el rumbo de la odometría deriva hacia la %2 %1 grados por metro (el %3 % de sus puntos encaja así, el %4 % tal como se dice), como de ruedas que no son de un mismo tamaño: el camino se dobla</translation>
    </message>
    <message>
        <source>is too short for copy %1, which leaves out the first %2 scans; ask for fewer copies</source>
        <translation>es demasiado corto para la copia %1, que omite los %2 primeros barridos; pida menos copias</translation>
    </message>
    <message>
        <source>the odometry stands still while the robot turns, for up to %1 s, and makes up for it in one step, of up to %2 degrees (line %3), %4 in all; scans of that time lie on each other</source>
        <translation>la odometría se queda quieta mientras el robot gira, hasta %1 s, y lo recupera en un solo paso, de hasta %2 grados (línea %3), %4 en total; los barridos de ese tiempo quedan unos sobre otros</translation>
    </message>
    <message>
        <source>as where a heading was written into z</source>
        <translation>como cuando en z se escribió un rumbo</translation>
    </message>
    <message>
        <source>as where nobody divided by it</source>
        <translation>como cuando nadie dividió por ella</translation>
    </message>
    <message>
        <source>as where angles were written into it, or its four numbers are not of one turn</source>
        <translation>como cuando se escribieron ángulos en él, o sus cuatro números no son de un mismo giro</translation>
    </message>
    <message>
        <source>the orientation of %1 of %2 %3 is no quaternion of length 1 (of length %4 in message %5), %6</source>
        <translation>la orientación de %1 de %2 %3 no es un cuaternión de longitud 1 (de longitud %4 en el mensaje %5), %6</translation>
    </message>
    <message>
        <source>let its program write (0, 0, sin, cos) of half the heading</source>
        <translation>que su programa escriba (0, 0, sen, cos) de la mitad del rumbo</translation>
    </message>
    <message>
        <source>transforms</source>
        <translation>transformaciones</translation>
    </message>
    <message>
        <source>let its program write (0, 0, sin, cos) of half the turn, or say where the laser sits: --laser-pose x,y,degrees</source>
        <translation>que su programa escriba (0, 0, sen, cos) de la mitad del giro, o diga dónde está el láser: --laser-pose x,y,grados</translation>
    </message>
    <message>
        <source>look what they are: intensities, or of another unit</source>
        <translation>mire qué son: intensidades, o de otra unidad</translation>
    </message>
    <message>
        <source>by the odometry the robot mostly drives at %1 m/s, which none of its kind does, and half of the readings are beyond %2 m: both are no metres</source>
        <translation>según la odometría el robot va casi siempre a %1 m/s, como no va ninguno de su clase, y la mitad de las lecturas están más allá de %2 m: ni lo uno ni lo otro son metros</translation>
    </message>
    <message>
        <source>say where it sits: --laser-pose</source>
        <translation>diga dónde está: --laser-pose</translation>
    </message>
    <message>
        <source>so the scans fit the odometry better</source>
        <translation>así los barridos encajan mejor con la odometría</translation>
    </message>
    <message>
        <source>the laser is said to sit %1 m from the robot&apos;s middle, farther than a robot is large: walls go round in circles where it turns</source>
        <translation>se dice que el láser está a %1 m del centro del robot, más lejos de lo que mide un robot: las paredes dan vueltas donde gira</translation>
    </message>
    <message>
        <source>decimetres</source>
        <translation>decímetros</translation>
    </message>
    <message>
        <source>for %1 s there is no scan (line %2), while the robot drives to %3 m from where it was: how the map goes on there is the odometry&apos;s word alone</source>
        <translation>durante %1 s no hay ningún barrido (línea %2), mientras el robot va hasta %3 m de donde estaba: cómo sigue el mapa allí lo dice solo la odometría</translation>
    </message>
    <message>
        <source>for %1 s there is no scan, and what is seen then (line %2) is not what was seen before, though by the odometry it is %3 m from there: %4 % of its points fit; the map goes on at a wrong place until that is recognised</source>
        <translation>durante %1 s no hay ningún barrido, y lo que se ve después (línea %2) no es lo que se veía antes, aunque según la odometría está a %3 m de allí: encaja el %4 % de sus puntos; el mapa sigue en un sitio equivocado hasta que eso se reconoce</translation>
    </message>
    <message>
        <source>if the robot was carried, cut the log at that line, and map the second part with the map of the first</source>
        <translation>si alguien llevó el robot en brazos, corte el registro en esa línea y haga el mapa de la segunda parte con el de la primera</translation>
    </message>
    <message>
        <source>holds %1, which is of no study and would be written over; move it away or choose another folder</source>
        <translation>contiene %1, que no es de ningún estudio y se sobrescribiría; llévelo a otro sitio o elija otra carpeta</translation>
    </message>
    <message>
        <source>This is the tour that the map of %1 was made of: laid on itself it brings the map nothing new, and that it fits tells nothing.</source>
        <translation>Este es el recorrido del que se hizo el mapa de %1: puesto sobre sí mismo no aporta nada nuevo al mapa, y que encaje no dice nada.</translation>
    </message>
    <message>
        <source>origin: found a yaw of %1, which is more than a turn in radians; if it is in degrees, write %2</source>
        <translation>origin: se encontró un giro de %1, que es más de una vuelta en radianes; si está en grados, escriba %2</translation>
    </message>
    <message>
        <source>%1 stands in line %2 already; leave one of them out</source>
        <translation>%1 está ya en la línea %2; quite una de las dos</translation>
    </message>
    <message>
        <source>occupied_thresh: found %1, expected more than free_thresh, which is %2 in line %3; are they the wrong way round?</source>
        <translation>occupied_thresh: se encontró %1, se esperaba más que free_thresh, que es %2 en la línea %3; ¿están al revés?</translation>
    </message>
    <message>
        <source>the file has no negate, which may be wrong: by it %1 of the picture is free ground, with negate: %2 it would be %3</source>
        <translation>el archivo no tiene negate, lo que puede estar mal: así el %1 de la imagen es suelo libre, con negate: %2 sería el %3</translation>
    </message>
    <message>
        <source>negate in line %1 may be the wrong way round: by it %2 of the picture is free ground, with negate: %3 it would be %4</source>
        <translation>negate, en la línea %1, puede estar al revés: con él el %2 de la imagen es suelo libre, con negate: %3 sería el %4</translation>
    </message>
    <message>
        <source>closed door %1, (%2, %3) to (%4, %5), which an event { at = 0, open = %1 } would open</source>
        <translation>la puerta cerrada %1, de (%2, %3) a (%4, %5), que abriría un suceso { at = 0, open = %1 }</translation>
    </message>
    <message>
        <source>is of ROS recordings, and %1 is none; leave it out</source>
        <translation>es de grabaciones de ROS, y %1 no es ninguna; quítela</translation>
    </message>
    <message>
        <source>is of worlds, which are simulated, and %1 is none; leave it out</source>
        <translation>es de mundos, que se simulan, y %1 no es ninguno; quítela</translation>
    </message>
    <message>
        <source>found %1, and a comma is a decimal one here, while these are whole numbers; part values by semicolons or blanks</source>
        <translation>se encontró %1, y aquí la coma es decimal, pero estos son números enteros; separe los valores con puntos y comas o espacios</translation>
    </message>
    <message>
        <source>%1 scans show another place than those before and behind them, which are alike (%2 are): two lasers, or two robots, under one name; the map is of both</source>
        <translation>%1 barridos muestran otro lugar que los de antes y después, que se parecen entre sí (lo hacen %2): dos láseres, o dos robots, con un mismo nombre; el mapa es de ambos</translation>
    </message>
    <message>
        <source>record each laser under a name of its own</source>
        <translation>grabe cada láser con un nombre propio</translation>
    </message>
    <message>
        <source>the readings go in steps of %1 m, and walls are no better known than that; no scan lies on another by them</source>
        <translation>las lecturas van en pasos de %1 m, y las paredes no se conocen mejor que eso; con ellas ningún barrido se ajusta a otro</translation>
    </message>
    <message>
        <source>record them with the digits that the laser gives</source>
        <translation>grábelas con las cifras que da el láser</translation>
    </message>
    <message>
        <source>a quarter of the scans do not lie on the ones before by any motion (at best %1 % of their points do): rays in another order than is said, readings that are none, or scans of another laser among them; the odometry cannot be judged by them</source>
        <translation>una cuarta parte de los barridos no se ajusta a los anteriores con ningún movimiento (como mucho lo hace el %1 % de sus puntos): rayos en otro orden que el que se dice, lecturas que no lo son, o barridos de otro láser entre ellos; la odometría no se puede juzgar con ellos</translation>
    </message>
    <message>
        <source>look at what wrote the scans</source>
        <translation>mire qué escribió los barridos</translation>
    </message>
    <message>
        <source>mend what tells it, and record again: the scans alone do not show enough of how it moved</source>
        <translation>arregle lo que la da y grabe de nuevo: los barridos solos no muestran lo bastante de cómo se movió</translation>
    </message>
    <message>
        <source>%1 rays read the same distance all the time, %2 m and more, however the robot turns: they are stuck, and draw walls that are not there</source>
        <translation>%1 rayos leen siempre la misma distancia, %2 m o más, gire como gire el robot: están atascados, y dibujan paredes que no existen</translation>
    </message>
    <message>
        <source>leave these rays out of the log, or record it with a laser that is whole</source>
        <translation>deje esos rayos fuera del registro, o grábelo con un láser que esté entero</translation>
    </message>
</context>
<context>
    <name>Finding</name>
    <message>
        <source>“%1” %2</source>
        <translation>«%1» %2</translation>
    </message>
</context>
<context>
    <name>FullLabel</name>
    <message>
        <source>Number of particles</source>
        <translation>Número de partículas</translation>
    </message>
    <message>
        <source>Kind of features</source>
        <translation>Tipo de características</translation>
    </message>
    <message>
        <source>Probability of a new observation</source>
        <translation>Probabilidad de una nueva observación</translation>
    </message>
    <message>
        <source>Least number of points in a line</source>
        <translation>Mínimo número de puntos en una recta</translation>
    </message>
    <message>
        <source>Greatest distance to the line</source>
        <translation>Máxima distancia a la recta</translation>
    </message>
    <message>
        <source>Least length of a line</source>
        <translation>Mínima longitud de una recta</translation>
    </message>
    <message>
        <source>Model of the robot</source>
        <translation>Modelo del robot</translation>
    </message>
    <message>
        <source>Kind of resampler</source>
        <translation>Tipo de remuestreador</translation>
    </message>
    <message>
        <source>Number of effective particles</source>
        <translation>Número de partículas efectivas</translation>
    </message>
</context>
<context>
    <name>Landmarks</name>
    <message>
        <source>Line %1</source>
        <translation>Recta %1</translation>
    </message>
    <message>
        <source>Corner %1</source>
        <translation>Esquina %1</translation>
    </message>
    <message>
        <source>Observed %1 times</source>
        <translation>Observaciones: %1</translation>
    </message>
    <message>
        <source>Landmark %1</source>
        <translation>Hito %1</translation>
    </message>
    <message>
        <source>Observed once</source>
        <translation>Observado una vez</translation>
    </message>
</context>
<context>
    <name>Language</name>
    <message>
        <source>As the system</source>
        <translation>Como el sistema</translation>
    </message>
    <message>
        <source>The language changes when Hitos starts again.</source>
        <translation>El idioma cambia cuando Hitos se inicia de nuevo.</translation>
    </message>
    <message>
        <source>en</source>
        <comment>the code of the language that the window speaks</comment>
        <translation>es</translation>
    </message>
</context>
<context>
    <name>Layers</name>
    <message>
        <source>Scan points</source>
        <translation>Puntos del barrido</translation>
    </message>
    <message>
        <source>Detected features</source>
        <translation>Características detectadas</translation>
    </message>
    <message>
        <source>Particle cloud</source>
        <translation>Nube de partículas</translation>
    </message>
    <message>
        <source>Landmarks</source>
        <translation>Hitos</translation>
    </message>
    <message>
        <source>Uncertainty (1, 2, 3 σ)</source>
        <translation>Incertidumbre (1, 2, 3 σ)</translation>
    </message>
    <message>
        <source>Lines without end</source>
        <translation>Rectas sin fin</translation>
    </message>
    <message>
        <source>Associations</source>
        <translation>Asociaciones</translation>
    </message>
    <message>
        <source>Robot</source>
        <translation>Robot</translation>
    </message>
    <message>
        <source>Best particle&apos;s path</source>
        <translation>Camino de la mejor partícula</translation>
    </message>
    <message>
        <source>Odometry path</source>
        <translation>Camino de la odometría</translation>
    </message>
    <message>
        <source>Path while driving</source>
        <translation>Camino durante el recorrido</translation>
    </message>
    <message>
        <source>Key scans and loops</source>
        <translation>Barridos clave y bucles</translation>
    </message>
    <message>
        <source>Reference</source>
        <translation>Referencia</translation>
    </message>
    <message>
        <source>Landmark numbers</source>
        <translation>Números de los hitos</translation>
    </message>
    <message>
        <source>Particles&apos; ancestry</source>
        <translation>Ascendencia de las partículas</translation>
    </message>
    <message>
        <source>Path</source>
        <translation>Camino</translation>
    </message>
    <message>
        <source>Where the laser&apos;s rays of the last scan ended</source>
        <translation>Dónde acabaron los rayos del láser en el último barrido</translation>
    </message>
    <message>
        <source>Lines and corners that were found in the last scan</source>
        <translation>Rectas y esquinas encontradas en el último barrido</translation>
    </message>
    <message>
        <source>Where each particle believes that the robot is; the heavier, the stronger its colour</source>
        <translation>Dónde cree cada partícula que está el robot; cuanto más pesa, más intenso su color</translation>
    </message>
    <message>
        <source>The map&apos;s lines, as far as they were seen, and its corners</source>
        <translation>Las rectas del mapa, hasta donde se vieron, y sus esquinas</translation>
    </message>
    <message>
        <source>How well landmarks and the robot&apos;s place are known: bands and ellipses of one, two and three standard deviations</source>
        <translation>Con qué precisión se conocen los hitos y el lugar del robot: franjas y elipses de una, dos y tres desviaciones típicas</translation>
    </message>
    <message>
        <source>The map&apos;s lines as the filter has them: without ends</source>
        <translation>Las rectas del mapa como las tiene el filtro: sin extremos</translation>
    </message>
    <message>
        <source>From each feature to the landmark that it was taken for; a ring with a cross is a new landmark, a grey cross was left out</source>
        <translation>De cada característica al hito por el que se tomó; un círculo con cruz es un hito nuevo, una cruz gris se dejó fuera</translation>
    </message>
    <message>
        <source>Where the robot is by the map</source>
        <translation>Dónde está el robot según el mapa</translation>
    </message>
    <message>
        <source>The way that the robot went, as the map has it now</source>
        <translation>El camino que siguió el robot, como lo tiene ahora el mapa</translation>
    </message>
    <message>
        <source>The way by the odometry alone</source>
        <translation>El camino según la odometría sola</translation>
    </message>
    <message>
        <source>The way as it was thought to be at each scan, before anything later corrected it</source>
        <translation>El camino como se creía en cada barrido, antes de que nada posterior lo corrigiera</translation>
    </message>
    <message>
        <source>The scans that registration keeps, and lines between those that a closed loop joins</source>
        <translation>Los barridos que conserva la alineación, y líneas entre los que une un bucle cerrado</translation>
    </message>
    <message>
        <source>Their numbers, as tables and files have them</source>
        <translation>Sus números, como los tienen tablas y archivos</translation>
    </message>
    <message>
        <source>From where the particles of now come: paths of all, which are one where resampling left one ancestor</source>
        <translation>De dónde vienen las partículas de ahora: los caminos de todas, que son uno donde el remuestreo dejó un solo antepasado</translation>
    </message>
    <message>
        <source>The map and the path that this run is compared with, and the drawing that it is anchored to</source>
        <translation>El mapa y el camino con los que se compara esta ejecución, y el dibujo al que está anclada</translation>
    </message>
</context>
<context>
    <name>LoopVerdict</name>
    <message>
        <source>Closed</source>
        <translation>Cerrado</translation>
    </message>
    <message>
        <source>Fits badly</source>
        <translation>Encaja mal</translation>
    </message>
    <message>
        <source>Corridor</source>
        <translation>Pasillo</translation>
    </message>
    <message>
        <source>Looked through</source>
        <translation>Visto a través</translation>
    </message>
    <message>
        <source>Said once</source>
        <translation>Dicho una vez</translation>
    </message>
    <message>
        <source>No edge</source>
        <translation>Sin arista</translation>
    </message>
    <message>
        <source>Bends the graph</source>
        <translation>Dobla el grafo</translation>
    </message>
    <message>
        <source>Refused by hand</source>
        <translation>Rechazado a mano</translation>
    </message>
</context>
<context>
    <name>Measure</name>
    <message>
        <source>map error</source>
        <translation>error del mapa</translation>
    </message>
    <message>
        <source>trajectory error</source>
        <translation>error del recorrido</translation>
    </message>
    <message>
        <source>blur of the grid map</source>
        <translation>borrosidad del mapa de rejilla</translation>
    </message>
    <message>
        <source>landmarks</source>
        <translation>hitos</translation>
    </message>
    <message>
        <source>relative error in 10 m</source>
        <translation>error relativo en 10 m</translation>
    </message>
    <message>
        <source>true poses in the region of 95 %</source>
        <translation>poses verdaderas en la región del 95 %</translation>
    </message>
    <message>
        <source>true landmarks in the region of 95 %</source>
        <translation>hitos verdaderos en la región del 95 %</translation>
    </message>
    <message>
        <source>true distances in the region of 95 %</source>
        <translation>distancias verdaderas en la región del 95 %</translation>
    </message>
</context>
<context>
    <name>Parameter</name>
    <message>
        <source>Readings at or beyond this range are no points, so a higher value keeps more far readings; 0 takes what the log says.</source>
        <translation>Las lecturas a esta distancia o más lejos no son puntos: un valor mayor conserva más lecturas lejanas; 0 toma lo que dice el registro.</translation>
    </message>
    <message>
        <source>Number of particles M; more of them follow more hypotheses, and time and memory grow in proportion.</source>
        <translation>Número de partículas M; con más se siguen más hipótesis, y el tiempo y la memoria crecen en proporción.</translation>
    </message>
    <message>
        <source>Likelihood P0 of a new landmark; a higher value makes new landmarks more readily.</source>
        <translation>Similitud P0 de un hito nuevo; con un valor mayor se crean hitos con más facilidad.</translation>
    </message>
    <message>
        <source>What an observation that fits several landmarks, and is kept out of the map, does to the weight: keep-likelihood multiplies it with the best likelihood, neutral leaves it, new-landmark multiplies it with p0; off updates the best landmark instead.</source>
        <translation>Qué hace con el peso una observación que encaja con varios hitos y queda fuera del mapa: multiplicarlo por la mejor similitud, dejarlo igual o multiplicarlo por P0 como un hito nuevo; con «No», actualiza el mejor hito.</translation>
    </message>
    <message>
        <source>Proportional noise: variance along the motion per metre; a higher value trusts the measured distance less.</source>
        <translation>Ruido proporcional: varianza a lo largo del movimiento por metro; con un valor mayor se confía menos en la distancia medida.</translation>
    </message>
    <message>
        <source>Proportional noise: variance across the motion per metre; a higher value allows more sideways slip.</source>
        <translation>Ruido proporcional: varianza de través al movimiento por metro; un valor mayor admite más deslizamiento lateral.</translation>
    </message>
    <message>
        <source>Proportional noise: variance of the heading per radian turned; a higher value trusts measured turns less.</source>
        <translation>Ruido proporcional: varianza de la orientación por radián girado; con un valor mayor se confía menos en los giros medidos.</translation>
    </message>
    <message>
        <source>Proportional noise: variance of the heading per metre driven; a higher value allows more drift of the heading on straight ways.</source>
        <translation>Ruido proporcional: varianza de la orientación por metro recorrido; un valor mayor admite más deriva de la orientación en las rectas.</translation>
    </message>
    <message>
        <source>Variance sigma^2 of the observed rho of a line or range of a corner; a higher value trusts the laser less and accepts greater differences from a landmark.</source>
        <translation>Varianza sigma² de la rho observada de una recta o de la distancia a una esquina; con un valor mayor se confía menos en el láser y se aceptan diferencias mayores con un hito.</translation>
    </message>
    <message>
        <source>Variance sigma^2 of the observed theta of a line or bearing of a corner; a higher value trusts the laser less and accepts greater differences from a landmark.</source>
        <translation>Varianza sigma² de la theta observada de una recta o del ángulo de una esquina; con un valor mayor se confía menos en el láser y se aceptan diferencias mayores con un hito.</translation>
    </message>
    <message>
        <source>How sure an observation is: fixed takes var_rho and var_theta for all; points computes the covariance of each line and corner from the points that support it.</source>
        <translation>Cuán segura es una observación: fixed toma var_rho y var_theta para todas; points calcula la covarianza de cada recta y esquina a partir de los puntos que la sostienen.</translation>
    </message>
    <message>
        <source>What is looked for in a scan: lines, corners where two lines meet, or both.</source>
        <translation>Qué se busca en un barrido: rectas, esquinas donde se cortan dos rectas, o ambas.</translation>
    </message>
    <message>
        <source>Greatest distance Es of a corner from the nearest point of each of its lines; a higher value accepts corners that were seen less closely.</source>
        <translation>Distancia máxima Es de una esquina al punto más próximo de cada una de sus rectas; un valor mayor acepta esquinas vistas con menos detalle.</translation>
    </message>
    <message>
        <source>Greatest distance Dmax of a point from its line; a higher value makes fewer and rougher lines.</source>
        <translation>Distancia máxima Dmax de un punto a su recta; un valor mayor da menos rectas y más toscas.</translation>
    </message>
    <message>
        <source>Shortest line Lmin; a higher value drops more short lines.</source>
        <translation>Longitud mínima Lmin de una recta; un valor mayor descarta más rectas cortas.</translation>
    </message>
    <message>
        <source>Fewest points Pmin of a line; a higher value drops more lines that are short or far.</source>
        <translation>Número mínimo Pmin de puntos de una recta; un valor mayor descarta más rectas cortas o lejanas.</translation>
    </message>
    <message>
        <source>How an accepted line is fitted: through its first and last point, or by total least squares over all its points.</source>
        <translation>Cómo se ajusta una recta aceptada: por su primer y último punto, o por mínimos cuadrados totales sobre todos sus puntos.</translation>
    </message>
    <message>
        <source>Lines whose rho differs by less than this are merged if their theta is near too; a higher value merges more.</source>
        <translation>Las rectas cuya rho difiere en menos se funden si su theta también es próxima; un valor mayor funde más.</translation>
    </message>
    <message>
        <source>Lines whose theta differs by less than this are merged if their rho is near too; a higher value merges more.</source>
        <translation>Las rectas cuya theta difiere en menos se funden si su rho también es próxima; un valor mayor funde más.</translation>
    </message>
    <message>
        <source>Lines are merged only where they are less than this apart, so a higher value merges more; 0 merges over any distance.</source>
        <translation>Las rectas solo se funden si distan menos que esto, así que un valor mayor funde más; 0 las funde a cualquier distancia.</translation>
    </message>
    <message>
        <source>Neighbouring points further apart than gap + gap_per_range * range never share a line, so a higher value lets lines cross wider gaps; both 0 allow any gap.</source>
        <translation>Los puntos vecinos que distan más que hueco + hueco_por_distancia × distancia nunca comparten recta, así que un valor mayor deja que las rectas crucen huecos más anchos; con ambos a 0 vale cualquier hueco.</translation>
    </message>
    <message>
        <source>How much the gap allowed between neighbours grows with their range; a higher value lets far lines cross wider gaps.</source>
        <translation>Cuánto crece con la distancia el hueco permitido entre vecinos; un valor mayor deja que las rectas lejanas crucen huecos más anchos.</translation>
    </message>
    <message>
        <source>Ranges of neighbours that differ by more than edge + edge_per_range * range end a run; a higher value makes longer runs.</source>
        <translation>Las distancias de vecinos que difieren más que borde + borde_por_distancia × distancia cortan la serie; un valor mayor hace series más largas.</translation>
    </message>
    <message>
        <source>How much the difference allowed between neighbours grows with their range; a higher value lets walls run on that are seen at a flat angle.</source>
        <translation>Cuánto crece con la distancia la diferencia permitida entre vecinos; un valor mayor deja seguir las paredes vistas casi de perfil.</translation>
    </message>
    <message>
        <source>Greatest distance of a point that agrees with a line; a higher value makes fewer and rougher lines.</source>
        <translation>Mayor distancia de un punto que concuerda con una recta; un valor mayor da menos rectas y más toscas.</translation>
    </message>
    <message>
        <source>Most hypotheses tried for one line; a higher value finds lines among more stray points and takes longer.</source>
        <translation>Máximo de hipótesis probadas por recta; un valor mayor halla rectas entre más puntos espurios y tarda más.</translation>
    </message>
    <message>
        <source>When particles are drawn anew: after every step that observed something, or only where Neff has fallen below its threshold.</source>
        <translation>Cuándo se remuestrean las partículas: tras cada paso que observó algo, o solo cuando Neff ha caído por debajo de su umbral.</translation>
    </message>
    <message>
        <source>Effective number of particles Neff below which the rule neff resamples; a higher value resamples more often.</source>
        <translation>Número efectivo de partículas Neff por debajo del cual se remuestrea; con un valor mayor se remuestrea más a menudo.</translation>
    </message>
    <message>
        <source>Side of a cell of the occupancy grid; a higher value makes a coarser and faster map.</source>
        <translation>Lado de una celda de la rejilla de ocupación; un valor mayor da un mapa más tosco y más rápido.</translation>
    </message>
    <message>
        <source>Added to the cell that a ray ends in; a higher value makes walls appear sooner.</source>
        <translation>Se suma a la celda en que acaba un rayo; con un valor mayor las paredes aparecen antes.</translation>
    </message>
    <message>
        <source>Added to every cell that a ray passes; a value nearer to 0 clears free space more slowly.</source>
        <translation>Se suma a cada celda que atraviesa un rayo; con un valor más cercano a 0 el espacio libre se despeja más despacio.</translation>
    </message>
    <message>
        <source>Greatest absolute value of a cell; a higher value makes a sure cell slower to change again.</source>
        <translation>Mayor valor absoluto de una celda; con un valor mayor una celda segura tarda más en volver a cambiar.</translation>
    </message>
    <message>
        <source>Rays are drawn up to this length, so a higher value draws more of the far readings; 0 draws them whole.</source>
        <translation>Los rayos se dibujan hasta esta longitud, así que un valor mayor dibuja más de las lecturas lejanas; 0 los dibuja enteros.</translation>
    </message>
    <message>
        <source>Seed of all random numbers; the same seed gives the same result to the last bit.</source>
        <translation>Semilla de todos los números aleatorios; la misma semilla da el mismo resultado hasta el último bit.</translation>
    </message>
    <message>
        <source>Number of threads, which changes the time and never the result; 0 uses as many as the machine has.</source>
        <translation>Número de hilos, que cambia el tiempo y nunca el resultado; 0 usa todos los de la máquina.</translation>
    </message>
    <message>
        <source>%1 to %2 %3</source>
        <translation>de %1 a %2 %3</translation>
    </message>
    <message>
        <source>How lines are found in a scan. Every method uses min_length, min_points and collinear_* of split_merge.</source>
        <translation>Cómo se encuentran las rectas en un barrido. Todos los métodos usan min_length, min_points y collinear_* de split_merge.</translation>
    </message>
    <message>
        <source>What builds the map of landmarks and the path.</source>
        <translation>Qué construye el mapa de hitos y la trayectoria.</translation>
    </message>
    <message>
        <source>Where particles draw their new poses from.</source>
        <translation>De dónde extraen las partículas sus nuevas poses.</translation>
    </message>
    <message>
        <source>How the robot moves between two scans, and how unsure that is.</source>
        <translation>Cómo se mueve el robot entre dos barridos y con cuánta incertidumbre.</translation>
    </message>
    <message>
        <source>How particles are drawn anew; every method gives a particle as many copies in the mean as its weight says, and they differ in how much chance adds.</source>
        <translation>Cómo se vuelven a extraer las partículas; con todos los métodos una partícula recibe en media tantas copias como dice su peso, y se distinguen en cuánto añade el azar.</translation>
    </message>
    <message>
        <source>Least angle between the lines of a corner, modulo pi; a higher value takes fewer bends for corners, among them those of a wall that noise has broken; 0 takes any, as the thesis does.</source>
        <translation>Ángulo mínimo entre las rectas de una esquina, módulo pi; un valor mayor toma menos quiebros por esquinas, entre ellos los de una pared que el ruido ha roto; 0 acepta cualquiera, como el proyecto.</translation>
    </message>
    <message>
        <source>Seed of the noise of a world&apos;s laser and odometry, so that runs with other seeds drive the same tour; 0 takes what the world says, else the run&apos;s seed.</source>
        <translation>Semilla del ruido del láser y de la odometría de un mundo, para que ejecuciones con otras semillas hagan el mismo recorrido; 0 toma la que dice el mundo o, si no, la de la ejecución.</translation>
    </message>
    <message>
        <source>What corners are the intersections of: the lines as they are detected, or least squares lines over all points of each, which differ where lines go through their end points.</source>
        <translation>De qué son intersección las esquinas: de las rectas tal como se detectan, o de las rectas de mínimos cuadrados por todos los puntos de cada una; ambas difieren donde las rectas pasan por sus puntos extremos.</translation>
    </message>
    <message>
        <source>Constant noise: standard deviation of the motion noise in x per step, or its variance as motion.unit says; a higher value spreads the particles more.</source>
        <translation>Ruido constante: desviación típica del ruido de movimiento en x por paso, o su varianza, según motion.unit; un valor mayor dispersa más las partículas.</translation>
    </message>
    <message>
        <source>Constant noise: standard deviation of the motion noise in y per step, or its variance as motion.unit says; a higher value spreads the particles more.</source>
        <translation>Ruido constante: desviación típica del ruido de movimiento en y por paso, o su varianza, según motion.unit; un valor mayor dispersa más las partículas.</translation>
    </message>
    <message>
        <source>Constant noise: standard deviation of the heading noise per step, or its variance as motion.unit says; a higher value spreads the headings more.</source>
        <translation>Ruido constante: desviación típica del ruido de orientación por paso, o su varianza, según motion.unit; un valor mayor dispersa más las orientaciones.</translation>
    </message>
    <message>
        <source>Whether sigma_x, sigma_y and sigma_theta are standard deviations or variances; the thesis calls its numbers variances, but only as standard deviations do they give its figures.</source>
        <translation>Si sigma_x, sigma_y y sigma_theta son desviaciones típicas o varianzas; la tesis llama varianzas a sus números, pero solo como desviaciones típicas dan sus resultados.</translation>
    </message>
    <message>
        <source>How an observation finds its landmark: ml takes the maximum likelihood, with p0 for a new landmark, and is gnn where an algorithm has no p0; gnn the nearest one inside a chi-square gate; jcbb pairs all observations of a scan together.</source>
        <translation>Cómo encuentra una observación su hito: ml toma la máxima similitud, con p0 para un hito nuevo, y es gnn donde un algoritmo no tiene p0; gnn, el más cercano dentro de una ventana ji cuadrado; jcbb empareja juntas todas las observaciones de un barrido.</translation>
    </message>
    <message>
        <source>Probability of the chi-square gate of gnn and jcbb; a higher value accepts observations that lie further from their landmark.</source>
        <translation>Probabilidad de la ventana ji cuadrado de gnn y jcbb; un valor mayor acepta observaciones más alejadas de su hito.</translation>
    </message>
    <message>
        <source>Probability of the chi-square gate that all pairings of a scan pass together with jcbb; a higher value pairs more observations that fit less well together.</source>
        <translation>Probabilidad de la ventana ji cuadrado que con jcbb pasan juntos todos los emparejamientos de un barrido; un valor mayor empareja más observaciones que encajan peor entre sí.</translation>
    </message>
    <message>
        <source>ekf-slam: probability of the chi-square gate outside which an observation is a new landmark, and between the two gates nothing; a higher value makes fewer new landmarks.</source>
        <translation>ekf-slam: probabilidad de la ventana ji cuadrado fuera de la cual una observación es un hito nuevo, y entre las dos ventanas no es nada; un valor mayor crea menos hitos nuevos.</translation>
    </message>
    <message>
        <source>Second best likelihood over the best from which an observation is ambiguous, and from which two new ones of a scan are one landmark; a higher value does both less often.</source>
        <translation>Segunda mejor similitud respecto a la mejor a partir de la cual una observación es ambigua, y a partir de la cual dos nuevas de un barrido son un solo hito; un valor mayor hace ambas cosas con menos frecuencia.</translation>
    </message>
    <message>
        <source>Whether the scan is divided at edges and RANSAC finds the lines of each part, or RANSAC has the whole scan and the points of each line are divided at edges.</source>
        <translation>Si el barrido se divide en los bordes y RANSAC busca las rectas de cada parte, o RANSAC trabaja sobre todo el barrido y los puntos de cada recta se dividen en los bordes.</translation>
    </message>
    <message>
        <source>Noise of increments: standard deviation of the step ahead per metre of it; a higher value trusts it less.</source>
        <translation>Ruido de los incrementos: desviación típica del avance por metro avanzado; un valor mayor se fía menos de él.</translation>
    </message>
    <message>
        <source>Noise of increments: standard deviation of the step sideways per metre of it; a higher value trusts it less.</source>
        <translation>Ruido de los incrementos: desviación típica del paso lateral por metro desplazado; un valor mayor se fía menos de él.</translation>
    </message>
    <message>
        <source>Noise of increments: standard deviation of the turn per radian of it; a higher value trusts it less.</source>
        <translation>Ruido de los incrementos: desviación típica del giro por radián girado; un valor mayor se fía menos de él.</translation>
    </message>
    <message>
        <source>Changes of a world&apos;s values, with spaces between them, e.g. laser.sigma=0.003 tour.laps=2; hitos-cli simulate --help lists the keys.</source>
        <translation>Cambios de los valores de un mundo, separados por espacios, p. ej. laser.sigma=0.003 tour.laps=2; hitos-cli simulate --help enumera las claves.</translation>
    </message>
    <message>
        <source>Readings beyond it are not registered; a higher value sees the ends of corridors and halls, which hold the heading.</source>
        <translation>Las lecturas más lejanas no entran en la alineación de barridos; un valor mayor ve los extremos de pasillos y salas, que sujetan la orientación.</translation>
    </message>
    <message>
        <source>Newest key scans that a scan is matched with; half as many of an earlier passage come in addition. More take longer.</source>
        <translation>Últimos barridos clave con los que se empareja un barrido; se añaden hasta la mitad de un paso anterior. Con más se tarda más.</translation>
    </message>
    <message>
        <source>A scan that far from the last key scan is the next one; a higher value keeps fewer and is quicker.</source>
        <translation>Un barrido a esta distancia del último barrido clave es el siguiente; un valor mayor guarda menos y es más rápido.</translation>
    </message>
    <message>
        <source>A scan turned that far from the last key scan is the next one; a higher value keeps fewer and is quicker.</source>
        <translation>Un barrido girado este ángulo respecto al último barrido clave es el siguiente; un valor mayor guarda menos y es más rápido.</translation>
    </message>
    <message>
        <source>Standard deviation of a matched point, the errors that neighbours share included; a higher value trusts the odometry more and searches wider for loops.</source>
        <translation>Desviación típica de un punto emparejado, con los errores que comparten los vecinos; un valor mayor se fía más de la odometría y busca bucles en una zona más amplia.</translation>
    </message>
    <message>
        <source>Factor of the odometry&apos;s standard deviations (2 cm and 10 % along, 1 cm and 5 % across, 30 mrad and 15 % of a turn); a higher value trusts the scans more.</source>
        <translation>Factor de las desviaciones típicas de la odometría (2 cm y 10 % a lo largo, 1 cm y 5 % de través, 30 mrad y 15 % de un giro); un valor mayor se fía más de los barridos.</translation>
    </message>
    <message>
        <source>Whether odometry that the scan plainly contradicts loses weight, as when a wheel slips.</source>
        <translation>Si pierde peso la odometría que el barrido contradice claramente, como cuando patina una rueda.</translation>
    </message>
    <message>
        <source>Whether a scan that fits nothing near its odometry is searched for in a window about it.</source>
        <translation>Si un barrido que no encaja con nada cerca de su odometría se busca en una ventana alrededor de ella.</translation>
    </message>
    <message>
        <source>Whether the laser&apos;s angle and its distance ahead of the axle are learnt while driving.</source>
        <translation>Si el ángulo del láser y su distancia por delante del eje se aprenden durante el recorrido.</translation>
    </message>
    <message>
        <source>Whether the robot&apos;s return to a place is looked for and the path behind corrected.</source>
        <translation>Si se busca el regreso del robot a un lugar y se corrige el camino ya recorrido.</translation>
    </message>
    <message>
        <source>Least correlation of the last metres with an earlier passage; a higher value refuses more, false and true.</source>
        <translation>Correlación mínima de los últimos metros con un paso anterior; un valor mayor rechaza más bucles, falsos y verdaderos.</translation>
    </message>
    <message>
        <source>Searches in a row that must say the same before a loop is closed; a higher value refuses more, false and true.</source>
        <translation>Búsquedas seguidas que deben decir lo mismo antes de cerrar un bucle; un valor mayor rechaza más bucles, falsos y verdaderos.</translation>
    </message>
    <message>
        <source>How often all key scans are matched anew with their neighbours at the tour&apos;s end.</source>
        <translation>Cuántas veces se vuelven a emparejar todos los barridos clave con sus vecinos al final del recorrido.</translation>
    </message>
    <message>
        <source>Whether a line is compared only with landmarks that were seen beside it and from its side, so that two walls in one line stay two landmarks.</source>
        <translation>Si una recta se compara solo con hitos vistos junto a ella y desde su lado, para que dos paredes alineadas sigan siendo dos hitos.</translation>
    </message>
    <message>
        <source>How far beyond the ends between which a landmark was seen a line may be of it; a higher value joins walls over wider openings.</source>
        <translation>Hasta qué distancia de los extremos entre los que se vio un hito puede ser suya una recta; un valor mayor une paredes a través de aberturas más anchas.</translation>
    </message>
    <message>
        <source>Whether a landmark takes only the likeliest of the observations of a scan that claim it, the others being kept out of the map; jcbb always does so.</source>
        <translation>Si un hito toma solo la más probable de las observaciones de un barrido que lo reclaman y las demás quedan fuera del mapa; jcbb lo hace siempre.</translation>
    </message>
    <message>
        <source>Whether each particle draws, by their likelihoods, which of several plausible landmarks an ambiguous observation is of, or a new one, so that particles follow different hypotheses; not with jcbb.</source>
        <translation>Si cada partícula sortea, según las similitudes, de cuál de varios hitos posibles es una observación ambigua, o si es de uno nuevo, para que las partículas sigan hipótesis distintas; no con jcbb.</translation>
    </message>
    <message>
        <source>Whether landmarks go that scans look through: where they should be seen and rays pass through them they lose, where they are found they gain log-odds of existence.</source>
        <translation>Si se eliminan los hitos a través de los cuales ven los barridos: donde deberían verse y los rayos los atraviesan pierden, y donde se encuentran ganan, log-odds de existencia.</translation>
    </message>
    <message>
        <source>Log-odds of existence that a landmark has at first and gains wherever it is found; a higher value makes it last longer.</source>
        <translation>Log-odds de existencia que un hito tiene al principio y gana cada vez que se encuentra; con un valor mayor dura más.</translation>
    </message>
    <message>
        <source>Log-odds of existence, negative, that a landmark gets wherever a scan looks through it; below 0 in all it goes.</source>
        <translation>Log-odds de existencia, negativos, que recibe un hito cada vez que un barrido ve a través de él; por debajo de 0 en total se elimina.</translation>
    </message>
    <message>
        <source>Greatest log-odds of existence of a landmark; a higher value lets what was long there stay longer once it is gone.</source>
        <translation>Máximo de los log-odds de existencia de un hito; con un valor mayor lo que estuvo mucho tiempo tarda más en eliminarse cuando ya no está.</translation>
    </message>
    <message>
        <source>Sightings that a new landmark needs before it is part of the map that is told; 0 or 1 asks for none, a higher value keeps more chance features out.</source>
        <translation>Observaciones que necesita un hito nuevo para formar parte del mapa que se da; 0 o 1 no exige ninguna, un valor mayor deja fuera más características casuales.</translation>
    </message>
    <message>
        <source>Scans from its first on in which the sightings of landmarks.probation have to come, else the landmark goes.</source>
        <translation>Barridos desde el primero en los que deben llegar las observaciones de landmarks.probation; si no, el hito se elimina.</translation>
    </message>
    <message>
        <source>Registered path: way after which 1/e of a particle&apos;s deviation from it is left; with a higher value particles keep their deviations longer.</source>
        <translation>Camino alineado: recorrido tras el cual queda 1/e de la desviación de una partícula respecto a él; con un valor mayor las partículas conservan más tiempo sus desviaciones.</translation>
    </message>
    <message>
        <source>Registered path: share of the registered step&apos;s covariance in the spread of the particles about the path; a higher value spreads them more where the match is poor.</source>
        <translation>Camino alineado: parte de la covarianza del paso alineado en la dispersión de las partículas alrededor del camino; un valor mayor las dispersa más donde el emparejamiento es malo.</translation>
    </message>
    <message>
        <source>Registered path: standard deviation that the particles&apos; positions have about it besides; a higher value spreads them more everywhere.</source>
        <translation>Camino alineado: desviación típica que tienen además las posiciones de las partículas alrededor de él; un valor mayor las dispersa más en todas partes.</translation>
    </message>
    <message>
        <source>Registered path: standard deviation that the particles&apos; headings have about it besides; a higher value spreads them more everywhere.</source>
        <translation>Camino alineado: desviación típica que tienen además las orientaciones de las partículas alrededor de él; un valor mayor las dispersa más en todas partes.</translation>
    </message>
    <message>
        <source>Path of the log or ROS recording to read; empty where none is chosen.</source>
        <translation>Ruta del registro o de la grabación de ROS que se lee; vacío si no se ha elegido ninguno.</translation>
    </message>
    <message>
        <source>Format of the log; auto finds it from its beginning.</source>
        <translation>Formato del registro; auto lo reconoce por su comienzo.</translation>
    </message>
    <message>
        <source>Topic of the laser in a ROS recording with several: one, some with commas between them, or all. Lasers that see from one place become one; empty takes the only one.</source>
        <translation>Tema del láser en una grabación de ROS con varios: uno, algunos separados por comas, o all. Los láseres que miran desde un mismo lugar pasan a ser uno; vacío toma el único.</translation>
    </message>
    <message>
        <source>Topic of the odometry in a ROS recording with several, or tf for its transforms; empty takes the only one, else the transforms.</source>
        <translation>Tema de la odometría en una grabación de ROS con varios, o tf para sus transformaciones; vacío toma el único o, si no hay, las transformaciones.</translation>
    </message>
    <message>
        <source>What becomes of scans before the first odometry reading: they are used as if the robot had stood still until then, or left out. Both are counted.</source>
        <translation>Qué se hace con los barridos anteriores a la primera lectura de odometría: usarlos como si el robot hubiera estado parado hasta ella u omitirlos. En ambos casos se cuentan.</translation>
    </message>
    <message>
        <source>seed of the laser&apos;s and the odometry&apos;s noise; 0: that of the run</source>
        <translation>semilla del ruido del láser y de la odometría; 0: la de la ejecución</translation>
    </message>
    <message>
        <source>how often the way points are driven, end to end</source>
        <translation>cuántas veces se recorren los puntos de paso, de principio a fin</translation>
    </message>
    <message>
        <source>time at rest before the robot leaves</source>
        <translation>tiempo en reposo antes de que el robot salga</translation>
    </message>
    <message>
        <source>turn once round on the spot before leaving</source>
        <translation>dar una vuelta sobre sí mismo antes de salir</translation>
    </message>
    <message>
        <source>the way points backwards, the last one still last</source>
        <translation>los puntos de paso al revés, el último sigue siendo el último</translation>
    </message>
    <message>
        <source>no wall may come nearer to the robot&apos;s centre</source>
        <translation>ninguna pared puede acercarse más al centro del robot</translation>
    </message>
    <message>
        <source>greatest speed</source>
        <translation>velocidad máxima</translation>
    </message>
    <message>
        <source>greatest change of speed</source>
        <translation>cambio máximo de la velocidad</translation>
    </message>
    <message>
        <source>greatest turn rate</source>
        <translation>velocidad de giro máxima</translation>
    </message>
    <message>
        <source>greatest change of the turn rate</source>
        <translation>cambio máximo de la velocidad de giro</translation>
    </message>
    <message>
        <source>every way point is passed at least this near</source>
        <translation>se pasa al menos así de cerca de cada punto de paso</translation>
    </message>
    <message>
        <source>how often the robot&apos;s velocities are set anew</source>
        <translation>con qué frecuencia se fijan de nuevo las velocidades del robot</translation>
    </message>
    <message>
        <source>between the wheels; of a robot whose wheel slips</source>
        <translation>entre las ruedas; de un robot al que le patina una rueda</translation>
    </message>
    <message>
        <source>rays of a scan</source>
        <translation>rayos de un barrido</translation>
    </message>
    <message>
        <source>from the first ray to the last</source>
        <translation>del primer rayo al último</translation>
    </message>
    <message>
        <source>how far the fan is turned to the left in the laser&apos;s frame, which has it straight ahead where this is 0</source>
        <translation>cuánto está girado el abanico a la izquierda en el sistema del láser, que con 0 lo tiene justo al frente</translation>
    </message>
    <message>
        <source>the rays follow each other to the right</source>
        <translation>los rayos se siguen unos a otros hacia la derecha</translation>
    </message>
    <message>
        <source>the rays of a scan are measured one after the other while the robot drives on, a whole turn from scan to scan</source>
        <translation>los rayos de un barrido se miden uno tras otro mientras el robot sigue su camino, una vuelta entera de un barrido al siguiente</translation>
    </message>
    <message>
        <source>walls further away give no reading</source>
        <translation>las paredes más lejanas no dan lectura</translation>
    </message>
    <message>
        <source>standard deviation of a range</source>
        <translation>desviación típica de una distancia</translation>
    </message>
    <message>
        <source>scans per second</source>
        <translation>barridos por segundo</translation>
    </message>
    <message>
        <source>the laser&apos;s place, ahead of the robot&apos;s centre</source>
        <translation>lugar del láser, delante del centro del robot</translation>
    </message>
    <message>
        <source>the laser&apos;s place, left of the robot&apos;s centre</source>
        <translation>lugar del láser, a la izquierda del centro del robot</translation>
    </message>
    <message>
        <source>the laser&apos;s heading, left of the robot&apos;s</source>
        <translation>orientación del láser, a la izquierda de la del robot</translation>
    </message>
    <message>
        <source>what a ray gives that meets no wall: nothing, or a point at max_range</source>
        <translation>qué da un rayo que no encuentra pared: nada, o un punto a max_range</translation>
    </message>
    <message>
        <source>cells in which the laser sees the walls; 0: none</source>
        <translation>celdas en las que el láser ve las paredes; 0: ninguna</translation>
    </message>
    <message>
        <source>how thick the walls are drawn into the cells</source>
        <translation>con qué grosor se dibujan las paredes en las celdas</translation>
    </message>
    <message>
        <source>shrink the drawing until the thick walls end at the outermost lines</source>
        <translation>encoger el dibujo hasta que las paredes gruesas acaben en las líneas exteriores</translation>
    </message>
    <message>
        <source>to the edge of the cell that is hit, or in whole cells as Stage counts</source>
        <translation>hasta el borde de la celda alcanzada, o en celdas enteras como cuenta Stage</translation>
    </message>
    <message>
        <source>odometry readings per second</source>
        <translation>lecturas de odometría por segundo</translation>
    </message>
    <message>
        <source>level of the noise on v and w of each reading</source>
        <translation>nivel del ruido en v y w de cada lectura</translation>
    </message>
    <message>
        <source>sigma = level |v|, or variance = level |v|</source>
        <translation>sigma = nivel |v|, o varianza = nivel |v|</translation>
    </message>
    <message>
        <source>Added to the times of the scans, where the laser&apos;s clock is not the odometry&apos;s; hitos-cli check says by how much they differ. A higher value pairs scans with later odometry.</source>
        <translation>Se suma a los tiempos de los barridos cuando el reloj del láser no es el de la odometría; hitos-cli check dice cuánto difieren. Un valor mayor empareja los barridos con odometría posterior.</translation>
    </message>
    <message>
        <source>Where the laser sits on the robot, whatever the log says: x,y,degrees (metres ahead, metres to the left, turn to the left), with ,upside-down behind it where it does; empty takes what the log says.</source>
        <translation>Dónde va el láser en el robot, diga lo que diga el registro: x,y,grados (metros hacia delante, metros a la izquierda, giro a la izquierda), seguido de ,upside-down si va boca abajo; vacío toma lo que dice el registro.</translation>
    </message>
    <message>
        <source>Frames of a ROS recording that are one under two names, as base_footprint=base_link; several with commas between them.</source>
        <translation>Marcos de una grabación de ROS que son uno con dos nombres, como base_footprint=base_link; varios, separados por comas.</translation>
    </message>
    <message>
        <source>Nearer readings are no points, so a higher value leaves out more of what may be the robot itself.</source>
        <translation>Las lecturas más cercanas no son puntos, así que un valor mayor omite más de lo que puede ser el propio robot.</translation>
    </message>
    <message>
        <source>Time from one ray of a scan to the next, by which rays are moved as the robot drives on; a higher value moves them further; 0 takes what the log says.</source>
        <translation>Tiempo de un rayo de un barrido al siguiente, según el cual se mueven los rayos mientras el robot avanza; un valor mayor los mueve más; 0 toma lo que dice el registro.</translation>
    </message>
    <message>
        <source>The odometry&apos;s way is taken that many times as long; a higher value lengthens it.</source>
        <translation>El camino de la odometría se toma tantas veces más largo; un valor mayor lo alarga.</translation>
    </message>
    <message>
        <source>Whether controls come from the differences of the logged poses, are the logged v and omega, or come from the scans alone, as where a log has no odometry.</source>
        <translation>Si los controles salen de las diferencias de las poses registradas, son la v y la omega registradas, o salen solo de los barridos, como donde un registro no tiene odometría.</translation>
    </message>
    <message>
        <source>%1 or %2</source>
        <translation>%1 o %2</translation>
    </message>
    <message>
        <source>Whether what is known to be wrong is mended: rays that were measured one after the other are moved by the odometry to one time (rays); besides, leaps of the odometry that no robot makes are bridged, stamps of too few digits give way to the logger&apos;s times, and where there is no odometry the scans say how the robot moved (on).</source>
        <translation>Si se corrige lo que se sabe falso: los rayos medidos uno tras otro se llevan con la odometría a un mismo instante (rays); además se salvan los saltos de la odometría que no da ningún robot, los sellos de tiempo con demasiado pocas cifras ceden a los tiempos del registrador, y donde no hay odometría los barridos dicen cómo se movió (on).</translation>
    </message>
    <message>
        <source>The laser&apos;s readings, and the greatest range that the log says, are taken that many times as long, as 0.001 where they are millimetres; a higher value lengthens them.</source>
        <translation>Las lecturas del láser, y el alcance máximo que dice el registro, se toman otras tantas veces más largas, como 0.001 si son milímetros; un valor mayor las alarga.</translation>
    </message>
    <message>
        <source>The angles of a scan&apos;s rays, from where the laser looks, are taken that many times as wide, as 0.0174533 where they are in degrees; a higher value widens them. Logs of points have none.</source>
        <translation>Los ángulos de los rayos de un barrido, desde donde mira el láser, se toman otras tantas veces más anchos, como 0.0174533 si están en grados; un valor mayor los abre. Los registros de puntos no los tienen.</translation>
    </message>
    <message>
        <source>Added to each of the laser&apos;s readings, where all of them are too short or too long by that; a higher value puts walls further away. Logs of points have none.</source>
        <translation>Se suma a cada lectura del láser, si a todas les falta o les sobra eso; un valor mayor pone las paredes más lejos. Los registros de puntos no la tienen.</translation>
    </message>
    <message>
        <source>The odometry&apos;s turns are taken that many times as wide; a higher value widens them, a negative one turns right what it says is left.</source>
        <translation>Los giros de la odometría se toman tantas veces más amplios; un valor mayor los amplía, uno negativo gira a la derecha lo que ella dice a la izquierda.</translation>
    </message>
    <message>
        <source>What logged poses have in the place of x, y and heading: axes in another order or negative, and theta or, in degrees, degrees, with an angle that is added, as in y,x,theta or x,y,90-theta; empty takes x,y,theta.</source>
        <translation>Lo que las poses registradas tienen en el lugar de x, y y rumbo: ejes en otro orden o negativos, y theta o, en grados, degrees, con un ángulo que se suma, como en y,x,theta o x,y,90-theta; vacío toma x,y,theta.</translation>
    </message>
    <message>
        <source>Added to the scans&apos; times besides, where the laser&apos;s clock runs at another speed or was set: seconds@second of the tour, as in 0@0,-1.39@680, evenly in between; two points of one second are a leap; empty adds nothing.</source>
        <translation>Se suma además a los tiempos de los barridos, donde el reloj del láser va a otra velocidad o se puso en hora: segundos@segundo del recorrido, como en 0@0,-1.39@680, por igual entre medias; dos puntos de un mismo segundo son un salto; vacío no suma nada.</translation>
    </message>
    <message>
        <source>nothing that this run makes use of</source>
        <translation>nada que esta ejecución use</translation>
    </message>
    <message>
        <source>%1 and %2 more</source>
        <translation>%1 y %2 más</translation>
    </message>
    <message>
        <source>How the pictures of grids that a run leaves mark where the path begins and where it ends: by discs, green and blue, or by an X and an O as the thesis prints them.</source>
        <translation>Cómo señalan las imágenes de rejilla que deja una ejecución dónde empieza y dónde acaba el camino: con discos, verde y azul, o con una X y una O como las imprime la tesis.</translation>
    </message>
    <message>
        <source>one ray in so many is traced and the ranges between are interpolated, as Stage 2 can; 1: all</source>
        <translation>uno de cada tantos rayos se traza y las distancias intermedias se interpolan, como puede hacer Stage 2; 1: todos</translation>
    </message>
    <message>
        <source>Whether the map of the tour before (source.map) stays as it is: the robot is found in it and followed, and nothing is added.</source>
        <translation>Si el mapa del recorrido anterior (source.map) queda como está: se encuentra al robot en él y se le sigue, y no se añade nada.</translation>
    </message>
    <message>
        <source>Where in the map of the tour before (source.map) this one begins, as x,y,degrees, give or take 3 m and 30 degrees, where places look alike; empty looks for it everywhere.</source>
        <translation>Dónde empieza este recorrido en el mapa del anterior (source.map), como x,y,grados, con 3 m y 30 grados de margen, para donde hay sitios parecidos; vacío lo busca en todas partes.</translation>
    </message>
    <message>
        <source>Folder with the results of a run, whose tour comes before this one: the robot, which may begin anywhere in that map, is found in it, and the map goes on; empty begins a new one.</source>
        <translation>Carpeta con los resultados de una ejecución, cuyo recorrido va antes de este: se encuentra al robot, que puede empezar en cualquier sitio de ese mapa, y el mapa sigue; vacío empieza uno nuevo.</translation>
    </message>
    <message>
        <source>standard deviation of a landmark&apos;s range</source>
        <translation>desviación típica de la distancia a un hito</translation>
    </message>
    <message>
        <source>standard deviation of a landmark&apos;s bearing</source>
        <translation>desviación típica del rumbo de un hito</translation>
    </message>
    <message>
        <source>whether the sensor tells which landmark it sees</source>
        <translation>si el sensor dice qué hito ve</translation>
    </message>
    <message>
        <source>Whether what a sensor says of which landmark it sees is believed, wherever that landmark lies; off associates as if it said nothing.</source>
        <translation>Si se cree lo que un sensor dice de qué hito ve, esté donde esté ese hito; off asocia como si no dijera nada.</translation>
    </message>
    <message>
        <source>Standard deviation of a measured range, for the covariance points and for circles; a higher value trusts the laser less.</source>
        <translation>Desviación típica de una distancia medida, para la covarianza de los puntos y para los círculos; un valor mayor se fía menos del láser.</translation>
    </message>
    <message>
        <source>Standard deviation of the error that all points of a line or circle share, for the covariance points and for circles: walls that are not straight, trunks that are not round, ranges in steps; a higher value trusts long walls less.</source>
        <translation>Desviación típica del error que comparten todos los puntos de una recta o círculo, para la covarianza de los puntos y para los círculos: paredes que no son rectas, troncos que no son redondos, distancias a saltos; un valor mayor se fía menos de las paredes largas.</translation>
    </message>
    <message>
        <source>Whether round things that stand alone are point landmarks at their centres, whatever else is looked for: trees, posts.</source>
        <translation>Si las cosas redondas que están aisladas son hitos puntuales en su centro, se busque lo que se busque además: árboles, postes.</translation>
    </message>
    <message>
        <source>Greatest radius of a circle; a higher value takes thicker trees, and more that is none.</source>
        <translation>Radio máximo de un círculo; un valor mayor admite árboles más gruesos, y más cosas que no lo son.</translation>
    </message>
    <message>
        <source>Nothing else may be as near to a circle, and what is behind it is farther by more; a higher value takes fewer twigs of bushes, and fewer trees that stand close together.</source>
        <translation>Ninguna otra cosa puede estar tan cerca de un círculo, y lo que hay detrás está más lejos que esto; un valor mayor admite menos ramas de arbustos, y menos árboles que estén juntos.</translation>
    </message>
    <message>
        <source>Fewest points of a circle; a higher value takes fewer of the trees that are far away, and less that is none.</source>
        <translation>Mínimo de puntos de un círculo; un valor mayor admite menos árboles lejanos, y menos cosas que no lo son.</translation>
    </message>
    <message>
        <source>What is changed in the graph of this very tour: &quot;refuse SCAN EARLIER&quot; (no loop), &quot;close SCAN EARLIER X Y THETA&quot; (a loop), &quot;fix SCAN X Y THETA&quot;, &quot;slip SCAN&quot;, &quot;wall SCAN BEARING X1 Y1 X2 Y2&quot; and &quot;point SCAN DX DY X Y&quot; (anchors to a drawing), with semicolons between; a file of them is read by --edits.</source>
        <translation>Lo que se cambia en el grafo de este mismo recorrido: «refuse SCAN EARLIER» (no es un bucle), «close SCAN EARLIER X Y THETA» (lo es), «fix SCAN X Y THETA», «slip SCAN», «wall SCAN BEARING X1 Y1 X2 Y2» y «point SCAN DX DY X Y» (anclas a un dibujo), separados por punto y coma; --edits lee un archivo de ellos.</translation>
    </message>
    <message>
        <source>Of a log that came in live: by how many of its first bytes was decided what has to be before the first scan, and its messages are taken as they were received; so it gives what the live run gave. 0: by all of it, in the order of its stamps.</source>
        <translation>De un registro que llegó en vivo: por cuántos de sus primeros bytes se decidió lo que hay que decidir antes del primer barrido, y sus mensajes se toman como se recibieron; así da lo que dio la ejecución en vivo. 0: por todo él, en el orden de sus instantes.</translation>
    </message>
    <message>
        <source>%1 (the left one alone)</source>
        <translation>%1 (solo la izquierda)</translation>
    </message>
</context>
<context>
    <name>ParameterChoice</name>
    <message>
        <source>Automatic</source>
        <translation>Automático</translation>
    </message>
    <message>
        <source>Player</source>
        <translation>Player</translation>
    </message>
    <message>
        <source>Radish</source>
        <translation>Radish</translation>
    </message>
    <message>
        <source>Normalised</source>
        <translation>Normalizado</translation>
    </message>
    <message>
        <source>CARMEN</source>
        <translation>CARMEN</translation>
    </message>
    <message>
        <source>Logged poses</source>
        <translation>Poses registradas</translation>
    </message>
    <message>
        <source>Logged velocities</source>
        <translation>Velocidades registradas</translation>
    </message>
    <message>
        <source>FastSLAM 1.0</source>
        <translation>FastSLAM 1.0</translation>
    </message>
    <message>
        <source>EKF-SLAM</source>
        <translation>EKF-SLAM</translation>
    </message>
    <message>
        <source>Maximum likelihood</source>
        <translation>Máxima similitud</translation>
    </message>
    <message>
        <source>Gated nearest neighbour</source>
        <translation>Vecino más cercano</translation>
    </message>
    <message>
        <source>Keep the likelihood</source>
        <translation>Con similitud</translation>
    </message>
    <message>
        <source>Neutral</source>
        <translation>Neutra</translation>
    </message>
    <message>
        <source>As a new landmark</source>
        <translation>Como hito nuevo</translation>
    </message>
    <message>
        <source>Off</source>
        <translation>No</translation>
    </message>
    <message>
        <source>Differential with odometry</source>
        <translation>Diferencial con odometría</translation>
    </message>
    <message>
        <source>Differential without odometry</source>
        <translation>Diferencial sin odometría</translation>
    </message>
    <message>
        <source>Proportional</source>
        <translation>Proporcional</translation>
    </message>
    <message>
        <source>Fixed variances</source>
        <translation>Varianzas fijas</translation>
    </message>
    <message>
        <source>From the points</source>
        <translation>De los puntos</translation>
    </message>
    <message>
        <source>Split and Merge</source>
        <translation>Split and Merge</translation>
    </message>
    <message>
        <source>RANSAC</source>
        <translation>RANSAC</translation>
    </message>
    <message>
        <source>Lines</source>
        <translation>Recta</translation>
    </message>
    <message>
        <source>Corners</source>
        <translation>Punto</translation>
    </message>
    <message>
        <source>Both</source>
        <translation>Ambas</translation>
    </message>
    <message>
        <source>End points</source>
        <translation>Extremos</translation>
    </message>
    <message>
        <source>Least squares</source>
        <translation>Mín. cuadrados</translation>
    </message>
    <message>
        <source>Without threshold</source>
        <translation>Sin umbral</translation>
    </message>
    <message>
        <source>Motion model</source>
        <translation>Modelo de movimiento</translation>
    </message>
    <message>
        <source>Low variance</source>
        <translation>Baja varianza</translation>
    </message>
    <message>
        <source>Multinomial</source>
        <translation>Multinomial</translation>
    </message>
    <message>
        <source>Residual</source>
        <translation>Residual</translation>
    </message>
    <message>
        <source>Stratified</source>
        <translation>Estratificado</translation>
    </message>
    <message>
        <source>Detected lines</source>
        <translation>Rectas detectadas</translation>
    </message>
    <message>
        <source>Fitted walls</source>
        <translation>Paredes ajustadas</translation>
    </message>
    <message>
        <source>Standard deviations</source>
        <translation>Desviaciones típicas</translation>
    </message>
    <message>
        <source>Variances</source>
        <translation>Varianzas</translation>
    </message>
    <message>
        <source>Joint compatibility</source>
        <translation>Compatibilidad conjunta</translation>
    </message>
    <message>
        <source>Edges, then RANSAC</source>
        <translation>Bordes, luego RANSAC</translation>
    </message>
    <message>
        <source>RANSAC, then edges</source>
        <translation>RANSAC, luego bordes</translation>
    </message>
    <message>
        <source>Increments</source>
        <translation>Incrementos</translation>
    </message>
    <message>
        <source>On</source>
        <translation>Sí</translation>
    </message>
    <message>
        <source>Graph-SLAM</source>
        <translation>Graph-SLAM</translation>
    </message>
    <message>
        <source>Registered path</source>
        <translation>Camino alineado</translation>
    </message>
    <message>
        <source>Motion and observations</source>
        <translation>Movimiento y observaciones</translation>
    </message>
    <message>
        <source>ROS bag</source>
        <translation>Bolsa (bag) de ROS</translation>
    </message>
    <message>
        <source>MCAP</source>
        <translation>MCAP</translation>
    </message>
    <message>
        <source>ROS 2 SQLite</source>
        <translation>SQLite de ROS 2</translation>
    </message>
    <message>
        <source>ROS 2 folder</source>
        <translation>Carpeta de ROS 2</translation>
    </message>
    <message>
        <source>Keep, robot at rest</source>
        <translation>Usar, robot parado</translation>
    </message>
    <message>
        <source>Leave out</source>
        <translation>Omitir</translation>
    </message>
    <message>
        <source>σ = level · speed</source>
        <translation>σ = nivel · velocidad</translation>
    </message>
    <message>
        <source>σ² = level · speed</source>
        <translation>σ² = nivel · velocidad</translation>
    </message>
    <message>
        <source>no</source>
        <translation>no</translation>
    </message>
    <message>
        <source>yes</source>
        <translation>sí</translation>
    </message>
    <message>
        <source>no point</source>
        <translation>ningún punto</translation>
    </message>
    <message>
        <source>greatest range</source>
        <translation>alcance máximo</translation>
    </message>
    <message>
        <source>to the edge</source>
        <translation>hasta el borde</translation>
    </message>
    <message>
        <source>in whole cells</source>
        <translation>en celdas enteras</translation>
    </message>
    <message>
        <source>Scans</source>
        <translation>Barridos</translation>
    </message>
    <message>
        <source>Rays only</source>
        <translation>Solo los rayos</translation>
    </message>
    <message>
        <source>With Neff threshold</source>
        <translation>Con umbral Neff</translation>
    </message>
    <message>
        <source>Discs</source>
        <translation>Discos</translation>
    </message>
    <message>
        <source>X and O</source>
        <translation>X y O</translation>
    </message>
    <message>
        <source>MRCLAM</source>
        <translation>MRCLAM</translation>
    </message>
    <message>
        <source>none</source>
        <translation>ninguno</translation>
    </message>
</context>
<context>
    <name>ParameterGroup</name>
    <message>
        <source>Data source</source>
        <translation>Origen de los datos</translation>
    </message>
    <message>
        <source>Motion model</source>
        <translation>Modelo de movimiento</translation>
    </message>
    <message>
        <source>Observation model</source>
        <translation>Modelo de observación</translation>
    </message>
    <message>
        <source>Resampling</source>
        <translation>Remuestreo</translation>
    </message>
    <message>
        <source>Grid map</source>
        <translation>Mapa de rejilla</translation>
    </message>
    <message>
        <source>Run</source>
        <translation>Ejecución</translation>
    </message>
    <message>
        <source>Registration</source>
        <translation>Alineación de barridos</translation>
    </message>
    <message>
        <source>Particle filter</source>
        <translation>Filtro de partículas</translation>
    </message>
    <message>
        <source>%1 algorithm</source>
        <translation>Algoritmo %1</translation>
    </message>
</context>
<context>
    <name>ParameterLabel</name>
    <message>
        <source>Log</source>
        <translation>Registro</translation>
    </message>
    <message>
        <source>Format</source>
        <translation>Tipo</translation>
    </message>
    <message>
        <source>Maximum range</source>
        <translation>Alcance máximo</translation>
    </message>
    <message>
        <source>Odometry from</source>
        <translation>Odometría</translation>
    </message>
    <message>
        <source>Algorithm</source>
        <translation>Algoritmo</translation>
    </message>
    <message>
        <source>Particles</source>
        <translation>Partículas</translation>
    </message>
    <message>
        <source>Association</source>
        <translation>Asociación</translation>
    </message>
    <message>
        <source>P0</source>
        <translation>P0</translation>
    </message>
    <message>
        <source>Gate probability</source>
        <translation>Probabilidad de la puerta</translation>
    </message>
    <message>
        <source>New landmark gate</source>
        <translation>Puerta de hito nuevo</translation>
    </message>
    <message>
        <source>Ambiguous</source>
        <translation>Ambiguas</translation>
    </message>
    <message>
        <source>Ambiguity ratio</source>
        <translation>Razón de ambigüedad</translation>
    </message>
    <message>
        <source>Model</source>
        <translation>Modelo</translation>
    </message>
    <message>
        <source>σ x</source>
        <translation>σ x</translation>
    </message>
    <message>
        <source>σ y</source>
        <translation>σ y</translation>
    </message>
    <message>
        <source>σ θ</source>
        <translation>σ θ</translation>
    </message>
    <message>
        <source>Var. along</source>
        <translation>Var. a lo largo</translation>
    </message>
    <message>
        <source>Var. across</source>
        <translation>Var. de través</translation>
    </message>
    <message>
        <source>Var. θ per rad</source>
        <translation>Var. θ por rad</translation>
    </message>
    <message>
        <source>Var. θ per m</source>
        <translation>Var. θ por m</translation>
    </message>
    <message>
        <source>σ² ρ</source>
        <translation>σ² ρ</translation>
    </message>
    <message>
        <source>σ² θ</source>
        <translation>σ² θ</translation>
    </message>
    <message>
        <source>Covariance</source>
        <translation>Covarianza</translation>
    </message>
    <message>
        <source>σ range</source>
        <translation>σ distancia</translation>
    </message>
    <message>
        <source>σ shared</source>
        <translation>σ común</translation>
    </message>
    <message>
        <source>Lines by</source>
        <translation>Rectas por</translation>
    </message>
    <message>
        <source>Features</source>
        <translation>Características</translation>
    </message>
    <message>
        <source>Corner distance (Es)</source>
        <translation>Distancia de esquina (Es)</translation>
    </message>
    <message>
        <source>D max</source>
        <translation>D máx</translation>
    </message>
    <message>
        <source>L min</source>
        <translation>L mín</translation>
    </message>
    <message>
        <source>P min</source>
        <translation>P mín</translation>
    </message>
    <message>
        <source>Fit</source>
        <translation>Ajuste</translation>
    </message>
    <message>
        <source>Collinear ρ</source>
        <translation>ρ colineal</translation>
    </message>
    <message>
        <source>Collinear θ</source>
        <translation>θ colineal</translation>
    </message>
    <message>
        <source>Collinear gap</source>
        <translation>Hueco colineal</translation>
    </message>
    <message>
        <source>Gap</source>
        <translation>Hueco</translation>
    </message>
    <message>
        <source>Gap per range</source>
        <translation>Hueco por distancia</translation>
    </message>
    <message>
        <source>RANSAC edge</source>
        <translation>Borde RANSAC</translation>
    </message>
    <message>
        <source>Edge per range</source>
        <translation>Borde por distancia</translation>
    </message>
    <message>
        <source>RANSAC threshold</source>
        <translation>Umbral RANSAC</translation>
    </message>
    <message>
        <source>RANSAC iterations</source>
        <translation>Iteraciones RANSAC</translation>
    </message>
    <message>
        <source>Resampling</source>
        <translation>Remuestreo</translation>
    </message>
    <message>
        <source>Neff threshold</source>
        <translation>Umbral Neff</translation>
    </message>
    <message>
        <source>Cell size</source>
        <translation>Lado de celda</translation>
    </message>
    <message>
        <source>Longest ray</source>
        <translation>Rayo más largo</translation>
    </message>
    <message>
        <source>Seed</source>
        <translation>Semilla</translation>
    </message>
    <message>
        <source>Threads</source>
        <translation>Hilos</translation>
    </message>
    <message>
        <source>Proposal</source>
        <translation>Propuesta</translation>
    </message>
    <message>
        <source>Resampling method</source>
        <translation>Método de remuestreo</translation>
    </message>
    <message>
        <source>Corner angle</source>
        <translation>Ángulo de esquina</translation>
    </message>
    <message>
        <source>Tour seed</source>
        <translation>Semilla del recorrido</translation>
    </message>
    <message>
        <source>Corners of</source>
        <translation>Esquinas de</translation>
    </message>
    <message>
        <source>Noise given as</source>
        <translation>Ruido dado como</translation>
    </message>
    <message>
        <source>Joint probability</source>
        <translation>Probabilidad conjunta</translation>
    </message>
    <message>
        <source>RANSAC order</source>
        <translation>Orden de RANSAC</translation>
    </message>
    <message>
        <source>Ratio x</source>
        <translation>Razón x</translation>
    </message>
    <message>
        <source>Ratio y</source>
        <translation>Razón y</translation>
    </message>
    <message>
        <source>Ratio θ</source>
        <translation>Razón θ</translation>
    </message>
    <message>
        <source>World values</source>
        <translation>Valores del mundo</translation>
    </message>
    <message>
        <source>Range</source>
        <translation>Alcance</translation>
    </message>
    <message>
        <source>Key scans</source>
        <translation>Barridos clave</translation>
    </message>
    <message>
        <source>Key distance</source>
        <translation>Distancia clave</translation>
    </message>
    <message>
        <source>Key angle</source>
        <translation>Ángulo clave</translation>
    </message>
    <message>
        <source>σ point</source>
        <translation>σ punto</translation>
    </message>
    <message>
        <source>Odometry noise</source>
        <translation>Ruido odométrico</translation>
    </message>
    <message>
        <source>Robust odometry</source>
        <translation>Odometría robusta</translation>
    </message>
    <message>
        <source>Search</source>
        <translation>Búsqueda</translation>
    </message>
    <message>
        <source>Calibration</source>
        <translation>Calibración</translation>
    </message>
    <message>
        <source>Loops</source>
        <translation>Bucles</translation>
    </message>
    <message>
        <source>Loop score</source>
        <translation>Puntuación de bucle</translation>
    </message>
    <message>
        <source>Agreeing searches</source>
        <translation>Búsquedas acordes</translation>
    </message>
    <message>
        <source>Final passes</source>
        <translation>Pasadas finales</translation>
    </message>
    <message>
        <source>Bounded lines</source>
        <translation>Rectas acotadas</translation>
    </message>
    <message>
        <source>Margin of ends</source>
        <translation>Margen de extremos</translation>
    </message>
    <message>
        <source>Mutual exclusion</source>
        <translation>Exclusión mutua</translation>
    </message>
    <message>
        <source>Several hypotheses</source>
        <translation>Varias hipótesis</translation>
    </message>
    <message>
        <source>Vanishing landmarks</source>
        <translation>Hitos desaparecidos</translation>
    </message>
    <message>
        <source>Probation</source>
        <translation>Hito a prueba</translation>
    </message>
    <message>
        <source>Probation scans</source>
        <translation>Barridos de prueba</translation>
    </message>
    <message>
        <source>Memory</source>
        <translation>Memoria</translation>
    </message>
    <message>
        <source>Share</source>
        <translation>Parte</translation>
    </message>
    <message>
        <source>σ position</source>
        <translation>σ posición</translation>
    </message>
    <message>
        <source>σ heading</source>
        <translation>σ orientación</translation>
    </message>
    <message>
        <source>Laser topic</source>
        <translation>Tema del láser</translation>
    </message>
    <message>
        <source>Odometry topic</source>
        <translation>Tema de la odometría</translation>
    </message>
    <message>
        <source>Scans before the odometry</source>
        <translation>Barridos antes de la odometría</translation>
    </message>
    <message>
        <source>Seed of the noise</source>
        <translation>Semilla del ruido</translation>
    </message>
    <message>
        <source>Laps</source>
        <translation>Vueltas</translation>
    </message>
    <message>
        <source>Rest at first</source>
        <translation>Reposo inicial</translation>
    </message>
    <message>
        <source>Look around first</source>
        <translation>Mirar alrededor antes</translation>
    </message>
    <message>
        <source>Backwards</source>
        <translation>Al revés</translation>
    </message>
    <message>
        <source>Radius</source>
        <translation>Radio</translation>
    </message>
    <message>
        <source>Greatest speed</source>
        <translation>Velocidad máxima</translation>
    </message>
    <message>
        <source>Acceleration</source>
        <translation>Aceleración</translation>
    </message>
    <message>
        <source>Greatest turn rate</source>
        <translation>Giro máximo</translation>
    </message>
    <message>
        <source>Turn acceleration</source>
        <translation>Aceleración del giro</translation>
    </message>
    <message>
        <source>Tolerance</source>
        <translation>Tolerancia</translation>
    </message>
    <message>
        <source>Control rate</source>
        <translation>Frecuencia de control</translation>
    </message>
    <message>
        <source>Track</source>
        <translation>Ancho de vía</translation>
    </message>
    <message>
        <source>Rays</source>
        <translation>Rayos</translation>
    </message>
    <message>
        <source>Field of view</source>
        <translation>Campo de visión</translation>
    </message>
    <message>
        <source>Fan turned</source>
        <translation>Abanico girado</translation>
    </message>
    <message>
        <source>Rays one by one</source>
        <translation>Rayos uno a uno</translation>
    </message>
    <message>
        <source>Clockwise</source>
        <translation>Sentido horario</translation>
    </message>
    <message>
        <source>Greatest range</source>
        <translation>Alcance máximo</translation>
    </message>
    <message>
        <source>Scans</source>
        <translation>Barridos</translation>
    </message>
    <message>
        <source>Mounted ahead</source>
        <translation>Montado delante</translation>
    </message>
    <message>
        <source>Mounted left</source>
        <translation>Montado a la izquierda</translation>
    </message>
    <message>
        <source>Mounted turned</source>
        <translation>Montado girado</translation>
    </message>
    <message>
        <source>No return</source>
        <translation>Sin eco</translation>
    </message>
    <message>
        <source>Cell</source>
        <translation>Celda</translation>
    </message>
    <message>
        <source>Wall</source>
        <translation>Pared</translation>
    </message>
    <message>
        <source>Ranges</source>
        <translation>Distancias</translation>
    </message>
    <message>
        <source>Readings</source>
        <translation>Lecturas</translation>
    </message>
    <message>
        <source>Noise</source>
        <translation>Ruido</translation>
    </message>
    <message>
        <source>Kind of noise</source>
        <translation>Tipo de ruido</translation>
    </message>
    <message>
        <source>Scan delay</source>
        <translation>Retraso de barridos</translation>
    </message>
    <message>
        <source>Laser&apos;s place</source>
        <translation>Lugar del láser</translation>
    </message>
    <message>
        <source>Frames that are one</source>
        <translation>Marcos que son uno</translation>
    </message>
    <message>
        <source>Minimum range</source>
        <translation>Alcance mínimo</translation>
    </message>
    <message>
        <source>Time of a ray</source>
        <translation>Tiempo de un rayo</translation>
    </message>
    <message>
        <source>Odometry scale</source>
        <translation>Escala de la odometría</translation>
    </message>
    <message>
        <source>Mend</source>
        <translation>Corregir</translation>
    </message>
    <message>
        <source>Range scale</source>
        <translation>Escala de los alcances</translation>
    </message>
    <message>
        <source>Fan scale</source>
        <translation>Escala del abanico</translation>
    </message>
    <message>
        <source>Range offset</source>
        <translation>Corrección de los alcances</translation>
    </message>
    <message>
        <source>Scale of turns</source>
        <translation>Escala de los giros</translation>
    </message>
    <message>
        <source>Axes of the odometry</source>
        <translation>Ejes de la odometría</translation>
    </message>
    <message>
        <source>Clock of the scans</source>
        <translation>Reloj de los barridos</translation>
    </message>
    <message>
        <source>Gain of a hit</source>
        <translation>Ganancia de un impacto</translation>
    </message>
    <message>
        <source>Loss of a pass</source>
        <translation>Pérdida de un paso</translation>
    </message>
    <message>
        <source>Greatest log-odds</source>
        <translation>Log-odds máximo</translation>
    </message>
    <message>
        <source>Gain where found</source>
        <translation>Ganancia al verse</translation>
    </message>
    <message>
        <source>Loss where looked through</source>
        <translation>Pérdida al verse a través</translation>
    </message>
    <message>
        <source>Ends of the path</source>
        <translation>Extremos del camino</translation>
    </message>
    <message>
        <source>Rays traced: one in</source>
        <translation>Rayos trazados: uno de cada</translation>
    </message>
    <message>
        <source>Changes by hand</source>
        <translation>Cambios a mano</translation>
    </message>
    <message>
        <source>Hold the map</source>
        <translation>Retener el mapa</translation>
    </message>
    <message>
        <source>Start in the map</source>
        <translation>Inicio en el mapa</translation>
    </message>
    <message>
        <source>Map to go on with</source>
        <translation>Mapa con el que seguir</translation>
    </message>
    <message>
        <source>σ bearing</source>
        <translation>σ rumbo</translation>
    </message>
    <message>
        <source>Identities</source>
        <translation>Identidades</translation>
    </message>
    <message>
        <source>Known identities</source>
        <translation>Identidades conocidas</translation>
    </message>
    <message>
        <source>Trees and posts</source>
        <translation>Árboles y postes</translation>
    </message>
    <message>
        <source>Thickest</source>
        <translation>El más grueso</translation>
    </message>
    <message>
        <source>Stands alone by</source>
        <translation>Aislado por</translation>
    </message>
    <message>
        <source>Fewest points</source>
        <translation>Mínimo de puntos</translation>
    </message>
    <message>
        <source>Opening</source>
        <translation>Apertura</translation>
    </message>
</context>
<context>
    <name>Picture</name>
    <message>
        <source>the picture could not be encoded</source>
        <translation>no se pudo codificar la imagen</translation>
    </message>
    <message>
        <source>pictures are written as %1</source>
        <translation>las imágenes se escriben como %1</translation>
    </message>
    <message>
        <source>Pictures (*.png *.jpg *.jpeg *.svg *.pdf)</source>
        <translation>Imágenes (*.png *.jpg *.jpeg *.svg *.pdf)</translation>
    </message>
    <message>
        <source>The picture would have %1 × %2 pixels and may have %3 a side; choose a smaller one.</source>
        <translation>La imagen tendría %1 × %2 píxeles y puede tener %3 por lado; elija una menor.</translation>
    </message>
</context>
<context>
    <name>PlanarEdge</name>
    <message>
        <source>Between poses</source>
        <translation>Entre poses</translation>
    </message>
    <message>
        <source>Point seen</source>
        <translation>Punto visto</translation>
    </message>
    <message>
        <source>Line seen</source>
        <translation>Recta vista</translation>
    </message>
    <message>
        <source>Known pose</source>
        <translation>Pose conocida</translation>
    </message>
    <message>
        <source>Known position</source>
        <translation>Posición conocida</translation>
    </message>
    <message>
        <source>Known point</source>
        <translation>Punto conocido</translation>
    </message>
</context>
<context>
    <name>Preset</name>
    <message>
        <source>Simulated tours</source>
        <translation>Recorridos simulados</translation>
    </message>
    <message>
        <source>As the thesis</source>
        <translation>Como el proyecto</translation>
    </message>
    <message>
        <source>FastSLAM with the parameters of the thesis&apos;s final experiments, on worlds with a laser of 3 mm.</source>
        <translation>FastSLAM con los parámetros de los últimos experimentos del proyecto, en mundos con un láser de 3 mm.</translation>
    </message>
    <message>
        <source>EKF-SLAM</source>
        <translation>EKF-SLAM</translation>
    </message>
    <message>
        <source>EKF-SLAM with lines by RANSAC, each with the covariance of its own points, for worlds and exact lasers.</source>
        <translation>EKF-SLAM con rectas por RANSAC, cada una con la covarianza de sus propios puntos, para mundos y láseres exactos.</translation>
    </message>
    <message>
        <source>Recorded tours</source>
        <translation>Recorridos grabados</translation>
    </message>
    <message>
        <source>As the paper</source>
        <translation>Como el artículo</translation>
    </message>
    <message>
        <source>EKF-SLAM to the letter of the paper that it comes from: lines alone, one gate, noise in proportion to the way.</source>
        <translation>EKF-SLAM al pie de la letra del artículo del que procede: solo rectas, una sola puerta y ruido proporcional al camino.</translation>
    </message>
    <message>
        <source>Scans registered with what was seen before, loops closed, FastSLAM about that path: one configuration for every building.</source>
        <translation>Barridos alineados con lo visto antes, bucles cerrados y FastSLAM alrededor de ese camino: una sola configuración para cualquier edificio.</translation>
    </message>
    <message>
        <source>Recorded tours without registration</source>
        <translation>Recorridos grabados sin alineación de barridos</translation>
    </message>
    <message>
        <source>FastSLAM 1.0 alone on logs of real robots: noise that grows with the motion, gaps that end a line.</source>
        <translation>FastSLAM 1.0 solo, con registros de robots reales: ruido que crece con el movimiento y huecos que terminan una recta.</translation>
    </message>
    <message>
        <source>Landmarks with names</source>
        <translation>Hitos con nombre</translation>
    </message>
    <message>
        <source>FastSLAM for sensors that tell landmarks by themselves, posts or codes, and say which one they see.</source>
        <translation>FastSLAM para sensores que distinguen por sí mismos los hitos, postes o códigos, y dicen cuál ven.</translation>
    </message>
    <message>
        <source>Trees and posts</source>
        <translation>Árboles y postes</translation>
    </message>
    <message>
        <source>FastSLAM for parks and orchards: trees and posts as circles in the scans of a laser that sees far.</source>
        <translation>FastSLAM para parques y huertos: árboles y postes como círculos en los barridos de un láser que ve lejos.</translation>
    </message>
    <message>
        <source>FastSLAM for worlds of walls and their laser of 10 mm: lines fitted to all points, noise that grows with the motion.</source>
        <translation>FastSLAM para mundos de paredes y su láser de 10 mm: rectas ajustadas a todos los puntos, ruido que crece con el movimiento.</translation>
    </message>
</context>
<context>
    <name>Prompts</name>
    <message>
        <source>The file exists</source>
        <translation>El archivo existe</translation>
    </message>
    <message>
        <source>Replace %1?</source>
        <translation>¿Reemplazar %1?</translation>
    </message>
    <message>
        <source>What it holds now will be lost.</source>
        <translation>Se perderá lo que contiene ahora.</translation>
    </message>
    <message>
        <source>Replace</source>
        <translation>Reemplazar</translation>
    </message>
    <message>
        <source>The file was not written</source>
        <translation>El archivo no se ha escrito</translation>
    </message>
    <message>
        <source>The folder exists</source>
        <translation>La carpeta existe</translation>
    </message>
    <message>
        <source>Write into %1?</source>
        <translation>¿Escribir en %1?</translation>
    </message>
    <message>
        <source>Results of another run in it will be lost; other files stay.</source>
        <translation>Los resultados de otra ejecución que contenga se perderán; los demás archivos quedan.</translation>
    </message>
    <message>
        <source>Folder</source>
        <translation>Carpeta</translation>
    </message>
    <message>
        <source>%1 is a file, and a folder is to be written. Choose another name.</source>
        <translation>%1 es un archivo, y se va a escribir una carpeta. Elija otro nombre.</translation>
    </message>
</context>
<context>
    <name>RunGuard</name>
    <message>
        <source>A long run</source>
        <translation>Una ejecución larga</translation>
    </message>
    <message>
        <source>Discard this run?</source>
        <translation>¿Descartar esta ejecución?</translation>
    </message>
    <message>
        <source>Discard</source>
        <translation>Descartar</translation>
    </message>
    <message>
        <source>A tour that comes in</source>
        <translation>Un recorrido que está llegando</translation>
    </message>
    <message>
        <source>End the tour here?</source>
        <translation>¿Terminar aquí el recorrido?</translation>
    </message>
    <message>
        <source>What has come so far is in %1 and can be mapped again; what comes from now on is not mapped.</source>
        <translation>Lo que ha llegado está en %1 y se puede volver a cartografiar; lo que llegue desde ahora no se cartografía.</translation>
    </message>
    <message>
        <source>End the tour</source>
        <translation>Terminar el recorrido</translation>
    </message>
    <message>
        <source>Its log does not hold all of it any more, so it cannot be mapped again.</source>
        <translation>Su registro ya no lo contiene todo, así que no se puede volver a cartografiar.</translation>
    </message>
    <message>
        <source>It has computed for %1 s.</source>
        <translation>Ha calculado durante %1 s.</translation>
    </message>
    <message>
        <source>A map that is here alone</source>
        <translation>Un mapa que solo está aquí</translation>
    </message>
    <message>
        <source>Its results can be kept first with File → Save all results.</source>
        <translation>Antes se pueden guardar sus resultados con Archivo → Guardar todos los resultados.</translation>
    </message>
</context>
<context>
    <name>RunList</name>
    <message>
        <source>this run</source>
        <translation>esta ejecución</translation>
    </message>
    <message>
        <source>run %1</source>
        <translation>ejecución %1</translation>
    </message>
    <message>
        <source>%1, driven</source>
        <translation>%1, conducido</translation>
    </message>
</context>
<context>
    <name>SkippedLines</name>
    <message>
        <source>… and %1 more</source>
        <translation>… y %1 más</translation>
    </message>
    <message>
        <source>Damaged lines of %1</source>
        <translation>Líneas dañadas de %1</translation>
    </message>
    <message>
        <source>Damaged messages and records of %1</source>
        <translation>Mensajes y partes dañados de %1</translation>
    </message>
</context>
<context>
    <name>WorldForm</name>
    <message>
        <source>Robot</source>
        <translation>Robot</translation>
    </message>
    <message>
        <source>Tour</source>
        <translation>Recorrido</translation>
    </message>
    <message>
        <source>Noise</source>
        <translation>Ruido</translation>
    </message>
    <message>
        <source>Laser</source>
        <translation>Láser</translation>
    </message>
    <message>
        <source>Odometry</source>
        <translation>Odometría</translation>
    </message>
    <message>
        <source>Raster of the walls</source>
        <translation>Cuadrícula de las paredes</translation>
    </message>
    <message>
        <source>Landmarks in the place of a laser</source>
        <translation>Hitos en lugar de un láser</translation>
    </message>
</context>
<context>
    <name>WorldItem</name>
    <message>
        <source>x</source>
        <translation>x</translation>
    </message>
    <message>
        <source>y</source>
        <translation>y</translation>
    </message>
    <message>
        <source>side</source>
        <translation>lado</translation>
    </message>
    <message>
        <source>length</source>
        <translation>longitud</translation>
    </message>
    <message>
        <source>direction</source>
        <translation>dirección</translation>
    </message>
    <message>
        <source>heading</source>
        <translation>orientación</translation>
    </message>
    <message>
        <source>speed</source>
        <translation>velocidad</translation>
    </message>
    <message>
        <source>radius</source>
        <translation>radio</translation>
    </message>
</context>
<context>
    <name>WrittenPose</name>
    <message>
        <source>Expected: %1</source>
        <translation>Se espera: %1</translation>
    </message>
    <message>
        <source>x, y [m], heading [°]</source>
        <translation>x, y [m], rumbo [°]</translation>
    </message>
</context>
<context>
    <name>hitos::window::AnchorDialog</name>
    <message>
        <source>Anchor to a drawing</source>
        <translation>Anclar a un dibujo</translation>
    </message>
    <message>
        <source>A wall</source>
        <translation>Una pared</translation>
    </message>
    <message>
        <source>A point</source>
        <translation>Un punto</translation>
    </message>
    <message>
        <source>What the scan and the drawing have in common</source>
        <translation>Lo que el barrido y el dibujo tienen en común</translation>
    </message>
    <message>
        <source>Drawing…</source>
        <translation>Dibujo…</translation>
    </message>
    <message>
        <source>A DXF drawing, a world, a reference map, or segments.txt of a run; coordinates can be written without any</source>
        <translation>Un dibujo DXF, un mundo, un mapa de referencia o el segments.txt de una ejecución; las coordenadas se pueden escribir sin ninguno</translation>
    </message>
    <message>
        <source>The unit of a DXF drawing</source>
        <translation>La unidad de un dibujo DXF</translation>
    </message>
    <message>
        <source>as the drawing says, else metres</source>
        <translation>la que dice el dibujo, si no metros</translation>
    </message>
    <message>
        <source>Drawing</source>
        <translation>Dibujo</translation>
    </message>
    <message>
        <source>Open a drawing, or write the coordinates below.</source>
        <translation>Abra un dibujo, o escriba debajo las coordenadas.</translation>
    </message>
    <message>
        <source>Scan</source>
        <translation>Barrido</translation>
    </message>
    <message>
        <source>No scan is shown.</source>
        <translation>No se muestra ningún barrido.</translation>
    </message>
    <message>
        <source>In the drawing</source>
        <translation>En el dibujo</translation>
    </message>
    <message>
        <source>In the scan</source>
        <translation>En el barrido</translation>
    </message>
    <message>
        <source>Anchor</source>
        <translation>Anclar</translation>
    </message>
    <message>
        <source>x, y [m] in the drawing&apos;s own coordinates</source>
        <translation>x, y [m] en las coordenadas propias del dibujo</translation>
    </message>
    <message>
        <source>x, y of the wall&apos;s left end and of its right end, as the robot sees it [m], in the drawing&apos;s own coordinates</source>
        <translation>x, y del extremo izquierdo de la pared y de su extremo derecho, vista desde el robot [m], en las coordenadas propias del dibujo</translation>
    </message>
    <message>
        <source>x ahead, y to the left [m], from the robot</source>
        <translation>x hacia delante, y hacia la izquierda [m], desde el robot</translation>
    </message>
    <message>
        <source>Direction of the wall, to the left of ahead [°]</source>
        <translation>Dirección de la pared, a la izquierda del frente [°]</translation>
    </message>
    <message>
        <source>x, y</source>
        <translation>x, y</translation>
    </message>
    <message>
        <source>x, y, x, y</source>
        <translation>x, y, x, y</translation>
    </message>
    <message>
        <source>ahead, left</source>
        <translation>delante, izquierda</translation>
    </message>
    <message>
        <source>direction</source>
        <translation>dirección</translation>
    </message>
    <message>
        <source>One anchor moves nothing yet. A second wall that is not parallel, or a second point, lays the drawing on the map; each further one bends the map.</source>
        <translation>Un ancla sola no mueve nada todavía. Una segunda pared que no sea paralela, o un segundo punto, coloca el dibujo sobre el mapa; cada una más dobla el mapa.</translation>
    </message>
    <message>
        <source>With this one and the ones before it the drawing will lie on the map, if they are not all parallel.</source>
        <translation>Con esta y las anteriores el dibujo quedará colocado sobre el mapa, si no son todas paralelas.</translation>
    </message>
    <message>
        <source>As the anchors so far lay the drawing, the point is %1 m off.</source>
        <translation>Tal como colocan el dibujo las anclas que hay, el punto se aparta %1 m.</translation>
    </message>
    <message>
        <source>As the anchors so far lay the drawing, the wall is %1 m off and turned by %2°.</source>
        <translation>Tal como colocan el dibujo las anclas que hay, la pared se aparta %1 m y está girada %2°.</translation>
    </message>
    <message>
        <source>This is another wall, or it was seen from its other side (space).</source>
        <translation>Es otra pared, o se vio desde el otro lado (espacio).</translation>
    </message>
    <message>
        <source>Let the run come to a scan first.</source>
        <translation>Deje primero que la ejecución llegue a un barrido.</translation>
    </message>
    <message>
        <source>The scan sees no straight wall of half a metre in that direction.</source>
        <translation>El barrido no ve ninguna pared recta de medio metro en esa dirección.</translation>
    </message>
    <message>
        <source>Choose a place of the drawing and the same place in scan %1.</source>
        <translation>Elija un sitio del dibujo y el mismo sitio en el barrido %1.</translation>
    </message>
    <message>
        <source>Choose a wall of the drawing, on the side where the robot stood, and the same wall in scan %1.</source>
        <translation>Elija una pared del dibujo, por el lado donde estaba el robot, y la misma pared en el barrido %1.</translation>
    </message>
    <message>
        <source>“%1” cannot be read; expected: %2</source>
        <translation>«%1» no se puede leer; se espera: %2</translation>
    </message>
</context>
<context>
    <name>hitos::window::Animation</name>
    <message>
        <source>%1 cannot be made: %2</source>
        <translation>No se puede crear %1: %2</translation>
    </message>
    <message>
        <source>Cancelled</source>
        <translation>Cancelado</translation>
    </message>
    <message>
        <source>neither ffmpeg nor ImageMagick&apos;s convert is installed</source>
        <translation>no está instalado ffmpeg ni convert de ImageMagick</translation>
    </message>
    <message>
        <source>%1 has failed: %2</source>
        <translation>%1 ha fallado: %2</translation>
    </message>
    <message>
        <source>%1 cannot be made; is it there already?</source>
        <translation>No se puede crear %1; ¿existe ya?</translation>
    </message>
</context>
<context>
    <name>hitos::window::AnimationDialog</name>
    <message>
        <source>Save animation: name of a new folder</source>
        <translation>Guardar animación: nombre de una carpeta nueva</translation>
    </message>
    <message>
        <source>%1 is there already; name a new folder.</source>
        <translation>%1 ya existe; dé el nombre de una carpeta nueva.</translation>
    </message>
    <message>
        <source>%1 frames saved: %2</source>
        <translation>%1 fotogramas guardados: %2</translation>
    </message>
    <message>
        <source>%1; no film: %2</source>
        <translation>%1; sin película: %2</translation>
    </message>
    <message>
        <source>%1, with %2</source>
        <translation>%1, con %2</translation>
    </message>
    <message>
        <source>Save animation</source>
        <translation>Guardar animación</translation>
    </message>
    <message>
        <source>Grid map</source>
        <translation>Mapa de rejilla</translation>
    </message>
    <message>
        <source>Last scan</source>
        <translation>Último barrido</translation>
    </message>
    <message>
        <source>View</source>
        <translation>Vista</translation>
    </message>
    <message>
        <source>From scan</source>
        <translation>Desde el barrido</translation>
    </message>
    <message>
        <source>To scan</source>
        <translation>Hasta el barrido</translation>
    </message>
    <message>
        <source>A frame every so many scans</source>
        <translation>Un fotograma cada tantos barridos</translation>
    </message>
    <message>
        <source>Frames a second</source>
        <translation>Fotogramas por segundo</translation>
    </message>
    <message>
        <source>%1 frames, %2 s</source>
        <translation>%1 fotogramas, %2 s</translation>
    </message>
    <message>
        <source>Writing the animation…</source>
        <translation>Escribiendo la animación…</translation>
    </message>
    <message>
        <source>Cancel</source>
        <translation>Cancelar</translation>
    </message>
    <message>
        <source>No animation was written.</source>
        <translation>No se ha escrito ninguna animación.</translation>
    </message>
    <message>
        <source>Making the film; the frames are there…</source>
        <translation>Haciendo la película; los fotogramas ya están…</translation>
    </message>
    <message>
        <source>Both, side by side</source>
        <translation>Las dos, una junto a otra</translation>
    </message>
    <message>
        <source>As on the screen</source>
        <translation>Como en la pantalla</translation>
    </message>
    <message>
        <source>At most %1 × %2 pixels</source>
        <translation>Como mucho %1 × %2 píxeles</translation>
    </message>
    <message>
        <source>Camera stands still, as it is now</source>
        <translation>Cámara quieta, como está ahora</translation>
    </message>
    <message>
        <source>Size</source>
        <translation>Tamaño</translation>
    </message>
</context>
<context>
    <name>hitos::window::AssociationInspector</name>
    <message>
        <source>Line</source>
        <translation>Recta</translation>
    </message>
    <message>
        <source>Corner</source>
        <translation>Esquina</translation>
    </message>
    <message>
        <source>Of particle</source>
        <translation>De la partícula</translation>
    </message>
    <message>
        <source>the best</source>
        <translation>la mejor</translation>
    </message>
    <message>
        <source>Features of the scan</source>
        <translation>Características del barrido</translation>
    </message>
    <message>
        <source>Landmarks it was compared with</source>
        <translation>Hitos con los que se comparó</translation>
    </message>
    <message>
        <source>Choose a feature here, or click one in the scan.</source>
        <translation>Elija una característica aquí, o pulse una en el barrido.</translation>
    </message>
    <message>
        <source>The numbers come when the run is stopped.</source>
        <translation>Los números aparecen al detener la ejecución.</translation>
    </message>
    <message>
        <source>Weighing the scan again…</source>
        <translation>Evaluando de nuevo el barrido…</translation>
    </message>
    <message>
        <source>This run cannot go back to weigh the scan again.</source>
        <translation>Esta ejecución no puede retroceder para evaluar de nuevo el barrido.</translation>
    </message>
    <message>
        <source>p0, of a new landmark: ln p0 = %1</source>
        <translation>p0, de un hito nuevo: ln p0 = %1</translation>
    </message>
    <message>
        <source>Gate: distance %1</source>
        <translation>Puerta: distancia %1</translation>
    </message>
    <message>
        <source>New from distance %1 on</source>
        <translation>Nuevo a partir de la distancia %1</translation>
    </message>
    <message>
        <source>It was merged with an older landmark then: it is none of its own.</source>
        <translation>Después se fundió con un hito anterior: no es uno propio.</translation>
    </message>
    <message>
        <source>Landmarks were merged at this scan: the numbers of those that it was compared with are of before.</source>
        <translation>En este barrido se fundieron hitos: los números de aquellos con que se comparó son los de antes.</translation>
    </message>
</context>
<context>
    <name>hitos::window::CandidateModel</name>
    <message>
        <source>Landmark</source>
        <translation>Hito</translation>
    </message>
    <message>
        <source>ν ρ / range</source>
        <translation>ν ρ / distancia</translation>
    </message>
    <message>
        <source>ν θ / bearing</source>
        <translation>ν θ / rumbo</translation>
    </message>
    <message>
        <source>Distance</source>
        <translation>Distancia</translation>
    </message>
    <message>
        <source>ln p</source>
        <translation>ln p</translation>
    </message>
    <message>
        <source>Standing</source>
        <translation>Situación</translation>
    </message>
</context>
<context>
    <name>hitos::window::CanvasView</name>
    <message>
        <source>Save as image…</source>
        <translation>Guardar como imagen…</translation>
    </message>
    <message>
        <source>Fit to window</source>
        <translation>Ajustar a la ventana</translation>
    </message>
    <message>
        <source>Zoom in</source>
        <translation>Acercar</translation>
    </message>
    <message>
        <source>Zoom out</source>
        <translation>Alejar</translation>
    </message>
    <message>
        <source>Copy picture</source>
        <translation>Copiar imagen</translation>
    </message>
    <message>
        <source>What is seen now</source>
        <translation>Lo que se ve ahora</translation>
    </message>
    <message>
        <source>The whole picture</source>
        <translation>La imagen entera</translation>
    </message>
</context>
<context>
    <name>hitos::window::CheckLine</name>
    <message>
        <source>Nothing is drawn yet.</source>
        <translation>Todavía no hay nada dibujado.</translation>
    </message>
    <message>
        <source>tour: too long to be driven while it is drawn</source>
        <translation>recorrido: demasiado largo para probarlo mientras se dibuja</translation>
    </message>
</context>
<context>
    <name>hitos::window::CompareWindow</name>
    <message>
        <source>Compare runs</source>
        <translation>Comparar ejecuciones</translation>
    </message>
    <message>
        <source>Side by side</source>
        <translation>Lado a lado</translation>
    </message>
    <message>
        <source>Overlaid</source>
        <translation>Superpuestas</translation>
    </message>
    <message>
        <source>Blinking</source>
        <translation>Alternadas</translation>
    </message>
    <message>
        <source>%1, odometry</source>
        <translation>%1, odometría</translation>
    </message>
    <message>
        <source>Left and right have the same configuration.</source>
        <translation>La izquierda y la derecha tienen la misma configuración.</translation>
    </message>
    <message>
        <source>The right one differs in: %1</source>
        <translation>La derecha se distingue en: %1</translation>
    </message>
    <message>
        <source>No grid map of %1: %2</source>
        <translation>Sin mapa de rejilla de la %1: %2</translation>
    </message>
    <message>
        <source>The logs differ: %1 and %2</source>
        <translation>Los registros difieren: %1 y %2</translation>
    </message>
    <message>
        <source>Figures</source>
        <translation>Cifras</translation>
    </message>
    <message>
        <source>no scans yet</source>
        <translation>aún sin barridos</translation>
    </message>
    <message>
        <source>the reference knows no pose at the times of its scans (%1)</source>
        <translation>la referencia no conoce ninguna pose en los tiempos de sus barridos (%1)</translation>
    </message>
    <message>
        <source>no reference trajectory of %1 is loaded; “File → Load reference trajectory…” takes one of the log in the window</source>
        <translation>no hay cargada ninguna trayectoria de referencia de %1; «Archivo → Cargar trayectoria de referencia…» toma una del registro de la ventana</translation>
    </message>
    <message>
        <source>How far all are from the reference trajectory</source>
        <translation>A qué distancia están todas de la trayectoria de referencia</translation>
    </message>
    <message>
        <source>Save as image…</source>
        <translation>Guardar como imagen…</translation>
    </message>
    <message>
        <source>Chosen as well, and left out: %1</source>
        <translation>Elegidas además, y dejadas fuera: %1</translation>
    </message>
    <message>
        <source>Reference</source>
        <translation>Referencia</translation>
    </message>
    <message>
        <source>%1 is not laid on the left one: it is of another log, or has none of its stamps.</source>
        <translation>%1 no se superpone a la izquierda: es de otro registro, o no tiene ninguno de sus instantes.</translation>
    </message>
</context>
<context>
    <name>hitos::window::ConfigurationActions</name>
    <message>
        <source>The configuration cannot be used</source>
        <translation>La configuración no se puede usar</translation>
    </message>
    <message>
        <source>The log cannot be used</source>
        <translation>El registro no se puede usar</translation>
    </message>
    <message>
        <source>Source loaded: %1</source>
        <translation>Origen cargado: %1</translation>
    </message>
    <message>
        <source>The configuration was not loaded</source>
        <translation>La configuración no se ha cargado</translation>
    </message>
    <message>
        <source>Load configuration</source>
        <translation>Cargar configuración</translation>
    </message>
    <message>
        <source>Replace the configuration by %1?</source>
        <translation>¿Reemplazar la configuración por %1?</translation>
    </message>
    <message>
        <source>The run starts from the beginning.</source>
        <translation>La ejecución empieza desde el principio.</translation>
    </message>
    <message>
        <source>Load</source>
        <translation>Cargar</translation>
    </message>
    <message>
        <source>Configuration loaded: %1</source>
        <translation>Configuración cargada: %1</translation>
    </message>
    <message>
        <source>Save configuration</source>
        <translation>Guardar configuración</translation>
    </message>
    <message>
        <source>Configurations (*.cfg);;All files (*)</source>
        <translation>Configuraciones (*.cfg);;Todos los archivos (*)</translation>
    </message>
    <message>
        <source>Configuration saved: %1</source>
        <translation>Configuración guardada: %1</translation>
    </message>
    <message>
        <source>The configuration has changed</source>
        <translation>La configuración ha cambiado</translation>
    </message>
    <message>
        <source>Set as default</source>
        <translation>Establecer como predeterminada</translation>
    </message>
    <message>
        <source>Start with this configuration from now on?</source>
        <translation>¿Empezar con esta configuración de ahora en adelante?</translation>
    </message>
    <message>
        <source>%1 is overwritten.</source>
        <translation>Se sobreescribe %1.</translation>
    </message>
    <message>
        <source>Default configuration written: %1</source>
        <translation>Configuración predeterminada escrita: %1</translation>
    </message>
    <message>
        <source>Load reference map</source>
        <translation>Cargar mapa de referencia</translation>
    </message>
    <message>
        <source>Maps (*.map *.txt);;All files (*)</source>
        <translation>Mapas (*.map *.txt);;Todos los archivos (*)</translation>
    </message>
    <message>
        <source>The reference was not loaded</source>
        <translation>La referencia no se ha cargado</translation>
    </message>
    <message>
        <source>Load reference trajectory</source>
        <translation>Cargar trayectoria de referencia</translation>
    </message>
    <message>
        <source>Trajectories (*.tum *.txt *.gz);;All files (*)</source>
        <translation>Trayectorias (*.tum *.txt *.gz);;Todos los archivos (*)</translation>
    </message>
    <message>
        <source>References removed</source>
        <translation>Referencias quitadas</translation>
    </message>
    <message>
        <source>Preset</source>
        <translation>Configuración incluida</translation>
    </message>
    <message>
        <source>The file begins:</source>
        <translation>El archivo empieza así:</translation>
    </message>
    <message>
        <source>Save as preset</source>
        <translation>Guardar como configuración propia</translation>
    </message>
    <message>
        <source>Source loaded: %1, %2</source>
        <translation>Origen cargado: %1, %2</translation>
    </message>
    <message>
        <source>1 scan</source>
        <translation>1 barrido</translation>
    </message>
    <message>
        <source>%1 scans</source>
        <translation>%1 barridos</translation>
    </message>
    <message>
        <source>Reference map: %1</source>
        <translation>Mapa de referencia: %1</translation>
    </message>
    <message>
        <source>1 landmark</source>
        <translation>1 hito</translation>
    </message>
    <message>
        <source>%1 landmarks</source>
        <translation>%1 hitos</translation>
    </message>
    <message>
        <source>Reference trajectory: %1</source>
        <translation>Trayectoria de referencia: %1</translation>
    </message>
    <message>
        <source>1 pose</source>
        <translation>1 pose</translation>
    </message>
    <message>
        <source>%1 poses</source>
        <translation>%1 poses</translation>
    </message>
    <message>
        <source>The reference is in doubt</source>
        <translation>La referencia es dudosa</translation>
    </message>
    <message>
        <source>Parameters: the defaults</source>
        <translation>Parámetros: los predeterminados</translation>
    </message>
    <message>
        <source>Parameters: %1, because this is a world</source>
        <translation>Parámetros: %1, porque esto es un mundo</translation>
    </message>
    <message>
        <source>Parameters: %1, because a robot recorded this log</source>
        <translation>Parámetros: %1, porque este registro lo grabó un robot</translation>
    </message>
    <message>
        <source>How the former one was read is not applied</source>
        <translation>No se aplica cómo se leía la anterior</translation>
    </message>
    <message>
        <source>The references, of the former log, are removed</source>
        <translation>Las referencias, del registro anterior, se han quitado</translation>
    </message>
    <message>
        <source>Undone, now: %1</source>
        <translation>Deshecho, ahora: %1</translation>
    </message>
    <message>
        <source>Redone, now: %1</source>
        <translation>Rehecho, ahora: %1</translation>
    </message>
    <message>
        <source>The graph is changed by hand; what follows is done again</source>
        <translation>El grafo está cambiado a mano; lo que sigue se hace de nuevo</translation>
    </message>
    <message>
        <source>The results of the map to go on with</source>
        <translation>Los resultados del mapa con el que seguir</translation>
    </message>
    <message>
        <source>There is no map to go on with</source>
        <translation>No hay mapa con el que seguir</translation>
    </message>
    <message>
        <source>Parameters: %1, because its sensor tells landmarks</source>
        <translation>Parámetros: %1, porque su sensor distingue hitos</translation>
    </message>
    <message>
        <source>Parameters: %1, because this is a world of trees</source>
        <translation>Parámetros: %1, porque esto es un mundo de árboles</translation>
    </message>
    <message>
        <source>The tour that comes in cannot be mapped</source>
        <translation>No se puede hacer el mapa del recorrido que llega</translation>
    </message>
    <message>
        <source>Maps what comes in: %1</source>
        <translation>Hace el mapa de lo que llega: %1</translation>
    </message>
    <message>
        <source>Parameters: %1, because this is a world with people</source>
        <translation>Parámetros: %1, porque es un mundo con personas</translation>
    </message>
    <message>
        <source>An option has no effect</source>
        <translation>Una opción no tiene efecto</translation>
    </message>
</context>
<context>
    <name>hitos::window::ConfigurationDialog</name>
    <message>
        <source>Manual configuration</source>
        <translation>Configuración manual</translation>
    </message>
    <message>
        <source>Values to correct: %1. Nothing changes until all are possible.</source>
        <translation>Valores por corregir: %1. Nada cambia hasta que todos sean posibles.</translation>
    </message>
    <message>
        <source>Values that differ from their default are marked. Nothing changes until you confirm.</source>
        <translation>Los valores distintos del predeterminado están marcados. Nada cambia hasta que confirme.</translation>
    </message>
    <message>
        <source>… and %1 more</source>
        <translation>… y %1 más</translation>
    </message>
    <message>
        <source>Search all parameters: name, key or what they do</source>
        <translation>Buscar en todos los parámetros: nombre, clave o lo que hacen</translation>
    </message>
    <message>
        <source>Fewer</source>
        <translation>Menos</translation>
    </message>
    <message>
        <source>%1 more</source>
        <translation>%1 más</translation>
    </message>
    <message>
        <source>No parameter has all of these words</source>
        <translation>Ningún parámetro tiene todas esas palabras</translation>
    </message>
    <message>
        <source>OK starts from the beginning with: %1</source>
        <translation>Aceptar empieza desde el principio con: %1</translation>
    </message>
</context>
<context>
    <name>hitos::window::ConnectDialog</name>
    <message>
        <source>%1 s</source>
        <translation>%1 s</translation>
    </message>
    <message>
        <source>Browse…</source>
        <translation>Examinar…</translation>
    </message>
    <message>
        <source>Connect to a robot</source>
        <translation>Conectar con un robot</translation>
    </message>
    <message>
        <source>ws://HOST:PORT, where foxglove_bridge answers on the robot, or the path of a log that another program is writing</source>
        <translation>ws://MÁQUINA:PUERTO, donde responde foxglove_bridge en el robot, o la ruta de un registro que otro programa está escribiendo</translation>
    </message>
    <message>
        <source>Address</source>
        <translation>Dirección</translation>
    </message>
    <message>
        <source>All that is received is kept there as it comes; the same map can be made of it again</source>
        <translation>Todo lo que se recibe se guarda ahí según llega; de ello se puede volver a hacer el mismo mapa</translation>
    </message>
    <message>
        <source>Keep in</source>
        <translation>Guardar en</translation>
    </message>
    <message>
        <source>Received</source>
        <translation>Recibido</translation>
    </message>
    <message>
        <source>Delay</source>
        <translation>Retraso</translation>
    </message>
    <message>
        <source>Lost</source>
        <translation>Perdido</translation>
    </message>
    <message>
        <source>What has happened</source>
        <translation>Qué ha pasado</translation>
    </message>
    <message>
        <source>robot-%1.mcap</source>
        <translation>robot-%1.mcap</translation>
    </message>
    <message>
        <source>Keep what is received</source>
        <translation>Guardar lo que se recibe</translation>
    </message>
    <message>
        <source>Recordings (*.mcap)</source>
        <translation>Grabaciones (*.mcap)</translation>
    </message>
    <message>
        <source>Disconnect</source>
        <translation>Desconectar</translation>
    </message>
    <message>
        <source>Connect</source>
        <translation>Conectar</translation>
    </message>
    <message>
        <source>%1, %2</source>
        <translation>%1, %2</translation>
    </message>
    <message>
        <source>1 scan</source>
        <translation>1 barrido</translation>
    </message>
    <message>
        <source>%1 scans</source>
        <translation>%1 barridos</translation>
    </message>
    <message>
        <source>%1, %2 wait</source>
        <translation>%1, esperan %2</translation>
    </message>
    <message>
        <source>the connection once</source>
        <translation>la conexión una vez</translation>
    </message>
    <message>
        <source>the connection %1 times</source>
        <translation>la conexión %1 veces</translation>
    </message>
    <message>
        <source>nothing</source>
        <translation>nada</translation>
    </message>
    <message>
        <source>Connecting…</source>
        <translation>Conectando…</translation>
    </message>
    <message>
        <source>The connection is lost and looked for again.</source>
        <translation>La conexión se ha perdido y se busca de nuevo.</translation>
    </message>
    <message>
        <source>There are several lasers or odometries: tick those to use.</source>
        <translation>Hay varios láseres u odometrías: marque los que se usan.</translation>
    </message>
    <message>
        <source>Waits: %1</source>
        <translation>Espera: %1</translation>
    </message>
    <message>
        <source>Scan %1 of %2, then the map begins.</source>
        <translation>Barrido %1 de %2; después empieza el mapa.</translation>
    </message>
    <message>
        <source>No scan for %1.</source>
        <translation>Ningún barrido desde hace %1.</translation>
    </message>
    <message>
        <source>The map grows with what comes in.</source>
        <translation>El mapa crece con lo que llega.</translation>
    </message>
    <message>
        <source>Disconnected.</source>
        <translation>Desconectado.</translation>
    </message>
    <message>
        <source>1 message passed over</source>
        <translation>1 mensaje pasado por alto</translation>
    </message>
    <message>
        <source>%1 messages passed over</source>
        <translation>%1 mensajes pasados por alto</translation>
    </message>
    <message>
        <source>Name the file in which what is received is to be kept.</source>
        <translation>Nombre el archivo en el que se ha de guardar lo que se recibe.</translation>
    </message>
    <message>
        <source>The connection was lost, and looked for in vain.</source>
        <translation>La conexión se perdió, y se buscó en vano.</translation>
    </message>
    <message>
        <source>What was received is in %1</source>
        <translation>Lo recibido está en %1</translation>
    </message>
    <message>
        <source>%1 is the log that this window runs. Name another file in which what is received is to be kept.</source>
        <translation>%1 es el registro que ejecuta esta ventana. Indique otro archivo en el que guardar lo que se recibe.</translation>
    </message>
    <message>
        <source>The run stands still; what comes in is kept, and mapped when it goes on.</source>
        <translation>La ejecución está detenida; lo que llega se guarda, y se cartografía cuando continúe.</translation>
    </message>
    <message>
        <source>What is received is kept in the file first, and mapped as it comes, with the parameters of this window.</source>
        <translation>Lo que se recibe se guarda primero en el archivo y se cartografía según llega, con los parámetros de esta ventana.</translation>
    </message>
    <message>
        <source>What was there before is kept in %1</source>
        <translation>Lo que había antes queda en %1</translation>
    </message>
    <message>
        <source>The log is mapped as it is written, with the parameters of this window.</source>
        <translation>El registro se cartografía según se escribe, con los parámetros de esta ventana.</translation>
    </message>
    <message>
        <source>What was mapped of it is in this window: its results can be saved.</source>
        <translation>Lo que se cartografió de él está en esta ventana: sus resultados se pueden guardar.</translation>
    </message>
</context>
<context>
    <name>hitos::window::CorrelationView</name>
    <message>
        <source>Robot</source>
        <translation>Robot</translation>
    </message>
    <message>
        <source>Lines</source>
        <translation>Rectas</translation>
    </message>
    <message>
        <source>Corners</source>
        <translation>Esquinas</translation>
    </message>
    <message>
        <source>Correlation %1</source>
        <translation>Correlación %1</translation>
    </message>
    <message>
        <source>Covariance %1</source>
        <translation>Covarianza %1</translation>
    </message>
</context>
<context>
    <name>hitos::window::DisturbBar</name>
    <message>
        <source>What happens</source>
        <translation>Qué ocurre</translation>
    </message>
    <message>
        <source>Now</source>
        <translation>Ahora</translation>
    </message>
    <message>
        <source>Let it happen to the robot now</source>
        <translation>Hacer que le ocurra al robot ahora</translation>
    </message>
</context>
<context>
    <name>hitos::window::DrawBar</name>
    <message>
        <source>Grid</source>
        <translation>Cuadrícula</translation>
    </message>
    <message>
        <source> m</source>
        <translation> m</translation>
    </message>
    <message>
        <source>none</source>
        <translation>ninguna</translation>
    </message>
    <message>
        <source>Points are drawn on multiples of it, unless ends, walls or right angles are nearer; with Shift a point is where the cursor is</source>
        <translation>Los puntos se dibujan en sus múltiplos, salvo que haya más cerca extremos, paredes o ángulos rectos; con Mayús un punto está donde el cursor</translation>
    </message>
</context>
<context>
    <name>hitos::window::DrawTool</name>
    <message>
        <source>%1 × %2 m</source>
        <translation>%1 × %2 m</translation>
    </message>
    <message>
        <source>%1 m, %2°</source>
        <translation>%1 m, %2°</translation>
    </message>
    <message>
        <source>Found a point at %1; expected one no further than %2 km from the origin.</source>
        <translation>El punto está en %1; se esperaba uno a no más de %2 km del origen.</translation>
    </message>
</context>
<context>
    <name>hitos::window::DrivePanel</name>
    <message>
        <source>Hold the clock</source>
        <translation>Parar el reloj</translation>
    </message>
    <message>
        <source>The world stands still until you let the clock go on</source>
        <translation>El mundo queda quieto hasta que deje seguir el reloj</translation>
    </message>
    <message>
        <source>Pace</source>
        <translation>Ritmo</translation>
    </message>
    <message>
        <source>real pace</source>
        <translation>ritmo real</translation>
    </message>
    <message>
        <source>%1 times as fast</source>
        <translation>%1 veces más rápido</translation>
    </message>
    <message>
        <source>Save a log…</source>
        <translation>Guardar un registro…</translation>
    </message>
    <message>
        <source>Writes what has been driven so far as a log, and the true path beside it; the tour goes on</source>
        <translation>Escribe lo conducido hasta ahora como registro, y a su lado la trayectoria verdadera; el recorrido sigue</translation>
    </message>
    <message>
        <source>End and keep the tour…</source>
        <translation>Terminar y guardar el recorrido…</translation>
    </message>
    <message>
        <source>Writes a world file that repeats the tour to the last bit, and maps it to its end</source>
        <translation>Escribe un archivo de mundo que repite el recorrido hasta el último bit, y lo procesa hasta el final</translation>
    </message>
    <message>
        <source>The driven tour was kept as %1</source>
        <translation>El recorrido conducido se ha guardado como %1</translation>
    </message>
    <message>
        <source>The log is written: %1, and the true path beside it</source>
        <translation>El registro está escrito: %1, y a su lado la trayectoria verdadera</translation>
    </message>
    <message>
        <source>The log was not written</source>
        <translation>No se ha escrito el registro</translation>
    </message>
    <message>
        <source>That cannot happen here</source>
        <translation>Eso no puede ocurrir aquí</translation>
    </message>
    <message>
        <source>Gamepad: %1</source>
        <translation>Mando: %1</translation>
    </message>
    <message>
        <source>%1. The left stick or the cross drives the robot, Start holds the clock.</source>
        <translation>%1. La palanca izquierda o la cruceta conducen el robot; Start para el reloj.</translation>
    </message>
    <message>
        <source>Keep the tour as a world</source>
        <translation>Guardar el recorrido como mundo</translation>
    </message>
    <message>
        <source>Worlds (*.toml)</source>
        <translation>Mundos (*.toml)</translation>
    </message>
    <message>
        <source>The tour is kept as %1</source>
        <translation>El recorrido se ha guardado como %1</translation>
    </message>
    <message>
        <source>Save a log; the true path goes beside it as NAME.truth.tum</source>
        <translation>Guardar un registro; la trayectoria verdadera queda a su lado como NOMBRE.truth.tum</translation>
    </message>
    <message>
        <source>%1 s, %2 m/s, %3 °/s</source>
        <translation>%1 s, %2 m/s, %3 °/s</translation>
    </message>
    <message>
        <source>The arrow keys or W, A, S, D drive the robot; a click is where it drives by itself. Line and dots are what the filter believes.</source>
        <translation>Las flechas o W, A, S, D conducen el robot; un clic es adonde va él solo. La línea y los puntos son lo que cree el filtro.</translation>
    </message>
    <message>
        <source>; scan %1: the estimate is off by %2 m and %3°</source>
        <translation>; barrido %1: la estimación se desvía %2 m y %3°</translation>
    </message>
    <message>
        <source>, NEES %1 (%2 to %3 where it is as sure as it may be)</source>
        <translation>, NEES %1 (de %2 a %3 si está tan seguro como puede estarlo)</translation>
    </message>
    <message>
        <source>The tour stands still</source>
        <translation>El recorrido está parado</translation>
    </message>
    <message>
        <source>A wall is in the way: the Down key or S backs off, a click on the free side leads away.</source>
        <translation>Una pared corta el paso: la flecha abajo o S da marcha atrás, un clic en el lado libre lo aleja.</translation>
    </message>
    <message>
        <source>A wall is behind: the Up key or W drives on.</source>
        <translation>Hay una pared detrás: la flecha arriba o W sigue adelante.</translation>
    </message>
</context>
<context>
    <name>hitos::window::EditList</name>
    <message>
        <source>Refused: scan %1 has not come back to %2</source>
        <translation>Rechazado: el barrido %1 no ha vuelto al %2</translation>
    </message>
    <message>
        <source>Closed: scan %1 has come back to %2</source>
        <translation>Cerrado: el barrido %1 ha vuelto al %2</translation>
    </message>
    <message>
        <source>Scan %1 is fixed</source>
        <translation>El barrido %1 está fijado</translation>
    </message>
    <message>
        <source>The step to scan %1 slipped</source>
        <translation>El paso al barrido %1 patinó</translation>
    </message>
    <message>
        <source>Changes by hand</source>
        <translation>Cambios a mano</translation>
    </message>
    <message>
        <source>Take back the change</source>
        <translation>Retirar el cambio</translation>
    </message>
    <message>
        <source>The odometry says nothing of the step to the scan that is shown: its wheels slipped, or somebody pushed the robot</source>
        <translation>La odometría no dice nada del paso al barrido que se muestra: las ruedas patinaron, o alguien empujó el robot</translation>
    </message>
    <message>
        <source>The step to %1 slipped</source>
        <translation>El paso a %1 patinó</translation>
    </message>
    <message>
        <source>The scan that is shown was made there: it stays, and the map bends</source>
        <translation>El barrido que se muestra se hizo ahí: se queda, y el mapa se dobla</translation>
    </message>
    <message>
        <source>x, y [m] and heading [°] in the map</source>
        <translation>x, y [m] y orientación [°] en el mapa</translation>
    </message>
    <message>
        <source>As before</source>
        <translation>Como antes</translation>
    </message>
    <message>
        <source>Shows the map as it was before the last change</source>
        <translation>Muestra el mapa como era antes del último cambio</translation>
    </message>
    <message>
        <source>Fix scan %1 at</source>
        <translation>Fijar el barrido %1 en</translation>
    </message>
    <message>
        <source>error %1 → %2 m</source>
        <translation>error %1 → %2 m</translation>
    </message>
    <message>
        <source>χ² %1 → %2</source>
        <translation>χ² %1 → %2</translation>
    </message>
    <message>
        <source>up to %1 m moved</source>
        <translation>movido hasta %1 m</translation>
    </message>
    <message>
        <source>Foreseen, the scans are taken anew: %1.</source>
        <translation>Previsto, los barridos se toman de nuevo: %1.</translation>
    </message>
    <message>
        <source>By the last change: %1.</source>
        <translation>Por el último cambio: %1.</translation>
    </message>
    <message>
        <source>Scan %1 is anchored to the point %2, %3 of the drawing</source>
        <translation>El barrido %1 está anclado al punto %2, %3 del dibujo</translation>
    </message>
    <message>
        <source>Anchor…</source>
        <translation>Anclar…</translation>
    </message>
    <message>
        <source>A wall or point of the scan that is shown is one of a drawing, or has known coordinates: the map bends to it</source>
        <translation>Una pared o un punto del barrido que se muestra es de un dibujo, o tiene coordenadas conocidas: el mapa se dobla hasta allí</translation>
    </message>
    <message>
        <source>Scan %1 is anchored to a wall of the drawing, seen at %2°</source>
        <translation>El barrido %1 está anclado a una pared del dibujo, vista a %2°</translation>
    </message>
</context>
<context>
    <name>hitos::window::ErrorStrip</name>
    <message>
        <source>; RPE per metre %1, %2 (RMSE)</source>
        <translation>; RPE por metro %1, %2 (RMSE)</translation>
    </message>
    <message>
        <source>; poses compared: %1</source>
        <translation>; poses comparadas: %1</translation>
    </message>
    <message>
        <source>Error along</source>
        <translation>Error a lo largo de</translation>
    </message>
    <message>
        <source>Over time</source>
        <translation>En el tiempo</translation>
    </message>
    <message>
        <source>By way</source>
        <translation>Por camino</translation>
    </message>
    <message>
        <source>Aligned</source>
        <translation>Alineadas</translation>
    </message>
    <message>
        <source>Save plot…</source>
        <translation>Guardar gráfica…</translation>
    </message>
    <message>
        <source>Distance from the reference [m]</source>
        <translation>Distancia a la referencia [m]</translation>
    </message>
    <message>
        <source>Way [m]</source>
        <translation>Camino recorrido [m]</translation>
    </message>
    <message>
        <source>Time [s]</source>
        <translation>Tiempo [s]</translation>
    </message>
    <message>
        <source>Path errors</source>
        <translation>Errores de las trayectorias</translation>
    </message>
    <message>
        <source>Copy picture</source>
        <translation>Copiar imagen</translation>
    </message>
    <message>
        <source>Save as image…</source>
        <translation>Guardar como imagen…</translation>
    </message>
    <message>
        <source>Each path is laid over the reference as well as possible, as for the ATE, and the maps over the left one likewise; else so that the first poses agree</source>
        <translation>Cada trayectoria se superpone a la referencia lo mejor posible, como para el ATE, y los mapas al de la izquierda igualmente; si no, de modo que coincidan las primeras poses</translation>
    </message>
    <message>
        <source>%1: ATE %2 (RMSE, aligned), mean %3, greatest %4</source>
        <translation>%1: ATE %2 (RMSE, alineado), media %3, máximo %4</translation>
    </message>
    <message>
        <source>; heading %1 (RMSE)</source>
        <translation>; orientación %1 (RMSE)</translation>
    </message>
    <message>
        <source>; the reference has no headings</source>
        <translation>; la referencia no tiene orientaciones</translation>
    </message>
</context>
<context>
    <name>hitos::window::ExportDialog</name>
    <message>
        <source>Save as image: %1</source>
        <translation>Guardar como imagen: %1</translation>
    </message>
    <message>
        <source>What</source>
        <translation>Qué</translation>
    </message>
    <message>
        <source>Format</source>
        <translation>Formato</translation>
    </message>
    <message>
        <source>Copy</source>
        <translation>Copiar</translation>
    </message>
    <message>
        <source>Pixels, as on the screen</source>
        <translation>Píxeles, como en la pantalla</translation>
    </message>
    <message>
        <source>Millimetres, for print</source>
        <translation>Milímetros, para imprimir</translation>
    </message>
    <message>
        <source>Size in</source>
        <translation>Tamaño en</translation>
    </message>
    <message>
        <source> pixels</source>
        <translation> píxeles</translation>
    </message>
    <message>
        <source>Width</source>
        <translation>Anchura</translation>
    </message>
    <message>
        <source> mm</source>
        <translation> mm</translation>
    </message>
    <message>
        <source>Width on paper</source>
        <translation>Anchura en papel</translation>
    </message>
    <message>
        <source> points</source>
        <translation> puntos</translation>
    </message>
    <message>
        <source>Letters on paper</source>
        <translation>Letras en papel</translation>
    </message>
    <message>
        <source> dots per inch</source>
        <translation> puntos por pulgada</translation>
    </message>
    <message>
        <source>Resolution</source>
        <translation>Resolución</translation>
    </message>
    <message>
        <source>none</source>
        <translation>ninguno</translation>
    </message>
    <message>
        <source>Title</source>
        <translation>Título</translation>
    </message>
    <message>
        <source>Axes in metres</source>
        <translation>Ejes en metros</translation>
    </message>
    <message>
        <source>Legend</source>
        <translation>Leyenda</translation>
    </message>
    <message>
        <source>Light ground</source>
        <translation>Fondo claro</translation>
    </message>
    <message>
        <source>Layers</source>
        <translation>Capas</translation>
    </message>
    <message>
        <source>%1 × %2 mm</source>
        <translation>%1 × %2 mm</translation>
    </message>
    <message>
        <source>%1 × %2 pixels</source>
        <translation>%1 × %2 píxeles</translation>
    </message>
</context>
<context>
    <name>hitos::window::FeatureModel</name>
    <message>
        <source>No.</source>
        <translation>N.º</translation>
    </message>
    <message>
        <source>Kind</source>
        <translation>Tipo</translation>
    </message>
    <message>
        <source>ρ / range</source>
        <translation>ρ / distancia</translation>
    </message>
    <message>
        <source>θ / bearing</source>
        <translation>θ / rumbo</translation>
    </message>
    <message>
        <source>Outcome</source>
        <translation>Resultado</translation>
    </message>
    <message>
        <source>Landmark %1</source>
        <translation>Hito %1</translation>
    </message>
</context>
<context>
    <name>hitos::window::FileMenus</name>
    <message>
        <source>Clear the list</source>
        <translation>Vaciar la lista</translation>
    </message>
</context>
<context>
    <name>hitos::window::Gamepad</name>
    <message>
        <source>without a name</source>
        <translation>sin nombre</translation>
    </message>
</context>
<context>
    <name>hitos::window::GraphChanges</name>
    <message>
        <source>Refused: the edges between %1 and %2</source>
        <translation>Rechazadas: las aristas entre %1 y %2</translation>
    </message>
    <message>
        <source>Closed: %1 seen from %2</source>
        <translation>Cerrado: %1 vista desde %2</translation>
    </message>
    <message>
        <source>Fixed: %1</source>
        <translation>Fijada: %1</translation>
    </message>
    <message>
        <source>Slipped: the step to %1</source>
        <translation>Patinó: el paso a %1</translation>
    </message>
    <message>
        <source>Changes by hand</source>
        <translation>Cambios a mano</translation>
    </message>
    <message>
        <source>Take back the change</source>
        <translation>Retirar el cambio</translation>
    </message>
    <message>
        <source>Another change of the same poses was given up for it: %1.</source>
        <translation>Se descartó por él otro cambio de las mismas poses: %1.</translation>
    </message>
    <message>
        <source>(%1 σ off)</source>
        <translation>(se aparta %1 σ)</translation>
    </message>
</context>
<context>
    <name>hitos::window::GraphHand</name>
    <message>
        <source>Pose A, by its id</source>
        <translation>Pose A, por su número</translation>
    </message>
    <message>
        <source>Pose B, by its id</source>
        <translation>Pose B, por su número</translation>
    </message>
    <message>
        <source>Refuse</source>
        <translation>Rechazar</translation>
    </message>
    <message>
        <source>Drops the edges between A and B</source>
        <translation>Quita las aristas entre A y B</translation>
    </message>
    <message>
        <source>Slip</source>
        <translation>Patinó</translation>
    </message>
    <message>
        <source>The step to A from the pose before it says next to nothing</source>
        <translation>El paso a A desde la pose anterior no dice casi nada</translation>
    </message>
    <message>
        <source>Close</source>
        <translation>Cerrar</translation>
    </message>
    <message>
        <source>An edge more: A is seen from B there, as sure as an eye is</source>
        <translation>Una arista más: A se ve ahí desde B, con la seguridad de un ojo</translation>
    </message>
    <message>
        <source>A seen from B: x, y [m] and heading [°]</source>
        <translation>A vista desde B: x, y [m] y rumbo [°]</translation>
    </message>
    <message>
        <source>Fix</source>
        <translation>Fijar</translation>
    </message>
    <message>
        <source>A is known to be there in the map</source>
        <translation>Se sabe que A está ahí en el mapa</translation>
    </message>
    <message>
        <source>A in the map: x, y [m] and heading [°]</source>
        <translation>A en el mapa: x, y [m] y rumbo [°]</translation>
    </message>
    <message>
        <source>The graph has no pose %1.</source>
        <translation>El grafo no tiene ninguna pose %1.</translation>
    </message>
</context>
<context>
    <name>hitos::window::GraphModel</name>
    <message>
        <source>From</source>
        <translation>De</translation>
    </message>
    <message>
        <source>To</source>
        <translation>A</translation>
    </message>
    <message>
        <source>Edge</source>
        <translation>Arista</translation>
    </message>
    <message>
        <source>Error [σ]</source>
        <translation>Error [σ]</translation>
    </message>
</context>
<context>
    <name>hitos::window::GraphView</name>
    <message>
        <source>Graph</source>
        <translation>Grafo</translation>
    </message>
    <message>
        <source>path, by the poses&apos; ids</source>
        <translation>camino, por los números de las poses</translation>
    </message>
    <message>
        <source>other edges between poses</source>
        <translation>otras aristas entre poses</translation>
    </message>
    <message>
        <source>landmarks seen</source>
        <translation>hitos vistos</translation>
    </message>
    <message>
        <source>landmarks</source>
        <translation>hitos</translation>
    </message>
    <message>
        <source>known places</source>
        <translation>lugares conocidos</translation>
    </message>
    <message>
        <source>fixed</source>
        <translation>fijo</translation>
    </message>
    <message>
        <source>greatest errors</source>
        <translation>errores mayores</translation>
    </message>
    <message>
        <source>The graph is being read…</source>
        <translation>Se está leyendo el grafo…</translation>
    </message>
</context>
<context>
    <name>hitos::window::GraphWindow</name>
    <message>
        <source>%1 – Graph</source>
        <translation>%1 – Grafo</translation>
    </message>
    <message>
        <source>Robust</source>
        <translation>Robusto</translation>
    </message>
    <message>
        <source>Edges far from the rest lose weight, as false ones are</source>
        <translation>Las aristas que se apartan del resto, como hacen las falsas, pierden peso</translation>
    </message>
    <message>
        <source>Greatest errors: </source>
        <translation>Errores mayores: </translation>
    </message>
    <message>
        <source>How many edges of the greatest errors are listed and marked</source>
        <translation>Cuántas aristas de los errores mayores se enumeran y se marcan</translation>
    </message>
    <message>
        <source>As in the file</source>
        <translation>Como en el archivo</translation>
    </message>
    <message>
        <source>Shows poses and landmarks where the file has them</source>
        <translation>Muestra poses e hitos donde los tiene el archivo</translation>
    </message>
    <message>
        <source>Undo</source>
        <translation>Deshacer</translation>
    </message>
    <message>
        <source>Redo</source>
        <translation>Rehacer</translation>
    </message>
    <message>
        <source>Open changes…</source>
        <translation>Abrir cambios…</translation>
    </message>
    <message>
        <source>Changes by hand from a file, in the place of those that are made</source>
        <translation>Cambios a mano de un archivo, en lugar de los que hay</translation>
    </message>
    <message>
        <source>Save…</source>
        <translation>Guardar…</translation>
    </message>
    <message>
        <source>Into a folder: the solved graph.g2o, its picture and its changes by hand (Ctrl+S)</source>
        <translation>En una carpeta: el graph.g2o resuelto, su imagen y sus cambios a mano (Ctrl+S)</translation>
    </message>
    <message>
        <source>Save as image…</source>
        <translation>Guardar como imagen…</translation>
    </message>
    <message>
        <source>Edges of the greatest errors</source>
        <translation>Aristas de los errores mayores</translation>
    </message>
    <message>
        <source>Close</source>
        <translation>Cerrar</translation>
    </message>
    <message>
        <source>Changes by hand</source>
        <translation>Cambios a mano</translation>
    </message>
    <message>
        <source>The graph was not opened</source>
        <translation>No se abrió el grafo</translation>
    </message>
    <message>
        <source>The graph was not solved</source>
        <translation>No se resolvió el grafo</translation>
    </message>
    <message>
        <source>The change was not made</source>
        <translation>No se hizo el cambio</translation>
    </message>
    <message>
        <source>Open changes</source>
        <translation>Abrir cambios</translation>
    </message>
    <message>
        <source>Changes by hand (*.txt);;All files (*)</source>
        <translation>Cambios a mano (*.txt);;Todos los archivos (*)</translation>
    </message>
    <message>
        <source>The changes were not opened</source>
        <translation>No se abrieron los cambios</translation>
    </message>
    <message>
        <source>Save graph: name of a new folder</source>
        <translation>Guardar grafo: nombre de una carpeta nueva</translation>
    </message>
    <message>
        <source>Graph saved: %1</source>
        <translation>Grafo guardado: %1</translation>
    </message>
    <message>
        <source>Close the graph without its changes by hand?</source>
        <translation>¿Cerrar el grafo sin sus cambios a mano?</translation>
    </message>
    <message>
        <source>They are written nowhere yet: “Save…” keeps them.</source>
        <translation>Todavía no están escritos en ninguna parte: «Guardar…» los conserva.</translation>
    </message>
    <message>
        <source>The graph is being read…</source>
        <translation>Se está leyendo el grafo…</translation>
    </message>
    <message>
        <source>Poses: %1, edges: %2.</source>
        <translation>Poses: %1, aristas: %2.</translation>
    </message>
    <message>
        <source>Passed over, and not written, for what they say is not known here: %1 of %2.</source>
        <translation>No se leen ni se escriben, porque aquí no se conoce lo que dicen: %1 de %2.</translation>
    </message>
    <message>
        <source>1 line</source>
        <translation>1 línea</translation>
    </message>
    <message>
        <source>%1 lines</source>
        <translation>%1 líneas</translation>
    </message>
    <message>
        <source>χ² %1 → %2, up to %3 m moved.</source>
        <translation>χ² %1 → %2, se movió hasta %3 m.</translation>
    </message>
    <message>
        <source>Nothing is fixed in %1 of %2 parts: one vertex of each is held, %3 first.</source>
        <translation>Nada está fijo en %1 de %2 partes: se retiene un vértice de cada una, primero %3.</translation>
    </message>
    <message>
        <source>Further steps would still move the graph: are edges false? “Robust” takes their weight from those that are far from the rest.</source>
        <translation>Más pasos aún moverían el grafo: ¿hay aristas falsas? «Robusto» quita peso a las que se apartan del resto.</translation>
    </message>
    <message>
        <source>At work…</source>
        <translation>Trabajando…</translation>
    </message>
    <message>
        <source>The last change (Ctrl+Z)</source>
        <translation>El último cambio (Ctrl+Z)</translation>
    </message>
    <message>
        <source>The change that was undone (Ctrl+Shift+Z)</source>
        <translation>El cambio deshecho (Ctrl+Mayús+Z)</translation>
    </message>
    <message>
        <source>Graph saved in %1.</source>
        <translation>Grafo guardado en %1.</translation>
    </message>
    <message>
        <source>χ² %1, foreseen; it is being solved from the beginning.</source>
        <translation>χ² %1, previsto; se está resolviendo desde el principio.</translation>
    </message>
</context>
<context>
    <name>hitos::window::GridView</name>
    <message>
        <source>The map grows here, step by step, from where the robot is believed to be.</source>
        <translation>Aquí crece el mapa, paso a paso, desde donde se cree que está el robot.</translation>
    </message>
    <message>
        <source>Grid map</source>
        <translation>Mapa de rejilla</translation>
    </message>
    <message>
        <source>The map for papers, as results have it (map.pdf)</source>
        <translation>El mapa para artículos, como en los resultados (map.pdf)</translation>
    </message>
    <message>
        <source>Uncertainty (%1 σ)</source>
        <translation>Incertidumbre (%1 σ)</translation>
    </message>
</context>
<context>
    <name>hitos::window::GuideWindow</name>
    <message>
        <source>User&apos;s guide</source>
        <translation>Guía del usuario</translation>
    </message>
    <message>
        <source>Page</source>
        <translation>Página</translation>
    </message>
    <message>
        <source>Contents</source>
        <translation>Contenido</translation>
    </message>
    <message>
        <source>Back</source>
        <translation>Atrás</translation>
    </message>
    <message>
        <source>Forward</source>
        <translation>Adelante</translation>
    </message>
    <message>
        <source>Search this page (Ctrl+F)</source>
        <translation>Buscar en esta página (Ctrl+F)</translation>
    </message>
    <message>
        <source>Search</source>
        <translation>Búsqueda</translation>
    </message>
    <message>
        <source>Return goes to the next place, Shift+Return to the one before</source>
        <translation>Intro va al sitio siguiente, Mayús+Intro al anterior</translation>
    </message>
    <message>
        <source>%1 is not installed.</source>
        <translation>%1 no está instalado.</translation>
    </message>
    <message>
        <source>not found</source>
        <translation>no se encuentra</translation>
    </message>
    <message>
        <source>found: %1</source>
        <translation>encontrados: %1</translation>
    </message>
    <message>
        <source>%1 of %2</source>
        <translation>%1 de %2</translation>
    </message>
</context>
<context>
    <name>hitos::window::HelpGuide</name>
    <message>
        <source>User&apos;s guide</source>
        <translation>Guía del usuario</translation>
    </message>
    <message>
        <source>docs/user-guide.md is not installed.</source>
        <translation>docs/user-guide.md no está instalado.</translation>
    </message>
</context>
<context>
    <name>hitos::window::HintBar</name>
    <message>
        <source>Close</source>
        <translation>Cerrar</translation>
    </message>
    <message>
        <source>Use “%1”</source>
        <translation>Usar «%1»</translation>
    </message>
    <message>
        <source>This recording looks wrong: %1</source>
        <translation>Esta grabación parece errónea: %1</translation>
    </message>
    <message>
        <source>(and %1 more)</source>
        <translation>(y %1 más)</translation>
    </message>
</context>
<context>
    <name>hitos::window::ImportDialog</name>
    <message>
        <source> m</source>
        <translation> m</translation>
    </message>
    <message>
        <source>Walls of %1</source>
        <translation>Paredes de %1</translation>
    </message>
    <message>
        <source>How long a side of a pixel is. The YAML file of map_server beside a picture says it: open that one instead, if there is one.</source>
        <translation>Cuánto mide el lado de un píxel. Lo dice el archivo YAML de map_server que acompaña a una imagen: si lo hay, abra ese en su lugar.</translation>
    </message>
    <message>
        <source>A pixel</source>
        <translation>Un píxel</translation>
    </message>
    <message>
        <source>0.05 m</source>
        <translation>0.05 m</translation>
    </message>
    <message>
        <source>two pixels</source>
        <translation>dos píxeles</translation>
    </message>
    <message>
        <source>How far a corner may lie from a line to be on it</source>
        <translation>A qué distancia de una línea puede estar una esquina para pertenecer a ella</translation>
    </message>
    <message>
        <source>How far a wall may lie from the middle of what is drawn; more gives fewer and straighter walls</source>
        <translation>A qué distancia puede estar una pared del medio de lo dibujado; más da menos paredes y más rectas</translation>
    </message>
    <message>
        <source>Tolerance</source>
        <translation>Tolerancia</translation>
    </message>
    <message>
        <source>Find the walls</source>
        <translation>Buscar las paredes</translation>
    </message>
    <message>
        <source>Looking for walls…</source>
        <translation>Buscando paredes…</translation>
    </message>
    <message>
        <source>; lines without two corners left out: %1</source>
        <translation>; líneas sin dos esquinas, omitidas: %1</translation>
    </message>
    <message>
        <source>Walls found: %1, tolerance %2</source>
        <translation>Paredes encontradas: %1, tolerancia %2</translation>
    </message>
    <message>
        <source>Walls found: %1</source>
        <translation>Paredes encontradas: %1</translation>
    </message>
    <message>
        <source>as the drawing says, else metres</source>
        <translation>la que dice el dibujo, si no metros</translation>
    </message>
    <message>
        <source>Unit</source>
        <translation>Unidad</translation>
    </message>
    <message>
        <source>all that are shown</source>
        <translation>todas las que se ven</translation>
    </message>
    <message>
        <source>The layers whose entities are walls, apart by commas</source>
        <translation>Las capas cuyas entidades son paredes, separadas por comas</translation>
    </message>
    <message>
        <source>Layers</source>
        <translation>Capas</translation>
    </message>
</context>
<context>
    <name>hitos::window::Inspection</name>
    <message>
        <source>Landmarks</source>
        <translation>Hitos</translation>
    </message>
    <message>
        <source>Particles</source>
        <translation>Partículas</translation>
    </message>
    <message>
        <source>Associations</source>
        <translation>Asociaciones</translation>
    </message>
    <message>
        <source>Joint covariance</source>
        <translation>Covarianza conjunta</translation>
    </message>
    <message>
        <source>Loops</source>
        <translation>Bucles</translation>
    </message>
</context>
<context>
    <name>hitos::window::JointCovariance</name>
    <message>
        <source>Joint covariance</source>
        <translation>Covarianza conjunta</translation>
    </message>
    <message>
        <source>Save as image…</source>
        <translation>Guardar como imagen…</translation>
    </message>
    <message>
        <source>Point at an entry to read it.</source>
        <translation>Señale una casilla para leerla.</translation>
    </message>
    <message>
        <source>%1 keeps no joint covariance of pose and landmarks.</source>
        <translation>%1 no lleva covarianza conjunta de la pose y los hitos.</translation>
    </message>
    <message>
        <source>It appears here once the algorithm runs.</source>
        <translation>Aparece aquí cuando se ejecuta el algoritmo.</translation>
    </message>
    <message>
        <source>Copy picture</source>
        <translation>Copiar imagen</translation>
    </message>
</context>
<context>
    <name>hitos::window::LandmarkModel</name>
    <message>
        <source>%1 (%2 s)</source>
        <translation>%1 (%2 s)</translation>
    </message>
    <message>
        <source>No.</source>
        <translation>N.º</translation>
    </message>
    <message>
        <source>Kind</source>
        <translation>Tipo</translation>
    </message>
    <message>
        <source>Corr.</source>
        <translation>Corr.</translation>
    </message>
    <message>
        <source>Observed</source>
        <translation>Observado</translation>
    </message>
    <message>
        <source>First seen</source>
        <translation>Visto primero</translation>
    </message>
    <message>
        <source>Last seen</source>
        <translation>Visto por última vez</translation>
    </message>
    <message>
        <source>Line</source>
        <translation>Recta</translation>
    </message>
    <message>
        <source>Corner</source>
        <translation>Esquina</translation>
    </message>
</context>
<context>
    <name>hitos::window::LandmarkTable</name>
    <message>
        <source>Landmarks</source>
        <translation>Hitos</translation>
    </message>
</context>
<context>
    <name>hitos::window::Layouts</name>
    <message>
        <source>Keep this layout…</source>
        <translation>Conservar esta disposición…</translation>
    </message>
    <message>
        <source>Forget a layout…</source>
        <translation>Olvidar una disposición…</translation>
    </message>
    <message>
        <source>Layouts</source>
        <translation>Disposiciones</translation>
    </message>
    <message>
        <source>Layout to forget:</source>
        <translation>Disposición que se olvida:</translation>
    </message>
    <message>
        <source>Name of this layout:</source>
        <translation>Nombre de esta disposición:</translation>
    </message>
    <message>
        <source>Replace the layout %1?</source>
        <translation>¿Reemplazar la disposición %1?</translation>
    </message>
    <message>
        <source>Replace</source>
        <translation>Reemplazar</translation>
    </message>
</context>
<context>
    <name>hitos::window::Legend</name>
    <message>
        <source>More…</source>
        <translation>Más…</translation>
    </message>
    <message>
        <source>All layers</source>
        <translation>Todas las capas</translation>
    </message>
</context>
<context>
    <name>hitos::window::LessonGuide</name>
    <message>
        <source>&amp;Lessons</source>
        <translation>&amp;Lecciones</translation>
    </message>
    <message>
        <source>Lesson %1</source>
        <translation>Lección %1</translation>
    </message>
    <message>
        <source>Lesson %1: %2</source>
        <translation>Lección %1: %2</translation>
    </message>
    <message>
        <source>Before: %1</source>
        <translation>Antes: %1</translation>
    </message>
    <message>
        <source>Next: %1</source>
        <translation>Siguiente: %1</translation>
    </message>
    <message>
        <source>Not possible at this moment</source>
        <translation>No es posible en este momento</translation>
    </message>
</context>
<context>
    <name>hitos::window::LoopModel</name>
    <message>
        <source>Scan</source>
        <translation>Barrido</translation>
    </message>
    <message>
        <source>Earlier</source>
        <translation>Anterior</translation>
    </message>
    <message>
        <source>Verdict</source>
        <translation>Veredicto</translation>
    </message>
    <message>
        <source>Score</source>
        <translation>Puntuación</translation>
    </message>
    <message>
        <source>Overlap</source>
        <translation>Solape</translation>
    </message>
    <message>
        <source>Looked through</source>
        <translation>Visto a través</translation>
    </message>
    <message>
        <source>Way between</source>
        <translation>Camino entre ambos</translation>
    </message>
    <message>
        <source>Moved</source>
        <translation>Movió</translation>
    </message>
    <message>
        <source>Weight</source>
        <translation>Peso</translation>
    </message>
    <message>
        <source>Off</source>
        <translation>Desvío</translation>
    </message>
</context>
<context>
    <name>hitos::window::LoopTable</name>
    <message>
        <source>Which places the table lists</source>
        <translation>Qué lugares enumera la tabla</translation>
    </message>
    <message>
        <source>Loops</source>
        <translation>Bucles</translation>
    </message>
    <message>
        <source>With these parameters scans are not registered, and no loops are looked for. The preset “Recorded tours” does both.</source>
        <translation>Con estos parámetros los barridos no se alinean, y no se buscan bucles. La configuración «Recorridos grabados» hace ambas cosas.</translation>
    </message>
    <message>
        <source>Take back</source>
        <translation>Retirar</translation>
    </message>
    <message>
        <source>Does not change this place by hand any more</source>
        <translation>Deja de cambiar este lugar a mano</translation>
    </message>
    <message>
        <source>Refuse</source>
        <translation>Rechazar</translation>
    </message>
    <message>
        <source>Takes this loop, and what was found beside it, out of the map</source>
        <translation>Saca del mapa este bucle, y lo que se encontró a su lado</translation>
    </message>
    <message>
        <source>Close</source>
        <translation>Cerrar</translation>
    </message>
    <message>
        <source>Closes this loop as both passages lie below</source>
        <translation>Cierra este bucle tal como las dos pasadas están abajo</translation>
    </message>
    <message>
        <source>score %1, overlap %2, looked through %3</source>
        <translation>puntuación %1, solape %2, visto a través %3</translation>
    </message>
    <message>
        <source>Fit</source>
        <translation>Ajustar</translation>
    </message>
    <message>
        <source>Lays the later passage on the walls of the earlier one, from where it lies below</source>
        <translation>Pone la pasada posterior sobre las paredes de la anterior, desde donde está abajo</translation>
    </message>
    <message>
        <source>Choose in the map</source>
        <translation>Elegir en el mapa</translation>
    </message>
    <message>
        <source>Two clicks into the map, on the later passage and on the earlier one, propose a loop</source>
        <translation>Dos pulsaciones en el mapa, sobre la pasada posterior y sobre la anterior, proponen un bucle</translation>
    </message>
    <message>
        <source>Scan %1</source>
        <translation>Barrido %1</translation>
    </message>
    <message>
        <source>came back to %1</source>
        <translation>volvió al %1</translation>
    </message>
    <message>
        <source>Go</source>
        <translation>Ir</translation>
    </message>
    <message>
        <source>The run goes to this scan</source>
        <translation>La ejecución va a este barrido</translation>
    </message>
    <message>
        <source>No scan has been registered yet.</source>
        <translation>Todavía no se ha alineado ningún barrido.</translation>
    </message>
    <message>
        <source>Fitted: %1.</source>
        <translation>Ajustado: %1.</translation>
    </message>
    <message>
        <source>Laid by hand; Fit lays it on the walls.</source>
        <translation>Puesta a mano; Ajustar la pone sobre las paredes.</translation>
    </message>
    <message>
        <source>As the path has both passages; drag the later one, or Fit it.</source>
        <translation>Como el camino tiene las dos pasadas; arrastre la posterior, o pulse Ajustar.</translation>
    </message>
    <message>
        <source>The earlier scan has to come before the other.</source>
        <translation>El barrido anterior tiene que venir antes que el otro.</translation>
    </message>
    <message>
        <source>Scan %1. Now click the other passage.</source>
        <translation>Barrido %1. Ahora pulse la otra pasada.</translation>
    </message>
    <message>
        <source>All places (%1)</source>
        <translation>Todos los lugares (%1)</translation>
    </message>
    <message>
        <source>Closed loops (%1)</source>
        <translation>Bucles cerrados (%1)</translation>
    </message>
    <message>
        <source>Refused (%1)</source>
        <translation>Rechazados (%1)</translation>
    </message>
    <message>
        <source>It fits nothing here: %1.</source>
        <translation>Aquí no encaja con nada: %1.</translation>
    </message>
</context>
<context>
    <name>hitos::window::LoopView</name>
    <message>
        <source>Both passages of the loop</source>
        <translation>Las dos pasadas del bucle</translation>
    </message>
    <message>
        <source>Choose a place: the scans of both passages stand here, one over the other.</source>
        <translation>Elija un lugar: aquí están los barridos de las dos pasadas, uno sobre otro.</translation>
    </message>
    <message>
        <source>scan %1</source>
        <translation>barrido %1</translation>
    </message>
</context>
<context>
    <name>hitos::window::MainWindow</name>
    <message>
        <source>Last scan</source>
        <translation>Último barrido</translation>
    </message>
    <message>
        <source>World frame (Ctrl+T)</source>
        <translation>Sistema del mundo (Ctrl+T)</translation>
    </message>
    <message>
        <source>Zoom out (-)</source>
        <translation>Alejar (-)</translation>
    </message>
    <message>
        <source>Zoom in (+)</source>
        <translation>Acercar (+)</translation>
    </message>
    <message>
        <source>Fit to window (F)</source>
        <translation>Ajustar a la ventana (F)</translation>
    </message>
    <message>
        <source>Save as image…</source>
        <translation>Guardar como imagen…</translation>
    </message>
    <message>
        <source>Grid map, step by step</source>
        <translation>Mapa de rejilla por pasos</translation>
    </message>
    <message>
        <source>Follow the robot (Ctrl+F)</source>
        <translation>Seguir al robot (Ctrl+F)</translation>
    </message>
    <message>
        <source>&amp;File</source>
        <translation>&amp;Archivo</translation>
    </message>
    <message>
        <source>Recent files</source>
        <translation>Archivos recientes</translation>
    </message>
    <message>
        <source>&amp;Configuration</source>
        <translation>&amp;Configuración</translation>
    </message>
    <message>
        <source>&amp;Run</source>
        <translation>&amp;Ejecución</translation>
    </message>
    <message>
        <source>&amp;View</source>
        <translation>&amp;Ver</translation>
    </message>
    <message>
        <source>Layers</source>
        <translation>Capas</translation>
    </message>
    <message>
        <source>Appearance</source>
        <translation>Apariencia</translation>
    </message>
    <message>
        <source>&amp;Help</source>
        <translation>A&amp;yuda</translation>
    </message>
    <message>
        <source>Select source…</source>
        <translation>Seleccionar Origen…</translation>
    </message>
    <message>
        <source>Choose the log and its type</source>
        <translation>Elegir el registro y su tipo</translation>
    </message>
    <message>
        <source>Save the view in use as an image</source>
        <translation>Guardar la vista en uso como imagen</translation>
    </message>
    <message>
        <source>Save all results…</source>
        <translation>Guardar todos los resultados…</translation>
    </message>
    <message>
        <source>Write map, trajectories, pictures and summary into a folder</source>
        <translation>Escribir mapa, trayectorias, imágenes y resumen en una carpeta</translation>
    </message>
    <message>
        <source>Load reference map…</source>
        <translation>Cargar mapa de referencia…</translation>
    </message>
    <message>
        <source>Compare the map with a known one</source>
        <translation>Comparar el mapa con uno conocido</translation>
    </message>
    <message>
        <source>Load reference trajectory…</source>
        <translation>Cargar trayectoria de referencia…</translation>
    </message>
    <message>
        <source>Compare the path with a known one (TUM format)</source>
        <translation>Comparar el camino con uno conocido (formato TUM)</translation>
    </message>
    <message>
        <source>Remove references</source>
        <translation>Quitar referencias</translation>
    </message>
    <message>
        <source>Compare map and path with nothing</source>
        <translation>No comparar mapa ni camino con nada</translation>
    </message>
    <message>
        <source>Exit</source>
        <translation>Salir</translation>
    </message>
    <message>
        <source>Manual configuration…</source>
        <translation>Configuración Manual…</translation>
    </message>
    <message>
        <source>Change the parameters</source>
        <translation>Cambiar los parámetros</translation>
    </message>
    <message>
        <source>Load configuration…</source>
        <translation>Cargar Configuración…</translation>
    </message>
    <message>
        <source>Save configuration…</source>
        <translation>Guardar Configuración…</translation>
    </message>
    <message>
        <source>Set as default…</source>
        <translation>Establecer como predeterminada…</translation>
    </message>
    <message>
        <source>Start with this configuration from now on</source>
        <translation>Empezar con esta configuración de ahora en adelante</translation>
    </message>
    <message>
        <source>Run</source>
        <translation>Ejecutar</translation>
    </message>
    <message>
        <source>Start or resume the algorithm (Space)</source>
        <translation>Iniciar o reanudar el algoritmo (Espacio)</translation>
    </message>
    <message>
        <source>Stop</source>
        <translation>Detener</translation>
    </message>
    <message>
        <source>Pause the algorithm (Space)</source>
        <translation>Pausar el algoritmo (Espacio)</translation>
    </message>
    <message>
        <source>Run 1 step</source>
        <translation>Ejecutar 1 paso</translation>
    </message>
    <message>
        <source>Process one scan (Right arrow)</source>
        <translation>Procesar un barrido (flecha derecha)</translation>
    </message>
    <message>
        <source>View best particle</source>
        <translation>Ver mejor partícula</translation>
    </message>
    <message>
        <source>Grid map of the best particle (B)</source>
        <translation>Mapa de rejilla de la mejor partícula (B)</translation>
    </message>
    <message>
        <source>View odometry</source>
        <translation>Ver Odometría</translation>
    </message>
    <message>
        <source>Grid map from odometry alone (O)</source>
        <translation>Mapa de rejilla solo con odometría (O)</translation>
    </message>
    <message>
        <source>Save best particle&apos;s map</source>
        <translation>Guardar Mapa Mejor Partícula</translation>
    </message>
    <message>
        <source>Write the landmarks to a file (Ctrl+Shift+S)</source>
        <translation>Escribir los hitos en un archivo (Ctrl+Mayús+S)</translation>
    </message>
    <message>
        <source>Restart</source>
        <translation>Reiniciar</translation>
    </message>
    <message>
        <source>Back to the beginning (Ctrl+R)</source>
        <translation>Volver al principio (Ctrl+R)</translation>
    </message>
    <message>
        <source>About Hitos</source>
        <translation>Acerca de Hitos</translation>
    </message>
    <message>
        <source>Keyboard</source>
        <translation>Teclado</translation>
    </message>
    <message>
        <source>User&apos;s guide</source>
        <translation>Guía del usuario</translation>
    </message>
    <message>
        <source>World frame</source>
        <translation>Sistema del mundo</translation>
    </message>
    <message>
        <source>Show the scan in the world&apos;s frame instead of the robot&apos;s</source>
        <translation>Mostrar el barrido en el sistema del mundo en vez del robot</translation>
    </message>
    <message>
        <source>Follow the robot</source>
        <translation>Seguir al robot</translation>
    </message>
    <message>
        <source>Keep the robot in the middle of the map</source>
        <translation>Mantener el robot en el centro del mapa</translation>
    </message>
    <message>
        <source>Plots</source>
        <translation>Gráficas</translation>
    </message>
    <message>
        <source>The run has failed</source>
        <translation>La ejecución ha fallado</translation>
    </message>
    <message>
        <source>Free software under the GNU GPL, version 3 or later.</source>
        <translation>Software libre bajo la GNU GPL, versión 3 o posterior.</translation>
    </message>
    <message>
        <source>run or stop</source>
        <translation>ejecutar o detener</translation>
    </message>
    <message>
        <source>one step</source>
        <translation>un paso</translation>
    </message>
    <message>
        <source>restart</source>
        <translation>reiniciar</translation>
    </message>
    <message>
        <source>data source, parameters</source>
        <translation>origen de datos, parámetros</translation>
    </message>
    <message>
        <source>load, save the configuration</source>
        <translation>cargar, guardar la configuración</translation>
    </message>
    <message>
        <source>plots</source>
        <translation>gráficas</translation>
    </message>
    <message>
        <source>world frame, follow the robot</source>
        <translation>sistema del mundo, seguir al robot</translation>
    </message>
    <message>
        <source>layers</source>
        <translation>capas</translation>
    </message>
    <message>
        <source>zoom, fit and move the view in use</source>
        <translation>acercar, ajustar y mover la vista en uso</translation>
    </message>
    <message>
        <source>Run several values of a parameter and compare the maps</source>
        <translation>Ejecutar varios valores de un parámetro y comparar los mapas</translation>
    </message>
    <message>
        <source>View one particle…</source>
        <translation>Ver una partícula…</translation>
    </message>
    <message>
        <source>Grid map of a particle by its number (P)</source>
        <translation>Mapa de rejilla de una partícula por su número (P)</translation>
    </message>
    <message>
        <source>&amp;Presets</source>
        <translation>Configuraciones &amp;incluidas</translation>
    </message>
    <message>
        <source>Save figures as CSV…</source>
        <translation>Guardar las cifras como CSV…</translation>
    </message>
    <message>
        <source>Write Neff, weights, landmarks, features, errors and time of every scan as a table</source>
        <translation>Escribir Neff, pesos, hitos, características, errores y tiempo de cada barrido como tabla</translation>
    </message>
    <message>
        <source>As fast as possible</source>
        <translation>Tan rápido como sea posible</translation>
    </message>
    <message>
        <source>As fast as possible (Ctrl+Space)</source>
        <translation>Tan rápido como sea posible (Ctrl+Espacio)</translation>
    </message>
    <message>
        <source>Run until…</source>
        <translation>Ejecutar hasta…</translation>
    </message>
    <message>
        <source>Run so many scans, to a scan or a time, or until something happens</source>
        <translation>Ejecutar tantos barridos, hasta un barrido o un instante, o hasta que ocurra algo</translation>
    </message>
    <message>
        <source>Language</source>
        <translation>Idioma</translation>
    </message>
    <message>
        <source>Undo</source>
        <translation>Deshacer</translation>
    </message>
    <message>
        <source>Back to the configuration before the last change</source>
        <translation>Volver a la configuración anterior al último cambio</translation>
    </message>
    <message>
        <source>Redo</source>
        <translation>Rehacer</translation>
    </message>
    <message>
        <source>Save as preset…</source>
        <translation>Guardar como configuración propia…</translation>
    </message>
    <message>
        <source>Keep this configuration among the presets</source>
        <translation>Guardar esta configuración en este menú</translation>
    </message>
    <message>
        <source>Configuration at a glance</source>
        <translation>Resumen de la configuración</translation>
    </message>
    <message>
        <source>Show the five groups above the views</source>
        <translation>Mostrar los cinco grupos encima de las vistas</translation>
    </message>
    <message>
        <source>undo, redo a change of the configuration</source>
        <translation>deshacer, rehacer un cambio de la configuración</translation>
    </message>
    <message>
        <source>configuration at a glance</source>
        <translation>resumen de la configuración</translation>
    </message>
    <message>
        <source>run until something happens</source>
        <translation>ejecutar hasta que ocurra algo</translation>
    </message>
    <message>
        <source>as fast as possible, or at the pace chosen</source>
        <translation>tan rápido como sea posible, o al ritmo elegido</translation>
    </message>
    <message>
        <source>Copy picture</source>
        <translation>Copiar imagen</translation>
    </message>
    <message>
        <source>Put the view in use into the clipboard as an image</source>
        <translation>Poner la vista en uso en el portapapeles como imagen</translation>
    </message>
    <message>
        <source>The picture is in the clipboard.</source>
        <translation>La imagen está en el portapapeles.</translation>
    </message>
    <message>
        <source>Compare runs</source>
        <translation>Comparar ejecuciones</translation>
    </message>
    <message>
        <source>Open results…</source>
        <translation>Abrir resultados…</translation>
    </message>
    <message>
        <source>A run from a folder that “Save all results” or hitos-cli run has written</source>
        <translation>Una ejecución de una carpeta escrita por «Guardar todos los resultados» o por hitos-cli run</translation>
    </message>
    <message>
        <source>View map</source>
        <translation>Ver mapa</translation>
    </message>
    <message>
        <source>Grid map by %1 (B)</source>
        <translation>Mapa de rejilla de %1 (B)</translation>
    </message>
    <message>
        <source>Save map</source>
        <translation>Guardar mapa</translation>
    </message>
    <message>
        <source>A workbench for landmark SLAM on recorded laser tours: FastSLAM, EKF-SLAM and graph-SLAM step by step, with every parameter at hand.</source>
        <translation>Un banco de trabajo para SLAM con hitos sobre recorridos láser grabados: FastSLAM, EKF-SLAM y Graph-SLAM paso a paso, con todos los parámetros a mano.</translation>
    </message>
    <message>
        <source>Measure a distance</source>
        <translation>Medir una distancia</translation>
    </message>
    <message>
        <source>Distance</source>
        <translation>Distancia</translation>
    </message>
    <message>
        <source>Click two walls, corners or places in a view (M)</source>
        <translation>Pulse dos paredes, esquinas o lugares en una vista (M)</translation>
    </message>
    <message>
        <source>Measure an angle</source>
        <translation>Medir un ángulo</translation>
    </message>
    <message>
        <source>Angle</source>
        <translation>Ángulo</translation>
    </message>
    <message>
        <source>Click two walls, or three corners or places in a view (Shift+M)</source>
        <translation>Pulse dos paredes, o tres esquinas o lugares en una vista (Mayús+M)</translation>
    </message>
    <message>
        <source>measure a distance, an angle</source>
        <translation>medir una distancia, un ángulo</translation>
    </message>
    <message>
        <source>what was measured</source>
        <translation>lo que se ha medido</translation>
    </message>
    <message>
        <source>compare runs, the list of runs</source>
        <translation>comparar ejecuciones, la lista de ellas</translation>
    </message>
    <message>
        <source>Measurements</source>
        <translation>Medidas</translation>
    </message>
    <message>
        <source>Save animation…</source>
        <translation>Guardar animación…</translation>
    </message>
    <message>
        <source>Write the run as pictures, one after the other, and as a film</source>
        <translation>Escribir la ejecución como imágenes, una tras otra, y como película</translation>
    </message>
    <message>
        <source>World workshop…</source>
        <translation>Taller de mundos…</translation>
    </message>
    <message>
        <source>Draw a world, drive a robot through it and see it mapped (Ctrl+D)</source>
        <translation>Dibujar un mundo, conducir un robot por él y verlo en el mapa (Ctrl+D)</translation>
    </message>
    <message>
        <source>draw a world, drive a robot through it</source>
        <translation>dibujar un mundo, conducir un robot por él</translation>
    </message>
    <message>
        <source>Look</source>
        <translation>Ver</translation>
    </message>
    <message>
        <source>Run kept</source>
        <translation>Ejecución guardada</translation>
    </message>
    <message>
        <source>Look at the run of %1 that was kept?</source>
        <translation>¿Ver la ejecución de %1 que se ha guardado?</translation>
    </message>
    <message>
        <source>Results are being written</source>
        <translation>Se escriben resultados</translation>
    </message>
    <message>
        <source>Close when all results are written?</source>
        <translation>¿Cerrar cuando estén escritos todos los resultados?</translation>
    </message>
    <message>
        <source>Until then the window stays open.</source>
        <translation>Hasta entonces la ventana sigue abierta.</translation>
    </message>
    <message>
        <source>Close then</source>
        <translation>Cerrar entonces</translation>
    </message>
    <message>
        <source>A double click shows this view alone (F11)</source>
        <translation>Un doble clic muestra solo esta vista (F11)</translation>
    </message>
    <message>
        <source>One view alone</source>
        <translation>Una vista sola</translation>
    </message>
    <message>
        <source>Only the view in use, as does a double click on its title (F11)</source>
        <translation>Solo la vista en uso, como un doble clic en su título (F11)</translation>
    </message>
    <message>
        <source>Views one above the other</source>
        <translation>Vistas una encima de otra</translation>
    </message>
    <message>
        <source>Legend</source>
        <translation>Leyenda</translation>
    </message>
    <message>
        <source>Name what the views draw, and switch it there</source>
        <translation>Nombrar lo que dibujan las vistas, y activarlo o quitarlo allí</translation>
    </message>
    <message>
        <source>one view alone, one above the other</source>
        <translation>una vista sola, una encima de otra</translation>
    </message>
    <message>
        <source>To the event before</source>
        <translation>Al suceso anterior</translation>
    </message>
    <message>
        <source>Back to the last scan with a mark below the time line: new landmarks, one seen again, a loop, a disturbance, damage</source>
        <translation>Atrás, al último barrido con una marca bajo la línea de tiempo: hitos nuevos, uno visto de nuevo, un bucle, una perturbación, daños</translation>
    </message>
    <message>
        <source>To the next event</source>
        <translation>Al suceso siguiente</translation>
    </message>
    <message>
        <source>On to the next scan with a mark below the time line, as far as the run has been</source>
        <translation>Adelante, al siguiente barrido con una marca bajo la línea de tiempo, hasta donde ha llegado la ejecución</translation>
    </message>
    <message>
        <source>First scan, before the run</source>
        <translation>Primer barrido, antes de ejecutar</translation>
    </message>
    <message>
        <source>to the event before, to the next (time line)</source>
        <translation>al suceso anterior, al siguiente (línea de tiempo)</translation>
    </message>
    <message>
        <source>Hitos was ended from outside after this long run, which was over on %1. With Cancel it stays where it is, for File → Open results. Its results are in %2.</source>
        <translation>Hitos se cerró desde fuera tras esta larga ejecución, que acabó el %1. Con Cancelar se queda donde está, para Archivo → Abrir resultados. Sus resultados están en %2.</translation>
    </message>
    <message>
        <source>Explain what has the keyboard</source>
        <translation>Explicar lo que tiene el teclado</translation>
    </message>
    <message>
        <source>explain what has the keyboard, list the keys</source>
        <translation>explicar lo que tiene el teclado, enumerar las teclas</translation>
    </message>
    <message>
        <source>Layouts</source>
        <translation>Disposiciones</translation>
    </message>
    <message>
        <source>Presenter mode</source>
        <translation>Modo de presentación</translation>
    </message>
    <message>
        <source>Large letters and one view, for a classroom</source>
        <translation>Letras grandes y una vista, para una clase</translation>
    </message>
    <message>
        <source>Study of parameters…</source>
        <translation>Estudio de parámetros…</translation>
    </message>
    <message>
        <source>study of parameters</source>
        <translation>estudio de parámetros</translation>
    </message>
    <message>
        <source>Set as in the study: %1. Undo takes it back</source>
        <translation>Puesto como en el estudio: %1. Deshacer lo quita</translation>
    </message>
    <message>
        <source>Runs, or a run and its odometry, side by side, overlaid or blinking</source>
        <translation>Ejecuciones, o una ejecución y su odometría, lado a lado, superpuestas o alternadas</translation>
    </message>
    <message>
        <source>Undo, back to: %1</source>
        <translation>Deshacer, de vuelta a: %1</translation>
    </message>
    <message>
        <source>Redo, on to: %1</source>
        <translation>Rehacer, de nuevo a: %1</translation>
    </message>
    <message>
        <source>As in the study already: %1</source>
        <translation>Ya como en el estudio: %1</translation>
    </message>
    <message>
        <source>loops: closed, refused, changed by hand</source>
        <translation>bucles: cerrados, rechazados, cambiados a mano</translation>
    </message>
    <message>
        <source>Go on with a map…</source>
        <translation>Seguir con un mapa…</translation>
    </message>
    <message>
        <source>Another tour in the map of a run that was saved: the robot is found in it, and follows it or maps on</source>
        <translation>Otro recorrido en el mapa de una ejecución guardada: se encuentra en él al robot, que lo sigue o continúa el mapa</translation>
    </message>
    <message>
        <source>Open graph…</source>
        <translation>Abrir grafo…</translation>
    </message>
    <message>
        <source>A graph of poses of any program (g2o), to be solved, changed by hand and written again</source>
        <translation>Un grafo de poses de cualquier programa (g2o), para resolverlo, cambiarlo a mano y volver a escribirlo</translation>
    </message>
    <message>
        <source>Open graph</source>
        <translation>Abrir grafo</translation>
    </message>
    <message>
        <source>Graphs of poses (*.g2o *.g2o.gz);;All files (*)</source>
        <translation>Grafos de poses (*.g2o *.g2o.gz);;Todos los archivos (*)</translation>
    </message>
    <message>
        <source>Drawing to anchor to</source>
        <translation>Dibujo al que anclar</translation>
    </message>
    <message>
        <source>All of them (*.dxf *.toml *.map *.txt);;Drawings (*.dxf);;Worlds (*.toml);;Maps and segments (*.map *.txt)</source>
        <translation>Todos ellos (*.dxf *.toml *.map *.txt);;Dibujos (*.dxf);;Mundos (*.toml);;Mapas y segmentos (*.map *.txt)</translation>
    </message>
    <message>
        <source>Connect to a robot…</source>
        <translation>Conectar con un robot…</translation>
    </message>
    <message>
        <source>Map what a running robot sees, or a log that is being written (Ctrl+Shift+N)</source>
        <translation>Hacer el mapa de lo que ve un robot en marcha, o de un registro que se está escribiendo (Ctrl+Mayús+N)</translation>
    </message>
    <message>
        <source>Newest scan, before the run</source>
        <translation>Barrido más reciente, antes de la ejecución</translation>
    </message>
    <message>
        <source>map as estimated, of one particle, as by the odometry</source>
        <translation>mapa estimado, de una partícula, según la odometría</translation>
    </message>
    <message>
        <source>save the map, all results</source>
        <translation>guardar el mapa, todos los resultados</translation>
    </message>
    <message>
        <source>save the view in use as an image, copy it</source>
        <translation>guardar la vista en uso como imagen, copiarla</translation>
    </message>
    <message>
        <source>map what a running robot sees</source>
        <translation>hacer el mapa de lo que ve un robot en marcha</translation>
    </message>
    <message>
        <source>presenter mode, for a classroom</source>
        <translation>modo de presentación, para el aula</translation>
    </message>
    <message>
        <source>tables of landmarks and particles</source>
        <translation>tablas de hitos y de partículas</translation>
    </message>
    <message>
        <source>why features were associated, joint covariance</source>
        <translation>por qué se asociaron las características, covarianza conjunta</translation>
    </message>
    <message>
        <source>quit</source>
        <translation>salir</translation>
    </message>
</context>
<context>
    <name>hitos::window::MapWindow</name>
    <message>
        <source>&amp;Stop</source>
        <translation>&amp;Detener</translation>
    </message>
    <message>
        <source>Save as &amp;image…</source>
        <translation>Guardar como &amp;imagen…</translation>
    </message>
    <message>
        <source>&amp;Close</source>
        <translation>&amp;Cerrar</translation>
    </message>
    <message>
        <source>Drawing the map…</source>
        <translation>Dibujando el mapa…</translation>
    </message>
    <message>
        <source>Stopped after %1 scans</source>
        <translation>Detenido tras %1 barridos</translation>
    </message>
    <message>
        <source>Map of %1 scans</source>
        <translation>Mapa de %1 barridos</translation>
    </message>
    <message>
        <source>&amp;Layers</source>
        <translation>Ca&amp;pas</translation>
    </message>
    <message>
        <source>Stopped after 1 scan</source>
        <translation>Detenido tras 1 barrido</translation>
    </message>
    <message>
        <source>Map of 1 scan</source>
        <translation>Mapa de 1 barrido</translation>
    </message>
    <message>
        <source>1 of them reaches beyond what a grid can hold</source>
        <translation>1 de ellos se sale de lo que cabe en una rejilla</translation>
    </message>
    <message>
        <source>%1 of them reach beyond what a grid can hold</source>
        <translation>%1 de ellos se salen de lo que cabe en una rejilla</translation>
    </message>
</context>
<context>
    <name>hitos::window::MeasureTool</name>
    <message>
        <source>Wall</source>
        <translation>Pared</translation>
    </message>
    <message>
        <source>Corner</source>
        <translation>Esquina</translation>
    </message>
    <message>
        <source>Click two walls, corners or places (Shift: any place); Esc ends.</source>
        <translation>Pulse dos paredes, esquinas o lugares (Mayús: cualquier lugar); Esc termina.</translation>
    </message>
    <message>
        <source>Click two walls, or three corners or places with the vertex second (Shift: any place); Esc ends.</source>
        <translation>Pulse dos paredes, o tres esquinas o lugares con el vértice en segundo lugar (Mayús: cualquier lugar); Esc termina.</translation>
    </message>
</context>
<context>
    <name>hitos::window::MeasurementModel</name>
    <message>
        <source>Angle of walls</source>
        <translation>Ángulo de paredes</translation>
    </message>
    <message>
        <source>Angle</source>
        <translation>Ángulo</translation>
    </message>
    <message>
        <source>Wall to wall</source>
        <translation>De pared a pared</translation>
    </message>
    <message>
        <source>Point to wall</source>
        <translation>De punto a pared</translation>
    </message>
    <message>
        <source>Point to point</source>
        <translation>De punto a punto</translation>
    </message>
    <message>
        <source>Name</source>
        <translation>Nombre</translation>
    </message>
    <message>
        <source>Kind</source>
        <translation>Tipo</translation>
    </message>
    <message>
        <source>True</source>
        <translation>Verdadero</translation>
    </message>
    <message>
        <source>Error</source>
        <translation>Error</translation>
    </message>
    <message>
        <source>Error %</source>
        <translation>Error %</translation>
    </message>
    <message>
        <source>The map has no such walls or corners there.</source>
        <translation>El mapa no tiene ahí tales paredes o esquinas.</translation>
    </message>
    <message>
        <source>Double click to write the true value; empty: the reference map&apos;s</source>
        <translation>Doble clic para escribir el valor verdadero; vacío: el del mapa de referencia</translation>
    </message>
    <message>
        <source>“%1” is no name: a word without commas, quotes and #, that no other row has.</source>
        <translation>«%1» no es un nombre: una palabra sin comas, comillas ni #, que no tenga ninguna otra fila.</translation>
    </message>
    <message>
        <source>“%1” is no angle from 0 to 180 degrees.</source>
        <translation>«%1» no es un ángulo de 0 a 180 grados.</translation>
    </message>
    <message>
        <source>“%1” is no distance in metres, at least 0.001.</source>
        <translation>«%1» no es una distancia en metros, de al menos 0,001.</translation>
    </message>
</context>
<context>
    <name>hitos::window::MeasurementTable</name>
    <message>
        <source>Remove</source>
        <translation>Quitar</translation>
    </message>
    <message>
        <source>Clear</source>
        <translation>Vaciar</translation>
    </message>
    <message>
        <source>Open…</source>
        <translation>Abrir…</translation>
    </message>
    <message>
        <source>Save…</source>
        <translation>Guardar…</translation>
    </message>
    <message>
        <source>Write the distances between walls as a file for hitos-cli --distances</source>
        <translation>Escribir las distancias entre paredes en un archivo para hitos-cli --distances</translation>
    </message>
    <message>
        <source>Measurements</source>
        <translation>Medidas</translation>
    </message>
    <message>
        <source>Mean error of %1: %2 m, %3 %</source>
        <translation>Error medio de %1: %2 m, %3 %</translation>
    </message>
    <message>
        <source>Clear the measurements</source>
        <translation>Vaciar las medidas</translation>
    </message>
    <message>
        <source>Forget all %1 measurements?</source>
        <translation>¿Olvidar las %1 medidas?</translation>
    </message>
    <message>
        <source>Open distances file</source>
        <translation>Abrir archivo de distancias</translation>
    </message>
    <message>
        <source>Distances (*.distances *.txt);;All files (*)</source>
        <translation>Distancias (*.distances *.txt);;Todos los archivos (*)</translation>
    </message>
    <message>
        <source>The file cannot be used</source>
        <translation>El archivo no se puede usar</translation>
    </message>
    <message>
        <source>Save as distances file</source>
        <translation>Guardar como archivo de distancias</translation>
    </message>
    <message>
        <source>%1; %2 without a true value, with what is measured now</source>
        <translation>%1; %2 sin valor verdadero, con lo que se mide ahora</translation>
    </message>
    <message>
        <source>%1 of %2 measurements, those between walls, saved: %3</source>
        <translation>%1 de %2 medidas, las que hay entre paredes, guardadas: %3</translation>
    </message>
</context>
<context>
    <name>hitos::window::NumberBoxes</name>
    <message>
        <source>Allowed: %1 to %2</source>
        <translation>Permitido: de %1 a %2</translation>
    </message>
</context>
<context>
    <name>hitos::window::PaceControl</name>
    <message>
        <source>recorded × %1</source>
        <translation>grabado × %1</translation>
    </message>
    <message>
        <source>%1 scans/s</source>
        <translation>%1 barridos/s</translation>
    </message>
    <message>
        <source>Speed</source>
        <translation>Velocidad</translation>
    </message>
    <message>
        <source>How fast the run goes: against the time of the recording, in scans, or as fast as possible (Ctrl+Space)</source>
        <translation>A qué velocidad avanza la ejecución: según el tiempo de la grabación, en barridos, o lo más rápido posible (Ctrl+Espacio)</translation>
    </message>
    <message>
        <source>maximum</source>
        <translation>máxima</translation>
    </message>
</context>
<context>
    <name>hitos::window::ParameterField</name>
    <message>
        <source>Allowed: %1</source>
        <translation>Permitido: %1</translation>
    </message>
    <message>
        <source>Default: %1</source>
        <translation>Predeterminado: %1</translation>
    </message>
    <message>
        <source>Whole numbers: %1</source>
        <translation>Números enteros: %1</translation>
    </message>
</context>
<context>
    <name>hitos::window::ParticleModel</name>
    <message>
        <source>No.</source>
        <translation>N.º</translation>
    </message>
    <message>
        <source>Weight</source>
        <translation>Peso</translation>
    </message>
    <message>
        <source>Weight now</source>
        <translation>Peso ahora</translation>
    </message>
    <message>
        <source>Drawn from</source>
        <translation>Procede de</translation>
    </message>
</context>
<context>
    <name>hitos::window::ParticleTable</name>
    <message>
        <source>Particles</source>
        <translation>Partículas</translation>
    </message>
    <message>
        <source>Grid map</source>
        <translation>Mapa de rejilla</translation>
    </message>
    <message>
        <source>Save map…</source>
        <translation>Guardar mapa…</translation>
    </message>
    <message>
        <source>Save path…</source>
        <translation>Guardar trayectoria…</translation>
    </message>
    <message>
        <source>%1 has no particles.</source>
        <translation>%1 no tiene partículas.</translation>
    </message>
</context>
<context>
    <name>hitos::window::Plots</name>
    <message>
        <source>Time [s]</source>
        <translation>Tiempo [s]</translation>
    </message>
    <message>
        <source>Effective particles (Neff)</source>
        <translation>Partículas efectivas (Neff)</translation>
    </message>
    <message>
        <source>Landmarks</source>
        <translation>Hitos</translation>
    </message>
    <message>
        <source>Best weight (ln)</source>
        <translation>Mejor peso (ln)</translation>
    </message>
    <message>
        <source>Time per step [ms]</source>
        <translation>Tiempo por paso [ms]</translation>
    </message>
    <message>
        <source>Landmark error [m]</source>
        <translation>Error de los hitos [m]</translation>
    </message>
    <message>
        <source>Trajectory error [m]</source>
        <translation>Error de la trayectoria [m]</translation>
    </message>
    <message>
        <source>Save as image…</source>
        <translation>Guardar como imagen…</translation>
    </message>
    <message>
        <source>Features in the scan</source>
        <translation>Características del barrido</translation>
    </message>
    <message>
        <source>Position error [m]</source>
        <translation>Error de posición [m]</translation>
    </message>
    <message>
        <source>Save the figures as CSV…</source>
        <translation>Guardar las cifras como CSV…</translation>
    </message>
    <message>
        <source>NEES of the pose (95 %: 0.2 … 9.3)</source>
        <translation>NEES de la pose (95 %: 0,2 … 9,3)</translation>
    </message>
    <message>
        <source>Copy picture</source>
        <translation>Copiar imagen</translation>
    </message>
    <message>
        <source>Plots</source>
        <translation>Gráficas</translation>
    </message>
</context>
<context>
    <name>hitos::window::ResultActions</name>
    <message>
        <source>Grid map of the best particle</source>
        <translation>Mapa de rejilla de la mejor partícula</translation>
    </message>
    <message>
        <source>Grid map based on odometry</source>
        <translation>Mapa de rejilla basado en odometría</translation>
    </message>
    <message>
        <source>Save best particle&apos;s map</source>
        <translation>Guardar Mapa Mejor Partícula</translation>
    </message>
    <message>
        <source>Maps (*.txt *.map);;Segments (*.seg);;CAD drawings (*.dxf);;All files (*)</source>
        <translation>Mapas (*.txt *.map);;Segmentos (*.seg);;Dibujos CAD (*.dxf);;Todos los archivos (*)</translation>
    </message>
    <message>
        <source>Map saved: %1</source>
        <translation>Mapa guardado: %1</translation>
    </message>
    <message>
        <source>Save all results: name of a new folder</source>
        <translation>Guardar todos los resultados: nombre de una carpeta nueva</translation>
    </message>
    <message>
        <source>Results saved: %1</source>
        <translation>Resultados guardados: %1</translation>
    </message>
    <message>
        <source>Image saved: %1</source>
        <translation>Imagen guardada: %1</translation>
    </message>
    <message>
        <source>Map of one particle</source>
        <translation>Mapa de una partícula</translation>
    </message>
    <message>
        <source>Number of the particle, 0 to %1:</source>
        <translation>Número de la partícula, de 0 a %1:</translation>
    </message>
    <message>
        <source>Grid map of particle %1</source>
        <translation>Mapa de rejilla de la partícula %1</translation>
    </message>
    <message>
        <source>%1; not written: %2</source>
        <translation>%1; sin escribir: %2</translation>
    </message>
    <message>
        <source>Save the figures of every scan</source>
        <translation>Guardar las cifras de cada barrido</translation>
    </message>
    <message>
        <source>Tables (*.csv)</source>
        <translation>Tablas (*.csv)</translation>
    </message>
    <message>
        <source>Figures saved: %1</source>
        <translation>Cifras guardadas: %1</translation>
    </message>
    <message>
        <source>Save the map of particle %1</source>
        <translation>Guardar el mapa de la partícula %1</translation>
    </message>
    <message>
        <source>Save the path of particle %1</source>
        <translation>Guardar la trayectoria de la partícula %1</translation>
    </message>
    <message>
        <source>Trajectories (*.tum);;All files (*)</source>
        <translation>Trayectorias (*.tum);;Todos los archivos (*)</translation>
    </message>
    <message>
        <source>Path saved: %1</source>
        <translation>Trayectoria guardada: %1</translation>
    </message>
    <message>
        <source>Grid map by %1</source>
        <translation>Mapa de rejilla de %1</translation>
    </message>
    <message>
        <source>Save map</source>
        <translation>Guardar mapa</translation>
    </message>
    <message>
        <source>Writing results: %1 (%2 of %3)</source>
        <translation>Escribiendo resultados: %1 (%2 de %3)</translation>
    </message>
    <message>
        <source>Writing results…</source>
        <translation>Escribiendo resultados…</translation>
    </message>
    <message>
        <source>The run has been further</source>
        <translation>La ejecución ha llegado más lejos</translation>
    </message>
    <message>
        <source>What to save:</source>
        <translation>Qué guardar:</translation>
    </message>
    <message>
        <source>As it is now, at scan %1</source>
        <translation>Como está ahora, en el barrido %1</translation>
    </message>
    <message>
        <source>As far as it came, at scan %1</source>
        <translation>Hasta donde llegó, en el barrido %1</translation>
    </message>
    <message>
        <source>What is shown is foreseen; the run is not there yet. Try again when it is.</source>
        <translation>Lo que se muestra está previsto; la ejecución aún no ha llegado. Pruebe de nuevo cuando esté.</translation>
    </message>
    <message>
        <source>The run is not at its end</source>
        <translation>La ejecución no está en su final</translation>
    </message>
    <message>
        <source>As it is at its end, scan %1</source>
        <translation>Como queda en su final, barrido %1</translation>
    </message>
    <message>
        <source>%1 is in that folder and of no run: it would be written over. Choose another folder.</source>
        <translation>%1 está en esa carpeta y no es de ninguna ejecución: se sobrescribiría. Elija otra carpeta.</translation>
    </message>
</context>
<context>
    <name>hitos::window::RunControls</name>
    <message>
        <source>a loop was closed</source>
        <translation>se cerró un bucle</translation>
    </message>
    <message>
        <source>new landmarks: %1</source>
        <translation>hitos nuevos: %1</translation>
    </message>
    <message>
        <source>a landmark seen again after %1 s</source>
        <translation>un hito visto de nuevo tras %1 s</translation>
    </message>
    <message>
        <source>resampled</source>
        <translation>remuestreo</translation>
    </message>
    <message>
        <source>another particle is the best</source>
        <translation>otra partícula es la mejor</translation>
    </message>
    <message>
        <source>damaged and skipped before it: %1</source>
        <translation>dañado y saltado antes: %1</translation>
    </message>
</context>
<context>
    <name>hitos::window::RunUntilDialog</name>
    <message>
        <source>Run until</source>
        <translation>Ejecutar hasta</translation>
    </message>
    <message>
        <source>The run stops at the first of these that is met.</source>
        <translation>La ejecución se detiene con la primera de estas condiciones que se cumpla.</translation>
    </message>
    <message>
        <source> s</source>
        <translation> s</translation>
    </message>
    <message>
        <source> m</source>
        <translation> m</translation>
    </message>
    <message>
        <source>so many scans further</source>
        <translation>tantos barridos más</translation>
    </message>
    <message>
        <source>this scan is reached, forwards or back</source>
        <translation>se llegue a este barrido, hacia delante o hacia atrás</translation>
    </message>
    <message>
        <source>this time of the tour is reached, forwards or back</source>
        <translation>se llegue a este instante del recorrido, hacia delante o hacia atrás</translation>
    </message>
    <message>
        <source>Neff falls below</source>
        <translation>Neff baje de</translation>
    </message>
    <message>
        <source>a landmark is born</source>
        <translation>nazca un hito</translation>
    </message>
    <message>
        <source>a landmark is seen again that was out of sight for</source>
        <translation>se vuelva a ver un hito no visto durante</translation>
    </message>
    <message>
        <source>registration closes a loop</source>
        <translation>la alineación de barridos cierre un bucle</translation>
    </message>
    <message>
        <source>another particle becomes the best</source>
        <translation>otra partícula pase a ser la mejor</translation>
    </message>
    <message>
        <source>the position error exceeds</source>
        <translation>el error de posición supere</translation>
    </message>
    <message>
        <source>Against the reference trajectory; both begin at the same place.</source>
        <translation>Respecto a la trayectoria de referencia; ambas empiezan en el mismo lugar.</translation>
    </message>
    <message>
        <source>Run</source>
        <translation>Ejecutar</translation>
    </message>
    <message>
        <source>There is no reference trajectory to measure against.</source>
        <translation>No hay trayectoria de referencia con la que medir.</translation>
    </message>
    <message>
        <source>%1 has no particles.</source>
        <translation>%1 no tiene partículas.</translation>
    </message>
    <message>
        <source>The tour is over: only scans and times before its end can be reached. Go back on the time line, or restart, for the others.</source>
        <translation>El recorrido ha terminado: solo se puede llegar a barridos y tiempos anteriores al final. Para lo demás, retroceda en la línea de tiempo o reinicie.</translation>
    </message>
</context>
<context>
    <name>hitos::window::Runs</name>
    <message>
        <source>Runs</source>
        <translation>Ejecuciones</translation>
    </message>
</context>
<context>
    <name>hitos::window::RunsModel</name>
    <message>
        <source>Run</source>
        <translation>Ejecución</translation>
    </message>
    <message>
        <source>Log</source>
        <translation>Registro</translation>
    </message>
    <message>
        <source>Different from this run</source>
        <translation>Diferencias con esta ejecución</translation>
    </message>
    <message>
        <source>Scans</source>
        <translation>Barridos</translation>
    </message>
    <message>
        <source>Landmarks</source>
        <translation>Hitos</translation>
    </message>
    <message>
        <source>Path error</source>
        <translation>Error del camino</translation>
    </message>
    <message>
        <source>Map error</source>
        <translation>Error del mapa</translation>
    </message>
    <message>
        <source>Time</source>
        <translation>Tiempo</translation>
    </message>
</context>
<context>
    <name>hitos::window::RunsPanel</name>
    <message>
        <source>Runs</source>
        <translation>Ejecuciones</translation>
    </message>
    <message>
        <source>Compare</source>
        <translation>Comparar</translation>
    </message>
    <message>
        <source>Use configuration</source>
        <translation>Usar configuración</translation>
    </message>
    <message>
        <source>Remove</source>
        <translation>Quitar</translation>
    </message>
    <message>
        <source>Open results…</source>
        <translation>Abrir resultados…</translation>
    </message>
    <message>
        <source>A folder that “Save all results” or hitos-cli run has written</source>
        <translation>Una carpeta escrita por «Guardar todos los resultados» o por hitos-cli run</translation>
    </message>
    <message>
        <source>Open a folder of results</source>
        <translation>Abrir una carpeta de resultados</translation>
    </message>
    <message>
        <source>The results were not opened</source>
        <translation>No se han abierto los resultados</translation>
    </message>
    <message>
        <source>Side by side, one over the other, or blinking; of up to six the errors</source>
        <translation>Lado a lado, superpuestas o alternadas; de hasta seis, los errores</translation>
    </message>
</context>
<context>
    <name>hitos::window::ScanView</name>
    <message>
        <source>The scan and what the algorithm makes of it appear here once it runs.</source>
        <translation>Aquí aparecen el barrido y lo que el algoritmo hace de él cuando se ejecuta.</translation>
    </message>
    <message>
        <source>Last scan</source>
        <translation>Último barrido</translation>
    </message>
</context>
<context>
    <name>hitos::window::SourceDialog</name>
    <message>
        <source>&amp;Type</source>
        <translation>&amp;Tipo</translation>
    </message>
    <message>
        <source>&amp;File</source>
        <translation>&amp;Archivo</translation>
    </message>
    <message>
        <source>&amp;Browse…</source>
        <translation>&amp;Examinar…</translation>
    </message>
    <message>
        <source>First lines</source>
        <translation>Primeras líneas</translation>
    </message>
    <message>
        <source>Open log</source>
        <translation>Abrir registro</translation>
    </message>
    <message>
        <source>Reading…</source>
        <translation>Leyendo…</translation>
    </message>
    <message>
        <source>The file holds odometry but not one readable scan.</source>
        <translation>El archivo contiene odometría pero ni un barrido legible.</translation>
    </message>
    <message>
        <source>Laser: %1 rays over %2°.</source>
        <translation>Láser: %1 rayos en %2°.</translation>
    </message>
    <message>
        <source>Logs and worlds (%1 *.gz *.toml);;All files (*)</source>
        <translation>Registros y mundos (%1 *.gz *.toml);;Todos los archivos (*)</translation>
    </message>
    <message>
        <source>World</source>
        <translation>Mundo</translation>
    </message>
    <message>
        <source>Path of a log or a ROS recording; files and folders can be dropped here</source>
        <translation>Ruta de un registro o de una grabación de ROS; se pueden soltar aquí archivos y carpetas</translation>
    </message>
    <message>
        <source>&amp;Laser topic</source>
        <translation>Tema del &amp;láser</translation>
    </message>
    <message>
        <source>The only one; or one, several with commas between them, or all</source>
        <translation>El único; o uno, varios separados por comas, o all</translation>
    </message>
    <message>
        <source>O&amp;dometry topic</source>
        <translation>Tema de la o&amp;dometría</translation>
    </message>
    <message>
        <source>The only one, else the transforms; or one, or tf</source>
        <translation>El único o, si no hay, las transformaciones; o uno, o tf</translation>
    </message>
    <message>
        <source>Choose a log: odometry and laser scans, as text, .gz or ROS recording.</source>
        <translation>Elija un registro: odometría y barridos láser, como texto, .gz o grabación de ROS.</translation>
    </message>
    <message>
        <source>Scans before the first odometry reading: %1. They are used as if the robot had stood still until then; “%2” in the configuration leaves them out.</source>
        <translation>Barridos anteriores a la primera lectura de odometría: %1. Se usan como si el robot hubiera estado parado hasta ella; «%2», en la configuración, los omite.</translation>
    </message>
    <message>
        <source>Scans before the first odometry reading, which are left out: %1.</source>
        <translation>Barridos anteriores a la primera lectura de odometría, que se omiten: %1.</translation>
    </message>
    <message>
        <source>Damaged messages or records that will be skipped: %1; the first is %2</source>
        <translation>Mensajes o partes dañados que se saltarán: %1; lo primero es el %2</translation>
    </message>
    <message>
        <source>Damaged lines that will be skipped: %1; the first is %2</source>
        <translation>Líneas dañadas que se saltarán: %1; la primera es la %2</translation>
    </message>
    <message>
        <source>Topics</source>
        <translation>Temas</translation>
    </message>
    <message>
        <source>Set how it is read</source>
        <translation>Ajustar cómo se lee</translation>
    </message>
    <message>
        <source>Clocks, the laser&apos;s place, ranges and what else is put right</source>
        <translation>Relojes, posición del láser, alcances y demás correcciones</translation>
    </message>
    <message>
        <source>%1: %2, %3, %4 s, %5 m.</source>
        <translation>%1: %2, %3, %4 s, %5 m.</translation>
    </message>
    <message>
        <source>1 scan</source>
        <translation>1 barrido</translation>
    </message>
    <message>
        <source>%1 scans</source>
        <translation>%1 barridos</translation>
    </message>
    <message>
        <source>1 odometry reading</source>
        <translation>1 lectura de odometría</translation>
    </message>
    <message>
        <source>%1 odometry readings</source>
        <translation>%1 lecturas de odometría</translation>
    </message>
    <message>
        <source>Set %1</source>
        <translation>Poner %1</translation>
    </message>
    <message>
        <source>Select source</source>
        <translation>Selección de origen</translation>
    </message>
    <message>
        <source>The recording has several lasers or odometries: write above which ones to use, or tick them below.</source>
        <translation>La grabación tiene varios láseres u odometrías: escriba arriba cuáles se usan, o márquelos abajo.</translation>
    </message>
    <message>
        <source>%1, %2 of them the map&apos;s</source>
        <translation>%1, %2 de ellos del mapa</translation>
    </message>
</context>
<context>
    <name>hitos::window::StartBar</name>
    <message>
        <source>Run the ready tour</source>
        <translation>Ejecutar el recorrido de muestra</translation>
    </message>
    <message>
        <source>A simulated robot with noisy odometry, open below (Space)</source>
        <translation>Un robot simulado con odometría ruidosa, abierto abajo (espacio)</translation>
    </message>
    <message>
        <source>Open a log of mine…</source>
        <translation>Abrir un registro mío…</translation>
    </message>
    <message>
        <source>Player, CARMEN, ROS bag or MCAP, text (Ctrl+O)</source>
        <translation>Player, CARMEN, bag o MCAP de ROS, texto (Ctrl+O)</translation>
    </message>
    <message>
        <source>Draw a world</source>
        <translation>Dibujar un mundo</translation>
    </message>
    <message>
        <source>Walls by hand, and a robot driven through them (Ctrl+D)</source>
        <translation>Paredes a mano y un robot conducido entre ellas (Ctrl+D)</translation>
    </message>
    <message>
        <source>Close</source>
        <translation>Cerrar</translation>
    </message>
</context>
<context>
    <name>hitos::window::StatusLine</name>
    <message>
        <source>Scan %1 of %2</source>
        <translation>Barrido %1 de %2</translation>
    </message>
    <message>
        <source>Time %1 s</source>
        <translation>Tiempo %1 s</translation>
    </message>
    <message>
        <source>%1 steps/s</source>
        <translation>%1 pasos/s</translation>
    </message>
    <message>
        <source>Neff %1</source>
        <translation>Neff %1</translation>
    </message>
    <message>
        <source>No data source</source>
        <translation>Sin origen de datos</translation>
    </message>
    <message>
        <source>Ready</source>
        <translation>Listo</translation>
    </message>
    <message>
        <source>Running</source>
        <translation>Ejecutando</translation>
    </message>
    <message>
        <source>Stopped</source>
        <translation>Detenido</translation>
    </message>
    <message>
        <source>End of the log</source>
        <translation>Fin del registro</translation>
    </message>
    <message>
        <source>Failed</source>
        <translation>Fallo</translation>
    </message>
    <message>
        <source>Scan %1</source>
        <translation>Barrido %1</translation>
    </message>
    <message>
        <source>Try Configuration → Presets → %1.</source>
        <translation>Pruebe Configuración → Configuraciones incluidas → %1.</translation>
    </message>
    <message>
        <source>Stopped at the time asked for.</source>
        <translation>Detenido en el instante pedido.</translation>
    </message>
    <message>
        <source>Stopped: Neff fell to %1.</source>
        <translation>Detenido: Neff ha bajado a %1.</translation>
    </message>
    <message>
        <source>Stopped: a landmark was born.</source>
        <translation>Detenido: ha nacido un hito.</translation>
    </message>
    <message>
        <source>Stopped: a landmark was seen again.</source>
        <translation>Detenido: se ha vuelto a ver un hito.</translation>
    </message>
    <message>
        <source>Stopped: a loop was closed.</source>
        <translation>Detenido: se ha cerrado un bucle.</translation>
    </message>
    <message>
        <source>Stopped: another particle is the best.</source>
        <translation>Detenido: otra partícula es la mejor.</translation>
    </message>
    <message>
        <source>Stopped: the position error has passed its limit.</source>
        <translation>Detenido: el error de posición ha superado su límite.</translation>
    </message>
    <message>
        <source>Landmarks %1</source>
        <translation>Hitos %1</translation>
    </message>
    <message>
        <source>Lines %1, corners %2</source>
        <translation>Rectas %1, esquinas %2</translation>
    </message>
    <message>
        <source>Skipped %1</source>
        <translation>Saltado %1</translation>
    </message>
    <message>
        <source>List what is damaged</source>
        <translation>Listar lo dañado</translation>
    </message>
    <message>
        <source>Said last:</source>
        <translation>Lo último que se dijo:</translation>
    </message>
    <message>
        <source>Connection lost</source>
        <translation>Conexión perdida</translation>
    </message>
    <message>
        <source>Live, %1 s behind</source>
        <translation>En vivo, %1 s de retraso</translation>
    </message>
    <message>
        <source>Live, no scan for %1 s</source>
        <translation>En vivo, sin barridos desde hace %1 s</translation>
    </message>
    <message>
        <source>Live</source>
        <translation>En vivo</translation>
    </message>
    <message>
        <source>Stopped, connection lost</source>
        <translation>Detenido, conexión perdida</translation>
    </message>
    <message>
        <source>Stopped, the tour goes on</source>
        <translation>Parado, el recorrido sigue</translation>
    </message>
    <message>
        <source>Found in the map after %1 m, at scan %2</source>
        <translation>Encontrado en el mapa tras %1 m, en el barrido %2</translation>
    </message>
</context>
<context>
    <name>hitos::window::StudyDialog</name>
    <message>
        <source>With the other parameters as they are set in the main window.</source>
        <translation>Con los demás parámetros como están en la ventana principal.</translation>
    </message>
    <message>
        <source>&amp;Parameter</source>
        <translation>&amp;Parámetro</translation>
    </message>
    <message>
        <source>What is varied: a parameter of the thesis, any other one by its key, or keys joined by +</source>
        <translation>Lo que se varía: un parámetro de la tesis, cualquier otro por su clave, o claves unidas por +</translation>
    </message>
    <message>
        <source>&amp;Values</source>
        <translation>&amp;Valores</translation>
    </message>
    <message>
        <source>0.01, 0.02 or 0.01:0.05:0.01</source>
        <translation>0.01; 0.02 o 0.01:0.05:0.01</translation>
    </message>
    <message>
        <source>Values with commas between them, and ranges from:to:step</source>
        <translation>Valores separados por comas y rangos desde:hasta:paso</translation>
    </message>
    <message>
        <source>&amp;Runs per value</source>
        <translation>&amp;Ejecuciones/valor</translation>
    </message>
    <message>
        <source>Each with a seed of its own, one after the other</source>
        <translation>Cada una con su propia semilla, una tras otra</translation>
    </message>
    <message>
        <source>First &amp;seed</source>
        <translation>Primera &amp;semilla</translation>
    </message>
    <message>
        <source>Odometry &amp;noise</source>
        <translation>R&amp;uido odométrico</translation>
    </message>
    <message>
        <source>Every run gets noise of its own on its odometry, drawn with its seed; the thesis uses 0.1</source>
        <translation>Cada ejecución recibe su propio ruido en la odometría, sorteado con su semilla; la tesis usa 0.1</translation>
    </message>
    <message>
        <source>none</source>
        <translation>ninguno</translation>
    </message>
    <message>
        <source>How level and speed give the noise</source>
        <translation>Cómo dan el ruido el nivel y la velocidad</translation>
    </message>
    <message>
        <source>&amp;Threads</source>
        <translation>&amp;Hilos</translation>
    </message>
    <message>
        <source>Runs at a time; the results do not depend on it</source>
        <translation>Ejecuciones a la vez; los resultados no dependen de ello</translation>
    </message>
    <message>
        <source>Reference &amp;map</source>
        <translation>&amp;Mapa de referencia</translation>
    </message>
    <message>
        <source>Browse…</source>
        <translation>Examinar…</translation>
    </message>
    <message>
        <source>Results &amp;folder</source>
        <translation>&amp;Carpeta</translation>
    </message>
    <message>
        <source>Tables, plots and the map of every run are written here; a study that was stopped goes on from it</source>
        <translation>Aquí se escriben tablas, gráficas y el mapa de cada ejecución; un estudio detenido continúa a partir de ella</translation>
    </message>
    <message>
        <source>Save plot…</source>
        <translation>Guardar gráfica…</translation>
    </message>
    <message>
        <source>Open folder</source>
        <translation>Abrir carpeta</translation>
    </message>
    <message>
        <source>Stop</source>
        <translation>Detener</translation>
    </message>
    <message>
        <source>Start</source>
        <translation>Comenzar</translation>
    </message>
    <message>
        <source>Close</source>
        <translation>Cerrar</translation>
    </message>
    <message>
        <source>Stopping…</source>
        <translation>Deteniendo…</translation>
    </message>
    <message>
        <source>The folder holds a study</source>
        <translation>La carpeta contiene un estudio</translation>
    </message>
    <message>
        <source>Write into %1?</source>
        <translation>¿Escribir en %1?</translation>
    </message>
    <message>
        <source>Write</source>
        <translation>Escribir</translation>
    </message>
    <message>
        <source>Nothing starts until all fields are possible.</source>
        <translation>Nada comienza hasta que todos los campos sean posibles.</translation>
    </message>
    <message>
        <source>Reading the log…</source>
        <translation>Leyendo el registro…</translation>
    </message>
    <message>
        <source>Run %1 of %2: %3</source>
        <translation>Ejecución %1 de %2: %3</translation>
    </message>
    <message>
        <source>done before: %1</source>
        <translation>hechas antes: %1</translation>
    </message>
    <message>
        <source>failed: %1</source>
        <translation>fallidas: %1</translation>
    </message>
    <message>
        <source>Stopped; runs done: %1 of %2. Start goes on where it was.</source>
        <translation>Detenido; ejecuciones hechas: %1 de %2. Comenzar continúa donde estaba.</translation>
    </message>
    <message>
        <source>Runs done: %1 of %2, in %3 s. Results: %4</source>
        <translation>Ejecuciones hechas: %1 de %2, en %3 s. Resultados: %4</translation>
    </message>
    <message>
        <source>Runs failed: %1; the first: %2</source>
        <translation>Ejecuciones fallidas: %1; la primera: %2</translation>
    </message>
    <message>
        <source>No picture files of the plots: %1</source>
        <translation>Sin imágenes de las gráficas: %1</translation>
    </message>
    <message>
        <source>A study is under way</source>
        <translation>Hay un estudio en marcha</translation>
    </message>
    <message>
        <source>Stop the study?</source>
        <translation>¿Detener el estudio?</translation>
    </message>
    <message>
        <source>Runs that are done stay in its folder; started again, it goes on from there.</source>
        <translation>Las ejecuciones hechas quedan en su carpeta; al comenzar de nuevo, continúa a partir de ellas.</translation>
    </message>
    <message>
        <source>Stop the study</source>
        <translation>Detener el estudio</translation>
    </message>
    <message>
        <source>Plot saved: %1</source>
        <translation>Gráfica guardada: %1</translation>
    </message>
    <message>
        <source>The true landmarks, to measure every map against; without, the path (where the true one is known) and the grid map are measured</source>
        <translation>Los hitos verdaderos, con los que se compara cada mapa; sin ellos se miden el recorrido (donde se conoce el verdadero) y el mapa de rejilla</translation>
    </message>
    <message>
        <source>Pictures of the &amp;grid maps</source>
        <translation>Imá&amp;genes de los mapas de rejilla</translation>
    </message>
    <message>
        <source>The grid map of each value&apos;s first run, and all of them on one contact sheet</source>
        <translation>El mapa de rejilla de la primera ejecución de cada valor, y todos juntos en una hoja de contactos</translation>
    </message>
    <message>
        <source>Every value is run several times and every map is measured, against the reference where there is one, exactly as hitos-cli study does it.</source>
        <translation>Cada valor se ejecuta varias veces y cada mapa se mide, con la referencia si la hay, exactamente como lo hace hitos-cli study.</translation>
    </message>
    <message>
        <source>No contact sheet: %1</source>
        <translation>Sin hoja de contactos: %1</translation>
    </message>
    <message>
        <source>Open run…</source>
        <translation>Abrir ejecución…</translation>
    </message>
    <message>
        <source>Do one of the runs in the main window, to look at it</source>
        <translation>Hacer una de las ejecuciones en la ventana principal, para mirarla</translation>
    </message>
    <message>
        <source>: map error %1 m</source>
        <translation>: error del mapa %1 m</translation>
    </message>
    <message>
        <source>Open a run of the study</source>
        <translation>Abrir una ejecución del estudio</translation>
    </message>
    <message>
        <source>Run to look at:</source>
        <translation>Ejecución que se quiere mirar:</translation>
    </message>
    <message>
        <source>The log is damaged: lines skipped: %1, stamps that did not advance: %2</source>
        <translation>El registro está dañado: líneas omitidas: %1, marcas de tiempo que no avanzaron: %2</translation>
    </message>
    <message>
        <source>Runs that are the same are kept and not done again. What is there stays until the new study is complete; then its tables and plots take the place of these.</source>
        <translation>Las ejecuciones iguales se conservan y no se repiten. Lo que hay se queda hasta que el estudio nuevo esté completo; entonces sus tablas y gráficas ocupan su lugar.</translation>
    </message>
    <message>
        <source>Study of parameters</source>
        <translation>Estudio de parámetros</translation>
    </message>
    <message>
        <source>An&amp;d parameter</source>
        <translation>&amp;Otro parámetro</translation>
    </message>
    <message>
        <source>What is varied too: every value of the first parameter is run with every one of this</source>
        <translation>Lo que se varía además: cada valor del primer parámetro se ejecuta con cada uno de este</translation>
    </message>
    <message>
        <source>Its va&amp;lues</source>
        <translation>Sus va&amp;lores</translation>
    </message>
    <message>
        <source>Use these values</source>
        <translation>Usar estos valores</translation>
    </message>
    <message>
        <source>Set what is chosen in the plot in the main window</source>
        <translation>Poner en la ventana principal lo elegido en la gráfica</translation>
    </message>
    <message>
        <source>seed %1</source>
        <translation>semilla %1</translation>
    </message>
</context>
<context>
    <name>hitos::window::StudyForm</name>
    <message>
        <source>all (%1)</source>
        <translation>todos (%1)</translation>
    </message>
    <message>
        <source>Reference map</source>
        <translation>Mapa de referencia</translation>
    </message>
    <message>
        <source>Maps (*.map *.txt);;All files (*)</source>
        <translation>Mapas (*.map *.txt);;Todos los archivos (*)</translation>
    </message>
    <message>
        <source>Results folder</source>
        <translation>Carpeta de resultados</translation>
    </message>
    <message>
        <source>Write at least one value.</source>
        <translation>Escriba al menos un valor.</translation>
    </message>
    <message>
        <source>Expected a whole number, 0 or more.</source>
        <translation>Se espera un número entero, 0 o mayor.</translation>
    </message>
    <message>
        <source>Choose a folder for the results.</source>
        <translation>Elija una carpeta para los resultados.</translation>
    </message>
    <message>
        <source>Runs in all: %1</source>
        <translation>En total: %1</translation>
    </message>
</context>
<context>
    <name>hitos::window::StudyPlots</name>
    <message>
        <source>Runs: %1</source>
        <translation>Ejecuciones: %1</translation>
    </message>
    <message>
        <source>Save as image…</source>
        <translation>Guardar como imagen…</translation>
    </message>
    <message>
        <source>Copy picture</source>
        <translation>Copiar imagen</translation>
    </message>
    <message>
        <source>%1: every run, mean and standard deviation</source>
        <translation>%1: cada ejecución, media y desviación típica</translation>
    </message>
    <message>
        <source>; dashed: %1 in the reference</source>
        <translation>; a trazos: %1 en la referencia</translation>
    </message>
    <message>
        <source>Study</source>
        <translation>Estudio</translation>
    </message>
    <message>
        <source>%1: mean over the runs; framed: the best</source>
        <translation>%1: media de las ejecuciones; con marco: el mejor</translation>
    </message>
    <message>
        <source>Failed: %1</source>
        <translation>Fallidas: %1</translation>
    </message>
    <message>
        <source>Figure of the plot</source>
        <translation>Cifra de la gráfica</translation>
    </message>
    <message>
        <source>What the plot shows of each run</source>
        <translation>Qué muestra la gráfica de cada ejecución</translation>
    </message>
    <message>
        <source>; dashed: %1, as it ought to be</source>
        <translation>; a trazos: %1, como debería ser</translation>
    </message>
    <message>
        <source>away from %1</source>
        <translation>distancia a %1</translation>
    </message>
    <message>
        <source>expected share</source>
        <translation>proporción esperada</translation>
    </message>
    <message>
        <source>share seen</source>
        <translation>proporción observada</translation>
    </message>
    <message>
        <source>as it ought to be</source>
        <translation>como debería ser</translation>
    </message>
    <message>
        <source>Calibration: expected and seen shares</source>
        <translation>Calibración: proporciones esperadas y observadas</translation>
    </message>
    <message>
        <source>and %1 more: choose a value to see its name</source>
        <translation>y %1 más: elija un valor para ver su nombre</translation>
    </message>
    <message>
        <source>%1 in the region of %2 %: %3; NEES %4 (%5 to %6 where it is as sure as it may be)</source>
        <translation>%1 en la región del %2 %: %3; NEES %4 (de %5 a %6 donde está tan seguro como puede estarlo)</translation>
    </message>
</context>
<context>
    <name>hitos::window::StudyRow</name>
    <message>
        <source>none</source>
        <translation>ninguno</translation>
    </message>
    <message>
        <source>%1 Allowed: %2. Now: %3.</source>
        <translation>%1 Permitido: %2. Ahora: %3.</translation>
    </message>
    <message>
        <source>Join the parts of a value by “/”.</source>
        <translation>Una las partes de un valor con «/».</translation>
    </message>
    <message>
        <source>A name from the list, or keys joined by “+”.</source>
        <translation>Un nombre de la lista, o claves unidas por «+».</translation>
    </message>
    <message>
        <source>Values with semicolons or blanks between them, or a range from:to:step.</source>
        <translation>Valores separados por punto y coma o espacios, o un intervalo desde:hasta:paso.</translation>
    </message>
    <message>
        <source>Values with commas, semicolons or blanks between them, or a range from:to:step.</source>
        <translation>Valores separados por comas, punto y coma o espacios, o un intervalo desde:hasta:paso.</translation>
    </message>
    <message>
        <source>Values: %1 (%2).</source>
        <translation>Valores: %1 (%2).</translation>
    </message>
</context>
<context>
    <name>hitos::window::SummaryBar</name>
    <message>
        <source>none</source>
        <translation>ninguno</translation>
    </message>
    <message>
        <source>Changed; the default is %1.</source>
        <translation>Cambiado; el predeterminado es %1.</translation>
    </message>
    <message>
        <source>Motion</source>
        <translation>Movimiento</translation>
    </message>
    <message>
        <source>Observation</source>
        <translation>Observación</translation>
    </message>
</context>
<context>
    <name>hitos::window::TimeLine</name>
    <message>
        <source>Time line</source>
        <translation>Línea de tiempo</translation>
    </message>
    <message>
        <source>Scan %1 of %2</source>
        <translation>Barrido %1 de %2</translation>
    </message>
</context>
<context>
    <name>hitos::window::TopicList</name>
    <message>
        <source>Laser</source>
        <translation>Láser</translation>
    </message>
    <message>
        <source>Odometry</source>
        <translation>Odometría</translation>
    </message>
    <message>
        <source>Transforms</source>
        <translation>Transformaciones</translation>
    </message>
    <message>
        <source>Topic</source>
        <translation>Tema</translation>
    </message>
    <message>
        <source>Gives</source>
        <translation>Da</translation>
    </message>
    <message>
        <source>Type</source>
        <translation>Tipo</translation>
    </message>
    <message>
        <source>Messages</source>
        <translation>Mensajes</translation>
    </message>
    <message>
        <source>Frame</source>
        <translation>Marco</translation>
    </message>
    <message>
        <source>Topics</source>
        <translation>Temas</translation>
    </message>
</context>
<context>
    <name>hitos::window::ViewSettings</name>
    <message>
        <source>As the system</source>
        <translation>Como el sistema</translation>
    </message>
    <message>
        <source>Light</source>
        <translation>Clara</translation>
    </message>
    <message>
        <source>Dark</source>
        <translation>Oscura</translation>
    </message>
</context>
<context>
    <name>hitos::window::WorldDraft</name>
    <message>
        <source>untitled</source>
        <translation>sin nombre</translation>
    </message>
</context>
<context>
    <name>hitos::window::WorldFiles</name>
    <message>
        <source>&amp;New</source>
        <translation>&amp;Nuevo</translation>
    </message>
    <message>
        <source>&amp;Open…</source>
        <translation>&amp;Abrir…</translation>
    </message>
    <message>
        <source>&amp;Worlds that come with Hitos</source>
        <translation>&amp;Mundos que vienen con Hitos</translation>
    </message>
    <message>
        <source>The world cannot be opened</source>
        <translation>No se puede abrir el mundo</translation>
    </message>
    <message>
        <source>&amp;Save</source>
        <translation>&amp;Guardar</translation>
    </message>
    <message>
        <source>Save &amp;as…</source>
        <translation>Guardar &amp;como…</translation>
    </message>
    <message>
        <source>The world is not saved</source>
        <translation>El mundo no está guardado</translation>
    </message>
    <message>
        <source>Give up what was drawn in %1?</source>
        <translation>¿Abandonar lo dibujado en %1?</translation>
    </message>
    <message>
        <source>It will be lost.</source>
        <translation>Se perderá.</translation>
    </message>
    <message>
        <source>Give up</source>
        <translation>Abandonar</translation>
    </message>
    <message>
        <source>World, drawing, map, picture or segments to open</source>
        <translation>Mundo, dibujo, mapa, imagen o segmentos que abrir</translation>
    </message>
    <message>
        <source>All of them (*.toml *.dxf *.map *.txt *.yaml *.yml *.png *.pgm *.jpg *.bmp);;Worlds (*.toml);;Drawings (*.dxf);;Maps and segments (*.map *.txt);;Occupancy pictures (*.yaml *.yml *.png *.pgm *.jpg *.jpeg *.bmp);;All files (*)</source>
        <translation>Todos ellos (*.toml *.dxf *.map *.txt *.yaml *.yml *.png *.pgm *.jpg *.bmp);;Mundos (*.toml);;Dibujos (*.dxf);;Mapas y segmentos (*.map *.txt);;Imágenes de ocupación (*.yaml *.yml *.png *.pgm *.jpg *.jpeg *.bmp);;Todos los archivos (*)</translation>
    </message>
    <message>
        <source>Save the world</source>
        <translation>Guardar el mundo</translation>
    </message>
    <message>
        <source>Worlds (*.toml)</source>
        <translation>Mundos (*.toml)</translation>
    </message>
    <message>
        <source>The world is saved as %1</source>
        <translation>El mundo se ha guardado como %1</translation>
    </message>
</context>
<context>
    <name>hitos::window::WorldForm</name>
    <message>
        <source>Robot, laser, odometry</source>
        <translation>Robot, láser, odometría</translation>
    </message>
</context>
<context>
    <name>hitos::window::WorldView</name>
    <message>
        <source>Draw a world, or open one, and drive a robot through it.</source>
        <translation>Dibuje un mundo, o abra uno, y conduzca un robot por él.</translation>
    </message>
    <message>
        <source>World</source>
        <translation>Mundo</translation>
    </message>
</context>
<context>
    <name>hitos::window::WorldWindow</name>
    <message>
        <source>Drive a robot</source>
        <translation>Conducir un robot</translation>
    </message>
    <message>
        <source>World</source>
        <translation>Mundo</translation>
    </message>
    <message>
        <source>The world cannot be opened</source>
        <translation>No se puede abrir el mundo</translation>
    </message>
    <message>
        <source>&amp;Robot, laser, odometry…</source>
        <translation>&amp;Robot, láser, odometría…</translation>
    </message>
    <message>
        <source>Undo</source>
        <translation>Deshacer</translation>
    </message>
    <message>
        <source>Redo</source>
        <translation>Rehacer</translation>
    </message>
    <message>
        <source>Run its tour</source>
        <translation>Ejecutar su recorrido</translation>
    </message>
    <message>
        <source>That cannot be drawn</source>
        <translation>Eso no se puede dibujar</translation>
    </message>
    <message>
        <source>Back to drawing</source>
        <translation>Volver a dibujar</translation>
    </message>
    <message>
        <source>Ends the tour; of five seconds or more a copy is kept</source>
        <translation>Termina el recorrido; si dura cinco segundos o más se guarda una copia</translation>
    </message>
    <message>
        <source>Puts the robot at the start, to be driven by hand</source>
        <translation>Pone el robot en la salida, para conducirlo a mano</translation>
    </message>
    <message>
        <source>%1 – World workshop</source>
        <translation>%1 – Taller de mundos</translation>
    </message>
    <message>
        <source>The world cannot be driven through</source>
        <translation>No se puede conducir por el mundo</translation>
    </message>
    <message>
        <source>Maps the tour along the way points, or the one that was driven, in the main window</source>
        <translation>Procesa en la ventana principal el recorrido por los puntos de paso, o el que se condujo</translation>
    </message>
    <message>
        <source>Image saved: %1</source>
        <translation>Imagen guardada: %1</translation>
    </message>
</context>
</TS>
