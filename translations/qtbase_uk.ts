<?xml version="1.0" encoding="utf-8"?>
<!DOCTYPE TS>
<TS version="2.1" language="uk_UA" sourcelanguage="en">
<context>
    <name>QAbstractFileIconProvider</name>
    <message>
        <source>File</source>
        <translation>Файл</translation>
    </message>
    <message>
        <source>File Folder</source>
        <translation>Тека з файлами</translation>
    </message>
    <message>
        <source>Folder</source>
        <translation>Тека</translation>
    </message>
    <message>
        <source>Drive</source>
        <translation>Диск</translation>
    </message>
    <message>
        <source>Alias</source>
        <translation>Псевдонім</translation>
    </message>
    <message>
        <source>Shortcut</source>
        <translation>Ярлик</translation>
    </message>
    <message>
        <source>Unknown</source>
        <translation>Невідомий</translation>
    </message>
</context>
<context>
    <name>QColorDialog</name>
    <message>
        <source>Pick Screen Color</source>
        <translation>Вибрати колір на екрані</translation>
    </message>
    <message>
        <source>Cursor at %1, %2, color: %3
Press ESC to cancel</source>
        <translation>Курсор у позиції %1, %2, колір: %3
Натисніть ESC, щоб скасувати</translation>
    </message>
</context>
<context>
    <name>QCommandLineParser</name>
    <message>
        <source>Displays help including Qt specific options.</source>
        <translation>Показує довідку разом із параметрами Qt.</translation>
    </message>
    <message>
        <source>Displays help on commandline options.</source>
        <translation>Показує довідку щодо параметрів командного рядка.</translation>
    </message>
</context>
<context>
    <name>QCupsPrinterSupport</name>
    <message>
        <source>Authentication Needed</source>
        <translation>Потрібна автентифікація</translation>
    </message>
    <message>
        <source>Authentication needed to use %1 on %2.</source>
        <translation>Щоб користуватися %1 на %2, потрібна автентифікація.</translation>
    </message>
    <message>
        <source>Authentication needed to use %1.</source>
        <translation>Щоб користуватися %1, потрібна автентифікація.</translation>
    </message>
    <message>
        <source>Username:</source>
        <translation>Ім’я користувача:</translation>
    </message>
    <message>
        <source>Password:</source>
        <translation>Пароль:</translation>
    </message>
</context>
<context>
    <name>QDockWidget</name>
    <message>
        <source>Undocks and re-attaches the dock widget</source>
        <translation>Відкріплює панель або знову її прикріплює</translation>
    </message>
    <message>
        <source>Closes the dock widget</source>
        <translation>Закриває панель</translation>
    </message>
</context>
<context>
    <name>QErrorMessage</name>
    <message>
        <source>Critical Error:</source>
        <translation>Критична помилка:</translation>
    </message>
    <message>
        <source>Information:</source>
        <translation>Інформація:</translation>
    </message>
</context>
<context>
    <name>QFile</name>
    <message>
        <source>Cannot open destination file: %1</source>
        <translation>Не вдалося відкрити файл призначення: %1</translation>
    </message>
    <message>
        <source>Error while renaming: %1</source>
        <translation>Помилка під час перейменування: %1</translation>
    </message>
    <message>
        <source>Cannot open for output: %1</source>
        <translation>Не вдалося відкрити для запису: %1</translation>
    </message>
    <message>
        <source>Cannot create %1 for output: %2</source>
        <translation>Не вдалося створити %1 для запису: %2</translation>
    </message>
    <message>
        <source>Failure to write block: %1</source>
        <translation>Не вдалося записати блок: %1</translation>
    </message>
</context>
<context>
    <name>QFileDevice</name>
    <message>
        <source>No file engine available</source>
        <translation>Немає доступного рушія файлів</translation>
    </message>
</context>
<context>
    <name>QFileDialog</name>
    <message>
        <source>Show </source>
        <translation>Показати </translation>
    </message>
