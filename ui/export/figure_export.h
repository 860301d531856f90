#pragma once

#include "core/figure/plot/plot.h"
#include "ui/figures/figure_file.h"

#include <QObject>

#include <array>

class QThreadPool;
class QWidget;

namespace kriva::ui {

class SheetEditor;

/// Asks how and into which file plots go, one above the other; the options begin with the last ones.
void exportPlots(const std::vector<Plot>& plots, FigureFileOptions& options, QThreadPool& workers, QWidget* window);

/// The ways of a tab's figure out of the window: into files and onto the clipboard, always the stage on view.
class FigureExport : public QObject {
    Q_OBJECT
  public:
    explicit FigureExport(QWidget* window);

    /// Asks how and into which file; `name` is the document's, for the file that is proposed.
    void ask(const SheetEditor& editor, const QString& name);
    /// The same as the last time into the same file, without a question; asks where there was no last time.
    void again(const SheetEditor& editor, const QString& name);
    /// As SVG, PDF and PNG at once.
    void copy(const SheetEditor& editor) const;
    void copyTikz(const SheetEditor& editor) const;
    /// The data of the active curve's path as text.
    void copyPath(const SheetEditor& editor) const;
    /// Shows the figure on paper, where printing can be set up and begun.
    void print(const SheetEditor& editor, const QString& name);
    /// Another document is open: its figures go into files of their own.
    void forgetFiles();

  Q_SIGNALS:
    /// A text for the status row about what just happened.
    void told(const QString& text);

  private:
    /// Tells what went wrong, and where.
    void write(const SheetEditor& editor, const QString& path);

    QWidget* window_;
    std::array<QString, kSheetCount> paths_; ///< of the last files
};

} // namespace kriva::ui
