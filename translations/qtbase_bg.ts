<?xml version="1.0" encoding="utf-8"?>
<!DOCTYPE TS>
<TS version="2.1" language="bg_BG" sourcelanguage="en">
<context>
    <name>QAbstractFileIconProvider</name>
    <message>
        <source>File</source>
        <translation>Файл</translation>
    </message>
    <message>
        <source>File Folder</source>
        <translation>Папка с файлове</translation>
    </message>
    <message>
        <source>Folder</source>
        <translation>Папка</translation>
    </message>
    <message>
        <source>Drive</source>
        <translation>Устройство</translation>
    </message>
    <message>
        <source>Alias</source>
        <translation>Псевдоним</translation>
    </message>
    <message>
        <source>Shortcut</source>
        <translation>Пряк път</translation>
    </message>
    <message>
        <source>Unknown</source>
        <translation>Неизвестен</translation>
    </message>
</context>
<context>
    <name>QColorDialog</name>
    <message>
        <source>Pick Screen Color</source>
        <translation>Вземане на цвят от екрана</translation>
    </message>
    <message>
        <source>Cursor at %1, %2, color: %3
Press ESC to cancel</source>
        <translation>Показалец на %1, %2, цвят: %3
Натиснете ESC за отказ</translation>
    </message>
</context>
<context>
    <name>QCommandLineParser</name>
    <message>
        <source>Displays help including Qt specific options.</source>
        <translation>Показва помощ заедно с възможностите на Qt.</translation>
    </message>
    <message>
        <source>Displays help on commandline options.</source>
        <translation>Показва помощ за възможностите на командния ред.</translation>
    </message>
</context>
<context>
    <name>QCupsPrinterSupport</name>
    <message>
        <source>Authentication Needed</source>
        <translation>Нужно е удостоверяване</translation>
    </message>
    <message>
        <source>Authentication needed to use %1 on %2.</source>
        <translation>За да ползвате %1 на %2, е нужно удостоверяване.</translation>
    </message>
    <message>
        <source>Authentication needed to use %1.</source>
        <translation>За да ползвате %1, е нужно удостоверяване.</translation>
    </message>
    <message>
        <source>Username:</source>
        <translation>Потребителско име:</translation>
    </message>
    <message>
        <source>Password:</source>
        <translation>Парола:</translation>
    </message>
</context>
<context>
    <name>QDockWidget</name>
    <message>
        <source>Undocks and re-attaches the dock widget</source>
        <translation>Откача панела и отново го закача</translation>
    </message>
    <message>
        <source>Closes the dock widget</source>
        <translation>Затваря панела</translation>
    </message>
</context>
<context>
    <name>QErrorMessage</name>
    <message>
        <source>Critical Error:</source>
        <translation>Критична грешка:</translation>
    </message>
    <message>
        <source>Information:</source>
        <translation>Информация:</translation>
    </message>
</context>
<context>
    <name>QFile</name>
    <message>
        <source>Cannot open destination file: %1</source>
        <translation>Целевият файл не може да се отвори: %1</translation>
    </message>
    <message>
        <source>Error while renaming: %1</source>
        <translation>Грешка при преименуване: %1</translation>
    </message>
    <message>
        <source>Cannot open for output: %1</source>
        <translation>Не може да се отвори за запис: %1</translation>
    </message>
    <message>
        <source>Cannot create %1 for output: %2</source>
        <translation>%1 не може да се създаде за запис: %2</translation>
    </message>
    <message>
        <source>Failure to write block: %1</source>
        <translation>Блокът не можа да се запише: %1</translation>
    </message>
</context>
<context>
    <name>QFileDevice</name>
    <message>
        <source>No file engine available</source>
        <translation>Няма подходящ механизъм за файлове</translation>
    </message>
</context>
<context>
    <name>QFileDialog</name>
    <message>
        <source>Sidebar</source>
        <translation>Странична лента</translation>
    </message>
    <message>
        <source>Show </source>
        <translation>Показване </translation>
    </message>
    <message>
        <source>Alt+Left</source>
        <translation>Alt+Left</translation>
    </message>
    <message>
        <source>Alt+Right</source>
        <translation>Alt+Right</translation>
    </message>
    <message>
        <source>Alt+Up</source>
        <translation>Alt+Up</translation>
    </message>
</context>
<context>
    <name>QFileSystemModel</name>
    <message>
        <source>&lt;b&gt;The name &quot;%1&quot; cannot be used.&lt;/b&gt;&lt;p&gt;Try using another name, with fewer characters or no punctuation marks.</source>
        <translation>&lt;b&gt;Името „%1“ не може да се ползва.&lt;/b&gt;&lt;p&gt;Опитайте с друго име, с по-малко знаци или без препинателни знаци.</translation>
    </message>