</context>
<context>
    <name>QFileSystemModel</name>
    <message>
        <source>&lt;b&gt;The name &quot;%1&quot; cannot be used.&lt;/b&gt;&lt;p&gt;Try using another name, with fewer characters or no punctuation marks.</source>
        <translation>&lt;b&gt;Назву «%1» не можна використати.&lt;/b&gt;&lt;p&gt;Спробуйте іншу назву, з меншою кількістю символів або без розділових знаків.</translation>
    </message>
</context>
<context>
    <name>QImageWriter</name>
    <message>
        <source>Image is empty</source>
        <translation>Зображення порожнє</translation>
    </message>
    <message>
        <source>Cannot open device for writing: %1</source>
        <translation>Не вдалося відкрити пристрій для запису: %1</translation>
    </message>
</context>
<context>
    <name>QLineEdit</name>
    <message>
        <source>&amp;Undo</source>
        <translation>&amp;Скасувати</translation>
    </message>
    <message>
        <source>Delete</source>
        <translation>Вилучити</translation>
    </message>
</context>
<context>
    <name>QMessageBox</name>
    <message>
        <source>&lt;p&gt;Qt is a C++ toolkit for cross-platform application development.&lt;/p&gt;&lt;p&gt;Qt provides single-source portability across all major desktop operating systems. It is also available for embedded Linux and other embedded and mobile operating systems.&lt;/p&gt;&lt;p&gt;Qt is available under multiple licensing options designed to accommodate the needs of our various users.&lt;/p&gt;&lt;p&gt;Qt licensed under our commercial license agreement is appropriate for development of proprietary/commercial software where you do not want to share any source code with third parties or otherwise cannot comply with the terms of GNU (L)GPL.&lt;/p&gt;&lt;p&gt;Qt licensed under GNU (L)GPL is appropriate for the development of Qt&amp;nbsp;applications provided you can comply with the terms and conditions of the respective licenses.&lt;/p&gt;&lt;p&gt;Please see &lt;a href=&quot;http://%2/&quot;&gt;%2&lt;/a&gt; for an overview of Qt licensing.&lt;/p&gt;&lt;p&gt;Copyright (C) %1 The Qt Company Ltd and other contributors.&lt;/p&gt;&lt;p&gt;Qt and the Qt logo are trademarks of The Qt Company Ltd.&lt;/p&gt;&lt;p&gt;Qt is The Qt Company Ltd product developed as an open source project. See &lt;a href=&quot;http://%3/&quot;&gt;%3&lt;/a&gt; for more information.&lt;/p&gt;</source>
        <translation>&lt;p&gt;Qt — це набір інструментів C++ для розробки програм для різних платформ.&lt;/p&gt;&lt;p&gt;Qt дає змогу використовувати той самий код в усіх основних настільних операційних системах. Його можна використовувати також у вбудованих системах на основі Linux та в інших вбудованих і мобільних операційних системах.&lt;/p&gt;&lt;p&gt;Qt поширюється за умов кількох ліцензій, які відповідають потребам різних користувачів.&lt;/p&gt;&lt;p&gt;Qt за нашою комерційною ліцензією придатний для розробки закритих і комерційних програм, якщо ви не бажаєте відкривати код стороннім особам або з інших причин не можете виконати умови GNU (L)GPL.&lt;/p&gt;&lt;p&gt;Qt за ліцензією GNU (L)GPL придатний для розробки програм на&amp;nbsp;Qt, якщо ви можете виконати умови відповідних ліцензій.&lt;/p&gt;&lt;p&gt;Огляд ліцензій Qt наведено на сторінці &lt;a href=&quot;http://%2/&quot;&gt;%2&lt;/a&gt;.&lt;/p&gt;&lt;p&gt;Авторські права (C) %1 The Qt Company Ltd та інші учасники.&lt;/p&gt;&lt;p&gt;Qt і логотип Qt є торговельними марками The Qt Company Ltd.&lt;/p&gt;&lt;p&gt;Qt є продуктом The Qt Company Ltd, який розробляють як проєкт із відкритим кодом. Докладніше: &lt;a href=&quot;http://%3/&quot;&gt;%3&lt;/a&gt;.&lt;/p&gt;</translation>
    </message>
