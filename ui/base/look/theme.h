#pragma once

#include <QObject>
#include <QPalette>

namespace kriva::ui {

class DesktopScheme;

enum class ThemeChoice { System, Light, Dark };

[[nodiscard]] QPalette lightPalette();
[[nodiscard]] QPalette darkPalette();
[[nodiscard]] bool isDark(const QPalette& palette);

/// Gives the program's windows their colours, in the Fusion style; widgets take on new ones when the event loop turns.
/// It needs a QApplication.
class ThemeSwitch : public QObject {
    Q_OBJECT

  public:
    /// `desktop` outlives this. Where it knows nothing, the system's own palette at this moment decides.
    ThemeSwitch(ThemeChoice theme, const DesktopScheme& desktop, QObject* parent = nullptr);

    [[nodiscard]] ThemeChoice theme() const { return theme_; }
    [[nodiscard]] bool isDark() const;
    void setTheme(ThemeChoice theme);

  Q_SIGNALS:
    /// The windows turned from light to dark or back.
    void changed();

  private:
    void apply();

    const DesktopScheme& desktop_;
    ThemeChoice theme_;
    bool systemIsDark_;
    bool shownDark_;
};

} // namespace kriva::ui
