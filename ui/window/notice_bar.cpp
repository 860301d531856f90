#include "ui/window/notice_bar.h"

#include "ui/base/language/plain_text.h"
#include "ui/base/look/plain_label.h"
#include "ui/window/document_session.h"

#include <QEvent>
#include <QHBoxLayout>
#include <QPushButton>

namespace kriva::ui {
namespace {

constexpr int kNoticeMargin = 6; // px: a row that is seen, and takes little of the canvas
constexpr int kNameWidth = 400;  // px: of most names all is seen; a name is one word, and would widen the window

} // namespace

NoticeBar::NoticeBar(DocumentSession& session, QWidget* parent)
    : QFrame(parent)
    , session_(session)
    , text_(new PlainLabel(this))
    , action_(new QPushButton(this))
    , leave_(new QPushButton(this)) {
    setObjectName(QStringLiteral("notice"));
    action_->setObjectName(QStringLiteral("act"));
    leave_->setObjectName(QStringLiteral("leave"));
    setAutoFillBackground(true);
    setBackgroundRole(QPalette::ToolTipBase);
    text_->setForegroundRole(QPalette::ToolTipText);
    text_->setWordWrap(true);
    auto* layout = new QHBoxLayout(this);
    layout->setContentsMargins(2 * kNoticeMargin, kNoticeMargin, kNoticeMargin, kNoticeMargin);
    layout->addWidget(text_, 1);
    layout->addWidget(action_);
    layout->addWidget(leave_);
    hide();
    connect(action_, &QPushButton::clicked, this, &NoticeBar::act);
    connect(leave_, &QPushButton::clicked, this, &QWidget::hide);
    connect(&session.fileWatch(), &FileWatch::changed, this, &NoticeBar::show);
    connect(&session, &DocumentSession::pathChanged, this, &NoticeBar::retranslateUi);
    retranslateUi();
}

void NoticeBar::show(FileState state) {
    state_ = state;
    retranslateUi();
    setVisible(state != FileState::Same);
}

void NoticeBar::act() {
    state_ == FileState::Gone ? session_.save() : session_.reload();
}

void NoticeBar::changeEvent(QEvent* event) {
    if (event->type() == QEvent::LanguageChange)
        retranslateUi();
    QFrame::changeEvent(event);
}

void NoticeBar::retranslateUi() {
    const bool isGone = state_ == FileState::Gone;
    const QString name = text_->fontMetrics().elidedText(printable(session_.name()), Qt::ElideMiddle, kNameWidth);
    text_->setText((isGone ? tr("The file “%1” was deleted or moved by another program.")
                           : tr("Another program changed the file “%1”."))
                       .arg(name));
    text_->setToolTip(toolTipOf(session_.path()));
    action_->setText(isGone ? tr("Save again") : tr("Reload"));
    leave_->setText(tr("Leave as it is"));
}

} // namespace kriva::ui
