// The dialog, its small pictures as jobs, and the file.
#include "app/exchange/picture_exchange.h"

#include "app/headless/picture.h"
#include "view/head_area/scene_light.h"
#include "view/head_area/stage.h"

#include <QFileInfo>
#include <QImageWriter>

#include <cmath>

namespace hairpaint::app {

namespace {

float shapeOf(QSize px)
{
    return static_cast<float>(px.width()) / static_cast<float>(std::max(px.height(), 1));
}

/// Whether they show the same but for how the hair hangs.
bool looksAlike(const ShownScene& a, const ShownScene& b)
{
    rendering::Scene same = a.scene;
    same.hair = b.scene.hair;
    return a.px == b.px && same == b.scene;
}

} // namespace

rendering::Scene chosenScene(ShownScene shown, const view::PictureChoice& choice, QSize px, const model::Head& head)
{
    rendering::Scene& scene = shown.scene;
    const auto fitted = [&](rendering::Fit fit) {
        return view::pictureCamera(scene.camera, fit, head, scene.hair.get(), shapeOf(px));
    };
    switch (choice.framing) {
    case view::PictureFraming::Shown:
        // The field of view is vertical.
        if (shapeOf(px) < shapeOf(shown.px))
            scene.camera.fieldOfViewRad =
                2.0F * std::atan(std::tan(0.5F * scene.camera.fieldOfViewRad) * shapeOf(shown.px) / shapeOf(px));
        break;
    case view::PictureFraming::Hair:
        scene.camera = fitted(rendering::Fit::Hair);
        break;
    case view::PictureFraming::Head:
        scene.camera = fitted(rendering::Fit::Head);
        break;
    case view::PictureFraming::Bust:
        scene.camera = fitted(rendering::Fit::Bust);
        break;
    }
    scene.transparent = choice.background == view::PictureBackground::Transparent;
    if (choice.background == view::PictureBackground::Colour)
        scene.background = view::linearColour(choice.colour.rgb());
    return std::move(scene);
}

PictureExchange::PictureExchange(Session& session, FileWork& files, HairExchange& hair)
    : QObject(&files), m_session(session), m_files(files), m_hair(hair)
{}

void PictureExchange::setSource(std::function<ShownScene()> source)
{
    m_source = std::move(source);
}

void PictureExchange::savePicture()
{
    if (m_dialog == nullptr) {
        m_dialog = new view::PictureDialog(m_files.settings().pictureChoice(), m_source().px, &m_files.window());
        m_dialog->setAttribute(Qt::WA_DeleteOnClose);
        m_files.announce(*m_dialog, view::HelpDialog::Topic::Picture);
        connect(m_dialog, &view::PictureDialog::previewWanted, this, &PictureExchange::drawPreview);
        connect(m_dialog, &view::PictureDialog::saveWanted, this, &PictureExchange::saveChosen);
        // Also what was chosen and then not saved.
        connect(m_dialog, &QDialog::finished, this, [this] {
            if (m_dialog == nullptr)
                return;
            m_files.settings().setPictureChoice(m_dialog->choice());
            m_dialog.clear(); // It goes by itself.
        });
    }
    m_dialog->show();
    m_dialog->raise();
    m_dialog->activateWindow();
}

void PictureExchange::followView()
{
    if (m_dialog == nullptr)
        return;
    const ShownScene shown = m_source();
    if (looksAlike(shown, m_previewed))
        return;
    m_dialog->setViewPx(shown.px);
    m_dialog->refresh();
}

void PictureExchange::drawPreview()
{
    if (m_dialog == nullptr)
        return; // It was closed before its first small picture.
    m_previewed = m_source();
    const QSize px = m_dialog->previewPx();
    const std::shared_ptr<const model::Head> head = m_session.document().project().head;
    m_files.jobs().start<QImage>(
        {},
        [shown = m_previewed, choice = m_dialog->choice(), px, head](const model::Progress& progress) {
            return PictureMaker().sketch(chosenScene(shown, choice, px, *head), px, progress);
        },
        m_dialog,
        [dialog = m_dialog.data()](const model::Result<QImage>& picture) {
            dialog->showPreview(picture.value_or(QImage()));
        });
}

void PictureExchange::saveChosen()
{
    const view::PictureChoice choice = m_dialog->choice();
    const QSize px = m_dialog->picturePx();
    QStringList filters{tr("PNG images (*.png)"), tr("OpenEXR images in linear light (*.exr)")};
    if (QImageWriter::supportedImageFormats().contains("jpg"))
        filters += tr("JPEG images (*.jpg)");
    const QString path = m_files.askSavePath({.title = tr("Save picture"),
                                              .suggestedPath = tr("hairstyle"),
                                              .filter = filters.join(QLatin1String(";;")),
                                              .suffix = QStringLiteral("png"),
                                              .otherSuffixes = {QStringLiteral("jpeg")}});
    if (path.isEmpty())
        return;
    const QString name = QFileInfo(path).fileName();
    const Doing saving{.text = tr("Saving the picture %1").arg(name),
                       .whenCancelled = tr("The picture '%1' was not saved: cancelled").arg(name)};
    if (m_hair.currentHair(saving.whenCancelled) == nullptr || m_dialog == nullptr)
        return;
    const rendering::Scene scene = chosenScene(m_source(), choice, px, *m_session.document().committed().head);
    const PictureLook look{.samples = choice.samples};
    const bool isSaved = m_files.write(saving, path, [scene, px, look, path](const model::Progress& progress) {
        return PictureMaker().save(scene, px, look, path, progress);
    });
    if (isSaved && m_dialog != nullptr)
        m_dialog->accept();
}

} // namespace hairpaint::app
