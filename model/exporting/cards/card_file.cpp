// Binary glTF (Khronos, glTF 2.0 specification): vertices and indices of each group, then the images.
#include "model/exporting/cards/card_file.h"

#include "model/exporting/cards/card_mesh.h"
#include "model/files/atomic_file.h"
#include "model/files/glb.h"
#include "model/files/staged_files.h"
#include "sim/base/parallel.h"

#include <QFileInfo>
#include <QJsonArray>
#include <QJsonObject>

#include <array>
#include <limits>

namespace hairpaint::model {

namespace {

constexpr int kFloats = 5126;
constexpr int kInts = 5125;
constexpr int kVertices = 34962;
constexpr int kIndices = 34963;

QJsonArray numbers(const glm::vec3& v)
{
    return {static_cast<double>(v.x), static_cast<double>(v.y), static_cast<double>(v.z)};
}

/// Puts meshes and images into the binary chunk and describes them.
class CardGlb
{
public:
    void addMesh(const QString& name, const CardMesh& mesh)
    {
        glm::vec3 least(std::numeric_limits<float>::max());
        glm::vec3 greatest(std::numeric_limits<float>::lowest());
        for (const CardVertex& vertex : mesh.vertices) {
            least = glm::min(least, vertex.position);
            greatest = glm::max(greatest, vertex.position);
        }
        const int vertices = addView(mesh.vertices.data(), mesh.vertices.size() * sizeof(CardVertex), kVertices,
                                     static_cast<int>(sizeof(CardVertex)));
        const auto attribute = [&](std::size_t offset, const char* type) {
            return accessor(vertices, offset, kFloats, mesh.vertices.size(), type);
        };
        QJsonObject position = attribute(offsetof(CardVertex, position), "VEC3");
        position.insert(QStringLiteral("min"), numbers(least));
        position.insert(QStringLiteral("max"), numbers(greatest));
        const QJsonObject attributes{
            {QStringLiteral("POSITION"), addAccessor(position)},
            {QStringLiteral("NORMAL"), addAccessor(attribute(offsetof(CardVertex, normal), "VEC3"))},
            {QStringLiteral("TANGENT"), addAccessor(attribute(offsetof(CardVertex, tangent), "VEC4"))},
            {QStringLiteral("TEXCOORD_0"), addAccessor(attribute(offsetof(CardVertex, uv), "VEC2"))}};
        const int indices = addView(mesh.indices.data(), mesh.indices.size() * sizeof(std::uint32_t), kIndices, 0);
        const QJsonObject primitive{
            {QStringLiteral("attributes"), attributes},
            {QStringLiteral("indices"), addAccessor(accessor(indices, 0, kInts, mesh.indices.size(), "SCALAR"))},
            {QStringLiteral("material"), 0},
            {QStringLiteral("mode"), 4}};
        m_meshes.append(
            QJsonObject{{QStringLiteral("name"), name}, {QStringLiteral("primitives"), QJsonArray{primitive}}});
        m_nodes.append(QJsonObject{{QStringLiteral("name"), name},
                                   {QStringLiteral("mesh"), static_cast<int>(m_meshes.size()) - 1}});
    }

    void addImage(const QString& name, const QByteArray& png)
    {
        const int view = addView(png.constData(), static_cast<std::size_t>(png.size()), 0, 0);
        m_images.append(QJsonObject{{QStringLiteral("name"), name},
                                    {QStringLiteral("mimeType"), QStringLiteral("image/png")},
                                    {QStringLiteral("bufferView"), view}});
        m_textures.append(QJsonObject{{QStringLiteral("source"), static_cast<int>(m_images.size()) - 1},
                                      {QStringLiteral("sampler"), 0}});
    }

