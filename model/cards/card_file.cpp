// Cards are made, and all files staged beside their targets.
#include "model/cards/card_file.h"

#include "model/cards/card_glb.h"
#include "model/disk/atomic_file.h"
#include "model/disk/staged_files.h"
#include "sim/base/parallel.h"

#include <QDir>
#include <QFileInfo>

#include <optional>
#include <vector>

namespace hairpaint::model {

QStringList cardImagePaths(const QString& path)
{
    const QFileInfo file(path);
    QStringList paths;
    for (const CardImageKind& kind : cardImageKinds())
        if (!kind.embedded)
            paths += file.dir().filePath(file.completeBaseName() + QLatin1Char('-') + QLatin1StringView(kind.name) +
                                         QLatin1String(".png"));
    return paths;
}

Result<void> writeCardFile(const CurveSet& curves, const ExportSettings& settings, const QString& path,
                           const Progress& progress)
{
    constexpr double kMade = 0.7;     // The fraction of all work that is done once the cards are made.
    constexpr double kPictured = 0.9; // The fraction of all work that is done once the PNG files are written.
    QStringList paths{path};
    if (!curves.curves().empty())
        paths += cardImagePaths(path);
    for (const QString& target : paths)
        if (const Checked<void> writable = checkWritable(target); !writable)
            return cannotWrite(target, writable.error());
    StagedFiles staged(QFileInfo(path).path());
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
    std::vector<QByteArray> files{cardGlb(curves, *cards, settings, pngs)};
    for (std::size_t i = 0; i < pngs.size(); ++i)
        if (!cardImageKinds()[i].embedded)
            files.push_back(std::move(pngs[i]));
    for (qsizetype i = 0; i < paths.size(); ++i)
        if (const Checked<void> written = writeFile(staged.pathFor(paths[i]), files[static_cast<std::size_t>(i)]);
            !written)
            return cannotWrite(paths[i], written.error());
    if (progress && !progress(1.0))
        return cancelled(path);
    return staged.publish(paths);
}

} // namespace hairpaint::model
