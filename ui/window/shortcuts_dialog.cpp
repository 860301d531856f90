#include "ui/window/shortcuts_dialog.h"

#include <QDialogButtonBox>
#include <QEvent>
#include <QLineEdit>
#include <QTreeWidget>
#include <QVBoxLayout>

namespace kriva::ui {
namespace {

constexpr int kPadding = 5;       // px: rows of a table that is read across
constexpr int kTitlePadding = 12; // px: and room before the next group
constexpr int kGap = 16;          // px between the columns

} // namespace

ShortcutsDialog::ShortcutsDialog(Sheet sheet, QWidget* parent)
    : QDialog(parent)
    , sheet_(std::move(sheet))
    , filter_(new QLineEdit(this))
    , list_(new QTreeWidget(this))
    , buttons_(new QDialogButtonBox(QDialogButtonBox::Close, this)) {
    setObjectName(QStringLiteral("shortcuts"));
    filter_->setClearButtonEnabled(true);
    list_->setColumnCount(2);
    list_->setRootIsDecorated(false);
    list_->setItemsExpandable(false);
    list_->setAlternatingRowColors(true);
    auto* layout = new QVBoxLayout(this);
    layout->addWidget(filter_);
    layout->addWidget(list_);
    layout->addWidget(buttons_);
    resize(860, 680);
    connect(filter_, &QLineEdit::textChanged, this, &ShortcutsDialog::narrow);
    connect(buttons_, &QDialogButtonBox::rejected, this, &QDialog::close);
    retranslateUi();
}

void ShortcutsDialog::changeEvent(QEvent* event) {
    if (event->type() == QEvent::LanguageChange)
        retranslateUi();
    QDialog::changeEvent(event);
}

void ShortcutsDialog::retranslateUi() {
    setWindowTitle(tr("Shortcuts"));
    filter_->setPlaceholderText(tr("Search"));
    filter_->setAccessibleName(tr("Search"));
    list_->setAccessibleName(tr("Shortcuts"));
    list_->setHeaderLabels({tr("What it does"), tr("Keys and mouse")});
    fill();
}

void ShortcutsDialog::fill() {
    list_->clear();
    for (const ShortcutGroup& group : sheet_()) {
        auto* title = new QTreeWidgetItem(list_, {group.title});
        title->setFirstColumnSpanned(true);
        title->setFlags(Qt::ItemIsEnabled);
        QFont font = list_->font();
        font.setBold(true);
        title->setFont(0, font);
        title->setSizeHint(0, {0, fontMetrics().height() + kTitlePadding});
        for (const ShortcutGroup::Row& row : group.rows)
            (new QTreeWidgetItem(title, {row.what, row.keys}))->setSizeHint(1, {0, fontMetrics().height() + kPadding});
    }
    list_->expandAll();
    list_->resizeColumnToContents(0);
    list_->setColumnWidth(0, list_->columnWidth(0) + kGap);
    narrow();
}

void ShortcutsDialog::narrow() {
    const QString wanted = filter_->text().trimmed();
    for (int i = 0; i < list_->topLevelItemCount(); ++i) {
        QTreeWidgetItem* group = list_->topLevelItem(i);
        const bool isWhole = group->text(0).contains(wanted, Qt::CaseInsensitive);
        bool isEmpty = true;
        for (int k = 0; k < group->childCount(); ++k) {
            QTreeWidgetItem* row = group->child(k);
            const bool isFound = isWhole || row->text(0).contains(wanted, Qt::CaseInsensitive) ||
                                 row->text(1).contains(wanted, Qt::CaseInsensitive);
            row->setHidden(!isFound);
            isEmpty = isEmpty && !isFound;
        }
        group->setHidden(isEmpty);
    }
}

} // namespace kriva::ui
