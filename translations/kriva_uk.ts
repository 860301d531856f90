<?xml version="1.0" encoding="utf-8"?>
<!DOCTYPE TS>
<TS version="2.1" language="uk" sourcelanguage="en">
<context>
    <name>Actions</name>
    <message>
        <source>&amp;New</source>
        <translation>&amp;Новий</translation>
    </message>
    <message>
        <source>&amp;Open…</source>
        <translation>&amp;Відкрити…</translation>
    </message>
    <message>
        <source>&amp;Save</source>
        <translation>&amp;Зберегти</translation>
    </message>
    <message>
        <source>Save &amp;as…</source>
        <translation>Зберегти &amp;як…</translation>
    </message>
    <message>
        <source>&amp;Export figure…</source>
        <translation>&amp;Експортувати рисунок…</translation>
    </message>
    <message>
        <source>&amp;Quit</source>
        <translation>Ви&amp;йти</translation>
    </message>
    <message>
        <source>&amp;Undo</source>
        <translation>&amp;Скасувати</translation>
    </message>
    <message>
        <source>&amp;Redo</source>
        <translation>&amp;Повторити</translation>
    </message>
    <message>
        <source>&amp;Delete</source>
        <translation>&amp;Вилучити</translation>
    </message>
    <message>
        <source>Delete &amp;last point</source>
        <translation>Вилучити &amp;останню точку</translation>
    </message>
    <message>
        <source>&amp;Clear the canvas</source>
        <translation>О&amp;чистити полотно</translation>
    </message>
    <message>
        <source>Select &amp;all</source>
        <translation>Вибрати вс&amp;е</translation>
    </message>
    <message>
        <source>Select n&amp;one</source>
        <translation>Зняти ви&amp;бір</translation>
    </message>
    <message>
        <source>&amp;Invert the selection</source>
        <translation>Обе&amp;рнути вибір</translation>
    </message>
    <message>
        <source>&amp;New curve</source>
        <translation>&amp;Нова крива</translation>
    </message>
    <message>
        <source>&amp;Duplicate the curve</source>
        <translation>&amp;Дублювати криву</translation>
    </message>
    <message>
        <source>De&amp;lete the curve</source>
        <translation>&amp;Вилучити криву</translation>
    </message>
    <message>
        <source>Ne&amp;xt curve</source>
        <translation>На&amp;ступна крива</translation>
    </message>
    <message>
        <source>&amp;Reverse</source>
        <translation>&amp;Обернути</translation>
    </message>
    <message>
        <source>&amp;Edit tool</source>
        <translation>Інструмент &amp;редагування</translation>
    </message>
    <message>
        <source>&amp;Add tool</source>
        <translation>Інструмент &amp;додавання</translation>
    </message>
    <message>
        <source>Zoom &amp;in</source>
        <translation>З&amp;більшити</translation>
    </message>
    <message>
        <source>Zoom &amp;out</source>
        <translation>З&amp;меншити</translation>
    </message>
    <message>
        <source>Zoom to &amp;100 %</source>
        <translation>Масштаб &amp;100 %</translation>
    </message>
    <message>
        <source>&amp;Fit all</source>
        <translation>&amp;Умістити все</translation>
    </message>
    <message>
        <source>Fit &amp;selection</source>
        <translation>Умістити в&amp;ибране</translation>
    </message>
    <message>
        <source>&amp;Grid</source>
        <translation>&amp;Сітка</translation>
    </message>
    <message>
        <source>A&amp;xes</source>
        <translation>&amp;Осі</translation>
    </message>
    <message>
        <source>&amp;Reset panels</source>
        <translation>Скинути &amp;панелі</translation>
    </message>
    <message>
        <source>F&amp;ull screen</source>
        <translation>&amp;На весь екран</translation>
    </message>
    <message>
        <source>&amp;About Kriva</source>
        <translation>&amp;Про Kriva</translation>
    </message>
    <message>
        <source>About &amp;Qt</source>
        <translation>Про &amp;Qt</translation>
    </message>
    <message>
        <source>S&amp;how the history</source>
        <translation>Показати &amp;історію</translation>
    </message>
    <message>
        <source>Cu&amp;t</source>
        <translation>Вирі&amp;зати</translation>
    </message>
    <message>
        <source>Co&amp;py</source>
        <translation>&amp;Копіювати</translation>
    </message>
    <message>
        <source>Pa&amp;ste</source>
        <translation>Вст&amp;авити</translation>
    </message>
    <message>
        <source>Duplicat&amp;e</source>
        <translation>&amp;Дублювати</translation>
    </message>
    <message>
        <source>Rena&amp;me</source>
        <translation>&amp;Перейменувати</translation>
    </message>
    <message>
        <source>Move &amp;up in the list</source>
        <translation>Посунути в&amp;гору у списку</translation>
    </message>
    <message>
        <source>Move do&amp;wn in the list</source>
        <translation>Посунути вни&amp;з у списку</translation>
    </message>
    <message>
        <source>&amp;Show the curve</source>
        <translation>По&amp;казати криву</translation>
    </message>
    <message>
        <source>Ru&amp;lers</source>
        <translation>&amp;Лінійки</translation>
    </message>
    <message>
        <source>S&amp;nap</source>
        <translation>Прилип&amp;ання</translation>
    </message>
    <message>
        <source>&amp;Insert a point</source>
        <translation>Вставити то&amp;чку</translation>
    </message>
    <message>
        <source>User &amp;guide</source>
        <translation>П&amp;осібник користувача</translation>
    </message>
    <message>
        <source>&amp;Shortcuts</source>
        <translation>&amp;Клавіатурні скорочення</translation>
    </message>
    <message>
        <source>Export a&amp;gain</source>
        <translation>Експортувати &amp;ще раз</translation>
    </message>
    <message>
        <source>Copy &amp;figure</source>
        <translation>Копіювати &amp;рисунок</translation>
    </message>
    <message>
        <source>Copy as &amp;TikZ</source>
        <translation>Копіювати як &amp;TikZ</translation>
    </message>
    <message>
        <source>&amp;Import points…</source>
        <translation>&amp;Імпортувати точки…</translation>
    </message>
    <message>
        <source>Copy pat&amp;h</source>
        <translation>Копіювати к&amp;онтур</translation>
    </message>
    <message>
        <source>&amp;Print…</source>
        <translation>Др&amp;укувати…</translation>
    </message>
    <message>
        <source>New &amp;window</source>
        <translation>Відкри&amp;ти нове вікно</translation>
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
        <translation>Підвищення степеня</translation>
    </message>
    <message>
        <source>Subdivision</source>
        <translation>Підрозбиття</translation>
    </message>
    <message>
        <source>Spline</source>
        <translation>Сплайн</translation>
    </message>
    <message>
        <source>Combined algorithm</source>
        <translation>Комбінований алгоритм</translation>
    </message>
    <message>
        <source>Curve</source>
        <translation>Крива</translation>
    </message>
    <message>
        <source>Control polygon</source>
        <translation>Контрольний полігон</translation>
    </message>
    <message>
        <source>Elevated polygon</source>
        <translation>Полігон підвищеного степеня</translation>
    </message>
    <message>
        <source>Points</source>
        <translation>Точки</translation>
    </message>
    <message>
        <source>Labels</source>
        <translation>Позначення</translation>
    </message>
    <message>
        <source>De Casteljau scheme</source>
        <translation>Схема де Кастельжо</translation>
    </message>
    <message>
        <source>Curves of degree n − 1</source>
        <translation>Криві степеня n − 1</translation>
    </message>
    <message>
        <source>Pieces</source>
        <translation>Частини</translation>
    </message>
    <message>
        <source>Left polygon</source>
        <translation>Лівий полігон</translation>
    </message>
    <message>
        <source>Right polygon</source>
        <translation>Правий полігон</translation>
    </message>
    <message>
        <source>Point of the curve</source>
        <translation>Точка кривої</translation>
    </message>
    <message>
        <source>Blossom</source>
        <translation>Полярна форма</translation>
    </message>
    <message>
        <source>Labels of left and right</source>
        <translation>Позначення лівого і правого</translation>
    </message>
    <message>
        <source>Degree</source>
        <translation>Степінь</translation>
    </message>
    <message>
        <source>Length</source>
        <translation>Довжина</translation>
    </message>
    <message>
        <source>Bounds</source>
        <translation>Межі</translation>
    </message>
    <message>
        <source>Degree after elevation</source>
        <translation>Степінь після підвищення</translation>
    </message>
    <message>
        <source>Gap between polygon and curve</source>
        <translation>Відстань між полігоном і кривою</translation>
    </message>
    <message>
        <source>Point at t</source>
        <translation>Точка при t</translation>
    </message>
    <message>
        <source>Derivative at t</source>
        <translation>Похідна при t</translation>
    </message>
    <message>
        <source>Number of pieces</source>
        <translation>Кількість частин</translation>
    </message>
    <message>
        <source>Knots</source>
        <translation>Вузли</translation>
    </message>
    <message>
        <source>Handles</source>
        <translation>Маркери</translation>
    </message>
    <message>
        <source>End derivatives</source>
        <translation>Похідні на кінцях</translation>
    </message>
    <message>
        <source>Length of segment</source>
        <translation>Довжина сегмента</translation>
    </message>
    <message>
        <source>Coefficients of segment</source>
        <translation>Коефіцієнти сегмента</translation>
    </message>
    <message>
        <source>Continuity at knot</source>
        <translation>Неперервність у вузлі</translation>
    </message>
    <message>
        <source>Extrema of the curvature</source>
        <translation>Екстремуми кривини</translation>
    </message>
    <message>
        <source>Bending energy</source>
        <translation>Енергія згину</translation>
    </message>
    <message>
        <source>Polygon of the given points</source>
        <translation>Полігон опорних точок</translation>
    </message>
    <message>
        <source>Monotone runs</source>
        <translation>Монотонні ділянки</translation>
    </message>
    <message>
        <source>Joins</source>
        <translation>Сполучення</translation>
    </message>
    <message>
        <source>Middle points of pairs</source>
        <translation>Проміжні точки пар</translation>
    </message>
    <message>
        <source>Numbers of runs</source>
        <translation>Номери ділянок</translation>
    </message>
    <message>
        <source>Points of run</source>
        <translation>Точки ділянки</translation>
    </message>
    <message>
        <source>Degree of run</source>
        <translation>Степінь ділянки</translation>
    </message>
    <message>
        <source>Coefficients of run</source>
        <translation>Коефіцієнти ділянки</translation>
    </message>
    <message>
        <source>Residual (root mean square) of run</source>
        <translation>Нев’язка (середньоквадратична) ділянки</translation>
    </message>
    <message>
        <source>Largest residual of run</source>
        <translation>Найбільша нев’язка ділянки</translation>
    </message>
    <message>
        <source>Largest kink</source>
        <translation>Найбільший злам</translation>
    </message>
    <message>
        <source>Slope variation</source>
        <translation>Варіація нахилу</translation>
    </message>
    <message>
        <source>This curve needs more points</source>
        <translation>Цій кривій потрібно більше точок</translation>
    </message>
    <message>
        <source>open end</source>
        <translation>вільний кінець</translation>
    </message>
    <message>
        <source>Crossings</source>
        <translation>Перетини</translation>
    </message>
    <message>
        <source>Crossings of the sheet</source>
        <translation>Перетини на аркуші</translation>
    </message>
    <message>
        <source>Crossing</source>
        <translation>Перетин</translation>
    </message>
    <message>
        <source>Overlaps of the sheet</source>
        <translation>Накладання на аркуші</translation>
    </message>
    <message>
        <source>Bernstein polynomials</source>
        <translation>Поліноми Бернштейна</translation>
    </message>
    <message>
        <source>Control point</source>
        <translation>Контрольна точка</translation>
    </message>
    <message>
        <source>Weight</source>
        <translation>Вага</translation>
    </message>
    <message>
        <source>Weights at t</source>
        <translation>Ваги при t</translation>
    </message>
    <message>
        <source>Level</source>
        <translation>Рівень</translation>
    </message>
    <message>
        <source>Left and right polygon</source>
        <translation>Лівий і правий полігони</translation>
    </message>
    <message>
        <source>Points of the last elevation</source>
        <translation>Точки останнього підвищення</translation>
    </message>
    <message>
        <source>Hodograph</source>
        <translation>Годограф</translation>
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
        <translation>Усі правила</translation>
    </message>
    <message>
        <source>Catmull–Rom</source>
        <translation>Катмулла–Рома</translation>
    </message>
    <message>
        <source>Largest curvature</source>
        <translation>Найбільша кривина</translation>
    </message>
    <message>
        <source>Run</source>
        <translation>Ділянка</translation>
    </message>
    <message>
        <source>After run</source>
        <translation>Після ділянки</translation>
    </message>
    <message>
        <source>Values of the runs, y(x)</source>
        <translation>Значення ділянок, y(x)</translation>
    </message>
    <message>
        <source>Slopes of the runs, y′(x)</source>
        <translation>Нахили ділянок, y′(x)</translation>
    </message>
    <message>
        <source>Method</source>
        <translation>Метод</translation>
    </message>
    <message>
        <source>Comparison of methods</source>
        <translation>Порівняння методів</translation>
    </message>
    <message>
        <source>Interpolation</source>
        <translation>Інтерполяція</translation>
    </message>
    <message>
        <source>Approximation</source>
        <translation>Апроксимація</translation>
    </message>
    <message>
        <source>Pairs</source>
        <translation>Пари</translation>
    </message>
    <message>
        <source>All polygons so far</source>
        <translation>Усі полігони дотепер</translation>
    </message>
    <message>
        <source>Convex hull</source>
        <translation>Опукла оболонка</translation>
    </message>
    <message>
        <source>End tangents</source>
        <translation>Дотичні на кінцях</translation>
    </message>
    <message>
        <source>De Casteljau schemes at further t</source>
        <translation>Схеми де Кастельжо при інших t</translation>
    </message>
    <message>
        <source>Curvature comb</source>
        <translation>Гребінь кривини</translation>
    </message>
    <message>
        <source>Inflections</source>
        <translation>Точки перегину</translation>
    </message>
    <message>
        <source>Continuity at the knots</source>
        <translation>Неперервність у вузлах</translation>
    </message>
    <message>
        <source>Polygons of runs</source>
        <translation>Полігони ділянок</translation>
    </message>
    <message>
        <source>Polynomials of runs</source>
        <translation>Многочлени ділянок</translation>
    </message>
    <message>
        <source>mirror</source>
        <translation>дзеркальне</translation>
    </message>
    <message>
        <source>natural</source>
        <translation>природний</translation>
    </message>
    <message>
        <source>clamped</source>
        <translation>затиснутий</translation>
    </message>
    <message>
        <source>De Casteljau polyline</source>
        <translation>Ламана де Кастельжо</translation>
    </message>
    <message>
        <source>Grid</source>
        <translation>Сітка</translation>
    </message>
    <message>
        <source>Numbers of the axes</source>
        <translation>Числа на осях</translation>
    </message>
    <message>
        <source>Axes</source>
        <translation>Осі</translation>
    </message>
    <message>
        <source>Lines</source>
        <translation>Лінії</translation>
    </message>
    <message>
        <source>Place on view</source>
        <translation>Розглядуване місце</translation>
    </message>
    <message>
        <source>Legend</source>
        <translation>Легенда</translation>
    </message>
    <message>
        <source>Residual (root mean square)</source>
        <translation>Нев’язка (середньоквадратична)</translation>
    </message>
    <message>
        <source>Passes through crossings and overlaps</source>
        <translation>Проходження через перетини та накладання</translation>
    </message>
    <message>
        <source>too many to count</source>
        <translation>забагато, щоб полічити</translation>
    </message>
