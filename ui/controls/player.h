#pragma once

#include "ui/controls/player_clock.h"

#include <QLabel>
#include <QSlider>
#include <QTimer>
#include <QToolButton>

namespace kriva::ui {

/// Plays through stages: play and pause, slower, faster, direction, loop, step and scrub. What a stage is, its owner
/// knows; playing is view state and changes no document.
class Player : public QFrame {
    Q_OBJECT
  public:
    explicit Player(QWidget* parent = nullptr);

    /// How many stages a second at speed 1: many where they flow into each other, few where each is to be read.
    void setPace(double stagesPerSecond);
    /// Where a stage is nothing that a document could keep, "Keep this stage" is not offered.
    void setKeepable(bool isKeepable) { keep_->setVisible(isKeepable); }
    /// Stages from 0 to `last`; a player with one stage only is disabled. A disabled player does not play.
    void setLast(int last);
    /// What the stage on view is: "t = 0.25".
    void setStageText(const QString& text) { stageText_->setText(text); }
    /// Shows a stage without telling anyone.
    void setStage(int stage);
    [[nodiscard]] int stage() const { return clock_.stage; }
    [[nodiscard]] bool isPlaying() const { return timer_.isActive(); }
    void pause();
    /// One tick of the running animation: the timer calls it, and so may a test.
    void tick();

  Q_SIGNALS:
    void stageChanged(int stage);
    /// "Keep this stage": the owner writes it into the document.
    void keepRequested();

  protected:
    void changeEvent(QEvent* event) override;
    void keyPressEvent(QKeyEvent* event) override;
    bool eventFilter(QObject* watched, QEvent* event) override;

  private:
    QToolButton* button(const char* name);
    void layOut();
    void retranslateUi();
    void showState();
    void toggle();
    void setSpeed(double factor);
    void goTo(int stage);
    bool takeKey(int key);

    PlayerClock clock_;
    QTimer timer_;
    QToolButton* back_;
    QToolButton* play_;
    QToolButton* forward_;
    QToolButton* slower_;
    QToolButton* faster_;
    QToolButton* direction_;
    QToolButton* loop_;
    QToolButton* keep_;
    QSlider* scrubber_;
    QLabel* speed_;
    QLabel* stageText_;
};

} // namespace kriva::ui
