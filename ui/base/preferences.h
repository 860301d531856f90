#pragma once

#include "ui/base/language/language.h"
#include "ui/base/look/theme.h"

#include <QByteArray>
#include <QSettings>
#include <QStringList>

#include <optional>

namespace kriva::ui {

/// What the program remembers of a person between two starts, in $XDG_CONFIG_HOME/kriva/kriva.ini. Whatever stands
/// there, what is read is valid.
class Preferences {
  public:
    Preferences();

    /// nullopt until one is chosen: the system's language is taken.
    [[nodiscard]] std::optional<Language> language() const;
    void setLanguage(Language language);

    [[nodiscard]] ThemeChoice theme() const;
    void setTheme(ThemeChoice theme);

    /// Absolute paths, the last one used first, at most ten, no path twice.
    [[nodiscard]] QStringList recentFiles() const;
    void addRecentFile(const QString& path);

    /// Whether points snap, and whether canvases have rulers; at first neither.
    [[nodiscard]] bool isSnapping() const;
    void setSnapping(bool isSnapping);
    [[nodiscard]] bool areRulersShown() const;
    void setRulersShown(bool areShown);

    /// Place and size of the window, as QWidget::saveGeometry() gives them; empty at first.
    [[nodiscard]] QByteArray windowGeometry() const;
    void setWindowGeometry(const QByteArray& geometry);

    /// How the panels of a tab lie, as QMainWindow::saveState() gives it; empty at first.
    [[nodiscard]] QByteArray panelLayout(const QString& tab) const;
    void setPanelLayout(const QString& tab, const QByteArray& layout);

  private:
    QSettings settings_;
};

} // namespace kriva::ui