</context>
<context>
    <name>Clip</name>
    <message>
        <source>The clipboard: %1</source>
        <translation>Буфер обміну: %1</translation>
    </message>
    <message>
        <source>The clipboard: its curve cannot be read: %1</source>
        <translation>Буфер обміну: його криву неможливо прочитати: %1</translation>
    </message>
</context>
<context>
    <name>CommandLine</name>
    <message>
        <source>unknown option %1</source>
        <translation>невідомий параметр %1</translation>
    </message>
    <message>
        <source>a value is missing behind %1</source>
        <translation>після %1 бракує значення</translation>
    </message>
    <message>
        <source>unknown language %1</source>
        <translation>невідома мова %1</translation>
    </message>
    <message>
        <source>there is no sheet %1</source>
        <translation>немає аркуша %1</translation>
    </message>
    <message>
        <source>the option --%1 does not belong here</source>
        <translation>параметру --%1 тут не місце</translation>
    </message>
    <message>
        <source>export needs the file to write: -o OUT.svg</source>
        <translation>export потребує файлу для запису: -o OUT.svg</translation>
    </message>
    <message>
        <source>report needs one file</source>
        <translation>report потребує одного файлу</translation>
    </message>
    <message>
        <source>there is no format %1</source>
        <translation>немає формату %1</translation>
    </message>
    <message>
        <source>%1: there is no curve to draw</source>
        <translation>%1: немає кривої, яку можна намалювати</translation>
    </message>
    <message>
        <source>the output could not be written</source>
        <translation>не вдалося записати вивід</translation>
    </message>
    <message>
        <source>the editor needs a display; export and report do without one</source>
        <translation>редакторові потрібен екран; export і report обходяться без нього</translation>
    </message>
    <message>
        <source>%1; kriva --help tells more</source>
        <translation>%1; докладніше: kriva --help</translation>
    </message>
    <message>
        <source>export needs a file</source>
        <translation>export потребує файлу</translation>
    </message>
    <message>
        <source>%1: with several files it needs {name} for the name of each</source>
        <translation>%1: для кількох файлів потрібне {name} для назви кожного</translation>
    </message>
    <message>
        <source>%1: there is no curve %2; the sheet has %3, counted from 0</source>
        <translation>%1: немає кривої %2; аркуш має %3, лічба від 0</translation>
    </message>
    <message>
        <source>there is no layer %1; the sheet has %2</source>
        <translation>немає шару %1; аркуш має %2</translation>
    </message>
    <message>
        <source>%1: figures are written as .svg, .pdf, .png, .tex or .csv</source>
        <translation>%1: рисунки записуються як .svg, .pdf, .png, .tex або .csv</translation>
    </message>
    <message>
        <source>--width must be more than both margins, which are %1 mm</source>
        <translation>--width має бути більше за обидва поля, які становлять %1 мм</translation>
    </message>
    <message>
        <source>there is no theme %1</source>
        <translation>немає теми %1</translation>
    </message>
    <message>
        <source>--%1 is a length such as 120mm, at most %2 mm</source>
        <translation>--%1 є довжиною на зразок 120mm, щонайбільше %2 мм</translation>
    </message>
    <message>
        <source>--%1 is a whole number from %2 to %3</source>
        <translation>--%1 є цілим числом від %2 до %3</translation>
    </message>
    <message>
        <source>import needs a file</source>
        <translation>import потребує файлу</translation>
    </message>
    <message>
        <source>import needs the document to write: -o OUT.kriva</source>
        <translation>import потребує документа для запису: -o OUT.kriva</translation>
    </message>
    <message>
        <source>import needs the sheet that the curves go to: --sheet NAME</source>
        <translation>import потребує аркуша, на який підуть криві: --sheet NAME</translation>
    </message>
    <message>
        <source>there is no scale %1</source>
        <translation>немає масштабу %1</translation>
    </message>
    <message>
        <source>%1 is no offset: two numbers with a comma between them</source>
        <translation>%1 — не зсув: два числа з комою між ними</translation>
    </message>
    <message>
        <source>--frames are stages such as 0,5,10 or 0..10, or values such as t=0.25,0.5</source>
        <translation>--frames — це етапи, як-от 0,5,10 чи 0..10, або значення, як-от t=0.25,0.5</translation>
    </message>
    <message>
        <source>--animate needs --frames and an SVG file</source>
        <translation>--animate потребує --frames і файлу SVG</translation>
    </message>
    <message>
        <source>--seconds is a number from %1 to %2</source>
        <translation>--seconds — число від %1 до %2</translation>
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
    відкриває редактор
kriva export FILE... -o OUT.{svg,pdf,png,tex,csv} [--sheet NAME] [--curve N] [--layers A,B]
    малює аркуш: названий, інакше той, що був показаний під час збереження документа.
    {name} і {sheet} в OUT — назва й аркуш кожного файлу; - є стандартним вводом і виводом
    --format svg|pdf|png|tex|csv     коли кінець OUT його не називає
    --width 120mm --margin 6mm       сторінки; mm, cm, in або pt
    --scale 10                       міліметрів на одиницю замість ширини
    --no-labels --theme light|dark
    --no-document --decimals N --inkscape-layers --outlines    для SVG; контури замість літер
    --dpi 300 --transparent          для PNG
    --fragment                       для TeX: для вставлення в інший документ
    --frames 0,5,10 | 0..10 | t=0.25,0.5   етапи анімації поруч або з {frame} в OUT
                                     файл для кожного; --animate --seconds 0.5: один за одним у SVG
kriva import FILE... -o OUT.kriva --sheet NAME [--scale N] [--offset X,Y]
    робить документ із контурів файлів SVG, з даних контурів або з таблиць точок
kriva report FILE [--format json|text] [--sheet NAME]
    друкує числа документа

    --language CODE   en, bg, sl або uk; інакше мова системи
    --sheet NAME      %1
    --help            цей текст
    --version         версія

