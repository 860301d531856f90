<?xml version="1.0" encoding="utf-8"?>
<!DOCTYPE TS>
<TS version="2.1" language="sl_SI" sourcelanguage="en">
<context>
    <name>CloseButton</name>
    <message>
        <source>Close Tab</source>
        <translation>Zapri zavihek</translation>
    </message>
</context>
<context>
    <name>QAbstractFileIconProvider</name>
    <message>
        <source>File</source>
        <translation>Datoteka</translation>
    </message>
    <message>
        <source>File Folder</source>
        <translation>Mapa z datotekami</translation>
    </message>
    <message>
        <source>Folder</source>
        <translation>Mapa</translation>
    </message>
    <message>
        <source>Drive</source>
        <translation>Pogon</translation>
    </message>
    <message>
        <source>Alias</source>
        <translation>Vzdevek</translation>
    </message>
    <message>
        <source>Shortcut</source>
        <translation>Bližnjica</translation>
    </message>
    <message>
        <source>Unknown</source>
        <translation>Neznano</translation>
    </message>
</context>
<context>
    <name>QAbstractSpinBox</name>
    <message>
        <source>&amp;Select All</source>
        <translation>&amp;Izberi vse</translation>
    </message>
    <message>
        <source>&amp;Step up</source>
        <translation>Po&amp;večaj</translation>
    </message>
    <message>
        <source>Step &amp;down</source>
        <translation>Z&amp;manjšaj</translation>
    </message>
</context>
<context>
    <name>QAccessibleActionInterface</name>
    <message>
        <source>Press</source>
        <translation>Pritisni</translation>
    </message>
    <message>
        <source>Increase</source>
        <translation>Povečaj</translation>
    </message>
    <message>
        <source>Decrease</source>
        <translation>Zmanjšaj</translation>
    </message>
    <message>
        <source>ShowMenu</source>
        <translation>Pokaži meni</translation>
    </message>
    <message>
        <source>SetFocus</source>
        <translation>Nastavi žarišče</translation>
    </message>
    <message>
        <source>Toggle</source>
        <translation>Preklopi</translation>
    </message>
    <message>
        <source>Scroll Left</source>
        <translation>Drsi levo</translation>
    </message>
    <message>
        <source>Scroll Right</source>
        <translation>Drsi desno</translation>
    </message>
    <message>
        <source>Scroll Up</source>
        <translation>Drsi gor</translation>
    </message>
    <message>
        <source>Scroll Down</source>
        <translation>Drsi dol</translation>
    </message>
    <message>
        <source>Previous Page</source>
        <translation>Prejšnja stran</translation>
    </message>
    <message>
        <source>Next Page</source>
        <translation>Naslednja stran</translation>
    </message>
    <message>
        <source>Triggers the action</source>
        <translation>Sproži dejanje</translation>
    </message>
    <message>
        <source>Increase the value</source>
        <translation>Poveča vrednost</translation>
    </message>
    <message>
        <source>Decrease the value</source>
        <translation>Zmanjša vrednost</translation>
    </message>
    <message>
        <source>Shows the menu</source>
        <translation>Pokaže meni</translation>
    </message>
    <message>
        <source>Sets the focus</source>
        <translation>Nastavi žarišče</translation>
    </message>
    <message>
        <source>Toggles the state</source>
        <translation>Preklopi stanje</translation>
    </message>
    <message>
        <source>Scrolls to the left</source>
        <translation>Drsi levo</translation>
    </message>
    <message>
        <source>Scrolls to the right</source>
        <translation>Drsi desno</translation>
    </message>
    <message>
        <source>Scrolls up</source>
        <translation>Drsi gor</translation>
    </message>
    <message>
        <source>Scrolls down</source>
        <translation>Drsi dol</translation>
    </message>
    <message>
        <source>Goes back a page</source>
        <translation>Gre stran nazaj</translation>
    </message>
    <message>
        <source>Goes to the next page</source>
        <translation>Gre na naslednjo stran</translation>
    </message>
</context>
<context>
    <name>QApplication</name>
    <message>
        <source>Executable &apos;%1&apos; requires Qt %2, found Qt %3.</source>
        <translation>Program »%1« potrebuje Qt %2, najden pa je Qt %3.</translation>
    </message>
    <message>
        <source>Incompatible Qt Library Error</source>
        <translation>Nezdružljiva knjižnica Qt</translation>
    </message>
</context>
<context>
    <name>QColorDialog</name>
    <message>
        <source>Hu&amp;e:</source>
        <translation>&amp;Odtenek:</translation>
    </message>
    <message>
        <source>&amp;Sat:</source>
        <translation>&amp;Nasičenost:</translation>
    </message>
    <message>
        <source>&amp;Val:</source>
        <translation>&amp;Vrednost:</translation>
    </message>
    <message>
        <source>&amp;Red:</source>
        <translation>&amp;Rdeča:</translation>
    </message>
    <message>
        <source>&amp;Green:</source>
        <translation>&amp;Zelena:</translation>
    </message>
    <message>
        <source>Bl&amp;ue:</source>
        <translation>&amp;Modra:</translation>
    </message>
    <message>
        <source>A&amp;lpha channel:</source>
        <translation>&amp;Kanal alfa:</translation>
    </message>
    <message>
        <source>&amp;HTML:</source>
        <translation>&amp;HTML:</translation>
    </message>
    <message>
        <source>Select Color</source>
        <translation>Izberite barvo</translation>
    </message>
    <message>
        <source>&amp;Basic colors</source>
        <translation>O&amp;snovne barve</translation>
    </message>
    <message>
        <source>&amp;Custom colors</source>
        <translation>&amp;Lastne barve</translation>
    </message>
    <message>
        <source>&amp;Add to Custom Colors</source>
        <translation>&amp;Dodaj lastnim barvam</translation>
    </message>
    <message>
        <source>&amp;Pick Screen Color</source>
        <translation>&amp;Poberi barvo z zaslona</translation>
    </message>
    <message>
        <source>Pick Screen Color</source>
        <translation>Poberi barvo z zaslona</translation>
    </message>
    <message>
        <source>Cursor at %1, %2
Press ESC to cancel</source>
        <translation>Kazalec na %1, %2
Za preklic pritisnite tipko ESC</translation>
    </message>
    <message>
        <source>Cursor at %1, %2, color: %3
Press ESC to cancel</source>
        <translation>Kazalec na %1, %2, barva: %3
Za preklic pritisnite tipko ESC</translation>
    </message>
</context>
<context>
    <name>QComboBox</name>
    <message>
        <source>Open the combo box selection popup</source>
        <translation>Odpri seznam izbir</translation>
    </message>
    <message>
        <source>False</source>
        <translation>Napačno</translation>
    </message>
    <message>
        <source>True</source>
        <translation>Pravilno</translation>
    </message>
</context>
<context>
    <name>QCommandLineParser</name>
    <message>
        <source>Displays version information.</source>
        <translation>Izpiše podatke o različici.</translation>
    </message>
    <message>
        <source>Displays this help.</source>
        <translation>Izpiše to pomoč.</translation>
    </message>
    <message>
        <source>Displays help on commandline options.</source>
        <translation>Izpiše pomoč o možnostih ukazne vrstice.</translation>
    </message>
    <message>
        <source>Displays help including Qt specific options.</source>
        <translation>Izpiše pomoč skupaj z možnostmi knjižnice Qt.</translation>
    </message>
    <message>
        <source>Unknown option &apos;%1&apos;.</source>
        <translation>Neznana možnost »%1«.</translation>
    </message>
    <message>
        <source>Unknown options: %1.</source>
        <translation>Neznane možnosti: %1.</translation>
    </message>
    <message>
        <source>Missing value after &apos;%1&apos;.</source>
        <translation>Manjka vrednost za »%1«.</translation>
    </message>
    <message>
        <source>Unexpected value after &apos;%1&apos;.</source>
        <translation>Nepričakovana vrednost za »%1«.</translation>
    </message>
    <message>
        <source>Usage: %1</source>
        <translation>Uporaba: %1</translation>
    </message>
    <message>
        <source>[options]</source>
        <translation>[možnosti]</translation>
    </message>
    <message>
        <source>Options:</source>
        <translation>Možnosti:</translation>
    </message>
    <message>
        <source>Arguments:</source>
        <translation>Argumenti:</translation>
    </message>
</context>
<context>
    <name>QCupsJobWidget</name>
    <message>
        <source>Job</source>
        <translation>Posel</translation>
    </message>
    <message>
        <source>Job Control</source>
        <translation>Nadzor posla</translation>
    </message>
    <message>
        <source>Scheduled printing:</source>
        <translation>Razporejeno tiskanje:</translation>
    </message>
    <message>
        <source>Billing information:</source>
        <translation>Podatki za obračun:</translation>
    </message>
    <message>
        <source>Job priority:</source>
        <translation>Prednost posla:</translation>
    </message>
    <message>
        <source>Banner Pages</source>
        <translation>Naslovne strani</translation>
    </message>
    <message>
        <source>End:</source>
        <translation>Konec:</translation>
    </message>
    <message>
        <source>Start:</source>
        <translation>Začetek:</translation>
    </message>
    <message>
        <source>None</source>
        <translation>Brez</translation>
    </message>
    <message>
        <source>Print Immediately</source>
        <translation>Natisni takoj</translation>
    </message>
    <message>
        <source>Hold Indefinitely</source>
        <translation>Zadrži do preklica</translation>
    </message>
    <message>
        <source>Day (06:00 to 17:59)</source>
        <translation>Dan (od 6.00 do 17.59)</translation>
    </message>
    <message>
        <source>Night (18:00 to 05:59)</source>
        <translation>Noč (od 18.00 do 5.59)</translation>
    </message>
    <message>
        <source>Second Shift (16:00 to 23:59)</source>
        <translation>Druga izmena (od 16.00 do 23.59)</translation>
    </message>
    <message>
        <source>Third Shift (00:00 to 07:59)</source>
        <translation>Tretja izmena (od 0.00 do 7.59)</translation>
    </message>
    <message>
        <source>Weekend (Saturday to Sunday)</source>
        <translation>Konec tedna (sobota in nedelja)</translation>
    </message>
    <message>
        <source>Specific Time</source>
        <translation>Določen čas</translation>
    </message>
    <message>
        <source>Standard</source>
        <translation>Običajno</translation>
    </message>
    <message>
        <source>Unclassified</source>
        <translation>Brez stopnje tajnosti</translation>
    </message>
    <message>
        <source>Confidential</source>
        <translation>Zaupno</translation>
    </message>
    <message>
        <source>Classified</source>
        <translation>Interno</translation>
    </message>
    <message>
        <source>Secret</source>
        <translation>Tajno</translation>
    </message>
    <message>
        <source>Top Secret</source>
        <translation>Strogo tajno</translation>
    </message>
