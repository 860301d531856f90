<?xml version="1.0" encoding="utf-8"?>
<!DOCTYPE TS>
<TS version="2.1" language="sl" sourcelanguage="en">
<context>
    <name>Actions</name>
    <message>
        <source>&amp;New</source>
        <translation>&amp;Nov</translation>
    </message>
    <message>
        <source>&amp;Open…</source>
        <translation>&amp;Odpri …</translation>
    </message>
    <message>
        <source>&amp;Save</source>
        <translation>&amp;Shrani</translation>
    </message>
    <message>
        <source>Save &amp;as…</source>
        <translation>Shrani &amp;kot …</translation>
    </message>
    <message>
        <source>&amp;Export figure…</source>
        <translation>&amp;Izvozi sliko …</translation>
    </message>
    <message>
        <source>&amp;Quit</source>
        <translation>I&amp;zhod</translation>
    </message>
    <message>
        <source>&amp;Undo</source>
        <translation>&amp;Razveljavi</translation>
    </message>
    <message>
        <source>&amp;Redo</source>
        <translation>&amp;Znova uveljavi</translation>
    </message>
    <message>
        <source>&amp;Delete</source>
        <translation>Iz&amp;briši</translation>
    </message>
    <message>
        <source>Delete &amp;last point</source>
        <translation>Izbriši zadnjo &amp;točko</translation>
    </message>
    <message>
        <source>&amp;Clear the canvas</source>
        <translation>&amp;Počisti platno</translation>
    </message>
    <message>
        <source>Select &amp;all</source>
        <translation>Izberi &amp;vse</translation>
    </message>
    <message>
        <source>Select n&amp;one</source>
        <translation>Ne izberi &amp;ničesar</translation>
    </message>
    <message>
        <source>&amp;Invert the selection</source>
        <translation>&amp;Obrni izbiro</translation>
    </message>
    <message>
        <source>&amp;New curve</source>
        <translation>&amp;Nova krivulja</translation>
    </message>
    <message>
        <source>&amp;Duplicate the curve</source>
        <translation>&amp;Podvoji krivuljo</translation>
    </message>
    <message>
        <source>De&amp;lete the curve</source>
        <translation>Iz&amp;briši krivuljo</translation>
    </message>
    <message>
        <source>Ne&amp;xt curve</source>
        <translation>Na&amp;slednja krivulja</translation>
    </message>
    <message>
        <source>&amp;Reverse</source>
        <translation>&amp;Obrni</translation>
    </message>
    <message>
        <source>&amp;Edit tool</source>
        <translation>Orodje za &amp;urejanje</translation>
    </message>
    <message>
        <source>&amp;Add tool</source>
        <translation>Orodje za &amp;dodajanje</translation>
    </message>
    <message>
        <source>Zoom &amp;in</source>
        <translation>Po&amp;večaj</translation>
    </message>
    <message>
        <source>Zoom &amp;out</source>
        <translation>Po&amp;manjšaj</translation>
    </message>
    <message>
        <source>Zoom to &amp;100 %</source>
        <translation>Merilo &amp;100 %</translation>
    </message>
    <message>
        <source>&amp;Fit all</source>
        <translation>Pokaži v&amp;se</translation>
    </message>
    <message>
        <source>Fit &amp;selection</source>
        <translation>Pokaži &amp;izbrano</translation>
    </message>
    <message>
        <source>&amp;Grid</source>
        <translation>M&amp;reža</translation>
    </message>
    <message>
        <source>A&amp;xes</source>
        <translation>&amp;Osi</translation>
    </message>
    <message>
        <source>&amp;Reset panels</source>
        <translation>&amp;Ponastavi plošče</translation>
    </message>
    <message>
        <source>F&amp;ull screen</source>
        <translation>&amp;Celoten zaslon</translation>
    </message>
    <message>
        <source>&amp;About Kriva</source>
        <translation>&amp;O programu Kriva</translation>
    </message>
    <message>
        <source>About &amp;Qt</source>
        <translation>O knjižnici &amp;Qt</translation>
    </message>
    <message>
        <source>S&amp;how the history</source>
        <translation>Pokaži z&amp;godovino</translation>
    </message>
    <message>
        <source>Cu&amp;t</source>
        <translation>&amp;Izreži</translation>
    </message>
    <message>
        <source>Co&amp;py</source>
        <translation>&amp;Kopiraj</translation>
    </message>
    <message>
        <source>Pa&amp;ste</source>
        <translation>Pri&amp;lepi</translation>
    </message>
    <message>
        <source>Duplicat&amp;e</source>
        <translation>Po&amp;dvoji</translation>
    </message>
    <message>
        <source>Rena&amp;me</source>
        <translation>Prei&amp;menuj</translation>
    </message>
    <message>
        <source>Move &amp;up in the list</source>
        <translation>Premakni na&amp;vzgor po seznamu</translation>
    </message>
    <message>
        <source>Move do&amp;wn in the list</source>
        <translation>Premakni navz&amp;dol po seznamu</translation>
    </message>
    <message>
        <source>&amp;Show the curve</source>
        <translation>Po&amp;kaži krivuljo</translation>
    </message>
    <message>
        <source>Ru&amp;lers</source>
        <translation>Ravni&amp;la</translation>
    </message>
    <message>
        <source>S&amp;nap</source>
        <translation>Pripe&amp;njanje</translation>
    </message>
    <message>
        <source>&amp;Insert a point</source>
        <translation>Vst&amp;avi točko</translation>
    </message>
    <message>
        <source>User &amp;guide</source>
        <translation>&amp;Uporabniški priročnik</translation>
    </message>
    <message>
        <source>&amp;Shortcuts</source>
        <translation>&amp;Bližnjice</translation>
    </message>
    <message>
        <source>Export a&amp;gain</source>
        <translation>Izvozi zno&amp;va</translation>
    </message>
    <message>
        <source>Copy &amp;figure</source>
        <translation>Kopiraj s&amp;liko</translation>
    </message>
    <message>
        <source>Copy as &amp;TikZ</source>
        <translation>Kopiraj kot &amp;TikZ</translation>
    </message>
    <message>
        <source>&amp;Import points…</source>
        <translation>&amp;Uvozi točke …</translation>
    </message>
    <message>
        <source>Copy pat&amp;h</source>
        <translation>Kopira&amp;j pot</translation>
    </message>
    <message>
        <source>&amp;Print…</source>
        <translation>N&amp;atisni …</translation>
    </message>
    <message>
        <source>New &amp;window</source>
        <translation>Odp&amp;ri novo okno</translation>
    </message>
</context>
<context>
    <name>CanvasAccessible</name>
    <message>
        <source>Point %1</source>
        <translation>Točka %1</translation>
    </message>
</context>
<context>
    <name>Caption</name>
    <message>
        <source>Degree elevation</source>
        <translation>Zviševanje stopnje</translation>
    </message>
    <message>
        <source>Subdivision</source>
        <translation>Subdivizija</translation>
    </message>
    <message>
        <source>Spline</source>
        <translation>Zlepek</translation>
    </message>
    <message>
        <source>Combined algorithm</source>
        <translation>Kombinirani algoritem</translation>
    </message>
    <message>
        <source>Curve</source>
        <translation>Krivulja</translation>
    </message>
    <message>
        <source>Control polygon</source>
        <translation>Kontrolni poligon</translation>
    </message>
    <message>
        <source>Elevated polygon</source>
        <translation>Poligon zvišane stopnje</translation>
    </message>
    <message>
        <source>Points</source>
        <translation>Točke</translation>
    </message>
    <message>
        <source>Labels</source>
        <translation>Oznake</translation>
    </message>
    <message>
        <source>De Casteljau scheme</source>
        <translation>De Casteljaujeva shema</translation>
    </message>
    <message>
        <source>Curves of degree n − 1</source>
        <translation>Krivulji stopnje n − 1</translation>
    </message>
    <message>
        <source>Pieces</source>
        <translation>Kosi</translation>
    </message>
    <message>
        <source>Left polygon</source>
        <translation>Levi poligon</translation>
    </message>
    <message>
        <source>Right polygon</source>
        <translation>Desni poligon</translation>
    </message>
    <message>
        <source>Point of the curve</source>
        <translation>Točka krivulje</translation>
    </message>
    <message>
        <source>Blossom</source>
        <translation>Polarna forma</translation>
    </message>
    <message>
        <source>Labels of left and right</source>
        <translation>Oznake levega in desnega</translation>
    </message>
    <message>
        <source>Degree</source>
        <translation>Stopnja</translation>
    </message>
    <message>
        <source>Length</source>
        <translation>Dolžina</translation>
    </message>
    <message>
        <source>Bounds</source>
        <translation>Meje</translation>
    </message>
    <message>
        <source>Degree after elevation</source>
        <translation>Stopnja po zvišanju</translation>
    </message>
    <message>
        <source>Gap between polygon and curve</source>
        <translation>Razmik med poligonom in krivuljo</translation>
    </message>
    <message>
        <source>Point at t</source>
        <translation>Točka pri t</translation>
    </message>
    <message>
        <source>Derivative at t</source>
        <translation>Odvod pri t</translation>
    </message>
    <message>
        <source>Number of pieces</source>
        <translation>Število kosov</translation>
    </message>
    <message>
        <source>Knots</source>
        <translation>Vozli</translation>
    </message>
    <message>
        <source>Handles</source>
        <translation>Ročice</translation>
    </message>
    <message>
        <source>End derivatives</source>
        <translation>Odvoda v krajiščih</translation>
    </message>
    <message>
        <source>Length of segment</source>
        <translation>Dolžina odseka</translation>
    </message>
    <message>
        <source>Coefficients of segment</source>
        <translation>Koeficienti odseka</translation>
    </message>
    <message>
        <source>Continuity at knot</source>
        <translation>Zveznost v vozlu</translation>
    </message>
    <message>
        <source>Extrema of the curvature</source>
        <translation>Ekstremi ukrivljenosti</translation>
    </message>
    <message>
        <source>Bending energy</source>
        <translation>Upogibna energija</translation>
    </message>
    <message>
        <source>Polygon of the given points</source>
        <translation>Poligon danih točk</translation>
    </message>
    <message>
        <source>Monotone runs</source>
        <translation>Monotoni odseki</translation>
    </message>
    <message>
        <source>Joins</source>
        <translation>Stiki</translation>
    </message>
    <message>
        <source>Middle points of pairs</source>
        <translation>Vmesne točke parov</translation>
    </message>
    <message>
        <source>Numbers of runs</source>
        <translation>Številke odsekov</translation>
    </message>
    <message>
        <source>Points of run</source>
        <translation>Točke odseka</translation>
    </message>
    <message>
        <source>Degree of run</source>
        <translation>Stopnja odseka</translation>
    </message>
    <message>
        <source>Coefficients of run</source>
        <translation>Koeficienti odseka</translation>
    </message>
    <message>
        <source>Residual (root mean square) of run</source>
        <translation>Ostanek (koren povprečja kvadratov) odseka</translation>
    </message>
    <message>
        <source>Largest residual of run</source>
        <translation>Največji ostanek odseka</translation>
    </message>
    <message>
        <source>Largest kink</source>
        <translation>Največji prelom</translation>
    </message>
    <message>
        <source>Slope variation</source>
        <translation>Variacija naklona</translation>
    </message>
    <message>
        <source>This curve needs more points</source>
        <translation>Ta krivulja potrebuje še točke</translation>
    </message>
    <message>
        <source>open end</source>
        <translation>prosto krajišče</translation>
    </message>
    <message>
        <source>Crossings</source>
        <translation>Presečišča</translation>
    </message>
    <message>
        <source>Crossings of the sheet</source>
        <translation>Presečišča na listu</translation>
    </message>
    <message>
        <source>Crossing</source>
        <translation>Presečišče</translation>
    </message>
    <message>
        <source>Overlaps of the sheet</source>
        <translation>Prekrivanja na listu</translation>
    </message>
    <message>
        <source>Bernstein polynomials</source>
        <translation>Bernsteinovi polinomi</translation>
    </message>
    <message>
        <source>Control point</source>
        <translation>Kontrolna točka</translation>
    </message>
    <message>
        <source>Weight</source>
        <translation>Utež</translation>
    </message>
    <message>
        <source>Weights at t</source>
        <translation>Uteži pri t</translation>
    </message>
    <message>
        <source>Level</source>
        <translation>Nivo</translation>
    </message>
    <message>
        <source>Left and right polygon</source>
        <translation>Levi in desni poligon</translation>
    </message>
    <message>
        <source>Points of the last elevation</source>
        <translation>Točke zadnjega zvišanja</translation>
    </message>
    <message>
        <source>Hodograph</source>
        <translation>Hodograf</translation>
    </message>
    <message>
        <source>Segment</source>
        <translation>Odsek</translation>
    </message>
    <message>
        <source>Rule</source>
        <translation>Pravilo</translation>
    </message>
    <message>
        <source>All rules</source>
        <translation>Vsa pravila</translation>
    </message>
    <message>
        <source>Catmull–Rom</source>
        <translation>Catmull–Rom</translation>
    </message>
    <message>
        <source>Largest curvature</source>
        <translation>Največja ukrivljenost</translation>
    </message>
    <message>
        <source>Run</source>
        <translation>Odsek</translation>
    </message>
    <message>
        <source>After run</source>
        <translation>Za odsekom</translation>
    </message>
    <message>
        <source>Values of the runs, y(x)</source>
        <translation>Vrednosti odsekov, y(x)</translation>
    </message>
    <message>
        <source>Slopes of the runs, y′(x)</source>
        <translation>Nakloni odsekov, y′(x)</translation>
    </message>
    <message>
        <source>Method</source>
        <translation>Metoda</translation>
    </message>
    <message>
        <source>Comparison of methods</source>
        <translation>Primerjava metod</translation>
    </message>
    <message>
        <source>Interpolation</source>
        <translation>Interpolacija</translation>
    </message>
    <message>
        <source>Approximation</source>
        <translation>Aproksimacija</translation>
    </message>
    <message>
        <source>Pairs</source>
        <translation>Pari</translation>
    </message>
    <message>
        <source>All polygons so far</source>
        <translation>Vsi poligoni doslej</translation>
    </message>
    <message>
        <source>Convex hull</source>
        <translation>Konveksna ovojnica</translation>
    </message>
    <message>
        <source>End tangents</source>
        <translation>Tangenti v krajiščih</translation>
    </message>
    <message>
        <source>De Casteljau schemes at further t</source>
        <translation>De Casteljaujeve sheme pri drugih t</translation>
    </message>
    <message>
        <source>Curvature comb</source>
        <translation>Glavnik ukrivljenosti</translation>
    </message>
    <message>
        <source>Inflections</source>
        <translation>Prevoji</translation>
    </message>
    <message>
        <source>Continuity at the knots</source>
        <translation>Zveznost v vozlih</translation>
    </message>
    <message>
        <source>Polygons of runs</source>
        <translation>Poligoni odsekov</translation>
    </message>
    <message>
        <source>Polynomials of runs</source>
        <translation>Polinomi odsekov</translation>
    </message>
    <message>
        <source>mirror</source>
        <translation>zrcalno</translation>
    </message>
    <message>
        <source>natural</source>
        <translation>naravni</translation>
    </message>
    <message>
        <source>clamped</source>
        <translation>vpeti</translation>
    </message>
    <message>
        <source>De Casteljau polyline</source>
        <translation>De Casteljaujeva lomljenka</translation>
    </message>
    <message>
        <source>Grid</source>
        <translation>Mreža</translation>
    </message>
    <message>
        <source>Numbers of the axes</source>
        <translation>Številke na oseh</translation>
    </message>
    <message>
        <source>Axes</source>
        <translation>Osi</translation>
    </message>
    <message>
        <source>Lines</source>
        <translation>Črte</translation>
    </message>
    <message>
        <source>Place on view</source>
        <translation>Opazovano mesto</translation>
    </message>
    <message>
        <source>Legend</source>
        <translation>Legenda</translation>
    </message>
    <message>
        <source>Residual (root mean square)</source>
        <translation>Ostanek (koren povprečja kvadratov)</translation>
    </message>
    <message>
        <source>Passes through crossings and overlaps</source>
        <translation>Prehodi skozi presečišča in prekrivanja</translation>
    </message>
    <message>
        <source>too many to count</source>
        <translation>preveč za štetje</translation>
    </message>
