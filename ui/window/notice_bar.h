#pragma once

#include "ui/document/sharing/file_watch.h"

#include <QFrame>

class QLabel;
class QPushButton;

namespace kriva::ui {

class DocumentSession;

/// A row above the tabs that says when another program changed or removed the document's file, and what can be done. It
/// asks nothing and keeps nobody from working.
class NoticeBar : public QFrame {
    Q_OBJECT
  public:
    NoticeBar(DocumentSession& session, QWidget* parent);

  protected:
    void changeEvent(QEvent* event) override;

  private:
    void show(FileState state);
    void act();
    void retranslateUi();

    DocumentSession& session_;
    FileState state_ = FileState::Same;
    QLabel* text_;
    QPushButton* action_; ///< reload, or save again
    QPushButton* leave_;
};

} // namespace kriva::ui