Коди виходу: 0 зроблено, 1 невдача, 2 хибне вживання, 3 ввід відхилено, 4 вивід не записано.
</translation>
    </message>
    <message>
        <source>--scale is how many millimetres a unit has</source>
        <translation>--scale — скільки міліметрів має одиниця</translation>
    </message>
    <message>
        <source>--width and --scale do not go together</source>
        <translation>--width і --scale не йдуть разом</translation>
    </message>
    <message>
        <source>%1: its lines were edited in another program; the document inside is taken as it was</source>
        <translation>%1: лінії змінено в іншій програмі; взято документ усередині, яким він був</translation>
    </message>
    <message>
        <source>%1: at work for %2 s; Ctrl+C ends it</source>
        <translation>%1: виконується вже %2 с; Ctrl+C перериває</translation>
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
        <translation>Змінений рисунок</translation>
    </message>
    <message>
        <source>The lines of “%1” were edited in another program: they are not those of the document inside any more.</source>
        <translation>Лінії рисунка «%1» змінено в іншій програмі: вони вже не такі, як у документі всередині.</translation>
    </message>
    <message>
        <source>Open the document as it was, or as it is drawn now?</source>
        <translation>Відкрити документ таким, яким він був, чи таким, як його накреслено тепер?</translation>
    </message>
    <message>
        <source>D&amp;rawing</source>
        <translation>&amp;Креслення</translation>
    </message>
    <message>
        <source>&amp;Document</source>
        <translation>&amp;Документ</translation>
    </message>
    <message>
        <source>Unsaved changes</source>
        <translation>Незбережені зміни</translation>
    </message>
    <message>
        <source>Save the changes to “%1”?</source>
        <translation>Зберегти зміни у «%1»?</translation>
    </message>
    <message>
        <source>Without saving they are lost.</source>
        <translation>Без збереження їх буде втрачено.</translation>
    </message>
    <message>
        <source>The file is gone</source>
        <translation>Файлу немає</translation>
    </message>
    <message>
        <source>Save “%1” again?</source>
        <translation>Зберегти «%1» знову?</translation>
    </message>
    <message>
        <source>Its file was deleted or moved elsewhere.</source>
        <translation>Файл вилучено або переміщено деінде.</translation>
    </message>
    <message>
        <source>Open elsewhere</source>
        <translation>Відкрито деінде</translation>
    </message>
    <message>
        <source>Another Kriva has “%1” open.</source>
        <translation>«%1» відкрито в іншій програмі Kriva.</translation>
    </message>
    <message>
        <source>A copy is a document of its own. Opened anyway, the one that saves last overwrites the other.</source>
        <translation>Копія є окремим документом. Якщо все ж відкрити, то хто збереже останнім, перезапише іншого.</translation>
    </message>
    <message>
        <source>Open a &amp;copy</source>
        <translation>Відкрити &amp;копію</translation>
    </message>
    <message>
        <source>Open &amp;anyway</source>
        <translation>&amp;Все одно відкрити</translation>
    </message>
    <message>
        <source>“%1” is open in another window or in another Kriva.</source>
        <translation>«%1» відкрито в іншому вікні або в іншій програмі Kriva.</translation>
    </message>
    <message>
        <source>Overwritten, it is no longer what is shown there.</source>
        <translation>Якщо його перезаписати, він уже не буде тим, що показано там.</translation>
    </message>
    <message>
        <source>Save &amp;as…</source>
        <translation>Зберегти &amp;як…</translation>
    </message>
    <message>
        <source>&amp;Overwrite</source>
        <translation>&amp;Перезаписати</translation>
    </message>
    <message>
        <source>Changed elsewhere</source>
        <translation>Змінено деінде</translation>
    </message>
    <message>
        <source>Another program changed “%1” since it was opened or saved here.</source>
        <translation>Інша програма змінила «%1», відколи його відкрито або збережено тут.</translation>
    </message>
    <message>
        <source>Overwritten, the changes made there are lost; reloaded, those made here.</source>
        <translation>Якщо перезаписати, буде втрачено зміни, зроблені там; якщо перезавантажити – зроблені тут.</translation>
    </message>
    <message>
        <source>&amp;Reload</source>
        <translation>Перезавантажит&amp;и</translation>
    </message>
    <message>
        <source>Reload “%1” as it is in its file?</source>
        <translation>Перезавантажити «%1» таким, яким він є у файлі?</translation>
    </message>
    <message>
        <source>The changes made here are lost.</source>
        <translation>Зміни, зроблені тут, буде втрачено.</translation>
    </message>
    <message>
        <source>The file was not opened</source>
        <translation>Файл не відкрито</translation>
    </message>
    <message>
        <source>The document was not saved</source>
        <translation>Документ не збережено</translation>
    </message>
    <message>
        <source>It is still here, as you see it.</source>
        <translation>Він усе ще тут, яким ви його бачите.</translation>
    </message>
    <message>
        <source>What is shown here is in no file any more: without saving it is lost.</source>
        <translation>Показаного тут уже немає в жодному файлі: без збереження його буде втрачено.</translation>
    </message>
</context>
<context>
    <name>Errors</name>
    <message>
        <source>line %1, column %2</source>
        <translation>рядок %1, стовпець %2</translation>
    </message>
    <message>
        <source>this is no JSON</source>
        <translation>це не JSON</translation>
    </message>
    <message>
        <source>nested more than %1 deep</source>
        <translation>вкладено глибше ніж %1</translation>
    </message>
    <message>
        <source>a number of more than %1 characters</source>
        <translation>число, довше за %1 символів</translation>
    </message>
    <message>
        <source>this is no document of Kriva</source>
        <translation>це не документ Kriva</translation>
    </message>
    <message>
        <source>version %1 needs a newer Kriva</source>
        <translation>версія %1 потребує новішої Kriva</translation>
    </message>
    <message>
        <source>unknown key</source>
        <translation>невідомий ключ</translation>
    </message>
    <message>
        <source>the key stands here twice</source>
        <translation>ключ стоїть тут двічі</translation>
    </message>
    <message>
        <source>the key “%1” is missing</source>
        <translation>бракує ключа «%1»</translation>
    </message>
    <message>
        <source>expected an object</source>
        <translation>очікувався об’єкт</translation>
    </message>
    <message>
        <source>expected a list</source>
        <translation>очікувався список</translation>
    </message>
    <message>
        <source>expected a text</source>
        <translation>очікувався текст</translation>
    </message>
    <message>
        <source>expected true or false</source>
        <translation>очікувалося true або false</translation>
    </message>
    <message>
        <source>expected a number</source>
        <translation>очікувалося число</translation>
    </message>
    <message>
        <source>expected a whole number from %1 to %2</source>
        <translation>очікувалося ціле число від %1 до %2</translation>
    </message>
    <message>
        <source>expected a number from %1 to %2</source>
        <translation>очікувалося число від %1 до %2</translation>
    </message>
    <message>
        <source>expected a number between %1 and %2</source>
        <translation>очікувалося число між %1 і %2</translation>
    </message>
    <message>
        <source>expected two finite numbers</source>
        <translation>очікувалося два скінченні числа</translation>
    </message>
    <message>
        <source>expected one of: %1</source>
        <translation>очікувалося одне з: %1</translation>
    </message>
    <message>
        <source>expected a colour like #0072b2</source>
        <translation>очікувався колір на зразок #0072b2</translation>
    </message>
    <message numerus="yes">
        <source>expected %n element(s)</source>
        <translation>
            <numerusform>очікувався %n елемент</numerusform>
            <numerusform>очікувалися %n елементи</numerusform>
            <numerusform>очікувалося %n елементів</numerusform>
        </translation>
    </message>
    <message>
        <source>more than %1 is too many</source>
        <translation>більше ніж %1 — забагато</translation>
    </message>
    <message>
        <source>no such index</source>
        <translation>такого індексу немає</translation>
    </message>
    <message>
        <source>the file is larger than %1 bytes</source>
        <translation>файл більший за %1 байтів</translation>
    </message>
    <message>
        <source>this figure has no document of Kriva inside</source>
        <translation>у цьому рисунку немає документа Kriva</translation>
    </message>
    <message>
        <source>this is no XML</source>
        <translation>це не XML</translation>
    </message>
    <message>
        <source>the document type has declarations of its own</source>
        <translation>тип документа має власні оголошення</translation>
    </message>
    <message>
        <source>more than %1 elements are too many</source>
        <translation>більше ніж %1 елементів — забагато</translation>
    </message>
    <message>
        <source>more than %1 attributes are too many</source>
        <translation>більше ніж %1 атрибутів — забагато</translation>
    </message>
    <message>
        <source>%1: there is no such file</source>
        <translation>%1: такого файлу немає</translation>
    </message>
    <message>
        <source>%1: this is no regular file</source>
        <translation>%1: це не звичайний файл</translation>
    </message>
    <message>
        <source>%1: the file is larger than %2 bytes</source>
        <translation>%1: файл більший за %2 байтів</translation>
    </message>
    <message>
        <source>%1: reading is not permitted</source>
        <translation>%1: читати не дозволено</translation>
    </message>
    <message>
        <source>%1: the file cannot be read (%2)</source>
        <translation>%1: файл не вдається прочитати (%2)</translation>
    </message>
    <message>
        <source>%1: there is no such folder</source>
        <translation>%1: такої теки немає</translation>
    </message>
    <message>
        <source>%1: writing is not permitted</source>
        <translation>%1: писати не дозволено</translation>
    </message>
    <message>
        <source>%1: there is no space left</source>
        <translation>%1: не лишилося місця</translation>
    </message>
    <message>
        <source>%1: the file cannot be written (%2)</source>
        <translation>%1: файл не вдається записати (%2)</translation>
    </message>
    <message>
        <source>this is no path data</source>
        <translation>це не дані контуру</translation>
    </message>
    <message>
        <source>the attribute “%1” cannot be read</source>
        <translation>атрибут «%1» неможливо прочитати</translation>
    </message>
    <message>
        <source>there is no path to import</source>
        <translation>немає контуру для імпорту</translation>
    </message>
    <message>
        <source>the interpolated runs have more than %1 pairs of points</source>
        <translation>інтерпольовані ділянки мають понад %1 пар точок</translation>
    </message>
    <message>
        <source>%1: written, but the owner or the permissions of the file could not be kept</source>
        <translation>%1: записано, але власника або права файлу зберегти не вдалося</translation>
    </message>
    <message>
        <source>a sheet takes at most %1 curves, and these are %2</source>
        <translation>аркуш уміщує щонайбільше %1 кривих, а цих %2</translation>
    </message>
    <message>
        <source>a sheet takes at most %1 points</source>
        <translation>аркуш уміщує щонайбільше %1 точок</translation>
    </message>
    <message>
        <source>a sheet takes at most %1 points of elevated curves and of pieces</source>
        <translation>аркуш уміщує щонайбільше %1 точок кривих підвищеного степеня та частин</translation>
    </message>
    <message>
        <source>this curve takes at most %1 points, and would have %2</source>
        <translation>ця крива вміщує щонайбільше %1 точок, а мала б %2</translation>
    </message>
    <message>
        <source>interpolation takes at most %1 points in a monotone run, and one has %2</source>
        <translation>інтерполяція допускає щонайбільше %1 точок на монотонній ділянці, а одна має %2</translation>
    </message>
    <message>
        <source>a report takes at most %1 segments of a sheet, and these are %2</source>
        <translation>звіт приймає щонайбільше %1 сегментів аркуша, а їх %2</translation>
    </message>
    <message>
        <source>more than %1 passes through crossings and overlaps are too many</source>
        <translation>більше ніж %1 проходжень через перетини та накладання — це забагато</translation>
    </message>
    <message>
        <source>the curves have too many intersections to work out</source>
        <translation>криві мають забагато перетинів, щоб їх обчислити</translation>
    </message>
    <message>
        <source>coordinates go from %1 to %2</source>
        <translation>координати йдуть від %1 до %2</translation>
    </message>
    <message>
        <source>more than %1 uses of elements are too many</source>
        <translation>понад %1 використань елементів — забагато</translation>
    </message>
    <message>
        <source>uses of elements are nested more than %1 deep</source>
        <translation>використання елементів вкладено глибше ніж %1</translation>
    </message>
    <message>
        <source>there is something behind the end of the outermost element</source>
        <translation>є щось після кінця найзовнішнього елемента</translation>
    </message>
    <message>
        <source>the attribute “%1” stands here twice</source>
        <translation>атрибут «%1» стоїть тут двічі</translation>
    </message>
    <message>
        <source>the entity “%1” is unknown</source>
        <translation>сутність «%1» невідома</translation>
    </message>
    <message>
        <source>this is no UTF-8, which the file says that it is</source>
        <translation>це не UTF-8, хоча файл стверджує, що це він</translation>
    </message>
    <message>
        <source>the attribute “%1” leads beyond the coordinates from %2 to %3</source>
        <translation>атрибут «%1» виводить за координати від %2 до %3</translation>
    </message>
    <message>
        <source>curve %1</source>
        <translation>крива %1</translation>
    </message>
    <message>
        <source>curve %1, “%2”</source>
        <translation>крива %1, «%2»</translation>
    </message>
    <message>
        <source>%1, the document inside</source>
        <translation>%1, документ усередині</translation>
    </message>
    <message>
        <source>a report takes at most %1 points of de Casteljau schemes of a sheet, and these are %2</source>
        <translation>звіт приймає щонайбільше %1 точок схем де Кастельжо аркуша, а їх %2</translation>
    </message>
    <message>
        <source>a report or a figure takes at most %1 pieces of the curves of a sheet, and these are %2</source>
        <translation>звіт або рисунок вміщує щонайбільше %1 частин кривих однієї вкладки, а їх %2</translation>
    </message>
    <message>
        <source>the encoding “%1” cannot be read</source>
        <translation>кодування «%1» не можна прочитати</translation>
    </message>
    <message>
        <source>“%1” is no character of XML</source>
        <translation>«%1» не є символом XML</translation>
    </message>
    <message>
        <source>%1: there is no file of this name, and one whose name is no UTF-8 cannot be opened</source>
        <translation>%1: файлу з такою назвою немає, а файл, назва якого не в UTF-8, не можна відкрити</translation>
    </message>