</context>
<context>
    <name>Clip</name>
    <message>
        <source>The clipboard: %1</source>
        <translation>Odložišče: %1</translation>
    </message>
    <message>
        <source>The clipboard: its curve cannot be read: %1</source>
        <translation>Odložišče: njegove krivulje ni mogoče prebrati: %1</translation>
    </message>
</context>
<context>
    <name>CommandLine</name>
    <message>
        <source>unknown option %1</source>
        <translation>neznana možnost %1</translation>
    </message>
    <message>
        <source>a value is missing behind %1</source>
        <translation>za %1 manjka vrednost</translation>
    </message>
    <message>
        <source>unknown language %1</source>
        <translation>neznan jezik %1</translation>
    </message>
    <message>
        <source>there is no sheet %1</source>
        <translation>lista %1 ni</translation>
    </message>
    <message>
        <source>the option --%1 does not belong here</source>
        <translation>možnost --%1 ne spada sem</translation>
    </message>
    <message>
        <source>export needs the file to write: -o OUT.svg</source>
        <translation>export potrebuje datoteko za zapis: -o OUT.svg</translation>
    </message>
    <message>
        <source>report needs one file</source>
        <translation>report potrebuje eno datoteko</translation>
    </message>
    <message>
        <source>there is no format %1</source>
        <translation>oblike %1 ni</translation>
    </message>
    <message>
        <source>%1: there is no curve to draw</source>
        <translation>%1: ni krivulje, ki bi jo narisali</translation>
    </message>
    <message>
        <source>the output could not be written</source>
        <translation>izhoda ni bilo mogoče zapisati</translation>
    </message>
    <message>
        <source>the editor needs a display; export and report do without one</source>
        <translation>urejevalnik potrebuje zaslon; export in report shajata brez njega</translation>
    </message>
    <message>
        <source>%1; kriva --help tells more</source>
        <translation>%1; več pove kriva --help</translation>
    </message>
    <message>
        <source>export needs a file</source>
        <translation>export potrebuje datoteko</translation>
    </message>
    <message>
        <source>%1: with several files it needs {name} for the name of each</source>
        <translation>%1: pri več datotekah je potreben {name} za ime vsake</translation>
    </message>
    <message>
        <source>%1: there is no curve %2; the sheet has %3, counted from 0</source>
        <translation>%1: krivulje %2 ni; list jih ima %3, štetih od 0</translation>
    </message>
    <message>
        <source>there is no layer %1; the sheet has %2</source>
        <translation>plasti %1 ni; list ima %2</translation>
    </message>
    <message>
        <source>%1: figures are written as .svg, .pdf, .png, .tex or .csv</source>
        <translation>%1: slike se zapisujejo kot .svg, .pdf, .png, .tex ali .csv</translation>
    </message>
    <message>
        <source>--width must be more than both margins, which are %1 mm</source>
        <translation>--width mora biti več kot oba robova, ki sta %1 mm</translation>
    </message>
    <message>
        <source>there is no theme %1</source>
        <translation>teme %1 ni</translation>
    </message>
    <message>
        <source>--%1 is a length such as 120mm, at most %2 mm</source>
        <translation>--%1 je dolžina, kot je 120mm, največ %2 mm</translation>
    </message>
    <message>
        <source>--%1 is a whole number from %2 to %3</source>
        <translation>--%1 je celo število od %2 do %3</translation>
    </message>
    <message>
        <source>import needs a file</source>
        <translation>import potrebuje datoteko</translation>
    </message>
    <message>
        <source>import needs the document to write: -o OUT.kriva</source>
        <translation>import potrebuje dokument za zapis: -o OUT.kriva</translation>
    </message>
    <message>
        <source>import needs the sheet that the curves go to: --sheet NAME</source>
        <translation>import potrebuje list, na katerega gredo krivulje: --sheet NAME</translation>
    </message>
    <message>
        <source>there is no scale %1</source>
        <translation>merila %1 ni</translation>
    </message>
    <message>
        <source>%1 is no offset: two numbers with a comma between them</source>
        <translation>%1 ni odmik: dve števili z vejico med njima</translation>
    </message>
    <message>
        <source>--frames are stages such as 0,5,10 or 0..10, or values such as t=0.25,0.5</source>
        <translation>--frames so stopnje, na primer 0,5,10 ali 0..10, ali vrednosti, na primer t=0.25,0.5</translation>
    </message>
    <message>
        <source>--animate needs --frames and an SVG file</source>
        <translation>--animate potrebuje --frames in datoteko SVG</translation>
    </message>
    <message>
        <source>--seconds is a number from %1 to %2</source>
        <translation>--seconds je število od %1 do %2</translation>
    </message>
    <message>
        <source>kriva [FILE...]
    opens the editor
kriva export FILE... -o OUT.{svg,pdf,png,tex,csv} [--sheet NAME] [--curve N] [--layers A,B]
    draws a sheet: the one named, else the one that was shown when the document was saved.
    {name} and {sheet} in OUT stand for those of each file; - is the standard input and output
    --format svg|pdf|png|tex|csv     where the end of OUT does not say it
    --width 120mm --margin 6mm       of the page; mm, cm, in or pt
    --scale 10                       millimetres for a unit, in place of a width
    --no-labels --theme light|dark
    --no-document --decimals N --inkscape-layers --outlines    of SVG; outlines in place of letters
    --dpi 300 --transparent          of PNG
    --fragment                       of TeX: to be put into another document
    --frames 0,5,10 | 0..10 | t=0.25,0.5   stages of the animation side by side, or with {frame} in OUT
                                     a file for each; --animate --seconds 0.5: one after the other in SVG
kriva import FILE... -o OUT.kriva --sheet NAME [--scale N] [--offset X,Y]
    makes a document of the paths of SVG files, of path data or of tables of points
kriva report FILE [--format json|text] [--sheet NAME]
    prints the numbers of a document

    --language CODE   en, bg, sl or uk; else the language of the system
    --sheet NAME      %1
    --help            this text
    --version         the version

Exit codes: 0 done, 1 failure, 2 wrong usage, 3 input refused, 4 output not written.
</source>
        <translation>kriva [FILE...]
    odpre urejevalnik
kriva export FILE... -o OUT.{svg,pdf,png,tex,csv} [--sheet NAME] [--curve N] [--layers A,B]
    nariše list: imenovanega, sicer tistega, ki je bil prikazan ob shranjevanju dokumenta.
    {name} in {sheet} v OUT sta ime in list vsake datoteke; - je standardni vhod in izhod
    --format svg|pdf|png|tex|csv     kadar ga konec OUT ne pove
    --width 120mm --margin 6mm       strani; mm, cm, in ali pt
    --scale 10                       milimetri na enoto namesto širine
    --no-labels --theme light|dark
    --no-document --decimals N --inkscape-layers --outlines    za SVG; obrisi namesto črk
    --dpi 300 --transparent          za PNG
    --fragment                       za TeX: za vstavljanje v drug dokument
    --frames 0,5,10 | 0..10 | t=0.25,0.5   stopnje animacije druga ob drugi ali s {frame} v OUT
                                     datoteka za vsako; --animate --seconds 0.5: druga za drugo v SVG
kriva import FILE... -o OUT.kriva --sheet NAME [--scale N] [--offset X,Y]
    iz poti datotek SVG, iz podatkov poti ali iz tabel točk naredi dokument
kriva report FILE [--format json|text] [--sheet NAME]
    izpiše števila dokumenta

    --language CODE   en, bg, sl ali uk; sicer jezik sistema
    --sheet NAME      %1
    --help            to besedilo
    --version         različica

Izhodne kode: 0 opravljeno, 1 neuspeh, 2 napačna raba, 3 vhod zavrnjen, 4 izhod ni zapisan.
</translation>
    </message>
    <message>
        <source>--scale is how many millimetres a unit has</source>
        <translation>--scale je, koliko milimetrov ima enota</translation>
    </message>
    <message>
        <source>--width and --scale do not go together</source>
        <translation>--width in --scale ne gresta skupaj</translation>
    </message>
    <message>
        <source>%1: its lines were edited in another program; the document inside is taken as it was</source>
        <translation>%1: črte so bile spremenjene v drugem programu; vzet je dokument v njej, kakršen je bil</translation>
    </message>
    <message>
        <source>%1: at work for %2 s; Ctrl+C ends it</source>
        <translation>%1: delo teče že %2 s; Ctrl+C ga konča</translation>
    </message>
</context>
<context>
    <name>CurveName</name>
    <message>
        <source>Curve %1</source>
        <translation>Krivulja %1</translation>
    </message>