</context>
<context>
    <name>QPPDOptionsModel</name>
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
    <name>QPageSetupWidget</name>
    <message>
        <source>Centimeters (cm)</source>
        <translation>Сантиметри (см)</translation>
    </message>
</context>
<context>
    <name>QPageSize</name>
    <message>
        <source>Postcard</source>
        <translation>Листівка</translation>
    </message>
    <message>
        <source>Double Postcard</source>
        <translation>Подвійна листівка</translation>
    </message>
    <message>
        <source>Note</source>
        <translation>Аркуш для нотаток</translation>
    </message>
    <message>
        <source>Statement</source>
        <translation>Виписка</translation>
    </message>
    <message>
        <source>PRC 32K Big</source>
        <translation>PRC 32K, великий</translation>
    </message>
    <message>
        <source>Envelope Italian</source>
        <translation>Конверт, італійський</translation>
    </message>
    <message>
        <source>Envelope Personal</source>
        <translation>Конверт, особистий</translation>
    </message>
    <message>
        <source>Envelope Invite</source>
        <translation>Конверт для запрошення</translation>
    </message>
    <message>
        <source>A4 Extra</source>
        <translation>A4, збільшений</translation>
    </message>
    <message>
        <source>A3 Extra</source>
        <translation>A3, збільшений</translation>
    </message>
    <message>
        <source>A5 Extra</source>
        <translation>A5, збільшений</translation>
    </message>
    <message>
        <source>B5 Extra</source>
        <translation>B5, збільшений</translation>
    </message>
    <message>
        <source>Letter Extra</source>
        <translation>Letter, збільшений</translation>
    </message>
    <message>
        <source>Tabloid Extra</source>
        <translation>Tabloid, збільшений</translation>
    </message>
    <message>
        <source>Legal Extra</source>
        <translation>Legal, збільшений</translation>
    </message>
    <message>
        <source>A4 Small</source>
        <translation>A4, зменшений</translation>
    </message>
    <message>
        <source>A4 Plus</source>
        <translation>A4, подовжений</translation>
    </message>
    <message>
        <source>Letter Small</source>
        <translation>Letter, зменшений</translation>
    </message>
    <message>
        <source>Letter Plus</source>
        <translation>Letter, подовжений</translation>
    </message>
    <message>
        <source>Architect A</source>
        <translation>Архітектурний A</translation>
    </message>
    <message>
        <source>Architect B</source>
        <translation>Архітектурний B</translation>
    </message>
    <message>
        <source>Architect C</source>
        <translation>Архітектурний C</translation>
    </message>
    <message>
        <source>Architect D</source>
        <translation>Архітектурний D</translation>
    </message>
    <message>
        <source>Architect E</source>
        <translation>Архітектурний E</translation>
    </message>
    <message>
        <source>Envelope B4</source>
        <translation>Конверт B4</translation>
    </message>
    <message>
        <source>Envelope B5</source>
        <translation>Конверт B5</translation>
    </message>
    <message>
        <source>Envelope B6</source>
        <translation>Конверт B6</translation>
    </message>
    <message>
        <source>Envelope C0</source>
        <translation>Конверт C0</translation>
    </message>
    <message>
        <source>Envelope C1</source>
        <translation>Конверт C1</translation>
    </message>
    <message>
        <source>Envelope C2</source>
        <translation>Конверт C2</translation>
    </message>
    <message>
        <source>Envelope C3</source>
        <translation>Конверт C3</translation>
    </message>
    <message>
        <source>Envelope C4</source>
        <translation>Конверт C4</translation>
    </message>
    <message>
        <source>Envelope C5</source>
        <translation>Конверт C5</translation>
    </message>
    <message>
        <source>Envelope C6</source>
        <translation>Конверт C6</translation>
    </message>
    <message>
        <source>Envelope C7</source>
        <translation>Конверт C7</translation>
    </message>
    <message>
        <source>Envelope C65</source>
        <translation>Конверт C65</translation>
    </message>
    <message>
        <source>Envelope DL</source>
        <translation>Конверт DL</translation>
    </message>
    <message>
        <source>Envelope Monarch</source>
        <translation>Конверт Monarch</translation>
    </message>
    <message>
        <source>Envelope US 9</source>
        <translation>Конверт US 9</translation>
    </message>
    <message>
        <source>Envelope US 10</source>
        <translation>Конверт US 10</translation>
    </message>
    <message>
        <source>Envelope US 11</source>
        <translation>Конверт US 11</translation>
    </message>
    <message>
        <source>Envelope US 12</source>
        <translation>Конверт US 12</translation>
    </message>
    <message>
        <source>Envelope US 14</source>
        <translation>Конверт US 14</translation>
    </message>
    <message>
        <source>Envelope PRC 1</source>
        <translation>Конверт PRC 1</translation>
    </message>
    <message>
        <source>Envelope PRC 2</source>
        <translation>Конверт PRC 2</translation>
    </message>
    <message>
        <source>Envelope PRC 3</source>
        <translation>Конверт PRC 3</translation>
    </message>
    <message>
        <source>Envelope PRC 4</source>
        <translation>Конверт PRC 4</translation>
    </message>
    <message>
        <source>Envelope PRC 5</source>
        <translation>Конверт PRC 5</translation>
    </message>
    <message>
        <source>Envelope PRC 6</source>
        <translation>Конверт PRC 6</translation>
    </message>
    <message>
        <source>Envelope PRC 7</source>
        <translation>Конверт PRC 7</translation>
    </message>
    <message>
        <source>Envelope PRC 8</source>
        <translation>Конверт PRC 8</translation>
    </message>
    <message>
        <source>Envelope PRC 9</source>
        <translation>Конверт PRC 9</translation>
    </message>
    <message>
        <source>Envelope PRC 10</source>
        <translation>Конверт PRC 10</translation>
    </message>
    <message>
        <source>Envelope Chou 3</source>
        <translation>Конверт Chou 3</translation>
    </message>
    <message>
        <source>Envelope Chou 4</source>
        <translation>Конверт Chou 4</translation>
    </message>
    <message>
        <source>Envelope Kaku 2</source>
        <translation>Конверт Kaku 2</translation>
    </message>
    <message>
        <source>Envelope Kaku 3</source>
        <translation>Конверт Kaku 3</translation>
    </message>
    <message>
        <source>Envelope You 4</source>
        <translation>Конверт You 4</translation>
    </message>