</context>
<context>
    <name>QImageWriter</name>
    <message>
        <source>Image is empty</source>
        <translation>Изображението е празно</translation>
    </message>
    <message>
        <source>Cannot open device for writing: %1</source>
        <translation>Устройството не може да се отвори за запис: %1</translation>
    </message>
</context>
<context>
    <name>QMessageBox</name>
    <message>
        <source>&lt;p&gt;Qt is a C++ toolkit for cross-platform application development.&lt;/p&gt;&lt;p&gt;Qt provides single-source portability across all major desktop operating systems. It is also available for embedded Linux and other embedded and mobile operating systems.&lt;/p&gt;&lt;p&gt;Qt is available under multiple licensing options designed to accommodate the needs of our various users.&lt;/p&gt;&lt;p&gt;Qt licensed under our commercial license agreement is appropriate for development of proprietary/commercial software where you do not want to share any source code with third parties or otherwise cannot comply with the terms of GNU (L)GPL.&lt;/p&gt;&lt;p&gt;Qt licensed under GNU (L)GPL is appropriate for the development of Qt&amp;nbsp;applications provided you can comply with the terms and conditions of the respective licenses.&lt;/p&gt;&lt;p&gt;Please see &lt;a href=&quot;http://%2/&quot;&gt;%2&lt;/a&gt; for an overview of Qt licensing.&lt;/p&gt;&lt;p&gt;Copyright (C) %1 The Qt Company Ltd and other contributors.&lt;/p&gt;&lt;p&gt;Qt and the Qt logo are trademarks of The Qt Company Ltd.&lt;/p&gt;&lt;p&gt;Qt is The Qt Company Ltd product developed as an open source project. See &lt;a href=&quot;http://%3/&quot;&gt;%3&lt;/a&gt; for more information.&lt;/p&gt;</source>
        <translation>&lt;p&gt;Qt е набор от инструменти на C++ за разработка на програми за различни платформи.&lt;/p&gt;&lt;p&gt;Qt дава възможност един и същ изходен код да се ползва във всички основни настолни операционни системи. Наличен е и за вграден Linux и за други вградени и мобилни операционни системи.&lt;/p&gt;&lt;p&gt;Qt се предлага с няколко лиценза, съобразени с нуждите на различните потребители.&lt;/p&gt;&lt;p&gt;Qt с нашия търговски лиценз е подходящ за разработка на собственически и търговски програми, когато не желаете да споделяте изходния код с трети лица или по друга причина не можете да спазите условията на GNU (L)GPL.&lt;/p&gt;&lt;p&gt;Qt с лиценз GNU (L)GPL е подходящ за разработка на програми с&amp;nbsp;Qt, при условие че можете да спазите изискванията на съответните лицензи.&lt;/p&gt;&lt;p&gt;Преглед на лицензите на Qt има на адрес &lt;a href=&quot;http://%2/&quot;&gt;%2&lt;/a&gt;.&lt;/p&gt;&lt;p&gt;Авторски права (C) %1 The Qt Company Ltd и други сътрудници.&lt;/p&gt;&lt;p&gt;Qt и логото на Qt са търговски марки на The Qt Company Ltd.&lt;/p&gt;&lt;p&gt;Qt е продукт на The Qt Company Ltd, разработван като проект с отворен код. За повече сведения вижте &lt;a href=&quot;http://%3/&quot;&gt;%3&lt;/a&gt;.&lt;/p&gt;</translation>
    </message>
    <message>
        <source>OK</source>
        <translation>Добре</translation>
    </message>
    <message>
        <source>Help</source>
        <translation>Помощ</translation>
    </message>
</context>
<context>
    <name>QPPDOptionsModel</name>
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
    <name>QPageSetupWidget</name>
    <message>
        <source>Centimeters (cm)</source>
        <translation>Сантиметри (cm)</translation>
    </message>
</context>
<context>
    <name>QPageSize</name>
    <message>
        <source>%1 x %2 in</source>
        <translation>%1 × %2 in</translation>
    </message>
</context>
<context>
    <name>QPrintDialog</name>
    <message>
        <source>There are conflicts in duplex settings. Do you want to fix them?</source>
        <translation>Настройките за двустранен печат си противоречат. Искате ли да ги поправите?</translation>
    </message>
    <message>
        <source>Duplex Settings Conflicts</source>
        <translation>Противоречиви настройки за двустранен печат</translation>
    </message>
    <message>
        <source>Invalid Pages Definition</source>
        <translation>Неправилно зададени страници</translation>
    </message>
    <message>
        <source>%1 does not follow the correct syntax. Please use &apos;,&apos; to separate ranges and pages, &apos;-&apos; to define ranges and make sure ranges do not intersect with each other.</source>
        <translation>%1 не е записано правилно. Отделяйте интервалите и страниците със запетая „,“, задавайте интервалите с тире „-“ и внимавайте интервалите да не се пресичат.</translation>
    </message>
    <message>
        <source>Custom</source>
        <translation>Потребителски</translation>
    </message>