</context>
<context>
    <name>DocumentQuestions</name>
    <message>
        <source>An edited figure</source>
        <translation>Spremenjena slika</translation>
    </message>
    <message>
        <source>The lines of “%1” were edited in another program: they are not those of the document inside any more.</source>
        <translation>Črte slike »%1« so bile spremenjene v drugem programu: niso več črte dokumenta v njej.</translation>
    </message>
    <message>
        <source>Open the document as it was, or as it is drawn now?</source>
        <translation>Naj se odpre dokument, kakršen je bil, ali kakršen je narisan zdaj?</translation>
    </message>
    <message>
        <source>D&amp;rawing</source>
        <translation>&amp;Risba</translation>
    </message>
    <message>
        <source>&amp;Document</source>
        <translation>&amp;Dokument</translation>
    </message>
    <message>
        <source>Unsaved changes</source>
        <translation>Neshranjene spremembe</translation>
    </message>
    <message>
        <source>Save the changes to “%1”?</source>
        <translation>Naj se spremembe v »%1« shranijo?</translation>
    </message>
    <message>
        <source>Without saving they are lost.</source>
        <translation>Brez shranjevanja bodo izgubljene.</translation>
    </message>
    <message>
        <source>The file is gone</source>
        <translation>Datoteke ni več</translation>
    </message>
    <message>
        <source>Save “%1” again?</source>
        <translation>Naj se »%1« znova shrani?</translation>
    </message>
    <message>
        <source>Its file was deleted or moved elsewhere.</source>
        <translation>Datoteka je bila izbrisana ali premaknjena drugam.</translation>
    </message>
    <message>
        <source>Open elsewhere</source>
        <translation>Odprto drugje</translation>
    </message>
    <message>
        <source>Another Kriva has “%1” open.</source>
        <translation>»%1« je odprt v drugem programu Kriva.</translation>
    </message>
    <message>
        <source>A copy is a document of its own. Opened anyway, the one that saves last overwrites the other.</source>
        <translation>Kopija je samostojen dokument. Če ga vseeno odprete, bo tisti, ki shrani zadnji, prepisal drugega.</translation>
    </message>
    <message>
        <source>Open a &amp;copy</source>
        <translation>Odpri &amp;kopijo</translation>
    </message>
    <message>
        <source>Open &amp;anyway</source>
        <translation>Vseeno &amp;odpri</translation>
    </message>
    <message>
        <source>“%1” is open in another window or in another Kriva.</source>
        <translation>»%1« je odprt v drugem oknu ali v drugem programu Kriva.</translation>
    </message>
    <message>
        <source>Overwritten, it is no longer what is shown there.</source>
        <translation>Če ga prepišete, ne bo več to, kar je prikazano tam.</translation>
    </message>
    <message>
        <source>Save &amp;as…</source>
        <translation>Shrani &amp;kot …</translation>
    </message>
    <message>
        <source>&amp;Overwrite</source>
        <translation>&amp;Prepiši</translation>
    </message>
    <message>
        <source>Changed elsewhere</source>
        <translation>Spremenjeno drugje</translation>
    </message>
    <message>
        <source>Another program changed “%1” since it was opened or saved here.</source>
        <translation>Drug program je spremenil »%1«, odkar je bil odprt ali shranjen tukaj.</translation>
    </message>
    <message>
        <source>Overwritten, the changes made there are lost; reloaded, those made here.</source>
        <translation>Če ga prepišete, bodo izgubljene spremembe od tam; če ga znova naložite, spremembe od tukaj.</translation>
    </message>
    <message>
        <source>&amp;Reload</source>
        <translation>&amp;Znova naloži</translation>
    </message>
    <message>
        <source>Reload “%1” as it is in its file?</source>
        <translation>Naj se »%1« znova naloži, kakršen je v datoteki?</translation>
    </message>
    <message>
        <source>The changes made here are lost.</source>
        <translation>Spremembe, narejene tukaj, bodo izgubljene.</translation>
    </message>
    <message>
        <source>The file was not opened</source>
        <translation>Datoteka ni bila odprta</translation>
    </message>
    <message>
        <source>The document was not saved</source>
        <translation>Dokument ni bil shranjen</translation>
    </message>
    <message>
        <source>It is still here, as you see it.</source>
        <translation>Še vedno je tukaj, kakršnega vidite.</translation>
    </message>
    <message>
        <source>What is shown here is in no file any more: without saving it is lost.</source>
        <translation>Tega, kar je prikazano tukaj, ni več v nobeni datoteki: brez shranjevanja bo izgubljeno.</translation>
    </message>
</context>
<context>
    <name>Errors</name>
    <message>
        <source>line %1, column %2</source>
        <translation>vrstica %1, stolpec %2</translation>
    </message>
    <message>
        <source>this is no JSON</source>
        <translation>to ni JSON</translation>
    </message>
    <message>
        <source>nested more than %1 deep</source>
        <translation>vgnezdeno globlje od %1</translation>
    </message>
    <message>
        <source>a number of more than %1 characters</source>
        <translation>število z več kot %1 znaki</translation>
    </message>
    <message>
        <source>this is no document of Kriva</source>
        <translation>to ni dokument programa Kriva</translation>
    </message>
    <message>
        <source>version %1 needs a newer Kriva</source>
        <translation>različica %1 potrebuje novejšo Krivo</translation>
    </message>
    <message>
        <source>unknown key</source>
        <translation>neznan ključ</translation>
    </message>
    <message>
        <source>the key stands here twice</source>
        <translation>ključ je tu dvakrat</translation>
    </message>
    <message>
        <source>the key “%1” is missing</source>
        <translation>manjka ključ »%1«</translation>
    </message>
    <message>
        <source>expected an object</source>
        <translation>pričakovan je objekt</translation>
    </message>
    <message>
        <source>expected a list</source>
        <translation>pričakovan je seznam</translation>
    </message>
    <message>
        <source>expected a text</source>
        <translation>pričakovano je besedilo</translation>
    </message>
    <message>
        <source>expected true or false</source>
        <translation>pričakovano je true ali false</translation>
    </message>
    <message>
        <source>expected a number</source>
        <translation>pričakovano je število</translation>
    </message>
    <message>
        <source>expected a whole number from %1 to %2</source>
        <translation>pričakovano je celo število od %1 do %2</translation>
    </message>
    <message>
        <source>expected a number from %1 to %2</source>
        <translation>pričakovano je število od %1 do %2</translation>
    </message>
    <message>
        <source>expected a number between %1 and %2</source>
        <translation>pričakovano je število med %1 in %2</translation>
    </message>
    <message>
        <source>expected two finite numbers</source>
        <translation>pričakovani sta dve končni števili</translation>
    </message>
    <message>
        <source>expected one of: %1</source>
        <translation>pričakovano je eno od: %1</translation>
    </message>
    <message>
        <source>expected a colour like #0072b2</source>
        <translation>pričakovana je barva, kot je #0072b2</translation>
    </message>
    <message numerus="yes">
        <source>expected %n element(s)</source>
        <translation>
            <numerusform>pričakovan je %n element</numerusform>
            <numerusform>pričakovana sta %n elementa</numerusform>
            <numerusform>pričakovani so %n elementi</numerusform>
            <numerusform>pričakovanih je %n elementov</numerusform>
        </translation>
    </message>
    <message>
        <source>more than %1 is too many</source>
        <translation>več kot %1 je preveč</translation>
    </message>
    <message>
        <source>no such index</source>
        <translation>tega indeksa ni</translation>
    </message>
    <message>
        <source>the file is larger than %1 bytes</source>
        <translation>datoteka je večja od %1 bajtov</translation>
    </message>
    <message>
        <source>this figure has no document of Kriva inside</source>
        <translation>v tej sliki ni dokumenta programa Kriva</translation>
    </message>
    <message>
        <source>this is no XML</source>
        <translation>to ni XML</translation>
    </message>
    <message>
        <source>the document type has declarations of its own</source>
        <translation>vrsta dokumenta ima lastne deklaracije</translation>
    </message>
    <message>
        <source>more than %1 elements are too many</source>
        <translation>več kot %1 elementov je preveč</translation>
    </message>
    <message>
        <source>more than %1 attributes are too many</source>
        <translation>več kot %1 atributov je preveč</translation>
    </message>
    <message>
        <source>%1: there is no such file</source>
        <translation>%1: te datoteke ni</translation>
    </message>
    <message>
        <source>%1: this is no regular file</source>
        <translation>%1: to ni navadna datoteka</translation>
    </message>
    <message>
        <source>%1: the file is larger than %2 bytes</source>
        <translation>%1: datoteka je večja od %2 bajtov</translation>
    </message>
    <message>
        <source>%1: reading is not permitted</source>
        <translation>%1: branje ni dovoljeno</translation>
    </message>
    <message>
        <source>%1: the file cannot be read (%2)</source>
        <translation>%1: datoteke ni mogoče prebrati (%2)</translation>
    </message>
    <message>
        <source>%1: there is no such folder</source>
        <translation>%1: te mape ni</translation>
    </message>
    <message>
        <source>%1: writing is not permitted</source>
        <translation>%1: pisanje ni dovoljeno</translation>
    </message>
    <message>
        <source>%1: there is no space left</source>
        <translation>%1: prostora je zmanjkalo</translation>
    </message>
    <message>
        <source>%1: the file cannot be written (%2)</source>
        <translation>%1: datoteke ni mogoče zapisati (%2)</translation>
    </message>
    <message>
        <source>this is no path data</source>
        <translation>to niso podatki poti</translation>
    </message>
    <message>
        <source>the attribute “%1” cannot be read</source>
        <translation>atributa »%1« ni mogoče prebrati</translation>
    </message>
    <message>
        <source>there is no path to import</source>
        <translation>ni poti za uvoz</translation>
    </message>
    <message>
        <source>the interpolated runs have more than %1 pairs of points</source>
        <translation>interpolirani odseki imajo več kot %1 parov točk</translation>
    </message>
    <message>
        <source>%1: written, but the owner or the permissions of the file could not be kept</source>
        <translation>%1: zapisano, vendar lastnika ali pravic datoteke ni bilo mogoče ohraniti</translation>
    </message>
    <message>
        <source>a sheet takes at most %1 curves, and these are %2</source>
        <translation>list sprejme največ %1 krivulj, teh pa je %2</translation>
    </message>
    <message>
        <source>a sheet takes at most %1 points</source>
        <translation>list sprejme največ %1 točk</translation>
    </message>
    <message>
        <source>a sheet takes at most %1 points of elevated curves and of pieces</source>
        <translation>list sprejme največ %1 točk krivulj zvišane stopnje in kosov</translation>
    </message>
    <message>
        <source>this curve takes at most %1 points, and would have %2</source>
        <translation>ta krivulja sprejme največ %1 točk, imela pa bi jih %2</translation>
    </message>
    <message>
        <source>interpolation takes at most %1 points in a monotone run, and one has %2</source>
        <translation>interpolacija dopušča največ %1 točk v monotonem odseku, eden pa jih ima %2</translation>
    </message>
    <message>
        <source>a report takes at most %1 segments of a sheet, and these are %2</source>
        <translation>poročilo sprejme največ %1 segmentov lista, teh pa je %2</translation>
    </message>
    <message>
        <source>more than %1 passes through crossings and overlaps are too many</source>
        <translation>več kot %1 prehodov skozi presečišča in prekrivanja je preveč</translation>
    </message>
    <message>
        <source>the curves have too many intersections to work out</source>
        <translation>krivulje imajo preveč presečišč, da bi jih bilo mogoče izračunati</translation>
    </message>
    <message>
        <source>coordinates go from %1 to %2</source>
        <translation>koordinate so od %1 do %2</translation>
    </message>
    <message>
        <source>more than %1 uses of elements are too many</source>
        <translation>več kot %1 uporab elementov je preveč</translation>
    </message>
    <message>
        <source>uses of elements are nested more than %1 deep</source>
        <translation>uporabe elementov so vgnezdene globlje od %1</translation>
    </message>
    <message>
        <source>there is something behind the end of the outermost element</source>
        <translation>za koncem najbolj zunanjega elementa nekaj je</translation>
    </message>
    <message>
        <source>the attribute “%1” stands here twice</source>
        <translation>atribut »%1« je tu dvakrat</translation>
    </message>
    <message>
        <source>the entity “%1” is unknown</source>
        <translation>entiteta »%1« ni znana</translation>
    </message>
    <message>
        <source>this is no UTF-8, which the file says that it is</source>
        <translation>to ni UTF-8, kar datoteka trdi, da je</translation>
    </message>
    <message>
        <source>the attribute “%1” leads beyond the coordinates from %2 to %3</source>
        <translation>atribut »%1« vodi čez koordinate od %2 do %3</translation>
    </message>
    <message>
        <source>curve %1</source>
        <translation>krivulja %1</translation>
    </message>
    <message>
        <source>curve %1, “%2”</source>
        <translation>krivulja %1, »%2«</translation>
    </message>
    <message>
        <source>%1, the document inside</source>
        <translation>%1, dokument v njej</translation>
    </message>
    <message>
        <source>a report takes at most %1 points of de Casteljau schemes of a sheet, and these are %2</source>
        <translation>poročilo sprejme največ %1 točk de Casteljaujevih shem lista, teh pa je %2</translation>
    </message>
    <message>
        <source>a report or a figure takes at most %1 pieces of the curves of a sheet, and these are %2</source>
        <translation>poročilo ali slika sprejme največ %1 kosov krivulj enega zavihka, teh pa je %2</translation>
    </message>
    <message>
        <source>the encoding “%1” cannot be read</source>
        <translation>kodiranja »%1« ni mogoče prebrati</translation>
    </message>
    <message>
        <source>“%1” is no character of XML</source>
        <translation>»%1« ni znak XML</translation>
    </message>
    <message>
        <source>%1: there is no file of this name, and one whose name is no UTF-8 cannot be opened</source>
        <translation>%1: datoteke s tem imenom ni, datoteke, katere ime ni v UTF-8, pa ni mogoče odpreti</translation>
    </message>
