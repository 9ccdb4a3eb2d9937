// Pictures of the 3D area: asked for with a small one beside the choices, and saved.
#pragma once

#include "app/exchange/hair_exchange.h"
#include "view/dialogs/picture_dialog.h"
#include "view/rendering/scene.h"

#include <QPointer>

#include <functional>

namespace hairpaint::app {

/// What the 3D area shows at present.
struct ShownScene
{
    rendering::Scene scene; ///< Without rings.
    QSize px;
};

/// The scene as a picture of `px` shows it. A picture narrower than the area still shows its whole width.
[[nodiscard]] rendering::Scene chosenScene(ShownScene shown, const view::PictureChoice& choice, QSize px,
                                           const model::Head& head);

/// GUI thread. The dialog stays open beside the window until a picture is saved.
class PictureExchange : public QObject
{
    Q_OBJECT
public:
    PictureExchange(Session& session, FileWork& files, HairExchange& hair);

    void setSource(std::function<ShownScene()> source);
    void savePicture(); ///< Asks how, and for the file.
    /// The 3D area has drawn: where it shows something else than hair that moves, so does the open dialog.
    void followView();

private:
    void drawPreview();
    void saveChosen();

    Session& m_session;
    FileWork& m_files;
    HairExchange& m_hair;
    std::function<ShownScene()> m_source;
    QPointer<view::PictureDialog> m_dialog;
    ShownScene m_previewed; ///< The scene of the last preview.
};

} // namespace hairpaint::app
