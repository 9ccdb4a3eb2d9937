// Heads: built-in ones, those of other programs, and their landmarks.
#pragma once

#include "app/exchange/file_work.h"
#include "app/session/session.h"
#include "model/files/head_file.h"

namespace hairpaint::app {

/// GUI thread.
class HeadExchange : public QObject
{
    Q_OBJECT
public:
    HeadExchange(Session& session, FileWork& files);

    void importHead(); ///< Asks for the file.
    void importHeadFrom(const QString& path);
    /// Shows the head's landmarks; where the user moves them, hair goes along.
    void moveLandmarks();
    void useBuiltInHead(const model::NamedHead& named);

private:
    [[nodiscard]] static Doing preparing(const QString& name);
    /// The head with the landmarks that the user set; null if the dialog was cancelled.
    [[nodiscard]] std::shared_ptr<const model::Head> withLandmarksAsked(const std::shared_ptr<const model::Head>& head);
    /// One undo step. The hairstyle is carried to the new head, or its maps stay as they lie.
    void replaceHead(const std::shared_ptr<const model::Head>& head, std::vector<sim::Ellipsoid> ellipsoids,
                     bool carriesHair);

    Session& m_session;
    FileWork& m_files;
};

} // namespace hairpaint::app