</context>
<context>
    <name>Examples</name>
    <message>
        <source>The polygon of degree 100 lies all but on the curve. Lower the degree with Page Down and watch the gap grow like 1/N.</source>
        <translation>Poligon stopnje 100 leži skoraj na krivulji. Znižujte stopnjo s Page Down in opazujte, kako razmik raste kot 1/N.</translation>
    </message>
    <message>
        <source>Three rows of midpoints lead to the point (7/2, 3/2) of the curve. Move t: the last segment of the scheme stays tangent to the curve.</source>
        <translation>Tri vrste razpolovišč vodijo do točke (7/2, 3/2) na krivulji. Premikajte t: zadnja daljica sheme se krivulje ves čas dotika.</translation>
    </message>
    <message>
        <source>Each row of the scheme has a parameter of its own, and so the point lies off the curve. Make the three arguments equal: it falls on it.</source>
        <translation>Vsaka vrstica sheme ima svoj parameter, zato točka ne leži na krivulji. Izenačite vse tri argumente: točka pade nanjo.</translation>
    </message>
    <message>
        <source>One polygon, whose inner points count once, twice and three times: the more often a point counts, the closer it draws the arc to itself.</source>
        <translation>En poligon, katerega notranji točki štejeta enkrat, dvakrat in trikrat: večja ko je večkratnost, bolj točka pritegne lok k sebi.</translation>
    </message>
    <message>
        <source>A closed chain of six cubics that crosses itself three times. Results names the segments and parameters of every crossing.</source>
        <translation>Sklenjena veriga šestih kubičnih krivulj, ki trikrat seka samo sebe. V Rezultatih so odseki in parametri vsakega presečišča.</translation>
    </message>
    <message>
        <source>The two arrows are the derivatives at the ends. Drag one: the whole chain follows, and every knot stays C2.</source>
        <translation>Puščici sta odvoda v krajiščih. Povlecite eno: sledi ji cela veriga, vsak vozel pa ostane C2.</translation>
    </message>
    <message>
        <source>On equally spaced points the interpolation of degree 10 swings out near the ends; the approximation of degree 6 does so far less.</source>
        <translation>Na enakomerno razporejenih točkah interpolacija stopnje 10 ob krajiščih močno zaniha; aproksimacija stopnje 6 mnogo manj.</translation>
    </message>
    <message>
        <source>The points turn back in x four times: five monotone runs, each a polynomial y(x), joined by Bézier curves.</source>
        <translation>Točke se v smeri x štirikrat obrnejo: pet monotonih odsekov, vsak je polinom y(x), stikajo pa jih Bézierove krivulje.</translation>
    </message>
    <message>
        <source>Two curves of pairs pass through every point. Drag a middle point: only its own pair changes.</source>
        <translation>Dve krivulji iz parov gresta skozi vse točke. Povlecite vmesno točko: spremeni se samo njen par.</translation>
    </message>
</context>
<context>
    <name>FigureFile</name>
    <message>
        <source>the picture would have more than %1 pixels a side</source>
        <translation>slika bi imela več kot %1 pik na stranico</translation>
    </message>
    <message>
        <source>TeX draws at most %1 mm a side; give the figure a width</source>
        <translation>TeX riše največ %1 mm na stranico; določite širino slike</translation>
    </message>
    <message>
        <source>the animation of the curve has no such frame</source>
        <translation>animacija krivulje nima take sličice</translation>
    </message>
</context>
<context>
    <name>Gestures</name>
    <message>
        <source>Tabs</source>
        <translation>Zavihki</translation>
    </message>
    <message>
        <source>Show a tab</source>
        <translation>Pokaže zavihek</translation>
    </message>
    <message>
        <source>Alt+1 … Alt+%1</source>
        <translation>Alt+1 … Alt+%1</translation>
    </message>
    <message>
        <source>Next tab</source>
        <translation>Naslednji zavihek</translation>
    </message>
    <message>
        <source>Points, with the mouse</source>
        <translation>Točke, z miško</translation>
    </message>
    <message>
        <source>Select a point, or make a curve the active one</source>
        <translation>Izbere točko ali naredi krivuljo dejavno</translation>
    </message>
    <message>
        <source>Click</source>
        <translation>Klik</translation>
    </message>
    <message>
        <source>Select or deselect one more point</source>
        <translation>Izbere še eno točko ali jo izvzame iz izbora</translation>
    </message>
    <message>
        <source>Shift+click</source>
        <translation>Shift+klik</translation>
    </message>
    <message>
        <source>Select all points in a rectangle</source>
        <translation>Izbere vse točke v pravokotniku</translation>
    </message>
    <message>
        <source>Drag on the empty canvas</source>
        <translation>Vlečenje po praznem platnu</translation>
    </message>
    <message>
        <source>Add the points in a rectangle to the selection</source>
        <translation>Doda točke v pravokotniku k izboru</translation>
    </message>
    <message>
        <source>Shift+drag</source>
        <translation>Shift+vlečenje</translation>
    </message>
    <message>
        <source>Take the points in a rectangle out of the selection</source>
        <translation>Izvzame točke v pravokotniku iz izbora</translation>
    </message>
    <message>
        <source>Alt+drag or Ctrl+Shift+drag</source>
        <translation>Alt+vlečenje ali Ctrl+Shift+vlečenje</translation>
    </message>
    <message>
        <source>Add a point at the end of the curve</source>
        <translation>Doda točko na koncu krivulje</translation>
    </message>
    <message>
        <source>Alt+click, or double-click on the empty canvas</source>
        <translation>Alt+klik ali dvojni klik na prazno platno</translation>
    </message>
    <message>
        <source>Insert a point and keep the shape</source>
        <translation>Vstavi točko in ohrani obliko</translation>
    </message>
    <message>
        <source>Double-click or Ctrl+Alt+click on the curve</source>
        <translation>Dvojni klik ali Ctrl+Alt+klik na krivuljo</translation>
    </message>
    <message>
        <source>Remove a point and refit its neighbours</source>
        <translation>Odstrani točko in prilagodi sosednji</translation>
    </message>
    <message>
        <source>Alt+click on the point</source>
        <translation>Alt+klik na točko</translation>
    </message>
    <message>
        <source>Move a point or the selection</source>
        <translation>Premakne točko ali izbrano</translation>
    </message>
    <message>
        <source>Drag the point</source>
        <translation>Vlečenje točke</translation>
    </message>
    <message>
        <source>Move along an axis</source>
        <translation>Premakne vzdolž osi</translation>
    </message>
    <message>
        <source>Ctrl+drag</source>
        <translation>Ctrl+vlečenje</translation>
    </message>
    <message>
        <source>Move without snapping</source>
        <translation>Premakne brez pripenjanja</translation>
    </message>
    <message>
        <source>Shift, pressed during the drag</source>
        <translation>Shift, pritisnjen med vlečenjem</translation>
    </message>
    <message>
        <source>Mould the curve</source>
        <translation>Oblikuje krivuljo</translation>
    </message>
    <message>
        <source>Drag the curve</source>
        <translation>Vlečenje krivulje</translation>
    </message>
    <message>
        <source>What can be done here</source>
        <translation>Kaj je tu mogoče storiti</translation>
    </message>
    <message>
        <source>Right-click</source>
        <translation>Desni klik</translation>
    </message>
    <message>
        <source>Add tool</source>
        <translation>Orodje za dodajanje</translation>
    </message>
    <message>
        <source>Add a point, or insert one on the curve</source>
        <translation>Doda točko ali jo vstavi v krivuljo</translation>
    </message>
    <message>
        <source>Pull the handles of the new knot</source>
        <translation>Izvleče ročici novega vozla</translation>
    </message>
    <message>
        <source>Press and drag</source>
        <translation>Pritisk in vlečenje</translation>
    </message>
    <message>
        <source>Close the curve</source>
        <translation>Sklene krivuljo</translation>
    </message>
    <message>
        <source>Click on the first knot</source>
        <translation>Klik na prvi vozel</translation>
    </message>
    <message>
        <source>End</source>
        <translation>Konec</translation>
    </message>
    <message>
        <source>Enter or Esc</source>
        <translation>Enter ali Esc</translation>
    </message>
    <message>
        <source>Handles and end derivatives</source>
        <translation>Ročice in odvoda v krajiščih</translation>
    </message>
    <message>
        <source>Turn in steps of 15°</source>
        <translation>Vrti v korakih po 15°</translation>
    </message>
    <message>
        <source>Keep the angle</source>
        <translation>Ohrani kot</translation>
    </message>
    <message>
        <source>Ctrl+Alt+drag</source>
        <translation>Ctrl+Alt+vlečenje</translation>
    </message>
    <message>
        <source>Leave the other handle where it is</source>
        <translation>Pusti drugo ročico na mestu</translation>
    </message>
    <message>
        <source>Alt, pressed during the drag</source>
        <translation>Alt, pritisnjen med vlečenjem</translation>
    </message>
    <message>
        <source>Carry the knot along</source>
        <translation>Nese tudi vozel</translation>
    </message>
    <message>
        <source>Space, held during the drag</source>
        <translation>Preslednica, pridržana med vlečenjem</translation>
    </message>
    <message>
        <source>Retract the handle</source>
        <translation>Skrči ročico</translation>
    </message>
    <message>
        <source>Ctrl+click</source>
        <translation>Ctrl+klik</translation>
    </message>
    <message>
        <source>Keys on the canvas</source>
        <translation>Tipke na platnu</translation>
    </message>
    <message>
        <source>Edit tool</source>
        <translation>Orodje za urejanje</translation>
    </message>
    <message>
        <source>Fit the selection</source>
        <translation>Pokaže izbrano</translation>
    </message>
    <message>
        <source>Grid</source>
        <translation>Mreža</translation>
    </message>
    <message>
        <source>Next point</source>
        <translation>Naslednja točka</translation>
    </message>
    <message>
        <source>Previous point</source>
        <translation>Prejšnja točka</translation>
    </message>
    <message>
        <source>Move the selection by a step of the grid</source>
        <translation>Premakne izbrano za korak mreže</translation>
    </message>
    <message>
        <source>Arrow keys</source>
        <translation>Smerne tipke</translation>
    </message>
    <message>
        <source>Move the selection by ten steps</source>
        <translation>Premakne izbrano za deset korakov</translation>
    </message>
    <message>
        <source>Shift+arrow keys</source>
        <translation>Shift+smerne tipke</translation>
    </message>
    <message>
        <source>Move the selection by a pixel</source>
        <translation>Premakne izbrano za piko</translation>
    </message>
    <message>
        <source>Alt+arrow keys</source>
        <translation>Alt+smerne tipke</translation>
    </message>
    <message>
        <source>Remove the selection and refit its neighbours</source>
        <translation>Odstrani izbrano in prilagodi sosednje točke</translation>
    </message>
    <message>
        <source>Delete or Backspace</source>
        <translation>Delete ali Backspace</translation>
    </message>
    <message>
        <source>Remove the selection without refitting</source>
        <translation>Odstrani izbrano brez prilagajanja</translation>
    </message>
    <message>
        <source>Take back the drag, end the tool, deselect, leave the canvas</source>
        <translation>Prekliče vlečenje, konča orodje, počisti izbor, zapusti platno</translation>
    </message>
    <message>
        <source>View, with the mouse</source>
        <translation>Pogled, z miško</translation>
    </message>
    <message>
        <source>Scroll</source>
        <translation>Drsi</translation>
    </message>
    <message>
        <source>Wheel</source>
        <translation>Kolesce</translation>
    </message>
    <message>
        <source>Scroll sideways</source>
        <translation>Drsi vstran</translation>
    </message>
    <message>
        <source>Shift+wheel</source>
        <translation>Shift+kolesce</translation>
    </message>
    <message>
        <source>Zoom at the pointer</source>
        <translation>Spremeni merilo pri kazalcu</translation>
    </message>
    <message>
        <source>Ctrl+wheel</source>
        <translation>Ctrl+kolesce</translation>
    </message>
    <message>
        <source>Move the sheet</source>
        <translation>Premakne list</translation>
    </message>
    <message>
        <source>Drag with the middle button or with Space</source>
        <translation>Vlečenje s srednjim gumbom ali s preslednico</translation>
    </message>
    <message>
        <source>Player</source>
        <translation>Animacija</translation>
    </message>
    <message>
        <source>Play or pause</source>
        <translation>Predvajaj ali premor</translation>
    </message>
    <message>
        <source>One step back or forth</source>
        <translation>Eno stopnjo nazaj ali naprej</translation>
    </message>
    <message>
        <source>Left, Right</source>
        <translation>Leva, desna smerna tipka</translation>
    </message>