</context>
<context>
    <name>QCupsPrinterSupport</name>
    <message>
        <source>Authentication Needed</source>
        <translation>Potrebna je overitev</translation>
    </message>
    <message>
        <source>Authentication needed to use %1 on %2.</source>
        <translation>Za uporabo %1 na %2 je potrebna overitev.</translation>
    </message>
    <message>
        <source>Authentication needed to use %1.</source>
        <translation>Za uporabo %1 je potrebna overitev.</translation>
    </message>
    <message>
        <source>Username:</source>
        <translation>Uporabniško ime:</translation>
    </message>
    <message>
        <source>Password:</source>
        <translation>Geslo:</translation>
    </message>
</context>
<context>
    <name>QDBusTrayIcon</name>
    <message>
        <source>OK</source>
        <translation>V redu</translation>
    </message>
</context>
<context>
    <name>QDialog</name>
    <message>
        <source>What&apos;s This?</source>
        <translation>Kaj je to?</translation>
    </message>
</context>
<context>
    <name>QDialogButtonBox</name>
    <message>
        <source>OK</source>
        <translation>V redu</translation>
    </message>
</context>
<context>
    <name>QDockWidget</name>
    <message>
        <source>Float</source>
        <translation>Odpni</translation>
    </message>
    <message>
        <source>Undocks and re-attaches the dock widget</source>
        <translation>Odpne ali znova pripne ploščo</translation>
    </message>
    <message>
        <source>Close</source>
        <translation>Zapri</translation>
    </message>
    <message>
        <source>Closes the dock widget</source>
        <translation>Zapre ploščo</translation>
    </message>
</context>
<context>
    <name>QErrorMessage</name>
    <message>
        <source>Debug Message:</source>
        <translation>Razhroščevalno sporočilo:</translation>
    </message>
    <message>
        <source>Warning:</source>
        <translation>Opozorilo:</translation>
    </message>
    <message>
        <source>Fatal Error:</source>
        <translation>Usodna napaka:</translation>
    </message>
    <message>
        <source>Critical Error:</source>
        <translation>Kritična napaka:</translation>
    </message>
    <message>
        <source>Information:</source>
        <translation>Obvestilo:</translation>
    </message>
    <message>
        <source>&amp;Show this message again</source>
        <translation>&amp;Znova pokaži to sporočilo</translation>
    </message>
    <message>
        <source>&amp;OK</source>
        <translation>&amp;V redu</translation>
    </message>
</context>
<context>
    <name>QFile</name>
    <message>
        <source>Destination file is the same file.</source>
        <translation>Ciljna datoteka je ista datoteka.</translation>
    </message>
    <message>
        <source>Source file does not exist.</source>
        <translation>Izvorna datoteka ne obstaja.</translation>
    </message>
    <message>
        <source>Destination file exists</source>
        <translation>Ciljna datoteka že obstaja</translation>
    </message>
    <message>
        <source>Error while renaming: %1</source>
        <translation>Napaka pri preimenovanju: %1</translation>
    </message>
    <message>
        <source>Error while renaming.</source>
        <translation>Napaka pri preimenovanju.</translation>
    </message>
    <message>
        <source>Unable to restore from %1: %2</source>
        <translation>Obnovitev iz %1 ni mogoča: %2</translation>
    </message>
    <message>
        <source>Will not rename sequential file using block copy</source>
        <translation>Zaporedne datoteke ni mogoče preimenovati s kopiranjem blokov</translation>
    </message>
    <message>
        <source>Cannot remove source file</source>
        <translation>Izvorne datoteke ni mogoče odstraniti</translation>
    </message>
    <message>
        <source>Cannot open %1 for input</source>
        <translation>%1 ni mogoče odpreti za branje</translation>
    </message>
    <message>
        <source>Cannot open destination file: %1</source>
        <translation>Ciljne datoteke ni mogoče odpreti: %1</translation>
    </message>
    <message>
        <source>Cannot open for output: %1</source>
        <translation>Ni mogoče odpreti za pisanje: %1</translation>
    </message>
    <message>
        <source>Cannot open for output</source>
        <translation>Ni mogoče odpreti za pisanje</translation>
    </message>
    <message>
        <source>Failure to write block: %1</source>
        <translation>Bloka ni bilo mogoče zapisati: %1</translation>
    </message>
    <message>
        <source>Failure to write block</source>
        <translation>Bloka ni bilo mogoče zapisati</translation>
    </message>
    <message>
        <source>Cannot create %1 for output: %2</source>
        <translation>%1 ni mogoče ustvariti za pisanje: %2</translation>
    </message>
    <message>
        <source>Cannot create %1 for output</source>
        <translation>%1 ni mogoče ustvariti za pisanje</translation>
    </message>
</context>
<context>
    <name>QFileDevice</name>
    <message>
        <source>No file engine available</source>
        <translation>Na voljo ni pogona za datoteke</translation>
    </message>
    <message>
        <source>No file engine available or engine does not support UnMapExtension</source>
        <translation>Na voljo ni pogona za datoteke ali pa ne podpira UnMapExtension</translation>
    </message>
</context>
<context>
    <name>QFileDialog</name>
    <message>
        <source>Back</source>
        <translation>Nazaj</translation>
    </message>
    <message>
        <source>File</source>
        <translation>Datoteka</translation>
    </message>
    <message>
        <source>Open</source>
        <translation>Odpri</translation>
    </message>
    <message>
        <source>&amp;Open</source>
        <translation>&amp;Odpri</translation>
    </message>
    <message>
        <source>&amp;Save</source>
        <translation>&amp;Shrani</translation>
    </message>
    <message>
        <source>Drive</source>
        <translation>Pogon</translation>
    </message>
    <message>
        <source>Files</source>
        <translation>Datoteke</translation>
    </message>
    <message>
        <source>Show </source>
        <translation>Pokaži </translation>
    </message>
    <message>
        <source>&apos;%1&apos; is write protected.
Do you want to delete it anyway?</source>
        <translation>»%1« je zaščitena pred pisanjem.
Ali jo vseeno želite izbrisati?</translation>
    </message>
    <message>
        <source>Are you sure you want to delete &apos;%1&apos;?</source>
        <translation>Ali res želite izbrisati »%1«?</translation>
    </message>
    <message>
        <source>List of places and bookmarks</source>
        <translation>Seznam mest in zaznamkov</translation>
    </message>
    <message>
        <source>File &amp;name:</source>
        <translation>&amp;Ime datoteke:</translation>
    </message>
    <message>
        <source>Alt+Left</source>
        <translation>Alt+Left</translation>
    </message>
    <message>
        <source>Alt+Up</source>
        <translation>Alt+Up</translation>
    </message>
    <message>
        <source>Alt+Right</source>
        <translation>Alt+Right</translation>
    </message>
    <message>
        <source>Delete</source>
        <translation>Izbriši</translation>
    </message>
    <message>
        <source>New Folder</source>
        <translation>Nova mapa</translation>
    </message>
    <message>
        <source>File Folder</source>
        <translation>Mapa z datotekami</translation>
    </message>
    <message>
        <source>Folder</source>
        <translation>Mapa</translation>
    </message>
    <message>
        <source>Alias</source>
        <translation>Vzdevek</translation>
    </message>
    <message>
        <source>My Computer</source>
        <translation>Moj računalnik</translation>
    </message>
    <message>
        <source>%1 File</source>
        <translation>Datoteka %1</translation>
    </message>
    <message>
        <source>Parent Directory</source>
        <translation>Nadrejena mapa</translation>
    </message>
    <message>
        <source>&amp;New Folder</source>
        <translation>&amp;Nova mapa</translation>
    </message>
    <message>
        <source>Remove</source>
        <translation>Odstrani</translation>
    </message>
    <message>
        <source>Look in:</source>
        <translation>Poglej v:</translation>
    </message>
    <message>
        <source>Create a New Folder</source>
        <translation>Ustvari novo mapo</translation>
    </message>
    <message>
        <source>Files of type:</source>
        <translation>Vrsta datotek:</translation>
    </message>
    <message>
        <source>Find Directory</source>
        <translation>Poišči mapo</translation>
    </message>
    <message>
        <source>Show &amp;hidden files</source>
        <translation>Pokaži s&amp;krite datoteke</translation>
    </message>
    <message>
        <source>Save As</source>
        <translation>Shrani kot</translation>
    </message>
    <message>
        <source>%1
Directory not found.
Please verify the correct directory name was given.</source>
        <translation>%1
Mape ni mogoče najti.
Preverite, ali ste vnesli pravo ime mape.</translation>
    </message>
    <message>
        <source>Sidebar</source>
        <translation>Stranska vrstica</translation>
    </message>
    <message>
        <source>List View</source>
        <translation>Pogled seznama</translation>
    </message>
    <message>
        <source>&amp;Choose</source>
        <translation>Iz&amp;beri</translation>
    </message>
    <message>
        <source>&amp;Delete</source>
        <translation>I&amp;zbriši</translation>
    </message>
    <message>
        <source>All files (*)</source>
        <translation>Vse datoteke (*)</translation>
    </message>
    <message>
        <source>All Files (*)</source>
        <translation>Vse datoteke (*)</translation>
    </message>
    <message>
        <source>Directories</source>
        <translation>Mape</translation>
    </message>
    <message>
        <source>&amp;Rename</source>
        <translation>&amp;Preimenuj</translation>
    </message>
    <message>
        <source>Could not delete directory.</source>
        <translation>Mape ni bilo mogoče izbrisati.</translation>
    </message>
    <message>
        <source>Directory:</source>
        <translation>Mapa:</translation>
    </message>
    <message>
        <source>Unknown</source>
        <translation>Neznano</translation>
    </message>
    <message>
        <source>%1 already exists.
Do you want to replace it?</source>
        <translation>%1 že obstaja.
Ali jo želite zamenjati?</translation>
    </message>
    <message>
        <source>Forward</source>
        <translation>Naprej</translation>
    </message>
    <message>
        <source>Go forward</source>
        <translation>Pojdi naprej</translation>
    </message>
    <message>
        <source>Go to the parent directory</source>
        <translation>Pojdi v nadrejeno mapo</translation>
    </message>
    <message>
        <source>Recent Places</source>
        <translation>Nedavna mesta</translation>
    </message>
    <message>
        <source>Go back</source>
        <translation>Pojdi nazaj</translation>
    </message>
    <message>
        <source>Change to detail view mode</source>
        <translation>Preklopi v podrobni pogled</translation>
    </message>
    <message>
        <source>Create New Folder</source>
        <translation>Ustvari novo mapo</translation>
    </message>
    <message>
        <source>Shortcut</source>
        <translation>Bližnjica</translation>
    </message>
    <message>
        <source>Detail View</source>
        <translation>Podrobni pogled</translation>
    </message>
    <message>
        <source>%1
File not found.
Please verify the correct file name was given.</source>
        <translation>%1
Datoteke ni mogoče najti.
Preverite, ali ste vnesli pravo ime datoteke.</translation>
    </message>
    <message>
        <source>Change to list view mode</source>
        <translation>Preklopi v pogled seznama</translation>
    </message>
