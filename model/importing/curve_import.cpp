// One step after the other.
#include "model/importing/curve_import.h"

#include "model/importing/braid_estimate.h"
#include "model/importing/curve_reader.h"
#include "model/importing/strand_maps.h"
#include "model/values/sentences.h"

#include <QFileInfo>

#include <algorithm>

namespace hairpaint::model {

namespace {

constexpr int kSmallestMap = 256;
constexpr int kLargestMap = 1024;
constexpr double kCurvesRead = 0.3;      ///< Fraction of all work that is done once the curves are read.
constexpr double kTexelsFound = 0.15;    ///< Fraction of the work after that.
constexpr double kStrandsMeasured = 0.5; ///< Fraction of a group's work that is done once its strands are measured.

/// Tells of a part of the work.
Progress partOfImport(const Progress& progress, double from, double until)
{
    if (!progress)
        return {};
    return [&progress, from, until](double done) { return progress(from + (until - from) * done); };
}

/// Some texels a strand: what stands wide apart tells no more.
int mapSizeFor(const ForeignCurves& curves)
{
    constexpr std::size_t kTexelsEach = 10;
    std::size_t strands = 0;
    for (const ForeignStrands& group : curves.groups)
        strands += group.count();
    std::size_t size = kSmallestMap;
    while (size < kLargestMap && size * size < kTexelsEach * strands)
        size *= 2;
    return static_cast<int>(size);
}

/// Some programs write a prim for each lock: so many are no groups.
void mergeMany(ForeignCurves& curves)
{
    constexpr std::size_t kMostImportedGroups = 16;
    if (curves.groups.size() <= kMostImportedGroups)
        return;
    ForeignStrands all;
    all.hasColours = true;
    for (const ForeignStrands& group : curves.groups) {
        const auto before = static_cast<std::uint32_t>(all.points.size());
        all.hasColours = all.hasColours && group.hasColours;
        all.points.insert(all.points.end(), group.points.begin(), group.points.end());
        all.looks.insert(all.looks.end(), group.looks.begin(), group.looks.end());
        for (const std::uint32_t end : group.ends)
            all.ends.push_back(before + end);
    }
    curves.groups.clear();
    curves.groups.push_back(std::move(all));
}

tl::unexpected<Error> fitsNowhere(const QString& path)
{
    return cannotOpen(path, {.text = say(QT_TRANSLATE_NOOP(
                                 "Files", "its hair does not fit on this head; export it in metres with y up, as it "
                                          "stands on a head of this size")),
                             .cure = Clause::Cure::OtherFile});
}

tl::unexpected<Error> fitsNotAsTold(const QString& path)
{
    return cannotOpen(path, {.text = say(QT_TRANSLATE_NOOP(
                                 "Files", "its hair does not lie on this head in the unit and axis that it is told to "
                                          "have; tell others, or none")),
                             .cure = Clause::Cure::OtherFile});
}

} // namespace

QString unreadFiles(const QStringList& names)
{
    constexpr qsizetype kMost = 4;
    QString text = names.first(std::min(kMost, names.size())).join(QStringLiteral(", "));
    if (names.size() > kMost)
        text += QStringLiteral(", ...");
    return say(QT_TRANSLATE_NOOP("Files",
                                 "not read, so hair that is in there is missing: %1; save it as USD text in the "
                                 "same folder"))
        .arg(onOneLine(text)); // As they stand in the file: a path in a stage is none of the system's.
}

Result<std::vector<HairGroup>> groupsFromCurves(const QString& path, const CurveSpaceChoice& choice,
                                                const std::shared_ptr<const Head>& head, const Progress& progress,
                                                CurveRemarks* remarks)
{
    using Groups = std::vector<HairGroup>;
    return withinMemory(path, cannotOpen, [&]() -> Result<Groups> {
        Result<ForeignCurves> curves = readCurves(path, partOfImport(progress, 0.0, kCurvesRead));
        if (!curves)
            return tl::unexpected(curves.error());
        return groupsFromCurves(std::move(*curves), path, choice, head, partOfImport(progress, kCurvesRead, 1.0),
                                remarks);
    });
}

Result<std::vector<HairGroup>> groupsFromCurves(ForeignCurves curves, const QString& path,
                                                const CurveSpaceChoice& choice, const std::shared_ptr<const Head>& head,
                                                const Progress& progress, CurveRemarks* remarks)
{
    using Groups = std::vector<HairGroup>;
    return withinMemory(path, cannotOpen, [&]() -> Result<Groups> {
        if (remarks != nullptr)
            *remarks = {.leftOut = curves.leftOut, .unread = curves.unread};
        mergeMany(curves);
        turnTipFirst(curves, choice, *head->skin);
        const std::optional<CurveTransform> transform = fitCurves(curves, choice, *head->skin);
        if (!transform)
            return choice.metresPerUnit ? fitsNotAsTold(path) : fitsNowhere(path);
        const std::optional<SkinTexels> texels =
            SkinTexels::of(*head->skin, mapSizeFor(curves), partOfImport(progress, 0.0, kTexelsFound));
        if (!texels)
            return cancelled(path);
        Groups groups;
        for (std::size_t i = 0; i < curves.groups.size(); ++i) {
            const ForeignStrands& strands = curves.groups[i];
            const double part = (1.0 - kTexelsFound) / static_cast<double>(curves.groups.size());
            const double from = kTexelsFound + part * static_cast<double>(i);
            std::optional<HeadStrands> onHead =
                strandsOnHead(strands, *transform, *head->skin, head->distances.get(),
                              partOfImport(progress, from, from + part * kStrandsMeasured));
            if (!onHead)
                return cancelled(path);
            if (onHead->strands.empty())
                continue;
            const double measured = from + part * kStrandsMeasured;
            if (!estimateBraids(strands, *transform, *onHead, partOfImport(progress, measured, measured)))
                return cancelled(path);
            const QString name = strands.name.isEmpty() ? QFileInfo(path).completeBaseName() : strands.name;
            std::optional<HairGroup> group =
                groupFromStrands(*onHead, strands.hasColours, *texels, name, head,
                                 partOfImport(progress, from + part * kStrandsMeasured, from + part));
            if (!group)
                return cancelled(path);
            groups.push_back(std::move(*group));
        }
        if (groups.empty())
            return fitsNowhere(path);
        return groups;
    });
}

} // namespace hairpaint::model