</context>
<context>
    <name>Examples</name>
    <message>
        <source>The polygon of degree 100 lies all but on the curve. Lower the degree with Page Down and watch the gap grow like 1/N.</source>
        <translation>Полігон степеня 100 майже збігається з кривою. Знижуйте степінь клавішею Page Down і стежте, як відстань зростає, мов 1/N.</translation>
    </message>
    <message>
        <source>Three rows of midpoints lead to the point (7/2, 3/2) of the curve. Move t: the last segment of the scheme stays tangent to the curve.</source>
        <translation>Три ряди середин відрізків ведуть до точки (7/2, 3/2) кривої. Змінюйте t: останній відрізок схеми весь час дотикається до кривої.</translation>
    </message>
    <message>
        <source>Each row of the scheme has a parameter of its own, and so the point lies off the curve. Make the three arguments equal: it falls on it.</source>
        <translation>Кожен рядок схеми має власний параметр, тому точка не лежить на кривій. Зробіть три аргументи рівними: вона потрапить на неї.</translation>
    </message>
    <message>
        <source>One polygon, whose inner points count once, twice and three times: the more often a point counts, the closer it draws the arc to itself.</source>
        <translation>Один полігон, внутрішні точки якого враховано один раз, двічі і тричі: що більша кратність точки, то ближче вона притягує дугу.</translation>
    </message>
    <message>
        <source>A closed chain of six cubics that crosses itself three times. Results names the segments and parameters of every crossing.</source>
        <translation>Замкнений ланцюг із шести кубічних кривих, що тричі перетинає сам себе. У результатах наведено сегменти й параметри кожного перетину.</translation>
    </message>
    <message>
        <source>The two arrows are the derivatives at the ends. Drag one: the whole chain follows, and every knot stays C2.</source>
        <translation>Дві стрілки – це похідні на кінцях. Потягніть одну: змінюється весь ланцюг, а кожен вузол зберігає C2.</translation>
    </message>
    <message>
        <source>On equally spaced points the interpolation of degree 10 swings out near the ends; the approximation of degree 6 does so far less.</source>
        <translation>На рівновіддалених точках інтерполяція степеня 10 сильно коливається біля кінців; апроксимація степеня 6 – значно менше.</translation>
    </message>
    <message>
        <source>The points turn back in x four times: five monotone runs, each a polynomial y(x), joined by Bézier curves.</source>
        <translation>Точки чотири рази змінюють напрямок за x: п’ять монотонних ділянок, кожна – поліном y(x), сполучені кривими Без’є.</translation>
    </message>
    <message>
        <source>Two curves of pairs pass through every point. Drag a middle point: only its own pair changes.</source>
        <translation>Дві криві з пар проходять через усі точки. Потягніть проміжну точку: змінюється лише її пара.</translation>
    </message>
</context>
<context>
    <name>FigureFile</name>
    <message>
        <source>the picture would have more than %1 pixels a side</source>
        <translation>зображення мало б понад %1 пікселів за сторону</translation>
    </message>
    <message>
        <source>TeX draws at most %1 mm a side; give the figure a width</source>
        <translation>TeX малює щонайбільше %1 мм за сторону; задайте ширину рисунка</translation>
    </message>
    <message>
        <source>the animation of the curve has no such frame</source>
        <translation>анімація кривої не має такого кадру</translation>
    </message>
</context>
<context>
    <name>Gestures</name>
    <message>
        <source>Tabs</source>
        <translation>Вкладки</translation>
    </message>
    <message>
        <source>Show a tab</source>
        <translation>Показати вкладку</translation>
    </message>
    <message>
        <source>Alt+1 … Alt+%1</source>
        <translation>Alt+1 … Alt+%1</translation>
    </message>
    <message>
        <source>Next tab</source>
        <translation>Наступна вкладка</translation>
    </message>
    <message>
        <source>Points, with the mouse</source>
        <translation>Точки, мишею</translation>
    </message>
    <message>
        <source>Select a point, or make a curve the active one</source>
        <translation>Вибрати точку або зробити криву активною</translation>
    </message>
    <message>
        <source>Click</source>
        <translation>Клацання</translation>
    </message>
    <message>
        <source>Select or deselect one more point</source>
        <translation>Вибрати ще одну точку або зняти її вибір</translation>
    </message>
    <message>
        <source>Shift+click</source>
        <translation>Shift+клацання</translation>
    </message>
    <message>
        <source>Select all points in a rectangle</source>
        <translation>Вибрати всі точки в прямокутнику</translation>
    </message>
    <message>
        <source>Drag on the empty canvas</source>
        <translation>Перетягування порожнім полотном</translation>
    </message>
    <message>
        <source>Add the points in a rectangle to the selection</source>
        <translation>Додати до вибору точки в прямокутнику</translation>
    </message>
    <message>
        <source>Shift+drag</source>
        <translation>Shift+перетягування</translation>
    </message>
    <message>
        <source>Take the points in a rectangle out of the selection</source>
        <translation>Зняти вибір точок у прямокутнику</translation>
    </message>
    <message>
        <source>Alt+drag or Ctrl+Shift+drag</source>
        <translation>Alt+перетягування або Ctrl+Shift+перетягування</translation>
    </message>
    <message>
        <source>Add a point at the end of the curve</source>
        <translation>Додати точку в кінці кривої</translation>
    </message>
    <message>
        <source>Alt+click, or double-click on the empty canvas</source>
        <translation>Alt+клацання або подвійне клацання на порожньому полотні</translation>
    </message>
    <message>
        <source>Insert a point and keep the shape</source>
        <translation>Вставити точку, зберігши форму</translation>
    </message>
    <message>
        <source>Double-click or Ctrl+Alt+click on the curve</source>
        <translation>Подвійне клацання або Ctrl+Alt+клацання на кривій</translation>
    </message>
    <message>
        <source>Remove a point and refit its neighbours</source>
        <translation>Вилучити точку й підлаштувати сусідні</translation>
    </message>
    <message>
        <source>Alt+click on the point</source>
        <translation>Alt+клацання на точці</translation>
    </message>
    <message>
        <source>Move a point or the selection</source>
        <translation>Посунути точку або вибране</translation>
    </message>
    <message>
        <source>Drag the point</source>
        <translation>Перетягування точки</translation>
    </message>
    <message>
        <source>Move along an axis</source>
        <translation>Посунути вздовж осі</translation>
    </message>
    <message>
        <source>Ctrl+drag</source>
        <translation>Ctrl+перетягування</translation>
    </message>
    <message>
        <source>Move without snapping</source>
        <translation>Посунути без прилипання</translation>
    </message>
    <message>
        <source>Shift, pressed during the drag</source>
        <translation>Shift, натиснутий під час перетягування</translation>
    </message>
    <message>
        <source>Mould the curve</source>
        <translation>Зігнути криву</translation>
    </message>
    <message>
        <source>Drag the curve</source>
        <translation>Перетягування кривої</translation>
    </message>
    <message>
        <source>What can be done here</source>
        <translation>Що тут можна зробити</translation>
    </message>
    <message>
        <source>Right-click</source>
        <translation>Клацання правою кнопкою</translation>
    </message>
    <message>
        <source>Add tool</source>
        <translation>Інструмент додавання</translation>
    </message>
    <message>
        <source>Add a point, or insert one on the curve</source>
        <translation>Додати точку або вставити її на кривій</translation>
    </message>
    <message>
        <source>Pull the handles of the new knot</source>
        <translation>Витягнути маркери нового вузла</translation>
    </message>
    <message>
        <source>Press and drag</source>
        <translation>Натискання й перетягування</translation>
    </message>
    <message>
        <source>Close the curve</source>
        <translation>Замкнути криву</translation>
    </message>
    <message>
        <source>Click on the first knot</source>
        <translation>Клацання на першому вузлі</translation>
    </message>
    <message>
        <source>End</source>
        <translation>Завершити</translation>
    </message>
    <message>
        <source>Enter or Esc</source>
        <translation>Enter або Esc</translation>
    </message>
    <message>
        <source>Handles and end derivatives</source>
        <translation>Маркери й похідні на кінцях</translation>
    </message>
    <message>
        <source>Turn in steps of 15°</source>
        <translation>Повернути кроками по 15°</translation>
    </message>
    <message>
        <source>Keep the angle</source>
        <translation>Зберегти кут</translation>
    </message>
    <message>
        <source>Ctrl+Alt+drag</source>
        <translation>Ctrl+Alt+перетягування</translation>
    </message>
    <message>
        <source>Leave the other handle where it is</source>
        <translation>Лишити інший маркер на місці</translation>
    </message>
    <message>
        <source>Alt, pressed during the drag</source>
        <translation>Alt, натиснутий під час перетягування</translation>
    </message>
    <message>
        <source>Carry the knot along</source>
        <translation>Рухати й вузол</translation>
    </message>
    <message>
        <source>Space, held during the drag</source>
        <translation>Пробіл, утримуваний під час перетягування</translation>
    </message>
    <message>
        <source>Retract the handle</source>
        <translation>Прибрати маркер</translation>
    </message>
    <message>
        <source>Ctrl+click</source>
        <translation>Ctrl+клацання</translation>
    </message>
    <message>
        <source>Keys on the canvas</source>
        <translation>Клавіші на полотні</translation>
    </message>
    <message>
        <source>Edit tool</source>
        <translation>Інструмент редагування</translation>
    </message>
    <message>
        <source>Fit the selection</source>
        <translation>Умістити вибране</translation>
    </message>
    <message>
        <source>Grid</source>
        <translation>Сітка</translation>
    </message>
    <message>
        <source>Next point</source>
        <translation>Наступна точка</translation>
    </message>
    <message>
        <source>Previous point</source>
        <translation>Попередня точка</translation>
    </message>
    <message>
        <source>Move the selection by a step of the grid</source>
        <translation>Посунути вибране на крок сітки</translation>
    </message>
    <message>
        <source>Arrow keys</source>
        <translation>Стрілки</translation>
    </message>
    <message>
        <source>Move the selection by ten steps</source>
        <translation>Посунути вибране на десять кроків</translation>
    </message>
    <message>
        <source>Shift+arrow keys</source>
        <translation>Shift+стрілки</translation>
    </message>
    <message>
        <source>Move the selection by a pixel</source>
        <translation>Посунути вибране на піксель</translation>
    </message>
    <message>
        <source>Alt+arrow keys</source>
        <translation>Alt+стрілки</translation>
    </message>
    <message>
        <source>Remove the selection and refit its neighbours</source>
        <translation>Вилучити вибране й підлаштувати сусідні точки</translation>
    </message>
    <message>
        <source>Delete or Backspace</source>
        <translation>Delete або Backspace</translation>
    </message>
    <message>
        <source>Remove the selection without refitting</source>
        <translation>Вилучити вибране без підлаштування</translation>
    </message>
    <message>
        <source>Take back the drag, end the tool, deselect, leave the canvas</source>
        <translation>Скасувати перетягування, завершити інструмент, зняти вибір, залишити полотно</translation>
    </message>
    <message>
        <source>View, with the mouse</source>
        <translation>Вигляд, мишею</translation>
    </message>
    <message>
        <source>Scroll</source>
        <translation>Прокрутити</translation>
    </message>
    <message>
        <source>Wheel</source>
        <translation>Коліщатко</translation>
    </message>
    <message>
        <source>Scroll sideways</source>
        <translation>Прокрутити вбік</translation>
    </message>
    <message>
        <source>Shift+wheel</source>
        <translation>Shift+коліщатко</translation>
    </message>
    <message>
        <source>Zoom at the pointer</source>
        <translation>Масштабувати біля вказівника</translation>
    </message>
    <message>
        <source>Ctrl+wheel</source>
        <translation>Ctrl+коліщатко</translation>
    </message>
    <message>
        <source>Move the sheet</source>
        <translation>Пересунути аркуш</translation>
    </message>
    <message>
        <source>Drag with the middle button or with Space</source>
        <translation>Перетягування середньою кнопкою або з пробілом</translation>
    </message>
    <message>
        <source>Player</source>
        <translation>Анімація</translation>
    </message>
    <message>
        <source>Play or pause</source>
        <translation>Відтворити або призупинити</translation>
    </message>
    <message>
        <source>One step back or forth</source>
        <translation>На етап назад або вперед</translation>
    </message>
    <message>
        <source>Left, Right</source>
        <translation>Стрілка ліворуч, праворуч</translation>
    </message>
