// Decoded by the helper, scaled and placed here.
#include "app/exchange/worn_exchange.h"

#include "model/files/importer_client.h"
#include "model/files/own_mesh_file.h"

#include <QFileInfo>

#include <optional>
#include <utility>

namespace hairpaint::app {

namespace {

model::Result<model::BroughtMesh> readBroughtMesh(const QString& path, const model::Progress& progress)
{
    return model::withinMemory(path, model::cannotOpen, [&]() -> model::Result<model::BroughtMesh> {
        const model::Result<model::RiggedMesh> decoded = model::ImporterClient().readBody(path, progress);
        if (!decoded)
            return tl::unexpected(decoded.error());
        model::Checked<model::BroughtMesh> mesh = model::broughtMesh(*decoded, QFileInfo(path).completeBaseName());
        return mesh ? model::Result<model::BroughtMesh>(std::move(*mesh)) : model::cannotOpen(path, mesh.error());
    });
}

} // namespace

WornExchange::WornExchange(Session& session, FileWork& files) : QObject(&files), m_session(session), m_files(files) {}

void WornExchange::putOn(view::HeadView& head)
{
    const QString path =
        m_files.askOpenPath(tr("Put on a mesh"), tr("Meshes (*.glb *.gltf *.vrm *.obj *.fbx *.ply *.dae *.3ds *.x3d)"));
    if (!path.isEmpty())
        putOn(path, head);
}

void WornExchange::putOn(const QString& path, view::HeadView& head)
{
    m_session.editor().tools().commitStroke();
    const std::optional<model::BroughtMesh> mesh = m_files.read<model::BroughtMesh>(
        path, [path](const model::Progress& progress) { return readBroughtMesh(path, progress); });
    const std::optional<sim::SurfacePoint> point = head.pointForWorn();
    if (mesh && point)
        head.addWornThing(wornFrom(*mesh, *point, m_session.editor().target().group()));
}

} // namespace hairpaint::app