</context>
<context>
    <name>QFileSystemModel</name>
    <message>
        <source>Name</source>
        <translation>Ime</translation>
    </message>
    <message>
        <source>Size</source>
        <translation>Velikost</translation>
    </message>
    <message>
        <source>Type</source>
        <translation>Vrsta</translation>
    </message>
    <message>
        <source>Kind</source>
        <translation>Vrsta</translation>
    </message>
    <message>
        <source>Date Modified</source>
        <translation>Datum spremembe</translation>
    </message>
    <message>
        <source>Computer</source>
        <translation>Računalnik</translation>
    </message>
    <message>
        <source>My Computer</source>
        <translation>Moj računalnik</translation>
    </message>
    <message>
        <source>Invalid filename</source>
        <translation>Neveljavno ime datoteke</translation>
    </message>
    <message>
        <source>&lt;b&gt;The name &quot;%1&quot; cannot be used.&lt;/b&gt;&lt;p&gt;Try using another name, with fewer characters or no punctuation marks.</source>
        <translation>&lt;b&gt;Imena »%1« ni mogoče uporabiti.&lt;/b&gt;&lt;p&gt;Poskusite z drugim imenom, z manj znaki ali brez ločil.</translation>
    </message>
    <message>
        <source>&lt;b&gt;The name &quot;%1&quot; can not be used.&lt;/b&gt;&lt;p&gt;Try using another name, with fewer characters or no punctuations marks.</source>
        <translation>&lt;b&gt;Imena »%1« ni mogoče uporabiti.&lt;/b&gt;&lt;p&gt;Poskusite z drugim imenom, z manj znaki ali brez ločil.</translation>
    </message>
</context>
<context>
    <name>QGnomeTheme</name>
    <message>
        <source>&amp;OK</source>
        <translation>&amp;V redu</translation>
    </message>
    <message>
        <source>&amp;Save</source>
        <translation>&amp;Shrani</translation>
    </message>
    <message>
        <source>&amp;Cancel</source>
        <translation>&amp;Prekliči</translation>
    </message>
    <message>
        <source>&amp;Close</source>
        <translation>&amp;Zapri</translation>
    </message>
    <message>
        <source>Close without Saving</source>
        <translation>Zapri brez shranjevanja</translation>
    </message>
</context>
<context>
    <name>QGuiApplication</name>
    <message>
        <source>QT_LAYOUT_DIRECTION</source>
        <translation>LTR</translation>
    </message>
</context>
<context>
    <name>QIODevice</name>
    <message>
        <source>Permission denied</source>
        <translation>Dostop zavrnjen</translation>
    </message>
    <message>
        <source>Too many open files</source>
        <translation>Preveč odprtih datotek</translation>
    </message>
    <message>
        <source>No such file or directory</source>
        <translation>Ni take datoteke ali mape</translation>
    </message>
    <message>
        <source>No space left on device</source>
        <translation>Na napravi ni več prostora</translation>
    </message>
    <message>
        <source>file to open is a directory</source>
        <translation>datoteka, ki naj se odpre, je mapa</translation>
    </message>
    <message>
        <source>Unknown error</source>
        <translation>Neznana napaka</translation>
    </message>
</context>
<context>
    <name>QImageWriter</name>
    <message>
        <source>Unknown error</source>
        <translation>Neznana napaka</translation>
    </message>
    <message>
        <source>Device is not set</source>
        <translation>Naprava ni nastavljena</translation>
    </message>
    <message>
        <source>Cannot open device for writing: %1</source>
        <translation>Naprave ni mogoče odpreti za pisanje: %1</translation>
    </message>
    <message>
        <source>Device not writable</source>
        <translation>Na napravo ni mogoče pisati</translation>
    </message>
    <message>
        <source>Unsupported image format</source>
        <translation>Nepodprta vrsta slike</translation>
    </message>
    <message>
        <source>Image is empty</source>
        <translation>Slika je prazna</translation>
    </message>
</context>
<context>
    <name>QInputDialog</name>
    <message>
        <source>Enter a value:</source>
        <translation>Vnesite vrednost:</translation>
    </message>
</context>
<context>
    <name>QKeySequenceEdit</name>
    <message>
        <source>Press shortcut</source>
        <translation>Pritisnite bližnjico</translation>
    </message>
    <message>
        <source>%1, ...</source>
        <translation>%1, ...</translation>
    </message>
</context>
<context>
    <name>QLineEdit</name>
    <message>
        <source>&amp;Undo</source>
        <translation>&amp;Razveljavi</translation>
    </message>
    <message>
        <source>&amp;Redo</source>
        <translation>&amp;Znova uveljavi</translation>
    </message>
    <message>
        <source>Cu&amp;t</source>
        <translation>&amp;Izreži</translation>
    </message>
    <message>
        <source>&amp;Copy</source>
        <translation>&amp;Kopiraj</translation>
    </message>
    <message>
        <source>&amp;Paste</source>
        <translation>&amp;Prilepi</translation>
    </message>
    <message>
        <source>Delete</source>
        <translation>Izbriši</translation>
    </message>
    <message>
        <source>Select All</source>
        <translation>Izberi vse</translation>
    </message>
</context>
<context>
    <name>QMdiArea</name>
    <message>
        <source>(Untitled)</source>
        <translation>(Brez naslova)</translation>
    </message>
</context>
<context>
    <name>QMdiSubWindow</name>
    <message>
        <source>%1 - [%2]</source>
        <translation>%1 - [%2]</translation>
    </message>
    <message>
        <source>- [%1]</source>
        <translation>- [%1]</translation>
    </message>
    <message>
        <source>Close</source>
        <translation>Zapri</translation>
    </message>
    <message>
        <source>Minimize</source>
        <translation>Skrči</translation>
    </message>
    <message>
        <source>Restore Down</source>
        <translation>Obnovi navzdol</translation>
    </message>
    <message>
        <source>&amp;Restore</source>
        <translation>&amp;Obnovi</translation>
    </message>
    <message>
        <source>&amp;Move</source>
        <translation>&amp;Premakni</translation>
    </message>
    <message>
        <source>&amp;Size</source>
        <translation>&amp;Velikost</translation>
    </message>
    <message>
        <source>Mi&amp;nimize</source>
        <translation>&amp;Skrči</translation>
    </message>
    <message>
        <source>Ma&amp;ximize</source>
        <translation>&amp;Razpni</translation>
    </message>
    <message>
        <source>Stay on &amp;Top</source>
        <translation>Ostani na vr&amp;hu</translation>
    </message>
    <message>
        <source>&amp;Close</source>
        <translation>&amp;Zapri</translation>
    </message>
    <message>
        <source>Maximize</source>
        <translation>Razpni</translation>
    </message>
    <message>
        <source>Unshade</source>
        <translation>Odvij</translation>
    </message>
    <message>
        <source>Shade</source>
        <translation>Zvij</translation>
    </message>
    <message>
        <source>Restore</source>
        <translation>Obnovi</translation>
    </message>
    <message>
        <source>Help</source>
        <translation>Pomoč</translation>
    </message>
    <message>
        <source>Menu</source>
        <translation>Meni</translation>
    </message>
</context>
<context>
    <name>QMessageBox</name>
    <message>
        <source>OK</source>
        <translation>V redu</translation>
    </message>
    <message>
        <source>Help</source>
        <translation>Pomoč</translation>
    </message>
    <message>
        <source>Show Details...</source>
        <translation>Pokaži podrobnosti ...</translation>
    </message>
    <message>
        <source>Hide Details...</source>
        <translation>Skrij podrobnosti ...</translation>
    </message>
    <message>
        <source>About Qt</source>
        <translation>O Qt</translation>
    </message>
    <message>
        <source>&lt;h3&gt;About Qt&lt;/h3&gt;&lt;p&gt;This program uses Qt version %1.&lt;/p&gt;</source>
        <translation>&lt;h3&gt;O Qt&lt;/h3&gt;&lt;p&gt;Ta program uporablja Qt, različica %1.&lt;/p&gt;</translation>
    </message>
    <message>
        <source>&lt;p&gt;Qt is a C++ toolkit for cross-platform application development.&lt;/p&gt;&lt;p&gt;Qt provides single-source portability across all major desktop operating systems. It is also available for embedded Linux and other embedded and mobile operating systems.&lt;/p&gt;&lt;p&gt;Qt is available under multiple licensing options designed to accommodate the needs of our various users.&lt;/p&gt;&lt;p&gt;Qt licensed under our commercial license agreement is appropriate for development of proprietary/commercial software where you do not want to share any source code with third parties or otherwise cannot comply with the terms of GNU (L)GPL.&lt;/p&gt;&lt;p&gt;Qt licensed under GNU (L)GPL is appropriate for the development of Qt&amp;nbsp;applications provided you can comply with the terms and conditions of the respective licenses.&lt;/p&gt;&lt;p&gt;Please see &lt;a href=&quot;http://%2/&quot;&gt;%2&lt;/a&gt; for an overview of Qt licensing.&lt;/p&gt;&lt;p&gt;Copyright (C) %1 The Qt Company Ltd and other contributors.&lt;/p&gt;&lt;p&gt;Qt and the Qt logo are trademarks of The Qt Company Ltd.&lt;/p&gt;&lt;p&gt;Qt is The Qt Company Ltd product developed as an open source project. See &lt;a href=&quot;http://%3/&quot;&gt;%3&lt;/a&gt; for more information.&lt;/p&gt;</source>
        <translation>&lt;p&gt;Qt je zbirka orodij C++ za razvoj programov za več okolij.&lt;/p&gt;&lt;p&gt;Qt omogoča eno izvorno kodo za vse pomembnejše namizne operacijske sisteme. Na voljo je tudi za vgrajeni Linux ter druge vgrajene in mobilne operacijske sisteme.&lt;/p&gt;&lt;p&gt;Qt je na voljo pod več licencami, da ustreza potrebam različnih uporabnikov.&lt;/p&gt;&lt;p&gt;Qt s komercialno licenco je primeren za razvoj lastniških in komercialnih programov, kadar izvorne kode ne želite deliti z drugimi ali kako drugače ne morete izpolniti pogojev licence GNU (L)GPL.&lt;/p&gt;&lt;p&gt;Qt z licenco GNU (L)GPL je primeren za razvoj programov&amp;nbsp;Qt, če lahko izpolnite določila in pogoje teh licenc.&lt;/p&gt;&lt;p&gt;Pregled licenc za Qt je na naslovu &lt;a href=&quot;http://%2/&quot;&gt;%2&lt;/a&gt;.&lt;/p&gt;&lt;p&gt;Avtorske pravice (C) %1 The Qt Company Ltd in drugi sodelavci.&lt;/p&gt;&lt;p&gt;Qt in logotip Qt sta blagovni znamki družbe The Qt Company Ltd.&lt;/p&gt;&lt;p&gt;Qt je izdelek družbe The Qt Company Ltd, razvijan kot odprtokodni projekt. Več o tem na &lt;a href=&quot;http://%3/&quot;&gt;%3&lt;/a&gt;.&lt;/p&gt;</translation>
    </message>
