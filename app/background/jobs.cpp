// Threads, the progress window, and input while it waits.
#include "app/background/jobs.h"

#include "app/background/counted_thread.h"
#include "app/background/thread_time.h"

#include <QApplication>
#include <QDialog>
#include <QDialogButtonBox>
#include <QElapsedTimer>
#include <QEventLoop>
#include <QLabel>
#include <QMouseEvent>
#include <QProgressBar>
#include <QPushButton>
#include <QTimer>
#include <QVBoxLayout>
#include <QWindow>

#include <atomic>

namespace hairpaint::app {

namespace {

constexpr int kMsUntilShown = 500;
constexpr int kMsBetweenLooks = 30;
constexpr int kMsUntilLeft = 2000; ///< After Cancel, while nothing is computed.
constexpr double kBusyMs = 3.0;    ///< Between two looks.

/// What the window and the thread of some work both use.
struct Watched
{
    std::function<void(const model::Progress&)> work;
    std::atomic<double> fraction = 0.0;
    std::atomic<bool> isToStop = false;
    std::mutex mutex;
    QEventLoop* loop = nullptr; ///< Null once nobody waits any more.
    bool hasEnded = false;
};

void workWatched(const std::shared_ptr<Watched>& watched)
{
    const sim::ArenaScope arena(sim::Arena::Background);
    watched->work([&watched](double done) {
        watched->fraction = done;
        return !watched->isToStop;
    });
    const std::lock_guard lock(watched->mutex);
    watched->hasEnded = true;
    if (watched->loop != nullptr)
        QMetaObject::invokeMethod(watched->loop, "quit", Qt::QueuedConnection); // It may not have begun yet.
}

/// What is done, how far it is, and Cancel.
class ProgressWindow : public QDialog
{
public:
    ProgressWindow(const QString& doing, QWidget& parent, const Jobs::Clock& clock)
        : QDialog(&parent), m_clock(clock), m_beganMs(clock())
    {
        setWindowTitle(Jobs::tr("Hair Paint"));
        setModal(true);
        setObjectName(QStringLiteral("progressWindow"));
        auto* layout = new QVBoxLayout(this);
        m_label = new QLabel(Jobs::tr("%1…").arg(doing), this);
        m_label->setMinimumWidth(320);
        m_bar = new QProgressBar(this);
        m_bar->setAccessibleName(doing);
        m_bar->setRange(0, 0); // Moves to and fro until it is known how far the work is.
        m_bar->setTextVisible(false);
        m_buttons = new QDialogButtonBox(QDialogButtonBox::Cancel, this);
        // It opens under keys that were meant for the dialog before: none of them may be taken for Cancel. So no button
        // is the default, and what shows how far the work is has the focus, one step before Cancel.
        m_buttons->button(QDialogButtonBox::Cancel)->setAutoDefault(false);
        m_bar->setFocusPolicy(Qt::StrongFocus);
        m_bar->setFocus();
        connect(m_buttons, &QDialogButtonBox::rejected, this, &ProgressWindow::reject);
        layout->addWidget(m_label);
        layout->addWidget(m_bar);
        layout->addWidget(m_buttons);
    }

    void showOnceLong()
    {
        if (!isVisible() && m_clock() - m_beganMs >= kMsUntilShown)
            show();
    }

    [[nodiscard]] bool cancelled() const { return m_busyMs.has_value(); }
    /// For long, and nothing has been computed meanwhile.
    [[nodiscard]] bool isLongCancelled(double processorMs)
    {
        if (cancelled() && processorMs > m_processorMs + kBusyMs)
            m_busyMs = m_clock();
        m_processorMs = processorMs;
        return cancelled() && m_clock() - *m_busyMs >= kMsUntilLeft;
    }

    void showFraction(double fraction)
    {
        if (fraction <= 0.0)
            return;
        m_bar->setRange(0, 100);
        m_bar->setValue(static_cast<int>(fraction * 100.0));
    }

    /// Cancel, Esc and the frame's close button: the window stays until the work has ended.
    void reject() override
    {
        if (!cancelled())
            m_busyMs = m_clock();
        m_label->setText(Jobs::tr("Cancelling…"));
        m_buttons->setEnabled(false);
    }

private:
    QLabel* m_label;
    QProgressBar* m_bar;
    QDialogButtonBox* m_buttons;
    const Jobs::Clock& m_clock;
    qint64 m_beganMs;
    std::optional<qint64> m_busyMs; ///< When Cancel was pressed, or when the work was last seen computing after it.
    double m_processorMs = 0.0;
};

/// Takes all input from everything but one window. Events go on being taken from the system, so that none of them is
/// left over for when the work is done.
class InputStop : public QObject
{
public:
    explicit InputStop(const QWidget& spared) : m_spared(spared), m_held(QGuiApplication::mouseButtons())
    {
        qApp->installEventFilter(this);
    }

protected:
    bool eventFilter(QObject* watched, QEvent* event) override
    {
        if (!stops(*event) || isSpared(watched))
            return QObject::eventFilter(watched, event);
        event->ignore();
        return true;
    }

private:
    [[nodiscard]] bool stops(const QEvent& event) const
    {
        switch (event.type()) {
        case QEvent::MouseButtonRelease: // What was pressed before may be let go.
            return !m_held.testFlag(static_cast<const QMouseEvent&>(event).button());
        case QEvent::MouseButtonPress:
        case QEvent::MouseButtonDblClick:
        case QEvent::MouseMove:
        case QEvent::Enter:
        case QEvent::HoverEnter:
        case QEvent::HoverMove:
        case QEvent::Wheel:
        case QEvent::KeyPress:
        case QEvent::ShortcutOverride:
        case QEvent::Shortcut:
        case QEvent::InputMethod:
        case QEvent::ContextMenu:
        case QEvent::TabletPress: // Its release comes through: nothing happens without a press, and a stroke ends.
        case QEvent::TabletMove:
        case QEvent::TouchBegin:
        case QEvent::TouchUpdate:
        case QEvent::NativeGesture:
        case QEvent::DragEnter:
        case QEvent::DragMove:
        case QEvent::Drop:
        case QEvent::Close:
            return true;
        default:
            return false;
        }
    }