</context>
<context>
    <name>Hint</name>
    <message>
        <source>Alt+click: remove the point</source>
        <translation>Alt+klik: odstrani točko</translation>
    </message>
    <message>
        <source>Drag: move the point, Ctrl: along an axis   Alt+click: remove it</source>
        <translation>Vlečenje: premakne točko, Ctrl: vzdolž osi   Alt+klik: odstrani jo</translation>
    </message>
    <message>
        <source>Drag: mould the curve   Double-click: insert a point</source>
        <translation>Vlečenje: oblikuje krivuljo   Dvojni klik: vstavi točko</translation>
    </message>
    <message>
        <source>Alt+click: add a point</source>
        <translation>Alt+klik: doda točko</translation>
    </message>
    <message>
        <source>Double-click or Alt+click: add a point   Drag: select points   Ctrl+wheel: zoom</source>
        <translation>Dvojni klik ali Alt+klik: doda točko   Vlečenje: izbere točke   Ctrl+kolesce: merilo</translation>
    </message>
    <message>
        <source>No point can be inserted here</source>
        <translation>Tu ni mogoče vstaviti točke</translation>
    </message>
    <message>
        <source>This curve follows its points; drag them</source>
        <translation>Ta krivulja sledi svojim točkam; vlecite te</translation>
    </message>
    <message>
        <source>The shape changes by at most %1</source>
        <translation>Oblika se spremeni za največ %1</translation>
    </message>
    <message>
        <source>The degree falls to %1</source>
        <translation>Stopnja se zniža na %1</translation>
    </message>
    <message>
        <source>Click: close the curve   Drag: move the point   Esc: end</source>
        <translation>Klik: zapre krivuljo   Vlečenje: premakne točko   Esc: konec</translation>
    </message>
    <message>
        <source>Click: add a point   Drag: move the point   Esc: end</source>
        <translation>Klik: doda točko   Vlečenje: premakne točko   Esc: konec</translation>
    </message>
    <message>
        <source>Ctrl+drag: move the point along an axis</source>
        <translation>Ctrl+vlečenje: premakne točko vzdolž osi</translation>
    </message>
    <message>
        <source>Shift+click: select or deselect the point</source>
        <translation>Shift+klik: izbere točko ali jo izvzame iz izbora</translation>
    </message>
    <message>
        <source>Ctrl+drag: steps of 15°   Ctrl+click: retract the handle</source>
        <translation>Ctrl+vlečenje: koraki po 15°   Ctrl+klik: skrči ročico</translation>
    </message>
    <message>
        <source>Drag: move the handle, Ctrl: in steps of 15°   Ctrl+click: retract it</source>
        <translation>Vlečenje: premakne ročico, Ctrl: v korakih po 15°   Ctrl+klik: jo skrči</translation>
    </message>
    <message>
        <source>Ctrl+drag: steps of 15°   Ctrl+click: back to the natural derivative</source>
        <translation>Ctrl+vlečenje: koraki po 15°   Ctrl+klik: nazaj na naravni odvod</translation>
    </message>
    <message>
        <source>Drag: change the derivative, Ctrl: in steps of 15°   Ctrl+click: back to the natural one</source>
        <translation>Vlečenje: spremeni odvod, Ctrl: v korakih po 15°   Ctrl+klik: nazaj na naravnega</translation>
    </message>
    <message>
        <source>Drag: move the point, Ctrl: along an axis</source>
        <translation>Vlečenje: premakne točko, Ctrl: vzdolž osi</translation>
    </message>
    <message>
        <source>Ctrl+Alt+click: insert a point</source>
        <translation>Ctrl+Alt+klik: vstavi točko</translation>
    </message>
    <message>
        <source>Click: insert a point   Drag: pull its handles   Esc: end</source>
        <translation>Klik: vstavi točko   Vlečenje: izvleče njeni ročici   Esc: konec</translation>
    </message>
    <message>
        <source>Click: insert a point   Drag: place it   Esc: end</source>
        <translation>Klik: vstavi točko   Vlečenje: jo postavi   Esc: konec</translation>
    </message>
    <message>
        <source>Alt+click: add a point   Alt+drag: deselect points</source>
        <translation>Alt+klik: doda točko   Alt+vlečenje: izvzame točke iz izbora</translation>
    </message>
    <message>
        <source>Shift+drag: select more points</source>
        <translation>Shift+vlečenje: izbere še druge točke</translation>
    </message>
    <message>
        <source>Ctrl+Shift+drag: deselect points</source>
        <translation>Ctrl+Shift+vlečenje: izvzame točke iz izbora</translation>
    </message>
    <message>
        <source>Click: add a point   Drag: pull its handles   Esc: end</source>
        <translation>Klik: doda točko   Vlečenje: izvleče njeni ročici   Esc: konec</translation>
    </message>
    <message>
        <source>Click: add a point   Drag: place it   Esc: end</source>
        <translation>Klik: doda točko   Vlečenje: jo postavi   Esc: konec</translation>
    </message>
    <message>
        <source>Space: the knot goes along</source>
        <translation>Preslednica: vozel gre z ročico</translation>
    </message>
    <message>
        <source>Ctrl+Alt: the handle keeps its angle</source>
        <translation>Ctrl+Alt: ročica ohrani svoj kot</translation>
    </message>
    <message>
        <source>Ctrl: steps of 15°</source>
        <translation>Ctrl: koraki po 15°</translation>
    </message>
    <message>
        <source>Alt: the other handle stays</source>
        <translation>Alt: druga ročica ostane na mestu</translation>
    </message>
    <message>
        <source>Ctrl: steps of 15°   Ctrl+Alt: keep the angle   Alt: leave the other handle   Space: carry the knot</source>
        <translation>Ctrl: koraki po 15°   Ctrl+Alt: ohrani kot   Alt: pusti drugo ročico   Preslednica: nese tudi vozel</translation>
    </message>
    <message>
        <source>Click: how this point is worked out, in Tables</source>
        <translation>Klik: kako je ta točka izračunana, v Tabelah</translation>
    </message>
    <message>
        <source>The shape stays as it is</source>
        <translation>Oblika ostane enaka</translation>
    </message>
</context>
<context>
    <name>Menus</name>
    <message>
        <source>A cubic raised 97 times</source>
        <translation>Kubična krivulja, zvišana 97-krat</translation>
    </message>
    <message>
        <source>De Casteljau at t = 1/2</source>
        <translation>De Casteljau pri t = 1/2</translation>
    </message>
    <message>
        <source>The blossom b[t₁, t₂, t₃]</source>
        <translation>Polarna forma b[t₁, t₂, t₃]</translation>
    </message>
    <message>
        <source>An arc with double and triple points</source>
        <translation>Lok z dvojnimi in trojnimi točkami</translation>
    </message>
    <message>
        <source>A chain with three self-intersections</source>
        <translation>Veriga s tremi samopresečišči</translation>
    </message>
    <message>
        <source>A clamped cubic spline</source>
        <translation>Vpet kubični zlepek</translation>
    </message>
    <message>
        <source>Runge&apos;s function</source>
        <translation>Rungejeva funkcija</translation>
    </message>
    <message>
        <source>A curve with five monotone runs</source>
        <translation>Krivulja s petimi monotonimi odseki</translation>
    </message>
    <message>
        <source>The outline of a leaf</source>
        <translation>Obris lista</translation>
    </message>
    <message>
        <source>&amp;File</source>
        <translation>&amp;Datoteka</translation>
    </message>
    <message>
        <source>Open &amp;recent</source>
        <translation>Odpri ne&amp;davno</translation>
    </message>
    <message>
        <source>&amp;Edit</source>
        <translation>&amp;Uredi</translation>
    </message>
    <message>
        <source>&amp;Curve</source>
        <translation>&amp;Krivulja</translation>
    </message>
    <message>
        <source>&amp;View</source>
        <translation>&amp;Pogled</translation>
    </message>
    <message>
        <source>&amp;Panels</source>
        <translation>&amp;Plošče</translation>
    </message>
    <message>
        <source>&amp;Settings</source>
        <translation>&amp;Nastavitve</translation>
    </message>
    <message>
        <source>&amp;Language</source>
        <translation>&amp;Jezik</translation>
    </message>
    <message>
        <source>&amp;Theme</source>
        <translation>&amp;Tema</translation>
    </message>
    <message>
        <source>&amp;System</source>
        <translation>&amp;Sistemska</translation>
    </message>
    <message>
        <source>&amp;Light</source>
        <translation>S&amp;vetla</translation>
    </message>
    <message>
        <source>&amp;Dark</source>
        <translation>&amp;Temna</translation>
    </message>
    <message>
        <source>&amp;Help</source>
        <translation>Po&amp;moč</translation>
    </message>
    <message>
        <source>Exa&amp;mples</source>
        <translation>&amp;Primeri</translation>
    </message>
    <message>
        <source>Tool bar</source>
        <translation>Orodna vrstica</translation>
    </message>
    <message>
        <source>Use these &amp;points in</source>
        <translation>Uporabi te &amp;točke v zavihku</translation>
    </message>
</context>
<context>
    <name>PointColumn</name>
    <message>
        <source>Join</source>
        <translation>Stik</translation>
    </message>
    <message>
        <source>Multiplicity</source>
        <translation>Večkratnost</translation>
    </message>
    <message>
        <source>One of these is needed: %1.</source>
        <translation>Potrebno je eno od tega: %1.</translation>
    </message>
</context>
<context>
    <name>PointsImport</name>
    <message>
        <source>Import points</source>
        <translation>Uvoz točk</translation>
    </message>
    <message>
        <source>Paths and points (*.svg *.csv *.tsv *.txt);;All files (*)</source>
        <translation>Poti in točke (*.svg *.csv *.tsv *.txt);;Vse datoteke (*)</translation>
    </message>
    <message>
        <source>Nothing was imported</source>
        <translation>Nič ni bilo uvoženo</translation>
    </message>
