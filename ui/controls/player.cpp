#include "ui/controls/player.h"

#include "ui/base/language/number_text.h"
#include "ui/base/look/icons.h"
#include "ui/base/look/plain_label.h"
#include "ui/controls/focused_wheel.h"

#include <QEvent>
#include <QGridLayout>
#include <QHBoxLayout>
#include <QKeyEvent>
#include <QSignalBlocker>

#include <algorithm>

namespace kriva::ui {

Player::Player(QWidget* parent)
    : QFrame(parent)
    , back_(button("back"))
    , play_(button("play"))
    , forward_(button("forward"))
    , slower_(button("slower"))
    , faster_(button("faster"))
    , direction_(button("direction"))
    , loop_(button("loop"))
    , keep_(button("keep"))
    , scrubber_(new QSlider(Qt::Horizontal, this))
    , speed_(new PlainLabel(this))
    , stageText_(new PlainLabel(this)) {
    layOut();
    back_->setIcon(icon(IconName::StepBack));
    forward_->setIcon(icon(IconName::StepForward));
    slower_->setIcon(icon(IconName::Slower));
    faster_->setIcon(icon(IconName::Faster));
    loop_->setIcon(icon(IconName::Loop));
    loop_->setCheckable(true);
    keep_->setToolButtonStyle(Qt::ToolButtonTextOnly);
    keep_->setAutoRaise(false);
    speed_->setAlignment(Qt::AlignCenter);
    scrubber_->installEventFilter(this);
    takeWheelWithFocusOnly(*scrubber_);
    scrubber_->setObjectName(QStringLiteral("scrubber"));
    setFocusPolicy(Qt::StrongFocus);
    timer_.setInterval(clock_.interval());

    connect(&timer_, &QTimer::timeout, this, &Player::tick);
    connect(play_, &QToolButton::clicked, this, &Player::toggle);
    connect(back_, &QToolButton::clicked, this, [this] { goTo(clock_.stage - 1); });
    connect(forward_, &QToolButton::clicked, this, [this] { goTo(clock_.stage + 1); });
    connect(slower_, &QToolButton::clicked, this, [this] { setSpeed(clock_.speed / 2); });
    connect(faster_, &QToolButton::clicked, this, [this] { setSpeed(clock_.speed * 2); });
    connect(direction_, &QToolButton::clicked, this, [this] {
        clock_.direction = static_cast<PlayDirection>((static_cast<int>(clock_.direction) + 1) % 3);
        retranslateUi();
    });
    connect(loop_, &QToolButton::toggled, this, [this](bool on) { clock_.isLooping = on; });
    connect(scrubber_, &QSlider::valueChanged, this, &Player::goTo);
    connect(keep_, &QToolButton::clicked, this, &Player::keepRequested);
    retranslateUi();
}

void Player::layOut() {
    auto* layout = new QGridLayout(this);
    auto* buttons = new QHBoxLayout;
    buttons->setSpacing(0);
    for (QWidget* widget : {back_, play_, forward_})
        buttons->addWidget(widget);
    buttons->addStretch(1);
    for (QWidget* widget : std::initializer_list<QWidget*>{slower_, speed_, faster_})
        buttons->addWidget(widget);
    buttons->addStretch(1);
    for (QWidget* widget : {direction_, loop_})
        buttons->addWidget(widget);
    layout->setContentsMargins(0, 0, 0, 0);
    layout->addLayout(buttons, 0, 0);
    layout->addWidget(scrubber_, 1, 0);
    auto* below = new QHBoxLayout;
    below->addWidget(stageText_, 1);
    below->addWidget(keep_);
    layout->addLayout(below, 2, 0);
}

QToolButton* Player::button(const char* name) {
    auto* made = new QToolButton(this);
    made->setObjectName(QString::fromLatin1(name));
    made->setAutoRaise(true);
    made->setFocusPolicy(Qt::TabFocus);
    return made;
}

void Player::setPace(double stagesPerSecond) {
    if (clock_.pace == stagesPerSecond) // a timer that is set again begins anew
        return;
    clock_.pace = stagesPerSecond;
    timer_.setInterval(clock_.interval());
}

void Player::setLast(int last) {
    clock_.last = last;
    clock_.stage = std::min(clock_.stage, last);
    showState();
}

void Player::setStage(int stage) {
    clock_.stage = std::clamp(stage, 0, clock_.last);
    showState();
}

void Player::setSpeed(double factor) {
    clock_.speed = std::clamp(factor, kSlowest, kFastest);
    timer_.setInterval(clock_.interval());
    showState();
}

void Player::pause() {
    timer_.stop();
    retranslateUi();
}

void Player::toggle() {
    if (isPlaying()) {
        pause();
        return;
    }
    clock_.rewindAtEnd();
    timer_.start();
    showState();
    retranslateUi();
    Q_EMIT stageChanged(clock_.stage);
}

void Player::tick() {
    if (!clock_.advance())
        pause();
    showState();
    Q_EMIT stageChanged(clock_.stage);
}

void Player::goTo(int stage) {
    pause();
    setStage(stage);
    Q_EMIT stageChanged(clock_.stage);
}

void Player::showState() {
    const QSignalBlocker blocker(scrubber_);
    scrubber_->setRange(0, clock_.last);
    scrubber_->setValue(clock_.stage);
    const QSignalBlocker loopBlocker(loop_);
    loop_->setChecked(clock_.isLooping);
    setEnabled(clock_.last > 0);
    back_->setEnabled(clock_.stage > 0);
    forward_->setEnabled(clock_.stage < clock_.last);
    slower_->setEnabled(clock_.speed > kSlowest);
    faster_->setEnabled(clock_.speed < kFastest);
    speed_->setText(tr("%1×", "speed of an animation").arg(formatNumber(clock_.speed)));
}

void Player::changeEvent(QEvent* event) {
    if (event->type() == QEvent::LanguageChange)
        retranslateUi();
    else if (event->type() == QEvent::EnabledChange && !isEnabled())
        pause(); // there is nothing to play through
    QFrame::changeEvent(event);
}

void Player::retranslateUi() {
    const auto name = [](QToolButton* button, const QString& text) {
        button->setAccessibleName(text);
        button->setToolTip(text);
    };
    name(back_, tr("One stage back"));
    name(forward_, tr("One stage on"));
    name(play_, isPlaying() ? tr("Pause") : tr("Play"));
    play_->setIcon(icon(isPlaying() ? IconName::Pause : IconName::Play));
    name(slower_, tr("Slower"));
    name(faster_, tr("Faster"));
    name(loop_, tr("Over and over"));
    switch (clock_.direction) {
    case PlayDirection::forwards:
        name(direction_, tr("Direction of the animation: forwards"));
        direction_->setIcon(icon(IconName::DirectionForward));
        break;
    case PlayDirection::backwards:
        name(direction_, tr("Direction of the animation: backwards"));
        direction_->setIcon(icon(IconName::DirectionBackward));
        break;
    case PlayDirection::toAndFro:
        name(direction_, tr("Direction of the animation: to and fro"));
        direction_->setIcon(icon(IconName::DirectionBoth));
        break;
    }
    setAccessibleName(tr("Animation"));
    speed_->setAccessibleName(tr("Animation speed"));
    scrubber_->setAccessibleName(tr("Stage"));
    keep_->setText(tr("Keep this stage"));
    keep_->setToolTip(tr("Writes the stage on view into the document"));
    showState();
}

void Player::keyPressEvent(QKeyEvent* event) {
    if (!takeKey(event->key()))
        QFrame::keyPressEvent(event);
}

bool Player::eventFilter(QObject* watched, QEvent* event) {
    if (event->type() == QEvent::KeyPress && takeKey(static_cast<QKeyEvent*>(event)->key()))
        return true;
    return QFrame::eventFilter(watched, event);
}

bool Player::takeKey(int key) {
    switch (key) {
    case Qt::Key_Space:
        toggle();
        return true;
    case Qt::Key_Left:
        goTo(clock_.stage - 1);
        return true;
    case Qt::Key_Right:
        goTo(clock_.stage + 1);
        return true;
    default:
        return false;
    }
}

} // namespace kriva::ui