</context>
<context>
    <name>QPPDOptionsModel</name>
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
    <name>QPageSetupWidget</name>
    <message>
        <source>Form</source>
        <translation>Obrazec</translation>
    </message>
    <message>
        <source>Paper</source>
        <translation>Papir</translation>
    </message>
    <message>
        <source>Page size:</source>
        <translation>Velikost strani:</translation>
    </message>
    <message>
        <source>Width:</source>
        <translation>Širina:</translation>
    </message>
    <message>
        <source>Height:</source>
        <translation>Višina:</translation>
    </message>
    <message>
        <source>Paper source:</source>
        <translation>Vir papirja:</translation>
    </message>
    <message>
        <source>Orientation</source>
        <translation>Usmerjenost</translation>
    </message>
    <message>
        <source>Portrait</source>
        <translation>Pokončno</translation>
    </message>
    <message>
        <source>Landscape</source>
        <translation>Ležeče</translation>
    </message>
    <message>
        <source>Reverse landscape</source>
        <translation>Obrnjeno ležeče</translation>
    </message>
    <message>
        <source>Reverse portrait</source>
        <translation>Obrnjeno pokončno</translation>
    </message>
    <message>
        <source>Margins</source>
        <translation>Robovi</translation>
    </message>
    <message>
        <source>top margin</source>
        <translation>zgornji rob</translation>
    </message>
    <message>
        <source>left margin</source>
        <translation>levi rob</translation>
    </message>
    <message>
        <source>right margin</source>
        <translation>desni rob</translation>
    </message>
    <message>
        <source>bottom margin</source>
        <translation>spodnji rob</translation>
    </message>
    <message>
        <source>Page Layout</source>
        <translation>Postavitev strani</translation>
    </message>
    <message>
        <source>Page order:</source>
        <translation>Vrstni red strani:</translation>
    </message>
    <message>
        <source>Pages per sheet:</source>
        <translation>Strani na list:</translation>
    </message>
    <message>
        <source>mm</source>
        <translation>mm</translation>
    </message>
    <message>
        <source>pt</source>
        <translation>pt</translation>
    </message>
    <message>
        <source>in</source>
        <translation>in</translation>
    </message>
    <message>
        <source>P̸</source>
        <translation>P̸</translation>
    </message>
    <message>
        <source>DD</source>
        <translation>DD</translation>
    </message>
    <message>
        <source>CC</source>
        <translation>CC</translation>
    </message>
    <message>
        <source>Custom</source>
        <translation>Po meri</translation>
    </message>
    <message>
        <source>Millimeters (mm)</source>
        <translation>Milimetri (mm)</translation>
    </message>
    <message>
        <source>Centimeters (cm)</source>
        <translation>Centimetri (cm)</translation>
    </message>
    <message>
        <source>Inches (in)</source>
        <translation>Palci (in)</translation>
    </message>
    <message>
        <source>Points (pt)</source>
        <translation>Pike (pt)</translation>
    </message>
    <message>
        <source>Pica (P̸)</source>
        <translation>Pika (P̸)</translation>
    </message>
    <message>
        <source>Didot (DD)</source>
        <translation>Didot (DD)</translation>
    </message>
    <message>
        <source>Cicero (CC)</source>
        <translation>Cicero (CC)</translation>
    </message>
</context>
<context>
    <name>QPageSize</name>
    <message>
        <source>Custom</source>
        <translation>Po meri</translation>
    </message>
    <message>
        <source>%1 x %2 in</source>
        <translation>%1 × %2 in</translation>
    </message>
    <message>
        <source>Custom (%1in x %2in)</source>
        <translation>Po meri (%1 in × %2 in)</translation>
    </message>
    <message>
        <source>Custom (%1mm x %2mm)</source>
        <translation>Po meri (%1 mm × %2 mm)</translation>
    </message>
    <message>
        <source>Custom (%1CC x %2CC)</source>
        <translation>Po meri (%1 CC × %2 CC)</translation>
    </message>
    <message>
        <source>Custom (%1DD x %2DD)</source>
        <translation>Po meri (%1 DD × %2 DD)</translation>
    </message>
    <message>
        <source>Custom (%1pc x %2pc)</source>
        <translation>Po meri (%1 pc × %2 pc)</translation>
    </message>
    <message>
        <source>Custom (%1pt x %2pt)</source>
        <translation>Po meri (%1 pt × %2 pt)</translation>
    </message>
    <message>
        <source>Postcard</source>
        <translation>Razglednica</translation>
    </message>
    <message>
        <source>Double Postcard</source>
        <translation>Dvojna razglednica</translation>
    </message>
    <message>
        <source>Note</source>
        <translation>Listek</translation>
    </message>
    <message>
        <source>Statement</source>
        <translation>Izpisek</translation>
    </message>
    <message>
        <source>Envelope Italian</source>
        <translation>Ovojnica, italijanska</translation>
    </message>
    <message>
        <source>Envelope Personal</source>
        <translation>Ovojnica, osebna</translation>
    </message>
    <message>
        <source>Envelope Invite</source>
        <translation>Ovojnica za vabilo</translation>
    </message>
    <message>
        <source>Fan-fold US (14.875 x 11 in)</source>
        <translation>Neskončni papir ZDA (14,875 × 11 in)</translation>
    </message>
    <message>
        <source>Fan-fold German (8.5 x 12 in)</source>
        <translation>Neskončni papir, nemški (8,5 × 12 in)</translation>
    </message>
    <message>
        <source>Fan-fold German Legal (8.5 x 13 in)</source>
        <translation>Neskončni papir, nemški Legal (8,5 × 13 in)</translation>
    </message>
    <message>
        <source>Executive (7.5 x 10 in)</source>
        <translation>Executive (7,5 × 10 in)</translation>
    </message>
    <message>
        <source>Executive (7.25 x 10.5 in)</source>
        <translation>Executive (7,25 × 10,5 in)</translation>
    </message>
    <message>
        <source>Folio (8.27 x 13 in)</source>
        <translation>Folio (8,27 × 13 in)</translation>
    </message>
    <message>
        <source>PRC 32K Big</source>
        <translation>PRC 32K, velik</translation>
    </message>
    <message>
        <source>A4 Extra</source>
        <translation>A4 dodatno</translation>
    </message>
    <message>
        <source>A3 Extra</source>
        <translation>A3 dodatno</translation>
    </message>
    <message>
        <source>A5 Extra</source>
        <translation>A5 dodatno</translation>
    </message>
    <message>
        <source>B5 Extra</source>
        <translation>B5 dodatno</translation>
    </message>
    <message>
        <source>Letter Extra</source>
        <translation>Letter dodatno</translation>
    </message>
    <message>
        <source>Tabloid Extra</source>
        <translation>Tabloid dodatno</translation>
    </message>
    <message>
        <source>Legal Extra</source>
        <translation>Legal dodatno</translation>
    </message>
    <message>
        <source>A4 Small</source>
        <translation>A4 malo</translation>
    </message>
    <message>
        <source>A4 Plus</source>
        <translation>A4 plus</translation>
    </message>
    <message>
        <source>Letter Small</source>
        <translation>Letter malo</translation>
    </message>
    <message>
        <source>Letter Plus</source>
        <translation>Letter plus</translation>
    </message>
    <message>
        <source>Architect A</source>
        <translation>Arhitekturni A</translation>
    </message>
    <message>
        <source>Architect B</source>
        <translation>Arhitekturni B</translation>
    </message>
    <message>
        <source>Architect C</source>
        <translation>Arhitekturni C</translation>
    </message>
    <message>
        <source>Architect D</source>
        <translation>Arhitekturni D</translation>
    </message>
    <message>
        <source>Architect E</source>
        <translation>Arhitekturni E</translation>
    </message>
    <message>
        <source>Envelope B4</source>
        <translation>Ovojnica B4</translation>
    </message>
    <message>
        <source>Envelope B5</source>
        <translation>Ovojnica B5</translation>
    </message>
    <message>
        <source>Envelope B6</source>
        <translation>Ovojnica B6</translation>
    </message>
    <message>
        <source>Envelope C0</source>
        <translation>Ovojnica C0</translation>
    </message>
    <message>
        <source>Envelope C1</source>
        <translation>Ovojnica C1</translation>
    </message>
    <message>
        <source>Envelope C2</source>
        <translation>Ovojnica C2</translation>
    </message>
    <message>
        <source>Envelope C3</source>
        <translation>Ovojnica C3</translation>
    </message>
    <message>
        <source>Envelope C4</source>
        <translation>Ovojnica C4</translation>
    </message>
    <message>
        <source>Envelope C5</source>
        <translation>Ovojnica C5</translation>
    </message>
    <message>
        <source>Envelope C6</source>
        <translation>Ovojnica C6</translation>
    </message>
    <message>
        <source>Envelope C7</source>
        <translation>Ovojnica C7</translation>
    </message>
    <message>
        <source>Envelope C65</source>
        <translation>Ovojnica C65</translation>
    </message>
    <message>
        <source>Envelope DL</source>
        <translation>Ovojnica DL</translation>
    </message>
    <message>
        <source>Envelope Monarch</source>
        <translation>Ovojnica Monarch</translation>
    </message>
    <message>
        <source>Envelope US 9</source>
        <translation>Ovojnica US 9</translation>
    </message>
    <message>
        <source>Envelope US 10</source>
        <translation>Ovojnica US 10</translation>
    </message>
    <message>
        <source>Envelope US 11</source>
        <translation>Ovojnica US 11</translation>
    </message>
    <message>
        <source>Envelope US 12</source>
        <translation>Ovojnica US 12</translation>
    </message>
    <message>
        <source>Envelope US 14</source>
        <translation>Ovojnica US 14</translation>
    </message>
    <message>
        <source>Envelope PRC 1</source>
        <translation>Ovojnica PRC 1</translation>
    </message>
    <message>
        <source>Envelope PRC 2</source>
        <translation>Ovojnica PRC 2</translation>
    </message>
    <message>
        <source>Envelope PRC 3</source>
        <translation>Ovojnica PRC 3</translation>
    </message>
    <message>
        <source>Envelope PRC 4</source>
        <translation>Ovojnica PRC 4</translation>
    </message>
    <message>
        <source>Envelope PRC 5</source>
        <translation>Ovojnica PRC 5</translation>
    </message>
    <message>
        <source>Envelope PRC 6</source>
        <translation>Ovojnica PRC 6</translation>
    </message>
    <message>
        <source>Envelope PRC 7</source>
        <translation>Ovojnica PRC 7</translation>
    </message>
    <message>
        <source>Envelope PRC 8</source>
        <translation>Ovojnica PRC 8</translation>
    </message>
    <message>
        <source>Envelope PRC 9</source>
        <translation>Ovojnica PRC 9</translation>
    </message>
    <message>
        <source>Envelope PRC 10</source>
        <translation>Ovojnica PRC 10</translation>
    </message>
    <message>
        <source>Envelope Chou 3</source>
        <translation>Ovojnica Chou 3</translation>
    </message>
    <message>
        <source>Envelope Chou 4</source>
        <translation>Ovojnica Chou 4</translation>
    </message>
    <message>
        <source>Envelope Kaku 2</source>
        <translation>Ovojnica Kaku 2</translation>
    </message>
    <message>
        <source>Envelope Kaku 3</source>
        <translation>Ovojnica Kaku 3</translation>
    </message>
    <message>
        <source>Envelope You 4</source>
        <translation>Ovojnica You 4</translation>
    </message>
