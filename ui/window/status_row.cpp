#include "ui/window/status_row.h"

#include "ui/base/language/number_text.h"
#include "ui/base/language/plain_text.h"
#include "ui/base/look/plain_label.h"

#include <QEvent>
#include <QLocale>

#include <algorithm>
#include <utility>

namespace kriva::ui {
namespace {

constexpr int kDigits = 6; // of a coordinate: what a pointer can tell apart

constexpr int kLabelMargin = 2;

/// A place for a label whose text changes with every move of the pointer. In a layout of its own, each text would have
/// the whole window laid out and painted anew. It grows with the texts but does not shrink, so that nothing jumps.
class LabelPlace : public QWidget {
  public:
    LabelPlace(QLabel* label, bool grows, QWidget* parent)
        : QWidget(parent)
        , label_(label)
        , grows_(grows) {
        label->setParent(this);
        label->setMargin(kLabelMargin);
    }
    [[nodiscard]] QSize sizeHint() const override {
        const QSize needed = label_->sizeHint();
        return {grows_ ? std::max(width_, needed.width()) : 0, needed.height()};
    }
    [[nodiscard]] QSize minimumSizeHint() const override { return sizeHint(); }

  protected:
    bool event(QEvent* event) override {
        const bool mayHaveGrown = event->type() == QEvent::LayoutRequest || event->type() == QEvent::ShowToParent;
        if (mayHaveGrown && grows_ && sizeHint().width() > width_) {
            width_ = sizeHint().width();
            updateGeometry();
        }
        return QWidget::event(event);
    }
    void resizeEvent(QResizeEvent*) override { label_->setGeometry(rect()); }

  private:
    QLabel* label_;
    bool grows_;
    int width_ = 0;
};

} // namespace

StatusRow::StatusRow(QWidget* parent)
    : QStatusBar(parent)
    , hint_(new PlainLabel(this))
    , pointer_(new PlainLabel(this))
    , zoom_(new PlainLabel(this)) {
    hint_->setObjectName(QStringLiteral("hint"));
    pointer_->setObjectName(QStringLiteral("pointer"));
    zoom_->setObjectName(QStringLiteral("zoom"));
    addWidget(new LabelPlace(hint_, false, this), 1);
    addPermanentWidget(new LabelPlace(pointer_, true, this));
    addPermanentWidget(new LabelPlace(zoom_, true, this));
    retranslateUi();
}

void StatusRow::showHint(const QString& hint) {
    if (!isTelling_)
        hint_->setText(hint);
}

void StatusRow::tell(const QString& text) {
    hint_->setText(printable(text));
    isTelling_ = true;
}

void StatusRow::endTelling() {
    if (std::exchange(isTelling_, false))
        hint_->clear();
}

void StatusRow::forgetPointer() {
    at_.reset();
    pointer_->clear();
    if (!isTelling_)
        hint_->clear();
}

void StatusRow::showPointer(Point at) {
    if (at != at_)
        isTelling_ = false;
    at_ = at;
    pointer_->setText(
        tr("x %1   y %2", "the pointer's coordinates").arg(shownNumber(at.x, kDigits), shownNumber(at.y, kDigits)));
}

void StatusRow::showZoom(double percent) {
    percent_ = percent;
    QLocale locale;
    locale.setNumberOptions(QLocale::OmitGroupSeparator);
    zoom_->setText(tr("%1 %", "zoom in percent")
                       .arg(percent < 1000 ? locale.toString(percent, 'g', 3) : locale.toString(percent, 'f', 0)));
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
    if (at_)
        showPointer(*at_);
    showZoom(percent_);
}

} // namespace kriva::ui