</context>
<context>
    <name>Properties</name>
    <message>
        <source>Method</source>
        <translation>Metoda</translation>
    </message>
    <message>
        <source>Approximation</source>
        <translation>Aproksimacija</translation>
    </message>
    <message>
        <source>Interpolation</source>
        <translation>Interpolacija</translation>
    </message>
    <message>
        <source>Pairs</source>
        <translation>Pari</translation>
    </message>
    <message>
        <source>Degree</source>
        <translation>Stopnja</translation>
    </message>
    <message>
        <source>Basis</source>
        <translation>Baza</translation>
    </message>
    <message>
        <source>Power basis</source>
        <translation>Potenčna baza</translation>
    </message>
    <message>
        <source>Newton basis</source>
        <translation>Newtonova baza</translation>
    </message>
    <message>
        <source>Lagrange basis</source>
        <translation>Lagrangeeva baza</translation>
    </message>
    <message>
        <source>Chebyshev basis</source>
        <translation>Čebiševa baza</translation>
    </message>
    <message>
        <source>Corrected pairs</source>
        <translation>Popravljeni pari</translation>
    </message>
    <message>
        <source>Animation</source>
        <translation>Animacija</translation>
    </message>
    <message>
        <source>Rule</source>
        <translation>Pravilo</translation>
    </message>
    <message>
        <source>Mirror</source>
        <translation>Zrcalno</translation>
    </message>
    <message>
        <source>Natural</source>
        <translation>Naravni</translation>
    </message>
    <message>
        <source>Clamped</source>
        <translation>Vpeti</translation>
    </message>
    <message>
        <source>Catmull–Rom</source>
        <translation>Catmull–Rom</translation>
    </message>
    <message>
        <source>Selected knots</source>
        <translation>Izbrani vozli</translation>
    </message>
    <message>
        <source>Join</source>
        <translation>Stik</translation>
    </message>
    <message>
        <source>End derivatives</source>
        <translation>Odvoda v krajiščih</translation>
    </message>
    <message>
        <source>Start</source>
        <translation>Začetek</translation>
    </message>
    <message>
        <source>End</source>
        <translation>Konec</translation>
    </message>
    <message>
        <source>Automatic</source>
        <translation>Samodejni</translation>
    </message>
    <message>
        <source>Symmetric</source>
        <translation>Simetrični</translation>
    </message>
    <message>
        <source>Smooth</source>
        <translation>Gladki</translation>
    </message>
    <message>
        <source>Corner</source>
        <translation>Kot</translation>
    </message>
    <message>
        <source>Parameter t</source>
        <translation>Parameter t</translation>
    </message>
    <message>
        <source>Levels</source>
        <translation>Nivoji</translation>
    </message>
    <message>
        <source>Multiplicity of the selected point</source>
        <translation>Večkratnost izbrane točke</translation>
    </message>
    <message>
        <source>Blossom</source>
        <translation>Polarna forma</translation>
    </message>
    <message>
        <source>Arguments</source>
        <translation>Argumenti</translation>
    </message>
    <message>
        <source>Runs over</source>
        <translation>Teče po</translation>
    </message>
    <message>
        <source>The algorithm step by step</source>
        <translation>Algoritem po korakih</translation>
    </message>
    <message>
        <source>Curvature comb</source>
        <translation>Glavnik ukrivljenosti</translation>
    </message>
    <message>
        <source>Scale of the comb</source>
        <translation>Merilo glavnika</translation>
    </message>
    <message>
        <source>Further t</source>
        <translation>Drugi t</translation>
    </message>
    <message>
        <source>Make this the control polygon</source>
        <translation>Sprejmi kot kontrolni poligon</translation>
    </message>
    <message>
        <source>Reduce the degree by one</source>
        <translation>Znižaj stopnjo za ena</translation>
    </message>
    <message>
        <source>Comparison with the built-in drawing</source>
        <translation>Primerjava z vgrajenim risanjem</translation>
    </message>
    <message>
        <source>Points per segment</source>
        <translation>Točk na odsek</translation>
    </message>
    <message>
        <source>Largest deviation</source>
        <translation>Največji odmik</translation>
    </message>
    <message>
        <source>Split here</source>
        <translation>Razdeli tukaj</translation>
    </message>
</context>
<context>
    <name>Sheet</name>
    <message>
        <source>Combined</source>
        <translation>Kombinirani</translation>
    </message>
    <message>
        <source>Elevation</source>
        <translation>Zviševanje</translation>
    </message>
    <message>
        <source>Spline</source>
        <translation>Zlepek</translation>
    </message>
    <message>
        <source>Subdivision</source>
        <translation>Subdivizija</translation>
    </message>
</context>
<context>
    <name>SheetActions</name>
    <message>
        <source>Raise the degree</source>
        <translation>Zvišaj stopnjo</translation>
    </message>
    <message>
        <source>Lower the degree</source>
        <translation>Znižaj stopnjo</translation>
    </message>
    <message>
        <source>Elevate once more</source>
        <translation>Eno zvišanje več</translation>
    </message>
    <message>
        <source>Elevate once less</source>
        <translation>Eno zvišanje manj</translation>
    </message>
    <message>
        <source>Closed</source>
        <translation>Zaprta</translation>
    </message>
    <message>
        <source>Corner</source>
        <translation>Kot</translation>
    </message>
    <message>
        <source>Smooth</source>
        <translation>Gladki</translation>
    </message>
    <message>
        <source>Symmetric</source>
        <translation>Simetrični</translation>
    </message>
    <message>
        <source>Automatic</source>
        <translation>Samodejni</translation>
    </message>
    <message>
        <source>Align handles</source>
        <translation>Poravnaj ročici</translation>
    </message>
    <message>
        <source>Equalize handles</source>
        <translation>Izenači ročici</translation>
    </message>
    <message>
        <source>Pull out handles</source>
        <translation>Izvleči ročici</translation>
    </message>
    <message>
        <source>Retract handles</source>
        <translation>Skrči ročici</translation>
    </message>
    <message>
        <source>One level more</source>
        <translation>En nivo več</translation>
    </message>
    <message>
        <source>One level fewer</source>
        <translation>En nivo manj</translation>
    </message>
    <message>
        <source>Make the elevated polygon the control polygon</source>
        <translation>Sprejmi poligon zvišane stopnje kot kontrolni</translation>
    </message>
    <message>
        <source>Split here, at t</source>
        <translation>Razdeli tukaj, pri t</translation>
    </message>
</context>
<context>
    <name>SheetPanels</name>
    <message>
        <source>Curves</source>
        <translation>Krivulje</translation>
    </message>
    <message>
        <source>Points</source>
        <translation>Točke</translation>
    </message>
    <message>
        <source>Layers</source>
        <translation>Plasti</translation>
    </message>
    <message>
        <source>Properties</source>
        <translation>Lastnosti</translation>
    </message>
    <message>
        <source>Results</source>
        <translation>Rezultati</translation>
    </message>
    <message>
        <source>History</source>
        <translation>Zgodovina</translation>
    </message>
    <message>
        <source>Plots</source>
        <translation>Grafi</translation>
    </message>
    <message>
        <source>Tables</source>
        <translation>Tabele</translation>
    </message>
    <message>
        <source>Guide</source>
        <translation>Priročnik</translation>
    </message>
</context>
<context>
    <name>Step</name>
    <message>
        <source>Set the method</source>
        <translation>Nastavitev metode</translation>
    </message>
    <message>
        <source>Set the degree</source>
        <translation>Nastavitev stopnje</translation>
    </message>
    <message>
        <source>Set the basis</source>
        <translation>Nastavitev baze</translation>
    </message>
    <message>
        <source>Back to automatic</source>
        <translation>Nazaj na samodejno</translation>
    </message>
    <message>
        <source>Raise the degree</source>
        <translation>Zvišanje stopnje</translation>
    </message>
    <message>
        <source>Keep the stage</source>
        <translation>Ohranitev stopnje animacije</translation>
    </message>
    <message>
        <source>Add a point</source>
        <translation>Dodajanje točke</translation>
    </message>
    <message>
        <source>Insert a point</source>
        <translation>Vstavljanje točke</translation>
    </message>
    <message>
        <source>Remove point %1</source>
        <translation>Odstranitev točke %1</translation>
    </message>
    <message>
        <source>Remove points</source>
        <translation>Odstranitev točk</translation>
    </message>
    <message>
        <source>Nudge</source>
        <translation>Pomik za korak</translation>
    </message>
    <message>
        <source>Reverse the curve</source>
        <translation>Obrat krivulje</translation>
    </message>
    <message>
        <source>New curve</source>
        <translation>Nova krivulja</translation>
    </message>
    <message>
        <source>Duplicate the curve</source>
        <translation>Podvojitev krivulje</translation>
    </message>
    <message>
        <source>Delete the curve</source>
        <translation>Izbris krivulje</translation>
    </message>
    <message>
        <source>Rename the curve</source>
        <translation>Preimenovanje krivulje</translation>
    </message>
    <message>
        <source>Colour the curve</source>
        <translation>Barvanje krivulje</translation>
    </message>
    <message>
        <source>Reorder the curves</source>
        <translation>Prerazporeditev krivulj</translation>
    </message>
    <message>
        <source>Clear the canvas</source>
        <translation>Čiščenje platna</translation>
    </message>
    <message>
        <source>Move points</source>
        <translation>Premik točk</translation>
    </message>
    <message>
        <source>Mould the curve</source>
        <translation>Oblikovanje krivulje</translation>
    </message>
    <message>
        <source>Move point %1</source>
        <translation>Premik točke %1</translation>
    </message>
    <message>
        <source>Move a handle of knot %1</source>
        <translation>Premik ročice vozla %1</translation>
    </message>
    <message>
        <source>Move an inner point of segment %1</source>
        <translation>Premik notranje točke odseka %1</translation>
    </message>
    <message>
        <source>Move the middle point of pair %1</source>
        <translation>Premik vmesne točke para %1</translation>
    </message>
    <message>
        <source>Change the start derivative</source>
        <translation>Sprememba začetnega odvoda</translation>
    </message>
    <message>
        <source>Change the end derivative</source>
        <translation>Sprememba končnega odvoda</translation>
    </message>
    <message>
        <source>Set the rule</source>
        <translation>Nastavitev pravila</translation>
    </message>
    <message>
        <source>Close the curve</source>
        <translation>Zaprtje krivulje</translation>
    </message>
    <message>
        <source>Open the curve</source>
        <translation>Odprtje krivulje</translation>
    </message>
    <message>
        <source>Set the join</source>
        <translation>Nastavitev stika</translation>
    </message>
    <message>
        <source>Set the parameter t</source>
        <translation>Nastavitev parametra t</translation>
    </message>
    <message>
        <source>Set the levels</source>
        <translation>Nastavitev nivojev</translation>
    </message>
    <message>
        <source>Set the multiplicity</source>
        <translation>Nastavitev večkratnosti</translation>
    </message>
    <message>
        <source>Show the blossom</source>
        <translation>Prikaz polarne forme</translation>
    </message>
    <message>
        <source>Hide the blossom</source>
        <translation>Skrivanje polarne forme</translation>
    </message>
    <message>
        <source>Set the blossom</source>
        <translation>Nastavitev polarne forme</translation>
    </message>
    <message>
        <source>Cut the curve</source>
        <translation>Izrez krivulje</translation>
    </message>
    <message>
        <source>Cut points</source>
        <translation>Izrez točk</translation>
    </message>
    <message>
        <source>Paste points</source>
        <translation>Lepljenje točk</translation>
    </message>
    <message>
        <source>Paste the curve</source>
        <translation>Lepljenje krivulje</translation>
    </message>
    <message>
        <source>Duplicate points</source>
        <translation>Podvojitev točk</translation>
    </message>
    <message>
        <source>Set the width of the line</source>
        <translation>Nastavitev debeline črte</translation>
    </message>
    <message>
        <source>Set the dashes of the line</source>
        <translation>Nastavitev vrste črte</translation>
    </message>
    <message>
        <source>Set the marks of the points</source>
        <translation>Nastavitev znakov točk</translation>
    </message>
    <message>
        <source>Show the labels</source>
        <translation>Prikaz oznak</translation>
    </message>
    <message>
        <source>Hide the labels</source>
        <translation>Skritje oznak</translation>
    </message>
    <message>
        <source>Reset the style</source>
        <translation>Ponastavitev sloga</translation>
    </message>
    <message>
        <source>Use the points of a tab</source>
        <translation>Uporaba točk z drugega zavihka</translation>
    </message>
    <message>
        <source>Retract a handle of knot %1</source>
        <translation>Skrčenje ročice vozla %1</translation>
    </message>
    <message>
        <source>Retract the handles</source>
        <translation>Skrčenje ročic</translation>
    </message>
    <message>
        <source>Align the handles</source>
        <translation>Poravnava ročic</translation>
    </message>
    <message>
        <source>Equalize the handles</source>
        <translation>Izenačenje ročic</translation>
    </message>
    <message>
        <source>Pull out the handles</source>
        <translation>Izvlek ročic</translation>
    </message>
    <message>
        <source>Take the elevated polygon over</source>
        <translation>Prevzem poligona zvišane stopnje</translation>
    </message>
    <message>
        <source>Reduce the degree</source>
        <translation>Znižanje stopnje</translation>
    </message>
    <message>
        <source>Split the curve</source>
        <translation>Razdelitev krivulje</translation>
    </message>
    <message>
        <source>Paste curves</source>
        <translation>Lepljenje krivulj</translation>
    </message>
    <message>
        <source>Import curves</source>
        <translation>Uvoz krivulj</translation>
    </message>