</context>
<context>
    <name>QPlatformTheme</name>
    <message>
        <source>OK</source>
        <translation>V redu</translation>
    </message>
    <message>
        <source>Save</source>
        <translation>Shrani</translation>
    </message>
    <message>
        <source>Save All</source>
        <translation>Shrani vse</translation>
    </message>
    <message>
        <source>Open</source>
        <translation>Odpri</translation>
    </message>
    <message>
        <source>&amp;Yes</source>
        <translation>&amp;Da</translation>
    </message>
    <message>
        <source>Yes to &amp;All</source>
        <translation>Da za &amp;vse</translation>
    </message>
    <message>
        <source>&amp;No</source>
        <translation>&amp;Ne</translation>
    </message>
    <message>
        <source>N&amp;o to All</source>
        <translation>N&amp;e za vse</translation>
    </message>
    <message>
        <source>Abort</source>
        <translation>Prekini</translation>
    </message>
    <message>
        <source>Retry</source>
        <translation>Poskusi znova</translation>
    </message>
    <message>
        <source>Ignore</source>
        <translation>Prezri</translation>
    </message>
    <message>
        <source>Close</source>
        <translation>Zapri</translation>
    </message>
    <message>
        <source>Cancel</source>
        <translation>Prekliči</translation>
    </message>
    <message>
        <source>Discard</source>
        <translation>Zavrzi</translation>
    </message>
    <message>
        <source>Help</source>
        <translation>Pomoč</translation>
    </message>
    <message>
        <source>Apply</source>
        <translation>Uveljavi</translation>
    </message>
    <message>
        <source>Reset</source>
        <translation>Ponastavi</translation>
    </message>
    <message>
        <source>Restore Defaults</source>
        <translation>Obnovi privzeto</translation>
    </message>
</context>
<context>
    <name>QPrintDialog</name>
    <message>
        <source>OK</source>
        <translation>V redu</translation>
    </message>
    <message>
        <source>Print</source>
        <translation>Natisni</translation>
    </message>
    <message>
        <source>&amp;Print</source>
        <translation>&amp;Natisni</translation>
    </message>
    <message>
        <source>&amp;Options &gt;&gt;</source>
        <translation>&amp;Možnosti &gt;&gt;</translation>
    </message>
    <message>
        <source>&amp;Options &lt;&lt;</source>
        <translation>Mo&amp;žnosti &lt;&lt;</translation>
    </message>
    <message>
        <source>Print to File (PDF)</source>
        <translation>Natisni v datoteko (PDF)</translation>
    </message>
    <message>
        <source>Local file</source>
        <translation>Krajevna datoteka</translation>
    </message>
    <message>
        <source>Write PDF file</source>
        <translation>Zapiši datoteko PDF</translation>
    </message>
    <message>
        <source>Print To File ...</source>
        <translation>Natisni v datoteko ...</translation>
    </message>
    <message>
        <source>%1 is a directory.
Please choose a different file name.</source>
        <translation>%1 je mapa.
Izberite drugo ime datoteke.</translation>
    </message>
    <message>
        <source>File %1 is not writable.
Please choose a different file name.</source>
        <translation>V datoteko %1 ni mogoče pisati.
Izberite drugo ime datoteke.</translation>
    </message>
    <message>
        <source>%1 already exists.
Do you want to overwrite it?</source>
        <translation>%1 že obstaja.
Ali jo želite prepisati?</translation>
    </message>
    <message>
        <source>Options &apos;Pages Per Sheet&apos; and &apos;Page Set&apos; cannot be used together.
Please turn one of those options off.</source>
        <translation>Možnosti »Strani na list« in »Nabor strani« ni mogoče uporabiti hkrati.
Eno od njiju izključite.</translation>
    </message>
    <message>
        <source>The &apos;From&apos; value cannot be greater than the &apos;To&apos; value.</source>
        <translation>Vrednost »od« ne sme biti večja od vrednosti »do«.</translation>
    </message>
    <message>
        <source>Duplex Settings Conflicts</source>
        <translation>Neskladne nastavitve obojestranskega tiskanja</translation>
    </message>
    <message>
        <source>There are conflicts in duplex settings. Do you want to fix them?</source>
        <translation>Nastavitve obojestranskega tiskanja so neskladne. Ali jih želite popraviti?</translation>
    </message>
    <message>
        <source>Invalid Pages Definition</source>
        <translation>Neveljaven seznam strani</translation>
    </message>
    <message>
        <source>%1 does not follow the correct syntax. Please use &apos;,&apos; to separate ranges and pages, &apos;-&apos; to define ranges and make sure ranges do not intersect with each other.</source>
        <translation>%1 ni pravilno zapisano. Obsege in strani ločite z vejico »,«, obsege zapišite z vezajem »-« in pazite, da se ne prekrivajo.</translation>
    </message>
    <message>
        <source>Automatic</source>
        <translation>Samodejno</translation>
    </message>
    <message>
        <source>All Pages</source>
        <translation>Vse strani</translation>
    </message>
    <message>
        <source>Odd Pages</source>
        <translation>Lihe strani</translation>
    </message>
    <message>
        <source>Even Pages</source>
        <translation>Sode strani</translation>
    </message>
    <message>
        <source>Custom</source>
        <translation>Po meri</translation>
    </message>
    <message>
        <source>Left to Right, Top to Bottom</source>
        <translation>Od leve proti desni, od zgoraj navzdol</translation>
    </message>
    <message>
        <source>Left to Right, Bottom to Top</source>
        <translation>Od leve proti desni, od spodaj navzgor</translation>
    </message>
    <message>
        <source>Right to Left, Bottom to Top</source>
        <translation>Od desne proti levi, od spodaj navzgor</translation>
    </message>
    <message>
        <source>Right to Left, Top to Bottom</source>
        <translation>Od desne proti levi, od zgoraj navzdol</translation>
    </message>
    <message>
        <source>Bottom to Top, Left to Right</source>
        <translation>Od spodaj navzgor, od leve proti desni</translation>
    </message>
    <message>
        <source>Bottom to Top, Right to Left</source>
        <translation>Od spodaj navzgor, od desne proti levi</translation>
    </message>
    <message>
        <source>Top to Bottom, Left to Right</source>
        <translation>Od zgoraj navzdol, od leve proti desni</translation>
    </message>
    <message>
        <source>Top to Bottom, Right to Left</source>
        <translation>Od zgoraj navzdol, od desne proti levi</translation>
    </message>
    <message>
        <source>1 (1x1)</source>
        <translation>1 (1 × 1)</translation>
    </message>
    <message>
        <source>2 (2x1)</source>
        <translation>2 (2 × 1)</translation>
    </message>
    <message>
        <source>4 (2x2)</source>
        <translation>4 (2 × 2)</translation>
    </message>
    <message>
        <source>6 (2x3)</source>
        <translation>6 (2 × 3)</translation>
    </message>
    <message>
        <source>9 (3x3)</source>
        <translation>9 (3 × 3)</translation>
    </message>
    <message>
        <source>16 (4x4)</source>
        <translation>16 (4 × 4)</translation>
    </message>
</context>
<context>
    <name>QPrintPreviewDialog</name>
    <message>
        <source>%1%</source>
        <translation>%1 %</translation>
    </message>
    <message>
        <source>Print Preview</source>
        <translation>Predogled tiskanja</translation>
    </message>
    <message>
        <source>Print</source>
        <translation>Natisni</translation>
    </message>
    <message>
        <source>Fit page</source>
        <translation>Prilagodi strani</translation>
    </message>
    <message>
        <source>Zoom in</source>
        <translation>Povečaj</translation>
    </message>
    <message>
        <source>Zoom out</source>
        <translation>Pomanjšaj</translation>
    </message>
    <message>
        <source>Landscape</source>
        <translation>Ležeče</translation>
    </message>
    <message>
        <source>Portrait</source>
        <translation>Pokončno</translation>
    </message>
    <message>
        <source>Fit width</source>
        <translation>Prilagodi širini</translation>
    </message>
    <message>
        <source>Page Setup</source>
        <translation>Nastavitev strani</translation>
    </message>
    <message>
        <source>Page setup</source>
        <translation>Nastavitev strani</translation>
    </message>
    <message>
        <source>Show overview of all pages</source>
        <translation>Pokaži pregled vseh strani</translation>
    </message>
    <message>
        <source>First page</source>
        <translation>Prva stran</translation>
    </message>
    <message>
        <source>Last page</source>
        <translation>Zadnja stran</translation>
    </message>
    <message>
        <source>Show single page</source>
        <translation>Pokaži eno stran</translation>
    </message>
    <message>
        <source>Export to PDF</source>
        <translation>Izvozi v PDF</translation>
    </message>
    <message>
        <source>Previous page</source>
        <translation>Prejšnja stran</translation>
    </message>
    <message>
        <source>Next page</source>
        <translation>Naslednja stran</translation>
    </message>
    <message>
        <source>Show facing pages</source>
        <translation>Pokaži nasprotni strani</translation>
    </message>
</context>
<context>
    <name>QPrintPropertiesDialog</name>
    <message>
        <source>Printer Properties</source>
        <translation>Lastnosti tiskalnika</translation>
    </message>
    <message>
        <source>Job Options</source>
        <translation>Možnosti posla</translation>
    </message>
    <message>
        <source>Page Setup Conflicts</source>
        <translation>Neskladna nastavitev strani</translation>
    </message>
    <message>
        <source>There are conflicts in page setup options. Do you want to fix them?</source>
        <translation>Nastavitve strani so neskladne. Ali jih želite popraviti?</translation>
    </message>
    <message>
        <source>Advanced Option Conflicts</source>
        <translation>Neskladne napredne možnosti</translation>
    </message>
    <message>
        <source>There are conflicts in some advanced options. Do you want to fix them?</source>
        <translation>Nekatere napredne možnosti so neskladne. Ali jih želite popraviti?</translation>
    </message>
</context>
<context>
    <name>QPrintPropertiesWidget</name>
    <message>
        <source>Form</source>
        <translation>Obrazec</translation>
    </message>
    <message>
        <source>Page</source>
        <translation>Stran</translation>
    </message>
    <message>
        <source>Advanced</source>
        <translation>Napredno</translation>
    </message>
    <message>
        <source>There are conflicts in some options. Please fix them.</source>
        <translation>Nekatere možnosti so neskladne. Popravite jih.</translation>
    </message>
