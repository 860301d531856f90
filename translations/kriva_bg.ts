<?xml version="1.0" encoding="utf-8"?>
<!DOCTYPE TS>
<TS version="2.1" language="bg" sourcelanguage="en">
<context>
    <name>Actions</name>
    <message>
        <source>&amp;New</source>
        <translation>&amp;Нов</translation>
    </message>
    <message>
        <source>&amp;Open…</source>
        <translation>&amp;Отваряне…</translation>
    </message>
    <message>
        <source>&amp;Save</source>
        <translation>&amp;Запазване</translation>
    </message>
    <message>
        <source>Save &amp;as…</source>
        <translation>Запазване &amp;като…</translation>
    </message>
    <message>
        <source>&amp;Export figure…</source>
        <translation>Изнасяне на &amp;фигура…</translation>
    </message>
    <message>
        <source>&amp;Quit</source>
        <translation>&amp;Изход</translation>
    </message>
    <message>
        <source>&amp;Undo</source>
        <translation>&amp;Отмяна</translation>
    </message>
    <message>
        <source>&amp;Redo</source>
        <translation>&amp;Повтаряне</translation>
    </message>
    <message>
        <source>&amp;Delete</source>
        <translation>&amp;Изтриване</translation>
    </message>
    <message>
        <source>Delete &amp;last point</source>
        <translation>Изтриване на последната &amp;точка</translation>
    </message>
    <message>
        <source>&amp;Clear the canvas</source>
        <translation>Изчистване на п&amp;латното</translation>
    </message>
    <message>
        <source>Select &amp;all</source>
        <translation>Избиране на &amp;всичко</translation>
    </message>
    <message>
        <source>Select n&amp;one</source>
        <translation>&amp;Без избор</translation>
    </message>
    <message>
        <source>&amp;Invert the selection</source>
        <translation>Об&amp;ръщане на избора</translation>
    </message>
    <message>
        <source>&amp;New curve</source>
        <translation>&amp;Нова крива</translation>
    </message>
    <message>
        <source>&amp;Duplicate the curve</source>
        <translation>&amp;Дублиране на кривата</translation>
    </message>
    <message>
        <source>De&amp;lete the curve</source>
        <translation>&amp;Изтриване на кривата</translation>
    </message>
    <message>
        <source>Ne&amp;xt curve</source>
        <translation>&amp;Следваща крива</translation>
    </message>
    <message>
        <source>&amp;Reverse</source>
        <translation>&amp;Обръщане</translation>
    </message>
    <message>
        <source>&amp;Edit tool</source>
        <translation>Инструмент за &amp;редактиране</translation>
    </message>
    <message>
        <source>&amp;Add tool</source>
        <translation>Инструмент за &amp;добавяне</translation>
    </message>
    <message>
        <source>Zoom &amp;in</source>
        <translation>&amp;Увеличаване</translation>
    </message>
    <message>
        <source>Zoom &amp;out</source>
        <translation>&amp;Намаляване</translation>
    </message>
    <message>
        <source>Zoom to &amp;100 %</source>
        <translation>Мащаб &amp;100 %</translation>
    </message>
    <message>
        <source>&amp;Fit all</source>
        <translation>&amp;Всичко в изгледа</translation>
    </message>
    <message>
        <source>Fit &amp;selection</source>
        <translation>&amp;Избраното в изгледа</translation>
    </message>
    <message>
        <source>&amp;Grid</source>
        <translation>&amp;Мрежа</translation>
    </message>
    <message>
        <source>A&amp;xes</source>
        <translation>&amp;Оси</translation>
    </message>
    <message>
        <source>&amp;Reset panels</source>
        <translation>Върни &amp;панелите</translation>
    </message>
    <message>
        <source>F&amp;ull screen</source>
        <translation>&amp;Цял екран</translation>
    </message>
    <message>
        <source>&amp;About Kriva</source>
        <translation>&amp;Относно Крива</translation>
    </message>
    <message>
        <source>About &amp;Qt</source>
        <translation>Относно &amp;Qt</translation>
    </message>
    <message>
        <source>S&amp;how the history</source>
        <translation>Показване на ис&amp;торията</translation>
    </message>
    <message>
        <source>Cu&amp;t</source>
        <translation>И&amp;зрязване</translation>
    </message>
    <message>
        <source>Co&amp;py</source>
        <translation>&amp;Копиране</translation>
    </message>
    <message>
        <source>Pa&amp;ste</source>
        <translation>Пост&amp;авяне</translation>
    </message>
    <message>
        <source>Duplicat&amp;e</source>
        <translation>&amp;Дублиране</translation>
    </message>
    <message>
        <source>Rena&amp;me</source>
        <translation>&amp;Преименуване</translation>
    </message>
    <message>
        <source>Move &amp;up in the list</source>
        <translation>Преместване на&amp;горе в списъка</translation>
    </message>
    <message>
        <source>Move do&amp;wn in the list</source>
        <translation>Преместване надо&amp;лу в списъка</translation>
    </message>
    <message>
        <source>&amp;Show the curve</source>
        <translation>Пока&amp;зване на кривата</translation>
    </message>
    <message>
        <source>Ru&amp;lers</source>
        <translation>&amp;Линийки</translation>
    </message>
    <message>
        <source>S&amp;nap</source>
        <translation>Прил&amp;епване</translation>
    </message>
    <message>
        <source>&amp;Insert a point</source>
        <translation>&amp;Вмъкване на точка</translation>
    </message>
    <message>
        <source>User &amp;guide</source>
        <translation>&amp;Ръководство</translation>
    </message>
    <message>
        <source>&amp;Shortcuts</source>
        <translation>&amp;Клавишни комбинации</translation>
    </message>
    <message>
        <source>Export a&amp;gain</source>
        <translation>Изнасяне о&amp;тново</translation>
    </message>
    <message>
        <source>Copy &amp;figure</source>
        <translation>Копиране на фи&amp;гура</translation>
    </message>
    <message>
        <source>Copy as &amp;TikZ</source>
        <translation>Копиране като &amp;TikZ</translation>
    </message>
    <message>
        <source>&amp;Import points…</source>
        <translation>&amp;Внасяне на точки…</translation>
    </message>
    <message>
        <source>Copy pat&amp;h</source>
        <translation>Копиране на п&amp;ътя</translation>
    </message>
    <message>
        <source>&amp;Print…</source>
        <translation>П&amp;ечат…</translation>
    </message>
    <message>
        <source>New &amp;window</source>
        <translation>Нов п&amp;розорец</translation>
    </message>
</context>
<context>
    <name>CanvasAccessible</name>
    <message>
        <source>Point %1</source>
        <translation>Точка %1</translation>
    </message>
</context>
<context>
    <name>Caption</name>
    <message>
        <source>Degree elevation</source>
        <translation>Повишаване на степента</translation>
    </message>
    <message>
        <source>Subdivision</source>
        <translation>Подразделяне</translation>
    </message>
    <message>
        <source>Spline</source>
        <translation>Сплайн</translation>
    </message>
    <message>
        <source>Combined algorithm</source>
        <translation>Комбиниран алгоритъм</translation>
    </message>
    <message>
        <source>Curve</source>
        <translation>Крива</translation>
    </message>
    <message>
        <source>Control polygon</source>
        <translation>Контролен полигон</translation>
    </message>
    <message>
        <source>Elevated polygon</source>
        <translation>Полигон с повишена степен</translation>
    </message>
    <message>
        <source>Points</source>
        <translation>Точки</translation>
    </message>
    <message>
        <source>Labels</source>
        <translation>Означения</translation>
    </message>
    <message>
        <source>De Casteljau scheme</source>
        <translation>Схема на дьо Кастелжо</translation>
    </message>
    <message>
        <source>Curves of degree n − 1</source>
        <translation>Криви от степен n − 1</translation>
    </message>
    <message>
        <source>Pieces</source>
        <translation>Части</translation>
    </message>
    <message>
        <source>Left polygon</source>
        <translation>Ляв полигон</translation>
    </message>
    <message>
        <source>Right polygon</source>
        <translation>Десен полигон</translation>
    </message>
    <message>
        <source>Point of the curve</source>
        <translation>Точка от кривата</translation>
    </message>
    <message>
        <source>Blossom</source>
        <translation>Полярна форма (blossom)</translation>
    </message>
    <message>
        <source>Labels of left and right</source>
        <translation>Означения на ляв и десен</translation>
    </message>
    <message>
        <source>Degree</source>
        <translation>Степен</translation>
    </message>
    <message>
        <source>Length</source>
        <translation>Дължина</translation>
    </message>
    <message>
        <source>Bounds</source>
        <translation>Граници</translation>
    </message>
    <message>
        <source>Degree after elevation</source>
        <translation>Степен след повишаването</translation>
    </message>
    <message>
        <source>Gap between polygon and curve</source>
        <translation>Разстояние между полигона и кривата</translation>
    </message>
    <message>
        <source>Point at t</source>
        <translation>Точка при t</translation>
    </message>
    <message>
        <source>Derivative at t</source>
        <translation>Производна при t</translation>
    </message>
    <message>
        <source>Number of pieces</source>
        <translation>Брой на частите</translation>
    </message>
    <message>
        <source>Knots</source>
        <translation>Възли</translation>
    </message>
    <message>
        <source>Handles</source>
        <translation>Манипулатори</translation>
    </message>
    <message>
        <source>End derivatives</source>
        <translation>Производни в краищата</translation>
    </message>
    <message>
        <source>Length of segment</source>
        <translation>Дължина на сегмент</translation>
    </message>
    <message>
        <source>Coefficients of segment</source>
        <translation>Коефициенти на сегмент</translation>
    </message>
    <message>
        <source>Continuity at knot</source>
        <translation>Непрекъснатост във възел</translation>
    </message>
    <message>
        <source>Extrema of the curvature</source>
        <translation>Екстремуми на кривината</translation>
    </message>
    <message>
        <source>Bending energy</source>
        <translation>Енергия на огъване</translation>
    </message>
    <message>
        <source>Polygon of the given points</source>
        <translation>Полигон на опорните точки</translation>
    </message>
    <message>
        <source>Monotone runs</source>
        <translation>Монотонни участъци</translation>
    </message>
    <message>
        <source>Joins</source>
        <translation>Съединения</translation>
    </message>
    <message>
        <source>Middle points of pairs</source>
        <translation>Междинни точки на двойките</translation>
    </message>
    <message>
        <source>Numbers of runs</source>
        <translation>Номера на участъците</translation>
    </message>
    <message>
        <source>Points of run</source>
        <translation>Точки на участък</translation>
    </message>
    <message>
        <source>Degree of run</source>
        <translation>Степен на участък</translation>
    </message>
    <message>
        <source>Coefficients of run</source>
        <translation>Коефициенти на участък</translation>
    </message>
    <message>
        <source>Residual (root mean square) of run</source>
        <translation>Остатък (средноквадратичен) на участък</translation>
    </message>
    <message>
        <source>Largest residual of run</source>
        <translation>Най-голям остатък на участък</translation>
    </message>
    <message>
        <source>Largest kink</source>
        <translation>Най-голямо пречупване</translation>
    </message>
    <message>
        <source>Slope variation</source>
        <translation>Вариация на наклона</translation>
    </message>
    <message>
        <source>This curve needs more points</source>
        <translation>Тази крива се нуждае от още точки</translation>
    </message>
    <message>
        <source>open end</source>
        <translation>свободен край</translation>
    </message>
    <message>
        <source>Crossings</source>
        <translation>Пресичания</translation>
    </message>
    <message>
        <source>Crossings of the sheet</source>
        <translation>Пресичания в листа</translation>
    </message>
    <message>
        <source>Crossing</source>
        <translation>Пресичане</translation>
    </message>
    <message>
        <source>Overlaps of the sheet</source>
        <translation>Припокривания в листа</translation>
    </message>
    <message>
        <source>Bernstein polynomials</source>
        <translation>Полиноми на Бернщайн</translation>
    </message>
    <message>
        <source>Control point</source>
        <translation>Контролна точка</translation>
    </message>
    <message>
        <source>Weight</source>
        <translation>Тегло</translation>
    </message>
    <message>
        <source>Weights at t</source>
        <translation>Тегла при t</translation>
    </message>
    <message>
        <source>Level</source>
        <translation>Ниво</translation>
    </message>
    <message>
        <source>Left and right polygon</source>
        <translation>Ляв и десен полигон</translation>
    </message>
    <message>
        <source>Points of the last elevation</source>
        <translation>Точки от последното повишаване</translation>
    </message>
    <message>
        <source>Hodograph</source>
        <translation>Ходограф</translation>
    </message>
    <message>
        <source>Segment</source>
        <translation>Сегмент</translation>
    </message>
    <message>
        <source>Rule</source>
        <translation>Правило</translation>
    </message>
    <message>
        <source>All rules</source>
        <translation>Всички правила</translation>
    </message>
    <message>
        <source>Catmull–Rom</source>
        <translation>Катмул–Ром</translation>
    </message>
    <message>
        <source>Largest curvature</source>
        <translation>Най-голяма кривина</translation>
    </message>
    <message>
        <source>Run</source>
        <translation>Участък</translation>
    </message>
    <message>
        <source>After run</source>
        <translation>След участък</translation>
    </message>
    <message>
        <source>Values of the runs, y(x)</source>
        <translation>Стойности на участъците, y(x)</translation>
    </message>
    <message>
        <source>Slopes of the runs, y′(x)</source>
        <translation>Наклони на участъците, y′(x)</translation>
    </message>
    <message>
        <source>Method</source>
        <translation>Метод</translation>
    </message>
    <message>
        <source>Comparison of methods</source>
        <translation>Сравнение на методите</translation>
    </message>
    <message>
        <source>Interpolation</source>
        <translation>Интерполация</translation>
    </message>
    <message>
        <source>Approximation</source>
        <translation>Апроксимация</translation>
    </message>
    <message>
        <source>Pairs</source>
        <translation>Двойки</translation>
    </message>
    <message>
        <source>All polygons so far</source>
        <translation>Всички полигони досега</translation>
    </message>
    <message>
        <source>Convex hull</source>
        <translation>Изпъкнала обвивка</translation>
    </message>
    <message>
        <source>End tangents</source>
        <translation>Допирателни в краищата</translation>
    </message>
    <message>
        <source>De Casteljau schemes at further t</source>
        <translation>Схеми на дьо Кастелжо при други t</translation>
    </message>
    <message>
        <source>Curvature comb</source>
        <translation>Гребен на кривината</translation>
    </message>
    <message>
        <source>Inflections</source>
        <translation>Инфлексни точки</translation>
    </message>
    <message>
        <source>Continuity at the knots</source>
        <translation>Непрекъснатост във възлите</translation>
    </message>
    <message>
        <source>Polygons of runs</source>
        <translation>Полигони на участъците</translation>
    </message>
    <message>
        <source>Polynomials of runs</source>
        <translation>Полиноми на участъците</translation>
    </message>
    <message>
        <source>mirror</source>
        <translation>огледално</translation>
    </message>
    <message>
        <source>natural</source>
        <translation>естествен</translation>
    </message>
    <message>
        <source>clamped</source>
        <translation>със зададени краища</translation>
    </message>
    <message>
        <source>De Casteljau polyline</source>
        <translation>Начупена линия на дьо Кастелжо</translation>
    </message>
    <message>
        <source>Grid</source>
        <translation>Мрежа</translation>
    </message>
    <message>
        <source>Numbers of the axes</source>
        <translation>Числа по осите</translation>
    </message>
    <message>
        <source>Axes</source>
        <translation>Оси</translation>
    </message>
    <message>
        <source>Lines</source>
        <translation>Линии</translation>
    </message>
    <message>
        <source>Place on view</source>
        <translation>Разглеждано място</translation>
    </message>
    <message>
        <source>Legend</source>
        <translation>Легенда</translation>
    </message>
    <message>
        <source>Residual (root mean square)</source>
        <translation>Остатък (средноквадратичен)</translation>
    </message>
    <message>
        <source>Passes through crossings and overlaps</source>
        <translation>Преминавания през пресичания и припокривания</translation>
    </message>
    <message>
        <source>too many to count</source>
        <translation>твърде много за броене</translation>
    </message>
