#include "ui/shell/status_row.h"

#include <QEvent>
#include <QLocale>

namespace kriva::ui {
namespace {

constexpr int kDigits = 6; // of a coordinate: what a pointer can tell apart

} // namespace

StatusRow::StatusRow(QWidget* parent)
    : QStatusBar(parent)
    , hint_(new QLabel(this))
    , pointer_(new QLabel(this))
    , zoom_(new QLabel(this)) {
    hint_->setObjectName(QStringLiteral("hint"));
    pointer_->setObjectName(QStringLiteral("pointer"));
    zoom_->setObjectName(QStringLiteral("zoom"));
    addWidget(hint_, 1);
    addPermanentWidget(pointer_);
    addPermanentWidget(zoom_);
    retranslateUi();
}

void StatusRow::showHint(const QString& hint) {
    if (!isTelling_)
        hint_->setText(hint);
}

void StatusRow::tell(const QString& text) {
    hint_->setText(text);
    isTelling_ = true;
}

void StatusRow::showPointer(Point at) {
    if (at != at_)
        isTelling_ = false;
    at_ = at;
    QLocale locale;
    locale.setNumberOptions(QLocale::OmitGroupSeparator);
    pointer_->setText(tr("x %1   y %2", "the pointer's coordinates")
                          .arg(locale.toString(at.x, 'g', kDigits), locale.toString(at.y, 'g', kDigits)));
}

void StatusRow::showZoom(double percent) {
    percent_ = percent;
    QLocale locale;
    locale.setNumberOptions(QLocale::OmitGroupSeparator);
    zoom_->setText(tr("%1 %", "zoom in percent").arg(locale.toString(percent, 'g', percent < 1000 ? 3 : 6)));
}

void StatusRow::changeEvent(QEvent* event) {
    if (event->type() == QEvent::LanguageChange)
        retranslateUi();
    QStatusBar::changeEvent(event);
}

void StatusRow::retranslateUi() {
    isTelling_ = false;
    hint_->clear(); // the next move of the pointer gives one in the new language
    pointer_->setAccessibleName(tr("Coordinates of the pointer"));
    zoom_->setAccessibleName(tr("Zoom"));
    showPointer(at_);
    showZoom(percent_);
}

} // namespace kriva::ui