</context>
<context>
    <name>QPrintSettingsOutput</name>
    <message>
        <source>Form</source>
        <translation>Obrazec</translation>
    </message>
    <message>
        <source>Copies</source>
        <translation>Kopije</translation>
    </message>
    <message>
        <source>Print range</source>
        <translation>Obseg tiskanja</translation>
    </message>
    <message>
        <source>Print all</source>
        <translation>Natisni vse</translation>
    </message>
    <message>
        <source>Pages from</source>
        <translation>Strani od</translation>
    </message>
    <message>
        <source>to</source>
        <translation>do</translation>
    </message>
    <message>
        <source>Pages</source>
        <translation>Strani</translation>
    </message>
    <message>
        <source>Current Page</source>
        <translation>Trenutna stran</translation>
    </message>
    <message>
        <source>Selection</source>
        <translation>Izbor</translation>
    </message>
    <message>
        <source>Page Set:</source>
        <translation>Nabor strani:</translation>
    </message>
    <message>
        <source>Output Settings</source>
        <translation>Nastavitve izhoda</translation>
    </message>
    <message>
        <source>Copies:</source>
        <translation>Kopije:</translation>
    </message>
    <message>
        <source>Collate</source>
        <translation>Zberi</translation>
    </message>
    <message>
        <source>Reverse</source>
        <translation>Obratno</translation>
    </message>
    <message>
        <source>Options</source>
        <translation>Možnosti</translation>
    </message>
    <message>
        <source>Color Mode</source>
        <translation>Barvni način</translation>
    </message>
    <message>
        <source>Color</source>
        <translation>Barvno</translation>
    </message>
    <message>
        <source>Grayscale</source>
        <translation>Sivine</translation>
    </message>
    <message>
        <source>Duplex Printing</source>
        <translation>Obojestransko tiskanje</translation>
    </message>
    <message>
        <source>Double Sided Printing</source>
        <translation>Obojestransko tiskanje</translation>
    </message>
    <message>
        <source>None</source>
        <translation>Brez</translation>
    </message>
    <message>
        <source>Off</source>
        <translation>Izključeno</translation>
    </message>
    <message>
        <source>Long side</source>
        <translation>Daljša stranica</translation>
    </message>
    <message>
        <source>Short side</source>
        <translation>Krajša stranica</translation>
    </message>
    <message>
        <source>Long side binding</source>
        <translation>Vezava po daljši stranici</translation>
    </message>
    <message>
        <source>Short side binding</source>
        <translation>Vezava po krajši stranici</translation>
    </message>
    <message>
        <source>Specify pages or ranges separated by commas. Ranges are specified by two numbers separated by a hyphen. E.g: 3,5-7,9 prints pages 3, 5, 6, 7 and 9.</source>
        <translation>Strani ali obsege ločite z vejicami. Obseg sta dve števili z vezajem med njima. Zgled: 3,5-7,9 natisne strani 3, 5, 6, 7 in 9.</translation>
    </message>
</context>
<context>
    <name>QPrintWidget</name>
    <message>
        <source>Form</source>
        <translation>Obrazec</translation>
    </message>
    <message>
        <source>Printer</source>
        <translation>Tiskalnik</translation>
    </message>
    <message>
        <source>&amp;Name:</source>
        <translation>&amp;Ime:</translation>
    </message>
    <message>
        <source>P&amp;roperties</source>
        <translation>&amp;Lastnosti</translation>
    </message>
    <message>
        <source>Location:</source>
        <translation>Mesto:</translation>
    </message>
    <message>
        <source>Preview</source>
        <translation>Predogled</translation>
    </message>
    <message>
        <source>Type:</source>
        <translation>Vrsta:</translation>
    </message>
    <message>
        <source>Output &amp;file:</source>
        <translation>Izhodna &amp;datoteka:</translation>
    </message>
    <message>
        <source>...</source>
        <translation>...</translation>
    </message>
</context>
<context>
    <name>QProgressDialog</name>
    <message>
        <source>Cancel</source>
        <translation>Prekliči</translation>
    </message>
</context>
<context>
    <name>QSaveFile</name>
    <message>
        <source>Existing file %1 is not writable</source>
        <translation>V obstoječo datoteko %1 ni mogoče pisati</translation>
    </message>
    <message>
        <source>Filename refers to a directory</source>
        <translation>Ime datoteke pripada mapi</translation>
    </message>
    <message>
        <source>Writing canceled by application</source>
        <translation>Program je preklical pisanje</translation>
    </message>
</context>
<context>
    <name>QScrollBar</name>
    <message>
        <source>Scroll here</source>
        <translation>Drsi sem</translation>
    </message>
    <message>
        <source>Left edge</source>
        <translation>Levi rob</translation>
    </message>
    <message>
        <source>Top</source>
        <translation>Vrh</translation>
    </message>
    <message>
        <source>Right edge</source>
        <translation>Desni rob</translation>
    </message>
    <message>
        <source>Bottom</source>
        <translation>Dno</translation>
    </message>
    <message>
        <source>Page left</source>
        <translation>Stran levo</translation>
    </message>
    <message>
        <source>Page up</source>
        <translation>Stran gor</translation>
    </message>
    <message>
        <source>Page right</source>
        <translation>Stran desno</translation>
    </message>
    <message>
        <source>Page down</source>
        <translation>Stran dol</translation>
    </message>
    <message>
        <source>Scroll left</source>
        <translation>Drsi levo</translation>
    </message>
    <message>
        <source>Scroll up</source>
        <translation>Drsi gor</translation>
    </message>
    <message>
        <source>Scroll right</source>
        <translation>Drsi desno</translation>
    </message>
    <message>
        <source>Scroll down</source>
        <translation>Drsi dol</translation>
    </message>