</context>
<context>
    <name>Hint</name>
    <message>
        <source>Alt+click: remove the point</source>
        <translation>Alt+клацання: вилучає точку</translation>
    </message>
    <message>
        <source>Drag: move the point, Ctrl: along an axis   Alt+click: remove it</source>
        <translation>Перетягування: рухає точку, Ctrl: уздовж осі   Alt+клацання: вилучає її</translation>
    </message>
    <message>
        <source>Drag: mould the curve   Double-click: insert a point</source>
        <translation>Перетягування: згинає криву   Подвійне клацання: вставляє точку</translation>
    </message>
    <message>
        <source>Alt+click: add a point</source>
        <translation>Alt+клацання: додає точку</translation>
    </message>
    <message>
        <source>Double-click or Alt+click: add a point   Drag: select points   Ctrl+wheel: zoom</source>
        <translation>Подвійне клацання або Alt+клацання: додає точку   Перетягування: вибирає точки   Ctrl+коліщатко: масштаб</translation>
    </message>
    <message>
        <source>No point can be inserted here</source>
        <translation>Тут не можна вставити точку</translation>
    </message>
    <message>
        <source>This curve follows its points; drag them</source>
        <translation>Ця крива йде за своїми точками; перетягуйте їх</translation>
    </message>
    <message>
        <source>The shape changes by at most %1</source>
        <translation>Форма змінюється щонайбільше на %1</translation>
    </message>
    <message>
        <source>The degree falls to %1</source>
        <translation>Степінь знижується до %1</translation>
    </message>
    <message>
        <source>Click: close the curve   Drag: move the point   Esc: end</source>
        <translation>Клацання: замикає криву   Перетягування: рухає точку   Esc: кінець</translation>
    </message>
    <message>
        <source>Click: add a point   Drag: move the point   Esc: end</source>
        <translation>Клацання: додає точку   Перетягування: рухає точку   Esc: кінець</translation>
    </message>
    <message>
        <source>Ctrl+drag: move the point along an axis</source>
        <translation>Ctrl+перетягування: рухає точку вздовж осі</translation>
    </message>
    <message>
        <source>Shift+click: select or deselect the point</source>
        <translation>Shift+клацання: вибирає точку або знімає вибір</translation>
    </message>
    <message>
        <source>Ctrl+drag: steps of 15°   Ctrl+click: retract the handle</source>
        <translation>Ctrl+перетягування: кроки по 15°   Ctrl+клацання: прибирає маркер</translation>
    </message>
    <message>
        <source>Drag: move the handle, Ctrl: in steps of 15°   Ctrl+click: retract it</source>
        <translation>Перетягування: рухає маркер, Ctrl: кроками по 15°   Ctrl+клацання: прибирає його</translation>
    </message>
    <message>
        <source>Ctrl+drag: steps of 15°   Ctrl+click: back to the natural derivative</source>
        <translation>Ctrl+перетягування: кроки по 15°   Ctrl+клацання: назад до природної похідної</translation>
    </message>
    <message>
        <source>Drag: change the derivative, Ctrl: in steps of 15°   Ctrl+click: back to the natural one</source>
        <translation>Перетягування: змінює похідну, Ctrl: кроками по 15°   Ctrl+клацання: назад до природної</translation>
    </message>
    <message>
        <source>Drag: move the point, Ctrl: along an axis</source>
        <translation>Перетягування: рухає точку, Ctrl: уздовж осі</translation>
    </message>
    <message>
        <source>Ctrl+Alt+click: insert a point</source>
        <translation>Ctrl+Alt+клацання: вставляє точку</translation>
    </message>
    <message>
        <source>Click: insert a point   Drag: pull its handles   Esc: end</source>
        <translation>Клацання: вставляє точку   Перетягування: витягує її маркери   Esc: кінець</translation>
    </message>
    <message>
        <source>Click: insert a point   Drag: place it   Esc: end</source>
        <translation>Клацання: вставляє точку   Перетягування: розташовує її   Esc: кінець</translation>
    </message>
    <message>
        <source>Alt+click: add a point   Alt+drag: deselect points</source>
        <translation>Alt+клацання: додає точку   Alt+перетягування: знімає вибір точок</translation>
    </message>
    <message>
        <source>Shift+drag: select more points</source>
        <translation>Shift+перетягування: вибирає ще точки</translation>
    </message>
    <message>
        <source>Ctrl+Shift+drag: deselect points</source>
        <translation>Ctrl+Shift+перетягування: знімає вибір точок</translation>
    </message>
    <message>
        <source>Click: add a point   Drag: pull its handles   Esc: end</source>
        <translation>Клацання: додає точку   Перетягування: витягує її маркери   Esc: кінець</translation>
    </message>
    <message>
        <source>Click: add a point   Drag: place it   Esc: end</source>
        <translation>Клацання: додає точку   Перетягування: розташовує її   Esc: кінець</translation>
    </message>
    <message>
        <source>Space: the knot goes along</source>
        <translation>Пробіл: вузол рухається разом із маркером</translation>
    </message>
    <message>
        <source>Ctrl+Alt: the handle keeps its angle</source>
        <translation>Ctrl+Alt: маркер зберігає свій кут</translation>
    </message>
    <message>
        <source>Ctrl: steps of 15°</source>
        <translation>Ctrl: кроки по 15°</translation>
    </message>
    <message>
        <source>Alt: the other handle stays</source>
        <translation>Alt: інший маркер лишається на місці</translation>
    </message>
    <message>
        <source>Ctrl: steps of 15°   Ctrl+Alt: keep the angle   Alt: leave the other handle   Space: carry the knot</source>
        <translation>Ctrl: кроки по 15°   Ctrl+Alt: зберігає кут   Alt: лишає інший маркер   Пробіл: рухає й вузол</translation>
    </message>
    <message>
        <source>Click: how this point is worked out, in Tables</source>
        <translation>Клацання: як обчислено цю точку, у «Таблицях»</translation>
    </message>
    <message>
        <source>The shape stays as it is</source>
        <translation>Форма не змінюється</translation>
    </message>
</context>
<context>
    <name>Menus</name>
    <message>
        <source>A cubic raised 97 times</source>
        <translation>Кубічна крива, підвищена 97 разів</translation>
    </message>
    <message>
        <source>De Casteljau at t = 1/2</source>
        <translation>Де Кастельжо при t = 1/2</translation>
    </message>
    <message>
        <source>The blossom b[t₁, t₂, t₃]</source>
        <translation>Полярна форма b[t₁, t₂, t₃]</translation>
    </message>
    <message>
        <source>An arc with double and triple points</source>
        <translation>Дуга з подвійними і потрійними точками</translation>
    </message>
    <message>
        <source>A chain with three self-intersections</source>
        <translation>Ланцюг із трьома самоперетинами</translation>
    </message>
    <message>
        <source>A clamped cubic spline</source>
        <translation>Затиснутий кубічний сплайн</translation>
    </message>
    <message>
        <source>Runge&apos;s function</source>
        <translation>Функція Рунге</translation>
    </message>
    <message>
        <source>A curve with five monotone runs</source>
        <translation>Крива з п’ятьма монотонними ділянками</translation>
    </message>
    <message>
        <source>The outline of a leaf</source>
        <translation>Обрис листка</translation>
    </message>
    <message>
        <source>&amp;File</source>
        <translation>&amp;Файл</translation>
    </message>
    <message>
        <source>Open &amp;recent</source>
        <translation>Відкрити не&amp;давні</translation>
    </message>
    <message>
        <source>&amp;Edit</source>
        <translation>&amp;Зміни</translation>
    </message>
    <message>
        <source>&amp;Curve</source>
        <translation>&amp;Крива</translation>
    </message>
    <message>
        <source>&amp;View</source>
        <translation>&amp;Вигляд</translation>
    </message>
    <message>
        <source>&amp;Panels</source>
        <translation>&amp;Панелі</translation>
    </message>
    <message>
        <source>&amp;Settings</source>
        <translation>П&amp;араметри</translation>
    </message>
    <message>
        <source>&amp;Language</source>
        <translation>&amp;Мова</translation>
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
        <translation>Св&amp;ітла</translation>
    </message>
    <message>
        <source>&amp;Dark</source>
        <translation>&amp;Темна</translation>
    </message>
    <message>
        <source>&amp;Help</source>
        <translation>&amp;Довідка</translation>
    </message>
    <message>
        <source>Exa&amp;mples</source>
        <translation>При&amp;клади</translation>
    </message>
    <message>
        <source>Tool bar</source>
        <translation>Панель інструментів</translation>
    </message>
    <message>
        <source>Use these &amp;points in</source>
        <translation>Використати ці &amp;точки у вкладці</translation>
    </message>
</context>
<context>
    <name>PointColumn</name>
    <message>
        <source>Join</source>
        <translation>Сполучення</translation>
    </message>
    <message>
        <source>Multiplicity</source>
        <translation>Кратність</translation>
    </message>
    <message>
        <source>One of these is needed: %1.</source>
        <translation>Потрібне одне з цього: %1.</translation>
    </message>