    /// The first two images are base colour and normals.
    [[nodiscard]] QByteArray finish(float roughness) const
    {
        QJsonObject root{
            {QStringLiteral("asset"), QJsonObject{{QStringLiteral("version"), QStringLiteral("2.0")},
                                                  {QStringLiteral("generator"), QStringLiteral("Hair Paint")}}},
            {QStringLiteral("scene"), 0}};
        QJsonObject scene{{QStringLiteral("name"), QStringLiteral("Hair")}};
        if (!m_nodes.isEmpty()) { // Arrays of glTF are never empty.
            QJsonArray nodes;
            for (int i = 0; i < static_cast<int>(m_nodes.size()); ++i)
                nodes.append(i);
            scene.insert(QStringLiteral("nodes"), nodes);
            root.insert(QStringLiteral("nodes"), m_nodes);
            root.insert(QStringLiteral("meshes"), m_meshes);
            root.insert(QStringLiteral("materials"), QJsonArray{material(roughness)});
            root.insert(QStringLiteral("images"), m_images);
            root.insert(QStringLiteral("textures"), m_textures);
            // Linear, with levels; no repetition.
            root.insert(QStringLiteral("samplers"), QJsonArray{QJsonObject{{QStringLiteral("magFilter"), 9729},
                                                                           {QStringLiteral("minFilter"), 9987},
                                                                           {QStringLiteral("wrapS"), 33071},
                                                                           {QStringLiteral("wrapT"), 33071}}});
            root.insert(QStringLiteral("accessors"), m_accessors);
            root.insert(QStringLiteral("bufferViews"), m_views);
            root.insert(QStringLiteral("buffers"),
                        QJsonArray{QJsonObject{{QStringLiteral("byteLength"), m_bin.size()}}});
        }
        root.insert(QStringLiteral("scenes"), QJsonArray{scene});
        return glbHead(root, static_cast<quint32>(m_bin.size())) + m_bin;
    }

private:
    [[nodiscard]] static QJsonObject material(float roughness)
    {
        const auto texture = [](int index) { return QJsonObject{{QStringLiteral("index"), index}}; };
        return {{QStringLiteral("name"), QStringLiteral("Hair cards")},
                {QStringLiteral("doubleSided"), true},
                {QStringLiteral("alphaMode"), QStringLiteral("MASK")},
                {QStringLiteral("alphaCutoff"), static_cast<double>(kCardCutoff)},
                {QStringLiteral("normalTexture"), texture(1)},
                {QStringLiteral("pbrMetallicRoughness"),
                 QJsonObject{{QStringLiteral("baseColorTexture"), texture(0)},
                             {QStringLiteral("metallicFactor"), 0.0},
                             {QStringLiteral("roughnessFactor"), static_cast<double>(roughness)}}}};
    }
    int addView(const void* data, std::size_t bytes, int target, int stride)
    {
        QJsonObject view{{QStringLiteral("buffer"), 0},
                         {QStringLiteral("byteOffset"), m_bin.size()},
                         {QStringLiteral("byteLength"), static_cast<qsizetype>(bytes)}};
        if (target > 0)
            view.insert(QStringLiteral("target"), target);
        if (stride > 0)
            view.insert(QStringLiteral("byteStride"), stride);
        m_bin.append(static_cast<const char*>(data), static_cast<qsizetype>(bytes));
        while (m_bin.size() % 4 != 0)
            m_bin.append('\0');
        m_views.append(view);
        return static_cast<int>(m_views.size()) - 1;
    }
    [[nodiscard]] static QJsonObject accessor(int view, std::size_t offset, int componentType, std::size_t count,
                                              const char* type)
    {
        return {{QStringLiteral("bufferView"), view},
                {QStringLiteral("byteOffset"), static_cast<int>(offset)},
                {QStringLiteral("componentType"), componentType},
                {QStringLiteral("count"), static_cast<qsizetype>(count)},
                {QStringLiteral("type"), QLatin1String(type)}};
    }
    int addAccessor(const QJsonObject& accessor)
    {
        m_accessors.append(accessor);
        return static_cast<int>(m_accessors.size()) - 1;
    }

    QJsonArray m_nodes, m_meshes, m_images, m_textures, m_accessors, m_views;
    QByteArray m_bin;
};

QByteArray glbOf(const CurveSet& curves, const HairCards& cards, std::span<const QByteArray> pngs)
{
    CardGlb glb;
    for (std::size_t group = 0; group < curves.groups().size(); ++group)
        if (const CardMesh mesh = cardMesh(cards, group); !mesh.indices.empty())
            glb.addMesh(curves.groups()[group].name, mesh);
    if (cards.patches.empty())
        return glb.finish(1.0F);
    for (std::size_t i = 0; i < pngs.size(); ++i)
        if (cardImageKinds()[i].embedded)
            glb.addImage(QString::fromLatin1(cardImageKinds()[i].name), pngs[i]);
    return glb.finish(curves.material(curves.curves().front()).roughness);
}

} // namespace

QStringList cardImagePlaces(const QString& path)
{
    const QFileInfo file(path);
    QStringList places;
    for (const CardImageKind& kind : cardImageKinds())
        if (!kind.embedded)
            places += file.dir().filePath(file.completeBaseName() + QLatin1Char('-') + QLatin1StringView(kind.name) +
                                          QLatin1String(".png"));
    return places;
}

Result<void> writeCardFile(const CurveSet& curves, const ExportSettings& settings, const QString& path,
                           const Progress& progress)
{
    constexpr double kMade = 0.7;     // Of all work.
    constexpr double kPictured = 0.9; // PNG files are there.
    QStringList places{path};
    if (!curves.curves().empty())
        places += cardImagePlaces(path);
    for (const QString& place : places)
        if (const Checked<void> writable = checkWritable(place); !writable)
            return cannotWrite(place, writable.error());
    const StagedFiles staged(QFileInfo(path).absolutePath());
    if (Result<void> ready = staged.check(path); !ready)
        return ready;
    std::optional<HairCards> cards =
        makeCards(curves, settings.cards, [&progress](double done) { return !progress || progress(kMade * done); });
    if (!cards)
        return cancelled(path);

    std::vector<QByteArray> pngs(cardImageKinds().size());
    if (!cards->patches.empty())
        sim::parallelFor(pngs.size(), 1, [&](std::size_t begin, std::size_t end) {
            for (std::size_t i = begin; i < end; ++i)
                pngs[i] = cardImagePng(cards->images, cardImageKinds()[i]);
        });
    if (progress && !progress(kPictured))
        return cancelled(path);
    std::vector<QByteArray> files{glbOf(curves, *cards, pngs)};
    for (std::size_t i = 0; i < pngs.size(); ++i)
        if (!cardImageKinds()[i].embedded)
            files.push_back(std::move(pngs[i]));
    for (qsizetype i = 0; i < places.size(); ++i)
        if (const Checked<void> written = writeFile(staged.pathFor(places[i]), files[static_cast<std::size_t>(i)]);
            !written)
            return cannotWrite(places[i], written.error());
    if (progress && !progress(1.0))
        return cancelled(path);
    return staged.publish(places);
}

} // namespace hairpaint::model