</context>
<context>
    <name>Clip</name>
    <message>
        <source>The clipboard: %1</source>
        <translation>Буферът за обмен: %1</translation>
    </message>
    <message>
        <source>The clipboard: its curve cannot be read: %1</source>
        <translation>Буферът за обмен: кривата му не може да се прочете: %1</translation>
    </message>
</context>
<context>
    <name>CommandLine</name>
    <message>
        <source>unknown option %1</source>
        <translation>непозната опция %1</translation>
    </message>
    <message>
        <source>a value is missing behind %1</source>
        <translation>липсва стойност след %1</translation>
    </message>
    <message>
        <source>unknown language %1</source>
        <translation>непознат език %1</translation>
    </message>
    <message>
        <source>there is no sheet %1</source>
        <translation>няма лист %1</translation>
    </message>
    <message>
        <source>the option --%1 does not belong here</source>
        <translation>опцията --%1 не е за тук</translation>
    </message>
    <message>
        <source>export needs the file to write: -o OUT.svg</source>
        <translation>export изисква файл за запис: -o OUT.svg</translation>
    </message>
    <message>
        <source>report needs one file</source>
        <translation>report изисква един файл</translation>
    </message>
    <message>
        <source>there is no format %1</source>
        <translation>няма формат %1</translation>
    </message>
    <message>
        <source>%1: there is no curve to draw</source>
        <translation>%1: няма крива за чертане</translation>
    </message>
    <message>
        <source>the output could not be written</source>
        <translation>изходът не можа да бъде записан</translation>
    </message>
    <message>
        <source>the editor needs a display; export and report do without one</source>
        <translation>редакторът изисква екран; export и report минават и без него</translation>
    </message>
    <message>
        <source>%1; kriva --help tells more</source>
        <translation>%1; повече казва kriva --help</translation>
    </message>
    <message>
        <source>export needs a file</source>
        <translation>export изисква файл</translation>
    </message>
    <message>
        <source>%1: with several files it needs {name} for the name of each</source>
        <translation>%1: при няколко файла е нужно {name} за името на всеки</translation>
    </message>
    <message>
        <source>%1: there is no curve %2; the sheet has %3, counted from 0</source>
        <translation>%1: няма крива %2; листът има %3, броени от 0</translation>
    </message>
    <message>
        <source>there is no layer %1; the sheet has %2</source>
        <translation>няма слой %1; листът има %2</translation>
    </message>
    <message>
        <source>%1: figures are written as .svg, .pdf, .png, .tex or .csv</source>
        <translation>%1: фигурите се записват като .svg, .pdf, .png, .tex или .csv</translation>
    </message>
    <message>
        <source>--width must be more than both margins, which are %1 mm</source>
        <translation>--width трябва да е повече от двете полета, които са %1 mm</translation>
    </message>
    <message>
        <source>there is no theme %1</source>
        <translation>няма тема %1</translation>
    </message>
    <message>
        <source>--%1 is a length such as 120mm, at most %2 mm</source>
        <translation>--%1 е дължина като 120mm, най-много %2 mm</translation>
    </message>
    <message>
        <source>--%1 is a whole number from %2 to %3</source>
        <translation>--%1 е цяло число от %2 до %3</translation>
    </message>
    <message>
        <source>import needs a file</source>
        <translation>import изисква файл</translation>
    </message>
    <message>
        <source>import needs the document to write: -o OUT.kriva</source>
        <translation>import изисква документ за запис: -o OUT.kriva</translation>
    </message>
    <message>
        <source>import needs the sheet that the curves go to: --sheet NAME</source>
        <translation>import изисква листа, в който отиват кривите: --sheet NAME</translation>
    </message>
    <message>
        <source>there is no scale %1</source>
        <translation>няма мащаб %1</translation>
    </message>
    <message>
        <source>%1 is no offset: two numbers with a comma between them</source>
        <translation>%1 не е отместване: две числа със запетая между тях</translation>
    </message>
    <message>
        <source>--frames are stages such as 0,5,10 or 0..10, or values such as t=0.25,0.5</source>
        <translation>--frames са етапи като 0,5,10 или 0..10 или стойности като t=0.25,0.5</translation>
    </message>
    <message>
        <source>--animate needs --frames and an SVG file</source>
        <translation>--animate изисква --frames и файл SVG</translation>
    </message>
    <message>
        <source>--seconds is a number from %1 to %2</source>
        <translation>--seconds е число от %1 до %2</translation>
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
    отваря редактора
kriva export FILE... -o OUT.{svg,pdf,png,tex,csv} [--sheet NAME] [--curve N] [--layers A,B]
    чертае лист: посочения, иначе показвания при запазването на документа.
    {name} и {sheet} в OUT са тези на всеки файл; - е стандартният вход и изход
    --format svg|pdf|png|tex|csv     когато краят на OUT не го казва
    --width 120mm --margin 6mm       на страницата; mm, cm, in или pt
    --scale 10                       милиметри за единица вместо ширина
    --no-labels --theme light|dark
    --no-document --decimals N --inkscape-layers --outlines    за SVG; контури вместо букви
    --dpi 300 --transparent          за PNG
    --fragment                       за TeX: за вмъкване в друг документ
    --frames 0,5,10 | 0..10 | t=0.25,0.5   етапи на анимацията един до друг или с {frame} в OUT
                                     файл за всеки; --animate --seconds 0.5: един след друг в SVG
kriva import FILE... -o OUT.kriva --sheet NAME [--scale N] [--offset X,Y]
    прави документ от пътищата на файлове SVG, от данни на пътища или от таблици с точки
kriva report FILE [--format json|text] [--sheet NAME]
    отпечатва числата на документ

    --language CODE   en, bg, sl или uk; иначе езикът на системата
    --sheet NAME      %1
    --help            този текст
    --version         версията

Кодове на изход: 0 готово, 1 неуспех, 2 грешна употреба, 3 отказан вход, 4 изходът не е записан.
</translation>
    </message>
    <message>
        <source>--scale is how many millimetres a unit has</source>
        <translation>--scale е колко милиметра има една единица</translation>
    </message>
    <message>
        <source>--width and --scale do not go together</source>
        <translation>--width и --scale не вървят заедно</translation>
    </message>
    <message>
        <source>%1: its lines were edited in another program; the document inside is taken as it was</source>
        <translation>%1: линиите са променени в друга програма; взема се документът вътре, какъвто е бил</translation>
    </message>
    <message>
        <source>%1: at work for %2 s; Ctrl+C ends it</source>
        <translation>%1: изчислява се от %2 s; Ctrl+C прекратява</translation>
    </message>
</context>
<context>
    <name>CurveName</name>
    <message>
        <source>Curve %1</source>
        <translation>Крива %1</translation>
    </message>