</context>
<context>
    <name>PointsImport</name>
    <message>
        <source>Import points</source>
        <translation>Імпорт точок</translation>
    </message>
    <message>
        <source>Paths and points (*.svg *.csv *.tsv *.txt);;All files (*)</source>
        <translation>Контури й точки (*.svg *.csv *.tsv *.txt);;Усі файли (*)</translation>
    </message>
    <message>
        <source>Nothing was imported</source>
        <translation>Нічого не імпортовано</translation>
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
        <translation>Апроксимація</translation>
    </message>
    <message>
        <source>Interpolation</source>
        <translation>Інтерполяція</translation>
    </message>
    <message>
        <source>Pairs</source>
        <translation>Пари</translation>
    </message>
    <message>
        <source>Degree</source>
        <translation>Степінь</translation>
    </message>
    <message>
        <source>Basis</source>
        <translation>Базис</translation>
    </message>
    <message>
        <source>Power basis</source>
        <translation>Степеневий базис</translation>
    </message>
    <message>
        <source>Newton basis</source>
        <translation>Базис Ньютона</translation>
    </message>
    <message>
        <source>Lagrange basis</source>
        <translation>Базис Лагранжа</translation>
    </message>
    <message>
        <source>Chebyshev basis</source>
        <translation>Базис Чебишова</translation>
    </message>
    <message>
        <source>Corrected pairs</source>
        <translation>Скориговані пари</translation>
    </message>
    <message>
        <source>Animation</source>
        <translation>Анімація</translation>
    </message>
    <message>
        <source>Rule</source>
        <translation>Правило</translation>
    </message>
    <message>
        <source>Mirror</source>
        <translation>Дзеркальне</translation>
    </message>
    <message>
        <source>Natural</source>
        <translation>Природний</translation>
    </message>
    <message>
        <source>Clamped</source>
        <translation>Затиснутий</translation>
    </message>
    <message>
        <source>Catmull–Rom</source>
        <translation>Катмулла–Рома</translation>
    </message>
    <message>
        <source>Selected knots</source>
        <translation>Вибрані вузли</translation>
    </message>
    <message>
        <source>Join</source>
        <translation>Сполучення</translation>
    </message>
    <message>
        <source>End derivatives</source>
        <translation>Похідні на кінцях</translation>
    </message>
    <message>
        <source>Start</source>
        <translation>Початок</translation>
    </message>
    <message>
        <source>End</source>
        <translation>Кінець</translation>
    </message>
    <message>
        <source>Automatic</source>
        <translation>Автоматичний</translation>
    </message>
    <message>
        <source>Symmetric</source>
        <translation>Симетричний</translation>
    </message>
    <message>
        <source>Smooth</source>
        <translation>Гладкий</translation>
    </message>
    <message>
        <source>Corner</source>
        <translation>Кутовий</translation>
    </message>
    <message>
        <source>Parameter t</source>
        <translation>Параметр t</translation>
    </message>
    <message>
        <source>Levels</source>
        <translation>Рівні</translation>
    </message>
    <message>
        <source>Multiplicity of the selected point</source>
        <translation>Кратність вибраної точки</translation>
    </message>
    <message>
        <source>Blossom</source>
        <translation>Полярна форма</translation>
    </message>
    <message>
        <source>Arguments</source>
        <translation>Аргументи</translation>
    </message>
    <message>
        <source>Runs over</source>
        <translation>Іде за</translation>
    </message>
    <message>
        <source>The algorithm step by step</source>
        <translation>Алгоритм крок за кроком</translation>
    </message>
    <message>
        <source>Curvature comb</source>
        <translation>Гребінь кривини</translation>
    </message>
    <message>
        <source>Scale of the comb</source>
        <translation>Масштаб гребеня</translation>
    </message>
    <message>
        <source>Further t</source>
        <translation>Інші t</translation>
    </message>
    <message>
        <source>Make this the control polygon</source>
        <translation>Зробити контрольним полігоном</translation>
    </message>
    <message>
        <source>Reduce the degree by one</source>
        <translation>Знизити степінь на одиницю</translation>
    </message>
    <message>
        <source>Comparison with the built-in drawing</source>
        <translation>Порівняння із вбудованим малюванням</translation>
    </message>
    <message>
        <source>Points per segment</source>
        <translation>Точок на сегмент</translation>
    </message>
    <message>
        <source>Largest deviation</source>
        <translation>Найбільше відхилення</translation>
    </message>
    <message>
        <source>Split here</source>
        <translation>Розділити тут</translation>
    </message>
</context>
<context>
    <name>Sheet</name>
    <message>
        <source>Combined</source>
        <translation>Комбінований</translation>
    </message>
    <message>
        <source>Elevation</source>
        <translation>Підвищення</translation>
    </message>
    <message>
        <source>Spline</source>
        <translation>Сплайн</translation>
    </message>
    <message>
        <source>Subdivision</source>
        <translation>Підрозбиття</translation>
    </message>
</context>
<context>
    <name>SheetActions</name>
    <message>
        <source>Raise the degree</source>
        <translation>Підвищити степінь</translation>
    </message>
    <message>
        <source>Lower the degree</source>
        <translation>Зниження степеня</translation>
    </message>
    <message>
        <source>Elevate once more</source>
        <translation>На одне підвищення більше</translation>
    </message>
    <message>
        <source>Elevate once less</source>
        <translation>На одне підвищення менше</translation>
    </message>
    <message>
        <source>Closed</source>
        <translation>Замкнена</translation>
    </message>
    <message>
        <source>Corner</source>
        <translation>Кутовий</translation>
    </message>
    <message>
        <source>Smooth</source>
        <translation>Гладкий</translation>
    </message>
    <message>
        <source>Symmetric</source>
        <translation>Симетричний</translation>
    </message>
    <message>
        <source>Automatic</source>
        <translation>Автоматичний</translation>
    </message>
    <message>
        <source>Align handles</source>
        <translation>Вирівняти маркери</translation>
    </message>
    <message>
        <source>Equalize handles</source>
        <translation>Зрівняти маркери</translation>
    </message>
    <message>
        <source>Pull out handles</source>
        <translation>Витягнути маркери</translation>
    </message>
    <message>
        <source>Retract handles</source>
        <translation>Прибрати маркери</translation>
    </message>
    <message>
        <source>One level more</source>
        <translation>На рівень більше</translation>
    </message>
    <message>
        <source>One level fewer</source>
        <translation>На рівень менше</translation>
    </message>
    <message>
        <source>Make the elevated polygon the control polygon</source>
        <translation>Зробити полігон підвищеного степеня контрольним</translation>
    </message>
    <message>
        <source>Split here, at t</source>
        <translation>Розділити тут, при t</translation>
    </message>
</context>
<context>
    <name>SheetPanels</name>
    <message>
        <source>Curves</source>
        <translation>Криві</translation>
    </message>
    <message>
        <source>Points</source>
        <translation>Точки</translation>
    </message>
    <message>
        <source>Layers</source>
        <translation>Шари</translation>
    </message>
    <message>
        <source>Properties</source>
        <translation>Властивості</translation>
    </message>
    <message>
        <source>Results</source>
        <translation>Результати</translation>
    </message>
    <message>
        <source>History</source>
        <translation>Історія</translation>
    </message>
    <message>
        <source>Plots</source>
        <translation>Графіки</translation>
    </message>
    <message>
        <source>Tables</source>
        <translation>Таблиці</translation>
    </message>
    <message>
        <source>Guide</source>
        <translation>Посібник</translation>
    </message>
</context>
<context>
    <name>Step</name>
    <message>
        <source>Set the method</source>
        <translation>Зміна методу</translation>
    </message>
    <message>
        <source>Set the degree</source>
        <translation>Зміна степеня</translation>
    </message>
    <message>
        <source>Set the basis</source>
        <translation>Зміна базису</translation>
    </message>
    <message>
        <source>Back to automatic</source>
        <translation>Назад до автоматичного</translation>
    </message>
    <message>
        <source>Raise the degree</source>
        <translation>Підвищення степеня</translation>
    </message>
    <message>
        <source>Keep the stage</source>
        <translation>Збереження етапу</translation>
    </message>
    <message>
        <source>Add a point</source>
        <translation>Додавання точки</translation>
    </message>
    <message>
        <source>Insert a point</source>
        <translation>Вставлення точки</translation>
    </message>
    <message>
        <source>Remove point %1</source>
        <translation>Вилучення точки %1</translation>
    </message>
    <message>
        <source>Remove points</source>
        <translation>Вилучення точок</translation>
    </message>
    <message>
        <source>Nudge</source>
        <translation>Зсув на крок</translation>
    </message>
    <message>
        <source>Reverse the curve</source>
        <translation>Обернення кривої</translation>
    </message>
    <message>
        <source>New curve</source>
        <translation>Нова крива</translation>
    </message>
    <message>
        <source>Duplicate the curve</source>
        <translation>Дублювання кривої</translation>
    </message>
    <message>
        <source>Delete the curve</source>
        <translation>Вилучення кривої</translation>
    </message>
    <message>
        <source>Rename the curve</source>
        <translation>Перейменування кривої</translation>
    </message>
    <message>
        <source>Colour the curve</source>
        <translation>Зміна кольору кривої</translation>
    </message>
    <message>
        <source>Reorder the curves</source>
        <translation>Зміна порядку кривих</translation>
    </message>
    <message>
        <source>Clear the canvas</source>
        <translation>Очищення полотна</translation>
    </message>
    <message>
        <source>Move points</source>
        <translation>Переміщення точок</translation>
    </message>
    <message>
        <source>Mould the curve</source>
        <translation>Згинання кривої</translation>
    </message>
    <message>
        <source>Move point %1</source>
        <translation>Переміщення точки %1</translation>
    </message>
    <message>
        <source>Move a handle of knot %1</source>
        <translation>Переміщення маркера вузла %1</translation>
    </message>
    <message>
        <source>Move an inner point of segment %1</source>
        <translation>Переміщення внутрішньої точки сегмента %1</translation>
    </message>
    <message>
        <source>Move the middle point of pair %1</source>
        <translation>Переміщення проміжної точки пари %1</translation>
    </message>
    <message>
        <source>Change the start derivative</source>
        <translation>Зміна початкової похідної</translation>
    </message>
    <message>
        <source>Change the end derivative</source>
        <translation>Зміна кінцевої похідної</translation>
    </message>
    <message>
        <source>Set the rule</source>
        <translation>Зміна правила</translation>
    </message>
    <message>
        <source>Close the curve</source>
        <translation>Замикання кривої</translation>
    </message>
    <message>
        <source>Open the curve</source>
        <translation>Розмикання кривої</translation>
    </message>
    <message>
        <source>Set the join</source>
        <translation>Зміна сполучення</translation>
    </message>
    <message>
        <source>Set the parameter t</source>
        <translation>Зміна параметра t</translation>
    </message>
    <message>
        <source>Set the levels</source>
        <translation>Зміна рівнів</translation>
    </message>
    <message>
        <source>Set the multiplicity</source>
        <translation>Зміна кратності</translation>
    </message>
    <message>
        <source>Show the blossom</source>
        <translation>Показ полярної форми</translation>
    </message>
    <message>
        <source>Hide the blossom</source>
        <translation>Приховування полярної форми</translation>
    </message>
    <message>
        <source>Set the blossom</source>
        <translation>Зміна полярної форми</translation>
    </message>
    <message>
        <source>Cut the curve</source>
        <translation>Вирізання кривої</translation>
    </message>
    <message>
        <source>Cut points</source>
        <translation>Вирізання точок</translation>
    </message>
    <message>
        <source>Paste points</source>
        <translation>Вставлення точок</translation>
    </message>
    <message>
        <source>Paste the curve</source>
        <translation>Вставлення кривої</translation>
    </message>
    <message>
        <source>Duplicate points</source>
        <translation>Дублювання точок</translation>
    </message>
    <message>
        <source>Set the width of the line</source>
        <translation>Зміна товщини лінії</translation>
    </message>
    <message>
        <source>Set the dashes of the line</source>
        <translation>Зміна типу лінії</translation>
    </message>
    <message>
        <source>Set the marks of the points</source>
        <translation>Зміна знаків точок</translation>
    </message>
    <message>
        <source>Show the labels</source>
        <translation>Показ позначень</translation>
    </message>
    <message>
        <source>Hide the labels</source>
        <translation>Приховання позначень</translation>
    </message>
    <message>
        <source>Reset the style</source>
        <translation>Скидання стилю</translation>
    </message>
    <message>
        <source>Use the points of a tab</source>
        <translation>Використання точок з іншої вкладки</translation>
    </message>
    <message>
        <source>Retract a handle of knot %1</source>
        <translation>Прибирання маркера вузла %1</translation>
    </message>
    <message>
        <source>Retract the handles</source>
        <translation>Прибирання маркерів</translation>
    </message>
    <message>
        <source>Align the handles</source>
        <translation>Вирівнювання маркерів</translation>
    </message>
    <message>
        <source>Equalize the handles</source>
        <translation>Зрівнювання маркерів</translation>
    </message>
    <message>
        <source>Pull out the handles</source>
        <translation>Витягування маркерів</translation>
    </message>
    <message>
        <source>Take the elevated polygon over</source>
        <translation>Прийняття полігона підвищеного степеня</translation>
    </message>
    <message>
        <source>Reduce the degree</source>
        <translation>Зниження степеня</translation>
    </message>
    <message>
        <source>Split the curve</source>
        <translation>Розділення кривої</translation>
    </message>
    <message>
        <source>Paste curves</source>
        <translation>Вставлення кривих</translation>
    </message>
    <message>
        <source>Import curves</source>
        <translation>Імпорт кривих</translation>
    </message>
