// The open project's file: new, open, save, and the question before anything is lost.
#pragma once

#include "app/background/jobs.h"
#include "app/project/file_watch.h"
#include "app/project/open_file.h"
#include "app/project/project_questions.h"
#include "app/session/session.h"
#include "app/settings/settings.h"
#include "model/document/journal_state.h"
#include "model/files/project_file.h"

#include <QImage>
#include <QObject>

#include <functional>
#include <memory>
#include <optional>
#include <utility>
#include <vector>

namespace hairpaint::app {

/// Shows message boxes and file dialogs over `window`. Loading and saving run on another thread with progress; what a
/// disk or a network folder does not answer in time is left to itself.
class ProjectFiles : public QObject
{
    Q_OBJECT
public:
    ProjectFiles(Session& session, Settings& settings, Jobs& jobs, QWidget& window);

    [[nodiscard]] const QString& path() const { return m_file.path(); } ///< Empty: never saved.
    [[nodiscard]] QString displayName() const;
    /// Draws the picture that files are saved with, on a thread of the jobs'; made anew for each file, on this one.
    using Picture = std::function<QImage(const model::Progress&)>;
    void setThumbnailMaker(std::function<Picture()> maker);
    /// The stamp of the file when this window last read or wrote it.
    [[nodiscard]] model::KnownFile knownFile() const;
    /// The open project came from here; from nowhere, it may have a name all the same. Without a stamp the disk is
    /// asked for it.
    void setPath(const QString& path, const QString& nameWithoutPath = {}, const FileStamp& stamp = {});

    void newProject();     ///< With the first of the built-in styles.
    bool newBaldProject(); ///< With an empty group; false where the user wants to keep what is open.
    void open();           ///< Asks for the file.
    bool openPath(const QString& path);
    /// Whether that file is what is open, however its path is spelt.
    [[nodiscard]] bool isOpen(const QString& path);
    /// Replaces the open project, which nobody has changed, by what a journal kept.
    bool restore(const model::RecoveredWork& work);
    [[nodiscard]] static Doing restoring();
    bool save();
    bool saveAs();
    /// Offers to save; false where the user wants to stay.
    bool mayDiscard();
    /// Checks whether another program has changed the file; not every system reports that.
    void lookOutside() { m_watch.look(); }
    [[nodiscard]] bool isLooking() const { return m_watch.isLooking(); } ///< At the file, for what others did to it.

Q_SIGNALS:
    void pathChanged();
    /// Another project is being read or made; `doing`: what is done, the file named. openingEnded() follows.
    void openingBegan(const QString& doing);
    /// Whether it is the one that is open now.
    void openingEnded(bool isOpen);
    /// The file was changed or removed by others: a sentence, once until it is opened or saved again.
    void changedOutside(const QString& text);

private:
    /// Without a file.
    bool begin(const Doing& doing, const std::function<model::Project()>& make);
    [[nodiscard]] static Doing startingOfNew();
    [[nodiscard]] static Doing openingOf(const QString& path);
    struct Taken
    {
        bool isOpen = false;
        std::optional<model::Error> problem; ///< None where it was cancelled.
    };
    /// Reads a project and resolves its maps in the background; then it replaces the one that is open.
    Taken take(const Doing& doing, std::shared_ptr<model::EncodedLayers> encoded, const QString& path,
               Work<model::Project> read);
    Taken takeQuietly(const Doing& doing, std::shared_ptr<model::EncodedLayers> encoded, const QString& path,
                      Work<model::Project> read);
    /// What can be read of a damaged file replaces the open project, as one that was never saved.
    bool openRepaired(const QString& path);
    enum class Changed ///< By another program.
    {
        Ask,
        Replace
    };
    bool saveTo(const QString& path, Changed changed);
    bool saveUnder(const QString& suggested);
    /// Reports that a disk does not answer.
    bool saveElsewhere(const QString& path);
    struct Saved
    {
        FileStamp stamp;
        bool wasChanged = false; ///< By another program, so it was not saved.
    };
    [[nodiscard]] Work<Saved> savingOf(const QString& path, Changed changed);
    /// An earlier save there was left to itself and has not ended.
    [[nodiscard]] bool isLeft(const QString& path) const;
    /// Asks before this window overwrites a file that another window has open or another program has changed.
    [[nodiscard]] bool mayOpenTwice(const QString& path);
    bool answerOutside();
    void tellOfOutside(const FileStamp& now);
    /// The last known stamp of the file; empty if none is known.
    [[nodiscard]] FileStamp stampBefore() const;

    Session& m_session;
    Settings& m_settings;
    Jobs& m_jobs;
    QWidget& m_window;
    ProjectQuestions m_questions;
    OpenFile m_file;
    FileWatch m_watch;
    QString m_toldOfOutside;       ///< The last such sentence, so that it is not repeated.
    model::KnownFile m_asRestored; ///< As a journal tells of the file; used until the disk has answered.
    bool m_saving = false;         ///< Then it is this window that changes the file.
    QString m_nameWithoutPath;     ///< Empty: untitled.
    std::function<Picture()> m_thumbnail;
    std::shared_ptr<model::EncodedLayers> m_encoded;
    std::vector<std::pair<QString, std::weak_ptr<const void>>> m_left; ///< Saves by their paths, until they end.
};

} // namespace hairpaint::app
