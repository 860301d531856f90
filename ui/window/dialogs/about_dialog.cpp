#include "ui/window/dialogs/about_dialog.h"

#include "ui/base/look/icons.h"

#include <QCoreApplication>
#include <QDialogButtonBox>
#include <QEvent>
#include <QGridLayout>
#include <QLabel>

namespace kriva::ui {
namespace {

constexpr int kIconSize = 96;

} // namespace

AboutDialog::AboutDialog(QWidget* parent)
    : QDialog(parent)
    , text_(new QLabel(this))
    , details_(new QLabel(this))
    , buttons_(new QDialogButtonBox(QDialogButtonBox::Close, this)) {
    auto* sign = new QLabel(this);
    sign->setPixmap(applicationIcon().pixmap(kIconSize, kIconSize));
    for (QLabel* label : {text_, details_}) {
        label->setWordWrap(true);
        label->setMinimumWidth(380);
    }
    auto* layout = new QGridLayout(this);
    layout->addWidget(sign, 0, 0, 2, 1, Qt::AlignTop);
    layout->addWidget(text_, 0, 1);
    layout->addWidget(details_, 1, 1);
    layout->addWidget(buttons_, 2, 0, 1, 2);
    layout->setHorizontalSpacing(20);
    layout->setContentsMargins(20, 20, 20, 12);
    connect(buttons_, &QDialogButtonBox::rejected, this, &QDialog::close);
    retranslateUi();
}

void AboutDialog::changeEvent(QEvent* event) {
    if (event->type() == QEvent::LanguageChange)
        retranslateUi();
    QDialog::changeEvent(event);
}

void AboutDialog::retranslateUi() {
    setWindowTitle(tr("About Kriva"));
    text_->setText(QStringLiteral("<h2>Kriva %1</h2><p>%2</p>")
                       .arg(QCoreApplication::applicationVersion(), tr("A workbench for Bézier curves.")));
    details_->setText(QStringLiteral("<p>%1</p><p>%2</p>")
                          .arg(tr("Free software under the MIT licence."),
                               tr("Built on %1 (LGPL, dynamically linked), Eigen, JSON for Modern C++ and pugixml.")
                                   .arg(QStringLiteral("Qt ") + QString::fromLatin1(qVersion()))));
}

} // namespace kriva::ui