</context>
<context>
    <name>StyleEditor</name>
    <message>
        <source>Solid</source>
        <translation>Суцільна</translation>
    </message>
    <message>
        <source>Dashed</source>
        <translation>Штрихова</translation>
    </message>
    <message>
        <source>Dotted</source>
        <translation>Пунктирна</translation>
    </message>
    <message>
        <source>Dash-dot</source>
        <translation>Штрихпунктирна</translation>
    </message>
    <message>
        <source>As usual</source>
        <translation>Звичайні</translation>
    </message>
    <message>
        <source>None</source>
        <translation>Немає</translation>
    </message>
    <message>
        <source>Circles</source>
        <translation>Кружки</translation>
    </message>
    <message>
        <source>Squares</source>
        <translation>Квадратики</translation>
    </message>
    <message>
        <source>Diamonds</source>
        <translation>Ромби</translation>
    </message>
</context>
<context>
    <name>TableErrors</name>
    <message>
        <source>there are no points</source>
        <translation>немає точок</translation>
    </message>
    <message>
        <source>more than %1 points are too many</source>
        <translation>понад %1 точок — забагато</translation>
    </message>
    <message>
        <source>expected two numbers</source>
        <translation>очікувалося два числа</translation>
    </message>
    <message>
        <source>“%1” is no number</source>
        <translation>«%1» — не число</translation>
    </message>
    <message>
        <source>“%1” is not from %2 to %3</source>
        <translation>«%1» не в межах від %2 до %3</translation>
    </message>
    <message>
        <source>“%1” has another decimal sign than the numbers before it</source>
        <translation>«%1» має інший десятковий знак, ніж числа перед ним</translation>
    </message>
    <message>
        <source>line %1, column %2</source>
        <translation>рядок %1, стовпець %2</translation>
    </message>
    <message>
        <source>a curve takes at most %1 points</source>
        <translation>крива вміщує щонайбільше %1 точок</translation>
    </message>
</context>
<context>
    <name>Values</name>
    <message>
        <source>more than %L1</source>
        <translation>більше ніж %L1</translation>
    </message>
</context>
<context>
    <name>kriva::ui::AboutDialog</name>
    <message>
        <source>About Kriva</source>
        <translation>Про Kriva</translation>
    </message>
    <message>
        <source>A workbench for Bézier curves.</source>
        <translation>Майстерня кривих Без’є.</translation>
    </message>
    <message>
        <source>Free software under the MIT licence.</source>
        <translation>Вільна програма за ліцензією MIT.</translation>
    </message>
    <message>
        <source>Built on %1 (LGPL, dynamically linked), Eigen, JSON for Modern C++ and pugixml.</source>
        <translation>Побудовано на %1 (LGPL, динамічно приєднано), Eigen, JSON for Modern C++ і pugixml.</translation>
    </message>
</context>
<context>
    <name>kriva::ui::CanvasView</name>
    <message>
        <source>Canvas</source>
        <translation>Полотно</translation>
    </message>
</context>
<context>
    <name>kriva::ui::CombinedProperties</name>
    <message>
        <source>Back to automatic</source>
        <translation>Назад до автоматичного</translation>
    </message>
    <message>
        <source>Puts the selected middle points, or all where none is selected, where the tangents meet</source>
        <translation>Ставить вибрані проміжні точки, або всі, якщо не вибрано жодної, туди, де перетинаються дотичні</translation>
    </message>
    <message>
        <source>1 of 5: the given points</source>
        <translation>1 з 5: опорні точки</translation>
    </message>
    <message>
        <source>2 of 5: monotone runs</source>
        <translation>2 з 5: монотонні ділянки</translation>
    </message>
    <message>
        <source>3 of 5: a polynomial for each run</source>
        <translation>3 з 5: многочлен для кожної ділянки</translation>
    </message>
    <message>
        <source>4 of 5: joins between the runs</source>
        <translation>4 з 5: сполучення між ділянками</translation>
    </message>
    <message>
        <source>5 of 5: the whole curve</source>
        <translation>5 з 5: уся крива</translation>
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
        <translation>Дублювати криву</translation>
    </message>
    <message>
        <source>Delete the curve</source>
        <translation>Вилучити криву</translation>
    </message>
    <message>
        <source>Move the curve up</source>
        <translation>Посунути криву вгору</translation>
    </message>
    <message>
        <source>Move the curve down</source>
        <translation>Посунути криву вниз</translation>
    </message>
    <message>
        <source>Colour of the curve</source>
        <translation>Колір кривої</translation>
    </message>
    <message>
        <source>Curves</source>
        <translation>Криві</translation>
    </message>
    <message>
        <source>Style of the curve</source>
        <translation>Стиль кривої</translation>
    </message>
</context>
<context>
    <name>kriva::ui::DocumentSession</name>
    <message>
        <source>Untitled</source>
        <translation>Без назви</translation>
    </message>
    <message>
        <source>Open</source>
        <translation>Відкриття</translation>
    </message>
    <message>
        <source>Documents and figures of Kriva (*.kriva *.svg)</source>
        <translation>Документи й рисунки Kriva (*.kriva *.svg)</translation>
    </message>
    <message>
        <source>Save as</source>
        <translation>Збереження як</translation>
    </message>
    <message>
        <source>Documents of Kriva (*.kriva)</source>
        <translation>Документи Kriva (*.kriva)</translation>
    </message>
    <message>
        <source>Unsaved changes cannot be kept for a recovery: %1</source>
        <translation>Незбережені зміни не вдається зберігати для відновлення: %1</translation>
    </message>
</context>
<context>
    <name>kriva::ui::ElevationProperties</name>
    <message>
        <source>The curve then moves by at most %1</source>
        <translation>Крива при цьому зсувається щонайбільше на %1</translation>
    </message>
    <message>
        <source>The degree cannot fall any more</source>
        <translation>Степінь більше не можна знизити</translation>
    </message>
    <message>
        <source>The curve then stays as it is</source>
        <translation>Крива при цьому не змінюється</translation>
    </message>
</context>
<context>
    <name>kriva::ui::ExportDialog</name>
    <message>
        <source>Export figure</source>
        <translation>Експорт рисунка</translation>
    </message>
    <message>
        <source>SVG figure</source>
        <translation>Рисунок SVG</translation>
    </message>
    <message>
        <source>PDF page</source>
        <translation>Сторінка PDF</translation>
    </message>
    <message>
        <source>PNG picture</source>
        <translation>Зображення PNG</translation>
    </message>
    <message>
        <source>TikZ for LaTeX</source>
        <translation>TikZ для LaTeX</translation>
    </message>
    <message>
        <source>CSV of the points</source>
        <translation>CSV з точками</translation>
    </message>
    <message>
        <source>Light</source>
        <translation>Світлі</translation>
    </message>
    <message>
        <source>Dark</source>
        <translation>Темні</translation>
    </message>
    <message>
        <source>&amp;Format</source>
        <translation>&amp;Формат</translation>
    </message>
    <message>
        <source>&amp;Margin (mm)</source>
        <translation>&amp;Поле (мм)</translation>
    </message>
    <message>
        <source>Page</source>
        <translation>Сторінка</translation>
    </message>
    <message>
        <source>&amp;Colours</source>
        <translation>&amp;Кольори</translation>
    </message>
    <message>
        <source>La&amp;yers</source>
        <translation>Ша&amp;ри</translation>
    </message>
    <message>
        <source>D&amp;ecimals</source>
        <translation>&amp;Десяткові знаки</translation>
    </message>
    <message>
        <source>&amp;Dots per inch</source>
        <translation>&amp;Точок на дюйм</translation>
    </message>
    <message>
        <source>Text&amp;s in the figure</source>
        <translation>&amp;Написи на рисунку</translation>
    </message>
    <message>
        <source>Layers for &amp;Inkscape</source>
        <translation>Шари для &amp;Inkscape</translation>
    </message>
    <message>
        <source>&amp;Round coordinates</source>
        <translation>Округлити координ&amp;ати</translation>
    </message>
    <message>
        <source>&amp;Transparent</source>
        <translation>Про&amp;зора</translation>
    </message>
    <message>
        <source>A &amp;part for another document</source>
        <translation>&amp;Частина для іншого документа</translation>
    </message>
    <message>
        <source>The figure as it will be</source>
        <translation>Рисунок, яким він буде</translation>
    </message>
    <message>
        <source>%1 × %2 mm</source>
        <translation>%1 × %2 мм</translation>
    </message>
    <message>
        <source>The document &amp;goes along, to open the file again</source>
        <translation>Документ &amp;йде разом, щоб відкрити файл знову</translation>
    </message>
    <message>
        <source>E&amp;xport…</source>
        <translation>&amp;Експортувати…</translation>
    </message>
    <message>
        <source>Fra&amp;mes</source>
        <translation>Кадр&amp;и</translation>
    </message>
    <message>
        <source>Seconds of &amp;a frame</source>
        <translation>&amp;Секунд на кадр</translation>
    </message>
    <message>
        <source>0; 5; 10 or 0..10 or t = 0.25; 0.5</source>
        <translation>0; 5; 10 або 0..10 або t = 0,25; 0,5</translation>
    </message>
    <message>
        <source>A&amp;nimated</source>
        <translation>Ані&amp;мований</translation>
    </message>
    <message>
        <source>O&amp;utlines in place of letters</source>
        <translation>Конт&amp;ури замість літер</translation>
    </message>
    <message>
        <source>Scale (mm for a unit)</source>
        <translation>Масштаб (мм на одиницю)</translation>
    </message>
    <message>
        <source>Width (mm)</source>
        <translation>Ширина (мм)</translation>
    </message>
    <message>
        <source>Set the &amp;width</source>
        <translation>Задати &amp;ширину</translation>
    </message>
    <message>
        <source>Set the scale</source>
        <translation>Задати масштаб</translation>
    </message>
</context>
<context>
    <name>kriva::ui::FigureExport</name>
    <message>
        <source>The figure was not written</source>
        <translation>Рисунок не записано</translation>
    </message>
    <message>
        <source>Export figure</source>
        <translation>Експорт рисунка</translation>
    </message>
    <message>
        <source>Figures (%1)</source>
        <translation>Рисунки (%1)</translation>
    </message>
    <message>
        <source>Written: %1</source>
        <translation>Записано: %1</translation>
    </message>
    <message>
        <source>Print</source>
        <translation>Друк</translation>
    </message>
    <message>
        <source>Working out the figure…</source>
        <translation>Обчислюється рисунок…</translation>
    </message>
</context>
<context>
    <name>kriva::ui::FramesField</name>
    <message numerus="yes">
        <source>At most %n frame(s): stages, such as 0; 5 or 0..10, or values of t, such as t = 0.25; 0.5.</source>
        <translation>
            <numerusform>Щонайбільше %n кадр: етапи, наприклад 0; 5 або 0..10, або значення t, наприклад t = 0,25; 0,5.</numerusform>
            <numerusform>Щонайбільше %n кадри: етапи, наприклад 0; 5 або 0..10, або значення t, наприклад t = 0,25; 0,5.</numerusform>
            <numerusform>Щонайбільше %n кадрів: етапи, наприклад 0; 5 або 0..10, або значення t, наприклад t = 0,25; 0,5.</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>kriva::ui::GuidePanel</name>
    <message>
        <source>Guide</source>
        <translation>Посібник</translation>
    </message>
