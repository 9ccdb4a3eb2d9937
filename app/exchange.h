// What comes in from other programs and goes out to them: images, heads, hair, pictures, styles.
#pragma once

#include "app/background/jobs.h"
#include "app/save_dialog.h"
#include "app/session.h"
#include "app/settings.h"
#include "model/files/head_file.h"
#include "view/dialogs/export_hair_dialog.h"
#include "view/dialogs/help_dialog.h"
#include "view/rendering/scene.h"

#include <QObject>

#include <functional>

namespace hairpaint::app {

/// Shows file dialogs, progress and message boxes over `window`.
class Exchange : public QObject
{
    Q_OBJECT
public:
    Exchange(Session& session, Settings& settings, Jobs& jobs, QWidget& window);

    /// What the 3D area shows at present, for pictures of it.
    void setSceneSource(std::function<rendering::Scene()> source);

    /// Into the active map; `grey`: brightness is the value, else the image's colours are read by the map's scale.
    void importImage(bool grey); ///< Asks for the file.
    void importImageFrom(const QString& path, bool grey);
    void exportMap(); ///< The active map in its scale.
    void importHead();
    void importHeadFrom(const QString& path);
    /// Shows the head's landmarks; where the user moves them, hair goes along.
    void moveLandmarks();
    void useBuiltInHead(const model::NamedHead& named);
    void exportHair();
    /// Makes cards of the hair as they were last chosen for export, and has them shown; nothing is written.
    void previewCards();
    /// Curves of other programs as new hair groups, one undo step.
    void importHair(); ///< Asks for the file.
    void importHairFrom(const QString& path);
    /// Into every Blender that is there; asks for a place where there is none.
    void installBlenderAddon();
    void savePicture();
    void saveStyle();
    void renameStyle(const QString& path); ///< Asks for the name.
    void deleteStyle(const QString& path);
    void applyStyleFrom(const QString& path);
    /// The hair of the document as it is, waited for; null where that was cancelled or there is no memory for it.
    [[nodiscard]] std::shared_ptr<const sim::StrandFrame> currentHair();

Q_SIGNALS:
    /// About to be shown; the help has a page on it.
    void dialogMade(QDialog& dialog, hairpaint::view::HelpDialog::Topic topic);
    void cardsMade(const std::shared_ptr<const hairpaint::rendering::CardSet>& cards);
    void stylesChanged();
    void done(const QString& message); ///< For the status bar.

private:
    [[nodiscard]] static QString noGroupText();
    void complain(const QString& message);
    /// The head with its landmarks where the user wants them; null where he wants none of it.
    [[nodiscard]] std::shared_ptr<const model::Head> withLandmarksAsked(const std::shared_ptr<const model::Head>& head);
    /// One undo step. The hairstyle is carried to the new head, or its maps stay as they lie.
    void replaceHead(const std::shared_ptr<const model::Head>& head, std::vector<sim::Ellipsoid> ellipsoids,
                     bool carriesHair);
    void previewChosen(const std::shared_ptr<const sim::StrandFrame>& frame);
    /// Has a file written with progress, and tells of it.
    void write(const QString& path, const Work<void>& work);
    /// Asks in the last folder; see app::askSavePath. `question.suggestedPath`: a name without folder and ending.
    [[nodiscard]] QString askSavePath(SaveQuestion question, QString* chosenFilter = nullptr);
    [[nodiscard]] QString askOpenPath(const QString& title, const QString& filter);

    Session& m_session;
    Settings& m_settings;
    Jobs& m_jobs;
    QWidget& m_window;
    std::function<rendering::Scene()> m_scene;
    view::HairExportChoice m_export; ///< That was last made.
};

} // namespace hairpaint::app