</context>
<context>
    <name>StyleEditor</name>
    <message>
        <source>Solid</source>
        <translation>Polna</translation>
    </message>
    <message>
        <source>Dashed</source>
        <translation>Črtkana</translation>
    </message>
    <message>
        <source>Dotted</source>
        <translation>Pikčasta</translation>
    </message>
    <message>
        <source>Dash-dot</source>
        <translation>Črta-pika</translation>
    </message>
    <message>
        <source>As usual</source>
        <translation>Kot običajno</translation>
    </message>
    <message>
        <source>None</source>
        <translation>Brez</translation>
    </message>
    <message>
        <source>Circles</source>
        <translation>Krogci</translation>
    </message>
    <message>
        <source>Squares</source>
        <translation>Kvadratki</translation>
    </message>
    <message>
        <source>Diamonds</source>
        <translation>Rombi</translation>
    </message>
</context>
<context>
    <name>TableErrors</name>
    <message>
        <source>there are no points</source>
        <translation>ni točk</translation>
    </message>
    <message>
        <source>more than %1 points are too many</source>
        <translation>več kot %1 točk je preveč</translation>
    </message>
    <message>
        <source>expected two numbers</source>
        <translation>pričakovani sta dve števili</translation>
    </message>
    <message>
        <source>“%1” is no number</source>
        <translation>»%1« ni število</translation>
    </message>
    <message>
        <source>“%1” is not from %2 to %3</source>
        <translation>»%1« ni med %2 in %3</translation>
    </message>
    <message>
        <source>“%1” has another decimal sign than the numbers before it</source>
        <translation>»%1« ima drug decimalni znak kot števila pred njim</translation>
    </message>
    <message>
        <source>line %1, column %2</source>
        <translation>vrstica %1, stolpec %2</translation>
    </message>
    <message>
        <source>a curve takes at most %1 points</source>
        <translation>krivulja sprejme največ %1 točk</translation>
    </message>
</context>
<context>
    <name>Values</name>
    <message>
        <source>more than %L1</source>
        <translation>več kot %L1</translation>
    </message>
</context>
<context>
    <name>kriva::ui::AboutDialog</name>
    <message>
        <source>About Kriva</source>
        <translation>O programu Kriva</translation>
    </message>
    <message>
        <source>A workbench for Bézier curves.</source>
        <translation>Delavnica za Bézierove krivulje.</translation>
    </message>
    <message>
        <source>Free software under the MIT licence.</source>
        <translation>Prosto programje pod licenco MIT.</translation>
    </message>
    <message>
        <source>Built on %1 (LGPL, dynamically linked), Eigen, JSON for Modern C++ and pugixml.</source>
        <translation>Zgrajeno na %1 (LGPL, dinamično povezano), Eigen, JSON for Modern C++ in pugixml.</translation>
    </message>
</context>
<context>
    <name>kriva::ui::CanvasView</name>
    <message>
        <source>Canvas</source>
        <translation>Platno</translation>
    </message>
</context>
<context>
    <name>kriva::ui::CombinedProperties</name>
    <message>
        <source>Back to automatic</source>
        <translation>Nazaj na samodejno</translation>
    </message>
    <message>
        <source>Puts the selected middle points, or all where none is selected, where the tangents meet</source>
        <translation>Postavi izbrane vmesne točke, ali vse, če ni izbrana nobena, kjer se sekata tangenti</translation>
    </message>
    <message>
        <source>1 of 5: the given points</source>
        <translation>1 od 5: dane točke</translation>
    </message>
    <message>
        <source>2 of 5: monotone runs</source>
        <translation>2 od 5: monotoni odseki</translation>
    </message>
    <message>
        <source>3 of 5: a polynomial for each run</source>
        <translation>3 od 5: polinom za vsak odsek</translation>
    </message>
    <message>
        <source>4 of 5: joins between the runs</source>
        <translation>4 od 5: stiki med odseki</translation>
    </message>
    <message>
        <source>5 of 5: the whole curve</source>
        <translation>5 od 5: celotna krivulja</translation>
    </message>
</context>
<context>
    <name>kriva::ui::CurvesPanel</name>
    <message>
        <source>New curve</source>
        <translation>Nova krivulja</translation>
    </message>
    <message>
        <source>Duplicate the curve</source>
        <translation>Podvoji krivuljo</translation>
    </message>
    <message>
        <source>Delete the curve</source>
        <translation>Izbriši krivuljo</translation>
    </message>
    <message>
        <source>Move the curve up</source>
        <translation>Premakni krivuljo navzgor</translation>
    </message>
    <message>
        <source>Move the curve down</source>
        <translation>Premakni krivuljo navzdol</translation>
    </message>
    <message>
        <source>Colour of the curve</source>
        <translation>Barva krivulje</translation>
    </message>
    <message>
        <source>Curves</source>
        <translation>Krivulje</translation>
    </message>
    <message>
        <source>Style of the curve</source>
        <translation>Slog krivulje</translation>
    </message>
</context>
<context>
    <name>kriva::ui::DocumentSession</name>
    <message>
        <source>Untitled</source>
        <translation>Brez imena</translation>
    </message>
    <message>
        <source>Open</source>
        <translation>Odpiranje</translation>
    </message>
    <message>
        <source>Documents and figures of Kriva (*.kriva *.svg)</source>
        <translation>Dokumenti in slike programa Kriva (*.kriva *.svg)</translation>
    </message>
    <message>
        <source>Save as</source>
        <translation>Shranjevanje kot</translation>
    </message>
    <message>
        <source>Documents of Kriva (*.kriva)</source>
        <translation>Dokumenti programa Kriva (*.kriva)</translation>
    </message>
    <message>
        <source>Unsaved changes cannot be kept for a recovery: %1</source>
        <translation>Neshranjenih sprememb ni mogoče ohraniti za obnovitev: %1</translation>
    </message>
</context>
<context>
    <name>kriva::ui::ElevationProperties</name>
    <message>
        <source>The curve then moves by at most %1</source>
        <translation>Krivulja se pri tem premakne za največ %1</translation>
    </message>
    <message>
        <source>The degree cannot fall any more</source>
        <translation>Stopnje ni mogoče več znižati</translation>
    </message>
    <message>
        <source>The curve then stays as it is</source>
        <translation>Krivulja pri tem ostane enaka</translation>
    </message>
</context>
<context>
    <name>kriva::ui::ExportDialog</name>
    <message>
        <source>Export figure</source>
        <translation>Izvoz slike</translation>
    </message>
    <message>
        <source>SVG figure</source>
        <translation>Slika SVG</translation>
    </message>
    <message>
        <source>PDF page</source>
        <translation>Stran PDF</translation>
    </message>
    <message>
        <source>PNG picture</source>
        <translation>Slika PNG</translation>
    </message>
    <message>
        <source>TikZ for LaTeX</source>
        <translation>TikZ za LaTeX</translation>
    </message>
    <message>
        <source>CSV of the points</source>
        <translation>CSV s točkami</translation>
    </message>
    <message>
        <source>Light</source>
        <translation>Svetle</translation>
    </message>
    <message>
        <source>Dark</source>
        <translation>Temne</translation>
    </message>
    <message>
        <source>&amp;Format</source>
        <translation>&amp;Oblika zapisa</translation>
    </message>
    <message>
        <source>&amp;Margin (mm)</source>
        <translation>&amp;Rob (mm)</translation>
    </message>
    <message>
        <source>Page</source>
        <translation>Stran</translation>
    </message>
    <message>
        <source>&amp;Colours</source>
        <translation>&amp;Barve</translation>
    </message>
    <message>
        <source>La&amp;yers</source>
        <translation>&amp;Plasti</translation>
    </message>
    <message>
        <source>D&amp;ecimals</source>
        <translation>&amp;Decimalke</translation>
    </message>
    <message>
        <source>&amp;Dots per inch</source>
        <translation>Pik na pal&amp;ec</translation>
    </message>
    <message>
        <source>Text&amp;s in the figure</source>
        <translation>Besedil&amp;a na sliki</translation>
    </message>
    <message>
        <source>Layers for &amp;Inkscape</source>
        <translation>Plasti za &amp;Inkscape</translation>
    </message>
    <message>
        <source>&amp;Round coordinates</source>
        <translation>Zaokroži &amp;koordinate</translation>
    </message>
    <message>
        <source>&amp;Transparent</source>
        <translation>Pro&amp;sojna</translation>
    </message>
    <message>
        <source>A &amp;part for another document</source>
        <translation>Del za dr&amp;ug dokument</translation>
    </message>
    <message>
        <source>The figure as it will be</source>
        <translation>Slika, kakršna bo</translation>
    </message>
    <message>
        <source>%1 × %2 mm</source>
        <translation>%1 × %2 mm</translation>
    </message>
    <message>
        <source>The document &amp;goes along, to open the file again</source>
        <translation>Dokument &amp;gre zraven, da se datoteka spet odpre</translation>
    </message>
    <message>
        <source>E&amp;xport…</source>
        <translation>Iz&amp;vozi …</translation>
    </message>
    <message>
        <source>Fra&amp;mes</source>
        <translation>Sli&amp;čice</translation>
    </message>
    <message>
        <source>Seconds of &amp;a frame</source>
        <translation>Sekunde sliči&amp;ce</translation>
    </message>
    <message>
        <source>0; 5; 10 or 0..10 or t = 0.25; 0.5</source>
        <translation>0; 5; 10 ali 0..10 ali t = 0,25; 0,5</translation>
    </message>
    <message>
        <source>A&amp;nimated</source>
        <translation>A&amp;nimirana</translation>
    </message>
    <message>
        <source>O&amp;utlines in place of letters</source>
        <translation>Obrisi na&amp;mesto črk</translation>
    </message>
    <message>
        <source>Scale (mm for a unit)</source>
        <translation>Merilo (mm na enoto)</translation>
    </message>
    <message>
        <source>Width (mm)</source>
        <translation>Širina (mm)</translation>
    </message>
    <message>
        <source>Set the &amp;width</source>
        <translation>Določi &amp;širino</translation>
    </message>
    <message>
        <source>Set the scale</source>
        <translation>Določi merilo</translation>
    </message>
</context>
<context>
    <name>kriva::ui::FigureExport</name>
    <message>
        <source>The figure was not written</source>
        <translation>Slika ni bila zapisana</translation>
    </message>
    <message>
        <source>Export figure</source>
        <translation>Izvoz slike</translation>
    </message>
    <message>
        <source>Figures (%1)</source>
        <translation>Slike (%1)</translation>
    </message>
    <message>
        <source>Written: %1</source>
        <translation>Zapisano: %1</translation>
    </message>
    <message>
        <source>Print</source>
        <translation>Tiskanje</translation>
    </message>
    <message>
        <source>Working out the figure…</source>
        <translation>Izračunavanje slike…</translation>
    </message>
</context>
<context>
    <name>kriva::ui::FramesField</name>
    <message numerus="yes">
        <source>At most %n frame(s): stages, such as 0; 5 or 0..10, or values of t, such as t = 0.25; 0.5.</source>
        <translation>
            <numerusform>Največ %n sličica: stopnje animacije, na primer 0; 5 ali 0..10, ali vrednosti t, na primer t = 0,25; 0,5.</numerusform>
            <numerusform>Največ %n sličici: stopnje animacije, na primer 0; 5 ali 0..10, ali vrednosti t, na primer t = 0,25; 0,5.</numerusform>
            <numerusform>Največ %n sličice: stopnje animacije, na primer 0; 5 ali 0..10, ali vrednosti t, na primer t = 0,25; 0,5.</numerusform>
            <numerusform>Največ %n sličic: stopnje animacije, na primer 0; 5 ali 0..10, ali vrednosti t, na primer t = 0,25; 0,5.</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>kriva::ui::GuidePanel</name>
    <message>
        <source>Guide</source>
        <translation>Priročnik</translation>
    </message>
</context>
<context>
    <name>kriva::ui::HistoryPanel</name>
    <message>
        <source>History</source>
        <translation>Zgodovina</translation>
    </message>
    <message>
        <source>Beginning</source>
        <translation>Začetek</translation>
    </message>
