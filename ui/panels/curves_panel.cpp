#include "ui/panels/curves_panel.h"

#include "ui/base/look/icons.h"
#include "ui/editing/sheet_editor.h"
#include "ui/panels/style_editor.h"

#include <QColorDialog>
#include <QCoreApplication>
#include <QEvent>
#include <QHBoxLayout>
#include <QPainter>
#include <QSignalBlocker>
#include <QStyledItemDelegate>
#include <QVBoxLayout>

namespace kriva::ui {
namespace {

/// Frames the colours of curves, so that the blue of a curve is seen on the blue of the selection, and keeps a style
/// from tinting them there.
class CurveDelegate : public QStyledItemDelegate {
  public:
    using QStyledItemDelegate::QStyledItemDelegate;

  protected:
    void initStyleOption(QStyleOptionViewItem* option, const QModelIndex& index) const override {
        QStyledItemDelegate::initStyleOption(option, index);
        QPixmap swatch(option->decorationSize);
        swatch.fill(index.data(Qt::DecorationRole).value<QColor>());
        QPainter painter(&swatch);
        painter.setPen(option->palette.color(QPalette::Base));
        painter.drawRect(swatch.rect().adjusted(0, 0, -1, -1));
        option->icon = QIcon(swatch);
        option->icon.addPixmap(swatch, QIcon::Selected);
    }
};

} // namespace

CurvesPanel::CurvesPanel(SheetEditor& editor, QWidget* parent)
    : QWidget(parent)
    , editor_(editor)
    , model_(editor)
    , list_(new QListView(this))
    , add_(new QToolButton(this))
    , duplicate_(new QToolButton(this))
    , delete_(new QToolButton(this))
    , up_(new QToolButton(this))
    , down_(new QToolButton(this))
    , color_(new QToolButton(this))
    , style_(new QToolButton(this))
    , styleEditor_(new StyleEditor(editor, this)) {
    list_->setObjectName(QStringLiteral("curves"));
    list_->setModel(&model_);
    list_->setItemDelegate(new CurveDelegate(list_));
    list_->setFrameShape(QFrame::NoFrame);
    list_->setUniformItemSizes(true);
    list_->setEditTriggers(QAbstractItemView::DoubleClicked | QAbstractItemView::EditKeyPressed);
    add_->setIcon(icon(IconName::New));
    duplicate_->setIcon(icon(IconName::Duplicate));
    delete_->setIcon(icon(IconName::Delete));
    up_->setIcon(icon(IconName::Up));
    down_->setIcon(icon(IconName::Down));
    style_->setIcon(icon(IconName::More));
    style_->setCheckable(true);
    styleEditor_->hide();
    auto* buttons = new QHBoxLayout;
    buttons->setSpacing(0);
    for (QToolButton* button : {add_, duplicate_, delete_, up_, down_, color_, style_}) {
        button->setAutoRaise(true);
        button->setFocusPolicy(Qt::TabFocus);
        buttons->addWidget(button);
    }
    buttons->addStretch(1);
    auto* layout = new QVBoxLayout(this);
    layout->setContentsMargins(0, 0, 0, 0);
    layout->setSpacing(2);
    layout->addWidget(list_, 1);
    layout->addLayout(buttons);
    layout->addWidget(styleEditor_);
    connectButtons();
    retranslateUi();
}

void CurvesPanel::connectButtons() {
    connect(add_, &QToolButton::clicked, &editor_, &SheetEditor::beginCurve);
    connect(duplicate_, &QToolButton::clicked, this, [this] { editor_.duplicateCurve(editor_.activeSerial()); });
    connect(delete_, &QToolButton::clicked, this, [this] { editor_.deleteCurve(editor_.activeSerial()); });
    connect(up_, &QToolButton::clicked, this,
            [this] { editor_.moveCurve(editor_.activeSerial(), editor_.sheet().view.activeCurve - 1); });
    connect(down_, &QToolButton::clicked, this,
            [this] { editor_.moveCurve(editor_.activeSerial(), editor_.sheet().view.activeCurve + 1); });
    connect(color_, &QToolButton::clicked, this, &CurvesPanel::chooseColor);
    connect(style_, &QToolButton::toggled, styleEditor_, &QWidget::setVisible);
    connect(list_->selectionModel(), &QItemSelectionModel::currentChanged, this, [this](const QModelIndex& index) {
        if (index.isValid())
            editor_.activate(model_.serialAt(index.row()));
    });
    connect(&editor_.document(), &OpenDocument::viewChanged, this, &CurvesPanel::showState);
    connect(&model_, &QAbstractItemModel::modelReset, this, &CurvesPanel::showState);
    connect(&model_, &QAbstractItemModel::dataChanged, this, &CurvesPanel::showState);
}

void CurvesPanel::changeEvent(QEvent* event) {
    if (event->type() == QEvent::LanguageChange)
        retranslateUi();
    QWidget::changeEvent(event);
}

void CurvesPanel::retranslateUi() {
    const auto name = [](QToolButton* button, const QString& text) {
        button->setToolTip(text);
        button->setAccessibleName(text);
    };
    name(add_, tr("New curve"));
    name(duplicate_, tr("Duplicate the curve"));
    name(delete_, tr("Delete the curve"));
    name(up_, tr("Move the curve up"));
    name(down_, tr("Move the curve down"));
    name(color_, tr("Colour of the curve"));
    name(style_, tr("Style of the curve"));
    list_->setAccessibleName(tr("Curves"));
    model_.retranslate();
    showState();
}

void CurvesPanel::showState() {
    const int active = editor_.sheet().view.activeCurve;
    const int last = model_.rowCount() - 1;
    const QSignalBlocker blocker(list_->selectionModel());
    list_->setCurrentIndex(model_.index(active));
    list_->viewport()->update(); // the blocked selection model has not told the view
    for (QToolButton* button : {duplicate_, delete_, color_})
        button->setEnabled(last >= 0);
    up_->setEnabled(active > 0);
    down_->setEnabled(active < last);
    QPixmap swatch(color_->iconSize());
    swatch.fill(last >= 0 ? model_.index(active).data(Qt::DecorationRole).value<QColor>() : Qt::transparent);
    color_->setIcon(swatch);
}

void CurvesPanel::beginRenaming() {
    list_->setFocus();
    list_->edit(list_->currentIndex());
}

void CurvesPanel::chooseColor() {
    const Serial serial = editor_.activeSerial();
    const QColor before = model_.index(editor_.sheet().view.activeCurve).data(Qt::DecorationRole).value<QColor>();
    const QColor chosen = QColorDialog::getColor(before, this, tr("Colour of the curve"));
    const Curve* curve = editor_.document().find(editor_.index(), serial);
    if (!chosen.isValid() || !curve)
        return;
    CurveStyle style = styleOf(*curve);
    style.color = Color{static_cast<std::uint8_t>(chosen.red()), static_cast<std::uint8_t>(chosen.green()),
                        static_cast<std::uint8_t>(chosen.blue())};
    editor_.styleCurve(serial, style, {QT_TRANSLATE_NOOP("Step", "Colour the curve")});
}

} // namespace kriva::ui