</context>
<context>
    <name>QShortcut</name>
    <message>
        <source>Space</source>
        <translation>Preslednica</translation>
    </message>
    <message>
        <source>Esc</source>
        <translation>Esc</translation>
    </message>
    <message>
        <source>Escape</source>
        <translation>Escape</translation>
    </message>
    <message>
        <source>Tab</source>
        <translation>Tab</translation>
    </message>
    <message>
        <source>Backtab</source>
        <translation>Shift+Tab</translation>
    </message>
    <message>
        <source>Backspace</source>
        <translation>Vračalka</translation>
    </message>
    <message>
        <source>Return</source>
        <translation>Vnašalka</translation>
    </message>
    <message>
        <source>Enter</source>
        <translation>Enter</translation>
    </message>
    <message>
        <source>Ins</source>
        <translation>Ins</translation>
    </message>
    <message>
        <source>Insert</source>
        <translation>Insert</translation>
    </message>
    <message>
        <source>Del</source>
        <translation>Del</translation>
    </message>
    <message>
        <source>Delete</source>
        <translation>Delete</translation>
    </message>
    <message>
        <source>Pause</source>
        <translation>Pause</translation>
    </message>
    <message>
        <source>Print</source>
        <translation>Print</translation>
    </message>
    <message>
        <source>SysReq</source>
        <translation>SysReq</translation>
    </message>
    <message>
        <source>Home</source>
        <translation>Home</translation>
    </message>
    <message>
        <source>End</source>
        <translation>End</translation>
    </message>
    <message>
        <source>Left</source>
        <translation>Levo</translation>
    </message>
    <message>
        <source>Up</source>
        <translation>Gor</translation>
    </message>
    <message>
        <source>Right</source>
        <translation>Desno</translation>
    </message>
    <message>
        <source>Down</source>
        <translation>Dol</translation>
    </message>
    <message>
        <source>PgUp</source>
        <translation>PgUp</translation>
    </message>
    <message>
        <source>PgDown</source>
        <translation>PgDown</translation>
    </message>
    <message>
        <source>Page Up</source>
        <translation>Page Up</translation>
    </message>
    <message>
        <source>Page Down</source>
        <translation>Page Down</translation>
    </message>
    <message>
        <source>CapsLock</source>
        <translation>CapsLock</translation>
    </message>
    <message>
        <source>Caps Lock</source>
        <translation>Caps Lock</translation>
    </message>
    <message>
        <source>NumLock</source>
        <translation>NumLock</translation>
    </message>
    <message>
        <source>Num Lock</source>
        <translation>Num Lock</translation>
    </message>
    <message>
        <source>Number Lock</source>
        <translation>Number Lock</translation>
    </message>
    <message>
        <source>ScrollLock</source>
        <translation>ScrollLock</translation>
    </message>
    <message>
        <source>Scroll Lock</source>
        <translation>Scroll Lock</translation>
    </message>
    <message>
        <source>Print Screen</source>
        <translation>Print Screen</translation>
    </message>
    <message>
        <source>System Request</source>
        <translation>System Request</translation>
    </message>
    <message>
        <source>Menu</source>
        <translation>Meni</translation>
    </message>
    <message>
        <source>Help</source>
        <translation>Pomoč</translation>
    </message>
    <message>
        <source>Ctrl</source>
        <translation>Ctrl</translation>
    </message>
    <message>
        <source>Control</source>
        <translation>Ctrl</translation>
    </message>
    <message>
        <source>Alt</source>
        <translation>Alt</translation>
    </message>
    <message>
        <source>Shift</source>
        <translation>Shift</translation>
    </message>
    <message>
        <source>Meta</source>
        <translation>Meta</translation>
    </message>
    <message>
        <source>Num</source>
        <translation>Num</translation>
    </message>
    <message>
        <source>+</source>
        <translation>+</translation>
    </message>
    <message>
        <source>F%1</source>
        <translation>F%1</translation>
    </message>
    <message>
        <source>Back</source>
        <translation>Nazaj</translation>
    </message>
    <message>
        <source>Forward</source>
        <translation>Naprej</translation>
    </message>
    <message>
        <source>Stop</source>
        <translation>Ustavi</translation>
    </message>
    <message>
        <source>Refresh</source>
        <translation>Osveži</translation>
    </message>
    <message>
        <source>Reload</source>
        <translation>Ponovno naloži</translation>
    </message>
    <message>
        <source>Volume Down</source>
        <translation>Tišje</translation>
    </message>
    <message>
        <source>Volume Mute</source>
        <translation>Utišaj</translation>
    </message>
    <message>
        <source>Volume Up</source>
        <translation>Glasneje</translation>
    </message>
    <message>
        <source>Bass Boost</source>
        <translation>Ojačitev nizkih tonov</translation>
    </message>
    <message>
        <source>Bass Up</source>
        <translation>Nizki toni več</translation>
    </message>
    <message>
        <source>Bass Down</source>
        <translation>Nizki toni manj</translation>
    </message>
    <message>
        <source>Treble Up</source>
        <translation>Visoki toni več</translation>
    </message>
    <message>
        <source>Treble Down</source>
        <translation>Visoki toni manj</translation>
    </message>
    <message>
        <source>Media Play</source>
        <translation>Predvajaj</translation>
    </message>
    <message>
        <source>Media Stop</source>
        <translation>Ustavi predvajanje</translation>
    </message>
    <message>
        <source>Media Previous</source>
        <translation>Prejšnja skladba</translation>
    </message>
    <message>
        <source>Media Next</source>
        <translation>Naslednja skladba</translation>
    </message>
    <message>
        <source>Media Record</source>
        <translation>Snemaj</translation>
    </message>
    <message>
        <source>Media Pause</source>
        <translation>Premor predvajanja</translation>
    </message>
    <message>
        <source>Toggle Media Play/Pause</source>
        <translation>Predvajaj ali premor</translation>
    </message>
    <message>
        <source>Media Rewind</source>
        <translation>Previj nazaj</translation>
    </message>
    <message>
        <source>Media Fast Forward</source>
        <translation>Previj naprej</translation>
    </message>
    <message>
        <source>Home Page</source>
        <translation>Domača stran</translation>
    </message>
    <message>
        <source>Favorites</source>
        <translation>Priljubljene</translation>
    </message>
    <message>
        <source>Add Favorite</source>
        <translation>Dodaj priljubljeno</translation>
    </message>
    <message>
        <source>Search</source>
        <translation>Iskanje</translation>
    </message>
    <message>
        <source>Standby</source>
        <translation>Pripravljenost</translation>
    </message>
    <message>
        <source>Sleep</source>
        <translation>Spanje</translation>
    </message>
    <message>
        <source>Hibernate</source>
        <translation>Mirovanje</translation>
    </message>
    <message>
        <source>Suspend</source>
        <translation>Zaustavitev</translation>
    </message>
    <message>
        <source>Wake Up</source>
        <translation>Zbudi</translation>
    </message>
    <message>
        <source>Power Off</source>
        <translation>Izklop</translation>
    </message>
    <message>
        <source>Power Down</source>
        <translation>Izklop</translation>
    </message>
    <message>
        <source>Open URL</source>
        <translation>Odpri naslov URL</translation>
    </message>
    <message>
        <source>Launch Mail</source>
        <translation>Zaženi pošto</translation>
    </message>
    <message>
        <source>Launch Media</source>
        <translation>Zaženi predvajalnik</translation>
    </message>
    <message>
        <source>Screensaver</source>
        <translation>Ohranjevalnik zaslona</translation>
    </message>
    <message>
        <source>Browser</source>
        <translation>Brskalnik</translation>
    </message>
    <message>
        <source>Calculator</source>
        <translation>Računalo</translation>
    </message>
    <message>
        <source>Calendar</source>
        <translation>Koledar</translation>
    </message>
    <message>
        <source>Terminal</source>
        <translation>Terminal</translation>
    </message>
    <message>
        <source>Spreadsheet</source>
        <translation>Preglednica</translation>
    </message>
    <message>
        <source>Word Processor</source>
        <translation>Urejevalnik besedil</translation>
    </message>
    <message>
        <source>Messenger</source>
        <translation>Sporočilnik</translation>
    </message>
    <message>
        <source>Documents</source>
        <translation>Dokumenti</translation>
    </message>
    <message>
        <source>Music</source>
        <translation>Glasba</translation>
    </message>
    <message>
        <source>Pictures</source>
        <translation>Slike</translation>
    </message>
    <message>
        <source>Video</source>
        <translation>Video</translation>
    </message>
    <message>
        <source>News</source>
        <translation>Novice</translation>
    </message>
    <message>
        <source>Phone</source>
        <translation>Telefon</translation>
    </message>
    <message>
        <source>Settings</source>
        <translation>Nastavitve</translation>
    </message>
    <message>
        <source>Support</source>
        <translation>Podpora</translation>
    </message>
    <message>
        <source>Tools</source>
        <translation>Orodja</translation>
    </message>
    <message>
        <source>Travel</source>
        <translation>Potovanje</translation>
    </message>
    <message>
        <source>To-do list</source>
        <translation>Opravila</translation>
    </message>
    <message>
        <source>Memo</source>
        <translation>Zapisek</translation>
    </message>
    <message>
        <source>Copy</source>
        <translation>Kopiraj</translation>
    </message>
    <message>
        <source>Cut</source>
        <translation>Izreži</translation>
    </message>
    <message>
        <source>Paste</source>
        <translation>Prilepi</translation>
    </message>
    <message>
        <source>Clear</source>
        <translation>Počisti</translation>
    </message>
    <message>
        <source>Close</source>
        <translation>Zapri</translation>
    </message>
    <message>
        <source>Open</source>
        <translation>Odpri</translation>
    </message>
    <message>
        <source>Save</source>
        <translation>Shrani</translation>
    </message>
    <message>
        <source>New</source>
        <translation>Novo</translation>
    </message>
    <message>
        <source>Undo</source>
        <translation>Razveljavi</translation>
    </message>
    <message>
        <source>Redo</source>
        <translation>Znova uveljavi</translation>
    </message>
    <message>
        <source>Find</source>
        <translation>Najdi</translation>
    </message>
    <message>
        <source>Reply</source>
        <translation>Odgovori</translation>
    </message>
    <message>
        <source>Send</source>
        <translation>Pošlji</translation>
    </message>
    <message>
        <source>Mail Forward</source>
        <translation>Posreduj pošto</translation>
    </message>
    <message>
        <source>Cancel</source>
        <translation>Prekliči</translation>
    </message>
    <message>
        <source>Select</source>
        <translation>Izberi</translation>
    </message>
    <message>
        <source>Execute</source>
        <translation>Izvedi</translation>
    </message>
    <message>
        <source>Yes</source>
        <translation>Da</translation>
    </message>
    <message>
        <source>No</source>
        <translation>Ne</translation>
    </message>
    <message>
        <source>Exit</source>
        <translation>Izhod</translation>
    </message>
    <message>
        <source>Zoom</source>
        <translation>Zum</translation>
    </message>
    <message>
        <source>Zoom In</source>
        <translation>Povečaj</translation>
    </message>
    <message>
        <source>Zoom Out</source>
        <translation>Pomanjšaj</translation>
    </message>
    <message>
        <source>Play</source>
        <translation>Predvajaj</translation>
    </message>
    <message>
        <source>Printer</source>
        <translation>Tiskalnik</translation>
    </message>
    <message>
        <source>Eject</source>
        <translation>Izvrzi</translation>
    </message>
    <message>
        <source>History</source>
        <translation>Zgodovina</translation>
    </message>
    <message>
        <source>View</source>
        <translation>Pogled</translation>
    </message>
    <message>
        <source>Split Screen</source>
        <translation>Razdeli zaslon</translation>
    </message>
    <message>
        <source>Task Panel</source>
        <translation>Opravilna vrstica</translation>
    </message>
    <message>
        <source>Top Menu</source>
        <translation>Glavni meni</translation>
    </message>
    <message>
        <source>Option</source>
        <translation>Možnost</translation>
    </message>
    <message>
        <source>Display</source>
        <translation>Zaslon</translation>
    </message>
    <message>
        <source>Battery</source>
        <translation>Baterija</translation>
    </message>
    <message>
        <source>Bluetooth</source>
        <translation>Bluetooth</translation>
    </message>
    <message>
        <source>Wireless</source>
        <translation>Brezžično</translation>
    </message>
    <message>
        <source>Adjust contrast</source>
        <translation>Prilagodi kontrast</translation>
    </message>
    <message>
        <source>Adjust Brightness</source>
        <translation>Prilagodi svetlost</translation>
    </message>
    <message>
        <source>Keyboard Light On/Off</source>
        <translation>Osvetlitev tipkovnice</translation>
    </message>
    <message>
        <source>Keyboard Brightness Up</source>
        <translation>Svetlejša tipkovnica</translation>
    </message>
    <message>
        <source>Keyboard Brightness Down</source>
        <translation>Temnejša tipkovnica</translation>
    </message>
    <message>
        <source>Monitor Brightness Up</source>
        <translation>Svetlejši zaslon</translation>
    </message>
    <message>
        <source>Monitor Brightness Down</source>
        <translation>Temnejši zaslon</translation>
    </message>
    <message>
        <source>Microphone Mute</source>
        <translation>Izklop mikrofona</translation>
    </message>
    <message>
        <source>Microphone Volume Up</source>
        <translation>Glasnejši mikrofon</translation>
    </message>
    <message>
        <source>Microphone Volume Down</source>
        <translation>Tišji mikrofon</translation>
    </message>
    <message>
        <source>Touchpad On</source>
        <translation>Vklop sledilne ploščice</translation>
    </message>
    <message>
        <source>Touchpad Off</source>
        <translation>Izklop sledilne ploščice</translation>
    </message>
    <message>
        <source>Touchpad Toggle</source>
        <translation>Preklop sledilne ploščice</translation>
    </message>
    <message>
        <source>Red</source>
        <translation>Rdeča</translation>
    </message>
    <message>
        <source>Green</source>
        <translation>Zelena</translation>
    </message>
    <message>
        <source>Yellow</source>
        <translation>Rumena</translation>
    </message>
    <message>
        <source>Blue</source>
        <translation>Modra</translation>
    </message>
    <message>
        <source>Guide</source>
        <translation>Vodič</translation>
    </message>
    <message>
        <source>Info</source>
        <translation>Podatki</translation>
    </message>
    <message>
        <source>Subtitle</source>
        <translation>Podnapisi</translation>
    </message>
    <message>
        <source>Channel Up</source>
        <translation>Kanal naprej</translation>
    </message>
    <message>
        <source>Channel Down</source>
        <translation>Kanal nazaj</translation>
    </message>
    <message>
        <source>Camera Shutter</source>
        <translation>Sprožilec</translation>
    </message>
    <message>
        <source>Camera Focus</source>
        <translation>Ostrenje</translation>
    </message>
    <message>
        <source>Spellchecker</source>
        <translation>Črkovalnik</translation>
    </message>
    <message>
        <source>Logoff</source>
        <translation>Odjava</translation>
    </message>
