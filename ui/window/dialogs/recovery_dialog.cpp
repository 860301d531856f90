#include "ui/window/dialogs/recovery_dialog.h"

#include "ui/base/language/plain_text.h"
#include "ui/base/look/icons.h"
#include "ui/base/look/plain_label.h"

#include <QComboBox>
#include <QDialogButtonBox>
#include <QDir>
#include <QEvent>
#include <QFileInfo>
#include <QGridLayout>
#include <QLocale>
#include <QPushButton>
#include <QScrollArea>

namespace kriva::ui {
namespace {

constexpr int kSignSize = 64;
constexpr int kEdge = 20;
constexpr int kRowGap = 12;
constexpr int kPlaceWidth = 400; // px: of most folders all is seen
constexpr int kTallest = 380;    // px of rows; beyond, they scroll

/// The folder as people write it, its middle left out where it is long; file names are never broken.
[[nodiscard]] QString shownFolder(const QString& path, const QFontMetrics& metrics) {
    QString folder = printable(QFileInfo(path).path());
    if (folder == QDir::homePath() || folder.startsWith(QDir::homePath() + QLatin1Char('/')))
        folder.replace(0, QDir::homePath().size(), QStringLiteral("~"));
    return metrics.elidedText(folder, Qt::ElideMiddle, kPlaceWidth);
}

void setBold(QLabel& label, qreal times = 1) {
    QFont font = label.font();
    font.setBold(true);
    font.setPointSizeF(font.pointSizeF() * times);
    label.setFont(font);
}

void add(QComboBox& choice, RecoveryChoice value) {
    choice.addItem(QString(), static_cast<int>(value));
}

} // namespace

RecoveryDialog::RecoveryDialog(std::span<const FoundRecovery> found, QWidget* parent)
    : QDialog(parent)
    , title_(new PlainLabel(this))
    , text_(new PlainLabel(this))
    , goOn_(new QPushButton(this))
    , later_(new QPushButton(this)) {
    setObjectName(QStringLiteral("recovery"));
    setWindowIcon(applicationIcon());
    setBold(*title_, 1.3);
    text_->setWordWrap(true);
    auto* sign = new PlainLabel(this);
    sign->setPixmap(applicationIcon().pixmap(kSignSize, kSignSize));
    auto* layout = new QGridLayout(this);
    layout->setContentsMargins(kEdge, kEdge, kEdge, kRowGap);
    layout->setHorizontalSpacing(kEdge);
    layout->setVerticalSpacing(kRowGap);
    layout->addWidget(sign, 0, 0, 3, 1, Qt::AlignTop);
    layout->addWidget(title_, 0, 1);
    layout->addWidget(text_, 1, 1);
    layout->addWidget(makeRows(found), 2, 1);
    auto* buttons = new QDialogButtonBox(this);
    buttons->addButton(goOn_, QDialogButtonBox::AcceptRole);
    buttons->addButton(later_, QDialogButtonBox::RejectRole);
    goOn_->setObjectName(QStringLiteral("goOn"));
    goOn_->setDefault(true);
    later_->setObjectName(QStringLiteral("later"));
    layout->addWidget(buttons, 3, 0, 1, 2);
    layout->setRowStretch(2, 1);
    connect(buttons, &QDialogButtonBox::accepted, this, &QDialog::accept);
    connect(buttons, &QDialogButtonBox::rejected, this, &QDialog::reject);
    retranslateUi();
}

QWidget* RecoveryDialog::makeRows(std::span<const FoundRecovery> found) {
    auto* area = new QScrollArea(this);
    auto* inside = new QWidget(area);
    auto* layout = new QGridLayout(inside);
    layout->setContentsMargins(kRowGap, kRowGap, kRowGap, kRowGap);
    layout->setHorizontalSpacing(kEdge);
    layout->setVerticalSpacing(2);
    layout->setColumnStretch(0, 1);
    int line = 0;
    for (const FoundRecovery& one : found) {
        const Row row = makeRow(one, inside);
        if (line > 0)
            layout->setRowMinimumHeight(line++, kRowGap);
        layout->addWidget(row.choice, line, 1, row.damage ? 3 : 2, 1, Qt::AlignVCenter);
        for (QLabel* label : {row.name, row.place, row.damage})
            if (label)
                layout->addWidget(label, line++, 0);
        rows_.push_back(row);
    }
    layout->setRowStretch(line, 1);
    area->setWidget(inside);
    area->setWidgetResizable(true);
    area->setHorizontalScrollBarPolicy(Qt::ScrollBarAlwaysOff);
    area->setFocusPolicy(Qt::NoFocus);
    inside->setAutoFillBackground(true);
    inside->setBackgroundRole(QPalette::Base);
    for (const Row& row : rows_)
        retranslate(row);
    area->setMinimumSize(inside->sizeHint().width() + 2 * kRowGap, std::min(inside->sizeHint().height() + 2, kTallest));
    area->setMaximumHeight(inside->sizeHint().height() + 2);
    return area;
}

RecoveryDialog::Row RecoveryDialog::makeRow(const FoundRecovery& found, QWidget* parent) const {
    Row row{&found, new PlainLabel(parent), new PlainLabel(parent), nullptr, new QComboBox(parent)};
    setBold(*row.name);
    row.choice->setSizeAdjustPolicy(QComboBox::AdjustToContents); // its words come later, and change
    row.place->setMinimumWidth(kPlaceWidth);
    if (found.state != RecoveryState::Whole)
        row.damage = new PlainLabel(parent);
    if (found.state == RecoveryState::Whole || found.state == RecoveryState::Damaged)
        add(*row.choice, RecoveryChoice::Recover);
    add(*row.choice, RecoveryChoice::Later);
    add(*row.choice, RecoveryChoice::Discard);
    return row;
}

void RecoveryDialog::retranslate(const Row& row) {
    const QString path = row.found->note ? row.found->note->path : QString();
    const QString name = path.isEmpty() ? tr("Untitled") : printable(QFileInfo(path).fileName());
    const QString time = QLocale().toString(row.found->time, QLocale::ShortFormat);
    row.name->setText(row.name->fontMetrics().elidedText(name, Qt::ElideMiddle, kPlaceWidth));
    row.place->setText(
        path.isEmpty()
            ? tr("never saved · changed %1", "a document and a time").arg(time)
            : tr("%1 · changed %2", "a folder and a time").arg(shownFolder(path, row.place->fontMetrics()), time));
    if (row.damage)
        row.damage->setText(damageText(row.found->state));
    row.choice->setAccessibleName(tr("What to do with %1").arg(name));
    for (int i = 0; i < row.choice->count(); ++i) {
        switch (static_cast<RecoveryChoice>(row.choice->itemData(i).toInt())) {
        case RecoveryChoice::Recover:
            row.choice->setItemText(i, tr("Recover"));
            break;
        case RecoveryChoice::Later:
            row.choice->setItemText(i, tr("Ask later"));
            break;
        case RecoveryChoice::Discard:
            row.choice->setItemText(i, tr("Discard"));
            break;
        }
    }
}

QString RecoveryDialog::damageText(RecoveryState state) {
    switch (state) {
    case RecoveryState::Whole:
        return {};
    case RecoveryState::Damaged:
        return tr("Damaged: look closely at what is recovered.");
    case RecoveryState::Unreadable:
        return tr("Damaged: it cannot be read any more.");
    case RecoveryState::Missing:
        return tr("Missing: the unsaved work is not there any more.");
    }
    return {};
}

std::vector<RecoveryChoice> RecoveryDialog::choices() const {
    std::vector<RecoveryChoice> choices;
    for (const Row& row : rows_)
        choices.push_back(result() == QDialog::Accepted ? static_cast<RecoveryChoice>(row.choice->currentData().toInt())
                                                        : RecoveryChoice::Later);
    return choices;
}

void RecoveryDialog::changeEvent(QEvent* event) {
    if (event->type() == QEvent::LanguageChange)
        retranslateUi();
    QDialog::changeEvent(event);
}

void RecoveryDialog::retranslateUi() {
    setWindowTitle(tr("Recover unsaved work"));
    title_->setText(tr("Kriva ended before this was saved"));
    text_->setText(tr("What is recovered opens in a window of its own and is written to its file only when you save."));
    goOn_->setText(tr("&Continue"));
    later_->setText(tr("Ask &later about all"));
    for (const Row& row : rows_)
        retranslate(row);
}

} // namespace kriva::ui