</context>
<context>
    <name>kriva::ui::ImportDialog</name>
    <message>
        <source>Import points</source>
        <translation>Uvoz točk</translation>
    </message>
    <message>
        <source>&amp;Curves</source>
        <translation>&amp;Krivulje</translation>
    </message>
    <message>
        <source>Curves</source>
        <translation>Krivulje</translation>
    </message>
    <message>
        <source>&amp;Scale</source>
        <translation>&amp;Merilo</translation>
    </message>
    <message>
        <source>Move by &amp;x</source>
        <translation>Premik po &amp;x</translation>
    </message>
    <message>
        <source>Move by &amp;y</source>
        <translation>Premik po &amp;y</translation>
    </message>
    <message>
        <source>The curves as they will be</source>
        <translation>Krivulje, kakršne bodo</translation>
    </message>
    <message>
        <source>&amp;Import</source>
        <translation>&amp;Uvozi</translation>
    </message>
    <message numerus="yes">
        <source>%n point(s)</source>
        <translation>
            <numerusform>%n točka</numerusform>
            <numerusform>%n točki</numerusform>
            <numerusform>%n točke</numerusform>
            <numerusform>%n točk</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>kriva::ui::LayersPanel</name>
    <message>
        <source>Layers</source>
        <translation>Plasti</translation>
    </message>
</context>
<context>
    <name>kriva::ui::MainWindow</name>
    <message>
        <source>&amp;Undo: %1</source>
        <translation>&amp;Razveljavi: %1</translation>
    </message>
    <message>
        <source>&amp;Undo</source>
        <translation>&amp;Razveljavi</translation>
    </message>
    <message>
        <source>&amp;Redo: %1</source>
        <translation>&amp;Znova uveljavi: %1</translation>
    </message>
    <message>
        <source>&amp;Redo</source>
        <translation>&amp;Znova uveljavi</translation>
    </message>
    <message>
        <source>Sheets</source>
        <translation>Listi</translation>
    </message>
</context>
<context>
    <name>kriva::ui::NoticeBar</name>
    <message>
        <source>The file “%1” was deleted or moved by another program.</source>
        <translation>Datoteko »%1« je izbrisal ali premaknil drug program.</translation>
    </message>
    <message>
        <source>Another program changed the file “%1”.</source>
        <translation>Drug program je spremenil datoteko »%1«.</translation>
    </message>
    <message>
        <source>Save again</source>
        <translation>Znova shrani</translation>
    </message>
    <message>
        <source>Reload</source>
        <translation>Znova naloži</translation>
    </message>
    <message>
        <source>Leave as it is</source>
        <translation>Pusti tako</translation>
    </message>
</context>
<context>
    <name>kriva::ui::NumberField</name>
    <message>
        <source>A whole number from %1 to %2 is needed.</source>
        <translation>Potrebno je celo število od %1 do %2.</translation>
    </message>
    <message>
        <source>A number above %1 and below %2 is needed.</source>
        <translation>Potrebno je število nad %1 in pod %2.</translation>
    </message>
    <message>
        <source>A number from %1 to %2 is needed.</source>
        <translation>Potrebno je število od %1 do %2.</translation>
    </message>
</context>
<context>
    <name>kriva::ui::NumberListField</name>
    <message numerus="yes">
        <source>%n number(s) from %1 to %2, with semicolons between them.</source>
        <translation>
            <numerusform>%n število od %1 do %2, med njimi podpičja.</numerusform>
            <numerusform>%n števili od %1 do %2, med njimi podpičja.</numerusform>
            <numerusform>%n števila od %1 do %2, med njimi podpičja.</numerusform>
            <numerusform>%n števil od %1 do %2, med njimi podpičja.</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>At most %n number(s) above %1 and below %2, with semicolons between them.</source>
        <translation>
            <numerusform>Največ %n število nad %1 in pod %2, med njimi podpičja.</numerusform>
            <numerusform>Največ %n števili nad %1 in pod %2, med njimi podpičja.</numerusform>
            <numerusform>Največ %n števila nad %1 in pod %2, med njimi podpičja.</numerusform>
            <numerusform>Največ %n števil nad %1 in pod %2, med njimi podpičja.</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>kriva::ui::Player</name>
    <message>
        <source>%1×</source>
        <comment>speed of an animation</comment>
        <translation>%1×</translation>
    </message>
    <message>
        <source>One stage back</source>
        <translation>Eno stopnjo nazaj</translation>
    </message>
    <message>
        <source>One stage on</source>
        <translation>Eno stopnjo naprej</translation>
    </message>
    <message>
        <source>Pause</source>
        <translation>Premor</translation>
    </message>
    <message>
        <source>Play</source>
        <translation>Predvajaj</translation>
    </message>
    <message>
        <source>Slower</source>
        <translation>Počasneje</translation>
    </message>
    <message>
        <source>Faster</source>
        <translation>Hitreje</translation>
    </message>
    <message>
        <source>Over and over</source>
        <translation>Znova in znova</translation>
    </message>
    <message>
        <source>Direction of the animation: forwards</source>
        <translation>Smer animacije: naprej</translation>
    </message>
    <message>
        <source>Direction of the animation: backwards</source>
        <translation>Smer animacije: nazaj</translation>
    </message>
    <message>
        <source>Direction of the animation: to and fro</source>
        <translation>Smer animacije: sem in tja</translation>
    </message>
    <message>
        <source>Animation speed</source>
        <translation>Hitrost animacije</translation>
    </message>
    <message>
        <source>Stage</source>
        <translation>Stopnja animacije</translation>
    </message>
    <message>
        <source>Keep this stage</source>
        <translation>Ohrani to stopnjo</translation>
    </message>
    <message>
        <source>Writes the stage on view into the document</source>
        <translation>Zapiše prikazano stopnjo v dokument</translation>
    </message>
    <message>
        <source>Animation</source>
        <translation>Animacija</translation>
    </message>
</context>
<context>
    <name>kriva::ui::PlotsPanel</name>
    <message>
        <source>Plot</source>
        <translation>Graf</translation>
    </message>
    <message>
        <source>Export the plot</source>
        <translation>Izvozi graf</translation>
    </message>
</context>
<context>
    <name>kriva::ui::PointsModel</name>
    <message>
        <source>New point</source>
        <translation>Nova točka</translation>
    </message>
</context>
<context>
    <name>kriva::ui::PointsPanel</name>
    <message>
        <source>Points</source>
        <translation>Točke</translation>
    </message>
</context>
<context>
    <name>kriva::ui::PropertiesPanel</name>
    <message>
        <source>Less</source>
        <translation>Manj</translation>
    </message>
    <message>
        <source>More</source>
        <translation>Več</translation>
    </message>
</context>
<context>
    <name>kriva::ui::RecoveryDialog</name>
    <message>
        <source>Untitled</source>
        <translation>Brez imena</translation>
    </message>
    <message>
        <source>never saved · changed %1</source>
        <comment>a document and a time</comment>
        <translation>še ni shranjen · spremenjen %1</translation>
    </message>
    <message>
        <source>%1 · changed %2</source>
        <comment>a folder and a time</comment>
        <translation>%1 · spremenjen %2</translation>
    </message>
    <message>
        <source>Damaged: it cannot be read any more.</source>
        <translation>Poškodovan: ni ga več mogoče prebrati.</translation>
    </message>
    <message>
        <source>Damaged: look closely at what is recovered.</source>
        <translation>Poškodovan: natančno preglejte, kaj je obnovljeno.</translation>
    </message>
    <message>
        <source>What to do with %1</source>
        <translation>Kaj naj se zgodi z dokumentom %1</translation>
    </message>
    <message>
        <source>Recover</source>
        <translation>Obnovi</translation>
    </message>
    <message>
        <source>Ask later</source>
        <translation>Vprašaj pozneje</translation>
    </message>
    <message>
        <source>Discard</source>
        <translation>Zavrzi</translation>
    </message>
    <message>
        <source>Recover unsaved work</source>
        <translation>Obnovitev neshranjenega dela</translation>
    </message>
    <message>
        <source>Kriva ended before this was saved</source>
        <translation>Kriva se je končala, preden je bilo to shranjeno</translation>
    </message>
    <message>
        <source>What is recovered opens in a window of its own and is written to its file only when you save.</source>
        <translation>Obnovljeno se odpre v svojem oknu in se v svojo datoteko zapiše šele, ko shranite.</translation>
    </message>
    <message>
        <source>&amp;Continue</source>
        <translation>&amp;Nadaljuj</translation>
    </message>
    <message>
        <source>Ask &amp;later about all</source>
        <translation>Vprašaj &amp;pozneje o vseh</translation>
    </message>
    <message>
        <source>Missing: the unsaved work is not there any more.</source>
        <translation>Manjka: neshranjenega dela ni več.</translation>
    </message>
</context>
<context>
    <name>kriva::ui::ResultsModel</name>
    <message>
        <source>Name</source>
        <translation>Ime</translation>
    </message>
    <message>
        <source>Value</source>
        <translation>Vrednost</translation>
    </message>
</context>
<context>
    <name>kriva::ui::ResultsPanel</name>
    <message>
        <source>Results</source>
        <translation>Rezultati</translation>
    </message>
</context>
<context>
    <name>kriva::ui::ShortcutsDialog</name>
    <message>
        <source>Shortcuts</source>
        <translation>Bližnjice</translation>
    </message>
    <message>
        <source>Search</source>
        <translation>Iskanje</translation>
    </message>
    <message>
        <source>What it does</source>
        <translation>Kaj naredi</translation>
    </message>
    <message>
        <source>Keys and mouse</source>
        <translation>Tipke in miška</translation>
    </message>
</context>
<context>
    <name>kriva::ui::SplineProperties</name>
    <message>
        <source>Closed</source>
        <translation>Zaprta</translation>
    </message>
    <message>
        <source>Given here; otherwise that of the natural spline</source>
        <translation>Podan tukaj; sicer odvod naravnega zlepka</translation>
    </message>
    <message>
        <source>Given</source>
        <translation>Podan</translation>
    </message>
    <message>
        <source>Show the comb</source>
        <translation>Pokaži glavnik</translation>
    </message>
    <message>
        <source>Show the polyline</source>
        <translation>Pokaži lomljenko</translation>
    </message>
</context>
<context>
    <name>kriva::ui::StatusRow</name>
    <message>
        <source>x %1   y %2</source>
        <comment>the pointer&apos;s coordinates</comment>
        <translation>x %1   y %2</translation>
    </message>
    <message>
        <source>%1 %</source>
        <comment>zoom in percent</comment>
        <translation>%1 %</translation>
    </message>
    <message>
        <source>Coordinates of the pointer</source>
        <translation>Koordinati kazalca</translation>
    </message>
    <message>
        <source>Zoom</source>
        <translation>Merilo</translation>
    </message>
</context>
<context>
    <name>kriva::ui::StyleEditor</name>
    <message>
        <source>Width of the line</source>
        <translation>Debelina črte</translation>
    </message>
    <message>
        <source>Line</source>
        <translation>Črta</translation>
    </message>
    <message>
        <source>Marks of the points</source>
        <translation>Znaki točk</translation>
    </message>
    <message>
        <source>Labels</source>
        <translation>Oznake</translation>
    </message>
    <message>
        <source>Usual style</source>
        <translation>Običajen slog</translation>
    </message>
</context>
<context>
    <name>kriva::ui::SubdivisionProperties</name>
    <message>
        <source>Show the curve</source>
        <translation>Pokaži krivuljo</translation>
    </message>
    <message>
        <source>Show the blossom</source>
        <translation>Pokaži polarno formo</translation>
    </message>
    <message>
        <source>Parameter t</source>
        <translation>Parameter t</translation>
    </message>
    <message>
        <source>Levels</source>
        <translation>Nivoji</translation>
    </message>
    <message>
        <source>Shows the de Casteljau scheme at these t as well, like 0.25; 0.75</source>
        <translation>Pokaže de Casteljaujevo shemo tudi pri teh t, na primer 0,25; 0,75</translation>
    </message>
    <message>
        <source>Show the pieces</source>
        <translation>Pokaži kose</translation>
    </message>
</context>
<context>
    <name>kriva::ui::TablesPanel</name>
    <message>
        <source>Table</source>
        <translation>Tabela</translation>
    </message>
    <message>
        <source>Numbers of the table</source>
        <translation>Števila v tabeli</translation>
    </message>
    <message>
        <source>LaTeX</source>
        <translation>LaTeX</translation>
    </message>
    <message>
        <source>Copy the table as LaTeX</source>
        <translation>Kopiraj tabelo kot LaTeX</translation>
    </message>
    <message>
        <source>CSV</source>
        <translation>CSV</translation>
    </message>
    <message>
        <source>Copy the table for a spreadsheet</source>
        <translation>Kopiraj tabelo za preglednico</translation>
    </message>
</context>
</TS>