</context>
<context>
    <name>QPrintDialog</name>
    <message>
        <source>There are conflicts in duplex settings. Do you want to fix them?</source>
        <translation>Параметри двостороннього друку суперечать один одному. Бажаєте їх виправити?</translation>
    </message>
    <message>
        <source>Duplex Settings Conflicts</source>
        <translation>Суперечливі параметри двостороннього друку</translation>
    </message>
    <message>
        <source>Invalid Pages Definition</source>
        <translation>Неправильно вказано сторінки</translation>
    </message>
    <message>
        <source>%1 does not follow the correct syntax. Please use &apos;,&apos; to separate ranges and pages, &apos;-&apos; to define ranges and make sure ranges do not intersect with each other.</source>
        <translation>%1 записано неправильно. Відокремлюйте діапазони і сторінки комою «,», задавайте діапазони дефісом «-» і стежте, щоб діапазони не перетиналися.</translation>
    </message>
    <message>
        <source>Custom</source>
        <translation>Нетиповий</translation>
    </message>
</context>
<context>
    <name>QPrintPropertiesDialog</name>
    <message>
        <source>Advanced Option Conflicts</source>
        <translation>Суперечливі додаткові параметри</translation>
    </message>
    <message>
        <source>Page Setup Conflicts</source>
        <translation>Суперечливі параметри сторінки</translation>
    </message>
    <message>
        <source>There are conflicts in some advanced options. Do you want to fix them?</source>
        <translation>Деякі додаткові параметри суперечать один одному. Бажаєте їх виправити?</translation>
    </message>
    <message>
        <source>There are conflicts in page setup options. Do you want to fix them?</source>
        <translation>Параметри сторінки суперечать один одному. Бажаєте їх виправити?</translation>
    </message>
