#pragma once

#include "ui/base/look/icons.h"

#include <QAction>
#include <QObject>

#include <optional>
#include <vector>

namespace kriva::ui {

/// All actions of the window, with their texts, icons and shortcuts, but without what they do. Menus, tool bar and
/// window connect them; a language switch changes their texts in place.
class Actions : public QObject {
    Q_OBJECT
  public:
    explicit Actions(QWidget* window);

    // File
    QAction* newDocument;
    QAction* newWindow;
    QAction* open;
    QAction* save;
    QAction* saveAs;
    QAction* importPoints;
    QAction* exportFigure;
    QAction* exportAgain;
    QAction* copyFigure;
    QAction* copyTikz;
    QAction* copyPath;
    QAction* print;
    QAction* quit;
    // Edit
    QAction* undo;
    QAction* redo;
    QAction* cut;
    QAction* copy;
    QAction* paste;
    QAction* duplicate;
    QAction* deleteSelected;
    QAction* deleteLastPoint;
    QAction* clearCanvas;
    QAction* selectAll;
    QAction* selectNone;
    QAction* selectInverse;
    // Curve
    QAction* newCurve;
    QAction* duplicateCurve;
    QAction* deleteCurve;
    QAction* nextCurve;
    QAction* reverseCurve;
    QAction* renameCurve;
    QAction* moveCurveUp;
    QAction* moveCurveDown;
    QAction* showCurve;
    QAction* insertPoint;
    // View
    QAction* editTool;
    QAction* addTool;
    QAction* zoomIn;
    QAction* zoomOut;
    QAction* zoomTo100;
    QAction* fitAll;
    QAction* fitSelection;
    QAction* grid;
    QAction* axes;
    QAction* rulers;
    QAction* snap;
    QAction* resetPanels;
    QAction* showHistory;
    QAction* fullScreen;
    // Help
    QAction* guide;
    QAction* shortcuts;
    QAction* about;
    QAction* aboutQt;

    void retranslateUi();

  private:
    struct Entry {
        QAction* action;
        const char* text; ///< marked with QT_TRANSLATE_NOOP("Actions", ...)
    };
    void makeFile();
    void makeEdit();
    void makeCurve();
    void makeView();
    void makeHelp();
    QAction* make(const char* name, const char* text, const QKeySequence& shortcut = {},
                  std::optional<IconName> iconName = {});
    QAction* makeToggle(const char* name, const char* text, const QKeySequence& shortcut = {},
                        std::optional<IconName> iconName = {});

    QWidget* window_;
    std::vector<Entry> entries_;
};

} // namespace kriva::ui
