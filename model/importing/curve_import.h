// Hair of other programs as hair groups.
#pragma once

#include "model/importing/curve_fit.h"
#include "model/project/project.h"
#include "model/values/error.h"
#include "model/values/progress.h"

#include <QStringList>

#include <cstddef>
#include <memory>
#include <vector>

namespace hairpaint::model {

/// What there is to be told of hair that came in.
struct CurveRemarks
{
    std::size_t leftOut = 0; ///< Strands of one point, or with a point that is no number.
    QStringList unread;      ///< Files that it names, and that were not read.
};
/// A sentence without a full stop.
[[nodiscard]] QString unreadFiles(const QStringList& names);

/// Reads a file of curves (curve_reader.h), fits them to the head and tells the maps from them: a group for each that
/// the file names; one named after the file where it names none, or more than sixteen. Ids are nobody's yet. Fails
/// where the file can't be read, its hair does not fit on this head, or `progress` cancels. Any thread; 100,000
/// strands of 16 points take some seconds.
[[nodiscard]] Result<std::vector<HairGroup>> groupsFromCurves(const QString& path, const CurveSpaceChoice& choice,
                                                              const std::shared_ptr<const Head>& head,
                                                              const Progress& progress = {},
                                                              CurveRemarks* remarks = nullptr);
/// The same of curves that are read already from the file `path`.
[[nodiscard]] Result<std::vector<HairGroup>> groupsFromCurves(ForeignCurves curves, const QString& path,
                                                              const CurveSpaceChoice& choice,
                                                              const std::shared_ptr<const Head>& head,
                                                              const Progress& progress = {},
                                                              CurveRemarks* remarks = nullptr);

} // namespace hairpaint::model
