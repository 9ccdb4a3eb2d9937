// Hair goes out to other programs and comes in from them: as curves, as cards.
#pragma once

#include "app/exchange/file_work.h"
#include "app/session/session.h"
#include "view/dialogs/export_hair_dialog.h"
#include "view/rendering/card_set.h"

#include <QPointer>

#include <memory>

namespace hairpaint::app {

/// GUI thread.
class HairExchange : public QObject
{
    Q_OBJECT
public:
    HairExchange(Session& session, FileWork& files);

    /// Where the open project lies, which names avatars; empty where it was never saved.
    void setProjectPath(const QString& path) { m_projectPath = path; }

    /// Asks how, in a dialog that stays open until a file is written: its preview can be looked at from all sides and
    /// asked for again meanwhile. Then asks for the file.
    void exportHair();
    /// Makes cards of the hair as they were last chosen for export, and has them shown; nothing is written.
    void previewCards();
    /// Curves of other programs as new hair groups, one undo step.
    void importHair(); ///< Asks for the file.
    void importHairFrom(const QString& path);
    /// Installs the add-on into every Blender found; asks for a folder if there is none.
    void installBlenderAddon();
    /// Waits for the hair of the document as it is; null if that was cancelled or memory ran out.
    /// `whenCancelled`: as in Doing.
    [[nodiscard]] std::shared_ptr<const sim::StrandFrame> currentHair(const QString& whenCancelled);

Q_SIGNALS:
    void cardsMade(const std::shared_ptr<const hairpaint::rendering::CardSet>& cards);

private:
    [[nodiscard]] static QString noCardsText();
    [[nodiscard]] static QString notExportedText();
    void rememberChoice(); ///< Keeps the choice of the open dialog in m_export.
    void exportChosenHair();
    void previewChosen();
    void followHair(); ///< Updates the groups and hairs that the open dialog offers.
    void followHead();

    Session& m_session;
    FileWork& m_files;
    QString m_projectPath;
    view::HairExportChoice m_export; ///< The last choice made in the dialog.
    QPointer<view::ExportHairDialog> m_dialog;
};

} // namespace hairpaint::app
