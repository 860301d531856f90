#include "ui/base/preferences.h"

#include <QDir>

#include <algorithm>

namespace kriva::ui {

using namespace Qt::StringLiterals;

namespace {

constexpr qsizetype kMostRecentFiles = 10;

const auto kLanguage = u"language"_s;
const auto kTheme = u"theme"_s;
const auto kRecentFiles = u"recentFiles"_s;
const auto kSnap = u"canvas/snap"_s;
const auto kRulers = u"canvas/rulers"_s;
const auto kWindowGeometry = u"window/geometry"_s;
const auto kLightTheme = u"light"_s;
const auto kDarkTheme = u"dark"_s;
const auto kSystemTheme = u"system"_s;
const auto kOn = u"on"_s;
const auto kOff = u"off"_s;

[[nodiscard]] QString layoutKey(const QString& tab) {
    return u"panels/%1"_s.arg(tab);
}

} // namespace

Preferences::Preferences()
    : settings_(QSettings::IniFormat, QSettings::UserScope, u"kriva"_s, u"kriva"_s) {
    settings_.setFallbacksEnabled(false);
}

std::optional<Language> Preferences::language() const {
    return languageOf(settings_.value(kLanguage).toString());
}

void Preferences::setLanguage(Language language) {
    settings_.setValue(kLanguage, languageCode(language));
}

ThemeChoice Preferences::theme() const {
    const QString name = settings_.value(kTheme).toString();
    return name == kLightTheme ? ThemeChoice::Light : name == kDarkTheme ? ThemeChoice::Dark : ThemeChoice::System;
}

void Preferences::setTheme(ThemeChoice theme) {
    settings_.setValue(kTheme, theme == ThemeChoice::Light  ? kLightTheme
                               : theme == ThemeChoice::Dark ? kDarkTheme
                                                            : kSystemTheme);
}

QStringList Preferences::recentFiles() const {
    QStringList files = settings_.value(kRecentFiles).toStringList();
    files.removeIf([](const QString& path) { return QDir::isRelativePath(path); });
    files.removeDuplicates();
    return files.first(std::min(files.size(), kMostRecentFiles));
}

void Preferences::addRecentFile(const QString& path) {
    const QString absolute = QDir::cleanPath(QDir::current().absoluteFilePath(path));
    QStringList files = recentFiles();
    files.removeAll(absolute);
    files.prepend(absolute);
    settings_.setValue(kRecentFiles, files.first(std::min(files.size(), kMostRecentFiles)));
}

bool Preferences::isSnapping() const {
    return settings_.value(kSnap).toString() == kOn;
}

void Preferences::setSnapping(bool isSnapping) {
    settings_.setValue(kSnap, isSnapping ? kOn : kOff);
}

bool Preferences::areRulersShown() const {
    return settings_.value(kRulers).toString() == kOn;
}

void Preferences::setRulersShown(bool areShown) {
    settings_.setValue(kRulers, areShown ? kOn : kOff);
}

QByteArray Preferences::windowGeometry() const {
    return settings_.value(kWindowGeometry).toByteArray();
}

void Preferences::setWindowGeometry(const QByteArray& geometry) {
    settings_.setValue(kWindowGeometry, geometry);
}

QByteArray Preferences::panelLayout(const QString& tab) const {
    return settings_.value(layoutKey(tab)).toByteArray();
}

void Preferences::setPanelLayout(const QString& tab, const QByteArray& layout) {
    settings_.setValue(layoutKey(tab), layout);
}

} // namespace kriva::ui
