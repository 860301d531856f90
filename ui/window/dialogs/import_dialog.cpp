#include "ui/window/dialogs/import_dialog.h"

#include "core/curve/limits.h"
#include "ui/base/language/plain_text.h"
#include "ui/base/look/plain_label.h"
#include "ui/document/error_text.h"
#include "ui/figures/caption_text.h"

#include <QEvent>
#include <QHBoxLayout>
#include <QPushButton>
#include <QVBoxLayout>

#include <utility>

namespace kriva::ui {
namespace {

constexpr double kLeastScale = 1e-6;
constexpr double kMostScale = 1e6;

/// Of the preview, which is drawn at every change: crossings that take longer are left out.
constexpr std::uint64_t kPreviewSteps = 500'000;

} // namespace

ImportDialog::ImportDialog(std::vector<ImportedPath> paths, SheetIndex sheet, QWidget* parent)
    : QDialog(parent)
    , paths_(std::move(paths))
    , sheet_(sheet)
    , preview_(new FigurePreview(this))
    , list_(new QListWidget(this))
    , listLabel_(new PlainLabel(this))
    , form_(new LabelledForm)
    , scale_(new NumberField(this))
    , x_(new NumberField(this))
    , y_(new NumberField(this))
    , told_(new PlainLabel(this))
    , buttons_(new QDialogButtonBox(QDialogButtonBox::Ok | QDialogButtonBox::Cancel, this)) {
    fill();
    layOut();
    connect(list_, &QListWidget::itemChanged, this, &ImportDialog::showCurves);
    for (NumberField* field : {scale_, x_, y_})
        connect(field, &NumberField::valueCommitted, this, &ImportDialog::showCurves);
    connect(buttons_, &QDialogButtonBox::accepted, this, &QDialog::accept);
    connect(buttons_, &QDialogButtonBox::rejected, this, &QDialog::reject);
    retranslateUi();
}

void ImportDialog::fill() {
    for (std::size_t i = 0; i < paths_.size(); ++i) {
        auto* item = new QListWidgetItem(list_);
        item->setCheckState(Qt::Checked);
    }
    scale_->setRange({kLeastScale, kMostScale});
    scale_->setValue(1);
    for (NumberField* field : {x_, y_}) {
        field->setRange({-limits::kNumber, limits::kNumber});
        field->setValue(0);
    }
}

void ImportDialog::layOut() {
    for (NumberField* field : {scale_, x_, y_})
        form_->addField(field);
    listLabel_->setBuddy(list_);
    told_->setWordWrap(true);
    auto* fields = new QVBoxLayout;
    fields->addWidget(listLabel_);
    fields->addWidget(list_, 1);
    fields->addLayout(form_);
    fields->addWidget(told_);
    auto* both = new QHBoxLayout;
    both->addWidget(preview_, 1);
    both->addLayout(fields);
    auto* layout = new QVBoxLayout(this);
    layout->addLayout(both, 1);
    layout->addWidget(buttons_);
}

void ImportDialog::changeEvent(QEvent* event) {
    if (event->type() == QEvent::LanguageChange)
        retranslateUi();
    QDialog::changeEvent(event);
}

void ImportDialog::retranslateUi() {
    setWindowTitle(tr("Import points"));
    listLabel_->setText(tr("&Curves"));
    list_->setAccessibleName(tr("Curves"));
    for (int i = 0; i < list_->count(); ++i)
        list_->item(i)->setText(nameOfPath(i));
    form_->setLabel(scale_, tr("&Scale"));
    form_->setLabel(x_, tr("Move by &x"));
    form_->setLabel(y_, tr("Move by &y"));
    preview_->setAccessibleName(tr("The curves as they will be"));
    buttons_->button(QDialogButtonBox::Ok)->setText(tr("&Import"));
    showCurves();
}

QString ImportDialog::nameOfPath(int index) const {
    const ImportedPath& path = paths_[static_cast<std::size_t>(index)];
    const auto points = static_cast<int>(pointsOf(path.path).size());
    const QString name = path.name.empty() ? QString::number(index + 1) : QString::fromStdString(path.name);
    return printable(QStringLiteral("%1: %2").arg(name, tr("%n point(s)", nullptr, points)));
}

std::vector<int> ImportDialog::chosen() const {
    std::vector<int> chosen;
    for (int i = 0; i < list_->count(); ++i)
        if (list_->item(i)->checkState() == Qt::Checked)
            chosen.push_back(i);
    return chosen;
}

void ImportDialog::showCurves() {
    const Placing placing{scale_->value(), {x_->value(), y_->value()}};
    const std::vector<int> chosen = this->chosen();
    std::vector<ImportedPath> paths;
    for (const int index : chosen)
        paths.push_back(paths_[static_cast<std::size_t>(index)]);
    auto read = importedCurves(paths, sheet_, placing);
    curves_.clear();
    told_->clear();
    if (FileError* error = std::get_if<FileError>(&read)) {
        if (error->curve > 0) // the list numbers those that are left out too
            error->curve = chosen[static_cast<std::size_t>(error->curve) - 1] + 1;
        told_->setText(printable(errorText(*error)));
    } else
        curves_ = std::get<std::vector<Curve>>(std::move(read));
    buttons_->button(QDialogButtonBox::Ok)->setEnabled(!curves_.empty());
    Document document;
    document.sheets[sheet_].curves = curves_;
    WorkBudget budget(kPreviewSteps);
    preview_->setDrawing(curves_.empty() ? Drawing() : drawingOf(document, sheet_, textSource(), {}, budget));
}

} // namespace kriva::ui