</context>
<context>
    <name>QPrintPropertiesWidget</name>
    <message>
        <source>There are conflicts in some options. Please fix them.</source>
        <translation>Деякі параметри суперечать один одному. Будь ласка, виправте їх.</translation>
    </message>
    <message>
        <source>Advanced</source>
        <translation>Додатково</translation>
    </message>
</context>
<context>
    <name>QPrintSettingsOutput</name>
    <message>
        <source>Pages</source>
        <translation>Сторінки</translation>
    </message>
    <message>
        <source>Specify pages or ranges separated by commas. Ranges are specified by two numbers separated by a hyphen. E.g: 3,5-7,9 prints pages 3, 5, 6, 7 and 9.</source>
        <translation>Вкажіть сторінки або діапазони, відокремлені комами. Діапазон задають двома числами з дефісом між ними. Приклад: 3,5-7,9 друкує сторінки 3, 5, 6, 7 і 9.</translation>
    </message>
    <message>
        <source>Off</source>
        <translation>Вимкнено</translation>
    </message>
    <message>
        <source>Short side binding</source>
        <translation>Зшивання за коротким боком</translation>
    </message>
    <message>
        <source>Long side binding</source>
        <translation>Зшивання за довгим боком</translation>
    </message>
    <message>
        <source>Double Sided Printing</source>
        <translation>Двосторонній друк</translation>
    </message>
</context>
<context>
    <name>QShortcut</name>
    <message>
        <source>Memo</source>
        <translation>Нотатка</translation>
    </message>
    <message>
        <source>Launch (G)</source>
        <translation>Запустити (G)</translation>
    </message>
    <message>
        <source>Launch (H)</source>
        <translation>Запустити (H)</translation>
    </message>
    <message>
        <source>Adjust contrast</source>
        <translation>Змінити контрастність</translation>
    </message>
    <message>
        <source>Calendar</source>
        <translation>Календар</translation>
    </message>
    <message>
        <source>Clear Grab</source>
        <translation>Звільнити захоплення</translation>
    </message>
    <message>
        <source>To-do list</source>
        <translation>Список справ</translation>
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
        <translation>сповіщення</translation>
    </message>
    <message>
        <source>desktop</source>
        <translation>стільниця</translation>
    </message>
    <message>
        <source>terminal</source>
        <translation>термінал</translation>
    </message>
    <message>
        <source>window</source>
        <translation>вікно</translation>
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
        <translation>Загальнодоступні</translation>
    </message>
</context>
<context>
    <name>QUndoGroup</name>
    <message>
        <source>Undo</source>
        <translation>Скасувати</translation>
    </message>
    <message>
        <source>Undo %1</source>
        <translation>Скасувати: %1</translation>
    </message>
    <message>
        <source>Redo %1</source>
        <translation>Повторити: %1</translation>
    </message>
</context>
<context>
    <name>QUndoStack</name>
    <message>
        <source>Undo</source>
        <translation>Скасувати</translation>
    </message>
    <message>
        <source>Undo %1</source>
        <translation>Скасувати: %1</translation>
    </message>
    <message>
        <source>Redo %1</source>
        <translation>Повторити: %1</translation>
    </message>
</context>
<context>
    <name>QWidgetTextControl</name>
    <message>
        <source>&amp;Undo</source>
        <translation>&amp;Скасувати</translation>
    </message>
    <message>
        <source>Delete</source>
        <translation>Вилучити</translation>
    </message>
</context>
</TS>