</context>
<context>
    <name>QPrintPropertiesDialog</name>
    <message>
        <source>Advanced Option Conflicts</source>
        <translation>Противоречиви допълнителни настройки</translation>
    </message>
    <message>
        <source>Page Setup Conflicts</source>
        <translation>Противоречиви настройки на страницата</translation>
    </message>
    <message>
        <source>There are conflicts in some advanced options. Do you want to fix them?</source>
        <translation>Някои допълнителни настройки си противоречат. Искате ли да ги поправите?</translation>
    </message>
    <message>
        <source>There are conflicts in page setup options. Do you want to fix them?</source>
        <translation>Настройките на страницата си противоречат. Искате ли да ги поправите?</translation>
    </message>
</context>
<context>
    <name>QPrintPropertiesWidget</name>
    <message>
        <source>There are conflicts in some options. Please fix them.</source>
        <translation>Някои настройки си противоречат. Моля, поправете ги.</translation>
    </message>
    <message>
        <source>Advanced</source>
        <translation>Допълнителни</translation>
    </message>
</context>
<context>
    <name>QPrintSettingsOutput</name>
    <message>
        <source>Pages</source>
        <translation>Страници</translation>
    </message>
    <message>
        <source>Specify pages or ranges separated by commas. Ranges are specified by two numbers separated by a hyphen. E.g: 3,5-7,9 prints pages 3, 5, 6, 7 and 9.</source>
        <translation>Задайте страници или интервали, отделени със запетаи. Интервалът се задава с две числа с тире между тях. Пример: 3,5-7,9 отпечатва страниците 3, 5, 6, 7 и 9.</translation>
    </message>
    <message>
        <source>Off</source>
        <translation>Изключено</translation>
    </message>
    <message>
        <source>Short side binding</source>
        <translation>Подвързване по късата страна</translation>
    </message>
    <message>
        <source>Long side binding</source>
        <translation>Подвързване по дългата страна</translation>
    </message>
    <message>
        <source>Double Sided Printing</source>
        <translation>Двустранен печат</translation>
    </message>
</context>
<context>
    <name>QShortcut</name>
    <message>
        <source>Memo</source>
        <translation>Бележка</translation>
    </message>
    <message>
        <source>Launch (G)</source>
        <translation>Пускане (G)</translation>
    </message>
    <message>
        <source>Launch (H)</source>
        <translation>Пускане (H)</translation>
    </message>
    <message>
        <source>Adjust contrast</source>
        <translation>Настройване на контраста</translation>
    </message>
    <message>
        <source>Calendar</source>
        <translation>Календар</translation>
    </message>
    <message>
        <source>To-do list</source>
        <translation>Списък със задачи</translation>
    </message>
    <message>
        <source>Control</source>
        <translation>Ctrl</translation>
    </message>
</context>
<context>
    <name>QSpiAccessibleBridge</name>
    <message>
        <source>notification</source>
        <translation>известие</translation>
    </message>
    <message>
        <source>desktop</source>
        <translation>работен плот</translation>
    </message>
    <message>
        <source>terminal</source>
        <translation>терминал</translation>
    </message>
    <message>
        <source>window</source>
        <translation>прозорец</translation>
    </message>
</context>
<context>
    <name>QStandardPaths</name>
    <message>
        <source>Templates</source>
        <translation>Шаблони</translation>
    </message>
    <message>
        <source>Public</source>
        <translation>Публични</translation>
    </message>
</context>
<context>
    <name>QUndoGroup</name>
    <message>
        <source>Redo</source>
        <translation>Повтаряне</translation>
    </message>
    <message>
        <source>Undo %1</source>
        <translation>Отмяна: %1</translation>
    </message>
    <message>
        <source>Redo %1</source>
        <translation>Повтаряне: %1</translation>
    </message>
</context>
<context>
    <name>QUndoStack</name>
    <message>
        <source>Redo</source>
        <translation>Повтаряне</translation>
    </message>
    <message>
        <source>Undo %1</source>
        <translation>Отмяна: %1</translation>
    </message>
    <message>
        <source>Redo %1</source>
        <translation>Повтаряне: %1</translation>
    </message>
</context>
</TS>