</context>
<context>
    <name>DocumentQuestions</name>
    <message>
        <source>An edited figure</source>
        <translation>Променена фигура</translation>
    </message>
    <message>
        <source>The lines of “%1” were edited in another program: they are not those of the document inside any more.</source>
        <translation>Линиите на „%1“ са променени в друга програма: те вече не са тези на документа вътре.</translation>
    </message>
    <message>
        <source>Open the document as it was, or as it is drawn now?</source>
        <translation>Да се отвори ли документът, какъвто е бил, или какъвто е начертан сега?</translation>
    </message>
    <message>
        <source>D&amp;rawing</source>
        <translation>&amp;Чертеж</translation>
    </message>
    <message>
        <source>&amp;Document</source>
        <translation>&amp;Документ</translation>
    </message>
    <message>
        <source>Unsaved changes</source>
        <translation>Незапазени промени</translation>
    </message>
    <message>
        <source>Save the changes to “%1”?</source>
        <translation>Да се запазят ли промените в „%1“?</translation>
    </message>
    <message>
        <source>Without saving they are lost.</source>
        <translation>Без запазване те се губят.</translation>
    </message>
    <message>
        <source>The file is gone</source>
        <translation>Файлът липсва</translation>
    </message>
    <message>
        <source>Save “%1” again?</source>
        <translation>Да се запази ли „%1“ отново?</translation>
    </message>
    <message>
        <source>Its file was deleted or moved elsewhere.</source>
        <translation>Файлът е изтрит или преместен другаде.</translation>
    </message>
    <message>
        <source>Open elsewhere</source>
        <translation>Отворен другаде</translation>
    </message>
    <message>
        <source>Another Kriva has “%1” open.</source>
        <translation>„%1“ е отворен в друга програма Kriva.</translation>
    </message>
    <message>
        <source>A copy is a document of its own. Opened anyway, the one that saves last overwrites the other.</source>
        <translation>Копието е отделен документ. Ако се отвори все пак, който запази последен, презаписва другия.</translation>
    </message>
    <message>
        <source>Open a &amp;copy</source>
        <translation>Отваряне на &amp;копие</translation>
    </message>
    <message>
        <source>Open &amp;anyway</source>
        <translation>&amp;Отваряне все пак</translation>
    </message>
    <message>
        <source>“%1” is open in another window or in another Kriva.</source>
        <translation>„%1“ е отворен в друг прозорец или в друга програма Kriva.</translation>
    </message>
    <message>
        <source>Overwritten, it is no longer what is shown there.</source>
        <translation>Ако се презапише, вече няма да е това, което се вижда там.</translation>
    </message>
    <message>
        <source>Save &amp;as…</source>
        <translation>Запазване &amp;като…</translation>
    </message>
    <message>
        <source>&amp;Overwrite</source>
        <translation>&amp;Презаписване</translation>
    </message>
    <message>
        <source>Changed elsewhere</source>
        <translation>Променен другаде</translation>
    </message>
    <message>
        <source>Another program changed “%1” since it was opened or saved here.</source>
        <translation>Друга програма е променила „%1“, след като е отворен или запазен тук.</translation>
    </message>
    <message>
        <source>Overwritten, the changes made there are lost; reloaded, those made here.</source>
        <translation>При презаписване се губят промените, направени там; при презареждане – направените тук.</translation>
    </message>
    <message>
        <source>&amp;Reload</source>
        <translation>П&amp;резареждане</translation>
    </message>
    <message>
        <source>Reload “%1” as it is in its file?</source>
        <translation>Да се презареди ли „%1“, какъвто е във файла?</translation>
    </message>
    <message>
        <source>The changes made here are lost.</source>
        <translation>Промените, направени тук, се губят.</translation>
    </message>
    <message>
        <source>The file was not opened</source>
        <translation>Файлът не беше отворен</translation>
    </message>
    <message>
        <source>The document was not saved</source>
        <translation>Документът не беше запазен</translation>
    </message>
    <message>
        <source>It is still here, as you see it.</source>
        <translation>Той е все още тук, какъвто го виждате.</translation>
    </message>
    <message>
        <source>What is shown here is in no file any more: without saving it is lost.</source>
        <translation>Показаното тук вече не е в никой файл: без запазване то се губи.</translation>
    </message>
</context>
<context>
    <name>Errors</name>
    <message>
        <source>line %1, column %2</source>
        <translation>ред %1, колона %2</translation>
    </message>
    <message>
        <source>this is no JSON</source>
        <translation>това не е JSON</translation>
    </message>
    <message>
        <source>nested more than %1 deep</source>
        <translation>вложено на повече от %1 нива</translation>
    </message>
    <message>
        <source>a number of more than %1 characters</source>
        <translation>число с повече от %1 знака</translation>
    </message>
    <message>
        <source>this is no document of Kriva</source>
        <translation>това не е документ на Kriva</translation>
    </message>
    <message>
        <source>version %1 needs a newer Kriva</source>
        <translation>версия %1 изисква по-нова Kriva</translation>
    </message>
    <message>
        <source>unknown key</source>
        <translation>непознат ключ</translation>
    </message>
    <message>
        <source>the key stands here twice</source>
        <translation>ключът стои тук два пъти</translation>
    </message>
    <message>
        <source>the key “%1” is missing</source>
        <translation>липсва ключът „%1“</translation>
    </message>
    <message>
        <source>expected an object</source>
        <translation>очакваше се обект</translation>
    </message>
    <message>
        <source>expected a list</source>
        <translation>очакваше се списък</translation>
    </message>
    <message>
        <source>expected a text</source>
        <translation>очакваше се текст</translation>
    </message>
    <message>
        <source>expected true or false</source>
        <translation>очакваше се true или false</translation>
    </message>
    <message>
        <source>expected a number</source>
        <translation>очакваше се число</translation>
    </message>
    <message>
        <source>expected a whole number from %1 to %2</source>
        <translation>очакваше се цяло число от %1 до %2</translation>
    </message>
    <message>
        <source>expected a number from %1 to %2</source>
        <translation>очакваше се число от %1 до %2</translation>
    </message>
    <message>
        <source>expected a number between %1 and %2</source>
        <translation>очакваше се число между %1 и %2</translation>
    </message>
    <message>
        <source>expected two finite numbers</source>
        <translation>очакваха се две крайни числа</translation>
    </message>
    <message>
        <source>expected one of: %1</source>
        <translation>очакваше се едно от: %1</translation>
    </message>
    <message>
        <source>expected a colour like #0072b2</source>
        <translation>очакваше се цвят като #0072b2</translation>
    </message>
    <message numerus="yes">
        <source>expected %n element(s)</source>
        <translation>
            <numerusform>очакваше се %n елемент</numerusform>
            <numerusform>очакваха се %n елемента</numerusform>
        </translation>
    </message>
    <message>
        <source>more than %1 is too many</source>
        <translation>повече от %1 е твърде много</translation>
    </message>
    <message>
        <source>no such index</source>
        <translation>няма такъв индекс</translation>
    </message>
    <message>
        <source>the file is larger than %1 bytes</source>
        <translation>файлът е по-голям от %1 байта</translation>
    </message>
    <message>
        <source>this figure has no document of Kriva inside</source>
        <translation>в тази фигура няма документ на Kriva</translation>
    </message>
    <message>
        <source>this is no XML</source>
        <translation>това не е XML</translation>
    </message>
    <message>
        <source>the document type has declarations of its own</source>
        <translation>типът на документа има собствени декларации</translation>
    </message>
    <message>
        <source>more than %1 elements are too many</source>
        <translation>повече от %1 елемента са твърде много</translation>
    </message>
    <message>
        <source>more than %1 attributes are too many</source>
        <translation>повече от %1 атрибута са твърде много</translation>
    </message>
    <message>
        <source>%1: there is no such file</source>
        <translation>%1: няма такъв файл</translation>
    </message>
    <message>
        <source>%1: this is no regular file</source>
        <translation>%1: това не е обикновен файл</translation>
    </message>
    <message>
        <source>%1: the file is larger than %2 bytes</source>
        <translation>%1: файлът е по-голям от %2 байта</translation>
    </message>
    <message>
        <source>%1: reading is not permitted</source>
        <translation>%1: четенето не е позволено</translation>
    </message>
    <message>
        <source>%1: the file cannot be read (%2)</source>
        <translation>%1: файлът не може да се прочете (%2)</translation>
    </message>
    <message>
        <source>%1: there is no such folder</source>
        <translation>%1: няма такава папка</translation>
    </message>
    <message>
        <source>%1: writing is not permitted</source>
        <translation>%1: писането не е позволено</translation>
    </message>
    <message>
        <source>%1: there is no space left</source>
        <translation>%1: няма повече място</translation>
    </message>
    <message>
        <source>%1: the file cannot be written (%2)</source>
        <translation>%1: файлът не може да се запише (%2)</translation>
    </message>
    <message>
        <source>this is no path data</source>
        <translation>това не са данни на път</translation>
    </message>
    <message>
        <source>the attribute “%1” cannot be read</source>
        <translation>атрибутът „%1“ не може да се прочете</translation>
    </message>
    <message>
        <source>there is no path to import</source>
        <translation>няма път за внасяне</translation>
    </message>
    <message>
        <source>the interpolated runs have more than %1 pairs of points</source>
        <translation>интерполираните участъци имат повече от %1 двойки точки</translation>
    </message>
    <message>
        <source>%1: written, but the owner or the permissions of the file could not be kept</source>
        <translation>%1: записан, но собственикът или правата на файла не можаха да се запазят</translation>
    </message>
    <message>
        <source>a sheet takes at most %1 curves, and these are %2</source>
        <translation>листът побира най-много %1 криви, а тези са %2</translation>
    </message>
    <message>
        <source>a sheet takes at most %1 points</source>
        <translation>листът побира най-много %1 точки</translation>
    </message>
    <message>
        <source>a sheet takes at most %1 points of elevated curves and of pieces</source>
        <translation>листът побира най-много %1 точки на криви с повишена степен и на части</translation>
    </message>
    <message>
        <source>this curve takes at most %1 points, and would have %2</source>
        <translation>тази крива побира най-много %1 точки, а би имала %2</translation>
    </message>
    <message>
        <source>interpolation takes at most %1 points in a monotone run, and one has %2</source>
        <translation>интерполацията допуска най-много %1 точки в монотонен участък, а един има %2</translation>
    </message>
    <message>
        <source>a report takes at most %1 segments of a sheet, and these are %2</source>
        <translation>отчетът побира най-много %1 сегмента от лист, а тези са %2</translation>
    </message>
    <message>
        <source>more than %1 passes through crossings and overlaps are too many</source>
        <translation>повече от %1 преминавания през пресичания и припокривания са твърде много</translation>
    </message>
    <message>
        <source>the curves have too many intersections to work out</source>
        <translation>кривите имат твърде много пресичания, за да бъдат пресметнати</translation>
    </message>
    <message>
        <source>coordinates go from %1 to %2</source>
        <translation>координатите са от %1 до %2</translation>
    </message>
    <message>
        <source>more than %1 uses of elements are too many</source>
        <translation>повече от %1 използвания на елементи са твърде много</translation>
    </message>
    <message>
        <source>uses of elements are nested more than %1 deep</source>
        <translation>използванията на елементи са вложени на повече от %1 нива</translation>
    </message>
    <message>
        <source>there is something behind the end of the outermost element</source>
        <translation>има нещо след края на най-външния елемент</translation>
    </message>
    <message>
        <source>the attribute “%1” stands here twice</source>
        <translation>атрибутът „%1“ стои тук два пъти</translation>
    </message>
    <message>
        <source>the entity “%1” is unknown</source>
        <translation>същността „%1“ е непозната</translation>
    </message>
    <message>
        <source>this is no UTF-8, which the file says that it is</source>
        <translation>това не е UTF-8, какъвто файлът твърди, че е</translation>
    </message>
    <message>
        <source>the attribute “%1” leads beyond the coordinates from %2 to %3</source>
        <translation>атрибутът „%1“ извежда извън координатите от %2 до %3</translation>
    </message>
    <message>
        <source>curve %1</source>
        <translation>крива %1</translation>
    </message>
    <message>
        <source>curve %1, “%2”</source>
        <translation>крива %1, „%2“</translation>
    </message>
    <message>
        <source>%1, the document inside</source>
        <translation>%1, документът вътре</translation>
    </message>
    <message>
        <source>a report takes at most %1 points of de Casteljau schemes of a sheet, and these are %2</source>
        <translation>отчетът побира най-много %1 точки на схеми на дьо Кастелжо от лист, а тези са %2</translation>
    </message>
    <message>
        <source>a report or a figure takes at most %1 pieces of the curves of a sheet, and these are %2</source>
        <translation>отчетът или фигурата побира най-много %1 части на кривите от един раздел, а те са %2</translation>
    </message>
    <message>
        <source>the encoding “%1” cannot be read</source>
        <translation>кодирането „%1“ не може да се прочете</translation>
    </message>
    <message>
        <source>“%1” is no character of XML</source>
        <translation>„%1“ не е знак на XML</translation>
    </message>
    <message>
        <source>%1: there is no file of this name, and one whose name is no UTF-8 cannot be opened</source>
        <translation>%1: няма файл с това име, а файл, чието име не е в UTF-8, не може да се отвори</translation>
    </message>
