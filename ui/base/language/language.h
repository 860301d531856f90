#pragma once

#include <QLocale>
#include <QObject>
#include <QStringList>

#include <array>
#include <memory>
#include <optional>

namespace kriva::ui {

enum class Language { English, Bulgarian, Slovenian, Ukrainian };

/// In the order in which they are offered.
inline constexpr std::array kLanguages = {Language::English, Language::Bulgarian, Language::Slovenian,
                                          Language::Ukrainian};

/// "en", "bg", "sl", "uk": the ISO 639 code, as in the names of the catalogues and on the command line.
[[nodiscard]] QString languageCode(Language language);

/// What its own speakers call it: "Slovenščina". Never translated.
[[nodiscard]] QString languageName(Language language);

/// How the language writes numbers and dates.
[[nodiscard]] QLocale languageLocale(Language language);

/// The language of a code or of the name of a locale that begins with it: "bg", "bg-BG", "bg_BG.UTF-8".
[[nodiscard]] std::optional<Language> languageOf(QStringView localeName);

/// The first of the wanted ones that Kriva speaks; English if it speaks none.
[[nodiscard]] Language firstLanguageOf(const QStringList& localeNames);

/// What the system asks for: the locale's messages (LANGUAGE, LC_ALL, LC_MESSAGES, LANG).
[[nodiscard]] Language systemLanguage();

/// The language in use: while this lives, every tr() speaks it, Qt's own texts included, and QLocale() writes its
/// numbers. It needs a QCoreApplication, and only one lives at a time.
class LanguageSwitch : public QObject {
    Q_OBJECT

  public:
    explicit LanguageSwitch(Language language, QObject* parent = nullptr);
    ~LanguageSwitch() override;

    [[nodiscard]] Language language() const { return language_; }

    /// Speaks another language at once. Widgets get a LanguageChange event when the event loop turns; for what is no
    /// widget (items, plots, undo actions) there is changed().
    void setLanguage(Language language);

  Q_SIGNALS:
    void changed();

  private:
    class Catalogues;

    void load();

    Language language_;
    std::unique_ptr<Catalogues> catalogues_;
};

} // namespace kriva::ui
