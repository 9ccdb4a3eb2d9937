// Names matched, and a head made of what was chosen.
#include "model/files/part_selection.h"

#include "model/heads/layout_packing.h"
#include "model/heads/own_layout.h"
#include "model/heads/part_choice.h"

#include <algorithm>
#include <utility>

namespace hairpaint::model {

namespace {

/// The part that grows hair cut out, laid out anew, and put back before the others.
RiggedMesh laidOutAnew(RiggedMesh source)
{
    if (source.parts.empty())
        return withOwnLayout(source);
    const PartRange head = rangesOf(source).front();
    const auto split = [](auto& all, std::size_t at) {
        using List = std::remove_reference_t<decltype(all)>;
        if (all.empty())
            return List();
        const auto from = all.begin() + static_cast<std::ptrdiff_t>(at);
        List rest(from, all.end());
        all.erase(from, all.end());
        return rest;
    };
    const auto positions = split(source.positionsHd, head.vertices);
    const auto normals = split(source.normalsHd, head.vertices);
    const auto uvs = split(source.uvs, head.vertices);
    const auto weights = split(source.skeleton.weights, head.vertices);
    const auto triangles = split(source.triangles, head.triangles);
    RiggedMesh made = withOwnLayout(source);
    made.parts = std::move(source.parts);
    made.textures = std::move(source.textures);
    made.parts.front().vertices = static_cast<std::uint32_t>(made.positionsHd.size());
    made.parts.front().triangles = static_cast<std::uint32_t>(made.triangles.size());
    made.parts.front().texture = -1; // It lay on the other layout.
    const auto moved = static_cast<std::uint32_t>(made.positionsHd.size());
    const auto append = [](auto& to, const auto& from) { to.insert(to.end(), from.begin(), from.end()); };
    append(made.positionsHd, positions);
    append(made.normalsHd, normals);
    append(made.uvs, uvs);
    append(made.skeleton.weights, weights);
    for (const glm::uvec3& triangle : triangles)
        made.triangles.push_back(triangle - static_cast<std::uint32_t>(head.vertices) + moved);
    return made;
}

sim::HeadMesh growingMesh(const RiggedMesh& mesh)
{
    if (mesh.parts.empty())
        return mesh;
    const PartRange range = rangesOf(mesh).front();
    const auto first = [](const auto& all, std::size_t count) {
        return std::decay_t<decltype(all)>(all.begin(), all.begin() + static_cast<std::ptrdiff_t>(count));
    };
    return {.positionsHd = first(mesh.positionsHd, range.vertices),
            .normalsHd = first(mesh.normalsHd, range.vertices),
            .uvs = first(mesh.uvs, range.vertices),
            .triangles = first(mesh.triangles, range.triangles)};
}

QString quoted(const QStringList& names)
{
    constexpr qsizetype kMost = 4;
    QString text = names.first(std::min(kMost, names.size())).join(QStringLiteral(", "));
    return names.size() > kMost ? text + QStringLiteral(", ...") : text;
}

/// By part; a clause where a name is none of a part.
Checked<std::vector<bool>> named(const RiggedMesh& source, const std::vector<QString>& names)
{
    std::vector<bool> isNamed(source.parts.size());
    for (const QString& name : names) {
        bool any = false;
        for (std::size_t i = 0; i < source.parts.size(); ++i) {
            const MeshPart& part = source.parts[i];
            for (const QString& own :
                 {QString::fromStdString(part.name), QString::fromStdString(part.material), titleOf(source, i)})
                if (own.compare(name, Qt::CaseInsensitive) == 0) {
                    isNamed[i] = true;
                    any = true;
                }
        }
        if (any)
            continue;
        QStringList known;
        for (std::size_t i = 0; i < source.parts.size(); ++i)
            known.append(titleOf(source, i));
        known.removeDuplicates();
        return refuse(say(QT_TRANSLATE_NOOP("Files", "it has no part '%1'; it has %2")).arg(name, quoted(known)),
                      Clause::Cure::OtherFile);
    }
    return isNamed;
}

QString percentOf(double fraction)
{
    return QString::number(std::max(qRound(100.0 * fraction), 1));
}

} // namespace

QString titleOf(const RiggedMesh& source, std::size_t part)
{
    const MeshPart& own = source.parts[part];
    const bool isShared = std::ranges::any_of(source.parts, [&own](const MeshPart& other) {
        return &other != &own && other.name == own.name && other.material != own.material;
    });
    const QString name = QString::fromStdString(own.name.empty() ? own.material : own.name);
    return isShared && !own.material.empty() && !own.name.empty()
               ? name + QStringLiteral(" / ") + QString::fromStdString(own.material)
               : name;
}

Checked<void> choosePartsBy(RiggedMesh& source, const HeadChoice& choice, const HeadGuess& guess)
{
    const Checked<std::vector<bool>> comingIn = named(source, choice.comingIn);
    if (!comingIn)
        return tl::unexpected(comingIn.error());
    const Checked<std::vector<bool>> growing = named(source, choice.growing);
    if (!growing)
        return tl::unexpected(growing.error());
    RiggedMesh considered = source;
    if (choice.ownLayout && std::ranges::none_of(source.parts, &MeshPart::hasLayout)) // It will have one.
        for (MeshPart& part : considered.parts)
            part.hasLayout = true;
    if (!choice.comingIn.empty()) // What is left out is no skin that is looked for.
        for (std::size_t i = 0; i < source.parts.size(); ++i)
            considered.parts[i].hasLayout = considered.parts[i].hasLayout && (*comingIn)[i];
    const std::vector<PartUse> likely =
        likelyUses(considered, guess.upAxis == UpAxis::Y ? glm::vec3(0, 1, 0) : glm::vec3(0, 0, 1), guess.unitScale);
    for (std::size_t i = 0; i < source.parts.size(); ++i) {
        MeshPart& part = source.parts[i];
        part.use = likely[i];
        if (!choice.growing.empty())
            part.use = (*growing)[i] ? PartUse::Grows : PartUse::Seen;
        if (!choice.comingIn.empty() && !(*comingIn)[i] && !(!choice.growing.empty() && (*growing)[i]))
            part.use = PartUse::LeftOut;
        if (part.use == PartUse::Grows && !part.hasLayout && !choice.ownLayout && !choice.growing.empty())
            return refuse(say(QT_TRANSLATE_NOOP("Files", "its part '%1' has no uv coordinates to paint on; choose "
                                                         "another, or a layout of our own"))
                              .arg(titleOf(source, i)),
                          Clause::Cure::OtherFile);
    }
    return {};
}

Checked<ChosenHead> headOfParts(const RiggedMesh& source, bool ownLayout)
{
    const auto nothingToPaintOn = [] {
        return refuse(say(QT_TRANSLATE_NOOP("Files", "all its uv coordinates are the same, so there is nothing to "
                                                     "paint on; unwrap it in a 3D program first")),
                      Clause::Cure::OtherFile);
    };
    if (!source.parts.empty() &&
        std::ranges::none_of(source.parts, [](const MeshPart& part) { return part.use == PartUse::Grows; })) {
        if (!ownLayout && std::ranges::none_of(source.parts, &MeshPart::hasLayout))
            return nothingToPaintOn();
        return refuse(say(QT_TRANSLATE_NOOP("Files", "hair is to grow on none of its parts; choose one")),
                      Clause::Cure::OtherFile);
    }
    ChosenHead chosen{.mesh = arranged(source), .remarks = {}};
    if (ownLayout)
        chosen.mesh = laidOutAnew(std::move(chosen.mesh));
    const sim::HeadMesh head = growingMesh(chosen.mesh);
    if (!hasLayout(head))
        return nothingToPaintOn();
    QStringList bare;
    QStringList tiles;
    for (std::size_t i = 0; i < source.parts.size(); ++i) {
        const MeshPart& part = source.parts[i];
        if (part.use == PartUse::Seen && !part.hasLayout)
            bare.append(titleOf(source, i));
        if (part.use == PartUse::Grows && part.tile != glm::ivec2(0))
            tiles.append(QString::number(udimOf(part.tile)));
    }
    tiles.removeDuplicates();
    if (!bare.isEmpty())
        chosen.remarks.append(
            say(QT_TRANSLATE_NOOP("Files", "without uv coordinates, so no hair grows there: %1")).arg(quoted(bare)));
    if (!tiles.isEmpty() && !ownLayout)
        chosen.remarks.append(
            say(QT_TRANSLATE_NOOP("Files", "its uv tiles lie side by side on the maps: 1001, %1")).arg(quoted(tiles)));
    if (const std::optional<int> shared = chosen.mesh.tiles.shared(); shared && !ownLayout)
        chosen.remarks.append(say(QT_TRANSLATE_NOOP("Files", "several of its parts have a layout of their own "
                                                             "in uv tile %1, so these lie side by side on the "
                                                             "maps; images by tile can't hold them"))
                                  .arg(*shared));
    if (const LayoutOverlap overlap = overlapOf(head); !ownLayout && overlap.fraction > kNotableOverlap)
        chosen.remarks.append(
            (overlap.isMirrored
                 ? say(QT_TRANSLATE_NOOP("Files",
                                         "its left and right half share %1 % of the texels: what is painted on "
                                         "one grows on both; a layout of our own parts them"))
                 : say(QT_TRANSLATE_NOOP("Files", "parts of its skin share %1 % of the texels: what is painted on one "
                                                  "grows on all; a layout of our own parts them")))
                .arg(percentOf(overlap.fraction)));
    return chosen;
}

} // namespace hairpaint::model
