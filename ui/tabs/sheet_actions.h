#pragma once

#include "ui/editing/sheet_editor.h"
#include "ui/tabs/sheet_ui.h"

#include <QAction>

namespace kriva::ui {

/// The actions that one tab has and the others have not. They are enabled where they apply to what is selected.
class SheetActions : public QObject {
    Q_OBJECT
  public:
    /// `canvas` is where their shortcuts work. `ui` outlives this.
    SheetActions(SheetEditor& editor, const SheetUi& ui, QWidget& canvas);

    /// All of them as they stand in a menu, with a separator before each group.
    [[nodiscard]] const QList<QAction*>& all() const { return all_; }
    /// Those of some groups.
    [[nodiscard]] QList<QAction*> of(std::initializer_list<SheetAction::Group> groups) const;
    void retranslateUi();

  private:
    struct Entry {
        QAction* action;
        SheetAction what;
    };
    void addNumber(const SheetNumber& number);
    void add(SheetAction what);
    void addSeparator();
    void follow();

    SheetEditor& editor_;
    QWidget& canvas_;
    std::vector<Entry> entries_;
    QList<QAction*> all_;
};

} // namespace kriva::ui