</context>
<context>
    <name>Examples</name>
    <message>
        <source>The polygon of degree 100 lies all but on the curve. Lower the degree with Page Down and watch the gap grow like 1/N.</source>
        <translation>Полигонът от степен 100 почти съвпада с кривата. Понижавайте степента с Page Down и вижте как разстоянието расте като 1/N.</translation>
    </message>
    <message>
        <source>Three rows of midpoints lead to the point (7/2, 3/2) of the curve. Move t: the last segment of the scheme stays tangent to the curve.</source>
        <translation>Три реда от среди на отсечки водят до точката (7/2, 3/2) от кривата. Променяйте t: последната отсечка на схемата остава допирателна към кривата.</translation>
    </message>
    <message>
        <source>Each row of the scheme has a parameter of its own, and so the point lies off the curve. Make the three arguments equal: it falls on it.</source>
        <translation>Всеки ред на схемата има собствен параметър, затова точката не лежи върху кривата. Направете трите аргумента равни: тя пада върху нея.</translation>
    </message>
    <message>
        <source>One polygon, whose inner points count once, twice and three times: the more often a point counts, the closer it draws the arc to itself.</source>
        <translation>Един полигон, чиито вътрешни точки се броят веднъж, два пъти и три пъти: колкото по-голяма е кратността, толкова повече точката притегля дъгата.</translation>
    </message>
    <message>
        <source>A closed chain of six cubics that crosses itself three times. Results names the segments and parameters of every crossing.</source>
        <translation>Затворена верига от шест кубични криви, която се пресича сама три пъти. В Резултати са сегментите и параметрите на всяко пресичане.</translation>
    </message>
    <message>
        <source>The two arrows are the derivatives at the ends. Drag one: the whole chain follows, and every knot stays C2.</source>
        <translation>Двете стрелки са производните в краищата. Влачете една от тях: цялата верига я следва, а всеки възел остава C2.</translation>
    </message>
    <message>
        <source>On equally spaced points the interpolation of degree 10 swings out near the ends; the approximation of degree 6 does so far less.</source>
        <translation>В равноотдалечени точки интерполацията от степен 10 силно се люлее край краищата; апроксимацията от степен 6 – много по-малко.</translation>
    </message>
    <message>
        <source>The points turn back in x four times: five monotone runs, each a polynomial y(x), joined by Bézier curves.</source>
        <translation>Точките четири пъти обръщат посоката си по x: пет монотонни участъка, всеки полином y(x), съединени с криви на Безие.</translation>
    </message>
    <message>
        <source>Two curves of pairs pass through every point. Drag a middle point: only its own pair changes.</source>
        <translation>Две криви от двойки минават през всички точки. Влачете междинна точка: променя се само нейната двойка.</translation>
    </message>
</context>
<context>
    <name>FigureFile</name>
    <message>
        <source>the picture would have more than %1 pixels a side</source>
        <translation>картината би имала повече от %1 пиксела на страна</translation>
    </message>
    <message>
        <source>TeX draws at most %1 mm a side; give the figure a width</source>
        <translation>TeX чертае най-много %1 mm на страна; задайте ширина на фигурата</translation>
    </message>
    <message>
        <source>the animation of the curve has no such frame</source>
        <translation>анимацията на кривата няма такъв кадър</translation>
    </message>
</context>
<context>
    <name>Gestures</name>
    <message>
        <source>Tabs</source>
        <translation>Раздели</translation>
    </message>
    <message>
        <source>Show a tab</source>
        <translation>Показва раздел</translation>
    </message>
    <message>
        <source>Alt+1 … Alt+%1</source>
        <translation>Alt+1 … Alt+%1</translation>
    </message>
    <message>
        <source>Next tab</source>
        <translation>Следващ раздел</translation>
    </message>
    <message>
        <source>Points, with the mouse</source>
        <translation>Точки, с мишката</translation>
    </message>
    <message>
        <source>Select a point, or make a curve the active one</source>
        <translation>Избира точка или прави крива активна</translation>
    </message>
    <message>
        <source>Click</source>
        <translation>Щракване</translation>
    </message>
    <message>
        <source>Select or deselect one more point</source>
        <translation>Избира още една точка или я изключва от избора</translation>
    </message>
    <message>
        <source>Shift+click</source>
        <translation>Shift+щракване</translation>
    </message>
    <message>
        <source>Select all points in a rectangle</source>
        <translation>Избира всички точки в правоъгълник</translation>
    </message>
    <message>
        <source>Drag on the empty canvas</source>
        <translation>Влачене по празно платно</translation>
    </message>
    <message>
        <source>Add the points in a rectangle to the selection</source>
        <translation>Добавя точките в правоъгълник към избора</translation>
    </message>
    <message>
        <source>Shift+drag</source>
        <translation>Shift+влачене</translation>
    </message>
    <message>
        <source>Take the points in a rectangle out of the selection</source>
        <translation>Изключва точките в правоъгълник от избора</translation>
    </message>
    <message>
        <source>Alt+drag or Ctrl+Shift+drag</source>
        <translation>Alt+влачене или Ctrl+Shift+влачене</translation>
    </message>
    <message>
        <source>Add a point at the end of the curve</source>
        <translation>Добавя точка в края на кривата</translation>
    </message>
    <message>
        <source>Alt+click, or double-click on the empty canvas</source>
        <translation>Alt+щракване или двойно щракване върху празно платно</translation>
    </message>
    <message>
        <source>Insert a point and keep the shape</source>
        <translation>Вмъква точка и запазва формата</translation>
    </message>
    <message>
        <source>Double-click or Ctrl+Alt+click on the curve</source>
        <translation>Двойно щракване или Ctrl+Alt+щракване върху кривата</translation>
    </message>
    <message>
        <source>Remove a point and refit its neighbours</source>
        <translation>Премахва точка и нагласява съседите ѝ</translation>
    </message>
    <message>
        <source>Alt+click on the point</source>
        <translation>Alt+щракване върху точката</translation>
    </message>
    <message>
        <source>Move a point or the selection</source>
        <translation>Премества точка или избраното</translation>
    </message>
    <message>
        <source>Drag the point</source>
        <translation>Влачене на точката</translation>
    </message>
    <message>
        <source>Move along an axis</source>
        <translation>Премества успоредно на ос</translation>
    </message>
    <message>
        <source>Ctrl+drag</source>
        <translation>Ctrl+влачене</translation>
    </message>
    <message>
        <source>Move without snapping</source>
        <translation>Премества без прилепване</translation>
    </message>
    <message>
        <source>Shift, pressed during the drag</source>
        <translation>Shift, натиснат по време на влачене</translation>
    </message>
    <message>
        <source>Mould the curve</source>
        <translation>Извива кривата</translation>
    </message>
    <message>
        <source>Drag the curve</source>
        <translation>Влачене на кривата</translation>
    </message>
    <message>
        <source>What can be done here</source>
        <translation>Какво може да се направи тук</translation>
    </message>
    <message>
        <source>Right-click</source>
        <translation>Щракване с десния бутон</translation>
    </message>
    <message>
        <source>Add tool</source>
        <translation>Инструмент за добавяне</translation>
    </message>
    <message>
        <source>Add a point, or insert one on the curve</source>
        <translation>Добавя точка или я вмъква в кривата</translation>
    </message>
    <message>
        <source>Pull the handles of the new knot</source>
        <translation>Изтегля манипулаторите на новия възел</translation>
    </message>
    <message>
        <source>Press and drag</source>
        <translation>Натискане и влачене</translation>
    </message>
    <message>
        <source>Close the curve</source>
        <translation>Затваря кривата</translation>
    </message>
    <message>
        <source>Click on the first knot</source>
        <translation>Щракване върху първия възел</translation>
    </message>
    <message>
        <source>End</source>
        <translation>Край</translation>
    </message>
    <message>
        <source>Enter or Esc</source>
        <translation>Enter или Esc</translation>
    </message>
    <message>
        <source>Handles and end derivatives</source>
        <translation>Манипулатори и производни в краищата</translation>
    </message>
    <message>
        <source>Turn in steps of 15°</source>
        <translation>Върти на стъпки от 15°</translation>
    </message>
    <message>
        <source>Keep the angle</source>
        <translation>Запазва ъгъла</translation>
    </message>
    <message>
        <source>Ctrl+Alt+drag</source>
        <translation>Ctrl+Alt+влачене</translation>
    </message>
    <message>
        <source>Leave the other handle where it is</source>
        <translation>Оставя другия манипулатор на място</translation>
    </message>
    <message>
        <source>Alt, pressed during the drag</source>
        <translation>Alt, натиснат по време на влачене</translation>
    </message>
    <message>
        <source>Carry the knot along</source>
        <translation>Носи и възела</translation>
    </message>
    <message>
        <source>Space, held during the drag</source>
        <translation>Интервал, задържан по време на влачене</translation>
    </message>
    <message>
        <source>Retract the handle</source>
        <translation>Прибира манипулатора</translation>
    </message>
    <message>
        <source>Ctrl+click</source>
        <translation>Ctrl+щракване</translation>
    </message>
    <message>
        <source>Keys on the canvas</source>
        <translation>Клавиши върху платното</translation>
    </message>
    <message>
        <source>Edit tool</source>
        <translation>Инструмент за редактиране</translation>
    </message>
    <message>
        <source>Fit the selection</source>
        <translation>Избраното в изгледа</translation>
    </message>
    <message>
        <source>Grid</source>
        <translation>Мрежа</translation>
    </message>
    <message>
        <source>Next point</source>
        <translation>Следваща точка</translation>
    </message>
    <message>
        <source>Previous point</source>
        <translation>Предишна точка</translation>
    </message>
    <message>
        <source>Move the selection by a step of the grid</source>
        <translation>Премества избраното с една стъпка на мрежата</translation>
    </message>
    <message>
        <source>Arrow keys</source>
        <translation>Стрелки</translation>
    </message>
    <message>
        <source>Move the selection by ten steps</source>
        <translation>Премества избраното с десет стъпки</translation>
    </message>
    <message>
        <source>Shift+arrow keys</source>
        <translation>Shift+стрелки</translation>
    </message>
    <message>
        <source>Move the selection by a pixel</source>
        <translation>Премества избраното с един пиксел</translation>
    </message>
    <message>
        <source>Alt+arrow keys</source>
        <translation>Alt+стрелки</translation>
    </message>
    <message>
        <source>Remove the selection and refit its neighbours</source>
        <translation>Премахва избраното и нагласява съседните точки</translation>
    </message>
    <message>
        <source>Delete or Backspace</source>
        <translation>Delete или Backspace</translation>
    </message>
    <message>
        <source>Remove the selection without refitting</source>
        <translation>Премахва избраното без нагласяване</translation>
    </message>
    <message>
        <source>Take back the drag, end the tool, deselect, leave the canvas</source>
        <translation>Отменя влаченето, прекратява инструмента, изчиства избора, напуска платното</translation>
    </message>
    <message>
        <source>View, with the mouse</source>
        <translation>Изглед, с мишката</translation>
    </message>
    <message>
        <source>Scroll</source>
        <translation>Превърта</translation>
    </message>
    <message>
        <source>Wheel</source>
        <translation>Колелце</translation>
    </message>
    <message>
        <source>Scroll sideways</source>
        <translation>Превърта настрани</translation>
    </message>
    <message>
        <source>Shift+wheel</source>
        <translation>Shift+колелце</translation>
    </message>
    <message>
        <source>Zoom at the pointer</source>
        <translation>Мащабира при показалеца</translation>
    </message>
    <message>
        <source>Ctrl+wheel</source>
        <translation>Ctrl+колелце</translation>
    </message>
    <message>
        <source>Move the sheet</source>
        <translation>Мести листа</translation>
    </message>
    <message>
        <source>Drag with the middle button or with Space</source>
        <translation>Влачене със средния бутон или с Интервал</translation>
    </message>
    <message>
        <source>Player</source>
        <translation>Анимация</translation>
    </message>
    <message>
        <source>Play or pause</source>
        <translation>Пускане или пауза</translation>
    </message>
    <message>
        <source>One step back or forth</source>
        <translation>Един етап назад или напред</translation>
    </message>
    <message>
        <source>Left, Right</source>
        <translation>Стрелка наляво, стрелка надясно</translation>
    </message>
