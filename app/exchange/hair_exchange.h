// Hair goes out to other programs and comes in from them: as curves, as cards, as pictures.
#pragma once

#include "app/exchange/file_work.h"
#include "app/session.h"
#include "view/dialogs/export_hair_dialog.h"
#include "view/rendering/scene.h"

#include <functional>

namespace hairpaint::app {

/// GUI thread.
class HairExchange : public QObject
{
    Q_OBJECT
public:
    HairExchange(Session& session, FileWork& files);

    /// What the 3D area shows at present, for pictures of it.
    void setSceneSource(std::function<rendering::Scene()> source);

    void exportHair(); ///< Asks how and for the file.
    /// Makes cards of the hair as they were last chosen for export, and has them shown; nothing is written.
    void previewCards();
    /// Curves of other programs as new hair groups, one undo step.
    void importHair(); ///< Asks for the file.
    void importHairFrom(const QString& path);
    /// Into every Blender that is there; asks for a place where there is none.
    void installBlenderAddon();
    void savePicture();
    /// The hair of the document as it is, waited for; null where that was cancelled or there is no memory for it.
    /// `whenCancelled`: as in Doing.
    [[nodiscard]] std::shared_ptr<const sim::StrandFrame> currentHair(const QString& whenCancelled);

Q_SIGNALS:
    void cardsMade(const std::shared_ptr<const hairpaint::rendering::CardSet>& cards);

private:
    [[nodiscard]] static QString noCardsText();
    void previewChosen(const std::shared_ptr<const sim::StrandFrame>& frame);

    Session& m_session;
    FileWork& m_files;
    std::function<rendering::Scene()> m_scene;
    view::HairExportChoice m_export; ///< That was last made.
};

} // namespace hairpaint::app
