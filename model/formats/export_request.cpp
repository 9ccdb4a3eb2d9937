// The project's part of a request, and the request carried out.
#include "model/formats/export_request.h"

#include "model/formats/export_format.h"
#include "model/project/skin_tone.h"
#include "model/values/sentences.h"

#include <QFileInfo>

namespace hairpaint::model {

namespace {

/// Fraction of all work that is done once the curves are found.
constexpr double kMeasured = 0.2;

} // namespace

Result<void> addProject(ExportRequest& request, const Project& project, const QString& projectPath, const QString& path)
{
    request.worn = project.worn;
    request.skinColour = skinLook(project.skin).skin;
    if (project.head) {
        request.parts = project.head->parts;
        request.headTexture = project.head->texture;
    }
    if (!request.format->isAvatar)
        return {};
    const QString name = QFileInfo(projectPath.isEmpty() ? path : projectPath).completeBaseName();
    const Checked<std::shared_ptr<const Avatar>> avatar = avatarOf(*project.head, name, request.author);
    if (!avatar)
        return cannotWrite(path, avatar.error());
    request.avatar = *avatar;
    return {};
}

Result<void> exportHair(const std::shared_ptr<const sim::StrandFrame>& frame, const ExportRequest& wanted,
                        const QString& path, const Progress& progress)
{
    return withinMemory(path, cannotWrite, [&]() -> Result<void> {
        const auto part = [&progress](double from, double to) -> Progress {
            return [&progress, from, to](double done) { return !progress || progress(from + (to - from) * done); };
        };
        const ExportRequest request = wanted.format->requestFor(wanted);
        const std::optional<CurveSet> curves = CurveSet::of(frame, request.curves, part(0.0, kMeasured));
        if (!curves)
            return cancelled(path);
        ExportSettings settings = request.format->settingsFor(*request.target);
        settings.cards = request.cards;
        Q_ASSERT(!request.format->isAvatar || request.avatar != nullptr);
        if (request.format->isAvatar)
            settings.avatar = request.avatar;
        settings.worn = request.worn;
        settings.skinColour = request.skinColour;
        settings.parts = request.parts;
        settings.headTexture = request.headTexture;
        return request.format->write(*curves, settings, path, part(kMeasured, 1.0));
    });
}

} // namespace hairpaint::model