</context>
<context>
    <name>Hint</name>
    <message>
        <source>Alt+click: remove the point</source>
        <translation>Alt+щракване: премахва точката</translation>
    </message>
    <message>
        <source>Drag: move the point, Ctrl: along an axis   Alt+click: remove it</source>
        <translation>Влачене: премества точката, Ctrl: по оста   Alt+щракване: премахва я</translation>
    </message>
    <message>
        <source>Drag: mould the curve   Double-click: insert a point</source>
        <translation>Влачене: извива кривата   Двойно щракване: вмъква точка</translation>
    </message>
    <message>
        <source>Alt+click: add a point</source>
        <translation>Alt+щракване: добавя точка</translation>
    </message>
    <message>
        <source>Double-click or Alt+click: add a point   Drag: select points   Ctrl+wheel: zoom</source>
        <translation>Двойно щракване или Alt+щракване: добавя точка   Влачене: избира точки   Ctrl+колелце: мащаб</translation>
    </message>
    <message>
        <source>No point can be inserted here</source>
        <translation>Тук не може да се вмъкне точка</translation>
    </message>
    <message>
        <source>This curve follows its points; drag them</source>
        <translation>Тази крива следва точките си; влачете тях</translation>
    </message>
    <message>
        <source>The shape changes by at most %1</source>
        <translation>Формата се променя с най-много %1</translation>
    </message>
    <message>
        <source>The degree falls to %1</source>
        <translation>Степента пада до %1</translation>
    </message>
    <message>
        <source>Click: close the curve   Drag: move the point   Esc: end</source>
        <translation>Щракване: затваря кривата   Влачене: премества точката   Esc: край</translation>
    </message>
    <message>
        <source>Click: add a point   Drag: move the point   Esc: end</source>
        <translation>Щракване: добавя точка   Влачене: премества точката   Esc: край</translation>
    </message>
    <message>
        <source>Ctrl+drag: move the point along an axis</source>
        <translation>Ctrl+влачене: премества точката по оста</translation>
    </message>
    <message>
        <source>Shift+click: select or deselect the point</source>
        <translation>Shift+щракване: избира точката или я изключва от избора</translation>
    </message>
    <message>
        <source>Ctrl+drag: steps of 15°   Ctrl+click: retract the handle</source>
        <translation>Ctrl+влачене: стъпки от 15°   Ctrl+щракване: прибира манипулатора</translation>
    </message>
    <message>
        <source>Drag: move the handle, Ctrl: in steps of 15°   Ctrl+click: retract it</source>
        <translation>Влачене: премества манипулатора, Ctrl: на стъпки от 15°   Ctrl+щракване: прибира го</translation>
    </message>
    <message>
        <source>Ctrl+drag: steps of 15°   Ctrl+click: back to the natural derivative</source>
        <translation>Ctrl+влачене: стъпки от 15°   Ctrl+щракване: обратно към естествената производна</translation>
    </message>
    <message>
        <source>Drag: change the derivative, Ctrl: in steps of 15°   Ctrl+click: back to the natural one</source>
        <translation>Влачене: променя производната, Ctrl: на стъпки от 15°   Ctrl+щракване: обратно към естествената</translation>
    </message>
    <message>
        <source>Drag: move the point, Ctrl: along an axis</source>
        <translation>Влачене: премества точката, Ctrl: по оста</translation>
    </message>
    <message>
        <source>Ctrl+Alt+click: insert a point</source>
        <translation>Ctrl+Alt+щракване: вмъква точка</translation>
    </message>
    <message>
        <source>Click: insert a point   Drag: pull its handles   Esc: end</source>
        <translation>Щракване: вмъква точка   Влачене: изтегля манипулаторите ѝ   Esc: край</translation>
    </message>
    <message>
        <source>Click: insert a point   Drag: place it   Esc: end</source>
        <translation>Щракване: вмъква точка   Влачене: намества я   Esc: край</translation>
    </message>
    <message>
        <source>Alt+click: add a point   Alt+drag: deselect points</source>
        <translation>Alt+щракване: добавя точка   Alt+влачене: изключва точки от избора</translation>
    </message>
    <message>
        <source>Shift+drag: select more points</source>
        <translation>Shift+влачене: избира още точки</translation>
    </message>
    <message>
        <source>Ctrl+Shift+drag: deselect points</source>
        <translation>Ctrl+Shift+влачене: изключва точки от избора</translation>
    </message>
    <message>
        <source>Click: add a point   Drag: pull its handles   Esc: end</source>
        <translation>Щракване: добавя точка   Влачене: изтегля манипулаторите ѝ   Esc: край</translation>
    </message>
    <message>
        <source>Click: add a point   Drag: place it   Esc: end</source>
        <translation>Щракване: добавя точка   Влачене: намества я   Esc: край</translation>
    </message>
    <message>
        <source>Space: the knot goes along</source>
        <translation>Интервал: възелът върви заедно с манипулатора</translation>
    </message>
    <message>
        <source>Ctrl+Alt: the handle keeps its angle</source>
        <translation>Ctrl+Alt: манипулаторът запазва ъгъла си</translation>
    </message>
    <message>
        <source>Ctrl: steps of 15°</source>
        <translation>Ctrl: стъпки от 15°</translation>
    </message>
    <message>
        <source>Alt: the other handle stays</source>
        <translation>Alt: другият манипулатор остава на място</translation>
    </message>
    <message>
        <source>Ctrl: steps of 15°   Ctrl+Alt: keep the angle   Alt: leave the other handle   Space: carry the knot</source>
        <translation>Ctrl: стъпки от 15°   Ctrl+Alt: запазва ъгъла   Alt: оставя другия манипулатор   Интервал: носи и възела</translation>
    </message>
    <message>
        <source>Click: how this point is worked out, in Tables</source>
        <translation>Щракване: как се изчислява тази точка, в „Таблици“</translation>
    </message>
    <message>
        <source>The shape stays as it is</source>
        <translation>Формата остава същата</translation>
    </message>
</context>
<context>
    <name>Menus</name>
    <message>
        <source>A cubic raised 97 times</source>
        <translation>Кубична крива, повишена 97 пъти</translation>
    </message>
    <message>
        <source>De Casteljau at t = 1/2</source>
        <translation>Дьо Кастелжо при t = 1/2</translation>
    </message>
    <message>
        <source>The blossom b[t₁, t₂, t₃]</source>
        <translation>Полярната форма b[t₁, t₂, t₃]</translation>
    </message>
    <message>
        <source>An arc with double and triple points</source>
        <translation>Дъга с двойни и тройни точки</translation>
    </message>
    <message>
        <source>A chain with three self-intersections</source>
        <translation>Верига с три самопресичания</translation>
    </message>
    <message>
        <source>A clamped cubic spline</source>
        <translation>Кубичен сплайн със зададени краища</translation>
    </message>
    <message>
        <source>Runge&apos;s function</source>
        <translation>Функцията на Рунге</translation>
    </message>
    <message>
        <source>A curve with five monotone runs</source>
        <translation>Крива с пет монотонни участъка</translation>
    </message>
    <message>
        <source>The outline of a leaf</source>
        <translation>Контурът на листо</translation>
    </message>
    <message>
        <source>&amp;File</source>
        <translation>&amp;Файл</translation>
    </message>
    <message>
        <source>Open &amp;recent</source>
        <translation>&amp;Скорошни</translation>
    </message>
    <message>
        <source>&amp;Edit</source>
        <translation>&amp;Редактиране</translation>
    </message>
    <message>
        <source>&amp;Curve</source>
        <translation>&amp;Крива</translation>
    </message>
    <message>
        <source>&amp;View</source>
        <translation>&amp;Изглед</translation>
    </message>
    <message>
        <source>&amp;Panels</source>
        <translation>&amp;Панели</translation>
    </message>
    <message>
        <source>&amp;Settings</source>
        <translation>&amp;Настройки</translation>
    </message>
    <message>
        <source>&amp;Language</source>
        <translation>&amp;Език</translation>
    </message>
    <message>
        <source>&amp;Theme</source>
        <translation>&amp;Тема</translation>
    </message>
    <message>
        <source>&amp;System</source>
        <translation>&amp;Системна</translation>
    </message>
    <message>
        <source>&amp;Light</source>
        <translation>С&amp;ветла</translation>
    </message>
    <message>
        <source>&amp;Dark</source>
        <translation>&amp;Тъмна</translation>
    </message>
    <message>
        <source>&amp;Help</source>
        <translation>&amp;Помощ</translation>
    </message>
    <message>
        <source>Exa&amp;mples</source>
        <translation>&amp;Примери</translation>
    </message>
    <message>
        <source>Tool bar</source>
        <translation>Лента с инструменти</translation>
    </message>
    <message>
        <source>Use these &amp;points in</source>
        <translation>Използване на тези &amp;точки в раздел</translation>
    </message>
</context>
<context>
    <name>PointColumn</name>
    <message>
        <source>Join</source>
        <translation>Съединение</translation>
    </message>
    <message>
        <source>Multiplicity</source>
        <translation>Кратност</translation>
    </message>
    <message>
        <source>One of these is needed: %1.</source>
        <translation>Нужно е едно от следните: %1.</translation>
    </message>
</context>
<context>
    <name>PointsImport</name>
    <message>
        <source>Import points</source>
        <translation>Внасяне на точки</translation>
    </message>
    <message>
        <source>Paths and points (*.svg *.csv *.tsv *.txt);;All files (*)</source>
        <translation>Пътища и точки (*.svg *.csv *.tsv *.txt);;Всички файлове (*)</translation>
    </message>
    <message>
        <source>Nothing was imported</source>
        <translation>Нищо не беше внесено</translation>
    </message>
