// Keeps the journal of the open document: see model/journal.
#pragma once

#include "app/background/journal_thread.h"
#include "model/document/document.h"
#include "model/document/journal_state.h"

#include <QObject>
#include <QTimer>

#include <atomic>
#include <chrono>
#include <functional>
#include <optional>
#include <utility>

namespace hairpaint::app {

/// After each step of the document its content goes to a thread of the journal's, which puts on the disk what is new
/// in it. Nothing is written before the first step. Lives on the GUI thread, which never waits but in flush() and
/// discard(), and there only while the disk answers; the document outlives it.
class Journal : public QObject
{
    Q_OBJECT
public:
    Journal(model::Document& document, const QString& root, QObject* parent = nullptr);
    ~Journal() override; ///< Flushes; what is on the disk stays, for the next start.
    /// How long a disk that does not answer is waited for.
    void setPatience(std::chrono::milliseconds patience) { m_thread.setPatience(patience); }

    /// The project's file, from the next step on. `file` is called at each step, on the GUI thread.
    void setPath(const QString& path, std::function<model::KnownFile()> file)
    {
        m_path = path;
        m_file = std::move(file);
    }
    /// While paused nothing is written: a restored history is taken over as a whole, not step by step.
    void setPaused(bool paused);
    /// The document was restored with this history.
    void takeOver(const model::RecoveredWork& work);
    [[nodiscard]] bool idle() const;                             ///< Nothing waits to be written.
    [[nodiscard]] bool isStopped() const { return m_isStopped; } ///< The newest step is not on the disk.
    /// Returns when all steps are on the disk or writing them has failed.
    void flush();
    /// Creates its folder again if it is missing, and retries failed writes. A timer also calls it.
    void lookAfterFolder();
    /// Deletes the journal: the work is saved or discarded.
    void discard();

Q_SIGNALS:
    /// A clause. The work goes on, but a crash would lose it; each further step and each look tries again.
    void stopped(const QString& reason);
    void resumed();
    /// Everything posted is on the disk.
    void kept();

private:
    void look();
    [[nodiscard]] model::JournalState present() const;
    void post(JournalThread::Task task);
    void tell(const QString& problem);

    model::Document& m_document;
    QString m_path;
    std::function<model::KnownFile()> m_file;
    QTimer m_soon;       ///< Zero: several signals of one step.
    QTimer m_nowAndThen; ///< While something is written.
    bool m_replaced = true;
    bool m_isPaused = false;
    bool m_isStopped = false;                    ///< See isStopped().
    std::pair<std::uint64_t, int> m_posted;      ///< Revision and index of the step that was posted last.
    bool m_written = false;                      ///< A state of this history was posted.
    std::optional<model::JournalState> m_before; ///< The last one that was saved; it is written with the first step.

    std::atomic<int> m_untold = 0; ///< Tasks that have ended, of which tell() has not heard.
    JournalThread m_thread;
};

} // namespace hairpaint::app