</context>
<context>
    <name>kriva::ui::HistoryPanel</name>
    <message>
        <source>History</source>
        <translation>Історія</translation>
    </message>
    <message>
        <source>Beginning</source>
        <translation>Початок</translation>
    </message>
</context>
<context>
    <name>kriva::ui::ImportDialog</name>
    <message>
        <source>Import points</source>
        <translation>Імпорт точок</translation>
    </message>
    <message>
        <source>&amp;Curves</source>
        <translation>&amp;Криві</translation>
    </message>
    <message>
        <source>Curves</source>
        <translation>Криві</translation>
    </message>
    <message>
        <source>&amp;Scale</source>
        <translation>&amp;Масштаб</translation>
    </message>
    <message>
        <source>Move by &amp;x</source>
        <translation>Зсув по &amp;x</translation>
    </message>
    <message>
        <source>Move by &amp;y</source>
        <translation>Зсув по &amp;y</translation>
    </message>
    <message>
        <source>The curves as they will be</source>
        <translation>Криві, якими вони будуть</translation>
    </message>
    <message>
        <source>&amp;Import</source>
        <translation>&amp;Імпортувати</translation>
    </message>
    <message numerus="yes">
        <source>%n point(s)</source>
        <translation>
            <numerusform>%n точка</numerusform>
            <numerusform>%n точки</numerusform>
            <numerusform>%n точок</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>kriva::ui::LayersPanel</name>
    <message>
        <source>Layers</source>
        <translation>Шари</translation>
    </message>
</context>
<context>
    <name>kriva::ui::MainWindow</name>
    <message>
        <source>&amp;Undo: %1</source>
        <translation>&amp;Скасувати: %1</translation>
    </message>
    <message>
        <source>&amp;Undo</source>
        <translation>&amp;Скасувати</translation>
    </message>
    <message>
        <source>&amp;Redo: %1</source>
        <translation>&amp;Повторити: %1</translation>
    </message>
    <message>
        <source>&amp;Redo</source>
        <translation>&amp;Повторити</translation>
    </message>
    <message>
        <source>Sheets</source>
        <translation>Аркуші</translation>
    </message>
</context>
<context>
    <name>kriva::ui::NoticeBar</name>
    <message>
        <source>The file “%1” was deleted or moved by another program.</source>
        <translation>Файл «%1» вилучила або перемістила інша програма.</translation>
    </message>
    <message>
        <source>Another program changed the file “%1”.</source>
        <translation>Інша програма змінила файл «%1».</translation>
    </message>
    <message>
        <source>Save again</source>
        <translation>Зберегти знову</translation>
    </message>
    <message>
        <source>Reload</source>
        <translation>Перезавантажити</translation>
    </message>
    <message>
        <source>Leave as it is</source>
        <translation>Залишити так</translation>
    </message>
</context>
<context>
    <name>kriva::ui::NumberField</name>
    <message>
        <source>A whole number from %1 to %2 is needed.</source>
        <translation>Потрібне ціле число від %1 до %2.</translation>
    </message>
    <message>
        <source>A number above %1 and below %2 is needed.</source>
        <translation>Потрібне число більше за %1 і менше за %2.</translation>
    </message>
    <message>
        <source>A number from %1 to %2 is needed.</source>
        <translation>Потрібне число від %1 до %2.</translation>
    </message>
</context>
<context>
    <name>kriva::ui::NumberListField</name>
    <message numerus="yes">
        <source>%n number(s) from %1 to %2, with semicolons between them.</source>
        <translation>
            <numerusform>%n число від %1 до %2, розділені крапкою з комою.</numerusform>
            <numerusform>%n числа від %1 до %2, розділені крапкою з комою.</numerusform>
            <numerusform>%n чисел від %1 до %2, розділені крапкою з комою.</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>At most %n number(s) above %1 and below %2, with semicolons between them.</source>
        <translation>
            <numerusform>Щонайбільше %n число понад %1 і менше %2, між числами крапка з комою.</numerusform>
            <numerusform>Щонайбільше %n числа понад %1 і менше %2, між числами крапка з комою.</numerusform>
            <numerusform>Щонайбільше %n чисел понад %1 і менше %2, між числами крапка з комою.</numerusform>
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
        <translation>На етап назад</translation>
    </message>
    <message>
        <source>One stage on</source>
        <translation>На етап уперед</translation>
    </message>
    <message>
        <source>Pause</source>
        <translation>Пауза</translation>
    </message>
    <message>
        <source>Play</source>
        <translation>Відтворити</translation>
    </message>
    <message>
        <source>Slower</source>
        <translation>Повільніше</translation>
    </message>
    <message>
        <source>Faster</source>
        <translation>Швидше</translation>
    </message>
    <message>
        <source>Over and over</source>
        <translation>Знову і знову</translation>
    </message>
    <message>
        <source>Direction of the animation: forwards</source>
        <translation>Напрямок анімації: уперед</translation>
    </message>
    <message>
        <source>Direction of the animation: backwards</source>
        <translation>Напрямок анімації: назад</translation>
    </message>
    <message>
        <source>Direction of the animation: to and fro</source>
        <translation>Напрямок анімації: туди й назад</translation>
    </message>
    <message>
        <source>Animation speed</source>
        <translation>Швидкість анімації</translation>
    </message>
    <message>
        <source>Stage</source>
        <translation>Етап</translation>
    </message>
    <message>
        <source>Keep this stage</source>
        <translation>Зберегти цей етап</translation>
    </message>
    <message>
        <source>Writes the stage on view into the document</source>
        <translation>Записує показаний етап у документ</translation>
    </message>
    <message>
        <source>Animation</source>
        <translation>Анімація</translation>
    </message>
</context>
<context>
    <name>kriva::ui::PlotsPanel</name>
    <message>
        <source>Plot</source>
        <translation>Графік</translation>
    </message>
    <message>
        <source>Export the plot</source>
        <translation>Експортувати графік</translation>
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
        <translation>Менше</translation>
    </message>
    <message>
        <source>More</source>
        <translation>Більше</translation>
    </message>
</context>
<context>
    <name>kriva::ui::RecoveryDialog</name>
    <message>
        <source>Untitled</source>
        <translation>Без назви</translation>
    </message>
    <message>
        <source>never saved · changed %1</source>
        <comment>a document and a time</comment>
        <translation>ще не збережено · змінено %1</translation>
    </message>
    <message>
        <source>%1 · changed %2</source>
        <comment>a folder and a time</comment>
        <translation>%1 · змінено %2</translation>
    </message>
    <message>
        <source>Damaged: it cannot be read any more.</source>
        <translation>Пошкоджено: його вже не можна прочитати.</translation>
    </message>
    <message>
        <source>Damaged: look closely at what is recovered.</source>
        <translation>Пошкоджено: уважно перегляньте відновлене.</translation>
    </message>
    <message>
        <source>What to do with %1</source>
        <translation>Що зробити з %1</translation>
    </message>
    <message>
        <source>Recover</source>
        <translation>Відновити</translation>
    </message>
    <message>
        <source>Ask later</source>
        <translation>Запитати пізніше</translation>
    </message>
    <message>
        <source>Discard</source>
        <translation>Відкинути</translation>
    </message>
    <message>
        <source>Recover unsaved work</source>
        <translation>Відновлення незбереженого</translation>
    </message>
    <message>
        <source>Kriva ended before this was saved</source>
        <translation>Kriva завершилася, перш ніж це було збережено</translation>
    </message>
    <message>
        <source>What is recovered opens in a window of its own and is written to its file only when you save.</source>
        <translation>Відновлене відкривається у власному вікні й записується у свій файл лише тоді, коли ви збережете.</translation>
    </message>
    <message>
        <source>&amp;Continue</source>
        <translation>&amp;Продовжити</translation>
    </message>
    <message>
        <source>Ask &amp;later about all</source>
        <translation>Запитати про всі пі&amp;зніше</translation>
    </message>
    <message>
        <source>Missing: the unsaved work is not there any more.</source>
        <translation>Відсутнє: незбереженого вже немає.</translation>
    </message>
</context>
<context>
    <name>kriva::ui::ResultsModel</name>
    <message>
        <source>Name</source>
        <translation>Назва</translation>
    </message>
    <message>
        <source>Value</source>
        <translation>Значення</translation>
    </message>
</context>
<context>
    <name>kriva::ui::ResultsPanel</name>
    <message>
        <source>Results</source>
        <translation>Результати</translation>
    </message>
</context>
<context>
    <name>kriva::ui::ShortcutsDialog</name>
    <message>
        <source>Shortcuts</source>
        <translation>Клавіатурні скорочення</translation>
    </message>
    <message>
        <source>Search</source>
        <translation>Пошук</translation>
    </message>
    <message>
        <source>What it does</source>
        <translation>Дія</translation>
    </message>
    <message>
        <source>Keys and mouse</source>
        <translation>Клавіші та миша</translation>
    </message>
</context>
<context>
    <name>kriva::ui::SplineProperties</name>
    <message>
        <source>Closed</source>
        <translation>Замкнена</translation>
    </message>
    <message>
        <source>Given here; otherwise that of the natural spline</source>
        <translation>Задана тут; інакше та, що в природного сплайна</translation>
    </message>
    <message>
        <source>Given</source>
        <translation>Задана</translation>
    </message>
    <message>
        <source>Show the comb</source>
        <translation>Показати гребінь</translation>
    </message>
    <message>
        <source>Show the polyline</source>
        <translation>Показати ламану</translation>
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
        <translation>Координати вказівника</translation>
    </message>
    <message>
        <source>Zoom</source>
        <translation>Масштаб</translation>
    </message>
</context>
<context>
    <name>kriva::ui::StyleEditor</name>
    <message>
        <source>Width of the line</source>
        <translation>Товщина лінії</translation>
    </message>
    <message>
        <source>Line</source>
        <translation>Лінія</translation>
    </message>
    <message>
        <source>Marks of the points</source>
        <translation>Знаки точок</translation>
    </message>
    <message>
        <source>Labels</source>
        <translation>Позначення</translation>
    </message>
    <message>
        <source>Usual style</source>
        <translation>Звичайний стиль</translation>
    </message>
</context>
<context>
    <name>kriva::ui::SubdivisionProperties</name>
    <message>
        <source>Show the curve</source>
        <translation>Показати криву</translation>
    </message>
    <message>
        <source>Show the blossom</source>
        <translation>Показати полярну форму</translation>
    </message>
    <message>
        <source>Parameter t</source>
        <translation>Параметр t</translation>
    </message>
    <message>
        <source>Levels</source>
        <translation>Рівні</translation>
    </message>
    <message>
        <source>Shows the de Casteljau scheme at these t as well, like 0.25; 0.75</source>
        <translation>Показує схему де Кастельжо також при цих t, наприклад 0,25; 0,75</translation>
    </message>
    <message>
        <source>Show the pieces</source>
        <translation>Показати частини</translation>
    </message>
</context>
<context>
    <name>kriva::ui::TablesPanel</name>
    <message>
        <source>Table</source>
        <translation>Таблиця</translation>
    </message>
    <message>
        <source>Numbers of the table</source>
        <translation>Числа таблиці</translation>
    </message>
    <message>
        <source>LaTeX</source>
        <translation>LaTeX</translation>
    </message>
    <message>
        <source>Copy the table as LaTeX</source>
        <translation>Копіювати таблицю як LaTeX</translation>
    </message>
    <message>
        <source>CSV</source>
        <translation>CSV</translation>
    </message>
    <message>
        <source>Copy the table for a spreadsheet</source>
        <translation>Копіювати таблицю для електронної таблиці</translation>
    </message>
</context>
</TS>