</context>
<context>
    <name>Properties</name>
    <message>
        <source>Method</source>
        <translation>Метод</translation>
    </message>
    <message>
        <source>Approximation</source>
        <translation>Апроксимация</translation>
    </message>
    <message>
        <source>Interpolation</source>
        <translation>Интерполация</translation>
    </message>
    <message>
        <source>Pairs</source>
        <translation>Двойки</translation>
    </message>
    <message>
        <source>Degree</source>
        <translation>Степен</translation>
    </message>
    <message>
        <source>Basis</source>
        <translation>Базис</translation>
    </message>
    <message>
        <source>Power basis</source>
        <translation>Степенен базис</translation>
    </message>
    <message>
        <source>Newton basis</source>
        <translation>Базис на Нютон</translation>
    </message>
    <message>
        <source>Lagrange basis</source>
        <translation>Базис на Лагранж</translation>
    </message>
    <message>
        <source>Chebyshev basis</source>
        <translation>Базис на Чебишов</translation>
    </message>
    <message>
        <source>Corrected pairs</source>
        <translation>Коригирани двойки</translation>
    </message>
    <message>
        <source>Animation</source>
        <translation>Анимация</translation>
    </message>
    <message>
        <source>Rule</source>
        <translation>Правило</translation>
    </message>
    <message>
        <source>Mirror</source>
        <translation>Огледално</translation>
    </message>
    <message>
        <source>Natural</source>
        <translation>Естествен</translation>
    </message>
    <message>
        <source>Clamped</source>
        <translation>Със зададени краища</translation>
    </message>
    <message>
        <source>Catmull–Rom</source>
        <translation>Катмул–Ром</translation>
    </message>
    <message>
        <source>Selected knots</source>
        <translation>Избрани възли</translation>
    </message>
    <message>
        <source>Join</source>
        <translation>Съединение</translation>
    </message>
    <message>
        <source>End derivatives</source>
        <translation>Производни в краищата</translation>
    </message>
    <message>
        <source>Start</source>
        <translation>Начало</translation>
    </message>
    <message>
        <source>End</source>
        <translation>Край</translation>
    </message>
    <message>
        <source>Automatic</source>
        <translation>Автоматичен</translation>
    </message>
    <message>
        <source>Symmetric</source>
        <translation>Симетричен</translation>
    </message>
    <message>
        <source>Smooth</source>
        <translation>Гладък</translation>
    </message>
    <message>
        <source>Corner</source>
        <translation>Ъглов</translation>
    </message>
    <message>
        <source>Parameter t</source>
        <translation>Параметър t</translation>
    </message>
    <message>
        <source>Levels</source>
        <translation>Нива</translation>
    </message>
    <message>
        <source>Multiplicity of the selected point</source>
        <translation>Кратност на избраната точка</translation>
    </message>
    <message>
        <source>Blossom</source>
        <translation>Полярна форма (blossom)</translation>
    </message>
    <message>
        <source>Arguments</source>
        <translation>Аргументи</translation>
    </message>
    <message>
        <source>Runs over</source>
        <translation>Тече по</translation>
    </message>
    <message>
        <source>The algorithm step by step</source>
        <translation>Алгоритъмът стъпка по стъпка</translation>
    </message>
    <message>
        <source>Curvature comb</source>
        <translation>Гребен на кривината</translation>
    </message>
    <message>
        <source>Scale of the comb</source>
        <translation>Мащаб на гребена</translation>
    </message>
    <message>
        <source>Further t</source>
        <translation>Други t</translation>
    </message>
    <message>
        <source>Make this the control polygon</source>
        <translation>Приемане за контролен полигон</translation>
    </message>
    <message>
        <source>Reduce the degree by one</source>
        <translation>Понижаване на степента с едно</translation>
    </message>
    <message>
        <source>Comparison with the built-in drawing</source>
        <translation>Сравнение с вграденото чертане</translation>
    </message>
    <message>
        <source>Points per segment</source>
        <translation>Точки на сегмент</translation>
    </message>
    <message>
        <source>Largest deviation</source>
        <translation>Най-голямо отклонение</translation>
    </message>
    <message>
        <source>Split here</source>
        <translation>Разделяне тук</translation>
    </message>
</context>
<context>
    <name>Sheet</name>
    <message>
        <source>Combined</source>
        <translation>Комбиниран</translation>
    </message>
    <message>
        <source>Elevation</source>
        <translation>Повишаване</translation>
    </message>
    <message>
        <source>Spline</source>
        <translation>Сплайн</translation>
    </message>
    <message>
        <source>Subdivision</source>
        <translation>Подразделяне</translation>
    </message>
</context>
<context>
    <name>SheetActions</name>
    <message>
        <source>Raise the degree</source>
        <translation>Повишаване на степента</translation>
    </message>
    <message>
        <source>Lower the degree</source>
        <translation>Понижаване на степента</translation>
    </message>
    <message>
        <source>Elevate once more</source>
        <translation>Още едно повишаване</translation>
    </message>
    <message>
        <source>Elevate once less</source>
        <translation>Едно повишаване по-малко</translation>
    </message>
    <message>
        <source>Closed</source>
        <translation>Затворена</translation>
    </message>
    <message>
        <source>Corner</source>
        <translation>Ъглов</translation>
    </message>
    <message>
        <source>Smooth</source>
        <translation>Гладък</translation>
    </message>
    <message>
        <source>Symmetric</source>
        <translation>Симетричен</translation>
    </message>
    <message>
        <source>Automatic</source>
        <translation>Автоматичен</translation>
    </message>
    <message>
        <source>Align handles</source>
        <translation>Изравняване на манипулаторите</translation>
    </message>
    <message>
        <source>Equalize handles</source>
        <translation>Уеднаквяване на манипулаторите</translation>
    </message>
    <message>
        <source>Pull out handles</source>
        <translation>Изтегляне на манипулаторите</translation>
    </message>
    <message>
        <source>Retract handles</source>
        <translation>Прибиране на манипулаторите</translation>
    </message>
    <message>
        <source>One level more</source>
        <translation>Едно ниво повече</translation>
    </message>
    <message>
        <source>One level fewer</source>
        <translation>Едно ниво по-малко</translation>
    </message>
    <message>
        <source>Make the elevated polygon the control polygon</source>
        <translation>Приемане на полигона с повишена степен за контролен</translation>
    </message>
    <message>
        <source>Split here, at t</source>
        <translation>Разделяне тук, при t</translation>
    </message>
</context>
<context>
    <name>SheetPanels</name>
    <message>
        <source>Curves</source>
        <translation>Криви</translation>
    </message>
    <message>
        <source>Points</source>
        <translation>Точки</translation>
    </message>
    <message>
        <source>Layers</source>
        <translation>Слоеве</translation>
    </message>
    <message>
        <source>Properties</source>
        <translation>Свойства</translation>
    </message>
    <message>
        <source>Results</source>
        <translation>Резултати</translation>
    </message>
    <message>
        <source>History</source>
        <translation>История</translation>
    </message>
    <message>
        <source>Plots</source>
        <translation>Графики</translation>
    </message>
    <message>
        <source>Tables</source>
        <translation>Таблици</translation>
    </message>
    <message>
        <source>Guide</source>
        <translation>Ръководство</translation>
    </message>
</context>
<context>
    <name>Step</name>
    <message>
        <source>Set the method</source>
        <translation>Задаване на метода</translation>
    </message>
    <message>
        <source>Set the degree</source>
        <translation>Задаване на степента</translation>
    </message>
    <message>
        <source>Set the basis</source>
        <translation>Задаване на базиса</translation>
    </message>
    <message>
        <source>Back to automatic</source>
        <translation>Обратно към автоматично</translation>
    </message>
    <message>
        <source>Raise the degree</source>
        <translation>Повишаване на степента</translation>
    </message>
    <message>
        <source>Keep the stage</source>
        <translation>Запазване на етапа</translation>
    </message>
    <message>
        <source>Add a point</source>
        <translation>Добавяне на точка</translation>
    </message>
    <message>
        <source>Insert a point</source>
        <translation>Вмъкване на точка</translation>
    </message>
    <message>
        <source>Remove point %1</source>
        <translation>Премахване на точка %1</translation>
    </message>
    <message>
        <source>Remove points</source>
        <translation>Премахване на точки</translation>
    </message>
    <message>
        <source>Nudge</source>
        <translation>Побутване</translation>
    </message>
    <message>
        <source>Reverse the curve</source>
        <translation>Обръщане на кривата</translation>
    </message>
    <message>
        <source>New curve</source>
        <translation>Нова крива</translation>
    </message>
    <message>
        <source>Duplicate the curve</source>
        <translation>Дублиране на кривата</translation>
    </message>
    <message>
        <source>Delete the curve</source>
        <translation>Изтриване на кривата</translation>
    </message>
    <message>
        <source>Rename the curve</source>
        <translation>Преименуване на кривата</translation>
    </message>
    <message>
        <source>Colour the curve</source>
        <translation>Оцветяване на кривата</translation>
    </message>
    <message>
        <source>Reorder the curves</source>
        <translation>Пренареждане на кривите</translation>
    </message>
    <message>
        <source>Clear the canvas</source>
        <translation>Изчистване на платното</translation>
    </message>
    <message>
        <source>Move points</source>
        <translation>Преместване на точки</translation>
    </message>
    <message>
        <source>Mould the curve</source>
        <translation>Извиване на кривата</translation>
    </message>
    <message>
        <source>Move point %1</source>
        <translation>Преместване на точка %1</translation>
    </message>
    <message>
        <source>Move a handle of knot %1</source>
        <translation>Преместване на манипулатор на възел %1</translation>
    </message>
    <message>
        <source>Move an inner point of segment %1</source>
        <translation>Преместване на вътрешна точка на сегмент %1</translation>
    </message>
    <message>
        <source>Move the middle point of pair %1</source>
        <translation>Преместване на междинната точка на двойка %1</translation>
    </message>
    <message>
        <source>Change the start derivative</source>
        <translation>Промяна на началната производна</translation>
    </message>
    <message>
        <source>Change the end derivative</source>
        <translation>Промяна на крайната производна</translation>
    </message>
    <message>
        <source>Set the rule</source>
        <translation>Задаване на правилото</translation>
    </message>
    <message>
        <source>Close the curve</source>
        <translation>Затваряне на кривата</translation>
    </message>
    <message>
        <source>Open the curve</source>
        <translation>Отваряне на кривата</translation>
    </message>
    <message>
        <source>Set the join</source>
        <translation>Задаване на съединението</translation>
    </message>
    <message>
        <source>Set the parameter t</source>
        <translation>Задаване на параметъра t</translation>
    </message>
    <message>
        <source>Set the levels</source>
        <translation>Задаване на нивата</translation>
    </message>
    <message>
        <source>Set the multiplicity</source>
        <translation>Задаване на кратността</translation>
    </message>
    <message>
        <source>Show the blossom</source>
        <translation>Показване на полярната форма</translation>
    </message>
    <message>
        <source>Hide the blossom</source>
        <translation>Скриване на полярната форма</translation>
    </message>
    <message>
        <source>Set the blossom</source>
        <translation>Задаване на полярната форма</translation>
    </message>
    <message>
        <source>Cut the curve</source>
        <translation>Изрязване на кривата</translation>
    </message>
    <message>
        <source>Cut points</source>
        <translation>Изрязване на точки</translation>
    </message>
    <message>
        <source>Paste points</source>
        <translation>Поставяне на точки</translation>
    </message>
    <message>
        <source>Paste the curve</source>
        <translation>Поставяне на крива</translation>
    </message>
    <message>
        <source>Duplicate points</source>
        <translation>Дублиране на точки</translation>
    </message>
    <message>
        <source>Set the width of the line</source>
        <translation>Задаване на дебелината на линията</translation>
    </message>
    <message>
        <source>Set the dashes of the line</source>
        <translation>Задаване на вида на линията</translation>
    </message>
    <message>
        <source>Set the marks of the points</source>
        <translation>Задаване на знаците на точките</translation>
    </message>
    <message>
        <source>Show the labels</source>
        <translation>Показване на означенията</translation>
    </message>
    <message>
        <source>Hide the labels</source>
        <translation>Скриване на означенията</translation>
    </message>
    <message>
        <source>Reset the style</source>
        <translation>Връщане на обичайния стил</translation>
    </message>
    <message>
        <source>Use the points of a tab</source>
        <translation>Използване на точките от друг раздел</translation>
    </message>
    <message>
        <source>Retract a handle of knot %1</source>
        <translation>Прибиране на манипулатор на възел %1</translation>
    </message>
    <message>
        <source>Retract the handles</source>
        <translation>Прибиране на манипулаторите</translation>
    </message>
    <message>
        <source>Align the handles</source>
        <translation>Изравняване на манипулаторите</translation>
    </message>
    <message>
        <source>Equalize the handles</source>
        <translation>Уеднаквяване на манипулаторите</translation>
    </message>
    <message>
        <source>Pull out the handles</source>
        <translation>Изтегляне на манипулаторите</translation>
    </message>
    <message>
        <source>Take the elevated polygon over</source>
        <translation>Приемане на полигона с повишена степен</translation>
    </message>
    <message>
        <source>Reduce the degree</source>
        <translation>Понижаване на степента</translation>
    </message>
    <message>
        <source>Split the curve</source>
        <translation>Разделяне на кривата</translation>
    </message>
    <message>
        <source>Paste curves</source>
        <translation>Поставяне на криви</translation>
    </message>
    <message>
        <source>Import curves</source>
        <translation>Внасяне на криви</translation>
    </message>