</context>
<context>
    <name>QSpiAccessibleBridge</name>
    <message>
        <source>invalid role</source>
        <translation>neveljavna vloga</translation>
    </message>
    <message>
        <source>title bar</source>
        <translation>naslovna vrstica</translation>
    </message>
    <message>
        <source>menu bar</source>
        <translation>menijska vrstica</translation>
    </message>
    <message>
        <source>scroll bar</source>
        <translation>drsnik</translation>
    </message>
    <message>
        <source>grip</source>
        <translation>ročaj</translation>
    </message>
    <message>
        <source>sound</source>
        <translation>zvok</translation>
    </message>
    <message>
        <source>cursor</source>
        <translation>kazalec</translation>
    </message>
    <message>
        <source>text caret</source>
        <translation>besedilni kazalec</translation>
    </message>
    <message>
        <source>alert message</source>
        <translation>opozorilo</translation>
    </message>
    <message>
        <source>window</source>
        <translation>okno</translation>
    </message>
    <message>
        <source>filler</source>
        <translation>polnilo</translation>
    </message>
    <message>
        <source>popup menu</source>
        <translation>pojavni meni</translation>
    </message>
    <message>
        <source>menu item</source>
        <translation>menijski ukaz</translation>
    </message>
    <message>
        <source>tool tip</source>
        <translation>namig</translation>
    </message>
    <message>
        <source>application</source>
        <translation>program</translation>
    </message>
    <message>
        <source>document</source>
        <translation>dokument</translation>
    </message>
    <message>
        <source>panel</source>
        <translation>plošča</translation>
    </message>
    <message>
        <source>chart</source>
        <translation>grafikon</translation>
    </message>
    <message>
        <source>dialog</source>
        <translation>pogovorno okno</translation>
    </message>
    <message>
        <source>frame</source>
        <translation>okvir</translation>
    </message>
    <message>
        <source>separator</source>
        <translation>ločilo</translation>
    </message>
    <message>
        <source>tool bar</source>
        <translation>orodna vrstica</translation>
    </message>
    <message>
        <source>status bar</source>
        <translation>vrstica stanja</translation>
    </message>
    <message>
        <source>table</source>
        <translation>tabela</translation>
    </message>
    <message>
        <source>column header</source>
        <translation>glava stolpca</translation>
    </message>
    <message>
        <source>row header</source>
        <translation>glava vrstice</translation>
    </message>
    <message>
        <source>column</source>
        <translation>stolpec</translation>
    </message>
    <message>
        <source>row</source>
        <translation>vrstica</translation>
    </message>
    <message>
        <source>cell</source>
        <translation>celica</translation>
    </message>
    <message>
        <source>link</source>
        <translation>povezava</translation>
    </message>
    <message>
        <source>help balloon</source>
        <translation>oblaček s pomočjo</translation>
    </message>
    <message>
        <source>assistant</source>
        <translation>pomočnik</translation>
    </message>
    <message>
        <source>list</source>
        <translation>seznam</translation>
    </message>
    <message>
        <source>list item</source>
        <translation>element seznama</translation>
    </message>
    <message>
        <source>tree</source>
        <translation>drevo</translation>
    </message>
    <message>
        <source>tree item</source>
        <translation>element drevesa</translation>
    </message>
    <message>
        <source>page tab</source>
        <translation>zavihek</translation>
    </message>
    <message>
        <source>property page</source>
        <translation>stran lastnosti</translation>
    </message>
    <message>
        <source>indicator</source>
        <translation>kazalnik</translation>
    </message>
    <message>
        <source>graphic</source>
        <translation>slika</translation>
    </message>
    <message>
        <source>label</source>
        <translation>oznaka</translation>
    </message>
    <message>
        <source>text</source>
        <translation>besedilo</translation>
    </message>
    <message>
        <source>push button</source>
        <translation>gumb</translation>
    </message>
    <message>
        <source>check box</source>
        <translation>potrditveno polje</translation>
    </message>
    <message>
        <source>radio button</source>
        <translation>izbirni gumb</translation>
    </message>
    <message>
        <source>combo box</source>
        <translation>spustni seznam</translation>
    </message>
    <message>
        <source>progress bar</source>
        <translation>vrstica napredka</translation>
    </message>
    <message>
        <source>dial</source>
        <translation>vrtljivi gumb</translation>
    </message>
    <message>
        <source>hotkey field</source>
        <translation>polje za bližnjico</translation>
    </message>
    <message>
        <source>slider</source>
        <translation>vlečni drsnik</translation>
    </message>
    <message>
        <source>spin box</source>
        <translation>vrtilno polje</translation>
    </message>
    <message>
        <source>canvas</source>
        <translation>platno</translation>
    </message>
    <message>
        <source>animation</source>
        <translation>animacija</translation>
    </message>
    <message>
        <source>equation</source>
        <translation>enačba</translation>
    </message>
    <message>
        <source>button with drop down</source>
        <translation>gumb s spustnim seznamom</translation>
    </message>
    <message>
        <source>button menu</source>
        <translation>gumb z menijem</translation>
    </message>
    <message>
        <source>button with drop down grid</source>
        <translation>gumb s spustno mrežo</translation>
    </message>
    <message>
        <source>space</source>
        <translation>presledek</translation>
    </message>
    <message>
        <source>page tab list</source>
        <translation>seznam zavihkov</translation>
    </message>
    <message>
        <source>clock</source>
        <translation>ura</translation>
    </message>
    <message>
        <source>splitter</source>
        <translation>razdelilnik</translation>
    </message>
    <message>
        <source>layered pane</source>
        <translation>plastna plošča</translation>
    </message>
    <message>
        <source>web document</source>
        <translation>spletni dokument</translation>
    </message>
    <message>
        <source>paragraph</source>
        <translation>odstavek</translation>
    </message>
    <message>
        <source>section</source>
        <translation>razdelek</translation>
    </message>
    <message>
        <source>color chooser</source>
        <translation>izbirnik barv</translation>
    </message>
    <message>
        <source>footer</source>
        <translation>noga</translation>
    </message>
    <message>
        <source>form</source>
        <translation>obrazec</translation>
    </message>
    <message>
        <source>heading</source>
        <translation>naslov</translation>
    </message>
    <message>
        <source>note</source>
        <translation>opomba</translation>
    </message>
    <message>
        <source>complementary content</source>
        <translation>dopolnilna vsebina</translation>
    </message>
    <message>
        <source>terminal</source>
        <translation>terminal</translation>
    </message>
    <message>
        <source>desktop</source>
        <translation>namizje</translation>
    </message>
    <message>
        <source>notification</source>
        <translation>obvestilo</translation>
    </message>
    <message>
        <source>unknown</source>
        <translation>neznano</translation>
    </message>
</context>
<context>
    <name>QStandardPaths</name>
    <message>
        <source>Desktop</source>
        <translation>Namizje</translation>
    </message>
    <message>
        <source>Documents</source>
        <translation>Dokumenti</translation>
    </message>
    <message>
        <source>Fonts</source>
        <translation>Pisave</translation>
    </message>
    <message>
        <source>Applications</source>
        <translation>Programi</translation>
    </message>
    <message>
        <source>Music</source>
        <translation>Glasba</translation>
    </message>
    <message>
        <source>Movies</source>
        <translation>Filmi</translation>
    </message>
    <message>
        <source>Pictures</source>
        <translation>Slike</translation>
    </message>
    <message>
        <source>Temporary Directory</source>
        <translation>Začasna mapa</translation>
    </message>
    <message>
        <source>Home</source>
        <translation>Domov</translation>
    </message>
    <message>
        <source>Cache</source>
        <translation>Predpomnilnik</translation>
    </message>
    <message>
        <source>Shared Data</source>
        <translation>Skupni podatki</translation>
    </message>
    <message>
        <source>Runtime</source>
        <translation>Izvajanje</translation>
    </message>
    <message>
        <source>Configuration</source>
        <translation>Nastavitve</translation>
    </message>
    <message>
        <source>Shared Configuration</source>
        <translation>Skupne nastavitve</translation>
    </message>
    <message>
        <source>Shared Cache</source>
        <translation>Skupni predpomnilnik</translation>
    </message>
    <message>
        <source>Download</source>
        <translation>Prejemi</translation>
    </message>
    <message>
        <source>Application Data</source>
        <translation>Podatki programa</translation>
    </message>
    <message>
        <source>Application Configuration</source>
        <translation>Nastavitve programa</translation>
    </message>
    <message>
        <source>Templates</source>
        <translation>Predloge</translation>
    </message>
    <message>
        <source>Public</source>
        <translation>Javno</translation>
    </message>
</context>
<context>
    <name>QTabBar</name>
    <message>
        <source>Scroll Left</source>
        <translation>Drsi levo</translation>
    </message>
    <message>
        <source>Scroll Right</source>
        <translation>Drsi desno</translation>
    </message>
</context>
<context>
    <name>QUndoGroup</name>
    <message>
        <source>Undo %1</source>
        <translation>Razveljavi: %1</translation>
    </message>
    <message>
        <source>Undo</source>
        <translation>Razveljavi</translation>
    </message>
    <message>
        <source>Redo %1</source>
        <translation>Znova uveljavi: %1</translation>
    </message>
    <message>
        <source>Redo</source>
        <translation>Znova uveljavi</translation>
    </message>
</context>
<context>
    <name>QUndoModel</name>
    <message>
        <source>&lt;empty&gt;</source>
        <translation>&lt;prazno&gt;</translation>
    </message>
</context>
<context>
    <name>QUndoStack</name>
    <message>
        <source>Undo %1</source>
        <translation>Razveljavi: %1</translation>
    </message>
    <message>
        <source>Undo</source>
        <translation>Razveljavi</translation>
    </message>
    <message>
        <source>Redo %1</source>
        <translation>Znova uveljavi: %1</translation>
    </message>
    <message>
        <source>Redo</source>
        <translation>Znova uveljavi</translation>
    </message>
</context>
<context>
    <name>QUnicodeControlCharacterMenu</name>
    <message>
        <source>LRM Left-to-right mark</source>
        <translation>LRM Oznaka od leve proti desni</translation>
    </message>
    <message>
        <source>RLM Right-to-left mark</source>
        <translation>RLM Oznaka od desne proti levi</translation>
    </message>
    <message>
        <source>ZWJ Zero width joiner</source>
        <translation>ZWJ Povezovalnik brez širine</translation>
    </message>
    <message>
        <source>ZWNJ Zero width non-joiner</source>
        <translation>ZWNJ Ločevalnik brez širine</translation>
    </message>
    <message>
        <source>ZWSP Zero width space</source>
        <translation>ZWSP Presledek brez širine</translation>
    </message>
    <message>
        <source>LRE Start of left-to-right embedding</source>
        <translation>LRE Začetek vstavka od leve proti desni</translation>
    </message>
    <message>
        <source>RLE Start of right-to-left embedding</source>
        <translation>RLE Začetek vstavka od desne proti levi</translation>
    </message>
    <message>
        <source>LRO Start of left-to-right override</source>
        <translation>LRO Začetek prisile od leve proti desni</translation>
    </message>
    <message>
        <source>RLO Start of right-to-left override</source>
        <translation>RLO Začetek prisile od desne proti levi</translation>
    </message>
    <message>
        <source>PDF Pop directional formatting</source>
        <translation>PDF Konec oblikovanja smeri</translation>
    </message>
    <message>
        <source>LRI Left-to-right isolate</source>
        <translation>LRI Osamljeno od leve proti desni</translation>
    </message>
    <message>
        <source>RLI Right-to-left isolate</source>
        <translation>RLI Osamljeno od desne proti levi</translation>
    </message>
    <message>
        <source>FSI First strong isolate</source>
        <translation>FSI Osamljeno po prvem močnem znaku</translation>
    </message>
    <message>
        <source>PDI Pop directional isolate</source>
        <translation>PDI Konec osamljenega</translation>
    </message>
    <message>
        <source>Insert Unicode control character</source>
        <translation>Vstavi kontrolni znak Unicode</translation>
    </message>
</context>
<context>
    <name>QWhatsThisAction</name>
    <message>
        <source>What&apos;s This?</source>
        <translation>Kaj je to?</translation>
    </message>
</context>
<context>
    <name>QWidgetTextControl</name>
    <message>
        <source>&amp;Undo</source>
        <translation>&amp;Razveljavi</translation>
    </message>
    <message>
        <source>&amp;Redo</source>
        <translation>&amp;Znova uveljavi</translation>
    </message>
    <message>
        <source>Cu&amp;t</source>
        <translation>&amp;Izreži</translation>
    </message>
    <message>
        <source>&amp;Copy</source>
        <translation>&amp;Kopiraj</translation>
    </message>
    <message>
        <source>&amp;Paste</source>
        <translation>&amp;Prilepi</translation>
    </message>
    <message>
        <source>Delete</source>
        <translation>Izbriši</translation>
    </message>
    <message>
        <source>Select All</source>
        <translation>Izberi vse</translation>
    </message>
    <message>
        <source>Copy &amp;Link Location</source>
        <translation>Kopiraj &amp;naslov povezave</translation>
    </message>
</context>
</TS>
