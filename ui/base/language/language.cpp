#include "ui/base/language/language.h"

#include <QCoreApplication>
#include <QEvent>
#include <QLibraryInfo>
#include <QTranslator>

#include <algorithm>

namespace kriva::ui {

using namespace Qt::StringLiterals;

namespace {

struct LanguageNames {
    QStringView code;
    QStringView name;
};

/// By Language.
constexpr std::array<LanguageNames, kLanguages.size()> kNames{{
    {u"en", u"English"},
    {u"bg", u"Български"},
    {u"sl", u"Slovenščina"},
    {u"uk", u"Українська"},
}};

const LanguageNames& namesOf(Language language) {
    return kNames[static_cast<std::size_t>(language)];
}

} // namespace

QString languageCode(Language language) {
    return namesOf(language).code.toString();
}

QString languageName(Language language) {
    return namesOf(language).name.toString();
}

QLocale languageLocale(Language language) {
    return QLocale(languageCode(language));
}

std::optional<Language> languageOf(QStringView localeName) {
    const auto end = std::find_if_not(localeName.begin(), localeName.end(), [](QChar c) { return c.isLetter(); });
    const QStringView code = localeName.first(end - localeName.begin());
    for (const Language language : kLanguages) {
        if (code.compare(languageCode(language), Qt::CaseInsensitive) == 0)
            return language;
    }
    return std::nullopt;
}

Language firstLanguageOf(const QStringList& localeNames) {
    for (const QString& name : localeNames) {
        if (const auto language = languageOf(name))
            return *language;
    }
    return Language::English;
}

Language systemLanguage() {
    return firstLanguageOf(QLocale::system().uiLanguages());
}

/// All catalogues of a language as one translator, so that a switch is one step and no moment knows half of it.
class LanguageSwitch::Catalogues : public QTranslator {
  public:
    void load(const QString& code) {
        // Our supplement comes before Qt's own catalogue: it says what that lacks or, where there is none, all of it.
        const QString qtFolder = QLibraryInfo::path(QLibraryInfo::TranslationsPath);
        const std::array paths = {u":/i18n/kriva_%1.qm"_s.arg(code), u":/i18n/qtbase_%1.qm"_s.arg(code),
                                  u"%1/qtbase_%2.qm"_s.arg(qtFolder, code)};
        for (std::size_t i = 0; i < paths.size(); ++i) {
            catalogues_[i] = std::make_unique<QTranslator>();
            // A catalogue that is not there stays empty: English needs none of Qt's.
            (void)catalogues_[i]->load(paths[i]);
        }
    }

    [[nodiscard]] bool isEmpty() const override { return false; }

    [[nodiscard]] QString translate(const char* context, const char* source, const char* comment,
                                    int count) const override {
        for (const auto& catalogue : catalogues_) {
            QString text = catalogue->translate(context, source, comment, count);
            if (!text.isNull())
                return text;
        }
        return {};
    }

  private:
    std::array<std::unique_ptr<QTranslator>, 3> catalogues_;
};

LanguageSwitch::LanguageSwitch(Language language, QObject* parent)
    : QObject(parent)
    , language_(language)
    , catalogues_(std::make_unique<Catalogues>()) {
    load();
    QCoreApplication::installTranslator(catalogues_.get());
}

LanguageSwitch::~LanguageSwitch() {
    QCoreApplication::removeTranslator(catalogues_.get());
}

void LanguageSwitch::setLanguage(Language language) {
    if (language == language_)
        return;
    language_ = language;
    load();
    // What installing a translator would send.
    QEvent change(QEvent::LanguageChange);
    QCoreApplication::sendEvent(QCoreApplication::instance(), &change);
    Q_EMIT changed();
}

void LanguageSwitch::load() {
    catalogues_->load(languageCode(language_));
    QLocale::setDefault(languageLocale(language_));
}

} // namespace kriva::ui