</context>
<context>
    <name>StyleEditor</name>
    <message>
        <source>Solid</source>
        <translation>Плътна</translation>
    </message>
    <message>
        <source>Dashed</source>
        <translation>С тирета</translation>
    </message>
    <message>
        <source>Dotted</source>
        <translation>С точки</translation>
    </message>
    <message>
        <source>Dash-dot</source>
        <translation>Тире и точка</translation>
    </message>
    <message>
        <source>As usual</source>
        <translation>Както обикновено</translation>
    </message>
    <message>
        <source>None</source>
        <translation>Няма</translation>
    </message>
    <message>
        <source>Circles</source>
        <translation>Кръгчета</translation>
    </message>
    <message>
        <source>Squares</source>
        <translation>Квадратчета</translation>
    </message>
    <message>
        <source>Diamonds</source>
        <translation>Ромбчета</translation>
    </message>
</context>
<context>
    <name>TableErrors</name>
    <message>
        <source>there are no points</source>
        <translation>няма точки</translation>
    </message>
    <message>
        <source>more than %1 points are too many</source>
        <translation>повече от %1 точки са твърде много</translation>
    </message>
    <message>
        <source>expected two numbers</source>
        <translation>очакват се две числа</translation>
    </message>
    <message>
        <source>“%1” is no number</source>
        <translation>„%1“ не е число</translation>
    </message>
    <message>
        <source>“%1” is not from %2 to %3</source>
        <translation>„%1“ не е от %2 до %3</translation>
    </message>
    <message>
        <source>“%1” has another decimal sign than the numbers before it</source>
        <translation>„%1“ има друг десетичен знак от числата преди него</translation>
    </message>
    <message>
        <source>line %1, column %2</source>
        <translation>ред %1, колона %2</translation>
    </message>
    <message>
        <source>a curve takes at most %1 points</source>
        <translation>кривата побира най-много %1 точки</translation>
    </message>
</context>
<context>
    <name>Values</name>
    <message>
        <source>more than %L1</source>
        <translation>повече от %L1</translation>
    </message>
</context>
<context>
    <name>kriva::ui::AboutDialog</name>
    <message>
        <source>About Kriva</source>
        <translation>Относно Kriva</translation>
    </message>
    <message>
        <source>A workbench for Bézier curves.</source>
        <translation>Работилница за криви на Безие.</translation>
    </message>
    <message>
        <source>Free software under the MIT licence.</source>
        <translation>Свободен софтуер под лиценза MIT.</translation>
    </message>
    <message>
        <source>Built on %1 (LGPL, dynamically linked), Eigen, JSON for Modern C++ and pugixml.</source>
        <translation>Изградена върху %1 (LGPL, динамично свързан), Eigen, JSON for Modern C++ и pugixml.</translation>
    </message>
</context>
<context>
    <name>kriva::ui::CanvasView</name>
    <message>
        <source>Canvas</source>
        <translation>Платно</translation>
    </message>
</context>
<context>
    <name>kriva::ui::CombinedProperties</name>
    <message>
        <source>Back to automatic</source>
        <translation>Обратно към автоматично</translation>
    </message>
    <message>
        <source>Puts the selected middle points, or all where none is selected, where the tangents meet</source>
        <translation>Поставя избраните междинни точки, или всички, ако няма избрани, където се срещат допирателните</translation>
    </message>
    <message>
        <source>1 of 5: the given points</source>
        <translation>1 от 5: опорните точки</translation>
    </message>
    <message>
        <source>2 of 5: monotone runs</source>
        <translation>2 от 5: монотонни участъци</translation>
    </message>
    <message>
        <source>3 of 5: a polynomial for each run</source>
        <translation>3 от 5: полином за всеки участък</translation>
    </message>
    <message>
        <source>4 of 5: joins between the runs</source>
        <translation>4 от 5: съединения между участъците</translation>
    </message>
    <message>
        <source>5 of 5: the whole curve</source>
        <translation>5 от 5: цялата крива</translation>
    </message>
</context>
<context>
    <name>kriva::ui::CurvesPanel</name>
    <message>
        <source>New curve</source>
        <translation>Нова крива</translation>
    </message>
    <message>
        <source>Duplicate the curve</source>
        <translation>Дублиране на кривата</translation>
    </message>
    <message>
        <source>Delete the curve</source>
        <translation>Изтриване на кривата</translation>
    </message>
    <message>
        <source>Move the curve up</source>
        <translation>Преместване на кривата нагоре</translation>
    </message>
    <message>
        <source>Move the curve down</source>
        <translation>Преместване на кривата надолу</translation>
    </message>
    <message>
        <source>Colour of the curve</source>
        <translation>Цвят на кривата</translation>
    </message>
    <message>
        <source>Curves</source>
        <translation>Криви</translation>
    </message>
    <message>
        <source>Style of the curve</source>
        <translation>Стил на кривата</translation>
    </message>
</context>
<context>
    <name>kriva::ui::DocumentSession</name>
    <message>
        <source>Untitled</source>
        <translation>Без име</translation>
    </message>
    <message>
        <source>Open</source>
        <translation>Отваряне</translation>
    </message>
    <message>
        <source>Documents and figures of Kriva (*.kriva *.svg)</source>
        <translation>Документи и фигури на Kriva (*.kriva *.svg)</translation>
    </message>
    <message>
        <source>Save as</source>
        <translation>Запазване като</translation>
    </message>
    <message>
        <source>Documents of Kriva (*.kriva)</source>
        <translation>Документи на Kriva (*.kriva)</translation>
    </message>
    <message>
        <source>Unsaved changes cannot be kept for a recovery: %1</source>
        <translation>Незапазените промени не могат да се пазят за възстановяване: %1</translation>
    </message>
</context>
<context>
    <name>kriva::ui::ElevationProperties</name>
    <message>
        <source>The curve then moves by at most %1</source>
        <translation>Тогава кривата се отмества най-много с %1</translation>
    </message>
    <message>
        <source>The degree cannot fall any more</source>
        <translation>Степента не може да се понижи повече</translation>
    </message>
    <message>
        <source>The curve then stays as it is</source>
        <translation>Тогава кривата остава същата</translation>
    </message>
</context>
<context>
    <name>kriva::ui::ExportDialog</name>
    <message>
        <source>Export figure</source>
        <translation>Изнасяне на фигура</translation>
    </message>
    <message>
        <source>SVG figure</source>
        <translation>Фигура SVG</translation>
    </message>
    <message>
        <source>PDF page</source>
        <translation>Страница PDF</translation>
    </message>
    <message>
        <source>PNG picture</source>
        <translation>Картина PNG</translation>
    </message>
    <message>
        <source>TikZ for LaTeX</source>
        <translation>TikZ за LaTeX</translation>
    </message>
    <message>
        <source>CSV of the points</source>
        <translation>CSV с точките</translation>
    </message>
    <message>
        <source>Light</source>
        <translation>Светли</translation>
    </message>
    <message>
        <source>Dark</source>
        <translation>Тъмни</translation>
    </message>
    <message>
        <source>&amp;Format</source>
        <translation>&amp;Формат</translation>
    </message>
    <message>
        <source>&amp;Margin (mm)</source>
        <translation>&amp;Поле (mm)</translation>
    </message>
    <message>
        <source>Page</source>
        <translation>Страница</translation>
    </message>
    <message>
        <source>&amp;Colours</source>
        <translation>&amp;Цветове</translation>
    </message>
    <message>
        <source>La&amp;yers</source>
        <translation>С&amp;лоеве</translation>
    </message>
    <message>
        <source>D&amp;ecimals</source>
        <translation>&amp;Десетични знаци</translation>
    </message>
    <message>
        <source>&amp;Dots per inch</source>
        <translation>&amp;Точки на инч</translation>
    </message>
    <message>
        <source>Text&amp;s in the figure</source>
        <translation>&amp;Надписи във фигурата</translation>
    </message>
    <message>
        <source>Layers for &amp;Inkscape</source>
        <translation>Слоеве за &amp;Inkscape</translation>
    </message>
    <message>
        <source>&amp;Round coordinates</source>
        <translation>З&amp;акръгляване на координатите</translation>
    </message>
    <message>
        <source>&amp;Transparent</source>
        <translation>Прозра&amp;чна</translation>
    </message>
    <message>
        <source>A &amp;part for another document</source>
        <translation>Част за д&amp;руг документ</translation>
    </message>
    <message>
        <source>The figure as it will be</source>
        <translation>Фигурата, каквато ще бъде</translation>
    </message>
    <message>
        <source>%1 × %2 mm</source>
        <translation>%1 × %2 mm</translation>
    </message>
    <message>
        <source>The document &amp;goes along, to open the file again</source>
        <translation>Доку&amp;ментът е във файла, за да се отвори отново</translation>
    </message>
    <message>
        <source>E&amp;xport…</source>
        <translation>И&amp;знасяне…</translation>
    </message>
    <message>
        <source>Fra&amp;mes</source>
        <translation>&amp;Кадри</translation>
    </message>
    <message>
        <source>Seconds of &amp;a frame</source>
        <translation>С&amp;екунди на кадър</translation>
    </message>
    <message>
        <source>0; 5; 10 or 0..10 or t = 0.25; 0.5</source>
        <translation>0; 5; 10 или 0..10 или t = 0,25; 0,5</translation>
    </message>
    <message>
        <source>A&amp;nimated</source>
        <translation>Ан&amp;имирана</translation>
    </message>
    <message>
        <source>O&amp;utlines in place of letters</source>
        <translation>Конт&amp;ури вместо букви</translation>
    </message>
    <message>
        <source>Scale (mm for a unit)</source>
        <translation>Мащаб (mm за единица)</translation>
    </message>
    <message>
        <source>Width (mm)</source>
        <translation>Ширина (mm)</translation>
    </message>
    <message>
        <source>Set the &amp;width</source>
        <translation>Задаване на &amp;ширината</translation>
    </message>
    <message>
        <source>Set the scale</source>
        <translation>Задаване на мащаба</translation>
    </message>
</context>
<context>
    <name>kriva::ui::FigureExport</name>
    <message>
        <source>The figure was not written</source>
        <translation>Фигурата не беше записана</translation>
    </message>
    <message>
        <source>Export figure</source>
        <translation>Изнасяне на фигура</translation>
    </message>
    <message>
        <source>Figures (%1)</source>
        <translation>Фигури (%1)</translation>
    </message>
    <message>
        <source>Written: %1</source>
        <translation>Записано: %1</translation>
    </message>
    <message>
        <source>Print</source>
        <translation>Печат</translation>
    </message>
    <message>
        <source>Working out the figure…</source>
        <translation>Пресмята се фигурата…</translation>
    </message>
</context>
<context>
    <name>kriva::ui::FramesField</name>
    <message numerus="yes">
        <source>At most %n frame(s): stages, such as 0; 5 or 0..10, or values of t, such as t = 0.25; 0.5.</source>
        <translation>
            <numerusform>Най-много %n кадър: етапи, например 0; 5 или 0..10, или стойности на t, например t = 0,25; 0,5.</numerusform>
            <numerusform>Най-много %n кадъра: етапи, например 0; 5 или 0..10, или стойности на t, например t = 0,25; 0,5.</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>kriva::ui::GuidePanel</name>
    <message>
        <source>Guide</source>
        <translation>Ръководство</translation>
    </message>
