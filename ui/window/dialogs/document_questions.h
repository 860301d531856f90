#pragma once

#include <QString>

class QWidget;

/// What a person is asked, or told, about a document's file. File names are shown as they are written.
namespace kriva::ui {

enum class EditedFigureAnswer { Document, Drawing, Cancel };
/// The lines of a figure are not those of the document inside.
[[nodiscard]] EditedFigureAnswer askAboutEditedFigure(const QString& name, QWidget* window);

enum class SaveAnswer { Save, SaveAs, Overwrite, Reload, Discard, Cancel };
/// Before a document goes: Save, Discard or Cancel.
[[nodiscard]] SaveAnswer askAboutUnsaved(const QString& name, QWidget* window);
/// The same where nothing was changed, but the file is not there any more.
[[nodiscard]] SaveAnswer askAboutGone(const QString& name, QWidget* window);
/// Nothing was changed, but another program wrote into the file: SaveAs, Overwrite, Discard or Cancel.
[[nodiscard]] SaveAnswer askAboutChanged(const QString& name, QWidget* window);

enum class OpenElsewhereAnswer { Copy, Anyway, Cancel };
/// Another program has the file open that is to be opened.
[[nodiscard]] OpenElsewhereAnswer askAboutOpenElsewhere(const QString& name, QWidget* window);

/// Another window or program has the file open that is to be written: SaveAs, Overwrite or Cancel.
[[nodiscard]] SaveAnswer askToOverwriteOpen(const QString& name, QWidget* window);
/// Another program wrote into the file that is to be written: the same or Reload.
[[nodiscard]] SaveAnswer askToOverwriteChanged(const QString& name, QWidget* window);

/// Whether to give up what was changed here for what is in the file.
[[nodiscard]] bool askToReload(const QString& name, QWidget* window);

void tellNotOpened(const QString& sentence, QWidget* window);
/// Whether to save under another name instead.
[[nodiscard]] bool tellNotSaved(const QString& sentence, QWidget* window);

} // namespace kriva::ui