    [[nodiscard]] bool isSpared(const QObject* watched) const
    {
        if (watched == m_spared.windowHandle())
            return true;
        while (watched != nullptr && watched != &m_spared)
            watched = watched->parent();
        return watched != nullptr;
    }

    const QWidget& m_spared;
    Qt::MouseButtons m_held;
};

/// Waits for `ended` with the window after a while; whether Cancel was pressed. `look` is called now and then.
template<typename Look>
bool watch(const QString& doing, QWidget& window, const Jobs::Clock& clock, QEventLoop& loop, const Look& look)
{
    while (QWidget* popup = QApplication::activePopupWidget())
        popup->close();
    ProgressWindow progress(doing, window, clock);
    const InputStop stop(progress);
    QTimer looks;
    QObject::connect(&looks, &QTimer::timeout, &progress, [&] {
        progress.showOnceLong();
        look(progress);
    });
    looks.start(kMsBetweenLooks);
    loop.exec();
    progress.hide();
    // What was clicked in the last moment is lost, too.
    QCoreApplication::processEvents();
    return progress.cancelled();
}

} // namespace

Jobs::Jobs(QWidget& window) : QObject(&window), m_window(window), m_ear(std::make_shared<Ear>())
{
    m_ear->jobs = this;
    QElapsedTimer sinceStart;
    sinceStart.start();
    m_clock = [sinceStart] { return sinceStart.elapsed(); };
}

Jobs::~Jobs()
{
    {
        const std::lock_guard lock(m_ear->mutex);
        m_ear->jobs = nullptr;
    }
    for (std::jthread& thread : m_threads)
        thread.request_stop();
    m_threads.clear(); // Waits for each.
}

WorkEnd Jobs::runWatched(const QString& doing, std::function<void(const model::Progress&)> work, bool mayBeLeft)
{
    QEventLoop loop;
    const auto watched = std::make_shared<Watched>();
    watched->work = std::move(work);
    watched->loop = &loop;
    std::thread thread = countedThread([watched] {
        workWatched(watched);
        watched->work = nullptr; // What it owns goes with it.
    });
    const bool cancelled = watch(doing, m_window, m_clock, loop, [&](ProgressWindow& progress) {
        progress.showFraction(watched->fraction);
        watched->isToStop = progress.cancelled();
        if (mayBeLeft && progress.isLongCancelled(processorMs(thread)))
            loop.quit();
    });
    watched->isToStop = true; // Where the program ends, the work has not.
    const bool isLeft = [&] {
        const std::lock_guard lock(watched->mutex);
        watched->loop = nullptr;
        return mayBeLeft && !watched->hasEnded;
    }();
    if (isLeft) {
        thread.detach();
        return WorkEnd::Left;
    }
    thread.join();
    return cancelled ? WorkEnd::Cancelled : WorkEnd::Done;
}

void Jobs::runLeft(std::function<std::function<void()>()> work)
{
    countedThread([work = std::move(work), ear = m_ear] {
        std::function<void()> told = work();
        const std::lock_guard lock(ear->mutex);
        if (ear->jobs != nullptr)
            ear->jobs->tellLater(std::move(told));
    }).detach();
}

bool Jobs::anyLeft()
{
    return anyCountedThread();
}

bool Jobs::awaitUntil(const Doing& doing, const std::function<bool()>& ready)
{
    if (ready())
        return true;
    QEventLoop loop;
    const bool isCancelled = watch(doing.text, m_window, m_clock, loop, [&](ProgressWindow& progress) {
        if (ready() || progress.cancelled())
            loop.quit();
    });
    const bool isReady = ready();
    if (isCancelled && !isReady)
        Q_EMIT cancelled(doing.whenCancelled);
    return isReady;
}

void Jobs::runUnwatched(Unwatched work)
{
    constexpr std::size_t kMostThreads = 2;
    const std::lock_guard lock(m_mutex);
    m_unwatched.push_back(std::move(work));
    if (m_threads.size() < kMostThreads)
        m_threads.emplace_back([this](const std::stop_token& stop) { workUnwatched(stop); });
    m_wanted.notify_one();
}

void Jobs::workUnwatched(const std::stop_token& stop)
{
    const sim::ArenaScope arena(sim::Arena::Background);
    for (;;) {
        Unwatched work;
        {
            std::unique_lock lock(m_mutex);
            if (!m_wanted.wait(lock, stop, [this] { return !m_unwatched.empty(); }) || stop.stop_requested())
                return;
            work = std::move(m_unwatched.front());
            m_unwatched.pop_front();
        }
        std::function<void()> told = work([&stop](double) { return !stop.stop_requested(); });
        tellLater(std::move(told));
    }
}

void Jobs::tellLater(std::function<void()> told)
{
    const std::lock_guard lock(m_mutex);
    m_told.push_back(std::move(told));
    QCoreApplication::postEvent(this, new QEvent(QEvent::User));
}

void Jobs::customEvent(QEvent* /*event*/)
{
    std::vector<std::function<void()>> told;
    {
        const std::lock_guard lock(m_mutex);
        told.swap(m_told);
    }
    for (const auto& tell : told)
        tell();
}

} // namespace hairpaint::app