</context>
<context>
    <name>kriva::ui::HistoryPanel</name>
    <message>
        <source>History</source>
        <translation>История</translation>
    </message>
    <message>
        <source>Beginning</source>
        <translation>Начало</translation>
    </message>
</context>
<context>
    <name>kriva::ui::ImportDialog</name>
    <message>
        <source>Import points</source>
        <translation>Внасяне на точки</translation>
    </message>
    <message>
        <source>&amp;Curves</source>
        <translation>&amp;Криви</translation>
    </message>
    <message>
        <source>Curves</source>
        <translation>Криви</translation>
    </message>
    <message>
        <source>&amp;Scale</source>
        <translation>&amp;Мащаб</translation>
    </message>
    <message>
        <source>Move by &amp;x</source>
        <translation>Преместване по &amp;x</translation>
    </message>
    <message>
        <source>Move by &amp;y</source>
        <translation>Преместване по &amp;y</translation>
    </message>
    <message>
        <source>The curves as they will be</source>
        <translation>Кривите, каквито ще бъдат</translation>
    </message>
    <message>
        <source>&amp;Import</source>
        <translation>&amp;Внасяне</translation>
    </message>
    <message numerus="yes">
        <source>%n point(s)</source>
        <translation>
            <numerusform>%n точка</numerusform>
            <numerusform>%n точки</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>kriva::ui::LayersPanel</name>
    <message>
        <source>Layers</source>
        <translation>Слоеве</translation>
    </message>
</context>
<context>
    <name>kriva::ui::MainWindow</name>
    <message>
        <source>&amp;Undo: %1</source>
        <translation>&amp;Отмяна: %1</translation>
    </message>
    <message>
        <source>&amp;Undo</source>
        <translation>&amp;Отмяна</translation>
    </message>
    <message>
        <source>&amp;Redo: %1</source>
        <translation>&amp;Повтаряне: %1</translation>
    </message>
    <message>
        <source>&amp;Redo</source>
        <translation>&amp;Повтаряне</translation>
    </message>
    <message>
        <source>Sheets</source>
        <translation>Листове</translation>
    </message>
</context>
<context>
    <name>kriva::ui::NoticeBar</name>
    <message>
        <source>The file “%1” was deleted or moved by another program.</source>
        <translation>Файлът „%1“ е изтрит или преместен от друга програма.</translation>
    </message>
    <message>
        <source>Another program changed the file “%1”.</source>
        <translation>Друга програма промени файла „%1“.</translation>
    </message>
    <message>
        <source>Save again</source>
        <translation>Запазване отново</translation>
    </message>
    <message>
        <source>Reload</source>
        <translation>Презареждане</translation>
    </message>
    <message>
        <source>Leave as it is</source>
        <translation>Оставяне така</translation>
    </message>
</context>
<context>
    <name>kriva::ui::NumberField</name>
    <message>
        <source>A whole number from %1 to %2 is needed.</source>
        <translation>Нужно е цяло число от %1 до %2.</translation>
    </message>
    <message>
        <source>A number above %1 and below %2 is needed.</source>
        <translation>Нужно е число над %1 и под %2.</translation>
    </message>
    <message>
        <source>A number from %1 to %2 is needed.</source>
        <translation>Нужно е число от %1 до %2.</translation>
    </message>
</context>
<context>
    <name>kriva::ui::NumberListField</name>
    <message numerus="yes">
        <source>%n number(s) from %1 to %2, with semicolons between them.</source>
        <translation>
            <numerusform>%n число от %1 до %2, разделени с точка и запетая.</numerusform>
            <numerusform>%n числа от %1 до %2, разделени с точка и запетая.</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>At most %n number(s) above %1 and below %2, with semicolons between them.</source>
        <translation>
            <numerusform>Най-много %n число над %1 и под %2, разделени с точка и запетая.</numerusform>
            <numerusform>Най-много %n числа над %1 и под %2, разделени с точка и запетая.</numerusform>
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
        <translation>Един етап назад</translation>
    </message>
    <message>
        <source>One stage on</source>
        <translation>Един етап напред</translation>
    </message>
    <message>
        <source>Pause</source>
        <translation>Пауза</translation>
    </message>
    <message>
        <source>Play</source>
        <translation>Пускане</translation>
    </message>
    <message>
        <source>Slower</source>
        <translation>По-бавно</translation>
    </message>
    <message>
        <source>Faster</source>
        <translation>По-бързо</translation>
    </message>
    <message>
        <source>Over and over</source>
        <translation>Отново и отново</translation>
    </message>
    <message>
        <source>Direction of the animation: forwards</source>
        <translation>Посока на анимацията: напред</translation>
    </message>
    <message>
        <source>Direction of the animation: backwards</source>
        <translation>Посока на анимацията: назад</translation>
    </message>
    <message>
        <source>Direction of the animation: to and fro</source>
        <translation>Посока на анимацията: напред и назад</translation>
    </message>
    <message>
        <source>Animation speed</source>
        <translation>Скорост на анимацията</translation>
    </message>
    <message>
        <source>Stage</source>
        <translation>Етап</translation>
    </message>
    <message>
        <source>Keep this stage</source>
        <translation>Запазване на този етап</translation>
    </message>
    <message>
        <source>Writes the stage on view into the document</source>
        <translation>Записва показания етап в документа</translation>
    </message>
    <message>
        <source>Animation</source>
        <translation>Анимация</translation>
    </message>
</context>
<context>
    <name>kriva::ui::PlotsPanel</name>
    <message>
        <source>Plot</source>
        <translation>Графика</translation>
    </message>
    <message>
        <source>Export the plot</source>
        <translation>Изнасяне на графиката</translation>
    </message>
</context>
<context>
    <name>kriva::ui::PointsModel</name>
    <message>
        <source>New point</source>
        <translation>Нова точка</translation>
    </message>
</context>
<context>
    <name>kriva::ui::PointsPanel</name>
    <message>
        <source>Points</source>
        <translation>Точки</translation>
    </message>
</context>
<context>
    <name>kriva::ui::PropertiesPanel</name>
    <message>
        <source>Less</source>
        <translation>По-малко</translation>
    </message>
    <message>
        <source>More</source>
        <translation>Повече</translation>
    </message>
</context>
<context>
    <name>kriva::ui::RecoveryDialog</name>
    <message>
        <source>Untitled</source>
        <translation>Без име</translation>
    </message>
    <message>
        <source>never saved · changed %1</source>
        <comment>a document and a time</comment>
        <translation>не е запазван · променен %1</translation>
    </message>
    <message>
        <source>%1 · changed %2</source>
        <comment>a folder and a time</comment>
        <translation>%1 · променен %2</translation>
    </message>
    <message>
        <source>Damaged: it cannot be read any more.</source>
        <translation>Повреден: вече не може да се прочете.</translation>
    </message>
    <message>
        <source>Damaged: look closely at what is recovered.</source>
        <translation>Повреден: прегледайте внимателно възстановеното.</translation>
    </message>
    <message>
        <source>What to do with %1</source>
        <translation>Какво да стане с %1</translation>
    </message>
    <message>
        <source>Recover</source>
        <translation>Възстановяване</translation>
    </message>
    <message>
        <source>Ask later</source>
        <translation>Питане по-късно</translation>
    </message>
    <message>
        <source>Discard</source>
        <translation>Изхвърляне</translation>
    </message>
    <message>
        <source>Recover unsaved work</source>
        <translation>Възстановяване на незапазеното</translation>
    </message>
    <message>
        <source>Kriva ended before this was saved</source>
        <translation>Kriva приключи, преди това да бъде запазено</translation>
    </message>
    <message>
        <source>What is recovered opens in a window of its own and is written to its file only when you save.</source>
        <translation>Възстановеното се отваря в собствен прозорец и се записва във файла си едва когато го запазите.</translation>
    </message>
    <message>
        <source>&amp;Continue</source>
        <translation>&amp;Продължаване</translation>
    </message>
    <message>
        <source>Ask &amp;later about all</source>
        <translation>Питане по-къ&amp;сно за всички</translation>
    </message>
    <message>
        <source>Missing: the unsaved work is not there any more.</source>
        <translation>Липсва: незапазеното вече го няма.</translation>
    </message>
</context>
<context>
    <name>kriva::ui::ResultsModel</name>
    <message>
        <source>Name</source>
        <translation>Име</translation>
    </message>
    <message>
        <source>Value</source>
        <translation>Стойност</translation>
    </message>
</context>
<context>
    <name>kriva::ui::ResultsPanel</name>
    <message>
        <source>Results</source>
        <translation>Резултати</translation>
    </message>
</context>
<context>
    <name>kriva::ui::ShortcutsDialog</name>
    <message>
        <source>Shortcuts</source>
        <translation>Клавишни комбинации</translation>
    </message>
    <message>
        <source>Search</source>
        <translation>Търсене</translation>
    </message>
    <message>
        <source>What it does</source>
        <translation>Действие</translation>
    </message>
    <message>
        <source>Keys and mouse</source>
        <translation>Клавиши и мишка</translation>
    </message>
</context>
<context>
    <name>kriva::ui::SplineProperties</name>
    <message>
        <source>Closed</source>
        <translation>Затворена</translation>
    </message>
    <message>
        <source>Given here; otherwise that of the natural spline</source>
        <translation>Зададена тук; иначе тази на естествения сплайн</translation>
    </message>
    <message>
        <source>Given</source>
        <translation>Зададена</translation>
    </message>
    <message>
        <source>Show the comb</source>
        <translation>Показване на гребена</translation>
    </message>
    <message>
        <source>Show the polyline</source>
        <translation>Показване на линията</translation>
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
        <translation>Координати на показалеца</translation>
    </message>
    <message>
        <source>Zoom</source>
        <translation>Мащаб</translation>
    </message>
</context>
<context>
    <name>kriva::ui::StyleEditor</name>
    <message>
        <source>Width of the line</source>
        <translation>Дебелина на линията</translation>
    </message>
    <message>
        <source>Line</source>
        <translation>Линия</translation>
    </message>
    <message>
        <source>Marks of the points</source>
        <translation>Знаци на точките</translation>
    </message>
    <message>
        <source>Labels</source>
        <translation>Означения</translation>
    </message>
    <message>
        <source>Usual style</source>
        <translation>Обичаен стил</translation>
    </message>
</context>
<context>
    <name>kriva::ui::SubdivisionProperties</name>
    <message>
        <source>Show the curve</source>
        <translation>Показване на кривата</translation>
    </message>
    <message>
        <source>Show the blossom</source>
        <translation>Показване на полярната форма</translation>
    </message>
    <message>
        <source>Parameter t</source>
        <translation>Параметър t</translation>
    </message>
    <message>
        <source>Levels</source>
        <translation>Нива</translation>
    </message>
    <message>
        <source>Shows the de Casteljau scheme at these t as well, like 0.25; 0.75</source>
        <translation>Показва схемата на дьо Кастелжо и при тези t, например 0,25; 0,75</translation>
    </message>
    <message>
        <source>Show the pieces</source>
        <translation>Показване на частите</translation>
    </message>
</context>
<context>
    <name>kriva::ui::TablesPanel</name>
    <message>
        <source>Table</source>
        <translation>Таблица</translation>
    </message>
    <message>
        <source>Numbers of the table</source>
        <translation>Числа в таблицата</translation>
    </message>
    <message>
        <source>LaTeX</source>
        <translation>LaTeX</translation>
    </message>
    <message>
        <source>Copy the table as LaTeX</source>
        <translation>Копиране на таблицата като LaTeX</translation>
    </message>
    <message>
        <source>CSV</source>
        <translation>CSV</translation>
    </message>
    <message>
        <source>Copy the table for a spreadsheet</source>
        <translation>Копиране на таблицата за електронна таблица</translation>
    </message>
</context>
</TS>
